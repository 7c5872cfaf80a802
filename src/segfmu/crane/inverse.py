"""Feedforward by the flat inverse (7): a load trajectory -> forces, velocities, states."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.contacts import NONE, Contacts
from segfmu.crane.equipment import Friction
from segfmu.crane.parameters import Crane
from segfmu.crane.rope import LoadTrajectory, require_rope
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import FlatInverse as Results
from segfmu.kernels.crane.records import State
from segfmu.planning.arrays import FloatArray

ORDERS = 5

# columns of `FlatInverse.evaluate`; ANGLE: both sway angles
FORCE = slice(Results.FORCE, Results.STATE)
STATE = slice(Results.STATE, Results.ACCELERATION)
POSITION = slice(Results.STATE, Results.STATE + State.ANGLE)
ANGLE = slice(Results.STATE + State.ANGLE, Results.STATE + State.VELOCITY)
VELOCITY = slice(Results.STATE + State.VELOCITY, Results.STATE + State.RATE)
ACCELERATION = slice(Results.ACCELERATION, Results.SIZE)
DRIVE_ACCELERATION = slice(Results.ACCELERATION, Results.ACCELERATION + State.ANGLE)


class FlatInverse:
    """Setpoints that make the load of a crane follow a trajectory of x, y and z exactly.

    Parameters
    ----------
    crane : Crane
    trajectory : Trajectory
        Three axes, four times continuously differentiable (errata E7: z as well).
    friction : Friction, optional
        Of the axes, which is added to the forces; none by default. The damping of the sway is not
        inverted.

    Raises
    ------
    InputError
        For a trajectory without exactly three axes, and for anything but a Friction.
    InfeasibleError
        If the load reaches the trolley's height, or the rope goes slack or leaves its range; the
        error gives the time.
    """

    def __init__(
        self, crane: Crane, trajectory: LoadTrajectory, friction: Friction = NONE
    ) -> None:
        if isinstance(trajectory, type) or not hasattr(trajectory, "axes"):
            raise InputError(f"trajectory must be a plan, got {type(trajectory).__name__}")
        require_flat(crane, trajectory.axes, trajectory.smoothness)
        self.crane = crane
        self.trajectory = trajectory
        self.contacts = Contacts(crane, friction, trajectory)
        require_rope(crane, trajectory)

    def __repr__(self) -> str:
        return f"FlatInverse({self.crane!r}, {self.trajectory!r})"

    def force(self, t: ArrayLike) -> FloatArray:
        """Drive forces F_x, F_y, F_l [N] at times t, shape (..., 3)."""
        return self.evaluate(t)[..., FORCE]

    def velocity(self, t: ArrayLike) -> FloatArray:
        """Velocities of bridge, trolley and rope [m/s] at times t, shape (..., 3)."""
        return self.evaluate(t)[..., VELOCITY]

    def state(self, t: ArrayLike) -> FloatArray:
        """State x_t, y_t, l, phi_x, phi_y and rates at times t, shape (..., 10)."""
        return self.evaluate(t)[..., STATE]

    def acceleration(self, t: ArrayLike) -> FloatArray:
        """Second derivatives of x_t, y_t, l, phi_x, phi_y at times t, shape (..., 5)."""
        return self.evaluate(t)[..., ACCELERATION]

    def evaluate(self, t: ArrayLike) -> FloatArray:
        """Forces (3), state (10) and accelerations (5) side by side, shape (..., 18)."""
        times = np.asarray(t, dtype=np.float64)
        flat = np.stack([self.trajectory(times, d) for d in range(ORDERS)], axis=-2)
        results = np.empty((*flat.shape[:-2], Results.SIZE))
        masses = np.array(self.crane.masses)
        for time, row, values in zip(
            times.ravel().tolist(), results.reshape(-1, Results.SIZE),
            flat.reshape(-1, ORDERS, 3), strict=True,
        ):
            backend.crane_flat_inverse(values, masses, row[FORCE], row[STATE], row[ACCELERATION])
            if self.contacts.acts:
                for axis, (x, v) in enumerate(zip(row[POSITION], row[VELOCITY], strict=True)):
                    row[axis] += self.contacts.friction(axis, time, x, v)
        return results


def require_flat(crane: Crane, axes: int, smoothness: int) -> None:
    """Raise InputError unless a trajectory of so many axes, so smooth, has a flat inverse."""
    if not isinstance(crane, Crane):
        raise InputError(f"crane must be a segfmu.Crane, got {type(crane).__name__}")
    if axes != 3:
        raise InputError(f"the flat inverse needs axes x, y, z; got {axes} axes")
    if smoothness < 4:
        raise InputError(
            f"the flat inverse needs smoothness 4 or more, got {smoothness}; with less, the "
            "carriage's acceleration jumps"
        )
