"""Records of the planner: an axis, its boundary problems, phases, and the work space."""

from segfmu.kernels.records import Codes, Record, field


class Shape(Codes):
    """Shapes of an acceleration ramp (parameters.py)."""

    SMOOTHSTEP = 0
    PLATEAU = 1


class Synchronization(Codes):
    """Where the axes of a plan meet."""

    NONE = 0
    WAYPOINTS = 1
    TOTAL = 2


class PlanStatus(Codes):
    """What became of a plan; below zero it is refused, and `Refusal` says where.

    START_BRAKING, END_BRAKING: braking the first, building up the last acceleration passes the
    velocity limit. NO_PROFILE, NO_COMMON_DURATION: none was found. DURATION_TOO_SHORT,
    DURATION_IN_GAP: of the duration asked for. WAYPOINT_VELOCITY, WAYPOINT_ACCELERATION: a waypoint
    is beyond the limit. UNBOUNDED_RAMP: no limit bounds a ramp. MOVING_DWELL: a dwell at a waypoint
    that moves. OUT_OF_RANGE: of the C function alone, sizes or choices out of range. CHECK_FAILED:
    a plan that does not pass its check. NO_VELOCITY_LIMIT, NO_ACCELERATION_LIMIT: of
    `check_problem`. SAMPLE_TIME: too short or too long for doubles. MORE_PIECES: planned, but with
    more pieces than the arrays have rows.
    """

    MORE_PIECES = 1
    PLANNED = 0
    START_BRAKING = -1
    END_BRAKING = -2
    NO_PROFILE = -3
    NO_COMMON_DURATION = -4
    DURATION_TOO_SHORT = -5
    DURATION_IN_GAP = -6
    WAYPOINT_VELOCITY = -7
    WAYPOINT_ACCELERATION = -8
    UNBOUNDED_RAMP = -9
    MOVING_DWELL = -10
    OUT_OF_RANGE = -11
    CHECK_FAILED = -12
    NO_VELOCITY_LIMIT = -14
    NO_ACCELERATION_LIMIT = -15
    SAMPLE_TIME = -16


class Braking(Codes):
    """What `braked` returns in place of a number of phases.

    START_FAILS and END_FAILS are the plan's status START_BRAKING and END_BRAKING; NOT_NEEDED: an
    acceleration that shall be braked is zero.
    """

    START_FAILS = -1
    END_FAILS = -2
    NOT_NEEDED = -3


class Effort(Codes):
    """How many ways of planning an axis are tried.

    QUICK: without levels next to one ramp, where many plans are compared that differ by little.
    THOROUGH: passing profiles also have the starts and ways that take long.
    """

    USUAL = 0
    QUICK = 1
    THOROUGH = 2


class Weight(Codes):
    """In place of the share of the second of two averaged profiles, where there are none.

    UNBRAKED: an acceleration at an end cannot be braked.
    """

    MISSING = -1
    UNBRAKED = -2


class Way(Codes):
    """Ways in which `timed_profile` looks for profiles, in the order in which they are tried.

    TURNED is added where the time is reversed. ANY: all of them.
    """

    SMOOTH = 0
    WAITING = 1
    RAMPS = 2
    PASSING = 3
    PASSING_USUAL = 4
    PASSING_PLAIN = 5
    EXTREMES = 6
    DIPPED = 7
    TURNING = 8
    TURNED = 9
    ANY = -1


class Rises(Codes):
    """How steep the rises of the ramps are (parameters.py).

    USUAL: as smoothness asks. MODERATE, STEEPEST: where the limits leave no room for those.
    """

    USUAL = 0
    MODERATE = 1
    STEEPEST = 2


class PlanOptions(Record):
    """How to plan."""

    SMOOTHNESS = field(
        "n, 2 to 6: how often the trajectory is continuously differentiable",
        variables=("planner.smoothness",),
    )
    SHAPE = field("of the ramps, see Shape", variables=("planner.shape",), base=1)
    SYNCHRONIZATION = field(
        "of the axes, see Synchronization", variables=("planner.synchronization",), base=1
    )
    SAMPLE_TIME = field(
        "intervals and dwells last a multiple of it; 0: any time", "s",
        variables=("planner.sample_time",),
    )
    DURATION = field("in total; 0: the shortest", "s", variables=("planner.duration",))


