"""The rope against obstacles: dense samples of the line from trolley to load agree."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from segfmu import (
    ActuatorBounds,
    Clearance,
    Crane,
    InfeasibleError,
    InputError,
    Limits,
    Obstacle,
    Trajectory,
    Waypoint,
    plan,
    plan_actuated,
)
from segfmu.kernels.clearance.records import Ranges
from segfmu.planning.contacts import Path

LIMITS = Limits([1.0, 0.8, 0.5], [1.0, 0.8, 0.8], 4.0, 30.0)
CRANE = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
GRAVITY = 9.81
# of the positions, below which a touch is rounding
TOUCH = 1e-9


def rope_ends(
    trajectory: Trajectory, times: np.ndarray, gravity: float
) -> tuple[np.ndarray, np.ndarray]:
    """Load and trolley at times, from Newton's law for the load."""
    load = trajectory(times)
    pull = trajectory(times, 2) + np.array([0.0, 0.0, gravity])
    return load, load - load[:, 2:] * pull / pull[:, 2:]


def meets(
    trajectory: Trajectory, times: np.ndarray, box: Obstacle, gravity: float, smaller: float
) -> np.ndarray:
    """Whether the rope meets the grown box, less so much of a touch on each side, at times.

    The segment is clipped at the faces, one after the other.
    """
    load, trolley = rope_ends(trajectory, times, gravity)
    low, high = box.minimum - box.margin, box.maximum + box.margin
    touch = TOUCH * np.abs(trajectory.extrema(0)).max()
    less = smaller * np.minimum(touch, 0.25 * (high - low))
    if smaller < 1.0:
        # positions are right to a hundredth of a touch
        less = less - 0.01 * touch
    begin, end = np.zeros(times.size), np.ones(times.size)
    for axis in range(3):
        way = trolley[:, axis] - load[:, axis]
        for face, sign in ((low[axis] + less[axis], 1.0), (high[axis] - less[axis], -1.0)):
            # share * way * sign > gap
            gap = (face - load[:, axis]) * sign
            with np.errstate(all="ignore"):
                share = gap / (way * sign)
            begin = np.where(way * sign > 0.0, np.maximum(begin, share), begin)
            end = np.where(way * sign < 0.0, np.minimum(end, share), end)
            end = np.where((way == 0.0) & (gap > 0.0), -1.0, end)
    return np.asarray(begin < end)


def compare(trajectory: Trajectory, box: Obstacle, gravity: float = GRAVITY) -> bool:
    """Whether there is a contact, after a comparison with samples."""
    found = Clearance([box]).rope_contact(trajectory, box, gravity)
    assert (np.diff(found.ravel()) >= 0.0).all()
    edges = found.ravel()
    times = [np.linspace(0.0, trajectory.duration, 2001), edges - 1e-7, edges + 1e-7,
             found.mean(axis=1)]
    times = np.clip(np.sort(np.concatenate(times)), 0.0, trajectory.duration)
    ours, near = np.zeros((2, times.size), dtype=bool)
    for begin, end in found:
        ours |= (times >= begin) & (times <= end)
        near |= (np.abs(times - begin) < 1e-9) | (np.abs(times - end) < 1e-9)
    assert not (ours & ~near & ~meets(trajectory, times, box, gravity, 0.5)).any()
    assert not (~ours & ~near & meets(trajectory, times, box, gravity, 1.5)).any()
    return bool(len(found))


PLACES = st.sampled_from([-1.0, -0.5, 0.0, 0.25, 0.5, 1.0])


@st.composite
def motions(draw: st.DrawFn) -> Trajectory:
    """Plans with rest, one moving axis alone, vertical ropes, and moving waypoints."""
    points = []
    count = draw(st.integers(2, 3))
    for i in range(count):
        place = [draw(PLACES), draw(PLACES), draw(st.sampled_from([-2.0, -1.5, -1.0, -0.75]))]
        moving = 0 < i < count - 1 and draw(st.booleans())
        speed = [draw(st.sampled_from([0.0, 0.2, -0.3])) for _ in range(3)] if moving else None
        points.append(Waypoint(place, speed))
    options = {"smoothness": draw(st.sampled_from([4, 4, 5, 6])),
               "synchronize": draw(st.sampled_from(["waypoints", "none", "total"]))}
    try:
        return plan(points, LIMITS, **options)
    except InfeasibleError:
        return plan([points[0], Waypoint([0.3, 0.2, -1.0])], LIMITS)


