"""A load on hook and sling, 20 m across a hall: duration, residual sway, feedback, time of a plan.

The gantry crane's methods take hook and load for one load at the end of rope and sling.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import replace
from time import perf_counter

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.optimize import linprog

from benchmarks.report import Part, Record, Section, Settings
from segfmu import ActuatorBounds, Crane, HookCrane, SimulationError, Waypoint, plan_actuated
from segfmu.crane import (
    FlatInverse,
    Plant,
    Setpoints,
    TrackingController,
    Uncertainty,
    design_lqr,
    design_observer,
)
from segfmu.crane.hook import HookController, design_hook
from segfmu.errors import BuildError
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import chosen
from segfmu.fmu.hook_feedforward import interface
from segfmu.fmu.standard.spec import started
from segfmu.kernels.crane.records import DRIVES

FloatArray = NDArray[np.float64]
CRANE = HookCrane(Crane(8e4, 1.2e4, 1e4, rope_min=2.0, rope_max=12.0), 500.0, 4.0)
DISTANCE, ROPE, VELOCITY, ACCELERATION = 20.0, 6.0, 1.2, 0.3
DEPTH = ROPE + CRANE.sling
POINTS = (Waypoint([0.0, 0.0, -DEPTH]), Waypoint([0.0, DISTANCE, -DEPTH]))
WHOLE = replace(CRANE.crane, payload_mass=CRANE.crane.payload_mass + CRANE.hook_mass, rope_max=20.0)
# of the drives that the plan leaves to the feedback
ROOM = 0.85
STEP, PERIOD = 0.01, 0.05
SWING = 2.0 * np.pi * np.sqrt(DEPTH / CRANE.gravity)
# loads and slings over those planned for
CORNERS = tuple(itertools.product((0.7, 1.0, 1.3), (0.9, 1.0, 1.1)))
# places of a hook's state that the gantry crane has too, and of all angles
GANTRY, ANGLES = [0, 1, 2, 3, 4, 7, 8, 9, 10, 11], [3, 4, 5, 6]


def measure(settings: Settings) -> Part:
    """Duration over its optimum, sway behind the move, feedback, and the plan inside the FMU."""
    quick = settings.samples <= 100
    return Part(
        "A load on hook and sling",
        (
            Section(
                "20 m, rope 6 m, sling 4 m, 10 t, trolley 1.2 m/s and 0.3 m/s2",
                _durations(100 if quick else 400),
            ),
            Section("feedforward alone: largest angle of rope or sling behind the move", _left()),
            Section(
                "load 0.7 to 1.3, sling 0.9 to 1.1, measured signals, a sixth of the drives left: "
                "largest angle from a swing after the arrival on", _corners(quick),
            ),
            Section("smoothness 6 within the drives, inside HookFeedforward", _plans(settings)),
        ),
        (
            "linear program: HiGHS, the trolley's acceleration constant in each interval, small "
            "angles, no smoothness",
            "trapezoid, ZV for both swings: 20 / 1.2 + 1.2 / 0.3 s and half of each period",
        ),
    )


def bounds(share: float = 1.0) -> ActuatorBounds:
    """Of all drives, or a share of them."""
    return ActuatorBounds(
        velocity=[share * VELOCITY, share * VELOCITY, 0.2],
        acceleration=[share * ACCELERATION, share * ACCELERATION, 0.2],
    )


def shortest(intervals: int, tolerance: float = 1e-4) -> float:
    """The shortest rest-to-rest transfer [s], by bisection."""
    low = DISTANCE / VELOCITY + VELOCITY / ACCELERATION
    high = 2.0 * low
    while high - low > tolerance * high:
        middle = 0.5 * (low + high)
        if _feasible(middle, intervals):
            high = middle
        else:
            low = middle
    return high


def _feasible(duration: float, intervals: int) -> bool:
    """Whether trolley, hook and load can be at rest at the end of a duration [s].

    Newton's equations at small angles, with the trolley's acceleration as input.
    """
    gravity, sling = CRANE.gravity, CRANE.sling
    ratio = CRANE.crane.payload_mass / CRANE.hook_mass
    model = np.zeros((7, 7))
    model[:3, 3:6] = np.eye(3)
    model[3, 6] = 1.0
    # the pulls of rope and sling on the hook, then of the sling on the load
    model[4, :3] = gravity * np.array([
        (1.0 + ratio) / ROPE, -(1.0 + ratio) / ROPE - ratio / sling, ratio / sling
    ])
    model[5, 1:3] = gravity / sling * np.array([1.0, -1.0])
    step = expm(model * duration / intervals)
    states = np.zeros((intervals + 1, 6, intervals))
    for k in range(intervals):
        states[k + 1] = step[:6, :6] @ states[k]
        states[k + 1, :, k] += step[:6, 6] * ACCELERATION
    speeds = states[1:-1, 3] / VELOCITY
    found = linprog(
        np.zeros(intervals), A_ub=np.vstack([speeds, -speeds]), b_ub=np.ones(2 * len(speeds)),
        A_eq=states[-1], b_eq=[DISTANCE] * 3 + [0.0] * 3, bounds=(-1.0, 1.0), method="highs",
    )
    return bool(found.status == 0)


def _durations(intervals: int) -> list[Record]:
    optimum = shortest(intervals)
    shaped = DISTANCE / VELOCITY + VELOCITY / ACCELERATION + sum(np.pi / CRANE.frequencies(ROPE))
    rows = {"linear program": optimum, "trapezoid, ZV for both swings": float(shaped)}
    for shape in ("smoothstep", "plateau"):
        found = plan_actuated(CRANE, POINTS, None, bounds(), smoothness=6, shape=shape)
        rows[f"smoothness 6, {shape}"] = found.trajectory.duration
    return [
        {"plan": name, "duration s": duration, "over optimum": duration / optimum}
        for name, duration in rows.items()
    ]


class Move:
    """A plan, its setpoints and its reference, for a crane with a hook or for one without."""

    def __init__(self, crane: Crane | HookCrane, smoothness: int, shape: str, share: float) -> None:
        self.trajectory = plan_actuated(
            crane, POINTS, None, bounds(share), smoothness=smoothness, shape=shape
        ).trajectory
        inverse = FlatInverse(crane, self.trajectory)
        self.times = np.arange(0.0, self.trajectory.duration + 4.0 * SWING, STEP)
        self.velocity, self.states = inverse.velocity(self.times), inverse.state(self.times)
        if isinstance(crane, HookCrane):
            self.states = self.states[:, GANTRY]
        else:
            # its rope ends at the load
            self.states[:, 2] -= CRANE.sling

    def sway(self, true: HookCrane, controller: HookController | TrackingController | None,
             delay: float) -> float:
        """Largest angle [deg] from a delay [s] after the arrival on; NaN where the crane fails."""
        start = np.zeros(14)
        start[2] = ROPE
        setpoints = [
            Setpoints(velocity=v, reference=r)
            for v, r in zip(self.velocity, self.states, strict=True)
        ]
        plant = Plant(
            true, start, setpoints[0], controller or hook_controller(), driven=True,
            enabled=controller is not None,
        )
        most = 0.0
        for time, one in zip(self.times[1:].tolist(), setpoints[1:], strict=True):
            try:
                plant.step(STEP, one)
            except SimulationError:
                return float("nan")
            if time >= self.trajectory.duration + delay:
                most = max(most, float(np.abs(plant.state[ANGLES]).max()))
        return float(np.degrees(most))


def hook_controller() -> HookController:
    """The feedback with a hook, for the crane that is planned for."""
    feedback = design_hook(
        CRANE, sample_time=PERIOD, shortest=2.0, longest=12.0, driven=True
    )
    most = np.array([ACCELERATION, ACCELERATION, 0.2])
    return HookController(feedback, -most, most)


def gantry_controller() -> TrackingController:
    """The gantry crane's feedback of measured signals, awake."""
    most = np.array([ACCELERATION, ACCELERATION, 0.2])
    observer = design_observer(
        WHOLE, sample_time=PERIOD, shortest=2.0, longest=16.0, driven=True,
        uncertainty=Uncertainty(wake=0.0),
    )
    gains = design_lqr(WHOLE, sample_time=PERIOD, shortest=2.0, longest=16.0, driven=True)
    return TrackingController(
        observer, gains, lower=-most, upper=most,
        velocity_max=np.array([VELOCITY, VELOCITY, 0.2]),
    )


