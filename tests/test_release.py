"""The package as its users get it: versions, the wheel, and what the commands load."""

from __future__ import annotations

import subprocess
import sys
import sysconfig
from importlib.metadata import distributions, metadata, version
from importlib.util import find_spec
from pathlib import Path

import pytest
from packaging.specifiers import SpecifierSet

import segfmu
from segfmu.fmu.native.compilers import available
from tests import release
from tests.compiler import CC, compiled_kernels, needs_cc, needs_native

ROOT = Path(__file__).parents[1]
MISSION = ROOT / "models" / "paper.toml"

# Runs the command line where some packages cannot be imported.
BLOCKED = """
import sys


class Blocked:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {packages!r}:
            raise ModuleNotFoundError(f"No module named {{name!r}}: blocked by a test")
        return None


sys.meta_path.insert(0, Blocked())
sys.argv = ["segfmu", *{words!r}]
{before}
from segfmu.cli import main

main()
"""
# an archive is compiled without optimisation, in a fifth of the time
PLAIN = """
from segfmu.fmu.native import compilers

compilers.OPTIONS = tuple("-O0" if o == "-O3" else o for o in compilers.OPTIONS)
"""
HEAVY = ("sympy", "pyccel", "pythonfmu", "fmpy", "matplotlib")


def run_without(
    packages: tuple[str, ...], *words: str, before: str = ""
) -> subprocess.CompletedProcess[str]:
    """Run `segfmu` in a process where these packages are not installed, after some code."""
    code = BLOCKED.format(packages=set(packages), words=[str(w) for w in words], before=before)
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=300, cwd=ROOT
    )


def test_version_is_that_of_the_package() -> None:
    assert segfmu.__version__ == version("segfmu")
    shown = run_without(HEAVY, "--version")
    assert (shown.returncode, shown.stdout) == (0, f"segfmu {segfmu.__version__}\n")


def test_the_test_can_block_a_package() -> None:
    failed = run_without(("numpy",), "plan", str(MISSION))
    assert failed.returncode != 0 and "blocked by a test" in failed.stderr


def test_plan_needs_nothing_heavy() -> None:
    planned = run_without(HEAVY, "plan", str(MISSION))
    assert planned.returncode == 0, planned.stderr
    assert "velocity" in planned.stdout


@needs_native
def test_native_build_needs_nothing_heavy(tmp_path: Path) -> None:
    words = ("build", str(MISSION), "--fmi", "3", "-o", str(tmp_path))
    built = run_without(HEAVY, *words, before=PLAIN)
    assert built.returncode == 0, built.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "GantryCrane.fmu", "GantryFeedforward.fmu"
    ]


def test_python_build_needs_pythonfmu_alone(tmp_path: Path) -> None:
    others = tuple(n for n in HEAVY if n != "pythonfmu")
    built = run_without(others, "build", "--backend", "python", "-o", str(tmp_path))
    assert built.returncode == 0, built.stderr


def test_plots_need_matplotlib_alone(tmp_path: Path) -> None:
    others = tuple(n for n in HEAVY if n != "matplotlib")
    planned = run_without(others, "plan", str(MISSION), "-o", str(tmp_path))
    assert planned.returncode == 0, planned.stderr
    assert (tmp_path / "plan.png").exists()


@needs_native
def test_simulation_needs_neither_sympy_nor_pythonfmu(tmp_path: Path) -> None:
    done = run_without(
        ("sympy", "pyccel", "pythonfmu"), "simulate", str(MISSION), "-o", str(tmp_path)
    )
    assert done.returncode == 0, done.stderr + done.stdout


@pytest.mark.skipif(
    not CC or not (Path(sysconfig.get_path("include")) / "Python.h").exists(),
    reason="no C compiler, or no headers of Python",
)
@pytest.mark.parametrize("module", ["segfmu.kernels._compiled", "segfmu.cosim._loop"])
def test_where_a_compiler_is_the_extensions_are_there(module: str) -> None:
    # tests that need them are skipped without them, which must not hide a failed build
    assert find_spec(module) is not None


@needs_cc
def test_where_a_compiler_is_native_fmus_can_be_built() -> None:
    # `needs_native` skips tests of binaries, which must not hide that none can be made
    assert available()


def test_the_compiled_kernels_are_one_binary_for_all_versions_of_python() -> None:
    compiled = compiled_kernels()
    if sys.platform != "win32":
        assert Path(compiled.__file__).name == "_compiled.abi3.so"


def test_locked_packages_are_for_the_oldest_python_too() -> None:
    """Of those that are installed here; one was for Python 3.11.5 and newer."""
    oldest = f"{metadata('segfmu')['Requires-Python'].removeprefix('>=')}.0"
    locked = dict(
        line.split("==") for line in (ROOT / "requirements-dev.lock").read_text().splitlines()
    )
    newer = [
        f"{package.name} {package.version}" for package in distributions()
        if locked.get(package.name) == package.version
        and not SpecifierSet(package.metadata.get("Requires-Python", "")).contains(oldest)
    ]
    assert locked and not newer


def test_every_file_states_the_same_version() -> None:
    assert set(release.places().values()) == {release.version()}


def test_a_release_with_entries_left_over_is_refused(monkeypatch, tmp_path: Path) -> None:
    for name in (*release.PLACES, "pyproject.toml"):
        target = tmp_path / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes((ROOT / name).read_bytes())
    monkeypatch.setattr(release, "ROOT", tmp_path)
    log = tmp_path / "CHANGELOG.md"
    ready = f"## [Unreleased]\n\n## [{release.version()}] - 2026-01-02\n\n- All of it.\n"
    log.write_text(ready, encoding="utf-8")
    assert release.faults() == []
    log.write_text(ready.replace("[Unreleased]\n", "[Unreleased]\n\n- More.\n"), encoding="utf-8")
    assert release.faults() == ["CHANGELOG.md has entries under [Unreleased]"]
    log.write_text("## [9.9.9] - 2026-01-02\n\n- Another.\n", encoding="utf-8")
    assert "no section" in release.faults()[0]
