"""What all commands print with, and arguments that they share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

console = Console()

MissionFile = Annotated[Path, typer.Argument(help="Mission file (TOML); see models/ for examples.")]


def tell(line: str) -> None:
    """One line on standard output, as it is; none if it is empty."""
    if line:
        console.print(line, highlight=False, markup=False, soft_wrap=True)
