"""Choice of free waypoint velocities and accelerations, for axes that meet in the waypoints.

Waypoints with free states between two whose states are given form a passage, which is planned on
its own. What counts is the planner's own duration. Rest at the free waypoints and free velocities
without acceleration are candidates as well, so the choice is never slower than these.

For m waypoints and k axes: choice (Block.COUNT m, k, WaypointState), states of the places of the
waypoints; place (m,); tools (Tools rows, Tools columns), whose row PATH brings SHARE; axes (k,
Track); spots, links, spans and band as in path.py; cells, timing, coefficients and work as in
judge.py.
"""

from segfmu.kernels.limits.places import is_free, take_states, unite_waypoints
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.passage.boxes import admit_states, is_moving, widen_boxes, write_boxes
from segfmu.kernels.passage.direction import (
    reverse_limits,
    reverse_places,
    reverse_spots,
    runs_backwards,
)
from segfmu.kernels.passage.grid import write_grid
from segfmu.kernels.passage.judge import copy_states, plan_lengths, set_axes
from segfmu.kernels.passage.path import gap_of
from segfmu.kernels.passage.polish import polish_states
from segfmu.kernels.passage.records import Block, Free, Path, Point, Spot, Tools, Track
from segfmu.kernels.passage.search import block_rows, may_beat, search_states, write_tracks
from segfmu.kernels.passage.units import restore_given, return_states, take_units
from segfmu.kernels.planner.problem import motion_scale
from segfmu.kernels.planner.records import WaypointState


def usual_room() -> float:
    """Share of the range around two places by which an axis may leave it, if no other is asked."""
    return 0.25


def begin_choice(
    states: 'float[:,:,:]', dwells: 'float[:]', limits: 'float[:,:]', lower: 'float[:,:]',
    allowed: 'float[:,:]', choice: 'float[:,:,:]', place: 'float[:]', tools: 'float[:,:]',
    axes: 'float[:,:]', spots: 'float[:,:,:]', work: 'float[:,:]',
) -> bool:
    """Write the places of waypoints, which of their states are free, and a grid.

    states (m, k, WaypointState): not a number where free; dwells (m,) [s]. limits (k, smoothness +
    1) and lower (k, Lower) are copies: those that no motion reaches are brought down. allowed (k,
    2): range of the positions [m]. False where no limit bounds an axis.
    """
    path = tools[Tools.PATH, :]
    places = write_places(states, dwells, choice, place, spots)
    for axis in range(axes.shape[0]):
        for order in range(2):
            if not lower[axis, order] > 0.0:
                lower[axis, order] = limits[axis, order]
            axes[axis, Track.ALLOWED + order] = allowed[axis, order]
    bring_down(choice[0:places, :, :], limits, lower, axes)
    take_units(places, choice, limits, lower, axes)
    path[Path.BACKWARDS] = runs_backwards(places, choice, spots)
    if path[Path.BACKWARDS] != 0.0:
        reverse_limits(places, choice, limits, lower, axes)
        reverse_places(places, choice)
        reverse_spots(places, axes.shape[0], spots)
    path[Path.AXES] = axes.shape[0]
    path[Path.PLACES] = places
    path[Path.LAST] = 0.0
    write_tracks(limits, lower, path, axes)
    square = tools[Tools.SQUARE:Tools.SIZE, :]
    write_grid(int(path[Path.ORDER]), tools[Tools.GRID:Tools.SQUARE, :], square)
    return set_axes(limits, lower, axes, work)


def bring_down(
    given: 'float[:,:,:]', limits: 'float[:,:]', lower: 'float[:,:]', axes: 'float[:,:]'
) -> None:
    """Bring limits of velocity and acceleration down to a few times what is reached at most.

    A limit that is meant as none would be a useless unit.
    """
    for axis in range(axes.shape[0]):
        for order in range(2):
            # what is reached may be in either direction
            axes[axis, Track.LIMIT + order] = limits[axis, order]
            limits[axis, order] = max(limits[axis, order], lower[axis, order])
    velocity = 4.0 * motion_scale(0, given, limits)
    acceleration = 4.0 * motion_scale(1, given, limits)
    for axis in range(axes.shape[0]):
        for order in range(2):
            reached = acceleration if order == 1 else velocity
            limits[axis, order] = axes[axis, Track.LIMIT + order]
            if reached > 0.0:
                limits[axis, order] = min(limits[axis, order], reached)
                lower[axis, order] = min(lower[axis, order], reached)


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
            if spots[point * count + axis, Spot.FREE, field] != 0.0:
                return False
    return True


