"""Obstacles, workspace and excursions: dense samples of the path agree."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from segfmu import (
    Clearance,
    InfeasibleError,
    InputError,
    Limits,
    Obstacle,
    Waypoint,
    excursions,
    plan,
)
from segfmu.kernels.clearance import path, ranges
from segfmu.kernels.clearance.records import Box, Part
from segfmu.planning import contacts
from tests.campaign import soaked

LIMITS = Limits([1.0, 0.8, 0.5], [1.0, 0.8, 0.8], [4.0, 4.0, 4.0], [30.0, 30.0, 30.0])
STACK = Obstacle("stack", [0.4, -0.2, -2.0], [0.6, 0.2, -0.9], margin=0.05)
OVER = [
    Waypoint([0.0, 0.0, -1.5]), Waypoint([0.2, 0.0, -0.7]), Waypoint([0.8, 0.0, -0.7]),
    Waypoint([1.0, 0.0, -1.5]),
]


def sampled_contact(trajectory, clearance, obstacle, samples=400_001):
    """Times of contact by samples: the load's box, grown by the margin, meets the obstacle."""
    times = np.linspace(0.0, trajectory.duration, samples)
    centre = trajectory(times) + clearance.load_centre
    half = 0.5 * clearance.load_size + obstacle.margin
    low, high = centre - half, centre + half
    met = ((high > obstacle.minimum) & (low < obstacle.maximum)).all(axis=1)
    return times, met


def test_a_path_over_a_stack_is_clear_and_one_through_it_is_named() -> None:
    clearance = Clearance([STACK], load_size=[0.1, 0.1, 0.2])
    clearance.require(plan(OVER, LIMITS))
    trajectory = plan([OVER[0], OVER[-1]], LIMITS)
    with pytest.raises(
        InfeasibleError,
        match=r"obstacle stack: the load meets it from .* s to .* s, first at \(0.3, 0, -1.5\) m, "
        r"between waypoints 1 and 2; lead it past, or above z = -0.75 m",
    ) as info:
        clearance.require(trajectory)
    assert info.value.limit == "stack"
    assert trajectory(info.value.time)[0] == pytest.approx(0.4 - 0.05 - 0.05, abs=1e-8)


@pytest.mark.parametrize("seed", [*range(3), *soaked(*range(3, 8))])
def test_contacts_are_those_of_dense_samples(seed) -> None:
    random = np.random.default_rng(seed)
    points = [Waypoint(p) for p in random.uniform(-1.0, 1.0, (4, 3)) - [0.0, 0.0, 2.0]]
    points[1] = Waypoint(points[1].position, random.uniform(-0.3, 0.3, 3))
    synchronize = ("waypoints", "total", "none")[seed % 3]
    trajectory = plan(points, LIMITS, synchronize=synchronize)
    met = 0
    for _ in range(12):
        middle = trajectory(random.uniform(0.0, trajectory.duration)) + random.normal(0, 0.2, 3)
        half = random.uniform(0.02, 0.4, 3)
        box = Obstacle("box", middle - half, middle + half, margin=random.uniform(0.0, 0.1))
        clearance = Clearance(
            [box], load_size=random.uniform(0.0, 0.2, 3), load_centre=random.normal(0.0, 0.1, 3)
        )
        found = clearance.contact(trajectory, box)
        times, truth = sampled_contact(trajectory, clearance, box)
        ours = np.zeros(times.size, dtype=bool)
        for begin, end in found:
            ours |= (times >= begin) & (times <= end)
        wrong = times[ours != truth]
        # samples next to an end of an interval may fall on either side of it by rounding
        edges = np.append(found.ravel(), np.inf)
        assert all(np.abs(edges - t).min() < 1e-6 for t in wrong)
        met += found.shape[0] > 0
    assert met > 2


