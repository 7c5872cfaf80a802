"""Drives at their bounds against Newton's equations; friction and gusts."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from segfmu.kernels.crane.drives import driven_derivative
from segfmu.kernels.crane.records import (
    Action,
    DriveMode,
    Plant,
    PlantState,
    State,
    Work,
)
from segfmu.kernels.crane.wind import gust_factor
from tests.crane.newton import accelerations

MASSES = (2.2, 1.155, 1.0, 9.81)


def driven(state, demand, force_max, acceleration_max=(0.0, 0.0, 0.0)):
    """Accelerations, drive forces and flags; no lag, no friction, no wind."""
    parameters, derivative = np.zeros(Plant.SIZE), np.zeros(PlantState.SIZE)
    work = np.zeros((Work.SIZE, Work.COLUMNS))
    parameters[: len(MASSES)] = MASSES
    parameters[Plant.MODE] = DriveMode.VELOCITY
    parameters[Plant.FORCE_MAX : Plant.FORCE_MIN] = force_max
    parameters[Plant.ACCELERATION_MAX : Plant.ACCELERATION_MIN] = acceleration_max
    work[Work.DEMAND, :3] = demand
    whole = np.zeros(PlantState.SIZE)
    whole[: len(state)] = state
    driven_derivative(parameters, whole, work, derivative)
    action = work[Work.ACTION]
    saturated = action[Action.SATURATED : Action.ROPE_FORCE] > 0.0
    return derivative[State.VELOCITY : State.SIZE], action[: Action.SATURATED], saturated


angles = st.floats(-1.3, 1.3)
rates = st.floats(-2.0, 2.0)
demands = st.floats(-8.0, 8.0)
bounds = st.sampled_from([0.0, 0.5, 3.0, 9.81, 12.0]) | st.floats(0.1, 40.0)


@given(
    st.tuples(angles, angles), st.floats(0.2, 3.0), st.tuples(*[rates] * 5),
    st.tuples(*[demands] * 3), st.tuples(*[bounds] * 3),
)
def test_a_drive_has_its_demand_or_lags_behind_at_its_bound(angle, length, rate, demand, most):
    state = np.array([0.0, 0.0, length, *angle, *rate, 0.0, 0.0, 0.0])
    found, force, saturated = driven(state, demand, most)
    expected = accelerations(state[:10], force, np.zeros(3), *MASSES)
    assert found == pytest.approx(expected, rel=1e-7, abs=1e-7)
    for i in range(3):
        if saturated[i]:
            assert abs(force[i]) == pytest.approx(most[i], rel=1e-9)
            assert np.sign(force[i]) * (found[i] - demand[i]) <= 1e-9
        else:
            assert found[i] == pytest.approx(demand[i], abs=1e-9)
            assert most[i] == 0.0 or abs(force[i]) <= most[i] * (1.0 + 1e-9)


def test_forces_change_continuously_where_a_bound_sets_in() -> None:
    state = np.array([0.0, 0.0, 0.7, 0.3, -0.2, 0.1, 0.2, 0.0, 0.5, -0.4, 0.0, 0.0, 0.0])
    needed = driven(state, (1.0, 0.5, 0.2), (0.0, 0.0, 0.0))[1]
    below = driven(state, (1.0, 0.5, 0.2), np.abs(needed) * (1.0 - 1e-7))
    above = driven(state, (1.0, 0.5, 0.2), np.abs(needed) * (1.0 + 1e-7))
    assert below[2].any()
    assert not above[2].any()
    assert below[0] == pytest.approx(above[0], abs=1e-5)


def test_accelerations_are_bounded_and_flagged() -> None:
    state = np.array([0.0, 0.0, 0.7, 0.3, -0.2, 0.1, 0.2, 0.0, 0.5, -0.4, 0.0, 0.0, 0.0])
    found, _, saturated = driven(state, (1.0, -2.0, 0.2), (0.0,) * 3, (1.0, 0.6, 0.5))
    assert found[:3].tolist() == [1.0, -0.6, 0.2]
    assert saturated.tolist() == [False, True, False]


@pytest.mark.parametrize("shape", [0.0, 1.0])
def test_gusts_rise_to_one_and_are_zero_outside(shape: float) -> None:
    assert [gust_factor(shape, s) for s in (-0.1, 0.0, 1.0, 1.1)] == [0.0] * 4
    assert gust_factor(shape, 0.5) == pytest.approx(1.0)
    assert gust_factor(shape, 0.25) == pytest.approx(0.5 if shape == 0.0 else np.sqrt(0.5))


@pytest.mark.parametrize("velocity", [-0.4, 0.4])
def test_drives_overcome_their_friction_while_the_rope_is_slack(velocity: float) -> None:
    """Each carriage has its own mass to accelerate, and against its friction."""
    plant, state = np.zeros(Plant.SIZE), np.zeros(PlantState.SIZE)
    work, derivative = np.zeros((Work.SIZE, Work.COLUMNS)), np.zeros(PlantState.SIZE)
    plant[: len(MASSES)] = MASSES
    plant[Plant.MODE] = DriveMode.VELOCITY
    state[State.POSITION + 2], state[PlantState.PAID_OUT] = 0.8, 0.9
    state[State.VELOCITY : State.VELOCITY + 2] = velocity
    state[PlantState.SLACK] = 1.0
    demand, friction = np.array([0.5, -0.2, 0.1]), np.array([3.0, 2.0, 1.0]) * np.sign(velocity)
    work[Work.DEMAND, :3], work[Work.FRICTION, :3] = demand, friction
    driven_derivative(plant, state, work, derivative)
    force = work[Work.ACTION][Action.FORCE : Action.FORCE + 3]
    # bridge with the trolley, the trolley, and a drum without a mass
    assert force == pytest.approx(np.array([2.2 + 1.155, 1.155, 0.0]) * demand + friction)
    assert derivative[State.VELOCITY : State.VELOCITY + 2] == pytest.approx(demand[:2])
    assert work[Work.ACTION, Action.ROPE_FORCE] == 0.0
