"""Small campaigns that the tests share."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

MODELS = Path(__file__).parents[3] / "models"
SCENARIO = f"""
name = "s"
mission = "{(MODELS / "inteco.toml").as_posix()}"
step = 0.01
coupling = "sequential"
crane.drive = "velocity"
simulation.settle = 1.0

[[criteria]]
name = "follows"
signal = "error.load.norm"
bound = 0.02

[[criteria]]
name = "rests"
kind = "settled"
signal = "sway.total"
bound = 0.01
"""
CAMPAIGN = """
name = "c"
scenarios = ["s.toml"]

[sampling]
kind = "latin hypercube"
runs = 40
seed = 3

[[factors]]
name = "sway"
key = "simulation.initial_sway.0"
range = [0.0, 1.0]

[[factors]]
name = "payload"
key = "true_crane.payload_mass"
range = [0.5, 1.5]
relative = true

[[factors]]
name = "design"
key = "controller.design"
values = ["lqr", "flatness"]
"""


def write(folder: Path, campaign: str = CAMPAIGN, scenario: str = SCENARIO) -> Path:
    """Write a campaign and its scenario; returns the campaign's file."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "s.toml").write_text(scenario, encoding="utf-8")
    path = folder / "c.toml"
    path.write_text(campaign, encoding="utf-8")
    return path


def command(*words: str | Path) -> list[str]:
    """The command `segfmu campaign` as a process."""
    return [sys.executable, "-m", "segfmu", "campaign", *map(str, words)]


def run(*words: str | Path, code: int = 0) -> subprocess.CompletedProcess[str]:
    """Run `segfmu campaign`; it ends with this exit code."""
    done = subprocess.run(
        command(*words), capture_output=True, text=True, timeout=300,
        env={**os.environ, "COLUMNS": "200"},
    )
    assert done.returncode == code, done.stdout + done.stderr
    return done
