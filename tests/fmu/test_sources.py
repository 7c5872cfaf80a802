"""Sources in C, from folders and from the archive of a wheel."""

from __future__ import annotations

import tarfile
from io import BytesIO
from pathlib import Path

import pytest

from segfmu.fmu import sources

PACKAGE = "segfmu.fmu.native"
FOLDER = Path(sources.__file__).parent / "native" / "c"


def test_a_folder_gives_its_sources_in_the_order_of_their_names() -> None:
    found = sources.sources_of(PACKAGE)
    assert found["fmi/fmi2Functions.h"] == (FOLDER / "fmi" / "fmi2Functions.h").read_bytes()
    assert list(found) == sorted(found)
    assert {name.rpartition(".")[2] for name in found} == {"c", "h"}


def test_the_archive_of_a_wheel_gives_the_same(tmp_path: Path, monkeypatch) -> None:
    expected = {p: sources.sources_of(p) for p in (PACKAGE, "segfmu.fmu.crane", "segfmu.kernels")}
    (tmp_path / "fmu").mkdir()
    with tarfile.open(tmp_path / "fmu" / sources.ARCHIVE, "w:bz2") as archive:
        for package, texts in expected.items():
            for name, content in texts.items():
                entry = tarfile.TarInfo("/".join((*package.split(".")[1:], "c", name)))
                entry.size = len(content)
                archive.addfile(entry, BytesIO(content))
    monkeypatch.setattr(sources, "files", lambda p: tmp_path.joinpath(*p.split(".")[1:]))
    sources._archived.cache_clear()
    try:
        for package, texts in expected.items():
            assert list(sources.sources_of(package).items()) == list(texts.items())
        assert sources.sources_of("segfmu.validation") == {}
    finally:
        sources._archived.cache_clear()


def test_without_either_the_file_is_told(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(sources, "files", lambda p: tmp_path.joinpath(*p.split(".")[1:]))
    sources._archived.cache_clear()
    with pytest.raises(FileNotFoundError, match=sources.ARCHIVE):
        sources.sources_of(PACKAGE)
