"""The evolution strategy on functions whose least value is known."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.crane.evolution import EQUAL, Evolution, ranked, roots


def least(evolution: Evolution, value, generations: int) -> float:
    for _ in range(generations):
        evolution.advance(lambda place: (False, value(place)))
    return float(value(evolution.mean))


def test_narrow_ellipsoid_that_is_turned() -> None:
    turn = np.linalg.qr(np.random.default_rng(3).standard_normal((6, 6)))[0]
    scale = 10.0 ** np.linspace(0.0, 3.0, 6)

    def value(place: np.ndarray) -> float:
        return float((scale * (turn @ (place - 1.0)) ** 2).sum())

    assert least(Evolution(np.zeros(6), 0.5), value, 300) < 1e-10


def test_rosenbrock() -> None:
    def value(place: np.ndarray) -> float:
        return float((100.0 * (place[1:] - place[:-1] ** 2) ** 2 + (1.0 - place[:-1]) ** 2).sum())

    assert least(Evolution(np.zeros(4), 0.3), value, 400) < 1e-10


def test_places_without_a_value_are_sampled_again() -> None:
    # the least value is in a corner of what has a value: one of 32 places about it
    def value(place: np.ndarray) -> tuple[bool, float] | None:
        return (False, float(place.sum())) if (place > 0.0).all() else None

    evolution = Evolution(np.full(5, 2.0), 0.5)
    for _ in range(200):
        evolution.advance(value)
    assert (evolution.mean > 0.0).all()
    assert evolution.mean.sum() < 0.05


def test_nothing_has_a_value() -> None:
    evolution = Evolution(np.zeros(3), 0.5)
    for _ in range(60):
        evolution.advance(lambda place: None)
    assert not evolution.mean.any()
    assert evolution.settled


@pytest.mark.parametrize("plateau", [0.0, 0.5])
def test_the_last_digits_of_values_do_not_matter(plateau: float) -> None:
    """Not one bit of the path, also where many values are equal but for rounding."""
    random = np.random.default_rng(1)

    def value(place: np.ndarray) -> float:
        return float(max((place**2).sum(), plateau) + 7.0)

    exact, rounded = (Evolution(np.ones(6), 0.4) for _ in range(2))
    for _ in range(40):
        exact.advance(lambda place: (False, value(place)))
        rounded.advance(
            lambda place: (False, value(place) * (1.0 + random.uniform(-1e-14, 1e-14)))
        )
    assert np.array_equal(exact.mean, rounded.mean)
    assert np.array_equal(exact.covariance, rounded.covariance)
    assert not np.array_equal(exact.mean, np.ones(6))


def test_equal_values_stay_in_their_order() -> None:
    tiny = 0.1 * EQUAL
    values = [(False, 2.0 + tiny), (True, 1.0), (False, 2.0), (False, 1.0), (False, 2.0 - tiny)]
    assert ranked(values) == [3, 0, 2, 4, 1]
    assert ranked([(False, 2.0 + 20.0 * tiny), (False, 2.0)]) == [1, 0]
    assert ranked([]) == []


@pytest.mark.parametrize("size", [1, 2, 12, 30])
@pytest.mark.parametrize("decades", [0.0, 4.0, 8.0])
def test_roots_are_those_of_the_eigenvalues(size: int, decades: float) -> None:
    turn = np.linalg.qr(np.random.default_rng(4).standard_normal((size, size)))[0]
    spread = 10.0 ** np.linspace(0.0, -decades, size)
    root, inverse = roots((turn * spread) @ turn.T)
    assert root == pytest.approx((turn * spread**0.5) @ turn.T, rel=0.0, abs=1e-9)
    assert root @ inverse == pytest.approx(np.eye(size), rel=0.0, abs=1e-6)
