"""Runs a campaign: what a folder does not have yet, on the workers of a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

from segfmu.errors import InputError
from segfmu.validation.campaigns.campaign import Campaign
from segfmu.validation.campaigns.factors import changes
from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.sampling import levels
from segfmu.validation.campaigns.worker import Order
from segfmu.validation.files.scenario_file import build_scenario
from segfmu.validation.suite import Runner

PACKAGES = ("dask", "distributed", "pyarrow")

# runs that are there, runs of the campaign
Progress = Callable[[int, int], None]


def require_packages() -> None:
    """Refuse to begin without the packages of the extra.

    Raises
    ------
    InputError
        That names those that are missing.
    """
    missing = [name for name in PACKAGES if find_spec(name) is None]
    if missing:
        raise InputError(
            f"campaigns need {', '.join(missing)}: pip install 'segfmu[campaign]' installs "
            "everything that they need"
        )


def run_campaign(
    campaign: Campaign, folder: Path, *, scheduler: str | None = None, jobs: int | None = None,
    progress: Progress = lambda done, count: None,
) -> CampaignResult:
    """Make all runs that the folder does not have yet, and their table.

    In a script it belongs below `if __name__ == "__main__":`, as all that starts processes.

    Parameters
    ----------
    campaign : Campaign
    folder : Path
        It exists. Results of the same campaign in it are kept.
    scheduler : str, optional
        Address of a Dask scheduler; by default workers of this machine.
    jobs : int, optional
        Number of these workers; by default that of the cores.
    progress : callable
        Called with the number of runs that are there, and of all runs.

    Raises
    ------
    InputError
        For a folder that is in use, has another campaign or cannot be
        written, and a scheduler that does not answer.
    SimulationError
        If there are no more workers. What was made is kept, here as in all other cases.
    """
    require_packages()
    from segfmu.validation.campaigns.cluster import cluster, stream
    from segfmu.validation.campaigns.store import FLUSH, Store, alone

    with alone(folder):
        store = Store(folder, campaign)
        done, count = store.done, len(campaign.runs)
        left = [run for run in campaign.runs if run.number not in done]
        made = count - len(left)
        progress(made, count)
        if left:
            def idle() -> None:
                store.flush(FLUSH)

            orders = (Order(r.number, r.scenario, campaign.changes(r)) for r in left)
            with cluster(scheduler, jobs) as client:
                try:
                    for outcomes in stream(
                        client, campaign.source.scenarios, orders, len(left), idle
                    ):
                        store.add(outcomes)
                        made += len(outcomes)
                        progress(made, count)
                finally:
                    store.flush()
        table = store.finish()
    file = campaign.source.file
    return CampaignResult(
        file.name, folder, tuple(f.name for f in campaign.factors), campaign.criteria, table,
        campaign.draws,
    )


def require_names(campaign: Campaign) -> None:
    """Refuse what no run could do: names and values that FMUs and criteria do not have.

    It builds the FMUs and runs each scenario once.

    Raises
    ------
    InputError
        For the first one.
    BuildError
        If the FMUs cannot be built.
    """
    with Runner() as runner:
        for source in campaign.source.scenarios:
            runner.run(build_scenario(source))
            for factor in campaign.factors:
                for value in levels(factor, 2):
                    own = changes(source, [factor], {factor.name: value})
                    try:
                        runner.check(build_scenario(source, own))
                    except InputError as error:
                        raise InputError(
                            f"{campaign.source.path}: factor {factor.name} = {value}: {error}"
                        ) from None
