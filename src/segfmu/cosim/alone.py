"""One FMU alone, whose inputs follow a table: an experiment as every importer performs it."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.channel import Channel
from segfmu.cosim.points import communication_points
from segfmu.cosim.table import Table, columns, fields
from segfmu.cosim.unit import Unit, alike
from segfmu.errors import InputError, meant


def run_alone(
    path: Path, *, stop_time: float, step: float, start_time: float = 0.0,
    values: Mapping[str, Any] | None = None,
    stimuli: Mapping[str, NDArray[np.float64]] | None = None, known: Collection[str] = (),
) -> NDArray[np.void]:
    """Step an FMU; its inputs are held over a step, at their values of its beginning.

    Outputs are those at the end of a step, before the inputs of the next one.

    Parameters
    ----------
    path : Path
        Co-simulation FMU of FMI 2.0 or 3.0.
    stop_time, step, start_time : float
        [s]; the last step is shorter if the step does not divide the time.
    values : mapping of str to number or str
        Parameters and start values.
    stimuli : mapping of str to ndarray
        "time" and inputs; real ones are linear between rows, others are held, all behind the end.
    known : collection of str
        Names of variables, or of elements of arrays, that it has to have.

    Returns
    -------
    ndarray, structured, shape (steps + 1,)
        "time" and all scalar outputs.

    Raises
    ------
    InputError
        For invalid values and files.
    SimulationError
        If the FMU reports an error, with its message.
    """
    from segfmu.cosim.load import load

    times = communication_points(start_time, stop_time, step)
    with load(path) as unit:
        _require_variables(unit, known)
        given = _tracks(unit, stimuli or {}, times)
        unit.set(values or {})
        _feed(given, 0)
        unit.observe(unit.outputs())
        table = Table(times, columns({unit.name: unit}, fields({unit.name: unit.outputs()})))
        unit.enter_initialization(start_time, stop_time)
        unit.exit_initialization()
        unit.read_outputs()
        table.record(0)
        for i, (before, end) in enumerate(pairwise(times.tolist()), 1):
            _feed(given, i - 1)
            unit.step(before, end)
            unit.read_outputs()
            table.record(i)
    return table.rows


def units_of(path: Path) -> dict[str, str]:
    """Units of the outputs of an FMU by name; empty ones are left out.

    Raises
    ------
    InputError
        If it is not a readable FMU.
    """
    from segfmu.cosim.load import describe

    outputs = [v for v in describe(path).modelVariables if v.causality == "output"]
    units = {v.name: v.unit or getattr(v.declaredType, "unit", None) for v in outputs}
    return {name: unit for name, unit in units.items() if unit}


def _require_variables(unit: Unit, names: Collection[str]) -> None:
    for name in names:
        if not {name, name.partition("[")[0]} & {"time", *unit.variables}:
            raise InputError(f"{unit.name} has no variable {name}{meant(name, unit.variables)}")


def _tracks(
    unit: Unit, stimuli: Mapping[str, NDArray[np.float64]], times: NDArray[np.float64]
) -> list[tuple[Channel, NDArray[np.float64]]]:
    """Channels of the inputs, and their values at all times."""
    names = [name for name in stimuli if name != "time"]
    for name in names:
        variable = unit.variables.get(name)
        if variable is None or variable.causality != "input":
            raise InputError(f"{unit.name} has no input {name}")
        if variable.type not in unit.COLUMNS or variable.dimensions:
            raise InputError(f"{unit.name}: {name} is no number, only numbers can follow a table")
    found = []
    for group in alike(names, unit):
        real = unit.kind(group[0]) is float
        tracks = [_sampled(times, stimuli["time"], stimuli[name], real) for name in group]
        found.append((unit.channel(group), np.stack(tracks, axis=1)))
    return found


def _sampled(
    times: NDArray[np.float64], given: NDArray[np.float64], values: NDArray[np.float64], real: bool
) -> NDArray[np.float64]:
    if real:
        return np.interp(times, given, values)
    # a row that rounding puts just behind a time is of this time
    places = np.searchsorted(given, times + 1e-9 * np.abs(times), side="right") - 1
    held: NDArray[np.float64] = values[np.maximum(places, 0)]
    return held


def _feed(given: list[tuple[Channel, NDArray[np.float64]]], row: int) -> None:
    for channel, values in given:
        channel.values[:] = values[row]
        channel.write()
