"""Commands while GantryFeedforward runs: as `segfmu.Operator`, in every archive."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.operated import LAB, PORT, Site, commands, parameters
from fmpy import simulate_fmu

from segfmu import Operator
from segfmu.cosim import System
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.gantry_feedforward import interface
from segfmu.kernels.crane.records import DRIVES
from segfmu.kernels.operation.records import OperationStatus
from segfmu.validation.pairs import with_arrays
from tests.campaign import campaign
from tests.compiler import require_native
from tests.cosim.probe.build import build
from tests.fmu.gantry_feedforward.test_drive_bounds import initialised
from tests.fmu.native.importer import Importer
from tests.fmu.native.test_state import restore, serialised

SITES = {"lab": LAB, "port": PORT}
MODES = {"mission": 1, "target": 2, "velocity": 3, "stop": 4, "inching": 5, "emergency": 6}
LOAD = [f"reference.load.{n}.{a}" for n in ("position", "velocity", "acceleration", "jerk", "snap")
        for a in "xyz"]
FORCE = [f"force.{d}" for d in ("bridge", "trolley", "hoist")]
KINDS = [("native", 2), ("native", 3), ("python", 2)]


@pytest.fixture(params=KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def archive(request, native_fmus, fmus) -> Path:
    kind, fmi = request.param
    return native_fmus[fmi][0] if kind == "native" else fmus[0]


def named(command: dict[str, Any]) -> dict[str, Any]:
    """A command as values of the FMU's variables."""
    values: dict[str, Any] = {
        "command.mode": MODES[command["mode"]], "limits.scale": command["scale"],
    }
    for name in ("velocity", "target"):
        values |= {f"command.{name}.{a}": float(v)
                   for a, v in zip("xyz", command[name], strict=True)}
    return values


def flag(fmu: Importer, name: str) -> bool:
    """Value of a Boolean."""
    reference = [fmu.variables[name].valueReference]
    return bool((fmu.fmu.getBoolean)(reference)[0])


def arrays(fmu: Importer, values: dict[str, Any]) -> dict[str, Any]:
    """With arrays in place of what FMI 3.0 has as such."""
    if not fmu.three:
        return values
    return with_arrays(interface.native_spec(), values)


def follow(fmu: Importer, site: Site, wanted: list[dict[str, Any]], first: int = 0) -> np.ndarray:
    """Load and forces after the step that follows each command."""
    rows = []
    for i, command in enumerate(wanted, first):
        fmu.set(named(command))
        fmu.step(i * site.step, site.step)
        rows.append(fmu.get(*LOAD, *FORCE))
    return np.array(rows)


def chosen(site: Site, seed: int, steps: int) -> list[dict[str, Any]]:
    """Random commands; the push is a parameter that stays."""
    wanted = commands(site, np.random.default_rng(seed), steps)
    return [{**c, "distance": 0.05 * site.step} for c in wanted]


def begun(fmu: Importer, site: Site) -> None:
    distance = {f"command.distance.{a}": 0.05 * site.step for a in "xyz"}
    fmu.set(arrays(fmu, parameters(site) | distance))
    fmu.initialise()


@campaign(1, 20, "seeds")
@pytest.mark.parametrize("name", SITES)
def test_an_fmu_moves_as_the_operator_does(archive, name: str, seeds: int) -> None:
    site = SITES[name]
    for seed in range(seeds):
        wanted = chosen(site, 2 + seed, 200)
        operator = site.operator()
        with Importer(archive) as fmu:
            begun(fmu, site)
            found = follow(fmu, site, wanted)
        for command, row in zip(wanted, found, strict=True):
            operator.command(**command)
            load = operator.step(site.step)
            scale = np.vstack([np.ones(3), site.limits.table(3, 4).T[:4]])
            assert (np.abs(row[:15].reshape(5, 3) - load) <= 1e-9 * scale).all()
            np.testing.assert_allclose(row[15:18], operator.setpoints[:3], rtol=1e-9, atol=1e-6)
        assert operator.plans > 5


