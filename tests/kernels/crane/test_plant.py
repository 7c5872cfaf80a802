"""The plant's integration against SciPy's on Newton's equations, and its status codes."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu import Crane
from segfmu.crane import Drive, Friction, Gust, Rig, TravelLimits, Wind
from segfmu.kernels.crane.plant import plant_advance
from segfmu.kernels.crane.records import PlantState, Report, Work
from tests.crane.newton import accelerations, direction

MASSES = (2.2, 1.155, 1.0, 9.81)
START = np.zeros(PlantState.SIZE)
START[:10] = 0.1, -0.2, 0.7, 0.2, -0.3, 0.3, -0.1, 0.1, 0.4, -0.2


def advance(
    state, command, rate, duration, *, rig=None, driven=False, wind=(0.0, 0.0, 0.0), time=0.0,
    tolerance=1e-11,
):
    rig = rig or Rig()
    result, report = np.array(state), np.zeros(Report.SIZE)
    work = np.zeros((Work.SIZE, Work.COLUMNS))
    work[Work.COMMAND, :3], work[Work.RATES, : len(rate)] = command, rate
    work[Work.LOAD_FORCE, :3] = wind
    status = plant_advance(
        rig.parameters(Crane(*MASSES), driven), rig.wind.components, time, result, duration,
        tolerance, work, report,
    )
    return status, result, report


def load_velocity(x: np.ndarray) -> np.ndarray:
    h = 1e-6
    ahead, behind = x[3:5] + h * x[8:10], x[3:5] - h * x[8:10]
    turning = (direction(*ahead) - direction(*behind)) / (2.0 * h)
    return np.array([x[5], x[6], 0.0]) + x[7] * direction(x[3], x[4]) + x[2] * turning


def reference(command, rate, duration, wind, viscous, coulomb, slides, sway):
    """SciPy's solution with Newton's equations; the sway damping as a force on load and trolley.

    Dry friction is that of a damped spring that yields at its largest force.
    """
    bridge, trolley, payload, gravity = MASSES
    mass = np.array([bridge + trolley, trolley, payload])

    def right(t: float, x: np.ndarray) -> np.ndarray:
        drive = np.array(command) + t * np.array(rate)
        velocity, z = x[5:8], np.clip(x[10:13] / slides, -1.0, 1.0)
        damped = 2.0 * np.sqrt(1.5 * coulomb * mass / slides) * velocity
        damped = damped / np.hypot(1.0, damped / np.maximum(coulomb, 1e-9))
        friction = viscous * velocity + coulomb * (1.5 * z - 0.5 * z**3) + damped * (1.0 - z**2)
        yields = (np.abs(x[10:13]) >= slides) & (z * velocity > 0.0)
        torque = -sway * x[8:10]
        sx, cx, sy, cy = np.sin(x[3]), np.cos(x[3]), np.sin(x[4]), np.cos(x[4])
        # torques are a pair of forces across the rope, at the load and at the trolley
        across = torque[0] / x[2] * np.array([cx, sx * sy, sx * cy])
        across += torque[1] / (x[2] * cx) * np.array([0.0, -cy, sy])
        net = drive - friction - np.array([across[0], across[1], 0.0])
        second = accelerations(x[:10], net, np.array(wind) + across, *MASSES)
        works = [
            drive @ x[5:8], np.dot(wind, load_velocity(x)),
            friction @ x[5:8] + sway * x[8:10] @ x[8:10],
        ]
        moved = np.where(yields | (coulomb == 0.0), 0.0, velocity)
        # the rope stays taut
        return np.concatenate([x[5:10], second, moved, works, np.zeros(7)])

    return solve_ivp(
        right, (0.0, duration), START, method="DOP853", rtol=1e-11, atol=1e-12
    ).y[:, -1]


@pytest.mark.parametrize("duration", [1e-3, 0.5, 2.0])
@pytest.mark.parametrize("rough", [False, True])
def test_forces_linear_in_time_against_scipy(duration: float, rough: bool) -> None:
    command, rate, wind = [1.0, -0.5, -10.0], [0.5, 0.4, -0.3], (0.1, 0.2, -0.3)
    viscous, coulomb = rough * np.array([2.0, 1.0, 3.0]), rough * np.array([0.3, 0.2, 0.1])
    expected = reference(command, rate, duration, wind, viscous, coulomb, 0.05, 0.04 * rough)
    rig = Rig(friction=Friction(
        tuple(viscous), tuple(coulomb), sway=0.04 * rough, presliding=0.05
    ))
    status, found, report = advance(START, command, rate, duration, rig=rig, wind=wind)
    assert status == 0
    assert found == pytest.approx(expected, rel=1e-8, abs=1e-8)
    forces = np.array(command) + duration * np.array(rate)
    assert report[: Report.SATURATED] == pytest.approx(forces)
    assert report[Report.ELAPSED] == pytest.approx(duration)


def test_driven_carriage_moves_as_prescribed() -> None:
    status, found, _ = advance(START, [0.4, -0.2, 0.1], [0.0] * 3, 0.5, driven=True)
    assert status == 0
    assert found[5:8] == pytest.approx(START[5:8] + 0.5 * np.array([0.4, -0.2, 0.1]))
    assert found[0] == pytest.approx(0.1 + 0.3 * 0.5 + 0.5 * 0.4 * 0.25)


def test_wind_of_the_rig_is_a_force_on_the_load() -> None:
    still = advance(START, [0.0, 0.0, -9.81], [0.0] * 3, 0.4, wind=(0.3, -0.2, 0.1))[1]
    rig = Rig(wind=Wind(constant=(0.3, -0.2, 0.1)))
    assert advance(START, [0.0, 0.0, -9.81], [0.0] * 3, 0.4, rig=rig)[1] == pytest.approx(
        still, abs=1e-12
    )


@pytest.mark.parametrize(("shape", "mean"), [("cosine", 0.5), ("sine", 2.0 / np.pi)])
def test_a_gust_gives_the_impulse_of_its_shape(shape: str, mean: float) -> None:
    rig = Rig(wind=Wind(gust=Gust(1.0, 0.2, (0.5, 0.0, 0.0), shape)))
    start = np.zeros(PlantState.SIZE)
    start[2] = 1.0
    total = np.zeros(2)
    for time in (0.9, 1.0, 1.2):
        duration = 0.2 if time == 1.0 else 0.1
        status, start, _ = advance(
            start, [0.0, 0.0, -9.81], [0.0] * 3, duration, rig=rig, time=time
        )
        assert status == 0
        momentum = (MASSES[0] + MASSES[1]) * start[5] + MASSES[2] * load_velocity(start)[0]
        total = np.append(total, momentum)
    assert total[2:] == pytest.approx([0.0, 0.1 * mean, 0.1 * mean], abs=1e-9)


@pytest.mark.parametrize(
    ("state", "command", "status"),
    [
        ({3: 1.5, 8: 5.0}, [0.0, 0.0, -10.0], 1),
        ({2: 0.05, 3: 0.0, 4: 0.0, 7: -1.0, 8: 0.0, 9: 0.0}, [0.0, 0.0, -20.0], 2),
        ({0: np.nan}, [0.0, 0.0, -10.0], 4),
        ({}, [np.inf, 0.0, 0.0], 4),
        ({}, [0.0, 0.0, 1e-6], 5),
    ],
)
def test_failures_are_reported_by_code(state, command, status: int) -> None:
    start = START.copy()
    for i, value in state.items():
        start[i] = value
    assert advance(start, command, [0.0] * 3, 0.2)[0] == status


def test_falling_faster_than_the_load_slackens_the_rope() -> None:
    start = np.zeros(PlantState.SIZE)
    start[2] = 1.0
    assert advance(start, [0.0, 0.0, 9.7], [0.0] * 3, 0.1, driven=True)[0] == 0
    status, _, report = advance(start, [0.0, 0.0, 9.7], [0.0, 0.0, 2.0], 0.1, driven=True)
    assert status == 5
    assert report[Report.ELAPSED] == pytest.approx(0.055, abs=1e-6)


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_end_stops_are_met_at_their_place_and_time(axis: int, side: float) -> None:
    start = np.zeros(PlantState.SIZE)
    start[2] = 1.0
    centre = start[axis]
    name = ("bridge", "trolley", "rope")[axis]
    rig = Rig(travel=TravelLimits(**{name: (centre - 0.02, centre + 0.02)}))
    command = [0.0, 0.0, 0.0]
    command[axis] = side
    status, found, report = advance(start, command, [0.0] * 3, 1.0, rig=rig, driven=True)
    assert status == (9 if side > 0.0 else 6) + axis
    assert found[axis] == pytest.approx(centre + 0.02 * side, abs=1e-7)
    assert report[Report.ELAPSED] == pytest.approx(0.2, abs=1e-6)


def test_resting_at_an_end_stop_is_allowed() -> None:
    start = np.zeros(PlantState.SIZE)
    start[2] = 1.0
    rig = Rig(travel=TravelLimits(bridge=(0.0, 1.0), rope=(0.5, 1.0)))
    assert advance(start, [0.0, 0.0, -9.81], [0.0] * 3, 1.0, rig=rig)[0] == 0


def test_lag_and_bounds_are_reported() -> None:
    start = np.zeros(PlantState.SIZE)
    start[2] = 1.0
    rig = Rig(bridge=Drive(lag=0.1, acceleration_max=0.5), trolley=Drive(lag=0.1, force_max=0.5))
    _, found, report = advance(start, [0.2, 0.02, 0.0], [0.0] * 3, 0.1, rig=rig, driven=True)
    assert report[Report.SATURATED : Report.ROPE_FORCE].tolist() == [1.0, 0.0, 0.0]
    assert found[5] == pytest.approx(0.05, abs=1e-9)
    assert found[6] == pytest.approx(0.02 * (1.0 - np.exp(-1.0)), abs=1e-9)
