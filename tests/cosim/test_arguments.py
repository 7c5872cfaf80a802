"""Arguments of a system and its runs, with values of every kind: one InputError, or a result."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.cosim import Change, System, profile, require_steps, write_csv
from segfmu.cosim.points import communication_points
from segfmu.errors import InputError, SegfmuError
from tests.test_nonsense import NONSENSE

MADE = ("fmus", "step", "steps", "connections", "coupling", "record", "repeatable", "engine")
RUN = ("values", "stop_time", "start_time", "changes")
INNER: dict[str, Any] = {
    "fmus": lambda v: [v], "steps": lambda v: {"a": v}, "connections": lambda v: [v],
    "record": lambda v: {"a": v}, "repeatable": lambda v: [v], "values": lambda v: {"a": {"x": v}},
    "changes": lambda v: [v],
}


def one_line(error: SegfmuError) -> bool:
    return bool(str(error)) and "\n" not in str(error)


@pytest.mark.parametrize("name", MADE)
def test_nonsense_for_a_system_is_one_error(probes: dict[int, Path], name: str) -> None:
    usual: dict[str, Any] = {"fmus": {"a": probes[2]}, "step": 0.1}
    for value in [*NONSENSE, *map(INNER.get(name, lambda v: v), NONSENSE)]:
        try:
            System(**{**usual, name: value}).close()
        except SegfmuError as error:
            assert one_line(error), value


@pytest.mark.parametrize("name", RUN)
def test_nonsense_for_a_run_is_one_error(probes: dict[int, Path], name: str) -> None:
    changes = [Change(v, "a", {"x": 1.0}) for v in NONSENSE]
    changes += [Change(0.1, v, {"x": 1.0}) for v in NONSENSE]
    changes += [Change(0.1, "a", v) for v in NONSENSE]
    changes += [Change(0.1, "a", {"x": v}) for v in NONSENSE]
    more = [[change] for change in changes] if name == "changes" else []
    with System({"a": probes[2]}, step=0.1) as system:
        for value in [*NONSENSE, *map(INNER.get(name, lambda v: v), NONSENSE), *more]:
            try:
                system.run(**{"stop_time": 0.2, name: value})
            except SegfmuError as error:
                assert one_line(error), value
        assert system.run(stop_time=0.2).size == 3


@pytest.mark.parametrize(("argument", "words"), [
    ({"record": {"a": "y"}}, "record of a must be a sequence of names, got 'y'"),
    ({"repeatable": "a"}, "repeatable must be a sequence of names, got 'a'"),
    ({"connections": ["abcd"]}, "a connection must be a sequence of names, got 'abcd'"),
    ({"fmus": [None]}, "fmus must be paths of files, got None"),
])
def test_a_name_is_no_sequence_of_names(
    probes: dict[int, Path], argument: dict[str, Any], words: str
) -> None:
    with pytest.raises(InputError) as info:
        System(**{"fmus": {"a": probes[2]}, "step": 0.1, **argument})
    assert str(info.value) == words


def test_changes_of_a_file_name_its_line(probes: dict[int, Path]) -> None:
    with System({"a": probes[2]}, step=0.1) as system:
        for name, value, told in (
            ("x", "much", "a: x takes a number, got 'much'"), ("z", 1.0, "a has no variable z"),
        ):
            changes = [Change(0.1, "a", {name: value}, origin="r.csv, line 3")]
            with pytest.raises(InputError, match=f"^r.csv, line 3: {told}"):
                system.run(stop_time=0.2, changes=changes)


def test_a_profile_has_a_value_for_each_time() -> None:
    assert profile("a", "x", iter([0.0, 1.0]), [1, 2]) == [
        Change(0.0, "a", {"x": 1}), Change(1.0, "a", {"x": 2})
    ]
    with pytest.raises(InputError, match=r"^x has 2 times but 1 values$"):
        profile("a", "x", [0.0, 1.0], [1])


@pytest.mark.parametrize("other", [None, list, "one", [1.0, 2.0], float("nan"), 1j])
def test_steps_and_tables_of_another_kind_are_told(other: Any, tmp_path: Path) -> None:
    for call in (
        lambda: require_steps(other, 0.1), lambda: require_steps(1.0, other),
        lambda: communication_points(0.0, other, 0.1),
        lambda: write_csv(tmp_path / "t.csv", other),
        lambda: profile(other, 3, [1.0], [1.0]),  # type: ignore[arg-type]
        lambda: System([], step=0.1, events=other),
    ):
        with pytest.raises(InputError):
            call()


def test_a_table_has_a_path_columns_of_numbers_and_units(tmp_path: Path) -> None:
    rows = np.zeros(2, [("time", float), ("on", bool)])
    write_csv(str(tmp_path / "t.csv"), rows, {"time": "s"})
    assert (tmp_path / "t.csv").read_text().splitlines()[0] == '"time [s]","on"'
    with pytest.raises(InputError, match="path must be that of a file, got 3"):
        write_csv(3, rows)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="units must be a mapping"):
        write_csv(tmp_path / "t.csv", rows, ["s"])  # type: ignore[arg-type]
    with pytest.raises(InputError, match="column name must have numbers, got <U3"):
        write_csv(tmp_path / "t.csv", np.zeros(2, [("time", float), ("name", "<U3")]))
    with pytest.raises(InputError, match="rows must be a structured array"):
        write_csv(tmp_path / "t.csv", np.zeros((2, 2)))
