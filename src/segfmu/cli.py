"""The command line: plan, build, simulate, campaign."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import Progress

from segfmu.crane import FlatInverse
from segfmu.errors import BuildError, InputError, SegfmuError
from segfmu.planning import Trajectory
from segfmu.planning.verify import verify
from segfmu.validation.mission import Mission, load_mission

if TYPE_CHECKING:
    from segfmu.fmu.choice import Choice
    from segfmu.fmu.standard.spec import Spec

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    rich_markup_mode="markdown",
    help="Plan a crane load's motion, build the FMUs, co-simulate and judge them.\n\n"
    "Exit codes: 0 success, 1 infeasible plan or failed verdict, 2 invalid input.",
)
console = Console()

MissionFile = Annotated[Path, typer.Argument(help="Mission file (TOML); see models/ for examples.")]


def _show_version(wanted: bool) -> None:
    if wanted:
        console.print(f"segfmu {version('segfmu')}", highlight=False)
        raise typer.Exit


@app.callback()
def _options(
    show_version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_show_version, is_eager=True, help="Show the version and exit."
        ),
    ] = False,
) -> None:
    pass


@app.command(epilog="Example: segfmu plan models/paper.toml --output out")
def plan(
    mission: MissionFile,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder for plan.csv and plots.")
    ] = None,
) -> None:
    """Plan a mission and show every peak against its limit."""
    task = load_mission(mission)
    trajectory = _planned(task)
    if output is not None:
        _require_steps(task, trajectory)
    from segfmu.validation.report import plan_table

    console.print(plan_table(task.name, trajectory, verify(trajectory)))
    if output is not None:
        _write_plan(task, trajectory, output)


@app.command(epilog="Example: segfmu build models/paper.toml --output fmus/dist --fmi 3")
def build(
    mission: Annotated[
        Path | None,
        typer.Argument(help="Mission file (TOML) with the FMUs' start values."),
    ] = None,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for the two archives.")
    ] = Path("fmus/dist"),
    fmi: Annotated[int, typer.Option(help="Version of the standard, 2 or 3.")] = 2,
    backend: Annotated[
        str, typer.Option(help="native: C, with sources; python: needs segfmu at run time.")
    ] = "native",
    platforms: Annotated[
        str, typer.Option(help="Of native binaries: all, or names with commas; default: available.")
    ] = "",
    waypoints: Annotated[
        int | None,
        typer.Option(help="Maximum number of waypoints; default: 16, or that of the mission.",
                     min=2, max=256),
    ] = None,
    enumerations: Annotated[
        str, typer.Option(help="Type of choices: enumeration, or integer for importers without.")
    ] = "enumeration",
    modelica: Annotated[
        bool, typer.Option("--modelica", help="Also write a Modelica package with both FMUs.")
    ] = False,
    ssp: Annotated[
        bool, typer.Option("--ssp", help="Also write mission.ssp and OspSystemStructure.xml.")
    ] = False,
) -> None:
    """Build GantryFeedforward.fmu and GantryCrane.fmu.

    Native FMUs support co-simulation and model exchange; those of the Python backend support FMI
    2.0 co-simulation.
    """
    from segfmu.fmu.build import describe
    from segfmu.fmu.choice import chosen, require_native
    from segfmu.validation.scenario import sized, specs

    choice = chosen(fmi, backend, platforms, enumerations=enumerations)
    for option, wanted in (("--modelica", modelica), ("--ssp", ssp)):
        if wanted:
            require_native(choice, option)
    if mission is None:
        title, interfaces = "", sized(waypoints)
    else:
        task = load_mission(mission)
        title, interfaces = task.name, specs(task, _planned(task), waypoints)
    paths = _built(output, choice, interfaces)
    for path in paths:
        console.print(f"{path}  {path.stat().st_size / 1024:.0f} KiB", highlight=False)
    for path in describe(output, paths, interfaces, title, modelica=modelica, ssp=ssp):
        console.print(f"{path}", highlight=False)


@app.command(epilog="Example: segfmu simulate models/paper.toml --output out")
def simulate(
    mission: MissionFile,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for FMUs, run.csv and plots.")
    ] = Path("out"),
    step: Annotated[
        float | None, typer.Option(help="Communication step [s]; default: the mission's.")
    ] = None,
) -> None:
    """Build the FMUs, co-simulate a mission, write and judge the results."""
    task = load_mission(mission)
    if step is not None:
        if not 0.0 < step <= 0.1:
            raise InputError(f"--step must be above 0 and at most 0.1 s, got {step}")
        simulation = task.simulation.model_copy(update={"step": step})
        task = task.model_copy(update={"simulation": simulation})
    trajectory = _planned(task)
    _require_steps(task, trajectory)
    from segfmu.cosim import write_csv
    from segfmu.fmu.choice import chosen
    from segfmu.validation.criteria import judge
    from segfmu.validation.plots import plot_run, save
    from segfmu.validation.report import run_table
    from segfmu.validation.scenario import specs

    choice = chosen(2, "native", "", everywhere=False)
    feedforward, crane = _built(output, choice, specs(task, trajectory))
    rows = _run(task, trajectory, feedforward, crane)
    write_csv(output / "run.csv", rows)
    save(plot_run(rows, trajectory.waypoint_times, task.name), output / "run.png")
    limits = task.simulation
    found = judge(rows, trajectory.duration, limits.tracking_tolerance, limits.sway_tolerance)
    console.print(run_table(task.name, found))
    console.print(f"FMUs, run.csv and run.png are in {output}", highlight=False)
    if not found.passed:
        raise typer.Exit(1)


@app.command(epilog="Example: segfmu paper --output out")
def paper(
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for figures, mission and run.csv.")
    ] = Path("out"),
) -> None:
    """Plan and co-simulate the paper's mission; draw its figures 3, 6 and 7."""
    from segfmu.fmu.choice import chosen
    from segfmu.validation.paper import MISSION, write_figures
    from segfmu.validation.scenario import specs

    task = load_mission(MISSION)
    trajectory = _planned(task)
    choice = chosen(2, "native", "", everywhere=False)
    rows = _run(task, trajectory, *_built(output, choice, specs(task, trajectory)))
    for path, what in write_figures(output, trajectory, rows):
        console.print(f"{path}  {what}", highlight=False)


