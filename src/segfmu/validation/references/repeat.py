"""Repeats the experiments in an FMU, and compares the results with those in it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from segfmu.cosim.alone import run_alone, units_of
from segfmu.errors import InputError, SegfmuError
from segfmu.validation.apart import Apart
from segfmu.validation.comparison import Excess, compare
from segfmu.validation.progress import Progress, quiet
from segfmu.validation.references.archive import Case, References, read_references


@dataclass(frozen=True, eq=False)
class Repetition:
    """An experiment that was repeated.

    Attributes
    ----------
    case : Case
    signals : int
        Those that were compared.
    outside : tuple of Excess
        Those that leave their tubes.
    left_out : tuple of str
        Those that were not compared: texts, and variables that are no outputs.
    error : str
        Why there is no result; empty if there is one.
    """

    case: Case
    signals: int = 0
    outside: tuple[Excess, ...] = ()
    left_out: tuple[str, ...] = ()
    error: str = ""

    @property
    def alike(self) -> bool:
        """Whether the FMU did what its references say, in something at least."""
        return self.signals > 0 and not self.outside and not self.error


def repeat(
    path: Path, *, tube_time: float = 0.0, tube_value: float | None = None,
    relative: bool = False, progress: Progress = quiet,
) -> tuple[References, list[Repetition]]:
    """Repeat all experiments of an FMU.

    Parameters
    ----------
    path : Path
        Co-simulation FMU of FMI 2.0 or 3.0 with references after FMI-LS-REF.
    tube_time, tube_value, relative
        As of `compare`.
    progress : callable
        Called with what is being done and the share of it that is done.

    Raises
    ------
    InputError
        For a file that has no references that can be repeated.
    """
    references = read_references(path)
    found: list[Repetition] = []
    with Apart(_repeating) as repeated:
        for case in references.cases:
            progress(f"repeating {case.name}", len(found) / len(references.cases))
            try:
                found.append(repeated(path, case, tube_time, tube_value, relative))
            except SegfmuError as error:
                found.append(Repetition(case, error=str(error)))
    return references, found


@contextmanager
def _repeating() -> Iterator[Callable[[Path, Case, float, float | None, bool], Repetition]]:
    yield _repeated


def _repeated(
    path: Path, case: Case, tube_time: float, tube_value: float | None, relative: bool
) -> Repetition:
    rows = run_alone(
        path, start_time=case.start, stop_time=case.stop, step=case.step, values=case.values,
        stimuli=case.stimuli, known=case.references.numbers,
    )
    names = rows.dtype.names or ()
    wrong = next((name for name in case.references.texts if name in names), None)
    if wrong is not None:
        raise InputError(f"the references of {wrong} are no numbers")
    reference = {n: v for n, v in case.references.numbers.items() if n in names}
    result = {n: rows[n].astype(float) for n in reference}
    times, own = reference["time"], result["time"]
    if own[0] <= times[0] and times[-1] <= own[-1]:
        # references may have fewer rows, between which they are not linear
        result = {n: np.interp(times, own, v) for n, v in result.items()}
    outside = compare(
        result, reference, tube_time=tube_time, tube_value=tube_value, relative=relative,
        units=units_of(path),
    )
    left_out = [n for n in case.references.numbers if n not in names]
    return Repetition(
        case, len(reference) - 1, tuple(outside), (*left_out, *case.references.texts)
    )
