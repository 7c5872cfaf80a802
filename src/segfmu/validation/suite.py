"""Scenarios as co-simulations of the FMUs that a user ships, and their verdicts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from segfmu.cosim import Change, System, profile
from segfmu.cosim.points import communication_points
from segfmu.errors import BuildError, InputError, SegfmuError
from segfmu.planning import Trajectory
from segfmu.validation.baselines.course import Course
from segfmu.validation.baselines.course import changes as inputs
from segfmu.validation.baselines.methods import course, position_gains
from segfmu.validation.files.crane_parameters import models
from segfmu.validation.files.mission import DISTURBED, Mission
from segfmu.validation.files.scenario_file import Scenario
from segfmu.validation.files.scenario_tables import CRANE, moment, moments
from segfmu.validation.kept import Kept
from segfmu.validation.monitor import Finding, Signals, judge, variables
from segfmu.validation.pairs import Pairs, with_arrays, without_starts
from segfmu.validation.planned import require_memory
from segfmu.validation.scenario import (
    AT_BUILD,
    crane_values,
    ending,
    feedforward_values,
)
from segfmu.validation.scenario_result import Result, Rows

LEAD, ENABLED = "setpoint.lead", "command.enabled"
# control of positions knows no disturbances
NO_REJECTION = {
    "feedback.design": "lqr", "feedback.rejection.carriage": 0.0, "feedback.rejection.load": 0.0,
}
# loaded FMUs take some 10 MB, inputs at all communication steps some MB, plans next to nothing
MOST_SYSTEMS, MOST_TOLD, MOST_PLANS = 4, 8, 256
# keys of a mission that its plan does not depend on
UNPLANNED: dict[str, Any] = {
    "name": True, "true_crane": True, "simulation": True,
    "crane": {"name", "drive", "travel", "sensors", "load", "controller", "wind"},
}


class Runner:
    """Runs scenarios; keeps the FMUs, and plans of the missions that were run last.

    A context manager that frees the FMUs and removes their archives.

    Parameters
    ----------
    rows : bool
        Whether results have rows. Without, only what the criteria read is recorded, in less time.
    """

    def __init__(self, rows: bool = True) -> None:
        self._has_rows = rows
        self._pairs = Pairs()
        self._systems: Kept[System] = Kept(MOST_SYSTEMS, System.close)
        self._plans: Kept[Trajectory] = Kept(MOST_PLANS)
        self._courses: Kept[Course] = Kept(MOST_PLANS)
        self._sources: Kept[dict[str, Any]] = Kept(MOST_PLANS)
        self._told: Kept[list[Change]] = Kept(MOST_TOLD)

    def __enter__(self) -> Runner:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Free everything."""
        self._systems.clear()
        self._plans.clear()
        self._courses.clear()
        self._sources.clear()
        self._told.clear()
        self._pairs.close()

    def run(self, scenario: Scenario) -> Result:
        """Run a scenario and judge it; a run that an FMU stops is a result with an error.

        Raises
        ------
        InputError
            For variables and values that the FMUs do not have or take.
        BuildError
            If the FMUs cannot be built.
        """
        found = Result(scenario, {})
        try:
            trajectory = self._plan(scenario.mission)
            known = self._known(scenario, trajectory)
            found = replace(found, known=known)
            rows = self._rows(scenario, trajectory, known)
            findings = tuple(self._findings(scenario, trajectory, known, rows))
            return replace(found, rows=rows if self._has_rows else None, findings=findings)
        except InputError as error:
            raise InputError(f"{scenario.path}: {error}") from None
        except BuildError:
            raise
        except SegfmuError as error:
            return replace(found, error=str(error))

    def check(self, scenario: Scenario) -> None:
        """Refuse variables that the FMUs do not have, without a run.

        Raises
        ------
        InputError
            For the first one.
        BuildError
            If the FMUs cannot be built.
        """
        try:
            trajectory = self._plan(scenario.mission)
            known = self._known(scenario, trajectory)
            values = self._values(scenario, trajectory)
            changes = self._changes(scenario, known)
            self._system(scenario, trajectory).check(
                values, stop_time=known["end"], changes=changes
            )
        except (InputError, BuildError):
            raise
        except SegfmuError:
            # there is no plan: an outcome, not a wrong name
            return

    def _plan(self, mission: Mission) -> Trajectory:
        return self._plans.get(mission.model_dump_json(exclude=UNPLANNED), mission.plan)

    def _known(self, scenario: Scenario, trajectory: Trajectory) -> dict[str, float]:
        """Times of "start", "arrival" and "end" [s]."""
        mission, own = scenario.mission, self._course(scenario)
        end = ending(mission, trajectory)
        if own is not None:
            end = own.duration + max(own.dead_time)
        end = max(end, *(r.end for r in scenario.recordings if r is not None), 0.0)
        require_memory(mission, end)
        return {"start": 0.0, "arrival": end, "end": end + mission.simulation.settle}

    def _course(self, scenario: Scenario) -> Course | None:
        """The course of a method without a plan."""
        method, mission = scenario.file.method, scenario.mission
        if method == "feedforward":
            return None
        return self._courses.get(_course_key(scenario), lambda: course(mission, method))

    def _inputs(self, scenario: Scenario, own: Course, end: float) -> list[Change]:
        """What a course tells the crane at every communication step."""
        times = communication_points(0.0, end, scenario.mission.simulation.step)
        crane = models(scenario.mission.crane).crane
        return self._told.get((*_course_key(scenario), end), lambda: inputs(own, crane, times))

    def _changes(self, scenario: Scenario, known: Mapping[str, float]) -> list[Change]:
        file, own = scenario.file, self._course(scenario)
        found: list[Change] = []
        if own is not None:
            found += self._inputs(scenario, own, known["end"])
        found += [Change(moment(e.time, known), e.fmu, e.values) for e in file.events]
        for p, recording in zip(file.profiles, scenario.recordings, strict=True):
            if recording is not None:
                owners = self._interfaces(scenario)
                if p.fmu is not None:
                    owners = {p.fmu: tuple(recording.columns)}
                found += recording.changes(owners)
            elif p.variable is not None:
                instants = moments(p.times, known)
                found += profile(p.fmu or CRANE, p.variable, instants, p.values)
        return found

    def _interfaces(self, scenario: Scenario) -> dict[str, tuple[str, ...]]:
        """Names of the variables of both FMUs."""
        mission, fmi = scenario.mission, scenario.file.fmi
        pair = self._pairs.get(mission, self._plan(mission), fmi)
        return {spec.name: tuple(spec.references) for spec in pair.interfaces}

    def _findings(
        self, scenario: Scenario, trajectory: Trajectory, known: Mapping[str, float], rows: Rows
    ) -> Iterator[Finding]:
        """Judge all criteria; runs that bounds are relative to are made once."""
        own, nominal = Signals(rows), dict[str, Signals]()
        others = {"without feedback": _without_feedback, "undisturbed": _undisturbed}
        for criterion in scenario.file.criteria:
            key = criterion.against
            if key is not None and key not in nominal:
                nominal[key] = Signals(self._rows(others[key](scenario), trajectory, known))
            crane = scenario.mission.simulated
            try:
                yield judge(criterion, own, known, crane, scenario.units, nominal.get(key or ""))
            except InputError as error:
                raise InputError(f"criterion {criterion.name}: {error}") from None

    def _rows(
        self, scenario: Scenario, trajectory: Trajectory, known: Mapping[str, float]
    ) -> Rows:
        system, end = self._system(scenario, trajectory), known["end"]
        # an FMU that refuses a value would make this an outcome of the run
        for own in (scenario.file.parameters, {f.name: f.values for f in scenario.file.fmus}):
            system.check(own, stop_time=end)
        return system.run(
            self._values(scenario, trajectory), stop_time=end,
            changes=self._changes(scenario, known),
        )

    def _values(self, scenario: Scenario, trajectory: Trajectory) -> dict[str, dict[str, Any]]:
        """Parameters and start values of all FMUs."""
        file, mission = scenario.file, scenario.mission
        lead = {LEAD: mission.simulation.step} if file.lead else {}
        known = mission.model_dump_json(exclude=DISTURBED)
        changed, sink, gains = self._pairs.values(mission, trajectory, file.fmi, known)
        interfaces = self._pairs.get(mission, trajectory, file.fmi).interfaces
        passed = with_arrays if file.fmi == 3 else without_starts
        source = self._sources.get((known, file.fmi), lambda: passed(
            interfaces[0], changed | feedforward_values(mission, trajectory)
        ))
        # weights are those of the build
        sink = sink | {
            n: v for n, v in crane_values(mission).items() if not n.startswith(AT_BUILD)
        }
        if file.method == "pd":
            driven = sink["drive.mode"] == "velocity"
            sink |= NO_REJECTION | position_gains(mission, driven, gains)
        sink = passed(interfaces[1], sink)
        own = models(mission.crane)
        values: dict[str, dict[str, Any]] = {
            own.feedforward: source | lead, own.crane: sink | lead,
            **{unit.name: dict(unit.values) for unit in file.fmus},
        }
        if any(r is not None and r.commands for r in scenario.recordings):
            values[own.feedforward][ENABLED] = True
        if file.method != "feedforward":
            del values[own.feedforward]
        for fmu, given in file.parameters.items():
            values[fmu] = values.get(fmu, {}) | given
        return values

    def _system(self, scenario: Scenario, trajectory: Trajectory) -> System:
        file, step = scenario.file, scenario.mission.simulation.step
        pair = self._pairs.get(scenario.mission, trajectory, file.fmi)
        both = models(scenario.mission.crane)
        archives = pair.paths
        others = {unit.name: Path(unit.path) for unit in file.fmus}
        steps = {unit.name: unit.step for unit in file.fmus if unit.step is not None}
        for name in others:
            if name in both.names:
                raise InputError(f"fmus: {name} is the name of one of the two FMUs")
        links = [tuple(link) for unit in file.fmus for link in unit.connections]
        planned = file.method == "feedforward"
        read = variables(file.criteria, scenario.mission.simulated)
        kept = None if self._has_rows else tuple(sorted(read))

        def make() -> System:
            taken = {link[2:] for link in links}
            own = [
                (both.feedforward, name, both.crane, name) for name in both.shared
                if planned and (both.crane, name) not in taken
            ]
            first = {both.feedforward: archives[0]} if planned else {}
            outputs = [v.name for v in pair.interfaces[1].where("output")]
            # of the crane alone: what it follows is among the rows too
            alone = {**dict.fromkeys(others), both.crane: [*outputs, *both.shared]}
            return System(
                {**first, **others, both.crane: archives[1]}, step=step, steps=steps,
                record=None if planned else alone, kept=kept, coupling=file.coupling,
                connections=[*own, *links], repeatable=first,
            )

        key = (
            planned, kept, *archives, step, *steps.items(), file.coupling, *others.items(), *links
        )
        return self._systems.get(key, make)


def _course_key(scenario: Scenario) -> tuple[str, str]:
    """The method, and the mission as far as it is known to it."""
    mission = scenario.mission
    return scenario.file.method, mission.model_dump_json(exclude={"name", "true_crane"})


def _without_feedback(scenario: Scenario) -> Scenario:
    simulation = scenario.mission.simulation.model_copy(update={"feedback": False})
    return replace(scenario, mission=scenario.mission.model_copy(
        update={"simulation": simulation}
    ))


def _undisturbed(scenario: Scenario) -> Scenario:
    """The nominal crane, from rest, without events."""
    simulation = scenario.mission.simulation.model_copy(update={"initial_sway": [0.0, 0.0]})
    return replace(
        scenario,
        file=scenario.file.model_copy(update={"events": [], "profiles": [], "parameters": {}}),
        recordings=(),
        mission=scenario.mission.model_copy(
            update={"true_crane": None, "simulation": simulation}
        ),
    )