def _limits(axis: str) -> list[str]:
    """Variables of the limits of an axis, from the velocity on."""
    return [f"limits.{axis}.{n}" for n in ("velocity", "acceleration", "jerk", "snap")]


class LoadLimits(Record):
    """Limits of a load's velocity, acceleration, jerk and snap along each axis; 0 where absent."""

    X = field("limits c_1 .. c_4 along x", size=4, variables=_limits("x"))
    Y = field("limits c_1 .. c_4 along y", size=4, variables=_limits("y"))
    Z = field("limits c_1 .. c_4 along z", size=4, variables=_limits("z"))


def _lower(axis: str) -> list[str]:
    """Variables of the limits of an axis in the negative direction."""
    return [f"limits.{axis}.{n}_min" for n in ("velocity", "acceleration")]


class LowerLimits(Record):
    """Limits of a load's velocity and acceleration in the negative direction; 0: as in the other.

    Unlike in `Lower` they are below zero.
    """

    X = field("along x", size=2, variables=_lower("x"))
    Y = field("along y", size=2, variables=_lower("y"))
    Z = field("along z", size=2, variables=_lower("z"))


class Lower(Record):
    """Limits of an axis in the negative direction, as magnitudes; 0: as in the positive one."""

    VELOCITY = field("of the velocity", "m/s")
    ACCELERATION = field("of the acceleration", "m/s2")


class WaypointState(Record):
    """WaypointState of one axis at a waypoint."""

    POSITION = field("position", "m")
    VELOCITY = field("velocity", "m/s")
    ACCELERATION = field("acceleration", "m/s2")


class DelayedState(WaypointState):
    """State of one axis at a waypoint that it leaves later than the others."""

    DELAY = field("at the first waypoint: time before the axis is in its state", "s")


class Axis(Record):
    """Limits of one axis, and the parameters of its ramps (parameters.py)."""

    SMOOTHNESS = field("n, 2 to 6")
    SHAPE = field("of the ramps, see Shape")
    VELOCITY = field("velocity limit c_1, in the positive direction", "m/s")
    ACCELERATION = field("acceleration limit c_2, in the positive direction", "m/s2")
    JERK = field("limits c_3 .. c_7 of the jerk and what follows; 0 where absent", size=5)
    LOWER = field("the first two in the negative direction, see Lower", size=2)
    RAISED = field("order of the derivative that takes the place of the position: 0 but in leads")
    EFFORT = field("how many ways are tried, see Effort")
    FULL_RAMP = field("duration of the ramp from zero to the larger acceleration limit", "s")
    PLATEAU = field("1 where the ramps are plateau ramps, else 0")
    LINEAR_FROM = field("change from which the duration is linear; 1e300: none", "m/s2")
    LINEAR_SLOPE = field("slope of the duration there", "s3/m")
    LINEAR_RATE = field("its inverse: the steepest jerk", "m/s3")
    LINEAR_CONSTANT = field("constant of the duration there", "s")
    SQUARE = field("plateau: duration^2 over a change below, of the snap alone; else 0", "s4/m")
    SQUARE_RATE = field("its inverse", "m/s4")
    RISES = field("plateau: rise of the jerk .. to its limit; 1e60: has none", "s", size=5)
    SHARES = field("plateau: least share of that rise in the rise it belongs to", size=5)
    POWERS = field("smoothstep: q_e; a ramp lasts (q_e change)^(1/e) at least", size=5)
    VARIANCE = field("where one number suffices: variance V of the jerk over duration^2; else 0")
    INNER_VARIANCE = field("part of the rises within, where the duration is linear", "s2")
    ABOVE = field("plateau: order of the derivative whose levels passing profiles have, less 2")
    CURVE_SIZE = field("smoothstep: number of coefficients of the transition polynomial")
    CURVE = field("smoothstep: transition polynomial, ascending powers", size=10)


class Problem(Record):
    """Boundary problem of one axis: from (0, V, A) to (DISTANCE, W, B)."""

    V = field("velocity at the start", "m/s")
    A = field("acceleration at the start", "m/s2")
    W = field("velocity at the end", "m/s")
    B = field("acceleration at the end", "m/s2")
    DISTANCE = field("position at the end less that at the start", "m")
    DURATION = field("duration that a profile of prescribed duration takes", "s")


