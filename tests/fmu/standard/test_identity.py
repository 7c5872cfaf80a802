"""The identifier of an FMU: what it follows from, and that every machine gives the same one."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from segfmu.errors import InputError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.standard import identity
from segfmu.fmu.standard.identity import guid
from segfmu.fmu.standard.spec import Spec, started

CRANE = gantry_crane.native_spec()
MODELS = Path(__file__).parents[3] / "models"
GUIDS = f"""
from pathlib import Path
from segfmu.fmu.gantry_crane import interface as crane
from segfmu.fmu.gantry_feedforward import interface as feedforward
from segfmu.fmu.standard.identity import guid
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.scenario import specs

print(guid(crane.spec()), guid(crane.native_spec()), guid(feedforward.native_spec()))
for path in sorted(Path({str(MODELS)!r}).glob("[ip]*.toml")):
    mission = load_mission(path)
    first, second = specs(mission, mission.plan())
    print(path.stem, guid(feedforward.native_spec(first)), guid(crane.native_spec(second)))
"""


def starts(spec: Spec) -> dict[str, float]:
    return {v.name: v.start for v in spec.variables}


def nudged(spec: Spec, *names: str) -> Spec:
    """With the last digit of some start values changed."""
    return replace(spec, variables=tuple(
        replace(v, start=math.nextafter(v.start, math.inf)) if v.name in names else v
        for v in spec.variables
    ))


def test_every_kind_of_processor_gives_the_same() -> None:
    found = set()
    for kind in ("Prescott", "Nehalem", "Haswell"):
        done = subprocess.run(
            [sys.executable, "-c", GUIDS], capture_output=True, text=True, timeout=600,
            env=os.environ | {"OPENBLAS_CORETYPE": kind},
        )
        assert done.returncode == 0, f"{kind}: {done.stderr}"
        found.add(done.stdout)
    assert len(found) == 1, found


def test_computed_gains_do_not_count() -> None:
    table = [v.name for v in CRANE.variables if v.name.startswith("feedback.table[")]
    # a length, four gains and that of the command for two axes, two and it for the hoist
    assert len(table) == gantry_crane.MOST_ROWS * 14
    assert guid(nudged(CRANE, *table)) == guid(CRANE)
    assert all(v.computed == (v.name in table) for v in CRANE.variables)


def test_gains_that_are_given_count() -> None:
    name = "feedback.table[3].bridge.angle"
    assert guid(started(CRANE, {name: 7.0})) != guid(CRANE)
    assert guid(started(CRANE, {name: 7.0})) != guid(started(CRANE, {name: 8.0}))


@pytest.mark.parametrize("change", [
    {"name": "other"}, {"unit": "km"}, {"minimum": -1.0}, {"maximum": 1e3}, {"start": 2.3},
    {"description": "other"}, {"variability": "tunable"}, {"nominal": 3.0},
])
def test_what_is_declared_counts(change: dict[str, object]) -> None:
    place = CRANE.references["crane.bridge_mass"]
    variables = list(CRANE.variables)
    variables[place] = replace(variables[place], **change)
    assert guid(replace(CRANE, variables=tuple(variables))) != guid(CRANE)


def test_the_release_counts(monkeypatch) -> None:
    first = guid(CRANE)
    monkeypatch.setattr(identity, "version", lambda _: "99.0")
    assert guid(CRANE) != first


def test_the_last_digits_of_planned_start_values_do_not_count() -> None:
    spec = gantry_feedforward.native_spec()
    values = {"waypoint[2].velocity.x": 1.0 / 7.0, "waypoint[2].velocity.y": 2.0 / 7.0}
    assert guid(nudged(started(spec, values), *values)) == guid(started(spec, values))
    values |= {"waypoint[2].velocity.y": 2.0 / 7.0 + 1e-6}
    assert guid(started(spec, values)) != guid(nudged(spec))


WEIGHTS = ("position", "angle", "velocity", "rate", "effort")


@pytest.mark.parametrize("weight", WEIGHTS)
def test_weights_given_at_the_build_make_the_table(weight: str) -> None:
    name = f"feedback.weight.{weight}"
    made = gantry_crane.native_spec(started(gantry_crane.spec(), {name: 4.0}))
    assert name not in made.references
    usual, found = starts(CRANE), starts(made)
    changed = {n for n in usual if usual[n] != found[n]}
    assert {f"feedback.table[{i}].trolley.angle" for i in range(1, 18)} <= changed
    assert all(n.startswith("feedback.table[") for n in changed)
    assert guid(made) != guid(CRANE)
    count = made.variable("feedback.table.count")
    assert f"{weight} 4.0" in count.description


def test_weights_without_a_design_are_refused() -> None:
    for weight in ("position", "effort"):
        own = started(gantry_crane.spec(), {f"feedback.weight.{weight}": 0.0})
        with pytest.raises(InputError, match=f"weight {weight} must be positive"):
            gantry_crane.native_spec(own)


def test_weights_are_not_offered_where_they_cannot_act() -> None:
    with pytest.raises(KeyError, match=r"has no feedback\.weight\.position"):
        started(CRANE, {"feedback.weight.position": 4.0})
