"""A planner and the crane that follows it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from segfmu.fmu.feedforward.interface import WAYPOINTS
from segfmu.fmu.model import Model
from segfmu.fmu.standard.spec import Spec

# colours of bodies in icons
GREY, ORANGE = "{60, 60, 60}", "{200, 90, 0}"


@dataclass(frozen=True)
class ModelPair:
    """A planner and the crane that follows it.

    Attributes
    ----------
    models : tuple of 2 Model
        The planner first.
    planner : callable
        The planner's interface with room for so many waypoints.
    plant : callable
        The crane's interface.
    held : callable
        It with start values of inputs with which the load hangs at rest at the start.
    coupled : tuple of (str, str)
        Modelica class of both, connected, and the name of the crane in it.
    described : str
        Sentences about both in the Modelica package.
    hanging : tuple of (int, int, int, str)
        Bodies on the rope in icons, from above: middle, half their width, and colour.
    ropes : tuple of (int, int)
        Ends of rope and links in icons, from above.
    """

    models: tuple[Model, Model]
    planner: Callable[[int], Spec]
    plant: Callable[[], Spec]
    held: Callable[[Spec], Spec]
    coupled: tuple[str, str]
    described: str
    hanging: tuple[tuple[int, int, int, str], ...]
    ropes: tuple[tuple[int, int], ...]

    @property
    def feedforward(self) -> str:
        """Name of the planner."""
        return self.models[0].name

    @property
    def crane(self) -> str:
        """Name of the crane."""
        return self.models[1].name

    @property
    def names(self) -> tuple[str, str]:
        """Of both, the planner first."""
        return self.feedforward, self.crane

    @property
    def shared(self) -> list[str]:
        """Outputs of the planner that the crane takes."""
        taken = {v.name for v in self.plant().where("input")}
        return [v.name for v in self.planner(WAYPOINTS).where("output") if v.name in taken]
