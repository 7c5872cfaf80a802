"""Interleaved timing: the contestants take turns, so that what else the machine does hits all."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from time import perf_counter_ns

import numpy as np
from numpy.typing import NDArray

from benchmarks.report import Record

FloatArray = NDArray[np.float64]
WARM_UP = 50


def interleaved(
    calls: Mapping[str, Callable[[int], object]], problems: int, repetitions: int
) -> dict[str, FloatArray]:
    """Time every call on every problem [us], shape (repetitions, problems) each.

    A problem is given to one contestant after the other, and every time another one begins.
    """
    for call in calls.values():
        for i in range(min(WARM_UP, problems)):
            call(i)
    times = {name: np.zeros((repetitions, problems)) for name in calls}
    order = list(calls.items())
    for repetition in range(repetitions):
        for i in range(problems):
            order.append(order.pop(0))
            for name, call in order:
                begun = perf_counter_ns()
                call(i)
                times[name][repetition, i] = (perf_counter_ns() - begun) / 1e3
    return times


def spread(values: FloatArray) -> Record:
    """Mean, median, 99 % and largest of times [us], shape (repetitions, problems).

    For the last two each problem counts with its least time of all passes: what else the machine
    does would hide the slow problems.
    """
    least = values.min(axis=0)
    return {
        "mean us": float(values.mean()),
        "median us": float(np.median(values)),
        "99 % us": float(np.quantile(least, 0.99)),
        "largest us": float(least.max()),
    }


def ratios(values: FloatArray, reference: FloatArray) -> Record:
    """Ratio of two rows of figures, one a repetition: its median, least and largest."""
    found = values / reference
    return {
        "ratio": float(np.median(found)),
        "least": float(found.min()),
        "largest": float(found.max()),
    }
