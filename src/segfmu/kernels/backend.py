"""The entry points of the kernels that other layers call."""

from segfmu.kernels.evaluate import evaluate
from segfmu.kernels.expand import count_pieces, expand_plan
from segfmu.kernels.plan import plan_phases

__all__ = ["count_pieces", "evaluate", "expand_plan", "plan_phases"]
