"""Lift, travel, lower: setpoints of the three drives by the flat inverse."""

import numpy as np

import segfmu

limits = segfmu.Limits([0.8, 0.5, 0.5], 0.8, 4.0, 30.0)
waypoints = [
    segfmu.Waypoint([0.0, 0.0, -1.2]),
    segfmu.Waypoint([0.7, 0.3, -0.5], velocity=[0.5, 0.2, 0.0]),
    segfmu.Waypoint([1.4, 0.6, -1.2]),
]
crane = segfmu.Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0, rope_max=1.5)
trajectory = segfmu.plan(waypoints, limits)
feedforward = segfmu.FlatInverse(crane, trajectory)
times = np.linspace(0.0, trajectory.duration, 1000)
for drive, force, velocity in zip(
    ("bridge", "trolley", "hoist"),
    np.abs(feedforward.force(times)).max(axis=0),
    np.abs(feedforward.velocity(times)).max(axis=0),
    strict=True,
):
    print(f"{drive:8s} at most {force:7.3f} N and {velocity:6.3f} m/s")
