"""Many random boundary problems through the planner, each judged from its polynomials.

`python -m tests.property.soak --problems 1000000` takes the generator's problems of each
smoothness; the test suite runs a few thousand of them. The judge is NumPy's: Bernstein hulls of all
pieces of a batch at once, roots where a hull does not settle it.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass, field

import numpy as np

from segfmu.kernels.backend import (
    axis_limits,
    expand_phases,
    ramp_parameters,
    shortest_profile,
)
from segfmu.kernels.planner.parameters import usual_share
from segfmu.kernels.planner.records import Axis, Cell, Phase, PlanStatus, PlanWork, Problem
from segfmu.kernels.trajectory.records import Expansion, PieceState, Timing
from segfmu.planning.polynomials import derivative_pieces, hulls, piece_extrema

TOLERANCE = 1e-9
BATCH = 2000
# every phase has up to 31 pieces
ROWS = 31 * Cell.ABOVE


@dataclass
class Tally:
    """What became of the problems."""

    planned: int = 0
    refused: int = 0
    invalid: list[str] = field(default_factory=list)


def shares(random: np.random.Generator, count: int) -> np.ndarray:
    """Numbers in [-1, 1], half of them zeros, ends, quarters and tiny ones."""
    kind = random.integers(0, 10, count)
    values = random.uniform(-1.0, 1.0, count)
    signs = random.choice([-1.0, 1.0], count)
    values[kind == 0] = 0.0
    values[kind == 1] = signs[kind == 1]
    values[kind == 2] = np.round(4.0 * values[kind == 2]) / 4.0
    values[kind == 3] = (signs * 10.0 ** random.uniform(-14.0, 0.0, count))[kind == 3]
    values[kind == 4] = (signs * (1.0 - 10.0 ** random.uniform(-14.0, -1.0, count)))[kind == 4]
    return values


def problems(random: np.random.Generator, n: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Limits (count, n + 1) and boundary values v, a, w, b, distance (count, 5)."""
    limits = 10.0 ** random.uniform(-1.5, 1.5, (count, n + 1))
    plain = random.random((count, n + 1)) < 0.3
    limits[plain] = np.round(limits[plain]) + 1.0
    if n > 2:
        limits[random.random(count) < 0.7, n] = 0.0
        for i in range(3, n):
            limits[random.random(count) < 0.15, i] = 0.0
        absent = (random.random(count) < 0.1) & (limits[:, 3:n].max(axis=1, initial=0.0) > 0.0)
        limits[absent, 2] = 0.0
    state = np.empty((count, 5))
    for i, bound in enumerate((0, 1, 0, 1)):
        state[:, i] = shares(random, count) * limits[:, bound]
    tie = random.integers(0, 10, count)
    state[tie == 0, 2] = state[tie == 0, 0]
    state[tie == 1, 3] = state[tie == 1, 1]
    state[tie == 2, 3] = -state[tie == 2, 1]
    state[tie == 3, :4] = 0.0
    state[:, 4] = shares(random, count) * 10.0 ** random.integers(-4, 4, count)
    return limits, state


def soak(smoothness: int, shape: int, count: int, seed: int) -> Tally:
    """Plan `count` problems of one smoothness and judge every plan."""
    random = np.random.default_rng(seed)
    tally = Tally()
    for first in range(0, count, BATCH):
        limits, state = problems(random, smoothness, min(BATCH, count - first))
        _batch(smoothness, shape, limits, state, tally)
    return tally


def _batch(n: int, shape: int, limits: np.ndarray, state: np.ndarray, tally: Tally) -> None:
    axis, phases = np.zeros(Axis.SIZE), np.zeros((Cell.ABOVE, Phase.SIZE))
    problem, work = np.zeros(Problem.SIZE), np.zeros((PlanWork.SIZE, PlanWork.COLUMNS))
    expansion = np.zeros((Expansion.SIZE, Expansion.COLUMNS))
    timing, pieces = np.zeros((ROWS, Timing.SIZE)), np.zeros((ROWS, 2 * n))
    rows, lengths, owners, ends = [], [], [], []
    for i in range(len(state)):
        axis_limits(n, shape, limits[i], axis)
        assert ramp_parameters(usual_share(axis), axis, work)
        v, a, w, b, distance = (float(x) for x in state[i])
        problem[: Problem.DURATION] = state[i]
        count = shortest_profile(problem, axis, phases, work)
        if count in (PlanStatus.START_BRAKING, PlanStatus.END_BRAKING):
            if not brakes_too_late(v, a, w, b, limits[i], count, n, shape):
                tally.invalid.append(f"refused {describe(n, shape, limits[i], state[i])}")
            tally.refused += 1
            continue
        if count < 0:
            tally.invalid.append(f"status {count} {describe(n, shape, limits[i], state[i])}")
            continue
        tally.planned += 1
        at = expansion[Expansion.STATE]
        at[:] = 0.0
        at[PieceState.VELOCITY], at[PieceState.ACCELERATION] = v, a
        used = expand_phases(phases, count, axis, timing, pieces, 0, expansion)
        rows.append(pieces[:used].copy())
        lengths.append(timing[:used, Timing.LENGTH].copy())
        owners.append(np.full(used, i))
        missed = np.abs(at[:3] - [distance, w, b])
        # of the path, as `verify` judges
        path = max(np.ptp(pieces[:used, 0]), abs(distance), 1.0) if used else 1.0
        missed /= [path, limits[i, 0], limits[i, 1]]
        if count and not missed.max() <= TOLERANCE:
            tally.invalid.append(f"end {missed} {describe(n, shape, limits[i], state[i])}")
        ends.append(used)
    if rows:
        _judge(n, shape, limits, state, rows, lengths, owners, tally)


