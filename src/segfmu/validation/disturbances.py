"""Disturbances of the campaign: each one alone, and all at once."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from segfmu.crane import Crane, Drive, Friction, Gust, Rig, Sensors, TravelLimits, Wind
from segfmu.crane.feedforward import Compensation, Three
from segfmu.crane.sensors import resolution
from segfmu.planning.arrays import FloatArray

# lag of the velocity drives [s], period of the controller [s]
LAG = 0.025
SAMPLE_TIME = 0.01

# published for the INTECO 3DCrane: bridge, trolley, hoist
INTECO = Friction(viscous=(100.0, 82.0, 75.0), coulomb=(5.0, 7.5, 10.0))
COMPENSATED = 0.5

# encoders of 4096 counts per revolution; carriages and winch travel 0.25 m per revolution
COUNTS = 4096.0
TRAVEL = 0.25
ENCODERS = (resolution(COUNTS, TRAVEL),) * 3 + (resolution(COUNTS),) * 2

# gust along x and along y, relative to the load's weight; start relative to the plan; duration [s]
GUST = 0.1
GUST_START = 0.2
GUST_DURATION = 0.5


@dataclass(frozen=True)
class Disturbance:
    """A disturbance of the campaign; none by default.

    Attributes
    ----------
    name : str
    sway : float
        Sway angle phi_x at the start [deg].
    gust : bool
        A gust during the move.
    payload : float
        True mass of the load over the nominal one.
    rope : float
        True rope length at the start over the nominal one, minus 1.
    rope_measured : bool
        Whether the rope's encoder measures that; otherwise its zero is wrong by as much.
    friction : bool
        Friction of the INTECO rig; the feedforward compensates half of it.
    encoder, dead_time : bool
        Quantised signals; signals one sample old. The controller is designed for both.
    demanded : bool
        Whether the verdict requires its factors, not only "not worse".
    """

    name: str
    sway: float = 0.0
    gust: bool = False
    payload: float = 1.0
    rope: float = 0.0
    rope_measured: bool = False
    friction: bool = False
    encoder: bool = False
    dead_time: bool = False
    demanded: bool = False

    @property
    def blind(self) -> bool:
        """Whether the load's height has an error that no sensor measures."""
        return self.rope != 0.0 and not self.rope_measured


DISTURBANCES = (
    Disturbance("none"),
    Disturbance("initial sway 5 deg", sway=5.0, demanded=True),
    Disturbance("gust", gust=True, demanded=True),
    Disturbance("payload -50 %", payload=0.5, demanded=True),
    Disturbance("payload +50 %", payload=1.5, demanded=True),
    Disturbance("rope -5 %, measured", rope=-0.05, rope_measured=True, demanded=True),
    Disturbance("rope +5 %, measured", rope=0.05, rope_measured=True, demanded=True),
    Disturbance("rope -5 %, unmeasured", rope=-0.05, demanded=True),
    Disturbance("rope +5 %, unmeasured", rope=0.05, demanded=True),
    Disturbance("friction, half known", friction=True),
    Disturbance("encoder 4096/rev", encoder=True),
    Disturbance("dead time of a sample", dead_time=True),
    Disturbance(
        "all at once", sway=5.0, gust=True, payload=1.5, rope=0.05, friction=True, encoder=True,
        dead_time=True,
    ),
)


@dataclass(frozen=True, eq=False)
class Case:
    """A disturbance applied to one crane.

    Attributes
    ----------
    crane : Crane
        The true crane.
    rig : Rig
    compensation : Compensation
        Known lag and friction of the drives.
    deviation : ndarray, shape (10,)
        Of the state at the start.
    """

    crane: Crane
    rig: Rig
    compensation: Compensation
    deviation: FloatArray


def meet(
    disturbance: Disturbance, crane: Crane, length: float, duration: float, driven: bool
) -> Case:
    """Apply a disturbance to a nominal crane, for a plan's first rope length [m] and duration [s].

    The velocity drives have a known lag; the end stops of the rope are the crane's.
    """
    lag = LAG if driven else 0.0
    share = COMPENSATED if disturbance.friction else 0.0
    deviation = np.zeros(10)
    deviation[2] = disturbance.rope * length
    deviation[3] = np.radians(disturbance.sway)
    rope = None
    if crane.rope_min is not None and crane.rope_max is not None:
        rope = crane.rope_min, crane.rope_max
    drive = Drive(lag=lag)
    return Case(
        crane=replace(crane, payload_mass=disturbance.payload * crane.payload_mass),
        rig=Rig(
            drive, drive, drive,
            friction=INTECO if disturbance.friction else Friction(),
            travel=TravelLimits(rope=rope),
            sensors=_sensors(disturbance, deviation[2]),
            wind=_wind(disturbance, crane, duration),
        ),
        compensation=Compensation(
            (lag, lag, lag), _scaled(share, INTECO.viscous), _scaled(share, INTECO.coulomb),
            INTECO.width,
        ),
        deviation=deviation,
    )


def _scaled(share: float, values: Three) -> Three:
    first, second, third = values
    return share * first, share * second, share * third


def _sensors(disturbance: Disturbance, rope: float) -> Sensors:
    late = disturbance.dead_time
    return Sensors(
        sample_time=SAMPLE_TIME if late else 0.0,
        dead_time=SAMPLE_TIME if late else 0.0,
        resolution=ENCODERS if disturbance.encoder else (0.0,) * 5,
        offset=(0.0, 0.0, -float(rope) if disturbance.blind else 0.0, 0.0, 0.0),
    )


def _wind(disturbance: Disturbance, crane: Crane, duration: float) -> Wind:
    if not disturbance.gust:
        return Wind()
    force = GUST * crane.payload_mass * crane.gravity
    return Wind(gust=Gust(GUST_START * duration, GUST_DURATION, (force, force, 0.0)))
