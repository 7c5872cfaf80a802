"""The drawing of the crane."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from segfmu.codegen import drawing
from segfmu.fmu.models import registered
from segfmu.fmu.standard.documentation import page


@pytest.mark.parametrize("target", drawing.TARGETS, ids=lambda t: t.parent.name)
def test_it_is_up_to_date(target) -> None:
    assert target.read_text(encoding="utf-8") == drawing.generate(), "run make generate"


def test_every_symbol_of_the_equations_is_in_it() -> None:
    texts = {
        "".join(t.itertext()) for t in ET.fromstring(drawing.generate()).iter()
        if t.tag.endswith("text")
    }
    assert texts >= {
        "x", "y", "z", "xt", "yt", "l", "φx", "φy", "mb", "mt", "mp", "Fx", "Fy", "Fl",
    }


@pytest.mark.parametrize("index", [0, 1, 2, 3])
def test_the_page_of_each_fmu_shows_it(index: int) -> None:
    model = registered()[index]
    assert "Coordinates, angles and forces" in page(model.spec(), "1.0", model.about)
