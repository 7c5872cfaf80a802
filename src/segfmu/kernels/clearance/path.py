"""The first contact of a path with boxes."""

from segfmu.kernels.clearance.contact import span_contacts
from segfmu.kernels.clearance.ranges import is_any_near, is_near, span_ranges
from segfmu.kernels.clearance.records import Box, Collision, Part, Ranges, Stack
from segfmu.kernels.clearance.spans import begin_span, write_span_products, write_span_pull
from segfmu.kernels.crane.rope import interval_end, interval_pieces
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.records import Timing


def first_contact(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    gravity: float,
    boxes: 'float[:,:]',
    work: 'float[:,:]',
    stack: 'float[:,:,:]',
    ranges: 'float[:,:]',
    lasting: bool,
    report: 'float[:]',
) -> int:
    """The part (Part) that meets one of the boxes first, with a report (Collision); or CLEAR.

    Pieces as for `check_rope`, of `width` coefficients; work (RopeWork.SIZE, 4 width - 5 or more),
    stack (Stack.ROWS, Span.SIZE, 2 width - 3), ranges those of `path_ranges`, which are used up.
    boxes (.., Box) are made smaller by what may be touched. The rope counts where the load meets
    nothing: it has to follow that. lasting: whether to find when the contact ends; else its end is
    not known.
    """
    shrink_boxes(touch_distance(ranges), boxes)
    is_load_near = is_any_near(Part.LOAD, boxes, ranges)
    is_rope_near = is_any_near(Part.ROPE, boxes, ranges)
    for part in range(Part.LOAD, Part.ROPE + 1):
        if (part == Part.LOAD and not is_load_near) or (part == Part.ROPE and not is_rope_near):
            continue
        report[Collision.BEGIN] = NEVER
        time = timing[offsets[0], Timing.START]
        until = interval_end(time, timing, offsets)
        lasts = True
        while lasts:
            begun = report[Collision.BEGIN] < NEVER
            interval_pieces(time, until, timing, coefficients, offsets, gravity, work)
            span_ranges(part, until - time, coefficients.shape[1], work, ranges)
            if begun or is_any_near(part, boxes, ranges):
                span = stack[Stack.WHOLE, :, :]
                begin_span(time, until, coefficients.shape[1], work, span)
                if part == Part.ROPE:
                    write_span_pull(gravity, work, span)
                    write_span_products(work, span)
                if begun:
                    prolong_contact(part, boxes, stack, ranges, report)
                else:
                    note_first(part, boxes, stack, ranges, report)
            # a contact that ends before the span does has ended
            ended = not lasting or report[Collision.END] < until * (1 - 1e-11)
            ended = ended and report[Collision.BEGIN] < NEVER
            time = until
            until = interval_end(time, timing, offsets)
            lasts = until > time and not ended
        if report[Collision.BEGIN] < NEVER:
            return part
    return Part.CLEAR


def note_first(
    part: int, boxes: 'float[:,:]', stack: 'float[:,:,:]', ranges: 'float[:,:]',
    report: 'float[:]',
) -> None:
    """Note the first contact of a part with any of the boxes within the whole span."""
    times = ranges[Ranges.TIMES:Ranges.TIMES + 1, :]
    place = ranges[Ranges.PLACE, :]
    for number in range(boxes.shape[0]):
        if is_near(part, boxes[number, :], ranges):
            found = span_contacts(
                part, 0, boxes[number, :], stack[Stack.WHOLE, :, :], stack, times, place
            )
            if found > 0 and times[0, 0] < report[Collision.BEGIN]:
                report[Collision.BEGIN] = times[0, 0]
                report[Collision.END] = times[0, 1]
                report[Collision.BOX] = number
                for axis in range(3):
                    report[Collision.X + axis] = place[axis]


def prolong_contact(
    part: int, boxes: 'float[:,:]', stack: 'float[:,:,:]', ranges: 'float[:,:]',
    report: 'float[:]',
) -> None:
    """Prolong the first contact, which lasts until the whole span, by its part of that."""
    times = ranges[Ranges.TIMES:Ranges.TIMES + 1, :]
    times[0, 0] = report[Collision.BEGIN]
    times[0, 1] = report[Collision.END]
    number = int(report[Collision.BOX])
    span_contacts(
        part, 1, boxes[number, :], stack[Stack.WHOLE, :, :], stack, times, ranges[Ranges.PLACE, :]
    )
    report[Collision.END] = times[0, 1]


def touch_distance(ranges: 'float[:,:]') -> float:
    """Distance [m] below which a touch is rounding: 1e-9 of the largest coordinate of the load."""
    largest = 0.0
    for axis in range(3):
        largest = max(largest, abs(ranges[Ranges.LOAD_LOW, axis]))
        largest = max(largest, abs(ranges[Ranges.LOAD_HIGH, axis]))
    return 1e-9 * largest


def shrink_boxes(touch: float, boxes: 'float[:,:]') -> None:
    """Take from boxes what may be touched [m] on each side, of a thin one at most a quarter."""
    for number in range(boxes.shape[0]):
        shrink_box(touch, Box.LOAD_LOW, Box.LOAD_HIGH, boxes[number, :])
        shrink_box(touch, Box.ROPE_LOW, Box.ROPE_HIGH, boxes[number, :])


def shrink_box(touch: float, low: int, high: int, box: 'float[:]') -> None:
    """The same for one part of a box, whose ends begin at two places."""
    for axis in range(3):
        edge = min(touch, 0.25 * (box[high + axis] - box[low + axis]))
        box[low + axis] = box[low + axis] + edge
        box[high + axis] = box[high + axis] - edge
