"""Whether load or rope meet a box during a span, as far as Bernstein coefficients tell.

Load and rope are convex, as the box is: they are apart where a plane is between them. For the load,
a point, and the box these are its faces; for the rope, a segment, also planes through it and an
edge.
"""

from segfmu.kernels.clearance.records import Box, Meeting, Moment, Part, Span
from segfmu.kernels.numerics.numbers import NEVER


def load_meeting(span: 'float[:,:]', box: 'float[:]') -> int:
    """Meeting of the load and a box."""
    meeting = Meeting.ALWAYS
    for axis in range(3):
        least, most = row_range(span, Span.LOAD + axis)
        low = box[Box.LOAD_LOW + axis]
        high = box[Box.LOAD_HIGH + axis]
        if most <= low or least >= high:
            return Meeting.NEVER
        if least <= low or most >= high:
            meeting = Meeting.OPEN
    return meeting


def rope_meeting(span: 'float[:,:]', box: 'float[:]') -> int:
    """Meeting of the rope and a box; there is no rope where it is slack or the load is too high."""
    least, most = row_range(span, Span.PULL + 2)
    top = min(box[Box.ROPE_HIGH + 2], 0.0)
    # as good as none
    if most <= 1e-9 or box[Box.ROPE_LOW + 2] >= top:
        return Meeting.NEVER
    lowest, highest = row_range(span, Span.LOAD + 2)
    if lowest >= top:
        return Meeting.NEVER
    if least <= 0.0:
        return Meeting.OPEN
    for axis in range(2):
        if is_beside(axis, lowest, highest, top, span, box):
            return Meeting.NEVER
    left, right = count_edges(span, box)
    if left == 4 or right == 4:
        return Meeting.NEVER
    if highest >= top:
        return Meeting.OPEN
    # nothing is between them at any time; or, where the rope may be vertical, one height is inside
    if is_across(0, lowest, highest, top, span, box) and is_across(
        1, lowest, highest, top, span, box
    ) and left > 0 and right > 0:
        return Meeting.ALWAYS
    height = shared_height(0.5, span, box)
    if highest < height and is_within(height, span, box):
        return Meeting.ALWAYS
    return Meeting.OPEN


def part_moves(part: int, span: 'float[:,:]') -> bool:
    """Whether a part moves by more than rounding of positions during a span."""
    rounding = span[Span.MOMENT, Moment.ROUNDING]
    for axis in range(3):
        least, most = row_range(span, Span.LOAD + axis)
        if most - least > rounding:
            return True
    if part == Part.LOAD:
        return False
    slowest, fastest = row_range(span, Span.PULL + 2)
    for axis in range(2):
        least, most = row_range(span, Span.REACH + axis)
        if most - least > rounding * slowest:
            return True
    return False


def row_range(span: 'float[:,:]', row: int) -> 'tuple[float, float]':
    """Least and greatest coefficient of a row, between which its polynomial is."""
    least = span[row, 0]
    most = least
    for i in range(1, span.shape[1]):
        least = min(least, span[row, i])
        most = max(most, span[row, i])
    return least, most


def is_beside(
    axis: int, lowest: float, highest: float, top: float, span: 'float[:,:]', box: 'float[:]'
) -> bool:
    """Whether the rope is beside the box along x or y wherever it is as high as the box.

    lowest, highest: of the load's height; top: of the box or the rope, what is lower.
    """
    bottom = box[Box.ROPE_LOW + 2]
    below = True
    above = True
    for i in range(span.shape[1]):
        reach = span[Span.REACH + axis, i]
        upwards = span[Span.PULL + 2, i]
        low = reach - box[Box.ROPE_LOW + axis] * upwards
        high = reach - box[Box.ROPE_HIGH + axis] * upwards
        side = span[Span.PULL + axis, i]
        place = span[Span.LOAD + axis, i]
        # the rope's lower end within the height of the box: at its bottom, or at the load
        below = below and low + top * side <= 0.0
        above = above and high + top * side >= 0.0
        if lowest < bottom:
            below = below and low + bottom * side <= 0.0
            above = above and high + bottom * side >= 0.0
        if highest > bottom:
            below = below and place <= box[Box.ROPE_LOW + axis]
            above = above and place >= box[Box.ROPE_HIGH + axis]
        if not below and not above:
            return False
    return True


