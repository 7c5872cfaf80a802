"""Feedback with a hook: its model, its stability with other loads and slings, and what it knows."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from scipy.linalg import solve_discrete_are

from segfmu import FlatInverse, Limits, Waypoint, plan
from segfmu.crane import Crane, Drive, Friction, Plant, Rig, Sensors, Setpoints
from segfmu.crane.hook import (
    HookController,
    HookCrane,
    HookFeedback,
    HookWeights,
    design_hook,
)
from segfmu.crane.linear import sampled
from segfmu.errors import InputError
from segfmu.kernels.crane.records import Axes
from segfmu.kernels.hook.records import HookAxis, HookAxisTable, HookTable
from tests.crane.hook_linear import VELOCITY, axis_model

LAB = HookCrane(Crane(2.2, 1.155, 1.0), 0.1, 0.3)
PORT = HookCrane(Crane(8e4, 1.2e4, 1e4), 500.0, 4.0)
# crane, shortest and longest rope, period
SIZES = {"lab": (LAB, 0.2, 1.2, 0.01), "10 t": (PORT, 2.0, 12.0, 0.05)}

# places of the sling in a state
SLING = [5, 6, 12, 13]


def feedback(size: str, driven: bool, lag: float = 0.0, **weights: float) -> HookFeedback:
    crane, shortest, longest, period = SIZES[size]
    return design_hook(
        crane, sample_time=period, shortest=shortest, longest=longest, driven=driven, lag=lag,
        weights=HookWeights(**weights),
    )


def other(crane: HookCrane, load: float, sling: float) -> HookCrane:
    """The crane with shares of its load and its sling."""
    plain = replace(crane.crane, payload_mass=load * crane.crane.payload_mass)
    return HookCrane(plain, crane.hook_mass, sling * crane.sling)


@pytest.mark.parametrize("size", SIZES)
def test_the_model_is_that_of_small_angles(size: str) -> None:
    """M = m_h + m_p, u the carriage's acceleration:

    m_h l phi'' = -M g phi + m_p g psi - m_h u,  m_h s psi'' = M g (phi - psi).
    """
    crane = SIZES[size][0]
    hook, load, g, s = crane.hook_mass, crane.crane.payload_mass, 9.81, crane.sling
    length, total = SIZES[size][2], hook + load
    a, b = axis_model(crane, length, 0, True)
    assert a[4, 1:3] == pytest.approx(np.array([-total, load]) * g / (hook * length), rel=1e-7)
    assert a[5, 1:3] == pytest.approx(np.array([total, -total]) * g / (hook * s), rel=1e-7)
    assert b[:, 0] == pytest.approx([0.0, 0.0, 0.0, 1.0, -1.0 / length, 0.0], abs=1e-9)
    assert axis_model(crane, length, 1, True)[0] == pytest.approx(a, abs=1e-6)
    # under a force, the hook pulls the carriage along by both weights
    a, b = axis_model(crane, length, 1, False)
    assert a[3, 1] == pytest.approx(total * g / crane.masses[1], rel=1e-7)
    assert b[3, 0] == pytest.approx(1.0 / crane.masses[1], rel=1e-9)
    assert axis_model(crane, length, 2, False)[1][1, 0] == pytest.approx(1.0 / total, rel=1e-7)


def block(found: HookFeedback, axis: int, row: int) -> np.ndarray:
    """The `HookAxisTable` of an axis at a rope length of the table."""
    first = HookTable.AXES + axis * HookAxisTable.SIZE
    part: np.ndarray = found.table[row, first : first + HookAxisTable.SIZE]
    return part


@pytest.mark.parametrize(("size", "lag"), [*product(SIZES, [None, 0.0, 0.1])])
def test_gains_are_those_of_scipy(size: str, lag: float | None) -> None:
    """The generated equations, linearised by differences, and SciPy's Riccati solver."""
    crane, _, _, period = SIZES[size]
    driven, g, w = lag is not None, crane.crane.gravity, HookWeights()
    found = feedback(size, driven, lag or 0.0)
    for axis, row in product(range(3), (0, len(found.lengths) - 1)):
        length = float(found.lengths[row])
        whole, (a, b) = length + crane.sling, axis_model(crane, length, axis, driven)
        n = 2 if axis == 2 else 6
        time, unit = np.sqrt(whole / g), 1.0 if driven else 1.0 / b[VELOCITY[axis], 0]
        full, inputs = np.zeros((n + 2, n + 2)), np.zeros((n + 2, 1))
        full[:n, :n], full[:n, n], inputs[:n] = a, unit * b[:, 0], b
        if lag:
            full[:n, n + 1], inputs[:n] = b[:, 0] / lag, 0.0
            full[:n, VELOCITY[axis]] -= b[:, 0] / lag
            inputs[n + 1] = 1.0
        ad, bd = sampled(full, inputs, period)
        own = block(found, axis, row)
        places = [0, 3, 6, 7] if axis == 2 else [*range(8)]
        assert own[np.ix_(places, places)] == pytest.approx(ad, rel=1e-6, abs=1e-7)
        # the regulator, without the unknown acceleration, and without lag without the command
        kept = [*range(n), n + 1] if lag else [*range(n)]
        scale = np.array([1.0 / whole, 1.0, 1.0] if axis < 2 else [1.0 / whole])
        cost = np.zeros((len(kept), len(kept)))
        values = [w.rope, w.velocity]
        if axis < 2:
            values = [w.position, w.angle, w.angle, w.velocity, w.rate, w.rate]
        cost[:n, :n] = np.diag(np.concatenate([scale, time * scale]) ** 2 * values)
        effort = np.array([[w.effort / (3.0 * unit * g) ** 2]])
        ak, bk = ad[np.ix_(kept, kept)], bd[kept]
        x = solve_discrete_are(ak, bk, cost, effort)
        gains = np.linalg.solve(effort + bk.T @ x @ bk, bk.T @ x @ ak)[0]
        used = own[HookAxisTable.GAINS][[places[i] for i in kept]]
        assert used == pytest.approx(gains, rel=1e-6, abs=1e-7 * np.abs(gains).max())
        # the observer, which knows the command
        push = w.push * g * axis_model(crane, length, axis, True)[1][:, 0]
        noise = np.zeros((n + 1, n + 1))
        noise[:n, :n] = np.outer(push, push)
        if axis < 2:
            noise[n - 1, n - 1] += (w.swing * g / crane.sling) ** 2
        noise[n, n] = (w.drift * g / time) ** 2
        seen = np.eye(2 if axis < 2 else 1, n + 1)
        errors = np.diag([(w.noise * whole) ** 2, w.noise**2][: len(seen)]) * time / period
        x = solve_discrete_are(
            ad[: n + 1, : n + 1].T, seen.T, noise * period * time, errors
        )
        gained = np.linalg.solve(seen @ x @ seen.T + errors, seen @ x)
        both = own[[HookAxisTable.POSITION_GAIN, HookAxisTable.ANGLE_GAIN]][: len(seen)]
        assert both[:, places[: n + 1]] == pytest.approx(
            gained, rel=1e-6, abs=1e-7 * np.abs(gained).max()
        )


