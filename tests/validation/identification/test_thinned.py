"""Logs with fewer rows: they do what all rows do, and spare a search most of its work."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks import synthetic_logs
from benchmarks.synthetic_logs import SIZES, synthetic, tables

import segfmu
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.reading import merged
from segfmu.validation.identification import fit
from segfmu.validation.identification.log import Log
from segfmu.validation.identification.model import Model
from segfmu.validation.identification.thinned import ROWS, thinned

PERIOD = 2.0 * np.pi * np.sqrt(SIZES["lab"][-1] / 9.81)


def smooth(times: np.ndarray) -> Log:
    """Setpoints and signals of a moving crane, of which the signals do not matter."""
    share = 2.0 * np.pi * times / PERIOD
    told = 0.1 * np.stack([np.sin(share), np.sin(2.0 * share), 0.5 * np.sin(share + 1.0)], axis=1)
    return Log("log", times, told, np.cumsum(np.ones((times.size, 5)), axis=0))


@pytest.mark.parametrize("seed", [None, 1])
def test_a_crane_does_with_few_rows_what_it_does_with_all(seed: int | None) -> None:
    steps = np.full(6000, 4.0 * PERIOD / 6000)
    if seed is not None:
        steps *= np.random.default_rng(seed).uniform(0.3, 1.7, steps.size)
    log = smooth(np.append(0.0, np.cumsum(steps)))
    few = thinned(log, PERIOD)
    places = np.searchsorted(log.times, few.times)
    assert few.times.size < 1.1 * 4.0 * ROWS
    np.testing.assert_array_equal(few.times, log.times[places])
    np.testing.assert_array_equal(few.measured, log.measured[places])
    known = synthetic("lab", "velocity", 2, rows=50)
    model = Model(CraneFile.model_validate(merged(known.crane, tables(known.truth))))
    start = np.zeros(10)
    start[2] = SIZES["lab"][-1]
    full, found = (model.run(one, {}, start) for one in (log, few))
    np.testing.assert_allclose(found, full[places], atol=1e-4 * np.ptp(full, axis=0).max())


def test_setpoints_bring_what_they_brought() -> None:
    """One that is only sampled misses what is between: a pulse, or noise."""
    log = smooth(np.linspace(0.0, PERIOD, 2000))
    log.setpoints[1001:1004, 0] += 5.0
    few = thinned(log, PERIOD)
    ways = [np.trapezoid(one.setpoints, one.times, axis=0) for one in (log, few)]
    np.testing.assert_allclose(*ways, atol=1e-9)


def test_a_log_of_few_rows_stays_as_it_is() -> None:
    log = smooth(np.linspace(0.0, 4.0 * PERIOD, int(4.0 * 1.9 * ROWS)))
    assert thinned(log, PERIOD) is log


def test_a_search_takes_few_rows_and_finds_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """At 1 kHz it took minutes, by which it told the same."""
    monkeypatch.setattr(synthetic_logs, "ROWS_OF_PERIOD", 400)
    log = synthetic("lab", "velocity", 2, rows=800)
    keys = ["bridge.lag", "sensors.rope.zero", "friction.sway.viscous"]
    rows: list[int] = []
    run = Model.run

    def counted(self: Model, one: Log, *rest: object) -> np.ndarray:
        rows[-1] += one.times.size
        return run(self, one, *rest)  # type: ignore[arg-type]

    monkeypatch.setattr(Model, "run", counted)
    found = []
    for thin in (thinned, lambda one, _: one):
        monkeypatch.setattr(fit, "thinned", thin)
        rows.append(0)
        found.append(
            segfmu.identify(log.columns, log.crane_without(*keys), fit=keys, held_out=0.0)
        )
    assert rows[0] < 0.8 * rows[1]
    for one, other in zip(found[0].estimates, found[1].estimates, strict=True):
        half = 0.5 * (other.high - other.low)
        assert one.value == pytest.approx(other.value, abs=0.05 * half), one.key
        assert one.high - one.low == pytest.approx(2.0 * half, rel=0.05)
