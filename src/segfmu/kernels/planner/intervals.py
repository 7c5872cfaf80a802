"""Waypoints -> the phases of every axis in every waypoint interval, on common durations.

Rows of the waypoint arrays are waypoints, columns axes. The phases of axis i in interval j are
phases[2 * (j * axes + i)] and, where two profiles are averaged (synchronize.py), the one after
it; counts has the same index, weights[j * axes + i] is the share of the second one.

Status codes, negative: 1, 2 braking the first, building up the last acceleration passes the
velocity limit; 3 no profile; 4 no common duration; 5 the requested duration is too short, 6 it
falls into a gap; 7, 8 a waypoint's velocity, acceleration is beyond its limit; 9 no limit bounds
a ramp; 10 a dwell at a moving waypoint. report = axis, interval from 0, value, bound.
"""

from math import ceil

from segfmu.kernels.planner.gaps import gap_ends
from segfmu.kernels.planner.phases import append_hold, measure_phases, without_dust
from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.synchronize import stretch_phases, timed_profile


def set_shortest(
    interval: int,
    axis: int,
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    limits: 'float[:,:]',
    ramps: 'float[:,:]',
    phases: 'float[:,:,:]',
    counts: 'int[:]',
    weights: 'float[:]',
    trial: 'float[:,:]',
) -> 'tuple[int, float]':
    """Write the shortest profile of one axis in one interval; returns status and duration."""
    cell = interval * limits.shape[0] + axis
    v = velocities[interval, axis]
    distance = positions[interval + 1, axis] - positions[interval, axis]
    count = shortest_profile(
        v,
        accelerations[interval, axis],
        velocities[interval + 1, axis],
        accelerations[interval + 1, axis],
        distance,
        limits[axis, 0],
        limits[axis, 1],
        ramps[axis, :],
        phases[2 * cell, :, :],
        trial,
    )
    counts[2 * cell] = max(count, 0)
    counts[2 * cell + 1] = 0
    weights[cell] = 0.0
    if count < 0:
        return count, 0.0
    duration, y, end, lowest, highest = measure_phases(
        phases[2 * cell, :, :], count, v, 1e300, ramps[axis, :]
    )
    return 0, duration


def set_duration(
    interval: int,
    axis: int,
    target: float,
    shortest: float,
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
    """Write a profile of the given duration; False when that duration is not feasible."""
    cell = interval * limits.shape[0] + axis
    v = velocities[interval, axis]
    a = accelerations[interval, axis]
    w = velocities[interval + 1, axis]
    b = accelerations[interval + 1, axis]
    distance = positions[interval + 1, axis] - positions[interval, axis]
    if target < shortest * (1.0 - 1e-13):
        return False
    speed = without_dust(abs(v) + abs(w), limits[axis, 0])
    resting = speed == 0.0 and without_dust(abs(a) + abs(b), limits[axis, 1]) == 0.0
    if resting or target <= shortest * (1.0 + 1e-13):
        # the shortest profile may still be there, from the first step of planning
        duration = 0.0
        if counts[2 * cell + 1] == 0:
            for i in range(counts[2 * cell]):
                duration = duration + phases[2 * cell, i, 0]
        if duration == 0.0 or abs(duration - shortest) > 1e-13 * shortest:
            status, duration = set_shortest(
                interval, axis, positions, velocities, accelerations, limits, ramps, phases,
                counts, weights, trial,
            )
        if resting and counts[2 * cell] == 0:
            counts[2 * cell] = append_hold(phases[2 * cell, :, :], 0, 0.0, target)
        elif resting:
            stretch_phases(phases[2 * cell, :, :], counts[2 * cell], target / duration)
        return True
    weight = timed_profile(
        target, v, a, w, b, distance, limits[axis, 0], limits[axis, 1], ramps[axis, :],
        found, phases[2 * cell, :, :], phases[2 * cell + 1, :, :], trial,
    )
    if weight < 0.0:
        return False
    weights[cell] = weight
    counts[2 * cell] = int(found[0])
    counts[2 * cell + 1] = int(found[2])
    return True


def next_feasible(
    interval: int,
    axis: int,
    start: float,
    shortest: float,
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
) -> float:
    """The end of the gap that holds the infeasible duration `start`; -1 if none is found.

    The durations at which gaps can end are tried one after the other. Should a duration just before
    one of them be feasible as well, or none of them, the end is searched for.
    """
    after = start
    ends = trial[26:42, :]
    for sweep in range(8):
        count = gap_ends(
            after, velocities[interval, axis], accelerations[interval, axis],
            velocities[interval + 1, axis], accelerations[interval + 1, axis],
            positions[interval + 1, axis] - positions[interval, axis], limits[axis, 0],
            limits[axis, 1], ramps[axis, :], trial, ends,
        )
        for i in range(count):
            duration = ends[i, 0] * (1.0 + 1e-9)
            if set_duration(
                interval, axis, duration, shortest, positions, velocities, accelerations, limits,
                ramps, phases, counts, weights, found, trial,
            ):
                return first_feasible(
                    after, duration, interval, axis, shortest, positions, velocities,
                    accelerations, limits, ramps, phases, counts, weights, found, trial,
                )
            after = duration
        if count < 16:
            break
    growth = 1.005
    for i in range(600):
        duration = after * growth
        if set_duration(
            interval, axis, duration, shortest, positions, velocities, accelerations, limits,
            ramps, phases, counts, weights, found, trial,
        ):
            return first_feasible(
                after, duration, interval, axis, shortest, positions, velocities, accelerations,
                limits, ramps, phases, counts, weights, found, trial,
            )
        after = duration
        if i > 230:
            growth = 1.02
        if i > 350:
            growth = 1.1
    return -1.0


def first_feasible(
    outside: float,
    inside: float,
    interval: int,
    axis: int,
    shortest: float,
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
) -> float:
    """The first feasible duration between an infeasible and a feasible one, to 4e-9 of it."""
    duration = inside * (1.0 - 3e-9)
    for i in range(60):
        if duration <= outside or inside - outside <= 4e-9 * inside:
            break
        if set_duration(
            interval, axis, duration, shortest, positions, velocities, accelerations, limits,
            ramps, phases, counts, weights, found, trial,
        ):
            inside = duration
        else:
            outside = duration
        duration = 0.5 * (outside + inside)
    return inside


def round_up(duration: float, sample_time: float) -> float:
    """The next multiple of the sample time, or the duration itself if there is none."""
    if sample_time <= 0.0:
        return duration
    return ceil(duration / sample_time - 1e-9) * sample_time


def common_duration(
    interval: int,
    first: int,
    last: int,
    start: float,
    sample_time: float,
    shortest: 'float[:,:]',
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
) -> float:
    """The shortest duration >= start that the axes first .. last - 1 all meet; -1 if none.

    Their profiles of that duration are written.
    """
    duration = start
    for axis in range(first, last):
        duration = max(duration, shortest[interval, axis])
    duration = round_up(duration, sample_time)
    axis = first
    agreed = 0
    for i in range(100000):
        if agreed == last - first:
            return duration
        if set_duration(
            interval, axis, duration, shortest[interval, axis], positions, velocities,
            accelerations, limits, ramps, phases, counts, weights, found, trial,
        ):
            agreed = agreed + 1
        else:
            duration = next_feasible(
                interval, axis, duration, shortest[interval, axis], positions, velocities,
                accelerations, limits, ramps, phases, counts, weights, found, trial,
            )
            if duration < 0.0:
                return -1.0
            duration = round_up(duration, sample_time)
            agreed = 0
        axis = axis + 1
        if axis == last:
            axis = first
    return -1.0
