"""Bounds of the drives that are none."""

from __future__ import annotations

import pytest

from segfmu import ActuatorBounds, InputError


@pytest.mark.parametrize("other", [None, {}, 1.0])
def test_bounds_are_tightened_by_bounds_alone(other: object) -> None:
    with pytest.raises(InputError, match="other must be an ActuatorBounds, got"):
        ActuatorBounds().tightened(other)
