"""What is no table of signals is refused in one line."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter

import pytest

from segfmu.errors import InputError
from segfmu.validation.signal_table import read_table


@pytest.mark.parametrize(("text", "told"), [
    ("", "empty; the first line names the columns, such as time,wind.x"),
    ("\n# a comment\n", "empty; the first line names the columns"),
    ("x,y\n1,2\n", "no column time; the first line has 'x, y'"),
    ("time;a\n0,0;1,5\n",
     ", line 2: time must be a number, got '0,0'; numbers have a decimal point"),
    ("time,a\n", "there is no row of numbers"),
    ("time,a\n0,1\n1,2\n2\n", ", line 4: 1 values for 2 columns"),
    ("time,a\n0,1\n1,1_000\n", ", line 3: a must be a number, got '1_000'"),
    ("time,a\n0,1\n1,\u0663\n", ", line 3: a must be a number, got '\u0663'"),
    ("time,a\n0,1\n1,fast\n", ", line 3: a must be a number, got 'fast'"),
    ("time,a\n0,1,2\n", "2 names but rows of 3 numbers"),
    ("time [ms],a\n0,1\n1,2\n", "column time is in ms; give it in s"),
    ("time,sway.x.angle [deg]\n0,1\n1,2\n", "column sway.x.angle is in deg; give it in rad"),
    ("time,sway.x.angle (deg)\n0,1\n1,2\n", "column sway.x.angle is in deg; give it in rad"),
    ("time[ms],a\n0,1\n1,2\n", "column time is in ms; give it in s"),
    ("time,a,a\n0,1,2\n", "two columns have one name, 'a'"),
    ("title\ntime,a\n0,1\n", "no column time; the first line has 'title'"),
    ("time|a\n0|1\n", "no column time; the first line has 'time|a'"),
    ("time a\n0 1\n", "no column time; the first line has 'time a'; columns are separated by com"),
    ("0,1\n1,1.5\n", "no column time; the first line has '0, 1'; the first line has to name the c"),
    ("time,a\n0,0,1,5\n", "2 names but rows of 4 numbers; decimals have a point"),
    ("time;a\n0,0\nx,1\n", ", line 2: 1 values for 2 columns; values are separated as the names"),
    ("time,a\n0,1\n1,\n",
     ", line 3: a must be a number, got ''; leave out the rows that lack one"),
    ("time," + 200_000 * "a" + "\n0,1\n", "the first line is no names of columns: field larger"),
    ("time,a\n0,1\n1,1\n1,2\n",
     "time does not increase: 1.0 s behind 1.0 s in row 3 of the numbers"),
    ("time,a\nnan,1\n1,2\n", "time does not increase: 1.0 s behind nan s"),
    # also where not all are numbers, a row is judged before those behind it are read
    ("time,a\n0,1\n2,1\n1,2\n3,x\n",
     "time does not increase: 1.0 s behind 2.0 s in row 3 of the numbers"),
])
def test_a_table_is_refused_in_one_line(tmp_path: Path, text: str, told: str) -> None:
    path = tmp_path / "log.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as error:
        read_table(path)
    message = str(error.value)
    assert message.startswith(f"{path}{told if told.startswith(',') else f': {told}'}")
    assert "\n" not in message and "usecols" not in message


def test_a_table_with_many_columns_is_read_at_once(tmp_path: Path) -> None:
    """Each of its names was looked for among all others, twice: it took minutes."""
    path = tmp_path / "wide.csv"
    names = ["time", *(f"c{i}" for i in range(50_000))]
    path.write_text("\n".join([",".join(names), ",".join(["0"] * len(names))]), encoding="utf-8")
    begin = perf_counter()
    assert len(read_table(path)) == len(names)
    path.write_text(",".join([*names, "c7"]) + "\n", encoding="utf-8")
    with pytest.raises(InputError, match="two columns have one name, 'c7'"):
        read_table(path)
    assert perf_counter() - begin < 15.0


@pytest.mark.parametrize("text", [
    "time,a [m]\n0,1\n1,2\n", "time (s),a[m]\n0,1\n1,2\n",
    "time;a\n0;1\n1;2\n", "time\ta [m]\r\n0\t1\r\n1\t2\r\n",
    ' time , "a" \r0 , 1\r1 , 2\r', "\ufefftime, a\n0, 1\n\n1, 2",
    "# logged on Monday, at noon\n\ntime,a\n0,1\n1,2\n",
])
def test_tables_are_read_as_spreadsheets_write_them(tmp_path: Path, text: str) -> None:
    path = tmp_path / "log.csv"
    path.write_text(text, encoding="utf-8", newline="")
    table = read_table(path)
    assert {name: values.tolist() for name, values in table.items()} == {
        "time": [0.0, 1.0], "a": [1.0, 2.0],
    }


def test_what_is_a_part_of_a_name_is_no_unit(tmp_path: Path) -> None:
    (tmp_path / "log.csv").write_text("time,a[2],der(a),norm(a) [m]\n0,1,2,3\n", encoding="utf-8")
    assert list(read_table(tmp_path / "log.csv")) == ["time", "a[2]", "der(a)", "norm(a)"]


@pytest.mark.parametrize("encoding", ["utf-16", "latin-1"])
def test_other_encodings_are_named(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "log.csv"
    path.write_text("time,Länge\n0,1\n", encoding=encoding)
    with pytest.raises(InputError, match=r"cannot be read: it is not text in UTF-8$"):
        read_table(path)


def test_columns_that_are_not_used_may_hold_anything(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text("clock,t [s],a,note,,note\n10:00,0,1,on,,x\n10:01,1,2,off,nan,y\n", "utf-8")
    table = read_table(path, {"t", "a"}, {"time": "t"})
    assert {name: values.tolist() for name, values in table.items()} == {
        "t": [0.0, 1.0], "a": [1.0, 2.0],
    }
    for used, told in (
        ({"t", "note"}, "two columns have one name, 'note'"),
        ({"t", "clock"}, "line 2: clock must be a number, got '10:00'"),
    ):
        with pytest.raises(InputError, match=told):
            read_table(path, used, {"time": "t"})
    path.write_text("t,a,note\n0,1,on\n1,2,5,off\n", "utf-8")
    with pytest.raises(InputError, match="line 3: 4 values for 3 columns"):
        read_table(path, {"t", "a"}, {"time": "t"})
