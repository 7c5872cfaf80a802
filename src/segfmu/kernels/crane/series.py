"""Time derivatives of any order of the flat inverse, by arithmetic with truncated Taylor series.

A series is a row of coefficients: derivative over factorial. The equations are those of
crane/flatness.py; the derivatives are exact, as every rule below is.
"""

from math import atan2, sqrt


def series_product(a: 'float[:]', b: 'float[:]', count: int, found: 'float[:]') -> None:
    """found = a b, `count` coefficients."""
    for k in range(count):
        total = 0.0
        for i in range(k + 1):
            total = total + a[i] * b[k - i]
        found[k] = total


def series_quotient(a: 'float[:]', b: 'float[:]', count: int, found: 'float[:]') -> None:
    """found = a / b, where b[0] is not zero."""
    for k in range(count):
        total = a[k]
        for i in range(k):
            total = total - found[i] * b[k - i]
        found[k] = total / b[0]


def series_root(a: 'float[:]', count: int, found: 'float[:]') -> None:
    """found = sqrt(a), where a[0] is positive."""
    found[0] = sqrt(a[0])
    for k in range(1, count):
        total = a[k]
        for i in range(1, k):
            total = total - found[i] * found[k - i]
        found[k] = total / (2.0 * found[0])


def series_angle(
    y: 'float[:]', x: 'float[:]', square: 'float[:]', count: int, scratch: 'float[:]',
    found: 'float[:]',
) -> None:
    """found = atan2(y, x), where square = x x + y y: its rate is (x y' - y x') / square."""
    found[0] = atan2(y[0], x[0])
    for k in range(count - 1):
        total = 0.0
        for i in range(k + 1):
            total = total + (k + 1 - i) * (x[i] * y[k + 1 - i] - y[i] * x[k + 1 - i])
        for i in range(k):
            total = total - scratch[i] * square[k - i]
        scratch[k] = total / square[0]
        found[k + 1] = scratch[k] / (k + 1.0)


def flat_derivatives(
    flat: 'float[:,:]', order: int, bridge_mass: float, trolley_mass: float,
    payload_mass: float, gravity: float, work: 'float[:,:]', found: 'float[:]',
) -> None:
    """Time derivatives of what `crane_flat_inverse` gives.

    flat holds the derivatives 0 .. order + 4 of the load's position, work is (20, order + 3) or
    larger; found (18) are the derivatives of that order of forces, state and accelerations.
    """
    count = order + 3
    factorial = 1.0
    for i in range(count):
        if i > 1:
            factorial = factorial * i
        for axis in range(3):
            work[axis, i] = flat[i, axis] / factorial
            work[3 + axis, i] = flat[i + 2, axis] / factorial
    work[5, 0] = work[5, 0] + gravity
    # rows: 0-2 load, 3-5 pull w, 6-8 squares, 9 |w_yz|^2, 10 |w|^2, 11 |w_yz|, 12 |w|
    for axis in range(3):
        series_product(work[3 + axis, :], work[3 + axis, :], count, work[6 + axis, :])
    for i in range(count):
        work[9, i] = work[7, i] + work[8, i]
        work[10, i] = work[9, i] + work[6, i]
    series_root(work[9, :], count, work[11, :])
    series_root(work[10, :], count, work[12, :])
    # rows 15-19: the coordinates; 13 and 14 are scratch
    series_quotient(work[2, :], work[5, :], count, work[13, :])
    for axis in range(2):
        series_product(work[13, :], work[3 + axis, :], count, work[14, :])
        for i in range(count):
            work[15 + axis, i] = work[axis, i] - work[14, i]
    series_product(work[13, :], work[12, :], count, work[17, :])
    for i in range(count):
        work[17, i] = -work[17, i]
        work[13, i] = -work[3, i]
    series_angle(work[13, :], work[11, :], work[10, :], count, work[14, :], work[18, :])
    series_angle(work[4, :], work[5, :], work[9, :], count, work[14, :], work[19, :])
    factorial = 1.0
    for i in range(2, order + 1):
        factorial = factorial * i
    for j in range(5):
        found[3 + j] = factorial * work[15 + j, order]
        found[8 + j] = factorial * (order + 1.0) * work[15 + j, order + 1]
        found[13 + j] = factorial * (order + 1.0) * (order + 2.0) * work[15 + j, order + 2]
    found[0] = (bridge_mass + trolley_mass) * found[13] + payload_mass * flat[order + 2, 0]
    found[1] = trolley_mass * found[14] + payload_mass * flat[order + 2, 1]
    found[2] = -payload_mass * factorial * work[12, order]
