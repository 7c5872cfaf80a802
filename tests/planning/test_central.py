"""The central path: its steps against differences, its end against linear programming."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import linprog

from segfmu.planning.central import CentralPath
from segfmu.planning.grid import CELLS, grid
from segfmu.planning.point import Point

LIMITS = np.array([[1.0, 0.8, 2.0, 15.0], [0.6, 0.7, 3.0, 10.0]])
PLACES = np.array([[0.0, 0.0], [0.6, 0.2], [0.9, 0.9], [1.8, 0.7]])
EVERYWHERE = np.broadcast_to([-np.inf, np.inf], (3, 2, 2))


def mission(box: np.ndarray = EVERYWHERE) -> CentralPath:
    free = np.ones((4, 2, 2), dtype=np.bool_)
    free[[0, -1]] = False
    centre = np.zeros((2, 2))
    return CentralPath(PLACES, np.zeros((4, 2, 2)), free, LIMITS, centre, np.ones((3, 4)), box)


def followed(path: CentralPath, gap: float) -> Point:
    point = path.start(10.0)
    assert point is not None
    theta = 0.1 * path.constraints / point.total
    while path.constraints / (theta * point.total) > gap:
        centred = path.centre(point, theta)
        assert centred is not None
        point = centred
        theta *= 3.0
    return point


def chain(order: int, start: tuple[float, float], control: np.ndarray, duration: float):
    """States (nodes, order) of an integrator chain by its exact steps."""
    h = duration / CELLS
    states = [np.array([0.0, *start, *[0.0] * (order - 3)])]
    factorials = np.cumprod([1.0, *range(1, order + 1)])
    for u in control:
        taylor = [*states[-1], u]
        states.append(np.array([
            sum(taylor[d + j] * h**j / factorials[j] for j in range(order + 1 - d))
            for d in range(order)
        ]))
    return np.array(states)


@pytest.mark.parametrize("order", [3, 4])
def test_motions_on_the_grid_arrive_and_have_the_derivatives_it_says(order: int) -> None:
    random = np.random.default_rng(order)
    maps = grid(order)
    distance, v, a, w, b = random.normal(size=5)
    duration = 1.7
    ends = [distance, v * duration, a * duration**2, w * duration, b * duration**2]
    values = maps.rows @ np.array([*ends, *random.normal(size=maps.rows.shape[1] - 5)])
    control = values[maps.orders == order] / duration**order
    states = chain(order, (v, a), control, duration)
    assert states[-1, :3] == pytest.approx([distance, w, b], abs=1e-9)
    assert states[-1, 3:] == pytest.approx(0.0, abs=1e-8)
    for d in range(order):
        scaled = states[1:-1, d] * duration**d
        assert values[maps.orders == d] == pytest.approx(scaled, abs=1e-8)


def test_steps_promise_the_slope_of_the_barrier() -> None:
    path = mission()
    point = followed(path, 3.0)
    theta = 50.0
    step, decrease = path._step(point, theta)
    up, down = (path._value(point.moved(step, e), theta) for e in (1e-6, -1e-6))
    assert (down - up) / 2e-6 == pytest.approx(decrease, rel=1e-5)


def test_the_end_of_the_path_cannot_be_shortened() -> None:
    """For durations that are 1 % shorter in all intervals a linear program finds no motion."""
    path = mission()
    point = followed(path, 1e-3)
    assert shortest_slack(np.exp(point.times)) >= -1e-9
    assert shortest_slack(0.99 * np.exp(point.times)) < 0.0


def shortest_slack(times: np.ndarray) -> float:
    """Largest share by which every limit can be kept more than needed, over both axes."""
    return min(axis_slack(times, axis) for axis in range(2))


def axis_slack(times: np.ndarray, axis: int) -> float:
    cells = CELLS * len(times)
    steps = np.repeat(times / CELLS, CELLS)
    effect, slack = np.zeros((4, cells)), np.zeros(cells)
    rows, bounds, equal, places = [], [], [], []
    for k, h in enumerate(steps):
        moved = np.array([
            sum(effect[d + j] * h**j / [1, 1, 2, 6][j] for j in range(4 - d)) for d in range(4)
        ])
        moved[:, k] += [h**4 / 24, h**3 / 6, h**2 / 2, h]
        effect = moved
        if (k + 1) % CELLS == 0:
            equal += [effect[0], effect[3]]
            places += [PLACES[(k + 1) // CELLS, axis] - PLACES[0, axis], 0.0]
        rows += [effect[1], effect[2], effect[3]]
        bounds += list(LIMITS[axis, :3])
    equal += [effect[1], effect[2]]
    places += [0.0, 0.0]
    rows += list(np.eye(cells))
    bounds += [LIMITS[axis, 3]] * cells
    limits = np.array(bounds)
    shares = np.array(rows) / limits[:, None]
    slack = np.ones((len(shares), 1))
    found = linprog(
        [*np.zeros(cells), -1.0],
        A_ub=np.vstack([np.hstack([shares, slack]), np.hstack([-shares, slack])]),
        b_ub=np.ones(2 * len(shares)),
        A_eq=np.hstack([np.array(equal), np.zeros((len(equal), 1))]), b_eq=places,
        bounds=[*[(None, None)] * cells, (-10.0, 1.0)], method="highs",
    )
    assert found.status == 0
    return float(found.x[-1])


def test_positions_keep_their_range() -> None:
    box = np.stack([np.minimum(PLACES[:-1], PLACES[1:]) - 0.02,
                    np.maximum(PLACES[:-1], PLACES[1:]) + 0.02], axis=2)
    path, bound = mission(), mission(box)
    free, kept = followed(path, 0.01), followed(bound, 0.01)
    # the same motions, judged by the range: the free one leaves it and is shorter
    assert np.abs(bound._shares(free)).max() > 1.0 > np.abs(bound._shares(kept)).max()
    assert free.total < kept.total
