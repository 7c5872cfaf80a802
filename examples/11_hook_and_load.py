"""What is left of the swing of hook and load behind a move, by method, with and without feedback.

The trolley moves, and in most cases the hoist lifts meanwhile. Baselines move it with a trapezoidal
velocity, plain or shaped for one or both natural frequencies at the mean rope length. The gantry
crane's feedforward takes hook and load for one load at the end of rope and sling. All trolleys
keep the same largest velocity and acceleration.
"""

from dataclasses import dataclass, replace

import numpy as np

import segfmu
from segfmu.crane import (
    FlatInverse,
    HookController,
    HookCrane,
    Plant,
    Setpoints,
    Shaped,
    Shaper,
    Trapezoid,
    design_hook,
    zv,
    zvd,
)
from segfmu.kernels import backend

PLAIN = Shaper(np.zeros(1), np.ones(1))
# places of the sling in a state, which is not measured
SLING = [5, 6, 12, 13]


@dataclass(frozen=True)
class Task:
    """A crane, its move and its limits; step: of the setpoints [s], period: of the feedback [s]."""

    name: str
    crane: HookCrane
    rope: float
    lifted: float
    distance: float
    velocity: float
    acceleration: float
    step: float
    period: float

    @property
    def swing(self) -> float:
        """Time scale of the slow swing [s]."""
        return float(np.sqrt((self.rope + self.crane.sling) / self.crane.crane.gravity))


@dataclass(frozen=True)
class Motion:
    """Setpoints of the drives and reference states until the end, at equal times."""

    velocity: np.ndarray
    reference: np.ndarray

    def setpoints(self, i: int) -> Setpoints:
        if i < len(self.velocity):
            return Setpoints(velocity=self.velocity[i], reference=self.reference[i])
        # behind the end: at rest
        rest = self.reference[-1].copy()
        rest[3:] = 0.0
        return Setpoints(reference=rest)


LAB = HookCrane(segfmu.Crane(2.2, 1.155, 1.0), 0.1, 0.3)
PORT = HookCrane(segfmu.Crane(8e4, 1.2e4, 1e4), 500.0, 4.0)
LIGHT = replace(PORT, crane=replace(PORT.crane, payload_mass=500.0))
TASKS = (
    Task("10 t, rope 6 m", PORT, 6.0, 0.0, 15.0, 1.2, 0.3, 0.005, 0.05),
    Task("10 t, rope 6 to 3 m", PORT, 6.0, 3.0, 15.0, 1.2, 0.3, 0.005, 0.05),
    Task("0.5 t, rope 6 to 3 m", LIGHT, 6.0, 3.0, 15.0, 1.2, 0.3, 0.005, 0.05),
    Task("1 kg, rope 0.6 to 0.3 m", LAB, 0.6, 0.3, 1.2, 0.4, 0.5, 0.001, 0.01),
)


def simulated(
    task: Task, motion: Motion, true: HookCrane, swings: float, enabled: bool = False
) -> np.ndarray:
    """States (n, 14) of a run until so many slow swings behind the end."""
    feedback = design_hook(
        task.crane, sample_time=task.period, shortest=0.5 * (task.rope - task.lifted),
        longest=1.2 * task.rope, driven=True,
    )
    start = np.zeros(14)
    start[2] = task.rope
    plant = Plant(
        true, start, motion.setpoints(0), HookController(feedback), driven=True, enabled=enabled
    )
    states = [plant.state]
    for i in range(1, len(motion.velocity) + int(swings * 2.0 * np.pi * task.swing / task.step)):
        plant.step(task.step, motion.setpoints(i))
        states.append(plant.state)
    return np.array(states)


def baseline(task: Task, shaper: Shaper) -> Motion:
    """A trapezoid of trolley and hoist, the former shaped; the reference swings as they make it."""
    trapezoid = Trapezoid(task.distance, task.velocity, task.acceleration)
    trolley = Shaped(trapezoid, shaper)
    count = int(np.ceil(trolley.duration / task.step)) + 1
    times = task.step * np.arange(count)
    velocity = np.zeros((count, 3))
    velocity[:, 1] = trolley(times, 1)
    if task.lifted:
        mean = task.lifted / (0.8 * trapezoid.duration)
        hoist = Trapezoid(-task.lifted, 1.5 * mean, 4.0 * mean / trapezoid.duration)
        velocity[:, 2] = hoist(times, 1)
    moving = Motion(velocity, np.zeros((count, 10)))
    states = simulated(task, moving, task.crane, 0.0)[:count]
    reference = np.delete(states, SLING, axis=1)
    reference[-1] = [0.0, task.distance, task.rope - task.lifted, *np.zeros(7)]
    return Motion(velocity, reference)


