"""The reference signals in fmus/ are what the FMUs produce now; `make golden` writes them again."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from segfmu.cosim import simulate, write_csv
from segfmu.fmu.pair import ModelPair
from segfmu.fmu.pairs import GANTRY, HOOK

FOLDER = Path(__file__).parents[2] / "fmus"


def signals_of(models: ModelPair, file: str) -> list[str]:
    """Names of a file's columns behind time."""
    spec = models.planner(2) if "feedforward" in file else models.plant()
    return [v.name for v in spec.where("input" if file.endswith("_in.csv") else "output")]


@pytest.fixture(scope="module")
def run(fmus: tuple[Path, Path]) -> np.ndarray:
    return simulate(*fmus, stop_time=5.0, step=1e-3)[::100]


@pytest.fixture(scope="module")
def hook_run(hook_fmus: dict[int, tuple[Path, Path]]) -> np.ndarray:
    """The crane with a hook, whose feedback of measured signals brings a deviation to rest."""
    rows: np.ndarray = simulate(
        *hook_fmus[2], stop_time=9.0, step=1e-3,
        sink_values={"feedback.enabled": True, "sling.x.angle": 0.02, "sway.y.angle": 0.01},
    )
    return rows[::100]


FILES = ("feedforward/reference_out.csv", "crane/reference_in.csv", "crane/reference_out.csv")


@pytest.mark.interpreted
@pytest.mark.parametrize("file", FILES)
def test_reference_signals(run: np.ndarray, file: str) -> None:
    _compare(run, f"gantry_{file}", signals_of(GANTRY, file))


@pytest.mark.parametrize("file", FILES)
def test_reference_signals_with_a_hook(hook_run: np.ndarray, file: str) -> None:
    _compare(hook_run, f"hook_{file}", signals_of(HOOK, file))


def _compare(run: np.ndarray, file: str, signals: list[str]) -> None:
    """Compare a run with the file, or write this."""
    # the wind is not connected and stays zero
    used = ["time", *(n for n in signals if not n.startswith("wind."))]
    rows = np.zeros(run.size, dtype=[(n, float) for n in used])
    for name in used:
        rows[name] = run[name]
    path = FOLDER / file
    if os.environ.get("SEGFMU_UPDATE_GOLDEN"):
        write_csv(path, rows)
    header = path.read_text(encoding="utf-8").splitlines()[0]
    assert header == ",".join(f'"{n}"' for n in used)
    table = np.genfromtxt(path, delimiter=",", skip_header=1)
    for column, name in zip(table.T, used, strict=True):
        # tracking errors are rounding and integration errors: compared on their own scale
        scale = 1e-4 if name.startswith("error.") else max(1.0, float(np.abs(column).max()))
        assert rows[name] == pytest.approx(column, abs=1e-7 * scale, rel=1e-7), name
