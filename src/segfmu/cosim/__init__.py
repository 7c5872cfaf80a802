"""Co-simulation of FMUs: a system of any number of them, stepped in C or in Python."""

from segfmu.cosim.change import Change, profile
from segfmu.cosim.connection import Connection
from segfmu.cosim.master import simulate
from segfmu.cosim.points import require_steps
from segfmu.cosim.result import write_csv
from segfmu.cosim.system import System

__all__ = [
    "Change", "Connection", "System", "profile", "require_steps", "simulate", "write_csv",
]
