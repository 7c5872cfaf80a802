"""Plots where the user's choices for Matplotlib do not fit."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

PLOTS = """
import os, sys
from pathlib import Path
from segfmu import Clearance, Limits, Waypoint, plan
from segfmu.validation import suite_plots
from segfmu.validation.plots.path import plot_path
from segfmu.validation.plots.plan import plot_plan
from segfmu.validation.plots.style import save

motion = plan([Waypoint([0.0, 0.0, -2.0]), Waypoint([1.0, 0.0, -2.0])], Limits(1.0, 1.0, 5.0))
save(plot_plan(motion, "$a_1$"), Path("plan.png"))
save(plot_path(motion, "$a_1$", Clearance([])), Path("path.png"))
from matplotlib import rcParams
print(rcParams._get("backend") == os.environ["MPLBACKEND"])
"""


def plotted(
    folder: Path, backend: str, choices: bytes = b""
) -> subprocess.CompletedProcess[str]:
    (folder / "matplotlibrc").write_bytes(choices)
    places = {"MPLBACKEND": backend, "MATPLOTLIBRC": str(folder), "PATH": str(folder)}
    return subprocess.run(
        [sys.executable, "-c", PLOTS], cwd=folder, env=os.environ | places, text=True,
        capture_output=True, check=False,
    )


@pytest.mark.parametrize(("backend", "choices", "known"), [
    ("nonsense", b"", False), ("svg", b"backend: nonsense\ntext.usetex: True\n", True),
])
def test_plots_need_neither_a_known_backend_nor_latex(
    tmp_path: Path, backend: str, choices: bytes, known: bool
) -> None:
    done = plotted(tmp_path, backend, choices)
    assert done.returncode == 0, done.stderr
    assert {path.name for path in tmp_path.glob("*.png")} == {"plan.png", "path.png"}
    # later figures of the user have the backend that was asked for
    assert done.stdout.split() == [str(known)]


def test_choices_that_cannot_be_read_are_one_error(tmp_path: Path) -> None:
    done = plotted(tmp_path, "agg", b"backend: \xff\n")
    assert "InputError: Matplotlib cannot read its file matplotlibrc: " in done.stderr
    assert "0xff in position 9" in done.stderr and "MATPLOTLIBRC" in done.stderr
