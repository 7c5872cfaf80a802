"""The law of friction: its values, its slopes, and the deflection that carries it."""

from __future__ import annotations

from math import exp

import numpy as np
import pytest

from segfmu.kernels.crane.friction import (
    deflection_rate,
    first_deflection,
    friction_force,
    friction_slopes,
)
from segfmu.kernels.crane.records import Plant

pytestmark = pytest.mark.interpreted

SLIDES = 2e-5


def plant(static: float = 0.0) -> np.ndarray:
    found = np.zeros(Plant.SIZE)
    found[: Plant.VISCOUS] = 2.0, 1.0, 0.5, 9.81
    found[Plant.VISCOUS : Plant.VISCOUS + 3] = 2.0, 0.0, 1.0
    found[Plant.COULOMB : Plant.COULOMB + 3] = 5.0, 4.0, 0.0
    found[Plant.STATIC : Plant.STATIC + 3] = static, 0.0, 0.0
    found[Plant.FRICTION_WIDTH], found[Plant.PRESLIDING] = 1e-3, SLIDES
    return found


def test_sliding_friction_is_odd_and_complete() -> None:
    for velocity in (1e-6, 0.01, 3.0):
        assert friction_force(plant(), 0, velocity, SLIDES) == pytest.approx(5.0 + 2.0 * velocity)
        assert friction_force(plant(), 0, -velocity, -SLIDES) == -friction_force(
            plant(), 0, velocity, SLIDES
        )
    assert friction_force(plant(), 2, 0.5, 0.0) == pytest.approx(0.5)


def test_deflection_alone_carries_what_rests() -> None:
    shares = np.linspace(-1.0, 1.0, 41)
    carried = [friction_force(plant(), 1, 0.0, share * SLIDES) for share in shares]
    assert carried == pytest.approx(4.0 * (1.5 * shares - 0.5 * shares**3))
    assert np.diff(carried).min() > 0.0


@pytest.mark.parametrize("velocity", [0.0, 5e-4, 1e-3, 4e-3])
def test_static_friction_falls_to_coulomb_friction(velocity: float) -> None:
    found = friction_force(plant(7.0), 0, velocity, SLIDES) - 2.0 * velocity
    assert found == pytest.approx(5.0 + 2.0 * exp(-((velocity / 1e-3) ** 2)))


def test_static_friction_alone_is_gone_at_speed() -> None:
    """Without Coulomb friction nothing is left of it, and nothing divides by it."""
    found = plant(7.0)
    found[Plant.COULOMB] = 0.0
    assert friction_force(found, 0, 0.5, SLIDES) == 1.0
    assert friction_slopes(found, 0, 0.5, 0.0) == (2.0, 0.0)


def test_a_contact_deflects_until_it_slides_and_back() -> None:
    assert deflection_rate(plant(), 0, 0.3, 0.5 * SLIDES) == 0.3
    assert deflection_rate(plant(), 0, 0.3, SLIDES) == 0.0
    assert deflection_rate(plant(), 0, -0.3, SLIDES) == -0.3
    assert deflection_rate(plant(), 0, -0.3, -SLIDES) == 0.0
    # the hoist has no dry friction
    assert deflection_rate(plant(), 2, 0.3, 0.0) == 0.0


def test_what_moves_at_the_start_slides() -> None:
    found = [first_deflection(plant(), 0, v) for v in (-0.2, 0.0, 5e-4, 0.2)]
    assert found == [-SLIDES, 0.0, 0.5 * SLIDES, SLIDES]
    assert first_deflection(plant(), 2, 0.2) == 0.0


@pytest.mark.parametrize("static", [0.0, 7.0])
def test_slopes_are_those_of_the_force(static: float) -> None:
    own, random = plant(static), np.random.default_rng(3)
    for velocity, share in zip(
        random.uniform(-3e-3, 3e-3, 60), random.uniform(-1.5, 1.5, 60), strict=True
    ):
        z, h = share * SLIDES, (1e-8, 1e-5 * SLIDES)
        by_velocity = (
            friction_force(own, 0, velocity + h[0], z) - friction_force(own, 0, velocity - h[0], z)
        ) / (2.0 * h[0])
        by_deflection = (
            friction_force(own, 0, velocity, z + h[1]) - friction_force(own, 0, velocity, z - h[1])
        ) / (2.0 * h[1])
        found = friction_slopes(own, 0, velocity, z)
        assert found[0] == pytest.approx(by_velocity, rel=1e-5, abs=1e-3)
        assert found[1] == pytest.approx(by_deflection, rel=1e-5, abs=1.0)


def test_drag_is_odd_and_grows_with_the_square() -> None:
    own = plant()
    own[Plant.DRAG + 2] = 0.7
    for velocity in (-3.0, -0.2, 0.0, 0.4, 2.0):
        drag = 0.7 * velocity * abs(velocity)
        assert friction_force(own, 2, velocity, 0.0) == pytest.approx(velocity + drag)
        slope, _ = friction_slopes(own, 2, velocity, 0.0)
        assert slope == pytest.approx(1.0 + 1.4 * abs(velocity))
