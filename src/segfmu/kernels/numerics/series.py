"""Arithmetic with truncated Taylor series, for exact derivatives of any order.

A series is an array of coefficients: derivative over factorial. Every function computes the first
`count` coefficients of its result; `found` may be an operand of sum, difference and negative only.
"""

from math import atan2, exp, sqrt


def series_factorial(order: int) -> float:
    """order! as a float."""
    product = 1.0
    for i in range(2, order + 1):
        product = product * i
    return product


def series_of_derivatives(
    values: 'float[:,:]', first: int, column: int, count: int, found: 'float[:]'
) -> None:
    """Series of a function from its derivatives in a column of `values`, from a row on."""
    scale = 1.0
    for i in range(count):
        if i > 1:
            scale = scale * i
        found[i] = values[first + i, column] / scale


def series_derivative(a: 'float[:]', order: int) -> float:
    """The derivative of an order, from a series."""
    return series_factorial(order) * a[order]


def series_sum(a: 'float[:]', b: 'float[:]', count: int, found: 'float[:]') -> None:
    """found = a + b."""
    for i in range(count):
        found[i] = a[i] + b[i]


def series_difference(a: 'float[:]', b: 'float[:]', count: int, found: 'float[:]') -> None:
    """found = a - b."""
    for i in range(count):
        found[i] = a[i] - b[i]


def series_negative(a: 'float[:]', count: int, found: 'float[:]') -> None:
    """found = -a."""
    for i in range(count):
        found[i] = -a[i]


def series_product(a: 'float[:]', b: 'float[:]', count: int, found: 'float[:]') -> None:
    """found = a b."""
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


def series_exponential(a: 'float[:]', count: int, found: 'float[:]') -> None:
    """found = exp(a): its rate is exp(a) a'."""
    found[0] = exp(a[0])
    for k in range(1, count):
        total = 0.0
        for i in range(1, k + 1):
            total = total + i * a[i] * found[k - i]
        found[k] = total / k


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
