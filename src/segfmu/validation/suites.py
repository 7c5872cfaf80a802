"""`segfmu.validate`: scenarios as co-simulations, and their results as one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape
from math import nan
from pathlib import Path
from typing import TYPE_CHECKING, Any

from segfmu.arrays import as_tuple, require_callable, shown
from segfmu.errors import InputError
from segfmu.validation.files.scenario_file import Scenario, find, load_scenario
from segfmu.validation.frames import frame
from segfmu.validation.monitor import Finding
from segfmu.validation.progress import Progress, quiet
from segfmu.validation.scenario_result import Result
from segfmu.validation.suite_runs import Runs

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

# of a scenario without a run
ABSENT = {"kind": "run", "signal": "", "unit": "", "passed": False}
Scenarios = str | Path | Scenario | Sequence[str | Path | Scenario]


@dataclass(frozen=True, eq=False, repr=False)
class Suite:
    """Scenarios that were run; iterates over their results.

    Attributes
    ----------
    results : tuple of Result
        One for each scenario: `rows`, `findings`, `passed`, `right`, `error`.
    """

    results: tuple[Result, ...]

    @property
    def passed(self) -> bool:
        """Whether every scenario passed, or failed as its file expects."""
        return all(result.right for result in self.results)

    def __iter__(self) -> Iterator[Result]:
        return iter(self.results)

    def __len__(self) -> int:
        return len(self.results)

    def __repr__(self) -> str:
        right = sum(result.right for result in self.results)
        return f"<Suite: {right} of {len(self)} scenarios as expected>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{escape(result.scenario.file.name)}</td>"
            f"<td>{'passed' if result.passed else 'failed'}"
            f"{', as expected' if result.right and not result.passed else ''}</td></tr>"
            for result in self.results
        )
        return f"<p>{escape(repr(self).strip('<>'))}</p><table>{rows}</table>"

    def to_pandas(self) -> pandas.DataFrame:
        """A row for every criterion: scenario, bound, margin, unit, margin over bound, verdict.

        A scenario without a run has one row, with its error.

        Raises
        ------
        InputError
            If pandas is not installed.
        """
        entries: list[tuple[Result, Finding | None]] = []
        for result in self.results:
            entries += [(result, finding) for finding in result.findings or (None,)]
        names = ("kind", "signal", "bound", "margin", "unit", "normalised", "passed")
        return frame({
            "scenario": [result.scenario.file.name for result, _ in entries],
            "criterion": [finding.name if finding else "run" for _, finding in entries],
            **{n: [getattr(f, n) if f else ABSENT.get(n, nan) for _, f in entries] for n in names},
            "error": [result.error for result, _ in entries],
        })

    def report(self, path: str | Path) -> Path:
        """Write all results as one HTML file that opens without a network; returns its path."""
        from segfmu.validation.report import suite_page, write

        return write(path, suite_page(self))

    def plot(self) -> Figure:
        """The margins of all criteria, as shares of their bounds, as a figure of Matplotlib."""
        from segfmu.validation.suite_plots import plot_margins

        return plot_margins(self.results)


def validate(scenarios: Scenarios, *, progress: Progress = quiet) -> Suite:
    """Run scenarios as co-simulations of both FMUs and judge them by their criteria.

    Parameters
    ----------
    scenarios : path, Scenario, or sequence of them
        Scenario files, or folders of them.
    progress : callable
        Called with what is being done and the share of it that is done.

    Returns
    -------
    Suite

    Raises
    ------
    InputError
        For files that are no scenarios, and values that the FMUs do not take.
    BuildError
        If the FMUs cannot be built.

    Examples
    --------
    >>> import segfmu
    >>> suite = segfmu.validate("scenario.toml")
    >>> suite
    <Suite: 1 of 1 scenarios as expected>
    """
    require_callable("progress", progress)
    single = isinstance(scenarios, str | Path | Scenario)
    given: tuple[Any, ...] = (scenarios,) if single else as_tuple("scenarios", scenarios)
    for entry in given:
        if not isinstance(entry, str | Path | Scenario):
            raise InputError(f"scenarios must be files or folders, got {shown(entry)}")
    if not given:
        raise InputError("no scenarios; name files or folders of them")
    loaded = [entry for entry in given if isinstance(entry, Scenario)]
    paths = [Path(entry) for entry in given if not isinstance(entry, Scenario)]
    loaded += [load_scenario(path) for path in find(paths)]
    results = []
    with Runs() as runs:
        for i, scenario in enumerate(loaded):
            progress("running scenarios", i / len(loaded))
            results.append(runs.run(scenario))
    return Suite(tuple(results))
