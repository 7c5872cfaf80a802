"""Every listing in Python of README, docs and docs/howto, run as it is.

Those of docs/importing are run by tests/cosim/test_importing.py.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import pytest

from segfmu import cli
from tests.command import called
from tests.compiler import needs_native

ROOT = Path(__file__).parents[1]
LISTING = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
MOVE = """
import numpy as np
import segfmu
from segfmu import reach_velocity, replan, stop

limits = segfmu.Limits(0.5, 0.5, 2.0, 20.0)
crane = segfmu.Crane(2.2, 1.155, 1.0)
waypoints = [segfmu.Waypoint([0.0, 0.0, -0.5]), segfmu.Waypoint([0.5, 0.3, -0.4])]
trajectory = segfmu.plan(waypoints, limits)
inverse = segfmu.FlatInverse(crane, trajectory)
"""
TABLE = re.search(
    r"^```text\n(.*?)^```$", (ROOT / "docs/howto/csv_path.md").read_text(encoding="utf-8"),
    re.MULTILINE | re.DOTALL,
)[1]
# page -> what its listings take for granted
BEFORE = {
    "README.md": "",
    "docs/control.md": MOVE + (
        "lengths, payloads, lag = [0.2, 0.5], [0.5, 1.0], (0.025, 0.025, 0.025)\n"
    ),
    "docs/cosimulation.md": "",
    "docs/fmus.md": "",
    "docs/howto/csv_path.md": f"from pathlib import Path\nPath('path.csv').write_text({TABLE!r})\n",
    "docs/operator.md": "",
    "docs/planner.md": MOVE + (
        "t, velocity = 0.7, [0.1, 0.0, 0.0]\ntargets = segfmu.Waypoint([0.4, 0.1, -0.5])\n"
    ),
}
# the page whose listings are files of a suite of pytest
OF_PYTEST = "docs/howto/continuous_integration.md"


def listings(page: str) -> list[str]:
    return LISTING.findall((ROOT / page).read_text(encoding="utf-8"))


def test_no_page_is_forgotten() -> None:
    pages = {
        str(path.relative_to(ROOT)) for pattern in ("*.md", "docs/*.md", "docs/howto/*.md")
        for path in ROOT.glob(pattern)
    }
    assert {page for page in pages if listings(page)} == set(BEFORE) | {OF_PYTEST}


@needs_native
@pytest.mark.parametrize("page", BEFORE)
def test_listings_run(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In this process, where warnings are errors too."""
    if "fmus/dist" in "".join(listings(page)):
        cli.app(["build", "-o", str(tmp_path / "fmus" / "dist")], standalone_mode=False)
    code = BEFORE[page] + "\n".join(listings(page))
    monkeypatch.chdir(tmp_path)
    exec(compile(code, page, "exec"), {"__name__": "__main__"})
    plt.close("all")


def commands() -> list[str]:
    """Commands of segfmu in the page on installation, without their comments."""
    text = (ROOT / "docs" / "install.md").read_text(encoding="utf-8")
    return [found.strip() for found in re.findall(r"^    (segfmu [^#\n]*)", text, re.MULTILINE)]


# takes a minute, and is run by tests/validation/test_suite.py
SUITE = "segfmu validate models/scenarios"


@needs_native
def test_commands_run_as_printed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In this process; that the command is there, the tutorial's test shows."""
    (tmp_path / "models").symlink_to(ROOT / "models")
    monkeypatch.chdir(tmp_path)
    assert len(commands()) >= 6 and SUITE in commands()
    for command in commands():
        name, *words = command.split()
        assert name == "segfmu"
        if command != SUITE:
            assert not cli.app(words, standalone_mode=False), command


@needs_native
def test_a_suite_of_pytest_runs(tmp_path: Path) -> None:
    text = "\n".join(listings(OF_PYTEST))
    name = re.findall(r'"(scenarios/gust\.toml)"', text)[0]
    scenario = tmp_path / name
    scenario.parent.mkdir(parents=True)
    gust = (ROOT / "models" / "scenarios" / "gust.toml").as_posix()
    scenario.write_text(f'base = "{gust}"\n', encoding="utf-8")
    plugins, test = re.split(r"(?=^def )", text, flags=re.MULTILINE)
    (tmp_path / "conftest.py").write_text(plugins, encoding="utf-8")
    (tmp_path / "test_crane.py").write_text(test, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(tmp_path)],
        cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False,
    )
    assert "1 passed" in done.stdout, done.stdout + done.stderr


@needs_native
def test_the_controller_of_ones_own_damps_the_sway(tmp_path: Path) -> None:
    folder = tmp_path / "examples" / "own_controller"
    folder.mkdir(parents=True)
    (tmp_path / "models").symlink_to(ROOT / "models")
    for name in ("sway_damper.py", "sway_damper.toml"):
        (folder / name).write_bytes((ROOT / "examples" / "own_controller" / name).read_bytes())
    built = subprocess.run(
        [str(Path(sys.executable).parent / "pythonfmu"), "build", "-f", "sway_damper.py"],
        cwd=folder, capture_output=True, text=True, timeout=300, check=False,
    )
    assert built.returncode == 0, built.stderr

    def verdict() -> str:
        return called("validate", "sway_damper.toml", cwd=folder).stdout

    assert "1 of 1 scenarios as expected" in verdict()
    scenario = folder / "sway_damper.toml"
    text = scenario.read_text(encoding="utf-8")
    assert "gain = 0.4" in text
    scenario.write_text(text.replace("gain = 0.4", "gain = 0.0"), encoding="utf-8")
    assert "0 of 1 scenarios as expected" in verdict()
