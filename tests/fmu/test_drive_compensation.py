"""GantryFeedforward for drives with lag and dead time, in both backends and versions."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import segfmu
from segfmu.fmu.gantry_feedforward.interface import LIMITS, POINTS
from segfmu.kernels.crane.records import AXES, DRIVES
from tests.fmu.native.importer import Importer

LAG, DEAD = np.array([0.2, 0.05, 0.0]), np.array([0.02, 0.0, 0.31])
DRIVEN = {f"drive.{d}.lag": v for d, v in zip(DRIVES, LAG.tolist(), strict=True)}
DRIVEN |= {f"drive.{d}.dead_time": v for d, v in zip(DRIVES, DEAD.tolist(), strict=True)}
VELOCITY = [f"velocity.{d}" for d in DRIVES]
FORCE = [f"force.{d}" for d in DRIVES]
REFERENCE = [f"reference.{a}.{'length' if a == 'rope' else 'position'}" for a in AXES]
START = 0.5
KINDS = [("native", 2), ("native", 3), ("python", 2)]


@pytest.fixture(params=KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def archive(request, native_fmus, fmus):
    kind, fmi = request.param
    return native_fmus[fmi][0] if kind == "native" else fmus[0]


def inverse() -> segfmu.FlatInverse:
    limits = segfmu.Limits(*(np.array(list(LIMITS.values())).T))
    points = [segfmu.Waypoint(*map(list, p)) for p in POINTS]
    return segfmu.FlatInverse(segfmu.Crane(2.2, 1.155, 1.0), segfmu.plan(points, limits))


def test_setpoints_are_early_by_dead_time_and_lag(archive) -> None:
    flat = inverse()
    with Importer(archive) as fmu:
        fmu.set(DRIVEN | {"planner.start_time": START})
        fmu.initialise()
        assert fmu.get(*VELOCITY) == pytest.approx([0.0] * 3, abs=1e-12)
        for before, time in itertools.pairwise(np.arange(60) * 0.1):
            fmu.step(before, time - before)
            # the load moves the longest dead time after the start
            local = time - START - DEAD.max()
            assert fmu.get(*REFERENCE) == pytest.approx(flat.state(local)[:3], abs=1e-9)
            for i in range(3):
                t = local + DEAD[i]
                velocity = flat.velocity(t)[i] + LAG[i] * flat.acceleration(t)[i]
                assert fmu.get(VELOCITY[i])[0] == pytest.approx(velocity, abs=1e-9)
                assert fmu.get(FORCE[i])[0] == pytest.approx(flat.force(t)[i], abs=1e-9)
        end = START + DEAD.max() + flat.trajectory.duration
        assert fmu.get("plan.next_event")[0] == pytest.approx(end)


def test_events_are_those_of_reference_and_setpoints(archive) -> None:
    """A first-order hold of steps that end at all of them misses no kink."""
    flat = inverse()
    events = flat.trajectory.events + START + DEAD.max()
    expected = np.unique(np.round([events - d for d in (0.0, *DEAD)], 6))
    found, time = [], 0.0
    with Importer(archive) as fmu:
        fmu.set(DRIVEN | {"planner.start_time": START})
        fmu.initialise()
        while (ahead := float(fmu.get("plan.next_event")[0])) > time:
            fmu.step(time, ahead - time)
            time = ahead
            found.append(time)
    assert np.round(found, 6).tolist() == expected[expected > 0.0].tolist()
