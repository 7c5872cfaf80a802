"""Interfaces of planner and crane."""

from dataclasses import replace

from segfmu.fmu.feedforward.interface import WAYPOINTS
from segfmu.fmu.gantry_crane import interface as crane
from segfmu.fmu.gantry_crane.pair import GANTRY
from segfmu.fmu.gantry_feedforward import interface as feedforward
from segfmu.fmu.model import Model
from segfmu.fmu.pair import ModelPair
from segfmu.fmu.standard.spec import parameter

MASS = parameter("spreader.mass", 0.0, "kg", "mass of the spreader", minimum=0.0)


def planner(most=WAYPOINTS):
    plain = feedforward.spec(most)
    return replace(plain, name="SpreaderFeedforward", variables=(MASS, *plain.variables))


def plant():
    plain = crane.spec()
    return replace(plain, name="SpreaderCrane", variables=(*plain.variables, MASS))


SPREADER = ModelPair(
    tuple(
        Model(own().name, "segfmu.fmu.spreader", own, plain.native_spec, plain.largest)
        for own, plain in zip((planner, plant), GANTRY.models, strict=True)
    ),
    planner, plant, crane.held, ("SpreaderCoupled", "crane"), "", GANTRY.hanging, GANTRY.ropes,
)
