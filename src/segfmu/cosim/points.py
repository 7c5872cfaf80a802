"""Communication points of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import finite_number, shown
from segfmu.errors import InputError

# results of two FMUs take 0.7 kB a step
MAX_STEPS = 2_000_000
# a share of a step that is rounding
SAME = 1e-9


def require_steps(duration: float, step: float) -> None:
    """Refuse runs whose results would not fit in memory.

    Raises
    ------
    InputError
        For more than `MAX_STEPS` steps, and what are no times.
    """
    duration, step = finite_number("duration", duration), require_step(step)
    steps = duration / step
    if steps > MAX_STEPS:
        raise InputError(
            f"{duration:.6g} s in steps of {step:.6g} s are {steps:.3g} steps, at most {MAX_STEPS} "
            "are possible; take a longer step or a shorter time"
        )


def require_step(step: float) -> float:
    """A step as a number; InputError for one that is no time above zero."""
    number = finite_number("step", step)
    if not number > 0.0:
        raise InputError(f"step must be a time > 0 s, got {shown(step)}")
    return number


def step_counts(
    names: Sequence[str], steps: Mapping[str, float], step: float, coupling: str | None
) -> list[int]:
    """How many communication steps a step of each FMU has.

    Parameters
    ----------
    names : sequence of str
        Of the FMUs, in the order in which they step.
    steps : mapping of str to float
        Of some of them [s].
    step : float
        Communication step [s].
    coupling : str, optional
        That was asked for.

    Raises
    ------
    InputError
        For a step that is no multiple, one of the first FMU, and derivatives with several steps.
    """
    counts = dict.fromkeys(names, 1)
    for owner, given in steps.items():
        own = require_step(given)
        counts[owner] = round(own / step)
        if abs(counts[owner] * step - own) > SAME * own:
            raise InputError(
                f"step {own} s of {owner} is no multiple of the communication step {step} s"
            )
    if counts[names[0]] > 1:
        raise InputError(
            f"{names[0]} steps first, and with the communication step; name another FMU first, or "
            "leave out its step"
        )
    if coupling == "derivatives" and max(counts.values()) > 1:
        raise InputError('coupling "derivatives" needs one step for all FMUs')
    return list(counts.values())


def communication_points(start: float, stop: float, step: float) -> NDArray[np.float64]:
    """Times start + i * step, the last one at stop."""
    step = require_step(step)
    start, stop = finite_number("start_time", start), finite_number("stop_time", stop)
    if not stop > start:
        raise InputError(f"stop_time {stop!r} s must be after start_time {start!r} s")
    require_steps(stop - start, step)
    count = max(ceil((stop - start) / step - SAME), 1)
    times: NDArray[np.float64] = start + np.arange(count + 1, dtype=np.float64) * step
    times[-1] = stop
    return times
