"""A stick that is pushed and released: the operator's plans beside shaped velocities."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from benchmarks.operated import SITES, Site
from benchmarks.report import Part, Record, Section, Settings
from segfmu import Clearance
from segfmu.crane.shaping import Shaper, zv, zvd

FloatArray = NDArray[np.float64]
# samples of a step of the site; in swings: how long the stick is pushed, until when it is watched
FINE = 20
PUSHED, WATCHED = 4.0, 8.0
# the velocity is there within this share of it
THERE = 0.02
# shares of the full velocity: the stick at its end, and microspeed
SHARES = (1.0, 0.1)
ROPES = (1.0, 0.95, 1.05)
# the stick has all the way that it needs
FREE = Clearance()


def measure(settings: Settings) -> Part:
    """Tables by crane and speed: the trolley at a velocity, from rest and back to rest."""
    return Part("Joystick", tuple(
        Section(
            f"{name}: trolley to {share * site.limits.velocity[1]:g} m/s and released",
            rows_of(site, share),
        )
        for name, site in SITES.items() for share in SHARES
    ), (
        "shapers know the rope exactly, and the trolley has the drive's greatest acceleration; the "
        "operator keeps the load's limits as well",
        "a pendulum with the trolley's motion and the rope's length; the last column with a rope "
        "that is 5 % shorter or longer than was known",
    ))


def rows_of(site: Site, share: float = 1.0) -> list[Record]:
    """A record for each way to follow the stick; share: of the full velocity."""
    frequency = float(np.sqrt(site.crane.gravity / -site.start[2]))
    swing = 2.0 * np.pi / frequency
    step = site.step / FINE
    times: FloatArray = step * np.arange(round(WATCHED * swing / step), dtype=np.float64)
    release = PUSHED * swing
    shapers: dict[str, Callable[[float], Shaper] | None] = {"flat ramp": None, "ZV": zv, "ZVD": zvd}
    rows = [
        judged(site, name, share, times, release, *shaped(
            site, share, times, release, shaper(frequency) if shaper else None
        ))
        for name, shaper in shapers.items()
    ]
    own = operated(site, share, times, release)
    return [*rows, judged(site, "operator", share, times, release, *own)]


def shaped(
    site: Site, speed: float, times: FloatArray, release: float, shaper: Shaper | None
) -> tuple[FloatArray, FloatArray]:
    """Acceleration of the trolley, that of the drive in ramps, and length of the rope."""
    most, velocity = float(site.bounds.acceleration[1]), speed * float(site.limits.velocity[1])
    ramp = velocity / most
    delays, shares = (shaper.times, shaper.shares) if shaper else (np.zeros(1), np.ones(1))
    found = np.zeros(times.size)
    for delay, share in zip(delays, shares, strict=True):
        for begin, sign in ((0.0, 1.0), (release, -1.0)):
            since = times - delay - begin
            found += sign * share * most * ((since >= 0.0) & (since < ramp))
    return found, np.full(times.size, -site.start[2])


def operated(
    site: Site, share: float, times: FloatArray, release: float
) -> tuple[FloatArray, FloatArray]:
    """The same of an operator without a space."""
    operator = site.operator(clearance=FREE)
    full = float(site.limits.velocity[1])
    operator.command("velocity", velocity=[0.0, full, 0.0], scale=share)
    rows = []
    for i in range(times.size):
        if i % FINE == 0:
            if times[i] >= release:
                operator.command("stop")
            operator.step(site.step)
        rows.append(operator.load_at(times[i]))
    load = np.array(rows)
    # the rope points along the force on the load
    lean = load[:, 2, 1] / (load[:, 2, 2] + site.crane.gravity)
    trolley = load[:, 0, 1] - load[:, 0, 2] * lean
    step = times[1] - times[0]
    length = -load[:, 0, 2] * np.hypot(1.0, lean)
    return np.gradient(np.gradient(trolley, step), step), length


def judged(
    site: Site, name: str, full: float, times: FloatArray, release: float,
    acceleration: FloatArray, length: FloatArray,
) -> Record:
    """What the load does."""
    velocity = full * float(site.limits.velocity[1])
    runs = [swung(site, times, acceleration, share * length) for share in ROPES]
    place, speed, angle = runs[0]
    pushed = times < release
    away = np.flatnonzero(pushed & (np.abs(speed - velocity) > THERE * velocity))
    resting = times > times[-1] - 2.0 * np.pi * np.sqrt(length[0] / site.crane.gravity)
    at = int(np.searchsorted(times, release))
    return {
        "way to follow": name, "to velocity [s]": float(times[away[-1]]),
        "largest sway [deg]": float(np.degrees(np.abs(angle).max())),
        "overshoot of velocity [%]": float(100.0 * (speed[pushed].max() / velocity - 1.0)),
        "way after release [m]": float(place.max() - place[at]),
        "sway at rest [deg]": float(np.degrees(np.abs(angle[resting]).max())),
        "with 5 % rope [deg]": float(
            np.degrees(max(np.abs(r[2][resting]).max() for r in runs[1:]))
        ),
    }


def swung(
    site: Site, times: FloatArray, acceleration: FloatArray, length: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Place and velocity of the load and the angle of a pendulum under a trolley, by midpoints."""
    step = times[1] - times[0]
    rate = np.gradient(length, step)
    swing, turning, trolley, speed = 0.0, 0.0, 0.0, 0.0
    rows = []
    for i in range(times.size):
        rows.append((
            trolley + length[i] * np.sin(swing),
            speed + rate[i] * np.sin(swing) + length[i] * np.cos(swing) * turning, swing,
        ))
        j = min(i + 1, times.size - 1)
        push, rope = 0.5 * (acceleration[i] + acceleration[j]), 0.5 * (length[i] + length[j])
        gain = 0.5 * (rate[i] + rate[j])

        def turn(angle: float, rate: float, push: float = push, rope: float = rope,
                 gain: float = gain) -> float:
            pull = site.crane.gravity * np.sin(angle) + push * np.cos(angle)
            return float(-(pull + 2.0 * gain * rate) / rope)

        half = turning + 0.5 * step * turn(swing, turning)
        middle = swing + 0.5 * step * turning
        swing, turning = swing + step * half, turning + step * turn(middle, half)
        trolley, speed = trolley + step * (speed + 0.5 * step * push), speed + step * push
    place, velocity, angle = np.array(rows).T
    return place, velocity, angle
