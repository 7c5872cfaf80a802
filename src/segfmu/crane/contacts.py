"""Friction that a crane is known to have, along a plan.

The friction of the plant depends on what was before: a contact is deflected before it slides. The
history of a plan's contacts, kernels/crane/contact.py, gives the friction at any time of it.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.crane.equipment import FRICTION, Friction
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.rope import LoadTrajectory, joined_pieces
from segfmu.crane.variables import filled, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import DRIVES, Axes, Contact, ContactWork, Resistance

NONE = Friction()
IDEAL = np.zeros(len(DRIVES))
# rows for a first try, and at most: a plan with more turning points is none
ROWS, MOST_ROWS = 64, 65536


def resistance(crane: AnyCrane, friction: Friction, lag: FloatArray = IDEAL) -> FloatArray:
    """The kernels' `Resistance`; lag: of the velocity loops [s], shape (3,).

    Raises
    ------
    InputError
        For anything but a Friction.
    """
    if not isinstance(friction, Friction):
        raise InputError(f"friction must be a segfmu.crane.Friction, got {type(friction).__name__}")
    lags = dict(zip(Resistance.FIELDS["LAG"].variables, lag, strict=True))
    known = crane.values() | values(friction, FRICTION) | lags
    found = filled(Resistance, known.__getitem__)
    found[Resistance.SUSPENSION : Resistance.SLING + 1] = crane.suspension, *crane.tackle
    return found


class Contacts:
    """Friction of bridge, trolley and hoist along a plan.

    Parameters
    ----------
    crane : Crane or HookCrane
    friction : Friction
    trajectory : LoadTrajectory
    lag : ndarray, shape (3,)
        Of the velocity loops [s].

    Raises
    ------
    InputError
        For anything but a Friction.
    """

    def __init__(
        self, crane: AnyCrane, friction: Friction, trajectory: LoadTrajectory,
        lag: FloatArray = IDEAL,
    ) -> None:
        self.resistance = resistance(crane, friction, lag)
        self._trajectory = trajectory
        self._rubs = any(friction.coulomb) or any(friction.static)
        self.acts = self._rubs or any(friction.viscous) or any(friction.drag)

    @cached_property
    def pieces(self) -> tuple[FloatArray, FloatArray, NDArray[np.int64], FloatArray]:
        """The trajectory as the kernels take it: timing, coefficients, offsets and ends."""
        timing, coefficients, offsets = joined_pieces(self._trajectory)
        ends = timing[offsets[1:] - 1].sum(axis=1)
        # the last pieces of axes that end together do so up to rounding
        last = self._trajectory.duration
        ends[np.abs(ends - last) <= 1e-12 * last] = last
        return timing, coefficients, offsets, ends

    @cached_property
    def rows(self) -> FloatArray:
        """A `Contact` per row for each axis, shape (3, rows, 7)."""
        if not self._rubs:
            return np.zeros((Axes.SIZE, 1, Contact.SIZE))
        pieces = self.pieces
        work = np.zeros((ContactWork.SIZE, ContactWork.COLUMNS))
        room = ROWS
        while room <= MOST_ROWS:
            rows = np.zeros((Axes.SIZE, room, Contact.SIZE))
            counts = [
                backend.contact_history(
                    axis, *pieces, self.resistance, work, rows[axis]
                )
                for axis in range(Axes.SIZE)
            ]
            if all(counts):
                return rows[:, : max(counts)].copy()
            room *= 8
        raise AssertionError("a plan with endless turning points")

    @property
    def times(self) -> FloatArray:
        """Times [s] at which friction changes its law, ascending, shape (times,)."""
        if not self._rubs:
            return np.zeros(0)
        places = [Contact.TIME, Contact.BEGUN, Contact.SLIDES, Contact.SETTLED]
        known = self.rows[self.rows[..., Contact.TIME] < 1e300]
        return np.unique(known[:, places])

    def friction(self, axis: int, time: float, position: float, velocity: float) -> float:
        """Friction [N] of an axis at a time [s] of the plan, where it has a position and velocity.

        0 before the plan.
        """
        return float(
            backend.planned_friction(
                self.resistance, axis, time, position, velocity, self.rows[axis]
            )
        )

    def next_event(self, time: float, axis: int) -> float:
        """First time after another one [s] at which a step should end for the friction of an axis.

        Infinite after the last one.
        """
        if not self._rubs:
            return np.inf
        found = float(backend.next_contact_event(time, 0.0, self.rows[axis]))
        return found if found < 1e300 else np.inf
