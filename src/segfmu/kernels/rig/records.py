"""Records of the rig: settings, memory, balance of energy, partial derivatives."""

from segfmu.kernels.control.records import Tick, Tracking
from segfmu.kernels.crane.records import (
    DRIVES,
    Axes,
    Coordinates,
    Plant,
    PlantState,
    Report,
    State,
    Work,
)
from segfmu.kernels.numerics.records import RandomState
from segfmu.kernels.records import Codes, Record, field

SIGNALS = ("bridge.position", "trolley.position", "rope.length", "sway.x.angle", "sway.y.angle")


class Corrector(Codes):
    """Who corrects the setpoints."""

    CALLER = 0
    STATE = 1
    TRACKING = 2


class RigStatus(Codes):
    """Status of a step beside those of the plant: the caller's correction is due."""

    TICK = -1


class SensorLimits(Codes):
    """Samples that can be on their way at a time, for each of which there is memory."""

    MOST_SAMPLES = 100000


class SetupStatus(Codes):
    """What is wrong with the parameters of a rig; `SetupFault` says where.

    EMPTY_TRAVEL: an axis has no room between its end stops. NO_LAG: without lag, the acceleration
    of a velocity drive does not follow from its setpoint. NOT_SAMPLED, SHORT_SAMPLE,
    LONG_DEAD_TIME: of the sensors. ROPE_START: the rope has no length. ROPE_BOUNDS: its bounds are
    not ascending. LENGTHS, OBSERVER: of a controller's table, the observer's is not finite.
    LONG_DELAY, LATE_EXCHANGE: dead time of a drive, longer than there is memory for, or in model
    exchange. LOW_STATIC: static friction below Coulomb friction. NO_WIND: turbulence
    without a mean speed. SLACK_EXCHANGE: a rope that may slacken, in model exchange. UNSTABLE: the
    gains of the feedback. SHORT_LAG: a lag of a velocity drive so short that runs take hours.
    MANY_TURNS: a plan in which an axis with friction turns too often. SLACK_SLING: a rope that may
    slacken, with a sling. TWO_CHANGES: of the load at one time.
    """

    FITS = 0
    EMPTY_TRAVEL = 1
    NO_LAG = 2
    NOT_SAMPLED = 3
    SHORT_SAMPLE = 4
    LONG_DEAD_TIME = 5
    ROPE_START = 6
    ROPE_BOUNDS = 7
    LENGTHS = 8
    OBSERVER = 9
    LONG_DELAY = 10
    LATE_EXCHANGE = 11
    LOW_STATIC = 12
    NO_WIND = 13
    SLACK_EXCHANGE = 14
    UNSTABLE = 15
    SHORT_LAG = 16
    MANY_TURNS = 17
    SLACK_SLING = 18
    TWO_CHANGES = 19


class SetupFault(Record):
    """A parameter that does not fit."""

    AXIS = field("axis, from 0")
    DRIVE = field("drive, from 0")
    VALUE = field("value that does not fit")
    BOUND = field("what it does not fit to")

class StartStatus(Codes):
    """What is wrong with the state at the start; `StartFault` says where.

    NO_ROPE: the rope has no length. SWAY: the load does not hang below the trolley. FAR: the state
    is far from its reference, FAILED: and the crane has failed soon after. RANGE: the rope is
    outside its bounds.
    """

    FITS = 0
    NO_ROPE = 1
    SWAY = 2
    FAR = 3
    FAILED = 4
    RANGE = 5


class StartFault(Record):
    """A component of the state at the start that does not fit."""

    PLACE = field("component of the state, from 0")
    VALUE = field("its value")
    BOUND = field("that of its reference, or its bound")
    TIME = field("when the crane failed", "s")


class Loop(Record):
    """Settings of the sampled loop."""

    CORRECTOR = field("who corrects, see Corrector", variables=("feedback.source",))
    PERIOD = field("period of the controller", "s", variables=("feedback.sample_time",))
    ENABLED = field("1: corrections act", variables=("feedback.enabled",))
    TOLERANCE = field("tolerance of the integration")
    FADE = field(
        "time constant with which a change of ENABLED fades in; 0: it jumps", "s",
        variables=("feedback.fade",),
    )


