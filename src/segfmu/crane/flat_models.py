"""The models whose load's path determines everything: a further one is an entry of `MODELS`.

`FlatInverse` and the planner serve every model of this table.
"""

from __future__ import annotations

from segfmu.crane.flat_model import GANTRY, FlatModel
from segfmu.crane.hook.model import HOOK
from segfmu.crane.parameters import Crane
from segfmu.errors import InputError

MODELS = (GANTRY, HOOK)


def model_of(crane: object) -> FlatModel:
    """The model that a crane's parameters belong to.

    Raises
    ------
    InputError
        For anything else.
    """
    for model in MODELS:
        if isinstance(crane, model.parameters):
            return model
    names = " or a ".join(f"segfmu.{model.name}" for model in MODELS)
    raise InputError(f"crane must be a {names}, got {type(crane).__name__}")


def require_flat(crane: object, axes: int, smoothness: int) -> None:
    """Raise InputError unless a trajectory of so many axes, so smooth, has a flat inverse."""
    model = model_of(crane)
    if axes != 3:
        raise InputError(f"the flat inverse needs axes x, y, z; got {axes} axes")
    if smoothness < model.least:
        jumps = "acceleration" if model.least == model.orders - 1 else "velocity"
        raise InputError(
            f"the flat inverse of a {model.name} needs smoothness {model.least} or more, got "
            f"{smoothness}; with less, the carriage's {jumps} jumps"
        )


def require_gantry(crane: object, axes: int, smoothness: int) -> None:
    """The same for a gantry crane alone."""
    if not isinstance(crane, Crane):
        raise InputError(f"crane must be a segfmu.Crane, got {type(crane).__name__}")
    require_flat(crane, axes, smoothness)


def require_force(crane: object, smoothness: int) -> None:
    """Raise InputError unless a trajectory is smooth enough for the forces of the drives."""
    model = model_of(crane)
    if smoothness < model.orders - 1:
        raise InputError(
            f"the forces of a {model.name} need smoothness {model.orders - 1}, got {smoothness}; "
            "with less, they jump"
        )
