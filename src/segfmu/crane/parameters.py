"""The parameters of the crane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, as_flag, finite_vector, sized
from segfmu.crane.checks import require_positive, require_quantity
from segfmu.crane.variables import Value, build, fed, of_values, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import DriveMode, Masses, Plant, RopeBounds
from segfmu.kernels.crane.rope import least_depth
from segfmu.kernels.messages import SETUP
from segfmu.kernels.rig.records import SetupFault, SetupStatus


@dataclass(frozen=True)
class Crane:
    """Masses, gravity and rope range of a 3-DOF gantry crane (Fig. 5).

    The bridge moves in x and carries the trolley, which moves in y (errata E6). The mass moved in
    x is bridge_mass + trolley_mass, in y it is trolley_mass.

    Parameters
    ----------
    bridge_mass, trolley_mass, payload_mass : float
        Masses [kg], positive.
    gravity : float
        [m/s2], positive.
    rope_min, rope_max : float, optional
        Range of the rope length [m]; None for no bound.

    Raises
    ------
    InputError
        For masses and a gravity that are not from 1e-9 to 1e9, and an empty rope range.
    """

    bridge_mass: float
    trolley_mass: float
    payload_mass: float
    gravity: float = 9.81
    rope_min: float | None = None
    rope_max: float | None = None

    def __post_init__(self) -> None:
        for name in ("bridge_mass", "trolley_mass", "payload_mass", "gravity"):
            require_quantity(name, getattr(self, name))
            object.__setattr__(self, name, float(getattr(self, name)))
        for name in ("rope_min", "rope_max"):
            if getattr(self, name) is not None:
                require_positive(name, getattr(self, name))
                object.__setattr__(self, name, float(getattr(self, name)))
        fault = np.zeros(SetupFault.SIZE)
        # the start is the plant's
        status = backend.check_rope_bounds(1.0, self.rope_min or 0.0, self.rope_max or 0.0, fault)
        if status != SetupStatus.FITS:
            raise InputError(SETUP.text(status, fault.tolist()))

    @property
    def masses(self) -> tuple[float, float, float, float]:
        """Bridge, trolley and payload mass [kg] and gravity [m/s2], as the kernels take them."""
        return self.bridge_mass, self.trolley_mass, self.payload_mass, self.gravity

    @property
    def weight(self) -> float:
        """Of what hangs on the rope [N]."""
        return self.payload_mass * self.gravity

    @property
    def crane(self) -> Crane:
        """Carriages, load and rope range, as every model has them: this crane."""
        return self

    @property
    def suspension(self) -> int:
        """The kernels' code of what is between rope and load: nothing."""
        return 0

    @property
    def tackle(self) -> tuple[float, float]:
        """Mass [kg] and length [m] of what is between rope and load: nothing."""
        return 0.0, 0.0

    def plant(self, driven: bool, lag: ArrayLike = 0.0) -> FloatArray:
        """The kernels' `Plant` with ideal drives but for lags [s], scalar or (3,).

        Raises
        ------
        InputError
            For a `driven` that is no bool, and lags that are not one or three times >= 0.
        """
        driven = as_flag("driven", driven)
        lags = finite_vector("lag", lag)
        if lags.size not in (1, 3) or (lags < 0.0).any():
            raise InputError(f"lag must be one or three times >= 0 s, got {lags.tolist()}")
        packed = np.zeros(Plant.SIZE)
        packed[Plant.BRIDGE_MASS : Plant.VISCOUS] = self.masses
        packed[Plant.MODE] = DriveMode.VELOCITY if driven else DriveMode.FORCE
        packed[Plant.LAG : Plant.LAG + 3] = lags
        return packed

    def values(self) -> dict[str, float]:
        """As FMU variables; a rope bound of 0 means none."""
        return values(self, CRANE)

    @classmethod
    @of_values
    def of(cls, value: Value) -> Crane:
        """The crane that variables of an FMU describe; `value` gives them by name."""
        return build(cls, CRANE, value)

    def rhs(
        self, state: ArrayLike, force: ArrayLike, load_force: ArrayLike = (0.0, 0.0, 0.0)
    ) -> FloatArray:
        """Time derivative of the state, equation (1).

        Parameters
        ----------
        state : array_like, shape (10,)
            x_t, y_t, l, phi_x, phi_y and their rates [m, rad, m/s, rad/s].
        force : array_like, shape (3,)
            F_x on the bridge, F_y on the trolley, F_l along the rope (tension < 0) [N].
        load_force : array_like, shape (3,)
            Force on the load [N].

        Returns
        -------
        ndarray, shape (10,)

        Raises
        ------
        InputError
            For other numbers of values, and for a rope without length.
        """
        start = sized("state", state, 10)
        if start[2] <= 0.0:
            raise InputError(f"state: rope length must be > 0 m, got {start[2]} m")
        generalized = np.zeros(5)
        generalized[:3] = sized("force", force, 3)
        derivative = np.zeros(10)
        backend.crane_rhs(
            start, generalized, sized("load_force", load_force, 3),
            np.array(self.masses), derivative,
        )
        return derivative

    def load(self, state: ArrayLike) -> FloatArray:
        """Position and velocity of the load, (16); shape (2, 3) [m, m/s]."""
        load = np.zeros((2, 3))
        backend.crane_load(sized("state", state, 10), load)
        return load

    def hanging(self, position: ArrayLike) -> FloatArray:
        """State of the load hanging at rest at a position (3,), the trolley above it; (10,)."""
        x, y, z = sized("position", position, 3)
        if z > -least_depth():
            raise InputError(f"position z {z} m must be below the trolley, z <= {-least_depth():g}")
        return np.array([x, y, -z, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])


# variables of the fields
CRANE = {
    "bridge_mass": fed(Masses, "BRIDGE_MASS"), "trolley_mass": fed(Masses, "TROLLEY_MASS"),
    "payload_mass": fed(Masses, "PAYLOAD_MASS"), "gravity": fed(Masses, "GRAVITY"),
    "rope_min": fed(RopeBounds, "SHORTEST", none=(0.0,)),
    "rope_max": fed(RopeBounds, "LONGEST", none=(0.0,)),
}