class Sensors(Record):
    """Settings of the sensors of the coordinates."""

    SAMPLE_TIME = field("period; 0: continuous", "s", variables=("sensor.sample_time",))
    DEAD_TIME = field("from sampling to the signal", "s", variables=("sensor.dead_time",))
    SEED = field("seed of the noise", variables=("sensor.seed",))
    OFFSET = field(
        "measured minus true value, m or rad", size=Coordinates.SIZE,
        variables=[f"sensor.{s}.offset" for s in SIGNALS],
    )
    DEVIATION = field(
        "standard deviation of the noise, m or rad", size=Coordinates.SIZE,
        variables=[f"sensor.{s}.deviation" for s in SIGNALS],
    )
    RESOLUTION = field(
        "width of a quantisation step, m or rad; 0: none", size=Coordinates.SIZE,
        variables=[f"sensor.{s}.resolution" for s in SIGNALS],
    )


class Settings(Record):
    """Rows: all that is set of a rig."""

    LOOP = field("sampled loop", of=Loop)
    SENSORS = field("sensors", of=Sensors)
    TRACKING = field("tracking controller", of=Tracking)
    PLANT = field("crane and drives", of=Plant)


class PayloadChange(Record):
    """A change of the load."""

    TIME = field("from when on", "s", variables=("payload[{}].time",))
    MASS = field("mass of the load", "kg", variables=("payload[{}].mass",))


class Disturbance(Codes):
    """Changes of the load that an FMU has room for, and sines in the noise of the wind."""

    MOST_CHANGES = 4
    COMPONENTS = 32


class WindNoise(Record):
    """Noise of the wind."""

    DEVIATION = field(
        "standard deviations along x, y and z", "N", size=3,
        variables=[f"wind.noise.deviation.{a}" for a in "xyz"],
    )
    BANDWIDTH = field("largest frequency", "Hz", variables=("wind.noise.bandwidth",))
    SEED = field("seed of the noise", variables=("wind.noise.seed",))


class Turbulence(Record):
    """Turbulence of the air."""

    SPEED = field(
        "mean speed along x, y and z", "m/s", size=3,
        variables=[f"wind.speed.{a}" for a in "xyz"],
    )
    DEVIATION = field(
        "standard deviations along x, y and z", "m/s", size=3,
        variables=[f"wind.turbulence.deviation.{a}" for a in "xyz"],
    )
    LENGTH = field("length scale", "m", variables=("wind.turbulence.length",))
    BANDWIDTH = field("largest frequency", "Hz", variables=("wind.turbulence.bandwidth",))
    SEED = field("seed", variables=("wind.turbulence.seed",))


class Target(Record):
    """Where the load shall be."""

    LOAD = field(
        "reference of its position", "m", size=3,
        variables=[f"reference.load.position.{a}" for a in "xyz"],
    )


class Setpoints(Record):
    """What the crane follows at a time."""

    FORCE = field("forces", "N", size=3, variables=[f"force.{d}" for d in DRIVES])
    VELOCITY = field("velocities", "m/s", size=3, variables=[f"velocity.{d}" for d in DRIVES])
    REFERENCE = field(
        "reference state", size=State.SIZE, of=State,
        variables=[f"reference.{v}" for f in State.FIELDS.values() for v in f.variables],
    )
    WIND = field(
        "force on the load beside the rig's wind", "N", size=3,
        variables=[f"wind.{a}" for a in "xyz"],
    )


class Clock(Record):
    """Times of a rig; those without another zero are since the start."""

    START = field("time of the start", "s")
    REACHED = field("end of the last communication step", "s")
    DONE = field("time done within the present communication step", "s")
    TICKS = field("ticks of the controller")
    NEXT_CHANGE = field("next change of payload or wind", "s")
    EVENT = field("tick that is due, or failure, from the zero of START", "s")
    LAST_TICK = field("last tick, in model exchange", "s")


class Energies(Record):
    """Mechanical energy of the crane."""

    KINETIC = field("kinetic energy", "J")
    POTENTIAL = field("potential energy", "J")


class EnergyMemory(Energies):
    """Mechanical energy, and what changed it beside works."""

    INITIAL = field("energy at the start", "J")
    PAYLOAD = field("energy that payload changes brought", "J")


