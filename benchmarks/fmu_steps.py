"""Communication steps of the FMUs, native and on PythonFMU, beside an FMU that does nothing.

Every step sets all inputs, steps by 1 ms and reads all real outputs: in C through a small importer,
and in Python through fmpy's bindings.
"""

from __future__ import annotations

import ctypes
import statistics
import time
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.drivers import NATIVE, compiled
from benchmarks.report import Part, Record, Section, Settings
from segfmu.cosim.unit import Unit
from segfmu.fmu import gantry_crane, gantry_feedforward, native
from segfmu.fmu.build import build_all
from segfmu.fmu.fmi2 import guid
from segfmu.fmu.spec import Spec, started

HEADERS = Path(native.__file__).parent / "c" / "fmi"
STEP = 1e-3
WAYPOINTS = 16


class Job(ctypes.Structure):
    """What fmu_driver.c measures."""

    _fields_ = [
        ("library", ctypes.c_char_p), ("token", ctypes.c_char_p),
        *((n, ctypes.c_size_t) for n in ("reals", "integers", "inputs", "outputs")),
        *((n, ctypes.c_void_p) for n in (
            "real_references", "integer_references", "input_references", "output_references",
            "real_values", "input_values", "integer_values",
        )),
        ("steps", ctypes.c_int64), ("step", ctypes.c_double),
    ]


def measure(settings: Settings) -> Part:
    """Microseconds a step of 1 ms, and initialisation with a plan through 16 waypoints."""
    specs = (_mission(gantry_feedforward.spec()), _hanging(gantry_crane.spec()))
    natives = (gantry_feedforward.native_spec(specs[0]), gantry_crane.native_spec(specs[1]))
    ours = native.build_all(natives, settings.folder / "native")
    theirs = build_all(settings.folder / "python", specs=specs)
    driver = compiled(
        "cc", ["-std=c99", f"-I{HEADERS}"], [NATIVE / "fmu_driver.c"],
        settings.folder / "fmu_driver.so",
    )
    nothing = settings.folder / "nothing.so"
    compiled("cc", ["-std=c99", f"-I{HEADERS}"], [NATIVE / "nothing.c"], nothing)
    records: list[Record] = []
    for spec, path, other in zip(natives, ours, theirs, strict=True):
        steps = 40 * settings.samples
        library = _library(path, settings.folder / "binaries")
        in_c = [_in_c(driver, spec, library, steps) for _ in range(settings.repetitions)]
        records.append(_record(spec.name, "native", "C", in_c))
        for name, archive, count in (("native", path, steps // 4), ("python", other, 400)):
            taken = [_in_python(archive, count) for _ in range(min(settings.repetitions, 3))]
            records.append(_record(spec.name, name, "fmpy", taken))
    empty = [_in_c(driver, natives[1], nothing, 200000) for _ in range(settings.repetitions)]
    records.append(_record("does nothing", "native", "C", empty))
    return Part(
        "FMUs",
        (Section("Communication steps of 1 ms, all inputs set, all outputs read", records),),
        (f"GantryFeedforward plans through {WAYPOINTS} waypoints in its initialisation",),
    )


def _record(name: str, backend: str, importer: str, taken: list[tuple[float, float]]) -> Record:
    start, step = zip(*taken, strict=True)
    return {
        "FMU": name, "backend": backend, "importer": importer,
        "us a step, median": 1e6 * statistics.median(step), "us a step, largest": 1e6 * max(step),
        "ms initialisation, median": 1e3 * statistics.median(start),
    }


def _mission(spec: Spec) -> Spec:
    """A mission through 16 waypoints, of which some are passed."""
    random = np.random.default_rng(5)
    places = np.cumsum(random.uniform(0.1, 0.5, (WAYPOINTS, 3)), axis=0) * [1.0, 1.0, 0.0]
    places[:, 2] = -0.5 - 0.2 * np.arange(WAYPOINTS) % 3
    values: dict[str, Any] = {"waypoint.count": WAYPOINTS, "crane.rope_max": 0.0}
    for i, place in enumerate(places, 1):
        velocity = [0.1, 0.1, 0.0] if 1 < i < WAYPOINTS else [0.0] * 3
        for axis, x, v in zip("xyz", place, velocity, strict=True):
            values[f"waypoint[{i}].position.{axis}"] = float(x)
            values[f"waypoint[{i}].velocity.{axis}"] = v
            values[f"waypoint[{i}].acceleration.{axis}"] = 0.0
    return started(spec, values)


def _hanging(spec: Spec) -> Spec:
    """A load that swings, held by its weight, under feedback."""
    return started(
        spec, {"sway.x.angle": 0.05, "force.hoist": -9.81, "reference.rope.length": 0.5}
    )


def _library(path: Path, folder: Path) -> Path:
    with zipfile.ZipFile(path) as archive:
        name = next(n for n in archive.namelist() if n.startswith("binaries/"))
        return Path(archive.extract(name, folder / path.stem))


def _in_c(driver: ctypes.CDLL, spec: Spec, library: Path, steps: int) -> tuple[float, float]:
    """Seconds of initialisation and of a step."""
    references = {v.name: i for i, v in enumerate(spec.variables)}
    inputs = spec.where("input")
    outputs = [v for v in spec.where("output") if v.kind == "Real"]
    arrays: list[NDArray[Any]] = [
        np.zeros(0, np.uint32), np.zeros(0, np.uint32),
        np.array([references[v.name] for v in inputs], np.uint32),
        np.array([references[v.name] for v in outputs], np.uint32), np.zeros(0),
        np.array([v.start for v in inputs], np.float64), np.zeros(0, np.int32),
    ]
    job = Job(
        str(library.resolve()).encode(), guid(spec).encode(), 0, 0, len(inputs), len(outputs),
        *(a.ctypes.data for a in arrays), steps, STEP,
    )
    times = (ctypes.c_double * 3)()
    status = driver.measure(ctypes.byref(job), times)
    if status != 0:
        raise RuntimeError(f"fmu_driver.c: status {status} for {library.name}")
    return times[0], times[1] / steps


def _in_python(path: Path, steps: int) -> tuple[float, float]:
    """The same through the master's bindings."""
    with Unit(path) as unit:
        begin = time.perf_counter()
        unit.enter_initialization(0.0, STEP * steps)
        unit.exit_initialization()
        start = time.perf_counter() - begin
        names = [v.name for v in unit.description.modelVariables if v.causality == "input"]
        written = unit.channel(names).get("Real")
        if written is not None:
            written.values[:] = [float(unit.variables[n].start) for n in names]
        read = unit.channel([n for n in unit.outputs() if unit.variables[n].type == "Real"])["Real"]
        begin = time.perf_counter()
        for i in range(steps):
            if written is not None:
                written.write()
            unit.step(STEP * i, STEP)
            read.read()
        return start, (time.perf_counter() - begin) / steps