@app.command(epilog="Example: segfmu campaign models/inteco.toml --output out")
def campaign(
    mission: MissionFile,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for tables (CSV, JSON) and maps (PNG).")
    ] = Path("out"),
    jobs: Annotated[int, typer.Option(help="Number of processes.", min=1, max=64)] = 1,
    coarse: Annotated[bool, typer.Option("--coarse", help="Maps with few points.")] = False,
) -> None:
    """Compare six control methods under every disturbance; map move times and eigenvalues."""
    task = load_mission(mission)
    trajectory = _planned(task)
    _require_steps(task, trajectory)
    from segfmu.validation.campaign import run_campaign
    from segfmu.validation.campaign_files import require_folder, write_maps, write_tables
    from segfmu.validation.campaign_report import outcome_table, verdict_table
    from segfmu.validation.methods import MODES
    from segfmu.validation.verdict import compare

    require_folder(output)
    with Progress(console=console, transient=True) as progress:
        bar = progress.add_task("disturbances and methods", total=1.0)
        outcomes = run_campaign(
            task, jobs=jobs, progress=lambda share: progress.update(bar, completed=share)
        )
    comparisons = compare(outcomes)
    write_tables(output, task.name, outcomes, comparisons)
    with console.status("mapping move times and eigenvalues"):
        write_maps(output, task, trajectory, coarse)
    for mode in MODES:
        console.print(outcome_table(mode, outcomes))
    console.print(verdict_table(comparisons))
    console.print(f"tables (CSV, JSON) and maps (CSV, PNG) are in {output}", highlight=False)
    if not all(c.reached for c in comparisons):
        raise typer.Exit(1)


def _planned(task: Mission) -> Trajectory:
    """Plan, and check by the flat inverse that the crane can follow."""
    trajectory = task.plan()
    FlatInverse(task.build_crane(), trajectory)
    return trajectory


def _require_steps(task: Mission, trajectory: Trajectory) -> None:
    """Refuse missions whose results would not fit in memory."""
    from segfmu.cosim import require_steps

    settings = task.simulation
    try:
        require_steps(trajectory.duration + settings.settle, settings.step)
    except InputError as error:
        raise InputError(f"{task.name}: {error} (simulation.step, settle, dwell, limits)") from None


def _write_plan(task: Mission, trajectory: Trajectory, output: Path) -> None:
    from segfmu.cosim import write_csv
    from segfmu.validation.plots import plot_path, plot_plan, save

    write_csv(output / "plan.csv", _samples(task, trajectory))
    save(plot_plan(trajectory, task.name), output / "plan.png")
    save(plot_path(trajectory, task.name), output / "path.png")
    console.print(f"plan.csv, plan.png and path.png are in {output}", highlight=False)


def _samples(task: Mission, trajectory: Trajectory) -> NDArray[np.void]:
    """The plan and its feedforward at the mission's communication step."""
    times = np.append(
        np.arange(0.0, trajectory.duration, task.simulation.step), trajectory.duration
    )
    columns = {"time": times}
    for order, name in enumerate(("position", "velocity", "acceleration", "jerk", "snap")):
        for axis, values in zip("xyz", trajectory(times, order).T, strict=True):
            columns[f"reference.load.{name}.{axis}"] = values
    inverse = FlatInverse(task.build_crane(), trajectory)
    for kind, table in (("force", inverse.force(times)), ("velocity", inverse.velocity(times))):
        for drive, values in zip(("bridge", "trolley", "hoist"), table.T, strict=True):
            columns[f"{kind}.{drive}"] = values
    rows = np.zeros(times.size, dtype=[(n, np.float64) for n in columns])
    for name, values in columns.items():
        rows[name] = values
    return rows


def _built(folder: Path, choice: Choice, interfaces: Sequence[Spec]) -> list[Path]:
    """Build FMUs of both interfaces."""
    from segfmu.fmu.build import build_all

    if choice.note:
        print(f"segfmu: {choice.note}", file=sys.stderr)
    with console.status("building the FMUs") as status:
        return build_all(folder, choice, interfaces, report=status.update)


def _run(
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


@contextmanager
def _one_line_errors() -> Iterator[None]:
    """Print segfmu's errors as one line on stderr and set the exit code."""
    try:
        yield
    except SegfmuError as error:
        print(f"segfmu: {error}", file=sys.stderr)
        sys.exit(2 if isinstance(error, InputError | BuildError) else 1)
    except KeyboardInterrupt:
        print("segfmu: interrupted", file=sys.stderr)
        sys.exit(130)


def main() -> None:
    """Entry point of the command `segfmu`."""
    with _one_line_errors():
        app()