def test_a_load_may_touch_but_not_enter() -> None:
    # the load's lower edge slides along the top
    top = Obstacle("deck", [-1.0, -1.0, -3.0], [2.0, 1.0, -1.6], margin=0.1)
    trajectory = plan([Waypoint([0.0, 0.0, -1.4]), Waypoint([1.0, 0.0, -1.4])], LIMITS)
    Clearance([top], load_size=[0.0, 0.0, 0.2]).require(trajectory)
    with pytest.raises(InfeasibleError, match=r"obstacle deck.*from 0.000 s"):
        Clearance([top], load_size=[0.0, 0.0, 0.2001]).require(trajectory)


def test_a_short_contact_between_samples_is_found() -> None:
    # the path reaches 1 m only at one moment, the needle 1e-7 m less
    points = [Waypoint([0.0, 0.0, -1.0]), Waypoint([1.0, 0.0, -1.0]), Waypoint([0.0, 0.0, -1.0])]
    needle = Obstacle("needle", [1.0 - 1e-7, -1.0, -2.0], [2.0, 1.0, 0.0])
    with pytest.raises(InfeasibleError, match="obstacle needle"):
        Clearance([needle]).require(plan(points, LIMITS))
    beside = Obstacle("needle", [1.0 + 1e-7, -1.0, -2.0], [2.0, 1.0, 0.0])
    Clearance([beside]).require(plan(points, LIMITS))


def test_an_obstacle_around_a_dwell_is_met_all_the_time() -> None:
    points = [
        Waypoint([0.0, 0.0, -1.0]), Waypoint([1.0, 0.0, -1.0], dwell=2.0),
        Waypoint([2.0, 0.0, -1.0]),
    ]
    trajectory = plan(points, LIMITS)
    box = Obstacle("box", [0.9, -1.0, -2.0], [1.1, 1.0, 0.0])
    found = Clearance([box]).contact(trajectory, box)
    assert found.shape == (1, 2)
    assert found[0, 1] - found[0, 0] > 2.0


def test_the_first_of_many_obstacles_is_named() -> None:
    trajectory = plan([OVER[0], OVER[-1]], LIMITS)
    far = Obstacle("far", [0.8, -1.0, -2.0], [0.9, 1.0, -1.0])
    near = Obstacle("near", [0.1, -1.0, -2.0], [0.2, 1.0, -1.0])
    with pytest.raises(InfeasibleError, match="obstacle near"):
        Clearance([far, near]).require(trajectory)


def test_the_workspace_is_kept_by_each_axis() -> None:
    points = [OVER[0], Waypoint([0.9, 0.0, -1.0], [0.5, 0.0, 0.0]), Waypoint([0.0, 0.0, -1.5])]
    trajectory = plan(points, LIMITS)
    Clearance(minimum=[0.0, None, -1.5], maximum=[1.2, np.inf, None]).require(trajectory)
    with pytest.raises(
        InfeasibleError,
        match=r"workspace: axis x leaves its range 0 to 0.95 m at .* waypoints 2 and 3",
    ) as info:
        Clearance(minimum=[0.0, -1.0, -2.0], maximum=[0.95, 1.0, 0.0]).require(trajectory)
    assert trajectory(info.value.time)[0] == pytest.approx(0.95, abs=1e-8)


def test_a_plan_that_lasts_no_time_keeps_the_workspace_too() -> None:
    still = plan([Waypoint([0.0, 0.0, -0.5])] * 2, Limits(1.0, 1.0, 4.0, 20.0))
    Clearance(minimum=[0.0, -1.0, -1.0]).require(still)
    with pytest.raises(InfeasibleError, match="axis x leaves its range"):
        Clearance(minimum=[0.1, -1.0, -1.0]).require(still)


