"""Records of the controllers: gains, observer, tracking controller."""

from segfmu.kernels.crane.records import Axes, Coordinates, State
from segfmu.kernels.records import Codes, Record, field

OBSERVER = "feedback.observer"


class Acting(Codes):
    """Whether corrections acted at the tick before."""

    NO_TICK = 0
    OFF = 1
    ON = 2
    # with other gains
    RETUNED = 3


class Correction(Record):
    """The correction, and what remains of switching."""

    VALUE = field("correction that acts, N or m/s2", size=3)
    FADING = field("what remains of a switching step, N or m/s2", size=3)
    ACTED = field("whether corrections acted at the tick before, see Acting")
    BEFORE = field("correction of the tick before, N or m/s2", size=3)


class Tick(Record):
    """Rows: what a controller gets at a tick, and its correction."""

    SIGNALS = field("signals of the sensors", of=Coordinates)
    REFERENCE = field("reference at the tick", of=State)
    ADDED_TO = field(
        "what the correction is added to: force setpoints, or accelerations that the velocity "
        "setpoints give the drives",
        of=Axes,
    )
    CORRECTION = field("correction", of=Correction)


class GainInputs(State):
    """What the corrections are proportional to: errors of the state, and the velocity added."""

    COMMAND = field("velocity that the corrections of the axis have added to its setpoint", "m/s")


class Gains(Record):
    """Rows of a table of gains at a rope length."""

    LENGTH = field("rope length, the first entry", "m")
    AXES = field("gains of bridge, trolley and hoist", size=3, of=GainInputs)


def _gains(drive: str, axis: int) -> list[str]:
    """Variables of a row of gains: one an entry of the state, where it has to do with the axis."""
    names = [""] * GainInputs.SIZE
    names[GainInputs.COMMAND] = f"feedback.table[{{}}].{drive}.command"
    for name, quantity in (
        ("POSITION", "position"), ("ANGLE", "angle"), ("VELOCITY", "velocity"), ("RATE", "rate")
    ):
        if axis < State.FIELDS[name].size:
            names[getattr(State, name) + axis] = f"feedback.table[{{}}].{drive}.{quantity}"
    return names


class GainsRow(Record):
    """A row of an FMU's table of gains: a `Gains` with its rows one behind the other."""

    LENGTH = field(
        "rope length, the first entry", "m", size=GainInputs.SIZE,
        variables=["feedback.table[{}].length", *[""] * (GainInputs.SIZE - 1)],
    )
    BRIDGE = field("gains of the bridge", size=GainInputs.SIZE, variables=_gains("bridge", 0))
    TROLLEY = field("gains of the trolley", size=GainInputs.SIZE, variables=_gains("trolley", 1))
    HOIST = field("gains of the hoist", size=GainInputs.SIZE, variables=_gains("hoist", 2))


class Estimate(Record):
    """Deviation of an axis from its reference; the load is at position + length * angle."""

    POSITION = field("of the carriage, or length of the rope", "m")
    ANGLE = field("sway angle; the hoist has none", "rad")
    VELOCITY = field("rate of the position", "m/s")
    RATE = field("rate of the sway angle", "rad/s")
    DRIFT = field("unknown acceleration of the carriage or rope", "m/s2")
    WIND = field("unknown acceleration of the load; the hoist has none", "m/s2")


class AxisModel(Estimate):
    """States and inputs of the observer's model of an axis."""

    COMMAND = field("velocity command", "m/s")
    CORRECTION = field("force on the carriage [N], or acceleration [m/s2]")


class AxisTable(AxisModel):
    """Columns of the observer's table: transition over a sample, effect of the inputs, gains."""

    POSITION_GAIN = field("gain from the position's innovation")
    ANGLE_GAIN = field("gain from the angle's innovation")


class Observer(Record):
    """Rows of the observer's table at a rope length."""

    LENGTH = field("rope length, the first entry", "m")
    BRIDGE = field("a row for each entry of the estimate", size=Estimate.SIZE, of=AxisTable)
    TROLLEY = field("a row for each entry of the estimate", size=Estimate.SIZE, of=AxisTable)
    HOIST = field("a row for each entry of the estimate", size=Estimate.SIZE, of=AxisTable)


