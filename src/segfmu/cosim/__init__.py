"""Co-simulation of FMUs by a small master on fmpy."""

from segfmu.cosim.master import simulate
from segfmu.cosim.result import write_csv

__all__ = ["simulate", "write_csv"]
