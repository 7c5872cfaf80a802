"""Equipment and disturbances of a real crane; by default it is ideal."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from segfmu.arrays import FloatArray, as_flag, as_tuple
from segfmu.crane.checks import require_kind
from segfmu.crane.disturbance import PAYLOAD, PayloadChange, Wind
from segfmu.crane.equipment import DRIVE, FRICTION, TRAVEL, Drive, Friction, TravelLimits
from segfmu.crane.flat_models import model_of
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.sensors import SENSORS, Sensors
from segfmu.crane.variables import Value, build, filled, kept, of_values, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import DRIVES, DriveMode, Plant
from segfmu.kernels.messages import SETUP
from segfmu.kernels.rig.records import SetupFault, SetupStatus

PARTS = {
    **dict.fromkeys(DRIVES, Drive), "friction": Friction, "travel": TravelLimits,
    "sensors": Sensors, "wind": Wind,
}


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
        In any order, each at a time of its own.

    Raises
    ------
    InputError
        For objects of other classes, and two changes of the load at one time.
    """

    bridge: Drive = field(default_factory=Drive)
    trolley: Drive = field(default_factory=Drive)
    hoist: Drive = field(default_factory=Drive)
    friction: Friction = field(default_factory=Friction)
    travel: TravelLimits = field(default_factory=TravelLimits)
    sensors: Sensors = field(default_factory=Sensors)
    wind: Wind = field(default_factory=Wind)
    payload: tuple[PayloadChange, ...] = ()

    def __post_init__(self) -> None:
        for name, kind in PARTS.items():
            require_kind(name, getattr(self, name), kind)
        for change in as_tuple("payload", self.payload):
            require_kind("a change of the payload", change, PayloadChange)
        fault = np.zeros(SetupFault.SIZE)
        status = backend.check_changes(self.changes, fault)
        if status != SetupStatus.FITS:
            raise InputError(SETUP.text(status, fault.tolist()))

    @property
    def drives(self) -> tuple[Drive, Drive, Drive]:
        """In the order of the axes."""
        return self.bridge, self.trolley, self.hoist

    @property
    def changes(self) -> FloatArray:
        """Times [s] and masses [kg] of the payload changes, shape (changes, 2)."""
        return np.array([(c.time, c.mass) for c in self.payload], dtype=np.float64).reshape(-1, 2)

    def parameters(self, crane: AnyCrane, driven: bool) -> FloatArray:
        """The kernels' `Plant`, shape (Plant.SIZE,)."""
        model_of(crane)
        driven = as_flag("driven", driven)
        found = crane.values() | values(self.friction, FRICTION) | values(self.travel, TRAVEL)
        for drive, mapping in zip(self.drives, DRIVE, strict=True):
            found |= values(drive, mapping)
        found |= self.wind.values()
        # the item of the enumeration
        found["drive.mode"] = 1 + (DriveMode.VELOCITY if driven else DriveMode.FORCE)
        return plant_record(crane, found.__getitem__)

    @classmethod
    @of_values
    def of(cls, value: Value) -> Rig:
        """The rig that variables of the FMU describe; `value` gives them by name.

        Raises
        ------
        InputError
            For values that do not fit together.
        """
        bridge, trolley, hoist = (kept(Drive, mapping, value) for mapping in DRIVE)
        return cls(
            bridge, trolley, hoist, kept(Friction, FRICTION, value),
            kept(TravelLimits, TRAVEL, value), kept(Sensors, SENSORS, value), Wind.of(value),
            tuple(_change(value, i) for i in range(1, int(value("payload.count")) + 1)),
        )


def plant_record(crane: AnyCrane, value: Value) -> FloatArray:
    """The kernels' `Plant` of a crane and the variables of its FMU; `value` gives them by name."""
    packed = filled(Plant, value)
    packed[Plant.SUSPENSION : Plant.SLING + 1] = crane.suspension, *crane.tackle
    return packed


def require_fitting(plant: FloatArray, period: float) -> None:
    """Check what `Plant` needs to be integrated with a controller's period [s].

    Raises
    ------
    InputError
        For lags, dead times and a slack rope that cannot be.
    """
    fault = np.zeros(SetupFault.SIZE)
    status = backend.check_lags(plant, 0, fault)
    if status == SetupStatus.FITS:
        status = backend.check_slack(plant, 0, fault)
    if status == SetupStatus.FITS:
        status = backend.check_delays(plant, period, 0, fault)
    if status != SetupStatus.FITS:
        raise InputError(SETUP.text(status, fault.tolist()))


def _change(value: Value, row: int) -> PayloadChange:
    return build(PayloadChange, PAYLOAD, lambda name: value(name.format(row)))
