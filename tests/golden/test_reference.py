"""The reference signals in fmus/ are what the FMUs produce now; `make golden` writes them again."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from segfmu.cosim import simulate, write_csv
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward

pytestmark = pytest.mark.interpreted

FOLDER = Path(__file__).parents[2] / "fmus"


def names(spec, causality: str) -> list[str]:
    return [v.name for v in spec.where(causality)]


@pytest.fixture(scope="module")
def run(fmus: tuple[Path, Path]) -> np.ndarray:
    return simulate(*fmus, stop_time=5.0, step=1e-3)[::100]


@pytest.mark.parametrize(
    ("file", "signals"),
    [
        ("gantry_feedforward/reference_out.csv", names(gantry_feedforward.spec(), "output")),
        ("gantry_crane/reference_in.csv", names(gantry_crane.spec(), "input")),
        ("gantry_crane/reference_out.csv", names(gantry_crane.spec(), "output")),
    ],
)
def test_reference_signals(run: np.ndarray, file: str, signals: list[str]) -> None:
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
