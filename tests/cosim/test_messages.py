"""What FMUs say reaches the caller: logging records, the lines of the command line, errors."""

from __future__ import annotations

import logging
import shutil
import sys
from collections.abc import Callable
from copy import copy
from pathlib import Path

import pytest

from segfmu import cli
from segfmu.cosim import simulate
from segfmu.cosim.load import load
from segfmu.cosim.messages import MOST_TEXTS, Messages, on_stderr
from segfmu.cosim.unit import Unit
from segfmu.errors import SimulationError
from segfmu.validation import archives, scenario

MODELS = Path(__file__).parents[2] / "models"
TABLE = (
    "the gains of feedback.table, design lqr, were made for other values of crane.bridge_mass; "
    "set feedback.design to flatness, or build the FMU with these values"
)
SHORT = {"stop_time": 0.05, "step": 0.01}


@pytest.fixture(params=[2, 3])
def unit(request, native_fmus):
    """GantryCrane of either version."""
    with load(native_fmus[request.param][1]) as opened:
        yield opened


def speaker(unit: Unit) -> Callable[[int, bytes | None, bytes | None], None]:
    """The callback that the FMU itself calls, with status, category and message."""
    if unit.description.fmiVersion == "2.0":
        return lambda *told: unit._callbacks.logger(None, b"crane", *told)
    return lambda *told: unit.fmu.logMessage(None, *told)


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_warning_of_the_crane_is_a_record(native_fmus, caplog, fmi: int) -> None:
    rows = simulate(*native_fmus[fmi], **SHORT, sink_values={"crane.bridge_mass": 9.0})
    assert rows.size == 6
    record, = caplog.records
    assert (record.name, record.levelname) == ("segfmu.cosim", "WARNING")
    assert record.getMessage() == f"GantryCrane: {TABLE}"
    assert record.fmu == "GantryCrane"


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_run_without_messages_is_silent(native_fmus, caplog, capfd, fmi: int) -> None:
    simulate(*native_fmus[fmi], **SHORT)
    assert caplog.records == []
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("fmi", [2, 3])
def test_an_error_has_its_own_words_after_a_warning(native_fmus, caplog, fmi: int) -> None:
    values = {"crane.bridge_mass": 9.0, "force.hoist": 1e6, "feedback.enabled": False}
    with load(native_fmus[fmi][1]) as crane:
        crane.set(values)
        crane.enter_initialization(0.0, 1.0)
        crane.exit_initialization()
        with pytest.raises(SimulationError, match="GantryCrane could not step at") as raised:
            for i in range(100):
                crane.step(0.01 * i, 0.01 * (i + 1))
    assert "feedback.table" not in str(raised.value)
    assert [r.levelname for r in caplog.records] == ["WARNING", "ERROR"]
    assert caplog.records[1].getMessage().endswith(str(raised.value).split(": ", 1)[1])


def test_refused_reading_and_writing_name_the_variables(unit) -> None:
    for name in ("force.hoist", "error.load.x"):
        # other units of the archive have the same description
        unit.variables[name] = copy(unit.variables[name])
        unit.variables[name].valueReference = 10**6
    with pytest.raises(SimulationError, match=r"GantryCrane could not set force\.hoist: \w"):
        unit.set({"force.hoist": 1.0})
    with pytest.raises(SimulationError, match=r"give error\.load\.x and 1 more: \w"):
        unit.channel(["error.load.x", "error.load.y"]).read()


@pytest.mark.parametrize(
    ("status", "category", "level"),
    [
        (0, b"logAll", "INFO"), (1, b"logStatusWarning", "WARNING"), (2, None, "WARNING"),
        (3, b"logStatusError", "ERROR"), (4, b"", "CRITICAL"), (5, b"logStatusPending", "INFO"),
        (0, b"logStatusError", "ERROR"), (1, b"logStatusFatal", "CRITICAL"), (3, b"\xff", "ERROR"),
        (17, b"", "WARNING"), (-1, b"", "WARNING"),
    ],
)
def test_level_follows_from_status_and_category(unit, caplog, status, category, level) -> None:
    caplog.set_level(logging.INFO, "segfmu.cosim")
    speaker(unit)(status, category, b"something")
    assert [(r.levelname, r.getMessage()) for r in caplog.records] == [
        (level, "GantryCrane: something")
    ]