class Expected(Record):
    """What the observer expects of the crane."""

    POSITION = field("sensor step of the carriages", "m", variables=(f"{OBSERVER}.position",))
    LENGTH = field("sensor step of the rope's length", "m", variables=(f"{OBSERVER}.length",))
    ANGLE = field("sensor step of the sway angles", "rad", variables=(f"{OBSERVER}.angle",))
    DRIFT = field(
        "standard deviation of the drift's random walk after 1 s", "m/s2",
        variables=(f"{OBSERVER}.drift",),
    )
    WIND = field(
        "standard deviation of the wind's random walk after 1 s", "m/s2",
        variables=(f"{OBSERVER}.wind",),
    )


class ModelWork(Record):
    """Rows, blocks of eight: work space of the sampled model."""

    TERM = field("term of a series", size=AxisModel.SIZE)
    PRODUCT = field("product with the model", size=AxisModel.SIZE)
    TRANSPOSED = field("product with the transposed model", size=AxisModel.SIZE)


class Doubling(Record):
    """Rows, blocks of eight: matrices of the doubling of a Riccati equation."""

    TRANSPOSED = field("A^T", size=AxisModel.SIZE)
    INFORMATION = field("G, what the measurements tell", size=AxisModel.SIZE)
    FACTOR = field("1 + G X, then products", size=AxisModel.SIZE)
    SOLUTION = field("(1 + G X)^-1 A^T and, behind it, (1 + G X)^-1 G", size=AxisModel.SIZE)
    PRODUCT = field("products", size=AxisModel.SIZE)
    CHANGE = field("change of X in a turn", size=AxisModel.SIZE)


class Kalman(Doubling):
    """Rows, blocks of eight: work space of the observer's design."""

    TRANSITION = field("transition over a sample", size=AxisModel.SIZE)
    SPREAD = field("covariance X of the estimate", size=AxisModel.SIZE)
    MODEL = field("derivatives of states and inputs", size=AxisModel.SIZE)


class Loops(Codes):
    """How many states a loop can have that is checked for its stability."""

    MOST = 48


class LoopStates(Record):
    """States of a closed loop."""

    STATES = field("states of the model, then corrections on their way", size=Loops.MOST)


class LoopWork(Record):
    """Rows: work space of the check of a loop."""

    MODEL = field("derivatives of states and inputs", size=AxisModel.SIZE, of=LoopStates)
    TRANSITION = field("transition over a sample", size=AxisModel.SIZE)
    TERM = field("term of a series, then a square", size=AxisModel.SIZE)
    PRODUCT = field("product with the model", size=AxisModel.SIZE)
    LOOP = field("transition of the closed loop", size=Loops.MOST)
    SQUARE = field("its square", size=Loops.MOST)
    LENGTHS = field("rope lengths", "m")
    GAINS = field("gains by the entries of an AxisModel")


class OffsetCause(Codes):
    """What a lasting deviation of a measured sway angle is; no signal tells these apart.

    Wind pushes the load, so the carriage has to make room. The zero of the angle's sensor does not.
    """

    WIND = 0
    SENSOR = 1


class Tracking(Record):
    """Parameters of the tracking controller."""

    MODE = field("what the drives follow, see DriveMode", variables=("drive.mode",), base=1)
    PERIOD = field("sample time", "s", variables=("feedback.sample_time",))
    AGE = field("age of the signals, in samples")
    MASSES = field("masses that move in x, in y and with the rope", "kg", size=3)
    GRAVITY = field("gravity", "m/s2", variables=("crane.gravity",))
    REJECTED_DRIFT = field(
        "share of the drift that is rejected", variables=("feedback.rejection.carriage",)
    )
    REJECTED_WIND = field(
        "share of the load's disturbance that is rejected",
        variables=("feedback.rejection.load",),
    )
    ENABLED = field("1: corrections are made", variables=("feedback.enabled",))
    FADE = field("time constant of switching", "s", variables=("feedback.fade",))
    DECAY = field("what is left of a switching step after a sample")
    LEAST = field("least setpoints, N or m/s2", size=3)
    GREATEST = field("greatest setpoints, N or m/s2", size=3)
    GAINS_PAYLOAD = field("mass of the load that the gains are for", "kg")
    PAYLOAD_SHARE = field("sample time over the time constant of the payload's estimate")
    WAKE_POSITION = field("deviation of a carriage up to which nothing is corrected", "m")
    WAKE_LENGTH = field("deviation of the rope up to which nothing is corrected", "m")
    WAKE_ANGLE = field("deviation of an angle up to which nothing is corrected", "rad")
    OFFSET_EXPECTED = field(
        "expected standard deviation of the length sensor's offset over the rope's length; 0: "
        "none is estimated",
    )
    OFFSET_BANDWIDTH = field("bandwidth of the offset's filter", "rad/s")
    ANGLE_VARIANCE = field("variance of the angles' noise", "rad2")
    POSITION_VARIANCE = field("variance of the positions' noise", "m2")
    DELAY = field("age of the signals and dead time of the drive, in samples", size=3)
    VELOCITY_MAX = field("largest velocities of the drives; 0: no bound", "m/s", size=3)
    VELOCITY_MIN = field("least velocities; 0: minus the largest ones", "m/s", size=3)
    POWER_MAX = field("largest powers of the drives; 0: no bound", "W", size=3)
    OFFSET_CAUSE = field(
        "what a lasting deviation of an angle is, see OffsetCause",
        variables=("feedback.offset_cause",), base=1,
    )
    OFFSET_ACTS = field(
        "1: the offset of the rope's sensor is corrected", variables=("feedback.rope_offset",)
    )


