"""Planners and the cranes that follow them: which two models belong together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from segfmu.fmu.feedforward.interface import WAYPOINTS
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.hook_crane import interface as hook_crane
from segfmu.fmu.hook_feedforward import interface as hook_feedforward
from segfmu.fmu.models import named
from segfmu.fmu.standard.spec import Spec


@dataclass(frozen=True)
class ModelPair:
    """A planner and the crane that follows it.

    Attributes
    ----------
    feedforward, crane : str
        Names of both models.
    planner : callable
        The planner's interface with room for so many waypoints.
    plant : callable
        The crane's interface.
    held : callable
        It with start values of inputs with which the load hangs at rest at the start.
    """

    feedforward: str
    crane: str
    planner: Callable[[int], Spec]
    plant: Callable[[], Spec]
    held: Callable[[Spec], Spec]

    @property
    def names(self) -> tuple[str, str]:
        """Of both, the planner first."""
        return self.feedforward, self.crane

    @property
    def shared(self) -> list[str]:
        """Outputs of the planner that the crane takes."""
        taken = {v.name for v in self.plant().where("input")}
        return [v.name for v in self.planner(WAYPOINTS).where("output") if v.name in taken]


GANTRY = ModelPair(
    "GantryFeedforward", "GantryCrane", gantry_feedforward.spec, gantry_crane.spec,
    gantry_crane.held,
)
HOOK = ModelPair(
    "HookFeedforward", "HookCrane", hook_feedforward.spec, hook_crane.spec, hook_crane.held
)
PAIRS = (GANTRY, HOOK)


def native(interfaces: Sequence[Spec]) -> tuple[Spec, Spec]:
    """The native interfaces of both, from those with any start values."""
    feedforward, crane = (named(own.name).native_spec(own) for own in interfaces)
    return feedforward, crane
