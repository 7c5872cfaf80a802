"""GantryFeedforward and GantryCrane belong together."""

from __future__ import annotations

from segfmu.fmu.gantry_crane import interface as crane
from segfmu.fmu.gantry_crane.model import GANTRY_CRANE
from segfmu.fmu.gantry_feedforward import interface as feedforward
from segfmu.fmu.gantry_feedforward.model import GANTRY_FEEDFORWARD
from segfmu.fmu.pair import ORANGE, ModelPair

GANTRY = ModelPair(
    (GANTRY_FEEDFORWARD, GANTRY_CRANE), feedforward.spec, crane.spec, crane.held,
    ("Coupled", "gantry"),
    "GantryFeedforward plans the motion of a crane's load and inverts the crane; GantryCrane is "
    "the crane with drives, sensors and sway feedback. The partial model Coupled has both, "
    "connected.",
    ((20, -30, 22, ORANGE),), ((-20, 60), (10, -10)),
)
