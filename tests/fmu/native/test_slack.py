"""A slack rope in the FMUs: the same numbers as in Python, its memory in the state, refusals."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from fmpy.fmi1 import FMICallException

from segfmu import Crane
from segfmu.crane import Plant, Rig, Setpoints, TravelLimits
from segfmu.crane.feedback import design
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.slave import CraneSlave
from tests.fmu.bench import Rows, SlaveBench, Values, bench
from tests.fmu.native.importer import Importer
from tests.fmu.native.test_state import restore, serialised

NAMES = [*gantry_crane.STATE, "rope.force", "energy.drives", "energy.dissipated",
         "energy.imbalance", "drive.hoist.power"]
TIMES = np.arange(81) * 0.005
START: Values = {
    "rope.slack": "free_fall", "drive.mode": "velocity", "feedback.enabled": False,
    "feedback.design": "flatness",
    "sway.x.angle": 0.1, "sway.y.rate": 0.3, "start.on_reference": False,
    "friction.hoist.viscous": 2.0,
}
VERSIONS = pytest.mark.parametrize("fmi", [2, 3])


def inputs(time: float) -> Values:
    """The drum is accelerated to 3 m/s within 0.15 s, and stops as fast."""
    return {"velocity.hoist": float(np.interp(time, (0.0, 0.15, 0.3), (0.0, 3.0, 0.0)))}


def of_plant() -> Rows:
    crane = Crane(2.2, 1.155, 1.0)
    start = crane.hanging([0.0, 0.0, -0.5])
    start[[3, 9]] = 0.1, 0.3
    own = {**{v.name: v.start for v in gantry_crane.spec().variables}, "rope.slack": 2,
           "friction.hoist.viscous": 2.0}
    rig = Rig.of(lambda name: 1 if name == "wind.gust.shape" else own[name])
    assert rig.travel.slack == "free_fall"
    gains = design(crane, sample_time=0.01, shortest=0.3, longest=2.0, driven=True)
    given = [Setpoints(velocity=np.array([0.0, 0.0, *inputs(t).values()])) for t in TIMES]
    plant = Plant(crane, start, given[0], gains, driven=True, enabled=False, rig=rig)
    rows: list[list[float]] = []
    for i in range(len(TIMES)):
        if i > 0:
            plant.step(TIMES[i] - TIMES[i - 1], given[i - 1])
        balance = plant.balance
        rows.append([
            *plant.state, plant.rope_force, balance.drives, balance.dissipated, balance.imbalance,
            plant.drive_power[2],
        ])
    return dict(zip(NAMES, np.array(rows).T.tolist(), strict=True))


def agree(found: Rows | None, messages: list[str]) -> None:
    assert found is not None, messages
    expected = of_plant()
    force = np.array(expected["rope.force"])
    slack = np.flatnonzero(force[1:] == 0.0)
    assert 30 < len(slack) < 70 and force[-1] < 0.0, "slack, then taut"
    assert expected["energy.dissipated"][-1] > 1.0
    for name in NAMES:
        size = max(1.0, float(np.abs(expected[name]).max()))
        assert found[name] == pytest.approx(expected[name], abs=1e-9 * size), name


@VERSIONS
def test_native_fmus_agree_with_python(native_fmus, fmi: int) -> None:
    with bench(native_fmus[fmi][1], gantry_crane.native_spec(), NAMES) as runs:
        agree(runs.run(START, inputs, TIMES), runs.messages)


def test_the_slave_agrees_with_python() -> None:
    runs = SlaveBench(CraneSlave, NAMES)
    agree(runs.run(START, inputs, TIMES), runs.messages)


@VERSIONS
def test_a_slack_rope_is_in_the_saved_state(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1]) as fmu:
        fmu.set(START)
        fmu.set(inputs(0.0))
        fmu.initialise()

        def run(times: np.ndarray) -> np.ndarray:
            rows = []
            for before, after in pairwise(times):
                fmu.set(inputs(before))
                fmu.step(before, after - before)
                rows.append(fmu.get(*NAMES))
            return np.array(rows)

        assert run(TIMES[:31])[-1, NAMES.index("rope.force")] == 0.0
        kept = serialised(fmu)
        expected = run(TIMES[30:])
        restore(fmu, kept)
        assert run(TIMES[30:]).tobytes() == expected.tobytes()
        assert expected[-1, NAMES.index("rope.force")] < 0.0


@VERSIONS
def test_model_exchange_has_no_slack_rope(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1], "ModelExchange") as unit:
        unit.set({"rope.slack": "free_fall"})
        with pytest.raises(FMICallException):
            unit.initialise()
        assert unit.messages == [
            "initialisation failed: in model exchange rope.slack must be error, got free_fall "
            "(the slack rope has no state there); use co-simulation"
        ]


def test_rig_keeps_what_it_is_given() -> None:
    rig = Rig(travel=TravelLimits(slack="free_fall"))
    assert rig.parameters(Crane(1.0, 1.0, 1.0), driven=True)[-1] == 1.0
