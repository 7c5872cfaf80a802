"""Derivatives that native FMUs give against finite differences of their own values."""

from __future__ import annotations

import ctypes
from collections.abc import Callable

import numpy as np
import pytest

from segfmu import plan
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.hook_crane import interface as hook_crane
from segfmu.fmu.standard.spec import Spec
from tests.fmu.native.importer import Importer
from tests.fmu.python.test_slaves import LIMITS, POINTS
from tests.fmu.test_drive_compensation import DRIVEN

FRICTION = {
    "friction.bridge.viscous": 3.0, "friction.trolley.coulomb": 0.4, "friction.width": 0.3,
    "friction.presliding": 0.5, "friction.trolley.static": 0.6, "friction.hoist.coulomb": 0.3,
    "friction.hoist.viscous": 2.0, "friction.sway.viscous": 0.03, "wind.noise.deviation.x": 0.3,
    "wind.gust.start": -1.0, "wind.gust.duration": 3.0, "wind.gust.force.y": 0.4,
}
VELOCITY = {
    "drive.mode": "velocity", "feedback.design": "flatness", "drive.bridge.lag": 0.05,
    "drive.trolley.lag": 0.04, "drive.hoist.lag": 0.03,
}
CASES = {
    "force": {}, "friction": FRICTION, "velocity": VELOCITY | FRICTION,
    "saturated": {"drive.bridge.force_max": 0.1, **FRICTION},
    "clamped": {**VELOCITY, "drive.bridge.acceleration_max": 0.1},
    "air": {"wind.speed.x": 3.0, "wind.speed.y": -2.0, "wind.gust.speed.z": 1.0,
            "wind.turbulence.deviation.x": 0.5, "load.drag_area": 0.4, **FRICTION},
    "driven in air": {**VELOCITY, "wind.speed.x": 3.0, "load.drag_area": 0.4},
    "buffers": {"travel.bridge.min": 1.0, "travel.trolley.max": -1.0, "travel.rope.max": 0.1,
                **{f"travel.{a}.stiffness": 20.0 for a in ("bridge", "trolley", "rope")},
                "travel.trolley.damping": 3.0, "travel.rope.damping": 2.0},
    "clipped": {**VELOCITY, "drive.trolley.velocity_max": 0.05},
    "clipped below": {**VELOCITY, "drive.trolley.velocity_min": -0.05,
                      "drive.bridge.acceleration_min": -0.1, "drive.hoist.velocity_min": -0.02},
    "saturated below": {"drive.trolley.force_min": -0.1, "drive.bridge.force_min": -0.2,
                        "drive.bridge.power_max": 0.01, **FRICTION},
    "power": {"drive.bridge.power_max": 0.01, "drive.hoist.power_max": 0.3, **FRICTION},
}


def directional(fmu: Importer, unknowns: list[str], knowns: list[str]) -> np.ndarray:
    """Jacobian by one directional derivative a known, (unknowns, knowns)."""
    references = [fmu.variables[n].valueReference for n in unknowns]
    columns = [
        fmu.fmu.getDirectionalDerivative(references, [fmu.variables[n].valueReference], [1.0])
        for n in knowns
    ]
    return np.array(columns).T


GANTRY = gantry_crane.native_spec()


class Point:
    """A crane in continuous-time mode whose states, inputs and time can be moved."""

    def __init__(self, fmu: Importer, seed: int, spec: Spec = GANTRY) -> None:
        random = np.random.default_rng(seed)
        self.fmu = fmu
        self.states = tuple(name for name, _ in spec.states)
        self.inputs = tuple(v.name for v in spec.where("input"))
        state = random.uniform(-0.4, 0.4, len(self.states))
        state[2] = 0.8 + state[2]
        self.place = np.concatenate([state, random.uniform(-1.0, 1.0, len(self.inputs)), [0.005]])
        # FMI 2.0 has no variable for time
        self.names = (*self.states, *self.inputs, *(["time"] if fmu.three else []))

    def go(self, place: np.ndarray) -> None:
        fmu, n = self.fmu, len(self.states)
        fmu.fmu.setTime(place[-1])
        fmu.fmu.setContinuousStates((ctypes.c_double * n)(*place[:n]), n)
        fmu.write(self.inputs, place[n:-1])

    def differences(self, unknowns: list[str]) -> np.ndarray:
        columns = []
        for i in range(len(self.names)):
            rows = []
            for sign in (-1.0, 1.0):
                moved = self.place.copy()
                moved[i] += sign * 1e-5
                self.go(moved)
                rows.append(self.fmu.get(*unknowns))
            columns.append((rows[1] - rows[0]) / 2e-5)
        self.go(self.place)
        return np.array(columns).T


