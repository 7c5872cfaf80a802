"""The tracking controller in closed loops by Newton's laws: disturbances, limits, switching."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane, FlatInverse, InputError, Limits, SimulationError, Waypoint, plan
from segfmu.crane import Compensation, Drive, Feedforward, Gust, Plant, Sensors, Setpoints, Wind
from segfmu.crane import Rig as Equipment
from segfmu.crane.feedback import SwayFeedback, design
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.observer import Uncertainty, design_observer
from segfmu.crane.tracking import TrackingController
from tests.campaign import soaked_rows
from tests.crane.loop import Rig, simulate
from tests.crane.newton import direction

LAB = Crane(2.2, 1.155, 1.0)
T = 0.01
REST = LAB.hanging([0.1, -0.2, -0.6])
HOLD = np.array([0.0, 0.0, -9.81])
DESIGNS = {"lqr": design, "flat": design_flat}
ENCODERS = (1e-4, 1e-4, 1e-4, 2.0 * np.pi / 4096.0, 2.0 * np.pi / 4096.0)
SWAYING = REST + np.radians([0.0, 0.0, 0.0, 5.0, -5.0, 0.0, 0.0, 0.0, 0.0, 0.0])


def controller(
    kind: str, driven: bool, *, delayed: bool = False, wake: float = 0.0, offset: float = 0.05,
    steps: tuple[float, float, float] = (0.0, 0.0, 0.0), **options,
) -> TrackingController:
    ranges = {"sample_time": T, "shortest": 0.16, "longest": 0.98, "driven": driven}
    observer = design_observer(
        LAB, lag=lags(driven), delayed=delayed,
        uncertainty=Uncertainty(*steps, wake=wake, offset=offset), **ranges,
    )
    known = {"lag": max(lags(driven))} if kind == "flat" else {}
    return TrackingController(observer, DESIGNS[kind](LAB, **ranges, **known), **options)


def lags(driven: bool) -> tuple[float, float, float]:
    return (0.025, 0.025, 0.025) if driven else (0.0, 0.0, 0.0)


def rig(driven: bool, payload: float = 1.0, **values) -> Rig:
    return Rig((2.2, 1.155, payload, 9.81), driven=driven, lag=lags(driven), **values)


def run(loop, true: Rig, start=REST, duration: float = 4.0, **options):
    """States and corrections while the reference rests."""
    holding = np.zeros(3) if true.driven else HOLD
    return simulate(true, loop, start, duration, lambda t: REST, lambda t: holding, **options)


def load(states: np.ndarray) -> np.ndarray:
    """Position of the load against the reference, by the rope's direction."""
    hanging = [np.array([x, y, 0.0]) + rope * direction(p, q) for x, y, rope, p, q in states[:, :5]]
    return np.array(hanging) - [0.1, -0.2, -0.6]


@pytest.mark.parametrize("measured", ["exact", "encoders", "late"])
@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_sway_is_damped_from_measured_signals(kind: str, driven: bool, measured: str) -> None:
    late = measured == "late"
    resolution = (0.0,) * 5 if measured == "exact" else ENCODERS
    loop = controller(kind, driven, delayed=late)
    states, _ = run(loop, rig(driven, resolution=resolution, delayed=late), SWAYING, 6.0)
    # a step of the encoder is 0.088 degrees, and 0.9 mm of the load
    exact = measured == "exact"
    assert np.degrees(np.abs(states[-100:, 3:5]).max()) < (0.02 if exact else 0.3)
    assert np.abs(load(states[-100:])).max() < (2e-4 if exact else 6e-4)


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_constant_wind_leaves_no_error_of_the_load(kind: str, driven: bool) -> None:
    wind = np.array([0.5, -0.3, 0.0])
    blown = rig(driven, wind=lambda t: wind)
    states, _ = run(controller(kind, driven), blown, duration=7.0)
    assert np.abs(load(states[-50:])).max() < 1e-4
    # the load hangs aslant, so the carriages stand elsewhere
    assert states[-1, 0] - 0.1 == pytest.approx(-0.6 * 0.5 / 9.81, rel=0.01)
    plain, _ = run(controller(kind, driven, rejection=(1.0, 0.0)), blown, duration=7.0)
    assert np.abs(load(plain[-50:])).max() > 0.05


