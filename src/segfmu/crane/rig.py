"""All that separates a real crane from the ideal one, each part by itself; none by default."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from segfmu.crane.disturbance import SHAPES, PayloadChange, Wind
from segfmu.crane.equipment import AXES, Drive, Friction, TravelLimits
from segfmu.crane.parameters import Crane
from segfmu.crane.sensors import Sensors
from segfmu.kernels.crane.records import DriveMode, Plant
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
        """The kernels' `Plant`, shape (37,)."""
        packed = np.zeros(Plant.SIZE)
        packed[Plant.BRIDGE_MASS : Plant.MODE] = crane.masses
        packed[Plant.MODE] = DriveMode.VELOCITY if driven else DriveMode.FORCE
        for i, drive in enumerate(self.drives):
            packed[Plant.LAG + i] = drive.lag
            packed[Plant.FORCE_MAX + i] = drive.force_max or 0.0
            packed[Plant.ACCELERATION_MAX + i] = drive.acceleration_max or 0.0
        packed[Plant.VISCOUS : Plant.COULOMB] = self.friction.viscous
        packed[Plant.COULOMB : Plant.FRICTION_WIDTH] = self.friction.coulomb
        packed[Plant.FRICTION_WIDTH] = self.friction.width
        packed[Plant.SWAY_DAMPING] = self.friction.sway
        for i, name in enumerate(AXES):
            least, greatest = getattr(self.travel, name) or (-UNLIMITED, UNLIMITED)
            packed[Plant.TRAVEL_MIN + i], packed[Plant.TRAVEL_MAX + i] = least, greatest
        packed[Plant.WIND : Plant.GUST_START] = self.wind.constant
        gust = self.wind.gust
        if gust is not None:
            packed[Plant.GUST_START], packed[Plant.GUST_DURATION] = gust.start, gust.duration
            packed[Plant.GUST_SHAPE] = SHAPES.index(gust.shape)
            packed[Plant.GUST_FORCE :] = gust.force
        return packed
