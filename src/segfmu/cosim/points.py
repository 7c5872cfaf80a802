"""Communication points of a run."""

from __future__ import annotations

from math import ceil

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import finite_number, shown
from segfmu.errors import InputError

# results of two FMUs take 0.7 kB a step
MAX_STEPS = 2_000_000


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


def require_step(step: float) -> None:
    """InputError for a step that is no time above zero."""
    if not finite_number("step", step) > 0.0:
        raise InputError(f"step must be a time > 0 s, got {shown(step)}")


def communication_points(start: float, stop: float, step: float) -> NDArray[np.float64]:
    """Times start + i * step, the last one at stop."""
    require_step(step)
    if not finite_number("stop_time", stop) > finite_number("start_time", start):
        raise InputError(f"stop_time {stop!r} s must be after start_time {start!r} s")
    require_steps(stop - start, step)
    count = max(ceil((stop - start) / step - 1e-9), 1)
    times: NDArray[np.float64] = start + np.arange(count + 1, dtype=np.float64) * step
    times[-1] = stop
    return times
