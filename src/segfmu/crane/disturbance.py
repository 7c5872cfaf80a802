"""Disturbances of a crane: wind on the load, payload changes."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from typing import Literal

import numpy as np

from segfmu.crane.checks import (
    require_finite,
    require_not_negative,
    require_positive,
    require_seed,
    sized,
)
from segfmu.crane.variables import Value, build, fed, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Plant
from segfmu.kernels.numerics.records import RandomState, Sinusoid
from segfmu.kernels.rig.records import Disturbance, WindNoise
from segfmu.kernels.rig.records import PayloadChange as Change
from segfmu.planning.arrays import FloatArray

SHAPES = ("cosine", "sine")

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Gust:
    """A gust that rises to `force` and falls again.

    Parameters
    ----------
    start, duration : float
        [s]
    force : tuple of 3 float
        Peak along x, y, z [N].
    shape : {"cosine", "sine"}
        1 - cosine, (1 - cos(2 pi s)) / 2, or half a sine, sin(pi s); s is time over duration.
    """

    start: float
    duration: float
    force: Vector
    shape: Literal["cosine", "sine"] = "cosine"

    def __post_init__(self) -> None:
        require_finite("gust start", self.start)
        require_positive("gust duration", self.duration)
        sized("gust force", self.force, 3)
        if self.shape not in SHAPES:
            raise InputError(f"gust shape must be cosine or sine, got {self.shape!r}")


@dataclass(frozen=True)
class Wind:
    """Force of the wind on the load, a function of time only.

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
    """

    constant: Vector = (0.0, 0.0, 0.0)
    gust: Gust | None = None
    deviation: Vector = (0.0, 0.0, 0.0)
    bandwidth: float = 1.0
    seed: int = 0
    components: FloatArray = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        sized("wind constant", self.constant, 3)
        deviation = sized("wind deviation", self.deviation, 3)
        for axis, value in zip("xyz", deviation, strict=True):
            require_not_negative(f"wind deviation along {axis}", value)
        require_positive("wind bandwidth", self.bandwidth)
        require_seed("wind seed", self.seed)
        components = np.zeros((Disturbance.COMPONENTS if deviation.any() else 0, Sinusoid.SIZE))
        numbers = np.zeros(RandomState.SIZE)
        backend.seed_numbers(self.seed, numbers)
        backend.noise_components(self.bandwidth, deviation, numbers, components)
        object.__setattr__(self, "components", components)

    def values(self) -> dict[str, float]:
        """As the FMU's variables."""
        gust = values(self.gust or Gust(0.0, 1.0, (0.0, 0.0, 0.0)), GUST)
        return values(self, WIND) | gust | ({} if self.gust else {DURATION: 0.0})

    @classmethod
    def of(cls, value: Value) -> Wind:
        """From the FMU's variables; `value` gives them by name."""
        gust = build(Gust, GUST, value) if float(value(DURATION)) > 0.0 else None
        return build(partial(cls, gust=gust), WIND, value)


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
}
WIND = {
    "constant": fed(Plant, "WIND"), "deviation": fed(WindNoise, "DEVIATION"),
    "bandwidth": fed(WindNoise, "BANDWIDTH"), "seed": fed(WindNoise, "SEED", whole=True),
}
PAYLOAD = {"time": fed(Change, "TIME"), "mass": fed(Change, "MASS")}
(DURATION,) = GUST["duration"].variables
