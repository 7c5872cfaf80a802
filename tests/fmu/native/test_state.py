"""Saved states, many instances, and calls that are refused."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pytest

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from tests.campaign import campaign
from tests.compiler import optimised
from tests.fmu.native.importer import Importer

CRANE = {"sway.x.angle": 0.1, "force.hoist": -9.81, "reference.rope.length": 0.5,
         "sensor.sample_time": 0.013, "sensor.dead_time": 0.05, "drive.trolley.dead_time": 0.031,
         "sensor.sway.x.angle.deviation": 1e-3, "wind.noise.deviation.x": 0.2,
         "friction.bridge.coulomb": 0.1}

each = pytest.mark.parametrize(("fmi", "index"), [(2, 0), (2, 1), (3, 0), (3, 1)])


def start(fmu: Importer, index: int) -> None:
    if index == 1:
        fmu.set(CRANE)
    fmu.initialise()


def run(fmu: Importer, first: int, last: int) -> np.ndarray:
    """Real outputs after steps of varied lengths."""
    outputs = [
        n for n, v in fmu.variables.items()
        if v.causality == "output" and v.type in ("Real", "Float64")
    ]
    times = 0.007 * np.arange(last + 1) + 0.002 * np.sin(np.arange(last + 1))
    times[0] = 0.0
    rows = []
    for i in range(first, last):
        fmu.step(times[i], times[i + 1] - times[i])
        rows.append(fmu.get(*outputs))
    return np.array(rows)


def serialised(fmu: Importer) -> bytes:
    library = fmu.fmu
    if fmu.three:
        state = library.getFMUState()
        data = library.serializeFMUState(state)
        library.freeFMUState(state)
    else:
        state = library.getFMUstate()
        data = library.serializeFMUstate(state)
        library.freeFMUstate(state)
    return data


def restore(fmu: Importer, data: bytes) -> None:
    library = fmu.fmu
    if fmu.three:
        library.setFMUState(library.deserializeFMUState(data))
    else:
        library.setFMUstate(library.deSerializeFMUstate(data))


@each
def test_a_fresh_instance_goes_on_bit_for_bit(
    native_fmus, fmi: int, index: int, tmp_path: Path
) -> None:
    path = native_fmus[fmi][index]
    with Importer(path) as fmu:
        start(fmu, index)
        run(fmu, 0, 40)
        (tmp_path / "state").write_bytes(serialised(fmu))
        expected = run(fmu, 40, 80)
    with Importer(path) as fmu:
        restore(fmu, (tmp_path / "state").read_bytes())
        assert run(fmu, 40, 80).tobytes() == expected.tobytes()


@each
def test_a_step_can_be_taken_back(native_fmus, fmi: int, index: int) -> None:
    with Importer(native_fmus[fmi][index]) as fmu:
        start(fmu, index)
        run(fmu, 0, 10)
        data = serialised(fmu)
        first = run(fmu, 10, 30)
        restore(fmu, data)
        assert serialised(fmu) == data
        assert run(fmu, 10, 30).tobytes() == first.tobytes()


@each
def test_reading_changes_nothing(native_fmus, fmi: int, index: int) -> None:
    with Importer(native_fmus[fmi][index]) as fmu:
        start(fmu, index)
        expected = run(fmu, 0, 30)
    with Importer(native_fmus[fmi][index]) as fmu:
        start(fmu, index)
        reference = fmu.variables["load.position.x" if index else "force.bridge"].valueReference
        library, rows = fmu.fmu, []
        read = library.getOutputDerivatives if fmu.three else library.getRealOutputDerivatives
        for i in range(30):
            rows.append(run(fmu, i, i + 1)[0])
            assert np.isfinite(read([reference], [1])).all()
            serialised(fmu)
        assert np.array(rows).tobytes() == expected.tobytes()


@each
def test_damaged_and_foreign_states_are_refused(native_fmus, fmi: int, index: int) -> None:
    with Importer(native_fmus[fmi][index]) as fmu, Importer(native_fmus[fmi][1 - index]) as other:
        start(fmu, index)
        start(other, 1 - index)
        good = serialised(fmu)
        for bad, words in (
            (good[:-8], f"damaged: its header is that of {len(good)} bytes, there are "
                        f"{len(good) - 8}"),
            (good[:-1], f"there are {len(good) - 1}"),
            (good + b"\0", f"there are {len(good) + 1}"),
            (good[: len(good) // 2] + b"\1" + good[len(good) // 2 + 1 :], "damaged"),
            (b"", "0 bytes are not a saved state"),
            (b"nonsense" * 10, "no saved state"),
            (serialised(other), "another model"),
        ):
            with pytest.raises(Exception, match="ialize"):
                restore(fmu, bad)
            assert words in fmu.messages[-1]
        assert serialised(fmu) == good


@pytest.mark.parametrize("fmi", [2, 3])
def test_states_of_another_mission_or_interface_tell_what_differs(
    native_fmus, tmp_path: Path, fmi: int
) -> None:
    spec = gantry_feedforward.native_spec(gantry_feedforward.spec(8))
    other, = native.build_all([spec], tmp_path, fmi=fmi)
    usual = native_fmus[fmi][0]
    with Importer(usual) as fmu, Importer(usual, "ModelExchange") as exchange, \
            Importer(other) as mission:
        start(fmu, 0)
        good = serialised(fmu)
        for foreign, words in ((mission, "another GUID"), (exchange, "one of co-simulation")):
            with pytest.raises(Exception, match="ialize"):
                restore(foreign, good)
            assert words in foreign.messages[-1]
        with pytest.raises(Exception, match="ialize"):
            restore(fmu, serialised(exchange))
        assert "one of model exchange" in fmu.messages[-1]


def test_states_of_the_other_version_of_fmi_are_refused(native_fmus) -> None:
    with Importer(native_fmus[2][0]) as two, Importer(native_fmus[3][0]) as three:
        for one, other in ((two, three), (three, two)):
            start(one, 0)
            with pytest.raises(Exception, match="ialize"):
                restore(other, serialised(one))
            assert "another version of FMI" in other.messages[-1]


def test_states_of_another_build_are_refused(native_fmus, tmp_path: Path, monkeypatch) -> None:
    """As they are where only a record of the kernels has changed, and the interface has not."""
    packaged = native._packaged

    def changed(package: str, names: Iterable[str]) -> dict[str, bytes]:
        texts = packaged(package, names)
        return {n: t + b"/* changed */\n" if n == "records.h" else t for n, t in texts.items()}

    monkeypatch.setattr(native, "_packaged", changed)
    monkeypatch.setattr(native, "sources", native.sources.__wrapped__)  # its cache has the old ones
    # so little runs sooner than an optimised program compiles
    with optimised("-Og"):
        path, = native.build_all([gantry_crane.native_spec()], tmp_path)
    with Importer(native_fmus[2][1]) as old, Importer(path) as new:
        assert old.description.guid == new.description.guid
        start(old, 1)
        with pytest.raises(Exception, match="ialize"):
            restore(new, serialised(old))
        assert "another build" in new.messages[-1]


def resident() -> int:
    """Bytes of memory in use by this process."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is read from /proc")
