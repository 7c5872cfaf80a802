"""The native FMUs' sources on other platforms: `python -m tests.fmu.native.foreign`.

The random call sequences of fuzz.py are compiled with ziglang for Windows and Arm, and run under
Wine and qemu where these are installed; a line says where they are not. The binaries of archives
are run by platforms.py.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

from tests.fmu.native.fuzz import DRIVERS, SPECS, written

# name -> target of zig, its options, and what runs the program
PLATFORMS = {
    "x86_64-windows": ("x86_64-windows-gnu", (), "wine"),
    "aarch64-linux": ("aarch64-linux-musl", ("-static",), "qemu-aarch64"),
}
SEQUENCES = "2000"


def program(target: str, options: tuple[str, ...], fmi: int, index: int, folder: Path) -> Path:
    """Compile the driver of a version with all sources of an FMU for a platform."""
    spec = SPECS[index]
    place = folder / f"{target}-{spec.name}{fmi}"
    place.mkdir()
    written(spec, fmi, place)
    built = place / "fuzz.exe"
    subprocess.run(
        [sys.executable, "-m", "ziglang", "cc", "-target", target, "-std=c99", "-O1", "-w",
         "-ffp-contract=off", *options, f"-I{place}", f"-I{DRIVERS}", DRIVERS / f"fuzz{fmi}.c",
         "-lm", "-o", built],
        check=True,
    )
    return built


def main() -> None:
    """Every platform with both FMUs, each in one version."""
    if find_spec("ziglang") is None:
        raise SystemExit("not run: ziglang compiles for other platforms; install segfmu[platforms]")
    with tempfile.TemporaryDirectory() as work:
        for name, (target, options, runner) in PLATFORMS.items():
            for fmi, index in ((2, 1), (3, 0)):
                built = program(target, options, fmi, index, Path(work))
                if shutil.which(runner) is None:
                    print(f"{name}, {SPECS[index].name}: compiled, not run: no {runner}")
                    continue
                done = subprocess.run(
                    [runner, built, SEQUENCES, "1", str(built.parent)], capture_output=True,
                    text=True, check=False,
                )
                if done.returncode != 0:
                    raise SystemExit(f"{name}, {SPECS[index].name}: {done.stdout}{done.stderr}")
                print(f"{name}, {SPECS[index].name}: {done.stdout.strip()}")


if __name__ == "__main__":
    main()
