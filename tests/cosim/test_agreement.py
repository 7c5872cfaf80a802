"""The loop through the FMUs and the same loop in pure Python give the same numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from segfmu import Crane, FlatInverse, plan
from segfmu.cosim import simulate
from segfmu.crane import Plant, Rig, Setpoints
from segfmu.crane.feedback import design
from segfmu.fmu.gantry_crane.rig_parameters import rig_parameters
from tests.campaign import soaked_rows
from tests.fmu.python.test_slaves import LIMITS, POINTS

# no step ends at the plan's event at 0.1 s, which is a rounding error before a tick
STEP, STOP = 0.003, 1.998
ENDS = ((-1.0, "min"), (1.0, "max"))
UNKIND = {
    "drive.bridge.lag": 0.025, "drive.trolley.lag": 0.013, "drive.trolley.acceleration_max": 0.4,
    "drive.trolley.dead_time": 0.0071,
    "drive.hoist.force_max": 14.0, "drive.bridge.acceleration_min": -0.3,
    "drive.trolley.acceleration_min": -0.25, "drive.trolley.force_min": -1.2,
    "drive.hoist.velocity_max": 0.3, "drive.hoist.velocity_min": -0.12,
    "friction.bridge.viscous": 5.0, "friction.trolley.coulomb": 0.5, "friction.hoist.viscous": 4.0,
    "friction.sway.viscous": 0.02,
    "sensor.sample_time": 0.01, "sensor.dead_time": 0.01, "sensor.seed": 2,
    "sensor.sway.x.angle.resolution": 2.0 * np.pi / 4096, "sensor.rope.length.offset": 0.02,
    "sensor.trolley.position.deviation": 1e-4,
    "wind.gust.start": 0.5, "wind.gust.duration": 0.7, "wind.gust.force.x": 0.5,
    "wind.noise.deviation.y": 0.1, "wind.noise.bandwidth": 3.0,
    "payload.count": 1, "payload[1].time": 1.1111, "payload[1].mass": 1.2,
}


def pure(driven: bool, values: dict[str, float], events: bool) -> tuple[list, list, list]:
    """States, measured signals and drive forces at every communication point.

    With events, steps end at those of the plan as well.
    """
    parameters = {v.name: v.start for v in rig_parameters()} | values
    crane = Crane(2.2, 1.155, 1.0, rope_min=0.16, rope_max=1.5)
    trajectory = plan(POINTS, LIMITS)
    inverse = FlatInverse(crane, trajectory)
    drives = ("bridge", "trolley", "hoist")
    late = parameters["sensor.dead_time"] + max(parameters[f"drive.{d}.dead_time"] for d in drives)
    bound = "acceleration" if driven else "force"
    pairs = [[parameters[f"drive.{d}.{bound}_{end}"] or s * 1e99 for s, end in ENDS]
             for d in drives]
    gains = design(
        crane, sample_time=0.01, shortest=0.16, longest=1.5, driven=driven,
        lag=[parameters[f"drive.{d}.lag"] for d in drives], dead_time=late,
        strongest=[min(most, -least) for least, most in pairs],
    )

    def setpoints(time: float) -> Setpoints:
        return Setpoints(inverse.force(time), inverse.velocity(time), inverse.state(time))

    plant = Plant(
        crane, crane.hanging([0.0, 0.0, -0.5]), setpoints(0.0), gains, driven=driven,
        rig=Rig.of(parameters.__getitem__),
    )
    rows = [(plant.state, plant.measured, plant.drive_force.copy())]
    for i in range(1, round(STOP / STEP) + 1):
        for time in trajectory.events if events else ():
            if plant.time < time < i * STEP:
                plant.step(time - plant.time, setpoints(time))
        plant.step(i * STEP - plant.time, setpoints(i * STEP))
        rows.append((plant.state, plant.measured, plant.drive_force.copy()))
    states, measured, forces = zip(*rows, strict=True)
    return list(states), list(measured), list(forces)


# each two of the three together, and in a soak all combinations
@pytest.mark.parametrize(("values", "driven", "events"), [
    ({}, False, False), ({}, True, True), (UNKIND, False, True), (UNKIND, True, False),
    *soaked_rows(
        ({}, False, True), ({}, True, False), (UNKIND, False, False), (UNKIND, True, True)
    ),
])
def test_fmus_and_python_agree(
    fmus: tuple[Path, Path], driven: bool, values, events: bool
) -> None:
    mode = {"drive.mode": "velocity" if driven else "force"}
    rows = simulate(
        *fmus, stop_time=STOP, step=STEP, sink_values={**mode, **values}, events=events
    )
    states, measured, forces = pure(driven, values, events)
    columns = [
        ("bridge.velocity", states, 5), ("trolley.position", states, 1), ("rope.length", states, 2),
        ("sway.x.angle", states, 3), ("sway.y.rate", states, 9),
        ("measured.trolley.position", measured, 1), ("measured.rope.length", measured, 2),
        ("measured.sway.x.angle", measured, 3), ("drive.bridge.force", forces, 0),
        ("drive.hoist.force", forces, 2),
    ]
    for name, table, i in columns:
        expected = np.array(table)[:, i]
        assert rows[name] == pytest.approx(expected, abs=1e-9 * np.abs(expected).max()), name
