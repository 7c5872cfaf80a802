"""SI units of the interfaces: exponents of the base units, and display units."""

from __future__ import annotations

from collections.abc import Iterable
from math import degrees
from xml.etree import ElementTree as ET

from segfmu.fmu.standard.spec import Spec, Variable

BASE_UNITS: dict[str, dict[str, int]] = {
    "m": {"m": 1},
    "m/s": {"m": 1, "s": -1},
    "m/s2": {"m": 1, "s": -2},
    "m/s3": {"m": 1, "s": -3},
    "m/s4": {"m": 1, "s": -4},
    "s": {"s": 1},
    "kg": {"kg": 1},
    "N": {"kg": 1, "m": 1, "s": -2},
    "N/m": {"kg": 1, "s": -2},
    "N.s/m": {"kg": 1, "s": -1},
    "kg/m3": {"kg": 1, "m": -3},
    "m2": {"m": 2},
    "N.m.s": {"kg": 1, "m": 2, "s": -1},
    "W": {"kg": 1, "m": 2, "s": -3},
    "Hz": {"s": -1},
    "J": {"kg": 1, "m": 2, "s": -2},
    "rad": {"rad": 1},
    "rad/s": {"rad": 1, "s": -1},
    "rad/s2": {"rad": 1, "s": -2},
}

# unit -> (display unit, factor from the unit to it)
DISPLAY_UNITS: dict[str, tuple[str, float]] = {
    "rad": ("deg", degrees(1.0)),
    "rad/s": ("deg/s", degrees(1.0)),
    "rad/s2": ("deg/s2", degrees(1.0)),
}

# sizes that are usual, where they are not about 1
NOMINALS = {"rad": 0.1, "rad/s": 0.1, "N": 10.0, "J": 10.0, "W": 10.0}


def unit_definitions(root: ET.Element, spec: Spec) -> None:
    """Describe the units that an interface uses, as both versions of FMI do."""
    definitions = ET.SubElement(root, "UnitDefinitions")
    for name in used_units(spec.variables):
        unit = ET.SubElement(definitions, "Unit", {"name": name})
        ET.SubElement(unit, "BaseUnit", exponents(name))
        if name in DISPLAY_UNITS:
            shown, factor = DISPLAY_UNITS[name]
            ET.SubElement(unit, "DisplayUnit", {"name": shown, "factor": repr(factor)})


def used_units(variables: Iterable[Variable]) -> list[str]:
    """The units of variables, each once."""
    used = {v.unit for v in variables}
    return [name for name in BASE_UNITS if name in used]


def exponents(name: str) -> dict[str, str]:
    """Exponents of a unit's base units, as attributes."""
    return {base: str(value) for base, value in BASE_UNITS[name].items()}


def nominal(variable: Variable) -> float | None:
    """The nominal value of a continuous variable; None where it is 1, as FMI takes it to be."""
    if variable.nominal is not None or variable.variability != "continuous":
        return variable.nominal
    return NOMINALS.get(variable.unit or "")