INPUTS = tuple(v.name for v in gantry_crane.spec().where("input"))


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("case", CASES)
def test_crane_in_every_direction(native_fmus, fmi: int, case: str) -> None:
    with Importer(native_fmus[fmi][1], "ModelExchange") as fmu:
        fmu.set(CASES[case] | {"rope.length": 0.8, "sway.x.angle": 0.1})
        fmu.initialise()
        unknowns = [
            n for n, v in fmu.variables.items()
            if v.causality in ("output", "local") and v.variability == "continuous"
        ]
        for seed in range(4):
            point = Point(fmu, seed)
            point.go(point.place)
            found = directional(fmu, unknowns, list(point.names))
            expected = point.differences(unknowns)
            scale = np.maximum(np.abs(expected), 1.0)
            worst = np.unravel_index(np.argmax(np.abs(found - expected) / scale), found.shape)
            assert np.abs(found - expected)[worst] <= 1e-6 * scale[worst], (
                unknowns[worst[0]], point.names[worst[1]], found[worst], expected[worst]
            )


def dependencies(fmu: Importer) -> dict[str, set[str]]:
    """What the structure says of each continuous output and derivative."""
    found = fmu.description
    listed = {
        u.variable.name: {v.name for v in u.dependencies}
        for u in (*found.outputs, *found.derivatives)
    }
    return {n: used for n, used in listed.items() if fmu.variables[n].variability == "continuous"}


def require_named(listed: dict[str, set[str]], point: Point, jacobian: np.ndarray) -> None:
    """Where the structure says nothing, the derivative is zero."""
    for row, (unknown, named) in zip(jacobian, listed.items(), strict=True):
        used = {n for n, x in zip(point.names, row, strict=True) if x != 0.0}
        assert used <= named, (unknown, used - named)


def test_structure_names_every_dependency(native_fmus) -> None:
    with Importer(native_fmus[2][1], "ModelExchange") as fmu:
        fmu.set(CASES["friction"])
        fmu.initialise()
        point = Point(fmu, 1)
        point.go(point.place)
        listed = dependencies(fmu)
        require_named(listed, point, directional(fmu, list(listed), list(point.names)))


@pytest.mark.parametrize("case", ["force", "friction", "driven in air", "buffers"])
def test_structure_names_every_dependency_with_a_hook(hook_fmus, case: str) -> None:
    """By differences, as this crane has no directional derivatives."""
    spec = hook_crane.native_spec()
    with Importer(hook_fmus[2][1], "ModelExchange") as fmu:
        fmu.set(CASES[case] | {"rope.length": 0.8, "sling.x.angle": 0.1})
        fmu.initialise()
        point = Point(fmu, 2, spec)
        point.go(point.place)
        listed = dependencies(fmu)
        assert {"sling.tension", "hook.position.x", "sway.frequency.slow"} <= set(listed)
        require_named(listed, point, point.differences(list(listed)))


def longest_pieces(fmu: Importer, count: int) -> np.ndarray:
    """The middles of the longest polynomial pieces of the plan, in order."""
    breaks = [0.0]
    while (following := float(fmu.get("plan.next_event")[0])) < fmu.get("plan.duration")[0]:
        fmu.step(breaks[-1], following - breaks[-1])
        breaks.append(following)
    times = np.array(breaks)
    chosen = np.sort(np.argsort(np.diff(times))[-count:])
    return 0.5 * (times[chosen] + times[chosen + 1])


