"""GantryCrane's parameters for the feedback, and the controller on measured signals from them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane import Crane
from segfmu.crane.feedback import SwayFeedback, Weights, design
from segfmu.crane.flat_feedback import DAMPING, HOIST_RATIO, RATIO, design_flat
from segfmu.crane.linear import ROWS, rope_range
from segfmu.crane.observer import UNCERTAINTY, Uncertainty, design_observer
from segfmu.crane.tracking import CAUSES as OFFSET_CAUSES
from segfmu.crane.tracking import FADE, PAYLOAD_TIME, TrackingController
from segfmu.crane.variables import Value, build, filled
from segfmu.fmu.standard.spec import Enumeration, Variable, choice, parameter
from segfmu.kernels import backend
from segfmu.kernels.control.records import FlatDesign, LoopWork, Tracking, TrackingDesign
from segfmu.kernels.control.records import Uncertainty as Expectations
from segfmu.kernels.crane.records import DRIVES, Axes, DriveMode, Plant
from segfmu.kernels.messages import SETUP
from segfmu.kernels.rig.records import Sensors, SetupFault, SetupStatus

DESIGNS = Enumeration(
    "FeedbackDesign", ("lqr", "flatness"), "how the gains of the feedback come about"
)
SOURCES = Enumeration(
    "FeedbackSource", ("state", "measured"), "what the feedback knows of the crane"
)
CAUSES = Enumeration(
    "OffsetCause", OFFSET_CAUSES, "what a lasting deviation of a sway angle is"
)
OBSERVER = (
    ("position", "m", "quantisation step of the carriages' positions; 0: that of the sensors", 0.0),
    ("length", "m", "quantisation step of the rope's length; 0: that of the sensor", 0.0),
    ("angle", "rad", "quantisation step of the sway angles; 0: that of the sensors", 0.0),
    ("drift", None, "random walk of the carriages' and the rope's unknown accelerations: "
     "standard deviation after sqrt(l / g) over gravity", 1e-12),
    ("wind", None, "the same of the load's", 1e-12),
)
WEIGHTS = (
    ("position", "carriage and rope position"), ("angle", "sway angles"),
    ("velocity", "carriage and rope velocity"), ("rate", "sway rates"), ("effort", "effort"),
)


def feedback_parameters() -> list[Variable]:
    """All of them; by default the gains of an LQR design on the true state."""
    return [*_design(), *weight_parameters(), *_tracking()]


def _design() -> list[Variable]:
    return [
        parameter(
            "feedback.enabled", True, None, "sway feedback acts", kind="Boolean", tunable=True
        ),
        choice(
            "feedback.design", DESIGNS, "lqr", "gains of a linear-quadratic design, or closed form"
        ),
        parameter("feedback.sample_time", 0.01, "s", "period of the feedback", minimum=1e-6),
        parameter(
            "feedback.payload_mass", 0.0, "kg",
            "mass of the load that the feedback is designed for; 0: crane.payload_mass",
            minimum=0.0,
        ),
        parameter(
            "feedback.bandwidth", RATIO, None,
            "of design flatness: bandwidth in units of the pendulum's frequency", minimum=1e-6,
            tunable=True,
        ),
        parameter(
            "feedback.hoist_bandwidth", HOIST_RATIO, None,
            "of design flatness: bandwidth of the hoist in units of the pendulum's frequency",
            minimum=1e-6, tunable=True,
        ),
        parameter(
            "feedback.damping", DAMPING, None, "of design flatness: damping of all poles",
            minimum=1e-6, tunable=True,
        ),
    ]


def weight_parameters() -> list[Variable]:
    """Of design lqr; a native FMU has the resulting table of gains instead."""
    return [
        parameter(
            f"feedback.weight.{name}", 1.0, None,
            f"weight of the {text} in the dimensionless LQR design", minimum=0.0,
        )
        for name, text in WEIGHTS
    ]


def weights_from(value: Value) -> Weights:
    """The weights of the LQR design from the parameters; `value` gives one by name.

    Raises
    ------
    InputError
        For weights for which no design exists.
    """
    return Weights(*(float(value(f"feedback.weight.{name}")) for name, _ in WEIGHTS))


def _tracking() -> list[Variable]:
    """Of source measured; the observer's expectations are those of `crane.Uncertainty`."""
    expected = Uncertainty()
    return [
        choice(
            "feedback.source", SOURCES, "state",
            "the true state, or measured.* alone, with an observer",
        ),
        *(
            parameter(
                f"feedback.rejection.{n}", 1.0, None,
                f"share of the estimated disturbance of the {text} that is rejected", minimum=0.0,
                maximum=1.0, tunable=True,
            )
            for n, text in (("carriage", "carriages and the rope"), ("load", "load"))
        ),
        parameter(
            "feedback.fade", FADE, "s", "time constant of the change when something is switched "
            "or tuned; 0: the correction jumps", minimum=0.0, tunable=True,
        ),
        parameter(
            "feedback.payload_time", PAYLOAD_TIME, "s", "time constant of the payload's estimate",
            minimum=1e-6,
        ),
        *(
            parameter(
                f"feedback.observer.{n}", getattr(expected, n), unit, f"expected {text}",
                minimum=least,
            )
            for n, unit, text, least in OBSERVER
        ),
        parameter(
            "feedback.observer.wake", expected.wake, None, "number of quantisation steps that a "
            "signal differs from its reference when corrections begin; 0: from the start",
            minimum=0.0,
        ),
        parameter(
            "feedback.observer.offset", expected.offset, None, "expected standard deviation of the "
            "zero of the rope's sensor over the rope's length, which is estimated; 0: it is not",
            minimum=0.0,
        ),
        parameter(
            "feedback.rope_offset", False, None,
            "the measured length of the rope is corrected by estimate.rope_offset", kind="Boolean",
        ),
        choice(
            "feedback.offset_cause", CAUSES, "wind", "what a lasting deviation of a sway angle "
            "is: wind, for which the carriage makes room, or the zero of the angle's sensor",
        ),
    ]


