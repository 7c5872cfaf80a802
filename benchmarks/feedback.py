"""The feedback on cranes that differ from the planned ones: better than none, damped, taut."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from benchmarks.feedback_cranes import Perturbed, perturbed_cranes
from benchmarks.report import Part, Record, Section, Settings
from segfmu import SimulationError
from segfmu.crane import Plant, Setpoints, TrackingController
from segfmu.fmu.gantry_crane.feedback_parameters import gains_from, nominal_from, tracking_from
from segfmu.kernels.crane.records import PlantStatus, State

COUNT, QUICK = 200, 20
DESIGNS = ("lqr", "flatness")
SWAY, CALM = np.radians(5.0), np.radians(1.0)
# periods of the pendulum after the move; residual sway and last error are those of the last one
SETTLING = 6.0
# ticks of the controller in a step of the simulation; setpoints are linear within it
TICKS = 4


@dataclass(frozen=True)
class Outcome:
    """What became of a move.

    Attributes
    ----------
    failure : str
        Empty, or what ended it.
    error, last : float
        RMS horizontal distance of the load from its plan [m], and the largest in the last period.
    sway : float
        Largest angle between the rope and the vertical in the last period [rad].
    """

    failure: str
    error: float
    last: float
    sway: float


class Move:
    """A perturbed crane with its setpoints, to be moved with and without feedback."""

    def __init__(self, case: Perturbed) -> None:
        self.case = case
        known = case.values(DESIGNS[0])
        self.step = TICKS * float(known["feedback.sample_time"])
        self.period = 2.0 * np.pi * np.sqrt(case.longest / case.nominal.gravity)
        times = np.arange(0.0, case.end + SETTLING * self.period, self.step)
        forces, velocities = case.feedforward.force(times), case.feedforward.velocity(times)
        self.states = case.feedforward.state(times)
        self.setpoints = [
            Setpoints(*row) for row in zip(forces, velocities, self.states, strict=True)
        ]
        self.places = case.feedforward.load(times)[1:, :2]

    def controller(self, design: str) -> TrackingController:
        """The feedback that GantryCrane has by default for what its user knows."""
        value = self.case.values(design).__getitem__
        nominal = nominal_from(value)
        length = float(self.states[0, State.POSITION + 2])
        return tracking_from(value, nominal, gains_from(value, nominal, length))

    def run(self, controller: TrackingController, swing: float = 0.0) -> Outcome:
        """Move from a sway [rad], along both axes."""
        case, start = self.case, self.states[0].copy()
        start[State.POSITION + 2] += case.longer
        start[State.ANGLE : State.VELOCITY] += swing / np.sqrt(2.0) * np.array([1.0, -1.0])
        controller.reset()
        plant = Plant(
            case.crane, start, self.setpoints[0], controller, driven=case.driven, rig=case.rig
        )
        found = np.zeros((len(self.places), State.SIZE))
        try:
            for row, setpoints in enumerate(self.setpoints[1:]):
                plant.step(self.step, setpoints)
                found[row] = plant.state
        except SimulationError as error:
            slack = plant.ending[0] == PlantStatus.SLACK_ROPE
            return Outcome("slack rope" if slack else str(error), np.inf, np.inf, np.inf)
        return self._outcome(found)

    def _outcome(self, states: np.ndarray) -> Outcome:
        x, y, length, phi_x, phi_y = states.T[: State.VELOCITY]
        load = np.array([x + length * np.sin(phi_x), y - length * np.cos(phi_x) * np.sin(phi_y)])
        errors = np.hypot(*(load - self.places.T))
        angles = np.arccos(np.cos(phi_x) * np.cos(phi_y))
        last = round(self.period / self.step)
        return Outcome(
            "", float(np.sqrt(np.mean(errors**2))), float(errors[-last:].max()),
            float(angles[-last:].max()),
        )


@dataclass(frozen=True)
class Compared:
    """Moves of a crane: without feedback, and by design undisturbed and from SWAY."""

    move: Move
    alone: Outcome
    undisturbed: dict[str, Outcome]
    swinging: dict[str, Outcome]

    @property
    def name(self) -> str:
        """The crane's."""
        return self.move.case.name

    def worse(self, design: str) -> bool:
        """Whether an undisturbed move is worse with feedback, beyond the sensors' resolution."""
        with_it, place = self.undisturbed[design], self.move.case.resolution
        angle = place / self.move.case.longest
        return (
            bool(with_it.failure) or with_it.error > self.alone.error + place
            or with_it.last > self.alone.last + place or with_it.sway > self.alone.sway + angle
        )

    def swings(self, design: str) -> bool:
        """Whether the sway from SWAY does not end below CALM."""
        return not self.swinging[design].sway < CALM

    def slack(self, design: str) -> bool:
        """Whether the rope went slack, or the move failed in another way."""
        return bool(self.undisturbed[design].failure or self.swinging[design].failure)


def compare(case: Perturbed) -> Compared:
    """All moves of a crane."""
    move = Move(case)
    controllers = {design: move.controller(design) for design in DESIGNS}
    undisturbed = {design: move.run(c) for design, c in controllers.items()}
    swinging = {design: move.run(c, SWAY) for design, c in controllers.items()}
    idle = controllers[DESIGNS[0]]
    idle.enabled = False
    return Compared(move, move.run(idle), undisturbed, swinging)


def measure(settings: Settings) -> Part:
    """Counts over random cranes, and the cranes that are counted."""
    found = [compare(c) for c in perturbed_cranes(QUICK if settings.samples <= 100 else COUNT)]
    failures: list[Record] = [
        {"crane": c.name, "design": d, "what": what}
        for c in found for d in DESIGNS
        for what, holds in (
            ("worse", c.worse(d)), ("swings", c.move.case.driven and c.swings(d)),
            ("slack", c.slack(d)),
        ) if holds
    ]
    return Part(
        "Feedback of perturbed cranes",
        (Section("moves of random cranes, 1 kg to 40 t, ropes of 0.5 to 20 m", counts(found)),
         Section("cranes that are counted", failures)),
        (
            "worse: RMS or last horizontal error or residual sway above that without feedback by "
            "more than a step of the positions and one of the angles together",
            "from 5 degrees of sway: below 1 degree in the last of six periods after the move",
        ),
    )


def counts(found: Iterable[Compared]) -> list[Record]:
    """One record a kind of drives and design."""
    records: list[Record] = []
    for driven in (True, False):
        chosen = [c for c in found if c.move.case.driven == driven]
        for design in DESIGNS:
            records.append({
                "drives": "velocity" if driven else "force", "design": design,
                "cranes": len(chosen),
                "worse than without": sum(c.worse(design) for c in chosen),
                "1 degree or more from 5": sum(c.swings(design) for c in chosen),
                "slack rope or failed": sum(c.slack(design) for c in chosen),
                "failed without": sum(bool(c.alone.failure) for c in chosen),
            })
    return records
