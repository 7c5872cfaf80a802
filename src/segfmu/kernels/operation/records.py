"""Records of an operated motion."""

from segfmu.kernels.clearance.records import Box, ObstacleRow, Space, SpaceFault, SpaceLimits
from segfmu.kernels.crane.records import (
    DRIVES,
    Axes,
    Coordinates,
    Demand,
    DriveBounds,
    Resistance,
    RopeBounds,
    RopeWork,
    State,
    Vector,
)
from segfmu.kernels.planner.records import Axis, Lower, PlanOptions
from segfmu.kernels.records import Codes, Record, field
from segfmu.kernels.settling.records import LeadEnd

# by State
MEASURED = (
    "bridge.position",
    "trolley.position",
    "rope.length",
    "sway.x.angle",
    "sway.y.angle",
    "bridge.velocity",
    "trolley.velocity",
    "rope.velocity",
    "sway.x.rate",
    "sway.y.rate",
)


class OperationMode(Codes):
    """What the load does.

    MISSION: follows the plan that it has. INCHING: moves by a distance with each push. EMERGENCY:
    the carriages stop as fast as their drives can, and the load swings on; so they do while a drive
    has tripped.
    """

    MISSION = 0
    TARGET = 1
    VELOCITY = 2
    STOP = 3
    INCHING = 4
    EMERGENCY = 5


class OperationStatus(Codes):
    """What became of the last command that needed a plan.

    TAKEN: as it is; REDUCED: slower, or with some axes at rest. The others tell why the old plan
    goes on: what no plan for it keeps; PENDING: the command is new, the tries of a step are used
    up, and the next one tries others.
    """

    TAKEN = 0
    REDUCED = 1
    LIMITS = 2
    ROPE = 3
    WORKSPACE = 4
    OBSTACLE = 5
    DRIVES = 6
    PENDING = 7
    TRAVEL = 8


class Tries(Codes):
    """Plans that are tried for a command: in a step unless told otherwise, and of all steps."""

    USUAL = 3
    MOST = 9


class Attempt(Codes):
    """Plans that are tried for a command, in turn; see attempts.py.

    FULL: as it is. APART: to a target, upwards at first or downwards at last. SLOWER, SLOWEST: more
    slowly built up. PART: a part of the velocity. LEVEL, UPRIGHT: the horizontal axes or the
    vertical one alone. STOP and the two behind it: at rest. NONE: none was found. BLOCKED: FULL or
    a slower one, before an obstacle.
    """

    FULL = 0
    APART = 1
    SLOWER = 2
    SLOWEST = 3
    PART = 4
    LEVEL = 5
    UPRIGHT = 6
    STOP = 7
    STOP_SLOWER = 8
    STOP_SLOWEST = 9
    NONE = 10
    BLOCKED = 11


class ReadyStatus(Codes):
    """Why a feedforward cannot follow commands.

    PIECES: its plan has too many of them.
    """

    READY = 0
    DEAD_TIME = 1
    FRICTION = 2
    PIECES = 3


class ReadyFault(Record):
    """What is in the way of commands."""

    DRIVE = field("drive, from 0")
    VALUE = field("dead time [s], number of pieces, or measured rope length [m]")


