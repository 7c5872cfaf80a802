"""Records of splines."""

from segfmu.kernels.records import Codes, Record, field


class Mesh(Codes):
    """Sizes of a spline.

    FINER: pieces of a cell of the spline whose control points keep the range: that hull is within
    4e-4 of the positions. POINTS: control points, of the largest degree. BOUNDS: of its derivatives
    and the finer one.
    """

    CELLS = 60
    FINER = 4
    POINTS = 67
    BOUNDS = 650


class Derivatives(Record):
    """Position and derivatives, by their order."""

    VALUE = field("values", size=8)


class Program(Record):
    """A spline that is sought, in the time from 0 to 1 and units of length."""

    DEGREE = field("of the spline: n + 1")
    COUNT = field("number of bounds")
    SCALE = field("share of limits at the start of the search, in which it measures shares")
    SHARE = field("share of limits that is used")
    SHARE_STEP = field("its step")
    WEIGHT = field("curvature by the share alone")
    SLOPE = field("by the share")
    GAP = field("mean product of room and price")


class ControlPoint(Record):
    """A control point of the position, and its row of the equations of a step."""

    VALUE = field("over the unit of length")
    STEP = field("step; before it the right-hand side")
    SHARED = field("curvature by it and the share; after that the solution for it")
    BAND = field("matrix from the diagonal to the left", size=8)


class Bound(Record):
    """A control point of a derivative, or of the finer spline, between two bounds.

    Of the fields of two the first one is of the upper bound, the second one of the lower.
    """

    FIRST = field("first free control point of the position on which it depends")
    COUNT = field("number of these")
    ORDER = field("of the derivative")
    GIVEN = field("part that the ends give")
    VALUE = field("part that the free control points give, or its step")
    BY = field("dependence on them", size=8)
    PART = field("of the share, in units of this row", size=2)
    ROOM = field("distance of the bound from what is given; 1e300: there is none", size=2)
    SLACK = field("what is left of it", size=2)
    PRICE = field("multiplier", size=2)
    SLACK_STEP = field("step of the slack", size=2)
    PRICE_STEP = field("step of the price", size=2)


class Level(Record):
    """The highest derivative in a cell."""

    VALUE = field("value")
    GAIN = field("orthogonal effects on the end", size=7)


class SplineWork(Record):
    """Rows of work space."""

    PROGRAM = field("what is sought", of=Program)
    BEGIN = field("at the start, times powers of the duration", of=Derivatives)
    END = field("at the end", of=Derivatives)
    MISSED = field("by what the end is missed", of=Derivatives)
    FIRST = field("the state at the start of an interval", of=Derivatives)
    LAST = field("that at its end", of=Derivatives)
    ALLOWED = field("range of the positions between", "m", of=Derivatives)
    POINTS = field("control points", size=Mesh.POINTS, of=ControlPoint)
    BOUNDS = field("bounds", size=Mesh.BOUNDS, of=Bound)
    LEVELS = field("highest derivative", size=Mesh.CELLS, of=Level)