@pytest.mark.parametrize("step", [0.03, 0.3])
def test_the_next_event_of_a_commanded_motion_is_never_past(archive, step: float) -> None:
    """A new plan has events within the step that begins it, and may end there."""
    velocities = ([0.3, 0.1, 0.0], [-0.2, 0.0, 0.1], [0.0, 0.0, 0.0])
    with Importer(archive) as fmu:
        fmu.set(arrays(fmu, parameters(LAB)))
        fmu.initialise()
        for i in range(120):
            wished = velocities[i // 7 % 3]
            fmu.set({"command.mode": MODES["velocity"]}
                    | {f"command.velocity.{a}": v for a, v in zip("xyz", wished, strict=True)})
            fmu.step(step * i, step)
            (following,), load = fmu.get("plan.next_event"), fmu.get(*LOAD[3:])
            done = flag(fmu, "plan.done")
            assert following > step * (i + 1) - 1e-9 or done
            assert done or np.abs(load).max() > 0.0


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_state_in_the_middle_goes_on_bit_for_bit(native_fmus, fmi: int) -> None:
    wanted = chosen(LAB, 3, 120)
    with Importer(native_fmus[fmi][0]) as fmu:
        begun(fmu, LAB)
        follow(fmu, LAB, wanted[:60])
        data = serialised(fmu)
        rest = follow(fmu, LAB, wanted[60:], 60)
    with Importer(native_fmus[fmi][0]) as fmu:
        begun(fmu, LAB)
        restore(fmu, data)
        np.testing.assert_array_equal(follow(fmu, LAB, wanted[60:], 60), rest)


def test_commands_have_to_be_enabled(archive) -> None:
    with Importer(archive) as fmu:
        fmu.set(arrays(fmu, parameters(LAB)) | {"command.enabled": False})
        fmu.initialise()
        row = follow(fmu, LAB, [c for c in chosen(LAB, 1, 200) if c["mode"] == "velocity"][:20])
    np.testing.assert_array_equal(row[:, 3:15], 0.0)


def test_the_mission_goes_on_without_a_command(archive) -> None:
    rows = {}
    for enabled in (False, True):
        with Importer(archive) as fmu:
            fmu.set({"command.enabled": enabled})
            fmu.initialise()
            rows[enabled] = []
            for i in range(40):
                fmu.step(0.1 * i, 0.1)
                rows[enabled].append(fmu.get(*LOAD, *FORCE, "plan.next_event"))
    np.testing.assert_array_equal(rows[True], rows[False])


def test_a_mission_is_left_for_a_stop(archive) -> None:
    with Importer(archive) as fmu:
        fmu.set({"command.enabled": True, "setpoint.lead": 0.01})
        fmu.initialise()
        before = []
        for i in range(150):
            fmu.step(0.01 * i, 0.01)
            before.append(fmu.get(*LOAD))
        fmu.set({"command.mode": 4})
        for i in range(150, 500):
            fmu.step(0.01 * i, 0.01)
            before.append(fmu.get(*LOAD))
        (ended,) = fmu.get("plan.next_event")
        done = flag(fmu, "plan.done")
    motion = np.array(before)
    assert np.abs(motion[149, 3:6]).max() > 0.1
    np.testing.assert_allclose(motion[-1, 3:], 0.0, atol=1e-9)
    assert motion[-1, 0] < 0.9
    # the acceleration is continuous, as the jerk is bounded by 1
    assert np.abs(np.diff(motion[:, 6:9], axis=0)).max() <= 0.0101
    assert done
    assert 1.5 < ended < 4.0


@pytest.mark.parametrize(("values", "words"), [
    ({"drive.hoist.dead_time": 0.1}, "drive.hoist.dead_time is 0.1 s: no command can be followed"),
    ({"friction.trolley.coulomb": 1.0}, "friction.trolley: no command can be followed"),
    ({"command.target.x": 1e300}, "command.target.x must be at least -1e+06 and at most 1e+06"),
    ({"waypoint[2].position.y": 1.1e6}, "must be at least -1e+06 and at most 1e+06, got 1100000"),
    ({"command.distance.z": 1.1e6}, "command.distance.z must be at least 0 and at most 1e+06"),
])
def test_what_is_in_the_way_of_commands_is_told(archive, values, words: str) -> None:
    found = initialised(archive, {"command.enabled": True} | values)
    assert isinstance(found, str)
    assert words in found


def test_smooth_friction_is_added(archive) -> None:
    with Importer(archive) as fmu:
        fmu.set({"command.enabled": True, "friction.bridge.viscous": 2.0, "command.mode": 3,
                 "command.velocity.x": 0.1})
        fmu.initialise()
        for i in range(600):
            fmu.step(0.01 * i, 0.01)
        speed, force = fmu.get("velocity.bridge", "force.bridge")
    assert speed == pytest.approx(0.1)
    assert force == pytest.approx(0.2)


def test_model_exchange_renews_what_is_held(native_fmus) -> None:
    operator = Operator(
        LAB.crane, LAB.limits, LAB.start, bounds=LAB.bounds, clearance=LAB.clearance
    )
    operator.command("velocity", velocity=[-0.3, 0.0, 0.0])
    for _ in range(200):
        operator.step(0.01)
    with Importer(native_fmus[2][0], "ModelExchange") as fmu:
        fmu.set(parameters(LAB) | {"command.mode": 3, "command.velocity.x": -0.3})
        fmu.initialise()
        time, events = 0.0, 0
        fmu.fmu.enterEventMode()
        following = fmu.event()
        while following < 2.0:
            assert following > time
            time = following
            fmu.fmu.setTime(time)
            fmu.fmu.enterEventMode()
            following = fmu.event()
            events += 1
        fmu.fmu.setTime(2.0)
        (velocity,) = fmu.get("reference.load.velocity.x")
        (place,) = fmu.get("reference.load.position.x")
    assert velocity == pytest.approx(-0.3)
    assert place == pytest.approx(operator.load[0, 0], abs=1e-9)
    assert events < 400


@pytest.mark.parametrize("fmi", [2, 3])
def test_model_exchange_follows_what_is_commanded_between_events(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][0], "ModelExchange") as fmu:
        given = parameters(LAB) | {"command.mode": 3, "planner.start_time": -5.0}
        fmu.set(arrays(fmu, given))
        fmu.initialise(-5.0)

        def asked(time: float, velocity: float) -> bool:
            fmu.fmu.setTime(time)
            fmu.set({"command.velocity.x": velocity})
            return bool(fmu.fmu.completedIntegratorStep()[0])

        assert not asked(-4.9, 0.0)
        assert asked(-4.8, -0.2)
        fmu.fmu.enterEventMode()
        fmu.event()
        # the same command, and one at once, as of a signal that changes all the time
        assert not asked(-4.7, -0.2)
        fmu.fmu.enterEventMode()
        fmu.event()
        assert not asked(-4.6999, -0.3)
        assert asked(-4.6, -0.3)
        fmu.fmu.enterEventMode()
        fmu.event()
        fmu.fmu.setTime(-4.55)
        assert fmu.get("reference.load.velocity.x") < 0.0
        with pytest.raises(Exception, match=r"Set(Real|Float64)"):
            fmu.set({"crane.payload_mass": 2.0})


