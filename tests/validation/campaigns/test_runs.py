"""Campaigns as commands: the same table whatever happens on the way."""

from __future__ import annotations

import logging
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from xml.etree import ElementTree

import distributed
import pyarrow
import pyarrow.parquet
import pytest

import segfmu
from segfmu import cli
from segfmu.errors import InputError
from segfmu.validation.campaigns import cluster, worker
from segfmu.validation.campaigns.campaign import Run, load_campaign
from segfmu.validation.campaigns.replay import write_run
from segfmu.validation.campaigns.result import CampaignResult, load_result
from segfmu.validation.campaigns.store import Store
from segfmu.validation.files.scenario_file import Source, load_scenario
from segfmu.validation.suite import Runner
from tests.campaign import SOAK, soaked
from tests.compiler import require_native
from tests.cosim.probe.build import build
from tests.validation.campaigns.files import (
    CAMPAIGN,
    SCENARIO,
    SEARCH,
    called,
    command,
    completed,
    run,
    threaded,
    write,
)

ROOT = Path(__file__).parents[3]
RUNS = 40


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> CampaignResult:
    """A campaign that nothing interrupted."""
    return completed(tmp_path_factory, "campaign", CAMPAIGN)


def test_every_run_is_that_of_its_scenario_file(whole: CampaignResult, tmp_path: Path) -> None:
    campaign = load_campaign(whole.folder.parent / "c.toml")
    assert whole.column("run") == list(range(40))
    paths = {
        number: write_run(tmp_path, campaign, campaign.runs[number]) for number in (0, 17, 39)
    }
    with Runner() as runner:
        results = {number: runner.run(load_scenario(path)) for number, path in paths.items()}
    for number, found in results.items():
        for finding in found.findings:
            assert whole.column(f"margin.{finding.name}")[number] == finding.margin
            assert whole.column(f"holds.{finding.name}")[number] is finding.passed
        assert whole.column("passed")[number] is found.passed
        assert whole.column("arrival")[number] == found.known["arrival"]
        scenario = load_scenario(paths[number])
        assert scenario.mission.simulation.initial_sway[0] == whole.column("sway")[number]
        assert scenario.mission.crane.controller.design == whole.column("design")[number]


def test_the_same_seed_gives_the_same_table(whole: CampaignResult, tmp_path: Path) -> None:
    run(write(tmp_path), "-o", tmp_path / "out", "--jobs", "2")
    same = load_result(tmp_path / "out").table
    assert same.equals(whole.table) and same.schema == whole.table.schema
    other = load_campaign(write(tmp_path / "4", CAMPAIGN.replace("seed = 3", "seed = 4")))
    samples = [run.sample["sway"] for run in other.runs]
    assert len(samples) == 40 and samples != whole.column("sway")


def test_the_worst_run_is_told_and_its_command_shows_it(
    whole: CampaignResult, tmp_path: Path
) -> None:
    out = whole.folder
    (worst, *_) = whole.summaries
    margins = whole.column("margin.follows")
    assert worst.worst == min(margins) and margins[worst.run or 0] == worst.worst
    # a complete campaign is shown again without a run
    again = run(out.parent / "c.toml", "-o", out)
    told = re.findall(r"^segfmu (validate \S+)$", again.stdout, re.MULTILINE)
    assert f"validate {out / f'run_{worst.run}.toml'}" in told
    assert f"{worst.worst:+.4g}" in called(*told[0].split()).stdout


def test_the_sway_at_the_start_is_what_counts(whole: CampaignResult) -> None:
    (first, *_) = whole.sensitivities
    assert (first.criterion, first.factor, first.signed) == ("follows", "sway", True)
    assert first.effect < -0.9 and first.chance < 1e-6


def test_the_call_in_python_has_what_the_command_has(
    whole: CampaignResult, tmp_path: Path
) -> None:
    out = Path(shutil.copytree(whole.folder, tmp_path / "out"))
    for path in out.glob("run_*.toml"):
        path.unlink()
    told = []
    found = segfmu.campaign(
        whole.folder.parent / "c.toml", out, jobs=1, progress=lambda what, _: told.append(what)
    )
    assert found.table.equals(whole.table) and "runs" in told
    case = found.worst("rests")
    assert case.margin == min(whole.column("margin.rests"))
    assert case.factors["sway"] == whole.column("sway")[case.run]
    assert load_scenario(out / f"run_{case.run}.toml").mission.crane.payload_mass > 0.0
    table = found.to_pandas()
    assert table.loc[case.run, "margin.rests"] == case.margin and len(table) == 40
    assert len(found.plot().axes) == 4
    assert found.report(tmp_path / "report.html").stat().st_size > 1e6
    passed = sum(whole.column("passed"))
    assert repr(found) == f"<CampaignResult 'c': {passed} of 40 runs passed>"
    with pytest.raises(InputError, match="no criterion 'rest'; they are follows, rests"):
        found.worst("rest")


