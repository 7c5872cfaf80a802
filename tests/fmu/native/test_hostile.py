"""What a careless or hostile importer does: it gets an error, and never a crash or a false OK."""

from __future__ import annotations

import ctypes
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pytest
from fmpy.fmi2 import fmi2CallbackFunctions, fmi2CallbackLoggerTYPE

from tests.fmu.native.importer import Importer
from tests.fmu.native.test_state import CRANE, each, start

ROOT = Path(__file__).parents[3]
# what the bindings raise for a status
STATUS = r"(?i)status|error"
both = pytest.mark.parametrize("fmi", [2, 3])


def instantiated(fmu: Importer, kind: int, token: bytes) -> list[str]:
    """Messages of an instance of FMI 2.0 that is asked for with a type and a token."""
    told: list[str] = []
    callbacks = fmi2CallbackFunctions()
    log = fmi2CallbackLoggerTYPE(lambda _, n, s, c, m: told.append(m.decode()))
    callbacks.logger = log
    function = fmu.fmu.dll.fmi2Instantiate
    function.restype = ctypes.c_void_p
    place = (fmu.folder / "resources").as_uri().encode()
    assert not function(b"one", kind, token, place, ctypes.byref(callbacks), 0, 0)
    return told


def test_percent_signs_of_a_token_reach_the_logger_as_text(native_fmus) -> None:
    with Importer(native_fmus[2][0]) as fmu:
        told = instantiated(fmu, 1, b"%s%n%s%s%s%s")
    assert "%%s%%n%%s" in told[0] and "%s%n" not in told[0].replace("%%", "")


def test_an_interface_that_does_not_exist_is_refused(native_fmus) -> None:
    with Importer(native_fmus[2][0]) as fmu:
        told = instantiated(fmu, 7, fmu.description.guid.encode())
    assert "neither" in told[0]


@both
@pytest.mark.parametrize(
    ("name", "value"),
    [("feedback.bandwidth", -5.0), ("feedback.rejection.load", 1e300), ("feedback.fade", -1.0)],
)
def test_what_is_tuned_stays_in_its_range(native_fmus, fmi: int, name: str, value: float) -> None:
    with Importer(native_fmus[fmi][1]) as fmu:
        fmu.set({"force.hoist": -9.81, "reference.rope.length": 0.5})
        fmu.initialise()
        fmu.step(0.0, 0.01)
        before = fmu.get(name)
        with pytest.raises(Exception, match=STATUS):
            fmu.set({name: value})
        assert f"{name} must be at least" in fmu.messages[-1]
        assert fmu.get(name) == before
        fmu.step(0.01, 0.01)


@both
@pytest.mark.parametrize(
    ("index", "name"),
    [(0, "limits.z.velocity_min"), (1, "drive.hoist.velocity_min"), (1, "drive.bridge.force_min")],
)
def test_a_least_bound_is_not_above_zero(native_fmus, fmi: int, index: int, name: str) -> None:
    with Importer(native_fmus[fmi][index]) as fmu:
        with pytest.raises(Exception, match=STATUS):
            fmu.set({name: 0.5})
            fmu.initialise()
        assert f"{name} must be at most 0, got 0.5" in fmu.messages[-1]


@both
def test_a_step_below_the_resolution_of_time_is_refused(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1]) as fmu:
        fmu.set({"force.hoist": -9.81})
        fmu.initialise()
        fmu.step(0.0, 1e-3)
        with pytest.raises(Exception, match=STATUS):
            fmu.step(1e-3, 1e-20)
        assert "resolution" in fmu.messages[-1]


@both
def test_a_stop_before_the_start_is_refused(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][0]) as fmu:
        with pytest.raises(Exception, match=STATUS):
            fmu.begin(1.0, 0.5)
        assert "the stop time 0.5 s is before the start time 1 s" in fmu.messages[-1]
        fmu.begin(1.0, 1.0)


@both
@pytest.mark.parametrize("index", [0, 1])
def test_outputs_that_overflow_are_an_error(native_fmus, fmi: int, index: int) -> None:
    with Importer(native_fmus[fmi][index]) as fmu:
        fmu.set({"crane.payload_mass": 1e308})
        with pytest.raises(Exception, match=STATUS):
            fmu.initialise()
            fmu.step(0.0, 1e-3)
        assert fmu.messages


def test_within_the_callback_of_fmi3_values_can_be_read_and_nothing_else(native_fmus) -> None:
    refused, read = [], []

    def update(*_: object) -> None:
        position = fmu.variables["reference.load.position.x"].valueReference
        read.extend(fmu.fmu.getFloat64([position]))
        for name in ("terminate", "reset", "getFMUState"):
            with pytest.raises(Exception, match=STATUS):
                getattr(fmu.fmu, name)()
            refused.append(name)
        with pytest.raises(Exception, match=STATUS):
            fmu.fmu.doStep(0.0, 0.1)
        with pytest.raises(Exception, match=STATUS):
            fmu.set({"crane.payload_mass": 2.0})
        # returns nothing: it must leave the instance to the step under way
        fmu.fmu.dll.fmi3FreeInstance(ctypes.c_void_p(fmu.fmu.component))

    with Importer(native_fmus[3][0], intermediateUpdate=update) as fmu:
        fmu.initialise()
        assert fmu.fmu.doStep(0.0, 0.1)[-1] == 0.1
    assert len(refused) >= 3 and np.isfinite(read).all()


