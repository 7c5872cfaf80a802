"""What a suite of scenarios leaves: tables of the runs, results as JSON, criteria as JUnit XML."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree as xml

from rich.markup import escape
from rich.table import Table

from segfmu.cosim import write_csv
from segfmu.cosim.result import replacing
from segfmu.validation.documents.document import text
from segfmu.validation.documents.suite import SuiteDocument, suite_document
from segfmu.validation.files.scenario_file import Scenario
from segfmu.validation.junit import add_requirements, add_test, plain, write_tests
from segfmu.validation.requirements import of_results
from segfmu.validation.scenario_result import Result
from segfmu.validation.units import with_unit


def write_results(folder: Path, results: Sequence[Result]) -> SuiteDocument:
    """Write a table of every run, and `results.json`, which is returned.

    Raises
    ------
    InputError
        When a file cannot be written.
    """
    tables = _tables(results)
    for name, result in zip(tables, results, strict=True):
        if name is not None and result.rows is not None:
            write_csv(folder / name, result.rows, result.scenario.units)
    document = suite_document(results, tables)
    with replacing(folder / "results.json") as path:
        path.write_text(text(document), encoding="utf-8")
    return document


def write_junit(path: Path, results: Sequence[Result]) -> None:
    """Write all criteria as JUnit XML, for servers that show tests.

    Criteria that fail in a scenario that is expected to are skipped.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    root = xml.Element("testsuites", name="segfmu validate")
    for result in results:
        _suite(root, result)
    add_requirements(root, of_results(results))
    write_tests(path, root)


def suite_table(results: Sequence[Result]) -> Table:
    """Every criterion with its margin and verdict."""
    table = Table()
    for name in ("criterion", "bound", "margin", "of the bound", "verdict"):
        left = name in ("criterion", "verdict")
        # a number without its unit on the next line is misread
        table.add_column(name, justify="left" if left else "right", no_wrap=not left)
    for result in results:
        table.add_section()
        error = f": {result.error}" if result.error else ""
        title = f"[bold]{escape(result.scenario.file.name)}[/]{escape(error)}"
        table.add_row(title, "", "", "", _verdict(result.passed, result))
        for found in result.findings:
            share = found.normalised
            table.add_row(
                f"  {escape(found.name)}", with_unit(f"{found.bound:.4g}", found.unit),
                with_unit(f"{found.margin:+.4g}", found.unit),
                "" if share is None else f"{100.0 * share:+.1f} %", _verdict(found.passed, result),
            )
    return table


def _verdict(passed: bool, result: Result) -> str:
    if passed:
        return "[green]passed[/]"
    return "[yellow]failed, as expected[/]" if result.right else "[red]failed[/]"


def table_names(scenarios: Sequence[Scenario]) -> list[str]:
    """Names of tables, one for each scenario."""
    stems = [s.path.stem for s in scenarios]
    names = [s if stems.count(s) == 1 else f"{s}_{i}" for i, s in enumerate(stems, 1)]
    return [f"{name}.csv" for name in names]


def _tables(results: Sequence[Result]) -> list[str | None]:
    """The same, one for each result with a run."""
    names = table_names([r.scenario for r in results])
    return [None if r.rows is None else n for n, r in zip(names, results, strict=True)]


def _suite(root: xml.Element, result: Result) -> None:
    file = result.scenario.file
    suite = xml.SubElement(root, "testsuite", name=plain(file.name))
    where = str(result.scenario.path)
    if result.error:
        add_test(suite, where, "run", "skipped" if result.right else "error", result.error)
    for found in result.findings:
        if found.passed:
            add_test(suite, where, found.name)
        else:
            add_test(
                suite, where, found.name, "skipped" if result.right else "failure",
                f"margin {with_unit(f'{found.margin:.6g}', found.unit)} of {found.signal}, bound "
                f"{with_unit(f'{found.bound:.6g}', found.unit)}",
            )
    if result.passed and not result.right:
        add_test(suite, where, "expected to fail", "failure", "all criteria hold")
