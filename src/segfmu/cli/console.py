"""What all commands print with, and arguments that they share."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

if TYPE_CHECKING:
    from segfmu.validation.documents.document import Document

# a width of 0 is one that nobody knows; Rich would print nothing
if not os.environ.get("COLUMNS", "80").strip("0"):
    del os.environ["COLUMNS"]
console = Console()

MissionFile = Annotated[Path, typer.Argument(help="Mission file (TOML); see models/ for examples.")]

AsJson = Annotated[
    bool,
    typer.Option(
        "--json", help="Print one JSON document and nothing else; `segfmu schema` describes it."
    ),
]


def print_document(document: Document) -> None:
    """One JSON document on standard output."""
    from segfmu.validation.documents.document import text

    print(text(document), end="", flush=True)


def tell(line: str) -> None:
    """One line on standard output, as it is; none if it is empty."""
    if line:
        console.print(line, highlight=False, markup=False, soft_wrap=True)
