"""The application: its commands, options and exit codes."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from importlib.metadata import version
from io import TextIOWrapper
from typing import Annotated, Any

import typer

from segfmu.cli import campaigns, files, identification, missions, verdicts
from segfmu.cli.console import console, print_document
from segfmu.errors import BuildError, InputError, SegfmuError

app = typer.Typer(
    add_completion=False,
    rich_markup_mode="markdown",
    help="Plan a crane load's motion, build the FMUs, co-simulate and judge them.\n\n"
    "Exit codes: 0 success, 1 infeasible plan or failed verdict, 2 invalid input.",
)
# of options and arguments
USAGE_ERROR: type[Any] = typer.BadParameter.__mro__[1]

# in the order of the help
COMMANDS = (
    (missions.plan, "segfmu plan models/paper.toml --output out"),
    (files.init, "segfmu init hall"),
    (files.schema, "segfmu schema mission > mission.schema.json"),
    (missions.build, "segfmu build models/paper.toml --output fmus/dist --fmi 3"),
    (missions.simulate, "segfmu simulate models/paper.toml --output out"),
    (missions.live, "segfmu live models/container.toml -o live.html"),
    (missions.paper, "segfmu paper --output out"),
    (campaigns.campaign, "segfmu campaign models/campaigns/paper.toml -o out"),
    (verdicts.validate, "segfmu validate models/scenarios -o out --junit out/junit.xml"),
    (identification.identify, "segfmu identify log.csv --crane crane.toml -o out"),
    (verdicts.compare, "segfmu compare out/gust.csv gust.csv --tube-value 1e-3 --relative"),
)
for command, example in COMMANDS:
    app.command(epilog=f"Example: {example}")(command)


def _show_version(wanted: bool) -> None:
    if wanted:
        console.print(f"segfmu {version('segfmu')}", highlight=False)
        raise typer.Exit


@app.callback()
def _options(
    show_version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_show_version, is_eager=True, help="Show the version and exit."
        ),
    ] = False,
) -> None:
    pass


def run() -> int:
    """Run the command of `sys.argv` and return its exit code; an error is one line on stderr."""
    if isinstance(sys.stdout, TextIOWrapper):
        # names and paths may have characters that the encoding of a terminal or a log has not
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        # without standalone mode, wrong options are raised
        return app(sys.argv[1:] or ["--help"], standalone_mode=False) or 0
    except SegfmuError as error:
        return _fail(error, str(error), 2 if isinstance(error, InputError | BuildError) else 1)
    except USAGE_ERROR as error:
        where = getattr(error.ctx, "command_path", "segfmu")
        return _fail(error, f"{error.format_message().rstrip('.')}; see {where} --help", 2)
    except OSError as error:
        name = f"{error.filename}: " if error.filename else ""
        return _fail(error, f"{name}{error.strerror or error}", 2)


def _fail(error: Exception, text: str, code: int) -> int:
    line = " ".join(text.split())
    print(f"segfmu: {line}", file=sys.stderr)
    # wrong options too, which no command gets to see
    if "--json" in sys.argv:
        from segfmu.validation.documents.document import refusal

        # where nothing can be printed, the line above has told why
        with suppress(OSError):
            print_document(refusal(error, line))
    try:
        sys.stdout.flush()
    except OSError:
        # what could not be printed would be tried again at the exit, with a traceback
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return code


def main() -> None:
    """Run the command of `sys.argv` and exit."""
    sys.exit(run())
