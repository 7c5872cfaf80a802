"""Faults that tests have to find: `python -m tests.mutants [WORD...]`.

mutants.toml lists faults: a file of the package, a text that it has once, another text in its
place, and the tests that have to fail for it. Each fault is made in a copy of the package, with
which the tests run; before, the same tests have to pass with the copy as it is. Words choose the
faults whose file or text has one of them. Kernels run interpreted, so that nothing has to be
translated; the step loop in C is compiled again.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
from dataclasses import dataclass
from pathlib import Path

from tests.compiler import CC

ROOT = Path(__file__).parents[1]
PACKAGE = Path("src") / "segfmu"
# of pytest: all passed, some failed
PASSED, FAILED = 0, 1
# s; a loop that a fault makes endless counts as found
LONGEST = 600


@dataclass(frozen=True)
class Mutant:
    """A fault, as mutants.toml has it."""

    file: str
    old: str
    new: str
    tests: str

    @property
    def interpreted(self) -> bool:
        """Whether the tests have to run without the compiled kernels."""
        return self.file.startswith("kernels/")

    def __str__(self) -> str:
        return f"{self.file}: {self.old.strip()!r} -> {self.new.strip()!r}"


def listed(words: list[str]) -> list[Mutant]:
    """The faults that have one of the words; all without words."""
    table = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
    every = [Mutant(**{"new": "", **entry}) for entry in table["mutant"]]
    return [m for m in every if not words or any(w in str(m) for w in words)]


def outcome(copy: Path, mutant: Mutant) -> int:
    """What pytest returns for the tests of a fault with a copy of the package."""
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider"]
    own = {
        "PYTHONPATH": str(copy / "src"), "PYTHONDONTWRITEBYTECODE": "1",
        "SEGFMU_CACHE": str(copy / "cache"),
    }
    if mutant.interpreted:
        own["SEGFMU_INTERPRETED"] = "1"
    try:
        done = subprocess.run(
            [*command, *shlex.split(mutant.tests)], cwd=ROOT, env=os.environ | own, timeout=LONGEST,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False,
        )
    except subprocess.TimeoutExpired:
        return FAILED
    return done.returncode


def compiled(copy: Path, mutant: Mutant) -> None:
    """Compile the step loop of a copy, where the fault is in it."""
    folder = copy / PACKAGE / "cosim"
    if mutant.file.startswith("cosim/c/"):
        subprocess.run(
            [CC, "-std=c99", "-O2", "-ffp-contract=off", "-w", "-shared", "-fPIC",
             "-DPy_LIMITED_API=0x030B0000", "-I", sysconfig.get_path("include"),
             *sorted((folder / "c").glob("*.c")), "-o", next(folder.glob("_loop*"))], check=True,
        )


def is_found(copy: Path, mutant: Mutant) -> bool:
    """Whether the tests of a fault fail for it."""
    path = copy / PACKAGE / mutant.file
    sound = path.read_text(encoding="utf-8")
    if sound.count(mutant.old) != 1:
        raise SystemExit(f"{mutant}: the text is there {sound.count(mutant.old)} times, not once")
    try:
        path.write_text(sound.replace(mutant.old, mutant.new), encoding="utf-8")
        compiled(copy, mutant)
        return outcome(copy, mutant) == FAILED
    finally:
        path.write_text(sound, encoding="utf-8")
        compiled(copy, mutant)


def main(words: list[str]) -> int:
    """Try the faults; returns how many were not found."""
    mutants = listed(words)
    survived, sound = 0, set()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder)
        shutil.copytree(ROOT / "src", copy / "src", ignore=shutil.ignore_patterns("__pycache__"))
        for mutant in mutants:
            way = mutant.tests, mutant.interpreted
            if way not in sound and outcome(copy, mutant) != PASSED:
                raise SystemExit(f"{mutant.tests} do not pass without a fault")
            sound.add(way)
            found = is_found(copy, mutant)
            survived += not found
            print("found   " if found else "SURVIVED", mutant, flush=True)
    print(f"{len(mutants)} faults, {survived} survived")
    return survived


if __name__ == "__main__":
    sys.exit(min(main(sys.argv[1:]), 1))
