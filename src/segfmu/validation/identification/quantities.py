"""What of a crane file can be fitted: scale, bounds and unit of every such key."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import degrees, inf, pi, sqrt
from typing import Any

from segfmu.arrays import shown
from segfmu.errors import InputError
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.keys import DRIVES, Entry, entries

# of the moved mass, the pendulum's time or the rope's length: as large as what is small beside the
# motion usually is, such as friction, lags and zeros
SMALL = 0.1
# shares of their scales that lags and masses do not go below, as equations of motion need them
LEAST_LAG, LEAST_MASS = 1e-2, 1e-3
# share of its scale from which on what cannot be negative is searched: at a bound there is no way
FROM = 0.3
# times a value that is known, beyond which another one is in another unit
FAR = 10.0
# greatest zero of the rope as a share of its shortest length: a load on hardly any rope turns so
# fast that runs do not end. A rope may be longer than what is measured by any sling
FARTHEST = 0.5
# greatest damping ratio of the sway: of cranes it is a few per cent, from 1 on nothing sways
MOST_DAMPED = 0.5


@dataclass(frozen=True)
class Sizes:
    """Sizes of a crane, from which those of its parameters follow.

    Attributes
    ----------
    masses : tuple of 3 float
        That bridge, trolley and hoist move [kg].
    length : float
        Of the rope [m].
    shortest : float
        Of the rope, but for rare rows [m].
    gravity : float
        [m/s2]
    """

    masses: tuple[float, float, float]
    length: float
    shortest: float
    gravity: float

    @property
    def time(self) -> float:
        """That of the pendulum, its period over 2 pi [s]."""
        return sqrt(self.length / self.gravity)

    @property
    def period(self) -> float:
        """Of the pendulum [s]."""
        return 2.0 * pi * self.time


@dataclass(frozen=True)
class Quantity:
    """A key of the crane file as an unknown.

    Attributes
    ----------
    key : str
        With dots.
    variable : str
        Parameter of GantryCrane that it sets.
    unit : str
        Of the file.
    factor : float
        From the unit of GantryCrane to that of the file.
    before : float
        What the file has, here and below in the unit of GantryCrane.
    start : float
        Where the search begins.
    scale : float
        A change that is large.
    low, high : float
        What is possible.
    """

    key: str
    variable: str
    unit: str
    factor: float
    before: float
    start: float
    scale: float
    low: float = -inf
    high: float = inf


Scale = Callable[[Sizes, int], float]
# by the last parts of a key: scale of axis i, and the least value as a share of it
KINDS: dict[str, tuple[Scale, float]] = {
    "bridge_mass": (lambda s, _: s.masses[0], LEAST_MASS),
    "trolley_mass": (lambda s, _: s.masses[1], LEAST_MASS),
    "payload_mass": (lambda s, _: s.masses[2], LEAST_MASS),
    "lag": (lambda s, _: SMALL * s.time, LEAST_LAG),
    "dead_time": (lambda s, _: SMALL * s.time, 0.0),
    "viscous": (lambda s, i: SMALL * s.masses[i] / s.time, 0.0),
    "coulomb": (lambda s, i: SMALL * s.masses[i] * s.gravity, 0.0),
    "drag": (lambda s, i: SMALL * s.masses[i] / s.length, 0.0),
    "sway.viscous": (lambda s, _: SMALL * s.masses[2] * s.length**2 / s.time, 0.0),
    "zero": (lambda s, _: SMALL * s.length, -inf),
    "sway_x.zero": (lambda s, _: SMALL, -inf),
    "sway_y.zero": (lambda s, _: SMALL, -inf),
}
MASSES = ("bridge_mass", "trolley_mass", "payload_mass")
ZEROS = ("sensors.rope.zero", "sensors.sway_x.zero", "sensors.sway_y.zero")


def fittable() -> list[str]:
    """All keys that can be fitted."""
    return [key for key in _entries() if _kind(key)]


def usual(drive: str) -> list[str]:
    """The keys that are fitted if none are named: what acts on how these drives move the crane."""
    found = [f"{axis}.dead_time" for axis in DRIVES]
    if drive == "velocity":
        # their motion is that of their setpoints, whatever they have to move
        found += [f"{axis}.lag" for axis in DRIVES]
    else:
        found += MASSES
        found += [f"friction.{axis}.{kind}" for axis in DRIVES for kind in ("viscous", "coulomb")]
    return [*found, "friction.sway.viscous", *ZEROS]


def quantity(key: str, crane: CraneFile, value: Callable[[str], Any], sizes: Sizes) -> Quantity:
    """A key as an unknown; `value` gives parameters of GantryCrane by name.

    Raises
    ------
    InputError
        For a key that cannot be fitted.
    """
    if key not in fittable():
        known = ", ".join(fittable())
        raise InputError(f"{key or shown(key)} cannot be fitted; what can is {known}")
    entry = _entries()[key]
    (variable,) = entry.feeds
    before = float(value(variable))
    if key.endswith(".lag") and crane.drive == "force":
        raise InputError(f"{key}: drives that follow forces have no lag")
    make, least = KINDS[_kind(key)]
    scale = make(sizes, next((i for i, a in enumerate(DRIVES) if a in key.split(".")), 0))
    # friction that breaks away is not below the one that slides
    static = float(value(variable.replace(".coulomb", ".static"))) if "coulomb" in key else 0.0
    low, high = least * scale, min(static or inf, greatest(key, sizes))
    start = min(max(before, low if least < 0.0 else FROM * scale), high)
    factor = degrees(1.0) if entry.key.unit == "deg" else 1.0
    return Quantity(key, variable, entry.key.unit, factor, before, start, scale, low, high)


def greatest(key: str, sizes: Sizes) -> float:
    """The greatest value that a key has on cranes."""
    if key == "sensors.rope.zero":
        return FARTHEST * sizes.shortest
    if key == "friction.sway.viscous":
        time = sqrt(sizes.shortest / sizes.gravity)
        return MOST_DAMPED * 2.0 * sizes.masses[2] * sizes.shortest**2 / time
    return inf


def _entries() -> dict[str, Entry]:
    return {".".join(e.path): e for e in entries(CraneFile) if len(e.feeds) == 1}


def _kind(key: str) -> str:
    """The kind of a key, the longest that fits; empty for one that cannot be fitted."""
    if key.startswith(("controller.", "sensors.dead_time")):
        return ""
    return max((k for k in KINDS if f".{key}".endswith(f".{k}")), key=len, default="")
