"""The progress of commands on the screen."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

from segfmu.validation.progress import Progress as Progressed

if TYPE_CHECKING:
    from segfmu.validation.requirements import Requirement


@contextmanager
def watched() -> Iterator[Progressed]:
    """A bar on standard error that shows what is being done, for the `progress` of long calls."""
    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn())
    with Progress(
        *columns, console=console, transient=True, disable=not console.is_terminal
    ) as shown:
        bar = shown.add_task("", total=1.0)
        yield lambda what, share: shown.update(bar, description=what, completed=share)


def warn(note: str) -> None:
    """One line on stderr; none if it is empty."""
    if note:
        print(f"segfmu: {note}", file=sys.stderr)


def warn_unproved(requirements: Sequence[Requirement]) -> None:
    """A line on stderr for every requirement without evidence, which fails no scenario."""
    for one in requirements:
        if one.holds is None:
            warn(f"requirement {one.name}: {one.verdict}")
