"""Commands that judge: scenarios, and results against references."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from segfmu.cli.console import AsJson, console, print_document, tell
from segfmu.cli.work import warn_unproved, watched
from segfmu.errors import InputError
from segfmu.validation.output import (
    folder,
    require_apart,
    require_file,
    require_folder,
    require_kept,
    require_there,
)

if TYPE_CHECKING:
    from segfmu.validation.comparison import Excess

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
    from segfmu.validation.files.scenario_file import files_of, find, load_scenario, read_source
    from segfmu.validation.requirements import of_results
    from segfmu.validation.suite_files import (
        suite_table,
        table_names,
        write_junit,
        write_results,
    )

    if output is not None:
        require_folder(output, *SUITE_FILES)
    if junit is not None:
        require_file(junit)
    scenarios = [load_scenario(path) for path in find(paths)]
    names = [*SUITE_FILES, *table_names(scenarios)] if output is not None else []
    if junit is not None and output is not None:
        require_apart(junit, output, *names)
    written = [Path(output or "") / name for name in names] + ([junit] if junit else [])
    for scenario in scenarios:
        require_kept(files_of(read_source(scenario.path)), written)
    with watched() as progress:
        suite = suites.validate(scenarios, progress=progress)
    # first what cannot fail for a full disk
    if not as_json:
        console.print(suite_table(suite.results))
        right = sum(result.right for result in suite)
        console.print(f"{right} of {len(suite)} scenarios as expected")
    warn_unproved(of_results(suite.results))
    document = suite_document(suite.results)
    if output is not None:
        target = folder(output)
        document = write_results(target, suite.results)
        report = suite.report(target / "report.html")
        require_there(target / name for name in SUITE_FILES)
        if not as_json:
            tell(f"report: {report}")
    if junit is not None:
        write_junit(junit, suite.results)
    if as_json:
        print_document(document)
    if not suite.passed:
        raise typer.Exit(1)


def compare(
    result: Annotated[
        Path, typer.Argument(help="Table of a run (CSV), or an FMU with references inside.")
    ],
    reference: Annotated[
        Path | None,
        typer.Argument(help="Table that a table is to agree with (CSV); an FMU has its own."),
    ] = None,
    tube_time: Annotated[
        float, typer.Option(help="Half the width of the tubes in time [s].", min=0.0)
    ] = 0.0,
    tube_value: Annotated[
        float | None,
        typer.Option(
            help="Half the width in value, in the unit of each signal; default: 0, of an FMU 1e-6 "
            "of the peak or the unit.", min=0.0, show_default=False,
        ),
    ] = None,
    relative: Annotated[
        bool,
        typer.Option("--relative", help="The width in value is a share of the signal's peak."),
    ] = False,
) -> None:
    """Compare a table with a reference in tubes, or an FMU with the references inside of it.

    The experiments of an FMU are repeated. Named are the first signals that leave their tubes.
    """
    archive = result.suffix.lower() == ".fmu"
    if archive is not (reference is None):
        raise InputError(
            f"{result}: an FMU has its references inside; leave out {reference}" if archive
            else f"{result}: name the table that it is to agree with"
        )
    if reference is None:
        alike = _repeated(result, tube_time, tube_value, relative)
    else:
        alike = _compared(result, reference, tube_time, tube_value or 0.0, relative)
    if not alike:
        raise typer.Exit(1)


def _compared(
    result: Path, reference: Path, tube_time: float, tube_value: float, relative: bool
) -> bool:
    from segfmu.validation.comparison import compare as compared
    from segfmu.validation.signal_table import column_units, read_table
    from segfmu.validation.units import signal_units

    tables = read_table(result), read_table(reference)
    own, given = column_units(result), column_units(reference)
    for name in own.keys() & given.keys() & tables[1].keys():
        if own[name] != given[name]:
            raise InputError(
                f"{name} is in {own[name]} in {result} and in {given[name]} in {reference}; give "
                "both in one unit"
            )
    found = compared(
        *tables, tube_time=tube_time, tube_value=tube_value, relative=relative,
        units=signal_units() | given | own,
    )
    _tell(found, len(tables[1]) - 1)
    return not found


def _repeated(
    path: Path, tube_time: float, tube_value: float | None, relative: bool
) -> bool:
    from segfmu.validation.references.repeat import repeat

    with watched() as progress:
        references, found = repeat(
            path, tube_time=tube_time, tube_value=tube_value, relative=relative, progress=progress
        )
    for text in references.missing:
        tell(f"not repeated: {text}")
    for report in references.reports:
        tell(f"inside: {report.source}: {report.description}")
    for one in found:
        case = one.case
        tell(f"{case.name}: {case.start:.6g} to {case.stop:.6g} s in steps of {case.step:.6g} s")
        if one.error:
            tell(one.error)
            continue
        if one.left_out:
            tell(f"not compared: {', '.join(one.left_out)}")
        _tell(one.outside, one.signals)
    return all(one.alike for one in found)


def _tell(found: Sequence[Excess], count: int) -> None:
    for excess in found[:MOST_SHOWN]:
        tell(str(excess))
    console.print(f"{count - len(found)} of {count} signals are in their tubes", highlight=False)