class Phase(Record):
    """A ramp of the acceleration or, where it does not change, a hold.

    In a passing profile (passing.py) it is one of a derivative above.
    """

    DURATION = field("duration", "s")
    BASIS = field("duration of the fastest ramp of these proportions; 0: hold", "s")
    ACCELERATION = field("acceleration, or that derivative, at the start", "m/s2")
    CHANGE = field("change of the acceleration, or of that derivative", "m/s2")
    ABOVE = field("order of the derivative less 2; 0: the acceleration")


class LoopArc(Codes):
    """Arcs of profiles of two levels (loop.py).

    LOOP: around the single ramp. FIRST, LAST: a stretched ramp after the first, before the last
    one. FLAT_FIRST, FLAT_LAST: with the proportions of the fastest ramp of that duration instead.
    SINGLE: one ramp, with proportions between. FOLD: where the loop folds back outwards.
    """

    LOOP = 0
    FIRST = 1
    LAST = 2
    FLAT_FIRST = 3
    FLAT_LAST = 4
    SINGLE = 5
    FOLD = 6


class Family(Record):
    """Canonical family of merged profiles (levels.py), what is searched for, and one member."""

    V = field("canonical velocity at the start", "m/s")
    A = field("canonical acceleration at the start", "m/s2")
    W = field("canonical velocity at the end", "m/s")
    B = field("canonical acceleration at the end", "m/s2")
    TOP = field("canonical acceleration limit", "m/s2")
    BOTTOM = field("the same in the negative direction", "m/s2")
    HIGHEST = field("bound of the first level", "m/s2")
    LOWEST = field("the same of the second one, in the negative direction", "m/s2")
    LAST_RAMP = field("duration of the last ramp from that bound", "s")
    FIRST_UP = field("duration of the ramp from A to the acceleration limit", "s")
    FIRST_DOWN = field("duration of the ramp from A to the negative acceleration limit", "s")
    LAST_UP = field("duration of the ramp from the acceleration limit to B", "s")
    LAST_DOWN = field("duration of the ramp from the negative acceleration limit to B", "s")
    START_VELOCITY = field("velocity at the start of the phases, on their own branch", "m/s")
    REVERSE = field("1 where time is reversed, else 0")
    MIRROR = field("1 where the position is mirrored, else 0")
    BY_TIME = field("1 where members are searched by their duration, 0: by their distance")
    TARGET = field("distance or duration that is searched for", "m or s")
    MEMBER = field("number of the member of that value, from 0; -1: the first one found")
    SCALE = field("time over which members are looked for", "s")
    FREE = field("least duration of the optimal forms without the velocity limit", "s")
    MISSED = field("rises that may leave room for a shorter profile, see Rises")
    SLOW = field("1: the velocity limit makes the profile much longer: more starts may help")
    PASSED = field("samples that were passed up to the member before")
    PASSED_INSIDE = field("parameter of the last one of them; -1: it has no member", "s")
    PASSED_VALUE = field("its distance or duration", "m or s")
    LOWERED = field("1 where the first level was lowered to keep the velocity limit, else 0")
    FIRST_TIME = field("member: duration of the first ramp", "s")
    FIRST_HOLD = field("member: hold at the first level", "s")
    FIRST_LEVEL = field("member: first acceleration level", "m/s2")
    SECOND_HOLD = field("member: hold at the second level", "s")
    SECOND_LEVEL = field("member: second acceleration level", "m/s2")
    LAST_TIME = field("member: duration of the last ramp", "s")
    STRETCH = field("member: duration of the second ramp over that of the fastest one")
    FLATNESS = field("member: 0: it is the fastest one, stretched; 1: the one that lasts as long")


class Gentle(Record):
    """Three slow ramps over two levels (gentle.py)."""

    LEVELS = field("levels; beyond the acceleration limit they are held there", "m/s2", size=2)
    STEPS = field("their changes in Newton's method", "m/s2", size=2)
    ENDS = field("accelerations at the ends of the ramps", "m/s2", size=3)
    HOLDS = field("how long they are held", "s", size=3)
    RAMPS = field("durations of the fastest ramps", "s", size=3)
    STRETCH = field("by which they are slowed down")
    GAIN = field("velocity that is gained too much", "m/s")
    EXCESS = field("distance that is covered too much, over the duration", "m/s")
    GAIN_SLOPES = field("derivatives of the first with the levels", "s", size=2)
    EXCESS_SLOPES = field("derivatives of the second", "s", size=2)


