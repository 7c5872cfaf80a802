"""The arrays of an operated motion, and the kernel that changes its plan (kernels/operation)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.clearance.records import Span, Stack
from segfmu.kernels.crane.records import Vector
from segfmu.kernels.operation.records import (
    Command,
    Operation,
    OperationRows,
    OperationWork,
    Progress,
    Slot,
    Swing,
)
from segfmu.kernels.planner.records import Cell
from segfmu.kernels.settling.records import LeadWork
from segfmu.kernels.trajectory.records import Timing


class OperatedMotion:
    """A motion that follows commands; all arrays are made once.

    Parameters
    ----------
    limits : ndarray, shape (3, smoothness + 1)
        As from `Limits.table`.
    known : ndarray, shape (Known.SIZE, Known.COLUMNS)
        The record `Known`.
    """

    def __init__(self, limits: FloatArray, known: FloatArray) -> None:
        orders = limits.shape[1]
        width = 2 * orders - 2
        self.known = known
        self.record = np.zeros((Operation.SIZE, Operation.COLUMNS))
        self._limits = np.stack([limits, limits])
        self._timing = np.zeros((Slot.COUNT, OperationRows.ALL, Timing.SIZE))
        self._coefficients = np.zeros((Slot.COUNT, OperationRows.ALL, width))
        self._offsets = np.zeros(Slot.COUNT * Slot.OFFSETS, dtype=np.int64)
        self._states = np.zeros((2, Vector.SIZE, orders))
        self._cells = np.zeros((Vector.SIZE, Cell.SIZE, Cell.COLUMNS))
        self._lead = np.zeros((LeadWork.SIZE, LeadWork.COLUMNS))
        self._work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
        self._stack = np.zeros((Stack.ROWS, Span.SIZE, 2 * width - 3))

    def begin(
        self, time: float, timing: FloatArray, coefficients: FloatArray, offsets: NDArray[np.int64]
    ) -> bool:
        """Begin with a plan, which begins at a time [s]; False if it has too many pieces."""
        count = int(offsets[-1])
        if count > OperationRows.KEPT:
            return False
        self._timing[Slot.PRESENT, :count] = timing[:count]
        self._coefficients[Slot.PRESENT, :count] = coefficients[:count]
        self._offsets[: Slot.OFFSETS] = offsets
        backend.begin_operation(time, self.record)
        return True

    def take_over(self, time: float) -> int:
        """Begin in the measured state of the command at a time [s], and come to rest.

        Returns an `OperationStatus`; only if that is TAKEN, there is another motion.
        """
        self.command[Command.TIME] = time
        return backend.take_over_measured(
            self.record, self.known, self._timing, self._coefficients, self._offsets, self._work,
            self._stack,
        )

    @property
    def command(self) -> FloatArray:
        """The record `Command`, to be written."""
        row: FloatArray = self.record[Operation.COMMAND]
        return row

    def operate(self, time: float, step: float) -> bool:
        """Follow the command at a time [s], with the next one a step [s] later.

        Returns whether the plan is another one.
        """
        command = self.command
        command[Command.TIME] = time
        command[Command.STEP] = step
        return backend.operate(
            self.record, self._limits, self.known, self._timing, self._coefficients,
            self._offsets, self._states, self._cells, self._lead, self._work, self._stack,
        )

    def foresee(self, time: float) -> FloatArray | None:
        """An emergency stop at a time [s], or the present one: a `Swing`; None: it cannot be."""
        self.command[Command.TIME] = time
        if not backend.foresee_emergency(
            self.record, self.known, self._timing, self._coefficients, self._offsets, self._work
        ):
            return None
        row: FloatArray = self.record[Operation.SWING]
        return row

    @property
    def swings(self) -> bool:
        """Whether the present motion is an emergency stop."""
        return bool(self.record[Operation.SWING, Swing.ACTIVE])

    @property
    def pieces(self) -> tuple[FloatArray, FloatArray, NDArray[np.int64], FloatArray]:
        """Timing, coefficients, offsets and ends of the present plan."""
        offsets = self._offsets[: Slot.OFFSETS]
        timing = self._timing[Slot.PRESENT]
        last = timing[offsets[1:] - 1]
        # a sum along the short axis takes five times as long
        ends = last[:, Timing.START] + last[:, Timing.LENGTH]
        return timing, self._coefficients[Slot.PRESENT], offsets, ends

    @property
    def begins(self) -> float:
        """Time at which the present plan begins [s]."""
        return float(self.record[Operation.PROGRESS, Progress.BEGIN])

    @property
    def status(self) -> int:
        """What became of the last command, an `OperationStatus`."""
        return int(self.record[Operation.PROGRESS, Progress.STATUS])

    @property
    def refused(self) -> int:
        """What the last plan that was not taken did not keep, an `OperationStatus`."""
        return int(self.record[Operation.PROGRESS, Progress.REFUSED])

    def motion(self, time: float, orders: int) -> FloatArray:
        """Position of the load and its derivatives at a time [s], shape (orders, 3)."""
        values = np.empty((orders, Vector.SIZE))
        backend.evaluate_orders(time - self.begins, *self.pieces, values)
        return values

