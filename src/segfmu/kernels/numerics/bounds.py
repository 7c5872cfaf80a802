"""Bounds of a polynomial on an interval, from its Bernstein coefficients: wide, but cheap."""


def polynomial_hull(values: 'float[:]', count: int, length: float) -> None:
    """Replace `count` ascending coefficients by those of Bernstein on [0, length]."""
    scale = 1.0
    for i in range(1, count):
        # of the power of the length over the binomial coefficient
        scale = scale * (length * i / (count - i))
        values[i] = values[i] * scale
    for r in range(1, count):
        for j in range(count - r):
            i = count - 1 - j
            values[i] = values[i] + values[i - 1]


def polynomial_bounds(values: 'float[:]', count: int, length: float) -> 'tuple[float, float]':
    """Bounds on [0, length] of `count` ascending coefficients, which are used up."""
    polynomial_hull(values, count, length)
    least = values[0]
    most = least
    for i in range(1, count):
        least = min(least, values[i])
        most = max(most, values[i])
    return least, most
