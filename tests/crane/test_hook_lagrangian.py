"""Equations of hook and load against Newton's, energy, and the gantry crane as a limit."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from segfmu.crane import lagrangian
from segfmu.crane.hook import lagrangian as hook_lagrangian
from segfmu.kernels.crane._crane import crane_rhs
from segfmu.kernels.hook._hook import hook_driven, hook_energy, hook_load, hook_rhs
from segfmu.kernels.hook.records import HookMasses, HookState
from tests.crane.hook_newton import direction_rate, driven, forced
from tests.crane.newton import direction

RNG = np.random.default_rng(20240302)
LAB = np.array([2.2, 1.155, 1.0, 9.81, 0.2, 0.3])


def random_case() -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """State, forces, wind and masses, from a lab to a ship-to-shore crane."""
    state = np.concatenate([
        RNG.uniform(-3.0, 3.0, 2), RNG.uniform(0.1, 20.0, 1), RNG.uniform(-1.3, 1.3, 4),
        RNG.uniform(-3.0, 3.0, 7),
    ])
    masses = (*10.0 ** RNG.uniform(-1.0, 3.0, 3), RNG.uniform(1.0, 20.0),
              10.0 ** RNG.uniform(-1.0, 3.0), RNG.uniform(0.1, 20.0))
    return state, RNG.uniform(-50.0, 50.0, 3), RNG.uniform(-5.0, 5.0, 3), np.array(masses)


def rhs(state, force, wind, masses) -> tuple[np.ndarray, float]:
    derivative, tension = np.zeros(HookState.SIZE), np.zeros(1)
    hook_rhs(state, np.append(force, [0.0, 0.0]), wind, masses, derivative, tension)
    return derivative, tension[0]


def test_rhs_agrees_with_newton_at_1000_states() -> None:
    for _ in range(1000):
        state, force, wind, masses = random_case()
        derivative, tension = rhs(state, force, wind, masses)
        expected = forced(state, force, wind, masses)
        scale = np.abs(expected.coordinates).max()
        assert np.abs(derivative[7:] - expected.coordinates).max() <= 1e-12 * scale
        assert derivative[:7].tolist() == state[7:].tolist()
        assert tension == pytest.approx(expected.tension, rel=1e-11, abs=1e-11 * scale)


def test_driven_form_agrees_with_newton_at_1000_states() -> None:
    for _ in range(1000):
        state, carriage, wind, masses = random_case()
        derivative, force, tension = np.zeros(HookState.SIZE), np.zeros(3), np.zeros(1)
        hook_driven(state, carriage, np.zeros(5), wind, masses, derivative, force, tension)
        expected = driven(state, carriage, wind, masses)
        scale = np.abs(expected.coordinates).max()
        assert np.abs(derivative[7:] - expected.coordinates).max() <= 1e-12 * scale
        assert np.abs(force - expected.force).max() <= 1e-12 * np.abs(expected.force).max()
        assert tension[0] == pytest.approx(expected.tension, rel=1e-11, abs=1e-11 * scale)


def test_driven_form_is_the_inverse_of_the_rhs() -> None:
    for _ in range(200):
        state, force, wind, masses = random_case()
        generalized, derivative = np.append(force, [0.3, -0.2]), np.zeros(HookState.SIZE)
        tension, again, needed = np.zeros(1), np.zeros(HookState.SIZE), np.zeros(3)
        hook_rhs(state, generalized, wind, masses, derivative, tension)
        carriage = derivative[7:10].copy()
        hook_driven(state, carriage, generalized, wind, masses, again, needed, tension)
        assert again == pytest.approx(derivative, rel=1e-8, abs=1e-8)
        assert needed == pytest.approx(force, rel=1e-8, abs=1e-7)


def test_load_hangs_on_the_sling_below_the_hook() -> None:
    state, _, _, masses = random_case()
    load = np.zeros((2, 3))
    hook_load(state, masses, load)
    sling = masses[HookMasses.SLING]
    place = np.array([state[0], state[1], 0.0]) + state[2] * direction(*state[3:5])
    velocity = np.array([state[7], state[8], 0.0]) + state[9] * direction(*state[3:5])
    velocity += state[2] * direction_rate(state[3:5], state[10:12])
    assert load[0] == pytest.approx(place + sling * direction(*state[5:7]), rel=1e-13)
    assert load[1] == pytest.approx(
        velocity + sling * direction_rate(state[5:7], state[12:]), rel=1e-13
    )


def test_energy_minus_work_of_constant_forces_is_conserved() -> None:
    force = np.array([0.8, -0.5, -11.9])
    start = np.array([0.0, 0.0, 2.0, 0.3, -0.2, -0.4, 0.5, 0.1, 0.2, 0.05, 0.1, -0.3, 0.9, -1.1])

    def energy(state: np.ndarray) -> float:
        values = np.zeros(2)
        hook_energy(state, LAB, values)
        return float(values.sum())

    run = solve_ivp(
        lambda _, x: rhs(x, force, np.zeros(3), LAB)[0], (0.0, 10.0), start, method="DOP853",
        rtol=1e-12, atol=1e-13,
    )
    assert run.status == 0
    work = np.array([force @ (x[:3] - start[:3]) for x in run.y.T])
    energies = np.array([energy(x) for x in run.y.T])
    assert np.abs(run.y[5:7]).max() > 0.5
    assert np.abs(energies - energies[0] - work).max() <= 1e-9 * np.abs(energies).max()


def test_equilibrium_needs_both_weights_as_tension() -> None:
    at_rest = np.array([1.0, 2.0, 0.7, *np.zeros(11)])
    derivative, tension = rhs(at_rest, [0.0, 0.0, -1.2 * 9.81], np.zeros(3), LAB)
    assert derivative == pytest.approx(np.zeros(14), abs=1e-14)
    assert tension == pytest.approx(9.81, rel=1e-14)


def test_a_short_sling_makes_a_heavier_load() -> None:
    """With sling -> 0 along the rope, hook and load are one mass; the sling turns with the rope."""
    for _ in range(100):
        state, force, _, masses = random_case()
        state[5:7], state[12:] = state[3:5], state[10:12]
        masses[HookMasses.SLING] = 1e-12
        own = np.zeros(10)
        total = masses[2] + masses[4]
        gantry = np.array([*masses[:2], total, masses[3]])
        crane_rhs(np.concatenate([state[:5], state[7:12]]), np.append(force, [0.0, 0.0]),
                  np.zeros(3), gantry, own)
        found = rhs(state, force, np.zeros(3), masses)[0]
        assert found[7:12] == pytest.approx(own[5:], rel=1e-9, abs=1e-9)


def test_without_a_hook_rope_and_sling_are_one_rope() -> None:
    """With m_h -> 0 the hook is where it turns with the load, and both are on one straight rope.

    An angle between rope and sling of the order m_h, found by Newton's method with 40 digits, is
    what makes a hook of almost no mass turn with the load.
    """
    s, plain = hook_lagrangian.symbols(), lagrangian.symbols()
    motion, tension = hook_lagrangian.accelerations(s)
    masses = ("bridge_mass", "trolley_mass", "payload_mass", "gravity")
    own = [[*v.q, *v.rate, *v.force, *(getattr(v, n) for n in masses)] for v in (s, plain)]
    calm = [dict.fromkeys([*v.load_force], 0) for v in (s, plain)]
    both = sp.lambdify(
        [*own[0], s.hook_mass, s.sling], [*motion.subs(calm[0]), tension.subs(calm[0])], "mpmath"
    )
    one = sp.lambdify(own[1], list(lagrangian.accelerations(plain).subs(calm[1])), "mpmath")
    with mpmath.workdps(40):
        for _ in range(10):
            state, force, _, known = random_case()
            force[2] = -abs(force[2])
            state[12:] = state[10:12]
            sling = known[HookMasses.SLING]

            def hanging(x, y, case=(state, force, known)):
                at, pull, m = case
                return both(*at[:5], x, y, *at[7:], *pull, 0, 0, *m[:4], mpmath.mpf("1e-20"), m[5])

            def turned(x, y, found=hanging):
                values = found(x, y)
                return values[5] - values[3], values[6] - values[4]

            straight = [*state[:2], state[2] + sling, *state[3:5], *state[7:12]]
            angles = mpmath.findroot(turned, tuple(map(mpmath.mpf, state[3:5])), tol=1e-18)
            found = hanging(*angles)
            expected = [float(v) for v in one(*straight, *force, 0, 0, *known[:4])]
            assert [float(v) for v in found[:5]] == pytest.approx(expected, rel=1e-9, abs=1e-9)
            assert float(found[7]) == pytest.approx(-force[2], rel=1e-9)
