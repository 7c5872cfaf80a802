"""Interface of HookFeedforward: planner and flat inverse of a crane with hook and sling."""

from __future__ import annotations

from functools import cache

from segfmu.fmu.feedforward.interface import (
    MOST_WAYPOINTS,
    WAYPOINTS,
    bounds,
    drives,
    limits,
    nativized,
    outputs,
    planner,
    space,
    waypoints,
)
from segfmu.fmu.gantry import crane_parameters, friction_parameters
from segfmu.fmu.hook import hook_parameters
from segfmu.fmu.standard.spec import Spec, calculated

__all__ = ["MOST_WAYPOINTS", "WAYPOINTS", "native_spec", "spec"]


@cache
def spec(most: int = WAYPOINTS) -> Spec:
    """The interface of HookFeedforward, with room for so many waypoints; they come last."""
    return Spec(
        "HookFeedforward",
        "Plans the motion of a load that hangs by a sling on the hook of a crane through waypoints "
        "within limits, and inverts this double pendulum exactly: force and velocity setpoints and "
        "the reference of load, hook and crane",
        (
            *outputs(6, {"sway": "phi", "sling": "psi"}),
            calculated("plan.duration", "s", "duration of the planned motion"),
            calculated("plan.pace", None, "pace of the motion; 1 unless it was slowed down"),
            *crane_parameters("nominal crane"),
            *hook_parameters("nominal crane"),
            *limits(),
            *planner(
                6, 5, "n: the load's position is n times differentiable; with 6 forces are "
                "continuous, with 5 velocities",
                # forces follow the sixth derivative, which in short parts of ramps is large
                "smoothstep",
            ),
            *drives(),
            *bounds(),
            *space(),
            *friction_parameters(),
            *waypoints(most),
        ),
        stop_time=8.0,
        step_size=0.001,
    )


def native_spec(own: Spec | None = None) -> Spec:
    """The interface of the native HookFeedforward, which also names time.

    It is that of `spec`, or of one with other start values.
    """
    return nativized(own or spec())
