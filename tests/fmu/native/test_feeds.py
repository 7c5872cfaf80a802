"""Tables of what variables feed records: rows by steps, and what cannot be fed."""

from __future__ import annotations

import re

import pytest

from segfmu.errors import BuildError
from segfmu.fmu.native import feeds
from segfmu.fmu.native.tables import layout
from segfmu.fmu.standard.spec import Spec, parameter
from segfmu.kernels.records import Record, field


class Row(Record):
    """A row of a table."""

    LENGTH = field("length", variables=("row[{}].length",))
    GAINS = field("gains; the second has no variable", size=2, variables=("row[{}].gain", ""))


def spec(names: list[str]) -> Spec:
    return Spec("Rows", "rows", tuple(parameter(n, 0.0, None, n) for n in names), 1.0, 0.1)


def test_rows_are_found_by_their_step() -> None:
    names = [f"row[{i}].{q}" for i in (1, 2, 3) for q in ("other", "gain", "length")]
    own = spec(names)
    rows = re.findall(r"\{(\d+), (\d+), (\d+), 0, false\}", feeds.source(own, [Row]))
    offsets = layout(own).offsets
    assert [tuple(map(int, r)) for r in rows] == [
        (0, offsets["row[1].length"], 3), (1, offsets["row[1].gain"], 3),
    ]


def test_uneven_rows_are_refused() -> None:
    names = ["row[1].length", "row[1].gain", "row[2].length", "row[2].gain", "x", "row[3].length"]
    with pytest.raises(BuildError, match=r"rows of row\[\{\}\]\.length .* evenly"):
        feeds.source(spec(names), [Row])


def test_a_variable_that_is_missing_is_named() -> None:
    with pytest.raises(BuildError, match=r"Rows has no variable row\[1\]\.gain"):
        feeds.source(spec(["row[1].length"]), [Row])
