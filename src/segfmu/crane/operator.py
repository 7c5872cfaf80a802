"""A crane under an operator's hand: commands at any time, plans while it runs."""

from __future__ import annotations

import math
from copy import deepcopy

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, finite_number, numbers, shown
from segfmu.crane.bounds import ActuatorBounds
from segfmu.crane.contacts import NONE
from segfmu.crane.equipment import Friction
from segfmu.crane.flat_models import require_gantry
from segfmu.crane.inverse import ACCELERATION, FORCE, ORDERS, STATE
from segfmu.crane.operation import OperatedMotion
from segfmu.crane.operation_command import HOLD, MODES, changed_command, first_command
from segfmu.crane.operation_emergency import (
    EmergencyStop,
    foreseen,
    require_brakes,
    reset,
    trip,
    tripped,
)
from segfmu.crane.operation_start import (
    decelerations,
    known_of,
    refuse_rest,
    require_hanging,
    require_plan,
    require_site,
    resting,
)
from segfmu.crane.parameters import Crane
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import FlatInverse as Results
from segfmu.kernels.crane.records import State
from segfmu.kernels.operation.records import (
    Command,
    DriveBrakes,
    Known,
    Operation,
    OperationMode,
    OperationStatus,
    Progress,
    Tries,
)
from segfmu.kernels.planner.records import PlanOptions
from segfmu.planning.clearance import Clearance
from segfmu.planning.limits import Limits
from segfmu.planning.pieces import Pieces
from segfmu.planning.planner import plan
from segfmu.planning.request import checked_request, checked_smoothness
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint

STATUSES = tuple(name.lower() for name in OperationStatus.items())
UNBOUNDED = ActuatorBounds()
FREE = Clearance()


