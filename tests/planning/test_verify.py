"""What `verify` measures on plans with known faults."""

from __future__ import annotations

from dataclasses import replace
from math import factorial

import numpy as np
import pytest

from segfmu import InfeasibleError, InputError, Limits, Trajectory, Waypoint, plan, stop, verify
from segfmu.planning.demands import require

pytestmark = pytest.mark.interpreted

LIMITS = Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5], [10.0, 5.0])
WIDE = Limits([2.0, 0.8], [2.0, 1.0], [2.0, 1.0], [20.0, 10.0])
TINY = 1e-9
ORDERS = ("velocity", "acceleration", "jerk", "snap")
POINTS = [
    Waypoint([0.0, 0.0]), Waypoint([0.07, 0.055], [0.2, 0.17], [0.34, 0.27]), Waypoint([1.0, 0.8])
]


def test_what_does_not_belong_together_is_refused() -> None:
    whole = plan(POINTS, LIMITS)
    for changes, words in (
        ({"waypoints": whole.waypoints[:1]}, "1 waypoints of 2 axes, but the times of 3 x 2"),
        ({"waypoints": (*whole.waypoints[:2], Waypoint(1.0))}, "waypoint 3 has 1"),
        ({"axis_names": ("x",)}, "2 axes, but 1 axis_names"),
        ({"synchronize": "sometimes"}, "synchronize 'sometimes'"),
    ):
        with pytest.raises(InputError, match=words):
            verify(replace(whole, **changes))


def planned(order: int) -> Trajectory:
    """A plan far within the limits that it is judged by."""
    limits = LIMITS if order > 2 else Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5])
    return replace(plan(POINTS, limits, smoothness=order), limits=WIDE)


def bent(trajectory: Trajectory, derivative: int, size: float) -> Trajectory:
    """The last piece but one of the second axis gains a power of its local time.

    So at its start one derivative jumps, and at its end the lower ones do as well.
    """
    coefficients = trajectory.coefficients.copy()
    last = coefficients.shape[0] - 1
    coefficients[last - 1, derivative] += size / factorial(derivative)
    return replace(trajectory, coefficients=coefficients)


@pytest.mark.parametrize("order", [3, 4, 5])
def test_a_sound_plan_passes(order: int) -> None:
    found = verify(planned(order))
    assert found.passed
    assert found.jumps.max() < 1e-10
    assert found.waypoint_error < 1e-11


@pytest.mark.parametrize(
    ("order", "derivative"), [(n, d) for n in (3, 4, 5) for d in range(n + 1)]
)
def test_a_jump_of_any_derivative_that_must_be_smooth_fails(order: int, derivative: int) -> None:
    sound = planned(order)
    found = verify(bent(sound, derivative, 1e-6))
    assert not found.passed
    # every limit and the waypoints are still met: the jump alone is what fails
    assert (found.usage <= 1.0).all()
    low, high = sound.extrema(derivative)
    scale = float(high[1] - low[1])
    if derivative > 0:
        bounds = WIDE.table(2, order)[1]
        peak = max(float(-low[1]), float(high[1]))
        scale = min(bounds[derivative - 1] or np.inf, peak)
    assert found.jumps[derivative, 1] == pytest.approx(1e-6 / scale, rel=1e-3)
    assert found.jumps[:, 0].max() < 1e-10
    with pytest.raises(InfeasibleError, match="jumps by"):
        require(bent(sound, derivative, 1e-6))


def test_a_missed_waypoint_fails() -> None:
    sound = planned(4)
    for name, change in (("position", 1e-6), ("velocity", 1e-6), ("acceleration", 1e-6)):
        middle = sound.waypoints[1]
        states = {n: getattr(middle, n) for n in ("position", "velocity", "acceleration")}
        states[name] = states[name] + [0.0, change]
        points = (sound.waypoints[0], Waypoint(**states), sound.waypoints[2])
        found = verify(replace(sound, waypoints=points))
        assert not found.passed
        assert found.waypoint_error >= 0.9 * change


