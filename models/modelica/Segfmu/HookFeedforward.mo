within Segfmu;
model HookFeedforward "Plans the motion of a load that hangs by a sling on the hook of a crane through waypoints within limits, and inverts this double pendulum exactly: force and velocity setpoints and the reference of load, hook and crane"
  parameter String folder = "" "folder of the unpacked FMU; empty: that in Resources/FMUs" annotation(Dialog(tab = "FMU"));
  Interfaces.RealOutput force_bridge(unit = "N", nominal = 10.0) "feedforward force setpoint of the bridge drive" annotation(Placement(transformation(extent = {{200, 442}, {216, 458}})));
  Interfaces.RealOutput force_trolley(unit = "N", nominal = 10.0) "feedforward force setpoint of the trolley drive" annotation(Placement(transformation(extent = {{200, 422}, {216, 438}})));
  Interfaces.RealOutput force_hoist(unit = "N", nominal = 10.0) "feedforward force setpoint of the winch; negative is rope tension" annotation(Placement(transformation(extent = {{200, 402}, {216, 418}})));
  Interfaces.RealOutput velocity_bridge(unit = "m/s") "velocity setpoint of the bridge drive" annotation(Placement(transformation(extent = {{200, 362}, {216, 378}})));
  Interfaces.RealOutput velocity_trolley(unit = "m/s") "velocity setpoint of the trolley drive" annotation(Placement(transformation(extent = {{200, 342}, {216, 358}})));
  Interfaces.RealOutput velocity_hoist(unit = "m/s") "rope velocity setpoint; positive pays rope out" annotation(Placement(transformation(extent = {{200, 322}, {216, 338}})));
  Interfaces.RealOutput reference_load_position_x(unit = "m") "planned position of the load, x" annotation(Placement(transformation(extent = {{200, 282}, {216, 298}})));
  Interfaces.RealOutput reference_load_position_y(unit = "m") "planned position of the load, y" annotation(Placement(transformation(extent = {{200, 262}, {216, 278}})));
  Interfaces.RealOutput reference_load_position_z(unit = "m") "planned position of the load, z" annotation(Placement(transformation(extent = {{200, 242}, {216, 258}})));
  Interfaces.RealOutput reference_load_velocity_x(unit = "m/s") "planned velocity of the load, x" annotation(Placement(transformation(extent = {{200, 222}, {216, 238}})));
  Interfaces.RealOutput reference_load_velocity_y(unit = "m/s") "planned velocity of the load, y" annotation(Placement(transformation(extent = {{200, 202}, {216, 218}})));
  Interfaces.RealOutput reference_load_velocity_z(unit = "m/s") "planned velocity of the load, z" annotation(Placement(transformation(extent = {{200, 182}, {216, 198}})));
  Interfaces.RealOutput reference_load_acceleration_x(unit = "m/s2") "planned acceleration of the load, x" annotation(Placement(transformation(extent = {{200, 162}, {216, 178}})));
  Interfaces.RealOutput reference_load_acceleration_y(unit = "m/s2") "planned acceleration of the load, y" annotation(Placement(transformation(extent = {{200, 142}, {216, 158}})));
  Interfaces.RealOutput reference_load_acceleration_z(unit = "m/s2") "planned acceleration of the load, z" annotation(Placement(transformation(extent = {{200, 122}, {216, 138}})));
  Interfaces.RealOutput reference_load_jerk_x(unit = "m/s3") "planned jerk of the load, x" annotation(Placement(transformation(extent = {{200, 102}, {216, 118}})));
  Interfaces.RealOutput reference_load_jerk_y(unit = "m/s3") "planned jerk of the load, y" annotation(Placement(transformation(extent = {{200, 82}, {216, 98}})));
  Interfaces.RealOutput reference_load_jerk_z(unit = "m/s3") "planned jerk of the load, z" annotation(Placement(transformation(extent = {{200, 62}, {216, 78}})));
  Interfaces.RealOutput reference_load_snap_x(unit = "m/s4") "planned snap of the load, x" annotation(Placement(transformation(extent = {{200, 42}, {216, 58}})));
  Interfaces.RealOutput reference_load_snap_y(unit = "m/s4") "planned snap of the load, y" annotation(Placement(transformation(extent = {{200, 22}, {216, 38}})));
  Interfaces.RealOutput reference_load_snap_z(unit = "m/s4") "planned snap of the load, z" annotation(Placement(transformation(extent = {{200, 2}, {216, 18}})));
  Interfaces.RealOutput reference_bridge_position(unit = "m") "planned bridge position" annotation(Placement(transformation(extent = {{200, -18}, {216, -2}})));
  Interfaces.RealOutput reference_bridge_velocity(unit = "m/s") "planned bridge velocity" annotation(Placement(transformation(extent = {{200, -38}, {216, -22}})));
  Interfaces.RealOutput reference_bridge_acceleration(unit = "m/s2") "planned bridge acceleration" annotation(Placement(transformation(extent = {{200, -58}, {216, -42}})));
  Interfaces.RealOutput reference_trolley_position(unit = "m") "planned trolley position" annotation(Placement(transformation(extent = {{200, -78}, {216, -62}})));
  Interfaces.RealOutput reference_trolley_velocity(unit = "m/s") "planned trolley velocity" annotation(Placement(transformation(extent = {{200, -98}, {216, -82}})));
  Interfaces.RealOutput reference_trolley_acceleration(unit = "m/s2") "planned trolley acceleration" annotation(Placement(transformation(extent = {{200, -118}, {216, -102}})));
  Interfaces.RealOutput reference_rope_length(unit = "m") "planned rope length" annotation(Placement(transformation(extent = {{200, -138}, {216, -122}})));
  Interfaces.RealOutput reference_rope_velocity(unit = "m/s") "planned rope velocity" annotation(Placement(transformation(extent = {{200, -158}, {216, -142}})));
  Interfaces.RealOutput reference_rope_acceleration(unit = "m/s2") "planned rope acceleration" annotation(Placement(transformation(extent = {{200, -178}, {216, -162}})));
  Interfaces.RealOutput reference_sway_x_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "planned sway angle phi_x" annotation(Placement(transformation(extent = {{200, -198}, {216, -182}})));
  Interfaces.RealOutput reference_sway_x_rate(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "planned rate of phi_x" annotation(Placement(transformation(extent = {{200, -218}, {216, -202}})));
  Interfaces.RealOutput reference_sway_y_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "planned sway angle phi_y" annotation(Placement(transformation(extent = {{200, -238}, {216, -222}})));
  Interfaces.RealOutput reference_sway_y_rate(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "planned rate of phi_y" annotation(Placement(transformation(extent = {{200, -258}, {216, -242}})));
  Interfaces.RealOutput reference_sling_x_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "planned sling angle psi_x" annotation(Placement(transformation(extent = {{200, -278}, {216, -262}})));
  Interfaces.RealOutput reference_sling_x_rate(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "planned rate of psi_x" annotation(Placement(transformation(extent = {{200, -298}, {216, -282}})));
  Interfaces.RealOutput reference_sling_y_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "planned sling angle psi_y" annotation(Placement(transformation(extent = {{200, -318}, {216, -302}})));
  Interfaces.RealOutput reference_sling_y_rate(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "planned rate of psi_y" annotation(Placement(transformation(extent = {{200, -338}, {216, -322}})));
  Interfaces.IntegerOutput plan_interval "active waypoint interval, from 1" annotation(Placement(transformation(extent = {{200, -378}, {216, -362}})));
  Interfaces.BooleanOutput plan_done "the planned motion has ended" annotation(Placement(transformation(extent = {{200, -398}, {216, -382}})));
  Interfaces.RealOutput plan_next_event(unit = "s") "time of the next event: arrival at a waypoint, end of the motion, or jump of a derivative of the forces (the first at smoothness 6), and while friction changes its sign; behind the last, its time" annotation(Placement(transformation(extent = {{200, -418}, {216, -402}})));
  parameter Real crane_bridge_mass(unit = "kg", min = 1e-09) = 2.2 "nominal crane: mass of the bridge, which moves in x together with the trolley" annotation(Dialog(tab = "crane"));
  parameter Real crane_trolley_mass(unit = "kg", min = 1e-09) = 1.155 "nominal crane: mass of the trolley, which moves in y on the bridge" annotation(Dialog(tab = "crane"));
  parameter Real crane_payload_mass(unit = "kg", min = 1e-09) = 1.0 "nominal crane: mass of the load" annotation(Dialog(tab = "crane"));
  parameter Real crane_gravity(unit = "m/s2", min = 1e-09) = 9.81 "nominal crane: gravity" annotation(Dialog(tab = "crane"));
  parameter Real crane_rope_min(unit = "m", min = 0.0) = 0.16 "nominal crane: shortest rope; 0: no bound" annotation(Dialog(tab = "crane"));
  parameter Real crane_rope_max(unit = "m", min = 0.0) = 1.5 "nominal crane: longest rope; 0: no bound" annotation(Dialog(tab = "crane"));
  parameter Real hook_mass(unit = "kg", min = 1e-09) = 0.1 "nominal crane: mass of the hook" annotation(Dialog(tab = "hook"));
  parameter Real hook_sling(unit = "m", min = 1e-09) = 0.3 "nominal crane: length of the sling, from hook to load" annotation(Dialog(tab = "hook"));
  parameter Real limits_x_velocity(unit = "m/s", min = 0.0) = 1.0 "limit of the load's velocity in x; 0: none, if they are found" annotation(Dialog(tab = "limits"));
  parameter Real limits_x_acceleration(unit = "m/s2", min = 0.0) = 1.0 "limit of the load's acceleration in x; 0: none, if they are found" annotation(Dialog(tab = "limits"));
  parameter Real limits_x_jerk(unit = "m/s3", min = 0.0) = 1.0 "limit of the load's jerk in x; 0: no limit" annotation(Dialog(tab = "limits"));
  parameter Real limits_x_snap(unit = "m/s4", min = 0.0) = 10.0 "limit of the load's snap in x; 0: no limit" annotation(Dialog(tab = "limits"));
  parameter Real limits_x_velocity_min(unit = "m/s", max = 0.0) = 0.0 "limit of the load's velocity in the negative direction of x, below 0; 0: as in the positive one" annotation(Dialog(tab = "limits"));
  parameter Real limits_x_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "limit of the load's acceleration in the negative direction of x, below 0; 0: as in the positive one" annotation(Dialog(tab = "limits"));
  parameter Real limits_y_velocity(unit = "m/s", min = 0.0) = 0.4 "limit of the load's velocity in y; 0: none, if they are found" annotation(Dialog(tab = "limits"));
  parameter Real limits_y_acceleration(unit = "m/s2", min = 0.0) = 0.5 "limit of the load's acceleration in y; 0: none, if they are found" annotation(Dialog(tab = "limits"));
  parameter Real limits_y_jerk(unit = "m/s3", min = 0.0) = 0.5 "limit of the load's jerk in y; 0: no limit" annotation(Dialog(tab = "limits"));
  parameter Real limits_y_snap(unit = "m/s4", min = 0.0) = 5.0 "limit of the load's snap in y; 0: no limit" annotation(Dialog(tab = "limits"));
  parameter Real limits_y_velocity_min(unit = "m/s", max = 0.0) = 0.0 "limit of the load's velocity in the negative direction of y, below 0; 0: as in the positive one" annotation(Dialog(tab = "limits"));
  parameter Real limits_y_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "limit of the load's acceleration in the negative direction of y, below 0; 0: as in the positive one" annotation(Dialog(tab = "limits"));
  parameter Real limits_z_velocity(unit = "m/s", min = 0.0) = 0.3 "limit of the load's velocity in z; 0: none, if they are found" annotation(Dialog(tab = "limits"));
  parameter Real limits_z_acceleration(unit = "m/s2", min = 0.0) = 0.5 "limit of the load's acceleration in z; 0: none, if they are found" annotation(Dialog(tab = "limits"));
  parameter Real limits_z_jerk(unit = "m/s3", min = 0.0) = 0.5 "limit of the load's jerk in z; 0: no limit" annotation(Dialog(tab = "limits"));
  parameter Real limits_z_snap(unit = "m/s4", min = 0.0) = 5.0 "limit of the load's snap in z; 0: no limit" annotation(Dialog(tab = "limits"));
  parameter Real limits_z_velocity_min(unit = "m/s", max = 0.0) = 0.0 "limit of the load's velocity in the negative direction of z, below 0; 0: as in the positive one" annotation(Dialog(tab = "limits"));
  parameter Real limits_z_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "limit of the load's acceleration in the negative direction of z, below 0; 0: as in the positive one" annotation(Dialog(tab = "limits"));
  parameter Integer planner_smoothness(min = 5, max = 6) = 6 "n: the load's position is n times differentiable; with 6 forces are continuous, with 5 velocities" annotation(Dialog(tab = "planner"));
  parameter Types.Shape planner_shape = Types.Shape.smoothstep "shape of the acceleration ramps" annotation(Dialog(tab = "planner"));
  parameter Types.Synchronization planner_synchronization = Types.Synchronization.waypoints "where the axes meet" annotation(Dialog(tab = "planner"));
  parameter Real planner_sample_time(unit = "s", min = 0.0) = 0.0 "waypoint intervals and dwells become multiples of it; 0: any duration" annotation(Dialog(tab = "planner"));
  parameter Real planner_duration(unit = "s", min = 0.0) = 0.0 "duration to take; 0: the shortest one" annotation(Dialog(tab = "planner"));
  parameter Boolean planner_finds_limits = false "where the plan with the limits of the load exceeds bounds of the drives, limits up to these are found with which the motion is short and keeps the bounds; false: it is refused, or slows down" annotation(Dialog(tab = "planner"));
  parameter Boolean planner_slows_down = false "where the plan exceeds bounds of the drives, the whole motion becomes as slow as they need, waypoint velocities included; false: it is refused" annotation(Dialog(tab = "planner"));
  parameter Real planner_start_time(unit = "s", min = -1000000000.0) = -1000000000.0 "time at which the motion starts; -1e+09: the start of the simulation" annotation(Dialog(tab = "planner"));
  parameter Real setpoint_lead(unit = "s", min = 0.0) = 0.0 "all outputs are those of so much later, from the end of initialisation on: the communication step of importers that couple in parallel" annotation(Dialog(tab = "setpoint"));
  parameter Real drive_bridge_lag(unit = "s", min = 0.0) = 0.0 "time constant of the bridge drive, for which its velocity setpoint is compensated; 0: none" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_dead_time(unit = "s", min = 0.0) = 0.0 "time by which the bridge drive acts late, for which its setpoints are early; the load starts the longest of them late" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_lag(unit = "s", min = 0.0) = 0.0 "time constant of the trolley drive, for which its velocity setpoint is compensated; 0: none" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_dead_time(unit = "s", min = 0.0) = 0.0 "time by which the trolley drive acts late, for which its setpoints are early; the load starts the longest of them late" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_lag(unit = "s", min = 0.0) = 0.0 "time constant of the hoist drive, for which its velocity setpoint is compensated; 0: none" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_dead_time(unit = "s", min = 0.0) = 0.0 "time by which the hoist drive acts late, for which its setpoints are early; the load starts the longest of them late" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_force_max(unit = "N", min = 0.0) = 0.0 "largest force of the bridge drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_force_min(unit = "N", max = 0.0) = 0.0 "least force of the bridge drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_velocity_max(unit = "m/s", min = 0.0) = 0.0 "largest velocity of the bridge drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_velocity_min(unit = "m/s", max = 0.0) = 0.0 "least velocity of the bridge drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_acceleration_max(unit = "m/s2", min = 0.0) = 0.0 "largest acceleration of the bridge drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "least acceleration of the bridge drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_power_max(unit = "W", min = 0.0) = 0.0 "largest power of the bridge drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_force_max(unit = "N", min = 0.0) = 0.0 "largest force of the trolley drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_force_min(unit = "N", max = 0.0) = 0.0 "least force of the trolley drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_velocity_max(unit = "m/s", min = 0.0) = 0.0 "largest velocity of the trolley drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_velocity_min(unit = "m/s", max = 0.0) = 0.0 "least velocity of the trolley drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_acceleration_max(unit = "m/s2", min = 0.0) = 0.0 "largest acceleration of the trolley drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "least acceleration of the trolley drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_power_max(unit = "W", min = 0.0) = 0.0 "largest power of the trolley drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_force_max(unit = "N", min = 0.0) = 0.0 "largest force of the hoist drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_force_min(unit = "N", max = 0.0) = 0.0 "least force of the hoist drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_velocity_max(unit = "m/s", min = 0.0) = 0.0 "largest velocity of the hoist drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_velocity_min(unit = "m/s", max = 0.0) = 0.0 "least velocity of the hoist drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_acceleration_max(unit = "m/s2", min = 0.0) = 0.0 "largest acceleration of the hoist drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "least acceleration of the hoist drive, below 0; 0: minus the largest one" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_power_max(unit = "W", min = 0.0) = 0.0 "largest power of the hoist drive; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real sway_x_angle_max(unit = "rad", displayUnit = "deg", min = 0.0) = 0.0 "largest sway angle phi_x; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "sway"));
  parameter Real sway_y_angle_max(unit = "rad", displayUnit = "deg", min = 0.0) = 0.0 "largest sway angle phi_y; the plan keeps it, or initialisation fails; 0: no bound" annotation(Dialog(tab = "sway"));
  parameter Real travel_bridge_min(unit = "m") = -1000000000.0 "least position of the bridge; the plan keeps it, or initialisation fails" annotation(Dialog(tab = "travel"));
  parameter Real travel_bridge_max(unit = "m") = 1000000000.0 "greatest position of the bridge; the plan keeps it, or initialisation fails" annotation(Dialog(tab = "travel"));
  parameter Real travel_trolley_min(unit = "m") = -1000000000.0 "least position of the trolley; the plan keeps it, or initialisation fails" annotation(Dialog(tab = "travel"));
  parameter Real travel_trolley_max(unit = "m") = 1000000000.0 "greatest position of the trolley; the plan keeps it, or initialisation fails" annotation(Dialog(tab = "travel"));
  parameter Real travel_rope_min(unit = "m") = -1000000000.0 "least length of the rope; the plan keeps it, or initialisation fails" annotation(Dialog(tab = "travel"));
  parameter Real travel_rope_max(unit = "m") = 1000000000.0 "greatest length of the rope; the plan keeps it, or initialisation fails" annotation(Dialog(tab = "travel"));
  parameter Real workspace_x_min(unit = "m") = -1000000000.0 "least position of the load in x" annotation(Dialog(tab = "workspace"));
  parameter Real workspace_x_max(unit = "m") = 1000000000.0 "greatest one in x" annotation(Dialog(tab = "workspace"));
  parameter Real workspace_y_min(unit = "m") = -1000000000.0 "least position of the load in y" annotation(Dialog(tab = "workspace"));
  parameter Real workspace_y_max(unit = "m") = 1000000000.0 "greatest one in y" annotation(Dialog(tab = "workspace"));
  parameter Real workspace_z_min(unit = "m") = -1000000000.0 "least position of the load in z" annotation(Dialog(tab = "workspace"));
  parameter Real workspace_z_max(unit = "m") = 1000000000.0 "greatest one in z" annotation(Dialog(tab = "workspace"));
  parameter Real load_size_x(unit = "m", min = 0.0) = 0.0 "edge of the load's box, 0 for a point, x" annotation(Dialog(tab = "load"));
  parameter Real load_size_y(unit = "m", min = 0.0) = 0.0 "edge of the load's box, 0 for a point, y" annotation(Dialog(tab = "load"));
  parameter Real load_size_z(unit = "m", min = 0.0) = 0.0 "edge of the load's box, 0 for a point, z" annotation(Dialog(tab = "load"));
  parameter Real load_centre_x(unit = "m") = 0.0 "centre of the load's box from its position, the rope's end, x" annotation(Dialog(tab = "load"));
  parameter Real load_centre_y(unit = "m") = 0.0 "centre of the load's box from its position, the rope's end, y" annotation(Dialog(tab = "load"));
  parameter Real load_centre_z(unit = "m") = 0.0 "centre of the load's box from its position, the rope's end, z" annotation(Dialog(tab = "load"));
  parameter Real obstacle_minimum[:, 3](each unit = "m") = zeros(0, 3) "minimum corners of the obstacles" annotation(Dialog(tab = "obstacle"));
  final parameter Integer obstacle_count = size(obstacle_minimum, 1) "number of obstacles in use";
  parameter Real obstacle_maximum[obstacle_count, 3](each unit = "m") = fill(1.0, obstacle_count, 3) "maximum corners of the obstacles" annotation(Dialog(tab = "obstacle"));
  parameter Real obstacle_margin[obstacle_count](each unit = "m", each min = 0.0) = zeros(obstacle_count) "distances that load and rope keep from the obstacles along each axis" annotation(Dialog(tab = "obstacle"));
  parameter Boolean obstacle_rope[obstacle_count] = fill(true, obstacle_count) "whether the rope keeps off the obstacles as well" annotation(Dialog(tab = "obstacle"));
  parameter Real friction_bridge_viscous(unit = "N.s/m", min = 0.0) = 0.0 "viscous friction of the bridge" annotation(Dialog(tab = "friction"));
  parameter Real friction_bridge_coulomb(unit = "N", min = 0.0) = 0.0 "Coulomb friction of the bridge" annotation(Dialog(tab = "friction"));
  parameter Real friction_bridge_static(unit = "N", min = 0.0) = 0.0 "static friction of the bridge; 0: as Coulomb friction" annotation(Dialog(tab = "friction"));
  parameter Real friction_bridge_drag(unit = "N", min = 0.0) = 0.0 "friction of the bridge is drag * v |v|, v in m/s" annotation(Dialog(tab = "friction"));
  parameter Real friction_trolley_viscous(unit = "N.s/m", min = 0.0) = 0.0 "viscous friction of the trolley" annotation(Dialog(tab = "friction"));
  parameter Real friction_trolley_coulomb(unit = "N", min = 0.0) = 0.0 "Coulomb friction of the trolley" annotation(Dialog(tab = "friction"));
  parameter Real friction_trolley_static(unit = "N", min = 0.0) = 0.0 "static friction of the trolley; 0: as Coulomb friction" annotation(Dialog(tab = "friction"));
  parameter Real friction_trolley_drag(unit = "N", min = 0.0) = 0.0 "friction of the trolley is drag * v |v|, v in m/s" annotation(Dialog(tab = "friction"));
  parameter Real friction_hoist_viscous(unit = "N.s/m", min = 0.0) = 0.0 "viscous friction of the hoist" annotation(Dialog(tab = "friction"));
  parameter Real friction_hoist_coulomb(unit = "N", min = 0.0) = 0.0 "Coulomb friction of the hoist" annotation(Dialog(tab = "friction"));
  parameter Real friction_hoist_static(unit = "N", min = 0.0) = 0.0 "static friction of the hoist; 0: as Coulomb friction" annotation(Dialog(tab = "friction"));
  parameter Real friction_hoist_drag(unit = "N", min = 0.0) = 0.0 "friction of the hoist is drag * v |v|, v in m/s" annotation(Dialog(tab = "friction"));
  parameter Real friction_width(unit = "m/s", min = 1e-09) = 0.001 "velocity over which static friction falls to Coulomb friction" annotation(Dialog(tab = "friction"));
  parameter Real friction_presliding(unit = "m", min = 1e-09) = 1e-05 "displacement at which a contact begins to slide" annotation(Dialog(tab = "friction"));
  parameter Real waypoint_position[:, 3](each unit = "m", each min = -1000000.0, each max = 1000000.0) = [0.0, 0.0, -0.5;
      0.07, 0.055, -0.5;
      1.0, 0.8, -0.5] "position of the load at the waypoints" annotation(Dialog(tab = "waypoint"));
  final parameter Integer waypoint_count = size(waypoint_position, 1) "number of waypoints in use";
  parameter Real waypoint_velocity[waypoint_count, 3](each unit = "m/s") = [0.0, 0.0, 0.0;
      0.2, 0.17, 0.0;
      0.0, 0.0, 0.0] "velocity of the load at the waypoints" annotation(Dialog(tab = "waypoint"));
  parameter Real waypoint_acceleration[waypoint_count, 3](each unit = "m/s2") = [0.0, 0.0, 0.0;
      0.34, 0.27, 0.0;
      0.0, 0.0, 0.0] "acceleration of the load at the waypoints" annotation(Dialog(tab = "waypoint"));
  parameter Boolean waypoint_velocity_free[waypoint_count, 3] = fill(false, waypoint_count, 3) "velocity at the waypoints that is chosen for the shortest plan, not given" annotation(Dialog(tab = "waypoint"));
  parameter Boolean waypoint_acceleration_free[waypoint_count, 3] = fill(false, waypoint_count, 3) "acceleration at the waypoints that is chosen for the shortest plan, not given" annotation(Dialog(tab = "waypoint"));
  parameter Real waypoint_dwell[waypoint_count](each unit = "s", each min = 0.0) = zeros(waypoint_count) "rest at the waypoints" annotation(Dialog(tab = "waypoint"));
  final parameter Real plan_duration(unit = "s", fixed = false) "duration of the planned motion";
  final parameter Real plan_pace(fixed = false) "pace of the motion; 1 unless it was slowed down";
  final parameter Real plan_limits_x_velocity(unit = "m/s", fixed = false) "limit of the plan: velocity in x; 0: none";
  final parameter Real plan_limits_x_acceleration(unit = "m/s2", fixed = false) "limit of the plan: acceleration in x; 0: none";
  final parameter Real plan_limits_x_jerk(unit = "m/s3", fixed = false) "limit of the plan: jerk in x; 0: none";
  final parameter Real plan_limits_x_snap(unit = "m/s4", fixed = false) "limit of the plan: snap in x; 0: none";
  final parameter Real plan_limits_x_velocity_min(unit = "m/s", fixed = false) "limit of the plan: velocity_min in x; 0: none";
  final parameter Real plan_limits_x_acceleration_min(unit = "m/s2", fixed = false) "limit of the plan: acceleration_min in x; 0: none";
  final parameter Real plan_limits_y_velocity(unit = "m/s", fixed = false) "limit of the plan: velocity in y; 0: none";
  final parameter Real plan_limits_y_acceleration(unit = "m/s2", fixed = false) "limit of the plan: acceleration in y; 0: none";
  final parameter Real plan_limits_y_jerk(unit = "m/s3", fixed = false) "limit of the plan: jerk in y; 0: none";
  final parameter Real plan_limits_y_snap(unit = "m/s4", fixed = false) "limit of the plan: snap in y; 0: none";
  final parameter Real plan_limits_y_velocity_min(unit = "m/s", fixed = false) "limit of the plan: velocity_min in y; 0: none";
  final parameter Real plan_limits_y_acceleration_min(unit = "m/s2", fixed = false) "limit of the plan: acceleration_min in y; 0: none";
  final parameter Real plan_limits_z_velocity(unit = "m/s", fixed = false) "limit of the plan: velocity in z; 0: none";
  final parameter Real plan_limits_z_acceleration(unit = "m/s2", fixed = false) "limit of the plan: acceleration in z; 0: none";
  final parameter Real plan_limits_z_jerk(unit = "m/s3", fixed = false) "limit of the plan: jerk in z; 0: none";
  final parameter Real plan_limits_z_snap(unit = "m/s4", fixed = false) "limit of the plan: snap in z; 0: none";
  final parameter Real plan_limits_z_velocity_min(unit = "m/s", fixed = false) "limit of the plan: velocity_min in z; 0: none";
  final parameter Real plan_limits_z_acceleration_min(unit = "m/s2", fixed = false) "limit of the plan: acceleration_min in z; 0: none";
  final parameter Real plan_use_bridge_force(fixed = false) "largest use of the bound of bridge force; 1: all; 0: no bound";
  final parameter Real plan_use_bridge_force_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_trolley_force(fixed = false) "largest use of the bound of trolley force; 1: all; 0: no bound";
  final parameter Real plan_use_trolley_force_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_hoist_force(fixed = false) "largest use of the bound of hoist force; 1: all; 0: no bound";
  final parameter Real plan_use_hoist_force_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_bridge_velocity(fixed = false) "largest use of the bound of bridge velocity; 1: all; 0: no bound";
  final parameter Real plan_use_bridge_velocity_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_trolley_velocity(fixed = false) "largest use of the bound of trolley velocity; 1: all; 0: no bound";
  final parameter Real plan_use_trolley_velocity_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_hoist_velocity(fixed = false) "largest use of the bound of hoist velocity; 1: all; 0: no bound";
  final parameter Real plan_use_hoist_velocity_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_bridge_acceleration(fixed = false) "largest use of the bound of bridge acceleration; 1: all; 0: no bound";
  final parameter Real plan_use_bridge_acceleration_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_trolley_acceleration(fixed = false) "largest use of the bound of trolley acceleration; 1: all; 0: no bound";
  final parameter Real plan_use_trolley_acceleration_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_hoist_acceleration(fixed = false) "largest use of the bound of hoist acceleration; 1: all; 0: no bound";
  final parameter Real plan_use_hoist_acceleration_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_bridge_power(fixed = false) "largest use of the bound of bridge power; 1: all; 0: no bound";
  final parameter Real plan_use_bridge_power_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_trolley_power(fixed = false) "largest use of the bound of trolley power; 1: all; 0: no bound";
  final parameter Real plan_use_trolley_power_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_hoist_power(fixed = false) "largest use of the bound of hoist power; 1: all; 0: no bound";
  final parameter Real plan_use_hoist_power_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_travel_bridge(fixed = false) "largest use of the bound of travel bridge; 1: all; 0: no bound";
  final parameter Real plan_use_travel_bridge_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_travel_trolley(fixed = false) "largest use of the bound of travel trolley; 1: all; 0: no bound";
  final parameter Real plan_use_travel_trolley_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_travel_rope(fixed = false) "largest use of the bound of travel rope; 1: all; 0: no bound";
  final parameter Real plan_use_travel_rope_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_sway_x(fixed = false) "largest use of the bound of sway x; 1: all; 0: no bound";
  final parameter Real plan_use_sway_x_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
  final parameter Real plan_use_sway_y(fixed = false) "largest use of the bound of sway y; 1: all; 0: no bound";
  final parameter Real plan_use_sway_y_time(unit = "s", fixed = false) "when it is reached, since the start of the plan";
protected
  constant Integer waypoint_position_references[16, 3] = [322, 323, 324;
      338, 339, 340;
      354, 355, 356;
      370, 371, 372;
      386, 387, 388;
      402, 403, 404;
      418, 419, 420;
      434, 435, 436;
      450, 451, 452;
      466, 467, 468;
      482, 483, 484;
      498, 499, 500;
      514, 515, 516;
      530, 531, 532;
      546, 547, 548;
      562, 563, 564];
  constant Integer waypoint_velocity_references[16, 3] = [325, 326, 327;
      341, 342, 343;
      357, 358, 359;
      373, 374, 375;
      389, 390, 391;
      405, 406, 407;
      421, 422, 423;
      437, 438, 439;
      453, 454, 455;
      469, 470, 471;
      485, 486, 487;
      501, 502, 503;
      517, 518, 519;
      533, 534, 535;
      549, 550, 551;
      565, 566, 567];
  constant Integer waypoint_acceleration_references[16, 3] = [328, 329, 330;
      344, 345, 346;
      360, 361, 362;
      376, 377, 378;
      392, 393, 394;
      408, 409, 410;
      424, 425, 426;
      440, 441, 442;
      456, 457, 458;
      472, 473, 474;
      488, 489, 490;
      504, 505, 506;
      520, 521, 522;
      536, 537, 538;
      552, 553, 554;
      568, 569, 570];
  constant Integer waypoint_velocity_free_references[16, 3] = [331, 332, 333;
      347, 348, 349;
      363, 364, 365;
      379, 380, 381;
      395, 396, 397;
      411, 412, 413;
      427, 428, 429;
      443, 444, 445;
      459, 460, 461;
      475, 476, 477;
      491, 492, 493;
      507, 508, 509;
      523, 524, 525;
      539, 540, 541;
      555, 556, 557;
      571, 572, 573];
  constant Integer waypoint_acceleration_free_references[16, 3] = [334, 335, 336;
      350, 351, 352;
      366, 367, 368;
      382, 383, 384;
      398, 399, 400;
      414, 415, 416;
      430, 431, 432;
      446, 447, 448;
      462, 463, 464;
      478, 479, 480;
      494, 495, 496;
      510, 511, 512;
      526, 527, 528;
      542, 543, 544;
      558, 559, 560;
      574, 575, 576];
  constant Integer waypoint_dwell_references[16] = {337, 353, 369, 385, 401, 417, 433, 449, 465, 481, 497, 513, 529, 545, 561, 577};
  constant Integer obstacle_minimum_references[16, 3] = [179, 180, 181;
      187, 188, 189;
      195, 196, 197;
      203, 204, 205;
      211, 212, 213;
      219, 220, 221;
      227, 228, 229;
      235, 236, 237;
      243, 244, 245;
      251, 252, 253;
      259, 260, 261;
      267, 268, 269;
      275, 276, 277;
      283, 284, 285;
      291, 292, 293;
      299, 300, 301];
  constant Integer obstacle_maximum_references[16, 3] = [182, 183, 184;
      190, 191, 192;
      198, 199, 200;
      206, 207, 208;
      214, 215, 216;
      222, 223, 224;
      230, 231, 232;
      238, 239, 240;
      246, 247, 248;
      254, 255, 256;
      262, 263, 264;
      270, 271, 272;
      278, 279, 280;
      286, 287, 288;
      294, 295, 296;
      302, 303, 304];
  constant Integer obstacle_margin_references[16] = {185, 193, 201, 209, 217, 225, 233, 241, 249, 257, 265, 273, 281, 289, 297, 305};
  constant Integer obstacle_rope_references[16] = {186, 194, 202, 210, 218, 226, 234, 242, 250, 258, 266, 274, 282, 290, 298, 306};
  final parameter Integer real_references[:] = cat(1, {44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66,
      67, 68, 69, 91, 92, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109,
      110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 126, 127,
      128, 129, 130, 131, 166, 167, 168, 169, 170, 171, 172, 173, 174, 175, 176, 177, 307, 308,
      309, 310, 311, 312, 313, 314, 315, 316, 317, 318, 319, 320},
      FMI.references(waypoint_position_references, waypoint_count),
      FMI.references(waypoint_velocity_references, waypoint_count),
      FMI.references(waypoint_acceleration_references, waypoint_count),
      waypoint_dwell_references[1:waypoint_count],
      FMI.references(obstacle_minimum_references, obstacle_count),
      FMI.references(obstacle_maximum_references, obstacle_count),
      obstacle_margin_references[1:obstacle_count]);
  final parameter Real reals[:] = cat(1, {crane_bridge_mass, crane_trolley_mass, crane_payload_mass, crane_gravity, crane_rope_min,
      crane_rope_max, hook_mass, hook_sling, limits_x_velocity, limits_x_acceleration,
      limits_x_jerk, limits_x_snap, limits_x_velocity_min, limits_x_acceleration_min,
      limits_y_velocity, limits_y_acceleration, limits_y_jerk, limits_y_snap,
      limits_y_velocity_min, limits_y_acceleration_min, limits_z_velocity, limits_z_acceleration,
      limits_z_jerk, limits_z_snap, limits_z_velocity_min, limits_z_acceleration_min,
      planner_sample_time, planner_duration, planner_start_time, setpoint_lead, drive_bridge_lag,
      drive_bridge_dead_time, drive_trolley_lag, drive_trolley_dead_time, drive_hoist_lag,
      drive_hoist_dead_time, drive_bridge_force_max, drive_bridge_force_min,
      drive_bridge_velocity_max, drive_bridge_velocity_min, drive_bridge_acceleration_max,
      drive_bridge_acceleration_min, drive_bridge_power_max, drive_trolley_force_max,
      drive_trolley_force_min, drive_trolley_velocity_max, drive_trolley_velocity_min,
      drive_trolley_acceleration_max, drive_trolley_acceleration_min, drive_trolley_power_max,
      drive_hoist_force_max, drive_hoist_force_min, drive_hoist_velocity_max,
      drive_hoist_velocity_min, drive_hoist_acceleration_max, drive_hoist_acceleration_min,
      drive_hoist_power_max, sway_x_angle_max, sway_y_angle_max, travel_bridge_min,
      travel_bridge_max, travel_trolley_min, travel_trolley_max, travel_rope_min, travel_rope_max,
      workspace_x_min, workspace_x_max, workspace_y_min, workspace_y_max, workspace_z_min,
      workspace_z_max, load_size_x, load_size_y, load_size_z, load_centre_x, load_centre_y,
      load_centre_z, friction_bridge_viscous, friction_bridge_coulomb, friction_bridge_static,
      friction_bridge_drag, friction_trolley_viscous, friction_trolley_coulomb,
      friction_trolley_static, friction_trolley_drag, friction_hoist_viscous,
      friction_hoist_coulomb, friction_hoist_static, friction_hoist_drag, friction_width,
      friction_presliding},
      FMI.rows(waypoint_position),
      FMI.rows(waypoint_velocity),
      FMI.rows(waypoint_acceleration),
      waypoint_dwell,
      FMI.rows(obstacle_minimum),
      FMI.rows(obstacle_maximum),
      obstacle_margin);
  constant Integer integer_references[5] = {88, 89, 90, 178, 321};
  final parameter Integer integers[5] = {planner_smoothness, Integer(planner_shape), Integer(planner_synchronization),
      obstacle_count, waypoint_count};
  final parameter Integer boolean_references[:] = cat(1, {93, 94},
      FMI.references(waypoint_velocity_free_references, waypoint_count),
      FMI.references(waypoint_acceleration_free_references, waypoint_count),
      obstacle_rope_references[1:obstacle_count]);
  final parameter Integer booleans[:] = cat(1, {if planner_finds_limits then 1 else 0, if planner_slows_down then 1 else 0},
      FMI.truths(waypoint_velocity_free),
      FMI.truths(waypoint_acceleration_free),
      FMI.truths(matrix(obstacle_rope)));
  constant Integer input_references[0] = fill(0, 0);
  Real inputs[0] = fill(0.0, 0);
  FMI.Instance fmu = FMI.Instance(folder, "HookFeedforward", getInstanceName(),
      "{0a973e53-6101-2ad8-d999-053d8de8fcf4}", 0);
  final parameter Real started(fixed = false) "the FMU has its parameters";
  final parameter Real begun(fixed = false) "the FMU is initialised";
  Real x[0] "states of the FMU";
  discrete Real next(start = 0, fixed = true) "time of the next event";
  Real last "changes with every event";
initial equation
  started = FMI.start(fmu, time, real_references, reals, integer_references, integers,
      boolean_references, booleans);
  begun = FMI.begin(fmu, input_references, inputs, started);
  {plan_duration, plan_pace, plan_limits_x_velocity, plan_limits_x_acceleration,
      plan_limits_x_jerk, plan_limits_x_snap, plan_limits_x_velocity_min,
      plan_limits_x_acceleration_min, plan_limits_y_velocity, plan_limits_y_acceleration,
      plan_limits_y_jerk, plan_limits_y_snap, plan_limits_y_velocity_min,
      plan_limits_y_acceleration_min, plan_limits_z_velocity, plan_limits_z_acceleration,
      plan_limits_z_jerk, plan_limits_z_snap, plan_limits_z_velocity_min,
      plan_limits_z_acceleration_min, plan_use_bridge_force, plan_use_bridge_force_time,
      plan_use_trolley_force, plan_use_trolley_force_time, plan_use_hoist_force,
      plan_use_hoist_force_time, plan_use_bridge_velocity, plan_use_bridge_velocity_time,
      plan_use_trolley_velocity, plan_use_trolley_velocity_time, plan_use_hoist_velocity,
      plan_use_hoist_velocity_time, plan_use_bridge_acceleration,
      plan_use_bridge_acceleration_time, plan_use_trolley_acceleration,
      plan_use_trolley_acceleration_time, plan_use_hoist_acceleration,
      plan_use_hoist_acceleration_time, plan_use_bridge_power, plan_use_bridge_power_time,
      plan_use_trolley_power, plan_use_trolley_power_time, plan_use_hoist_power,
      plan_use_hoist_power_time, plan_use_travel_bridge, plan_use_travel_bridge_time,
      plan_use_travel_trolley, plan_use_travel_trolley_time, plan_use_travel_rope,
      plan_use_travel_rope_time, plan_use_sway_x, plan_use_sway_x_time, plan_use_sway_y,
      plan_use_sway_y_time} = FMI.reals(fmu, time, x, fill(0, 0), fill(0.0, 0), {42, 43, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 132, 133,
      134, 135, 136, 137, 138, 139, 140, 141, 142, 143, 144, 145, 146, 147, 148, 149, 150, 151,
      152, 153, 154, 155, 156, 157, 158, 159, 160, 161, 162, 163, 164, 165}, started);
equation
  when {initial(), time >= pre(next)} then
    next = FMI.event(fmu, time, x, input_references, inputs, begun);
  end when;
  // what an event changed is seen behind it
  last = started + pre(next);
  {force_bridge, force_trolley, force_hoist, velocity_bridge, velocity_trolley, velocity_hoist,
      reference_load_position_x, reference_load_position_y, reference_load_position_z,
      reference_load_velocity_x, reference_load_velocity_y, reference_load_velocity_z,
      reference_load_acceleration_x, reference_load_acceleration_y, reference_load_acceleration_z,
      reference_load_jerk_x, reference_load_jerk_y, reference_load_jerk_z, reference_load_snap_x,
      reference_load_snap_y, reference_load_snap_z, reference_bridge_position,
      reference_bridge_velocity, reference_bridge_acceleration, reference_trolley_position,
      reference_trolley_velocity, reference_trolley_acceleration, reference_rope_length,
      reference_rope_velocity, reference_rope_acceleration, reference_sway_x_angle,
      reference_sway_x_rate, reference_sway_y_angle, reference_sway_y_rate,
      reference_sling_x_angle, reference_sling_x_rate, reference_sling_y_angle,
      reference_sling_y_rate, plan_next_event}
      = FMI.reals(fmu, time, x, fill(0, 0),
      fill(0.0, 0),
      {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25,
      26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 41}, last);
  plan_interval = FMI.integer(fmu, 39, last);
  plan_done = FMI.boolean(fmu, 40, last);
  annotation(
    Diagram(coordinateSystem(extent = {{-200, -470}, {200, 470}})),
    Icon(coordinateSystem(extent = {{-200, -470}, {200, 470}}), graphics = {
      Rectangle(extent = {{-200, -470}, {200, 470}}, lineColor = {60, 60, 60}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid),
      Text(extent = {{-200, 480}, {200, 540}}, textString = "%name", textColor = {0, 0, 255}),
      Line(points = {{-60, 60}, {60, 60}}, color = {60, 60, 60}, thickness = 3),
      Line(points = {{-20, 60}, {-2, 10}, {6, -55}}, color = {60, 60, 60}),
      Ellipse(extent = {{-10, 2}, {6, 18}}, lineColor = {60, 60, 60}, fillColor = {60, 60, 60}, fillPattern = FillPattern.Solid),
      Ellipse(extent = {{-12, -97}, {32, -53}}, lineColor = {200, 90, 0}, fillColor = {200, 90, 0}, fillPattern = FillPattern.Solid),
      Text(extent = {{90, 442}, {190, 458}}, textString = "force", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 362}, {190, 378}}, textString = "velocity", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 282}, {190, 298}}, textString = "reference", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -378}, {190, -362}}, textString = "plan", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60})}));
end HookFeedforward;