def test_junit_and_a_comparison_of_the_command(
    whole: CampaignResult, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = Path(shutil.copytree(whole.folder, tmp_path / "out"))
    junit = tmp_path / "junit.xml"
    cli.app(
        ["campaign", str(whole.folder.parent / "c.toml"), "-o", str(out), "--junit", str(junit),
         "--against", str(whole.folder)],
        standalone_mode=False,
    )
    assert "follows: margin 0 (0 to 0) m, no difference told" in capsys.readouterr().out
    suite = ElementTree.parse(junit).getroot().find("testsuite")
    assert (suite.get("name"), suite.get("tests"), suite.get("errors")) == ("c", "2", "0")
    for row, test in zip(whole.summaries, suite, strict=True):
        told = test.find("failure") if row.held < row.judged else test.find("system-out")
        text = told.get("message") or told.text
        assert text.startswith(f"{row.held} of 40 runs hold it; fails (95 %): {row.fails}; least")
        assert test.get("name") == row.criterion and f"in run {row.run}: sway" in text


# the command, which does something at a given place of the campaign, however fast runs are made
DRIVER = """
import os, signal, sys
from contextlib import nullcontext
sys.path.append({root!r})
from segfmu.cli.app import main
from segfmu.validation.campaigns.store import Store

from tests.validation.campaigns.files import threaded

add, came = Store.add, 0

def adds(self, outcomes):
    global came
    outcomes = list(outcomes)
    add(self, outcomes)
    before, came = came, came + len(outcomes)
    {action}

if __name__ == "__main__":
    Store.add = adds
    with {workers}():
        main()
"""
# a third is written; what comes next is lost with the process
KILLED = """
    if before >= {count}:
        os.kill(os.getpid(), signal.SIGKILL)
    if came >= {count}:
        self.flush()
"""
# some runs are written
HELD = """
    self.flush()
    os.kill(os.getpid(), signal.SIGSTOP)
"""


def driver(folder: Path, action: str, *words: str | Path, threads: bool = False) -> list[str]:
    """`segfmu campaign` with something that happens on the way.

    threads : whether its workers are threads of its process.
    """
    script = folder / "driver.py"
    text = DRIVER.format(
        action=action, root=str(ROOT), workers="threaded" if threads else "nullcontext"
    )
    script.write_text(text, encoding="utf-8")
    _, _, _, _, *own = command(*words)
    return [sys.executable, str(script), "campaign", *own]


def driven(words: list[str]) -> subprocess.Popen[str]:
    return subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def rows(out: Path) -> int:
    return sum(pyarrow.parquet.read_metadata(p).num_rows for p in (out / "parts").glob("*.parquet"))


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGKILL")
# tests/validation/campaigns/test_search.py interrupts searches in a process that goes on
@pytest.mark.parametrize("name", ["campaign", *soaked("search")])
def test_a_killed_campaign_goes_on_where_it_was(
    name: str, tmp_path_factory: pytest.TempPathFactory, tmp_path: Path
) -> None:
    text, most = (CAMPAIGN, "40") if name == "campaign" else (SEARCH, "at most 50")
    whole = completed(tmp_path_factory, name, text)
    runs = whole.table.num_rows
    path, out = write(tmp_path, text), tmp_path / "out"
    action = KILLED.format(count=runs // 3)
    # workers that are processes are in other tests
    words = driver(tmp_path, action, path, "-o", out, "--jobs", "2", threads=True)
    with driven(words) as first:
        said = first.communicate(timeout=300)
    assert first.returncode == -signal.SIGKILL, said
    before = {p: p.read_bytes() for p in (out / "parts").glob("*.parquet")}
    kept = rows(out)
    assert runs // 3 <= kept < runs
    done = run(path, "-o", out, "--jobs", "1", threads=True)
    assert f"{kept} of {most} runs were there" in done.stdout
    assert before and load_result(out).table.equals(whole.table)
    assert (out / "runs.parquet").read_bytes() == (whole.folder / "runs.parquet").read_bytes()


@pytest.fixture
def scheduler(tmp_path: Path) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    """Address of a scheduler with two workers, each a process started by hand, and these."""
    processes: list[subprocess.Popen[bytes]] = []
    with distributed.LocalCluster(
        n_workers=0, host="127.0.0.1", protocol="tcp", processes=False,
        dashboard_address="127.0.0.1:0",
    ) as cluster:
        try:
            processes += [
                subprocess.Popen(
                    [sys.executable, "-m", "dask", "worker", cluster.scheduler_address,
                     "--nthreads", "1", "--no-nanny", "--no-dashboard", "--local-directory",
                     str(tmp_path / str(i))],
                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=tmp_path,
                )
                for i in range(2)
            ]
            yield cluster.scheduler_address, processes
        finally:
            for one in processes:
                one.kill()
                one.wait()


def test_a_worker_that_is_killed_loses_nothing(
    whole: CampaignResult, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    scheduler: tuple[str, list[subprocess.Popen[bytes]]],
) -> None:
    path, out = write(tmp_path), tmp_path / "out"
    address, workers = scheduler
    add, came = Store.add, 0

    def adds(self: Store, outcomes: Iterable[tuple[Run, worker.Outcome]]) -> None:
        nonlocal came
        own = list(outcomes)
        add(self, own)
        before, came = came, came + len(own)
        if before < RUNS // 6 <= came:
            workers[0].kill()

    monkeypatch.setattr(Store, "add", adds)
    run(path, "-o", out, "--scheduler", address)
    assert came == RUNS and load_result(out).table.equals(whole.table)
    assert workers[0].wait() == -signal.SIGKILL and workers[1].poll() is None


def test_no_scheduler_is_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of a process: the packages below may write too. None that is there answers within 0.5 s."""
    monkeypatch.setattr(cluster, "ANSWER", 0.5)
    code = (
        "from segfmu.validation.campaigns import cluster; cluster.ANSWER = 0.5\n"
        "from segfmu.cli.app import main; main()"
    )
    words = ["campaign", str(write(tmp_path)), "-o", str(tmp_path / "out"), "--scheduler"]
    address = "tcp://127.0.0.1:1"
    with driven([sys.executable, "-c", code, *words, address]) as first:
        _, told = first.communicate(timeout=300)
    assert first.returncode == 2
    assert told.count("\n") == 1 and f"--scheduler {address}" in told
    done = called(*words, "nonsense", code=2)
    assert done.stderr.count("\n") == 1 and "--scheduler nonsense" in done.stderr


# runs that fail beside those that do not
FAILING = """
[[fmus]]
name = "probe"
path = "{path}"
connections = [["probe", "y", "GantryCrane", "wind.z"]]
[fmus.values]
gain = 0.0
"fail.time" = 1.0
"""
FAILURES = """
name = "failing"
scenarios = ["s.toml"]
sampling.kind = "one at a time"

[[factors]]
name = "status"
key = "fmus.probe.values.fail.status"
values = {statuses}

[[factors]]
name = "step"
key = "parameters.GantryCrane.crane.payload_mass"
values = [1.0, 1e300]

[[factors]]
name = "speed"
key = "limits.x.velocity"
values = [0.22, 0.21]
"""


# test_names.py has one that dies
@pytest.mark.parametrize("statuses", [[0, 3], *soaked([0, 3, 99])])
def test_runs_that_fail_are_rows_with_their_error(
    statuses: list[int], whole: CampaignResult, tmp_path: Path
) -> None:
    probe = build(tmp_path, 2)
    scenario = SCENARIO + FAILING.format(path=probe.as_posix())
    path = write(tmp_path, FAILURES.format(statuses=statuses), scenario)
    done = run(path, "-o", tmp_path / "out", "--jobs", "1", code=1, threads=99 not in statuses)
    result = load_result(tmp_path / "out")
    errors = dict(result.errors)
    count = len(statuses)
    assert set(errors) == {2, *([3] if count > 2 else []), count + 2}
    assert "told to fail" in errors[2] and "died" in errors.get(3, "died")
    assert "check setpoints, wind, masses and friction" in errors[count + 2]
    assert result.column("status") == [None, *statuses, *[None] * 4]
    assert not any(result.column("passed")[number] for number in errors)
    assert all(f"run {number}: " in done.stdout for number in errors)
    judged = [margin is not None for margin in result.column("margin.follows")]
    assert judged == [number not in errors for number in range(count + 5)]


@pytest.mark.soak
@pytest.mark.skipif(not SOAK, reason="takes the time limit of a run; make soak waits for it")
def test_a_run_that_hangs_costs_itself_alone(tmp_path: Path) -> None:
    require_native()
    scenario = SCENARIO + FAILING.format(path=build(tmp_path, 2).as_posix())
    campaign = FAILURES.format(statuses=[0, 98]).replace('"failing"', '"hanging"\ntimeout = 20')
    path = write(tmp_path, campaign, scenario)
    done = run(path, "-o", tmp_path / "out", "--jobs", "1", code=1)
    errors = dict(load_result(tmp_path / "out").errors)
    assert set(errors) == {2, 4} and errors[2] == "did not end within timeout = 20 s"
    assert f"run 2: {errors[2]}" in done.stdout


def test_a_worker_gives_up_at_the_run_that_hangs(monkeypatch: pytest.MonkeyPatch) -> None:
    def make(_: Runner, __: Source, order: worker.Order) -> worker.Outcome:
        if order.number == 1:
            time.sleep(1.0)
        return worker.Outcome(order.number, passed=True)

    monkeypatch.setattr(worker, "_made", make)
    # workers are silent for good; this process is none
    monkeypatch.setattr(worker, "LOGGER", logging.getLogger("worker"))
    orders = [worker.Order(number, 0, {}) for number in range(3)]
    outcomes, _ = worker.perform([Source(Path("s.toml"), {})], orders, 0.2)
    assert [(o.number, o.passed, o.hung) for o in outcomes] == [(0, True, False), (1, False, True)]
    # what comes next has FMUs of its own
    assert not worker._runners
    again, _ = worker.perform([Source(Path("s.toml"), {})], orders[:1], None)
    assert again[0].passed
    worker.release()


def test_two_campaigns_in_one_folder(tmp_path: Path) -> None:
    require_native()
    path, out = write(tmp_path), tmp_path / "out"
    words = driver(tmp_path, HELD, path, "-o", out, "--jobs", "1", threads=True)
    with driven(words) as first:
        # it must not come to its end before the other one begins
        _, status = os.waitpid(first.pid, os.WUNTRACED)
        assert os.WIFSTOPPED(status)
        second = run(path, "-o", out, code=2)
        first.kill()
    assert second.stderr.count("\n") == 1
    assert "another campaign is running in this folder" in second.stderr
    assert rows(out) >= 1
    other = write(tmp_path / "other", CAMPAIGN.replace("seed = 3", "seed = 4"))
    third = run(other, "-o", out, code=2)
    assert third.stderr.count("\n") == 1 and "results of another campaign" in third.stderr


def test_a_folder_that_is_removed_meanwhile(tmp_path: Path) -> None:
    """What came later was written into a new folder, and passed for the whole campaign."""
    require_native()
    path, out = write(tmp_path), tmp_path / "out"

    def remove(what: str, share: float) -> None:
        if what == "runs":
            shutil.rmtree(out, ignore_errors=True)

    with threaded(), pytest.raises(InputError, match=r"campaign\.json: was written and is gone"):
        segfmu.campaign(path, out, jobs=1, progress=remove)
    assert not out.exists()


def in_namespace(script: str) -> subprocess.CompletedProcess[str]:
    """A shell that may mount file systems."""
    return subprocess.run(
        ["unshare", "-rm", "sh", "-c", script], capture_output=True, text=True, timeout=300
    )


needs_mounts = pytest.mark.skipif(
    not shutil.which("unshare") or in_namespace("mount -t tmpfs none /mnt").returncode != 0,
    reason="this system lets nobody mount file systems",
)


@needs_mounts
def test_a_disk_that_fills_up(whole: CampaignResult, tmp_path: Path) -> None:
    path, out, kept = write(tmp_path), tmp_path / "out", tmp_path / "kept"
    out.mkdir()
    words = " ".join(driver(tmp_path, "pass", path, "-o", out, "--jobs", "1", threads=True))
    # room for the first files alone; what was written is looked at before the mount is gone
    done = in_namespace(
        f"mount -t tmpfs -o size=12k none {out} && {words}; echo $?; cp -r {out} {kept}"
    )
    assert done.stdout.split()[-1] == "2"
    assert done.stderr.count("\n") == 1 and "No space left on device" in done.stderr
    # with room, the campaign goes on from there
    assert not list(kept.rglob("*.part"))
    run(path, "-o", kept, "--jobs", "1", threads=True)
    assert load_result(kept).table.equals(whole.table)


@needs_mounts
def test_a_read_only_folder(whole: CampaignResult, tmp_path: Path) -> None:
    path, out = write(tmp_path), tmp_path / "out"
    out.mkdir()
    words = " ".join(command(path, "-o", out))
    done = in_namespace(f"mount -t tmpfs -o ro none {out} && {words}; echo $?")
    assert done.stdout.split()[-1] == "2"
    assert done.stderr.count("\n") == 1 and "Read-only file system" in done.stderr


def test_the_parts_are_tables_that_any_tool_reads(whole: CampaignResult) -> None:
    table = pyarrow.parquet.read_table(whole.folder / "runs.parquet")
    assert isinstance(table, pyarrow.Table)
    assert table.schema.names == [
        "run", "scenario", "sway", "payload", "design", "passed", "error", "arrival",
        "margin.follows", "bound.follows", "holds.follows",
        "margin.rests", "bound.rests", "holds.rests",
    ]
    assert not (whole.folder / "parts").exists()