class OffsetSignals(Record):
    """What the offset's filter takes."""

    PLACE = field("place of the load by the measured length", "m", size=3)
    DIRECTION = field("direction of the rope", size=3)
    START = field("1 at the first tick, then 0")


class OffsetFilter(Record):
    """Rows: three lags in series."""

    INPUT = field("input", of=OffsetSignals)
    FIRST = field("after one lag", of=OffsetSignals)
    SECOND = field("after two lags", of=OffsetSignals)
    THIRD = field("after three lags", of=OffsetSignals)


class OffsetEquation(Record):
    """The equation of the offset along an axis."""

    RESIDUAL = field("left side without offset")
    FACTOR = field("factor of the offset")
    INSTRUMENT = field("the factor of the reference")


class OffsetMeans(Record):
    """Slow means of the equations."""

    AXES = field("residual, factor and instrument of x, then of y", size=2 * OffsetEquation.SIZE)
    START = field("residual at the start, of x and y", size=2)
    STARTED = field("1: there was a tick before")


class OffsetEstimate(Record):
    """What is known of the offset."""

    FOUND = field("offset by the sums", "m")
    DEVIATION = field("its standard deviation", "m")
    TICKS = field("ticks for which it has been significant")
    LAST = field("the last significant offset", "m")
    VALID = field("1: LAST is to be used")
    USED = field("what is added to the measured length", "m")


class OffsetSums(Record):
    """Sums over the ticks of products of instrument z, residual r and factor f."""

    ZR = field("z r")
    ZF = field("z f")
    ZZRR = field("z^2 r^2")
    ZZRF = field("z^2 r f")
    ZZFF = field("z^2 f^2")
    ZZ = field("z^2")


class OffsetMemory(Record):
    """Rows: memory of the offset's estimate."""

    MEASURED = field("filter of the measured signals", size=OffsetFilter.SIZE, of=OffsetSignals)
    PLANNED = field("filter of the reference", size=OffsetFilter.SIZE, of=OffsetSignals)
    MEANS = field("slow means", of=OffsetMeans)
    ESTIMATE = field("estimate", of=OffsetEstimate)
    SUMS = field("sums", of=OffsetSums)
    SIGNALS = field("signals to be filtered", of=OffsetSignals)
    EQUATIONS = field("equations of x and y at the present tick", size=2, of=OffsetEquation)


class Held(Record):
    """What holds from tick to tick."""

    INPUT = field("corrections as the observer takes them, N or m/s2", size=3)
    CORRECTION = field("corrections, N or m/s2", size=3)
    AWAKE = field("1: a deviation was more than the sensors' steps")


class VelocityCommand(Record):
    """Velocity command and switches of the tracking controller."""

    VELOCITY = field("velocity command", "m/s", size=3)
    STARTED = field("1: there was a tick before")
    SWITCHED = field("1: something was switched since")


class Fading(Record):
    """What fades out, and the payload."""

    STEP = field("what remains of a switching step, N or m/s2", size=3)
    PAYLOAD = field("estimate of the payload over the nominal one, minus 1")


