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
from segfmu.fmu.hook_crane import interface as hook_crane
from segfmu.fmu.hook_feedforward import interface as hook_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.standard.spec import Spec, started

DRIVERS = Path(__file__).parent / "c"
SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
OPTIONS = ("-std=c99", "-g", "-ffp-contract=off", "-w", *SANITIZERS)
# one that follows a stick from the start
COMMANDED = started(gantry_feedforward.native_spec(), {
    "command.enabled": True, "command.mode": "velocity", "command.velocity.x": 0.2,
    "command.velocity.z": 0.05, "workspace.x.max": 1.2, "drive.bridge.acceleration_max": 1.5,
})
# the feedback with a hook, which is off by default, designs its tables at initialisation
HOOKED = started(hook_crane.native_spec(), {"feedback.enabled": True, "sling.x.angle": 0.05})
HOOKS = (hook_feedforward.native_spec(), HOOKED)
SPECS = (gantry_feedforward.native_spec(), gantry_crane.native_spec(), COMMANDED, *HOOKS)


def program(compiler: str, spec: Spec, fmi: int, folder: Path, level: str = "-O1") -> Path:
    """Compile the driver of a version, which includes the FMU, and put its resources beside it.

    `level` is the compiler's option of optimisation.
    """
    place = folder / f"{spec.name}{fmi}"
    place.mkdir()
    written(spec, fmi, place)
    target = place / "fuzz"
    subprocess.run(
        [compiler, *OPTIONS, level, f"-I{place}", f"-I{DRIVERS}", DRIVERS / f"fuzz{fmi}.c", "-lm",
         "-o", target],
        check=True,
    )
    return target


def written(spec: Spec, fmi: int, place: Path) -> None:
    """Write the sources and the start values of an FMU into a folder."""
    for name, content in native.entries(spec, fmi, ()).items():
        folder, _, own = name.rpartition("/")
        if folder in ("sources", "resources"):
            (place / own).write_bytes(content)


def run(target: Path, sequences: int, first: int, timeout: float | None = None) -> str:
    """Run a program; returns its summary, raises AssertionError with the report of a crash."""
    done = subprocess.run(
        [target, str(sequences), str(first), str(target.parent)], capture_output=True, text=True,
        check=False, timeout=timeout,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout.strip()


def main() -> None:
    """All programs, with as many sequences each as asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sequences", type=int, default=1_000_000)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--compiler", default="cc")
    chosen = parser.parse_args()
    for fmi in (2, 3):
        for spec in SPECS:
            with tempfile.TemporaryDirectory() as work:
                target = program(chosen.compiler, spec, fmi, Path(work))
                print(f"{spec.name}, FMI {fmi}: {run(target, chosen.sequences, chosen.first)}")


if __name__ == "__main__":
    main()
