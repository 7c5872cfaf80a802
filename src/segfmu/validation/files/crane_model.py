"""What a crane model declares to files, views and baselines, and the gantry crane's."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from segfmu.crane import Crane
from segfmu.crane.kinds import AnyCrane
from segfmu.fmu.gantry_crane.pair import GANTRY as GANTRY_PAIR
from segfmu.fmu.pair import ModelPair

if TYPE_CHECKING:
    from segfmu.validation.files.crane_file import CraneFile
    from segfmu.validation.files.mission import Mission


@dataclass(frozen=True)
class CraneModel:
    """A crane model.

    Attributes
    ----------
    key : str
        Of the table in crane files that makes a crane one of this model; empty for the gantry
        crane, which has none.
    pair : ModelPair
        Its FMUs.
    parameters : type
        Of its parameters in Python.
    build : callable
        These, from a `Crane` and the table.
    table : callable
        The values of the table, by key, from the parameters.
    source : str
        What the feedback knows unless the file says it.
    defaults : dict
        Of missions.
    notes : dict of str to str
        What keys of missions mean for it, added to their descriptions.
    without_key : dict of str to str
        Parameters of its FMU that no key sets, by the beginning of their names, and why.
    designed : callable
        Parameters for which the feedback is designed, from the table of the nominal crane.
    check_crane, check_mission : callable
        Refuse what it does not have, with `InputError`.
    bodies : tuple of str
        Between rope and load, from above; the crane's FMU shows where: `body.position.x`.
    links : tuple of str
        Below the bodies, which swing as the rope does: `link.x.angle`.
    parts : tuple of (str, str, str)
        For reports: name, key in the table, and unit, kg or m.
    """

    key: str
    pair: ModelPair
    parameters: type[AnyCrane]
    build: Callable[[Crane, Any], AnyCrane]
    table: Callable[[Any], dict[str, float]]
    source: str = "state"
    defaults: Mapping[str, Any] = field(default_factory=dict)
    notes: Mapping[str, str] = field(default_factory=dict)
    without_key: Mapping[str, str] = field(default_factory=dict)
    designed: Callable[[Any], dict[str, float]] = lambda table: {}
    check_crane: Callable[[CraneFile], None] = lambda crane: None
    check_mission: Callable[[Mission], None] = lambda mission: None
    bodies: tuple[str, ...] = ()
    links: tuple[str, ...] = ()
    parts: tuple[tuple[str, str, str], ...] = ()

    @property
    def shown(self) -> tuple[str, ...]:
        """Signals of bodies and links."""
        return (
            *(f"{body}.position.{axis}" for body in self.bodies for axis in "xyz"),
            *(f"{link}.{axis}.angle" for link in self.links for axis in "xy"),
        )


GANTRY = CraneModel("", GANTRY_PAIR, Crane, lambda crane, table: crane, lambda crane: {})
