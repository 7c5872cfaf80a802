"""The equations of hook and load in the plant of every crane.

`plant` is a `Plant`, `state` a `PlantState`, `work` a `Work`, see crane/records.py; the equations
have the order of `HookState`.
"""

from math import cos, sin

from segfmu.kernels.crane.records import Action, Coordinates, Masses, Plant, PlantState, State, Work
from segfmu.kernels.hook._hook import hook_driven, hook_energy, hook_load, hook_rhs
from segfmu.kernels.hook.records import HookMasses, HookState


def gather_hook(plant: 'float[:]', state: 'float[:]', work: 'float[:,:]') -> None:
    """Write state and masses in the order of the equations."""
    own = work[Work.OWN_STATE, :]
    masses = work[Work.OWN_MASSES, :]
    for i in range(Coordinates.SIZE):
        own[i] = state[i]
        own[HookState.VELOCITY + i] = state[State.VELOCITY + i]
    for i in range(2):
        own[HookState.SLING_ANGLE + i] = state[PlantState.SLING_ANGLE + i]
        own[HookState.SLING_RATE + i] = state[PlantState.SLING_RATE + i]
    for i in range(Masses.SIZE):
        masses[i] = plant[i]
    masses[HookMasses.HOOK_MASS] = plant[Plant.TACKLE_MASS]
    masses[HookMasses.SLING] = plant[Plant.SLING]


def scatter_hook(work: 'float[:,:]', derivative: 'float[:]') -> None:
    """Write the derivative of a `PlantState` from that of a `HookState`."""
    rate = work[Work.OWN_RATE, :]
    for i in range(Coordinates.SIZE):
        derivative[i] = rate[i]
        derivative[State.VELOCITY + i] = rate[HookState.VELOCITY + i]
    for i in range(2):
        derivative[PlantState.SLING_ANGLE + i] = rate[HookState.SLING_ANGLE + i]
        derivative[PlantState.SLING_RATE + i] = rate[HookState.SLING_RATE + i]
    work[Work.ACTION, Action.SLING_TENSION] = work[Work.OWN_TENSION, 0]


def hooked_rhs(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the state, see `suspended_rhs`."""
    gather_hook(plant, state, work)
    hook_rhs(
        work[Work.OWN_STATE, :], work[Work.GENERALISED, :], work[Work.WIND, :],
        work[Work.OWN_MASSES, :], work[Work.OWN_RATE, :], work[Work.OWN_TENSION, :],
    )
    scatter_hook(work, derivative)


def hooked_driven(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """The same under demanded accelerations, see `suspended_driven`."""
    gather_hook(plant, state, work)
    hook_driven(
        work[Work.OWN_STATE, :], work[Work.DEMAND, :], work[Work.GENERALISED, :],
        work[Work.WIND, :], work[Work.OWN_MASSES, :], work[Work.OWN_RATE, :],
        work[Work.ACTION, :], work[Work.OWN_TENSION, :],
    )
    scatter_hook(work, derivative)


def hooked_load(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', load: 'float[:,:]'
) -> None:
    """Write the motion of the load, a `Load`."""
    gather_hook(plant, state, work)
    hook_load(work[Work.OWN_STATE, :], work[Work.OWN_MASSES, :], load)


def hooked_energy(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', energy: 'float[:]'
) -> None:
    """Write the mechanical energy, an `Energies`."""
    gather_hook(plant, state, work)
    hook_energy(work[Work.OWN_STATE, :], work[Work.OWN_MASSES, :], energy)


def hooked_mass(plant: 'float[:]', state: 'float[:]') -> float:
    """Mass [kg] at the end of the rope against an acceleration along it.

    With the sling at an angle a to the rope: 1 / m = (1 - M cos(a)^2 / (M + h)) / h, with the
    masses M of the load and h of the hook.
    """
    payload = plant[Plant.PAYLOAD_MASS]
    hook = plant[Plant.TACKLE_MASS]
    phi_x = state[State.ANGLE]
    psi_x = state[PlantState.SLING_ANGLE]
    turned = cos(state[State.ANGLE + 1] - state[PlantState.SLING_ANGLE + 1])
    cosine = sin(phi_x) * sin(psi_x) + cos(phi_x) * cos(psi_x) * turned
    return hook * (hook + payload) / (hook + payload * (1.0 - cosine * cosine))
