"""Commands that help to write files."""

from __future__ import annotations

import json
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
        str,
        typer.Argument(
            metavar="[mission|crane|scenario|campaign|plan|simulate|validate]",
            help="Kind of file, or command whose --json it describes.",
        ),
    ] = "mission",
) -> None:
    """Print a JSON schema: of a kind of file, for editors, or of what a command prints as JSON."""
    from segfmu.validation.documents.schema import DOCUMENTS, document_schema
    from segfmu.validation.files.schema import KINDS, file_schema

    if kind not in (*KINDS, *DOCUMENTS):
        raise InputError(f"schema of {kind!r}: give {' or '.join((*KINDS, *DOCUMENTS))}")
    found = file_schema(kind) if kind in KINDS else document_schema(kind)
    print(json.dumps(found, indent=2, ensure_ascii=False))
