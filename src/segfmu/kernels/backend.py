"""The entry points of the kernels that other layers call."""

from segfmu.kernels.evaluate import evaluate
from segfmu.kernels.plan import count_pieces, expand_plan, plan_phases

__all__ = ["count_pieces", "evaluate", "expand_plan", "plan_phases"]
