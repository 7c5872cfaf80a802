"""Commands for one mission: plan, build, co-simulate."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from segfmu.cli.console import AsJson, MissionFile, console, print_document, tell
from segfmu.cli.work import warn, watched
from segfmu.crane import ActuatorBounds, BoundUse, bound_uses
from segfmu.fmu.gantry_feedforward.interface import MOST_WAYPOINTS
from segfmu.planning import Trajectory, excursions
from segfmu.planning.verify import Verification, verify
from segfmu.validation.files.crane_parameters import models
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import files_of, load_mission
from segfmu.validation.output import (
    about,
    folder,
    plan_samples,
    require_folder,
    require_kept,
    require_there,
    stride,
)
from segfmu.validation.output import note as thinning
from segfmu.validation.planned import planned
from segfmu.validation.sticking import sticking

if TYPE_CHECKING:
    from segfmu.validation.runs import Run

NO_BOUNDS = (
    "no bounds of the drives are known (velocity_max, acceleration_max, force_max, power_max of "
    "the crane file): the plan keeps the mission's limits alone"
)
# what the commands write
PLAN_FILES = ("plan.csv", "plan.png", "path.png", "drives.png")
RUN_FILES = ("run.csv", "run.png", "report.html")


def plan(
    mission: MissionFile,
    output: Annotated[
        str | None,
        typer.Option("--output", "-o", metavar="FOLDER", help="Folder for plan.csv and plots."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Plan a mission and show every peak against its limit."""
    task = load_mission(mission)
    if output is not None:
        require_folder(output, *PLAN_FILES)
        require_kept(files_of(mission), (Path(output) / name for name in PLAN_FILES))
    with about(mission), watched() as progress:
        trajectory = planned(task, progress)
        every = stride(task, trajectory.duration)
    target = None if output is None else folder(output)
    found, uses = verify(trajectory), _uses(task, trajectory)
    notes = [str(one) for one in excursions(trajectory)]
    notes += filter(None, [sticking(task, trajectory)])
    if as_json:
        from segfmu.validation.documents.plan import plan_document

        if target is not None:
            _write_plan(task, trajectory, target, every)
        files = [] if target is None else [str(target / name) for name in PLAN_FILES]
        print_document(plan_document(
            task.name, trajectory, found, uses or (), limits_found=task.limits is None,
            notes=notes, files=files,
        ))
        return
    _show_plan(task, trajectory, found, uses)
    for note in notes:
        tell(note)
    if target is not None:
        _write_plan(task, trajectory, target, every)
        tell(thinning("plan.csv", every, task.simulation.step))
        tell(f"plan.csv, plan.png, path.png and drives.png are in {output}")


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
        str | None,
        typer.Option(help="Of native binaries: all, or names with commas; default: available."),
    ] = None,
    waypoints: Annotated[
        int | None,
        typer.Option(help="Maximum number of waypoints; default: 16, or that of the mission.",
                     min=2, max=MOST_WAYPOINTS),
    ] = None,
    enumerations: Annotated[
        str, typer.Option(help="Type of choices: enumeration, or integer for importers without.")
    ] = "enumeration",
    commands: Annotated[
        str, typer.Option(help="An operator's commands: parameters, or inputs to be connected.")
    ] = "parameters",
    modelica: Annotated[
        bool, typer.Option("--modelica", help="Also write a Modelica package with both FMUs.")
    ] = False,
    ssp: Annotated[
        bool,
        typer.Option("--ssp", help="Also write mission.ssp and, of FMI 2, OspSystemStructure.xml."),
    ] = False,
    references: Annotated[
        bool,
        typer.Option("--references", help="Put an experiment, its results and the verdict inside."),
    ] = False,
) -> None:
    """Build GantryFeedforward.fmu and GantryCrane.fmu.

    Native FMUs support co-simulation and model exchange; those of the Python backend support FMI
    2.0 co-simulation.
    """
    from segfmu.validation import archives

    with watched() as progress:
        written = archives.build(
            mission, output, fmi=fmi, backend=backend, platforms=platforms, waypoints=waypoints,
            enumerations=enumerations, commands=commands, modelica=modelica, ssp=ssp,
            references=references, progress=progress,
        )
    warn(written.note)
    for path in (written.feedforward, written.crane):
        tell(f"{path}  {path.stat().st_size / 1024:.0f} KiB")
    for path in written.others:
        tell(str(path))


