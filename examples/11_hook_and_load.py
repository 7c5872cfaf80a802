"""Half a tonne on hook and sling is carried across a hall while the hoist lifts it by 3 m.

The drives take the velocities of the flat inverse. That of the gantry crane, for which hook and
load are one load at the end of rope and sling, leaves a swing; that of hook and load does not, and
the feedback, which does not see the sling, calms the other.
"""

from dataclasses import replace

import numpy as np

import segfmu
from segfmu.crane import FlatInverse, Plant, Setpoints
from segfmu.crane.hook import HookController, HookCrane, design_hook

STEP, PERIOD, ROPE = 0.01, 0.05, 6.0
crane = HookCrane(segfmu.Crane(8e4, 1.2e4, 500.0, rope_min=2.0, rope_max=12.0), 500.0, 4.0)
one = replace(crane.crane, payload_mass=1000.0, rope_min=6.0, rope_max=16.0)
waypoints = [segfmu.Waypoint([0.0, 0.0, -10.0]), segfmu.Waypoint([0.0, 15.0, -7.0])]
bounds = segfmu.ActuatorBounds(velocity=[1.2, 1.2, 0.2], acceleration=[0.25, 0.25, 0.2])
feedback = design_hook(crane, sample_time=PERIOD, shortest=2.0, longest=12.0, driven=True)
slow, fast = crane.frequencies(ROPE)
print(f"swings of {2.0 * np.pi / slow:.2f} s and {2.0 * np.pi / fast:.2f} s at a rope of {ROPE} m")


def left(planned: HookCrane | segfmu.Crane, enabled: bool) -> tuple[float, float]:
    """Duration of the plan [s], and distance of the load from its goal two swings later [mm]."""
    plan = segfmu.plan_actuated(
        planned, waypoints, None, bounds, smoothness=6, shape="smoothstep"
    ).trajectory
    end = plan.duration + 4.0 * np.pi / slow
    times = np.arange(0.0, end + 2.0 * np.pi / slow, STEP)
    inverse = FlatInverse(planned, plan)
    # the feedback gets a state without the sling
    states = inverse.state(times)
    if isinstance(planned, HookCrane):
        states = np.delete(states, [5, 6, 12, 13], axis=1)
    else:
        states[:, 2] -= crane.sling
    start = np.zeros(14)
    start[2] = ROPE
    setpoints = [
        Setpoints(velocity=v, reference=r)
        for v, r in zip(inverse.velocity(times), states, strict=True)
    ]
    plant = Plant(
        crane, start, setpoints[0], HookController(feedback), driven=True, enabled=enabled
    )
    most = 0.0
    for time, one_step in zip(times[1:].tolist(), setpoints[1:], strict=True):
        plant.step(STEP, one_step)
        if time >= end:
            most = max(most, float(np.hypot(*(plant.load[0, :2] - [0.0, 15.0]))))
    return plan.duration, 1e3 * most


for name, planned in (("one load", one), ("hook and load", crane)):
    for enabled in (False, True):
        duration, distance = left(planned, enabled)
        told = "with" if enabled else "without"
        print(f"{name:14s} {duration:6.2f} s, {told:7s} feedback {distance:8.3f} mm are left")
