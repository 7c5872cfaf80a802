"""Steps that end at the plan's events: feedforward alone, force mode, perfect model."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.cosim.load import load
from segfmu.errors import InputError
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.scenario import crane_values, feedforward_values
from tests.campaign import soaked
from tests.tables import require_length, rows_of

MODELS = Path(__file__).parents[2] / "models"
PAGE = MODELS.parent / "docs" / "cosimulation.md"
ALONE = {"feedback.enabled": False, "drive.mode": "force"}


def arrays(values: dict[str, Any]) -> dict[str, Any]:
    """Waypoints as FMI 3.0 has them."""
    rows: dict[str, list[Any]] = {}
    for name in [n for n in values if n.startswith("waypoint[")]:
        quantity = re.sub(r"\[\d+\]|\.[xyz]$", "", name)
        rows.setdefault(quantity, []).append(values[name])
    scalars = {n: v for n, v in values.items() if not n.startswith("waypoint[")}
    return {"waypoint.count": scalars.pop("waypoint.count"), **scalars, **rows}


def run(
    native_fmus, name: str, smoothness: int, shape: str, *, step: float, fmi: int = 2, **options
) -> np.ndarray:
    """Rows of a mission by feedforward alone."""
    changes = {"smoothness": smoothness, "shape": shape}
    task = load_mission(MODELS / f"{name}.toml").model_copy(update=changes)
    trajectory = task.plan()
    values = feedforward_values(task, trajectory)
    return simulate(
        *native_fmus[fmi], stop_time=trajectory.duration + 0.5, step=step,
        source_values=arrays(values) if fmi == 3 else values,
        sink_values=crane_values(task) | ALONE, **options,
    )


def errors(native_fmus, steps, *mission, **options) -> tuple[np.ndarray, float]:
    """Largest distances of the load from its plan [m], and their fitted order in the step."""
    found = np.array([
        run(native_fmus, *mission, step=float(h), **options)["error.load.norm"].max()
        for h in steps
    ])
    return found, float(np.polyfit(np.log(steps), np.log(found), 1)[0])


@pytest.mark.parametrize("name", ["paper", "pick_and_place", "inteco"])
@pytest.mark.parametrize("shape", ["plateau", "smoothstep"])
def test_derivatives_err_by_their_order_between_kinks(native_fmus, name: str, shape: str) -> None:
    """Smoothness 4, whose forces have kinks; below 1 nm, tolerances of the integration show."""
    steps = np.array([8e-3, 4e-3, 2e-3, 1e-3])
    found, order = errors(native_fmus, steps, name, 4, shape)
    assert found[0] < 2e-6 and found[-1] < 2e-9
    assert order > 2.0 or found[0] < 1e-9


@pytest.mark.parametrize("smoothness", [5, 6])
def test_derivatives_of_smoother_plans(native_fmus, smoothness: int) -> None:
    found, order = errors(
        native_fmus, np.array([2e-3, 1e-3, 5e-4]), "paper", smoothness, "smoothstep"
    )
    assert found[-1] < 1e-8
    assert order > 3.0


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", ["paper", "inteco"])
def test_linear_setpoints_err_by_second_order_between_kinks(
    native_fmus, name: str, fmi: int
) -> None:
    steps = np.array([2e-3, 1e-3, 5e-4])
    options: dict[str, Any] = {"coupling": "sequential", "fmi": fmi}
    found, order = errors(native_fmus, steps, name, 4, "plateau", **options)
    assert found[-1] < 2e-7
    assert order > 1.95
    over = run(native_fmus, name, 4, "plateau", step=1e-3, events=False, **options)
    # the kinks of the INTECO mission are small
    if fmi == 2 and name == "paper":
        assert over["error.load.norm"].max() > 50.0 * found[1]


def test_linear_setpoints_of_smooth_forces_err_by_second_order(native_fmus) -> None:
    """Smoothness 6 in equal steps, of which the shortest ramps have several."""
    found, order = errors(
        native_fmus, np.array([1e-3, 5e-4, 2.5e-4]), "paper", 6, "smoothstep",
        coupling="sequential", events=False,
    )
    assert found[0] < 1e-7
    assert order == pytest.approx(2.0, abs=0.1)


def test_both_versions_give_the_same_rows(native_fmus) -> None:
    two, three = (
        run(native_fmus, "paper", 4, "plateau", step=5e-3, fmi=fmi, coupling="sequential")
        for fmi in (2, 3)
    )
    assert two.dtype.names is not None and set(two.dtype.names) == set(three.dtype.names)
    for name in two.dtype.names:
        assert three[name] == pytest.approx(two[name], rel=1e-9, abs=1e-9), name


def test_a_later_start_of_the_plan_moves_its_events(native_fmus) -> None:
    late = {"planner.start_time": 0.35}
    rows = [
        simulate(*native_fmus[2], stop_time=4.0 + shift, step=5e-3, sink_values=ALONE,
                 source_values=values)
        for shift, values in ((0.0, {}), (0.35, late))
    ]
    assert rows[1]["plan.next_event"][0] == pytest.approx(0.35)
    shifted = rows[1][70:]
    assert shifted["plan.next_event"] == pytest.approx(rows[0]["plan.next_event"] + 0.35)
    assert shifted["bridge.velocity"] == pytest.approx(rows[0]["bridge.velocity"], abs=1e-8)
    assert shifted["error.load.norm"].max() < 1e-8


def test_fmi3_has_no_input_derivatives(native_fmus) -> None:
    with pytest.raises(InputError, match=r"FMI 3\.0 has no input derivatives; use coupling seq"):
        simulate(*native_fmus[3], stop_time=0.1, step=0.01, coupling="derivatives")


def test_arrays_of_fmi3_take_their_first_rows(native_fmus) -> None:
    with load(native_fmus[3][0]) as unit:
        for count in (4, 51):
            with pytest.raises(InputError, match="takes up to 48 values in rows of 3"):
                unit.set({"waypoint.position": [0.0] * count})
        unit.set({"waypoint.position": [[0.1, 0.2, -0.6]]})
        channel = unit.channel(["waypoint.position"])
        channel.read()
        assert channel.values[:6].tolist() == [0.1, 0.2, -0.6, 0.07, 0.055, -0.5]


COUPLINGS: tuple[dict[str, Any], ...] = (
    {"coupling": "sequential", "events": False}, {"coupling": "sequential"}, {},
)
TOLD = rows_of(PAGE, "mission, ramps")


@pytest.mark.parametrize("row", [TOLD[0], *soaked(*TOLD[1:])], ids=lambda row: " ".join(row[:2]))
def test_errors_of_the_couplings_are_as_told(native_fmus, row: list[str]) -> None:
    """Steps of 8 to 0.5 ms; told is the error at 1 ms, and its order where errors have one."""
    name, shape = row[0].lower().replace(" ", "_").split(",_")
    steps = 8e-3 / 2.0 ** np.arange(5)
    for told, options in zip(row[2:], COUPLINGS, strict=True):
        length, _, order = told.partition(", ")
        found, fitted = errors(native_fmus, steps, name, int(row[1]), shape, **options)
        require_length(length, float(found[3]))
        assert not order or fitted == pytest.approx(float(order), abs=0.3), (told, fitted)
