"""Records of the crane and its equipment. Triples are bridge, trolley and rope, or x, y and z."""

from typing import Any

from segfmu.kernels.numerics.records import Stages
from segfmu.kernels.records import Codes, Record, field

DRIVES = ("bridge", "trolley", "hoist")
AXES = ("bridge", "trolley", "rope")


def _load(name: str) -> list[str]:
    """Variables of a derivative of the load's position."""
    return [f"reference.load.{name}.{a}" for a in "xyz"]


def _of_drives(meaning: str, unit: str, variable: str) -> Any:
    """A field with an entry for each drive; `{}` in the variable stands for the drive's name."""
    return field(meaning, unit, size=len(DRIVES), variables=[variable.format(d) for d in DRIVES])


class DriveMode(Codes):
    """What the drives follow."""

    FORCE = 0
    VELOCITY = 1


class GustShape(Codes):
    """Force of a gust over its duration: 1 - cosine, or half a sine."""

    COSINE = 0
    SINE = 1


class SlackRope(Codes):
    """What a rope does that would have to push: an error, or the load falls freely."""

    ERROR = 0
    FREE_FALL = 1


class PlantStatus(Codes):
    """How an advance of the crane ended."""

    DONE = 0
    SWAY_ANGLE = 1
    ROPE_LENGTH = 2
    STEP_TOO_SMALL = 3
    NOT_FINITE = 4
    SLACK_ROPE = 5
    # and the two behind it: trolley and rope
    BELOW_TRAVEL = 6
    ABOVE_TRAVEL = 9
    SLACK_SLING = 12


class RopeFault(Record):
    """Where a trajectory does not meet a demand."""

    TIME = field("from when on it is not met", "s")
    WORST = field("worst value after that: height, acceleration downwards or length")
    BOUND = field("its bound")


class PlantFault(Record):
    """What went wrong with the crane."""

    TIME = field("when", "s")
    AXIS = field("axis at its end stop, from 0")
    POSITION = field("its position, or length of the rope", "m")
    STOP = field("its end stop", "m")
    SWAY = field("angle at the end of its range: both of the rope, then of the sling, from 0")
    ANGLE = field("its value", "rad")


class Axes(Record):
    """A triple of the axes."""

    BRIDGE = field("bridge, along x")
    TROLLEY = field("trolley, along y")
    ROPE = field("rope or hoist")


class Vector(Record):
    """A triple of the directions in space."""

    X = field("along x")
    Y = field("along y")
    Z = field("upwards")


class Coordinates(Record):
    """Generalised coordinates of the crane."""

    POSITION = field(
        "positions of bridge and trolley, length of the rope", "m", size=3,
        variables=("bridge.position", "trolley.position", "rope.length"),
    )
    ANGLE = field(
        "sway angles phi_x, phi_y", "rad", size=2, variables=("sway.x.angle", "sway.y.angle")
    )


class State(Coordinates):
    """State of the crane."""

    VELOCITY = field(
        "rates of the positions", "m/s", size=3,
        variables=("bridge.velocity", "trolley.velocity", "rope.velocity"),
    )
    RATE = field(
        "rates of the sway angles", "rad/s", size=2, variables=("sway.x.rate", "sway.y.rate")
    )


class PlantState(State):
    """State of the crane, contacts that rub, works since the start, sling and slack rope."""

    DEFLECTION = _of_drives(
        "deflections of the contacts, see `friction_force`", "m", "friction.{}.deflection"
    )
    DRIVE_WORK = field("work of the drives", "J")
    WIND_WORK = field("work of the wind", "J")
    DISSIPATED = field("energy dissipated by friction", "J")
    SLING_ANGLE = field("angles of the sling; 0 without one", "rad", size=2)
    SLING_RATE = field("their rates", "rad/s", size=2)
    SLACK = field("1: the rope is slack, and the next two are not 0")
    PAID_OUT = field("length of the slack rope", "m")
    PAYING_OUT = field("its rate", "m/s")


