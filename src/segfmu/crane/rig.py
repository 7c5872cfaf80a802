"""All that separates a real crane from the ideal one, each part by itself; none by default."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from segfmu.crane.disturbance import SHAPES, PayloadChange, Wind
from segfmu.crane.equipment import AXES, Drive, Friction, TravelLimits
from segfmu.crane.parameters import Crane
from segfmu.crane.sensors import Sensors
from segfmu.planning.arrays import FloatArray

UNLIMITED = 1e99


@dataclass(frozen=True)
class Rig:
    """Equipment and surroundings of a crane.

    Parameters
    ----------
    bridge, trolley, hoist : Drive
    friction : Friction
    travel : TravelLimits
    sensors : Sensors
    wind : Wind
    payload : tuple of PayloadChange
        In any order.
    """

    bridge: Drive = field(default_factory=Drive)
    trolley: Drive = field(default_factory=Drive)
    hoist: Drive = field(default_factory=Drive)
    friction: Friction = field(default_factory=Friction)
    travel: TravelLimits = field(default_factory=TravelLimits)
    sensors: Sensors = field(default_factory=Sensors)
    wind: Wind = field(default_factory=Wind)
    payload: tuple[PayloadChange, ...] = ()

    @property
    def drives(self) -> tuple[Drive, Drive, Drive]:
        """In the order of the axes."""
        return self.bridge, self.trolley, self.hoist

    @property
    def changes(self) -> FloatArray:
        """Times [s] and masses [kg] of the payload changes, shape (changes, 2)."""
        return np.array([(c.time, c.mass) for c in self.payload], dtype=np.float64).reshape(-1, 2)

    def parameters(self, crane: Crane, driven: bool) -> FloatArray:
        """The array of kernels/crane/plant.py, shape (37,)."""
        packed = np.zeros(37)
        packed[:4] = crane.masses
        packed[4] = driven
        for i, drive in enumerate(self.drives):
            packed[5 + i] = drive.lag
            packed[8 + i] = drive.force_max or 0.0
            packed[11 + i] = drive.acceleration_max or 0.0
        packed[14:17] = self.friction.viscous
        packed[17:20] = self.friction.coulomb
        packed[20], packed[21] = self.friction.width, self.friction.sway
        for i, name in enumerate(AXES):
            limits = getattr(self.travel, name) or (-UNLIMITED, UNLIMITED)
            packed[22 + i], packed[25 + i] = limits
        packed[28:31] = self.wind.constant
        gust = self.wind.gust
        if gust is not None:
            packed[31:34] = gust.start, gust.duration, SHAPES.index(gust.shape)
            packed[34:37] = gust.force
        return packed
