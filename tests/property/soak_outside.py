"""States outside their limits: none may be refused, none outside after the told time.

`python -m tests.property.soak_outside --problems 2000` takes that many random states of each
smoothness, each for a stop, a velocity and a target, in Python and in C, and problems made by the
recipe of Ruckig's own tests. `verify` judges every plan. The test suite runs some hundreds.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from segfmu import (
    InfeasibleError,
    Limits,
    Trajectory,
    Waypoint,
    plan,
    reach_velocity,
    replan,
    stop,
    verify,
)
from segfmu.arrays import FloatArray
from tests.kernels.planner.c_planner import Asked, Planner, Result
from tests.property.replan_in_c import given

BASES = np.array([
    [1.0, 1.0, 4.0, 20.0, 400.0, 1e4, 3e5], [4.0, 0.8, 0.6, 0.9, 3.0, 20.0, 100.0],
])


@dataclass
class Tally:
    """What became of the requests, and how many of the plans begin outside."""

    requests: int = 0
    outside: int = 0
    refused: list[str] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)

    def judge(self, name: str, found: Trajectory) -> None:
        """Count a plan."""
        judged, told = verify(found), found.outside
        self.outside += bool(told.any())
        if not judged.passed:
            self.wrong.append(f"{name}: {judged}")
        elif (told > judged.outside * (1.0 + 1e-9)).any():
            self.wrong.append(f"{name}: outside until {told}, by its brake until {judged.outside}")


def beyond(random: np.random.Generator, limits: FloatArray) -> FloatArray:
    """A state, derivatives 0 .. n, some of them beyond their limits by 1e-9 to 3 times."""
    n = limits.size - 1
    shares = random.uniform(-0.95, 0.95, n)
    for i in random.choice(n, size=random.integers(1, n + 1), replace=False):
        shares[i] = random.choice([-1.0, 1.0]) * (1.0 + 10.0 ** random.uniform(-9.0, np.log10(2.0)))
    return np.array([0.0, *(shares * limits[:n])])


def random_limits(random: np.random.Generator, n: int) -> FloatArray:
    """Limits c_1 .. c_{n+1} of a crane of any size, some of the higher ones absent."""
    limits = random.choice(BASES)[: n + 1] * np.exp(random.uniform(-0.7, 0.7, n + 1))
    given = int(random.integers(3, n + 2))
    limits[given:] = 0.0
    return limits


def as_limits(table: FloatArray, shares: FloatArray | None = None) -> Limits:
    """`Limits` of one axis; shares of those of velocity and acceleration in the other direction."""
    velocity, acceleration = (None, None) if shares is None else (-shares * table[:2]).tolist()
    return Limits(
        *(value or None for value in table[:6]), velocity_min=velocity,
        acceleration_min=acceleration,
    )


def slowed(random: np.random.Generator, n: int) -> tuple[Trajectory, float, Limits]:
    """A plan, a time of it, and the limits of a slower motion, or lower limits of the velocity."""
    table = random_limits(random, n)[:6]
    table[2] = table[2] or 4.0
    old = plan([Waypoint(0.0), Waypoint(random.uniform(0.5, 5.0))], as_limits(table), smoothness=n)
    share = random.uniform(0.1, 1.0)
    low = table * share ** np.arange(1.0, table.size + 1.0)
    if random.random() < 0.5:
        low = table.copy()
        low[0] *= share
    return old, random.uniform(0.0, old.duration), as_limits(low)


def try_states(n: int, count: int, seed: int, planner: Planner | None = None) -> Tally:
    """Random states and slowed plans of one smoothness, also in C if given."""
    tally = Tally()
    for number in range(count):
        random = np.random.default_rng([seed, n, number])
        if number % 4 == 3:
            old, time, limits = slowed(random, n)
            start: Trajectory | Waypoint = old
        else:
            table = random_limits(random, n)
            # a state of a derivative that nothing limits is any
            state = beyond(random, np.where(table > 0.0, table, BASES[0, : n + 1]))
            # half of them are limited more, or less, in the other direction
            shares = np.exp(random.uniform(-0.7, 0.7, 2)) if number % 2 else None
            start, time, limits = Waypoint(*state), 0.0, as_limits(table, shares)
        fastest = min(float(limits.velocity), float(limits.lower(1)[0, 0]))
        wanted = random.uniform(-1.0, 1.0) * fastest
        target = Waypoint(random.uniform(-3.0, 3.0))
        for name, call in {
            "stop": lambda: stop(start, time, limits, smoothness=n),
            "velocity": lambda: reach_velocity(start, wanted, time, limits, smoothness=n),
            "target": lambda: replan(start, time, target, limits, smoothness=n),
        }.items():
            tally.requests += 1
            place = f"n = {n}, number {number}, {name}"
            try:
                found = call()
            except InfeasibleError as error:
                tally.refused.append(f"{place}: {error}")
                continue
            tally.judge(place, found)
            if planner is not None and name != "target":
                velocity = wanted if name == "velocity" else 0.0
                compare(tally, place, found, in_c(planner, start, time, velocity, limits, n))
            elif planner is not None and name == "target":
                asked = Asked([Waypoint(0.0), target], limits, n)
                old_c = given(as_plan(start, limits, n), planner)
                compare(tally, place, found, planner.replan(old_c, time, asked))
    return tally


def as_plan(start: Trajectory | Waypoint, limits: Limits, n: int) -> Trajectory:
    """A trajectory that begins in a state: one piece of its Taylor series."""
    if isinstance(start, Trajectory):
        return start
    coefficients = np.zeros((1, 2 * n))
    factorials = np.cumprod([1.0, *range(1, n + 1)])
    coefficients[0, : n + 1] = start.state(n)[0] / factorials
    return Trajectory(
        (start, Waypoint(0.0)), limits, n, "plateau", "waypoints", ("x",), np.array([[0.0, 1e3]]),
        coefficients, np.array([0, 1], dtype=np.int64), np.array([[0.0], [1e3]]), np.array([1e3]),
    )


def in_c(
    planner: Planner, start: Trajectory | Waypoint, time: float, velocity: float, limits: Limits,
    n: int,
) -> Result:
    """`reach_velocity` in C."""
    old = given(as_plan(start, limits, n), planner)
    return planner.reach(old, time, [velocity], limits.table(1, n), limits.lower(1))


def compare(tally: Tally, name: str, found: Trajectory, c: Result) -> None:
    """Count a plan of C that is another one than Python's."""
    if c.status != 0:
        tally.refused.append(f"{name} in C: status {c.status}")
        return
    told = c.trajectory.outside[0]
    if abs(c.duration - found.duration) > 1e-9 * found.duration:
        tally.wrong.append(f"{name} in C: {c.duration} s, in Python {found.duration} s")
    if found.outside[0] > told * (1.0 + 1e-9):
        tally.wrong.append(f"{name} in C: outside until {told}, in Python {found.outside[0]}")