def estimates() -> list[Variable]:
    """Estimates of source measured; constant between the ticks of the feedback."""
    rows = [("estimate.payload_mass", "kg", "estimated mass of the load in drive.mode force")]
    rows += [
        (f"estimate.disturbance.{n}", "m/s2", f"estimated unknown acceleration of the {n}")
        for n in DRIVES
    ]
    rows += [
        (f"estimate.disturbance.load.{a}", "m/s2", f"estimated acceleration of the load, {a}")
        for a in "xy"
    ]
    rows.append(("estimate.rope_offset", "m", "estimated correction of the rope's measured length"))
    return [
        Variable(n, "Real", "output", "discrete", f"{text}; of source measured", unit=unit)
        for n, unit, text in rows
    ]


def nominal_from(value: Value) -> Crane:
    """The crane with the load that the feedback is designed for; `value` gives values by name."""
    own = Crane.of(value)
    expected = float(value("feedback.payload_mass"))
    return replace(own, payload_mass=backend.nominal_payload(expected, own.payload_mass))


def gains_from(value: Value, nominal: Crane, length: float) -> SwayFeedback:
    """Gains from the parameters, by `feedback.design`; `value` gives one by name.

    nominal: with the load that the feedback is designed for; length: of the rope at the start [m].

    Raises
    ------
    InputError
        For values without a design.
    """
    if DESIGNS.items[int(value("feedback.design")) - 1] == "lqr":
        return lqr_from(value, nominal, length)
    shortest, longest = rope_range(nominal, length)
    plant, chosen = filled(Plant, value), filled(FlatDesign, value)
    lags, late = _lateness(value, plant)
    return design_flat(
        nominal, sample_time=float(chosen[FlatDesign.PERIOD]), shortest=shortest, longest=longest,
        ratio=float(chosen[FlatDesign.BANDWIDTH]),
        hoist_ratio=float(chosen[FlatDesign.HOIST_BANDWIDTH]),
        damping=float(chosen[FlatDesign.DAMPING]), driven=_driven(plant), lag=lags, dead_time=late,
    )


def lqr_from(
    value: Value, nominal: Crane, length: float, rows: int = ROWS
) -> SwayFeedback:
    """The same of design lqr, whatever `feedback.design` is."""
    shortest, longest = rope_range(nominal, length)
    plant = filled(Plant, value)
    lags, late = _lateness(value, plant)
    return design(
        nominal, sample_time=float(value("feedback.sample_time")), shortest=shortest,
        longest=longest, weights=weights_from(value), driven=_driven(plant), lag=lags,
        dead_time=late, strongest=_strongest(plant), rows=rows,
    )


def gains_warning(value: Value, nominal: Crane, feedback: SwayFeedback) -> str | None:
    """What the user ought to know of gains that are unstable with the drives."""
    plant, fault = filled(Plant, value), np.zeros(SetupFault.SIZE)
    plant[Plant.PAYLOAD_MASS] = nominal.payload_mass
    status = backend.check_gains(
        plant, feedback.sample_time, int(value("feedback.source")) - 1,
        feedback.lengths[[0, -1]], feedback.table, np.zeros((LoopWork.SIZE, LoopWork.COLUMNS)),
        fault,
    )
    return None if status == SetupStatus.FITS else str(SETUP.text(status, fault.tolist()))