def test_excursions_are_those_of_samples() -> None:
    points = [OVER[0], Waypoint([0.9, 0.0, -1.0], [0.5, 0.0, 0.0]), Waypoint([0.0, 0.0, -1.5])]
    trajectory = plan(points, LIMITS)
    found = excursions(trajectory)
    assert [(e.interval, e.axis) for e in found] == [(2, 0)]
    times = np.linspace(0.0, trajectory.duration, 100_001)
    path = trajectory(times)[:, 0]
    assert found[0].distance == pytest.approx(path.max() - 0.9, rel=1e-6)
    # the path leaves the box at the waypoint itself
    assert found[0].time == pytest.approx(trajectory.waypoint_times[1], abs=1e-3)
    assert str(found[0]).startswith("between waypoints 2 and 3 the path leaves the box of both by")
    assert excursions(plan(OVER, LIMITS)) == ()


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: Obstacle("a", [0, 0, 0], [1, 0, 1]), "obstacle a: minimum y 0.0 m is not below"),
        (lambda: Obstacle("a", [0, 0], [1, 1, 1]), "obstacle a: minimum must have 3 values"),
        (lambda: Obstacle("a", [0, 0, 0], [1, 1, 1], -1.0), "obstacle a: margin must be"),
        (lambda: Obstacle(None, [0, 0, 0], [1, 1, 1]), "name of an obstacle must be a text, got"),
        (lambda: Clearance(["a"]), "an obstacle must be an Obstacle, got str"),
        (lambda: Clearance(load_size=[1, 1, -1]), "load_size must be >= 0 m"),
        (lambda: Clearance(minimum=[2, 0, 0], maximum=[1, 1, 1]), "workspace: minimum x 2.0 m"),
    ],
)
def test_wrong_boxes_are_refused(make, text) -> None:
    with pytest.raises(InputError, match=text):
        make()


def test_clearance_needs_three_axes() -> None:
    trajectory = plan([Waypoint([0.0]), Waypoint([1.0])], Limits(1.0, 1.0, 1.0))
    with pytest.raises(InputError, match="clearance needs axes x, y, z; got 1 axes"):
        Clearance([STACK]).require(trajectory)


@pytest.mark.parametrize(("trajectory", "obstacle", "words"), [
    (None, STACK, "trajectory must be a plan, got NoneType"),
    (plan(OVER, LIMITS), None, "an obstacle must be an Obstacle, got NoneType"),
])
def test_contact_is_one_of_a_plan_and_an_obstacle(trajectory, obstacle, words: str) -> None:
    with pytest.raises(InputError, match=words):
        Clearance().contact(trajectory, obstacle)


def test_boxes_beyond_the_path_are_passed_over(monkeypatch: pytest.MonkeyPatch) -> None:
    # the interpreted kernels, so that their calls can be counted
    spans, looked = [], []

    def begin_span(*args):
        spans.append(args[0])
        kept[0](*args)

    def span_contacts(part, found, box, *args):
        looked.append((part, *box[Box.ROPE_LOW : Box.ROPE_LOW + 3]))
        return kept[1](part, found, box, *args)

    kept = path.begin_span, path.span_contacts
    interpreted = SimpleNamespace(first_contact=path.first_contact, path_ranges=ranges.path_ranges)
    monkeypatch.setattr(contacts, "backend", interpreted)
    monkeypatch.setattr(path, "begin_span", begin_span)
    monkeypatch.setattr(path, "span_contacts", span_contacts)
    trajectory = plan(OVER, LIMITS)
    far = [Obstacle(f"{i}", [1.5 + i, -1.0, -2.0], [2.0 + i, 1.0, -0.1]) for i in range(100)]
    # beside the load as beside the rope
    near = Obstacle("below", [0.0, -0.1, -2.0], [1.0, 0.1, -1.6])
    over = Obstacle("through", [0.3, 0.05, -0.6], [0.5, 0.2, -0.5])
    Clearance([*far, near, over]).require(trajectory)
    assert spans == looked == []
    Clearance([*far, STACK]).require(trajectory)
    corner = pytest.approx(STACK.minimum - STACK.margin)
    parts = [part for part, *_ in looked]
    assert all(low == corner for _, *low in looked)
    # load and rope are beside the stack, then above it: no span of the rope needs a closer look
    assert parts == [Part.LOAD] * (len(spans) // 2)
