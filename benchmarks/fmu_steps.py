"""Communication steps of the FMUs, native and on PythonFMU, beside an FMU that does nothing.

Every step sets all real inputs, steps by 1 ms and reads all real outputs: in C through a small
importer that loads the FMU's library, and in Python by the calls of our master. The backends take
turns, and every measurement loads and initialises the FMU anew.
"""

from __future__ import annotations

import ctypes
import time
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from fmpy import extract, read_model_description
from numpy.typing import NDArray

from benchmarks.drivers import NATIVE, DriverError, compiled
from benchmarks.report import Part, Record, Section, Settings
from benchmarks.timing import ratios
from segfmu.cosim.load import load
from segfmu.errors import BuildError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.python.archive import build_all
from segfmu.fmu.standard.spec import Spec, started

FloatArray = NDArray[np.float64]
HEADERS = Path(native.__file__).parent / "c" / "fmi"
STEP = 1e-3
WAYPOINTS = 16
TITLE = "FMUs: a communication step of 1 ms, all inputs set, all outputs read"
NATIVE_C, PYTHON, NOTHING = "native", "PythonFMU", "does nothing"
# steps of a measurement, so that each takes some 10 ms
STEPS = {
    (NATIVE_C, "C"): 10000, (PYTHON, "C"): 200, (NOTHING, "C"): 100000,
    (NATIVE_C, "master"): 2000, (PYTHON, "master"): 200, (NOTHING, "master"): 2000,
}


class Job(ctypes.Structure):
    """What fmu_driver.c measures."""

    _fields_ = [
        *((n, ctypes.c_char_p) for n in ("library", "token", "resources")),
        *((n, ctypes.c_size_t) for n in ("inputs", "outputs")),
        *((n, ctypes.c_void_p) for n in ("input_references", "output_references", "input_values")),
        ("steps", ctypes.c_int64), ("step", ctypes.c_double),
    ]


@dataclass(frozen=True)
class Archive:
    """An FMU, unpacked for the importer in C; inputs keep their start values."""

    path: Path
    library: Path
    resources: str
    token: str
    inputs: NDArray[np.uint32]
    outputs: NDArray[np.uint32]
    values: FloatArray


def measure(settings: Settings) -> Part:
    """Microseconds a step of 1 ms, and initialisation with a plan through 16 waypoints."""
    try:
        driver = _compiled("fmu_driver", settings.folder)
        _compiled("nothing", settings.folder)
        archives = _archives(settings.folder)
    except (DriverError, BuildError) as problem:
        return Part(TITLE, (), (f"not measured: {problem}",))
    sections = []
    for name, backends in archives.items():
        calls = {
            (backend, importer): _call(driver, archive, importer, STEPS[backend, importer])
            for importer in ("C", "master")
            for backend, archive in backends.items()
        }
        found = _in_turns(calls, settings.repetitions)
        records = [_record(b, i, found[b, i], found[NATIVE_C, i]) for b, i in calls]
        inputs, outputs = (len(a) for a in (backends[NATIVE_C].inputs, backends[NATIVE_C].outputs))
        sections.append(Section(f"{name}, {inputs} inputs, {outputs} outputs", records))
    return Part(TITLE, sections, (
        f"median, least and largest of {settings.repetitions} measurements; ratio: time over the "
        "native FMU's in the same importer and pass",
        "C: the FMU's library, loaded and called by a program in C; master: by ours",
        f"initialisation: GantryFeedforward plans through {WAYPOINTS} waypoints, GantryCrane finds "
        "its feedback gains",
    ))


def _compiled(name: str, folder: Path) -> ctypes.CDLL:
    return compiled("cc", ["-std=c99", f"-I{HEADERS}"], [NATIVE / f"{name}.c"],
                    folder / f"{name}.so")


def _in_turns(
    calls: dict[tuple[str, str], Callable[[], tuple[float, float]]], repetitions: int
) -> dict[tuple[str, str], FloatArray]:
    """Seconds of initialisation and of a step, shape (repetitions, 2), after one warm-up."""
    rows: dict[tuple[str, str], list[tuple[float, float]]] = {key: [] for key in calls}
    order = list(calls)
    for _ in range(repetitions + 1):
        order.append(order.pop(0))
        for key in order:
            rows[key].append(calls[key]())
    return {key: np.array(found[1:]) for key, found in rows.items()}


