"""A measured state as it is when the command acts, beside a pendulum integrated by SciPy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu.kernels.crane.records import Masses, State
from segfmu.kernels.operation.measured import write_measured
from segfmu.kernels.operation.records import Command, Known, Operation, OperationWork, Swing

GRAVITY = 9.81


@pytest.mark.parametrize("lead", [0.0, 0.4])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_load_swings_on_until_the_command_acts(side: float, lead: float) -> None:
    length, stretch, angle, rate, speed = 8.0, -0.5, 0.3 * side, -0.2 * side, 0.7 * side
    known = np.zeros((Known.SIZE, Known.COLUMNS))
    known[Known.CRANE, Masses.GRAVITY] = GRAVITY
    operation = np.zeros((Operation.SIZE, Operation.COLUMNS))
    command = operation[Operation.COMMAND]
    state = command[Command.MEASURED : Command.MEASURED + State.SIZE]
    state[State.POSITION + 2], state[State.VELOCITY + 2] = length, stretch
    state[State.ANGLE], state[State.RATE] = angle, rate
    state[State.VELOCITY] = speed
    command[Command.LEAD] = lead
    write_measured(operation, known, np.zeros((OperationWork.SIZE, OperationWork.COLUMNS)))

    def pendulum(t: float, y: np.ndarray) -> list[float]:
        theta, omega = y
        rope = length + stretch * t
        return [omega, -(GRAVITY * np.sin(theta) + 2.0 * stretch * omega) / rope]

    later = solve_ivp(pendulum, (0.0, lead), [angle, rate], rtol=1e-11, atol=1e-12).y[:, -1]
    rope = length + stretch * lead
    swing = operation[Operation.SWING]
    path = rope * np.array([np.sin(later[0]), 0.0, -np.cos(later[0])])
    assert swing[Swing.PATH : Swing.PATH + 3] == pytest.approx(path, abs=1e-8)
    along = np.array([np.cos(later[0]), 0.0, np.sin(later[0])])
    moving = rope * later[1] * along + stretch * path / rope
    assert swing[Swing.RATE : Swing.RATE + 3] == pytest.approx(moving, abs=1e-8)
    assert swing[Swing.POSITION] == pytest.approx(speed * lead, abs=1e-12)
    assert swing[Swing.POSITION + 2] == pytest.approx(rope, abs=1e-12)
