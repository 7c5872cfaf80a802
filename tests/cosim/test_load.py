"""What is read of archives, and when it is read again."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from segfmu.cosim import load


def test_a_description_is_read_once_until_its_archive_is_another_one(
    native_fmus, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    read = []

    def reading(path: str, own=load.read_model_description):
        read.append(path)
        return own(path)

    monkeypatch.setattr(load, "read_model_description", reading)
    archive = tmp_path / "a.fmu"
    names = []
    for given in (0, 0, 1):
        source = native_fmus[2][given]
        if not archive.exists() or archive.read_bytes() != source.read_bytes():
            shutil.copyfile(source, archive)
        with load.load(archive) as unit:
            names.append(unit.name)
    assert names == ["GantryFeedforward", "GantryFeedforward", "GantryCrane"]
    assert read == [str(archive)] * 2