@campaign(400, 1000)
@each
def test_memory_stays_flat_over_many_instances(
    native_fmus, fmi: int, index: int, count: int
) -> None:
    sizes = []
    with Importer(native_fmus[fmi][index]) as fmu:
        for i in range(count):
            start(fmu, index)
            fmu.step(0.0, 0.002)
            state = serialised(fmu) if i % 100 == 0 else b""
            free = fmu.fmu.fmi3FreeInstance if fmu.three else fmu.fmu.fmi2FreeInstance
            free(fmu.fmu.component)
            assert state is not None
            if fmu.three:
                fmu.fmu.instantiate(logMessage=fmu._log, loggingOn=False)
            else:
                fmu.fmu.instantiate(callbacks=fmu.fmu.callbacks, loggingOn=False)
            if i in (count // 5, count - 1):
                sizes.append(resident())
    assert sizes[1] - sizes[0] < 4_000 * count


def test_instances_do_not_disturb_each_other(native_fmus) -> None:
    path = native_fmus[2][1]
    with Importer(path) as alone:
        start(alone, 1)
        expected = run(alone, 0, 20)
    with Importer(path) as one, Importer(path) as two:
        start(one, 1)
        two.set({"crane.payload_mass": 2.0, "force.hoist": -19.62})
        two.initialise()
        rows = []
        for i in range(20):
            rows.append(run(one, i, i + 1)[0])
            run(two, i, i + 1)
        assert np.array(rows).tobytes() == expected.tobytes()


REFUSED = [
    ({"waypoint[2].velocity.y": 0.5}, "axis y, waypoint 2: velocity 0.5 m/s exceeds the limit"),
    ({"waypoint[2].velocity.x": 0.99, "limits.x.jerk": 0.1},
     "axis x, waypoints 2 -> 3: braking the first"),
    ({"crane.rope_max": 0.3}, "rope_max"),
    ({"limits.x.velocity": 0.0}, "limits.x.velocity must be greater than 0"),
    ({"waypoint[3].position.z": 0.4}, "trolley's height"),
    ({"limits.x.jerk": 0.0, "limits.x.snap": 0.0}, "no limit bounds the duration"),
    ({"planner.duration": 1.0}, "duration 1 s is shorter than the shortest plan, 3.96"),
    ({"waypoint[2].dwell": 1.0}, "a dwell needs a waypoint at rest"),
    ({"waypoint.count": 17}, "waypoint.count must be at least 2 and at most 16, got 17"),
    ({"crane.payload_mass": -1.0}, "crane.payload_mass must be at least"),
    ({"planner.shape": 3}, "planner.shape must be at least 1 and at most 2, got 3"),
]


@pytest.mark.parametrize(("values", "words"), REFUSED)
def test_what_cannot_be_planned_is_told_and_can_be_corrected(native_fmus, values, words) -> None:
    with Importer(native_fmus[2][0]) as fmu:
        fmu.set(values)
        fmu.begin()
        with pytest.raises(Exception, match="fmi2ExitInitializationMode"):
            fmu.fmu.exitInitializationMode()
        assert words in fmu.messages[-1]
        with pytest.raises(Exception, match="fmi2DoStep"):
            fmu.step(0.0, 0.01)
        assert "not allowed after an error" in fmu.messages[-1]
        fmu.fmu.reset()
        fmu.initialise()
        fmu.step(0.0, 4.0)
        assert fmu.get("reference.load.position.x")[0] == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"rope.length": 0.0}, "the start value of rope.length must be above 0 m"),
        ({"drive.mode": "velocity"}, "feedback.table are for the other drive.mode"),
        ({"sensor.dead_time": 0.1}, "set sensor.sample_time above 0 s"),
        ({"travel.bridge.min": 2e9}, "travel.bridge: min 2000000000 m must be below max"),
        ({"crane.rope_min": 2.0}, "rope_min 2 m must be less than rope_max 1.5 m"),
        ({"feedback.table[3].length": 0.01}, "feedback.table[3].length"),
    ],
)
def test_a_crane_that_cannot_be_is_told(native_fmus, values, words) -> None:
    with Importer(native_fmus[2][1]) as fmu:
        fmu.set(values)
        fmu.begin()
        with pytest.raises(Exception, match="fmi2ExitInitializationMode"):
            fmu.fmu.exitInitializationMode()
        assert words in fmu.messages[-1]