def _record(backend: str, importer: str, times: FloatArray, reference: FloatArray) -> Record:
    initialisation, step = 1e3 * times[:, 0], 1e6 * times[:, 1]
    return {
        "importer": importer, "backend": backend,
        "us a step": float(np.median(step)), "least us": float(step.min()),
        "largest us": float(step.max()), **ratios(times[:, 1], reference[:, 1]),
        "ms initialisation": float(np.median(initialisation)),
        "least ms": float(initialisation.min()), "largest ms": float(initialisation.max()),
    }


def _archives(folder: Path) -> dict[str, dict[str, Archive]]:
    """By FMU and backend."""
    specs = (_mission(gantry_feedforward.spec()), _hanging(gantry_crane.spec()))
    natives = (gantry_feedforward.native_spec(specs[0]), gantry_crane.native_spec(specs[1]))
    ours = native.build_all(natives, folder / "native")
    theirs = build_all(folder / "python", specs=specs)
    empty = [_emptied(path, folder / "nothing.so", folder / "empty") for path in ours]
    return {
        spec.name: {
            backend: _unpacked(path, folder / "unpacked" / backend)
            for backend, path in zip((NATIVE_C, PYTHON, NOTHING), paths, strict=True)
        }
        for spec, paths in zip(specs, zip(ours, theirs, empty, strict=True), strict=True)
    }


def _emptied(path: Path, library: Path, folder: Path) -> Path:
    """An FMU of the same interface that does nothing."""
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / path.name
    with zipfile.ZipFile(path) as source, zipfile.ZipFile(target, "w") as archive:
        for name in source.namelist():
            binary = name.startswith("binaries/")
            archive.writestr(name, library.read_bytes() if binary else source.read(name))
    return target


def _unpacked(path: Path, folder: Path) -> Archive:
    place = folder / path.stem
    extract(str(path), unzipdir=str(place))
    found = read_model_description(str(path))
    # PythonFMU packs binaries of several platforms
    library = place / "binaries" / "linux64" / f"{path.stem}.so"
    if not library.exists():
        raise DriverError("the importer in C needs Linux on x86_64")
    real = [v for v in found.modelVariables if v.type == "Real"]
    inputs = [v for v in real if v.causality == "input"]
    outputs = [v for v in real if v.causality == "output"]
    return Archive(
        path, library, (place / "resources").resolve().as_uri(), found.guid,
        np.array([v.valueReference for v in inputs], np.uint32),
        np.array([v.valueReference for v in outputs], np.uint32),
        np.array([float(v.start) for v in inputs]),
    )


def _call(
    driver: ctypes.CDLL, archive: Archive, importer: str, steps: int
) -> Callable[[], tuple[float, float]]:
    if importer == "C":
        return lambda: _in_c(driver, archive, steps)
    return lambda: _in_python(archive, steps)


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


def _in_c(driver: ctypes.CDLL, archive: Archive, steps: int) -> tuple[float, float]:
    """Seconds of initialisation and of a step."""
    job = Job(
        str(archive.library.resolve()).encode(), archive.token.encode(),
        archive.resources.encode(), len(archive.inputs), len(archive.outputs),
        archive.inputs.ctypes.data, archive.outputs.ctypes.data, archive.values.ctypes.data,
        steps, STEP,
    )
    times = (ctypes.c_double * 2)()
    status = driver.measure(ctypes.byref(job), times)
    if status != 0:
        raise RuntimeError(f"fmu_driver.c: status {status} for {archive.path}")
    return times[0], times[1] / steps


def _in_python(archive: Archive, steps: int) -> tuple[float, float]:
    """The same through the master's bindings."""
    with load(archive.path) as unit:
        begin = time.perf_counter()
        unit.enter_initialization(0.0, STEP * steps)
        unit.exit_initialization()
        start = time.perf_counter() - begin
        names = {n: v.causality for n, v in unit.variables.items() if v.type == "Real"}
        inputs = [n for n, c in names.items() if c == "input"]
        written = unit.channel(inputs) if inputs else None
        if written is not None:
            written.values[:] = archive.values
        read = unit.channel([n for n, c in names.items() if c == "output"])
        begin = time.perf_counter()
        for i in range(steps):
            if written is not None:
                written.write()
            unit.step(STEP * i, STEP * (i + 1))
            read.read()
        return start, (time.perf_counter() - begin) / steps