@pytest.mark.parametrize(("derivative", "unit"), [(1, 1.0), (2, 0.5), (3, 0.25), (4, 0.125)])
def test_a_jump_within_the_rounding_of_the_limits_passes(derivative: int, unit: float) -> None:
    # a motion of one derivative only, by almost nothing; in place of an absent limit one counts
    # that lower limits imply
    limits = Limits(1.0, 0.5, 0.25) if derivative == 4 else Limits(1.0, 0.5, None, 8.0)
    still = stop(Waypoint(0.0), limits=limits)
    timing = np.array([[0.0, 1e-12], [1e-12, 1e-12]])
    for size, passed in ((0.9e-14, True), (1.1e-14, False)):
        coefficients = np.zeros((2, still.coefficients.shape[1]))
        coefficients[0, derivative] = size * unit / factorial(derivative)
        start = [0.0] * derivative + [size * unit]
        tried = replace(
            still, timing=timing, coefficients=coefficients, offsets=np.array([0, 2]),
            waypoints=(Waypoint(*start), Waypoint(0.0)),
            axis_waypoint_times=np.array([[0.0], [2e-12]]), axis_durations=np.array([2e-12]),
        )
        assert verify(tried).passed == passed


@pytest.mark.parametrize("derivative", [1, 2, 3, 4])
def test_a_limit_that_is_passed_between_the_switches_fails(derivative: int) -> None:
    sound = plan(POINTS, LIMITS)
    names = ("velocity", "acceleration", "jerk", "snap")
    low, high = sound.extrema(derivative)
    peak = np.maximum(-low, high)
    bounds = {n: getattr(WIDE, n) for n in names}
    bounds[names[derivative - 1]] = peak * [1.0, 1.0 - 1e-6]
    found = verify(replace(sound, limits=Limits(**bounds)))
    assert not found.passed
    assert np.argwhere(found.usage > 1.0 + 1e-9).tolist() == [[derivative - 1, 1]]


@pytest.mark.parametrize("end", [0, 2])
def test_a_missed_end_fails(end: int) -> None:
    sound = planned(4)
    points = list(sound.waypoints)
    points[end] = Waypoint(np.add(points[end].position, [0.0, 1e-6]))
    found = verify(replace(sound, waypoints=tuple(points)))
    assert not found.passed
    assert found.waypoint_error == pytest.approx(1e-6 / 0.8, rel=1e-3)


def delayed(trajectory: Trajectory, by: float, axis: int = 1, first: int = 0) -> Trajectory:
    """The pieces of an axis from `first` on start later; its times do not tell."""
    timing = trajectory.timing.copy()
    timing[trajectory.offsets[axis] + first : trajectory.offsets[axis + 1], 0] += by
    return replace(trajectory, timing=timing)


def late(trajectory: Trajectory) -> Trajectory:
    """The second axis waits for 1 s at the start; its pieces and its own times are sound."""
    timing, arrivals = trajectory.timing.copy(), trajectory.axis_waypoint_times.copy()
    row = trajectory.offsets[1]
    timing[row:, 0] += 1.0
    arrivals[1:, 1] += 1.0
    waiting = np.zeros(trajectory.coefficients.shape[1])
    return replace(
        trajectory, axis_waypoint_times=arrivals,
        timing=np.insert(timing, row, [0.0, 1.0], axis=0),
        coefficients=np.insert(trajectory.coefficients, row, waiting, axis=0),
        offsets=np.add(trajectory.offsets, [0, 0, 1]),
        axis_durations=np.add(trajectory.axis_durations, [0.0, 1.0]),
    )


def longer(trajectory: Trajectory, row: int, by: float) -> Trajectory:
    """A piece lasts longer than until the next one starts."""
    timing = trajectory.timing.copy()
    timing[row, 1] += by
    return replace(trajectory, timing=timing)


def moved(trajectory: Trajectory, share: float) -> Trajectory:
    """From the middle on, the second axis is elsewhere, by a share of its way."""
    coefficients = trajectory.coefficients.copy()
    row = (trajectory.offsets[1] + trajectory.offsets[2]) // 2
    way = trajectory.waypoints[-1].position[1] - trajectory.waypoints[0].position[1]
    coefficients[row:, 0] += share * way
    points = (*trajectory.waypoints[:-1], Waypoint(trajectory.waypoints[-1].position
                                                   + np.array([0.0, share * way])))
    return replace(trajectory, coefficients=coefficients, waypoints=points)


def dwelling() -> Trajectory:
    """A plan that rests for 1 s at its middle waypoint."""
    points = [POINTS[0], Waypoint([0.07, 0.055], dwell=1.0), POINTS[2]]
    return plan(points, LIMITS)


