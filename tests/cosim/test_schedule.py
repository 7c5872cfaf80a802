"""The order in which units leave initialisation mode and hand on their outputs."""

from __future__ import annotations

from types import SimpleNamespace

from segfmu.cosim.schedule import initialise


def test_each_unit_leaves_with_the_outputs_of_those_before_it() -> None:
    done: list[str] = []

    def said(words: str) -> object:
        return lambda: done.append(words)

    a, b, c = (SimpleNamespace(exit_initialization=said(f"{n} leaves")) for n in "abc")
    links = [
        SimpleNamespace(source=source, sink=sink, pass_on=said(words))
        for source, sink, words in ((a, b, "a to b"), (b, c, "b to c"), (c, a, "c to a"))
    ]
    initialise([a, b, c], links, [])
    assert done == [
        "c to a", "a leaves", "a to b", "b leaves", "b to c", "c leaves",
        # what c gives now
        "c to a",
    ]