def simulate(
    mission: MissionFile,
    output: Annotated[
        str,
        typer.Option(
            "--output", "-o", metavar="FOLDER", help="Folder for FMUs, run.csv, plots and report."
        ),
    ] = "out",
    step: Annotated[
        float | None, typer.Option(help="Communication step [s]; default: the mission's.")
    ] = None,
    commands: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="Recording (CSV) of an operator's commands, which are followed."
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Build the FMUs, co-simulate a mission, write and judge the results."""
    from segfmu.cosim.messages import on_stderr
    from segfmu.validation import runs
    from segfmu.validation.plots.style import save

    require_folder(output, *RUN_FILES)
    read = [*files_of(mission), commands]
    require_kept(read, (Path(output) / name for name in RUN_FILES))
    with on_stderr(), watched() as progress:
        run = runs.simulate(
            mission, step=step, commands=commands, output=output, progress=progress
        )
    target = Path(output)
    left_out = run.to_csv(target / "run.csv")
    save(run.plot(), target / "run.png")
    run.report(target / "report.html")
    files = [target / name for name in RUN_FILES]
    archives = (target / f"{name}.fmu" for name in models(run.mission.crane).names)
    require_there((*archives, *files))
    if as_json:
        from segfmu.validation.documents.run import run_document

        print_document(run_document(run, [str(path) for path in files]))
    else:
        warn(run.note)
        _show_run(run, target, left_out)
    if not run.passed:
        raise typer.Exit(1)


def live(
    mission: MissionFile,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="FILE", help="The page.")
    ] = "live.html",
) -> None:
    """Write a page on which the mission's crane is driven in a browser, without a network."""
    from segfmu.validation.live import page

    require_kept(files_of(mission), [Path(output)])
    with watched() as progress:
        path = page.live(mission, output, progress=progress)
    tell(f"{path}  {path.stat().st_size / 1024:.0f} KiB; open it in a browser")


def paper(
    output: Annotated[
        str,
        typer.Option(
            "--output", "-o", metavar="FOLDER", help="Folder for figures, mission and run.csv."
        ),
    ] = "out",
) -> None:
    """Plan and co-simulate the paper's mission; draw its figures 3, 6 and 7."""
    from segfmu.cosim.messages import on_stderr
    from segfmu.validation.paper import MISSION, write_figures
    from segfmu.validation.runs import simulate

    target = folder(output)
    with on_stderr(), watched() as progress:
        run = simulate(MISSION, output=target, progress=progress)
    warn(run.note)
    written = write_figures(target, run.trajectory, run.rows)
    require_there(path for path, _ in written)
    for path, what in written:
        tell(f"{path}  {what}")


def _uses(task: Mission, trajectory: Trajectory) -> tuple[BoundUse, ...] | None:
    """The use of every bound of the drives; None if none is known."""
    bounds = task.build_bounds()
    if bounds is None:
        return None
    return bound_uses(task.build_crane(), trajectory, bounds, task.build_friction())


def _show_plan(
    task: Mission, trajectory: Trajectory, found: Verification, uses: tuple[BoundUse, ...] | None
) -> None:
    from segfmu.validation.drive_use import bound_table
    from segfmu.validation.tables import plan_table

    console.print(plan_table(task.name, trajectory, found, task.limits is not None))
    if uses is None:
        tell(NO_BOUNDS)
    else:
        console.print(bound_table(uses))


def _write_plan(task: Mission, trajectory: Trajectory, output: Path, every: int) -> None:
    from segfmu.cosim import write_csv
    from segfmu.validation.plots.drives import plot_drives
    from segfmu.validation.plots.path import plot_path
    from segfmu.validation.plots.plan import plot_plan
    from segfmu.validation.plots.style import save
    from segfmu.validation.units import signal_units

    write_csv(output / "plan.csv", plan_samples(task, trajectory, every), signal_units())
    given = task.limits is not None
    save(plot_plan(trajectory, task.name, given), output / "plan.png")
    save(plot_path(trajectory, task.name, task.build_clearance()), output / "path.png")
    bounds = task.build_bounds() or ActuatorBounds()
    drives = plot_drives(
        task.build_crane(), trajectory, bounds, task.name, task.build_friction()
    )
    save(drives, output / "drives.png")
    require_there(output / name for name in PLAN_FILES)


def _show_run(run: Run, target: Path, left_out: str) -> None:
    from segfmu.validation.tables import run_table

    console.print(run_table(run.mission.name, run.criteria))
    tell(left_out)
    tell(f"FMUs, run.csv and run.png are in {target}")
    tell(f"report: {target / 'report.html'}")
    for row in run.criteria.rows:
        if not row.passed:
            tell(f"failed: {row.name} {row}; {row.key} sets what is allowed")
