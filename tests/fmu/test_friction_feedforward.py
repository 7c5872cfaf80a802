"""GantryFeedforward for a crane with friction: both backends and versions, and whole missions."""

from __future__ import annotations

import numpy as np
import pytest

import segfmu
from segfmu.crane import Friction
from segfmu.fmu.gantry_feedforward.interface import LIMITS, POINTS
from segfmu.kernels.crane.records import DRIVES
from tests.fmu.native.importer import Importer

FRICTION = Friction((2.0, 1.0, 0.5), (4.0, 3.0, 1.0), drag=(1.0, 0.0, 2.0), static=(5.0, 0.0, 1.2))
KNOWN = {
    f"friction.{d}.{name}": getattr(FRICTION, name)[i]
    for i, d in enumerate(DRIVES) for name in ("viscous", "coulomb", "drag", "static")
}
DEAD = np.array([0.02, 0.0, 0.31])
FORCE = [f"force.{d}" for d in DRIVES]
START = 0.5
KINDS = [("native", 2), ("native", 3), ("python", 2)]
LAB = segfmu.Crane(2.2, 1.155, 1.0)


@pytest.fixture(params=KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def archive(request, native_fmus, fmus):
    kind, fmi = request.param
    return native_fmus[fmi][0] if kind == "native" else fmus[0]


def inverse(friction: Friction) -> segfmu.FlatInverse:
    limits = segfmu.Limits(*(np.array(list(LIMITS.values())).T))
    points = [segfmu.Waypoint(*map(list, p)) for p in POINTS]
    return segfmu.FlatInverse(LAB, segfmu.plan(points, limits), friction)


@pytest.mark.parametrize("dead", [0.0 * DEAD, DEAD], ids=["at once", "late"])
def test_forces_have_the_friction_and_steps_end_where_it_changes(archive, dead) -> None:
    flat = inverse(FRICTION)
    late = {f"drive.{d}.dead_time": v for d, v in zip(DRIVES, dead.tolist(), strict=True)}
    with Importer(archive) as fmu:
        fmu.set(KNOWN | late | {"planner.start_time": START})
        fmu.initialise()
        time, visited = 0.0, 0
        while (ahead := float(fmu.get("plan.next_event")[0])) > time:
            # in the middle of a change as well
            for until in (0.5 * (time + ahead), ahead):
                fmu.step(time, until - time)
                time = until
                local = time - START - dead.max() + dead
                expected = [flat.force(t)[i] for i, t in enumerate(local)]
                assert fmu.get(*FORCE) == pytest.approx(expected, abs=1e-6)
            visited += 1
        # behind the plan only contacts are released, in no hurry
        assert time == pytest.approx(flat.trajectory.duration + START + dead.max())
        # from each of three starts and stops steps of a sixteenth
        assert visited > 60


def test_friction_of_zero_changes_no_bit(archive) -> None:
    rows = []
    for values in ({}, {"friction.width": 2e-3, "friction.presliding": 1e-6}):
        with Importer(archive) as fmu:
            fmu.set(values)
            fmu.initialise()
            found = []
            for k in range(60):
                fmu.step(0.1 * k, 0.1)
                found.append([*fmu.get(*FORCE), *fmu.get("plan.next_event")])
            rows.append(found)
    assert np.array(rows[0]).tobytes() == np.array(rows[1]).tobytes()


@pytest.mark.parametrize("fmi", [2, 3])
def test_static_friction_below_coulomb_friction_is_refused(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.set({"friction.trolley.coulomb": 4.0, "friction.trolley.static": 3.0})
        with pytest.raises(Exception, match="InitializationMode failed"):
            fmu.initialise()
        assert "friction.trolley.static 3 N must be 0 or at least friction.trolley.coulomb 4 N" in (
            " ".join(str(m) for m in fmu.messages)
        )


def mission(drives: float, **friction: float) -> segfmu.Mission:
    """The lab rig with force drives, each with the same friction, and a diagonal move."""
    names = ("bridge", "trolley", "hoist")
    crane = {
        "bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0,
        **{n: {"force_max": drives, "velocity_max": 1.0} for n in names[:2]},
        "hoist": {"force_max": 20.0}, "friction": dict.fromkeys(names, friction),
    }
    return segfmu.load_mission({
        "name": "friction", "crane": crane,
        "limits": segfmu.Limits(0.5, 0.5, 1.0, 10.0),
        "waypoints": [segfmu.Waypoint([0.0, 0.0, -0.5]), segfmu.Waypoint([1.0, 0.8, -0.4])],
        "simulation": {"feedback": False},
    })


@pytest.mark.parametrize("drives", [6.0, 100.0])
@pytest.mark.parametrize(
    "friction", [{"coulomb": 4.0}, {"coulomb": 3.0, "viscous": 2.0, "drag": 1.0}],
    ids=["coulomb", "all"],
)
def test_a_mission_whose_crane_states_friction_is_followed(drives: float, friction) -> None:
    """Nothing else says so: the plan, both FMUs and the run take it from the crane file."""
    run = segfmu.simulate(mission(drives, **friction))
    assert run.passed
    assert run.rows["error.load.norm"].max() < 1e-3
    assert run.rows["error.load.norm"][-1] < 1e-3
    for drive in DRIVES:
        assert not run.rows[f"drive.{drive}.saturated"].any()
        # and the drives need their friction: 343 mm were missed without
        assert run.rows[f"drive.{drive}.force"].std() > 0.5
