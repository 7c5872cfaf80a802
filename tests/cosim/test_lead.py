"""Importers that couple in parallel have the error of a sequential one with `setpoint.lead`.

The paper's mission, with feedback, by four importers. The load is judged against the plan itself as
well, which none of them has a part in.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.fmu.gantry_feedforward.interface import LIMITS, POINTS
from segfmu.planning import Limits, Waypoint, plan
from tests.cosim.pair import SIGNALS
from tests.cosim.test_ecos import ecos
from tests.cosim.test_libcosim import libcosim
from tests.fmu.native.importer import Importer

STOP = 5.0
# largest error of the load [m] by communication step [s]
BOUNDS = {0.001: 1e-6, 0.005: 1e-4}
LOAD = [f"load.position.{a}" for a in "xyz"]
Rows = dict[str, np.ndarray]


def loop(
    paths: tuple[Path, Path], *values: dict[str, Any], step: float, stop: float
) -> Rows:
    """A plain loop: all values are handed on, then both FMUs step."""
    names, rows = (*LOAD, "error.load.norm"), []
    with Importer(paths[0]) as source, Importer(paths[1]) as sink:
        for fmu, given in zip((source, sink), values, strict=True):
            fmu.set(given)
            fmu.begin()
        sink.write(tuple(SIGNALS), source.get(*SIGNALS))
        source.fmu.exitInitializationMode()
        sink.fmu.exitInitializationMode()
        for i in range(round(stop / step)):
            sink.write(tuple(SIGNALS), source.get(*SIGNALS))
            source.step(i * step, step)
            sink.step(i * step, step)
            rows.append(sink.get(*names))
    return dict(zip(names, np.array(rows).T, strict=True))


def master(
    paths: tuple[Path, Path], *values: dict[str, Any], step: float, stop: float
) -> Rows:
    """Our master in parallel coupling."""
    rows = simulate(*paths, stop_time=stop, step=step, source_values=values[0],
                    sink_values=values[1], coupling="parallel")[1:]
    return {n: rows[n] for n in rows.dtype.names}


IMPORTERS = {"loop": loop, "master": master, "libcosim": libcosim, "ecos": ecos}
# libcosim has no FMI 3.0
CASES = [(name, fmi) for name in IMPORTERS for fmi in (2, 3) if (name, fmi) != ("libcosim", 3)]


def planned(times: np.ndarray) -> np.ndarray:
    """The paper's load at these times, shape (times, 3)."""
    limits = Limits(*(np.array(list(LIMITS.values())).T))
    trajectory = plan([Waypoint(*map(list, p)) for p in POINTS], limits, smoothness=4)
    return np.asarray(trajectory(times))


@pytest.mark.parametrize("step", BOUNDS)
@pytest.mark.parametrize(("name", "fmi"), CASES)
def test_parallel_coupling_has_no_delay(native_fmus, name: str, fmi: int, step: float) -> None:
    found = IMPORTERS[name](
        native_fmus[fmi], {"setpoint.lead": step}, {"setpoint.lead": step}, step=step, stop=STOP
    )
    times = step * np.arange(1, round(STOP / step) + 1)
    apart = np.stack([found[n] for n in LOAD], axis=1) - planned(times)
    error = np.linalg.norm(apart, axis=1)
    assert error.max() <= BOUNDS[step]
    assert np.abs(found["error.load.norm"] - error).max() <= 1e-12


@pytest.mark.parametrize("fmi", (2, 3))
def test_a_loop_with_a_lead_is_a_sequential_one(native_fmus, fmi: int) -> None:
    """To the bit: the crane gets the same values at the same steps."""
    step = 0.005
    values = {"waypoint.count": 2, "setpoint.lead": step}
    found = master(native_fmus[fmi], values, {"sway.x.angle": 0.1}, step=step, stop=2.0)
    expected = simulate(
        *native_fmus[fmi], stop_time=2.0, step=step, source_values=values | {"setpoint.lead": 0.0},
        sink_values={"sway.x.angle": 0.1}, coupling="sequential", events=False,
    )[1:]
    assert np.abs(found["sway.x.angle"]).max() > 0.05
    for name in LOAD:
        assert np.abs(found[name] - expected[name]).max() <= 1e-12


@pytest.mark.parametrize("fmi", (2, 3))
def test_all_outputs_are_ahead(native_fmus, fmi: int) -> None:
    """Values and derivatives are those of a plan that starts earlier, and so are its events."""
    lead, step = 0.25, 0.01
    names = ("plan.next_event", "force.bridge", "velocity.trolley", "reference.rope.acceleration",
             "reference.load.snap.x", "reference.sway.y.rate")
    with Importer(native_fmus[fmi][0]) as led, Importer(native_fmus[fmi][0]) as early:
        led.set({"setpoint.lead": lead, "planner.start_time": 1.0})
        early.set({"planner.start_time": 1.0 - lead})
        for fmu in (led, early):
            fmu.initialise()
        for i in range(500):
            assert led.get(*names) == pytest.approx(early.get(*names), abs=1e-9)
            for fmu in (led, early):
                fmu.step(i * step, step)


def test_the_start_is_that_without_a_lead(native_fmus, fmus) -> None:
    """At initialisation the crane is to take its state from where it is, not from where it goes."""
    values = {"planner.start_time": -1.0, "setpoint.lead": 0.1}
    names = ("reference.load.position.x", "reference.bridge.velocity")
    for paths in (native_fmus[2], native_fmus[3], fmus):
        with Importer(paths[0]) as fmu:
            fmu.set(values)
            fmu.begin()
            before = fmu.get(*names)
            fmu.fmu.exitInitializationMode()
            after = fmu.get(*names)
        times = np.array([1.0, 1.1])
        assert [before[0], after[0]] == pytest.approx(planned(times)[:, 0].tolist(), abs=1e-9)
        assert before[1] != after[1]


def test_a_lead_below_zero_is_refused(native_fmus, fmus) -> None:
    for paths in (native_fmus[2], native_fmus[3], fmus):
        with Importer(paths[0]) as fmu:
            fmu.set({"setpoint.lead": -0.001})
            with pytest.raises(Exception, match="nitialization"):
                fmu.initialise()
            assert any("setpoint.lead must be at least 0" in m for m in fmu.messages)