class Masses(Record):
    """Masses and gravity."""

    BRIDGE_MASS = field("mass of the bridge", "kg", variables=("crane.bridge_mass",))
    TROLLEY_MASS = field("mass of the trolley", "kg", variables=("crane.trolley_mass",))
    PAYLOAD_MASS = field("mass of the load", "kg", variables=("crane.payload_mass",))
    GRAVITY = field("gravity", "m/s2", variables=("crane.gravity",))


class Resistance(Masses):
    """Masses, friction of the axes and lags of their drives; 0 where an effect is absent."""

    VISCOUS = _of_drives("viscous friction", "N.s/m", "friction.{}.viscous")
    COULOMB = _of_drives("Coulomb friction", "N", "friction.{}.coulomb")
    STATIC = _of_drives("static friction; 0: as Coulomb friction", "N", "friction.{}.static")
    DRAG = _of_drives(
        "friction at 1 m/s that grows with the square of the velocity", "N", "friction.{}.drag"
    )
    FRICTION_WIDTH = field(
        "velocity at which static friction has fallen to Coulomb friction but for 1/e", "m/s",
        variables=("friction.width",),
    )
    PRESLIDING = field(
        "displacement at which a contact slides", "m", variables=("friction.presliding",)
    )
    LAG = _of_drives("time constants of the velocity loops", "s", "drive.{}.lag")
    SUSPENSION = field("what is between rope and load, by the code of a model; 0: nothing")
    TACKLE_MASS = field("its mass", "kg")
    SLING = field("its length, of the sling from the rope's end to the load", "m")


class Plant(Resistance):
    """Parameters of the crane with its drives; 0 where a bound or an effect is absent."""

    MODE = field("what the drives follow, see DriveMode", variables=("drive.mode",), base=1)
    FORCE_MAX = _of_drives("largest forces of the drives", "N", "drive.{}.force_max")
    FORCE_MIN = _of_drives(
        "least forces, below 0; 0: minus the largest ones", "N", "drive.{}.force_min"
    )
    ACCELERATION_MAX = _of_drives(
        "largest accelerations by velocity drives", "m/s2", "drive.{}.acceleration_max"
    )
    ACCELERATION_MIN = _of_drives(
        "least accelerations, below 0; 0: minus the largest ones",
        "m/s2", "drive.{}.acceleration_min"
    )
    VELOCITY_MAX = _of_drives("largest velocities of the drives", "m/s", "drive.{}.velocity_max")
    VELOCITY_MIN = _of_drives(
        "least velocities, below 0; 0: minus the largest ones", "m/s", "drive.{}.velocity_min"
    )
    POWER_MAX = _of_drives(
        "largest powers of the drives, driving or braking", "W", "drive.{}.power_max"
    )
    DEAD_TIME = _of_drives("from the command to the drive", "s", "drive.{}.dead_time")
    SWAY_DAMPING = field(
        "viscous damping of both sway angles", "N.m.s", variables=("friction.sway.viscous",)
    )
    TRAVEL_MIN = field(
        "least positions", "m", size=3, variables=[f"travel.{a}.min" for a in AXES]
    )
    TRAVEL_MAX = field(
        "greatest positions", "m", size=3, variables=[f"travel.{a}.max" for a in AXES]
    )
    STIFFNESS = field(
        "stiffness of the buffers at both end stops; 0: none", "N/m", size=3,
        variables=[f"travel.{a}.stiffness" for a in AXES],
    )
    DAMPING = field(
        "damping of the buffers", "N.s/m", size=3,
        variables=[f"travel.{a}.damping" for a in AXES],
    )
    WIND = field("constant wind", "N", size=3, variables=[f"wind.constant.{a}" for a in "xyz"])
    GUST_START = field("start of the gust", "s", variables=("wind.gust.start",))
    GUST_DURATION = field("duration of the gust", "s", variables=("wind.gust.duration",))
    GUST_SHAPE = field(
        "force of the gust over time, see GustShape", variables=("wind.gust.shape",), base=1
    )
    GUST_FORCE = field(
        "greatest force of the gust", "N", size=3,
        variables=[f"wind.gust.force.{a}" for a in "xyz"],
    )
    WIND_SPEED = field(
        "mean speed of the air", "m/s", size=3, variables=[f"wind.speed.{a}" for a in "xyz"]
    )
    GUST_SPEED = field(
        "greatest speed that the gust adds", "m/s", size=3,
        variables=[f"wind.gust.speed.{a}" for a in "xyz"],
    )
    DRAG_AREA = field(
        "drag coefficient of the load times its area", "m2", variables=("load.drag_area",)
    )
    AIR_DENSITY = field("density of the air", "kg/m3", variables=("wind.air_density",))
    SLACK = field(
        "what a rope does that would have to push, see SlackRope", variables=("rope.slack",),
        base=1,
    )