def _left() -> list[Record]:
    moves: dict[str, tuple[Crane | HookCrane, int, str]] = {
        "gantry, smoothness 4": (WHOLE, 4, "plateau"),
        "gantry, smoothness 6": (WHOLE, 6, "smoothstep"),
        "hook, smoothness 6": (CRANE, 6, "smoothstep"),
    }
    rows: list[Record] = []
    for name, (crane, smoothness, shape) in moves.items():
        move = Move(crane, smoothness, shape, 1.0)
        rows.append({
            "feedforward": name, "duration s": move.trajectory.duration,
            "sway deg": move.sway(CRANE, None, 0.0),
        })
    return rows


def _corners(quick: bool) -> list[Record]:
    hook = Move(CRANE, 6, "smoothstep", ROOM)
    gantry = Move(WHOLE, 4, "plateau", ROOM)
    rows: list[Record] = []
    for load, sling in CORNERS[::4] if quick else CORNERS:
        plain = replace(CRANE.crane, payload_mass=load * CRANE.crane.payload_mass)
        true = HookCrane(plain, CRANE.hook_mass, sling * CRANE.sling)
        found = [
            hook.sway(true, None, SWING), hook.sway(true, hook_controller(), SWING),
            gantry.sway(true, None, SWING), gantry.sway(true, gantry_controller(), SWING),
        ]
        names = ("hook deg", "hook + feedback deg", "gantry deg", "gantry + feedback deg")
        rows.append({"load": load, "sling": sling, **dict(zip(names, found, strict=True))})
    return rows


