"""Many random plans of three axes between moving waypoints: do they meet, and as early as can be?

`python -m tests.property.soak_axes --problems 100000`. Whether an earlier common duration exists is
asked of the timed profiles alone, on a grid between the slowest axis and the duration found.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan, verify
from segfmu.kernels.backend import timed_profile
from segfmu.planning.problem import Options, Problem
from tests.problems import planned_cells, work_space
from tests.property.soak import shares

GRID = 60


def problem(random: np.random.Generator) -> tuple[list[Waypoint], Limits, int, str]:
    """Two to four waypoints of three axes, states well inside the limits or degenerate."""
    n = int(random.choice([2, 3, 4, 4, 6]))
    shape = str(random.choice(["plateau", "plateau", "smoothstep"]))
    table = 10.0 ** random.uniform(-0.7, 0.7, (n, 3))
    if n == 2:
        table = np.vstack([table, 10.0 ** random.uniform(-0.3, 1.0, (1, 3))])
    names = ("velocity", "acceleration", "jerk", "snap", "crackle", "pop")
    limits = Limits(**dict(zip(names, table, strict=False)))
    count = int(random.integers(2, 5))
    position = np.cumsum(random.uniform(-1.0, 2.0, (count, 3)) * table[0], axis=0)
    states = np.array([shares(random, 3 * count).reshape(count, 3) * 0.6 for _ in range(2)])
    states[:, random.random(count) < 0.2] = 0.0
    points = [
        Waypoint(p, v * table[0], a * table[1] * 0.5)
        for p, v, a in zip(position, *states, strict=True)
    ]
    return points, limits, n, shape


def earlier(trajectory: Trajectory) -> str | None:
    """A common duration shorter than the one found, if the grid holds one."""
    axes, n = trajectory.axes, trajectory.smoothness
    table = trajectory.limits.table(axes, n)
    dwells = np.array([p.dwell for p in trajectory.waypoints])
    options = Options(n, trajectory.shape, "waypoints", 0.0, 0.0)
    states = np.stack(
        [np.column_stack([p.position, p.velocity, p.acceleration]) for p in trajectory.waypoints]
    )
    packed, cells = planned_cells(
        Problem(states, dwells, table, trajectory.limits.lower(axes), options)
    )
    alone = plan(
        trajectory.waypoints, trajectory.limits, smoothness=n, shape=trajectory.shape,
        synchronize="none",
    )
    found = np.diff(trajectory.waypoint_times)
    slowest = np.diff(alone.axis_waypoint_times, axis=0).max(axis=1)
    for j, (low, high) in enumerate(zip(slowest, found, strict=True)):
        if high < low * (1.0 - 1e-12):
            return f"interval {j + 1}: shorter than the slowest axis"
        if high <= low * (1.0 + 1e-9):
            continue
        for target in np.linspace(low, high * (1.0 - 1e-6), GRID)[1:]:
            if all(
                feasible(trajectory, packed[i], cells[j * axes + i], j, i, float(target))
                for i in range(axes)
            ):
                return f"interval {j + 1}: {target} s would do, {high} s was found"
    return None


def feasible(
    trajectory: Trajectory, packed: np.ndarray, cell: np.ndarray, j: int, axis: int, target: float
) -> bool:
    """Whether an axis has a profile of the given duration in the interval j; packed (Axis)."""
    resting = not any(
        p.velocity[axis] or p.acceleration[axis] for p in trajectory.waypoints[j : j + 2]
    )
    return resting or timed_profile(target, packed, cell.copy(), work_space()) >= 0.0


def soak_axes(count: int, seed: int) -> tuple[int, int, list[str]]:
    """Numbers of plans and refusals, and what was wrong."""
    random = np.random.default_rng(seed)
    planned, refused, wrong = 0, 0, []
    for i in range(count):
        points, limits, n, shape = problem(random)
        try:
            trajectory = plan(points, limits, smoothness=n, shape=shape)
        except InfeasibleError as error:
            refused += 1
            if error.limit != "velocity":
                wrong.append(f"problem {i}: {error}")
            continue
        planned += 1
        times = trajectory.axis_waypoint_times
        if np.ptp(times, axis=1).max() > 0.0 or not verify(trajectory).passed:
            wrong.append(f"problem {i}: axes do not meet, or a limit is broken")
        finding = earlier(trajectory)
        if finding:
            wrong.append(f"problem {i}: {finding}")
    return planned, refused, wrong


def main() -> None:
    """Run and print a line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    begun = time.perf_counter()
    planned, refused, wrong = soak_axes(given.problems, given.seed)
    seconds = time.perf_counter() - begun
    print(f"{planned} planned, {refused} refused, {len(wrong)} wrong, {seconds:.0f} s")
    for line in wrong[:20]:
        print(f"  {line}")


if __name__ == "__main__":
    main()