class Compensation(Record):
    """What feedforward knows of the drives."""

    LAG = _of_drives("time constants of the velocity loops", "s", "drive.{}.lag")
    DEAD_TIME = _of_drives("from setpoint to drive", "s", "drive.{}.dead_time")


class FlatInverse(Record):
    """Results of the flat inverse."""

    FORCE = field(
        "forces of the drives", "N", size=3, variables=[f"force.{d}" for d in DRIVES]
    )
    STATE = field(
        "state of the crane", size=State.SIZE, of=State,
        variables=[f"reference.{v}" for f in State.FIELDS.values() for v in f.variables],
    )
    ACCELERATION = field(
        "second derivatives of the coordinates", size=Coordinates.SIZE,
        variables=[*(f"reference.{a}.acceleration" for a in AXES), "", ""],
    )


class Feedforward(FlatInverse):
    """What feedforward gives a crane: results of the flat inverse, and velocities as setpoints."""

    VELOCITY = field(
        "velocities of the drives", "m/s", size=3, variables=[f"velocity.{d}" for d in DRIVES]
    )


class Demand(Record):
    """What a motion asks of the drives, and how far the rope sways in it."""

    FORCE = field("forces of the drives; the hoist's is negative under tension", "N", size=3)
    VELOCITY = field("velocity setpoints of bridge, trolley and rope", "m/s", size=3)
    ACCELERATION = field("accelerations of bridge, trolley and rope", "m/s2", size=3)
    POWER = field("powers of the drives, positive when they do work", "W", size=3)
    PLACE = field("positions of bridge and trolley, length of the rope", "m", size=3)
    SWAY = field("sway angles", "rad", size=2)


class DriveBounds(Record):
    """Bounds in the order of `Demand`, 0: none; then those of the negative directions.

    The latter are below 0; 0: minus those of the positive direction. But for places: both ends are
    those of the travel, none where they are far away or the same.
    """

    FORCE_MAX = _of_drives("largest forces of the drives", "N", "drive.{}.force_max")
    VELOCITY_MAX = _of_drives("largest velocities of the drives", "m/s", "drive.{}.velocity_max")
    ACCELERATION_MAX = _of_drives(
        "largest accelerations of the drives", "m/s2", "drive.{}.acceleration_max"
    )
    POWER_MAX = _of_drives(
        "largest powers of the drives, driving or braking", "W", "drive.{}.power_max"
    )
    TRAVEL_MAX = field(
        "greatest positions", "m", size=3, variables=[f"travel.{a}.max" for a in AXES]
    )
    SWAY_MAX = field(
        "largest sway angles", "rad", size=2, variables=[f"sway.{a}.angle_max" for a in "xy"]
    )
    FORCE_MIN = _of_drives("least forces", "N", "drive.{}.force_min")
    VELOCITY_MIN = _of_drives("least velocities", "m/s", "drive.{}.velocity_min")
    ACCELERATION_MIN = _of_drives("least accelerations", "m/s2", "drive.{}.acceleration_min")
    TRAVEL_MIN = field("least positions", "m", size=3, variables=[f"travel.{a}.min" for a in AXES])


