"""Records of the polynomial pieces of a trajectory."""

from segfmu.kernels.planner.records import PlanOptions, PlanWork
from segfmu.kernels.records import Codes, Record, field
from segfmu.kernels.spline.records import SplineWork


class Order(Codes):
    """Derivatives of the position above the acceleration."""

    JERK = 3
    SNAP = 4
    CRACKLE = 5
    POP = 6


class Timing(Record):
    """When a polynomial piece holds.

    The length is kept beside the start, as the difference of two late starts would not be exact.
    """

    START = field("start", "s")
    LENGTH = field("length", "s")


class PieceState(Record):
    """WaypointState of one axis at the start of a piece."""

    POSITION = field("position", "m")
    VELOCITY = field("velocity", "m/s")
    ACCELERATION = field("acceleration", "m/s2")
    JERK = field("jerk", "m/s3")
    HIGHER = field("snap and the derivatives above it", size=4)
    TIME = field("time", "s")


class Piece(Record):
    """Coefficients of a polynomial piece in its local time: derivatives over their factorials."""

    POSITION = field("position at the start", "m")
    VELOCITY = field("velocity there", "m/s")
    ACCELERATION = field("half the acceleration there", "m/s2")
    JERK = field("a sixth of the jerk there", "m/s3")
    SNAP = field("a 24th of the snap there; from smoothness 3 on", "m/s4")
    HIGHER = field("those of the higher powers, 2 n - 5", size=7)


class Expansion(Record):
    """Rows of the work space of the expansion of phases into pieces."""

    PSI = field("transition polynomial of the ramps, ascending powers", of=Piece)
    STATE = field("state between two pieces", of=PieceState)
    LENGTHS = field("of the pieces of a ramp that hold the jerk, and each derivative above it")
    PEAKS = field("values of these derivatives")


class Spare(Codes):
    """Rows at the end of the arrays of pieces in which two profiles are expanded to be averaged."""

    ROWS = 810


class Brake(Record):
    """How the state of an axis is brought inside its limits at the start of a plan."""

    UNTIL = field("time until all derivatives are inside, 0 where they always are", "s")
    COUNT = field("number of the pieces that bring it there")
    LAST = field("row after the pieces that are tried")
    GENTLE = field("by order, 0 to 1: how slowly a derivative comes inside, 0: at once", size=8)
    LOWEST = field("least value of the derivative of each order until then", size=8)
    HIGHEST = field("largest value", size=8)


class Hull(Record):
    """Bernstein coefficients of a polynomial on a part of its interval."""

    COEFFICIENTS = field("coefficients", size=13)
    DEPTH = field("how often the interval was halved")


class Check(Record):
    """Rows of the work space of the check of a plan."""

    HULLS = field("hulls of the parts of a piece", size=40, of=Hull)
    ENDS = field("derivatives at the end of the piece before, by their order")
    PEAKS = field("peaks of the derivatives; of the position its range")
    JUMPS = field("largest jumps of the derivatives between two pieces")
    VALUES = field("Bernstein coefficients of a derivative", of=Hull)
    STARTS = field("derivatives at the start of a piece, by their order")
    LOWEST = field("lower bounds of the derivatives of a piece, by their order")
    HIGHEST = field("upper bounds, 0 where absent")
    BRAKE = field("how far an axis may be outside its limits at first", of=Brake)


class Judging(Record):
    """How a plan is checked."""

    TOLERANCE = field("relative tolerance of limits")
    JOINTS = field("relative tolerance of jumps and waypoints, see `check_plan`")


class MotionWork(Record):
    """Rows of the work space of a whole plan, and how it is made."""

    OPTIONS = field("how to plan", of=PlanOptions)
    JUDGING = field("how to check the plan", of=Judging)
    SPLINE = field("of splines", size=SplineWork.SIZE, of=SplineWork)
    PLAN = field("of the planner", size=PlanWork.SIZE, of=PlanWork)
    EXPANSION = field("of the expansion", size=Expansion.SIZE, of=Expansion)
    CHECK = field("of the check, to the end", size=Check.SIZE, of=Check)
