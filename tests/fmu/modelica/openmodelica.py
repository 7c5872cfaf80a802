"""Models built and run by OpenModelica's compiler, where there is one."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

SOLVERS = ("dassl", "ida", "cvode", "gbode")

# connectors of imported FMUs, so that no library has to be installed
CONNECTORS = """package Modelica
  package Blocks
    package Interfaces
      connector RealInput = input Real;
      connector BooleanInput = input Boolean;
      connector RealOutput = output Real;
      connector BooleanOutput = output Boolean;
      connector IntegerOutput = output Integer;
    end Interfaces;
  end Blocks;
end Modelica;
"""
# the only option: the code of every imported FMU with events needs it
PREPARATION = 'setCommandLineOptions("--allowNonStandardModelica=reinitInAlgorithms");\n'


def compiler() -> str | None:
    """The path of omc."""
    return shutil.which("omc")


def require_omc() -> None:
    """Skip a module, with one line, where there is no omc."""
    if compiler() is None:
        pytest.skip("OpenModelica's compiler omc is not on the PATH", allow_module_level=True)


def script(folder: Path, text: str) -> str:
    """Run a script in a folder; returns what it said."""
    (folder / "script.mos").write_text(text)
    done = subprocess.run(
        [compiler() or "omc", "script.mos"], cwd=folder, capture_output=True, text=True, check=False
    )
    return done.stdout + done.stderr


def built(folder: Path, model: str, preparation: str, stop: float) -> Path:
    """Compile a model; raises AssertionError with what the compiler said."""
    target = folder / model
    said = script(folder, preparation + (
        f'buildModel({model}, stopTime={stop}, numberOfIntervals={round(stop * 1000)}, '
        'tolerance=1e-8, outputFormat="csv");\ngetErrorString();\n'
    ))
    assert target.exists(), said
    return target


def simulated(program: Path, *options: str) -> tuple[NDArray[np.void], str]:
    """Results of a compiled model, a row each ms and each event, and what it said."""
    results = program.with_name("results.csv")
    results.unlink(missing_ok=True)
    done = subprocess.run(
        [program, f"-r={results}", *options], cwd=program.parent, capture_output=True, text=True,
        check=False,
    )
    said = done.stdout + done.stderr
    assert results.exists() and "finished successfully.\n" in said, said
    # the compiler quotes the names
    return np.genfromtxt(results, delimiter=",", names=True, deletechars="\""), said


def imported(folder: Path, archives: Sequence[Path]) -> str:
    """Have FMUs imported as model exchange, each into a folder of its own; returns loading them."""
    lines = ['loadFile("Modelica.mo");']
    (folder / "Modelica.mo").write_text(CONNECTORS)
    for archive in archives:
        own = folder / archive.stem
        own.mkdir()
        lines.append(f'importFMU("{archive}", workdir="{own}");')
    said = script(folder, PREPARATION + "\n".join([*lines, "getErrorString();"]))
    assert "Error" not in said, said
    loads = [
        f'loadFile("{folder / a.stem / (a.stem + "_me_FMU.mo")}");' for a in archives
    ]
    return PREPARATION + "\n".join([lines[0], *loads, ""])


def at_steps(results: NDArray[np.void], times: NDArray[np.float64]) -> NDArray[np.void]:
    """The rows at some times; behind an event where one is there."""
    rows = np.searchsorted(results["time"], times + 1e-9, side="right") - 1
    assert np.abs(results["time"][rows] - times).max() < 1e-9
    return results[rows]


def load_distance(
    results: NDArray[np.void], prefix: str, expected: NDArray[np.void]
) -> float:
    """The largest distance of the load from that of a co-simulation, in m."""
    rows = at_steps(results, expected["time"])
    differences = [
        rows[f"{prefix}load_position_{a}"] - expected[f"load.position.{a}"] for a in "xyz"
    ]
    return float(np.linalg.norm(differences, axis=0).max())
