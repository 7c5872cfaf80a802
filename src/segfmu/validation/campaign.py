"""The campaign: every method under every disturbance, and a verdict on the feedback.

Metrics, units and the verdict are defined in docs/campaign.md.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from math import ceil
from multiprocessing import get_context

import numpy as np

from segfmu.crane import Controller, Plant, Setpoints
from segfmu.errors import SimulationError
from segfmu.planning import Trajectory
from segfmu.planning.arrays import FloatArray
from segfmu.validation.disturbances import DISTURBANCES, Case, Disturbance, meet
from segfmu.validation.files.mission import Mission
from segfmu.validation.methods import (
    METHODS,
    MODES,
    NO_FEEDBACK,
    Course,
    Method,
    baseline_course,
    baseline_motions,
    planned_course,
    rope_range,
    tracking_controller,
)

# the load has settled within this distance of its final position [m]
SETTLED = 5e-3


@dataclass(frozen=True)
class Outcome:
    """Result of one method under one disturbance; NaN if the run ended early.

    Attributes
    ----------
    mode, disturbance, method : str
    duration : float
        Of the reference motion [s].
    rms_error, peak_error : float
        Distance of the load from its reference [m].
    rms_horizontal : float
        The same without the height [m].
    residual_sway : float
        Largest angle of the rope from the vertical after the reference motion [deg].
    last_sway : float
        The same within the last pendulum period of the run [deg].
    settling_time : float
        From the start until the load stays within SETTLED of its final position [s]; infinite if
        it does not within the run.
    peak_force_bridge, peak_force_trolley, peak_force_hoist : float
        [N]
    failure : str
        Why the run ended early; empty if it did not.
    """

    mode: str
    disturbance: str
    method: str
    duration: float
    rms_error: float = np.nan
    peak_error: float = np.nan
    rms_horizontal: float = np.nan
    residual_sway: float = np.nan
    last_sway: float = np.nan
    settling_time: float = np.nan
    peak_force_bridge: float = np.nan
    peak_force_trolley: float = np.nan
    peak_force_hoist: float = np.nan
    failure: str = ""


def run_campaign(
    mission: Mission,
    modes: Iterable[str] = MODES,
    disturbances: tuple[Disturbance, ...] = DISTURBANCES,
    methods: tuple[Method, ...] = METHODS,
    jobs: int = 1,
    progress: Callable[[float], None] = lambda _: None,
) -> list[Outcome]:
    """Run every method under every disturbance, in the order of modes, disturbances, methods.

    Parameters
    ----------
    mission : Mission
        Its actuators and feedback settings are not used; its step and settling time are.
    modes : iterable of str
        "velocity", "force".
    disturbances, methods
    jobs : int
        Processes.
    progress : callable
        Called with the share done.
    """
    columns = [(mode, method) for mode in modes for method in methods]
    mission.require_limits()
    work = partial(_column, mission, mission.plan(), disturbances)
    found: dict[tuple[str, str], list[Outcome]] = {}
    with _pool(jobs) as pool:
        for column, outcomes in zip(columns, pool.map(work, columns), strict=True):
            found[column[0], column[1].name] = outcomes
            progress(len(found) / len(columns))
    return [
        found[mode, method.name][row]
        for mode in dict.fromkeys(mode for mode, _ in columns)
        for row in range(len(disturbances))
        for method in methods
    ]


def _pool(jobs: int) -> ProcessPoolExecutor | _Here:
    # spawn: fork may hang because the progress bar has a thread
    return ProcessPoolExecutor(jobs, get_context("spawn")) if jobs > 1 else _Here()


class _Here:
    """Takes the place of a pool if one process is enough."""

    def __enter__(self) -> _Here:
        return self

    def __exit__(self, *error: object) -> None:
        pass

    map = staticmethod(map)


def _column(
    mission: Mission,
    trajectory: Trajectory,
    disturbances: tuple[Disturbance, ...],
    column: tuple[str, Method],
) -> list[Outcome]:
    mode, method = column
    return [run_case(mission, trajectory, mode, row, method) for row in disturbances]


def run_case(
    mission: Mission, trajectory: Trajectory, mode: str, disturbance: Disturbance, method: Method
) -> Outcome:
    """One method under one disturbance."""
    driven, crane = mode == "velocity", mission.build_crane()
    length = -float(mission.waypoints[0].position[2])
    case = meet(disturbance, crane, length, trajectory.duration, driven)
    step, settle = mission.simulation.step, mission.simulation.settle
    if method.planned:
        times = _times(trajectory.duration + settle, step)
        course = planned_course(crane, trajectory, case.compensation, times)
    else:
        motions = baseline_motions(mission, method.shaper, driven)
        times = _times(max(motion.duration for motion in motions) + settle, step)
        course = baseline_course(crane, motions, case.compensation, times)
    controller = _controller(mission, trajectory, driven, disturbance, method)
    found = Outcome(mode, disturbance.name, method.name, course.duration)
    try:
        states, loads, forces = _simulate(case, course, controller, step, driven)
    except SimulationError as error:
        return replace(found, failure=str(error))
    return _measured(found, crane.gravity, course, times, (states, loads, forces))


def _times(duration: float, step: float) -> FloatArray:
    times: FloatArray = step * np.arange(ceil(duration / step) + 1, dtype=np.float64)
    return times


def _controller(
    mission: Mission,
    trajectory: Trajectory,
    driven: bool,
    disturbance: Disturbance,
    method: Method,
) -> Controller:
    if not method.feedback:
        return NO_FEEDBACK
    crane = mission.build_crane()
    return tracking_controller(
        crane, method.feedback, driven, rope_range(crane, trajectory), disturbance.dead_time
    )


def _simulate(
    case: Case, course: Course, controller: Controller, step: float, driven: bool
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """States (times, 10), loads (times, 3) and forces (times, 3)."""
    setpoints = [
        Setpoints(force, velocity, reference)
        for force, velocity, reference in zip(
            course.force, course.velocity, course.reference, strict=True
        )
    ]
    start = course.reference[0] + case.deviation
    plant = Plant(case.crane, start, setpoints[0], controller, driven=driven, rig=case.rig)
    found = [(plant.state, plant.load[0], plant.drive_force.copy())]
    for aim in setpoints[1:]:
        plant.step(step, aim)
        found.append((plant.state, plant.load[0], plant.drive_force.copy()))
    states, loads, forces = (np.array(column) for column in zip(*found, strict=True))
    return states, loads, forces


def _measured(
    found: Outcome,
    gravity: float,
    course: Course,
    times: FloatArray,
    run: tuple[FloatArray, FloatArray, FloatArray],
) -> Outcome:
    states, loads, forces = run
    error = loads - course.load
    distance = np.linalg.norm(error, axis=1)
    sway = np.degrees(np.arccos(np.cos(states[:, 3]) * np.cos(states[:, 4])))
    after = times >= course.duration - 1e-9
    period = 2.0 * np.pi * np.sqrt(states[-1, 2] / gravity)
    away = np.flatnonzero(np.linalg.norm(loads - course.load[-1], axis=1) > SETTLED)
    settled = times[away[-1] + 1] if away.size and away[-1] + 1 < times.size else np.inf
    peaks = np.abs(forces[1:]).max(axis=0)
    return replace(
        found,
        rms_error=float(np.sqrt(np.mean(distance**2))),
        peak_error=float(distance.max()),
        rms_horizontal=float(np.sqrt(np.mean((error[:, :2] ** 2).sum(axis=1)))),
        residual_sway=float(sway[after].max()),
        last_sway=float(sway[after & (times >= times[-1] - period)].max()),
        settling_time=float(settled),
        peak_force_bridge=float(peaks[0]),
        peak_force_trolley=float(peaks[1]),
        peak_force_hoist=float(peaks[2]),
    )
