"""From waypoints to phases: ramps, profiles of one axis, common durations."""