class Balance(Energies):
    """The balance of energy and work since the start."""

    INITIAL = field("energy at the start", "J")
    DRIVES = field("work of the drives", "J")
    WIND = field("work of the wind", "J")
    PAYLOAD = field("energy that payload changes brought", "J")
    DISSIPATED = field("energy dissipated", "J")


class Sample(Record):
    """A sample that waits for its dead time to pass."""

    AVAILABLE = field("when it becomes the signal", "s")
    VALUES = field("measured values", size=Coordinates.SIZE)


class Queue(Record):
    """State of the ring of samples, integers kept as floats."""

    TAKEN = field("samples taken")
    OLDEST = field("place of the oldest sample")
    WAITING = field("samples in the ring")
    DELIVERED = field("1: a sample has become the signal")


class Ring(Codes):
    """Layout of the ring of samples: as many in a row as fit into one of the memory."""

    SAMPLES_A_ROW = 12


class RingRow(Record):
    """A row of the ring."""

    SAMPLES = field("samples", size=Ring.SAMPLES_A_ROW * Sample.SIZE)


class Sensing(Record):
    """Rows: memory of the sensors."""

    QUEUE = field("state of the ring", of=Queue)
    RANDOM = field("state of the random numbers", of=RandomState)
    LATEST = field("sample that is the signal", of=Coordinates)
    TAKEN = field("work space: the sample that is taken", of=Coordinates)
    RING = field("ring of samples, as many rows as it takes", size=0, of=RingRow)


class Delay(Codes):
    """Memory of the commands that are on their way to the drives.

    A row has as many as fit into one of the memory. Those shorter than the longest dead time over
    RESOLUTION are joined, unless a tick of the controller parts them. MOST_TICKS: of the controller
    in a dead time.
    """

    COMMANDS_A_ROW = 5
    RESOLUTION = 512
    MOST_TICKS = 100000


class SentCommand(Record):
    """Commands of all drives from a time on, cubic in the time since."""

    START = field("from when on they were sent", "s")
    AT_TICK = field("1: the controller's correction changed then")
    VALUE = field("commands then, N or m/s", size=3)
    LINEAR = field("coefficients of the time", size=3)
    SQUARE = field("of its square", size=3)
    CUBE = field("of its cube", size=3)


class CommandQueue(Record):
    """State of the ring of commands, integers kept as floats."""

    OLDEST = field("place of the oldest one")
    WAITING = field("commands in the ring")
    TICKS = field("ticks of the controller when the newest one was sent")


class CommandRow(Record):
    """A row of the ring."""

    COMMANDS = field("commands", size=Delay.COMMANDS_A_ROW * SentCommand.SIZE)


class Delayed(Record):
    """Rows: memory of the commands on their way, behind that of the sensors."""

    QUEUE = field("state of the ring", of=CommandQueue)
    RING = field("ring of commands, as many rows as it takes", size=0, of=CommandRow)


class Planned(Record):
    """What the velocity setpoints alone, without corrections, make the drives do."""

    SETPOINT = field("setpoints at the last tick of the controller, as bounded", "m/s", size=3)
    ACCELERATION = field(
        "accelerations of the drives then; beyond its bound, what a drive lacks", "m/s2", size=3
    )


class Memory(Tick):
    """Rows: all that a rig remembers. A copy of the array is the rig's state."""

    STATE = field("state", of=PlantState)
    PLANT = field("crane and drives, with the present mass of the load", of=Plant)
    CLOCK = field("times", of=Clock)
    LAST = field("setpoints at the end of the last step", of=Setpoints)
    REPORT = field("what acted", of=Report)
    ADDED = field("velocities that corrections have added", "m/s", of=Axes)
    PLANNED = field("what velocity setpoints make the drives do", of=Planned)
    SQUARE = field("what setpoints have of the square of the share of the step done", of=Setpoints)
    CUBE = field("what setpoints have of its cube", of=Setpoints)
    ENERGY = field("energies", of=EnergyMemory)
    WORK = field("commands, and work space of the plant", size=Work.SIZE, of=Work)
    SENSING = field(
        "memory of the sensors, and behind it that of late commands, see Delayed",
        size=Sensing.SIZE, of=Sensing,
    )


