"""Reproducible noise: random numbers and the spectral components of gusty wind.

The numbers are those of P. L'Ecuyer, Efficient and portable combined random number generators,
Comm. ACM 31 (1988): two integers as state, the same on every machine. They are kept as floats, so
that a model's memory is one block of floats; all products are below 2^53 and hence exact.
"""

from math import cos, floor, log, sin, sqrt

from segfmu.kernels.numerics.records import RandomState, Sinusoid


def full_circle() -> float:
    """2 pi; C99 has no name for it."""
    return 6.283185307179586


def seed_numbers(seed: int, numbers: 'float[:]') -> None:
    """Start the random numbers; seed in 0 .. 2^31 - 1."""
    other = seed * 69069 + 12345
    numbers[RandomState.FIRST] = 1.0 + seed - (seed // 2147483562) * 2147483562
    numbers[RandomState.SECOND] = 1.0 + other - (other // 2147483398) * 2147483398
    # similar seeds give similar first numbers, so skip some
    for _ in range(20):
        next_uniform(numbers)


def next_uniform(numbers: 'float[:]') -> float:
    """A number in the open interval (0, 1)."""
    first = 40014.0 * numbers[RandomState.FIRST]
    second = 40692.0 * numbers[RandomState.SECOND]
    numbers[RandomState.FIRST] = first - floor(first / 2147483563.0) * 2147483563.0
    numbers[RandomState.SECOND] = second - floor(second / 2147483399.0) * 2147483399.0
    difference = numbers[RandomState.FIRST] - numbers[RandomState.SECOND]
    if difference < 1.0:
        difference = difference + 2147483562.0
    return difference / 2147483563.0


def next_normal(numbers: 'float[:]') -> float:
    """A number of the standard normal distribution, by Box and Muller."""
    radius = sqrt(-2.0 * log(next_uniform(numbers)))
    return radius * cos(full_circle() * next_uniform(numbers))


def noise_components(
    bandwidth: float, deviation: 'float[:]', numbers: 'float[:]', components: 'float[:,:]'
) -> None:
    """Sines that add up to noise whose spectrum is flat up to a bandwidth [Hz] and zero above.

    deviation (3,): standard deviations along x, y, z [N]; components (count, 8): a `Sinusoid` a
    row, a sine with a random phase.
    Spectral representation of M. Shinozuka and C.-M. Jan, J. Sound Vib. 25 (1972); the frequencies
    are random within equal bands, so that the noise has no period.
    """
    count = components.shape[0]
    for i in range(count):
        frequency = full_circle() * bandwidth * (i + next_uniform(numbers)) / count
        components[i, Sinusoid.FREQUENCY] = frequency
        for axis in range(3):
            amplitude = deviation[axis] * sqrt(2.0 / count)
            phase = full_circle() * next_uniform(numbers)
            components[i, Sinusoid.SINE + axis] = amplitude * cos(phase)
            components[i, Sinusoid.COSINE + axis] = amplitude * sin(phase)


def turbulence_components(
    speed: float, length: float, bandwidth: float, deviation: 'float[:]', numbers: 'float[:]',
    components: 'float[:,:]',
) -> None:
    """Sines that add up to the turbulence of wind with a mean speed [m/s], up to a bandwidth [Hz].

    deviation (3,): standard deviations along x, y, z [m/s]; components: as `noise_components`.
    Spectrum of A. G. Davenport, Quart. J. R. Met. Soc. 87 (1961), f S / s^2 = 2 X^2 / (3 (1 + X^2)
    ^(4/3)) with X = f length / speed, whose integral is 1 - (1 + X^2)^(-1/3). The sines divide it
    into equal parts, at a random frequency within each.
    """
    count = components.shape[0]
    most = bandwidth * length / speed
    held = 1.0 - (1.0 + most * most) ** (-1.0 / 3.0)
    for i in range(count):
        rest = 1.0 - held * (i + next_uniform(numbers)) / count
        frequency = sqrt(1.0 / (rest * rest * rest) - 1.0) * speed / length
        components[i, Sinusoid.FREQUENCY] = full_circle() * frequency
        components[i, Sinusoid.OF_SPEED] = 1.0
        for axis in range(3):
            amplitude = deviation[axis] * sqrt(2.0 / count)
            phase = full_circle() * next_uniform(numbers)
            components[i, Sinusoid.SINE + axis] = amplitude * cos(phase)
            components[i, Sinusoid.COSINE + axis] = amplitude * sin(phase)
