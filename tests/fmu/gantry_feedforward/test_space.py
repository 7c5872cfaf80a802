"""Workspace and obstacles as parameters of GantryFeedforward, beside dense samples of the path."""

from __future__ import annotations

import re

import numpy as np
import pytest

import segfmu
from segfmu.cosim.load import load
from segfmu.fmu.gantry_feedforward import interface
from segfmu.fmu.native.archive import build_all
from segfmu.validation.pairs import with_arrays
from tests.campaign import soaked
from tests.compiler import require_native
from tests.fmu.gantry_feedforward.test_drive_bounds import initialised

GRAVITY = 9.81
# largest way and rope of a lab rig and of a ship-to-shore crane [m]
SIZES = {"lab": (1.0, 0.8), "ship to shore": (60.0, 30.0)}


def planned(rng, way, rope) -> tuple[segfmu.Trajectory, dict[str, float]]:
    """A plan over three waypoints and the parameters of it."""
    points = way * rng.uniform(-0.5, 0.5, (3, 3))
    points[:, 2] = -rope * rng.uniform(0.5, 1.2, 3)
    swing = (rope / GRAVITY) ** 0.5
    limits = [0.2 * way / swing, 0.1 * way / swing**2, 0.3 * way / swing**3, way / swing**4]
    values = {"waypoint.count": 3.0, "crane.rope_max": 0.0, "crane.rope_min": 0.0}
    for k, axis in enumerate("xyz"):
        names = ("velocity", "acceleration", "jerk", "snap")
        values |= {f"limits.{axis}.{n}": v for n, v in zip(names, limits, strict=True)}
        for i, point in enumerate(points, 1):
            values[f"waypoint[{i}].position.{axis}"] = float(point[k])
            values[f"waypoint[{i}].velocity.{axis}"] = 0.0
            values[f"waypoint[{i}].acceleration.{axis}"] = 0.0
    found = segfmu.plan([segfmu.Waypoint(p) for p in points], segfmu.Limits(*limits))
    return found, values


def samples(trajectory) -> tuple[np.ndarray, np.ndarray]:
    """Places of the load (times, 3), and of the rope from load to trolley (times, 60, 3)."""
    times = np.linspace(0.0, trajectory.duration, 3000)
    load, pull = trajectory(times), np.add(trajectory(times, 2), (0.0, 0.0, GRAVITY))
    top = load - load[:, 2:] / pull[:, 2:] * pull
    shares = np.linspace(0.0, 1.0, 60)[:, None]
    return load, load[:, None, :] + shares * (top - load)[:, None, :]


def depth(places, low, high) -> float:
    """How far places (..., 3) are inside a box at most [m]; negative outside."""
    return float(np.minimum(places - low, high - places).min(axis=-1).max())


