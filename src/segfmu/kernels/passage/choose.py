"""Choice of free waypoint velocities and accelerations, for axes that meet in the waypoints.

Waypoints with free states between two whose states are given form a passage, which is planned on
its own. What counts is the planner's own duration. Rest at the free waypoints and free velocities
without acceleration are candidates as well, so the choice is never slower than these.

For m waypoints and k axes: choice (5 m, k, WaypointState), the places of the waypoints, and states
of them that are compared; place (m,); path, tracks, spots, links, spans, grid, square and band as
in path.py; axes, cells, timing, coefficients, rope and work as in judge.py.
"""

from segfmu.kernels.limits.places import is_free, take_states, unite_waypoints
from segfmu.kernels.passage.boxes import admit_states, is_moving, widen_boxes, write_boxes
from segfmu.kernels.passage.grid import write_grid
from segfmu.kernels.passage.judge import copy_states, plan_lengths, set_axes
from segfmu.kernels.passage.polish import polish_states
from segfmu.kernels.passage.records import Free, Path, Spot
from segfmu.kernels.passage.search import search_states, write_tracks
from segfmu.kernels.planner.problem import motion_scale
from segfmu.kernels.planner.records import WaypointState


def begin_choice(
    states: 'float[:,:,:]', dwells: 'float[:]', limits: 'float[:,:]', lower: 'float[:,:]',
    choice: 'float[:,:,:]', place: 'float[:]', path: 'float[:]', tracks: 'float[:,:]',
    spots: 'float[:,:,:]', grid: 'float[:,:]', square: 'float[:,:]', axes: 'float[:,:]',
    work: 'float[:,:]',
) -> bool:
    """Write the places of waypoints, which of their states are free, and a grid.

    states (m, k, WaypointState): not a number where free; dwells (m,) [s]. limits (k, smoothness +
    1) and lower (k, Lower) are copies: those that no motion reaches are brought down. False
    where no limit bounds an axis.
    """
    count = states.shape[1]
    places = write_places(states, dwells, choice, place, spots)
    given = choice[0:places, :, :]
    for axis in range(count):
        for order in range(2):
            if not lower[axis, order] > 0.0:
                lower[axis, order] = limits[axis, order]
    for order in range(2):
        # a limit that is meant as none would be a useless unit
        reached = 4.0 * motion_scale(order, given, limits)
        for axis in range(count):
            if reached > 0.0:
                limits[axis, order] = min(limits[axis, order], reached)
                lower[axis, order] = min(lower[axis, order], reached)
    path[Path.AXES] = count
    path[Path.PLACES] = places
    path[Path.LAST] = 0.0
    write_tracks(limits, lower, path, tracks)
    write_grid(int(path[Path.ORDER]), grid, square)
    return set_axes(limits, lower, axes, work)


def write_places(
    states: 'float[:,:,:]', dwells: 'float[:]', choice: 'float[:,:,:]', place: 'float[:]',
    spots: 'float[:,:,:]',
) -> int:
    """Write the places, at rest where states are free, and which are; returns their number.

    What is free becomes zero at the first and the last place, at one with a dwell, and where all
    axes stay.
    """
    count = states.shape[1]
    copy_states(states, choice[0:states.shape[0], :, :])
    unite_waypoints(choice[0:states.shape[0], :, :], place)
    for point in range(1, states.shape[0]):
        own = int(place[point])
        take_states(True, choice[point, :, :], choice[own, :, :])
    places = int(place[states.shape[0] - 1]) + 1
    for point in range(places):
        for axis in range(count):
            for field in range(Free.SIZE):
                free = is_free(choice[point, axis, WaypointState.VELOCITY + field])
                if free:
                    choice[point, axis, WaypointState.VELOCITY + field] = 0.0
                free = free and 0 < point < places - 1
                spots[point * count + axis, Spot.FREE, field] = free
    for point in range(states.shape[0]):
        own = int(place[point])
        if dwells[point] > 0.0:
            give_states(own, count, spots)
        if 0 < own and stays(own, choice):
            give_states(own - 1, count, spots)
            give_states(own, count, spots)
    return places


def stays(point: int, choice: 'float[:,:,:]') -> bool:
    """Whether no axis moves on its way to a place."""
    for axis in range(choice.shape[1]):
        here = choice[point, axis, WaypointState.POSITION]
        if here != choice[point - 1, axis, WaypointState.POSITION]:
            return False
    return True


def give_states(point: int, count: int, spots: 'float[:,:,:]') -> None:
    """Note that no state of a place is free."""
    for axis in range(count):
        for field in range(Free.SIZE):
            spots[point * count + axis, Spot.FREE, field] = 0.0


def is_given(point: int, count: int, spots: 'float[:,:,:]') -> bool:
    """Whether no state of a place is free."""
    for axis in range(count):
        for field in range(Free.SIZE):
            if spots[point * count + axis, Spot.FREE, field] > 0.5:
                return False
    return True


def next_passage(path: 'float[:]', spots: 'float[:,:,:]') -> bool:
    """Go to the next passage; False if there is none."""
    count = int(path[Path.AXES])
    end = int(path[Path.PLACES]) - 1
    first = int(path[Path.LAST])
    while first < end and is_given(first + 1, count, spots):
        first = first + 1
    last = first + 1
    while last < end and not is_given(last, count, spots):
        last = last + 1
    path[Path.FIRST] = first
    path[Path.LAST] = last
    return last <= end


