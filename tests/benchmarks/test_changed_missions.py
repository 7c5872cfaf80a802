"""A mission that is built once and changed in the importing tool keeps all its bounds."""

from __future__ import annotations

from collections import Counter

import pytest
from benchmarks.changed_missions import SITES, changes, compared

import segfmu
from tests.campaign import campaign, soaked


@campaign(4, 6)
@pytest.mark.parametrize("size", ["ship to shore", *soaked("lab")])
def test_a_changed_mission_keeps_its_bounds_or_is_refused_by_name(
    size: str, tmp_path, count: int
) -> None:
    site = SITES[size]
    archive = segfmu.build(segfmu.load_mission(site.mission), tmp_path).feedforward
    kinds: Counter[str] = Counter()
    for mission, values in changes(site, count):
        kind, used, apart = compared(archive, mission, values)
        kinds[kind] += 1
        if kind == "planned":
            assert 0.9 < used <= 1.0 + 1e-9
            assert apart <= 1e-9
    assert set(kinds) == {"planned", "refused"}
