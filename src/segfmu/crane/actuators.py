"""Plans that are as short as the drives of a crane allow.

limit_search.py finds the limits of the load's motion; demand.py measures what the result asks of
the drives.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, require_callable
from segfmu.crane.bounds import ActuatorBounds, BoundUse, require_bounds, uses
from segfmu.crane.checks import require_kind
from segfmu.crane.contacts import NONE, resistance
from segfmu.crane.demand import demands_in_state, peaks
from segfmu.crane.drive_refusals import exceeded, refused, require_below, require_start
from segfmu.crane.drive_task import Task
from segfmu.crane.equipment import Friction
from segfmu.crane.flat_models import model_of, require_flat, require_force
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.limit_search import KEPT, Found, LimitSearch
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels.limits.records import LimitRow
from segfmu.planning.clearance import Clearance
from segfmu.planning.limits import NAMES, Limits, limited
from segfmu.planning.planner import plan
from segfmu.planning.request import checked_request, position_range
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint

# a bound is active if it is used beyond this share
ACTIVE = 0.999
# for the checks of arguments where none are given
ANY_LIMITS = Limits(1.0, 1.0)
# limits that are searched for; higher ones stay as they are given
SEARCHED = LimitRow.VELOCITY_MIN


@dataclass(frozen=True, eq=False)
class ActuatedPlan:
    """A trajectory within the bounds, and the use of every bound.

    Attributes
    ----------
    trajectory : Trajectory
        Its `limits` are those found.
    uses : tuple of BoundUse
        Exact peaks of forces, velocities, accelerations and powers (bridge, trolley, hoist each)
        and of both sway angles, and the farthest places, with their bounds and times.
    """

    trajectory: Trajectory
    uses: tuple[BoundUse, ...]

    @property
    def active(self) -> tuple[BoundUse, ...]:
        """Bounds used by more than 99.9 %, the most used first."""
        used = [found for found in self.uses if found.use >= ACTIVE]
        return tuple(sorted(used, key=lambda found: -found.use))

    @property
    def passed(self) -> bool:
        """Whether all bounds hold, to 1e-9."""
        return all(found.use <= KEPT for found in self.uses)


def plan_actuated(
    crane: AnyCrane,
    waypoints: Sequence[Waypoint],
    limits: Limits | None,
    bounds: ActuatorBounds,
    *,
    smoothness: int = 4,
    shape: str = "plateau",
    synchronize: str = "waypoints",
    sample_time: float | None = None,
    duration: float | None = None,
    position_min: ArrayLike | None = None,
    position_max: ArrayLike | None = None,
    axis_names: Sequence[str] | None = None,
    clearance: Clearance | None = None,
    friction: Friction = NONE,
    progress: Callable[[float], None] = lambda _: None,
) -> ActuatedPlan:
    """Plan the load's trajectory as fast as the bounds of the crane's drives allow.

    Limits of velocity, acceleration, jerk and snap are found for each axis by itself, and free
    states with them; where a drive or a limit of the load differs by direction, limits of velocity
    and acceleration for each. If the plan with the given limits keeps the bounds, it is the result.

    Parameters
    ----------
    crane : Crane or HookCrane
    waypoints : sequence of Waypoint
        Of the axes x, y, z.
    limits : Limits or None
        Limits of the load that hold as well; None for those that follow from the bounds alone.
    bounds : ActuatorBounds
        Of the drives and, by `ActuatorBounds.tightened`, those that the mission sets itself.
    smoothness, shape, synchronize, sample_time, duration, position_min, position_max, axis_names
        As for `plan`; smoothness 4 or more, with a hook 6.
    clearance : Clearance, optional
        Workspace and obstacles; the search rejects plans that do not keep off them. With a hook
        obstacles must have `rope=False`, as rope and sling are not judged.
    friction : Friction, optional
        Of the axes, which the drives overcome as well; none by default.
    progress : callable, optional
        Called with the share of the search that is done, from 0 to 1.

    Raises
    ------
    InputError
        As `plan` and `FlatInverse`; also if neither limits nor bounds restrict an axis.
    InfeasibleError
        If no plan keeps limits and bounds. It names the bound, the value needed, and the time or
        the waypoint.
    """
    require_callable("progress", progress)
    require_bounds("bounds", bounds)
    if not isinstance(clearance, Clearance | None):
        raise InputError(f"clearance must be a segfmu.Clearance, got {type(clearance).__name__}")
    options: dict[str, Any] = {
        "smoothness": smoothness, "shape": shape, "synchronize": synchronize,
        "axis_names": axis_names,
    }
    timing: dict[str, Any] = {"sample_time": sample_time, "duration": duration}
    request = checked_request(
        waypoints, ANY_LIMITS if limits is None else limits, **options, **timing
    )
    require_flat(crane, len(request.axis_names), smoothness)
    _require_judged(crane, smoothness, clearance)
    resistance(crane, friction)
    within: dict[str, Any] = {"position_min": position_min, "position_max": position_max}
    refusal: InfeasibleError | None = None
    if limits is not None:
        found, refusal = _as_limited(
            crane, bounds, friction, clearance,
            lambda: plan(waypoints, limits, **options, **within, **timing),
        )
        if found is not None:
            return found
    allowed = position_range(position_min, position_max, len(request.axis_names))
    task = _task(crane, request.waypoints, limits, bounds, options, allowed, clearance, friction)
    try:
        _require_states(task, bounds)
        require_start(task, bounds)
        require_below(task)
        best = _searched(task, bounds, timing, progress)
    except InfeasibleError as error:
        raise refusal or error from None
    return _measured(crane, bounds, friction, best.trajectory)


def _require_judged(
    crane: AnyCrane, smoothness: int, clearance: Clearance | None
) -> None:
    """Refuse what is not judged: forces that jump, and with some models a rope near obstacles."""
    require_force(crane, smoothness)
    unjudged = model_of(crane).unjudged
    if unjudged and clearance is not None:
        for number, obstacle in enumerate(clearance.obstacles, 1):
            if obstacle.rope:
                raise InputError(
                    f"obstacle {number}: {unjudged}, are not judged; give it rope=False, and a "
                    "margin that keeps them off"
                )


def bound_uses(
    crane: AnyCrane, trajectory: Trajectory, bounds: ActuatorBounds,
    friction: Friction = NONE,
) -> tuple[BoundUse, ...]:
    """The exact use of every bound of the drives by a trajectory of x, y and z."""
    model_of(crane)
    require_kind("trajectory", trajectory, Trajectory)
    require_flat(crane, len(trajectory.axis_names), trajectory.smoothness)
    require_kind("bounds", bounds, ActuatorBounds)
    require_kind("friction", friction, Friction)
    return uses(bounds, *peaks(crane, trajectory, friction, bounds.lag))


def _measured(
    crane: AnyCrane, bounds: ActuatorBounds, friction: Friction, trajectory: Trajectory
) -> ActuatedPlan:
    return ActuatedPlan(trajectory, bound_uses(crane, trajectory, bounds, friction))


def _as_limited(
    crane: AnyCrane, bounds: ActuatorBounds, friction: Friction,
    clearance: Clearance | None, made: Callable[[], Trajectory],
) -> tuple[ActuatedPlan | None, InfeasibleError | None]:
    """The plan with the given limits, if nothing needs a slower one; why it was refused, if so."""
    try:
        trajectory = made()
        found = _measured_taut(crane, bounds, friction, trajectory)
        if clearance is not None and found is not None and found.passed:
            clearance.require(trajectory, crane.gravity)
    except InfeasibleError as error:
        # slower plans, and others of free states, can keep the range and the clearance
        if bounds.known:
            return None, error
        raise
    return (found if found is not None and found.passed else None), None


def _measured_taut(
    crane: AnyCrane, bounds: ActuatorBounds, friction: Friction, trajectory: Trajectory
) -> ActuatedPlan | None:
    """A plan as it uses the bounds; None if the rope goes slack, which a slower one may avoid."""
    try:
        model_of(crane).require_taut(crane, trajectory)
    except InfeasibleError:
        if bounds.known:
            return None
        raise
    return _measured(crane, bounds, friction, trajectory)


def _task(
    crane: AnyCrane, waypoints: tuple[Waypoint, ...], limits: Limits | None,
    bounds: ActuatorBounds, options: dict[str, Any], allowed: FloatArray | None,
    clearance: Clearance | None, friction: Friction,
) -> Task:
    caps, higher = _caps(limits)
    return Task(
        crane, waypoints, bounds.record, caps, higher, options, clearance, friction, bounds.lag,
        allowed=allowed,
    )


def _caps(limits: Limits | None) -> tuple[FloatArray, dict[str, Any]]:
    """Given limits as the task has them, (3, LimitRow.SIZE), and those above the snap."""
    caps, higher = np.zeros((3, LimitRow.SIZE)), {}
    if limits is not None:
        for i, name in enumerate(NAMES):
            values = np.broadcast_to(getattr(limits, name), (3,))
            if i < SEARCHED:
                caps[:, i] = np.where(np.isfinite(values), values, 0.0)
            elif limited(values):
                higher[name] = values
        caps[:, SEARCHED:] = limits.lower(3)
    return caps, higher


def _require_states(task: Task, bounds: ActuatorBounds) -> None:
    """Refuse waypoints whose states alone exceed a bound."""
    for number, (point, led) in enumerate(zip(task.resting, task.led, strict=True), 1):
        if led.any():
            continue
        needs = demands_in_state(task.crane, point, task.friction, bounds.lag)
        told = uses(bounds, needs, np.zeros(needs.shape))
        # an end stop is refused with when the plan is there
        found = max((use for use in told if use.unit != "m"), key=lambda use: use.use)
        if found.use > KEPT:
            raise exceeded(f"waypoint {number}: ", found, "its state alone")


def _searched(
    task: Task, bounds: ActuatorBounds, timing: dict[str, Any], progress: Callable[[float], None]
) -> Found:
    """The shortest plan found, with a sample time or a duration if there is one."""
    search = LimitSearch(task)
    found = search.run(timing, progress)
    if found is None:
        raise refused(task, search, bounds)
    return found
