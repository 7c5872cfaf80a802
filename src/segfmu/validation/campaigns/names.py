"""What no run of a campaign could do is refused before the first one, in a process of its own.

An FMU that ends its process ends that one alone; the runs tell which of them do.
"""

from __future__ import annotations

import pickle
import signal
import subprocess
import sys
import tempfile
from contextlib import suppress
from functools import partial
from pathlib import Path

from segfmu.cosim.messages import on_stderr
from segfmu.errors import InputError
from segfmu.folders import work_folder
from segfmu.validation.campaigns.campaign import Campaign
from segfmu.validation.campaigns.factors import changes
from segfmu.validation.campaigns.sampling import levels
from segfmu.validation.campaigns.worker import within
from segfmu.validation.files.scenario_file import build_scenario
from segfmu.validation.suite import Runner

# in the folder of the process: what it checks, and the error that it found
TASK, FOUND = "task", "found"
# s; for the process to end its compilers when the command is stopped
PATIENCE = 5.0


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
    with work_folder() as folder:
        (folder / TASK).write_bytes(pickle.dumps(campaign))
        _perform(folder)
        if (folder / FOUND).exists():
            raise pickle.loads((folder / FOUND).read_bytes())


def _perform(folder: Path) -> None:
    """Have a process check what the folder has; a signal of the terminal does not reach it."""
    code = f"import sys; sys.path[:] = {sys.path!r}; from {__name__} import main; main()"
    process = subprocess.Popen(
        [sys.executable, "-c", code, str(folder)], start_new_session=True
    )
    try:
        process.wait()
    finally:
        process.terminate()
        with suppress(subprocess.TimeoutExpired):
            process.wait(PATIENCE)
        process.kill()
        process.wait()


def main() -> None:
    """Check the campaign in the folder of the command line, and write the error there."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    tempfile.tempdir = sys.argv[1]
    folder = Path(sys.argv[1])
    try:
        with on_stderr():
            check_names(pickle.loads((folder / TASK).read_bytes()))
    except Exception as error:
        written = folder / f"{FOUND}.part"
        written.write_bytes(pickle.dumps(error))
        written.rename(folder / FOUND)


def check_names(campaign: Campaign) -> None:
    """The same in this process, which an FMU can end; raises as `require_names`."""
    with Runner() as runner:
        for source in campaign.source.scenarios:
            timeout = campaign.source.file.timeout
            if within(timeout, partial(runner.run, build_scenario(source))) is None:
                raise InputError(
                    f"{campaign.source.path}: timeout: {source.path} as it is does not end within "
                    f"{timeout:g} s; the time to build its FMUs is a part of this"
                )
            for factor in campaign.factors:
                for value in levels(factor, 2):
                    own = changes(source, [factor], {factor.name: value})
                    try:
                        runner.check(build_scenario(source, own))
                    except InputError as error:
                        raise InputError(
                            f"{campaign.source.path}: factor {factor.name} = {value}: {error}"
                        ) from None
