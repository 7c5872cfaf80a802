"""What a crane file means to planner and FMUs: the plant by which it is judged."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest

from segfmu.crane import Rig
from segfmu.crane.rig import plant_record
from segfmu.fmu.standard.spec import start_values
from segfmu.kernels.crane.records import Plant
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.reading import checked
from tests.validation.files.test_crane_file import EVERYTHING

MODELS = Path(__file__).parents[3] / "models"
FILES = {
    "everything": EVERYTHING,
    **{p.stem: p.read_text(encoding="utf-8") for p in sorted(MODELS.glob("crane*.toml"))},
}


@pytest.mark.parametrize("name", FILES)
def test_a_plant_of_variables_is_that_of_the_rig_they_describe(name: str) -> None:
    # files are judged by the one, the crane in Python is the other
    own = checked(CraneFile, tomllib.loads(FILES[name]), name)
    crane = crane_parameters.nominal(own)
    plant = crane_parameters.models(own).plant()
    value = start_values(plant, crane_parameters.parameters(own)).__getitem__
    direct = plant_record(crane, value)
    by_rig = Rig.of(value).parameters(crane, own.drive == "velocity")
    # but for the time of a gust that does not blow
    calm = direct[Plant.GUST_DURATION] == 0.0
    assert set(np.flatnonzero(direct != by_rig)) <= ({Plant.GUST_START} if calm else set())