def slowest(
    found: HookFeedback, true: HookCrane, axis: int, row: int, driven: bool, late: bool = False
) -> float:
    """Slowest decay of crane and observer together, in units of sqrt(g / (l + s)).

    late: whether corrections act a period after they are due.
    """
    length, own = float(found.lengths[row]), block(found, axis, row)
    used = np.array([0, 3, 6] if axis == 2 else [0, 1, 2, 3, 4, 5, 6])
    transition, effect = own[np.ix_(used, used)], own[used, HookAxis.CORRECTION][:, None]
    gains = own[HookAxisTable.GAINS][used][None, :]
    signals = 1 if axis == 2 else 2
    correction = own[[HookAxisTable.POSITION_GAIN, HookAxisTable.ANGLE_GAIN]][:signals, used].T
    a, b = sampled(*axis_model(true, length, axis, driven), found.sample_time)
    if late:
        n = len(a)
        a = np.block([[a, b], [np.zeros((1, n + 1))]])
        b = np.eye(n + 1)[:, n:]
    gained = correction @ np.eye(signals, len(a))
    kept = np.eye(used.size) - correction @ np.eye(signals, used.size)
    loop = np.block([
        [a - b @ gains @ gained, -b @ gains @ kept],
        [transition @ gained - effect @ gains @ gained, transition @ kept - effect @ gains @ kept],
    ])
    rate = -np.log(np.abs(np.linalg.eigvals(loop)).max()) / found.sample_time
    return float(rate * np.sqrt((length + true.sling) / true.crane.gravity))


