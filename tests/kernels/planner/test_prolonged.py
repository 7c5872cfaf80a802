"""Durations that smooth motions have: a gap between feasible durations must not contain them."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.completeness import random_problem
from benchmarks.optimal_control import Transition, earliest, feasible
from benchmarks.smooth_motions import boundary, smooth_motion

from segfmu import InfeasibleError, Limits, Waypoint, plan, verify
from tests.campaign import campaign

# smoothness, limits, velocity and acceleration at both ends, distance: of polynomials that last 1 s
# and keep 77 or 95 % of the limits; segfmu once found their durations infeasible
MOTIONS = (
    (4, (0.3177, 0.3468, 1.3003, 4.0037), 0.152636, 4 / 15, 0.152636, -4 / 15,
     0.20977885714285713),
    (4, (0.1281801106, 0.3384028267, 1.30026, 4.550000259), 0.0, -0.260257815136,
     -0.016853797863, 0.260257815136, -0.0641964307464),
    (4, (0.05262560826, 0.2492757488, 1.05021, 3.878596659), 0.0201384035915, -0.237358003421,
     0.0501096049886, 0.237310536783, -0.0163096746734),
    (3, (0.1021398526, 0.3010344736, 1.05021, 3.139888307), 0.00884666592625, 0.286642170232,
     -0.00501783990397, -0.286642170232, 0.0617013755988),
    (5, (0.1204128624, 0.2084686335, 1.05021, 4.247169015, 35.53789349), 0.114655985354,
     -0.198499075662, 0.102496276437, 0.198501855341, 0.0634641065414),
    (6, (0.09930985097, 0.25667874, 1.30026, 5.35984156, 43.71778868, 437.0701391),
     0.00248859433486, 0.197405703502, 0.0, -0.197405703502, 0.0463634806571),
)


@pytest.mark.parametrize(("smoothness", "limits", "v", "a", "w", "b", "distance"), MOTIONS)
def test_a_duration_that_a_smooth_motion_has(
    smoothness: int, limits: tuple[float, ...], v: float, a: float, w: float, b: float,
    distance: float,
) -> None:
    points = [Waypoint(0.0, v, a), Waypoint(distance, w, b)]
    trajectory = plan(points, Limits(*limits), smoothness=smoothness, duration=1.0)
    assert trajectory.duration == pytest.approx(1.0, rel=1e-12)
    assert verify(trajectory).passed


def test_axes_meet_shortly_after_their_shortest_profiles() -> None:
    """Both axes have smooth motions of 1 s; the second one none of the first one's shortest."""
    points = [
        Waypoint([0.0, 0.0], [0.58395618075, 0.045833333333], [-0.90124569484, -0.26666666667]),
        Waypoint(
            [0.057142857143, -0.01130952381], [-0.58395618075, 0.045833333333],
            [-1.4345790282, 0.26666666667],
        ),
    ]
    limits = Limits([0.642480269, 0.05042675], [1.57835254, 0.293392], 1.10022, 3.38771491)
    trajectory = plan(points, limits)
    assert 0.982 < trajectory.duration < 0.985
    assert verify(trajectory).passed


def prolonged(rng: np.random.Generator, smoothness: int, highest: int) -> bool:
    """Whether the states of a smooth motion are joined in its duration, with 10 % of slack."""
    motion = smooth_motion(rng, smoothness)
    points, limits = boundary(motion, highest, 1.0 / 1.1)
    try:
        assert verify(plan(points, limits, smoothness=smoothness, duration=1.0)).passed
    except InfeasibleError:
        return False
    return True


@pytest.mark.parametrize(
    ("smoothness", "highest", "refused"),
    [(2, 3, 0), (3, 3, 0), (3, 4, 4), (4, 4, 0), (4, 5, 0), (5, 5, 0), (5, 6, 2), (6, 6, 0)],
)
@campaign(75, 300)
def test_most_durations_of_smooth_motions(
    smoothness: int, highest: int, refused: int, count: int
) -> None:
    """`refused` of 300."""
    rng = np.random.default_rng(smoothness)
    missed = sum(not prolonged(rng, smoothness, highest) for _ in range(count))
    assert missed <= -(-refused * count // 300)


@pytest.mark.parametrize(("n", "missed"), [(4, 1), (5, 2), (6, 15)])
@campaign(3, 60)
def test_durations_are_refused_where_no_motion_lasts_them(n: int, missed: int, count: int) -> None:
    """`missed` of 60 times 4. Linear programs judge, and give the optimum as well."""
    rng = np.random.default_rng(n)
    wrong = 0
    planned = 0
    while planned < count:
        limits, state = random_problem(rng, n, "moving")
        v, a, w, b, distance = state
        points = [Waypoint(0.0, v, a), Waypoint(distance, w, b)]
        given = Limits(*map(float, limits[:n]))
        try:
            shortest = plan(points, given, smoothness=n).duration
        except InfeasibleError:
            continue
        planned += 1
        transition = Transition("", (0.0, v, a), (distance, w, b), tuple(limits[:n]))
        optimum = earliest(transition, shortest, 50, 2e-3)
        for factor in (1.06, 1.1, 1.2, 1.5):
            try:
                found = plan(points, given, smoothness=n, duration=factor * optimum)
                assert verify(found).passed
            except InfeasibleError:
                wrong += feasible(transition, factor * optimum, 50)
    assert wrong <= -(-missed * count // 60)


def test_phases_too_short_for_the_clock_are_left_out() -> None:
    """The last ramp of this plan lasted 1e-14 s; `verify` found the crackle at the end wrong."""
    rng = np.random.default_rng((77, 5, 5))
    motions = [smooth_motion(rng, 5) for _ in range(13)]
    points, limits = boundary(motions[-1], 5, 0.95)
    assert verify(plan(points, limits, smoothness=5, duration=1.0)).passed


def test_levels_too_short_for_the_clock_are_holds() -> None:
    """A level of this plan lasted 3e-9 s, after 1.6 s; the snap at its end was found wrong."""
    points = [
        Waypoint([1.4324191724870596, 0.5911205908913935], [1.115428647882691, 0.0],
                 [0.2504264596547191, 1.7594654251279378]),
        Waypoint([2.8257128345035123, 0.8516626006470869], [0.0, 0.9975663754391138],
                 [-1.4383000002117357, 1.9702366428700657]),
        Waypoint([2.1450434255657695, 2.941561488295503]),
    ]
    limits = Limits(
        [1.1323803189238821, 1.5511765262325554], [1.4383000002117357, 1.9702366428700657],
        [5.481958117517331, 7.509389387625421], [59.76100971701464, 81.86284581939998],
    )
    assert verify(plan(points, limits)).passed
