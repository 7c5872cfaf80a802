"""Records of the search for limits within the bounds of the drives."""

from segfmu.kernels.crane.records import Demand
from segfmu.kernels.records import Codes, Record, field


class Pace(Record):
    """State of the search for the pace at which a motion just keeps the bounds."""

    PACE = field("pace to try; 1: the motion as it is given", variables=("plan.pace",))
    MOST = field("largest pace that is allowed")
    FULL = field("use of a bound that is enough")
    KEEPS = field("largest pace that is known to keep the bounds, 0: none")
    EXCEEDS = field("least pace that is known to exceed them; 1e300: none")
    KEPT_USE = field("largest use of a bound at the pace that keeps them")
    EXCEEDED_USE = field("largest use of a bound at the pace that exceeds them")
    LAST = field("the pace before this one, 0: none")
    LAST_USE = field("largest use of a bound at it")
    TRIALS = field("paces tried so far")


class LimitRow(Record):
    """Limits of an axis as magnitudes; those of the negative direction are the last ones."""

    VELOCITY = field("velocity", "m/s")
    ACCELERATION = field("acceleration", "m/s2")
    JERK = field("jerk", "m/s3")
    SNAP = field("snap", "m/s4")
    VELOCITY_MIN = field("velocity in the negative direction", "m/s")
    ACCELERATION_MIN = field("acceleration in the negative direction", "m/s2")


def _found(axis: str) -> list[str]:
    """Variables of the limits of an axis that a plan has."""
    names = ("velocity", "acceleration", "jerk", "snap", "velocity_min", "acceleration_min")
    return [f"plan.limits.{axis}.{name}" for name in names]


class PlanLimits(Record):
    """Limits of the load that a plan has, a `LimitRow` per axis; least ones are below 0."""

    X = field("along x", size=LimitRow.SIZE, variables=_found("x"))
    Y = field("along y", size=LimitRow.SIZE, variables=_found("y"))
    Z = field("along z", size=LimitRow.SIZE, variables=_found("z"))


class AxisTask(Record):
    """What limits of an axis are searched for."""

    MOVES = field("1 if the axis moves, else 0")
    DISTANCE = field("largest distance between two waypoints", "m")
    FASTEST = field("largest velocity at a waypoint", "m/s")
    GOES = field("1 if the drive goes in the positive, and in the negative direction", size=2)
    DIRECTED = field("1 if velocity, and acceleration, have limits by direction", size=2)
    FARTHEST = field("greatest place at a waypoint, and minus the least one", "m", size=2)
    HELD = field("dry friction that the drive overcomes, and weight that it carries", "N", size=2)
    FLOOR = field("least limits, which admit the given states", size=LimitRow.SIZE)
    CAP = field("largest limits, 1e300: none", size=LimitRow.SIZE)


class Heading(Record):
    """Order and direction of the free states that are searched for."""

    LAST = field("last place, counted from 0")
    TIME = field("1: the first place comes first, -1: the last one")
    AXIS = field("sign of an acceleration whose unknown is positive", size=3)


class Starts(Codes):
    """How many starts a search has, and from how many of them it descends, the shortest ones."""

    COUNT = 16
    DESCENTS = 4


class LimitStatus(Codes):
    """Why limits cannot be searched for.

    UNBOUNDED: nothing bounds the acceleration of an axis. SLOW_VELOCITY, SLOW_ACCELERATION: a bound
    so small that the clock is too coarse for the ramps.
    """

    FOUND = 0
    UNBOUNDED = 1
    SLOW_VELOCITY = 2
    SLOW_ACCELERATION = 3


class LimitFault(Record):
    """Where limits cannot be searched for."""

    AXIS = field("axis, counted from 0")
    DRIVE = field("the same, as a drive")
    SIDE = field("1 in the negative direction")
    VALUE = field("the bound")


class SearchStage(Codes):
    """What the trial of a search is for.

    START: a start, at a pace. ENTER: the point that a descent goes on from, at a pace. POLL: a free
    state of it, changed. SLOPE: an unknown of it, changed. STEP: a step from it, at a pace.
    """

    START = 0
    ENTER = 1
    POLL = 2
    SLOPE = 3
    STEP = 4


class Search(Record):
    """Rows: a search for limits, with the numbers of its state in the first one.

    Limits are logarithms, free states shares of their limits.
    """

    STATE = field("see `SearchState`")
    PACE = field("the `Pace` of a sequence of trials", of=Pace)
    TRIAL = field("what to try next")
    ORIGIN = field("the start of a descent; what follows is relative to it")
    CENTRE = field("where it is")
    BASE = field("the point of a sequence of paces")
    KEPT = field("the shortest of its plans that keep the bounds")
    STEP = field("step to the next point")
    BEST = field("the shortest plan of all, not relative")
    CHOSEN = field("starts that descents begin from, not relative", size=Starts.DESCENTS)
    DURATIONS = field("their durations, from the shortest one on")
    KIND = field("of the unknowns, an `Unknown`")
    ORDER = field("power of the pace that a limit grows with")
    FREE = field("1 for unknowns whose slopes are known")


class Unknown(Codes):
    """What an unknown is."""

    GIVEN = 0
    LIMIT = 1
    STATE = 2


class SearchState(Record):
    """Numbers of the state of a search; durations are logarithms, 1e300 where there is no plan."""

    STAGE = field("a `SearchStage`")
    UNKNOWNS = field("how many unknowns there are")
    START = field("start or descent, counted from 0")
    UNKNOWN = field("unknown that is changed, counted from 0")
    WAY = field("how it is changed, counted from 0")
    TRIALS = field("plans of a sequence of paces")
    FAILURES = field("those that cannot be made")
    STEPS = field("steps of a descent")
    ROUND = field("rounds of polls and descents")
    RADIUS = field("largest change of an unknown in a step")
    PREDICTED = field("gain that a step promises")
    KEPT = field("duration of the row KEPT")
    BEST = field("duration of the row BEST")
    BEFORE = field("what it was before a round")
    WANTED = field("duration below which a plan is of use to a poll or a sequence of paces")
    STALE = field("1: slopes are those of another point, corrected")


class Values(Record):
    """Duration and uses of the bounds at a point."""

    DURATION = field("logarithm of the duration")
    USE = field("uses of the bounds, the positive direction first", size=2 * Demand.SIZE)


class SearchValues(Record):
    """Rows: the values at points of a search."""

    CENTRE = field("where it is", of=Values)
    KEPT = field("the shortest of a sequence of paces", of=Values)
