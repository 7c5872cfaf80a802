"""What tests keep from run to run is made anew where anything that it follows from changes."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests import made
from tests.compiler import CC, compiled, needs_cc


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SEGFMU_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(made, "SOAK", False)


def test_it_is_made_once_for_each_content_and_name() -> None:
    count = 0

    def once(name: str, content: bytes) -> bytes:
        nonlocal count

        def make() -> bytes:
            nonlocal count
            count += 1
            return content + b" made"

        return made.made(name, lambda: {"a": content}, make)

    for name, content, times in (
        ("One", b"x", 1), ("One", b"x", 1), ("One", b"y", 2), ("Two", b"y", 3), ("One", b"x", 3),
    ):
        assert once(name, content) == content + b" made" and count == times


def test_what_changes_meanwhile_is_not_kept(tmp_path: Path) -> None:
    source = tmp_path / "source"

    def made_of(later: bytes) -> bytes:
        source.write_bytes(b"old")

        def make() -> bytes:
            source.write_bytes(later)
            return source.read_bytes()

        return made.made("One", lambda: {"a": source.read_bytes()}, make)

    assert made_of(b"new") == b"new"
    assert made_of(b"old") == b"old"
    # now it is kept
    assert made_of(b"new") == b"old"


def test_a_soak_makes_it_again(monkeypatch: pytest.MonkeyPatch) -> None:
    assert made.made("One", dict, lambda: b"1") == b"1"
    assert made.made("One", dict, lambda: b"2") == b"1"
    monkeypatch.setattr(made, "SOAK", True)
    assert made.made("One", dict, lambda: b"2") == b"2"


def test_a_file_that_has_changed_since_the_start_is_told(tmp_path: Path) -> None:
    assert made.unchanged([Path(made.__file__)])
    (tmp_path / "new").touch()
    assert not made.unchanged([Path(made.__file__), tmp_path / "new"])


@needs_cc
def test_objects_follow_from_sources_headers_and_words(tmp_path: Path) -> None:
    source, header = tmp_path / "one.c", tmp_path / "one.h"
    source.write_text('#include "one.h"\nint one(void) { return ONE; }\n')
    found = []
    for text, word in (("1", "-O0"), ("2", "-O0"), ("2", "-O2"), ("1", "-O0")):
        header.write_text(f"#define ONE {text}\n")
        compiled(tmp_path / "made", [word, "-c", "one.c"], tmp_path, CC)
        found.append((tmp_path / "made").read_bytes())
    assert len(set(found)) == 3 and found[0] == found[3]
