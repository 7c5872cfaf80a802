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
    PLACE = field("where load or rope are at first", "m", size=3)
    BOX = field("number of the box, from 0")


class Stack(Codes):
    """Spans in the work space, one for each time that a span is halved, and the next one."""

    ROWS = 42


class Ranges(Record):
    """Rows: where a path leads, x, y and z in columns, and where it meets a box."""

    LOAD_LOW = field("least position of the load", "m")
    LOAD_HIGH = field("greatest one", "m")
    ROPE_LOW = field("least position of the rope", "m")
    ROPE_HIGH = field("greatest one", "m")
    PLACE = field("place of a contact", "m")
