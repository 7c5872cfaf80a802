"""What `segfmu validate --json` prints, and `results.json` has."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

from segfmu.validation.documents.document import Part, ResultDocument, Text, Value
from segfmu.validation.files.keys import Key
from segfmu.validation.monitor import Finding
from segfmu.validation.requirements import of_results
from segfmu.validation.scenario_result import Result


class Judged(Part):
    """A criterion of a run."""

    name: Annotated[str, Key("name of the criterion")]
    kind: Annotated[str, Key("always, eventually, at, settled, tube or drives")]
    signal: Annotated[str, Key("what is judged")]
    unit: Annotated[str | None, Key(
        "of bound and margin; null of signals without, and of FMUs of your own"
    )]
    bound: Annotated[Value, Key("what the signal is held against; of drives a share")]
    margin: Annotated[Value, Key("distance from the bound; negative: the criterion fails")]
    normalised: Annotated[Value, Key("margin over bound; null for a bound of zero")]
    passed: Annotated[bool, Key("whether the criterion holds")]


class Times(Part):
    """Instants of a run."""

    start: Annotated[float, Key("begin of the run", "s")]
    arrival: Annotated[float, Key("end of the plan", "s")]
    end: Annotated[float, Key("end of the run", "s")]


class ScenarioResult(Part):
    """A scenario that was run."""

    scenario: Annotated[Text, Key("name of the scenario")]
    file: Annotated[Text, Key("scenario file")]
    expect: Annotated[Literal["pass", "fail"], Key("what the file expects")]
    passed: Annotated[bool, Key("whether the run came to its end and all criteria hold")]
    right: Annotated[bool, Key("whether it passed or failed as expected")]
    error: Annotated[Text | None, Key("why there is no run; null: there is one")]
    times_s: Annotated[Times | None, Key("instants of the run; null: there is no plan", "s")]
    table: Annotated[Text | None, Key("table of the run (CSV) in the folder; null: none")]
    criteria: Annotated[list[Judged], Key("all criteria")]


class Proof(Part):
    """What a run says of a criterion that names a requirement."""

    criterion: Annotated[str, Key("text or name of the criterion")]
    found: Annotated[str, Key("what was found")]
    holds: Annotated[bool | None, Key("null: no verdict")]


class RequirementResult(Part):
    """A requirement with its evidence."""

    requirement: Annotated[str, Key("name of the requirement")]
    verdict: Annotated[Literal["holds", "fails", "no evidence"], Key("over all evidence")]
    evidence: Annotated[list[Proof], Key("criteria that name the requirement")]


class SuiteDocument(ResultDocument):
    """Scenarios that were run."""

    passed: Annotated[bool, Key("whether every scenario passed or failed as expected")]
    scenarios: Annotated[list[ScenarioResult], Key("all scenarios")]
    requirements: Annotated[list[RequirementResult], Key("all requirements that are named")]


def suite_document(
    results: Sequence[Result], tables: Sequence[str | None] | None = None
) -> SuiteDocument:
    """The document of scenarios, and the names of their tables if these are written."""
    tables = tables or [None] * len(results)
    return SuiteDocument(
        passed=all(result.right for result in results),
        scenarios=[
            _scenario(result, table)
            for result, table in zip(results, tables, strict=True)
        ],
        requirements=[
            RequirementResult.model_validate({
                "requirement": one.name, "verdict": one.verdict, "evidence": [
                    Proof(criterion=e.criterion, found=e.found, holds=e.holds)
                    for e in one.evidence
                ],
            })
            for one in of_results(results)
        ],
    )


def _scenario(result: Result, table: str | None) -> ScenarioResult:
    file = result.scenario.file
    return ScenarioResult(
        scenario=file.name, file=str(result.scenario.path), expect=file.expect,
        passed=result.passed, right=result.right, error=result.error or None,
        times_s=Times(**result.known) if result.known else None, table=table,
        criteria=[_judged(finding) for finding in result.findings],
    )


def _judged(found: Finding) -> Judged:
    return Judged(
        name=found.name, kind=found.kind, signal=found.signal, unit=found.unit or None,
        bound=found.bound, margin=found.margin, normalised=found.normalised, passed=found.passed,
    )
