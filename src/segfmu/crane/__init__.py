"""The gantry crane: parameters, equations of motion, flat inverse, sway feedback."""

from segfmu.crane.actuators import ActuatedPlan, ActuatorBounds, plan_actuated
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.inverse import FlatInverse
from segfmu.crane.parameters import Crane

__all__ = [
    "ActuatedPlan",
    "ActuatorBounds",
    "Crane",
    "FlatInverse",
    "SwayFeedback",
    "plan_actuated",
]