class Touch(Codes):
    """What the derivative of a `Node` does at its limit.

    HOLDS: it stays there. TOUCHES: only for an instant, with the hold AIM. BELOW: it stays below.
    """

    HOLDS = 0
    TOUCHES = 1
    BELOW = 2


class Node(Record):
    """A level of a passing profile, and the ramp to it from the one before (sequence.py)."""

    STATE = field("position, velocity .. before the ramp, below the derivative of levels", size=4)
    KIND = field("0: free level; else the derivative of this order stays at its limit, level 0")
    SIGN = field("sign of the level, or of the derivative that stays")
    TIME = field("time of the ramp from 0 and of the hold; hold where a derivative stays", "s")
    TOUCH = field("what the derivative does at its limit, a `Touch`")
    AIM = field("hold where it touches; below zero only on the way to 0", "s")
    LEVEL = field("level")
    HOLD = field("duration of its hold", "s")
    RAMP = field("duration of the ramp", "s")


class Dip(Record):
    """Dips (dip.py) from a state that keep the limits."""

    V = field("velocity of the state", "m/s")
    A = field("its acceleration", "m/s2")
    END = field("acceleration at their end: zero, or of the other sign", "m/s2")
    ABOVE = field("order of the derivative that has levels, less 2; 0: there are no dips")
    LEAST = field("time of the first level of the least dip", "s")
    DEEPEST = field("the same of the deepest one", "s")


class Passing(Record):
    """A sequence of nodes, and what its equations are measured in."""

    COUNT = field("number of nodes")
    ABOVE = field("order of the derivative that has levels, less 2")
    PACE = field("at most 1: ramps are those of this pace, stretched to 1")
    TIME = field("scale of durations", "s")
    ACCELERATION = field("scale of accelerations", "m/s2")
    TARGET = field("duration that it shall take by its pace; 0: the pace is given", "s")
    FREE = field("1, -1: over the largest, the least distance within TARGET, at the given pace")
    REVERSED = field("1: of the motion with the time reversed")
    START = field("level at the start")
    JERK = field("jerk at the start, where the levels are those of the snap", "m/s3")
    SETTLED = field("1: a profile that keeps the limits was found, not one slowed down")
    PLAIN = field("1: without the ways that are tried last")
    QUICK = field("1: Newton's method gives up soon")
    INSTANTS = field("number of derivatives that reach their limits for an instant")
    INSTANT_ORDER = field("their orders", size=3)
    INSTANT_SIGN = field("signs of the limits", size=3)
    INSTANT_FROM = field("first nodes in whose ramps or holds they may do so", size=3)
    INSTANT_TO = field("last nodes", size=3)


class Repeat(Record):
    """A search for the shortest profile, which is not made again (repeats.py)."""

    PROBLEM = field("boundary problem in the direction in which it is solved", size=5)
    PLAIN = field("Passing.PLAIN of the search")
    USED = field("turn of its last use, from 1; 0: there is none")
    REVERSED = field("Passing.REVERSED of the profile")
    PASSING = field("1: the profile passes zero jerk with snap; 0: it does not, or there is none")


class Excess(Record):
    """By how much a passing profile exceeds the limit of a derivative the most."""

    SHARE = field("of the limit; 0: it keeps the limit")
    NODE = field("node in whose ramp or hold")
    HOLDING = field("1: in its hold")
    SIGN = field("sign of the derivative there")


class Tighten(Record):
    """Limits that a sequence exceeds, brought down to what they are (tighten.py)."""

    SHARE = field("by which the derivatives exceed them at first", size=4)
    STEPS = field("steps of Newton's method so far")
    MOST = field("steps after which no other sequence is tried")
    MOVING = field("1: a derivative may reach its limit elsewhere, without a level more")


class Equations(Record):
    """Values of one row of equations."""

    VALUES = field("values", size=16)


