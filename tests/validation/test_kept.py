"""Values that are kept, those asked for last; keys of what was found right."""

from __future__ import annotations

from segfmu.validation.kept import Kept, Right


def test_the_value_that_was_not_asked_for_longest_is_dropped() -> None:
    dropped: list[str] = []
    kept = Kept(2, dropped.append)
    for key in ("one", "two", "one", "three"):
        assert kept.get(key, key.upper) == key.upper()
    assert dropped == ["TWO"]
    assert kept.get("one", lambda: "made again") == "ONE"
    kept.clear()
    assert sorted(dropped) == ["ONE", "THREE", "TWO"]
    assert kept.get("one", lambda: "made again") == "made again"


def test_what_was_found_right_is_remembered_until_there_are_too_many() -> None:
    right = Right(2)
    right.add("one")
    right.add("two")
    assert "one" in right and "two" in right and "three" not in right
    right.add("three")
    assert "three" in right and "one" not in right
