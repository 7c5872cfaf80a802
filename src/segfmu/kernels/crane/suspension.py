"""What hangs on the rope: the load alone, or a model's parts between rope and load.

This is where the kernels choose a model, by `Resistance.SUSPENSION`: equations, flat inverse, and
the mass along the rope. `state` is a `PlantState`, `work` a `Work`, see crane/records.py.
"""

from segfmu.kernels.crane._crane import (
    crane_driven,
    crane_energy,
    crane_flat_inverse,
    crane_load,
    crane_rhs,
)
from segfmu.kernels.crane._series import suspension_derivatives
from segfmu.kernels.crane.records import FlatOrders, Plant, Resistance, Work
from segfmu.kernels.hook.inverse import write_sling
from segfmu.kernels.hook.records import HookModel
from segfmu.kernels.hook.suspended import (
    hooked_driven,
    hooked_energy,
    hooked_load,
    hooked_mass,
    hooked_rhs,
)


def has_tackle(resistance: 'float[:]') -> bool:
    """Whether there is anything between rope and load."""
    return resistance[Resistance.SUSPENSION] > 0.0


def suspended_rhs(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the state under the generalised forces and the wind of work."""
    if int(plant[Plant.SUSPENSION]) == HookModel.CODE:
        hooked_rhs(plant, state, work, derivative)
    else:
        crane_rhs(state, work[Work.GENERALISED, :], work[Work.WIND, :], plant, derivative)


def suspended_driven(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """The same under the demanded accelerations, with the forces for them, which act then."""
    if int(plant[Plant.SUSPENSION]) == HookModel.CODE:
        hooked_driven(plant, state, work, derivative)
    else:
        crane_driven(
            state, work[Work.DEMAND, :], work[Work.GENERALISED, :], work[Work.WIND, :], plant,
            derivative, work[Work.ACTION, :],
        )


def suspended_load(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', load: 'float[:,:]'
) -> None:
    """Write the motion of the load, a `Load`."""
    if int(plant[Plant.SUSPENSION]) == HookModel.CODE:
        hooked_load(plant, state, work, load)
    else:
        crane_load(state, load)


def suspended_energy(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', energy: 'float[:]'
) -> None:
    """Write the mechanical energy, an `Energies`."""
    if int(plant[Plant.SUSPENSION]) == HookModel.CODE:
        hooked_energy(plant, state, work, energy)
    else:
        crane_energy(state, plant, energy)


def suspended_mass(plant: 'float[:]', state: 'float[:]') -> float:
    """Mass [kg] at the end of the rope against an acceleration along it."""
    if int(plant[Plant.SUSPENSION]) == HookModel.CODE:
        return hooked_mass(plant, state)
    return plant[Plant.PAYLOAD_MASS]


def flat_orders(resistance: 'float[:]') -> int:
    """Derivatives of the load's position that the flat inverse needs, that of order 0 included."""
    if int(resistance[Resistance.SUSPENSION]) == HookModel.CODE:
        return HookModel.ORDERS
    return FlatOrders.CRANE


def crane_inverse(
    flat: 'float[:,:]',
    resistance: 'float[:]',
    series: 'float[:,:]',
    force: 'float[:]',
    state: 'float[:]',
    acceleration: 'float[:]',
) -> None:
    """Forces of the drives, and motion of carriages and rope, see `crane_flat_inverse`.

    flat: as many derivatives of the load's position as `flat_orders` says; resistance:
    `Resistance`; series: MostSeries.
    """
    if int(resistance[Resistance.SUSPENSION]) == HookModel.CODE:
        write_sling(
            flat, FlatOrders.CRANE, resistance, resistance[Resistance.TACKLE_MASS],
            resistance[Resistance.SLING], series,
        )
        suspension_derivatives(0, resistance, series, force, state, acceleration)
    else:
        crane_flat_inverse(flat, resistance, force, state, acceleration)
