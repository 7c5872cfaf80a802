within Segfmu;
model HookCrane "Dynamics of a gantry crane whose load hangs by a sling on a hook, a double pendulum in space, from Lagrange's equations; drives, friction, end stops, sensors, wind and payload changes as on a real crane, ideal by default"
  parameter String folder = "" "folder of the unpacked FMU; empty: that in Resources/FMUs" annotation(Dialog(tab = "FMU"));
  parameter Boolean use_force = true "the connectors force_* are there; else the FMU has their start values" annotation(Dialog(tab = "inputs"), choices(checkBox = true));
  parameter Boolean use_velocity = true "the connectors velocity_* are there; else the FMU has their start values" annotation(Dialog(tab = "inputs"), choices(checkBox = true));
  parameter Boolean use_reference = true "the connectors reference_* are there; else the FMU has their start values" annotation(Dialog(tab = "inputs"), choices(checkBox = true));
  parameter Boolean use_wind = false "the connectors wind_* are there; else the FMU has their start values" annotation(Dialog(tab = "inputs"), choices(checkBox = true));
  Interfaces.RealInput force_bridge(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0, start = 0.0) if use_force "force setpoint of the bridge drive" annotation(Placement(transformation(extent = {{-216, 302}, {-200, 318}})));
  parameter Real force_bridge_start(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0) = 0.0 "value where force_bridge is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput force_trolley(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0, start = 0.0) if use_force "force setpoint of the trolley drive" annotation(Placement(transformation(extent = {{-216, 282}, {-200, 298}})));
  parameter Real force_trolley_start(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0) = 0.0 "value where force_trolley is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput force_hoist(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0, start = -10.791000000000002) if use_force "force setpoint of the hoist drive" annotation(Placement(transformation(extent = {{-216, 262}, {-200, 278}})));
  parameter Real force_hoist_start(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0) = -10.791000000000002 "value where force_hoist is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput velocity_bridge(unit = "m/s", min = -1e+20, max = 1e+20, start = 0.0) if use_velocity "velocity setpoint of the bridge drive" annotation(Placement(transformation(extent = {{-216, 222}, {-200, 238}})));
  parameter Real velocity_bridge_start(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "value where velocity_bridge is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput velocity_trolley(unit = "m/s", min = -1e+20, max = 1e+20, start = 0.0) if use_velocity "velocity setpoint of the trolley drive" annotation(Placement(transformation(extent = {{-216, 202}, {-200, 218}})));
  parameter Real velocity_trolley_start(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "value where velocity_trolley is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput velocity_hoist(unit = "m/s", min = -1e+20, max = 1e+20, start = 0.0) if use_velocity "velocity setpoint of the hoist drive" annotation(Placement(transformation(extent = {{-216, 182}, {-200, 198}})));
  parameter Real velocity_hoist_start(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "value where velocity_hoist is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_bridge_position(unit = "m", min = -1e+20, max = 1e+20, start = 0.0) if use_reference "reference of bridge.position" annotation(Placement(transformation(extent = {{-216, 142}, {-200, 158}})));
  parameter Real reference_bridge_position_start(unit = "m", min = -1e+20, max = 1e+20) = 0.0 "value where reference_bridge_position is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_trolley_position(unit = "m", min = -1e+20, max = 1e+20, start = 0.0) if use_reference "reference of trolley.position" annotation(Placement(transformation(extent = {{-216, 122}, {-200, 138}})));
  parameter Real reference_trolley_position_start(unit = "m", min = -1e+20, max = 1e+20) = 0.0 "value where reference_trolley_position is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_rope_length(unit = "m", min = -1e+20, max = 1e+20, start = 0.5) if use_reference "reference of rope.length" annotation(Placement(transformation(extent = {{-216, 102}, {-200, 118}})));
  parameter Real reference_rope_length_start(unit = "m", min = -1e+20, max = 1e+20) = 0.5 "value where reference_rope_length is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_sway_x_angle(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20, nominal = 0.1, start = 0.0) if use_reference "reference of sway.x.angle" annotation(Placement(transformation(extent = {{-216, 82}, {-200, 98}})));
  parameter Real reference_sway_x_angle_start(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20, nominal = 0.1) = 0.0 "value where reference_sway_x_angle is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_sway_y_angle(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20, nominal = 0.1, start = 0.0) if use_reference "reference of sway.y.angle" annotation(Placement(transformation(extent = {{-216, 62}, {-200, 78}})));
  parameter Real reference_sway_y_angle_start(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20, nominal = 0.1) = 0.0 "value where reference_sway_y_angle is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_bridge_velocity(unit = "m/s", min = -1e+20, max = 1e+20, start = 0.0) if use_reference "reference of bridge.velocity" annotation(Placement(transformation(extent = {{-216, 42}, {-200, 58}})));
  parameter Real reference_bridge_velocity_start(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "value where reference_bridge_velocity is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_trolley_velocity(unit = "m/s", min = -1e+20, max = 1e+20, start = 0.0) if use_reference "reference of trolley.velocity" annotation(Placement(transformation(extent = {{-216, 22}, {-200, 38}})));
  parameter Real reference_trolley_velocity_start(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "value where reference_trolley_velocity is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_rope_velocity(unit = "m/s", min = -1e+20, max = 1e+20, start = 0.0) if use_reference "reference of rope.velocity" annotation(Placement(transformation(extent = {{-216, 2}, {-200, 18}})));
  parameter Real reference_rope_velocity_start(unit = "m/s", min = -1e+20, max = 1e+20) = 0.0 "value where reference_rope_velocity is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_sway_x_rate(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20, nominal = 0.1, start = 0.0) if use_reference "reference of sway.x.rate" annotation(Placement(transformation(extent = {{-216, -18}, {-200, -2}})));
  parameter Real reference_sway_x_rate_start(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20, nominal = 0.1) = 0.0 "value where reference_sway_x_rate is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_sway_y_rate(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20, nominal = 0.1, start = 0.0) if use_reference "reference of sway.y.rate" annotation(Placement(transformation(extent = {{-216, -38}, {-200, -22}})));
  parameter Real reference_sway_y_rate_start(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20, nominal = 0.1) = 0.0 "value where reference_sway_y_rate is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_load_position_x(unit = "m", min = -1e+20, max = 1e+20, start = 0.0) if use_reference "reference of the load's position, x" annotation(Placement(transformation(extent = {{-216, -58}, {-200, -42}})));
  parameter Real reference_load_position_x_start(unit = "m", min = -1e+20, max = 1e+20) = 0.0 "value where reference_load_position_x is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_load_position_y(unit = "m", min = -1e+20, max = 1e+20, start = 0.0) if use_reference "reference of the load's position, y" annotation(Placement(transformation(extent = {{-216, -78}, {-200, -62}})));
  parameter Real reference_load_position_y_start(unit = "m", min = -1e+20, max = 1e+20) = 0.0 "value where reference_load_position_y is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_load_position_z(unit = "m", min = -1e+20, max = 1e+20, start = -0.8) if use_reference "reference of the load's position, z" annotation(Placement(transformation(extent = {{-216, -98}, {-200, -82}})));
  parameter Real reference_load_position_z_start(unit = "m", min = -1e+20, max = 1e+20) = -0.8 "value where reference_load_position_z is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput wind_x(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0, start = 0.0) if use_wind "external force on the load, x" annotation(Placement(transformation(extent = {{-216, -138}, {-200, -122}})));
  parameter Real wind_x_start(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0) = 0.0 "value where wind_x is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput wind_y(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0, start = 0.0) if use_wind "external force on the load, y" annotation(Placement(transformation(extent = {{-216, -158}, {-200, -142}})));
  parameter Real wind_y_start(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0) = 0.0 "value where wind_y is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput wind_z(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0, start = 0.0) if use_wind "external force on the load, z" annotation(Placement(transformation(extent = {{-216, -178}, {-200, -162}})));
  parameter Real wind_z_start(unit = "N", min = -1e+20, max = 1e+20, nominal = 10.0) = 0.0 "value where wind_z is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_sling_x_angle(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20, nominal = 0.1, start = 0.0) if use_reference "reference of sling.x.angle, for the start" annotation(Placement(transformation(extent = {{-216, -218}, {-200, -202}})));
  parameter Real reference_sling_x_angle_start(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20, nominal = 0.1) = 0.0 "value where reference_sling_x_angle is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_sling_y_angle(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20, nominal = 0.1, start = 0.0) if use_reference "reference of sling.y.angle, for the start" annotation(Placement(transformation(extent = {{-216, -238}, {-200, -222}})));
  parameter Real reference_sling_y_angle_start(unit = "rad", displayUnit = "deg", min = -1e+20, max = 1e+20, nominal = 0.1) = 0.0 "value where reference_sling_y_angle is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_sling_x_rate(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20, nominal = 0.1, start = 0.0) if use_reference "reference of sling.x.rate, for the start" annotation(Placement(transformation(extent = {{-216, -258}, {-200, -242}})));
  parameter Real reference_sling_x_rate_start(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20, nominal = 0.1) = 0.0 "value where reference_sling_x_rate is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealInput reference_sling_y_rate(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20, nominal = 0.1, start = 0.0) if use_reference "reference of sling.y.rate, for the start" annotation(Placement(transformation(extent = {{-216, -278}, {-200, -262}})));
  parameter Real reference_sling_y_rate_start(unit = "rad/s", displayUnit = "deg/s", min = -1e+20, max = 1e+20, nominal = 0.1) = 0.0 "value where reference_sling_y_rate is not there" annotation(Dialog(tab = "inputs"));
  Interfaces.RealOutput bridge_position(unit = "m") "true bridge.position" annotation(Placement(transformation(extent = {{200, 942}, {216, 958}})));
  Interfaces.RealOutput trolley_position(unit = "m") "true trolley.position" annotation(Placement(transformation(extent = {{200, 902}, {216, 918}})));
  Interfaces.RealOutput rope_length(unit = "m") "true rope.length" annotation(Placement(transformation(extent = {{200, 862}, {216, 878}})));
  Interfaces.RealOutput sway_x_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "true sway.x.angle" annotation(Placement(transformation(extent = {{200, 822}, {216, 838}})));
  Interfaces.RealOutput sway_y_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "true sway.y.angle" annotation(Placement(transformation(extent = {{200, 802}, {216, 818}})));
  Interfaces.RealOutput bridge_velocity(unit = "m/s") "true bridge.velocity" annotation(Placement(transformation(extent = {{200, 762}, {216, 778}})));
  Interfaces.RealOutput trolley_velocity(unit = "m/s") "true trolley.velocity" annotation(Placement(transformation(extent = {{200, 722}, {216, 738}})));
  Interfaces.RealOutput rope_velocity(unit = "m/s") "true rope.velocity" annotation(Placement(transformation(extent = {{200, 682}, {216, 698}})));
  Interfaces.RealOutput sway_x_rate(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "true sway.x.rate" annotation(Placement(transformation(extent = {{200, 642}, {216, 658}})));
  Interfaces.RealOutput sway_y_rate(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "true sway.y.rate" annotation(Placement(transformation(extent = {{200, 622}, {216, 638}})));
  Interfaces.RealOutput measured_bridge_position(unit = "m") "measured bridge.position" annotation(Placement(transformation(extent = {{200, 582}, {216, 598}})));
  Interfaces.RealOutput measured_trolley_position(unit = "m") "measured trolley.position" annotation(Placement(transformation(extent = {{200, 562}, {216, 578}})));
  Interfaces.RealOutput measured_rope_length(unit = "m") "measured rope.length" annotation(Placement(transformation(extent = {{200, 542}, {216, 558}})));
  Interfaces.RealOutput measured_sway_x_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "measured sway.x.angle" annotation(Placement(transformation(extent = {{200, 522}, {216, 538}})));
  Interfaces.RealOutput measured_sway_y_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "measured sway.y.angle" annotation(Placement(transformation(extent = {{200, 502}, {216, 518}})));
  Interfaces.RealOutput load_position_x(unit = "m") "true position of the load, x" annotation(Placement(transformation(extent = {{200, 462}, {216, 478}})));
  Interfaces.RealOutput load_position_y(unit = "m") "true position of the load, y" annotation(Placement(transformation(extent = {{200, 442}, {216, 458}})));
  Interfaces.RealOutput load_position_z(unit = "m") "true position of the load, z" annotation(Placement(transformation(extent = {{200, 422}, {216, 438}})));
  Interfaces.RealOutput load_velocity_x(unit = "m/s") "true velocity of the load, x" annotation(Placement(transformation(extent = {{200, 402}, {216, 418}})));
  Interfaces.RealOutput load_velocity_y(unit = "m/s") "true velocity of the load, y" annotation(Placement(transformation(extent = {{200, 382}, {216, 398}})));
  Interfaces.RealOutput load_velocity_z(unit = "m/s") "true velocity of the load, z" annotation(Placement(transformation(extent = {{200, 362}, {216, 378}})));
  Interfaces.RealOutput error_load_x(unit = "m") "load minus its reference, x" annotation(Placement(transformation(extent = {{200, 322}, {216, 338}})));
  Interfaces.RealOutput error_load_y(unit = "m") "load minus its reference, y" annotation(Placement(transformation(extent = {{200, 302}, {216, 318}})));
  Interfaces.RealOutput error_load_z(unit = "m") "load minus its reference, z" annotation(Placement(transformation(extent = {{200, 282}, {216, 298}})));
  Interfaces.RealOutput error_load_norm(unit = "m") "distance of the load from its reference" annotation(Placement(transformation(extent = {{200, 262}, {216, 278}})));
  Interfaces.RealOutput drive_bridge_force(unit = "N", nominal = 10.0) "force that the bridge drive applies" annotation(Placement(transformation(extent = {{200, 222}, {216, 238}})));
  Interfaces.BooleanOutput drive_bridge_saturated "bridge drive at a bound at some time in the last step" annotation(Placement(transformation(extent = {{200, 202}, {216, 218}})));
  Interfaces.RealOutput drive_bridge_power(unit = "W", nominal = 10.0) "power of the bridge drive" annotation(Placement(transformation(extent = {{200, 182}, {216, 198}})));
  Interfaces.RealOutput drive_trolley_force(unit = "N", nominal = 10.0) "force that the trolley drive applies" annotation(Placement(transformation(extent = {{200, 162}, {216, 178}})));
  Interfaces.BooleanOutput drive_trolley_saturated "trolley drive at a bound at some time in the last step" annotation(Placement(transformation(extent = {{200, 142}, {216, 158}})));
  Interfaces.RealOutput drive_trolley_power(unit = "W", nominal = 10.0) "power of the trolley drive" annotation(Placement(transformation(extent = {{200, 122}, {216, 138}})));
  Interfaces.RealOutput drive_hoist_force(unit = "N", nominal = 10.0) "force that the hoist drive applies" annotation(Placement(transformation(extent = {{200, 102}, {216, 118}})));
  Interfaces.BooleanOutput drive_hoist_saturated "hoist drive at a bound at some time in the last step" annotation(Placement(transformation(extent = {{200, 82}, {216, 98}})));
  Interfaces.RealOutput drive_hoist_power(unit = "W", nominal = 10.0) "power of the hoist drive" annotation(Placement(transformation(extent = {{200, 62}, {216, 78}})));
  Interfaces.RealOutput rope_force(unit = "N", nominal = 10.0) "force on the rope, tension is negative" annotation(Placement(transformation(extent = {{200, 22}, {216, 38}})));
  Interfaces.RealOutput payload_mass(unit = "kg") "present mass of the load" annotation(Placement(transformation(extent = {{200, -18}, {216, -2}})));
  Interfaces.RealOutput energy_kinetic(unit = "J", nominal = 10.0) "kinetic energy of bridge, trolley and load" annotation(Placement(transformation(extent = {{200, -58}, {216, -42}})));
  Interfaces.RealOutput energy_potential(unit = "J", nominal = 10.0) "potential energy of the load, zero at the trolley" annotation(Placement(transformation(extent = {{200, -78}, {216, -62}})));
  Interfaces.RealOutput energy_work(unit = "J", nominal = 10.0) "work of drives and wind since the start" annotation(Placement(transformation(extent = {{200, -98}, {216, -82}})));
  Interfaces.RealOutput energy_drives(unit = "J", nominal = 10.0) "work of the drives since the start" annotation(Placement(transformation(extent = {{200, -118}, {216, -102}})));
  Interfaces.RealOutput energy_wind(unit = "J", nominal = 10.0) "work of the wind since the start" annotation(Placement(transformation(extent = {{200, -138}, {216, -122}})));
  Interfaces.RealOutput energy_payload(unit = "J", nominal = 10.0) "energy that payload changes brought since the start" annotation(Placement(transformation(extent = {{200, -158}, {216, -142}})));
  Interfaces.RealOutput energy_dissipated(unit = "J", nominal = 10.0) "energy that friction took since the start" annotation(Placement(transformation(extent = {{200, -178}, {216, -162}})));
  Interfaces.RealOutput energy_imbalance(unit = "J", nominal = 10.0) "error of the balance of these by integration" annotation(Placement(transformation(extent = {{200, -198}, {216, -182}})));
  Interfaces.RealOutput power_wind(unit = "W", nominal = 10.0) "power of the wind" annotation(Placement(transformation(extent = {{200, -238}, {216, -222}})));
  Interfaces.RealOutput power_friction(unit = "W", nominal = 10.0) "power that friction dissipates" annotation(Placement(transformation(extent = {{200, -258}, {216, -242}})));
  Interfaces.RealOutput estimate_payload_mass(unit = "kg") "estimated mass of the load in drive.mode force; of source measured" annotation(Placement(transformation(extent = {{200, -298}, {216, -282}})));
  Interfaces.RealOutput estimate_disturbance_bridge(unit = "m/s2") "estimated unknown acceleration of the bridge; of source measured" annotation(Placement(transformation(extent = {{200, -318}, {216, -302}})));
  Interfaces.RealOutput estimate_disturbance_trolley(unit = "m/s2") "estimated unknown acceleration of the trolley; of source measured" annotation(Placement(transformation(extent = {{200, -338}, {216, -322}})));
  Interfaces.RealOutput estimate_disturbance_hoist(unit = "m/s2") "estimated unknown acceleration of the hoist; of source measured" annotation(Placement(transformation(extent = {{200, -358}, {216, -342}})));
  Interfaces.RealOutput estimate_disturbance_load_x(unit = "m/s2") "estimated acceleration of the load, x; of source measured" annotation(Placement(transformation(extent = {{200, -378}, {216, -362}})));
  Interfaces.RealOutput estimate_disturbance_load_y(unit = "m/s2") "estimated acceleration of the load, y; of source measured" annotation(Placement(transformation(extent = {{200, -398}, {216, -382}})));
  Interfaces.RealOutput estimate_rope_offset(unit = "m") "estimated correction of the rope's measured length; of source measured" annotation(Placement(transformation(extent = {{200, -418}, {216, -402}})));
  Interfaces.RealOutput friction_bridge_deflection(unit = "m", nominal = 1e-05) "deflection of the contact that rubs" annotation(Placement(transformation(extent = {{200, -458}, {216, -442}})));
  Interfaces.RealOutput friction_trolley_deflection(unit = "m", nominal = 1e-05) "deflection of the contact that rubs" annotation(Placement(transformation(extent = {{200, -478}, {216, -462}})));
  Interfaces.RealOutput friction_hoist_deflection(unit = "m", nominal = 1e-05) "deflection of the contact that rubs" annotation(Placement(transformation(extent = {{200, -498}, {216, -482}})));
  Interfaces.RealOutput load_speed(unit = "m/s") "speed of the load" annotation(Placement(transformation(extent = {{200, -538}, {216, -522}})));
  Interfaces.RealOutput sway_total(unit = "rad", displayUnit = "deg", nominal = 0.1) "angle between rope and vertical" annotation(Placement(transformation(extent = {{200, -578}, {216, -562}})));
  Interfaces.RealOutput sling_x_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "true sling.x.angle" annotation(Placement(transformation(extent = {{200, -618}, {216, -602}})));
  Interfaces.RealOutput sling_y_angle(unit = "rad", displayUnit = "deg", nominal = 0.1) "true sling.y.angle" annotation(Placement(transformation(extent = {{200, -638}, {216, -622}})));
  Interfaces.RealOutput sling_x_rate(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "true sling.x.rate" annotation(Placement(transformation(extent = {{200, -658}, {216, -642}})));
  Interfaces.RealOutput sling_y_rate(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "true sling.y.rate" annotation(Placement(transformation(extent = {{200, -678}, {216, -662}})));
  Interfaces.RealOutput hook_position_x(unit = "m") "true position of the hook, x" annotation(Placement(transformation(extent = {{200, -718}, {216, -702}})));
  Interfaces.RealOutput hook_position_y(unit = "m") "true position of the hook, y" annotation(Placement(transformation(extent = {{200, -738}, {216, -722}})));
  Interfaces.RealOutput hook_position_z(unit = "m") "true position of the hook, z" annotation(Placement(transformation(extent = {{200, -758}, {216, -742}})));
  Interfaces.RealOutput hook_velocity_x(unit = "m/s") "true velocity of the hook, x" annotation(Placement(transformation(extent = {{200, -778}, {216, -762}})));
  Interfaces.RealOutput hook_velocity_y(unit = "m/s") "true velocity of the hook, y" annotation(Placement(transformation(extent = {{200, -798}, {216, -782}})));
  Interfaces.RealOutput hook_velocity_z(unit = "m/s") "true velocity of the hook, z" annotation(Placement(transformation(extent = {{200, -818}, {216, -802}})));
  Interfaces.RealOutput sling_tension(unit = "N", nominal = 10.0) "tension of the sling" annotation(Placement(transformation(extent = {{200, -858}, {216, -842}})));
  Interfaces.RealOutput sway_frequency_slow(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "natural frequency of hook and load, to the same side, for the present rope and small swings below a carriage at rest" annotation(Placement(transformation(extent = {{200, -898}, {216, -882}})));
  Interfaces.RealOutput sway_frequency_fast(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) "natural frequency of hook and load, to opposite sides, for the present rope and small swings below a carriage at rest" annotation(Placement(transformation(extent = {{200, -918}, {216, -902}})));
  parameter Real bridge_position_start(unit = "m") = 0.0 "start value: true bridge.position" annotation(Dialog(tab = "start"));
  parameter Real trolley_position_start(unit = "m") = 0.0 "start value: true trolley.position" annotation(Dialog(tab = "start"));
  parameter Real rope_length_start(unit = "m") = 0.5 "start value: true rope.length" annotation(Dialog(tab = "start"));
  parameter Real sway_x_angle_start(unit = "rad", displayUnit = "deg", nominal = 0.1) = 0.0 "start value: true sway.x.angle" annotation(Dialog(tab = "start"));
  parameter Real sway_y_angle_start(unit = "rad", displayUnit = "deg", nominal = 0.1) = 0.0 "start value: true sway.y.angle" annotation(Dialog(tab = "start"));
  parameter Real bridge_velocity_start(unit = "m/s") = 0.0 "start value: true bridge.velocity" annotation(Dialog(tab = "start"));
  parameter Real trolley_velocity_start(unit = "m/s") = 0.0 "start value: true trolley.velocity" annotation(Dialog(tab = "start"));
  parameter Real rope_velocity_start(unit = "m/s") = 0.0 "start value: true rope.velocity" annotation(Dialog(tab = "start"));
  parameter Real sway_x_rate_start(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) = 0.0 "start value: true sway.x.rate" annotation(Dialog(tab = "start"));
  parameter Real sway_y_rate_start(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) = 0.0 "start value: true sway.y.rate" annotation(Dialog(tab = "start"));
  parameter Real crane_bridge_mass(unit = "kg", min = 1e-09) = 2.2 "true crane: mass of the bridge, which moves in x together with the trolley" annotation(Dialog(tab = "crane"));
  parameter Real crane_trolley_mass(unit = "kg", min = 1e-09) = 1.155 "true crane: mass of the trolley, which moves in y on the bridge" annotation(Dialog(tab = "crane"));
  parameter Real crane_payload_mass(unit = "kg", min = 1e-09) = 1.0 "true crane: mass of the load" annotation(Dialog(tab = "crane"));
  parameter Real crane_gravity(unit = "m/s2", min = 1e-09) = 9.81 "true crane: gravity" annotation(Dialog(tab = "crane"));
  parameter Real crane_rope_min(unit = "m", min = 0.0) = 0.16 "true crane: shortest rope; 0: no bound" annotation(Dialog(tab = "crane"));
  parameter Real crane_rope_max(unit = "m", min = 0.0) = 1.5 "true crane: longest rope; 0: no bound" annotation(Dialog(tab = "crane"));
  parameter Types.DriveMode drive_mode = Types.DriveMode.force "what the drives follow" annotation(Dialog(tab = "drive"));
  parameter Boolean start_on_reference = true "start where the reference is at initialisation; start values of the state are then deviations, counted from the start values of the reference" annotation(Dialog(tab = "start"));
  parameter Real setpoint_lead(unit = "s", min = 0.0) = 0.0 "that of GantryFeedforward; above 0, inputs set after a step are those of the end of the next one, and no reference for the errors yet" annotation(Dialog(tab = "setpoint"));
  parameter Real drive_bridge_lag(unit = "s", min = 0.0) = 0.0 "time constant of the bridge drive in mode velocity; 0: none" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_force_max(unit = "N", min = 0.0) = 0.0 "largest force of the bridge drive; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_force_min(unit = "N", max = 0.0) = 0.0 "least force of the bridge drive, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_acceleration_max(unit = "m/s2", min = 0.0) = 0.0 "largest acceleration of the bridge drive in mode velocity; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "least acceleration of the bridge drive in mode velocity, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_velocity_max(unit = "m/s", min = 0.0) = 0.0 "largest velocity of the bridge drive; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_velocity_min(unit = "m/s", max = 0.0) = 0.0 "least velocity of the bridge drive, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_power_max(unit = "W", min = 0.0) = 0.0 "largest power of the bridge drive, driving or braking; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_bridge_dead_time(unit = "s", min = 0.0) = 0.0 "from the command of the bridge, setpoint and correction, to the drive; in model exchange 0" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_lag(unit = "s", min = 0.0) = 0.0 "time constant of the trolley drive in mode velocity; 0: none" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_force_max(unit = "N", min = 0.0) = 0.0 "largest force of the trolley drive; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_force_min(unit = "N", max = 0.0) = 0.0 "least force of the trolley drive, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_acceleration_max(unit = "m/s2", min = 0.0) = 0.0 "largest acceleration of the trolley drive in mode velocity; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "least acceleration of the trolley drive in mode velocity, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_velocity_max(unit = "m/s", min = 0.0) = 0.0 "largest velocity of the trolley drive; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_velocity_min(unit = "m/s", max = 0.0) = 0.0 "least velocity of the trolley drive, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_power_max(unit = "W", min = 0.0) = 0.0 "largest power of the trolley drive, driving or braking; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_trolley_dead_time(unit = "s", min = 0.0) = 0.0 "from the command of the trolley, setpoint and correction, to the drive; in model exchange 0" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_lag(unit = "s", min = 0.0) = 0.0 "time constant of the hoist drive in mode velocity; 0: none" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_force_max(unit = "N", min = 0.0) = 0.0 "largest force of the hoist drive; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_force_min(unit = "N", max = 0.0) = 0.0 "least force of the hoist drive, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_acceleration_max(unit = "m/s2", min = 0.0) = 0.0 "largest acceleration of the hoist drive in mode velocity; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_acceleration_min(unit = "m/s2", max = 0.0) = 0.0 "least acceleration of the hoist drive in mode velocity, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_velocity_max(unit = "m/s", min = 0.0) = 0.0 "largest velocity of the hoist drive; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_velocity_min(unit = "m/s", max = 0.0) = 0.0 "least velocity of the hoist drive, below 0; 0: minus the largest" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_power_max(unit = "W", min = 0.0) = 0.0 "largest power of the hoist drive, driving or braking; 0: no bound" annotation(Dialog(tab = "drive"));
  parameter Real drive_hoist_dead_time(unit = "s", min = 0.0) = 0.0 "from the command of the hoist, setpoint and correction, to the drive; in model exchange 0" annotation(Dialog(tab = "drive"));
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
  parameter Real friction_sway_viscous(unit = "N.m.s", min = 0.0) = 0.0 "damping of both sway angles" annotation(Dialog(tab = "friction"));
  parameter Real travel_bridge_min(unit = "m") = -1000000000.0 "lower end stop of the bridge" annotation(Dialog(tab = "travel"));
  parameter Real travel_bridge_max(unit = "m") = 1000000000.0 "upper end stop of the bridge" annotation(Dialog(tab = "travel"));
  parameter Real travel_bridge_stiffness(unit = "N/m", min = 0.0) = 0.0 "stiffness of its buffers; 0: none, reaching it is an error" annotation(Dialog(tab = "travel"));
  parameter Real travel_bridge_damping(unit = "N.s/m", min = 0.0) = 0.0 "damping of its buffers, which have a stiffness" annotation(Dialog(tab = "travel"));
  parameter Real travel_trolley_min(unit = "m") = -1000000000.0 "lower end stop of the trolley" annotation(Dialog(tab = "travel"));
  parameter Real travel_trolley_max(unit = "m") = 1000000000.0 "upper end stop of the trolley" annotation(Dialog(tab = "travel"));
  parameter Real travel_trolley_stiffness(unit = "N/m", min = 0.0) = 0.0 "stiffness of its buffers; 0: none, reaching it is an error" annotation(Dialog(tab = "travel"));
  parameter Real travel_trolley_damping(unit = "N.s/m", min = 0.0) = 0.0 "damping of its buffers, which have a stiffness" annotation(Dialog(tab = "travel"));
  parameter Real travel_rope_min(unit = "m") = -1000000000.0 "lower end stop of the rope's length" annotation(Dialog(tab = "travel"));
  parameter Real travel_rope_max(unit = "m") = 1000000000.0 "upper end stop of the rope's length" annotation(Dialog(tab = "travel"));
  parameter Real travel_rope_stiffness(unit = "N/m", min = 0.0) = 0.0 "stiffness of its buffers; 0: none, reaching it is an error" annotation(Dialog(tab = "travel"));
  parameter Real travel_rope_damping(unit = "N.s/m", min = 0.0) = 0.0 "damping of its buffers, which have a stiffness" annotation(Dialog(tab = "travel"));
  parameter Types.SlackRope rope_slack = Types.SlackRope.error "where the rope would have to push: an error, or free fall of the load until the rope is taut again; in model exchange error" annotation(Dialog(tab = "rope"));
  parameter Real sensor_sample_time(unit = "s", min = 0.0) = 0.0 "period; 0: continuous" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_dead_time(unit = "s", min = 0.0) = 0.0 "from sampling to the signal; needs sensor.sample_time" annotation(Dialog(tab = "sensor"));
  parameter Integer sensor_seed(min = 0, max = 2147483647) = 0 "seed of the sensors' noise" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_bridge_position_resolution(unit = "m", min = 0.0) = 0.0 "quantisation step; 0: none" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_bridge_position_deviation(unit = "m", min = 0.0) = 0.0 "standard deviation of the noise; needs sensor.sample_time" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_bridge_position_offset(unit = "m") = 0.0 "measured minus true value" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_trolley_position_resolution(unit = "m", min = 0.0) = 0.0 "quantisation step; 0: none" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_trolley_position_deviation(unit = "m", min = 0.0) = 0.0 "standard deviation of the noise; needs sensor.sample_time" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_trolley_position_offset(unit = "m") = 0.0 "measured minus true value" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_rope_length_resolution(unit = "m", min = 0.0) = 0.0 "quantisation step; 0: none" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_rope_length_deviation(unit = "m", min = 0.0) = 0.0 "standard deviation of the noise; needs sensor.sample_time" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_rope_length_offset(unit = "m") = 0.0 "measured minus true value" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_sway_x_angle_resolution(unit = "rad", displayUnit = "deg", min = 0.0) = 0.0 "quantisation step; 0: none" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_sway_x_angle_deviation(unit = "rad", displayUnit = "deg", min = 0.0) = 0.0 "standard deviation of the noise; needs sensor.sample_time" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_sway_x_angle_offset(unit = "rad", displayUnit = "deg") = 0.0 "measured minus true value" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_sway_y_angle_resolution(unit = "rad", displayUnit = "deg", min = 0.0) = 0.0 "quantisation step; 0: none" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_sway_y_angle_deviation(unit = "rad", displayUnit = "deg", min = 0.0) = 0.0 "standard deviation of the noise; needs sensor.sample_time" annotation(Dialog(tab = "sensor"));
  parameter Real sensor_sway_y_angle_offset(unit = "rad", displayUnit = "deg") = 0.0 "measured minus true value" annotation(Dialog(tab = "sensor"));
  parameter Real wind_constant_x(unit = "N") = 0.0 "constant wind, x" annotation(Dialog(tab = "wind"));
  parameter Real wind_constant_y(unit = "N") = 0.0 "constant wind, y" annotation(Dialog(tab = "wind"));
  parameter Real wind_constant_z(unit = "N") = 0.0 "constant wind, z" annotation(Dialog(tab = "wind"));
  parameter Real wind_gust_start(unit = "s", min = -1000000000.0) = -1000000000.0 "start of the gust; -1e+09: the start of the simulation" annotation(Dialog(tab = "wind"));
  parameter Real wind_gust_duration(unit = "s", min = 0.0) = 0.0 "duration of the gust; 0: none" annotation(Dialog(tab = "wind"));
  parameter Types.GustShape wind_gust_shape = Types.GustShape.cosine "1 - cosine, or half a sine" annotation(Dialog(tab = "wind"));
  parameter Real wind_gust_force_x(unit = "N") = 0.0 "peak of the gust, x" annotation(Dialog(tab = "wind"));
  parameter Real wind_gust_force_y(unit = "N") = 0.0 "peak of the gust, y" annotation(Dialog(tab = "wind"));
  parameter Real wind_gust_force_z(unit = "N") = 0.0 "peak of the gust, z" annotation(Dialog(tab = "wind"));
  parameter Real wind_noise_deviation_x(unit = "N", min = 0.0) = 0.0 "standard deviation of the wind's noise, x" annotation(Dialog(tab = "wind"));
  parameter Real wind_noise_deviation_y(unit = "N", min = 0.0) = 0.0 "standard deviation of the wind's noise, y" annotation(Dialog(tab = "wind"));
  parameter Real wind_noise_deviation_z(unit = "N", min = 0.0) = 0.0 "standard deviation of the wind's noise, z" annotation(Dialog(tab = "wind"));
  parameter Real wind_noise_bandwidth(unit = "Hz", min = 1e-09, max = 1000000.0) = 1.0 "largest frequency in it" annotation(Dialog(tab = "wind"));
  parameter Integer wind_noise_seed(min = 0, max = 2147483647) = 0 "seed of the wind's noise" annotation(Dialog(tab = "wind"));
  parameter Real wind_speed_x(unit = "m/s") = 0.0 "mean speed of the air, x" annotation(Dialog(tab = "wind"));
  parameter Real wind_speed_y(unit = "m/s") = 0.0 "mean speed of the air, y" annotation(Dialog(tab = "wind"));
  parameter Real wind_speed_z(unit = "m/s") = 0.0 "mean speed of the air, z" annotation(Dialog(tab = "wind"));
  parameter Real wind_gust_speed_x(unit = "m/s") = 0.0 "peak of the gust's speed, x" annotation(Dialog(tab = "wind"));
  parameter Real wind_gust_speed_y(unit = "m/s") = 0.0 "peak of the gust's speed, y" annotation(Dialog(tab = "wind"));
  parameter Real wind_gust_speed_z(unit = "m/s") = 0.0 "peak of the gust's speed, z" annotation(Dialog(tab = "wind"));
  parameter Real wind_turbulence_deviation_x(unit = "m/s", min = 0.0) = 0.0 "standard deviation of the air's turbulence; needs wind.speed, x" annotation(Dialog(tab = "wind"));
  parameter Real wind_turbulence_deviation_y(unit = "m/s", min = 0.0) = 0.0 "standard deviation of the air's turbulence; needs wind.speed, y" annotation(Dialog(tab = "wind"));
  parameter Real wind_turbulence_deviation_z(unit = "m/s", min = 0.0) = 0.0 "standard deviation of the air's turbulence; needs wind.speed, z" annotation(Dialog(tab = "wind"));
  parameter Real wind_turbulence_length(unit = "m", min = 0.001) = 1200.0 "length scale of Davenport's spectrum" annotation(Dialog(tab = "wind"));
  parameter Real wind_turbulence_bandwidth(unit = "Hz", min = 1e-09, max = 1000000.0) = 1.0 "largest frequency of the turbulence" annotation(Dialog(tab = "wind"));
  parameter Integer wind_turbulence_seed(min = 0, max = 2147483647) = 0 "seed of the turbulence" annotation(Dialog(tab = "wind"));
  parameter Real wind_air_density(unit = "kg/m3", min = 0.0) = 1.225 "density of the air" annotation(Dialog(tab = "wind"));
  parameter Real load_drag_area(unit = "m2", min = 0.0) = 0.0 "drag coefficient of the load times its area; 0: the air's speed does not act" annotation(Dialog(tab = "load"));
  parameter Integer payload_count(min = 0, max = 4) = 0 "number of payload changes in use" annotation(Dialog(tab = "payload"));
  parameter Real payload_1_time(unit = "s") = 0.0 "time of a payload change" annotation(Dialog(tab = "payload"));
  parameter Real payload_1_mass(unit = "kg", min = 1e-09) = 1.0 "mass of the load from then on" annotation(Dialog(tab = "payload"));
  parameter Real payload_2_time(unit = "s") = 0.0 "time of a payload change" annotation(Dialog(tab = "payload"));
  parameter Real payload_2_mass(unit = "kg", min = 1e-09) = 1.0 "mass of the load from then on" annotation(Dialog(tab = "payload"));
  parameter Real payload_3_time(unit = "s") = 0.0 "time of a payload change" annotation(Dialog(tab = "payload"));
  parameter Real payload_3_mass(unit = "kg", min = 1e-09) = 1.0 "mass of the load from then on" annotation(Dialog(tab = "payload"));
  parameter Real payload_4_time(unit = "s") = 0.0 "time of a payload change" annotation(Dialog(tab = "payload"));
  parameter Real payload_4_mass(unit = "kg", min = 1e-09) = 1.0 "mass of the load from then on" annotation(Dialog(tab = "payload"));
  parameter Boolean feedback_enabled = false "sway feedback acts" annotation(Dialog(tab = "feedback"));
  parameter Types.FeedbackDesign feedback_design = Types.FeedbackDesign.lqr "gains of a linear-quadratic design, or closed form" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_sample_time(unit = "s", min = 1e-06) = 0.01 "period of the feedback" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_payload_mass(unit = "kg", min = 0.0) = 0.0 "mass of the load that the feedback is designed for; 0: crane.payload_mass" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_bandwidth(min = 1e-06) = 1.0 "of design flatness: bandwidth in units of the pendulum's frequency" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hoist_bandwidth(min = 1e-06) = 3.0 "of design flatness: bandwidth of the hoist in units of the pendulum's frequency" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_damping(min = 1e-06) = 1.0 "of design flatness: damping of all poles" annotation(Dialog(tab = "feedback"));
  parameter Types.FeedbackSource feedback_source = Types.FeedbackSource.measured "the true state, or measured.* alone, with an observer" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_rejection_carriage(min = 0.0, max = 1.0) = 1.0 "share of the estimated disturbance of the carriages and the rope that is rejected" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_rejection_load(min = 0.0, max = 1.0) = 1.0 "share of the estimated disturbance of the load that is rejected" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_fade(unit = "s", min = 0.0) = 0.1 "time constant of the change when something is switched or tuned; 0: the correction jumps" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_payload_time(unit = "s", min = 1e-06) = 2.0 "time constant of the payload's estimate" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_observer_position(unit = "m", min = 0.0) = 0.0 "expected quantisation step of the carriages' positions; 0: that of the sensors" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_observer_length(unit = "m", min = 0.0) = 0.0 "expected quantisation step of the rope's length; 0: that of the sensor" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_observer_angle(unit = "rad", displayUnit = "deg", min = 0.0) = 0.0 "expected quantisation step of the sway angles; 0: that of the sensors" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_observer_drift(min = 1e-12) = 0.1 "expected random walk of the carriages' and the rope's unknown accelerations: standard deviation after sqrt(l / g) over gravity" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_observer_wind(min = 1e-12) = 0.015 "expected the same of the load's" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_observer_wake(min = 0.0) = 1.0 "number of quantisation steps that a signal differs from its reference when corrections begin; 0: from the start" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_observer_offset(min = 0.0) = 0.05 "expected standard deviation of the zero of the rope's sensor over the rope's length, which is estimated; 0: it is not" annotation(Dialog(tab = "feedback"));
  parameter Boolean feedback_rope_offset = false "the measured length of the rope is corrected by estimate.rope_offset" annotation(Dialog(tab = "feedback"));
  parameter Types.OffsetCause feedback_offset_cause = Types.OffsetCause.wind "what a lasting deviation of a sway angle is: wind, for which the carriage makes room, or the zero of the angle's sensor" annotation(Dialog(tab = "feedback"));
  parameter Real sling_x_angle_start(unit = "rad", displayUnit = "deg", nominal = 0.1) = 0.0 "start value: true sling.x.angle" annotation(Dialog(tab = "start"));
  parameter Real sling_y_angle_start(unit = "rad", displayUnit = "deg", nominal = 0.1) = 0.0 "start value: true sling.y.angle" annotation(Dialog(tab = "start"));
  parameter Real sling_x_rate_start(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) = 0.0 "start value: true sling.x.rate" annotation(Dialog(tab = "start"));
  parameter Real sling_y_rate_start(unit = "rad/s", displayUnit = "deg/s", nominal = 0.1) = 0.0 "start value: true sling.y.rate" annotation(Dialog(tab = "start"));
  parameter Real hook_mass(unit = "kg", min = 1e-09) = 0.1 "true crane: mass of the hook" annotation(Dialog(tab = "hook"));
  parameter Real hook_sling(unit = "m", min = 1e-09) = 0.3 "true crane: length of the sling, from hook to load" annotation(Dialog(tab = "hook"));
  parameter Real feedback_sling(unit = "m", min = 0.0) = 0.0 "length of the sling that the feedback is designed for; 0: hook.sling" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_position(min = 0.0) = 0.4 "feedback of source measured, dimensionless: carriage's position" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_angle(min = 0.0) = 1.0 "feedback of source measured, dimensionless: both angles" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_velocity(min = 0.0) = 1.0 "feedback of source measured, dimensionless: velocity of carriage and rope" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_rate(min = 0.0) = 0.3 "feedback of source measured, dimensionless: rates of both angles" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_effort(min = 0.0) = 2.0 "feedback of source measured, dimensionless: effort" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_rope(min = 0.0) = 9.0 "feedback of source measured, dimensionless: rope's length" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_push(min = 0.0) = 0.13 "feedback of source measured, dimensionless: acceleration of the carriage that the observer expects, over gravity" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_swing(min = 0.0) = 0.27 "feedback of source measured, dimensionless: acceleration of the load that it expects, over gravity" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_drift(min = 0.0) = 0.13 "feedback of source measured, dimensionless: walk of the unknown acceleration over gravity, in sqrt(L / g)" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_hook_noise(min = 0.0) = 0.001 "feedback of source measured, dimensionless: errors of the signals over L, and of the angles" annotation(Dialog(tab = "feedback"));
  parameter Types.DriveMode feedback_table_mode = Types.DriveMode.force "drive.mode that the gains in the table are for" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_table_payload_mass(unit = "kg", min = 1e-09) = 1.0 "mass of the load that the gains in the table are for" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_table_length[:](each unit = "m", each min = 1e-09) = {0.16, 0.18402133941664497, 0.21164908350435035, 0.24342467395484932, 0.2799708409264467,
      0.32200380715555726, 0.3703473243126543, 0.42594881668365786, 0.4898979485566356,
      0.563447979192867, 0.6480403238917082, 0.7453328024909286, 0.85723212890964,
      0.9859312784558375, 1.1339524652138024, 1.3041965717715653, 1.5} "rope lengths of the table of gains" annotation(Dialog(tab = "feedback"));
  final parameter Integer feedback_table_count = size(feedback_table_length, 1) "rope lengths in the table of gains; its start values are those of weights position 1.0, angle 1.0, velocity 1.0, rate 1.0, effort 1.0";
  parameter Real feedback_table_bridge[feedback_table_count, 5] = [495.2792722279254, -101.68957434311993, 136.31861135337454, 1.799440951194204, 0.0;
      437.0288866784117, -103.303596665725, 128.81578796066702, 2.0026794235079044, 0.0;
      385.25246246685924, -104.83118624620607, 121.61993703533741, 2.2219490290163817, 0.0;
      339.29945700159004, -106.27543788029345, 114.7322924493292, 2.458334633314458, 0.0;
      298.57193598571695, -107.6395549473711, 108.15186703336241, 2.7130031383589444, 0.0;
      262.5227810416982, -108.92680859464988, 101.87575576848957, 2.9872094422352578, 0.0;
      230.65340661816785, -110.14050248544996, 95.8994192436701, 3.2823027939325664, 0.0;
      202.51113528997388, -111.2839426707816, 90.2169454594923, 3.5997335790537566, 0.0;
      177.68635608262375, -112.36041212586116, 84.82128901941917, 3.9410605738396365, 0.0;
      155.8095679015997, -113.37314949155675, 79.70448750735002, 4.307958706804628, 0.0;
      136.54838990437648, -114.32533157324444, 74.85785542930766, 4.702227369064705, 0.0;
      119.60460288697455, -115.22005916990287, 70.27215652682698, 5.1257993170690135, 0.0;
      104.71127045847031, -116.06034583215734, 65.93775557226044, 5.580750213499134, 0.0;
      91.62997584129312, -116.84910917796591, 61.844750958547266, 6.069308855274204, 0.0;
      80.1481993754995, -117.58916442592461, 57.983089515220655, 6.593868140493184, 0.0;
      70.07685300905264, -118.28321983738624, 54.34266503803258, 7.15699682952584, 0.0;
      61.247980983722876, -118.93387378919908, 50.913402025650626, 7.761452159005088, 0.0] "gains of the bridge by the errors of position, angle, velocity, rate, command" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_table_trolley[feedback_table_count, 5] = [171.12016606392177, 29.275890496654004, 47.291230292266874, -0.7877974013713973, 0.0;
      150.95747245479913, 29.82919627879027, 44.67807101202137, -0.8700272559144467, 0.0;
      133.042602651937, 30.352760665033948, 42.173211630656056, -0.9586835773905993, 0.0;
      117.14835004276965, 30.847660644896944, 39.77685225605123, -1.0542041885787437, 0.0;
      103.0661535559701, 31.315009226826334, 37.48844560103378, -1.1570599105140063, 0.0;
      90.60539686859343, 31.755941386499334, 35.306800466426516, -1.2677569545151173, 0.0;
      79.59255089671109, 32.17160196735857, 33.23017840862391, -1.3868394745222576, 0.0;
      69.87020930628286, 32.56313537125768, 31.256382940387336, -1.5148922939628624, 0.0;
      61.29605852820283, 32.93167687327372, 29.38284094603388, -1.6525438221744688, 0.0;
      53.74181615485919, 33.27834539526164, 27.606676251588887, -1.8004691758583005, 0.0;
      47.09216477702177, 33.60423757924394, 25.92477549011614, -1.9593935221936745, 0.0;
      41.24370233629524, 33.91042300906315, 24.33384654783522, -2.1300956608662314, 0.0;
      36.103924926899495, 34.19794043955319, 22.83046998033465, -2.313411863542267, 0.0;
      31.590253637659803, 34.46779490278061, 21.411143855498977, -2.5102399902272254, 0.0;
      27.62911342199856, 34.72095557297682, 20.072322519943707, -2.721543903419541, 0.0;
      24.1550690441056, 34.95835428259661, 18.810449803151613, -2.948358202087776, 0.0;
      21.11002079463424, 35.18088459337045, 17.621987174838875, -3.191793299181677, 0.0] "gains of the trolley by the errors of position, angle, velocity, rate, command" annotation(Dialog(tab = "feedback"));
  parameter Real feedback_table_hoist[feedback_table_count, 3] = [450.44578749631887, 35.61729196049007, 0.0;
      397.0308866690633, 33.50544191295822, 0.0;
      349.6311234880476, 31.500809398510036, 0.0;
      307.62795141319225, 29.600241197596514, 0.0;
      270.4554362844191, 27.800359447070807, 0.0;
      237.59792296438704, 26.09761706246386, 0.0;
      208.58732848654822, 24.488347035668074, 0.0;
      183.00019854238195, 22.9688058670456, 0.0;
      160.4546383481842, 21.535211462897273, 0.0;
      140.6072061901626, 20.183775875990094, 0.0;
      123.14983827106141, 18.91073329344541, 0.0;
      107.80685674356153, 17.71236368691699, 0.0;
      94.33209880315104, 16.585012538462546, 0.0;
      82.5061931607132, 15.525107044748186, 0.0;
      72.13400084052199, 14.529169184946022, 0.0;
      63.04222976561128, 13.593826015840092, 0.0;
      55.077226726948105, 12.715817532987826, 0.0] "gains of the hoist by the errors of position, velocity, command" annotation(Dialog(tab = "feedback"));
  Real bridge_acceleration(unit = "m/s2") "acceleration of bridge";
  Real trolley_acceleration(unit = "m/s2") "acceleration of trolley";
  Real rope_acceleration(unit = "m/s2") "acceleration of rope";
  Real sway_x_acceleration(unit = "rad/s2", displayUnit = "deg/s2") "acceleration of sway.x";
  Real sway_y_acceleration(unit = "rad/s2", displayUnit = "deg/s2") "acceleration of sway.y";
  Real friction_bridge_deflection_rate(unit = "m/s") "derivative of friction.bridge.deflection";
  Real friction_trolley_deflection_rate(unit = "m/s") "derivative of friction.trolley.deflection";
  Real friction_hoist_deflection_rate(unit = "m/s") "derivative of friction.hoist.deflection";
  Real power_drives(unit = "W", nominal = 10.0) "power of all drives";
  Real sling_x_acceleration(unit = "rad/s2", displayUnit = "deg/s2") "acceleration of sling.x";
  Real sling_y_acceleration(unit = "rad/s2", displayUnit = "deg/s2") "acceleration of sling.y";
protected
  constant Integer feedback_table_length_references[17] = {254, 268, 282, 296, 310, 324, 338, 352, 366, 380, 394, 408, 422, 436, 450, 464, 478};
  constant Integer feedback_table_bridge_references[17, 5] = [255, 256, 257, 258, 259;
      269, 270, 271, 272, 273;
      283, 284, 285, 286, 287;
      297, 298, 299, 300, 301;
      311, 312, 313, 314, 315;
      325, 326, 327, 328, 329;
      339, 340, 341, 342, 343;
      353, 354, 355, 356, 357;
      367, 368, 369, 370, 371;
      381, 382, 383, 384, 385;
      395, 396, 397, 398, 399;
      409, 410, 411, 412, 413;
      423, 424, 425, 426, 427;
      437, 438, 439, 440, 441;
      451, 452, 453, 454, 455;
      465, 466, 467, 468, 469;
      479, 480, 481, 482, 483];
  constant Integer feedback_table_trolley_references[17, 5] = [260, 261, 262, 263, 264;
      274, 275, 276, 277, 278;
      288, 289, 290, 291, 292;
      302, 303, 304, 305, 306;
      316, 317, 318, 319, 320;
      330, 331, 332, 333, 334;
      344, 345, 346, 347, 348;
      358, 359, 360, 361, 362;
      372, 373, 374, 375, 376;
      386, 387, 388, 389, 390;
      400, 401, 402, 403, 404;
      414, 415, 416, 417, 418;
      428, 429, 430, 431, 432;
      442, 443, 444, 445, 446;
      456, 457, 458, 459, 460;
      470, 471, 472, 473, 474;
      484, 485, 486, 487, 488];
  constant Integer feedback_table_hoist_references[17, 3] = [265, 266, 267;
      279, 280, 281;
      293, 294, 295;
      307, 308, 309;
      321, 322, 323;
      335, 336, 337;
      349, 350, 351;
      363, 364, 365;
      377, 378, 379;
      391, 392, 393;
      405, 406, 407;
      419, 420, 421;
      433, 434, 435;
      447, 448, 449;
      461, 462, 463;
      475, 476, 477;
      489, 490, 491];
  final parameter Integer real_references[:] = cat(1, {27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 85, 86, 87, 88, 89, 90, 93, 94, 95, 96, 97, 98, 99,
      100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117,
      118, 119, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129, 130, 131, 132, 133, 134, 135,
      136, 137, 138, 139, 140, 141, 142, 143, 144, 145, 146, 147, 149, 150, 152, 153, 154, 155,
      156, 157, 158, 159, 160, 161, 162, 163, 164, 165, 166, 167, 168, 169, 170, 171, 173, 174,
      175, 176, 177, 178, 179, 181, 182, 183, 184, 185, 186, 187, 188, 189, 190, 191, 193, 194,
      196, 197, 198, 199, 200, 201, 202, 203, 206, 207, 208, 209, 210, 212, 213, 214, 215, 216,
      217, 218, 219, 220, 221, 222, 225, 226, 227, 228, 238, 239, 240, 241, 242, 243, 244, 245,
      246, 247, 248, 249, 250, 253},
      feedback_table_length_references[1:feedback_table_count],
      FMI.references(feedback_table_bridge_references, feedback_table_count),
      FMI.references(feedback_table_trolley_references, feedback_table_count),
      FMI.references(feedback_table_hoist_references, feedback_table_count));
  final parameter Real reals[:] = cat(1, {bridge_position_start, trolley_position_start, rope_length_start, sway_x_angle_start,
      sway_y_angle_start, bridge_velocity_start, trolley_velocity_start, rope_velocity_start,
      sway_x_rate_start, sway_y_rate_start, crane_bridge_mass, crane_trolley_mass,
      crane_payload_mass, crane_gravity, crane_rope_min, crane_rope_max, setpoint_lead,
      drive_bridge_lag, drive_bridge_force_max, drive_bridge_force_min,
      drive_bridge_acceleration_max, drive_bridge_acceleration_min, drive_bridge_velocity_max,
      drive_bridge_velocity_min, drive_bridge_power_max, drive_bridge_dead_time,
      drive_trolley_lag, drive_trolley_force_max, drive_trolley_force_min,
      drive_trolley_acceleration_max, drive_trolley_acceleration_min, drive_trolley_velocity_max,
      drive_trolley_velocity_min, drive_trolley_power_max, drive_trolley_dead_time,
      drive_hoist_lag, drive_hoist_force_max, drive_hoist_force_min, drive_hoist_acceleration_max,
      drive_hoist_acceleration_min, drive_hoist_velocity_max, drive_hoist_velocity_min,
      drive_hoist_power_max, drive_hoist_dead_time, friction_bridge_viscous,
      friction_bridge_coulomb, friction_bridge_static, friction_bridge_drag,
      friction_trolley_viscous, friction_trolley_coulomb, friction_trolley_static,
      friction_trolley_drag, friction_hoist_viscous, friction_hoist_coulomb,
      friction_hoist_static, friction_hoist_drag, friction_width, friction_presliding,
      friction_sway_viscous, travel_bridge_min, travel_bridge_max, travel_bridge_stiffness,
      travel_bridge_damping, travel_trolley_min, travel_trolley_max, travel_trolley_stiffness,
      travel_trolley_damping, travel_rope_min, travel_rope_max, travel_rope_stiffness,
      travel_rope_damping, sensor_sample_time, sensor_dead_time,
      sensor_bridge_position_resolution, sensor_bridge_position_deviation,
      sensor_bridge_position_offset, sensor_trolley_position_resolution,
      sensor_trolley_position_deviation, sensor_trolley_position_offset,
      sensor_rope_length_resolution, sensor_rope_length_deviation, sensor_rope_length_offset,
      sensor_sway_x_angle_resolution, sensor_sway_x_angle_deviation, sensor_sway_x_angle_offset,
      sensor_sway_y_angle_resolution, sensor_sway_y_angle_deviation, sensor_sway_y_angle_offset,
      wind_constant_x, wind_constant_y, wind_constant_z, wind_gust_start, wind_gust_duration,
      wind_gust_force_x, wind_gust_force_y, wind_gust_force_z, wind_noise_deviation_x,
      wind_noise_deviation_y, wind_noise_deviation_z, wind_noise_bandwidth, wind_speed_x,
      wind_speed_y, wind_speed_z, wind_gust_speed_x, wind_gust_speed_y, wind_gust_speed_z,
      wind_turbulence_deviation_x, wind_turbulence_deviation_y, wind_turbulence_deviation_z,
      wind_turbulence_length, wind_turbulence_bandwidth, wind_air_density, load_drag_area,
      payload_1_time, payload_1_mass, payload_2_time, payload_2_mass, payload_3_time,
      payload_3_mass, payload_4_time, payload_4_mass, feedback_sample_time, feedback_payload_mass,
      feedback_bandwidth, feedback_hoist_bandwidth, feedback_damping, feedback_rejection_carriage,
      feedback_rejection_load, feedback_fade, feedback_payload_time, feedback_observer_position,
      feedback_observer_length, feedback_observer_angle, feedback_observer_drift,
      feedback_observer_wind, feedback_observer_wake, feedback_observer_offset,
      sling_x_angle_start, sling_y_angle_start, sling_x_rate_start, sling_y_rate_start, hook_mass,
      hook_sling, feedback_sling, feedback_hook_position, feedback_hook_angle,
      feedback_hook_velocity, feedback_hook_rate, feedback_hook_effort, feedback_hook_rope,
      feedback_hook_push, feedback_hook_swing, feedback_hook_drift, feedback_hook_noise,
      feedback_table_payload_mass},
      feedback_table_length,
      FMI.rows(feedback_table_bridge),
      FMI.rows(feedback_table_trolley),
      FMI.rows(feedback_table_hoist));
  constant Integer integer_references[12] = {91, 148, 151, 172, 180, 192, 195, 205, 211, 224, 251, 252};
  final parameter Integer integers[12] = {Integer(drive_mode), Integer(rope_slack), sensor_seed, Integer(wind_gust_shape),
      wind_noise_seed, wind_turbulence_seed, payload_count, Integer(feedback_design),
      Integer(feedback_source), Integer(feedback_offset_cause), feedback_table_count,
      Integer(feedback_table_mode)};
  constant Integer boolean_references[3] = {92, 204, 223};
  final parameter Integer booleans[3] = {if start_on_reference then 1 else 0, if feedback_enabled then 1 else 0, if
      feedback_rope_offset then 1 else 0};
  constant Integer input_references[26] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25,
      26};
  Interfaces.RealInput force_bridge_used;
  Interfaces.RealInput force_trolley_used;
  Interfaces.RealInput force_hoist_used;
  Interfaces.RealInput velocity_bridge_used;
  Interfaces.RealInput velocity_trolley_used;
  Interfaces.RealInput velocity_hoist_used;
  Interfaces.RealInput reference_bridge_position_used;
  Interfaces.RealInput reference_trolley_position_used;
  Interfaces.RealInput reference_rope_length_used;
  Interfaces.RealInput reference_sway_x_angle_used;
  Interfaces.RealInput reference_sway_y_angle_used;
  Interfaces.RealInput reference_bridge_velocity_used;
  Interfaces.RealInput reference_trolley_velocity_used;
  Interfaces.RealInput reference_rope_velocity_used;
  Interfaces.RealInput reference_sway_x_rate_used;
  Interfaces.RealInput reference_sway_y_rate_used;
  Interfaces.RealInput reference_load_position_x_used;
  Interfaces.RealInput reference_load_position_y_used;
  Interfaces.RealInput reference_load_position_z_used;
  Interfaces.RealInput wind_x_used;
  Interfaces.RealInput wind_y_used;
  Interfaces.RealInput wind_z_used;
  Interfaces.RealInput reference_sling_x_angle_used;
  Interfaces.RealInput reference_sling_y_angle_used;
  Interfaces.RealInput reference_sling_x_rate_used;
  Interfaces.RealInput reference_sling_y_rate_used;
  Real inputs[26] = {force_bridge_used, force_trolley_used, force_hoist_used, velocity_bridge_used,
      velocity_trolley_used, velocity_hoist_used, reference_bridge_position_used,
      reference_trolley_position_used, reference_rope_length_used, reference_sway_x_angle_used,
      reference_sway_y_angle_used, reference_bridge_velocity_used,
      reference_trolley_velocity_used, reference_rope_velocity_used, reference_sway_x_rate_used,
      reference_sway_y_rate_used, reference_load_position_x_used, reference_load_position_y_used,
      reference_load_position_z_used, wind_x_used, wind_y_used, wind_z_used,
      reference_sling_x_angle_used, reference_sling_y_angle_used, reference_sling_x_rate_used,
      reference_sling_y_rate_used};
  FMI.Instance fmu = FMI.Instance(folder, "HookCrane", getInstanceName(),
      "{8069133e-6e5b-708f-92fa-6bc651361b5e}", 20);
  final parameter Real started(fixed = false) "the FMU has its parameters";
  final parameter Real begun(fixed = false) "the FMU is initialised";
  Real x[20](each stateSelect = StateSelect.always, each nominal = 0.1) "states of the FMU";
  discrete Real next(start = 0, fixed = true) "time of the next event";
  Real last "changes with every event";
initial equation
  started = FMI.start(fmu, time, real_references, reals, integer_references, integers,
      boolean_references, booleans);
  begun = FMI.begin(fmu, input_references, inputs, started);
  x = FMI.states(fmu, {7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 23, 24, 25, 26},
      {reference_bridge_position_used, reference_trolley_position_used, reference_rope_length_used,
      reference_sway_x_angle_used, reference_sway_y_angle_used, reference_bridge_velocity_used,
      reference_trolley_velocity_used, reference_rope_velocity_used, reference_sway_x_rate_used,
      reference_sway_y_rate_used, reference_load_position_x_used, reference_load_position_y_used,
      reference_load_position_z_used, reference_sling_x_angle_used, reference_sling_y_angle_used,
      reference_sling_x_rate_used, reference_sling_y_rate_used}, 20, started);
equation
  connect(force_bridge, force_bridge_used);
  connect(force_trolley, force_trolley_used);
  connect(force_hoist, force_hoist_used);
  connect(velocity_bridge, velocity_bridge_used);
  connect(velocity_trolley, velocity_trolley_used);
  connect(velocity_hoist, velocity_hoist_used);
  connect(reference_bridge_position, reference_bridge_position_used);
  connect(reference_trolley_position, reference_trolley_position_used);
  connect(reference_rope_length, reference_rope_length_used);
  connect(reference_sway_x_angle, reference_sway_x_angle_used);
  connect(reference_sway_y_angle, reference_sway_y_angle_used);
  connect(reference_bridge_velocity, reference_bridge_velocity_used);
  connect(reference_trolley_velocity, reference_trolley_velocity_used);
  connect(reference_rope_velocity, reference_rope_velocity_used);
  connect(reference_sway_x_rate, reference_sway_x_rate_used);
  connect(reference_sway_y_rate, reference_sway_y_rate_used);
  connect(reference_load_position_x, reference_load_position_x_used);
  connect(reference_load_position_y, reference_load_position_y_used);
  connect(reference_load_position_z, reference_load_position_z_used);
  connect(wind_x, wind_x_used);
  connect(wind_y, wind_y_used);
  connect(wind_z, wind_z_used);
  connect(reference_sling_x_angle, reference_sling_x_angle_used);
  connect(reference_sling_y_angle, reference_sling_y_angle_used);
  connect(reference_sling_x_rate, reference_sling_x_rate_used);
  connect(reference_sling_y_rate, reference_sling_y_rate_used);
  if not use_force then
    force_bridge_used = force_bridge_start;
    force_trolley_used = force_trolley_start;
    force_hoist_used = force_hoist_start;
  end if;
  if not use_velocity then
    velocity_bridge_used = velocity_bridge_start;
    velocity_trolley_used = velocity_trolley_start;
    velocity_hoist_used = velocity_hoist_start;
  end if;
  if not use_reference then
    reference_bridge_position_used = reference_bridge_position_start;
    reference_trolley_position_used = reference_trolley_position_start;
    reference_rope_length_used = reference_rope_length_start;
    reference_sway_x_angle_used = reference_sway_x_angle_start;
    reference_sway_y_angle_used = reference_sway_y_angle_start;
    reference_bridge_velocity_used = reference_bridge_velocity_start;
    reference_trolley_velocity_used = reference_trolley_velocity_start;
    reference_rope_velocity_used = reference_rope_velocity_start;
    reference_sway_x_rate_used = reference_sway_x_rate_start;
    reference_sway_y_rate_used = reference_sway_y_rate_start;
    reference_load_position_x_used = reference_load_position_x_start;
    reference_load_position_y_used = reference_load_position_y_start;
    reference_load_position_z_used = reference_load_position_z_start;
    reference_sling_x_angle_used = reference_sling_x_angle_start;
    reference_sling_y_angle_used = reference_sling_y_angle_start;
    reference_sling_x_rate_used = reference_sling_x_rate_start;
    reference_sling_y_rate_used = reference_sling_y_rate_start;
  end if;
  if not use_wind then
    wind_x_used = wind_x_start;
    wind_y_used = wind_y_start;
    wind_z_used = wind_z_start;
  end if;
  when {initial(), time >= pre(next)} then
    next = FMI.event(fmu, time, x, input_references, inputs, begun);
  end when;
  // what an event changed is seen behind it
  last = started + pre(next);
  der(x) = FMI.derivatives(fmu, time, x, {1, 2, 3, 4, 5, 6, 20, 21, 22},
      {force_bridge_used, force_trolley_used, force_hoist_used, velocity_bridge_used,
      velocity_trolley_used, velocity_hoist_used, wind_x_used, wind_y_used, wind_z_used}, last);
  {bridge_position, trolley_position, rope_length, sway_x_angle, sway_y_angle, bridge_velocity,
      trolley_velocity, rope_velocity, sway_x_rate, sway_y_rate, measured_bridge_position,
      measured_trolley_position, measured_rope_length, measured_sway_x_angle,
      measured_sway_y_angle, load_position_x, load_position_y, load_position_z, load_velocity_x,
      load_velocity_y, load_velocity_z, payload_mass, energy_kinetic, energy_potential,
      energy_work, energy_drives, energy_wind, energy_payload, energy_dissipated,
      energy_imbalance, estimate_payload_mass, estimate_disturbance_bridge,
      estimate_disturbance_trolley, estimate_disturbance_hoist, estimate_disturbance_load_x,
      estimate_disturbance_load_y, estimate_rope_offset, sling_x_angle, sling_y_angle,
      sling_x_rate, sling_y_rate, hook_position_x, hook_position_y, hook_position_z,
      hook_velocity_x, hook_velocity_y, hook_velocity_z, sway_frequency_slow, sway_frequency_fast,
      friction_bridge_deflection_rate, friction_trolley_deflection_rate,
      friction_hoist_deflection_rate}
      = FMI.reals(fmu, time, x, fill(0, 0),
      fill(0.0, 0),
      {27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 62, 63,
      64, 65, 66, 67, 68, 69, 70, 73, 74, 75, 76, 77, 78, 79, 225, 226, 227, 228, 229, 230, 231,
      232, 233, 234, 236, 237, 497, 498, 499}, last);
  {error_load_x}
      = FMI.reals(fmu, time, x, {17},
      {reference_load_position_x_used},
      {48}, last);
  {error_load_y}
      = FMI.reals(fmu, time, x, {18},
      {reference_load_position_y_used},
      {49}, last);
  {error_load_z}
      = FMI.reals(fmu, time, x, {19},
      {reference_load_position_z_used},
      {50}, last);
  {error_load_norm}
      = FMI.reals(fmu, time, x, {17, 18, 19},
      {reference_load_position_x_used, reference_load_position_y_used,
      reference_load_position_z_used},
      {51}, last);
  {drive_bridge_force, drive_bridge_power, drive_trolley_force, drive_trolley_power,
      drive_hoist_force, drive_hoist_power, rope_force, power_wind, power_friction, sling_tension,
      bridge_acceleration, trolley_acceleration, rope_acceleration, sway_x_acceleration,
      sway_y_acceleration, power_drives, sling_x_acceleration, sling_y_acceleration}
      = FMI.reals(fmu, time, x, {1, 2, 3, 4, 5, 6, 20, 21, 22},
      {force_bridge_used, force_trolley_used, force_hoist_used, velocity_bridge_used,
      velocity_trolley_used, velocity_hoist_used, wind_x_used, wind_y_used, wind_z_used},
      {52, 54, 55, 57, 58, 60, 61, 71, 72, 235, 492, 493, 494, 495, 496, 500, 508, 509}, last);
  {friction_bridge_deflection, friction_trolley_deflection, friction_hoist_deflection,
      load_speed, sway_total}
      = FMI.reals(fmu, time, x, {1, 2, 3, 4, 5, 6, 20, 21, 22, 17, 18, 19},
      {force_bridge_used, force_trolley_used, force_hoist_used, velocity_bridge_used,
      velocity_trolley_used, velocity_hoist_used, wind_x_used, wind_y_used, wind_z_used,
      reference_load_position_x_used, reference_load_position_y_used,
      reference_load_position_z_used},
      {80, 81, 82, 83, 84}, last);
  drive_bridge_saturated = FMI.boolean(fmu, 53, last);
  drive_trolley_saturated = FMI.boolean(fmu, 56, last);
  drive_hoist_saturated = FMI.boolean(fmu, 59, last);
  annotation(
    Diagram(coordinateSystem(extent = {{-200, -970}, {200, 970}})),
    Icon(coordinateSystem(extent = {{-200, -970}, {200, 970}}), graphics = {
      Rectangle(extent = {{-200, -970}, {200, 970}}, lineColor = {60, 60, 60}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid),
      Text(extent = {{-200, 980}, {200, 1040}}, textString = "%name", textColor = {0, 0, 255}),
      Line(points = {{-60, 60}, {60, 60}}, color = {60, 60, 60}, thickness = 3),
      Line(points = {{-20, 60}, {-2, 10}, {6, -55}}, color = {60, 60, 60}),
      Ellipse(extent = {{-10, 2}, {6, 18}}, lineColor = {60, 60, 60}, fillColor = {60, 60, 60}, fillPattern = FillPattern.Solid),
      Ellipse(extent = {{-12, -97}, {32, -53}}, lineColor = {200, 90, 0}, fillColor = {200, 90, 0}, fillPattern = FillPattern.Solid),
      Text(extent = {{-190, 302}, {-90, 318}}, textString = "force", horizontalAlignment = TextAlignment.Left, textColor = {60, 60, 60}),
      Text(extent = {{-190, 222}, {-90, 238}}, textString = "velocity", horizontalAlignment = TextAlignment.Left, textColor = {60, 60, 60}),
      Text(extent = {{-190, 142}, {-90, 158}}, textString = "reference", horizontalAlignment = TextAlignment.Left, textColor = {60, 60, 60}),
      Text(extent = {{-190, -138}, {-90, -122}}, textString = "wind", horizontalAlignment = TextAlignment.Left, textColor = {60, 60, 60}),
      Text(extent = {{90, 942}, {190, 958}}, textString = "bridge", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 902}, {190, 918}}, textString = "trolley", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 862}, {190, 878}}, textString = "rope", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 822}, {190, 838}}, textString = "sway", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 582}, {190, 598}}, textString = "measured", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 462}, {190, 478}}, textString = "load", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 322}, {190, 338}}, textString = "error", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, 222}, {190, 238}}, textString = "drive", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -18}, {190, -2}}, textString = "payload", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -58}, {190, -42}}, textString = "energy", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -238}, {190, -222}}, textString = "power", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -298}, {190, -282}}, textString = "estimate", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -458}, {190, -442}}, textString = "friction", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -618}, {190, -602}}, textString = "sling", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60}),
      Text(extent = {{90, -718}, {190, -702}}, textString = "hook", horizontalAlignment = TextAlignment.Right, textColor = {60, 60, 60})}));
end HookCrane;
