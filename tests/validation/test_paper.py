"""The paper's figures by one command."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from segfmu.cli import app
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.paper import MISSION, PHASES, profile
from tests.compiler import needs_native
from tests.tables import columns


@needs_native
def test_the_command_writes_figures_and_a_mission_that_runs(tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["paper", "--output", str(tmp_path)])
    assert done.exit_code == 0, done.output
    for number in (3, 6, 7):
        assert (tmp_path / f"figure_{number}.png").read_bytes().startswith(b"\x89PNG")
        assert f"figure_{number}.png" in done.output
    assert load_mission(tmp_path / "paper_rig.toml") == load_mission(MISSION)
    rows = columns(tmp_path / "run.csv")
    error = rows["load.position.x"] - rows["reference.load.position.x"]
    assert 0.0 < np.abs(error).max() < 0.002
    assert rows["load.position.x"][-1] == pytest.approx(1.0, abs=0.002)


def test_the_profile_has_all_phases() -> None:
    _, lengths, coefficients = profile().pieces(0)
    assert len(lengths) == len(PHASES) and (lengths > 0.0).all()
    # an acceleration that is constant in I.c, c and II.c, and not in between
    constant = np.abs(coefficients[:, 3:]).max(axis=1) < 1e-12
    assert constant.tolist() == [False, True, False, True, False, True, False]


def test_the_mission_is_that_of_the_paper() -> None:
    mission = load_mission(MISSION)
    trajectory = mission.plan()
    assert trajectory.shape == "smoothstep" and trajectory.smoothness == 4
    at = float(trajectory.waypoint_times[1])
    expected = np.array([[0.07, 0.055], [0.2, 0.17], [0.34, 0.27]])
    found = np.array([trajectory(at, order)[:2] for order in range(3)])
    assert np.allclose(found, expected, atol=1e-9)
    limits = np.array([[1.0, 0.4], [1.0, 0.5], [1.0, 0.5]])
    for order in range(1, 4):
        least, most = trajectory.extrema(order)
        assert (np.maximum(-least, most)[:2] <= limits[order - 1] * (1.0 + 1e-9)).all()
