within Segfmu;
model PlainCrane "Gantry crane of Newton's equations for bridge, trolley and load, in Cartesian coordinates"
  type DriveMode = Types.DriveMode;
  parameter Real bridge_mass(unit = "kg") = 2.2 "mass of the bridge, which moves in x with the trolley";
  parameter Real trolley_mass(unit = "kg") = 1.155 "mass of the trolley, which moves in y on the bridge";
  parameter Real payload_mass(unit = "kg") = 1.0 "mass of the load";
  parameter Real gravity(unit = "m/s2") = 9.81 "gravity";
  parameter DriveMode mode = DriveMode.force "what the drives follow";
  parameter Real lag[3](each unit = "s", each min = 0) = fill(0.05, 3) "time constants of bridge, trolley and hoist in mode velocity";
  parameter Real carriage_start[2](each unit = "m") = {0, 0} "bridge and trolley at the start";
  parameter Real rope_length_start(unit = "m") = 0.5 "rope at the start, which hangs at rest";
  Interfaces.RealInput force[3](each unit = "N") "forces of bridge, trolley and hoist; the last is negative in tension" annotation(Placement(transformation(extent = {{-120, 50}, {-100, 70}})));
  Interfaces.RealInput velocity[3](each unit = "m/s") "velocity setpoints of bridge, trolley and rope" annotation(Placement(transformation(extent = {{-120, -10}, {-100, 10}})));
  Interfaces.RealInput wind[3](each unit = "N") "force on the load" annotation(Placement(transformation(extent = {{-120, -70}, {-100, -50}})));
  Interfaces.RealOutput load[3](each unit = "m", start = {carriage_start[1], carriage_start[2], -rope_length_start}, each fixed = true) "position of the load" annotation(Placement(transformation(extent = {{100, 50}, {120, 70}})));
  Interfaces.RealOutput carriage[2](each unit = "m", start = carriage_start, each fixed = true) "positions of bridge and trolley" annotation(Placement(transformation(extent = {{100, -10}, {120, 10}})));
  Interfaces.RealOutput rope_length(unit = "m") "length of the rope" annotation(Placement(transformation(extent = {{100, -70}, {120, -50}})));
  Interfaces.RealOutput sway_angle[2](each unit = "rad", each displayUnit = "deg") "angles of the cardan joint" annotation(Placement(transformation(extent = {{100, -100}, {120, -80}})));
  Real load_velocity[3](each unit = "m/s", each start = 0, each fixed = true);
  Real carriage_velocity[2](each unit = "m/s", each start = 0, each fixed = true);
  Real tension(unit = "N") "pull of the rope on the load";
  Real rope_velocity(unit = "m/s");
  Real rope_acceleration(unit = "m/s2");
protected
  Real rope[3](each unit = "m") "from the trolley to the load";
  Real rope_rate[3](each unit = "m/s");
  Real along[3] "unit vector of the rope";
  Real pull[2](each unit = "N") "forces of the drives on bridge and trolley";
  final parameter Real moved[2](each unit = "kg") = {bridge_mass + trolley_mass, trolley_mass} "what each drive moves";
equation
  rope = load - {carriage[1], carriage[2], 0};
  rope_rate = load_velocity - {carriage_velocity[1], carriage_velocity[2], 0};
  rope_length = sqrt(rope*rope);
  along = rope/rope_length;
  rope_velocity = along*rope_rate;
  // second derivative of the distance between trolley and load
  rope_acceleration = along*(der(load_velocity) - {der(carriage_velocity[1]), der(carriage_velocity[2]), 0})
    + (rope_rate*rope_rate - rope_velocity^2)/rope_length;
  // Newton's equations
  der(load) = load_velocity;
  der(carriage) = carriage_velocity;
  payload_mass*der(load_velocity) = {0, 0, -payload_mass*gravity} - tension*along + wind;
  moved[1]*der(carriage_velocity[1]) = pull[1] + tension*along[1];
  moved[2]*der(carriage_velocity[2]) = pull[2] + tension*along[2];
  // drives
  if mode == DriveMode.force then
    pull = force[1:2];
    tension = -force[3];
  else
    lag[1:2].*der(carriage_velocity) = velocity[1:2] - carriage_velocity;
    lag[3]*rope_acceleration = velocity[3] - rope_velocity;
  end if;
  sway_angle = {asin(along[1]), atan2(-along[2], -along[3])};
  annotation(
    Documentation(info = "<html>
<p>The load hangs on a straight rope without mass. The carriages move in the plane z = 0. In mode force the
drives are ideal; in mode velocity each follows its setpoint with a lag. There is neither friction nor
feedback.</p>
</html>"),
    Icon(graphics = {
      Rectangle(extent = {{-100, 100}, {100, -100}}, lineColor = {60, 60, 60}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid),
      Line(points = {{-80, 40}, {80, 40}}, color = {60, 60, 60}, thickness = 3),
      Rectangle(extent = {{-40, 55}, {0, 30}}, lineColor = {60, 60, 60}, fillColor = {180, 180, 180}, fillPattern = FillPattern.Solid),
      Line(points = {{-20, 30}, {20, -40}}, color = {60, 60, 60}),
      Ellipse(extent = {{5, -35}, {35, -65}}, lineColor = {200, 90, 0}, fillColor = {200, 90, 0}, fillPattern = FillPattern.Solid),
      Text(extent = {{-100, 140}, {100, 105}}, textString = "%name", textColor = {0, 0, 255})}));
end PlainCrane;
