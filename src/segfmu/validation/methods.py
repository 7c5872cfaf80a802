"""Methods of the campaign: three baselines, the feedforward, and the feedforward with two
feedbacks.

A baseline moves bridge, trolley and rope from waypoint to waypoint with trapezoidal velocities. It
stops at each waypoint, because trapezoids of several axes cannot pass one together while moving. It
assumes the load straight below. ZV and ZVD shape bridge and trolley for the mean rope length.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane import Controller, Crane, FlatInverse, SwayFeedback
from segfmu.crane.feedback import design
from segfmu.crane.feedforward import Compensation, Feedforward
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.linear import moved_masses
from segfmu.crane.observer import Observer, Uncertainty, design_observer
from segfmu.crane.shaping import Motion, Shaped, Shaper, Trapezoid, zv, zvd
from segfmu.crane.tracking import TrackingController
from segfmu.planning import Trajectory
from segfmu.planning.arrays import FloatArray
from segfmu.validation.disturbances import ENCODERS, LAG, SAMPLE_TIME
from segfmu.validation.files.keys import AXES
from segfmu.validation.files.mission import Mission

MODES = ("velocity", "force")

# the observer assumes the encoders' steps, whether signals are quantised or not
EXPECTED = Uncertainty(position=ENCODERS[0], length=ENCODERS[2], angle=ENCODERS[3])

# rope range relative to the rope lengths of the move, if the crane file has none
MARGIN = 0.2


@dataclass(frozen=True)
class Method:
    """A method of the campaign.

    Attributes
    ----------
    name : str
    shaper : callable, optional
        Makes the shaper of a baseline for a frequency [rad/s].
    planned : bool
        Whether it follows the plan and its feedforward.
    feedback : str
        "", "LQR" or "flatness".
    """

    name: str
    shaper: Callable[[float], Shaper] | None = None
    planned: bool = False
    feedback: str = ""


FEEDFORWARD = "feedforward"
METHODS = (
    Method("no control"),
    Method("ZV", shaper=zv),
    Method("ZVD", shaper=zvd),
    Method(FEEDFORWARD, planned=True),
    Method("feedforward + LQR", planned=True, feedback="LQR"),
    Method("feedforward + flatness", planned=True, feedback="flatness"),
)


class Legs:
    """Consecutive trapezoids.

    Parameters
    ----------
    positions : sequence of float
        [m]
    lengths : sequence of float
        Time from each position to the next one [s].
    velocity, acceleration : float
        Limits [m/s], [m/s2].
    """

    def __init__(
        self, positions: FloatArray, lengths: FloatArray, velocity: float, acceleration: float
    ) -> None:
        self.duration = float(np.sum(lengths))
        self._start = float(positions[0])
        self._times = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
        self._legs = [Trapezoid(float(d), velocity, acceleration) for d in np.diff(positions)]

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Position, velocity or acceleration at times t, the shape of t."""
        times = np.asarray(t, dtype=np.float64)
        value = np.full(times.shape, self._start if derivative == 0 else 0.0)
        for start, leg in zip(self._times, self._legs, strict=True):
            value += leg(times - start, derivative)
        return value


@dataclass(frozen=True, eq=False)
class Course:
    """Setpoints of a crane over time, and the reference of its load.

    Attributes
    ----------
    duration : float
        Of the reference motion [s].
    force, velocity : ndarray, shape (times, 3)
        Setpoints [N], [m/s].
    reference : ndarray, shape (times, 10)
        Reference state.
    load : ndarray, shape (times, 3)
        Reference of the load [m].
    """

    duration: float
    force: FloatArray
    velocity: FloatArray
    reference: FloatArray
    load: FloatArray


def planned_course(
    crane: Crane, trajectory: Trajectory, compensation: Compensation, times: FloatArray
) -> Course:
    """The plan with its feedforward."""
    feedforward = Feedforward(FlatInverse(crane, trajectory), compensation)
    return Course(
        trajectory.duration + compensation.delay, feedforward.force(times),
        feedforward.velocity(times), feedforward.state(times), feedforward.load(times),
    )


