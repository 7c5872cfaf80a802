"""What a load trajectory asks of the drives, and its exact peaks.

kernels/crane/peaks.py finds the peaks.
"""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane.bounds import sides
from segfmu.crane.contacts import IDEAL, NONE, Contacts, resistance
from segfmu.crane.equipment import Friction
from segfmu.crane.flat_models import model_of
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.rope import LoadTrajectory
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Axes, Contact, Demand, DemandPeaks, DemandWork
from segfmu.planning.waypoint import Waypoint

# way [m] behind which every contact slides
FAR = 1e30


def demands(
    crane: AnyCrane, trajectory: LoadTrajectory, times: FloatArray,
    friction: Friction = NONE, lag: FloatArray = IDEAL,
) -> FloatArray:
    """Rows of the record `Demand` at times, shape (times, 17); lag: of the velocity loops [s]."""
    contacts = Contacts(crane, friction, trajectory, lag)
    return _at(model_of(crane).orders, contacts, trajectory, times)


def demands_in_state(
    crane: AnyCrane, point: Waypoint, friction: Friction = NONE, lag: FloatArray = IDEAL
) -> FloatArray:
    """Magnitudes of the demands in the state of a waypoint in both directions, shape (2, 17).

    An axis that moves slides; one at rest needs no more than what it carries.
    """
    flat = np.zeros((1, model_of(crane).orders, 3))
    known_orders = point.position, point.velocity, point.acceleration, point.jerk, point.snap
    flat[0, : len(known_orders)] = known_orders
    known, ideal = resistance(crane, friction, lag), resistance(crane, friction)
    rows = np.zeros((Axes.SIZE, 1, Contact.SIZE))
    # a contact slides with the drive's own velocity, which is the setpoint of an ideal drive
    velocity = _of(flat, np.zeros(1), ideal, rows)[0, Demand.VELOCITY : Demand.ACCELERATION]
    # far from where it turned
    rows[:, 0, Contact.POSITION] = np.where(velocity == 0.0, 0.0, -np.sign(velocity) * FAR)
    rows[velocity == 0.0, 0, Contact.RELEASED] = 1.0
    return sides(_of(flat, np.zeros(1), known, rows))


def _at(
    orders: int, contacts: Contacts, trajectory: LoadTrajectory, times: FloatArray
) -> FloatArray:
    flat = np.empty((times.size, orders, 3))
    for order in range(orders):
        flat[:, order] = trajectory(times, order)
    return _of(flat, times, contacts.resistance, contacts.rows)


def _of(
    flat: FloatArray, times: FloatArray, known: FloatArray, rows: FloatArray
) -> FloatArray:
    found = np.empty((flat.shape[0], Demand.SIZE))
    work = np.zeros((DemandWork.SIZE, DemandWork.COLUMNS))
    backend.drive_demands(flat, np.ascontiguousarray(times), known, rows, work, found)
    return found


def peaks(
    crane: AnyCrane, trajectory: LoadTrajectory, friction: Friction = NONE,
    lag: FloatArray = IDEAL,
) -> tuple[FloatArray, FloatArray]:
    """Exact greatest magnitudes of all demands in the positive and in the negative direction.

    Also their times [s]; shapes (2, 17). 0 at time 0 where there is none in a direction; of places
    the greatest and minus the least one.
    """
    contacts = Contacts(crane, friction, trajectory, lag)
    found, moments = np.zeros((2, Demand.SIZE)), np.zeros((2, Demand.SIZE))
    backend.demand_peaks(
        *contacts.pieces, contacts.resistance, contacts.rows,
        np.zeros((DemandPeaks.SIZE, DemandPeaks.COLUMNS)), found, moments,
    )
    return found, moments
