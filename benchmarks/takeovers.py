"""Swings that are taken over: the time until the load rests over the least one."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from benchmarks.report import Part, Record, Section, Settings
from segfmu import ActuatorBounds, Crane, InfeasibleError, Limits, Operator

FloatArray = NDArray[np.float64]
SEED = 73
SWAYS = (5.0, 10.0, 20.0)
GRAVITY = 9.81
# intervals of the linear program, halvings of its time, samples of a motion
CELLS, HALVINGS, SAMPLES = 120, 9, 2000
LIMITS = Limits(velocity=1.0, acceleration=1.0, jerk=1.0, snap=1.0)


@dataclass(frozen=True, eq=False)
class Swinging:
    """A crane whose load swings; bounds of bridge and trolley, state (10,)."""

    crane: Crane
    velocity: FloatArray
    acceleration: FloatArray
    state: FloatArray

    @property
    def bounds(self) -> ActuatorBounds:
        return ActuatorBounds(
            velocity=[*self.velocity, 1.0], acceleration=[*self.acceleration, 0.5]
        )


def problem(random: np.random.Generator, sway: float) -> Swinging:
    """A random crane from a rig to 40 t; sway: angle that its load swings with [deg]."""
    payload = float(np.exp(random.uniform(0.0, np.log(40e3))))
    rope = float(np.exp(random.uniform(np.log(0.3), np.log(40.0))))
    acceleration = np.exp(random.uniform(np.log(0.1), np.log(1.0), 2))
    # full speed after 0.5 to 8 s
    velocity = acceleration * np.exp(random.uniform(np.log(0.5), np.log(8.0), 2))
    direction, phase = random.uniform(0.0, 2.0 * np.pi, 2)
    angle = np.radians(sway) * np.array([np.cos(direction), np.sin(direction)])
    moving = random.choice([0.0, 1.0]) * random.uniform(-0.8, 0.8, 2) * velocity
    rate = -angle * np.sqrt(GRAVITY / rope) * np.sin(phase)
    state = np.array([0.0, 0.0, rope, *(angle * np.cos(phase)), *moving, 0.0, *rate])
    return Swinging(
        Crane(3.0 * payload, 1.5 * payload, payload, rope_min=0.1, rope_max=50.0),
        velocity,
        acceleration,
        state,
    )


def least_time(velocity: float, acceleration: float, swing: FloatArray, longest: float) -> float:
    """Least time [s] until an axis rests, by linear programs on small angles.

    swing: velocity of the carriage, way from it to the load, and its rate, as for a frequency of
    1 / s, in swing[3]: the frequency. The acceleration is constant in each of CELLS intervals.
    """
    moving, place, rate, frequency = swing
    low, high = 0.0, longest
    for _ in range(HALVINGS):
        duration = 0.5 * (low + high)
        step = duration / CELLS
        middle = (np.arange(CELLS) + 0.5) * step
        gain = 2.0 * np.sin(0.5 * frequency * step) / frequency
        ends = np.array(
            [
                gain * np.cos(frequency * middle),
                gain * np.sin(frequency * middle),
                np.full(CELLS, step),
            ]
        )
        reached = step * np.tril(np.ones((CELLS, CELLS)))
        found = linprog(
            np.zeros(CELLS),
            A_ub=np.vstack([reached, -reached]),
            b_ub=np.repeat([velocity - moving, velocity + moving], CELLS),
            A_eq=ends,
            b_eq=[rate, -frequency * place, -moving],
            bounds=(-acceleration, acceleration),
            method="highs",
        )
        low, high = (low, duration) if found.status == 0 else (duration, high)
    return high


def optimum(asked: Swinging, longest: float) -> float:
    """The least time of the slower axis."""
    rope, angles, rates = asked.state[2], asked.state[3:5], asked.state[8:10]
    frequency = float(np.sqrt(GRAVITY / rope))
    # both angles turn the load to +x and -y
    sides = np.array([1.0, -1.0])
    return max(
        least_time(
            asked.velocity[i],
            asked.acceleration[i],
            np.array(
                [
                    asked.state[5 + i],
                    rope * sides[i] * angles[i],
                    rope * sides[i] * rates[i],
                    frequency,
                ]
            ),
            longest,
        )
        for i in range(2)
    )


def drives_of(operator: Operator, step: float) -> tuple[FloatArray, FloatArray]:
    """Velocities and accelerations (samples, 3) of the drives at equal steps [s], by Newton's laws.

    The rope points along the force on the load; the rest are finite differences.
    """
    path = np.array([operator.load_at(step * i)[:3] for i in range(SAMPLES + 1)])
    place, force = path[:, 0], path[:, 2] + np.array([0.0, 0.0, GRAVITY])
    away = place[:, 2:] * force / force[:, 2:]
    drives = np.column_stack([(place - away)[:, :2], np.linalg.norm(away, axis=1)])
    return (
        (drives[2:] - drives[:-2]) / (2.0 * step),
        (drives[2:] - 2.0 * drives[1:-1] + drives[:-2]) / step**2,
    )


def exceeds(asked: Swinging, operator: Operator) -> bool:
    """Whether a sample exceeds a bound, or the load does not begin in the state and end at rest."""
    found = drives_of(operator, operator.rests_at / SAMPLES)
    rope = asked.state[2]
    frequency = np.sqrt(GRAVITY / rope)
    unit = np.array([rope, rope, rope, 1.0, 1.0])
    missed = np.abs(operator.setpoints[3:13] - asked.state) > 1e-6 * np.append(
        unit, frequency * unit
    )
    moves = np.abs(operator.load_at(operator.rests_at)[1]) > 1e-9 * frequency * rope
    most = (asked.bounds.velocity, asked.bounds.acceleration)
    return bool(missed.any() or moves.any()) or any(
        bool((np.abs(values) > np.asarray(bound)).any())
        for values, bound in zip(found, most, strict=True)
    )


def measure(settings: Settings) -> Part:
    """A table: times over the least ones, by sway."""
    count = max(settings.problems // 150, 3)
    return Part(
        "Swings that are taken over",
        (
            Section(
                "Time until the load rests over the least by linear programs",
                [row(sway, count) for sway in SWAYS],
            ),
        ),
        (
            "cranes of 1 kg to 40 t with ropes of 0.3 to 40 m, drives of 0.1 to 1 m/s2 that are at "
            "full speed after 0.5 to 8 s, half of them moving",
            f"linear programs: small angles, {CELLS} intervals of constant acceleration an axis",
        ),
    )


def row(sway: float, count: int) -> Record:
    """A record of random cranes."""
    ratios, seconds, refused, exceeded = [], [], 0, 0
    for seed in range(count):
        asked = problem(np.random.default_rng((SEED, int(sway), seed)), sway)
        begin = time.perf_counter()
        try:
            operator = Operator(asked.crane, LIMITS, asked.state, bounds=asked.bounds)
        except InfeasibleError:
            refused += 1
            continue
        seconds.append(time.perf_counter() - begin)
        exceeded += exceeds(asked, operator)
        ratios.append(operator.rests_at / optimum(asked, 1.05 * operator.rests_at))
    return {
        "sway [deg]": sway,
        "cranes": count,
        "refused": refused,
        "exceeded": exceeded,
        "median": float(np.median(ratios)),
        "95 %": float(np.quantile(ratios, 0.95)),
        "largest": max(ratios),
        "median [ms]": 1e3 * float(np.median(seconds)),
        "longest [ms]": 1e3 * max(seconds),
    }
