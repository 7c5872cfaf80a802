"""Dask: the workers of this machine, or of a cluster, and the outcomes of runs as they come."""

from __future__ import annotations

import logging
import os
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from importlib.metadata import version
from math import ceil
from time import monotonic, sleep
from typing import TYPE_CHECKING, Any

from segfmu.errors import InputError, SimulationError
from segfmu.folders import work_folder
from segfmu.validation.campaigns import preload, worker
from segfmu.validation.campaigns.worker import Order, Outcome
from segfmu.validation.files.scenario_file import Source

if TYPE_CHECKING:
    from distributed import Client, Future, LocalCluster

# s; runs are handed out for so long at a time: a share takes as much of the processor as a run
SHARE = 1.0
MOST_SHARED = 128
# shares on their way to each worker's thread: one that runs and one that waits
AHEAD = 2
# of a future whose worker died with the result: it is made again
REPEATED = ("lost", "pending")
# bytes; what a worker keeps for its next run, and glibc's largest block that can be kept
KEPT_MEMORY, MOST_MAPPED = 1 << 26, 1 << 25
# s; for a scheduler to answer, and for a worker of a scheduler elsewhere to come
ANSWER, PATIENCE = 5.0, 30.0
CONFIGURATION = {
    # a worker that dies is begun anew, which takes long on a busy machine
    "distributed.deploy.lost-worker-timeout": "365 days",
    # what the dashboard would show of threads and loops takes a tenth of the processor
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "500ms",
    "distributed.admin.system-monitor.interval": "5s",
    # messages that are remembered: with orders and outcomes, some kB for each run
    "distributed.admin.low-level-log-length": 10,
    # glibc: the rows of a run stay with the process, where Dask's 64 kB has each run ask the system
    # for them anew, page by page
    "distributed.nanny.pre-spawn-environ.MALLOC_TRIM_THRESHOLD_": KEPT_MEMORY,
    "distributed.nanny.pre-spawn-environ.MALLOC_MMAP_THRESHOLD_": MOST_MAPPED,
}
# each process that is started runs the script that starts it, up to what is guarded
GUARD = (
    'in a script the call belongs below if __name__ == "__main__":, as each worker runs the rest '
    "of the script"
)
# of one that restarts a worker of this machine, however long that takes: it will not
GIVEN_UP = ("closing", "closed", "failed")


@contextmanager
def cluster(scheduler: str | None, jobs: int | None) -> Iterator[Client]:
    """A client of the scheduler at an address, or of so many workers of this machine.

    Raises
    ------
    InputError
        If the scheduler does not answer, has no workers, or these have another segfmu; if workers
        of this machine do not start.
    """
    from dask import config
    from distributed import Client

    with ExitStack() as stack:
        stack.enter_context(config.set(CONFIGURATION))
        if scheduler is None:
            target: Any = stack.enter_context(_local(jobs or os.cpu_count() or 1))
        else:
            target = scheduler
        try:
            client = stack.enter_context(Client(target, timeout=ANSWER))
        except (OSError, ValueError) as error:
            raise InputError(
                f"--scheduler {scheduler}: no Dask scheduler answers: {error}"
            ) from None
        _require_workers(client, scheduler)
        yield client
        with suppress(Exception):
            client.run(worker.release)


@contextmanager
def _local(jobs: int) -> Iterator[LocalCluster]:
    """So many workers of this machine."""
    from distributed import LocalCluster

    # of Dask's locks and of archives, also those of a worker that is killed
    with work_folder() as folder:
        try:
            found = LocalCluster(
                n_workers=jobs, threads_per_worker=1, memory_limit=0,
                dashboard_address="127.0.0.1:0", local_directory=str(folder),
                silence_logs=logging.CRITICAL, preload=preload.__name__,
            )
        except RuntimeError as error:
            told = str(error).rstrip(".")
            raise InputError(
                f"workers of this machine do not start ({told}); {GUARD}"
            ) from None
        with found:
            yield found


def _require_workers(client: Client, scheduler: str | None) -> None:
    where = f"--scheduler {scheduler}" if scheduler else "workers of this machine"
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
        versions = client.run(version, "segfmu")
    except TimeoutError:
        raise InputError(f"{where}: no worker came within {PATIENCE:g} s") from None
    except Exception as error:
        raise InputError(f"{where}: the workers cannot import segfmu: {error}") from None
    others = {v for v in versions.values() if v != version("segfmu")}
    if others:
        raise InputError(
            f"{where}: workers have segfmu {', '.join(sorted(others))}, this is "
            f"{version('segfmu')}"
        )


