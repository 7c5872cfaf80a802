"""A crane with hook and sling: its parameters and the errors for bad ones."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigvalsh

from segfmu import (
    ActuatorBounds,
    Clearance,
    Crane,
    FlatInverse,
    HookCrane,
    InfeasibleError,
    InputError,
    Limits,
    Obstacle,
    Waypoint,
    plan,
    plan_actuated,
)

CRANE = Crane(2.2, 1.155, 1.0, rope_min=0.2)


@pytest.mark.parametrize("name", ["hook_mass", "sling"])
@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), 1e10, "1", None, True])
def test_bad_values_are_named(name: str, value: object) -> None:
    with pytest.raises(InputError, match=name):
        HookCrane(**{"crane": CRANE, "hook_mass": 0.2, "sling": 0.3, name: value})


def test_it_hangs_on_a_crane() -> None:
    with pytest.raises(InputError, match=r"crane must be a segfmu\.Crane, got int"):
        HookCrane(1, 0.2, 0.3)  # type: ignore[arg-type]


def test_variables_give_it_back() -> None:
    hook = HookCrane(CRANE, 0.2, 0.3)
    assert hook.values()["hook.mass"] == 0.2
    assert HookCrane.of(hook.values().__getitem__) == hook


LAB = HookCrane(CRANE, 0.25, 0.3)
LIMITS = Limits(1.0, 1.0, 4.0, 20.0)
POINTS = [Waypoint([0.0, 0.0, -1.0]), Waypoint([0.9, 0.6, -0.7])]


def moved(smoothness: int = 6) -> FlatInverse:
    return FlatInverse(LAB, plan(POINTS, LIMITS, smoothness=smoothness))


def test_the_state_leads_back_to_the_path() -> None:
    inverse = moved()
    trajectory, h = inverse.trajectory, 1e-4
    for t in np.linspace(0.01, trajectory.duration - 0.01, 23):
        change = (inverse.force(t + h)[2] - inverse.force(t - h)[2]) / (2.0 * h)
        load = LAB.load_motion(inverse.state(t), [inverse.force(t)[2], change])
        for order in range(3):
            assert load[order] == pytest.approx(trajectory(t, order), abs=1e-11)
        # the rate of the force is a difference quotient
        assert load[3] == pytest.approx(trajectory(t, 3), abs=1e-5)


def test_newton_moves_the_carriages() -> None:
    """Forces of the drives against momentum: the whole crane's, and what moves with the trolley."""
    inverse = moved()
    t, h = np.linspace(0.1, inverse.trajectory.duration - 0.1, 11), 1e-4
    crane = LAB.crane

    def momentum(times: np.ndarray) -> np.ndarray:
        """Of load and hook, by the geometry of rope and sling."""
        below = np.stack([inverse.state(times + s)[..., :7] for s in (-h, h)])
        x, y, length, phi_x, phi_y = np.moveaxis(below[..., :5], -1, 0)
        hook = np.stack([
            x + length * np.sin(phi_x), y - length * np.cos(phi_x) * np.sin(phi_y),
            -length * np.cos(phi_x) * np.cos(phi_y),
        ], axis=-1)
        psi_x, psi_y = np.moveaxis(below[..., 5:], -1, 0)
        load = hook + LAB.sling * np.stack([
            np.sin(psi_x), -np.cos(psi_x) * np.sin(psi_y), -np.cos(psi_x) * np.cos(psi_y)
        ], axis=-1)
        total = LAB.hook_mass * hook + crane.payload_mass * load
        return (total[1] - total[0]) / (2.0 * h)

    rate = (momentum(t + h) - momentum(t - h)) / (2.0 * h)
    moving = inverse.acceleration(t)[:, :2] * [crane.bridge_mass + crane.trolley_mass,
                                               crane.trolley_mass]
    assert inverse.force(t)[:, :2] == pytest.approx(moving + rate[:, :2], abs=1e-5)
    weight = (LAB.hook_mass + crane.payload_mass) * crane.gravity
    tension = np.hypot(np.hypot(rate[:, 0], rate[:, 1]), rate[:, 2] + weight)
    assert -inverse.force(t)[:, 2] == pytest.approx(tension, abs=1e-5)


@pytest.mark.parametrize(("rope", "hook", "sling", "load"), [
    (0.7, 0.25, 0.3, 1.0), (6.0, 500.0, 4.0, 10e3), (6.0, 500.0, 4.0, 1.0), (30.0, 8e3, 2.0, 40e3),
])
def test_frequencies_are_eigenvalues(rope: float, hook: float, sling: float, load: float) -> None:
    crane = HookCrane(Crane(1.0, 1.0, load, gravity=9.81), hook, sling)
    mass = np.array([
        [(hook + load) * rope**2, load * rope * sling], [load * rope * sling, load * sling**2]
    ])
    stiffness = 9.81 * np.diag([(hook + load) * rope, load * sling])
    expected = np.sqrt(eigvalsh(stiffness, mass))
    assert crane.frequencies(rope) == pytest.approx(expected, rel=1e-9)


