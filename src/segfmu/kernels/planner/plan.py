"""A whole plan: waypoints, limits and options -> the phases of every axis in every interval.

`plan_phases` is the entry point; it allocates nothing. Arrays and status codes are those of
intervals.py; in addition durations[j, axis] is the time of interval j, and dwells[j] the rest at
waypoint j before it starts.
"""

from segfmu.kernels.planner.intervals import common_duration, set_duration, set_shortest
from segfmu.kernels.planner.transition import ramp_parameters


def check_waypoints(
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    dwells: 'float[:]',
    limits: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Status 7, 8 or 10 (negative) when a waypoint breaks a limit or dwells while moving."""
    for j in range(velocities.shape[0]):
        for axis in range(limits.shape[0]):
            report[0] = axis
            report[1] = j
            report[2] = velocities[j, axis]
            report[3] = limits[axis, 0]
            if abs(velocities[j, axis]) > limits[axis, 0] * (1.0 + 1e-12):
                return -7
            moving = velocities[j, axis] != 0.0 or accelerations[j, axis] != 0.0
            if dwells[j] > 0.0 and moving:
                return -10
            report[2] = accelerations[j, axis]
            report[3] = limits[axis, 1]
            if abs(accelerations[j, axis]) > limits[axis, 1] * (1.0 + 1e-12):
                return -8
    return 0


def distribute(
    first: int,
    last: int,
    target: float,
    shortest: 'float[:,:]',
    durations: 'float[:,:]',
    active: 'int[:]',
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    limits: 'float[:,:]',
    ramps: 'float[:,:]',
    phases: 'float[:,:,:]',
    counts: 'int[:]',
    weights: 'float[:]',
    found: 'float[:]',
    trial: 'float[:,:]',
) -> bool:
    """Prolong the intervals of some axes, in proportion, until their sum is `target`.

    Intervals that take no time share it equally. An interval whose share lies in a gap jumps to the
    end of the gap when there is time for it, and else keeps its duration. False when time is left
    that no interval takes.
    """
    intervals = durations.shape[0]
    for j in range(intervals):
        active[j] = 1
    for sweep in range(50):
        base = 0.0
        open_intervals = 0
        rest = target
        for j in range(intervals):
            rest = rest - durations[j, first]
            if active[j] == 1:
                base = base + durations[j, first]
                open_intervals = open_intervals + 1
        if rest <= 1e-13 * target:
            return True
        if open_intervals == 0:
            return False
        factor = 1.0
        extra = rest / open_intervals
        if base > 0.0:
            factor = 1.0 + rest / base
            extra = 0.0
        for j in range(intervals):
            if active[j] == 1:
                wished = durations[j, first] * factor + extra
                reached = common_duration(
                    j, first, last, wished, 0.0, shortest, positions, velocities, accelerations,
                    limits, ramps, phases, counts, weights, found, trial,
                )
                if reached < 0.0 or reached - durations[j, first] > rest * (1.0 + 1e-13):
                    active[j] = 0
                else:
                    rest = rest - (reached - durations[j, first])
                    for axis in range(first, last):
                        durations[j, axis] = reached
    return False


def rewrite_intervals(
    first: int,
    last: int,
    shortest: 'float[:,:]',
    durations: 'float[:,:]',
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    limits: 'float[:,:]',
    ramps: 'float[:,:]',
    phases: 'float[:,:,:]',
    counts: 'int[:]',
    weights: 'float[:]',
    found: 'float[:]',
    trial: 'float[:,:]',
) -> bool:
    """Write the profiles of the durations that were settled on; False if one is infeasible."""
    for j in range(durations.shape[0]):
        for axis in range(first, last):
            if not set_duration(
                j, axis, durations[j, axis], shortest[j, axis], positions, velocities,
                accelerations, limits, ramps, phases, counts, weights, found, trial,
            ):
                return False
    return True


def plan_axis(
    axis: int,
    share: float,
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    limits: 'float[:,:]',
    smoothness: int,
    shape: int,
    ramps: 'float[:,:]',
    phases: 'float[:,:,:]',
    counts: 'int[:]',
    weights: 'float[:]',
    shortest: 'float[:,:]',
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Ramp parameters and shortest profiles of one axis; status as in `plan_phases`."""
    report[0] = axis
    status = ramp_parameters(
        smoothness, shape, share, limits[axis, :], work[0, :], work[1, :], ramps[axis, :]
    )
    if status > 0:
        return -9
    for j in range(positions.shape[0] - 1):
        report[1] = j
        status, time = set_shortest(
            j, axis, positions, velocities, accelerations, limits, ramps, phases, counts,
            weights, work,
        )
        if status < 0:
            return status
        shortest[j, axis] = time
    return 0


def plan_phases(
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    dwells: 'float[:]',
    limits: 'float[:,:]',
    smoothness: int,
    shape: int,
    synchronization: int,
    sample_time: float,
    duration: float,
    ramps: 'float[:,:]',
    phases: 'float[:,:,:]',
    counts: 'int[:]',
    weights: 'float[:]',
    shortest: 'float[:,:]',
    durations: 'float[:,:]',
    active: 'int[:]',
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Plan all intervals. Returns 0 or a negative status, with the details in `report`.

    m waypoints, k axes: positions, velocities, accelerations (m, k), dwells (m,), limits
    (k, smoothness + 1) with 0 for absent, ramps (k, 48), phases (2 (m - 1) k, 13, 4), counts
    (2 (m - 1) k,), weights ((m - 1) k,), shortest and durations (m - 1, k), active (m - 1,),
    work (43, 4 + 2 smoothness), report (4,). synchronization: 0 none, 1 waypoints, 2 total;
    sample_time and duration: 0 for none.
    """
    axes = limits.shape[0]
    intervals = positions.shape[0] - 1
    status = check_waypoints(velocities, accelerations, dwells, limits, report)
    if status < 0:
        return status
    for axis in range(axes):
        status = plan_axis(
            axis, 0.1, positions, velocities, accelerations, limits, smoothness, shape, ramps,
            phases, counts, weights, shortest, work, report,
        )
        if status == -1 or status == -2:
            # braking just fails: the steepest ramps decide whether the limits admit it
            status = plan_axis(
                axis, 0.004, positions, velocities, accelerations, limits, smoothness, shape,
                ramps, phases, counts, weights, shortest, work, report,
            )
        if status < 0:
            return status
        for j in range(intervals):
            durations[j, axis] = shortest[j, axis]
    return synchronize_plan(
        positions, velocities, accelerations, dwells, limits, synchronization, sample_time,
        duration, ramps, phases, counts, weights, shortest, durations, active, work, report,
    )


def synchronize_plan(
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    dwells: 'float[:]',
    limits: 'float[:,:]',
    synchronization: int,
    sample_time: float,
    duration: float,
    ramps: 'float[:,:]',
    phases: 'float[:,:,:]',
    counts: 'int[:]',
    weights: 'float[:]',
    shortest: 'float[:,:]',
    durations: 'float[:,:]',
    active: 'int[:]',
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Bring the shortest profiles to common durations; status as in `plan_phases`."""
    axes = limits.shape[0]
    intervals = positions.shape[0] - 1
    group = 1
    if synchronization == 1:
        group = axes
    resting = 0.0
    for j in range(intervals + 1):
        resting = resting + dwells[j]
    longest = 0.0
    for axis in range(0, axes, group):
        total = 0.0
        for j in range(intervals):
            if synchronization == 1 or sample_time > 0.0:
                time = common_duration(
                    j, axis, axis + group, 0.0, sample_time, shortest, positions, velocities,
                    accelerations, limits, ramps, phases, counts, weights, work[42, :],
                    work[0:42, :],
                )
                report[0] = axis
                report[1] = j
                if time < 0.0:
                    return -4
                for i in range(axis, axis + group):
                    durations[j, i] = time
            total = total + durations[j, axis]
        longest = max(longest, total)
    report[2] = longest + resting
    report[3] = duration
    target = longest
    if duration > 0.0:
        target = duration - resting
        if target < longest * (1.0 - 1e-13):
            return -5
    if synchronization < 2 and duration <= 0.0:
        return 0
    report[2] = target + resting
    for axis in range(0, axes, group):
        report[0] = axis
        if not distribute(
            axis, axis + group, target, shortest, durations, active, positions, velocities,
            accelerations, limits, ramps, phases, counts, weights, work[42, :], work[0:42, :],
        ):
            return -6
        if not rewrite_intervals(
            axis, axis + group, shortest, durations, positions, velocities, accelerations,
            limits, ramps, phases, counts, weights, work[42, :], work[0:42, :],
        ):
            return -6
    return 0
