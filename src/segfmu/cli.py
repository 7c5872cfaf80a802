"""The command line."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import Progress

from segfmu.crane import ActuatorBounds, FlatInverse, bound_uses
from segfmu.errors import BuildError, InputError, SegfmuError
from segfmu.planning import Trajectory, excursions
from segfmu.planning.verify import verify
from segfmu.validation import commands
from segfmu.validation.mission import Mission, load_mission
from segfmu.validation.output import about, folder, note, plan_samples, stride, thinned

if TYPE_CHECKING:
    from segfmu.fmu.choice import Choice
    from segfmu.fmu.standard.spec import Spec

app = typer.Typer(
    add_completion=False,
    rich_markup_mode="markdown",
    help="Plan a crane load's motion, build the FMUs, co-simulate and judge them.\n\n"
    "Exit codes: 0 success, 1 infeasible plan or failed verdict, 2 invalid input.",
)
console = Console()

# of options and arguments
USAGE_ERROR: type[Any] = typer.BadParameter.__mro__[1]
NO_BOUNDS = (
    "no bounds of the drives are known (velocity_max, acceleration_max, force_max, power_max of "
    "the crane file): the plan keeps the mission's limits alone"
)

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
        str | None,
        typer.Option("--output", "-o", metavar="FOLDER", help="Folder for plan.csv and plots."),
    ] = None,
) -> None:
    """Plan a mission and show every peak against its limit."""
    with about(mission):
        task = load_mission(mission)
        trajectory = _planned(task)
        every = stride(task, trajectory.duration)
    target = None if output is None else folder(output)
    from segfmu.validation.report import plan_table

    console.print(plan_table(task.name, trajectory, verify(trajectory)))
    _show_bounds(task, trajectory)
    for found in excursions(trajectory):
        _tell(str(found))
    if target is not None:
        _write_plan(task, trajectory, target, every)


@app.command(epilog="Example: segfmu init hall")
def init(
    output: Annotated[str, typer.Argument(metavar="FOLDER", help="Where to write them.")] = ".",
) -> None:
    """Write a commented mission and crane file to begin with; existing files are kept."""
    from segfmu.validation.template import write

    target = folder(output)
    for path in write(target):
        _tell(str(path))
    _tell(f"next: segfmu plan {target / 'mission.toml'}")


@app.command(epilog="Example: segfmu schema mission > mission.schema.json")
def schema(
    kind: Annotated[
        str, typer.Argument(metavar="[mission|crane]", help="Kind of file.")
    ] = "mission",
) -> None:
    """Print the JSON schema of mission or crane files, with which editors complete and check."""
    from segfmu.validation.schema import KINDS, text

    if kind not in KINDS:
        raise InputError(f"schema of {kind!r}: give {' or '.join(KINDS)}")
    print(text(kind), end="")


@app.command(epilog="Example: segfmu build models/paper.toml --output fmus/dist --fmi 3")
def build(
    mission: Annotated[
        Path | None,
        typer.Argument(help="Mission file (TOML) with the FMUs' start values."),
    ] = None,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="FOLDER", help="Folder for the two archives.")
    ] = "fmus/dist",
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
        with about(mission):
            task = load_mission(mission)
            title, interfaces = task.name, specs(task, _planned(task), waypoints)
    target = folder(output)
    paths = _built(target, choice, interfaces)
    for path in paths:
        _tell(f"{path}  {path.stat().st_size / 1024:.0f} KiB")
    for path in describe(target, paths, interfaces, title, modelica=modelica, ssp=ssp):
        _tell(str(path))


@app.command(epilog="Example: segfmu simulate models/paper.toml --output out")
def simulate(
    mission: MissionFile,
    output: Annotated[
        str,
        typer.Option("--output", "-o", metavar="FOLDER", help="Folder for FMUs, run.csv, plots."),
    ] = "out",
    step: Annotated[
        float | None, typer.Option(help="Communication step [s]; default: the mission's.")
    ] = None,
) -> None:
    """Build the FMUs, co-simulate a mission, write and judge the results."""
    if step is not None and not 1e-6 <= step <= 0.1:
        raise InputError(f"--step must be from 1e-6 to 0.1 s, got {step}")
    with about(mission):
        task = load_mission(mission)
        if step is not None:
            simulation = task.simulation.model_copy(update={"step": step})
            task = task.model_copy(update={"simulation": simulation})
        trajectory = _planned(task)
        _require_steps(task, trajectory)
        every = stride(task, trajectory.duration + task.simulation.settle)
    target = folder(output)
    from segfmu.cosim import write_csv
    from segfmu.fmu.choice import chosen
    from segfmu.validation.criteria import judge
    from segfmu.validation.plots import plot_run, save
    from segfmu.validation.report import run_table
    from segfmu.validation.scenario import ending, specs

    choice = chosen(2, "native", "", everywhere=False)
    feedforward, crane = _built(target, choice, specs(task, trajectory))
    rows = _run(task, trajectory, feedforward, crane)
    write_csv(target / "run.csv", thinned(rows, every))
    save(plot_run(rows, trajectory.waypoint_times, task.name), target / "run.png")
    limits = task.simulation
    found = judge(
        rows, ending(task, trajectory), limits.tracking_tolerance, limits.sway_tolerance,
        task.build_bounds(),
    )
    console.print(run_table(task.name, found))
    _tell(note("run.csv", every, limits.step))
    _tell(f"FMUs, run.csv and run.png are in {target}")
    for row in found.rows:
        if not row.passed:
            _tell(f"failed: {row.name} {row}; {row.key} sets what is allowed")
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
        console.print(f"{path}  {what}", highlight=False, soft_wrap=True)


@app.command(epilog="Example: segfmu campaign models/inteco.toml --output out")
def campaign(
    mission: MissionFile,
    output: Annotated[
        str,
        typer.Option("--output", "-o", metavar="FOLDER", help="Folder for tables and maps (PNG)."),
    ] = "out",
    jobs: Annotated[int, typer.Option(help="Number of processes.", min=1, max=64)] = 1,
    coarse: Annotated[bool, typer.Option("--coarse", help="Maps with few points.")] = False,
) -> None:
    """Compare six control methods under every disturbance; map move times and eigenvalues."""
    with about(mission):
        task = load_mission(mission)
        trajectory = _planned(task)
        _require_steps(task, trajectory)
    from segfmu.validation.campaign import run_campaign
    from segfmu.validation.campaign_files import write_maps, write_tables
    from segfmu.validation.campaign_report import outcome_table, verdict_table
    from segfmu.validation.methods import MODES
    from segfmu.validation.verdict import compare

    target = folder(output)
    with Progress(console=console, transient=True) as progress:
        bar = progress.add_task("disturbances and methods", total=1.0)
        outcomes = run_campaign(
            task, jobs=jobs, progress=lambda share: progress.update(bar, completed=share)
        )
    comparisons = compare(outcomes)
    write_tables(target, task.name, outcomes, comparisons)
    with console.status("mapping move times and eigenvalues"):
        write_maps(target, task, trajectory, coarse)
    for mode in MODES:
        console.print(outcome_table(mode, outcomes))
    console.print(verdict_table(comparisons))
    _tell(f"tables (CSV, JSON) and maps (CSV, PNG) are in {target}")
    for missed in (c for c in comparisons if not c.reached):
        _tell(f"missed: {missed}")
    if not all(c.reached for c in comparisons):
        raise typer.Exit(1)


app.command(epilog="Example: segfmu validate models/scenarios -o out --junit out/junit.xml")(
    commands.validate
)
app.command(epilog="Example: segfmu compare out/gust.csv gust.csv --tube-value 1e-3 --relative")(
    commands.compare
)


def _planned(task: Mission) -> Trajectory:
    """Plan, and check by the flat inverse that the crane can follow."""
    with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
        bar = progress.add_task("planning", total=1.0)
        trajectory = task.plan(lambda share: progress.update(bar, completed=share))
    FlatInverse(task.build_crane(), trajectory)
    return trajectory


def _show_bounds(task: Mission, trajectory: Trajectory) -> None:
    """The use of every bound of the drives, or that none is known."""
    bounds = task.build_bounds()
    if bounds is None:
        _tell(NO_BOUNDS)
        return
    from segfmu.validation.drive_use import bound_table

    console.print(bound_table(bound_uses(task.build_crane(), trajectory, bounds)))


def _require_steps(task: Mission, trajectory: Trajectory) -> None:
    """Refuse missions whose results would not fit in memory."""
    from segfmu.cosim import require_steps

    settings = task.simulation
    try:
        require_steps(trajectory.duration + settings.settle, settings.step)
    except InputError as error:
        raise InputError(f"simulation.step: {error} (settle, dwell, limits)") from None


def _write_plan(task: Mission, trajectory: Trajectory, output: Path, every: int) -> None:
    from segfmu.cosim import write_csv
    from segfmu.validation.drive_plots import plot_drives
    from segfmu.validation.plots import plot_path, plot_plan, save

    write_csv(output / "plan.csv", plan_samples(task, trajectory, every))
    save(plot_plan(trajectory, task.name), output / "plan.png")
    save(plot_path(trajectory, task.name), output / "path.png")
    bounds = task.build_bounds() or ActuatorBounds()
    drives = plot_drives(task.build_crane(), trajectory, bounds, task.name)
    save(drives, output / "drives.png")
    _tell(note("plan.csv", every, task.simulation.step))
    _tell(f"plan.csv, plan.png, path.png and drives.png are in {output}")


def _tell(line: str) -> None:
    """One line on standard output, as it is; none if it is empty."""
    if line:
        console.print(line, highlight=False, markup=False, soft_wrap=True)


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


def run() -> int:
    """Run the command of `sys.argv` and return its exit code; an error is one line on stderr."""
    try:
        # without standalone mode, wrong options are raised
        return app(sys.argv[1:] or ["--help"], standalone_mode=False) or 0
    except SegfmuError as error:
        return _fail(str(error), 2 if isinstance(error, InputError | BuildError) else 1)
    except USAGE_ERROR as error:
        where = getattr(error.ctx, "command_path", "segfmu")
        return _fail(f"{error.format_message().rstrip('.')}; see {where} --help", 2)
    except OSError as error:
        name = f"{error.filename}: " if error.filename else ""
        return _fail(f"{name}{error.strerror or error}", 2)


def _fail(text: str, code: int) -> int:
    print(f"segfmu: {' '.join(text.split())}", file=sys.stderr)
    return code


def main() -> None:
    """Run the command of `sys.argv` and exit."""
    sys.exit(run())