def without_dwell(trajectory: Trajectory) -> Trajectory:
    """The dwell's piece is gone and all that follows comes earlier."""
    starts = [trajectory.pieces(axis)[0] for axis in range(2)]
    leaving = trajectory.axis_waypoint_times[1] + 1.0
    rows = [
        int(trajectory.offsets[axis]) + int(np.searchsorted(starts[axis], leaving[axis] - 0.5)) - 1
        for axis in range(2)
    ]
    timing = trajectory.timing.copy()
    timing[timing[:, 0] > 0.5 + leaving[0] - 1.0, 0] -= 1.0
    return replace(
        trajectory, timing=np.delete(timing, rows, axis=0),
        coefficients=np.delete(trajectory.coefficients, rows, axis=0),
        offsets=trajectory.offsets - [0, 1, 2],
        axis_waypoint_times=trajectory.axis_waypoint_times - [[0.0], [0.0], [1.0]],
        axis_durations=trajectory.axis_durations - 1.0,
    )


def restless(trajectory: Trajectory) -> Trajectory:
    """During the dwell an axis goes away by 1 mm and comes back, smoothly."""
    row = int(np.argmax((np.abs(trajectory.timing[:, 1] - 1.0) < 1e-9)
                        & (trajectory.coefficients[:, 1:] == 0.0).all(axis=1)))
    coefficients = np.zeros((len(trajectory.coefficients), 13))
    coefficients[:, :8] = trajectory.coefficients
    out_and_back = np.polynomial.polynomial.polypow([0.0, 1.0, -1.0], 6)
    coefficients[row] += 1e-3 * 4.0**6 * out_and_back
    return replace(trajectory, coefficients=coefficients)


def shrunk() -> Trajectory:
    """A plan over a nanometre."""
    return plan([Waypoint(p.position * TINY) for p in POINTS[::2]], LIMITS)


TAMPERED = {
    "gap of 1 ms": lambda: delayed(planned(4), 1e-3, first=3),
    "gap of 1 s": lambda: delayed(planned(4), 1.0, first=3),
    "overlap of 1 ms": lambda: delayed(planned(4), -1e-3, first=3),
    "overlap of 1 s": lambda: delayed(planned(4), -1.0, first=3),
    "gap of 1 ns": lambda: delayed(planned(4), 1e-9, first=3),
    "axis delayed by 1 s": lambda: delayed(planned(4), 1.0),
    "axis that waits for 1 s": lambda: late(planned(4)),
    "piece too long": lambda: longer(planned(4), 2, 1e-3),
    "last piece too long": lambda: longer(dwelling(), -1, 1e-3),
    "wrong end": lambda: replace(
        planned(4), axis_durations=np.add(planned(4).axis_durations, [0.0, 0.1])
    ),
    "end is NaN": lambda: replace(planned(4), axis_durations=np.array([np.nan, np.nan])),
    "end of one axis is NaN": lambda: replace(
        planned(4), axis_durations=planned(4).axis_durations * [1.0, np.nan]
    ),
    "start is NaN": lambda: delayed(planned(4), np.nan),
    "start of a piece is NaN": lambda: replace(
        planned(4), timing=np.where(np.arange(len(planned(4).timing))[:, None] == 4,
                                    [np.nan, 0.1], planned(4).timing)
    ),
    "wrong arrival": lambda: replace(
        planned(4), axis_waypoint_times=np.add(
            planned(4).axis_waypoint_times, [[0.0, 0.0], [0.0, 0.01], [0.0, 0.0]])
    ),
    "wrong arrival of all axes": lambda: replace(
        planned(4), axis_waypoint_times=np.add(
            planned(4).axis_waypoint_times, [[0.0, 0.0], [1e-6, 1e-6], [0.0, 0.0]])
    ),
    "arrival a dwell too soon": lambda: replace(
        dwelling(), axis_waypoint_times=np.add(
            dwelling().axis_waypoint_times, [[0.0, 0.0], [-1e-6, -1e-6], [0.0, 0.0]])
    ),
    "dwell left early": lambda: replace(
        dwelling(), waypoints=(dwelling().waypoints[0], Waypoint([0.07, 0.055], dwell=1.0 + 1e-6),
                               dwelling().waypoints[2])
    ),
    "dwell at the end that is missing": lambda: replace(
        planned(4), waypoints=(*planned(4).waypoints[:2], Waypoint([1.0, 0.8], dwell=0.5))
    ),
    "rest at the end that is too long": lambda: replace(
        plan([*POINTS[:2], Waypoint([1.0, 0.8], dwell=0.5)], LIMITS), waypoints=tuple(POINTS)
    ),
    "late start in the times": lambda: replace(
        planned(4), axis_waypoint_times=np.add(
            planned(4).axis_waypoint_times, [[1.0], [0.0], [0.0]])
    ),
    "missing dwell": lambda: without_dwell(dwelling()),
    "moves in its dwell": lambda: restless(dwelling()),
    "jump of the whole way, 1 nm": lambda: moved(shrunk(), 1.0),
    "jump of a millionth of 1 nm": lambda: moved(shrunk(), 1e-6),
    "jump of a millionth": lambda: moved(planned(4), 1e-6),
    "end missed by the whole way, 1 nm": lambda: replace(
        shrunk(), waypoints=(shrunk().waypoints[0], Waypoint([TINY, 0.0]))
    ),
}


