"""FMI 2.0 model exchange in the order in which OpenModelica's import calls it.

Its wrappers leave initialisation mode with the values of the description, set parameters after it,
set states before the first event is over, and read the time of the next event in any case.
"""

from __future__ import annotations

import ctypes

import numpy as np
import pytest

from tests.fmu.native.importer import Importer

CRANE = {"crane.payload_mass": 1.7, "drive.bridge.force_max": 0.8, "feedback.bandwidth": 1.3,
         "feedback.design": "flatness", "payload.count": 1, "payload[1].time": 0.2}


def set_states(fmu: Importer, states: np.ndarray) -> None:
    fmu.fmu.setContinuousStates((ctypes.c_double * fmu.states)(*states), fmu.states)


def leave_initialisation(fmu: Importer) -> None:
    fmu.begin()
    fmu.fmu.exitInitializationMode()


def walk(fmu: Importer) -> list[np.ndarray]:
    """Derivatives from event to event, at a state that moves."""
    found, time = [], 0.0
    state = fmu.state()
    for _ in range(30):
        found.append(fmu.derivatives(time, state))
        state = state + 1e-3 * found[-1]
        fmu.fmu.enterEventMode()
        time = fmu.event()
        fmu.fmu.setTime(time)
    return [*found, np.array([time])]


def test_parameters_set_after_initialisation_give_the_same_crane(native_fmus) -> None:
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        fmu.set(CRANE)
        fmu.initialise()
        expected = walk(fmu)
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        fmu.set(CRANE)
        set_states(fmu, fmu.state())
        assert fmu.get("payload.mass")[0] == 1.7
        fmu.event()
        assert np.array_equal(np.concatenate(walk(fmu)), np.concatenate(expected))


def test_parameters_set_after_initialisation_give_the_same_plan(native_fmus) -> None:
    changes = {"limits.x.velocity": 0.3, "waypoint[3].position.x": 1.5, "planner.smoothness": 5}
    with Importer(native_fmus[2][0], "ModelExchange") as fmu:
        fmu.set(changes)
        fmu.initialise()
        expected = fmu.get("plan.duration", "plan.next_event", "reference.load.snap.x")
    with Importer(native_fmus[2][0], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        usual = fmu.get("plan.duration")[0]
        fmu.set(changes)
        found = fmu.get("plan.duration", "plan.next_event", "reference.load.snap.x")
        assert found.tolist() == expected.tolist() and found[0] != usual
        assert fmu.event() == expected[1]


def test_a_reference_set_after_initialisation_moves_the_states(native_fmus) -> None:
    held = np.array([0.0, 0.0, 0.5])
    moved = {"reference.bridge.position": 0.3, "reference.trolley.position": -0.2,
             "reference.rope.length": 0.7}
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        old = fmu.state()
        fmu.set(moved)
        set_states(fmu, old)
        fmu.fmu.enterEventMode()
        fmu.set(moved)
        assert fmu.states_moved()
        assert np.array_equal(old[:3], held)
        assert fmu.state()[:3].tolist() == [0.3, -0.2, 0.7]
        fmu.set({n: v + 0.1 for n, v in moved.items()})
        assert not fmu.states_moved()


def test_states_that_are_right_are_not_moved(native_fmus) -> None:
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        fmu.set({"reference.rope.length": 0.5})
        set_states(fmu, fmu.state())
        assert not fmu.states_moved()


def test_the_first_event_ends_it(native_fmus) -> None:
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        fmu.initialise()
        fmu.fmu.enterEventMode()
        with pytest.raises(Exception, match="fmi2SetReal"):
            fmu.set({"crane.payload_mass": 1.7})
        assert fmu.messages[-1] == "fmi2SetReal: crane.payload_mass cannot be set now"
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        fmu.fmu.enterContinuousTimeMode()
        fmu.fmu.enterEventMode()
        with pytest.raises(Exception, match="fmi2SetReal"):
            fmu.set({"crane.payload_mass": 1.7})


def test_what_else_stays_refused(native_fmus) -> None:
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        with pytest.raises(Exception, match="fmi2SetReal"):
            fmu.set({"rope.length": 0.7})
    with Importer(native_fmus[2][1]) as fmu:
        leave_initialisation(fmu)
        with pytest.raises(Exception, match="fmi2SetReal"):
            fmu.set({"crane.payload_mass": 1.7})
    with Importer(native_fmus[3][1], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        with pytest.raises(Exception, match="fmi3SetFloat64"):
            fmu.set({"crane.payload_mass": 1.7})
        with pytest.raises(Exception, match="fmi3SetContinuousStates"):
            set_states(fmu, np.zeros(fmu.states))


def test_parameters_of_no_use_are_refused_with_their_reason(native_fmus) -> None:
    with Importer(native_fmus[2][0], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        fmu.set({"limits.x.velocity": -1.0})
        with pytest.raises(Exception, match="fmi2GetReal"):
            fmu.get("force.bridge")
        fmu.set({"limits.x.velocity": 0.5})
        assert np.isfinite(fmu.get("force.bridge"))
        fmu.set({"limits.x.velocity": -1.0})
        with pytest.raises(Exception, match="fmi2NewDiscreteStates"):
            fmu.event()
        assert "limits.x.velocity must be at least 0" in fmu.messages[-1]
        with pytest.raises(Exception, match="fmi2NewDiscreteStates"):
            fmu.event()
        assert "not allowed after an error" in fmu.messages[-1]


def test_reset_forgets_parameters_set_after_initialisation(native_fmus) -> None:
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        fmu.set({"crane.payload_mass": 1.7})
        fmu.fmu.reset()
        fmu.initialise()
        assert fmu.get("payload.mass")[0] == 1.0


def test_states_saved_between_keep_parameters(native_fmus) -> None:
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        fmu.set({"crane.payload_mass": 1.7})
        kept = fmu.fmu.getFMUState()
        fmu.event()
        fmu.fmu.setFMUState(kept)
        fmu.set({"crane.payload_mass": 1.2})
        fmu.event()
        assert fmu.get("payload.mass")[0] == 1.2
        fmu.fmu.freeFMUState(kept)


def test_an_undefined_event_is_far_away(native_fmus) -> None:
    with Importer(native_fmus[2][0], "ModelExchange") as fmu:
        leave_initialisation(fmu)
        fmu.event()
        fmu.fmu.setTime(100.0)
        fmu.fmu.enterEventMode()
        *_, defined, time = fmu.fmu.newDiscreteStates()
        assert not defined and time > 1e9


def test_time_is_no_variable_of_fmi2_and_the_last_of_fmi3(native_fmus) -> None:
    for fmu in (0, 1):
        with Importer(native_fmus[2][fmu]) as two, Importer(native_fmus[3][fmu]) as three:
            assert "time" not in two.variables
            assert list(three.variables)[-1] == "time"
            count = len(two.variables)
            assert [v.valueReference for v in two.variables.values()] == list(range(1, count + 1))
            with pytest.raises(Exception, match="fmi2GetReal"):
                two.fmu.getReal([count + 1])
