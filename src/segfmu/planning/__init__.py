"""The planner's Python interface: waypoints and limits in, a verified trajectory out."""

from segfmu.planning.clearance import Clearance, Obstacle
from segfmu.planning.excursions import Excursion, excursions
from segfmu.planning.limits import Limits
from segfmu.planning.planner import plan
from segfmu.planning.replanning import replan
from segfmu.planning.table import read_waypoints
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.velocity import reach_velocity, stop
from segfmu.planning.waypoint import Waypoint

__all__ = [
    "Clearance", "Excursion", "Limits", "Obstacle", "Trajectory", "Waypoint", "excursions", "plan",
    "reach_velocity", "read_waypoints", "replan", "stop",
]