class Outputs(Record):
    """What an FMU of the crane shows.

    Where the interface has no text for a variable, it takes unit and meaning from here.
    """

    STATE = field(
        "state", size=State.SIZE, of=State,
        variables=[v for f in State.FIELDS.values() for v in f.variables],
    )
    DEFLECTION = field(
        "deflection of the contact that rubs", "m", size=3,
        variables=[f"friction.{d}.deflection" for d in DRIVES],
    )
    MEASURED = field(
        "signals of the sensors", size=Coordinates.SIZE, of=Coordinates,
        variables=[f"measured.{s}" for s in SIGNALS],
    )
    LOAD_POSITION = field(
        "position of the load", "m", size=3, variables=[f"load.position.{a}" for a in "xyz"]
    )
    LOAD_VELOCITY = field(
        "velocity of the load", "m/s", size=3, variables=[f"load.velocity.{a}" for a in "xyz"]
    )
    LOAD_SPEED = field("speed of the load", "m/s", variables=("load.speed",))
    TOTAL_SWAY = field("angle between rope and vertical", "rad", variables=("sway.total",))
    ERROR = field(
        "load minus its reference", "m", size=3, variables=[f"error.load.{a}" for a in "xyz"]
    )
    ERROR_NORM = field(
        "distance of the load from its reference", "m", variables=("error.load.norm",)
    )
    FORCE = field(
        "forces that the drives apply", "N", size=3, variables=[f"drive.{d}.force" for d in DRIVES]
    )
    SATURATED = field(
        "1: the drive was at a bound in the last step", size=3,
        variables=[f"drive.{d}.saturated" for d in DRIVES],
    )
    POWER = field(
        "power of the drives", "W", size=3, variables=[f"drive.{d}.power" for d in DRIVES]
    )
    ROPE_FORCE = field("force on the rope", "N", variables=("rope.force",))
    PAYLOAD_MASS = field("present mass of the load", "kg", variables=("payload.mass",))
    KINETIC = field("kinetic energy", "J", variables=("energy.kinetic",))
    POTENTIAL = field("potential energy", "J", variables=("energy.potential",))
    WORK = field("work of drives and wind", "J", variables=("energy.work",))
    DRIVE_WORK = field("work of the drives", "J", variables=("energy.drives",))
    WIND_WORK = field("work of the wind", "J", variables=("energy.wind",))
    PAYLOAD = field("energy that payload changes brought", "J", variables=("energy.payload",))
    DISSIPATED = field("energy that friction took", "J", variables=("energy.dissipated",))
    IMBALANCE = field("error of the balance", "J", variables=("energy.imbalance",))
    WIND_POWER = field("power of the wind", "W", variables=("power.wind",))
    FRICTION_POWER = field("power that friction dissipates", "W", variables=("power.friction",))


class Accelerations(Record):
    """Derivatives of velocities, rates and deflections, as variables of model exchange."""

    POSITION = field(
        "of the positions", "m/s2", size=3,
        variables=[f"{a}.acceleration" for a in ("bridge", "trolley", "rope")],
    )
    ANGLE = field(
        "of the sway angles", "rad/s2", size=2,
        variables=("sway.x.acceleration", "sway.y.acceleration"),
    )
    DEFLECTION = field(
        "of the deflections of the contacts", "m/s", size=3,
        variables=[f"friction.{d}.deflection_rate" for d in DRIVES],
    )


class RigPartials(Record):
    """Rows of the rig's partial derivatives."""

    ACCELERATION = field("second derivatives of the coordinates", size=Coordinates.SIZE)
    FORCE = field("forces of the drives", size=3)
    ROPE_FORCE = field("force on the rope")
    DRIVE_POWER = field("power of the drives")
    WIND_POWER = field("power of the wind")
    FRICTION_POWER = field("power of friction")
    DEFLECTION = field("derivatives of the deflections", size=3)


class RigVariables(State):
    """Columns of the rig's partial derivatives: what they are by."""

    COMMAND = field("commands of the drives, forces or velocities", size=3)
    WIND = field("forces on the load", size=3)
    DEFLECTION = field("deflections of the contacts that rub", "m", size=3)
    TIME = field("time")
