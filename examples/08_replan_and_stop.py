"""A move that is replanned to another target, stopped, and taken over at a velocity."""

import segfmu

limits = segfmu.Limits(velocity=1.0, acceleration=1.0, jerk=4.0, snap=20.0)
move = segfmu.plan([segfmu.Waypoint([0.0, 0.0]), segfmu.Waypoint([2.0, 1.0])], limits)
time = 0.4
state = move.state(time)
print(f"at {time} s: velocity {state.velocity}, jerk {state.jerk}, snap {state.snap}")

plans = {
    "same target": segfmu.replan(move, time, segfmu.Waypoint([2.0, 1.0])),
    "new target": segfmu.replan(move, time, segfmu.Waypoint([1.5, -0.5])),
    "stop": segfmu.stop(move, time),
    "velocity (0.3, 0)": segfmu.reach_velocity(move, [0.3, 0.0], time),
}
for name, plan in plans.items():
    end = plan.waypoints[-1]
    print(f"{name:18s} {plan.duration:.3f} s to {end.position.round(3)}, "
          f"verified: {segfmu.verify(plan).passed}")
