"""What drives, friction and travel limits refuse."""

from __future__ import annotations

import pytest

from segfmu import InputError
from segfmu.crane import Drive, Friction, TravelLimits


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Drive(lag=-0.1), "drive lag must be a finite number >= 0, got -0.1"),
        (lambda: Drive(lag=float("inf")), "drive lag"),
        (lambda: Drive(dead_time=-1.0), "drive dead_time must be a finite number >= 0, got -1"),
        (lambda: Drive(force_max=0.0), "drive force_max must be a finite number > 0"),
        (lambda: Drive(acceleration_max=-1.0), "drive acceleration_max"),
        (lambda: Drive(velocity_max=0.0), "drive velocity_max must be a finite number > 0"),
        (lambda: Drive(power_max=-1.0), "drive power_max"),
        (lambda: Drive(acceleration_max="fast"), "drive acceleration_max"),
        (lambda: Friction(viscous=(1.0, -1.0, 0.0)), "friction viscous of the trolley"),
        (lambda: Friction(coulomb=(1.0, 1.0, -2.0)), "friction coulomb of the rope"),
        (lambda: Friction(coulomb=(1.0, 1.0)), "friction coulomb must have 3 values, got 2"),
        (lambda: Friction(width=0.0), "friction width must be a finite number > 0"),
        (lambda: Friction(sway=float("nan")), "friction sway"),
        (lambda: TravelLimits(bridge=(1.0, 1.0)), "travel.bridge: min 1 m must be below max 1 m"),
        (lambda: TravelLimits(rope=(0.5, float("inf"))), "travel rope must be finite"),
        (lambda: TravelLimits(trolley=(0.5,)), "travel trolley must have 2 values"),
    ],
)
def test_bad_values_are_refused_by_name(make, words: str) -> None:
    with pytest.raises(InputError, match=words):
        make()


def test_everything_is_absent_by_default() -> None:
    assert Drive() == Drive(0.0, None, None, 0.0, None, None)
    assert Friction().viscous == Friction().coulomb == (0.0, 0.0, 0.0)
    assert TravelLimits().bridge is None
