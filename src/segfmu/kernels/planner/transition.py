"""Transition polynomials: Psi of (12) of the paper (errata E1, E2), and their peaks (errata E3)."""

from segfmu.kernels.numerics.numbers import HALVINGS, SAMPLES


def transition_coefficients(order: int, coefficients: 'float[:]') -> None:
    """Coefficients of Psi(s, 1) of (12) in ascending powers of s; 2 order + 2 of them."""
    for i in range(2 * order + 2):
        coefficients[i] = 0.0
    # Psi' is (2k+1)!/(k!)^2 s^k (1-s)^k; expanding the binomial gives the sum in (12).
    scale = 1.0
    for i in range(1, order + 1):
        scale = scale * (order + 1 + i) / i
    scale = scale * (order + 1)
    binomial = 1.0
    for i in range(order + 1):
        coefficients[order + 1 + i] = scale * binomial / (order + 1 + i)
        binomial = -binomial * (order - i) / (i + 1)


def polynomial_derivative(coefficients: 'float[:]', count: int, times: int, s: float) -> float:
    """Value at s of a derivative of the polynomial with `count` ascending coefficients."""
    value = 0.0
    for j in range(count - times):
        i = count - 1 - j
        factor = 1.0
        for m in range(times):
            factor = factor * (i - m)
        value = value * s + factor * coefficients[i]
    return value


def transition_peaks(order: int, coefficients: 'float[:]', peaks: 'float[:]') -> None:
    """M_j of errata E3: peaks[j] = max over [0, 1] of |d^j Psi / ds^j|, j = 1 .. order + 1.

    `coefficients` is work space for 2 order + 2 numbers. All extrema of these derivatives of
    s^k (1-s)^k lie in [0, 1]; the largest is the first one, next to s = 0, or the end itself.
    """
    count = 2 * order + 2
    transition_coefficients(order, coefficients)
    peaks[0] = 1.0
    samples = SAMPLES * (order + 1)
    for j in range(1, order + 2):
        best, at = 0.0, 0
        for i in range(samples + 1):
            value = abs(polynomial_derivative(coefficients, count, j, i / (2.0 * samples)))
            if value > best:
                best = value
                at = i
        lower = (at - 1) / (2.0 * samples)
        upper = (at + 1) / (2.0 * samples)
        if at == 0:
            lower = 0.0
        # bisect the next derivative, which changes sign at an interior extremum
        left = polynomial_derivative(coefficients, count, j + 1, lower)
        for i in range(HALVINGS):
            middle = 0.5 * (lower + upper)
            slope = polynomial_derivative(coefficients, count, j + 1, middle)
            if slope * left > 0.0:
                lower = middle
            else:
                upper = middle
        value = abs(polynomial_derivative(coefficients, count, j, 0.5 * (lower + upper)))
        if value > best:
            best = value
        peaks[j] = best
