"""`segfmu.simulate`: a mission as a co-simulation of both FMUs, and its result."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from difflib import get_close_matches
from html import escape
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray, finite_number, require_callable, shown
from segfmu.cosim import write_csv
from segfmu.crane import ActuatorBounds
from segfmu.errors import InputError
from segfmu.folders import work_folder
from segfmu.planning import Trajectory
from segfmu.validation.archives import for_simulation
from segfmu.validation.criteria import Criteria, judge
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.crane_models import require_gantry
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import Source, load_mission
from segfmu.validation.files.recording import load_recording
from segfmu.validation.frames import frame
from segfmu.validation.output import (
    about,
    file_path,
    folder,
    note,
    require_there,
    stride,
    thinned,
)
from segfmu.validation.planned import (
    planned,
    require_memory,
    unknown_wind,
)
from segfmu.validation.progress import Progress, quiet
from segfmu.validation.scenario import arrival, recorded, run
from segfmu.validation.sticking import sticking
from segfmu.validation.units import signal_units

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

LEAST_STEP, MOST_STEP = 1e-6, 0.1
Picture = Literal["run", "plan", "path", "drives"]


@dataclass(frozen=True, eq=False, repr=False)
class Run:
    """A mission that was co-simulated. `run["sway.x.angle"]` is one signal; iterates over names.

    Attributes
    ----------
    mission : Mission
    trajectory : Trajectory
        The plan.
    rows : structured array
        "time" and the variables of both FMUs, a row for every communication step; read-only.
    criteria : Criteria
        Measures of the run and what is allowed.
    notes : tuple of str
        What the user must know of the FMUs that were used and of the plan.
    commands : Path or None
        Recording of the operator's commands that were followed in place of the plan.
    again : str
        Command that runs it again; empty if its mission is that of no file.
    """

    mission: Mission
    trajectory: Trajectory
    rows: NDArray[np.void]
    criteria: Criteria
    notes: tuple[str, ...] = ()
    commands: Path | None = None
    again: str = ""

    @property
    def note(self) -> str:
        """All notes in one line; empty if there are none."""
        return "; ".join(self.notes)

    @property
    def passed(self) -> bool:
        """The verdict."""
        return self.criteria.passed

    @property
    def time(self) -> FloatArray:
        """Times of the rows [s]."""
        return self["time"]

    @property
    def signals(self) -> tuple[str, ...]:
        """Names of all variables."""
        return self.rows.dtype.names or ()

    def __iter__(self) -> Iterator[str]:
        return iter(self.signals)

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and name in self.signals

    def __getitem__(self, name: str) -> FloatArray:
        if name not in self:
            near = get_close_matches(str(name), self.signals, n=1)
            hint = f"did you mean {near[0]}?" if near else "run.signals has all names"
            raise InputError(f"no variable {shown(name)} in the run; {hint}")
        column: FloatArray = self.rows[name]
        return column

    def __repr__(self) -> str:
        measures = ", ".join(f"{row.name} {row.measured}" for row in self.criteria.rows[:2])
        verdict = "passed" if self.passed else "failed"
        return f"<Run of {self.mission.name!r}: {self.time[-1]:.3f} s, {measures}, {verdict}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{escape(row.name)}</td><td>{escape(str(row))}</td>"
            f"<td>{'passed' if row.passed else 'failed'}</td></tr>"
            for row in self.criteria.rows
        )
        return f"<p>{escape(repr(self).strip('<>'))}</p><table>{rows}</table>"

    def to_pandas(self) -> pandas.DataFrame:
        """All rows and variables; the index is the time [s].

        Raises
        ------
        InputError
            If pandas is not installed.
        """
        return frame({name: self.rows[name] for name in self.signals}, "time")

    def to_csv(self, path: str | Path) -> str:
        """Write all variables as CSV, thinned as `simulation.output_step` says.

        Returns
        -------
        str
            What the table leaves out; empty if nothing.
        """
        target = file_path(path)
        every = stride(self.mission, float(self.time[-1]))
        write_csv(target, thinned(self.rows, every), signal_units())
        return note(target.name, every, self.mission.simulation.step)

    def report(self, path: str | Path) -> Path:
        """Write the run as one HTML file that opens without a network; returns its path."""
        from segfmu.validation.report import run_page, write

        return write(path, run_page(self))

    def plot(self, what: Picture = "run") -> Figure:
        """A figure of Matplotlib; `figure.savefig` writes it.

        Parameters
        ----------
        what : str
            "run": drives, sway and error; "plan": the plan against its limits; "path":
            from above and from the side; "drives": what the plan asks of them.
        """
        from segfmu.validation.plots.drives import plot_drives
        from segfmu.validation.plots.path import plot_path
        from segfmu.validation.plots.plan import plot_plan
        from segfmu.validation.plots.run import plot_run

        if not isinstance(what, str) or what not in get_args(Picture):
            raise InputError(f"plot: must be run, plan, path or drives, got {shown(what)}")
        task, trajectory, name = self.mission, self.trajectory, self.mission.name
        crane, bounds = task.build_crane(), task.build_bounds() or ActuatorBounds()
        if what == "run":
            # under commands the load does not go to the waypoints
            times = trajectory.waypoint_times if self.commands is None else np.empty(0)
            # the weight on the rope is that of the load that was carried
            carried = crane_parameters.nominal(task.simulated)
            return plot_run(self.rows, times, name, carried, bounds)
        if what == "plan":
            return plot_plan(trajectory, name, self.mission.limits is not None)
        if what == "path":
            return plot_path(trajectory, name, task.build_clearance())
        return plot_drives(crane, trajectory, bounds, name, task.build_friction())


def simulate(
    mission: Source,
    *,
    step: float | None = None,
    commands: str | Path | None = None,
    output: str | Path | None = None,
    progress: Progress = quiet,
) -> Run:
    """Plan a mission, build the FMUs, co-simulate them and judge the run.

    Parameters
    ----------
    mission : path, mapping or Mission
        As of `load_mission`.
    step : float, optional
        Communication step [s]; by default the mission's.
    commands : path, optional
        Recording of an operator's commands, which the planner follows: a CSV file with a column
        time [s], and columns of variables of both FMUs, whose rows are held. The load is to be at
        rest after its last row.
    output : path, optional
        Folder that keeps the FMUs.
    progress : callable
        Called with what is being done and the share of it that is done.

    Returns
    -------
    Run

    Raises
    ------
    InputError
        For a mission that is not possible, and FMUs that others remove meanwhile.
    InfeasibleError
        If the mission cannot be planned.
    SimulationError
        If an FMU reports an error.

    Examples
    --------
    >>> import segfmu
    >>> run = segfmu.simulate("mission.toml")
    >>> run.passed
    True
    >>> bool(abs(run["sway.x.angle"]).max() < 0.2)
    True
    >>> run.plot().savefig("run.png")
    >>> run.report("report.html").name
    'report.html'
    """
    require_callable("progress", progress)
    if step is not None:
        step = finite_number("step", step)
        if not LEAST_STEP <= step <= MOST_STEP:
            raise InputError(f"step must be from {LEAST_STEP:g} to {MOST_STEP:g} s, got {step}")
    task = load_mission(mission)
    if step is not None:
        simulation = task.simulation.model_copy(update={"step": step})
        task = task.model_copy(update={"simulation": simulation})
    if not isinstance(commands, str | Path | None):
        raise InputError(f"commands must be the path of a file, got {shown(commands)}")
    recording = None if commands is None else load_recording(Path(commands))
    changes = []
    if recording is not None:
        with about(task.file):
            require_gantry(task.build_crane(), "commands")
        changes = recorded(task, recording)
    with about(task.file):
        trajectory = planned(task, progress)
        ends = arrival(task, trajectory, recording)
        require_memory(task, ends)
        stride(task, ends + task.simulation.settle)
    with ExitStack() as stack:
        place = stack.enter_context(work_folder()) if output is None else folder(output)
        archives = for_simulation(task, trajectory, place, progress)
        rows = run(
            task, archives.feedforward, archives.crane, trajectory, ends,
            lambda share: progress("co-simulating", share), changes,
        )
        require_there(archives)
    rows.flags.writeable = False
    if recording is not None:
        ends = max(ends, _rests(rows))
    settings = task.simulation
    found = judge(
        rows, ends, settings.tracking_tolerance, settings.sway_tolerance,
        task.build_bounds(),
    )
    notes = archives.note, sticking(task, trajectory), unknown_wind(task)
    return Run(
        task, trajectory, rows, found, tuple(filter(None, notes)),
        None if commands is None else Path(commands), _again(task, step, commands),
    )


def _again(task: Mission, step: float | None, commands: str | Path | None) -> str:
    if task.file is None or task.changed:
        return ""
    words = ["segfmu", "simulate", quote(str(task.file))]
    words += [] if step is None else ["--step", f"{step:.15g}"]
    words += [] if commands is None else ["--commands", quote(str(commands))]
    return " ".join(words)


def _rests(rows: NDArray[np.void]) -> float:
    """Time from which on nothing is planned any more [s]."""
    moving = np.flatnonzero(~rows["plan.done"].astype(bool))
    return float(rows["time"][min(moving[-1] + 1, rows.size - 1)]) if moving.size else 0.0
