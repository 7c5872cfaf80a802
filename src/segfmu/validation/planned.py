"""A mission's plan, checked before anything is built or run."""

from __future__ import annotations

from segfmu.cosim import require_steps
from segfmu.crane import FlatInverse
from segfmu.errors import InputError
from segfmu.planning import Trajectory
from segfmu.validation.files.crane_parameters import feedback_source
from segfmu.validation.files.mission import Mission
from segfmu.validation.progress import Progress, quiet


def planned(task: Mission, progress: Progress = quiet) -> Trajectory:
    """Plan, and check by the flat inverse that the crane can follow.

    Raises
    ------
    InfeasibleError
        If the mission cannot be planned, the rope goes slack, or an end stop is in the way.
    """
    trajectory = task.plan(lambda share: progress("planning", share))
    FlatInverse(task.build_crane(), trajectory)
    return trajectory


def unknown_wind(task: Mission) -> str:
    """What is said of a feedback from the state against a lasting wind; else empty.

    Its gains hold the load's place by the carriage's, which the wind's swing is no part of.
    """
    crane, settings = task.simulated, task.simulation
    acts = crane.controller.enabled if settings.feedback is None else settings.feedback
    source = settings.feedback_source or feedback_source(crane)
    wind = [*(crane.wind.constant or ()), *(crane.wind.speed or ())]
    if not acts or source != "state" or not any(wind):
        return ""
    return (
        "the feedback does not know the wind, from the state alone, and can enlarge its lasting "
        'error; source = "measured" in the crane file\'s [controller] estimates the wind'
    )


def require_memory(task: Mission, arrival: float) -> None:
    """Refuse missions whose results would not fit in memory, or that end when they begin.

    arrival: of the load [s].

    Raises
    ------
    InputError
        If a run would have too many steps, or none.
    """
    settings = task.simulation
    if not arrival + settings.settle > 0.0:
        raise InputError(
            f"simulation.settle: a plan of 0 s needs a time > 0 s behind it, got {settings.settle}"
        )
    try:
        require_steps(arrival + settings.settle, settings.step)
    except InputError as error:
        raise InputError(f"simulation.step: {error} (settle, dwell, limits)") from None
