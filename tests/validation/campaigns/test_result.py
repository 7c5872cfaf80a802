"""What a campaign found, from its table."""

from __future__ import annotations

import json
from io import StringIO
from pathlib import Path

import pyarrow
import pyarrow.parquet
import pytest
from rich.console import Console

from segfmu.errors import InputError
from segfmu.validation.campaigns.campaign import load_campaign
from segfmu.validation.campaigns.junit import write_junit
from segfmu.validation.campaigns.result import CampaignResult, load_result
from segfmu.validation.campaigns.store import Store, about, read_table
from segfmu.validation.campaigns.summary_file import write_summary
from segfmu.validation.campaigns.tables import criteria_table
from segfmu.validation.report import campaign_page
from tests.validation.campaigns.files import SCENARIO, write


@pytest.mark.parametrize(("margins", "worst"), [
    ([0.3, -0.1, float("nan"), 0.2], 12), ([0.3, float("nan"), -0.1, 0.2], 11),
    ([0.3, -0.1, None, 0.2], 11), ([None] * 4, None),
])
def test_a_margin_that_is_no_number_is_the_worst(
    margins: list[float | None], worst: int | None
) -> None:
    held = [None if m is None else m >= 0.0 for m in margins]
    table = pyarrow.table({
        "run": [10, 11, 12, 13], "margin.c": pyarrow.array(margins, pyarrow.float64()),
        "holds.c": pyarrow.array(held, pyarrow.bool_()),
    })
    (found,) = CampaignResult("n", Path(), (), ("c",), table).summaries
    assert (found.run, found.judged) == (worst, sum(m is not None for m in margins))
    assert found.held == sum(bool(h) for h in held)


def test_margins_are_told_with_their_units(tmp_path: Path) -> None:
    """They were numbers "in the unit of the signal" everywhere but in suites."""
    used = '[[criteria]]\nname = "drives"\nkind = "drives"\n'
    text = SCENARIO + used + '[[criteria]]\nname = "own"\nsignal = "mine.y"\nbound = 1.0\n'
    campaign = load_campaign(write(tmp_path, scenario=text))
    units = {"follows": "m", "rests": "rad", "drives": "of the bounds", "own": ""}
    assert campaign.units == units
    Store(tmp_path, campaign)
    table = pyarrow.table({
        "run": [0, 1], "scenario": ["s.toml"] * 2, "sway": [0.0, 1.0], "payload": [1.0, 1.0],
        "design": ["lqr"] * 2, "passed": [True] * 2, "error": [None] * 2,
        **{f"margin.{name}": [0.5, 0.25] for name in units},
        **{f"holds.{name}": [True, True] for name in units},
    })
    found = CampaignResult(folder=tmp_path, table=table, **about(tmp_path))
    told = {"follows": "0.25 m", "rests": "0.25 rad", "drives": "0.25 of the bounds", "own": "0.25"}
    assert {row.criterion: row.least for row in found.summaries} == told
    assert found.worst("rests").unit == "rad"
    page = campaign_page(found)
    assert [row[4] for row in page.summary.rows] == list(told.values())
    assert [chart.across for chart in page.sections[0].charts] == [
        "margin [m]", "margin [rad]", "margin [of the bounds]", "margin",
    ]
    assert all(chart.caption.endswith(units[chart.title]) for chart in page.sections[0].charts)
    shown = StringIO()
    Console(file=shown, width=200).print(criteria_table(found))
    assert all(f"+{text}│" in shown.getvalue() for text in told.values())
    panels = found.plot().axes
    assert panels[0].get_xlabel() == "margin of follows [m]"
    entries = json.loads(write_summary(found).read_text())["criteria"]
    assert {e["criterion"]: e["unit"] for e in entries} == {n: u or None for n, u in units.items()}
    write_junit(tmp_path / "junit.xml", found)
    assert "least margin 0.25 rad in run 1" in (tmp_path / "junit.xml").read_text()
    better = str(found.against(found)["follows"])
    assert better.startswith("follows: margin 0 (0 to 0) m, no difference")


@pytest.mark.parametrize("folder", [1, None, [], 0.5, "", " "])
def test_what_is_no_folder_has_no_result(folder: object) -> None:
    with pytest.raises(InputError, match=r"^output (must be the path of a folder|is empty)"):
        load_result(folder)


def test_a_column_that_the_table_has_not_is_told_with_one_that_may_be_meant() -> None:
    found = CampaignResult("n", Path(), (), (), pyarrow.table({"run": [0], "passed": [True]}))
    assert found.column("passed") == [True]
    with pytest.raises(InputError, match=r"no column 'pased' in the runs; did you mean passed\?"):
        found.column("pased")
    for name in (None, 3, ["run"]):
        with pytest.raises(InputError, match="no column"):
            found.column(name)


def test_a_run_that_there_is_not_is_told() -> None:
    found = CampaignResult("n", Path(), ("load",), (), pyarrow.table({"run": [0], "load": [7.0]}))
    assert found.values(0) == {"load": 7.0}
    for run in (1, -1, None):
        with pytest.raises(InputError, match="numbered from 0, there are 1"):
            found.values(run)


def test_a_command_is_one_of_a_scenario_that_is_there(tmp_path: Path) -> None:
    table = pyarrow.table({"run": [0, 1], "margin.c": [0.1, 0.2], "holds.c": [True, True]})
    found = CampaignResult("n", tmp_path, (), ("c",), table)
    assert found.command(0) == f"segfmu validate {tmp_path / 'run_0.toml'}"
    with pytest.raises(InputError, match=r"run 1 is the worst of no .* --replay 1 writes"):
        found.command(1)
    (tmp_path / "run_1.toml").touch()
    assert found.command(1) == f"segfmu validate {tmp_path / 'run_1.toml'}"
    with pytest.raises(InputError, match="no run 2"):
        found.command(2)


def test_a_table_that_lacks_a_column_is_no_table_of_runs(tmp_path: Path) -> None:
    """What it lacked was filled with nothing, and taken for runs."""
    path = tmp_path / "runs.parquet"
    schema = pyarrow.schema([("run", pyarrow.int64()), ("passed", pyarrow.bool_())])
    pyarrow.parquet.write_table(pyarrow.table({"more": ["x"], "passed": [True], "run": [0]}), path)
    assert read_table(path, schema).to_pylist() == [{"run": 0, "passed": True}]
    pyarrow.parquet.write_table(pyarrow.table({"run": [0]}), path)
    with pytest.raises(InputError, match=r"runs\.parquet: no table of runs: there is no column pa"):
        read_table(path, schema)


@pytest.mark.parametrize("about", [
    '{"name": "x", "factors": 5, "criteria": []}', '{"name": "x", "factors": [], "criteria": null}',
])
def test_a_campaign_of_other_kinds_of_values_is_told(about: str, tmp_path: Path) -> None:
    (tmp_path / "campaign.json").write_text(about, encoding="utf-8")
    with pytest.raises(InputError, match=r"campaign\.json: no campaign: .* not iterable$"):
        load_result(tmp_path)
