"""Records of a crane whose load hangs by a sling on a hook."""

from segfmu.kernels.control.records import Doubling
from segfmu.kernels.crane.records import (
    AXES,
    DRIVES,
    Coordinates,
    FlatSeries,
    Masses,
    RopeBounds,
    Vector,
)
from segfmu.kernels.records import Codes, Record, field


class HookModel(Codes):
    """Its code as `Resistance.SUSPENSION`, and the derivatives that its flat inverse needs."""

    CODE = 1
    ORDERS = 7


class HookMasses(Masses):
    """Masses and gravity, hook and sling."""

    HOOK_MASS = field("mass of the hook", "kg", variables=("hook.mass",))
    SLING = field("length of the sling, from hook to load", "m", variables=("hook.sling",))


class HookCoordinates(Coordinates):
    """Generalised coordinates; angles of the rope are those of the hook below the trolley."""

    SLING_ANGLE = field(
        "angles of the sling against the vertical, as those of the rope", "rad", size=2,
        variables=("sling.x.angle", "sling.y.angle"),
    )


class HookState(HookCoordinates):
    """State of crane, hook and load."""

    VELOCITY = field(
        "rates of the positions", "m/s", size=3,
        variables=("bridge.velocity", "trolley.velocity", "rope.velocity"),
    )
    RATE = field(
        "rates of the rope's angles", "rad/s", size=2, variables=("sway.x.rate", "sway.y.rate")
    )
    SLING_RATE = field(
        "rates of the sling's angles", "rad/s", size=2, variables=("sling.x.rate", "sling.y.rate")
    )


class HookInverse(Record):
    """Results of the flat inverse."""

    FORCE = field(
        "forces of the drives", "N", size=3, variables=[f"force.{d}" for d in DRIVES]
    )
    STATE = field(
        "state of crane, hook and load", size=HookState.SIZE, of=HookState,
        variables=[f"reference.{v}" for f in HookState.FIELDS.values() for v in f.variables],
    )
    ACCELERATION = field(
        "second derivatives of the coordinates", size=HookCoordinates.SIZE,
        variables=[*(f"reference.{a}.acceleration" for a in AXES), *("",) * 4],
    )


class HookFeedforward(HookInverse):
    """What feedforward gives a crane with hook and sling: velocities as setpoints as well."""

    VELOCITY = field(
        "velocities of the drives", "m/s", size=3, variables=[f"velocity.{d}" for d in DRIVES]
    )


class HookFrequencies(Record):
    """Natural frequencies of small swings while the carriages rest."""

    SLOW = field("hook and load swing to the same side", "rad/s")
    FAST = field("hook and load swing to opposite sides", "rad/s")


class HookMotion(Record):
    """Rows: motion of the load that belongs to a state of the crane."""

    POSITION = field("position", "m", of=Vector)
    VELOCITY = field("velocity", "m/s", of=Vector)
    ACCELERATION = field("acceleration", "m/s2", of=Vector)
    JERK = field("jerk", "m/s3", of=Vector)


class HookTension(Record):
    """Force of the hoist, and how it changes."""

    FORCE = field("force that lengthens the rope, below 0", "N")
    RATE = field("its derivative by time", "N/s")


class HookLinks(Record):
    """Rows: the work space of `hook_load_motion`, vectors of rope and sling."""

    ROPE = field("unit vector from the hook to the trolley", of=Vector)
    ROPE_RATE = field("its derivative by time", "1/s", of=Vector)
    SLING = field("unit vector from the load to the hook", of=Vector)
    SLING_RATE = field("its derivative by time", "1/s", of=Vector)
    RELATIVE = field("second derivative of the unit vector of the sling", "1/s2", of=Vector)


class HookMargins(Record):
    """What must not become negative, in the order of its proof."""

    TAUT = field("upward force of the rope per mass of hook and load", "m/s2")
    BELOW = field("depth of the hook below the trolley", "m")
    SHORT = field("shortness of the rope; large without a bound", "m")
    LONG = field("length of the rope beyond the shortest one; large without a bound", "m")


class SlingSeries(FlatSeries):
    """Rows: the work space of `hook_derivatives`, a Taylor series each."""

    DIRECTION = field("direction from the load to the hook", size=3)
    SLING = field("angles of the sling", "rad", size=2)


class HookPath(SlingSeries):
    """Rows: the work space of `check_hook`."""

    MOTION = field("position of the load and four derivatives", size=5, of=Vector)
    FREE = field("bounds without lengths", of=RopeBounds)
    SAMPLES = field("margins at the last three samples", size=3, of=HookMargins)
    FIRST = field("first times of negative margins; 1e300: there is none", of=HookMargins)
    LEAST = field("least margins", of=HookMargins)


