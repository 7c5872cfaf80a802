"""Where friction leads force drives off a plan: they may stick, run ahead, stop early, spring back.

While the velocity passes that over which friction falls, a deviation grows by the slope of the
friction over the mass, towards both sides. Stops of a plan have Coulomb friction alone, so that
nothing runs ahead there: static friction makes them early.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.crane import FlatInverse
from segfmu.crane.bounds import DRIVES
from segfmu.crane.demand import demands
from segfmu.kernels.crane.records import Contact, Demand
from segfmu.planning import Trajectory
from segfmu.validation.files.mission import Mission

# samples between two times at which the motion or the friction changes its law, closest at these
BETWEEN = 48
# velocity, over that over which friction falls, beyond which it has fallen
FALLEN = 3.0
# exponent of the growth of a deviation that force setpoints are exact enough for
GROWN = 8.0
# of the tolerance of the load's way, by which a stop may be early, or an axis spring back
EARLY = 0.5


def sticking(task: Mission, trajectory: Trajectory) -> str:
    """The force drive that dry friction leads off its plan most; else empty."""
    friction, tolerance = task.build_friction(), EARLY * task.simulation.tracking_tolerance
    rubs = any(friction.coulomb) or any(friction.static)
    if (task.simulation.drive or task.simulated.drive) == "velocity" or not rubs:
        return ""
    if friction.presliding > tolerance:
        return (
            "where an axis with dry friction rests it springs back by friction.presliding, "
            f"{1e3 * friction.presliding:.3g} mm; use feedback, or raise "
            "simulation.tracking_tolerance"
        )
    crane, masses = task.build_crane(), task.crane
    contacts = FlatInverse(crane, trajectory, friction).contacts
    nodes = np.unique([*contacts.times, *trajectory.events, 0.0, trajectory.duration])
    nodes = nodes[nodes <= trajectory.duration]
    times = _between(nodes)
    velocities = demands(crane, trajectory, times)[:, Demand.VELOCITY : Demand.ACCELERATION]
    hanging = masses.payload_mass + crane.tackle[0]
    moved = (masses.bridge_mass + masses.trolley_mass, masses.trolley_mass, hanging)
    grown, early = (0.0, ""), (0.0, "")
    for axis, rows in enumerate(contacts.rows):
        excess = max(friction.static[axis] - friction.coulomb[axis], 0.0) / moved[axis]
        speed = np.abs(velocities[:, axis])
        rests, stops = _rests(rows, times)
        share = speed / friction.width
        slope = 2.0 * share * np.exp(-(share**2)) * excess / friction.width * ~stops
        for part in _runs((share < FALLEN) & ~rests):
            growth = float(np.trapezoid(slope[part], times[part]))
            slowest = float(times[part][np.argmin(speed[part])])
            off = part.start == 0 or rests[part.start - 1]
            where = "moves off" if off else "turns or passes through rest"
            grown = max(grown, (growth, f"the {DRIVES[axis]} may stick where it {where} at "
                                        f"{slowest:.3f} s"))
        for part in _runs(stops):
            way = _early(times[part], speed[part], excess, friction.width)
            early = max(early, (way, f"the {DRIVES[axis]} may stop {1e3 * way:.3g} mm early at "
                                     f"{times[part][-1]:.3f} s"))
    if grown[0] > GROWN:
        return (
            f"{grown[1]}: it does so slowly, and a deviation grows by the factor e^{grown[0]:.0f} "
            "while its friction falls from static to Coulomb friction; use feedback, a higher jerk "
            "and snap in [limits], or a larger friction.width"
        )
    if early[0] > tolerance:
        return (
            f"{early[1]}: it does so slowly, and its friction rises from Coulomb to static "
            "friction before it rests; use feedback, a higher jerk and snap in [limits], or a "
            "smaller friction.width"
        )
    return ""


def _between(nodes: FloatArray) -> FloatArray:
    """Times from node to node, ascending, closest at the nodes."""
    shares = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, BETWEEN))
    times: FloatArray = np.unique(nodes[:-1, None] + np.diff(nodes)[:, None] * shares)
    return times


def _rests(rows: FloatArray, times: FloatArray) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Whether an axis rests at times, and whether it stops there."""
    rests, stops = np.zeros(times.size, dtype=bool), np.zeros(times.size, dtype=bool)
    ends = [*rows[1:, Contact.TIME], np.inf]
    for row, end in zip(rows, ends, strict=True):
        if row[Contact.RELEASED] > 0.0:
            rests |= (times > row[Contact.TIME]) & (times < end)
            stops |= (times >= row[Contact.BEGUN]) & (times <= row[Contact.TIME])
    return rests, stops


def _runs(chosen: NDArray[np.bool_]) -> list[slice]:
    """Parts of the samples that are chosen without one between."""
    edges = np.flatnonzero(np.diff(chosen, prepend=False, append=False))
    return [slice(first, last) for first, last in edges.reshape(-1, 2).tolist()]


def _early(times: FloatArray, speed: FloatArray, excess: float, width: float) -> float:
    """Way [m] that an axis lacks at the end of a stop whose force has Coulomb friction alone."""
    lost = way = 0.0
    for step, planned in zip(np.diff(times).tolist(), speed.tolist(), strict=False):
        left = max(planned - lost, 0.0)
        lost += step * excess * float(np.exp(-((left / width) ** 2)))
        way += step * min(lost, planned)
    return way
