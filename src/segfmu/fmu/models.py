"""The registered models: those of all pairs, and others that are registered later."""

from __future__ import annotations

from segfmu.errors import BuildError
from segfmu.fmu.model import Model
from segfmu.fmu.pairs import MODELS

_registered: dict[str, Model] = {}


def register(model: Model) -> None:
    """Register a model for both backends.

    Raises
    ------
    BuildError
        If another model has its name.
    """
    if _registered.setdefault(model.name, model) is not model:
        raise BuildError(f"there is a model {model.name} already; give this one another name")


def registered() -> tuple[Model, ...]:
    """All models in the order of their registration."""
    return tuple(_registered.values())


def named(name: str) -> Model:
    """The model with a name.

    Raises
    ------
    BuildError
        If there is none.
    """
    if name not in _registered:
        raise BuildError(f"model must be one of {', '.join(_registered)}, got {name!r}")
    return _registered[name]


for _model in MODELS.values():
    register(_model)
