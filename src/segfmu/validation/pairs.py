"""The archives of both FMUs, built once for many missions, and their parameters for each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from segfmu.fmu.build import build_all
from segfmu.fmu.choice import chosen
from segfmu.fmu.feedforward.interface import WAYPOINTS
from segfmu.fmu.pairs import native
from segfmu.fmu.standard.spec import Spec
from segfmu.folders import make_folder, remove_folder
from segfmu.planning import Trajectory
from segfmu.validation.files.crane_parameters import models, with_keys
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_tables import SimulationEntry
from segfmu.validation.kept import Kept
from segfmu.validation.scenario import specs

# of start values: a mission has those of some kB
MOST_STARTS = 64
TABLE = "feedback.table"
# parameters of planner and crane, and gains
Starts = tuple[dict[str, Any], dict[str, Any], dict[str, Any]]


@dataclass(frozen=True)
class Pair:
    """Archives of both FMUs, and their interfaces."""

    paths: tuple[Path, Path]
    interfaces: tuple[Spec, Spec]


class Pairs:
    """Builds both FMUs in a temporary folder, for the first mission that comes.

    Later missions differ in parameters alone, among them the gains for their nominal crane, so a
    run has the numbers that it has with archives of its own.
    """

    def __init__(self) -> None:
        self._folder = make_folder()
        self._pairs: dict[tuple[str, int, int], Pair] = {}
        self._starts: Kept[Starts] = Kept(MOST_STARTS)

    def close(self) -> None:
        """Remove the archives."""
        self._pairs.clear()
        self._starts.clear()
        remove_folder(self._folder)

    def get(self, mission: Mission, trajectory: Trajectory, fmi: int) -> Pair:
        """The archives of a version of FMI with room for a mission's waypoints.

        Raises
        ------
        BuildError
            If they cannot be built.
        """
        planner = models(mission.crane).feedforward
        key = planner, fmi, max(len(mission.waypoints), WAYPOINTS)
        if key not in self._pairs:
            folder = self._folder / "_".join(map(str, key))
            interfaces = specs(_planned(mission), trajectory)
            with with_keys():
                choice = chosen(fmi, "native", "", everywhere=False)
                paths = build_all(folder, choice, interfaces, whole=False)
            self._pairs[key] = Pair((paths[0], paths[1]), _native(interfaces))
        return self._pairs[key]

    def values(
        self, mission: Mission, trajectory: Trajectory, fmi: int, known: str
    ) -> Starts:
        """Parameters of both FMUs whose start values differ from their archives', and all gains.

        known : all that planner and design know of the mission, beside the mode of the drives.
        """
        pair = self.get(mission, trajectory, fmi)

        def make() -> Starts:
            own = _native(specs(_planned(mission), trajectory))
            first, second = map(_differences, pair.interfaces, own)
            return first, second, _table(own[1])

        return self._starts.get((id(pair), known, mission.simulation.drive), make)


def _planned(mission: Mission) -> Mission:
    """The nominal mission: what a scenario disturbs is unknown to the design of the FMUs."""
    return mission.model_copy(update={
        "true_crane": None, "simulation": SimulationEntry(drive=mission.simulation.drive),
    })


def _native(interfaces: Sequence[Spec]) -> tuple[Spec, Spec]:
    with with_keys():
        return native(interfaces)


def _differences(old: Spec, new: Spec) -> dict[str, Any]:
    """Start values of parameters that differ; of the table of gains all, if one does."""
    before = old.starts
    found = {v.name: v.start for v in new.where("parameter") if v.start != before[v.name]}
    if any(name.startswith(TABLE) for name in found):
        found |= _table(new)
    return found


def _table(interface: Spec) -> dict[str, Any]:
    """The table of gains."""
    return {v.name: v.start for v in interface.where("parameter") if v.name.startswith(TABLE)}


def without_starts(interface: Spec, values: Mapping[str, Any]) -> dict[str, Any]:
    """Values without those that the archive starts with: an FMU that is reset has them."""
    starts = interface.starts
    return {n: value for n, value in values.items() if value != starts.get(n)}


def with_arrays(interface: Spec, values: Mapping[str, Any]) -> dict[str, Any]:
    """Values by the names of FMI 3.0: the counts of rows, then the rows in use as arrays.

    What is not given among them is that of the archive's start values.
    """
    whole = {**interface.starts, **values}
    members = {m for a in interface.arrays for m in a.members}
    found = {n: v for n, v in values.items() if n not in members}
    for array in interface.arrays:
        if not values.keys().isdisjoint({array.rows, *array.members}):
            used = array.columns * int(whole[array.rows])
            found[array.name] = [whole[m] for m in array.members[:used]]
    return found
