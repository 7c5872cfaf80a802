"""A continuous output whose derivatives nobody wrote: asking for them is refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from fmpy.fmi1 import FMICallException

from segfmu.fmu import models
from segfmu.fmu.gantry_crane.interface import native_spec, spec
from segfmu.fmu.gantry_crane.model import GANTRY_CRANE
from segfmu.fmu.native.archive import build_all
from segfmu.fmu.standard.spec import Spec, output
from tests.campaign import soaked
from tests.fmu.native.importer import Importer

MODEL, NAME = "FurtherCrane", "load.slant"


def further(own: Spec | None = None) -> Spec:
    """The interface of GantryCrane with one more continuous output."""
    known = native_spec(own or spec())
    *others, time = known.variables
    speed = output(NAME, "m/s", "speed of the load")
    return replace(known, name=MODEL, variables=(*others, speed, time))


@pytest.fixture(scope="module", params=[3, *soaked(2)])
def built(request, tmp_path_factory) -> Path:
    with pytest.MonkeyPatch.context() as patch:
        model = replace(GANTRY_CRANE, name=MODEL, native_spec=further, largest=further)
        patch.setitem(models._registered, MODEL, model)
        folder = tmp_path_factory.mktemp("further")
        return build_all([further()], folder, fmi=request.param)[0]


def refused(fmu: Importer, words: str) -> bool:
    return any(words in message for message in fmu.messages)


def test_its_partial_derivatives_are_refused(built: Path) -> None:
    with Importer(built, "ModelExchange") as fmu:
        fmu.initialise()
        known = fmu.variables["bridge.velocity"].valueReference
        with pytest.raises(FMICallException):
            fmu.fmu.getDirectionalDerivative([fmu.variables[NAME].valueReference], [known], [1.0])
        assert refused(fmu, f"there is no derivative of {NAME} by bridge.velocity now")


def test_others_have_theirs(built: Path) -> None:
    with Importer(built, "ModelExchange") as fmu:
        fmu.initialise()
        known = fmu.variables["bridge.velocity"].valueReference
        unknown = fmu.variables["load.velocity.x"].valueReference
        assert fmu.fmu.getDirectionalDerivative([unknown], [known], [1.0]) == [1.0]