@each
def test_an_instance_takes_what_its_parameters_need(native_fmus, fmi: int, index: int) -> None:
    def resident() -> int:
        # without pages of files, such as the code of the libraries
        pages = [int(n) for n in Path("/proc/self/statm").read_text().split()]
        return (pages[1] - pages[2]) * 4096

    if not Path("/proc/self/statm").exists():
        pytest.skip("memory in use is read from Linux' /proc")
    with ExitStack() as stack:
        instances = [stack.enter_context(Importer(native_fmus[fmi][index])) for _ in range(20)]
        before = resident()
        for fmu in instances:
            start(fmu, index)
            fmu.step(0.0, 1e-3)
        # feedforward: without what only planning needed
        assert (resident() - before) / len(instances) < (80e3, 250e3)[index]


@each
def test_no_damaged_state_brings_the_importer_down(native_fmus, fmi: int, index: int) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "tests.fmu.native.damaged", str(native_fmus[fmi][index]),
         str(index), "60", str(fmi)],
        cwd=ROOT, capture_output=True, text=True, check=False, timeout=120,
    )
    assert done.returncode == 0, done.stderr
    refused, gone_on = map(int, done.stdout.split()[-2:])
    assert refused > 0 and refused + gone_on == 60


def test_a_late_sensor_still_has_room(native_fmus) -> None:
    with Importer(native_fmus[2][1]) as fmu:
        fmu.set(CRANE | {"sensor.sample_time": 1e-4, "sensor.dead_time": 1.0})
        fmu.initialise()
        for i in range(30):
            fmu.step(i * 0.05, 0.05)
        assert np.isfinite(fmu.get("measured.sway.x.angle"))


@pytest.mark.parametrize("names", [
    ("limits.x.velocity",), ("waypoint.position",), ("limits.x.jerk", "waypoint.dwell"),
])
@pytest.mark.parametrize("wrong", [-1, 1, 1000])
def test_arrays_of_another_size_than_their_variables_are_refused(native_fmus, names, wrong) -> None:
    """FMI 3.0 tells both counts; nothing is read or written where they differ."""
    with Importer(native_fmus[3][0]) as fmu:
        variables = [fmu.variables[n] for n in names]
        size = sum(int(np.prod([d.start for d in v.dimensions], dtype=int)) for v in variables)
        references = (ctypes.c_uint32 * len(names))(*(v.valueReference for v in variables))
        before = fmu.fmu.getFloat64([v.valueReference for v in variables], nValues=size)
        for function in (fmu.fmu.dll.fmi3GetFloat64, fmu.fmu.dll.fmi3SetFloat64):
            values = (ctypes.c_double * (size + 1001))(*[-7.5] * (size + 1001))
            status = function(
                ctypes.c_void_p(fmu.fmu.component), references, ctypes.c_size_t(len(names)),
                values, ctypes.c_size_t(size + wrong),
            )
            assert status == 3
            assert f"have {size} values, got {size + wrong}" in fmu.messages[-1]
            assert set(values) == {-7.5}
        after = fmu.fmu.getFloat64([v.valueReference for v in variables], nValues=size)
        assert list(after) == list(before)


@both
@pytest.mark.parametrize("value", [1e-20, 1e9])
def test_a_sample_time_that_cannot_be_counted_is_refused_at_once(
    native_fmus, fmi: int, value: float
) -> None:
    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.set({"planner.sample_time": value})
        with pytest.raises(Exception, match=STATUS):
            fmu.initialise()
        assert "sample_time must be from" in fmu.messages[-1]


@both
def test_log_categories_choose_what_is_told(native_fmus, fmi: int) -> None:
    def choose(*names: bytes) -> int:
        function = getattr(fmu.fmu.dll, f"fmi{fmi}SetDebugLogging")
        given = (ctypes.c_char_p * max(len(names), 1))(*names)
        return function(ctypes.c_void_p(fmu.fmu.component), 1, ctypes.c_size_t(len(names)), given)

    def refused() -> int:
        before = len(fmu.messages)
        with pytest.raises(Exception, match=STATUS):
            fmu.step(0.0, -1.0)
        return len(fmu.messages) - before

    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.initialise()
        assert refused() == 1
        assert choose(b"logStatusWarning") == 0 and refused() == 0
        assert choose(b"logStatusWarning", b"logStatusError") == 0 and refused() == 1
        assert choose() == 0 and refused() == 1
        assert choose(b"logNonsense") != 0 and "no log category" in fmu.messages[-1]


@both
def test_a_state_that_a_solver_only_tries_is_discarded(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1], "ModelExchange") as fmu:
        fmu.set({"force.hoist": -9.81})
        fmu.initialise()
        good = fmu.state()
        found = (ctypes.c_double * fmu.states)()
        name = "fmi3GetContinuousStateDerivatives" if fmu.three else "fmi2GetDerivatives"
        derivatives = getattr(fmu.fmu.dll, name)
        wild = good.copy()
        wild[2] = 1e-200
        wild[8:] = 1e200
        for state, status in ((good, 0), (wild, 2), (good, 0)):
            values = (ctypes.c_double * fmu.states)(*state)
            fmu.fmu.setContinuousStates(values, fmu.states)
            assert derivatives(
                ctypes.c_void_p(fmu.fmu.component), found, ctypes.c_size_t(fmu.states)
            ) == status


@both
def test_a_value_just_beyond_its_bound_is_told_with_its_digits(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1]) as fmu:
        with pytest.raises(Exception, match=STATUS):
            fmu.set({"feedback.rejection.load": 1.0 + 1e-9})
            fmu.initialise()
        assert "at most 1, got 1.000000001" in fmu.messages[-1]


@both
def test_a_time_just_beyond_the_last_is_told_with_its_digits(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1]) as fmu:
        fmu.set({"force.hoist": -9.81, "reference.rope.length": 0.5})
        with pytest.raises(Exception, match=STATUS):
            fmu.initialise(1e9 + 1e-3)
        assert "within 1e+09 s of 0, got 1000000000.001 s" in fmu.messages[-1]
