"""A mission's plan, checked before anything is built or run."""

from __future__ import annotations

import numpy as np

from segfmu.cosim import require_steps
from segfmu.crane import FlatInverse
from segfmu.crane.bounds import DRIVES
from segfmu.errors import InputError
from segfmu.kernels.crane.records import Contact
from segfmu.planning import Trajectory
from segfmu.validation.files.crane_parameters import feedback_source
from segfmu.validation.files.mission import Mission
from segfmu.validation.progress import Progress, quiet

# samples of the time in which friction falls
AROUND = 201
# exponent of the growth of a deviation that force setpoints are exact enough for
GROWN = 8.0


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


def sticking(task: Mission, trajectory: Trajectory) -> str:
    """The force drive that may stick as it moves off, by static friction that falls; else empty.

    Where the velocity passes that of the fall, a deviation grows by the slope of the friction over
    the mass. An axis that is late there needs more than its force.
    """
    friction = task.build_friction()
    if (task.simulation.drive or task.simulated.drive) == "velocity" or not any(friction.static):
        return ""
    inverse = FlatInverse(task.build_crane(), trajectory, friction)
    crane = task.crane
    hanging = crane.payload_mass + task.build_crane().tackle[0]
    moved = (crane.bridge_mass + crane.trolley_mass, crane.trolley_mass, hanging)
    found = []
    for axis, rows in enumerate(inverse.contacts.rows):
        excess = max(friction.static[axis] - friction.coulomb[axis], 0.0)
        moving = (rows[:, Contact.TIME] < trajectory.duration) & (rows[:, Contact.RELEASED] == 0.0)
        for row in rows[moving]:
            times = np.linspace(row[Contact.TIME], row[Contact.SETTLED], AROUND)
            share = inverse.velocity(times)[:, axis] / friction.width
            slope = 2.0 * np.abs(share) * np.exp(-(share**2)) * excess / friction.width
            growth = float(np.trapezoid(slope, times)) / moved[axis]
            found.append((growth, axis, float(row[Contact.TIME])))
    growth, axis, time = max(found)
    if growth <= GROWN:
        return ""
    return (
        f"the {DRIVES[axis]} may stick where it moves off at {time:.3f} s: it does so slowly, and "
        f"a deviation grows by the factor e^{growth:.0f} while its friction falls from static to "
        "Coulomb friction; use feedback, a higher jerk and snap in [limits], or a larger "
        "friction.width"
    )


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
