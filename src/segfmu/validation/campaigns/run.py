"""Runs a campaign: what a folder does not have yet, on the workers of a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from importlib.util import find_spec
from pathlib import Path

from segfmu.errors import InputError
from segfmu.validation.campaigns.batches import batches, probabilities
from segfmu.validation.campaigns.campaign import Campaign, Run
from segfmu.validation.campaigns.rare import require_package
from segfmu.validation.campaigns.result import CampaignResult, load_result
from segfmu.validation.campaigns.store import FLUSH, Store, alone, write_probabilities
from segfmu.validation.campaigns.worker import Order, Outcome

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
        Called with the number of runs that are there, and of all runs; of a search that is the
        greatest number that it can have.

    Raises
    ------
    InputError
        For a folder that is in use, has another campaign or cannot be
        written, and a scheduler that does not answer.
    SimulationError
        If there are no more workers. What was made is kept, here as in all other cases.
    """
    require_packages()
    if campaign.rare:
        require_package()
    from segfmu.validation.campaigns.cluster import cluster, stream

    with alone(folder), ExitStack() as stack:
        store = Store(folder, campaign)
        made, client = store.rows().num_rows, None
        progress(made, campaign.most)
        for batch in batches(campaign, store):
            # a campaign that is complete needs no workers
            client = client or stack.enter_context(cluster(scheduler, jobs))
            orders = (Order(r.number, r.scenario, campaign.changes(r)) for r in batch)
            outcomes = stream(
                client, campaign.source.scenarios, orders, len(batch), lambda: store.flush(FLUSH),
                campaign.source.file.timeout,
            )
            for count in _kept(store, batch, outcomes):
                made += count
                progress(made, campaign.most)
        if campaign.rare:
            write_probabilities(folder, probabilities(campaign, store))
        store.finish()
    return load_result(folder)


def _kept(
    store: Store, batch: Sequence[Run], outcomes: Iterator[list[Outcome]]
) -> Iterator[int]:
    """Keep runs as they come; yields how many."""
    runs = {run.number: run for run in batch}
    try:
        for some in outcomes:
            store.add((runs[outcome.number], outcome) for outcome in some)
            yield len(some)
    finally:
        store.flush()
