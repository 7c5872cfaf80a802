"""What hangs on the rope: the load, or a hook from which the load hangs by a sling.

A `Plant` has a hook if its sling has a length. `state` is a `PlantState`, `work` a `Work`, see
crane/records.py; the equations with a hook have the order of `HookState`.
"""

from segfmu.kernels.crane._crane import crane_driven, crane_energy, crane_load, crane_rhs
from segfmu.kernels.crane.records import Action, Coordinates, Masses, Plant, PlantState, State, Work
from segfmu.kernels.hook._hook import hook_driven, hook_energy, hook_load, hook_rhs
from segfmu.kernels.hook.records import HookMasses, HookState


def has_hook(plant: 'float[:]') -> bool:
    """Whether the load hangs on a hook."""
    return plant[Plant.SLING] > 0.0


def gather_hook(plant: 'float[:]', state: 'float[:]', work: 'float[:,:]') -> None:
    """Write state and masses in the order of the equations with a hook."""
    own = work[Work.HOOK_STATE, :]
    masses = work[Work.HOOK_MASSES, :]
    for i in range(Coordinates.SIZE):
        own[i] = state[i]
        own[HookState.VELOCITY + i] = state[State.VELOCITY + i]
    for i in range(2):
        own[HookState.SLING_ANGLE + i] = state[PlantState.SLING_ANGLE + i]
        own[HookState.SLING_RATE + i] = state[PlantState.SLING_RATE + i]
    for i in range(Masses.SIZE):
        masses[i] = plant[i]
    masses[HookMasses.HOOK_MASS] = plant[Plant.HOOK_MASS]
    masses[HookMasses.SLING] = plant[Plant.SLING]


def scatter_hook(work: 'float[:,:]', derivative: 'float[:]') -> None:
    """Write the derivative of a `PlantState` from that of a `HookState`."""
    rate = work[Work.HOOK_RATE, :]
    for i in range(Coordinates.SIZE):
        derivative[i] = rate[i]
        derivative[State.VELOCITY + i] = rate[HookState.VELOCITY + i]
    for i in range(2):
        derivative[PlantState.SLING_ANGLE + i] = rate[HookState.SLING_ANGLE + i]
        derivative[PlantState.SLING_RATE + i] = rate[HookState.SLING_RATE + i]
    work[Work.ACTION, Action.SLING_TENSION] = work[Work.HOOK_TENSION, 0]


def suspended_rhs(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the state under the generalised forces and the wind of work."""
    if has_hook(plant):
        gather_hook(plant, state, work)
        hook_rhs(
            work[Work.HOOK_STATE, :], work[Work.GENERALISED, :], work[Work.WIND, :],
            work[Work.HOOK_MASSES, :], work[Work.HOOK_RATE, :], work[Work.HOOK_TENSION, :],
        )
        scatter_hook(work, derivative)
    else:
        crane_rhs(state, work[Work.GENERALISED, :], work[Work.WIND, :], plant, derivative)


def suspended_driven(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """The same under the demanded accelerations, with the forces for them, which act then."""
    if has_hook(plant):
        gather_hook(plant, state, work)
        hook_driven(
            work[Work.HOOK_STATE, :], work[Work.DEMAND, :], work[Work.GENERALISED, :],
            work[Work.WIND, :], work[Work.HOOK_MASSES, :], work[Work.HOOK_RATE, :],
            work[Work.ACTION, :], work[Work.HOOK_TENSION, :],
        )
        scatter_hook(work, derivative)
    else:
        crane_driven(
            state, work[Work.DEMAND, :], work[Work.GENERALISED, :], work[Work.WIND, :], plant,
            derivative, work[Work.ACTION, :],
        )


def suspended_load(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', load: 'float[:,:]'
) -> None:
    """Write the motion of the load, a `Load`."""
    if has_hook(plant):
        gather_hook(plant, state, work)
        hook_load(work[Work.HOOK_STATE, :], work[Work.HOOK_MASSES, :], load)
    else:
        crane_load(state, load)


def suspended_energy(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', energy: 'float[:]'
) -> None:
    """Write the mechanical energy, an `Energies`."""
    if has_hook(plant):
        gather_hook(plant, state, work)
        hook_energy(work[Work.HOOK_STATE, :], work[Work.HOOK_MASSES, :], energy)
    else:
        crane_energy(state, plant, energy)
