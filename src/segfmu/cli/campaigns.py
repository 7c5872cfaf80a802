"""The command for campaigns."""

from __future__ import annotations

from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING, Annotated

import typer
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    Task,
    TextColumn,
    TimeRemainingColumn,
)
from rich.text import Text

from segfmu.cli.console import console, tell
from segfmu.cli.work import warn_unproved
from segfmu.validation.output import (
    folder,
    require_apart,
    require_file,
    require_folder,
    require_kept,
    require_there,
)

if TYPE_CHECKING:
    from segfmu.validation.campaigns.campaign import Campaign
    from segfmu.validation.campaigns.result import CampaignResult

# errors of runs that are listed
MOST_SHOWN = 5
REPORT = "report.html"


def campaign(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="Campaign file (TOML).")],
    output: Annotated[
        str,
        typer.Option("--output", "-o", metavar="FOLDER", help="For the table of runs."),
    ] = "out",
    jobs: Annotated[
        int | None, typer.Option(help="Number of processes; default: all cores.", min=1, max=1024)
    ] = None,
    scheduler: Annotated[
        str | None, typer.Option(metavar="ADDRESS", help="Of a Dask scheduler, whose workers run.")
    ] = None,
    replay: Annotated[
        int | None,
        typer.Option(metavar="N", help="Only write run N as a scenario file.", min=0),
    ] = None,
    junit: Annotated[
        Path | None, typer.Option("--junit", metavar="FILE", help="JUnit XML of all criteria.")
    ] = None,
    against: Annotated[
        Path | None,
        typer.Option(metavar="FOLDER", help="Of a campaign with the same draws, to compare with."),
    ] = None,
) -> None:
    """Run scenarios many times with factors that differ; show the worst case of every criterion.

    What the folder already has of the same campaign is not run again. The exit code is 0 if every
    run passes.
    """
    from segfmu.validation.campaigns.campaign import load_campaign
    from segfmu.validation.campaigns.junit import write_junit
    from segfmu.validation.campaigns.replay import find_run, write_run
    from segfmu.validation.campaigns.result import load_result
    from segfmu.validation.campaigns.run import require_packages
    from segfmu.validation.campaigns.store import CAMPAIGN_FILES
    from segfmu.validation.files.scenario_file import files_of
    from segfmu.validation.texts import require_utf8

    require_packages()
    if replay is None:
        require_folder(output, *CAMPAIGN_FILES, REPORT)
    require_utf8(Path(output))
    if junit is not None:
        require_file(junit)
        require_apart(junit, output, *CAMPAIGN_FILES, REPORT)
        require_kept([file], [junit])
    task = load_campaign(file)
    if junit is not None:
        for own in task.source.scenarios:
            require_kept(files_of(own), [junit])
    # before the runs, which may take hours
    other = None if against is None else load_result(against)
    if replay is not None:
        run = find_run(Path(output), task, replay)
        _tell_replay(write_run(folder(output), task, run))
        return
    result = _run(task, output, scheduler, jobs)
    _show(task, result)
    if junit is not None:
        write_junit(junit, result)
    if other is not None:
        for difference in result.against(other):
            tell(str(difference))
    if not result.passed:
        raise typer.Exit(1)


def _run(
    task: Campaign, output: str, scheduler: str | None, jobs: int | None
) -> CampaignResult:
    from segfmu.validation.campaigns.names import require_names
    from segfmu.validation.campaigns.run import run_campaign

    with console.status("checking names"):
        require_names(task)
    columns = (
        TextColumn("runs"), BarColumn(), MofNCompleteColumn(), _Rate(), TimeRemainingColumn(),
    )
    with Progress(*columns, console=console, transient=True) as progress:
        bar = progress.add_task("runs", total=task.most)
        there: list[int] = []

        def show(done: int, count: int) -> None:
            # the first call tells what an earlier command has made
            if not there:
                there.append(done)
                if done:
                    most = "at most " if task.searched else ""
                    tell(f"{done} of {most}{count} runs were there")
            progress.update(bar, completed=done)

        return run_campaign(task, folder(output), scheduler=scheduler, jobs=jobs, progress=show)


def _show(task: Campaign, result: CampaignResult) -> None:
    from segfmu.validation.campaigns.call import write_worst
    from segfmu.validation.campaigns.store import CAMPAIGN_FILES
    from segfmu.validation.campaigns.summary_file import write_summary
    from segfmu.validation.campaigns.tables import criteria_table
    from segfmu.validation.suites import validate

    console.print(criteria_table(result))
    errors = result.errors
    for run, error in errors[:MOST_SHOWN]:
        tell(f"run {run}: {error}")
    if len(errors) > MOST_SHOWN:
        tell(f"and {len(errors) - MOST_SHOWN} more runs with an error")
    passed = sum(result.column("passed"))
    console.print(f"{passed} of {result.table.num_rows} runs passed", highlight=False)
    warn_unproved(result.requirements)
    write_summary(result)
    files = write_worst(task, result)
    with console.status("running the worst cases again"):
        worst = validate(files) if files else None
    report = result.report(result.folder / REPORT, worst)
    require_there((*(result.folder / name for name in CAMPAIGN_FILES), report, *files))
    worst_of = "; the worst of each criterion:" if files else ""
    tell(f"runs.parquet, results.json and report.html are in {result.folder}{worst_of}")
    for path in files:
        _tell_replay(path)
    tell(f"report: {report}")


def _tell_replay(path: Path) -> None:
    tell(f"segfmu validate {quote(str(path))}")


class _Rate(ProgressColumn):
    """Runs in a second."""

    def render(self, task: Task) -> Text:
        return Text("" if task.speed is None else f"{task.speed:.1f} runs/s")