def next_passage(tools: 'float[:,:]', spots: 'float[:,:,:]') -> bool:
    """Go to the next passage; False if there is none."""
    path = tools[Tools.PATH, :]
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
    choice: 'float[:,:,:]', tools: 'float[:,:]', axes: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', band: 'float[:,:]', cells: 'float[:,:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]', work: 'float[:,:]',
) -> None:
    """Choose the free states between the two places at which a passage begins and ends.

    With more room than usual the search may end elsewhere, and later: so the usual one is tried
    as well.
    """
    path = tools[Tools.PATH, :]
    first = int(path[Path.FIRST])
    last = int(path[Path.LAST])
    begin, end = block_rows(Block.GIVEN, path, choice)
    part = choice[begin:end, :, :]
    begin, end = block_rows(Block.BEST, path, choice)
    best = choice[begin:end, :, :]
    begin, end = block_rows(Block.KEPT, path, choice)
    kept = choice[begin:end, :, :]
    low = first * axes.shape[0]
    high = last * axes.shape[0]
    beyond = high + axes.shape[0]
    size = Free.SIZE * (beyond - low)
    own_spots = spots[low:beyond, :, :]
    own_links = links[low:high, :, :]
    own_spans = spans[first:last, :]
    own_cells = cells[low:high, :, :]
    least = NEVER
    copy_states(part, kept)
    share = path[Path.SHARE]
    for attempt in range(2):
        if attempt == 1:
            if share <= usual_room():
                break
            share = usual_room()
        places = int(path[Path.PLACES])
        write_boxes(share, first, choice[0:places, :, :], path, axes, own_links)
        if not admit_states(part, path, own_spots, own_links):
            continue
        widen_boxes(
            share, part, path, own_links, own_spans, axes, own_cells, timing, coefficients, work
        )
        found = fastest_states(
            choice, tools, axes, own_spots, own_links, own_spans, band[0:size, :], own_cells,
            timing, coefficients, work,
        )
        if found < least:
            least = found
            copy_states(best, kept)
    copy_states(kept, part)


def fastest_states(
    choice: 'float[:,:,:]', tools: 'float[:,:]', axes: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', band: 'float[:,:]', cells: 'float[:,:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]', work: 'float[:,:]',
) -> float:
    """Write the states of the fastest plan found to the block BEST; its duration [s]."""
    path = tools[Tools.PATH, :]
    begin, end = block_rows(Block.BEST, path, choice)
    best = choice[begin:end, :, :]
    begin, end = block_rows(Block.ALONE, path, choice)
    alone = choice[begin:end, :, :]
    path[Path.KNOWN] = NEVER
    path[Path.BLOCK] = Block.BEST
    searched_states(
        choice, tools, axes, spots, links, spans, band, cells, timing, coefficients, work
    )
    total = polish_states(best, path, spots, links, spans, axes, cells, timing, coefficients, work)
    if not choose_fields(False, spots):
        return total
    # as if velocities alone were free: from the best it may end elsewhere
    path[Path.KNOWN] = total
    path[Path.BLOCK] = Block.ALONE
    searched_states(
        choice, tools, axes, spots, links, spans, band, cells, timing, coefficients, work
    )
    least = NEVER
    if may_beat(total, Point.LAST, path[Path.LOOSEST]):
        least = polish_states(
            alone, path, spots, links, spans, axes, cells, timing, coefficients, work
        )
    choose_fields(True, spots)
    if least < total:
        copy_states(alone, best)
        total = polish_states(
            best, path, spots, links, spans, axes, cells, timing, coefficients, work
        )
    return total


def choose_fields(all_fields: bool, spots: 'float[:,:,:]') -> bool:
    """Choose all states that are admitted, or velocities alone; whether accelerations are."""
    found = False
    for i in range(spots.shape[0]):
        found = found or spots[i, Spot.ADMITTED, Free.ACCELERATION] != 0.0
        spots[i, Spot.CHOSEN, Free.ACCELERATION] = 0.0
        if all_fields:
            admitted = spots[i, Spot.ADMITTED, Free.ACCELERATION]
            spots[i, Spot.CHOSEN, Free.ACCELERATION] = admitted
    return found


def searched_states(
    choice: 'float[:,:,:]', tools: 'float[:,:]', axes: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', band: 'float[:,:]', cells: 'float[:,:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]', work: 'float[:,:]',
) -> None:
    """Write the fastest states on central paths, or rest, to the path's block.

    What is no faster than KNOWN of the path is of no interest.
    """
    path = tools[Tools.PATH, :]
    begin, end = block_rows(Block.GIVEN, path, choice)
    given = choice[begin:end, :, :]
    begin, end = block_rows(int(path[Path.BLOCK]), path, choice)
    copy_states(given, choice[begin:end, :, :])
    path[Path.LOOSEST] = NEVER
    path[Path.BEST] = plan_lengths(given, spans, axes, cells, work)
    # the motion found depends on where the path begins, so each is tried if given states move
    path[Path.START] = gap_of(Point.NEAR)
    attempts = 2 if is_moving(given) else 1
    for attempt in range(attempts):
        search_states(
            choice, tools, axes, spots, links, spans, band, cells, timing, coefficients, work
        )
        path[Path.START] = gap_of(Point.FAR)


def end_choice(
    states: 'float[:,:,:]', place: 'float[:]', choice: 'float[:,:,:]', tools: 'float[:,:]',
    axes: 'float[:,:]',
) -> None:
    """Write the states that were chosen to the waypoints at which they are free.

    What one of several waypoints at a place has is that of all, to the last digit.
    """
    if tools[Tools.PATH, Path.BACKWARDS] != 0.0:
        reverse_places(int(tools[Tools.PATH, Path.PLACES]), choice)
    for point in range(states.shape[0]):
        own = int(place[point])
        if point == 0 or own != int(place[point - 1]):
            return_states(own, choice, axes)
        restore_given(states[point, :, :], choice[own, :, :])
    for point in range(states.shape[0]):
        own = int(place[point])
        take_states(False, choice[own, :, :], states[point, :, :])
