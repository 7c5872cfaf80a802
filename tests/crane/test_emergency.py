"""Emergency stops: carriages by closed forms, the load by Newton's laws."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.operated import LAB, PORT, SITES, Site
from scipy.integrate import solve_ivp

from segfmu import ActuatorBounds, InfeasibleError, InputError, Limits, Operator
from segfmu.kernels.crane.records import DriveBounds
from segfmu.kernels.operation.records import Known

FASTEST = {"lab": [0.3, 0.35, 0.2], "port": [0.5, 2.6, 1.2]}
GRAVITY = 9.81


def moving(site: Site, sense: float = 1.0, **options: object) -> Operator:
    """A crane whose load moves along all axes, without obstacles in its way."""
    name = "lab" if site is LAB else "port"
    known = {"bounds": ActuatorBounds(acceleration=site.bounds.acceleration)} | options
    operator = Operator(site.crane, site.limits, site.start, **known)  # type: ignore[arg-type]
    operator.command("velocity", velocity=sense * np.array(FASTEST[name]))
    for _ in range(70):
        operator.step(site.step)
    # the carriages sway behind the load and are faster or slower than it
    operator.command("velocity", velocity=[0.0, sense * FASTEST[name][1], 0.0])
    for _ in range(8):
        operator.step(site.step)
    return operator


def swung(site: Site, start: np.ndarray, times: np.ndarray) -> np.ndarray:
    """The load (samples, 3) below carriages that brake, by Newton's laws for load and rope.

    start: positions, angles, velocities and rates of the crane, as `setpoints` has them.
    """
    brakes = np.asarray(site.bounds.acceleration) * np.ones(3)
    velocity = start[5:8]

    # which carriages rest in the interval that is integrated
    rest = np.zeros(3, dtype=bool)

    def carriages(t: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Positions, velocities and accelerations of bridge, trolley and rope."""
        braked = np.minimum(t, np.abs(velocity) / brakes)
        slope = -np.sign(velocity) * brakes
        rate = velocity + slope * braked
        return (
            start[:3] + velocity * braked + 0.5 * slope * braked**2, np.where(rest, 0.0, rate),
            np.where(rest, 0.0, slope),
        )

    def slope(t: float, state: np.ndarray) -> np.ndarray:
        place, rate, acceleration = carriages(t)
        rope = state[:3] - [place[0], place[1], 0.0]
        drift = state[3:] - [rate[0], rate[1], 0.0]
        # w'' + s rope = -g, rope w'' = what keeps |rope| = l: four equations for w'' and s
        matrix = np.zeros((4, 4))
        matrix[:3, :3], matrix[:3, 3], matrix[3, :3] = np.eye(3), rope, rope
        right = rate[2] ** 2 + place[2] * acceleration[2] - drift @ drift
        right += rope[:2] @ acceleration[:2]
        found = np.linalg.solve(matrix, [0.0, 0.0, -GRAVITY, right])
        return np.concatenate([state[3:], found[:3]])

    x, y = start[3], start[4]
    dx, dy = start[8], start[9]
    length, rate = start[2], start[7]
    # direction of the rope for the two angles
    way = np.array([np.sin(x), -np.cos(x) * np.sin(y), -np.cos(x) * np.cos(y)])
    turn = np.array([
        np.cos(x) * dx, np.sin(x) * np.sin(y) * dx - np.cos(x) * np.cos(y) * dy,
        np.sin(x) * np.cos(y) * dx + np.cos(x) * np.sin(y) * dy,
    ])
    load = length * way + [start[0], start[1], 0.0]
    speed = length * turn + rate * way + [start[5], start[6], 0.0]
    kinks = np.sort(np.abs(velocity) / brakes)
    state, found, begin = np.concatenate([load, speed]), [], 0.0
    for end in [*kinks, times[-1]]:
        rest[:] = 0.5 * (begin + end) >= np.abs(velocity) / brakes
        inside = times[(times > begin) & (times <= end)]
        if end > begin:
            run = solve_ivp(
                slope, (begin, end), state, "DOP853", np.union1d(inside, end), rtol=1e-12,
                atol=1e-13 * length,
            )
            found.append(run.y[:3, : inside.size].T)
            state, begin = run.y[:, -1], end
    return np.concatenate(found)


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("name", SITES)
def test_the_load_swings_as_newton_says(name: str, sense: float) -> None:
    site = SITES[name]
    operator = moving(site, sense)
    start = operator.setpoints[3:13]
    told = operator.emergency
    brakes = np.asarray(site.bounds.acceleration)
    # the shortest stop of the carriages
    assert told.duration == pytest.approx((np.abs(start[5:8]) / brakes).max(), rel=1e-12)
    operator.command("emergency")
    count = 400
    found, states, accelerations = np.empty((count, 3)), np.empty((count, 10)), []
    for i in range(count):
        found[i] = operator.step(site.step)[0]
        states[i], accelerations = operator.setpoints[3:13], [
            *accelerations, operator.setpoints[13:16]
        ]
    times = site.step * np.arange(1, count + 1)
    assert operator.emergency == told
    load = swung(site, start, times)
    length = states[-1, 2]
    assert np.abs(found - load).max() <= 1e-8 * length
    # setpoints: bounded while the carriages brake, none afterwards
    assert np.abs(accelerations).max() <= brakes.max() * (1.0 + 1e-6)
    assert (np.abs(accelerations).max(axis=0) <= brakes * (1.0 + 1e-6)).all()
    rests = times > told.duration
    assert np.abs(states[rests, 5:8]).max() <= 1e-7 * np.abs(start[5:8]).max()
    # the sway was told beforehand: no sample exceeds it, and the largest comes near
    rope = (load - np.column_stack([states[:, :2], np.zeros(count)]))[rests]
    sway = np.arctan2(np.hypot(rope[:, 0], rope[:, 1]), -rope[:, 2])
    assert sway.max() <= told.sway + 1e-6
    assert sway.max() >= told.sway * (1.0 - 5e-3)
    assert operator.rests_at == np.inf


