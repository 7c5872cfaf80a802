"""HookFeedforward and HookCrane belong together."""

from __future__ import annotations

from segfmu.fmu.hook_crane import interface as crane
from segfmu.fmu.hook_crane.model import HOOK_CRANE
from segfmu.fmu.hook_feedforward import interface as feedforward
from segfmu.fmu.hook_feedforward.model import HOOK_FEEDFORWARD
from segfmu.fmu.pair import GREY, ORANGE, ModelPair

HOOK = ModelPair(
    (HOOK_FEEDFORWARD, HOOK_CRANE), feedforward.spec, crane.spec, crane.held,
    ("HookCoupled", "crane"),
    "HookFeedforward, HookCrane and HookCoupled are the same for a load that hangs by a sling on a "
    "hook; the feedback of HookCrane needs co-simulation: here it is switched off.",
    ((-2, 10, 8, GREY), (10, -75, 22, ORANGE)),
    ((-20, 60), (-2, 10), (6, -55)),
)
