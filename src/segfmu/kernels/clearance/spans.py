"""A trajectory of the load as spans between changes of piece, with what its rope follows from.

The load's acceleration gives the rope's direction w = p'' / g + e_z (crane/flatness.py). So the
rope at a height h is beside the load by (h - z) w / w_z: products with w_z are polynomials in time,
linear in h, and those that a box needs are sums of the rows of a `Span`.
"""

from segfmu.kernels.clearance.records import Moment, Span
from segfmu.kernels.crane.records import RopeWork
from segfmu.kernels.crane.rope import interval_end, interval_pieces
from segfmu.kernels.numerics.polynomials import polynomial_add_product, polynomial_clear
from segfmu.kernels.trajectory.check import bernstein_coefficients
from segfmu.kernels.trajectory.records import Timing


def clearance_spans(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    gravity: float,
    work: 'float[:,:]',
    spans: 'float[:,:,:]',
) -> int:
    """Write the spans of a trajectory x, y, z of any duration; returns their number.

    Pieces as for `check_rope`, of `width` coefficients; work (RopeWork.SIZE, 4 width - 5 or more),
    spans (pieces + 1 or more, Span.SIZE, 2 width - 3).
    """
    count = 0
    time = timing[offsets[0], Timing.START]
    until = interval_end(time, timing, offsets)
    while until > time or count == 0:
        span = spans[count, :, :]
        interval_pieces(time, until, timing, coefficients, offsets, gravity, work)
        begin_span(time, until, coefficients.shape[1], work, span)
        write_span_pull(gravity, work, span)
        write_span_products(work, span)
        count = count + 1
        time = until
        until = interval_end(time, timing, offsets)
    return count


def begin_span(
    time: float, until: float, width: int, work: 'float[:,:]', span: 'float[:,:]'
) -> None:
    """Begin the span between two times [s] without a change of piece: where the load is.

    `interval_pieces` has written pieces of `width` coefficients to work, which `write_span_pull`
    goes on with.
    """
    place = 0.0
    for axis in range(3):
        write_row(
            RopeWork.LOAD + axis, width, until - time, Span.LOAD + axis, work, span
        )
        for i in range(span.shape[1]):
            place = max(place, abs(span[Span.LOAD + axis, i]))
    span[Span.MOMENT, Moment.START] = time
    span[Span.MOMENT, Moment.LENGTH] = until - time
    span[Span.MOMENT, Moment.DEPTH] = 0.0
    span[Span.MOMENT, Moment.TURN_ROUNDING] = 0.0
    # a thousandth of what is a touch
    span[Span.MOMENT, Moment.ROUNDING] = 1e-12 * place


def write_span_pull(gravity: float, work: 'float[:,:]', span: 'float[:,:]') -> None:
    """Write the direction of the rope to a span that `begin_span` has begun."""
    length = span[Span.MOMENT, Moment.LENGTH]
    count = (span.shape[1] - 1) // 2
    for axis in range(3):
        for i in range(count):
            pull = work[RopeWork.PULL + axis, i]
            work[RopeWork.PULL + axis, i] = pull / gravity
        write_row(RopeWork.PULL + axis, count, length, Span.PULL + axis, work, span)


def write_span_products(work: 'float[:,:]', span: 'float[:,:]') -> None:
    """Write what the rope's place follows from to a span that has load and pull."""
    length = span[Span.MOMENT, Moment.LENGTH]
    for axis in range(2):
        write_difference(axis, 2, 2, axis, length, Span.REACH + axis, work, span)
    write_difference(0, 1, 1, 0, length, Span.TURN, work, span)
    pull = 0.0
    for axis in range(2):
        for i in range(span.shape[1]):
            pull = max(pull, abs(span[Span.PULL + axis, i]))
    place = 1e12 * span[Span.MOMENT, Moment.ROUNDING]
    span[Span.MOMENT, Moment.TURN_ROUNDING] = 1e-14 * place * pull


def write_row(
    source: int, count: int, length: float, row: int, work: 'float[:,:]', span: 'float[:,:]'
) -> None:
    """Bernstein coefficients of `count` ascending ones of a row of `work`, in a row of a span."""
    columns = span.shape[1]
    part = span[row:row + 1, :]
    for i in range(columns):
        work[RopeWork.DEMAND, i] = 0.0
    for i in range(count):
        work[RopeWork.DEMAND, i] = work[source, i]
    bernstein_coefficients(work, RopeWork.DEMAND, columns, length, part)


def write_difference(
    first: int, pull: int, second: int, other: int, length: float, row: int,
    work: 'float[:,:]', span: 'float[:,:]',
) -> None:
    """position `first` times pull `pull` less position `second` times pull `other`, in a row."""
    width = (span.shape[1] + 3) // 2
    product = work[RopeWork.PRODUCTS, :]
    taken = work[RopeWork.PRODUCTS + 1, :]
    polynomial_clear(product)
    polynomial_clear(taken)
    polynomial_add_product(
        work[RopeWork.LOAD + first, :], width, work[RopeWork.PULL + pull, :], width - 2, product
    )
    polynomial_add_product(
        work[RopeWork.LOAD + second, :], width, work[RopeWork.PULL + other, :], width - 2, taken
    )
    for i in range(2 * width - 3):
        product[i] = product[i] - taken[i]
    write_row(RopeWork.PRODUCTS, 2 * width - 3, length, row, work, span)


def halve_span(row: int, moving: int, stack: 'float[:,:,:]') -> None:
    """Halve the first `moving` rows of a span: its second half stays, the first one follows."""
    count = stack.shape[2]
    span = stack[row, :, :]
    first = stack[row + 1, :, :]
    for k in range(moving):
        for r in range(count):
            first[k, r] = span[k, 0]
            for i in range(count - 1 - r):
                span[k, i] = 0.5 * (span[k, i] + span[k, i + 1])
    half = 0.5 * span[Span.MOMENT, Moment.LENGTH]
    first[Span.MOMENT, Moment.START] = span[Span.MOMENT, Moment.START]
    span[Span.MOMENT, Moment.START] = span[Span.MOMENT, Moment.START] + half
    span[Span.MOMENT, Moment.DEPTH] = span[Span.MOMENT, Moment.DEPTH] + 1.0
    for i in range(Moment.DEPTH, Moment.ROUNDING + 1):
        first[Span.MOMENT, i] = span[Span.MOMENT, i]
    span[Span.MOMENT, Moment.LENGTH] = half
    first[Span.MOMENT, Moment.LENGTH] = half