@pytest.mark.parametrize(("size", "driven"), [*product(SIZES, [False, True])])
def test_it_is_stable_with_other_loads_and_slings(size: str, driven: bool) -> None:
    """+-30 % of the load, +-10 % of the sling, every rope: damped in three times sqrt(L / g).

    Still damped with a dead time of a period, 10 and 50 ms, that the design does not know.
    """
    found = feedback(size, driven)
    for load, sling in product((0.7, 1.0, 1.3), (0.9, 1.0, 1.1)):
        true = other(SIZES[size][0], load, sling)
        for row, axis in product(range(len(found.lengths)), range(3)):
            assert slowest(found, true, axis, row, driven) > 0.35
            assert slowest(found, true, axis, row, driven, late=True) > 0.1


def test_an_observer_that_expects_no_pushes_would_not_be() -> None:
    found = feedback("10 t", False, push=3e-3, swing=1e-3)
    assert min(slowest(found, other(PORT, 0.7, 1.1), 0, row, False) for row in range(9)) < 0.0


def swung(size: str, driven: bool, true: HookCrane, rig: Rig, enabled: bool = True) -> np.ndarray:
    """Deviations of the load, in m, after a start aside; a row a period, for 12 sqrt(L / g)."""
    crane, shortest, longest, period = SIZES[size]
    length = 0.5 * (shortest + longest)
    whole = length + crane.sling
    lag = max(d.lag for d in rig.drives) if driven else 0.0
    controller = HookController(feedback(size, driven, lag))
    rest = np.array([0.0, 0.0, length, *np.zeros(11)])
    # hook and load aside in both directions, the sling at another angle
    start = rest.copy()
    start[3:7] = 0.1, -0.08, -0.05, 0.12
    weight = (crane.hook_mass + crane.crane.payload_mass) * crane.crane.gravity
    given = Setpoints(np.array([0.0, 0.0, -weight]), np.zeros(3), np.delete(rest, SLING))
    plant = Plant(true, start, given, controller, driven=driven, rig=rig, enabled=enabled)
    target = np.array([0.0, 0.0, -length - true.sling])
    rows = []
    for _ in range(int(12.0 * np.sqrt(whole / 9.81) / period)):
        plant.step(period, given)
        rows.append(plant.load[0] - target)
    return np.array(rows) / whole


@pytest.mark.parametrize(("size", "driven"), [*product(SIZES, [False, True])])
@pytest.mark.parametrize(("load", "sling"), [(1.0, 1.0), (0.7, 1.1), (1.3, 0.9)])
def test_swings_end_in_space(size: str, driven: bool, load: float, sling: float) -> None:
    crane = SIZES[size][0]
    # without feedback a hoist that applies a force falls with another load
    free = swung(size, driven, crane, Rig(), enabled=False)
    damped = swung(size, driven, other(crane, load, sling), Rig())
    last = len(free) // 5
    assert np.abs(free[-last:, :2]).max() > 0.04
    assert np.abs(damped[-last:]).max() < 0.002


