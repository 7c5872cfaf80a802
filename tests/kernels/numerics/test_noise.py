"""Random numbers and wind noise by their statistics."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from segfmu.kernels.numerics.noise import (
    next_normal,
    next_uniform,
    noise_components,
    seed_numbers,
)

pytestmark = pytest.mark.interpreted


def seeded(seed: int) -> np.ndarray:
    numbers = np.zeros(2)
    seed_numbers(seed, numbers)
    return numbers


@pytest.mark.parametrize("seed", [0, 1, 2, 12345, 2**31 - 1])
def test_numbers_have_their_distributions(seed: int) -> None:
    numbers = seeded(seed)
    uniform = np.array([next_uniform(numbers) for _ in range(4000)])
    assert stats.kstest(uniform, "uniform").pvalue > 1e-3
    assert abs(np.corrcoef(uniform[1:], uniform[:-1])[0, 1]) < 0.05
    normal = np.array([next_normal(numbers) for _ in range(4000)])
    assert stats.kstest(normal, "norm").pvalue > 1e-3


def test_seeds_repeat_and_neighbours_differ() -> None:
    first, again, other = ([next_uniform(n) for _ in range(50)] for n in map(seeded, (7, 7, 8)))
    assert first == again
    assert abs(np.corrcoef(first, other)[0, 1]) < 0.4


def test_noise_has_its_deviation_and_its_band() -> None:
    components = np.zeros((32, 7))
    noise_components(2.0, np.array([1.5, 0.5, 0.0]), seeded(3), components)
    frequency = components[:, 0] / (2.0 * np.pi)
    assert frequency.min() > 0.0
    assert frequency.max() < 2.0
    assert np.diff(np.histogram(frequency, 4, (0.0, 2.0))[0]).tolist() == [0, 0, 0]
    time = np.linspace(0.0, 2000.0, 40001)
    for axis, deviation in enumerate((1.5, 0.5, 0.0)):
        values = sum(
            row[1 + axis] * np.sin(row[0] * time) + row[4 + axis] * np.cos(row[0] * time)
            for row in components
        )
        assert np.std(values) == pytest.approx(deviation, rel=0.02)


def test_numbers_are_those_of_integer_arithmetic() -> None:
    numbers = seeded(2**31 - 1)
    first, second = (int(n) for n in numbers)
    for _ in range(2000):
        found = next_uniform(numbers)
        first, second = 40014 * first % 2147483563, 40692 * second % 2147483399
        assert numbers.tolist() == [first, second]
        assert found == ((first - second - 1) % 2147483562 + 1) / 2147483563
