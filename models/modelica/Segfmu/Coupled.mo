within Segfmu;
partial model Coupled "GantryFeedforward and GantryCrane, connected by name"
  GantryFeedforward feedforward annotation(Placement(transformation(origin = {-300, 0}, extent = {{-200, -470}, {200, 470}})));
  GantryCrane gantry annotation(Placement(transformation(origin = {300, 0}, extent = {{-200, -800}, {200, 800}})));
equation
  connect(feedforward.force_bridge, gantry.force_bridge) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.force_trolley, gantry.force_trolley) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.force_hoist, gantry.force_hoist) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.velocity_bridge, gantry.velocity_bridge) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.velocity_trolley, gantry.velocity_trolley) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.velocity_hoist, gantry.velocity_hoist) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_bridge_position, gantry.reference_bridge_position) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_trolley_position, gantry.reference_trolley_position) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_rope_length, gantry.reference_rope_length) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_sway_x_angle, gantry.reference_sway_x_angle) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_sway_y_angle, gantry.reference_sway_y_angle) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_bridge_velocity, gantry.reference_bridge_velocity) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_trolley_velocity, gantry.reference_trolley_velocity) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_rope_velocity, gantry.reference_rope_velocity) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_sway_x_rate, gantry.reference_sway_x_rate) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_sway_y_rate, gantry.reference_sway_y_rate) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_load_position_x, gantry.reference_load_position_x) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_load_position_y, gantry.reference_load_position_y) annotation(Line(color = {0, 0, 127}));
  connect(feedforward.reference_load_position_z, gantry.reference_load_position_z) annotation(Line(color = {0, 0, 127}));
  annotation(Diagram(coordinateSystem(extent = {{-600, -860}, {600, 860}})));
end Coupled;
