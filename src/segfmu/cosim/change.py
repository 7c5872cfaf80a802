"""Changes during a run: variables that get new values at a time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set
from dataclasses import dataclass, field
from typing import Any

from numpy.typing import NDArray

from segfmu.arrays import as_tuple, finite_number, require_mapping, shown
from segfmu.cosim.channel import Call, Channel
from segfmu.cosim.domain import Domain, domain
from segfmu.cosim.unit import Unit
from segfmu.errors import InputError, meant


@dataclass(frozen=True)
class Change:
    """New values of inputs or tunable parameters of one FMU, from a time on.

    Attributes
    ----------
    time : float
        [s]; a step ends there. The row of this time already has what follows from the values.
    fmu : str
        Name of the FMU in the system.
    values : mapping of str to number or str
        As start values. They stay until the next change.
    origin : str
        Where the values are from, as a line of a file, for messages.
    """

    time: float
    fmu: str
    values: Mapping[str, Any]
    origin: str = field(default="", compare=False)


@dataclass(frozen=True, eq=False)
class Due:
    """A change whose values are numbers for buffers."""

    time: float
    unit: int
    assignments: list[tuple[Channel, NDArray[Any]]]

    def calls(self) -> Iterator[Call]:
        """The calls, each after its buffer was filled."""
        for channel, values in self.assignments:
            channel.values[:] = values
            yield channel.write


def profile(
    fmu: str, name: str, times: Iterable[float], values: Iterable[Any]
) -> list[Change]:
    """Changes that make a variable follow samples, each held until the next one.

    Raises
    ------
    InputError
        For other numbers of times than of values, and names that are no texts.
    """
    for told, text in (("fmu", fmu), ("name", name)):
        if not isinstance(text, str):
            raise InputError(f"{told} must be a text, got {shown(text)}")
    when, what = as_tuple("times", times), as_tuple("values", values)
    if len(when) != len(what):
        raise InputError(f"{name} has {len(when)} times but {len(what)} values")
    return [Change(t, fmu, {name: v}) for t, v in zip(when, what, strict=True)]


def due(
    units: Mapping[str, Unit], changes: Iterable[Change], connected: Set[tuple[str, str]],
    span: tuple[float, float],
) -> list[Due]:
    """Changes in the order of their times; of one time, in the order given.

    Raises
    ------
    InputError
        For an FMU or a variable that there is not, one that cannot change, a value outside of the
        range that the FMU gives, or a time outside of the run.
    """
    names = list(units)
    found = []
    right: dict[tuple[str, tuple[str, ...]], list[tuple[str, Domain]]] = {}
    for change in as_tuple("changes", changes):
        if not isinstance(change, Change):
            raise InputError(f"changes must be segfmu.cosim.Change, got {shown(change)}")
        if not isinstance(change.fmu, str) or change.fmu not in units:
            told = change.fmu if isinstance(change.fmu, str) else shown(change.fmu)
            raise InputError(f"no FMU {told} in the system; it has {', '.join(names)}")
        time = finite_number(f"{change.fmu}: the time of a change", change.time)
        if not span[0] <= time <= span[1]:
            raise InputError(
                f"{change.fmu}: a change at {change.time!r} s is outside of the run from "
                f"{span[0]:.6g} s to {span[1]:.6g} s"
            )
        require_mapping(f"{change.fmu}: values of a change", change.values)
        unit = units[change.fmu]
        own = change.fmu, tuple(change.values)
        try:
            if own not in right:
                require_changeable(change, unit.variables, connected)
                right[own] = list(_bounded(unit, change.values))
            assignments = unit.assignments(change.values)
            _require_within(change, right[own])
            found.append(Due(time, names.index(change.fmu), assignments))
        except InputError as error:
            raise InputError(f"{change.origin}: {error}" if change.origin else str(error)) from None
    return sorted(found, key=lambda d: d.time)


def _bounded(unit: Unit, names: Iterable[str]) -> Iterator[tuple[str, Domain]]:
    """Of the variables of an FMU those with a least or a greatest value."""
    for name in names:
        variable = unit.variables[name]
        own = domain(variable, unit.TYPES[variable.type])
        if own.bounded:
            yield name, own


def _require_within(change: Change, domains: Iterable[tuple[str, Domain]]) -> None:
    for name, own in domains:
        own.require_within(f"{change.fmu}: {name}", change.values[name])


def require_changeable(
    change: Change, variables: Mapping[str, Any], connected: Set[tuple[str, str]]
) -> None:
    """Refuse a change of what cannot change; variables of the FMU have causality and variability.

    Raises
    ------
    InputError
        For the first name.
    """
    owner = change.fmu
    for name in change.values:
        variable = variables.get(name)
        if variable is None:
            raise InputError(f"{owner} has no variable {name}{meant(name, variables)}")
        tunable = variable.causality == "parameter" and variable.variability == "tunable"
        if variable.causality != "input" and not tunable:
            raise InputError(
                f"{owner}: {name} cannot change during a run, only inputs and tunable parameters "
                "can; give it as a start value"
            )
        if (owner, name) in connected:
            raise InputError(f"{owner}: {name} is connected, so a change of it would not last")

