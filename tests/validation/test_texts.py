"""Files whose names have bytes that are no UTF-8: they are told with escapes, or refused.

Each ended with an error of Python, behind the run, with a part of the results written.
"""

from __future__ import annotations

import os
import shutil
import sys
from dataclasses import replace
from pathlib import Path

import pytest
import tomlkit
from matplotlib.figure import Figure

import segfmu
from segfmu.errors import InputError
from segfmu.validation.plots.style import label
from segfmu.validation.texts import encodable
from tests.compiler import require_native
from tests.validation.campaigns.files import write
from tests.validation.identification.test_arguments import CRANE, LOG, written
from tests.validation.report.test_report import campaign

NAME = os.fsdecode(b"n\xff")

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="other systems have no such names")


def test_what_is_utf8_is_left_as_it_is() -> None:
    assert encodable("Köln, 2 µm \U0001f3d7") == "Köln, 2 µm \U0001f3d7"
    assert encodable(NAME) == "n\\udcff"


def test_a_report_names_it(tmp_path: Path) -> None:
    path = replace(campaign(20), folder=Path(NAME)).report(tmp_path / "report.html")
    assert "n\\udcff/run_" in path.read_text(encoding="utf-8")


def test_a_figure_names_it(tmp_path: Path) -> None:
    figure = Figure()
    figure.suptitle(label(NAME))
    figure.savefig(tmp_path / "figure.png")


def test_an_identified_crane_names_its_log(tmp_path: Path) -> None:
    log = written(tmp_path / f"{NAME}.csv", ",".join([*LOG, "note"]), "on")
    crane = tmp_path / "crane.toml"
    crane.write_text(tomlkit.dumps({**CRANE, "bridge": {"lag": 0.1}}), encoding="utf-8")
    found = segfmu.identify(log, crane, fit=["bridge.lag"])
    text = found.write(tmp_path / "out.toml").read_text(encoding="utf-8")
    assert "n\\udcff.csv" in text


def test_a_campaign_is_refused_before_its_runs(tmp_path: Path) -> None:
    """Scenario files of its runs name the scenarios that they begin with."""
    require_native()
    file = write(tmp_path)
    with pytest.raises(InputError, match=r"this name is not UTF-8, and a campaign's files have"):
        segfmu.campaign(file, tmp_path / NAME)
    other = Path(shutil.copy(file, tmp_path / f"{NAME}.toml"))
    with pytest.raises(InputError, match=r"this name is not UTF-8"):
        segfmu.campaign(other, tmp_path / "out")
    assert not (tmp_path / NAME).exists() and not (tmp_path / "out").exists()