@pytest.mark.parametrize(
    ("message", "text"),
    [
        (b"\xff\xfeK\xe4se", "\ufffd\ufffdK\ufffdse"), ("Öl".encode(), "Öl"),
        (b"%s %d {} %(x)s", "%s %d {} %(x)s"), (b" two\nlines\r\n", "two\nlines"),
    ],
)
def test_texts_of_any_bytes_arrive(unit, caplog, message: bytes, text: str) -> None:
    speaker(unit)(1, b"logStatusWarning", message)
    assert [r.getMessage() for r in caplog.records] == [f"GantryCrane: {text}"]


def test_nothing_said_is_no_record(unit, caplog) -> None:
    for message in (None, b"", b" \n"):
        speaker(unit)(1, b"logStatusWarning", message)
    assert caplog.records == []


def test_percent_signs_of_fmi2_come_doubled_as_in_a_format(native_fmus, caplog) -> None:
    for fmi, shown in ((2, "5 %"), (3, "5 %%")):
        caplog.clear()
        with load(native_fmus[fmi][1]) as crane:
            speaker(crane)(1, b"", b"5 %%")
        assert caplog.records[0].getMessage() == f"GantryCrane: {shown}"


@pytest.mark.parametrize("fmi", [2, 3])
def test_what_is_said_in_every_step_is_told_twice(native_fmus, caplog, monkeypatch, fmi) -> None:
    with load(native_fmus[fmi][1]) as crane:
        kind = type(crane)
    step = kind.step

    def talkative(self: Unit, time: float, end: float) -> float:
        speaker(self)(1, b"logStatusWarning", b"again")
        return float(step(self, time, end))

    monkeypatch.setattr(kind, "step", talkative)
    simulate(*native_fmus[fmi], **SHORT, events=False, engine="python")
    texts = [r.getMessage() for r in caplog.records]
    assert texts == [
        "GantryFeedforward: again", "GantryCrane: again", "GantryCrane: said 5 times: again",
        "GantryFeedforward: said 5 times: again",
    ]


def test_a_flood_of_different_texts_ends_in_a_count(caplog) -> None:
    messages = Messages("FMU")
    for i in range(3 * MOST_TEXTS):
        messages.hear(1, None, b"at %d s" % i)
    assert len(caplog.records) == MOST_TEXTS
    messages.close()
    assert [r.getMessage() for r in caplog.records[MOST_TEXTS:]] == [
        f"FMU: {2 * MOST_TEXTS} further messages were omitted"
    ]


def test_lines_do_not_steer_the_terminal(capsys) -> None:
    messages = Messages("FMU")
    with on_stderr():
        messages.hear(1, None, b"one\ntwo \x1b[31m\x07")
        messages.hear(3, None, b"an error that is none")
        messages.hear(0, None, b"hello")
    assert capsys.readouterr().err.splitlines() == [
        r"warning: FMU: one two \x1b[31m\x07", "error: FMU: an error that is none",
        "info: FMU: hello",
    ]


def run_cli(monkeypatch, native_fmus, folder: Path, mass: float) -> int:
    """`segfmu simulate` of the paper's mission with an FMU of another crane."""
    values = scenario.crane_values

    monkeypatch.setattr(
        scenario, "crane_values", lambda mission: values(mission) | {"crane.bridge_mass": mass}
    )
    monkeypatch.setattr(
        archives, "written",
        lambda target, *_: tuple(Path(shutil.copy(p, target)) for p in native_fmus[2]),
    )
    mission = str(MODELS / "paper.toml")
    monkeypatch.setattr(
        sys, "argv", ["segfmu", "simulate", mission, "-o", str(folder), "--step", "0.01"]
    )
    folder.mkdir()
    with pytest.raises(SystemExit) as ended:
        cli.main()
    return int(ended.value.code or 0)


def test_the_command_line_shows_warnings(native_fmus, tmp_path, monkeypatch, capsys) -> None:
    code = run_cli(monkeypatch, native_fmus, tmp_path / "out", 9.0)
    printed, told = capsys.readouterr()
    assert code in (0, 1) and "verdict" in printed
    assert told.splitlines() == [f"warning: GantryCrane: {TABLE}"]


def test_the_command_line_shows_an_error_once(native_fmus, tmp_path, monkeypatch, capsys) -> None:
    assert run_cli(monkeypatch, native_fmus, tmp_path / "out", -1.0) == 1
    line, = capsys.readouterr().err.splitlines()
    assert line.startswith("segfmu: GantryCrane could not be initialised: initialisation failed")
    assert "crane.bridge_mass" in line