def tracking_from(
    value: Value, nominal: Crane, feedback: SwayFeedback
) -> TrackingController:
    """The controller from the parameters; `value` gives one by name.

    The observer is for the nominal crane and the rope lengths of the feedback.

    Raises
    ------
    InputError
        For inconsistent values.
    """
    plant, design, own = (filled(r, value) for r in (Plant, TrackingDesign, Tracking))
    least, greatest = _setpoints(plant)
    bridge, trolley, hoist = plant[Plant.LAG : Plant.LAG + Axes.SIZE].tolist()
    age = backend.signal_age(
        float(design[TrackingDesign.DEAD_TIME]), float(design[TrackingDesign.SAMPLING]),
        feedback.sample_time,
    )
    expected = build(Uncertainty, UNCERTAINTY, value)
    steps = expected.vector
    backend.set_steps(filled(Sensors, value), float(feedback.lengths[-1]), steps)
    position, length, angle = steps[: Expectations.DRIFT].tolist()
    observer = design_observer(
        nominal, sample_time=feedback.sample_time, shortest=float(feedback.lengths[0]),
        longest=float(feedback.lengths[-1]), driven=_driven(plant),
        lag=(bridge, trolley, hoist), delayed=age / feedback.sample_time,
        dead_time=dead_times(plant),
        uncertainty=replace(expected, position=position, length=length, angle=angle),
        strongest=_strongest(plant),
    )
    return TrackingController(
        observer, feedback, rejection=_rejection(own), lower=least, upper=greatest,
        velocity_max=plant[Plant.VELOCITY_MAX : Plant.VELOCITY_MAX + Axes.SIZE],
        velocity_min=plant[Plant.VELOCITY_MIN : Plant.VELOCITY_MIN + Axes.SIZE],
        power_max=plant[Plant.POWER_MAX : Plant.POWER_MAX + Axes.SIZE],
        fade=float(own[Tracking.FADE]), payload_time=float(design[TrackingDesign.PAYLOAD_TIME]),
        offset_cause=OFFSET_CAUSES[int(own[Tracking.OFFSET_CAUSE])],
        rope_offset=bool(own[Tracking.OFFSET_ACTS]), enabled=bool(own[Tracking.ENABLED]),
    )


def dead_times(plant: FloatArray) -> tuple[float, float, float]:
    """Those of the drives [s], from a `Plant`."""
    bridge, trolley, hoist = plant[Plant.DEAD_TIME : Plant.DEAD_TIME + Axes.SIZE].tolist()
    return bridge, trolley, hoist


def _driven(plant: FloatArray) -> bool:
    return bool(plant[Plant.MODE] == DriveMode.VELOCITY)


def _setpoints(plant: FloatArray) -> FloatArray:
    """Least and greatest setpoints of the drives, shape (2, 3) [N] or [m/s2], from a `Plant`."""
    return np.array([
        [sign * backend.drive_bound(plant, i, sign) for i in range(Axes.SIZE)]
        for sign in (-1.0, 1.0)
    ])


def _strongest(plant: FloatArray) -> FloatArray:
    """Largest setpoints of the drives in both directions, shape (3,) [N] or [m/s2]."""
    most: FloatArray = np.abs(_setpoints(plant)).min(axis=0)
    return most


def _lateness(value: Value, plant: FloatArray) -> tuple[FloatArray, float]:
    """Lags of the drives, and what signals and drives are late by [s]; `value` gives parameters."""
    lags = plant[Plant.LAG : Plant.LAG + Axes.SIZE]
    return lags, float(value("sensor.dead_time")) + max(dead_times(plant))


def tune(
    controller: TrackingController, value: Value, feedback: SwayFeedback | None
) -> None:
    """Take over the tunable parameters and new gains; what stays the same is no switching."""
    own = filled(Tracking, value)
    if feedback is not None:
        controller.feedback = feedback
    controller.fade = float(own[Tracking.FADE])
    controller.enabled = bool(own[Tracking.ENABLED])
    if controller.rejection != _rejection(own):
        controller.rejection = _rejection(own)


def _rejection(own: FloatArray) -> tuple[float, float]:
    return float(own[Tracking.REJECTED_DRIFT]), float(own[Tracking.REJECTED_WIND])
