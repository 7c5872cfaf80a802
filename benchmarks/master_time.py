"""CPU time of the co-simulation master beside a plain loop on fmpy's methods.

The paper's mission in steps of 1 ms, loading of both FMUs included. The plain loop couples
sequentially, gets and sets lists, and writes a result value by value, as examples of fmpy do; its
rows are those of the master without events.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.report import Part, Section, Settings
from benchmarks.timing import ratios
from segfmu.cosim import native as native_loop
from segfmu.cosim import simulate
from segfmu.cosim.load import load
from segfmu.cosim.unit import Unit
from segfmu.errors import BuildError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.scenario import specs

MISSION = Path(__file__).parents[1] / "models" / "paper.toml"
STEP = 1e-3
TITLE = "co-simulation master: the paper's mission in steps of 1 ms, CPU time"
PLAIN = "plain loop, sequential"
# a type's name in the functions of fmpy
GROUPS = {"Enumeration": {"2.0": "Integer", "3.0": "Int64"}}
# options of the master's runs; FMI 3.0 has no derivatives of inputs
COUPLINGS: dict[str, dict[str, Any]] = {
    "default": {},
    "sequential, no events": {"coupling": "sequential", "events": False},
    "parallel, no events": {"coupling": "parallel", "events": False},
}
ENGINES = ("python", "c") if native_loop.COMPILED else ("python",)
RUNS: dict[str, dict[str, Any]] = {
    f"{name}, {engine}": {"engine": engine, **options}
    for name, options in COUPLINGS.items() for engine in ENGINES
}

Rows = NDArray[np.void]


def measure(settings: Settings) -> Part:
    """Milliseconds of a run, and their ratio over the plain loop's in the same pass."""
    task = load_mission(MISSION)
    trajectory = task.plan()
    stop = trajectory.duration + task.simulation.settle
    sections = []
    for fmi in (2, 3):
        source, sink = specs(task, trajectory)
        try:
            paths = native.build_all(
                (gantry_feedforward.native_spec(source), gantry_crane.native_spec(sink)),
                settings.folder / f"master{fmi}", fmi=fmi,
            )
        except BuildError as problem:
            return Part(TITLE, (), (f"not measured: {problem}",))
        sections.append(_section(fmi, (paths[0], paths[1]), stop, settings.repetitions))
    return Part(TITLE, sections, (
        f"median, least and largest of {settings.repetitions} passes; ratio: CPU time over the "
        "plain loop's in the same pass",
        "plain loop: fmpy's methods with lists, a result written value by value",
    ))


def _section(fmi: int, paths: tuple[Path, Path], stop: float, repetitions: int) -> Section:
    calls: dict[str, Callable[[], Rows]] = {PLAIN: partial(plain_loop, paths, stop)}
    for name, options in RUNS.items():
        calls[name] = partial(simulate, *paths, stop_time=stop, step=STEP, **options)
    expected, found = (calls[name]() for name in (PLAIN, "sequential, no events, python"))
    if expected.tobytes() != found.tobytes():
        raise RuntimeError(f"FMI {fmi}: the plain loop and the master have different rows")
    times: dict[str, list[float]] = {name: [] for name in calls}
    order = list(calls)
    for _ in range(repetitions):
        order.append(order.pop(0))
        for name in order:
            begin = time.process_time()
            calls[name]()
            times[name].append(1e3 * (time.process_time() - begin))
    reference = np.array(times[PLAIN])
    return Section(f"FMI {fmi}, {expected.size - 1} steps", [
        {
            "master": name, "ms": float(np.median(row)), "least ms": min(row),
            "largest ms": max(row), **ratios(np.array(row), reference),
        }
        for name, row in times.items()
    ])


def plain_loop(paths: tuple[Path, Path], stop: float) -> Rows:
    """Rows of a co-simulation as the master's without events, by fmpy's methods."""
    times = np.append(np.arange(0.0, stop, STEP), stop)
    with load(paths[0]) as first, load(paths[1]) as second:
        for unit in (first, second):
            unit.enter_initialization(0.0, stop)
        linked = [n for n in first.outputs() if n in second.variables]
        get, given, _ = _access(first, linked, "get")
        put, taken, _ = _access(second, linked, "set")
        outputs = [_access(u, names, "get") for u in (first, second) for names in _by_type(u)]
        kinds: dict[type, type] = {float: np.float64, int: np.int32, bool: np.bool_}
        fields = [(n, kinds[u.kind(n)]) for u in (first, second) for n in u.outputs()]
        rows: Rows = np.zeros(times.size, [("time", np.float64), *fields])
        rows["time"] = times
        first.exit_initialization()
        put(taken, get(given))
        second.exit_initialization()
        for i, end in enumerate(times.tolist()):
            if i > 0:
                begin = float(times[i - 1])
                first.fmu.doStep(begin, end - begin)
                put(taken, get(given))
                second.fmu.doStep(begin, end - begin)
            for read, references, names in outputs:
                for name, value in zip(names, read(references), strict=True):
                    rows[i][name] = value
    return rows


def _by_type(unit: Unit) -> list[list[str]]:
    names = unit.outputs()
    kinds = dict.fromkeys(unit.variables[n].type for n in names)
    return [[n for n in names if unit.variables[n].type == kind] for kind in kinds]


def _access(unit: Unit, names: list[str], way: str) -> tuple[Any, list[int], list[str]]:
    """fmpy's method for variables of one type, their references and names."""
    kind = unit.variables[names[0]].type
    group = GROUPS.get(kind, {}).get(unit.description.fmiVersion, kind)
    return getattr(unit.fmu, way + group), [unit.variables[n].valueReference for n in names], names