def continuous_outputs(
    fmu: Importer,
) -> tuple[list[str], list[int], Callable[[list[int], list[int]], list[float]]]:
    """Names of the continuous outputs, their references, and what reads their derivatives."""
    names = [
        n for n, v in fmu.variables.items()
        if v.causality == "output" and v.variability == "continuous"
    ]
    library = fmu.fmu
    read = library.getOutputDerivatives if fmu.three else library.getRealOutputDerivatives
    return names, [fmu.variables[n].valueReference for n in names], read


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("values", [{}, DRIVEN], ids=["ideal", "drives"])
def test_feedforward_over_time(native_fmus, fmi: int, order: int, values) -> None:
    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.set(values)
        fmu.initialise()
        targets = longest_pieces(fmu, 3)
    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.set(values)
        fmu.initialise()
        names, references, read = continuous_outputs(fmu)

        def outputs(which: int) -> np.ndarray:
            return np.array(
                read(references, [which] * len(names)) if which else fmu.get(*names)
            )

        # five points within one polynomial piece: the error is of the fourth power of the step
        time, h = 0.0, 1e-3
        for target in targets:
            rows = []
            for k in range(-2, 3):
                fmu.step(time, target + k * h - time)
                time = target + k * h
                rows.append(outputs(order - 1))
                if k == 0:
                    found = outputs(order)
            quotient = (rows[0] - 8.0 * rows[1] + 8.0 * rows[3] - rows[4]) / (12.0 * h)
            scale = np.maximum(np.abs(quotient), 1.0)
            assert (np.abs(found - quotient) <= 1e-6 * scale).all()


def test_feedforward_by_time_is_its_first_output_derivative(native_fmus) -> None:
    with Importer(native_fmus[3][0]) as fmu:
        fmu.initialise()
        fmu.step(0.0, 0.7)
        names = ["force.bridge", "reference.sway.x.angle", "reference.load.jerk.y"]
        found = directional(fmu, names, ["time"])[:, 0]
        references = [fmu.variables[n].valueReference for n in names]
        assert found.tolist() == fmu.fmu.getOutputDerivatives(references, [1] * 3)
        assert found[1] == pytest.approx(fmu.get("reference.sway.x.rate")[0], rel=1e-12)
        adjoint = fmu.fmu.getAdjointDerivative(
            references, [fmu.variables["time"].valueReference], [1.0, 2.0, 3.0], 1
        )
        assert adjoint[0] == pytest.approx(found @ [1.0, 2.0, 3.0])


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("case", ["force", "friction", "velocity", "clamped"])
def test_crane_outputs_over_time(native_fmus, fmi: int, case: str) -> None:
    random = np.random.default_rng(7)
    rates = random.uniform(-0.5, 0.5, len(INPUTS))
    start = np.zeros(len(INPUTS))
    start[2] = -9.81
    with Importer(native_fmus[fmi][1]) as fmu:
        fmu.set(CASES[case] | {"feedback.enabled": 0, "sway.x.angle": 0.1, "sway.y.rate": 0.2,
                               "bridge.velocity": 0.1})
        fmu.write(INPUTS, start)
        fmu.initialise()
        names, references, read = continuous_outputs(fmu)
        h, rows = 1e-4, []
        for i in range(1, 304):
            fmu.write(INPUTS, start + rates * i * h)
            fmu.step((i - 1) * h, h)
            if i >= 299:
                rows.append(fmu.get(*names))
            if i == 301:
                found = np.array(read(references, [1] * len(names)))
        quotient = (rows[0] - 8.0 * rows[1] + 8.0 * rows[3] - rows[4]) / (12.0 * h)
        scale = np.maximum(np.abs(quotient), 1.0)
        worst = int(np.argmax(np.abs(found - quotient) / scale))
        assert abs(found - quotient)[worst] <= 1e-6 * scale[worst], (
            names[worst], found[worst], quotient[worst]
        )


def polynomial(coefficients: np.ndarray, time: float, order: int = 0) -> np.ndarray:
    """Inputs, cubic in time, or their derivatives."""
    derived = np.polynomial.polynomial.polyder(coefficients, order)
    return np.polynomial.polynomial.polyval(time, derived)


