"""GantryCrane on PythonFMU: the plant with its sampled feedback."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from pythonfmu.enums import Fmi2Status

from segfmu.arrays import FloatArray
from segfmu.crane import Crane, Rig
from segfmu.crane.controller import Controller
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.plant import Plant
from segfmu.crane.setpoints import Setpoints
from segfmu.crane.tracking import TrackingController
from segfmu.errors import SimulationError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.feedback_parameters import (
    DESIGNS,
    SOURCES,
    gains_from,
    gains_warning,
    nominal_from,
    tracking_from,
    tune,
)
from segfmu.fmu.gantry_crane.start import Start
from segfmu.fmu.python.slave import SpecSlave
from segfmu.kernels.control.records import Estimates, FlatDesign
from segfmu.kernels.crane.records import Axes, DriveMode, State
from segfmu.kernels.crane.records import Plant as Parameters
from segfmu.kernels.rig.records import Loop, Outputs, Target
from segfmu.kernels.rig.records import Setpoints as SetpointRecord

# places of the reference among setpoints
REFERENCE = slice(SetpointRecord.REFERENCE, SetpointRecord.REFERENCE + State.SIZE)


class CraneSlave(SpecSlave):
    """The slave; it uses `segfmu.crane.plant.Plant`.

    One of another model has its own interface, crane, state and feedback of measured signals.
    """

    spec = gantry_crane.spec()

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._plant: Plant | None = None
        self._tracking: TrackingController | None = None
        self._design: Callable[[], SwayFeedback] | None = None
        self._tuned: tuple[float, ...] = ()
        self._start: Start | None = None
        # whether inputs were set before the end of initialisation, and whether a step was made
        self._given = self._stepped = False

    def initialise(self) -> None:
        """Design the feedback and set the initial state."""
        crane = Crane.of(self.value)
        if self._start is None:
            self._start = self._begin()
        state = self._start.state(self._reference(), self._given)
        self.show(State, state)
        placed = self.placed(state)
        driven = self.filled(Parameters)[Parameters.MODE] == DriveMode.VELOCITY
        expected = nominal_from(self.value)
        controller, gains = self.controlled(expected, float(state[State.POSITION + Axes.ROPE]))
        self.show(Estimates, np.array([expected.payload_mass, *np.zeros(6)]))
        self._plant = Plant(
            self.crane(), placed, self._setpoints(), controller, driven=driven,
            rig=Rig.of(self.value), start_time=self.start_time,
        )
        self._show(self._plant)
        enabled = bool(self.value("feedback.enabled"))
        warning = self._start.warning(crane, enabled)
        if enabled and warning is None and gains is not None:
            warning = gains_warning(self.value, expected, gains)
        if warning:
            self.log(warning, Fmi2Status.warning)

    def crane(self) -> AnyCrane:
        """The crane that the parameters describe."""
        return Crane.of(self.value)

    def placed(self, state: FloatArray) -> FloatArray:
        """The state of the model at the start, from that of carriages and rope, shape (10,)."""
        return state

    @property
    def measures(self) -> bool:
        """Whether the feedback knows the sensors' signals alone."""
        return SOURCES.items[int(self.value("feedback.source")) - 1] == "measured"

    def controlled(
        self, expected: Crane, length: float
    ) -> tuple[Controller | SwayFeedback, SwayFeedback | None]:
        """The feedback for an expected crane, and its gains, if those of feedback.design act.

        length: of the rope at the start [m].
        """
        self._design = partial(gains_from, self.value, expected, length)
        self._tuned = self._poles()
        feedback = self._design()
        self._tracking = None
        if self.measures:
            self._tracking = tracking_from(self.value, expected, feedback)
        return self._tracking or feedback, feedback

    def _begin(self) -> Start:
        """Start values, before outputs take their places."""
        held = np.zeros(SetpointRecord.SIZE)
        SetpointRecord.fill(
            held, lambda n: self.starts.get(n, self.spec.variable(n).start or 0.0)
        )
        return Start(
            self.filled(State), held[REFERENCE], bool(self.value("start.on_reference"))
        )

    def _reference(self) -> FloatArray:
        return self.filled(SetpointRecord)[REFERENCE]

    def _set(self, kind: str, references: list[int], values: list[Any]) -> None:
        if self._plant is None:
            self._given |= any(
                self.spec.variables[r - 1].causality == "input"
                for r in references if 0 < r <= len(self.spec.variables)
            )
        super()._set(kind, references, values)

    def advance(self, time: float, step: float) -> None:
        """Step the plant to the setpoints now set."""
        plant, start = self._ready(step)
        self._tune(plant)
        try:
            plant.step(step, self._setpoints())
        except SimulationError:
            status, when = plant.ending
            reason = start.failure(Crane.of(self.value), status, when, when - self.start_time)
            if reason is None:
                raise
            raise SimulationError(reason) from None
        self._show(plant)

    def _ready(self, step: float) -> tuple[Plant, Start]:
        """The plant, which starts again where the first step is the first to have a reference."""
        assert self._start is not None
        late = not (self._stepped or self._given)
        self._stepped = True
        if late and self._start.is_late(self._reference(), step):
            self.initialise()
        assert self._plant is not None
        return self._plant, self._start

    def _poles(self) -> tuple[float, ...]:
        """The tunable parameters that gains follow from; none of design lqr."""
        return tuple(self.filled(FlatDesign).tolist()) if self._flat() else ()

    def _flat(self) -> bool:
        return DESIGNS.items[int(self.value("feedback.design")) - 1] == "flatness"

    def _tune(self, plant: Plant) -> None:
        """Apply the tunable parameters."""
        feedback = None
        if self._design is not None and self._poles() != self._tuned:
            self._tuned = self._poles()
            feedback = self._design()
        if self._tracking is not None:
            tune(self._tracking, self.value, feedback)
            return
        loop = self.filled(Loop)
        plant.fade, plant.enabled = float(loop[Loop.FADE]), bool(loop[Loop.ENABLED])
        if feedback is not None:
            plant.retune(feedback)

    def _setpoints(self) -> Setpoints:
        return Setpoints.of(self.filled(SetpointRecord))

    def _show(self, plant: Plant) -> None:
        self.show(Outputs, plant.outputs(self.filled(Target)))
        if self._tracking is not None:
            self.show(Estimates, self._tracking.estimates)
