"""The crane file: everything that is known of a crane, in the user's units.

The first tables are what planner, FMUs and controller design need of every crane. All others
describe what is real about it; without them it is ideal. A `Key` names the parameters of
GantryCrane that take its value.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field, StrictBool

from segfmu.crane.checks import LARGEST_SEED
from segfmu.kernels.rig.records import Disturbance
from segfmu.validation.keys import (
    AXES,
    NUMBER,
    RANGE,
    SWAY,
    Key,
    NotNegative,
    NotNegativeTriple,
    Number,
    Pair,
    Positive,
    PositivePair,
    Quantity,
    Share,
    Table,
    Triple,
    printable,
)

SwayPair = Annotated[
    list[Annotated[float, Field(ge=1e-3, le=89.0), NUMBER]], Field(min_length=2, max_length=2)
]
Seed = Annotated[int, Field(ge=0, le=LARGEST_SEED, strict=True)]
STOPPED = ("bridge", "trolley", "rope")
IDEAL = "the drive is ideal"
NO_BOUND = "no bound is known"


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
        Positive | None,
        Key("greatest velocity", "m/s", ("drive.{}.velocity_max",), NO_BOUND),
    ] = None
    acceleration_max: Annotated[
        Positive | None,
        Key("greatest acceleration", "m/s2", ("drive.{}.acceleration_max",), NO_BOUND),
    ] = None
    force_max: Annotated[
        Positive | None, Key("greatest force", "N", ("drive.{}.force_max",), NO_BOUND)
    ] = None
    power_max: Annotated[
        Positive | None,
        Key("greatest power, driving or braking", "W", ("drive.{}.power_max",), NO_BOUND),
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


class LoadChange(Table):
    """A change of the load's mass during a run."""

    time: Annotated[Number, Key("time of the change", "s", ("payload[{}].time",))]
    mass: Annotated[Quantity, Key("mass from then on", "kg", ("payload[{}].mass",))]


