"""What a suite of scenarios leaves: tables of the runs, results as JSON, criteria as JUnit XML."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from math import isfinite
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as xml

from rich.markup import escape
from rich.table import Table

from segfmu.cosim import write_csv
from segfmu.cosim.result import replacing
from segfmu.validation.junit import add_requirements, add_test, plain, write_tests
from segfmu.validation.requirements import of_results
from segfmu.validation.suite import Result
from segfmu.validation.units import signal_units


def write_results(folder: Path, results: Sequence[Result]) -> None:
    """Write a table of every run, and `results.json`.

    Raises
    ------
    InputError
        When a file cannot be written.
    """
    units = signal_units()
    for name, result in zip(_names(results), results, strict=True):
        if result.rows is not None:
            write_csv(folder / f"{name}.csv", result.rows, units)
    entries = [_entry(n, r) for n, r in zip(_names(results), results, strict=True)]
    with replacing(folder / "results.json") as path:
        path.write_text(json.dumps(entries, indent=2, allow_nan=False) + "\n", encoding="utf-8")


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
        table.add_column(name, justify="left" if name in ("criterion", "verdict") else "right")
    for result in results:
        table.add_section()
        error = f": {result.error}" if result.error else ""
        title = f"[bold]{escape(result.scenario.file.name)}[/]{escape(error)}"
        table.add_row(title, "", "", "", _verdict(result.passed, result))
        for found in result.findings:
            share = found.normalised
            table.add_row(
                f"  {escape(found.name)}", f"{found.bound:.4g}", f"{found.margin:+.4g}",
                "" if share is None else f"{100.0 * share:+.1f} %", _verdict(found.passed, result),
            )
    return table


def _verdict(passed: bool, result: Result) -> str:
    if passed:
        return "[green]passed[/]"
    return "[yellow]failed, as expected[/]" if result.right else "[red]failed[/]"


def _names(results: Sequence[Result]) -> list[str]:
    """Names of files, one for each result."""
    stems = [r.scenario.path.stem for r in results]
    return [s if stems.count(s) == 1 else f"{s}_{i}" for i, s in enumerate(stems, 1)]


def _entry(name: str, result: Result) -> dict[str, Any]:
    file = result.scenario.file
    return {
        "scenario": file.name, "file": str(result.scenario.path), "expect": file.expect,
        "passed": result.passed, "right": result.right, "error": result.error,
        "times": _finite(result.known), "table": "" if result.rows is None else f"{name}.csv",
        "criteria": [
            _finite({**asdict(f), "normalised": f.normalised, "passed": f.passed})
            for f in result.findings
        ],
    }


def _finite(entry: Mapping[str, Any]) -> dict[str, Any]:
    """JSON has neither NaN nor infinity: null."""
    return {
        k: None if isinstance(v, float) and not isfinite(v) else v for k, v in entry.items()
    }


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
                f"margin {found.margin:.6g} of {found.signal}, bound {found.bound:.6g}",
            )
    if result.passed and not result.right:
        add_test(suite, where, "expected to fail", "failure", "all criteria hold")
