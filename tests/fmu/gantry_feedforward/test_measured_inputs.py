"""Measured states as inputs that change while the FMU runs, nonsense among them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.gantry_feedforward import interface
from segfmu.kernels.operation.records import MEASURED, OperationStatus
from tests.compiler import require_native
from tests.fmu.gantry_feedforward.test_commands import LOAD, SITES, arrays, named
from tests.fmu.gantry_feedforward.test_measured import STILL, given, measured, operator_of, swing_of
from tests.fmu.native.importer import Importer

NONSENSE: dict[str, dict[str, float]] = {
    "no rope": {"measured.rope.length": 0.0},
    "a rope upwards": {"measured.rope.length": -0.5},
    "a rope without end": {"measured.rope.length": 1e20},
    "a load above its crane": {"measured.sway.x.angle": 2.5},
    "a load beside its crane": {"measured.sway.y.angle": -1.57},
    "a load that spins": {"measured.sway.y.rate": 1e6},
    "a load as fast as light": {"measured.sway.x.rate": 3e8, "measured.rope.velocity": -3e8},
    "a bridge elsewhere": {"measured.bridge.position": 1e12},
    "a trolley that flies": {"measured.trolley.velocity": 1e9},
    "a hoist that falls": {"measured.rope.velocity": 1e3},
    "all at once": {f"measured.{n}": (-1.0) ** i * 1e20 for i, n in enumerate(MEASURED)},
}
NO_NUMBERS = (float("nan"), float("inf"), -float("inf"))


@pytest.fixture(scope="module")
def connectable(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """Archives in which commands are inputs, by version of FMI."""
    require_native()
    return {
        fmi: build_all(
            tmp_path_factory.mktemp(f"measured{fmi}"), Choice(True, fmi, connected=True),
            [interface.spec()],
        )[0]
        for fmi in (2, 3)
    }


def begun(fmu: Importer, name: str) -> None:
    """A load that rests, under a stop."""
    fmu.set(arrays(fmu, given(name)))
    fmu.initialise()
    fmu.set(named(STILL))


def number(fmu: Importer, name: str) -> int:
    """Value of an Integer."""
    read = fmu.fmu.getInt32 if fmu.three else fmu.fmu.getInteger
    return int(read([fmu.variables[name].valueReference])[0])


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", SITES)
def test_each_rise_takes_the_inputs_of_its_step_over(
    connectable, name: str, fmi: int
) -> None:
    """What is measured changes with each step; the one at which the input rises counts."""
    site, random = SITES[name], np.random.default_rng(5)
    size = np.array([0.2, 0.2, 0.1, 1.0, 1.0, 0.3, 0.3, 0.1, 1.0, 1.0])
    state, rope = swing_of(site), -site.start[2]
    operator = operator_of(name, np.array([0.0, 0.0, rope] + [0.0] * 7))
    operator.command(**STILL)
    taken = 0
    with Importer(connectable[fmi]) as fmu:
        begun(fmu, name)
        for i in range(160):
            now = state * (1.0 + size * random.uniform(-0.5, 0.5, state.size))
            rises = i % 40 == 7
            fmu.set(measured(now) | {"command.take_over": i % 40 in (7, 8, 9)})
            fmu.step(i * site.step, site.step)
            if rises:
                operator.take_over(now)
                taken += 1
            load = operator.step(site.step)
            # the clocks differ by rounding errors, which what is found for a swing enlarges
            np.testing.assert_allclose(
                fmu.get(*LOAD[:6]), load[:2].ravel(), rtol=0.0, atol=1e-7 * rope
            )
    assert taken == 4


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", SITES)
def test_nonsense_is_refused_and_the_plan_goes_on(connectable, name: str, fmi: int) -> None:
    site = SITES[name]
    moves: dict[str, Any] = STILL | {"mode": "velocity", "velocity": 0.3 * np.array([
        0.0, float(site.limits.velocity[1]), 0.0
    ])}
    state = swing_of(site)
    with Importer(connectable[fmi]) as fmu, Importer(connectable[fmi]) as other:
        for one in (fmu, other):
            begun(one, name)
            one.set(named(moves))
        for i in range(10):
            fmu.step(i * site.step, site.step)
            other.step(i * site.step, site.step)
        for values in NONSENSE.values():
            for risen in (True, False):
                i += 1
                fmu.set(measured(state) | values | {"command.take_over": risen})
                fmu.step(i * site.step, site.step)
                other.step(i * site.step, site.step)
                if risen:
                    assert number(fmu, "plan.refused") != OperationStatus.TAKEN
                np.testing.assert_array_equal(fmu.get(*LOAD), other.get(*LOAD))
        # a state of a load is taken over as if nothing had been
        for one in (fmu, other):
            one.set(measured(state) | {"command.take_over": True})
            one.step((i + 1) * site.step, site.step)
        assert number(fmu, "plan.status") == number(other, "plan.status")
        np.testing.assert_array_equal(fmu.get(*LOAD), other.get(*LOAD))
        assert np.isfinite(fmu.get(*LOAD)).all()


@pytest.mark.parametrize("fmi", [2, 3])
def test_what_is_no_number_is_refused_by_name(connectable, fmi: int) -> None:
    site, state = SITES["lab"], swing_of(SITES["lab"])
    with Importer(connectable[fmi]) as fmu:
        begun(fmu, "lab")
        fmu.step(0.0, site.step)
        for name in (f"measured.{n}" for n in MEASURED):
            for value in NO_NUMBERS:
                with pytest.raises(Exception, match="failed with status"):
                    fmu.set({name: value})
                assert name in fmu.messages[-1]
        # it goes on with what was set before
        fmu.step(site.step, site.step)
        fmu.set(measured(state) | {"command.take_over": True})
        fmu.step(2.0 * site.step, site.step)
        assert number(fmu, "plan.status") == OperationStatus.TAKEN
        expected = operator_of("lab", state).step(site.step)
        np.testing.assert_allclose(fmu.get(*LOAD[:6]), expected[:2].ravel(), rtol=0.0, atol=1e-7)
