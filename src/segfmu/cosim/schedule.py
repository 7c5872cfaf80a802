"""What a coupling makes of units and links: lists of operations that both engines perform."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.channel import Call, Copy
from segfmu.cosim.connection import Link
from segfmu.cosim.unit import Unit

Coupling = Literal["sequential", "parallel", "derivatives"]


@dataclass(frozen=True)
class Step:
    """The step of a unit to the time reached; the first unit may end it earlier."""

    unit: int


@dataclass(frozen=True)
class Meet:
    """The event at which a unit's step ended, and what follows if there was one."""

    unit: int
    calls: tuple[Call, ...] = ()


@dataclass(frozen=True)
class Gate:
    """Operations of a unit with steps of its own: at every so many communication points."""

    every: int
    operations: tuple[Call | Copy | Step, ...]


Operation = Call | Copy | Step | Meet | Gate
Operations = tuple[Operation, ...]


@dataclass(frozen=True)
class Schedule:
    """Operations of a run.

    Attributes
    ----------
    advance : tuple
        A step of all units.
    refresh : tuple
        After a change of variables between two steps.
    exchange : tuple
        At the end of every step, and of a change before the first one.
    point : tuple
        At a communication point, before its row is recorded.
    events : list of ndarray, shape (1,)
        Buffers with times of next events, at which steps end.
    """

    advance: Operations
    refresh: Operations
    exchange: Operations
    point: Operations
    events: list[NDArray[np.float64]]


def scheduled(
    units: Sequence[Unit], links: Sequence[Link], coupling: Coupling, *, events: bool,
    ahead: bool, every: Sequence[int] = (),
) -> Schedule:
    """Operations of a coupling.

    With `events`, steps also end at them; `ahead`: outputs are ahead of time by a communication
    step, so that all steps have to be equal. `every`: how many communication steps a step of each
    unit has; 1 by default, and of the first one. Those of more get their inputs at its end, or, but
    for the sequential coupling, at its beginning; their outputs are held.

    Sequential: a unit's step has the outputs of the units before it at the end of the step, and
    those of the units behind it at its beginning. Else all have those of its beginning.
    """
    told = {u: place for u in units if (place := u.next_event()) is not None}
    if ahead or not events:
        told = {}
    sources = [u for u in units if u in told or any(k.source is u for k in links)]
    others = [u for u in units if u not in sources]
    sinks = [u for u in sources if any(k.sink is u for k in links)]
    long = {unit: count for unit, count in zip(units, every, strict=False) if count > 1}
    transfers = tuple(o for link in links for o in _gated(long.get(link.sink), link.transfer))
    if coupling == "sequential":
        leader = _reads(units[:1]) if units[0] in sources else ()
        advance: list[Operation] = []
        for i, unit in enumerate(units):
            taken = (o for link in links if link.sink is unit for o in link.transfer)
            own = (*taken, Step(i), *(_reads([unit]) if unit in sources else ()))
            advance += _gated(long.get(unit), own)
        return Schedule(
            (*advance, Meet(0, leader)), _reads(sources), (), _reads(others), list(told.values())
        )
    slopes = [s for link in links for s in link.slopes()] if coupling == "derivatives" else []
    each = (o for i, unit in enumerate(units) for o in _gated(long.get(unit), (Step(i),)))
    steps: Operations = (*slopes, *each, Meet(0))
    if ahead:
        # an FMU measures its errors against the inputs that it has, so outputs are read first
        return Schedule(steps, (), (), (*_reads(units), *transfers), [])
    return Schedule(
        steps, (), (*_reads(sources), *transfers), (*_reads(others), *_reads(sinks)),
        list(told.values()),
    )


def initialise(
    units: Sequence[Unit], links: Sequence[Link], leading: Sequence[Unit],
    silent: Sequence[Unit] = (),
) -> None:
    """Leave initialisation mode one after the other, each with the outputs of those before it.

    Units that are silent are in no mode: they only tell what they have told.

    Outputs of units behind are those of initialisation mode. A unit with a lead is ahead of time
    from the end of its initialisation on, so its outputs are handed on before.
    """
    for i, unit in enumerate(units):
        for link in links:
            if link.sink is unit and link.source in units[i:]:
                link.pass_on()
        if unit not in leading and unit not in silent:
            unit.exit_initialization()
        for link in links:
            if link.source is unit and link.sink in units[i:]:
                link.pass_on()
        if unit in leading and unit not in silent:
            unit.exit_initialization()
    for link in links:
        if units.index(link.source) > units.index(link.sink):
            link.pass_on()
    for unit in units:
        # the first row, and the first step, take what was read last
        if not any(link.source is unit for link in links):
            unit.read_outputs()


def _gated(every: int | None, own: Sequence[Call | Copy | Step]) -> Operations:
    return tuple(own) if every is None else (Gate(every, tuple(own)),)


def _reads(units: Sequence[Unit]) -> tuple[Call, ...]:
    return tuple(channel.read for unit in units for _, channel in unit.observed)
