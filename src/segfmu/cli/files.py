"""Commands that help to write files."""

from __future__ import annotations

from shlex import quote
from typing import Annotated

import typer

from segfmu.cli.console import tell
from segfmu.errors import InputError
from segfmu.validation.output import folder


def init(
    output: Annotated[str, typer.Argument(metavar="FOLDER", help="Where to write them.")] = ".",
) -> None:
    """Write a commented mission and crane file to begin with; existing files are kept."""
    from segfmu.validation.files.template import write

    target = folder(output)
    for path in write(target):
        tell(str(path))
    tell(f"next: segfmu plan {quote(str(target / 'mission.toml'))}")


def schema(
    kind: Annotated[
        str, typer.Argument(metavar="[mission|crane|scenario|campaign]", help="Kind of file.")
    ] = "mission",
) -> None:
    """Print the JSON schema of a kind of file, with which editors complete and check."""
    from segfmu.validation.files.schema import KINDS, text

    if kind not in KINDS:
        raise InputError(f"schema of {kind!r}: give {' or '.join(KINDS)}")
    print(text(kind), end="")