# what is bounded, in the order of `Demand`
BOUNDED = (
    *(f"{d}.{q}" for q in ("force", "velocity", "acceleration", "power") for d in DRIVES),
    *(f"travel.{a}" for a in AXES), "sway.x", "sway.y",
)


class BoundUses(Record):
    """What a plan uses of the bounds, in the order of `Demand`; 0 without a bound."""

    USE = field(
        "largest use of the bounds", size=Demand.SIZE,
        variables=[f"plan.use.{name}" for name in BOUNDED],
    )
    TIME = field(
        "when, since the start of the plan", "s", size=Demand.SIZE,
        variables=[f"plan.use.{name}_time" for name in BOUNDED],
    )


class BoundStatus(Codes):
    """Which bound a plan exceeds most."""

    KEPT = 0
    FORCE = 1
    VELOCITY = 2
    ACCELERATION = 3
    POWER = 4
    TRAVEL = 5
    SWAY = 6


class BoundFault(Record):
    """Where a plan exceeds a bound of the drives."""

    DRIVE = field("bridge, trolley or hoist, counted from 0; of the sway its axis")
    AXIS = field("the same, as an axis of the load")
    STOPPED = field("the same, as what its end stops hold")
    SIDE = field("1 where the negative direction has a bound of its own, and exceeds it")
    VALUE = field("what the plan needs")
    BOUND = field("bound")
    TIME = field("when, since the start of the plan", "s")


class FlatSeries(Record):
    """Rows: the work space of `flat_derivatives`, a Taylor series each."""

    LOAD = field("position of what hangs on the rope", "m", size=3)
    PULL = field("force of the rope per mass of the load; of a gantry crane w = p'' + g e_z",
                 "m/s2", size=3)
    INTERMEDIATE = field("intermediate results", size=7)
    COORDINATES = field("coordinates of the crane", size=Coordinates.SIZE)


class MostSeries(FlatSeries):
    """Rows: the work space of any model's flat inverse."""

    OWN = field("series of the model", size=5)


class FlatOrders(Codes):
    """Derivatives of the load's position in the flat inverse, that of order 0 included."""

    CRANE = 5
    # of any model
    MOST = 7


class DemandWork(Record):
    """Rows: the work space of `drive_demands`, parts of a `FlatInverse`."""

    FORCE = field("forces of the drives", "N", of=Axes)
    STATE = field("state of the crane", of=State)
    ACCELERATION = field("second derivatives of the coordinates", of=Coordinates)
    SERIES = field("Taylor series, where the model needs them", size=MostSeries.SIZE, of=State)


class Sought(Codes):
    """How peaks of the demands are sought."""

    # Chebyshev points of an interval, halvings at most, points among which a peak is sought
    NODES = 17
    HALVINGS = 12
    GRID = 65


class ChebyshevNodes(Record):
    """Values at Chebyshev points."""

    VALUE = field("value at each of them", size=Sought.NODES)


class DemandPeaks(DemandWork):
    """Rows: the work space of `demand_peaks`."""

    LOAD = field(
        "position of the load and its derivatives", size=FlatOrders.MOST, of=Vector
    )
    VALUES = field("demands at Chebyshev points", size=Sought.NODES, of=Demand)
    SERIES = field("coefficients of their Chebyshev series", size=Sought.NODES, of=Demand)
    TAILS = field("last coefficients after each halving", size=Sought.HALVINGS + 1, of=Demand)
    SCALE = field("magnitudes relative to which they are resolved", of=Demand)
    CANDIDATE = field("demands where a peak may be", of=Demand)
    NEAR = field("rows of the pieces of each axis at the time before", of=Axes)
    TRANSFORM = field(
        "from values to coefficients", size=Sought.NODES, of=ChebyshevNodes
    )


