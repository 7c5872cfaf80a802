"""Errors for refused plans."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from segfmu.arrays import FloatArray
from segfmu.errors import InfeasibleError, InputError, SegfmuError
from segfmu.kernels.messages import PLAN, Messages
from segfmu.kernels.planner.records import PlanStatus, Refusal

# attributes of `InfeasibleError` for a status: the limit, and which of these are set
AXIS, INTERVAL, WAYPOINT, VALUE, BOUND = "axis", "interval", "waypoint", "value", "bound"
DETAILS: dict[int, tuple[str | None, tuple[str, ...]]] = {
    PlanStatus.START_BRAKING: ("velocity", (AXIS, INTERVAL, BOUND)),
    PlanStatus.END_BRAKING: ("velocity", (AXIS, INTERVAL, BOUND)),
    PlanStatus.NO_PROFILE: (None, (AXIS, INTERVAL)),
    PlanStatus.NO_COMMON_DURATION: ("duration", (INTERVAL,)),
    PlanStatus.DURATION_TOO_SHORT: ("duration", (VALUE, BOUND)),
    PlanStatus.DURATION_IN_GAP: ("duration", (AXIS,)),
    PlanStatus.WAYPOINT_VELOCITY: ("velocity", (AXIS, WAYPOINT, VALUE, BOUND)),
    PlanStatus.WAYPOINT_ACCELERATION: ("acceleration", (AXIS, WAYPOINT, VALUE, BOUND)),
    PlanStatus.UNBOUNDED_RAMP: ("jerk", (AXIS,)),
    PlanStatus.MOVING_DWELL: ("dwell", (AXIS, WAYPOINT)),
}

SCALE = "the problem is badly scaled; choose limits and distances of similar size"

# the digits of a number in a text
DIGITS = re.compile(r"(?<=:\.)\d+(?=g})")


def told_apart(value: float, bound: float, digits: int) -> int:
    """Digits, at least so many, with which two different numbers read differently."""
    if value == bound:
        return digits
    return next(d for d in range(digits, 18) if f"{value:.{d}g}" != f"{bound:.{d}g}")


def text_apart(
    table: Messages, status: int, report: Sequence[float], pair: tuple[str, str],
    **words: tuple[str, ...],
) -> str:
    """The text of a status, with more digits where two fields of it would read the same."""
    text = table.texts[status]
    if all(f"{{{name}:" in text for name in pair):
        one, other = (report[getattr(table.report, name)] for name in pair)
        text = DIGITS.sub(lambda found: str(told_apart(one, other, int(found.group()))), text)
    return str(replace(table, texts={status: text}).text(status, report, **words))


def refusal(status: int, report: FloatArray, names: tuple[str, ...]) -> SegfmuError:
    """Return the error for a status and report (Refusal); `names` are those of the axes."""
    text = text_apart(PLAN, status, report.tolist(), ("VALUE", "BOUND"), AXIS=names)
    place = int(report[Refusal.INTERVAL])
    if status == PlanStatus.SAMPLE_TIME:
        return InputError(text)
    limit, shown = DETAILS[status]
    if limit in ("velocity", "acceleration"):
        limit += PLAN.words["SIDE"][int(report[Refusal.SIDE])]
    # a waypoint belongs to the interval that ends there
    interval = place + 1 if INTERVAL in shown else max(place, 1) if WAYPOINT in shown else None
    return InfeasibleError(
        text,
        axis=int(report[Refusal.AXIS]) if AXIS in shown else None,
        interval=interval,
        limit=limit,
        value=float(report[Refusal.VALUE]) if VALUE in shown else None,
        bound=float(report[Refusal.BOUND]) if BOUND in shown else None,
    )