@pytest.mark.parametrize("payload", [0.5, 1.5])
@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_a_wrong_payload_is_held(kind: str, payload: float) -> None:
    states, _ = run(controller(kind, False), rig(False, payload), SWAYING, 6.0)
    assert np.abs(load(states)[:, 2]).max() < 0.01
    assert np.abs(load(states[-50:])).max() < 1e-3


def test_friction_of_the_rig_without_compensation() -> None:
    """Half of it is unknown: the load comes to within millimetres, the sway goes."""
    rough = rig(False, viscous=(50.0, 41.0, 37.0), coulomb=(2.5, 3.75, 5.0), substeps=20)
    states, _ = run(controller("lqr", False), rough, SWAYING, 3.0)
    assert np.abs(load(states[-50:])).max() < 0.01
    assert np.degrees(np.abs(states[-50:, 3:5]).max()) < 1.0


class Unaware:
    """Limits outside of the controller, which is not told: what windup is."""

    def __init__(self, loop: TrackingController, bound: float) -> None:
        self.sample_time, self._loop, self._bound = loop.sample_time, loop, bound

    def sample(self, time, measured, reference, given) -> np.ndarray:
        found = self._loop.sample(time, measured, reference, given)
        return np.append(np.clip(found[:2], -self._bound, self._bound), found[2])


@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_at_its_limits_it_does_not_wind_up(kind: str) -> None:
    """A push that the drives cannot hold, for a second; then the way back."""

    def push(t: float) -> np.ndarray:
        return np.array([1.5, 0.0, 0.0]) if t < 1.0 else np.zeros(3)

    def pushed(loop) -> np.ndarray:
        states, corrections = run(loop, rig(False, wind=push), duration=9.0)
        assert np.abs(corrections[:, :2]).max() == pytest.approx(1.0)
        return load(states)[:, 0]

    aware = pushed(controller(kind, False, lower=[-1.0, -1.0, -30.0], upper=[1.0, 1.0, 0.0]))
    unaware = pushed(Unaware(controller(kind, False), 1.0))
    # it comes back and rests; without knowing, it swings for long
    assert -aware.min() < 0.5 * aware.max()
    assert abs(aware[-1]) < 1e-3
    assert abs(unaware[-1]) > 0.1


@pytest.mark.parametrize("driven", [False, True])
def test_enabling_has_no_bump(driven: bool) -> None:
    def corrections(fade: float) -> np.ndarray:
        loop = controller("flat", driven, fade=fade, enabled=False)

        def switch(tick: int) -> None:
            loop.enabled = tick >= 50

        return run(loop, rig(driven), SWAYING, 1.0, before=switch)[1][:, :2]

    jumping, fading = corrections(0.0), corrections(0.2)
    assert not (jumping[:50].any() or fading[:50].any())
    assert np.abs(fading[50]).max() < 0.1 * np.abs(jumping[50]).max()
    assert np.abs(np.diff(fading, axis=0)).max() < 0.6 * np.abs(np.diff(jumping, axis=0)).max()
    assert np.abs(fading[50:]).max() > 0.15 * np.abs(jumping[50:]).max()


def test_disabling_brings_an_added_velocity_back() -> None:
    loop = controller("flat", True, fade=0.1)

    def switch(tick: int) -> None:
        loop.enabled = tick < 20

    states, corrections = run(loop, rig(True), SWAYING, 2.0, before=switch)
    assert np.abs(states[20, 5:7]).max() > 0.02
    assert np.abs(states[-1, 5:7]).max() < 1e-3
    assert np.abs(np.diff(corrections, axis=0)).max() < np.abs(corrections).max()


