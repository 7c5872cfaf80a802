"""Puts references into the FMUs of a mission: an experiment of each alone, and the verdict."""

from __future__ import annotations

import io
import os
import zipfile
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim import System
from segfmu.cosim.alone import run_alone
from segfmu.fmu.native.archive import DATE
from segfmu.fmu.standard.ls_ref import (
    EXPERIMENTS,
    FOLDER,
    JSON,
    MANIFEST,
    NOTES,
    TABLE,
    Experiment,
    File,
    Related,
    experiments,
    manifest,
)
from segfmu.planning import Trajectory
from segfmu.validation.criteria import judge
from segfmu.validation.documents.document import text
from segfmu.validation.documents.run import run_document
from segfmu.validation.files.mission import Mission
from segfmu.validation.output import stride, thinned
from segfmu.validation.planned import require_memory
from segfmu.validation.progress import Progress
from segfmu.validation.runs import Run
from segfmu.validation.scenario import ending

# digits of tables that importers can repeat: more would double the archive
DIGITS = "%.10g"
ABOUT = """This FMU has references after FMI-LS-REF ({folder}):

experiments.exp  experiment "{title}": {stop:.6g} s in steps of {step:.6g} s, with the FMU's start
                 values{inputs}
results.csv      its results: outputs at the end of each step, before the inputs of the next one
verdict.json     planner and crane connected, judged by segfmu {version}: {verdict}

With segfmu installed, segfmu compare {name}.fmu repeats the experiment and compares the results.
Any importer can: inputs are linear between the rows of stimuli.csv, and are set before each step.
Numbers differ by rounding alone, 1e-6 of a signal's greatest value or less.
"""


def record(
    task: Mission, trajectory: Trajectory, archives: Sequence[Path], progress: Progress
) -> None:
    """Add references to the archives of planner and crane, which have the mission's start values.

    Raises
    ------
    InputError
        If they cannot be loaded on this machine.
    SimulationError
        If one of them reports an error.
    """
    settings = task.simulation
    stop, step = ending(task, trajectory) + settings.settle, settings.step
    require_memory(task, trajectory.duration)
    with System(archives, step=step) as system:
        rows = system.run(stop_time=stop, progress=lambda share: progress("co-simulating", share))
        connections = list(system.connections)
    criteria = judge(
        rows, ending(task, trajectory), settings.tracking_tolerance, settings.sway_tolerance,
        task.build_bounds(),
    )
    run = Run(task, trajectory, rows, criteria)
    every = stride(task, stop)
    planner, crane = archives
    fed = {c.input: c.output for c in connections if c.sink == crane.stem}
    stimuli = {"time": rows["time"], **{name: rows[output] for name, output in fed.items()}}
    for path, given in ((planner, {}), (crane, stimuli)):
        progress(f"references of {path.name}", 0.0)
        _add(path, _entries(path, run, given, stop, every))


def _entries(
    path: Path, run: Run, stimuli: dict[str, NDArray[np.float64]], stop: float, every: int
) -> dict[str, bytes]:
    """Files of an archive's references by their names."""
    step, title = run.mission.simulation.step, run.mission.name or "mission"
    own = {"stimuli.csv": _csv(stimuli)} if stimuli else {}
    # what is in the table is what the experiment gets
    given = {n: np.array([float(DIGITS % v) for v in c]) for n, c in stimuli.items()}
    rows = thinned(run_alone(path, stop_time=stop, step=step, stimuli=given), every)
    own["results.csv"] = _csv({name: rows[name] for name in rows.dtype.names or ()})
    own["verdict.json"] = text(run_document(run, [])).encode()
    own["experiments.exp"] = experiments(title, [Experiment(
        title, 0.0, stop, step, stimuli=File("stimuli.csv", TABLE) if stimuli else None,
        references=File("results.csv", TABLE),
    )])
    verdict = "passed" if run.passed else "failed"
    listed = [
        Related("experiments.exp", "experiment/smoke-test", EXPERIMENTS, title),
        Related("results.csv", "result", TABLE, f"results of the experiment {title}"),
        Related("verdict.json", "report", JSON, f"planner and crane, judged: {verdict}"),
    ]
    if stimuli:
        listed.append(Related("stimuli.csv", "other", TABLE, "inputs of the experiment"))
    notes = ABOUT.format(
        folder=FOLDER, title=title, stop=stop, step=step, version=version("segfmu"),
        inputs=" and the inputs of stimuli.csv" if stimuli else "", verdict=verdict,
        name=path.stem,
    )
    found = {f"{FOLDER}/{name}": content for name, content in own.items()}
    return {MANIFEST: manifest(listed), NOTES: notes.encode(), **found}


def _csv(columns: dict[str, NDArray[np.float64]]) -> bytes:
    """A table whose header has names alone, as importers read inputs."""
    written = io.StringIO()
    header = ",".join(f'"{name}"' for name in columns)
    table = np.column_stack([c.astype(np.float64) for c in columns.values()])
    np.savetxt(written, table, fmt=DIGITS, delimiter=",", comments="", header=header)
    return written.getvalue().encode()


def _add(path: Path, entries: dict[str, bytes]) -> None:
    """Add files to an archive, which appears when it is complete."""
    part = path.with_name(f"{path.name}.part")
    with zipfile.ZipFile(path) as old, zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED) as new:
        for info in old.infolist():
            new.writestr(info, old.read(info))
        for name in sorted(entries):
            info = zipfile.ZipInfo(name, DATE)  # type: ignore[arg-type]
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            new.writestr(info, entries[name])
    os.replace(part, path)
