"""Requirements: what they rest on, in JUnit and reports, and those that rest on nothing."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree as xml

import pyarrow
import pytest

from segfmu.validation import suites
from segfmu.validation.campaigns.campaign import load_campaign
from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.store import Store, about
from segfmu.validation.campaigns.summary_file import write_summary
from segfmu.validation.files.scenario_file import load_scenario
from segfmu.validation.monitor import Finding
from segfmu.validation.report import campaign_page
from segfmu.validation.report.requirements import requirement_sections
from segfmu.validation.requirements import of_results
from segfmu.validation.scenario_result import Result
from segfmu.validation.suite_files import write_junit
from segfmu.validation.suites import Suite
from tests.validation.campaigns.files import SCENARIO, called, write

FOLLOWS = 'bound = 0.02\nrequirement = "REQ-1"\ntext = "the load is where it is expected"\n'
ASKED = SCENARIO.replace("bound = 0.02\n", FOLLOWS).replace(
    "bound = 0.01\n", 'bound = 0.01\nrequirement = "REQ-2"\n'
).replace('name = "s"\n', 'name = "s"\nrequirements = ["REQ-3"]\n')


def result(folder: Path, follows: float | None, rests: float | None) -> Result:
    """A run with these margins."""
    write(folder, scenario=ASKED)
    findings = tuple(
        Finding(name, "always", "signal", 0.02, margin, "m")
        for name, margin in (("follows", follows), ("rests", rests)) if margin is not None
    )
    error = "" if findings else "the rope is slack"
    return Result(load_scenario(folder / "s.toml"), {}, findings=findings, error=error)


def test_a_requirement_rests_on_all_runs_of_its_criteria(tmp_path: Path) -> None:
    good, bad = result(tmp_path, 0.01, 0.02), result(tmp_path, -0.01, 0.02)
    found = {one.name: one for one in of_results([good, bad])}
    assert {name: one.verdict for name, one in found.items()} == {
        "REQ-3": "no evidence", "REQ-1": "fails", "REQ-2": "holds",
    }
    assert [e.found for e in found["REQ-1"].evidence] == [
        "s: margin 0.01 m, bound 0.02 m", "s: margin -0.01 m, bound 0.02 m",
    ]
    assert found["REQ-1"].evidence[0].criterion == "the load is where it is expected"
    assert found["REQ-2"].evidence[0].criterion == "rests"
    # a run without a verdict leaves what holds without evidence, and what fails failing
    stopped = result(tmp_path, None, None)
    found = {one.name: one for one in of_results([good, bad, stopped])}
    assert (found["REQ-1"].verdict, found["REQ-2"].verdict) == ("fails", "no evidence")


def test_junit_has_a_test_for_every_requirement(tmp_path: Path) -> None:
    write_junit(tmp_path / "junit.xml", [result(tmp_path, -0.01, 0.02)])
    (suite,) = xml.parse(tmp_path / "junit.xml").findall("testsuite[@name='requirements']")
    assert (suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("3", "1", "1")
    failure, error = suite.find("*/failure"), suite.find("*/error")
    assert failure is not None and "margin -0.01" in str(failure.get("message"))
    assert error is not None and error.get("message") == "no evidence: no criterion names it"


def test_commands_name_requirements_without_evidence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = result(tmp_path, 0.01, 0.02)
    monkeypatch.setattr(suites, "validate", lambda *_, **__: Suite([found]))
    done = called("validate", tmp_path / "s.toml")
    assert done.stderr == "segfmu: requirement REQ-3: no evidence\n"


def test_the_table_has_every_requirement_with_its_verdict(tmp_path: Path) -> None:
    every = of_results([result(tmp_path, 0.01, 0.02)])
    ((table,),) = (section.tables for section in requirement_sections(every))
    assert [(row[0], row[3][0]) for row in table.rows] == [
        ("REQ-3", "no evidence"), ("REQ-1", "holds"), ("REQ-2", "holds"),
    ]
    assert requirement_sections(of_results([])) == []


@pytest.mark.parametrize(("holds", "verdict"), [
    ([True, True], "holds"), ([True, False], "fails"), ([True, None], "no evidence"),
])
def test_a_campaign_has_the_evidence_of_all_runs(
    holds: list[bool | None], verdict: str, tmp_path: Path
) -> None:
    campaign = load_campaign(write(tmp_path, scenario=ASKED))
    Store(tmp_path, campaign)
    margins = [None if held is None else 1.0 if held else -1.0 for held in holds]
    table = pyarrow.table({
        "run": [0, 1], "scenario": ["s.toml"] * 2, "sway": [0.0, 1.0], "payload": [1.0, 1.0],
        "design": ["lqr"] * 2, "passed": [bool(held) for held in holds],
        "error": [None if held is not None else "slack" for held in holds],
        **{f"{kind}.{name}": values for name in campaign.criteria for kind, values in (
            ("margin", margins), ("holds", holds),
        )},
    })
    found = CampaignResult(folder=tmp_path, table=table, **about(tmp_path))
    verdicts = {one.name: one.verdict for one in found.requirements}
    assert verdicts == {"REQ-3": "no evidence", "REQ-1": verdict, "REQ-2": verdict}
    assert campaign_page(found).sections[0].title == "Requirements"
    told = json.loads(write_summary(found).read_text())["requirements"]
    assert {entry["requirement"]: entry["verdict"] for entry in told} == verdicts