class Command(Record):
    """What an operator wants, from a time on."""

    TIME = field("present time", "s")
    STEP = field("time until the next command can come", "s")
    MODE = field("see OperationMode", variables=("command.mode",), base=1)
    VELOCITY = field(
        "velocity of the load; its sign is the push of INCHING", "m/s", size=3,
        variables=[f"command.velocity.{a}" for a in "xyz"],
    )
    TARGET = field(
        "target of the load", "m", size=3, variables=[f"command.target.{a}" for a in "xyz"]
    )
    GO = field("1: go to the target, 0: stop", variables=("command.go",))
    SCALE = field("share of the velocity limits, 0 to 1", variables=("limits.scale",))
    DISTANCE = field(
        "way of a push", "m", size=3, variables=[f"command.distance.{a}" for a in "xyz"]
    )
    HOLD = field(
        "how long a velocity is held at least beyond the next command", "s",
        variables=("command.hold",),
    )
    TRIES = field(
        "plans that are tried in a step at most, one at least", variables=("command.tries",)
    )
    LEAD = field("how much later than the measured state the present time is", "s")
    TRIPPED = field(
        "1: the drive has tripped, its brake stops it",
        size=3,
        variables=[f"command.tripped.{d}" for d in DRIVES],
    )
    TAKE_OVER = field(
        "1: begin in the measured state, when it was 0 before", variables=("command.take_over",)
    )
    MEASURED = field(
        "state of the crane",
        "m, rad, m/s, rad/s",
        size=State.SIZE,
        variables=[f"measured.{name}" for name in MEASURED],
    )


class DriveBrakes(Record):
    """What stops a drive that has tripped."""

    DECELERATION = field(
        "deceleration of the brake, 0: the drive's greatest one",
        "m/s2",
        size=3,
        variables=[f"drive.{d}.brake_deceleration" for d in DRIVES],
    )


class Aim(Record):
    """What a command comes to."""

    IS_TARGET = field("1: VALUE is a position, 0: a velocity")
    VALUE = field("where to go, or how fast", "m or m/s", size=3)
    SCALE = field("share of the velocity limits")


class Progress(Record):
    """How far an operated motion is."""

    BEGIN = field("time at which the present plan begins", "s")
    STATUS = field("see OperationStatus")
    REFUSED = field("why the last attempt that failed did so, see OperationStatus")
    ATTEMPT = field("which one the present plan is, see Attempt")
    RETRY = field("when a command that was not taken as it is is tried again", "s")
    MODE = field("of the last command")
    PACE = field("of a plan that is built up more slowly, see attempts.py")
    STEEPNESS = field("of its ramps of the acceleration")
    SPEED = field("share of the velocity that it gets")
    APART = field("1: it is one along which the axes go apart")
    KEPT_PACE = field("pace of the present plan, 0: not known")
    KEPT_STEEPNESS = field("steepness of its ramps")
    NEXT = field("1 + the attempt with which the next step goes on, 0: with the first")
    FAILED = field("why the last attempt before that failed, see OperationStatus")
    RESTED = field(
        "step of the command for which plans were last tried, if the load rested; -1: it moved", "s"
    )
    BLOCKS = field("obstacles before which a way to be tried ends")
    PLANS = field("plans taken so far")
    ATTEMPTS = field("plans tried so far")
    TAKES = field("1: the step before took a measured state over, or tried to")


class HeldVelocity(Record):
    """How an axis holds a velocity before it stops."""

    VELOCITY = field("velocity", "m/s")
    UNTIL = field("until when it is held, since the start of the plan", "s")
    FREE = field("1: it can be held longer, 0: the axis stops at an end, or does not move")
    BEHIND = field("number of the pieces behind")


class Way(Record):
    """Between what an axis may come to rest."""

    LOW = field("the lowest position", "m")
    HIGH = field("the highest one", "m")


class Motion(Record):
    """State of an axis: its position and derivatives."""

    DERIVATIVES = field("by their order, up to the largest smoothness", size=7)


class Swing(Record):
    """Carriages of known accelerations, and the load that swings below them.

    ACTIVE, COVERED, LEFT, STAND, SWAY and TRIPPED are of an emergency stop.
    """

    ACTIVE = field("1: it is the present motion")
    COVERED = field("until when it is in the plan's pieces, since their start", "s")
    POSITION = field("of bridge and trolley, length of the rope", "m", size=3)
    VELOCITY = field("their rates", "m/s", size=3)
    ACCELERATION = field("rates of these, until they rest", "m/s2", size=3)
    JERK = field("rates of these, in a calming motion", "m/s3", size=3)
    SNAP = field("rates of these", "m/s4", size=3)
    LEFT = field("time until each rests", "s", size=3)
    PATH = field("from the suspension to the load", "m", size=3)
    RATE = field("its rate", "m/s", size=3)
    STAND = field("time from the stop's start until all rest", "s")
    SWAY = field("largest angle between rope and vertical from then on", "rad")
    TRIPPED = field("1: the brake of this drive is at work, as it has tripped", size=3)
    CALM = field("when the load rests whose swing has been taken over", "s")


