"""The stepping plant: sampling, switching the feedback, independence of the step."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from segfmu import Crane
from segfmu.crane import Friction, Rig, TravelLimits
from segfmu.crane.feedback import design
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.observer import design_observer
from segfmu.crane.plant import Plant, Setpoints
from segfmu.crane.tracking import TrackingController
from segfmu.errors import InputError, SimulationError
from segfmu.kernels.rig.records import Outputs

CRANE = Crane(2.2, 1.155, 1.0)
HANGING = CRANE.hanging([0.0, 0.0, -0.5])
HOLD = Setpoints(force=np.array([0.0, 0.0, -9.81]), reference=HANGING)


def plant(sway: float = 0.05, **options) -> Plant:
    start = HANGING.copy()
    start[3] = sway
    feedback = design(CRANE, sample_time=0.01, shortest=0.2, longest=1.0)
    return Plant(CRANE, start, HOLD, feedback, **options)


def test_feedback_acts_only_while_enabled() -> None:
    swinging = plant(fade=0.0)
    swinging.step(0.05, HOLD)
    assert np.abs(swinging.drive_force[:2]).max() > 0.01
    swinging.enabled = False
    swinging.step(0.02, HOLD)
    assert swinging.drive_force == pytest.approx([0.0, 0.0, -9.81], abs=1e-15)


def forces_of_ticks(swinging: Plant, count: int) -> np.ndarray:
    found = []
    for _ in range(count):
        swinging.step(0.01, HOLD)
        found.append(swinging.drive_force[0])
    return np.array(found)


def test_switching_the_feedback_off_and_on_has_no_bump() -> None:
    swinging = plant(fade=0.2)
    last = forces_of_ticks(swinging, 5)[-1]
    swinging.enabled = False
    assert forces_of_ticks(swinging, 10) == pytest.approx(
        last * np.exp(-0.05 * np.arange(1, 11)), rel=1e-9
    )
    fading, jumping = plant(enabled=False, fade=0.2), plant(enabled=False, fade=0.0)
    for one in (fading, jumping):
        assert not forces_of_ticks(one, 5).any()
        one.enabled = True
    slowly, at_once = forces_of_ticks(fading, 100), forces_of_ticks(jumping, 100)
    assert abs(slowly[0]) < 0.06 * abs(at_once[0])
    assert np.abs(np.diff(slowly)).max() < 0.5 * np.abs(np.diff(at_once)).max()
    assert np.abs(slowly).max() > 0.15 * np.abs(at_once).max()


def test_switching_off_in_velocity_mode_brings_the_added_velocity_back() -> None:
    swinging = plant(driven=True, fade=0.1)
    forces_of_ticks(swinging, 20)
    added = np.abs(swinging.state[5:8]).max()
    swinging.enabled = False
    forces_of_ticks(swinging, 200)
    assert added > 0.01
    assert np.abs(swinging.state[5:8]).max() < 1e-6


def test_other_gains_fade_in() -> None:
    other = design_flat(CRANE, sample_time=0.01, shortest=0.2, longest=1.0, ratio=3.0)
    fading, jumping = plant(fade=0.2), plant(fade=0.0)
    before = [forces_of_ticks(one, 5)[-1] for one in (fading, jumping)]
    for one in (fading, jumping):
        one.retune(other)
    steps = [forces_of_ticks(one, 1)[0] for one in (fading, jumping)]
    assert before[0] == before[1]
    assert abs(steps[0] - before[0]) < 0.1 * abs(steps[1] - before[1])
    with pytest.raises(InputError, match="fade"):
        fading.fade = -1.0


def test_correction_holds_between_samples() -> None:
    swinging = plant()
    swinging.step(0.004, HOLD)
    first = swinging.drive_force.copy()
    swinging.step(0.004, HOLD)
    assert swinging.drive_force.tolist() == first.tolist()
    swinging.step(0.004, HOLD)
    assert swinging.drive_force.tolist() != first.tolist()


@pytest.mark.parametrize("driven", [False, True])
def test_communication_step_does_not_matter(driven: bool) -> None:
    ends = []
    for steps in (10, 50, 63, 200):
        swinging = plant(driven=driven)
        for _ in range(steps):
            swinging.step(1.0 / steps, HOLD)
        ends.append(swinging.state)
    for end in ends[1:]:
        assert end == pytest.approx(ends[0], abs=1e-8)


def test_work_and_energy_balance() -> None:
    swinging = plant()
    before = swinging.energy.sum()
    for _ in range(100):
        swinging.step(0.01, HOLD)
    assert swinging.energy.sum() - before == pytest.approx(swinging.work, abs=1e-8)


@pytest.mark.parametrize(
    ("sway", "words"),
    [
        (0.0, "the rope length reached zero"),
        (0.05, r"sway\.x\.angle reached -1\.57 rad, with 0\.\d+ m of rope; .* 90 degrees; check"),
        (-0.05, r"sway\.x\.angle reached 1\.57 rad, "),
    ],
)
def test_failure_names_what_and_when(sway: float, words: str) -> None:
    falling = plant(sway, enabled=False)
    pull = Setpoints(force=np.array([0.0, 0.0, -60.0]), reference=HANGING)
    with pytest.raises(SimulationError, match=rf"at 0\.\d+ s: {words}"):
        for _ in range(100):
            falling.step(0.01, pull)


def test_end_stop_names_axis_position_limit_and_time() -> None:
    rig = Rig(travel=TravelLimits(trolley=(-0.1, 0.25)))
    moved = plant(0.0, driven=True, enabled=False, rig=rig)
    # the setpoint rises to 0.5 m/s within the first second: 0.25 m
    with pytest.raises(SimulationError) as caught:
        for i in range(1, 30):
            moved.step(0.1, Setpoints(velocity=np.array([0.0, min(0.05 * i, 0.5), 0.0])))
    assert str(caught.value) == (
        "at 1.000 s: trolley at 0.25 m is at its end stop, greatest position 0.25 m; shorten the "
        "move, brake earlier or widen the travel limits"
    )
    assert moved.state[1] == pytest.approx(0.25, abs=1e-7)
    # it stays there, and goes on failing
    with pytest.raises(SimulationError, match="end stop"):
        moved.step(0.1, Setpoints(velocity=np.array([0.0, 0.5, 0.0])))


def test_slack_rope_is_named() -> None:
    falling = plant(0.0, driven=True, enabled=False)
    with pytest.raises(SimulationError, match=r"at 0\.0\d+ s: the rope went slack"):
        falling.step(0.1, Setpoints(velocity=np.array([0.0, 0.0, 2.0])))


def test_friction_too_stiff_to_integrate_is_named() -> None:
    rig = Rig(friction=Friction(coulomb=(50.0, 0.0, 0.0), presliding=1e-15))
    stuck = plant(0.05, enabled=False, rig=rig)
    with pytest.raises(SimulationError, match=r"steps became too small; check .* friction"):
        stuck.step(0.01, HOLD)


def test_many_steps_may_take_so_much_of_the_integration() -> None:
    # a load on hardly any rope, which damping stops within microseconds
    start = CRANE.hanging([0.0, 0.0, -1e-3])
    start[3] = 0.05
    feedback = design(CRANE, sample_time=0.01, shortest=0.2, longest=1.0)
    rig = Rig(friction=Friction(sway=0.1))
    durations, setpoints = np.full(100, 0.1), np.zeros((100, HOLD.vector.size))

    def follow(most: float) -> None:
        stiff = Plant(CRANE, start, HOLD, feedback, driven=True, enabled=False, rig=rig)
        stiff.follow(durations[:2], setpoints[:2], most=most)

    follow(1e6)
    with pytest.raises(SimulationError, match=r"at 0\.\d+ s: the integration steps"):
        follow(100.0)


def test_speed_of_the_load_is_the_rate_of_its_way() -> None:
    swinging = plant(sway=0.3, enabled=False)
    swinging.step(0.1, HOLD)
    places, speeds = [], []
    for _ in range(3):
        found = swinging.outputs(np.zeros(3))
        places.append(found[Outputs.LOAD_POSITION : Outputs.LOAD_VELOCITY])
        speeds.append(found[Outputs.LOAD_SPEED])
        swinging.step(1e-4, HOLD)
    assert speeds[1] == pytest.approx(np.linalg.norm(places[2] - places[0]) / 2e-4, rel=1e-6)
    assert speeds[1] > 0.1


def test_balance_has_its_parts() -> None:
    swinging = plant(0.1)
    swinging.step(0.2, Setpoints(HOLD.force, reference=HANGING, wind=np.array([0.3, 0.0, 0.0])))
    found = swinging.balance
    assert (found.kinetic, found.potential) == tuple(swinging.energy)
    assert swinging.work == pytest.approx(found.drives + found.wind)
    assert found.wind != 0.0
    assert found.dissipated == found.payload == 0.0
    assert abs(found.imbalance) < 1e-11
    assert replace(found, dissipated=0.5).imbalance == pytest.approx(0.5)
    assert swinging.drive_power == pytest.approx(swinging.drive_force * swinging.state[5:8])
    assert swinging.wind_power == pytest.approx(0.3 * swinging.load[1, 0])
    assert swinging.rope_force == swinging.drive_force[2]


@pytest.mark.parametrize(
    ("duration", "setpoints"),
    [
        (np.nan, HOLD), (np.inf, HOLD), (0.01, replace(HOLD, wind=np.array([0.0, 0.0, np.inf]))),
        (0.01, replace(HOLD, reference=np.full(10, np.nan))),
        (0.01, replace(HOLD, force=np.array([np.nan, 0.0, 0.0]))),
    ],
)
def test_a_step_that_is_not_finite_changes_nothing(duration: float, setpoints: Setpoints) -> None:
    swinging, other = plant(), plant()
    with pytest.raises(SimulationError, match=r"at 0\.000 s: a value is not finite"):
        swinging.step(duration, setpoints)
    for run in (swinging, other):
        run.step(0.02, HOLD)
    assert swinging.state.tolist() == other.state.tolist()


def test_a_controller_without_a_period_is_refused() -> None:
    feedback = design(CRANE, sample_time=0.01, shortest=0.2, longest=1.0)
    with pytest.raises(InputError, match="sample_time must be a finite number > 0, got 0"):
        replace(feedback, sample_time=0.0)
    other: Any = SimpleNamespace(sample_time=0.0)
    with pytest.raises(InputError, match="controller sample_time must be a finite number > 0"):
        Plant(CRANE, HANGING, HOLD, other)


def test_gains_may_be_replaced_on_the_way() -> None:
    """From a state on, a crane with replaced gains moves as one that starts there with them."""
    other = design_flat(CRANE, sample_time=0.01, shortest=0.2, longest=1.0)
    swinging = plant(fade=0.0)
    swinging.step(0.03, HOLD)
    unchanged = plant()
    unchanged.step(0.03, HOLD)
    fresh = Plant(CRANE, swinging.state, HOLD, other)
    swinging.retune(other)
    for one in (swinging, unchanged, fresh):
        one.step(0.02, HOLD)
    assert swinging.state == pytest.approx(fresh.state, abs=1e-10)
    assert np.abs(swinging.state - unchanged.state).max() > 1e-4


def test_gains_of_another_period_or_for_another_controller_are_refused() -> None:
    swinging = plant()
    with pytest.raises(InputError, match=r"gains of 0\.02 s, the SwayFeedback has 0\.01 s"):
        swinging.retune(design(CRANE, sample_time=0.02, shortest=0.2, longest=1.0))
    feedback = design(CRANE, sample_time=0.01, shortest=0.2, longest=1.0)
    observer = design_observer(CRANE, sample_time=0.01, shortest=0.2, longest=1.0)
    tracking = Plant(CRANE, HANGING, HOLD, TrackingController(observer, feedback))
    with pytest.raises(InputError, match="the TrackingController has"):
        tracking.retune(feedback)


@pytest.mark.parametrize(("kernel", "size"), [(None, 1), (len, -1), (len, 10**400), (len, "a")])
def test_only_a_kernel_tells_of_so_many_numbers(kernel: Any, size: Any) -> None:
    with pytest.raises(InputError, match=r"^(kernel must be a function|size must be )"):
        plant().told(kernel, size)
