"""The master on the real FMUs: results, time labels, errors, clean-up."""

from __future__ import annotations

import errno
import gc
import os
import tempfile
from pathlib import Path

import numpy as np
import pytest

from segfmu.cosim import load, simulate, write_csv
from segfmu.errors import InputError, SimulationError


def residual(rows: np.ndarray, after: float) -> float:
    late = rows["time"] >= after
    angles = np.abs([rows["sway.x.angle"][late], rows["sway.y.angle"][late]])
    return float(np.degrees(angles.max()))


@pytest.mark.parametrize("mode", ["force", "velocity"])
def test_perfect_model_tracks_and_leaves_no_sway(native_fmus, mode: str) -> None:
    values = {"drive.mode": mode, "feedback.design": "flatness"}
    rows = simulate(*native_fmus[2], stop_time=5.5, step=1e-3, sink_values=values)
    assert rows["error.load.norm"].max() < 1e-3
    assert residual(rows, 4.03) < 0.02
    assert rows["plan.done"][-1]


def test_feedback_removes_an_initial_sway_and_without_it_the_sway_stays(native_fmus) -> None:
    start = {
        "sway.x.angle": np.radians(5.0), "drive.mode": "velocity", "feedback.design": "flatness",
    }
    still = {"waypoint.count": 2, "waypoint[2].position.x": 0.01}
    for name in ("velocity", "acceleration"):
        still.update({f"waypoint[2].{name}.{axis}": 0.0 for axis in "xy"})
    still["waypoint[2].position.y"] = 0.0
    period = 2.0 * np.pi * np.sqrt(0.5 / 9.81)
    for enabled, low, high in ((True, 0.0, 0.1), (False, 4.5, 5.6)):
        rows = simulate(
            *native_fmus[2], stop_time=5.0 * period, step=5e-3, source_values=still,
            sink_values={**start, "feedback.enabled": enabled},
        )
        assert low <= residual(rows, 4.0 * period) < high


def test_error_falls_with_the_square_of_the_step(fmus: tuple[Path, Path]) -> None:
    errors = [
        simulate(*fmus, stop_time=2.0, step=h, sink_values={"feedback.enabled": False})[
            "error.load.norm"
        ].max()
        for h in (8e-3, 4e-3)
    ]
    assert errors[0] / errors[1] > 3.0


@pytest.mark.parametrize(("step", "count"), [(0.007, 143), (0.05, 20), (0.3, 4)])
def test_rows_are_labelled_with_the_time_of_their_values(
    fmus: tuple[Path, Path], step: float, count: int
) -> None:
    rows = simulate(*fmus, stop_time=1.0, step=step)
    assert rows.size == count + 1
    assert rows["time"][:-1] == pytest.approx(np.arange(count) * step, abs=0.0)
    assert rows["time"][-1] == 1.0
    fine = simulate(*fmus, stop_time=1.0, step=0.001)
    for name in ("reference.load.position.x", "force.bridge"):
        at = np.interp(rows["time"], fine["time"], fine[name])
        assert rows[name] == pytest.approx(at, abs=2e-4)


def test_many_steps_do_not_drift(native_fmus) -> None:
    rows = simulate(*native_fmus[2], stop_time=0.7, step=1e-4)
    assert rows["time"].tolist() == [*(i * 1e-4 for i in range(7000)), 0.7]


def test_infeasible_plan_is_reported_and_everything_freed(
    fmus: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # a folder of its own: other processes may run FMUs beside
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    for _ in range(3):
        with pytest.raises(SimulationError, match="axis x, waypoint 2"):
            simulate(
                *fmus, stop_time=1.0, step=0.01, source_values={"waypoint[2].velocity.x": 5.0}
            )
    gc.collect()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"step": 0.0}, "step"),
        ({"step": float("nan")}, "step"),
        ({"stop_time": -1.0}, "stop_time"),
        ({"source_values": {"nonsense": 1.0}}, "nonsense"),
        ({"source_values": {"planner.shape": "round"}}, "smoothstep, plateau"),
        ({"sink_values": {"feedback.enabled": "yes"}}, "feedback.enabled"),
        ({"source_values": {"waypoint.count": 2.5}}, "integer"),
    ],
)
def test_bad_requests_are_named(fmus: tuple[Path, Path], options, words: str) -> None:
    with pytest.raises(InputError, match=words):
        simulate(*fmus, **{"stop_time": 1.0, "step": 0.01, **options})


@pytest.mark.parametrize("content", [b"", b"no archive", b"PK\x03\x04 broken"])
def test_bad_archives_are_named(tmp_path: Path, fmus: tuple[Path, Path], content: bytes) -> None:
    bad = tmp_path / "bad.fmu"
    bad.write_bytes(content)
    with pytest.raises(InputError, match=r"bad\.fmu"):
        simulate(bad, fmus[1], stop_time=1.0, step=0.01)


def test_an_archive_is_not_blamed_for_a_full_disk(
    fmus: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(load, "extract", full)
    with pytest.raises(InputError, match=r"^temporary files cannot be written in .*: No space"):
        simulate(*fmus, stop_time=1.0, step=0.01)


def test_csv_holds_every_digit_and_appears_whole(tmp_path: Path) -> None:
    rows = np.zeros(3, dtype=[("time", float), ("a.b", float), ("done", bool)])
    rows["time"], rows["a.b"] = [0.0, 0.1, 0.2], np.pi
    write_csv(tmp_path / "deep" / "r.csv", rows)
    back = np.genfromtxt(tmp_path / "deep" / "r.csv", delimiter=",", skip_header=1)
    assert back[:, 1].tolist() == [np.pi] * 3
    assert [p.name for p in (tmp_path / "deep").iterdir()] == ["r.csv"]
    (tmp_path / "file").write_text("x")
    with pytest.raises(InputError, match="cannot be written"):
        write_csv(tmp_path / "file" / "r.csv", rows)


@pytest.mark.parametrize("step", [1e-300, 1e-9])
def test_endless_runs_are_refused(fmus: tuple[Path, Path], step: float) -> None:
    with pytest.raises(InputError, match=r"steps, at most 2000000 are possible; take a longer"):
        simulate(*fmus, stop_time=1.0, step=step)


def test_an_error_while_the_other_fmu_initialises_is_the_one_reported(native_fmus) -> None:
    """The crane is still in initialisation mode then and can only be freed."""
    with pytest.raises(SimulationError, match="GantryFeedforward could not be initialised"):
        simulate(*native_fmus[2], stop_time=1.0, step=0.01,
                 source_values={"crane.bridge_mass": 0.0})


def test_unknown_coupling_is_refused(fmus: tuple[Path, Path]) -> None:
    with pytest.raises(InputError, match="sequential or parallel or derivatives, got 'both'"):
        simulate(*fmus, stop_time=1.0, step=0.1, coupling="both")  # type: ignore[arg-type]


def test_coupling_by_derivatives_needs_fmus_that_have_them(fmus) -> None:
    with pytest.raises(InputError, match="tells no output derivatives"):
        simulate(*fmus, stop_time=0.1, step=0.01, coupling="derivatives")