def _plans(settings: Settings) -> list[Record]:
    values = {
        f"limits.{axis}.{name}": 0.0
        for axis in "xyz" for name in ("velocity", "acceleration", "jerk", "snap")
    }
    values |= CRANE.values() | {"planner.finds_limits": True, "waypoint.count": 2}
    own = bounds()
    for i, drive in enumerate(DRIVES):
        values[f"drive.{drive}.velocity_max"] = float(own.velocity[i])
        values[f"drive.{drive}.acceleration_max"] = float(own.acceleration[i])
    rows: list[Record] = []
    for name, last in (
        ("20 m", [0.0, DISTANCE, -DEPTH]), ("20 m, 5 m aside, lifted by 3 m", [5.0, 20.0, -7.0]),
    ):
        for i, place in enumerate(([0.0, 0.0, -DEPTH], last), 1):
            values |= {f"waypoint[{i}].position.{a}": p for a, p in zip("xyz", place, strict=True)}
        values |= {
            f"waypoint[2].{n}.{a}": 0.0 for n in ("velocity", "acceleration") for a in "xyz"
        }
        try:
            times, duration = _initialised(settings, values)
        except BuildError:
            continue
        rows.append({
            "move": name, "duration s": duration, "median ms": 1e3 * float(np.median(times)),
            "largest ms": 1e3 * max(times),
        })
    return rows


def _initialised(
    settings: Settings, values: Mapping[str, float]
) -> tuple[list[float], float]:
    """Times of initialisations [s], and the duration of the plan [s]."""
    choice = chosen(2, "native", "", everywhere=False)
    (path,) = build_all(settings.folder / "hooks", choice, [started(interface.spec(), values)])
    folder = extract(str(path))
    described = read_model_description(folder)
    references = {v.name: v.valueReference for v in described.modelVariables}
    times, duration = [], 0.0
    for i in range(settings.repetitions):
        fmu = FMU2Slave(
            guid=described.guid, unzipDirectory=folder, instanceName=f"plan{i}",
            modelIdentifier=described.coSimulation.modelIdentifier,
        )
        fmu.instantiate()
        fmu.setupExperiment()
        begin = perf_counter()
        fmu.enterInitializationMode()
        fmu.exitInitializationMode()
        times.append(perf_counter() - begin)
        duration = fmu.getReal([references["plan.duration"]])[0]
        fmu.terminate()
        fmu.freeInstance()
    return times, duration
