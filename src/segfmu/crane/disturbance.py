"""Disturbances of a crane: wind on the load, payload changes."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np

from segfmu.arrays import FloatArray, shown, sized
from segfmu.crane.checks import (
    require_finite,
    require_frequency,
    require_kind,
    require_not_negative,
    require_positive,
    require_seed,
)
from segfmu.crane.variables import Value, fed, kept, of_values, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Plant
from segfmu.kernels.messages import SETUP
from segfmu.kernels.numerics.records import RandomState, Sinusoid
from segfmu.kernels.rig.records import Disturbance, SetupFault, SetupStatus, WindNoise
from segfmu.kernels.rig.records import PayloadChange as Change
from segfmu.kernels.rig.records import Turbulence as Spectrum

SHAPES = ("cosine", "sine")

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Gust:
    """A gust that rises to `force` and falls again.

    Parameters
    ----------
    start, duration : float
        [s]; a start of -1e9 is that of the simulation.
    force : tuple of 3 float
        Peak along x, y, z [N].
    speed : tuple of 3 float
        The same of the air's speed [m/s], which acts on the load by its drag area.
    shape : {"cosine", "sine"}
        1 - cosine, (1 - cos(2 pi s)) / 2, or half a sine, sin(pi s); s is time over duration.
    """

    start: float
    duration: float
    force: Vector = (0.0, 0.0, 0.0)
    shape: Literal["cosine", "sine"] = "cosine"
    speed: Vector = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        require_finite("gust start", self.start)
        require_positive("gust duration", self.duration)
        sized("gust force", self.force, 3)
        sized("gust speed", self.speed, 3)
        if not isinstance(self.shape, str) or self.shape not in SHAPES:
            raise InputError(f"gust shape must be cosine or sine, got {shown(self.shape)}")


@dataclass(frozen=True)
class Turbulence:
    """Turbulence of the air, with Davenport's spectrum; it depends on the mean speed of the wind.

    Parameters
    ----------
    deviation : tuple of 3 float
        Standard deviations of the air's speed along x, y, z [m/s], all of it below `bandwidth`.
    length : float
        Length scale of the spectrum [m].
    bandwidth : float
        Largest frequency [Hz].
    seed : int
        The same seed gives the same wind with any step.
    """

    deviation: Vector
    length: float = 1200.0
    bandwidth: float = 1.0
    seed: int = 0

    def __post_init__(self) -> None:
        deviation = sized("turbulence deviation", self.deviation, 3)
        for axis, value in zip("xyz", deviation, strict=True):
            require_not_negative(f"turbulence deviation along {axis}", value)
        require_positive("turbulence length", self.length)
        require_frequency("turbulence bandwidth", self.bandwidth)
        require_seed("turbulence seed", self.seed)


@dataclass(frozen=True)
class Wind:
    """Force of the wind on the load: forces over time, and drag of the air that moves past it.

    The drag is air_density * drag_area * |v| v / 2, with the velocity v of the air relative to the
    load: a steady speed, the gust's, and turbulence.

    Parameters
    ----------
    constant : tuple of 3 float
        Along x, y, z [N].
    gust : Gust, optional
    deviation : tuple of 3 float
        Standard deviations of the noise [N].
    bandwidth : float
        The spectrum of the noise is flat up to this frequency [Hz] and zero above it.
    seed : int
        Of the noise; the same seed gives the same wind with any step.
    speed : tuple of 3 float
        Mean speed of the air along x, y, z [m/s].
    turbulence : Turbulence, optional
    drag_area : float
        Drag coefficient of the load times its area [m2].
    air_density : float
        [kg/m3]

    Raises
    ------
    InputError
        For values out of range, and for turbulence without a mean speed.
    """

    constant: Vector = (0.0, 0.0, 0.0)
    gust: Gust | None = None
    deviation: Vector = (0.0, 0.0, 0.0)
    bandwidth: float = 1.0
    seed: int = 0
    speed: Vector = (0.0, 0.0, 0.0)
    turbulence: Turbulence | None = None
    drag_area: float = 0.0
    air_density: float = 1.225
    components: FloatArray = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        for name, kind in (("gust", Gust), ("turbulence", Turbulence)):
            if getattr(self, name) is not None:
                require_kind(f"wind {name}", getattr(self, name), kind)
        sized("wind constant", self.constant, 3)
        deviation = sized("wind deviation", self.deviation, 3)
        for axis, value in zip("xyz", deviation, strict=True):
            require_not_negative(f"wind deviation along {axis}", value)
        require_frequency("wind bandwidth", self.bandwidth)
        require_seed("wind seed", self.seed)
        components = np.zeros((Disturbance.COMPONENTS if deviation.any() else 0, Sinusoid.SIZE))
        numbers = np.zeros(RandomState.SIZE)
        backend.seed_numbers(self.seed, numbers)
        backend.noise_components(self.bandwidth, deviation, numbers, components)
        components = np.vstack([components, self._turbulent()])
        object.__setattr__(self, "components", components)

    def _turbulent(self) -> FloatArray:
        """Sines of the air's speed; checks what they follow from."""
        speed = sized("wind speed", self.speed, 3)
        require_not_negative("wind drag_area", self.drag_area)
        require_not_negative("wind air_density", self.air_density)
        own = self.turbulence
        if own is None or not any(own.deviation):
            return np.zeros((0, Sinusoid.SIZE))
        found, numbers = np.zeros((Disturbance.COMPONENTS, Sinusoid.SIZE)), np.zeros(2)
        fault = np.zeros(SetupFault.SIZE)
        status = backend.check_turbulence(speed, np.array(own.deviation, dtype=np.float64), fault)
        if status != SetupStatus.FITS:
            raise InputError(SETUP.text(status, fault.tolist()))
        backend.seed_numbers(own.seed, numbers)
        backend.turbulence_components(
            backend.wind_speed(speed), own.length, own.bandwidth,
            np.array(own.deviation, dtype=np.float64), numbers, found,
        )
        return found

    def values(self) -> dict[str, float]:
        """As the FMU's variables."""
        return dict(self._values)

    @cached_property
    def _values(self) -> dict[str, float]:
        gust = values(self.gust or Gust(0.0, 1.0), GUST)
        turbulence = values(self.turbulence or Turbulence((0.0, 0.0, 0.0)), TURBULENCE)
        return (
            values(self, WIND) | gust | turbulence | ({} if self.gust else {DURATION: 0.0})
        )

    @classmethod
    @of_values
    def of(cls, value: Value) -> Wind:
        """From the FMU's variables; `value` gives them by name."""
        gust = kept(Gust, GUST, value) if float(value(DURATION)) > 0.0 else None
        turbulence: Turbulence | None = kept(Turbulence, TURBULENCE, value)
        if turbulence is not None and not any(turbulence.deviation):
            turbulence = None
        return kept(cls, WIND, value, gust=gust, turbulence=turbulence)


