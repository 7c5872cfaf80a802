"""States of model exchange that are set and read by their names, as both standards allow."""

from __future__ import annotations

import ctypes

import numpy as np
import pytest

from segfmu.fmu.gantry_crane import interface as gantry_crane
from tests.fmu.native.importer import Importer

each = pytest.mark.parametrize("fmi", [2, 3])
STATES = gantry_crane.STATES
SET = {2: "fmi2SetReal", 3: "fmi3SetFloat64"}
# none is that of another one, and the rope is not slack
VALUES = 0.5 + 0.01 * np.arange(len(STATES))


def crane(native_fmus, fmi: int, kind: str = "ModelExchange") -> Importer:
    return Importer(native_fmus[fmi][1], kind)


@each
def test_the_description_has_them_in_the_order_of_the_vector(native_fmus, fmi: int) -> None:
    with crane(native_fmus, fmi) as fmu:
        fmu.initialise()
        described = [d.variable for d in fmu.description.derivatives]
        rates = fmu.derivatives(0.0, VALUES)
        assert fmu.get(*(d.derivative.name for d in described)).tolist() == VALUES.tolist()
        assert fmu.get(*(d.name for d in described)).tolist() == rates.tolist()
        assert len(set(np.round(rates, 6))) >= 12


@each
def test_each_alone_is_as_all_at_once(native_fmus, fmi: int) -> None:
    with crane(native_fmus, fmi) as fmu:
        fmu.initialise()
        expected = fmu.derivatives(0.0, VALUES)
        before = fmu.state()
        for place, name in enumerate(STATES):
            fmu.derivatives(0.0, before)
            fmu.set({name: 0.3})
            wanted = before.copy()
            wanted[place] = 0.3
            assert fmu.state().tolist() == wanted.tolist(), name
            assert fmu.get(name)[0] == 0.3
        # with an input among them, in another order
        names = (*STATES[::-1], "wind.x")
        fmu.write(names, np.array([*VALUES[::-1], 0.7]))
        assert fmu.state().tolist() == VALUES.tolist() and fmu.get("wind.x")[0] == 0.7
        fmu.set({"wind.x": 0.0})
        found = (ctypes.c_double * fmu.states)()
        read = (
            fmu.fmu.getContinuousStateDerivatives if fmu.three else fmu.fmu.getDerivatives
        )
        read(found, fmu.states)
        assert list(found) == expected.tolist()


def refused(fmu: Importer, fmi: int, name: str, value: float, message: str) -> None:
    before = fmu.get(name)[0]
    with pytest.raises(Exception, match=SET[fmi]):
        fmu.set({name: value})
    assert message in fmu.messages[-1]
    assert fmu.get(name)[0] == before


@each
def test_what_is_no_number_and_no_state_is_refused(native_fmus, fmi: int) -> None:
    with crane(native_fmus, fmi) as fmu:
        fmu.initialise()
        refused(fmu, fmi, "bridge.position", np.nan, "must be finite")
        for name in ("load.position.x", "der(bridge.position)", "bridge.acceleration"):
            refused(fmu, fmi, name, 0.1, f"{name} cannot be set at all")
        with pytest.raises(Exception, match=SET[fmi]):
            fmu.write(("bridge.position", "load.position.x"), np.array([0.4, 0.4]))
        assert fmu.get("bridge.position")[0] == 0.0


def test_at_events_only_fmi3_allows_it(native_fmus) -> None:
    for fmi in (2, 3):
        with crane(native_fmus, fmi) as fmu:
            fmu.initialise()
            fmu.fmu.enterEventMode()
            if fmi == 2:
                refused(fmu, fmi, "sway.x.angle", 0.2, "sway.x.angle cannot be set now")
                refused(fmu, fmi, "energy.wind", 0.2, "energy.wind cannot be set now")
            else:
                fmu.set({"sway.x.angle": 0.2, "energy.wind": 3.0})
                fmu.event()
                assert fmu.get("sway.x.angle", "energy.wind").tolist() == [0.2, 3.0]


@each
def test_in_co_simulation_they_are_start_values(native_fmus, fmi: int) -> None:
    with crane(native_fmus, fmi, "CoSimulation") as fmu:
        refused_early = "energy.wind cannot be set at all"
        with pytest.raises(Exception, match=SET[fmi]):
            fmu.set({"energy.wind": 1.0})
        assert refused_early in fmu.messages[-1]
        fmu.set({"sway.x.angle": 0.2})
        fmu.initialise()
        assert fmu.get("sway.x.angle")[0] == pytest.approx(0.2)
        refused(fmu, fmi, "sway.x.angle", 0.3, "sway.x.angle cannot be set now")


@each
def test_derivatives_have_the_values_of_the_outputs(native_fmus, fmi: int) -> None:
    with crane(native_fmus, fmi) as fmu:
        fmu.initialise()
        fmu.derivatives(0.0, VALUES)
        for state, rate in gantry_crane.SHOWN.items():
            name = f"der({state})"
            assert fmu.get(name)[0] == fmu.get(rate)[0]
            assert fmu.variables[name].causality == "local"
            assert fmu.variables[name].derivative.name == state
            assert fmu.variables[rate].derivative is None or rate in STATES
            references = [fmu.variables[n].valueReference for n in (name, rate)]
            known = [fmu.variables["sway.x.rate"].valueReference]
            found = fmu.fmu.getDirectionalDerivative(references, known, [1.0])
            assert found[0] == found[1]
