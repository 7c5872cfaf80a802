"""The shortest total time of a mission with free states by casadi with ipopt.

One nonlinear program for the whole mission: the chain position .. jerk of every axis with constant
snap in each cell of an interval, zero jerk at the waypoints or a free one, one duration an
interval. Limits of velocity, acceleration and jerk hold at the nodes. ipopt finds a local optimum;
from rest in all waypoints and from motion along the chords it found the same one in all missions
with zero jerk so far.
"""

from __future__ import annotations

from math import factorial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.free_missions import AXES, Mission

FloatArray = NDArray[np.float64]
ORDER = 4
CELLS = 20


class MissionProgram:
    """The program for missions of one number of points: built once.

    free_jerk: the jerk is continuous in inner waypoints, else zero there.
    """

    def __init__(self, points: int, *, free_jerk: bool = False) -> None:
        import casadi as ca

        self.points = points
        self.free_jerk = free_jerk
        times = ca.SX.sym("times", points - 1)
        states: list[Any] = []
        snaps: list[Any] = []
        gaps: list[Any] = []
        for i in range(points - 1):
            for _ in range(AXES):
                states.append(ca.SX.sym("x", ORDER, CELLS + 1))
                snaps.append(ca.SX.sym("u", CELLS))
                gaps += _gaps(states[-1], snaps[-1], times[i] / CELLS)
        for before, after in zip(states, states[AXES:], strict=False):
            continuous = range(1, ORDER if free_jerk else ORDER - 1)
            gaps += [before[r, CELLS] - after[r, 0] for r in continuous]
        program: Any = {
            "x": ca.vertcat(times, *[ca.vec(x) for x in states], *snaps),
            "f": ca.sum1(times), "g": ca.vertcat(*gaps),
        }
        ipopt = {"print_level": 0, "sb": "yes", "max_iter": 600, "tol": 1e-6}
        quiet: Any = {"print_time": False, "ipopt": ipopt}
        self._solver: Any = ca.nlpsol("mission", "ipopt", program, quiet)

    def solve(self, mission: Mission) -> float:
        """Least total time found [s]; infinite where ipopt does not converge."""
        return min(self._solve(mission, moving) for moving in (False, True))

    def _solve(self, mission: Mission, moving: bool) -> float:
        positions, limits = mission.positions, mission.limits
        intervals = self.points - 1
        chords = np.diff(positions, axis=0)
        rises = (limits[:, :3] / limits[:, 1:]).sum(axis=1).max()
        slow = (np.abs(chords) / limits[:, 0]).max(axis=1) + (0.5 if moving else 2.0) * rises
        upper = np.full((intervals, AXES, CELLS + 1, ORDER), np.inf)
        upper[..., 1:] = limits[:, None, :3]
        lower = -upper
        guess = np.zeros_like(upper)
        share = np.linspace(0.0, 1.0, CELLS + 1)
        guess[..., 0] = positions[:-1, :, None] + chords[:, :, None] * share
        if moving:
            guess[..., 1] = (chords / slow[:, None])[:, :, None]
        for box in (lower, upper):
            box[:, :, 0, 0], box[:, :, -1, 0] = positions[:-1], positions[1:]
            if not self.free_jerk:
                box[:, :, [0, -1], 3] = 0.0
            box[0, :, 0, 1:] = box[-1, :, -1, 1:] = 0.0
        snaps = np.broadcast_to(limits[:, 3, None], (intervals, AXES, CELLS)).ravel()
        found = self._solver(
            x0=np.concatenate([slow, guess.ravel(), 0.0 * snaps]),
            lbx=np.concatenate([np.full(intervals, 1e-3), lower.ravel(), -snaps]),
            ubx=np.concatenate([np.full(intervals, np.inf), upper.ravel(), snaps]),
            lbg=0.0, ubg=0.0,
        )
        return float(found["f"]) if self._solver.stats()["success"] else np.inf


def _gaps(x: Any, snap: Any, h: Any) -> list[Any]:
    """What the states of a chain miss at the end of every cell."""
    gaps = []
    for k in range(CELLS):
        for r in range(ORDER):
            reached = snap[k] * h ** (ORDER - r) / factorial(ORDER - r)
            for j in range(ORDER - r):
                reached += x[r + j, k] * h**j / factorial(j)
            gaps.append(x[r, k + 1] - reached)
    return gaps
