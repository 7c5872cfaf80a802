"""What a third crane gives once it is registered; run in a copy of the package that has it."""

import numpy as np

import segfmu
from segfmu.crane import FlatInverse, Plant, Setpoints
from segfmu.validation.files.crane_models import MODELS
from segfmu.validation.planned import planned
from segfmu.validation.scenario import specs

LAB = segfmu.Crane(2.2, 1.155, 1.0, rope_min=0.2, rope_max=1.5)
HEAVY = segfmu.Crane(2.2, 1.155, 1.5, rope_min=0.2, rope_max=1.5)
OWN = segfmu.SpreaderCrane(LAB, 0.5)
LIMITS = segfmu.Limits(0.6, 0.8, 4.0, 40.0)
POINTS = [segfmu.Waypoint([0.0, 0.0, -0.9]), segfmu.Waypoint([0.6, 0.4, -0.6])]


class Idle:
    """A controller that corrects nothing."""

    sample_time = 0.01

    def sample(self, time, measured, reference, setpoint):
        return np.zeros(3)


def planning() -> None:
    """Setpoints are those of a load of both masses; prints the duration within drives."""
    bounds = segfmu.ActuatorBounds(force=[4.0, 3.0, 17.0], velocity=0.6)
    # along the axis that interpreted kernels search soonest, and whose drive holds both masses
    along = [POINTS[0], segfmu.Waypoint([0.0, 0.0, -0.6])]
    print(segfmu.plan_actuated(OWN, along, None, bounds).trajectory.duration)
    trajectory = segfmu.plan(POINTS, LIMITS)
    times = np.linspace(0.0, trajectory.duration, 101)
    for name in ("force", "velocity", "state"):
        own, heavy = (getattr(FlatInverse(c, trajectory), name)(times) for c in (OWN, HEAVY))
        assert np.abs(own - heavy).max() < 1e-12, name


def simulating() -> None:
    """The plant moves as that of a load of both masses does."""
    start = np.array([0.1, -0.2, 0.6, 0.2, -0.1, 0.1, -0.05, 0.02, 0.3, -0.2])
    states = []
    for crane in (OWN, HEAVY):
        given = Setpoints(np.array([0.8, -0.5, -14.9]), np.zeros(3), np.zeros(10))
        plant = Plant(crane, start, given, Idle())
        for _ in range(20):
            plant.step(0.05, given)
        states.append(plant.state)
    assert np.abs(states[0] - states[1]).max() < 1e-9


def files() -> None:
    """A mission with the key is planned, and both interfaces have the mass."""
    own = {"bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0,
           "spreader": {"mass": 0.5}}
    task = segfmu.load_mission({
        "crane": own, "limits": LIMITS, "waypoints": POINTS,
    })
    assert task.build_crane() == segfmu.SpreaderCrane(task.build_crane().crane, 0.5)
    trajectory = planned(task)
    for spec in specs(task, trajectory):
        assert spec.variable("spreader.mass").start == 0.5
    assert [model.key for model in MODELS] == ["", "hook", "spreader"]


planning()
simulating()
files()