@st.composite
def cases(draw: st.DrawFn) -> tuple[Trajectory, Obstacle]:
    """Boxes whose faces and edges touch or graze the rope, flat ones, and any."""
    trajectory = draw(motions())
    time = draw(st.floats(0.0, 1.0)) * trajectory.duration
    load, trolley = rope_ends(trajectory, np.array([time]), GRAVITY)
    share = draw(st.sampled_from([0.0, 0.1, 0.5, 0.9, 1.0]))
    place = (load + share * (trolley - load))[0]
    sizes = st.sampled_from([1e-12, 1e-7, 1e-3, 0.05, 0.3, 2.0])
    low, high = place.copy(), place.copy()
    for axis in range(3):
        kind = draw(st.sampled_from(["around", "below", "above", "near", "grid"]))
        size = draw(sizes)
        gap = draw(st.sampled_from([0.0, 1e-12, 3e-9, 1e-6, 0.01])) if kind == "near" else 0.0
        if kind == "grid":
            low[axis] = draw(PLACES) - (1.0 if axis == 2 else 0.0)
        else:
            low[axis] += {"around": -0.5 * size, "below": -size, "above": 0.0, "near": gap}[kind]
        high[axis] = low[axis] + size
    return trajectory, Obstacle("box", low, high)


@settings(max_examples=150, deadline=None)
@given(cases())
def test_contacts_are_those_of_dense_samples(case: tuple[Trajectory, Obstacle]) -> None:
    compare(*case)


def test_both_answers_are_common() -> None:
    random = np.random.default_rng(2)
    met = []
    for _ in range(60):
        points = [Waypoint(p) for p in random.uniform(-1.0, 1.0, (3, 3)) - [0.0, 0.0, 2.0]]
        trajectory = plan(points, LIMITS)
        load, trolley = rope_ends(
            trajectory, random.uniform(0.0, trajectory.duration, 1), GRAVITY
        )
        middle = (load + random.uniform() * (trolley - load))[0] + random.normal(0.0, 0.3, 3)
        half = random.uniform(0.01, 0.3, 3)
        met.append(compare(trajectory, Obstacle("box", middle - half, middle + half)))
    assert 10 < sum(met) < 50


@pytest.mark.parametrize("scale", [1.0, 60.0])
def test_a_beam_between_trolley_and_load_is_met_by_the_rope_alone(scale: float) -> None:
    pace = scale**0.5
    limits = Limits(pace, 1.0, 4.0 / pace, 30.0 / scale)
    trajectory = plan([Waypoint([0.0, 0.0, -scale]), Waypoint([scale, 0.0, -scale])], limits)
    beam = Obstacle(
        "beam", [0.4 * scale, -scale, -0.6 * scale], [0.5 * scale, scale, -0.5 * scale]
    )
    with pytest.raises(
        InfeasibleError,
        match=r"obstacle beam: the rope meets it from .* s to .* s, first at \(.*\) m, between "
        r"waypoints 1 and 2; lead the load past it at more distance, or above z = ",
    ) as info:
        Clearance([beam]).require(trajectory)
    assert info.value.limit == "beam"
    # the rope leans forwards: its upper part meets the beam first
    assert info.value.value == pytest.approx(-0.5 * scale, abs=1e-6 * scale)
    load, trolley = rope_ends(trajectory, np.array([info.value.time]), GRAVITY)
    assert (0.5 * (load + trolley))[0, 0] == pytest.approx(0.4 * scale, abs=2e-9 * scale)
    assert len(Clearance([beam]).contact(trajectory, beam)) == 0
    Clearance([Obstacle("beam", beam.minimum, beam.maximum, rope=False)]).require(trajectory)


def around(gap: float, gravity: float = GRAVITY) -> tuple[Trajectory, Obstacle]:
    """A curved path of the load, and a post inside the curve, which the leaning rope enters.

    By a gap [m] at the waypoint; a straight line down from the load would miss it.
    """
    points = [
        Waypoint([0.0, 0.0, -1.0]), Waypoint([0.5, 0.5, -1.0], [0.5, 0.0, 0.0], [0.0, -0.5, 0.0]),
        Waypoint([1.0, 0.0, -1.0]),
    ]
    trajectory = plan(points, LIMITS)
    load, trolley = rope_ends(trajectory, trajectory.waypoint_times[1:2], gravity)
    inside = (load + 0.9 * (trolley - load))[0, 1]
    assert inside < 0.5 - 0.04
    return trajectory, Obstacle("post", [0.4999, 0.3, -0.1001], [0.5001, inside + gap, -0.0999])


def test_ranges_of_load_and_rope_hold_both_and_hardly_more() -> None:
    random = np.random.default_rng(5)
    wider = []
    for i in range(60):
        points = [Waypoint(p) for p in random.uniform(-1.0, 1.0, (3, 3)) - [0.0, 0.0, 2.0]]
        synchronize = ("waypoints", "none", "total")[i % 3]
        trajectory = plan(points, LIMITS, synchronize=synchronize, smoothness=4 + i % 3)
        load, trolley = rope_ends(trajectory, np.linspace(0.0, trajectory.duration, 2001), GRAVITY)
        path = Path(trajectory, GRAVITY)
        rope = np.vstack([load, trolley])
        for row, sampled in ((Ranges.LOAD_LOW, load), (Ranges.ROPE_LOW, rope)):
            least, most = path.ranges[row : row + 2]
            low, high = sampled.min(axis=0), sampled.max(axis=0)
            assert (least <= low + 1e-12).all()
            assert (most >= high - 1e-12).all()
            wider.append(((most - least) / (high - low)).max())
    assert np.quantile(wider, 0.9) < 1.1


