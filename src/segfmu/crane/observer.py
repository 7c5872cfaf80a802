"""Observer: velocities, rates and unknown disturbances from measured positions and angles.

A steady-state Kalman filter for each axis of the crane linearised about rest, in deviations from
the reference, scheduled by rope length. Besides the states of the axis it has two random walks: an
acceleration of the carriage or rope (friction, wrong masses), and one of the load (wind). With as
many disturbances as measured signals the control is free of offset (U. Maeder, F. Borrelli,
M. Morari, Linear offset-free model predictive control, Automatica 45 (2009)).

kernels/control/kalman.py designs it, also in native FMUs; kernels/control/observer.py updates it at
run time.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from segfmu.crane.checks import require_not_negative, require_positive, sized
from segfmu.crane.linear import ROWS, scheduled_lengths
from segfmu.crane.parameters import Crane
from segfmu.crane.variables import fed, filled, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.control.records import AxisModel, Expected, Kalman
from segfmu.kernels.control.records import Observer as Table
from segfmu.kernels.control.records import Uncertainty as Expectations
from segfmu.kernels.messages import SETUP
from segfmu.kernels.rig.records import SetupFault, SetupStatus
from segfmu.planning.arrays import FloatArray

# shape of the design's work space
WORK_COLUMNS = 2 * AxisModel.SIZE


@dataclass(frozen=True)
class Uncertainty:
    """Assumed uncertainty of sensors and disturbances.

    Parameters
    ----------
    position, length, angle : float
        Quantisation steps of the carriages' positions [m], the rope's length [m] and the sway
        angles [rad]; errors are assumed uniformly distributed, with variance step^2 / 12.
    drift, wind : float
        Random walks of the disturbances of carriages and rope, and of the load: standard deviation
        after one second, as a multiple of gravity. Larger values make the observer faster and
        noisier.
    wake : float
        The controller starts to act when a signal first deviates from its reference by more than
        this many quantisation steps; smaller deviations may be rounding. 0: from the start.
    offset : float
        Standard deviation of the rope sensor's zero, as a share of the rope's length; it limits how
        far the controller corrects the measured length. 0: no correction.

    Raises
    ------
    InputError
        For values that are not positive; `wake` and `offset` may be 0.
    """

    position: float = 1e-4
    length: float = 1e-4
    angle: float = 2.0 * pi / 4096.0
    drift: float = 0.3
    wind: float = 0.1
    wake: float = 1.0
    offset: float = 0.05

    def __post_init__(self) -> None:
        for name in ("position", "length", "angle", "drift", "wind"):
            require_positive(f"uncertainty {name}", getattr(self, name))
        for name in ("wake", "offset"):
            require_not_negative(f"uncertainty {name}", getattr(self, name))

    @property
    def vector(self) -> FloatArray:
        """The kernels' `Uncertainty`, shape (7,)."""
        return filled(Expectations, values(self, UNCERTAINTY).__getitem__)


# variables of the fields
UNCERTAINTY = {name.lower(): fed(Expectations, name) for name in Expectations.FIELDS}


@dataclass(frozen=True, eq=False)
class Observer:
    """Table of an observer over rope length.

    Attributes
    ----------
    crane : Crane
        The nominal crane.
    sample_time : float
        [s]
    driven : bool
        Whether corrections are accelerations.
    delayed : bool
        Whether measured signals are one sample old.
    table : ndarray, shape (rows, 19, 10)
        The kernels' `Observer` for ascending rope lengths.
    uncertainty : Uncertainty
    """

    crane: Crane
    sample_time: float
    driven: bool
    delayed: bool
    table: FloatArray
    uncertainty: Uncertainty

    @property
    def lengths(self) -> FloatArray:
        """Rope lengths [m], ascending, shape (rows,)."""
        return self.table[:, Table.LENGTH, 0]


def design_observer(
    crane: Crane,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    driven: bool = False,
    lag: tuple[float, float, float] = (0.0, 0.0, 0.0),
    delayed: bool = False,
    uncertainty: Uncertainty | None = None,
    rows: int = ROWS,
) -> Observer:
    """Design the observer between two rope lengths.

    Parameters
    ----------
    crane : Crane
        The nominal crane.
    sample_time : float
        [s]
    shortest, longest : float
        Rope lengths [m].
    driven : bool
        True: velocity drives, corrections are accelerations; False: forces.
    lag : tuple of 3 float
        Lags of the velocity drives [s].
    delayed : bool
        Measured signals are one sample old.
    uncertainty : Uncertainty, optional

    Raises
    ------
    InputError
        For a period or rope lengths that are not positive, for negative lags, and for numbers so
        large or small that the gains are not finite.
    """
    require_positive("sample_time", sample_time)
    lags = sized("lag", lag, 3)
    for name, value in zip(("bridge", "trolley", "hoist"), lags, strict=True):
        require_not_negative(f"lag of the {name}", value)
    lengths = scheduled_lengths(shortest, longest, rows)
    expected = uncertainty or Uncertainty()
    table = np.zeros((lengths.size, Table.SIZE, Table.COLUMNS))
    work = np.zeros((Kalman.SIZE, WORK_COLUMNS))
    # overflow is reported below, for interpreted and compiled kernels alike
    with np.errstate(all="ignore"):
        finite = backend.observer_table(
            crane.plant(driven, lags), sample_time, expected.vector, lengths.size, lengths,
            np.zeros(Expected.SIZE), work, table,
        )
    if not finite:
        fault = np.zeros(SetupFault.SIZE)
        fault[[SetupFault.VALUE, SetupFault.BOUND]] = shortest, longest
        raise InputError(SETUP.text(SetupStatus.OBSERVER, fault.tolist()))
    return Observer(crane, sample_time, driven, delayed, table, expected)
