"""Records of the numerics."""

from segfmu.kernels.records import Codes, Record, field


class Stages(Record):
    """Rows: derivatives at the stages of a Runge-Kutta step."""

    K1 = field("at the step's start")
    K2 = field("at 1/5 of the step")
    K3 = field("at 3/10 of the step")
    K4 = field("at 4/5 of the step")
    K5 = field("at 8/9 of the step")
    K6 = field("at the step's end, by a lower order")
    K7 = field("at the step's end")


class Sinusoid(Record):
    """A sine of the wind's noise, with its amplitudes along x, y and z."""

    FREQUENCY = field("angular frequency w", "rad/s")
    SINE = field("factors of sin(w t), N or m/s", size=3)
    COSINE = field("factors of cos(w t), N or m/s", size=3)
    OF_SPEED = field("1: of the air's speed, 0: of the force")


class RandomState(Record):
    """State of the random numbers, integers kept as floats."""

    FIRST = field("of the first generator")
    SECOND = field("of the second generator")


class GivenTime(Codes):
    """Parameters that are times. AT_START, before any that a simulation has [s]: when it starts."""

    AT_START = -1000000000


class RangeStatus(Codes):
    """Whether a value is in its range. BELOW, ABOVE: no, and the range has no other end."""

    INSIDE = 0
    BELOW = 1
    OUTSIDE = 2
    ABOVE = 3


class RangeFault(Record):
    """A value that is not in its range."""

    VALUE = field("the value")
    LEAST = field("least value of the range")
    MOST = field("greatest value of the range")


class AccessStatus(Codes):
    """Why a variable cannot be read or set."""

    NO_VARIABLE = 1


class AccessFault(Record):
    """A variable that cannot be read or set."""

    REFERENCE = field("value reference")