def test_real_drives_and_sensors() -> None:
    """Lag, friction and quantised, late signals: what is left is of the order of the friction."""
    rig = Rig(
        *(Drive(lag=0.03, acceleration_max=3.0) for _ in range(3)),
        friction=Friction(viscous=(2.0, 1.0, 1.0), coulomb=(0.2, 0.1, 0.1)),
        sensors=Sensors(sample_time=0.01, resolution=(1e-4, 1e-4, 1e-4, 1e-3, 1e-3)),
    )
    damped = swung("lab", True, other(LAB, 1.3, 1.1), rig)
    assert np.abs(damped[-len(damped) // 5:]).max() < 0.01


def test_the_sling_is_estimated_though_nothing_measures_it() -> None:
    controller = HookController(feedback("lab", True))
    rest = np.array([0.0, 0.0, 0.7, *np.zeros(11)])
    start = rest.copy()
    start[5] = 0.1
    given = Setpoints(np.zeros(3), np.zeros(3), np.delete(rest, SLING))
    plant = Plant(LAB, start, given, controller, driven=True)
    assert np.abs(controller.estimates).max() == 0.0
    errors = []
    for _ in range(200):
        plant.step(0.01, given)
        errors.append(abs(controller.estimates[Axes.BRIDGE, HookAxis.SLING] - plant.state[5]))
    assert max(errors[50:]) < 0.01
    assert max(errors[100:]) < 0.003


def test_corrections_stay_within_what_drives_can_do() -> None:
    found = feedback("lab", True)
    controller = HookController(found, -0.5, [0.5, 0.4, 0.3])
    measured = np.array([1.0, -1.0, 0.9, 0.2, 0.2])
    reference = np.array([0.0, 0.0, 0.7, *np.zeros(7)])
    value = controller.sample(0.0, measured, reference, np.array([0.1, 0.0, 0.0]))
    setpoint = value + np.array([0.1, 0.0, 0.0])
    assert (setpoint <= np.array([0.5, 0.4, 0.3]) + 1e-15).all()
    assert (setpoint >= -0.5 - 1e-15).all()
    assert controller.sample_time == found.sample_time == 0.01


def test_corrections_keep_the_velocities_of_the_drives() -> None:
    """They accelerate a drive until its bound, and never turn back a plan beyond it."""
    reference = np.array([0.0, 0.0, 0.7, 0.0, 0.0, 0.499, 0.6, -0.35, 0.0, 0.0])
    planned = np.array([0.05, 0.0, 0.0])
    for side in (-1.0, 1.0):
        away = 1e-3 * side
        measured = np.array([away, away, 0.7 + away, 0.0, 0.0])
        controller = HookController(feedback("lab", True), velocity_min=-0.3, velocity_max=0.5)
        value = controller.sample(0.0, measured, reference, planned)
        ahead = reference[5:8] + controller.estimates[:3, HookAxis.VELOCITY] + 0.01 * planned
        reached = ahead + 0.01 * value
        assert (reached <= np.maximum(ahead, 0.5) + 1e-12).all()
        assert (reached >= np.minimum(ahead, -0.3) - 1e-12).all()
        free = HookController(feedback("lab", True)).sample(0.0, measured, reference, planned)
        assert (np.abs(value) <= np.abs(free) + 1e-12).all() and (value * free >= 0.0).all()
        assert not np.array_equal(value, free)


@pytest.mark.parametrize(
    "values", [{"sample_time": 0.0}, {"shortest": 2.0}, {"lag": -1.0, "driven": True},
               {"shortest": 1e-300, "longest": 1e-299}]
)
def test_bad_values_are_refused(values: dict[str, float]) -> None:
    given = {"sample_time": 0.01, "shortest": 0.2, "longest": 1.2} | values
    with pytest.raises(InputError):
        design_hook(LAB, **given)  # type: ignore[arg-type]


@pytest.mark.parametrize(("with_hook", "least", "most"), [(True, 0.0, 1e-5), (False, 5e-4, 1e-2)])
def test_what_feedforward_leaves_behind_a_move_with_hoisting(
    with_hook: bool, least: float, most: float
) -> None:
    """Sampled at 1 ms, the hook's inverse leaves no swing; that of one load on a rope does."""
    below = 0.6 + LAB.sling
    limits = Limits(0.3, 0.3, 0.6, 1.5, 4.0, 15.0)
    points = [Waypoint([0.0, 0.0, -below]), Waypoint([0.0, 0.8, 0.3 - below])]
    trajectory = plan(points, limits, smoothness=6)
    crane = LAB if with_hook else replace(LAB.crane, payload_mass=1.1)
    times = 1e-3 * np.arange(int(1e3 * trajectory.duration) + 2)
    velocity = FlatInverse(crane, trajectory).velocity(times)
    idle = HookController(feedback("lab", True))
    start = np.array([0.0, 0.0, 0.6, *np.zeros(11)])
    plant = Plant(LAB, start, Setpoints(), idle, driven=True, enabled=False)
    for row in velocity[1:]:
        plant.step(1e-3, Setpoints(velocity=row))
    left = 0.0
    for _ in range(200):
        plant.step(1e-2, Setpoints())
        left = max(left, abs(plant.load[0, 1] - 0.8))
    assert least <= left <= most
