"""When load or rope meet boxes: spans are halved until the coefficients tell.

What is still open where nothing moves by more than rounding counts as a contact: boxes are taken
smaller by the distance that counts as a touch.
"""

from segfmu.kernels.clearance.meeting import (
    load_meeting,
    part_moves,
    rope_meeting,
    shared_height,
)
from segfmu.kernels.clearance.records import Meeting, Moment, Part, Span
from segfmu.kernels.clearance.spans import halve_span


def part_meeting(part: int, span: 'float[:,:]', box: 'float[:]') -> int:
    """Meeting of a part and a box."""
    if part == Part.LOAD:
        return load_meeting(span, box)
    return rope_meeting(span, box)


def contact_times(
    part: int,
    until: float,
    count: int,
    box: 'float[:]',
    spans: 'float[:,:,:]',
    stack: 'float[:,:,:]',
    times: 'float[:,:]',
    place: 'float[:]',
) -> int:
    """Intervals in which a part (Part) meets a box, in order; returns their number.

    Those that begin before a time [s], among the first `count` spans; stack (Stack.ROWS, Span.SIZE,
    columns of a span). Written: times (rows, 2), as many as there are rows, and the place (3,)
    where the first contact begins.
    """
    found = 0
    for row in range(count):
        span = spans[row, :, :]
        if span[Span.MOMENT, Moment.START] >= until or found > times.shape[0]:
            break
        found = span_contacts(part, found, box, span, stack, times, place)
    return found


def span_contacts(
    part: int, found: int, box: 'float[:]', span: 'float[:,:]', stack: 'float[:,:,:]',
    times: 'float[:,:]', place: 'float[:]',
) -> int:
    """Add the contacts of a span to those found; returns their number."""
    if part_meeting(part, span, box) == Meeting.NEVER:
        return found
    for k in range(Span.SIZE):
        for i in range(span.shape[1]):
            stack[0, k, i] = span[k, i]
    return halved_contacts(part, found, box, stack, times, place)


def halved_contacts(
    part: int, found: int, box: 'float[:]', stack: 'float[:,:,:]', times: 'float[:,:]',
    place: 'float[:]',
) -> int:
    """Add the contacts of the first span of the stack to those found; returns their number."""
    rows = 1
    halvings = 0
    # of the load, what the rope follows from is not needed
    moving = Span.REACH if part == Part.LOAD else Span.MOMENT
    while rows > 0:
        span = stack[rows - 1, :, :]
        meeting = part_meeting(part, span, box)
        deep = span[Span.MOMENT, Moment.DEPTH] > 39.5
        # a contact takes about 100 halvings; more than this only follow a face within rounding
        if meeting == Meeting.OPEN and not deep and halvings < 20000 and part_moves(part, span):
            halve_span(rows - 1, moving, stack)
            rows = rows + 1
            halvings = halvings + 1
            continue
        rows = rows - 1
        if meeting == Meeting.NEVER:
            if found > 0 and times.shape[0] == 1:
                return found
            continue
        if found == 0:
            note_place(part, span, box, place)
        found = note_time(found, span, times)
    return found


def note_time(found: int, span: 'float[:,:]', times: 'float[:,:]') -> int:
    """Prolong the last contact by a span, or begin another one; returns the number of contacts."""
    begin = span[Span.MOMENT, Moment.START]
    end = begin + span[Span.MOMENT, Moment.LENGTH]
    rows = times.shape[0]
    # the clock rounds, and so does what was halved
    if 0 < found <= rows and begin <= times[found - 1, 1] + 1e-11 * end:
        times[found - 1, 1] = end
        return found
    if found < rows:
        times[found, 0] = begin
        times[found, 1] = end
    return found + 1


def note_place(part: int, span: 'float[:,:]', box: 'float[:]', place: 'float[:]') -> None:
    """Where a part meets a box at the start of a span in which it does."""
    for axis in range(3):
        place[axis] = span[Span.LOAD + axis, 0]
    upwards = span[Span.PULL + 2, 0]
    if part == Part.ROPE and upwards > 0.0:
        height = shared_height(0.0, span, box)
        for axis in range(2):
            rope = span[Span.REACH + axis, 0] + height * span[Span.PULL + axis, 0]
            place[axis] = rope / upwards
        place[2] = height
