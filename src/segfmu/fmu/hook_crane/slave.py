"""HookCrane on PythonFMU: the plant of the gantry crane, with hook and sling."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane import Crane, SwayFeedback
from segfmu.crane.controller import Controller
from segfmu.crane.hook import HookController, HookCrane, HookWeights, design_hook
from segfmu.crane.hook.model import HOOK
from segfmu.crane.linear import rope_range
from segfmu.crane.plant import Plant
from segfmu.errors import InputError
from segfmu.fmu.gantry_crane.slave import CraneSlave
from segfmu.fmu.hook_crane import interface as hook_crane
from segfmu.kernels import backend
from segfmu.kernels.control.records import Tracking
from segfmu.kernels.crane.records import Axes, DriveMode, PlantState, State
from segfmu.kernels.crane.records import Plant as Parameters
from segfmu.kernels.hook.records import HookOutputs, HookWeighing, Sling, SlingReference

# of rope and sling at the start [rad]
MOST_ANGLE = 1.57


class HookCraneSlave(CraneSlave):
    """The slave; the sling's start values count from its reference, as those of the crane."""

    spec = hook_crane.spec()
    _own: FloatArray | None = None

    def crane(self) -> HookCrane:
        """The crane that the parameters describe."""
        return HookCrane.of(self.value)

    def placed(self, state: FloatArray) -> FloatArray:
        """The same with the sling's angles and rates."""
        if self._own is None:
            self._own = self.filled(Sling)
        sling = self._own.copy()
        if self.value("start.on_reference") and self.value("reference.rope.length") > 0.0:
            held = np.zeros(SlingReference.SIZE)
            SlingReference.fill(
                held, lambda n: self.starts.get(n, self.spec.variable(n).start or 0.0)
            )
            sling += self.filled(SlingReference) - held
        for axis, angle in zip("xy", sling[Sling.ANGLE : Sling.RATE].tolist(), strict=True):
            if not abs(angle) < MOST_ANGLE:
                raise InputError(
                    f"sling.{axis}.angle: {angle:g} rad is no sling below its hook; give less than "
                    f"{MOST_ANGLE:g} rad"
                )
        self.show(Sling, sling)
        found = np.zeros(PlantState.SIZE)
        found[: State.SIZE] = state
        found[PlantState.SLING_ANGLE : PlantState.SLING_ANGLE + 2] = sling[: Sling.RATE]
        found[PlantState.SLING_RATE : PlantState.SLING_RATE + 2] = sling[Sling.RATE :]
        return np.asarray(found[HOOK.places])

    def controlled(
        self, expected: Crane, length: float
    ) -> tuple[Controller | SwayFeedback, SwayFeedback | None]:
        """The same; measured signals have a feedback of their own, whose gains are not tuned."""
        if not self.measures:
            return super().controlled(expected, length)
        self._design, self._tracking = None, None
        sling = float(self.value("feedback.sling"))
        own = replace(self.crane(), crane=expected)
        plant = self.filled(Parameters)
        plant[Parameters.PAYLOAD_MASS] = expected.payload_mass
        shortest, longest = rope_range(expected, length)
        feedback = design_hook(
            replace(own, sling=sling) if sling > 0.0 else own,
            sample_time=float(self.value("feedback.sample_time")), shortest=shortest,
            longest=longest, weights=HookWeights(*self.filled(HookWeighing).tolist()),
            driven=_driven(plant), lag=plant[Parameters.LAG : Parameters.LAG + Axes.SIZE],
        )
        return HookController(feedback, *_limits(plant)), None

    def _show(self, plant: Plant) -> None:
        super()._show(plant)
        self.show(HookOutputs, plant.told(backend.hook_outputs, HookOutputs.SIZE))


def _driven(plant: FloatArray) -> bool:
    return bool(plant[Parameters.MODE] == DriveMode.VELOCITY)


def _limits(plant: FloatArray) -> tuple[FloatArray, ...]:
    """Least and greatest setpoints, and velocities that corrections keep, from a `Plant`."""
    drives = np.zeros(Tracking.SIZE)
    backend.set_drives(plant, drives)
    least, greatest = (
        drives[first : first + Axes.SIZE].copy() for first in (Tracking.LEAST, Tracking.GREATEST)
    )
    most, lower = (
        plant[first : first + Axes.SIZE]
        for first in (Parameters.VELOCITY_MAX, Parameters.VELOCITY_MIN)
    )
    fastest = np.where(_driven(plant) & (most > 0.0), most, 1e99)
    slowest = np.where(_driven(plant) & (lower < 0.0), lower, -fastest)
    return least, greatest, slowest, fastest
