"""The constants of C and the reference page are those of the records."""

from __future__ import annotations

from segfmu.codegen import records
from segfmu.kernels.crane.records import Masses, Plant, PlantState, State
from segfmu.kernels.rig.records import Memory, Setpoints, Tick


def test_generated_header_and_page_are_up_to_date() -> None:
    for target, text in records.generate().items():
        assert target.read_text(encoding="utf-8") == text, target


def test_a_derived_record_begins_with_the_fields_of_its_base() -> None:
    for base, derived in ((Masses, Plant), (State, PlantState), (Tick, Memory)):
        assert [getattr(derived, n) for n in base.FIELDS] == [
            getattr(base, n) for n in base.FIELDS
        ]
        assert list(derived.FIELDS)[: len(base.FIELDS)] == list(base.FIELDS)
    assert State.SIZE == PlantState.DEFLECTION == 10


def test_fields_lie_side_by_side_and_rows_have_room() -> None:
    assert (Plant.LAG, Plant.FORCE_MAX, Setpoints.WIND) == (18, 25, 16)
    assert max(Plant.SIZE, Setpoints.SIZE) <= Memory.COLUMNS


def test_names_in_c_carry_the_record() -> None:
    text = records.generate()[records.HEADER]
    for line in ("PLANT_LAG = 18,", f"PLANT_SIZE = {Plant.SIZE}\n", "PLANT_STATE_WIND_WORK = 14,"):
        assert f"    {line}" in text