def test_a_hook_without_mass_swings_as_one_pendulum() -> None:
    slow, fast = HookCrane(CRANE, 1e-9, 0.3).frequencies(0.7)
    assert slow == pytest.approx(np.sqrt(9.81 / 1.0), rel=1e-8)
    assert fast > 1e4


def test_rope_and_sling_stay_taut() -> None:
    fall = Limits(9.0, 14.0, 400.0, 1e5)
    down = [Waypoint([0.0, 0.0, -1.0]), Waypoint([0.0, 0.0, -4.0])]
    with pytest.raises(InfeasibleError, match="downward acceleration of the load"):
        FlatInverse(LAB, plan(down, fall, smoothness=6))


def test_a_hook_that_is_thrown_is_refused() -> None:
    """The load's jerk turns the sling, and a heavy hook would have to push its rope."""
    fast = Limits(9.0, 9.0, 300.0, 1e5)
    across = [Waypoint([0.0, 0.0, -3.0]), Waypoint([1.5, 0.0, -3.0])]
    heavy = HookCrane(Crane(2.0, 1.0, 0.1), 5.0, 1.0)
    with pytest.raises(InfeasibleError, match="downward acceleration of all on the rope"):
        FlatInverse(heavy, plan(across, fast, smoothness=6))


@pytest.mark.parametrize(("bounds", "message"), [
    ((0.5, None), "rope length .* reaches 0.4 m"), ((None, 0.65), "rope length .* reaches 0.70"),
])
def test_the_rope_ends_at_the_hook(bounds: tuple[float, float], message: str) -> None:
    crane = HookCrane(Crane(2.2, 1.155, 1.0, rope_min=bounds[0], rope_max=bounds[1]), 0.25, 0.3)
    with pytest.raises(InfeasibleError, match=message):
        FlatInverse(crane, plan(POINTS, LIMITS, smoothness=6))


def test_a_hook_at_the_trolley_is_refused() -> None:
    high = [Waypoint([0.0, 0.0, -1.0]), Waypoint([0.0, 0.0, -0.2])]
    with pytest.raises(InfeasibleError, match=r"height z of the rope's end .* reaches 0\.1 m"):
        FlatInverse(HookCrane(Crane(2.2, 1.155, 1.0), 0.25, 0.3), plan(high, LIMITS, smoothness=6))


def test_smoothness_is_required() -> None:
    velocities = moved(5).velocity([0.3])
    assert velocities.shape == (1, 3)
    with pytest.raises(InputError, match="the forces of a HookCrane need smoothness 6, got 5"):
        moved(5).force(0.3)
    with pytest.raises(InputError, match="of a HookCrane needs smoothness 5 or more, got 4"):
        moved(4)


HALL = HookCrane(Crane(12e3, 3e3, 10e3), 500.0, 4.0)
BOUNDED = {
    "lab": (LAB, POINTS, ActuatorBounds(force=[3.0, 2.0, 13.0], velocity=0.6)),
    "hall": (
        HALL, [Waypoint([0.0, 0.0, -10.0]), Waypoint([12.0, 6.0, -8.0])],
        ActuatorBounds(force=[9e3, 6e3, 1.1e5], velocity=[1.0, 0.8, 0.4], sway_angle=0.1),
    ),
}


@pytest.mark.parametrize("name", BOUNDED)
def test_plans_keep_the_bounds_of_the_drives(name: str) -> None:
    """Forces, velocities and angles of the inverse, at samples, against what the plan promises."""
    hook, points, bounds = BOUNDED[name]
    found = plan_actuated(hook, points, None, bounds, smoothness=6, shape="smoothstep")
    assert found.passed
    assert found.active
    inverse = FlatInverse(hook, found.trajectory)
    times = np.linspace(0.0, found.trajectory.duration, 4001)
    peaks = {
        "force": np.abs(inverse.force(times)).max(axis=0),
        "velocity": np.abs(inverse.velocity(times)).max(axis=0),
    }
    for quantity, most in peaks.items():
        assert (most <= getattr(bounds, quantity) * (1.0 + 1e-9)).all(), quantity
    told = {use.name: use for use in found.uses}
    for i, drive in enumerate(("bridge", "trolley", "hoist")):
        use = told[f"{drive} force"]
        assert abs(inverse.force(use.time)[i]) == pytest.approx(abs(use.peak), rel=1e-9), drive
        assert abs(use.peak) >= peaks["force"][i] * (1.0 - 1e-9), drive


def test_plans_need_forces_and_judged_ropes() -> None:
    hook, points, bounds = BOUNDED["lab"]
    with pytest.raises(InputError, match="the forces of a HookCrane need smoothness 6, got 5"):
        plan_actuated(hook, points, None, bounds, smoothness=5)
    box = Clearance([Obstacle("wall", [3.0, 3.0, -1.0], [4.0, 4.0, 0.0])])
    with pytest.raises(InputError, match="obstacle 1: the rope above a hook"):
        plan_actuated(hook, points, None, bounds, smoothness=6, clearance=box)
    alone = Clearance([Obstacle("wall", [3.0, 3.0, -1.0], [4.0, 4.0, 0.0], rope=False)])
    assert plan_actuated(hook, points, LIMITS, ActuatorBounds(force=1e3), smoothness=6,
                         shape="smoothstep", clearance=alone).passed
