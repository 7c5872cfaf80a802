"""Many co-simulated runs of the paper's mission: engines side by side, one process and two.

4.5 s in steps of 1 ms, all outputs, native FMUs; every run has start values of its own. "Loaded for
each run" is `simulate`, as it was before systems kept their instances.
"""

from __future__ import annotations

import multiprocessing
import time
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from benchmarks.report import Part, Record, Section, Settings
from segfmu.cosim import System, native, simulate
from segfmu.cosim.schedule import Coupling
from segfmu.cosim.system import Engine
from segfmu.errors import BuildError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native.archive import build_all

STEP, STOP = 1e-3, 4.5
CRANE = "GantryCrane"
TITLE = "many runs: the paper's mission, 4.5 s in steps of 1 ms, all outputs"
LOADED, KEPT = "loaded for each run", "kept"


@dataclass(frozen=True)
class Job:
    """Runs of one process."""

    paths: tuple[Path, Path]
    coupling: Coupling
    engine: Engine
    way: str
    runs: int


@dataclass(frozen=True)
class Found:
    """Seconds of the clock and of the processor, kB after a tenth of the runs and at the end."""

    clock: float
    processor: float
    memory: tuple[int, int]


def measure(settings: Settings) -> Part:
    """Runs a second of each engine, and of two processes."""
    sections = []
    for fmi in (2, 3):
        specs = (gantry_feedforward.native_spec(), gantry_crane.native_spec())
        try:
            paths = build_all(specs, settings.folder / f"runs{fmi}", fmi=fmi)
        except BuildError as problem:
            return Part(TITLE, (), (f"not measured: {problem}",))
        couplings: tuple[Coupling, ...] = ("sequential", "parallel", "derivatives")
        for coupling in couplings[: 3 if fmi == 2 else 1]:
            records = _records((paths[0], paths[1]), coupling, 2 * settings.samples)
            sections.append(Section(f"FMI {fmi}, {coupling}", records))
        if native.COMPILED:
            long = Job((paths[0], paths[1]), "sequential", "c", KEPT, settings.problems)
            record = _record(long, 1, settings.problems, _side_by_side([long]))
            sections.append(Section(f"FMI {fmi}, sequential, one system all along", [record]))
    return Part(TITLE, sections, (
        "ratio: runs per second of the processor over those of the first row",
        "more memory: of the process, from a tenth of the runs to the last one",
    ))


def _records(paths: tuple[Path, Path], coupling: Coupling, runs: int) -> list[Record]:
    few = max(2, runs // 50)
    jobs: list[tuple[str, Engine, int]] = [(LOADED, "python", few), (KEPT, "python", few)]
    if native.COMPILED:
        jobs += [(LOADED, "c", few), (KEPT, "c", runs)]
    records = []
    for way, engine, count in jobs:
        job = Job(paths, coupling, engine, way, count)
        records.append(_record(job, 1, count, _side_by_side([job])))
    half = replace(job, runs=job.runs // 2)
    records.append(_record(half, 2, 2 * half.runs, _side_by_side([half, half])))
    reference = float(records[0]["runs/s of processor"] or 0.0)
    return [r | {"ratio": float(r["runs/s of processor"] or 0.0) / reference} for r in records]


def _record(job: Job, processes: int, runs: int, found: list[Found]) -> Record:
    return {
        "instances": job.way, "engine": job.engine, "processes": processes, "runs": runs,
        "runs/s": runs / max(f.clock for f in found),
        "runs/s of processor": runs / sum(f.processor for f in found),
        "more memory kB": max(f.memory[1] - f.memory[0] for f in found),
    }


def _side_by_side(jobs: list[Job]) -> list[Found]:
    """Each job in a new process, which waits until all have loaded."""
    context = multiprocessing.get_context("spawn")
    with context.Manager() as manager:
        ready = manager.Barrier(len(jobs))
        with context.Pool(len(jobs)) as pool:
            return pool.starmap(_work, [(job, ready) for job in jobs], chunksize=1)


def _work(job: Job, ready: object) -> Found:
    sways = np.random.default_rng(1).uniform(-0.1, 0.1, job.runs)
    with System(job.paths, step=STEP, coupling=job.coupling, engine=job.engine) as system:
        system.run(stop_time=0.1)
        ready.wait()  # type: ignore[attr-defined]
        clock, processor = time.perf_counter(), time.process_time()
        early = 0
        for i, sway in enumerate(sways.tolist()):
            values = {"sway.x.angle": sway}
            if job.way == KEPT:
                system.run({CRANE: values}, stop_time=STOP)
            else:
                simulate(*job.paths, stop_time=STOP, step=STEP, coupling=job.coupling,
                                engine=job.engine, sink_values=values)
            if i == job.runs // 10:
                early = _memory()
        return Found(
            time.perf_counter() - clock, time.process_time() - processor, (early, _memory())
        )


def _memory() -> int:
    """Largest memory of this process so far [kB]; 0 where the system does not tell."""
    try:
        import resource
    except ImportError:
        return 0
    return int(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