def choose_passage(
    room: float, limits: 'float[:,:]', lower: 'float[:,:]', allowed: 'float[:,:]',
    choice: 'float[:,:,:]', path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]',
    band: 'float[:,:]', axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', rope: 'float[:,:]', work: 'float[:,:]',
) -> None:
    """Choose the free states between the two places at which a passage begins and ends.

    room: share of the range around two places by which an axis may leave it, 1e300: any; allowed
    (k, 2): range of the positions [m]. With more room the search may end elsewhere, and later: so
    the usual one is tried as well.
    """
    first = int(path[Path.FIRST])
    last = int(path[Path.LAST])
    places = int(path[Path.PLACES])
    count = int(path[Path.AXES])
    size = choice.shape[0] // 5
    given = choice[0:places, :, :]
    part = choice[first:last + 1, :, :]
    kept = choice[4 * size + first:4 * size + last + 1, :, :]
    own_spots = spots[first * count:(last + 1) * count, :, :]
    own_links = links[first * count:last * count, :, :]
    own_spans = spans[first:last, :]
    own_cells = cells[first * count:last * count, :, :]
    own_band = band[0:Free.SIZE * count * (last + 1 - first), :]
    least = 1e300
    copy_states(part, kept)
    for attempt in range(2):
        share = room
        if attempt == 1:
            share = 0.25
            if room <= 0.25:
                break
        write_boxes(share, first, given, allowed, path, own_links)
        if not admit_states(first, given, path, own_spots, own_links):
            continue
        widen_boxes(
            part, path, own_links, own_spans, axes, own_cells, timing, coefficients, rope, work
        )
        best = choice[size + first:size + last + 1, :, :]
        alone = choice[2 * size + first:2 * size + last + 1, :, :]
        tried = choice[3 * size + first:3 * size + last + 1, :, :]
        found = fastest_states(
            limits, lower, part, best, alone, tried, path, tracks, own_spots, own_links,
            own_spans, grid, square, own_band, axes, own_cells, timing, coefficients, rope, work,
        )
        if found < least:
            least = found
            copy_states(best, kept)
    copy_states(kept, part)


def fastest_states(
    limits: 'float[:,:]', lower: 'float[:,:]', given: 'float[:,:,:]', best: 'float[:,:,:]',
    alone: 'float[:,:,:]', tried: 'float[:,:,:]', path: 'float[:]', tracks: 'float[:,:]',
    spots: 'float[:,:,:]', links: 'float[:,:,:]', spans: 'float[:,:]', grid: 'float[:,:]',
    square: 'float[:,:]', band: 'float[:,:]', axes: 'float[:,:]', cells: 'float[:,:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]', rope: 'float[:,:]', work: 'float[:,:]',
) -> float:
    """Write the states of the fastest plan found; its duration [s]."""
    total = searched_states(
        1e300, given, best, tried, path, tracks, spots, links, spans, grid, square, band, axes,
        cells, timing, coefficients, rope, work,
    )
    least = 1e300
    if choose_fields(False, spots):
        # polished on its own, as if velocities alone were free: from `best` it may end elsewhere
        least = searched_states(
            total, given, alone, tried, path, tracks, spots, links, spans, grid, square, band,
            axes, cells, timing, coefficients, rope, work,
        )
        if least < total:
            copy_states(alone, best)
        least = polish_states(
            alone, path, limits, lower, spots, links, spans, axes, cells, timing, coefficients,
            rope, work,
        )
    choose_fields(True, spots)
    total = polish_states(
        best, path, limits, lower, spots, links, spans, axes, cells, timing, coefficients, rope,
        work,
    )
    if least < total:
        copy_states(alone, best)
        return least
    return total


def choose_fields(all_fields: bool, spots: 'float[:,:,:]') -> bool:
    """Choose all states that are admitted, or velocities alone; whether accelerations are."""
    found = False
    for i in range(spots.shape[0]):
        found = found or spots[i, Spot.ADMITTED, Free.ACCELERATION] > 0.5
        spots[i, Spot.CHOSEN, Free.ACCELERATION] = 0.0
        if all_fields:
            admitted = spots[i, Spot.ADMITTED, Free.ACCELERATION]
            spots[i, Spot.CHOSEN, Free.ACCELERATION] = admitted
    return found


def searched_states(
    known: float, given: 'float[:,:,:]', best: 'float[:,:,:]', tried: 'float[:,:,:]',
    path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]', band: 'float[:,:]',
    axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', rope: 'float[:,:]', work: 'float[:,:]',
) -> float:
    """Write the fastest states on central paths, or rest; the duration of their plan [s].

    known: duration of a plan beside which others are of interest [s].
    """
    copy_states(given, best)
    path[Path.BEST] = plan_lengths(given, spans, axes, cells, work)
    # the motion found depends on where the path begins, so each is tried if given states move
    path[Path.START] = 10.0
    attempts = 1
    if is_moving(given):
        path[Path.START] = 3.0
        attempts = 2
    for attempt in range(attempts):
        search_states(
            known, given, best, tried, path, tracks, spots, links, spans, grid, square, band,
            axes, cells, timing, coefficients, rope, work,
        )
        path[Path.START] = 100.0
    return path[Path.BEST]


def end_choice(
    states: 'float[:,:,:]', place: 'float[:]', choice: 'float[:,:,:]'
) -> None:
    """Write the states that were chosen to the waypoints at which they are free."""
    for point in range(states.shape[0]):
        own = int(place[point])
        take_states(False, choice[own, :, :], states[point, :, :])
