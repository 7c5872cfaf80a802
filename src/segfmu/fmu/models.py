"""The registered models. A further model is one more entry here."""

from __future__ import annotations

from segfmu.errors import BuildError
from segfmu.fmu.gantry_crane.model import GANTRY_CRANE
from segfmu.fmu.gantry_feedforward.model import GANTRY_FEEDFORWARD
from segfmu.fmu.hook_crane.model import HOOK_CRANE
from segfmu.fmu.hook_feedforward.model import HOOK_FEEDFORWARD
from segfmu.fmu.model import Model

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


register(GANTRY_FEEDFORWARD)
register(GANTRY_CRANE)
register(HOOK_FEEDFORWARD)
register(HOOK_CRANE)
