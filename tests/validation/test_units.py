"""Units in the headers of tables, and numbers in the units of the field."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from segfmu.cosim import write_csv
from segfmu.validation.signal_table import read_table
from segfmu.validation.units import labelled, powers, scale, shown, signal_units, unlike, with_unit
from tests.tables import columns


def test_headers_have_units_and_are_read_without() -> None:
    known = signal_units()
    assert known["time"] == "s"
    assert known["load.position.x"] == "m"
    assert known["sway.x.angle"] == "rad"
    assert known["drive.hoist.force"] == "N"


def test_a_table_is_read_as_it_was_written(tmp_path: Path) -> None:
    rows = np.zeros(3, dtype=[("time", float), ("load.position.x", float), ("a[1].b", float)])
    rows["time"], rows["a[1].b"] = [0.0, 0.1, 0.3], [1.0, 2.0, 1.0 / 3.0]
    path = tmp_path / "run.csv"
    write_csv(path, rows, signal_units())
    header = path.read_text(encoding="utf-8").splitlines()[0]
    assert header == '"time [s]","load.position.x [m]","a[1].b"'
    for found in (read_table(path), columns(path)):
        assert list(found) == list(rows.dtype.names or ())
        for name, values in found.items():
            assert np.array_equal(values, rows[name])


@pytest.mark.parametrize(("largest", "unit", "expected"), [
    (12.0, "N", (1.0, "N")), (4e5, "N", (1e-3, "kN")), (5.9e5, "W", (1e-3, "kW")),
    (0.1, "rad", (180.0 / np.pi, "deg")), (4e5, "m/s", (1.0, "m/s")),
    (0.5, "m/s2", (1.0, "m/s²")),
])
def test_units_follow_the_size(largest: float, unit: str, expected: tuple[float, str]) -> None:
    factor, name = scale(largest, unit)
    assert (factor, name) == (pytest.approx(expected[0]), expected[1])
    assert shown((largest, 0.0), unit)[0] == (pytest.approx(factor * largest), 0.0)


def test_powers_are_raised_where_people_read_them() -> None:
    units = ("m/s", "m/s2", "m/s3", "m/s4", "rad/s2", "kg/m3", "N.s/m", "")
    raised = ("m/s", "m/s²", "m/s³", "m/s⁴", "rad/s²", "kg/m³", "N.s/m", "")
    assert tuple(map(powers, units)) == raised == tuple(map(powers, raised))
    assert with_unit("2", "m/s2") == "2 m/s²"
    assert labelled("jerk", "m/s3") == "jerk [m/s³]"
    # what programs read keeps its units
    assert "m/s2" in signal_units().values() and "m/s²" not in signal_units().values()


@pytest.mark.parametrize(("names", "told"), [
    (["sway.total", "error.load.norm"], "sway.total is in rad, error.load.norm in m"),
    (["error.load.x", "third.signal", "load.velocity.x"],
     "error.load.x is in m, load.velocity.x in m/s"),
    (["bridge.position", "reference.bridge.position"], ""), (["third.signal", "sway.total"], ""),
    ([], ""),
])
def test_signals_of_different_units_are_told(names: list[str], told: str) -> None:
    assert unlike(names, signal_units()) == told
