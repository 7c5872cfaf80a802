"""One axis from rest to rest, limits up to snap: how long it takes and what it uses."""

import segfmu

limits = segfmu.Limits(velocity=1.0, acceleration=1.0, jerk=2.0, snap=10.0)
trajectory = segfmu.plan([segfmu.Waypoint([0.0]), segfmu.Waypoint([2.0])], limits)
print(f"duration {trajectory.duration:.4f} s")
for order, name in enumerate(("velocity", "acceleration", "jerk", "snap"), 1):
    low, high = trajectory.extrema(order)
    print(f"{name:12s} from {low[0]:+.6f} to {high[0]:+.6f}")
