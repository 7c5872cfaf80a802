"""The gantry crane: parameters, equations of motion, flat inverse, sway feedback, real plant."""

from segfmu.crane.actuators import ActuatedPlan, ActuatorBounds, plan_actuated
from segfmu.crane.controller import Controller
from segfmu.crane.disturbance import Gust, PayloadChange, Wind
from segfmu.crane.equipment import Drive, Friction, TravelLimits
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.inverse import FlatInverse
from segfmu.crane.parameters import Crane
from segfmu.crane.plant import Plant, Setpoints
from segfmu.crane.rig import Rig
from segfmu.crane.sensors import Sensors

__all__ = [
    "ActuatedPlan", "ActuatorBounds", "Controller", "Crane", "Drive", "FlatInverse", "Friction",
    "Gust", "PayloadChange", "Plant", "Rig", "Sensors", "Setpoints", "SwayFeedback",
    "TravelLimits", "Wind", "plan_actuated",
]
