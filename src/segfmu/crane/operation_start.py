"""What an operated motion begins with: what is known of the crane, a plan, or a state."""

from __future__ import annotations

from typing import NoReturn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.arrays import FloatArray, shown, sized
from segfmu.crane.bounds import ActuatorBounds, require_bounds
from segfmu.crane.bounds import uses as bound_uses
from segfmu.crane.contacts import resistance
from segfmu.crane.demand import peaks
from segfmu.crane.equipment import Friction
from segfmu.crane.limit_search import KEPT
from segfmu.crane.parameters import Crane
from segfmu.crane.rope import require_rope
from segfmu.crane.variables import filled
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels.clearance.records import ObstacleRow, Space, SpaceLimits
from segfmu.kernels.crane.records import Axes, RopeBounds, State
from segfmu.kernels.crane.rope import least_depth
from segfmu.kernels.numerics.numbers import FARTHEST_PLACE
from segfmu.kernels.operation.records import Known
from segfmu.kernels.planner.records import Lower
from segfmu.kernels.trajectory.records import Timing
from segfmu.planning.clearance import Clearance
from segfmu.planning.limits import Limits
from segfmu.planning.trajectory import Trajectory

# an end of the workspace [m] that is none
FAR = 1e9


def require_near(name: str, places: ArrayLike) -> None:
    """Refuse places from which no target can be given."""
    farthest = float(np.abs(places).max())
    if farthest > FARTHEST_PLACE:
        raise InputError(
            f"{name}: a place {farthest:.6g} m from the origin is beyond {FARTHEST_PLACE:g} m, "
            "where targets end; move the origin"
        )


def require_hanging(name: str, value: ArrayLike) -> FloatArray:
    """The state (10,) of a load below its crane."""
    state = sized(name, value, State.SIZE)
    angle = np.abs(state[State.ANGLE : State.VELOCITY]).max()
    if state[Axes.ROPE] < least_depth() or angle >= 1.5:
        raise InputError(
            f"{name}: a rope of {state[Axes.ROPE]:.4g} m and angles up to {angle:.4g} rad are no "
            "state of a load below its crane; give positions, rope, angles and their rates, shape "
            "(10,)"
        )
    require_near(name, state[: State.ANGLE])
    return state


def resting(start: ArrayLike, smoothness: int) -> tuple[FloatArray, FloatArray, NDArray[np.int64]]:
    """A plan that rests in a place."""
    coefficients = np.zeros((3, 2 * smoothness))
    coefficients[:, 0] = sized("start", start, 3)
    require_near("start", coefficients[:, 0])
    return np.zeros((3, Timing.SIZE)), coefficients, np.arange(4, dtype=np.int64)


def decelerations(value: ArrayLike) -> FloatArray:
    """Those of the drives' brakes [m/s2], shape (3,)."""
    given = sized("brakes", value, 3, alike=True)
    if not (given >= 0.0).all():
        raise InputError(
            f"brakes must be decelerations > 0 m/s2, or 0 for that of the drive, got {shown(value)}"
        )
    return given


def require_site(limits: Limits, bounds: ActuatorBounds, clearance: Clearance) -> None:
    """Refuse what are no limits, bounds or clearance."""
    if not isinstance(limits, Limits):
        raise InputError(f"limits must be a segfmu.Limits, got {type(limits).__name__}")
    require_bounds("bounds", bounds)
    if not isinstance(clearance, Clearance):
        kind = type(clearance).__name__
        raise InputError(f"clearance must be a segfmu.Clearance, got {kind}")


def require_plan(
    crane: Crane,
    plan: Trajectory,
    bounds: ActuatorBounds,
    clearance: Clearance,
    friction: Friction,
) -> None:
    """Refuse a plan that does not keep what plans for commands keep."""
    require_near("start", [waypoint.position for waypoint in plan.waypoints])
    require_rope(crane, plan)
    clearance.require(plan, crane.gravity)
    for use in bound_uses(bounds, *peaks(crane, plan, friction, bounds.lag)):
        if use.use > KEPT:
            raise InfeasibleError(
                f"start: the plan uses {100.0 * use.use:.4g} % of the bound of the {use.name}; "
                "plan it within the bounds"
            )


def refuse_rest(
    refused: str,
    crane: Crane,
    still: Trajectory,
    bounds: ActuatorBounds,
    clearance: Clearance,
    friction: Friction,
) -> NoReturn:
    """Refuse to begin at rest where a plan stays that lasts no time, and tell what exceeds what."""
    text = f"start: a load at rest there does not keep {refused}"
    try:
        require_plan(crane, still, bounds, clearance, friction)
    except InfeasibleError as error:
        reason = str(error).removeprefix("start: ")
        raise InfeasibleError(f"{text}: {reason}") from error
    raise InfeasibleError(f"{text}; move it, or widen that")


def known_of(
    crane: Crane, limits: Limits, bounds: ActuatorBounds, clearance: Clearance, friction: Friction
) -> FloatArray:
    """The record `Known`, without options."""
    known = np.zeros((Known.SIZE, Known.COLUMNS))
    given = resistance(crane, friction, bounds.lag)
    known[Known.CRANE, : given.size] = given
    known[Known.ROPE, : RopeBounds.SIZE] = filled(RopeBounds, crane.values().__getitem__)
    known[Known.BOUNDS, : bounds.record.size] = bounds.record
    known[Known.LOWER : Known.OBSTACLES, : Lower.SIZE] = limits.lower(3)
    space = known[Known.SPACE]
    space[Space.GRAVITY] = crane.gravity
    for place, value in (
        (Space.WORKSPACE_MIN, clearance.minimum),
        (Space.WORKSPACE_MAX, clearance.maximum),
        (Space.LOAD_SIZE, clearance.load_size),
        (Space.LOAD_CENTRE, clearance.load_centre),
    ):
        space[place : place + 3] = np.clip(value, -FAR, FAR)
    if len(clearance.obstacles) > SpaceLimits.OBSTACLES:
        raise InputError(
            f"clearance has {len(clearance.obstacles)} obstacles, at most {SpaceLimits.OBSTACLES} "
            "can be kept off while running; join some of them"
        )
    space[Space.OBSTACLES] = len(clearance.obstacles)
    for i, box in enumerate(clearance.obstacles):
        known[Known.OBSTACLES + i, : ObstacleRow.SIZE] = [
            *box.minimum,
            *box.maximum,
            box.margin,
            box.rope,
        ]
    return known