def test_gains_are_tunable_while_running() -> None:
    loop = controller("flat", False)
    slower = design_flat(LAB, sample_time=T, shortest=0.16, longest=0.98, ratio=0.5)

    def switch(tick: int) -> None:
        if tick == 30:
            loop.feedback = slower

    states, corrections = run(loop, rig(False), SWAYING, 6.0, before=switch)
    usual, before = run(controller("flat", False), rig(False), SWAYING, 6.0)
    assert corrections[:30] == pytest.approx(before[:30])
    assert loop.feedback is slower
    jump = np.abs(corrections[30] - corrections[29]).max()
    assert jump < 2.0 * np.abs(np.diff(corrections[20:30], axis=0)).max()
    assert np.abs(load(states)[200]).max() > 2.0 * np.abs(load(usual)[200]).max()
    assert np.abs(load(states)[-1]).max() < 5e-3


def test_rejection_is_tunable_while_running() -> None:
    wind = np.array([0.5, 0.0, 0.0])
    loop = controller("flat", False, rejection=(1.0, 0.0))

    def switch(tick: int) -> None:
        if tick == 400:
            loop.rejection = (1.0, 1.0)

    states, _ = run(loop, rig(False, wind=lambda t: wind), duration=8.0, before=switch)
    assert abs(load(states)[400, 0]) > 5e-3
    assert abs(load(states)[-1, 0]) < 5e-4
    assert loop.rejection == (1.0, 1.0)


@pytest.mark.parametrize("driven", [False, True])
def test_a_crane_on_its_plan_is_left_alone_by_rounding(driven: bool) -> None:
    """With encoders nothing moves until a signal is a step away; without sleep it does."""
    between = REST + np.array([3e-5, -4e-5, 2e-5, *np.zeros(7)])
    true, holding = rig(driven, resolution=ENCODERS), np.zeros(3) if driven else HOLD

    def corrections(wake: float, start: np.ndarray) -> np.ndarray:
        loop = controller("flat", driven, wake=wake, steps=ENCODERS[1:4])
        return simulate(true, loop, start, 1.0, lambda t: between, lambda t: holding)[1]

    assert not corrections(1.0, between).any()
    assert corrections(0.0, between).any()
    assert corrections(1.0, between + np.array([2e-4, *np.zeros(9)])).any()


GUST = Wind(gust=Gust(0.5, 0.8, (1.0, 0.7, 0.0)))
SHIFTED = np.array([0.0, 0.0, 0.035, *np.zeros(7)])
# the rope is longer, and its sensor shows the planned length
UNAWARE = Sensors(offset=(0.0, 0.0, -0.035, 0.0, 0.0))


def moved(
    loop, driven: bool, *, start=0.0, payload: float = 1.0, blind: bool = False, **values
) -> np.ndarray:
    """RMS tracking error [m] and sway [rad] beside the plan's in the fourth second after a move.

    Infinite where the crane leaves the range of its equations; horizontal error where the height is
    off by what no sensor tells.
    """
    points = [Waypoint([-0.25, -0.3, -0.8]), Waypoint([0.25, 0.3, -0.7])]
    trajectory = plan(points, Limits([0.22, 0.22, 0.2], 0.3, 0.8, 6.0), smoothness=5)
    feedforward = Feedforward(FlatInverse(LAB, trajectory), Compensation(lag=lags(driven)))
    step = 2e-3
    times = np.arange(int((trajectory.duration + 4.0) / step) + 1) * step
    states, planned = feedforward.inverse.state(times), trajectory(times)
    rows = zip(feedforward.force(times), feedforward.velocity(times), states, strict=True)
    given = [Setpoints(*row) for row in rows]
    drive = Drive(lags(driven)[0])
    plant = Plant(
        Crane(2.2, 1.155, payload), states[0] + start, given[0], loop, driven=driven,
        rig=Equipment(drive, drive, drive, **values),
    )
    errors, sways = [], []
    for setpoints, position, state in zip(given[1:], planned[1:], states[1:], strict=True):
        try:
            plant.step(step, setpoints)
        except SimulationError:
            return np.full(2, np.inf)
        errors.append(float(np.linalg.norm((plant.load[0] - position)[: 2 if blind else 3])))
        sways.append(float(np.abs(plant.state[3:5] - state[3:5]).max()))
    return np.array([np.sqrt(np.mean(np.square(errors))), max(sways[-500:])])


