"""GantryCrane's parameters of the real equipment: `segfmu.crane.Rig` as variables."""

from __future__ import annotations

from segfmu.crane.checks import HIGHEST_FREQUENCY, LARGEST_SEED
from segfmu.crane.disturbance import SHAPES
from segfmu.crane.equipment import SLACK
from segfmu.fmu.gantry import friction_parameters
from segfmu.fmu.standard.spec import Enumeration, Variable, beginning, choice, parameter
from segfmu.kernels.crane.records import AXES, DRIVES
from segfmu.kernels.rig.records import SIGNALS, Disturbance

GUST_SHAPES = Enumeration("GustShape", SHAPES, "course of a gust over time")
SLACK_ROPES = Enumeration("SlackRope", SLACK, "a rope that would have to push")
# position of an end stop that stands for none
FAR = 1e9


def rig_parameters() -> list[Variable]:
    """All of them; by default everything is ideal."""
    return [
        *_drives(), *friction_parameters(), _sway_friction(), *_travel(), *_sensors(), *_wind(),
        *_payload(),
    ]


def _drives() -> list[Variable]:
    rows = []
    for drive in DRIVES:
        name = f"drive.{drive}"
        rows += [
            parameter(
                f"{name}.lag", 0.0, "s", f"time constant of the {drive} drive in mode velocity; "
                "0: none", minimum=0.0,
            ),
            parameter(
                f"{name}.force_max", 0.0, "N", f"largest force of the {drive} drive; 0: no bound",
                minimum=0.0,
            ),
            _least(f"{name}.force", "N", f"force of the {drive} drive"),
            parameter(
                f"{name}.acceleration_max", 0.0, "m/s2",
                f"largest acceleration of the {drive} drive in mode velocity; 0: no bound",
                minimum=0.0,
            ),
            _least(
                f"{name}.acceleration", "m/s2",
                f"acceleration of the {drive} drive in mode velocity",
            ),
            parameter(
                f"{name}.velocity_max", 0.0, "m/s",
                f"largest velocity of the {drive} drive; 0: no bound", minimum=0.0,
            ),
            _least(f"{name}.velocity", "m/s", f"velocity of the {drive} drive"),
            parameter(
                f"{name}.power_max", 0.0, "W",
                f"largest power of the {drive} drive, driving or braking; 0: no bound",
                minimum=0.0,
            ),
            parameter(
                f"{name}.dead_time", 0.0, "s",
                f"from the command of the {drive}, setpoint and correction, to the drive; in model "
                "exchange 0", minimum=0.0,
            ),
        ]
    return rows


def _least(name: str, unit: str, text: str) -> Variable:
    """The bound in the negative direction beside one in the positive direction."""
    return parameter(
        f"{name}_min", 0.0, unit, f"least {text}, below 0; 0: minus the largest", maximum=0.0
    )


def _sway_friction() -> Variable:
    return parameter(
        "friction.sway.viscous", 0.0, "N.m.s", "damping of both sway angles", minimum=0.0
    )


def _travel() -> list[Variable]:
    rows = []
    for axis in AXES:
        text = "end stop of the rope's length" if axis == "rope" else f"end stop of the {axis}"
        rows += [
            parameter(f"travel.{axis}.min", -FAR, "m", f"lower {text}"),
            parameter(f"travel.{axis}.max", FAR, "m", f"upper {text}"),
            parameter(
                f"travel.{axis}.stiffness", 0.0, "N/m",
                "stiffness of its buffers; 0: none, reaching it is an error", minimum=0.0,
            ),
            parameter(
                f"travel.{axis}.damping", 0.0, "N.s/m",
                "damping of its buffers, which have a stiffness", minimum=0.0,
            ),
        ]
    return [
        *rows,
        choice(
            "rope.slack", SLACK_ROPES, "error", "where the rope would have to push: an error, or "
            "free fall of the load until the rope is taut again; in model exchange error",
        ),
    ]


def _sensors() -> list[Variable]:
    rows = [
        parameter("sensor.sample_time", 0.0, "s", "period; 0: continuous", minimum=0.0),
        parameter(
            "sensor.dead_time", 0.0, "s", "from sampling to the signal; needs sensor.sample_time",
            minimum=0.0,
        ),
        _seed("sensor.seed", "seed of the sensors' noise"),
    ]
    for name in SIGNALS:
        unit = "rad" if name.endswith("angle") else "m"
        rows += [
            parameter(
                f"sensor.{name}.resolution", 0.0, unit, "quantisation step; 0: none", minimum=0.0
            ),
            parameter(
                f"sensor.{name}.deviation", 0.0, unit,
                "standard deviation of the noise; needs sensor.sample_time", minimum=0.0,
            ),
            parameter(f"sensor.{name}.offset", 0.0, unit, "measured minus true value"),
        ]
    return rows


def _wind() -> list[Variable]:
    return [
        *_vector("wind.constant", "constant wind"),
        beginning("wind.gust.start", "start of the gust"),
        parameter("wind.gust.duration", 0.0, "s", "duration of the gust; 0: none", minimum=0.0),
        choice("wind.gust.shape", GUST_SHAPES, "cosine", "1 - cosine, or half a sine"),
        *_vector("wind.gust.force", "peak of the gust"),
        *_vector("wind.noise.deviation", "standard deviation of the wind's noise", minimum=0.0),
        parameter("wind.noise.bandwidth", 1.0, "Hz", "largest frequency in it", minimum=1e-9,
                  maximum=HIGHEST_FREQUENCY),
        _seed("wind.noise.seed", "seed of the wind's noise"),
        *_vector("wind.speed", "mean speed of the air", unit="m/s"),
        *_vector("wind.gust.speed", "peak of the gust's speed", unit="m/s"),
        *_vector("wind.turbulence.deviation", "standard deviation of the air's turbulence; needs "
                 "wind.speed", minimum=0.0, unit="m/s"),
        parameter("wind.turbulence.length", 1200.0, "m", "length scale of Davenport's spectrum",
                  minimum=1e-3),
        parameter("wind.turbulence.bandwidth", 1.0, "Hz", "largest frequency of the turbulence",
                  minimum=1e-9, maximum=HIGHEST_FREQUENCY),
        _seed("wind.turbulence.seed", "seed of the turbulence"),
        parameter("wind.air_density", 1.225, "kg/m3", "density of the air", minimum=0.0),
        parameter("load.drag_area", 0.0, "m2", "drag coefficient of the load times its area; 0: "
                  "the air's speed does not act", minimum=0.0),
    ]


def _payload() -> list[Variable]:
    rows = [
        parameter(
            "payload.count", 0, None, "number of payload changes in use", kind="Integer",
            minimum=0, maximum=Disturbance.MOST_CHANGES,
        )
    ]
    for i in range(1, Disturbance.MOST_CHANGES + 1):
        rows += [
            parameter(f"payload[{i}].time", 0.0, "s", "time of a payload change"),
            parameter(f"payload[{i}].mass", 1.0, "kg", "mass of the load from then on",
                      minimum=1e-9),
        ]
    return rows


def _vector(
    prefix: str, text: str, minimum: float | None = None, unit: str = "N"
) -> list[Variable]:
    return [parameter(f"{prefix}.{a}", 0.0, unit, f"{text}, {a}", minimum=minimum) for a in "xyz"]


def _seed(name: str, text: str) -> Variable:
    return parameter(name, 0, None, text, kind="Integer", minimum=0, maximum=LARGEST_SEED)
