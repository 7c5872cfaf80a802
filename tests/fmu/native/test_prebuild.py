"""The queue of the binaries that a wheel carries."""

from itertools import groupby
from pathlib import Path

import pytest

from segfmu.fmu.models import registered
from segfmu.fmu.native import prebuild
from segfmu.fmu.native.compilers import BROWSER, PLATFORMS
from segfmu.fmu.native.packed import unpack
from segfmu.fmu.native.prebuild import PAGE, jobs


def test_every_library_is_compiled_once_and_platforms_take_turns() -> None:
    found = jobs()
    models = {model.name for model in registered()}
    assert len(found) == len(set(found))
    assert set(found) == {
        *((p, name, fmi) for p in PLATFORMS for name in models for fmi in (2, 3)),
        *((BROWSER.name, name, 2) for name in PAGE),
    }
    # two of a platform would wait for one C library
    assert all(len(list(same)) == 1 for _, same in groupby(found, key=lambda job: job[0]))
    assert [name.endswith("Feedforward") for _, name, _ in found] == sorted(
        (name.endswith("Feedforward") for _, name, _ in found), reverse=True
    )


def test_an_archive_is_written_where_it_is_another_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(prebuild, "TARGET", tmp_path)
    path = tmp_path / "vax.tar.xz"

    def written(library: bytes) -> int:
        told = prebuild._write("vax.tar.xz", {"one.so": library})
        assert told.startswith("vax.tar.xz: ") and list(tmp_path.iterdir()) == [path]
        assert unpack(path.read_bytes()) == {"one.so": library}
        return path.stat().st_mtime_ns

    first = written(b"one")
    assert written(b"one") == first
    assert written(b"other") > first
    path.write_bytes(b"damaged")
    written(b"other")
