"""Factors: which key of which file they set."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from segfmu.errors import InputError
from segfmu.validation.campaigns.factors import changes, nominal
from segfmu.validation.files.campaign_tables import FactorTable
from segfmu.validation.files.scenario_file import (
    Scenario,
    Source,
    build_scenario,
    read_source,
)
from tests.validation.campaigns.files import SCENARIO

EVENTS = """
[[events]]
time = 1.0
values = { "feedback.enabled" = false }
"""


@pytest.fixture
def source(tmp_path: Path) -> Source:
    path = tmp_path / "s.toml"
    path.write_text(SCENARIO + EVENTS, encoding="utf-8")
    return read_source(path)


def changed(source: Source, **values: Any) -> Scenario:
    """The scenario with keys at values; dots are written as two underscores."""
    keys = [n.replace("__", ".") for n in values]
    factors = [FactorTable(name=f"f{i}", key=k, range=[-1e9, 1e9]) for i, k in enumerate(keys)]
    sample = {f"f{i}": v for i, v in enumerate(values.values())}
    return build_scenario(source, changes(source, factors, sample))


def test_keys_of_crane_mission_and_controller(source: Source) -> None:
    found = changed(
        source, true_crane__bridge__lag=0.1, crane__payload_mass=2.0, limits__x__velocity=0.21,
        simulation__settle=2.5, controller__bandwidth=1.5, step=0.02, plan__smoothness=5,
    )
    mission = found.mission
    assert mission.simulated.bridge.lag == 0.1 and mission.crane.bridge.lag != 0.1
    # the true crane is the nominal one but for its own changes
    assert mission.crane.payload_mass == mission.simulated.payload_mass == 2.0
    assert mission.limits is not None and mission.limits.x.velocity == 0.21
    assert mission.limits.y.velocity == 0.22
    assert mission.simulation.settle == 2.5 and mission.simulation.step == 0.02
    assert mission.crane.controller.bandwidth == 1.5 and mission.smoothness == 5


def test_entries_of_lists_by_place_and_by_name(source: Source) -> None:
    found = changed(
        source, plan__waypoints__2__position__0=0.2, plan__waypoints__2__position__2=-0.75,
        simulation__initial_sway__1=0.3, criteria__rests__bound=0.5, events__0__time=1.5,
    )
    last = found.mission.waypoints[2]
    assert last.position == [0.2, 0.3, -0.75]
    assert found.mission.waypoints[1].velocity == [0.2, 0.2, 0.0]
    assert found.mission.simulation.initial_sway == [0.0, 0.3]
    assert {c.name: c.bound for c in found.file.criteria} == {"follows": 0.02, "rests": 0.5}
    assert found.file.events[0].time == 1.5
    assert found.file.events[0].values == {"feedback.enabled": False}


def test_variables_of_fmus_have_dots(source: Source) -> None:
    factors = [
        FactorTable(name="a", key="parameters.GantryCrane.drive.bridge.lag", range=[0.0, 1.0]),
        FactorTable(name="b", key="events.0.values.feedback.enabled", values=[True, False]),
    ]
    found = build_scenario(source, changes(source, factors, {"a": 0.25, "b": True})).file
    assert found.parameters == {"GantryCrane": {"drive.bridge.lag": 0.25}}
    assert found.events[0].values == {"feedback.enabled": True}


def test_multiples_of_what_the_files_have(source: Source) -> None:
    factor = FactorTable(name="m", key="true_crane.bridge_mass", range=[0.5, 2.0], relative=True)
    found = build_scenario(source, changes(source, [factor], {"m": 1.5}))
    assert found.mission.simulated.bridge_mass == pytest.approx(1.5 * 2.2, abs=1e-15)
    assert nominal(source, factor) == 2.2
    none = FactorTable(name="m", key="true_crane.bridge.force_max", range=[0.5, 2.0], relative=True)
    with pytest.raises(InputError, match=r"m: relative: true_crane.bridge.force_max is no number"):
        changes(source, [none], {"m": 1.5})
    text = FactorTable(name="d", key="controller.design", values=[1.0, 2.0], relative=True)
    words = r"d: relative: controller\.design is no number in the files, but 'lqr'$"
    with pytest.raises(InputError, match=words):
        changes(source, [text], {"d": 2.0})


def test_variants_are_merged_and_later_factors_see_them(source: Source) -> None:
    gust = {"true_crane": {"wind": {"gust": {"start": 1.0, "duration": 0.5,
                                             "force": [0.1, 0.2, 0.0]}}}}
    factors = [
        FactorTable(name="row", variants={"gust": gust, "calm": {}}),
        FactorTable(name="y", key="true_crane.wind.gust.force.1", range=[0.0, 1.0]),
    ]
    found = build_scenario(source, changes(source, factors, {"row": "gust", "y": 0.9}))
    own = found.mission.simulated.wind.gust
    assert own is not None and own.force == [0.1, 0.9, 0.0]
    calm = build_scenario(source, changes(source, factors, {"row": "calm"}))
    assert calm.mission.simulated.wind.gust is None


@pytest.mark.parametrize(("key", "said"), [
    ("true_crane.paylod_mass", "paylod_mass: unknown key; did you mean payload_mass"),
    ("payload_mass", "payload_mass: unknown key"),
    ("simulation.initial_sway.2", "a list has no entry 2"),
    ("criteria.none.bound", "a list has no entry none"),
    ("step.x", "x is below a value"),
])
def test_keys_that_there_are_not(source: Source, key: str, said: str) -> None:
    factor = FactorTable(name="f", key=key, range=[0.0, 1.0])
    with pytest.raises(InputError, match=said):
        build_scenario(source, changes(source, [factor], {"f": 0.5}))
