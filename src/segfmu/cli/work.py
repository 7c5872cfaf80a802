"""Steps that commands share, with their progress on the screen."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from rich.progress import Progress

from segfmu.cli.console import console
from segfmu.crane import FlatInverse
from segfmu.errors import InputError
from segfmu.planning import Trajectory
from segfmu.validation.files.mission import Mission

if TYPE_CHECKING:
    from segfmu.fmu.choice import Choice
    from segfmu.fmu.standard.spec import Spec


def planned(task: Mission) -> Trajectory:
    """Plan, and check by the flat inverse that the crane can follow."""
    with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
        bar = progress.add_task("planning", total=1.0)
        trajectory = task.plan(lambda share: progress.update(bar, completed=share))
    FlatInverse(task.build_crane(), trajectory)
    return trajectory


def require_steps(task: Mission, trajectory: Trajectory) -> None:
    """Refuse missions whose results would not fit in memory."""
    from segfmu.cosim import require_steps

    settings = task.simulation
    try:
        require_steps(trajectory.duration + settings.settle, settings.step)
    except InputError as error:
        raise InputError(f"simulation.step: {error} (settle, dwell, limits)") from None


def built(folder: Path, choice: Choice, interfaces: Sequence[Spec]) -> list[Path]:
    """Build FMUs of both interfaces."""
    from segfmu.fmu.build import build_all

    if choice.note:
        print(f"segfmu: {choice.note}", file=sys.stderr)
    with console.status("building the FMUs") as status:
        return build_all(folder, choice, interfaces, report=status.update)


def co_simulated(
    task: Mission, trajectory: Trajectory, feedforward: Path, crane: Path
) -> NDArray[np.void]:
    from segfmu.cosim.messages import on_stderr
    from segfmu.validation.scenario import run

    with on_stderr(), Progress(console=console, transient=True) as progress:
        bar = progress.add_task("co-simulating", total=1.0)
        return run(
            task, feedforward, crane, trajectory,
            lambda share: progress.update(bar, completed=share),
        )