class Sling(Record):
    """State of the sling."""

    ANGLE = field(
        "angles against the vertical", "rad", size=2, variables=("sling.x.angle", "sling.y.angle")
    )
    RATE = field("their rates", "rad/s", size=2, variables=("sling.x.rate", "sling.y.rate"))


class SlingReference(Record):
    """Reference of the sling's state."""

    ANGLE = field(
        "angles", "rad", size=2, variables=("reference.sling.x.angle", "reference.sling.y.angle")
    )
    RATE = field(
        "their rates", "rad/s", size=2,
        variables=("reference.sling.x.rate", "reference.sling.y.rate"),
    )


class SlingAccelerations(Record):
    """Derivatives of the sling's rates, as variables of model exchange."""

    ANGLE = field(
        "of the angles", "rad/s2", size=2,
        variables=("sling.x.acceleration", "sling.y.acceleration"),
    )


class HookOutputs(Sling):
    """What an FMU of the crane shows of hook and sling."""

    POSITION = field(
        "position of the hook", "m", size=3, variables=[f"hook.position.{a}" for a in "xyz"]
    )
    VELOCITY = field(
        "velocity of the hook", "m/s", size=3, variables=[f"hook.velocity.{a}" for a in "xyz"]
    )
    TENSION = field("tension of the sling", "N", variables=("sling.tension",))
    FREQUENCY = field(
        "natural frequencies at rest, see HookFrequencies", "rad/s", size=2,
        variables=("sway.frequency.slow", "sway.frequency.fast"),
    )


class HookAxis(Record):
    """States of an axis in the feedback, deviations from the reference, and its input.

    Signs of angles are such that they move the load along the axis. The hoist has no angles.
    """

    POSITION = field("position of the carriage, or length of the rope", "m")
    ANGLE = field("angle of the rope", "rad")
    SLING = field("angle of the sling", "rad")
    VELOCITY = field("rate of the position", "m/s")
    RATE = field("rate of the rope's angle", "rad/s")
    SLING_RATE = field("rate of the sling's angle", "rad/s")
    DRIFT = field("unknown acceleration of the carriage or the rope", "m/s2")
    COMMAND = field("velocity command of a drive with lag", "m/s")
    CORRECTION = field("correction: a force or an acceleration")


class HookAxisTable(Record):
    """Rows: model and gains of an axis at a rope length."""

    TRANSITION = field(
        "states after a period, by states and correction", size=HookAxis.CORRECTION, of=HookAxis
    )
    GAINS = field("minus the correction, by the states", of=HookAxis)
    POSITION_GAIN = field("changes of the estimate by the measured position", of=HookAxis)
    ANGLE_GAIN = field("the same by the measured angle of the rope", of=HookAxis)


class HookTable(Record):
    """Rows: feedback at a rope length, which is in the first place."""

    LENGTH = field("length of the rope", "m", of=HookAxis)
    AXES = field("bridge, trolley, hoist", size=3 * HookAxisTable.SIZE, of=HookAxis)


class HookWeighing(Record):
    """Weights of the designs, dimensionless."""

    POSITION = field("carriage's position", variables=("feedback.hook.position",))
    ANGLE = field("both angles", variables=("feedback.hook.angle",))
    VELOCITY = field("velocity of carriage and rope", variables=("feedback.hook.velocity",))
    RATE = field("rates of both angles", variables=("feedback.hook.rate",))
    EFFORT = field("effort", variables=("feedback.hook.effort",))
    ROPE = field("rope's length", variables=("feedback.hook.rope",))
    PUSH = field(
        "acceleration of the carriage that the observer expects, over gravity",
        variables=("feedback.hook.push",),
    )
    SWING = field(
        "acceleration of the load that it expects, over gravity",
        variables=("feedback.hook.swing",),
    )
    DRIFT = field(
        "walk of the unknown acceleration over gravity, in sqrt(L / g)",
        variables=("feedback.hook.drift",),
    )
    NOISE = field(
        "errors of the signals over L, and of the angles", variables=("feedback.hook.noise",)
    )


class HookDesign(Doubling):
    """Rows: work space of the design."""

    SPREAD = field("solution X of a Riccati equation", size=HookAxis.CORRECTION)
    MODEL = field("derivatives by states and input", size=HookAxis.SIZE)
    MOVED = field("states and input after a period", size=HookAxis.SIZE)
    TERM = field("term of a series", size=HookAxis.SIZE)
    RESULT = field("its product with the model", size=HookAxis.SIZE)


class HookLimits(Record):
    """Setpoints that the drives can follow."""

    LEAST = field("least forces or accelerations", size=3)
    GREATEST = field("greatest ones", size=3)
    SLOWEST = field("least velocities of drives that corrections accelerate", "m/s", size=3)
    FASTEST = field("greatest ones", "m/s", size=3)
    PERIOD = field("period of the corrections", "s")