def is_across(
    axis: int, lowest: float, highest: float, top: float, span: 'float[:,:]', box: 'float[:]'
) -> bool:
    """Whether an end of the rope's part as high as the box is past each of its faces, all the time.

    Arguments as for `is_beside`.
    """
    bottom = box[Box.ROPE_LOW + 2]
    past_low = True
    past_high = True
    lower_past_low = True
    lower_past_high = True
    for i in range(span.shape[1]):
        reach = span[Span.REACH + axis, i]
        upwards = span[Span.PULL + 2, i]
        low = reach - box[Box.ROPE_LOW + axis] * upwards
        high = reach - box[Box.ROPE_HIGH + axis] * upwards
        side = span[Span.PULL + axis, i]
        place = span[Span.LOAD + axis, i]
        past_low = past_low and low + top * side > 0.0
        past_high = past_high and high + top * side < 0.0
        if lowest < bottom:
            lower_past_low = lower_past_low and low + bottom * side > 0.0
            lower_past_high = lower_past_high and high + bottom * side < 0.0
        if highest > bottom:
            lower_past_low = lower_past_low and place > box[Box.ROPE_LOW + axis]
            lower_past_high = lower_past_high and place < box[Box.ROPE_HIGH + axis]
    return (past_low or lower_past_low) and (past_high or lower_past_high)


def count_edges(span: 'float[:,:]', box: 'float[:]') -> 'tuple[int, int]':
    """How many edges are, seen from above, left and right of the rope's line, always."""
    rounding = span[Span.MOMENT, Moment.TURN_ROUNDING]
    left = 0
    right = 0
    for corner in range(4):
        least, most = turn_range(corner, span, box)
        if least > rounding:
            left = left + 1
        if most < -rounding:
            right = right + 1
    return left, right


def turn_range(corner: int, span: 'float[:,:]', box: 'float[:]') -> 'tuple[float, float]':
    """Range of the side on which an edge of the box is: above 0 left of the rope's line."""
    x = box[Box.ROPE_LOW]
    y = box[Box.ROPE_LOW + 1]
    if corner % 2 == 1:
        x = box[Box.ROPE_HIGH]
    if corner // 2 == 1:
        y = box[Box.ROPE_HIGH + 1]
    least = NEVER
    most = -NEVER
    for i in range(span.shape[1]):
        turn = span[Span.TURN, i] - x * span[Span.PULL + 1, i] + y * span[Span.PULL, i]
        least = min(least, turn)
        most = max(most, turn)
    return least, most


def shared_height(share: float, span: 'float[:,:]', box: 'float[:]') -> float:
    """About the middle of the part of the rope that is in the box after a share of a span."""
    top = min(box[Box.ROPE_HIGH + 2], 0.0)
    bottom = max(box[Box.ROPE_LOW + 2], value_about(share, Span.LOAD + 2, span))
    upwards = value_about(share, Span.PULL + 2, span)
    for axis in range(2):
        place = value_about(share, Span.REACH + axis, span) / upwards
        slope = value_about(share, Span.PULL + axis, span) / upwards
        near = box[Box.ROPE_LOW + axis] - place
        far = box[Box.ROPE_HIGH + axis] - place
        if slope < 0.0:
            near = box[Box.ROPE_HIGH + axis] - place
            far = box[Box.ROPE_LOW + axis] - place
        # a slope so small that the quotient is infinite bounds nothing
        if abs(slope) * 1e12 > abs(near):
            bottom = max(bottom, near / slope)
        if abs(slope) * 1e12 > abs(far):
            top = min(top, far / slope)
    return 0.5 * (bottom + top)


def value_about(share: float, row: int, span: 'float[:,:]') -> float:
    """About the value of a row after a share of a span; exact at its ends."""
    return (1.0 - share) * span[row, 0] + share * span[row, span.shape[1] - 1]


def is_within(height: float, span: 'float[:,:]', box: 'float[:]') -> bool:
    """Whether the rope at a height is within the box along x and y all the time."""
    for axis in range(2):
        for i in range(span.shape[1]):
            place = span[Span.REACH + axis, i] + height * span[Span.PULL + axis, i]
            upwards = span[Span.PULL + 2, i]
            if not place - box[Box.ROPE_LOW + axis] * upwards > 0.0:
                return False
            if not place - box[Box.ROPE_HIGH + axis] * upwards < 0.0:
                return False
    return box[Box.ROPE_LOW + 2] < height < box[Box.ROPE_HIGH + 2] and height < 0.0
