"""`segfmu identify`: what it writes is what the call finds, in the user's own file."""

from __future__ import annotations

import json
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import tomlkit
from benchmarks.synthetic_logs import synthetic

import segfmu
from segfmu import cli
from segfmu.errors import InputError
from tests.validation.identification.swapped import swapped

CRANE = """# a crane
bridge_mass = 2.2      # kg, data sheet
trolley_mass = 1.155
payload_mass = 1.0     # kg, weighed
drive = "velocity"
sensors.sway_x = { zero = 0.1 }
trolley.lag = 0.02   # s, guess
trolley.velocity_max = 3.0
# more
"""
KEYS = ["trolley.lag", "sensors.sway_x.zero", "hoist.dead_time", "payload_mass"]


def files(folder: Path) -> tuple[Path, Path]:
    made = synthetic("lab", "velocity", 3, rows=100)
    log, path, crane = made.columns, folder / "log.csv", folder / "crane.toml"
    table = np.stack(list(log.values()), axis=1)
    np.savetxt(path, table, delimiter=",", header=",".join(log), comments="")
    known = made.crane_without(*KEYS)
    told = {f"{a}.{n}": known[a][n] for a in ("bridge", "hoist") for n in known[a]}
    told["trolley.dead_time"] = known["trolley"]["dead_time"]
    for name in ("rope", "sway_y"):
        told[f"sensors.{name}.zero"] = known["sensors"][name]["zero"]
    lines = "".join(f"{key} = {value}\n" for key, value in told.items())
    crane.write_text(CRANE.replace("# more\n", lines), encoding="utf-8")
    return path, crane


def test_the_command_writes_what_the_call_finds(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    log, crane = files(tmp_path)
    out = tmp_path / "out"
    options = [word for key in KEYS for word in ("--fit", key)]
    cli.app(
        ["identify", str(log), "--crane", str(crane), "-o", str(out), *options],
        standalone_mode=False,
    )
    told = capsys.readouterr().out
    assert "payload_mass is not told; kept at 1 kg" in told and "load's path" in told
    found = segfmu.identify(str(log), crane, fit=KEYS)
    assert repr(found).startswith("<Identification: trolley.lag ")
    assert found.plot().get_suptitle().endswith(", only predicted")
    assert replace(found, predicted=()).plot().get_suptitle().endswith(", fitted")
    assert repr(replace(found, estimates=())).startswith("<Identification: the logs tell nothing; ")
    results = json.loads((out / "identification.json").read_text(encoding="utf-8"))
    lag = found["trolley.lag"]
    assert results["estimates"][0] == {
        "key": "trolley.lag", "unit": "s", "before": 0.02, "value": lag.value, "low": lag.low,
        "high": lag.high,
    }
    text = (out / "crane.toml").read_text(encoding="utf-8")
    (line,) = [line for line in text.splitlines() if line.startswith("trolley.lag = ")]
    assert line.endswith("(95 %), identified from log.csv, " + line.split(", ")[-1])
    assert "kg, weighed; not told by log.csv" in text and "# a crane" in text
    content = tomllib.loads(text)
    width = lag.high - lag.low
    assert content["trolley"]["lag"] == pytest.approx(lag.value, abs=0.01 * width)
    assert content["sensors"]["sway_x"]["zero"] == pytest.approx(
        found["sensors.sway_x.zero"].value, abs=1e-3
    )
    assert content["hoist"]["dead_time"] > 0.0 and content["trolley"]["velocity_max"] == 3.0
    assert (out / "identification.png").stat().st_size > 10_000


def test_a_log_of_a_crane_at_rest_has_its_results(tmp_path: Path) -> None:
    """The fit of a load that rests is no number, which JSON has not."""
    log, crane = files(tmp_path)
    names = log.read_text(encoding="utf-8").splitlines()[0].split(",")
    table = np.zeros((60, len(names)))
    table[:, names.index("time")] = 0.01 * np.arange(60)
    # whose mean is another number, by rounding
    table[:, names.index("measured.rope.length")] = 0.7
    table[:, names.index("measured.trolley.position")] = 0.1
    np.savetxt(log, table, delimiter=",", header=",".join(names), comments="")
    out = tmp_path / "out"
    cli.app(
        ["identify", str(log), "--crane", str(crane), "-o", str(out), "--fit", "trolley.lag"],
        standalone_mode=False,
    )
    results = json.loads((out / "identification.json").read_text(encoding="utf-8"))
    assert results["fitted"][0]["load"] is None and results["estimates"] == []
    assert all(one["index"] is None for one in results["fitted"][0]["signals"])


def test_a_crane_without_a_file_is_written_too(tmp_path: Path) -> None:
    log = synthetic("lab", "velocity", 3, rows=100)
    crane = log.crane_without("trolley.lag")
    found = segfmu.identify(log.columns, crane, fit=["trolley.lag"])
    written = found.write(tmp_path / "crane.toml").read_text(encoding="utf-8")
    assert tomllib.loads(written)["bridge_mass"] == log.crane["bridge_mass"]
    with pytest.raises(KeyError):
        found["bridge.lag"]


def test_an_estimate_that_no_crane_file_may_have_is_not_written(tmp_path: Path) -> None:
    log = synthetic("lab", "force", 2, rows=100)
    crane = log.crane_without("payload_mass") | {"load": {"mass_range": [0.999, 1.001]}}
    found = segfmu.identify(log.columns, crane, fit=["payload_mass"])
    with pytest.raises(InputError, match=r"payload_mass: .* is outside load\.mass_range"):
        found.write(tmp_path / "crane.toml")
    assert not list(tmp_path.iterdir())


def test_columns_that_are_swapped_leave_no_files(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A crane file with a rope longer by far than the measured one was written."""
    columns, known = swapped()
    log, crane = tmp_path / "log.csv", tmp_path / "crane.toml"
    table = np.stack(list(columns.values()), axis=1)
    np.savetxt(log, table, delimiter=",", header=",".join(columns), comments="")
    crane.write_text(tomlkit.dumps(known), encoding="utf-8")
    with pytest.raises(InputError, match=r"no crane has sensors\.rope\.zero .* are swapped"):
        cli.app(
            ["identify", str(log), "--crane", str(crane), "-o", str(tmp_path / "out"),
             "--fit", "sensors.rope.zero", "--fit", "sensors.sway_y.zero"],
            standalone_mode=False,
        )
    assert "the fitted crane does not follow measured.sway." in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_column_option_without_a_name_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="--column rope: must be NAME=COLUMN"):
        cli.app(
            ["identify", "log.csv", "--crane", "crane.toml", "--column", "rope", "-o",
             str(tmp_path)],
            standalone_mode=False,
        )
