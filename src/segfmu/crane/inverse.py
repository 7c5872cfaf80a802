"""Feedforward by the flat inverse (7): a load trajectory -> forces, velocities, states."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, finite_times
from segfmu.crane.contacts import NONE, Contacts
from segfmu.crane.equipment import Friction
from segfmu.crane.flat_model import GANTRY
from segfmu.crane.flat_models import model_of, require_flat, require_force
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.rope import LoadTrajectory
from segfmu.errors import InputError
from segfmu.kernels.crane.records import FlatInverse as Results
from segfmu.kernels.crane.records import State

# columns of `FlatInverse.evaluate` for a gantry crane; ANGLE: both sway angles
FORCE, STATE = GANTRY.columns.force, GANTRY.columns.state
POSITION, VELOCITY = GANTRY.columns.position, GANTRY.columns.velocity
ACCELERATION = GANTRY.columns.acceleration
DRIVE_ACCELERATION = GANTRY.columns.drive_acceleration
ORDERS = GANTRY.orders
ANGLE = slice(Results.STATE + State.ANGLE, Results.STATE + State.VELOCITY)


class FlatInverse:
    """Setpoints that make the load of a crane follow a trajectory of x, y and z exactly.

    Parameters
    ----------
    crane : Crane or HookCrane
    trajectory : Trajectory
        Three axes, four times continuously differentiable (errata E7: z as well); with a hook five
        times for velocities, and six times for forces.
    friction : Friction, optional
        Of the axes, which is added to the forces; none by default. The damping of the sway is not
        inverted.

    Raises
    ------
    InputError
        For a trajectory without exactly three axes or less smooth, and for anything but a Friction.
    InfeasibleError
        If load or hook reach the trolley's height, or rope or sling go slack, or the rope leaves
        its range; the error gives the time.
    """

    def __init__(
        self, crane: AnyCrane, trajectory: LoadTrajectory, friction: Friction = NONE
    ) -> None:
        if isinstance(trajectory, type) or not isinstance(trajectory, LoadTrajectory):
            raise InputError(f"trajectory must be a plan, got {type(trajectory).__name__}")
        require_flat(crane, trajectory.axes, trajectory.smoothness)
        self.model = model_of(crane)
        self.crane = crane
        self.trajectory = trajectory
        self.contacts = Contacts(crane, friction, trajectory)
        self.model.require_taut(crane, trajectory)

    def __repr__(self) -> str:
        return f"FlatInverse({self.crane!r}, {self.trajectory!r})"

    def force(self, t: ArrayLike) -> FloatArray:
        """Drive forces F_x, F_y, F_l [N] at times t, shape (..., 3).

        Raises
        ------
        InputError
            For a hook and a trajectory with a smoothness below 6, whose forces jump.
        """
        require_force(self.crane, self.trajectory.smoothness)
        return self.evaluate(t)[..., self.model.columns.force]

    def velocity(self, t: ArrayLike) -> FloatArray:
        """Velocities of bridge, trolley and rope [m/s] at times t, shape (..., 3)."""
        return self.evaluate(t)[..., self.model.columns.velocity]

    def state(self, t: ArrayLike) -> FloatArray:
        """State x_t, y_t, l, phi_x, phi_y and rates at times t, shape (..., 10).

        With a hook (..., 14): behind both angles of the rope come those of the sling.
        """
        return self.evaluate(t)[..., self.model.columns.state]

    def acceleration(self, t: ArrayLike) -> FloatArray:
        """Second derivatives of x_t, y_t, l and the angles at times t, shape (..., 5 or 7)."""
        return self.evaluate(t)[..., self.model.columns.acceleration]

    def evaluate(self, t: ArrayLike) -> FloatArray:
        """Forces, state and accelerations side by side, shape (..., 18), with a hook (..., 24)."""
        times = finite_times(t)
        orders, columns = self.model.orders, self.model.columns
        flat = np.stack([self.trajectory(times, d) for d in range(orders)], axis=-2)
        results = np.empty((*flat.shape[:-2], self.model.results.SIZE))
        for time, row, values in zip(
            times.ravel().tolist(), results.reshape(-1, self.model.results.SIZE),
            flat.reshape(-1, orders, 3), strict=True,
        ):
            self.model.invert(self.crane, values, row)
            if self.contacts.acts:
                for axis, (x, v) in enumerate(
                    zip(row[columns.position], row[columns.velocity], strict=True)
                ):
                    row[axis] += self.contacts.friction(axis, time, x, v)
        return results
