within Segfmu.Examples;
model AgainstPlainCrane "GantryCrane without feedback beside the plain crane under equal forces"
  extends Coupled(gantry(feedback_enabled = false));
  PlainCrane plain(
    bridge_mass = gantry.crane_bridge_mass,
    trolley_mass = gantry.crane_trolley_mass,
    payload_mass = gantry.crane_payload_mass,
    gravity = gantry.crane_gravity,
    mode = gantry.drive_mode,
    lag = {gantry.drive_bridge_lag, gantry.drive_trolley_lag, gantry.drive_hoist_lag},
    carriage_start = {gantry.bridge_position_start, gantry.trolley_position_start},
    rope_length_start = gantry.rope_length_start) annotation(Placement(transformation(extent = {{200, -800}, {400, -1000}})));
  Real difference(unit = "m") "distance of both loads";
equation
  plain.force = {feedforward.force_bridge, feedforward.force_trolley, feedforward.force_hoist};
  plain.velocity = {feedforward.velocity_bridge, feedforward.velocity_trolley, feedforward.velocity_hoist};
  plain.wind = {0, 0, 0};
  difference = sqrt((plain.load[1] - gantry.load_position_x)^2
    + (plain.load[2] - gantry.load_position_y)^2 + (plain.load[3] - gantry.load_position_z)^2);
  annotation(experiment(StopTime = 8, Interval = 0.001, Tolerance = 1e-10));
end AgainstPlainCrane;