def _judge(n, shape, limits, state, rows, lengths, owners, tally: Tally) -> None:
    pieces, length, owner = (np.concatenate(x) for x in (rows, lengths, owners))
    same = owner[1:] == owner[:-1]
    for d in range(1, n + 2):
        polynomials = derivative_pieces(pieces, d)
        bound = np.where(limits[owner, d - 1] > 0.0, limits[owner, d - 1], np.inf)
        peak = np.abs(hulls(polynomials, length)).max(axis=1, initial=0.0)
        for row in np.flatnonzero(~(peak <= bound * (1.0 + TOLERANCE))):
            extreme = max(map(abs, piece_extrema(polynomials[row], float(length[row]))))
            if not extreme <= bound[row] * (1.0 + TOLERANCE):
                i = owner[row]
                tally.invalid.append(
                    f"derivative {d}: {extreme / bound[row] - 1.0:.2e} over "
                    f"{describe(n, shape, limits[i], state[i])}"
                )
        if d <= n:
            right = (polynomials * length[:, None] ** np.arange(polynomials.shape[1])).sum(axis=1)
            peaks = np.full(len(state), 1e-300)
            np.maximum.at(peaks, owner, peak)
            scale = np.minimum(bound, peaks[owner])
            jump = np.abs(right[:-1] - polynomials[1:, 0]) / scale[1:]
            for row in np.flatnonzero(same & ~(jump <= TOLERANCE)):
                i = owner[row]
                tally.invalid.append(
                    f"jump {d}: {jump[row]:.2e} {describe(n, shape, limits[i], state[i])}"
                )


# largest slope of the transition polynomial: how much longer its ramp is than one at full jerk
PEAKS = {2: 1.0, 3: 1.5, 4: 1.875, 5: 2.1875, 6: 2.4609375}


def brakes_too_late(v, a, w, b, limits: np.ndarray, status: int, n: int, shape: int) -> bool:
    """Whether no ramp of the shape can bring the acceleration to zero within c_1.

    Judged only where c_3 alone bounds the ramp: the velocity then changes by a^2 / (2 c_3) times
    the factor by which the ramp is longer than one at full jerk, or by a little less past zero.
    """
    velocity, acceleration = (v, a)
    if status == PlanStatus.END_BRAKING:
        velocity, acceleration = w, -b
    if limits[3:].max(initial=0.0) > 0.0 or limits[2] == 0.0:
        return acceleration != 0.0
    factor = PEAKS[n] if shape == 0 else 1.0 / (1.0 - 0.1 * (n > 2))
    room = limits[0] - velocity * np.sign(acceleration)
    return acceleration**2 / (2.0 * limits[2]) * factor >= room * (1.0 - 1e-9)


def describe(n: int, shape: int, limits: np.ndarray, state: np.ndarray) -> str:
    """A problem as text that can be pasted into a test."""
    return f"n={n} shape={shape} limits={limits.tolist()} state={state.tolist()}"


def main() -> None:
    """Run all of it and print a line each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=1_000_000)
    parser.add_argument("--smoothness", type=int, nargs="+", default=[2, 3, 4, 6])
    parser.add_argument("--shapes", type=int, nargs="+", default=[1, 0])
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    for n in given.smoothness:
        for shape in given.shapes:
            begun = time.perf_counter()
            tally = soak(n, shape, given.problems, given.seed)
            name = ("smoothstep", "plateau")[shape]
            print(
                f"smoothness {n} {name}: {tally.planned} planned, {tally.refused} refused, "
                f"{len(tally.invalid)} invalid, {time.perf_counter() - begun:.0f} s", flush=True
            )
            for line in tally.invalid[:20]:
                print(f"  {line}")


if __name__ == "__main__":
    main()
