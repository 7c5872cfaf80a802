"""Commands that GantryFeedforward on PythonFMU follows while it runs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from segfmu.crane.operation import OperatedMotion
from segfmu.crane.variables import filled
from segfmu.errors import InfeasibleError
from segfmu.kernels import backend
from segfmu.kernels.clearance.records import ObstacleRow, Space, SpaceLimits
from segfmu.kernels.crane.records import Compensation, DriveBounds, Resistance, RopeBounds
from segfmu.kernels.limits.records import LimitRow, PlanLimits
from segfmu.kernels.messages import READY, TAKEOVER
from segfmu.kernels.operation.records import (
    Command,
    DriveBrakes,
    Known,
    OperationMode,
    OperationStatus,
    ReadyFault,
    ReadyStatus,
    Swing,
)
from segfmu.kernels.planner.records import Lower, PlanOptions
from segfmu.planning import Trajectory

Value = Callable[[str], Any]


class Commands:
    """Follows the commands of an FMU, whose variables `value` gives by name, behind a plan.

    start : time at which the plan begins [s].

    Raises
    ------
    InfeasibleError
        If no command can be followed with these parameters.
    """

    def __init__(self, value: Value, plan: Trajectory, start: float) -> None:
        fault = np.zeros(ReadyFault.SIZE)
        status = backend.check_ready(
            filled(Compensation, value), filled(Resistance, value), int(plan.offsets[-1]), fault
        )
        if status != ReadyStatus.READY:
            raise InfeasibleError(READY.text(status, fault))
        self._value = value
        table = plan.limits.table(3, plan.smoothness)
        self.motion = OperatedMotion(table, np.zeros((Known.SIZE, Known.COLUMNS)))
        self.motion.begin(start, plan.timing, plan.coefficients, plan.offsets)
        self._fill_known()
        # whether there was a command, so that the present plan is that of the motion
        self.acts = bool(value("command.take_over"))
        if self.acts:
            self._begin_measured(start)

    def _begin_measured(self, start: float) -> None:
        """Begin in the measured state instead of with the plan, at a time [s]."""
        Command.fill(self.motion.command, self._value)
        status = self.motion.take_over(start)
        if status != OperationStatus.TAKEN:
            fault = np.zeros(ReadyFault.SIZE)
            fault[ReadyFault.VALUE] = self._value("measured.rope.length")
            raise InfeasibleError(TAKEOVER.text(status, fault))

    def _fill_known(self) -> None:
        known = self.motion.known
        for row, record in (
            (Known.CRANE, Resistance), (Known.ROPE, RopeBounds), (Known.BOUNDS, DriveBounds),
            (Known.BRAKES, DriveBrakes), (Known.SPACE, Space), (Known.OPTIONS, PlanOptions),
        ):
            record.fill(known[row], self._value)
        limits = filled(PlanLimits, self._value).reshape(3, -1)
        known[Known.LOWER : Known.OBSTACLES, : Lower.SIZE] = -limits[:, LimitRow.VELOCITY_MIN :]
        for i in range(SpaceLimits.OBSTACLES):
            ObstacleRow.fill(known[Known.OBSTACLES + i], self._value, i + 1)

    def follow(self, time: float, step: float) -> None:
        """Follow the command at a time of the plan's clock [s], with the next a step [s] later."""
        command = self.motion.command
        Command.fill(command, self._value)
        command[Command.LEAD] = self._value("setpoint.lead")
        asks = command[Command.TRIPPED : Command.MEASURED].any()
        if self.acts or asks or command[Command.MODE] != OperationMode.MISSION:
            self.acts = True
            self.motion.operate(time, step)

    def foresee(self, time: float) -> tuple[float, float]:
        """What an emergency stop at a time of the plan's clock [s] would come to.

        Time until the carriages stand [s], and sway from then on [rad]; -1: there is no such stop.
        """
        found = self.motion.foresee(time) if self._value("command.foresees") else None
        if found is None:
            return -1.0, -1.0
        return float(found[Swing.STAND]), float(found[Swing.SWAY])

    @property
    def stops(self) -> float:
        """When the load rests, by the plan's clock [s]."""
        return self.motion.begins + float(self.motion.pieces[3].max())

    def next_event(self, time: float, start: float) -> float:
        """The next time [s] at which a derivative of the motion jumps; 1e300 where there is none.

        start: of the present plan, by the clock of the simulation [s].
        """
        timing, _, offsets, ends = self.motion.pieces
        return float(backend.next_plan_event(time, start, timing, offsets, ends, ends[None]))