class Contact(Record):
    """A row of a contact's history along a plan: it turns, comes to rest or leaves it."""

    TIME = field("from when on, since the start of the plan", "s")
    POSITION = field("position of bridge or trolley, or length of the rope, then", "m")
    DEFLECTION = field("deflection of the contact then", "m")
    RELEASED = field("at rest: time in which the contact is released; 0: it moves", "s")
    BEGUN = field("from when on friction changes with the velocity, before", "s")
    SLIDES = field("when the contact begins to slide, or is released", "s")
    SETTLED = field("until when friction changes much", "s")


class History(Record):
    """How far the history of a contact is known."""

    AXIS = field("the axis, see Axes")
    COUNT = field("rows so far, 0: there is no room for more")
    DIRECTION = field("-1, 1: direction of the motion, 0: at rest so far")


class ContactWork(DemandWork):
    """Rows: the work space of `contact_history`."""

    HISTORY = field("how far it is known", of=History)
    RESISTANCE = field("the crane", of=Resistance)
    LOAD = field("position of the load and its derivatives", size=FlatOrders.MOST, of=Vector)


class FrictionSeries(Record):
    """Rows: the work space of `friction_derivative`, a Taylor series each."""

    VELOCITY = field("velocity of the axis", "m/s")
    SHARE = field("deflection of the contact over that at which it slides")
    LEVEL = field("dry friction at the velocity", "N")
    DAMPED = field("damping of the contact over the dry friction")
    REST = field("share of the contact that does not slide")
    PRODUCT = field("intermediate results", size=3)
    FRICTION = field("friction", "N")


class LoadMotion(Record):
    """Position of the load and its derivatives, triples of the directions in space."""

    POSITION = field("position", "m", size=3, variables=_load("position"))
    VELOCITY = field("velocity", "m/s", size=3, variables=_load("velocity"))
    ACCELERATION = field("acceleration", "m/s2", size=3, variables=_load("acceleration"))
    JERK = field("jerk", "m/s3", size=3, variables=_load("jerk"))
    SNAP = field("snap", "m/s4", size=3, variables=_load("snap"))


class Load(Record):
    """Rows: motion of the load along x, y and z."""

    POSITION = field("position", "m", of=Vector)
    VELOCITY = field("velocity", "m/s", of=Vector)


class GeneralisedForce(Record):
    """Forces on the coordinates; the rope's is negative under tension."""

    FORCE = field("on bridge, trolley and along the rope", "N", size=3)
    TORQUE = field("on the sway angles", "N.m", size=2)


class CommandRates(Record):
    """Coefficients of the time elapsed in the commands of the drives."""

    LINEAR = field("of the time", size=3)
    SQUARE = field("of its square", size=3)
    CUBE = field("of its cube", size=3)


class Action(Record):
    """What acts on the crane."""

    FORCE = field("forces of the drives, friction included", "N", size=3)
    SATURATED = field("1: the drive is at a bound", size=3)
    ROPE_FORCE = field("force on the rope, negative under tension", "N")
    SLING_TENSION = field("tension of the sling; 0 without one", "N")


class StageAction(Action):
    """What acts at a stage of a step."""

    SATURATED_BEFORE = field("SATURATED at the step's start", size=3)


class Report(Action):
    """What acted at the end of an interval; SATURATED: at some time in it."""

    WIND_POWER = field("power of the wind", "W")
    FRICTION_POWER = field("power that friction dissipates", "W")
    ELAPSED = field("time advanced", "s")
    STEP_SATURATED = field("1: the drive was at a bound in the communication step", size=3)


class ForceLimit(Record):
    """Work space of the drives at their largest force or velocity."""

    SIDE = field("-1, 1: the drive is at its bound, 0: it is not", size=3)
    CHANGE = field("change of its acceleration", "m/s2", size=3)
    ROPE = field("direction of the rope in the coordinates of the drives", size=3)
    BOUND = field("largest force at the present velocity, 0: no bound", "N", size=3)
    LOWER = field("the same of forces below 0, as a magnitude", "N", size=3)
    ADDED = field("force that holds a drive at its largest velocity", "N", size=3)
    MASS = field("mass that resists along the rope", "kg")