@pytest.mark.parametrize(("change", "words"), [
    (lambda p: {"axis_durations": p.axis_durations[:1]}, "axis_durations must have the shape"),
    (lambda p: {"waypoints": (), "axis_waypoint_times": p.axis_waypoint_times[:0]}, "0 waypoints"),
    (lambda p: {"offsets": np.array([0, 0, p.offsets[-1]])}, "offsets that ascend from 0"),
    (lambda p: {"offsets": np.add(p.offsets, [0, 0, 5])}, "timing must have the shape"),
    (lambda p: {"timing": p.timing[:-1]}, "timing must have the shape"),
    (lambda p: {"coefficients": p.coefficients[:-1]}, "coefficients must have the shape"),
])
def test_arrays_that_do_not_belong_together(change, words: str) -> None:
    with pytest.raises(InputError, match=words):
        verify(replace(planned(4), **change(planned(4))))


@pytest.mark.parametrize("name", TAMPERED)
def test_a_tampered_plan_fails(name: str) -> None:
    tampered = TAMPERED[name]()
    assert not verify(tampered).passed
    with pytest.raises(InfeasibleError, match=r"^(axis [xy], waypoint.*|times err) ") as caught:
        require(tampered)
    # the place, or a fault of the times of all axes
    error = caught.value
    assert (error.axis is None) == (error.interval is None) == str(error).startswith("times")


@pytest.mark.parametrize("synchronize", ["waypoints", "none"])
@pytest.mark.parametrize("name", ORDERS)
def test_a_broken_limit_is_named_with_its_place(name: str, synchronize: str) -> None:
    points = [Waypoint([0.0, 0.0]), Waypoint([0.1, 0.1]), Waypoint([-2.0, 1.0])]
    sound = plan(points, LIMITS, synchronize=synchronize)
    order = 1 + ORDERS.index(name)
    peak = verify(sound).peaks[order - 1, 1]
    tight = {n: getattr(LIMITS, n) for n in ORDERS} | {name: [10.0, 0.9 * peak]}
    words = rf"^axis y, waypoints \d -> \d: .*{name}"
    with pytest.raises(InfeasibleError, match=words) as caught:
        require(replace(sound, limits=Limits(**tight)))
    error = caught.value
    assert (error.axis, error.limit, error.value, error.bound) == (1, name, peak, 0.9 * peak)
    assert f"at {error.time:.3f} s" in str(error)
    sides = np.array([error.time - 1e-9, error.time + 1e-9])
    assert np.abs(sound(sides, order)[:, 1]).max() == pytest.approx(error.value, rel=1e-6)
    arrivals = sound.axis_waypoint_times[:, 1]
    assert arrivals[error.interval - 1] <= error.time <= arrivals[error.interval]


def test_a_missed_waypoint_is_named() -> None:
    sound = planned(4)
    wrong = Waypoint([0.07, 0.055001], [0.2, 0.17], [0.34, 0.27])
    for point, points in ((2, (POINTS[0], wrong, POINTS[2])), (3, (*POINTS[:2], Waypoint([1, 1])))):
        words = rf"^axis y, waypoint {point}: the plan misses"
        with pytest.raises(InfeasibleError, match=words) as caught:
            require(replace(sound, waypoints=points))
        assert (caught.value.axis, caught.value.interval) == (1, point - 1)
        assert caught.value.time == sound.axis_waypoint_times[point - 1, 1]


@pytest.mark.parametrize("size", [1e-9, 1e-3, 1.0, 1e6])
@pytest.mark.parametrize("synchronize", ["waypoints", "total", "none"])
def test_a_sound_plan_of_any_size_passes(size: float, synchronize: str) -> None:
    points = [
        Waypoint(3.0 * size + size * p.position, size * p.velocity, size * p.acceleration)
        for p in POINTS
    ]
    limits = Limits(*(size * np.array([[1.0, 0.4], [1.0, 0.5], [1.0, 0.5], [10.0, 5.0]])))
    assert verify(plan(points, limits, synchronize=synchronize)).passed
    assert verify(dwelling()).passed
    assert verify(shrunk()).passed
