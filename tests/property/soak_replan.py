"""Random plans, replanned and stopped at random times: none may be refused or break a limit.

`python -m tests.property.soak_replan --problems 100000` takes the problems of each smoothness, with
`--ends` at times shortly after the start and before the end of the plans; the test suite runs some
hundreds of both. `verify` judges every plan. Dwells, other synchronizations and wider limits come
from a generator of their own: but for them, the problems of a seed stay the same. With `--c` the C
entry points get the same requests.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from segfmu import (
    InfeasibleError,
    InputError,
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
from tests.kernels.planner.c_planner import Planner
from tests.property.replan_in_c import Replanner
from tests.property.soak import problems

TIMES = 8


@dataclass
class Tally:
    """What became of the states, and the new plan's duration over the old plan's rest."""

    states: int = 0
    refused: list[str] = field(default_factory=list)
    invalid: list[str] = field(default_factory=list)
    late: list[str] = field(default_factory=list)


def random_plan(
    random: np.random.Generator, more: np.random.Generator, n: int, axes: int
) -> Trajectory:
    """A plan that ends at rest, over one or two waypoints more, often moving, some with dwells."""
    dwelling = more.random() < 0.4
    while True:
        table = problems(random, n, axes)[0]
        # a limit is given for all axes or for none
        table[:, (table == 0.0).any(axis=0)] = 0.0
        if not table[:, 2:].any():
            continue
        count = int(random.integers(2, 4))
        points = []
        for i in range(count):
            moving = 0.7 * (0 < i < count - 1 and random.random() < 0.6)
            share = moving * random.uniform(-1.0, 1.0, (2, axes))
            way = random.normal(size=axes) * 10.0 ** random.uniform(-2.0, 1.5)
            rests = dwelling and not share.any() and more.random() < 0.6
            dwell = 10.0 ** more.uniform(-3.0, 1.0) if rests else 0.0
            points.append(Waypoint(way, *(share * table.T[:2]), dwell=dwell))
        limits = Limits(*(column if column.any() else None for column in table.T[:6]))
        shape = "plateau" if random.random() < 0.8 else "smoothstep"
        synchronize = random.choice(["waypoints", "none", "total"])
        try:
            return plan(points, limits, smoothness=n, shape=shape, synchronize=synchronize)
        except InfeasibleError:
            continue


def random_target(
    random: np.random.Generator, trajectory: Trajectory, asked: dict[str, object]
) -> Waypoint:
    """A position near the plan's, often with a velocity."""
    reach = random.normal(size=trajectory.axes) * 10.0 ** random.uniform(-2.0, 1.0)
    bounds = trajectory.limits.table(trajectory.axes, trajectory.smoothness).T
    moving = random.random() < 0.3
    share = 0.5 * moving * random.uniform(-1.0, 1.0, (2, trajectory.axes))
    target = Waypoint(trajectory.waypoints[-1].position + reach, *(share * bounds[:2]))
    try:
        plan([trajectory.waypoints[-1], target], shape=trajectory.shape,
             smoothness=trajectory.smoothness, **asked)
    except InfeasibleError:
        # not even from rest
        return Waypoint(target.position)
    return target


def random_request(more: np.random.Generator, old: Trajectory) -> dict[str, object]:
    """Limits and synchronization of a new plan: those of the old one, or others that it keeps."""
    limits, mode = old.limits, old.synchronize
    if more.random() < 0.3:
        table = limits.table(old.axes, old.smoothness).T * more.uniform(1.0, 3.0)
        limits = Limits(*(column if column.any() else None for column in table[:6]))
    if more.random() < 0.5:
        mode = str(more.choice(["waypoints", "none", "total"]))
    return {"limits": limits, "synchronize": mode}


def targets_left(more: np.random.Generator, old: Trajectory, t: float) -> tuple[Waypoint, ...]:
    """The last waypoint, or all that no axis has passed."""
    passed = int((old.axis_waypoint_times <= t).any(axis=1).sum()) if more.random() < 0.5 else -1
    return old.waypoints[passed:] or old.waypoints[-1:]


def can_keep(old: Trajectory, asked: dict[str, object], targets: int) -> bool:
    """Whether the axes of a plan meet as asked of a new one to its last waypoints."""
    mode = asked["synchronize"]
    if mode in ("none", old.synchronize) or old.synchronize == "waypoints":
        return True
    return old.synchronize == "total" and targets == 1


