"""Tubes: closed forms, and runs with another gain or another step."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
import pytest

from segfmu import cli
from segfmu.cosim import write_csv
from segfmu.errors import InputError
from segfmu.validation.comparison import compare
from segfmu.validation.files.scenario_file import load_scenario
from segfmu.validation.suite import Runner
from tests.compiler import require_native

SUITE = Path(__file__).parents[2] / "models" / "scenarios"
TIMES = np.linspace(0.0, 2.0, 2001)


def ramp(shift: float = 0.0) -> dict[str, np.ndarray]:
    return {"time": TIMES, "a": np.clip(3.0 * (TIMES - shift - 0.5), 0.0, 3.0)}


def test_a_shift_in_time_needs_a_tube_as_wide() -> None:
    wide = {"tube_time": 0.1, "tube_value": 0.3}
    # 3 m/s make 0.3 m of 0.1 s: 0.2 s are at the edge of both tubes together
    assert not compare(ramp(0.199), ramp(), **wide)
    (found,) = compare(ramp(0.25), ramp(), **wide)
    assert found.signal == "a" and found.largest == pytest.approx(0.75 - 0.6)


def test_what_is_no_number_is_named() -> None:
    hole = ramp()
    hole["a"] = np.where(np.arange(TIMES.size) == 700, np.nan, hole["a"])
    (found,) = compare(hole, ramp(), tube_time=0.0, tube_value=0.1)
    assert str(found) == "a is not a number at 0.7 s"
    with pytest.raises(InputError, match=r"the reference has no number for a at 0\.7 s"):
        compare(ramp(), hole, tube_time=0.0, tube_value=0.1)
    # every tube that is a share of it would be infinite
    for endless in (np.inf, -np.inf):
        far = ramp() | {"a": np.where(np.arange(TIMES.size) == 700, endless, 1.0)}
        with pytest.raises(InputError, match=r"the reference has no number for a at 0\.7 s"):
            compare(ramp(), far, tube_time=0.0, tube_value=None)


def test_the_first_signal_its_time_and_excess() -> None:
    reference = {"time": TIMES, "a": np.zeros(2001), "b": np.zeros(2001)}
    result = {"time": TIMES, "a": np.where(TIMES > 1.5, 0.4, 0.0),
              "b": np.where(TIMES > 0.5, -0.3, 0.0)}
    found = compare(result, reference, tube_time=0.0, tube_value=0.1)
    assert [e.signal for e in found] == ["b", "a"]
    assert found[0].time == pytest.approx(0.501) and found[0].excess == pytest.approx(0.2)


def test_what_is_no_number_later_hides_no_excess() -> None:
    result = ramp() | {"a": np.where(TIMES > 1.5, np.nan, ramp()["a"] + 0.3 * (TIMES > 0.5))}
    (found,) = compare(result, ramp(), tube_time=0.0, tube_value=0.1)
    assert str(found) == "a leaves its tube at 0.501 s by 0.2 (at most by 0.2)"


def test_an_excess_has_the_unit_of_the_signal() -> None:
    name = "load.velocity.x"
    own, other = ({"time": TIMES, name: np.full(2001, value)} for value in (0.0, 0.3))
    (found,) = compare(own, other, tube_time=0.0, tube_value=0.1)
    assert str(found) == f"{name} leaves its tube at 0 s by 0.2 m/s (at most by 0.2 m/s)"


def test_other_rows_and_what_is_no_number() -> None:
    coarse = {n: v[::7] for n, v in ramp().items()}
    coarse = {n: np.append(v, ramp()[n][-1]) for n, v in coarse.items()}
    assert not compare(coarse, ramp(), tube_time=0.0, tube_value=1e-12)
    broken = {"time": TIMES, "a": np.where(TIMES > 1.0, np.nan, ramp()["a"])}
    assert compare(broken, ramp(), tube_time=0.0, tube_value=1.0)


def test_refusals() -> None:
    short = {n: v[:1000] for n, v in ramp().items()}
    for result, wide in ((short, 0.0), ({"time": TIMES}, 0.0), (ramp(), -1.0)):
        with pytest.raises(InputError):
            compare(result, ramp(), tube_time=wide, tube_value=1.0)


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The same scenario as it is, with half the step, and with one gain 1 % higher."""
    require_native()
    folder = tmp_path_factory.mktemp("runs")
    head = f'base = "{(SUITE / "initial_sway.toml").as_posix()}"\n'
    texts = {
        "reference": head + "step = 0.005\n", "half": head + "step = 0.0025\n",
        "gain": head + '[controller]\ndesign = "flatness"\nbandwidth = 1.111\n',
        "flat": head + '[controller]\ndesign = "flatness"\nbandwidth = 1.1\n',
        "flat_half": head + 'step = 0.0025\n[controller]\ndesign = "flatness"\nbandwidth = 1.1\n',
    }
    with Runner() as runner:
        for name, text in texts.items():
            (folder / f"{name}.toml").write_text(text, encoding="utf-8")
            result = runner.run(load_scenario(folder / f"{name}.toml"))
            assert result.rows is not None
            load = [f"load.position.{a}" for a in "xyz"]
            write_csv(folder / f"{name}.csv", result.rows[["time", *load, "sway.total"]])
    return {name: folder / f"{name}.csv" for name in texts}


def judged(monkeypatch: pytest.MonkeyPatch, *paths: Path) -> int:
    tubes = ["--tube-time", "0.0", "--tube-value", "5e-4", "--relative"]
    monkeypatch.setattr(sys, "argv", ["segfmu", "compare", *map(str, paths), *tubes])
    return cli.run()


@pytest.mark.parametrize("pair", [("half", "reference"), ("flat_half", "flat")])
def test_half_the_step_is_the_same(
    pair: tuple[str, str], runs: dict[str, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert judged(monkeypatch, *(runs[name] for name in pair)) == 0


def test_one_per_cent_of_a_gain_is_found(
    runs: dict[str, Path], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert judged(monkeypatch, runs["gain"], runs["flat"]) == 1
    assert "leaves its tube at" in capsys.readouterr().out


def test_a_signal_that_the_result_has_not_is_told_with_one_alike() -> None:
    times = {"time": np.linspace(0.0, 1.0, 5)}
    words = "no signal sway.x.angel, which the reference has; did you mean sway.x.angle?"
    with pytest.raises(InputError, match=re.escape(words)):
        compare(times | {"sway.x.angle": times["time"]}, times | {"sway.x.angel": times["time"]},
                tube_time=0.0, tube_value=0.0)


def test_a_tube_has_a_width() -> None:
    for wide in ({"tube_time": np.inf, "tube_value": 0.1}, {"tube_time": 0.0, "tube_value": -1.0}):
        with pytest.raises(InputError, match="tubes must be finite and at least 0, got"):
            compare(ramp(), ramp(), **wide)


def test_a_reference_without_signals_is_no_agreement() -> None:
    times = {"time": np.linspace(0.0, 1.0, 5)}
    with pytest.raises(InputError, match=r"^the reference has no signal beside time: nothing"):
        compare(times | {"a": times["time"]}, times, tube_time=0.0, tube_value=0.0)
