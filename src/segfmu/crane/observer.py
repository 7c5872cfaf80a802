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

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, as_flag, sized, table_of
from segfmu.crane.checks import require_kind, require_not_negative, require_positive
from segfmu.crane.linear import ROWS, scheduled_lengths
from segfmu.crane.parameters import Crane
from segfmu.crane.variables import fed, filled, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.control.records import AxisModel, Expected, History, Kalman
from segfmu.kernels.control.records import Observer as Table
from segfmu.kernels.control.records import Uncertainty as Expectations
from segfmu.kernels.crane.records import Axes, Plant
from segfmu.kernels.messages import SETUP
from segfmu.kernels.rig.records import Sensors, SetupFault, SetupStatus

STEPS = ("position", "length", "angle")

# shape of the design's work space
WORK_COLUMNS = 2 * AxisModel.SIZE


@dataclass(frozen=True)
class Uncertainty:
    """Assumed uncertainty of sensors and disturbances.

    Parameters
    ----------
    position, length, angle : float
        Quantisation steps of the carriages' positions [m], the rope's length [m] and the sway
        angles [rad]; errors are assumed uniformly distributed, with variance step^2 / 12. 0: those
        of usual encoders, 1 / 5000 of the longest rope, and 4096 in a turn.
    drift, wind : float
        Random walks of the disturbances of carriages and rope, and of the load: standard deviation
        after sqrt(l / g), the time of the pendulum, as a multiple of gravity. Larger values make
        the observer faster and noisier. Where drives are weak, that of the load counts less.
    wake : float
        The controller starts to act when a signal first deviates from its reference by more than
        this many quantisation steps; smaller deviations may be rounding. 0: from the start.
    offset : float
        Standard deviation of the rope sensor's zero, as a share of the rope's length; it limits
        what is believed of an estimate. 0: none is estimated.

    Raises
    ------
    InputError
        For negative values, and walks of 0.
    """

    position: float = 0.0
    length: float = 0.0
    angle: float = 0.0
    drift: float = 0.1
    wind: float = 0.015
    wake: float = 1.0
    offset: float = 0.05

    def __post_init__(self) -> None:
        for name in ("drift", "wind"):
            require_positive(f"uncertainty {name}", getattr(self, name))
        for name in ("position", "length", "angle", "wake", "offset"):
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
    delayed : float
        Age of the signals, in samples.
    dead_time : tuple of 3 float
        From a setpoint to the drive that takes it [s].
    table : ndarray, shape (rows, 19, 10)
        The kernels' `Observer` for ascending rope lengths.
    uncertainty : Uncertainty
    lag : tuple of 3 float
        Of the velocity drives [s].

    Raises
    ------
    InputError
        For arguments of another kind, and a table of another shape.
    """

    crane: Crane
    sample_time: float
    driven: bool
    delayed: float
    table: FloatArray
    uncertainty: Uncertainty
    lag: tuple[float, float, float]
    dead_time: tuple[float, float, float]

    def __post_init__(self) -> None:
        require_kind("crane", self.crane, Crane)
        require_kind("uncertainty", self.uncertainty, Uncertainty)
        require_positive("sample_time", self.sample_time)
        as_flag("driven", self.driven)
        _delays(self.sample_time, self.delayed, self.dead_time)
        for value in sized("lag", self.lag, 3):
            require_not_negative("lag", value)
        table = table_of("table", self.table, None, Table.SIZE, Table.COLUMNS)
        object.__setattr__(self, "table", table)

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
    delayed: float = 0.0,
    dead_time: tuple[float, float, float] = (0.0, 0.0, 0.0),
    uncertainty: Uncertainty | None = None,
    strongest: ArrayLike | None = None,
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
    delayed : float
        Age of the signals at a tick, in samples; True is one.
    dead_time : tuple of 3 float
        From a setpoint to the drive that takes it [s].
    uncertainty : Uncertainty, optional
    strongest : array_like, shape (3,), optional
        Largest corrections that the drives can make [N] or [m/s2].

    Raises
    ------
    InputError
        For a period or rope lengths that are not positive, for negative or long delays, and for
        numbers so large or small that the gains are not finite.
    """
    expected = Uncertainty() if uncertainty is None else uncertainty
    require_kind("crane", crane, Crane)
    require_kind("uncertainty", expected, Uncertainty)
    require_positive("sample_time", sample_time)
    lags = sized("lag", lag, 3)
    for name, value in zip(("bridge", "trolley", "hoist"), lags, strict=True):
        require_not_negative(f"lag of the {name}", value)
    delayed = float(delayed) if isinstance(delayed, bool | np.bool_) else delayed
    late = _delays(sample_time, delayed, dead_time)
    lengths = scheduled_lengths(shortest, longest, rows)
    steps = expected.vector
    backend.set_steps(np.zeros(Sensors.SIZE), float(lengths[-1]), steps)
    known = replace(expected, **dict(zip(STEPS, steps.tolist(), strict=False)))
    plant = crane.plant(driven, lags)
    if strongest is not None:
        bounds = Plant.ACCELERATION_MAX if driven else Plant.FORCE_MAX
        plant[bounds : bounds + Axes.SIZE] = sized("strongest", strongest, Axes.SIZE)
    backend.set_walks(plant, steps)
    table = np.zeros((lengths.size, Table.SIZE, Table.COLUMNS))
    work = np.zeros((Kalman.SIZE, WORK_COLUMNS))
    # overflow is reported below, for interpreted and compiled kernels alike
    with np.errstate(all="ignore"):
        finite = backend.observer_table(
            plant, sample_time, steps, lengths.size, lengths,
            np.zeros(Expected.SIZE), work, table,
        )
    if not finite:
        fault = np.zeros(SetupFault.SIZE)
        fault[[SetupFault.VALUE, SetupFault.BOUND]] = shortest, longest
        raise InputError(SETUP.text(SetupStatus.OBSERVER, fault.tolist()))
    first, second, third = lags.tolist()
    return Observer(
        crane, sample_time, bool(driven), float(delayed), table, known, (first, second, third), late
    )


def _delays(
    sample_time: float, delayed: float, dead_time: ArrayLike
) -> tuple[float, float, float]:
    """Dead times of the three drives [s], with which signals are not too late."""
    require_not_negative("delayed", delayed)
    first, second, third = sized("dead_time", dead_time, 3).tolist()
    for value in (first, second, third):
        require_not_negative("dead_time", value)
    total = delayed + max(first, second, third) / sample_time
    if total > History.MOST - 3:
        raise InputError(
            f"signals and drives are {total:.3g} samples late; a controller remembers "
            f"{History.MOST - 3}: raise its sample_time of {sample_time:g} s"
        )
    return first, second, third
