"""Tables of a crane file: drives, travel, friction, sensors."""

from __future__ import annotations

from typing import Annotated, Literal

from segfmu.validation.files.keys import (
    NO_BOUND,
    RANGE,
    Bound,
    Key,
    LowerBound,
    NotNegative,
    NotNegativeTriple,
    Number,
    Pair,
    Quantity,
    Seed,
    Table,
)

STOPPED = ("bridge", "trolley", "rope")
IDEAL = "the drive is ideal"


class DriveTable(Table):
    """Drive of one axis; its bounds hold in every plan."""

    lag: Annotated[
        NotNegative | None,
        Key("time constant of the velocity loop", "s", ("drive.{}.lag",), IDEAL),
    ] = None
    dead_time: Annotated[
        NotNegative | None,
        Key("from the command to the drive", "s", ("drive.{}.dead_time",), IDEAL),
    ] = None
    velocity_max: Annotated[
        Bound | None,
        Key("greatest velocity", "m/s", ("drive.{}.velocity_max",), NO_BOUND),
    ] = None
    velocity_min: Annotated[
        LowerBound | None,
        Key("least velocity, below 0; the hoist lifts with it", "m/s", ("drive.{}.velocity_min",),
            "minus `velocity_max`"),
    ] = None
    acceleration_max: Annotated[
        Bound | None,
        Key("greatest acceleration", "m/s2", ("drive.{}.acceleration_max",), NO_BOUND),
    ] = None
    acceleration_min: Annotated[
        LowerBound | None,
        Key("least acceleration, below 0", "m/s2", ("drive.{}.acceleration_min",),
            "minus `acceleration_max`"),
    ] = None
    force_max: Annotated[
        Bound | None, Key("greatest force", "N", ("drive.{}.force_max",), NO_BOUND)
    ] = None
    force_min: Annotated[
        LowerBound | None,
        Key("least force, below 0; the hoist pulls with it", "N", ("drive.{}.force_min",),
            "minus `force_max`"),
    ] = None
    power_max: Annotated[
        Bound | None,
        Key("greatest power, driving or braking", "W", ("drive.{}.power_max",), NO_BOUND),
    ] = None
    brake_deceleration: Annotated[
        Bound | None,
        Key("deceleration of the brake that stops it if it trips", "m/s2",
            default="that of the drive"),
    ] = None


class TravelTable(Table):
    """End stops: least and greatest position."""

    bridge: Annotated[
        Pair | None,
        Key("of the bridge", "m", ("travel.bridge.min", "travel.bridge.max"), "no end stops",
            parts=RANGE),
    ] = None
    trolley: Annotated[
        Pair | None,
        Key("of the trolley", "m", ("travel.trolley.min", "travel.trolley.max"), "no end stops",
            parts=RANGE),
    ] = None
    rope: Annotated[
        Pair | None,
        Key("of the rope's length", "m", ("travel.rope.min", "travel.rope.max"), "no end stops",
            parts=RANGE),
    ] = None
    stiffness: Annotated[
        NotNegativeTriple | None,
        Key("stiffness of the buffers; 0: reaching the end stop is an error", "N/m",
            tuple(f"travel.{a}.stiffness" for a in STOPPED), "no buffers", parts=STOPPED),
    ] = None
    damping: Annotated[
        NotNegativeTriple | None,
        Key("damping of the buffers", "N s/m", tuple(f"travel.{a}.damping" for a in STOPPED),
            "none", parts=STOPPED),
    ] = None
    slack: Annotated[
        Literal["error", "free_fall"],
        Key("a rope that would have to push: an error, or free fall until it is taut again", "",
            ("rope.slack",)),
    ] = "error"


class AxisFriction(Table):
    """Friction of one axis."""

    viscous: Annotated[
        NotNegative | None, Key("viscous friction", "N s/m", ("friction.{}.viscous",), "none")
    ] = None
    coulomb: Annotated[
        NotNegative | None, Key("Coulomb friction", "N", ("friction.{}.coulomb",), "none")
    ] = None
    static: Annotated[
        NotNegative | None,
        Key("static friction", "N", ("friction.{}.static",), "as Coulomb friction"),
    ] = None
    drag: Annotated[
        NotNegative | None,
        Key("friction that grows with the square of the velocity, at 1 m/s", "N",
            ("friction.{}.drag",), "none"),
    ] = None


class SwayFriction(Table):
    """Damping of the sway."""

    viscous: Annotated[
        NotNegative | None,
        Key("damping of both sway angles", "N m s", ("friction.sway.viscous",), "none"),
    ] = None


class FrictionTable(Table):
    """Friction of axes and sway."""

    bridge: Annotated[AxisFriction, Key("friction of the bridge")] = AxisFriction()
    trolley: Annotated[AxisFriction, Key("friction of the trolley")] = AxisFriction()
    hoist: Annotated[AxisFriction, Key("friction of the hoist")] = AxisFriction()
    sway: Annotated[SwayFriction, Key("damping of the sway")] = SwayFriction()
    width: Annotated[
        Quantity | None,
        Key("velocity over which static friction falls to Coulomb friction", "m/s",
            ("friction.width",)),
    ] = None
    presliding: Annotated[
        Quantity | None,
        Key("displacement at which a contact begins to slide", "m", ("friction.presliding",)),
    ] = None


class LengthSignal(Table):
    """Sensor of a position or of the rope's length."""

    resolution: Annotated[
        NotNegative | None, Key("quantisation step", "m", ("sensor.{}.resolution",), "none")
    ] = None
    noise: Annotated[
        NotNegative | None,
        Key("standard deviation of every sample; needs a sample time", "m",
            ("sensor.{}.deviation",), "none"),
    ] = None
    zero: Annotated[
        Number | None, Key("measured minus true value", "m", ("sensor.{}.offset",))
    ] = None


class AngleSignal(Table):
    """Sensor of a sway angle."""

    resolution: Annotated[
        NotNegative | None, Key("quantisation step", "deg", ("sensor.{}.resolution",), "none")
    ] = None
    noise: Annotated[
        NotNegative | None,
        Key("standard deviation of every sample; needs a sample time", "deg",
            ("sensor.{}.deviation",), "none"),
    ] = None
    zero: Annotated[
        Number | None, Key("measured minus true value", "deg", ("sensor.{}.offset",))
    ] = None


class SensorTable(Table):
    """Sensors of the five measured signals."""

    sample_time: Annotated[
        NotNegative | None, Key("period", "s", ("sensor.sample_time",), "continuous")
    ] = None
    dead_time: Annotated[
        NotNegative | None,
        Key("from sampling to the signal; needs a sample time", "s", ("sensor.dead_time",), "none"),
    ] = None
    seed: Annotated[Seed | None, Key("seed of the noise", "", ("sensor.seed",))] = None
    bridge: Annotated[
        LengthSignal, Key("position of the bridge", slot="bridge.position")
    ] = LengthSignal()
    trolley: Annotated[
        LengthSignal, Key("position of the trolley", slot="trolley.position")
    ] = LengthSignal()
    rope: Annotated[
        LengthSignal, Key("length of the rope", slot="rope.length")
    ] = LengthSignal()
    sway_x: Annotated[
        AngleSignal, Key("sway angle phi_x", slot="sway.x.angle")
    ] = AngleSignal()
    sway_y: Annotated[
        AngleSignal, Key("sway angle phi_y", slot="sway.y.angle")
    ] = AngleSignal()
