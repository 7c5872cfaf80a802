"""The command that fits a crane file to logs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from segfmu.cli.console import console, tell
from segfmu.cli.work import warn, watched
from segfmu.errors import InputError
from segfmu.validation.output import folder, require_folder, require_kept, require_there

if TYPE_CHECKING:
    from segfmu.validation.identification.result import Identification

CRANE, PLOT, RESULTS = "crane.toml", "identification.png", "identification.json"


def identify(
    logs: Annotated[list[Path], typer.Argument(metavar="LOG...", help="Tables of signals (CSV).")],
    crane: Annotated[
        Path, typer.Option("--crane", metavar="FILE", help="Crane file (TOML) to begin with.")
    ],
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="FOLDER", help="For crane file and plot.")
    ] = "out",
    fit: Annotated[
        list[str] | None,
        typer.Option(metavar="KEY", help="Key of the crane file to fit; repeat it for several."),
    ] = None,
    column: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=COLUMN", help="A signal's column in the logs; may be repeated."),
    ] = None,
    held_out: Annotated[
        float, typer.Option(help="Share of each log, at its end, that is only predicted.")
    ] = 0.25,
    piece: Annotated[
        float | None, typer.Option(metavar="SECONDS", help="Cut logs into pieces; see the manual.")
    ] = None,
    validation: Annotated[
        Path | None, typer.Option(metavar="LOG", help="A log that is only predicted.")
    ] = None,
    tube: Annotated[
        float, typer.Option(help="Half the width of tubes, as a share of a signal's peak.", min=0.0)
    ] = 0.05,
) -> None:
    """Fit parameters of a crane file to measured signals; write the crane file.

    Shown are intervals at 95 %, what the logs cannot tell, and how what was not fitted is followed.
    """
    from segfmu.validation.identification.crane_output import crane_text
    from segfmu.validation.identification.identify import identify as identified
    from segfmu.validation.identification.result_file import write_results
    from segfmu.validation.plots.style import save

    require_folder(output, CRANE, PLOT, RESULTS)
    require_kept(
        [crane, validation, *logs], (Path(output) / name for name in (CRANE, PLOT, RESULTS))
    )
    columns = {}
    for pair in column or []:
        name, equals, other = pair.partition("=")
        if not (name and equals and other):
            raise InputError(f"--column {pair}: must be NAME=COLUMN")
        columns[name] = other
    with watched() as progress:
        found = identified(
            logs, crane, fit=fit or None, columns=columns, held_out=held_out, piece=piece,
            validation=validation, tube=tube, progress=progress,
        )
    _show(found)
    # a crane that there is not leaves no files
    crane_text(found, Path(output) / CRANE)
    target = folder(output)
    write_results(found, target / RESULTS)
    save(found.plot(), target / PLOT)
    found.write(target / CRANE)
    require_there(target / name for name in (CRANE, PLOT, RESULTS))
    tell(f"crane file: {target / CRANE}")


def _show(found: Identification) -> None:
    from segfmu.validation.identification.tables import estimates_table, predictions_table

    console.print(estimates_table(found))
    if not found.converged:
        warn("the fit came to no end; values nearer to the crane, or fewer of them, may help")
    for untold in found.untold:
        tell(str(untold))
    for title, parts in (("fitted", found.fitted), ("only predicted", found.predicted)):
        for part in parts:
            console.print(predictions_table(f"{title}: {part.log}", part))
            for excess in part.outside:
                tell(str(excess))
    for gap in found.gaps:
        warn(str(gap))
    for log in found.poor:
        warn(str(log))
    for drive in found.shifted:
        warn(str(drive))
    for signal in found.beyond:
        warn(str(signal))
