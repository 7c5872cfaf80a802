"""Many steps of 1 ms under commands, a million in a soak: places, clocks, memory do not drift."""

from __future__ import annotations

import resource
import sys
from collections.abc import Callable

import numpy as np
import pytest
from benchmarks.operated import SITES, Site

from tests.campaign import campaign, soaked
from tests.fmu.gantry_feedforward.test_commands import LOAD, begun, named
from tests.fmu.native.importer import Importer

STEP = 1e-3
# of a command, and of the way back to the start
HELD, BACK = 300, 14_000
# what a round may add to the memory in use [kB]
ROOM = 2048

Motion = Callable[[int, dict], np.ndarray]


def command(site: Site, random: np.random.Generator) -> dict:
    """A velocity, a stop, or a target near the start."""
    most = np.asarray(site.limits.velocity)
    return {
        "mode": str(random.choice(["velocity", "velocity", "stop", "target"])),
        "velocity": random.uniform(-most, most),
        "target": np.asarray(site.start) + most * random.uniform(-1.0, 1.0, 3),
        "scale": float(random.choice([1.0, 0.5])),
    }


def memory() -> int:
    """Most memory that this process has had [kB]."""
    found = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return found // 1024 if sys.platform == "darwin" else found


def rounding(site: Site) -> float:
    """The last digits of a place in the workspace [m], in the last round as in the first."""
    reach = np.abs([site.clearance.minimum, site.clearance.maximum]).max()
    return float(16.0 * np.finfo(float).eps * reach)


def drifts(site: Site, steps: int, move: Motion) -> tuple[np.ndarray, int]:
    """How far the load is from the start [m] after each round, and what memory was added [kB].

    A round is random commands, then the way back; move: makes steps under a command.
    """
    random = np.random.default_rng(17)
    back = {"mode": "target", "velocity": np.zeros(3), "target": site.start, "scale": 1.0}
    slow = round(BACK * (site.step / 0.02) ** 0.75)
    found, done, used = [], 0, 0
    while done < steps:
        for _ in range(20):
            move(HELD, command(site, random))
        load = move(slow, back)
        done += 20 * HELD + slow
        found.append(np.abs(load[0] - site.start).max())
        assert np.abs(load[1:]).max() < 1e-9, "the load does not rest"
        if len(found) == 1:
            used = memory()
    return np.array(found), memory() - used


@campaign(60_000, 1_000_000, "steps")
@pytest.mark.parametrize("name", ["lab", *soaked("port")])
def test_an_operator_does_not_drift(name: str, steps: int) -> None:
    site = SITES[name]
    operator = site.operator()
    count = 0

    def move(number: int, wanted: dict) -> np.ndarray:
        nonlocal count
        operator.command(**wanted)
        for _ in range(number):
            load = operator.step(STEP)
        count += number
        return load

    places, added = drifts(site, steps, move)
    assert count >= steps and operator.plans > count / 5000
    assert places.max() <= rounding(site)
    assert operator.time == pytest.approx(count * STEP, rel=2e-16, abs=0.0)
    assert added <= ROOM


@campaign(60_000, 1_000_000, "steps")
@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", ["port", *soaked("lab")])
def test_an_fmu_does_not_drift(native_fmus, name: str, fmi: int, steps: int) -> None:
    site, count = SITES[name], 0
    with Importer(native_fmus[fmi][0]) as fmu:
        begun(fmu, site)

        def move(number: int, wanted: dict) -> np.ndarray:
            nonlocal count
            fmu.set(named(wanted))
            for i in range(count, count + number):
                fmu.step(i * STEP, STEP)
            count += number
            return fmu.get(*LOAD).reshape(5, 3)

        places, added = drifts(site, steps, move)
        assert count >= steps
        assert places.max() <= rounding(site)
        assert added <= ROOM