class Air(Record):
    """The air around the load, triples of the directions in space."""

    RELATIVE = field("its velocity relative to the load", "m/s", size=3)
    RATE = field("derivative of its velocity by time", "m/s2", size=3)
    FORCE_RATE = field("derivative of the wind's force by time", "N/s", size=3)


class Work(Record):
    """Rows: the commands of an interval, and the plant's work space."""

    COMMAND = field("forces, velocities or accelerations at the start of the interval", of=Axes)
    RATES = field("how they change in it", of=CommandRates)
    LOAD_FORCE = field("force on the load at the start of the interval", "N", of=Vector)
    LOAD_RATES = field("how it changes in it", of=CommandRates)
    STAGES = field("derivatives of the state", size=Stages.SIZE, of=PlantState)
    TRIAL = field("state to which the step that is tried leads", of=PlantState)
    STEP = field("step to try first, 0: the whole interval; kept for the next call", "s")
    GENERALISED = field("generalised forces", of=GeneralisedForce)
    ACTION = field("what acts", of=StageAction)
    WIND = field("force of the wind on the load", "N", of=Vector)
    LOAD = field("motion of the load", size=Load.SIZE, of=Load)
    DEMAND = field("commands of the drives, then their accelerations", of=Axes)
    FRICTION = field("resistance: friction, and buffers at the end stops", "N", of=Axes)
    LIMIT = field("drives at their largest force", of=ForceLimit)
    AIR = field("air around the load", of=Air)
    OWN_STATE = field("state in the order of the model's equations", of=PlantState)
    OWN_RATE = field("its derivative", of=PlantState)
    OWN_MASSES = field("masses and lengths of the model's equations", of=Resistance)
    OWN_TENSION = field("tension of the sling", "N")


class CranePartials(State):
    """Columns: what the partial derivatives of the crane's equations are by."""

    DRIVE = field("forces on bridge, trolley and rope, or their accelerations", size=3)
    TORQUE = field("torques on the sway angles", size=2)
    WIND = field("forces on the load", size=3)


class DrivenPartials(Record):
    """Rows of the partial derivatives for given accelerations of the drives."""

    ANGLE = field("accelerations of the sway angles", size=2)
    FORCE = field("forces of the drives", size=3)


class LoadPartials(Record):
    """Rows of the partial derivatives of the load."""

    POSITION = field("position", size=3)
    VELOCITY = field("velocity", size=3)


class RopeDemand(Codes):
    """Demands on the rope, in the order of their proof: each relies on those before it."""

    MET = 0
    BELOW_TROLLEY = 1
    TAUT = 2
    NOT_TOO_LONG = 3
    NOT_TOO_SHORT = 4
    # of all that hangs on a rope with a sling below it, and of the rope's end
    ALL_TAUT = 5
    END_BELOW_TROLLEY = 6


class RopeBounds(Record):
    """What the proof about the rope needs of a crane."""

    GRAVITY = field("gravity", "m/s2", variables=("crane.gravity",))
    SHORTEST = field("shortest rope, 0: no bound", "m", variables=("crane.rope_min",))
    LONGEST = field("longest rope, 0: no bound", "m", variables=("crane.rope_max",))


class RopeWork(Record):
    """Rows: the work space of `check_rope`, polynomials in an interval's local time, and hulls.

    The last two columns of a hull hold where it starts and how often it was halved.
    """

    LOAD = field("position of the load", "m", size=3)
    PULL = field("w = p'' + g e_z", "m/s2", size=3)
    DEMAND = field("polynomial that must not become negative")
    PRODUCTS = field("its parts", size=3)
    HULLS = field("Bernstein coefficients of parts of the interval", size=42)