class Control(Codes):
    """A calming motion: control points of a velocity, and intervals between its knots.

    DEGREE: of the splines. FREE: the first control point that the state at the start does not set.
    CONDITIONS: on those of an axis, of its swing and of where it rests. STEPS: most pieces of an
    interval, so that a plan has room for all of them; MANY: far more.
    """

    POINTS = 102
    DEGREE = 3
    FREE = 3
    SWING = 0
    PLACE = 2
    CONDITIONS = 3
    INTERVALS = 99
    STEPS = 4
    MANY = 1000


class ControlPoints(Record):
    """A cubic B-spline, or what belongs to each of its control points."""

    VALUES = field("by control point", size=Control.POINTS)


class Operation(Record):
    """Rows: an operated motion."""

    COMMAND = field("what is wanted", of=Command)
    AIM = field("what that comes to", of=Aim)
    BEFORE = field("the same of the step before", of=Aim)
    TAKEN = field("what the present plan is for", of=Aim)
    PROGRESS = field("how far it is", of=Progress)
    PUSHED = field("signs of the last pushes of INCHING", of=Vector)
    HELD = field("by axis, of the present plan", size=3, of=HeldVelocity)
    TRIED = field("the same of a plan that is tried", size=3, of=HeldVelocity)
    SHARE = field("share of its velocity that each axis gets", of=Vector)
    WAYS = field("by axis, of the present plan", size=3, of=Way)
    TRIED_WAYS = field("the same of a plan that is tried", size=3, of=Way)
    NOW = field("by axis: the present state", size=3, of=Motion)
    WISH = field("velocity that is tried", "m/s", of=Vector)
    LOWER = field("by axis: limits in the negative direction, as tried", size=3, of=Lower)
    LEAD_ENDS = field("by axis: where a velocity is reached", size=3, of=LeadEnd)
    STOP_ENDS = field("by axis: where it comes to rest from there", size=3, of=LeadEnd)
    SWING = field("an emergency stop, at the start of its pieces", of=Swing)
    AHEAD = field("the same at a later time", of=Swing)
    ASIDE = field("the one before, while a motion from another state is tried", of=Swing)
    SPLINE = field("velocities of a calming motion", "m/s", size=3, of=ControlPoints)


class Known(Record):
    """Rows: what is known of a crane and its space."""

    CRANE = field("masses, gravity and friction", of=Resistance)
    ROPE = field("its range", of=RopeBounds)
    BOUNDS = field("of the drives", of=DriveBounds)
    BRAKES = field("of the drives", of=DriveBrakes)
    SPACE = field("of the load", of=Space)
    OPTIONS = field("how targets are planned", of=PlanOptions)
    LOWER = field("by axis: limits in the negative direction", size=3, of=Lower)
    OBSTACLES = field("obstacles", size=SpaceLimits.OBSTACLES, of=ObstacleRow)


class Slot(Codes):
    """Plans in the arrays of an operated motion, and the entries of `offsets` of each."""

    PRESENT = 0
    REST = 1
    LEADS = 2
    BEHIND = 3
    TRIED = 4
    NONE = 5
    COUNT = 6
    OFFSETS = 4
    AXES = 3


class OperationRows(Codes):
    """Most pieces of a plan that is taken, and rows of a slot: leads need as many beside it."""

    KEPT = 1200
    ALL = 3604


class Column(Record):
    """A polynomial of the rope's proof, at the largest smoothness."""

    VALUES = field("coefficients", size=43)