@dataclass(frozen=True)
class PayloadChange:
    """The load's mass becomes `mass` [kg] at `time` [s]; added mass has the load's velocity."""

    time: float
    mass: float

    def __post_init__(self) -> None:
        require_finite("payload change time", self.time)
        require_positive("payload change mass", self.mass)


# variables of the classes' fields
GUST = {
    "start": fed(Plant, "GUST_START"), "duration": fed(Plant, "GUST_DURATION"),
    "force": fed(Plant, "GUST_FORCE"), "shape": fed(Plant, "GUST_SHAPE", items=SHAPES),
    "speed": fed(Plant, "GUST_SPEED"),
}
TURBULENCE = {
    "deviation": fed(Spectrum, "DEVIATION"), "length": fed(Spectrum, "LENGTH"),
    "bandwidth": fed(Spectrum, "BANDWIDTH"), "seed": fed(Spectrum, "SEED", whole=True),
}
WIND = {
    "speed": fed(Plant, "WIND_SPEED"), "drag_area": fed(Plant, "DRAG_AREA"),
    "air_density": fed(Plant, "AIR_DENSITY"),
    "constant": fed(Plant, "WIND"), "deviation": fed(WindNoise, "DEVIATION"),
    "bandwidth": fed(WindNoise, "BANDWIDTH"), "seed": fed(WindNoise, "SEED", whole=True),
}
PAYLOAD = {"time": fed(Change, "TIME"), "mass": fed(Change, "MASS")}
(DURATION,) = GUST["duration"].variables