def test_the_sway_that_is_told_is_that_of_a_plane_pendulum() -> None:
    # a trolley at a velocity v that stops at once, nearly: v^2 = 2 g l (1 - cos(angle))
    bounds = ActuatorBounds(acceleration=1e6)
    limits = Limits(velocity=3.0, acceleration=0.5, jerk=1.0, snap=5.0)
    operator = Operator(PORT.crane, limits, [0.0, 0.0, -10.0], bounds=bounds)
    operator.command("velocity", velocity=[0.0, 3.0, 0.0])
    for _ in range(300):
        operator.step(0.05)
    angle = 2.0 * np.arcsin(3.0 / np.sqrt(4.0 * GRAVITY * 10.0))
    assert operator.emergency.sway == pytest.approx(angle, abs=1e-5)


@pytest.mark.parametrize("name", SITES)
def test_forces_keep_their_bounds_with_a_longer_stop(name: str) -> None:
    site = SITES[name]
    free = moving(site)
    longest = free.emergency.duration
    free.command("emergency")
    used = []
    for _ in range(200):
        free.step(site.step)
        used.append(free.setpoints[:3])
    # the rope's force stays free; half of what bridge and trolley would use
    force = [*(0.6 * np.abs(used).max(axis=0)[:2]), 1e9]
    bounds = ActuatorBounds(acceleration=site.bounds.acceleration, force=force)
    operator = moving(site, bounds=bounds)
    operator.command("emergency")
    operator.step(site.step)
    assert operator.status == "taken"
    assert operator.emergency.duration > 1.05 * longest
    for _ in range(200):
        operator.step(site.step)
        assert (np.abs(operator.setpoints[:3]) <= force).all()


def test_without_a_command_the_carriages_stand() -> None:
    operator = moving(LAB)
    operator.command("emergency")
    for _ in range(60):
        operator.step(LAB.step)
    place = operator.setpoints[3:6]
    for mode in ("emergency", "mission"):
        operator.command(mode)
        for _ in range(30):
            operator.step(LAB.step)
        assert operator.setpoints[3:6] == pytest.approx(place, abs=1e-9)
        assert operator.rests_at == np.inf


def test_a_crane_at_rest_stays_there() -> None:
    operator = LAB.operator()
    assert operator.emergency.duration == operator.emergency.sway == 0.0
    operator.command("emergency")
    operator.step(LAB.step)
    assert operator.load[0] == pytest.approx(LAB.start, abs=1e-12)
    assert operator.rests_at < np.inf


def test_an_emergency_stop_that_cannot_be_is_told() -> None:
    operator = LAB.operator(bounds=ActuatorBounds(velocity=1.0))
    with pytest.raises(InputError, match="of the bridge has no bound"):
        operator.command("emergency")
    with pytest.raises(InputError, match="of the bridge has no bound"):
        operator.emergency  # noqa: B018
    # the least bearable hoist, which holds the load but cannot brake it
    weak = moving(LAB, -1.0)
    weak._motion.known[Known.BOUNDS, DriveBounds.FORCE_MAX + 2] = 9.7
    with pytest.raises(InfeasibleError, match="use the mode stop"):
        weak.emergency  # noqa: B018
    weak.command("emergency")
    weak.step(LAB.step)
    assert weak.refused == "drives"
