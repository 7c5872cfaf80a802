"""Values that are kept: those asked for last."""

from __future__ import annotations

from segfmu.validation.kept import Kept


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
