"""CasADi as an importer of model exchange: both versions, values, Jacobians, integration.

CasADi knows derivatives, states and outputs as variables of their own, sets states one by one, and
lets no event happen: it evaluates the equations between events.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import casadi
import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.fmu.gantry_crane import interface as gantry_crane
from tests.fmu.native.importer import Importer
from tests.fmu.native.test_derivatives import CASES, INPUTS

QUAY = {
    "crane.bridge_mass": 3e5, "crane.trolley_mass": 15e3, "crane.payload_mass": 4e4,
    "crane.rope_min": 8.0, "crane.rope_max": 45.0, "friction.trolley.viscous": 2e3,
    "load.drag_area": 30.0, "wind.speed.y": 8.0,
}
# a crane has another size, or what acts on it
CRANES = {name: CASES[name] for name in ("force", "friction", "velocity", "air", "buffers")} | {
    "quay": QUAY
}
TIME = 0.3
each = pytest.mark.parametrize("fmi", [2, 3])


def imported(path: Path, values: Mapping[str, Any] | None = None) -> casadi.DaeBuilder:
    """A model with time as an input and continuous outputs, as docs/importing/casadi.md has it."""
    dae = casadi.DaeBuilder(path.stem, str(path))
    if not dae.has_t():
        dae.set_category("time", "t")
    for name, value in (values or {}).items():
        dae.set(name, value if not isinstance(value, str) else number(value))
    dae.set_all("y", [n for n in dae.y() if dae.variability(n) == "continuous"])
    return dae


def number(item: str) -> int:
    found = {i: k for e in gantry_crane.spec().enumerations for k, i in enumerate(e.items, 1)}
    return found[item]


def points(case: str, count: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """States and inputs."""
    random = np.random.default_rng(3)
    found = []
    for _ in range(count):
        state = random.uniform(-0.4, 0.4, len(gantry_crane.STATES))
        state[2] += 20.0 if case == "quay" else 0.8
        inputs = random.uniform(-1.0, 1.0, len(INPUTS))
        if case == "quay":
            inputs[:3] *= 4e5
        found.append((state, inputs))
    return found


def ordered(dae: casadi.DaeBuilder, state: np.ndarray) -> np.ndarray:
    """A state in the order in which CasADi has them."""
    by_name = dict(zip(gantry_crane.STATES, state, strict=True))
    return np.array([by_name[n] for n in dae.x()])


@each
@pytest.mark.parametrize("case", CRANES)
def test_right_hand_side_and_outputs(native_fmus, fmi: int, case: str) -> None:
    dae = imported(native_fmus[fmi][1], CRANES[case])
    assert sorted(dae.x()) == sorted(gantry_crane.STATES) and tuple(dae.u()) == INPUTS
    evaluate = dae.create("f", ["t", "x", "u"], ["ode", "y"])
    with Importer(native_fmus[fmi][1], "ModelExchange") as fmu:
        fmu.set(CRANES[case])
        fmu.initialise()
        for state, inputs in points(case, 5):
            fmu.write(INPUTS, inputs)
            expected = fmu.derivatives(TIME, state)
            rates, outputs = (v.full().ravel() for v in evaluate(TIME, ordered(dae, state), inputs))
            assert rates.tolist() == ordered(dae, expected).tolist()
            assert outputs.tolist() == fmu.get(*dae.y()).tolist()
            assert np.ptp(rates) > 1.0


def differences(
    evaluate: casadi.Function, place: list[np.ndarray], which: int, names: list[str]
) -> list[np.ndarray]:
    """Jacobians of both results by one of the arguments."""
    columns: list[list[np.ndarray]] = [[], []]
    # results are linear in the energies, and sums with large ones
    linear = np.array([n.startswith("energy.") for n in names])
    step = np.where(linear, 10.0, 1e-5 * np.maximum(1.0, np.abs(place[which])))
    for i in range(len(place[which])):
        ends = []
        for sign in (-1.0, 1.0):
            moved = [np.array(p) for p in place]
            moved[which][i] += sign * step[i]
            ends.append([v.full().ravel() for v in evaluate(*moved)])
        for column, below, above in zip(columns, *ends, strict=True):
            column.append((above - below) / (2.0 * step[i]))
    return [np.array(c).T for c in columns]


@each
@pytest.mark.parametrize("case", CRANES)
def test_jacobians_are_those_of_differences(native_fmus, fmi: int, case: str) -> None:
    dae = imported(native_fmus[fmi][1], CRANES[case])
    assert dae.provides_directional_derivatives()
    arguments = ["t", "x", "u"]
    evaluate = dae.create("f", arguments, ["ode", "y"])
    kinds = ["jac_ode_x", "jac_y_x", "jac_ode_u", "jac_y_u"]
    jacobians = dae.create("j", arguments, kinds)
    for state, inputs in points(case, 3):
        place = [np.array([TIME]), ordered(dae, state), inputs]
        found = [m.full() for m in jacobians(*place)]
        expected = [
            *differences(evaluate, place, 1, dae.x()), *differences(evaluate, place, 2, dae.u())
        ]
        for name, one, other in zip(kinds, found, expected, strict=True):
            error = np.abs(one - other) / np.maximum(np.abs(other), 1.0)
            assert error.max() <= 1e-6, (name, np.unravel_index(error.argmax(), error.shape))
        assert all(np.count_nonzero(m) > 5 for m in expected)


@each
def test_gradients_and_curvature(native_fmus, fmi: int) -> None:
    """FMI 3.0 by the FMU's adjoint derivatives, 2.0 by its Jacobian."""
    dae = imported(native_fmus[fmi][1])
    evaluate = dae.create("f", ["t", "x", "u"], ["ode"])
    jacobian = dae.create("j", ["t", "x", "u"], ["jac_ode_x"])
    state, inputs = points("force", 1)[0]
    weights = np.random.default_rng(5).normal(size=dae.nx())
    x = casadi.MX.sym("x", dae.nx())
    cost = casadi.dot(weights, evaluate(TIME, x, inputs))
    curvature, slope = casadi.Function("h", [x], list(casadi.hessian(cost, x)))(state)
    expected = jacobian(TIME, state, inputs).full().T @ weights
    assert slope.full().ravel() == pytest.approx(expected, abs=1e-12)
    below, above = (
        np.array([
            jacobian(TIME, state + sign * 1e-5 * e, inputs).full().T @ weights
            for e in np.eye(dae.nx())
        ]) for sign in (-1.0, 1.0)
    )
    quotient = (above - below) / 2e-5
    assert np.abs(curvature.full() - quotient).max() <= 1e-6 * np.abs(quotient).max()


