"""Bounds of the drives, and what a state asks of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from segfmu import ActuatorBounds, Crane, InputError, Waypoint
from segfmu.crane.demand import demands_in_state
from segfmu.crane.equipment import Friction
from segfmu.kernels.crane.records import Demand


@pytest.mark.parametrize("other", [None, {}, 1.0])
def test_bounds_are_tightened_by_bounds_alone(other: object) -> None:
    with pytest.raises(InputError, match="other must be an ActuatorBounds, got"):
        ActuatorBounds().tightened(other)


def test_of_two_bounds_the_lower_one_holds() -> None:
    found = ActuatorBounds(force=[10.0, 20.0, None], velocity=1.0).tightened(
        ActuatorBounds(force=[15.0, 5.0, 30.0])
    )
    assert found.force.tolist() == [10.0, 5.0, 30.0]
    assert found.velocity.tolist() == [1.0] * 3
    assert not found.power.min() < float("inf")


def test_a_state_at_rest_asks_for_no_friction_and_one_that_moves_for_all() -> None:
    crane = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
    friction = Friction(coulomb=(4.0, 3.0, 2.0), static=(5.0, 4.0, 3.0))
    still = demands_in_state(crane, Waypoint([0.7, 0.4, -0.9]), friction)
    forces = still[:, Demand.FORCE : Demand.VELOCITY]
    assert forces == pytest.approx(np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 9.81]]))
    # far above the width over which friction falls
    moving = demands_in_state(crane, Waypoint([0.7, 0.4, -0.9], [0.3, -0.2, 0.1]), friction)
    forces = moving[:, Demand.FORCE : Demand.VELOCITY]
    expected = np.array([[4.0, 0.0, 0.0], [0.0, 3.0, 9.81 + 2.0]])
    assert forces == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("name", ["speed", 3, None, ["force"], np.zeros(3)])
def test_lower_bounds_of_no_quantity_are_refused(name: Any) -> None:
    with pytest.raises(InputError, match=r"^name must be one of force, velocity, accel.*, got "):
        ActuatorBounds(velocity=1.0).lower(name)
