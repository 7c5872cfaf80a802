"""Axes that have time, and move at both waypoints, beside their shortest profile."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.position_ranges import FARTHER, SEED, Moving, paths, random_problem

from segfmu.kernels.spline.records import Mesh

# of the first random problems of each smoothness some whose ramps lead farther by up to 14 %
NEAR = ((3, (42, 50, 58, 112, 114)), (4, (6, 10, 13, 23, 25, 33, 72, 73, 84, 91)))
# and some that go farther than theirs to the other side, by less than that
OTHER_SIDE = ((2, (91,)), (3, (171, 182, 267)), (4, (187, 228, 296)))


def problems(n: int, numbers: tuple[int, ...]) -> list[Moving]:
    random = np.random.default_rng((SEED, n))
    found = [random_problem(n, random) for _ in range(max(numbers) + 1)]
    return [found[i] for i in numbers]


def farthest(problem: Moving) -> float:
    """How much farther than its shortest profile an axis goes, over that one's path."""
    shares = []
    for _, _, found, own in paths(problem):
        beyond = np.concatenate([own[0] - found[0], found[1] - own[1]])
        shares.append(float(beyond.max() / (own[1, 0] - own[0, 0])))
    return max(shares)


@pytest.mark.parametrize(("n", "numbers"), NEAR + OTHER_SIDE)
def test_an_axis_that_has_time_goes_as_far_as_its_shortest_profile(
    n: int, numbers: tuple[int, ...]
) -> None:
    for problem in problems(n, numbers):
        assert farthest(problem) <= FARTHER
        mirrored = Moving(
            -problem.positions, -problem.velocities, -problem.accelerations, problem.limits
        )
        assert farthest(mirrored) <= FARTHER
        # the end is reached from the other side in reversed time
        reverse = Moving(
            problem.positions[::-1], -problem.velocities[::-1], problem.accelerations[::-1],
            problem.limits,
        )
        assert farthest(reverse) <= FARTHER


def test_the_spline_takes_the_place_of_one_profile() -> None:
    problem = problems(4, (73,))[0]
    plan = problem.planned()
    assert plan is not None
    pieces = [len(plan.pieces(axis)[0]) for axis in range(plan.axes)]
    assert pieces.count(Mesh.CELLS) == 1
    # up to the derivative n nothing jumps, and the ends are exact
    for axis, count in enumerate(pieces):
        if count == Mesh.CELLS:
            _, lengths, coefficients = plan.pieces(axis)
            for order in range(5):
                rows = [np.polynomial.Polynomial(row).deriv(order) for row in coefficients]
                ends = np.array([row(time) for row, time in zip(rows, lengths, strict=True)])
                begins = np.array([row(0.0) for row in rows])
                size = np.abs(begins).max()
                np.testing.assert_allclose(ends[:-1], begins[1:], atol=1e-12 * size)