def ruckig_inputs(
    count: int, seed: int
) -> Iterator[tuple[Waypoint, Waypoint, Limits]]:
    """Problems of three axes by the recipe of `position-random-3` in Ruckig's test_target.cpp."""
    random = np.random.default_rng(seed)
    made = 0
    while made < count:
        def some(share: float) -> FloatArray:
            return np.where(random.random(3) < share, random.normal(0.0, 0.8, 3), 0.0)

        states = [random.normal(0.0, 4.0, 3), some(0.9), some(0.8)]
        ends = [random.normal(0.0, 4.0, 3), some(0.7), some(0.6)]
        velocity, acceleration, jerk = random.uniform(0.08, 16.0, (3, 3))
        velocity, acceleration = velocity + np.abs(ends[1]), acceleration + np.abs(ends[2])
        # Ruckig itself refuses targets that cannot be reached within the limits
        bound = ends[1] - np.sign(ends[2]) * ends[2] ** 2 / (2.0 * jerk)
        if (np.abs(bound) <= velocity).all():
            made += 1
            yield Waypoint(*states), Waypoint(*ends), Limits(velocity, acceleration, jerk)


def try_ruckig(count: int, seed: int) -> Tally:
    """Problems of Ruckig's recipe, at the smoothness 2."""
    tally = Tally()
    for number, (start, target, limits) in enumerate(ruckig_inputs(count, seed)):
        tally.requests += 1
        try:
            found = replan(start, 0.0, target, limits, smoothness=2)
        except InfeasibleError as error:
            tally.refused.append(f"Ruckig, number {number}: {error}")
            continue
        tally.judge(f"Ruckig, number {number}", found)
    return tally


def main() -> None:
    """Print what became of the states of every smoothness, and of Ruckig's problems."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=500, help="of each smoothness")
    parser.add_argument("--ruckig", type=int, default=6000, help="by the recipe of Ruckig")
    parser.add_argument("--seed", type=int, default=42)
    asked = parser.parse_args()
    with TemporaryDirectory() as folder:
        planner = Planner(Path(folder))
        for n in range(2, 7):
            show(f"n = {n}", try_states(n, asked.problems, asked.seed, planner))
    show("Ruckig", try_ruckig(asked.ruckig, asked.seed))


def show(name: str, tally: Tally) -> None:
    """Print one line, and what is wrong."""
    print(
        f"{name}: {tally.requests} requests, {tally.outside} begin outside, "
        f"{len(tally.refused)} refused, {len(tally.wrong)} wrong"
    )
    for line in [*tally.refused[:5], *tally.wrong[:5]]:
        print(f"  {line}")


if __name__ == "__main__":
    main()
