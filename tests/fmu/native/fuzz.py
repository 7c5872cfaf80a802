"""Random call sequences against native FMUs under sanitizers: `python -m tests.fmu.native.fuzz`.

The sources of an archive are compiled with a driver in C, AddressSanitizer and
UndefinedBehaviorSanitizer. A failing sequence is repeated with its number as `--first`.
"""

from __future__ import annotations

import argparse
import subprocess
import tempfile
from pathlib import Path

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.standard.spec import Spec

DRIVERS = Path(__file__).parent / "c"
SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
OPTIONS = ("-std=c99", "-g", "-O1", "-ffp-contract=off", "-w", *SANITIZERS)
SPECS = (gantry_feedforward.native_spec(), gantry_crane.native_spec())


def kernels(compiler: str, folder: Path) -> list[Path]:
    """Object files of the kernels, the same for all programs."""
    made = []
    for name in ("kernels.c", "plan.c"):
        made.append(folder / f"{name}.o")
        source = Path(native.__file__).parents[2] / "kernels" / "c" / name
        subprocess.run([compiler, *OPTIONS, "-c", source, "-o", made[-1]], check=True)
    return made


def program(compiler: str, spec: Spec, fmi: int, folder: Path, objects: list[Path]) -> Path:
    """Compile the driver of a version with all sources of an FMU."""
    place = folder / f"{spec.name}{fmi}"
    place.mkdir()
    for name, text in native.sources(spec, fmi).items():
        (place / name).write_bytes(text)
    own = [p for p in place.glob("*.c") if p.name not in native.KERNELS]
    target = place / "fuzz"
    subprocess.run(
        [compiler, *OPTIONS, f"-I{place}", f"-I{DRIVERS}", DRIVERS / f"fuzz{fmi}.c", *own,
         *objects, "-lm", "-o", target],
        check=True,
    )
    return target


def run(target: Path, sequences: int, first: int, timeout: float | None = None) -> str:
    """Run a program; returns its summary, raises AssertionError with the report of a crash."""
    done = subprocess.run(
        [target, str(sequences), str(first)], capture_output=True, text=True, check=False,
        timeout=timeout,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout.strip()


def main() -> None:
    """All four programs, with as many sequences each as asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sequences", type=int, default=1_000_000)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--compiler", default="cc")
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        objects = kernels(chosen.compiler, Path(work))
        for fmi in (2, 3):
            for spec in SPECS:
                target = program(chosen.compiler, spec, fmi, Path(work), objects)
                print(f"{spec.name}, FMI {fmi}: {run(target, chosen.sequences, chosen.first)}")


if __name__ == "__main__":
    main()