@each
def test_feedforward_over_time(native_fmus, fmi: int) -> None:
    dae = imported(native_fmus[fmi][0], {"limits.x.velocity": 0.7})
    assert dae.nx() == dae.nu() == 0
    evaluate = dae.create("f", ["t"], ["y"])
    with Importer(native_fmus[fmi][0], "ModelExchange") as fmu:
        fmu.set({"limits.x.velocity": 0.7})
        fmu.initialise()
        for time in (0.0, 0.4, 1.3, 2.2, 9.0, 0.1):
            fmu.fmu.setTime(time)
            assert evaluate(time).full().ravel().tolist() == fmu.get(*dae.y()).tolist()
    if fmi == 3:
        # in FMI 2.0 nothing can depend on a time that is no variable
        found = dae.create("j", ["t"], ["jac_y_t"])(1.3).full().ravel()
        quotient = (evaluate(1.3 + 1e-6) - evaluate(1.3 - 1e-6)).full().ravel() / 2e-6
        assert np.abs(found - quotient).max() <= 1e-6 * np.abs(quotient).max() and found.any()


@each
def test_mission_of_the_paper(native_fmus, fmi: int) -> None:
    """The crane under the planner's setpoints, by CVODES, against our co-simulation."""
    feedforward, crane = (imported(path) for path in native_fmus[fmi])
    shared = [n for n in crane.u() if n in feedforward.y()]
    assert len(shared) == 19
    feedforward.set_all("y", shared)
    crane.set_all("y", [f"load.position.{a}" for a in "xyz"])
    setpoints = feedforward.create("setpoints", ["t"], ["y"])
    plant = crane.create("plant", ["t", "x", "u"], ["ode", "y"])
    t, x = casadi.MX.sym("t"), casadi.MX.sym("x", crane.nx())
    given = dict(zip(shared, casadi.vertsplit(setpoints(t)), strict=True))
    rate, load = plant(t, x, casadi.vertcat(*(given.get(n, 0.0) for n in crane.u())))
    times = np.linspace(0.0, 4.5, 451)
    run = casadi.integrator(
        "run", "cvodes", {"t": t, "x": x, "ode": rate}, 0.0, times,
        {"reltol": 1e-10, "abstol": 1e-10},
    )
    states = run(x0=crane.start(crane.x()))["xf"]
    found = casadi.Function("load", [t, x], [load]).map(len(times))(times, states).full()
    rows = simulate(*native_fmus[fmi], stop_time=4.5, step=1e-3)
    expected = np.array([rows[f"load.position.{a}"][::10] for a in "xyz"])
    assert np.abs(found - expected).max() <= 1e-6
    assert expected[:2, -1] == pytest.approx([1.0, 0.8], abs=1e-6)