def baseline_motions(
    mission: Mission, shaper: Callable[[float], Shaper] | None, driven: bool
) -> tuple[Motion, Motion, Motion]:
    """Motions of bridge, trolley and rope of a baseline."""
    points = np.array([w.position for w in mission.waypoints]) * [1.0, 1.0, -1.0]
    limits = [getattr(mission.require_limits(), axis) for axis in AXES]
    lengths = np.array(
        [
            max(
                Trapezoid(float(d), limit.velocity, limit.acceleration).duration
                for d, limit in zip(leg, limits, strict=True)
            )
            for leg in np.diff(points, axis=0)
        ]
    ) + [w.dwell for w in mission.waypoints[1:]]
    legs = [
        Legs(points[:, i], lengths, limit.velocity, limit.acceleration)
        for i, limit in enumerate(limits)
    ]
    bridge, trolley, rope = legs
    if shaper is None:
        return bridge, trolley, rope
    mean = float(rope(np.linspace(0.0, rope.duration, 1001)).mean())
    first, second = (
        Shaped(leg, shaper(_frequency(mission.build_crane(), mean, axis, driven)))
        for axis, leg in enumerate((bridge, trolley))
    )
    return first, second, rope


def _frequency(crane: Crane, length: float, axis: int, driven: bool) -> float:
    """Of the load [rad/s] below a carriage with prescribed velocity, or force."""
    share = 0.0 if driven else crane.payload_mass / moved_masses(crane.masses)[axis]
    return sqrt(crane.gravity / length * (1.0 + float(share)))


def baseline_course(
    crane: Crane,
    motions: tuple[Motion, Motion, Motion],
    compensation: Compensation,
    times: FloatArray,
) -> Course:
    """A baseline with its load straight below.

    The forces would move carriage and load as one body, so they move their centre of mass exactly.
    """
    position, velocity, acceleration = (
        np.stack([motion(times, d) for motion in motions], axis=-1) for d in range(3)
    )
    moved = moved_masses(crane.masses) + crane.payload_mass * np.array([1.0, 1.0, 0.0])
    force = moved * acceleration - [0.0, 0.0, crane.payload_mass * crane.gravity]
    force, setpoint = compensation.setpoints(force, velocity, acceleration)
    reference = np.zeros((times.size, 10))
    reference[:, :3], reference[:, 5:8] = position, velocity
    duration = max(motion.duration for motion in motions)
    return Course(duration, force, setpoint, reference, position * [1.0, 1.0, -1.0])


def rope_range(crane: Crane, trajectory: Trajectory) -> tuple[float, float]:
    """Design range of rope lengths for the controllers [m]."""
    heights = -np.array(trajectory.extrema(0))[:, 2]
    return (
        crane.rope_min or float(heights.min()) * (1.0 - MARGIN),
        crane.rope_max or float(heights.max()) * (1.0 + MARGIN),
    )


@cache
def _gains(crane: Crane, kind: str, driven: bool, ropes: tuple[float, float]) -> SwayFeedback:
    shortest, longest = ropes
    if kind == "LQR":
        return design(
            crane, sample_time=SAMPLE_TIME, shortest=shortest, longest=longest, driven=driven,
            lag=LAG if driven else 0.0,
        )
    return design_flat(
        crane, sample_time=SAMPLE_TIME, shortest=shortest, longest=longest, driven=driven,
        lag=LAG if driven else 0.0,
    )


@cache
def _observer(
    crane: Crane, driven: bool, ropes: tuple[float, float], delayed: bool
) -> Observer:
    return design_observer(
        crane, sample_time=SAMPLE_TIME, shortest=ropes[0], longest=ropes[1], driven=driven,
        lag=(LAG if driven else 0.0,) * 3, delayed=delayed, uncertainty=EXPECTED,
    )


def tracking_controller(
    crane: Crane, kind: str, driven: bool, ropes: tuple[float, float], delayed: bool = False
) -> TrackingController:
    """Observer and gains, "LQR" or "flatness", for a nominal crane; the designs are cached."""
    return TrackingController(
        _observer(crane, driven, ropes, delayed), _gains(crane, kind, driven, ropes),
        rope_offset=True,
    )


class NoFeedback:
    """The controller of methods without one."""

    sample_time = SAMPLE_TIME

    def sample(
        self, time: float, measured: FloatArray, reference: FloatArray, feedforward: FloatArray
    ) -> FloatArray:
        """No correction."""
        return np.zeros(3)


NO_FEEDBACK: Controller = NoFeedback()
