"""Two FMUs, co-simulated once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.change import Change
from segfmu.cosim.points import communication_points
from segfmu.cosim.schedule import Coupling
from segfmu.cosim.system import Engine, System


def simulate(
    source: Path,
    sink: Path,
    *,
    stop_time: float,
    step: float,
    start_time: float = 0.0,
    source_values: Mapping[str, Any] | None = None,
    sink_values: Mapping[str, Any] | None = None,
    changes: Iterable[Change] = (),
    coupling: Coupling | None = None,
    events: bool = True,
    engine: Engine = "auto",
    progress: Callable[[float], None] = lambda _: None,
) -> NDArray[np.void]:
    """Co-simulate two FMUs once; `System` keeps them for many runs, and takes any number.

    Parameters
    ----------
    source, sink : Path
        Co-simulation FMUs of FMI 2.0 or 3.0. Outputs of the source are connected to inputs of the
        sink with the same name.
    stop_time, step, start_time : float
        [s]; the last step is shorter if the step does not divide the time.
    source_values, sink_values : mapping of str to number or str
        Parameters, start values and constant inputs; enumerations by the name of an item; arrays
        of FMI 3.0 after their sizes.
    changes : iterable of Change
        New values during the run; FMUs are called as the names of their models.
    coupling, events, engine
        As of `System`.
    progress : callable
        Called with the share done from time to time.

    Returns
    -------
    ndarray, structured, shape (steps + 1,)
        "time" and all outputs of both FMUs; row i belongs to time start_time + i * step.

    Raises
    ------
    InputError
        For invalid values and files.
    SimulationError
        If an FMU reports an error, with its message.
    """
    # refused before the FMUs are loaded
    communication_points(start_time, stop_time, step)
    with System(
        [source, sink], step=step, coupling=coupling, events=events, engine=engine
    ) as system:
        first, second = system.names
        return system.run(
            {first: source_values or {}, second: sink_values or {}}, start_time=start_time,
            stop_time=stop_time, changes=changes, progress=progress,
        )
