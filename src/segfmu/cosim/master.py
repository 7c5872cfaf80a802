"""The master: two FMUs, the first one's outputs are the second one's inputs by their names.

In every communication step the source steps first and its outputs at the end of the step are
handed to the sink, which then makes the same step. In parallel, as most importers do it, both step
with the values of the step before and the outputs are handed on afterwards.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import ceil, isfinite
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.unit import Channel, Slopes, Unit
from segfmu.errors import InputError

# results of both FMUs take 0.7 kB a step
MAX_STEPS = 2_000_000

Coupling = Literal["sequential", "parallel", "derivatives"]


def simulate(
    source: Path,
    sink: Path,
    *,
    stop_time: float,
    step: float,
    start_time: float = 0.0,
    source_values: Mapping[str, Any] | None = None,
    sink_values: Mapping[str, Any] | None = None,
    coupling: Coupling = "sequential",
    progress: Callable[[float], None] = lambda _: None,
) -> NDArray[np.void]:
    """Co-simulate two FMUs.

    Parameters
    ----------
    source, sink : Path
        FMI 2.0 co-simulation FMUs. Outputs of the source are connected to the inputs of the sink
        that have the same name.
    stop_time, step, start_time : float
        [s]; the last step is shorter where the step does not divide the time.
    source_values, sink_values : mapping of str to number or str
        Parameters, start values and constant inputs; enumerations by the name of an item.
    coupling : str
        "sequential": the sink's step has the inputs of its end, an error of second order in the
        step; "parallel": those of its beginning, an error of first order; "derivatives": those of
        its beginning and their slopes, by output and input derivatives, of second order again.
    progress : callable
        Gets the share done, now and then.

    Returns
    -------
    ndarray, structured, shape (steps + 1,)
        "time" and all outputs of both FMUs; row i belongs to time start_time + i * step.

    Raises
    ------
    InputError
        For values and files that are not usable.
    SimulationError
        When an FMU reports an error, with its message.
    """
    if coupling not in get_args(Coupling):
        allowed = " or ".join(get_args(Coupling))
        raise InputError(f"coupling must be {allowed}, got {coupling!r}")
    times = _times(start_time, stop_time, step)
    with Unit(source) as first, Unit(sink) as second:
        first.set(dict(source_values or {}))
        second.set(dict(sink_values or {}))
        for unit in (first, second):
            unit.enter_initialization(start_time, stop_time)
        link = _Link(first, second, slopes=coupling == "derivatives")
        first.exit_initialization()
        link.transfer()
        second.exit_initialization()
        table = _Table(times, first, second)
        table.record(0)
        for i in range(1, times.size):
            time, length = float(times[i - 1]), float(times[i] - times[i - 1])
            link.transfer_slopes()
            first.step(time, length)
            if coupling == "sequential":
                link.transfer()
            second.step(time, length)
            if coupling != "sequential":
                link.transfer()
            table.record(i)
            if i % 100 == 0:
                progress(i / (times.size - 1))
    progress(1.0)
    return table.rows


def require_steps(duration: float, step: float) -> None:
    """Refuse runs whose results would not fit in memory.

    Raises
    ------
    InputError
        For more than `MAX_STEPS` steps.
    """
    steps = duration / step
    if steps > MAX_STEPS:
        raise InputError(
            f"{duration:.6g} s in steps of {step:.6g} s are {steps:.3g} steps, at most {MAX_STEPS} "
            "are possible; take a longer step or a shorter time"
        )


def _times(start: float, stop: float, step: float) -> NDArray[np.float64]:
    """Communication points start + i * step, the last one at stop."""
    if not (isfinite(step) and step > 0.0):
        raise InputError(f"step must be a time > 0 s, got {step!r}")
    if not (isfinite(start) and isfinite(stop) and stop > start):
        raise InputError(f"stop_time {stop!r} s must be after start_time {start!r} s")
    require_steps(stop - start, step)
    count = ceil((stop - start) / step - 1e-9)
    times: NDArray[np.float64] = start + np.arange(count + 1, dtype=np.float64) * step
    times[-1] = stop
    return times


class _Link:
    """Equal names: outputs of one unit to inputs of the other."""

    def __init__(self, first: Unit, second: Unit, *, slopes: bool) -> None:
        inputs = {
            v.name: v.type for v in second.description.modelVariables if v.causality == "input"
        }
        names = [n for n in first.outputs() if n in inputs]
        for name in names:
            if first.variables[name].type != inputs[name]:
                raise InputError(f"{name}: types of output and input differ")
        sources, sinks = first.channel(names), second.channel(names)
        self._pairs: list[tuple[Channel, Channel]] = [(sources[g], sinks[g]) for g in sources]
        self._slopes: tuple[Slopes, Slopes] | None = None
        if slopes:
            self._slopes = first.output_slopes(names), second.input_slopes(names)

    def transfer_slopes(self) -> None:
        """Slopes at the beginning of a step; they hold until its end."""
        if self._slopes:
            source, sink = self._slopes
            source.read()
            sink.values[:] = source.values
            sink.write()

    def transfer(self) -> None:
        for source, sink in self._pairs:
            source.read()
            sink.values[:] = source.values
            sink.write()


class _Table:
    """Rows of the result: time and all outputs."""

    def __init__(self, times: NDArray[np.float64], *units: Unit) -> None:
        fields: list[tuple[str, type]] = [("time", np.float64)]
        self._sources: list[tuple[Channel, list[str]]] = []
        for unit in units:
            names = unit.outputs()
            for group, channel in unit.channel(names).items():
                own = [n for n in names if _group(unit, n) == group]
                kind = {"Real": np.float64, "Integer": np.int32, "Boolean": np.bool_}[group]
                fields += [(n, kind) for n in own]
                self._sources.append((channel, own))
        self.rows: NDArray[np.void] = np.zeros(times.size, dtype=fields)
        self.rows["time"] = times

    def record(self, i: int) -> None:
        row = self.rows[i]
        for channel, names in self._sources:
            channel.read()
            for name, value in zip(names, channel.values, strict=True):
                row[name] = value


def _group(unit: Unit, name: str) -> str:
    kind = unit.variables[name].type
    return "Integer" if kind == "Enumeration" else str(kind)