class Interval(Record):
    """Result of one axis in one waypoint interval."""

    SHORTEST = field("shortest duration", "s")
    DURATION = field("duration of the plan", "s")
    WEIGHT = field("share of the second profile in the weighted mean of both")
    BELOW_COUNT = field("number of phases of the first profile")
    ABOVE_COUNT = field("number of phases of the second profile; 0: there is none")
    KEPT_COUNT = field("number of phases that are kept in its place")
    PASSING = field("1: the shortest profile passes zero jerk with snap")


class Place(Record):
    """Where one axis is in one waypoint interval, and what may be added to that."""

    POSITION = field("position at its start", "m")
    START = field("time of its start", "s")
    DELAY = field("time before its profile begins", "s")
    LEAST = field("duration before the interval is prolonged", "s")
    PROLONGED = field("of the first axis: 1 while the interval can be prolonged, else 0")


class Cell(Record):
    """Rows of what belongs to one axis in one interval."""

    BELOW = field("phases of the first profile", size=33, of=Phase)
    ABOVE = field("phases of a second profile: averaged with the first, or kept", size=33, of=Phase)
    PROBLEM = field("boundary problem", of=Problem)
    RESULT = field("result", of=Interval)
    PLACE = field("position and times", of=Place)


class Nearest(Record):
    """The two profiles of prescribed duration next to the distance."""

    BELOW_COUNT = field("number of phases of the one that falls short; 0: none")
    BELOW_DISTANCE = field("its distance", "m")
    ABOVE_COUNT = field("number of phases of the one that covers the distance; 0: none")
    ABOVE_DISTANCE = field("its distance", "m")
    KNOWN = field("-1, 1: without braking only one that falls short, or covers it; 0: neither")
    WAY = field("in which they were found last (Way)")


class Refusal(Record):
    """Where and why a plan is refused."""

    AXIS = field("axis, from 0")
    INTERVAL = field("waypoint interval, or waypoint, from 0")
    VALUE = field("value that is refused")
    BOUND = field("its bound")
    SIDE = field("1: that of the negative direction alone, else 0")


class PlanWork(Record):
    """Rows of the planner's work space."""

    TRIAL = field("phases that are tried", size=21, of=Phase)
    BEST = field("phases of the candidate in question", size=21, of=Phase)
    GAP_ENDS = field("durations at which a gap can end, in the first column", size=16)
    NEAREST = field("profiles next to the distance", of=Nearest)
    PROBLEM = field("boundary problem without rounding errors at the limits", of=Problem)
    REST = field("boundary problem that braking leaves", of=Problem)
    DIPPED = field("boundary problem that dips leave", of=Problem)
    DIP = field("dips that braking tries", of=Dip)
    DIP_FIRST = field("dips at the start of a profile", of=Dip)
    DIP_LAST = field("dips at its end, the time reversed", of=Dip)
    DIP_PHASES = field("phases between them", size=33, of=Phase)
    FAMILY = field("canonical family", of=Family)
    REFUSAL = field("of a plan that is refused", of=Refusal)
    GENTLE = field("three slow ramps", of=Gentle)
    PASSING = field("passing profile in question", of=Passing)
    NODES = field("its nodes, the end, and the state there", size=18, of=Node)
    KEPT = field("the same of one that was kept", size=19, of=Node)
    FOUND = field("the same of the shortest one", size=19, of=Node)
    SOLVED = field("the same of one before it meets the limits", size=19, of=Node)
    TRIED = field("the same of the shortest one with one level more", size=19, of=Node)
    EXCESS = field("by the order of the derivative", size=4, of=Excess)
    TIGHTEN = field("limits that are brought down", of=Tighten)
    LOOSE = field("the axis with wider limits", of=Axis)
    RESIDUAL = field("residuals of the equations", of=Equations)
    MATRIX = field("their derivatives", size=16, of=Equations)
    STEP = field("step of Newton's method, in the first column", size=16, of=Equations)
    SLOPES = field("derivatives of the residuals with one unknown", of=Equations)
    BEFORE = field("nodes before the time of one changes", size=3, of=Node)
    CHANGE = field("change of the state after them", of=Node)
    SEARCHES = field("searches that are kept", size=8, of=Repeat)
    SEARCHED_AXES = field("their axes", size=8, of=Axis)
    SEARCHED = field("the sequences of their profiles, as FOUND", size=152, of=Node)
