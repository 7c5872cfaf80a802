"""Short scenarios in which every parameter and every input of an FMU acts, and how each is changed.

A scenario is start values and inputs; a change of a parameter counts where an output differs.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import cos, sin
from typing import Any

import numpy as np

from segfmu.fmu.gantry_crane.rig_parameters import DRIVES, SIGNALS
from segfmu.fmu.standard.spec import Variable
from segfmu.kernels.clearance.records import SpaceLimits
from tests.fmu.bench import Inputs, Values


def crane_inputs(time: float) -> Values:
    """Setpoints and winds that move every axis, about the place where the crane starts."""
    wave = 0.1 * sin(3.0 * time)
    rate = 0.3 * cos(3.0 * time)
    values = {"force.bridge": 2.0 + wave, "force.trolley": 1.0 - wave, "force.hoist": -9.0 - wave}
    values |= {f"velocity.{d}": v for d, v in zip(DRIVES, (rate, -rate, 0.5 * rate), strict=True)}
    values |= {"reference.bridge.position": wave, "reference.trolley.position": -wave,
               "reference.rope.length": 0.5 + 0.5 * wave}
    return values | WINDS


def still(time: float) -> Values:
    """Inputs stay at their start values, which hold the crane where it is."""
    return {}


def swing(time: float) -> Values:
    """The bridge and its reference swing the load at 3 rad/s, a rope of 0.5 m at constant length.

    The load's place is y = x + l phi with y'' = -g phi, so phi = w^2 x / (g - l w^2).
    """
    rate = 3.0
    angle = rate**2 / (9.81 - 0.5 * rate**2)
    place, velocity = 0.1 * sin(rate * time), 0.1 * rate * cos(rate * time)
    return {
        "velocity.bridge": velocity, "reference.bridge.position": place,
        "reference.bridge.velocity": velocity, "reference.sway.x.angle": angle * place,
        "reference.sway.x.rate": angle * velocity,
    }


@dataclass(frozen=True)
class Scenario:
    """Start values, inputs in motion or not, and the communication points [s]."""

    values: Values
    times: np.ndarray
    motion: Inputs = crane_inputs
    # inputs that are held
    held: Values = field(default_factory=dict)
    # the feedback is off for a while
    switched: bool = False

    def inputs(self, time: float) -> Values:
        """Values of the inputs, and of what is tuned."""
        values = self.motion(time) | self.held
        if self.switched:
            values["feedback.enabled"] = not 0.4 < time < 0.6
        return values


TIMES = np.arange(33) / 40.0

EQUIPMENT: Values = {
    "sway.x.angle": 0.05, "sway.y.angle": -0.04, "sway.x.rate": 0.1, "bridge.velocity": 0.05,
    "trolley.velocity": -0.04, "rope.velocity": 0.03, "friction.width": 0.02,
    "friction.sway.viscous": 0.01, "wind.gust.start": 0.1, "wind.gust.duration": 0.3,
    "wind.noise.seed": 3, "payload.count": 4, "sensor.sample_time": 0.01,
    "sensor.dead_time": 0.02, "sensor.seed": 5,
}
EQUIPMENT |= {f"friction.{d}.viscous": 0.5 for d in DRIVES}
EQUIPMENT |= {f"friction.{d}.coulomb": 0.3 for d in DRIVES}
EQUIPMENT |= {f"friction.{d}.static": 0.4 for d in DRIVES} | {"friction.presliding": 1e-4}
EQUIPMENT |= {f"wind.{n}.{a}": 0.2 for n in ("constant", "gust.force") for a in "xyz"}
EQUIPMENT |= {f"wind.noise.deviation.{a}": 0.1 for a in "xyz"}
EQUIPMENT |= {f"wind.{n}.{a}": 0.3 for n in ("speed", "gust.speed") for a in "xyz"}
EQUIPMENT |= {f"wind.turbulence.deviation.{a}": 0.2 for a in "xyz"}
EQUIPMENT |= {"wind.turbulence.length": 2.0, "load.drag_area": 0.1}
EQUIPMENT |= {f"sensor.{s}.resolution": 1e-6 for s in SIGNALS}
EQUIPMENT |= {f"sensor.{s}.deviation": 1e-4 for s in SIGNALS}
EQUIPMENT |= {f"sensor.{s}.offset": 1e-3 for s in SIGNALS}
for _i in range(1, 5):
    EQUIPMENT |= {f"payload[{_i}].time": 0.15 * _i, f"payload[{_i}].mass": 1.0 + 0.1 * _i}
QUIET: Values = {n: v for n, v in EQUIPMENT.items() if not n.startswith(("sensor", "payload"))}
FORCE_BOUNDS: Values = {
    f"drive.{d}.force_max": m for d, m in zip(DRIVES, (2.05, 1.05, 9.5), strict=True)
}
LAGS: Values = {f"drive.{d}.lag": 0.05 for d in DRIVES}
ACCELERATIONS: Values = {f"drive.{d}.acceleration_max": 0.5 for d in DRIVES}
DELAYS: Values = {f"drive.{d}.dead_time": 0.013 for d in DRIVES}
POWERS: Values = {f"drive.{d}.power_max": 0.5 for d in DRIVES}
SPEEDS: Values = {f"drive.{d}.velocity_max": 0.1 for d in DRIVES}
# pressed from the start on
BUFFERS: Values = {f"travel.{a}.stiffness": 20.0 for a in ("bridge", "trolley", "rope")}
BUFFERS |= {f"travel.{a}.damping": 3.0 for a in ("bridge", "trolley", "rope")}
BUFFERS |= {"travel.bridge.max": -0.01, "travel.trolley.min": 0.01, "travel.rope.max": 0.499}
OBSERVED: Values = {
    "feedback.source": "measured", "sensor.rope.length.offset": 0.01,
}
WINDS: Values = {"wind.x": 0.2, "wind.y": -0.3, "wind.z": 0.1}
FLAT: Values = {"feedback.design": "flatness"}
VELOCITY: Values = {"drive.mode": "velocity"}

# in the order in which they are tried
CRANE: dict[str, Scenario] = {
    "equipment": Scenario(EQUIPMENT | FORCE_BOUNDS | FLAT, TIMES),
    "velocity": Scenario(
        EQUIPMENT | VELOCITY | LAGS | DELAYS | ACCELERATIONS | SPEEDS | POWERS | FLAT, TIMES
    ),
    "buffers": Scenario(BUFFERS, TIMES[:5]),
    "observer": Scenario(
        QUIET | OBSERVED | FLAT, np.arange(61) / 20.0, motion=still, held=WINDS, switched=True
    ),
    "lqr": Scenario({"sway.x.angle": 0.05, "sway.y.angle": 0.04, "rope.length": 0.52}, TIMES[:5],
                    held={"reference.bridge.position": 0.02}),
    "observed lqr": Scenario({"feedback.source": "measured"}, TIMES, motion=still, held=WINDS),
    "swing": Scenario(
        OBSERVED | VELOCITY | LAGS | FLAT | {
            "sensor.sample_time": 0.01, "sensor.rope.length.offset": 0.03,
            "feedback.enabled": False, "bridge.velocity": 0.3,
            "sway.x.rate": swing(0.0)["reference.sway.x.rate"],
        },
        np.arange(201) / 20.0, motion=swing,
    ),
    "lifting": Scenario(
        VELOCITY | LAGS | FLAT, TIMES[:5], motion=still, held={"velocity.hoist": -0.1}
    ),
    "slack": Scenario(
        {"rope.slack": "free_fall", "feedback.enabled": False}, TIMES[:5], motion=still,
        held={"force.hoist": 1.0},
    ),
}


def row_scenario(length: float, more: Values | None = None) -> Scenario:
    """With a rope of nearly the length of a row of the table of gains."""
    values = (more or {}) | {"start.on_reference": False, "rope.length": 0.995 * length,
              "sway.x.rate": 0.1, "sway.y.rate": 0.1, "sway.x.angle": 0.05,
              "sway.y.angle": 0.05, "rope.velocity": 0.1}
    held = {"reference.rope.length": length, "reference.bridge.position": 0.1,
            "reference.trolley.position": 0.1}
    return Scenario(values, TIMES[:3], motion=still, held=held)

ZIGZAG: Values = {"waypoint.count": 16, "planner.shape": "plateau"}
for _i in range(1, 17):
    ZIGZAG |= {f"waypoint[{_i}].position.{a}": p for a, p in zip(
        "xyz", (0.1 * _i if _i < 16 else 0.9, 0.3 * (_i % 2), -0.5 - 0.05 * (_i % 3)), strict=True
    )}
    ZIGZAG |= {f"waypoint[{_i}].{n}.{a}": 0.0 for n in ("velocity", "acceleration") for a in "xyz"}

# the same without rest: a state that is free instead is another one
MOVING: Values = ZIGZAG | {
    f"waypoint[{_i}].{n}.{a}": v for _i in range(1, 17)
    for n, v in (("velocity", 0.03), ("acceleration", 0.02)) for a in "xyz"
}

# close enough to see a contact deflect
RUBBING: Values = {f"friction.{d}.coulomb": 0.3 for d in DRIVES}
RUBBING |= {f"friction.{d}.static": 0.4 for d in DRIVES} | {"friction.presliding": 1e-4}

# bounds that the zigzag keeps
BOUNDS: Values = {f"drive.{d}.{q}_max": 50.0 for d in DRIVES
                  for q in ("force", "velocity", "acceleration", "power")}
BOUNDS |= {f"sway.{a}.angle_max": 1.0 for a in "xy"}
BOUNDS |= {f"travel.{a}.{n}": s for a in ("bridge", "trolley", "rope")
           for n, s in (("min", -1.0), ("max", 2.0))}

# the load of the paper's mission is within these; boxes on one side of it, which they cover else
WITHIN = ((-0.1, 1.1), (-0.1, 0.9), (-0.6, -0.4))
BESIDE = ((3.0, 4.0), (3.0, 4.0), (-0.35, -0.3)), ((-4.0, -3.0), (-4.0, -3.0), (-4.0, -3.0))


def boxes(axis: int, side: int, rope: bool = False) -> Values:
    """Obstacles beyond (0) or before (1) the load along an axis."""
    ends = [BESIDE[side][k] if k == axis else WITHIN[k] for k in range(3)]
    values: Values = {"obstacle.count": SpaceLimits.OBSTACLES}
    for i in range(1, SpaceLimits.OBSTACLES + 1):
        values[f"obstacle[{i}].rope"] = rope
        for a, (low, high) in zip("xyz", ends, strict=True):
            values[f"obstacle[{i}].minimum.{a}"] = low
            values[f"obstacle[{i}].maximum.{a}"] = high
    return values


# the second waypoint at rest, with bounds that the default limits exceed
REST: Values = {
    f"waypoint[2].{name}.{axis}": 0.0 for name in ("velocity", "acceleration") for axis in "xy"
} | {"drive.trolley.acceleration_max": 0.05}
FEEDFORWARD: dict[str, Scenario] = {
    "paper": Scenario({}, np.linspace(0.0, 5.0, 26), motion=still),
    "zigzag": Scenario(ZIGZAG, np.linspace(0.0, 60.0, 31), motion=still),
    "moving": Scenario(MOVING, np.linspace(0.0, 60.0, 31), motion=still),
    "friction": Scenario(RUBBING, np.linspace(0.0, 0.2, 41), motion=still),
    "bounds": Scenario(ZIGZAG | BOUNDS, TIMES[:2], motion=still),
    "slowed": Scenario(
        {"drive.trolley.acceleration_max": 0.05, "planner.slows_down": True}, TIMES[:2], still
    ),
    "found": Scenario(BOUNDS | REST | {"planner.finds_limits": True}, TIMES[:2], still),
}
BOXES = {
    f"{('beyond', 'before')[side]} {'xyz'[axis]}": Scenario(boxes(axis, side), TIMES[:2], still)
    for axis in range(3) for side in range(2)
}
FEEDFORWARD |= BOXES
# in the way, but not in use
FEEDFORWARD["unused"] = Scenario(
    boxes(2, 0) | {"obstacle.count": 0, "obstacle[1].minimum.z": -0.6}, TIMES[:2], still
)


def pushes(time: float) -> Values:
    """The stick is pushed along all axes after a while."""
    return {f"command.velocity.{a}": float(time > 0.05) for a in "xyz"}


# velocities beyond the limits, scaled; a target; pushes
COMMANDED: Values = {"command.enabled": True, "limits.scale": 0.5}
for _a, _p in zip("xyz", (0.3, 0.2, -0.45), strict=True):
    COMMANDED |= {f"command.velocity.{_a}": 0.1, f"command.target.{_a}": _p}
FEEDFORWARD |= {
    "joystick": Scenario(COMMANDED | {"command.mode": "velocity"}, TIMES, still),
    "fast": Scenario(
        COMMANDED | {"command.mode": "velocity", "command.velocity.x": 9.0}, 4.0 * TIMES, still
    ),
    "target": Scenario(COMMANDED | {"command.mode": "target"}, TIMES, still),
    "beyond": Scenario(
        COMMANDED | {"command.mode": "target", "command.target.x": 5.0, "workspace.x.max": 1.1},
        TIMES, still,
    ),
    "inching": Scenario(COMMANDED | {"command.mode": "inching"}, TIMES, pushes),
}
# a swing that is taken over at the start
MEASURED: Values = {
    "command.take_over": True, "measured.bridge.position": 0.1, "measured.trolley.position": -0.1,
    "measured.rope.length": 0.5, "measured.sway.x.angle": 0.05, "measured.sway.y.angle": -0.04,
    "measured.bridge.velocity": 0.05, "measured.trolley.velocity": -0.05,
    "measured.rope.velocity": 0.02, "measured.sway.x.rate": 0.1, "measured.sway.y.rate": 0.1,
    **{f"drive.{drive}.acceleration_max": 0.9 for drive in DRIVES},
}
FEEDFORWARD["taken over"] = Scenario(
    COMMANDED | {"command.mode": "stop"} | MEASURED, TIMES, still
)


def trips(time: float) -> Values:
    """All drives trip while the load moves."""
    return {f"command.tripped.{drive}": time > 0.15 for drive in DRIVES}


BRAKED: Values = {
    "command.foresees": True,
    **{f"drive.{drive}.acceleration_max": 0.9 for drive in DRIVES},
    **{f"drive.{drive}.brake_deceleration": 0.5 for drive in DRIVES},
}
FEEDFORWARD["tripped"] = Scenario(
    COMMANDED | {"command.mode": "velocity"} | BRAKED, 2.0 * TIMES, trips
)


# where a small change does nothing yet
CHANGES: Values = {
    "limits.x.velocity": 0.4, "limits.z.velocity": 0.1, "limits.x.acceleration": 0.2,
    **{f"limits.{axis}.velocity_min": -0.05 for axis in "xyz"},
    **{f"limits.{axis}.acceleration_min": -0.1 for axis in "xyz"},
    **{f"drive.{drive}.velocity_min": -0.02 for drive in DRIVES},
    **{f"drive.{drive}.acceleration_min": -0.1 for drive in DRIVES},
    **{f"drive.{drive}.force_min": -0.05 for drive in DRIVES},
    "limits.y.acceleration": 0.2, "limits.z.acceleration": 0.05, "planner.smoothness": 5,
    "planner.duration": 80.0, "planner.start_time": 0.3,
    "command.tries": 1, "feedback.observer.wake": 100.0, "feedback.observer.offset": 0.02,
}


def of_bounds() -> dict[str, tuple[str, Any, str]]:
    """Refusals by bounds of the negative direction."""
    values = {"force": -0.01, "velocity": -0.02, "acceleration": -0.1}
    return {
        name: ("zigzag", value, f"{name} is {value:g} ")
        for drive in DRIVES for quantity, value in values.items()
        for name in [f"drive.{drive}.{quantity}_min"]
    }


def of_travel() -> dict[str, tuple[str, Any, str]]:
    """Refusals by end stops."""
    found: dict[str, tuple[str, Any, str]] = {}
    for axis, stops in zip(("bridge", "trolley", "rope"), ((0.2, 0.7), (0.2, 0.5), (0.52, 0.49)),
                           strict=True):
        for name, stop in zip(("min", "max"), stops, strict=True):
            found[f"travel.{axis}.{name}"] = (
                "paper", stop, f"the plan takes the {axis} to"
            )
    return found


def of_space() -> dict[str, tuple[str, Any, str]]:
    """Refusals by workspace, obstacles and the size of the load."""
    found: dict[str, tuple[str, Any, str]] = {
        "obstacle.count": ("unused", 1, "obstacle 1: the load meets it"),
    }
    for axis, (low, high) in zip("xyz", WITHIN, strict=True):
        middle = 0.5 * (low + high) - (0.01 if axis == "z" else 0.0)
        found[f"workspace.{axis}.max"] = ("paper", middle, f"workspace.{axis}: the load leaves")
        middle = 0.5 * (low + high) + (0.01 if axis == "z" else 0.0)
        found[f"workspace.{axis}.min"] = ("paper", middle, f"workspace.{axis}: the load leaves")
        found[f"load.size.{axis}"] = (f"beyond {axis}", 10.0, "obstacle 1: the load meets it")
        found[f"load.centre.{axis}"] = (
            f"beyond {axis}", 0.18 if axis == "z" else 3.0, "obstacle 1: the load meets it"
        )
    for i in range(1, SpaceLimits.OBSTACLES + 1):
        name, words = f"obstacle[{i}]", f"obstacle {i}: the load meets it"
        for axis, (low, high) in zip("xyz", WITHIN, strict=True):
            found[f"{name}.minimum.{axis}"] = (f"beyond {axis}", low, words)
            found[f"{name}.maximum.{axis}"] = (f"before {axis}", high, words)
        found[f"{name}.margin"] = ("beyond z", 0.2, words)
        found[f"{name}.rope"] = ("beyond z", True, f"obstacle {i}: the rope meets it")
    return found


# what only ever refuses: the scenario, a value that is refused, and a part of what is said
REFUSALS: dict[str, dict[str, tuple[str, Any, str]]] = {
    "feedforward": {
        "crane.rope_min": ("paper", 0.55, "rope length passes rope_min"),
        "crane.rope_max": ("paper", 0.45, "rope length passes rope_max"),
        "planner.finds_limits": ("found", False, "drive.trolley.acceleration_max is 0.05 m/s2"),
        "planner.slows_down": ("slowed", False, "drive.trolley.acceleration_max is 0.05 m/s2"),
        **of_bounds(), **of_travel(), **of_space(),
    },
    "crane": {
        "travel.bridge.min": ("equipment", 0.001, "bridge at 0 m is at its end stop, least"),
        "travel.bridge.max": ("equipment", 0.01, "bridge at 0.01 m is at its end stop, greatest"),
        "travel.trolley.min": ("equipment", 0.001, "trolley at 0 m is at its end stop, least"),
        "travel.trolley.max": ("equipment", -0.01, "trolley at 0 m is at its end stop, greatest"),
        "travel.rope.min": ("equipment", 0.501, "rope at 0.5 m is at its end stop, least"),
        "travel.rope.max": ("equipment", 0.499, "rope at 0.5 m is at its end stop, greatest"),
        "rope.slack": ("slack", "error", "the rope went slack"),
        # what it does needs inputs that are read back before a step: tests/cosim/test_lead.py
        "setpoint.lead": ("lqr", -0.01, "setpoint.lead must be at least 0"),
        "feedback.table.mode": ("lqr", "velocity", "feedback.table are for the other drive.mode"),
    },
}


def changed(variable: Variable, value: Any) -> Any:
    """Another value of a parameter or an input, a little away."""
    if variable.name in CHANGES:
        return CHANGES[variable.name]
    if variable.kind == "Boolean":
        return not value
    if isinstance(value, str):
        return next(item for item in variable.enumeration.items if item != value)
    if variable.kind == "Enumeration":
        return 2 if value == 1 else 1
    if variable.kind == "Integer":
        return value + 1 if value < 4 else value - 1
    if value == 0.0:
        return 0.01
    most = variable.maximum
    return 1.03 * value if most is None or 1.03 * value <= most else 0.97 * value
