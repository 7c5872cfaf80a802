"""Records of settling: a full state of an axis, and the work space of the search for a lead."""

from segfmu.kernels.planner.records import (
    Axis,
    DelayedState,
    Lower,
    Phase,
    PlanOptions,
    PlanWork,
    Problem,
)
from segfmu.kernels.records import Codes, Record, field
from segfmu.kernels.spline.records import SplineWork
from segfmu.kernels.trajectory.records import Brake, Check, Expansion, Judging


class Chain(Record):
    """Position of one axis and its derivatives by their order, as far as they are continuous."""

    DERIVATIVES = field("position and its derivatives 1 .. n, and of limits n + 1", size=8)
    TIME = field("time", "s")


class Ends(Record):
    """Where the stages of a lead end."""

    VALUES = field("by the order that a stage is for: its derivative; 1e300: any", size=8)


class LeadStage(Codes):
    """Orders of last stages: of the derivatives that they lead to a value."""

    VELOCITY = 1
    ACCELERATION = 2


class Lead(Record):
    """The shortest lead that was found."""

    TIME = field("from its start to the target, -1: there is none", "s")
    COUNT = field("number of its pieces")
    LEVEL = field("level of the best one that goes over a level")
    STEEP = field("steepness of rises with which the stages of the best one end soonest")
    GAIN = field("a lead is better if it takes less than this share of its time")


class Done(Codes):
    """What of a motion from any state is there already."""

    NOTHING = 0
    LEADS = 1
    PHASES = 2


class PlanPart(Codes):
    """Parts of a motion from any state, and their number: each has its rows of the arrays."""

    FOLLOWED = 0
    LEADS = 1
    BEHIND = 2
    WHOLE = 3
    COUNT = 4


class LeadTask(Record):
    """What leads are searched for."""

    ORDER = field("of their last stage, see LeadStage")
    MEETING = field("time at which axes that meet do so at the earliest; below 0: none waits", "s")
    SHAPE = field("of the ramps, see Shape")
    BRAKES = field("1: a state that cannot keep the limits is brought inside first")
    DONE = field("what is there already, see Done")
    FAILED = field("written: first axis that has no lead, -1: all have one")
    COARSE = field("1: a brake is searched for, and its times need not be exact yet")
    OLDEST = field("written: brake in KEPT that the next one replaces")


class KeptBrake(Record):
    """How the brake from a state was made, see `keep_brake`."""

    KIND = field("whether it goes on until all is zero, and its number of limits; 0: there is none")
    STATE = field("position and its derivatives 1 .. n", size=7)
    LIMITS = field("c_1 .. c_{n+1}", size=7)
    LOWER = field("limits in the negative direction", size=2)
    STEEP = field("steepness of derivatives that nothing limits; 0: no brake was found")
    LOOSE = field("order from which on derivatives may stay as large as they are")
    GENTLE = field("see Brake", size=7)


class LeadEnd(DelayedState):
    """Where the lead of an axis ends, and after which time."""

    TIME = field("from its start to the target", "s")
    FOLLOWS = field("1: it is the plan that is followed")
    HASTY = field("1: the axis was late, and has made haste")


class LeadRows(Codes):
    """Most pieces of a lead, and rows of its arrays.

    A third of these is for the best lead, one for what is tried, and one for a brake.
    """

    PIECES = 400
    ALL = 1200


class LeadWork(Record):
    """Rows of the work space in which one axis settles."""

    TASK = field("what leads are searched for", of=LeadTask)
    OPTIONS = field("how to plan behind leads", of=PlanOptions)
    JUDGING = field("how to check the plan", of=Judging)
    KEPT = field("the last brakes; all zeros at first", size=4, of=KeptBrake)
    NOW = field("state at the start", of=Chain)
    GIVEN = field("state before a brake", of=Chain)
    BRAKED = field("state that a brake has reached", of=Chain)
    TURN = field("state where a brake lets go", of=Chain)
    INSIDE = field("times at which a brake brings derivatives inside, 0: they are", of=Chain)
    LOWEST = field("lower limits by order", of=Chain)
    HIGHEST = field("upper limits by order", of=Chain)
    BRAKE = field("the brake", of=Brake)
    START = field("state from which the axis settles: at the start, or later in a plan", of=Chain)
    STATE = field("state that is reached", of=Chain)
    LEVEL = field("state at a level", of=Chain)
    REACHED = field("state that the best lead reaches", of=Chain)
    LIMITS = field("limits by order; natural ones where there are none", of=Chain)
    ROUNDING = field("rounding errors by order", of=Chain)
    ENDS = field("where stages end", of=Ends)
    BEST_ENDS = field("where the stages of the best lead end", of=Ends)
    BEST = field("the best lead", of=Lead)
    TARGET = field("boundary problem of the plan that follows, from the position 0", of=Problem)
    PROBLEM = field("boundary problem of a stage, or after settling", of=Problem)
    PHASES = field("phases of a stage, or after settling", size=33, of=Phase)
    AXIS = field("the axis", of=Axis)
    LOWER = field("its limits in the negative direction", of=Lower)
    CHAINS = field("the axis seen from its derivatives of order 0 .. 4, and work space", size=7,
                   of=Axis)
    SPLINE = field("of splines", size=SplineWork.SIZE, of=SplineWork)
    PLAN = field("of the planner", size=PlanWork.SIZE, of=PlanWork)
    EXPANSION = field("of the expansion", size=Expansion.SIZE, of=Expansion)
    CHECK = field("of the check, to the end", size=Check.SIZE, of=Check)
