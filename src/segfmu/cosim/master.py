"""The master: couples two FMUs, connecting outputs of the first to inputs of the second by name.

Sequential: in every communication step the source steps first; the sink then makes the same step
with the source's outputs at the end of the step. Parallel, as in most importers: both step with the
values of the previous step; derivatives at the beginning of the step may be passed too. Steps also
end at the source's events.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import ceil, isfinite
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.link import Link
from segfmu.cosim.table import Table
from segfmu.cosim.unit import Unit
from segfmu.errors import InputError

# results of both FMUs take 0.7 kB a step
MAX_STEPS = 2_000_000

# parameter of the source by which its outputs are ahead of time
LEAD = "setpoint.lead"

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
    coupling: Coupling | None = None,
    events: bool = True,
    progress: Callable[[float], None] = lambda _: None,
) -> NDArray[np.void]:
    """Co-simulate two FMUs.

    Parameters
    ----------
    source, sink : Path
        Co-simulation FMUs of FMI 2.0 or 3.0. Outputs of the source are connected to inputs of the
        sink with the same name.
    stop_time, step, start_time : float
        [s]; the last step is shorter if the step does not divide the time.
    source_values, sink_values : mapping of str to number or str
        Parameters, start values and constant inputs; enumerations by the name of an item; arrays
        of FMI 3.0 after their sizes.
    coupling : str, optional
        By default "derivatives" where both FMUs have what it needs, else "sequential".
        "sequential": the sink's step has the inputs of its end, an error of second order in the
        step; "parallel": those of its beginning, an error of first order, or none beside that of
        "sequential" where the source has a parameter `setpoint.lead` as long as the step;
        "derivatives" (FMI 2.0): those of its beginning and their derivatives, as many as the source
        tells: k of them make an error of order k + 1.
    events : bool
        Steps end at the source's events as well: in FMI 3.0 it returns early, in FMI 2.0 its output
        `plan.next_event` names them. Without, what a signal does behind a kink within a step is
        seen at the end of that step. Steps in parallel that `setpoint.lead` makes up for have to
        be equal, so they end at no events.
    progress : callable
        Called with the share done from time to time.

    Returns
    -------
    ndarray, structured, shape (steps + 1,)
        "time" and all outputs of both FMUs; row i belongs to time start_time + i * step.

    Raises
    ------
    InputError
        For invalid values and files.
    SimulationError
        If an FMU reports an error, with its message.
    """
    if coupling is not None and coupling not in get_args(Coupling):
        allowed = " or ".join(get_args(Coupling))
        raise InputError(f"coupling must be {allowed}, got {coupling!r}")
    times = _times(start_time, stop_time, step)
    # loaded here, so that planning and building do not need fmpy
    from segfmu.cosim.load import load

    lead = bool((source_values or {}).get(LEAD))
    ahead = lead and coupling == "parallel"
    with load(source, leads=events and not ahead) as first, load(sink) as second:
        first.set(dict(source_values or {}))
        second.set(dict(sink_values or {}))
        for unit in (first, second):
            unit.enter_initialization(start_time, stop_time)
        if coupling is None:
            has_derivatives = first.order > 0 and second.takes_derivatives
            coupling = "derivatives" if has_derivatives else "sequential"
        order = max(1, first.order) if coupling == "derivatives" else 0
        link = Link(first, second, order=order)
        # a source with a lead is ahead from the end of its initialisation on
        if lead:
            link.transfer()
        first.exit_initialization()
        if not lead:
            link.transfer()
        second.exit_initialization()
        table = Table(times, first, second)
        _read(first, second, link, ahead)
        table.record(0)
        points = times.tolist()
        for i in range(1, times.size):
            time, end = points[i - 1], points[i]
            while time < end:
                time = _step(time, end, first, second, link, None if ahead else coupling)
            _read(first, second, link, ahead)
            table.record(i)
            if i % 100 == 0:
                progress(i / (times.size - 1))
    progress(1.0)
    return table.rows


def _read(first: Unit, second: Unit, link: Link, ahead: bool) -> None:
    """Read the outputs of a communication point; then hand on those that are ahead of it.

    In this order, as the sink measures its errors against the inputs that it has.
    """
    second.read_outputs()
    if ahead:
        link.transfer()


def _step(
    time: float, end: float, first: Unit, second: Unit, link: Link, coupling: Coupling | None
) -> float:
    """A step of both units towards `end`; returns the time reached, that of an event or `end`.

    Without a coupling, the outputs are handed on by the caller.
    """
    link.transfer_slopes()
    reached = first.step(time, first.next_end(time, end))
    if coupling == "sequential":
        link.transfer()
    second.step(time, reached)
    if first.meet_event() and coupling == "sequential":
        first.read_outputs()
    if coupling in ("parallel", "derivatives"):
        link.transfer()
    return reached


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
