"""Files of the campaign: tables as CSV and JSON, maps as CSV and PNG."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, fields
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from segfmu.cosim import write_csv
from segfmu.cosim.result import replacing
from segfmu.planning import Trajectory
from segfmu.validation.campaign import Outcome
from segfmu.validation.campaign_plots import plot_eigenvalues, plot_move_times, plot_outcomes
from segfmu.validation.files.mission import Mission
from segfmu.validation.maps import eigenvalue_maps, move_times
from segfmu.validation.methods import MODES, rope_range
from segfmu.validation.plots import save
from segfmu.validation.verdict import Comparison

# rope lengths and distances, rope lengths and payloads
GRIDS = ((21, 25), (25, 13))
COARSE_GRIDS = ((3, 4), (4, 3))

# distances of the map of move times [m]
DISTANCES = (0.02, 1.2)


def write_tables(
    folder: Path, name: str, outcomes: Sequence[Outcome], comparisons: Sequence[Comparison]
) -> None:
    """Write campaign.csv, campaign.json, verdict.csv, and one picture per mode.

    Raises
    ------
    InputError
        When a file cannot be written.
    """
    write_rows(folder / "campaign.csv", outcomes)
    write_rows(folder / "verdict.csv", comparisons)
    write_json(folder / "campaign.json", name, outcomes, comparisons)
    for mode in MODES:
        save(plot_outcomes(outcomes, mode, name), folder / f"campaign_{mode}.png")


def write_maps(folder: Path, mission: Mission, trajectory: Trajectory, coarse: bool) -> None:
    """Write the maps of move times and eigenvalues, CSV and PNG.

    Raises
    ------
    InputError
        When a file cannot be written.
    """
    (ropes, distances), (lengths, payloads) = COARSE_GRIDS if coarse else GRIDS
    crane = mission.build_crane()
    span = rope_range(crane, trajectory)
    limits = mission.require_limits().x.velocity, mission.require_limits().x.acceleration
    times = move_times(
        np.linspace(*span, ropes), np.linspace(*DISTANCES, distances), limits, crane.gravity
    )
    write_csv(folder / "move_times.csv", times)
    save(plot_move_times(times, limits), folder / "move_times.png")
    found = eigenvalue_maps(crane, span, lengths, payloads)
    write_csv(folder / "eigenvalues.csv", found)
    save(plot_eigenvalues(found, crane.payload_mass), folder / "eigenvalues.png")


def write_rows(path: Path, rows: Sequence[Any]) -> None:
    """Write dataclasses of one type as CSV; the file appears when it is complete.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    names = [field.name for field in fields(rows[0])]
    with replacing(path) as temporary, temporary.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, names)
        writer.writeheader()
        writer.writerows(asdict(row) for row in rows)


def write_json(
    path: Path, name: str, outcomes: Iterable[Outcome], comparisons: Iterable[Comparison]
) -> None:
    """Write outcomes and verdict as JSON, with null for non-finite numbers.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    content = {
        "mission": name,
        "outcomes": [_plain(asdict(o)) for o in outcomes],
        "comparisons": [_plain({**asdict(c), "reached": c.reached}) for c in comparisons],
    }
    with replacing(path) as temporary:
        temporary.write_text(json.dumps(content, indent=1, allow_nan=False), encoding="utf-8")


def _plain(values: dict[str, Any]) -> dict[str, Any]:
    return {
        key: None if isinstance(value, float) and not isfinite(value) else value
        for key, value in values.items()
    }
