"""Tables of a crane file: the sway feedback."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, StrictBool

from segfmu.validation.files.crane_models import usual_source
from segfmu.validation.files.keys import (
    NUMBER,
    Key,
    NotNegative,
    Positive,
    Quantity,
    Share,
    Table,
)


class WeightTable(Table):
    """Weights of the dimensionless LQR design."""

    position: Annotated[
        Positive | None,
        Key("carriage and rope position", "", ("feedback.weight.position",)),
    ] = None
    angle: Annotated[
        NotNegative | None, Key("sway angles", "", ("feedback.weight.angle",))
    ] = None
    velocity: Annotated[
        NotNegative | None,
        Key("carriage and rope velocity", "", ("feedback.weight.velocity",)),
    ] = None
    rate: Annotated[
        NotNegative | None, Key("sway rates", "", ("feedback.weight.rate",))
    ] = None
    effort: Annotated[Positive | None, Key("effort", "", ("feedback.weight.effort",))] = None


class RejectionTable(Table):
    """Shares of the estimated disturbances that are rejected."""

    carriage: Annotated[
        Share | None, Key("of carriages and rope", "", ("feedback.rejection.carriage",))
    ] = None
    load: Annotated[Share | None, Key("of the load", "", ("feedback.rejection.load",))] = None


class ObserverTable(Table):
    """What the observer expects."""

    position: Annotated[
        Quantity | None,
        Key("quantisation step of the carriages' positions", "m",
            ("feedback.observer.position",),
            "that of the sensors, or rope_max / 5000"),
    ] = None
    length: Annotated[
        Quantity | None,
        Key("quantisation step of the rope's length", "m", ("feedback.observer.length",),
            "that of the sensor, or rope_max / 5000"),
    ] = None
    angle: Annotated[
        Quantity | None,
        Key("quantisation step of the sway angles", "deg", ("feedback.observer.angle",),
            "that of the sensors, or 360 / 4096"),
    ] = None
    drift: Annotated[
        Quantity | None,
        Key("random walk of the unknown accelerations of carriages and rope: standard deviation "
            "after sqrt(l / g) over gravity", "", ("feedback.observer.drift",)),
    ] = None
    wind: Annotated[
        Quantity | None, Key("the same of the load's", "", ("feedback.observer.wind",))
    ] = None
    wake: Annotated[
        NotNegative | None,
        Key("quantisation steps between signal and reference at which corrections begin", "",
            ("feedback.observer.wake",)),
    ] = None
    offset: Annotated[
        NotNegative | None,
        Key("expected zero of the rope's sensor over the rope's length", "",
            ("feedback.observer.offset",)),
    ] = None


class ControllerTable(Table):
    """The sway feedback."""

    enabled: Annotated[StrictBool, Key("whether it acts", "", ("feedback.enabled",))] = True
    source: Annotated[
        Literal["state", "measured"] | None,
        Key("what it knows: the true state, or the measured signals", "", ("feedback.source",),
            usual_source()),
    ] = None
    design: Annotated[
        Literal["lqr", "flatness"],
        Key("gains of a linear-quadratic design, or in closed form", "", ("feedback.design",)),
    ] = "lqr"
    sample_time: Annotated[
        Annotated[float, Field(ge=1e-6, le=10.0), NUMBER] | None,
        Key("period", "s", ("feedback.sample_time",),
            "1, 2 or 5 of a decade up to 0.08 sqrt(rope_min / gravity), or whole samples of the "
            "sensors; 0.01 without rope_min"),
    ] = None
    bandwidth: Annotated[
        Quantity | None,
        Key("of design flatness: bandwidth over the pendulum's frequency", "",
            ("feedback.bandwidth",)),
    ] = None
    hoist_bandwidth: Annotated[
        Quantity | None,
        Key("of design flatness: bandwidth of the hoist over the pendulum's frequency", "",
            ("feedback.hoist_bandwidth",)),
    ] = None
    damping: Annotated[
        Quantity | None,
        Key("of design flatness: damping of all poles", "", ("feedback.damping",)),
    ] = None
    fade: Annotated[
        NotNegative | None,
        Key("time constant of the change when something is switched", "s", ("feedback.fade",)),
    ] = None
    payload_time: Annotated[
        Quantity | None,
        Key("time constant of the estimate of the load's mass", "s", ("feedback.payload_time",)),
    ] = None
    weight: Annotated[WeightTable, Key("weights of design lqr")] = WeightTable()
    offset_cause: Annotated[
        Literal["wind", "sensor"] | None,
        Key("what a lasting deviation of a sway angle is", "", ("feedback.offset_cause",)),
    ] = None
    rope_offset: Annotated[
        StrictBool | None,
        Key("whether the rope's measured length is corrected by the estimated offset", "",
            ("feedback.rope_offset",)),
    ] = None
    rejection: Annotated[
        RejectionTable, Key("rejected shares of estimated disturbances")
    ] = RejectionTable()
    observer: Annotated[ObserverTable, Key("what the observer expects")] = ObserverTable()
