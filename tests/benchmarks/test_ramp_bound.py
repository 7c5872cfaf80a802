"""Lower bounds on durations with ramps and holds, against profiles integrated on their own."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from benchmarks import ramp_shapes
from benchmarks.optimal_control import Transition
from benchmarks.ramp_bound import RampBound, leads
from benchmarks.ramp_limits import measure
from benchmarks.ramp_shapes import Ramps, ScaledTransition, Smoothstep, SymmetricRamps, scaled
from benchmarks.report import Settings
from numpy.typing import NDArray
from scipy.integrate import quad

from segfmu import Limits, Waypoint, plan

REFERENCE = Path(__file__).parents[1] / "data" / "planner-problems.json"
PER_CELL = 48
Shape = Callable[[np.ndarray], np.ndarray]


def curved(x: NDArray[np.float64]) -> NDArray[np.float64]:
    return x**3 * (10.0 - 15.0 * x + 6.0 * x**2)


@dataclass(frozen=True, eq=False)
class Profile:
    """A sequence of ramps and holds sampled at Gauss points of fine cells, and its integrals.

    Rows of `states` and `straight`: position, velocity, acceleration at `times`, the straight ones
    from ramps replaced by lines.
    """

    durations: NDArray[np.float64]
    changes: NDArray[np.float64]
    times: NDArray[np.float64]
    states: NDArray[np.float64]
    straight: NDArray[np.float64]

    def transition(self, reserve: float) -> Transition:
        """The boundary problem of the profile at limits that it keeps with a reserve."""
        ramps = self.durations > 0.0
        height, time = np.abs(self.changes[ramps]), self.durations[ramps]
        limits = (
            np.abs(self.states[1]).max(), np.abs(self.states[2]).max(),
            (1.875 * height / time).max(), (10.0 / np.sqrt(3.0) * height / time**2).max(),
        )
        ends = [(s[0], s[1], s[2]) for s in (self.states[:, 0], self.states[:, -1])]
        a, b, c, d = (reserve * float(limit) for limit in limits)
        return Transition("random", *ends, (a, b, c, d))

    @property
    def duration(self) -> float:
        return float(self.times[-1])


def integrated(t: NDArray[np.float64], rate: NDArray[np.float64], first: float) -> np.ndarray:
    """Integral at the cell ends of a rate given at three Gauss points per cell."""
    weights = np.array([5.0, 8.0, 5.0]) / 18.0
    return np.concatenate([[first], first + np.cumsum((rate @ weights) * np.diff(t))])


def random_profile(random: np.random.Generator) -> Profile:
    count = int(random.integers(2, 8))
    durations = random.uniform(0.05, 1.0, count) ** 2
    changes = random.uniform(-1.0, 1.0, count) * (random.random(count) < 0.7)
    changes[0] = changes[0] or 0.5
    level, velocity = random.uniform(-0.6, 0.6, 2)
    times, rates, lines, ends, end_lines = [np.zeros(1)], [], [], [], []
    points = 0.5 + np.sqrt(0.15) * np.array([-1.0, 0.0, 1.0])
    cells = (np.arange(PER_CELL)[:, None] + points) / PER_CELL
    shares = np.arange(1, PER_CELL + 1) / PER_CELL
    for duration, change in zip(durations, changes, strict=True):
        times.append(times[-1][-1] + duration * shares)
        rates.append(level + change * curved(cells))
        lines.append(level + change * cells)
        ends.append(level + change * curved(shares))
        end_lines.append(level + change * shares)
        level += change
    t = np.concatenate(times)
    found = []
    for gauss, nodes in ((rates, ends), (lines, end_lines)):
        first = nodes[0][0] - (changes[0] * (curved(shares) if nodes is ends else shares))[0]
        a = np.concatenate([[first], *nodes])
        v = integrated(t, np.concatenate(gauss), velocity)
        # Simpson's rule: the velocity in the middle of a cell by Hermite interpolation
        h = np.diff(t)
        middle = 0.5 * (v[1:] + v[:-1]) + h * (a[:-1] - a[1:]) / 8.0
        y = np.concatenate([[0.0], np.cumsum(h * (v[:-1] + 4.0 * middle + v[1:]) / 6.0)])
        found.append(np.array([y, v, a]))
    return Profile(durations, changes, t, found[0], found[1])


def test_constants_by_quadrature() -> None:
    lead, _ = quad(lambda x: x - curved(x), 0.0, 1.0)
    assert lead == pytest.approx(0.0, abs=1e-14)
    ahead, _ = quad(lambda x: (1.0 - x) * (x - curved(x)), 0.0, 1.0)
    assert pytest.approx(ahead, abs=1e-14) == ramp_shapes.AHEAD == pytest.approx(1.0 / 42.0)
    x = np.linspace(0.0, 1.0, 100_001)
    assert np.gradient(curved(x), x).max() == pytest.approx(ramp_shapes.SLOPE, rel=1e-6)
    bend = np.abs(np.gradient(np.gradient(curved(x), x), x)).max()
    assert bend == pytest.approx(ramp_shapes.CURVATURE, rel=1e-4)
    assert (ramp_shapes.LEAD(x) >= -1e-15).all()


def test_the_lead_of_a_straight_ramp_bends_no_more_than_stated() -> None:
    start, check = np.meshgrid(np.linspace(0.0, 0.9, 181), np.linspace(0.0, 1.0, 201))
    step = 1e-4
    for move in ((step, 0.0), (0.0, step)):
        values = [leads(Smoothstep(), start + k * move[0], 1.0 + k * move[1] + 0.0 * start, check)
                  for k in (-1, 0, 1)]
        second = np.abs(values[0] - 2.0 * values[1] + values[2]) / step**2
        assert second.max() < ramp_shapes.LEAD_CURVATURE


def weighted_sum(
    profile: Profile, problem: ScaledTransition, weights: np.ndarray, checks: np.ndarray,
) -> float:
    """What `RampBound.certified` bounds from above, from the integrated profile, at its end."""
    p, t = problem, profile.times / profile.duration
    v0, a0 = profile.states[1, 0], profile.states[2, 0]
    a_unit = p.a / a0
    v_unit = a_unit / profile.duration
    y_unit = v_unit / profile.duration
    y, v, a = (profile.states[i, -1] for i in range(3))
    scaled_v, lines = v_unit * profile.states[1], v_unit * profile.straight[1]
    assert v0 * v_unit == pytest.approx(p.v)
    upper = np.interp(checks, t, np.maximum(scaled_v, lines))
    lower = np.interp(checks, t, np.minimum(scaled_v, lines))
    held = a_unit * np.interp(checks, t, profile.straight[2])
    misses = [a_unit * a - p.b, v_unit * v - p.w, y_unit * y - p.distance]
    slack = [p.acceleration - held, p.acceleration + held, p.velocity - upper, p.velocity + lower]
    return float(np.concatenate([misses, *slack]) @ weights)


@pytest.mark.parametrize("seed", range(20))
def test_no_weighted_sum_of_a_profile_passes_its_bound(seed: int) -> None:
    random = np.random.default_rng(seed)
    profile = random_profile(random)
    # another boundary: the bound is on the sum, whatever the end is
    transition = random_profile(random).transition(3.0)
    own = profile.transition(1.0)
    limits = np.maximum(transition.limits, own.limits)
    mixed = Transition("mixed", own.start, transition.end, tuple(limits))  # type: ignore[arg-type]
    problem = scaled(mixed, profile.duration)
    ramps = RampBound(Smoothstep(), 12, 10)
    checks = np.arange(1, 12) / 12.0
    weights = random.uniform(0.0, 1.0, 3 + 4 * checks.size) ** 4
    weights[:3] = random.uniform(-1.0, 1.0, 3)
    weights[3:] *= random.random(weights.size - 3) < 0.2
    # linear interpolation of the sampled velocity is off by less than this
    sampled = 1e-3 * max(problem.acceleration, problem.velocity)
    found = weighted_sum(profile, problem, weights, checks)
    assert found <= ramps.certified(problem, weights, 0.0) + sampled


def trapezoid(x: np.ndarray, slope: np.ndarray, span: np.ndarray, snap: float) -> np.ndarray:
    """Acceleration, per height, of the trapezoid of jerk with the snap limit on its flanks."""
    rise = 0.5 - np.sqrt(np.maximum(0.25 - slope / (snap * span), 0.0))
    early = np.minimum(x, 1.0 - x)
    flank = early**2 / (2.0 * rise * (1.0 - rise))
    low = np.where(early < rise, flank, (early - rise / 2.0) / (1.0 - rise))
    return np.where(x < 0.5, low, 1.0 - low)


def ramp_sums(
    times: np.ndarray, first: np.ndarray, last: np.ndarray, shape: Shape, weights: np.ndarray,
    checks: np.ndarray,
) -> np.ndarray:
    """What ramps of slope 1 or -1 add to the sum, the larger, by the trapezoidal rule.

    The duration of the profile is 1.
    """
    t = np.linspace(0.0, 1.0, 3001)
    start, span = times[first, None], (times[last] - times[first])[:, None]
    shares = np.clip((t - start) / span, 0.0, 1.0)
    sums, lines = [], []
    for values in (shape(shares), shares):
        a = span * values
        v = np.hstack([np.zeros_like(start), np.cumsum(0.5 * (a[:, 1:] + a[:, :-1]), 1) * t[1]])
        lines.append(v)
        sums.append((a, v, (v.sum(1) - 0.5 * v[:, -1]) * t[1]))
    at = np.round(checks * 3000).astype(int)
    (a, v, y), held = sums[0], sums[1][0][:, at]
    ends = np.column_stack([a[:, -1], v[:, -1], y]) @ weights[:3]
    most, least = (f(*lines)[:, at] for f in (np.maximum, np.minimum))
    high, low, fast, back = weights[3:].reshape(4, -1)
    up = ends + held @ (low - high) - most @ fast + least @ back
    down = -ends - held @ (low - high) + least @ fast - most @ back
    return np.maximum(up, down)


@pytest.mark.parametrize("ramps", [Smoothstep(), SymmetricRamps()], ids=["smoothstep", "symmetric"])
@pytest.mark.parametrize("seed", range(6))
def test_the_gain_bounds_the_best_ramps_between_arbitrary_times_and_is_close(
    seed: int, ramps: Ramps
) -> None:
    random = np.random.default_rng(seed)
    checks = np.arange(1, 12) / 12.0
    weights = random.uniform(0.0, 0.5, 3 + 4 * checks.size)
    weights[:3] = random.uniform(-1.0, 1.0, 3)
    weights[3:] *= random.random(weights.size - 3) < 0.1 * (seed % 3)
    jerk, snap, acceleration = 1.0, random.choice([1.0, 5.0, 40.0]), random.choice([0.1, 1.0])
    problem = ScaledTransition(0.0, 0.0, 0.0, 0.0, 0.0, 1.0, acceleration, jerk, snap)
    times = np.concatenate([[0.0], np.sort(random.random(50)), [1.0]])
    first, last = np.triu_indices(times.size, 1)
    span = times[last] - times[first]
    slopes = np.minimum(np.minimum(jerk / 1.875, snap * span / 10.0 * np.sqrt(3.0)),
                        2.0 * acceleration / span)
    values = slopes * ramp_sums(times, first, last, curved, weights, checks)
    if isinstance(ramps, SymmetricRamps):
        rise = np.minimum(jerk / snap, span / 2.0)
        steepest = np.minimum(snap * rise * (span - rise) / span, 2.0 * acceleration / span)
        for share in (0.5, 1.0):
            slopes = share * steepest
            shape = partial(trapezoid, slope=slopes[:, None], span=span[:, None], snap=snap)
            more = slopes * ramp_sums(times, first, last, shape, weights, checks)
            values = np.maximum(values, more)
    added = np.zeros((times.size, times.size))
    added[first, last] = np.maximum(values, 0.0)
    best = np.zeros(times.size)
    for k in range(1, times.size):
        best[k] = (best[:k] + added[:k, k]).max()
    found = RampBound(ramps, 12, 40).gain(problem, weights)
    assert best[-1] <= found * (1.0 + 1e-5)
    assert found <= 1.1 * best[-1] + 1e-3


@pytest.mark.parametrize("seed", range(20))
def test_the_duration_of_a_profile_at_its_limits_is_not_excluded(seed: int) -> None:
    random = np.random.default_rng(100 + seed)
    ramps = RampBound(Smoothstep(), 16, 10)
    profile = random_profile(random)
    transition = profile.transition(1.0 + 1e-9)
    for low, high in ((1.0, 1.0), (0.9, 1.0), (0.999, 1.3), (0.0, 1.001)):
        span = low * profile.duration, high * profile.duration
        assert not ramps.excludes(transition, *span)


@pytest.mark.parametrize(
    ("i", "shape", "ramps"),
    [
        (25, "smoothstep", Smoothstep()),
        (48, "smoothstep", Smoothstep()),
        (48, "plateau", SymmetricRamps()),
        (116, "plateau", SymmetricRamps()),
    ],
)
def test_bounds_are_below_our_own_plans_and_not_far(i: int, shape: str, ramps: Ramps) -> None:
    item = json.loads(REFERENCE.read_text(encoding="utf-8"))[i]
    start, end = item["start"], item["end"]
    own = plan([Waypoint(*start), Waypoint(*end)], Limits(*item["limits"]), shape=shape)
    transition = Transition("", tuple(start), tuple(end), tuple(item["limits"]))
    found = RampBound(ramps, 16, 10).lower_bound(transition, 5e-3)
    assert 0.85 * own.duration < found <= own.duration


def test_no_planner_reaches_what_was_asked_for(tmp_path: Path) -> None:
    part = measure(Settings(1, 1, 1, tmp_path, bounded=1))
    for ratios, slowest in (part.sections[:2], part.sections[2:]):
        wanted, ours, least = (float(r["largest"] or 0.0) for r in ratios.records)
        assert wanted < least <= ours
        assert float(slowest.records[0]["bound"] or 0.0) == least
