"""Records of the choice of free states."""

from segfmu.kernels.planner.records import Axis
from segfmu.kernels.records import Codes, Record, field


class Cells(Codes):
    """Between two waypoints: cells of constant control, nodes within, and rows of a grid.

    These are added to a model by fours (`add_rows`).
    """

    COUNT = 12
    INNER = 11
    ROWS = 56


class Path(Record):
    """What a central path is of, and how far it has come."""

    ORDER = field("of the derivative that is the control: 3 or 4")
    COMPONENTS = field("of the control, which change nothing at the ends")
    ROWS = field("of the grid")
    AXES = field("that meet in the waypoints")
    PLACES = field("of the waypoints")
    BACKWARDS = field("1: the mission is chosen from its end")
    FIRST = field("place at which the passage begins")
    LAST = field("place at which it ends; 0: there is none yet")
    TERMS = field("of the barrier")
    ROOM = field("1; more while given states exceed the limits' shares")
    START = field("gap at the first point")
    FOLLOWED = field("1: the next path begins at the last point, slowed down")
    TOTAL = field("duration of the last point", "s")
    LOOSEST = field("the same of the first path, before it became tighter", "s")
    BEST = field("duration of the best plan, of states that are kept; 1e300: none", "s")
    KNOWN = field("duration beside which others are of interest", "s")
    BLOCK = field("of the choice that keeps the best states, see Block")
    STEP = field("by which states are moved, in half ranges")
    SHARE = field("of the range around two places by which an axis may leave it; 1e300: any")
    MARGIN = field("by which a plan may leave its box", "m")


class Point(Codes):
    """Points of a path, by the gap of their duration to the shortest one.

    FAR, NEAR: at which it begins. FIRST to LAST: whose states are offered.
    """

    FAR = 0
    NEAR = 3
    FIRST = 5
    SECOND = 6
    LAST = 7


class Track(Axis):
    """What an axis may do, for the planner and on the path."""

    LIMIT = field("half ranges of velocity and acceleration", size=2)
    JERK_LIMIT = field("limit of the jerk; 1e300: none", "m/s3")
    SNAP_LIMIT = field("limit of the snap; 1e300: none", "m/s4")
    MIDDLE = field("of the ranges of velocity and acceleration", "m/s, m/s2", size=2)
    ALLOWED = field("range of the positions", "m", size=2)
    UNIT = field("of velocity and acceleration, in those that are given", "m/s, m/s2", size=2)


class Block(Codes):
    """Blocks of `choice`, each with the states of all places.

    GIVEN: those that are given, and rest; in the end those chosen. BEST, ALONE: the best found,
    and that with free velocities alone. TRIED: of the last plan. KEPT: the best of several rooms.
    """

    GIVEN = 0
    BEST = 1
    ALONE = 2
    TRIED = 3
    KEPT = 4
    COUNT = 5


class Free(Record):
    """Velocity and acceleration of an axis at a waypoint, or what belongs to them."""

    VELOCITY = field("velocity")
    ACCELERATION = field("acceleration")


class Spot(Record):
    """An axis at a waypoint: rows for its state over the limits."""

    FREE = field("1 where it is free to be chosen", of=Free)
    ADMITTED = field("1 where a motion may have it within its boxes", of=Free)
    CHOSEN = field("1 where it is chosen now", of=Free)
    SHARE = field("at the point of the path", of=Free)
    STEP = field("Newton's step", of=Free)
    TRIAL = field("at the point that is tried", of=Free)


class GridColumn(Record):
    """What a derivative at a node depends on."""

    DISTANCE = field("distance between the waypoints", "m")
    ENDS = field("velocity and acceleration at both ends, over their limits", size=4)
    COMPONENTS = field("of the control, over its limit", size=9)
    TIME = field("logarithm of the duration, in the barrier's model")


class Pair(Record):
    """Two columns of a grid, from the ends on."""

    ENTRY = field("of the lower half of a symmetric matrix, row by row", size=91)


class GridRow(Record):
    """A derivative at a node, or the control in a cell."""

    BY = field("its dependence on each `GridColumn`", size=GridColumn.TIME)
    PRODUCT = field("of two of these, see Pair", size=Pair.SIZE)
    ORDER = field("of the derivative")
    SHARE = field("its value over its limit")
    PART = field("of the value by the distance, the velocities and the accelerations", size=3)
    CONTROL_PART = field("of the value by the control")
    PULL = field("slope of the barrier by the value")
    CURVE = field("its curvature")
    CROSSED = field("its curvature by the value and the logarithm of the duration")


class Link(Record):
    """An axis between two waypoints."""

    BOX = field("range of the positions; beyond 1e300: none", "m")
    WHERE = field("range of the derivatives less what the middle is, by order, over half of it")
    SCALE = field("one over half of the range of each order")
    POINT = field("variables of the point of the path", of=GridColumn)
    STEP = field("Newton's step", of=GridColumn)
    TRIAL = field("variables of the point that is tried", of=GridColumn)
    GRADIENT = field("of the barrier", of=GridColumn)
    SLOPE = field("of the barrier without the components; theirs over their own curvature",
                  of=GridColumn)
    CURVE = field("curvature of the barrier without them, see Outer", size=5, of=GridColumn)
    SOLVED = field("a component by each column before it, and the duration", size=9, of=GridColumn)
    KEPT = field("shortest duration and its kind (Interval), before a state is moved")


class Stretch(Record):
    """An interval between two waypoints."""

    TIME = field("logarithm of the duration at the point of the path")
    STEP = field("Newton's step, of one over the duration")
    TRIAL = field("logarithm of the duration at the point that is tried")
    BEND = field("curvature by the duration")
    PULL = field("slope by the duration")
    DEGREE = field("how tight the limits are")
    FAILED = field("highest degree at which the planner took longer; -1: none")
    GOOD = field("degree at which all kept up; 1e300: none")
    SLOW = field("1: the planner takes longer than the path, or leaves the box")
    TRIED_SLOW = field("the same with the states that were tried last")
    LENGTH = field("duration of the plan; 1e300: none", "s")
    TRIED = field("the same with a state that is moved", "s")


class Square(Record):
    """Rows of work space: small matrices."""

    UNIT = field("of each column, with its power of the duration", of=GridColumn)
    POWER = field("of the duration", of=GridColumn)
    PART = field("the column's variable in this unit", of=GridColumn)
    SCALE = field("of a derivative, by its order: what makes it a share")
    HESSIAN = field("of the barrier", of=Pair)
    CROSS = field("its entries by a variable and the duration", of=GridColumn)
    OWN = field("conditions at the end, by the controls of least norm", size=4, of=GridColumn)
    RIGHT = field("right-hand sides", size=4, of=GridColumn)
    BASIS = field("orthogonal controls that change nothing at the ends", size=9, of=GridColumn)


class Tools(Record):
    """Rows: the path, the grid, and small matrices."""

    PATH = field("what the path is of", of=Path)
    GRID = field("how derivatives depend on the columns", size=Cells.ROWS, of=GridRow)
    SQUARE = field("work space", size=Square.SIZE, of=GridColumn)


class Outer(Record):
    """Columns of `Link.CURVE`: what is around the components."""

    ENDS = field("states at the ends", size=4)
    TIME = field("logarithm of the duration")
