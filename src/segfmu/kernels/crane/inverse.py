"""What a motion of the load asks of a crane, whatever the load hangs on."""

from segfmu.kernels.crane._crane import crane_flat_inverse
from segfmu.kernels.crane._series import suspension_derivatives
from segfmu.kernels.crane.records import FlatOrders, Resistance
from segfmu.kernels.hook.inverse import write_sling


def flat_orders(resistance: 'float[:]') -> int:
    """Derivatives of the load's position that the flat inverse needs, see `FlatOrders`."""
    if resistance[Resistance.SLING] > 0.0:
        return FlatOrders.HOOK
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
    `Resistance`; series: SlingSeries.
    """
    if resistance[Resistance.SLING] > 0.0:
        write_sling(
            flat, FlatOrders.CRANE, resistance, resistance[Resistance.HOOK_MASS],
            resistance[Resistance.SLING], series,
        )
        suspension_derivatives(0, resistance, series, force, state, acceleration)
    else:
        crane_flat_inverse(flat, resistance, force, state, acceleration)
