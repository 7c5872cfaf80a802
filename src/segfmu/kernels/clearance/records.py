"""Records of the check of load and rope against obstacles."""

from segfmu.kernels.records import Codes, Record, field


class Span(Record):
    """Rows: what moves between two changes of piece, as Bernstein coefficients.

    The rope is at the height h at position + (h - z) pull / pull z, along x as along y.
    """

    LOAD = field("position of the load", "m", size=3)
    REACH = field("position times pull z less z times pull, along x and y", "m", size=2)
    TURN = field("x times pull y less y times pull x", "m")
    PULL = field("w = p'' / g + e_z", size=3)
    MOMENT = field("when it is, and what is rounding of it")


class Moment(Codes):
    """Columns of the row MOMENT of a `Span`: start and length [s], and how often it was halved.

    TURN_ROUNDING is rounding of TURN [m], ROUNDING that of positions [m].
    """

    START = 0
    LENGTH = 1
    DEPTH = 2
    TURN_ROUNDING = 3
    ROUNDING = 4


class Box(Record):
    """A box that load and rope must not meet."""

    LOAD_LOW = field("least position of the load in it", "m", size=3)
    LOAD_HIGH = field("greatest one", "m", size=3)
    ROPE_LOW = field("least position of the rope in it", "m", size=3)
    ROPE_HIGH = field("greatest one", "m", size=3)
    ROPE = field("1 if the rope must not meet it, else 0")


class Space(Record):
    """Where the load may be, and how large it is."""

    GRAVITY = field("gravity, which the rope's direction follows from", "m/s2",
                    variables=("crane.gravity",))
    WORKSPACE_MIN = field(
        "least position of the load", "m", size=3,
        variables=[f"workspace.{a}.min" for a in "xyz"],
    )
    WORKSPACE_MAX = field(
        "greatest one", "m", size=3, variables=[f"workspace.{a}.max" for a in "xyz"]
    )
    LOAD_SIZE = field(
        "edges of the load's box", "m", size=3, variables=[f"load.size.{a}" for a in "xyz"]
    )
    LOAD_CENTRE = field(
        "centre of that box from the load's position, the rope's end", "m", size=3,
        variables=[f"load.centre.{a}" for a in "xyz"],
    )
    OBSTACLES = field("number of obstacles", variables=("obstacle.count",))


class ObstacleRow(Record):
    """An obstacle, a row of a table."""

    MINIMUM = field(
        "least corner", "m", size=3, variables=[f"obstacle[{{}}].minimum.{a}" for a in "xyz"]
    )
    MAXIMUM = field(
        "greatest corner", "m", size=3, variables=[f"obstacle[{{}}].maximum.{a}" for a in "xyz"]
    )
    MARGIN = field(
        "distance that load and rope keep along each axis", "m",
        variables=("obstacle[{}].margin",),
    )
    ROPE = field("1 if the rope must not meet it, else 0", variables=("obstacle[{}].rope",))


class SpaceStatus(Codes):
    """What a path meets."""

    CLEAR = 0
    LOAD = 1
    ROPE = 2
    WORKSPACE = 3
    EMPTY_WORKSPACE = 4
    EMPTY_OBSTACLE = 5
    SLING = 6


class SpaceLimits(Codes):
    """Boxes around the workspace, two for each axis, and obstacles of an FMU at most."""

    FACES = 6
    OBSTACLES = 16


class Part(Codes):
    """What meets a box; CLEAR: neither load nor rope."""

    CLEAR = 0
    LOAD = 1
    ROPE = 2


class Meeting(Codes):
    """Whether load or rope meet a box within a span."""

    NEVER = 0
    ALWAYS = 1
    OPEN = 2


class Collision(Record):
    """When and where load or rope meet a box."""

    BEGIN = field("first moment", "s")
    END = field("last moment of the first contact", "s")
    X = field("where load or rope are at first", "m")
    Y = field("the same along y", "m")
    Z = field("the same along z", "m")
    BOX = field("number of the box, from 0")


class SpaceFault(Collision):
    """When and where load or rope leave the space that they have; or which corners are wrong."""

    AXIS = field("axis of the workspace or of the corners")
    VALUE = field("position of the load, or least corner", "m")
    BOUND = field("end of the workspace, or greatest corner", "m")
    PART = field("what meets an obstacle, see Part")


class Excursion(Record):
    """A part of a path outside of the box of the two waypoints that it joins, along one axis."""

    AXIS = field("axis, counted from 0")
    INTERVAL = field("waypoint interval, counted from 0")
    DISTANCE = field("farthest from the box", "m")
    TIME = field("when the path leaves it", "s")


class PathStatus(Codes):
    """Whether a path stays in the boxes of its waypoints."""

    INSIDE = 0
    EXCURSION = 1


class Stack(Codes):
    """Spans in the work space: one for each time that a span is halved, the next one, the whole."""

    WHOLE = 42
    ROWS = 43


class Ranges(Record):
    """Rows: where a path leads, x, y and z in columns, and where it meets a box."""

    LOAD_LOW = field("least position of the load", "m")
    LOAD_HIGH = field("greatest one", "m")
    ROPE_LOW = field("least position of the rope", "m")
    ROPE_HIGH = field("greatest one", "m")
    PLACE = field("place of a contact", "m")
    TIMES = field("begin and end of a contact", "s")
