"""The space that load and rope have: a workspace, and obstacles in it."""

from segfmu.kernels.clearance.path import first_contact
from segfmu.kernels.clearance.ranges import path_ranges
from segfmu.kernels.clearance.records import (
    Box,
    ObstacleRow,
    Part,
    Space,
    SpaceFault,
    SpaceLimits,
    SpaceStatus,
)


def write_box(space: 'float[:]', obstacle: 'float[:]', box: 'float[:]') -> None:
    """Write the `Box` of an obstacle (ObstacleRow) for the load of a `Space`."""
    for axis in range(3):
        low = obstacle[ObstacleRow.MINIMUM + axis] - obstacle[ObstacleRow.MARGIN]
        high = obstacle[ObstacleRow.MAXIMUM + axis] + obstacle[ObstacleRow.MARGIN]
        half = 0.5 * space[Space.LOAD_SIZE + axis]
        box[Box.LOAD_LOW + axis] = low - half - space[Space.LOAD_CENTRE + axis]
        box[Box.LOAD_HIGH + axis] = high + half - space[Space.LOAD_CENTRE + axis]
        box[Box.ROPE_LOW + axis] = low
        box[Box.ROPE_HIGH + axis] = high
    box[Box.ROPE] = obstacle[ObstacleRow.ROPE]


def write_faces(space: 'float[:]', boxes: 'float[:,:]') -> None:
    """Write the boxes around the workspace, which the load alone must not meet."""
    for number in range(SpaceLimits.FACES):
        for axis in range(3):
            boxes[number, Box.LOAD_LOW + axis] = -1e30
            boxes[number, Box.LOAD_HIGH + axis] = 1e30
            boxes[number, Box.ROPE_LOW + axis] = -1e30
            boxes[number, Box.ROPE_HIGH + axis] = 1e30
        boxes[number, Box.ROPE] = 0.0
        axis = number // 2
        if number % 2 == 0:
            boxes[number, Box.LOAD_HIGH + axis] = space[Space.WORKSPACE_MIN + axis]
        else:
            boxes[number, Box.LOAD_LOW + axis] = space[Space.WORKSPACE_MAX + axis]


def obstacle_count(space: 'float[:]', obstacles: 'float[:,:]') -> int:
    """Rows of obstacles that are in use."""
    return min(int(space[Space.OBSTACLES]), obstacles.shape[0])


def check_space(space: 'float[:]', obstacles: 'float[:,:]', fault: 'float[:]') -> int:
    """Whether workspace and obstacles (.., ObstacleRow) are not empty; a `SpaceStatus`."""
    for axis in range(3):
        fault[SpaceFault.AXIS] = axis
        fault[SpaceFault.VALUE] = space[Space.WORKSPACE_MIN + axis]
        fault[SpaceFault.BOUND] = space[Space.WORKSPACE_MAX + axis]
        if fault[SpaceFault.VALUE] >= fault[SpaceFault.BOUND]:
            return SpaceStatus.EMPTY_WORKSPACE
    for number in range(obstacle_count(space, obstacles)):
        fault[SpaceFault.BOX] = number
        for axis in range(3):
            fault[SpaceFault.AXIS] = axis
            fault[SpaceFault.VALUE] = obstacles[number, ObstacleRow.MINIMUM + axis]
            fault[SpaceFault.BOUND] = obstacles[number, ObstacleRow.MAXIMUM + axis]
            if fault[SpaceFault.VALUE] >= fault[SpaceFault.BOUND]:
                return SpaceStatus.EMPTY_OBSTACLE
    return SpaceStatus.CLEAR


def space_contact(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    space: 'float[:]',
    obstacles: 'float[:,:]',
    boxes: 'float[:,:]',
    work: 'float[:,:]',
    stack: 'float[:,:,:]',
    ranges: 'float[:,:]',
    lasting: bool,
    fault: 'float[:]',
) -> int:
    """What a path leaves or meets first, a `SpaceStatus`, with a `SpaceFault`.

    obstacles (.., ObstacleRow), of which the first ones are in use, as many as the `Space` says;
    boxes (SpaceLimits.FACES + obstacles, Box) are work space, the others those of `first_contact`.
    """
    status = check_space(space, obstacles, fault)
    if status != SpaceStatus.CLEAR:
        return status
    write_faces(space, boxes)
    count = obstacle_count(space, obstacles)
    for number in range(count):
        write_box(space, obstacles[number, :], boxes[SpaceLimits.FACES + number, :])
    path_ranges(timing, coefficients, offsets, space[Space.GRAVITY], work, ranges)
    used = boxes[0:SpaceLimits.FACES + count, :]
    part = first_contact(
        timing, coefficients, offsets, space[Space.GRAVITY], used, work, stack, ranges, lasting,
        fault,
    )
    if part == Part.CLEAR:
        return SpaceStatus.CLEAR
    number = int(fault[SpaceFault.BOX])
    fault[SpaceFault.PART] = part
    if number >= SpaceLimits.FACES:
        fault[SpaceFault.BOX] = number - SpaceLimits.FACES
        return part
    axis = number // 2
    fault[SpaceFault.AXIS] = axis
    fault[SpaceFault.VALUE] = fault[SpaceFault.X + axis]
    fault[SpaceFault.BOUND] = space[Space.WORKSPACE_MIN + axis]
    if number % 2 == 1:
        fault[SpaceFault.BOUND] = space[Space.WORKSPACE_MAX + axis]
    return SpaceStatus.WORKSPACE
