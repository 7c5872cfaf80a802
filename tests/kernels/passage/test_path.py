"""The central path: its steps against differences, its end against linear programming."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import linprog

from segfmu.kernels.passage.grid import write_grid
from segfmu.kernels.passage.records import Cells, GridRow, Square
from tests.kernels.passage.missions import LIMITS, PLACES, Mission

CELLS = Cells.COUNT


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
    rows = Cells.INNER * order + CELLS
    grid = np.zeros((Cells.ROWS, GridRow.SIZE))
    write_grid(order, grid, np.zeros((Square.SIZE, Square.COLUMNS)))
    orders = grid[:rows, GridRow.ORDER]
    distance, v, a, w, b = random.normal(size=5)
    duration = 1.7
    ends = [distance, v * duration, a * duration**2, w * duration, b * duration**2]
    variables = np.array([*ends, *random.normal(size=CELLS - order)])
    values = grid[:rows, : len(variables)] @ variables
    control = values[orders == order] / duration**order
    states = chain(order, (v, a), control, duration)
    assert states[-1, :3] == pytest.approx([distance, w, b], abs=1e-9)
    assert states[-1, 3:] == pytest.approx(0.0, abs=1e-8)
    for d in range(order):
        scaled = states[1:-1, d] * duration**d
        assert values[orders == d] == pytest.approx(scaled, abs=1e-8)


def test_steps_promise_the_slope_of_the_barrier() -> None:
    mission = Mission().followed(3.0)
    theta = 50.0
    decrease = mission.step(theta)
    up, down = (mission.value(theta, e) for e in (1e-6, -1e-6))
    assert (down - up) / 2e-6 == pytest.approx(decrease, rel=1e-5)


def test_the_end_of_the_path_cannot_be_shortened() -> None:
    """For durations that are 1 % shorter in all intervals a linear program finds no motion."""
    times = Mission().followed(1e-3).times
    assert shortest_slack(times) >= -1e-9
    assert shortest_slack(0.99 * times) < 0.0


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
    free, kept = Mission().followed(0.01), Mission(box).followed(0.01)
    # the same motions, judged by the range: the free one leaves it and is shorter
    assert Mission(box).used(free) > 1.0 > Mission(box).used(kept)
    assert free.times.sum() < kept.times.sum()
