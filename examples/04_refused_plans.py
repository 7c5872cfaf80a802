"""What an infeasible request says: axis, waypoints, value, limit, remedy."""

import segfmu

limits = segfmu.Limits(velocity=1.0, acceleration=1.0, jerk=1.0, snap=10.0)
requests = {
    "too fast at the waypoint": [segfmu.Waypoint([0.0], [1.2]), segfmu.Waypoint([1.0])],
    "cannot brake in time": [segfmu.Waypoint([0.0], [0.9], [1.0]), segfmu.Waypoint([1.0])],
}
for name, waypoints in requests.items():
    try:
        segfmu.plan(waypoints, limits)
    except segfmu.InfeasibleError as error:
        print(f"{name}: {error}")
