"""Polynomials as arrays of ascending coefficients."""


def polynomial_differentiate(a: 'float[:]', count: int, order: int, found: 'float[:]') -> None:
    """Put a derivative of a polynomial of `count` coefficients into found."""
    for i in range(count - order):
        factor = 1.0
        for j in range(order):
            factor = factor * (i + j + 1)
        found[i] = factor * a[i + order]


def polynomial_add_product(
    a: 'float[:]', a_count: int, b: 'float[:]', b_count: int, found: 'float[:]'
) -> None:
    """found = found + a b."""
    for i in range(a_count):
        for j in range(b_count):
            found[i + j] = found[i + j] + a[i] * b[j]


def polynomial_clear(found: 'float[:]') -> None:
    """found = 0."""
    for i in range(found.shape[0]):
        found[i] = 0.0


def polynomial_shift(a: 'float[:]', offset: float, count: int) -> None:
    """Rewrite a polynomial, in place, about the offset: its value at 0 is the one at the offset."""
    # repeated synthetic division
    for i in range(count - 1):
        for j in range(count - 1 - i):
            k = count - 2 - j
            a[k] = a[k] + offset * a[k + 1]