@pytest.mark.parametrize("gravity", [GRAVITY, 3.0])
def test_the_sway_counts(gravity: float) -> None:
    assert compare(*around(1e-3, gravity), gravity)
    assert not compare(*around(-1e-3, gravity), gravity)


def test_what_is_above_the_trolley_is_no_obstacle_to_the_rope() -> None:
    trajectory = plan([Waypoint([0.0, 0.0, -1.0]), Waypoint([1.0, 0.0, -1.0])], LIMITS)
    above = Obstacle("roof", [-1.0, -1.0, 0.0], [2.0, 1.0, 1.0])
    assert not compare(trajectory, above)
    below = Obstacle("floor", [-1.0, -1.0, -3.0], [2.0, 1.0, -1.0])
    assert not compare(trajectory, below)
    # it may touch, not enter
    Clearance([above, below]).require(trajectory)
    deeper = Obstacle("roof", [-1.0, -1.0, -1e-6], [2.0, 1.0, 1.0])
    assert compare(trajectory, deeper)
    with pytest.raises(InfeasibleError, match=r"obstacle roof: the rope .* at more distance$"):
        Clearance([deeper]).require(trajectory)


def test_a_margin_is_kept_by_the_rope() -> None:
    trajectory = plan([Waypoint([0.0, 0.0, -1.0]), Waypoint([0.0, 0.0, -2.0])], LIMITS)
    for margin, met in ((0.099, False), (0.1, False), (0.101, True)):
        post = Obstacle("post", [0.1, -1.0, -0.6], [0.2, 1.0, -0.5], margin=margin)
        assert compare(trajectory, post) == met


@pytest.mark.parametrize("part", ["load", "rope"])
def test_a_plan_of_no_time_is_checked(part: str) -> None:
    still = plan([Waypoint([0.0, 0.0, -1.0])] * 2, LIMITS)
    z = -1.0 if part == "load" else -0.5
    box = Obstacle("box", [-0.1, -0.1, z - 0.1], [0.1, 0.1, z + 0.1])
    with pytest.raises(InfeasibleError, match=f"obstacle box: the {part} meets it from 0.000 s"):
        Clearance([box]).require(still)


def test_there_is_no_rope_without_weight_and_above_the_trolley() -> None:
    fast = Limits(9.0, 30.0, 2000.0, 1e5)
    falling = plan([Waypoint([0.0, 0.0, -1.0]), Waypoint([0.0, 0.0, -4.0])], fast)
    assert falling.extrema(2)[0][2] < -GRAVITY
    box = Obstacle("box", [-0.1, -0.1, -0.6], [0.1, 0.1, -0.5])
    found = Clearance().rope_contact(falling, box)
    times = np.linspace(0.0, falling.duration, 5001)
    hangs = falling(times, 2)[:, 2] > -GRAVITY
    ours = np.zeros(times.size, dtype=bool)
    for begin, end in found:
        ours |= (times >= begin) & (times <= end)
    assert (ours == hangs).mean() > 0.999
    above = plan([Waypoint([0.0, 0.0, 1.0]), Waypoint([1.0, 0.0, 1.0])], LIMITS)
    assert len(Clearance().rope_contact(above, Obstacle("b", [-9, -9, -9], [9, 9, 9]))) == 0


def test_the_gravity_of_the_crane_counts() -> None:
    light = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0, gravity=3.0)
    trajectory, post = around(1e-3, 3.0)
    clearance = Clearance([post])
    clearance.require(trajectory)
    with pytest.raises(InfeasibleError, match="obstacle post: the rope"):
        clearance.require(trajectory, 3.0)
    points = trajectory.waypoints
    assert plan_actuated(CRANE, points, LIMITS, ActuatorBounds(), clearance=clearance).passed
    with pytest.raises(InfeasibleError, match="obstacle post: the rope"):
        plan_actuated(light, points, LIMITS, ActuatorBounds(), clearance=clearance)


@pytest.mark.parametrize("gravity", [0.0, -9.81, np.nan, "much"])
def test_gravity_is_an_acceleration(gravity) -> None:
    trajectory = plan([Waypoint([0.0, 0.0, -1.0]), Waypoint([1.0, 0.0, -1.0])], LIMITS)
    with pytest.raises(InputError, match="gravity"):
        Clearance().require(trajectory, gravity)
    with pytest.raises(InputError, match="rope must be True or False"):
        Obstacle("a", [0, 0, 0], [1, 1, 1], rope="yes")
