"""Times of a log without rows, in which nobody knows what the drives were told."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from segfmu.errors import InputError
from segfmu.validation.identification.log import FEWEST, GAP, Log, rows_told

# share of a setpoint's range, by which it has changed while there was no row
CHANGED = 0.01


def sections(log: Log, period: float) -> list[Log]:
    """The log, cut where no row is for longer than a period of the pendulum [s].

    Nobody knows what the drives were told and how the load swung meanwhile: what follows begins
    anew.

    Raises
    ------
    InputError
        For a section of too few rows.
    """
    cuts = np.flatnonzero(np.diff(log.times) > period) + 1
    ends = [0, *cuts.tolist(), log.times.size]
    if len(ends) == 2:
        return [log]
    found = []
    for first, last in pairwise(ends):
        part = log.rows(first, last)
        begin, end = part.times[[0, -1]]
        if last - first < FEWEST:
            raise InputError(
                f"{log.name}: {rows_told(last - first)} from {begin:.6g} to {end:.6g} s, with "
                f"gaps of more than the pendulum's period of {period:.3g} s beside them; at least "
                f"{FEWEST} are needed: leave them out, or fill the gaps"
            )
        found.append(replace(part, name=f"{log.name} from {begin:.6g} s"))
    return found


@dataclass(frozen=True)
class Gap:
    """A time without rows, shorter than a period of the pendulum, in which setpoints changed.

    Attributes
    ----------
    log : str
    begin, end : float
        [s]
    """

    log: str
    begin: float
    end: float

    def __str__(self) -> str:
        return (
            f"{self.log}: no row from {self.begin:.6g} to {self.end:.6g} s, while setpoints "
            "changed: they count as linear there, and values may be beyond their intervals; give "
            "what is before and what is behind as two logs"
        )


def longest_gap(log: Log) -> Gap | None:
    """The longest time in which nobody knows what the drives were told; None without any."""
    steps = np.diff(log.times)
    ranges = np.ptp(log.setpoints, axis=0)
    changed = (np.abs(np.diff(log.setpoints, axis=0)) > CHANGED * ranges).any(axis=1)
    places = np.flatnonzero((steps > GAP * np.median(steps)) & changed)
    if not places.size:
        return None
    first = int(places[steps[places].argmax()])
    return Gap(log.name, *log.times[first : first + 2].tolist())
