"""`segfmu.build`: the archives of both FMUs."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial
from html import escape
from pathlib import Path

from segfmu.arrays import as_flag, as_index, require_callable, shown
from segfmu.errors import InputError
from segfmu.fmu.build import build_all, describe, left_over
from segfmu.fmu.choice import Choice, chosen, require_native
from segfmu.fmu.feedforward.interface import MOST_WAYPOINTS
from segfmu.fmu.gantry_crane.pair import GANTRY
from segfmu.fmu.placing import placing
from segfmu.fmu.standard.spec import Spec
from segfmu.folders import work_folder
from segfmu.planning import Trajectory
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.crane_models import require_gantry
from segfmu.validation.files.crane_parameters import with_keys
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import Source, load_mission
from segfmu.validation.output import about, folder, require_folder
from segfmu.validation.planned import planned
from segfmu.validation.progress import Progress, quiet
from segfmu.validation.scenario import sized, specs


@dataclass(frozen=True, repr=False)
class Archives:
    """What `build` wrote; iterates over the files.

    Attributes
    ----------
    feedforward, crane : Path
        GantryFeedforward.fmu and GantryCrane.fmu, with a hook HookFeedforward.fmu and
        HookCrane.fmu.
    others : tuple of Path
        Files for other tools, such as mission.ssp.
    note : str
        What the user must know of the choice of the backend, and of files of a build before that
        lie beside the FMUs; empty if nothing.
    """

    feedforward: Path
    crane: Path
    others: tuple[Path, ...] = ()
    note: str = ""

    def __iter__(self) -> Iterator[Path]:
        return iter((self.feedforward, self.crane, *self.others))

    def __repr__(self) -> str:
        return f"<Archives in {self.crane.parent}: {', '.join(path.name for path in self)}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{escape(str(path))}</td><td>{path.stat().st_size / 1024:.0f} KiB</td></tr>"
            for path in self if path.is_file()
        )
        return f"<table>{rows}</table>"


def build(
    mission: Source | None = None,
    output: str | Path = "fmus",
    *,
    fmi: int = 2,
    backend: str = "native",
    platforms: str | None = None,
    waypoints: int | None = None,
    enumerations: str = "enumeration",
    commands: str = "parameters",
    modelica: bool = False,
    ssp: bool = False,
    references: bool = False,
    progress: Progress = quiet,
) -> Archives:
    """Build GantryFeedforward.fmu and GantryCrane.fmu, with a hook HookFeedforward and HookCrane.

    Native FMUs support co-simulation and model exchange; those of the Python backend support FMI
    2.0 co-simulation.

    Parameters
    ----------
    mission : path, mapping or Mission, optional
        As of `load_mission`; its values are the FMUs' start values.
    output : path
        Folder for the archives.
    fmi : int
        Version of the standard, 2 or 3.
    backend : str
        "native": C, with its sources; "python": needs segfmu where the FMU runs.
    platforms : str, optional
        Of native binaries: "all", or names with commas; by default those that are available.
    waypoints : int, optional
        Maximum number of waypoints; 16 by default, or that of the mission.
    enumerations : str
        Type of choices: "enumeration", or "integer" for importers without.
    commands : str
        What an operator commands: "parameters", tunable, or "inputs", to be connected.
    modelica, ssp : bool
        Whether to write a Modelica package with both FMUs, and the coupled system for importers of
        SSP (1.0; 2.0 with FMI 3) and, with FMI 2, for libcosim.
    references : bool
        Whether both archives get an experiment with its results, and the verdict on the mission,
        after FMI-LS-REF, with which `segfmu compare` and other tools check what they import. The
        FMUs run on this machine for it.
    progress : callable
        Called with what is being done and the share of it that is done.

    Returns
    -------
    Archives

    Raises
    ------
    InputError
        For a mission or an option that is not possible.
    InfeasibleError
        If the mission cannot be planned.
    BuildError
        If a file cannot be written or a compiler fails.
    SimulationError
        If an FMU that is to have references reports an error.

    Examples
    --------
    >>> import segfmu
    >>> archives = segfmu.build("mission.toml", "fmus")
    >>> archives.crane.name
    'GantryCrane.fmu'
    """
    require_callable("progress", progress)
    if not isinstance(platforms, str | None):
        raise InputError(f"platforms must be all, or names with commas, got {shown(platforms)}")
    if platforms is not None and not platforms.strip(", "):
        raise InputError("platforms is empty; name some, or all, or omit it for those available")
    flags = {"modelica": modelica, "ssp": ssp, "references": references}
    for name, value in flags.items():
        as_flag(name, value)
    choice = chosen(
        as_index("fmi", fmi), backend, platforms or "", enumerations=enumerations,
        commands=commands,
    )
    if waypoints is not None:
        waypoints = as_index("waypoints", waypoints, MOST_WAYPOINTS, least=2)
    if modelica:
        require_native(choice, "modelica", (2,))
    if ssp:
        require_native(choice, "ssp")
    task = None if mission is None else load_mission(mission)
    if references and task is None:
        raise InputError("references are results of a mission; name its file")
    if task is not None:
        with about(task.file):
            _require_options(task, choice)
    models = GANTRY if task is None else crane_parameters.models(task.crane)
    title, interfaces, file, complete = "", sized(waypoints, models), None, None
    require_folder(output, *(f"{name}.fmu" for name in models.names))
    if task is not None:
        file = task.file
        with about(file):
            trajectory = planned(task, progress)
            title, interfaces = task.name, specs(task, trajectory, waypoints)
        complete = partial(_record, task, trajectory, progress) if references else None
    target = folder(output)
    with with_keys(file):
        feedforward, crane = written(target, choice, interfaces, progress, complete)
    others = describe(
        target, (feedforward, crane), interfaces, title, fmi=choice.fmi, modelica=modelica, ssp=ssp
    )
    return Archives(feedforward, crane, tuple(others), _note(choice, target, others))


def _require_options(task: Mission, choice: Choice) -> None:
    """Refuse what the FMUs of further models do not have."""
    if choice.connected:
        require_gantry(task.build_crane(), "commands")


def for_simulation(
    task: Mission, trajectory: Trajectory, target: Path, progress: Progress
) -> Archives:
    """FMUs for this machine with a mission's values."""
    choice = chosen(2, "native", "", everywhere=False)
    with with_keys(task.file):
        paths = written(target, choice, specs(task, trajectory), progress)
    return Archives(*paths, note=_note(choice, target, ()))


def _note(choice: Choice, target: Path, others: Sequence[Path]) -> str:
    return "; ".join(filter(None, (choice.note, left_over(target, others))))


def written(
    target: Path, choice: Choice, interfaces: Sequence[Spec], progress: Progress,
    complete: Callable[[Sequence[Path]], None] | None = None,
) -> tuple[Path, Path]:
    """Build FMUs of both interfaces; `complete` adds to their archives before they are there."""
    with ExitStack() as stack:
        place = stack.enter_context(work_folder(target)) if complete else target
        paths = build_all(place, choice, interfaces, report=lambda line: progress(line, 0.0))
        if complete:
            complete(paths)
            named = [target / path.name for path in paths]
            with placing(named) as work:
                for path in paths:
                    os.replace(path, work / path.name)
            paths = named
    feedforward, crane = paths
    return feedforward, crane


def _record(
    task: Mission, trajectory: Trajectory, progress: Progress, archives: Sequence[Path]
) -> None:
    # it runs what this module builds
    from segfmu.validation.references.record import record

    record(task, trajectory, archives, progress)