def try_time(
    random: np.random.Generator, more: np.random.Generator, old: Trajectory, t: float, clock: float,
    name: str, tally: Tally, c: Replanner | None,
) -> None:
    """Replan to the same and to a new target, stop, and reach a velocity, also in C if given.

    clock: rounding error of the rest's duration that is not late [s].
    """
    asked, same = random_request(more, old), targets_left(more, old, t)
    name = (
        f"{name}, {old.synchronize} -> {asked['synchronize']}, {len(same)} targets, dwell "
        f"{same[-1].dwell:.3g} s"
    )
    wanted = random.uniform(-0.9, 0.9, old.axes) * old.limits.table(old.axes, old.smoothness)[:, 0]
    new = random_target(random, old, asked)
    tasks = {
        "same": lambda: replan(old, t, same, **asked),
        "new": lambda: replan(old, t, new, **asked),
        "stop": lambda: stop(old, t),
        "velocity": lambda: reach_velocity(old, wanted, t),
    }
    soon = {"stop", "stop in C"}
    if can_keep(old, asked, len(same)):
        # in C what is left is kept to one target only
        soon |= {"same", "same in C"} if len(same) == 1 else {"same"}
    if c is not None:
        tasks |= {
            "same in C": lambda: c.replan(old, t, same, **asked),
            "new in C": lambda: c.replan(old, t, (new,), **asked),
            "stop in C": lambda: c.reach_velocity(old, np.zeros(old.axes), t),
            "velocity in C": lambda: c.reach_velocity(old, wanted, t),
        }
    rest = max(old.duration - t, 0.0)
    for task, call in tasks.items():
        tally.states += 1
        try:
            found = call()
        except (InfeasibleError, InputError) as error:
            tally.refused.append(f"{name}, {task}, t = {t!r}: {error}")
            continue
        judged = verify(found)
        if not judged.passed:
            tally.invalid.append(
                f"{name}, {task}, t = {t!r}: limits {judged.usage.max():.12g}, waypoints "
                f"{judged.waypoint_error:.2g}, jumps {judged.jumps.max():.2g}, times "
                f"{judged.time_error:.2g}"
            )
        if task in soon and found.duration > rest * (1.0 + 1e-9) + clock:
            tally.late.append(f"{name}, {task}, t = {t!r}: {found.duration} s, was {rest} s")


def random_times(random: np.random.Generator, duration: float, ends: bool) -> FloatArray:
    """Times of a plan, uniform, or close to its start and its end, down to the last bit."""
    if ends:
        near = 10.0 ** random.uniform(-17.0, 0.0, TIMES)
        return duration * np.where(random.random(TIMES) < 0.5, near, 1.0 - near)
    return random.uniform(0.0, duration, TIMES)


def soak(
    n: int, count: int, seed: int, ends: bool = False, c: Replanner | None = None
) -> Tally:
    """`count` states of random plans of one smoothness, each for four tasks."""
    tally = Tally()
    for number in range(max(count // (4 * TIMES), 1)):
        random = np.random.default_rng([seed, n, number])
        more = np.random.default_rng([seed, n, number, 1])
        old = random_plan(random, more, n, int(random.integers(1, 4)))
        # what is left near the end is known up to the rounding of the whole duration
        clock = 1e-14 * old.duration if ends else 0.0
        for t in random_times(random, old.duration, ends):
            try_time(random, more, old, float(t), clock, f"n = {n}, problem {number}", tally, c)
    return tally


def main() -> None:
    """Run the soak for every smoothness and print what became of it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=10_000, help="of each smoothness")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--ends", action="store_true", help="times close to start and end")
    parser.add_argument("--smoothness", type=int, nargs="*", default=[2, 3, 4, 5, 6])
    parser.add_argument("--c", action="store_true", help="the C entry points as well")
    given = parser.parse_args()
    with TemporaryDirectory() as folder:
        c = Replanner(Planner(Path(folder))) if given.c else None
    for n in given.smoothness:
        begin = time.perf_counter()
        tally = soak(n, given.problems, given.seed, given.ends, c)
        print(
            f"n = {n}: {tally.states} plans, {len(tally.refused)} refused, {len(tally.invalid)} "
            f"invalid, {len(tally.late)} late, {time.perf_counter() - begin:.0f} s", flush=True,
        )
        for line in (tally.refused + tally.invalid + tally.late)[:20]:
            print("  ", line)


if __name__ == "__main__":
    main()
