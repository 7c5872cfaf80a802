"""What a user installs: `python -m tests.wheel [--keep FOLDER] [interpreter ...]`.

Builds the source distribution and from it the wheel, looks into both, and runs the wheel's commands
in an empty environment outside of the repository, for each of the interpreters. What has passed is
kept in a folder.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import time
import zipfile
from argparse import ArgumentParser
from collections import Counter
from pathlib import Path

from segfmu.fmu.models import registered
from segfmu.fmu.native.compilers import PLATFORMS
from segfmu.fmu.native.packed import unpack

ROOT = Path(__file__).parents[1]
# bytes of the wheel: 3.4 million with the binaries of four models for five platforms, each with the
# whole planner and what it proves of commands, 0.2 million of WebAssembly, without which
# `segfmu live` would need a compiler
LARGEST = 3_600_000
SHIPPED = (
    "src/segfmu/codegen/__main__.py",
    "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "Makefile", "README.md", "requirements-dev.lock",
    ".ci/run", "docs/planner.md", "examples/01_plan_a_move.py", "fmus/gantry_crane/README.md",
    "models/paper.toml", "src/segfmu/kernels/c/kernels.c", "tests/data/planner-problems.json",
    "tests/conftest.py",
)
CODE = """
import sys
import segfmu
from segfmu.cosim import native
from segfmu.kernels.backend import COMPILED

assert COMPILED, "the wheel has no compiled kernels"
assert native.COMPILED, "the wheel has no compiled step loop"
assert not segfmu.__file__.startswith({root!r}), segfmu.__file__
print(sys.version.split()[0], "segfmu", segfmu.__version__)
"""


FACE = """
import segfmu

run = segfmu.simulate({mission!r}, step=0.01)
assert run.passed, run
run.report("face.html")
segfmu.build(run.mission, "face")
try:
    run.to_pandas()
except segfmu.InputError as error:
    assert "pip install pandas" in str(error), error