class LoadTable(Table):
    """The load beside its mass."""

    mass_range: Annotated[
        PositivePair | None,
        Key("least and greatest mass of the load; `payload_mass` has to be within", "kg", (),
            "any", parts=RANGE),
    ] = None
    drag_area: Annotated[
        NotNegative | None,
        Key("drag coefficient times area, on which the air's speed acts", "m2",
            ("load.drag_area",), "none"),
    ] = None
    changes: Annotated[
        list[LoadChange],
        Key("changes of the mass during a run", "", ("payload.count",), slot="{}"),
        Field(max_length=Disturbance.MOST_CHANGES),
    ] = []


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
            ("feedback.observer.position",)),
    ] = None
    length: Annotated[
        Quantity | None,
        Key("quantisation step of the rope's length", "m", ("feedback.observer.length",)),
    ] = None
    angle: Annotated[
        Quantity | None,
        Key("quantisation step of the sway angles", "deg", ("feedback.observer.angle",)),
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
        Literal["state", "measured"],
        Key("what it knows: the true state, or the measured signals", "", ("feedback.source",)),
    ] = "state"
    design: Annotated[
        Literal["lqr", "flatness"],
        Key("gains of a linear-quadratic design, or in closed form", "", ("feedback.design",)),
    ] = "lqr"
    sample_time: Annotated[
        Annotated[float, Field(ge=1e-6, le=10.0), NUMBER] | None,
        Key("period", "s", ("feedback.sample_time",)),
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


class GustTable(Table):
    """One gust."""

    start: Annotated[Number, Key("start", "s", ("wind.gust.start",))] = 0.0
    duration: Annotated[Positive, Key("duration", "s", ("wind.gust.duration",))]
    shape: Annotated[
        Literal["cosine", "sine"],
        Key("1 - cosine, or half a sine", "", ("wind.gust.shape",)),
    ] = "cosine"
    force: Annotated[
        Triple | None,
        Key("peak of the force", "N", tuple(f"wind.gust.force.{a}" for a in AXES), "none",
            parts=AXES),
    ] = None
    speed: Annotated[
        Triple | None,
        Key("peak of the air's speed", "m/s", tuple(f"wind.gust.speed.{a}" for a in AXES), "none",
            parts=AXES),
    ] = None


class WindNoiseTable(Table):
    """Random wind."""

    deviation: Annotated[
        NotNegativeTriple,
        Key("standard deviations", "N",
            tuple(f"wind.noise.deviation.{a}" for a in AXES), parts=AXES),
    ]
    bandwidth: Annotated[
        Quantity, Key("greatest frequency", "Hz", ("wind.noise.bandwidth",))
    ] = 1.0
    seed: Annotated[Seed, Key("of the noise", "", ("wind.noise.seed",))] = 0


class TurbulenceTable(Table):
    """Turbulence of the air, with Davenport's spectrum; it needs a mean speed."""

    deviation: Annotated[
        NotNegativeTriple,
        Key("standard deviations", "m/s", tuple(f"wind.turbulence.deviation.{a}" for a in AXES),
            parts=AXES),
    ]
    length: Annotated[
        Annotated[Number, Field(ge=1e-3)],
        Key("length scale", "m", ("wind.turbulence.length",)),
    ] = 1200.0
    bandwidth: Annotated[
        Quantity, Key("greatest frequency", "Hz", ("wind.turbulence.bandwidth",))
    ] = 1.0
    seed: Annotated[Seed, Key("of the turbulence", "", ("wind.turbulence.seed",))] = 0


class WindTable(Table):
    """Wind on the load: forces, and the speed of the air, which acts on its drag area."""

    constant: Annotated[
        Triple | None,
        Key("constant force", "N",
            tuple(f"wind.constant.{a}" for a in AXES), "none", parts=AXES),
    ] = None
    gust: Annotated[GustTable | None, Key("one gust", default="none")] = None
    noise: Annotated[WindNoiseTable | None, Key("random wind", default="none")] = None
    speed: Annotated[
        Triple | None,
        Key("mean speed of the air", "m/s", tuple(f"wind.speed.{a}" for a in AXES), "none",
            parts=AXES),
    ] = None
    turbulence: Annotated[
        TurbulenceTable | None, Key("turbulence of the air", default="none")
    ] = None
    air_density: Annotated[
        NotNegative | None, Key("density of the air", "kg/m3", ("wind.air_density",))
    ] = None


class CraneFile(Table):
    """A crane."""

    name: Annotated[
        Annotated[str, Field(max_length=100), AfterValidator(printable)],
        Key("title of the crane"),
    ] = "crane"
    bridge_mass: Annotated[
        Quantity,
        Key("mass of the bridge, which moves in x together with the trolley", "kg",
            ("crane.bridge_mass",)),
    ]
    trolley_mass: Annotated[
        Quantity,
        Key("mass of the trolley, which moves in y on the bridge", "kg", ("crane.trolley_mass",)),
    ]
    payload_mass: Annotated[Quantity, Key("mass of the load", "kg", ("crane.payload_mass",))]
    gravity: Annotated[
        Annotated[float, Field(ge=1e-3, le=1e3), NUMBER],
        Key("acceleration of gravity", "m/s2", ("crane.gravity",)),
    ] = 9.81
    rope_min: Annotated[
        Quantity | None,
        Key("shortest rope of a plan", "m", ("crane.rope_min",), "no bound", none=(0.0,)),
    ] = None
    rope_max: Annotated[
        Quantity | None,
        Key("longest rope of a plan", "m", ("crane.rope_max",), "no bound", none=(0.0,)),
    ] = None
    drive: Annotated[
        Literal["force", "velocity"],
        Key("what all drives follow: force setpoints or velocity setpoints", "", ("drive.mode",)),
    ] = "force"
    sway_max: Annotated[
        SwayPair | None,
        Key("greatest sway angles of a plan", "deg", (), NO_BOUND, parts=SWAY),
    ] = None
    bridge: Annotated[DriveTable, Key("drive of the bridge")] = DriveTable()
    trolley: Annotated[DriveTable, Key("drive of the trolley")] = DriveTable()
    hoist: Annotated[DriveTable, Key("drive of the hoist")] = DriveTable()
    travel: Annotated[TravelTable, Key("end stops")] = TravelTable()
    friction: Annotated[FrictionTable, Key("friction")] = FrictionTable()
    sensors: Annotated[SensorTable, Key("sensors")] = SensorTable()
    load: Annotated[LoadTable, Key("the load")] = LoadTable()
    controller: Annotated[ControllerTable, Key("the sway feedback")] = ControllerTable()
    wind: Annotated[WindTable, Key("wind on the load")] = WindTable()
