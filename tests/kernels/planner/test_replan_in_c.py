"""The C entry points of replanning, in a program without Python, give what Python's give."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from segfmu import Limits, Waypoint, plan, replan, stop
from segfmu.codegen.native import TARGET
from tests.compiler import CC, needs_cc

pytestmark = needs_cc
LIMITS = Limits([1.0, 0.8], 1.0, [4.0, 3.0], 20.0)


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The driver, compiled from the sources that ship."""
    program = tmp_path_factory.mktemp("driver") / "driver"
    names = ("replan.c", "velocity.c", "lead.c", "plan.c", "kernels.c")
    sources = [Path(__file__).with_name("replan_driver.c"), *(TARGET / name for name in names)]
    flags = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-ffp-contract=off", "-O1"]
    unused = ["-Wno-unused-variable", "-Wno-unused-but-set-variable"]
    subprocess.run(
        [CC, *flags, *unused, f"-I{TARGET}", *sources, "-lm", "-o", program], check=True
    )
    return program


@pytest.mark.parametrize("n", [3, 4, 5, 6])
@pytest.mark.parametrize(
    "share", [5e-324, 1e-15, 1e-11, 0.05, 0.2, 0.5, 0.8, 1.0 - 1e-5, 1.0 - 1e-9, 1.0 - 1e-15, 1.0]
)
def test_c_replans_as_python_does(driver: Path, n: int, share: float) -> None:
    old = plan([Waypoint([0.0, 0.0]), Waypoint([1.0, 0.5])], LIMITS, smoothness=n)
    time = share * old.duration
    table = LIMITS.table(2, n)
    text = " ".join(str(x) for x in [n, time, *table.ravel()])
    done = subprocess.run(
        [driver], input=text, capture_output=True, text=True, check=True, timeout=20
    )
    rows = [[float(x) for x in line.split()] for line in done.stdout.splitlines()]
    expected = [
        old, replan(old, time, Waypoint([1.0, 0.5])), replan(old, time, Waypoint([0.2, -0.4])),
        stop(old, time),
    ]
    for row, found in zip(rows, expected, strict=True):
        assert row[0] == 0.0
        assert row[1] == pytest.approx(found.duration, rel=1e-12)
        assert row[2 : n + 3] == pytest.approx(
            [float(found(0.0, d)[0]) for d in range(n + 1)], rel=1e-9, abs=1e-9
        )
        assert row[n + 3 :] == pytest.approx(found(found.duration).tolist(), abs=1e-12)
