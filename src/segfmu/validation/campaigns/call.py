"""`segfmu.campaign`: many runs of scenarios, and what they found."""

from __future__ import annotations

from multiprocessing import current_process
from pathlib import Path

from segfmu.arrays import as_index, require_callable, shown
from segfmu.errors import InputError
from segfmu.validation.campaigns.campaign import Campaign, load_campaign
from segfmu.validation.campaigns.names import require_names
from segfmu.validation.campaigns.replay import find_run, write_run
from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.run import require_packages, run_campaign
from segfmu.validation.campaigns.store import CAMPAIGN_FILES
from segfmu.validation.campaigns.summary_file import write_summary
from segfmu.validation.output import file_path, folder, require_folder
from segfmu.validation.progress import Progress, quiet
from segfmu.validation.texts import require_utf8


def campaign(
    file: str | Path, output: str | Path = "out", *, scheduler: str | None = None,
    jobs: int | None = None, progress: Progress = quiet,
) -> CampaignResult:
    """Run scenarios many times with factors that differ, as `segfmu campaign` does.

    Processes are started: in a script the call belongs below `if __name__ == "__main__":`.

    Parameters
    ----------
    file : path
        A campaign file.
    output : path
        Folder for the table of runs, `results.json` and the worst runs as scenario files. What it
        has of the same campaign is not run again.
    scheduler : str, optional
        Address of a Dask scheduler, whose workers run; by default processes of this machine.
    jobs : int, optional
        Number of these; by default that of the cores.
    progress : callable
        Called with what is being done and the share of it that is done.

    Returns
    -------
    CampaignResult

    Raises
    ------
    InputError
        For files that are wrong, a folder with another campaign, packages that are missing, and a
        script that is not guarded.
    BuildError
        If the FMUs cannot be built.

    Examples
    --------
    >>> import segfmu
    >>> found = segfmu.campaign("campaign.toml", "runs")  # doctest: +SKIP
    >>> found  # doctest: +SKIP
    <CampaignResult 'small': 4 of 4 runs passed>
    """
    require_callable("progress", progress)
    require_packages()
    _require_guard()
    if not isinstance(scheduler, str | None):
        raise InputError(f"scheduler must be an address, got {shown(scheduler)}")
    if jobs is not None:
        jobs = as_index("jobs", jobs, least=1)
    require_folder(output, *CAMPAIGN_FILES)
    require_utf8(Path(output))
    task = load_campaign(file_path(file))
    progress("checking names", 0.0)
    require_names(task)
    result = run_campaign(
        task, folder(output), scheduler=scheduler, jobs=jobs,
        progress=lambda done, count: progress("runs", done / max(count, 1)),
    )
    write_summary(result)
    write_worst(task, result)
    return result


def _require_guard() -> None:
    """Refuse a call of a process that is being started, before it does all again."""
    if getattr(current_process(), "_inheriting", False):
        from segfmu.validation.campaigns.cluster import GUARD

        raise InputError(f"a worker of a campaign came to the call that started it: {GUARD}")


def write_worst(task: Campaign, result: CampaignResult) -> list[Path]:
    """Write the worst run of each criterion as a scenario file; returns the files."""
    found = (find_run(result.folder, task, run) for run in result.worst_runs)
    return [write_run(result.folder, task, run) for run in found]
