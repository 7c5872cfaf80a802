"""A mission's plan, checked before anything is built or run."""

from __future__ import annotations

import numpy as np

from segfmu.cosim import require_steps
from segfmu.crane import FlatInverse
from segfmu.crane.bounds import DRIVES
from segfmu.crane.inverse import DRIVE_ACCELERATION, VELOCITY
from segfmu.errors import InputError
from segfmu.planning import Trajectory
from segfmu.validation.files.mission import Mission
from segfmu.validation.progress import Progress, quiet

# samples of a plan in which setpoints beyond the drives are sought
SAMPLES = 4001
# share of the tracking tolerance from which on it is said that a drive falls behind
TOLD = 0.1


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


def beyond_drives(task: Mission, trajectory: Trajectory) -> str:
    """The drive that falls behind most as its setpoints exceed its greatest velocity; else empty.

    Velocity drives with lag are told v + lag v'. So a plan within their bounds may ask for more.
    By the excess times the lag, about, the load misses its place.
    """
    if (task.simulation.drive or task.simulated.drive) != "velocity":
        return ""
    times = np.union1d(np.linspace(0.0, trajectory.duration, SAMPLES), trajectory.events)
    values = FlatInverse(task.build_crane(), trajectory).evaluate(times)
    tables = [getattr(task.crane, drive) for drive in DRIVES]
    lags = np.array([table.lag or 0.0 for table in tables])
    bounds = np.array([table.velocity_max or 1e99 for table in tables])
    needs = np.abs(values[:, VELOCITY] + lags * values[:, DRIVE_ACCELERATION])
    missed = lags * (needs - bounds)
    row, worst = np.unravel_index(missed.argmax(), missed.shape)
    if missed[row, worst] <= TOLD * task.simulation.tracking_tolerance:
        return ""
    return (
        f"the {DRIVES[worst]} falls behind the plan: its setpoint, velocity + lag * acceleration, "
        f"reaches {needs[row, worst]:.4g} m/s at {times[row]:.3f} s, and its velocity_max is "
        f"{bounds[worst]:.4g} m/s; a lower acceleration in [limits] or [actuators] avoids this"
    )


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