def test_a_crane_that_leaves_its_range_tells_where(native_fmus) -> None:
    with Importer(native_fmus[2][1]) as fmu:
        fmu.set({"feedback.enabled": 0, "force.hoist": -9.81, "force.bridge": 2.0,
                 "travel.bridge.max": 0.05})
        fmu.initialise()
        with pytest.raises(Exception, match="fmi2DoStep"):
            for i in range(100):
                fmu.step(0.01 * i, 0.01)
        assert "bridge at 0.05 m is at its end stop, greatest position 0.05 m" in fmu.messages[-1]


def test_gains_are_tunable_between_steps(native_fmus) -> None:
    with Importer(native_fmus[2][1]) as fmu:
        fmu.set({"sway.x.angle": 0.1, "force.hoist": -9.81, "reference.rope.length": 0.5,
                 "feedback.fade": 0.0})
        fmu.initialise()
        fmu.step(0.0, 0.005)
        before = fmu.get("drive.bridge.force")[0]
        fmu.set({f"feedback.table[{i}].bridge.{n}": 0.0
                 for i in range(1, 18) for n in ("position", "angle", "velocity", "rate")})
        fmu.step(0.005, 0.02)
        assert before != 0.0 and fmu.get("drive.bridge.force")[0] == 0.0


# value reference of a parameter
MASS = gantry_feedforward.native_spec().references["crane.bridge_mass"]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda f: f.setReal([1], [1.0]), "force.bridge cannot be set at all"),
        (lambda f: f.setReal([9999], [1.0]), "no variable with value reference 9999"),
        (lambda f: f.setReal([0], [1.0]), "no variable with value reference 0"),
        (lambda f: f.setInteger([1], [1]), "force.bridge is of type Real"),
        (lambda f: f.getReal([1]), "not allowed before initialisation"),
        (lambda f: f.doStep(0.0, 0.1), "not allowed before initialisation"),
        (lambda f: f.exitInitializationMode(), "not allowed before initialisation"),
        (lambda f: f.setReal([MASS], [float("nan")]), "must be finite, got nan"),
        (lambda f: f.setupExperiment(startTime=1e300), "the start time must be within"),
    ],
)
def test_calls_out_of_order_are_refused_with_a_reason(native_fmus, call, words) -> None:
    with Importer(native_fmus[2][0]) as fmu:
        with pytest.raises(Exception, match="fmi2"):
            call(fmu.fmu)
        assert words in fmu.messages[-1]
        fmu.initialise()