class Operator:
    """A motion of a crane's load that follows commands.

    Every plan is proved to keep the limits, the bounds of the drives, the workspace and the
    obstacles until the load rests; where none for a command does, the one before goes on. Whatever
    is commanded, the load's position and its derivatives up to the smoothness are continuous; only
    behind a measured swing or an emergency stop they are so up to the velocity, until it rests.

    Parameters
    ----------
    crane : Crane
    limits : Limits
        Of the load in x, y and z.
    start : array_like, shape (3,) or (10,), or Trajectory
        Where the load rests [m]; a measured state of the crane, which swings and is brought to rest
        at first: positions of bridge and trolley and length of the rope [m], sway angles [rad], and
        the rates of these; or a plan that is followed at first, in the mode "mission".
    bounds : ActuatorBounds, optional
        Of the drives and of the sway.
    clearance : Clearance, optional
        Workspace and obstacles, 16 at most.
    smoothness : int
        4 to 6; that of the plan, if there is one.
    shape, synchronize : str
        Of the ways to a target, as for `plan`.
    hold : float
        How long a commanded velocity is held beyond the next step [s]; if nothing renews it, the
        load stops then.
    tries : int
        How many plans are tried in a step at most, 1 to 9; where none of them is taken, the next
        step tries others, and the plan before goes on.
    friction : Friction, optional
        Of the axes, which the forces of the drives have room for.
    brakes : array_like, scalar or shape (3,), optional
        Decelerations of the drives' brakes [m/s2], which stop a drive that trips; 0, or unless
        given: the drives' greatest ones.

    Raises
    ------
    InputError
        For invalid arguments.
    InfeasibleError
        If the load cannot be at the start, or be brought to rest from there.
    """

    def __init__(
        self,
        crane: Crane,
        limits: Limits,
        start: ArrayLike | Trajectory,
        *,
        bounds: ActuatorBounds = UNBOUNDED,
        clearance: Clearance = FREE,
        smoothness: int = 4,
        shape: str = "plateau",
        synchronize: str = "waypoints",
        hold: float = HOLD,
        tries: int = Tries.USUAL,
        friction: Friction = NONE,
        brakes: ArrayLike | None = None,
    ) -> None:
        planned = start if isinstance(start, Trajectory) else None
        smoothness = checked_smoothness(smoothness if planned is None else planned.smoothness)
        require_gantry(crane, 3 if planned is None else planned.axes, smoothness)
        require_site(limits, bounds, clearance)
        if planned is not None:
            require_plan(crane, planned, bounds, clearance, friction)
        command = first_command(hold, tries)
        known = known_of(crane, limits, bounds, clearance, friction)
        asked = checked_request(
            [Waypoint(np.zeros(3))] * 2, limits, smoothness, shape, synchronize, None, None, None,
        ).problem.options
        known[Known.OPTIONS, : PlanOptions.SIZE] = asked.vector
        if brakes is not None:
            known[Known.BRAKES, : DriveBrakes.SIZE] = decelerations(brakes)
        self.crane = crane
        self._motion = OperatedMotion(limits.table(3, smoothness), known)
        self._motion.command[: command.size] = command
        self._masses = np.array(crane.masses)
        self._time, self._lost = 0.0, 0.0
        self._begin(start, smoothness)
        if self.status != "taken":
            still = plan([Waypoint(self.load[0])] * 2, limits, smoothness=smoothness)
            refuse_rest(self.refused, crane, still, bounds, clearance, friction)

    def _begin(self, start: ArrayLike | Trajectory, smoothness: int) -> None:
        """Begin with the plan; or at rest, where a stop shows whether that is allowed."""
        if not isinstance(start, Trajectory) and numbers("start", start).size == State.SIZE:
            backend.begin_operation(0.0, self._motion.record)
            self._motion.command[Command.MODE] = OperationMode.STOP
            self._take_over("start", start)
            return
        if isinstance(start, Trajectory):
            pieces = start.timing, start.coefficients, start.offsets
        else:
            pieces = resting(start, smoothness)
        if not self._motion.begin(0.0, *pieces):
            raise InputError(
                f"start has {int(pieces[2][-1])} polynomial pieces, too many to be followed; plan "
                "fewer waypoints"
            )
        if not isinstance(start, Trajectory):
            self._motion.command[Command.MODE] = OperationMode.STOP
            self._motion.operate(0.0, 0.0)
        self._motion.command[Command.MODE] = OperationMode.MISSION

    def take_over(self, state: ArrayLike) -> None:
        """Begin anew in a measured state, from now on, and bring the load to rest.

        Parameters
        ----------
        state : array_like, shape (10,)
            As `FlatInverse.state`. Commands follow when the load rests; only a target is gone to
            at once, where there is a way.

        Raises
        ------
        InputError
            If that is no state of a load below its crane, or the acceleration of a drive has no
            bound.
        InfeasibleError
            If no way from there to rest keeps the bounds; what was followed before goes on.
        """
        self._take_over("state", state)

    def _take_over(self, name: str, state: ArrayLike) -> None:
        measured = require_hanging(name, state)
        require_brakes(self._motion, "a swing that is taken over")
        self._motion.command[Command.MEASURED : Command.SIZE] = measured
        status = STATUSES[self._motion.take_over(self._time)]
        if status != "taken":
            raise InfeasibleError(
                f"{name}: no way from there to rest keeps {status}; widen that, or let the swing "
                "decay"
            )

    def __copy__(self) -> Operator:
        """Another one that goes on from here by itself."""
        return deepcopy(self)

    def __repr__(self) -> str:
        at = ", ".join(f"{p:.4g}" for p in self.load[0])
        return f"Operator({self.mode} at {self.time:.6g} s, load at ({at}) m, {self.status})"

    def command(
        self,
        mode: str,
        velocity: ArrayLike | None = None,
        *,
        target: ArrayLike | None = None,
        distance: ArrayLike | None = None,
        scale: float | None = None,
    ) -> None:
        """Command what the next steps follow; what is not given stays as it was.

        Parameters
        ----------
        mode : {"mission", "target", "velocity", "stop", "inching", "emergency"}
            "mission" follows the plan that there is to its end. "emergency" stops bridge, trolley
            and hoist as fast as their drives can, and the load swings on: no other command is
            followed until they stand, then the first one but "mission" takes the swing over. Where
            no such stop keeps the bounds, it is "stop".
        velocity : array_like, shape (3,), optional
            Of the load [m/s]; beyond the limits, the limits. In the mode "inching" its signs are
            pushes: each change to one moves the target by the distance; one that is there when the
            mode begins is none.
        target : array_like, shape (3,), optional
            Where to go [m].
        distance : array_like, scalar or shape (3,), optional
            Of a push [m], at least 0.
        scale : float, optional
            Share of the velocity limits, 0 to 1; less than 0.001 stops the load.

        Raises
        ------
        InputError
            For invalid arguments, a target or a push without one or without a distance, and for an
            emergency stop of a drive whose acceleration has no bound. Nothing is changed then.
        """
        command = changed_command(
            self._motion.command, mode, velocity=velocity, target=target, distance=distance,
            scale=scale,
        )
        if command[Command.MODE] == OperationMode.EMERGENCY:
            require_brakes(self._motion, "an emergency stop")
        self._motion.command[:] = command

    def step(self, duration: float) -> FloatArray:
        """Follow the command for a time [s].

        Returns
        -------
        ndarray, shape (5, 3)
            Position of the load and its derivatives up to the snap, at the end.

        Raises
        ------
        InputError
            For a duration that is not above 0.
        """
        given = finite_number("duration", duration)
        if given <= 0.0:
            raise InputError(f"duration must be a time > 0 s, got {shown(duration)}")
        self._motion.operate(self._time, given)
        # without the rounding errors of many steps
        late = given - self._lost
        after = self._time + late
        self._lost = (after - self._time) - late
        self._time = after
        return self.load

    def trip(self, *drives: str) -> None:
        """Drives have tripped: from now on their brakes stop them, others stop as fast as they can.

        No other command is followed until `reset`; then the first one but "mission" takes the
        swing over.

        Parameters
        ----------
        *drives : {"bridge", "trolley", "hoist"}

        Raises
        ------
        InputError
            For another name, and if the acceleration of a drive has no bound.
        """
        trip(self._motion, drives)

    def reset(self) -> None:
        """All drives work again."""
        reset(self._motion)

    @property
    def tripped(self) -> tuple[str, ...]:
        """The drives that have tripped."""
        return tripped(self._motion)

    @property
    def emergency(self) -> EmergencyStop:
        """What an emergency stop would come to now; during one, what this one comes to.

        Raises
        ------
        InputError
            If the acceleration of a drive has no bound.
        InfeasibleError
            If no emergency stop keeps forces and powers of the drives.
        """
        return foreseen(self._motion, self._time)

    @property
    def time(self) -> float:
        """Time since the start [s]."""
        return self._time

    @property
    def mode(self) -> str:
        """The mode of the command."""
        return MODES[int(self._motion.command[Command.MODE])]

    @property
    def load(self) -> FloatArray:
        """Position of the load and its derivatives up to the snap, shape (5, 3)."""
        return self._motion.motion(self._time, ORDERS)

    @property
    def plan(self) -> Pieces:
        """What is followed unless a command changes it: pieces from `plan_begins` on, to rest."""
        timing, coefficients, offsets, _ = self._motion.pieces
        used = int(offsets[-1])
        return Pieces(timing[:used].copy(), coefficients[:used].copy(), offsets.copy())

    @property
    def plan_begins(self) -> float:
        """Time at which the plan begins [s]."""
        return self._motion.begins

    @property
    def rests_at(self) -> float:
        """Time at which the load rests if nothing is commanded any more [s].

        It is infinite after an emergency stop, as the load swings, until a command takes the swing
        over.
        """
        if self._motion.swings:
            return math.inf
        return self._motion.begins + float(self._motion.pieces[3].max())

    @property
    def status(self) -> str:
        """What became of the last command that needed a plan.

        "taken", "reduced" (slower, or some axes at rest), or what no plan for it keeps: "limits",
        "rope", "workspace", "obstacle", "drives" or "travel", where an end stop is in the way; then
        the plan before goes on, as it does if it is "pending": the command is new, the tries of a
        step are used up, and the next one tries others.
        """
        return STATUSES[self._motion.status]

    @property
    def refused(self) -> str:
        """What the last plan that was tried in vain does not keep, as `status`."""
        return STATUSES[self._motion.refused]

    @property
    def plans(self) -> int:
        """Number of the plans taken so far."""
        return int(self._motion.record[Operation.PROGRESS, Progress.PLANS])

    @property
    def attempts(self) -> int:
        """Number of the plans tried so far, those not taken included."""
        return int(self._motion.record[Operation.PROGRESS, Progress.ATTEMPTS])

    def load_at(self, time: float) -> FloatArray:
        """As `load`, at another time [s] of the present plan, (5, 3)."""
        return self._motion.motion(finite_number("time", time), ORDERS)

    @property
    def setpoints(self) -> FloatArray:
        """Forces (3), state (10) and accelerations (5) of the crane, as `FlatInverse.evaluate`.

        Without friction.
        """
        found = np.zeros(Results.SIZE)
        backend.crane_flat_inverse(
            self.load, self._masses, found[FORCE], found[STATE], found[ACCELERATION]
        )
        return found
