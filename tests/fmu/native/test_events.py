"""FMI 3.0: early return, event mode and intermediate updates at the events of the plan."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import plan
from tests.fmu.native.importer import Importer
from tests.fmu.python.test_slaves import LIMITS, POINTS


def piece_bounds(trajectory) -> np.ndarray:
    """Times at which a piece of any axis begins or ends, from the pieces themselves."""
    found = [np.append(trajectory.pieces(a)[0], trajectory.axis_durations[a]) for a in range(3)]
    times = np.unique(np.concatenate(found))
    return times[np.append(True, np.diff(times) > 1e-9)]


@pytest.mark.parametrize("event_mode", [False, True])
def test_early_return_at_every_event_of_the_plan_in_fmi3(native_fmus, event_mode: bool) -> None:
    expected = piece_bounds(plan(POINTS, LIMITS))
    options = {"eventModeUsed": event_mode, "earlyReturnAllowed": True}
    with Importer(native_fmus[3][0], **options) as fmu:
        fmu.begin()
        fmu.fmu.exitInitializationMode()
        if event_mode:
            fmu.fmu.updateDiscreteStates()
            fmu.fmu.enterStepMode()
        time, times, intervals = 0.0, [0.0], set()
        while time < 4.5:
            assert fmu.get("plan.next_event")[0] == pytest.approx(
                expected[min(len(times), expected.size - 1)], abs=1e-12
            )
            event, _, early, reached = fmu.fmu.doStep(time, 4.5 - time)
            assert early == (reached < 4.5) and event == (early and event_mode)
            time = reached
            if event:
                fmu.fmu.enterEventMode()
                fmu.fmu.updateDiscreteStates()
                fmu.fmu.enterStepMode()
            if early:
                times.append(time)
            intervals |= set(fmu.fmu.getInt32([fmu.variables["plan.interval"].valueReference]))
        assert times == pytest.approx(expected, abs=1e-12)
        assert intervals == {1, 2} and times[-1] == fmu.get("plan.duration")[0]


def test_events_within_a_step_are_met_where_it_may_not_return_early(native_fmus) -> None:
    with Importer(native_fmus[3][0], eventModeUsed=True) as fmu:
        fmu.begin()
        fmu.fmu.exitInitializationMode()
        fmu.fmu.enterStepMode()
        assert fmu.fmu.doStep(0.0, 4.5) == (False, False, False, 4.5)
        assert fmu.fmu.getBoolean([fmu.variables["plan.done"].valueReference]) == [True]


def test_intermediate_updates_of_fmi3_tell_every_event_and_may_end_the_step(native_fmus) -> None:
    expected = piece_bounds(plan(POINTS, LIMITS))
    told = []

    def hear(_environment, time, may_set, may_get, finished, may_return, early, asked) -> None:
        told.append((time, may_set, may_get, finished, may_return))
        early[0] = time > 1.0
        asked[0] = time + 1e-3

    options = {"intermediateUpdate": hear, "earlyReturnAllowed": False}
    with Importer(native_fmus[3][0], **options) as fmu:
        fmu.initialise()
        assert fmu.fmu.doStep(0.0, 4.5)[2:] == (False, 4.5)
    times = np.array([t for t, *_ in told])
    assert times == pytest.approx(np.append(expected[1:], 4.5), abs=1e-12)
    assert {tuple(flags) for _, *flags in told} == {(False, True, True, False)}
