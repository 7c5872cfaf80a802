"""Waypoints from CSV files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from segfmu import InputError, Limits, load_mission, plan, read_waypoints

TABLE = """\
# the path of a survey

x,y,z,velocity_x,velocity_y,velocity_z,dwell
0.0,0.0,-1.0,,,,
0.5,0.2,-0.9,free,free,free,
0.5,0.2,-0.9,free,free,free,
1.0,0.5,-0.7,0,0,0,1.5
1.0,0.5,-0.7,,,,0.5
"""


def write(folder: Path, text: str, name: str = "path.csv") -> Path:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


def test_a_table_becomes_waypoints(tmp_path: Path) -> None:
    points = read_waypoints(write(tmp_path, TABLE))
    assert [p.position.tolist() for p in points[::3]] == [[0.0, 0.0, -1.0], [1.0, 0.5, -0.7]]
    assert [p.dwell for p in points] == [0.0, 0.0, 0.0, 1.5, 0.5]
    assert np.isnan(points[1].velocity).all()
    assert not points[1].acceleration.any()
    found = plan(points, Limits(1.0, 1.0, 4.0, 30.0))
    assert found.duration - found.waypoint_times[3] == pytest.approx(2.0)


@pytest.mark.parametrize("delimiter", [";", "\t"])
def test_other_delimiters_marks_and_line_ends(tmp_path: Path, delimiter: str) -> None:
    text = "\ufeff" + TABLE.replace(",", delimiter).replace("\n", "\r\n")
    file = tmp_path / "path.csv"
    file.write_bytes(text.encode())
    assert len(read_waypoints(str(file))) == 5


def test_axes_have_any_names_and_an_order(tmp_path: Path) -> None:
    file = write(tmp_path, "boom, slew ,velocity_slew\n1,2,3\n")
    point = read_waypoints(file)[0]
    assert (point.position.tolist(), point.velocity.tolist()) == ([1.0, 2.0], [0.0, 3.0])
    assert read_waypoints(file, ["slew", "boom"])[0].position.tolist() == [2.0, 1.0]
    swapped = write(tmp_path, "z,y,x\n3,2,1\n")
    assert read_waypoints(swapped)[0].position.tolist() == [1.0, 2.0, 3.0]


def test_units_are_left_out(tmp_path: Path) -> None:
    text = "z [m],x [m],y [m],velocity_x [m/s],acceleration_y [m/s^2],dwell [s]\n3,1,2,4,5,6\n"
    point = read_waypoints(write(tmp_path, text))[0]
    assert point.position.tolist() == [1.0, 2.0, 3.0]
    assert (point.velocity[0], point.acceleration[1], point.dwell) == (4.0, 5.0, 6.0)


def test_states_that_are_free_for_one_axis_alone(tmp_path: Path) -> None:
    point = read_waypoints(write(tmp_path, "x,y,velocity_x,acceleration_y\n1,2,free,free\n"))[0]
    assert np.isnan(point.velocity).tolist() == [True, False]
    assert np.isnan(point.acceleration).tolist() == [False, True]


@pytest.mark.parametrize(("text", "words"), [
    ("", "path.csv: empty; the first line names the columns"),
    ("x,y\n1,2\n3\n", "path.csv, line 3: 1 values for 2 columns"),
    ("x,y\n\n1,two\n", "path.csv, line 3, column y: must be a finite number, got 'two'"),
    ("x,y\n1,\n", "path.csv, line 2, column y: must be a finite number, got ''"),
    ("x;y\n1;0,5\n", "path.csv, line 2, column y: must be a finite number, got '0,5'"),
    ("x,velocity_x\n1,nan\n", 'line 2, column velocity_x: must be a finite number or "free"'),
    ("x,dwell\n1,-2\n", "line 2, column dwell: must be a time >= 0 s, got -2"),
    ("x,velocity_y\n1,2\n", "line 1: column 'velocity_y': known are x, velocity_x, acceleration_x"),
    ("x,x\n1,2\n", "line 1: column x is there twice"),
    ("x,,y\n1,,2\n", "line 1: column 2 has no name"),
    ("dwell\n1\n", "line 1: no column has a position"),
    ("0,0,-1\n1,1,-1\n", "line 1: '0' is no name of a column; the first line has names"),
    ("x,y(m)\n1,2\n", "line 1: 'y(m)' is no name of a column"),
    ("x [m],y [mm]\n1,2\n", "line 1: column y is in mm; give it in m"),
    ("x(m),y (mm)\n1,2\n", "line 1: column y is in mm; give it in m"),
    ("x[mm],y (m)\n1,2\n", "line 1: column x is in mm; give it in m"),
    ("x,velocity_x [m/min]\n1,2\n", "line 1: column velocity_x is in m/min; give it in m/s"),
    ("x,y,velocty_x\n1,2,3\n", "line 1: column 'velocty_x': known are x, y, velocity_x"),
    ("x,y,z,comment\n1,2,3,4\n", "line 1: column 'comment': known are x, y, z, velocity_x"),
    ("Z,X,Y\n3,1,2\n", "line 1: column 'Z': known are x, y, z, velocity_x"),
    ("x\n\u0663\n", "line 2, column x: must be a finite number, got '\u0663'"),
    ("x\n1_0\n", "line 2, column x: must be a finite number, got '1_0'"),
    ("x;y\n1,5;2\n", "column x: must be a finite number, got '1,5'; decimals have a point"),
    ('x\n"1\n', "path.csv, line 2: "),
    ("x y z\n0 0 -1\n", "line 1: one column, 'x y z'; columns are separated by commas, semicolons"),
    ("x|y\n0|0\n", "line 1: one column, 'x|y'; columns are separated by commas, semicolons or"),
    ("x,y\n1,0,2,5\n", "line 2: 4 values for 2 columns; decimals have a point"),
    ("x;y\n1,2\n", "line 2: 1 values for 2 columns; values are separated as the names in the fi"),
])
def test_wrong_tables_are_told(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(InputError) as info:
        read_waypoints(write(tmp_path, text))
    assert words in str(info.value)


def test_files_that_are_none(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="No such file"):
        read_waypoints(tmp_path / "none.csv")
    (tmp_path / "binary.csv").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError, match="not text in UTF-8"):
        read_waypoints(tmp_path / "binary.csv")
    with pytest.raises(InputError, match="a table of waypoints is a file, got 3"):
        read_waypoints(3)
    with pytest.raises(InputError, match="no column z, the position of axis z"):
        read_waypoints(write(tmp_path, "x,y\n1,2\n"), ["x", "y", "z"])


def test_a_mission_names_a_table(tmp_path: Path) -> None:
    write(tmp_path, TABLE)
    limits = {axis: {"velocity": 1.0, "acceleration": 1.0, "jerk": 4.0} for axis in "xyz"}
    text = 'waypoints = "path.csv"\n[crane]\nbridge_mass = 2.0\ntrolley_mass = 1.0\n'
    text += "payload_mass = 1.0\n"
    for axis in "xyz":
        text += f"[limits.{axis}]\nvelocity = 1.0\nacceleration = 1.0\njerk = 4.0\n"
    mission = load_mission(write(tmp_path, text, "mission.toml"))
    assert [w.dwell for w in mission.waypoints] == [0.0, 0.0, 0.0, 1.5, 0.5]
    assert mission.waypoints[1].velocity == "free"
    same = load_mission({
        "waypoints": str(tmp_path / "path.csv"), "crane": mission.crane, "limits": limits,
    })
    assert same.waypoints == mission.waypoints
    write(tmp_path, "x,y,z\n0,0,deep\n")
    with pytest.raises(InputError, match=r"mission.toml: waypoints: .*path.csv, line 2, column z"):
        load_mission(tmp_path / "mission.toml")


def test_a_mission_reads_no_further_than_it_can_plan(tmp_path: Path) -> None:
    """A table of 64 MB took minutes to be refused; what is behind is not looked at."""
    rows = [f"{i},0,-1" for i in range(257)]
    write(tmp_path, "\n".join(["x,y,z", *rows, "no number"]))
    mission = tmp_path / "mission.toml"
    crane = "crane = {bridge_mass = 2, trolley_mass = 1, payload_mass = 1}\n"
    mission.write_text(f'waypoints = "path.csv"\n{crane}', encoding="utf-8")
    with pytest.raises(InputError, match=r"path\.csv, line 258: more than 256 waypoints; leave "):
        load_mission(mission)
