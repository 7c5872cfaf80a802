"""Wind and payload changes: seeds, and what they refuse."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import InputError
from segfmu.crane import Gust, PayloadChange, Wind
from segfmu.crane.disturbance import Turbulence
from segfmu.kernels.numerics.records import Sinusoid


def test_noise_follows_its_seed_and_costs_nothing_when_absent() -> None:
    wind = Wind(deviation=(1.0, 0.0, 0.0), seed=4)
    assert np.array_equal(wind.components, Wind(deviation=(1.0, 0.0, 0.0), seed=4).components)
    assert not np.array_equal(wind.components, Wind(deviation=(1.0, 0.0, 0.0)).components)
    assert Wind().components.shape == (0, Sinusoid.SIZE)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_noise_may_blow_along_one_axis_alone(axis: int) -> None:
    deviation = np.zeros(3)
    deviation[axis] = 1.0
    components = Wind(deviation=tuple(deviation), seed=4).components
    assert len(components) > 0 and np.isfinite(components).all() and components.any()


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Wind(constant=(1.0, 2.0)), "wind constant must have 3 values, got 2"),
        (lambda: Wind(deviation=(1.0, -2.0, 0.0)), "wind deviation along y"),
        (lambda: Wind(bandwidth=0.0), "wind bandwidth must be a finite number > 0"),
        (lambda: Wind(bandwidth=1e9), r"wind bandwidth must be at most 1e\+06 Hz, got 1000"),
        (lambda: Turbulence((1.0, 0.0, 0.0), bandwidth=2e6), "turbulence bandwidth must be"),
        (lambda: Wind(seed=-3), "wind seed must be an integer"),
        (lambda: Gust(float("nan"), 1.0, (1.0, 0.0, 0.0)), "gust start must be a finite number"),
        (lambda: Gust(0.0, 0.0, (1.0, 0.0, 0.0)), "gust duration must be a finite number > 0"),
        (lambda: Gust(0.0, 1.0, (float("inf"), 0.0, 0.0)), "gust force must be finite"),
        (lambda: Gust(0.0, 1.0, (1.0, 0.0, 0.0), "square"), "gust shape must be cosine or sine"),
        (lambda: PayloadChange(float("inf"), 1.0), "payload change time"),
        (lambda: PayloadChange(1.0, 0.0), "payload change mass must be a finite number > 0"),
    ],
)
def test_bad_values_are_refused_by_name(make, words: str) -> None:
    with pytest.raises(InputError, match=words):
        make()
