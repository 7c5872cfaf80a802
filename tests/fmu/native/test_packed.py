"""The archive of a platform's libraries."""

import lzma

import pytest

from segfmu.fmu.native.packed import pack, unpack


def test_libraries_come_back_and_the_archive_follows_from_them_alone() -> None:
    libraries = {"b.so": bytes(range(256)) * 3, "a.so": b"", "c.so": b"\0" * 513}
    archive = pack(libraries)
    assert unpack(archive) == libraries
    assert pack(dict(reversed(libraries.items()))) == archive


def test_what_libraries_share_is_packed_once() -> None:
    code = bytes(i * i % 251 for i in range(20_000)) + bytes(i**3 % 241 for i in range(20_000))
    assert len(pack({"a.so": code, "b.so": code})) < 1.1 * len(pack({"a.so": code}))


def test_damage_is_an_error() -> None:
    archive = pack({"a.so": bytes(1000)})
    with pytest.raises(lzma.LZMAError):
        unpack(archive[:-20])
