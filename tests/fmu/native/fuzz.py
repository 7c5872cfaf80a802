"""Random call sequences against native FMUs under sanitizers: `python -m tests.fmu.native.fuzz`.

The sources of an archive are compiled with a driver in C, AddressSanitizer and
UndefinedBehaviorSanitizer; or, with `--memcheck`, without them for Valgrind, which finds values
that nobody has set. A failing sequence is repeated with its number as `--first`.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from pathlib import Path

from benchmarks.initialisation import SIZES, changes

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.hook_crane import interface as hook_crane
from segfmu.fmu.hook_feedforward import interface as hook_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.native.binaries import APART
from segfmu.fmu.standard.spec import Spec, started
from tests.compiler import SANITIZERS, compiled

DRIVERS = Path(__file__).parent / "c"
OPTIONS = ("-std=c99", "-g", "-ffp-contract=off", "-w")
# sources of the kernels that are not in an object file of `kernels.c`
OTHERS = ("messages.c", "plan.c")
MEMCHECK = ("valgrind", "--quiet", "--error-exitcode=1", "--leak-check=full")
# one that follows a stick from the start
COMMANDED = started(gantry_feedforward.native_spec(), {
    "command.enabled": True, "command.mode": "velocity", "command.velocity.x": 0.2,
    "command.velocity.z": 0.05, "workspace.x.max": 1.2, "drive.bridge.acceleration_max": 1.5,
})
# the feedback with a hook, which is off by default, designs its tables at initialisation
HOOKED = started(hook_crane.native_spec(), {"feedback.enabled": True, "sling.x.angle": 0.05})
HOOKS = (hook_feedforward.native_spec(), HOOKED)
SPECS = (gantry_feedforward.native_spec(), gantry_crane.native_spec(), COMMANDED, *HOOKS)


def missions(count: int) -> Iterator[Spec]:
    """GantryFeedforward that searches: both sizes, states given or free, with boxes or without."""
    for name, free, boxed in product(SIZES, (False, True), (False, True)):
        for values in changes(count, name, free=free, boxed=boxed):
            yield started(gantry_feedforward.native_spec(), values)


def program(
    compiler: str, spec: Spec, fmi: int, folder: Path, level: str = "-O1",
    sanitizers: Sequence[str] = SANITIZERS, kernels: Path | None = None,
) -> Path:
    """Compile the driver of a version, which includes the FMU, and put its resources beside it.

    `level` is the compiler's option of optimisation; kernels in an object file, of the same
    sanitizers, are linked in place of being compiled with each FMU.
    """
    place = folder / f"{spec.name}{fmi}"
    place.mkdir()
    written(spec, fmi, place)
    shutil.copytree(DRIVERS, place, dirs_exist_ok=True)
    objects = []
    if kernels is not None:
        shutil.copyfile(kernels, place / "kernels.o")
        objects = [f"-D{APART}", *OTHERS, "kernels.o"]
    words = [*OPTIONS, *sanitizers, level, f"fuzz{fmi}.c", *objects, "-lm"]
    return compiled(place / "fuzz", words, place, compiler)


def written(spec: Spec, fmi: int, place: Path) -> None:
    """Write the sources and the start values of an FMU into a folder."""
    for name, content in native.entries(spec, fmi, ()).items():
        folder, _, own = name.rpartition("/")
        if folder in ("sources", "resources"):
            (place / own).write_bytes(content)


def run(
    target: Path, sequences: int, first: int, timeout: float | None = None,
    under: Sequence[str] = (),
) -> str:
    """Run a program; returns its summary, raises AssertionError with the report of a crash."""
    done = subprocess.run(
        [*under, target, str(sequences), str(first), str(target.parent)], capture_output=True,
        text=True, check=False, timeout=timeout,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout.strip()


def searches(
    target: Path, fmi: int, specs: Iterable[Spec], sequences: int, first: int,
    under: Sequence[str] = (),
) -> list[str]:
    """Run the program of GantryFeedforward with missions."""
    told = []
    for spec in specs:
        (target.parent / "start.bin").write_bytes(native.start_values(spec, fmi))
        told.append(run(target, sequences, first, under=under))
    return told


def main() -> None:
    """Programs, with as many sequences each as asked for; one in a hundred searches."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sequences", type=int, default=1_000_000)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--compiler", default="cc")
    parser.add_argument("--memcheck", action="store_true")
    numbers = range(len(SPECS))
    names = ", ".join(f"{number} {SPECS[number].name}" for number in numbers)
    parser.add_argument(
        "--only", type=int, choices=numbers, nargs="+", default=numbers, metavar="NUMBER",
        help=f"{names}; {SPECS.index(COMMANDED)} follows a stick (default: all)",
    )
    parser.add_argument("--fmi", type=int, choices=(2, 3), nargs="+", default=(2, 3))
    chosen = parser.parse_args()
    sanitizers, under = ((), MEMCHECK) if chosen.memcheck else (SANITIZERS, ())
    for fmi, number in product(chosen.fmi, chosen.only):
        spec = SPECS[number]
        with tempfile.TemporaryDirectory() as work:
            target = program(chosen.compiler, spec, fmi, Path(work), "-O2", sanitizers)
            told = run(target, chosen.sequences, chosen.first, under=under)
            print(f"{spec.name}, FMI {fmi}: {told}", flush=True)
            if number == 0:
                count = max(1, chosen.sequences // 10_000)
                for told in searches(target, fmi, missions(count), 10, chosen.first, under):
                    print(f"{spec.name}, FMI {fmi}, a search: {told}", flush=True)


if __name__ == "__main__":
    main()
