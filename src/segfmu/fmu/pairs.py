"""The pairs of planner and crane: those of a further crane are one more entry of `PAIRS`."""

from __future__ import annotations

from collections.abc import Sequence

from segfmu.fmu.gantry_crane.pair import GANTRY
from segfmu.fmu.hook_crane.pair import HOOK
from segfmu.fmu.standard.spec import Spec

PAIRS = (GANTRY, HOOK)
MODELS = {model.name: model for pair in PAIRS for model in pair.models}


def native(interfaces: Sequence[Spec]) -> tuple[Spec, Spec]:
    """The native interfaces of both, from those with any start values."""
    feedforward, crane = (MODELS[own.name].native_spec(own) for own in interfaces)
    return feedforward, crane
