"""What native FMUs say of a crane that the table of gains, or the interface, is not for."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from fmpy.fmi1 import FMICallException

from tests.fmu.native.importer import Importer

WARNING = (
    "the gains of feedback.table, design lqr, were made for other values of {}; set "
    "feedback.design to flatness, or build the FMU with these values"
)


def said(path, values: dict[str, Any], kind: str = "CoSimulation", logging: bool = True) -> list:
    """Messages of an initialisation with these parameters."""
    with Importer(path, kind) as unit:
        unit.fmu.setDebugLogging(logging, [])
        unit.set(values)
        unit.initialise()
        return list(unit.messages)


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize(
    ("values", "names"),
    [
        ({"crane.trolley_mass": 3.0}, "crane.trolley_mass"),
        (
            {"crane.bridge_mass": 9.0, "crane.payload_mass": 2.0, "crane.gravity": 1.62},
            "crane.bridge_mass, crane.gravity, crane.payload_mass",
        ),
        ({"feedback.payload_mass": 2.0}, "feedback.payload_mass"),
        (
            {"feedback.sample_time": 0.02, "rope.length": 9.0},
            "feedback.sample_time, rope.length",
        ),
    ],
)
def test_warns_of_a_crane_that_the_table_is_not_for(
    native_fmus, fmi: int, values: dict[str, Any], names: str
) -> None:
    path = native_fmus[fmi][1]
    for kind in ("CoSimulation", "ModelExchange"):
        assert said(path, values, kind) == [WARNING.format(names)]
    # without logging as well: the numbers would be wrong in silence
    assert said(path, values, logging=False) == [WARNING.format(names)]
    # the way out that the message names
    assert said(path, values | {"feedback.design": "flatness"}) == []


@pytest.mark.parametrize("fmi", [2, 3])
def test_is_silent_where_the_table_fits(native_fmus, fmi: int) -> None:
    path = native_fmus[fmi][1]
    table = "feedback.table.length" if fmi == 3 else "feedback.table[1].length"
    with Importer(path) as unit:
        mass = float(unit.variables["crane.payload_mass"].start)
        own = np.array(str(unit.variables[table].start).split(), float)
    assert said(path, {}) == []
    # a load that is not the one of the design, on purpose
    assert said(path, {"crane.payload_mass": 2.0 * mass, "feedback.payload_mass": mass}) == []
    # a table of the user's for a crane of the user's
    assert said(path, {table: 1.001 * own, "crane.trolley_mass": 3.0}) == []


@pytest.mark.parametrize("fmi", [2, 3])
def test_warns_of_a_feedback_that_is_unstable_with_the_drives(native_fmus, fmi: int) -> None:
    """The true state is not predicted over a dead time; an observer does this."""
    path = native_fmus[fmi][1]
    late = {
        "drive.mode": "velocity", "feedback.design": "flatness", "drive.bridge.dead_time": 0.3
    }
    text, = said(path, late)
    assert text.startswith("the feedback of the bridge is unstable at ")
    assert "drive.bridge.dead_time" in text and "feedback.source to measured" in text
    assert said(path, late | {"feedback.source": "measured"}) == []
    assert said(path, late | {"feedback.enabled": False}) == []


@pytest.mark.parametrize("fmi", [2, 3])
def test_the_status_is_that_of_a_warning(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1]) as unit:
        unit.set({"crane.trolley_mass": 3.0})
        unit.initialise()
        assert unit.categories == [(1, "logStatusWarning")]


@pytest.mark.parametrize("fmi", [2, 3])
def test_model_exchange_names_the_velocity_drive_without_a_lag(native_fmus, fmi: int) -> None:
    path = native_fmus[fmi][1]
    lags = {f"drive.{n}.lag": 0.05 for n in ("bridge", "trolley", "hoist")}
    values = {"drive.mode": "velocity", "feedback.design": "flatness"}
    for drive in ("bridge", "trolley", "hoist"):
        with Importer(path, "ModelExchange") as unit:
            unit.set(values | lags | {f"drive.{drive}.lag": 0.0})
            with pytest.raises(FMICallException):
                unit.initialise()
            assert unit.messages == [
                f"initialisation failed: in model exchange with drive.mode velocity, "
                f"drive.{drive}.lag must be above 0 s (without lag the setpoints do not "
                "determine the acceleration); set a lag, or use co-simulation"
            ]
    # both ways out
    assert said(path, values | lags, "ModelExchange") == said(path, values) == []


@pytest.mark.parametrize("fmi", [2, 3])
def test_model_exchange_names_the_drive_with_a_dead_time(native_fmus, fmi: int) -> None:
    path, values = native_fmus[fmi][1], {"drive.hoist.dead_time": 0.02}
    with Importer(path, "ModelExchange") as unit:
        unit.set(values)
        with pytest.raises(FMICallException):
            unit.initialise()
        assert unit.messages == [
            "initialisation failed: in model exchange drive.hoist.dead_time must be 0 s, got "
            "0.02 s (the setpoints of the past are the importer's); delay the setpoints in the "
            "importer, or use co-simulation"
        ]
    assert said(path, values) == []


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_dead_time_for_which_there_is_no_memory_is_refused(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1]) as unit:
        unit.set({"drive.bridge.dead_time": 1e6})
        with pytest.raises(FMICallException):
            unit.initialise()
        assert unit.messages == [
            "initialisation failed: drive.bridge.dead_time 1000000 s is longer than 100000 periods "
            "of 0.01 s; lower it or raise feedback.sample_time"
        ]
