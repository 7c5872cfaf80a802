"""What no run of a campaign could do is refused before the first one.

Where further FMUs take part, in a process of its own: one that ends its process ends that one
alone, and the runs tell which of them do.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial

from segfmu.cosim.messages import on_stderr
from segfmu.errors import InputError
from segfmu.validation.apart import Apart, Ended
from segfmu.validation.campaigns.campaign import Campaign
from segfmu.validation.campaigns.factors import changes, told
from segfmu.validation.campaigns.sampling import levels
from segfmu.validation.campaigns.worker import within
from segfmu.validation.files.scenario_file import build_scenario
from segfmu.validation.suite import Runner


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
    with on_stderr():
        if not any(build_scenario(source).file.fmus for source in campaign.source.scenarios):
            check_names(campaign)
            return
        with Apart(_checking) as check, suppress(Ended):
            check(campaign)


@contextmanager
def _checking() -> Iterator[Callable[[Campaign], None]]:
    yield check_names


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
                            f"{campaign.source.path}: {told(factor, value)}: {error}"
                        ) from None