def inverse(task: Task, crane: HookCrane | segfmu.Crane) -> Motion:
    """A plan of the load, inverted for a crane, as fast as the trolley's limits allow."""
    below = task.rope + task.crane.sling
    points = [[0.0, 0.0, -below], [0.0, task.distance, task.lifted - below]]
    waypoints = [segfmu.Waypoint(p) for p in points]
    share, most = 1.0, np.inf
    while most > task.acceleration:
        share *= 0.95
        # higher derivatives within a slow swing
        orders = [share * task.acceleration / task.swing**k for k in range(5)]
        vertical = [task.lifted / task.distance or 1.0] * 5
        limits = segfmu.Limits(
            [task.velocity] * 2 + [task.velocity * vertical[0]],
            *([c, c, c * r] for c, r in zip(orders, vertical, strict=True)),
        )
        trajectory = segfmu.plan(waypoints, limits, smoothness=6)
        found = FlatInverse(crane, trajectory)
        times = task.step * np.arange(int(np.ceil(trajectory.duration / task.step)) + 1)
        coarse = np.linspace(0.0, trajectory.duration, 500)
        most = np.abs(found.acceleration(coarse)[:, 1]).max()
    velocity, reference = found.velocity(times), found.state(times)
    if reference.shape[1] > 10:
        return Motion(velocity, np.delete(reference, SLING, axis=1))
    # its rope ends at the load
    reference[:, 2] -= task.crane.sling
    return Motion(velocity, reference)


def methods(task: Task) -> dict[str, Motion]:
    """All of them by name."""
    found = np.zeros(2)
    masses = np.array(task.crane.masses)
    backend.hook_frequencies(task.rope - 0.5 * task.lifted, masses, found)
    slow, fast = found.tolist()
    plain = task.crane.crane
    whole = replace(plain, payload_mass=plain.payload_mass + task.crane.hook_mass)
    return {
        "trapezoid": baseline(task, PLAIN),
        "ZV, slow swing": baseline(task, zv(slow)),
        "ZVD, slow swing": baseline(task, zvd(slow)),
        "ZV, both swings": baseline(task, zv(slow).then(zv(fast))),
        "ZVD, both swings": baseline(task, zvd(slow).then(zvd(fast))),
        "feedforward, no hook": inverse(task, whole),
        "feedforward, hook": inverse(task, task.crane),
    }


def left(task: Task, motion: Motion, true: HookCrane, enabled: bool) -> np.ndarray:
    """Greatest distance of load and hook from the goal, in the second swing behind the end [m]."""
    states = simulated(task, motion, true, 2.0, enabled)
    states = states[len(motion.velocity) + int(2.0 * np.pi * task.swing / task.step) :]
    _, y, rope, phi_x, phi_y, psi_x, psi_y = states[:, :7].T
    hook = y - rope * np.cos(phi_x) * np.sin(phi_y)
    load = hook - true.sling * np.cos(psi_x) * np.sin(psi_y)
    return np.abs(np.array([load, hook]) - task.distance).max(axis=1)


for task in TASKS:
    plain = task.crane.crane
    lighter = replace(plain, payload_mass=0.7 * plain.payload_mass)
    other = HookCrane(lighter, task.crane.hook_mass, 1.1 * task.crane.sling)
    cases = [(true, enabled) for true in (task.crane, other) for enabled in (False, True)]
    print(f"\n{task.name}: load / hook left in the second swing behind the move [mm]")
    print(f"{'':20s} {'time':>8s} {'exact':>15s} {'+ feedback':>15s} {'0.7 m, 1.1 s':>15s} "
          f"{'+ feedback':>15s}")
    for name, motion in methods(task).items():
        row = [1e3 * left(task, motion, true, enabled) for true, enabled in cases]
        told = " ".join(f"{load:7.2f}/{hook:7.2f}" for load, hook in row)
        print(f"{name:20s} {task.step * (len(motion.velocity) - 1):6.2f} s {told}", flush=True)
