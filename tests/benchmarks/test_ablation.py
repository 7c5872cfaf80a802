"""A way of planning is switched off in a copy of the kernels alone."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from benchmarks import ablation
from benchmarks.ablation import WAYS, build, durations, effects, switched_off

from tests.compiler import needs_cc


def test_every_way_is_in_the_kernels() -> None:
    source = (ablation.ROOT / "src" / ablation.KERNELS / "c" / "kernels.c").read_text("utf-8")
    for functions in WAYS.values():
        changed = switched_off(source, functions)
        assert len(changed) == len(source) + sum(len(s) + 1 for s in functions.values())
    with pytest.raises(LookupError, match="0 functions no_such"):
        switched_off(source, {"no_such": "return;"})


@needs_cc
def test_what_a_way_shortens_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    few = "import benchmarks.real_work as w; w.WORK = {'moving': w.WORK['moving']}; w.main()"
    monkeypatch.setattr(ablation, "COMMAND", ("-c", few))
    # so few plan sooner than an optimised kernel compiles
    quick = tuple("-O0" if option == "-O2" else option for option in ablation.OPTIONS)
    monkeypatch.setattr(ablation, "OPTIONS", quick)
    installed = tmp_path / "whole"
    installed.mkdir()
    (installed / "segfmu").symlink_to(ablation.ROOT / "src" / "segfmu")
    whole = durations(installed, 30)
    without = durations(build(WAYS["passing profiles"], tmp_path / "without"), 30)
    assert json.dumps(whole) != json.dumps(without)
    high = [row for row in effects("passing", whole, without) if row["n"] == "5, 6"]
    assert high and float(high[0]["largest"] or 0.0) > 1.05
    (none,) = effects("nothing", whole, whole)
    assert none["kind of work"] == "none"
