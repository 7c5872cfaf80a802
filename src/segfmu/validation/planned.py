"""A mission's plan, checked before anything is built or run."""

from __future__ import annotations

from segfmu.cosim import require_steps
from segfmu.crane import FlatInverse
from segfmu.errors import InputError
from segfmu.planning import Trajectory
from segfmu.validation.files.mission import Mission
from segfmu.validation.progress import Progress, quiet


def planned(task: Mission, progress: Progress = quiet) -> Trajectory:
    """Plan, and check by the flat inverse that the crane can follow.

    Raises
    ------
    InfeasibleError
        If the mission cannot be planned, or the rope goes slack.
    """
    trajectory = task.plan(lambda share: progress("planning", share))
    FlatInverse(task.build_crane(), trajectory)
    return trajectory


def require_memory(task: Mission, trajectory: Trajectory) -> None:
    """Refuse missions whose results would not fit in memory.

    Raises
    ------
    InputError
        If a run would have too many steps.
    """
    settings = task.simulation
    try:
        require_steps(trajectory.duration + settings.settle, settings.step)
    except InputError as error:
        raise InputError(f"simulation.step: {error} (settle, dwell, limits)") from None
