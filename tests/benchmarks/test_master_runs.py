"""The benchmark of many runs measures both engines, kept and loaded, and two processes."""

from __future__ import annotations

from threading import Barrier

from benchmarks import master_runs


def test_all_ways_are_measured(native_fmus, monkeypatch) -> None:
    side_by_side = master_runs._side_by_side

    def found(jobs: list[master_runs.Job]) -> list[master_runs.Found]:
        """Of one job in this process: what two processes do, one does."""
        if len(jobs) > 1:
            return side_by_side(jobs)
        return [master_runs._work(jobs[0], Barrier(1))]

    monkeypatch.setattr(master_runs, "_side_by_side", found)
    monkeypatch.setattr(master_runs, "STOP", 0.05)
    records = master_runs._records(native_fmus[2], "sequential", 4)
    assert records[0]["instances"] == master_runs.LOADED
    assert (records[-1]["instances"], records[-1]["processes"]) == (master_runs.KEPT, 2)
    assert all(r["runs/s"] > 0.0 for r in records)
