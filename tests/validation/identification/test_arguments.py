"""Arguments of `identify` that are none: one line with the name, before anything is fitted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import segfmu
from segfmu.errors import InputError
from segfmu.validation.identification.fit import Problem
from segfmu.validation.identification.log import read_log

CRANE = {"bridge_mass": 1.0, "trolley_mass": 1.0, "payload_mass": 1.0, "drive": "velocity"}
LOG = {
    "time": 0.1 * np.arange(50), "velocity.bridge": np.full(50, 0.1),
    "measured.bridge.position": 0.01 * np.arange(50), "measured.rope.length": np.ones(50),
}


class BeforeTheFitError(Exception):
    """All arguments have been taken; what a fit finds is told by other tests."""


@pytest.fixture
def unfitted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fits raise BeforeTheFitError."""

    def fit(*_: object) -> None:
        raise BeforeTheFitError

    monkeypatch.setattr(Problem, "fit", fit)


@pytest.mark.parametrize(("name", "wrong", "words"), [
    ("crane", [None, 5, [CRANE]], "crane must be a file or a dict, got"),
    ("logs", [None, 5, b"log.csv"], "logs must be a sequence, got"),
    ("logs", [[5], [None]], "log 1 must be a file or a dict of columns, got"),
    ("logs", [{**LOG, "time": 0.0}], "log 1: time must be a list of numbers"),
    ("fit", [5], "fit must be a sequence, got 5"),
    ("fit", ["bridge.lag", [5], [["bridge.lag"]]], "fit must be a sequence of names, got"),
    ("fit", [[""]], "'' cannot be fitted; what can is"),
    ("columns", [5, "time", ["time"]], "columns must be a mapping from names, got"),
    ("columns", [{"time": 5}, {5: "time"}], "columns must be a sequence of names, got"),
    ("validation", [5, [LOG]], "validation must be a file or a dict of columns, got"),
    ("tube", ["1", None, [], {}, True], "tube must be one number, got"),
    ("tube", [-1.0], "tube must be at least 0, got -1.0"),
    ("held_out", [None, "1"], "held_out must be one number, got"),
    ("piece", ["1", [1.0, 2.0]], "piece must be one number, got"),
])
def test_what_is_none(name: str, wrong: list[Any], words: str) -> None:
    for value in wrong:
        given = {"logs": LOG, "crane": CRANE, "fit": ["bridge.lag"], name: value}
        with pytest.raises(InputError, match=words):
            segfmu.identify(**given)


