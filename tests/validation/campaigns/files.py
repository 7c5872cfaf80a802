"""Small campaigns that the tests share."""

from __future__ import annotations

import logging
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

import pytest
from distributed import LocalCluster

from segfmu import cli
from segfmu.cli.console import console
from segfmu.validation.campaigns import cluster, worker
from segfmu.validation.campaigns.result import CampaignResult, load_result
from tests.compiler import require_native
from tests.sharing import shared

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

SEARCH = CAMPAIGN.replace("runs = 40", "runs = 50").replace(
    "[sampling]", 'search = "worst"\nsearch_for = ["follows"]\n\n[sampling]'
)


def completed(factory: pytest.TempPathFactory, name: str, text: str) -> CampaignResult:
    """A campaign's result, uninterrupted on one worker, which all workers of the tests share."""
    require_native()
    folder = shared(
        factory, name, lambda f: run(write(f, text), "-o", f / "out", "--jobs", "1", threads=True)
    )
    return load_result(folder / "out")


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


def called(*words: str | Path, code: int = 0) -> subprocess.CompletedProcess[str]:
    """A command in this process, which spares the start of one."""
    with (
        pytest.MonkeyPatch.context() as patch, pytest.raises(SystemExit) as ended,
        redirect_stdout(StringIO()) as out, redirect_stderr(StringIO()) as errors,
    ):
        patch.setattr(sys, "argv", ["segfmu", *map(str, words)])
        patch.setattr(console, "width", 200)
        cli.main()
    done = subprocess.CompletedProcess(
        sys.argv, int(ended.value.code or 0), out.getvalue(), errors.getvalue()
    )
    assert done.returncode == code, done.stdout + done.stderr
    return done


def run(
    *words: str | Path, code: int = 0, threads: bool = False
) -> subprocess.CompletedProcess[str]:
    """Run `segfmu campaign` in this process; it ends with this exit code.

    threads : whether its workers are threads of this process too.
    """
    if threads:
        with threaded():
            return called("campaign", *words, code=code)
    return called("campaign", *words, code=code)


@contextmanager
def threaded() -> Iterator[None]:
    """Workers of campaigns are threads of this process: each process loads all packages anew."""

    @contextmanager
    def local(jobs: int) -> Iterator[LocalCluster]:
        with LocalCluster(
            n_workers=jobs, threads_per_worker=1, processes=False,
            dashboard_address="127.0.0.1:0",
        ) as found:
            yield found

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cluster, "_local", local)
        # workers are silent for good; this process is none
        patch.setattr(worker, "LOGGER", logging.getLogger("worker"))
        yield
