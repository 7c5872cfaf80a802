"""The C and C++ drivers in native/: compiled here, loaded into this process."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.problems import Problems
from benchmarks.report import installed_version

FloatArray = NDArray[np.float64]
NATIVE = Path(__file__).parent / "native"
KERNELS = Path(__file__).parents[1] / "src" / "segfmu" / "kernels" / "c"
OPTIMISED = [
    "-O3", "-DNDEBUG", "-fPIC", "-shared", "-fno-semantic-interposition", "-fno-math-errno",
    "-fno-trapping-math",
]


class DriverError(Exception):
    """No compiler, no download, or sources that do not compile; the message is one line."""


class Batch(ctypes.Structure):
    """`batch` of batch.h."""

    _fields_ = [
        *((name, ctypes.c_int64) for name in ("count", "axes", "smoothness", "shape")),
        *(
            (name, ctypes.c_void_p)
            for name in (
                "limits", "positions", "velocities", "accelerations", "durations", "times"
            )
        ),
    ]


class Problem(ctypes.Structure):
    """`segfmu_problem` of segfmu.h."""

    _fields_ = [
        *(
            (name, ctypes.c_int64)
            for name in ("points", "axes", "smoothness", "shape", "synchronization")
        ),
        *((name, ctypes.c_double) for name in ("sample_time", "duration")),
        *(
            (name, ctypes.c_void_p)
            for name in ("positions", "velocities", "accelerations", "dwells", "limits", "lower")
        ),
    ]


class Driver:
    """One function of a driver, on one batch of problems.

    Attributes
    ----------
    durations : ndarray, shape (count,)
        Durations found by the last run [s], NaN where a problem was refused.
    """

    def __init__(
        self, library: ctypes.CDLL, function: str, problems: Problems, smoothness: int, shape: int
    ) -> None:
        self._call = getattr(library, function)
        self._call.restype = ctypes.c_double
        self._arrays = (
            problems.table(smoothness), problems.positions, problems.velocities,
            problems.accelerations,
        )
        self.durations = np.zeros(problems.count)
        self._sizes = (problems.count, problems.axes, smoothness, shape)

    def __call__(self, times: FloatArray | None = None) -> float:
        """Solve all problems; the time of the whole batch [us], of each in `times` if given."""
        arrays = [a.ctypes.data for a in (*self._arrays, self.durations)]
        given = Batch(*self._sizes, *arrays, None if times is None else times.ctypes.data)
        return float(self._call(ctypes.byref(given)))


def mission_time(library: ctypes.CDLL, states: FloatArray, limits: FloatArray) -> float:
    """Time of one `segfmu_plan` with plateau ramps and axes that meet in all waypoints [us].

    states (3, waypoints, axes): positions, velocities, accelerations; limits (axes, n + 1).
    Negative: the status of a refusal.
    """
    points, axes = states.shape[1:]
    arrays = (*(np.ascontiguousarray(s) for s in states), np.zeros(points), limits)
    given = Problem(
        points, axes, limits.shape[1] - 1, 1, 1, 0.0, 0.0, *(a.ctypes.data for a in arrays)
    )
    library.run_mission.restype = ctypes.c_double
    return float(library.run_mission(ctypes.byref(given)))


def segfmu_library(folder: Path) -> ctypes.CDLL:
    """Compile segfmu's kernels with their driver.

    Raises
    ------
    DriverError
        When there is no C compiler or it fails.
    """
    sources = [NATIVE / "segfmu_driver.c", KERNELS / "plan.c", KERNELS / "kernels.c"]
    flags = ["-std=c99", "-ffp-contract=off", "-w", f"-I{KERNELS}"]
    return compiled("cc", flags, sources, folder / "segfmu.so")


def ruckig_library(folder: Path) -> ctypes.CDLL:
    """Compile Ruckig's C++ sources, of the release whose wheel is installed, with their driver.

    Raises
    ------
    DriverError
        When the archive cannot be had, or there is no C++ compiler or it fails.
    """
    source = ruckig_source(folder)
    sources = [NATIVE / "ruckig_driver.cpp", *sorted((source / "src" / "ruckig").glob("*.cpp"))]
    sources = [path for path in sources if path.name != "cloud_client.cpp"]
    flags = ["-std=c++20", "-w", f"-I{source / 'include'}"]
    return compiled("c++", flags, sources, folder / "ruckig.so")


def ruckig_source(folder: Path) -> Path:
    """Folder with Ruckig's source archive of PyPI, downloaded once."""
    name = f"ruckig-{installed_version('ruckig')}"
    if not (folder / name).is_dir():
        command = [
            sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check",
            "--no-deps", "--no-binary", "ruckig", "--dest", str(folder), name.replace("-", "=="),
        ]
        _run(command, "pip cannot download Ruckig's source archive")
        with tarfile.open(folder / f"{name}.tar.gz") as archive:
            archive.extractall(folder, filter="data")
    return folder / name


def compiled(compiler: str, flags: list[str], sources: list[Path], target: Path) -> ctypes.CDLL:
    """Compile sources to a library and load it."""
    if shutil.which(compiler) is None:
        raise DriverError(f"no {compiler} found; install a compiler")
    target.parent.mkdir(parents=True, exist_ok=True)
    command = [compiler, *OPTIMISED, *flags, *map(str, sources), "-lm", "-o", str(target)]
    _run(command, f"{compiler} cannot compile {sources[0].name}")
    return ctypes.CDLL(str(target.resolve()))


def _run(command: list[str], failure: str) -> None:
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        lines = [line for line in done.stderr.splitlines() if "rror" in line]
        raise DriverError(f"{failure}: {lines[0] if lines else 'no message'}")
