within Segfmu.Examples;
model VelocityDrives "Speed-regulated drives with a lag of 50 ms, ramps of the shape smoothstep"
  extends Coupled(
    feedforward(planner_shape = Types.Shape.smoothstep),
    gantry(
      drive_mode = Types.DriveMode.velocity,
      drive_bridge_lag = 0.05,
      drive_trolley_lag = 0.05,
      drive_hoist_lag = 0.05,
      feedback_design = Types.FeedbackDesign.flatness));
  annotation(experiment(StopTime = 8, Interval = 0.001, Tolerance = 1e-8));
end VelocityDrives;
