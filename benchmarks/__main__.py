"""`python -m benchmarks`: run the parts one after the other, print and save what they measured."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from benchmarks.report import Part, Settings, installed_version, save, show

# letter -> module, and the packages of the extra `bench` it needs
PARTS: dict[str, tuple[str, tuple[str, ...]]] = {
    "a": ("planning_time", ("ruckig",)),
    "b": ("kernel_time", ("ruckig",)),
    "c": ("durations", ("ruckig",)),
    "d": ("effort", ("casadi",)),
    "e": ("growth", ()),
    "f": ("evaluation", ()),
    "g": ("fmu_steps", ()),
    "m": ("master_runs", ()),
    "n": ("campaign_rate", ("distributed", "pyarrow")),
    "mem": ("campaign_memory", ("distributed", "pyarrow")),
    "w": ("worst_cases", ("distributed", "pyarrow")),
    "rare": ("rare_failures", ("distributed", "pyarrow", "openturns")),
    "v": ("identification", ()),
    "h": ("master_time", ()),
    "i": ("completeness", ()),
    "j": ("drive_bounds", ()),
    "q": ("drive_friction", ()),
    "s": ("obstacles", ()),
    "l": ("braking", ()),
    "o": ("directions", ()),
    "t": ("coming_inside", ("ruckig",)),
    "y": ("position_ranges", ()),
    "r": ("replanning", ()),
    "u": ("operation", ()),
    "x": ("joystick", ()),
    "z": ("takeovers", ()),
    "rec": ("recordings", ()),
    "k": ("free_states", ("casadi",)),
    "ini": ("initialisation", ()),
    "chg": ("changed_missions", ()),
    "p": ("feedback", ()),
    "hook": ("hooks", ()),
    "ablation": ("ablation", ()),
}

LIST = ", ".join(f"{letter} {module}" for letter, (module, _) in PARTS.items())


def main(
    only: Annotated[str, typer.Option(help=f"Parts to run: {LIST}.")] = ",".join(PARTS),
    problems: Annotated[
        int, typer.Option(min=1, help="Random problems of the comparison of durations.")
    ] = 10_000,
    quick: Annotated[bool, typer.Option(help="Few samples: a look, not a measurement.")] = False,
    output: Annotated[Path, typer.Option(help="JSON file to write.")] = Path("out/benchmarks.json"),
) -> None:
    """Measure segfmu beside Ruckig, casadi with ipopt, and linear programming."""
    chosen = [name.strip() for name in only.split(",")]
    unknown = [name for name in chosen if name not in PARTS]
    if unknown:
        raise typer.BadParameter(f"no part {unknown[0]!r}; the parts are {', '.join(PARTS)}")
    settings = Settings(
        problems=min(problems, 1000) if quick else problems,
        samples=100 if quick else 500,
        repetitions=3 if quick else 9,
        folder=output.parent / "benchmarks",
    )
    # as wide as the widest table where the output is no terminal
    console = Console() if sys.stdout.isatty() else Console(width=132)
    found: dict[str, Part] = {}
    for name in chosen:
        module, packages = PARTS[name]
        missing = [package for package in packages if installed_version(package) is None]
        if missing:
            console.print(f"part {name} needs {missing[0]}: pip install 'segfmu\\[bench]'")
            continue
        found[module] = import_module(f"benchmarks.{module}").measure(settings)
        show(found[module], console)
        save(found, output)
    console.print(f"all figures: {output}", highlight=False)


if __name__ == "__main__":
    typer.run(main)
