"""Stops from states with crackle and pop, where the planner's ramps of the acceleration cost time.

The optimum is that of linear programming, computed here beside the stop.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.stopping import shortest_stop

from segfmu import (
    InfeasibleError,
    Limits,
    Waypoint,
    plan,
    reach_velocity,
    replan,
    stop,
    verify,
)
from tests.campaign import soaked_rows

# limits c_1 .. c_n, and velocity, acceleration and so on; smoothness n
STATES = (
    ((1.951, 0.3973, 3.254, 0.5757, 0.2845), (-0.7223, -0.3402, 0.02206, 0.112, 0.2845)),
    ((1.797, 0.6906, 0.6034, 1.275, 0.9459), (-0.3502, 0.2866, 0.03861, -0.2702, 0.9459)),
    ((0.4547, 1.255, 0.4401, 0.2462, 2.302, 1.623),
     (-0.0968, -0.1819, -0.1494, 0.2185, 0.2988, -1.623)),
    ((1.485, 0.6312, 2.131, 0.5088, 2.62, 0.7606),
     (0.09095, 0.08447, -0.06687, -0.2863, -0.02319, 0.6792)),
    ((1.453, 1.524, 1.228, 0.4496, 1.645, 1.682), (-0.2583, -0.2426, 0.08199, 0.4496, 0.0, 0.0)),
    ((0.3332, 0.3397, 0.4165, 0.6398, 0.2894, 0.3243),
     (-0.0009895, -0.005498, -0.02363, -0.06778, -0.06809, 0.2212)),
)
# where few ends of the stages keep the limit of the acceleration
NARROW = (
    ((3.8561, 1.9146, 2.2284, 4.9416, 0.68128, 0.29588),
     (1.0166, 0.90761, 0.36986, -0.28795, -0.4037, 0.29588)),
    ((4.1054, 0.20926, 1.4637, 2.6789, 0.36948, 2.0031),
     (0.3789, -0.035493, -0.22668, -0.0071832, 0.36948, 0.0)),
    ((1.1385, 0.38225, 2.1393, 4.9633, 3.9391, 4.7528),
     (0.2196, -0.030435, -0.47604, -0.38482, 1.6215, 4.7528)),
    ((2.1428, 0.32175, 4.1475, 1.1747, 3.6798, 1.4567),
     (0.6222, 0.13088, -0.37639, -0.2719, 0.64717, 1.4567)),
)


@pytest.mark.parametrize(("bounds", "state"), STATES)
@pytest.mark.parametrize(("sign", "scale"), [
    (1.0, 1000.0), (-1.0, 1.0), *soaked_rows((1.0, 1.0), (-1.0, 1000.0)),
])
def test_a_stop_passes_zero_jerk_with_snap(
    bounds: tuple[float, ...], state: tuple[float, ...], sign: float, scale: float
) -> None:
    state = tuple(sign * scale * value for value in state)
    bounds = tuple(scale * value for value in bounds)
    n = len(bounds)
    found = stop(Waypoint(0.0, *state), limits=Limits(*bounds), smoothness=n)
    assert verify(found).passed
    optimum = shortest_stop(np.array(state[: n - 1]), np.array(bounds), 1.05 * found.duration)
    assert optimum is not None
    assert 0.998 * optimum < found.duration < 1.02 * optimum


@pytest.mark.parametrize(("bounds", "state"), NARROW)
def test_a_stop_is_found_where_few_profiles_keep_the_limits(
    bounds: tuple[float, ...], state: tuple[float, ...]
) -> None:
    found = stop(Waypoint(0.0, *state), limits=Limits(*bounds), smoothness=6)
    assert verify(found).passed
    np.testing.assert_allclose(found.state(found.duration).state(6)[0, 1:], 0.0, atol=1e-9)


@pytest.mark.parametrize(("bounds", "state"), STATES)
def test_another_velocity_is_reached_as_well(
    bounds: tuple[float, ...], state: tuple[float, ...]
) -> None:
    # a motion less a constant velocity is one as well, while its own limit is far away
    bounds = (10.0 * bounds[0], *bounds[1:])
    n = len(bounds)
    limits = Limits(*bounds)
    stopped = stop(Waypoint(0.0, *state), limits=limits, smoothness=n)
    moving = (state[0] + 0.3, *state[1:])
    reached = reach_velocity(Waypoint(0.0, *moving), 0.3, limits=limits, smoothness=n)
    assert reached.duration == pytest.approx(stopped.duration, rel=1e-9)


@pytest.mark.parametrize(("state", "limit", "value", "bound"), [
    (([1.5], [0.0]), "velocity", 1.5, 1.0), (([0.5], [1.5]), "acceleration", 1.5, 1.0),
    (([0.5], [0.5], [5.0]), "jerk", 5.0, 4.0), (([0.5], [0.5], [1.0], [30.0]), "snap", 30.0, 20.0),
])
def test_a_state_beyond_a_limit_is_named_by_plan_and_else_brought_inside(
    state: tuple[list[float], ...], limit: str, value: float, bound: float
) -> None:
    start, limits = Waypoint([0.0], *state), Limits(1.0, 1.0, 4.0, 20.0)
    with pytest.raises(InfeasibleError, match=rf"{limit} {value:g} m.* exceeds") as refused:
        plan([start, Waypoint([3.0])], limits)
    found = refused.value
    assert (found.limit, found.value, found.bound) == (limit, value, bound)
    for braked in (
        stop(start, limits=limits), reach_velocity(start, 0.1, limits=limits),
        replan(start, 0.0, Waypoint([3.0]), limits),
    ):
        judged = verify(braked)
        assert judged.passed
        assert 0.0 < float(braked.outside[0]) <= judged.outside[0]
        assert f"outside limits for {braked.outside[0]:.6g} s" in repr(braked)
        # what is left of it is kept, outside for the rest of that time
        half = 0.5 * float(braked.outside[0])
        rest = replan(braked, half, braked.waypoints[-1])
        assert verify(rest).passed
        assert rest.outside[0] == pytest.approx(half, rel=1e-6)


def test_lower_limits_may_be_broken_at_the_start_alone() -> None:
    old = plan([Waypoint([0.0, 0.0]), Waypoint([3.0, 1.0])], Limits(1.0, 1.0, 4.0, 20.0))
    low = Limits([0.5, 0.9], 1.0, 4.0, 20.0)
    slow = replan(old, 1.7, Waypoint([3.0, 1.0]), low)
    assert verify(slow).passed
    assert slow.outside[0] > 0.0
    assert slow.outside[1] == 0.0
    # not longer, not farther, not in a plan that begins inside, not later
    starts, lengths, _ = slow.pieces(0)
    first = int(np.flatnonzero(lengths > 1e-3)[0])
    timing = slow.timing.copy()
    timing[first, 1] *= 1.01
    timing[first + 1 : slow.offsets[1], 0] += 0.01 * lengths[first]
    within = plan([Waypoint([0.0, 0.0]), Waypoint([3.0, 1.0])], Limits(1.0, 1.0, 4.0, 20.0))
    lower = Limits([0.45, 0.9], 1.0, 4.0, 20.0)
    for changed in (
        replace(slow, timing=timing), replace(slow, limits=lower), replace(within, limits=low),
    ):
        assert not verify(changed).passed
    assert starts[0] == 0.0
