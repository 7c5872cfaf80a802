"""Units: of all signals, and those of the field, such as kN instead of thousands of newtons."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from math import degrees
from pathlib import Path

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.fmu.model import Model
from segfmu.fmu.models import registered
from segfmu.planning import Trajectory

# from this magnitude on in the first unit, the second one, larger by a factor of 1000
LARGE = 2000.0
# of places; a way below this share of them is none
ROUNDING = 1e-12
LARGER = {"N": "kN", "W": "kW", "kg": "t"}
# behind the letters of a unit
POWER = re.compile(r"(?<=[A-Za-z])[2-6]")
RAISED = str.maketrans("23456", "²³⁴⁵⁶")


def powers(unit: str) -> str:
    """A unit with its powers as they are drawn and printed; headers of tables have m/s2."""
    return POWER.sub(lambda found: found[0].translate(RAISED), unit)


def scale(largest: float, unit: str) -> tuple[float, str]:
    """Factor and unit with which magnitudes up to a largest one are shown."""
    if unit == "rad":
        return degrees(1.0), "deg"
    if unit in LARGER and largest >= LARGE:
        return 1e-3, LARGER[unit]
    return 1.0, powers(unit)


def shown(values: Sequence[float], unit: str) -> tuple[tuple[float, ...], str]:
    """Values in the unit that suits the largest of them."""
    factor, name = scale(max(map(abs, values)), unit)
    return tuple(factor * value for value in values), name


def signal_units() -> dict[str, str]:
    """Units of the signals of all FMUs and of time, for the headers of tables."""
    return {"time": "s"} | _units(registered())


@cache
def _units(models: tuple[Model, ...]) -> dict[str, str]:
    specs = (model.spec() for model in models)
    return {v.name: v.unit for spec in specs for v in spec.variables if v.unit}


def run_units(fmus: Mapping[str, Path]) -> dict[str, str]:
    """Units of the columns of a run in which further FMUs take part, by their names.

    A column of which two FMUs have the name is "fmu.name".

    Raises
    ------
    InputError
        For a file that is not a readable FMU.
    """
    from segfmu.cosim.alone import units_of

    found = signal_units()
    if fmus:
        for model in registered():
            spec = model.spec()
            found |= {f"{spec.name}.{v.name}": v.unit for v in spec.variables if v.unit}
    for fmu, path in fmus.items():
        own = units_of(path)
        found |= own | {f"{fmu}.{name}": unit for name, unit in own.items()}
    return found


def with_unit(number: str, unit: str) -> str:
    """A number and its unit, which may be empty."""
    return f"{number} {powers(unit)}".rstrip()


def labelled(name: str, unit: str) -> str:
    """A name with its unit in brackets, which may be empty."""
    return f"{name} [{powers(unit)}]" if unit else name


def unlike(names: Iterable[str], units: Mapping[str, str]) -> str:
    """What tells that signals are in different units; empty where none is known to be."""
    found = [(name, units[name]) for name in names if name in units]
    other = next(((name, unit) for name, unit in found if unit != found[0][1]), None)
    return "" if other is None else f"{found[0][0]} is in {found[0][1]}, {other[0]} in {other[1]}"


def length(largest: float) -> tuple[float, str]:
    """Factor and unit with which lengths up to a largest one [m] are shown."""
    if largest >= 1.0:
        return 1.0, "m"
    return (1e3, "mm") if largest >= 1e-5 else (1e6, "µm")


def scale_with_lengths(largest: float, unit: str) -> tuple[float, str]:
    """As `scale`, with lengths in the unit of their size."""
    return length(largest) if unit == "m" else scale(largest, unit)


def resting(trajectory: Trajectory) -> tuple[bool, ...]:
    """Which axes do not move."""
    low, high = trajectory.extrema(1)
    return tuple((np.maximum(high, -low) == 0.0).tolist())


def ways_from_start(
    trajectory: Trajectory, times: FloatArray
) -> tuple[FloatArray, float, str]:
    """Ways of all axes (times, axes) [m], and factor and unit with which they are shown.

    What is rounding beside the positions is no way.
    """
    places = trajectory(times)
    ways = places - trajectory(0.0)
    largest = float(np.abs(ways).max())
    if largest <= ROUNDING * float(np.abs(places).max()):
        return np.zeros_like(ways), *length(1.0)
    return ways, *length(largest)


def pretty(value: float) -> str:
    """A number with four digits that count, without an exponent where one can do without."""
    if value and not 1e-4 <= abs(value) < 1e6:
        return f"{value:.3g}"
    return f"{float(f'{value:.4g}'):.10f}".rstrip("0").rstrip(".") if value else "0"
