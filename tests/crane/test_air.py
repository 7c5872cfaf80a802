"""Wind from the speed of the air against closed forms, Newton's equations, and its spectrum."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

from segfmu import Crane, InputError
from segfmu.crane import Gust, Plant, Rig, Setpoints, Wind
from segfmu.crane.disturbance import Turbulence
from segfmu.crane.feedback import design
from segfmu.kernels.numerics.records import Sinusoid
from tests.crane.newton import accelerations, direction

LAB, STS = Crane(2.2, 1.155, 1.0), Crane(300e3, 15e3, 40e3)
CASES = pytest.mark.parametrize(
    ("crane", "length", "area", "speed"), [(LAB, 0.5, 0.02, 6.0), (STS, 20.0, 40.0, 15.0)],
    ids=["lab", "sts"],
)


def blown(crane: Crane, length: float, wind: Wind) -> tuple[Plant, Setpoints]:
    gains = design(
        crane, sample_time=0.01, shortest=0.5 * length, longest=length, rows=2, driven=True
    )
    start = crane.hanging([0.0, 0.0, -length])
    given = Setpoints(reference=start)
    return Plant(crane, start, given, gains, driven=True, enabled=False, rig=Rig(wind=wind)), given


def load_velocity(x: np.ndarray) -> np.ndarray:
    h = 1e-6
    turning = direction(*(x[3:5] + h * x[8:10])) - direction(*(x[3:5] - h * x[8:10]))
    return np.array([x[5], x[6], 0.0]) + x[7] * direction(*x[3:5]) + x[2] * turning / (2.0 * h)


@CASES
def test_gust_on_a_swinging_load_against_newton(crane, length, area, speed) -> None:
    """The air's speed relative to the load, with constant wind and a gust of both kinds."""
    gust = Gust(0.5, 3.0, (0.01 * crane.payload_mass, 0.0, 0.0), "sine", (0.4 * speed, 0.0, 1.0))
    steady = np.array([0.3 * speed, speed, 0.1 * speed])
    wind = Wind(gust=gust, speed=tuple(steady), drag_area=area, air_density=1.3)
    plant, given = blown(crane, length, wind)
    masses = (crane.bridge_mass, crane.trolley_mass, crane.payload_mass, crane.gravity)
    # velocity drives hold carriages and rope: by these masses nothing moves them
    rigid = (1e30, 1e30, *masses[2:])
    weight = crane.payload_mass * crane.gravity

    def right(t: float, x: np.ndarray) -> np.ndarray:
        share = np.sin(np.pi * (t - 0.5) / 3.0) if 0.5 < t < 3.5 else 0.0
        relative = steady + share * np.array(gust.speed) - load_velocity(x)
        force = share * np.array(gust.force)
        force = force + 0.5 * 1.3 * area * np.linalg.norm(relative) * relative
        # the rope force that keeps its length
        free = accelerations(x, np.zeros(3), force, *rigid)[2]
        pulled = accelerations(x, np.array([0.0, 0.0, -weight]), force, *rigid)[2]
        tension = weight * free / (free - pulled)
        return np.concatenate(
            [x[5:], accelerations(x, np.array([0.0, 0.0, -tension]), force, *rigid)]
        )

    expected = plant.state
    for span in pairwise((0.0, 0.5, 3.5, 5.0)):
        run = solve_ivp(right, span, expected, method="DOP853", rtol=1e-11, atol=1e-12)
        expected = run.y[:, -1]
    for _ in range(100):
        plant.step(0.05, given)
    assert plant.state == pytest.approx(expected, abs=2e-8)
    assert np.abs(plant.state[3:5]).max() > 1e-3
    assert abs(plant.balance.imbalance) < 1e-8 * abs(plant.balance.wind)


@CASES
def test_steady_wind_holds_the_load_aside(crane, length, area, speed) -> None:
    """At rest the angle is that of drag over weight; the drag damps the swing until then."""
    drag = 0.5 * 1.225 * area * speed**2
    wind = Wind(speed=(0.0, speed, 0.0), drag_area=area)
    plant, given = blown(crane, length, wind)
    state = plant.state
    state[4] = -np.arctan2(drag, crane.payload_mass * crane.gravity)
    gains = design(
        crane, sample_time=0.01, shortest=0.5 * length, longest=length, rows=2, driven=True
    )
    plant = Plant(crane, state, given, gains, driven=True, enabled=False, rig=Rig(wind=wind))
    for _ in range(100):
        plant.step(0.05, given)
    assert plant.state == pytest.approx(state, abs=1e-9)


def test_without_an_area_the_air_does_not_act() -> None:
    plant, given = blown(LAB, 0.5, Wind(speed=(9.0, 9.0, 9.0)))
    plant.step(1.0, given)
    assert np.abs(plant.state[3:5]).max() == 0.0


@pytest.mark.parametrize("speed", [5.0, 20.0])
def test_turbulence_has_davenports_spectrum(speed: float) -> None:
    """Below every frequency as much of the variance as the spectrum has, to one sine."""
    own = Turbulence((1.5, 0.5, 0.2), bandwidth=0.8, seed=4)
    sines = Wind(speed=(0.6 * speed, 0.8 * speed, 0.0), turbulence=own).components
    assert (sines[:, Sinusoid.OF_SPEED] == 1.0).all()

    def spectrum(logarithm: float) -> float:
        x = np.exp(logarithm) * 1200.0 / speed
        return 2.0 / 3.0 * x**2 / (1.0 + x**2) ** (4.0 / 3.0)

    def below(frequency: float) -> float:
        return quad(spectrum, np.log(1e-9), np.log(frequency), limit=200)[0]

    found = np.sort(sines[:, Sinusoid.FREQUENCY]) / (2.0 * np.pi)
    assert found[-1] <= 0.8
    shares = np.array([below(f) for f in found]) / below(0.8)
    assert np.abs(shares - (np.arange(32) + 0.5) / 32).max() < 0.5 / 32 + 1e-6
    # sines with these amplitudes have the variances asked for
    squares = sines[:, Sinusoid.SINE : Sinusoid.OF_SPEED].reshape(32, 2, 3) ** 2
    assert np.sqrt(0.5 * squares.sum(axis=(0, 1))) == pytest.approx(own.deviation)


def test_turbulence_is_the_same_with_any_step_and_closes_the_balance() -> None:
    wind = Wind((0.1, 0.0, 0.0), deviation=(0.05, 0.0, 0.0), speed=(4.0, 0.0, 0.0),
                turbulence=Turbulence((1.0, 1.0, 0.5), seed=2), drag_area=0.05)
    assert len(wind.components) == 64
    ends = []
    for steps in (20, 400):
        plant, given = blown(LAB, 0.5, wind)
        for _ in range(steps):
            plant.step(4.0 / steps, given)
        ends.append(plant.state)
        assert abs(plant.balance.imbalance) < 1e-8 * abs(plant.balance.wind)
    assert ends[1] == pytest.approx(ends[0], abs=1e-8)


def test_turbulence_needs_a_mean_speed() -> None:
    with pytest.raises(InputError, match=r"wind\.turbulence\.deviation 1\.5 m/s needs"):
        Wind(turbulence=Turbulence((0.0, 1.5, 0.0)))
