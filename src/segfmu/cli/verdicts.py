"""Commands that judge: scenarios, and results against references."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from segfmu.cli.console import AsJson, console, print_document, tell
from segfmu.cli.work import watched
from segfmu.validation.output import folder, require_file, require_folder

# signals outside of their tubes that are listed
MOST_SHOWN = 10
# what `validate` writes, beside a table of every run
SUITE_FILES = ("results.json", "report.html")


def validate(
    paths: Annotated[
        list[Path], typer.Argument(metavar="PATH...", help="Scenario files, or folders of them.")
    ],
    output: Annotated[
        str | None,
        typer.Option(
            "--output", "-o", metavar="FOLDER", help="For tables, results.json and a report."
        ),
    ] = None,
    junit: Annotated[
        Path | None, typer.Option("--junit", metavar="FILE", help="JUnit XML of all criteria.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Run scenarios as co-simulations of both FMUs; show every criterion, margin and verdict.

    The exit code is 0 if every scenario passes or fails as its file expects.
    """
    from segfmu.validation import suites
    from segfmu.validation.documents.suite import suite_document
    from segfmu.validation.suite_files import suite_table, write_junit, write_results

    if output is not None:
        require_folder(output, *SUITE_FILES)
    if junit is not None:
        require_file(junit)
    with watched() as progress:
        suite = suites.validate(paths, progress=progress)
    # first what cannot fail for a full disk
    if not as_json:
        console.print(suite_table(suite.results))
        right = sum(result.right for result in suite)
        console.print(f"{right} of {len(suite)} scenarios as expected")
    document = suite_document(suite.results)
    if output is not None:
        target = folder(output)
        document = write_results(target, suite.results)
        report = suite.report(target / "report.html")
        if not as_json:
            tell(f"report: {report}")
    if junit is not None:
        write_junit(junit, suite.results)
    if as_json:
        print_document(document)
    if not suite.passed:
        raise typer.Exit(1)


def compare(
    result: Annotated[Path, typer.Argument(help="Table of a run (CSV).")],
    reference: Annotated[Path, typer.Argument(help="Table that it is to agree with (CSV).")],
    tube_time: Annotated[
        float, typer.Option(help="Half the width of the tubes in time [s].", min=0.0)
    ] = 0.0,
    tube_value: Annotated[
        float, typer.Option(help="Half the width in value, in the unit of each signal.", min=0.0)
    ] = 0.0,
    relative: Annotated[
        bool,
        typer.Option("--relative", help="The width in value is a share of the signal's peak."),
    ] = False,
) -> None:
    """Compare a table with a reference in tubes; name the first signal that leaves its own."""
    from segfmu.validation.comparison import compare as compared
    from segfmu.validation.signal_table import read_table

    tables = read_table(result), read_table(reference)
    found = compared(*tables, tube_time=tube_time, tube_value=tube_value, relative=relative)
    for excess in found[:MOST_SHOWN]:
        tell(str(excess))
    count = len(tables[1]) - 1
    console.print(f"{count - len(found)} of {count} signals are in their tubes", highlight=False)
    if found:
        raise typer.Exit(1)
