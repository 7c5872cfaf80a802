"""Ends of gaps between feasible durations, against linear programs over the jerk."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import linprog

from segfmu import Limits, Trajectory, Waypoint, plan, verify
from segfmu.kernels.planner.gaps import gap_ends, insert_end
from segfmu.kernels.planner.records import PlanWork
from tests.problems import AxisProblem, work_space
from tests.property.soak_axes import earlier

CELLS = 160


def reaches(problem: AxisProblem, duration: float) -> bool:
    """Whether some jerk, constant in each of many cells, meets the boundary in that duration."""
    h = duration / CELLS
    velocity, acceleration, jerk = problem.limits[:3]
    k = np.arange(CELLS)
    after = np.maximum(k[:, None] - k[None, :], 0.0)
    own = (k[:, None] >= k[None, :]).astype(float)
    a = own * h
    v = own * h * h * (after + 0.5)
    y = own[-1] * h**3 * (0.5 * after[-1] ** 2 + 0.5 * after[-1] + 1.0 / 6.0)
    t = h * (k + 1.0)
    a0, v0 = np.full(CELLS, problem.a), problem.v + problem.a * t
    y0 = problem.v * duration + 0.5 * problem.a * duration**2
    rows = np.vstack([a, -a, v, -v])
    bounds = np.concatenate([
        acceleration - a0, acceleration + a0, velocity - v0, velocity + v0,
    ])
    found = linprog(
        np.zeros(CELLS), A_ub=rows, b_ub=bounds, A_eq=np.vstack([y, v[-1], a[-1]]),
        b_eq=[problem.distance - y0, problem.w - v0[-1], problem.b - a0[-1]],
        bounds=(-jerk, jerk), method="highs",
    )
    return found.status == 0


def slow_partner(problem: AxisProblem, target: float) -> tuple[list[Waypoint], Limits]:
    """A plan of two axes: the problem, and one that rests at both ends and takes `target`."""
    # rest to rest with c_1 = 1 and hardly any ramp: distance + 1 / c_2 + c_2 / c_3
    distance = target - 1.0 / 1e3 - 1e3 / 1e7
    points = [
        Waypoint([0.0, 0.0], [problem.v, 0.0], [problem.a, 0.0]),
        Waypoint([problem.distance, distance], [problem.w, 0.0], [problem.b, 0.0]),
    ]
    velocity, acceleration, jerk = problem.limits[:3]
    return points, Limits([velocity, 1.0], [acceleration, 1e3], [jerk, 1e7])


@pytest.mark.parametrize(
    ("problem", "inside"),
    [
        # keeps going forwards as slowly as it can, then has to turn back
        (AxisProblem(2, 1, (2.0, 0.6, 3.0), 1.36, -0.11, 1.7, 0.38, 1.9), 2.2),
        (AxisProblem(2, 1, (2.0, 0.4, 3.0), -1.04, 0.2, -1.04, -0.2, -1.06), 2.0),
        # slow and nearly there: the gap is short
        (AxisProblem(2, 1, (1.0, 1.0, 1.0), 0.3, 0.0, 0.3, 0.0, 0.05), 0.5),
    ],
)
def test_a_common_duration_in_a_gap_goes_to_its_end(problem: AxisProblem, inside: float) -> None:
    points, limits = slow_partner(problem, inside)
    assert not reaches(problem, inside)
    found = plan(points, limits, smoothness=2).duration
    assert found > 1.02 * inside
    # the optimum over cells is a little slower than that over all jerks
    assert not reaches(problem, 0.99 * found)
    assert reaches(problem, 1.01 * found)


def test_ends_rise_and_come_after_the_given_duration() -> None:
    problem = AxisProblem(4, 1, (2.0, 0.6, 3.0, 20.0, 0.0), 1.36, -0.11, 1.7, 0.38, 1.9)
    work = work_space()
    count = gap_ends(1.3, problem.boundary(), problem.axis(), work)
    ends = work[PlanWork.GAP_ENDS :, 0]
    assert count >= 2
    assert (np.diff(ends[:count]) > 0.0).all() and ends[0] > 1.3


def test_insertion_keeps_the_earliest() -> None:
    ends = np.zeros((3, 8))
    count = 0
    for duration in (5.0, 2.0, 9.0, 0.5, 4.0, 2.0, 8.0):
        count = insert_end(duration, 1.0, count, ends)
    assert count == 3
    assert ends[:, 0].tolist() == [2.0, 4.0, 5.0]


TURNS = (
    (
        AxisProblem(
            5, 0, (12.9079862806, 8.0, 2.2264995785, 2.0, 0.1219789019),
            6.279442737, -3.578619206, -1.002483126, -0.1165917749, 13.80614924,
        ),
        35.0,
    ),
)


PASSED = (
    (
        AxisProblem(
            4, 1, (0.0707468147, 0.0498065466, 0.1753526762, 4.0, 0.03723825),
            -0.0003677391119, -0.01985812885, 0.01037935882, 0.01908260604, -0.122146877,
        ),
        5.54,
    ),
    (
        AxisProblem(
            6, 1, (16.9799542734, 2.3222803585, 2.5390431977, 0.3768493508, 0.0363073190, 9.0),
            0.0, -2.322280358, 2.668961957, 2.230235755, -179.4507204,
        ),
        45.6,
    ),
)


def with_partner(problem: AxisProblem, inside: float) -> Trajectory:
    """The plan of a problem beside an axis that takes a given time."""
    names = ("velocity", "acceleration", "jerk", "snap", "crackle", "pop")
    shape = ("smoothstep", "plateau")[problem.shape]

    def common(distance: float) -> Trajectory:
        points = [
            Waypoint([0.0, 0.0], [problem.v, 0.0], [problem.a, 0.0]),
            Waypoint([problem.distance, distance], [problem.w, 0.0], [problem.b, 0.0]),
        ]
        both = {n: [c, partner] for n, c, partner in zip(
            names, problem.limits, (1.0, 10.0, 1e3, 1e5, 1e7, 1e9), strict=False
        )}
        return plan(points, Limits(**both), smoothness=problem.smoothness, shape=shape)

    # the partner rests at both ends and cruises at 1 m/s: a meter takes it a second
    rest = common(100.0).duration - 100.0
    return common(inside - rest)


@pytest.mark.parametrize(("problem", "inside"), TURNS)
def test_a_gap_ends_where_the_duration_over_the_cruise_velocity_turns(
    problem: AxisProblem, inside: float
) -> None:
    """The feasible durations behind such an end are few: who misses it waits for the next gap."""
    trajectory = with_partner(problem, inside)
    assert trajectory.duration > 1.0005 * inside
    assert earlier(trajectory) is None


@pytest.mark.parametrize(("problem", "inside"), PASSED)
def test_passing_profiles_fill_gaps_of_the_other_forms(problem: AxisProblem, inside: float) -> None:
    assert with_partner(problem, inside).duration == pytest.approx(inside, rel=1e-9)


def test_a_window_that_begins_at_no_end_of_a_gap_is_found() -> None:
    """Of a dense path with free states: the first end of the gap was at 0.949 s."""
    first = Waypoint(
        [0.0, 0.0], [0.2627752684438861, 0.0094610459283731],
        [-0.7740572736838166, -0.2859177989379755],
    )
    second = Waypoint(
        [0.05280347277962499, -0.00109711511937649], [0.12148363617898043, 0.02995727407165822],
        [-0.06723673746364064, 0.4188018367784865],
    )
    limits = Limits(
        [1.3286968592499435, 1.0635319141712856], [0.9901504241139066, 0.7925484045095353],
        [5.405615951491496, 4.326829735572606], [38.30734854767022, 30.66244000210017],
    )
    trajectory = plan([first, second], limits)
    assert verify(trajectory).passed
    assert trajectory.duration < 0.315
