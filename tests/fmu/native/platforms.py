"""Binaries of other platforms, run where they can be: `python -m tests.fmu.native.platforms`.

Both archives are built for Windows and for Linux on Arm, and their own binaries are loaded and
stepped by a small importer in C under Wine and qemu. The crane's states are compared with our
master's on this machine. What is not installed is skipped with a line that says so.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from fmpy import read_model_description

from segfmu.cosim import simulate
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.native.compilers import PLATFORMS, compiler, host

SOURCE = Path(__file__).parent / "c" / "pair.c"
HEADERS = Path(native.__file__).parent / "c" / "fmi"
SPECS = (gantry_feedforward.native_spec(), gantry_crane.native_spec())
STEP, STEPS, EVERY = 0.002, 2500, 20
TOLERANCE = 1e-9
ARM_LIBRARIES = Path("/usr/aarch64-linux-gnu")
# name -> what runs its programs, and what to install for it
EMULATORS = {
    "x86_64-windows": (("wine",), "Wine"),
    "aarch64-linux": (
        ("qemu-aarch64", "-L", str(ARM_LIBRARIES)),
        "qemu-user and the C library of aarch64 (libc6-arm64-cross)",
    ),
}


def missing(name: str) -> str | None:
    """What keeps a platform's binaries from running here, in words; None where they do."""
    if name == host():
        return None
    command, packages = EMULATORS[name]
    found = shutil.which(command[0]) is not None
    if found and (name != "aarch64-linux" or ARM_LIBRARIES.is_dir()):
        return None
    return f"needs {packages}"


def importer(name: str, fmi: int, folder: Path) -> Path:
    """Compile the importer for a platform."""
    target = folder / f"pair{fmi}-{name}.exe"
    libraries = () if name.endswith("windows") else ("-ldl",)
    subprocess.run(
        [*compiler(name).command, "-std=c99", "-O1", f"-DFMI={fmi}", "-isystem", HEADERS, SOURCE,
         *libraries, "-o", target],
        check=True,
    )
    return target


def arguments(paths: list[Path], fmi: int, name: str, folder: Path) -> list[str]:
    """Libraries, tokens, resources; steps; connections by equal names; the crane's states."""
    words, variables = [], []
    place = PLATFORMS[name].folder if fmi == 2 else name
    for path in paths:
        library = f"binaries/{place}/{path.stem}{PLATFORMS[name].suffix}"
        unpacked = folder / f"{path.stem}{fmi}"
        with zipfile.ZipFile(path) as archive:
            target = archive.extract(library, unpacked)
            archive.extract("resources/start.bin", unpacked)
        found = read_model_description(str(path))
        resources = unpacked / "resources"
        words += [target, found.guid, resources.as_uri() if fmi == 2 else str(resources)]
        variables.append({v.name: v for v in found.modelVariables})
    source, sink = variables
    links = [
        f"{source[n].valueReference}:{v.valueReference}"
        for n, v in sink.items()
        if v.causality == "input" and n in source and source[n].causality == "output"
    ]
    seen = [str(sink[n].valueReference) for n in gantry_crane.STATE]
    return [*words, str(STEPS), repr(STEP), *links, ":", *seen]


def run(name: str, command: list[str], folder: Path) -> np.ndarray:
    """The rows that the importer prints."""
    runner = () if name == host() else EMULATORS[name][0]
    settings = {"WINEPREFIX": str(folder / "wine"), "WINEDEBUG": "-all", "DISPLAY": ""}
    done = subprocess.run(
        [*runner, *command], capture_output=True, text=True, check=False, timeout=600,
        env=os.environ | settings,
    )
    if done.returncode != 0:
        raise SystemExit(f"{name}: {done.stdout}{done.stderr}")
    return np.array([[float(x) for x in line.split()] for line in done.stdout.splitlines()])


def expected(paths: list[Path]) -> np.ndarray:
    """The same rows by our master, through fmpy; the program in C has sequential, equal steps."""
    rows = simulate(
        paths[0], paths[1], stop_time=STEP * STEPS, step=STEP, coupling="sequential", events=False
    )[EVERY::EVERY]
    return np.array([rows[n] for n in gantry_crane.STATE]).T


def check(name: str, folder: Path, reference: np.ndarray) -> None:
    """Build, run and compare both versions of FMI for one platform; prints a line each."""
    for fmi in (2, 3):
        paths = native.build_all(SPECS, folder / f"{name}{fmi}", fmi=fmi, platforms=(name,))
        program = importer(name, fmi, folder)
        found = run(name, [str(program), *arguments(paths, fmi, name, folder)], folder)
        if found.shape != reference.shape:
            raise SystemExit(f"{name}, FMI {fmi}: {found.shape} values, not {reference.shape}")
        difference = float(np.abs(found - reference).max())
        print(f"{name}, FMI {fmi}: {STEPS} steps of both FMUs, states within {difference:.1e} of "
              "this machine's", flush=True)
        if not difference <= TOLERANCE:
            raise SystemExit(f"{name}, FMI {fmi}: more than {TOLERANCE:g}")


def main() -> None:
    """All platforms that run here, this one first."""
    own = host()
    if own is None or find_spec("ziglang") is None:
        print("skipped: needs the extra segfmu[platforms] on Linux, Windows or macOS")
        sys.exit(0)
    with tempfile.TemporaryDirectory() as work:
        folder = Path(work)
        reference = expected(native.build_all(SPECS, folder / "own"))
        for name in dict.fromkeys((own, *EMULATORS)):
            lack = missing(name)
            if lack is not None:
                print(f"{name}: skipped, {lack}")
                continue
            check(name, folder, reference)
        if (folder / "wine").is_dir():
            subprocess.run(["wineserver", "-w"], check=False, timeout=60,
                           env=os.environ | {"WINEPREFIX": str(folder / "wine")})


if __name__ == "__main__":
    main()
