"""From waypoints to phases: transition polynomials, profiles, common durations."""