class History(Codes):
    """How many past ticks a controller can remember."""

    MOST = 40


class Past(Record):
    """A past tick."""

    INPUT = field("corrections as the observer takes them, N or m/s2", size=3)
    REFERENCE = field("reference, as a State", size=State.SIZE)


class Situation(Record):
    """What bounds of a correction depend on, beside the drives."""

    WEIGHT = field("weight of the load", "N")
    LENGTH = field("rope length", "m")
    VELOCITY = field("velocities of the drives", "m/s", size=3)
    PLACE = field("deviation of the load along an axis, or of the rope", "m", size=3)
    RATE = field("its rate", "m/s", size=3)


class Tracker(Record):
    """Rows: memory of the tracking controller."""

    ESTIMATE = field(
        "estimates of bridge, trolley and hoist, of when the signals were taken", size=3,
        of=Estimate,
    )
    COMMAND = field("velocity command", of=VelocityCommand)
    HELD = field("corrections since the last tick", of=Held)
    FADING = field("what fades out", of=Fading)
    REFERENCE = field("reference of when the signals were taken", of=State)
    DEVIATION = field("work space: the deviation", of=State)
    TARGET = field("work space: where the disturbances are balanced", of=State)
    INPUTS = field("work space of the observer", of=AxisModel)
    SIGNALS = field("measured signals without the offset", of=Coordinates)
    OFFSET = field("memory of the offset's estimate", size=OffsetMemory.SIZE, of=OffsetMemory)
    PRESENT = field("estimates of when corrections act", size=3, of=Estimate)
    AHEAD = field("work space: an estimate one sample ahead", of=Estimate)
    CHANGE = field("work space: change of an estimate in a sample", of=AxisModel)
    SITUATION = field("work space: what bounds depend on", of=Situation)
    PAST = field("ticks before, the latest one first", size=History.MOST, of=Past)


class Estimates(Record):
    """What a tracking controller has found, as an FMU shows it."""

    PAYLOAD_MASS = field("mass of the load", "kg", variables=("estimate.payload_mass",))
    DRIFT = field(
        "unknown accelerations of bridge, trolley and rope", "m/s2", size=3,
        variables=[f"estimate.disturbance.{d}" for d in ("bridge", "trolley", "hoist")],
    )
    WIND = field(
        "unknown accelerations of the load", "m/s2", size=2,
        variables=[f"estimate.disturbance.load.{a}" for a in "xy"],
    )
    ROPE_OFFSET = field(
        "what is added to the measured length of the rope", "m",
        variables=("estimate.rope_offset",),
    )


class FlatDesign(Record):
    """What the gains in closed form follow from, beside the crane."""

    PERIOD = field("sample time", "s", variables=("feedback.sample_time",))
    BANDWIDTH = field(
        "bandwidth over the pendulum's frequency", variables=("feedback.bandwidth",)
    )
    HOIST_BANDWIDTH = field(
        "bandwidth of the hoist over the pendulum's frequency",
        variables=("feedback.hoist_bandwidth",),
    )
    DAMPING = field("damping of all poles", variables=("feedback.damping",))
    DEAD_TIME = field("from sampling to the signal", "s", variables=("sensor.dead_time",))


class Uncertainty(Expected):
    """All that is expected of sensors and disturbances; drift and wind in units of gravity.

    Steps of 0 are those of the sensors. The walks' standard deviations are those after sqrt(l / g),
    the time of the pendulum, so the same numbers suit every crane.
    """

    WAKE = field(
        "sensor steps up to which nothing is corrected", variables=(f"{OBSERVER}.wake",)
    )
    OFFSET = field(
        "standard deviation of the length sensor's offset over the rope's length",
        variables=(f"{OBSERVER}.offset",),
    )


class TrackingDesign(Uncertainty):
    """What a `Tracking` follows from, beside its own variables and the nominal crane."""

    DEAD_TIME = field("from sampling to the signal", "s", variables=("sensor.dead_time",))
    SAMPLING = field("period of the sensors; 0: continuous", "s", variables=("sensor.sample_time",))
    PAYLOAD_TIME = field(
        "time constant of the payload's estimate", "s", variables=("feedback.payload_time",)
    )


class RopeRange(Record):
    """Rope lengths between which a controller's table lies."""

    SHORTEST = field("least rope length", "m")
    LONGEST = field("greatest rope length", "m")
