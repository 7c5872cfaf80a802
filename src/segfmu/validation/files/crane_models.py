"""The crane models: a further one is an entry of `FURTHER` with its table in `ModelTables`."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Annotated, Any

from segfmu.crane import Crane
from segfmu.crane.kinds import AnyCrane
from segfmu.errors import InputError
from segfmu.validation.files.crane_model import GANTRY, CraneModel
from segfmu.validation.files.keys import Key, Table
from segfmu.validation.hook.model import HOOK
from segfmu.validation.hook.tables import HookTable

if TYPE_CHECKING:
    from segfmu.validation.files.crane_file import CraneFile
    from segfmu.validation.files.mission import Mission



class ModelTables(Table):
    """Tables of a crane file that make a crane one of a further model."""

    hook: Annotated[
        HookTable | None, Key("hook on the rope, from which the load hangs by a sling")
    ] = None


FURTHER = (HOOK,)
MODELS = (GANTRY, *FURTHER)


def table_of(model: CraneModel, crane: CraneFile) -> Any:
    """The table of a crane file that a model has; None without one."""
    return getattr(crane, model.key) if model.key else None


def model_of(crane: CraneFile) -> CraneModel:
    """The model of a crane file."""
    return next((m for m in FURTHER if table_of(m, crane) is not None), GANTRY)


def check_models(mission: Mission) -> None:
    """Refuse what a mission asks of its model in vain, and another model of the true crane.

    Raises
    ------
    InputError
        For the first key that does not fit.
    """
    own, true = model_of(mission.crane), model_of(mission.simulated)
    if own is GANTRY and true is not GANTRY:
        raise InputError(
            f"true_crane.{true.key}: the crane that is planned for has no {true.key}; add "
            f"[crane.{true.key}], or [{true.key}] to the crane file"
        )
    own.check_mission(mission)


def require_gantry(crane: AnyCrane, what: str) -> Crane:
    """The crane, if it is the gantry crane.

    Raises
    ------
    InputError
        Telling `what` there is not of another model.
    """
    for model in FURTHER:
        if isinstance(crane, model.parameters):
            raise InputError(
                f"{model.key}: a crane with a {model.key} has no {what}; take [{model.key}] out of "
                f"the crane file, or [crane.{model.key}] out of the mission"
            )
    assert isinstance(crane, Crane)
    return crane


def usual(value: Any, name: str) -> str:
    """Text of the default of a mission's key, with those of the models."""
    return _stated(value, {m.key: m.defaults[name] for m in FURTHER if name in m.defaults})


def usual_source() -> str:
    """Text of what the feedback knows unless it is said."""
    return _stated(GANTRY.source, {m.key: m.source for m in FURTHER if m.source != GANTRY.source})


def _stated(value: Any, others: dict[str, Any]) -> str:
    rest = (f"with a {key} `{json.dumps(own)}`" for key, own in others.items())
    return "; ".join((f"`{json.dumps(value)}`", *rest))


def noted(text: str, name: str) -> str:
    """Description of a mission's key, with what it means for the models."""
    return "; ".join((text, *(m.notes[name] for m in FURTHER if name in m.notes)))
