"""What must hold for every plan: symmetries, scales, monotonicity, derivatives."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.planning.limits import NAMES
from tests.problems import AxisProblem, axis_problems


def move(problem: AxisProblem) -> Trajectory:
    """The plan of one axis problem."""
    start = Waypoint([0.0], [problem.v], [problem.a])
    end = Waypoint([problem.distance], [problem.w], [problem.b])
    limits = Limits(*(c or None for c in problem.limits[:6]))
    shape = ("smoothstep", "plateau")[problem.shape]
    return plan([start, end], limits, smoothness=problem.smoothness, shape=shape)


def planned(problem: AxisProblem, **changes) -> Trajectory:
    """The plan of one axis problem; problems without a plan are left out."""
    problem = replace(problem, **changes)
    velocity, acceleration = problem.limits[:2]
    change = max(
        abs(problem.v - problem.w) / velocity, abs(problem.a - problem.b) / acceleration
    )
    # states within 1e-9 of zero or of a limit are settled there
    assume(abs(problem.distance) > 1e-9 or change > 2e-9)
    try:
        return move(problem)
    except InfeasibleError as error:
        assert error.limit == "velocity"
        assume(False)
        raise


@settings(max_examples=150, deadline=None)
@given(axis_problems())
def test_time_reversal(problem: AxisProblem) -> None:
    reversed_ = planned(problem, v=problem.w, w=problem.v, a=-problem.b, b=-problem.a)
    assert reversed_.duration == pytest.approx(planned(problem).duration, rel=1e-12)


@settings(max_examples=150, deadline=None)
@given(axis_problems())
def test_mirror(problem: AxisProblem) -> None:
    trajectory = planned(problem)
    mirrored = planned(
        problem, v=-problem.v, w=-problem.w, a=-problem.a, b=-problem.b,
        distance=-problem.distance,
    )
    assert mirrored.duration == pytest.approx(trajectory.duration, rel=1e-12)


@settings(max_examples=100, deadline=None)
@given(axis_problems(), st.integers(-3, 3), st.integers(-6, 6))
def test_scaling_of_time_and_length(problem: AxisProblem, halvings: int, doublings: int) -> None:
    # powers of two, which double precision scales by without rounding
    time, length = 2.0**halvings, 2.0**doublings
    scaled = planned(
        problem,
        v=problem.v * length / time, w=problem.w * length / time,
        a=problem.a * length / time**2, b=problem.b * length / time**2,
        distance=problem.distance * length,
        limits=tuple(c * length / time ** (i + 1) for i, c in enumerate(problem.limits)),
    )
    trajectory = planned(problem)
    assert scaled.duration == pytest.approx(time * trajectory.duration, rel=1e-6, abs=1e-9 * time)


# an acceleration is reached within a distance of 1e-22 m, where none is asked
@example(AxisProblem(2, 0, (0.5, 0.5, 1.0), 0.0, 0.0, 0.0, -5e-8, 0.0), 0, 0.5)
@settings(max_examples=100, deadline=None)
@given(axis_problems(), st.integers(0, 6), st.floats(0.5, 0.99))
def test_tightening_a_limit_never_shortens(problem: AxisProblem, order: int, share: float) -> None:
    order = order % len(problem.limits)
    tight = [c * share if i == order else c for i, c in enumerate(problem.limits)]
    assume(tight[0] >= max(abs(problem.v), abs(problem.w)))
    assume(tight[1] >= max(abs(problem.a), abs(problem.b)))
    loose = planned(problem)
    # ramps are shaped, so a candidate of other limits can be shorter by a little
    assert planned(problem, limits=tuple(tight)).duration >= loose.duration * (1.0 - 0.05)


# A plan goes through a state; its parts were once refused, or planned by way of zero acceleration.
NO_ROOM = AxisProblem(4, 0, (0.5, 0.5, 0.0, 0.5, 0.0), 0.0, -0.25, -0.375, -0.5, -0.1)
LONGER = AxisProblem(4, 0, (1.0, 1.0, 2.0, 8.0, 0.0), 0.0, -1.0, 0.0, -1.0, 1.0)
LONGER_BY_LESS = AxisProblem(4, 0, (0.5, 0.5, 0.0, 4.0, 0.0), -0.25, 0.375, 0.25, -0.375, 0.75)
SPLITS = [
    (NO_ROOM, 0.5),
    (LONGER_BY_LESS, 0.65),
    (LONGER, 0.4),
]


@pytest.mark.parametrize(("problem", "share"), SPLITS)
def test_every_state_of_a_plan_is_a_waypoint(problem: AxisProblem, share: float) -> None:
    assert split_and_join(problem, move(problem), share) == "joined"


def test_split_and_join() -> None:
    # a state while cruising or at the acceleration limit is a waypoint that costs nothing; it can
    # be refused where the velocity limit leaves no room to bring its acceleration to zero
    outcomes = {"joined": 0, "no room": 0}

    @settings(max_examples=60, deadline=None)
    @given(axis_problems(smoothness=4), st.floats(0.05, 0.95))
    @example(NO_ROOM, 0.5)
    def check(problem: AxisProblem, share: float) -> None:
        outcome = split_and_join(problem, planned(problem), share)
        assume(outcome != "nothing held")
        outcomes[outcome] += 1

    check()
    assert outcomes["joined"] >= 9 * outcomes["no room"]


def split_and_join(problem: AxisProblem, trajectory: Trajectory, share: float) -> str:
    """Plan through a state of a plan; "no room" where its acceleration cannot be braked."""
    starts, lengths, coefficients = trajectory.pieces(0)
    level = 2.0 * np.abs(coefficients[:, 2]) / problem.limits[1]
    calm = ~coefficients[:, 3:].any(axis=1) & ((level == 0.0) | (level > 1.0 - 1e-9))
    holds = np.flatnonzero(calm & (lengths > 0.01))
    if not holds.size:
        return "nothing held"
    time = float(starts[holds[0]] + share * lengths[holds[0]])
    middle = Waypoint(*(trajectory(time, d) for d in range(3)))
    try:
        joined = plan(
            [trajectory.waypoints[0], middle, trajectory.waypoints[1]], trajectory.limits,
            shape=trajectory.shape,
        )
    except InfeasibleError as error:
        # the plan up to the middle ends with its acceleration, the one from there begins with it
        second = error.interval == 2
        assert f"braking the {'first' if second else 'last'} acceleration" in str(error)
        sign = 1.0 if second else -1.0
        time = ramp_duration(abs(middle.acceleration[0]), problem.axis())[0]
        braked = middle.velocity[0] + sign * 0.5 * middle.acceleration[0] * time
        assert abs(braked) > problem.limits[0]
        return "no room"
    # where the velocity limit is touched without a cruise, the candidates are near optimal only
    assert joined.duration <= trajectory.duration * (1.0 + 0.05) + 1e-9
    return "joined"


@settings(max_examples=60, deadline=None)
@given(axis_problems())
def test_derivatives_belong_together(problem: AxisProblem) -> None:
    trajectory = planned(problem)
    assume(trajectory.duration > 0.0)
    starts, lengths, _ = trajectory.pieces(0)
    ends = np.append(starts, trajectory.duration)
    # Gauss's rule of n nodes is exact for the degree 2 n - 1 of the pieces
    nodes, weights = np.polynomial.legendre.leggauss(problem.smoothness)
    times = starts[:, None] + lengths[:, None] * (0.5 + 0.5 * nodes)
    for d in range(problem.smoothness):
        value, slope = trajectory(ends, d)[:, 0], trajectory(times, d + 1)[:, :, 0]
        integral = value[0] + np.cumsum(0.5 * lengths * (slope @ weights))
        # the derivatives may jump by 1e-9 of their peaks between pieces, as `verify` allows
        bound = np.abs(slope).max() * trajectory.duration + np.abs(value).max()
        assert np.abs(value[1:] - integral).max() <= 1e-9 * bound, NAMES[max(d - 1, 0)]
