"""Archives get their names together, and none of them if one cannot."""

from __future__ import annotations

from pathlib import Path

import pytest

import segfmu
from segfmu.errors import BuildError, InputError
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.placing import placing


@pytest.mark.parametrize("native", [True, False])
def test_no_archive_is_replaced_if_one_cannot_be(native: bool, tmp_path: Path) -> None:
    if not native:
        pytest.importorskip("pythonfmu")
    (tmp_path / "GantryFeedforward.fmu").write_text("old", encoding="utf-8")
    (tmp_path / "GantryCrane.fmu").mkdir()
    with pytest.raises(BuildError, match=r"GantryCrane\.fmu: cannot be written: Is a directory"):
        build_all(tmp_path, Choice(native))
    with pytest.raises(InputError, match=r"GantryCrane\.fmu: cannot be written: Is a directory"):
        segfmu.build(output=tmp_path, backend="native" if native else "python")
    assert (tmp_path / "GantryFeedforward.fmu").read_text(encoding="utf-8") == "old"
    assert len(list(tmp_path.iterdir())) == 2


def test_archives_appear_when_all_are_complete(tmp_path: Path) -> None:
    targets = [tmp_path / "new" / name for name in ("one.fmu", "two.fmu")]
    with placing(targets) as work:
        for target in targets:
            (work / target.name).write_text(target.stem, encoding="utf-8")
            assert not any(t.exists() for t in targets)
    assert [t.read_text(encoding="utf-8") for t in targets] == ["one", "two"]
    assert sorted((tmp_path / "new").iterdir()) == targets


def test_a_folder_that_came_meanwhile_is_seen_before_any_is_replaced(tmp_path: Path) -> None:
    targets = [tmp_path / name for name in ("one.fmu", "two.fmu")]
    with pytest.raises(BuildError, match=r"two\.fmu: cannot be written"), placing(targets) as work:
        for target in targets:
            (work / target.name).write_text("new", encoding="utf-8")
        targets[1].mkdir()
    assert list(tmp_path.iterdir()) == [targets[1]]


def test_the_file_that_cannot_be_put_in_place_is_named(tmp_path: Path) -> None:
    target = tmp_path / "one.fmu"
    with pytest.raises(BuildError, match=r"one\.fmu: cannot be written"), placing([target]):
        pass
