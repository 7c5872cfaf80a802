"""Recordings: what a CSV file has to be."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu.cosim import Change
from segfmu.errors import InputError
from segfmu.validation.files.recording import load_recording


def written(folder: Path, text: str) -> Path:
    path = folder / "r.csv"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_row_is_held_and_only_what_changes_is_set(tmp_path: Path) -> None:
    found = load_recording(written(
        tmp_path, "time, command.mode,wind.x,command.go\n0,velocity,0.0,true\n1.5,velocity,2,True\n"
        "\n2,stop,2.0,false\n",
    ))
    assert (found.times, found.end, found.commands) == ((0.0, 1.5, 2.0), 2.0, True)
    variables = {"planner": ("command.mode", "command.go"), "crane": ("wind.x",)}
    assert list(found.changes(variables)) == [
        Change(0.0, "planner", {"command.mode": "velocity", "command.go": True}),
        Change(2.0, "planner", {"command.mode": "stop", "command.go": False}),
        Change(0.0, "crane", {"wind.x": 0.0}), Change(1.5, "crane", {"wind.x": 2.0}),
    ]
    assert [c.origin for c in found.changes(variables)] == [
        f"{found.path}, line {line}" for line in (2, 5, 2, 3)
    ]
    with pytest.raises(InputError, match=r"r\.csv: column wind\.x is no variable of planner"):
        list(found.changes({"planner": variables["planner"]}))


def test_units_are_left_out_of_names_as_in_other_tables(tmp_path: Path) -> None:
    """A table that `segfmu simulate` wrote had no column time."""
    found = load_recording(written(tmp_path, "time [s],wind.x [N],command.mode\n0,1.5,stop\n"))
    assert (found.times, found.columns) == ((0.0,), {"wind.x": (1.5,), "command.mode": ("stop",)})


WRONG = {
    "time [ms],a\n0,1\n": "column time is in ms; give it in s",
    "time,wind.x [kN]\n0,1\n": "column wind.x is in kN; give it in N",
    "time,a,a [m]\n0,1,2\n": "two columns are called 'a'",
    "": "empty; the first line names the columns",
    "wind.x\n0\n": "has no column time",
    # what is behind the first line is not read before that is right
    'wind.x\n"0\n': "has no column time",
    "time\n0\n": "has no column beside time",
    "time,a,a\n0,1,2\n": "two columns are called 'a'",
    "time,a\n": "has no rows below its header",
    "time,a\n0\n": "line 2: 1 values for 2 columns",
    "time|a\n0|1\n": "has no column time; columns are separated by commas, semicolons or tabs",
    "0,1\n1,1\n": "has no column time; the first line has to name the columns",
    "time,a\n0,0,1,5\n": "line 2: 4 values for 2 columns; decimals have a point",
    "time;a\n0;0,2\n": "line 2: a: got '0,2'; numbers have a decimal point",
    "time,a\n0,\n": "line 2: a is empty; repeat the value before",
    "time,a\n0,1\n1_0,1\n": "line 3: time must be a time >= 0 s, got '1_0'",
    "time,a\n0,1\nnow,1\n": "line 3: time must be a time >= 0 s, got 'now'",
    "time,a\n-1,1\n": "line 2: time must be a time >= 0 s, got -1.0",
    "time,a\nnan,1\n": "line 2: time must be finite, got nan",
    "time,a\n1,1\n1,2\n": "line 3: time must increase, got 1 after 1",
    # a row is judged before those behind it are read
    "time,a\n1,1\n1,2\n2,inf\n": "line 3: time must increase, got 1 after 1",
    "# a\n\ntime,a\n0,1\n1,inf\n": "line 5: a must be finite, got inf",
    "time,a\n0,1e400\n": "line 2: a must be finite, got 1e400",
    "time,a\n0,\0\n": "r.csv: ",
}


@pytest.mark.parametrize("text", WRONG)
def test_what_is_no_recording_is_told(tmp_path: Path, text: str) -> None:
    path = written(tmp_path, text)
    try:
        load_recording(path)
    except InputError as error:
        assert str(error).startswith(str(path))
        assert WRONG[text] in str(error)
    else:
        # some versions of csv take a zero byte for text
        assert "\0" in text


def test_a_file_that_is_missing_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"none\.csv: cannot be read: No such file"):
        load_recording(tmp_path / "none.csv")
    (tmp_path / "bytes.csv").write_bytes(b"\xff\xfe\x00time")
    with pytest.raises(InputError, match=r"bytes\.csv: cannot be read: it is not text in UTF-8"):
        load_recording(tmp_path / "bytes.csv")


@pytest.mark.parametrize("separator", [";", "\t", ","])
def test_columns_are_separated_as_in_tables_of_waypoints(tmp_path: Path, separator: str) -> None:
    found = load_recording(written(tmp_path, "# by hand\n\ntime,a\n0,1\n".replace(",", separator)))
    assert (found.times, found.columns) == ((0.0,), {"a": (1.0,)})


def test_a_file_without_an_end_is_refused() -> None:
    with pytest.raises(InputError, match=r"zero: larger than 64 MB"):
        load_recording(Path("/dev/zero"))
