"""What files know of it."""

from segfmu.crane.spreader import SpreaderCrane
from segfmu.fmu.spreader.pair import SPREADER as PAIR

from segfmu.validation.files.crane_model import CraneModel

SPREADER = CraneModel(
    "spreader", PAIR, SpreaderCrane, lambda crane, table: SpreaderCrane(crane, table.mass),
    lambda crane: {"mass": crane.mass}, parts=(("spreader", "mass", "kg"),),
)
