"""The paper's mission (24): the load passes the second point moving and accelerating."""

import segfmu

limits = segfmu.Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5], [10.0, 5.0])
waypoints = [
    segfmu.Waypoint([0.0, 0.0]),
    segfmu.Waypoint([0.07, 0.055], velocity=[0.2, 0.17], acceleration=[0.34, 0.27]),
    segfmu.Waypoint([1.0, 0.8]),
]
for shape in ("smoothstep", "plateau"):
    trajectory = segfmu.plan(waypoints, limits, shape=shape)
    found = segfmu.verify(trajectory)
    times = ", ".join(f"{t:.4f}" for t in trajectory.waypoint_times)
    print(f"{shape:10s} waypoints at {times} s, verified: {found.passed}")
