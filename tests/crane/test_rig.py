"""What is not ideal, each part against a closed form, and all of it together."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from segfmu import Crane, InputError
from segfmu.crane import (
    Drive,
    Friction,
    Gust,
    PayloadChange,
    Plant,
    Rig,
    Sensors,
    Setpoints,
    SwayFeedback,
    Wind,
)
from segfmu.crane.feedback import design

LAB = Crane(2.2, 1.155, 1.0)
# a load so light that bridge and trolley do not feel it
BARE = replace(LAB, payload_mass=1e-9)
HANGING = LAB.hanging([0.0, 0.0, -0.5])
INTECO = Friction((100.0, 82.0, 75.0), (5.0, 7.5, 10.0), 1e-3, 0.01)


def test_two_changes_of_the_load_at_one_time_are_refused() -> None:
    changes = [PayloadChange(time, mass) for time, mass in ((3.0, 1.0), (2.0, 4.0), (3.0, 2.0))]
    assert Rig(payload=tuple(changes[:2])).changes.tolist() == [[3.0, 1.0], [2.0, 4.0]]
    with pytest.raises(InputError, match="two changes of the load are at 3 s"):
        Rig(payload=tuple(changes))


def hold(crane: Crane, velocity=(0.0, 0.0, 0.0)) -> Setpoints:
    force = np.array([0.0, 0.0, -crane.payload_mass * crane.gravity])
    return Setpoints(force, np.array(velocity), HANGING)


@cache
def feedback(driven: bool) -> SwayFeedback:
    return design(LAB, sample_time=0.01, shortest=0.2, longest=1.0, rows=5, driven=driven)


def plant(crane: Crane = LAB, *, velocity=(0.0, 0.0, 0.0), state=HANGING, **options) -> Plant:
    """A plant without feedback that is told to stand, or to go at a velocity, from the start."""
    options = {"enabled": False, **options}
    gains = feedback(options.get("driven", False))
    return Plant(crane, state, hold(crane, velocity), gains, **options)


def moving(axis: int, velocity: float) -> np.ndarray:
    state = HANGING.copy()
    state[5 + axis] = velocity
    return state


def only(axis: int, value: float) -> tuple[float, float, float]:
    x, y, z = value * np.eye(3)[axis]
    return x, y, z


def residual_sway(length: float, distance: float, velocity: float, acceleration: float) -> float:
    """Largest angle [deg] after a trapezoidal move of a velocity-driven trolley."""
    rise = velocity / acceleration
    cruise = distance / velocity - rise
    start = LAB.hanging([0.0, 0.0, -length])
    moved = plant(state=start, driven=True)
    for duration, reached in ((rise, velocity), (cruise, velocity), (rise, 0.0)):
        if duration > 1e-12:
            moved.step(duration, Setpoints(velocity=np.array([0.0, reached, 0.0])))
    assert moved.state[1] == pytest.approx(distance)
    period = 2.0 * np.pi * np.sqrt(length / 9.81)
    largest = 0.0
    for _ in range(600):
        moved.step(period / 500.0, Setpoints())
        largest = max(largest, abs(moved.state[4]))
    return float(np.degrees(largest))


@pytest.mark.parametrize(
    ("length", "distance", "velocity", "acceleration", "degrees"),
    [
        (0.5, 0.4, 0.3, 0.6, 2.363), (0.7, 0.4, 0.3, 0.6, 6.791),
        (0.5, 1.0, 1.0, 1.0, 14.914), (0.7, 1.0, 1.0, 1.0, 21.295),
    ],
)
def test_residual_sway_of_an_unshaped_trapezoid(
    length: float, distance: float, velocity: float, acceleration: float, degrees: float
) -> None:
    # amplitudes of independent simulations; without damping, l phi'' = -g sin phi -+ a cos phi
    found = residual_sway(length, distance, velocity, acceleration)
    assert found == pytest.approx(degrees, rel=3e-4)


@pytest.mark.parametrize(("axis", "mass"), [(0, 3.355), (1, 1.155), (2, 1.0)])
def test_viscous_friction_lets_an_axis_coast_exponentially(axis: int, mass: float) -> None:
    crane = LAB if axis == 2 else BARE
    rig = Rig(friction=Friction(viscous=only(axis, 3.0)))
    coasting = plant(crane, state=moving(axis, 0.2), rig=rig)
    rate = 3.0 / mass
    for i in range(1, 21):
        coasting.step(0.05, hold(crane))
        assert coasting.state[5 + axis] == pytest.approx(0.2 * np.exp(-rate * 0.05 * i), rel=1e-7)
    travelled = 0.2 / rate * (1.0 - np.exp(-rate))
    assert coasting.state[axis] - HANGING[axis] == pytest.approx(travelled, rel=1e-7)


@pytest.mark.parametrize(("axis", "mass"), [(0, 3.355), (1, 1.155), (2, 1.0)])
def test_coulomb_friction_decelerates_evenly_to_rest(axis: int, mass: float) -> None:
    crane = LAB if axis == 2 else BARE
    rig = Rig(friction=Friction(coulomb=only(axis, 0.5), presliding=1e-6))
    coasting = plant(crane, state=moving(axis, 0.2), rig=rig)
    deceleration = 0.5 / mass
    stop = 0.2 / deceleration
    for i in range(1, 10):
        coasting.step(0.1 * stop, hold(crane))
        assert coasting.state[5 + axis] == pytest.approx(0.2 * (1.0 - 0.1 * i), abs=1e-6)
    coasting.step(0.2 * stop, hold(crane))
    assert abs(coasting.state[5 + axis]) < 1e-6
    travelled = 0.5 * 0.2 * stop
    assert coasting.state[axis] - HANGING[axis] == pytest.approx(travelled, abs=1e-5)
    assert coasting.balance.dissipated == pytest.approx(0.5 * mass * 0.04, rel=1e-4)


@pytest.mark.parametrize(("axis", "mass"), [(0, 3.355), (1, 1.155), (2, 1.0)])
def test_drag_slows_an_axis_the_less_the_slower_it_is(axis: int, mass: float) -> None:
    # m v' = -d v |v|, so that 1 / v grows evenly and the way is the logarithm of its growth
    crane = LAB if axis == 2 else BARE
    rig = Rig(friction=Friction(drag=only(axis, 8.0)))
    for speed in (0.2, -0.2):
        coasting = plant(crane, state=moving(axis, speed), rig=rig)
        for i in range(1, 11):
            coasting.step(0.05, hold(crane))
            growth = 1.0 + 8.0 * abs(speed) / mass * 0.05 * i
            assert coasting.state[5 + axis] == pytest.approx(speed / growth, rel=1e-7)
        travelled = np.sign(speed) * mass / 8.0 * np.log(growth)
        assert coasting.state[axis] - HANGING[axis] == pytest.approx(travelled, rel=1e-7)
        lost = 0.5 * mass * speed**2 * (1.0 - 1.0 / growth**2)
        assert coasting.balance.dissipated == pytest.approx(lost, rel=1e-7)


def test_sway_damping_reduces_small_swings_exponentially() -> None:
    start = HANGING.copy()
    start[4] = 1e-3
    damped = plant(state=start, driven=True, rig=Rig(friction=Friction(sway=0.05)))
    # m l^2 phi'' + d phi' + m g l phi = 0
    decay, square = 0.5 * 0.05 / 0.25, 9.81 / 0.5
    period = 2.0 * np.pi / np.sqrt(square - decay**2)
    for _ in range(300):
        damped.step(period / 100.0, hold(LAB))
    assert damped.state[4] == pytest.approx(1e-3 * np.exp(-3.0 * decay * period), rel=1e-5)


def test_step_response_of_a_lag() -> None:
    lagging = plant(velocity=(0.2, 0.0, 0.1), driven=True, rig=Rig(Drive(0.025), hoist=Drive(0.1)))
    for i in range(1, 21):
        lagging.step(0.01, hold(LAB, (0.2, 0.0, 0.1)))
        t = 0.01 * i
        assert lagging.state[5] == pytest.approx(0.2 * (1.0 - np.exp(-t / 0.025)), abs=1e-9)
        assert lagging.state[7] == pytest.approx(0.1 * (1.0 - np.exp(-t / 0.1)), abs=1e-9)
        assert not lagging.saturated.any()


def test_ramp_behind_a_lag_is_late_by_the_lag() -> None:
    lagging = plant(driven=True, rig=Rig(trolley=Drive(0.025)))
    for i in range(1, 51):
        lagging.step(0.01, hold(LAB, (0.0, 0.3 * 0.01 * i, 0.0)))
    late = 0.5 - 0.025 * (1.0 - np.exp(-0.5 / 0.025))
    assert lagging.state[6] == pytest.approx(0.3 * late, abs=1e-9)


def test_acceleration_saturates_then_the_lag_takes_over() -> None:
    rig = Rig(trolley=Drive(lag=0.1, acceleration_max=1.0))
    limited = plant(velocity=(0.0, 0.3, 0.0), driven=True, rig=rig)
    for i in range(1, 51):
        limited.step(0.01, hold(LAB, (0.0, 0.3, 0.0)))
        t = 0.01 * i
        expected = t if t <= 0.2 else 0.3 - 0.1 * np.exp(-(t - 0.2) / 0.1)
        assert limited.state[6] == pytest.approx(expected, abs=1e-7)
        assert limited.saturated.tolist() == [False, i <= 20, False]


def test_force_saturates_and_the_velocity_falls_behind() -> None:
    rig = Rig(Drive(lag=0.01, force_max=2.0))
    limited = plant(BARE, velocity=(0.5, 0.0, 0.0), driven=True, rig=rig)
    for i in range(1, 51):
        limited.step(0.01, hold(BARE, (0.5, 0.0, 0.0)))
        assert limited.state[5] == pytest.approx(2.0 / 3.355 * 0.01 * i, rel=1e-7)
        assert limited.drive_force[0] == pytest.approx(2.0)
        assert limited.saturated.tolist() == [True, False, False]


def test_force_mode_saturates_at_the_largest_force() -> None:
    limited = plant(BARE, rig=Rig(trolley=Drive(force_max=0.5)))
    limited.step(0.1, replace(hold(BARE), force=np.array([0.0, 0.0, -9.81e-9])))
    assert not limited.saturated.any()
    limited.step(0.1, replace(hold(BARE), force=np.array([0.4, -1.0, -9.81e-9])))
    assert limited.saturated.tolist() == [False, True, False]
    assert limited.drive_force == pytest.approx([0.4, -0.5, 0.0], abs=1e-8)


def test_without_lag_a_drive_catches_up_after_its_bound() -> None:
    limited = plant(driven=True, rig=Rig(Drive(acceleration_max=1.0)))
    limited.step(0.1, hold(LAB, (0.2, 0.0, 0.0)))
    assert limited.state[5] == pytest.approx(0.1)
    assert limited.saturated[0]
    limited.step(0.1, hold(LAB, (0.2, 0.0, 0.0)))
    assert limited.state[5] == pytest.approx(0.2)
    limited.step(0.1, hold(LAB, (0.25, 0.0, 0.0)))
    assert limited.state[5] == pytest.approx(0.25)
    assert not limited.saturated.any()


@pytest.mark.parametrize("step", [0.01, 0.037, 0.5])
def test_payload_changes_at_its_time(step: float) -> None:
    # force mode: the drive still holds 1 kg, so the load of 1.5 kg falls with a third of gravity
    changes = (PayloadChange(0.4123, 1.0), PayloadChange(0.1234, 1.5))
    changed = plant(rig=Rig(payload=changes))
    while changed.time < 1.0 - 1e-9:
        changed.step(step if changed.time + step < 1.0 else 1.0 - changed.time, hold(LAB))
    assert changed.payload_mass == 1.0
    velocity = 9.81 / 3.0 * (0.4123 - 0.1234)
    assert changed.state[7] == pytest.approx(velocity, rel=1e-9)
    assert changed.balance.payload == pytest.approx(
        -0.5 * 9.81 * 0.5 - (0.25 * velocity**2 - 0.5 * 9.81 * (0.5 + 0.5 * velocity * 0.2889)),
        rel=1e-9,
    )
    assert abs(changed.balance.imbalance) < 1e-9


@pytest.mark.parametrize("period", [1e8, 1e300])
def test_a_controller_that_hardly_ever_acts_leaves_the_time_of_changes_and_samples(period) -> None:
    rig = Rig(payload=(PayloadChange(0.1, 1.5),), sensors=Sensors(sample_time=0.01))
    slow = replace(feedback(False), sample_time=period)
    late = Plant(LAB, moving(0, 0.2), hold(LAB), slow, enabled=False, rig=rig)
    late.step(0.055, hold(LAB))
    assert late.payload_mass == 1.0
    assert late.measured[0] == pytest.approx(0.05 * 0.2, rel=1e-9)
    late.step(0.05, hold(LAB))
    assert late.payload_mass == 1.5


def test_payload_of_the_start_is_no_change() -> None:
    changed = plant(rig=Rig(payload=(PayloadChange(2.0, 3.0),)), start_time=2.0)
    assert changed.payload_mass == 3.0
    assert changed.balance.imbalance == changed.balance.payload == 0.0


def everything() -> Rig:
    return Rig(
        bridge=Drive(0.025, 30.0, 0.8), trolley=Drive(0.013, 25.0, 0.6), hoist=Drive(0.02, 40.0),
        friction=INTECO,
        sensors=Sensors(0.004, 0.004, (1e-4,) * 5, (1e-4,) * 5, (0.0, 0.0, 0.02, 0.0, 0.0), 3),
        wind=Wind(
            (0.05, 0.0, 0.0), Gust(0.3333, 0.5, (0.5, 0.4, 0.0)), (0.2, 0.1, 0.05), 3.0, seed=11
        ),
        payload=(PayloadChange(0.5101, 1.5), PayloadChange(0.9, 0.7)),
    )


def shaken(driven: bool, steps: int, rig: Rig, start_time: float = 0.0) -> Plant:
    """1.2 s with feedback on: setpoints rise evenly, so that they do not depend on the steps."""
    start = HANGING.copy()
    start[3:5] = 0.1, -0.05
    run = plant(state=start, driven=driven, enabled=True, rig=rig, start_time=start_time)
    for i in range(1, steps + 1):
        share = i / steps
        run.step(
            1.2 / steps,
            Setpoints(
                np.array([20.0 * share, 10.0 * share, -9.81 - 5.0 * share]),
                np.array([0.3, 0.8, -0.1]) * share, HANGING,
            ),
        )
    return run


@pytest.mark.parametrize("driven", [False, True])
def test_energy_balance_closes_with_everything_on(driven: bool) -> None:
    balance = shaken(driven, 1200, everything()).balance
    turned_over = abs(balance.drives) + abs(balance.wind) + balance.dissipated
    assert min(abs(balance.drives), abs(balance.wind), balance.dissipated) > 1e-3
    assert balance.payload != 0.0
    assert abs(balance.imbalance) < 1e-8 * turned_over


@pytest.mark.parametrize("driven", [False, True])
def test_communication_step_does_not_matter_with_everything_on(driven: bool) -> None:
    runs = [shaken(driven, steps, everything()) for steps in (12, 77, 1200)]
    for other in runs[1:]:
        assert other.state == pytest.approx(runs[0].state, abs=1e-7)
        assert other.measured.tolist() == runs[0].measured.tolist()


def test_same_seed_same_run_and_another_seed_another() -> None:
    rig = everything()
    first, again = (shaken(True, 100, rig) for _ in range(2))
    assert first.state.tolist() == again.state.tolist()
    assert first.measured.tolist() == again.measured.tolist()
    other_wind = shaken(True, 100, replace(rig, wind=replace(rig.wind, seed=12)))
    assert np.abs(other_wind.state - first.state).max() > 1e-5
    other_noise = shaken(True, 100, replace(rig, sensors=replace(rig.sensors, seed=4)))
    assert other_noise.state.tolist() == first.state.tolist()
    assert other_noise.measured.tolist() != first.measured.tolist()


def test_disturbances_follow_absolute_time() -> None:
    rig = everything()
    calm = replace(rig, wind=replace(rig.wind, deviation=(0.0, 0.0, 0.0)))
    gust = calm.wind.gust
    later = replace(
        calm, wind=replace(calm.wind, gust=replace(gust, start=gust.start + 5.0)),
        payload=tuple(replace(c, time=c.time + 5.0) for c in calm.payload),
    )
    assert shaken(False, 60, later, 5.0).state == pytest.approx(
        shaken(False, 60, calm).state, abs=1e-9
    )
