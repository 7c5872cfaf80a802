"""A prepared co-simulation: FMUs that are loaded once and run many times."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from threading import Lock
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import as_flag, as_names, as_tuple, require_callable, require_mapping, shown
from segfmu.cosim import native
from segfmu.cosim.change import Change, due
from segfmu.cosim.connection import Link, by_name, checked
from segfmu.cosim.loop import Loop
from segfmu.cosim.points import communication_points, require_step, step_counts
from segfmu.cosim.schedule import Coupling, initialise, scheduled
from segfmu.cosim.table import chosen, columns, fields
from segfmu.cosim.tape import OffTape, Tape
from segfmu.cosim.unit import NEXT_EVENT, Unit
from segfmu.errors import InputError, SimulationError, meant

# parameter of a source by which its outputs are ahead of time
LEAD = "setpoint.lead"

Engine = Literal["auto", "c", "python"]


class System:
    """FMUs, their connections, and how they are stepped; a context manager that frees them.

    Parameters
    ----------
    fmus : mapping of str to Path, or sequence of Path
        Co-simulation FMUs of FMI 2.0 or 3.0, also of both; in the order in which they step. Of a
        sequence, the names are those of the models.
    step : float
        Communication step [s].
    steps : mapping of str to float, optional
        Longer steps of some FMUs, multiples of `step` [s]: a sampled controller at 10 ms beside a
        crane at 1 ms. Their outputs are held meanwhile. Not of the first FMU, and not with
        "derivatives", which then is not the default.
    connections : iterable of Connection, optional
        Each (source, output, sink, input). By default outputs are connected to the inputs of the
        same names of the FMUs behind.
    coupling : str, optional
        By default "derivatives" where all connected FMUs have what it needs, else "sequential".
        "sequential": an FMU's step has the outputs of those before it at the end of the step, an
        error of second order in the step; "parallel": those of its beginning, an error of first
        order, or none beside that of "sequential" where a source has a parameter `setpoint.lead` as
        long as the step; "derivatives" (FMI 2.0): those of its beginning and their derivatives, as
        many as the source tells: k of them make an error of order k + 1.
    events : bool
        Steps also end at events: in FMI 3.0 where the first FMU returns early, in FMI 2.0 where an
        output `plan.next_event` says. Steps in parallel that `setpoint.lead` makes up for have to
        be equal, so they end at no events.
    record : mapping of str to sequence of str or None, optional
        Names of FMUs and of their variables, or None; by default, and for None, all scalar outputs.
    kept : collection of str, optional
        Of the columns that `record` makes, those that rows have beside "time"; by default all. What
        is neither kept nor connected is not read, so runs take less time.
    repeatable : collection of str
        Names of FMUs whose outputs follow from their values and the time alone, as a planner's do.
        With the engine "c", and without connected inputs, runs that give them the same values as
        the ones before hear them from a tape: the same rows, sooner.
    engine : str
        "c": the step loop in C, for which the package must have been installed with a compiler;
        "python"; or "auto": C where there is one. Both give the same numbers.

    Attributes
    ----------
    names : tuple of str
        Of the FMUs.
    engine : str
        "c" or "python".
    connections : list of Connection
        All of them.

    Raises
    ------
    InputError
        For invalid values and files.
    SimulationError
        If an FMU cannot be instantiated, with its message.
    """

    def __init__(
        self,
        fmus: Mapping[str, Path] | Sequence[Path],
        *,
        step: float,
        steps: Mapping[str, float] | None = None,
        connections: Iterable[Sequence[str]] | None = None,
        coupling: Coupling | None = None,
        events: bool = True,
        record: Mapping[str, Sequence[str] | None] | None = None,
        kept: Collection[str] | None = None,
        repeatable: Collection[str] = (),
        engine: Engine = "auto",
    ) -> None:
        if coupling is not None:
            _require_one("coupling", coupling, get_args(Coupling))
        step, events = require_step(step), as_flag("events", events)
        self.engine = _engine(engine)
        self._step, self._events = step, events
        self._running = Lock()
        # whether outputs of a source are ahead of time
        self._ahead = False
        # whether instances were made since the loop was prepared
        self._stale = False
        self._units: dict[str, Unit] = {}
        self._paths: dict[str, Path] = {}
        try:
            self._load(fmus)
            given = by_name(self._units) if connections is None else connections
            self.connections = checked(self._units, given)
            kept = None if kept is None else as_names("kept", kept)
            self._recorded = fields(chosen(self._units, record), kept)
            self._observe()
            steps = {} if steps is None else steps
            require_mapping("steps", steps)
            self._require_units({owner: {} for owner in steps})
            self._every = step_counts(self.names, steps, step, coupling)
            if coupling is None:
                derivatives = all(link.has_slopes for link in self._links) and not steps
                coupling = "derivatives" if derivatives else "sequential"
            self._coupling: Coupling = coupling
            self._require_units({owner: {} for owner in as_names("repeatable", repeatable)})
            sinks = {c.sink for c in self.connections}
            self._tape = Tape(set(repeatable) - sinks if self.engine == "c" else ())
            self._loop = self._prepared()
        except BaseException:
            self.close()
            raise

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(self._units)

    def run(
        self,
        values: Mapping[str, Mapping[str, Any]] | None = None,
        *,
        stop_time: float,
        start_time: float = 0.0,
        changes: Iterable[Change] = (),
        progress: Callable[[float], None] = lambda _: None,
    ) -> NDArray[np.void]:
        """Co-simulate once, from reset FMUs; nothing of an earlier run is left.

        Parameters
        ----------
        values : mapping of str to mapping
            By name of FMU: parameters, start values and constant inputs; enumerations by the name
            of an item; arrays of FMI 3.0 after their sizes.
        stop_time, start_time : float
            [s]; the last step is shorter if the step does not divide the time.
        changes : iterable of Change
            New values of inputs and tunable parameters during the run.
        progress : callable
            Called with the share done from time to time.

        Returns
        -------
        ndarray, structured, shape (steps + 1,)
            "time" and the recorded variables, as "fmu.name" where two FMUs have one name; row i
            belongs to time start_time + i * step.

        Raises
        ------
        InputError
            For invalid values; the system can run again.
        SimulationError
            If an FMU reports an error, with its message; the system can run again.
        """
        require_callable("progress", progress)
        values = {} if values is None else values
        self._require_units(values)
        changes = as_tuple("changes", changes)
        times = communication_points(start_time, stop_time, self._step)
        if not self._running.acquire(blocking=False):
            raise InputError("the system is running; make one for each thread")
        try:
            return self._run(values, times, changes, progress)
        except OffTape:
            self._tape.forget()
            return self._run(values, times, changes, progress)
        finally:
            self._running.release()

    def check(
        self,
        values: Mapping[str, Mapping[str, Any]],
        *,
        stop_time: float,
        start_time: float = 0.0,
        changes: Iterable[Change] = (),
    ) -> None:
        """Refuse names, and values outside of the ranges of FMUs, without a run.

        Raises
        ------
        InputError
            For the first one.
        """
        self._require_units(values)
        for owner, own in values.items():
            for name in own:
                known = self._units[owner].variables
                if name not in known:
                    raise InputError(f"{owner} has no variable {name}{meant(name, known)}")
            self._units[owner].require_within(own)
        connected = {(c.sink, c.input) for c in self.connections}
        due(self._units, changes, connected, (start_time, stop_time))

    def _require_units(self, values: Mapping[str, Mapping[str, Any]]) -> None:
        if not self._units:
            raise InputError("the system is closed")
        require_mapping("values", values)
        for owner, own in values.items():
            if owner not in self._units:
                raise InputError(f"no FMU {owner} in the system; it has {', '.join(self.names)}")
            require_mapping(f"values of {owner}", own)

    def close(self) -> None:
        """Free all instances."""
        units, self._units = list(self._units.values()), {}
        _all(unit.close for unit in reversed(units))

    def __enter__(self) -> System:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _load(self, fmus: Mapping[str, Path] | Sequence[Path]) -> None:
        # fmpy is loaded here, so that planning and building do not need it
        from segfmu.cosim.load import load

        if isinstance(fmus, str | Path):
            raise InputError(f"a system takes a mapping or a sequence of files, got {shown(fmus)}")
        named = fmus if isinstance(fmus, Mapping) else dict(enumerate(as_tuple("fmus", fmus)))
        if not named:
            raise InputError("a system needs at least one FMU")
        for key, path in named.items():
            if not isinstance(path, str | Path):
                raise InputError(f"fmus must be paths of files, got {shown(path)}")
            given = key if isinstance(key, str) else None
            unit = load(Path(path), leads=not self._units and self._events, name=given)
            if unit.name in self._units:
                unit.close()
                raise InputError(
                    f"two FMUs are called {unit.name}; give a mapping of names to files"
                )
            self._units[unit.name], self._paths[unit.name] = unit, Path(path)

    def _observe(self) -> None:
        """Let units read what is recorded, connected, or tells of events; make the links."""
        for owner, unit in self._units.items():
            needed = {c.output for c in self.connections if c.source == owner}
            needed |= {NEXT_EVENT} if self._events else set()
            extra = [n for n in self._recorded[owner] if n not in unit.outputs()]
            needed |= set(self._recorded[owner])
            unit.observe([*(n for n in unit.outputs() if n in needed), *extra])
        pairs: dict[tuple[str, str], list[tuple[str, str]]] = {}
        for c in self.connections:
            pairs.setdefault((c.source, c.sink), []).append((c.output, c.input))
        self._links = [
            Link(self._units[source], self._units[sink], names)
            for (source, sink), names in pairs.items()
        ]

    def _prepared(self) -> Loop | native.NativeLoop:
        units = list(self._units.values())
        schedule = scheduled(
            units, self._links, self._coupling, events=self._events, ahead=self._ahead,
            every=self._every,
        )
        recorded = columns(self._units, self._recorded)
        if self.engine == "c":
            return native.NativeLoop(units, schedule, recorded, self._tape)
        return Loop(units, schedule, recorded)

    def _renew(self, ahead: bool) -> None:
        """Reset all units; those that cannot be, and one that may lead no more, are made again."""
        from segfmu.cosim.load import load

        first, turns = self.names[0], ahead is not self._ahead
        self._ahead, self._stale = ahead, self._stale or turns
        for owner, unit in self._units.items():
            if not unit.reset() or (turns and owner == first):
                self._stale = True
                unit.close()
                leads = owner == first and self._events and not ahead
                self._units[owner] = load(self._paths[owner], leads=leads, name=owner)
        if self._stale:
            self._observe()
            self._tape.forget()
            self._loop = self._prepared()
            self._stale = False

    def _run(
        self, values: Mapping[str, Mapping[str, Any]], times: NDArray[np.float64],
        changes: Iterable[Change], progress: Callable[[float], None],
    ) -> NDArray[np.void]:
        sinks = {c.sink for c in self.connections}
        leading = {n for n in self.names if n not in sinks and values.get(n, {}).get(LEAD)}
        ahead = bool(leading) and self._coupling == "parallel"
        self._renew(ahead)
        start, stop = float(times[0]), float(times[-1])
        connected = {(c.sink, c.input) for c in self.connections}
        pending = due(self._units, changes, connected, (start, stop))
        units = list(self._units.values())
        self._tape.begin(self._units, values, pending, (start, stop, len(times), ahead))
        silent = [unit for unit in units if self._tape.silent(unit)]
        try:
            for owner, unit in self._units.items():
                if unit not in silent:
                    unit.set(values.get(owner, {}))
            for unit in units:
                if unit not in silent:
                    unit.enter_initialization(start, stop)
            with self._tape.beginning(units):
                initialise(units, self._links, [self._units[n] for n in leading], silent)
            rows = self._loop.run(times, pending, progress)
        except BaseException:
            with suppress(SimulationError):
                _all(unit.finish for unit in reversed(units))
            raise
        _all(unit.finish for unit in reversed(units))
        progress(1.0)
        return rows


def _all(calls: Iterable[Callable[[], None]]) -> None:
    """Make all calls; then raise the first error."""
    errors = []
    for call in calls:
        try:
            call()
        except Exception as error:
            errors.append(error)
    if errors:
        raise errors[0]


def _require_one(name: str, given: Any, allowed: tuple[str, ...]) -> None:
    if not (isinstance(given, str) and given in allowed):
        raise InputError(f"{name} must be {' or '.join(allowed)}, got {shown(given)}")


def _engine(wanted: Engine) -> Engine:
    _require_one("engine", wanted, get_args(Engine))
    if wanted == "c" and not native.COMPILED:
        raise InputError(
            "the step loop in C was not compiled when segfmu was installed, or is turned off by "
            "SEGFMU_INTERPRETED; take engine python"
        )
    if wanted == "auto":
        return "c" if native.COMPILED else "python"
    return wanted