@pytest.mark.parametrize(
    "values",
    [
        {"feedback.enabled": 0},
        {"feedback.design": 2, "feedback.sample_time": 0.007},
        {"drive.mode": 2, "feedback.design": 2, "drive.bridge.lag": 0.02, "drive.trolley.lag": 0.03,
         "drive.hoist.lag": 0.02},
    ],
    ids=["force", "feedback", "velocity"],
)
def test_input_derivatives_make_inputs_cubic_in_a_step(native_fmus, values) -> None:
    """Steps of 40 ms by three derivatives against tiny ones of the same inputs, linear in each."""
    random = np.random.default_rng(11)
    coefficients = random.uniform(-0.3, 0.3, (4, len(INPUTS))) * [[1.0], [1.0], [2.0], [6.0]]
    coefficients[0, 2], coefficients[0, 5:11] = -9.81, 0.0
    coefficients[0, INPUTS.index("reference.rope.length")] = 0.5
    names = [*gantry_crane.STATE, "energy.drives", "error.load.x"]
    ends = []
    for step, by_derivatives in ((0.04, True), (5e-5, False)):
        with Importer(native_fmus[2][1]) as fmu:
            references = [fmu.variables[n].valueReference for n in INPUTS]
            fmu.set(values)
            fmu.write(INPUTS, polynomial(coefficients, 0.0))
            fmu.initialise()
            for i in range(round(0.2 / step)):
                if by_derivatives:
                    for order in (1, 2, 3):
                        given = polynomial(coefficients, i * step, order)
                        fmu.fmu.setRealInputDerivatives(
                            references, [order] * len(references), given.tolist()
                        )
                else:
                    fmu.write(INPUTS, polynomial(coefficients, (i + 1) * step))
                fmu.step(i * step, step)
                fmu.write(INPUTS, polynomial(coefficients, (i + 1) * step))
            ends.append(fmu.get(*names))
    assert ends[0] == pytest.approx(ends[1], abs=2e-8)
    assert np.abs(ends[0][:5]).max() > 1e-3


@pytest.mark.parametrize("order", [0, 4])
def test_input_derivatives_have_orders_1_to_3(native_fmus, order: int) -> None:
    with Importer(native_fmus[2][1]) as fmu:
        fmu.initialise()
        with pytest.raises(Exception, match="fmi2SetRealInputDerivatives"):
            fmu.fmu.setRealInputDerivatives([1], [order], [1.0])
        assert f"takes no derivative of order {order}" in fmu.messages[-1]


def test_output_derivatives_at_a_kink_are_those_behind_it(native_fmus) -> None:
    trajectory = plan(POINTS, LIMITS)
    with Importer(native_fmus[2][0]) as fmu:
        fmu.initialise()
        snaps = [fmu.variables[f"reference.load.snap.{a}"].valueReference for a in "xyz"]
        time = 0.0
        for event in trajectory.events[1:]:
            fmu.step(time, event - time)
            time = float(event)
            found = fmu.fmu.getRealOutputDerivatives(snaps, [1] * 3)
            assert found == pytest.approx(trajectory(time + 1e-7, 5), rel=1e-3, abs=1e-2)
    assert found == [0.0, 0.0, 0.0]


def test_what_has_no_derivative_is_refused(native_fmus) -> None:
    with Importer(native_fmus[2][0]) as fmu:
        fmu.initialise()
        for unknown, known in (
            ("force.bridge", "crane.gravity"), ("plan.duration", "limits.x.snap"),
        ):
            with pytest.raises(Exception, match="fmi2GetDirectionalDerivative"):
                directional(fmu, [unknown], [known])
            assert f"no derivative of {unknown} by {known}" in fmu.messages[-1]
        with pytest.raises(Exception, match="fmi2GetRealOutputDerivatives"):
            fmu.fmu.getRealOutputDerivatives([1], [4])
        assert "force.bridge has no derivative of order 4" in fmu.messages[-1]
