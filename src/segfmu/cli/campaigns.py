"""The command for campaigns."""

from __future__ import annotations

from typing import Annotated

import typer
from rich.progress import Progress

from segfmu.cli.console import MissionFile, console, tell
from segfmu.validation.files.mission import load_mission
from segfmu.validation.output import about, folder
from segfmu.validation.planned import planned, require_memory


def campaign(
    mission: MissionFile,
    output: Annotated[
        str,
        typer.Option("--output", "-o", metavar="FOLDER", help="Folder for tables and maps (PNG)."),
    ] = "out",
    jobs: Annotated[int, typer.Option(help="Number of processes.", min=1, max=64)] = 1,
    coarse: Annotated[bool, typer.Option("--coarse", help="Maps with few points.")] = False,
) -> None:
    """Compare six control methods under every disturbance; map move times and eigenvalues."""
    with about(mission):
        task = load_mission(mission)
        trajectory = planned(task)
        require_memory(task, trajectory)
    from segfmu.validation.campaign import run_campaign
    from segfmu.validation.campaign_files import write_maps, write_tables
    from segfmu.validation.campaign_report import outcome_table, verdict_table
    from segfmu.validation.methods import MODES
    from segfmu.validation.verdict import compare

    target = folder(output)
    with Progress(console=console, transient=True) as progress:
        bar = progress.add_task("disturbances and methods", total=1.0)
        outcomes = run_campaign(
            task, jobs=jobs, progress=lambda share: progress.update(bar, completed=share)
        )
    comparisons = compare(outcomes)
    write_tables(target, task.name, outcomes, comparisons)
    with console.status("mapping move times and eigenvalues"):
        write_maps(target, task, trajectory, coarse)
    for mode in MODES:
        console.print(outcome_table(mode, outcomes))
    console.print(verdict_table(comparisons))
    tell(f"tables (CSV, JSON) and maps (CSV, PNG) are in {target}")
    for missed in (c for c in comparisons if not c.reached):
        tell(f"missed: {missed}")
    if not all(c.reached for c in comparisons):
        raise typer.Exit(1)
