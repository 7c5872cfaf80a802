"""Inputs that are beyond all sense are refused with name, value and range."""

from __future__ import annotations

import math
import re

import pytest

from segfmu.errors import SegfmuError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.slave import CraneSlave
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.gantry_feedforward.slave import FeedforwardSlave
from tests.fmu.native.importer import Importer

INPUTS = [v.name for v in gantry_crane.spec().where("input")]
MEASURED = [v.name for v in gantry_feedforward.spec().variables if v.name.startswith("measured.")]
TOLD = "must be at least -1e+20 and at most 1e+20, got "


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_running_crane_refuses_an_input_of_no_sense(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1]) as fmu:
        fmu.initialise()
        fmu.step(0.0, 0.01)
        for name in INPUTS:
            before = fmu.get(name)[0]
            for value in (1e300, -1.1e20):
                with pytest.raises(Exception, match=r"fmi[23]Set"):
                    fmu.set({name: value})
                refused = f"input refused: {name} {TOLD}{value:.15g}"
                assert fmu.messages[-1] == refused
            assert fmu.get(name)[0] == before
        # the list of all inputs, which is known from the second time on
        values = dict.fromkeys(INPUTS, 0.0) | {"wind.z": 1e30}
        references = [fmu.variables[name].valueReference for name in INPUTS]
        write = fmu.fmu.setFloat64 if fmu.three else fmu.fmu.setReal
        for _ in range(2):
            write(references, [fmu.get(name)[0] for name in INPUTS])
            with pytest.raises(Exception, match=r"fmi[23]Set"):
                write(references, list(values.values()))
            assert fmu.messages[-1].endswith(f"wind.z {TOLD}1e+30")
        fmu.step(0.01, 0.01)


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize(("index", "names"), [(1, INPUTS), (0, MEASURED)])
def test_it_does_so_at_the_start(native_fmus, fmi: int, index: int, names: list[str]) -> None:
    for name in names:
        with Importer(native_fmus[fmi][index]) as fmu:
            fmu.set({name: 1e300})
            with pytest.raises(Exception, match=r"fmi[23]"):
                fmu.initialise()
            assert fmu.messages[-1] == f"initialisation failed: {name} {TOLD}1e+300"


def test_derivatives_that_lead_there_are_refused(native_fmus) -> None:
    with Importer(native_fmus[2][1]) as fmu:
        fmu.initialise()
        reference = [fmu.variables["wind.x"].valueReference]
        for order, end in ((1, 1e23), (2, 5e20), (3, 5e18 / 3.0)):
            fmu.fmu.setRealInputDerivatives(reference, [order], [1e25])
            if end > 1e20:
                with pytest.raises(Exception, match="fmi2DoStep"):
                    fmu.step(0.0, 0.01)
                told = f"derivatives refused, where the step ends: wind.x {TOLD}"
                assert fmu.messages[-1].startswith(told)
                assert float(fmu.messages[-1].split()[-1]) == pytest.approx(end)
            fmu.fmu.setRealInputDerivatives(reference, [order], [0.0])
        fmu.step(0.0, 0.01)


@pytest.mark.parametrize(("kind", "names"), [(CraneSlave, INPUTS), (FeedforwardSlave, MEASURED)])
def test_the_slave_in_python_refuses_them_too(
    kind: type[CraneSlave | FeedforwardSlave], names: list[str]
) -> None:
    for name in names:
        reference = kind.spec.references[name]
        slave = kind(instance_name="one")
        slave.set_real([reference], [1e300])
        with pytest.raises(SegfmuError, match=re.escape(f"{name} {TOLD}1e+300")):
            slave.exit_initialization_mode()
    slave = kind(instance_name="one")
    slave.exit_initialization_mode()
    what = "input refused" if kind is CraneSlave else "tuning refused"
    for value, told in ((1e300, f"{TOLD}1e+300"), (math.nan, "must be finite, got nan")):
        slave.set_real([reference], [value])
        assert not slave.do_step(0.0, 0.01)
        assert slave.get_real([reference])[0] == slave.spec.variable(name).start
        assert str(slave._refusal) == f"{what}: {name} {told}"


def test_ranges_are_in_the_descriptions(native_fmus) -> None:
    for fmi in (2, 3):
        with Importer(native_fmus[fmi][1]) as fmu:
            bounds = {(fmu.variables[n].min, fmu.variables[n].max) for n in INPUTS}
        assert {(float(a), float(b)) for a, b in bounds} == {(-1e20, 1e20)}
