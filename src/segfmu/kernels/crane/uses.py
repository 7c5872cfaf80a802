"""What a plan uses of the bounds of the drives.

peaks and times are those of `demand_peaks`, bounds is a `DriveBounds`.
"""

from segfmu.kernels.crane.records import BoundFault, BoundStatus, BoundUses, Demand, DriveBounds
from segfmu.kernels.crane.travel import end_stop, is_place, travel_origin, travel_span


def bound_uses(
    peaks: 'float[:,:]',
    times: 'float[:,:]',
    bounds: 'float[:]',
    uses: 'float[:]',
    fault: 'float[:]',
) -> int:
    """Write the `BoundUses` of a plan; returns a `BoundStatus`.

    Where bounds are exceeded by more than rounding, 1e-9, the `BoundFault` is that of the one
    exceeded most.
    """
    status = BoundStatus.KEPT
    worst = 1.0 + 1e-9
    for i in range(Demand.SIZE):
        uses[BoundUses.USE + i] = 0.0
        uses[BoundUses.TIME + i] = 0.0
        for side in range(2):
            bound = bound_magnitude(i, side, bounds)
            if bound > 0.0:
                share = (peaks[side, i] - bound_origin(i, side, bounds)) / bound
                if share > uses[BoundUses.USE + i]:
                    uses[BoundUses.USE + i] = share
                    uses[BoundUses.TIME + i] = times[side, i]
                if share > worst:
                    worst = share
                    status = BoundStatus.FORCE + i // 3
                    write_fault(i, side, peaks[side, i], times[side, i], bounds, fault)
    return status


def has_own_bound(i: int, side: int, bounds: 'float[:]') -> bool:
    """Whether the negative direction of a demand, side 1, has a bound of its own."""
    return side == 1 and i < Demand.POWER and bounds[DriveBounds.FORCE_MIN + i] < 0.0


def bound_magnitude(i: int, side: int, bounds: 'float[:]') -> float:
    """Magnitude of the bound of a demand in the positive or negative direction; 0: none.

    Of a place, its distance from the `bound_origin`.
    """
    if is_place(i):
        return travel_span(i, side, bounds)
    if has_own_bound(i, side, bounds):
        return -bounds[DriveBounds.FORCE_MIN + i]
    return bounds[i]


def bound_origin(i: int, side: int, bounds: 'float[:]') -> float:
    """From where on a demand uses its bound in the positive or negative direction."""
    if is_place(i):
        return travel_origin(i, side, bounds)
    return 0.0


def has_bounds(first: int, last: int, bounds: 'float[:]') -> bool:
    """Whether there is any bound of the demands from one up to another, without that."""
    for i in range(first, last):
        for side in range(2):
            # not a number is a bound that nothing keeps
            if not bound_magnitude(i, side, bounds) == 0.0:
                return True
    return False


def paced_use(uses: 'float[:]') -> float:
    """The largest use (`BoundUses`) of what a slower plan needs less of.

    A place counts only where it is beyond its end stop: at any pace the plan has its waypoints.
    """
    found = 0.0
    for i in range(Demand.SIZE):
        if not is_place(i) or uses[BoundUses.USE + i] > 1.0 + 1e-9:
            found = max(found, uses[BoundUses.USE + i])
    return found


def write_fault(
    i: int, side: int, peak: float, time: float, bounds: 'float[:]', fault: 'float[:]'
) -> None:
    """Write the `BoundFault` of a demand that exceeds its bound in a direction."""
    fault[BoundFault.DRIVE] = i % 3
    fault[BoundFault.AXIS] = i % 3
    fault[BoundFault.STOPPED] = i % 3
    fault[BoundFault.SIDE] = 0.0
    fault[BoundFault.VALUE] = peak
    fault[BoundFault.BOUND] = bounds[i]
    if is_place(i) and side == 1:
        fault[BoundFault.SIDE] = 1.0
        fault[BoundFault.VALUE] = -peak
        fault[BoundFault.BOUND] = -end_stop(i, side, bounds)
    if has_own_bound(i, side, bounds):
        fault[BoundFault.SIDE] = 1.0
        fault[BoundFault.VALUE] = -peak
        fault[BoundFault.BOUND] = bounds[DriveBounds.FORCE_MIN + i]
    fault[BoundFault.TIME] = time
