"""Equal waypoints in a row are one waypoint in an FMU, whoever sets them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu

from segfmu import Limits, Waypoint, plan
from segfmu.fmu.gantry_feedforward import interface

PLACES = np.array([[0.1, 0.0, -0.5], [0.3, 0.2, -0.45], [0.7, 0.6, -0.4]])
LIMITS = Limits(*np.array(list(interface.LIMITS.values())).T)
# the place of each waypoint, and its dwell [s]
ROUTES = {
    "one": ([0, 1, 2], [0.0, 0.8, 0.0]),
    "repeated": ([0, 0, 1, 1, 2, 2], [0.0, 0.0, 0.3, 0.5, 0.0, 0.0]),
}
KINDS = [(fmi, kind) for fmi in (2, 3) for kind in ("CoSimulation", "ModelExchange")]
STOP = 7.0
OUTPUTS = ["reference.load.position.x", "reference.load.position.y", "reference.load.position.z"]


def start_values(path: Path, rows: list[int], dwells: list[float]) -> dict[str, object]:
    """The waypoints at rest as fmpy takes them: one by one, or as arrays of the declared size."""
    tables = {"position": PLACES[rows], "velocity": np.zeros((len(rows), 3)),
              "acceleration": np.zeros((len(rows), 3)), "dwell": np.array(dwells)}
    sizes = {v.name: np.prod(v.shape, dtype=int) if v.shape else 0
             for v in read_model_description(str(path)).modelVariables}
    values: dict[str, object] = {"waypoint.count": len(rows)}
    for name, table in tables.items():
        if f"waypoint.{name}" in sizes:
            padded = np.zeros(sizes[f"waypoint.{name}"])
            padded[: table.size] = table.ravel()
            values[f"waypoint.{name}"] = padded.tolist()
            continue
        for i, row in enumerate(table, 1):
            one = {"": row} if row.ndim == 0 else dict(zip((".x", ".y", ".z"), row, strict=True))
            values |= {f"waypoint[{i}].{name}{axis}": float(x) for axis, x in one.items()}
    return values


def run(path: Path, kind: str, rows: list[int], dwells: list[float]) -> np.ndarray:
    """Time, position and whether the plan is done; fmpy reads, sets and steps."""
    found = simulate_fmu(
        str(path), fmi_type=kind, stop_time=STOP, output_interval=0.02,
        start_values=start_values(path, rows, dwells), output=[*OUTPUTS, "plan.done"],
    )
    # of two rows at an event the last one is after it
    last = np.append(np.diff(found["time"]) > 1e-9, True)
    return np.column_stack([found[name][last] for name in ("time", *OUTPUTS, "plan.done")])


@pytest.mark.parametrize(("fmi", "kind"), KINDS)
@pytest.mark.parametrize("route", ROUTES)
def test_repeats_change_nothing(native_fmus, fmi: int, kind: str, route: str) -> None:
    expected = plan(
        [Waypoint(PLACES[0]), Waypoint(PLACES[1], dwell=0.8), Waypoint(PLACES[2])], LIMITS
    )
    found = run(native_fmus[fmi][0], kind, *ROUTES[route])
    assert 0.5 * STOP < expected.duration < STOP
    assert found[:, 1:4] == pytest.approx(expected(found[:, 0]), abs=1e-9)
    away = np.abs(found[:, 0] - expected.duration) > 1e-6
    assert np.array_equal(found[away, 4] > 0.5, found[away, 0] > expected.duration)


@pytest.mark.parametrize(("fmi", "kind"), KINDS)
def test_a_plan_to_where_the_load_is_takes_no_time(native_fmus, fmi: int, kind: str) -> None:
    found = run(native_fmus[fmi][0], kind, [1, 1, 1], [0.0] * 3)
    assert found[:, 1:4].tolist() == [PLACES[1].tolist()] * len(found)
    assert found[:, 4].all()
