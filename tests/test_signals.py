"""Ctrl-C and SIGTERM at any time: one line, the right code, and nothing left behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.campaign import campaign
from tests.compiler import needs_native

pytestmark = pytest.mark.skipif(
    not Path("/proc/self/status").exists(), reason="needs /proc to see when to stop"
)
MISSION = Path(__file__).parents[1] / "models" / "inteco.toml"
CODES = {
    signal.SIGINT: (130, "segfmu: interrupted\n"), signal.SIGTERM: (143, "segfmu: terminated\n"),
}


# the command where no binaries come with the package, as in a checkout
COMPILING = """
from segfmu.__main__ import main
from segfmu.fmu.native import binaries

binaries._packaged = lambda platform: {}
main()
"""


def started(folder: Path, *words: str, compiling: bool = False) -> subprocess.Popen[str]:
    """The command, from when its first line has run."""
    command = [Path(sys.executable).with_name("segfmu")]
    if compiling:
        command = [sys.executable, "-c", COMPILING]
    places = {"TMPDIR": str(folder / "temporary")}
    if compiling:
        places["SEGFMU_CACHE"] = str(folder / "cache")
    (folder / "temporary").mkdir(exist_ok=True)
    process = subprocess.Popen(
        [*command, *words], text=True, cwd=folder,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=os.environ | places,
    )
    caught = 1 << (signal.SIGTERM - 1)
    deadline = time.monotonic() + 60.0
    while not int(_status(process.pid, "SigCgt"), 16) & caught:
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.001)
    return process


def _status(pid: int, name: str) -> str:
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith(f"{name}:"):
            return line.split()[1]
    return "0"


def stopped(process: subprocess.Popen[str], number: signal.Signals) -> bool:
    """Stop a process; whether it was still running. It must say one line and nothing else."""
    process.send_signal(number)
    _, error = process.communicate(timeout=60)
    if process.returncode in (0, 1):
        assert error == ""
        return False
    assert (process.returncode, error) == CODES[number]
    return True


@pytest.mark.parametrize("number", CODES, ids=lambda n: n.name)
@pytest.mark.parametrize("delay", [0.0, 0.03, 0.1, 0.2])
def test_while_it_starts(number: signal.Signals, delay: float, tmp_path: Path) -> None:
    process = started(tmp_path, "plan", str(MISSION), "-o", "out")
    time.sleep(delay)
    stopped(process, number)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> float:
    """How long a run takes [s]; it compiles the binaries if no test did."""
    folder = tmp_path_factory.mktemp("whole")
    began = time.monotonic()
    process = started(folder, "simulate", str(MISSION), "-o", "out", "--step", "0.005")
    _, error = process.communicate(timeout=300)
    assert (process.returncode, error) == (0, "")
    assert not list((folder / "temporary").iterdir())
    return min(time.monotonic() - began, 4.0)


@pytest.mark.parametrize("number", CODES, ids=lambda n: n.name)
@campaign(2, 12, "parts")
def test_while_it_builds_and_simulates(
    number: signal.Signals, parts: int, whole: float, tmp_path: Path
) -> None:
    """Temporary folders go, wherever it is; half-written files are not left."""
    caught = 0
    for part in range(parts):
        process = started(tmp_path, "simulate", str(MISSION), "-o", f"out{part}", "--step", "0.005")
        # both signals together at twice as many times
        time.sleep((part + 0.5 * (number == signal.SIGTERM)) / parts * 0.9 * whole)
        caught += stopped(process, number)
        assert not list((tmp_path / "temporary").iterdir())
        left = (tmp_path / f"out{part}").glob("*")
        assert {p.name for p in left} <= {
            "GantryFeedforward.fmu", "GantryCrane.fmu", "run.csv", "run.png", "report.html",
        }
    assert caught >= max(1, parts // 3)


@needs_native
def test_while_it_compiles(tmp_path: Path) -> None:
    process = started(tmp_path, "build", "-o", "out", compiling=True)
    deadline = time.monotonic() + 60.0
    while not list((tmp_path / "temporary").glob("segfmu_*")):
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.005)
    assert stopped(process, signal.SIGTERM)
    assert not list((tmp_path / "temporary").iterdir())
    assert not list((tmp_path / "out").glob("*"))
