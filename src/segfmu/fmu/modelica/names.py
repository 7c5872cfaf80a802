"""Names, numbers and declarations of the specification as Modelica text."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable

from segfmu.fmu.standard.spec import Value, Variable
from segfmu.fmu.standard.units import DISPLAY_UNITS, nominal

CONNECTORS = {"Real": "RealOutput", "Integer": "IntegerOutput", "Boolean": "BooleanOutput"}


def identifier(name: str) -> str:
    """A structured name as one identifier: waypoint[1].dwell becomes waypoint_1_dwell."""
    return re.sub(r"\W+", "_", name).strip("_")


def title(name: str) -> str:
    """The first part of a structured name, by which a tool groups its dialogue."""
    return re.split(r"\W", name)[0]


def quoted(text: str) -> str:
    """A string literal."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def literal(variable: Variable, value: Value) -> str:
    """A value of a variable."""
    if variable.enumeration is not None:
        return f"{enumeration(variable)}.{variable.enumeration.items[int(value) - 1]}"
    if variable.kind == "Boolean":
        return "true" if value else "false"
    return repr(float(value)) if variable.kind == "Real" else str(int(value))


def enumeration(variable: Variable) -> str:
    """The Modelica type of an enumeration."""
    if variable.enumeration is None:
        raise AssertionError(f"{variable.name} is no enumeration")
    return f"Types.{variable.enumeration.name}"


def type_of(variable: Variable) -> str:
    """The Modelica type of a variable that is no connector."""
    return enumeration(variable) if variable.enumeration is not None else variable.kind


def modifiers(variable: Variable, *, each: bool = False, start: bool = False) -> str:
    """Unit, range and size of a variable, in parentheses where there are any."""
    found: list[str] = []
    if variable.unit is not None:
        found.append(f"unit = {quoted(variable.unit)}")
        if variable.unit in DISPLAY_UNITS:
            found.append(f"displayUnit = {quoted(DISPLAY_UNITS[variable.unit][0])}")
    if variable.enumeration is None:
        for name, bound in (("min", variable.minimum), ("max", variable.maximum)):
            if bound is not None:
                found.append(f"{name} = {literal(variable, bound)}")
        size = nominal(variable)
        if size is not None:
            found.append(f"nominal = {size!r}")
    if start and variable.start is not None:
        found.append(f"start = {literal(variable, variable.start)}")
    prefix = "each " if each else ""
    return f"({', '.join(prefix + text for text in found)})" if found else ""


def listed(items: Iterable[object]) -> str:
    """An array literal over lines of at most 100 characters."""
    return "{" + wrapped(", ".join(map(str, items))) + "}"


def wrapped(text: str) -> str:
    """A list with commas, broken at spaces, further lines indented."""
    return "\n      ".join(
        textwrap.wrap(text, 92, break_long_words=False, break_on_hyphens=False)
    )