class Range(Record):
    """A quantity in an interval of time: between CENTRE - RADIUS and CENTRE + RADIUS."""

    CENTRE = field("centre")
    RADIUS = field("radius")


class Reach(Record):
    """Rows: ranges of what a motion does in an interval of time."""

    POSITION = field("position of the load", size=3, of=Range)
    VELOCITY = field("its velocity", size=3, of=Range)
    ACCELERATION = field("its acceleration", size=3, of=Range)
    JERK = field("its jerk", size=3, of=Range)
    SNAP = field("its snap", size=3, of=Range)
    PULL = field("w_z = z'' + g", of=Range)
    SLOPE = field("w_x / w_z and w_y / w_z", size=2, of=Range)
    SLOPE_RATE = field("their rates", size=2, of=Range)
    SLOPE_CHANGE = field("rates of these", size=2, of=Range)
    STRETCH = field("rope length over depth", of=Range)
    STRETCH_RATE = field("its rate", of=Range)
    STRETCH_CHANGE = field("rate of this", of=Range)
    PRODUCT = field("intermediate result", of=Range)
    SUM = field("another one", of=Range)
    DEMAND = field("what it asks of the drives", size=Demand.SIZE, of=Range)


class SwingTerms(Codes):
    """Terms of a swinging load's series, and the pieces of an axis."""

    CONSTANT = 0
    LINEAR = 1
    QUADRATIC = 2
    CUBIC = 3
    QUARTIC = 4
    COUNT = 14
    # pieces of an axis: in a long step, and those at least, which few steps use up
    PIECES = 300
    SPARE = 100
    # looks at the drives: in a swing, and in a stop at most
    SWING = 63
    LONGEST = 20000


class FlatOrder(Codes):
    """Derivatives of the load's position that the flat inverse uses."""

    POSITION = 0
    VELOCITY = 1
    ACCELERATION = 2
    COUNT = 5


class OperationWork(Record):
    """Rows: work space."""

    ROPE = field("of the checks of rope and space", size=RopeWork.SIZE, of=Column)
    BOXES = field("boxes", size=SpaceLimits.FACES + SpaceLimits.OBSTACLES, of=Box)
    RANGES = field("ranges of load and rope", size=6, of=Vector)
    FAULT = field("where a path meets something", of=SpaceFault)
    TIMES = field("waypoint times, by axis", size=3, of=Vector)
    DWELLS = field("at start and target", of=Vector)
    AXES = field("the axes", size=3, of=Axis)
    PIECE = field("a piece of an axis", of=Column)
    REACH = field("ranges", size=Reach.SIZE, of=Range)
    PATH = field("series of the way from the suspension to a load that swings", size=3, of=Column)
    PULL = field("that of the rope's pull over the load's mass and the rope's length", of=Column)
    SQUARE = field("that of the rope's length, squared", of=Column)
    FREE = field("series of two free swings", size=2, of=Column)
    CONTROL = field("velocities of bridge, trolley and hoist", "m/s", size=3, of=ControlPoints)
    MOMENT = field("what a change of the velocity does to these swings", size=2, of=ControlPoints)
    SLOPE = field(
        "derivatives of the conditions by control point", size=Control.CONDITIONS, of=ControlPoints
    )
    DIAGONAL = field("second derivatives of a barrier", of=ControlPoints)
    COUPLING = field("those by neighbours", of=ControlPoints)
    AIM = field("of the conditions", "m/s and m", of=Vector)
    CHANGE = field(
        "Newton's steps, free and by condition", size=1 + Control.CONDITIONS, of=ControlPoints
    )
    SCHUR = field("what these do to the conditions", size=Control.CONDITIONS, of=Vector)
    LACK = field("what the conditions lack", size=Control.CONDITIONS, of=Vector)
    FLAT = field("position of the load and four derivatives", size=5, of=Vector)
    FORCE = field("forces of the drives", of=Axes)
    STATE = field("state of the crane", of=State)
    ACCELERATION = field("second derivatives of its coordinates", of=Coordinates)
