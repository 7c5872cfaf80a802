"""Recorded commands: the files, and both FMUs under them beside the operator."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from benchmarks.operated import SITES
from benchmarks.recordings import (
    FOLDER,
    RECORDINGS,
    archives,
    judged,
    read,
    replayed,
    simulated,
    step_of,
)

from segfmu.crane.operation_command import MODES
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from tests.campaign import soaked
from tests.compiler import require_native


@pytest.mark.parametrize("name", SITES)
def test_recordings_are_commands_at_steps(name: str) -> None:
    site = SITES[name]
    inputs = {*gantry_feedforward.spec().references, *gantry_crane.spec().references}
    paths = sorted((FOLDER / name).glob("*.csv"))
    assert {p.stem for p in paths} == {file for file, _ in RECORDINGS.values()}
    for path in paths:
        rows = read(path)
        times = np.array([row.time for row in rows])
        assert times[0] == 0.0
        assert (np.diff(times) > 0.0).all()
        np.testing.assert_allclose(times / step_of(site), np.round(times / step_of(site)))
        for row in rows:
            assert row.values["command.mode"] in MODES
            assert row.values.keys() <= inputs


@pytest.mark.parametrize("name", ["lab", *soaked("port")])
def test_fmus_follow_recordings_as_the_operator_does(name: str, tmp_path: Path) -> None:
    require_native()
    site = SITES[name]
    fmus = archives(site, tmp_path)
    rope = -site.start[2]
    found = {}
    for title, (file, payload) in RECORDINGS.items():
        rows = read(FOLDER / name / f"{file}.csv")
        places, statuses = replayed(site, rows)
        assert set(statuses) <= {"taken", "reduced", "pending"}, title
        # the load moves
        assert np.ptp(places, axis=0).max() > 0.01 * rope, title
        found[title] = judged(site, simulated(site, fmus, rows, payload), places)
        assert found[title]["FMU from operator [m]"] < 1e-9 * rope, title
        assert found[title]["sway at rest [deg]"] < 1e-3, title
        assert found[title]["error at rest [m]"] < 1e-4 * rope, title
    # half the load is moved twice as far by the wind
    whole, half = (found[n]["largest error [m]"] for n in ("wind", "wind, half the load"))
    assert half == pytest.approx(2.0 * whole, rel=0.1)
    assert found["emergency stop"]["largest sway [deg]"] > 1.5 * found["released"][
        "largest sway [deg]"
    ]