def boxes_of(rng, way, load, count) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Corners of random boxes near a path, and their margins."""
    centres = load[rng.integers(len(load), size=count)] + way * rng.uniform(-0.3, 0.3, (count, 3))
    half = way * rng.uniform(0.01, 0.1, (count, 3))
    return centres - half, centres + half, way * rng.uniform(0.0, 0.02, count)


@pytest.mark.parametrize("size", ["ship to shore", *soaked("lab")])
def test_what_samples_meet_is_refused_and_nothing_else(native_fmus, size) -> None:
    rng = np.random.default_rng(4)
    way, rope = SIZES[size]
    told = {"clear": 0, "load": 0, "rope": 0}
    for _ in range(40):
        trajectory, values = planned(rng, way, rope)
        load, line = samples(trajectory)
        low, high, margin = boxes_of(rng, way, load, 2)
        edges = way * rng.uniform(0.0, 0.05, 3)
        values |= {f"load.size.{a}": float(e) for a, e in zip("xyz", edges, strict=True)}
        values["obstacle.count"] = 2
        for i in range(2):
            name = f"obstacle[{i + 1}]"
            values[f"{name}.margin"] = float(margin[i])
            for k, a in enumerate("xyz"):
                values[f"{name}.minimum.{a}"] = float(low[i, k])
                values[f"{name}.maximum.{a}"] = float(high[i, k])
        gaps = margin[:, None] + np.zeros(3), margin[:, None] + 0.5 * edges
        met = {
            part: [depth(places, low[i] - gap[i], high[i] + gap[i]) for i in range(2)]
            for part, places, gap in (("rope", line, gaps[0]), ("load", load, gaps[1]))
        }
        found = initialised(native_fmus[2][0], values)
        # samples pass a corner by less than this
        near = 2e-3 * way
        if isinstance(found, str):
            box, part = re.search(r"obstacle (\d): the (load|rope) meets it", found).groups()
            assert met[part][int(box) - 1] > -near, (found, met)
            told[part] += 1
        else:
            assert max(met["load"] + met["rope"]) < near, met
            told["clear"] += 1
    assert min(told.values()) > 2, told


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("axis", range(3))
@pytest.mark.parametrize("end", ["min", "max"])
def test_the_workspace_may_be_touched_and_not_left(native_fmus, size, axis, end) -> None:
    way, rope = SIZES[size]
    trajectory, values = planned(np.random.default_rng(7 + axis), way, rope)
    reached = float(trajectory.extrema(0)[end == "max"][axis])
    inwards = way * (1e-6 if end == "min" else -1e-6)
    name = f"workspace.{'xyz'[axis]}.{end}"
    assert isinstance(initialised(native_fmus[2][0], values | {name: reached}), dict)
    found = initialised(native_fmus[2][0], values | {name: reached + inwards})
    assert isinstance(found, str)
    assert f"workspace.{'xyz'[axis]}: the load leaves its end at" in found


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"workspace.y.min": 2.0, "workspace.y.max": 2.0},
         "workspace.y: minimum must be below its maximum 2 m, got 2 m"),
        ({"obstacle.count": 2, "obstacle[2].maximum.z": -1.0},
         "obstacle[2]: minimum.z must be below its maximum -1 m, got 0 m"),
        ({"obstacle.count": 17}, "obstacle.count must be at"),
        ({"obstacle[3].margin": -0.1}, "obstacle[3].margin must be at least 0, got -0.1"),
        ({"load.size.x": float("nan")}, "load.size.x"),
    ],
)
@pytest.mark.parametrize("fmi", [2, 3])
def test_wrong_boxes_are_refused_by_name(native_fmus, fmi, values, words) -> None:
    found = initialised(native_fmus[fmi][0], values)
    assert isinstance(found, str)
    assert (words if fmi == 2 else words.replace("[3].margin", ".margin[3]")) in found


@pytest.mark.parametrize("waypoints", [4, 30])
def test_obstacles_are_arrays_in_fmi_3(tmp_path, waypoints) -> None:
    """All 16 boxes, whatever the room for waypoints is."""
    require_native()
    spec = interface.native_spec(interface.spec(waypoints))
    (archive,) = build_all([spec], tmp_path, fmi=3)
    corners = np.arange(48.0).reshape(16, 3)
    rows = {"minimum": corners, "maximum": corners + 1.0, "margin": np.arange(16.0) / 8.0,
            "rope": np.arange(16) % 3 == 0}
    with load(archive) as unit:
        for name, given in rows.items():
            unit.set({f"obstacle.{name}": given.tolist()})
        unit.set({"waypoint.position": np.full((waypoints, 3), -0.5).tolist()})
        for name, given in rows.items():
            channel = unit.channel([f"obstacle.{name}"])
            channel.read()
            assert channel.values.reshape(given.shape).tolist() == given.tolist()
    rope = {"obstacle.count": 16, "obstacle.minimum": [[9.0, 9.0, -9.0]] * 16,
            "obstacle.maximum": [[9.5, 9.5, 9.0]] * 15 + [[9.5, 9.5, -10.0]]}
    told = initialised(archive, rope)
    assert "obstacle[16]: minimum.z must be below its maximum -10 m, got -9 m" in told
    rope["obstacle.maximum"][15] = [9.5, 9.5, 9.0]
    assert isinstance(initialised(archive, rope), dict)


def test_rows_that_are_not_given_are_those_of_the_archive() -> None:
    spec = interface.native_spec()
    given = {"obstacle.count": 2, "obstacle[2].minimum.y": -3.0, "drive.hoist.lag": 0.1}
    assert with_arrays(spec, given) == {
        "obstacle.count": 2, "drive.hoist.lag": 0.1,
        "obstacle.minimum": [0.0, 0.0, 0.0, 0.0, -3.0, 0.0], "obstacle.maximum": [1.0] * 6,
        "obstacle.margin": [0.0, 0.0], "obstacle.rope": [True, True],
    }