"""


def built(folder: Path, *, anew: bool) -> tuple[Path, Path]:
    """Build into a folder; returns the source distribution and the wheel made from it.

    Unless `anew`, setuptools takes the modules of this environment that are newer than their
    sources, which an installation compiled in the same way.
    """
    run(sys.executable, "-m", "segfmu.fmu.native.prebuild")
    # what setuptools kept of an earlier build would be in the wheel
    shutil.rmtree(ROOT / "build", ignore_errors=True)
    if not anew:
        own = f"lib.{sysconfig.get_platform()}-{sys.implementation.cache_tag}"
        for module in (ROOT / "src").rglob("*.abi3.so"):
            place = ROOT / "build" / own / module.relative_to(ROOT / "src")
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(module, place)
    for kind in ("--sdist", "--wheel"):
        run(sys.executable, "-m", "build", kind, "--outdir", str(folder), str(ROOT))
    (source,), (wheel,) = folder.glob("*.tar.gz"), folder.glob("*.whl")
    return source, wheel


def run(*words: str, folder: Path | None = None) -> None:
    """Run a command; what it prints is shown where it fails."""
    outside = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}
    done = subprocess.run(
        words, cwd=folder, env=outside, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    )
    if done.returncode != 0:
        raise SystemExit(f"{done.stdout}\n{' '.join(words)}: exit code {done.returncode}")


def check_source(source: Path) -> None:
    """The source distribution is all of the repository that a fork needs."""
    with tarfile.open(source) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    missing = set(SHIPPED) - names
    assert not missing, f"{source.name} lacks {sorted(missing)}"
    made = (".so", ".tar.xz", ".pyc", ".fmu")
    left = {n for n in names if n.endswith(made) or n.startswith("out/")}
    assert not left, f"{source.name} has {sorted(left)}"


def check_wheel(wheel: Path) -> None:
    """One wheel for every Python from 3.11 on: two compiled modules, binaries of FMUs, no tests."""
    assert wheel.stat().st_size < LARGEST, f"{wheel.name} has {wheel.stat().st_size} bytes"
    assert "-cp311-abi3-" in wheel.name, wheel.name
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        metadata = archive.read(next(n for n in names if n.endswith("/METADATA"))).decode()
        fmus = [n for n in names if n.startswith("segfmu/fmu/native/binaries/")]
        libraries = [unpack(archive.read(name)) for name in fmus]
    # all models, an archive a processor; pages have two of them, in one version of FMI
    processors = Counter(platform.partition("-")[0] for platform in PLATFORMS)
    counts = sorted(2 * len(registered()) * platforms for platforms in processors.values())
    assert sorted(map(len, libraries)) == [2, *counts], fmus
    # FMUs take them along: see setup.py
    assert "segfmu/fmu/sources.tar.bz2" in names
    assert not any(n.endswith((".c", ".h")) and "/c/" in n for n in names)
    modules = [n for n in names if n.endswith((".so", ".pyd"))]
    assert len(modules) == 2, modules
    tops = {n.partition("/")[0].partition("-")[0] for n in names}
    assert tops == {"segfmu"}, tops
    # it needs SymPy and Pyccel, and writes into the repository
    assert not any(n.startswith("segfmu/codegen/") for n in names)
    needed = [line for line in metadata.splitlines() if line.startswith("Requires-Dist")]
    assert not any("sympy" in line and "extra" not in line for line in needed), needed


def check_commands(wheel: Path, interpreter: str, work: Path) -> None:
    """The main job, with what `pip install` brings and nothing else."""
    environment = work / "environment"
    run(interpreter, "-m", "venv", str(environment))
    commands = environment / ("Scripts" if os.name == "nt" else "bin")
    # what the commands do not import is not compiled
    run(str(commands / "python"), "-m", "pip", "install", "--quiet", "--no-compile", str(wheel))
    run(str(commands / "python"), "-c", CODE.format(root=str(ROOT)), folder=work)
    mission = str(ROOT / "models" / "paper.toml")
    segfmu = str(commands / "segfmu")
    run(segfmu, "--version", folder=work)
    run(segfmu, "plan", mission, "--output", "plan", folder=work)
    run(segfmu, "build", mission, "--fmi", "3", "--output", "fmi3", folder=work)
    run(segfmu, "build", "--backend", "python", "--output", "python", folder=work)
    run(segfmu, "simulate", mission, "--output", "run", folder=work)
    check_without_compiler(commands, work)
    for name in ("plan/plan.csv", "fmi3/GantryCrane.fmu", "python/GantryCrane.fmu", "run/run.csv"):
        assert (work / name).exists(), name


def check_without_compiler(commands: Path, work: Path) -> None:
    """Native FMUs of all platforms, and runs, where no compiler is on the path."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}
    environment |= {"PATH": str(commands), "SEGFMU_CACHE": str(work / "cache")}
    for fmi in ("2", "3"):
        start = time.perf_counter()
        subprocess.run(
            [commands / "segfmu", "build", "--platforms", "all", "--fmi", fmi, "-o", f"all{fmi}"],
            cwd=work, env=environment, check=True, stdout=subprocess.DEVNULL,
        )
        seconds = time.perf_counter() - start
        with zipfile.ZipFile(work / f"all{fmi}" / "GantryCrane.fmu") as archive:
            folders = {n.split("/")[1] for n in archive.namelist() if n.startswith("binaries/")}
        # FMI 2.0 has one folder for both processors of macOS
        assert len(folders) == len(PLATFORMS) - (fmi == "2"), folders
        print(f"FMI {fmi}, {len(PLATFORMS)} platforms without a compiler: {seconds:.2f} s")
    models = ROOT / "models"
    for words in (
        ["simulate", str(models / "paper.toml"), "--output", "bare"],
        ["validate", str(models / "scenarios" / "gust.toml"), "--output", "bare"],
        ["live", str(models / "container.toml"), "--output", "bare/live.html"],
    ):
        subprocess.run(
            [commands / "segfmu", *words], cwd=work, env=environment, check=True,
            stdout=subprocess.DEVNULL,
        )
    code = FACE.format(mission=str(models / "paper.toml"))
    subprocess.run([commands / "python", "-c", code], cwd=work, env=environment, check=True)
    made = ("gust.csv", "report.html", "live.html")
    for name in (*(f"bare/{each}" for each in made), "face.html", "face/GantryCrane.fmu"):
        assert (work / name).exists(), name
    assert not (work / "cache").exists()


def main() -> None:
    """Check both distributions under the interpreters of the command line, or this one."""
    parser = ArgumentParser()
    parser.add_argument("--keep", type=Path)
    parser.add_argument("interpreters", nargs="*", default=[sys.executable])
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="segfmu_wheel_") as folder:
        source, wheel = built(Path(folder) / "dist", anew=options.keep is not None)
        check_source(source)
        check_wheel(wheel)
        print(f"{wheel.name}  {wheel.stat().st_size / 1024:.0f} KiB")
        for i, interpreter in enumerate(options.interpreters):
            work = Path(folder) / f"work{i}"
            work.mkdir()
            check_commands(wheel, interpreter, work)
            print(f"{interpreter}: plan, build, simulate and validate work")
        if options.keep:
            options.keep.mkdir(exist_ok=True)
            for made in (source, wheel):
                print(shutil.copy2(made, options.keep))


if __name__ == "__main__":
    main()
