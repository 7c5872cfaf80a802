within Segfmu;
model GantryFeedforward "Plans the motion of a crane's load through waypoints within limits on velocity, acceleration, jerk and snap, and inverts the crane exactly: force and velocity setpoints and the reference of load and state"
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
  Interfaces.IntegerOutput plan_interval "active waypoint interval, from 1" annotation(Placement(transformation(extent = {{200, -298}, {216, -282}})));
  Interfaces.BooleanOutput plan_done "the planned motion has ended" annotation(Placement(transformation(extent = {{200, -318}, {216, -302}})));
  Interfaces.RealOutput plan_next_event(unit = "s") "time of the next event: arrival at a waypoint, end of the motion, or jump of a derivative of the forces (the first at smoothness 4), and while friction changes its sign; behind the last, its time" annotation(Placement(transformation(extent = {{200, -338}, {216, -322}})));
  Interfaces.IntegerOutput plan_status "what became of the last command; 0: taken, 1: reduced, 2: limits, 3: rope, 4: workspace, 5: obstacle, 6: drives, 7: pending, 8: travel" annotation(Placement(transformation(extent = {{200, -358}, {216, -342}})));
  Interfaces.IntegerOutput plan_refused "what the last plan for a command that was not taken does not keep; 0: taken, 1: reduced, 2: limits, 3: rope, 4: workspace, 5: obstacle, 6: drives, 7: pending, 8: travel" annotation(Placement(transformation(extent = {{200, -378}, {216, -362}})));
  Interfaces.RealOutput plan_emergency_duration(unit = "s") "what an emergency stop would come to, with command.foresees: time until the carriages stand; -1: there is none" annotation(Placement(transformation(extent = {{200, -398}, {216, -382}})));
  Interfaces.RealOutput plan_emergency_sway(unit = "rad", displayUnit = "deg") "what an emergency stop would come to, with command.foresees: largest angle between rope and vertical from then on; -1: there is none" annotation(Placement(transformation(extent = {{200, -418}, {216, -402}})));
  parameter Real crane_bridge_mass(unit = "kg", min = 1e-09) = 2.2 "nominal crane: mass of the bridge, which moves in x together with the trolley" annotation(Dialog(tab = "crane"));
  parameter Real crane_trolley_mass(unit = "kg", min = 1e-09) = 1.155 "nominal crane: mass of the trolley, which moves in y on the bridge" annotation(Dialog(tab = "crane"));
  parameter Real crane_payload_mass(unit = "kg", min = 1e-09) = 1.0 "nominal crane: mass of the load" annotation(Dialog(tab = "crane"));
  parameter Real crane_gravity(unit = "m/s2", min = 1e-09) = 9.81 "nominal crane: gravity" annotation(Dialog(tab = "crane"));
  parameter Real crane_rope_min(unit = "m", min = 0.0) = 0.16 "nominal crane: shortest rope; 0: no bound" annotation(Dialog(tab = "crane"));
  parameter Real crane_rope_max(unit = "m", min = 0.0) = 1.5 "nominal crane: longest rope; 0: no bound" annotation(Dialog(tab = "crane"));
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
  parameter Integer planner_smoothness(min = 4, max = 6) = 4 "n: the load's position is n times differentiable" annotation(Dialog(tab = "planner"));
  parameter Types.Shape planner_shape = Types.Shape.plateau "shape of the acceleration ramps" annotation(Dialog(tab = "planner"));
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
  parameter Boolean command_enabled = false "commands can be followed; takes 2 MB, and drives without dead time" annotation(Dialog(tab = "command"));
  parameter Types.Mode command_mode = Types.Mode.mission "what the load does; mission: the plan that it has" annotation(Dialog(tab = "command"));
  parameter Real command_velocity_x(unit = "m/s") = 0.0 "velocity of the load; in the mode inching its sign is a push, x" annotation(Dialog(tab = "command"));
  parameter Real command_velocity_y(unit = "m/s") = 0.0 "velocity of the load; in the mode inching its sign is a push, y" annotation(Dialog(tab = "command"));
  parameter Real command_velocity_z(unit = "m/s") = 0.0 "velocity of the load; in the mode inching its sign is a push, z" annotation(Dialog(tab = "command"));
  parameter Real command_target_x(unit = "m", min = -1000000.0, max = 1000000.0) = 0.0 "target of the load, x" annotation(Dialog(tab = "command"));
  parameter Real command_target_y(unit = "m", min = -1000000.0, max = 1000000.0) = 0.0 "target of the load, y" annotation(Dialog(tab = "command"));
  parameter Real command_target_z(unit = "m", min = -1000000.0, max = 1000000.0) = 0.0 "target of the load, z" annotation(Dialog(tab = "command"));
  parameter Boolean command_go = true "in the mode target: go there; false: stop" annotation(Dialog(tab = "command"));
  parameter Real limits_scale(min = 0.0, max = 1.0) = 1.0 "share of the velocity limits that commands are followed with; 0: stop" annotation(Dialog(tab = "limits"));
  parameter Real command_hold(unit = "s", min = 0.001) = 0.1 "how long a commanded velocity is held beyond a step, if nothing renews it" annotation(Dialog(tab = "command"));
  parameter Integer command_tries(min = 1, max = 9) = 3 "plans that are tried in a step at most; the next one tries others" annotation(Dialog(tab = "command"));
  parameter Boolean command_foresees = false "each step tells what an emergency stop would come to" annotation(Dialog(tab = "command"));
  parameter Boolean command_tripped_bridge = false "the bridge drive has tripped: its brake stops it, the others stop as fast as they can; while it is true, no other command is followed" annotation(Dialog(tab = "command"));
  parameter Real drive_bridge_brake_deceleration(unit = "m/s2", min = 0.0) = 0.0 "deceleration of the brake of the bridge drive, when it trips; 0: the drive's greatest one" annotation(Dialog(tab = "drive"));
  parameter Boolean command_tripped_trolley = false "the trolley drive has tripped: its brake stops it, the others stop as fast as they can; while it is true, no other command is followed" annotation(Dialog(tab = "command"));
  parameter Real drive_trolley_brake_deceleration(unit = "m/s2", min = 0.0) = 0.0 "deceleration of the brake of the trolley drive, when it trips; 0: the drive's greatest one" annotation(Dialog(tab = "drive"));
  parameter Boolean command_tripped_hoist = false "the hoist drive has tripped: its brake stops it, the others stop as fast as they can; while it is true, no other command is followed" annotation(Dialog(tab = "command"));
  parameter Real drive_hoist_brake_deceleration(unit = "m/s2", min = 0.0) = 0.0 "deceleration of the brake of the hoist drive, when it trips; 0: the drive's greatest one" annotation(Dialog(tab = "drive"));
  parameter Real command_distance_x(unit = "m", min = 0.0, max = 1000000.0) = 0.01 "way of a push in the mode inching, x" annotation(Dialog(tab = "command"));
  parameter Real command_distance_y(unit = "m", min = 0.0, max = 1000000.0) = 0.01 "way of a push in the mode inching, y" annotation(Dialog(tab = "command"));
  parameter Real command_distance_z(unit = "m", min = 0.0, max = 1000000.0) = 0.01 "way of a push in the mode inching, z" annotation(Dialog(tab = "command"));
  parameter Boolean command_take_over = false "begin in the measured state and bring the load to rest, or to the target; each time that it becomes true, and at the start" annotation(Dialog(tab = "command"));
  parameter Real measured_bridge_position(unit = "m", min = -1e+20, max = 1e+20) = 0.0 "measured bridge.position, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_trolley_position(unit = "m", min = -1e+20, max = 1e+20) = 0.0 "measured trolley.position, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_rope_length(unit = "m", min = -1e+20, max = 1e+20) = 1.0 "measured rope.length, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_sway_x_angle(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20) = 0.0 "measured sway.x.angle, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_sway_y_angle(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20) = 0.0 "measured sway.y.angle, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_bridge_velocity(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "measured bridge.velocity, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_trolley_velocity(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "measured trolley.velocity, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_rope_velocity(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "measured rope.velocity, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_sway_x_rate(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20) = 0.0 "measured sway.x.rate, for command.take_over" annotation(Dialog(tab = "measured"));
  parameter Real measured_sway_y_rate(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20) = 0.0 "measured sway.y.rate, for command.take_over" annotation(Dialog(tab = "measured"));
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
  constant Integer waypoint_position_references[16, 3] = [353, 354, 355;
      369, 370, 371;
      385, 386, 387;
      401, 402, 403;
      417, 418, 419;
      433, 434, 435;
      449, 450, 451;
      465, 466, 467;
      481, 482, 483;
      497, 498, 499;
      513, 514, 515;
      529, 530, 531;
      545, 546, 547;
      561, 562, 563;
      577, 578, 579;
      593, 594, 595];
  constant Integer waypoint_velocity_references[16, 3] = [356, 357, 358;
      372, 373, 374;
      388, 389, 390;
      404, 405, 406;
      420, 421, 422;
      436, 437, 438;
      452, 453, 454;
      468, 469, 470;
      484, 485, 486;
      500, 501, 502;
      516, 517, 518;
      532, 533, 534;
      548, 549, 550;
      564, 565, 566;
      580, 581, 582;
      596, 597, 598];
  constant Integer waypoint_acceleration_references[16, 3] = [359, 360, 361;
      375, 376, 377;
      391, 392, 393;
      407, 408, 409;
      423, 424, 425;
      439, 440, 441;
      455, 456, 457;
      471, 472, 473;
      487, 488, 489;
      503, 504, 505;
      519, 520, 521;
      535, 536, 537;
      551, 552, 553;
      567, 568, 569;
      583, 584, 585;
      599, 600, 601];
  constant Integer waypoint_velocity_free_references[16, 3] = [362, 363, 364;
      378, 379, 380;
      394, 395, 396;
      410, 411, 412;
      426, 427, 428;
      442, 443, 444;
      458, 459, 460;
      474, 475, 476;
      490, 491, 492;
      506, 507, 508;
      522, 523, 524;
      538, 539, 540;
      554, 555, 556;
      570, 571, 572;
      586, 587, 588;
      602, 603, 604];
  constant Integer waypoint_acceleration_free_references[16, 3] = [365, 366, 367;
      381, 382, 383;
      397, 398, 399;
      413, 414, 415;
      429, 430, 431;
      445, 446, 447;
      461, 462, 463;
      477, 478, 479;
      493, 494, 495;
      509, 510, 511;
      525, 526, 527;
      541, 542, 543;
      557, 558, 559;
      573, 574, 575;
      589, 590, 591;
      605, 606, 607];
  constant Integer waypoint_dwell_references[16] = {368, 384, 400, 416, 432, 448, 464, 480, 496, 512, 528, 544, 560, 576, 592, 608};
  constant Integer obstacle_minimum_references[16, 3] = [177, 178, 179;
      185, 186, 187;
      193, 194, 195;
      201, 202, 203;
      209, 210, 211;
      217, 218, 219;
      225, 226, 227;
      233, 234, 235;
      241, 242, 243;
      249, 250, 251;
      257, 258, 259;
      265, 266, 267;
      273, 274, 275;
      281, 282, 283;
      289, 290, 291;
      297, 298, 299];
  constant Integer obstacle_maximum_references[16, 3] = [180, 181, 182;
      188, 189, 190;
      196, 197, 198;
      204, 205, 206;
      212, 213, 214;
      220, 221, 222;
      228, 229, 230;
      236, 237, 238;
      244, 245, 246;
      252, 253, 254;
      260, 261, 262;
      268, 269, 270;
      276, 277, 278;
      284, 285, 286;
      292, 293, 294;
      300, 301, 302];
  constant Integer obstacle_margin_references[16] = {183, 191, 199, 207, 215, 223, 231, 239, 247, 255, 263, 271, 279, 287, 295, 303};
  constant Integer obstacle_rope_references[16] = {184, 192, 200, 208, 216, 224, 232, 240, 248, 256, 264, 272, 280, 288, 296, 304};
  final parameter Integer real_references[:] = cat(1, {44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66,
      67, 89, 90, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109,
      110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 126, 127,
      128, 129, 164, 165, 166, 167, 168, 169, 170, 171, 172, 173, 174, 175, 307, 308, 309, 310,
      311, 312, 314, 315, 319, 321, 323, 324, 325, 326, 328, 329, 330, 331, 332, 333, 334, 335,
      336, 337, 338, 339, 340, 341, 342, 343, 344, 345, 346, 347, 348, 349, 350, 351},
      FMI.references(waypoint_position_references, waypoint_count),
      FMI.references(waypoint_velocity_references, waypoint_count),
      FMI.references(waypoint_acceleration_references, waypoint_count),
      waypoint_dwell_references[1:waypoint_count],
      FMI.references(obstacle_minimum_references, obstacle_count),
      FMI.references(obstacle_maximum_references, obstacle_count),
      obstacle_margin_references[1:obstacle_count]);
  final parameter Real reals[:] = cat(1, {crane_bridge_mass, crane_trolley_mass, crane_payload_mass, crane_gravity, crane_rope_min,
      crane_rope_max, limits_x_velocity, limits_x_acceleration, limits_x_jerk, limits_x_snap,
      limits_x_velocity_min, limits_x_acceleration_min, limits_y_velocity, limits_y_acceleration,
      limits_y_jerk, limits_y_snap, limits_y_velocity_min, limits_y_acceleration_min,
      limits_z_velocity, limits_z_acceleration, limits_z_jerk, limits_z_snap,
      limits_z_velocity_min, limits_z_acceleration_min, planner_sample_time, planner_duration,
      planner_start_time, setpoint_lead, drive_bridge_lag, drive_bridge_dead_time,
      drive_trolley_lag, drive_trolley_dead_time, drive_hoist_lag, drive_hoist_dead_time,
      drive_bridge_force_max, drive_bridge_force_min, drive_bridge_velocity_max,
      drive_bridge_velocity_min, drive_bridge_acceleration_max, drive_bridge_acceleration_min,
      drive_bridge_power_max, drive_trolley_force_max, drive_trolley_force_min,
      drive_trolley_velocity_max, drive_trolley_velocity_min, drive_trolley_acceleration_max,
      drive_trolley_acceleration_min, drive_trolley_power_max, drive_hoist_force_max,
      drive_hoist_force_min, drive_hoist_velocity_max, drive_hoist_velocity_min,
      drive_hoist_acceleration_max, drive_hoist_acceleration_min, drive_hoist_power_max,
      sway_x_angle_max, sway_y_angle_max, travel_bridge_min, travel_bridge_max,
      travel_trolley_min, travel_trolley_max, travel_rope_min, travel_rope_max, workspace_x_min,
      workspace_x_max, workspace_y_min, workspace_y_max, workspace_z_min, workspace_z_max,
      load_size_x, load_size_y, load_size_z, load_centre_x, load_centre_y, load_centre_z,
      command_velocity_x, command_velocity_y, command_velocity_z, command_target_x,
      command_target_y, command_target_z, limits_scale, command_hold,
      drive_bridge_brake_deceleration, drive_trolley_brake_deceleration,
      drive_hoist_brake_deceleration, command_distance_x, command_distance_y, command_distance_z,
      measured_bridge_position, measured_trolley_position, measured_rope_length,
      measured_sway_x_angle, measured_sway_y_angle, measured_bridge_velocity,
      measured_trolley_velocity, measured_rope_velocity, measured_sway_x_rate,
      measured_sway_y_rate, friction_bridge_viscous, friction_bridge_coulomb,
      friction_bridge_static, friction_bridge_drag, friction_trolley_viscous,
      friction_trolley_coulomb, friction_trolley_static, friction_trolley_drag,
      friction_hoist_viscous, friction_hoist_coulomb, friction_hoist_static, friction_hoist_drag,
      friction_width, friction_presliding},
      FMI.rows(waypoint_position),
      FMI.rows(waypoint_velocity),
      FMI.rows(waypoint_acceleration),
      waypoint_dwell,
      FMI.rows(obstacle_minimum),
      FMI.rows(obstacle_maximum),
      obstacle_margin);
  constant Integer integer_references[7] = {86, 87, 88, 176, 306, 316, 352};
  final parameter Integer integers[7] = {planner_smoothness, Integer(planner_shape), Integer(planner_synchronization),
      obstacle_count, Integer(command_mode), command_tries, waypoint_count};
  final parameter Integer boolean_references[:] = cat(1, {91, 92, 305, 313, 317, 318, 320, 322, 327},
      FMI.references(waypoint_velocity_free_references, waypoint_count),
      FMI.references(waypoint_acceleration_free_references, waypoint_count),
      obstacle_rope_references[1:obstacle_count]);
  final parameter Integer booleans[:] = cat(1, {if planner_finds_limits then 1 else 0, if planner_slows_down then 1 else 0, if
      command_enabled then 1 else 0, if command_go then 1 else 0, if command_foresees then 1 else
      0, if command_tripped_bridge then 1 else 0, if command_tripped_trolley then 1 else 0, if
      command_tripped_hoist then 1 else 0, if command_take_over then 1 else 0},
      FMI.truths(waypoint_velocity_free),
      FMI.truths(waypoint_acceleration_free),
      FMI.truths(matrix(obstacle_rope)));
  constant Integer input_references[0] = fill(0, 0);
  Real inputs[0] = fill(0.0, 0);
  FMI.Instance fmu = FMI.Instance(folder, "GantryFeedforward", getInstanceName(),
      "{a9555e33-895f-d5c7-82ce-310228284930}", 0);
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
      plan_use_sway_y_time} = FMI.reals(fmu, time, x, fill(0, 0), fill(0.0, 0), {42, 43, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 130, 131,
      132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143, 144, 145, 146, 147, 148, 149,
      150, 151, 152, 153, 154, 155, 156, 157, 158, 159, 160, 161, 162, 163}, started);
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
      reference_sway_x_rate, reference_sway_y_angle, reference_sway_y_rate, plan_next_event,
      plan_emergency_duration, plan_emergency_sway}
      = FMI.reals(fmu, time, x, fill(0, 0),
      fill(0.0, 0),
      {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25,
      26, 27, 28, 29, 30, 31, 32, 33, 34, 37, 40, 41}, last);
  plan_interval = FMI.integer(fmu, 35, last);
  plan_done = FMI.boolean(fmu, 36, last);
  plan_status = FMI.integer(fmu, 38, last);
  plan_refused = FMI.integer(fmu, 39, last);
  annotation(
    Diagram(coordinateSystem(extent = {{-200, -470}, {200, 470}})),
    Icon(coordinateSystem(extent = {{-200, -470}, {200, 470}}), graphics = {
      Rectangle(extent = {{-200, -470}, {200, 470}}, lineColor = {60, 60, 60}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid),
      Text(extent = {{-200, 480}, {200, 540}}, textString = "%name", textColor = {0, 0, 255}),
      Line(points = {{-60, 60}, {60, 60}}, color = {60, 60, 60}, thickness = 3),
      Line(points = {{-20, 60}, {10, -10}}, color = {60, 60, 60}),
      Ellipse(extent = {{-2, -52}, {42, -8}}, lineColor = {200, 90, 0}, fillColor = {200, 90, 0}, fillPattern = FillPattern.Solid),
      Text(extent = {{90, 442}, {190, 458}}, textString = "force", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 362}, {190, 378}}, textString = "velocity", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 282}, {190, 298}}, textString = "reference", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -298}, {190, -282}}, textString = "plan", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60})}));
end GantryFeedforward;
