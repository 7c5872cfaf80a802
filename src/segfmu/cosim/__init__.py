"""Co-simulation of FMUs by a small master based on fmpy."""

from segfmu.cosim.master import require_steps, simulate
from segfmu.cosim.result import write_csv

__all__ = ["require_steps", "simulate", "write_csv"]