def stream(
    client: Client, sources: Sequence[Source], orders: Iterator[Order], count: int,
    idle: Callable[[], None] = lambda: None, timeout: float | None = None,
) -> Iterator[list[Outcome]]:
    """Have `count` orders performed; yields outcomes as they come.

    A run whose worker dies is repeated elsewhere; one at which worker after worker dies, also
    when nothing else runs, is an outcome with an error; so is one that takes longer than
    `timeout` [s], whose worker begins anew. `idle` is called at least every second.

    Raises
    ------
    SimulationError
        If there are no more workers.
    """
    from distributed import wait

    shares = _Shares(orders, count)
    running: dict[Future[tuple[list[Outcome], float]], list[Order]] = {}
    seen = monotonic()
    while shares.left or running:
        threads = sum(client.nthreads().values()) if client.status == "running" else 0
        while threads and (own := shares.next(threads, len(running))):
            # a campaign that is resumed asks for the same again
            future = client.submit(worker.perform, sources, own, timeout, pure=False)
            running[future] = own
        if threads or _restarts(client):
            seen = monotonic()
        elif monotonic() - seen > PATIENCE:
            raise SimulationError(
                f"no workers have been there for {PATIENCE:g} s; the same command goes on "
                "with what is missing"
            )
        idle()
        if not running:
            sleep(0.1)
            continue
        try:
            done = wait(list(running), timeout=1.0, return_when="FIRST_COMPLETED").done
        except TimeoutError:
            continue
        for future in done:
            if future.status in REPEATED:
                continue
            yield _outcomes(client, future, running.pop(future), shares)


def _restarts(client: Client) -> bool:
    """Whether a worker of this machine is or will be made again after its end."""
    own = getattr(client.cluster, "workers", {})
    return any(nanny.status.name not in GIVEN_UP for nanny in own.values())


def _outcomes(
    client: Client, future: Future[tuple[list[Outcome], float]], own: list[Order], shares: _Shares
) -> list[Outcome]:
    from distributed import KilledWorker

    if future.status == "finished":
        outcomes, seconds = future.result()
        if outcomes[-1].hung:
            _restart(client, future)
            shares.again(own[len(outcomes):])
        else:
            shares.learn(seconds / len(outcomes))
        return list(outcomes)
    error = future.exception() if future.status == "error" else None
    if not isinstance(error, KilledWorker):
        raise SimulationError(
            f"the Dask scheduler gave up a run: {error or future.status}; the same command goes on "
            "with what is missing"
        )
    if not shares.alone(own):
        # Dask suspects all that a worker has when it dies, also what waits behind the culprit
        shares.again(own)
        return []
    return [Outcome(own[0].number, error="the process that made this run died, again and again")]


def _restart(client: Client, future: Future[Any]) -> None:
    """End the process in which a run hangs; without a nanny it goes on beside the others."""
    with suppress(Exception):
        client.restart_workers(client.who_has([future])[future.key], timeout=ANSWER)


class _Shares:
    """Orders, handed out in shares that take a worker about as long as `SHARE`; suspects last."""

    def __init__(self, orders: Iterator[Order], count: int) -> None:
        self._orders, self._count = orders, count
        self._suspects: deque[Order] = deque()
        self._tried: set[int] = set()
        self._size = 1

    @property
    def left(self) -> bool:
        return bool(self._count or self._suspects)

    def next(self, threads: int, running: int) -> list[Order]:
        """What is handed out beside so many shares that run; nothing if they are enough."""
        if not self._count:
            return [self._suspect()] if self._suspects and not running else []
        if running >= AHEAD * threads:
            return []
        # smaller ones at the end, so that all workers end at a time
        size = min(self._size, ceil(self._count / (AHEAD * threads)))
        self._count -= size
        return [next(self._orders) for _ in range(size)]

    def _suspect(self) -> Order:
        order = self._suspects.popleft()
        self._tried.add(order.number)
        return order

    def alone(self, own: list[Order]) -> bool:
        """Whether nothing else ran beside these."""
        return own[0].number in self._tried

    def learn(self, seconds: float) -> None:
        """Take the time of a run into account; the first ones also load FMUs."""
        most = min(MOST_SHARED, 4 * self._size)
        self._size = max(1, min(most, round(SHARE / max(seconds, 1e-6))))

    def again(self, own: list[Order]) -> None:
        """Hand out these orders one at a time, when nothing else is left or runs."""
        self._suspects.extend(own)
