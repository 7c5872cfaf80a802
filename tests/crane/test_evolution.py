"""The evolution strategy on functions whose least value is known."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.crane.evolution import Evolution


def least(evolution: Evolution, value, generations: int) -> float:
    for _ in range(generations):
        evolution.advance(value)
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
    def value(place: np.ndarray) -> float | None:
        return float(place.sum()) if (place > 0.0).all() else None

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


def test_same_seed_same_path() -> None:
    def value(place: np.ndarray) -> float:
        return float((place**2).sum())

    first, second = (Evolution(np.ones(3), 0.4) for _ in range(2))
    assert least(first, value, 20) == pytest.approx(least(second, value, 20), rel=0.0, abs=0.0)
