"""Methods of scenarios: which there are for a crane, and their courses."""

from __future__ import annotations

from collections.abc import Mapping
from math import sqrt
from typing import Any

import numpy as np

from segfmu.crane import Crane
from segfmu.crane.linear import moved_masses
from segfmu.errors import InputError
from segfmu.validation.baselines.course import Course
from segfmu.validation.baselines.one_load import one_load
from segfmu.validation.baselines.trapezoids import trapezoids
from segfmu.validation.files.crane_models import FURTHER, require_gantry
from segfmu.validation.files.keys import DRIVES
from segfmu.validation.files.mission import Mission

# of two swings, or of what is ignored between rope and load
OF_TACKLE = ("zv_both", "zvd_both", "one_load")
# critically damped control of the carriages' positions: its frequency over the pendulum's; a
# stiffer one asks for more than drives have
RATIO = 1.0


def course(mission: Mission, method: str) -> Course:
    """The course of a method through a mission's waypoints.

    Raises
    ------
    InputError
        For methods that are not for the crane, and where no limits are known.
    InfeasibleError
        If "one_load" has no plan.
    """
    crane = mission.build_crane()
    if method == "pd":
        require_gantry(crane, "method pd")
    if method in OF_TACKLE and crane.tackle[1] == 0.0:
        keys = " or a ".join(model.key for model in FURTHER)
        raise InputError(
            f'method: {method} is for a crane with a {keys}, which this one has not; '
            '"feedforward", "zv" and "zvd" are for one load on a rope'
        )
    return one_load(mission) if method == "one_load" else trapezoids(mission, method)


def position_gains(mission: Mission, driven: bool, table: Mapping[str, Any]) -> dict[str, Any]:
    """The table of gains of PD control of the carriages' positions: nothing of the sway.

    `table` is that of the crane's linear-quadratic design, whose hoist stays.

    Raises
    ------
    InputError
        For a crane of another model.
    """
    crane: Crane = require_gantry(mission.build_crane(), "method pd")
    masses = moved_masses(crane.masses) if not driven else np.ones(3)
    found = dict(table)
    for name in table:
        row, _, gain = name.rpartition("].")
        drive, _, quantity = gain.partition(".")
        if drive not in DRIVES[:2]:
            continue
        own = RATIO * sqrt(crane.gravity / float(table[f"{row}].length"]))
        mass = float(masses[DRIVES.index(drive)])
        found[name] = mass * {"position": own**2, "velocity": 2.0 * own}.get(quantity, 0.0)
    return found
