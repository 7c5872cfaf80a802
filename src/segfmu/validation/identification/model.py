"""GantryCrane's kernels with the signals of a log: what its sensors would show."""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from functools import cache
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane import Crane, Plant, Rig, Setpoints, SwayFeedback
from segfmu.errors import InputError, SimulationError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.standard.spec import started
from segfmu.kernels import backend
from segfmu.kernels.control.records import GainInputs
from segfmu.kernels.crane.records import Axes, Coordinates, State
from segfmu.kernels.rig.records import Setpoints as Record
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_parameters import parameters
from segfmu.validation.identification.log import Log

# steps of the integration from row to row, on average: dry friction takes about ten where a period
# has 100 rows. A crane that takes more, as one with much damping and hardly a rope, is none
MOST_STEPS = 500.0
# what noise and steps of sensors add is no part of what they show on average
IDEAL = (".deviation", ".resolution")


class Model:
    """The crane of a file, whose parameters may be changed from run to run.

    Parameters
    ----------
    crane : CraneFile
    """

    def __init__(self, crane: CraneFile) -> None:
        known = started(gantry_crane.spec(), parameters(crane))
        self._values: dict[str, Any] = {v.name: v.start for v in known.variables}
        for name in self._values:
            if name.startswith("sensor.") and name.endswith(IDEAL):
                self._values[name] = 0.0
        self._driven = crane.drive == "velocity"

    def changed(self, changes: Mapping[str, float]) -> Model:
        """The same crane with other parameters of GantryCrane."""
        other = copy(self)
        other._values = self._values | dict(changes)
        return other

    def value(self, name: str) -> Any:
        """A parameter of GantryCrane."""
        return self._values[name]

    def run(self, log: Log, changes: Mapping[str, float], start: FloatArray) -> FloatArray:
        """The `OUTPUTS` at the times of a log, shape (rows, 5).

        Parameters
        ----------
        log : Log
        changes : mapping of str to float
            Parameters of GantryCrane by name.
        start : ndarray, shape (10,)
            State at the first row.

        Raises
        ------
        SimulationError, InputError
            For a crane that cannot do this.
        """
        if start[State.POSITION + Axes.ROPE] <= 0.0:
            raise InputError("the rope has no length at the start")
        plant = self.plant(log.times, log.setpoints[0], changes, start)
        first = plant.measured[None]
        rest = plant.follow(
            np.diff(log.times), self.records(log.setpoints[1:]), most=MOST_STEPS
        )
        return np.concatenate([first, rest])

    def plant(
        self, times: FloatArray, setpoints: FloatArray, changes: Mapping[str, float],
        start: FloatArray,
    ) -> Plant:
        """The crane at the first of some times, with setpoints (3,) of its drives."""
        value = (self._values | dict(changes)).__getitem__
        (first,) = self.records(setpoints[None])
        return Plant(
            Crane.of(value), start, Setpoints.of(first),
            _nothing(max(float(times[-1] - times[0]), 1.0)), driven=self._driven,
            enabled=False, rig=Rig.of(value), start_time=float(times[0]),
        )

    def attempt(
        self, log: Log, changes: Mapping[str, float], start: FloatArray
    ) -> FloatArray | None:
        """As `run`; None for a crane that cannot do this."""
        try:
            return self.run(log, changes, start)
        except (SimulationError, InputError):
            return None

    def records(self, values: FloatArray) -> FloatArray:
        """A kernel's `Setpoints` a row, from those of the drives, shape (rows, 3)."""
        found = np.zeros((len(values), Record.SIZE))
        first = Record.VELOCITY if self._driven else Record.FORCE
        found[:, first : first + Axes.SIZE] = values
        return found


def load_path(coordinates: FloatArray) -> FloatArray:
    """The load's path [m], shape (rows, 3), from the five coordinates, shape (rows, 5)."""
    load, state = np.zeros((2, Axes.SIZE)), np.zeros(State.SIZE)
    path = np.empty((len(coordinates), Axes.SIZE))
    for i, row in enumerate(coordinates):
        state[: Coordinates.SIZE] = row
        backend.crane_load(state, load)
        path[i] = load[0]
    return path


@cache
def _nothing(lasting: float) -> SwayFeedback:
    """No feedback, which is asked once in so many seconds."""
    return SwayFeedback(lasting, np.ones(1), np.zeros((1, Axes.SIZE, GainInputs.SIZE)), 1.0)
