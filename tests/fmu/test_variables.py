"""Every output moves, and every parameter and input acts, on both backends.

A variable that the specification has but no model computes or reads fails here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial
from math import isclose

import pytest

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.slave import CraneSlave
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.gantry_feedforward.slave import FeedforwardSlave
from segfmu.fmu.standard.spec import Spec, Variable
from tests.campaign import SOAK
from tests.fmu.bench import Bench, Rows, SlaveBench, bench
from tests.fmu.scenarios import (
    CRANE,
    FEEDFORWARD,
    LAGS,
    REFUSALS,
    VELOCITY,
    Scenario,
    changed,
    row_scenario,
)

Runs = Bench | SlaveBench
Case = tuple[Runs, Spec, dict[str, Scenario], dict[str, Rows]]
# in FMI 3 the same sources read them, but for its way to set values
BACKENDS = ("python", "fmi2", *(["fmi3"] if SOAK else []))
MODELS = ("feedforward", "crane")
SLAVES = {"feedforward": FeedforwardSlave, "crane": CraneSlave}
SCENARIOS = {"feedforward": FEEDFORWARD, "crane": CRANE}


def spec_of(backend: str, model: str) -> Spec:
    interface = {"feedforward": gantry_feedforward, "crane": gantry_crane}[model]
    return interface.spec() if backend == "python" else interface.native_spec()


def results(spec: Spec) -> list[str]:
    """Names of all that an FMU computes."""
    return [v.name for v in spec.where("output", "local", "calculatedParameter")]


def model_of(scenarios: dict[str, Scenario]) -> str:
    """Which model they are for."""
    return next(m for m in MODELS if SCENARIOS[m] is scenarios)


def run(runs: Runs, scenario: Scenario) -> Rows:
    """A run that must not be refused."""
    rows = runs.run(scenario.values, scenario.inputs, scenario.times)
    assert rows is not None, runs.messages
    return rows


@pytest.fixture(scope="module", params=[(b, m) for b in BACKENDS for m in MODELS],
                ids=lambda p: f"{p[0]}-{p[1]}")
def case(request) -> Iterator[Case]:
    """A bench, its specification and scenarios, and what runs of these tell."""
    backend, model = request.param
    spec = spec_of(backend, model)
    scenarios = SCENARIOS[model]
    if backend == "python":
        runs = SlaveBench(SLAVES[model], results(spec))
        yield runs, spec, scenarios, {n: run(runs, s) for n, s in scenarios.items()}
        return
    archives = request.getfixturevalue("native_fmus")[int(backend[-1])]
    with bench(archives[MODELS.index(model)], spec, results(spec)) as runs:
        yield runs, spec, scenarios, {n: run(runs, s) for n, s in scenarios.items()}


def test_every_output_moves(case) -> None:
    _, spec, _, told = case
    still = [
        name for name in results(spec)
        if len({value for rows in told.values() for value in rows[name]}) < 2
    ]
    assert still == []


@pytest.mark.soak
def test_every_parameter_and_input_acts(case) -> None:
    runs, spec, scenarios, told = case
    told = dict(told)
    refusing = REFUSALS[model_of(scenarios)]
    idle = []
    # the scenario in which the last variable of a group acted is the first one for the next
    last: dict[str, str] = {}
    # Python reads all rows in one loop; C by a table that has each
    variables = list(spec.where("parameter", "input"))
    for variable in few_rows(variables) if isinstance(runs, SlaveBench) else variables:
        if variable.name in refusing:
            continue
        group = re.split(r"[.\[]", variable.name)[0]
        tried = rows_of_the_table(variable, spec) or scenarios
        first = last.get(group, "")
        found = acts(
            variable, runs, dict(sorted(tried.items(), key=lambda item: item[0] != first)), told
        )
        if found is None:
            idle.append(variable.name)
        else:
            last[group] = found
    assert idle == []


def few_rows(variables: list[Variable]) -> list[Variable]:
    """Without the rows between the second and the last one, which a soak takes as well."""
    places = [re.match(r"(.+)\[(\d+)\]", variable.name) for variable in variables]
    last = {place[1]: int(place[2]) for place in places if place}
    return [
        variable for variable, place in zip(variables, places, strict=True)
        if SOAK or not place or int(place[2]) in (1, 2, last[place[1]])
    ]


def rows_of_the_table(variable: Variable, spec: Spec) -> dict[str, Scenario]:
    """A scenario in which the row of the table of gains acts that the variable belongs to."""
    if variable.name == "feedback.table.count":
        row = f"table[{variable.start}]"
    elif variable.name.startswith("feedback.table["):
        row = variable.name.split(".")[1]
    else:
        return {}
    length = spec.variable(f"feedback.{row}.length").start
    if variable.name.endswith(".command"):
        # only velocity drives have one, once something was added
        return {f"{row}, velocity": row_scenario(length, VELOCITY | LAGS | {
            "feedback.table.mode": "velocity"
        })}
    return {row: row_scenario(length)}


def acts(
    variable: Variable, runs: Runs, scenarios: dict[str, Scenario], told: dict[str, Rows]
) -> str | None:
    """The first scenario in which a change of a variable is seen in an output, if there is one."""
    for name, scenario in scenarios.items():
        if name not in told:
            told[name] = run(runs, scenario)
        held, values = {}, scenario.values
        if variable.causality == "input":
            start = scenario.inputs(0.0).get(variable.name, variable.start)
            held = {variable.name: changed(variable, start)}
        else:
            start = values.get(variable.name, variable.start)
            values = values | {variable.name: changed(variable, start)}
        differs = partial(differ, other=told[name])
        rows = runs.run(values, lambda t: scenario.inputs(t) | held, scenario.times, differs)
        if rows is not None and differs(rows):
            return name
    return None


def differ(rows: Rows, other: Rows) -> bool:
    """Whether the last values differ from those of the other run at that time.

    By more than rounding: another way to the same plan is no change.
    """
    return any(
        not isclose(values[-1], other[name][len(values) - 1], rel_tol=1e-7, abs_tol=1e-9)
        for name, values in rows.items()
    )


def test_what_only_refuses_says_why(case) -> None:
    runs, spec, scenarios, _ = case
    for name, (scenario, value, words) in REFUSALS[model_of(scenarios)].items():
        if name not in spec.references:
            continue
        tried = scenarios[scenario]
        assert runs.run(tried.values | {name: value}, tried.inputs, tried.times) is None, name
        assert words in runs.messages[-1], name