@pytest.mark.parametrize(
    ("driven", "values"),
    [
        (True, {"start": SWAYING - REST}), (False, {"wind": GUST}), (True, {"start": SHIFTED}),
        (False, {"start": SHIFTED, "sensors": UNAWARE, "blind": True}),
        (False, {"payload": 0.5}), (False, {"payload": 1.5}),
        *soaked_rows(
            (False, {"start": SWAYING - REST}), (True, {"wind": GUST}),
            (False, {"start": -SHIFTED}),
            (True, {"start": SHIFTED, "sensors": UNAWARE, "blind": True}),
        ),
    ],
    ids=lambda value: "-".join(value) if isinstance(value, dict) else "driven" * value,
)
@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_feedback_beats_feedforward_alone(kind: str, driven: bool, values) -> None:
    """Three times in RMS tracking error, ten times in residual sway."""
    alone = moved(controller(kind, driven, enabled=False), driven, **values)
    # what the sensor of the rope does not show has to be asked for
    asked = values.get("blind", False)
    together = moved(controller(kind, driven, wake=1.0, rope_offset=asked), driven, **values)
    assert (alone > np.array([3.0, 10.0]) * together).all()


@pytest.mark.parametrize(("driven", "dead_time"), [
    (False, 0.01), (True, 0.0), *soaked_rows((False, 0.0), (True, 0.01)),
])
@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_with_encoders_it_is_no_worse_than_feedforward_alone(
    kind: str, driven: bool, dead_time: float
) -> None:
    sensors = Sensors(sample_time=0.01, dead_time=dead_time, resolution=ENCODERS)
    late = dead_time > 0.0
    alone = moved(controller(kind, driven, enabled=False), driven, sensors=sensors)
    together = moved(controller(kind, driven, delayed=late, wake=1.0), driven, sensors=sensors)
    assert (together <= alone).all()


def test_reset_forgets_and_takes_a_start() -> None:
    loop = controller("lqr", True)
    run(loop, rig(True), SWAYING, 0.3)
    loop.reset()
    assert not loop.deviation.any()
    assert loop.sample(0.0, REST[:5], REST).tolist() == [0.0, 0.0, 0.0]
    moving = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.1, -0.1, 0.05, 0.2, 0.3])
    loop.reset(moving)
    assert loop.deviation == pytest.approx(moving)
    loop.sample(0.0, REST[:5], REST)
    assert loop.deviation == pytest.approx(moving)


def test_bad_values_are_refused() -> None:
    loop = controller("flat", True)
    other = SwayFeedback(0.02, loop.feedback.lengths, loop.feedback.gains, 1.0)
    with pytest.raises(InputError, match="design both for one sample_time"):
        loop.feedback = other
    with pytest.raises(InputError, match="rejection must be shares"):
        loop.rejection = (1.1, 0.0)
    for options, message in (
        ({"lower": [1.0] * 3, "upper": [0.0] * 3}, "lower must not be above upper"),
        ({"fade": -1.0}, "fade"),
        ({"payload_time": 0.0}, "payload_time"),
        ({"lower": [0.0]}, "lower must have 3 values"),
    ):
        with pytest.raises(InputError, match=message):
            controller("flat", True, **options)
