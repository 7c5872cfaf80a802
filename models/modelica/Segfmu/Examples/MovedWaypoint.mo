within Segfmu.Examples;
model MovedWaypoint "Waypoints that are passed, as fast as the drives allow: move one, and the plan follows"
  extends Coupled(feedforward(
    planner_finds_limits = true,
    limits_x_velocity = 0, limits_x_acceleration = 0, limits_x_jerk = 0, limits_x_snap = 0,
    limits_y_velocity = 0, limits_y_acceleration = 0, limits_y_jerk = 0, limits_y_snap = 0,
    limits_z_velocity = 0, limits_z_acceleration = 0, limits_z_jerk = 0, limits_z_snap = 0,
    drive_bridge_velocity_max = 0.6, drive_bridge_acceleration_max = 0.7,
    drive_trolley_velocity_max = 0.5, drive_trolley_acceleration_max = 0.6,
    drive_hoist_velocity_max = 0.3, drive_hoist_acceleration_max = 0.5,
    waypoint_position = [0, 0, -0.6; 0.2, 0.1, -0.4; 0.8, 0.6, -0.35; moved],
    waypoint_velocity = zeros(4, 3), waypoint_acceleration = zeros(4, 3),
    waypoint_velocity_free = passed, waypoint_acceleration_free = passed));
  parameter Real moved[1, 3](each unit = "m") = [1, 0.8, -0.6] "the last waypoint";
  constant Boolean passed[4, 3] = [fill(false, 1, 3); fill(true, 2, 3); fill(false, 1, 3)]
    "velocities and accelerations that are found";
  annotation(experiment(StopTime = 8, Interval = 0.001, Tolerance = 1e-8));
end MovedWaypoint;