def test_files_of_logs_are_others(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One that was there twice counted twice, and one that was fitted validated itself."""
    log = written(tmp_path / "log.csv", ",".join([*LOG, "note"]), "on")
    other = tmp_path / "other.csv"
    other.symlink_to(log)
    monkeypatch.setattr(Problem, "fit", lambda *_: pytest.fail("a fit before all was read"))
    for given, validation, words in (
        ([log, other], None, "other.csv: is there twice among the logs, and would count twice"),
        (log, str(other), "other.csv: is fitted, so that it validates nothing; name another log"),
        (log, tmp_path / "nowhere.csv", "nowhere.csv: cannot be read: No such file"),
    ):
        with pytest.raises(InputError, match=words):
            segfmu.identify(given, CRANE, fit=["bridge.lag"], validation=validation)


@pytest.mark.parametrize(("one", "other"), [
    ("velocity.bridge", "time"), ("velocity.bridge", "velocity.trolley"),
    ("measured.sway.x.angle", "measured.rope.length"),
])
def test_a_column_is_that_of_one_signal(one: str, other: str) -> None:
    log = LOG | {"velocity.trolley": np.zeros(50)}
    with pytest.raises(InputError, match=f"column {other} is to be .* and .*; name one of its own"):
        segfmu.identify(log, CRANE, fit=["bridge.lag"], columns={one: other})
    # exchanged ones are each that of another signal
    swapped = {"velocity.bridge": "velocity.trolley", "velocity.trolley": "velocity.bridge"}
    read_log(log, "velocity", swapped)


def test_pieces_of_next_to_no_length_are_the_shortest_that_can_be() -> None:
    log = {name: values[:20] for name, values in LOG.items()}
    found = segfmu.identify(log, CRANE, fit=["bridge.lag"], piece=[5e-324], held_out=[0.0])
    assert found.fitted[0].columns["time"].size == 20


@pytest.mark.parametrize(("wrong", "right"), [
    ("measured.sway.x.angel", "measured.sway.x.angle"),
    ("Measured.Trolley.Position", "measured.trolley.position"),
    ("measured.sway_y_angle", "measured.sway.y.angle"), ("velocity.trolly", "velocity.trolley"),
])
def test_columns_that_are_misspelt_are_named(
    wrong: str, right: str, tmp_path: Path, unfitted: None
) -> None:
    """They were left out without a word, and the sway was fitted to nothing."""
    log = {**LOG, wrong: np.zeros(50)}
    file = tmp_path / "log.csv"
    np.savetxt(file, np.stack([*log.values()]).T, delimiter=",", header=",".join(log), comments="")
    words = f"{wrong}' is no signal; did you mean {right}"
    for given in (log, file):
        with pytest.raises(InputError, match=words) as told:
            segfmu.identify(given, CRANE, fit=["bridge.lag"])
        assert f"--column {right}={wrong}" in str(told.value)
    with pytest.raises(BeforeTheFitError):
        segfmu.identify(log, CRANE, fit=["bridge.lag"], columns={right: wrong})


def test_further_columns_are_no_misspelt_ones(unfitted: None) -> None:
    names = (
        "sway.x.angle", "velocity.wind", "angle", "measured.bridge.velocity", "force.trolly",
        "measured.sway.x.rate", "plan.progress", "Measured.Bridge.Position",
    )
    log = LOG | {name: np.zeros(50) for name in names}
    with pytest.raises(BeforeTheFitError):
        segfmu.identify(log, CRANE, fit=["bridge.lag"])


def written(file: Path, header: str, note: str) -> Path:
    rows = np.stack([*LOG.values()]).T
    lines = [",".join([*map(repr, row.tolist()), note]) for row in rows]
    file.write_text("\n".join(["# of a crane", header, *lines]), "utf-8")
    return file


def test_time_may_have_another_name_and_other_columns_may_be_texts(tmp_path: Path) -> None:
    header = ",".join(["Clock [s]" if name == "time" else name for name in [*LOG, "note"]])
    file = written(tmp_path / "log.csv", header, "on")
    for name in ("Clock", "Clock [s]"):
        read = read_log(file, "velocity", {"time": name})
        assert read.times.tolist() == LOG["time"].tolist()
    log = {"Clock" if name == "time" else name: values for name, values in LOG.items()}
    found = segfmu.identify(log, CRANE, fit=["bridge.lag"], columns={"time": "Clock"})
    assert found.fitted[0].columns["time"].size == 38
    for given in (file, log):
        with pytest.raises(InputError, match="no column time"):
            segfmu.identify(given, CRANE, fit=["bridge.lag"])


@pytest.mark.parametrize("written", ["mine [{}]", "mine ({})", "mine[{}]"])
@pytest.mark.parametrize(("own", "unit", "needed"), [
    ("time", "ms", "s"), ("measured.sway.x.angle", "deg", "rad"),
    ("velocity.bridge", "m/min", "m/s"),
])
def test_units_of_columns_with_other_names_are_checked(
    own: str, unit: str, needed: str, written: str, tmp_path: Path
) -> None:
    """Degrees of a column of another name were taken for radians."""
    log = {**LOG, "measured.sway.x.angle": np.zeros(50)}
    whole = written.format(unit)
    names = [whole if name == own else name for name in log]
    file = tmp_path / "log.csv"
    np.savetxt(
        file, np.stack([*log.values()]).T, delimiter=",", header=",".join(names), comments=""
    )
    for source in (file, dict(zip(names, log.values(), strict=True))):
        for name in ("mine", whole):
            with pytest.raises(InputError, match=f"column mine is in {unit}; give it in {needed}"):
                segfmu.identify(source, CRANE, fit=["bridge.lag"], columns={own: name})


def test_the_signals_of_a_run_are_a_log() -> None:
    models = Path(__file__).parents[3] / "models"
    run = segfmu.simulate(models / "inteco.toml", step=0.05)
    log = {name: run[name] for name in run}
    assert log["plan.done"].dtype == bool
    found = segfmu.identify(log, models / "crane_inteco.toml", fit=["payload_mass"])
    assert found["payload_mass"].value == pytest.approx(1.0, rel=1e-2)
    with pytest.raises(InputError, match=r"plan\.done must be a number or a list of numbers"):
        segfmu.identify(log | {"plan.done": ["no"] * run.time.size}, models / "crane_inteco.toml")


def test_tables_of_other_packages_are_no_lists_of_logs(unfitted: None) -> None:
    """The names of their columns were taken for files, and their rows for logs."""
    rows = np.rec.fromarrays(list(LOG.values()), names=list(LOG))
    for table in (pytest.importorskip("pandas").DataFrame(LOG), rows):
        with pytest.raises(InputError, match="logs must be files or dicts of columns, got "):
            segfmu.identify(table, CRANE, fit=["bridge.lag"])
        columns = {name: table[name] for name in LOG}
        with pytest.raises(BeforeTheFitError):
            segfmu.identify(columns, CRANE, fit=["bridge.lag"])
