"""Steeper rises where the usual ones do not fit: against motions whose last derivative jumps."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Limits, Trajectory, Waypoint, plan, verify
from segfmu.kernels.planner.records import Phase, Shape
from tests.problems import AxisProblem, shortest_duration

pytestmark = pytest.mark.interpreted

# limits; v, a -> w, b over a distance
FITTING = [
    ((1.6786, 0.6213, 0.5689), (0.88, 0.1572, 0.8038, -0.1712, 0.8573)),
    ((0.6005, 0.5802, 2.0459), (-0.3156, -0.1366, -0.4413, -0.4522, -0.1154)),
    ((0.5414, 1.6585, 1.0397), (0.0781, -0.8866, 0.2265, 1.032, -0.3714)),
    ((1.699, 0.627, 2.59, 1.31), (1.359, 0.0, 1.359, -0.251, 2.553)),
    ((3.5724, 1.7674, 1.3472, 4.1464), (2.8544, -0.0707, 2.6598, 0.0961, 3.2688)),
    # an end that only steeper rises reach from the velocity limit without braking
    ((1.9294, 3.4937, 4.0529, 0.7706), (0.0, 1.3975, 0.0, -1.3975, 4.3366)),
    # an acceleration that keeps its sign, beside a profile that brakes
    ((0.9463, 1.4104, 2.4929, 1.0041), (0.65, -0.2785, 0.1509, -0.5278, 1.3194)),
    ((0.9048, 1.1233, 3.669, 1.179, 0.6283), (0.0811, -0.6125, -0.6892, 0.1461, -2.0979)),
    (
        (4.1085, 2.5624, 0.6791, 0.8332, 0.5157, 0.8361),
        (1.376, -1.0895, 2.1212, 1.2306, 0.2161),
    ),
]
# here they did not fit the profiles of the first search
SHORTER = [
    ((1.1746, 1.6921, 2.9627, 3.8189, 4.6568), (0.2921, 0.1814, -0.1644, -0.734, 0.6)),
    ((0.9669, 0.9282, 1.1447, 1.9913, 1.4536, 0.9127), (-0.7411, 0.515, -0.6815, -0.436, -0.8368)),
]
# with the usual rises one of the ends cannot be braked
REFUSED = [
    ((1.305275, 3.526176, 0.864504), (0.353234, -0.534242, -0.490459, 1.150318, 2.827886)),
    ((1.1876, 3.1847, 2.396, 1.8507), (-0.9433, 1.9039, 0.2564, -1.2068, 1.5255)),
    (
        (0.9, 0.779447, 2.137222, 0.728317, 0.579949),
        (0.0, 0.623557, 0.0, 0.311779, -0.635618),
    ),
]


def planned(
    limits: tuple[float, ...], state: tuple[float, ...], smoothness: int
) -> Trajectory:
    v, a, w, b, distance = state
    points = [Waypoint([0.0], [v], [a]), Waypoint([distance], [w], [b])]
    return plan(points, Limits(*limits), smoothness=smoothness)


def usual(limits: tuple[float, ...], state: tuple[float, ...]) -> tuple[int, float]:
    """Number of phases, or the status, and duration with the usual rises alone."""
    v, a, w, b, distance = state
    problem = AxisProblem(len(limits), Shape.PLATEAU, (*limits, 0.0), v, a, w, b, distance)
    count, phases = problem.shortest()
    return count, float(phases[:, Phase.DURATION].sum())


@pytest.mark.parametrize(("limits", "state"), FITTING)
def test_smoothness_costs_little_where_the_usual_rises_do_not_fit(limits, state) -> None:
    trajectory = planned(limits, state, len(limits))
    count, duration = usual(limits, state)
    assert count > 0 and duration > 1.5 * trajectory.duration
    assert verify(trajectory).passed
    # without smoothness of the last order the highest limited derivative jumps
    assert trajectory.duration < 1.1 * planned(limits, state, len(limits) - 1).duration


@pytest.mark.parametrize(("limits", "state"), SHORTER)
def test_the_usual_rises_fit_a_shorter_profile(limits, state) -> None:
    trajectory = planned(limits, state, len(limits))
    count, duration = usual(limits, state)
    assert count > 0 and duration < 1.01 * trajectory.duration
    assert trajectory.duration < 1.1 * planned(limits, state, len(limits) - 1).duration


@pytest.mark.parametrize(("limits", "state"), REFUSED)
def test_steeper_rises_brake_what_the_usual_ones_do_not(limits, state) -> None:
    trajectory = planned(limits, state, len(limits))
    count, _ = usual(limits, state)
    assert count < 0
    assert verify(trajectory).passed
    assert trajectory.duration < 1.1 * planned(limits, state, len(limits) - 1).duration


@pytest.mark.parametrize("smoothness", [3, 4])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_several_velocities_make_the_cruise_vanish(sign: float, smoothness: int) -> None:
    # the optimum by a linear program over 300 cells is between 1.11 and 1.12 s; at smoothness 4
    # moderate rises of the snap take 0.8 % more than the steepest ones
    limits = (0.16900397751310237, 1.0649514344931368, 33.71958381850731, 47.19453897301386)
    state = (0.08809892781208069, 0.6870024137216008, 0.16900269682194985, 0.0, 0.04927726821898364)
    mirrored = tuple(sign * value for value in state)
    most = 1.1125 if smoothness == 3 else 1.1125 * 1.008
    assert shortest_duration(planned(limits, mirrored, smoothness)) < most


@pytest.mark.parametrize("seed", range(5))
def test_the_usual_rises_stay_where_they_fit(seed: int) -> None:
    random = np.random.default_rng(seed)
    limits = tuple(10.0 ** random.uniform(-0.5, 1.0, 4))
    state = (0.0, 0.0, 0.0, 0.0, float(random.normal()))
    _, duration = usual(limits, state)
    assert planned(limits, state, 4).duration == duration
