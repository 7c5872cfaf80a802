"""Files and tables of a small campaign."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest
from rich.console import Console

from segfmu.errors import InputError
from segfmu.validation.campaign import Outcome
from segfmu.validation.campaign_files import write_maps, write_tables
from segfmu.validation.campaign_report import factor, outcome_table, verdict_table
from segfmu.validation.verdict import compare
from tests.validation.moves import DIAGONAL

PNG = b"\x89PNG\r\n\x1a\n"


def outcomes() -> list[Outcome]:
    found = []
    for mode in ("velocity", "force"):
        for row, error in (("none", 1e-6), ("gust", 0.05)):
            for method, share in (("ZV", 2.0), ("feedforward", 1.0), ("feedforward + LQR", 0.05)):
                value = share * error
                found.append(
                    Outcome(
                        mode, row, method, 2.5, value, value, value, 50.0 * value, value,
                        float("inf"), 3.0, 4.0, 5.0,
                    )
                )
    found[-2] = Outcome("force", "gust", "feedforward", 2.5, failure="at 1.0 s: rope slack")
    return found


def test_tables_are_complete_and_readable(tmp_path: Path) -> None:
    found = outcomes()
    write_tables(tmp_path, "a mission", found, compare(found))
    with (tmp_path / "campaign.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(found)
    assert rows[3]["disturbance"] == "gust"
    assert float(rows[3]["rms_error"]) == found[3].rms_error
    assert rows[-2]["failure"] == "at 1.0 s: rope slack"
    content = json.loads((tmp_path / "campaign.json").read_text(encoding="utf-8"))
    assert content["mission"] == "a mission"
    assert content["outcomes"][0]["settling_time"] is None
    assert content["outcomes"][-2]["rms_error"] is None
    assert [c["reached"] for c in content["comparisons"]] == [True] * 4
    for mode in ("velocity", "force"):
        assert (tmp_path / f"campaign_{mode}.png").read_bytes().startswith(PNG)
    assert not list(tmp_path.glob("*.part"))


def test_maps_are_written(tmp_path: Path) -> None:
    write_maps(tmp_path, DIAGONAL, DIAGONAL.plan(), coarse=True)
    for name in ("move_times", "eigenvalues"):
        assert (tmp_path / f"{name}.png").read_bytes().startswith(PNG)
        lines = (tmp_path / f"{name}.csv").read_text(encoding="utf-8").splitlines()
        assert len(lines) > 10


def test_a_folder_that_cannot_be_made_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    found = outcomes()
    with pytest.raises(InputError, match="cannot be written"):
        write_tables(tmp_path / "file", "a mission", found, compare(found))


def test_terminal_tables_fit_eighty_columns() -> None:
    found = outcomes()
    console = Console(width=80, record=True, file=None, quiet=False)
    with console.capture() as captured:
        console.print(outcome_table("force", found))
        console.print(verdict_table(compare(found)))
    text = captured.get()
    assert "feedforward + LQR" in text
    assert "failed" in text
    assert "100.000" in text
    assert "fails alone" in text
    assert "…" not in text


def test_factors() -> None:
    assert factor(2.98) == "2.98x"
    assert factor(63.1) == "63x"
    assert factor(float("nan")) == "-"
    assert factor(2e5) == "> 1000x"
    assert factor(float("inf")) == "fails alone"