@pytest.mark.parametrize("index", [0, 1])
@pytest.mark.parametrize("name", ["Float64", "Int32", "Boolean", "UInt64"])
@pytest.mark.parametrize("access", ["Get", "Set"])
def test_values_without_a_place_are_refused(
    native_fmus, index: int, name: str, access: str
) -> None:
    with Importer(native_fmus[3][index]) as fmu:
        call = fmu.fmu.dll[f"fmi3{access}{name}"]
        call.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p,
                         ctypes.c_size_t]
        assert call(fmu.fmu.component, None, 0, None, 0) == 0
        assert call(fmu.fmu.component, None, 0, None, 3) == 3
        assert "the variables have 0 values, got 3" in fmu.messages[-1]


@pytest.mark.parametrize("fmi", [2, 3])
def test_steps_are_checked(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.initialise(stop=1.0)
        for time, step, words in (
            (0.5, 0.1, "the time is 0 s"), (0.0, 0.0, "must be above 0 s"),
            (0.0, float("nan"), "the end of the step must be within"),
            (0.0, 2.0, "pass the stop time"),
        ):
            with pytest.raises(Exception, match="DoStep"):
                fmu.step(time, step)
            assert words in fmu.messages[-1]
        fmu.step(0.0, 1.0)


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("which", [0, 1])
def test_a_step_late_in_a_simulation_is_not_done_twice(native_fmus, fmi: int, which: int) -> None:
    """A time that is within 1e-9 of another one was the same: at 1e6 s so was one 1 ms before."""
    start, step = 1e6, 1e-3
    with Importer(native_fmus[fmi][which]) as fmu:
        fmu.initialise(start)
        # what an importer adds up, and what it multiplies, differ by rounding
        time = start
        for i in range(1000):
            fmu.step(time if i % 2 else start + step * i, step)
            time += step
        with pytest.raises(Exception, match="DoStep"):
            fmu.step(time - step, step)
        assert "a step from 1000000.999" in fmu.messages[-1]


def test_outputs_are_there_in_initialisation_mode(native_fmus) -> None:
    for fmi in (2, 3):
        with Importer(native_fmus[fmi][0]) as fmu:
            fmu.begin()
            assert fmu.get("reference.rope.length")[0] == pytest.approx(0.5)
            fmu.set({"crane.payload_mass": 2.0})
            assert fmu.get("force.hoist")[0] == pytest.approx(-19.62)
            assert fmu.get("plan.duration")[0] == pytest.approx(3.967, abs=1e-3)


@each
def test_to_free_no_state_is_allowed(native_fmus, fmi: int, index: int) -> None:
    """Both standards: a null pointer is ignored."""
    with Importer(native_fmus[fmi][index]) as fmu:
        free = fmu.fmu.dll.fmi3FreeFMUState if fmu.three else fmu.fmu.dll.fmi2FreeFMUstate
        nothing = ctypes.c_void_p()
        assert free(ctypes.c_void_p(fmu.fmu.component), ctypes.byref(nothing)) == 0
        assert free(ctypes.c_void_p(fmu.fmu.component), None) == 0
        assert fmu.messages == []