@pytest.fixture(scope="module")
def connectable(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """Archives in which commands are inputs, by version of FMI."""
    require_native()
    return {
        fmi: build_all(
            tmp_path_factory.mktemp(f"connectable{fmi}"), Choice(True, fmi, connected=True),
            [interface.spec()],
        )[0]
        for fmi in (2, 3)
    }


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", SITES)
def test_a_joystick_is_an_input(native_fmus, connectable, name: str, fmi: int) -> None:
    """A signal that an importer connects acts as values that are set between steps."""
    site, step = SITES[name], SITES[name].step
    times = step * np.arange(200)
    fastest = site.limits.table(3, 4)[0, 0]
    stick = np.where(times < times[120], 0.4 * fastest * np.sign(np.sin(times / step / 15.0)), 0.0)
    with Importer(native_fmus[fmi][0]) as fmu:
        begun(fmu, site)
        still = {"mode": "velocity", "scale": 1.0, "target": [0.0] * 3}
        wanted = [still | {"velocity": [v, 0.0, 0.0]} for v in stick]
        expected = follow(fmu, site, wanted)[:, 0]
    values = parameters(site) | {"command.mode": 3}
    with Importer(native_fmus[fmi][0]) as fmu:
        # fmpy takes whole arrays; what fills up the rows that are not in use is no matter
        given = {
            n: np.resize(v, [int(d.start) for d in fmu.variables[n].dimensions]).ravel().tolist()
            if np.ndim(v) else v for n, v in arrays(fmu, values).items()
        }
    signal = np.array(
        list(zip(times, stick, strict=True)),
        dtype=[("time", float), ("command.velocity.x", float)],
    )
    found = simulate_fmu(
        str(connectable[fmi]), fmi_type="CoSimulation", stop_time=float(times[-1]),
        step_size=step, output_interval=step, start_values=given, input=signal,
        output=["reference.load.position.x"],
    )["reference.load.position.x"]
    assert found[1:] == pytest.approx(expected[: found.size - 1], rel=1e-9, abs=1e-12)
    assert np.ptp(expected) > 5.0 * fastest * step


def test_a_stick_that_is_an_fmu(native_fmus, connectable, tmp_path: Path) -> None:
    """An output of another FMU, which rises with time, commands the velocity."""
    with System(
        {"stick": build(tmp_path, 2), "planner": connectable[2]}, step=LAB.step,
        connections=[("stick", "y", "planner", "command.velocity.y")],
        coupling="sequential", events=False,
    ) as system:
        rows = system.run(stop_time=1.0, values={
            "stick": {"x": 0.5, "gain": -0.2}, "planner": parameters(LAB) | {"command.mode": 3},
        })
    # in sequence the planner has the stick at the end of its step
    still = {"mode": "velocity", "scale": 1.0, "target": [0.0] * 3}
    wanted = [still | {"velocity": [0.0, y, 0.0]} for y in rows["y"][1:].tolist()]
    with Importer(native_fmus[2][0]) as fmu:
        begun(fmu, LAB)
        expected = follow(fmu, LAB, wanted)
    for k, name in enumerate(LOAD):
        assert rows[name][1:] == pytest.approx(expected[:, k], rel=1e-9, abs=1e-9), name
    assert rows["reference.load.velocity.y"][-1] > 0.2


def test_an_emergency_stop_is_that_of_the_operator(archive: Path) -> None:
    moves = {"mode": "velocity", "velocity": [0.3, 0.2, 0.1], "target": [0.0] * 3, "scale": 1.0}
    wanted = [moves] * 20 + [moves | {"mode": "emergency"}] * 100
    operator = LAB.operator()
    with Importer(archive) as fmu:
        begun(fmu, LAB)
        found = follow(fmu, LAB, wanted)
    scale = np.vstack([np.ones(3), LAB.limits.table(3, 4).T[:4]])
    for command, row in zip(wanted, found, strict=True):
        operator.command(**command)
        load = operator.step(LAB.step)
        assert (np.abs(row[:15].reshape(5, 3) - load) <= 1e-8 * scale).all()
        np.testing.assert_allclose(row[15:18], operator.setpoints[:3], rtol=1e-8, atol=1e-6)
    assert operator.rests_at == np.inf


def test_the_swing_behind_an_emergency_stop_is_taken_over(archive: Path) -> None:
    moves = {"mode": "velocity", "velocity": [0.3, 0.2, 0.1], "target": [0.0] * 3, "scale": 1.0}
    wanted = [moves] * 20 + [moves | {"mode": "emergency"}] * 3 + [moves | {"mode": "stop"}] * 100
    wanted += [moves | {"velocity": [-0.2, 0.1, 0.0]}] * 80
    operator = LAB.operator()
    with Importer(archive) as fmu:
        begun(fmu, LAB)
        found = follow(fmu, LAB, wanted)
    scale = np.vstack([np.ones(3), LAB.limits.table(3, 4).T[:4]])
    rested = 0
    for command, row in zip(wanted, found, strict=True):
        operator.command(**command)
        load = operator.step(LAB.step)
        assert (np.abs(row[:15].reshape(5, 3) - load) <= 1e-8 * scale).all()
        np.testing.assert_allclose(row[15:18], operator.setpoints[:3], rtol=1e-8, atol=1e-6)
        rested += command["mode"] == "stop" and operator.time > operator.rests_at
    assert rested > 10
    np.testing.assert_allclose(operator.load[1], [-0.2, 0.1, 0.0], atol=1e-9)


def test_a_drive_trips_as_that_of_the_operator(archive: Path) -> None:
    moves = {"mode": "velocity", "velocity": [0.3, 0.2, 0.1], "target": [0.0] * 3, "scale": 1.0}
    wanted = [moves] * 80 + [moves | {"mode": "stop"}] * 60
    operator = LAB.operator(brakes=[0.3, 0.4, 1.2])
    foreseen = ["plan.emergency.duration", "plan.emergency.sway"]
    given = {f"drive.{d}.brake_deceleration": b
             for d, b in zip(DRIVES, (0.3, 0.4, 1.2), strict=True)}
    scale = np.vstack([np.ones(3), LAB.limits.table(3, 4).T[:4]])
    with Importer(archive) as fmu:
        fmu.set(given | {"command.foresees": True})
        begun(fmu, LAB)
        assert fmu.get(*foreseen).tolist() == [0.0, 0.0]
        for i, command in enumerate(wanted):
            if i == 20:
                operator.trip("bridge")
            if i == 24:
                operator.trip("hoist")
            if i == 70:
                operator.reset()
            fmu.set({f"command.tripped.{d}": d in operator.tripped for d in DRIVES})
            row = follow(fmu, LAB, [command], i)[0]
            operator.command(**command)
            load = operator.step(LAB.step)
            assert (np.abs(row[:15].reshape(5, 3) - load) <= 1e-8 * scale).all()
            np.testing.assert_allclose(row[15:18], operator.setpoints[:3], rtol=1e-8, atol=1e-6)
            told = operator.emergency
            np.testing.assert_allclose(
                fmu.get(*foreseen), [told.duration, told.sway], rtol=1e-7, atol=1e-9
            )
    assert operator.time > operator.rests_at


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_drive_trips_during_a_mission(native_fmus, fmi: int) -> None:
    """No command was given before; without a bound of an acceleration it is a stop."""
    for bound in (0.9, 0.0):
        moves = {f"waypoint[2].position.{a}": p
                 for a, p in zip("xyz", (0.5, 0.3, -0.4), strict=True)}
        given = parameters(LAB) | moves | {"obstacle.count": 0} | {
            f"drive.{d}.acceleration_max": bound for d in DRIVES
        }
        with Importer(native_fmus[fmi][0]) as fmu:
            fmu.set(arrays(fmu, given))
            fmu.initialise()
            for i in range(200):
                if i == 60:
                    before = np.array(fmu.get("velocity.bridge"))
                    fmu.set({"command.tripped.bridge": True})
                fmu.step(i * LAB.step, LAB.step)
                if i == 61:
                    after = np.array(fmu.get("velocity.bridge"))
            assert fmu.get("plan.emergency.sway").tolist() == [-1.0]
            assert fmu.get(*[f"velocity.{d}" for d in DRIVES]) == pytest.approx([0.0] * 3, abs=1e-9)
            assert fmu.get("reference.load.position.x")[0] < 0.49
            drop = (before - after)[0] / (2.0 * LAB.step)
            assert bool(drop == pytest.approx(0.9)) == (bound > 0.0)
            read = fmu.fmu.getInt32 if fmu.three else fmu.fmu.getInteger
            refused = read([fmu.variables["plan.refused"].valueReference])[0]
            assert refused == (0 if bound else OperationStatus.DRIVES)
