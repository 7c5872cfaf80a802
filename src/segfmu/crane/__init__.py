"""The gantry crane: equations of motion, flat inverse, plant, control, and control baselines."""

from segfmu.crane.actuators import ActuatedPlan, bound_uses, plan_actuated
from segfmu.crane.bounds import ActuatorBounds, BoundUse
from segfmu.crane.controller import Controller
from segfmu.crane.disturbance import Gust, PayloadChange, Wind
from segfmu.crane.equipment import Drive, Friction, TravelLimits
from segfmu.crane.feedback import PayloadSchedule, SwayFeedback, Weights, design_schedule
from segfmu.crane.feedback import design as design_lqr
from segfmu.crane.feedforward import Compensation, Feedforward
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.inverse import FlatInverse
from segfmu.crane.observer import Observer, Uncertainty, design_observer
from segfmu.crane.operator import Operator
from segfmu.crane.parameters import Crane
from segfmu.crane.plant import Plant
from segfmu.crane.rig import Rig
from segfmu.crane.sensors import Sensors
from segfmu.crane.setpoints import Setpoints
from segfmu.crane.shaping import Shaped, Shaper, Trapezoid, zv, zvd
from segfmu.crane.stability import largest_eigenvalue, stability_map
from segfmu.crane.tracking import TrackingController

__all__ = [
    "ActuatedPlan", "ActuatorBounds", "BoundUse", "Compensation", "Controller", "Crane",
    "Drive", "Feedforward", "FlatInverse", "Friction", "Gust", "Observer", "Operator",
    "PayloadChange", "PayloadSchedule", "Plant", "Rig", "Sensors", "Setpoints", "Shaped",
    "Shaper", "SwayFeedback", "TrackingController", "Trapezoid", "TravelLimits",
    "Uncertainty", "Weights", "Wind", "bound_uses", "design_flat", "design_lqr",
    "design_observer", "design_schedule", "largest_eigenvalue", "plan_actuated",
    "stability_map", "zv", "zvd",
]
