/* Generated from the kernels in Python by `python -m segfmu.codegen`; never edited. */
#ifndef SEGFMU_KERNELS_H
#define SEGFMU_KERNELS_H

#include <stdbool.h>
#include <stdint.h>

#include "span.h"
#include "visible.h"

SEGFMU_API void segfmu_evaluate(array_double_1d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, int64_t derivative, array_double_2d values);
SEGFMU_API void segfmu_evaluate_orders(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d values);
SEGFMU_API double segfmu_state_scale(int64_t order, double duration, array_double_1d limits);
SEGFMU_API int64_t segfmu_check_plan(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, double tolerance, double joints, array_double_2d work);
SEGFMU_API int64_t segfmu_check_braked_plan(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, array_double_2d brakes, double tolerance, double joints, array_double_2d work);
SEGFMU_API int64_t segfmu_check_rope(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work, array_double_1d report);
SEGFMU_API int64_t segfmu_clearance_spans(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work, array_double_3d spans);
SEGFMU_API int64_t segfmu_contact_times(int64_t part, double until, int64_t count, array_double_1d box, array_double_3d spans, array_double_3d stack, array_double_2d times, array_double_1d place);
SEGFMU_API void segfmu_path_ranges(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work, array_double_2d ranges);
SEGFMU_API void segfmu_shrink_boxes(double touch, array_double_2d boxes);
SEGFMU_API int64_t segfmu_first_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d boxes, array_double_2d work, array_double_3d stack, array_double_2d ranges, array_double_1d report);
SEGFMU_API void segfmu_write_box(array_double_1d space, array_double_1d obstacle, array_double_1d box);
SEGFMU_API int64_t segfmu_space_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d space, array_double_2d obstacles, array_double_2d boxes, array_double_2d work, array_double_3d stack, array_double_2d ranges, array_double_1d fault);
SEGFMU_API void segfmu_feedback_correction(array_double_1d state, array_double_1d reference, array_double_1d added, array_double_3d gains, array_double_1d correction);
SEGFMU_API double segfmu_feedback_bandwidth(double ratio, double length, double gravity, double delay, double largest);
SEGFMU_API void segfmu_feedback_gains(array_double_1d plant, double length, double bandwidth, double pendulum, double hoist_bandwidth, double damping, array_double_2d gains);
SEGFMU_API void segfmu_observer_predict(int64_t axis, double length, array_double_3d table, double command, double correction, array_double_1d estimate, array_double_1d scratch);
SEGFMU_API void segfmu_observer_correct(double length, array_double_3d table, array_double_1d measured, array_double_1d reference, array_double_2d estimate);
SEGFMU_API void segfmu_observer_design(array_double_1d plant, double sample_time, double length, array_double_1d expected, array_double_2d work, array_double_2d table);
SEGFMU_API void segfmu_rope_range(double length, double shortest, double longest, array_double_1d found);
SEGFMU_API int64_t segfmu_table_lengths(double shortest, double longest, int64_t rows, array_double_1d lengths);
SEGFMU_API void segfmu_flat_table(array_double_1d plant, array_double_1d design, int64_t rows, array_double_1d lengths, array_double_3d table);
SEGFMU_API void segfmu_set_steps(array_double_1d sensors, double longest, array_double_1d uncertainty);
SEGFMU_API bool segfmu_observer_table(array_double_1d plant, double sample_time, array_double_1d uncertainty, int64_t rows, array_double_1d lengths, array_double_1d expected, array_double_2d work, array_double_3d table);
SEGFMU_API double segfmu_nominal_payload(double expected, double payload);
SEGFMU_API double segfmu_signal_age(double dead_time, double sampling, double period);
SEGFMU_API double segfmu_drive_bound(array_double_1d plant, int64_t axis, double sign);
SEGFMU_API void segfmu_set_walks(array_double_1d plant, array_double_1d uncertainty);
SEGFMU_API void segfmu_set_drives(array_double_1d plant, array_double_1d tracking);
SEGFMU_API void segfmu_set_tracking(array_double_1d plant, array_double_1d design, double longest, array_double_1d tracking);
SEGFMU_API void segfmu_set_fading(array_double_1d tracking);
SEGFMU_API int64_t segfmu_check_gains(array_double_1d plant, double period, int64_t predicted, array_double_1d ends, array_double_3d table, array_double_2d work, array_double_1d fault);
SEGFMU_API void segfmu_track_setpoint(array_double_1d parameters, array_double_3d table, array_double_3d gains, array_double_2d tick, array_double_2d memory);
SEGFMU_API void segfmu_crane_rhs(array_double_1d state, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative);
SEGFMU_API void segfmu_crane_driven(array_double_1d state, array_double_1d carriage, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative, array_double_1d force);
SEGFMU_API void segfmu_crane_flat_inverse(array_double_2d flat, array_double_1d masses, array_double_1d force, array_double_1d state, array_double_1d acceleration);
SEGFMU_API void segfmu_crane_load(array_double_1d state, array_double_2d load);
SEGFMU_API void segfmu_crane_energy(array_double_1d state, array_double_1d masses, array_double_1d energy);
SEGFMU_API void segfmu_crane_load_partials(array_double_1d state, array_double_2d partials);
SEGFMU_API void segfmu_crane_energy_partials(array_double_1d state, array_double_1d masses, array_double_2d partials);
SEGFMU_API void segfmu_flat_derivatives(array_double_2d flat, int64_t order, array_double_1d masses, array_double_2d work, array_double_1d found);
SEGFMU_API double segfmu_same_break(double time);
SEGFMU_API double segfmu_next_plan_event(double time, double start, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends, array_double_2d times);
SEGFMU_API double segfmu_right_of_break(double time, double start, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends);
SEGFMU_API bool segfmu_resists(array_double_1d resistance, int64_t axis);
SEGFMU_API double segfmu_planned_friction(array_double_1d resistance, int64_t axis, double time, double position, double velocity, array_double_2d contacts);
SEGFMU_API int64_t segfmu_contact_history(int64_t axis, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_2d work, array_double_2d contacts);
SEGFMU_API double segfmu_next_contact_event(double time, double start, array_double_2d contacts);
SEGFMU_API void segfmu_drive_demands(array_double_3d flat, array_double_1d times, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d demands);
SEGFMU_API int64_t segfmu_plant_failure(int64_t status, double time, array_double_1d state, array_double_1d plant, array_double_1d fault);
SEGFMU_API double segfmu_friction_derivative(array_double_1d resistance, int64_t axis, double time, array_double_1d motion, int64_t order, array_double_2d contacts, array_double_2d work);
SEGFMU_API void segfmu_begin_pace(array_double_1d pace);
SEGFMU_API bool segfmu_next_pace(double use, array_double_1d pace);
SEGFMU_API void segfmu_demand_peaks(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times);
SEGFMU_API double segfmu_next_uniform(array_double_1d numbers);
SEGFMU_API void segfmu_seed_numbers(int64_t seed, array_double_1d numbers);
SEGFMU_API void segfmu_noise_components(double bandwidth, array_double_1d deviation, array_double_1d numbers, array_double_2d components);
SEGFMU_API void segfmu_turbulence_components(double speed, double length, double bandwidth, array_double_1d deviation, array_double_1d numbers, array_double_2d components);
SEGFMU_API int64_t segfmu_plant_advance(array_double_1d plant, array_double_2d components, double time, array_double_1d state, double duration, double tolerance, array_double_2d work, array_double_1d report);
SEGFMU_API int64_t segfmu_bound_uses(array_double_2d peaks, array_double_2d times, array_double_1d bounds, array_double_1d uses, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_range(double value, double least, double most, array_double_1d fault);
SEGFMU_API double segfmu_begin_time(double given, double start);
SEGFMU_API int64_t segfmu_ramp_duration(double* result_0, double* result_1, double change, array_double_1d axis);
SEGFMU_API int64_t segfmu_ramp_pieces(array_double_1d axis);
SEGFMU_API void segfmu_axis_limits(int64_t smoothness, int64_t shape, array_double_1d limits, array_double_1d axis);
SEGFMU_API bool segfmu_ramp_parameters(double share, array_double_1d axis, array_double_2d work);
SEGFMU_API int64_t segfmu_measure_phases(double* result_0, double* result_1, double* result_2_0001, double* result_3, double* result_4, array_double_2d phases, int64_t count, double v, double within_0001, array_double_1d axis);
SEGFMU_API int64_t segfmu_shortest_profile(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
SEGFMU_API double segfmu_timed_profile(double target, array_double_1d axis, array_double_2d cell, array_double_2d work);
SEGFMU_API int64_t segfmu_plan_phases(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work);
SEGFMU_API int64_t segfmu_check_problem(array_double_3d states, array_double_2d limits, array_double_1d report);
SEGFMU_API double segfmu_motion_scale(int64_t order, array_double_3d states, array_double_2d limits);
SEGFMU_API int64_t segfmu_settle_states(int64_t first, array_double_3d states, array_double_2d limits, array_double_2d lower);
SEGFMU_API int64_t segfmu_settle_dwells(double sample_time, array_double_1d dwells);
SEGFMU_API void segfmu_measure_state(array_double_1d state, array_double_1d sensors, array_double_1d numbers, array_double_1d measured);
SEGFMU_API double segfmu_rig_next_event(array_double_2d settings, array_double_2d memory);
SEGFMU_API void segfmu_switch_correction(array_double_2d settings, array_double_2d memory);
SEGFMU_API void segfmu_rig_signals(array_double_2d settings, double time, array_double_2d memory);
SEGFMU_API void segfmu_rig_event(array_double_2d settings, array_double_2d changes, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_1d setpoints, double time, array_double_2d memory);
SEGFMU_API int64_t segfmu_rig_rates(array_double_2d components, array_double_1d setpoints, double time, array_double_2d memory, array_double_1d derivative);
SEGFMU_API int64_t segfmu_rig_rows(array_double_2d settings);
SEGFMU_API void segfmu_rig_start(array_double_2d settings, array_double_2d components, array_double_2d changes, array_double_1d state, array_double_1d setpoints, double start, array_double_2d memory);
SEGFMU_API int64_t segfmu_rig_step(array_double_2d settings, array_double_2d components, array_double_2d changes, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_1d setpoints, double duration, array_double_2d memory);
SEGFMU_API void segfmu_rig_balance(array_double_2d memory, array_double_1d balance);
SEGFMU_API double segfmu_rig_imbalance(array_double_1d balance);
SEGFMU_API void segfmu_rig_outputs(array_double_1d target, array_double_2d memory, array_double_1d balance, array_double_1d outputs);
SEGFMU_API void segfmu_tracking_estimates(array_double_1d parameters, array_double_2d tracker, array_double_1d estimates);
SEGFMU_API bool segfmu_rig_partials(array_double_2d components, double time, array_double_2d memory, array_double_2d work, array_double_2d partials);
SEGFMU_API int64_t segfmu_check_travel(array_double_1d least, array_double_1d greatest, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_lags(array_double_1d plant, int64_t exchange, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_friction(array_double_1d static_0001, array_double_1d coulomb, array_double_1d fault);
SEGFMU_API double segfmu_wind_speed(array_double_1d speed);
SEGFMU_API int64_t segfmu_check_turbulence(array_double_1d speed, array_double_1d deviation, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_slack(array_double_1d plant, int64_t exchange, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_delays(array_double_1d plant, double period, int64_t exchange, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_sensors(array_double_1d sensors, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_rope_bounds(double length, double shortest, double longest, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_lengths(array_double_1d lengths, array_double_1d fault);
SEGFMU_API void segfmu_start_state(array_double_1d own, array_double_1d held, array_double_1d reference, array_double_1d state);
SEGFMU_API int64_t segfmu_check_start(array_double_1d state, array_double_1d reference, array_double_1d fault);
SEGFMU_API int64_t segfmu_judge_start(array_double_1d state, array_double_1d reference, double gravity, array_double_1d fault);
SEGFMU_API int64_t segfmu_check_start_rope(double length, double shortest, double longest, array_double_1d fault);
SEGFMU_API int64_t segfmu_is_elsewhere(array_double_1d before, array_double_1d reference, double step);
SEGFMU_API int64_t segfmu_expand_phases(array_double_2d phases, int64_t count, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work);
SEGFMU_API int64_t segfmu_cut_plan(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d cut_timing, array_double_2d cut_coefficients, array_int64_t_1d cut_offsets);
SEGFMU_API void segfmu_meet_ends(double clock, double dwell, array_double_2d timing, array_int64_t_1d offsets);
SEGFMU_API void segfmu_anchor_plan(array_double_2d ends, array_double_2d limits, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets);
SEGFMU_API int64_t segfmu_join_plans(array_double_2d lead_timing, array_double_2d lead_coefficients, array_int64_t_1d lead_offsets, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d joined_timing, array_double_2d joined_coefficients, array_int64_t_1d joined_offsets);
SEGFMU_API int64_t segfmu_find_brake(bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
SEGFMU_API void segfmu_plan_ends(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d ends);
SEGFMU_API bool segfmu_are_at_velocities(array_double_2d targets, array_double_2d limits, array_double_2d ends);
SEGFMU_API int64_t segfmu_find_leads(array_double_3d states, array_double_2d limits, array_double_2d lower, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_2d ends, array_double_2d lead, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets);
SEGFMU_API bool segfmu_find_brakes(array_double_2d start, array_double_2d limits, array_double_2d lower, array_double_2d brakes, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
SEGFMU_API int64_t segfmu_count_pieces(array_double_2d axes, array_double_3d cells);
SEGFMU_API int64_t segfmu_expand_plan(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work);
SEGFMU_API int64_t segfmu_expand_motion(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work);
SEGFMU_API int64_t segfmu_plan_motion(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work);

#endif
