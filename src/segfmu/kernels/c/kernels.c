/* Generated from the kernels in Python by `python -m segfmu.codegen`; never edited. */
#include "kernels.h"

#include <math.h>

static int64_t row_range(double* result_0, double* result_1, array_double_2d span, int64_t row);
static int64_t load_meeting(array_double_2d span, array_double_1d box);
static bool is_beside(int64_t axis, double lowest, double highest, double top, array_double_2d span, array_double_1d box);
static int64_t turn_range(double* result_0, double* result_1, int64_t corner, array_double_2d span, array_double_1d box);
static int64_t count_edges(int64_t* result_0, int64_t* result_1, array_double_2d span, array_double_1d box);
static bool is_across(int64_t axis, double lowest, double highest, double top, array_double_2d span, array_double_1d box);
static double value_about(double share, int64_t row, array_double_2d span);
static double shared_height(double share, array_double_2d span, array_double_1d box);
static bool is_within(double height, array_double_2d span, array_double_1d box);
static int64_t rope_meeting(array_double_2d span, array_double_1d box);
static bool part_moves(int64_t part, array_double_2d span);
static void polynomial_differentiate(array_double_1d a, int64_t count, int64_t order, array_double_1d found);
static void polynomial_add_product(array_double_1d a, int64_t a_count, array_double_1d b, int64_t b_count, array_double_1d found);
static void polynomial_clear(array_double_1d found);
static void polynomial_shift(array_double_1d a, double offset, int64_t count);
static void rope_pull(double gravity, int64_t width, array_double_2d work);
static int64_t rope_margin(int64_t demand, double bound, int64_t width, array_double_2d work);
static double rope_value(int64_t demand, double gravity, double z, double w_x, double w_y, double w_z);
static int64_t find_piece(double time, array_double_2d timing, int64_t first, int64_t last);
static double evaluate_piece(array_double_2d coefficients, int64_t row, int64_t width, double t, int64_t derivative);
static double local_time(double time, array_double_2d timing, int64_t row);
static void evaluate_derivatives(array_double_2d coefficients, int64_t row, double t, int64_t axis, array_double_2d values);
static void evaluate_near(double time, array_double_1d near, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d values);
static void bernstein_coefficients(array_double_2d coefficients, int64_t row, int64_t count, double length, array_double_2d hull);
static double integrate_hull(int64_t count, double start, double length, array_double_1d values);
static void split_hull(array_double_2d hull, int64_t row, int64_t count);
static bool within(array_double_2d hull, int64_t count, double lowest, double highest);
static double least_peak(int64_t order, array_double_1d limits);
static double least_distance(array_double_1d limits);
static double reached_limit(int64_t order, double duration, array_double_1d limits);
static double rounding_error(int64_t order, array_double_1d limits);
static void keep_inside(array_double_2d work);
static void set_bounds(double middle, array_double_1d limits, array_double_1d lower, array_double_2d work);
static void note_ends(int64_t d, bool joined, double start, double end, double largest, array_double_2d work);
static bool check_piece(int64_t order, int64_t row, bool joined, double length, array_double_2d coefficients, double tolerance, array_double_2d work);
static bool check_axis(int64_t first, int64_t last, array_double_2d timing, array_double_2d coefficients, array_double_1d limits, array_double_1d lower, double tolerance, double joints, array_double_2d work);
static double switching_time(double time, double duration, array_double_2d timing, int64_t row);
static bool check_motion(int64_t axis, array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, double tolerance, double joints, array_double_2d work);
static int64_t check_plan(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, double tolerance, double joints, array_double_2d work);
static int64_t check_braked_plan(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, array_double_2d brakes, double tolerance, double joints, array_double_2d work);
static int64_t sum_range(double* result_0, double* result_1, int64_t axis, double share, double lean, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work);
static double least_depth(void);
static bool is_rope_easy(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work);
static double interval_end(double time, array_double_2d timing, array_int64_t_1d offsets);
static void interval_pieces(double time, double until, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work);
static double demand_bound(int64_t demand, array_double_1d bounds);
static int64_t rope_demand(int64_t demand, array_double_1d bounds, int64_t width, array_double_2d work);
static double first_negative(int64_t count, double length, array_double_2d work);
static double value_at(int64_t demand, double local, double gravity, int64_t width, array_double_2d work);
static double worst_value(int64_t demand, double first, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work);
static void write_row(int64_t source, int64_t count, double length, int64_t row, array_double_2d work, array_double_2d span);
static void begin_span(double time, double until, int64_t width, array_double_2d work, array_double_2d span);
static void write_span_pull(double gravity, array_double_2d work, array_double_2d span);
static void write_difference(int64_t first, int64_t pull, int64_t second, int64_t other, double length, int64_t row, array_double_2d work, array_double_2d span);
static void write_span_products(array_double_2d work, array_double_2d span);
static void halve_span(int64_t row, array_double_3d stack);
static int64_t part_meeting(int64_t part, array_double_2d span, array_double_1d box);
static void note_place(int64_t part, array_double_2d span, array_double_1d box, array_double_1d place);
static int64_t note_time(int64_t found, array_double_2d span, array_double_2d times);
static int64_t halved_contacts(int64_t part, int64_t found, array_double_1d box, array_double_3d stack, array_double_2d times, array_double_1d place);
static int64_t span_contacts(int64_t part, int64_t found, array_double_1d box, array_double_2d span, array_double_3d stack, array_double_2d times, array_double_1d place);
static void write_room(int64_t side, int64_t row, double local, double low, double high, array_double_2d coefficients, array_double_2d work);
static double greatest_lack(int64_t count, double length, double known, array_double_2d work);
static void begin_range(int64_t axis, double least, double most, array_double_2d ranges);
static void widen_range(int64_t row, int64_t axis, double least, double most, array_double_2d ranges);
static double lean_of(double pull, array_double_2d ranges);
static int64_t row_bounds(double* result_0, double* result_1, int64_t row, int64_t count, double length, array_double_2d work);
static void span_ranges(double length, int64_t width, array_double_2d work, array_double_2d ranges);
static bool is_near(int64_t part, array_double_1d box, array_double_2d ranges);
static bool is_any_near(int64_t part, array_double_2d boxes, array_double_2d ranges);
static double touch_distance(array_double_2d ranges);
static void shrink_box(double touch, int64_t low, int64_t high, array_double_1d box);
static void prolong_contact(int64_t part, array_double_2d boxes, array_double_3d stack, array_double_2d ranges, array_double_1d report);
static void note_first(int64_t part, array_double_2d boxes, array_double_3d stack, array_double_2d ranges, array_double_1d report);
static void write_faces(array_double_1d space, array_double_2d boxes);
static int64_t obstacle_count(array_double_1d space, array_double_2d obstacles);
static int64_t check_space(array_double_1d space, array_double_2d obstacles, array_double_1d fault);
static double series_factorial(int64_t order);
static void series_of_derivatives(array_double_2d values, int64_t first, int64_t column, int64_t count, array_double_1d found);
static double series_derivative(array_double_1d a, int64_t order);
static void series_sum(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found);
static void series_difference(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found);
static void series_negative(array_double_1d a, int64_t count, array_double_1d found);
static void series_product(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found);
static void series_quotient(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found);
static void series_root(array_double_1d a, int64_t count, array_double_1d found);
static void series_exponential(array_double_1d a, int64_t count, array_double_1d found);
static void series_angle(array_double_1d y, array_double_1d x, array_double_1d square, int64_t count, array_double_1d scratch, array_double_1d found);
static void suspension_derivatives(int64_t order, array_double_1d masses, array_double_2d work, array_double_1d force, array_double_1d state, array_double_1d acceleration);
static void write_links(array_double_2d flat, int64_t count, double gravity, array_double_2d work);
static void climb_sling(int64_t count, double share, double sling, double gravity, array_double_2d work);
static void write_sling(array_double_2d flat, int64_t count, array_double_1d masses, double hook_mass, double sling, array_double_2d work);
static void hook_rhs(array_double_1d state, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative, array_double_1d tension);
static void hook_driven(array_double_1d state, array_double_1d carriage, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative, array_double_1d force, array_double_1d tension);
static void hook_load(array_double_1d state, array_double_1d masses, array_double_2d load);
static void hook_energy(array_double_1d state, array_double_1d masses, array_double_1d energy);
static void gather_hook(array_double_1d plant, array_double_1d state, array_double_2d work);
static void scatter_hook(array_double_2d work, array_double_1d derivative);
static void hooked_rhs(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void hooked_driven(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void hooked_load(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_2d load);
static void hooked_energy(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d energy);
static double hooked_mass(array_double_1d plant, array_double_1d state);
static bool has_tackle(array_double_1d resistance);
static void suspended_rhs(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void suspended_driven(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void suspended_load(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_2d load);
static void suspended_energy(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d energy);
static double suspended_mass(array_double_1d plant, array_double_1d state);
static void crane_inverse(array_double_2d flat, array_double_1d resistance, array_double_2d series, array_double_1d force, array_double_1d state, array_double_1d acceleration);
static double side_bound(double sign, double greatest, double least);
static bool exceeds(double value, double bound);
static double limited(double value, double bound);
static double velocity_bound(array_double_1d plant, int64_t axis, double sign);
static double acceleration_bound(array_double_1d plant, int64_t axis, double sign);
static double static_bound(array_double_1d plant, int64_t axis, double sign);
static double force_bound(array_double_1d plant, int64_t axis, double sign, double velocity);
static void rope_direction(array_double_1d plant, array_double_1d state, array_double_1d limit);
static double carriage_mass(array_double_1d masses, int64_t axis);
static double available_force(int64_t axis, double side, array_double_1d limit);
static double limit_side(array_double_1d plant, int64_t axis, array_double_1d action, array_double_1d limit);
static double missing_force(int64_t axis, array_double_1d action, array_double_1d limit);
static void change_accelerations(array_double_1d plant, array_double_1d action, array_double_1d limit);
static void limit_accelerations(array_double_1d plant, array_double_1d state, array_double_1d action, array_double_1d acceleration, array_double_1d limit);
static double hanging_mass(array_double_1d resistance);
static bool at_velocity_bound(array_double_1d plant, int64_t axis, array_double_1d state);
static double held_side(int64_t axis, array_double_1d state, array_double_1d derivative, array_double_1d limit);
static void hold_accelerations(array_double_1d plant, array_double_1d derivative, array_double_1d limit);
static void hold_velocities(array_double_1d plant, array_double_1d state, array_double_1d derivative, array_double_1d action, array_double_1d limit);
static int64_t table_row(double length, array_double_3d table);
static double table_share(double length, array_double_3d table, int64_t row);
static void lead_gains(int64_t axis, double lag, double length, double gravity, array_double_1d gains);
static double return_effort(void);
static double return_speed(void);
static double held_within(double value, double least, double greatest);
static double scheduled_gain(double length, int64_t axis, int64_t column, array_double_3d gains);
static double top_speed(int64_t axis, double sign, array_double_1d parameters, array_double_1d situation);
static double power_bound(int64_t axis, array_double_1d parameters, array_double_1d situation);
static double least_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation);
static double greatest_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation);
static void bound_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation);
static double return_room(int64_t axis, array_double_1d parameters, array_double_3d gains, array_double_1d situation);
static void bound_return(int64_t axis, array_double_1d parameters, array_double_3d gains, array_double_2d tick, array_double_1d situation);
static void observer_input(int64_t axis, double length, array_double_3d table, double period, double correction, array_double_1d change);
static void observer_bend(int64_t axis, double length, array_double_3d table, double factor, array_double_1d change, array_double_1d estimate);
static int64_t remembered_ticks(array_double_1d parameters);
static void remember_tick(array_double_1d parameters, array_double_1d reference, array_double_2d memory);
static void remember_start(array_double_1d reference, array_double_2d memory);
static void aged_reference(array_double_1d parameters, array_double_2d memory);
static void advance_axis(int64_t axis, int64_t back, double share, array_double_1d parameters, double length, array_double_3d table, array_double_2d memory, array_double_1d estimate);
static void advance_estimates(array_double_1d parameters, double length, array_double_3d table, array_double_2d memory);
static void predict_share(int64_t axis, double share, array_double_1d parameters, double length, array_double_3d table, array_double_2d memory);
static void predict_present(array_double_1d parameters, double length, array_double_3d table, array_double_2d memory);
static void matrix_set(int64_t n, double value, array_double_2d a);
static void matrix_copy(int64_t n, array_double_2d a, array_double_2d c);
static void matrix_add(int64_t n, double factor, array_double_2d a, array_double_2d c);
static void matrix_product(int64_t n, array_double_2d a, array_double_2d b, array_double_2d c);
static void matrix_product_transposed(int64_t n, array_double_2d a, array_double_2d b, array_double_2d c);
static void matrix_transpose(int64_t n, array_double_2d a, array_double_2d c);
static void matrix_reduce(int64_t n, int64_t columns, int64_t pivot, array_double_2d a, array_double_2d b);
static void matrix_solve(int64_t n, int64_t columns, array_double_2d a, array_double_2d b);
static int64_t halvings_below(int64_t n, double time, array_double_2d a);
static void matrix_exponential(int64_t n, double part, array_double_2d a, array_double_2d c, array_double_2d term, array_double_2d product);
static void kalman_model(int64_t axis, array_double_1d plant, double length, array_double_2d model);
static void kalman_series(double part, double drift, double wind, array_double_2d model, array_double_2d transition, array_double_2d covariance, array_double_2d work);
static void kalman_sampled(double sample_time, double drift, double wind, array_double_2d model, array_double_2d transition, array_double_2d covariance, array_double_2d work);
static double kalman_turn(int64_t n, array_double_2d spread, array_double_2d work);
static void kalman_gain(int64_t axis, double first, double second, array_double_2d spread, array_double_2d table);
static void kalman_axis(int64_t axis, double sample_time, array_double_1d expected, array_double_2d work, array_double_2d table);
static double largest_angle(void);
static double largest_hoist_angle(void);
static double acts_late(array_double_1d plant, array_double_1d design);
static void design_flat_gains(array_double_1d plant, array_double_1d design, double length, array_double_2d gains);
static double sensor_step(array_double_1d sensors, int64_t signal);
static void expect_errors(array_double_1d uncertainty, double gravity, double length, double sample_time, array_double_1d expected);
static void offset_filter(bool first, double share, array_double_1d signals, array_double_2d states);
static void offset_signals(array_double_1d measured, double start, array_double_1d signals);
static double second_difference(int64_t signal, array_double_2d states);
static int64_t offset_residual(double* result_0_0001, double* result_1_0001, int64_t axis, double gravity, double square, array_double_2d states);
static int64_t offset_noise(double* result_0, double* result_1_0001, array_double_1d parameters, double length);
static void offset_centre(int64_t axis, double share, array_double_1d values, array_double_1d means);
static void offset_sum(double keep, array_double_1d values, array_double_1d sums);
static void offset_decide(array_double_1d parameters, double length, double noise, array_double_1d sums, array_double_1d estimate);
static void offset_equations(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory);
static double offset_estimate(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory);
static double weak_drive(void);
static double drive_strength(array_double_1d plant, int64_t axis);
static void set_noise(array_double_1d uncertainty, double gravity, double longest, array_double_1d tracking);
static double spectral_radius(int64_t n, double enough, array_double_2d a, array_double_2d square);
static void sampled_transition(double sample_time, array_double_2d model, array_double_2d transition, array_double_2d work);
static bool is_state(int64_t axis, bool lagging, int64_t place);
static void axis_gains(int64_t axis, array_double_1d plant, double length, array_double_3d table, array_double_1d gains);
static int64_t close_loop(int64_t axis, bool lagging, double delay, array_double_1d gains, array_double_2d work);
static void track_wake(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory);
static void track_offset(array_double_1d parameters, array_double_2d tick, array_double_2d memory);
static void track_start(array_double_1d measured, array_double_1d reference, array_double_2d memory);
static void track_observe(array_double_1d parameters, array_double_3d table, array_double_2d memory);
static bool track_acts(array_double_1d parameters, array_double_2d memory);
static void track_deviation(array_double_1d parameters, array_double_2d memory);
static void track_situation(array_double_1d parameters, array_double_2d tick, array_double_2d memory);
static void track_forces(array_double_1d parameters, array_double_2d memory, array_double_1d correction);
static void track_law(array_double_1d parameters, array_double_3d gains, array_double_2d tick, array_double_2d memory);
static void track_hoist(array_double_1d parameters, array_double_2d memory);
static void crane_rhs_partials(array_double_1d state, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_2d partials);
static void crane_driven_partials(array_double_1d state, array_double_1d carriage, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_2d partials);
static double compression(array_double_1d plant, int64_t axis, double position);
static double buffer_force(array_double_1d plant, int64_t axis, double position, double velocity);
static int64_t buffer_slopes(double* result_0_0001, double* result_1_0001, array_double_1d plant, int64_t axis, double position, double velocity);
static double dry_level(array_double_1d resistance, int64_t axis, double velocity);
static double level_slope(array_double_1d resistance, int64_t axis, double velocity);
static bool rubs(array_double_1d resistance, int64_t axis);
static double deflected(array_double_1d resistance, double deflection);
static double contact_damping(array_double_1d resistance, int64_t axis);
static double dry_friction(array_double_1d resistance, int64_t axis, double level, double velocity, double deflection);
static double smooth_friction(array_double_1d resistance, int64_t axis, double velocity);
static double friction_force(array_double_1d resistance, int64_t axis, double velocity, double deflection);
static int64_t friction_slopes(double* result_0, double* result_1_0001, array_double_1d resistance, int64_t axis, double velocity, double deflection);
static double deflection_rate(array_double_1d resistance, int64_t axis, double velocity, double deflection);
static double first_deflection(array_double_1d resistance, int64_t axis, double velocity);
static double next_break(double time, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends);
static double release_time(array_double_1d resistance, int64_t axis);
static int64_t axis_motion(double* result_0, double* result_1, double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work);
static int64_t find_contact(double time, array_double_2d contacts);
static double planned_deflection(array_double_1d resistance, double time, double position, array_double_2d contacts, int64_t row);
static double release_rate(double time, array_double_2d contacts, int64_t row);
static bool stops(double time, array_double_2d contacts, int64_t row);
static double stillness(array_double_2d work);
static bool at_rest(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work);
static void add_contact(double time, bool rests, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts);
static double turning_point(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work);
static void add_turns(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts);
static void follow_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts);
static double sliding_time(int64_t row, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts);
static double fading_time(double time, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work);
static void settle_contact(int64_t row, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts);
static double contact_node(double time, double begin, double end);
static void motion_demand(array_double_2d flat, double time, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_1d demand);
static bool may_slacken(array_double_1d plant);
static bool is_slack(array_double_1d state);
static double axis_position(array_double_1d state, int64_t axis);
static double axis_velocity(array_double_1d state, int64_t axis);
static bool bears_wrongly(array_double_1d plant, array_double_1d state, double rope_force);
static void change_rope(array_double_1d plant, array_double_1d state);
static void run_on(array_double_1d plant, array_double_2d work);
static void forced_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void slack_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void driven_forces(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void driven_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void widest_angle(int64_t sway, double angle, array_double_1d fault);
static void share_series(array_double_1d resistance, double time, array_double_1d motion, int64_t order, array_double_2d contacts, array_double_2d work);
static void level_series(array_double_1d resistance, int64_t axis, int64_t count, array_double_2d work);
static void add_dry_series(array_double_1d resistance, int64_t axis, int64_t count, array_double_2d work);
static double no_stop(void);
static bool is_place(int64_t i);
static double end_stop(int64_t i, int64_t side, array_double_1d bounds);
static double travel_span(int64_t i, int64_t side, array_double_1d bounds);
static double travel_origin(int64_t i, int64_t side, array_double_1d bounds);
static double clear_peaks(array_double_1d ends, array_double_2d work, array_double_2d peaks, array_double_2d times);
static void write_transform(array_double_2d work);
static void demand_at(double time, int64_t row, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work);
static void note_value(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times);
static double sooner(double time, double after, double following);
static double next_joint(double time, double duration, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends, array_double_3d contacts);
static void share_scale(array_double_2d work);
static void sample_demands(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work);
static bool is_resolved(int64_t depth, array_double_2d work);
static double series_value(int64_t i, double place, array_double_2d work);
static double peak_place(int64_t i, double sign, array_double_2d work);
static void note_peaks(double start, double length, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times);
static void search_interval(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times);
static double full_circle(void);
static double next_normal(array_double_1d numbers);
static double gust_factor(double shape, double share);
static double gust_rate(double shape, double share);
static double command_slope(int64_t i, double elapsed, array_double_1d rate);
static void add_sinusoid(array_double_1d component, double sine, double cosine, array_double_1d total);
static double drag_factor(array_double_1d plant);
static double relative_speed(array_double_1d air);
static void add_drag(array_double_1d plant, array_double_1d state, array_double_2d work);
static void wind_force(array_double_1d plant, array_double_2d components, double start, double elapsed, array_double_1d state, array_double_2d work);
static double drag_slope(array_double_1d plant, array_double_1d air, int64_t i, int64_t j);
static void add_rate(array_double_1d component, double time, int64_t first, array_double_1d total);
static void wind_rates(array_double_1d plant, array_double_2d components, double time, array_double_1d air);
static double stage_node(int64_t stage);
static double stage_state(int64_t stage, double h, int64_t count, array_double_1d state, array_double_2d k, array_double_1d trial);
static double step_error(double h, int64_t count, array_double_1d start, array_double_1d end, array_double_2d k);
static double next_step(double error, double tolerance);
static bool all_finite(array_double_1d values, int64_t count);
static void plant_powers(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void plant_derivative(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, array_double_2d work, array_double_1d derivative);
static int64_t changing_components(array_double_1d plant);
static void reuse_last_stage(array_double_1d plant, array_double_2d work);
static void first_stage(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, array_double_2d work);
static double try_step(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, double h, array_double_2d work);
static int64_t plant_status(array_double_1d plant, array_double_1d state, array_double_1d action);
static void accept_step(array_double_1d plant, array_double_1d state, array_double_2d work, double elapsed, array_double_1d report);
static bool has_own_bound(int64_t i, int64_t side, array_double_1d bounds);
static double bound_magnitude(int64_t i, int64_t side, array_double_1d bounds);
static double bound_origin(int64_t i, int64_t side, array_double_1d bounds);
static void write_fault(int64_t i, int64_t side, double peak, double time, array_double_1d bounds, array_double_1d fault);
static double hook_unit(int64_t axis, array_double_1d plant);
static double hook_lag(int64_t axis, array_double_1d plant);
static void hook_model(int64_t axis, array_double_1d plant, double length, array_double_2d model);
static void hook_moved(double sample_time, array_double_2d work);
static void hook_steady(array_double_2d work);
static void hook_gains(int64_t axis, array_double_1d plant, double length, array_double_1d weights, array_double_2d work, array_double_1d gains);
static void hook_watch(int64_t axis, array_double_1d plant, double sample_time, double length, array_double_1d weights, array_double_2d work, array_double_2d table);
static int64_t hook_row(int64_t* result_0, double* result_1_0001, double length, array_double_3d table);
static double hook_entry(int64_t row, double share, int64_t i, int64_t j, array_double_3d table);
static double hook_axis(int64_t axis, int64_t row, double share, array_double_3d table, double seen, double tilted, array_double_1d estimate, array_double_1d work);
static double hook_kept(int64_t axis, double velocity, double planned, double wanted, array_double_1d limits);
static void write_direction(array_double_1d state, int64_t angle, int64_t rate, int64_t row, array_double_2d work);
static void write_margins(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d masses, double hook_mass, double sling, array_double_1d bounds, array_double_2d work);
static bool is_dip(array_double_2d work);
static void look_around(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d masses, double hook_mass, double sling, array_double_1d bounds, array_double_2d work);
static int64_t judge_margins(array_double_1d bounds, array_double_2d work, array_double_1d report);
static double direction_of(array_double_2d places, double least);
static int64_t state_of(int64_t place, int64_t order, int64_t axis, array_double_1d heading);
static double heading_sign(int64_t order, int64_t axis, array_double_1d heading);
static double pace_between(double use, array_double_1d pace);
static bool is_free(double state);
static bool may_be_same(array_double_2d one, array_double_2d other);
static void take_states(bool every, array_double_2d given, array_double_2d found);
static bool is_passed(int64_t point, int64_t axis, array_double_3d states, array_double_1d place, array_double_1d dwells);
static double without_digits(double value);
static void write_paced(array_double_2d search);
static void enter_paces(double wanted, array_double_2d search);
static double log_of(double duration);
static double largest_share(array_double_1d uses);
static void write_values(double duration, array_double_1d uses, array_double_1d row);
static void note_best(array_double_2d search);
static bool is_hopeless(double duration, array_double_2d search);
static bool next_of_paces(double duration, array_double_1d uses, array_double_2d search, array_double_2d values);
static bool has_states(array_double_2d search);
static double merit_of(double duration, array_double_1d uses);
static bool enter_poll(array_double_2d search);
static double poll_change(int64_t way);
static bool next_poll(double duration, array_double_1d uses, array_double_2d search);
static bool leave_poll(array_double_2d search);
static double change_of(array_double_2d search);
static bool write_changed(array_double_2d search);
static bool enter_slopes(array_double_2d search);
static bool next_slope(double duration, array_double_1d uses, array_double_2d search, array_double_2d values, array_double_2d slopes);
static void correct_slopes(array_double_2d search, array_double_2d values, array_double_2d slopes);
static void add_bound(int64_t n, int64_t row, array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton);
static double damped_step(int64_t n, double radius, double weight, array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton);
static void write_step(array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton);
static void enter_start(array_double_2d starts, array_double_2d search);
static double worth_while(void);
static bool enter_descent(array_double_2d search);
static bool leave_round(array_double_2d search);
static bool enter_step(array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton);
static void note_start(array_double_2d search);
static void enter_centre(array_double_2d search, array_double_2d values);
static bool enter_round(array_double_2d search, array_double_2d values);
static double least_radius(array_double_2d search);
static bool judge_step(array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton);
static void write_motion_of(int64_t axis, array_double_2d positions, array_double_2d velocities, array_double_2d accelerations, array_double_1d row);
static void write_farthest(int64_t axis, array_double_2d positions, array_double_1d resistance, array_double_1d row);
static bool differs(int64_t i, array_double_1d bounds);
static void write_directions(int64_t axis, array_double_1d bounds, array_double_1d row);
static bool is_braked_by_friction(int64_t axis, array_double_1d bounds, array_double_1d row);
static void write_floors(int64_t axis, array_double_2d velocities, array_double_2d accelerations, array_double_1d row);
static double held_force(int64_t side, array_double_1d row);
static int64_t check_pace_of(int64_t axis, array_double_1d bounds, array_double_2d axes, array_double_1d fault);
static double least_of(double limit, double bound);
static double rigid_mass(int64_t axis, array_double_1d resistance);
static int64_t rigid_limits(double* result_0, double* result_1, int64_t axis, int64_t way, array_double_1d bounds, array_double_1d resistance, array_double_1d row);
static double of_the_way(double ahead, double back, int64_t axis, array_double_1d row);
static int64_t write_axis_starts(int64_t axis, double swing, array_double_1d bounds, array_double_1d resistance, array_double_2d axes, array_double_2d starts);
static double mean_velocity(int64_t point, int64_t axis, array_double_2d positions, array_double_2d axes, array_double_1d start);
static double root_share(double newest, double other, double before, double e_newest, double e_other, double e_before);
static double next_point(double newest, double other, double before, double e_newest, double e_other, double e_before);
static int64_t next_bracket(double* result_0_0001, double* result_1_0001, double* result_2_0001, double* result_3_0001, double* result_4_0001, double* result_5_0001, bool crossed, double point, double error, double newest, double other, double e_newest, double e_other);
static double least_scale(void);
static bool has_tripped(array_double_1d command);
static int64_t wanted_mode(array_double_1d command);
static double push_of(double velocity);
static double standstill(int64_t slot, int64_t axis, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static double stop_towards(int64_t side, int64_t axis, array_double_2d known);
static double end_rounding_of(double end);
static double low_end(int64_t axis, array_double_2d known);
static double high_end(int64_t axis, array_double_2d known);
static void write_push(double scale, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static double limited_velocity(double velocity, double scale, double limit, double lower);
static void write_target(double scale, array_double_1d aim, array_double_1d command);
static void write_wish(int64_t mode, double scale, array_double_1d aim, array_double_1d command, array_double_2d limits, array_double_2d known);
static void write_aim(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool is_aim(int64_t row, array_double_2d operation);
static bool is_slower(int64_t attempt);
static double ease_of(int64_t attempt, int64_t place, array_double_2d operation);
static void note_ease(int64_t attempt, double pace, double steepness, double speed, array_double_2d operation);
static void stop_as_before(array_double_2d operation);
static double share_of(int64_t attempt, int64_t axis, array_double_2d operation);
static bool is_worth(int64_t attempt, int64_t failed, array_double_1d aim);
static void set_lower_of(int64_t place, array_double_2d operation, array_double_3d limits, array_double_2d known);
static void set_attempt(int64_t attempt, array_double_2d operation, array_double_3d limits, array_double_2d known);
static int64_t most_newton(void);
static double control_bound(int64_t demand, double sense, double share, double fallback, array_double_2d known);
static double most_change(int64_t axis, double sense, double share, double interval, array_double_2d known);
static double most_speed(int64_t axis, double sense, double share, double interval, array_double_2d known, array_double_2d work);
static void decline_line(int64_t axis, array_double_2d work);
static bool is_inside_bounds(int64_t axis, double share, double interval, array_double_2d known, array_double_2d work);
static void write_conditions(double interval, array_double_2d work);
static double swing_left(int64_t j, double aim, int64_t axis, array_double_2d work);
static double place_left(double aim, int64_t axis, double interval, array_double_2d work);
static void write_barrier(int64_t axis, double share, double interval, array_double_2d known, array_double_2d work);
static void solve_barrier(int64_t first, int64_t last, array_double_2d work);
static double join_changes(int64_t first, int64_t last, array_double_2d work);
static double way_to_bounds(int64_t axis, double share, double interval, array_double_2d known, array_double_2d work);
static bool find_centre(int64_t axis, double share, double interval, int64_t first, int64_t last, array_double_1d aims, array_double_2d known, array_double_2d work);
static double inner_rise(double rise, int64_t level, array_double_1d axis);
static double shifted_root(double value, int64_t power, double shift);
static int64_t plateau_duration(double* result_0_0001, double* result_1_0001, double change, int64_t first, array_double_1d axis);
static int64_t plateau_change(double* result_0, double* result_1_0001, double duration, int64_t first, array_double_1d axis);
static int64_t slowest_root(double* result_0, double* result_1_0001, double change, array_double_1d axis);
static int64_t fastest_power(double* result_0, double* result_1_0001, double duration, array_double_1d axis);
static int64_t ramp_change(double* result_0, double* result_1, double duration, array_double_1d axis);
static int64_t rise_moments(double* result_0_0001, double* result_1_0001, double duration, int64_t first, array_double_1d axis);
static double ramp_variance(double basis, array_double_1d axis);
static double ramp_distance(double v, double a, double b, double duration, double basis, array_double_1d axis);
static int64_t rise_pieces(int64_t boxes);
static int64_t held_level(int64_t* result_0, double* result_1, int64_t piece, int64_t boxes);
static int64_t held_peak(double* result_0_0001, double* result_1_0001, double* result_2, int64_t level, int64_t first, double rise, double peak, double stretch, array_double_1d axis);
static int64_t piece_peak(double* result_0, double* result_1, int64_t level, int64_t first, double change, double duration, double basis, array_double_1d axis);
static void transition_coefficients(int64_t order, array_double_1d coefficients);
static double polynomial_derivative(array_double_1d coefficients, int64_t count, int64_t times, double s);
static void transition_peaks(int64_t order, array_double_1d coefficients, array_double_1d peaks);
static int64_t append_piece(double duration, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_1d state);
static void clear_piece(array_double_2d coefficients, int64_t row);
static void set_held(int64_t above, double level, array_double_1d state);
static int64_t expand_plateau(array_double_1d phase, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work);
static bool is_unnoticed(array_double_1d phase, double time, array_double_1d axis);
static double end_derivative(int64_t row, int64_t last, int64_t order, array_double_2d timing, array_double_2d coefficients);
static void cut_piece(int64_t row, int64_t last, double local, array_double_2d timing, array_double_2d coefficients, array_double_2d cut_coefficients, int64_t target);
static void settle_end(bool moves, int64_t first, int64_t last, array_double_2d coefficients, array_double_2d cut_coefficients, int64_t target);
static void copy_piece(array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d target_timing, array_double_2d target_coefficients, int64_t target);
static void add_power(double value, int64_t order, double before, array_double_2d coefficients, int64_t row);
static double length_term(int64_t order, array_double_1d swing);
static void write_square(array_double_1d swing, array_double_1d square);
static double suspension_pull(int64_t axis, int64_t order, double gravity, array_double_1d swing);
static void expand_swing(double gravity, array_double_1d swing, array_double_2d work);
static void tighten_rope(array_double_1d swing);
static void move_swing(double step, array_double_1d swing, array_double_2d work);
static double swing_step(double longest, array_double_1d swing);
static double resolved_step(double gravity, array_double_1d swing);
static double stand_time(array_double_1d swing);
static double sway_amplitude(double gravity, array_double_1d swing);
static void advance_swing(double duration, double gravity, array_double_1d swing, array_double_2d work);
static void write_swing_piece(int64_t axis, int64_t row, double before, array_double_1d swing, array_double_3d coefficients, array_double_2d work);
static void gather_axes(int64_t rows, int64_t count, int64_t slot, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static void write_swing(double least, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static double swing_frequency(double gravity, array_double_1d swing);
static void set_control_start(double interval, array_double_1d swing, array_double_2d work);
static void set_knot(int64_t k, double interval, array_double_1d ahead, array_double_2d control);
static void begin_controlled(array_double_2d operation);
static int64_t interval_parts(double longest, double interval, array_double_2d operation, double gravity, array_double_2d work);
static void add_moments(int64_t knot, double since, double step, double interval, array_double_1d moment, array_double_1d free, array_double_1d pull);
static double run_controlled(double interval, array_double_2d operation, array_double_2d known, array_double_2d work);
static bool fits_plan(double interval, array_double_2d operation, array_double_2d known, array_double_2d work);
static void write_controlled(double interval, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static void set_range(double centre, double radius, array_double_1d found);
static void add_range(double share, array_double_1d a, array_double_1d found);
static void add_range_product(double share, array_double_1d a, array_double_1d b, array_double_1d found);
static void divide_range(array_double_1d a, array_double_1d b, array_double_1d found);
static void write_derivative(int64_t order, int64_t width, double radius, array_double_1d piece, array_double_1d found);
static void write_load(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work);
static void write_slope(int64_t axis, array_double_2d reach);
static void write_stretch(array_double_2d reach);
static void write_drive(int64_t drive, double ahead, array_double_1d factor, array_double_1d rate, array_double_1d change, array_double_2d reach);
static void add_resistance(int64_t drive, array_double_1d crane, array_double_2d reach);
static void write_forces(array_double_1d crane, array_double_2d reach);
static void lead_velocities(array_double_1d crane, array_double_2d reach);
static void write_sway(array_double_2d reach);
static bool write_demands(array_double_1d crane, array_double_2d work);
static bool write_reach(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d crane, array_double_2d work);
static int64_t judge_reach(int64_t first, int64_t last, array_double_1d bounds, array_double_2d work);
static bool keeps_between(int64_t first, int64_t last, double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work);
static bool keeps_demands(int64_t first, int64_t last, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work);
static int64_t plan_pieces(int64_t slot, array_int64_t_1d offsets);
static double plan_end(int64_t slot, int64_t axis, array_double_3d timing, array_int64_t_1d offsets);
static void copy_plan(int64_t source, int64_t target, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool has_room(int64_t slot, array_int64_t_1d offsets);
static void clear_plan(int64_t slot, array_int64_t_1d offsets);
static void note_present(double elapsed, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool keeps_limits(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work);
static int64_t prove_crane(int64_t demands, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack);
static int64_t prove_plan(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work, array_double_3d stack);
static double used_share(void);
static bool brake_hoist(double share, double interval, array_double_2d known, array_double_2d work);
static void set_way(int64_t axis, array_double_2d operation, array_double_2d work);
static int64_t most_runs(void);
static bool calms_within(double duration, double share, array_double_2d operation, array_double_2d known, array_double_2d work);
static double least_time(double share, array_double_2d operation, array_double_2d known, array_double_2d work);
static int64_t most_growths(void);
static double seek_calm(double share, array_double_2d operation, array_double_2d known, array_double_2d work);
static int64_t plan_calm(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack);
static void invert_flat(array_double_2d known, array_double_2d work);
static void note_swing(array_double_2d operation, array_double_2d known, array_double_2d work);
static void note_trips(array_double_2d operation);
static double brake_of(int64_t drive, int64_t side, double share, array_double_1d swing, array_double_2d known);
static double least_brake(int64_t drive, array_double_1d swing, array_double_2d known);
static void set_brakes(double share, array_double_1d swing, array_double_2d known);
static bool is_inside(double value, int64_t demand, array_double_2d known);
static bool is_bearable(array_double_1d swing, array_double_2d known, array_double_2d work);
static bool brakes_with(double share, array_double_2d operation, array_double_2d known, array_double_2d work);
static bool plan_brakes(array_double_2d operation, array_double_2d known, array_double_2d work);
static bool plan_emergency(array_double_2d operation, array_double_2d known, array_double_2d work);
static double covered_time(array_double_2d operation);
static void cover_swing(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static bool begin_emergency(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static bool prolong_swing(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static double way_left(double velocity, double rest, array_double_1d way);
static double room_left(int64_t axis, array_double_2d operation);
static void hold_shares(array_double_2d operation);
static void shift_row(int64_t row, double later, double way, array_double_3d timing, array_double_3d coefficients);
static bool join_held(array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool holds_long_enough(double elapsed, array_double_2d operation);
static bool prolong_holds(double elapsed, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool is_calming(array_double_2d operation);
static bool aims_elsewhere(array_double_2d operation);
static void note_calming(array_double_2d operation);
static double next_calm(array_double_2d operation);
static bool wants_calm(array_double_2d operation);
static void write_calm_aim(array_double_2d operation);
static void follow_calm(array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static bool try_calm(bool rests, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack);
static void take_over(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack);
static void put_aside(array_double_2d operation);
static void note_calm_state(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static void bring_back(array_double_2d operation);
static bool calm_on(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack);
static bool is_hanging(array_double_1d command);
static int64_t state_status(array_double_1d command);
static void write_measured(array_double_2d operation, array_double_2d known, array_double_2d work);
static bool takes_measured(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack);
static bool keeps_at(double pace, double speed, double steepness, double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work);
static double pace_within(double speed, double steepness, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work);
static int64_t ease_within(double* result_0, double* result_1, double* result_2, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work);
static int64_t level_gain(double* result_0, double* result_1_0001, double level, double a, double b, array_double_1d axis);
static double linear_level(double gain, double a, double b, array_double_1d axis);
static int64_t root_level(double* result_0_0001, double* result_1, double gain, double a, double b, double lower, double upper, double start, array_double_1d axis);
static int64_t solve_level(double* result_0_0001, double* result_1_0001, double* result_2_0001, double gain, double a, double b, double low, double high, double near, array_double_1d axis);
static int64_t member_distance(double* result_0_0001, double* result_1, array_double_1d family, array_double_1d axis);
static int64_t second_level(double* result_0, double* result_1, double* result_2, double* result_3, double p, array_double_1d family, array_double_1d axis);
static bool has_member(double p, array_double_1d family, array_double_1d axis);
static int64_t canonical_member(double* result_0, double* result_1, double p, array_double_1d family, array_double_1d axis);
static int64_t curved_part(double* result_0, double* result_1, double* result_2_0001, double s, array_double_1d axis);
static double invert_curved_part(double value, double upper, array_double_1d axis);
static double extreme_gain(double a, double b, double duration, double basis, array_double_1d axis);
static double taylor(double t, double first, double second, double third, double fourth, double fifth);
static double crossing_time(double a, double length, double jerk, double snap, double crackle, double pop, double highest);
static double plateau_extreme_velocity(double v, double a, double change, double duration, double basis, array_double_1d axis);
static double ramp_extreme_velocity(double v, double a, double b, double duration, double basis, array_double_1d axis);
static double side_limit(int64_t order, double sign, array_double_1d axis);
static double own_side(int64_t order, double sign, array_double_1d axis);
static void set_lower(array_double_1d lower, array_double_1d axis);
static double fastest_velocity(array_double_1d axis);
static double slowest_velocity(array_double_1d axis);
static double top_acceleration(array_double_1d axis);
static bool is_beyond(double low, double high, double share, array_double_1d axis);
static void exchange_sides(int64_t order, array_double_1d axis);
static void reverse_axis(array_double_1d axis);
static void mirror_axis(array_double_1d axis);
static double flush_tiny(double value, double scale);
static double boundary_value(double value, double lower, double upper);
static int64_t append_phase(array_double_2d phases, int64_t count, double duration, double basis, double start, double change, double above);
static int64_t append_ramp(array_double_2d phases, int64_t count, double a, double b, double duration, array_double_1d axis);
static int64_t append_change(array_double_2d phases, int64_t count, double a, double b, array_double_1d axis);
static int64_t append_hold(array_double_2d phases, int64_t count, double a, double duration);
static int64_t insert_hold(array_double_2d phases, int64_t count, int64_t row, double a, double duration);
static void copy_phases(array_double_2d source, array_double_2d target, int64_t count);
static int64_t join_phases(array_double_2d source, int64_t count, array_double_2d phases, int64_t used);
static void mirror_phases(array_double_2d phases, int64_t count);
static void reverse_phases(array_double_2d phases, int64_t first, int64_t count);
static void boundary_problem(array_double_1d problem, array_double_1d axis, array_double_1d cleaned);
static double steepest_acceleration(double duration, array_double_1d problem, array_double_1d axis);
static double speed_bound(double sign, double duration, array_double_1d problem, array_double_1d axis);
static bool is_resting(array_double_1d problem, array_double_1d axis);
static double total_duration(array_double_2d phases, int64_t count);
static double valid_duration(array_double_2d phases, int64_t count, array_double_1d problem, array_double_1d axis);
static bool is_passing(array_double_2d phases, int64_t count, array_double_1d axis);
static bool has_dip(array_double_2d phases, int64_t count);
static void stretch_phases(array_double_2d phases, int64_t count, double factor);
static int64_t fit_duration(array_double_2d phases, int64_t count, double target);
static int64_t append_velocity_change(array_double_2d phases, int64_t count, double v, double a, double w, double top, double bottom, array_double_1d axis);
static int64_t cruise_form(int64_t* result_0, int64_t* result_1, double* result_2, double* result_3, array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis);
static int64_t with_cruise(array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis);
static int64_t vanishing_cruise(double short_0001, double far, double start, array_double_2d phases, array_double_1d problem, array_double_1d axis);
static int64_t slower_cruise(array_double_2d phases, array_double_1d problem, array_double_1d axis);
static int64_t shorter_cruise(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d trial);
static double set_loop(array_double_1d problem, array_double_1d axis, array_double_1d family);
static int64_t level_from(double* result_0_0001, double* result_1_0001, double* result_2_0001, double a, double time, double up, double down, array_double_1d family, array_double_1d axis);
static double set_point(double place, double radius, array_double_1d family, array_double_1d axis);
static double loop_radius(int64_t arc, double place, double accuracy, double missing, double largest, array_double_1d family, array_double_1d axis);
static bool slow_middle(double place, double radius, array_double_1d family, array_double_1d axis);
static double usual_share(array_double_1d axis);
static double moderate_share(void);
static double steepest_share(void);
static bool ramps_suffice(array_double_1d axis);
static bool snap_is_last(array_double_1d axis);
static double saving(array_double_1d axis);
static bool plateau_parameters(double share, array_double_1d axis);
static bool smoothstep_parameters(array_double_1d axis, array_double_1d psi, array_double_1d peaks);
static double window_edge(double inside, double outside, array_double_1d family, array_double_1d axis);
static int64_t canonical_value(double* result_0_0001, double* result_1, double p, array_double_1d family, array_double_1d axis);
static double bracketed_root(double lower, double upper, double f_lower, double f_upper, array_double_1d family, array_double_1d axis);
static int64_t highest_member(double* result_0_0001, double* result_1_0001, double lower, double upper, array_double_1d family, array_double_1d axis);
static double rising_member(double f_start, double end, array_double_1d family, array_double_1d axis);
static void note_near(double y, double duration, array_double_1d family, array_double_1d axis);
static int64_t first_window(double* result_0, double* result_1, double f_start, double t_zero, array_double_1d family, array_double_1d axis);
static bool only_farther(array_double_1d family);
static double shorter_member(double f_start, array_double_1d family, array_double_1d axis);
static void note_near_gain(array_double_1d family, array_double_1d axis);
static double second_window(double t_zero, array_double_1d family, array_double_1d axis);
static double farther_member(double lower, double f_lower, array_double_1d family, array_double_1d axis);
static double canonical_search(array_double_1d family, array_double_1d axis);
static double member_search(array_double_1d family, array_double_1d axis);
static void set_family(int64_t branch, array_double_1d problem, array_double_1d axis, array_double_1d family);
static void set_member(int64_t member, double time, bool by_time, array_double_1d family);
static bool same_members(int64_t branch, array_double_1d problem, array_double_1d family);
static int64_t write_member(array_double_2d phases, array_double_1d family, array_double_1d axis);
static int64_t merged_form(array_double_2d phases, double highest, array_double_1d family, array_double_1d axis);
static double velocity_excess(array_double_2d phases, int64_t count, double v, double within_0001, array_double_1d axis);
static int64_t level_within(double* result_0, double* result_1_0001, double* result_2_0001, double* result_3_0001, double outside, double e_outside, array_double_2d phases, array_double_1d family, array_double_1d axis);
static double highest_within(double inside, double outside, double e_inside, double e_outside, array_double_2d phases, array_double_1d family, array_double_1d axis);
static int64_t tempered_form(array_double_2d phases, array_double_1d family, array_double_1d axis);
static int64_t timed_cruise(int64_t* result_0, double* result_1_0001, double* result_2, array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis);
static double cruise_range(array_double_2d phases, double middle, double y, double hold, array_double_1d problem, array_double_1d axis);
static void keep_nearest(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static bool is_enclosed(array_double_2d work);
static double keep_cruise(double cruise, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static void between_cruises(double lower, double upper, double e_lower, double e_upper, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static double cruise_edge(double inside, double outside, double h_inside, double h_outside, array_double_2d phases, array_double_1d problem, array_double_1d axis);
static void scan_cruises(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static int64_t loop_excess(double* result_0, double* result_1, int64_t arc, double place, double accuracy, double missing, double largest, array_double_1d family, array_double_1d axis);
static double loop_root(int64_t arc, double lower, double upper, double e_lower, double e_upper, double missing, double largest, array_double_1d family, array_double_1d axis);
static int64_t scanned_excess(double* result_0, double* result_1, int64_t arc, double place, double missing, double largest, array_double_1d family, array_double_1d axis);
static int64_t arc_root(int64_t* result_0, double* result_1, int64_t arc, int64_t sample, double missing, double largest, array_double_1d family, array_double_1d axis);
static int64_t loop_form(int64_t last, int64_t count, double longest, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void timed_loop(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static double taylor_value(int64_t order, int64_t top, double t, array_double_1d state);
static double zero_time(int64_t order, int64_t top, double length, array_double_1d state);
static void advance_piece(int64_t top, double length, array_double_1d state, array_double_1d end);
static void note_excess(int64_t q, int64_t node, bool holding, array_double_1d axis, array_double_1d end, array_double_2d excess);
static void piece_excess(double length, int64_t node, bool holding, array_double_1d axis, array_double_2d work);
static bool measure_excess(array_double_1d axis, array_double_2d work);
static double power_term(double t, double sixth);
static double highest_in_piece(double length, double value, double first, double second, double third, double fourth, double fifth, double sixth);
static double highest_at_node(int64_t order, double sign, int64_t i, array_double_1d passing, array_double_1d axis, array_double_2d nodes);
static double instant_error(int64_t peak, array_double_1d passing, array_double_1d axis, array_double_2d nodes);
static void shift_instants(int64_t place, int64_t by, array_double_1d passing);
static void place_instant(int64_t peak, int64_t order, double sign, int64_t node, array_double_1d passing);
static void add_instant(int64_t order, double sign, int64_t node, array_double_1d passing);
static double power_of(double base, int64_t exponent);
static void set_level(array_double_1d node, array_double_1d passing, array_double_1d axis);
static void advance(double time, double level, double change, double variance, double fourth, int64_t above, array_double_1d state);
static void pass_node(int64_t i, array_double_1d passing, array_double_1d axis, array_double_2d nodes);
static int64_t dropped_condition(int64_t q, array_double_1d node);
static double residual_scale(int64_t order, array_double_1d passing, array_double_1d axis);
static int64_t node_residuals(int64_t i, int64_t row, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual);
static bool stays_at_limit(array_double_1d node);
static void hold_limit(int64_t q, array_double_1d node, array_double_1d axis, array_double_1d state);
static int64_t first_row(int64_t node, array_double_1d passing, array_double_2d nodes);
static void end_residuals(int64_t row, array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_1d end, array_double_1d residual);
static int64_t follow_node(int64_t i, int64_t row, array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual);
static double sequence_duration(array_double_1d passing, array_double_2d nodes);
static void run_sequence(array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual);
static void follow_change(int64_t first, int64_t row, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d change, array_double_1d slopes);
static bool is_square(array_double_1d passing, array_double_2d nodes);
static void begin_dip(int64_t above, double v, double a, array_double_2d work);
static double follow_dip(int64_t order, array_double_1d axis, array_double_2d work);
static double last_jerk(double second, array_double_1d axis, array_double_2d work);
static void balance_jerk(array_double_1d axis, array_double_2d work);
static double last_excess(double time, double end, array_double_1d axis, array_double_2d work);
static bool close_dip(double first, double end, array_double_1d axis, array_double_2d work);
static int64_t judge_dip(bool* result_0, bool* result_1, double first, double end, array_double_1d axis, array_double_2d work);
static double find_edge(bool deepest, double lower, double end, array_double_1d axis, array_double_2d work);
static bool find_dips(double v, double a, double end, array_double_1d axis, array_double_1d dips, array_double_2d work);
static void find_deepest(array_double_1d axis, array_double_1d dips, array_double_2d work);
static int64_t write_levels(array_double_2d phases, array_double_2d work);
static int64_t write_dip(int64_t* result_0, double* result_1, double* result_2, double* result_3, double depth, array_double_1d axis, array_double_1d dips, array_double_2d phases, array_double_2d work);
static double peak_past_zero(double v, double a, double level, array_double_1d axis);
static double deep_level(double v, double a, double velocity_limit, double bottom, array_double_1d axis);
static double level_past_zero(double v, double a, double velocity_limit, double bottom, array_double_1d axis);
static int64_t brake(int64_t* result_0, double* result_1, double* result_2, double* result_3, double v, double a, array_double_1d axis, array_double_2d phases, array_double_2d work);
static bool nearly_brakes(double v, double a, array_double_1d axis);
static int64_t braked(int64_t* result_0_0001, double* result_1, int64_t variant, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t surround(array_double_2d phases, int64_t count, int64_t variant, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void timed_merged(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static void usual_cruise(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static void timed_between(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static void note_known(array_double_2d work);
static void clear_nearest(array_double_2d work);
static double nearest_weight(array_double_1d problem, array_double_1d axis, array_double_1d nearest);
static double beyond_rounding(double value, double scale);
static void mirror_search(array_double_1d problem, array_double_1d axis);
static void reverse_search(array_double_1d problem, array_double_1d axis);
static int64_t orient(int64_t* result_0, int64_t* result_1, array_double_1d problem, array_double_1d axis);
static void turn_back(int64_t mirrored, int64_t turned, array_double_1d problem, array_double_1d axis);
static void turn_phases(int64_t mirrored, int64_t turned, int64_t count, array_double_2d phases);
static int64_t as_asked(int64_t mirrored, int64_t turned, int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_1d passing);
static bool has_pace(array_double_1d passing);
static double residual_norm(int64_t count, array_double_1d residual);
static void difference_column(int64_t column, double change, int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void time_column(int64_t column, int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void newton_step(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work);
static double longest_step(array_double_2d work);
static double nearest_multiple(double value, double grid);
static void take_step(double share, double grid, array_double_2d work);
static bool solve_sequence(array_double_1d problem, array_double_1d axis, array_double_2d work);
static void keep_sequence(int64_t row, array_double_2d work);
static void restore_sequence(int64_t row, array_double_2d work);
static void insert_node(int64_t place, int64_t kind, double sign, double time, bool touch, array_double_2d work);
static void set_alternating(double sign, double time, array_double_2d work);
static void remove_node(int64_t place, array_double_2d work);
static int64_t split_guess(double* result_0_0001, double* result_1_0001, double* result_2_0001, int64_t guess);
static bool split_level(int64_t place, int64_t kind, double sign, int64_t guess, array_double_1d axis, array_double_2d work);
static bool split_ramp(int64_t place, int64_t kind, double sign, bool touch, bool holding, array_double_2d work);
static bool insert_plateau(int64_t kind, bool touching, int64_t guess, array_double_1d axis, array_double_2d work);
static bool rotate_levels(array_double_2d work);
static bool solve_rotated(array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t overlong_plateau(array_double_2d work);
static bool shorten_hold(int64_t row, int64_t touch, int64_t steps, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool touch_limit(int64_t row, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t add_plateau(array_double_1d axis, array_double_2d work);
static bool meet_limits(double longest, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool may_go_on(array_double_2d work);
static bool insert_level(int64_t variant, int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool move_instant(int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool compares_levels(array_double_1d axis);
static double sequence_cost(array_double_2d work);
static bool insert_instant(int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool insert_limit(array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool stay_below(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool end_highest(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool end_plateau(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool meet_all(array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t vanishing_end(array_double_2d work);
static bool release_plateau(array_double_2d work);
static bool follow(double target, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void append_level(double sign, double time, array_double_2d work);
static void append_levels(double change, array_double_1d axis, array_double_2d work);
static int64_t limit_held(int64_t* result_0, double* result_1_0001, double a, double v, array_double_1d axis);
static void copy_levels(int64_t count, array_double_2d phases, double v, array_double_1d axis, array_double_2d work);
static void begin_sequence(double duration, double acceleration, array_double_1d axis, array_double_1d passing);
static double peak_acceleration(int64_t count, array_double_2d ramps);
static bool set_sequence(int64_t attempt, int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool first_solution(int64_t count, array_double_2d ramps, array_double_1d problem, array_double_1d axis, array_double_2d work);
static double largest_excess(array_double_1d axis, array_double_2d work);
static bool is_brief(array_double_1d axis);
static bool shorter_solution(array_double_1d problem, array_double_1d axis, array_double_2d work);
static void loosen(double share, array_double_1d axis, array_double_2d work);
static bool tighten(double longest, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool slow_down(double longest, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void flush_levels(array_double_1d problem, array_double_1d axis, array_double_2d work);
static double idle_time(int64_t i, array_double_1d axis, array_double_2d work);
static int64_t write_sequence(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool stays_below(array_double_2d work);
static double passing_duration(int64_t way, double longest, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t usual_ways(array_double_1d axis, array_double_2d work);
static int64_t shortest_way(int64_t* result_0, double* result_1_0001, int64_t ways, double shortest, double longest, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t passing_form(double shortest, double longest, int64_t count, array_double_2d ramps, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool pace_down(int64_t moving, double shortest, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t timed_passing(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t slower_form(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static double usual_duration(array_double_1d problem, array_double_1d axis);
static int64_t fastest_between(array_double_2d phases, array_double_1d problem, array_double_1d axis);
static int64_t shortest_between(int64_t attempt, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool is_done(array_double_1d problem);
static int64_t braked_variant(int64_t* result_0_0001, double* result_1_0001, int64_t variant, double longest, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t braked_ramps(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t passing_either_way(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work);
static bool set_dips(double v, double a, double end, array_double_1d axis, array_double_1d dips, array_double_2d work);
static double problem_between(double depth, array_double_1d asked, array_double_1d axis, array_double_1d rest, array_double_2d work);
static int64_t profile_between(array_double_1d rest, array_double_1d axis, array_double_2d work);
static int64_t with_dips(double depth, int64_t count, array_double_2d phases, array_double_1d axis, array_double_2d work);
static int64_t dipped_profile(double depth, double longest, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work);
static bool set_both_dips(double end, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t best_depth(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work);
static int64_t shorter_dipped(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work);
static void surround_with_dips(int64_t column, double depth, array_double_2d phases, array_double_1d axis, array_double_2d work);
static double timed_between_dips(array_double_1d rest, array_double_1d axis, array_double_2d cell, array_double_2d work);
static double timed_dipped(array_double_1d axis, array_double_2d cell, array_double_2d work);
static double sign_of(double value);
static bool may_touch(double v, double a, array_double_1d axis);
static void set_touching(int64_t variant, double duration, array_double_1d problem, array_double_2d work);
static int64_t touching_guess(int64_t* result_0_0001, double* result_1, int64_t attempt);
static int64_t touching_starts(int64_t* result_0, double* result_1_0001, int64_t count, double longest, array_double_2d ramps, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t touching_form(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static double least_lever(double c, double gain, double top, array_double_1d axis);
static double early_window(double duration, array_double_1d problem, array_double_1d axis);
static double short_window(double duration, array_double_1d problem, array_double_1d axis, array_double_1d rest);
static void begin_search(array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t shortest_ramps(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t usual_braked(array_double_1d asked, array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t shortest_braked(array_double_1d asked, array_double_1d axis, array_double_2d phases, array_double_2d work);
static bool misses_little(double free, double duration, array_double_1d asked, array_double_1d axis);
static bool may_last_longer(array_double_1d problem, array_double_1d axis);
static int64_t oriented_profile(array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t begun_profile(array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t plain_profile(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
static double shortest_scale(int64_t order, array_double_1d limits);
static double natural_limit(int64_t order, double steep, array_double_1d axis, array_double_1d limits);
static void chain_limits(double steep, array_double_1d axis, array_double_1d state, array_double_1d limits);
static void set_chains(double steep, array_double_1d axis, array_double_1d limits, array_double_2d chains);
static void lift_pieces(int64_t order, int64_t first, int64_t last, array_double_1d state, array_double_2d timing, array_double_2d coefficients);
static int64_t append_stage(double v, double a, double w, array_double_2d phases, array_double_1d chain);
static void set_stage_problem(int64_t order, double end, array_double_1d state, array_double_1d problem);
static int64_t stage_phases(int64_t order, double end, bool free, array_double_2d lead);
static int64_t append_phases(int64_t order, double end, int64_t count, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t run_stage(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void drop_rounding(int64_t order, array_double_2d lead);
static int64_t settle_above(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t settle(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double outside_by(double value, int64_t order, array_double_2d lead);
static int64_t hold_highest(double value, double length, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t lead_to(int64_t order, double end, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t part_hull(int64_t order, int64_t row, double start, double length, array_double_2d lead, array_double_2d coefficients);
static bool is_hull_inside(int64_t count, double low, double high, array_double_2d lead);
static bool stays_inside(int64_t order, int64_t first, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double time_crossed(int64_t order, int64_t row, double lower, double upper, array_double_2d lead, array_double_2d coefficients);
static int64_t inside_from(int64_t* result_0_0001, double* result_1_0001, int64_t order, int64_t first, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t turn_round(int64_t* result_0, int64_t* result_1, double* result_2_0001, int64_t order, double side, double level, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double try_brake(int64_t order, double side, double level, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool set_box(double steep, int64_t loose, array_double_1d limits, array_double_2d lead);
static double lower_limit(int64_t order, array_double_1d limits, array_double_2d lead);
static bool is_outside(array_double_1d limits, array_double_2d lead);
static void note_extremes(int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void end_brake(double until, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void append_pieces(double until, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void split_brake(double until, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double time_inside(array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double level_limit(int64_t order, double side, array_double_2d lead);
static double deepest_level(int64_t order, double side, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t best_level(double* result_0, double* result_1, int64_t order, double side, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t level_time(double* result_0, double* result_1, int64_t order, double side, double gentle, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double side_beyond(int64_t order, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void bring_highest(array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool bring_gently(int64_t order, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool bring_inside(int64_t order, bool whole, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double kind_of(bool whole, array_double_1d limits);
static bool is_kept(int64_t row, bool whole, array_double_1d limits, array_double_2d lead);
static int64_t kept_brake(bool whole, array_double_1d limits, array_double_2d lead);
static void keep_brake(bool whole, double steep, int64_t loose, array_double_1d limits, array_double_2d lead);
static void clip_reached(array_double_2d lead);
static int64_t brake_within(double steep, int64_t loose, bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t best_steepness(double* result_0_0001, double* result_1, int64_t loose, bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t choose_brake(bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void write_end(int64_t last, array_double_2d timing, array_double_2d coefficients, array_double_1d end);
static bool is_at_velocity(double velocity, array_double_1d limits, array_double_1d end);
static int64_t level_order(int64_t order, array_double_2d lead);
static double lead_end(int64_t order, array_double_2d lead);
static int64_t passing_phases(int64_t order, double least, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t settle_over_level(int64_t order, double end, double least, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void set_limits(double steep, array_double_2d lead);
static bool is_settled(array_double_2d lead);
static void soonest_ends(int64_t order, array_double_2d lead);
static double profile_time(bool ramps, array_double_2d lead);
static void time_anew(int64_t order, array_double_2d lead);
static void keep_lead(int64_t last, double time, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool begins_now(array_double_2d lead, array_double_2d coefficients);
static bool is_better(double time, array_double_2d lead);
static bool keep_better(int64_t last, double time, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double try_velocity(int64_t row, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double try_lead(int64_t order, int64_t row, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double try_level(int64_t order, double level, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double try_end(int64_t order, int64_t stage, double end, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void search_end(int64_t order, int64_t stage, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool leads_in(double time, array_double_2d lead);
static int64_t first_free_stage(int64_t order);
static void try_soonest(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void improve_ends(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool try_steeper(int64_t order, double within_0001, int64_t times, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void search_ends(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double near_zero(double i);
static bool jumps_often(array_double_2d lead);
static double hopeful_time(array_double_2d lead);
static double follow_level(int64_t order, double level, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double search_grid(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void improve_level(int64_t order, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void search_levels(int64_t order, double found, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool permits_levels(int64_t order, array_double_2d lead);
static bool settled_end(int64_t row, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void follow_plan(int64_t order, int64_t axis, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool start_search(int64_t shape, array_double_1d limits, array_double_2d lead);
static bool goes_on_at_level(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool search_stages(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void improve_lead(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void prepend_brake(int64_t steps, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void search_braked(int64_t order, double within_0001, int64_t shape, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool find_lead(int64_t order, double within_0001, int64_t axis, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void clear_search(array_double_2d lead);
static void set_start(int64_t axis, array_double_2d start, array_double_2d lower, array_double_2d lead);
static int64_t latest_axis(array_double_2d ends);
static int64_t take_lead(int64_t first, array_double_1d end, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void follow_whole(int64_t axis, array_double_1d limits, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d end, array_double_2d lead, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets);
static void pack_leads(array_int64_t_1d plan_offsets, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets);
static void lead_to_velocity(array_double_2d lead);
static bool lead_between(int64_t source, int64_t slot, array_double_2d ends, array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static void set_motion(array_double_2d operation, array_double_3d states);
static bool lead_of(int64_t axis, int64_t source, int64_t slot, array_double_2d ends, array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static bool reach_velocity(int64_t axis, array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static bool stop_behind(int64_t axis, array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static bool shrink_share(int64_t axis, bool last, array_double_2d operation);
static bool goes_back(int64_t axis, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d lead);
static bool reach_velocities(bool slow, array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static bool seek_velocity(bool slow, array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static int64_t insert_end(double duration, double after, int64_t count, array_double_2d ends);
static int64_t cruise_times(double* result_0, double* result_1_0001, double cruise, array_double_1d problem, array_double_1d axis, array_double_2d phases);
static double cruise_time(double cruise, bool covering, array_double_1d problem, array_double_1d axis, array_double_2d phases);
static double turning_time(double lower, double upper, bool covering, array_double_1d problem, array_double_1d axis, array_double_2d phases);
static double cruise_sample(int64_t sample, double fastest, double backwards);
static int64_t insert_turn(int64_t sample, bool covering, double least, double spent, double after, double fastest, double backwards, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count);
static int64_t turning_ends(double spent, double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count);
static int64_t insert_covering(array_double_2d phases, int64_t taken, double spent, double after, array_double_1d problem, array_double_1d axis, int64_t count, array_double_2d ends);
static int64_t covering_ends(double spent, double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count);
static int64_t gap_ends(double after, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void set_extreme(double sign, double pace, array_double_1d problem, array_double_1d axis, array_double_2d work);
static int64_t extreme_form(int64_t* result_0, double* result_1_0001, double sign, double pace, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool timed_extremes(array_double_1d axis, array_double_2d cell, array_double_2d work);
static void polynomial_levels(array_double_1d problem, array_double_1d gentle);
static int64_t gentle_hold(double* result_0_0001, double* result_1, double level, array_double_1d problem, array_double_1d axis);
static void gentle_ramps(array_double_1d problem, array_double_1d axis, array_double_1d gentle);
static double gentle_errors(array_double_1d problem, array_double_1d axis, array_double_1d gentle);
static double usual_speed(array_double_1d problem, array_double_1d axis);
static bool gentle_slopes(array_double_1d problem, array_double_1d axis, array_double_1d gentle);
static bool gentle_step(array_double_1d gentle);
static void spread_levels(int64_t attempt, array_double_1d gentle);
static void take_levels(double share, array_double_1d gentle);
static bool solve_gentle(int64_t attempt, array_double_1d problem, array_double_1d axis, array_double_1d gentle);
static int64_t write_gentle(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_1d gentle);
static bool is_turning(double lowest, double highest);
static bool turns_back(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static bool timed_gently(bool turning, array_double_1d axis, array_double_2d cell, array_double_2d work);
static bool timed_slower(bool turning, double shortest, array_double_1d axis, array_double_2d cell, array_double_2d work);
static void surround_nearest(int64_t variant, array_double_1d axis, array_double_2d cell, array_double_2d work);
static double timed_smoothly(bool turning, array_double_1d axis, array_double_2d cell, array_double_2d work);
static double timed_braked(array_double_1d axis, array_double_2d cell, array_double_2d work);
static int64_t slowed_shortest(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static double slower_passing(array_double_1d axis, array_double_2d cell, array_double_2d work);
static double between_extremes(array_double_1d axis, array_double_2d cell, array_double_2d work);
static double timed_forwards(array_double_1d axis, array_double_2d cell, array_double_2d work);
static int64_t set_shortest(int64_t* result_0, double* result_1_0001, array_double_2d cell, array_double_1d axis, array_double_2d work);
static void set_stretched(double target, bool resting, array_double_2d cell, array_double_1d axis, array_double_2d work);
static bool set_duration(double target, array_double_2d cell, array_double_1d axis, array_double_2d work);
static double first_feasible(double outside, double inside, array_double_2d cell, array_double_1d axis, array_double_2d work);
static double next_feasible(double start, double most, array_double_2d cell, array_double_1d axis, array_double_2d work);
static double round_up(double duration, double sample_time);
static double common_duration(double start, double most, double sample_time, int64_t first, int64_t last, array_double_2d axes, array_double_3d cells, array_double_2d work);
static void note_shortest(double time, array_double_1d axis, array_double_2d cell);
static int64_t plan_with_share(int64_t axis, double share, array_double_2d axes, array_double_3d cells, array_double_2d work);
static double axis_duration(int64_t axis, array_double_2d axes, array_double_3d cells);
static void keep_shortest(int64_t axis, array_double_2d axes, array_double_3d cells);
static void restore_shortest(int64_t axis, array_double_2d axes, array_double_3d cells);
static double smoothness_share(double usual, double share);
static bool shorter_with(double share, double kept, double factor, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work);
static double plan_steeper(int64_t missed, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work);
static void plan_thoroughly(double share, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work);
static int64_t plan_refused(int64_t* result_0, double* result_1, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work);
static int64_t plan_axis(int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work);
static int64_t check_waypoints(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_1d report);
static int64_t time_left(double* result_0, double* result_1, int64_t* result_2, int64_t first, int64_t step, double target, array_double_3d cells);
static bool prolong_all(int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work);
static bool prolong_from(int64_t begin, double share, int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work);
static bool distribute(int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work);
static bool rewrite_intervals(int64_t first, int64_t last, array_double_2d axes, array_double_3d cells, array_double_2d work);
static void set_problems(array_double_3d states, array_double_3d cells);
static double meet_intervals(int64_t first, int64_t last, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work);
static int64_t synchronize_plan(array_double_1d dwells, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work);
static void shift_piece(array_double_2d coefficients, int64_t source, double t, double weight, int64_t target);
static int64_t merge_pieces(double weight, double now, int64_t middle, int64_t last, array_double_2d timing, array_double_2d coefficients, int64_t row);
static int64_t expand_profile(array_double_2d cell, bool second, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work);
static int64_t expand_cell(array_double_2d cell, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work);
static int64_t expand_plan(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work);
static void lead_to_plan(array_double_2d lead);
static bool join_behind(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_3d cells, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d lead);
static void set_delayed(array_double_3d states);
static int64_t finish_plan(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d lead);
static void set_place(array_double_2d operation, array_double_3d states);
static void set_ends(array_double_2d operation, array_double_3d states);
static void set_options(array_double_2d known, array_double_2d lead, array_double_2d work);
static double coming_velocity(int64_t axis, array_double_2d operation, array_double_2d limits);
static bool is_too_fast(array_double_2d operation, array_double_3d limits);
static void end_ways_at_target(array_double_2d operation);
static bool lead_to_target(array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static bool plan_target(array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work);
static bool seek_target(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work);
static void open_ways(array_double_2d operation, array_double_2d known);
static bool are_ways_kept(array_double_2d operation);
static void keep_ways(array_double_2d operation);
static bool rests_short(array_double_2d operation);
static double depth_towards(int64_t axis, double low, double high, double place, array_double_2d operation);
static void end_way(int64_t axis, double low, double high, array_double_2d operation);
static bool end_before_obstacle(array_double_2d operation, array_double_2d known, array_double_2d work);
static bool is_prolonged(array_double_2d operation);
static void choose_ease(int64_t attempt, int64_t status, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static bool keeps_blocked(array_double_2d operation);
static int64_t first_attempt(int64_t* result_0_0001, int64_t* result_1_0001, array_double_2d operation, array_double_2d known);
static bool keeps_stopping(int64_t attempt, array_double_2d operation);
static bool is_passed_over(int64_t attempt, int64_t failed, array_double_2d operation);
static void put_off(int64_t attempt, int64_t failed, array_double_2d operation);
static bool seek_plan(int64_t attempt, array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work);
static bool is_stop(array_double_1d aim);
static int64_t rank(int64_t attempt, array_double_2d operation);
static bool is_slowed(array_double_2d operation);
static void note_taken(int64_t attempt, array_double_2d operation);
static void take_plan(int64_t attempt, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool blocks(int64_t attempt, array_double_2d operation, array_double_2d known, array_double_2d work);
static bool holds_until_next(array_double_2d operation);
static bool renew_holds(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work, array_double_3d stack);
static bool attempt_plans(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work, array_double_3d stack);
static bool trips(array_double_2d operation);
static bool brake_anew(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work);
static void begin_swing(array_double_2d operation);
static bool is_due(array_double_2d operation);
static bool is_served(double elapsed, array_double_2d operation);
static bool renews(double elapsed, array_double_2d operation);
static void write_variables(bool step, array_double_1d path, array_double_3d spots, array_double_3d links);
static int64_t unit_of(double* result_0_0001, int64_t* result_1_0001, int64_t column, int64_t order, array_double_1d track);
static void write_scales(array_double_1d path, array_double_1d track, double time, array_double_2d link, array_double_2d square);
static void write_node_shares(array_double_1d path, array_double_1d track, double time, array_double_2d link, array_double_2d grid, array_double_2d square);
static double largest_node_share(array_double_1d path, array_double_2d tracks, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square);
static double room_of(double share);
static double state_offset(array_double_2d spot, int64_t row, int64_t field, array_double_1d track);
static double path_total(int64_t column, array_double_2d spans);
static double barrier_value(double theta, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square);
static bool band_solve(array_double_2d band);
static int64_t end_row(int64_t i, int64_t place, int64_t axes);
static bool write_durations(double theta, array_double_1d path, array_double_3d links, array_double_2d spans);
static void add_link(int64_t i, int64_t other, int64_t axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band);
static void write_band(array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band);
static void write_components(int64_t count, array_double_2d link);
static double write_steps(array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, double theta);
static bool set_axes(array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_2d work);
static bool plan_alone(int64_t place, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work);
static double shortest_of(int64_t place, int64_t axis, array_double_2d axes, array_double_3d cells);
static double least_length(int64_t place, array_double_2d axes, array_double_3d cells, array_double_2d work);
static double common_length(int64_t place, double most, array_double_2d axes, array_double_3d cells, array_double_2d work);
static double plan_lengths(array_double_3d states, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d work);
static double farthest_beyond(int64_t side, double low, double high, double first, array_double_2d cell, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static bool leaves_box(int64_t place, array_double_3d states, array_double_1d path, array_double_3d links, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static void copy_states(array_double_3d source, array_double_3d target);
static int64_t offer_states(array_double_3d tried, array_double_3d best, array_double_1d path, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static double extent(int64_t axis, array_double_3d given);
static void write_boxes(double room, int64_t first, array_double_3d given, array_double_1d path, array_double_2d axes, array_double_3d links);
static bool admit_states(array_double_3d states, array_double_1d path, array_double_3d spots, array_double_3d links);
static bool is_moving(array_double_3d states);
static void write_margin(array_double_1d path, array_double_3d links);
static void widen_boxes(array_double_3d states, array_double_1d path, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static double power_over_factorial(double base, int64_t exponent);
static double control_effect(int64_t order, int64_t derivative, int64_t cell, int64_t node);
static double end_effect(int64_t derivative, int64_t column, double time);
static bool is_required(int64_t derivative, int64_t column);
static void write_least_controls(int64_t order, int64_t first, array_double_2d grid, array_double_2d square);
static void project_out(int64_t unit, int64_t row, array_double_2d basis);
static void write_free_controls(int64_t order, int64_t first, array_double_2d grid, array_double_2d square);
static void write_products(array_double_1d row);
static void write_grid(int64_t order, array_double_2d grid, array_double_2d square);
static int64_t row_change(double* result_0_0001, double* result_1_0001, int64_t row, int64_t count, array_double_2d grid, array_double_2d square);
static int64_t pair_place(int64_t one, int64_t other);
static double add_share(int64_t row, int64_t count, array_double_2d link, array_double_2d grid, array_double_2d square);
static void give_units(int64_t count, array_double_2d link, array_double_2d square);
static double hessian_entry(int64_t one, int64_t other, array_double_2d square);
static int64_t outer_column(int64_t place);
static void eliminate(int64_t count, array_double_2d link, array_double_2d square);
static void write_model(double ridge, array_double_1d path, array_double_1d track, double time, array_double_2d link, array_double_2d grid, array_double_2d square);
static double gap_of(int64_t point);
static void try_move(double share, array_double_1d path, array_double_3d spots, array_double_3d links, array_double_2d spans);
static void take_tried(array_double_3d spots, array_double_3d links, array_double_2d spans);
static double write_step_of(double theta, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band);
static bool centre_path(double theta, double accuracy, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band);
static void write_times(array_double_1d path, array_double_2d tracks, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square);
static bool retreat(array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band);
static bool begin_path(array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band);
static double slow_path(double gap, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square);
static double follow_path(double theta, double gap, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band);
static double limit_of(int64_t place, int64_t axis, array_double_2d limits);
static void write_tracks(array_double_2d limits, array_double_2d lower, array_double_1d path, array_double_2d tracks);
static double limit_share(int64_t order, double degree, bool smoothstep);
static void write_box_scale(double first, array_double_2d link);
static void write_scales_of(bool smoothstep, array_double_3d given, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans);
static double highest_state(int64_t field, double limit);
static void write_tried(array_double_3d given, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d tried);
static bool may_beat(double known, int64_t place, double total);
static int64_t block_rows(int64_t* result_0_0001, int64_t* result_1_0001, int64_t block, array_double_1d path, array_double_3d choice);
static bool try_path(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static bool tighten_path(bool everywhere, array_double_2d spans);
static void search_states(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static void keep_cells(int64_t point, int64_t axis, bool back, array_double_2d axes, array_double_3d cells, array_double_3d links);
static void forget_profiles(int64_t point, int64_t axis, array_double_2d axes, array_double_3d cells);
static void set_state(double value, int64_t point, int64_t axis, int64_t field, array_double_3d states, array_double_2d axes, array_double_3d cells);
static double longest_of(int64_t place, int64_t without, array_double_2d axes, array_double_3d cells);
static double tried_length(int64_t point, int64_t axis, array_double_3d states, array_double_1d path, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static void polish_state(int64_t spot, int64_t field, array_double_3d states, array_double_1d path, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static bool runs_backwards(array_double_2d spans);
static double polish_states(array_double_3d states, array_double_1d path, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static double few_digits(double value);
static void measure_states(int64_t axis, int64_t places, double slowest, array_double_3d choice, array_double_1d track);
static void take_units(int64_t places, array_double_3d choice, array_double_2d limits, array_double_2d lower, array_double_2d axes);
static void return_states(int64_t point, array_double_3d choice, array_double_2d axes);
static void restore_given(array_double_2d given, array_double_2d found);
static int64_t check_limits(array_double_2d limits, array_double_1d report);
static bool is_real(double value);
static int64_t check_numbers(array_double_3d states, array_double_2d limits, array_double_1d report);
static double change_time(double size, int64_t derivative, array_double_1d limits);
static int64_t axis_scale(double* result_0, double* result_1_0001, int64_t axis, array_double_3d states, array_double_1d limits);
static double settle_value(double value, int64_t order, int64_t axis, array_double_3d states, array_double_2d limits, array_double_2d lower);
static bool differ(double before, double value);
static bool is_same(array_double_2d before, array_double_2d state);
static void give_states(int64_t point, int64_t count, array_double_3d spots);
static bool stays(int64_t point, array_double_3d choice);
static int64_t write_places(array_double_3d states, array_double_1d dwells, array_double_3d choice, array_double_1d place, array_double_3d spots);
static void bring_down(array_double_3d given, array_double_2d limits, array_double_2d lower, array_double_2d axes);
static bool is_given(int64_t point, int64_t count, array_double_3d spots);
static void searched_states(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static bool choose_fields(bool all_fields, array_double_3d spots);
static double fastest_states(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work);
static int64_t sensing_rows(double sample_time, double dead_time);
static int64_t sensing_end(array_double_2d settings);
static double next_sample(array_double_1d sensors, array_double_2d memory);
static int64_t ring_size(array_double_2d memory);
static int64_t ring_place(int64_t* result_0, int64_t* result_1_0001, int64_t number, array_double_2d memory);
static void deliver_samples(array_double_1d sensors, double time, array_double_2d memory);
static void take_sample(array_double_1d sensors, array_double_1d state, array_double_2d memory);
static void start_sensing(array_double_1d sensors, array_double_1d state, array_double_2d memory);
static void sense_signals(array_double_1d sensors, double time, array_double_1d state, array_double_2d memory, array_double_1d measured);
static double time_tolerance(array_double_2d settings);
static double present_time(array_double_2d memory);
static double next_tick(array_double_2d settings, array_double_2d memory);
static double next_reading(array_double_2d settings, array_double_2d memory);
static double next_event(array_double_2d settings, double duration, array_double_2d memory);
static double next_change(array_double_2d changes, double after, array_double_2d memory);
static double mechanical_energy(array_double_2d memory);
static void change_payload(array_double_2d settings, array_double_2d changes, double time, array_double_2d memory);
static void handle_events(array_double_2d settings, array_double_2d changes, array_double_2d memory);
static void update_signals(array_double_2d settings, double time, array_double_2d memory);
static bool is_driven(array_double_2d memory);
static double setpoint_at(array_double_1d setpoints, int64_t i, double share, array_double_2d memory);
static int64_t setpoint_rates(double* result_0_0001, double* result_1, double* result_2_0001, array_double_1d setpoints, int64_t i, double share, double duration, array_double_2d memory);
static double bounded_velocity(int64_t axis, double velocity, array_double_2d memory);
static void set_polynomial(int64_t row, int64_t rates, int64_t i, double value, double slope, double square, double cube, array_double_2d memory);
static void set_command(int64_t axis, double value, double slope, double square, double cube, array_double_2d memory);
static void follow_velocity(int64_t axis, double end, double square, double cube, double length, array_double_2d memory);
static void set_load_force(int64_t i, double value, double slope, double square, double cube, array_double_2d memory);
static int64_t delay_rows(double longest, double period);
static double longest_delay(array_double_1d plant);
static bool is_late(array_double_2d memory);
static int64_t command_place(int64_t* result_0, int64_t* result_1_0001, int64_t number, array_double_2d delayed);
static double command_start(int64_t number, array_double_2d delayed);
static void start_delay(array_double_1d setpoints, array_double_2d delayed, array_double_2d memory);
static int64_t shifted_command(double* result_0, double* result_1, double* result_2_0001, double* result_3, int64_t axis, double after, int64_t column, array_double_1d sent);
static void join_commands(double time, double shortest, array_double_2d delayed);
static void drop_commands(double time, array_double_2d delayed);
static void write_command(int64_t axis, array_double_1d setpoints, double share, double duration, array_double_2d memory, int64_t column, array_double_1d sent);
static void send_commands(array_double_1d setpoints, double duration, array_double_2d memory, array_double_2d delayed);
static int64_t command_number(double time, array_double_2d delayed);
static double next_command(array_double_2d settings, double until, array_double_2d memory, array_double_2d delayed);
static void late_commands(array_double_2d settings, double length, array_double_2d memory, array_double_2d delayed);
static void start_planned(array_double_1d setpoints, array_double_2d memory);
static void follow_setpoint(int64_t axis, double setpoint, double slope, double period, array_double_2d memory);
static bool controller_due(array_double_2d settings, array_double_2d memory);
static void prepare_tick(array_double_2d settings, array_double_1d setpoints, double duration, array_double_2d memory);
static void bound_feedback(array_double_2d settings, array_double_3d gains, array_double_1d situation, array_double_2d memory);
static void correct_setpoints(array_double_2d settings, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_2d memory);
static void command_velocities(array_double_1d setpoints, double duration, double until, array_double_2d memory);
static void command_forces(array_double_1d setpoints, double duration, array_double_2d memory);
static void follow_wind(array_double_1d setpoints, double duration, array_double_2d memory);
static int64_t advance_plant(array_double_2d settings, array_double_2d components, array_double_1d setpoints, double duration, double until, array_double_2d memory);
static double added_velocity(int64_t axis, double time, array_double_2d memory);
static int64_t commanded_rates(array_double_2d components, array_double_1d setpoints, double time, array_double_2d memory, array_double_1d derivative);
static double first_command(int64_t axis, array_double_1d setpoints, array_double_2d memory);
static void act_first(array_double_2d components, array_double_1d setpoints, array_double_2d memory);
static void load_outputs(array_double_1d target, array_double_2d memory, array_double_1d outputs);
static double total_sway(double angle_x, double angle_y);
static void drive_outputs(array_double_2d memory, array_double_1d outputs);
static int64_t axis_slopes(double* result_0, double* result_1_0001, double* result_2, array_double_1d plant, int64_t axis, array_double_1d state);
static double power_slope(array_double_1d plant, int64_t axis, array_double_1d state, array_double_1d action);
static void add_damping(array_double_1d plant, array_double_1d by, array_double_1d row);
static void forced_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials);
static bool demand_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_1d command, array_double_2d partials);
static bool driven_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials);
static void power_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials);
static void drag_partials(array_double_1d plant, array_double_1d air, array_double_2d work, array_double_2d partials);


static int64_t row_range(double* result_0, double* result_1, array_double_2d span, int64_t row) {
double least, most;
int64_t i;
least = *cspan_at(&span, row, 0);
most = least;
for (i = 1; i < span.shape[1]; i += 1) {
least = span_min(least, *cspan_at(&span, row, i));
most = span_max(most, *cspan_at(&span, row, i));
}
(*result_0) = least;
(*result_1) = most;
return 0;
}
static int64_t load_meeting(array_double_2d span, array_double_1d box) {
int64_t axis, meeting;
double least, most, low, high;
meeting = 1;
for (axis = 0; axis < 3; axis += 1) {
row_range(&least, &most, span, 0 + axis);
low = *cspan_at(&box, 0 + axis);
high = *cspan_at(&box, 3 + axis);
if ((most <= low) || (least >= high)) {
return 0;
}
if ((least <= low) || (most >= high)) {
meeting = 2;
}
}
return meeting;
}
static bool is_beside(int64_t axis, double lowest, double highest, double top, array_double_2d span, array_double_1d box) {
double bottom, reach, upwards, low, high, side, place;
bool below, above;
int64_t i;
bottom = *cspan_at(&box, 6 + 2);
below = 1;
above = 1;
for (i = 0; i < span.shape[1]; i += 1) {
reach = *cspan_at(&span, 3 + axis, i);
upwards = *cspan_at(&span, 6 + 2, i);
low = reach - *cspan_at(&box, 6 + axis) * upwards;
high = reach - *cspan_at(&box, 9 + axis) * upwards;
side = *cspan_at(&span, 6 + axis, i);
place = *cspan_at(&span, 0 + axis, i);
below = below && (low + top * side <= 0.0);
above = above && (high + top * side >= 0.0);
if (lowest < bottom) {
below = below && (low + bottom * side <= 0.0);
above = above && (high + bottom * side >= 0.0);
}
if (highest > bottom) {
below = below && (place <= *cspan_at(&box, 6 + axis));
above = above && (place >= *cspan_at(&box, 9 + axis));
}
if ((!below) && (!above)) {
return 0;
}
}
return 1;
}
static int64_t turn_range(double* result_0, double* result_1, int64_t corner, array_double_2d span, array_double_1d box) {
double x, y, least, most, turn;
int64_t i;
x = *cspan_at(&box, 6);
y = *cspan_at(&box, 6 + 1);
if (span_floor_mod(corner, 2) == 1) {
x = *cspan_at(&box, 9);
}
if (span_floor_div(corner, 2) == 1) {
y = *cspan_at(&box, 9 + 1);
}
least = 1e+300;
most = -1e+300;
for (i = 0; i < span.shape[1]; i += 1) {
turn = *cspan_at(&span, 5, i) - x * *cspan_at(&span, 6 + 1, i) + y * *cspan_at(&span, 6, i);
least = span_min(least, turn);
most = span_max(most, turn);
}
(*result_0) = least;
(*result_1) = most;
return 0;
}
static int64_t count_edges(int64_t* result_0, int64_t* result_1, array_double_2d span, array_double_1d box) {
double rounding, least, most;
int64_t left, right, corner;
rounding = *cspan_at(&span, 9, 3);
left = 0;
right = 0;
for (corner = 0; corner < 4; corner += 1) {
turn_range(&least, &most, corner, span, box);
if (least > rounding) {
left = left + 1;
}
if (most < -rounding) {
right = right + 1;
}
}
(*result_0) = left;
(*result_1) = right;
return 0;
}
static bool is_across(int64_t axis, double lowest, double highest, double top, array_double_2d span, array_double_1d box) {
double bottom, reach, upwards, low, high, side, place;
bool past_low, past_high, lower_past_low, lower_past_high;
int64_t i;
bottom = *cspan_at(&box, 6 + 2);
past_low = 1;
past_high = 1;
lower_past_low = 1;
lower_past_high = 1;
for (i = 0; i < span.shape[1]; i += 1) {
reach = *cspan_at(&span, 3 + axis, i);
upwards = *cspan_at(&span, 6 + 2, i);
low = reach - *cspan_at(&box, 6 + axis) * upwards;
high = reach - *cspan_at(&box, 9 + axis) * upwards;
side = *cspan_at(&span, 6 + axis, i);
place = *cspan_at(&span, 0 + axis, i);
past_low = past_low && (low + top * side > 0.0);
past_high = past_high && (high + top * side < 0.0);
if (lowest < bottom) {
lower_past_low = lower_past_low && (low + bottom * side > 0.0);
lower_past_high = lower_past_high && (high + bottom * side < 0.0);
}
if (highest > bottom) {
lower_past_low = lower_past_low && (place > *cspan_at(&box, 6 + axis));
lower_past_high = lower_past_high && (place < *cspan_at(&box, 9 + axis));
}
}
return (past_low || lower_past_low) && (past_high || lower_past_high);
}
static double value_about(double share, int64_t row, array_double_2d span) {
double result;
result = (1.0 - share) * *cspan_at(&span, row, 0) + share * *cspan_at(&span, row, span.shape[1] - 1);
return result;
}
static double shared_height(double share, array_double_2d span, array_double_1d box) {
double top, bottom, upwards, place, slope, near, far;
int64_t axis;
top = span_min(*cspan_at(&box, 9 + 2), 0.0);
bottom = span_max(*cspan_at(&box, 6 + 2), value_about(share, 0 + 2, span));
upwards = value_about(share, 6 + 2, span);
for (axis = 0; axis < 2; axis += 1) {
place = value_about(share, 3 + axis, span) / upwards;
slope = value_about(share, 6 + axis, span) / upwards;
near = *cspan_at(&box, 6 + axis) - place;
far = *cspan_at(&box, 9 + axis) - place;
if (slope < 0.0) {
near = *cspan_at(&box, 9 + axis) - place;
far = *cspan_at(&box, 6 + axis) - place;
}
if (fabs(slope) * 1000000000000.0 > fabs(near)) {
bottom = span_max(bottom, near / slope);
}
if (fabs(slope) * 1000000000000.0 > fabs(far)) {
top = span_min(top, far / slope);
}
}
return 0.5 * (bottom + top);
}
static bool is_within(double height, array_double_2d span, array_double_1d box) {
int64_t axis, i;
double place, upwards;
bool result;
for (axis = 0; axis < 2; axis += 1) {
for (i = 0; i < span.shape[1]; i += 1) {
place = *cspan_at(&span, 3 + axis, i) + height * *cspan_at(&span, 6 + axis, i);
upwards = *cspan_at(&span, 6 + 2, i);
if (!(place - *cspan_at(&box, 6 + axis) * upwards > 0.0)) {
return 0;
}
if (!(place - *cspan_at(&box, 9 + axis) * upwards < 0.0)) {
return 0;
}
}
}
result = (*cspan_at(&box, 6 + 2) < height) && (height < *cspan_at(&box, 9 + 2)) && (height < 0.0);
return result;
}
static int64_t rope_meeting(array_double_2d span, array_double_1d box) {
double least, most, top, lowest, highest, height;
int64_t axis, left, right;
row_range(&least, &most, span, 6 + 2);
top = span_min(*cspan_at(&box, 9 + 2), 0.0);
if ((most <= 1e-09) || (*cspan_at(&box, 6 + 2) >= top)) {
return 0;
}
row_range(&lowest, &highest, span, 0 + 2);
if (lowest >= top) {
return 0;
}
if (least <= 0.0) {
return 2;
}
for (axis = 0; axis < 2; axis += 1) {
if (is_beside(axis, lowest, highest, top, span, box)) {
return 0;
}
}
count_edges(&left, &right, span, box);
if ((left == 4) || (right == 4)) {
return 0;
}
if (highest >= top) {
return 2;
}
if (is_across(0, lowest, highest, top, span, box) && is_across(1, lowest, highest, top, span, box) && (left > 0) && (right > 0)) {
return 1;
}
height = shared_height(0.5, span, box);
if ((highest < height) && is_within(height, span, box)) {
return 1;
}
return 2;
}
static bool part_moves(int64_t part, array_double_2d span) {
double rounding, least, most, slowest, fastest;
int64_t axis;
rounding = *cspan_at(&span, 9, 4);
for (axis = 0; axis < 3; axis += 1) {
row_range(&least, &most, span, 0 + axis);
if (most - least > rounding) {
return 1;
}
}
if (part == 1) {
return 0;
}
row_range(&slowest, &fastest, span, 6 + 2);
for (axis = 0; axis < 2; axis += 1) {
row_range(&least, &most, span, 3 + axis);
if (most - least > rounding * slowest) {
return 1;
}
}
return 0;
}
static void polynomial_differentiate(array_double_1d a, int64_t count, int64_t order, array_double_1d found) {
int64_t i, j;
double factor;
for (i = 0; i < count - order; i += 1) {
factor = 1.0;
for (j = 0; j < order; j += 1) {
factor = factor * (i + j + 1);
}
*cspan_at(&found, i) = factor * *cspan_at(&a, i + order);
}
}
static void polynomial_add_product(array_double_1d a, int64_t a_count, array_double_1d b, int64_t b_count, array_double_1d found) {
int64_t i, j;
for (i = 0; i < a_count; i += 1) {
for (j = 0; j < b_count; j += 1) {
*cspan_at(&found, i + j) = *cspan_at(&found, i + j) + *cspan_at(&a, i) * *cspan_at(&b, j);
}
}
}
static void polynomial_clear(array_double_1d found) {
int64_t i;
for (i = 0; i < found.shape[0]; i += 1) {
*cspan_at(&found, i) = 0.0;
}
}
static void polynomial_shift(array_double_1d a, double offset, int64_t count) {
int64_t i, j, k;
for (i = 0; i < count - 1; i += 1) {
for (j = 0; j < count - 1 - i; j += 1) {
k = count - 2 - j;
*cspan_at(&a, k) = *cspan_at(&a, k) + offset * *cspan_at(&a, k + 1);
}
}
}
static void rope_pull(double gravity, int64_t width, array_double_2d work) {
polynomial_differentiate(span_row(&work, 0), width, 2, span_row(&work, 3));
polynomial_differentiate(span_row(&work, 0 + 1), width, 2, span_row(&work, 3 + 1));
polynomial_differentiate(span_row(&work, 0 + 2), width, 2, span_row(&work, 3 + 2));
*cspan_at(&work, 3 + 2, 0) = *cspan_at(&work, 3 + 2, 0) + gravity;
}
static int64_t rope_margin(int64_t demand, double bound, int64_t width, array_double_2d work) {
array_double_1d z, w_x, w_y, w_z, margin, product_0, product_1, product_2;
int64_t i;
double sign;
z = span_row(&work, 0 + 2);
w_x = span_row(&work, 3);
w_y = span_row(&work, 3 + 1);
w_z = span_row(&work, 3 + 2);
margin = span_row(&work, 6);
product_0 = span_row(&work, 7);
product_1 = span_row(&work, 7 + 1);
product_2 = span_row(&work, 7 + 2);
if (demand == 1) {
for (i = 0; i < width; i += 1) {
*cspan_at(&margin, i) = -*cspan_at(&z, i);
}
*cspan_at(&margin, 0) = *cspan_at(&margin, 0) - bound;
return width;
}
if (demand == 2) {
for (i = 0; i < width - 2; i += 1) {
*cspan_at(&margin, i) = *cspan_at(&w_z, i);
}
*cspan_at(&margin, 0) = *cspan_at(&margin, 0) - bound;
return width - 2;
}
polynomial_clear(product_0);
polynomial_add_product(w_z, width - 2, w_z, width - 2, product_0);
polynomial_clear(product_1);
polynomial_add_product(z, width, z, width, product_1);
polynomial_clear(product_2);
polynomial_add_product(w_x, width - 2, w_x, width - 2, product_2);
polynomial_add_product(w_y, width - 2, w_y, width - 2, product_2);
polynomial_add_product(w_z, width - 2, w_z, width - 2, product_2);
polynomial_clear(margin);
polynomial_add_product(product_1, 2 * width - 1, product_2, 2 * width - 5, margin);
sign = 1.0;
if (demand == 4) {
sign = -1.0;
}
for (i = 0; i < 4 * width - 7; i += 1) {
*cspan_at(&margin, i) = sign * (bound * bound * *cspan_at(&product_0, i) - *cspan_at(&margin, i));
}
return 4 * width - 7;
}
static double rope_value(int64_t demand, double gravity, double z, double w_x, double w_y, double w_z) {
if (demand == 1) {
return z;
}
if (demand == 2) {
return gravity - w_z;
}
return (-z) * sqrt(w_x * w_x + w_y * w_y + w_z * w_z) / w_z;
}
static int64_t find_piece(double time, array_double_2d timing, int64_t first, int64_t last) {
int64_t upper, middle, lower;
lower = first;
upper = last;
while(upper - lower > 1) {
middle = span_floor_div((lower + upper), 2);
if (time >= *cspan_at(&timing, middle, 0)) {
lower = middle;
}
else {
upper = middle;
}
}
return lower;
}
static double evaluate_piece(array_double_2d coefficients, int64_t row, int64_t width, double t, int64_t derivative) {
int64_t j, i, m;
double factor, value;
value = 0.0;
for (j = 0; j < width - derivative; j += 1) {
i = width - 1 - j;
factor = 1.0;
for (m = 0; m < derivative; m += 1) {
factor = factor * (i - m);
}
value = value * t + factor * *cspan_at(&coefficients, row, i);
}
return value;
}
static double local_time(double time, array_double_2d timing, int64_t row) {
double result;
result = span_min(time - *cspan_at(&timing, row, 0), *cspan_at(&timing, row, 1));
return result;
}
void segfmu_evaluate(array_double_1d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, int64_t derivative, array_double_2d values) {
int64_t width, axis, first, last, row, i;
double t, local;
bool behind;
width = coefficients.shape[1];
for (axis = 0; axis < ends.shape[0]; axis += 1) {
first = *cspan_at(&offsets, axis);
last = *cspan_at(&offsets, axis + 1);
row = first;
for (i = 0; i < times.shape[0]; i += 1) {
t = span_min(span_max(*cspan_at(&times, i), *cspan_at(&timing, first, 0)), *cspan_at(&ends, axis));
behind = (row + 1 < last) && (t >= *cspan_at(&timing, row + 1, 0));
if ((t < *cspan_at(&timing, row, 0)) || behind) {
row = find_piece(t, timing, first, last);
}
if ((derivative > 0) && (t != *cspan_at(&times, i))) {
*cspan_at(&values, i, axis) = 0.0;
}
else {
local = local_time(t, timing, row);
*cspan_at(&values, i, axis) = evaluate_piece(coefficients, row, width, local, derivative);
}
}
}
}
void segfmu_evaluate_orders(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d values) {
int64_t width, axis, row, derivative;
double t, local;
width = coefficients.shape[1];
for (axis = 0; axis < ends.shape[0]; axis += 1) {
t = span_min(span_max(time, (*cspan_at(&timing, *cspan_at(&offsets, axis), 0))), *cspan_at(&ends, axis));
row = find_piece(t, timing, *cspan_at(&offsets, axis), *cspan_at(&offsets, axis + 1));
local = local_time(t, timing, row);
for (derivative = 0; derivative < values.shape[0]; derivative += 1) {
if ((derivative > 0) && (t != time)) {
*cspan_at(&values, derivative, axis) = 0.0;
}
else {
*cspan_at(&values, derivative, axis) = evaluate_piece(coefficients, row, width, local, derivative);
}
}
}
}
static void evaluate_derivatives(array_double_2d coefficients, int64_t row, double t, int64_t axis, array_double_2d values) {
int64_t width, j;
double position, velocity, acceleration, jerk, snap, crackle, pop;
width = coefficients.shape[1];
position = 0.0;
velocity = 0.0;
acceleration = 0.0;
jerk = 0.0;
snap = 0.0;
crackle = 0.0;
pop = 0.0;
for (j = 0; j < width; j += 1) {
pop = pop * t + crackle;
crackle = crackle * t + snap;
snap = snap * t + jerk;
jerk = jerk * t + acceleration;
acceleration = acceleration * t + velocity;
velocity = velocity * t + position;
position = position * t + *cspan_at(&coefficients, row, width - 1 - j);
}
*cspan_at(&values, 0, axis) = position;
*cspan_at(&values, 1, axis) = velocity;
*cspan_at(&values, 2, axis) = 2.0 * acceleration;
*cspan_at(&values, 3, axis) = 6.0 * jerk;
*cspan_at(&values, 4, axis) = 24.0 * snap;
if (values.shape[0] > 5) {
*cspan_at(&values, 5, axis) = 120.0 * crackle;
*cspan_at(&values, 6, axis) = 720.0 * pop;
}
}
static void evaluate_near(double time, array_double_1d near, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d values) {
int64_t axis, first, last, row, derivative;
double t;
bool behind;
for (axis = 0; axis < ends.shape[0]; axis += 1) {
first = *cspan_at(&offsets, axis);
last = *cspan_at(&offsets, axis + 1);
t = span_min(span_max(time, *cspan_at(&timing, first, 0)), *cspan_at(&ends, axis));
row = span_min_int(span_max_int((int64_t)(*cspan_at(&near, axis)), first), last - 1);
behind = (row + 1 < last) && (t >= *cspan_at(&timing, row + 1, 0));
if (behind || (t < *cspan_at(&timing, row, 0))) {
row = find_piece(t, timing, first, last);
}
*cspan_at(&near, axis) = row;
evaluate_derivatives(coefficients, row, local_time(t, timing, row), axis, values);
if (t != time) {
for (derivative = 1; derivative < values.shape[0]; derivative += 1) {
*cspan_at(&values, derivative, axis) = 0.0;
}
}
}
}
static void bernstein_coefficients(array_double_2d coefficients, int64_t row, int64_t count, double length, array_double_2d hull) {
double power, binomial;
int64_t i, r, j;
power = 1.0;
binomial = 1.0;
for (i = 0; i < count; i += 1) {
*cspan_at(&hull, 0, i) = *cspan_at(&coefficients, row, i) * power / binomial;
power = power * length;
binomial = binomial * (count - 1 - i) / (i + 1);
}
for (r = 1; r < count; r += 1) {
for (j = 0; j < count - r; j += 1) {
i = count - 1 - j;
*cspan_at(&hull, 0, i) = *cspan_at(&hull, 0, i) + *cspan_at(&hull, 0, i - 1);
}
}
}
static double integrate_hull(int64_t count, double start, double length, array_double_1d values) {
double value, step, gain, largest;
int64_t i;
value = start;
largest = fabs(start);
step = length / span_max_int(count, 1);
for (i = 0; i < count; i += 1) {
gain = step * *cspan_at(&values, i);
*cspan_at(&values, i) = value;
value = value + gain;
largest = span_max(largest, fabs(value));
}
*cspan_at(&values, count) = value;
return largest;
}
static void split_hull(array_double_2d hull, int64_t row, int64_t count) {
int64_t i, r;
for (i = 0; i < count; i += 1) {
*cspan_at(&hull, row + 1, i) = *cspan_at(&hull, row, i);
}
for (r = 1; r < count; r += 1) {
for (i = 0; i < count - r; i += 1) {
*cspan_at(&hull, row + 1, i) = 0.5 * (*cspan_at(&hull, row + 1, i) + *cspan_at(&hull, row + 1, i + 1));
}
*cspan_at(&hull, row, r) = *cspan_at(&hull, row + 1, 0);
}
}
static bool within(array_double_2d hull, int64_t count, double lowest, double highest) {
int64_t rows, row, i;
bool inside, ends;
double depth, last;
rows = 1;
*cspan_at(&hull, 0, 13) = 0.0;
while(rows > 0) {
row = rows - 1;
inside = 1;
for (i = 0; i < count; i += 1) {
inside = inside && (lowest <= *cspan_at(&hull, row, i)) && (*cspan_at(&hull, row, i) <= highest);
}
if (inside) {
rows = rows - 1;
continue;
}
depth = *cspan_at(&hull, row, 13);
last = *cspan_at(&hull, row, count - 1);
ends = (lowest <= *cspan_at(&hull, row, 0)) && (*cspan_at(&hull, row, 0) <= highest);
ends = ends && (lowest <= last) && (last <= highest);
if ((!ends) || (depth > 34.0)) {
return 0;
}
split_hull(hull, row, count);
*cspan_at(&hull, row, 13) = depth + 1.0;
*cspan_at(&hull, row + 1, 13) = depth + 1.0;
rows = rows + 1;
}
return 1;
}
static double least_peak(int64_t order, array_double_1d limits) {
double below, limit, before;
int64_t i;
below = *cspan_at(&limits, 0);
limit = *cspan_at(&limits, 0);
for (i = 1; i < order; i += 1) {
before = limit;
limit = *cspan_at(&limits, i);
if (limit <= 0.0) {
limit = before * before / below;
}
below = before;
}
return 1e-05 * limit;
}
static double least_distance(array_double_1d limits) {
double scale, ramp, square;
int64_t order;
scale = *cspan_at(&limits, 0) * *cspan_at(&limits, 0) / *cspan_at(&limits, 1);
ramp = 0.0;
for (order = 2; order < span_min_int(limits.shape[0], 4); order += 1) {
if (*cspan_at(&limits, order) > 0.0) {
square = *cspan_at(&limits, 1) / *cspan_at(&limits, order);
if (order == 2) {
square = square * square;
}
ramp = span_max(ramp, *cspan_at(&limits, 1) * square);
}
}
if (ramp > 0.0) {
scale = span_min(scale, 1000.0 * ramp);
}
return 1e-09 * scale;
}
static double reached_limit(int64_t order, double duration, array_double_1d limits) {
int64_t j;
double change, reached;
reached = 0.0;
for (j = 0; j < limits.shape[0] - order + 1; j += 1) {
change = reached * duration;
reached = *cspan_at(&limits, limits.shape[0] - 1 - j);
if ((reached <= 0.0) || ((change > 0.0) && (change < reached))) {
reached = change;
}
}
return reached;
}
double segfmu_state_scale(int64_t order, double duration, array_double_1d limits) {
double result;
if (order == 0) {
result = reached_limit(1, duration, limits) * duration + least_distance(limits);
return result;
}
result = span_max(least_peak(order, limits), reached_limit(order, duration, limits));
return result;
}
static double rounding_error(int64_t order, array_double_1d limits) {
double result;
result = 4e-10 * least_peak(order, limits);
return result;
}
static void keep_inside(array_double_2d work) {
int64_t i;
for (i = 0; i < 27; i += 1) {
*cspan_at(&work, 47, i) = 0.0;
}
}
static void set_bounds(double middle, array_double_1d limits, array_double_1d lower, array_double_2d work) {
array_double_1d report;
int64_t d;
double lowest, highest;
report = span_row(&work, 47);
for (d = 1; d < limits.shape[0] + 1; d += 1) {
lowest = -*cspan_at(&limits, d - 1);
highest = *cspan_at(&limits, d - 1);
if ((d <= 2) && (*cspan_at(&lower, d - 1) > 0.0)) {
lowest = -*cspan_at(&lower, d - 1);
}
if ((highest > 0.0) && (middle < *cspan_at(&report, 0))) {
lowest = span_min(lowest, *cspan_at(&report, 11 + d));
highest = span_max(highest, *cspan_at(&report, 19 + d));
}
*cspan_at(&work, 45, d) = lowest;
*cspan_at(&work, 46, d) = highest;
}
}
static void note_ends(int64_t d, bool joined, double start, double end, double largest, array_double_2d work) {
double jump;
*cspan_at(&work, 41, d) = span_max(*cspan_at(&work, 41, d), largest);
if (joined) {
jump = fabs(start - *cspan_at(&work, 40, d));
*cspan_at(&work, 42, d) = span_max(*cspan_at(&work, 42, d), jump);
}
*cspan_at(&work, 40, d) = end;
}
static bool check_piece(int64_t order, int64_t row, bool joined, double length, array_double_2d coefficients, double tolerance, array_double_2d work) {
array_double_1d values, starts;
int64_t degree, d, count, i;
double factorial, start, largest, lowest, highest, share;
array_double_2d hull;
values = span_row(&work, 43);
degree = coefficients.shape[1] - 1;
while((degree > 0) && (*cspan_at(&coefficients, row, degree) == 0.0)) {
degree = degree - 1;
}
for (d = degree + 1; d < order + 1; d += 1) {
note_ends(d, joined, 0.0, 0.0, 0.0, work);
}
starts = span_row(&work, 44);
factorial = 1.0;
for (d = 0; d < degree + 1; d += 1) {
if (d > 1) {
factorial = factorial * d;
}
*cspan_at(&starts, d) = *cspan_at(&coefficients, row, d) * factorial;
}
for (count = 0; count < degree + 1; count += 1) {
d = degree - count;
start = *cspan_at(&starts, d);
largest = integrate_hull(count, start, length, values);
if (!(fabs(*cspan_at(&values, count)) < 1e+300)) {
return 0;
}
if (d <= order) {
note_ends(d, joined, start, *cspan_at(&values, count), largest, work);
lowest = *cspan_at(&work, 45, d);
highest = *cspan_at(&work, 46, d);
if ((d > 0) && (highest > 0.0)) {
if (largest > span_min(-lowest, highest) * (1.0 + tolerance)) {
hull = span_rows(&work, 0, 40);
for (i = 0; i < count + 1; i += 1) {
*cspan_at(&hull, 0, i) = *cspan_at(&values, i);
}
share = 1.0 + tolerance;
if (!within(hull, count + 1, lowest * share, highest * share)) {
return 0;
}
}
}
}
}
return 1;
}
static bool check_axis(int64_t first, int64_t last, array_double_2d timing, array_double_2d coefficients, array_double_1d limits, array_double_1d lower, double tolerance, double joints, array_double_2d work) {
int64_t order, i, row, d;
double low, high, length, middle, least;
bool result;
order = limits.shape[0];
for (i = 0; i < 14; i += 1) {
*cspan_at(&work, 41, i) = 0.0;
*cspan_at(&work, 42, i) = 0.0;
}
low = *cspan_at(&coefficients, first, 0);
high = low;
for (row = first; row < last; row += 1) {
low = span_min(low, *cspan_at(&coefficients, row, 0));
high = span_max(high, *cspan_at(&coefficients, row, 0));
length = *cspan_at(&timing, row, 1);
middle = *cspan_at(&timing, row, 0) + 0.5 * length;
set_bounds(middle, limits, lower, work);
if (!check_piece(order, row, row > first, length, coefficients, tolerance, work)) {
return 0;
}
}
low = span_min(low, *cspan_at(&work, 40, 0));
high = span_max(high, *cspan_at(&work, 40, 0));
least = least_distance(limits);
*cspan_at(&work, 41, 0) = span_max(span_max(high - low, least), 1e-05 * span_max(-low, high));
for (d = 1; d < order; d += 1) {
*cspan_at(&work, 41, d) = span_max(*cspan_at(&work, 41, d), least_peak(d, limits));
}
for (d = 0; d < order; d += 1) {
if (!(*cspan_at(&work, 42, d) <= joints * *cspan_at(&work, 41, d))) {
return 0;
}
}
result = *cspan_at(&work, 41, 0) < 1e+300;
return result;
}
static double switching_time(double time, double duration, array_double_2d timing, int64_t row) {
double length, same, local;
length = *cspan_at(&timing, row, 1);
local = local_time(time, timing, row);
same = 1e-12 * duration;
if (local < length - local) {
if (local < same) {
local = 0.0;
}
}
else if (local > length - same) {
local = length;
}
return local;
}
static bool check_motion(int64_t axis, array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, double tolerance, double joints, array_double_2d work) {
int64_t width, points, first, last, j, point, row, d;
double duration, local, value, scale;
width = coefficients.shape[1];
points = states.shape[0];
first = *cspan_at(&offsets, axis);
last = *cspan_at(&offsets, axis + 1);
if (!check_axis(first, last, timing, coefficients, span_row(&limits, axis), span_row(&lower, axis), tolerance, joints, work)) {
return 0;
}
duration = *cspan_at(&times, points, axis) - *cspan_at(&times, 0, axis);
for (j = 0; j < points + 1; j += 1) {
point = span_min_int(j, points - 1);
row = find_piece(*cspan_at(&times, j, axis), timing, first, last);
local = switching_time(*cspan_at(&times, j, axis), *cspan_at(&times, points, axis), timing, row);
for (d = 0; d < span_min_int(states.shape[2], limits.shape[1]); d += 1) {
value = evaluate_piece(coefficients, row, width, local, d);
scale = *cspan_at(&work, 41, d);
if ((d > 0) && (*cspan_at(&limits, axis, d - 1) > 0.0)) {
scale = span_max(scale, segfmu_state_scale(d, duration, span_row(&limits, axis)));
}
if (!(fabs(value - *cspan_at(&states, point, axis, d)) <= joints * scale)) {
return 0;
}
}
}
return 1;
}
static int64_t check_plan(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, double tolerance, double joints, array_double_2d work) {
int64_t axis;
keep_inside(work);
for (axis = 0; axis < limits.shape[0]; axis += 1) {
if (!check_motion(axis, states, times, timing, coefficients, offsets, limits, lower, tolerance, joints, work)) {
return 1 + axis;
}
}
return 0;
}
static int64_t check_braked_plan(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, array_double_2d brakes, double tolerance, double joints, array_double_2d work) {
int64_t axis, i;
for (axis = 0; axis < limits.shape[0]; axis += 1) {
for (i = 0; i < 27; i += 1) {
*cspan_at(&work, 47, i) = *cspan_at(&brakes, axis, i);
}
if (!check_motion(axis, states, times, timing, coefficients, offsets, limits, lower, tolerance, joints, work)) {
return 1 + axis;
}
}
return 0;
}
static int64_t sum_range(double* result_0, double* result_1, int64_t axis, double share, double lean, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work) {
int64_t width, piece, i;
double least, most, second;
width = coefficients.shape[1];
least = 1e+300;
most = -1e+300;
for (piece = *cspan_at(&offsets, axis); piece < *cspan_at(&offsets, axis + 1); piece += 1) {
for (i = 0; i < width; i += 1) {
*cspan_at(&work, 1, i) = share * *cspan_at(&coefficients, piece, i);
}
for (i = 0; i < width - 2; i += 1) {
second = (i + 1) * (i + 2) * *cspan_at(&coefficients, piece, i + 2);
*cspan_at(&work, 1, i) = *cspan_at(&work, 1, i) + lean * second;
}
bernstein_coefficients(work, 1, width, *cspan_at(&timing, piece, 1), work);
for (i = 0; i < width; i += 1) {
least = span_min(least, *cspan_at(&work, 0, i));
most = span_max(most, *cspan_at(&work, 0, i));
}
}
(*result_0) = least;
(*result_1) = most;
return 0;
}
static double least_depth(void) {
return 1e-06;
}
static bool is_rope_easy(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work) {
double lowest, highest, least, most, pull, square, slope;
int64_t axis;
bool result;
sum_range(&lowest, &highest, 2, 1.0, 0.0, timing, coefficients, offsets, work);
sum_range(&least, &most, 2, 0.0, 1.0, timing, coefficients, offsets, work);
pull = *cspan_at(&bounds, 0) + span_min(least, 0.0);
if ((highest > -least_depth()) || (pull <= 0.0)) {
return 0;
}
square = 1.0;
for (axis = 0; axis < 2; axis += 1) {
sum_range(&least, &most, axis, 0.0, 1.0, timing, coefficients, offsets, work);
slope = span_max(-least, most) / pull;
square = square + slope * slope;
}
if ((*cspan_at(&bounds, 2) > 0.0) && ((-lowest) * sqrt(square) > *cspan_at(&bounds, 2))) {
return 0;
}
result = -highest >= *cspan_at(&bounds, 1);
return result;
}
static double interval_end(double time, array_double_2d timing, array_int64_t_1d offsets) {
int64_t axis, last, row;
double end, until;
until = time;
for (axis = 0; axis < 3; axis += 1) {
last = *cspan_at(&offsets, axis + 1);
row = find_piece(time, timing, *cspan_at(&offsets, axis), last);
end = *cspan_at(&timing, row, 0) + *cspan_at(&timing, row, 1);
if (row + 1 < last) {
end = *cspan_at(&timing, row + 1, 0);
}
if ((end > time) && ((until == time) || (end < until))) {
until = end;
}
}
return until;
}
static void interval_pieces(double time, double until, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work) {
int64_t width, axis, last, row, i;
double middle;
array_double_1d piece;
width = coefficients.shape[1];
middle = 0.5 * (time + until);
for (axis = 0; axis < 3; axis += 1) {
last = *cspan_at(&offsets, axis + 1);
row = find_piece(middle, timing, *cspan_at(&offsets, axis), last);
piece = span_row(&work, 0 + axis);
for (i = 0; i < width; i += 1) {
*cspan_at(&piece, i) = *cspan_at(&coefficients, row, i);
}
if (middle > *cspan_at(&timing, row, 0) + *cspan_at(&timing, row, 1)) {
*cspan_at(&piece, 0) = evaluate_piece(coefficients, row, width, *cspan_at(&timing, row, 1), 0);
for (i = 1; i < width; i += 1) {
*cspan_at(&piece, i) = 0.0;
}
}
else {
polynomial_shift(piece, time - *cspan_at(&timing, row, 0), width);
}
}
rope_pull(gravity, width, work);
}
static double demand_bound(int64_t demand, array_double_1d bounds) {
double result;
if (demand == 2) {
result = *cspan_at(&bounds, 0);
return result;
}
if (demand == 3) {
result = *cspan_at(&bounds, 2);
return result;
}
if (demand == 4) {
result = *cspan_at(&bounds, 1);
return result;
}
return -least_depth();
}
static int64_t rope_demand(int64_t demand, array_double_1d bounds, int64_t width, array_double_2d work) {
double tolerance, bound;
int64_t result;
tolerance = 1e-09;
bound = demand_bound(demand, bounds);
if (demand == 1) {
result = rope_margin(demand, -bound, width, work);
return result;
}
if (demand == 2) {
result = rope_margin(demand, tolerance * bound, width, work);
return result;
}
if (bound <= 0.0) {
return 0;
}
if (demand == 3) {
result = rope_margin(demand, bound * (1.0 + tolerance), width, work);
return result;
}
result = rope_margin(demand, bound * (1.0 - tolerance), width, work);
return result;
}
static double first_negative(int64_t count, double length, array_double_2d work) {
int64_t start, depth, i, rows, row;
array_double_2d hull;
double swapped, smallest, result;
start = work.shape[1] - 2;
depth = work.shape[1] - 1;
hull = span_rows(&work, 10, work.shape[0]);
bernstein_coefficients(work, 6, count, length, hull);
for (i = 0; i < span_floor_div(count, 2); i += 1) {
swapped = *cspan_at(&hull, 0, i);
*cspan_at(&hull, 0, i) = *cspan_at(&hull, 0, count - 1 - i);
*cspan_at(&hull, 0, count - 1 - i) = swapped;
}
*cspan_at(&hull, 0, start) = 0.0;
*cspan_at(&hull, 0, depth) = 0.0;
rows = 1;
while(rows > 0) {
row = rows - 1;
smallest = *cspan_at(&hull, row, 0);
for (i = 1; i < count; i += 1) {
smallest = span_min(smallest, *cspan_at(&hull, row, i));
}
if (smallest >= 0.0) {
rows = row;
}
else if ((*cspan_at(&hull, row, count - 1) < 0.0) || (*cspan_at(&hull, row, depth) > 39.5)) {
result = *cspan_at(&hull, row, start);
return result;
}
else {
split_hull(hull, row, count);
*cspan_at(&hull, row + 1, start) = *cspan_at(&hull, row, start);
*cspan_at(&hull, row, depth) = *cspan_at(&hull, row, depth) + 1.0;
*cspan_at(&hull, row + 1, depth) = *cspan_at(&hull, row, depth);
*cspan_at(&hull, row, start) = *cspan_at(&hull, row, start) + pow(0.5, *cspan_at(&hull, row, depth));
rows = rows + 1;
}
}
return -1.0;
}
static double value_at(int64_t demand, double local, double gravity, int64_t width, array_double_2d work) {
double z, w_x, w_y, w_z;
z = evaluate_piece(work, 0 + 2, width, local, 0);
w_x = evaluate_piece(work, 3, width - 2, local, 0);
w_y = evaluate_piece(work, 3 + 1, width - 2, local, 0);
w_z = evaluate_piece(work, 3 + 2, width - 2, local, 0);
return rope_value(demand, gravity, z, w_x, w_y, w_z);
}
static double worst_value(int64_t demand, double first, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work) {
double gravity, sign, worst, time, until, local;
int64_t width, intervals, i;
gravity = *cspan_at(&bounds, 0);
width = coefficients.shape[1];
sign = 1.0;
if (demand == 4) {
sign = -1.0;
}
worst = -1e+300;
time = (*cspan_at(&timing, *cspan_at(&offsets, 0), 0));
until = interval_end(time, timing, offsets);
intervals = 0;
while((until > time) || (intervals == 0)) {
intervals = intervals + 1;
if (until >= first) {
interval_pieces(time, until, timing, coefficients, offsets, gravity, work);
for (i = 0; i < 33; i += 1) {
local = span_max((until - time) * i / 32.0, first - time);
worst = span_max(worst, sign * value_at(demand, local, gravity, width, work));
}
}
time = until;
until = interval_end(time, timing, offsets);
}
return sign * worst;
}
int64_t segfmu_check_rope(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work, array_double_1d report) {
int64_t none, intervals, demand, count, failed;
double time, until, share;
if (is_rope_easy(timing, coefficients, offsets, bounds, work)) {
return 0;
}
none = 4 + 1;
time = (*cspan_at(&timing, *cspan_at(&offsets, 0), 0));
until = interval_end(time, timing, offsets);
failed = none;
intervals = 0;
while((until > time) || (intervals == 0)) {
intervals = intervals + 1;
interval_pieces(time, until, timing, coefficients, offsets, *cspan_at(&bounds, 0), work);
for (demand = 1; demand < failed; demand += 1) {
count = rope_demand(demand, bounds, coefficients.shape[1], work);
if (count > 0) {
share = first_negative(count, until - time, work);
if (share >= 0.0) {
failed = demand;
*cspan_at(&report, 0) = time + share * (until - time);
break;
}
}
}
time = until;
until = interval_end(time, timing, offsets);
}
if (failed == none) {
return 0;
}
*cspan_at(&report, 1) = worst_value(failed, *cspan_at(&report, 0), timing, coefficients, offsets, bounds, work);
*cspan_at(&report, 2) = demand_bound(failed, bounds);
return failed;
}
static void write_row(int64_t source, int64_t count, double length, int64_t row, array_double_2d work, array_double_2d span) {
int64_t columns, i;
array_double_2d part;
columns = span.shape[1];
part = span_rows(&span, row, row + 1);
for (i = 0; i < columns; i += 1) {
*cspan_at(&work, 6, i) = 0.0;
}
for (i = 0; i < count; i += 1) {
*cspan_at(&work, 6, i) = *cspan_at(&work, source, i);
}
bernstein_coefficients(work, 6, columns, length, part);
}
static void begin_span(double time, double until, int64_t width, array_double_2d work, array_double_2d span) {
double place;
int64_t axis, i, row;
place = 0.0;
for (axis = 0; axis < 3; axis += 1) {
write_row(0 + axis, width, until - time, 0 + axis, work, span);
for (i = 0; i < span.shape[1]; i += 1) {
place = span_max(place, fabs(*cspan_at(&span, 0 + axis, i)));
}
}
for (row = 3; row < 9; row += 1) {
for (i = 0; i < span.shape[1]; i += 1) {
*cspan_at(&span, row, i) = 0.0;
}
}
*cspan_at(&span, 9, 0) = time;
*cspan_at(&span, 9, 1) = until - time;
*cspan_at(&span, 9, 2) = 0.0;
*cspan_at(&span, 9, 3) = 0.0;
*cspan_at(&span, 9, 4) = 1e-12 * place;
}
static void write_span_pull(double gravity, array_double_2d work, array_double_2d span) {
double length, pull;
int64_t count, axis, i;
length = *cspan_at(&span, 9, 1);
count = span_floor_div((span.shape[1] - 1), 2);
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < count; i += 1) {
pull = *cspan_at(&work, 3 + axis, i);
*cspan_at(&work, 3 + axis, i) = pull / gravity;
}
write_row(3 + axis, count, length, 6 + axis, work, span);
}
}
static void write_difference(int64_t first, int64_t pull, int64_t second, int64_t other, double length, int64_t row, array_double_2d work, array_double_2d span) {
int64_t width, i;
array_double_1d product, taken;
width = span_floor_div((span.shape[1] + 3), 2);
product = span_row(&work, 7);
taken = span_row(&work, 7 + 1);
polynomial_clear(product);
polynomial_clear(taken);
polynomial_add_product(span_row(&work, 0 + first), width, span_row(&work, 3 + pull), width - 2, product);
polynomial_add_product(span_row(&work, 0 + second), width, span_row(&work, 3 + other), width - 2, taken);
for (i = 0; i < 2 * width - 3; i += 1) {
*cspan_at(&product, i) = *cspan_at(&product, i) - *cspan_at(&taken, i);
}
write_row(7, 2 * width - 3, length, row, work, span);
}
static void write_span_products(array_double_2d work, array_double_2d span) {
double length, pull, place;
int64_t axis, i;
length = *cspan_at(&span, 9, 1);
for (axis = 0; axis < 2; axis += 1) {
write_difference(axis, 2, 2, axis, length, 3 + axis, work, span);
}
write_difference(0, 1, 1, 0, length, 5, work, span);
pull = 0.0;
for (axis = 0; axis < 2; axis += 1) {
for (i = 0; i < span.shape[1]; i += 1) {
pull = span_max(pull, fabs(*cspan_at(&span, 6 + axis, i)));
}
}
place = 1000000000000.0 * *cspan_at(&span, 9, 4);
*cspan_at(&span, 9, 3) = 1e-14 * place * pull;
}
int64_t segfmu_clearance_spans(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work, array_double_3d spans) {
double time, until;
array_double_2d span;
int64_t count;
count = 0;
time = (*cspan_at(&timing, *cspan_at(&offsets, 0), 0));
until = interval_end(time, timing, offsets);
while((until > time) || (count == 0)) {
span = span_matrix(&spans, count);
interval_pieces(time, until, timing, coefficients, offsets, gravity, work);
begin_span(time, until, coefficients.shape[1], work, span);
write_span_pull(gravity, work, span);
write_span_products(work, span);
count = count + 1;
time = until;
until = interval_end(time, timing, offsets);
}
return count;
}
static void halve_span(int64_t row, array_double_3d stack) {
int64_t count, k, r, i;
array_double_2d span, first;
double half;
count = stack.shape[2];
span = span_matrix(&stack, row);
first = span_matrix(&stack, row + 1);
for (k = 0; k < 9; k += 1) {
for (r = 0; r < count; r += 1) {
*cspan_at(&first, k, r) = *cspan_at(&span, k, 0);
for (i = 0; i < count - 1 - r; i += 1) {
*cspan_at(&span, k, i) = 0.5 * (*cspan_at(&span, k, i) + *cspan_at(&span, k, i + 1));
}
}
}
half = 0.5 * *cspan_at(&span, 9, 1);
*cspan_at(&first, 9, 0) = *cspan_at(&span, 9, 0);
*cspan_at(&span, 9, 0) = *cspan_at(&span, 9, 0) + half;
*cspan_at(&span, 9, 2) = *cspan_at(&span, 9, 2) + 1.0;
for (i = 2; i < 4 + 1; i += 1) {
*cspan_at(&first, 9, i) = *cspan_at(&span, 9, i);
}
*cspan_at(&span, 9, 1) = half;
*cspan_at(&first, 9, 1) = half;
}
static int64_t part_meeting(int64_t part, array_double_2d span, array_double_1d box) {
int64_t result;
if (part == 1) {
result = load_meeting(span, box);
return result;
}
result = rope_meeting(span, box);
return result;
}
static void note_place(int64_t part, array_double_2d span, array_double_1d box, array_double_1d place) {
int64_t axis;
double upwards, height, rope;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&place, axis) = *cspan_at(&span, 0 + axis, 0);
}
upwards = *cspan_at(&span, 6 + 2, 0);
if ((part == 2) && (upwards > 0.0)) {
height = shared_height(0.0, span, box);
for (axis = 0; axis < 2; axis += 1) {
rope = *cspan_at(&span, 3 + axis, 0) + height * *cspan_at(&span, 6 + axis, 0);
*cspan_at(&place, axis) = rope / upwards;
}
*cspan_at(&place, 2) = height;
}
}
static int64_t note_time(int64_t found, array_double_2d span, array_double_2d times) {
double begin, end;
int64_t rows;
begin = *cspan_at(&span, 9, 0);
end = begin + *cspan_at(&span, 9, 1);
rows = times.shape[0];
if ((0 < found) && (found <= rows) && (begin <= *cspan_at(&times, found - 1, 1) + 1e-11 * end)) {
*cspan_at(&times, found - 1, 1) = end;
return found;
}
if (found < rows) {
*cspan_at(&times, found, 0) = begin;
*cspan_at(&times, found, 1) = end;
}
return found + 1;
}
static int64_t halved_contacts(int64_t part, int64_t found, array_double_1d box, array_double_3d stack, array_double_2d times, array_double_1d place) {
int64_t rows, halvings, meeting;
array_double_2d span;
bool deep;
rows = 1;
halvings = 0;
while(rows > 0) {
span = span_matrix(&stack, rows - 1);
meeting = part_meeting(part, span, box);
deep = *cspan_at(&span, 9, 2) > 39.5;
if ((meeting == 2) && (!deep) && (halvings < 20000) && part_moves(part, span)) {
halve_span(rows - 1, stack);
rows = rows + 1;
halvings = halvings + 1;
continue;
}
rows = rows - 1;
if (meeting == 0) {
if ((found > 0) && (times.shape[0] == 1)) {
return found;
}
continue;
}
if (found == 0) {
note_place(part, span, box, place);
}
found = note_time(found, span, times);
}
return found;
}
static int64_t span_contacts(int64_t part, int64_t found, array_double_1d box, array_double_2d span, array_double_3d stack, array_double_2d times, array_double_1d place) {
int64_t k, i, result;
if (part_meeting(part, span, box) == 0) {
return found;
}
for (k = 0; k < 10; k += 1) {
for (i = 0; i < span.shape[1]; i += 1) {
*cspan_at(&stack, 0, k, i) = *cspan_at(&span, k, i);
}
}
result = halved_contacts(part, found, box, stack, times, place);
return result;
}
int64_t segfmu_contact_times(int64_t part, double until, int64_t count, array_double_1d box, array_double_3d spans, array_double_3d stack, array_double_2d times, array_double_1d place) {
int64_t row, found;
array_double_2d span;
found = 0;
for (row = 0; row < count; row += 1) {
span = span_matrix(&spans, row);
if ((*cspan_at(&span, 9, 0) >= until) || (found > times.shape[0])) {
break;
}
found = span_contacts(part, found, box, span, stack, times, place);
}
return found;
}
static void write_room(int64_t side, int64_t row, double local, double low, double high, array_double_2d coefficients, array_double_2d work) {
double sign, edge;
int64_t width, i;
sign = 1.0;
edge = high;
if (side == 1) {
sign = -1.0;
edge = low;
}
width = coefficients.shape[1];
for (i = 0; i < width; i += 1) {
*cspan_at(&work, 6, i) = *cspan_at(&coefficients, row, i);
}
polynomial_shift(span_row(&work, 6), local, width);
for (i = 0; i < width; i += 1) {
*cspan_at(&work, 6, i) = (-sign) * *cspan_at(&work, 6, i);
}
*cspan_at(&work, 6, 0) = *cspan_at(&work, 6, 0) + sign * edge;
}
static double greatest_lack(int64_t count, double length, double known, array_double_2d work) {
int64_t depth, rows, row, i;
array_double_2d hull;
double most;
depth = work.shape[1] - 1;
hull = span_rows(&work, 10, work.shape[0]);
bernstein_coefficients(work, 6, count, length, hull);
*cspan_at(&hull, 0, depth) = 0.0;
rows = 1;
while(rows > 0) {
row = rows - 1;
most = 0.0;
for (i = 0; i < count; i += 1) {
most = span_max(most, -*cspan_at(&hull, row, i));
}
known = span_max(known, span_max(-*cspan_at(&hull, row, 0), -*cspan_at(&hull, row, count - 1)));
if ((most <= known * (1.0 + 1e-09)) || (*cspan_at(&hull, row, depth) > 39.5)) {
rows = row;
}
else {
split_hull(hull, row, count);
*cspan_at(&hull, row, depth) = *cspan_at(&hull, row, depth) + 1.0;
*cspan_at(&hull, row + 1, depth) = *cspan_at(&hull, row, depth);
rows = rows + 1;
}
}
return known;
}
bool segfmu_leaves_range(int64_t axis, double begin, double end, double low, double high, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_1d excursion) {
double small, start, length, local, share, beyond;
int64_t row, side;
bool found;
small = 1e-06 * (high - low);
for (row = 0; row < coefficients.shape[0]; row += 1) {
small = span_max(small, 1e-09 * fabs(*cspan_at(&coefficients, row, 0)));
}
found = 0;
*cspan_at(&excursion, 2) = 0.0;
for (row = *cspan_at(&offsets, axis); row < *cspan_at(&offsets, axis + 1); row += 1) {
start = span_max(begin, *cspan_at(&timing, row, 0));
length = span_min(end, *cspan_at(&timing, row, 0) + *cspan_at(&timing, row, 1)) - start;
if (length > 0.0) {
local = start - *cspan_at(&timing, row, 0);
share = 2.0;
for (side = 0; side < 2; side += 1) {
write_room(side, row, local, low - small, high + small, coefficients, work);
beyond = first_negative(coefficients.shape[1], length, work);
if (beyond >= 0.0) {
share = span_min(share, beyond);
}
}
if ((share < 1.5) && (!found)) {
found = 1;
*cspan_at(&excursion, 3) = start + share * length;
}
if (share < 1.5) {
for (side = 0; side < 2; side += 1) {
write_room(side, row, local, low, high, coefficients, work);
*cspan_at(&excursion, 2) = greatest_lack(coefficients.shape[1], length, *cspan_at(&excursion, 2), work);
}
}
}
}
return found;
}
int64_t segfmu_path_excursion(array_double_2d led, array_double_2d positions, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_1d excursion) {
int64_t interval, axis;
double one, other;
bool free;
for (interval = 0; interval < led.shape[0] - 1; interval += 1) {
for (axis = 0; axis < led.shape[1]; axis += 1) {
one = *cspan_at(&positions, interval, axis);
other = *cspan_at(&positions, interval + 1, axis);
free = *cspan_at(&led, interval, axis) + *cspan_at(&led, interval + 1, axis) > 0.5;
if (free && segfmu_leaves_range(axis, *cspan_at(&times, interval, axis), *cspan_at(&times, interval + 1, axis), span_min(one, other), span_max(one, other), timing, coefficients, offsets, work, excursion)) {
*cspan_at(&excursion, 0) = axis;
*cspan_at(&excursion, 1) = interval;
return 1;
}
}
}
return 0;
}
static void begin_range(int64_t axis, double least, double most, array_double_2d ranges) {
int64_t row;
for (row = 0; row < 4; row += 2) {
*cspan_at(&ranges, row, axis) = least;
*cspan_at(&ranges, row + 1, axis) = most;
}
}
static void widen_range(int64_t row, int64_t axis, double least, double most, array_double_2d ranges) {
*cspan_at(&ranges, row, axis) = span_min(*cspan_at(&ranges, row, axis), least);
*cspan_at(&ranges, row + 1, axis) = span_max(*cspan_at(&ranges, row + 1, axis), most);
}
static double lean_of(double pull, array_double_2d ranges) {
int64_t axis;
double result;
widen_range(2, 2, 0.0, 0.0, ranges);
if (pull <= 0.0) {
for (axis = 0; axis < 2; axis += 1) {
widen_range(2, axis, -1e+300, 1e+300, ranges);
}
return -1.0;
}
result = span_max(-*cspan_at(&ranges, 0, 2), 0.0) / pull;
return result;
}
void segfmu_path_ranges(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work, array_double_2d ranges) {
int64_t axis;
double least, most, lean;
for (axis = 0; axis < 3; axis += 1) {
sum_range(&least, &most, axis, 1.0, 0.0, timing, coefficients, offsets, work);
begin_range(axis, least, most, ranges);
}
sum_range(&least, &most, 2, 0.0, 1.0, timing, coefficients, offsets, work);
lean = lean_of(gravity + least, ranges);
if (lean < 0.0) {
return;
}
for (axis = 0; axis < 2; axis += 1) {
sum_range(&least, &most, axis, 1.0, lean, timing, coefficients, offsets, work);
widen_range(2, axis, least, most, ranges);
}
}
static int64_t row_bounds(double* result_0, double* result_1, int64_t row, int64_t count, double length, array_double_2d work) {
array_double_2d hull;
double least, most;
int64_t i;
hull = span_rows(&work, 6, 7);
bernstein_coefficients(work, row, count, length, hull);
least = *cspan_at(&hull, 0, 0);
most = least;
for (i = 1; i < count; i += 1) {
least = span_min(least, *cspan_at(&hull, 0, i));
most = span_max(most, *cspan_at(&hull, 0, i));
}
(*result_0) = least;
(*result_1) = most;
return 0;
}
static void span_ranges(double length, int64_t width, array_double_2d work, array_double_2d ranges) {
int64_t axis, i;
double least, most, pull, lean, ahead;
for (axis = 0; axis < 3; axis += 1) {
row_bounds(&least, &most, 0 + axis, width, length, work);
begin_range(axis, least, most, ranges);
}
row_bounds(&pull, &most, 3 + 2, width - 2, length, work);
lean = lean_of(pull, ranges);
if (lean < 0.0) {
return;
}
for (axis = 0; axis < 2; axis += 1) {
for (i = 0; i < width; i += 1) {
*cspan_at(&work, 7, i) = *cspan_at(&work, 0 + axis, i);
}
for (i = 0; i < width - 2; i += 1) {
ahead = lean * *cspan_at(&work, 3 + axis, i);
*cspan_at(&work, 7, i) = *cspan_at(&work, 7, i) + ahead;
}
row_bounds(&least, &most, 7, width, length, work);
widen_range(2, axis, least, most, ranges);
}
}
static bool is_near(int64_t part, array_double_1d box, array_double_2d ranges) {
int64_t low, high, row, axis;
low = 0;
high = 3;
row = 0;
if (part == 2) {
low = 6;
high = 9;
row = 2;
if (*cspan_at(&box, 12) < 0.5) {
return 0;
}
}
for (axis = 0; axis < 3; axis += 1) {
if ((*cspan_at(&ranges, row + 1, axis) <= *cspan_at(&box, low + axis)) || (*cspan_at(&ranges, row, axis) >= *cspan_at(&box, high + axis))) {
return 0;
}
}
return 1;
}
static bool is_any_near(int64_t part, array_double_2d boxes, array_double_2d ranges) {
int64_t number;
for (number = 0; number < boxes.shape[0]; number += 1) {
if (is_near(part, span_row(&boxes, number), ranges)) {
return 1;
}
}
return 0;
}
static double touch_distance(array_double_2d ranges) {
double largest;
int64_t axis;
largest = 0.0;
for (axis = 0; axis < 3; axis += 1) {
largest = span_max(largest, fabs(*cspan_at(&ranges, 0, axis)));
largest = span_max(largest, fabs(*cspan_at(&ranges, 1, axis)));
}
return 1e-09 * largest;
}
static void shrink_box(double touch, int64_t low, int64_t high, array_double_1d box) {
int64_t axis;
double edge;
for (axis = 0; axis < 3; axis += 1) {
edge = span_min(touch, 0.25 * (*cspan_at(&box, high + axis) - *cspan_at(&box, low + axis)));
*cspan_at(&box, low + axis) = *cspan_at(&box, low + axis) + edge;
*cspan_at(&box, high + axis) = *cspan_at(&box, high + axis) - edge;
}
}
void segfmu_shrink_boxes(double touch, array_double_2d boxes) {
int64_t number;
for (number = 0; number < boxes.shape[0]; number += 1) {
shrink_box(touch, 0, 3, span_row(&boxes, number));
shrink_box(touch, 6, 9, span_row(&boxes, number));
}
}
static void prolong_contact(int64_t part, array_double_2d boxes, array_double_3d stack, array_double_2d ranges, array_double_1d report) {
array_double_2d times;
int64_t number;
times = span_rows(&ranges, 5, 5 + 1);
*cspan_at(&times, 0, 0) = *cspan_at(&report, 0);
*cspan_at(&times, 0, 1) = *cspan_at(&report, 1);
number = (int64_t)(*cspan_at(&report, 5));
span_contacts(part, 1, span_row(&boxes, number), span_matrix(&stack, 42), stack, times, span_row(&ranges, 4));
*cspan_at(&report, 1) = *cspan_at(&times, 0, 1);
}
static void note_first(int64_t part, array_double_2d boxes, array_double_3d stack, array_double_2d ranges, array_double_1d report) {
array_double_2d times;
array_double_1d place;
int64_t number, found, axis;
times = span_rows(&ranges, 5, 5 + 1);
place = span_row(&ranges, 4);
for (number = 0; number < boxes.shape[0]; number += 1) {
if (is_near(part, span_row(&boxes, number), ranges)) {
found = span_contacts(part, 0, span_row(&boxes, number), span_matrix(&stack, 42), stack, times, place);
if ((found > 0) && (*cspan_at(&times, 0, 0) < *cspan_at(&report, 0))) {
*cspan_at(&report, 0) = *cspan_at(&times, 0, 0);
*cspan_at(&report, 1) = *cspan_at(&times, 0, 1);
*cspan_at(&report, 5) = number;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&report, 2 + axis) = *cspan_at(&place, axis);
}
}
}
}
}
int64_t segfmu_first_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d boxes, array_double_2d work, array_double_3d stack, array_double_2d ranges, array_double_1d report) {
double time, until;
bool lasts, begun, ended;
array_double_2d span;
int64_t part;
segfmu_shrink_boxes(touch_distance(ranges), boxes);
if ((!is_any_near(1, boxes, ranges)) && (!is_any_near(2, boxes, ranges))) {
return 0;
}
for (part = 1; part < 2 + 1; part += 1) {
*cspan_at(&report, 0) = 1e+300;
time = (*cspan_at(&timing, *cspan_at(&offsets, 0), 0));
until = interval_end(time, timing, offsets);
lasts = 1;
while(lasts) {
begun = *cspan_at(&report, 0) < 1e+300;
interval_pieces(time, until, timing, coefficients, offsets, gravity, work);
span_ranges(until - time, coefficients.shape[1], work, ranges);
if (begun || is_any_near(part, boxes, ranges)) {
span = span_matrix(&stack, 42);
begin_span(time, until, coefficients.shape[1], work, span);
if (part == 2) {
write_span_pull(gravity, work, span);
write_span_products(work, span);
}
if (begun) {
prolong_contact(part, boxes, stack, ranges, report);
}
else {
note_first(part, boxes, stack, ranges, report);
}
}
ended = (*cspan_at(&report, 0) < 1e+300) && (*cspan_at(&report, 1) < until * (1 - 1e-11));
time = until;
until = interval_end(time, timing, offsets);
lasts = (until > time) && (!ended);
}
if (*cspan_at(&report, 0) < 1e+300) {
return part;
}
}
return 0;
}
void segfmu_write_box(array_double_1d space, array_double_1d obstacle, array_double_1d box) {
int64_t axis;
double low, high, half;
for (axis = 0; axis < 3; axis += 1) {
low = *cspan_at(&obstacle, 0 + axis) - *cspan_at(&obstacle, 6);
high = *cspan_at(&obstacle, 3 + axis) + *cspan_at(&obstacle, 6);
half = 0.5 * *cspan_at(&space, 7 + axis);
*cspan_at(&box, 0 + axis) = low - half - *cspan_at(&space, 10 + axis);
*cspan_at(&box, 3 + axis) = high + half - *cspan_at(&space, 10 + axis);
*cspan_at(&box, 6 + axis) = low;
*cspan_at(&box, 9 + axis) = high;
}
*cspan_at(&box, 12) = *cspan_at(&obstacle, 7);
}
static void write_faces(array_double_1d space, array_double_2d boxes) {
int64_t number, axis;
for (number = 0; number < 6; number += 1) {
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&boxes, number, 0 + axis) = -1e+30;
*cspan_at(&boxes, number, 3 + axis) = 1e+30;
*cspan_at(&boxes, number, 6 + axis) = -1e+30;
*cspan_at(&boxes, number, 9 + axis) = 1e+30;
}
*cspan_at(&boxes, number, 12) = 0.0;
axis = span_floor_div(number, 2);
if (span_floor_mod(number, 2) == 0) {
*cspan_at(&boxes, number, 3 + axis) = *cspan_at(&space, 1 + axis);
}
else {
*cspan_at(&boxes, number, 0 + axis) = *cspan_at(&space, 4 + axis);
}
}
}
static int64_t obstacle_count(array_double_1d space, array_double_2d obstacles) {
int64_t result;
result = span_min_int((int64_t)(*cspan_at(&space, 13)), obstacles.shape[0]);
return result;
}
static int64_t check_space(array_double_1d space, array_double_2d obstacles, array_double_1d fault) {
int64_t axis, number;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&fault, 6) = axis;
*cspan_at(&fault, 7) = *cspan_at(&space, 1 + axis);
*cspan_at(&fault, 8) = *cspan_at(&space, 4 + axis);
if (*cspan_at(&fault, 7) >= *cspan_at(&fault, 8)) {
return 4;
}
}
for (number = 0; number < obstacle_count(space, obstacles); number += 1) {
*cspan_at(&fault, 5) = number;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&fault, 6) = axis;
*cspan_at(&fault, 7) = *cspan_at(&obstacles, number, 0 + axis);
*cspan_at(&fault, 8) = *cspan_at(&obstacles, number, 3 + axis);
if (*cspan_at(&fault, 7) >= *cspan_at(&fault, 8)) {
return 5;
}
}
}
return 0;
}
int64_t segfmu_space_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d space, array_double_2d obstacles, array_double_2d boxes, array_double_2d work, array_double_3d stack, array_double_2d ranges, array_double_1d fault) {
int64_t status, count, number, part, axis;
array_double_2d used;
status = check_space(space, obstacles, fault);
if (status != 0) {
return status;
}
write_faces(space, boxes);
count = obstacle_count(space, obstacles);
for (number = 0; number < count; number += 1) {
segfmu_write_box(space, span_row(&obstacles, number), span_row(&boxes, 6 + number));
}
segfmu_path_ranges(timing, coefficients, offsets, *cspan_at(&space, 0), work, ranges);
used = span_rows(&boxes, 0, 6 + count);
part = segfmu_first_contact(timing, coefficients, offsets, *cspan_at(&space, 0), used, work, stack, ranges, fault);
if (part == 0) {
return 0;
}
number = (int64_t)(*cspan_at(&fault, 5));
*cspan_at(&fault, 9) = part;
if (number >= 6) {
*cspan_at(&fault, 5) = number - 6;
return part;
}
axis = span_floor_div(number, 2);
*cspan_at(&fault, 6) = axis;
*cspan_at(&fault, 7) = *cspan_at(&fault, 2 + axis);
*cspan_at(&fault, 8) = *cspan_at(&space, 1 + axis);
if (span_floor_mod(number, 2) == 1) {
*cspan_at(&fault, 8) = *cspan_at(&space, 4 + axis);
}
return 3;
}
void segfmu_crane_rhs(array_double_1d state, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative) {
double l, phi_x, phi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, f_x_t, f_y_t, f_l, f_phi_x, f_phi_y, w_x, w_y, w_z, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23, c24, c25, c26, c27, c28;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
x_t_rate = *cspan_at(&state, 5);
y_t_rate = *cspan_at(&state, 6);
l_rate = *cspan_at(&state, 7);
phi_x_rate = *cspan_at(&state, 8);
phi_y_rate = *cspan_at(&state, 9);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
f_x_t = *cspan_at(&generalized_force, 0);
f_y_t = *cspan_at(&generalized_force, 1);
f_l = *cspan_at(&generalized_force, 2);
f_phi_x = *cspan_at(&generalized_force, 3);
f_phi_y = *cspan_at(&generalized_force, 4);
w_x = *cspan_at(&load_force, 0);
w_y = *cspan_at(&load_force, 1);
w_z = *cspan_at(&load_force, 2);
c0 = 1 / (bridge_mass + trolley_mass);
c1 = sin(phi_x);
c2 = cos(phi_x);
c3 = 1 / l;
c4 = c3 * f_phi_x;
c5 = c1 * f_l + c2 * c4;
c6 = c5 - f_x_t;
c7 = sin(phi_y);
c8 = c2 * c7;
c9 = cos(phi_y);
c10 = c3 / c2;
c11 = c10 * f_phi_y;
c12 = c1 * c7;
c13 = c11 * c9 - c12 * c4 + c8 * f_l;
c14 = (c13 + f_y_t) / trolley_mass;
c15 = c2 * l_rate;
c16 = c1 * phi_x_rate;
c17 = c16 * l;
c18 = 1 / payload_mass;
c19 = (-c0) * c6 + c15 * phi_x_rate - c18 * (c5 + w_x) + phi_x_rate * ((-c17) + c2 * l_rate);
c20 = c8 * phi_y_rate;
c21 = c1 * l_rate;
c22 = c2 * c9;
c23 = l * phi_x_rate;
c24 = l * phi_y_rate;
c25 = c22 * phi_y_rate;
c26 = c1 * c9;
c27 = (-c18) * (c11 * c7 - c22 * f_l + c26 * c4 + w_z) + gravity + l_rate * (c16 * c9 + c20) + phi_x_rate * ((-c12) * c24 + c21 * c9 + c22 * c23) + phi_y_rate * (c15 * c7 - c17 * c7 + c25 * l);
c28 = c14 - c18 * ((-c13) + w_y) + l_rate * (c16 * c7 - c25) + phi_x_rate * (c21 * c7 + c23 * c8 + c24 * c26) + phi_y_rate * ((-c15) * c9 + c17 * c9 + c20 * l);
*cspan_at(&derivative, 0) = x_t_rate;
*cspan_at(&derivative, 1) = y_t_rate;
*cspan_at(&derivative, 2) = l_rate;
*cspan_at(&derivative, 3) = phi_x_rate;
*cspan_at(&derivative, 4) = phi_y_rate;
*cspan_at(&derivative, 5) = (-c0) * c6;
*cspan_at(&derivative, 6) = c14;
*cspan_at(&derivative, 7) = (-c1) * c19 + c22 * c27 + c28 * c8;
*cspan_at(&derivative, 8) = (-c3) * (c12 * c28 + c19 * c2 + c26 * c27);
*cspan_at(&derivative, 9) = c10 * ((-c27) * c7 + c28 * c9);
}
void segfmu_crane_driven(array_double_1d state, array_double_1d carriage, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative, array_double_1d force) {
double l, phi_x, phi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, a_x, a_y, a_l, f_phi_x, f_phi_y, w_x, w_y, w_z, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c30, c31, c32, c33, c34;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
x_t_rate = *cspan_at(&state, 5);
y_t_rate = *cspan_at(&state, 6);
l_rate = *cspan_at(&state, 7);
phi_x_rate = *cspan_at(&state, 8);
phi_y_rate = *cspan_at(&state, 9);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
a_x = *cspan_at(&carriage, 0);
a_y = *cspan_at(&carriage, 1);
a_l = *cspan_at(&carriage, 2);
f_phi_x = *cspan_at(&generalized_force, 3);
f_phi_y = *cspan_at(&generalized_force, 4);
w_x = *cspan_at(&load_force, 0);
w_y = *cspan_at(&load_force, 1);
w_z = *cspan_at(&load_force, 2);
c0 = 1 / (l * l);
c1 = 1 / payload_mass;
c2 = cos(phi_x);
c3 = sin(phi_x);
c4 = c3 * phi_x_rate;
c5 = c4 * l;
c6 = (-c2) * l_rate + c5;
c7 = c2 * l_rate;
c8 = a_l * c3 + a_x + c7 * phi_x_rate;
c9 = (-c1) * w_x + c8;
c10 = c2 * l;
c11 = sin(phi_y);
c12 = cos(phi_y);
c13 = c2 * phi_y_rate;
c14 = c3 * l_rate;
c15 = c10 * c11;
c16 = c3 * l;
c17 = c12 * phi_y_rate;
c18 = a_l * c2;
c19 = a_y - c11 * c18 + l_rate * (c11 * c4 - c12 * c13) + phi_x_rate * (c11 * c14 + c15 * phi_x_rate + c16 * c17) + phi_y_rate * (c12 * c5 - c12 * c7 + c15 * phi_y_rate);
c20 = (-c1) * w_y + c19;
c21 = c11 * c16;
c22 = c10 * c12;
c23 = (-c1) * w_z - c12 * c18 + gravity + l_rate * (c11 * c13 + c12 * c4) + phi_x_rate * (c12 * c14 - c21 * phi_y_rate + c22 * phi_x_rate) + phi_y_rate * (c10 * c17 - c11 * c5 + c11 * c7);
c24 = (-c1) * f_phi_x + c10 * ((-c6) * phi_x_rate + c9) + c12 * c16 * c23 + c20 * c21;
c25 = c1 * f_phi_y - c15 * c23 + c20 * c22;
c26 = (-c6) * phi_x_rate;
c27 = 1 / l;
c28 = c2 * c27;
c29 = c12 * c27;
c30 = c25 / c2;
c31 = (-c29) * c30;
c32 = c11 * c27;
c33 = c3 * c32;
c34 = -c24;
*cspan_at(&derivative, 0) = x_t_rate;
*cspan_at(&derivative, 1) = y_t_rate;
*cspan_at(&derivative, 2) = l_rate;
*cspan_at(&derivative, 3) = phi_x_rate;
*cspan_at(&derivative, 4) = phi_y_rate;
*cspan_at(&derivative, 5) = a_x;
*cspan_at(&derivative, 6) = a_y;
*cspan_at(&derivative, 7) = a_l;
*cspan_at(&derivative, 8) = (-c0) * c24;
*cspan_at(&derivative, 9) = c0 * c25 / (c2 * c2);
*cspan_at(&force, 0) = a_x * (bridge_mass + trolley_mass) + payload_mass * ((-c24) * c28 + c26 + c8) - w_x;
*cspan_at(&force, 1) = a_y * trolley_mass + payload_mass * (c19 - c24 * c33 + c31) - w_y;
*cspan_at(&force, 2) = payload_mass * ((-c11) * c2 * (c20 + c31 + c33 * c34) - c12 * c2 * (c23 + c29 * c3 * c34 + c30 * c32) + c3 * (c26 + c28 * c34 + c9));
}
void segfmu_crane_flat_inverse(array_double_2d flat, array_double_1d masses, array_double_1d force, array_double_1d state, array_double_1d acceleration) {
double p0x, p0y, p0z, p1x, p1y, p1z, p2x, p2y, p2z, p3x, p3y, p3z, p4x, p4y, p4z, bridge_mass, trolley_mass, payload_mass, gravity, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c40, c41, c42, c43, c44, c45, c46, c47, c48, c49, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c60, c61, c62, c63, c64, c65, c66, c67;
p0x = *cspan_at(&flat, 0, 0);
p0y = *cspan_at(&flat, 0, 1);
p0z = *cspan_at(&flat, 0, 2);
p1x = *cspan_at(&flat, 1, 0);
p1y = *cspan_at(&flat, 1, 1);
p1z = *cspan_at(&flat, 1, 2);
p2x = *cspan_at(&flat, 2, 0);
p2y = *cspan_at(&flat, 2, 1);
p2z = *cspan_at(&flat, 2, 2);
p3x = *cspan_at(&flat, 3, 0);
p3y = *cspan_at(&flat, 3, 1);
p3z = *cspan_at(&flat, 3, 2);
p4x = *cspan_at(&flat, 4, 0);
p4y = *cspan_at(&flat, 4, 1);
p4z = *cspan_at(&flat, 4, 2);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
c0 = gravity + p2z;
c1 = 1 / c0;
c2 = c1 * p0z;
c3 = c1 * p2z;
c4 = p0z * p4z;
c5 = c0 * c0;
c6 = 1 / c5;
c7 = c6 * p2x;
c8 = c1 * p3z;
c9 = c8 * p2x;
c10 = c1 * p1z;
c11 = c1 * (c8 * p0z - p1z);
c12 = p0z * p3x;
c13 = p1z * p2x;
c14 = c6 * p3z;
c15 = c10 * (c9 - p3x) + c11 * p3x + c14 * (c12 + c13 - 2 * c9 * p0z) - c2 * p4x - c3 * p2x + c4 * c7 + p2x;
c16 = p2y * p4z;
c17 = c6 * p0z;
c18 = p2y * p3z;
c19 = p0z * p3y;
c20 = p1z * p2y;
c21 = 2 * c18;
c22 = c10 * (c1 * c18 - p3y) + c11 * p3y + c14 * (c19 - c2 * c21 + c20) + c16 * c17 - c2 * p4y - c3 * p2y + p2y;
c23 = p2x * p2x;
c24 = p2y * p2y;
c25 = c24 + c5;
c26 = c23 + c25;
c27 = sqrt(c26);
c28 = sqrt(c25);
c29 = p0z * p2x;
c30 = c1 * c12;
c31 = (-c1) * c13 - c30;
c32 = c1 * c19;
c33 = (-c1) * c20 - c32;
c34 = 1 / c27;
c35 = c1 * c34;
c36 = c12 * p2x;
c37 = c19 * p2y;
c38 = c27 * c6;
c39 = c34 - c38;
c40 = p0z * p3z;
c41 = 1 / c26;
c42 = c28 * p3x;
c43 = 1 / c28;
c44 = c43 * p2y;
c45 = c44 * p3y;
c46 = c0 * c43;
c47 = c46 * p3z;
c48 = 1 / c25;
c49 = c35 * p2y;
c50 = c41 + c6;
c51 = c30 * c41;
c52 = c32 * c41;
c53 = p2x * p2y;
c54 = 1 / (c26 * sqrt(c26));
c55 = c44 * p2x;
c56 = c46 * p2x;
c57 = 2 * c41;
c58 = c42 * c57;
c59 = c23 * c57;
c60 = c43 * p2x;
c61 = c60 * p3y;
c62 = p2x / (c25 * sqrt(c25));
c63 = c0 * c18;
c64 = c60 * p3z;
c65 = c0 * p3y;
c66 = c65 * p2y;
c67 = 2 * c48;
*cspan_at(&force, 0) = c15 * (bridge_mass + trolley_mass) + p2x * payload_mass;
*cspan_at(&force, 1) = c22 * trolley_mass + p2y * payload_mass;
*cspan_at(&force, 2) = (-c27) * payload_mass;
*cspan_at(&state, 0) = (-c2) * p2x + p0x;
*cspan_at(&state, 1) = (-c2) * p2y + p0y;
*cspan_at(&state, 2) = (-c2) * c27;
*cspan_at(&state, 3) = atan2(-p2x, c28);
*cspan_at(&state, 4) = atan2(p2y, c0);
*cspan_at(&state, 5) = c14 * c29 + c31 + p1x;
*cspan_at(&state, 6) = c17 * c18 + c33 + p1y;
*cspan_at(&state, 7) = (-c10) * c27 - c35 * c36 - c35 * c37 - c39 * c40;
*cspan_at(&state, 8) = c41 * ((-c42) + c45 * p2x + c47 * p2x);
*cspan_at(&state, 9) = c48 * (c0 * p3y - c18);
*cspan_at(&acceleration, 0) = c15;
*cspan_at(&acceleration, 1) = c22;
*cspan_at(&acceleration, 2) = (-c27) * c3 - c29 * c35 * p4x + c34 * p3x * (c23 * c51 + c31 + c40 * c50 * p2x + c52 * c53) + c34 * p3y * (c18 * c50 * p0z + c24 * c52 + c33 + c51 * c53) - c39 * c4 - c49 * p0z * p4y - p1z * (c35 * p2x * p3x + c39 * p3z + c49 * p3y) + p3z * (c12 * c34 * c7 + c34 * c37 * c6 - c34 * p1z + c36 * c54 + c37 * c54 + c38 * p1z - c40 * ((-c0) * c54 - c35 + 2 * c27 / (c0 * c0 * c0)));
*cspan_at(&acceleration, 3) = c41 * ((-c28) * p4x + c55 * p4y + c56 * p4z + p3x * ((-c45) * c59 + c45 - c47 * c59 + c47 + c58 * p2x) - p3y * (c21 * c41 * c56 + c24 * c57 * c61 + c24 * c62 * p3y + c44 * p3x - c58 * p2y - c61 + c62 * c63) - p3z * ((-c0) * c58 + c46 * p3x + c5 * c57 * c64 + c5 * c62 * p3z + c55 * c57 * c65 + c62 * c66 - c64));
*cspan_at(&acceleration, 4) = c48 * (c0 * p4y - c16 - p3y * ((-c24) * c67 * p3z + c66 * c67 + p3z) + p3z * ((-c5) * c67 * p3y + c63 * c67 + p3y));
}
void segfmu_crane_load(array_double_1d state, array_double_2d load) {
double x_t, y_t, l, phi_x, phi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9;
x_t = *cspan_at(&state, 0);
y_t = *cspan_at(&state, 1);
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
x_t_rate = *cspan_at(&state, 5);
y_t_rate = *cspan_at(&state, 6);
l_rate = *cspan_at(&state, 7);
phi_x_rate = *cspan_at(&state, 8);
phi_y_rate = *cspan_at(&state, 9);
c0 = sin(phi_x);
c1 = c0 * l;
c2 = sin(phi_y);
c3 = cos(phi_x);
c4 = c3 * l;
c5 = c2 * c4;
c6 = cos(phi_y);
c7 = c4 * c6;
c8 = c3 * l_rate;
c9 = c1 * phi_x_rate;
*cspan_at(&load, 0, 0) = c1 + x_t;
*cspan_at(&load, 0, 1) = (-c5) + y_t;
*cspan_at(&load, 0, 2) = -c7;
*cspan_at(&load, 1, 0) = c0 * l_rate + c4 * phi_x_rate + x_t_rate;
*cspan_at(&load, 1, 1) = (-c2) * c8 + c2 * c9 - c7 * phi_y_rate + y_t_rate;
*cspan_at(&load, 1, 2) = c5 * phi_y_rate - c6 * c8 + c6 * c9;
}
void segfmu_crane_energy(array_double_1d state, array_double_1d masses, array_double_1d energy) {
double l, phi_x, phi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
x_t_rate = *cspan_at(&state, 5);
y_t_rate = *cspan_at(&state, 6);
l_rate = *cspan_at(&state, 7);
phi_x_rate = *cspan_at(&state, 8);
phi_y_rate = *cspan_at(&state, 9);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
c0 = x_t_rate * x_t_rate;
c1 = sin(phi_x);
c2 = cos(phi_x);
c3 = l * phi_x_rate;
c4 = cos(phi_y);
c5 = c2 * l_rate;
c6 = c1 * c3;
c7 = sin(phi_y);
c8 = c2 * l;
c9 = c8 * phi_y_rate;
c10 = c1 * l_rate + c2 * c3 + x_t_rate;
c11 = (-c4) * c5 + c4 * c6 + c7 * c9;
c12 = (-c4) * c9 - c5 * c7 + c6 * c7 + y_t_rate;
*cspan_at(&energy, 0) = 1.0 / 2.0 * bridge_mass * c0 + 1.0 / 2.0 * payload_mass * (c10 * c10 + c11 * c11 + c12 * c12) + 1.0 / 2.0 * trolley_mass * (c0 + y_t_rate * y_t_rate);
*cspan_at(&energy, 1) = (-c4) * c8 * gravity * payload_mass;
}
static double series_factorial(int64_t order) {
int64_t i;
double product;
product = 1.0;
for (i = 2; i < order + 1; i += 1) {
product = product * i;
}
return product;
}
static void series_of_derivatives(array_double_2d values, int64_t first, int64_t column, int64_t count, array_double_1d found) {
double scale;
int64_t i;
scale = 1.0;
for (i = 0; i < count; i += 1) {
if (i > 1) {
scale = scale * i;
}
*cspan_at(&found, i) = *cspan_at(&values, first + i, column) / scale;
}
}
static double series_derivative(array_double_1d a, int64_t order) {
double result;
result = series_factorial(order) * *cspan_at(&a, order);
return result;
}
static void series_sum(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found) {
int64_t i;
for (i = 0; i < count; i += 1) {
*cspan_at(&found, i) = *cspan_at(&a, i) + *cspan_at(&b, i);
}
}
static void series_difference(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found) {
int64_t i;
for (i = 0; i < count; i += 1) {
*cspan_at(&found, i) = *cspan_at(&a, i) - *cspan_at(&b, i);
}
}
static void series_negative(array_double_1d a, int64_t count, array_double_1d found) {
int64_t i;
for (i = 0; i < count; i += 1) {
*cspan_at(&found, i) = -*cspan_at(&a, i);
}
}
static void series_product(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found) {
int64_t k, i;
double total;
for (k = 0; k < count; k += 1) {
total = 0.0;
for (i = 0; i < k + 1; i += 1) {
total = total + *cspan_at(&a, i) * *cspan_at(&b, k - i);
}
*cspan_at(&found, k) = total;
}
}
static void series_quotient(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found) {
int64_t k, i;
double total;
for (k = 0; k < count; k += 1) {
total = *cspan_at(&a, k);
for (i = 0; i < k; i += 1) {
total = total - *cspan_at(&found, i) * *cspan_at(&b, k - i);
}
*cspan_at(&found, k) = total / *cspan_at(&b, 0);
}
}
static void series_root(array_double_1d a, int64_t count, array_double_1d found) {
int64_t k, i;
double total;
*cspan_at(&found, 0) = sqrt(*cspan_at(&a, 0));
for (k = 1; k < count; k += 1) {
total = *cspan_at(&a, k);
for (i = 1; i < k; i += 1) {
total = total - *cspan_at(&found, i) * *cspan_at(&found, k - i);
}
*cspan_at(&found, k) = total / (2.0 * *cspan_at(&found, 0));
}
}
static void series_exponential(array_double_1d a, int64_t count, array_double_1d found) {
int64_t k, i;
double total;
*cspan_at(&found, 0) = exp(*cspan_at(&a, 0));
for (k = 1; k < count; k += 1) {
total = 0.0;
for (i = 1; i < k + 1; i += 1) {
total = total + i * *cspan_at(&a, i) * *cspan_at(&found, k - i);
}
*cspan_at(&found, k) = total / k;
}
}
static void series_angle(array_double_1d y, array_double_1d x, array_double_1d square, int64_t count, array_double_1d scratch, array_double_1d found) {
int64_t k, i;
double total;
*cspan_at(&found, 0) = atan2(*cspan_at(&y, 0), *cspan_at(&x, 0));
for (k = 0; k < count - 1; k += 1) {
total = 0.0;
for (i = 0; i < k + 1; i += 1) {
total = total + (k + 1 - i) * (*cspan_at(&x, i) * *cspan_at(&y, k + 1 - i) - *cspan_at(&y, i) * *cspan_at(&x, k + 1 - i));
}
for (i = 0; i < k; i += 1) {
total = total - *cspan_at(&scratch, i) * *cspan_at(&square, k - i);
}
*cspan_at(&scratch, k) = total / *cspan_at(&square, 0);
*cspan_at(&found, k + 1) = *cspan_at(&scratch, k) / (k + 1.0);
}
}
static void suspension_derivatives(int64_t order, array_double_1d masses, array_double_2d work, array_double_1d force, array_double_1d state, array_double_1d acceleration) {
double bridge_mass, trolley_mass, payload_mass, scale;
array_double_1d x, y, z, w_x, w_y, w_z, s0, s1, s2, s3, s4, s5, s6, x_t, y_t, l, phi_x, phi_y;
int64_t count, i;
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
x = span_row(&work, 0);
y = span_row(&work, 0 + 1);
z = span_row(&work, 0 + 2);
w_x = span_row(&work, 3);
w_y = span_row(&work, 3 + 1);
w_z = span_row(&work, 3 + 2);
s0 = span_row(&work, 6);
s1 = span_row(&work, 6 + 1);
s2 = span_row(&work, 6 + 2);
s3 = span_row(&work, 6 + 3);
s4 = span_row(&work, 6 + 4);
s5 = span_row(&work, 6 + 5);
s6 = span_row(&work, 6 + 6);
x_t = span_row(&work, 13);
y_t = span_row(&work, 13 + 1);
l = span_row(&work, 13 + 2);
phi_x = span_row(&work, 13 + 3);
phi_y = span_row(&work, 13 + 4);
count = order + 3;
series_quotient(z, w_z, count, s0);
series_product(w_y, w_y, count, s2);
series_product(w_z, w_z, count, s3);
series_sum(s2, s3, count, s1);
series_product(w_x, w_x, count, s3);
series_sum(s1, s3, count, s2);
series_root(s2, count, s3);
series_product(s0, w_x, count, s4);
series_difference(x, s4, count, x_t);
series_product(s0, w_y, count, s4);
series_difference(y, s4, count, y_t);
series_product(s0, s3, count, l);
series_negative(l, count, l);
series_negative(w_x, count, s4);
series_root(s1, count, s5);
series_angle(s4, s5, s2, count, s6, phi_x);
series_angle(w_y, w_z, s1, count, s4, phi_y);
for (i = 0; i < 5; i += 1) {
*cspan_at(&state, 0 + i) = series_derivative(span_row(&work, 13 + i), order);
*cspan_at(&state, 5 + i) = series_derivative(span_row(&work, 13 + i), order + 1);
*cspan_at(&acceleration, i) = series_derivative(span_row(&work, 13 + i), order + 2);
}
scale = series_factorial(order);
*cspan_at(&force, 0) = (bridge_mass + trolley_mass) * *cspan_at(&acceleration, 0) + payload_mass * scale * *cspan_at(&w_x, order);
*cspan_at(&force, 0 + 1) = trolley_mass * *cspan_at(&acceleration, 0 + 1) + payload_mass * scale * *cspan_at(&w_y, order);
*cspan_at(&force, 0 + 2) = (-payload_mass) * scale * *cspan_at(&s3, order);
}
void segfmu_flat_derivatives(array_double_2d flat, int64_t order, array_double_1d masses, array_double_2d work, array_double_1d found) {
double gravity;
array_double_1d x, y, z, w_x, w_y, w_z;
int64_t count;
gravity = *cspan_at(&masses, 3);
x = span_row(&work, 0);
y = span_row(&work, 0 + 1);
z = span_row(&work, 0 + 2);
w_x = span_row(&work, 3);
w_y = span_row(&work, 3 + 1);
w_z = span_row(&work, 3 + 2);
count = order + 3;
series_of_derivatives(flat, 0, 0, count, x);
series_of_derivatives(flat, 0, 1, count, y);
series_of_derivatives(flat, 0, 2, count, z);
series_of_derivatives(flat, 2, 0, count, w_x);
series_of_derivatives(flat, 2, 1, count, w_y);
series_of_derivatives(flat, 2, 2, count, w_z);
*cspan_at(&w_z, 0) = *cspan_at(&w_z, 0) + gravity;
suspension_derivatives(order, masses, work, span_piece(&found, 0, 3), span_piece(&found, 3, 13), span_piece(&found, 13, 18));
}
static void write_links(array_double_2d flat, int64_t count, double gravity, array_double_2d work) {
int64_t i, k;
array_double_1d w_x, w_y, w_z, across, size, square, part, scratch;
for (i = 0; i < 3; i += 1) {
series_of_derivatives(flat, 0, i, count, span_row(&work, 0 + i));
series_of_derivatives(flat, 2, i, count, span_row(&work, 3 + i));
}
w_x = span_row(&work, 3);
w_y = span_row(&work, 3 + 1);
w_z = span_row(&work, 3 + 2);
*cspan_at(&w_z, 0) = *cspan_at(&w_z, 0) + gravity;
across = span_row(&work, 6);
size = span_row(&work, 6 + 1);
square = span_row(&work, 6 + 2);
part = span_row(&work, 13);
scratch = span_row(&work, 13 + 1);
series_product(w_y, w_y, count, part);
series_product(w_z, w_z, count, scratch);
series_sum(part, scratch, count, across);
series_product(w_x, w_x, count, part);
series_sum(across, part, count, square);
series_angle(w_y, w_z, across, count, scratch, span_row(&work, 21 + 1));
series_root(across, count, part);
for (k = 0; k < count; k += 1) {
*cspan_at(&size, k) = -*cspan_at(&w_x, k);
}
series_angle(size, part, square, count, scratch, span_row(&work, 21));
series_root(square, count, size);
for (i = 0; i < 3; i += 1) {
series_quotient(span_row(&work, 3 + i), size, count, span_row(&work, 18 + i));
}
}
static void climb_sling(int64_t count, double share, double sling, double gravity, array_double_2d work) {
int64_t i, k;
array_double_1d path, direction, pull, upwards;
for (i = 0; i < 3; i += 1) {
path = span_row(&work, 0 + i);
direction = span_row(&work, 18 + i);
pull = span_row(&work, 3 + i);
for (k = 0; k < count; k += 1) {
*cspan_at(&path, k) = *cspan_at(&path, k) + sling * *cspan_at(&direction, k);
}
for (k = 0; k < count - 2; k += 1) {
*cspan_at(&pull, k) = *cspan_at(&pull, k) + share * (k + 1.0) * (k + 2.0) * *cspan_at(&path, k + 2);
}
}
upwards = span_row(&work, 3 + 2);
*cspan_at(&upwards, 0) = *cspan_at(&upwards, 0) + share * gravity;
}
static void write_sling(array_double_2d flat, int64_t count, array_double_1d masses, double hook_mass, double sling, array_double_2d work) {
double gravity;
gravity = *cspan_at(&masses, 3);
write_links(flat, count, gravity, work);
climb_sling(count, hook_mass / *cspan_at(&masses, 2), sling, gravity, work);
}
void segfmu_hook_derivatives(array_double_2d flat, int64_t order, array_double_1d masses, double hook_mass, double sling, array_double_2d work, array_double_1d found) {
int64_t i, k;
array_double_1d angle;
write_sling(flat, order + 5, masses, hook_mass, sling, work);
suspension_derivatives(order, masses, work, span_piece(&found, 0, 3), span_piece(&found, 3, 13), span_piece(&found, 13, 18));
for (i = 0; i < 5; i += 1) {
k = 5 - 1 - i;
*cspan_at(&found, 17 + k) = *cspan_at(&found, 13 + k);
}
for (i = 0; i < 5; i += 1) {
k = 5 - 1 - i;
*cspan_at(&found, 3 + 7 + k) = *cspan_at(&found, 3 + 5 + k);
}
for (i = 0; i < 2; i += 1) {
angle = span_row(&work, 21 + i);
*cspan_at(&found, 3 + 5 + i) = series_derivative(angle, order);
*cspan_at(&found, 3 + 12 + i) = series_derivative(angle, order + 1);
*cspan_at(&found, 17 + 5 + i) = series_derivative(angle, order + 2);
}
}
static void hook_rhs(array_double_1d state, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative, array_double_1d tension) {
double l, phi_x, phi_y, psi_x, psi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, psi_x_rate, psi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, hook_mass, sling, f_x_t, f_y_t, f_l, f_phi_x, f_phi_y, w_x, w_y, w_z, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c40, c41, c42, c43, c44, c45, c46, c47, c48, c49, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c60, c61, c62, c63;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
psi_x = *cspan_at(&state, 5);
psi_y = *cspan_at(&state, 6);
x_t_rate = *cspan_at(&state, 7);
y_t_rate = *cspan_at(&state, 8);
l_rate = *cspan_at(&state, 9);
phi_x_rate = *cspan_at(&state, 10);
phi_y_rate = *cspan_at(&state, 11);
psi_x_rate = *cspan_at(&state, 12);
psi_y_rate = *cspan_at(&state, 13);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
hook_mass = *cspan_at(&masses, 4);
sling = *cspan_at(&masses, 5);
f_x_t = *cspan_at(&generalized_force, 0);
f_y_t = *cspan_at(&generalized_force, 1);
f_l = *cspan_at(&generalized_force, 2);
f_phi_x = *cspan_at(&generalized_force, 3);
f_phi_y = *cspan_at(&generalized_force, 4);
w_x = *cspan_at(&load_force, 0);
w_y = *cspan_at(&load_force, 1);
w_z = *cspan_at(&load_force, 2);
c0 = 1 / (bridge_mass + trolley_mass);
c1 = sin(phi_x);
c2 = cos(phi_x);
c3 = 1 / l;
c4 = c3 * f_phi_x;
c5 = c1 * f_l + c2 * c4;
c6 = c5 - f_x_t;
c7 = sin(phi_y);
c8 = c2 * f_l;
c9 = c1 * c4;
c10 = cos(phi_y);
c11 = 1 / c2;
c12 = c11 * c3;
c13 = c12 * f_phi_y;
c14 = c10 * c13 + c7 * c8 - c7 * c9;
c15 = (c14 + f_y_t) / trolley_mass;
c16 = c2 * l_rate;
c17 = c1 * phi_x_rate;
c18 = c17 * l;
c19 = 1 / hook_mass;
c20 = sin(psi_x);
c21 = 1 / payload_mass;
c22 = c20 * (psi_x_rate * psi_x_rate) * sling;
c23 = (-c19) * c5 + c21 * w_x + c22;
c24 = cos(psi_x);
c25 = sin(psi_y);
c26 = c24 * c25;
c27 = cos(psi_y);
c28 = c20 * c27;
c29 = psi_x_rate * sling;
c30 = psi_y_rate * sling;
c31 = c29 * (c26 * psi_x_rate + c28 * psi_y_rate) + c30 * (c26 * psi_y_rate + c28 * psi_x_rate);
c32 = (-c14) * c19 - c21 * w_y + c31;
c33 = c10 * c8;
c34 = c24 * c27;
c35 = c20 * c25;
c36 = c29 * (c34 * psi_x_rate - c35 * psi_y_rate) + c30 * (c24 * c27 * psi_y_rate - c35 * psi_x_rate);
c37 = c19 * (c10 * c9 + c13 * c7 - c33) - c21 * w_z + c36;
c38 = (-c20) * c23 - c26 * c32 - c34 * c37;
c39 = -c38;
c40 = 1 / (c19 + c21);
c41 = c20 * c40;
c42 = (-c0) * c6 + c16 * phi_x_rate - c19 * (c39 * c41 + c5) + phi_x_rate * ((-c18) + c2 * l_rate);
c43 = c2 * phi_y_rate;
c44 = c43 * c7;
c45 = c1 * l_rate;
c46 = c10 * l;
c47 = c2 * phi_x_rate;
c48 = c7 * l;
c49 = c1 * phi_y_rate;
c50 = c10 * c43;
c51 = c39 * c40;
c52 = c34 * c51;
c53 = c19 * (c1 * c10 * c3 * f_phi_x + c11 * c3 * c7 * f_phi_y - c33 - c52);
c54 = (-c53) + gravity + l_rate * (c10 * c17 + c44) + phi_x_rate * (c10 * c45 + c46 * c47 - c48 * c49) + phi_y_rate * (c16 * c7 - c18 * c7 + c50 * l);
c55 = c10 * c54;
c56 = c26 * c51;
c57 = c19 * ((-c14) - c56);
c58 = c15 - c57 + l_rate * (c17 * c7 - c50) + phi_x_rate * (c45 * c7 + c46 * c49 + c47 * c48) + phi_y_rate * ((-c10) * c16 + c10 * c18 + c44 * l);
c59 = c58 * c7;
c60 = 1 / sling;
c61 = c38 * c41;
c62 = (-c21) * (c56 + w_y) + c31 + c57;
c63 = (-c21) * (c52 + w_z) + c36 + c53;
*cspan_at(&derivative, 0) = x_t_rate;
*cspan_at(&derivative, 1) = y_t_rate;
*cspan_at(&derivative, 2) = l_rate;
*cspan_at(&derivative, 3) = phi_x_rate;
*cspan_at(&derivative, 4) = phi_y_rate;
*cspan_at(&derivative, 5) = psi_x_rate;
*cspan_at(&derivative, 6) = psi_y_rate;
*cspan_at(&derivative, 7) = (-c0) * c6;
*cspan_at(&derivative, 8) = c15;
*cspan_at(&derivative, 9) = (-c1) * c42 + c2 * c55 + c2 * c59;
*cspan_at(&derivative, 10) = (-c3) * (c1 * c55 + c1 * c59 + c2 * c42);
*cspan_at(&derivative, 11) = (-c12) * ((-c10) * c58 + c54 * c7);
*cspan_at(&derivative, 12) = (-c60) * ((-c24) * ((-c19) * (c5 - c61) + c21 * (c61 + w_x) + c22) + c28 * c63 + c35 * c62);
*cspan_at(&derivative, 13) = (-c60) * (c25 * c63 - c27 * c62) / c24;
*cspan_at(&tension, 0) = c40 * (c20 * c23 + c26 * c32 + c34 * c37);
}
static void hook_driven(array_double_1d state, array_double_1d carriage, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative, array_double_1d force, array_double_1d tension) {
double l, phi_x, phi_y, psi_x, psi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, psi_x_rate, psi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, hook_mass, sling, a_x, a_y, a_l, f_phi_x, f_phi_y, w_x, w_y, w_z, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c40, c41, c42, c43, c44, c45, c46, c47, c48, c49, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c60, c61, c62, c63, c64, c65, c66, c67, c68, c69, c70, c71, c72, c73, c74, c75;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
psi_x = *cspan_at(&state, 5);
psi_y = *cspan_at(&state, 6);
x_t_rate = *cspan_at(&state, 7);
y_t_rate = *cspan_at(&state, 8);
l_rate = *cspan_at(&state, 9);
phi_x_rate = *cspan_at(&state, 10);
phi_y_rate = *cspan_at(&state, 11);
psi_x_rate = *cspan_at(&state, 12);
psi_y_rate = *cspan_at(&state, 13);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
hook_mass = *cspan_at(&masses, 4);
sling = *cspan_at(&masses, 5);
a_x = *cspan_at(&carriage, 0);
a_y = *cspan_at(&carriage, 1);
a_l = *cspan_at(&carriage, 2);
f_phi_x = *cspan_at(&generalized_force, 3);
f_phi_y = *cspan_at(&generalized_force, 4);
w_x = *cspan_at(&load_force, 0);
w_y = *cspan_at(&load_force, 1);
w_z = *cspan_at(&load_force, 2);
c0 = 1 / l;
c1 = cos(phi_x);
c2 = sin(phi_x);
c3 = c2 * phi_x_rate;
c4 = c3 * l;
c5 = (-c1) * l_rate + c4;
c6 = c1 * l_rate;
c7 = a_l * c2 + a_x + c6 * phi_x_rate;
c8 = (-c5) * phi_x_rate + c7;
c9 = c1 * l;
c10 = 1 / hook_mass;
c11 = sin(phi_y);
c12 = a_l * c1;
c13 = c11 * c12;
c14 = cos(phi_y);
c15 = c1 * phi_y_rate;
c16 = l_rate * (c11 * c3 - c14 * c15);
c17 = c2 * l_rate;
c18 = c11 * c9;
c19 = c14 * c2;
c20 = l * phi_y_rate;
c21 = phi_x_rate * (c11 * c17 + c18 * phi_x_rate + c19 * c20);
c22 = phi_y_rate * (c14 * c4 - c14 * c6 + c18 * phi_y_rate);
c23 = a_y - c13 + c16 + c21 + c22;
c24 = c11 * c2;
c25 = c14 * c9;
c26 = (-c12) * c14 + gravity + l_rate * (c11 * c15 + c14 * c3) + phi_x_rate * (c14 * c17 - c20 * c24 + c25 * phi_x_rate) + phi_y_rate * ((-c11) * c4 + c11 * c6 + c25 * phi_y_rate);
c27 = (-c10) * f_phi_x + c19 * c26 * l + c23 * c24 * l;
c28 = c27 + c8 * c9;
c29 = c0 * c28;
c30 = sin(psi_x);
c31 = sin(psi_y);
c32 = cos(psi_x);
c33 = c31 * c32;
c34 = cos(psi_y);
c35 = c32 * c34;
c36 = (-c1) * c30 + c19 * c35 + c24 * c33;
c37 = 1 / payload_mass;
c38 = -c36;
c39 = c11 * c34 - c14 * c31;
c40 = (-c32) * c39;
c41 = c11 * c40 + c14 * c2 * c38;
c42 = (-c11) * c2 * c38 + c14 * c40;
c43 = -c42;
c44 = c1 * c10 * c30 * c38 - c10 * c31 * c32 * c43 - c10 * c32 * c34 * c41 + c37;
c45 = -c28;
c46 = c0 * c1;
c47 = (-c30) * (psi_x_rate * psi_x_rate) * sling + c45 * c46 + c8;
c48 = (-c37) * w_x + c47;
c49 = c30 * c34;
c50 = psi_x_rate * sling;
c51 = psi_y_rate * sling;
c52 = c0 * c45;
c53 = c0 / c1;
c54 = c53 * (c10 * f_phi_y - c18 * c26 + c23 * c25);
c55 = c14 * c54;
c56 = c23 + c24 * c52 + c50 * (c33 * psi_x_rate + c49 * psi_y_rate) + c51 * (c33 * psi_y_rate + c49 * psi_x_rate) - c55;
c57 = (-c37) * w_y + c56;
c58 = c30 * c31;
c59 = c11 * c54 + c26;
c60 = c19 * c52 + c50 * (c35 * psi_x_rate - c58 * psi_y_rate) + c51 * (c32 * c34 * psi_y_rate - c58 * psi_x_rate) + c59;
c61 = (-c37) * w_z + c60;
c62 = c30 * c48 - c33 * c57 - c35 * c61;
c63 = (-c62) / c44;
c64 = c10 * c63;
c65 = c36 * c64;
c66 = c32 * c39;
c67 = 1 / sling;
c68 = (-c62) / c44;
c69 = c1 * c10;
c70 = c10 * c43 * c68 - c37 * (c33 * c68 + w_y) + c56;
c71 = c10 * c41 * c68 - c37 * (c35 * c68 + w_z) + c60;
c72 = c11 * c66 + c19 * c36;
c73 = (c30 * c48 - c33 * c57 - c35 * c61) / (c1 * c10 * c30 * c36 - c10 * c33 * c42 - c10 * c35 * c72 - c37);
c74 = (-c5) * phi_x_rate + c7;
c75 = (-a_y) + c13 - c16 - c21 - c22 + c24 * c29 + c42 * c64 + c55;
*cspan_at(&derivative, 0) = x_t_rate;
*cspan_at(&derivative, 1) = y_t_rate;
*cspan_at(&derivative, 2) = l_rate;
*cspan_at(&derivative, 3) = phi_x_rate;
*cspan_at(&derivative, 4) = phi_y_rate;
*cspan_at(&derivative, 5) = psi_x_rate;
*cspan_at(&derivative, 6) = psi_y_rate;
*cspan_at(&derivative, 7) = a_x;
*cspan_at(&derivative, 8) = a_y;
*cspan_at(&derivative, 9) = a_l;
*cspan_at(&derivative, 10) = (-c0) * (c29 + c65);
*cspan_at(&derivative, 11) = c53 * (c54 - c64 * c66);
*cspan_at(&derivative, 12) = (-c67) * (c32 * ((-c37) * ((-c30) * c68 + w_x) + c38 * c68 * c69 + c47) + c49 * c71 + c58 * c70);
*cspan_at(&derivative, 13) = (-c67) * (c31 * c71 - c34 * c70) / c32;
*cspan_at(&force, 0) = a_x * (bridge_mass + trolley_mass) - c30 * c73 + hook_mass * ((-c36) * c69 * c73 - c46 * (c27 + c74 * c9) + c74);
*cspan_at(&force, 1) = a_y * trolley_mass + c33 * c73 - c75 * hook_mass;
*cspan_at(&force, 2) = (-c1) * c11 * (c33 * c63 - c75 * hook_mass) - c1 * c14 * (c35 * c63 + hook_mass * ((-c19) * c29 + c59 - c64 * c72)) + c2 * ((-c30) * c63 + hook_mass * ((-c1) * c29 - c1 * c65 + c74));
*cspan_at(&tension, 0) = c73;
}
static void hook_load(array_double_1d state, array_double_1d masses, array_double_2d load) {
double x_t, y_t, l, phi_x, phi_y, psi_x, psi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, psi_x_rate, psi_y_rate, sling, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16;
x_t = *cspan_at(&state, 0);
y_t = *cspan_at(&state, 1);
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
psi_x = *cspan_at(&state, 5);
psi_y = *cspan_at(&state, 6);
x_t_rate = *cspan_at(&state, 7);
y_t_rate = *cspan_at(&state, 8);
l_rate = *cspan_at(&state, 9);
phi_x_rate = *cspan_at(&state, 10);
phi_y_rate = *cspan_at(&state, 11);
psi_x_rate = *cspan_at(&state, 12);
psi_y_rate = *cspan_at(&state, 13);
sling = *cspan_at(&masses, 5);
c0 = sin(phi_x);
c1 = c0 * l;
c2 = sling * sin(psi_x);
c3 = sin(phi_y);
c4 = cos(phi_x);
c5 = c4 * l;
c6 = c3 * c5;
c7 = sin(psi_y);
c8 = sling * cos(psi_x);
c9 = c7 * c8;
c10 = cos(phi_y);
c11 = c10 * c5;
c12 = cos(psi_y);
c13 = c12 * c8;
c14 = c4 * l_rate;
c15 = c1 * phi_x_rate;
c16 = c2 * psi_x_rate;
*cspan_at(&load, 0, 0) = c1 + c2 + x_t;
*cspan_at(&load, 0, 1) = (-c6) - c9 + y_t;
*cspan_at(&load, 0, 2) = (-c11) - c13;
*cspan_at(&load, 1, 0) = c0 * l_rate + c5 * phi_x_rate + c8 * psi_x_rate + x_t_rate;
*cspan_at(&load, 1, 1) = (-c11) * phi_y_rate - c13 * psi_y_rate - c14 * c3 + c15 * c3 + c16 * c7 + y_t_rate;
*cspan_at(&load, 1, 2) = (-c10) * c14 + c10 * c15 + c12 * c16 + c6 * phi_y_rate + c9 * psi_y_rate;
}
static void hook_energy(array_double_1d state, array_double_1d masses, array_double_1d energy) {
double l, phi_x, phi_y, psi_x, psi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, psi_x_rate, psi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, hook_mass, sling, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
psi_x = *cspan_at(&state, 5);
psi_y = *cspan_at(&state, 6);
x_t_rate = *cspan_at(&state, 7);
y_t_rate = *cspan_at(&state, 8);
l_rate = *cspan_at(&state, 9);
phi_x_rate = *cspan_at(&state, 10);
phi_y_rate = *cspan_at(&state, 11);
psi_x_rate = *cspan_at(&state, 12);
psi_y_rate = *cspan_at(&state, 13);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
hook_mass = *cspan_at(&masses, 4);
sling = *cspan_at(&masses, 5);
c0 = x_t_rate * x_t_rate;
c1 = sin(phi_x);
c2 = cos(phi_x);
c3 = c2 * l;
c4 = c1 * l_rate + c3 * phi_x_rate + x_t_rate;
c5 = cos(phi_y);
c6 = c2 * l_rate;
c7 = c1 * l * phi_x_rate;
c8 = sin(phi_y);
c9 = c3 * c8 * phi_y_rate - c5 * c6 + c5 * c7;
c10 = c3 * c5;
c11 = (-c10) * phi_y_rate - c6 * c8 + c7 * c8 + y_t_rate;
c12 = sling * cos(psi_x);
c13 = cos(psi_y);
c14 = psi_x_rate * sling * sin(psi_x);
c15 = sin(psi_y);
c16 = c12 * c13;
c17 = c12 * psi_x_rate + c4;
c18 = c11 + c14 * c15 - c16 * psi_y_rate;
c19 = c12 * c15 * psi_y_rate + c13 * c14 + c9;
*cspan_at(&energy, 0) = 1.0 / 2.0 * bridge_mass * c0 + 1.0 / 2.0 * hook_mass * (c11 * c11 + c4 * c4 + c9 * c9) + 1.0 / 2.0 * payload_mass * (c17 * c17 + c18 * c18 + c19 * c19) + 1.0 / 2.0 * trolley_mass * (c0 + y_t_rate * y_t_rate);
*cspan_at(&energy, 1) = (-gravity) * (c10 * hook_mass + payload_mass * (c10 + c16));
}
static void gather_hook(array_double_1d plant, array_double_1d state, array_double_2d work) {
array_double_1d own, masses;
int64_t i;
own = span_row(&work, 22);
masses = span_row(&work, 24);
for (i = 0; i < 5; i += 1) {
*cspan_at(&own, i) = *cspan_at(&state, i);
*cspan_at(&own, 7 + i) = *cspan_at(&state, 5 + i);
}
for (i = 0; i < 2; i += 1) {
*cspan_at(&own, 5 + i) = *cspan_at(&state, 16 + i);
*cspan_at(&own, 12 + i) = *cspan_at(&state, 18 + i);
}
for (i = 0; i < 4; i += 1) {
*cspan_at(&masses, i) = *cspan_at(&plant, i);
}
*cspan_at(&masses, 4) = *cspan_at(&plant, 22);
*cspan_at(&masses, 5) = *cspan_at(&plant, 23);
}
static void scatter_hook(array_double_2d work, array_double_1d derivative) {
array_double_1d rate;
int64_t i;
rate = span_row(&work, 23);
for (i = 0; i < 5; i += 1) {
*cspan_at(&derivative, i) = *cspan_at(&rate, i);
*cspan_at(&derivative, 5 + i) = *cspan_at(&rate, 7 + i);
}
for (i = 0; i < 2; i += 1) {
*cspan_at(&derivative, 16 + i) = *cspan_at(&rate, 5 + i);
*cspan_at(&derivative, 18 + i) = *cspan_at(&rate, 12 + i);
}
*cspan_at(&work, 14, 7) = *cspan_at(&work, 25, 0);
}
static void hooked_rhs(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
gather_hook(plant, state, work);
hook_rhs(span_row(&work, 22), span_row(&work, 13), span_row(&work, 15), span_row(&work, 24), span_row(&work, 23), span_row(&work, 25));
scatter_hook(work, derivative);
}
static void hooked_driven(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
gather_hook(plant, state, work);
hook_driven(span_row(&work, 22), span_row(&work, 18), span_row(&work, 13), span_row(&work, 15), span_row(&work, 24), span_row(&work, 23), span_row(&work, 14), span_row(&work, 25));
scatter_hook(work, derivative);
}
static void hooked_load(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_2d load) {
gather_hook(plant, state, work);
hook_load(span_row(&work, 22), span_row(&work, 24), load);
}
static void hooked_energy(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d energy) {
gather_hook(plant, state, work);
hook_energy(span_row(&work, 22), span_row(&work, 24), energy);
}
static double hooked_mass(array_double_1d plant, array_double_1d state) {
double payload, hook, phi_x, psi_x, turned, cosine;
payload = *cspan_at(&plant, 2);
hook = *cspan_at(&plant, 22);
phi_x = *cspan_at(&state, 3);
psi_x = *cspan_at(&state, 16);
turned = cos(*cspan_at(&state, 3 + 1) - *cspan_at(&state, 16 + 1));
cosine = sin(phi_x) * sin(psi_x) + cos(phi_x) * cos(psi_x) * turned;
return hook * (hook + payload) / (hook + payload * (1.0 - cosine * cosine));
}
static bool has_tackle(array_double_1d resistance) {
bool result;
result = *cspan_at(&resistance, 21) > 0.0;
return result;
}
static void suspended_rhs(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
if ((int64_t)(*cspan_at(&plant, 21)) == 1) {
hooked_rhs(plant, state, work, derivative);
}
else {
segfmu_crane_rhs(state, span_row(&work, 13), span_row(&work, 15), plant, derivative);
}
}
static void suspended_driven(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
if ((int64_t)(*cspan_at(&plant, 21)) == 1) {
hooked_driven(plant, state, work, derivative);
}
else {
segfmu_crane_driven(state, span_row(&work, 18), span_row(&work, 13), span_row(&work, 15), plant, derivative, span_row(&work, 14));
}
}
static void suspended_load(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_2d load) {
if ((int64_t)(*cspan_at(&plant, 21)) == 1) {
hooked_load(plant, state, work, load);
}
else {
segfmu_crane_load(state, load);
}
}
static void suspended_energy(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d energy) {
if ((int64_t)(*cspan_at(&plant, 21)) == 1) {
hooked_energy(plant, state, work, energy);
}
else {
segfmu_crane_energy(state, plant, energy);
}
}
static double suspended_mass(array_double_1d plant, array_double_1d state) {
double result;
if ((int64_t)(*cspan_at(&plant, 21)) == 1) {
result = hooked_mass(plant, state);
return result;
}
result = *cspan_at(&plant, 2);
return result;
}
int64_t segfmu_flat_orders(array_double_1d resistance) {
if ((int64_t)(*cspan_at(&resistance, 21)) == 1) {
return 7;
}
return 5;
}
static void crane_inverse(array_double_2d flat, array_double_1d resistance, array_double_2d series, array_double_1d force, array_double_1d state, array_double_1d acceleration) {
if ((int64_t)(*cspan_at(&resistance, 21)) == 1) {
write_sling(flat, 5, resistance, *cspan_at(&resistance, 22), *cspan_at(&resistance, 23), series);
suspension_derivatives(0, resistance, series, force, state, acceleration);
}
else {
segfmu_crane_flat_inverse(flat, resistance, force, state, acceleration);
}
}
static double side_bound(double sign, double greatest, double least) {
if ((sign < 0.0) && (least < 0.0)) {
return -least;
}
return greatest;
}
static bool exceeds(double value, double bound) {
return (bound > 0.0) && (fabs(value) > bound * (1.0 + 1e-12));
}
static double limited(double value, double bound) {
return span_min(span_max(value, -bound), bound);
}
static double velocity_bound(array_double_1d plant, int64_t axis, double sign) {
double result;
result = side_bound(sign, *cspan_at(&plant, 37 + axis), *cspan_at(&plant, 40 + axis));
return result;
}
static double acceleration_bound(array_double_1d plant, int64_t axis, double sign) {
double result;
result = side_bound(sign, *cspan_at(&plant, 31 + axis), *cspan_at(&plant, 34 + axis));
return result;
}
static double static_bound(array_double_1d plant, int64_t axis, double sign) {
double result;
result = side_bound(sign, *cspan_at(&plant, 25 + axis), *cspan_at(&plant, 28 + axis));
return result;
}
static double force_bound(array_double_1d plant, int64_t axis, double sign, double velocity) {
double speed, by_power, bound;
bound = static_bound(plant, axis, sign);
if (*cspan_at(&plant, 43 + axis) > 0.0) {
speed = span_max(fabs(velocity), 1e-99);
by_power = *cspan_at(&plant, 43 + axis) / speed;
if ((bound == 0.0) || (by_power < bound)) {
bound = by_power;
}
}
return bound;
}
static void rope_direction(array_double_1d plant, array_double_1d state, array_double_1d limit) {
double phi_x, phi_y;
*cspan_at(&limit, 18) = suspended_mass(plant, state);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 3 + 1);
*cspan_at(&limit, 6) = sin(phi_x);
*cspan_at(&limit, 6 + 1) = (-cos(phi_x)) * sin(phi_y);
*cspan_at(&limit, 6 + 2) = 1.0;
}
static double carriage_mass(array_double_1d masses, int64_t axis) {
double result;
if (axis == 0) {
result = *cspan_at(&masses, 0) + *cspan_at(&masses, 1);
return result;
}
if (axis == 1) {
result = *cspan_at(&masses, 1);
return result;
}
return 0.0;
}
static double available_force(int64_t axis, double side, array_double_1d limit) {
double result;
if (side < 0.0) {
result = *cspan_at(&limit, 12 + axis);
return result;
}
result = *cspan_at(&limit, 9 + axis);
return result;
}
static double limit_side(array_double_1d plant, int64_t axis, array_double_1d action, array_double_1d limit) {
double change, along, needed, side;
int64_t i;
side = *cspan_at(&limit, 0 + axis);
change = *cspan_at(&limit, 3 + axis);
if (side != 0.0) {
if (side * change > 0.0) {
return 0.0;
}
return side;
}
along = 0.0;
for (i = 0; i < 3; i += 1) {
along = along + *cspan_at(&limit, 6 + i) * *cspan_at(&limit, 3 + i);
}
needed = *cspan_at(&action, 0 + axis) + carriage_mass(plant, axis) * change;
needed = needed + *cspan_at(&limit, 18) * *cspan_at(&limit, 6 + axis) * along;
if (needed > 0.0) {
side = 1.0;
}
else {
side = -1.0;
}
if (!exceeds(needed, available_force(axis, side, limit))) {
return 0.0;
}
return side;
}
static double missing_force(int64_t axis, array_double_1d action, array_double_1d limit) {
double side, bound, result;
side = *cspan_at(&limit, 0 + axis);
bound = side * available_force(axis, side, limit);
result = bound - *cspan_at(&action, 0 + axis);
return result;
}
static void change_accelerations(array_double_1d plant, array_double_1d action, array_double_1d limit) {
double payload, total, weight, missing, mass, rope, along, rest;
int64_t i;
bool hoist_limited;
payload = *cspan_at(&limit, 18);
total = 0.0;
weight = 1.0;
for (i = 0; i < 2; i += 1) {
if (*cspan_at(&limit, 0 + i) != 0.0) {
missing = missing_force(i, action, limit);
mass = carriage_mass(plant, i);
rope = *cspan_at(&limit, 6 + i);
total = total + rope * missing / mass;
weight = weight + payload * rope * rope / mass;
}
}
along = total / weight;
hoist_limited = *cspan_at(&limit, 0 + 2) != 0.0;
if (hoist_limited) {
along = missing_force(2, action, limit) / payload;
}
rest = along;
for (i = 0; i < 2; i += 1) {
*cspan_at(&limit, 3 + i) = 0.0;
if (*cspan_at(&limit, 0 + i) != 0.0) {
missing = missing_force(i, action, limit);
missing = missing - payload * *cspan_at(&limit, 6 + i) * along;
*cspan_at(&limit, 3 + i) = missing / carriage_mass(plant, i);
}
rest = rest - *cspan_at(&limit, 6 + i) * *cspan_at(&limit, 3 + i);
}
*cspan_at(&limit, 3 + 2) = 0.0;
if (hoist_limited) {
*cspan_at(&limit, 3 + 2) = rest;
}
}
static void limit_accelerations(array_double_1d plant, array_double_1d state, array_double_1d action, array_double_1d acceleration, array_double_1d limit) {
int64_t i, Dummy_0000;
double velocity, side;
bool changed;
rope_direction(plant, state, limit);
for (i = 0; i < 3; i += 1) {
*cspan_at(&limit, 0 + i) = 0.0;
*cspan_at(&limit, 3 + i) = 0.0;
velocity = *cspan_at(&state, 5 + i);
*cspan_at(&limit, 9 + i) = force_bound(plant, i, 1.0, velocity);
*cspan_at(&limit, 12 + i) = force_bound(plant, i, -1.0, velocity);
}
for (Dummy_0000 = 0; Dummy_0000 < 16; Dummy_0000 += 1) {
changed = 0;
for (i = 0; i < 3; i += 1) {
if (!changed) {
side = limit_side(plant, i, action, limit);
changed = side != *cspan_at(&limit, 0 + i);
*cspan_at(&limit, 0 + i) = side;
}
}
if (!changed) {
break;
}
change_accelerations(plant, action, limit);
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&acceleration, i) = *cspan_at(&acceleration, i) + *cspan_at(&limit, 3 + i);
if (*cspan_at(&limit, 0 + i) != 0.0) {
*cspan_at(&action, 3 + i) = 1.0;
}
}
}
static double hanging_mass(array_double_1d resistance) {
double result;
result = *cspan_at(&resistance, 2) + *cspan_at(&resistance, 22);
return result;
}
static bool at_velocity_bound(array_double_1d plant, int64_t axis, array_double_1d state) {
double velocity, bound;
velocity = *cspan_at(&state, 5 + axis);
bound = velocity_bound(plant, axis, velocity);
return (bound > 0.0) && (fabs(velocity) >= bound);
}
static double held_side(int64_t axis, array_double_1d state, array_double_1d derivative, array_double_1d limit) {
double side;
side = 1.0;
if (*cspan_at(&state, 5 + axis) < 0.0) {
side = -1.0;
}
if (*cspan_at(&limit, 0 + axis) != 0.0) {
if (side * *cspan_at(&limit, 15 + axis) > 0.0) {
return 0.0;
}
return side;
}
if (side * (*cspan_at(&derivative, 5 + axis) + *cspan_at(&limit, 3 + axis)) > 0.0) {
return side;
}
return 0.0;
}
static void hold_accelerations(array_double_1d plant, array_double_1d derivative, array_double_1d limit) {
double payload, along, weight, rope, mass, pull;
int64_t i;
payload = *cspan_at(&limit, 18);
along = 0.0;
weight = 1.0;
for (i = 0; i < 3; i += 1) {
rope = *cspan_at(&limit, 6 + i);
*cspan_at(&limit, 3 + i) = 0.0;
if (*cspan_at(&limit, 0 + i) != 0.0) {
*cspan_at(&limit, 3 + i) = -*cspan_at(&derivative, 5 + i);
along = along + rope * *cspan_at(&limit, 3 + i);
}
else if (i != 2) {
weight = weight + payload * rope * rope / carriage_mass(plant, i);
}
}
if (*cspan_at(&limit, 0 + 2) == 0.0) {
*cspan_at(&limit, 3 + 2) = -along;
along = 0.0;
}
along = along / weight;
for (i = 0; i < 3; i += 1) {
mass = carriage_mass(plant, i);
pull = payload * *cspan_at(&limit, 6 + i) * along;
*cspan_at(&limit, 15 + i) = 0.0;
if (*cspan_at(&limit, 0 + i) != 0.0) {
*cspan_at(&limit, 15 + i) = mass * *cspan_at(&limit, 3 + i) + pull;
}
else if (i != 2) {
*cspan_at(&limit, 3 + i) = (-pull) / mass;
}
}
}
static void hold_velocities(array_double_1d plant, array_double_1d state, array_double_1d derivative, array_double_1d action, array_double_1d limit) {
int64_t i, Dummy_0000;
bool changed;
double side, force, bound;
rope_direction(plant, state, limit);
for (i = 0; i < 3; i += 1) {
*cspan_at(&limit, 0 + i) = 0.0;
*cspan_at(&limit, 3 + i) = 0.0;
*cspan_at(&limit, 15 + i) = 0.0;
}
for (Dummy_0000 = 0; Dummy_0000 < 16; Dummy_0000 += 1) {
changed = 0;
for (i = 0; i < 3; i += 1) {
if ((!changed) && at_velocity_bound(plant, i, state)) {
side = held_side(i, state, derivative, limit);
changed = side != *cspan_at(&limit, 0 + i);
*cspan_at(&limit, 0 + i) = side;
}
}
if (!changed) {
break;
}
hold_accelerations(plant, derivative, limit);
}
for (i = 0; i < 3; i += 1) {
if (*cspan_at(&limit, 0 + i) != 0.0) {
force = *cspan_at(&action, 0 + i) + *cspan_at(&limit, 15 + i);
bound = force_bound(plant, i, force, *cspan_at(&state, 5 + i));
if (exceeds(force, bound)) {
force = limited(force, bound);
}
*cspan_at(&action, 0 + i) = force;
*cspan_at(&action, 3 + i) = 1.0;
}
}
}
static int64_t table_row(double length, array_double_3d table) {
int64_t row;
row = 0;
while((row + 2 < table.shape[0]) && (length > *cspan_at(&table, row + 1, 0, 0))) {
row = row + 1;
}
return row;
}
static double table_share(double length, array_double_3d table, int64_t row) {
double first, result;
if (table.shape[0] < 2) {
return 0.0;
}
first = *cspan_at(&table, row, 0, 0);
result = span_min(span_max((length - first) / (*cspan_at(&table, row + 1, 0, 0) - first), 0.0), 1.0);
return result;
}
void segfmu_feedback_correction(array_double_1d state, array_double_1d reference, array_double_1d added, array_double_3d gains, array_double_1d correction) {
double length, share, total, k;
int64_t row, following, i, axis, j;
length = *cspan_at(&state, 0 + 2);
row = table_row(length, gains);
share = table_share(length, gains, row);
following = span_min_int(row + 1, gains.shape[0] - 1);
for (i = 0; i < 3; i += 1) {
axis = 1 + i;
total = 0.0;
for (j = 0; j < 10; j += 1) {
k = (1.0 - share) * *cspan_at(&gains, row, axis, j) + share * *cspan_at(&gains, following, axis, j);
total = total + k * (*cspan_at(&state, j) - *cspan_at(&reference, j));
}
k = (1.0 - share) * *cspan_at(&gains, row, axis, 10);
k = k + share * *cspan_at(&gains, following, axis, 10);
*cspan_at(&correction, i) = -(total + k * *cspan_at(&added, i));
}
}
double segfmu_feedback_bandwidth(double ratio, double length, double gravity, double delay, double largest) {
return span_min(ratio * sqrt(gravity / length), largest / delay);
}
static void lead_gains(int64_t axis, double lag, double length, double gravity, array_double_1d gains) {
double position, velocity, direct, sign, angle, rate;
if (lag <= 0.0) {
return;
}
position = *cspan_at(&gains, 0 + axis);
velocity = *cspan_at(&gains, 5 + axis);
direct = velocity;
if (axis != 2) {
sign = 1.0 - 2.0 * axis;
angle = sign * *cspan_at(&gains, 3 + axis);
rate = sign * *cspan_at(&gains, 8 + axis);
direct = velocity - rate / length;
*cspan_at(&gains, 3 + axis) = sign * (angle - lag * rate * gravity / length);
*cspan_at(&gains, 8 + axis) = sign * (rate + lag * angle);
}
*cspan_at(&gains, 5 + axis) = velocity + lag * position - direct;
*cspan_at(&gains, 10) = direct;
}
void segfmu_feedback_gains(array_double_1d plant, double length, double bandwidth, double pendulum, double hoist_bandwidth, double damping, array_double_2d gains) {
bool driven;
double gravity, slope, square, k0, k1, k2, k3, sign, scale, pull, ratio, angle, weight;
int64_t i, j;
array_double_1d axis, hoist;
driven = (int64_t)(*cspan_at(&plant, 24)) == 1;
gravity = *cspan_at(&plant, 3);
slope = 2.0 * damping * bandwidth;
square = bandwidth * bandwidth;
k0 = square * pendulum * pendulum;
k1 = slope * (square + pendulum * pendulum);
k2 = square + pendulum * pendulum + slope * slope;
k3 = 2.0 * slope;
for (i = 0; i < 4; i += 1) {
for (j = 0; j < 11; j += 1) {
*cspan_at(&gains, i, j) = 0.0;
}
}
*cspan_at(&gains, 0, 0) = length;
for (i = 0; i < 2; i += 1) {
axis = span_row(&gains, 1 + i);
sign = 1.0 - 2.0 * i;
scale = 1.0;
pull = 0.0;
if (!driven) {
scale = carriage_mass(plant, i);
pull = *cspan_at(&plant, 2) * gravity;
}
ratio = length / gravity;
angle = scale * (ratio * length * k0 - length * k2 + gravity) + pull;
*cspan_at(&axis, 0 + i) = scale * ratio * k0;
*cspan_at(&axis, 3 + i) = sign * angle;
*cspan_at(&axis, 5 + i) = scale * ratio * k1;
*cspan_at(&axis, 8 + i) = sign * scale * (ratio * length * k1 - length * k3);
}
weight = 1.0;
if (!driven) {
weight = *cspan_at(&plant, 2);
}
hoist = span_row(&gains, 1 + 2);
*cspan_at(&hoist, 0 + 2) = weight * hoist_bandwidth * hoist_bandwidth;
*cspan_at(&hoist, 5 + 2) = weight * 2.0 * damping * hoist_bandwidth;
if (driven) {
for (i = 0; i < 3; i += 1) {
lead_gains(i, *cspan_at(&plant, 18 + i), length, gravity, span_row(&gains, 1 + i));
}
}
}
static double return_effort(void) {
return 3.5;
}
static double return_speed(void) {
return 0.7;
}
static double held_within(double value, double least, double greatest) {
return span_max(span_min(value, greatest), least);
}
static double scheduled_gain(double length, int64_t axis, int64_t column, array_double_3d gains) {
int64_t row, following;
double share, first, result;
row = table_row(length, gains);
share = table_share(length, gains, row);
following = span_min_int(row + 1, gains.shape[0] - 1);
first = *cspan_at(&gains, row, 1 + axis, column);
result = first + share * (*cspan_at(&gains, following, 1 + axis, column) - first);
return result;
}
static double top_speed(int64_t axis, double sign, array_double_1d parameters, array_double_1d situation) {
double power, bound;
bound = side_bound(sign, *cspan_at(&parameters, 30 + axis), *cspan_at(&parameters, 33 + axis));
power = *cspan_at(&parameters, 36 + axis);
if (bound <= 0.0) {
bound = 1e+99;
}
if ((axis == 2) && (power > 0.0)) {
bound = span_min(bound, power / *cspan_at(&situation, 0));
}
return bound;
}
static double power_bound(int64_t axis, array_double_1d parameters, array_double_1d situation) {
double power, weight, gravity, force;
power = *cspan_at(&parameters, 36 + axis);
if (power <= 0.0) {
return 1e+99;
}
force = power / span_max(fabs(*cspan_at(&situation, 2 + axis)), 1e-12 * power);
if ((int64_t)(*cspan_at(&parameters, 0)) == 0) {
return force;
}
weight = *cspan_at(&situation, 0);
gravity = *cspan_at(&parameters, 6);
if (axis == 2) {
return gravity * span_max(force / weight - 1.0, 0.001);
}
force = force / (*cspan_at(&parameters, 3 + axis) + weight / gravity);
return force;
}
static double least_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation) {
double least, result;
least = span_max(*cspan_at(&parameters, 12 + axis), -power_bound(axis, parameters, situation));
result = span_min(least - *cspan_at(&tick, 2, axis), 0.0);
return result;
}
static double greatest_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation) {
double greatest, result;
greatest = *cspan_at(&parameters, 15 + axis);
if (axis != 2) {
greatest = span_min(greatest, power_bound(axis, parameters, situation));
}
else if ((int64_t)(*cspan_at(&parameters, 0)) == 0) {
greatest = span_min(greatest, (-0.1) * *cspan_at(&situation, 0));
}
result = span_max(greatest - *cspan_at(&tick, 2, axis), 0.0);
return result;
}
static void bound_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation) {
double correction, least, greatest, velocity, period;
correction = *cspan_at(&tick, 3, axis);
if ((int64_t)(*cspan_at(&parameters, 0)) == 1) {
least = -top_speed(axis, -1.0, parameters, situation);
greatest = top_speed(axis, 1.0, parameters, situation);
velocity = *cspan_at(&situation, 2 + axis);
period = *cspan_at(&parameters, 1);
correction = held_within(correction, span_min(least - velocity, 0.0) / period, span_max(greatest - velocity, 0.0) / period);
}
*cspan_at(&tick, 3, axis) = held_within(correction, least_correction(axis, parameters, tick, situation), greatest_correction(axis, parameters, tick, situation));
}
static double return_room(int64_t axis, array_double_1d parameters, array_double_3d gains, array_double_1d situation) {
double sign, length, pull, opposed;
if (axis == 2) {
return 1.0;
}
sign = 1.0 - 2.0 * axis;
length = *cspan_at(&situation, 1);
pull = *cspan_at(&parameters, 6);
if ((int64_t)(*cspan_at(&parameters, 0)) == 0) {
pull = pull * *cspan_at(&parameters, 3 + axis) + *cspan_at(&situation, 0);
}
opposed = length * scheduled_gain(length, axis, 0 + axis, gains);
opposed = opposed - sign * scheduled_gain(length, axis, 3 + axis, gains);
return return_effort() * span_max(1.0 + opposed / pull, 1.0);
}
static void bound_return(int64_t axis, array_double_1d parameters, array_double_3d gains, array_double_2d tick, array_double_1d situation) {
double length, slope, pull, damping, asked, speed, reference, fastest, room, least, greatest, given;
length = *cspan_at(&situation, 1);
slope = scheduled_gain(length, axis, 5 + axis, gains);
slope = slope + scheduled_gain(length, axis, 10, gains);
pull = scheduled_gain(length, axis, 0 + axis, gains);
pull = pull * *cspan_at(&situation, 5 + axis);
damping = slope * *cspan_at(&situation, 8 + axis);
asked = -(pull + damping);
speed = top_speed(axis, -pull, parameters, situation);
if ((slope > 0.0) && (speed < 1e+99)) {
reference = fabs(*cspan_at(&tick, 1, 5 + axis));
fastest = slope * return_speed() * span_max(speed - reference, 0.0);
pull = held_within(pull, -fastest, fastest);
}
room = return_room(axis, parameters, gains, situation);
least = room * least_correction(axis, parameters, tick, situation);
greatest = room * greatest_correction(axis, parameters, tick, situation);
given = held_within(-(pull + damping), least, greatest);
*cspan_at(&tick, 3, axis) = *cspan_at(&tick, 3, axis) + given - asked;
}
void segfmu_observer_predict(int64_t axis, double length, array_double_3d table, double command, double correction, array_double_1d estimate, array_double_1d scratch) {
int64_t row, following, j, i, k;
double share, total, entry;
row = table_row(length, table);
share = table_share(length, table, row);
following = span_min_int(row + 1, table.shape[0] - 1);
for (j = 0; j < 6; j += 1) {
*cspan_at(&scratch, j) = *cspan_at(&estimate, j);
}
*cspan_at(&scratch, 6) = command;
*cspan_at(&scratch, 7) = correction;
for (i = 0; i < 6; i += 1) {
k = 1 + 6 * axis + i;
total = 0.0;
for (j = 0; j < 8; j += 1) {
entry = (1.0 - share) * *cspan_at(&table, row, k, j) + share * *cspan_at(&table, following, k, j);
total = total + entry * *cspan_at(&scratch, j);
}
*cspan_at(&estimate, i) = total;
}
}
static void observer_input(int64_t axis, double length, array_double_3d table, double period, double correction, array_double_1d change) {
int64_t row, following, i, k;
double share, entry;
row = table_row(length, table);
share = table_share(length, table, row);
following = span_min_int(row + 1, table.shape[0] - 1);
for (i = 0; i < 6; i += 1) {
k = 1 + 6 * axis + i;
entry = (1.0 - share) * *cspan_at(&table, row, k, 7);
entry = entry + share * *cspan_at(&table, following, k, 7);
*cspan_at(&change, i) = entry * correction;
}
*cspan_at(&change, 6) = period * correction;
}
static void observer_bend(int64_t axis, double length, array_double_3d table, double factor, array_double_1d change, array_double_1d estimate) {
int64_t row, following, i, k, j;
double share, total, entry;
row = table_row(length, table);
share = table_share(length, table, row);
following = span_min_int(row + 1, table.shape[0] - 1);
for (i = 0; i < 6; i += 1) {
k = 1 + 6 * axis + i;
total = -*cspan_at(&change, i);
for (j = 0; j < 7; j += 1) {
entry = (1.0 - share) * *cspan_at(&table, row, k, j) + share * *cspan_at(&table, following, k, j);
total = total + entry * *cspan_at(&change, j);
}
*cspan_at(&estimate, i) = *cspan_at(&estimate, i) + factor * total;
}
}
void segfmu_observer_correct(double length, array_double_3d table, array_double_1d measured, array_double_1d reference, array_double_2d estimate) {
int64_t row, following, axis, angle, i, k;
double share, first, second, sign, deviation, a, b;
row = table_row(length, table);
share = table_share(length, table, row);
following = span_min_int(row + 1, table.shape[0] - 1);
for (axis = 0; axis < 3; axis += 1) {
first = *cspan_at(&measured, axis) - *cspan_at(&reference, axis) - *cspan_at(&estimate, axis, 0);
second = 0.0;
if (axis != 2) {
sign = 1.0 - 2.0 * axis;
angle = 3 + axis;
deviation = sign * (*cspan_at(&measured, angle) - *cspan_at(&reference, angle));
second = deviation - *cspan_at(&estimate, axis, 1);
}
for (i = 0; i < 6; i += 1) {
k = 1 + 6 * axis + i;
a = (1.0 - share) * *cspan_at(&table, row, k, 8);
a = a + share * *cspan_at(&table, following, k, 8);
b = (1.0 - share) * *cspan_at(&table, row, k, 9);
b = b + share * *cspan_at(&table, following, k, 9);
*cspan_at(&estimate, axis, i) = *cspan_at(&estimate, axis, i) + a * first + b * second;
}
}
}
static int64_t remembered_ticks(array_double_1d parameters) {
double longest;
int64_t axis;
longest = *cspan_at(&parameters, 2);
for (axis = 0; axis < 3; axis += 1) {
longest = span_max(longest, *cspan_at(&parameters, 27 + axis));
}
return span_min_int((int64_t)(longest) + 3, 40);
}
static void remember_tick(array_double_1d parameters, array_double_1d reference, array_double_2d memory) {
array_double_1d held, command;
int64_t rows, back, row, i;
double added;
held = span_row(&memory, 4);
command = span_row(&memory, 3);
rows = remembered_ticks(parameters);
for (back = 0; back < rows - 1; back += 1) {
row = 31 + rows - 1 - back;
for (i = 0; i < 13; i += 1) {
*cspan_at(&memory, row, i) = *cspan_at(&memory, row - 1, i);
}
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&memory, 31, 0 + i) = *cspan_at(&held, 0 + i);
added = *cspan_at(&parameters, 1) * *cspan_at(&held, 0 + i);
*cspan_at(&command, 0 + i) = *cspan_at(&command, 0 + i) + added;
}
for (i = 0; i < 10; i += 1) {
*cspan_at(&memory, 31, 3 + i) = *cspan_at(&reference, i);
}
}
static void remember_start(array_double_1d reference, array_double_2d memory) {
int64_t row, i;
for (row = 0; row < 40; row += 1) {
for (i = 0; i < 10; i += 1) {
*cspan_at(&memory, 31 + row, 3 + i) = *cspan_at(&reference, i);
}
}
}
static void aged_reference(array_double_1d parameters, array_double_2d memory) {
double age, share, later, earlier;
int64_t whole, i;
age = *cspan_at(&parameters, 2);
whole = span_min_int((int64_t)(age + 1e-09), 40 - 2);
share = span_min(span_max(age - whole, 0.0), 1.0);
for (i = 0; i < 10; i += 1) {
later = *cspan_at(&memory, 31 + whole, 3 + i);
earlier = *cspan_at(&memory, 31 + whole + 1, 3 + i);
*cspan_at(&memory, 6, i) = later + share * (earlier - later);
}
}
static void advance_axis(int64_t axis, int64_t back, double share, array_double_1d parameters, double length, array_double_3d table, array_double_2d memory, array_double_1d estimate) {
double period, before, after, command;
int64_t i;
array_double_1d change;
period = *cspan_at(&parameters, 1);
before = *cspan_at(&memory, 31 + back + 1, 0 + axis);
after = *cspan_at(&memory, 31 + back, 0 + axis);
command = *cspan_at(&memory, 3, 0 + axis) - share * period * before;
for (i = 0; i < back + 1; i += 1) {
command = command - period * *cspan_at(&memory, 31 + i, 0 + axis);
}
segfmu_observer_predict(axis, length, table, command, share * before + (1.0 - share) * after, estimate, span_row(&memory, 9));
if (share > 1e-09) {
change = span_row(&memory, 29);
observer_input(axis, length, table, period, before - after, change);
observer_bend(axis, length, table, 0.5 * share * (1.0 - share), change, estimate);
}
}
static void advance_estimates(array_double_1d parameters, double length, array_double_3d table, array_double_2d memory) {
int64_t axis, whole;
double delay, share;
for (axis = 0; axis < 3; axis += 1) {
delay = *cspan_at(&parameters, 27 + axis);
whole = span_min_int((int64_t)(delay + 1e-09), 40 - 2);
share = span_min(span_max(delay - whole, 0.0), 1.0);
advance_axis(axis, whole, share, parameters, length, table, memory, span_row(&memory, 0 + axis));
}
}
static void predict_share(int64_t axis, double share, array_double_1d parameters, double length, array_double_3d table, array_double_2d memory) {
array_double_1d present, ahead, change;
int64_t i;
double latest, command;
present = span_row(&memory, 25 + axis);
ahead = span_row(&memory, 28);
change = span_row(&memory, 29);
for (i = 0; i < 6; i += 1) {
*cspan_at(&ahead, i) = *cspan_at(&present, i);
}
latest = *cspan_at(&memory, 31, 0 + axis);
command = *cspan_at(&memory, 3, 0 + axis);
command = command - share * *cspan_at(&parameters, 1) * latest;
segfmu_observer_predict(axis, length, table, command, latest, ahead, span_row(&memory, 9));
for (i = 0; i < 6; i += 1) {
*cspan_at(&change, i) = *cspan_at(&ahead, i) - *cspan_at(&present, i);
*cspan_at(&present, i) = *cspan_at(&present, i) + share * *cspan_at(&change, i);
}
*cspan_at(&change, 6) = *cspan_at(&parameters, 1) * latest;
observer_bend(axis, length, table, (-0.5) * share * (1.0 - share), change, present);
}
static void predict_present(array_double_1d parameters, double length, array_double_3d table, array_double_2d memory) {
int64_t axis, whole, i, back;
double delay, share;
array_double_1d present;
for (axis = 0; axis < 3; axis += 1) {
delay = *cspan_at(&parameters, 27 + axis);
whole = span_min_int((int64_t)(delay + 1e-09), 40 - 2);
share = span_min(span_max(delay - whole, 0.0), 1.0);
present = span_row(&memory, 25 + axis);
for (i = 0; i < 6; i += 1) {
*cspan_at(&present, i) = *cspan_at(&memory, 0 + axis, i);
}
for (back = 0; back < whole; back += 1) {
advance_axis(axis, whole - 1 - back, share, parameters, length, table, memory, present);
}
if (share > 1e-09) {
predict_share(axis, share, parameters, length, table, memory);
}
}
}
static void matrix_set(int64_t n, double value, array_double_2d a) {
int64_t i, j;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&a, i, j) = 0.0;
}
*cspan_at(&a, i, i) = value;
}
}
static void matrix_copy(int64_t n, array_double_2d a, array_double_2d c) {
int64_t i, j;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&c, i, j) = *cspan_at(&a, i, j);
}
}
}
static void matrix_add(int64_t n, double factor, array_double_2d a, array_double_2d c) {
int64_t i, j;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&c, i, j) = *cspan_at(&c, i, j) + factor * *cspan_at(&a, i, j);
}
}
}
static void matrix_product(int64_t n, array_double_2d a, array_double_2d b, array_double_2d c) {
int64_t i, j, k;
double total;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
total = 0.0;
for (k = 0; k < n; k += 1) {
total = total + *cspan_at(&a, i, k) * *cspan_at(&b, k, j);
}
*cspan_at(&c, i, j) = total;
}
}
}
static void matrix_product_transposed(int64_t n, array_double_2d a, array_double_2d b, array_double_2d c) {
int64_t i, j, k;
double total;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
total = 0.0;
for (k = 0; k < n; k += 1) {
total = total + *cspan_at(&a, i, k) * *cspan_at(&b, j, k);
}
*cspan_at(&c, i, j) = total;
}
}
}
static void matrix_transpose(int64_t n, array_double_2d a, array_double_2d c) {
int64_t i, j;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&c, i, j) = *cspan_at(&a, j, i);
}
}
}
static void matrix_reduce(int64_t n, int64_t columns, int64_t pivot, array_double_2d a, array_double_2d b) {
int64_t best, i, j;
double kept, factor;
best = pivot;
for (i = pivot + 1; i < n; i += 1) {
if (fabs(*cspan_at(&a, i, pivot)) > fabs(*cspan_at(&a, best, pivot))) {
best = i;
}
}
for (j = 0; j < n; j += 1) {
kept = *cspan_at(&a, pivot, j);
*cspan_at(&a, pivot, j) = *cspan_at(&a, best, j);
*cspan_at(&a, best, j) = kept;
}
for (j = 0; j < columns; j += 1) {
kept = *cspan_at(&b, pivot, j);
*cspan_at(&b, pivot, j) = *cspan_at(&b, best, j);
*cspan_at(&b, best, j) = kept;
}
for (i = pivot + 1; i < n; i += 1) {
factor = *cspan_at(&a, i, pivot) / *cspan_at(&a, pivot, pivot);
for (j = pivot; j < n; j += 1) {
*cspan_at(&a, i, j) = *cspan_at(&a, i, j) - factor * *cspan_at(&a, pivot, j);
}
for (j = 0; j < columns; j += 1) {
*cspan_at(&b, i, j) = *cspan_at(&b, i, j) - factor * *cspan_at(&b, pivot, j);
}
}
}
static void matrix_solve(int64_t n, int64_t columns, array_double_2d a, array_double_2d b) {
int64_t pivot, step, i, j, k;
double total;
for (pivot = 0; pivot < n; pivot += 1) {
matrix_reduce(n, columns, pivot, a, b);
}
for (step = 0; step < n; step += 1) {
i = n - 1 - step;
for (j = 0; j < columns; j += 1) {
total = *cspan_at(&b, i, j);
for (k = i + 1; k < n; k += 1) {
total = total - *cspan_at(&a, i, k) * *cspan_at(&b, k, j);
}
*cspan_at(&b, i, j) = total / *cspan_at(&a, i, i);
}
}
}
static int64_t halvings_below(int64_t n, double time, array_double_2d a) {
double size, total;
int64_t i, j, count;
size = 0.0;
for (i = 0; i < n; i += 1) {
total = 0.0;
for (j = 0; j < n; j += 1) {
total = total + fabs(*cspan_at(&a, i, j));
}
size = span_max(size, total);
}
count = 0;
while(size * time > 0.5) {
time = 0.5 * time;
count = count + 1;
}
return count;
}
static void matrix_exponential(int64_t n, double part, array_double_2d a, array_double_2d c, array_double_2d term, array_double_2d product) {
int64_t k;
matrix_set(n, 1.0, c);
matrix_set(n, 1.0, term);
for (k = 1; k < 17; k += 1) {
matrix_product(n, a, term, product);
matrix_set(n, 0.0, term);
matrix_add(n, part / k, product, term);
matrix_add(n, 1.0, term, c);
}
}
static void kalman_model(int64_t axis, array_double_1d plant, double length, array_double_2d model) {
double mass, gravity, lag;
bool driven;
array_double_1d rate;
int64_t j;
mass = carriage_mass(plant, axis);
gravity = *cspan_at(&plant, 3);
lag = *cspan_at(&plant, 18 + axis);
driven = (int64_t)(*cspan_at(&plant, 24)) == 1;
matrix_set(8, 0.0, model);
*cspan_at(&model, 6, 7) = 1.0;
*cspan_at(&model, 0, 2) = 1.0;
*cspan_at(&model, 2, 4) = 1.0;
if (driven && (lag > 0.0)) {
*cspan_at(&model, 2, 2) = (-1.0) / lag;
*cspan_at(&model, 2, 6) = 1.0 / lag;
}
else if (driven || (axis == 2)) {
*cspan_at(&model, 2, 7) = 1.0;
}
else {
*cspan_at(&model, 2, 7) = 1.0 / mass;
*cspan_at(&model, 2, 1) = *cspan_at(&plant, 2) * gravity / mass;
}
if (axis != 2) {
rate = span_row(&model, 3);
*cspan_at(&model, 1, 3) = 1.0;
for (j = 0; j < 8; j += 1) {
*cspan_at(&rate, j) = (-*cspan_at(&model, 2, j)) / length;
}
*cspan_at(&rate, 1) = *cspan_at(&rate, 1) - gravity / length;
*cspan_at(&rate, 5) = 1.0 / length;
}
}
static void kalman_series(double part, double drift, double wind, array_double_2d model, array_double_2d transition, array_double_2d covariance, array_double_2d work) {
array_double_2d term, product, transposed;
int64_t n;
term = span_rows(&work, 0, 8);
product = span_rows(&work, 8, 16);
transposed = span_rows(&work, 16, 24);
matrix_exponential(8, part, model, transition, term, product);
matrix_set(6, 0.0, covariance);
matrix_set(6, 0.0, term);
*cspan_at(&term, 4, 4) = drift * drift * part;
*cspan_at(&term, 5, 5) = wind * wind * part;
for (n = 2; n < 18; n += 1) {
matrix_add(6, 1.0, term, covariance);
matrix_product(6, model, term, product);
matrix_product_transposed(6, term, model, transposed);
matrix_add(6, 1.0, transposed, product);
matrix_set(6, 0.0, term);
matrix_add(6, part / n, product, term);
}
}
static void kalman_sampled(double sample_time, double drift, double wind, array_double_2d model, array_double_2d transition, array_double_2d covariance, array_double_2d work) {
int64_t doublings, Dummy_0000;
double part;
array_double_2d term, product;
doublings = halvings_below(8, sample_time, model);
part = sample_time / pow(2.0, (double)(doublings));
kalman_series(part, drift, wind, model, transition, covariance, work);
term = span_rows(&work, 0, 8);
product = span_rows(&work, 8, 16);
for (Dummy_0000 = 0; Dummy_0000 < doublings; Dummy_0000 += 1) {
matrix_product(6, transition, covariance, term);
matrix_product_transposed(6, term, transition, product);
matrix_add(6, 1.0, product, covariance);
matrix_product(8, transition, transition, term);
matrix_copy(8, term, transition);
}
}
static double kalman_turn(int64_t n, array_double_2d spread, array_double_2d work) {
array_double_2d transposed, information, factor, solution, product, change;
int64_t i, j;
double largest;
transposed = span_rows(&work, 0, 8);
information = span_rows(&work, 8, 16);
factor = span_rows(&work, 16, 24);
solution = span_rows(&work, 24, 32);
product = span_rows(&work, 32, 40);
change = span_rows(&work, 40, 48);
matrix_set(n, 1.0, factor);
matrix_product(n, information, spread, solution);
matrix_add(n, 1.0, solution, factor);
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&solution, i, j) = *cspan_at(&transposed, i, j);
*cspan_at(&solution, i, n + j) = *cspan_at(&information, i, j);
}
}
matrix_solve(n, 2 * n, factor, solution);
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&product, i, j) = *cspan_at(&solution, i, n + j);
}
}
matrix_product(n, transposed, product, factor);
matrix_product_transposed(n, factor, transposed, product);
matrix_add(n, 1.0, product, information);
matrix_product(n, spread, solution, factor);
matrix_transpose(n, transposed, product);
matrix_product(n, product, factor, change);
matrix_add(n, 1.0, change, spread);
matrix_product(n, transposed, solution, factor);
matrix_copy(n, factor, transposed);
largest = 0.0;
for (i = 0; i < n; i += 1) {
if (*cspan_at(&spread, i, i) > 0.0) {
largest = span_max(largest, *cspan_at(&change, i, i) / *cspan_at(&spread, i, i));
}
}
return largest;
}
static void kalman_gain(int64_t axis, double first, double second, array_double_2d spread, array_double_2d table) {
double a, b, d, determinant;
int64_t i;
array_double_1d row;
a = *cspan_at(&spread, 0, 0) + first;
b = 0.5 * (*cspan_at(&spread, 0, 1) + *cspan_at(&spread, 1, 0));
d = *cspan_at(&spread, 1, 1) + second;
if (axis == 2) {
b = 0.0;
}
determinant = a * d - b * b;
for (i = 0; i < 6; i += 1) {
row = span_row(&table, 1 + 6 * axis + i);
*cspan_at(&row, 8) = (d * *cspan_at(&spread, i, 0) - b * *cspan_at(&spread, i, 1)) / determinant;
*cspan_at(&row, 9) = (a * *cspan_at(&spread, i, 1) - b * *cspan_at(&spread, i, 0)) / determinant;
}
}
static void kalman_axis(int64_t axis, double sample_time, array_double_1d expected, array_double_2d work, array_double_2d table) {
array_double_2d transition, spread, transposed, information;
double step, wind, position, angle;
int64_t first, i, j, turns;
transition = span_rows(&work, 48, 56);
spread = span_rows(&work, 56, 64);
transposed = span_rows(&work, 0, 8);
information = span_rows(&work, 8, 16);
step = *cspan_at(&expected, 0);
wind = *cspan_at(&expected, 4);
if (axis == 2) {
step = *cspan_at(&expected, 1);
wind = 0.0;
}
position = step * step / 12.0;
angle = *cspan_at(&expected, 2) * *cspan_at(&expected, 2) / 12.0;
kalman_sampled(sample_time, *cspan_at(&expected, 3), wind, span_rows(&work, 64, 72), transition, spread, span_rows(&work, 0, 24));
first = 1 + 6 * axis;
for (i = 0; i < 6; i += 1) {
for (j = 0; j < 8; j += 1) {
*cspan_at(&table, first + i, j) = *cspan_at(&transition, i, j);
}
}
matrix_transpose(6, transition, transposed);
matrix_set(6, 0.0, information);
*cspan_at(&information, 0, 0) = 1.0 / position;
if (axis != 2) {
*cspan_at(&information, 1, 1) = 1.0 / angle;
}
turns = 0;
while((kalman_turn(6, spread, span_rows(&work, 0, 48)) > 1e-15) && (turns < 60)) {
turns = turns + 1;
}
kalman_gain(axis, position, angle, spread, table);
if (axis == 2) {
for (i = 1; i < 6; i += 2) {
for (j = 0; j < 10; j += 1) {
*cspan_at(&table, first + i, j) = 0.0;
}
}
}
}
void segfmu_observer_design(array_double_1d plant, double sample_time, double length, array_double_1d expected, array_double_2d work, array_double_2d table) {
int64_t j, axis;
for (j = 0; j < 10; j += 1) {
*cspan_at(&table, 0, j) = 0.0;
}
*cspan_at(&table, 0, 0) = length;
for (axis = 0; axis < 3; axis += 1) {
kalman_model(axis, plant, length, span_rows(&work, 64, 72));
kalman_axis(axis, sample_time, expected, work, table);
}
}
void segfmu_rope_range(double length, double shortest, double longest, array_double_1d found) {
*cspan_at(&found, 0) = shortest;
*cspan_at(&found, 1) = longest;
if (!(shortest > 0.0)) {
*cspan_at(&found, 0) = 0.2 * length;
}
if (!(longest > 0.0)) {
*cspan_at(&found, 1) = 5.0 * length;
}
}
int64_t segfmu_table_lengths(double shortest, double longest, int64_t rows, array_double_1d lengths) {
int64_t row;
*cspan_at(&lengths, 0) = shortest;
if (!(longest > shortest)) {
return 1;
}
for (row = 1; row < rows - 1; row += 1) {
*cspan_at(&lengths, row) = shortest * pow((longest / shortest), ((double)(row) / (double)((rows - 1))));
}
*cspan_at(&lengths, rows - 1) = longest;
return rows;
}
static double largest_angle(void) {
return 0.25;
}
static double largest_hoist_angle(void) {
return 0.5;
}
static double acts_late(array_double_1d plant, array_double_1d design) {
double dead, lag, result;
int64_t axis;
dead = 0.0;
lag = 0.0;
for (axis = 0; axis < 3; axis += 1) {
dead = span_max(dead, *cspan_at(&plant, 46 + axis));
lag = span_max(lag, *cspan_at(&plant, 18 + axis));
}
if ((int64_t)(*cspan_at(&plant, 24)) != 1) {
lag = 0.0;
}
result = *cspan_at(&design, 0) + *cspan_at(&design, 4) + dead + 0.25 * lag;
return result;
}
static void design_flat_gains(array_double_1d plant, array_double_1d design, double length, array_double_2d gains) {
double delay, gravity, ratio, bandwidth, hoist, pendulum;
delay = acts_late(plant, design);
gravity = *cspan_at(&plant, 3);
ratio = *cspan_at(&design, 1);
bandwidth = segfmu_feedback_bandwidth(ratio, length, gravity, delay, largest_angle());
hoist = segfmu_feedback_bandwidth(*cspan_at(&design, 2), length, gravity, delay, largest_hoist_angle());
pendulum = ratio * sqrt(gravity / length);
segfmu_feedback_gains(plant, length, bandwidth, pendulum, hoist, *cspan_at(&design, 3), gains);
}
void segfmu_flat_table(array_double_1d plant, array_double_1d design, int64_t rows, array_double_1d lengths, array_double_3d table) {
int64_t row;
for (row = 0; row < rows; row += 1) {
design_flat_gains(plant, design, *cspan_at(&lengths, row), span_matrix(&table, row));
}
}
static double sensor_step(array_double_1d sensors, int64_t signal) {
double step, deviation;
step = *cspan_at(&sensors, 13 + signal);
deviation = *cspan_at(&sensors, 8 + signal);
return sqrt(step * step + 12.0 * deviation * deviation);
}
void segfmu_set_steps(array_double_1d sensors, double longest, array_double_1d uncertainty) {
double bridge, trolley, first;
if (*cspan_at(&uncertainty, 0) == 0.0) {
bridge = sensor_step(sensors, 0);
trolley = sensor_step(sensors, 0 + 1);
*cspan_at(&uncertainty, 0) = span_max(bridge, trolley);
}
if (*cspan_at(&uncertainty, 1) == 0.0) {
*cspan_at(&uncertainty, 1) = sensor_step(sensors, 0 + 2);
}
if (*cspan_at(&uncertainty, 2) == 0.0) {
first = sensor_step(sensors, 3);
*cspan_at(&uncertainty, 2) = span_max(first, sensor_step(sensors, 3 + 1));
}
if (*cspan_at(&uncertainty, 0) == 0.0) {
*cspan_at(&uncertainty, 0) = 0.0002 * longest;
}
if (*cspan_at(&uncertainty, 1) == 0.0) {
*cspan_at(&uncertainty, 1) = 0.0002 * longest;
}
if (*cspan_at(&uncertainty, 2) == 0.0) {
*cspan_at(&uncertainty, 2) = 6.283185307179586 / 4096.0;
}
}
static void expect_errors(array_double_1d uncertainty, double gravity, double length, double sample_time, array_double_1d expected) {
double time, repeated;
time = sqrt(length / gravity);
repeated = sqrt(span_max(1.0, 0.05 * time / sample_time));
*cspan_at(&expected, 0) = repeated * *cspan_at(&uncertainty, 0);
*cspan_at(&expected, 1) = repeated * *cspan_at(&uncertainty, 1);
*cspan_at(&expected, 2) = repeated * *cspan_at(&uncertainty, 2);
*cspan_at(&expected, 3) = *cspan_at(&uncertainty, 3) * gravity / sqrt(time);
*cspan_at(&expected, 4) = *cspan_at(&uncertainty, 4) * gravity / sqrt(time);
}
bool segfmu_observer_table(array_double_1d plant, double sample_time, array_double_1d uncertainty, int64_t rows, array_double_1d lengths, array_double_1d expected, array_double_2d work, array_double_3d table) {
int64_t row, i, j;
bool finite;
finite = 1;
for (row = 0; row < rows; row += 1) {
expect_errors(uncertainty, *cspan_at(&plant, 3), *cspan_at(&lengths, row), sample_time, expected);
segfmu_observer_design(plant, sample_time, *cspan_at(&lengths, row), expected, work, span_matrix(&table, row));
for (i = 0; i < 19; i += 1) {
for (j = 0; j < 10; j += 1) {
finite = finite && (fabs(*cspan_at(&table, row, i, j)) <= 1.7976931348623157e+308);
}
}
}
return finite;
}
static void offset_filter(bool first, double share, array_double_1d signals, array_double_2d states) {
int64_t i, k;
double before, lagged, entering;
for (i = 0; i < 7; i += 1) {
before = *cspan_at(&states, 0, i);
*cspan_at(&states, 0, i) = *cspan_at(&signals, i);
for (k = 1; k < 4; k += 1) {
lagged = *cspan_at(&states, k, i);
entering = before + *cspan_at(&states, k - 1, i);
*cspan_at(&states, k, i) = ((1.0 - share) * lagged + share * entering) / (1.0 + share);
if (first) {
*cspan_at(&states, k, i) = *cspan_at(&signals, i);
}
before = lagged;
}
}
}
static void offset_signals(array_double_1d measured, double start, array_double_1d signals) {
double phi_x, phi_y, length, place;
int64_t i;
phi_x = *cspan_at(&measured, 3);
phi_y = *cspan_at(&measured, 3 + 1);
*cspan_at(&signals, 3 + 0) = sin(phi_x);
*cspan_at(&signals, 3 + 1) = (-cos(phi_x)) * sin(phi_y);
*cspan_at(&signals, 3 + 2) = (-cos(phi_x)) * cos(phi_y);
length = *cspan_at(&measured, 0 + 2);
for (i = 0; i < 3; i += 1) {
*cspan_at(&signals, 0 + i) = length * *cspan_at(&signals, 3 + i);
}
for (i = 0; i < 2; i += 1) {
place = *cspan_at(&signals, 0 + i);
*cspan_at(&signals, 0 + i) = place + *cspan_at(&measured, 0 + i);
}
*cspan_at(&signals, 6) = start;
}
static double second_difference(int64_t signal, array_double_2d states) {
double difference, result;
difference = *cspan_at(&states, 1, signal) - 2.0 * *cspan_at(&states, 2, signal);
result = difference + *cspan_at(&states, 3, signal);
return result;
}
static int64_t offset_residual(double* result_0_0001, double* result_1_0001, int64_t axis, double gravity, double square, array_double_2d states) {
int64_t sideways, upwards;
double place, height, turn, drop, across, down;
sideways = 3 + axis;
upwards = 3 + 2;
place = square * second_difference(0 + axis, states);
height = square * second_difference(0 + 2, states) + gravity;
turn = square * second_difference(sideways, states);
drop = square * second_difference(upwards, states);
across = *cspan_at(&states, 3, sideways);
down = *cspan_at(&states, 3, upwards);
(*result_0_0001) = height * across - place * down;
(*result_1_0001) = drop * across - turn * down;
return 0;
}
static int64_t offset_noise(double* result_0, double* result_1_0001, array_double_1d parameters, double length) {
double w, gravity, share, fifth, angle, of_angles, residual;
w = *cspan_at(&parameters, 24);
gravity = *cspan_at(&parameters, 6);
share = *cspan_at(&parameters, 1) / 16.0;
fifth = 3.0 * w * w * w * w * w;
angle = length * length * fifth + gravity * w * (3.0 * gravity - 2.0 * length * w * w);
of_angles = angle * *cspan_at(&parameters, 25);
residual = share * (of_angles + fifth * *cspan_at(&parameters, 26));
(*result_0) = residual;
(*result_1_0001) = share * fifth * *cspan_at(&parameters, 25);
return 0;
}
static void offset_centre(int64_t axis, double share, array_double_1d values, array_double_1d means) {
int64_t i, k;
for (i = 0; i < 3; i += 1) {
k = 0 + 3 * axis + i;
*cspan_at(&means, k) = *cspan_at(&means, k) + share * (*cspan_at(&values, i) - *cspan_at(&means, k));
*cspan_at(&values, i) = *cspan_at(&values, i) - *cspan_at(&means, k);
}
}
static void offset_sum(double keep, array_double_1d values, array_double_1d sums) {
double residual, factor, instrument, square;
residual = *cspan_at(&values, 0);
factor = *cspan_at(&values, 1);
instrument = *cspan_at(&values, 2);
square = instrument * instrument;
*cspan_at(&sums, 0) = keep * *cspan_at(&sums, 0) + instrument * residual;
*cspan_at(&sums, 1) = keep * *cspan_at(&sums, 1) + instrument * factor;
*cspan_at(&sums, 2) = keep * *cspan_at(&sums, 2) + square * residual * residual;
*cspan_at(&sums, 3) = keep * *cspan_at(&sums, 3) + square * residual * factor;
*cspan_at(&sums, 4) = keep * *cspan_at(&sums, 4) + square * factor * factor;
*cspan_at(&sums, 5) = keep * *cspan_at(&sums, 5) + square;
}
static void offset_decide(array_double_1d parameters, double length, double noise, array_double_1d sums, array_double_1d estimate) {
double period, bandwidth, samples, offset, left, least, deviation, largest;
period = *cspan_at(&parameters, 1);
bandwidth = *cspan_at(&parameters, 24);
samples = 2.0 / (bandwidth * period);
offset = *cspan_at(&sums, 0) / *cspan_at(&sums, 1);
left = *cspan_at(&sums, 2) - 2.0 * offset * *cspan_at(&sums, 3);
left = left + offset * offset * *cspan_at(&sums, 4);
least = noise * *cspan_at(&sums, 5) / 16.0;
deviation = sqrt(samples * (span_max(left, 0.0) + least)) / *cspan_at(&sums, 1);
*cspan_at(&estimate, 0) = offset;
*cspan_at(&estimate, 1) = deviation;
*cspan_at(&estimate, 2) = *cspan_at(&estimate, 2) + 1.0;
largest = 3.0 * *cspan_at(&parameters, 23) * length;
if ((fabs(offset) < 5.0 * deviation) || (fabs(offset) > largest)) {
*cspan_at(&estimate, 2) = 0.0;
}
if (*cspan_at(&estimate, 2) * period * bandwidth > 5.0) {
*cspan_at(&estimate, 3) = offset;
*cspan_at(&estimate, 4) = 1.0;
}
else if (fabs(offset - *cspan_at(&estimate, 3)) > 3.0 * deviation) {
*cspan_at(&estimate, 4) = 0.0;
}
}
static void offset_equations(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory) {
array_double_1d means, signals, equation;
array_double_2d filtered, planned;
bool first;
double start, bandwidth, step, square, gravity, seen, factor, expected, instrument, residual, settling;
int64_t axis;
means = span_row(&memory, 8);
signals = span_row(&memory, 11);
filtered = span_rows(&memory, 0, 4);
planned = span_rows(&memory, 4, 8);
first = *cspan_at(&means, 8) < 0.5;
*cspan_at(&means, 8) = 1.0;
start = 0.0;
if (first) {
start = 1.0;
}
bandwidth = *cspan_at(&parameters, 24);
step = bandwidth * *cspan_at(&parameters, 1);
square = bandwidth * bandwidth;
offset_signals(measured, start, signals);
offset_filter(first, 0.5 * step, signals, filtered);
offset_signals(reference, start, signals);
offset_filter(first, 0.5 * step, signals, planned);
for (axis = 0; axis < 2; axis += 1) {
gravity = *cspan_at(&parameters, 6);
offset_residual(&seen, &factor, axis, gravity, square, filtered);
offset_residual(&expected, &instrument, axis, gravity, square, planned);
residual = expected - seen;
if (first) {
*cspan_at(&means, 6 + axis) = residual;
}
settling = *cspan_at(&filtered, 3, 6);
equation = span_row(&memory, 12 + axis);
*cspan_at(&equation, 0) = residual - *cspan_at(&means, 6 + axis) * settling;
*cspan_at(&equation, 1) = factor;
*cspan_at(&equation, 2) = instrument;
offset_centre(axis, step / 12.0, equation, means);
}
}
static double offset_estimate(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory) {
array_double_1d sums, estimate;
double length, noise, factor_noise, power, instrument, step, aim, used, result;
int64_t axis;
if (*cspan_at(&parameters, 23) <= 0.0) {
return 0.0;
}
sums = span_row(&memory, 10);
estimate = span_row(&memory, 9);
length = *cspan_at(&measured, 0 + 2);
offset_equations(parameters, measured, reference, memory);
offset_noise(&noise, &factor_noise, parameters, length);
power = 0.0;
for (axis = 0; axis < 2; axis += 1) {
instrument = *cspan_at(&memory, 12 + axis, 2);
power = power + instrument * instrument;
}
if (power > 9.0 * factor_noise) {
step = *cspan_at(&parameters, 24) * *cspan_at(&parameters, 1);
offset_sum(1.0 - step / 60.0, span_row(&memory, 12), sums);
offset_sum(1.0, span_row(&memory, 12 + 1), sums);
if (*cspan_at(&sums, 1) > 0.0) {
offset_decide(parameters, length, noise, sums, estimate);
}
}
aim = *cspan_at(&estimate, 4) * *cspan_at(&estimate, 3);
used = *cspan_at(&estimate, 5);
*cspan_at(&estimate, 5) = aim + *cspan_at(&parameters, 11) * (used - aim);
result = *cspan_at(&estimate, 5);
return result;
}
double segfmu_nominal_payload(double expected, double payload) {
if (expected > 0.0) {
return expected;
}
return payload;
}
double segfmu_signal_age(double dead_time, double sampling, double period) {
double age, ratio;
if (sampling <= 0.0) {
return dead_time;
}
age = sampling * (int64_t)ceil(dead_time / sampling - 1e-06);
ratio = period / sampling;
if (fabs(ratio - (int64_t)floor(ratio + 0.5)) > 1e-06) {
age = dead_time + 0.5 * sampling;
}
return age;
}
double segfmu_drive_bound(array_double_1d plant, int64_t axis, double sign) {
double moved, by_force, bound;
bound = static_bound(plant, axis, sign);
if ((int64_t)(*cspan_at(&plant, 24)) == 1) {
moved = carriage_mass(plant, axis) + *cspan_at(&plant, 2);
by_force = bound / moved;
if ((axis == 2) && (sign > 0.0)) {
by_force = 0.0;
}
else if ((axis == 2) && (bound > 0.0)) {
by_force = span_max(by_force - *cspan_at(&plant, 3), 0.001 * *cspan_at(&plant, 3));
}
bound = acceleration_bound(plant, axis, sign);
if ((by_force > 0.0) && ((bound <= 0.0) || (by_force < bound))) {
bound = by_force;
}
}
if (bound > 0.0) {
return bound;
}
return 1e+99;
}
static double weak_drive(void) {
return 0.1;
}
static double drive_strength(array_double_1d plant, int64_t axis) {
double weight, weaker;
weight = *cspan_at(&plant, 3);
if ((int64_t)(*cspan_at(&plant, 24)) == 0) {
weight = weight * carriage_mass(plant, axis);
}
weaker = span_min(segfmu_drive_bound(plant, axis, 1.0), segfmu_drive_bound(plant, axis, -1.0));
return span_min(weaker / (weak_drive() * weight), 1.0);
}
void segfmu_set_walks(array_double_1d plant, array_double_1d uncertainty) {
double strength;
strength = span_min(drive_strength(plant, 0), drive_strength(plant, 1));
*cspan_at(&uncertainty, 4) = strength * *cspan_at(&uncertainty, 4);
}
void segfmu_set_drives(array_double_1d plant, array_double_1d tracking) {
int64_t axis;
double greatest;
*cspan_at(&tracking, 0) = *cspan_at(&plant, 24);
*cspan_at(&tracking, 3 + 0) = carriage_mass(plant, 0);
*cspan_at(&tracking, 3 + 1) = carriage_mass(plant, 1);
*cspan_at(&tracking, 3 + 2) = *cspan_at(&plant, 2);
*cspan_at(&tracking, 6) = *cspan_at(&plant, 3);
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&tracking, 15 + axis) = segfmu_drive_bound(plant, axis, 1.0);
*cspan_at(&tracking, 12 + axis) = -segfmu_drive_bound(plant, axis, -1.0);
*cspan_at(&tracking, 30 + axis) = *cspan_at(&plant, 37 + axis);
*cspan_at(&tracking, 33 + axis) = *cspan_at(&plant, 40 + axis);
*cspan_at(&tracking, 36 + axis) = *cspan_at(&plant, 43 + axis);
}
greatest = 0.0;
if ((int64_t)(*cspan_at(&plant, 24)) == 1) {
greatest = span_min(0.9 * *cspan_at(&plant, 3), *cspan_at(&tracking, 15 + 2));
}
*cspan_at(&tracking, 15 + 2) = greatest;
}
static void set_noise(array_double_1d uncertainty, double gravity, double longest, array_double_1d tracking) {
double wake, angle, place;
wake = *cspan_at(&uncertainty, 5);
*cspan_at(&tracking, 20) = wake * *cspan_at(&uncertainty, 0);
*cspan_at(&tracking, 21) = wake * *cspan_at(&uncertainty, 1);
*cspan_at(&tracking, 22) = wake * *cspan_at(&uncertainty, 2);
*cspan_at(&tracking, 23) = *cspan_at(&uncertainty, 6);
*cspan_at(&tracking, 24) = span_min(4.0 * sqrt(gravity / longest), 0.5 / *cspan_at(&tracking, 1));
angle = *cspan_at(&uncertainty, 2);
place = span_max(*cspan_at(&uncertainty, 0), *cspan_at(&uncertainty, 1));
*cspan_at(&tracking, 25) = angle * angle / 12.0;
*cspan_at(&tracking, 26) = place * place / 12.0;
}
void segfmu_set_tracking(array_double_1d plant, array_double_1d design, double longest, array_double_1d tracking) {
double period, age;
int64_t axis;
period = *cspan_at(&tracking, 1);
segfmu_set_drives(plant, tracking);
age = segfmu_signal_age(*cspan_at(&design, 7), *cspan_at(&design, 8), period);
*cspan_at(&tracking, 2) = age / period;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&tracking, 27 + axis) = (age + *cspan_at(&plant, 46 + axis)) / period;
}
*cspan_at(&tracking, 19) = period / *cspan_at(&design, 9);
set_noise(design, *cspan_at(&plant, 3), longest, tracking);
}
void segfmu_set_fading(array_double_1d tracking) {
double fade;
fade = *cspan_at(&tracking, 10);
*cspan_at(&tracking, 11) = 0.0;
if (fade > 0.0) {
*cspan_at(&tracking, 11) = exp((-*cspan_at(&tracking, 1)) / fade);
}
}
static double spectral_radius(int64_t n, double enough, array_double_2d a, array_double_2d square) {
double total, weight, size;
int64_t Dummy_0000, i, j;
total = 0.0;
weight = 1.0;
for (Dummy_0000 = 0; Dummy_0000 < 30; Dummy_0000 += 1) {
size = 0.0;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
size = span_max(size, fabs(*cspan_at(&a, i, j)));
}
}
if (!(size > 0.0)) {
return 0.0;
}
total = total + weight * log(size);
if (total + weight * log((double)(n)) <= log(enough)) {
return enough;
}
weight = 0.5 * weight;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&a, i, j) = *cspan_at(&a, i, j) / size;
}
}
matrix_product(n, a, a, square);
matrix_copy(n, square, a);
}
return exp(total);
}
static void sampled_transition(double sample_time, array_double_2d model, array_double_2d transition, array_double_2d work) {
int64_t doublings, Dummy_0000;
array_double_2d term, product;
doublings = halvings_below(8, sample_time, model);
term = span_rows(&work, 0, 8);
product = span_rows(&work, 8, 2 * 8);
matrix_exponential(8, sample_time / pow(2.0, (double)(doublings)), model, transition, term, product);
for (Dummy_0000 = 0; Dummy_0000 < doublings; Dummy_0000 += 1) {
matrix_product(8, transition, transition, term);
matrix_copy(8, term, transition);
}
}
static bool is_state(int64_t axis, bool lagging, int64_t place) {
if (place == 6) {
return lagging;
}
if ((place == 1) || (place == 3)) {
return axis != 2;
}
return (place == 0) || (place == 2);
}
static void axis_gains(int64_t axis, array_double_1d plant, double length, array_double_3d table, array_double_1d gains) {
double sign, scale, command, place, velocity;
bool driven;
int64_t i;
sign = 1.0 - 2.0 * axis;
scale = 1.0;
driven = (int64_t)(*cspan_at(&plant, 24)) == 1;
if ((axis == 2) && (!driven)) {
scale = 1.0 / *cspan_at(&plant, 2);
}
for (i = 0; i < 8; i += 1) {
*cspan_at(&gains, i) = 0.0;
}
command = scale * scheduled_gain(length, axis, 10, table);
*cspan_at(&gains, 6) = command;
place = scheduled_gain(length, axis, 0 + axis, table);
velocity = scheduled_gain(length, axis, 5 + axis, table);
*cspan_at(&gains, 0) = scale * place;
*cspan_at(&gains, 2) = scale * velocity;
if (driven && (*cspan_at(&plant, 18 + axis) <= 0.0)) {
*cspan_at(&gains, 2) = scale * velocity + command;
}
if (axis != 2) {
*cspan_at(&gains, 1) = sign * scheduled_gain(length, axis, 3 + axis, table);
*cspan_at(&gains, 3) = sign * scheduled_gain(length, axis, 8 + axis, table);
}
}
static int64_t close_loop(int64_t axis, bool lagging, double delay, array_double_1d gains, array_double_2d work) {
array_double_2d transition, loop;
int64_t own, whole, i, j, order;
double share, effect;
transition = span_rows(&work, 8, 16);
loop = span_rows(&work, 32, 80);
own = 7;
whole = span_min_int((int64_t)(delay + 1e-09), 48 - own - 2);
share = span_min(span_max(delay - whole, 0.0), 1.0);
order = own + whole;
if (share > 1e-09) {
order = order + 1;
}
for (i = 0; i < order; i += 1) {
for (j = 0; j < order; j += 1) {
*cspan_at(&loop, i, j) = 0.0;
}
}
for (i = 0; i < own; i += 1) {
if (is_state(axis, lagging, i)) {
effect = *cspan_at(&transition, i, 7);
for (j = 0; j < own; j += 1) {
if (is_state(axis, lagging, j)) {
*cspan_at(&loop, i, j) = *cspan_at(&transition, i, j);
if (whole == 0) {
*cspan_at(&loop, i, j) = *cspan_at(&loop, i, j) - (1.0 - share) * effect * *cspan_at(&gains, j);
}
}
}
if (whole > 0) {
*cspan_at(&loop, i, own + whole - 1) = (1.0 - share) * effect;
}
if (share > 1e-09) {
*cspan_at(&loop, i, own + whole) = share * effect;
}
}
}
for (i = own; i < order; i += 1) {
if (i > own) {
*cspan_at(&loop, i, i - 1) = 1.0;
}
else {
for (j = 0; j < own; j += 1) {
if (is_state(axis, lagging, j)) {
*cspan_at(&loop, i, j) = -*cspan_at(&gains, j);
}
}
}
}
return order;
}
int64_t segfmu_check_gains(array_double_1d plant, double period, int64_t predicted, array_double_1d ends, array_double_3d table, array_double_2d work, array_double_1d fault) {
array_double_1d lengths, gains;
int64_t count, axis, row, order, status;
bool driven, lagging;
double delay, growth;
lengths = span_row(&work, 128);
gains = span_row(&work, 129);
count = segfmu_table_lengths(*cspan_at(&ends, 0), *cspan_at(&ends, 1), 33, lengths);
status = 0;
*cspan_at(&fault, 3) = 1.0 + 1e-06;
for (axis = 0; axis < 3; axis += 1) {
driven = (int64_t)(*cspan_at(&plant, 24)) == 1;
lagging = driven && (*cspan_at(&plant, 18 + axis) > 0.0);
delay = *cspan_at(&plant, 46 + axis) / period;
if (predicted == 1) {
delay = 0.0;
}
for (row = 0; row < count; row += 1) {
kalman_model(axis, plant, *cspan_at(&lengths, row), span_rows(&work, 0, 8));
sampled_transition(period, span_rows(&work, 0, 8), span_rows(&work, 8, 16), span_rows(&work, 16, 32));
axis_gains(axis, plant, *cspan_at(&lengths, row), table, gains);
order = close_loop(axis, lagging, delay, gains, work);
growth = spectral_radius(order, *cspan_at(&fault, 3), span_rows(&work, 32, 80), span_rows(&work, 80, 128));
if (growth > *cspan_at(&fault, 3)) {
*cspan_at(&fault, 3) = growth;
*cspan_at(&fault, 1) = (double)(axis);
*cspan_at(&fault, 2) = *cspan_at(&lengths, row);
status = 15;
}
}
}
return status;
}
static void track_wake(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory) {
int64_t i;
double tolerance;
for (i = 0; i < 5; i += 1) {
tolerance = *cspan_at(&parameters, 20);
if (i == 0 + 2) {
tolerance = *cspan_at(&parameters, 21);
}
else if (i >= 3) {
tolerance = *cspan_at(&parameters, 22);
}
if (fabs(*cspan_at(&measured, i) - *cspan_at(&reference, i)) > tolerance) {
*cspan_at(&memory, 4, 6) = 1.0;
}
}
}
static void track_offset(array_double_1d parameters, array_double_2d tick, array_double_2d memory) {
array_double_1d measured, hoist;
array_double_2d offsets;
double before, offset;
int64_t length, i;
measured = span_row(&tick, 0);
offsets = span_rows(&memory, 11, 11 + 14);
before = *cspan_at(&offsets, 9, 5);
offset = offset_estimate(parameters, measured, span_row(&memory, 6), offsets);
if (*cspan_at(&parameters, 40) < 0.5) {
offset = 0.0;
before = 0.0;
}
hoist = span_row(&memory, 0 + 2);
*cspan_at(&hoist, 0) = *cspan_at(&hoist, 0) + (offset - before);
length = 0 + 2;
for (i = 0; i < 5; i += 1) {
*cspan_at(&memory, 10, i) = *cspan_at(&measured, i);
}
*cspan_at(&memory, 10, length) = *cspan_at(&measured, length) + offset;
}
static void track_start(array_double_1d measured, array_double_1d reference, array_double_2d memory) {
array_double_2d estimate;
int64_t i, phi_x, phi_y;
estimate = span_rows(&memory, 0, 3);
for (i = 0; i < 3; i += 1) {
*cspan_at(&estimate, i, 0) = *cspan_at(&measured, i) - *cspan_at(&reference, i);
}
phi_x = 3;
phi_y = 3 + 1;
*cspan_at(&estimate, 0, 1) = *cspan_at(&measured, phi_x) - *cspan_at(&reference, phi_x);
*cspan_at(&estimate, 1, 1) = *cspan_at(&reference, phi_y) - *cspan_at(&measured, phi_y);
*cspan_at(&memory, 3, 3) = 1.0;
}
static void track_observe(array_double_1d parameters, array_double_3d table, array_double_2d memory) {
array_double_1d measured, reference;
double length;
measured = span_row(&memory, 10);
reference = span_row(&memory, 6);
length = *cspan_at(&measured, 0 + 2);
track_wake(parameters, measured, reference, memory);
if (*cspan_at(&memory, 3, 3) < 0.5) {
track_start(measured, reference, memory);
}
else {
advance_estimates(parameters, length, table, memory);
segfmu_observer_correct(length, table, measured, reference, span_rows(&memory, 0, 3));
}
predict_present(parameters, length, table, memory);
}
static bool track_acts(array_double_1d parameters, array_double_2d memory) {
bool result;
result = (*cspan_at(&parameters, 9) > 0.5) && (*cspan_at(&memory, 4, 6) > 0.5);
return result;
}
static void track_deviation(array_double_1d parameters, array_double_2d memory) {
double length, moves, slant, sign, rejected, angle;
array_double_1d deviation, target, estimate;
int64_t i, place;
length = *cspan_at(&memory, 10, 0 + 2);
deviation = span_row(&memory, 7);
target = span_row(&memory, 8);
for (i = 0; i < 10; i += 1) {
*cspan_at(&target, i) = 0.0;
}
moves = 1.0;
if ((int64_t)(*cspan_at(&parameters, 39)) == 1) {
moves = 0.0;
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&deviation, 0 + i) = *cspan_at(&memory, 25 + i, 0);
*cspan_at(&deviation, 5 + i) = *cspan_at(&memory, 25 + i, 2);
}
slant = 0.0;
for (i = 0; i < 2; i += 1) {
estimate = span_row(&memory, 25 + i);
sign = 1.0 - 2.0 * i;
rejected = *cspan_at(&parameters, 8) * *cspan_at(&estimate, 5);
angle = rejected / *cspan_at(&parameters, 6);
place = 0 + i;
*cspan_at(&deviation, place) = *cspan_at(&deviation, place) + moves * length * angle;
*cspan_at(&deviation, 3 + i) = sign * (*cspan_at(&estimate, 1) - angle);
*cspan_at(&deviation, 8 + i) = sign * *cspan_at(&estimate, 3);
slant = slant + 0.5 * moves * length * angle * angle;
}
*cspan_at(&target, 0 + 2) = length - *cspan_at(&deviation, 0 + 2) + slant;
*cspan_at(&deviation, 0 + 2) = length;
}
static void track_situation(array_double_1d parameters, array_double_2d tick, array_double_2d memory) {
array_double_1d situation, deviation;
double length, share, weight, velocity, place, rate, sign;
int64_t i;
situation = span_row(&memory, 30);
deviation = span_row(&memory, 7);
length = *cspan_at(&memory, 10, 0 + 2);
share = *cspan_at(&memory, 5, 3);
weight = *cspan_at(&parameters, 3 + 2) * *cspan_at(&parameters, 6);
*cspan_at(&situation, 0) = (1.0 + share) * weight;
*cspan_at(&situation, 1) = length;
for (i = 0; i < 3; i += 1) {
velocity = *cspan_at(&memory, 25 + i, 2);
if ((int64_t)(*cspan_at(&parameters, 0)) == 1) {
velocity = *cspan_at(&memory, 3, 0 + i);
}
velocity = velocity + *cspan_at(&tick, 1, 5 + i);
*cspan_at(&situation, 2 + i) = velocity;
place = *cspan_at(&deviation, 0 + i) - *cspan_at(&memory, 8, 0 + i);
rate = *cspan_at(&deviation, 5 + i);
if (i != 2) {
sign = 1.0 - 2.0 * i;
place = place + length * sign * *cspan_at(&deviation, 3 + i);
rate = rate + length * sign * *cspan_at(&deviation, 8 + i);
}
*cspan_at(&situation, 5 + i) = place;
*cspan_at(&situation, 8 + i) = rate;
}
}
static void track_forces(array_double_1d parameters, array_double_2d memory, array_double_1d correction) {
double rejected, payload, mass, pull, drift, rope, share;
int64_t i;
array_double_1d estimate;
rejected = *cspan_at(&parameters, 7);
payload = *cspan_at(&parameters, 3 + 2);
for (i = 0; i < 2; i += 1) {
estimate = span_row(&memory, 25 + i);
mass = rejected * *cspan_at(&parameters, 3 + i);
pull = *cspan_at(&parameters, 8) * payload * *cspan_at(&estimate, 5);
*cspan_at(&correction, i) = *cspan_at(&correction, i) - mass * *cspan_at(&estimate, 4) - pull;
}
drift = *cspan_at(&memory, 25 + 2, 4);
rope = *cspan_at(&correction, 2) / *cspan_at(&parameters, 18) - rejected * drift;
share = *cspan_at(&memory, 5, 3);
rope = (1.0 + share) * rope - share * *cspan_at(&parameters, 6);
*cspan_at(&correction, 2) = payload * rope;
}
static void track_law(array_double_1d parameters, array_double_3d gains, array_double_2d tick, array_double_2d memory) {
array_double_1d correction;
bool driven;
int64_t i;
double added, fade;
correction = span_row(&tick, 3);
driven = (int64_t)(*cspan_at(&parameters, 0)) == 1;
track_deviation(parameters, memory);
track_situation(parameters, tick, memory);
if (!track_acts(parameters, memory)) {
for (i = 0; i < 3; i += 1) {
*cspan_at(&correction, i) = 0.0;
if (driven) {
added = *cspan_at(&memory, 3, 0 + i);
fade = span_max(*cspan_at(&parameters, 10), *cspan_at(&parameters, 1));
*cspan_at(&correction, i) = (-added) / fade;
}
}
return;
}
segfmu_feedback_correction(span_row(&memory, 7), span_row(&memory, 8), span_row(&memory, 3), gains, correction);
for (i = 0; i < 3; i += 1) {
bound_return(i, parameters, gains, tick, span_row(&memory, 30));
}
if (!driven) {
track_forces(parameters, memory, correction);
}
}
static void track_hoist(array_double_1d parameters, array_double_2d memory) {
double gravity, share, force, rope;
array_double_1d held;
gravity = *cspan_at(&parameters, 6);
held = span_row(&memory, 4);
share = *cspan_at(&memory, 5, 3);
force = *cspan_at(&held, 3 + 2);
rope = (force / *cspan_at(&parameters, 3 + 2) + share * gravity) / (1.0 + share);
*cspan_at(&held, 0 + 2) = rope;
if (track_acts(parameters, memory)) {
share = share - *cspan_at(&parameters, 19) * (1.0 + share) * rope / gravity;
*cspan_at(&memory, 5, 3) = span_min(span_max(share, -0.98), 9.0);
}
}
void segfmu_track_setpoint(array_double_1d parameters, array_double_3d table, array_double_3d gains, array_double_2d tick, array_double_2d memory) {
array_double_1d correction, held, step, reference;
int64_t i;
correction = span_row(&tick, 3);
held = span_row(&memory, 4);
step = span_row(&memory, 5);
reference = span_row(&tick, 1);
if (*cspan_at(&memory, 3, 3) < 0.5) {
remember_start(reference, memory);
}
remember_tick(parameters, reference, memory);
aged_reference(parameters, memory);
track_offset(parameters, tick, memory);
track_observe(parameters, table, memory);
track_law(parameters, gains, tick, memory);
for (i = 0; i < 3; i += 1) {
if (*cspan_at(&memory, 3, 4) > 0.5) {
*cspan_at(&step, 0 + i) = *cspan_at(&held, 3 + i) - *cspan_at(&correction, i);
}
*cspan_at(&step, 0 + i) = *cspan_at(&parameters, 11) * *cspan_at(&step, 0 + i);
*cspan_at(&correction, i) = *cspan_at(&correction, i) + *cspan_at(&step, 0 + i);
bound_correction(i, parameters, tick, span_row(&memory, 30));
*cspan_at(&held, 3 + i) = *cspan_at(&correction, i);
*cspan_at(&held, 0 + i) = *cspan_at(&correction, i);
}
if ((int64_t)(*cspan_at(&parameters, 0)) == 0) {
track_hoist(parameters, memory);
}
*cspan_at(&memory, 3, 4) = 0.0;
}
static void crane_rhs_partials(array_double_1d state, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_2d partials) {
double l, phi_x, phi_y, l_rate, phi_x_rate, phi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, f_x_t, f_y_t, f_l, f_phi_x, f_phi_y, w_x, w_y, w_z, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c40, c41, c42, c43, c44, c45, c46, c47, c48, c49, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c60, c61, c62, c63, c64, c65, c66, c67, c68, c69, c70, c71, c72, c73, c74, c75, c76, c77, c78, c79, c80, c81, c82, c83, c84, c85, c86, c87, c88, c89, c90, c91, c92, c93, c94, c95, c96, c97, c98, c99, c100, c101, c102, c103, c104, c105, c106, c107, c108, c109, c110, c111, c112;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
l_rate = *cspan_at(&state, 7);
phi_x_rate = *cspan_at(&state, 8);
phi_y_rate = *cspan_at(&state, 9);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
f_x_t = *cspan_at(&generalized_force, 0);
f_y_t = *cspan_at(&generalized_force, 1);
f_l = *cspan_at(&generalized_force, 2);
f_phi_x = *cspan_at(&generalized_force, 3);
f_phi_y = *cspan_at(&generalized_force, 4);
w_x = *cspan_at(&load_force, 0);
w_y = *cspan_at(&load_force, 1);
w_z = *cspan_at(&load_force, 2);
c0 = 1 / (bridge_mass + trolley_mass);
c1 = 1 / (l * l);
c2 = cos(phi_x);
c3 = c2 * f_phi_x;
c4 = c0 * c1 * c3;
c5 = c2 * f_l;
c6 = 1 / l;
c7 = sin(phi_x);
c8 = c7 * f_phi_x;
c9 = c6 * c8;
c10 = c5 - c9;
c11 = c0 * c10;
c12 = (-c0) * c7;
c13 = c2 * c6;
c14 = (-c0) * c13;
c15 = sin(phi_y);
c16 = cos(phi_y);
c17 = 1 / c2;
c18 = c17 * f_phi_y;
c19 = c16 * c18;
c20 = c15 * c8 - c19;
c21 = 1 / trolley_mass;
c22 = c1 * c21;
c23 = c20 * c22;
c24 = c7 * f_l;
c25 = c13 * f_phi_x;
c26 = c16 * c7;
c27 = c2 * c2;
c28 = 1 / c27;
c29 = c28 * c6 * f_phi_y;
c30 = c15 * c24 + c15 * c25 - c26 * c29;
c31 = (-c21) * c30;
c32 = c15 * c18;
c33 = (-c16) * c5 + c16 * c9 + c32 * c6;
c34 = c15 * c2;
c35 = c21 * c34;
c36 = c15 * c7;
c37 = c21 * c6;
c38 = (-c36) * c37;
c39 = c17 * c6;
c40 = c16 * c39;
c41 = c21 * c40;
c42 = 1 / payload_mass;
c43 = c1 * c42;
c44 = c3 * c43 + c4 - c7 * (phi_x_rate * phi_x_rate);
c45 = c16 * c2;
c46 = c45 * phi_x_rate;
c47 = c7 * phi_y_rate;
c48 = c15 * c47;
c49 = c46 - c48;
c50 = c7 * phi_x_rate;
c51 = c15 * c50;
c52 = (-c16) * c2 * phi_y_rate + c51;
c53 = -c52;
c54 = c43 * (c16 * c8 + c32) + c49 * phi_x_rate + c53 * phi_y_rate;
c55 = c34 * phi_x_rate;
c56 = c16 * c47;
c57 = c55 + c56;
c58 = c16 * c50;
c59 = c34 * phi_y_rate;
c60 = c58 + c59;
c61 = c20 * c43 + c23 + c57 * phi_x_rate + c60 * phi_y_rate;
c62 = c7 * l_rate;
c63 = c10 * c42 + c11 + c62 * phi_x_rate + phi_x_rate * (c2 * l * phi_x_rate + c62);
c64 = c2 * l_rate;
c65 = c50 * l - c64;
c66 = c24 + c25;
c67 = c42 * (c66 + w_x);
c68 = c66 - f_x_t;
c69 = c15 * c62 + c55 * l + c56 * l;
c70 = c69 * phi_y_rate;
c71 = (-c16) * c64 + c58 * l + c59 * l;
c72 = c42 * (c16 * c24 + c16 * c25 + c29 * c36);
c73 = c16 * c62 + c46 * l - c48 * l;
c74 = c15 * c64 + c45 * l * phi_y_rate - c51 * l;
c75 = c60 * l_rate + c73 * phi_x_rate + c74 * phi_y_rate;
c76 = (-c42) * (c33 + w_z) + c75 + gravity;
c77 = c16 * c76;
c78 = c15 * c5 - c15 * c9 + c19 * c6;
c79 = c78 - w_y;
c80 = c69 * phi_x_rate;
c81 = c21 * (c78 + f_y_t) + c52 * l_rate + c71 * phi_y_rate + c80;
c82 = (-c30) * c42 + c57 * l_rate + c73 * phi_y_rate + c74 * phi_x_rate;
c83 = -c71;
c84 = (-c42) * c78 + c53 * l_rate - c80 + c83 * phi_y_rate;
c85 = c15 * c76;
c86 = (-c21) * c33 - c33 * c42 + c75;
c87 = c42 * c79 + c81;
c88 = c16 * c87;
c89 = c15 * c86 + c16 * c84 - c85 + c88;
c90 = c16 * c60;
c91 = c15 * c52;
c92 = 2 * c2;
c93 = c15 * c71 + c16 * c74;
c94 = c16 * c16;
c95 = c42 * c94;
c96 = c7 * c7;
c97 = c0 + c42;
c98 = c15 * c15;
c99 = c21 + c42;
c100 = c98 * c99;
c101 = c13 * c7 * (c0 - c100 + c42 - c95);
c102 = c15 * c16 * c37;
c103 = c42 * c7;
c104 = (-c0) * c68 + c64 * phi_x_rate - c65 * phi_x_rate - c67;
c105 = c49 * l_rate - c70 - c72 + c83 * phi_x_rate;
c106 = c15 * c87;
c107 = (-c21) * c30 + c82;
c108 = c6 * c7;
c109 = 2 * c6;
c110 = (-c16) * c17 * c22 * c36;
c111 = c103 * c6;
c112 = c109 * c17;
*cspan_at(&partials, 0, 0) = 0.0;
*cspan_at(&partials, 0, 1) = 0.0;
*cspan_at(&partials, 0, 2) = c4;
*cspan_at(&partials, 0, 3) = -c11;
*cspan_at(&partials, 0, 4) = 0.0;
*cspan_at(&partials, 0, 5) = 0.0;
*cspan_at(&partials, 0, 6) = 0.0;
*cspan_at(&partials, 0, 7) = 0.0;
*cspan_at(&partials, 0, 8) = 0.0;
*cspan_at(&partials, 0, 9) = 0.0;
*cspan_at(&partials, 0, 10) = c0;
*cspan_at(&partials, 0, 11) = 0.0;
*cspan_at(&partials, 0, 12) = c12;
*cspan_at(&partials, 0, 13) = c14;
*cspan_at(&partials, 0, 14) = 0.0;
*cspan_at(&partials, 0, 15) = 0.0;
*cspan_at(&partials, 0, 16) = 0.0;
*cspan_at(&partials, 0, 17) = 0.0;
*cspan_at(&partials, 1, 0) = 0.0;
*cspan_at(&partials, 1, 1) = 0.0;
*cspan_at(&partials, 1, 2) = c23;
*cspan_at(&partials, 1, 3) = c31;
*cspan_at(&partials, 1, 4) = (-c21) * c33;
*cspan_at(&partials, 1, 5) = 0.0;
*cspan_at(&partials, 1, 6) = 0.0;
*cspan_at(&partials, 1, 7) = 0.0;
*cspan_at(&partials, 1, 8) = 0.0;
*cspan_at(&partials, 1, 9) = 0.0;
*cspan_at(&partials, 1, 10) = 0.0;
*cspan_at(&partials, 1, 11) = c21;
*cspan_at(&partials, 1, 12) = c35;
*cspan_at(&partials, 1, 13) = c38;
*cspan_at(&partials, 1, 14) = c41;
*cspan_at(&partials, 1, 15) = 0.0;
*cspan_at(&partials, 1, 16) = 0.0;
*cspan_at(&partials, 1, 17) = 0.0;
*cspan_at(&partials, 2, 0) = 0.0;
*cspan_at(&partials, 2, 1) = 0.0;
*cspan_at(&partials, 2, 2) = c34 * c61 - c44 * c7 + c45 * c54;
*cspan_at(&partials, 2, 3) = (-c2) * ((-c0) * c68 + c2 * l_rate * phi_x_rate - c65 * phi_x_rate - c67) + c34 * (c31 + c82) - c36 * (c42 * c79 + c81) + c45 * (c49 * l_rate - c70 - c71 * phi_x_rate - c72) + c63 * c7 - c7 * c77;
*cspan_at(&partials, 2, 4) = c2 * c89;
*cspan_at(&partials, 2, 5) = 0.0;
*cspan_at(&partials, 2, 6) = 0.0;
*cspan_at(&partials, 2, 7) = c92 * ((-c50) + c90 + c91);
*cspan_at(&partials, 2, 8) = 2 * c34 * c69 + 2 * c45 * c73 + 2 * c65 * c7;
*cspan_at(&partials, 2, 9) = c92 * c93;
*cspan_at(&partials, 2, 10) = c12;
*cspan_at(&partials, 2, 11) = c35;
*cspan_at(&partials, 2, 12) = c100 * c27 + c27 * c95 + c96 * c97;
*cspan_at(&partials, 2, 13) = c101;
*cspan_at(&partials, 2, 14) = c102;
*cspan_at(&partials, 2, 15) = c103;
*cspan_at(&partials, 2, 16) = (-c34) * c42;
*cspan_at(&partials, 2, 17) = (-c42) * c45;
*cspan_at(&partials, 3, 0) = 0.0;
*cspan_at(&partials, 3, 1) = 0.0;
*cspan_at(&partials, 3, 2) = c6 * (c104 * c2 * c6 + c15 * c6 * c7 * c87 + c16 * c6 * c7 * c76 - c2 * c44 - c26 * c54 - c36 * c61);
*cspan_at(&partials, 3, 3) = c6 * (c104 * c7 - c105 * c26 - c106 * c2 - c107 * c36 + c2 * c63 - c2 * c77);
*cspan_at(&partials, 3, 4) = (-c108) * c89;
*cspan_at(&partials, 3, 5) = 0.0;
*cspan_at(&partials, 3, 6) = 0.0;
*cspan_at(&partials, 3, 7) = (-c109) * (c27 * phi_x_rate + c7 * c90 + c7 * c91);
*cspan_at(&partials, 3, 8) = c109 * (c2 * c65 - c26 * c73 - c36 * c69);
*cspan_at(&partials, 3, 9) = (-2) * c108 * c93;
*cspan_at(&partials, 3, 10) = c14;
*cspan_at(&partials, 3, 11) = c38;
*cspan_at(&partials, 3, 12) = c101;
*cspan_at(&partials, 3, 13) = c1 * (c100 * c96 + c27 * c97 + c95 * c96);
*cspan_at(&partials, 3, 14) = c110;
*cspan_at(&partials, 3, 15) = c13 * c42;
*cspan_at(&partials, 3, 16) = c111 * c15;
*cspan_at(&partials, 3, 17) = c111 * c16;
*cspan_at(&partials, 4, 0) = 0.0;
*cspan_at(&partials, 4, 1) = 0.0;
*cspan_at(&partials, 4, 2) = c39 * ((-c15) * c54 + c15 * c6 * c76 + c16 * c61 - c6 * c88);
*cspan_at(&partials, 4, 3) = c39 * ((-c105) * c15 + c107 * c16 + c16 * c17 * c7 * c87 - c17 * c7 * c85);
*cspan_at(&partials, 4, 4) = c39 * ((-c106) - c15 * c84 + c16 * c86 - c77);
*cspan_at(&partials, 4, 5) = 0.0;
*cspan_at(&partials, 4, 6) = 0.0;
*cspan_at(&partials, 4, 7) = c112 * ((-c15) * c60 + c16 * c52);
*cspan_at(&partials, 4, 8) = c112 * ((-c15) * c73 + c16 * c69);
*cspan_at(&partials, 4, 9) = c112 * ((-c15) * c74 + c16 * c71);
*cspan_at(&partials, 4, 10) = 0.0;
*cspan_at(&partials, 4, 11) = c41;
*cspan_at(&partials, 4, 12) = c102;
*cspan_at(&partials, 4, 13) = c110;
*cspan_at(&partials, 4, 14) = c1 * c28 * (c42 * c98 + c94 * c99);
*cspan_at(&partials, 4, 15) = 0.0;
*cspan_at(&partials, 4, 16) = (-c40) * c42;
*cspan_at(&partials, 4, 17) = c15 * c39 * c42;
}
static void crane_driven_partials(array_double_1d state, array_double_1d carriage, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_2d partials) {
double l, phi_x, phi_y, l_rate, phi_x_rate, phi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, a_x, a_y, a_l, f_phi_x, f_phi_y, w_x, w_y, w_z, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23, c24, c25, c26, c27, c28, c29, c30, c31, c32, c33, c34, c35, c36, c37, c38, c39, c40, c41, c42, c43, c44, c45, c46, c47, c48, c49, c50, c51, c52, c53, c54, c55, c56, c57, c58, c59, c60, c61, c62, c63, c64, c65, c66, c67, c68, c69, c70, c71, c72, c73, c74, c75, c76, c77, c78, c79, c80, c81, c82, c83, c84, c85, c86, c87, c88, c89, c90, c91, c92, c93, c94, c95, c96, c97, c98, c99, c100, c101, c102, c103, c104, c105, c106, c107, c108, c109, c110, c111, c112, c113, c114, c115, c116, c117, c118, c119, c120, c121, c122, c123, c124, c125, c126, c127, c128, c129, c130, c131, c132, c133, c134, c135, c136, c137, c138, c139, c140, c141, c142, c143, c144, c145, c146, c147, c148, c149, c150, c151, c152, c153, c154, c155, c156, c157, c158, c159, c160, c161, c162;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
l_rate = *cspan_at(&state, 7);
phi_x_rate = *cspan_at(&state, 8);
phi_y_rate = *cspan_at(&state, 9);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
a_x = *cspan_at(&carriage, 0);
a_y = *cspan_at(&carriage, 1);
a_l = *cspan_at(&carriage, 2);
f_phi_x = *cspan_at(&generalized_force, 3);
f_phi_y = *cspan_at(&generalized_force, 4);
w_x = *cspan_at(&load_force, 0);
w_y = *cspan_at(&load_force, 1);
w_z = *cspan_at(&load_force, 2);
c0 = 1 / (l * l);
c1 = 1 / l;
c2 = 1 / payload_mass;
c3 = c2 * f_phi_x;
c4 = cos(phi_x);
c5 = sin(phi_x);
c6 = c5 * phi_x_rate;
c7 = c6 * l;
c8 = (-c4) * l_rate + c7;
c9 = a_l * c5;
c10 = c4 * l_rate;
c11 = a_x + c10 * phi_x_rate - c2 * w_x + c9;
c12 = c11 - c8 * phi_x_rate;
c13 = c12 * c4;
c14 = sin(phi_y);
c15 = c2 * w_y;
c16 = a_l * c4;
c17 = c14 * c16;
c18 = cos(phi_y);
c19 = c4 * phi_y_rate;
c20 = c18 * c19;
c21 = c14 * c6 - c20;
c22 = c21 * l_rate;
c23 = c5 * l_rate;
c24 = c4 * phi_x_rate;
c25 = c14 * c24;
c26 = c5 * phi_y_rate;
c27 = c18 * c26;
c28 = c14 * c23 + c25 * l + c27 * l;
c29 = c28 * phi_x_rate;
c30 = c10 * c18;
c31 = c18 * c7;
c32 = c14 * c19;
c33 = c32 * l;
c34 = (-c30) + c31 + c33;
c35 = c34 * phi_y_rate;
c36 = a_y - c15 - c17 + c22 + c29 + c35;
c37 = c14 * c36;
c38 = c37 * c5;
c39 = c18 * c6 + c32;
c40 = c18 * c24;
c41 = c14 * c26;
c42 = c18 * c23 + c40 * l - c41 * l;
c43 = c10 * c14 - c14 * c7 + c20 * l;
c44 = (-c16) * c18 + c39 * l_rate + c42 * phi_x_rate + c43 * phi_y_rate;
c45 = (-c2) * w_z + c44 + gravity;
c46 = c18 * c45;
c47 = c46 * c5;
c48 = c13 * l - c3 + c38 * l + c47 * l;
c49 = phi_x_rate * phi_x_rate;
c50 = c14 * c5;
c51 = c25 + c27;
c52 = c39 * phi_y_rate + c51 * phi_x_rate;
c53 = c52 * l;
c54 = c50 * c53;
c55 = c18 * c5;
c56 = c40 - c41;
c57 = -c21;
c58 = c56 * phi_x_rate + c57 * phi_y_rate;
c59 = c58 * l;
c60 = c55 * c59;
c61 = c13 + c38 - c4 * c49 * c5 * l + c47 + c54 + c60;
c62 = (-c16) + c23 * phi_x_rate + phi_x_rate * (c23 + c24 * l);
c63 = c14 * c9 + c42 * phi_y_rate + c43 * phi_x_rate + c51 * l_rate;
c64 = c28 * phi_y_rate;
c65 = -c34;
c66 = c18 * c9 + c56 * l_rate - c64 + c65 * phi_x_rate;
c67 = (-c12) * c5 + c37 * c4 + c4 * c46 - c4 * c62 + c50 * c63 + c55 * c66;
c68 = c17 - c29;
c69 = c57 * l_rate + c65 * phi_y_rate + c68;
c70 = c18 * c36;
c71 = c14 * c45;
c72 = c70 - c71;
c73 = c14 * c44 + c18 * c69 + c72;
c74 = c1 * c5;
c75 = c4 * c4;
c76 = c21 * c50 + c39 * c55 + c75 * phi_x_rate;
c77 = 2 * c1;
c78 = c28 * c50 - c4 * c8 + c42 * c55;
c79 = c14 * c34 + c18 * c43;
c80 = c5 * c77;
c81 = c1 * c4;
c82 = c1 * c50;
c83 = c14 * c14;
c84 = c18 * c18;
c85 = c84 - 1;
c86 = c83 + c85;
c87 = c5 * c81;
c88 = c0 * c2;
c89 = c1 * c55;
c90 = c18 * c53;
c91 = -c36;
c92 = -c45;
c93 = c14 * c92;
c94 = c4 * l;
c95 = c2 * f_phi_y + c70 * c94 - c71 * c94;
c96 = 1 / c4;
c97 = c77 * c96;
c98 = c0 * c96;
c99 = c18 * c4;
c100 = c14 * c4;
c101 = (-c100) * c66 - c5 * c70 + c5 * c71 + c63 * c99;
c102 = 1 / c75;
c103 = c1 * c102;
c104 = c14 * c69 - c18 * c44 + c37 + c46;
c105 = c1 * c96;
c106 = c14 * c39 - c18 * c21;
c107 = c18 * c28;
c108 = (-c107) + c14 * c42;
c109 = c14 * c43 - c18 * c34;
c110 = c105 * c18;
c111 = c105 * c14;
c112 = c49 * c5;
c113 = -c48;
c114 = c0 * c4;
c115 = -c61;
c116 = c113 * c74 + c4 * c67 + c62;
c117 = c5 * payload_mass;
c118 = (-c76) + phi_x_rate;
c119 = 2 * payload_mass;
c120 = c119 * c4;
c121 = c75 - 1;
c122 = c4 * c50;
c123 = (-c122) * payload_mass;
c124 = c75 * c86 + 1;
c125 = (-c14) * c58 * l + c90;
c126 = c1 * c18;
c127 = c0 * c50;
c128 = c95 * c98;
c129 = c128 * c18 + c52;
c130 = (-c101) * c96;
c131 = c48 * c81;
c132 = (-c103) * c55 * c95 + c130 * c18 - c131 * c14 - c50 * c67 + c63;
c133 = c5 * c5;
c134 = c111 * c95;
c135 = c134 - c48 * c89;
c136 = c21 - c50 * c76;
c137 = c133 * c79;
c138 = c137 * c14;
c139 = c133 * c83 + c85;
c140 = (-c133) * c86 + 1;
c141 = c100 * payload_mass;
c142 = c133 - 1;
c143 = (-c12) * c4;
c144 = c50 * c91;
c145 = c55 * c92;
c146 = (-c125) + c18 * c91 - c93;
c147 = c110 * c95;
c148 = c147 - c22 - c35 + c68;
c149 = -c73;
c150 = c113 * c82;
c151 = c113 * c89 + c134;
c152 = -c104;
c153 = c133 * c149;
c154 = c14 * c39 + c18 * c57;
c155 = -c78;
c156 = c107 - c14 * c42;
c157 = -c109;
c158 = c75 * c83;
c159 = c75 * c84;
c160 = c158 + c159 - c75 + 1;
c161 = -c133;
c162 = c139 + c142 * c84 + c161;
*cspan_at(&partials, 0, 0) = 0.0;
*cspan_at(&partials, 0, 1) = 0.0;
*cspan_at(&partials, 0, 2) = c0 * (2 * c1 * c48 - c61);
*cspan_at(&partials, 0, 3) = (-c1) * c67;
*cspan_at(&partials, 0, 4) = (-c73) * c74;
*cspan_at(&partials, 0, 5) = 0.0;
*cspan_at(&partials, 0, 6) = 0.0;
*cspan_at(&partials, 0, 7) = (-c76) * c77;
*cspan_at(&partials, 0, 8) = (-c77) * c78;
*cspan_at(&partials, 0, 9) = (-c79) * c80;
*cspan_at(&partials, 0, 10) = -c81;
*cspan_at(&partials, 0, 11) = -c82;
*cspan_at(&partials, 0, 12) = c86 * c87;
*cspan_at(&partials, 0, 13) = c88;
*cspan_at(&partials, 0, 14) = 0.0;
*cspan_at(&partials, 0, 15) = c2 * c81;
*cspan_at(&partials, 0, 16) = c2 * c82;
*cspan_at(&partials, 0, 17) = c2 * c89;
*cspan_at(&partials, 1, 0) = 0.0;
*cspan_at(&partials, 1, 1) = 0.0;
*cspan_at(&partials, 1, 2) = (-c98) * (c14 * c59 + c18 * c91 - c90 - c93 + c95 * c97);
*cspan_at(&partials, 1, 3) = c103 * (c101 + c80 * c95 * c96);
*cspan_at(&partials, 1, 4) = (-c104) * c105;
*cspan_at(&partials, 1, 5) = 0.0;
*cspan_at(&partials, 1, 6) = 0.0;
*cspan_at(&partials, 1, 7) = (-c106) * c97;
*cspan_at(&partials, 1, 8) = (-c108) * c97;
*cspan_at(&partials, 1, 9) = (-c109) * c97;
*cspan_at(&partials, 1, 10) = 0.0;
*cspan_at(&partials, 1, 11) = c110;
*cspan_at(&partials, 1, 12) = 0.0;
*cspan_at(&partials, 1, 13) = 0.0;
*cspan_at(&partials, 1, 14) = c102 * c88;
*cspan_at(&partials, 1, 15) = 0.0;
*cspan_at(&partials, 1, 16) = (-c110) * c2;
*cspan_at(&partials, 1, 17) = c111 * c2;
*cspan_at(&partials, 2, 0) = 0.0;
*cspan_at(&partials, 2, 1) = 0.0;
*cspan_at(&partials, 2, 2) = (-payload_mass) * (c112 + c113 * c114 - c115 * c81);
*cspan_at(&partials, 2, 3) = (-c116) * payload_mass;
*cspan_at(&partials, 2, 4) = (-c117) * c4 * c73;
*cspan_at(&partials, 2, 5) = 0.0;
*cspan_at(&partials, 2, 6) = 0.0;
*cspan_at(&partials, 2, 7) = c118 * c120;
*cspan_at(&partials, 2, 8) = c119 * ((-c4) * c78 - c8);
*cspan_at(&partials, 2, 9) = (-c120) * c5 * c79;
*cspan_at(&partials, 2, 10) = bridge_mass - c121 * payload_mass + trolley_mass;
*cspan_at(&partials, 2, 11) = c123;
*cspan_at(&partials, 2, 12) = c117 * c124;
*cspan_at(&partials, 2, 13) = c81;
*cspan_at(&partials, 2, 14) = 0.0;
*cspan_at(&partials, 2, 15) = c121;
*cspan_at(&partials, 2, 16) = c122;
*cspan_at(&partials, 2, 17) = c4 * c55;
*cspan_at(&partials, 3, 0) = 0.0;
*cspan_at(&partials, 3, 1) = 0.0;
*cspan_at(&partials, 3, 2) = payload_mass * (c126 * ((-c125) - c72) + c127 * c48 + c129 - c61 * c82);
*cspan_at(&partials, 3, 3) = c132 * payload_mass;
*cspan_at(&partials, 3, 4) = payload_mass * (c104 * c18 - c133 * c14 * c73 + c135 + c44);
*cspan_at(&partials, 3, 5) = 0.0;
*cspan_at(&partials, 3, 6) = 0.0;
*cspan_at(&partials, 3, 7) = c119 * (c106 * c18 + c136);
*cspan_at(&partials, 3, 8) = c119 * (c108 * c18 + c28 - c50 * c78);
*cspan_at(&partials, 3, 9) = c119 * (c109 * c18 - c138 + c34);
*cspan_at(&partials, 3, 10) = c123;
*cspan_at(&partials, 3, 11) = (-c139) * payload_mass + trolley_mass;
*cspan_at(&partials, 3, 12) = (-c140) * c141;
*cspan_at(&partials, 3, 13) = c82;
*cspan_at(&partials, 3, 14) = -c110;
*cspan_at(&partials, 3, 15) = c122;
*cspan_at(&partials, 3, 16) = c139;
*cspan_at(&partials, 3, 17) = c14 * c142 * c18;
*cspan_at(&partials, 4, 0) = 0.0;
*cspan_at(&partials, 4, 1) = 0.0;
*cspan_at(&partials, 4, 2) = (-payload_mass) * (c100 * ((-c113) * c127 + c115 * c82 + c126 * c146 + c129) + c5 * (c112 + c114 * (c143 * l + c144 * l + c145 * l + c3) - c81 * (c112 * c94 + c143 + c144 + c145 - c54 - c60)) + c99 * ((-c0) * c113 * c55 + c1 * c115 * c18 * c5 - c1 * c14 * c146 - c128 * c14 - c21 * phi_y_rate + c56 * phi_x_rate));
*cspan_at(&partials, 4, 3) = payload_mass * ((-c100) * c132 - c116 * c5 + c14 * c5 * (a_y - c148 - c15 - c48 * c82) + c18 * c5 * (c135 + c45) + c4 * (c11 - c131 - c8 * phi_x_rate) - c99 * (a_l * c18 * c5 + c1 * c102 * c14 * c5 * c95 - c130 * c14 - c131 * c18 - c34 * phi_x_rate - c55 * c67 + c56 * l_rate - c64));
*cspan_at(&partials, 4, 4) = c4 * payload_mass * (c133 * c149 + c14 * (c151 + c45) - c14 * (c14 * c153 + c151 - c152 * c18 + c44) - c18 * ((-c147) + c150 + c36) - c18 * (c14 * c152 + c148 - c150 + c153 * c18));
*cspan_at(&partials, 4, 5) = 0.0;
*cspan_at(&partials, 4, 6) = 0.0;
*cspan_at(&partials, 4, 7) = c120 * (c118 * c5 - c14 * (c136 + c154 * c18) - c18 * ((-c14) * c154 + c39 - c55 * c76));
*cspan_at(&partials, 4, 8) = c119 * ((-c100) * (c155 * c50 - c156 * c18 + c28) + c5 * (c10 + c155 * c4 - c7) - c99 * (c14 * c156 + c155 * c55 + c42));
*cspan_at(&partials, 4, 9) = (-c120) * (c137 + c14 * ((-c138) - c157 * c18 - c30 + c31 + c33) + c18 * ((-c137) * c18 + c14 * c157 + c43));
*cspan_at(&partials, 4, 10) = c117 * c160;
*cspan_at(&partials, 4, 11) = c141 * c162;
*cspan_at(&partials, 4, 12) = payload_mass * (c124 * c133 + c140 * c158 + c140 * c159);
*cspan_at(&partials, 4, 13) = (-c86) * c87;
*cspan_at(&partials, 4, 14) = 0.0;
*cspan_at(&partials, 4, 15) = (-c160) * c5;
*cspan_at(&partials, 4, 16) = (-c100) * c162;
*cspan_at(&partials, 4, 17) = c99 * ((-c133) * c84 - c142 * c83 - c161 - c83 + 1);
}
void segfmu_crane_load_partials(array_double_1d state, array_double_2d partials) {
double l, phi_x, phi_y, l_rate, phi_x_rate, phi_y_rate, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
l_rate = *cspan_at(&state, 7);
phi_x_rate = *cspan_at(&state, 8);
phi_y_rate = *cspan_at(&state, 9);
c0 = sin(phi_x);
c1 = cos(phi_x);
c2 = c1 * l;
c3 = sin(phi_y);
c4 = c1 * c3;
c5 = -c4;
c6 = c0 * l;
c7 = c3 * c6;
c8 = cos(phi_y);
c9 = c2 * c8;
c10 = -c9;
c11 = c1 * c8;
c12 = -c11;
c13 = c6 * c8;
c14 = c2 * c3;
c15 = c0 * c3;
c16 = c0 * c8;
*cspan_at(&partials, 0, 0) = 1;
*cspan_at(&partials, 0, 1) = 0.0;
*cspan_at(&partials, 0, 2) = c0;
*cspan_at(&partials, 0, 3) = c2;
*cspan_at(&partials, 0, 4) = 0.0;
*cspan_at(&partials, 0, 5) = 0.0;
*cspan_at(&partials, 0, 6) = 0.0;
*cspan_at(&partials, 0, 7) = 0.0;
*cspan_at(&partials, 0, 8) = 0.0;
*cspan_at(&partials, 0, 9) = 0.0;
*cspan_at(&partials, 1, 0) = 0.0;
*cspan_at(&partials, 1, 1) = 1;
*cspan_at(&partials, 1, 2) = c5;
*cspan_at(&partials, 1, 3) = c7;
*cspan_at(&partials, 1, 4) = c10;
*cspan_at(&partials, 1, 5) = 0.0;
*cspan_at(&partials, 1, 6) = 0.0;
*cspan_at(&partials, 1, 7) = 0.0;
*cspan_at(&partials, 1, 8) = 0.0;
*cspan_at(&partials, 1, 9) = 0.0;
*cspan_at(&partials, 2, 0) = 0.0;
*cspan_at(&partials, 2, 1) = 0.0;
*cspan_at(&partials, 2, 2) = c12;
*cspan_at(&partials, 2, 3) = c13;
*cspan_at(&partials, 2, 4) = c14;
*cspan_at(&partials, 2, 5) = 0.0;
*cspan_at(&partials, 2, 6) = 0.0;
*cspan_at(&partials, 2, 7) = 0.0;
*cspan_at(&partials, 2, 8) = 0.0;
*cspan_at(&partials, 2, 9) = 0.0;
*cspan_at(&partials, 3, 0) = 0.0;
*cspan_at(&partials, 3, 1) = 0.0;
*cspan_at(&partials, 3, 2) = c1 * phi_x_rate;
*cspan_at(&partials, 3, 3) = c1 * l_rate - c6 * phi_x_rate;
*cspan_at(&partials, 3, 4) = 0.0;
*cspan_at(&partials, 3, 5) = 1;
*cspan_at(&partials, 3, 6) = 0.0;
*cspan_at(&partials, 3, 7) = c0;
*cspan_at(&partials, 3, 8) = c2;
*cspan_at(&partials, 3, 9) = 0.0;
*cspan_at(&partials, 4, 0) = 0.0;
*cspan_at(&partials, 4, 1) = 0.0;
*cspan_at(&partials, 4, 2) = (-c11) * phi_y_rate + c15 * phi_x_rate;
*cspan_at(&partials, 4, 3) = c13 * phi_y_rate + c14 * phi_x_rate + c15 * l_rate;
*cspan_at(&partials, 4, 4) = (-c11) * l_rate + c13 * phi_x_rate + c14 * phi_y_rate;
*cspan_at(&partials, 4, 5) = 0.0;
*cspan_at(&partials, 4, 6) = 1;
*cspan_at(&partials, 4, 7) = c5;
*cspan_at(&partials, 4, 8) = c7;
*cspan_at(&partials, 4, 9) = c10;
*cspan_at(&partials, 5, 0) = 0.0;
*cspan_at(&partials, 5, 1) = 0.0;
*cspan_at(&partials, 5, 2) = c16 * phi_x_rate + c4 * phi_y_rate;
*cspan_at(&partials, 5, 3) = c16 * l_rate - c7 * phi_y_rate + c9 * phi_x_rate;
*cspan_at(&partials, 5, 4) = c4 * l_rate - c7 * phi_x_rate + c9 * phi_y_rate;
*cspan_at(&partials, 5, 5) = 0.0;
*cspan_at(&partials, 5, 6) = 0.0;
*cspan_at(&partials, 5, 7) = c12;
*cspan_at(&partials, 5, 8) = c13;
*cspan_at(&partials, 5, 9) = c14;
}
void segfmu_crane_energy_partials(array_double_1d state, array_double_1d masses, array_double_2d partials) {
double l, phi_x, phi_y, x_t_rate, y_t_rate, l_rate, phi_x_rate, phi_y_rate, bridge_mass, trolley_mass, payload_mass, gravity, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23;
l = *cspan_at(&state, 2);
phi_x = *cspan_at(&state, 3);
phi_y = *cspan_at(&state, 4);
x_t_rate = *cspan_at(&state, 5);
y_t_rate = *cspan_at(&state, 6);
l_rate = *cspan_at(&state, 7);
phi_x_rate = *cspan_at(&state, 8);
phi_y_rate = *cspan_at(&state, 9);
bridge_mass = *cspan_at(&masses, 0);
trolley_mass = *cspan_at(&masses, 1);
payload_mass = *cspan_at(&masses, 2);
gravity = *cspan_at(&masses, 3);
c0 = cos(phi_x);
c1 = sin(phi_x);
c2 = c1 * l_rate;
c3 = c0 * l;
c4 = c3 * phi_x_rate;
c5 = c2 + c4 + x_t_rate;
c6 = c0 * c5;
c7 = cos(phi_y);
c8 = c1 * phi_x_rate;
c9 = c7 * c8;
c10 = sin(phi_y);
c11 = c0 * phi_y_rate;
c12 = c10 * c11;
c13 = c0 * l_rate;
c14 = c12 * l - c13 * c7 + c9 * l;
c15 = c10 * c8;
c16 = c11 * c7;
c17 = (-c10) * c13 + c15 * l - c16 * l + y_t_rate;
c18 = c1 * l * phi_y_rate;
c19 = c14 * c7;
c20 = c10 * c17;
c21 = l * payload_mass;
c22 = c3 * payload_mass;
c23 = c7 * gravity;
*cspan_at(&partials, 0, 0) = 0.0;
*cspan_at(&partials, 0, 1) = 0.0;
*cspan_at(&partials, 0, 2) = payload_mass * (c14 * (c12 + c9) + c17 * (c15 - c16) + c6 * phi_x_rate);
*cspan_at(&partials, 0, 3) = payload_mass * (c14 * ((-c10) * c18 + c2 * c7 + c4 * c7) + c17 * (c10 * c2 + c10 * c4 + c18 * c7) - c5 * ((-c13) + c8 * l));
*cspan_at(&partials, 0, 4) = c14 * payload_mass * y_t_rate;
*cspan_at(&partials, 0, 5) = bridge_mass * x_t_rate + c5 * payload_mass + trolley_mass * x_t_rate;
*cspan_at(&partials, 0, 6) = c17 * payload_mass + trolley_mass * y_t_rate;
*cspan_at(&partials, 0, 7) = (-payload_mass) * (c0 * c19 + c0 * c20 - c1 * c5);
*cspan_at(&partials, 0, 8) = c21 * (c1 * c19 + c1 * c20 + c6);
*cspan_at(&partials, 0, 9) = c22 * (c10 * c14 - c17 * c7);
*cspan_at(&partials, 1, 0) = 0.0;
*cspan_at(&partials, 1, 1) = 0.0;
*cspan_at(&partials, 1, 2) = (-c0) * c23 * payload_mass;
*cspan_at(&partials, 1, 3) = c1 * c21 * c23;
*cspan_at(&partials, 1, 4) = c10 * c22 * gravity;
*cspan_at(&partials, 1, 5) = 0.0;
*cspan_at(&partials, 1, 6) = 0.0;
*cspan_at(&partials, 1, 7) = 0.0;
*cspan_at(&partials, 1, 8) = 0.0;
*cspan_at(&partials, 1, 9) = 0.0;
}
static double compression(array_double_1d plant, int64_t axis, double position) {
double result;
if (position > *cspan_at(&plant, 53 + axis)) {
result = position - *cspan_at(&plant, 53 + axis);
return result;
}
result = span_min(position - *cspan_at(&plant, 50 + axis), 0.0);
return result;
}
static double buffer_force(array_double_1d plant, int64_t axis, double position, double velocity) {
double pressed, force;
if (*cspan_at(&plant, 56 + axis) == 0.0) {
return 0.0;
}
pressed = compression(plant, axis, position);
if (pressed == 0.0) {
return 0.0;
}
force = *cspan_at(&plant, 56 + axis) * pressed + *cspan_at(&plant, 59 + axis) * velocity;
if (force * pressed <= 0.0) {
return 0.0;
}
return force;
}
static int64_t buffer_slopes(double* result_0_0001, double* result_1_0001, array_double_1d plant, int64_t axis, double position, double velocity) {
if (buffer_force(plant, axis, position, velocity) == 0.0) {
(*result_0_0001) = 0.0;
(*result_1_0001) = 0.0;
return 0;
}
(*result_0_0001) = *cspan_at(&plant, 56 + axis);
(*result_1_0001) = *cspan_at(&plant, 59 + axis);
return 0;
}
static double dry_level(array_double_1d resistance, int64_t axis, double velocity) {
double ratio, coulomb;
coulomb = *cspan_at(&resistance, 7 + axis);
if (*cspan_at(&resistance, 10 + axis) <= coulomb) {
return coulomb;
}
ratio = velocity / *cspan_at(&resistance, 16);
coulomb = coulomb + (*cspan_at(&resistance, 10 + axis) - coulomb) * exp((-ratio) * ratio);
return coulomb;
}
static double level_slope(array_double_1d resistance, int64_t axis, double velocity) {
double coulomb, width, result;
coulomb = *cspan_at(&resistance, 7 + axis);
if (*cspan_at(&resistance, 10 + axis) <= coulomb) {
return 0.0;
}
width = *cspan_at(&resistance, 16);
result = (-2.0) * velocity / (width * width) * (dry_level(resistance, axis, velocity) - coulomb);
return result;
}
static bool rubs(array_double_1d resistance, int64_t axis) {
bool result;
result = (*cspan_at(&resistance, 7 + axis) > 0.0) || (*cspan_at(&resistance, 10 + axis) > 0.0);
return result;
}
static double deflected(array_double_1d resistance, double deflection) {
double result;
result = span_min(span_max(deflection / *cspan_at(&resistance, 17), -1.0), 1.0);
return result;
}
static double contact_damping(array_double_1d resistance, int64_t axis) {
double mass, static_0001, result;
mass = carriage_mass(resistance, axis);
if (axis == 2) {
mass = hanging_mass(resistance);
}
static_0001 = span_max(*cspan_at(&resistance, 10 + axis), *cspan_at(&resistance, 7 + axis));
result = 2.0 * sqrt(1.5 * static_0001 * mass / *cspan_at(&resistance, 17));
return result;
}
static double dry_friction(array_double_1d resistance, int64_t axis, double level, double velocity, double deflection) {
double share, friction, damped;
if (level <= 0.0) {
return 0.0;
}
share = deflected(resistance, deflection);
friction = level * 0.5 * share * (3.0 - share * share);
damped = contact_damping(resistance, axis) * velocity / level;
damped = damped / sqrt(1.0 + damped * damped);
return friction + level * damped * (1.0 - share * share);
}
static double smooth_friction(array_double_1d resistance, int64_t axis, double velocity) {
double drag, result;
drag = *cspan_at(&resistance, 13 + axis);
result = *cspan_at(&resistance, 4 + axis) * velocity + drag * velocity * fabs(velocity);
return result;
}
static double friction_force(array_double_1d resistance, int64_t axis, double velocity, double deflection) {
double level, friction;
friction = smooth_friction(resistance, axis, velocity);
if (rubs(resistance, axis)) {
level = dry_level(resistance, axis, velocity);
friction = friction + dry_friction(resistance, axis, level, velocity, deflection);
}
return friction;
}
static int64_t friction_slopes(double* result_0, double* result_1_0001, array_double_1d resistance, int64_t axis, double velocity, double deflection) {
double drag, by_velocity, level, slope, share, rest, damping, damped, root, changed, by_share;
drag = *cspan_at(&resistance, 13 + axis);
by_velocity = *cspan_at(&resistance, 4 + axis) + 2.0 * drag * fabs(velocity);
if (!rubs(resistance, axis)) {
(*result_0) = by_velocity;
(*result_1_0001) = 0.0;
return 0;
}
level = dry_level(resistance, axis, velocity);
if (level <= 0.0) {
(*result_0) = by_velocity;
(*result_1_0001) = 0.0;
return 0;
}
slope = level_slope(resistance, axis, velocity);
share = deflected(resistance, deflection);
rest = 1.0 - share * share;
damping = contact_damping(resistance, axis);
damped = damping * velocity / level;
root = sqrt(1.0 + damped * damped);
by_velocity = by_velocity + slope * 0.5 * share * (3.0 - share * share);
changed = (damping - damped * slope) / (root * root * root);
by_velocity = by_velocity + rest * (slope * damped / root + changed);
if (fabs(share) >= 1.0) {
(*result_0) = by_velocity;
(*result_1_0001) = 0.0;
return 0;
}
by_share = level * (1.5 * rest - 2.0 * share * damped / root);
(*result_0) = by_velocity;
(*result_1_0001) = by_share / *cspan_at(&resistance, 17);
return 0;
}
static double deflection_rate(array_double_1d resistance, int64_t axis, double velocity, double deflection) {
if (!rubs(resistance, axis)) {
return 0.0;
}
if ((fabs(deflection) >= *cspan_at(&resistance, 17)) && (deflection * velocity >= 0.0)) {
return 0.0;
}
return velocity;
}
static double first_deflection(array_double_1d resistance, int64_t axis, double velocity) {
double share, result;
if (!rubs(resistance, axis)) {
return 0.0;
}
share = velocity / *cspan_at(&resistance, 16);
result = *cspan_at(&resistance, 17) * span_min(span_max(share, -1.0), 1.0);
return result;
}
static double next_break(double time, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends) {
int64_t axis, first, last, row;
double following;
following = 1e+300;
for (axis = 0; axis < ends.shape[0]; axis += 1) {
first = *cspan_at(&offsets, axis);
last = *cspan_at(&offsets, axis + 1);
if (time < *cspan_at(&timing, first, 0)) {
following = span_min(following, *cspan_at(&timing, first, 0));
}
else {
row = find_piece(time, timing, first, last) + 1;
if (row < last) {
following = span_min(following, *cspan_at(&timing, row, 0));
}
else if (time < *cspan_at(&ends, axis)) {
following = span_min(following, *cspan_at(&ends, axis));
}
}
}
return following;
}
double segfmu_same_break(double time) {
return 1e-08 + 1e-14 * fabs(time);
}
double segfmu_next_plan_event(double time, double start, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends, array_double_2d times) {
double event, arrival, piece_end;
int64_t waypoint, axis;
event = 1e+300;
for (waypoint = 1; waypoint < times.shape[0] + 1; waypoint += 1) {
arrival = 0.0;
for (axis = 0; axis < ends.shape[0]; axis += 1) {
if (waypoint < times.shape[0]) {
arrival = span_max(arrival, *cspan_at(&times, waypoint, axis));
}
else {
arrival = span_max(arrival, *cspan_at(&ends, axis));
}
}
if (start + arrival > time + segfmu_same_break(time)) {
event = span_min(event, start + arrival);
}
}
piece_end = next_break(time + segfmu_same_break(time) - start, timing, offsets, ends);
if (piece_end < 1e+300) {
piece_end = start + piece_end;
}
if ((event <= piece_end + segfmu_same_break(time)) || (piece_end <= time)) {
return event;
}
return piece_end;
}
double segfmu_right_of_break(double time, double start, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends) {
double local, behind;
local = time - start;
behind = local + segfmu_same_break(time);
if (next_break(local - segfmu_same_break(time), timing, offsets, ends) <= behind) {
return behind;
}
return local;
}
bool segfmu_resists(array_double_1d resistance, int64_t axis) {
double smooth;
bool result;
smooth = *cspan_at(&resistance, 4 + axis) + *cspan_at(&resistance, 13 + axis);
result = (smooth > 0.0) || rubs(resistance, axis);
return result;
}
static double release_time(array_double_1d resistance, int64_t axis) {
double mass, static_0001, result;
mass = carriage_mass(resistance, axis);
if (axis == 2) {
mass = hanging_mass(resistance);
}
static_0001 = span_max(*cspan_at(&resistance, 10 + axis), *cspan_at(&resistance, 7 + axis));
result = 20.0 * sqrt(*cspan_at(&resistance, 17) * mass / (1.5 * static_0001));
return result;
}
static int64_t axis_motion(double* result_0, double* result_1, double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work) {
array_double_1d crane;
array_double_2d load, series;
int64_t axis;
double position, velocity;
crane = span_row(&work, 27);
load = span_rows(&work, 28, 28 + segfmu_flat_orders(crane));
series = span_rows(&work, 3, 3 + 23);
axis = (int64_t)(*cspan_at(&work, 26, 0));
segfmu_evaluate_orders(time, timing, coefficients, offsets, ends, load);
crane_inverse(load, crane, series, span_row(&work, 0), span_row(&work, 1), span_row(&work, 2));
position = *cspan_at(&work, 1, 0 + axis);
velocity = *cspan_at(&work, 1, 5 + axis);
(*result_0) = position;
(*result_1) = velocity;
return 0;
}
static int64_t find_contact(double time, array_double_2d contacts) {
int64_t upper, middle, lower;
lower = 0;
upper = contacts.shape[0];
while(upper - lower > 1) {
middle = span_floor_div((lower + upper), 2);
if (time >= *cspan_at(&contacts, middle, 0)) {
lower = middle;
}
else {
upper = middle;
}
}
return lower;
}
static double planned_deflection(array_double_1d resistance, double time, double position, array_double_2d contacts, int64_t row) {
double deflection, released, share, most;
deflection = *cspan_at(&contacts, row, 2);
released = *cspan_at(&contacts, row, 3);
if (released > 0.0) {
share = span_min((time - *cspan_at(&contacts, row, 0)) / released, 1.0);
return deflection * (1.0 - share * share * (3.0 - 2.0 * share));
}
deflection = deflection + position - *cspan_at(&contacts, row, 1);
most = *cspan_at(&resistance, 17);
return span_min(span_max(deflection, -most), most);
}
static double release_rate(double time, array_double_2d contacts, int64_t row) {
double released, share, result;
released = *cspan_at(&contacts, row, 3);
share = span_min((time - *cspan_at(&contacts, row, 0)) / released, 1.0);
result = (-6.0) * *cspan_at(&contacts, row, 2) * share * (1.0 - share) / released;
return result;
}
static bool stops(double time, array_double_2d contacts, int64_t row) {
bool result;
if (*cspan_at(&contacts, row, 3) > 0.0) {
return 1;
}
if (row + 1 >= contacts.shape[0]) {
return 0;
}
result = (*cspan_at(&contacts, row + 1, 3) > 0.0) && (time >= *cspan_at(&contacts, row + 1, 4));
return result;
}
double segfmu_planned_friction(array_double_1d resistance, int64_t axis, double time, double position, double velocity, array_double_2d contacts) {
int64_t row;
double deflection, rate, level, friction, result;
if ((time < 0.0) || (!segfmu_resists(resistance, axis))) {
return 0.0;
}
row = find_contact(time, contacts);
deflection = planned_deflection(resistance, time, position, contacts, row);
rate = velocity;
if (*cspan_at(&contacts, row, 3) > 0.0) {
rate = release_rate(time, contacts, row);
}
level = dry_level(resistance, axis, rate);
if (stops(time, contacts, row)) {
level = *cspan_at(&resistance, 7 + axis);
}
friction = smooth_friction(resistance, axis, rate);
result = friction + dry_friction(resistance, axis, level, rate, deflection);
return result;
}
static double stillness(array_double_2d work) {
double result;
result = 1e-06 * *cspan_at(&work, 27, 16);
return result;
}
static bool at_rest(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work) {
int64_t k;
double time, position, velocity;
for (k = 1; k < 12; k += 1) {
time = begin + k * (end - begin) / 12.0;
axis_motion(&position, &velocity, time, timing, coefficients, offsets, ends, work);
if (fabs(velocity) > stillness(work)) {
return 0;
}
}
return 1;
}
static void add_contact(double time, bool rests, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts) {
array_double_1d history, resistance;
int64_t count, before;
double position, velocity;
history = span_row(&work, 26);
resistance = span_row(&work, 27);
count = (int64_t)(*cspan_at(&history, 1));
if ((count == 0) || (count >= contacts.shape[0])) {
*cspan_at(&history, 1) = 0.0;
return;
}
before = count - 1;
if (*cspan_at(&contacts, before, 3) > time - *cspan_at(&contacts, before, 0)) {
*cspan_at(&contacts, before, 3) = 0.0;
}
axis_motion(&position, &velocity, time, timing, coefficients, offsets, ends, work);
*cspan_at(&contacts, count, 2) = planned_deflection(resistance, time, position, contacts, before);
*cspan_at(&contacts, count, 0) = time;
*cspan_at(&contacts, count, 1) = position;
if (rests) {
*cspan_at(&contacts, count, 3) = release_time(resistance, (int64_t)(*cspan_at(&history, 0)));
}
*cspan_at(&history, 1) = count + 1.0;
}
static double turning_point(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work) {
double lower, upper, middle, position, velocity;
int64_t Dummy_0000;
lower = begin;
upper = end;
for (Dummy_0000 = 0; Dummy_0000 < 50; Dummy_0000 += 1) {
middle = 0.5 * (lower + upper);
axis_motion(&position, &velocity, middle, timing, coefficients, offsets, ends, work);
if (velocity * *cspan_at(&work, 26, 2) > 0.0) {
lower = middle;
}
else {
upper = middle;
}
}
return 0.5 * (lower + upper);
}
static void add_turns(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts) {
array_double_1d history;
double before, time, position, velocity, turn;
int64_t k;
history = span_row(&work, 26);
before = begin;
for (k = 1; k < 13; k += 1) {
time = begin + k * (end - begin) / 12.0;
axis_motion(&position, &velocity, time, timing, coefficients, offsets, ends, work);
if (fabs(velocity) > stillness(work)) {
if (*cspan_at(&history, 2) * velocity < 0.0) {
turn = turning_point(before, time, timing, coefficients, offsets, ends, work);
add_contact(turn, 0, timing, coefficients, offsets, ends, work, contacts);
}
*cspan_at(&history, 2) = velocity / fabs(velocity);
before = time;
}
}
}
static void follow_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts) {
array_double_1d history;
bool rested, rests;
double time, following;
history = span_row(&work, 26);
rested = 0;
time = 0.0;
following = next_break(time, timing, offsets, ends);
while((following < 1e+300) && (*cspan_at(&history, 1) > 0.0)) {
rests = at_rest(time, following, timing, coefficients, offsets, ends, work);
if (rests != rested) {
add_contact(time, rests, timing, coefficients, offsets, ends, work, contacts);
*cspan_at(&history, 2) = 0.0;
rested = rests;
}
if (!rests) {
add_turns(time, following, timing, coefficients, offsets, ends, work, contacts);
}
time = following;
following = next_break(time, timing, offsets, ends);
}
if (!rested) {
add_contact(time, 1, timing, coefficients, offsets, ends, work, contacts);
}
}
static double sliding_time(int64_t row, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts) {
array_double_1d resistance;
double lower, most, middle, position, velocity, deflection, upper;
int64_t Dummy_0000;
resistance = span_row(&work, 27);
lower = *cspan_at(&contacts, row, 0);
if (*cspan_at(&contacts, row, 3) > 0.0) {
upper = lower + *cspan_at(&contacts, row, 3);
return upper;
}
most = *cspan_at(&resistance, 17);
upper = end;
for (Dummy_0000 = 0; Dummy_0000 < 50; Dummy_0000 += 1) {
middle = 0.5 * (lower + upper);
axis_motion(&position, &velocity, middle, timing, coefficients, offsets, ends, work);
deflection = planned_deflection(resistance, middle, position, contacts, row);
if ((deflection * velocity >= 0.0) && (fabs(deflection) >= most)) {
upper = middle;
}
else {
lower = middle;
}
}
return upper;
}
static double fading_time(double time, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work) {
double faded, share, position, velocity;
bool fast;
int64_t Dummy_0000;
faded = 3.0 * *cspan_at(&work, 27, 16);
share = 1e-06;
fast = 0;
for (Dummy_0000 = 0; Dummy_0000 < 33; Dummy_0000 += 1) {
if (!fast) {
axis_motion(&position, &velocity, time + share * (end - time), timing, coefficients, offsets, ends, work);
fast = fabs(velocity) > faded;
}
if (!fast) {
share = span_min(1.5 * share, 0.5);
}
}
return time + share * (end - time);
}
static void settle_contact(int64_t row, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts) {
array_double_1d resistance;
int64_t axis;
double time, end, slides, begun, settled;
resistance = span_row(&work, 27);
axis = (int64_t)(*cspan_at(&work, 26, 0));
time = *cspan_at(&contacts, row, 0);
end = time;
if (row + 1 < (int64_t)(*cspan_at(&work, 26, 1))) {
end = *cspan_at(&contacts, row + 1, 0);
}
slides = sliding_time(row, end, timing, coefficients, offsets, ends, work, contacts);
begun = time;
settled = slides;
if (*cspan_at(&resistance, 10 + axis) > *cspan_at(&resistance, 7 + axis)) {
if (*cspan_at(&contacts, row, 3) == 0.0) {
settled = span_max(settled, fading_time(time, end, timing, coefficients, offsets, ends, work));
}
if (row > 0) {
begun = fading_time(time, *cspan_at(&contacts, row - 1, 0), timing, coefficients, offsets, ends, work);
}
}
*cspan_at(&contacts, row, 4) = begun;
*cspan_at(&contacts, row, 5) = slides;
*cspan_at(&contacts, row, 6) = settled;
}
int64_t segfmu_contact_history(int64_t axis, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_2d work, array_double_2d contacts) {
int64_t i, place, row, count;
array_double_1d history;
double position, velocity;
for (i = 0; i < 24; i += 1) {
*cspan_at(&work, 27, i) = *cspan_at(&resistance, i);
}
history = span_row(&work, 26);
*cspan_at(&history, 0) = axis;
*cspan_at(&history, 1) = 1.0;
*cspan_at(&history, 2) = 0.0;
for (i = 0; i < contacts.shape[0]; i += 1) {
for (place = 0; place < 7; place += 1) {
*cspan_at(&contacts, i, place) = 0.0;
}
*cspan_at(&contacts, i, 0) = 1e+300;
}
axis_motion(&position, &velocity, 0.0, timing, coefficients, offsets, ends, work);
*cspan_at(&contacts, 0, 0) = 0.0;
*cspan_at(&contacts, 0, 1) = position;
if (!rubs(resistance, axis)) {
return 1;
}
*cspan_at(&contacts, 0, 2) = first_deflection(resistance, axis, velocity);
follow_contact(timing, coefficients, offsets, ends, work, contacts);
count = (int64_t)(*cspan_at(&history, 1));
for (row = 0; row < count; row += 1) {
settle_contact(row, timing, coefficients, offsets, ends, work, contacts);
}
return count;
}
static double contact_node(double time, double begin, double end) {
int64_t k;
double node;
if (end > begin) {
for (k = 0; k < 17; k += 1) {
node = begin + k * (end - begin) / 16.0;
if (node > time) {
return node;
}
}
}
return 1e+300;
}
double segfmu_next_contact_event(double time, double start, array_double_2d contacts) {
double after, event;
int64_t row;
after = time + segfmu_same_break(time) - start;
row = find_contact(after, contacts);
event = span_min(contact_node(after, *cspan_at(&contacts, row, 0), *cspan_at(&contacts, row, 5)), contact_node(after, *cspan_at(&contacts, row, 5), *cspan_at(&contacts, row, 6)));
if (after < *cspan_at(&contacts, row, 0)) {
event = *cspan_at(&contacts, row, 0);
}
if ((row + 1 < contacts.shape[0]) && (*cspan_at(&contacts, row + 1, 0) < 1e+300)) {
event = span_min(event, *cspan_at(&contacts, row + 1, 0));
event = span_min(event, contact_node(after, *cspan_at(&contacts, row + 1, 4), *cspan_at(&contacts, row + 1, 0)));
}
if (event < 1e+300) {
event = start + event;
if (event <= time) {
event = 1e+300;
}
}
return event;
}
static void motion_demand(array_double_2d flat, double time, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_1d demand) {
array_double_2d series;
int64_t k;
double velocity, force, acceleration;
series = span_rows(&work, 3, 3 + 23);
crane_inverse(flat, resistance, series, span_row(&work, 0), span_row(&work, 1), span_row(&work, 2));
for (k = 0; k < 3; k += 1) {
velocity = *cspan_at(&work, 1, 5 + k);
force = *cspan_at(&work, 0, k) + segfmu_planned_friction(resistance, k, time, *cspan_at(&work, 1, 0 + k), velocity, span_matrix(&contacts, k));
*cspan_at(&demand, 0 + k) = force;
acceleration = *cspan_at(&work, 2, k);
*cspan_at(&demand, 3 + k) = velocity + *cspan_at(&resistance, 18 + k) * acceleration;
*cspan_at(&demand, 6 + k) = acceleration;
*cspan_at(&demand, 9 + k) = force * velocity;
*cspan_at(&demand, 12 + k) = *cspan_at(&work, 1, 0 + k);
}
for (k = 0; k < 2; k += 1) {
*cspan_at(&demand, 15 + k) = *cspan_at(&work, 1, 3 + k);
}
}
void segfmu_drive_demands(array_double_3d flat, array_double_1d times, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d demands) {
int64_t i;
for (i = 0; i < flat.shape[0]; i += 1) {
motion_demand(span_matrix(&flat, i), *cspan_at(&times, i), resistance, contacts, work, span_row(&demands, i));
}
}
static bool may_slacken(array_double_1d plant) {
bool result;
result = (int64_t)(*cspan_at(&plant, 79)) == 1;
return result;
}
static bool is_slack(array_double_1d state) {
bool result;
result = *cspan_at(&state, 20) > 0.5;
return result;
}
static double axis_position(array_double_1d state, int64_t axis) {
double result;
if ((axis == 2) && is_slack(state)) {
result = *cspan_at(&state, 21);
return result;
}
result = *cspan_at(&state, 0 + axis);
return result;
}
static double axis_velocity(array_double_1d state, int64_t axis) {
double result;
if ((axis == 2) && is_slack(state)) {
result = *cspan_at(&state, 22);
return result;
}
result = *cspan_at(&state, 5 + axis);
return result;
}
static bool bears_wrongly(array_double_1d plant, array_double_1d state, double rope_force) {
double over;
bool result;
if (is_slack(state)) {
over = *cspan_at(&state, 0 + 2) - *cspan_at(&state, 21);
result = over > 1e-10 * *cspan_at(&state, 21);
return result;
}
result = rope_force > 1e-09 * *cspan_at(&plant, 2) * *cspan_at(&plant, 3);
return result;
}
static void change_rope(array_double_1d plant, array_double_1d state) {
int64_t rope;
double mass, against, along, across, drives, lost;
rope = 5 + 2;
if (!is_slack(state)) {
*cspan_at(&state, 20) = 1.0;
*cspan_at(&state, 21) = *cspan_at(&state, 0 + 2);
*cspan_at(&state, 22) = *cspan_at(&state, rope);
return;
}
mass = *cspan_at(&plant, 2);
against = *cspan_at(&state, rope) - *cspan_at(&state, 22);
along = *cspan_at(&state, 22) + sin(*cspan_at(&state, 3)) * *cspan_at(&state, 5);
across = cos(*cspan_at(&state, 3)) * sin(*cspan_at(&state, 3 + 1));
along = along - across * *cspan_at(&state, 5 + 1);
drives = *cspan_at(&state, 13) - mass * against * along;
lost = 0.5 * mass * against * against;
*cspan_at(&state, 13) = drives;
*cspan_at(&state, 15) = *cspan_at(&state, 15) + lost;
*cspan_at(&state, rope) = *cspan_at(&state, 22);
*cspan_at(&state, 20) = 0.0;
*cspan_at(&state, 21) = 0.0;
*cspan_at(&state, 22) = 0.0;
}
static void run_on(array_double_1d plant, array_double_2d work) {
array_double_1d force;
int64_t rope, i;
force = span_row(&work, 13);
rope = 0 + 2;
if ((!may_slacken(plant)) || (*cspan_at(&force, rope) < 0.0)) {
return;
}
*cspan_at(&work, 14, 0 + 2) = *cspan_at(&work, 19, 2);
*cspan_at(&force, rope) = 0.0;
for (i = 0; i < 2; i += 1) {
*cspan_at(&force, 3 + i) = 0.0;
}
}
static void forced_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
array_double_1d force, action;
bool fast;
int64_t i;
double drive, bound;
force = span_row(&work, 13);
action = span_row(&work, 14);
fast = 0;
for (i = 0; i < 3; i += 1) {
drive = *cspan_at(&work, 18, i);
bound = force_bound(plant, i, drive, *cspan_at(&state, 5 + i));
if (exceeds(drive, bound)) {
drive = limited(drive, bound);
*cspan_at(&action, 3 + i) = 1.0;
}
fast = fast || at_velocity_bound(plant, i, state);
*cspan_at(&action, 0 + i) = drive;
*cspan_at(&force, i) = drive - *cspan_at(&work, 19, i);
}
run_on(plant, work);
suspended_rhs(plant, state, work, derivative);
if (fast) {
hold_velocities(plant, state, derivative, action, span_row(&work, 20));
for (i = 0; i < 3; i += 1) {
*cspan_at(&force, i) = *cspan_at(&action, 0 + i) - *cspan_at(&work, 19, i);
}
run_on(plant, work);
suspended_rhs(plant, state, work, derivative);
}
*cspan_at(&action, 6) = *cspan_at(&force, 0 + 2);
}
static void slack_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
array_double_1d force, action;
int64_t i;
double needed, drive, bound;
force = span_row(&work, 13);
action = span_row(&work, 14);
for (i = 0; i < 3; i += 1) {
needed = carriage_mass(plant, i) * *cspan_at(&work, 18, i);
drive = needed + *cspan_at(&work, 19, i);
bound = force_bound(plant, i, drive, axis_velocity(state, i));
if (exceeds(drive, bound) && (i != 2)) {
drive = limited(drive, bound);
*cspan_at(&action, 3 + i) = 1.0;
}
*cspan_at(&action, 0 + i) = drive;
*cspan_at(&force, i) = drive - *cspan_at(&work, 19, i);
}
*cspan_at(&force, 0 + 2) = 0.0;
for (i = 0; i < 2; i += 1) {
*cspan_at(&force, 3 + i) = 0.0;
}
suspended_rhs(plant, state, work, derivative);
*cspan_at(&derivative, 21) = *cspan_at(&state, 22);
*cspan_at(&derivative, 22) = *cspan_at(&work, 18, 2);
*cspan_at(&action, 6) = 0.0;
}
static void driven_forces(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
array_double_1d action;
int64_t i;
action = span_row(&work, 14);
suspended_driven(plant, state, work, derivative);
*cspan_at(&action, 6) = *cspan_at(&action, 0 + 2);
for (i = 0; i < 3; i += 1) {
*cspan_at(&action, 0 + i) = *cspan_at(&action, 0 + i) + *cspan_at(&work, 19, i);
}
}
static void driven_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
array_double_1d action;
int64_t i;
double demand, bound;
action = span_row(&work, 14);
for (i = 0; i < 3; i += 1) {
demand = *cspan_at(&work, 18, i);
if (*cspan_at(&plant, 18 + i) > 0.0) {
bound = velocity_bound(plant, i, demand);
if (exceeds(demand, bound)) {
demand = limited(demand, bound);
*cspan_at(&action, 3 + i) = 1.0;
}
demand = (demand - axis_velocity(state, i)) / *cspan_at(&plant, 18 + i);
}
bound = acceleration_bound(plant, i, demand);
if (exceeds(demand, bound)) {
demand = limited(demand, bound);
*cspan_at(&action, 3 + i) = 1.0;
}
*cspan_at(&work, 18, i) = demand;
}
if (is_slack(state)) {
slack_derivative(plant, state, work, derivative);
return;
}
driven_forces(plant, state, work, derivative);
for (i = 0; i < 3; i += 1) {
bound = force_bound(plant, i, *cspan_at(&action, 0 + i), *cspan_at(&state, 5 + i));
if (exceeds(*cspan_at(&action, 0 + i), bound)) {
limit_accelerations(plant, state, action, span_row(&work, 18), span_row(&work, 20));
driven_forces(plant, state, work, derivative);
break;
}
}
}
static void widest_angle(int64_t sway, double angle, array_double_1d fault) {
if (fabs(angle) > fabs(*cspan_at(&fault, 5))) {
*cspan_at(&fault, 4) = sway;
*cspan_at(&fault, 5) = angle;
}
}
int64_t segfmu_plant_failure(int64_t status, double time, array_double_1d state, array_double_1d plant, array_double_1d fault) {
int64_t i, axis;
*cspan_at(&fault, 0) = time;
if (status == 1) {
*cspan_at(&fault, 2) = *cspan_at(&state, 0 + 2);
*cspan_at(&fault, 5) = 0.0;
for (i = 0; i < 2; i += 1) {
widest_angle(i, *cspan_at(&state, 3 + i), fault);
widest_angle(2 + i, *cspan_at(&state, 16 + i), fault);
}
}
if ((status < 6) || (status == 12)) {
return status;
}
axis = span_floor_mod((status - 6), 3);
*cspan_at(&fault, 1) = axis;
*cspan_at(&fault, 2) = *cspan_at(&state, 0 + axis);
if (status >= 9) {
*cspan_at(&fault, 3) = *cspan_at(&plant, 53 + axis);
return 9;
}
*cspan_at(&fault, 3) = *cspan_at(&plant, 50 + axis);
return 6;
}
static void share_series(array_double_1d resistance, double time, array_double_1d motion, int64_t order, array_double_2d contacts, array_double_2d work) {
array_double_1d share, velocity;
double later, most, released, first, at;
int64_t row, i;
share = span_row(&work, 1);
velocity = span_row(&work, 0);
later = time + segfmu_same_break(time);
row = find_contact(later, contacts);
most = *cspan_at(&resistance, 17);
for (i = 0; i < order + 1; i += 1) {
*cspan_at(&velocity, i) = *cspan_at(&motion, i + 1) / series_factorial(i);
}
released = *cspan_at(&contacts, row, 3);
if (released > 0.0) {
first = *cspan_at(&contacts, row, 2);
for (i = 0; i < order + 1; i += 1) {
*cspan_at(&velocity, i) = 0.0;
}
if (later < *cspan_at(&contacts, row, 5)) {
at = (later - *cspan_at(&contacts, row, 0)) / released;
*cspan_at(&velocity, 0) = release_rate(later, contacts, row);
if (order > 0) {
*cspan_at(&velocity, 1) = (-6.0) * first * (1.0 - 2.0 * at) / (released * released);
}
if (order > 1) {
*cspan_at(&velocity, 2) = 6.0 * first / (released * released * released);
}
}
}
*cspan_at(&share, 0) = planned_deflection(resistance, later, *cspan_at(&motion, 0), contacts, row) / most;
for (i = 0; i < order; i += 1) {
*cspan_at(&share, i + 1) = *cspan_at(&velocity, i) / ((i + 1) * most);
if ((released == 0.0) && (later >= *cspan_at(&contacts, row, 5))) {
*cspan_at(&share, i + 1) = 0.0;
}
}
}
static void level_series(array_double_1d resistance, int64_t axis, int64_t count, array_double_2d work) {
array_double_1d velocity, level, first;
double coulomb, width, rise;
int64_t i;
velocity = span_row(&work, 0);
level = span_row(&work, 2);
first = span_row(&work, 5);
coulomb = *cspan_at(&resistance, 7 + axis);
width = *cspan_at(&resistance, 16);
series_product(velocity, velocity, count, first);
for (i = 0; i < count; i += 1) {
*cspan_at(&first, i) = (-*cspan_at(&first, i)) / (width * width);
}
series_exponential(first, count, level);
rise = span_max(*cspan_at(&resistance, 10 + axis) - coulomb, 0.0);
for (i = 0; i < count; i += 1) {
*cspan_at(&level, i) = rise * *cspan_at(&level, i);
}
*cspan_at(&level, 0) = *cspan_at(&level, 0) + coulomb;
}
static void add_dry_series(array_double_1d resistance, int64_t axis, int64_t count, array_double_2d work) {
array_double_1d velocity, share, level, rest, damped, first, second, third, friction;
double damping;
int64_t i;
velocity = span_row(&work, 0);
share = span_row(&work, 1);
level = span_row(&work, 2);
rest = span_row(&work, 4);
damped = span_row(&work, 3);
first = span_row(&work, 5);
second = span_row(&work, 5 + 1);
third = span_row(&work, 5 + 2);
friction = span_row(&work, 8);
damping = contact_damping(resistance, axis);
series_product(velocity, velocity, count, first);
series_product(level, level, count, second);
for (i = 0; i < count; i += 1) {
*cspan_at(&first, i) = *cspan_at(&second, i) + damping * damping * *cspan_at(&first, i);
*cspan_at(&second, i) = damping * *cspan_at(&velocity, i);
}
series_root(first, count, third);
series_quotient(second, third, count, damped);
series_product(share, share, count, first);
for (i = 0; i < count; i += 1) {
*cspan_at(&rest, i) = -*cspan_at(&first, i);
*cspan_at(&second, i) = (-0.5) * *cspan_at(&first, i);
}
*cspan_at(&rest, 0) = *cspan_at(&rest, 0) + 1.0;
*cspan_at(&second, 0) = *cspan_at(&second, 0) + 1.5;
series_product(share, second, count, first);
series_product(damped, rest, count, second);
for (i = 0; i < count; i += 1) {
*cspan_at(&third, i) = *cspan_at(&first, i) + *cspan_at(&second, i);
}
series_product(level, third, count, first);
for (i = 0; i < count; i += 1) {
*cspan_at(&friction, i) = *cspan_at(&friction, i) + *cspan_at(&first, i);
}
}
double segfmu_friction_derivative(array_double_1d resistance, int64_t axis, double time, array_double_1d motion, int64_t order, array_double_2d contacts, array_double_2d work) {
int64_t count, i;
array_double_1d friction, velocity, square;
double side, later, result;
if ((time < 0.0) || (!segfmu_resists(resistance, axis))) {
return 0.0;
}
count = order + 1;
friction = span_row(&work, 8);
velocity = span_row(&work, 0);
share_series(resistance, time, motion, order, contacts, work);
side = 0.0;
for (i = 0; i < count; i += 1) {
if ((side == 0.0) && (*cspan_at(&velocity, i) != 0.0)) {
side = *cspan_at(&velocity, i) / fabs(*cspan_at(&velocity, i));
}
}
square = span_row(&work, 5);
series_product(velocity, velocity, count, square);
for (i = 0; i < count; i += 1) {
*cspan_at(&friction, i) = *cspan_at(&resistance, 4 + axis) * *cspan_at(&velocity, i);
*cspan_at(&friction, i) = *cspan_at(&friction, i) + side * *cspan_at(&resistance, 13 + axis) * *cspan_at(&square, i);
}
if (rubs(resistance, axis)) {
later = time + segfmu_same_break(time);
level_series(resistance, axis, count, work);
if (stops(later, contacts, find_contact(later, contacts))) {
for (i = 0; i < count; i += 1) {
*cspan_at(&work, 2, i) = 0.0;
}
*cspan_at(&work, 2, 0) = *cspan_at(&resistance, 7 + axis);
}
if (*cspan_at(&work, 2, 0) > 0.0) {
add_dry_series(resistance, axis, count, work);
}
}
result = series_derivative(friction, order);
return result;
}
static double no_stop(void) {
return 1000000000.0;
}
static bool is_place(int64_t i) {
return (12 <= i) && (i < 15);
}
static double end_stop(int64_t i, int64_t side, array_double_1d bounds) {
double least, greatest, found;
least = *cspan_at(&bounds, 26 + i - 12);
greatest = *cspan_at(&bounds, i);
found = greatest;
if (side == 1) {
found = -least;
}
if ((least == greatest) || (found >= no_stop())) {
return no_stop();
}
return found;
}
static double travel_span(int64_t i, int64_t side, array_double_1d bounds) {
double stop, other;
stop = end_stop(i, side, bounds);
other = end_stop(i, 1 - side, bounds);
if (stop == no_stop()) {
return 0.0;
}
if (other == no_stop()) {
return 1.0;
}
return 0.5 * (stop + other);
}
static double travel_origin(int64_t i, int64_t side, array_double_1d bounds) {
double result;
result = end_stop(i, side, bounds) - travel_span(i, side, bounds);
return result;
}
static double clear_peaks(array_double_1d ends, array_double_2d work, array_double_2d peaks, array_double_2d times) {
int64_t axis, i, side;
double duration;
duration = 0.0;
for (axis = 0; axis < ends.shape[0]; axis += 1) {
duration = span_max(duration, *cspan_at(&ends, axis));
*cspan_at(&work, 82, axis) = 0.0;
}
for (i = 0; i < 17; i += 1) {
for (side = 0; side < 2; side += 1) {
*cspan_at(&peaks, side, i) = 0.0;
*cspan_at(&times, side, i) = 0.0;
if (is_place(i)) {
*cspan_at(&peaks, side, i) = -1e+300;
}
}
}
return duration;
}
static void write_transform(array_double_2d work) {
int64_t last, k, j;
double weight, angle;
last = 17 - 1;
for (k = 0; k < 17; k += 1) {
for (j = 0; j < 17; j += 1) {
weight = 2.0 / last;
if ((j == 0) || (j == last)) {
weight = 0.5 * weight;
}
if ((k == 0) || (k == last)) {
weight = 0.5 * weight;
}
angle = 3.141592653589793 * k * (last - j) / last;
*cspan_at(&work, 83 + k, j) = weight * cos(angle);
}
}
}
static void demand_at(double time, int64_t row, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work) {
array_double_2d load;
array_double_1d near;
load = span_rows(&work, 26, 26 + segfmu_flat_orders(resistance));
near = span_row(&work, 82);
evaluate_near(time, near, timing, coefficients, offsets, ends, load);
motion_demand(load, time, resistance, contacts, work, span_row(&work, row));
}
static void note_value(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times) {
int64_t i, side;
double value;
demand_at(time, 81, timing, coefficients, offsets, ends, resistance, contacts, work);
for (i = 0; i < 17; i += 1) {
for (side = 0; side < 2; side += 1) {
value = (1.0 - 2.0 * side) * *cspan_at(&work, 81, i);
if (value > *cspan_at(&peaks, side, i)) {
*cspan_at(&peaks, side, i) = value;
*cspan_at(&times, side, i) = time;
}
}
}
}
static double sooner(double time, double after, double following) {
if (time > after) {
return span_min(time, following);
}
return following;
}
static double next_joint(double time, double duration, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends, array_double_3d contacts) {
double after, following;
int64_t axis, row;
after = time + 1e-12 * duration;
following = next_break(after, timing, offsets, ends);
for (axis = 0; axis < contacts.shape[0]; axis += 1) {
for (row = 0; row < contacts.shape[1]; row += 1) {
if (*cspan_at(&contacts, axis, row, 0) < 1e+300) {
following = sooner(*cspan_at(&contacts, axis, row, 0), after, following);
following = sooner(*cspan_at(&contacts, axis, row, 4), after, following);
following = sooner(*cspan_at(&contacts, axis, row, 5), after, following);
following = sooner(*cspan_at(&contacts, axis, row, 6), after, following);
}
}
}
if (following > duration) {
return 1e+300;
}
return following;
}
static void share_scale(array_double_2d work) {
array_double_1d scale;
int64_t group, last, i;
double most;
scale = span_row(&work, 80);
for (group = 0; group < 17; group += 3) {
last = span_min_int(group + 3, 17);
most = 0.0;
for (i = group; i < last; i += 1) {
most = span_max(most, *cspan_at(&scale, i));
}
for (i = group; i < last; i += 1) {
*cspan_at(&scale, i) = span_max(*cspan_at(&scale, i), 0.001 * most);
}
}
for (i = 15; i < 17; i += 1) {
*cspan_at(&scale, i) = span_max(*cspan_at(&scale, i), 1e-06);
}
}
static void sample_demands(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work) {
int64_t last, j;
double time;
last = 17 - 1;
for (j = 0; j < 17; j += 1) {
time = begin + 0.5 * (end - begin) * (1.0 + cos(3.141592653589793 * (last - j) / last));
demand_at(time, 33 + j, timing, coefficients, offsets, ends, resistance, contacts, work);
}
}
static bool is_resolved(int64_t depth, array_double_2d work) {
bool resolved, rounding;
int64_t k, i, j, last;
array_double_1d series, values;
double weight, tail, scale, before;
resolved = 1;
for (k = 0; k < 17; k += 1) {
series = span_row(&work, 50 + k);
for (i = 0; i < 17; i += 1) {
*cspan_at(&series, i) = 0.0;
}
for (j = 0; j < 17; j += 1) {
weight = *cspan_at(&work, 83 + k, j);
values = span_row(&work, 33 + j);
for (i = 0; i < 17; i += 1) {
*cspan_at(&series, i) = *cspan_at(&series, i) + weight * *cspan_at(&values, i);
}
}
}
for (i = 0; i < 17; i += 1) {
last = 50 + 17 - 1;
tail = span_max(fabs(*cspan_at(&work, last, i)), fabs(*cspan_at(&work, last - 1, i)));
scale = *cspan_at(&work, 80, i);
rounding = 0;
if (depth > 0) {
before = *cspan_at(&work, 67 + depth - 1, i);
rounding = (tail <= 1e-05 * scale) && (tail > 0.1 * before);
}
if ((tail > 1e-11 * scale) && (!rounding)) {
resolved = 0;
}
*cspan_at(&work, 67 + depth, i) = tail;
}
return resolved || (depth == 12);
}
static double series_value(int64_t i, double place, array_double_2d work) {
double second, first, coefficient, value, result;
int64_t j;
second = 0.0;
first = 0.0;
for (j = 0; j < 17 - 1; j += 1) {
coefficient = *cspan_at(&work, 50 + 17 - 1 - j, i);
value = coefficient + 2.0 * place * first - second;
second = first;
first = value;
}
result = *cspan_at(&work, 50, i) + place * first - second;
return result;
}
static double peak_place(int64_t i, double sign, array_double_2d work) {
double reach, best, most, value, lower, upper, golden, left, right, inner;
int64_t k, Dummy_0000;
reach = 2.0 / (65 - 1);
best = -1.0;
most = sign * series_value(i, best, work);
for (k = 1; k < 65; k += 1) {
value = sign * series_value(i, (-1.0) + k * reach, work);
if (value > most) {
most = value;
best = (-1.0) + k * reach;
}
}
lower = span_max(best - reach, -1.0);
upper = span_min(best + reach, 1.0);
golden = 0.5 * (sqrt(5.0) - 1.0);
for (Dummy_0000 = 0; Dummy_0000 < 40; Dummy_0000 += 1) {
left = upper - golden * (upper - lower);
right = lower + golden * (upper - lower);
if (sign * series_value(i, left, work) < sign * series_value(i, right, work)) {
lower = left;
}
else {
upper = right;
}
}
inner = 0.5 * (lower + upper);
if (sign * series_value(i, inner, work) > most) {
return inner;
}
return best;
}
static void note_peaks(double start, double length, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times) {
int64_t i, k, side;
double room, rounding, sign, known, place;
for (i = 0; i < 17; i += 1) {
room = 0.0;
for (k = 1; k < 17; k += 1) {
room = room + fabs(*cspan_at(&work, 50 + k, i));
}
rounding = 1e-13 * (fabs(*cspan_at(&work, 50, i)) + room);
for (side = 0; side < 2; side += 1) {
sign = 1.0 - 2.0 * side;
known = *cspan_at(&peaks, side, i) - rounding;
if (sign * *cspan_at(&work, 50, i) + room > known) {
place = peak_place(i, sign, work);
if (sign * series_value(i, place, work) > known) {
note_value(start + 0.5 * (place + 1.0) * length, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
}
}
}
}
}
static void search_interval(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times) {
int64_t depth, place;
double length, start;
depth = 0;
place = 0;
while((depth > 0) || (place == 0)) {
length = (end - begin) * pow(0.5, (double)(depth));
start = begin + place * length;
sample_demands(start, start + length, timing, coefficients, offsets, ends, resistance, contacts, work);
if (is_resolved(depth, work)) {
note_peaks(start, length, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
place = place + 1;
while((depth > 0) && (span_floor_mod(place, 2) == 0)) {
place = span_floor_div(place, 2);
depth = depth - 1;
}
}
else {
place = 2 * place;
depth = depth + 1;
}
}
}
void segfmu_demand_peaks(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times) {
double duration, begin, end, found;
int64_t i, axis, share;
duration = clear_peaks(ends, work, peaks, times);
for (i = 0; i < 17; i += 1) {
*cspan_at(&work, 80, i) = 0.0;
}
write_transform(work);
note_value(0.0, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
for (axis = 0; axis < ends.shape[0]; axis += 1) {
note_value(*cspan_at(&ends, axis), timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
}
begin = 0.0;
end = next_joint(begin, duration, timing, offsets, ends, contacts);
while(end < 1e+300) {
for (share = 0; share < 2; share += 1) {
demand_at(begin + 0.5 * share * (end - begin), 81, timing, coefficients, offsets, ends, resistance, contacts, work);
for (i = 0; i < 17; i += 1) {
found = fabs(*cspan_at(&work, 81, i));
*cspan_at(&work, 80, i) = span_max(*cspan_at(&work, 80, i), found);
}
}
begin = end;
end = next_joint(begin, duration, timing, offsets, ends, contacts);
}
share_scale(work);
begin = 0.0;
end = next_joint(begin, duration, timing, offsets, ends, contacts);
while(end < 1e+300) {
search_interval(begin, end, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
begin = end;
end = next_joint(begin, duration, timing, offsets, ends, contacts);
}
}
void segfmu_demand_samples(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times) {
double duration, begin, end;
int64_t count, j;
duration = clear_peaks(ends, work, peaks, times);
begin = 0.0;
end = next_joint(begin, duration, timing, offsets, ends, contacts);
while(end < 1e+300) {
count = 8 + (int64_t)(64.0 * (end - begin) / duration + 1e-06);
for (j = 0; j < count; j += 1) {
note_value(begin + (end - begin) * j / count, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
}
begin = end;
end = next_joint(begin, duration, timing, offsets, ends, contacts);
}
}
static double full_circle(void) {
return 6.283185307179586;
}
double segfmu_next_uniform(array_double_1d numbers) {
double first, second, difference;
first = 40014.0 * *cspan_at(&numbers, 0);
second = 40692.0 * *cspan_at(&numbers, 1);
*cspan_at(&numbers, 0) = first - (int64_t)floor(first / 2147483563.0) * 2147483563.0;
*cspan_at(&numbers, 1) = second - (int64_t)floor(second / 2147483399.0) * 2147483399.0;
difference = *cspan_at(&numbers, 0) - *cspan_at(&numbers, 1);
if (difference < 1.0) {
difference = difference + 2147483562.0;
}
return difference / 2147483563.0;
}
void segfmu_seed_numbers(int64_t seed, array_double_1d numbers) {
int64_t other, Dummy_0000;
other = seed * 69069 + 12345;
*cspan_at(&numbers, 0) = 1.0 + seed - span_floor_div(seed, INT64_C(2147483562)) * INT64_C(2147483562);
*cspan_at(&numbers, 1) = 1.0 + other - span_floor_div(other, INT64_C(2147483398)) * INT64_C(2147483398);
for (Dummy_0000 = 0; Dummy_0000 < 20; Dummy_0000 += 1) {
segfmu_next_uniform(numbers);
}
}
static double next_normal(array_double_1d numbers) {
double radius, result;
radius = sqrt((-2.0) * log(segfmu_next_uniform(numbers)));
result = radius * cos(full_circle() * segfmu_next_uniform(numbers));
return result;
}
void segfmu_noise_components(double bandwidth, array_double_1d deviation, array_double_1d numbers, array_double_2d components) {
int64_t count, i, axis;
double frequency, amplitude, phase;
count = components.shape[0];
for (i = 0; i < count; i += 1) {
frequency = full_circle() * bandwidth * (i + segfmu_next_uniform(numbers)) / count;
*cspan_at(&components, i, 0) = frequency;
for (axis = 0; axis < 3; axis += 1) {
amplitude = *cspan_at(&deviation, axis) * sqrt(2.0 / count);
phase = full_circle() * segfmu_next_uniform(numbers);
*cspan_at(&components, i, 1 + axis) = amplitude * cos(phase);
*cspan_at(&components, i, 4 + axis) = amplitude * sin(phase);
}
}
}
void segfmu_turbulence_components(double speed, double length, double bandwidth, array_double_1d deviation, array_double_1d numbers, array_double_2d components) {
int64_t count, i, axis;
double most, held, rest, frequency, amplitude, phase;
count = components.shape[0];
most = bandwidth * length / speed;
held = 1.0 - pow((1.0 + most * most), ((-1.0) / 3.0));
for (i = 0; i < count; i += 1) {
rest = 1.0 - held * (i + segfmu_next_uniform(numbers)) / count;
frequency = sqrt(1.0 / (rest * rest * rest) - 1.0) * speed / length;
*cspan_at(&components, i, 0) = full_circle() * frequency;
*cspan_at(&components, i, 7) = 1.0;
for (axis = 0; axis < 3; axis += 1) {
amplitude = *cspan_at(&deviation, axis) * sqrt(2.0 / count);
phase = full_circle() * segfmu_next_uniform(numbers);
*cspan_at(&components, i, 1 + axis) = amplitude * cos(phase);
*cspan_at(&components, i, 4 + axis) = amplitude * sin(phase);
}
}
}
static double gust_factor(double shape, double share) {
if ((share <= 0.0) || (share >= 1.0)) {
return 0.0;
}
if ((int64_t)(shape) == 1) {
return sin(0.5 * full_circle() * share);
}
return 0.5 * (1.0 - cos(full_circle() * share));
}
static double gust_rate(double shape, double share) {
double angle;
angle = full_circle() * share;
if ((int64_t)(shape) == 1) {
return 0.5 * full_circle() * cos(0.5 * angle);
}
return 0.5 * full_circle() * cos(angle - 0.25 * full_circle());
}
static double command_slope(int64_t i, double elapsed, array_double_1d rate) {
double slope, result;
slope = *cspan_at(&rate, 3 + i) + elapsed * *cspan_at(&rate, 6 + i);
result = *cspan_at(&rate, 0 + i) + elapsed * slope;
return result;
}
static void add_sinusoid(array_double_1d component, double sine, double cosine, array_double_1d total) {
int64_t i;
double added;
for (i = 0; i < 3; i += 1) {
added = *cspan_at(&total, i) + *cspan_at(&component, 1 + i) * sine;
*cspan_at(&total, i) = added + *cspan_at(&component, 4 + i) * cosine;
}
}
static double drag_factor(array_double_1d plant) {
double result;
result = 0.5 * *cspan_at(&plant, 78) * *cspan_at(&plant, 77);
return result;
}
static double relative_speed(array_double_1d air) {
double squares;
int64_t i;
squares = 0.0;
for (i = 0; i < 3; i += 1) {
squares = squares + *cspan_at(&air, 0 + i) * *cspan_at(&air, 0 + i);
}
return sqrt(squares);
}
static void add_drag(array_double_1d plant, array_double_1d state, array_double_2d work) {
array_double_1d air;
int64_t i;
double own, factor;
air = span_row(&work, 21);
suspended_load(plant, state, work, span_rows(&work, 16, 16 + 2));
for (i = 0; i < 3; i += 1) {
own = *cspan_at(&work, 16 + 1, i);
*cspan_at(&air, 0 + i) = *cspan_at(&air, 0 + i) - own;
}
factor = drag_factor(plant) * relative_speed(air);
for (i = 0; i < 3; i += 1) {
*cspan_at(&work, 15, i) = *cspan_at(&work, 15, i) + factor * *cspan_at(&air, 0 + i);
}
}
static void wind_force(array_double_1d plant, array_double_2d components, double start, double elapsed, array_double_1d state, array_double_2d work) {
double time, gust, share, given, steady, sine, cosine;
array_double_1d force, air, rate;
int64_t i, k;
time = start + elapsed;
gust = 0.0;
if (*cspan_at(&plant, 66) > 0.0) {
share = (time - *cspan_at(&plant, 65)) / *cspan_at(&plant, 66);
gust = gust_factor(*cspan_at(&plant, 67), share);
}
force = span_row(&work, 15);
air = span_row(&work, 21);
rate = span_row(&work, 3);
for (i = 0; i < 3; i += 1) {
given = *cspan_at(&work, 2, i) + elapsed * command_slope(i, elapsed, rate);
steady = given + *cspan_at(&plant, 62 + i);
*cspan_at(&force, i) = steady + gust * *cspan_at(&plant, 68 + i);
*cspan_at(&air, 0 + i) = *cspan_at(&plant, 71 + i) + gust * *cspan_at(&plant, 74 + i);
}
for (k = 0; k < components.shape[0]; k += 1) {
sine = sin(*cspan_at(&components, k, 0) * time);
cosine = cos(*cspan_at(&components, k, 0) * time);
if (*cspan_at(&components, k, 7) > 0.5) {
add_sinusoid(span_row(&components, k), sine, cosine, air);
}
else {
add_sinusoid(span_row(&components, k), sine, cosine, force);
}
}
if (*cspan_at(&plant, 77) > 0.0) {
add_drag(plant, state, work);
}
}
static double drag_slope(array_double_1d plant, array_double_1d air, int64_t i, int64_t j) {
double speed, slope, result;
speed = relative_speed(air);
if ((*cspan_at(&plant, 77) == 0.0) || (speed == 0.0)) {
return 0.0;
}
slope = *cspan_at(&air, 0 + i) * *cspan_at(&air, 0 + j) / speed;
if (i == j) {
slope = slope + speed;
}
result = drag_factor(plant) * slope;
return result;
}
static void add_rate(array_double_1d component, double time, int64_t first, array_double_1d total) {
double frequency, angle, sines;
int64_t i;
frequency = *cspan_at(&component, 0);
angle = frequency * time;
for (i = 0; i < 3; i += 1) {
sines = *cspan_at(&component, 1 + i) * cos(angle);
sines = sines - *cspan_at(&component, 4 + i) * sin(angle);
*cspan_at(&total, first + i) = *cspan_at(&total, first + i) + frequency * sines;
}
}
static void wind_rates(array_double_1d plant, array_double_2d components, double time, array_double_1d air) {
double gust, duration, share, rate;
int64_t i, k, j;
gust = 0.0;
duration = *cspan_at(&plant, 66);
if (duration > 0.0) {
share = (time - *cspan_at(&plant, 65)) / duration;
if ((share > 0.0) && (share < 1.0)) {
gust = gust_rate(*cspan_at(&plant, 67), share) / duration;
}
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&air, 3 + i) = gust * *cspan_at(&plant, 74 + i);
*cspan_at(&air, 6 + i) = gust * *cspan_at(&plant, 68 + i);
}
for (k = 0; k < components.shape[0]; k += 1) {
if (*cspan_at(&components, k, 7) > 0.5) {
add_rate(span_row(&components, k), time, 3, air);
}
else {
add_rate(span_row(&components, k), time, 6, air);
}
}
for (i = 0; i < 3; i += 1) {
rate = *cspan_at(&air, 6 + i);
for (j = 0; j < 3; j += 1) {
rate = rate + drag_slope(plant, air, i, j) * *cspan_at(&air, 3 + j);
}
*cspan_at(&air, 6 + i) = rate;
}
}
static double stage_node(int64_t stage) {
if (stage == 0) {
return 0.0;
}
if (stage == 1) {
return 1.0 / 5.0;
}
if (stage == 2) {
return 3.0 / 10.0;
}
if (stage == 3) {
return 4.0 / 5.0;
}
if (stage == 4) {
return 8.0 / 9.0;
}
return 1.0;
}
static double stage_state(int64_t stage, double h, int64_t count, array_double_1d state, array_double_2d k, array_double_1d trial) {
double a0, part, a1, a2, a3, a4, a5, size;
int64_t i;
size = 0.0;
if (stage == 1) {
a0 = h * (1.0 / 5.0);
for (i = 0; i < count; i += 1) {
part = *cspan_at(&state, i) + a0 * *cspan_at(&k, 0, i);
*cspan_at(&trial, i) = part;
size = size + fabs(part);
}
}
else if (stage == 2) {
a0 = h * (3.0 / 40.0);
a1 = h * (9.0 / 40.0);
for (i = 0; i < count; i += 1) {
part = *cspan_at(&state, i) + a0 * *cspan_at(&k, 0, i) + a1 * *cspan_at(&k, 1, i);
*cspan_at(&trial, i) = part;
size = size + fabs(part);
}
}
else if (stage == 3) {
a0 = h * (44.0 / 45.0);
a1 = h * ((-56.0) / 15.0);
a2 = h * (32.0 / 9.0);
for (i = 0; i < count; i += 1) {
part = *cspan_at(&state, i) + a0 * *cspan_at(&k, 0, i) + a1 * *cspan_at(&k, 1, i) + a2 * *cspan_at(&k, 2, i);
*cspan_at(&trial, i) = part;
size = size + fabs(part);
}
}
else if (stage == 4) {
a0 = h * (19372.0 / 6561.0);
a1 = h * ((-25360.0) / 2187.0);
a2 = h * (64448.0 / 6561.0);
a3 = h * ((-212.0) / 729.0);
for (i = 0; i < count; i += 1) {
part = *cspan_at(&state, i) + a0 * *cspan_at(&k, 0, i) + a1 * *cspan_at(&k, 1, i) + a2 * *cspan_at(&k, 2, i);
part = part + a3 * *cspan_at(&k, 3, i);
*cspan_at(&trial, i) = part;
size = size + fabs(part);
}
}
else if (stage == 5) {
a0 = h * (9017.0 / 3168.0);
a1 = h * ((-355.0) / 33.0);
a2 = h * (46732.0 / 5247.0);
a3 = h * (49.0 / 176.0);
a4 = h * ((-5103.0) / 18656.0);
for (i = 0; i < count; i += 1) {
part = *cspan_at(&state, i) + a0 * *cspan_at(&k, 0, i) + a1 * *cspan_at(&k, 1, i) + a2 * *cspan_at(&k, 2, i);
part = part + a3 * *cspan_at(&k, 3, i) + a4 * *cspan_at(&k, 4, i);
*cspan_at(&trial, i) = part;
size = size + fabs(part);
}
}
else {
a0 = h * (35.0 / 384.0);
a2 = h * (500.0 / 1113.0);
a3 = h * (125.0 / 192.0);
a4 = h * ((-2187.0) / 6784.0);
a5 = h * (11.0 / 84.0);
for (i = 0; i < count; i += 1) {
part = *cspan_at(&state, i) + a0 * *cspan_at(&k, 0, i) + a2 * *cspan_at(&k, 2, i) + a3 * *cspan_at(&k, 3, i);
part = part + a4 * *cspan_at(&k, 4, i) + a5 * *cspan_at(&k, 5, i);
*cspan_at(&trial, i) = part;
size = size + fabs(part);
}
}
return size;
}
static double step_error(double h, int64_t count, array_double_1d start, array_double_1d end, array_double_2d k) {
double e0, e2, e3, e4, e5, e6, part, difference, size, error;
int64_t i;
e0 = h * (71.0 / 57600.0);
e2 = h * ((-71.0) / 16695.0);
e3 = h * (71.0 / 1920.0);
e4 = h * ((-17253.0) / 339200.0);
e5 = h * (22.0 / 525.0);
e6 = h * ((-1.0) / 40.0);
error = 0.0;
for (i = 0; i < count; i += 1) {
part = e0 * *cspan_at(&k, 0, i) + e2 * *cspan_at(&k, 2, i) + e3 * *cspan_at(&k, 3, i);
difference = part + e4 * *cspan_at(&k, 4, i) + e5 * *cspan_at(&k, 5, i) + e6 * *cspan_at(&k, 6, i);
size = 1.0 + span_max(fabs(*cspan_at(&start, i)), fabs(*cspan_at(&end, i)));
error = span_max(error, fabs(difference) / size);
}
if (!(error < 1e+100)) {
return 1e+100;
}
return error;
}
static double next_step(double error, double tolerance) {
if (5300.0 * error > tolerance) {
return span_min(5.0, span_max(0.2, 0.9 * pow((tolerance / error), 0.2)));
}
return 5.0;
}
static bool all_finite(array_double_1d values, int64_t count) {
int64_t i;
for (i = 0; i < count; i += 1) {
if (!(fabs(*cspan_at(&values, i)) < 1e+100)) {
return 0;
}
}
return 1;
}
static void plant_powers(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative) {
array_double_1d wind;
bool calm;
double squares, velocity, drive, power, lost;
int64_t i;
wind = span_row(&work, 15);
calm = (*cspan_at(&wind, 0) == 0.0) && (*cspan_at(&wind, 1) == 0.0) && (*cspan_at(&wind, 2) == 0.0);
if (!calm) {
suspended_load(plant, state, work, span_rows(&work, 16, 16 + 2));
}
squares = *cspan_at(&state, 8) * *cspan_at(&state, 8);
squares = squares + *cspan_at(&state, 8 + 1) * *cspan_at(&state, 8 + 1);
*cspan_at(&derivative, 13) = 0.0;
*cspan_at(&derivative, 14) = 0.0;
*cspan_at(&derivative, 15) = *cspan_at(&plant, 49) * squares;
if (may_slacken(plant) && (*cspan_at(&work, 14, 6) >= 0.0)) {
*cspan_at(&derivative, 15) = 0.0;
}
for (i = 0; i < 3; i += 1) {
velocity = axis_velocity(state, i);
drive = *cspan_at(&work, 14, 0 + i) * velocity;
*cspan_at(&derivative, 13) = *cspan_at(&derivative, 13) + drive;
if (!calm) {
power = *cspan_at(&wind, i) * *cspan_at(&work, 16 + 1, i);
*cspan_at(&derivative, 14) = *cspan_at(&derivative, 14) + power;
}
lost = *cspan_at(&work, 19, i) * velocity;
*cspan_at(&derivative, 15) = *cspan_at(&derivative, 15) + lost;
}
}
static void plant_derivative(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, array_double_2d work, array_double_1d derivative) {
array_double_1d rate;
int64_t i;
double slope, demand, velocity, deflection, resistance, deflecting, torque;
rate = span_row(&work, 1);
wind_force(plant, components, time, elapsed, state, work);
for (i = 0; i < 3; i += 1) {
slope = command_slope(i, elapsed, rate);
demand = *cspan_at(&work, 0, i) + elapsed * slope;
velocity = axis_velocity(state, i);
deflection = *cspan_at(&state, 10 + i);
resistance = buffer_force(plant, i, axis_position(state, i), velocity);
resistance = resistance + friction_force(plant, i, velocity, deflection);
deflecting = deflection_rate(plant, i, velocity, deflection);
*cspan_at(&work, 18, i) = demand;
*cspan_at(&work, 19, i) = resistance;
*cspan_at(&derivative, 10 + i) = deflecting;
*cspan_at(&work, 14, 3 + i) = 0.0;
}
for (i = 0; i < 2; i += 1) {
*cspan_at(&derivative, 16 + i) = 0.0;
*cspan_at(&derivative, 18 + i) = 0.0;
}
*cspan_at(&derivative, 20) = 0.0;
*cspan_at(&derivative, 21) = 0.0;
*cspan_at(&derivative, 22) = 0.0;
for (i = 0; i < 2; i += 1) {
torque = (-*cspan_at(&plant, 49)) * *cspan_at(&state, 8 + i);
*cspan_at(&work, 13, 3 + i) = torque;
}
if ((int64_t)(*cspan_at(&plant, 24)) == 1) {
driven_derivative(plant, state, work, derivative);
}
else {
forced_derivative(plant, state, work, derivative);
}
plant_powers(plant, state, work, derivative);
}
static int64_t changing_components(array_double_1d plant) {
if (may_slacken(plant) || has_tackle(plant)) {
return 23;
}
return 16;
}
static void reuse_last_stage(array_double_1d plant, array_double_2d work) {
array_double_1d action;
int64_t i;
action = span_row(&work, 14);
for (i = 0; i < changing_components(plant); i += 1) {
*cspan_at(&work, 4, i) = *cspan_at(&work, 4 + 6, i);
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&action, 8 + i) = *cspan_at(&action, 3 + i);
}
}
static void first_stage(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, array_double_2d work) {
plant_derivative(plant, components, time, elapsed, state, work, span_row(&work, 4 + 6));
reuse_last_stage(plant, work);
}
static double try_step(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, double h, array_double_2d work) {
array_double_2d stages;
array_double_1d trial;
int64_t last, stage, count;
double result;
stages = span_rows(&work, 4, 4 + 7);
trial = span_row(&work, 11);
last = changing_components(plant);
for (stage = 1; stage < 7; stage += 1) {
count = last;
if ((stage != 6) && (last < 23)) {
count = 13;
}
if (!(stage_state(stage, h, count, state, stages, trial) < 1e+100)) {
return 1e+100;
}
plant_derivative(plant, components, time, elapsed + stage_node(stage) * h, trial, work, span_row(&work, 4 + stage));
}
result = step_error(h, last, state, trial, stages);
return result;
}
static int64_t plant_status(array_double_1d plant, array_double_1d state, array_double_1d action) {
int64_t i;
double position, least;
for (i = 0; i < 2; i += 1) {
if ((fabs(*cspan_at(&state, 3 + i)) >= 1.57) || (fabs(*cspan_at(&state, 16 + i)) >= 1.57)) {
return 1;
}
}
if (*cspan_at(&state, 0 + 2) <= 0.0) {
return 2;
}
for (i = 0; i < 3; i += 1) {
if (*cspan_at(&plant, 56 + i) > 0.0) {
continue;
}
position = axis_position(state, i);
if (position < *cspan_at(&plant, 50 + i) - 1e-09) {
return 6 + i;
}
if (position > *cspan_at(&plant, 53 + i) + 1e-09) {
return 9 + i;
}
}
if (bears_wrongly(plant, state, *cspan_at(&action, 6))) {
return 5;
}
least = (-1e-09) * *cspan_at(&plant, 2) * *cspan_at(&plant, 3);
if (has_tackle(plant) && (*cspan_at(&action, 7) < least)) {
return 12;
}
return 0;
}
static void accept_step(array_double_1d plant, array_double_1d state, array_double_2d work, double elapsed, array_double_1d report) {
array_double_1d action;
int64_t i;
double saturated;
action = span_row(&work, 14);
for (i = 0; i < changing_components(plant); i += 1) {
*cspan_at(&state, i) = *cspan_at(&work, 11, i);
}
for (i = 0; i < 3; i += 1) {
saturated = span_max(*cspan_at(&action, 3 + i), *cspan_at(&action, 8 + i));
*cspan_at(&report, 0 + i) = *cspan_at(&action, 0 + i);
*cspan_at(&report, 3 + i) = span_max(*cspan_at(&report, 3 + i), saturated);
}
*cspan_at(&report, 6) = *cspan_at(&action, 6);
*cspan_at(&report, 7) = *cspan_at(&action, 7);
*cspan_at(&report, 8) = *cspan_at(&work, 4 + 6, 14);
*cspan_at(&report, 9) = *cspan_at(&work, 4 + 6, 15);
*cspan_at(&report, 10) = elapsed;
}
int64_t segfmu_plant_advance(array_double_1d plant, array_double_2d components, double time, array_double_1d state, double duration, double tolerance, array_double_2d work, array_double_1d report) {
int64_t i, Dummy_0000, status;
bool finite, last;
double t, planned, h, error;
for (i = 0; i < 11; i += 1) {
*cspan_at(&report, i) = 0.0;
}
finite = all_finite(state, 23) && all_finite(span_row(&work, 0), 3);
if ((!finite) || (!all_finite(span_row(&work, 2), 3))) {
return 4;
}
first_stage(plant, components, time, 0.0, state, work);
t = 0.0;
planned = *cspan_at(&work, 12, 0);
if (planned <= 0.0) {
planned = duration;
}
h = planned;
for (Dummy_0000 = 0; Dummy_0000 < 200000; Dummy_0000 += 1) {
last = h >= duration - t;
if (last) {
planned = h;
h = duration - t;
}
error = try_step(plant, components, time, t, state, h, work);
if (error > tolerance) {
h = h * next_step(error, tolerance);
if (h < 1e-12 * duration) {
return 3;
}
continue;
}
status = plant_status(plant, span_row(&work, 11), span_row(&work, 14));
if (status != 0) {
if (h >= 1e-07) {
h = 0.5 * h;
continue;
}
if ((status != 5) || (!may_slacken(plant))) {
return status;
}
change_rope(plant, state);
first_stage(plant, components, time, t, state, work);
h = duration - t;
continue;
}
t = t + h;
h = h * next_step(error, tolerance);
accept_step(plant, state, work, t, report);
if (last) {
*cspan_at(&work, 12, 0) = span_max(h, planned);
return 0;
}
reuse_last_stage(plant, work);
}
return 3;
}
static bool has_own_bound(int64_t i, int64_t side, array_double_1d bounds) {
bool result;
result = (side == 1) && (i < 9) && (*cspan_at(&bounds, 17 + i) < 0.0);
return result;
}
static double bound_magnitude(int64_t i, int64_t side, array_double_1d bounds) {
double result;
if (is_place(i)) {
result = travel_span(i, side, bounds);
return result;
}
if (has_own_bound(i, side, bounds)) {
result = -*cspan_at(&bounds, 17 + i);
return result;
}
result = *cspan_at(&bounds, i);
return result;
}
static double bound_origin(int64_t i, int64_t side, array_double_1d bounds) {
double result;
if (is_place(i)) {
result = travel_origin(i, side, bounds);
return result;
}
return 0.0;
}
static void write_fault(int64_t i, int64_t side, double peak, double time, array_double_1d bounds, array_double_1d fault) {
*cspan_at(&fault, 0) = span_floor_mod(i, 3);
*cspan_at(&fault, 1) = span_floor_mod(i, 3);
*cspan_at(&fault, 2) = span_floor_mod(i, 3);
*cspan_at(&fault, 3) = 0.0;
*cspan_at(&fault, 4) = peak;
*cspan_at(&fault, 5) = *cspan_at(&bounds, i);
if (is_place(i) && (side == 1)) {
*cspan_at(&fault, 3) = 1.0;
*cspan_at(&fault, 4) = -peak;
*cspan_at(&fault, 5) = -end_stop(i, side, bounds);
}
if (has_own_bound(i, side, bounds)) {
*cspan_at(&fault, 3) = 1.0;
*cspan_at(&fault, 4) = -peak;
*cspan_at(&fault, 5) = *cspan_at(&bounds, 17 + i);
}
*cspan_at(&fault, 6) = time;
}
int64_t segfmu_bound_uses(array_double_2d peaks, array_double_2d times, array_double_1d bounds, array_double_1d uses, array_double_1d fault) {
double worst, bound, share;
int64_t i, side, status;
status = 0;
worst = 1.0 + 1e-09;
for (i = 0; i < 17; i += 1) {
*cspan_at(&uses, 0 + i) = 0.0;
*cspan_at(&uses, 17 + i) = 0.0;
for (side = 0; side < 2; side += 1) {
bound = bound_magnitude(i, side, bounds);
if (bound > 0.0) {
share = (*cspan_at(&peaks, side, i) - bound_origin(i, side, bounds)) / bound;
if (share > *cspan_at(&uses, 0 + i)) {
*cspan_at(&uses, 0 + i) = share;
*cspan_at(&uses, 17 + i) = *cspan_at(&times, side, i);
}
if (share > worst) {
worst = share;
status = 1 + span_floor_div(i, 3);
write_fault(i, side, *cspan_at(&peaks, side, i), *cspan_at(&times, side, i), bounds, fault);
}
}
}
}
return status;
}
bool segfmu_has_bounds(int64_t first, int64_t last, array_double_1d bounds) {
int64_t i, side;
for (i = first; i < last; i += 1) {
for (side = 0; side < 2; side += 1) {
if (bound_magnitude(i, side, bounds) != 0.0) {
return 1;
}
}
}
return 0;
}
double segfmu_paced_use(array_double_1d uses) {
int64_t i;
double found;
found = 0.0;
for (i = 0; i < 17; i += 1) {
if ((!is_place(i)) || (*cspan_at(&uses, 0 + i) > 1.0 + 1e-09)) {
found = span_max(found, *cspan_at(&uses, 0 + i));
}
}
return found;
}
static double hook_unit(int64_t axis, array_double_1d plant) {
double result;
if ((int64_t)(*cspan_at(&plant, 24)) == 1) {
return 1.0;
}
if (axis == 2) {
result = hanging_mass(plant);
return result;
}
result = carriage_mass(plant, axis);
return result;
}
static double hook_lag(int64_t axis, array_double_1d plant) {
double result;
if ((int64_t)(*cspan_at(&plant, 24)) == 1) {
result = *cspan_at(&plant, 18 + axis);
return result;
}
return 0.0;
}
static void hook_model(int64_t axis, array_double_1d plant, double length, array_double_2d model) {
double gravity, hook, total, lag, restoring, pulled;
array_double_1d change, rate;
int64_t j;
gravity = *cspan_at(&plant, 3);
hook = *cspan_at(&plant, 22);
total = hanging_mass(plant);
lag = hook_lag(axis, plant);
matrix_set(9, 0.0, model);
*cspan_at(&model, 0, 3) = 1.0;
change = span_row(&model, 3);
*cspan_at(&change, 6) = 1.0;
if (lag > 0.0) {
*cspan_at(&change, 3) = (-1.0) / lag;
*cspan_at(&change, 7) = 1.0 / lag;
*cspan_at(&model, 7, 8) = 1.0;
}
else {
*cspan_at(&change, 8) = 1.0 / hook_unit(axis, plant);
}
if (axis == 2) {
return;
}
if ((int64_t)(*cspan_at(&plant, 24)) == 0) {
*cspan_at(&change, 1) = total * gravity / carriage_mass(plant, axis);
}
*cspan_at(&model, 1, 4) = 1.0;
*cspan_at(&model, 2, 5) = 1.0;
for (j = 0; j < 9; j += 1) {
*cspan_at(&model, 4, j) = (-*cspan_at(&change, j)) / length;
}
restoring = total * gravity / hook;
pulled = restoring - gravity;
rate = span_row(&model, 4);
*cspan_at(&rate, 1) = *cspan_at(&rate, 1) - restoring / length;
*cspan_at(&rate, 2) = pulled / length;
*cspan_at(&model, 5, 1) = restoring / *cspan_at(&plant, 23);
*cspan_at(&model, 5, 2) = (-restoring) / *cspan_at(&plant, 23);
}
static void hook_moved(double sample_time, array_double_2d work) {
array_double_2d model, moved, term, result;
int64_t doublings, Dummy_0000;
double part;
model = span_rows(&work, 56, 65);
moved = span_rows(&work, 65, 74);
term = span_rows(&work, 74, 83);
result = span_rows(&work, 83, 92);
doublings = halvings_below(9, sample_time, model);
part = sample_time / pow(2.0, (double)(doublings));
matrix_exponential(9, part, model, moved, term, result);
for (Dummy_0000 = 0; Dummy_0000 < doublings; Dummy_0000 += 1) {
matrix_product(9, moved, moved, term);
matrix_copy(9, term, moved);
}
}
static void hook_steady(array_double_2d work) {
array_double_2d spread;
int64_t turns;
spread = span_rows(&work, 48, 56);
turns = 0;
while((kalman_turn(8, spread, span_rows(&work, 0, 48)) > 1e-15) && (turns < 60)) {
turns = turns + 1;
}
}
static void hook_gains(int64_t axis, array_double_1d plant, double length, array_double_1d weights, array_double_2d work, array_double_1d gains) {
array_double_2d moved, spread, kept, information;
double whole, per_rate, unit, largest, effort, place, speed, given, total, weight;
int64_t n, i, j;
array_double_1d row;
moved = span_rows(&work, 65, 74);
spread = span_rows(&work, 48, 56);
kept = span_rows(&work, 0, 8);
information = span_rows(&work, 8, 16);
whole = length + *cspan_at(&plant, 23);
per_rate = whole / *cspan_at(&plant, 3);
n = 8;
unit = hook_unit(axis, plant);
largest = 3.0 * unit * *cspan_at(&plant, 3);
effort = *cspan_at(&weights, 4) / (largest * largest);
matrix_set(n, 0.0, spread);
place = *cspan_at(&weights, 0);
if (axis == 2) {
place = *cspan_at(&weights, 5);
}
else {
*cspan_at(&spread, 1, 1) = *cspan_at(&weights, 1);
*cspan_at(&spread, 2, 2) = *cspan_at(&weights, 1);
*cspan_at(&spread, 4, 4) = *cspan_at(&weights, 3) * per_rate;
*cspan_at(&spread, 5, 5) = *cspan_at(&weights, 3) * per_rate;
}
*cspan_at(&spread, 0, 0) = place / (whole * whole);
speed = *cspan_at(&weights, 2) * per_rate / (whole * whole);
*cspan_at(&spread, 3, 3) = speed;
matrix_copy(n, moved, kept);
for (i = 0; i < n; i += 1) {
*cspan_at(&kept, i, 6) = 0.0;
*cspan_at(&kept, 6, i) = 0.0;
for (j = 0; j < n; j += 1) {
given = *cspan_at(&moved, i, 8) * *cspan_at(&moved, j, 8);
*cspan_at(&information, i, j) = given / effort;
}
}
hook_steady(work);
total = effort;
for (j = 0; j < n; j += 1) {
*cspan_at(&gains, j) = 0.0;
for (i = 0; i < n; i += 1) {
weight = *cspan_at(&moved, i, 8) * *cspan_at(&spread, i, j);
*cspan_at(&gains, j) = *cspan_at(&gains, j) + weight;
}
total = total + *cspan_at(&gains, j) * *cspan_at(&moved, j, 8);
}
row = span_row(&work, 74);
for (j = 0; j < n; j += 1) {
*cspan_at(&row, j) = *cspan_at(&gains, j) / total;
}
for (j = 0; j < n; j += 1) {
*cspan_at(&gains, j) = 0.0;
for (i = 0; i < n; i += 1) {
*cspan_at(&gains, j) = *cspan_at(&gains, j) + *cspan_at(&row, i) * *cspan_at(&moved, i, j);
}
}
*cspan_at(&gains, 6) = 0.0;
*cspan_at(&gains, 8) = 0.0;
if (hook_lag(axis, plant) == 0.0) {
*cspan_at(&gains, 6) = unit;
}
}
static void hook_watch(int64_t axis, array_double_1d plant, double sample_time, double length, array_double_1d weights, array_double_2d work, array_double_2d table) {
array_double_2d moved, spread, information;
double gravity, whole, time, push, swing, walk, angle, place, a, b, d, determinant, first, second;
int64_t n, i, j;
moved = span_rows(&work, 65, 74);
spread = span_rows(&work, 48, 56);
information = span_rows(&work, 8, 16);
gravity = *cspan_at(&plant, 3);
whole = length + *cspan_at(&plant, 23);
time = sqrt(whole / gravity);
n = 8;
matrix_set(n, 0.0, spread);
push = *cspan_at(&weights, 6) * gravity;
*cspan_at(&spread, 3, 3) = push * push;
if (axis != 2) {
swing = *cspan_at(&weights, 7) * gravity / *cspan_at(&plant, 23);
*cspan_at(&spread, 3, 4) = (-push) * push / length;
*cspan_at(&spread, 4, 3) = (-push) * push / length;
*cspan_at(&spread, 4, 4) = push * push / (length * length);
*cspan_at(&spread, 5, 5) = swing * swing;
}
walk = *cspan_at(&weights, 8) * gravity / time;
*cspan_at(&spread, 6, 6) = walk * walk;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&spread, i, j) = *cspan_at(&spread, i, j) * sample_time * time;
}
}
angle = *cspan_at(&weights, 9) * *cspan_at(&weights, 9) * time / sample_time;
place = angle * whole * whole;
matrix_transpose(n, moved, span_rows(&work, 0, 8));
matrix_set(n, 0.0, information);
*cspan_at(&information, 0, 0) = 1.0 / place;
if (axis != 2) {
*cspan_at(&information, 1, 1) = 1.0 / angle;
}
hook_steady(work);
a = *cspan_at(&spread, 0, 0) + place;
b = *cspan_at(&spread, 0, 1);
d = *cspan_at(&spread, 1, 1) + angle;
determinant = a * d - b * b;
for (i = 0; i < n; i += 1) {
first = *cspan_at(&spread, i, 0);
second = *cspan_at(&spread, i, 1);
*cspan_at(&table, 9, i) = (d * first - b * second) / determinant;
*cspan_at(&table, 10, i) = (a * second - b * first) / determinant;
}
*cspan_at(&table, 9, 8) = 0.0;
*cspan_at(&table, 10, 8) = 0.0;
}
void segfmu_hook_design(array_double_1d plant, double sample_time, double length, array_double_1d weights, array_double_2d work, array_double_2d table) {
int64_t j, axis, first, i;
array_double_2d rows;
for (j = 0; j < 9; j += 1) {
*cspan_at(&table, 0, j) = 0.0;
}
*cspan_at(&table, 0, 0) = length;
for (axis = 0; axis < 3; axis += 1) {
first = 1 + axis * 11;
rows = span_rows(&table, first, first + 11);
hook_model(axis, plant, length, span_rows(&work, 56, 65));
hook_moved(sample_time, work);
for (i = 0; i < 8; i += 1) {
for (j = 0; j < 9; j += 1) {
*cspan_at(&rows, 0 + i, j) = *cspan_at(&work, 65 + i, j);
}
}
hook_gains(axis, plant, length, weights, work, span_row(&rows, 8));
hook_watch(axis, plant, sample_time, length, weights, work, rows);
}
}
static int64_t hook_row(int64_t* result_0, double* result_1_0001, double length, array_double_3d table) {
int64_t last, row;
double begin, share;
last = table.shape[0] - 1;
row = 0;
while((row < last - 1) && (length >= *cspan_at(&table, row + 1, 0, 0))) {
row = row + 1;
}
if (last == 0) {
(*result_0) = 0;
(*result_1_0001) = 0.0;
return 0;
}
begin = *cspan_at(&table, row, 0, 0);
share = (length - begin) / (*cspan_at(&table, row + 1, 0, 0) - begin);
(*result_0) = row;
(*result_1_0001) = span_min(span_max(share, 0.0), 1.0);
return 0;
}
static double hook_entry(int64_t row, double share, int64_t i, int64_t j, array_double_3d table) {
double result;
if (share == 0.0) {
result = *cspan_at(&table, row, i, j);
return result;
}
result = (1.0 - share) * *cspan_at(&table, row, i, j) + share * *cspan_at(&table, row + 1, i, j);
return result;
}
static double hook_axis(int64_t axis, int64_t row, double share, array_double_3d table, double seen, double tilted, array_double_1d estimate, array_double_1d work) {
int64_t first, i, j;
double entry, position, angle, gain, wanted;
first = 1 + axis * 11;
for (i = 0; i < 8; i += 1) {
*cspan_at(&work, i) = 0.0;
for (j = 0; j < 9; j += 1) {
entry = hook_entry(row, share, first + 0 + i, j, table);
*cspan_at(&work, i) = *cspan_at(&work, i) + entry * *cspan_at(&estimate, j);
}
}
position = seen - *cspan_at(&work, 0);
angle = tilted - *cspan_at(&work, 1);
wanted = 0.0;
for (i = 0; i < 8; i += 1) {
gain = hook_entry(row, share, first + 9, i, table);
*cspan_at(&estimate, i) = *cspan_at(&work, i) + gain * position;
gain = hook_entry(row, share, first + 10, i, table);
*cspan_at(&estimate, i) = *cspan_at(&estimate, i) + gain * angle;
gain = hook_entry(row, share, first + 8, i, table);
wanted = wanted - gain * *cspan_at(&estimate, i);
}
return wanted;
}
static double hook_kept(int64_t axis, double velocity, double planned, double wanted, array_double_1d limits) {
double period, ahead, room, back;
period = *cspan_at(&limits, 12);
ahead = velocity + period * planned;
room = span_max(*cspan_at(&limits, 9 + axis) - ahead, 0.0);
back = span_min(*cspan_at(&limits, 6 + axis) - ahead, 0.0);
return span_min(span_max(wanted, back / period), room / period);
}
void segfmu_hook_correction(array_double_3d table, array_double_1d limits, array_double_1d measured, array_double_1d reference, array_double_1d feedforward, array_double_2d estimates, array_double_1d correction) {
int64_t row, axis;
double share, tilted, sign, wanted, planned, least, bounded, velocity;
array_double_1d estimate;
hook_row(&row, &share, *cspan_at(&measured, 2), table);
for (axis = 0; axis < 3; axis += 1) {
tilted = 0.0;
if (axis != 2) {
sign = 1.0 - 2.0 * axis;
tilted = sign * (*cspan_at(&measured, 3 + axis) - *cspan_at(&reference, 3 + axis));
}
estimate = span_row(&estimates, axis);
*cspan_at(&estimate, 8) = *cspan_at(&correction, axis);
wanted = hook_axis(axis, row, share, table, *cspan_at(&measured, axis) - *cspan_at(&reference, axis), tilted, estimate, span_row(&estimates, 3));
planned = *cspan_at(&feedforward, axis);
least = *cspan_at(&limits, 0 + axis);
bounded = span_min(span_max(planned + wanted, least), *cspan_at(&limits, 3 + axis));
velocity = *cspan_at(&reference, 5 + axis) + *cspan_at(&estimate, 3);
*cspan_at(&correction, axis) = hook_kept(axis, velocity, planned, bounded - planned, limits);
}
}
void segfmu_hook_frequencies(double rope, array_double_1d masses, array_double_1d found) {
double gravity, sling, hook, total, length, middle;
gravity = *cspan_at(&masses, 3);
sling = *cspan_at(&masses, 5);
hook = *cspan_at(&masses, 4);
total = hook + *cspan_at(&masses, 2);
length = rope + sling;
middle = 0.5 * (length + sqrt(length * length - 4.0 * hook * rope * sling / total));
*cspan_at(&found, 0) = sqrt(gravity / middle);
*cspan_at(&found, 1) = sqrt(gravity * total * middle / (hook * rope * sling));
}
static void write_direction(array_double_1d state, int64_t angle, int64_t rate, int64_t row, array_double_2d work) {
double sine, cosine, across, upright, first, second;
array_double_1d direction, turn;
sine = sin(*cspan_at(&state, angle));
cosine = cos(*cspan_at(&state, angle));
across = sin(*cspan_at(&state, angle + 1));
upright = cos(*cspan_at(&state, angle + 1));
first = *cspan_at(&state, rate);
second = *cspan_at(&state, rate + 1);
direction = span_row(&work, row);
turn = span_row(&work, row + 1);
*cspan_at(&direction, 0) = -sine;
*cspan_at(&direction, 1) = cosine * across;
*cspan_at(&direction, 2) = cosine * upright;
*cspan_at(&turn, 0) = (-cosine) * first;
*cspan_at(&turn, 1) = (-sine) * across * first + cosine * upright * second;
*cspan_at(&turn, 2) = (-sine) * upright * first - cosine * across * second;
}
void segfmu_hook_load_motion(array_double_1d state, array_double_1d tension, array_double_1d masses, array_double_2d work, array_double_2d load) {
double hook, payload, sling, length, pull, change, along, turning, share, sling_pull, gain;
int64_t i;
hook = *cspan_at(&masses, 4);
payload = *cspan_at(&masses, 2);
sling = *cspan_at(&masses, 5);
length = *cspan_at(&state, 0 + 2);
write_direction(state, 3, 10, 0, work);
write_direction(state, 5, 12, 2, work);
pull = -*cspan_at(&tension, 0);
change = -*cspan_at(&tension, 1);
along = 0.0;
turning = 0.0;
for (i = 0; i < 3; i += 1) {
along = along + *cspan_at(&work, 0, i) * *cspan_at(&work, 2, i);
turning = turning + *cspan_at(&work, 3, i) * *cspan_at(&work, 3, i);
}
share = payload / (hook + payload);
sling_pull = share * (pull * along + hook * sling * turning);
gain = 0.0;
for (i = 0; i < 3; i += 1) {
*cspan_at(&work, 4, i) = ((pull * *cspan_at(&work, 0, i) - sling_pull * *cspan_at(&work, 2, i)) / hook - sling_pull * *cspan_at(&work, 2, i) / payload) / sling;
gain = gain + (change * *cspan_at(&work, 0, i) * *cspan_at(&work, 2, i) + pull * *cspan_at(&work, 1, i) * *cspan_at(&work, 2, i) + pull * *cspan_at(&work, 0, i) * *cspan_at(&work, 3, i) + 2.0 * hook * sling * *cspan_at(&work, 3, i) * *cspan_at(&work, 4, i));
}
gain = share * gain;
for (i = 0; i < 3; i += 1) {
*cspan_at(&load, 0, i) = (-length) * *cspan_at(&work, 0, i) - sling * *cspan_at(&work, 2, i);
*cspan_at(&load, 1, i) = (-*cspan_at(&state, 7 + 2)) * *cspan_at(&work, 0, i) - length * *cspan_at(&work, 1, i) - sling * *cspan_at(&work, 3, i);
*cspan_at(&load, 2, i) = sling_pull * *cspan_at(&work, 2, i) / payload;
*cspan_at(&load, 3, i) = (gain * *cspan_at(&work, 2, i) + sling_pull * *cspan_at(&work, 3, i)) / payload;
}
for (i = 0; i < 2; i += 1) {
*cspan_at(&load, 0, i) = *cspan_at(&load, 0, i) + *cspan_at(&state, i);
*cspan_at(&load, 1, i) = *cspan_at(&load, 1, i) + *cspan_at(&state, 7 + i);
}
*cspan_at(&load, 2, 2) = *cspan_at(&load, 2, 2) - *cspan_at(&masses, 3);
}
void segfmu_hook_outputs(array_double_2d memory, array_double_1d outputs) {
array_double_1d state;
array_double_2d work, place;
int64_t i;
state = span_row(&memory, 4);
work = span_rows(&memory, 14, 14 + 26);
for (i = 0; i < 2; i += 1) {
*cspan_at(&outputs, 0 + i) = *cspan_at(&state, 16 + i);
*cspan_at(&outputs, 2 + i) = *cspan_at(&state, 18 + i);
}
place = span_rows(&work, 16, 16 + 2);
segfmu_crane_load(state, place);
for (i = 0; i < 3; i += 1) {
*cspan_at(&outputs, 4 + i) = *cspan_at(&place, 0, i);
*cspan_at(&outputs, 7 + i) = *cspan_at(&place, 1, i);
}
*cspan_at(&outputs, 10) = *cspan_at(&memory, 8, 7);
*cspan_at(&outputs, 11) = 0.0;
*cspan_at(&outputs, 11 + 1) = 0.0;
if (*cspan_at(&memory, 5, 23) > 0.0) {
gather_hook(span_row(&memory, 5), state, work);
segfmu_hook_frequencies(*cspan_at(&state, 0 + 2), span_row(&work, 24), span_piece(&outputs, 11, 11 + 2));
}
}
static void write_margins(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d masses, double hook_mass, double sling, array_double_1d bounds, array_double_2d work) {
double tolerance, share, w_x, w_y, w_z, depth, length;
array_double_2d motion;
array_double_1d margins;
int64_t i;
tolerance = 1e-09;
motion = span_rows(&work, 23, 28);
margins = span_row(&work, 29 + 2);
segfmu_evaluate_orders(time, timing, coefficients, offsets, ends, motion);
share = hook_mass / *cspan_at(&masses, 2);
write_sling(motion, 3, masses, hook_mass, sling, work);
w_x = *cspan_at(&work, 3, 0);
w_y = *cspan_at(&work, 3 + 1, 0);
w_z = *cspan_at(&work, 3 + 2, 0);
depth = -*cspan_at(&work, 0 + 2, 0);
*cspan_at(&margins, 0) = w_z / (1.0 + share) - tolerance * *cspan_at(&masses, 3);
*cspan_at(&margins, 1) = depth - tolerance;
*cspan_at(&margins, 2) = 1e+300;
*cspan_at(&margins, 3) = 1e+300;
if ((w_z > 0.0) && (depth > 0.0)) {
length = depth * sqrt(w_x * w_x + w_y * w_y + w_z * w_z) / w_z;
if (*cspan_at(&bounds, 2) > 0.0) {
*cspan_at(&margins, 2) = *cspan_at(&bounds, 2) * (1.0 + tolerance) - length;
}
if (*cspan_at(&bounds, 1) > 0.0) {
*cspan_at(&margins, 3) = length - *cspan_at(&bounds, 1) * (1.0 - tolerance);
}
}
for (i = 0; i < 4; i += 1) {
*cspan_at(&work, 33, i) = span_min(*cspan_at(&work, 33, i), *cspan_at(&margins, i));
if (*cspan_at(&margins, i) < 0.0) {
*cspan_at(&work, 32, i) = span_min(*cspan_at(&work, 32, i), time);
}
}
}
static bool is_dip(array_double_2d work) {
int64_t i;
double before, middle, after;
for (i = 0; i < 4; i += 1) {
before = *cspan_at(&work, 29, i);
middle = *cspan_at(&work, 29 + 1, i);
after = *cspan_at(&work, 29 + 2, i);
if ((middle <= span_min(before, after)) && (2.0 * middle < span_max(before, after))) {
return 1;
}
}
return 0;
}
static void look_around(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d masses, double hook_mass, double sling, array_double_1d bounds, array_double_2d work) {
int64_t count, j, i, k;
double time, lower;
count = 32;
for (j = 0; j < count + 1; j += 1) {
for (i = 0; i < 4; i += 1) {
*cspan_at(&work, 29, i) = *cspan_at(&work, 29 + 1, i);
*cspan_at(&work, 29 + 1, i) = *cspan_at(&work, 29 + 2, i);
}
time = begin + (end - begin) * j / count;
write_margins(time, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work);
if ((j > 1) && is_dip(work)) {
lower = begin + (end - begin) * (j - 2) / count;
for (k = 1; k < count; k += 1) {
write_margins(lower + (time - lower) * k / count, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work);
}
write_margins(time, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work);
}
}
}
static int64_t judge_margins(array_double_1d bounds, array_double_2d work, array_double_1d report) {
array_double_1d first, least;
first = span_row(&work, 32);
least = span_row(&work, 33);
if (*cspan_at(&first, 0) < 1e+300) {
*cspan_at(&report, 0) = *cspan_at(&first, 0);
*cspan_at(&report, 2) = *cspan_at(&bounds, 0);
*cspan_at(&report, 1) = *cspan_at(&bounds, 0) - *cspan_at(&least, 0);
return 5;
}
if (*cspan_at(&first, 1) < 1e+300) {
*cspan_at(&report, 0) = *cspan_at(&first, 1);
*cspan_at(&report, 2) = 0.0;
*cspan_at(&report, 1) = -*cspan_at(&least, 1);
return 6;
}
if (*cspan_at(&first, 2) < 1e+300) {
*cspan_at(&report, 0) = *cspan_at(&first, 2);
*cspan_at(&report, 2) = *cspan_at(&bounds, 2);
*cspan_at(&report, 1) = *cspan_at(&bounds, 2) - *cspan_at(&least, 2);
return 3;
}
if (*cspan_at(&first, 3) < 1e+300) {
*cspan_at(&report, 0) = *cspan_at(&first, 3);
*cspan_at(&report, 2) = *cspan_at(&bounds, 1);
*cspan_at(&report, 1) = *cspan_at(&bounds, 1) + *cspan_at(&least, 3);
return 4;
}
return 0;
}
int64_t segfmu_check_hook(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d masses, double hook_mass, double sling, array_double_1d bounds, array_double_2d polynomials, array_double_2d work, array_double_1d report) {
array_double_1d free;
int64_t i, status;
double begin, end;
free = span_row(&work, 28);
*cspan_at(&free, 0) = *cspan_at(&bounds, 0);
*cspan_at(&free, 1) = 0.0;
*cspan_at(&free, 2) = 0.0;
status = segfmu_check_rope(timing, coefficients, offsets, free, polynomials, report);
if (status != 0) {
return status;
}
for (i = 0; i < 4; i += 1) {
*cspan_at(&work, 32, i) = 1e+300;
*cspan_at(&work, 33, i) = 1e+300;
}
begin = 0.0;
end = next_break(begin, timing, offsets, ends);
write_margins(begin, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work);
while(end < 1e+300) {
look_around(begin, end, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work);
begin = end;
end = next_break(begin, timing, offsets, ends);
}
status = judge_margins(bounds, work, report);
return status;
}
static double direction_of(array_double_2d places, double least) {
int64_t last, k, axis;
double early, late;
last = places.shape[0] - 1;
for (k = 0; k < last; k += 1) {
for (axis = 0; axis < places.shape[1]; axis += 1) {
early = fabs(*cspan_at(&places, k + 1, axis) - *cspan_at(&places, k, axis));
late = fabs(*cspan_at(&places, last - k, axis) - *cspan_at(&places, last - k - 1, axis));
if (early > late + least) {
return 1.0;
}
if (late > early + least) {
return -1.0;
}
}
}
return 1.0;
}
void segfmu_write_heading(array_double_2d places, array_double_1d heading) {
int64_t last, axis, k, first;
double longest, farthest, way;
last = places.shape[0] - 1;
longest = 0.0;
for (axis = 0; axis < places.shape[1]; axis += 1) {
for (k = 0; k < last; k += 1) {
longest = span_max(longest, fabs(*cspan_at(&places, k + 1, axis) - *cspan_at(&places, k, axis)));
}
}
*cspan_at(&heading, 0) = last;
*cspan_at(&heading, 1) = direction_of(places, 1e-09 * longest);
for (axis = 0; axis < places.shape[1]; axis += 1) {
farthest = 0.0;
*cspan_at(&heading, 2 + axis) = 1.0;
for (k = 0; k < last; k += 1) {
first = k;
if (*cspan_at(&heading, 1) < 0.0) {
first = last - 1 - k;
}
way = *cspan_at(&heading, 1) * (*cspan_at(&places, first + 1, axis) - *cspan_at(&places, first, axis));
if (fabs(way) > farthest + 1e-09 * longest) {
farthest = fabs(way);
*cspan_at(&heading, 2 + axis) = way / farthest;
}
}
}
}
static int64_t state_of(int64_t place, int64_t order, int64_t axis, array_double_1d heading) {
int64_t passed;
passed = place;
if (*cspan_at(&heading, 1) < 0.0) {
passed = (int64_t)(*cspan_at(&heading, 0)) - place;
}
return 3 * 6 + ((passed - 1) * 2 + order) * 3 + axis;
}
static double heading_sign(int64_t order, int64_t axis, array_double_1d heading) {
double result;
if (order == 0) {
result = *cspan_at(&heading, 1) * *cspan_at(&heading, 2 + axis);
return result;
}
result = *cspan_at(&heading, 2 + axis);
return result;
}
void segfmu_begin_pace(double most, double full, array_double_1d pace) {
*cspan_at(&pace, 0) = 1.0;
*cspan_at(&pace, 1) = most;
*cspan_at(&pace, 2) = full;
*cspan_at(&pace, 3) = 0.0;
*cspan_at(&pace, 4) = 1e+300;
*cspan_at(&pace, 5) = 0.0;
*cspan_at(&pace, 6) = 1e+300;
*cspan_at(&pace, 7) = 0.0;
*cspan_at(&pace, 8) = 0.0;
*cspan_at(&pace, 9) = 0.0;
}
static double pace_between(double use, array_double_1d pace) {
double tried, lower, upper, aim, share, rise, growth, found;
bool known;
tried = *cspan_at(&pace, 0);
lower = span_max(*cspan_at(&pace, 3), 0.001);
upper = span_min(*cspan_at(&pace, 4), *cspan_at(&pace, 1));
aim = 0.5 * (1.0 + *cspan_at(&pace, 2));
if ((*cspan_at(&pace, 3) > 0.0) && (*cspan_at(&pace, 4) < 1e+300)) {
share = 0.5;
known = (*cspan_at(&pace, 5) > 0.0) && (*cspan_at(&pace, 6) < 1e+300);
if (known && (span_floor_mod((int64_t)(*cspan_at(&pace, 9)), 3) != 2)) {
rise = log(*cspan_at(&pace, 6) / *cspan_at(&pace, 5));
share = span_min(span_max(log(aim / *cspan_at(&pace, 5)) / rise, 0.001), 0.999);
}
return lower * exp(share * log(upper / lower));
}
if (use >= 1e+300) {
return span_max(0.5 * tried, lower);
}
growth = 2.0;
if ((0.0 < *cspan_at(&pace, 8)) && (*cspan_at(&pace, 8) < 1e+300) && (use > 0.0)) {
growth = log(*cspan_at(&pace, 8) / use) / log(*cspan_at(&pace, 7) / tried);
growth = span_min(span_max(growth, 0.5), 4.0);
}
found = tried * exp(log(aim / span_min(span_max(use, 0.01), 1000000.0)) / growth);
if ((*cspan_at(&pace, 3) == 0.0) && (*cspan_at(&pace, 9) > 2.5)) {
found = span_min(found, 0.5 * tried);
}
return span_min(span_max(found, lower), upper);
}
bool segfmu_next_pace(double use, array_double_1d pace) {
double tried;
bool result;
tried = *cspan_at(&pace, 0);
if (use <= 1.0 + 1e-09) {
*cspan_at(&pace, 3) = tried;
*cspan_at(&pace, 5) = use;
if ((tried >= *cspan_at(&pace, 1)) || (use >= *cspan_at(&pace, 2)) || (*cspan_at(&pace, 9) >= 40.0)) {
return 0;
}
}
else {
*cspan_at(&pace, 4) = tried;
*cspan_at(&pace, 6) = use;
if (tried <= 0.001) {
return 0;
}
}
*cspan_at(&pace, 0) = pace_between(use, pace);
*cspan_at(&pace, 7) = tried;
*cspan_at(&pace, 8) = use;
*cspan_at(&pace, 9) = *cspan_at(&pace, 9) + 1.0;
if (*cspan_at(&pace, 4) <= 1.0000001 * *cspan_at(&pace, 3)) {
*cspan_at(&pace, 9) = 40.0;
}
if (*cspan_at(&pace, 9) >= 40.0) {
*cspan_at(&pace, 0) = *cspan_at(&pace, 3);
}
result = *cspan_at(&pace, 0) > 0.0;
return result;
}
static bool is_free(double state) {
return state != state;
}
static bool may_be_same(array_double_2d one, array_double_2d other) {
int64_t axis, i;
for (axis = 0; axis < one.shape[0]; axis += 1) {
for (i = 0; i < 3; i += 1) {
if (fabs(*cspan_at(&one, axis, i) - *cspan_at(&other, axis, i)) > 1e-15 * span_max(fabs(*cspan_at(&other, axis, i)), 1.0)) {
return 0;
}
}
}
return 1;
}
static void take_states(bool every, array_double_2d given, array_double_2d found) {
int64_t axis, i;
for (axis = 0; axis < found.shape[0]; axis += 1) {
for (i = 0; i < 3; i += 1) {
if (every || is_free(*cspan_at(&found, axis, i))) {
*cspan_at(&found, axis, i) = *cspan_at(&given, axis, i);
}
}
}
}
void segfmu_unite_waypoints(array_double_3d states, array_double_1d place) {
int64_t first, point;
first = 0;
*cspan_at(&place, 0) = 0.0;
for (point = 1; point < states.shape[0]; point += 1) {
*cspan_at(&place, point) = *cspan_at(&place, point - 1);
if (may_be_same(span_matrix(&states, first), span_matrix(&states, point))) {
take_states(0, span_matrix(&states, point), span_matrix(&states, first));
}
else {
first = point;
*cspan_at(&place, point) = *cspan_at(&place, point - 1) + 1.0;
}
}
for (point = 1; point < states.shape[0]; point += 1) {
if (*cspan_at(&place, point) == *cspan_at(&place, point - 1)) {
take_states(1, span_matrix(&states, point - 1), span_matrix(&states, point));
}
}
}
static bool is_passed(int64_t point, int64_t axis, array_double_3d states, array_double_1d place, array_double_1d dwells) {
int64_t before, after, last, k;
double here, come, goes;
before = point;
after = point;
last = states.shape[0] - 1;
while((before > 0) && (*cspan_at(&place, before) == *cspan_at(&place, point))) {
before = before - 1;
}
while((after < last) && (*cspan_at(&place, after) == *cspan_at(&place, point))) {
after = after + 1;
}
if ((*cspan_at(&place, before) == *cspan_at(&place, point)) || (*cspan_at(&place, after) == *cspan_at(&place, point))) {
return 0;
}
for (k = before + 1; k < after; k += 1) {
if (*cspan_at(&dwells, k) > 0.0) {
return 0;
}
}
here = *cspan_at(&states, point, axis, 0);
come = here - *cspan_at(&states, before, axis, 0);
goes = *cspan_at(&states, after, axis, 0) - here;
return come * goes > 0.0;
}
void segfmu_write_free(array_double_3d states, array_double_1d place, array_double_1d dwells, array_double_1d heading, array_double_1d kinds, array_double_2d led) {
int64_t points, i, point, axis, order;
points = states.shape[0];
for (i = 3 * 6; i < kinds.shape[0]; i += 1) {
*cspan_at(&kinds, i) = 0;
}
for (point = 0; point < points; point += 1) {
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&led, point, axis) = 0.0;
if (is_passed(point, axis, states, place, dwells)) {
for (order = 0; order < 2; order += 1) {
if (is_free(*cspan_at(&states, point, axis, 1 + order))) {
*cspan_at(&led, point, axis) = 1.0;
i = state_of((int64_t)(*cspan_at(&place, point)), order, axis, heading);
*cspan_at(&kinds, i) = 2;
}
}
}
}
}
for (point = 0; point < points; point += 1) {
for (axis = 0; axis < 3; axis += 1) {
for (i = 1; i < 3; i += 1) {
if (is_free(*cspan_at(&states, point, axis, i))) {
*cspan_at(&states, point, axis, i) = 0.0;
}
}
}
}
}
void segfmu_write_states(array_double_1d unknowns, array_double_1d kinds, array_double_2d table, array_double_1d place, array_double_1d heading, array_double_3d states) {
int64_t points, point, axis, order, i;
double limit, share, value;
points = states.shape[0];
for (point = 0; point < points; point += 1) {
if ((0.5 < *cspan_at(&place, point)) && (*cspan_at(&place, point) < *cspan_at(&place, points - 1))) {
for (axis = 0; axis < 3; axis += 1) {
for (order = 0; order < 2; order += 1) {
i = state_of((int64_t)(*cspan_at(&place, point)), order, axis, heading);
if ((int64_t)(*cspan_at(&kinds, i)) == 2) {
limit = *cspan_at(&table, axis, 0 + order);
share = span_min(span_max(*cspan_at(&unknowns, i), -1.0), 1.0);
value = heading_sign(order, axis, heading) * share * limit;
*cspan_at(&states, point, axis, 1 + order) = value;
}
}
}
}
}
}
static double without_digits(double value) {
return (int64_t)floor(value * 1048576.0 + 0.5) / 1048576.0;
}
static void write_paced(array_double_2d search) {
double faster, moved;
int64_t i;
faster = log(*cspan_at(&search, 1, 0));
for (i = 0; i < (int64_t)(*cspan_at(&search, 0, 1)); i += 1) {
moved = *cspan_at(&search, 5, i) + *cspan_at(&search, 15, i) * faster;
*cspan_at(&search, 2, i) = *cspan_at(&search, 3, i) + without_digits(moved);
}
}
static void enter_paces(double wanted, array_double_2d search) {
array_double_1d state;
state = span_row(&search, 0);
*cspan_at(&state, 14) = wanted;
segfmu_begin_pace(1000.0, 0.995, span_row(&search, 1));
*cspan_at(&state, 5) = 0.0;
*cspan_at(&state, 6) = 0.0;
*cspan_at(&state, 11) = 1e+300;
write_paced(search);
}
static double log_of(double duration) {
return log(span_max(duration, 1e-300));
}
static double largest_share(array_double_1d uses) {
int64_t i;
double found;
found = 0.0;
for (i = 0; i < 2 * 17; i += 1) {
found = span_max(found, *cspan_at(&uses, i));
}
return found;
}
static void write_values(double duration, array_double_1d uses, array_double_1d row) {
int64_t i;
*cspan_at(&row, 0) = log_of(duration);
for (i = 0; i < 2 * 17; i += 1) {
*cspan_at(&row, 1 + i) = *cspan_at(&uses, i);
}
}
static void note_best(array_double_2d search) {
array_double_1d state;
int64_t i;
state = span_row(&search, 0);
if (*cspan_at(&state, 11) < *cspan_at(&state, 12) - 1e-09) {
*cspan_at(&state, 12) = *cspan_at(&state, 11);
for (i = 0; i < (int64_t)(*cspan_at(&state, 1)); i += 1) {
*cspan_at(&search, 8, i) = *cspan_at(&search, 2, i);
}
}
}
static bool is_hopeless(double duration, array_double_2d search) {
array_double_1d state;
double faster;
bool result;
state = span_row(&search, 0);
if ((int64_t)(*cspan_at(&state, 0)) != 4) {
return 0;
}
faster = log(*cspan_at(&search, 1, 0) / *cspan_at(&search, 1, 7));
result = log_of(duration) - faster - 0.9 * fabs(faster) > *cspan_at(&state, 14);
return result;
}
static bool next_of_paces(double duration, array_double_1d uses, array_double_2d search, array_double_2d values) {
array_double_1d state;
double use;
int64_t i;
state = span_row(&search, 0);
use = 1e+300;
if (duration >= 0.0) {
use = largest_share(uses);
if ((use <= 1.0 + 1e-09) && (log_of(duration) < *cspan_at(&state, 11) - 1e-09)) {
*cspan_at(&state, 11) = log_of(duration);
write_values(duration, uses, span_row(&values, 1));
for (i = 0; i < (int64_t)(*cspan_at(&state, 1)); i += 1) {
*cspan_at(&search, 6, i) = *cspan_at(&search, 2, i) - *cspan_at(&search, 3, i);
}
note_best(search);
}
}
else {
*cspan_at(&state, 6) = *cspan_at(&state, 6) + 1.0;
}
*cspan_at(&state, 5) = *cspan_at(&state, 5) + 1.0;
if ((*cspan_at(&state, 5) > 5.5) || (*cspan_at(&state, 6) > 1.5)) {
return 0;
}
if (!segfmu_next_pace(use, span_row(&search, 1))) {
return 0;
}
if ((duration >= 0.0) && is_hopeless(duration, search)) {
return 0;
}
write_paced(search);
return 1;
}
static bool has_states(array_double_2d search) {
int64_t i;
for (i = 0; i < (int64_t)(*cspan_at(&search, 0, 1)); i += 1) {
if ((int64_t)(*cspan_at(&search, 14, i)) == 2) {
return 1;
}
}
return 0;
}
static double merit_of(double duration, array_double_1d uses) {
double result;
result = log_of(duration) + 0.5 * log(span_max(largest_share(uses), 1e-09));
return result;
}
bool segfmu_is_judged(double duration, array_double_1d uses, array_double_2d search) {
array_double_1d state;
int64_t stage;
bool kept, result;
double useful;
state = span_row(&search, 0);
stage = (int64_t)(*cspan_at(&state, 0));
if (stage == 3) {
result = has_states(search);
return result;
}
if (stage == 2) {
result = merit_of(duration, uses) < *cspan_at(&state, 14) - 0.0001;
return result;
}
kept = largest_share(uses) <= 1.0 + 1e-09;
useful = span_min(*cspan_at(&state, 11) - 1e-09, *cspan_at(&state, 14));
return kept && (log_of(duration) < useful);
}
void segfmu_cap_best(array_double_2d axes, array_double_2d search) {
int64_t axis, i, known;
double most;
for (axis = 0; axis < axes.shape[0]; axis += 1) {
for (i = 0; i < 6; i += 1) {
known = axis * 6 + i;
most = log(*cspan_at(&axes, axis, 17 + i));
*cspan_at(&search, 8, known) = span_min(*cspan_at(&search, 8, known), most);
}
}
}
void segfmu_write_best(double pace, array_double_2d search) {
double faster;
int64_t i;
faster = log(pace);
for (i = 0; i < (int64_t)(*cspan_at(&search, 0, 1)); i += 1) {
*cspan_at(&search, 2, i) = *cspan_at(&search, 8, i) + *cspan_at(&search, 15, i) * faster;
}
}
void segfmu_keep_best(double pace, array_double_2d search) {
int64_t i;
segfmu_write_best(pace, search);
for (i = 0; i < (int64_t)(*cspan_at(&search, 0, 1)); i += 1) {
*cspan_at(&search, 8, i) = *cspan_at(&search, 2, i);
}
}
static bool enter_poll(array_double_2d search) {
array_double_1d state;
int64_t i;
state = span_row(&search, 0);
*cspan_at(&state, 0) = 2;
*cspan_at(&state, 14) = 1e+300;
*cspan_at(&state, 3) = -1.0;
*cspan_at(&state, 4) = -1.0;
for (i = 0; i < (int64_t)(*cspan_at(&state, 1)); i += 1) {
*cspan_at(&search, 2, i) = *cspan_at(&search, 3, i) + *cspan_at(&search, 4, i);
}
return 1;
}
static double poll_change(int64_t way) {
double size;
size = 0.15;
if (way > 1) {
size = 0.45;
}
if (span_floor_mod(way, 2) == 1) {
return -size;
}
return size;
}
static bool next_poll(double duration, array_double_1d uses, array_double_2d search) {
array_double_1d state;
int64_t n, i, way, j;
double merit, here, changed;
state = span_row(&search, 0);
n = (int64_t)(*cspan_at(&state, 1));
if (duration >= 0.0) {
merit = merit_of(duration, uses);
if (merit < *cspan_at(&state, 14) - 0.0001) {
*cspan_at(&state, 14) = merit;
for (i = 0; i < n; i += 1) {
*cspan_at(&search, 4, i) = *cspan_at(&search, 2, i) - *cspan_at(&search, 3, i);
}
}
}
while(*cspan_at(&state, 3) < n) {
i = (int64_t)(*cspan_at(&state, 3));
way = (int64_t)(*cspan_at(&state, 4)) + 1;
if ((i < 0) || (way > 3) || ((int64_t)(*cspan_at(&search, 14, i)) != 2)) {
*cspan_at(&state, 3) = *cspan_at(&state, 3) + 1.0;
*cspan_at(&state, 4) = -1.0;
}
else {
*cspan_at(&state, 4) = way;
here = *cspan_at(&search, 3, i) + *cspan_at(&search, 4, i);
changed = span_min(span_max(here + poll_change(way), -1.0), 1.0);
if (fabs(changed - here) > 1e-06) {
for (j = 0; j < n; j += 1) {
*cspan_at(&search, 2, j) = *cspan_at(&search, 3, j) + *cspan_at(&search, 4, j);
}
*cspan_at(&search, 2, i) = changed;
return 1;
}
}
}
return 0;
}
static bool leave_poll(array_double_2d search) {
array_double_1d state;
int64_t i;
state = span_row(&search, 0);
for (i = 0; i < (int64_t)(*cspan_at(&state, 1)); i += 1) {
*cspan_at(&search, 5, i) = *cspan_at(&search, 4, i);
}
*cspan_at(&state, 0) = 1;
enter_paces(1e+300, search);
return 1;
}
static double change_of(array_double_2d search) {
double size;
size = 0.02;
if ((int64_t)((*cspan_at(&search, 14, (int64_t)(*cspan_at(&search, 0, 3))))) == 2) {
size = 0.01;
}
if (*cspan_at(&search, 0, 4) > 0.5) {
return size;
}
return -size;
}
static bool write_changed(array_double_2d search) {
array_double_1d state;
int64_t n, changed, i;
state = span_row(&search, 0);
n = (int64_t)(*cspan_at(&state, 1));
changed = (int64_t)(*cspan_at(&state, 3));
if (*cspan_at(&state, 4) > 0.5) {
changed = changed + 1;
while((changed < n) && ((int64_t)(*cspan_at(&search, 14, changed)) == 0)) {
changed = changed + 1;
}
*cspan_at(&state, 4) = 0.0;
}
else {
*cspan_at(&state, 4) = 1.0;
}
*cspan_at(&state, 3) = changed;
if (changed >= n) {
return 0;
}
for (i = 0; i < n; i += 1) {
*cspan_at(&search, 2, i) = *cspan_at(&search, 3, i) + *cspan_at(&search, 4, i);
}
*cspan_at(&search, 2, changed) = *cspan_at(&search, 2, changed) + change_of(search);
return 1;
}
static bool enter_slopes(array_double_2d search) {
array_double_1d state;
bool result;
state = span_row(&search, 0);
*cspan_at(&state, 0) = 3;
*cspan_at(&state, 3) = -1.0;
*cspan_at(&state, 4) = 1.0;
*cspan_at(&state, 15) = 0.0;
result = write_changed(search);
return result;
}
static bool next_slope(double duration, array_double_1d uses, array_double_2d search, array_double_2d values, array_double_2d slopes) {
array_double_1d state, centre;
int64_t i, j;
double change;
bool result;
state = span_row(&search, 0);
i = (int64_t)(*cspan_at(&state, 3));
*cspan_at(&search, 16, i) = 0.0;
if (duration >= 0.0) {
*cspan_at(&search, 16, i) = 1.0;
change = change_of(search);
centre = span_row(&values, 0);
*cspan_at(&slopes, i, 0) = (log_of(duration) - *cspan_at(&centre, 0)) / change;
for (j = 0; j < 2 * 17; j += 1) {
*cspan_at(&slopes, i, 1 + j) = (*cspan_at(&uses, j) - *cspan_at(&centre, 1 + j)) / change;
}
*cspan_at(&state, 4) = 1.0;
}
result = write_changed(search);
return result;
}
static void correct_slopes(array_double_2d search, array_double_2d values, array_double_2d slopes) {
int64_t n, i, j;
double squared, change, missing;
n = (int64_t)(*cspan_at(&search, 0, 1));
squared = 0.0;
for (i = 0; i < n; i += 1) {
change = *cspan_at(&search, 16, i) * (*cspan_at(&search, 6, i) - *cspan_at(&search, 4, i));
*cspan_at(&search, 7, i) = change;
squared = squared + change * change;
}
if (squared <= 0.0) {
return;
}
for (j = 0; j < 35; j += 1) {
missing = *cspan_at(&values, 1, j) - *cspan_at(&values, 0, j);
for (i = 0; i < n; i += 1) {
missing = missing - *cspan_at(&slopes, i, j) * *cspan_at(&search, 7, i);
}
for (i = 0; i < n; i += 1) {
*cspan_at(&slopes, i, j) = *cspan_at(&slopes, i, j) + missing * *cspan_at(&search, 7, i) / squared;
}
}
}
static void add_bound(int64_t n, int64_t row, array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton) {
double room, own;
int64_t i, j;
room = span_max(1.0 - *cspan_at(&values, 0, row), 1e-05);
for (i = 0; i < n; i += 1) {
room = room - *cspan_at(&search, 16, i) * *cspan_at(&slopes, i, row) * *cspan_at(&search, 7, i);
}
for (i = 0; i < n; i += 1) {
own = *cspan_at(&search, 16, i) * *cspan_at(&slopes, i, row) / room;
*cspan_at(&newton, n + i, 0) = *cspan_at(&newton, n + i, 0) - own;
if (own != 0.0) {
for (j = 0; j < n; j += 1) {
*cspan_at(&newton, i, j) = *cspan_at(&newton, i, j) + own * *cspan_at(&search, 16, j) * *cspan_at(&slopes, j, row) / room;
}
}
}
}
static double damped_step(int64_t n, double radius, double weight, array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton) {
int64_t i, j, row;
double above, below, force, squared, decrement;
for (i = 0; i < n; i += 1) {
for (j = 0; j < n; j += 1) {
*cspan_at(&newton, i, j) = 0.0;
}
above = radius - *cspan_at(&search, 7, i);
below = radius + *cspan_at(&search, 7, i);
*cspan_at(&newton, i, i) = 1.0 / (above * above) + 1.0 / (below * below);
force = *cspan_at(&search, 16, i) * weight * *cspan_at(&slopes, i, 0);
*cspan_at(&newton, n + i, 0) = (-force) - 1.0 / above + 1.0 / below;
}
for (row = 1; row < slopes.shape[1]; row += 1) {
if (*cspan_at(&values, 0, row) > 0.3) {
add_bound(n, row, search, values, slopes, newton);
}
}
for (i = 0; i < n; i += 1) {
*cspan_at(&newton, n + i, 1) = *cspan_at(&newton, n + i, 0);
}
matrix_solve(n, 1, span_rows(&newton, 0, n), span_rows(&newton, n, 2 * n));
squared = 0.0;
for (i = 0; i < n; i += 1) {
squared = squared + *cspan_at(&newton, n + i, 0) * *cspan_at(&newton, n + i, 1);
}
decrement = sqrt(span_max(squared, 0.0));
for (i = 0; i < n; i += 1) {
*cspan_at(&search, 7, i) = *cspan_at(&search, 7, i) + *cspan_at(&newton, n + i, 0) / (1.0 + decrement);
}
return decrement;
}
static void write_step(array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton) {
int64_t n, i, level, trial;
double radius, most, weight, promised;
n = (int64_t)(*cspan_at(&search, 0, 1));
radius = *cspan_at(&search, 0, 9);
most = 0.0;
for (i = 0; i < n; i += 1) {
*cspan_at(&search, 7, i) = 0.0;
most = most + *cspan_at(&search, 16, i) * fabs(*cspan_at(&slopes, i, 0)) * radius;
}
*cspan_at(&search, 0, 10) = 0.0;
if (most <= 0.0) {
return;
}
weight = (2.0 * n + 1 + 28.0) / most;
for (level = 0; level < 6; level += 1) {
for (trial = 0; trial < 40; trial += 1) {
if (damped_step(n, radius, weight, search, values, slopes, newton) < 0.3) {
break;
}
}
weight = 8.0 * weight;
}
promised = 0.0;
for (i = 0; i < n; i += 1) {
promised = promised - *cspan_at(&search, 7, i) * *cspan_at(&slopes, i, 0);
}
*cspan_at(&search, 0, 10) = promised;
}
static void enter_start(array_double_2d starts, array_double_2d search) {
int64_t row, i;
row = (int64_t)(*cspan_at(&search, 0, 2));
for (i = 0; i < starts.shape[1]; i += 1) {
*cspan_at(&search, 3, i) = *cspan_at(&starts, row, i);
*cspan_at(&search, 5, i) = 0.0;
}
enter_paces(*cspan_at(&search, 13, 4 - 1), search);
}
void segfmu_begin_limits(array_double_2d starts, array_double_1d kinds, array_double_2d search) {
int64_t n, i, slot;
array_double_1d state;
n = kinds.shape[0];
state = span_row(&search, 0);
for (i = 0; i < 16; i += 1) {
*cspan_at(&state, i) = 0.0;
}
for (i = 0; i < n; i += 1) {
*cspan_at(&search, 14, i) = *cspan_at(&kinds, i);
*cspan_at(&search, 15, i) = 0.0;
if ((int64_t)(*cspan_at(&kinds, i)) == 1) {
*cspan_at(&search, 15, i) = 1.0 + span_floor_mod(span_floor_mod(i, 6), 4);
}
}
*cspan_at(&state, 1) = n;
*cspan_at(&state, 0) = 0;
*cspan_at(&state, 12) = 1e+300;
for (slot = 0; slot < 4; slot += 1) {
*cspan_at(&search, 13, slot) = 1e+300;
}
enter_start(starts, search);
}
static double worth_while(void) {
return 0.0005;
}
static bool enter_descent(array_double_2d search) {
array_double_1d state;
int64_t slot, i;
bool result;
state = span_row(&search, 0);
*cspan_at(&state, 2) = *cspan_at(&state, 2) + 1.0;
slot = (int64_t)(*cspan_at(&state, 2));
if ((slot == 4) || (*cspan_at(&search, 13, slot) >= 1e+300)) {
return 0;
}
for (i = 0; i < (int64_t)(*cspan_at(&state, 1)); i += 1) {
*cspan_at(&search, 3, i) = *cspan_at(&search, 9 + slot, i);
*cspan_at(&search, 4, i) = 0.0;
*cspan_at(&search, 5, i) = 0.0;
}
*cspan_at(&state, 8) = 0.0;
if (has_states(search)) {
*cspan_at(&state, 13) = *cspan_at(&search, 13, slot);
result = enter_poll(search);
return result;
}
*cspan_at(&state, 0) = 1;
enter_paces(1e+300, search);
return 1;
}
static bool leave_round(array_double_2d search) {
array_double_1d state;
double gain;
bool result;
state = span_row(&search, 0);
*cspan_at(&state, 8) = *cspan_at(&state, 8) + 1.0;
gain = *cspan_at(&state, 13) - *cspan_at(&state, 12);
if ((!has_states(search)) || (gain < 0.002) || (*cspan_at(&state, 8) > 7.5)) {
result = enter_descent(search);
return result;
}
*cspan_at(&state, 13) = *cspan_at(&state, 12);
result = enter_poll(search);
return result;
}
static bool enter_step(array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton) {
array_double_1d state;
double behind;
int64_t i;
bool result;
state = span_row(&search, 0);
write_step(search, values, slopes, newton);
if (*cspan_at(&state, 10) <= worth_while()) {
if (*cspan_at(&state, 15) > 0.5) {
result = enter_slopes(search);
return result;
}
result = leave_round(search);
return result;
}
behind = *cspan_at(&values, 0, 0) - *cspan_at(&state, 12);
if ((behind > 0.01) && (behind > 4.0 * *cspan_at(&state, 10))) {
result = leave_round(search);
return result;
}
for (i = 0; i < (int64_t)(*cspan_at(&state, 1)); i += 1) {
*cspan_at(&search, 5, i) = *cspan_at(&search, 4, i) + *cspan_at(&search, 7, i);
}
*cspan_at(&state, 0) = 4;
enter_paces(*cspan_at(&values, 0, 0), search);
return 1;
}
static void note_start(array_double_2d search) {
array_double_1d state;
int64_t n, slot, i;
double found;
state = span_row(&search, 0);
n = (int64_t)(*cspan_at(&state, 1));
found = *cspan_at(&state, 11);
slot = 4;
while((slot > 0) && (found < *cspan_at(&search, 13, slot - 1) - 1e-09)) {
slot = slot - 1;
if (slot + 1 < 4) {
*cspan_at(&search, 13, slot + 1) = *cspan_at(&search, 13, slot);
for (i = 0; i < n; i += 1) {
*cspan_at(&search, 9 + slot + 1, i) = *cspan_at(&search, 9 + slot, i);
}
}
}
if (slot < 4) {
*cspan_at(&search, 13, slot) = found;
for (i = 0; i < n; i += 1) {
*cspan_at(&search, 9 + slot, i) = *cspan_at(&search, 3, i) + *cspan_at(&search, 6, i);
}
}
}
static void enter_centre(array_double_2d search, array_double_2d values) {
int64_t i;
for (i = 0; i < (int64_t)(*cspan_at(&search, 0, 1)); i += 1) {
*cspan_at(&search, 4, i) = *cspan_at(&search, 6, i);
}
for (i = 0; i < 35; i += 1) {
*cspan_at(&values, 0, i) = *cspan_at(&values, 1, i);
}
}
static bool enter_round(array_double_2d search, array_double_2d values) {
array_double_1d state;
bool result;
state = span_row(&search, 0);
if (*cspan_at(&state, 11) >= 1e+300) {
result = enter_descent(search);
return result;
}
enter_centre(search, values);
*cspan_at(&state, 7) = 0.0;
*cspan_at(&state, 9) = 0.3;
result = enter_slopes(search);
return result;
}
static double least_radius(array_double_2d search) {
if (has_states(search)) {
return 0.01;
}
return 0.02;
}
static bool judge_step(array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton) {
array_double_1d state;
double gain;
bool result;
state = span_row(&search, 0);
gain = *cspan_at(&values, 0, 0) - *cspan_at(&state, 11);
if (gain > 0.2 * worth_while()) {
if (gain > 0.7 * *cspan_at(&state, 10)) {
*cspan_at(&state, 9) = span_min(1.5 * *cspan_at(&state, 9), 1.0);
}
else if (gain < 0.3 * *cspan_at(&state, 10)) {
*cspan_at(&state, 9) = 0.6 * *cspan_at(&state, 9);
}
*cspan_at(&state, 7) = *cspan_at(&state, 7) + 1.0;
if (*cspan_at(&state, 7) > 11.5) {
result = leave_round(search);
return result;
}
correct_slopes(search, values, slopes);
enter_centre(search, values);
if (has_states(search) || (gain < 0.5 * *cspan_at(&state, 10))) {
result = enter_slopes(search);
return result;
}
*cspan_at(&state, 15) = 1.0;
result = enter_step(search, values, slopes, newton);
return result;
}
if (*cspan_at(&state, 15) > 0.5) {
result = enter_slopes(search);
return result;
}
*cspan_at(&state, 9) = 0.4 * *cspan_at(&state, 9);
if (*cspan_at(&state, 9) < least_radius(search)) {
result = leave_round(search);
return result;
}
result = enter_step(search, values, slopes, newton);
return result;
}
bool segfmu_next_limits(double duration, array_double_1d uses, array_double_2d starts, array_double_2d search, array_double_2d values, array_double_2d slopes, array_double_2d newton) {
array_double_1d state;
int64_t stage;
bool result;
state = span_row(&search, 0);
stage = (int64_t)(*cspan_at(&state, 0));
if (stage == 2) {
if (next_poll(duration, uses, search)) {
return 1;
}
result = leave_poll(search);
return result;
}
if (stage == 3) {
if (next_slope(duration, uses, search, values, slopes)) {
return 1;
}
result = enter_step(search, values, slopes, newton);
return result;
}
if (next_of_paces(duration, uses, search, values)) {
return 1;
}
if (stage == 0) {
note_start(search);
*cspan_at(&state, 2) = *cspan_at(&state, 2) + 1.0;
if ((int64_t)(*cspan_at(&state, 2)) < starts.shape[0]) {
enter_start(starts, search);
return 1;
}
*cspan_at(&state, 2) = -1.0;
result = enter_descent(search);
return result;
}
if (stage == 1) {
result = enter_round(search, values);
return result;
}
result = judge_step(search, values, slopes, newton);
return result;
}
static void write_motion_of(int64_t axis, array_double_2d positions, array_double_2d velocities, array_double_2d accelerations, array_double_1d row) {
double ahead, back, velocity, way;
int64_t k;
ahead = 0.0;
back = 0.0;
for (k = 0; k < positions.shape[0]; k += 1) {
velocity = *cspan_at(&velocities, k, axis);
*cspan_at(&row, 2) = span_max(*cspan_at(&row, 2), fabs(velocity));
way = 0.0;
if (k > 0) {
way = *cspan_at(&positions, k, axis) - *cspan_at(&positions, k - 1, axis);
}
*cspan_at(&row, 1) = span_max(*cspan_at(&row, 1), fabs(way));
if ((velocity > 0.0) || (way > 0.0)) {
ahead = 1.0;
}
if ((velocity < 0.0) || (way < 0.0)) {
back = 1.0;
}
if ((velocity != 0.0) || (*cspan_at(&accelerations, k, axis) != 0.0) || (way != 0.0)) {
*cspan_at(&row, 0) = 1.0;
}
}
if ((ahead < 0.5) && (back < 0.5)) {
ahead = *cspan_at(&row, 0);
back = *cspan_at(&row, 0);
}
*cspan_at(&row, 3) = ahead;
*cspan_at(&row, 3 + 1) = back;
if (axis == 2) {
*cspan_at(&row, 3) = back;
*cspan_at(&row, 3 + 1) = ahead;
}
}
static void write_farthest(int64_t axis, array_double_2d positions, array_double_1d resistance, array_double_1d row) {
int64_t side, k;
double place;
for (side = 0; side < 2; side += 1) {
*cspan_at(&row, 7 + side) = -1e+300;
}
for (k = 0; k < positions.shape[0]; k += 1) {
place = *cspan_at(&positions, k, axis);
if (axis == 2) {
place = (-place) - *cspan_at(&resistance, 23);
}
*cspan_at(&row, 7) = span_max(*cspan_at(&row, 7), place);
*cspan_at(&row, 7 + 1) = span_max(*cspan_at(&row, 7 + 1), -place);
}
}
static bool differs(int64_t i, array_double_1d bounds) {
bool result;
result = bound_magnitude(i, 0, bounds) != bound_magnitude(i, 1, bounds);
return result;
}
static void write_directions(int64_t axis, array_double_1d bounds, array_double_1d row) {
bool turns, forced;
int64_t i, caps;
turns = (*cspan_at(&row, 3) > 0.5) && (*cspan_at(&row, 3 + 1) > 0.5);
if (turns && differs(3 + axis, bounds)) {
*cspan_at(&row, 5) = 1.0;
}
forced = (axis != 2) && differs(0 + axis, bounds);
if (forced || differs(6 + axis, bounds)) {
*cspan_at(&row, 5 + 1) = 1.0;
}
for (i = 0; i < 2; i += 1) {
caps = 17 + i;
if (*cspan_at(&row, caps) != *cspan_at(&row, caps + 4)) {
*cspan_at(&row, 5 + i) = 1.0;
}
}
}
static bool is_braked_by_friction(int64_t axis, array_double_1d bounds, array_double_1d row) {
bool turns, forced, result;
turns = (*cspan_at(&row, 3) > 0.5) && (*cspan_at(&row, 3 + 1) > 0.5);
forced = *cspan_at(&bounds, 0 + axis) > 0.0;
result = forced && (*cspan_at(&row, 9) > 0.0) && (!turns) && (axis != 2);
return result;
}
static void write_floors(int64_t axis, array_double_2d velocities, array_double_2d accelerations, array_double_1d row) {
int64_t k, i, ahead, back;
double state;
bool directed;
for (k = 0; k < velocities.shape[0]; k += 1) {
for (i = 0; i < 2; i += 1) {
state = *cspan_at(&velocities, k, axis);
if (i == 1) {
state = *cspan_at(&accelerations, k, axis);
}
ahead = 11 + 0 + i;
back = 11 + 4 + i;
directed = *cspan_at(&row, 5 + i) > 0.5;
if ((state > 0.0) || (!directed)) {
*cspan_at(&row, ahead) = span_max(*cspan_at(&row, ahead), fabs(state));
}
if ((state < 0.0) || (!directed)) {
*cspan_at(&row, back) = span_max(*cspan_at(&row, back), fabs(state));
}
}
}
}
void segfmu_write_axes(bool narrow, array_double_2d positions, array_double_2d velocities, array_double_2d accelerations, array_double_1d bounds, array_double_2d caps, array_double_1d resistance, array_double_2d axes) {
int64_t axis, i;
array_double_1d row;
for (axis = 0; axis < axes.shape[0]; axis += 1) {
row = span_row(&axes, axis);
for (i = 0; i < 23; i += 1) {
*cspan_at(&row, i) = 0.0;
}
for (i = 0; i < 6; i += 1) {
*cspan_at(&row, 17 + i) = 1e+300;
if (*cspan_at(&caps, axis, i) > 0.0) {
*cspan_at(&row, 17 + i) = *cspan_at(&caps, axis, i);
}
}
write_motion_of(axis, positions, velocities, accelerations, row);
write_farthest(axis, positions, resistance, row);
if (*cspan_at(&row, 0) > 0.5) {
*cspan_at(&row, 9) = span_max(*cspan_at(&resistance, 10 + axis), *cspan_at(&resistance, 7 + axis));
}
write_directions(axis, bounds, row);
if ((!narrow) && is_braked_by_friction(axis, bounds, row)) {
*cspan_at(&row, 5 + 1) = 1.0;
}
write_floors(axis, velocities, accelerations, row);
if (axis == 2) {
*cspan_at(&row, 9 + 1) = hanging_mass(resistance) * *cspan_at(&resistance, 3);
}
}
}
void segfmu_narrow_bounds(array_double_1d bounds, array_double_2d caps) {
int64_t i, axis;
double least, ahead, back;
for (i = 0; i < 9; i += 1) {
least = *cspan_at(&bounds, 17 + i);
if ((least < 0.0) && (i != 0 + 2)) {
if ((*cspan_at(&bounds, i) == 0.0) || (-least < *cspan_at(&bounds, i))) {
*cspan_at(&bounds, i) = -least;
}
*cspan_at(&bounds, 17 + i) = 0.0;
}
}
for (axis = 0; axis < caps.shape[0]; axis += 1) {
for (i = 0; i < 6 - 4; i += 1) {
ahead = *cspan_at(&caps, axis, i);
back = *cspan_at(&caps, axis, 4 + i);
least = span_min(ahead, back);
if (least <= 0.0) {
least = span_max(ahead, back);
}
*cspan_at(&caps, axis, i) = least;
*cspan_at(&caps, axis, 4 + i) = least;
}
}
}
static double held_force(int64_t side, array_double_1d row) {
double weight, result;
weight = *cspan_at(&row, 9 + 1);
if (weight > 0.0) {
result = span_max(*cspan_at(&row, 9) + (2.0 * side - 1.0) * weight, 0.0);
return result;
}
if (*cspan_at(&row, 3 + side) < 0.5) {
result = -*cspan_at(&row, 9);
return result;
}
result = *cspan_at(&row, 9);
return result;
}
void segfmu_write_kinds(array_double_2d axes, array_double_1d kinds) {
int64_t axis, i, same;
bool own;
for (axis = 0; axis < axes.shape[0]; axis += 1) {
for (i = 0; i < 6; i += 1) {
*cspan_at(&kinds, axis * 6 + i) = 0;
own = *cspan_at(&axes, axis, 0) > 0.5;
if (i >= 4) {
same = i - 4;
own = own && (*cspan_at(&axes, axis, 5 + same) > 0.5);
}
if (own) {
*cspan_at(&kinds, axis * 6 + i) = 1;
}
}
}
}
void segfmu_write_limits(array_double_1d unknowns, array_double_2d axes, array_double_2d table) {
int64_t axis, i, own, same;
double value;
for (axis = 0; axis < axes.shape[0]; axis += 1) {
for (i = 0; i < 6; i += 1) {
own = i;
if (i >= 4) {
same = i - 4;
if (*cspan_at(&axes, axis, 5 + same) < 0.5) {
own = same;
}
}
value = exp(span_min(span_max(*cspan_at(&unknowns, axis * 6 + own), -300.0), 300.0));
value = span_max(value, *cspan_at(&axes, axis, 11 + own));
*cspan_at(&table, axis, i) = span_min(value, *cspan_at(&axes, axis, 17 + own));
}
}
}
void segfmu_write_shares(array_double_2d peaks, array_double_1d bounds, array_double_2d axes, array_double_1d uses) {
int64_t i, side;
double bound, used, held;
bool full;
for (i = 0; i < 17; i += 1) {
for (side = 0; side < 2; side += 1) {
bound = bound_magnitude(i, side, bounds);
used = *cspan_at(&peaks, side, i) - bound_origin(i, side, bounds);
held = 0.0;
if (i < 3) {
held = held_force(side, span_row(&axes, i));
}
if (is_place(i)) {
held = *cspan_at(&axes, i - 12, 7 + side);
held = held - bound_origin(i, side, bounds);
}
full = bound <= held * (1.0 + 1e-06);
if (full) {
held = 0.0;
}
*cspan_at(&uses, side * 17 + i) = 0.0;
if (bound > 0.0) {
*cspan_at(&uses, side * 17 + i) = span_max(used - held, 0.0) / (bound - held);
}
if (is_place(i) && full && (used <= bound * (1.0 + 1e-09))) {
*cspan_at(&uses, side * 17 + i) = 0.0;
}
}
}
}
static int64_t check_pace_of(int64_t axis, array_double_1d bounds, array_double_2d axes, array_double_1d fault) {
int64_t side, i;
double bound;
*cspan_at(&fault, 0) = axis;
*cspan_at(&fault, 1) = axis;
for (side = 0; side < 2; side += 1) {
for (i = 0; i < 2; i += 1) {
bound = bound_magnitude(3 + 3 * i + axis, side, bounds);
if ((*cspan_at(&axes, axis, 0) > 0.5) && (0.0 < bound) && (bound < 1e-05)) {
*cspan_at(&fault, 2) = side;
*cspan_at(&fault, 3) = bound;
return 2 + i;
}
}
}
return 0;
}
static double least_of(double limit, double bound) {
if (bound > 0.0) {
return span_min(limit, bound);
}
return limit;
}
static double rigid_mass(int64_t axis, array_double_1d resistance) {
double mass;
mass = hanging_mass(resistance);
if (axis < 2) {
mass = mass + *cspan_at(&resistance, 1);
}
if (axis == 0) {
mass = mass + *cspan_at(&resistance, 0);
}
return mass;
}
static int64_t rigid_limits(double* result_0, double* result_1, int64_t axis, int64_t way, array_double_1d bounds, array_double_1d resistance, array_double_1d row) {
double gravity, velocity, strongest, acceleration, carried, held, mass, force, strong, steepest, sway, power, distance, time, fastest;
int64_t side, cap;
bool lowered;
gravity = *cspan_at(&resistance, 3);
side = way;
if (axis == 2) {
side = 1 - way;
}
cap = 17 + way * 4;
velocity = least_of(*cspan_at(&row, cap), bound_magnitude(3 + axis, side, bounds));
strongest = bound_magnitude(6 + axis, side, bounds);
acceleration = least_of(*cspan_at(&row, cap + 1), strongest);
carried = *cspan_at(&row, 9 + 1);
held = *cspan_at(&row, 9) + carried;
mass = rigid_mass(axis, resistance);
force = bound_magnitude(0 + axis, side, bounds);
if (axis == 2) {
force = bound_magnitude(0 + axis, 1, bounds);
}
lowered = (axis == 2) && (side == 0) && (*cspan_at(&row, 5 + 1) > 0.5);
if (lowered) {
acceleration = span_min(acceleration, 0.9 * gravity);
}
else if (force > 0.0) {
if (axis != 2) {
held = held_force(side, row);
}
strong = span_min((force - held) / mass, 1e+299);
acceleration = span_min(acceleration, span_max(strong, 0.001 * gravity));
}
steepest = tan(1.0);
if (axis == 2) {
steepest = 0.9;
}
else if (*cspan_at(&bounds, 15 + axis) > 0.0) {
sway = tan(span_min(*cspan_at(&bounds, 15 + axis), 1.0));
acceleration = span_min(acceleration, gravity * sway);
}
power = *cspan_at(&bounds, 9 + axis);
distance = *cspan_at(&row, 1);
if ((power > 0.0) && (acceleration >= 1e+300)) {
time = exp(log(span_max(mass * distance * distance / power, 1e-30)) / 3.0);
acceleration = span_min(velocity / time, distance / (time * time));
}
if (acceleration >= 1e+300) {
(*result_0) = velocity;
(*result_1) = acceleration;
return 0;
}
acceleration = span_min(acceleration, gravity * steepest);
if (distance <= 0.0) {
fastest = *cspan_at(&row, 2);
distance = span_max(fastest * fastest / acceleration, 1e-09);
}
if (power > 0.0) {
velocity = span_min(velocity, power / (*cspan_at(&row, 9) + carried + mass * acceleration));
}
(*result_0) = span_min(velocity, 2.0 * sqrt(acceleration * distance));
(*result_1) = acceleration;
return 0;
}
static double of_the_way(double ahead, double back, int64_t axis, array_double_1d row) {
double up, down;
up = *cspan_at(&row, 3);
down = *cspan_at(&row, 3 + 1);
if (axis == 2) {
up = *cspan_at(&row, 3 + 1);
down = *cspan_at(&row, 3);
}
if (down < 0.5) {
return ahead;
}
if (up < 0.5) {
return back;
}
return span_min(ahead, back);
}
static int64_t write_axis_starts(int64_t axis, double swing, array_double_1d bounds, array_double_1d resistance, array_double_2d axes, array_double_2d starts) {
array_double_1d row;
double ahead, rise, back, fall, least, time, multiple, ramp, faster, calmer, most;
int64_t k, first;
row = span_row(&axes, axis);
rigid_limits(&ahead, &rise, axis, 0, bounds, resistance, row);
rigid_limits(&back, &fall, axis, 1, bounds, resistance, row);
if ((rise >= 1e+300) || (fall >= 1e+300)) {
return 1;
}
if (*cspan_at(&row, 5) < 0.5) {
ahead = of_the_way(ahead, back, axis, row);
back = ahead;
}
if (*cspan_at(&row, 5 + 1) < 0.5) {
rise = of_the_way(rise, fall, axis, row);
fall = rise;
}
least = span_min(rise, fall);
time = span_min(ahead, back) / least;
if (*cspan_at(&row, 1) > 0.0) {
time = span_min(time, sqrt(*cspan_at(&row, 1) / least));
}
for (k = 0; k < starts.shape[0]; k += 1) {
multiple = 0.5 * exp(span_floor_mod(k, 4) * 0.46209812);
ramp = multiple * span_min(swing, 2.0 * time);
if (axis == 2) {
ramp = multiple * 0.3 * time;
}
faster = 0.0;
if (span_floor_mod(span_floor_div(k, 4), 2) == 1) {
faster = log(1.5);
}
calmer = 0.0;
if (span_floor_div(k, 8) == 1) {
calmer = log(0.75);
}
first = axis * 6;
most = span_max(rise, fall);
*cspan_at(&starts, k, first + 0) = log(ahead) + faster;
*cspan_at(&starts, k, first + 1) = log(rise) + calmer;
*cspan_at(&starts, k, first + 2) = log(1.9 * most / ramp);
*cspan_at(&starts, k, first + 3) = log(5.8 * most / (ramp * ramp));
*cspan_at(&starts, k, first + 4) = log(back) + faster;
*cspan_at(&starts, k, first + 5) = log(fall) + calmer;
}
return 0;
}
int64_t segfmu_write_starts(double rope, array_double_1d bounds, array_double_1d resistance, array_double_2d axes, array_double_2d starts, array_double_1d fault) {
double swing;
int64_t axis, k, i, status;
swing = 3.141592653589793 * sqrt(span_max(rope, 0.001) / *cspan_at(&resistance, 3));
for (axis = 0; axis < axes.shape[0]; axis += 1) {
status = check_pace_of(axis, bounds, axes, fault);
if (status != 0) {
return status;
}
for (k = 0; k < starts.shape[0]; k += 1) {
for (i = 0; i < 6; i += 1) {
*cspan_at(&starts, k, axis * 6 + i) = 0.0;
}
}
if (*cspan_at(&axes, axis, 0) > 0.5) {
status = write_axis_starts(axis, swing, bounds, resistance, axes, starts);
if (status != 0) {
return status;
}
}
}
return 0;
}
static double mean_velocity(int64_t point, int64_t axis, array_double_2d positions, array_double_2d axes, array_double_1d start) {
double time, way, velocity, acceleration, result;
int64_t i;
time = 0.0;
for (i = 0; i < axes.shape[0]; i += 1) {
if (*cspan_at(&axes, i, 0) > 0.5) {
way = fabs(*cspan_at(&positions, point, i) - *cspan_at(&positions, point - 1, i));
velocity = exp(*cspan_at(&start, i * 6 + 0));
acceleration = exp(*cspan_at(&start, i * 6 + 1));
time = span_max(time, span_max(way / velocity, 2.0 * sqrt(way / acceleration)));
}
}
result = (*cspan_at(&positions, point, axis) - *cspan_at(&positions, point - 1, axis)) / span_max(time, 1e-09);
return result;
}
void segfmu_write_passing(array_double_2d positions, array_double_1d kinds, array_double_2d axes, array_double_1d heading, array_double_1d start) {
int64_t point, axis, i;
double before, after, share;
for (point = 1; point < positions.shape[0] - 1; point += 1) {
for (axis = 0; axis < axes.shape[0]; axis += 1) {
i = state_of(point, 0, axis, heading);
if (*cspan_at(&kinds, i) > 1.5) {
before = mean_velocity(point, axis, positions, axes, start);
after = mean_velocity(point + 1, axis, positions, axes, start);
share = 0.0;
if (before * after > 0.0) {
share = span_min(fabs(before), fabs(after)) / exp(*cspan_at(&start, axis * 6));
}
if (before < 0.0) {
share = -share;
}
*cspan_at(&start, i) = share * heading_sign(0, axis, heading);
}
}
}
}
int64_t segfmu_check_range(double value, double least, double most, array_double_1d fault) {
*cspan_at(&fault, 0) = value;
*cspan_at(&fault, 1) = least;
*cspan_at(&fault, 2) = most;
if ((value >= least) && (value <= most)) {
return 0;
}
if (most > 1.7976931348623157e+308) {
return 1;
}
if (least < -1.7976931348623157e+308) {
return 3;
}
return 2;
}
static double root_share(double newest, double other, double before, double e_newest, double e_other, double e_before) {
double place, height, share, rest, least;
if (e_newest * e_other * e_before == 0.0) {
return 0.5;
}
if ((before == other) && (e_newest * e_other < 0.0)) {
return span_min(span_max(e_newest / (e_newest - e_other), 0.1), 0.9);
}
if ((e_before == e_newest) || (e_before == e_other) || (before == other)) {
return 0.5;
}
place = (newest - other) / (before - other);
height = (e_newest - e_other) / (e_before - e_other);
if ((height * height >= place) || ((1.0 - height) * (1.0 - height) >= 1.0 - place)) {
return 0.5;
}
share = e_newest / (e_other - e_newest) * e_before / (e_other - e_before);
rest = (before - newest) / (other - newest);
share = share + rest * e_newest / (e_before - e_newest) * e_other / (e_before - e_other);
least = 2e-16 * span_max(fabs(newest), fabs(other)) / fabs(other - newest);
return span_max(span_min(share, 1.0 - least), least);
}
static double next_point(double newest, double other, double before, double e_newest, double e_other, double e_before) {
double share;
share = root_share(newest, other, before, e_newest, e_other, e_before);
return newest + share * (other - newest);
}
static int64_t next_bracket(double* result_0_0001, double* result_1_0001, double* result_2_0001, double* result_3_0001, double* result_4_0001, double* result_5_0001, bool crossed, double point, double error, double newest, double other, double e_newest, double e_other) {
if (crossed) {
(*result_0_0001) = point;
(*result_1_0001) = newest;
(*result_2_0001) = other;
(*result_3_0001) = error;
(*result_4_0001) = e_newest;
(*result_5_0001) = e_other;
return 0;
}
(*result_0_0001) = point;
(*result_1_0001) = other;
(*result_2_0001) = newest;
(*result_3_0001) = error;
(*result_4_0001) = e_other;
(*result_5_0001) = e_newest;
return 0;
}
double segfmu_begin_time(double given, double start) {
if (given <= -INT64_C(1000000000)) {
return start;
}
return given;
}
static double least_scale(void) {
return 0.001;
}
static bool has_tripped(array_double_1d command) {
int64_t drive;
for (drive = 0; drive < 3; drive += 1) {
if (*cspan_at(&command, 17 + drive) > 0.5) {
return 1;
}
}
return 0;
}
static int64_t wanted_mode(array_double_1d command) {
int64_t result;
if (has_tripped(command)) {
return 5;
}
result = (int64_t)(*cspan_at(&command, 2));
return result;
}
static double push_of(double velocity) {
if (velocity > 0.0) {
return 1.0;
}
if (velocity < 0.0) {
return -1.0;
}
return 0.0;
}
static double standstill(int64_t slot, int64_t axis, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
int64_t last;
double result;
last = *cspan_at(&offsets, slot * 4 + axis + 1) - 1;
result = evaluate_piece(span_matrix(&coefficients, slot), last, coefficients.shape[2], *cspan_at(&timing, slot, last, 1), 0);
return result;
}
static double stop_towards(int64_t side, int64_t axis, array_double_2d known) {
double result;
if (axis == 2) {
result = end_stop(12 + axis, 1 - side, span_row(&known, 2));
return result;
}
result = end_stop(12 + axis, side, span_row(&known, 2));
return result;
}
static double end_rounding_of(double end) {
return 1e-10 * fabs(end);
}
static double low_end(int64_t axis, array_double_2d known) {
double end, longest;
end = *cspan_at(&known, 4, 1 + axis);
longest = *cspan_at(&known, 1, 2);
if ((axis == 2) && (longest > 0.0)) {
end = span_max(end, -longest);
}
end = span_max(end, -stop_towards(1, axis, known));
return end + end_rounding_of(end);
}
static double high_end(int64_t axis, array_double_2d known) {
double end;
end = *cspan_at(&known, 4, 4 + axis);
if (axis == 2) {
end = span_min(end, -*cspan_at(&known, 1, 1));
}
end = span_min(end, stop_towards(0, axis, known));
return end - end_rounding_of(end);
}
static void write_push(double scale, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
array_double_1d aim, command;
int64_t axis, i;
double push, distance, wished;
aim = span_row(&operation, 1);
command = span_row(&operation, 0);
if (*cspan_at(&operation, 4, 5) != 4) {
*cspan_at(&aim, 0) = 0.0;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&aim, 1 + axis) = 0.0;
*cspan_at(&operation, 5, axis) = push_of(*cspan_at(&command, 3 + axis));
}
}
for (axis = 0; axis < 3; axis += 1) {
push = push_of(*cspan_at(&command, 3 + axis));
if (push == *cspan_at(&operation, 5, axis)) {
continue;
}
*cspan_at(&operation, 5, axis) = push;
distance = *cspan_at(&command, 11 + axis);
if ((fabs(push) > 0.0) && (0.0 < distance) && (distance < 1e+300)) {
if (*cspan_at(&aim, 0) < 0.5) {
*cspan_at(&aim, 0) = 1.0;
for (i = 0; i < 3; i += 1) {
*cspan_at(&aim, 1 + i) = standstill(0, i, timing, coefficients, offsets);
}
}
wished = *cspan_at(&aim, 1 + axis) + push * distance;
*cspan_at(&aim, 1 + axis) = span_min(span_max(wished, low_end(axis, known)), high_end(axis, known));
}
}
*cspan_at(&aim, 4) = scale * *cspan_at(&aim, 0);
}
static double limited_velocity(double velocity, double scale, double limit, double lower) {
double least;
least = limit;
if (lower > 0.0) {
least = lower;
}
if (velocity > 0.0) {
return span_min(velocity, scale * limit);
}
if (velocity < 0.0) {
return span_max(velocity, (-scale) * least);
}
return 0.0;
}
static void write_target(double scale, array_double_1d aim, array_double_1d command) {
int64_t axis;
if ((!(*cspan_at(&command, 9) > 0.5)) || (!(scale > 0.0))) {
return;
}
for (axis = 0; axis < 3; axis += 1) {
if (!(fabs(*cspan_at(&command, 6 + axis)) < 1e+300)) {
return;
}
}
*cspan_at(&aim, 0) = 1.0;
*cspan_at(&aim, 4) = scale;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&aim, 1 + axis) = *cspan_at(&command, 6 + axis);
}
}
static void write_wish(int64_t mode, double scale, array_double_1d aim, array_double_1d command, array_double_2d limits, array_double_2d known) {
int64_t axis;
double lower;
*cspan_at(&aim, 0) = 0.0;
*cspan_at(&aim, 4) = 0.0;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&aim, 1 + axis) = 0.0;
}
if (mode == 2) {
for (axis = 0; axis < 3; axis += 1) {
lower = *cspan_at(&known, 6 + axis, 0);
*cspan_at(&aim, 1 + axis) = limited_velocity(*cspan_at(&command, 3 + axis), scale, *cspan_at(&limits, axis, 0), lower);
}
}
else if (mode == 1) {
write_target(scale, aim, command);
}
}
static void write_aim(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
array_double_1d command;
int64_t mode, axis;
double scale;
command = span_row(&operation, 0);
mode = wanted_mode(command);
scale = *cspan_at(&command, 10);
if (!(scale >= least_scale())) {
scale = 0.0;
}
scale = span_min(scale, 1.0);
if ((mode == 4) && (scale > 0.0)) {
write_push(scale, operation, known, timing, coefficients, offsets);
}
else {
write_wish(mode, scale, span_row(&operation, 1), command, limits, known);
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&operation, 5, axis) = 0.0;
}
}
*cspan_at(&operation, 4, 5) = mode;
}
static bool is_aim(int64_t row, array_double_2d operation) {
int64_t i;
for (i = 0; i < 5; i += 1) {
if (*cspan_at(&operation, 1, i) != *cspan_at(&operation, row, i)) {
return 0;
}
}
return 1;
}
static bool is_slower(int64_t attempt) {
if ((attempt == 1) || (attempt == 2)) {
return 1;
}
return (attempt == 7) || (attempt == 8);
}
static double ease_of(int64_t attempt, int64_t place, array_double_2d operation) {
double result;
if (is_slower(attempt)) {
result = *cspan_at(&operation, 4, place);
return result;
}
return 1.0;
}
static void note_ease(int64_t attempt, double pace, double steepness, double speed, array_double_2d operation) {
double share;
array_double_1d progress;
share = 0.7;
if (span_min(pace, speed) < 1.0) {
share = 0.98 * pace;
}
if (is_slower(attempt) && (steepness == 1.0)) {
share = span_min(share, 0.7);
}
if (speed < 1.0) {
speed = 0.98 * speed;
}
progress = span_row(&operation, 4);
*cspan_at(&progress, 6) = share * ease_of(attempt, 6, operation);
*cspan_at(&progress, 7) = steepness * ease_of(attempt, 7, operation);
*cspan_at(&progress, 8) = speed * ease_of(attempt, 8, operation);
}
static void stop_as_before(array_double_2d operation) {
array_double_1d progress;
double pace, steepness;
progress = span_row(&operation, 4);
pace = *cspan_at(&progress, 9);
steepness = *cspan_at(&progress, 10);
if ((pace >= 1.0) || (pace <= *cspan_at(&progress, 6))) {
return;
}
*cspan_at(&progress, 6) = pace;
*cspan_at(&progress, 7) = steepness;
}
static double share_of(int64_t attempt, int64_t axis, array_double_2d operation) {
double result;
if (attempt >= 6) {
return 0.0;
}
if (attempt == 3) {
return 0.25;
}
if ((attempt == 4) && (axis == 2)) {
return 0.0;
}
if ((attempt == 5) && (axis < 2)) {
return 0.0;
}
result = ease_of(attempt, 8, operation);
return result;
}
static bool is_worth(int64_t attempt, int64_t failed, array_double_1d aim) {
bool blocked;
double horizontal, vertical;
blocked = (failed == 4) || (failed == 5);
if (is_slower(attempt) && blocked) {
return 0;
}
if (attempt >= 6) {
return 1;
}
if (*cspan_at(&aim, 0) > 0.5) {
return attempt <= 2;
}
horizontal = fabs(*cspan_at(&aim, 1)) + fabs(*cspan_at(&aim, 1 + 1));
vertical = fabs(*cspan_at(&aim, 1 + 2));
if ((attempt == 4) || (attempt == 5)) {
return (horizontal > 0.0) && (vertical > 0.0);
}
return horizontal + vertical > 0.0;
}
static void set_lower_of(int64_t place, array_double_2d operation, array_double_3d limits, array_double_2d known) {
int64_t axis, i;
double share;
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < 2; i += 1) {
share = *cspan_at(&limits, place, axis, i) / *cspan_at(&limits, 0, axis, i);
*cspan_at(&operation, 23 + axis, i) = share * *cspan_at(&known, 6 + axis, i);
}
}
}
static void set_attempt(int64_t attempt, array_double_2d operation, array_double_3d limits, array_double_2d known) {
double pace, steepness, scale, power, given;
int64_t axis, i;
pace = ease_of(attempt, 6, operation);
steepness = ease_of(attempt, 7, operation);
scale = 1.0;
if ((*cspan_at(&operation, 1, 0) > 0.5) && (attempt < 6)) {
scale = *cspan_at(&operation, 1, 4) * ease_of(attempt, 8, operation);
}
for (axis = 0; axis < 3; axis += 1) {
power = pace;
*cspan_at(&limits, 1, axis, 0) = scale * *cspan_at(&limits, 0, axis, 0);
for (i = 1; i < limits.shape[2]; i += 1) {
power = power * pace;
if (i > 1) {
power = power * steepness;
}
given = *cspan_at(&limits, 0, axis, i);
if ((i == 3) && (given == 0.0) && is_slower(attempt)) {
given = *cspan_at(&limits, 0, axis, 2) * *cspan_at(&limits, 0, axis, 2) / *cspan_at(&limits, 0, axis, 1);
}
*cspan_at(&limits, 1, axis, i) = power * given;
}
}
set_lower_of(1, operation, limits, known);
}
static int64_t most_newton(void) {
return 60;
}
static double control_bound(int64_t demand, double sense, double share, double fallback, array_double_2d known) {
int64_t side;
double bound;
side = 0;
if (sense < 0.0) {
side = 1;
}
bound = share * bound_magnitude(demand, side, span_row(&known, 2));
if (bound == 0.0) {
bound = fallback;
}
return bound;
}
static double most_change(int64_t axis, double sense, double share, double interval, array_double_2d known) {
double result;
result = interval * control_bound(6 + axis, sense, share, 0.0, known);
return result;
}
static double most_speed(int64_t axis, double sense, double share, double interval, array_double_2d known, array_double_2d work) {
double most, result;
most = most_change(axis, 1.0, share, interval, known);
most = most + most_change(axis, -1.0, share, interval, known);
most = fabs(*cspan_at(&work, 140 + axis, 1)) + 102 * most;
result = control_bound(3 + axis, sense, share, most, known);
return result;
}
static void decline_line(int64_t axis, array_double_2d work) {
array_double_1d points;
int64_t begin, last, i;
points = span_row(&work, 140 + axis);
begin = 3 - 1;
last = 99;
for (i = 3; i < 102; i += 1) {
*cspan_at(&points, i) = *cspan_at(&points, begin) * span_max_int(last - i, 0) / (last - begin);
}
}
static bool is_inside_bounds(int64_t axis, double share, double interval, array_double_2d known, array_double_2d work) {
array_double_1d points;
double fastest, slowest, rise, fall;
int64_t i;
points = span_row(&work, 140 + axis);
fastest = most_speed(axis, 1.0, share, interval, known, work);
slowest = most_speed(axis, -1.0, share, interval, known, work);
rise = most_change(axis, 1.0, share, interval, known);
fall = most_change(axis, -1.0, share, interval, known);
for (i = 3; i < 99 + 1; i += 1) {
if (!((-slowest < *cspan_at(&points, i)) && (*cspan_at(&points, i) < fastest))) {
return 0;
}
if (!((-fall < *cspan_at(&points, i) - *cspan_at(&points, i - 1)) && (*cspan_at(&points, i) - *cspan_at(&points, i - 1) < rise))) {
return 0;
}
}
return 1;
}
static void write_conditions(double interval, array_double_2d work) {
int64_t i, j;
array_double_1d moment;
for (i = 3; i < 99; i += 1) {
for (j = 0; j < 2; j += 1) {
moment = span_row(&work, 143 + j);
*cspan_at(&work, 145 + j, i) = *cspan_at(&moment, i - 1) - *cspan_at(&moment, i);
}
*cspan_at(&work, 145 + 2, i) = interval;
}
}
static double swing_left(int64_t j, double aim, int64_t axis, array_double_2d work) {
int64_t i;
double change, left;
left = aim;
for (i = 0; i < 102 - 1; i += 1) {
change = *cspan_at(&work, 140 + axis, i + 1) - *cspan_at(&work, 140 + axis, i);
left = left - *cspan_at(&work, 143 + j, i) * change;
}
return left;
}
static double place_left(double aim, int64_t axis, double interval, array_double_2d work) {
array_double_1d points;
int64_t i;
double left;
points = span_row(&work, 140 + axis);
left = aim - interval * (*cspan_at(&points, 0) + 12.0 * *cspan_at(&points, 1) + 23.0 * *cspan_at(&points, 2)) / 24.0;
for (i = 3; i < 99; i += 1) {
left = left - interval * *cspan_at(&points, i);
}
return left;
}
static void write_barrier(int64_t axis, double share, double interval, array_double_2d known, array_double_2d work) {
array_double_1d points;
double fastest, slowest, rise, fall, slope, curve, over, under, slope_behind, curve_behind;
int64_t i;
points = span_row(&work, 140 + axis);
fastest = most_speed(axis, 1.0, share, interval, known, work);
slowest = most_speed(axis, -1.0, share, interval, known, work);
rise = most_change(axis, 1.0, share, interval, known);
fall = most_change(axis, -1.0, share, interval, known);
slope = 0.0;
curve = 0.0;
for (i = 3 - 1; i < 99; i += 1) {
over = 1.0 / (rise - *cspan_at(&points, i + 1) + *cspan_at(&points, i));
under = 1.0 / (fall + *cspan_at(&points, i + 1) - *cspan_at(&points, i));
slope_behind = over - under;
curve_behind = over * over + under * under;
over = 1.0 / (fastest - *cspan_at(&points, i));
under = 1.0 / (slowest + *cspan_at(&points, i));
*cspan_at(&work, 151, i) = slope_behind - slope - over + under;
*cspan_at(&work, 148, i) = curve + curve_behind + over * over + under * under;
*cspan_at(&work, 149, i) = -curve_behind;
slope = slope_behind;
curve = curve_behind;
}
}
static void solve_barrier(int64_t first, int64_t last, array_double_2d work) {
array_double_2d change;
int64_t i, j, k;
double ratio, coupling;
change = span_rows(&work, 151, 155);
for (i = 3; i < 99; i += 1) {
for (j = first; j < last; j += 1) {
*cspan_at(&change, 1 + j, i) = *cspan_at(&work, 145 + j, i);
}
}
for (i = 3 + 1; i < 99; i += 1) {
ratio = *cspan_at(&work, 149, i - 1) / *cspan_at(&work, 148, i - 1);
*cspan_at(&work, 148, i) = *cspan_at(&work, 148, i) - ratio * *cspan_at(&work, 149, i - 1);
*cspan_at(&change, 0, i) = *cspan_at(&change, 0, i) - ratio * *cspan_at(&change, 0, i - 1);
for (j = first; j < last; j += 1) {
*cspan_at(&change, 1 + j, i) = *cspan_at(&change, 1 + j, i) - ratio * *cspan_at(&change, 1 + j, i - 1);
}
}
for (k = 3; k < 99; k += 1) {
i = 99 + 3 - 1 - k;
coupling = *cspan_at(&work, 149, i);
if (k == 3) {
coupling = 0.0;
}
*cspan_at(&change, 0, i) = (*cspan_at(&change, 0, i) - coupling * *cspan_at(&change, 0, i + 1)) / *cspan_at(&work, 148, i);
for (j = first; j < last; j += 1) {
*cspan_at(&change, 1 + j, i) = (*cspan_at(&change, 1 + j, i) - coupling * *cspan_at(&change, 1 + j, i + 1)) / *cspan_at(&work, 148, i);
}
}
}
static double join_changes(int64_t first, int64_t last, array_double_2d work) {
array_double_2d change, schur, lack;
int64_t j, k, i;
array_double_1d slopes;
double largest;
change = span_rows(&work, 151, 155);
schur = span_rows(&work, 155, 158);
lack = span_rows(&work, 158, 161);
for (j = first; j < last; j += 1) {
slopes = span_row(&work, 145 + j);
for (k = first; k < last; k += 1) {
*cspan_at(&schur, j - first, k - first) = 0.0;
}
for (i = 3; i < 99; i += 1) {
*cspan_at(&lack, j - first, 0) = *cspan_at(&lack, j - first, 0) - *cspan_at(&slopes, i) * *cspan_at(&change, 0, i);
for (k = first; k < last; k += 1) {
*cspan_at(&schur, j - first, k - first) = *cspan_at(&schur, j - first, k - first) + *cspan_at(&slopes, i) * *cspan_at(&change, 1 + k, i);
}
}
}
matrix_solve(last - first, 1, schur, lack);
largest = 0.0;
for (i = 3; i < 99; i += 1) {
for (j = first; j < last; j += 1) {
*cspan_at(&change, 0, i) = *cspan_at(&change, 0, i) + *cspan_at(&lack, j - first, 0) * *cspan_at(&change, 1 + j, i);
}
if (!(fabs(*cspan_at(&change, 0, i)) < 1e+300)) {
return 1e+300;
}
largest = span_max(largest, fabs(*cspan_at(&change, 0, i)));
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&change, 0, i) = 0.0;
*cspan_at(&change, 0, 99 + i) = 0.0;
}
return largest;
}
static double way_to_bounds(int64_t axis, double share, double interval, array_double_2d known, array_double_2d work) {
array_double_1d points, change;
double fastest, slowest, rise, fall, inverse, moved, step;
int64_t i;
points = span_row(&work, 140 + axis);
change = span_row(&work, 151);
fastest = most_speed(axis, 1.0, share, interval, known, work);
slowest = most_speed(axis, -1.0, share, interval, known, work);
rise = most_change(axis, 1.0, share, interval, known);
fall = most_change(axis, -1.0, share, interval, known);
inverse = 0.0;
for (i = 3 - 1; i < 99; i += 1) {
moved = *cspan_at(&change, i + 1) - *cspan_at(&change, i);
step = *cspan_at(&points, i + 1) - *cspan_at(&points, i);
inverse = span_max(inverse, moved / (rise - step));
inverse = span_max(inverse, (-moved) / (fall + step));
inverse = span_max(inverse, *cspan_at(&change, i) / (fastest - *cspan_at(&points, i)));
inverse = span_max(inverse, (-*cspan_at(&change, i)) / (slowest + *cspan_at(&points, i)));
}
if (inverse > 0.0) {
return 1.0 / inverse;
}
return 1e+300;
}
static bool find_centre(int64_t axis, double share, double interval, int64_t first, int64_t last, array_double_1d aims, array_double_2d known, array_double_2d work) {
int64_t Dummy_0000, j, i;
double largest, step;
bool met;
decline_line(axis, work);
if (!is_inside_bounds(axis, share, interval, known, work)) {
return 0;
}
write_conditions(interval, work);
met = 0;
for (Dummy_0000 = 0; Dummy_0000 < most_newton(); Dummy_0000 += 1) {
write_barrier(axis, share, interval, known, work);
solve_barrier(first, last, work);
for (j = first; j < last; j += 1) {
if (j < 2) {
*cspan_at(&work, 158 + j - first, 0) = swing_left(j, *cspan_at(&aims, j), axis, work);
}
else {
*cspan_at(&work, 158 + j - first, 0) = place_left(*cspan_at(&aims, j), axis, interval, work);
}
}
largest = join_changes(first, last, work);
step = span_min(0.9 * way_to_bounds(axis, share, interval, known, work), 1.0);
if ((!(step > 0.0001)) || (!(largest < 1e+300))) {
return 0;
}
for (i = 3; i < 99; i += 1) {
*cspan_at(&work, 140 + axis, i) = *cspan_at(&work, 140 + axis, i) + step * *cspan_at(&work, 151, i);
}
if (step == 1.0) {
met = 1;
if (largest <= 1e-09 * most_change(axis, 1.0, share, interval, known)) {
return 1;
}
}
}
return met;
}
static double inner_rise(double rise, int64_t level, array_double_1d axis) {
double result;
result = span_min(span_max(*cspan_at(&axis, 21 + level), *cspan_at(&axis, 26 + level) * rise), 0.5 * rise);
return result;
}
static double shifted_root(double value, int64_t power, double shift) {
int64_t i, j;
double x_power, error, step, x;
if (power == 0) {
return value + shift;
}
if (power == 1) {
return 0.5 * (shift + sqrt(shift * shift + 4.0 * value));
}
x = shift + pow(value, (1.0 / (power + 1)));
for (i = 0; i < 100; i += 1) {
x_power = 1.0;
for (j = 0; j < power - 1; j += 1) {
x_power = x_power * x;
}
error = x_power * x * (x - shift) - value;
step = error / (x_power * (power * (x - shift) + x));
if (step <= 2e-16 * x) {
break;
}
x = x - step;
}
return x;
}
static int64_t plateau_duration(double* result_0_0001, double* result_1_0001, double change, int64_t first, array_double_1d axis) {
int64_t boxes, level, power, j;
double factor, doubled, limit, least, share, x_power, value, x, rest;
boxes = (int64_t)(*cspan_at(&axis, 0)) - 1;
factor = 1.0;
doubled = 1.0;
for (level = first; level < boxes; level += 1) {
limit = *cspan_at(&axis, 4 + level);
least = *cspan_at(&axis, 21 + level);
share = *cspan_at(&axis, 26 + level);
power = level - first;
x_power = 1.0;
for (j = 0; j < power; j += 1) {
x_power = x_power * 2.0 * least;
}
if ((limit > 0.0) && (change >= factor * x_power * limit * least)) {
value = change / (factor * limit);
x = 0.0;
if (share > 0.0) {
x = value / (1.0 - share);
if (power == 1) {
x = sqrt(x);
}
else if (power > 1) {
x = pow(x, (1.0 / (power + 1)));
}
}
if ((share == 0.0) || (share * x < least)) {
if ((least > 0.0) || (power == 0)) {
x = shifted_root(value, power, least);
}
else if (power == 1) {
x = sqrt(value);
}
else {
x = pow(value, (1.0 / (power + 1)));
}
rest = x - least;
(*result_0_0001) = doubled * x;
(*result_1_0001) = doubled * x * rest / (change * (power * rest + x));
return 0;
}
(*result_0_0001) = doubled * x;
(*result_1_0001) = doubled * x / ((power + 1) * change);
return 0;
}
factor = factor * doubled;
doubled = 2.0 * doubled;
}
(*result_0_0001) = 0.0;
(*result_1_0001) = 0.0;
return 0;
}
static int64_t plateau_change(double* result_0, double* result_1_0001, double duration, int64_t first, array_double_1d axis) {
int64_t boxes, level, power, j;
double x, factor, doubled, least, share, steepest, change;
boxes = (int64_t)(*cspan_at(&axis, 0)) - 1;
x = duration;
factor = 1.0;
doubled = 1.0;
for (level = first; level < boxes; level += 1) {
least = *cspan_at(&axis, 21 + level);
if (x >= 2.0 * least) {
share = *cspan_at(&axis, 26 + level);
power = level - first;
steepest = factor * *cspan_at(&axis, 4 + level);
for (j = 0; j < power; j += 1) {
steepest = steepest * x;
}
if (share * x >= least) {
change = steepest * (1.0 - share) * x;
(*result_0) = change;
(*result_1_0001) = (power + 1) * change / duration;
return 0;
}
change = steepest * (x - least);
(*result_0) = change;
(*result_1_0001) = (power * change + steepest * x) / duration;
return 0;
}
x = 0.5 * x;
factor = factor * doubled;
doubled = 2.0 * doubled;
}
(*result_0) = 0.0;
(*result_1_0001) = 0.0;
return 0;
}
static int64_t slowest_root(double* result_0, double* result_1_0001, double change, array_double_1d axis) {
double slowest, root;
int64_t exponent, e;
slowest = *cspan_at(&axis, 31) * change;
exponent = 1;
if (*cspan_at(&axis, 31 + 1) > 0.0) {
root = sqrt(*cspan_at(&axis, 31 + 1) * change);
if (root > slowest) {
slowest = root;
exponent = 2;
}
}
for (e = 3; e < 6; e += 1) {
if (*cspan_at(&axis, 31 + e - 1) > 0.0) {
root = pow((*cspan_at(&axis, 31 + e - 1) * change), (1.0 / e));
if (root > slowest) {
slowest = root;
exponent = e;
}
}
}
(*result_0) = slowest;
(*result_1_0001) = slowest / (exponent * change);
return 0;
}
static int64_t fastest_power(double* result_0, double* result_1_0001, double duration, array_double_1d axis) {
double fastest, power, change;
int64_t exponent, e;
fastest = -1.0;
exponent = 1;
power = 1.0;
for (e = 1; e < 6; e += 1) {
power = power * duration;
if (*cspan_at(&axis, 31 + e - 1) > 0.0) {
change = power / *cspan_at(&axis, 31 + e - 1);
if ((fastest < 0.0) || (change < fastest)) {
fastest = change;
exponent = e;
}
}
}
(*result_0) = fastest;
(*result_1_0001) = exponent * fastest / duration;
return 0;
}
SPAN_INLINE int64_t segfmu_ramp_duration(double* result_0, double* result_1, double change, array_double_1d axis) {
double slope, duration;
if (change <= 0.0) {
(*result_0) = 0.0;
(*result_1) = 0.0;
return 0;
}
if (change >= *cspan_at(&axis, 15)) {
slope = *cspan_at(&axis, 16);
(*result_0) = change * slope + *cspan_at(&axis, 18);
(*result_1) = slope;
return 0;
}
if (*cspan_at(&axis, 19) > 0.0) {
duration = sqrt(*cspan_at(&axis, 19) * change);
(*result_0) = duration;
(*result_1) = 0.5 / change * duration;
return 0;
}
if (*cspan_at(&axis, 14) == 0.0) {
slowest_root(result_0, result_1, change, axis);
return 0;
}
plateau_duration(result_0, result_1, change, 0, axis);
return 0;
}
static SPAN_INLINE int64_t ramp_change(double* result_0, double* result_1, double duration, array_double_1d axis) {
double slope;
if (duration <= 0.0) {
(*result_0) = 0.0;
(*result_1) = 0.0;
return 0;
}
if (*cspan_at(&axis, 19) > 0.0) {
if ((*cspan_at(&axis, 16) > 0.0) && (duration >= 2.0 * *cspan_at(&axis, 21))) {
slope = *cspan_at(&axis, 17);
(*result_0) = (duration - *cspan_at(&axis, 18)) * slope;
(*result_1) = slope;
return 0;
}
slope = duration * *cspan_at(&axis, 20);
(*result_0) = slope * duration;
(*result_1) = 2.0 * slope;
return 0;
}
if (*cspan_at(&axis, 14) == 0.0) {
fastest_power(result_0, result_1, duration, axis);
return 0;
}
plateau_change(result_0, result_1, duration, 0, axis);
return 0;
}
static int64_t rise_moments(double* result_0_0001, double* result_1_0001, double duration, int64_t first, array_double_1d axis) {
double rise, squares, fourths, inner, square;
int64_t level;
rise = duration;
squares = 0.0;
fourths = 0.0;
for (level = first; level < (int64_t)(*cspan_at(&axis, 0)) - 2; level += 1) {
inner = inner_rise(rise, level, axis);
square = (rise - inner) * (rise - inner);
squares = squares + square;
fourths = fourths + square * square;
rise = inner;
}
square = rise * rise;
(*result_0_0001) = (squares + square) / 12.0;
(*result_1_0001) = (-(fourths + square * square)) / 120.0;
return 0;
}
static SPAN_INLINE double ramp_variance(double basis, array_double_1d axis) {
double rise, box, fourth, variance;
if ((*cspan_at(&axis, 16) > 0.0) && (*cspan_at(&axis, 14) != 0.0)) {
rise = *cspan_at(&axis, 21);
if ((basis >= 2.0 * rise) && (*cspan_at(&axis, 26) == 0.0)) {
box = basis - rise;
variance = box * box / 12.0 + *cspan_at(&axis, 37);
return variance;
}
}
if (*cspan_at(&axis, 36) > 0.0) {
variance = *cspan_at(&axis, 36) * basis * basis;
return variance;
}
rise_moments(&variance, &fourth, basis, 0, axis);
return variance;
}
static SPAN_INLINE double ramp_distance(double v, double a, double b, double duration, double basis, array_double_1d axis) {
double variance, y;
y = (v + 0.5 * a * duration) * duration;
if (b == a) {
return y;
}
variance = ramp_variance(basis, axis);
if (duration != basis) {
variance = variance * (duration / basis) * (duration / basis);
}
return y + (b - a) * (0.125 * duration * duration + 0.5 * variance);
}
static int64_t rise_pieces(int64_t boxes) {
int64_t i, count;
count = 0;
for (i = 0; i < boxes; i += 1) {
count = 2 * count + 1;
}
return count;
}
int64_t segfmu_ramp_pieces(array_double_1d axis) {
int64_t result;
if (*cspan_at(&axis, 14) == 0.0) {
return 1;
}
result = rise_pieces((int64_t)(*cspan_at(&axis, 0)) - 1);
return result;
}
static int64_t held_level(int64_t* result_0, double* result_1, int64_t piece, int64_t boxes) {
int64_t level, rest;
double sign;
level = boxes - 1;
rest = piece;
while(span_floor_mod(rest, 2) == 0) {
level = level - 1;
rest = span_floor_div(rest, 2);
}
sign = 1.0;
rest = span_floor_div(rest, 2);
while(rest > 0) {
if (span_floor_mod(rest, 2) == 1) {
sign = -sign;
}
rest = span_floor_div(rest, 2);
}
(*result_0) = level;
(*result_1) = sign;
return 0;
}
static int64_t held_peak(double* result_0_0001, double* result_1_0001, double* result_2, int64_t level, int64_t first, double rise, double peak, double stretch, array_double_1d axis) {
double inner;
inner = 0.0;
if (level < (int64_t)(*cspan_at(&axis, 0)) - 2 - first) {
inner = inner_rise(rise, first + level, axis);
}
(*result_0_0001) = (rise - 2.0 * inner) * stretch;
(*result_1_0001) = peak / ((rise - inner) * stretch);
(*result_2) = inner;
return 0;
}
static int64_t piece_peak(double* result_0, double* result_1, int64_t level, int64_t first, double change, double duration, double basis, array_double_1d axis) {
double stretch, rise, peak, length;
int64_t i;
stretch = duration / basis;
rise = basis;
peak = change;
length = 0.0;
for (i = 0; i < level + 1; i += 1) {
held_peak(&length, &peak, &rise, i, first, rise, peak, stretch, axis);
}
(*result_0) = length;
(*result_1) = peak;
return 0;
}
static void transition_coefficients(int64_t order, array_double_1d coefficients) {
int64_t i;
double scale, binomial;
for (i = 0; i < 2 * order + 2; i += 1) {
*cspan_at(&coefficients, i) = 0.0;
}
scale = 1.0;
for (i = 1; i < order + 1; i += 1) {
scale = scale * (order + 1 + i) / i;
}
scale = scale * (order + 1);
binomial = 1.0;
for (i = 0; i < order + 1; i += 1) {
*cspan_at(&coefficients, order + 1 + i) = scale * binomial / (order + 1 + i);
binomial = (-binomial) * (order - i) / (i + 1);
}
}
static double polynomial_derivative(array_double_1d coefficients, int64_t count, int64_t times, double s) {
int64_t j, i, m;
double factor, value;
value = 0.0;
for (j = 0; j < count - times; j += 1) {
i = count - 1 - j;
factor = 1.0;
for (m = 0; m < times; m += 1) {
factor = factor * (i - m);
}
value = value * s + factor * *cspan_at(&coefficients, i);
}
return value;
}
static void transition_peaks(int64_t order, array_double_1d coefficients, array_double_1d peaks) {
int64_t count, samples, j, at, i;
double best, value, lower, upper, left, middle, slope;
count = 2 * order + 2;
transition_coefficients(order, coefficients);
*cspan_at(&peaks, 0) = 1.0;
samples = 24 * (order + 1);
for (j = 1; j < order + 2; j += 1) {
best = 0.0;
at = 0;
for (i = 0; i < samples + 1; i += 1) {
value = fabs(polynomial_derivative(coefficients, count, j, i / (2.0 * samples)));
if (value > best) {
best = value;
at = i;
}
}
lower = (at - 1) / (2.0 * samples);
upper = (at + 1) / (2.0 * samples);
if (at == 0) {
lower = 0.0;
}
left = polynomial_derivative(coefficients, count, j + 1, lower);
for (i = 0; i < 100; i += 1) {
middle = 0.5 * (lower + upper);
slope = polynomial_derivative(coefficients, count, j + 1, middle);
if (slope * left > 0.0) {
lower = middle;
}
else {
upper = middle;
}
}
value = fabs(polynomial_derivative(coefficients, count, j, 0.5 * (lower + upper)));
if (value > best) {
best = value;
}
*cspan_at(&peaks, j) = best;
}
}
static int64_t append_piece(double duration, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_1d state) {
int64_t width, order, i, used, j;
double factorial, y, v, a, jerk;
width = coefficients.shape[1];
order = span_floor_div(width, 2) + 1;
*cspan_at(&coefficients, row, 0) = *cspan_at(&coefficients, row, 0) + *cspan_at(&state, 0);
*cspan_at(&coefficients, row, 1) = *cspan_at(&coefficients, row, 1) + *cspan_at(&state, 1);
factorial = 1.0;
for (i = 2; i < order + 1; i += 1) {
factorial = factorial * i;
if (*cspan_at(&state, i) != 0.0) {
*cspan_at(&coefficients, row, i) = *cspan_at(&coefficients, row, i) + *cspan_at(&state, i) / factorial;
}
}
*cspan_at(&timing, row, 0) = *cspan_at(&state, 8);
*cspan_at(&timing, row, 1) = duration;
used = width;
while((used > 1) && (*cspan_at(&coefficients, row, used - 1) == 0.0)) {
used = used - 1;
}
y = 0.0;
v = 0.0;
a = 0.0;
jerk = 0.0;
for (j = 0; j < used; j += 1) {
i = used - 1 - j;
y = y * duration + *cspan_at(&coefficients, row, i);
if (i > 0) {
v = v * duration + i * *cspan_at(&coefficients, row, i);
}
if (i > 1) {
a = a * duration + i * (i - 1) * *cspan_at(&coefficients, row, i);
}
if (i > 2) {
jerk = jerk * duration + i * (i - 1) * (i - 2) * *cspan_at(&coefficients, row, i);
}
}
*cspan_at(&state, 0) = y;
*cspan_at(&state, 1) = v;
*cspan_at(&state, 2) = a;
*cspan_at(&state, 3) = jerk;
for (i = 4; i < order; i += 1) {
*cspan_at(&state, i) = evaluate_piece(coefficients, row, used, duration, i);
}
*cspan_at(&state, 8) = *cspan_at(&state, 8) + duration;
return row + 1;
}
static void clear_piece(array_double_2d coefficients, int64_t row) {
int64_t i;
for (i = 0; i < coefficients.shape[1]; i += 1) {
*cspan_at(&coefficients, row, i) = 0.0;
}
}
static void set_held(int64_t above, double level, array_double_1d state) {
int64_t i;
*cspan_at(&state, 2 + above) = level;
for (i = 3 + above; i < 8; i += 1) {
*cspan_at(&state, i) = 0.0;
}
}
static int64_t expand_plateau(array_double_1d phase, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work) {
array_double_1d state, lengths, peaks;
double duration, basis, peak, rise, length, sign;
int64_t first, boxes, level, count, piece, held, i;
state = span_row(&work, 1);
lengths = span_row(&work, 2);
peaks = span_row(&work, 3);
duration = *cspan_at(&phase, 0);
basis = *cspan_at(&phase, 1);
peak = *cspan_at(&phase, 3);
first = (int64_t)(*cspan_at(&phase, 4));
boxes = (int64_t)(*cspan_at(&axis, 0)) - 1 - first;
rise = basis;
for (level = 0; level < boxes; level += 1) {
held_peak(&length, &peak, &rise, level, first, rise, peak, duration / basis, axis);
*cspan_at(&lengths, level) = length;
*cspan_at(&peaks, level) = peak;
}
count = rise_pieces(boxes);
for (piece = 1; piece < count + 1; piece += 1) {
held_level(&level, &sign, piece, boxes);
held = 3 + first + level;
for (i = held; i < 8; i += 1) {
*cspan_at(&state, i) = 0.0;
}
*cspan_at(&state, held) = sign * *cspan_at(&peaks, level);
if (*cspan_at(&lengths, level) > 0.0) {
clear_piece(coefficients, row);
row = append_piece(*cspan_at(&lengths, level), timing, coefficients, row, state);
}
}
return row;
}
static bool is_unnoticed(array_double_1d phase, double time, array_double_1d axis) {
bool result;
if ((*cspan_at(&phase, 4) > 0.5) || (*cspan_at(&phase, 0) > 1e-06 * time)) {
return 0;
}
result = fabs(*cspan_at(&phase, 3)) <= 1e-13 * *cspan_at(&axis, 3);
return result;
}
int64_t segfmu_expand_phases(array_double_2d phases, int64_t count, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work) {
array_double_1d psi, state;
int64_t order, i, above, j;
bool plateau, ramp;
double a, change, duration, scale;
psi = span_row(&work, 0);
state = span_row(&work, 1);
order = (int64_t)(*cspan_at(&axis, 0)) - 2;
plateau = *cspan_at(&axis, 14) > 0.5;
if (!plateau) {
transition_coefficients(order, psi);
}
for (i = 0; i < count; i += 1) {
a = *cspan_at(&phases, i, 2);
change = *cspan_at(&phases, i, 3);
above = (int64_t)(*cspan_at(&phases, i, 4));
set_held(above, a, state);
ramp = (change != 0.0) && (!is_unnoticed(span_row(&phases, i), *cspan_at(&state, 8), axis));
if (plateau && ramp) {
row = expand_plateau(span_row(&phases, i), axis, timing, coefficients, row, work);
}
else {
duration = *cspan_at(&phases, i, 0);
clear_piece(coefficients, row);
if (ramp) {
for (j = order + 1; j < 2 * order + 2; j += 1) {
scale = change * *cspan_at(&psi, j) / ((j + 1.0) * (j + 2.0));
*cspan_at(&coefficients, row, 2 + j) = scale / pow(duration, (double)(j));
}
}
row = append_piece(duration, timing, coefficients, row, state);
}
set_held(above, a + change, state);
}
return row;
}
static double end_derivative(int64_t row, int64_t last, int64_t order, array_double_2d timing, array_double_2d coefficients) {
int64_t width, i;
double length, largest, power, start, value;
width = coefficients.shape[1];
length = *cspan_at(&timing, row, 1);
if ((row + 1 < last) && (order <= span_floor_div(width, 2))) {
value = evaluate_piece(coefficients, row + 1, width, 0.0, order);
return value;
}
value = evaluate_piece(coefficients, row, width, length, order);
largest = 0.0;
power = 1.0;
for (i = order; i < width; i += 1) {
start = evaluate_piece(coefficients, row, width, 0.0, i);
largest = span_max(largest, fabs(start) * power);
power = power * length / (i - order + 1);
}
if ((order > 0) && (fabs(value) <= 1e-13 * largest)) {
return 0.0;
}
return value;
}
static void cut_piece(int64_t row, int64_t last, double local, array_double_2d timing, array_double_2d coefficients, array_double_2d cut_coefficients, int64_t target) {
int64_t width, i, j, order;
double rest, factorial, value, end;
width = coefficients.shape[1];
rest = *cspan_at(&timing, row, 1) - local;
factorial = 1.0;
for (i = 0; i < width; i += 1) {
if (i > 0) {
factorial = factorial * i;
}
value = 0.0;
if (rest > local) {
value = evaluate_piece(coefficients, row, width, local, i);
}
else {
for (j = 0; j < width - i; j += 1) {
order = width - 1 - j;
end = end_derivative(row, last, order, timing, coefficients);
value = end - value * rest / (order - i + 1);
}
}
*cspan_at(&cut_coefficients, target, i) = value / factorial;
}
}
static void settle_end(bool moves, int64_t first, int64_t last, array_double_2d coefficients, array_double_2d cut_coefficients, int64_t target) {
double position, velocity, acceleration, fastest, steepest;
int64_t row;
position = *cspan_at(&cut_coefficients, target, 0);
velocity = *cspan_at(&cut_coefficients, target, 1);
acceleration = *cspan_at(&cut_coefficients, target, 2);
fastest = 0.0;
steepest = 0.0;
for (row = first; row < last; row += 1) {
fastest = span_max(fastest, fabs(*cspan_at(&coefficients, row, 1)));
steepest = span_max(steepest, fabs(*cspan_at(&coefficients, row, 2)));
}
clear_piece(cut_coefficients, target);
*cspan_at(&cut_coefficients, target, 0) = position;
if (moves && (fabs(velocity) > 1e-09 * fastest)) {
*cspan_at(&cut_coefficients, target, 1) = velocity;
}
if (moves && (fabs(acceleration) > 1e-09 * steepest)) {
*cspan_at(&cut_coefficients, target, 2) = acceleration;
}
}
static void copy_piece(array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d target_timing, array_double_2d target_coefficients, int64_t target) {
int64_t i;
for (i = 0; i < 2; i += 1) {
*cspan_at(&target_timing, target, i) = *cspan_at(&timing, row, i);
}
for (i = 0; i < coefficients.shape[1]; i += 1) {
*cspan_at(&target_coefficients, target, i) = *cspan_at(&coefficients, row, i);
}
}
int64_t segfmu_cut_plan(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d cut_timing, array_double_2d cut_coefficients, array_int64_t_1d cut_offsets) {
int64_t axis, last, row, target;
double local, start, rest, end;
bool moves;
target = 0;
for (axis = 0; axis < offsets.shape[0] - 1; axis += 1) {
*cspan_at(&cut_offsets, axis) = target;
last = *cspan_at(&offsets, axis + 1);
row = find_piece(time, timing, *cspan_at(&offsets, axis), last);
local = span_max(local_time(time, timing, row), 0.0);
start = 0.0;
rest = *cspan_at(&timing, row, 1) - local;
cut_piece(row, last, local, timing, coefficients, cut_coefficients, target);
if ((row == last - 1) && (rest <= 1e-15 * time)) {
end = *cspan_at(&timing, row, 0) + *cspan_at(&timing, row, 1);
moves = time - end <= 1e-15 * time;
settle_end(moves, *cspan_at(&offsets, axis), last, coefficients, cut_coefficients, target);
rest = 0.0;
}
while(row < last) {
*cspan_at(&cut_timing, target, 0) = start;
*cspan_at(&cut_timing, target, 1) = rest;
start = start + rest;
target = target + 1;
row = row + 1;
if (row < last) {
rest = *cspan_at(&timing, row, 1);
copy_piece(timing, coefficients, row, cut_timing, cut_coefficients, target);
}
}
}
*cspan_at(&cut_offsets, offsets.shape[0] - 1) = target;
return target;
}
void segfmu_meet_ends(double clock, double dwell, array_double_2d timing, array_int64_t_1d offsets) {
double latest, late;
int64_t axis, row, longest, i;
latest = 0.0;
for (axis = 0; axis < offsets.shape[0] - 1; axis += 1) {
row = *cspan_at(&offsets, axis + 1) - 1;
latest = span_max(latest, *cspan_at(&timing, row, 0) + *cspan_at(&timing, row, 1));
}
for (axis = 0; axis < offsets.shape[0] - 1; axis += 1) {
row = *cspan_at(&offsets, axis + 1) - 1;
late = latest - (*cspan_at(&timing, row, 0) + *cspan_at(&timing, row, 1));
if (late > 1e-12 * clock) {
continue;
}
longest = row;
if ((dwell > 0.0) && (row > *cspan_at(&offsets, axis))) {
longest = row - 1;
}
for (i = *cspan_at(&offsets, axis); i < longest; i += 1) {
if (*cspan_at(&timing, i, 1) > *cspan_at(&timing, longest, 1)) {
longest = i;
}
}
*cspan_at(&timing, longest, 1) = *cspan_at(&timing, longest, 1) + late;
for (i = longest + 1; i < row + 1; i += 1) {
*cspan_at(&timing, i, 0) = *cspan_at(&timing, i, 0) + late;
}
}
}
static void add_power(double value, int64_t order, double before, array_double_2d coefficients, int64_t row) {
int64_t power, i;
double term;
for (power = 0; power < order + 1; power += 1) {
term = value;
for (i = 1; i < order - power + 1; i += 1) {
term = (-term) * before / i;
}
for (i = 1; i < power + 1; i += 1) {
term = term / i;
}
*cspan_at(&coefficients, row, power) = *cspan_at(&coefficients, row, power) + term;
}
}
void segfmu_anchor_plan(array_double_2d ends, array_double_2d limits, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets) {
int64_t width, axis, last, i, row, j, order, repeat;
double length, wanted, rounding, missed;
width = coefficients.shape[1];
for (axis = 0; axis < offsets.shape[0] - 1; axis += 1) {
last = *cspan_at(&offsets, axis + 1) - 1;
for (i = 0; i < *cspan_at(&offsets, axis + 1) - *cspan_at(&offsets, axis); i += 1) {
row = last - i;
length = *cspan_at(&timing, row, 1);
for (j = 0; j < span_floor_div(width, 2) + 1; j += 1) {
order = span_floor_div(width, 2) - j;
wanted = 0.0;
rounding = 0.0;
if ((order > 0) && (order <= limits.shape[1])) {
rounding = rounding_error(order, span_row(&limits, axis));
}
if (i > 0) {
wanted = evaluate_piece(coefficients, row + 1, width, 0.0, order);
}
else if (order < ends.shape[1]) {
wanted = *cspan_at(&ends, axis, order);
}
for (repeat = 0; repeat < 2; repeat += 1) {
missed = wanted - evaluate_piece(coefficients, row, width, length, order);
if (fabs(missed) > rounding) {
add_power(missed, order, length, coefficients, row);
}
}
}
}
}
}
int64_t segfmu_join_plans(array_double_2d lead_timing, array_double_2d lead_coefficients, array_int64_t_1d lead_offsets, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d joined_timing, array_double_2d joined_coefficients, array_int64_t_1d joined_offsets) {
int64_t axis, row, target;
target = 0;
for (axis = 0; axis < offsets.shape[0] - 1; axis += 1) {
*cspan_at(&joined_offsets, axis) = target;
for (row = *cspan_at(&lead_offsets, axis); row < *cspan_at(&lead_offsets, axis + 1); row += 1) {
copy_piece(lead_timing, lead_coefficients, row, joined_timing, joined_coefficients, target);
target = target + 1;
}
for (row = *cspan_at(&offsets, axis); row < *cspan_at(&offsets, axis + 1); row += 1) {
copy_piece(timing, coefficients, row, joined_timing, joined_coefficients, target);
target = target + 1;
}
}
*cspan_at(&joined_offsets, offsets.shape[0] - 1) = target;
return target;
}
static double length_term(int64_t order, array_double_1d swing) {
double result;
if (order == 0) {
result = *cspan_at(&swing, 2 + 2);
return result;
}
if (order == 1) {
result = *cspan_at(&swing, 5 + 2);
return result;
}
if (order == 2) {
result = 0.5 * *cspan_at(&swing, 8 + 2);
return result;
}
if (order == 3) {
result = *cspan_at(&swing, 11 + 2) / 6.0;
return result;
}
result = *cspan_at(&swing, 14 + 2) / 24.0;
return result;
}
static void write_square(array_double_1d swing, array_double_1d square) {
int64_t i, j;
for (i = 0; i < 14; i += 1) {
*cspan_at(&square, i) = 0.0;
}
for (i = 0; i < 4 + 1; i += 1) {
for (j = 0; j < 4 + 1; j += 1) {
*cspan_at(&square, i + j) = *cspan_at(&square, i + j) + length_term(i, swing) * length_term(j, swing);
}
}
}
static double suspension_pull(int64_t axis, int64_t order, double gravity, array_double_1d swing) {
double found;
found = 0.0;
if (order == 0) {
found = gravity;
if (axis < 2) {
found = *cspan_at(&swing, 8 + axis);
}
}
else if ((order == 1) && (axis < 2)) {
found = *cspan_at(&swing, 11 + axis);
}
else if ((order == 2) && (axis < 2)) {
found = 0.5 * *cspan_at(&swing, 14 + axis);
}
return found;
}
static void expand_swing(double gravity, array_double_1d swing, array_double_2d work) {
array_double_2d series;
array_double_1d square, pull;
int64_t axis, k, i;
double found, product, value;
series = span_rows(&work, 133, 136);
square = span_row(&work, 137);
write_square(swing, square);
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&series, axis, 0) = *cspan_at(&swing, 20 + axis);
*cspan_at(&series, axis, 1) = *cspan_at(&swing, 23 + axis);
}
pull = span_row(&work, 136);
for (k = 0; k < 14 - 2; k += 1) {
found = (-0.5) * (k + 1) * (k + 2) * *cspan_at(&square, k + 2);
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < span_min_int(k, 2) + 1; i += 1) {
found = found - suspension_pull(axis, i, gravity, swing) * *cspan_at(&series, axis, k - i);
}
for (i = 0; i < k + 1; i += 1) {
product = *cspan_at(&series, axis, i + 1) * *cspan_at(&series, axis, k - i + 1);
found = found + (i + 1) * (k - i + 1) * product;
}
}
for (i = 0; i < k; i += 1) {
found = found - *cspan_at(&pull, i) * *cspan_at(&square, k - i);
}
*cspan_at(&pull, k) = found / *cspan_at(&square, 0);
for (axis = 0; axis < 3; axis += 1) {
value = -suspension_pull(axis, k, gravity, swing);
for (i = 0; i < k + 1; i += 1) {
value = value - *cspan_at(&pull, i) * *cspan_at(&series, axis, k - i);
}
*cspan_at(&series, axis, k + 2) = value / ((k + 1) * (k + 2));
}
}
}
static void tighten_rope(array_double_1d swing) {
double length, square, ratio, stray, along;
int64_t axis;
length = *cspan_at(&swing, 2 + 2);
square = 0.0;
for (axis = 0; axis < 3; axis += 1) {
square = square + *cspan_at(&swing, 20 + axis) * *cspan_at(&swing, 20 + axis);
}
ratio = length / sqrt(square);
stray = (-length) * *cspan_at(&swing, 5 + 2);
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&swing, 20 + axis) = *cspan_at(&swing, 20 + axis) * ratio;
stray = stray + *cspan_at(&swing, 20 + axis) * *cspan_at(&swing, 23 + axis);
}
for (axis = 0; axis < 3; axis += 1) {
along = stray * *cspan_at(&swing, 20 + axis) / (length * length);
*cspan_at(&swing, 23 + axis) = *cspan_at(&swing, 23 + axis) - along;
}
}
static void move_swing(double step, array_double_1d swing, array_double_2d work) {
int64_t axis, j, i;
array_double_1d series;
double place, rate, snap, jerk, acceleration, mean;
for (axis = 0; axis < 3; axis += 1) {
series = span_row(&work, 133 + axis);
place = 0.0;
rate = 0.0;
for (j = 0; j < 14; j += 1) {
i = 14 - 1 - j;
rate = rate * step + place;
place = place * step + *cspan_at(&series, i);
}
*cspan_at(&swing, 20 + axis) = place;
*cspan_at(&swing, 23 + axis) = rate;
snap = *cspan_at(&swing, 14 + axis);
jerk = *cspan_at(&swing, 11 + axis);
acceleration = *cspan_at(&swing, 8 + axis);
mean = *cspan_at(&swing, 5 + axis) + (0.5 * acceleration + (jerk / 6.0 + snap * step / 24.0) * step) * step;
*cspan_at(&swing, 2 + axis) = *cspan_at(&swing, 2 + axis) + mean * step;
*cspan_at(&swing, 5 + axis) = *cspan_at(&swing, 5 + axis) + (acceleration + (0.5 * jerk + snap * step / 6.0) * step) * step;
*cspan_at(&swing, 8 + axis) = acceleration + (jerk + 0.5 * snap * step) * step;
*cspan_at(&swing, 11 + axis) = jerk + snap * step;
*cspan_at(&swing, 17 + axis) = span_max(*cspan_at(&swing, 17 + axis) - step, 0.0);
if (*cspan_at(&swing, 17 + axis) == 0.0) {
*cspan_at(&swing, 5 + axis) = 0.0;
*cspan_at(&swing, 8 + axis) = 0.0;
*cspan_at(&swing, 11 + axis) = 0.0;
*cspan_at(&swing, 14 + axis) = 0.0;
}
}
tighten_rope(swing);
}
static double swing_step(double longest, array_double_1d swing) {
int64_t axis;
double left, found;
found = longest;
for (axis = 0; axis < 3; axis += 1) {
left = *cspan_at(&swing, 17 + axis);
if ((0.0 < left) && (left < found)) {
found = left;
}
}
return found;
}
static double resolved_step(double gravity, array_double_1d swing) {
double result;
result = 0.05 * sqrt(*cspan_at(&swing, 2 + 2) / gravity);
return result;
}
static double stand_time(array_double_1d swing) {
int64_t axis;
double latest;
latest = 0.0;
for (axis = 0; axis < 3; axis += 1) {
latest = span_max(latest, *cspan_at(&swing, 17 + axis));
}
return latest;
}
static double sway_amplitude(double gravity, array_double_1d swing) {
double length, x, y, low, squares, energy, moment, least, high, middle;
int64_t axis, Dummy_0000;
length = *cspan_at(&swing, 2 + 2);
x = *cspan_at(&swing, 20);
y = *cspan_at(&swing, 20 + 1);
low = (x * x + y * y) / (length * (length - *cspan_at(&swing, 20 + 2)));
squares = 0.0;
for (axis = 0; axis < 3; axis += 1) {
squares = squares + *cspan_at(&swing, 23 + axis) * *cspan_at(&swing, 23 + axis);
}
energy = low + squares / (2.0 * gravity * length);
moment = x * *cspan_at(&swing, 23 + 1) - y * *cspan_at(&swing, 23);
least = moment * moment / (2.0 * gravity * length * length * length);
high = span_min(energy, 2.0);
for (Dummy_0000 = 0; Dummy_0000 < 60; Dummy_0000 += 1) {
middle = 0.5 * (low + high);
if (middle * (2.0 - middle) * (energy - middle) >= least) {
low = middle;
}
else {
high = middle;
}
}
return 2.0 * atan2(sqrt(low), sqrt(span_max(2.0 - low, 0.0)));
}
static void advance_swing(double duration, double gravity, array_double_1d swing, array_double_2d work) {
double left, longest, step;
left = duration;
longest = span_max(resolved_step(gravity, swing), duration / 20000);
while(left > 0.0) {
step = span_min(swing_step(longest, swing), left);
expand_swing(gravity, swing, work);
move_swing(step, swing, work);
left = left - step;
}
}
static void write_swing_piece(int64_t axis, int64_t row, double before, array_double_1d swing, array_double_3d coefficients, array_double_2d work) {
int64_t width, i, j, k;
width = coefficients.shape[2];
for (i = 0; i < width; i += 1) {
*cspan_at(&coefficients, 4, row, i) = *cspan_at(&work, 133 + axis, i);
}
if (axis < 2) {
*cspan_at(&coefficients, 4, row, 0) = *cspan_at(&coefficients, 4, row, 0) + *cspan_at(&swing, 2 + axis);
*cspan_at(&coefficients, 4, row, 1) = *cspan_at(&coefficients, 4, row, 1) + *cspan_at(&swing, 5 + axis);
*cspan_at(&coefficients, 4, row, 2) = *cspan_at(&coefficients, 4, row, 2) + 0.5 * *cspan_at(&swing, 8 + axis);
*cspan_at(&coefficients, 4, row, 3) = *cspan_at(&coefficients, 4, row, 3) + *cspan_at(&swing, 11 + axis) / 6.0;
*cspan_at(&coefficients, 4, row, 4) = *cspan_at(&coefficients, 4, row, 4) + *cspan_at(&swing, 14 + axis) / 24.0;
}
for (i = 0; i < width - 1; i += 1) {
for (j = 0; j < width - 1 - i; j += 1) {
k = width - 2 - j;
*cspan_at(&coefficients, 4, row, k) = *cspan_at(&coefficients, 4, row, k) - before * *cspan_at(&coefficients, 4, row, k + 1);
}
}
}
static void gather_axes(int64_t rows, int64_t count, int64_t slot, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
int64_t axis, i;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&offsets, slot * 4 + axis) = axis * count;
for (i = 0; i < count; i += 1) {
copy_piece(span_matrix(&timing, 4), span_matrix(&coefficients, 4), axis * rows + i, span_matrix(&timing, slot), span_matrix(&coefficients, slot), axis * count + i);
}
}
*cspan_at(&offsets, slot * 4 + 3) = 3 * count;
}
static void write_swing(double least, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
double gravity, longest, time, step;
array_double_1d swing, ahead;
int64_t i, rows, count, axis;
gravity = *cspan_at(&known, 0, 3);
swing = span_row(&operation, 32);
ahead = span_row(&operation, 33);
for (i = 0; i < 32; i += 1) {
*cspan_at(&ahead, i) = *cspan_at(&swing, i);
}
longest = span_max(resolved_step(gravity, swing), least / 300);
rows = 300 + 100;
time = 0.0;
count = 0;
while((count < rows) && ((time < least) || (stand_time(ahead) > 0.0) || (count < 100))) {
step = swing_step(longest, ahead);
expand_swing(gravity, ahead, work);
move_swing(0.5 * step, ahead, work);
expand_swing(gravity, ahead, work);
for (axis = 0; axis < 3; axis += 1) {
write_swing_piece(axis, axis * rows + count, 0.5 * step, ahead, coefficients, work);
*cspan_at(&timing, 4, axis * rows + count, 0) = time;
*cspan_at(&timing, 4, axis * rows + count, 1) = step;
}
move_swing(0.5 * step, ahead, work);
time = time + step;
count = count + 1;
}
gather_axes(rows, count, 0, timing, coefficients, offsets);
*cspan_at(&swing, 1) = time;
}
static double swing_frequency(double gravity, array_double_1d swing) {
double result;
result = sqrt(gravity / *cspan_at(&swing, 2 + 2));
return result;
}
static void set_control_start(double interval, array_double_1d swing, array_double_2d work) {
int64_t axis, i;
double change, bend, since;
for (axis = 0; axis < 3; axis += 1) {
change = interval * *cspan_at(&swing, 8 + axis);
bend = interval * interval * *cspan_at(&swing, 11 + axis);
for (i = 0; i < 3; i += 1) {
since = i - 1.0;
*cspan_at(&work, 140 + axis, i) = *cspan_at(&swing, 5 + axis) + (since * change + (0.5 * since * since - 1.0 / 6.0) * bend);
}
}
}
static void set_knot(int64_t k, double interval, array_double_1d ahead, array_double_2d control) {
int64_t axis, last;
array_double_1d points;
double before, here, behind;
for (axis = 0; axis < 3; axis += 1) {
points = span_row(&control, axis);
last = k + 3;
before = (*cspan_at(&points, k + 1) - *cspan_at(&points, k)) / interval;
here = (*cspan_at(&points, k + 2) - *cspan_at(&points, k + 1)) / interval;
behind = (*cspan_at(&points, last) - *cspan_at(&points, k + 2)) / interval;
*cspan_at(&ahead, 5 + axis) = (*cspan_at(&points, k) + 4.0 * *cspan_at(&points, k + 1) + *cspan_at(&points, k + 2)) / 6.0;
*cspan_at(&ahead, 8 + axis) = 0.5 * (before + here);
*cspan_at(&ahead, 11 + axis) = (here - before) / interval;
*cspan_at(&ahead, 14 + axis) = (behind - 2.0 * here + before) / (interval * interval);
}
}
static void begin_controlled(array_double_2d operation) {
int64_t i, axis;
for (i = 0; i < 32; i += 1) {
*cspan_at(&operation, 33, i) = *cspan_at(&operation, 32, i);
}
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&operation, 33, 17 + axis) = 1e+300;
}
}
static int64_t interval_parts(double longest, double interval, array_double_2d operation, double gravity, array_double_2d work) {
array_double_1d swing, points;
double length, shortest, inner, phase;
int64_t k, last;
swing = span_row(&operation, 32);
length = *cspan_at(&swing, 2 + 2);
shortest = length;
for (k = 0; k < 99; k += 1) {
points = span_row(&work, 140 + 2);
inner = *cspan_at(&points, k + 1) + *cspan_at(&points, k + 2);
last = k + 3;
length = length + interval * (*cspan_at(&points, k) + 11.0 * inner + *cspan_at(&points, last)) / 24.0;
shortest = span_min(shortest, length);
}
if (!(shortest > 0.0)) {
shortest = *cspan_at(&swing, 2 + 2);
}
phase = interval * sqrt(gravity / shortest);
if (!(phase < longest * 1000)) {
return 1000;
}
return 1 + (int64_t)(phase / longest);
}
static void add_moments(int64_t knot, double since, double step, double interval, array_double_1d moment, array_double_1d free, array_double_1d pull) {
int64_t k, i, j;
double value, whole, late, later, place, rate;
for (k = 0; k < 14 - 2; k += 1) {
value = 0.0;
for (i = 0; i < k + 1; i += 1) {
value = value - *cspan_at(&pull, i) * *cspan_at(&free, k - i);
}
*cspan_at(&free, k + 2) = value / ((k + 1) * (k + 2));
}
whole = 0.0;
late = 0.0;
later = 0.0;
place = 0.0;
rate = 0.0;
for (j = 0; j < 14; j += 1) {
i = 14 - 1 - j;
whole = whole * step + *cspan_at(&free, i) / (i + 1);
late = late * step + *cspan_at(&free, i) / (i + 2);
later = later * step + *cspan_at(&free, i) / (i + 3);
rate = rate * step + place;
place = place * step + *cspan_at(&free, i);
}
whole = whole * step;
late = late * step * step;
later = later * step * step * step;
later = (since * since * whole + 2.0 * since * late + later) / (interval * interval);
late = (since * whole + late) / interval;
*cspan_at(&moment, knot) = *cspan_at(&moment, knot) + (0.5 * whole - late + 0.5 * later) / interval;
*cspan_at(&moment, knot + 1) = *cspan_at(&moment, knot + 1) + (0.5 * whole + late - later) / interval;
*cspan_at(&moment, knot + 2) = *cspan_at(&moment, knot + 2) + 0.5 * later / interval;
*cspan_at(&free, 0) = place;
*cspan_at(&free, 1) = rate;
}
static double run_controlled(double interval, array_double_2d operation, array_double_2d known, array_double_2d work) {
double gravity, step, frequency, found, away, rate, result;
array_double_1d ahead;
int64_t j, k, parts, i, axis;
gravity = *cspan_at(&known, 0, 3);
ahead = span_row(&operation, 33);
begin_controlled(operation);
for (j = 0; j < 2; j += 1) {
for (k = 0; k < 102; k += 1) {
*cspan_at(&work, 143 + j, k) = 0.0;
}
*cspan_at(&work, 138 + j, 0) = 1.0 - j;
*cspan_at(&work, 138 + j, 1) = j * swing_frequency(gravity, ahead);
}
parts = interval_parts(0.3, interval, operation, gravity, work);
step = interval / parts;
for (k = 0; k < 99; k += 1) {
set_knot(k, interval, ahead, span_rows(&work, 140, 143));
for (i = 0; i < parts; i += 1) {
expand_swing(gravity, ahead, work);
if (!(*cspan_at(&work, 136, 0) > 0.0)) {
return 1e+300;
}
for (j = 0; j < 2; j += 1) {
add_moments(k, i * step, step, interval, span_row(&work, 143 + j), span_row(&work, 138 + j), span_row(&work, 136));
}
move_swing(step, ahead, work);
}
}
frequency = swing_frequency(gravity, ahead);
found = 0.0;
for (axis = 0; axis < 2; axis += 1) {
away = *cspan_at(&ahead, 20 + axis);
rate = *cspan_at(&ahead, 23 + axis) / frequency;
found = found + away * away + rate * rate;
}
result = sqrt(found) / *cspan_at(&ahead, 2 + 2);
return result;
}
static bool fits_plan(double interval, array_double_2d operation, array_double_2d known, array_double_2d work) {
double gravity;
bool result;
gravity = *cspan_at(&known, 0, 3);
result = interval_parts(0.2, interval, operation, gravity, work) <= 4;
return result;
}
static void write_controlled(double interval, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
double gravity, step;
array_double_1d ahead;
int64_t parts, rows, count, k, i, axis, row;
gravity = *cspan_at(&known, 0, 3);
ahead = span_row(&operation, 33);
parts = span_min_int(2 + interval_parts(0.05, interval, operation, gravity, work), 4);
begin_controlled(operation);
step = interval / parts;
rows = 99 * 4;
count = 0;
for (k = 0; k < 99; k += 1) {
set_knot(k, interval, ahead, span_rows(&work, 140, 143));
for (i = 0; i < parts; i += 1) {
expand_swing(gravity, ahead, work);
move_swing(0.5 * step, ahead, work);
expand_swing(gravity, ahead, work);
for (axis = 0; axis < 3; axis += 1) {
row = axis * rows + count;
write_swing_piece(axis, row, 0.5 * step, ahead, coefficients, work);
*cspan_at(&timing, 4, row, 0) = k * interval + i * step;
*cspan_at(&timing, 4, row, 1) = step;
}
move_swing(0.5 * step, ahead, work);
count = count + 1;
}
}
gather_axes(rows, count, 4, timing, coefficients, offsets);
}
static void set_range(double centre, double radius, array_double_1d found) {
*cspan_at(&found, 0) = centre;
*cspan_at(&found, 1) = radius;
}
static void add_range(double share, array_double_1d a, array_double_1d found) {
*cspan_at(&found, 0) = *cspan_at(&found, 0) + share * *cspan_at(&a, 0);
*cspan_at(&found, 1) = *cspan_at(&found, 1) + fabs(share) * *cspan_at(&a, 1);
}
static void add_range_product(double share, array_double_1d a, array_double_1d b, array_double_1d found) {
double radius;
radius = fabs(*cspan_at(&a, 0)) * *cspan_at(&b, 1);
radius = radius + *cspan_at(&a, 1) * (fabs(*cspan_at(&b, 0)) + *cspan_at(&b, 1));
*cspan_at(&found, 0) = *cspan_at(&found, 0) + share * *cspan_at(&a, 0) * *cspan_at(&b, 0);
*cspan_at(&found, 1) = *cspan_at(&found, 1) + fabs(share) * radius;
}
static void divide_range(array_double_1d a, array_double_1d b, array_double_1d found) {
double quotient, least;
quotient = *cspan_at(&a, 0) / *cspan_at(&b, 0);
least = *cspan_at(&b, 0) - *cspan_at(&b, 1);
*cspan_at(&found, 1) = (*cspan_at(&a, 1) + fabs(quotient) * *cspan_at(&b, 1)) / least;
*cspan_at(&found, 0) = quotient;
}
static void write_derivative(int64_t order, int64_t width, double radius, array_double_1d piece, array_double_1d found) {
double total, value;
int64_t j, i, k;
total = 0.0;
value = 0.0;
for (j = 0; j < width - order; j += 1) {
i = width - 1 - j;
value = *cspan_at(&piece, i);
for (k = 0; k < order; k += 1) {
value = value * (i - k);
}
if (i > order) {
total = (total + fabs(value)) * radius;
}
}
set_range(value, total, found);
}
static void write_load(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work) {
int64_t width, axis, last, row, i, order, place;
double middle, radius, local;
array_double_1d piece;
width = coefficients.shape[1];
middle = 0.5 * (begin + end);
radius = 0.5 * (end - begin);
piece = span_row(&work, 88);
for (axis = 0; axis < 3; axis += 1) {
last = *cspan_at(&offsets, axis + 1);
row = find_piece(middle, timing, *cspan_at(&offsets, axis), last);
for (i = 0; i < width; i += 1) {
*cspan_at(&piece, i) = *cspan_at(&coefficients, row, i);
}
local = middle - *cspan_at(&timing, row, 0);
if (local > *cspan_at(&timing, row, 1)) {
*cspan_at(&piece, 0) = evaluate_piece(coefficients, row, width, *cspan_at(&timing, row, 1), 0);
for (i = 1; i < width; i += 1) {
*cspan_at(&piece, i) = 0.0;
}
}
else {
polynomial_shift(piece, local, width);
}
for (order = 0; order < 5; order += 1) {
place = 89 + 0 + 3 * order + axis;
write_derivative(order, width, radius, piece, span_row(&work, place));
}
}
}
static void write_slope(int64_t axis, array_double_2d reach) {
array_double_1d slope, rate, pull, pull_rate, total;
slope = span_row(&reach, 16 + axis);
rate = span_row(&reach, 18 + axis);
pull = span_row(&reach, 15);
pull_rate = span_row(&reach, 9 + 2);
total = span_row(&reach, 26);
divide_range(span_row(&reach, 6 + axis), pull, slope);
set_range(0.0, 0.0, total);
add_range(1.0, span_row(&reach, 9 + axis), total);
add_range_product(-1.0, slope, pull_rate, total);
divide_range(total, pull, rate);
set_range(0.0, 0.0, total);
add_range(1.0, span_row(&reach, 12 + axis), total);
add_range_product(-2.0, rate, pull_rate, total);
add_range_product(-1.0, slope, span_row(&reach, 12 + 2), total);
divide_range(total, pull, span_row(&reach, 20 + axis));
}
static void write_stretch(array_double_2d reach) {
array_double_1d total, stretch, rate, slope_rate;
int64_t axis;
double root;
total = span_row(&reach, 26);
stretch = span_row(&reach, 22);
rate = span_row(&reach, 23);
set_range(1.0, 0.0, total);
for (axis = 0; axis < 2; axis += 1) {
add_range_product(1.0, span_row(&reach, 16 + axis), span_row(&reach, 16 + axis), total);
}
root = sqrt(*cspan_at(&total, 0));
set_range(root, *cspan_at(&total, 1) / (1.0 + root), stretch);
set_range(0.0, 0.0, total);
for (axis = 0; axis < 2; axis += 1) {
slope_rate = span_row(&reach, 18 + axis);
add_range_product(1.0, span_row(&reach, 16 + axis), slope_rate, total);
}
divide_range(total, stretch, rate);
set_range(0.0, 0.0, total);
for (axis = 0; axis < 2; axis += 1) {
slope_rate = span_row(&reach, 18 + axis);
add_range_product(1.0, slope_rate, slope_rate, total);
add_range_product(1.0, span_row(&reach, 16 + axis), span_row(&reach, 20 + axis), total);
}
add_range_product(-1.0, rate, rate, total);
divide_range(total, stretch, span_row(&reach, 24));
}
static void write_drive(int64_t drive, double ahead, array_double_1d factor, array_double_1d rate, array_double_1d change, array_double_2d reach) {
array_double_1d place, velocity, acceleration;
place = span_row(&reach, 27 + 12 + drive);
velocity = span_row(&reach, 27 + 3 + drive);
acceleration = span_row(&reach, 27 + 6 + drive);
set_range(0.0, 0.0, place);
add_range(ahead, span_row(&reach, 0 + drive), place);
add_range_product(-1.0, span_row(&reach, 0 + 2), factor, place);
set_range(0.0, 0.0, velocity);
add_range(ahead, span_row(&reach, 3 + drive), velocity);
add_range_product(-1.0, span_row(&reach, 3 + 2), factor, velocity);
add_range_product(-1.0, span_row(&reach, 0 + 2), rate, velocity);
set_range(0.0, 0.0, acceleration);
add_range(ahead, span_row(&reach, 6 + drive), acceleration);
add_range_product(-1.0, span_row(&reach, 6 + 2), factor, acceleration);
add_range_product(-2.0, span_row(&reach, 3 + 2), rate, acceleration);
add_range_product(-1.0, span_row(&reach, 0 + 2), change, acceleration);
}
static void add_resistance(int64_t drive, array_double_1d crane, array_double_2d reach) {
array_double_1d velocity;
double most, dry, smooth;
velocity = span_row(&reach, 27 + 3 + drive);
most = fabs(*cspan_at(&velocity, 0)) + *cspan_at(&velocity, 1);
dry = span_max(*cspan_at(&crane, 10 + drive), *cspan_at(&crane, 7 + drive));
smooth = *cspan_at(&crane, 4 + drive) + *cspan_at(&crane, 13 + drive) * most;
set_range(0.0, dry + smooth * most, span_row(&reach, 25));
add_range(1.0, span_row(&reach, 25), span_row(&reach, 27 + 0 + drive));
}
static void write_forces(array_double_1d crane, array_double_2d reach) {
double payload;
int64_t drive;
array_double_1d force, acceleration, power;
payload = *cspan_at(&crane, 2);
for (drive = 0; drive < 2; drive += 1) {
force = span_row(&reach, 27 + 0 + drive);
set_range(0.0, 0.0, force);
acceleration = span_row(&reach, 27 + 6 + drive);
add_range(carriage_mass(crane, drive), acceleration, force);
add_range(payload, span_row(&reach, 6 + drive), force);
}
force = span_row(&reach, 27 + 0 + 2);
set_range(0.0, 0.0, force);
add_range_product(-payload, span_row(&reach, 15), span_row(&reach, 22), force);
for (drive = 0; drive < 3; drive += 1) {
add_resistance(drive, crane, reach);
power = span_row(&reach, 27 + 9 + drive);
set_range(0.0, 0.0, power);
add_range_product(1.0, span_row(&reach, 27 + 0 + drive), span_row(&reach, 27 + 3 + drive), power);
}
}
static void lead_velocities(array_double_1d crane, array_double_2d reach) {
int64_t drive;
for (drive = 0; drive < 3; drive += 1) {
add_range(*cspan_at(&crane, 18 + drive), span_row(&reach, 27 + 6 + drive), span_row(&reach, 27 + 3 + drive));
}
}
static void write_sway(array_double_2d reach) {
array_double_1d q_x, q_y;
double across, most;
q_x = span_row(&reach, 16);
q_y = span_row(&reach, 16 + 1);
across = *cspan_at(&q_x, 0) / sqrt(1.0 + *cspan_at(&q_y, 0) * *cspan_at(&q_y, 0));
most = fabs(*cspan_at(&q_x, 0)) + *cspan_at(&q_x, 1);
set_range(-atan(across), *cspan_at(&q_x, 1) + most * *cspan_at(&q_y, 1), span_row(&reach, 27 + 15));
set_range(atan(*cspan_at(&q_y, 0)), *cspan_at(&q_y, 1), span_row(&reach, 27 + 15 + 1));
}
static bool write_demands(array_double_1d crane, array_double_2d work) {
array_double_2d reach;
array_double_1d pull;
int64_t axis;
reach = span_rows(&work, 89, 169);
pull = span_row(&reach, 15);
set_range(*cspan_at(&crane, 3), 0.0, pull);
add_range(1.0, span_row(&reach, 6 + 2), pull);
if (!(*cspan_at(&pull, 0) > *cspan_at(&pull, 1))) {
return 0;
}
write_slope(0, reach);
write_slope(1, reach);
write_stretch(reach);
for (axis = 0; axis < 2; axis += 1) {
write_drive(axis, 1.0, span_row(&reach, 16 + axis), span_row(&reach, 18 + axis), span_row(&reach, 20 + axis), reach);
}
write_drive(2, 0.0, span_row(&reach, 22), span_row(&reach, 23), span_row(&reach, 24), reach);
write_forces(crane, reach);
lead_velocities(crane, reach);
write_sway(reach);
return 1;
}
static bool write_reach(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d crane, array_double_2d work) {
bool result;
write_load(begin, end, timing, coefficients, offsets, work);
result = write_demands(crane, work);
return result;
}
static int64_t judge_reach(int64_t first, int64_t last, array_double_1d bounds, array_double_2d work) {
double rounding, bound, value;
int64_t i, side, proved;
array_double_1d demand;
proved = 1;
rounding = 1.0 + 1e-09;
for (i = first; i < last; i += 1) {
demand = span_row(&work, 89 + 27 + i);
for (side = 0; side < 2; side += 1) {
bound = bound_magnitude(i, side, bounds) * rounding;
if (bound != 0.0) {
value = (1.0 - 2.0 * side) * *cspan_at(&demand, 0);
value = value - bound_origin(i, side, bounds);
if (!(value <= bound)) {
return -1;
}
if (!(value + *cspan_at(&demand, 1) <= bound)) {
proved = 0;
}
}
}
}
return proved;
}
static bool keeps_between(int64_t first, int64_t last, double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work) {
int64_t depth, place, found;
double length, start;
depth = 0;
place = 0;
while((depth > 0) || (place == 0)) {
length = (end - begin) * pow(0.5, (double)(depth));
start = begin + place * length;
found = 0;
if (write_reach(start, start + length, timing, coefficients, offsets, span_row(&known, 0), work)) {
found = judge_reach(first, last, span_row(&known, 2), work);
}
if ((found < 0) || ((found == 0) && (depth == 10))) {
return 0;
}
if (found == 0) {
place = 2 * place;
depth = depth + 1;
}
else {
place = place + 1;
while((depth > 0) && (span_floor_mod(place, 2) == 0)) {
place = span_floor_div(place, 2);
depth = depth - 1;
}
}
}
return 1;
}
static bool keeps_demands(int64_t first, int64_t last, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work) {
double time, until;
int64_t intervals;
if (!segfmu_has_bounds(first, last, span_row(&known, 2))) {
return 1;
}
time = (*cspan_at(&timing, *cspan_at(&offsets, 0), 0));
until = interval_end(time, timing, offsets);
intervals = 0;
while((until > time) || (intervals == 0)) {
intervals = intervals + 1;
if (!keeps_between(first, last, time, until, timing, coefficients, offsets, known, work)) {
return 0;
}
time = until;
until = interval_end(time, timing, offsets);
}
return 1;
}
bool segfmu_keeps_drives(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work) {
bool result;
result = keeps_demands(0, 17, timing, coefficients, offsets, known, work);
return result;
}
static int64_t plan_pieces(int64_t slot, array_int64_t_1d offsets) {
int64_t result;
result = *cspan_at(&offsets, slot * 4 + 3) - *cspan_at(&offsets, slot * 4);
return result;
}
static double plan_end(int64_t slot, int64_t axis, array_double_3d timing, array_int64_t_1d offsets) {
int64_t last;
double result;
last = *cspan_at(&offsets, slot * 4 + axis + 1) - 1;
result = *cspan_at(&timing, slot, last, 0) + *cspan_at(&timing, slot, last, 1);
return result;
}
static void copy_plan(int64_t source, int64_t target, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
int64_t i, row;
for (i = 0; i < 4; i += 1) {
*cspan_at(&offsets, target * 4 + i) = *cspan_at(&offsets, source * 4 + i);
}
for (row = 0; row < plan_pieces(source, offsets); row += 1) {
copy_piece(span_matrix(&timing, source), span_matrix(&coefficients, source), row, span_matrix(&timing, target), span_matrix(&coefficients, target), row);
}
}
static bool has_room(int64_t slot, array_int64_t_1d offsets) {
bool result;
result = plan_pieces(slot, offsets) <= 1200;
return result;
}
static void clear_plan(int64_t slot, array_int64_t_1d offsets) {
int64_t i;
for (i = 0; i < 4; i += 1) {
*cspan_at(&offsets, slot * 4 + i) = 0;
}
}
static void note_present(double elapsed, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
int64_t present, rest, width, axis, row, order;
present = 0 * 4;
rest = 1 * 4;
segfmu_cut_plan(span_max(elapsed, 0.0), span_matrix(&timing, 0), span_matrix(&coefficients, 0), span_part(&offsets, present, present + 4), span_matrix(&timing, 1), span_matrix(&coefficients, 1), span_part(&offsets, rest, rest + 4));
width = coefficients.shape[2];
for (axis = 0; axis < 3; axis += 1) {
row = *cspan_at(&offsets, rest + axis);
for (order = 0; order < span_floor_div(width, 2) + 1; order += 1) {
*cspan_at(&operation, 19 + axis, order) = evaluate_piece(span_matrix(&coefficients, 1), row, width, 0.0, order);
}
}
}
static bool keeps_limits(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work) {
int64_t first, axis, i, j;
array_double_2d times;
bool result;
first = 4 * 4;
times = span_rows(&work, 81, 84);
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < states.shape[2]; i += 1) {
*cspan_at(&states, 0, axis, i) = *cspan_at(&operation, 19 + axis, i);
*cspan_at(&states, 1, axis, i) = 0.0;
}
*cspan_at(&states, 1, axis, 0) = standstill(4, axis, timing, coefficients, offsets);
*cspan_at(&times, 0, axis) = 0.0;
for (j = 1; j < states.shape[0] + 1; j += 1) {
*cspan_at(&times, j, axis) = plan_end(4, axis, timing, offsets);
}
}
result = check_plan(states, times, span_matrix(&timing, 4), span_matrix(&coefficients, 4), span_part(&offsets, first, first + 4), limits, span_rows(&known, 6, 9), 1e-09, 9.5e-10, span_rows(&lead, 312, 360)) == 0;
return result;
}
static int64_t prove_crane(int64_t demands, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack) {
int64_t first, contact;
array_int64_t_1d pieces;
first = 4 * 4;
pieces = span_part(&offsets, first, first + 4);
if (segfmu_check_rope(span_matrix(&timing, 4), span_matrix(&coefficients, 4), pieces, span_row(&known, 1), span_rows(&work, 0, 52), span_row(&work, 80)) != 0) {
return 3;
}
contact = segfmu_space_contact(span_matrix(&timing, 4), span_matrix(&coefficients, 4), pieces, span_row(&known, 4), span_rows(&known, 9, 25), span_rows(&work, 52, 74), span_rows(&work, 0, 52), stack, span_rows(&work, 74, 80), span_row(&work, 80));
if (contact == 3) {
return 4;
}
if (contact != 0) {
return 5;
}
if (!keeps_demands(12, 15, span_matrix(&timing, 4), span_matrix(&coefficients, 4), pieces, known, work)) {
return 8;
}
if (!keeps_demands(0, demands, span_matrix(&timing, 4), span_matrix(&coefficients, 4), pieces, known, work)) {
return 6;
}
return 0;
}
static int64_t prove_plan(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work, array_double_3d stack) {
int64_t result;
if (!keeps_limits(operation, limits, known, timing, coefficients, offsets, states, lead, work)) {
return 2;
}
result = prove_crane(17, known, timing, coefficients, offsets, work, stack);
return result;
}
static double used_share(void) {
return 0.998;
}
static bool brake_hoist(double share, double interval, array_double_2d known, array_double_2d work) {
array_double_1d points;
int64_t i;
double fall, rise;
bool result;
points = span_row(&work, 140 + 2);
for (i = 3; i < 102; i += 1) {
fall = most_change(2, -1.0, share, interval, known);
rise = most_change(2, 1.0, share, interval, known);
*cspan_at(&points, i) = *cspan_at(&points, i - 1) + span_min(span_max(-*cspan_at(&points, i - 1), -fall), rise);
}
result = *cspan_at(&points, 99) == 0.0;
return result;
}
static void set_way(int64_t axis, array_double_2d operation, array_double_2d work) {
double sense;
sense = 1.0;
if (axis == 2) {
sense = -1.0;
}
*cspan_at(&work, 150, 2) = sense * *cspan_at(&operation, 1, 1 + axis) - *cspan_at(&operation, 32, 2 + axis);
}
static int64_t most_runs(void) {
return 30;
}
static bool calms_within(double duration, double share, array_double_2d operation, array_double_2d known, array_double_2d work) {
array_double_1d swing, aims;
int64_t last, axis, Dummy_0000;
double interval, frequency, before, angle;
swing = span_row(&operation, 32);
aims = span_row(&work, 150);
last = 2;
interval = duration / 99;
frequency = swing_frequency(*cspan_at(&known, 0, 3), swing);
set_control_start(interval, swing, work);
for (axis = 0; axis < 2; axis += 1) {
decline_line(axis, work);
}
if (*cspan_at(&operation, 1, 0) > 0.5) {
last = 3;
set_way(2, operation, work);
if (!find_centre(2, share, interval, 2, last, aims, known, work)) {
return 0;
}
}
else if (!brake_hoist(share, interval, known, work)) {
return 0;
}
if (!fits_plan(interval, operation, known, work)) {
return 0;
}
before = 1e+300;
for (Dummy_0000 = 0; Dummy_0000 < most_runs(); Dummy_0000 += 1) {
angle = run_controlled(interval, operation, known, work);
if ((angle < 1e-12) || ((angle < 1e-10) && (angle > 0.5 * before))) {
return 1;
}
before = angle;
for (axis = 0; axis < 2; axis += 1) {
set_way(axis, operation, work);
*cspan_at(&aims, 0) = *cspan_at(&swing, 23 + axis);
*cspan_at(&aims, 0 + 1) = (-frequency) * *cspan_at(&swing, 20 + axis);
if (!find_centre(axis, share, interval, 0, last, aims, known, work)) {
return 0;
}
}
}
return 0;
}
static double least_time(double share, array_double_2d operation, array_double_2d known, array_double_2d work) {
array_double_1d swing;
double frequency, least, velocity, place, rate, way, fastest, found;
int64_t axis;
swing = span_row(&operation, 32);
frequency = swing_frequency(*cspan_at(&known, 0, 3), swing);
found = 0.001 / frequency;
for (axis = 0; axis < 3; axis += 1) {
least = span_min(control_bound(6 + axis, 1.0, share, 0.0, known), control_bound(6 + axis, -1.0, share, 0.0, known));
velocity = fabs(*cspan_at(&swing, 5 + axis));
if (axis < 2) {
place = frequency * *cspan_at(&swing, 20 + axis);
rate = *cspan_at(&swing, 23 + axis);
velocity = span_max(velocity, sqrt(place * place + rate * rate));
}
found = span_max(found, velocity / least);
if (*cspan_at(&operation, 1, 0) > 0.5) {
set_way(axis, operation, work);
way = *cspan_at(&work, 150, 2);
fastest = control_bound(3 + axis, way, share, 0.0, known);
if (fastest > 0.0) {
found = span_max(found, fabs(way) / fastest);
}
}
}
return found;
}
static int64_t most_growths(void) {
return 20;
}
static double seek_calm(double share, array_double_2d operation, array_double_2d known, array_double_2d work) {
double tried, missed, found;
int64_t count;
tried = least_time(share, operation, known, work);
missed = tried;
count = 0;
while(!calms_within(tried, share, operation, known, work)) {
missed = tried;
tried = 1.25 * tried;
count = count + 1;
if (count == most_growths()) {
return 0.0;
}
}
found = tried;
while(found > 1.01 * missed) {
tried = 0.5 * (missed + found);
if (calms_within(tried, share, operation, known, work)) {
found = tried;
}
else {
missed = tried;
}
}
if ((tried != found) && (!calms_within(found, share, operation, known, work))) {
return 0.0;
}
return found;
}
static int64_t plan_calm(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack) {
int64_t drive, Dummy_0000, status;
double share, duration;
for (drive = 0; drive < 3; drive += 1) {
if (!(*cspan_at(&known, 2, 6 + drive) > 0.0)) {
return 6;
}
}
status = 6;
share = used_share();
for (Dummy_0000 = 0; Dummy_0000 < 4; Dummy_0000 += 1) {
duration = seek_calm(share, operation, known, work);
if (duration == 0.0) {
return 6;
}
write_controlled(duration / 99, operation, known, timing, coefficients, offsets, work);
status = prove_crane(15, known, timing, coefficients, offsets, work, stack);
if (status != 6) {
return status;
}
share = 0.7 * share;
}
return status;
}
static void invert_flat(array_double_2d known, array_double_2d work) {
segfmu_crane_flat_inverse(span_rows(&work, 161, 166), span_row(&known, 0), span_row(&work, 166), span_row(&work, 167), span_row(&work, 168));
}
static void note_swing(array_double_2d operation, array_double_2d known, array_double_2d work) {
array_double_2d flat;
array_double_1d swing, state;
int64_t axis, order;
flat = span_rows(&work, 161, 166);
swing = span_row(&operation, 32);
for (axis = 0; axis < 3; axis += 1) {
for (order = 0; order < 5; order += 1) {
*cspan_at(&flat, order, axis) = *cspan_at(&operation, 19 + axis, order);
}
}
invert_flat(known, work);
state = span_row(&work, 167);
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&swing, 2 + axis) = *cspan_at(&state, 0 + axis);
*cspan_at(&swing, 5 + axis) = *cspan_at(&state, 5 + axis);
*cspan_at(&swing, 20 + axis) = *cspan_at(&flat, 0, axis);
*cspan_at(&swing, 23 + axis) = *cspan_at(&flat, 1, axis);
if (axis < 2) {
*cspan_at(&swing, 20 + axis) = *cspan_at(&swing, 20 + axis) - *cspan_at(&swing, 2 + axis);
*cspan_at(&swing, 23 + axis) = *cspan_at(&swing, 23 + axis) - *cspan_at(&swing, 5 + axis);
}
}
}
static void note_trips(array_double_2d operation) {
int64_t drive;
for (drive = 0; drive < 3; drive += 1) {
*cspan_at(&operation, 32, 28 + drive) = *cspan_at(&operation, 0, 17 + drive);
}
}
static double brake_of(int64_t drive, int64_t side, double share, array_double_1d swing, array_double_2d known) {
double most, own;
most = bound_magnitude(6 + drive, side, span_row(&known, 2));
if (*cspan_at(&swing, 28 + drive) > 0.5) {
own = *cspan_at(&known, 3, 0 + drive);
if (own > 0.0) {
return own;
}
return most;
}
return share * most;
}
static double least_brake(int64_t drive, array_double_1d swing, array_double_2d known) {
double result;
result = span_min(brake_of(drive, 0, 1.0, swing, known), brake_of(drive, 1, 1.0, swing, known));
return result;
}
static void set_brakes(double share, array_double_1d swing, array_double_2d known) {
int64_t axis, side;
double velocity, most;
for (axis = 0; axis < 3; axis += 1) {
velocity = *cspan_at(&swing, 5 + axis);
*cspan_at(&swing, 8 + axis) = 0.0;
*cspan_at(&swing, 11 + axis) = 0.0;
*cspan_at(&swing, 14 + axis) = 0.0;
*cspan_at(&swing, 17 + axis) = 0.0;
if (fabs(velocity) > 0.0) {
side = 0;
if (velocity > 0.0) {
side = 1;
}
most = brake_of(axis, side, share, swing, known);
*cspan_at(&swing, 17 + axis) = fabs(velocity) / most;
*cspan_at(&swing, 8 + axis) = (1.0 - 2.0 * side) * most;
}
}
}
static bool is_inside(double value, int64_t demand, array_double_2d known) {
int64_t side;
double bound;
side = 0;
if (value < 0.0) {
side = 1;
}
bound = bound_magnitude(demand, side, span_row(&known, 2));
return (bound == 0.0) || (fabs(value) <= 0.999 * bound);
}
static bool is_bearable(array_double_1d swing, array_double_2d known, array_double_2d work) {
array_double_2d flat;
int64_t axis, order, drive;
double factorial, force, power;
if (!(*cspan_at(&work, 136, 0) > 0.0)) {
return 0;
}
if (!(*cspan_at(&swing, 20 + 2) < 0.0)) {
return 0;
}
flat = span_rows(&work, 161, 166);
for (axis = 0; axis < 3; axis += 1) {
factorial = 1.0;
for (order = 0; order < 5; order += 1) {
factorial = factorial * span_max_int(order, 1);
*cspan_at(&flat, order, axis) = factorial * *cspan_at(&work, 133 + axis, order);
}
if (axis < 2) {
*cspan_at(&flat, 0, axis) = *cspan_at(&flat, 0, axis) + *cspan_at(&swing, 2 + axis);
*cspan_at(&flat, 1, axis) = *cspan_at(&flat, 1, axis) + *cspan_at(&swing, 5 + axis);
*cspan_at(&flat, 2, axis) = *cspan_at(&flat, 2, axis) + *cspan_at(&swing, 8 + axis);
}
}
invert_flat(known, work);
for (drive = 0; drive < 3; drive += 1) {
if (*cspan_at(&swing, 28 + drive) > 0.5) {
continue;
}
force = *cspan_at(&work, 166, drive);
power = force * *cspan_at(&swing, 5 + drive);
if (!is_inside(force, 0 + drive, known)) {
return 0;
}
if (!is_inside(power, 9 + drive, known)) {
return 0;
}
}
return 1;
}
static bool brakes_with(double share, array_double_2d operation, array_double_2d known, array_double_2d work) {
double gravity, stand;
array_double_1d swing, ahead;
int64_t i, pieces, swings;
gravity = *cspan_at(&known, 0, 3);
swing = span_row(&operation, 32);
ahead = span_row(&operation, 33);
set_brakes(share, swing, known);
for (i = 0; i < 32; i += 1) {
*cspan_at(&ahead, i) = *cspan_at(&swing, i);
}
stand = stand_time(swing);
if (!(stand < 1000000000.0 * resolved_step(gravity, swing))) {
return 0;
}
*cspan_at(&swing, 26) = stand;
pieces = 0;
swings = 0;
while((stand_time(ahead) > 0.0) || (swings < 63)) {
if (stand_time(ahead) == 0.0) {
if (swings == 0) {
*cspan_at(&swing, 27) = sway_amplitude(gravity, ahead);
}
swings = swings + 1;
}
expand_swing(gravity, ahead, work);
if (!is_bearable(ahead, known, work)) {
return 0;
}
move_swing(swing_step(2.0 * resolved_step(gravity, ahead), ahead), ahead, work);
pieces = pieces + 1;
if (pieces > 20000) {
return 0;
}
}
return 1;
}
static bool plan_brakes(array_double_2d operation, array_double_2d known, array_double_2d work) {
int64_t drive, Dummy_0000;
double kept, missed, middle;
bool result;
for (drive = 0; drive < 3; drive += 1) {
if (!(least_brake(drive, span_row(&operation, 32), known) > 0.0)) {
return 0;
}
}
if (brakes_with(1.0, operation, known, work)) {
return 1;
}
kept = 0.0;
missed = 1.0;
for (Dummy_0000 = 0; Dummy_0000 < 12; Dummy_0000 += 1) {
middle = 0.5 * (kept + missed);
if (brakes_with(middle, operation, known, work)) {
kept = middle;
}
else {
missed = middle;
}
}
result = (kept > 0.0) && brakes_with(kept, operation, known, work);
return result;
}
static bool plan_emergency(array_double_2d operation, array_double_2d known, array_double_2d work) {
bool result;
note_swing(operation, known, work);
note_trips(operation);
result = plan_brakes(operation, known, work);
return result;
}
static double covered_time(array_double_2d operation) {
array_double_1d command;
double result;
command = span_row(&operation, 0);
result = *cspan_at(&command, 1) + *cspan_at(&command, 14);
return result;
}
static void cover_swing(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
write_swing(covered_time(operation), operation, known, timing, coefficients, offsets, work);
*cspan_at(&operation, 4, 0) = *cspan_at(&operation, 0, 0);
}
static bool begin_emergency(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
double gravity;
array_double_1d swing;
gravity = *cspan_at(&known, 0, 3);
swing = span_row(&operation, 32);
if (!plan_emergency(operation, known, work)) {
*cspan_at(&operation, 4, 2) = 6;
return 0;
}
if ((*cspan_at(&swing, 26) == 0.0) && (*cspan_at(&swing, 27) < 1e-09)) {
return 0;
}
if (covered_time(operation) > 6.0 * 300 * resolved_step(gravity, swing)) {
return 0;
}
*cspan_at(&swing, 0) = 1.0;
cover_swing(operation, known, timing, coefficients, offsets, work);
return 1;
}
static bool prolong_swing(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
array_double_1d command, swing;
command = span_row(&operation, 0);
swing = span_row(&operation, 32);
if (elapsed + *cspan_at(&command, 1) + 0.501 * *cspan_at(&command, 14) < *cspan_at(&swing, 1)) {
return 0;
}
advance_swing(elapsed, *cspan_at(&known, 0, 3), swing, work);
cover_swing(operation, known, timing, coefficients, offsets, work);
return 1;
}
bool segfmu_foresee_emergency(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
array_double_1d command;
double elapsed;
bool result;
command = span_row(&operation, 0);
if (*cspan_at(&operation, 32, 0) > 0.5) {
return 1;
}
elapsed = *cspan_at(&command, 0) - *cspan_at(&operation, 4, 0);
note_present(elapsed, operation, timing, coefficients, offsets);
result = plan_emergency(operation, known, work);
return result;
}
static double way_left(double velocity, double rest, array_double_1d way) {
double result;
if (velocity > 0.0) {
result = *cspan_at(&way, 1) - rest;
return result;
}
if (velocity < 0.0) {
result = rest - *cspan_at(&way, 0);
return result;
}
return 1e+300;
}
static double room_left(int64_t axis, array_double_2d operation) {
double result;
result = way_left(*cspan_at(&operation, 26 + axis, 1), *cspan_at(&operation, 29 + axis, 0), span_row(&operation, 16 + axis));
return result;
}
static void hold_shares(array_double_2d operation) {
array_double_1d command, held;
double until, velocity, delay, room, hold;
int64_t axis;
command = span_row(&operation, 0);
until = *cspan_at(&command, 1) + *cspan_at(&command, 14);
for (axis = 0; axis < 3; axis += 1) {
held = span_row(&operation, 9 + axis);
velocity = *cspan_at(&operation, 22, axis) * *cspan_at(&operation, 12, axis);
delay = *cspan_at(&operation, 26 + axis, 3);
*cspan_at(&held, 0) = velocity;
*cspan_at(&held, 1) = delay;
*cspan_at(&held, 2) = 0.0;
if (fabs(velocity) > 0.0) {
room = span_max(room_left(axis, operation), 0.0);
hold = span_max(until - delay, 0.0);
if (hold * fabs(velocity) < room) {
*cspan_at(&held, 2) = 1.0;
}
else {
hold = room / fabs(velocity);
}
*cspan_at(&held, 1) = delay + hold;
}
}
}
static void shift_row(int64_t row, double later, double way, array_double_3d timing, array_double_3d coefficients) {
*cspan_at(&timing, 4, row, 0) = *cspan_at(&timing, 4, row, 0) + later;
*cspan_at(&coefficients, 4, row, 0) = *cspan_at(&coefficients, 4, row, 0) + way;
}
static bool join_held(array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
int64_t rows, tried, target, axis, leads, row, behind;
array_double_1d reached, held;
double hold, way;
rows = plan_pieces(2, offsets) + plan_pieces(3, offsets) + 3;
if (rows > 1200) {
return 0;
}
tried = 4 * 4;
target = 0;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&offsets, tried + axis) = target;
reached = span_row(&operation, 26 + axis);
held = span_row(&operation, 9 + axis);
hold = *cspan_at(&held, 1) - *cspan_at(&reached, 3);
leads = 2 * 4 + axis;
for (row = *cspan_at(&offsets, leads); row < *cspan_at(&offsets, leads + 1); row += 1) {
copy_piece(span_matrix(&timing, 2), span_matrix(&coefficients, 2), row, span_matrix(&timing, 4), span_matrix(&coefficients, 4), target);
target = target + 1;
}
clear_piece(span_matrix(&coefficients, 4), target);
*cspan_at(&coefficients, 4, target, 0) = *cspan_at(&reached, 0);
*cspan_at(&coefficients, 4, target, 1) = *cspan_at(&reached, 1);
*cspan_at(&timing, 4, target, 0) = *cspan_at(&reached, 3);
*cspan_at(&timing, 4, target, 1) = hold;
target = target + 1;
behind = 3 * 4 + axis;
*cspan_at(&held, 3) = *cspan_at(&offsets, behind + 1) - *cspan_at(&offsets, behind);
way = *cspan_at(&reached, 1) * hold;
for (row = *cspan_at(&offsets, behind); row < *cspan_at(&offsets, behind + 1); row += 1) {
copy_piece(span_matrix(&timing, 3), span_matrix(&coefficients, 3), row, span_matrix(&timing, 4), span_matrix(&coefficients, 4), target);
shift_row(target, *cspan_at(&held, 1), way, timing, coefficients);
target = target + 1;
}
}
*cspan_at(&offsets, tried + 3) = target;
return 1;
}
static bool holds_long_enough(double elapsed, array_double_2d operation) {
array_double_1d command, held;
double until;
int64_t axis;
command = span_row(&operation, 0);
until = elapsed + *cspan_at(&command, 1) + 0.501 * *cspan_at(&command, 14);
for (axis = 0; axis < 3; axis += 1) {
held = span_row(&operation, 6 + axis);
if ((*cspan_at(&held, 2) > 0.5) && (*cspan_at(&held, 1) < until)) {
return 0;
}
}
return 1;
}
static bool prolong_holds(double elapsed, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
array_double_1d command, held, way;
double until, before, velocity, rest, longest, longer;
int64_t axis, i, last, first, row;
command = span_row(&operation, 0);
until = *cspan_at(&command, 1) + *cspan_at(&command, 14);
if (!has_room(4, offsets)) {
return 0;
}
for (axis = 0; axis < 3; axis += 1) {
held = span_row(&operation, 9 + axis);
for (i = 0; i < 4; i += 1) {
*cspan_at(&held, i) = *cspan_at(&operation, 6 + axis, i);
}
for (i = 0; i < 2; i += 1) {
*cspan_at(&operation, 16 + axis, i) = *cspan_at(&operation, 13 + axis, i);
}
before = *cspan_at(&held, 1) - elapsed;
*cspan_at(&held, 1) = before;
if (*cspan_at(&held, 2) > 0.5) {
if (before <= 0.0) {
return 0;
}
velocity = *cspan_at(&held, 0);
last = *cspan_at(&offsets, 4 * 4 + axis + 1);
first = last - (int64_t)(*cspan_at(&held, 3));
rest = standstill(4, axis, timing, coefficients, offsets);
way = span_row(&operation, 16 + axis);
longest = span_max(way_left(velocity, rest, way), 0.0) / fabs(velocity);
longer = span_max(until - before, 0.0);
if (longest <= longer) {
longer = longest;
*cspan_at(&held, 2) = 0.0;
}
*cspan_at(&timing, 4, first - 1, 1) = *cspan_at(&timing, 4, first - 1, 1) + longer;
*cspan_at(&held, 1) = before + longer;
for (row = first; row < last; row += 1) {
shift_row(row, longer, velocity * longer, timing, coefficients);
}
}
}
return 1;
}
static bool is_calming(array_double_2d operation) {
bool result;
result = *cspan_at(&operation, 0, 0) < *cspan_at(&operation, 32, 31);
return result;
}
static bool aims_elsewhere(array_double_2d operation) {
bool result;
if (*cspan_at(&operation, 1, 0) > 0.5) {
result = !is_aim(3, operation);
return result;
}
result = *cspan_at(&operation, 3, 0) > 0.5;
return result;
}
static void note_calming(array_double_2d operation) {
array_double_1d progress;
int64_t mode;
progress = span_row(&operation, 4);
mode = wanted_mode(span_row(&operation, 0));
*cspan_at(&progress, 1) = 1;
if ((mode == 3) || ((mode == 1) && (!aims_elsewhere(operation)))) {
*cspan_at(&progress, 1) = 0;
}
}
static double next_calm(array_double_2d operation) {
array_double_1d progress;
double stands, result;
progress = span_row(&operation, 4);
stands = *cspan_at(&progress, 0) + stand_time(span_row(&operation, 32));
result = span_max(stands, *cspan_at(&progress, 4));
return result;
}
static bool wants_calm(array_double_2d operation) {
array_double_1d command;
int64_t mode;
bool result;
command = span_row(&operation, 0);
mode = wanted_mode(command);
if ((mode == 5) || (mode == 0)) {
return 0;
}
result = *cspan_at(&command, 0) >= next_calm(operation);
return result;
}
static void write_calm_aim(array_double_2d operation) {
array_double_1d command;
int64_t i;
command = span_row(&operation, 0);
for (i = 0; i < 5; i += 1) {
*cspan_at(&operation, 1, i) = 0.0;
}
if (((int64_t)(*cspan_at(&command, 2)) == 1) && (*cspan_at(&command, 10) >= 1.0)) {
write_target(1.0, span_row(&operation, 1), command);
}
}
static void follow_calm(array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
array_double_1d command, progress, swing;
int64_t axis, i;
command = span_row(&operation, 0);
progress = span_row(&operation, 4);
swing = span_row(&operation, 32);
copy_plan(4, 0, timing, coefficients, offsets);
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < 4; i += 1) {
*cspan_at(&operation, 6 + axis, i) = 0.0;
}
for (i = 0; i < 102; i += 1) {
*cspan_at(&operation, 35 + axis, i) = *cspan_at(&work, 140 + axis, i);
}
}
*cspan_at(&swing, 0) = 0.0;
*cspan_at(&swing, 31) = *cspan_at(&command, 0) + plan_end(0, 0, timing, offsets);
*cspan_at(&progress, 0) = *cspan_at(&command, 0);
*cspan_at(&progress, 14) = *cspan_at(&progress, 14) + 1.0;
*cspan_at(&progress, 3) = 0.0;
*cspan_at(&progress, 11) = 0.0;
for (i = 0; i < 5; i += 1) {
*cspan_at(&operation, 3, i) = *cspan_at(&operation, 1, i);
}
if (*cspan_at(&operation, 1, 0) < 0.5) {
*cspan_at(&operation, 3, 0) = -1.0;
}
write_calm_aim(operation);
note_calming(operation);
}
static bool try_calm(bool rests, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack) {
array_double_1d progress, aim;
double radian, retry;
int64_t status;
progress = span_row(&operation, 4);
aim = span_row(&operation, 1);
radian = 20.0 * resolved_step(*cspan_at(&known, 0, 3), span_row(&operation, 32));
retry = *cspan_at(&operation, 0, 0) + radian;
*cspan_at(&progress, 15) = *cspan_at(&progress, 15) + 1.0;
status = plan_calm(operation, known, timing, coefficients, offsets, work, stack);
if (status != 0) {
*cspan_at(&progress, 2) = status;
*cspan_at(&progress, 4) = retry;
}
if ((status != 0) && (*cspan_at(&aim, 0) > 0.5) && rests) {
*cspan_at(&aim, 0) = 0.0;
status = plan_calm(operation, known, timing, coefficients, offsets, work, stack);
}
if (status != 0) {
*cspan_at(&progress, 1) = status;
return 0;
}
follow_calm(operation, timing, coefficients, offsets, work);
return 1;
}
static void take_over(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack) {
advance_swing(elapsed, *cspan_at(&known, 0, 3), span_row(&operation, 32), work);
cover_swing(operation, known, timing, coefficients, offsets, work);
write_calm_aim(operation);
try_calm(1, operation, known, timing, coefficients, offsets, work, stack);
}
static void put_aside(array_double_2d operation) {
int64_t i;
for (i = 0; i < 32; i += 1) {
*cspan_at(&operation, 34, i) = *cspan_at(&operation, 32, i);
}
}
static void note_calm_state(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
array_double_1d swing, ahead;
double begin, interval, since, snap, jerk;
int64_t k, axis;
swing = span_row(&operation, 32);
ahead = span_row(&operation, 33);
begin = *cspan_at(&operation, 4, 0);
interval = (*cspan_at(&swing, 31) - begin) / 99;
k = span_min_int(span_max_int((int64_t)(elapsed / interval), 0), 99 - 1);
set_knot(k, interval, ahead, span_rows(&operation, 35, 38));
since = elapsed - k * interval;
note_present(elapsed, operation, timing, coefficients, offsets);
note_swing(operation, known, work);
for (axis = 0; axis < 3; axis += 1) {
snap = *cspan_at(&ahead, 14 + axis);
jerk = *cspan_at(&ahead, 11 + axis);
*cspan_at(&swing, 8 + axis) = *cspan_at(&ahead, 8 + axis) + (jerk + 0.5 * snap * since) * since;
*cspan_at(&swing, 11 + axis) = jerk + snap * since;
}
}
static void bring_back(array_double_2d operation) {
int64_t i;
for (i = 0; i < 32; i += 1) {
*cspan_at(&operation, 32, i) = *cspan_at(&operation, 34, i);
}
}
static bool calm_on(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack) {
bool straight;
write_calm_aim(operation);
if (!aims_elsewhere(operation)) {
note_calming(operation);
return 0;
}
if (*cspan_at(&operation, 0, 0) < *cspan_at(&operation, 4, 4)) {
note_calming(operation);
return 0;
}
put_aside(operation);
note_calm_state(elapsed, operation, known, timing, coefficients, offsets, work);
straight = *cspan_at(&operation, 3, 0) > 0.5;
if (try_calm(straight, operation, known, timing, coefficients, offsets, work, stack)) {
return 1;
}
bring_back(operation);
note_calming(operation);
return 0;
}
static bool is_hanging(array_double_1d command) {
int64_t i;
double length, paid_out;
for (i = 0; i < 10; i += 1) {
if (!(fabs(*cspan_at(&command, 21 + i)) < 1e+300)) {
return 0;
}
}
for (i = 0; i < 2; i += 1) {
if (!(fabs(*cspan_at(&command, 21 + 3 + i)) < 1.5)) {
return 0;
}
}
length = *cspan_at(&command, 21 + 0 + 2);
paid_out = *cspan_at(&command, 16) * *cspan_at(&command, 21 + 5 + 2);
return span_min(length, length + paid_out) > 0.0;
}
static int64_t state_status(array_double_1d command) {
int64_t axis;
if (!is_hanging(command)) {
return 3;
}
for (axis = 0; axis < 3; axis += 1) {
if (fabs(*cspan_at(&command, 21 + 0 + axis)) > 1000000.0) {
return 4;
}
}
return 0;
}
static void write_measured(array_double_2d operation, array_double_2d known, array_double_2d work) {
array_double_1d command, state, swing;
int64_t i, axis;
double length, stretch, sin_x, cos_x, sin_y, cos_y, rate_x, rate_y;
command = span_row(&operation, 0);
state = span_piece(&command, 21, 31);
swing = span_row(&operation, 32);
for (i = 0; i < 32; i += 1) {
*cspan_at(&swing, i) = 0.0;
}
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&swing, 2 + axis) = *cspan_at(&state, 0 + axis);
*cspan_at(&swing, 5 + axis) = *cspan_at(&state, 5 + axis);
*cspan_at(&swing, 17 + axis) = 1e+300;
}
length = *cspan_at(&state, 0 + 2);
stretch = *cspan_at(&state, 5 + 2);
sin_x = sin(*cspan_at(&state, 3));
cos_x = cos(*cspan_at(&state, 3));
sin_y = sin(*cspan_at(&state, 3 + 1));
cos_y = cos(*cspan_at(&state, 3 + 1));
rate_x = *cspan_at(&state, 8);
rate_y = *cspan_at(&state, 8 + 1);
*cspan_at(&swing, 20) = length * sin_x;
*cspan_at(&swing, 20 + 1) = (-length) * cos_x * sin_y;
*cspan_at(&swing, 20 + 2) = (-length) * cos_x * cos_y;
*cspan_at(&swing, 23) = stretch * sin_x + length * cos_x * rate_x;
*cspan_at(&swing, 23 + 1) = (-stretch) * cos_x * sin_y + length * (sin_x * sin_y * rate_x - cos_x * cos_y * rate_y);
*cspan_at(&swing, 23 + 2) = (-stretch) * cos_x * cos_y + length * (sin_x * cos_y * rate_x + cos_x * sin_y * rate_y);
advance_swing(*cspan_at(&command, 16), *cspan_at(&known, 0, 3), swing, work);
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&swing, 17 + axis) = 0.0;
}
}
int64_t segfmu_take_over_measured(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack) {
array_double_1d progress;
double retry;
int64_t refused;
progress = span_row(&operation, 4);
*cspan_at(&progress, 16) = *cspan_at(&operation, 0, 20);
refused = state_status(span_row(&operation, 0));
if (refused != 0) {
*cspan_at(&progress, 1) = refused;
*cspan_at(&progress, 2) = refused;
return refused;
}
put_aside(operation);
write_measured(operation, known, work);
write_calm_aim(operation);
retry = *cspan_at(&progress, 4);
if (try_calm(1, operation, known, timing, coefficients, offsets, work, stack)) {
return 0;
}
bring_back(operation);
*cspan_at(&progress, 4) = retry;
refused = (int64_t)(*cspan_at(&progress, 1));
return refused;
}
static bool takes_measured(array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work, array_double_3d stack) {
array_double_1d command, progress;
bool result;
command = span_row(&operation, 0);
progress = span_row(&operation, 4);
if (wanted_mode(command) == 5) {
return 0;
}
if (!(*cspan_at(&command, 20) > 0.5)) {
*cspan_at(&progress, 16) = 0.0;
return 0;
}
if (*cspan_at(&progress, 16) > 0.5) {
return 0;
}
result = segfmu_take_over_measured(operation, known, timing, coefficients, offsets, work, stack) == 0;
return result;
}
static bool keeps_at(double pace, double speed, double steepness, double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work) {
double power, share;
int64_t order, axis, place;
bool result;
write_load(time, time, timing, coefficients, offsets, work);
power = pace;
for (order = 1; order < 5; order += 1) {
share = power;
if ((order == 1) && (speed > 0.0)) {
share = speed;
}
for (axis = 0; axis < 3; axis += 1) {
place = 89 + 0 + 3 * order + axis;
*cspan_at(&work, place, 0) = share * *cspan_at(&work, place, 0);
}
power = power * pace;
if (order > 1) {
power = power * steepness;
}
}
if (!write_demands(span_row(&known, 0), work)) {
return 0;
}
result = judge_reach(0, 17, span_row(&known, 2), work) > 0;
return result;
}
static double pace_within(double speed, double steepness, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work) {
double time, until, at, low, tried, pace;
int64_t k, i;
pace = 1.0;
time = (*cspan_at(&timing, *cspan_at(&offsets, 0), 0));
until = interval_end(time, timing, offsets);
while(until > time) {
for (k = 0; k < 4; k += 1) {
at = time + (until - time) * k / 4;
low = 1.0;
tried = pace;
for (i = 0; i < 2 + 8; i += 1) {
if (keeps_at(tried, speed, steepness, at, timing, coefficients, offsets, known, work)) {
low = tried;
if (i == 0) {
break;
}
}
else {
if (i == 1) {
return 0.0;
}
pace = tried;
}
tried = 0.0625;
if (i > 0) {
tried = 0.5 * (low + pace);
}
}
pace = low;
}
time = until;
until = interval_end(time, timing, offsets);
}
return pace;
}
static int64_t ease_within(double* result_0, double* result_1, double* result_2, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work) {
double speed, best, steepest, least, steepness, pace, takes;
int64_t Dummy_0000;
speed = 1.0;
best = 1.0;
steepest = 1.0;
least = 1e+300;
for (Dummy_0000 = 0; Dummy_0000 < 2; Dummy_0000 += 1) {
steepness = 1.0;
while((1.0 + 0.5 / steepness < least) && (steepness > 0.01)) {
pace = pace_within(speed, steepness, timing, coefficients, offsets, known, work);
if (pace > 0.0) {
takes = 1.0 / (pace * pace) + 0.5 / (pace * steepness);
if (takes < least) {
least = takes;
best = pace;
steepest = steepness;
}
}
steepness = 0.25 * steepness;
}
if (least < 1e+300) {
(*result_0) = best;
(*result_1) = steepest;
(*result_2) = speed;
return 0;
}
speed = pace_within(0.0, 0.0, timing, coefficients, offsets, known, work);
if (speed == 0.0) {
break;
}
}
(*result_0) = 1.0;
(*result_1) = 1.0;
(*result_2) = 1.0;
return 0;
}
static int64_t level_gain(double* result_0, double* result_1_0001, double level, double a, double b, array_double_1d axis) {
double first, slope, last;
segfmu_ramp_duration(&first, &slope, level - a, axis);
segfmu_ramp_duration(&last, &slope, level - b, axis);
(*result_0) = first;
(*result_1_0001) = 0.5 * (a + level) * first + 0.5 * (level + b) * last;
return 0;
}
static double linear_level(double gain, double a, double b, array_double_1d axis) {
double slope, half, rest, square;
slope = *cspan_at(&axis, 16);
half = 0.5 * *cspan_at(&axis, 18);
rest = gain + 0.5 * slope * (a * a + b * b) - half * (a + b);
square = half * half + slope * rest;
if (square <= 0.0) {
return -1.0;
}
return rest / (half + sqrt(square));
}
static int64_t root_level(double* result_0_0001, double* result_1, double gain, double a, double b, double lower, double upper, double start, array_double_1d axis) {
double t, level, t_before, rate_before, change, growth, t_end, slope, first, second, error, rate, following, newton, bend, reached;
int64_t i;
bool far;
t = start;
level = a;
t_before = start;
rate_before = 0.0;
for (i = 0; i < 100; i += 1) {
ramp_change(&change, &growth, t, axis);
level = a + change;
segfmu_ramp_duration(&t_end, &slope, level - b, axis);
first = 0.5 * (a + level) * t;
second = 0.5 * (level + b) * t_end;
error = first + second - gain;
if (fabs(error) <= 2e-16 * (fabs(first) + fabs(second))) {
(*result_0_0001) = t;
(*result_1) = level;
return 0;
}
if (error > 0.0) {
upper = t;
}
else {
lower = t;
}
rate = 0.5 * (a + level) + 0.5 * growth * (t + t_end + (level + b) * slope);
following = 0.5 * (lower + upper);
if (rate > 0.0) {
newton = t - error / rate;
bend = i > 0 ? 0.5 * error / rate * (rate - rate_before) / (t - t_before) : 0.0;
if ((bend != 0.0) && (fabs(bend) < 0.5 * rate)) {
newton = t - error / (rate - bend);
}
if (fabs(newton - t) <= 1e-07 * t) {
ramp_change(&change, &growth, newton, axis);
(*result_0_0001) = newton;
(*result_1) = a + change;
return 0;
}
reached = first + second;
far = (reached > 0.0) && (gain > 0.0) && ((reached > 2.0 * gain) || (gain > 2.0 * reached));
if (far && (reached < t * rate)) {
newton = t * pow((gain / reached), (reached / (t * rate)));
if (span_floor_mod(i, 3) == 2) {
newton = sqrt(lower * upper);
}
}
if ((newton > lower) && (newton < upper)) {
following = newton;
}
}
if (fabs(following - t) <= 2e-16 * t) {
(*result_0_0001) = t;
(*result_1) = level;
return 0;
}
t_before = t;
rate_before = rate;
t = following;
}
ramp_change(&change, &growth, t, axis);
(*result_0_0001) = t;
(*result_1) = a + change;
return 0;
}
static int64_t solve_level(double* result_0_0001, double* result_1_0001, double* result_2_0001, double gain, double a, double b, double low, double high, double near, array_double_1d axis) {
double linear_from, level, t, t_high, most, t_low, least, start;
linear_from = *cspan_at(&axis, 15);
if (span_max(a, b) + linear_from <= high) {
level = linear_level(gain, a, b, axis);
if ((level >= span_max(a, b) + linear_from) && (level >= low) && (level <= high)) {
t = (level - a) * *cspan_at(&axis, 16) + *cspan_at(&axis, 18);
(*result_0_0001) = t;
(*result_1_0001) = 0.0;
(*result_2_0001) = level;
return 0;
}
}
level_gain(&t_high, &most, high, a, b, axis);
if (gain > most) {
(*result_0_0001) = t_high;
(*result_1_0001) = (gain - most) / high;
(*result_2_0001) = high;
return 0;
}
level_gain(&t_low, &least, low, a, b, axis);
if (gain <= least) {
if (gain < least - 1e-14 * (fabs(gain) + fabs(least))) {
(*result_0_0001) = 0.0;
(*result_1_0001) = -1.0;
(*result_2_0001) = low;
return 0;
}
(*result_0_0001) = t_low;
(*result_1_0001) = 0.0;
(*result_2_0001) = low;
return 0;
}
start = near;
if ((start <= t_low) || (start >= t_high)) {
start = t_low + (t_high - t_low) * sqrt((gain - least) / (most - least));
}
root_level(&t, &level, gain, a, b, t_low, t_high, start, axis);
(*result_0_0001) = t;
(*result_1_0001) = 0.0;
(*result_2_0001) = level;
return 0;
}
static int64_t member_distance(double* result_0_0001, double* result_1, array_double_1d family, array_double_1d axis) {
double v, a, b, t1, hold1, level1, hold2, level2, t3, basis, slope, t2, y;
v = *cspan_at(&family, 0);
a = *cspan_at(&family, 1);
b = *cspan_at(&family, 3);
t1 = *cspan_at(&family, 27);
hold1 = *cspan_at(&family, 28);
level1 = *cspan_at(&family, 29);
hold2 = *cspan_at(&family, 30);
level2 = *cspan_at(&family, 31);
t3 = *cspan_at(&family, 32);
segfmu_ramp_duration(&basis, &slope, fabs(level2 - level1), axis);
t2 = basis * *cspan_at(&family, 33);
basis = basis + *cspan_at(&family, 34) * (t2 - basis);
if (*cspan_at(&family, 16) != 0.0) {
(*result_0_0001) = t1 + hold1 + t2 + hold2 + t3;
(*result_1) = 0.0;
return 0;
}
y = ramp_distance(v, a, level1, t1, t1, axis);
v = v + 0.5 * (a + level1) * t1;
if (hold1 > 0.0) {
y = y + (v + 0.5 * level1 * hold1) * hold1;
v = v + level1 * hold1;
}
y = y + ramp_distance(v, level1, level2, t2, basis, axis);
v = v + 0.5 * (level1 + level2) * t2;
if (hold2 > 0.0) {
y = y + (v + 0.5 * level2 * hold2) * hold2;
v = v + level2 * hold2;
}
y = y + ramp_distance(v, level2, b, t3, t3, axis);
(*result_0_0001) = t1 + hold1 + t2 + hold2 + t3;
(*result_1) = y;
return 0;
}
static int64_t second_level(double* result_0, double* result_1, double* result_2, double* result_3, double p, array_double_1d family, array_double_1d axis) {
double b, last_ramp, hold, t, level, change, slope, gain;
b = *cspan_at(&family, 3);
last_ramp = *cspan_at(&family, 8);
hold = 0.0;
t = p;
if (p >= last_ramp) {
t = last_ramp;
hold = p - last_ramp;
level = -*cspan_at(&family, 7);
}
else {
ramp_change(&change, &slope, p, axis);
level = b - change;
}
gain = *cspan_at(&family, 2) - *cspan_at(&family, 0) - 0.5 * (level + b) * t - level * hold;
(*result_0) = level;
(*result_1) = t;
(*result_2) = hold;
(*result_3) = gain;
return 0;
}
static bool has_member(double p, array_double_1d family, array_double_1d axis) {
double a, level, t, hold, gain, first, least;
a = *cspan_at(&family, 1);
second_level(&level, &t, &hold, &gain, p, family, axis);
level_gain(&first, &least, span_max(0.0, span_max(a, level)), a, level, axis);
return gain >= least;
}
static int64_t canonical_member(double* result_0, double* result_1, double p, array_double_1d family, array_double_1d axis) {
double a, level2, t3, hold2, gain, low, near, t1, hold1, level1;
a = *cspan_at(&family, 1);
second_level(&level2, &t3, &hold2, &gain, p, family, axis);
low = span_max(0.0, span_max(a, level2));
near = *cspan_at(&family, 27);
solve_level(&t1, &hold1, &level1, gain, a, level2, low, *cspan_at(&family, 6), near, axis);
if (hold1 < 0.0) {
(*result_0) = -1.0;
(*result_1) = 0.0;
return 0;
}
*cspan_at(&family, 27) = t1;
*cspan_at(&family, 28) = hold1;
*cspan_at(&family, 29) = level1;
*cspan_at(&family, 30) = hold2;
*cspan_at(&family, 31) = level2;
*cspan_at(&family, 32) = t3;
member_distance(result_0, result_1, family, axis);
return 0;
}
static int64_t curved_part(double* result_0, double* result_1, double* result_2_0001, double s, array_double_1d axis) {
int64_t count, j, i;
double value, slope, integral;
count = (int64_t)(*cspan_at(&axis, 39));
value = 0.0;
slope = 0.0;
integral = 0.0;
for (j = 0; j < count; j += 1) {
i = count - 1 - j;
value = value * s + *cspan_at(&axis, 40 + i);
integral = integral * s + *cspan_at(&axis, 40 + i) / (i + 1.0);
if (i > 0) {
slope = slope * s + i * *cspan_at(&axis, 40 + i);
}
}
(*result_0) = value;
(*result_1) = slope;
(*result_2_0001) = integral * s;
return 0;
}
static double invert_curved_part(double value, double upper, array_double_1d axis) {
double low, high, at, slope, integral, step, newton, s;
int64_t i;
low = 0.0;
high = upper;
s = upper * sqrt(span_min(span_max(2.0 * value, 0.0), 1.0));
for (i = 0; i < 100; i += 1) {
curved_part(&at, &slope, &integral, s, axis);
if (at > value) {
high = s;
}
else {
low = s;
}
step = 0.5 * (low + high) - s;
if (slope > 0.0) {
newton = (value - at) / slope;
if ((s + newton >= low) && (s + newton <= high)) {
step = newton;
}
}
s = s + step;
if (fabs(step) <= 1e-07) {
return s;
}
}
return s;
}
static double extreme_gain(double a, double b, double duration, double basis, array_double_1d axis) {
double smaller, slowness;
smaller = span_min(fabs(a), fabs(b));
if (*cspan_at(&axis, 14) == 0.0) {
return 0.5 * smaller * duration;
}
slowness = (basis - inner_rise(basis, 0, axis)) * (duration / basis) / fabs(b - a);
return 0.5 * smaller * (duration + (smaller - fabs(b - a)) * slowness);
}
static double taylor(double t, double first, double second, double third, double fourth, double fifth) {
return t * (first + t / 2.0 * (second + t / 3.0 * (third + t / 4.0 * (fourth + t / 5.0 * fifth))));
}
static double crossing_time(double a, double length, double jerk, double snap, double crackle, double pop, double highest) {
double low, high, at, slope, step, newton, t;
int64_t i;
low = 0.0;
high = length;
t = 0.5 * length;
for (i = 0; i < 100; i += 1) {
at = a + taylor(t, jerk, snap, crackle, pop, highest);
if (at * a <= 0.0) {
high = t;
}
else {
low = t;
}
slope = jerk + taylor(t, snap, crackle, pop, highest, 0.0);
step = 0.5 * (low + high) - t;
if (slope * a < 0.0) {
newton = (-at) / slope;
if ((t + newton >= low) && (t + newton <= high)) {
step = newton;
}
}
t = t + step;
if (fabs(step) <= 1e-07 * length) {
break;
}
}
return t;
}
static double plateau_extreme_velocity(double v, double a, double change, double duration, double basis, array_double_1d axis) {
int64_t boxes, pieces, piece, level;
double jerk, snap, crackle, pop, highest, sign, length, peak, end, gain;
bool crossed;
boxes = (int64_t)(*cspan_at(&axis, 0)) - 1;
jerk = 0.0;
snap = 0.0;
crackle = 0.0;
pop = 0.0;
highest = 0.0;
pieces = rise_pieces(boxes);
for (piece = 1; piece < pieces + 1; piece += 1) {
held_level(&level, &sign, piece, boxes);
piece_peak(&length, &peak, level, 0, change, duration, basis, axis);
if (level == 0) {
jerk = sign * peak;
snap = 0.0;
crackle = 0.0;
pop = 0.0;
highest = 0.0;
}
else if (level == 1) {
snap = sign * peak;
crackle = 0.0;
pop = 0.0;
highest = 0.0;
}
else if (level == 2) {
crackle = sign * peak;
pop = 0.0;
highest = 0.0;
}
else if (level == 3) {
pop = sign * peak;
highest = 0.0;
}
else {
highest = sign * peak;
}
end = length;
gain = taylor(end, jerk, snap, crackle, pop, highest);
crossed = (a + gain) * change >= 0.0;
if (crossed) {
end = crossing_time(a, length, jerk, snap, crackle, pop, highest);
}
v = v + end * a;
v = v + end * taylor(end, jerk / 2.0, snap / 3.0, crackle / 4.0, pop / 5.0, highest / 6.0);
if (crossed) {
return v;
}
a = a + gain;
jerk = jerk + taylor(length, snap, crackle, pop, highest, 0.0);
snap = snap + taylor(length, crackle, pop, highest, 0.0, 0.0);
crackle = crackle + taylor(length, pop, highest, 0.0, 0.0, 0.0);
pop = pop + length * highest;
}
return v;
}
static double ramp_extreme_velocity(double v, double a, double b, double duration, double basis, array_double_1d axis) {
double start, first, change, s, value, slope, integral, result;
start = v;
first = a;
change = b - a;
if (fabs(a) > fabs(b)) {
start = v + 0.5 * (a + b) * duration;
first = -b;
}
if (*cspan_at(&axis, 14) != 0.0) {
result = plateau_extreme_velocity(start, first, change, duration, basis, axis);
return result;
}
if (*cspan_at(&axis, 39) == 2.0) {
return start - 0.5 * first * first * duration / change;
}
s = invert_curved_part((-first) / change, 0.5, axis);
curved_part(&value, &slope, &integral, s, axis);
return start + duration * (first * s + change * integral);
}
static double side_limit(int64_t order, double sign, array_double_1d axis) {
double result;
if ((order <= 2) && (sign < 0.0)) {
result = *cspan_at(&axis, 9 + order - 1);
return result;
}
result = *cspan_at(&axis, 2 + order - 1);
return result;
}
static double own_side(int64_t order, double sign, array_double_1d axis) {
if ((sign < 0.0) && (fabs(side_limit(order, sign, axis) - side_limit(order, 1.0, axis)) > 0.0)) {
return 1.0;
}
return 0.0;
}
static void set_lower(array_double_1d lower, array_double_1d axis) {
int64_t i;
for (i = 0; i < 2; i += 1) {
if (*cspan_at(&lower, i) > 0.0) {
*cspan_at(&axis, 9 + i) = *cspan_at(&lower, i);
}
}
}
static double fastest_velocity(array_double_1d axis) {
double result;
result = span_max(*cspan_at(&axis, 2), *cspan_at(&axis, 9));
return result;
}
static double slowest_velocity(array_double_1d axis) {
double result;
result = span_min(*cspan_at(&axis, 2), *cspan_at(&axis, 9));
return result;
}
static double top_acceleration(array_double_1d axis) {
double result;
result = span_max(*cspan_at(&axis, 3), *cspan_at(&axis, 9 + 1));
return result;
}
static bool is_beyond(double low, double high, double share, array_double_1d axis) {
bool result;
result = (low < (-*cspan_at(&axis, 9)) * share) || (high > *cspan_at(&axis, 2) * share);
return result;
}
static void exchange_sides(int64_t order, array_double_1d axis) {
double kept;
kept = *cspan_at(&axis, 2 + order - 1);
*cspan_at(&axis, 2 + order - 1) = *cspan_at(&axis, 9 + order - 1);
*cspan_at(&axis, 9 + order - 1) = kept;
}
static void reverse_axis(array_double_1d axis) {
exchange_sides(2, axis);
}
static void mirror_axis(array_double_1d axis) {
exchange_sides(1, axis);
exchange_sides(2, axis);
}
static double flush_tiny(double value, double scale) {
return fabs(value) <= 1e-30 * scale ? 0.0 : value;
}
static double boundary_value(double value, double lower, double upper) {
return span_min(span_max(flush_tiny(value, span_max(lower, upper)), -lower), upper);
}
static int64_t append_phase(array_double_2d phases, int64_t count, double duration, double basis, double start, double change, double above) {
if (duration <= 0.0) {
return count;
}
*cspan_at(&phases, count, 0) = duration;
*cspan_at(&phases, count, 1) = basis;
*cspan_at(&phases, count, 2) = start;
*cspan_at(&phases, count, 3) = change;
*cspan_at(&phases, count, 4) = above;
return count + 1;
}
static int64_t append_ramp(array_double_2d phases, int64_t count, double a, double b, double duration, array_double_1d axis) {
double change, slope;
int64_t result;
if (duration <= 0.0) {
return count;
}
ramp_change(&change, &slope, duration, axis);
if (b < a) {
change = -change;
}
result = append_phase(phases, count, duration, duration, a, change, 0.0);
return result;
}
static int64_t append_change(array_double_2d phases, int64_t count, double a, double b, array_double_1d axis) {
double duration, slope;
int64_t result;
segfmu_ramp_duration(&duration, &slope, fabs(b - a), axis);
result = append_phase(phases, count, duration, duration, a, b - a, 0.0);
return result;
}
static int64_t append_hold(array_double_2d phases, int64_t count, double a, double duration) {
int64_t result;
result = append_phase(phases, count, duration, 0.0, a, 0.0, 0.0);
return result;
}
static int64_t insert_hold(array_double_2d phases, int64_t count, int64_t row, double a, double duration) {
int64_t j, i, column;
if (duration <= 0.0) {
return count;
}
for (j = 0; j < count - row; j += 1) {
i = count - 1 - j;
for (column = 0; column < 5; column += 1) {
*cspan_at(&phases, i + 1, column) = *cspan_at(&phases, i, column);
}
}
append_hold(phases, row, a, duration);
return count + 1;
}
static void copy_phases(array_double_2d source, array_double_2d target, int64_t count) {
int64_t i, column;
for (i = 0; i < count; i += 1) {
for (column = 0; column < 5; column += 1) {
*cspan_at(&target, i, column) = *cspan_at(&source, i, column);
}
}
}
static int64_t join_phases(array_double_2d source, int64_t count, array_double_2d phases, int64_t used) {
int64_t i, column;
for (i = 0; i < count; i += 1) {
for (column = 0; column < 5; column += 1) {
*cspan_at(&phases, used + i, column) = *cspan_at(&source, i, column);
}
}
return used + count;
}
static void mirror_phases(array_double_2d phases, int64_t count) {
int64_t i;
for (i = 0; i < count; i += 1) {
*cspan_at(&phases, i, 2) = -*cspan_at(&phases, i, 2);
*cspan_at(&phases, i, 3) = -*cspan_at(&phases, i, 3);
}
}
static void reverse_phases(array_double_2d phases, int64_t first, int64_t count) {
int64_t i, column;
double kept, end;
for (i = 0; i < span_floor_div((count - first), 2); i += 1) {
for (column = 0; column < 5; column += 1) {
kept = *cspan_at(&phases, first + i, column);
*cspan_at(&phases, first + i, column) = *cspan_at(&phases, count - 1 - i, column);
*cspan_at(&phases, count - 1 - i, column) = kept;
}
}
for (i = first; i < count; i += 1) {
end = *cspan_at(&phases, i, 2) + *cspan_at(&phases, i, 3);
*cspan_at(&phases, i, 2) = -end;
if (*cspan_at(&phases, i, 4) == 1.0) {
*cspan_at(&phases, i, 2) = end;
*cspan_at(&phases, i, 3) = -*cspan_at(&phases, i, 3);
}
}
}
static void boundary_problem(array_double_1d problem, array_double_1d axis, array_double_1d cleaned) {
double fastest, backwards, top, bottom, velocity, acceleration, ramp, scale;
fastest = *cspan_at(&axis, 2);
backwards = *cspan_at(&axis, 9);
top = *cspan_at(&axis, 3);
bottom = *cspan_at(&axis, 9 + 1);
*cspan_at(&cleaned, 0) = boundary_value(*cspan_at(&problem, 0), backwards, fastest);
*cspan_at(&cleaned, 1) = boundary_value(*cspan_at(&problem, 1), bottom, top);
*cspan_at(&cleaned, 2) = boundary_value(*cspan_at(&problem, 2), backwards, fastest);
*cspan_at(&cleaned, 3) = boundary_value(*cspan_at(&problem, 3), bottom, top);
velocity = fastest_velocity(axis);
acceleration = top_acceleration(axis);
ramp = acceleration * *cspan_at(&axis, 13) * *cspan_at(&axis, 13);
scale = span_min(velocity * velocity / acceleration, ramp);
*cspan_at(&cleaned, 4) = flush_tiny(*cspan_at(&problem, 4), scale);
*cspan_at(&cleaned, 5) = *cspan_at(&problem, 5);
}
static double steepest_acceleration(double duration, array_double_1d problem, array_double_1d axis) {
double change, slope, steepest, result;
ramp_change(&change, &slope, 0.5 * duration, axis);
steepest = span_max(fabs(*cspan_at(&problem, 1)), fabs(*cspan_at(&problem, 3))) + change;
result = span_min(steepest, top_acceleration(axis));
return result;
}
static double speed_bound(double sign, double duration, array_double_1d problem, array_double_1d axis) {
double steepest, most, result;
steepest = steepest_acceleration(duration, problem, axis);
most = span_max(fabs(*cspan_at(&problem, 0)), fabs(*cspan_at(&problem, 2))) + steepest * 0.5 * duration;
result = span_min(side_limit(1, sign, axis), most);
return result;
}
static bool is_resting(array_double_1d problem, array_double_1d axis) {
double speed, acceleration;
bool result;
speed = fabs(*cspan_at(&problem, 0)) + fabs(*cspan_at(&problem, 2));
if (flush_tiny(speed, fastest_velocity(axis)) != 0.0) {
return 0;
}
acceleration = fabs(*cspan_at(&problem, 1)) + fabs(*cspan_at(&problem, 3));
result = flush_tiny(acceleration, top_acceleration(axis)) == 0.0;
return result;
}
int64_t segfmu_measure_phases(double* result_0, double* result_1, double* result_2_0001, double* result_3, double* result_4, array_double_2d phases, int64_t count, double v, double within_0001, array_double_1d axis) {
double total, y, lowest, highest, duration, basis, a, b, near, bound, extreme;
int64_t i;
total = 0.0;
y = 0.0;
lowest = v;
highest = v;
for (i = 0; i < count; i += 1) {
duration = *cspan_at(&phases, i, 0);
basis = *cspan_at(&phases, i, 1);
a = *cspan_at(&phases, i, 2);
b = a + *cspan_at(&phases, i, 3);
if (a * b < 0.0) {
near = fabs(a) > fabs(b) ? v + 0.5 * (a + b) * duration : v;
bound = near + extreme_gain(a, b, duration, basis, axis);
if (a < 0.0) {
bound = 2.0 * near - bound;
}
if ((bound > span_max(highest, within_0001)) || (bound < span_min(lowest, -within_0001))) {
extreme = ramp_extreme_velocity(v, a, b, duration, basis, axis);
lowest = span_min(lowest, extreme);
highest = span_max(highest, extreme);
}
}
y = y + ramp_distance(v, a, b, duration, basis, axis);
v = v + 0.5 * (a + b) * duration;
lowest = span_min(lowest, v);
highest = span_max(highest, v);
total = total + duration;
}
(*result_0) = total;
(*result_1) = y;
(*result_2_0001) = v;
(*result_3) = lowest;
(*result_4) = highest;
return 0;
}
static double total_duration(array_double_2d phases, int64_t count) {
int64_t i;
double total;
total = 0.0;
for (i = 0; i < count; i += 1) {
total = total + *cspan_at(&phases, i, 0);
}
return total;
}
static double valid_duration(array_double_2d phases, int64_t count, array_double_1d problem, array_double_1d axis) {
double distance, most, duration, y, end, lowest, highest, fastest;
distance = *cspan_at(&problem, 4);
most = slowest_velocity(axis) * (1.0 + 1e-12);
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, *cspan_at(&problem, 0), most, axis);
if (is_beyond(lowest, highest, 1.0 + 1e-12, axis)) {
return -1.0;
}
fastest = span_max(-lowest, highest);
if (fabs(end - *cspan_at(&problem, 2)) > 1e-12 * fastest) {
return -1.0;
}
return fabs(y - distance) > 1e-12 * (fabs(distance) + fastest * duration) ? -1.0 : duration;
}
static bool is_passing(array_double_2d phases, int64_t count, array_double_1d axis) {
int64_t i;
bool found;
found = 0;
for (i = 0; i < count; i += 1) {
if (*cspan_at(&phases, i, 3) != 0.0) {
if ((*cspan_at(&phases, i, 4) == 0.0) || (*cspan_at(&phases, i, 4) != *cspan_at(&axis, 38))) {
return 0;
}
found = 1;
}
}
return found;
}
static bool has_dip(array_double_2d phases, int64_t count) {
bool result;
if (count == 0) {
return 0;
}
result = (*cspan_at(&phases, 0, 4) != 0.0) || (*cspan_at(&phases, count - 1, 4) != 0.0);
return result;
}
static void stretch_phases(array_double_2d phases, int64_t count, double factor) {
int64_t i, j;
double power;
for (i = 0; i < count; i += 1) {
*cspan_at(&phases, i, 0) = *cspan_at(&phases, i, 0) * factor;
power = factor * factor;
for (j = 0; j < (int64_t)(*cspan_at(&phases, i, 4)); j += 1) {
power = power * factor;
}
*cspan_at(&phases, i, 2) = *cspan_at(&phases, i, 2) / power;
*cspan_at(&phases, i, 3) = *cspan_at(&phases, i, 3) / power;
}
}
static int64_t fit_duration(array_double_2d phases, int64_t count, double target) {
double total, duration;
int64_t i, i_0001, kept;
total = 0.0;
kept = 0;
for (i = 0; i < count; i += 1) {
duration = *cspan_at(&phases, i, 0);
if (duration > 1e-13 * target) {
for (i_0001 = 0; i_0001 < phases.shape[1]; i_0001 += 1) {
*cspan_at(&phases, kept, i_0001) = *cspan_at(&phases, i, i_0001);
}
total = total + duration;
kept = kept + 1;
}
}
for (i = 0; i < kept; i += 1) {
*cspan_at(&phases, i, 0) = *cspan_at(&phases, i, 0) * (target / total);
}
return kept;
}
static int64_t append_velocity_change(array_double_2d phases, int64_t count, double v, double a, double w, double top, double bottom, array_double_1d axis) {
double sign, t1, hold, level;
int64_t result;
sign = 1.0;
solve_level(&t1, &hold, &level, w - v, a, 0.0, span_max(0.0, a), top, -1.0, axis);
if (hold < 0.0) {
sign = -1.0;
solve_level(&t1, &hold, &level, v - w, -a, 0.0, span_max(0.0, -a), bottom, -1.0, axis);
if (hold < 0.0) {
return -1;
}
}
count = append_ramp(phases, count, a, sign * level, t1, axis);
count = append_hold(phases, count, sign * level, hold);
result = append_change(phases, count, sign * level, 0.0, axis);
return result;
}
static int64_t cruise_form(int64_t* result_0, int64_t* result_1, double* result_2, double* result_3, array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis) {
double v, top, bottom, w, b, duration, y, end, lowest, highest;
int64_t row, count;
v = *cspan_at(&problem, 0);
top = *cspan_at(&axis, 3);
bottom = *cspan_at(&axis, 9 + 1);
row = append_velocity_change(phases, 0, v, *cspan_at(&problem, 1), cruise, top, bottom, axis);
if (row < 0) {
(*result_0) = -1;
(*result_1) = 0;
(*result_2) = 0.0;
(*result_3) = 0.0;
return 0;
}
w = *cspan_at(&problem, 2);
b = *cspan_at(&problem, 3);
count = append_velocity_change(phases, row, w, -b, cruise, bottom, top, axis);
if (count < 0) {
(*result_0) = -1;
(*result_1) = 0;
(*result_2) = 0.0;
(*result_3) = 0.0;
return 0;
}
reverse_phases(phases, row, count);
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, v, 1e+300, axis);
(*result_0) = count;
(*result_1) = row;
(*result_2) = duration;
(*result_3) = y;
return 0;
}
static int64_t with_cruise(array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis) {
double distance, duration, y, hold;
int64_t count, row, result;
distance = *cspan_at(&problem, 4);
cruise_form(&count, &row, &duration, &y, phases, cruise, problem, axis);
if ((count < 0) || (cruise == 0.0)) {
return span_max_int(count, 0);
}
hold = (distance - y) / cruise;
if ((hold < 0.0) && (fabs(distance - y) > 1e-13 * fabs(distance))) {
return 0;
}
result = insert_hold(phases, count, row, 0.0, hold);
return result;
}
static int64_t vanishing_cruise(double short_0001, double far, double start, array_double_2d phases, array_double_1d problem, array_double_1d axis) {
double distance, newest, other, before, e_newest, e_other, e_before, middle, duration, y, error, lower, upper, cruise;
bool falls_short, missing;
int64_t i, count, row, result;
distance = *cspan_at(&problem, 4);
newest = short_0001;
other = far;
before = other;
e_newest = 0.0;
e_other = 0.0;
e_before = 0.0;
falls_short = 1;
for (i = 0; i < 100; i += 1) {
middle = i > 0 ? next_point(newest, other, before, e_newest, e_other, e_before) : start;
if ((middle - newest) * (middle - other) >= 0.0) {
if (i > 0) {
break;
}
middle = 0.5 * (newest + other);
}
cruise_form(&count, &row, &duration, &y, phases, middle, problem, axis);
error = y - distance;
missing = (count < 0) || (error < 0.0);
if (count < 0) {
error = 0.0;
}
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, missing != falls_short, middle, error, newest, other, e_newest, e_other);
falls_short = missing;
if ((count >= 0) && (fabs(error) <= 2e-15 * fabs(distance))) {
other = newest;
break;
}
}
lower = newest;
upper = other;
if (!falls_short) {
lower = other;
upper = newest;
}
cruise = lower;
if (cruise < 0.0) {
cruise = upper;
}
result = with_cruise(phases, cruise, problem, axis);
return result;
}
static int64_t slower_cruise(array_double_2d phases, array_double_1d problem, array_double_1d axis) {
double start, slowest;
int64_t result;
start = span_max(*cspan_at(&problem, 0), *cspan_at(&problem, 2));
slowest = -*cspan_at(&axis, 9);
result = vanishing_cruise(slowest, *cspan_at(&axis, 2), start, phases, problem, axis);
return result;
}
static int64_t shorter_cruise(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d trial) {
double distance, longest, fastest, backwards, before, e_before, cruise, duration, y, error, short_0001, far;
int64_t i, used, row;
distance = *cspan_at(&problem, 4);
longest = 1e+300;
fastest = *cspan_at(&axis, 2);
backwards = *cspan_at(&axis, 9);
if (count > 0) {
longest = total_duration(phases, count);
fastest = speed_bound(1.0, longest, problem, axis);
backwards = speed_bound(-1.0, longest, problem, axis);
}
before = 0.0;
e_before = 0.0;
for (i = 0; i < 2 * 6 + 1; i += 1) {
cruise = fastest * (1.0 - i / 6.0);
if (i > 6) {
cruise = backwards * (1.0 - i / 6.0);
}
cruise_form(&used, &row, &duration, &y, trial, cruise, problem, axis);
error = used >= 0 ? y - distance : 0.0;
if (error * e_before < 0.0) {
short_0001 = cruise;
far = before;
if (e_before < 0.0) {
short_0001 = before;
far = cruise;
}
used = vanishing_cruise(short_0001, far, 0.5 * (short_0001 + far), trial, problem, axis);
duration = -1.0;
if (used > 0) {
duration = valid_duration(trial, used, problem, axis);
}
if ((duration >= 0.0) && (duration < longest * (1.0 - 1e-10))) {
copy_phases(trial, phases, used);
count = used;
longest = duration;
}
}
before = cruise;
e_before = error;
}
return count;
}
static double set_loop(array_double_1d problem, array_double_1d axis, array_double_1d family) {
double v, a, w, b, single, slope, missing, sign, top, bottom;
v = *cspan_at(&problem, 0);
a = *cspan_at(&problem, 1);
w = *cspan_at(&problem, 2);
b = *cspan_at(&problem, 3);
segfmu_ramp_duration(&single, &slope, fabs(b - a), axis);
missing = w - v - 0.5 * (a + b) * single;
sign = missing < 0.0 ? -1.0 : 1.0;
*cspan_at(&family, 0) = sign * v;
*cspan_at(&family, 1) = sign * a;
*cspan_at(&family, 2) = sign * w;
*cspan_at(&family, 3) = sign * b;
*cspan_at(&family, 16) = 0.0;
*cspan_at(&family, 17) = sign * *cspan_at(&problem, 4);
top = side_limit(2, sign, axis);
bottom = side_limit(2, -sign, axis);
*cspan_at(&family, 4) = top;
*cspan_at(&family, 5) = bottom;
*cspan_at(&family, 13) = v;
*cspan_at(&family, 14) = 0.0;
*cspan_at(&family, 15) = 0.5 - 0.5 * sign;
segfmu_ramp_duration(cspan_at(&family, 9), &slope, top - sign * a, axis);
segfmu_ramp_duration(cspan_at(&family, 10), &slope, bottom + sign * a, axis);
segfmu_ramp_duration(cspan_at(&family, 11), &slope, top - sign * b, axis);
segfmu_ramp_duration(cspan_at(&family, 12), &slope, bottom + sign * b, axis);
return sign * missing;
}
static int64_t level_from(double* result_0_0001, double* result_1_0001, double* result_2_0001, double a, double time, double up, double down, array_double_1d family, array_double_1d axis) {
double change, slope;
if (time >= up) {
(*result_0_0001) = up;
(*result_1_0001) = time - up;
(*result_2_0001) = *cspan_at(&family, 4);
return 0;
}
if (-time >= down) {
(*result_0_0001) = down;
(*result_1_0001) = (-time) - down;
(*result_2_0001) = -*cspan_at(&family, 5);
return 0;
}
ramp_change(&change, &slope, fabs(time), axis);
if (time < 0.0) {
(*result_0_0001) = -time;
(*result_1_0001) = 0.0;
(*result_2_0001) = a - change;
return 0;
}
(*result_0_0001) = time;
(*result_1_0001) = 0.0;
(*result_2_0001) = a + change;
return 0;
}
static double set_point(double place, double radius, array_double_1d family, array_double_1d axis) {
double part, p_sign, q_sign, a, b, t1, hold1, level1, t3, hold2, level2, t2, slope, gain, result;
part = place;
p_sign = 1.0;
q_sign = 1.0;
if (place >= 3.0) {
part = 4.0 - place;
q_sign = -1.0;
}
else if (place >= 2.0) {
part = place - 2.0;
p_sign = -1.0;
q_sign = -1.0;
}
else if (place >= 1.0) {
part = 2.0 - place;
p_sign = -1.0;
}
a = *cspan_at(&family, 1);
b = *cspan_at(&family, 3);
level_from(&t1, &hold1, &level1, a, p_sign * radius * (1.0 - part), *cspan_at(&family, 9), *cspan_at(&family, 10), family, axis);
level_from(&t3, &hold2, &level2, b, q_sign * radius * part, *cspan_at(&family, 11), *cspan_at(&family, 12), family, axis);
segfmu_ramp_duration(&t2, &slope, fabs(level2 - level1), axis);
*cspan_at(&family, 27) = t1;
*cspan_at(&family, 28) = hold1;
*cspan_at(&family, 29) = level1;
*cspan_at(&family, 30) = hold2;
*cspan_at(&family, 31) = level2;
*cspan_at(&family, 32) = t3;
gain = 0.5 * ((a + level1) * t1 + (level1 + level2) * t2 + (level2 + b) * t3);
gain = gain + level1 * hold1 + level2 * hold2;
result = gain - (*cspan_at(&family, 2) - *cspan_at(&family, 0));
return result;
}
static double loop_radius(int64_t arc, double place, double accuracy, double missing, double largest, array_double_1d family, array_double_1d axis) {
double lower, e_lower, upper, e_upper, other, before, e_newest, e_other, e_before, scale, most, radius, error, newest;
int64_t i;
lower = 0.0;
e_lower = -missing;
upper = span_max(0.25 * missing / *cspan_at(&family, 4), 1e-07 * largest);
upper = span_min(upper, 0.25 * largest);
e_upper = set_point(place, upper, family, axis);
while((e_upper < 0.0) || (arc == 6)) {
if (!(upper < largest)) {
return -1.0;
}
lower = upper;
e_lower = e_upper;
upper = span_min(2.0 * upper, largest);
e_upper = set_point(place, upper, family, axis);
if ((arc == 6) && (e_lower >= 0.0) && (e_upper < 0.0)) {
break;
}
}
newest = upper;
other = lower;
before = lower;
e_newest = e_upper;
e_other = e_lower;
e_before = e_lower;
scale = fabs(*cspan_at(&family, 0)) + fabs(*cspan_at(&family, 2)) + missing;
most = span_max(2e-16 * scale, accuracy * missing);
for (i = 0; i < 100; i += 1) {
if ((fabs(e_newest) <= most) || (fabs(other - newest) <= 2e-16 * newest)) {
break;
}
radius = next_point(newest, other, before, e_newest, e_other, e_before);
error = set_point(place, radius, family, axis);
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, error * e_newest < 0.0, radius, error, newest, other, e_newest, e_other);
}
return newest;
}
static bool slow_middle(double place, double radius, array_double_1d family, array_double_1d axis) {
double error, level1, level2, fastest, slope, mean, stretch;
error = set_point(place, radius, family, axis);
level1 = *cspan_at(&family, 29);
level2 = *cspan_at(&family, 31);
segfmu_ramp_duration(&fastest, &slope, fabs(level2 - level1), axis);
mean = 0.5 * (level1 + level2);
if (fastest <= 0.0) {
return 0;
}
if (mean != 0.0) {
stretch = 1.0 - error / (mean * fastest);
}
else if ((*cspan_at(&family, 16) != 0.0) && (radius == 0.0) && (error == 0.0)) {
stretch = *cspan_at(&family, 17) / fastest;
}
else {
return 0;
}
*cspan_at(&family, 33) = stretch;
return stretch >= 1.0;
}
void segfmu_axis_limits(int64_t smoothness, int64_t shape, array_double_1d limits, array_double_1d axis) {
int64_t i;
for (i = 0; i < 50; i += 1) {
*cspan_at(&axis, i) = 0.0;
}
*cspan_at(&axis, 0) = smoothness;
*cspan_at(&axis, 1) = shape;
for (i = 0; i < smoothness + 1; i += 1) {
*cspan_at(&axis, 2 + i) = *cspan_at(&limits, i);
}
for (i = 0; i < 2; i += 1) {
*cspan_at(&axis, 9 + i) = *cspan_at(&limits, i);
}
}
static double usual_share(array_double_1d axis) {
int64_t raised;
raised = (int64_t)(*cspan_at(&axis, 11));
if ((*cspan_at(&axis, 0) + raised == 4.0) && (raised < 2) && (*cspan_at(&axis, 4 + 1 - raised) > 0.0)) {
return 0.5 * 0.1;
}
return 0.1;
}
static double moderate_share(void) {
return 0.2 * 0.1;
}
static double steepest_share(void) {
return 0.2 * moderate_share();
}
static bool ramps_suffice(array_double_1d axis) {
bool result;
result = *cspan_at(&axis, 21 + 1) == 0.0;
return result;
}
static bool snap_is_last(array_double_1d axis) {
bool result;
result = (*cspan_at(&axis, 26) == 0.0) && ramps_suffice(axis);
return result;
}
static double saving(array_double_1d axis) {
double result;
result = 0.6 * *cspan_at(&axis, 26 + 1);
return result;
}
static bool plateau_parameters(double share, array_double_1d axis) {
int64_t boxes, last, level, i;
double limit, rise, slope, time, variance, fourth, jerk;
boxes = (int64_t)(*cspan_at(&axis, 0)) - 1;
*cspan_at(&axis, 14) = 1.0;
last = -1;
for (level = 0; level < boxes; level += 1) {
if (*cspan_at(&axis, 4 + level) > 0.0) {
last = level;
}
}
if (last < 0) {
return 0;
}
*cspan_at(&axis, 38) = span_min_int(span_floor_div((last + 1), 2), 2);
for (level = 0; level < boxes - 1; level += 1) {
if ((level > 0) || (last == 0)) {
*cspan_at(&axis, 26 + level) = share;
if (level > last) {
*cspan_at(&axis, 26 + level) = span_max(share, usual_share(axis));
}
if ((level + *cspan_at(&axis, 11) == 2.0) && (last + *cspan_at(&axis, 11) >= 2.0)) {
*cspan_at(&axis, 26 + level) = 0.2 * share;
}
}
}
for (i = 0; i < last; i += 1) {
level = last - 1 - i;
limit = *cspan_at(&axis, 4 + level);
rise = 1e+60;
if (limit > 0.0) {
plateau_duration(&rise, &slope, limit, level + 1, axis);
}
*cspan_at(&axis, 21 + level) = rise;
}
if (last == 1) {
*cspan_at(&axis, 20) = 0.25 * *cspan_at(&axis, 4 + 1) * (1.0 - *cspan_at(&axis, 26 + 1));
*cspan_at(&axis, 19) = 1.0 / *cspan_at(&axis, 20);
}
if (last <= 1) {
time = last == 1 ? *cspan_at(&axis, 21) : 1.0;
rise_moments(&variance, &fourth, time, 0, axis);
*cspan_at(&axis, 36) = variance / (time * time);
}
jerk = *cspan_at(&axis, 4);
if (jerk > 0.0) {
rise = *cspan_at(&axis, 21);
*cspan_at(&axis, 15) = jerk * rise;
*cspan_at(&axis, 17) = jerk * (1.0 - *cspan_at(&axis, 26));
*cspan_at(&axis, 16) = 1.0 / *cspan_at(&axis, 17);
*cspan_at(&axis, 18) = rise;
if (rise > 0.0) {
rise_moments(cspan_at(&axis, 37), &fourth, rise, 1, axis);
}
}
return 1;
}
static bool smoothstep_parameters(array_double_1d axis, array_double_1d psi, array_double_1d peaks) {
int64_t k, j, e;
double limit, slope, change;
bool bounded;
k = (int64_t)(*cspan_at(&axis, 0)) - 2;
bounded = 0;
transition_peaks(k, psi, peaks);
*cspan_at(&axis, 39) = 2.0 * k + 2.0;
for (j = 0; j < 2 * k + 2; j += 1) {
*cspan_at(&axis, 40 + j) = *cspan_at(&psi, j);
}
*cspan_at(&axis, 36) = 1.0 / (4.0 * (2 * k + 3));
for (j = 1; j < k + 2; j += 1) {
limit = *cspan_at(&axis, 4 + j - 1);
if (limit > 0.0) {
*cspan_at(&axis, 31 + j - 1) = *cspan_at(&peaks, j) / limit;
bounded = 1;
}
}
slope = *cspan_at(&axis, 31);
if (slope > 0.0) {
*cspan_at(&axis, 15) = 0.0;
*cspan_at(&axis, 16) = slope;
*cspan_at(&axis, 17) = 1.0 / slope;
for (e = 2; e < k + 2; e += 1) {
change = pow((*cspan_at(&axis, 31 + e - 1) / pow(slope, (double)(e))), (1.0 / (e - 1)));
*cspan_at(&axis, 15) = span_max(*cspan_at(&axis, 15), change);
}
}
return bounded;
}
bool segfmu_ramp_parameters(double share, array_double_1d axis, array_double_2d work) {
int64_t i;
double duration, slope;
bool bounded;
for (i = 13; i < 50; i += 1) {
*cspan_at(&axis, i) = 0.0;
}
*cspan_at(&axis, 15) = 1e+300;
bounded = 0;
if ((int64_t)(*cspan_at(&axis, 1)) == 1) {
bounded = plateau_parameters(share, axis);
}
else {
bounded = smoothstep_parameters(axis, span_row(&work, 0), span_row(&work, 1));
}
if (bounded) {
segfmu_ramp_duration(&duration, &slope, top_acceleration(axis), axis);
*cspan_at(&axis, 13) = duration;
}
return bounded;
}
static double window_edge(double inside, double outside, array_double_1d family, array_double_1d axis) {
int64_t i;
double middle;
for (i = 0; i < 100; i += 1) {
middle = 0.5 * (inside + outside);
if (fabs(inside - outside) <= 1e-09 * middle) {
break;
}
if (has_member(middle, family, axis)) {
inside = middle;
}
else {
outside = middle;
}
}
return inside;
}
static int64_t canonical_value(double* result_0_0001, double* result_1, double p, array_double_1d family, array_double_1d axis) {
double duration, y;
canonical_member(&duration, &y, p, family, axis);
if (*cspan_at(&family, 16) != 0.0) {
(*result_0_0001) = duration;
(*result_1) = duration;
return 0;
}
(*result_0_0001) = y;
(*result_1) = duration;
return 0;
}
static double bracketed_root(double lower, double upper, double f_lower, double f_upper, array_double_1d family, array_double_1d axis) {
double target, newest, e_newest, other, e_other, before, e_before, speed, p, value, duration, error;
int64_t i;
target = *cspan_at(&family, 17);
newest = upper;
e_newest = f_upper - target;
other = lower;
e_other = f_lower - target;
before = lower;
e_before = e_other;
speed = *cspan_at(&family, 16) != 0.0 ? 0.0 : fabs(*cspan_at(&family, 0)) + fabs(*cspan_at(&family, 2));
for (i = 0; i < 100; i += 1) {
if ((e_newest == 0.0) || (fabs(newest - other) <= 2e-16 * fabs(newest))) {
break;
}
p = next_point(newest, other, before, e_newest, e_other, e_before);
canonical_value(&value, &duration, p, family, axis);
error = value - target;
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, error * e_newest < 0.0, p, error, newest, other, e_newest, e_other);
if (fabs(error) <= 2e-15 * (fabs(target) + speed * duration)) {
break;
}
}
return fabs(e_other) < fabs(e_newest) ? other : newest;
}
static int64_t highest_member(double* result_0_0001, double* result_1_0001, double lower, double upper, array_double_1d family, array_double_1d axis) {
double p, q, f_p, duration, f_q;
int64_t i;
p = upper - 0.6180339887498949 * (upper - lower);
q = lower + 0.6180339887498949 * (upper - lower);
canonical_value(&f_p, &duration, p, family, axis);
canonical_value(&f_q, &duration, q, family, axis);
for (i = 0; i < 30; i += 1) {
if (span_max(f_p, f_q) >= *cspan_at(&family, 17)) {
break;
}
if (f_p >= f_q) {
upper = q;
q = p;
f_q = f_p;
p = upper - 0.6180339887498949 * (upper - lower);
canonical_value(&f_p, &duration, p, family, axis);
}
else {
lower = p;
p = q;
f_p = f_q;
q = lower + 0.6180339887498949 * (upper - lower);
canonical_value(&f_q, &duration, q, family, axis);
}
}
if (f_p >= f_q) {
(*result_0_0001) = p;
(*result_1_0001) = f_p;
return 0;
}
(*result_0_0001) = q;
(*result_1_0001) = f_q;
return 0;
}
static double rising_member(double f_start, double end, array_double_1d family, array_double_1d axis) {
double target, step, before, f_lower, value, duration, bend, p, highest, result;
int64_t i;
target = *cspan_at(&family, 17);
step = end / 12;
before = f_start;
f_lower = f_start;
for (i = 1; i < 12 + 1; i += 1) {
canonical_value(&value, &duration, i * step, family, axis);
if ((value >= target) && (value > f_lower)) {
result = bracketed_root((i - 1) * step, i * step, f_lower, value, family, axis);
return result;
}
bend = 2.0 * f_lower - before - value;
if ((i > 1) && (f_lower >= span_max(before, value)) && (target <= f_lower + 0.25 * bend)) {
highest_member(&p, &highest, (i - 2) * step, i * step, family, axis);
if ((highest >= target) && (highest > before)) {
result = bracketed_root((i - 2) * step, p, before, highest, family, axis);
return result;
}
}
before = f_lower;
f_lower = value;
}
return -1.0;
}
static void note_near(double y, double duration, array_double_1d family, array_double_1d axis) {
double speed;
speed = fabs(*cspan_at(&family, 0)) + fabs(*cspan_at(&family, 2));
speed = speed + (fabs(*cspan_at(&family, 1)) + fabs(*cspan_at(&family, 3))) * duration;
if (fabs(y - *cspan_at(&family, 17)) <= saving(axis) * speed * duration) {
*cspan_at(&family, 21) = 2;
}
}
static int64_t first_window(double* result_0, double* result_1, double f_start, double t_zero, array_double_1d family, array_double_1d axis) {
double target, value, duration, end, going_on, p;
target = *cspan_at(&family, 17);
canonical_value(&value, &duration, t_zero, family, axis);
end = t_zero;
going_on = t_zero;
if (duration < 0.0) {
end = window_edge(0.0, t_zero, family, axis);
canonical_value(&value, &duration, end, family, axis);
going_on = -1.0;
}
if (*cspan_at(&family, 0) < 0.0) {
p = rising_member(f_start, end, family, axis);
if (p >= 0.0) {
(*result_0) = p;
(*result_1) = going_on;
return 0;
}
}
if ((value >= target) && (value > f_start)) {
p = bracketed_root(0.0, end, f_start, value, family, axis);
(*result_0) = p;
(*result_1) = going_on;
return 0;
}
if (going_on < 0.0) {
note_near(value, duration, family, axis);
}
(*result_0) = -1.0;
(*result_1) = going_on;
return 0;
}
static bool only_farther(array_double_1d family) {
double gain, loss;
bool result;
if (*cspan_at(&family, 3) > 0.0) {
return 0;
}
gain = 0.5 * (*cspan_at(&family, 1) + *cspan_at(&family, 29)) * *cspan_at(&family, 27);
gain = gain + *cspan_at(&family, 29) * *cspan_at(&family, 28);
loss = 0.5 * (*cspan_at(&family, 31) + *cspan_at(&family, 3)) * *cspan_at(&family, 32);
loss = loss + *cspan_at(&family, 31) * *cspan_at(&family, 30);
result = (*cspan_at(&family, 0) + gain >= 0.0) || (*cspan_at(&family, 2) - loss >= 0.0);
return result;
}
static double shorter_member(double f_start, array_double_1d family, array_double_1d axis) {
double span, p, value, duration, result;
int64_t i;
span = span_max(*cspan_at(&family, 8), *cspan_at(&axis, 13));
for (i = 1; i < 12 + 1; i += 1) {
if (only_farther(family)) {
return -1.0;
}
p = span * i * i / (12 * 12);
canonical_value(&value, &duration, p, family, axis);
if (duration < 0.0) {
return -1.0;
}
if (value <= *cspan_at(&family, 17)) {
result = bracketed_root(p, 0.0, value, f_start, family, axis);
return result;
}
}
return -1.0;
}
static void note_near_gain(array_double_1d family, array_double_1d axis) {
double a, b, low, first, least;
a = *cspan_at(&family, 1);
b = *cspan_at(&family, 3);
low = span_max(0.0, span_max(a, b));
level_gain(&first, &least, low, a, b, axis);
if (*cspan_at(&family, 2) - *cspan_at(&family, 0) >= (1.0 - saving(axis)) * least) {
*cspan_at(&family, 21) = 2;
}
}
static double second_window(double t_zero, array_double_1d family, array_double_1d axis) {
double upper, value, duration, result;
int64_t i;
upper = *cspan_at(&family, 8);
canonical_value(&value, &duration, upper, family, axis);
for (i = 0; i < 100; i += 1) {
if (duration >= 0.0) {
break;
}
upper = 2.0 * upper;
canonical_value(&value, &duration, upper, family, axis);
}
result = window_edge(upper, t_zero, family, axis);
return result;
}
static double farther_member(double lower, double f_lower, array_double_1d family, array_double_1d axis) {
double upper, f_upper, duration, result;
int64_t i;
upper = span_max(*cspan_at(&family, 8), *cspan_at(&axis, 13));
if (upper <= lower) {
upper = 2.0 * lower;
}
for (i = 0; i < 100; i += 1) {
canonical_value(&f_upper, &duration, upper, family, axis);
if (f_upper >= *cspan_at(&family, 17)) {
result = bracketed_root(lower, upper, f_lower, f_upper, family, axis);
return result;
}
lower = upper;
f_lower = f_upper;
upper = 2.0 * upper;
}
return -1.0;
}
static double canonical_search(array_double_1d family, array_double_1d axis) {
double target, v, w, f_lower, duration, lower, t_zero, slope, p;
target = *cspan_at(&family, 17);
v = *cspan_at(&family, 0);
w = *cspan_at(&family, 2);
canonical_value(&f_lower, &duration, 0.0, family, axis);
if (duration < 0.0) {
note_near_gain(family, axis);
return -1.0;
}
if (fabs(f_lower - target) <= 1e-14 * (fabs(target) + (fabs(v) + fabs(w)) * duration)) {
return 0.0;
}
if (f_lower > target) {
note_near(f_lower, duration, family, axis);
if ((v >= 0.0) && (w >= 0.0)) {
return -1.0;
}
p = shorter_member(f_lower, family, axis);
return p;
}
lower = 0.0;
if (*cspan_at(&family, 3) > 0.0) {
segfmu_ramp_duration(&t_zero, &slope, *cspan_at(&family, 3), axis);
first_window(&p, &lower, f_lower, t_zero, family, axis);
if (p >= 0.0) {
return p;
}
if (lower < 0.0) {
lower = second_window(t_zero, family, axis);
}
canonical_value(&f_lower, &duration, lower, family, axis);
if (f_lower > target) {
return -1.0;
}
}
p = farther_member(lower, f_lower, family, axis);
return p;
}
static double member_search(array_double_1d family, array_double_1d axis) {
double target, lower, f_lower, p, value, duration, upper, f_upper, outside, result;
int64_t passed, begin, i;
bool whole, inside, found;
target = *cspan_at(&family, 17);
passed = 0;
begin = 0;
lower = -1.0;
f_lower = 0.0;
whole = *cspan_at(&family, 6) == *cspan_at(&family, 4);
if (whole && ((int64_t)(*cspan_at(&family, 18)) > 0)) {
passed = (int64_t)(*cspan_at(&family, 18));
begin = (int64_t)(*cspan_at(&family, 23));
lower = *cspan_at(&family, 24);
f_lower = *cspan_at(&family, 25);
if ((begin > 12 + 1) && (lower >= 0.0) && (f_lower > target)) {
return -1.0;
}
}
p = 0.0;
for (i = begin; i < 3 * 12; i += 1) {
p = *cspan_at(&family, 19) * i * i / (12 * 12);
canonical_value(&value, &duration, p, family, axis);
upper = p;
f_upper = value;
inside = duration >= 0.0;
if (inside && (lower < 0.0) && (i > 0)) {
outside = *cspan_at(&family, 19) * (i - 1) * (i - 1) / (12 * 12);
lower = window_edge(p, outside, family, axis);
canonical_value(&f_lower, &duration, lower, family, axis);
}
if ((!inside) && (lower >= 0.0)) {
upper = window_edge(lower, p, family, axis);
canonical_value(&f_upper, &duration, upper, family, axis);
}
found = (lower >= 0.0) && ((f_lower - target) * (f_upper - target) <= 0.0);
found = found && (f_upper != f_lower);
if (found && (passed == (int64_t)(*cspan_at(&family, 18)))) {
if (whole) {
*cspan_at(&family, 23) = i + 1;
*cspan_at(&family, 24) = inside ? p : -1.0;
*cspan_at(&family, 25) = f_upper;
}
if (f_upper > f_lower) {
result = bracketed_root(lower, upper, f_lower, f_upper, family, axis);
return result;
}
result = bracketed_root(upper, lower, f_upper, f_lower, family, axis);
return result;
}
if (found) {
passed = passed + 1;
}
lower = -1.0;
if (inside) {
lower = p;
f_lower = value;
if ((i > 12) && (value > target)) {
return -1.0;
}
}
}
return -1.0;
}
static void set_family(int64_t branch, array_double_1d problem, array_double_1d axis, array_double_1d family) {
bool reverse, mirror;
double v, a, w, b, distance, top, bottom, last_ramp, slope;
reverse = (branch == 1) || (branch == 2);
mirror = branch >= 2;
v = *cspan_at(&problem, 0);
a = *cspan_at(&problem, 1);
w = *cspan_at(&problem, 2);
b = *cspan_at(&problem, 3);
distance = *cspan_at(&problem, 4);
*cspan_at(&family, 13) = v;
if (reverse) {
v = *cspan_at(&problem, 2);
a = -*cspan_at(&problem, 3);
w = *cspan_at(&problem, 0);
b = -*cspan_at(&problem, 1);
}
if (mirror) {
v = -v;
a = -a;
w = -w;
b = -b;
distance = -distance;
}
top = *cspan_at(&axis, 3);
bottom = *cspan_at(&axis, 9 + 1);
if (reverse != mirror) {
top = *cspan_at(&axis, 9 + 1);
bottom = *cspan_at(&axis, 3);
}
segfmu_ramp_duration(&last_ramp, &slope, b + bottom, axis);
*cspan_at(&family, 0) = v;
*cspan_at(&family, 1) = a;
*cspan_at(&family, 2) = w;
*cspan_at(&family, 3) = b;
*cspan_at(&family, 4) = top;
*cspan_at(&family, 5) = bottom;
*cspan_at(&family, 7) = bottom;
*cspan_at(&family, 8) = last_ramp;
*cspan_at(&family, 14) = reverse;
*cspan_at(&family, 15) = mirror;
*cspan_at(&family, 16) = 0.0;
*cspan_at(&family, 17) = distance;
*cspan_at(&family, 18) = -1.0;
*cspan_at(&family, 27) = -1.0;
*cspan_at(&family, 19) = last_ramp;
*cspan_at(&family, 33) = 1.0;
*cspan_at(&family, 34) = 0.0;
*cspan_at(&family, 26) = 0.0;
}
static void set_member(int64_t member, double time, bool by_time, array_double_1d family) {
*cspan_at(&family, 18) = member;
*cspan_at(&family, 19) = span_min(span_max(*cspan_at(&family, 8), 0.1 * time), time);
if (by_time) {
*cspan_at(&family, 16) = 1.0;
*cspan_at(&family, 17) = time;
}
}
static bool same_members(int64_t branch, array_double_1d problem, array_double_1d family) {
double a, b;
if ((span_floor_mod(branch, 2) == 0) || (*cspan_at(&family, 26) != 0.0)) {
return 0;
}
a = *cspan_at(&problem, 1);
b = *cspan_at(&problem, 3);
if (branch >= 2) {
a = -a;
b = -b;
}
return (a >= 0.0) && (b <= 0.0);
}
static int64_t write_member(array_double_2d phases, array_double_1d family, array_double_1d axis) {
double a, b, level1, level2, basis, duration;
int64_t before, count;
a = *cspan_at(&family, 1);
b = *cspan_at(&family, 3);
level1 = *cspan_at(&family, 29);
level2 = *cspan_at(&family, 31);
count = append_ramp(phases, 0, a, level1, *cspan_at(&family, 27), axis);
count = append_hold(phases, count, level1, *cspan_at(&family, 28));
before = count;
count = append_change(phases, count, level1, level2, axis);
if ((count > before) && (*cspan_at(&family, 33) > 1.0)) {
basis = *cspan_at(&phases, before, 1);
duration = basis * *cspan_at(&family, 33);
*cspan_at(&phases, before, 0) = duration;
*cspan_at(&phases, before, 1) = basis + *cspan_at(&family, 34) * (duration - basis);
}
count = append_hold(phases, count, level2, *cspan_at(&family, 30));
count = append_ramp(phases, count, level2, b, *cspan_at(&family, 32), axis);
if (*cspan_at(&family, 14) != 0.0) {
reverse_phases(phases, 0, count);
}
if (*cspan_at(&family, 15) != 0.0) {
mirror_phases(phases, count);
}
return count;
}
static int64_t merged_form(array_double_2d phases, double highest, array_double_1d family, array_double_1d axis) {
double lowest, slope, p, duration, y;
int64_t result;
*cspan_at(&family, 6) = highest;
lowest = *cspan_at(&family, 5);
if ((*cspan_at(&family, 0) == *cspan_at(&family, 2)) && (*cspan_at(&family, 1) == -*cspan_at(&family, 3))) {
lowest = span_max(span_min(lowest, highest), *cspan_at(&family, 1));
}
if (lowest != *cspan_at(&family, 7)) {
*cspan_at(&family, 7) = lowest;
segfmu_ramp_duration(cspan_at(&family, 8), &slope, *cspan_at(&family, 3) + lowest, axis);
}
if (*cspan_at(&family, 18) < 0.0) {
p = canonical_search(family, axis);
}
else {
p = member_search(family, axis);
}
if (p < 0.0) {
return -1;
}
canonical_member(&duration, &y, p, family, axis);
if (duration < 0.0) {
return -1;
}
result = write_member(phases, family, axis);
return result;
}
static double velocity_excess(array_double_2d phases, int64_t count, double v, double within_0001, array_double_1d axis) {
double duration, y, end, lowest, highest, result;
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, v, within_0001, axis);
result = span_max(highest - *cspan_at(&axis, 2), (-lowest) - *cspan_at(&axis, 9));
return result;
}
static int64_t level_within(double* result_0, double* result_1_0001, double* result_2_0001, double* result_3_0001, double outside, double e_outside, array_double_2d phases, array_double_1d family, array_double_1d axis) {
double peak_limit, other_limit, v, rounding, margin, too_low, inside, duration, y, end, lowest, highest, peak, other, excess;
int64_t i, count;
peak_limit = *cspan_at(&axis, 2);
other_limit = *cspan_at(&axis, 9);
if (*cspan_at(&family, 15) != 0.0) {
peak_limit = *cspan_at(&axis, 9);
other_limit = *cspan_at(&axis, 2);
}
v = *cspan_at(&family, 13);
rounding = 1e-12 * fastest_velocity(axis);
margin = 1e-09 * fastest_velocity(axis);
too_low = span_max(*cspan_at(&family, 1), span_max(*cspan_at(&family, 3), 0.001 * outside));
inside = too_low;
for (i = 0; i < 24; i += 1) {
count = merged_form(phases, inside, family, axis);
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, span_max_int(count, 0), v, 0.0, axis);
peak = highest;
other = -lowest;
if (*cspan_at(&family, 15) != 0.0) {
peak = -lowest;
other = highest;
}
if ((count <= 0) || (other > other_limit + rounding)) {
too_low = inside;
}
else if (peak > peak_limit + rounding) {
outside = inside;
e_outside = peak - peak_limit + margin;
}
else {
excess = span_max(peak - peak_limit, other - other_limit);
(*result_0) = inside;
(*result_1_0001) = outside;
(*result_2_0001) = excess + margin;
(*result_3_0001) = e_outside;
return 0;
}
if (too_low == outside) {
break;
}
inside = 0.5 * (too_low + outside);
}
(*result_0) = -1.0;
(*result_1_0001) = outside;
(*result_2_0001) = 0.0;
(*result_3_0001) = e_outside;
return 0;
}
static double highest_within(double inside, double outside, double e_inside, double e_outside, array_double_2d phases, array_double_1d family, array_double_1d axis) {
double margin, before, e_before, share, level, error, v;
bool newest_inside, constant, probing;
int64_t steps, count;
margin = 1e-09 * fastest_velocity(axis);
before = outside;
e_before = e_outside;
newest_inside = 1;
constant = 0;
probing = 0;
steps = 0;
while(steps < 100) {
steps = steps + 1;
probing = 0;
if (constant) {
e_inside = 0.0;
if (steps > 24) {
break;
}
}
else if (fabs(e_inside) <= margin) {
probing = 1;
}
if (newest_inside) {
share = root_share(inside, outside, before, e_inside, e_outside, e_before);
}
else {
share = 1.0 - root_share(outside, inside, before, e_outside, e_inside, e_before);
}
if (probing) {
share = 0.001;
}
level = inside + share * (outside - inside);
count = merged_form(phases, level, family, axis);
error = 0.0;
if (count > 0) {
v = *cspan_at(&family, 13);
error = velocity_excess(phases, count, v, 0.0, axis) + margin;
}
if ((count > 0) && (error <= margin)) {
before = outside;
e_before = e_outside;
if (newest_inside) {
before = inside;
e_before = e_inside;
}
inside = level;
e_inside = error;
newest_inside = 1;
if (probing && (outside - inside <= 0.0001 * outside)) {
break;
}
constant = constant || probing;
}
else if (probing) {
break;
}
else {
before = inside;
e_before = e_inside;
if (!newest_inside) {
before = outside;
e_before = e_outside;
}
outside = level;
e_outside = error;
newest_inside = 0;
}
}
return inside;
}
static int64_t tempered_form(array_double_2d phases, array_double_1d family, array_double_1d axis) {
double rounding, margin, v, e_outside, outside, level, inside, e_inside;
int64_t i, count;
count = merged_form(phases, *cspan_at(&family, 4), family, axis);
rounding = 1e-12 * fastest_velocity(axis);
margin = 1e-09 * fastest_velocity(axis);
if (count <= 0) {
return count;
}
v = *cspan_at(&family, 13);
e_outside = velocity_excess(phases, count, v, slowest_velocity(axis), axis) + margin;
if (e_outside <= margin + rounding) {
return count;
}
*cspan_at(&family, 26) = 1.0;
outside = 0.0;
for (i = 0; i < count; i += 1) {
level = *cspan_at(&phases, i, 2);
if (*cspan_at(&family, 14) != *cspan_at(&family, 15)) {
level = -level;
}
outside = span_max(outside, level);
}
level_within(&inside, &outside, &e_inside, &e_outside, outside, e_outside, phases, family, axis);
if (inside < 0.0) {
return 0;
}
inside = highest_within(inside, outside, e_inside, e_outside, phases, family, axis);
count = merged_form(phases, inside, family, axis);
return count;
}
static int64_t timed_cruise(int64_t* result_0, double* result_1_0001, double* result_2, array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis) {
int64_t count, row;
double duration, y, hold;
cruise_form(&count, &row, &duration, &y, phases, cruise, problem, axis);
if (count < 0) {
(*result_0) = -1;
(*result_1_0001) = 0.0;
(*result_2) = -1.0;
return 0;
}
hold = *cspan_at(&problem, 5) - duration;
count = insert_hold(phases, count, row, 0.0, hold);
(*result_0) = count;
(*result_1_0001) = y + cruise * hold;
(*result_2) = hold;
return 0;
}
static double cruise_range(array_double_2d phases, double middle, double y, double hold, array_double_1d problem, array_double_1d axis) {
double distance, limit, outside, missing, cruise, y_cruise, inside;
bool failed;
int64_t i, count;
distance = *cspan_at(&problem, 4);
limit = speed_bound(1.0, *cspan_at(&problem, 5), problem, axis);
if (y > distance) {
limit = -speed_bound(-1.0, *cspan_at(&problem, 5), problem, axis);
}
inside = middle;
outside = limit;
failed = 0;
missing = distance - y;
cruise = middle + 2.5 * missing / (*cspan_at(&problem, 5) + hold);
if (cruise * limit > limit * limit) {
cruise = limit;
}
for (i = 0; i < 100; i += 1) {
if (fabs(missing) > 2.0 * *cspan_at(&problem, 5) * fabs(outside - inside)) {
break;
}
timed_cruise(&count, &y_cruise, &hold, phases, cruise, problem, axis);
if ((count >= 0) && (hold >= 0.0)) {
inside = cruise;
if (((y_cruise - distance) * missing >= 0.0) || (cruise == limit)) {
break;
}
missing = distance - y_cruise;
}
else {
outside = cruise;
failed = 1;
}
cruise = limit;
if (failed) {
cruise = 0.5 * (inside + outside);
if ((cruise == inside) || (cruise == outside)) {
break;
}
}
}
return inside;
}
static void keep_nearest(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_2d trial;
array_double_1d nearest;
double distance, target, most, duration, y, end, lowest, highest;
bool below, above;
if (count <= 0) {
return;
}
trial = span_rows(&work, 0, 21);
nearest = span_row(&work, 58);
distance = *cspan_at(&problem, 4);
target = *cspan_at(&problem, 5);
most = slowest_velocity(axis) * (1.0 + 1e-12);
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, trial, count, *cspan_at(&problem, 0), most, axis);
if (is_beyond(lowest, highest, 1.0 + 1e-12, axis)) {
return;
}
if (fabs(duration - target) > 1e-10 * target) {
return;
}
if (fabs(end - *cspan_at(&problem, 2)) > 1e-10 * span_max(-lowest, highest)) {
return;
}
below = *cspan_at(&nearest, 0) > 0.0;
if ((y <= distance) && ((!below) || (y > *cspan_at(&nearest, 1)))) {
copy_phases(trial, span_rows(&cell, 0, 33), count);
*cspan_at(&nearest, 0) = count;
*cspan_at(&nearest, 1) = y;
}
above = *cspan_at(&nearest, 2) > 0.0;
if ((y >= distance) && ((!above) || (y < *cspan_at(&nearest, 3)))) {
copy_phases(trial, span_rows(&cell, 33, 66), count);
*cspan_at(&nearest, 2) = count;
*cspan_at(&nearest, 3) = y;
}
}
static bool is_enclosed(array_double_2d work) {
array_double_1d nearest;
bool result;
nearest = span_row(&work, 58);
result = (*cspan_at(&nearest, 0) > 0.0) && (*cspan_at(&nearest, 2) > 0.0);
return result;
}
static double keep_cruise(double cruise, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_2d trial;
int64_t count;
double hold, y;
trial = span_rows(&work, 0, 21);
timed_cruise(&count, &y, &hold, trial, cruise, problem, axis);
keep_nearest(count, problem, axis, cell, work);
return y;
}
static void between_cruises(double lower, double upper, double e_lower, double e_upper, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
double distance, newest, other, before, e_newest, e_other, e_before, speed, rounding, share, cruise, error;
int64_t i;
distance = *cspan_at(&problem, 4);
newest = upper;
other = lower;
before = lower;
e_newest = e_upper;
e_other = e_lower;
e_before = e_other;
speed = fabs(*cspan_at(&problem, 0)) + fabs(*cspan_at(&problem, 2));
rounding = 2e-15 * (fabs(distance) + speed * *cspan_at(&problem, 5));
for (i = 0; i < 100; i += 1) {
if ((e_newest == 0.0) || (e_other == 0.0)) {
return;
}
share = root_share(newest, other, before, e_newest, e_other, e_before);
if (i == 0) {
share = e_newest / (e_newest - e_other);
}
cruise = newest + share * (other - newest);
if ((cruise == newest) || (cruise == other)) {
return;
}
error = keep_cruise(cruise, problem, axis, cell, work) - distance;
if (fabs(error) <= rounding) {
return;
}
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, error * e_newest < 0.0, cruise, error, newest, other, e_newest, e_other);
}
}
static double cruise_edge(double inside, double outside, double h_inside, double h_outside, array_double_2d phases, array_double_1d problem, array_double_1d axis) {
double newest, other, before, h_newest, h_other, h_before, cruise, y, hold;
int64_t i, count;
bool fits;
newest = outside;
other = inside;
before = inside;
h_newest = h_outside;
h_other = h_inside;
h_before = h_inside;
for (i = 0; i < 100; i += 1) {
if (newest == other) {
break;
}
cruise = next_point(newest, other, before, h_newest, h_other, h_before);
if ((cruise == newest) || (cruise == other)) {
break;
}
timed_cruise(&count, &y, &hold, phases, cruise, problem, axis);
fits = (count >= 0) && (hold >= 0.0);
if (count < 0) {
hold = 0.0;
}
next_bracket(&newest, &other, &before, &h_newest, &h_other, &h_before, fits != (newest == inside), cruise, hold, newest, other, h_newest, h_other);
if (fits) {
inside = cruise;
if (hold <= 1e-12 * *cspan_at(&problem, 5)) {
break;
}
}
else {
outside = cruise;
}
}
return inside;
}
static void scan_cruises(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_2d trial;
double distance, fastest, backwards, before, e_before, h_before, cruise, y, hold, error, lower, e_lower, upper, e_upper;
bool inside, fits;
int64_t i, count;
trial = span_rows(&work, 0, 21);
distance = *cspan_at(&problem, 4);
fastest = speed_bound(1.0, *cspan_at(&problem, 5), problem, axis);
backwards = speed_bound(-1.0, *cspan_at(&problem, 5), problem, axis);
inside = 0;
before = 0.0;
e_before = 0.0;
h_before = 0.0;
for (i = 0; i < 24 + 1; i += 1) {
cruise = fastest * (2.0 * i / 24 - 1.0);
if (cruise < 0.0) {
cruise = backwards * (2.0 * i / 24 - 1.0);
}
timed_cruise(&count, &y, &hold, trial, cruise, problem, axis);
error = y - distance;
fits = (count >= 0) && (hold >= 0.0);
if (count < 0) {
hold = 0.0;
}
if (fits) {
keep_nearest(count, problem, axis, cell, work);
}
if ((i > 0) && (inside || fits)) {
lower = before;
e_lower = e_before;
upper = cruise;
e_upper = error;
if (!inside) {
lower = cruise_edge(cruise, before, hold, h_before, trial, problem, axis);
e_lower = keep_cruise(lower, problem, axis, cell, work) - distance;
}
if (!fits) {
upper = cruise_edge(before, cruise, h_before, hold, trial, problem, axis);
e_upper = keep_cruise(upper, problem, axis, cell, work) - distance;
}
if (e_lower * e_upper <= 0.0) {
between_cruises(lower, upper, e_lower, e_upper, problem, axis, cell, work);
}
if (is_enclosed(work)) {
return;
}
}
inside = fits;
before = cruise;
e_before = error;
h_before = hold;
}
}
static int64_t loop_excess(double* result_0, double* result_1, int64_t arc, double place, double accuracy, double missing, double largest, array_double_1d family, array_double_1d axis) {
double part, side, duration, y, error, speed;
*cspan_at(&family, 33) = 1.0;
*cspan_at(&family, 34) = 0.0;
if ((arc == 0) || (arc == 6)) {
if (loop_radius(arc, place, accuracy, missing, largest, family, axis) < 0.0) {
(*result_0) = -1.0;
(*result_1) = 0.0;
return 0;
}
}
else if (arc == 5) {
*cspan_at(&family, 34) = 0.25 * place;
if (!slow_middle(0.0, 0.0, family, axis)) {
(*result_0) = -1.0;
(*result_1) = 0.0;
return 0;
}
}
else {
if ((arc == 3) || (arc == 4)) {
*cspan_at(&family, 34) = 1.0;
}
part = 0.5 * place - 1.0;
side = part < 0.0 ? 2.0 : 0.0;
if ((arc == 2) || (arc == 4)) {
side = side + 1.0;
}
if (!slow_middle(side, largest * part * part, family, axis)) {
(*result_0) = -1.0;
(*result_1) = 0.0;
return 0;
}
}
member_distance(&duration, &y, family, axis);
if (*cspan_at(&family, 16) != 0.0) {
error = duration - *cspan_at(&family, 17);
if (fabs(error) <= 2e-15 * duration) {
error = 0.0;
}
(*result_0) = duration;
(*result_1) = error;
return 0;
}
error = y - *cspan_at(&family, 17);
speed = fabs(*cspan_at(&family, 0)) + fabs(*cspan_at(&family, 2)) + top_acceleration(axis) * duration;
if (fabs(error) <= 1e-13 * (fabs(y) + span_min(fastest_velocity(axis), speed) * duration)) {
error = 0.0;
}
(*result_0) = duration;
(*result_1) = error;
return 0;
}
static double loop_root(int64_t arc, double lower, double upper, double e_lower, double e_upper, double missing, double largest, array_double_1d family, array_double_1d axis) {
double place, error, newest, other, before, e_newest, e_other, e_before, duration;
int64_t i;
if ((e_lower == 0.0) || (e_upper == 0.0)) {
place = e_lower == 0.0 ? lower : upper;
loop_excess(&duration, &error, arc, place, 0.0, missing, largest, family, axis);
return duration;
}
newest = upper;
other = lower;
before = lower;
e_newest = e_upper;
e_other = e_lower;
e_before = e_lower;
duration = -1.0;
for (i = 0; i < 100; i += 1) {
place = next_point(newest, other, before, e_newest, e_other, e_before);
if ((place == newest) || (place == other)) {
break;
}
loop_excess(&duration, &error, arc, place, 0.0, missing, largest, family, axis);
if (duration < 0.0) {
return -1.0;
}
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, error * e_newest < 0.0, place, error, newest, other, e_newest, e_other);
if (error == 0.0) {
break;
}
}
return duration;
}
static int64_t scanned_excess(double* result_0, double* result_1, int64_t arc, double place, double missing, double largest, array_double_1d family, array_double_1d axis) {
double duration, error, small, speed;
loop_excess(&duration, &error, arc, place, 0.001, missing, largest, family, axis);
if ((duration < 0.0) || ((arc != 0) && (arc != 6))) {
(*result_0) = duration;
(*result_1) = error;
return 0;
}
small = 0.02 * duration;
if (*cspan_at(&family, 16) == 0.0) {
speed = fabs(*cspan_at(&family, 0)) + fabs(*cspan_at(&family, 2)) + missing;
small = small * speed;
}
if (fabs(error) <= small) {
loop_excess(result_0, result_1, arc, place, 0.0, missing, largest, family, axis);
return 0;
}
(*result_0) = duration;
(*result_1) = error;
return 0;
}
static int64_t arc_root(int64_t* result_0, double* result_1, int64_t arc, int64_t sample, double missing, double largest, array_double_1d family, array_double_1d axis) {
double place, duration, e_place, before, e_before, other, e_other, inside, e_inside, outside, middle, error;
bool known, was_known;
int64_t i, j;
place = 4.0 * sample / 24;
scanned_excess(&duration, &e_place, arc, place, missing, largest, family, axis);
known = duration >= 0.0;
for (i = sample + 1; i < 24 + 1; i += 1) {
before = place;
e_before = e_place;
was_known = known;
place = 4.0 * i / 24;
scanned_excess(&duration, &e_place, arc, place, missing, largest, family, axis);
known = duration >= 0.0;
if ((!known) && (!was_known)) {
continue;
}
other = before;
e_other = e_before;
inside = place;
e_inside = e_place;
if (known != was_known) {
outside = before;
other = place;
e_other = e_place;
if (was_known) {
outside = place;
other = before;
e_other = e_before;
}
inside = other;
e_inside = e_other;
for (j = 0; j < 12; j += 1) {
middle = 0.5 * (inside + outside);
scanned_excess(&duration, &error, arc, middle, missing, largest, family, axis);
if (duration < 0.0) {
outside = middle;
}
else {
inside = middle;
e_inside = error;
if (error * e_other <= 0.0) {
break;
}
}
}
}
if ((other != inside) && (e_other * e_inside <= 0.0)) {
duration = loop_root(arc, other, inside, e_other, e_inside, missing, largest, family, axis);
if (duration >= 0.0) {
(*result_0) = i;
(*result_1) = duration;
return 0;
}
}
}
(*result_0) = -1;
(*result_1) = -1.0;
return 0;
}
static int64_t loop_form(int64_t last, int64_t count, double longest, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d family;
array_double_2d trial;
double missing, given, duration;
int64_t arc, sample, used;
if (*cspan_at(&axis, 12) == 1) {
return count;
}
family = span_row(&work, 98);
trial = span_rows(&work, 0, 21);
missing = set_loop(problem, axis, family);
given = longest;
for (arc = 0; arc < last + 1; arc += 1) {
if ((arc == 6) && (longest < given)) {
break;
}
sample = 0;
while((sample >= 0) && (sample < 24)) {
arc_root(&sample, &duration, arc, sample, missing, given, family, axis);
if ((sample >= 0) && (duration < longest)) {
used = write_member(trial, family, axis);
duration = valid_duration(trial, used, problem, axis);
if ((duration >= 0.0) && (duration < longest * (1.0 - 1e-10))) {
copy_phases(trial, phases, used);
count = used;
longest = duration;
}
}
}
}
return count;
}
static void timed_loop(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d family;
double target, missing, duration;
int64_t arc, sample, used;
family = span_row(&work, 98);
target = *cspan_at(&problem, 5);
missing = set_loop(problem, axis, family);
*cspan_at(&family, 16) = 1.0;
*cspan_at(&family, 17) = target;
for (arc = 0; arc < 5 + 1; arc += 1) {
sample = 0;
while((sample >= 0) && (sample < 24)) {
arc_root(&sample, &duration, arc, sample, missing, target, family, axis);
if (sample >= 0) {
used = write_member(span_rows(&work, 0, 21), family, axis);
keep_nearest(used, problem, axis, cell, work);
}
}
if (is_enclosed(work)) {
return;
}
}
}
static double taylor_value(int64_t order, int64_t top, double t, array_double_1d state) {
double power, value;
int64_t i;
value = *cspan_at(&state, order);
power = 1.0;
for (i = order + 1; i < top + 1; i += 1) {
power = power * (t / (i - order));
value = value + power * *cspan_at(&state, i);
}
return value;
}
static double zero_time(int64_t order, int64_t top, double length, array_double_1d state) {
double lower, upper, value, step, slope, newton, t;
int64_t i;
lower = 0.0;
upper = length;
t = 0.5 * length;
for (i = 0; i < 100; i += 1) {
value = taylor_value(order, top, t, state);
if (value * *cspan_at(&state, order) > 0.0) {
lower = t;
}
else {
upper = t;
}
step = 0.5 * (lower + upper) - t;
slope = taylor_value(order + 1, top, t, state);
if (slope != 0.0) {
newton = (-value) / slope;
if ((t + newton >= lower) && (t + newton <= upper)) {
step = newton;
}
}
t = t + step;
if (fabs(step) <= 1e-07 * length) {
break;
}
}
return t;
}
static void advance_piece(int64_t top, double length, array_double_1d state, array_double_1d end) {
int64_t order, j;
double power;
for (order = 0; order < top + 1; order += 1) {
*cspan_at(&end, order) = *cspan_at(&state, order);
}
power = 1.0;
for (j = 1; j < top + 1; j += 1) {
power = power * (length / j);
for (order = 0; order < top + 1 - j; order += 1) {
*cspan_at(&end, order) = *cspan_at(&end, order) + power * *cspan_at(&state, order + j);
}
}
}
static void note_excess(int64_t q, int64_t node, bool holding, array_double_1d axis, array_double_1d end, array_double_2d excess) {
int64_t order;
double limit, share;
for (order = 1; order < q; order += 1) {
limit = side_limit(order, *cspan_at(&end, order), axis);
if (limit > 0.0) {
share = fabs(*cspan_at(&end, order)) / limit - 1.0;
if ((share > 1e-10) && (share > 1.000001 * *cspan_at(&excess, order, 0))) {
*cspan_at(&excess, order, 0) = share;
*cspan_at(&excess, order, 1) = node;
*cspan_at(&excess, order, 2) = holding;
*cspan_at(&excess, order, 3) = *cspan_at(&end, order) < 0.0 ? -1.0 : 1.0;
}
}
}
}
static void piece_excess(double length, int64_t node, bool holding, array_double_1d axis, array_double_2d work) {
array_double_1d state, end;
array_double_2d excess;
int64_t q, top, i, j, order;
double rest, step;
state = span_row(&work, 203);
end = span_row(&work, 203 + 1);
excess = span_rows(&work, 196, 202);
q = (int64_t)(*cspan_at(&work, 101, 1)) + 2;
top = (int64_t)(*cspan_at(&axis, 0)) + 1;
rest = length;
for (i = 0; i < 100; i += 1) {
step = rest;
advance_piece(top, step, state, end);
for (j = 0; j < q - 1; j += 1) {
order = q - j;
if (*cspan_at(&state, order) * *cspan_at(&end, order) < 0.0) {
step = zero_time(order, top, step, state);
advance_piece(top, step, state, end);
*cspan_at(&end, order) = 0.0;
}
}
note_excess(q, node, holding, axis, end, excess);
for (order = 0; order < top + 1; order += 1) {
*cspan_at(&state, order) = *cspan_at(&end, order);
}
rest = rest - step;
if (rest <= 0.0) {
break;
}
}
}
static bool measure_excess(array_double_1d axis, array_double_2d work) {
array_double_1d passing, state;
array_double_2d excess;
int64_t above, q, boxes, pieces, order, i, row, piece, held;
double level, ramp, change, sign, basis, length, peak;
passing = span_row(&work, 101);
excess = span_rows(&work, 196, 202);
state = span_row(&work, 203);
above = (int64_t)(*cspan_at(&passing, 1));
q = above + 2;
boxes = (int64_t)(*cspan_at(&axis, 0)) - 1 - above;
level = *cspan_at(&passing, 8);
pieces = rise_pieces(boxes);
for (order = 0; order < 4; order += 1) {
*cspan_at(&excess, order, 0) = 0.0;
}
for (i = 0; i < (int64_t)(*cspan_at(&passing, 0)) + 1; i += 1) {
row = 102 + i;
for (order = 0; order < 8; order += 1) {
*cspan_at(&state, order) = order < q ? *cspan_at(&work, row, 0 + order) : 0.0;
}
*cspan_at(&state, q) = level;
ramp = *cspan_at(&work, row, 11);
change = *cspan_at(&work, row, 9) - level;
if (ramp > 0.0) {
for (piece = 1; piece < pieces + 1; piece += 1) {
held_level(&held, &sign, piece, boxes);
basis = ramp * *cspan_at(&passing, 2);
piece_peak(&length, &peak, held, above, change, ramp, basis, axis);
for (order = q + 1 + held; order < 8; order += 1) {
*cspan_at(&state, order) = 0.0;
}
*cspan_at(&state, q + 1 + held) = sign * peak;
if (length > 0.0) {
piece_excess(length, i, 0, axis, work);
}
}
}
level = *cspan_at(&work, row, 9);
if (*cspan_at(&work, row, 10) > 0.0) {
for (order = q; order < 8; order += 1) {
*cspan_at(&state, order) = 0.0;
}
*cspan_at(&state, q) = level;
piece_excess(*cspan_at(&work, row, 10), i, 1, axis, work);
}
}
for (order = 1; order < q; order += 1) {
if (*cspan_at(&excess, order, 0) > 0.0) {
return 1;
}
}
return 0;
}
static double power_term(double t, double sixth) {
return t * t * t * t * t * t * sixth / 720.0;
}
static double highest_in_piece(double length, double value, double first, double second, double third, double fourth, double fifth, double sixth) {
double end, slope, at, highest;
end = length;
highest = value + taylor(end, first, second, third, fourth, fifth);
highest = highest + power_term(end, sixth);
slope = first + taylor(end, second, third, fourth, fifth, sixth);
if ((first > 0.0) && (slope < 0.0)) {
end = crossing_time(first, length, second, third, fourth, fifth, sixth);
at = value + taylor(end, first, second, third, fourth, fifth);
highest = span_max(highest, at + power_term(end, sixth));
}
return highest;
}
static double highest_at_node(int64_t order, double sign, int64_t i, array_double_1d passing, array_double_1d axis, array_double_2d nodes) {
int64_t above, boxes, below, pieces, piece, held;
double before, upper, lower, lowest, level, slope, curvature, third, ramp, change, length, direction, basis, peak, at, highest;
above = (int64_t)(*cspan_at(&passing, 1));
boxes = (int64_t)(*cspan_at(&axis, 0)) - 1 - above;
before = i > 0 ? *cspan_at(&nodes, i - 1, 9) : *cspan_at(&passing, 8);
below = 0 + above + 1;
upper = sign * *cspan_at(&nodes, i, below);
below = below - 1;
lower = sign * *cspan_at(&nodes, i, below);
below = below - 1;
lowest = sign * *cspan_at(&nodes, i, below);
level = sign * before;
slope = 0.0;
curvature = 0.0;
third = 0.0;
ramp = *cspan_at(&nodes, i, 11);
change = sign * (*cspan_at(&nodes, i, 9) - before);
highest = lowest;
if (order == above) {
highest = lower;
}
else if (order == above + 1) {
highest = upper;
}
pieces = rise_pieces(boxes);
for (piece = 1; piece < pieces + 2; piece += 1) {
length = *cspan_at(&nodes, i, 10);
if (piece <= pieces) {
length = 0.0;
if (ramp > 0.0) {
held_level(&held, &direction, piece, boxes);
basis = ramp * *cspan_at(&passing, 2);
piece_peak(&length, &peak, held, above, change, ramp, basis, axis);
if (held == 0) {
slope = direction * peak;
curvature = 0.0;
third = 0.0;
}
else if (held == 1) {
curvature = direction * peak;
third = 0.0;
}
else {
third = direction * peak;
}
}
}
else {
level = sign * *cspan_at(&nodes, i, 9);
slope = 0.0;
curvature = 0.0;
third = 0.0;
}
if (length > 0.0) {
at = highest_in_piece(length, lowest, lower, upper, level, slope, curvature, third);
if (order == above) {
at = highest_in_piece(length, lower, upper, level, slope, curvature, third, 0.0);
}
else if (order == above + 1) {
at = highest_in_piece(length, upper, level, slope, curvature, third, 0.0, 0.0);
}
highest = span_max(highest, at);
lowest = lowest + taylor(length, lower, upper, level, slope, curvature);
lowest = lowest + power_term(length, third);
lower = lower + taylor(length, upper, level, slope, curvature, third);
upper = upper + taylor(length, level, slope, curvature, third, 0.0);
level = level + taylor(length, slope, curvature, third, 0.0, 0.0);
slope = slope + taylor(length, curvature, third, 0.0, 0.0, 0.0);
curvature = curvature + length * third;
}
}
return highest;
}
static double instant_error(int64_t peak, array_double_1d passing, array_double_1d axis, array_double_2d nodes) {
int64_t order, first, last, i;
double highest, sign, result;
order = (int64_t)(*cspan_at(&passing, 14 + peak));
first = span_max_int((int64_t)(*cspan_at(&passing, 20 + peak)), 0);
last = (int64_t)(*cspan_at(&passing, 23 + peak));
highest = -1e+300;
for (i = 0; i < (int64_t)(*cspan_at(&passing, 0)) + 1; i += 1) {
if ((i >= first) && (i <= last)) {
sign = *cspan_at(&passing, 17 + peak);
highest = span_max(highest, highest_at_node(order, sign, i, passing, axis, nodes));
}
}
result = highest - side_limit(order, *cspan_at(&passing, 17 + peak), axis);
return result;
}
static void shift_instants(int64_t place, int64_t by, array_double_1d passing) {
int64_t peak;
for (peak = 0; peak < (int64_t)(*cspan_at(&passing, 13)); peak += 1) {
if (*cspan_at(&passing, 20 + peak) >= place) {
*cspan_at(&passing, 20 + peak) = *cspan_at(&passing, 20 + peak) + by;
}
if (*cspan_at(&passing, 23 + peak) >= place) {
*cspan_at(&passing, 23 + peak) = *cspan_at(&passing, 23 + peak) + by;
}
}
}
static void place_instant(int64_t peak, int64_t order, double sign, int64_t node, array_double_1d passing) {
*cspan_at(&passing, 14 + peak) = order;
*cspan_at(&passing, 17 + peak) = sign;
*cspan_at(&passing, 20 + peak) = node - 1;
*cspan_at(&passing, 23 + peak) = node + 1;
}
static void add_instant(int64_t order, double sign, int64_t node, array_double_1d passing) {
int64_t peak;
peak = (int64_t)(*cspan_at(&passing, 13));
place_instant(peak, order, sign, node, passing);
*cspan_at(&passing, 13) = peak + 1;
}
static double power_of(double base, int64_t exponent) {
int64_t i;
double power;
power = 1.0;
for (i = 0; i < exponent; i += 1) {
power = power * base;
}
return power;
}
static void set_level(array_double_1d node, array_double_1d passing, array_double_1d axis) {
int64_t above, kind;
double pace, time, sign, rise, most, change, slope;
above = (int64_t)(*cspan_at(&passing, 1));
kind = (int64_t)(*cspan_at(&node, 4));
pace = *cspan_at(&passing, 2);
time = *cspan_at(&node, 6);
*cspan_at(&node, 9) = 0.0;
*cspan_at(&node, 10) = time;
if ((int64_t)(*cspan_at(&node, 7)) != 0) {
return;
}
if ((kind > 0) && ((kind != above) || (time >= 0.0))) {
return;
}
sign = *cspan_at(&node, 5) * power_of(pace, above + 2);
if (time < 0.0) {
sign = -sign;
}
rise = fabs(time);
*cspan_at(&node, 10) = 0.0;
most = *cspan_at(&axis, 21 + above - 1);
if (rise >= most) {
*cspan_at(&node, 9) = sign * *cspan_at(&axis, 4 + above - 1);
*cspan_at(&node, 10) = (rise - most) / pace;
}
else if (rise > 0.0) {
plateau_change(&change, &slope, rise, above, axis);
*cspan_at(&node, 9) = sign * change;
}
}
static void advance(double time, double level, double change, double variance, double fourth, int64_t above, array_double_1d state) {
double half, moment, second, third, last, total, square;
int64_t k, order, farthest;
half = 0.5 * time;
moment = half;
second = half * time;
third = second * time / 3.0;
last = 0.25 * third * time;
for (k = 0; k < above + 2; k += 1) {
order = above + 2 - k;
total = *cspan_at(&state, k);
if (order == 4) {
total = total + time * *cspan_at(&state, k + 1) + second * *cspan_at(&state, k + 2);
farthest = k + 3;
total = total + third * *cspan_at(&state, farthest);
}
else if (order == 3) {
total = total + time * *cspan_at(&state, k + 1) + second * *cspan_at(&state, k + 2);
last = third;
}
else if (order == 2) {
total = total + time * *cspan_at(&state, k + 1);
last = second;
}
else {
last = time;
}
total = total + last * level;
if (change != 0.0) {
square = half * half;
if (order == 1) {
moment = half;
}
else if (order == 2) {
moment = 0.5 * (square + variance);
}
else if (order == 3) {
moment = half * (square + 3.0 * variance) / 6.0;
}
else {
moment = square * (square + 6.0 * variance) + 3.0 * variance * variance;
moment = (moment + fourth) / 24.0;
}
total = total + change * moment;
}
*cspan_at(&state, k) = total;
}
}
static void pass_node(int64_t i, array_double_1d passing, array_double_1d axis, array_double_2d nodes) {
int64_t above, k;
double pace, before, change, basis, slope, variance, fourth, square;
above = (int64_t)(*cspan_at(&passing, 1));
pace = *cspan_at(&passing, 2);
before = i > 0 ? *cspan_at(&nodes, i - 1, 9) : *cspan_at(&passing, 8);
change = *cspan_at(&nodes, i, 9) - before;
for (k = 0; k < above + 2; k += 1) {
*cspan_at(&nodes, i + 1, 0 + k) = *cspan_at(&nodes, i, 0 + k);
}
*cspan_at(&nodes, i, 11) = 0.0;
if (change != 0.0) {
plateau_duration(&basis, &slope, fabs(change) / power_of(pace, above + 2), above, axis);
rise_moments(&variance, &fourth, basis, above, axis);
square = 1.0 / (pace * pace);
*cspan_at(&nodes, i, 11) = basis / pace;
advance(basis / pace, before, change, variance * square, fourth * square * square, above, span_row(&nodes, i + 1));
}
}
static int64_t dropped_condition(int64_t q, array_double_1d node) {
int64_t result;
if ((int64_t)(*cspan_at(&node, 7)) == 2) {
result = (int64_t)(*cspan_at(&node, 4));
return result;
}
result = (int64_t)(*cspan_at(&node, 7)) != 0 ? q - 1 : -1;
return result;
}
static double residual_scale(int64_t order, array_double_1d passing, array_double_1d axis) {
double acceleration, time, speed, result;
acceleration = *cspan_at(&passing, 4);
time = *cspan_at(&passing, 3);
if (order > 1) {
result = acceleration / power_of(span_min(time, *cspan_at(&axis, 13)), order - 2);
return result;
}
speed = span_min(fastest_velocity(axis), acceleration * time);
return order == 1 ? speed : speed * time;
}
static int64_t node_residuals(int64_t i, int64_t row, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual) {
int64_t q, kind, dropped, k;
double error, sign;
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
kind = (int64_t)(*cspan_at(&nodes, i, 4));
dropped = dropped_condition(q, span_row(&nodes, i));
if (kind == 0) {
return row;
}
for (k = kind; k < q; k += 1) {
error = *cspan_at(&nodes, i + 1, 0 + k);
if (k == kind) {
sign = *cspan_at(&nodes, i, 5);
error = error - sign * side_limit(kind, sign, axis);
}
*cspan_at(&residual, 0 + row) = error / residual_scale(k, passing, axis);
if (k == dropped) {
error = *cspan_at(&nodes, i, 6) - *cspan_at(&nodes, i, 8);
*cspan_at(&residual, 0 + row) = error / *cspan_at(&passing, 3);
}
row = row + 1;
}
return row;
}
static bool stays_at_limit(array_double_1d node) {
bool result;
if ((*cspan_at(&node, 4) == 0.0) || (*cspan_at(&node, 9) != 0.0)) {
return 0;
}
result = (int64_t)(*cspan_at(&node, 7)) == 0;
return result;
}
static void hold_limit(int64_t q, array_double_1d node, array_double_1d axis, array_double_1d state) {
int64_t kind, k;
if (stays_at_limit(node)) {
kind = (int64_t)(*cspan_at(&node, 4));
*cspan_at(&state, 0 + kind) = *cspan_at(&node, 5) * side_limit(kind, *cspan_at(&node, 5), axis);
for (k = kind + 1; k < q; k += 1) {
*cspan_at(&state, 0 + k) = 0.0;
}
}
}
static int64_t first_row(int64_t node, array_double_1d passing, array_double_2d nodes) {
int64_t q, i, row;
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
row = 0;
for (i = 0; i < node; i += 1) {
if (*cspan_at(&nodes, i, 4) != 0.0) {
row = row + q - (int64_t)(*cspan_at(&nodes, i, 4));
}
}
return row;
}
static void end_residuals(int64_t row, array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_1d end, array_double_1d residual) {
int64_t k;
double target, error;
for (k = 0; k < (int64_t)(*cspan_at(&passing, 1)) + 2; k += 1) {
target = 0.0;
if (k == 0) {
target = *cspan_at(&problem, 4);
}
else if (k == 1) {
target = *cspan_at(&problem, 2);
}
else if (k == 2) {
target = *cspan_at(&problem, 3);
}
error = *cspan_at(&end, 0 + k) - target;
*cspan_at(&residual, 0 + row + k) = error / residual_scale(k, passing, axis);
}
}
static int64_t follow_node(int64_t i, int64_t row, array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual) {
int64_t q;
double hold;
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
if (i == (int64_t)(*cspan_at(&passing, 0))) {
*cspan_at(&nodes, i, 4) = 0.0;
*cspan_at(&nodes, i, 9) = 0.0;
*cspan_at(&nodes, i, 10) = 0.0;
pass_node(i, passing, axis, nodes);
end_residuals(row, problem, passing, axis, span_row(&nodes, i + 1), residual);
return row + q;
}
set_level(span_row(&nodes, i), passing, axis);
pass_node(i, passing, axis, nodes);
row = node_residuals(i, row, passing, axis, nodes, residual);
hold = *cspan_at(&nodes, i, 10);
hold_limit(q, span_row(&nodes, i), axis, span_row(&nodes, i + 1));
if (hold != 0.0) {
advance(hold, *cspan_at(&nodes, i, 9), 0.0, 0.0, 0.0, q - 2, span_row(&nodes, i + 1));
}
return row;
}
static double sequence_duration(array_double_1d passing, array_double_2d nodes) {
int64_t i;
double total;
total = 0.0;
for (i = 0; i < (int64_t)(*cspan_at(&passing, 0)) + 1; i += 1) {
total = total + *cspan_at(&nodes, i, 11) + *cspan_at(&nodes, i, 10);
}
return total;
}
static void run_sequence(array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual) {
int64_t k, jerk, row, i, peak;
double scale, error;
for (k = 0; k < (int64_t)(*cspan_at(&passing, 1)) + 2; k += 1) {
*cspan_at(&nodes, 0, 0 + k) = 0.0;
}
*cspan_at(&nodes, 0, 0 + 1) = *cspan_at(&problem, 0);
*cspan_at(&nodes, 0, 0 + 2) = *cspan_at(&problem, 1);
jerk = 0 + 3;
if ((int64_t)(*cspan_at(&passing, 1)) > 1) {
*cspan_at(&nodes, 0, jerk) = *cspan_at(&passing, 9);
}
row = 0;
for (i = 0; i < (int64_t)(*cspan_at(&passing, 0)) + 1; i += 1) {
row = follow_node(i, row, problem, passing, axis, nodes, residual);
}
for (peak = 0; peak < (int64_t)(*cspan_at(&passing, 13)); peak += 1) {
scale = residual_scale((int64_t)(*cspan_at(&passing, 14 + peak)), passing, axis);
error = instant_error(peak, passing, axis, nodes);
*cspan_at(&residual, 0 + row) = error / scale;
row = row + 1;
}
if (*cspan_at(&passing, 5) > 0.0) {
error = sequence_duration(passing, nodes) - *cspan_at(&passing, 5);
if (*cspan_at(&passing, 6) != 0.0) {
row = first_row((int64_t)(*cspan_at(&passing, 0)), passing, nodes);
}
*cspan_at(&residual, 0 + row) = error / *cspan_at(&passing, 3);
}
}
static void follow_change(int64_t first, int64_t row, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d change, array_double_1d slopes) {
int64_t q, count, i, kind, dropped, k;
double slope;
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
count = (int64_t)(*cspan_at(&passing, 0));
for (i = first; i < count + 1; i += 1) {
advance(*cspan_at(&nodes, i, 11), 0.0, 0.0, 0.0, 0.0, q - 2, change);
kind = (int64_t)(*cspan_at(&nodes, i, 4));
dropped = -1;
if (i < count) {
dropped = dropped_condition(q, span_row(&nodes, i));
}
if ((kind > 0) || (i == count)) {
for (k = kind; k < q; k += 1) {
slope = *cspan_at(&change, 0 + k) / residual_scale(k, passing, axis);
if (k == dropped) {
slope = 0.0;
}
*cspan_at(&slopes, 0 + row) = slope;
row = row + 1;
}
}
if (stays_at_limit(span_row(&nodes, i))) {
for (k = kind; k < q; k += 1) {
*cspan_at(&change, 0 + k) = 0.0;
}
}
if (*cspan_at(&nodes, i, 10) != 0.0) {
advance(*cspan_at(&nodes, i, 10), 0.0, 0.0, 0.0, 0.0, q - 2, change);
}
}
}
static bool is_square(array_double_1d passing, array_double_2d nodes) {
int64_t count, conditions;
count = (int64_t)(*cspan_at(&passing, 0));
conditions = first_row(count, passing, nodes) + (int64_t)(*cspan_at(&passing, 1)) + 2;
conditions = conditions + (int64_t)(*cspan_at(&passing, 13));
return (conditions == count) && (count + 2 <= 120 - 102);
}
static void begin_dip(int64_t above, double v, double a, array_double_2d work) {
array_double_1d passing;
double sign;
int64_t i, i_0001;
passing = span_row(&work, 101);
*cspan_at(&passing, 0) = above + 1;
*cspan_at(&passing, 1) = above;
*cspan_at(&passing, 2) = 1.0;
*cspan_at(&passing, 8) = 0.0;
sign = -1.0;
for (i = 0; i < above + 2; i += 1) {
for (i_0001 = 0; i_0001 < work.shape[1]; i_0001 += 1) {
*cspan_at(&work, 102 + i, i_0001) = 0.0;
}
*cspan_at(&work, 102 + i, 5) = sign;
sign = -sign;
}
*cspan_at(&work, 102, 0 + 1) = v;
*cspan_at(&work, 102, 0 + 2) = a;
}
static double follow_dip(int64_t order, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
array_double_2d nodes;
int64_t above, i;
double hold, result;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
above = (int64_t)(*cspan_at(&passing, 1));
for (i = 0; i < above + 2; i += 1) {
if (i <= above) {
set_level(span_row(&nodes, i), passing, axis);
}
pass_node(i, passing, axis, nodes);
if (*cspan_at(&nodes, i, 10) > 0.0) {
hold = *cspan_at(&nodes, i, 10);
advance(hold, *cspan_at(&nodes, i, 9), 0.0, 0.0, 0.0, above, span_row(&nodes, i + 1));
}
}
result = *cspan_at(&nodes, above + 2, 0 + order);
return result;
}
static double last_jerk(double second, array_double_1d axis, array_double_2d work) {
double result;
*cspan_at(&work, 102 + 1, 6) = second;
result = follow_dip(3, axis, work);
return result;
}
static void balance_jerk(array_double_1d axis, array_double_2d work) {
double newest, e_newest, other, e_other, before, e_before, second, error;
int64_t i;
newest = *cspan_at(&work, 102, 6);
e_newest = last_jerk(newest, axis, work);
if (e_newest >= 0.0) {
return;
}
other = 2.0 * newest;
e_other = last_jerk(other, axis, work);
for (i = 0; i < 100; i += 1) {
if (e_other >= 0.0) {
break;
}
newest = other;
e_newest = e_other;
other = 2.0 * other;
e_other = last_jerk(other, axis, work);
}
before = other;
e_before = e_other;
for (i = 0; i < 100; i += 1) {
second = next_point(newest, other, before, e_newest, e_other, e_before);
if ((second == newest) || (second == other) || (e_newest == 0.0)) {
break;
}
error = last_jerk(second, axis, work);
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, error * e_newest <= 0.0, second, error, newest, other, e_newest, e_other);
}
*cspan_at(&work, 102 + 1, 6) = newest;
}
static double last_excess(double time, double end, array_double_1d axis, array_double_2d work) {
int64_t above;
double result;
above = (int64_t)(*cspan_at(&work, 101, 1));
*cspan_at(&work, 102 + above, 6) = time;
if (above == 2) {
balance_jerk(axis, work);
}
result = follow_dip(2, axis, work) - end;
return result;
}
static bool close_dip(double first, double end, array_double_1d axis, array_double_2d work) {
double newest, e_newest, other, e_other, before, e_before, time, error;
int64_t i;
*cspan_at(&work, 102, 6) = first;
newest = 0.0;
e_newest = last_excess(newest, end, axis, work);
if (e_newest > 0.0) {
return 0;
}
other = first;
e_other = last_excess(other, end, axis, work);
before = other;
e_before = e_other;
for (i = 0; i < 100; i += 1) {
time = next_point(newest, other, before, e_newest, e_other, e_before);
if ((time == newest) || (time == other) || (e_newest == 0.0)) {
break;
}
error = last_excess(time, end, axis, work);
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, error * e_newest <= 0.0, time, error, newest, other, e_newest, e_other);
}
last_excess(newest, end, axis, work);
return 1;
}
static int64_t judge_dip(bool* result_0, bool* result_1, double first, double end, array_double_1d axis, array_double_2d work) {
array_double_2d excess;
bool fast, shallow, deep;
int64_t order;
excess = span_rows(&work, 196, 202);
if (!close_dip(first, end, axis, work)) {
(*result_0) = 1;
(*result_1) = 0;
return 0;
}
if (!measure_excess(axis, work)) {
(*result_0) = 0;
(*result_1) = 0;
return 0;
}
fast = *cspan_at(&excess, 1, 0) > 0.0;
shallow = fast && (*cspan_at(&excess, 1, 3) > 0.0);
deep = fast && (!shallow);
for (order = 2; order < 4; order += 1) {
deep = deep || (*cspan_at(&excess, order, 0) > 0.0);
}
(*result_0) = shallow;
(*result_1) = deep;
return 0;
}
static double find_edge(bool deepest, double lower, double end, array_double_1d axis, array_double_2d work) {
double accuracy, upper, first, found;
int64_t i;
bool shallow, deep;
accuracy = deepest ? 0.01 : 0.001;
upper = 1e+300;
found = -1.0;
for (i = 0; i < 100; i += 1) {
first = upper < 1e+300 ? 0.5 * (lower + upper) : 2.0 * lower;
judge_dip(&shallow, &deep, first, end, axis, work);
if (shallow && deep) {
break;
}
if ((!shallow) && (!deep)) {
found = first;
}
if (shallow || (deepest && (!deep))) {
lower = first;
}
else {
upper = first;
}
if ((upper - lower <= 1e-12 * upper) || ((found > 0.0) && (upper - lower <= accuracy * upper))) {
break;
}
}
return found;
}
static bool find_dips(double v, double a, double end, array_double_1d axis, array_double_1d dips, array_double_2d work) {
double sign, duration, slope, gain, least;
int64_t lower, above;
sign = a < 0.0 ? -1.0 : 1.0;
segfmu_ramp_duration(&duration, &slope, fabs(a), axis);
gain = 0.37 * fabs(a) * duration;
if (ramps_suffice(axis) || (sign * v + gain > side_limit(1, sign, axis))) {
return 0;
}
*cspan_at(&dips, 0) = v;
*cspan_at(&dips, 1) = a;
*cspan_at(&dips, 2) = (-sign) * end;
for (lower = 0; lower < (int64_t)(*cspan_at(&axis, 38)); lower += 1) {
above = (int64_t)(*cspan_at(&axis, 38)) - lower;
begin_dip(above, sign * v, fabs(a), work);
if (sign < 0.0) {
mirror_axis(axis);
}
least = find_edge(0, 0.02 * duration, -end, axis, work);
if (sign < 0.0) {
mirror_axis(axis);
}
if (least > 0.0) {
*cspan_at(&dips, 3) = above;
*cspan_at(&dips, 4) = least;
*cspan_at(&dips, 5) = least;
return 1;
}
}
return 0;
}
static void find_deepest(array_double_1d axis, array_double_1d dips, array_double_2d work) {
double end;
end = -fabs(*cspan_at(&dips, 2));
if (*cspan_at(&dips, 1) < 0.0) {
mirror_axis(axis);
}
*cspan_at(&dips, 5) = span_max(find_edge(1, *cspan_at(&dips, 4), end, axis, work), *cspan_at(&dips, 4));
if (*cspan_at(&dips, 1) < 0.0) {
mirror_axis(axis);
}
}
static int64_t write_levels(array_double_2d phases, array_double_2d work) {
double above, level, ramp;
int64_t i, row, used;
above = *cspan_at(&work, 101, 1);
level = 0.0;
used = 0;
for (i = 0; i < (int64_t)(above) + 2; i += 1) {
row = 102 + i;
ramp = *cspan_at(&work, row, 11);
used = append_phase(phases, used, ramp, ramp, level, *cspan_at(&work, row, 9) - level, above);
level = *cspan_at(&work, row, 9);
used = append_phase(phases, used, *cspan_at(&work, row, 10), 0.0, level, 0.0, above);
}
return used;
}
static int64_t write_dip(int64_t* result_0, double* result_1, double* result_2, double* result_3, double depth, array_double_1d axis, array_double_1d dips, array_double_2d phases, array_double_2d work) {
int64_t above, count;
double sign, first, duration, y, v;
array_double_2d nodes;
above = (int64_t)(*cspan_at(&dips, 3));
if (above == 0) {
(*result_0) = 0;
(*result_1) = 0.0;
(*result_2) = 0.0;
(*result_3) = *cspan_at(&dips, 0);
return 0;
}
sign = *cspan_at(&dips, 1) < 0.0 ? -1.0 : 1.0;
begin_dip(above, sign * *cspan_at(&dips, 0), fabs(*cspan_at(&dips, 1)), work);
first = *cspan_at(&dips, 4) + depth * (*cspan_at(&dips, 5) - *cspan_at(&dips, 4));
close_dip(first, sign * *cspan_at(&dips, 2), axis, work);
count = write_levels(phases, work);
if (sign < 0.0) {
mirror_phases(phases, count);
}
nodes = span_rows(&work, 102, 120);
duration = sequence_duration(span_row(&work, 101), nodes);
y = sign * *cspan_at(&nodes, above + 2, 0);
v = sign * *cspan_at(&nodes, above + 2, 0 + 1);
v = boundary_value(v, *cspan_at(&axis, 9), *cspan_at(&axis, 2));
(*result_0) = count;
(*result_1) = duration;
(*result_2) = y;
(*result_3) = v;
return 0;
}
static double peak_past_zero(double v, double a, double level, array_double_1d axis) {
double duration, slope, result;
segfmu_ramp_duration(&duration, &slope, a - level, axis);
if (level >= 0.0) {
return v + 0.5 * a * duration;
}
result = ramp_extreme_velocity(v, a, level, duration, duration, axis);
return result;
}
static double deep_level(double v, double a, double velocity_limit, double bottom, array_double_1d axis) {
double lower, upper, inner, outer, at_inner, at_outer;
int64_t i;
lower = -span_min(bottom, 1000.0 * a);
upper = 0.0;
if (peak_past_zero(v, a, lower, axis) <= velocity_limit) {
return lower;
}
inner = upper - 0.6180339887498949 * (upper - lower);
outer = lower + 0.6180339887498949 * (upper - lower);
at_inner = peak_past_zero(v, a, inner, axis);
at_outer = peak_past_zero(v, a, outer, axis);
for (i = 0; i < 30; i += 1) {
if (at_inner <= velocity_limit) {
return inner;
}
if (at_outer <= velocity_limit) {
return outer;
}
if (at_inner < at_outer - 1e-12 * velocity_limit) {
upper = outer;
outer = inner;
at_outer = at_inner;
inner = upper - 0.6180339887498949 * (upper - lower);
at_inner = peak_past_zero(v, a, inner, axis);
}
else {
lower = inner;
inner = outer;
at_inner = at_outer;
outer = lower + 0.6180339887498949 * (upper - lower);
at_outer = peak_past_zero(v, a, outer, axis);
}
}
return 1.0;
}
static double level_past_zero(double v, double a, double velocity_limit, double bottom, array_double_1d axis) {
double newest, other, before, e_newest, e_other, e_before, level, error, inside;
int64_t i;
bool crossed;
inside = deep_level(v, a, velocity_limit, bottom, axis);
if (inside > 0.0) {
return inside;
}
newest = inside;
other = 0.0;
before = 0.0;
e_newest = peak_past_zero(v, a, inside, axis) - velocity_limit;
e_other = peak_past_zero(v, a, other, axis) - velocity_limit;
e_before = e_other;
for (i = 0; i < 100; i += 1) {
level = next_point(newest, other, before, e_newest, e_other, e_before);
if ((level == newest) || (level == other)) {
break;
}
error = peak_past_zero(v, a, level, axis) - velocity_limit;
crossed = newest == inside;
if (error <= 0.0) {
crossed = newest != inside;
inside = level;
}
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, crossed, level, error, newest, other, e_newest, e_other);
}
return inside;
}
static int64_t brake(int64_t* result_0, double* result_1, double* result_2, double* result_3, double v, double a, array_double_1d axis, array_double_2d phases, array_double_2d work) {
int64_t count, i;
double level, reached, duration, y, end, lowest, highest, sign, most, bottom, past;
array_double_1d dips;
count = 0;
level = a;
reached = v;
for (i = 0; i < 3; i += 1) {
count = append_change(phases, count, level, 0.0, axis);
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, v, 1e+300, axis);
if (!is_beyond(end, end, 1.0 + 1e-12, axis)) {
(*result_0) = count;
(*result_1) = duration;
(*result_2) = y;
(*result_3) = end;
return 0;
}
count = count - 1;
sign = level < 0.0 ? -1.0 : 1.0;
most = side_limit(1, sign, axis);
bottom = side_limit(2, -sign, axis);
past = sign * level_past_zero(sign * reached, sign * level, most, bottom, axis);
if (past * sign > 0.0) {
break;
}
count = append_change(phases, count, level, past, axis);
segfmu_measure_phases(&duration, &y, &reached, &lowest, &highest, phases, count, v, 1e+300, axis);
level = past;
}
dips = span_row(&work, 62);
if (find_dips(v, a, 0.0, axis, dips, work)) {
write_dip(result_0, result_1, result_2, result_3, 0.0, axis, dips, phases, work);
return 0;
}
(*result_0) = -1;
(*result_1) = 0.0;
(*result_2) = 0.0;
(*result_3) = 0.0;
return 0;
}
static bool nearly_brakes(double v, double a, array_double_1d axis) {
double duration, slope, end, near;
bool result;
segfmu_ramp_duration(&duration, &slope, fabs(a), axis);
end = v + 0.5 * a * duration;
near = v + (1.0 - saving(axis)) * (0.5 * a * duration);
result = is_beyond(end, end, 1.0, axis) && (!is_beyond(near, near, 1.0, axis));
return result;
}
static int64_t braked(int64_t* result_0_0001, double* result_1, int64_t variant, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_2d trial;
array_double_1d rest;
int64_t first, last;
double spent, v, a, w, b, distance, duration, y;
trial = span_rows(&work, 0, 21);
rest = span_row(&work, 60);
first = 0;
last = 0;
spent = 0.0;
v = *cspan_at(&problem, 0);
a = *cspan_at(&problem, 1);
w = *cspan_at(&problem, 2);
b = *cspan_at(&problem, 3);
distance = *cspan_at(&problem, 4);
if (((span_floor_mod(variant, 2) == 1) && (a == 0.0)) || ((variant >= 2) && (b == 0.0))) {
(*result_0_0001) = -3;
(*result_1) = 0.0;
return 0;
}
if (span_floor_mod(variant, 2) == 1) {
brake(&first, &duration, &y, &v, v, a, axis, trial, work);
if (first < 0) {
(*result_0_0001) = -1;
(*result_1) = 0.0;
return 0;
}
spent = duration;
distance = distance - y;
a = 0.0;
}
if (variant >= 2) {
reverse_axis(axis);
brake(&last, &duration, &y, &w, w, -b, axis, trial, work);
reverse_axis(axis);
if (last < 0) {
(*result_0_0001) = -2;
(*result_1) = 0.0;
return 0;
}
spent = spent + duration;
distance = distance - y;
b = 0.0;
}
*cspan_at(&rest, 0) = v;
*cspan_at(&rest, 1) = a;
*cspan_at(&rest, 2) = w;
*cspan_at(&rest, 3) = b;
*cspan_at(&rest, 4) = distance;
*cspan_at(&rest, 5) = *cspan_at(&problem, 5) - spent;
(*result_0_0001) = first + last;
(*result_1) = spent;
return 0;
}
static int64_t surround(array_double_2d phases, int64_t count, int64_t variant, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_2d trial;
double v, duration, y, end, w;
int64_t first, j, i, last, i_0001;
trial = span_rows(&work, 0, 21);
if (span_floor_mod(variant, 2) == 1) {
v = *cspan_at(&problem, 0);
brake(&first, &duration, &y, &end, v, *cspan_at(&problem, 1), axis, trial, work);
for (j = 0; j < count; j += 1) {
i = count - 1 - j;
for (i_0001 = 0; i_0001 < phases.shape[1]; i_0001 += 1) {
*cspan_at(&phases, first + i, i_0001) = *cspan_at(&phases, i, i_0001);
}
}
copy_phases(trial, phases, first);
count = first + count;
}
if (variant >= 2) {
w = *cspan_at(&problem, 2);
reverse_axis(axis);
brake(&last, &duration, &y, &end, w, -*cspan_at(&problem, 3), axis, trial, work);
reverse_axis(axis);
reverse_phases(trial, 0, last);
count = join_phases(trial, last, phases, count);
}
return count;
}
static void timed_merged(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_2d trial;
array_double_1d family;
int64_t branch, member, count;
trial = span_rows(&work, 0, 21);
family = span_row(&work, 98);
for (branch = 0; branch < 4; branch += 1) {
if (same_members(branch, problem, family)) {
continue;
}
set_family(branch, problem, axis, family);
for (member = 0; member < 2; member += 1) {
set_member(member, *cspan_at(&problem, 5), 1, family);
count = tempered_form(trial, family, axis);
if (count < 0) {
break;
}
keep_nearest(count, problem, axis, cell, work);
}
}
}
static void usual_cruise(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_2d trial;
double v, w, distance, middle, y, hold, edge, y_edge;
int64_t count;
trial = span_rows(&work, 0, 21);
v = *cspan_at(&problem, 0);
w = *cspan_at(&problem, 2);
distance = *cspan_at(&problem, 4);
middle = span_min(span_max(distance / *cspan_at(&problem, 5), span_min(v, w)), span_max(v, w));
timed_cruise(&count, &y, &hold, trial, middle, problem, axis);
if ((count >= 0) && (hold >= 0.0)) {
keep_nearest(count, problem, axis, cell, work);
edge = cruise_range(trial, middle, y, hold, problem, axis);
y_edge = keep_cruise(edge, problem, axis, cell, work);
if (is_enclosed(work)) {
between_cruises(middle, edge, y - distance, y_edge - distance, problem, axis, cell, work);
}
}
}
static void timed_between(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
usual_cruise(problem, axis, cell, work);
if (!is_enclosed(work)) {
scan_cruises(problem, axis, cell, work);
}
if (!is_enclosed(work)) {
timed_merged(problem, axis, cell, work);
}
}
static void note_known(array_double_2d work) {
array_double_1d nearest;
nearest = span_row(&work, 58);
*cspan_at(&nearest, 4) = 0.0;
if (*cspan_at(&nearest, 0) > 0.0) {
*cspan_at(&nearest, 4) = -1.0;
}
else if (*cspan_at(&nearest, 2) > 0.0) {
*cspan_at(&nearest, 4) = 1.0;
}
}
static void clear_nearest(array_double_2d work) {
*cspan_at(&work, 58, 0) = 0.0;
*cspan_at(&work, 58, 2) = 0.0;
}
static double nearest_weight(array_double_1d problem, array_double_1d axis, array_double_1d nearest) {
double distance, below, above, target, speed, tiny;
distance = *cspan_at(&problem, 4);
below = *cspan_at(&nearest, 1);
above = *cspan_at(&nearest, 3);
target = *cspan_at(&problem, 5);
speed = speed_bound(1.0, target, problem, axis);
speed = span_max(speed, speed_bound(-1.0, target, problem, axis));
tiny = 1e-14 * (fabs(distance) + speed * target);
if (above - distance <= tiny) {
return 1.0;
}
if (distance - below > tiny) {
return (distance - below) / (above - below);
}
return 0.0;
}
static double beyond_rounding(double value, double scale) {
return fabs(value) <= 1e-09 * scale ? 0.0 : value;
}
static void mirror_search(array_double_1d problem, array_double_1d axis) {
int64_t i;
for (i = 0; i < 5; i += 1) {
*cspan_at(&problem, i) = -*cspan_at(&problem, i);
}
mirror_axis(axis);
}
static void reverse_search(array_double_1d problem, array_double_1d axis) {
double v, a;
v = *cspan_at(&problem, 0);
a = *cspan_at(&problem, 1);
*cspan_at(&problem, 0) = *cspan_at(&problem, 2);
*cspan_at(&problem, 1) = -*cspan_at(&problem, 3);
*cspan_at(&problem, 2) = v;
*cspan_at(&problem, 3) = -a;
reverse_axis(axis);
}
static int64_t orient(int64_t* result_0, int64_t* result_1, array_double_1d problem, array_double_1d axis) {
double speed, push, way;
int64_t mirrored, turned;
speed = fabs(*cspan_at(&problem, 0)) + fabs(*cspan_at(&problem, 2));
push = fabs(*cspan_at(&problem, 1)) + fabs(*cspan_at(&problem, 3));
way = beyond_rounding(*cspan_at(&problem, 4), speed * speed / top_acceleration(axis));
if (way == 0.0) {
way = beyond_rounding(*cspan_at(&problem, 0) + *cspan_at(&problem, 2), speed);
}
if (way == 0.0) {
way = beyond_rounding(*cspan_at(&problem, 1) - *cspan_at(&problem, 3), push);
}
if (way == 0.0) {
way = *cspan_at(&axis, 2) - *cspan_at(&axis, 9);
}
mirrored = 0;
if (way < 0.0) {
mirrored = 1;
mirror_search(problem, axis);
}
way = beyond_rounding(*cspan_at(&problem, 0) - *cspan_at(&problem, 2), speed);
if (way == 0.0) {
way = beyond_rounding(*cspan_at(&problem, 1) + *cspan_at(&problem, 3), push);
}
if (way == 0.0) {
way = *cspan_at(&axis, 3) - *cspan_at(&axis, 9 + 1);
}
turned = 0;
if (way < 0.0) {
turned = 1;
reverse_search(problem, axis);
}
(*result_0) = mirrored;
(*result_1) = turned;
return 0;
}
static void turn_back(int64_t mirrored, int64_t turned, array_double_1d problem, array_double_1d axis) {
if (turned > 0) {
reverse_search(problem, axis);
}
if (mirrored > 0) {
mirror_search(problem, axis);
}
}
static void turn_phases(int64_t mirrored, int64_t turned, int64_t count, array_double_2d phases) {
if (turned > 0) {
reverse_phases(phases, 0, count);
}
if (mirrored > 0) {
mirror_phases(phases, count);
}
}
static int64_t as_asked(int64_t mirrored, int64_t turned, int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_1d passing) {
if (turned > 0) {
*cspan_at(&passing, 7) = 1.0 - *cspan_at(&passing, 7);
}
turn_back(mirrored, turned, problem, axis);
turn_phases(mirrored, turned, span_max_int(count, 0), phases);
if ((turned > 0) && (count == -1)) {
return -2;
}
return (turned > 0) && (count == -2) ? -1 : count;
}
static bool has_pace(array_double_1d passing) {
bool result;
result = (*cspan_at(&passing, 5) > 0.0) && (*cspan_at(&passing, 6) == 0.0);
return result;
}
static double residual_norm(int64_t count, array_double_1d residual) {
double total;
int64_t i;
total = 0.0;
for (i = 0; i < count; i += 1) {
total = total + *cspan_at(&residual, 0 + i) * *cspan_at(&residual, 0 + i);
}
return sqrt(total);
}
static void difference_column(int64_t column, double change, int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d residual;
array_double_2d nodes;
int64_t i;
double slope;
residual = span_row(&work, 202);
nodes = span_rows(&work, 102, 120);
run_sequence(problem, span_row(&work, 101), axis, nodes, residual);
for (i = 0; i < count; i += 1) {
slope = (*cspan_at(&residual, 0 + i) + *cspan_at(&work, 219 + i, 0)) / change;
*cspan_at(&work, 203 + i, column) = slope;
}
}
static void time_column(int64_t column, int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing, residual, slopes, moved, base;
array_double_2d nodes, before;
int64_t q, following, j, i, row, begin, k;
double spent, change, slope, difference;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
residual = span_row(&work, 202);
slopes = span_row(&work, 235);
before = span_rows(&work, 236, 239);
moved = span_row(&work, 239);
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
following = column + 2;
base = span_row(&work, 236 + 2);
spent = 0.0;
for (j = 0; j < 3; j += 1) {
for (i = 0; i < 12; i += 1) {
*cspan_at(&before, j, i) = *cspan_at(&nodes, column + j, i);
}
}
for (j = 0; j < 2; j += 1) {
spent = spent - *cspan_at(&nodes, column + j, 11) - *cspan_at(&nodes, column + j, 10);
}
change = 1e-05 * (fabs(*cspan_at(&nodes, column, 6)) + 0.001 * *cspan_at(&passing, 3));
*cspan_at(&nodes, column, 6) = *cspan_at(&nodes, column, 6) + change;
row = first_row(column, passing, nodes);
begin = row;
row = follow_node(column, row, problem, passing, axis, nodes, residual);
row = follow_node(column + 1, row, problem, passing, axis, nodes, residual);
for (i = 0; i < count; i += 1) {
*cspan_at(&slopes, 0 + i) = 0.0;
}
for (i = begin; i < row; i += 1) {
slope = *cspan_at(&residual, 0 + i) + *cspan_at(&work, 219 + i, 0);
*cspan_at(&slopes, 0 + i) = slope / change;
}
for (j = 0; j < 2; j += 1) {
spent = spent + *cspan_at(&nodes, column + j, 11) + *cspan_at(&nodes, column + j, 10);
}
if (*cspan_at(&passing, 5) > 0.0) {
*cspan_at(&slopes, 0 + count - 1) = spent / (change * *cspan_at(&passing, 3));
}
if (following <= (int64_t)(*cspan_at(&passing, 0))) {
for (k = 0; k < q; k += 1) {
difference = *cspan_at(&nodes, following, 0 + k) - *cspan_at(&base, 0 + k);
*cspan_at(&moved, 0 + k) = difference / change;
}
follow_change(following, row, passing, axis, nodes, moved, slopes);
}
for (j = 0; j < 3; j += 1) {
for (i = 0; i < 12; i += 1) {
*cspan_at(&nodes, column + j, i) = *cspan_at(&before, j, i);
}
}
for (i = 0; i < count; i += 1) {
*cspan_at(&work, 203 + i, column) = *cspan_at(&slopes, 0 + i);
}
}
static void newton_step(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing, residual;
array_double_2d nodes, matrix;
int64_t i, j;
double time, change, largest, added, diagonal;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
residual = span_row(&work, 202);
for (i = 0; i < count; i += 1) {
*cspan_at(&work, 219 + i, 0) = -*cspan_at(&residual, 0 + i);
}
if (has_pace(passing)) {
*cspan_at(&passing, 2) = *cspan_at(&passing, 2) + 1e-05;
difference_column(count - 1, 1e-05, count, problem, axis, work);
*cspan_at(&passing, 2) = *cspan_at(&passing, 2) - 1e-05;
run_sequence(problem, passing, axis, nodes, residual);
}
for (j = 0; j < (int64_t)(*cspan_at(&passing, 0)); j += 1) {
if ((*cspan_at(&passing, 13) != 0.0) || (*cspan_at(&passing, 6) != 0.0)) {
time = *cspan_at(&nodes, j, 6);
change = 1e-05 * (fabs(time) + 0.001 * *cspan_at(&passing, 3));
*cspan_at(&nodes, j, 6) = time + change;
difference_column(j, change, count, problem, axis, work);
*cspan_at(&nodes, j, 6) = time;
}
else {
time_column(j, count, problem, axis, work);
}
}
for (j = 0; j < count; j += 1) {
largest = 0.0;
for (i = 0; i < count; i += 1) {
largest = span_max(largest, fabs(*cspan_at(&work, 203 + i, j)));
}
added = largest == 0.0 ? 1.0 : 1e-12 * largest;
diagonal = *cspan_at(&work, 203 + j, j);
if (diagonal < 0.0) {
added = -added;
}
*cspan_at(&work, 203 + j, j) = diagonal + added;
}
matrix = span_rows(&work, 203, 219);
matrix_solve(count, 1, matrix, span_rows(&work, 219, 235));
}
static double longest_step(array_double_2d work) {
array_double_1d passing;
array_double_2d nodes;
int64_t count, i;
double change, time, most, share;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
share = 1.0;
count = (int64_t)(*cspan_at(&passing, 0));
for (i = 0; i < count; i += 1) {
change = *cspan_at(&work, 219 + i, 0);
time = *cspan_at(&nodes, i, 6);
if (!(fabs(change) < 10000.0 * *cspan_at(&passing, 3))) {
return 0.0;
}
most = 0.5 * *cspan_at(&passing, 3);
if (*cspan_at(&nodes, i, 4) == 0.0) {
most = change * time >= 0.0 ? 1.5 * fabs(time) : 0.7 * fabs(time);
most = most + 0.01 * *cspan_at(&passing, 3);
}
if (fabs(change) * share > most) {
share = most / fabs(change);
}
}
if (has_pace(passing)) {
change = fabs(*cspan_at(&work, 219 + count, 0));
if (change * share > 0.3 * *cspan_at(&passing, 2)) {
share = 0.3 * *cspan_at(&passing, 2) / change;
}
}
return share;
}
static double nearest_multiple(double value, double grid) {
if (grid == 0.0) {
return value;
}
if (value < 0.0) {
return (-grid) * (int64_t)floor(0.5 - value / grid);
}
return grid * (int64_t)floor(0.5 + value / grid);
}
static void take_step(double share, double grid, array_double_2d work) {
int64_t count, i, row;
double time, step;
count = (int64_t)(*cspan_at(&work, 101, 0));
time = *cspan_at(&work, 101, 3);
for (i = 0; i < count; i += 1) {
row = 102 + i;
step = nearest_multiple(share * *cspan_at(&work, 219 + i, 0), grid * time);
*cspan_at(&work, row, 6) = *cspan_at(&work, row, 6) + step;
}
if (has_pace(span_row(&work, 101))) {
step = nearest_multiple(share * *cspan_at(&work, 219 + count, 0), grid);
*cspan_at(&work, 101, 2) = *cspan_at(&work, 101, 2) + step;
}
}
static bool solve_sequence(array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing, residual;
array_double_2d nodes;
int64_t count, i, j;
double error, earlier, spent, share, grid, reached;
bool quick;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
residual = span_row(&work, 202);
count = (int64_t)(*cspan_at(&passing, 0));
if (has_pace(passing)) {
count = count + 1;
}
run_sequence(problem, passing, axis, nodes, residual);
error = residual_norm(count, residual);
quick = ramps_suffice(axis) || (*cspan_at(&passing, 12) != 0.0);
earlier = error;
spent = *cspan_at(&work, 200, 4) + 1.0;
for (i = 0; i < 30; i += 1) {
if (error <= 2e-15) {
break;
}
if (quick && (i > 0) && (span_floor_mod(i, 4) == 0)) {
if (error > 0.7 * earlier) {
break;
}
earlier = error;
}
newton_step(count, problem, axis, work);
share = longest_step(work);
grid = 0.0;
if (error > 0.0001) {
grid = 1e-10;
spent = spent + 1.0;
}
reached = error;
for (j = 0; j < 8; j += 1) {
if ((share == 0.0) || ((j > 0) && (error <= 1e-11))) {
break;
}
take_step(share, grid, work);
run_sequence(problem, passing, axis, nodes, residual);
reached = residual_norm(count, residual);
if (reached < error * (1.0 - 0.0001 * share)) {
break;
}
take_step(-share, grid, work);
share = 0.5 * share;
}
if (!(reached < error * (1.0 - 0.0001 * share))) {
run_sequence(problem, passing, axis, nodes, residual);
break;
}
error = reached;
}
*cspan_at(&work, 200, 4) = spent;
return error <= 1e-12;
}
static void keep_sequence(int64_t row, array_double_2d work) {
int64_t j, i;
for (j = 0; j < (int64_t)(*cspan_at(&work, 101, 0)) + 3; j += 1) {
for (i = 0; i < work.shape[1]; i += 1) {
*cspan_at(&work, row + j, i) = *cspan_at(&work, 101 + j, i);
}
}
}
static void restore_sequence(int64_t row, array_double_2d work) {
int64_t j, i;
for (j = 0; j < (int64_t)(*cspan_at(&work, row, 0)) + 3; j += 1) {
for (i = 0; i < work.shape[1]; i += 1) {
*cspan_at(&work, 101 + j, i) = *cspan_at(&work, row + j, i);
}
}
}
static void insert_node(int64_t place, int64_t kind, double sign, double time, bool touch, array_double_2d work) {
array_double_1d passing;
int64_t count, j, row, i;
passing = span_row(&work, 101);
count = (int64_t)(*cspan_at(&passing, 0));
shift_instants(place, 1, passing);
for (j = 0; j < count - place; j += 1) {
row = 102 + count - j;
for (i = 0; i < work.shape[1]; i += 1) {
*cspan_at(&work, row, i) = *cspan_at(&work, row - 1, i);
}
}
row = 102 + place;
*cspan_at(&work, row, 4) = kind;
*cspan_at(&work, row, 5) = sign;
*cspan_at(&work, row, 6) = time;
*cspan_at(&work, row, 7) = touch;
*cspan_at(&work, row, 8) = 0.0;
*cspan_at(&passing, 0) = count + 1;
}
static void set_alternating(double sign, double time, array_double_2d work) {
int64_t i;
*cspan_at(&work, 101, 0) = 0.0;
for (i = 0; i < (int64_t)(*cspan_at(&work, 101, 1)) + 2; i += 1) {
insert_node(i, 0, sign * (1.0 - 2.0 * (span_floor_mod(i, 2))), time, 0, work);
}
}
static void remove_node(int64_t place, array_double_2d work) {
array_double_1d passing;
int64_t count, row, i;
passing = span_row(&work, 101);
count = (int64_t)(*cspan_at(&passing, 0));
for (row = 102 + place; row < 102 + count - 1; row += 1) {
for (i = 0; i < work.shape[1]; i += 1) {
*cspan_at(&work, row, i) = *cspan_at(&work, row + 1, i);
}
}
*cspan_at(&passing, 0) = count - 1;
shift_instants(place + 1, -1, passing);
}
static int64_t split_guess(double* result_0_0001, double* result_1_0001, double* result_2_0001, int64_t guess) {
if (guess == 1) {
(*result_0_0001) = 0.9;
(*result_1_0001) = 0.7;
(*result_2_0001) = 0.6;
return 0;
}
if (guess == 2) {
(*result_0_0001) = 0.6;
(*result_1_0001) = 0.7;
(*result_2_0001) = 0.9;
return 0;
}
(*result_0_0001) = 0.8;
(*result_1_0001) = 0.5;
(*result_2_0001) = 0.8;
return 0;
}
static bool split_level(int64_t place, int64_t kind, double sign, int64_t guess, array_double_1d axis, array_double_2d work) {
int64_t row;
double time, level_sign, dip, before, depth, after;
row = 102 + place;
if (*cspan_at(&work, row, 4) != 0.0) {
return 0;
}
time = *cspan_at(&work, row, 6);
level_sign = *cspan_at(&work, row, 5);
dip = span_min(fabs(time), *cspan_at(&axis, 21 + kind - 1));
split_guess(&before, &depth, &after, guess);
*cspan_at(&work, row, 6) = before * time;
insert_node(place + 1, kind, sign, (-depth) * dip, 0, work);
insert_node(place + 2, 0, level_sign, after * time, 0, work);
return 1;
}
static bool split_ramp(int64_t place, int64_t kind, double sign, bool touch, bool holding, array_double_2d work) {
int64_t first, last, plateau;
double share, time, before, after, hold;
first = 102 + place - 1;
last = 102 + place;
plateau = kind + 2;
if (holding) {
last = last + 1;
if (*cspan_at(&work, last - 1, 4) != plateau) {
return 0;
}
}
if ((*cspan_at(&work, first, 4) != 0.0) || (*cspan_at(&work, last, 4) != 0.0)) {
return 0;
}
share = touch ? 0.5 : 0.7;
time = share * 0.5 * (*cspan_at(&work, first, 6) + *cspan_at(&work, last, 6));
before = *cspan_at(&work, first, 5);
after = *cspan_at(&work, last, 5);
if (holding) {
hold = *cspan_at(&work, last - 1, 6);
insert_node(place + 1, plateau, *cspan_at(&work, last - 1, 5), hold, 0, work);
place = place + 1;
}
insert_node(place, 0, before, time, 0, work);
insert_node(place, kind, sign, 0.0, touch, work);
insert_node(place, 0, after, time, 0, work);
return 1;
}
static bool insert_plateau(int64_t kind, bool touching, int64_t guess, array_double_1d axis, array_double_2d work) {
array_double_1d passing, excess;
int64_t q, count, place, row;
double sign;
bool holding, here, inside, result;
passing = span_row(&work, 101);
excess = span_row(&work, 196 + kind);
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
count = (int64_t)(*cspan_at(&passing, 0));
place = (int64_t)(*cspan_at(&excess, 1));
sign = *cspan_at(&excess, 3);
holding = *cspan_at(&excess, 2) != 0.0;
if (count > 12) {
return 0;
}
if (kind == q - 2) {
if (!holding) {
row = 102 + place;
here = (place < count) && (*cspan_at(&work, row, 4) == 0.0);
if ((!here) || (*cspan_at(&work, row, 9) * sign >= 0.0)) {
place = place - 1;
}
}
inside = (place >= 0) && (place < count);
result = inside && split_level(place, kind, sign, guess, axis, work);
return result;
}
if ((place == 0) || (place >= count)) {
return 0;
}
if (kind == q - 3) {
result = split_ramp(place, kind, sign, touching, holding, work);
return result;
}
row = 102 + place;
if (holding || (*cspan_at(&work, row, 4) != 0.0) || (*cspan_at(&work, row - 1, 4) != 0.0)) {
return 0;
}
insert_node(place, kind, sign, 0.0, 0, work);
return 1;
}
static bool rotate_levels(array_double_2d work) {
array_double_1d passing;
int64_t count, first, last;
double tiny, at_first, at_last;
passing = span_row(&work, 101);
count = (int64_t)(*cspan_at(&passing, 0));
first = 102;
last = 102 + count - 1;
tiny = 0.03 * *cspan_at(&passing, 3);
if ((count < 2) || (*cspan_at(&work, first, 4) != 0.0) || (*cspan_at(&work, last, 4) != 0.0)) {
return 0;
}
if (*cspan_at(&passing, 6) != 0.0) {
return 0;
}
at_first = fabs(*cspan_at(&work, first, 6));
at_last = fabs(*cspan_at(&work, last, 6));
if (span_min(at_first, at_last) >= tiny) {
return 0;
}
if (at_first <= 1.000001 * at_last) {
remove_node(0, work);
insert_node(count - 1, 0, -*cspan_at(&work, last - 1, 5), tiny, 0, work);
}
else {
remove_node(count - 1, work);
insert_node(0, 0, -*cspan_at(&work, first, 5), tiny, 0, work);
}
return 1;
}
static bool solve_rotated(array_double_1d problem, array_double_1d axis, array_double_2d work) {
bool result;
if (solve_sequence(problem, axis, work)) {
return 1;
}
result = rotate_levels(work) && solve_sequence(problem, axis, work);
return result;
}
static int64_t overlong_plateau(array_double_2d work) {
array_double_1d passing;
double least;
int64_t i, row, kind, found;
bool held;
passing = span_row(&work, 101);
found = -1;
least = (-1e-12) * *cspan_at(&passing, 3);
for (i = 0; i < (int64_t)(*cspan_at(&passing, 0)); i += 1) {
row = 102 + i;
kind = (int64_t)(*cspan_at(&work, row, 4));
held = ((int64_t)(*cspan_at(&work, row, 7)) == 0) && (kind != (int64_t)(*cspan_at(&passing, 1)));
if ((kind > 0) && held && (*cspan_at(&work, row, 6) < least)) {
found = i;
least = 1.000001 * *cspan_at(&work, row, 6);
}
}
return found;
}
static bool shorten_hold(int64_t row, int64_t touch, int64_t steps, array_double_1d problem, array_double_1d axis, array_double_2d work) {
double hold;
int64_t i;
hold = *cspan_at(&work, row, 6);
*cspan_at(&work, row, 7) = touch;
for (i = 0; i < steps; i += 1) {
*cspan_at(&work, row, 8) = hold * (steps - 1 - i) / steps;
if (!solve_sequence(problem, axis, work)) {
return 0;
}
}
return 1;
}
static bool touch_limit(int64_t row, array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t kind;
bool result;
keep_sequence(120, work);
kind = (int64_t)(*cspan_at(&work, row, 4));
if (kind == (int64_t)(*cspan_at(&work, 101, 1)) + 1) {
if (shorten_hold(row, 2, 1, problem, axis, work)) {
return 1;
}
}
else if (shorten_hold(row, 1, 4, problem, axis, work)) {
return 1;
}
restore_sequence(120, work);
result = shorten_hold(row, 2, 4, problem, axis, work);
return result;
}
static int64_t add_plateau(array_double_1d axis, array_double_2d work) {
int64_t q, kind;
q = (int64_t)(*cspan_at(&work, 101, 1)) + 2;
for (kind = 1; kind < q; kind += 1) {
if (*cspan_at(&work, 196 + kind, 0) > 0.0) {
if (insert_plateau(kind, 0, 0, axis, work)) {
return kind;
}
}
}
return 0;
}
static bool meet_limits(double longest, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
int64_t q, added, attempt, place, row;
passing = span_row(&work, 101);
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
added = 0;
for (attempt = 0; attempt < 24; attempt += 1) {
if ((attempt > 0) && (!solve_sequence(problem, axis, work))) {
if ((added == 0) || (added != q - 3)) {
return 0;
}
restore_sequence(120, work);
added = 0;
if (!insert_plateau(q - 3, 1, 0, axis, work)) {
return 0;
}
if (!solve_sequence(problem, axis, work)) {
return 0;
}
}
if (sequence_duration(passing, span_rows(&work, 102, 120)) >= longest) {
return 0;
}
added = 0;
place = overlong_plateau(work);
if (place >= 0) {
row = 102 + place;
if (!touch_limit(row, problem, axis, work)) {
return 0;
}
}
else if (!measure_excess(axis, work)) {
return 1;
}
else {
keep_sequence(120, work);
added = add_plateau(axis, work);
if (added == 0) {
return 0;
}
}
}
return 0;
}
static bool may_go_on(array_double_2d work) {
bool result;
result = *cspan_at(&work, 200, 4) < *cspan_at(&work, 200, 5);
return result;
}
static bool insert_level(int64_t variant, int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
int64_t node, count, place, beside, row;
double sign;
bool result;
passing = span_row(&work, 101);
node = (int64_t)(*cspan_at(&work, 196 + order, 1));
count = (int64_t)(*cspan_at(&passing, 0));
place = node;
beside = node;
sign = 1.0;
if (variant == 0) {
beside = node - 1;
}
else if (variant == 2) {
place = node - 1;
beside = node - 1;
}
else if (variant == 3) {
place = node + 1;
}
else if (variant == 4) {
place = 0;
beside = 0;
sign = -1.0;
}
else if (variant == 5) {
place = count;
beside = count - 1;
sign = -1.0;
}
if ((place < 0) || (beside < 0) || (beside >= count) || (count > 12)) {
return 0;
}
row = 102 + beside;
if (((int64_t)(*cspan_at(&passing, 13)) > 2) || (*cspan_at(&work, row, 4) != 0.0)) {
return 0;
}
sign = sign * *cspan_at(&work, row, 5);
insert_node(place, 0, sign, 0.5 * *cspan_at(&work, row, 6), 0, work);
add_instant(order, *cspan_at(&work, 196 + order, 3), node, passing);
result = solve_rotated(problem, axis, work);
return result;
}
static bool move_instant(int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
int64_t node, peak;
passing = span_row(&work, 101);
node = (int64_t)(*cspan_at(&work, 196 + order, 1));
for (peak = 0; peak < (int64_t)(*cspan_at(&passing, 13)); peak += 1) {
if (((int64_t)(*cspan_at(&passing, 14 + peak)) == order) && may_go_on(work)) {
place_instant(peak, order, *cspan_at(&work, 196 + order, 3), node, passing);
if (solve_rotated(problem, axis, work)) {
return 1;
}
restore_sequence(120, work);
}
}
return 0;
}
static bool compares_levels(array_double_1d axis) {
bool result;
result = ((int64_t)(*cspan_at(&axis, 38)) < 2) && (!ramps_suffice(axis));
return result;
}
static double sequence_cost(array_double_2d work) {
array_double_1d passing;
array_double_2d nodes;
int64_t end;
double result;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
if (*cspan_at(&passing, 6) != 0.0) {
end = (int64_t)(*cspan_at(&passing, 0)) + 1;
result = (-*cspan_at(&passing, 6)) * *cspan_at(&nodes, end, 0);
return result;
}
result = sequence_duration(passing, nodes);
return result;
}
static bool insert_instant(int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work) {
double least, cost;
int64_t variant;
if ((*cspan_at(&work, 200, 6) != 0.0) && move_instant(order, problem, axis, work)) {
return 1;
}
least = 1e+300;
for (variant = 0; variant < 6; variant += 1) {
if (may_go_on(work) && insert_level(variant, order, problem, axis, work)) {
if (has_pace(span_row(&work, 101)) || (!compares_levels(axis))) {
return 1;
}
cost = sequence_cost(work);
if (cost < least) {
least = cost - 1e-09 * fabs(cost);
keep_sequence(177, work);
}
}
restore_sequence(120, work);
}
if (least < 1e+300) {
restore_sequence(177, work);
}
return least < 1e+300;
}
static bool insert_limit(array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t q, order, j, lower, guesses, guess;
double excess;
bool result;
q = (int64_t)(*cspan_at(&work, 101, 1)) + 2;
order = q - 1;
for (j = 1; j < q - 1; j += 1) {
lower = q - 1 - j;
excess = *cspan_at(&work, 196 + order, 0);
if (*cspan_at(&work, 196 + lower, 0) > excess) {
order = lower;
}
}
keep_sequence(120, work);
if ((order == q - 3) && insert_instant(order, problem, axis, work)) {
return 1;
}
guesses = order == q - 2 ? 3 : 1;
for (guess = 0; guess < guesses; guess += 1) {
if (may_go_on(work) && insert_plateau(order, 0, guess, axis, work)) {
if (solve_rotated(problem, axis, work)) {
return 1;
}
}
restore_sequence(120, work);
}
result = (order >= q - 2) && insert_instant(order, problem, axis, work);
return result;
}
static bool stay_below(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t row;
keep_sequence(120, work);
row = 102 + place;
*cspan_at(&work, row, 7) = 2;
*cspan_at(&work, row, 8) = 0.0;
if (solve_rotated(problem, axis, work)) {
return 1;
}
restore_sequence(120, work);
return 0;
}
static bool end_highest(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work) {
bool first, result;
int64_t row, order;
double sign, hold;
first = has_pace(span_row(&work, 101)) || (!compares_levels(axis));
if (first && stay_below(place, problem, axis, work)) {
return 1;
}
row = 102 + place;
order = (int64_t)(*cspan_at(&work, row, 4));
sign = *cspan_at(&work, row, 5);
hold = *cspan_at(&work, row, 6);
remove_node(place, work);
*cspan_at(&work, 196 + order, 1) = place;
*cspan_at(&work, 196 + order, 3) = sign;
keep_sequence(120, work);
if (insert_instant(order, problem, axis, work)) {
return 1;
}
insert_node(place, order, sign, hold, 0, work);
result = (!first) && stay_below(place, problem, axis, work);
return result;
}
static bool end_plateau(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t row, order, side;
double sign;
bool result;
row = 102 + place;
order = (int64_t)(*cspan_at(&work, row, 4));
sign = *cspan_at(&work, row, 5);
if (order == (int64_t)(*cspan_at(&work, 101, 1)) + 1) {
result = end_highest(place, problem, axis, work);
return result;
}
keep_sequence(120, work);
for (side = 0; side < 2; side += 1) {
remove_node(place, work);
remove_node(place - side, work);
add_instant(order, sign, place - side, span_row(&work, 101));
if (solve_rotated(problem, axis, work)) {
return 1;
}
restore_sequence(120, work);
}
return 0;
}
static bool meet_all(array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t attempt, place;
for (attempt = 0; attempt < 12; attempt += 1) {
place = overlong_plateau(work);
if (place >= 0) {
if (!end_plateau(place, problem, axis, work)) {
return 0;
}
}
else if (!measure_excess(axis, work)) {
return 1;
}
else if (!insert_limit(problem, axis, work)) {
return 0;
}
}
return 0;
}
static int64_t vanishing_end(array_double_2d work) {
array_double_1d passing;
int64_t last, side, row, found;
double least;
passing = span_row(&work, 101);
last = (int64_t)(*cspan_at(&passing, 0)) - 1;
found = -1;
least = 0.1 * *cspan_at(&passing, 3);
for (side = 0; side < 2; side += 1) {
row = 102 + side * last;
if ((*cspan_at(&work, row, 4) == 0.0) && (fabs(*cspan_at(&work, row, 6)) < least)) {
found = side * last;
least = fabs(*cspan_at(&work, row, 6)) / 1.000001;
}
}
return found;
}
static bool release_plateau(array_double_2d work) {
array_double_1d passing;
int64_t kind, end, i, row;
bool touches;
passing = span_row(&work, 101);
kind = (int64_t)(*cspan_at(&passing, 1));
end = vanishing_end(work);
if ((end < 0) || ((int64_t)(*cspan_at(&passing, 13)) > 2)) {
return 0;
}
for (i = 0; i < (int64_t)(*cspan_at(&passing, 0)); i += 1) {
row = 102 + i;
touches = ((int64_t)(*cspan_at(&work, row, 7)) == 0) && (*cspan_at(&work, row, 6) < 0.0);
if (touches && ((int64_t)(*cspan_at(&work, row, 4)) == kind)) {
*cspan_at(&work, row, 4) = 0.0;
add_instant(kind, *cspan_at(&work, row, 5), i, passing);
remove_node(end, work);
return 1;
}
}
return 0;
}
static bool follow(double target, array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t change;
bool changed;
for (change = 0; change < 2; change += 1) {
restore_sequence(158, work);
*cspan_at(&work, 101, 12) = 1.0;
*cspan_at(&work, 101, 5) = target;
changed = (change == 0) || release_plateau(work);
if (changed && may_go_on(work) && solve_rotated(problem, axis, work)) {
if (meet_all(problem, axis, work)) {
return 1;
}
}
}
return 0;
}
static void append_level(double sign, double time, array_double_2d work) {
int64_t count, row;
double last;
count = (int64_t)(*cspan_at(&work, 101, 0));
if (count > 0) {
row = 102 + count - 1;
if ((*cspan_at(&work, row, 4) == 0.0) && (*cspan_at(&work, row, 5) == sign)) {
last = *cspan_at(&work, row, 6);
*cspan_at(&work, row, 6) = sqrt(last * last + time * time);
return;
}
}
insert_node(count, 0, sign, time, 0, work);
}
static void append_levels(double change, array_double_1d axis, array_double_2d work) {
double sign, duration, slope, rise, hold, time;
int64_t count;
if (change == 0.0) {
return;
}
sign = change < 0.0 ? -1.0 : 1.0;
segfmu_ramp_duration(&duration, &slope, fabs(change), axis);
rise = inner_rise(duration, 0, axis);
hold = span_max(duration - 2.0 * rise, 0.0);
if ((int64_t)(*cspan_at(&work, 101, 1)) < 2) {
append_level(sign, rise + hold, work);
return;
}
time = rise - inner_rise(rise, 1, axis);
append_level(sign, time, work);
if (hold > 1e-09 * duration) {
count = (int64_t)(*cspan_at(&work, 101, 0));
insert_node(count, 3, sign, hold, 0, work);
}
append_level(-sign, time, work);
}
static int64_t limit_held(int64_t* result_0, double* result_1_0001, double a, double v, array_double_1d axis) {
int64_t order;
double value;
order = 0;
value = 0.0;
if (fabs(a) >= side_limit(2, a, axis) * (1.0 - 1e-09)) {
order = 2;
value = a;
}
else if ((a == 0.0) && (fabs(v) >= side_limit(1, v, axis) * (1.0 - 1e-09))) {
order = 1;
value = v;
}
if (value < 0.0) {
(*result_0) = order;
(*result_1_0001) = -1.0;
return 0;
}
(*result_0) = order;
(*result_1_0001) = 1.0;
return 0;
}
static void copy_levels(int64_t count, array_double_2d phases, double v, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
double pending, a, change, duration, sign;
int64_t i, order;
passing = span_row(&work, 101);
*cspan_at(&passing, 0) = 0.0;
pending = 0.0;
for (i = 0; i < count; i += 1) {
a = *cspan_at(&phases, i, 2);
change = *cspan_at(&phases, i, 3);
duration = *cspan_at(&phases, i, 0);
if (change * pending < 0.0) {
append_levels(pending, axis, work);
pending = 0.0;
}
pending = pending + change;
if (change == 0.0) {
limit_held(&order, &sign, a, v, axis);
if (order > 0) {
append_levels(pending, axis, work);
pending = 0.0;
insert_node((int64_t)(*cspan_at(&passing, 0)), order, sign, duration, 0, work);
}
}
v = v + (a + 0.5 * change) * duration;
}
append_levels(pending, axis, work);
}
static void begin_sequence(double duration, double acceleration, array_double_1d axis, array_double_1d passing) {
*cspan_at(&passing, 1) = *cspan_at(&axis, 38);
*cspan_at(&passing, 2) = 1.0;
*cspan_at(&passing, 5) = 0.0;
*cspan_at(&passing, 6) = 0.0;
*cspan_at(&passing, 13) = 0.0;
*cspan_at(&passing, 12) = 0.0;
*cspan_at(&passing, 3) = duration;
*cspan_at(&passing, 4) = acceleration;
}
static double peak_acceleration(int64_t count, array_double_2d ramps) {
int64_t i;
double peak;
peak = 0.0;
for (i = 0; i < count; i += 1) {
peak = span_max(peak, fabs(*cspan_at(&ramps, i, 2) + *cspan_at(&ramps, i, 3)));
peak = span_max(peak, fabs(*cspan_at(&ramps, i, 2)));
}
return peak;
}
static bool set_sequence(int64_t attempt, int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
int64_t q, i, row;
double peak, duration, speed, factor;
passing = span_row(&work, 101);
q = (int64_t)(*cspan_at(&axis, 38)) + 2;
peak = peak_acceleration(count, phases);
if ((peak == 0.0) || has_dip(phases, count)) {
return 0;
}
duration = total_duration(phases, count);
speed = span_max(fabs(*cspan_at(&problem, 0)), fabs(*cspan_at(&problem, 2)));
begin_sequence(duration, span_max(peak, 0.001 * speed / duration), axis, passing);
copy_levels(count, phases, *cspan_at(&problem, 0), axis, work);
if (!is_square(passing, span_rows(&work, 102, 120))) {
set_alternating(1.0, 0.7 * *cspan_at(&passing, 3) / q, work);
}
factor = q == 4 ? 1.25 : 1.0;
if (span_floor_mod(attempt, 3) == 1) {
factor = 1.3 * factor;
}
else if (span_floor_mod(attempt, 3) == 2) {
factor = factor / 1.25;
}
for (i = 0; i < (int64_t)(*cspan_at(&passing, 0)); i += 1) {
row = 102 + i;
if (*cspan_at(&work, row, 4) == 0.0) {
*cspan_at(&work, row, 6) = factor * *cspan_at(&work, row, 6);
if (attempt >= 3) {
*cspan_at(&work, row, 5) = -*cspan_at(&work, row, 5);
}
}
else if (attempt >= 3) {
return 0;
}
}
return 1;
}
static bool first_solution(int64_t count, array_double_2d ramps, array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t attempt;
for (attempt = 0; attempt < 6; attempt += 1) {
if (!set_sequence(attempt, count, ramps, problem, axis, work)) {
return 0;
}
if (solve_rotated(problem, axis, work)) {
keep_sequence(158, work);
return 1;
}
}
return 0;
}
static double largest_excess(array_double_1d axis, array_double_2d work) {
int64_t order;
double largest;
largest = 0.0;
if (measure_excess(axis, work)) {
for (order = 1; order < (int64_t)(*cspan_at(&work, 101, 1)) + 2; order += 1) {
largest = span_max(largest, *cspan_at(&work, 196 + order, 0));
}
}
return largest;
}
static bool is_brief(array_double_1d axis) {
bool result;
result = ramps_suffice(axis) && (*cspan_at(&axis, 12) != 2);
return result;
}
static bool shorter_solution(array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
array_double_2d nodes;
int64_t q, attempt;
double most, duration, sign, scale;
bool shorter;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
if (is_brief(axis) || is_resting(problem, axis)) {
return 0;
}
most = (int64_t)(*cspan_at(&passing, 0)) == q ? 1e+300 : 0.3;
duration = sequence_duration(passing, nodes);
sign = *cspan_at(&work, 102, 5);
scale = duration;
*cspan_at(&passing, 12) = 1.0;
for (attempt = 0; attempt < 4; attempt += 1) {
sign = -sign;
if (attempt == 2) {
if (*cspan_at(&work, 98, 20) >= duration) {
break;
}
scale = *cspan_at(&work, 98, 20);
}
set_alternating(sign, 0.5 * 0.7 * scale / q, work);
if (solve_rotated(problem, axis, work)) {
shorter = sequence_duration(passing, nodes) < 0.9 * duration;
if (shorter && (largest_excess(axis, work) < most)) {
*cspan_at(&passing, 12) = 0.0;
keep_sequence(158, work);
return 1;
}
}
}
return 0;
}
static void loosen(double share, array_double_1d axis, array_double_2d work) {
array_double_1d loose;
int64_t i, order, lower;
double excess, factor;
loose = span_row(&work, 201);
for (i = 0; i < 50; i += 1) {
*cspan_at(&loose, i) = *cspan_at(&axis, i);
}
for (order = 1; order < (int64_t)(*cspan_at(&work, 101, 1)) + 2; order += 1) {
i = 2 + order - 1;
excess = *cspan_at(&work, 200, 0 + order);
factor = pow((1.0 + excess), (1.0 - share));
*cspan_at(&loose, i) = *cspan_at(&axis, i) * factor;
if (order <= 2) {
lower = 9 + order - 1;
*cspan_at(&loose, lower) = *cspan_at(&axis, lower) * factor;
}
}
}
static bool tighten(double longest, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing, steps;
array_double_2d nodes;
int64_t order;
double most, each, least, target, reached, step, share;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
steps = span_row(&work, 200);
measure_excess(axis, work);
for (order = 1; order < (int64_t)(*cspan_at(&passing, 1)) + 2; order += 1) {
*cspan_at(&steps, 0 + order) = *cspan_at(&work, 196 + order, 0);
}
*cspan_at(&passing, 3) = sequence_duration(passing, nodes);
keep_sequence(158, work);
most = 150.0;
each = 40.0;
least = 0.1;
if (longest > 1.4 * *cspan_at(&passing, 3)) {
most = 400.0;
least = 0.02;
}
if (compares_levels(axis)) {
most = most + 400.0;
each = 200.0;
}
*cspan_at(&steps, 4) = 0.0;
*cspan_at(&steps, 6) = 0.0;
target = *cspan_at(&passing, 5);
reached = 0.0;
step = 1.0;
while((step > least) && (*cspan_at(&steps, 4) < most)) {
*cspan_at(&steps, 5) = span_min(*cspan_at(&steps, 4) + each, most);
share = span_min(reached + step, 1.0);
loosen(share, axis, work);
if (follow(target, problem, span_row(&work, 201), work)) {
if (sequence_duration(passing, nodes) >= longest) {
return 0;
}
if (share == 1.0) {
return 1;
}
keep_sequence(158, work);
reached = share;
}
else {
step = 0.5 * step;
}
}
return 0;
}
static bool slow_down(double longest, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
array_double_2d nodes;
double fast, slow;
int64_t i;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
fast = 1.0;
slow = 0.0;
for (i = 0; i < 24; i += 1) {
*cspan_at(&passing, 2) = slow > 0.0 ? 0.5 * (slow + fast) : 0.97 * fast;
if (!solve_sequence(problem, axis, work)) {
break;
}
if (sequence_duration(passing, nodes) >= longest) {
break;
}
if ((overlong_plateau(work) < 0) && (!measure_excess(axis, work))) {
keep_sequence(120, work);
slow = *cspan_at(&passing, 2);
}
else {
fast = *cspan_at(&passing, 2);
}
if ((slow > 0.0) && (fast - slow < 0.001)) {
break;
}
}
if (slow > 0.0) {
restore_sequence(120, work);
}
return slow > 0.0;
}
static void flush_levels(array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
array_double_2d nodes;
int64_t i;
bool short_0001;
passing = span_row(&work, 101);
nodes = span_rows(&work, 102, 120);
for (i = 0; i < (int64_t)(*cspan_at(&passing, 0)); i += 1) {
short_0001 = fabs(*cspan_at(&nodes, i, 6)) < 1e-13 * *cspan_at(&passing, 3);
if (short_0001 && (*cspan_at(&nodes, i, 4) == 0.0)) {
*cspan_at(&nodes, i, 6) = 0.0;
}
}
run_sequence(problem, passing, axis, nodes, span_row(&work, 202));
}
static double idle_time(int64_t i, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
int64_t row;
double before, spent, scale, result;
passing = span_row(&work, 101);
row = 102 + i;
before = i > 0 ? *cspan_at(&work, row - 1, 9) : *cspan_at(&passing, 8);
if ((before != 0.0) || (*cspan_at(&work, row, 9) == 0.0) || (*cspan_at(&work, row + 1, 9) != 0.0)) {
return 0.0;
}
spent = *cspan_at(&work, row, 11) + *cspan_at(&work, row, 10) + *cspan_at(&work, row + 1, 11);
scale = residual_scale((int64_t)(*cspan_at(&passing, 1)) + 1, passing, axis);
result = fabs(*cspan_at(&work, row, 9)) * spent > 1e-12 * scale ? 0.0 : spent;
return result;
}
static int64_t write_sequence(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
double above, level, idle, after, ramp, basis, change, held, order, sign;
int64_t i, row, state, kind, used;
flush_levels(problem, axis, work);
above = *cspan_at(&work, 101, 1);
level = *cspan_at(&work, 101, 8);
used = 0;
idle = 0.0;
for (i = 0; i < (int64_t)(*cspan_at(&work, 101, 0)) + 1; i += 1) {
row = 102 + i;
after = idle;
idle = idle_time(i, axis, work);
if (idle > 0.0) {
state = 0 + (int64_t)(above) + 1;
used = append_phase(phases, used, idle, 0.0, *cspan_at(&work, row, state), 0.0, above - 1.0);
level = 0.0;
continue;
}
if (after == 0.0) {
ramp = *cspan_at(&work, row, 11);
basis = ramp * *cspan_at(&work, 101, 2);
change = *cspan_at(&work, row, 9) - level;
used = append_phase(phases, used, ramp, basis, level, change, above);
}
level = *cspan_at(&work, row, 9);
if ((*cspan_at(&work, row, 10) > 0.0) && ((int64_t)(*cspan_at(&work, row, 7)) == 0)) {
held = level;
order = above;
if ((*cspan_at(&work, row, 4) != 0.0) && (level == 0.0)) {
order = span_max(*cspan_at(&work, row, 4) - 2.0, 0.0);
held = 0.0;
kind = (int64_t)(*cspan_at(&work, row, 4));
if (kind > 1) {
sign = *cspan_at(&work, row, 5);
held = sign * side_limit(kind, sign, axis);
}
}
used = append_phase(phases, used, *cspan_at(&work, row, 10), 0.0, held, 0.0, order);
}
}
return used;
}
static bool stays_below(array_double_2d work) {
int64_t i;
for (i = 0; i < (int64_t)(*cspan_at(&work, 101, 0)); i += 1) {
if ((int64_t)(*cspan_at(&work, 102 + i, 7)) == 2) {
return 1;
}
}
return 0;
}
static double passing_duration(int64_t way, double longest, array_double_1d problem, array_double_1d axis, array_double_2d work) {
bool found;
double result;
restore_sequence(158, work);
if (way == 2) {
found = tighten(longest, problem, axis, work);
}
else if (way == 1) {
found = slow_down(longest, problem, axis, work);
}
else {
found = meet_limits(longest, problem, axis, work);
}
if (!found) {
return -1.0;
}
result = sequence_duration(span_row(&work, 101), span_rows(&work, 102, 120));
return result;
}
static int64_t usual_ways(array_double_1d axis, array_double_2d work) {
int64_t result;
if (is_brief(axis)) {
return 1;
}
result = *cspan_at(&work, 101, 11) == 0.0 ? 3 : 2;
return result;
}
static int64_t shortest_way(int64_t* result_0, double* result_1_0001, int64_t ways, double shortest, double longest, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t used, way;
double found;
used = 0;
for (way = 0; way < ways; way += 1) {
found = passing_duration(way, shortest, problem, axis, work);
if ((found > 0.0) && (found < (1.0 - 1e-09) * shortest)) {
shortest = found;
if (found < longest) {
used = write_sequence(phases, problem, axis, work);
keep_sequence(139, work);
}
if ((way == 2) || ((way == 0) && (!stays_below(work)))) {
*cspan_at(&work, 101, 10) = 1.0;
break;
}
}
}
(*result_0) = used;
(*result_1_0001) = shortest;
return 0;
}
static int64_t passing_form(double shortest, double longest, int64_t count, array_double_2d ramps, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
int64_t ways, others, used;
passing = span_row(&work, 101);
*cspan_at(&passing, 10) = 0.0;
ways = usual_ways(axis, work);
if (!first_solution(count, ramps, problem, axis, work)) {
return 0;
}
used = 0;
if ((*cspan_at(&passing, 11) == 0.0) && shorter_solution(problem, axis, work)) {
shortest_way(&used, &shortest, ways, shortest, longest, phases, problem, axis, work);
if (*cspan_at(&passing, 10) != 0.0) {
return used;
}
first_solution(count, ramps, problem, axis, work);
}
shortest_way(&others, &shortest, ways, shortest, longest, phases, problem, axis, work);
return others > 0 ? others : used;
}
static bool pace_down(int64_t moving, double shortest, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing, taken;
double target, reached, step, least, duration;
restore_sequence(139, work);
passing = span_row(&work, 101);
taken = span_row(&work, 200);
target = *cspan_at(&problem, 5);
keep_sequence(158, work);
*cspan_at(&taken, 4) = 0.0;
*cspan_at(&taken, 6) = moving;
reached = shortest;
step = target - shortest;
least = 0.001 * step;
while(reached < target) {
*cspan_at(&taken, 5) = *cspan_at(&taken, 4) + 40.0;
duration = span_min(reached + step, target);
if (follow(duration, problem, axis, work) && (*cspan_at(&passing, 2) <= 1.0)) {
keep_sequence(158, work);
reached = duration;
}
else {
step = 0.5 * step;
}
if ((step < least) || (*cspan_at(&taken, 4) > 400.0)) {
return 0;
}
}
return 1;
}
static int64_t timed_passing(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
double shortest;
int64_t ways, moving, result;
restore_sequence(139, work);
shortest = sequence_duration(span_row(&work, 101), span_rows(&work, 102, 120));
if (*cspan_at(&problem, 5) < shortest) {
return 0;
}
ways = *cspan_at(&work, 101, 13) != 0.0 ? 2 : 1;
for (moving = 0; moving < ways; moving += 1) {
if (pace_down(moving, shortest, problem, axis, work)) {
result = write_sequence(phases, problem, axis, work);
return result;
}
}
return 0;
}
static int64_t slower_form(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
bool backwards;
if (!is_passing(phases, count, axis)) {
return 0;
}
backwards = *cspan_at(&work, 101, 7) != 0.0;
if (backwards) {
reverse_search(problem, axis);
}
count = timed_passing(phases, problem, axis, work);
if (backwards) {
reverse_search(problem, axis);
reverse_phases(phases, 0, count);
}
return count;
}
static double usual_duration(array_double_1d problem, array_double_1d axis) {
double top, distance, cruise, result;
top = span_min(*cspan_at(&axis, 3), *cspan_at(&axis, 9 + 1));
distance = fabs(*cspan_at(&problem, 4));
cruise = span_max(fabs(*cspan_at(&problem, 0)), fabs(*cspan_at(&problem, 2))) + sqrt(top * distance);
cruise = span_min(slowest_velocity(axis), cruise + top * *cspan_at(&axis, 13));
result = 4.0 * (cruise / top + *cspan_at(&axis, 13)) + distance / cruise;
return result;
}
static int64_t fastest_between(array_double_2d phases, array_double_1d problem, array_double_1d axis) {
double v, a, w, b, duration, end, scale, cruise;
int64_t first, i, side, count;
v = *cspan_at(&problem, 0);
a = *cspan_at(&problem, 1);
w = *cspan_at(&problem, 2);
b = *cspan_at(&problem, 3);
count = append_change(phases, 0, a, b, axis);
if (count > 0) {
duration = *cspan_at(&phases, 0, 0);
end = v + 0.5 * (a + b) * duration;
scale = fabs(v) + fabs(w) + (fabs(a) + fabs(b)) * duration;
if (fabs(end - w) <= 1e-13 * span_min(fastest_velocity(axis), scale)) {
if (valid_duration(phases, count, problem, axis) >= 0.0) {
return count;
}
}
}
first = *cspan_at(&problem, 4) < 0.0 ? 1 : 0;
for (i = 0; i < 2; i += 1) {
side = span_floor_mod((first + i), 2);
cruise = side == 1 ? -*cspan_at(&axis, 9) : *cspan_at(&axis, 2);
count = with_cruise(phases, cruise, problem, axis);
if ((count > 0) && (valid_duration(phases, count, problem, axis) >= 0.0)) {
return count;
}
}
return 0;
}
static int64_t shortest_between(int64_t attempt, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_2d trial;
array_double_1d family;
double shortest, duration;
int64_t found, branch, count, best;
trial = span_rows(&work, 0, 21);
family = span_row(&work, 98);
best = 0;
shortest = 0.0;
if (attempt == 0) {
best = fastest_between(phases, problem, axis);
if (best > 0) {
return best;
}
}
found = -1;
for (branch = 0; branch < 4 + attempt; branch += 1) {
if ((attempt == 0) && (found == branch - 1) && same_members(branch, problem, family)) {
continue;
}
if (branch == 4) {
count = slower_cruise(trial, problem, axis);
}
else {
set_family(branch, problem, axis, family);
if (attempt == 0) {
count = merged_form(trial, *cspan_at(&family, 4), family, axis);
}
else {
count = tempered_form(trial, family, axis);
}
}
if (count > 0) {
duration = valid_duration(trial, count, problem, axis);
if (attempt == 0) {
*cspan_at(&family, 20) = span_min(*cspan_at(&family, 20), total_duration(trial, count));
}
if (duration >= 0.0) {
found = branch;
}
if ((duration >= 0.0) && ((best == 0) || (duration < shortest * (1.0 - 1e-09)))) {
copy_phases(trial, phases, count);
best = count;
shortest = duration;
}
}
}
return best;
}
static bool is_done(array_double_1d problem) {
bool result;
if ((*cspan_at(&problem, 4) != 0.0) || (*cspan_at(&problem, 0) != *cspan_at(&problem, 2))) {
return 0;
}
result = *cspan_at(&problem, 1) == *cspan_at(&problem, 3);
return result;
}
static int64_t braked_variant(int64_t* result_0_0001, double* result_1_0001, int64_t variant, double longest, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work) {
array_double_2d candidate, trial;
array_double_1d rest;
int64_t taken, count;
double spent, duration;
candidate = span_rows(&work, 21, 42);
rest = span_row(&work, 60);
braked(&taken, &spent, span_floor_mod(variant, 4), problem, axis, work);
if (taken == -3) {
(*result_0_0001) = 0;
(*result_1_0001) = 0.0;
return 0;
}
if (taken < 0) {
(*result_0_0001) = taken;
(*result_1_0001) = 0.0;
return 0;
}
count = shortest_between(span_floor_div(variant, 4), candidate, rest, axis, work);
if ((count == 0) && (variant == 4)) {
trial = span_rows(&work, 0, 21);
count = shorter_cruise(0, candidate, rest, axis, trial);
}
if ((count == 0) && (!(is_done(rest) && (*cspan_at(&rest, 1) == 0.0)))) {
(*result_0_0001) = 0;
(*result_1_0001) = 0.0;
return 0;
}
duration = valid_duration(candidate, count, rest, axis);
if ((duration < 0.0) || (spent + duration >= longest)) {
(*result_0_0001) = 0;
(*result_1_0001) = 0.0;
return 0;
}
count = surround(candidate, count, span_floor_mod(variant, 4), problem, axis, work);
copy_phases(candidate, phases, count);
(*result_0_0001) = count;
(*result_1_0001) = spent + duration;
return 0;
}
static int64_t braked_ramps(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work) {
int64_t best, variant, used;
double shortest, usual, duration;
best = count;
shortest = count > 0 ? total_duration(phases, count) * (1.0 - 1e-10) : 1e+300;
usual = usual_duration(problem, axis);
for (variant = 1; variant < 8; variant += 1) {
if ((variant > 4) && (best > 0) && (shortest <= usual)) {
break;
}
braked_variant(&used, &duration, variant, shortest, problem, axis, phases, work);
if ((used < 0) && (count == 0)) {
return used;
}
if (used > 0) {
best = used;
shortest = duration;
}
}
return best == 0 ? -3 : best;
}
static int64_t passing_either_way(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work) {
array_double_2d ramps;
array_double_1d passing;
double longest, whole, settled;
int64_t forwards, result, backwards;
ramps = span_rows(&work, 0, 21);
passing = span_row(&work, 101);
*cspan_at(&passing, 8) = 0.0;
*cspan_at(&passing, 9) = 0.0;
copy_phases(phases, ramps, count);
longest = total_duration(ramps, count) * (1.0 - 1e-09);
whole = longest;
forwards = passing_form(whole, longest, count, ramps, phases, asked, axis, work);
settled = *cspan_at(&passing, 10);
*cspan_at(&passing, 7) = 0.0;
result = count;
if (forwards > 0) {
if ((settled != 0.0) && ramps_suffice(axis)) {
return forwards;
}
longest = total_duration(phases, forwards) * (1.0 - 1e-09);
result = forwards;
}
reverse_search(asked, axis);
reverse_phases(ramps, 0, count);
backwards = passing_form(whole, longest, count, ramps, phases, asked, axis, work);
reverse_search(asked, axis);
if (backwards > 0) {
reverse_phases(phases, 0, backwards);
*cspan_at(&passing, 7) = 1.0;
return backwards;
}
if (forwards > 0) {
*cspan_at(&passing, 10) = settled;
}
return result;
}
static bool set_dips(double v, double a, double end, array_double_1d axis, array_double_1d dips, array_double_2d work) {
double duration, slope, reached;
*cspan_at(&dips, 0) = v;
*cspan_at(&dips, 2) = a;
*cspan_at(&dips, 3) = 0.0;
segfmu_ramp_duration(&duration, &slope, fabs(a), axis);
reached = v + 0.5 * a * duration;
if (!is_beyond(reached, reached, 1.0, axis)) {
return 1;
}
if (!find_dips(v, a, end, axis, dips, work)) {
return 0;
}
find_deepest(axis, dips, work);
return 1;
}
static double problem_between(double depth, array_double_1d asked, array_double_1d axis, array_double_1d rest, array_double_2d work) {
array_double_2d trial;
int64_t first, last;
double spent, y, v, duration, w;
trial = span_rows(&work, 0, 21);
write_dip(&first, &spent, &y, &v, depth, axis, span_row(&work, 63), trial, work);
*cspan_at(&rest, 0) = v;
*cspan_at(&rest, 1) = *cspan_at(&work, 63, 2);
*cspan_at(&rest, 4) = *cspan_at(&asked, 4) - y;
write_dip(&last, &duration, &y, &w, depth, axis, span_row(&work, 64), trial, work);
*cspan_at(&rest, 2) = w;
*cspan_at(&rest, 3) = -*cspan_at(&work, 64, 2);
*cspan_at(&rest, 4) = *cspan_at(&rest, 4) - y;
return spent + duration;
}
static int64_t profile_between(array_double_1d rest, array_double_1d axis, array_double_2d work) {
array_double_2d phases;
int64_t count, result;
phases = span_rows(&work, 65, 98);
if (is_done(rest)) {
return 0;
}
count = shortest_between(0, phases, rest, axis, work);
if (count == 0) {
count = braked_ramps(0, rest, axis, phases, work);
}
if (count <= 0) {
return -1;
}
result = passing_either_way(count, phases, rest, axis, work);
return result;
}
static int64_t with_dips(double depth, int64_t count, array_double_2d phases, array_double_1d axis, array_double_2d work) {
array_double_2d trial, between;
int64_t used, last, result;
double duration, y, v;
trial = span_rows(&work, 0, 21);
between = span_rows(&work, 65, 98);
write_dip(&used, &duration, &y, &v, depth, axis, span_row(&work, 63), phases, work);
used = join_phases(between, count, phases, used);
write_dip(&last, &duration, &y, &v, depth, axis, span_row(&work, 64), trial, work);
reverse_phases(trial, 0, last);
result = join_phases(trial, last, phases, used);
return result;
}
static int64_t dipped_profile(double depth, double longest, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work) {
array_double_1d rest;
array_double_2d between;
double spent;
int64_t count, result;
rest = span_row(&work, 61);
between = span_rows(&work, 65, 98);
spent = problem_between(depth, asked, axis, rest, work);
if (spent >= longest) {
return 0;
}
count = profile_between(rest, axis, work);
if ((count < 0) || (spent + total_duration(between, count) >= longest)) {
return 0;
}
result = with_dips(depth, count, phases, axis, work);
return result;
}
static bool set_both_dips(double end, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d first, last;
bool found, result;
first = span_row(&work, 63);
last = span_row(&work, 64);
if (!set_dips(*cspan_at(&problem, 0), *cspan_at(&problem, 1), end, axis, first, work)) {
return 0;
}
reverse_axis(axis);
found = set_dips(*cspan_at(&problem, 2), -*cspan_at(&problem, 3), end, axis, last, work);
reverse_axis(axis);
result = found && (*cspan_at(&first, 3) + *cspan_at(&last, 3) > 0.0);
return result;
}
static int64_t best_depth(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work) {
double middle, best, depth, longest;
int64_t sweep, i, taken;
middle = 0.5;
best = -1.0;
for (sweep = 0; sweep < 3; sweep += 1) {
for (i = -2; i < 3; i += 1) {
depth = middle + 0.25 * i / pow(2.0, (double)(sweep));
if ((sweep > 0) && ((span_floor_mod(i, 2) == 0) || (depth < 0.0) || (depth > 1.0))) {
continue;
}
longest = total_duration(phases, count) * (1.0 - 1e-09);
taken = dipped_profile(depth, longest, phases, asked, axis, work);
if (taken > 0) {
count = taken;
best = depth;
}
}
if (best < 0.0) {
break;
}
middle = best;
}
return count;
}
static int64_t shorter_dipped(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work) {
int64_t i;
double end;
for (i = 0; i < 3; i += 1) {
end = 0.45 * i * span_min(*cspan_at(&axis, 3), *cspan_at(&axis, 9 + 1));
if (set_both_dips(end, asked, axis, work)) {
count = best_depth(count, phases, asked, axis, work);
}
}
return count;
}
static void surround_with_dips(int64_t column, double depth, array_double_2d phases, array_double_1d axis, array_double_2d work) {
int64_t count;
double duration;
count = (int64_t)(*cspan_at(&work, 58, column));
if (count > 0) {
copy_phases(phases, span_rows(&work, 65, 98), count);
count = with_dips(depth, count, phases, axis, work);
duration = *cspan_at(&work, 59, 5);
*cspan_at(&work, 58, column) = fit_duration(phases, count, duration);
}
}
static double timed_between_dips(array_double_1d rest, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d nearest;
array_double_2d between;
int64_t count;
double result;
nearest = span_row(&work, 58);
between = span_rows(&work, 65, 98);
clear_nearest(work);
if (*cspan_at(&rest, 5) <= 0.0) {
return -1.0;
}
timed_between(rest, axis, cell, work);
if (is_enclosed(work)) {
result = nearest_weight(rest, axis, nearest);
return result;
}
clear_nearest(work);
count = slower_form(profile_between(rest, axis, work), between, rest, axis, work);
copy_phases(between, span_rows(&cell, 0, 33), count);
*cspan_at(&nearest, 0) = count;
return count == 0 ? -1.0 : 0.0;
}
static double timed_dipped(array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem, rest;
int64_t i;
double depth, spent, weight;
array_double_2d below, above;
problem = span_row(&work, 59);
rest = span_row(&work, 61);
if (!set_both_dips(0.0, problem, axis, work)) {
return -1.0;
}
for (i = 0; i < 5; i += 1) {
depth = 0.25 * i;
spent = problem_between(depth, problem, axis, rest, work);
*cspan_at(&rest, 5) = *cspan_at(&problem, 5) - spent;
weight = timed_between_dips(rest, axis, cell, work);
if (weight >= 0.0) {
below = span_rows(&cell, 0, 33);
above = span_rows(&cell, 33, 66);
surround_with_dips(0, depth, below, axis, work);
surround_with_dips(2, depth, above, axis, work);
return weight;
}
}
return -1.0;
}
static double sign_of(double value) {
return value < 0.0 ? -1.0 : 1.0;
}
static bool may_touch(double v, double a, array_double_1d axis) {
double duration, slope, sign;
bool result;
segfmu_ramp_duration(&duration, &slope, fabs(a), axis);
sign = sign_of(a);
result = sign * v + 0.5 * fabs(a) * duration > 0.9 * side_limit(1, sign, axis);
return result;
}
static void set_touching(int64_t variant, double duration, array_double_1d problem, array_double_2d work) {
array_double_1d passing;
int64_t q;
double sign, time, last;
passing = span_row(&work, 101);
q = (int64_t)(*cspan_at(&passing, 1)) + 2;
sign = span_floor_mod(variant, 2) == 1 ? -1.0 : 1.0;
time = duration / (q + 2);
if (q == 4) {
time = 0.7 * time;
}
set_alternating(sign, time, work);
last = sign * (1.0 - 2.0 * (span_floor_mod(q, 2)));
insert_node(q, 0, last, time, 0, work);
if (variant < 4) {
add_instant(1, sign_of(*cspan_at(&problem, 1)), 1 + span_floor_div(variant, 2), passing);
}
else {
add_instant(1, sign_of(-*cspan_at(&problem, 3)), q - 1, passing);
}
if (variant >= 6) {
insert_node(q + 1, 0, -last, time, 0, work);
add_instant(1, sign_of(*cspan_at(&problem, 1)), 1, passing);
}
}
static int64_t touching_guess(int64_t* result_0_0001, double* result_1, int64_t attempt) {
int64_t both, time;
double share;
both = attempt - 5 * 6;
if (both >= 0) {
(*result_0_0001) = 6 + span_floor_mod(both, 2);
(*result_1) = 0.5 + 0.15 * (span_floor_div(both, 2));
return 0;
}
time = span_floor_div(attempt, 6);
share = 0.65;
if (time == 1) {
share = 0.5;
}
else if (time == 2) {
share = 0.75;
}
else if (time == 3) {
share = 1.0;
}
else if (time == 4) {
share = 0.35;
}
(*result_0_0001) = span_floor_mod(attempt, 6);
(*result_1) = share;
return 0;
}
static int64_t touching_starts(int64_t* result_0, double* result_1_0001, int64_t count, double longest, array_double_2d ramps, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
double whole, acceleration, before, share, duration;
bool first, last;
int64_t used, attempts, ways, attempt, variant, found;
passing = span_row(&work, 101);
whole = total_duration(ramps, count);
acceleration = steepest_acceleration(whole, problem, axis);
first = may_touch(*cspan_at(&problem, 0), *cspan_at(&problem, 1), axis);
last = may_touch(*cspan_at(&problem, 2), -*cspan_at(&problem, 3), axis);
used = 0;
before = 0.0;
attempts = 5 * 6 + 4;
ways = usual_ways(axis, work);
if (ramps_suffice(axis)) {
attempts = 6;
ways = 1;
}
for (attempt = 0; attempt < attempts; attempt += 1) {
touching_guess(&variant, &share, attempt);
if (((variant < 4) || (variant > 5)) && (!first)) {
continue;
}
if ((variant > 3) && (!last)) {
continue;
}
begin_sequence(whole, acceleration, axis, passing);
set_touching(variant, share * whole, problem, work);
if (!solve_rotated(problem, axis, work)) {
continue;
}
duration = sequence_duration(passing, span_rows(&work, 102, 120));
if ((duration < longest) && (fabs(duration - before) > 1e-09 * duration)) {
before = duration;
keep_sequence(158, work);
shortest_way(&found, &longest, ways, longest, longest, phases, problem, axis, work);
if (found > 0) {
used = found;
}
}
}
(*result_0) = used;
(*result_1_0001) = longest;
return 0;
}
static int64_t touching_form(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
array_double_2d ramps;
double longest;
int64_t result, backwards;
passing = span_row(&work, 101);
ramps = span_rows(&work, 0, 21);
copy_phases(phases, ramps, count);
*cspan_at(&passing, 8) = 0.0;
*cspan_at(&passing, 9) = 0.0;
longest = total_duration(ramps, count) * (1.0 - 1e-09);
touching_starts(&result, &longest, count, longest, ramps, phases, problem, axis, work);
reverse_search(problem, axis);
touching_starts(&backwards, &longest, count, longest, ramps, phases, problem, axis, work);
reverse_search(problem, axis);
if (backwards > 0) {
reverse_phases(phases, 0, backwards);
*cspan_at(&passing, 7) = 1.0;
return backwards;
}
if (result > 0) {
*cspan_at(&passing, 7) = 0.0;
return result;
}
return count;
}
static double least_lever(double c, double gain, double top, array_double_1d axis) {
double jerk, rise, rest, hold;
if (gain <= 0.0) {
return 0.0;
}
jerk = *cspan_at(&axis, 4);
rise = (top - c) / jerk;
rest = gain - (c + 0.5 * jerk * rise) * rise;
if (rest <= 0.0) {
rise = (sqrt(c * c + 2.0 * jerk * gain) - c) / jerk;
rest = 0.0;
}
hold = rest / top;
return (0.5 * c + jerk * rise / 3.0) * rise * rise + rest * (rise + 0.5 * hold);
}
static double early_window(double duration, array_double_1d problem, array_double_1d axis) {
double sign, v, a, w, b, distance, gain, single, slope, top, jerk, first, last, late, early, rounding, least, most, slowest, fastest;
sign = *cspan_at(&problem, 1) + *cspan_at(&problem, 3) < 0.0 ? -1.0 : 1.0;
v = sign * *cspan_at(&problem, 0);
a = sign * *cspan_at(&problem, 1);
w = sign * *cspan_at(&problem, 2);
b = sign * *cspan_at(&problem, 3);
distance = sign * *cspan_at(&problem, 4);
gain = w - v;
if ((a < 0.0) || (b < 0.0) || (a + b == 0.0) || (*cspan_at(&axis, 0) < 3.0)) {
return 0.0;
}
segfmu_ramp_duration(&single, &slope, fabs(b - a), axis);
if (gain < 0.5 * (a + b) * single * (1.0 - 1e-12)) {
return 0.0;
}
top = side_limit(2, sign, axis);
jerk = *cspan_at(&axis, 4);
first = 0.0;
last = 0.0;
late = 0.0;
early = 0.0;
if ((jerk > 0.0) && (*cspan_at(&axis, 15) > 0.0) && (*cspan_at(&axis, 14) != 0.0)) {
first = 0.5 * a * a / jerk;
last = 0.5 * b * b / jerk;
late = least_lever(b, gain - first, top, axis) - a * first / (3.0 * jerk);
early = least_lever(a, gain - last, top, axis) - b * last / (3.0 * jerk);
}
rounding = 1e-09 * (fabs(distance) + fabs(late) + fabs(early));
late = late - rounding;
early = early - rounding;
least = span_max(single, gain / top);
most = duration;
slowest = v + first;
fastest = w - last;
if (slowest > 0.0) {
most = span_min(most, (distance - late) / slowest);
}
else if (slowest < 0.0) {
least = span_max(least, (distance - late) / slowest);
}
else if (late > distance) {
return 0.0;
}
if (fastest > 0.0) {
least = span_max(least, (distance + early) / fastest);
}
else if (fastest < 0.0) {
most = span_min(most, (distance + early) / fastest);
}
else if (distance + early > 0.0) {
return 0.0;
}
if (most < least * (1.0 - 1e-09)) {
return 0.0;
}
return span_min(most * (1.0 + 1e-09), duration);
}
static double short_window(double duration, array_double_1d problem, array_double_1d axis, array_double_1d rest) {
double a, b, spent, slope, distance, longest, result;
int64_t i;
a = *cspan_at(&problem, 1);
b = *cspan_at(&problem, 3);
if (a * b >= 0.0) {
result = early_window(duration, problem, axis);
return result;
}
if (span_min(fabs(a), fabs(b)) > 0.2 * span_max(fabs(a), fabs(b))) {
return 0.0;
}
for (i = 0; i < rest.shape[0]; i += 1) {
*cspan_at(&rest, i) = *cspan_at(&problem, i);
}
if (fabs(a) < fabs(b)) {
segfmu_ramp_duration(&spent, &slope, fabs(a), axis);
distance = ramp_distance(*cspan_at(&problem, 0), a, 0.0, spent, spent, axis);
*cspan_at(&rest, 0) = *cspan_at(&problem, 0) + 0.5 * a * spent;
*cspan_at(&rest, 1) = 0.0;
}
else {
segfmu_ramp_duration(&spent, &slope, fabs(b), axis);
*cspan_at(&rest, 2) = *cspan_at(&problem, 2) - 0.5 * b * spent;
distance = ramp_distance(*cspan_at(&rest, 2), 0.0, b, spent, spent, axis);
*cspan_at(&rest, 3) = 0.0;
}
*cspan_at(&rest, 4) = *cspan_at(&problem, 4) - distance;
longest = early_window(duration - spent, rest, axis);
return longest > 0.0 ? longest + spent : 0.0;
}
static void begin_search(array_double_1d problem, array_double_1d axis, array_double_2d work) {
boundary_problem(problem, axis, span_row(&work, 59));
*cspan_at(&work, 98, 21) = 0;
*cspan_at(&work, 98, 22) = 0.0;
*cspan_at(&work, 98, 20) = 1e+300;
*cspan_at(&work, 101, 11) = 0.0;
}
static int64_t shortest_ramps(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work) {
array_double_1d asked;
int64_t mirrored, turned, count, result;
asked = span_row(&work, 59);
begin_search(problem, axis, work);
if (is_done(asked)) {
return 0;
}
orient(&mirrored, &turned, asked, axis);
count = shortest_between(0, phases, asked, axis, work);
if (count == 0) {
count = braked_ramps(0, asked, axis, phases, work);
}
result = as_asked(mirrored, turned, count, phases, asked, axis, span_row(&work, 101));
return result;
}
static int64_t usual_braked(array_double_1d asked, array_double_1d axis, array_double_2d phases, array_double_2d work) {
double free, longest, window;
int64_t status, last, count, result;
bool settled, passing;
free = *cspan_at(&work, 98, 20);
status = braked_ramps(0, asked, axis, phases, work);
longest = usual_duration(asked, axis);
if (status > 0) {
settled = 0;
if (*cspan_at(&axis, 38) != 0.0) {
status = passing_either_way(status, phases, asked, axis, work);
settled = (*cspan_at(&work, 101, 10) != 0.0) && ramps_suffice(axis);
}
longest = total_duration(phases, status);
settled = settled && (longest <= 1.1 * free);
if (settled && (early_window(longest, asked, axis) <= 0.0)) {
return status;
}
}
passing = *cspan_at(&asked, 1) * *cspan_at(&asked, 3) <= 0.0;
if (is_resting(asked, axis) || (passing && (status < 0) && (status != -3))) {
return status;
}
last = 6;
count = span_max_int(status, 0);
window = short_window(longest, asked, axis, span_row(&work, 60));
if (window > 0.0) {
count = loop_form(last, count, window, phases, asked, axis, work);
}
else if ((status > 0) && ramps_suffice(axis)) {
last = 2;
}
if ((count == 0) || (total_duration(phases, count) >= longest)) {
count = loop_form(last, count, longest, phases, asked, axis, work);
}
if (count == 0) {
return status;
}
if ((*cspan_at(&axis, 38) != 0.0) && ((status < 0) || (total_duration(phases, count) < longest))) {
result = passing_either_way(count, phases, asked, axis, work);
return result;
}
return count;
}
static int64_t shortest_braked(array_double_1d asked, array_double_1d axis, array_double_2d phases, array_double_2d work) {
double free, most, far;
int64_t status;
free = *cspan_at(&work, 98, 20);
status = usual_braked(asked, axis, phases, work);
if ((status <= 0) || (*cspan_at(&axis, 38) == 0.0)) {
return status;
}
most = 1.05 * free;
far = most;
if (ramps_suffice(axis)) {
most = 1.1 * free;
far = 2.0 * free;
}
else if (total_duration(phases, status) > most) {
status = shorter_dipped(status, phases, asked, axis, work);
}
if ((*cspan_at(&axis, 12) == 2) && (total_duration(phases, status) > far)) {
status = touching_form(status, phases, asked, axis, work);
}
*cspan_at(&work, 98, 22) = total_duration(phases, status) > most;
return status;
}
static bool misses_little(double free, double duration, array_double_1d asked, array_double_1d axis) {
bool result;
if (duration > 1.3 * free) {
return 1;
}
if (early_window(duration, asked, axis) > 0.0) {
return 1;
}
if (nearly_brakes(*cspan_at(&asked, 0), *cspan_at(&asked, 1), axis)) {
return 1;
}
result = nearly_brakes(*cspan_at(&asked, 2), -*cspan_at(&asked, 3), axis);
return result;
}
static bool may_last_longer(array_double_1d problem, array_double_1d axis) {
double fastest;
bool result;
fastest = span_max(fabs(*cspan_at(&problem, 0)), fabs(*cspan_at(&problem, 2)));
result = (*cspan_at(&axis, 14) == 0.0) || (fastest > slowest_velocity(axis));
return result;
}
static int64_t oriented_profile(array_double_1d axis, array_double_2d phases, array_double_2d work) {
array_double_1d asked, family, rest;
int64_t missed, count;
double free, longest;
asked = span_row(&work, 59);
family = span_row(&work, 98);
*cspan_at(&work, 101, 10) = 1.0;
if (is_done(asked)) {
return 0;
}
count = shortest_between(0, phases, asked, axis, work);
missed = (int64_t)(*cspan_at(&family, 21));
if (count == 0) {
free = *cspan_at(&family, 20);
count = shortest_braked(asked, axis, phases, work);
if (*cspan_at(&work, 101, 10) == 0.0) {
missed = span_max_int(missed, 1);
}
if ((count > 0) && misses_little(free, total_duration(phases, count), asked, axis)) {
missed = 2;
}
}
else {
rest = span_row(&work, 60);
longest = short_window(total_duration(phases, count), asked, axis, rest);
if (longest > 0.0) {
count = loop_form(6, count, longest, phases, asked, axis, work);
if (total_duration(phases, count) > longest) {
missed = 2;
}
}
if ((*cspan_at(&axis, 38) != 0.0) && (!ramps_suffice(axis))) {
count = passing_either_way(count, phases, asked, axis, work);
}
}
if ((count > 0) && (*cspan_at(&axis, 14) == 0.0)) {
count = shorter_cruise(count, phases, asked, axis, span_rows(&work, 0, 21));
}
if ((count > 0) && may_last_longer(asked, axis)) {
count = braked_ramps(count, asked, axis, phases, work);
}
if ((!snap_is_last(axis)) && (!is_resting(asked, axis))) {
missed = 2;
}
*cspan_at(&family, 21) = missed;
return count;
}
static int64_t begun_profile(array_double_1d axis, array_double_2d phases, array_double_2d work) {
array_double_1d asked;
int64_t mirrored, turned, count, result;
asked = span_row(&work, 59);
orient(&mirrored, &turned, asked, axis);
count = oriented_profile(axis, phases, work);
result = as_asked(mirrored, turned, count, phases, asked, axis, span_row(&work, 101));
return result;
}
int64_t segfmu_shortest_profile(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work) {
int64_t result;
begin_search(problem, axis, work);
result = begun_profile(axis, phases, work);
return result;
}
static int64_t plain_profile(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work) {
int64_t result;
begin_search(problem, axis, work);
*cspan_at(&work, 101, 11) = 1.0;
result = begun_profile(axis, phases, work);
return result;
}
static double shortest_scale(int64_t order, array_double_1d limits) {
int64_t below;
double scale;
scale = *cspan_at(&limits, order - 1) / *cspan_at(&limits, order);
for (below = 1; below < order - 1; below += 1) {
scale = span_min(scale, pow((*cspan_at(&limits, below) / *cspan_at(&limits, order)), (1.0 / (order - below))));
}
return scale;
}
static double natural_limit(int64_t order, double steep, array_double_1d axis, array_double_1d limits) {
double below, bound, growth, result;
int64_t highest, top, above, given;
below = *cspan_at(&limits, order - 1);
highest = (int64_t)(*cspan_at(&axis, 0)) + 1;
top = 2;
for (above = order + 1; above < highest + 1; above += 1) {
bound = *cspan_at(&axis, 2 + above - 1);
if (bound > 0.0) {
return 2.0 * below * pow((bound / below), (1.0 / (above - order + 1)));
}
}
for (given = 3; given < order; given += 1) {
if (*cspan_at(&axis, 2 + given - 1) > 0.0) {
top = given;
}
}
growth = pow(steep, (1.0 / (highest - top))) / usual_share(axis);
result = growth * below / shortest_scale(order - 1, limits);
return result;
}
static void chain_limits(double steep, array_double_1d axis, array_double_1d state, array_double_1d limits) {
int64_t smoothness, order;
double bound, room, needed;
smoothness = (int64_t)(*cspan_at(&axis, 0));
for (order = 1; order < smoothness + 2; order += 1) {
*cspan_at(&limits, order) = *cspan_at(&axis, 2 + order - 1);
if (*cspan_at(&limits, order) <= 0.0) {
bound = natural_limit(order, steep, axis, limits);
if (order <= smoothness) {
bound = span_max(bound, 2.0 * fabs(*cspan_at(&state, order)));
}
room = span_max(*cspan_at(&limits, order - 2) - fabs(*cspan_at(&state, order - 2)), 0.0);
needed = *cspan_at(&state, order - 1) * *cspan_at(&state, order - 1);
if (needed > room * 10000.0 * bound) {
bound = 10000.0 * bound;
}
else if (needed > room * bound) {
bound = needed / room;
}
*cspan_at(&limits, order) = bound;
}
}
}
static void set_chains(double steep, array_double_1d axis, array_double_1d limits, array_double_2d chains) {
int64_t smoothness, order, i, i_0001;
array_double_1d chain;
smoothness = (int64_t)(*cspan_at(&axis, 0));
for (order = 0; order < smoothness - 1; order += 1) {
chain = span_row(&chains, order);
for (i_0001 = 0; i_0001 < chain.shape[0]; i_0001 += 1) {
*cspan_at(&chain, i_0001) = 0.0;
}
*cspan_at(&chain, 0) = smoothness - order;
*cspan_at(&chain, 1) = 1;
*cspan_at(&chain, 11) = order;
for (i = 0; i < smoothness - order + 1; i += 1) {
*cspan_at(&chain, 2 + i) = *cspan_at(&axis, 2 + order + i);
if (i <= 2) {
*cspan_at(&chain, 2 + i) = *cspan_at(&limits, order + 1 + i);
}
}
*cspan_at(&chain, 9) = *cspan_at(&chain, 2);
*cspan_at(&chain, 9 + 1) = *cspan_at(&chain, 3);
if (order == 0) {
*cspan_at(&chain, 9) = *cspan_at(&axis, 9);
*cspan_at(&chain, 9 + 1) = *cspan_at(&axis, 9 + 1);
}
else if (order == 1) {
*cspan_at(&chain, 9) = *cspan_at(&axis, 9 + 1);
}
segfmu_ramp_parameters(usual_share(chain) / span_min(steep, 10.0), chain, span_rows(&chains, smoothness - 1, smoothness + 1));
}
}
static void lift_pieces(int64_t order, int64_t first, int64_t last, array_double_1d state, array_double_2d timing, array_double_2d coefficients) {
int64_t width, row, j, i, m;
double value, factorial, length;
width = coefficients.shape[1];
for (row = first; row < last; row += 1) {
for (j = 0; j < width - order; j += 1) {
i = width - 1 - j;
value = *cspan_at(&coefficients, row, i - order);
for (m = 0; m < order; m += 1) {
value = value / (i - m);
}
*cspan_at(&coefficients, row, i) = value;
}
factorial = 1.0;
for (i = 0; i < order; i += 1) {
if (i > 0) {
factorial = factorial * i;
}
*cspan_at(&coefficients, row, i) = *cspan_at(&state, i) / factorial;
}
for (i = 0; i < order; i += 1) {
length = *cspan_at(&timing, row, 1);
*cspan_at(&state, i) = evaluate_piece(coefficients, row, width, length, i);
}
}
}
static int64_t append_stage(double v, double a, double w, array_double_2d phases, array_double_1d chain) {
double top;
int64_t result;
top = *cspan_at(&chain, 3);
result = append_velocity_change(phases, 0, v, a, w, top, *cspan_at(&chain, 9 + 1), chain);
return result;
}
static void set_stage_problem(int64_t order, double end, array_double_1d state, array_double_1d problem) {
*cspan_at(&problem, 0) = *cspan_at(&state, order + 1);
*cspan_at(&problem, 1) = *cspan_at(&state, order + 2);
*cspan_at(&problem, 2) = 0.0;
*cspan_at(&problem, 3) = 0.0;
*cspan_at(&problem, 4) = end - *cspan_at(&state, order);
}
static int64_t stage_phases(int64_t order, double end, bool free, array_double_2d lead) {
array_double_1d state, chain, problem;
array_double_2d phases;
int64_t smoothness, result;
state = span_row(&lead, 16);
phases = span_rows(&lead, 26, 59);
smoothness = (int64_t)(*cspan_at(&lead, 61, 0));
if (order == smoothness - 1) {
chain = span_row(&lead, 61 + order - 1);
if (free) {
result = append_change(phases, 0, *cspan_at(&state, order + 1), 0.0, chain);
return result;
}
result = append_stage(*cspan_at(&state, order), *cspan_at(&state, order + 1), end, phases, chain);
return result;
}
chain = span_row(&lead, 61 + order);
if (free) {
result = append_stage(*cspan_at(&state, order + 1), *cspan_at(&state, order + 2), 0.0, phases, chain);
return result;
}
problem = span_row(&lead, 25);
set_stage_problem(order, end, state, problem);
result = shortest_ramps(problem, chain, phases, span_rows(&lead, 68, 308));
return result;
}
static int64_t append_phases(int64_t order, double end, int64_t count, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state, chain, now;
int64_t smoothness, seen, third, i, last;
array_double_2d expansion, phases;
state = span_row(&lead, 16);
smoothness = (int64_t)(*cspan_at(&lead, 61, 0));
seen = span_min_int(order, smoothness - 2);
chain = span_row(&lead, 61 + seen);
if ((count < 0) || (row + segfmu_ramp_pieces(chain) * count > 2 * 400)) {
return -1;
}
expansion = span_rows(&lead, 308, 312);
now = span_row(&expansion, 1);
*cspan_at(&now, 0) = *cspan_at(&state, seen);
*cspan_at(&now, 1) = *cspan_at(&state, seen + 1);
*cspan_at(&now, 2) = *cspan_at(&state, seen + 2);
third = seen + 3;
*cspan_at(&now, 3) = *cspan_at(&state, third);
*cspan_at(&now, 8) = *cspan_at(&state, 8);
phases = span_rows(&lead, 26, 59);
last = segfmu_expand_phases(phases, count, chain, timing, coefficients, row, expansion);
lift_pieces(seen, row, last, state, timing, coefficients);
*cspan_at(&state, seen) = *cspan_at(&now, 0);
*cspan_at(&state, seen + 1) = *cspan_at(&now, 1);
if (end < 1e+300) {
*cspan_at(&state, order) = end;
}
for (i = order + 1; i < smoothness + 1; i += 1) {
*cspan_at(&state, i) = 0.0;
}
*cspan_at(&state, 8) = *cspan_at(&now, 8);
return last;
}
static int64_t run_stage(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double end;
int64_t count, result;
end = *cspan_at(&lead, 21, order);
count = stage_phases(order, end, end >= 1e+300, lead);
result = append_phases(order, end, count, row, lead, timing, coefficients);
return result;
}
static void drop_rounding(int64_t order, array_double_2d lead) {
array_double_1d state;
int64_t i;
double aim;
state = span_row(&lead, 16);
for (i = 1; i < (int64_t)(*cspan_at(&lead, 61, 0)) + 1; i += 1) {
aim = (i == order) && (*cspan_at(&lead, 21, i) < 1e+300) ? *cspan_at(&lead, 21, i) : 0.0;
if (fabs(*cspan_at(&state, i) - aim) <= *cspan_at(&lead, 20, i)) {
*cspan_at(&state, i) = aim;
}
}
}
static int64_t settle_above(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t smoothness, i, stage, i_0001;
smoothness = (int64_t)(*cspan_at(&lead, 61, 0));
for (i_0001 = 0; i_0001 < lead.shape[1]; i_0001 += 1) {
*cspan_at(&lead, 16, i_0001) = *cspan_at(&lead, 15, i_0001);
}
for (i = 0; i < 2; i += 1) {
stage = order + 4 - 2 * i;
if ((stage < smoothness) && (row >= 0)) {
drop_rounding(order, lead);
row = run_stage(stage, row, lead, timing, coefficients);
}
}
if (order < smoothness) {
drop_rounding(order, lead);
}
return row;
}
static int64_t settle(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
row = settle_above(order, row, lead, timing, coefficients);
if ((row >= 0) && (order < (int64_t)(*cspan_at(&lead, 61, 0)))) {
row = run_stage(order, row, lead, timing, coefficients);
}
return row;
}
static double outside_by(double value, int64_t order, array_double_2d lead) {
double low, high;
low = *cspan_at(&lead, 12, order);
high = *cspan_at(&lead, 13, order);
return span_max(value - high, low - value) - 1e-13 * (high - low);
}
static int64_t hold_highest(double value, double length, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state;
int64_t smoothness, i;
double factorial;
state = span_row(&lead, 16);
smoothness = (int64_t)(*cspan_at(&lead, 59, 0));
if ((row < 0) || (row >= 2 * 400)) {
return -1;
}
if (length <= 0.0) {
return row;
}
clear_piece(coefficients, row);
factorial = 1.0;
for (i = 0; i < smoothness + 1; i += 1) {
if (i > 0) {
factorial = factorial * i;
}
*cspan_at(&coefficients, row, i) = *cspan_at(&state, i) / factorial;
}
*cspan_at(&coefficients, row, smoothness + 1) = value / (factorial * (smoothness + 1));
*cspan_at(&timing, row, 0) = *cspan_at(&state, 8);
*cspan_at(&timing, row, 1) = length;
for (i = 0; i < smoothness + 1; i += 1) {
*cspan_at(&state, i) = evaluate_piece(coefficients, row, coefficients.shape[1], length, i);
}
*cspan_at(&state, 8) = *cspan_at(&state, 8) + length;
return row + 1;
}
static int64_t lead_to(int64_t order, double end, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state;
double top, length;
int64_t i, result;
state = span_row(&lead, 16);
if (row < 0) {
return -1;
}
if (order == (int64_t)(*cspan_at(&lead, 59, 0))) {
top = *cspan_at(&lead, 13, order + 1);
if (end < *cspan_at(&state, order)) {
top = *cspan_at(&lead, 12, order + 1);
}
length = (end - *cspan_at(&state, order)) / top;
row = hold_highest(top, length, row, lead, timing, coefficients);
*cspan_at(&state, order) = end;
return row;
}
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 15, i) = *cspan_at(&state, i);
*cspan_at(&lead, 21, i) = 1e+300;
}
*cspan_at(&lead, 21, order) = end;
result = settle(order, row, lead, timing, coefficients);
return result;
}
static int64_t part_hull(int64_t order, int64_t row, double start, double length, array_double_2d lead, array_double_2d coefficients) {
array_double_2d check;
int64_t width;
array_double_1d values;
check = span_rows(&lead, 312, 360);
width = coefficients.shape[1];
while((width > order + 1) && (*cspan_at(&coefficients, row, width - 1) == 0.0)) {
width = width - 1;
}
values = span_row(&check, 43);
polynomial_differentiate(span_row(&coefficients, row), width, order, values);
if (start > 0.0) {
polynomial_shift(values, start, width - order);
}
bernstein_coefficients(check, 43, width - order, length, check);
return width - order;
}
static bool is_hull_inside(int64_t count, double low, double high, array_double_2d lead) {
array_double_2d check;
int64_t i;
check = span_rows(&lead, 312, 360);
for (i = 0; i < count; i += 1) {
if (!((low <= *cspan_at(&check, 0, i)) && (*cspan_at(&check, 0, i) <= high))) {
return 0;
}
}
return 1;
}
static bool stays_inside(int64_t order, int64_t first, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_2d check;
double low, high, slack;
int64_t row, count;
check = span_rows(&lead, 312, 360);
low = *cspan_at(&lead, 12, order);
high = *cspan_at(&lead, 13, order);
slack = 1e-10 * (high - low);
for (row = first; row < last; row += 1) {
count = part_hull(order, row, 0.0, *cspan_at(&timing, row, 1), lead, coefficients);
if (!is_hull_inside(count, low, high, lead)) {
if (!within(check, count, low - slack, high + slack)) {
return 0;
}
}
}
return 1;
}
static double time_crossed(int64_t order, int64_t row, double lower, double upper, array_double_2d lead, array_double_2d coefficients) {
int64_t k;
double middle, value;
for (k = 0; k < 100; k += 1) {
middle = 0.5 * (lower + upper);
if ((middle == lower) || (middle == upper)) {
break;
}
value = evaluate_piece(coefficients, row, coefficients.shape[1], middle, order);
if (outside_by(value, order, lead) > 0.0) {
lower = middle;
}
else {
upper = middle;
}
}
return upper;
}
static int64_t inside_from(int64_t* result_0_0001, double* result_1_0001, int64_t order, int64_t first, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t width, i, row, count;
double low, high, slack, length, upper, step, lower, value;
width = coefficients.shape[1];
low = *cspan_at(&lead, 12, order);
high = *cspan_at(&lead, 13, order);
slack = 1e-13 * (high - low);
for (i = 0; i < last - first; i += 1) {
row = last - 1 - i;
length = *cspan_at(&timing, row, 1);
upper = length;
step = length;
while(upper > 0.0) {
lower = span_max(upper - step, 0.0);
count = part_hull(order, row, lower, upper - lower, lead, coefficients);
if (is_hull_inside(count, low - slack, high + slack, lead)) {
upper = lower;
step = 2.0 * step;
continue;
}
value = evaluate_piece(coefficients, row, width, lower, order);
if (outside_by(value, order, lead) > 0.0) {
count = part_hull(order + 1, row, lower, upper - lower, lead, coefficients);
if (is_hull_inside(count, 0.0, 1e+300, lead) || is_hull_inside(count, -1e+300, 0.0, lead) || (step <= 0.001 * length)) {
(*result_0_0001) = row;
(*result_1_0001) = time_crossed(order, row, lower, upper, lead, coefficients);
return 0;
}
}
if (step > 1e-09 * length) {
step = 0.25 * step;
}
else {
upper = lower;
}
}
}
(*result_0_0001) = first;
(*result_1_0001) = 0.0;
return 0;
}
static int64_t turn_round(int64_t* result_0, int64_t* result_1, double* result_2_0001, int64_t order, double side, double level, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state, turn;
int64_t row, last, i;
double far;
state = span_row(&lead, 16);
turn = span_row(&lead, 10);
row = 400;
for (i = 0; i < state.shape[0]; i += 1) {
*cspan_at(&state, i) = *cspan_at(&lead, 9, i);
}
if (settled && (order + 2 <= (int64_t)(*cspan_at(&lead, 59, 0)))) {
row = lead_to(order + 2, 0.0, row, lead, timing, coefficients);
}
row = lead_to(order + 1, level, row, lead, timing, coefficients);
for (i = 0; i < turn.shape[0]; i += 1) {
*cspan_at(&turn, i) = *cspan_at(&state, i);
}
last = lead_to(order + 1, 0.0, row, lead, timing, coefficients);
far = side < 0.0 ? *cspan_at(&lead, 13, order) : *cspan_at(&lead, 12, order);
(*result_0) = row;
(*result_1) = last;
(*result_2_0001) = side * (*cspan_at(&state, order) - far);
return 0;
}
static double try_brake(int64_t order, double side, double level, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state, turn;
int64_t smoothness, first, row, last, i, i_0001;
double room, near, hold, local, result;
state = span_row(&lead, 16);
turn = span_row(&lead, 10);
smoothness = (int64_t)(*cspan_at(&lead, 59, 0));
first = 400;
turn_round(&row, &last, &room, order, side, level, settled, lead, timing, coefficients);
if (last < 0) {
return 1e+300;
}
if (room < 0.0) {
return -1.0;
}
if (level != 0.0) {
near = side < 0.0 ? *cspan_at(&lead, 12, order) : *cspan_at(&lead, 13, order);
hold = span_min(side * (*cspan_at(&turn, order) - near), room) / fabs(level);
for (i_0001 = 0; i_0001 < state.shape[0]; i_0001 += 1) {
*cspan_at(&state, i_0001) = *cspan_at(&turn, i_0001);
}
row = hold_highest(0.0, hold, row, lead, timing, coefficients);
last = lead_to(order + 1, 0.0, row, lead, timing, coefficients);
}
if ((last < 0) || (outside_by(*cspan_at(&state, order), order, lead) > 0.0)) {
return 1e+300;
}
for (i = order + 1; i < smoothness + 2; i += 1) {
if (!stays_inside(i, first, last, lead, timing, coefficients)) {
return 1e+300;
}
}
inside_from(&row, &local, order, first, last, lead, timing, coefficients);
if ((last > first) && (!stays_inside(order, row + 1, last, lead, timing, coefficients))) {
return 1e+300;
}
*cspan_at(&lead, 14, 2) = last;
result = last == first ? *cspan_at(&lead, 9, 8) : *cspan_at(&timing, row, 0) + local;
return result;
}
static bool set_box(double steep, int64_t loose, array_double_1d limits, array_double_2d lead) {
int64_t smoothness, i, i_0001;
array_double_1d axis, state;
smoothness = limits.shape[0] - 1;
axis = span_row(&lead, 59);
state = span_row(&lead, 16);
segfmu_axis_limits(smoothness, 1, limits, axis);
set_lower(span_row(&lead, 60), axis);
for (i = loose; i < smoothness + 1; i += 1) {
if (*cspan_at(&limits, i - 1) > 0.0) {
*cspan_at(&axis, 2 + i - 1) = span_max(*cspan_at(&limits, i - 1), fabs(*cspan_at(&lead, 7, i)));
}
}
if (!segfmu_ramp_parameters(usual_share(axis), axis, span_rows(&lead, 61, 68))) {
return 0;
}
for (i_0001 = 0; i_0001 < state.shape[0]; i_0001 += 1) {
*cspan_at(&state, i_0001) = 0.0;
}
for (i = 1; i < smoothness + 1; i += 1) {
*cspan_at(&lead, 20, i) = rounding_error(i, limits);
if (*cspan_at(&limits, i - 1) <= 0.0) {
*cspan_at(&state, i) = *cspan_at(&lead, 7, i);
}
}
chain_limits(steep, axis, state, span_row(&lead, 19));
set_chains(steep, axis, span_row(&lead, 19), span_rows(&lead, 61, 68));
for (i = 1; i < smoothness + 2; i += 1) {
*cspan_at(&lead, 12, i) = -*cspan_at(&lead, 19, i);
if (i <= 2) {
*cspan_at(&lead, 12, i) = -*cspan_at(&axis, 9 + i - 1);
}
*cspan_at(&lead, 13, i) = *cspan_at(&lead, 19, i);
}
return 1;
}
static double lower_limit(int64_t order, array_double_1d limits, array_double_2d lead) {
double result;
if ((order <= 2) && (*cspan_at(&lead, 60, order - 1) > 0.0)) {
result = *cspan_at(&lead, 60, order - 1);
return result;
}
result = *cspan_at(&limits, order - 1);
return result;
}
static bool is_outside(array_double_1d limits, array_double_2d lead) {
int64_t i;
double value, bound;
for (i = 1; i < limits.shape[0]; i += 1) {
value = *cspan_at(&lead, 7, i);
bound = value < 0.0 ? lower_limit(i, limits, lead) : *cspan_at(&limits, i - 1);
if ((bound > 0.0) && (fabs(value) > bound * (1.0 + 1e-12))) {
return 1;
}
}
return 0;
}
static void note_extremes(int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_2d check;
array_double_1d report;
int64_t width, parts, order, part, count, i;
double step, value;
check = span_rows(&lead, 312, 360);
report = span_row(&lead, 14);
width = coefficients.shape[1];
parts = 8;
step = *cspan_at(&timing, row, 1) / parts;
for (order = 1; order < span_floor_div(width, 2) + 2; order += 1) {
for (part = 0; part < parts; part += 1) {
count = part_hull(order, row, part * step, step, lead, coefficients);
for (i = 0; i < count; i += 1) {
value = *cspan_at(&check, 0, i);
*cspan_at(&report, 11 + order) = span_min(*cspan_at(&report, 11 + order), value);
*cspan_at(&report, 19 + order) = span_max(*cspan_at(&report, 19 + order), value);
}
}
}
}
static void end_brake(double until, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d report, reached;
int64_t width, first, count, row, i;
double length;
report = span_row(&lead, 14);
reached = span_row(&lead, 9);
width = coefficients.shape[1];
first = 2 * 400;
count = (int64_t)(*cspan_at(&report, 1));
while((count > 0) && (*cspan_at(&timing, first + count - 1, 0) >= until)) {
count = count - 1;
}
*cspan_at(&report, 1) = count;
if (count > 0) {
row = first + count - 1;
length = span_min(*cspan_at(&timing, row, 1), until - *cspan_at(&timing, row, 0));
*cspan_at(&timing, row, 1) = length;
for (i = 0; i < span_floor_div(width, 2) + 1; i += 1) {
*cspan_at(&reached, i) = evaluate_piece(coefficients, row, width, length, i);
}
*cspan_at(&reached, 8) = *cspan_at(&timing, row, 0) + length;
}
}
static void append_pieces(double until, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d report;
int64_t row, target;
report = span_row(&lead, 14);
for (row = 400; row < last; row += 1) {
target = 2 * 400 + (int64_t)(*cspan_at(&report, 1));
if ((*cspan_at(&timing, row, 0) >= until) || (target >= 1200)) {
break;
}
copy_piece(timing, coefficients, row, timing, coefficients, target);
*cspan_at(&report, 1) = *cspan_at(&report, 1) + 1.0;
}
end_brake(until, lead, timing, coefficients);
}
static void split_brake(double until, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d report;
int64_t width, first, last, row, i;
double local, factorial, value;
report = span_row(&lead, 14);
width = coefficients.shape[1];
first = 2 * 400;
last = first + (int64_t)(*cspan_at(&report, 1));
for (row = first; row < last; row += 1) {
local = until - *cspan_at(&timing, row, 0);
if ((local > 0.0) && (local < *cspan_at(&timing, row, 1)) && (last < 1200)) {
for (i = 0; i < last - row; i += 1) {
copy_piece(timing, coefficients, last - 1 - i, timing, coefficients, last - i);
}
factorial = 1.0;
for (i = 0; i < width; i += 1) {
if (i > 0) {
factorial = factorial * i;
}
value = evaluate_piece(coefficients, row, width, local, i);
*cspan_at(&coefficients, row + 1, i) = value / factorial;
}
*cspan_at(&timing, row + 1, 0) = until;
*cspan_at(&timing, row + 1, 1) = *cspan_at(&timing, row, 1) - local;
*cspan_at(&timing, row, 1) = local;
*cspan_at(&report, 1) = *cspan_at(&report, 1) + 1.0;
break;
}
}
}
static double time_inside(array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t first, last, i, row;
double local, until;
first = 2 * 400;
last = first + (int64_t)(*cspan_at(&lead, 14, 1));
until = 0.0;
for (i = 1; i < limits.shape[0]; i += 1) {
if ((*cspan_at(&limits, i - 1) > 0.0) && (last > first)) {
*cspan_at(&lead, 12, i) = -lower_limit(i, limits, lead);
*cspan_at(&lead, 13, i) = *cspan_at(&limits, i - 1);
inside_from(&row, &local, i, first, last, lead, timing, coefficients);
until = span_max(until, *cspan_at(&timing, row, 0) + local);
}
}
return until;
}
static double level_limit(int64_t order, double side, array_double_2d lead) {
double result;
result = side < 0.0 ? *cspan_at(&lead, 13, order + 1) : *cspan_at(&lead, 12, order + 1);
return result;
}
static double deepest_level(int64_t order, double side, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double edge, near, e_other, e_newest, newest, other, before, e_before, level, room;
int64_t row, last, i;
edge = level_limit(order, side, lead);
near = 0.001 * (*cspan_at(&lead, 13, order) - *cspan_at(&lead, 12, order));
turn_round(&row, &last, &e_other, order, side, 0.0, settled, lead, timing, coefficients);
if ((last < 0) || (e_other < 0.0)) {
return 0.0;
}
turn_round(&row, &last, &e_newest, order, side, edge, settled, lead, timing, coefficients);
newest = 1.0;
other = 0.0;
before = 0.0;
e_before = e_other;
for (i = 0; i < 100; i += 1) {
level = next_point(newest, other, before, e_newest, e_other, e_before);
turn_round(&row, &last, &room, order, side, level * edge, settled, lead, timing, coefficients);
if ((last < 0) || ((0.0 <= room) && (room <= near)) || (fabs(newest - other) < 0.001)) {
break;
}
next_bracket(&newest, &other, &before, &e_newest, &e_other, &e_before, room * e_newest < 0.0, level, room, newest, other, e_newest, e_other);
}
if (room < 0.0) {
level = other;
}
return level * edge;
}
static int64_t best_level(double* result_0, double* result_1, int64_t order, double side, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double level, time;
int64_t i;
level = level_limit(order, side, lead);
time = try_brake(order, side, level, settled, lead, timing, coefficients);
if (time < 0.0) {
level = deepest_level(order, side, settled, lead, timing, coefficients);
time = try_brake(order, side, level, settled, lead, timing, coefficients);
}
for (i = 0; i < 6; i += 1) {
if ((0.0 <= time) && (time < 1e+300)) {
(*result_0) = time;
(*result_1) = level;
return 0;
}
level = i == 5 ? 0.0 : 0.5 * level;
time = try_brake(order, side, level, settled, lead, timing, coefficients);
}
if (time < 0.0) {
time = 1e+300;
}
(*result_0) = time;
(*result_1) = level;
return 0;
}
static int64_t level_time(double* result_0, double* result_1, int64_t order, double side, double gentle, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double level, time;
if (gentle > 0.0) {
level = (1.0 - gentle) * level_limit(order, side, lead);
time = try_brake(order, side, level, settled, lead, timing, coefficients);
if ((time >= 0.0) && (time < 1e+300)) {
(*result_0) = time;
(*result_1) = level;
return 0;
}
}
best_level(result_0, result_1, order, side, settled, lead, timing, coefficients);
return 0;
}
static double side_beyond(int64_t order, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state, reached;
double low, value, result;
int64_t first, last, i, i_0001;
state = span_row(&lead, 16);
reached = span_row(&lead, 9);
low = *cspan_at(&lead, 12, order);
first = 400;
for (i_0001 = 0; i_0001 < state.shape[0]; i_0001 += 1) {
*cspan_at(&state, i_0001) = *cspan_at(&reached, i_0001);
}
last = lead_to(order + 1, 0.0, first, lead, timing, coefficients);
for (i = 0; i < 2; i += 1) {
value = i == 1 ? *cspan_at(&reached, order) : *cspan_at(&state, order);
if (outside_by(value, order, lead) > 0.0) {
return value > low ? 1.0 : -1.0;
}
}
if ((last >= 0) && stays_inside(order, first, last, lead, timing, coefficients)) {
return 0.0;
}
result = *cspan_at(&reached, order + 1) > 0.0 ? 1.0 : -1.0;
return result;
}
static void bring_highest(array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t order, last, i;
double value, end, until;
order = (int64_t)(*cspan_at(&lead, 59, 0));
value = *cspan_at(&lead, 9, order);
end = span_min(span_max(value, *cspan_at(&lead, 12, order)), *cspan_at(&lead, 13, order));
if (outside_by(value, order, lead) > 0.0) {
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 16, i) = *cspan_at(&lead, 9, i);
}
last = lead_to(order, end, 400, lead, timing, coefficients);
until = *cspan_at(&lead, 16, 8);
append_pieces(until, last, lead, timing, coefficients);
*cspan_at(&lead, 14, 0) = until;
}
*cspan_at(&lead, 9, order) = end;
}
static bool bring_gently(int64_t order, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t first, last, i, i_0001;
array_double_1d reached, state;
double value, end, until;
first = 400;
reached = span_row(&lead, 9);
state = span_row(&lead, 16);
value = *cspan_at(&reached, order);
if (!(outside_by(value, order, lead) > 0.0)) {
return 0;
}
end = span_min(span_max(value, *cspan_at(&lead, 12, order)), *cspan_at(&lead, 13, order));
for (i_0001 = 0; i_0001 < state.shape[0]; i_0001 += 1) {
*cspan_at(&state, i_0001) = *cspan_at(&reached, i_0001);
}
last = lead_to(order, end, first, lead, timing, coefficients);
if (last < 0) {
return 0;
}
for (i = order + 1; i < (int64_t)(*cspan_at(&lead, 59, 0)) + 2; i += 1) {
if (!stays_inside(i, first, last, lead, timing, coefficients)) {
return 0;
}
}
until = *cspan_at(&state, 8);
append_pieces(until, last, lead, timing, coefficients);
for (i = order + 1; i < (int64_t)(*cspan_at(&lead, 59, 0)) + 1; i += 1) {
*cspan_at(&reached, i) = 0.0;
}
*cspan_at(&reached, order) = end;
*cspan_at(&lead, 14, 0) = until;
*cspan_at(&lead, 11, order) = until;
return 1;
}
static bool bring_inside(int64_t order, bool whole, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d report, reached;
double gentle, side, time, level, start, low;
bool settled;
int64_t i;
report = span_row(&lead, 14);
reached = span_row(&lead, 9);
gentle = *cspan_at(&report, 3 + order);
*cspan_at(&lead, 11, order) = 0.0;
if ((gentle == 1.0) && bring_gently(order, lead, timing, coefficients)) {
return 1;
}
side = side_beyond(order, lead, timing, coefficients);
if ((side == 0.0) && (!whole)) {
return 1;
}
time = 1e+300;
level = 0.0;
settled = 0;
for (i = 0; i < 2; i += 1) {
if (time >= 1e+300) {
settled = i == 1;
if (side == 0.0) {
time = try_brake(order, 1.0, 0.0, settled, lead, timing, coefficients);
}
else {
level_time(&time, &level, order, side, gentle, settled, lead, timing, coefficients);
}
}
}
if (time >= 1e+300) {
return 0;
}
start = *cspan_at(&reached, 8);
if (side != 0.0) {
try_brake(order, side, level, settled, lead, timing, coefficients);
}
if (time > start) {
*cspan_at(&report, 0) = time;
*cspan_at(&lead, 11, order) = time;
}
else if (!whole) {
return 1;
}
if (whole) {
time = 1e+300;
}
append_pieces(time, (int64_t)(*cspan_at(&report, 2)), lead, timing, coefficients);
for (i = order; i < reached.shape[0] - 2; i += 1) {
if (i <= (int64_t)(*cspan_at(&lead, 59, 0))) {
if (whole && (i > order)) {
*cspan_at(&reached, i) = 0.0;
}
low = *cspan_at(&lead, 12, i);
*cspan_at(&reached, i) = span_min(span_max(*cspan_at(&reached, i), low), *cspan_at(&lead, 13, i));
}
}
return 1;
}
static double kind_of(bool whole, array_double_1d limits) {
double result;
result = whole ? -(double)(limits.shape[0]) : (double)(limits.shape[0]);
return result;
}
static bool is_kept(int64_t row, bool whole, array_double_1d limits, array_double_2d lead) {
int64_t i;
if (*cspan_at(&lead, row, 0) != kind_of(whole, limits)) {
return 0;
}
for (i = 0; i < limits.shape[0]; i += 1) {
if (*cspan_at(&lead, row, 8 + i) != *cspan_at(&limits, i)) {
return 0;
}
if (*cspan_at(&lead, row, 1 + i) != *cspan_at(&lead, 7, 0 + i)) {
return 0;
}
}
for (i = 0; i < 2; i += 1) {
if (*cspan_at(&lead, row, 15 + i) != *cspan_at(&lead, 60, i)) {
return 0;
}
}
return 1;
}
static int64_t kept_brake(bool whole, array_double_1d limits, array_double_2d lead) {
int64_t row;
for (row = 3; row < 7; row += 1) {
if (is_kept(row, whole, limits, lead)) {
return row;
}
}
return -1;
}
static void keep_brake(bool whole, double steep, int64_t loose, array_double_1d limits, array_double_2d lead) {
int64_t row, i;
row = 3 + (int64_t)(*cspan_at(&lead, 0, 6));
*cspan_at(&lead, 0, 6) = 0.0;
if (row + 1 < 7) {
*cspan_at(&lead, 0, 6) = row + 1 - 3;
}
*cspan_at(&lead, row, 0) = kind_of(whole, limits);
*cspan_at(&lead, row, 17) = steep;
*cspan_at(&lead, row, 18) = loose;
for (i = 0; i < limits.shape[0]; i += 1) {
*cspan_at(&lead, row, 8 + i) = *cspan_at(&limits, i);
*cspan_at(&lead, row, 1 + i) = *cspan_at(&lead, 7, 0 + i);
*cspan_at(&lead, row, 19 + i) = *cspan_at(&lead, 14, 3 + i);
}
for (i = 0; i < 2; i += 1) {
*cspan_at(&lead, row, 15 + i) = *cspan_at(&lead, 60, i);
}
}
static void clip_reached(array_double_2d lead) {
int64_t i;
double value;
for (i = 1; i < (int64_t)(*cspan_at(&lead, 59, 0)) + 1; i += 1) {
value = span_max(*cspan_at(&lead, 9, i), *cspan_at(&lead, 12, i));
*cspan_at(&lead, 9, i) = span_min(value, *cspan_at(&lead, 13, i));
}
}
static int64_t brake_within(double steep, int64_t loose, bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t smoothness, i, order, i_0001, result;
array_double_1d report;
bool let_go;
smoothness = limits.shape[0] - 1;
report = span_row(&lead, 14);
*cspan_at(&report, 0) = 0.0;
*cspan_at(&report, 1) = 0.0;
if (!set_box(steep, loose, limits, lead)) {
return -1;
}
for (i_0001 = 0; i_0001 < lead.shape[1]; i_0001 += 1) {
*cspan_at(&lead, 9, i_0001) = *cspan_at(&lead, 7, i_0001);
}
bring_highest(lead, timing, coefficients);
let_go = whole || (loose <= smoothness);
for (i = 1; i < smoothness; i += 1) {
order = smoothness - i;
if (!bring_inside(order, let_go && (order == 1), lead, timing, coefficients)) {
return -1;
}
}
if (let_go) {
if (loose <= smoothness) {
*cspan_at(&report, 0) = time_inside(limits, lead, timing, coefficients);
}
split_brake(*cspan_at(&report, 0), lead, timing, coefficients);
if (!whole) {
end_brake(*cspan_at(&report, 0), lead, timing, coefficients);
clip_reached(lead);
}
}
result = (int64_t)(*cspan_at(&report, 1));
return result;
}
static int64_t best_steepness(double* result_0_0001, double* result_1, int64_t loose, bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t highest, i, count;
double best, steep, chosen, until;
highest = 1;
for (i = 0; i < limits.shape[0]; i += 1) {
if (*cspan_at(&limits, i) <= 0.0) {
highest = 8;
}
}
best = 1e+300;
steep = 1.0;
chosen = 0.0;
for (i = 0; i < highest; i += 1) {
count = brake_within(steep, loose, whole, limits, lead, timing, coefficients);
until = *cspan_at(&lead, 14, 0);
if ((count >= 0) && (until == 0.0)) {
(*result_0_0001) = steep;
(*result_1) = 0.0;
return 0;
}
if ((count > 0) && (until < 0.997 * best)) {
best = until;
chosen = steep;
}
else if ((best < 1e+300) && (i > 1)) {
break;
}
steep = 10.0 * steep;
}
(*result_0_0001) = chosen;
(*result_1) = best;
return 0;
}
static int64_t choose_brake(bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d report;
int64_t smoothness, loose, i, order, count;
double chosen, best, steep, until, inside, gentle;
report = span_row(&lead, 14);
smoothness = limits.shape[0] - 1;
loose = smoothness + 1;
best_steepness(&chosen, &best, loose, whole, limits, lead, timing, coefficients);
if (best == 0.0) {
count = (int64_t)(*cspan_at(&report, 1));
return count;
}
for (i = 0; i < smoothness - 2; i += 1) {
order = smoothness - i;
if ((*cspan_at(&limits, order - 1) > 0.0) && (fabs(*cspan_at(&lead, 7, order)) > *cspan_at(&limits, order - 1))) {
best_steepness(&steep, &until, order, whole, limits, lead, timing, coefficients);
if ((steep > 0.0) && (until < 0.5 * best)) {
chosen = steep;
best = until;
loose = order;
}
}
}
if ((chosen == 0.0) && (smoothness > 2)) {
*cspan_at(&report, 3 + 2) = 0.5;
best_steepness(&chosen, &best, loose, whole, limits, lead, timing, coefficients);
}
if (chosen == 0.0) {
keep_brake(whole, chosen, loose, limits, lead);
return -1;
}
count = brake_within(chosen, loose, whole, limits, lead, timing, coefficients);
for (order = 2; order < smoothness; order += 1) {
inside = *cspan_at(&lead, 11, order);
gentle = *cspan_at(&report, 3 + order);
if ((0.0 < inside) && (inside < *cspan_at(&report, 0))) {
for (i = 1; i < 5; i += 1) {
*cspan_at(&report, 3 + order) = 0.25 * i;
count = brake_within(chosen, loose, whole, limits, lead, timing, coefficients);
if ((count > 0) && (*cspan_at(&report, 0) < (1.0 - 0.001) * best)) {
best = *cspan_at(&report, 0);
gentle = *cspan_at(&report, 3 + order);
}
}
*cspan_at(&report, 3 + order) = gentle;
count = brake_within(chosen, loose, whole, limits, lead, timing, coefficients);
}
}
keep_brake(whole, chosen, loose, limits, lead);
return count;
}
int64_t segfmu_find_brake(bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t smoothness, kept, i, first, row, i_0001, count;
array_double_1d report;
smoothness = limits.shape[0] - 1;
if ((smoothness < 2) || (smoothness > 6) || (coefficients.shape[1] != 2 * smoothness)) {
return -1;
}
report = span_row(&lead, 14);
for (i_0001 = 0; i_0001 < report.shape[0]; i_0001 += 1) {
*cspan_at(&report, i_0001) = 0.0;
}
count = -1;
kept = kept_brake(whole, limits, lead);
if (kept < 0) {
count = choose_brake(whole, limits, lead, timing, coefficients);
}
else if (*cspan_at(&lead, kept, 17) > 0.0) {
for (i = 0; i < limits.shape[0]; i += 1) {
*cspan_at(&report, 3 + i) = *cspan_at(&lead, kept, 19 + i);
}
count = brake_within(*cspan_at(&lead, kept, 17), (int64_t)(*cspan_at(&lead, kept, 18)), whole, limits, lead, timing, coefficients);
}
first = 2 * 400;
for (row = first; row < first + count; row += 1) {
if (*cspan_at(&timing, row, 0) < *cspan_at(&report, 0)) {
note_extremes(row, lead, timing, coefficients);
}
}
return count;
}
static void write_end(int64_t last, array_double_2d timing, array_double_2d coefficients, array_double_1d end) {
int64_t width, order;
double length;
width = coefficients.shape[1];
length = *cspan_at(&timing, last, 1);
for (order = 0; order < 3; order += 1) {
*cspan_at(&end, order) = evaluate_piece(coefficients, last, width, length, order);
}
*cspan_at(&end, 3) = *cspan_at(&timing, last, 0) + length;
}
static bool is_at_velocity(double velocity, array_double_1d limits, array_double_1d end) {
double missed;
bool result;
missed = *cspan_at(&end, 1) - velocity;
if (fabs(missed) > 1e-11 * *cspan_at(&limits, 0)) {
return 0;
}
result = fabs(*cspan_at(&end, 2)) <= 1e-11 * *cspan_at(&limits, 1);
return result;
}
void segfmu_plan_ends(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d ends) {
int64_t axis;
for (axis = 0; axis < offsets.shape[0] - 1; axis += 1) {
write_end(*cspan_at(&offsets, axis + 1) - 1, timing, coefficients, span_row(&ends, axis));
}
}
bool segfmu_are_at_velocities(array_double_2d targets, array_double_2d limits, array_double_2d ends) {
int64_t axis;
double velocity;
for (axis = 0; axis < ends.shape[0]; axis += 1) {
velocity = *cspan_at(&targets, axis, 1);
if (!is_at_velocity(velocity, span_row(&limits, axis), span_row(&ends, axis))) {
return 0;
}
}
return 1;
}
static int64_t level_order(int64_t order, array_double_2d lead) {
int64_t seen, above;
seen = 2 - order;
above = (int64_t)(*cspan_at(&lead, 61 + seen, 38));
return above == 0 ? 0 : seen + 2 + above;
}
static double lead_end(int64_t order, array_double_2d lead) {
double result;
if (order == 1) {
result = *cspan_at(&lead, 24, 2);
return result;
}
result = *cspan_at(&lead, 24, 4);
return result;
}
static int64_t passing_phases(int64_t order, double least, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state, level, chain, problem, passing;
int64_t seen, count, third, result;
array_double_2d phases, plan, ramps;
double end, longest;
state = span_row(&lead, 16);
level = span_row(&lead, 17);
seen = 2 - order;
chain = span_row(&lead, 61 + seen);
problem = span_row(&lead, 25);
phases = span_rows(&lead, 26, 59);
plan = span_rows(&lead, 68, 308);
ramps = span_rows(&plan, 0, 21);
passing = span_row(&plan, 101);
end = lead_end(order, lead);
*cspan_at(&lead, 21, seen + 2) = 1e+300;
if (run_stage(seen + 2, row, lead, timing, coefficients) < 0) {
return 0;
}
longest = *cspan_at(&state, 8) - *cspan_at(&level, 8);
set_stage_problem(seen, end, state, problem);
count = shortest_ramps(problem, chain, phases, plan);
if (count <= 0) {
return 0;
}
copy_phases(phases, ramps, count);
longest = span_min(longest + total_duration(ramps, count), least - *cspan_at(&level, 8));
set_stage_problem(seen, end, level, problem);
*cspan_at(&passing, 11) = 1.0;
*cspan_at(&passing, 8) = (*cspan_at(&level, level_order(order, lead)));
third = seen + 3;
*cspan_at(&passing, 9) = *cspan_at(&level, third);
result = passing_form(longest, longest, count, ramps, phases, problem, chain, plan);
return result;
}
static int64_t settle_over_level(int64_t order, double end, double least, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state, level;
int64_t stage, count, seen, i, result;
state = span_row(&lead, 16);
level = span_row(&lead, 17);
stage = level_order(order, lead);
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 21, i) = 1e+300;
}
*cspan_at(&lead, 21, stage) = end;
row = settle(stage, row, lead, timing, coefficients);
if ((row < 0) || (*cspan_at(&state, 8) >= least)) {
return -1;
}
for (i = 0; i < level.shape[0]; i += 1) {
*cspan_at(&level, i) = *cspan_at(&state, i);
}
count = passing_phases(order, least, row, lead, timing, coefficients);
for (i = 0; i < state.shape[0]; i += 1) {
*cspan_at(&state, i) = *cspan_at(&level, i);
}
if (count == 0) {
return -1;
}
seen = 2 - order;
end = lead_end(order, lead);
result = append_phases(seen, end, count, row, lead, timing, coefficients);
return result;
}
static void set_limits(double steep, array_double_2d lead) {
array_double_1d axis;
axis = span_row(&lead, 59);
chain_limits(steep, axis, span_row(&lead, 15), span_row(&lead, 19));
set_chains(steep, axis, span_row(&lead, 19), span_rows(&lead, 61, 68));
}
static bool is_settled(array_double_2d lead) {
int64_t i;
for (i = 3; i < (int64_t)(*cspan_at(&lead, 59, 0)) + 1; i += 1) {
if (*cspan_at(&lead, 15, i) != 0.0) {
return 0;
}
}
return 1;
}
static void soonest_ends(int64_t order, array_double_2d lead) {
int64_t i;
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 21, i) = 1e+300;
}
if (order == 1) {
*cspan_at(&lead, 21, order) = *cspan_at(&lead, 24, 2);
}
}
static double profile_time(bool ramps, array_double_2d lead) {
array_double_1d state, target, problem, axis;
array_double_2d phases;
int64_t order, count;
double value, result;
state = span_row(&lead, 16);
target = span_row(&lead, 24);
problem = span_row(&lead, 25);
axis = span_row(&lead, 59);
phases = span_rows(&lead, 26, 59);
for (order = 1; order < 3; order += 1) {
value = *cspan_at(&state, 0 + order);
if (fabs(value) > side_limit(order, value, axis) * (1.0 + 1e-12)) {
return -1.0;
}
}
*cspan_at(&problem, 0) = *cspan_at(&state, 0 + 1);
*cspan_at(&problem, 1) = *cspan_at(&state, 0 + 2);
*cspan_at(&problem, 2) = *cspan_at(&target, 2);
*cspan_at(&problem, 3) = *cspan_at(&target, 3);
*cspan_at(&problem, 4) = *cspan_at(&target, 4) - *cspan_at(&state, 0);
count = -1;
if (ramps) {
count = shortest_ramps(problem, axis, phases, span_rows(&lead, 68, 308));
}
else {
count = plain_profile(problem, axis, phases, span_rows(&lead, 68, 308));
}
if (count < 0) {
return -1.0;
}
result = total_duration(phases, count);
return result;
}
static void time_anew(int64_t order, array_double_2d lead) {
double rest, time;
int64_t i;
if ((order == 1) || (*cspan_at(&lead, 23, 0) < 0.0)) {
return;
}
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 16, i) = *cspan_at(&lead, 18, i);
}
rest = profile_time(0, lead);
if (rest >= 0.0) {
time = *cspan_at(&lead, 16, 8) + rest;
*cspan_at(&lead, 23, 0) = span_min(*cspan_at(&lead, 23, 0), time);
}
}
static void keep_lead(int64_t last, double time, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t first, row, i;
first = 400;
for (row = first; row < last; row += 1) {
copy_piece(timing, coefficients, row, timing, coefficients, row - first);
}
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 18, i) = *cspan_at(&lead, 16, i);
*cspan_at(&lead, 22, i) = *cspan_at(&lead, 21, i);
}
*cspan_at(&lead, 23, 0) = time;
*cspan_at(&lead, 23, 1) = last - first;
}
static bool begins_now(array_double_2d lead, array_double_2d coefficients) {
int64_t width, i;
double value;
width = coefficients.shape[1];
for (i = 1; i < span_floor_div(width, 2) + 1; i += 1) {
value = evaluate_piece(coefficients, 400, width, 0.0, i);
if (!(fabs(value - *cspan_at(&lead, 7, i)) <= 1e-11 * *cspan_at(&lead, 19, i))) {
return 0;
}
}
return 1;
}
static bool is_better(double time, array_double_2d lead) {
double best;
bool result;
best = *cspan_at(&lead, 23, 0);
result = (best < 0.0) || (time < best * *cspan_at(&lead, 23, 4));
return result;
}
static bool keep_better(int64_t last, double time, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t first;
array_double_2d check;
array_double_1d lower;
first = 400;
if (!is_better(time, lead)) {
return 0;
}
check = span_rows(&lead, 312, 360);
lower = span_row(&lead, 60);
if (last > first) {
if (!begins_now(lead, coefficients)) {
return 0;
}
keep_inside(check);
if (!check_axis(first, last, timing, coefficients, limits, lower, 1e-09, 0.5 * 1e-09, check)) {
return 0;
}
}
keep_lead(last, time, lead, timing, coefficients);
*cspan_at(&lead, 23, 4) = 1.0 - 1e-12;
return 1;
}
static double try_velocity(int64_t row, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t order, count, last;
double end, time;
array_double_2d phases;
order = 1;
row = settle_above(order, row, lead, timing, coefficients);
if (row < 0) {
return 1e+300;
}
end = *cspan_at(&lead, 21, order);
count = stage_phases(order, end, 0, lead);
if (count < 0) {
return 1e+300;
}
phases = span_rows(&lead, 26, 59);
time = *cspan_at(&lead, 16, 8) + total_duration(phases, count);
if (!is_better(time, lead)) {
return time;
}
last = append_phases(order, end, count, row, lead, timing, coefficients);
if (last < 0) {
return 1e+300;
}
time = *cspan_at(&lead, 16, 8);
keep_better(last, time, limits, lead, timing, coefficients);
return time;
}
static double try_lead(int64_t order, int64_t row, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t last;
double best, rest, time;
if (order == 1) {
time = try_velocity(row, limits, lead, timing, coefficients);
return time;
}
last = settle(order, row, lead, timing, coefficients);
if (last < 0) {
return 1e+300;
}
time = *cspan_at(&lead, 16, 8);
best = *cspan_at(&lead, 23, 0);
if ((best >= 0.0) && (time >= best)) {
return 1e+300;
}
rest = profile_time(1, lead);
if (rest < 0.0) {
return 1e+300;
}
time = time + rest;
keep_better(last, time, limits, lead, timing, coefficients);
return time;
}
static double try_level(int64_t order, double level, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t last;
double time;
last = settle_over_level(order, level, least, 400, lead, timing, coefficients);
if (last < 0) {
return 1e+300;
}
time = *cspan_at(&lead, 16, 8);
keep_better(last, time, limits, lead, timing, coefficients);
return time;
}
static double try_end(int64_t order, int64_t stage, double end, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double bound, result;
int64_t i;
bound = *cspan_at(&lead, 19, stage);
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 21, i) = *cspan_at(&lead, 22, i);
}
*cspan_at(&lead, 21, stage) = span_min(span_max(end, -bound), bound);
result = try_lead(order, 400, limits, lead, timing, coefficients);
return result;
}
static void search_end(int64_t order, int64_t stage, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double bound, end, step, around, nearest, time;
int64_t i, side;
bound = *cspan_at(&lead, 19, stage);
if ((*cspan_at(&lead, 22, stage) >= 1e+300) || (*cspan_at(&lead, 23, 0) < 0.0)) {
try_end(order, stage, 0.0, limits, lead, timing, coefficients);
end = bound;
for (i = 0; i < 4; i += 1) {
try_end(order, stage, end, limits, lead, timing, coefficients);
try_end(order, stage, -end, limits, lead, timing, coefficients);
end = 0.25 * end;
}
}
step = 0.125 * bound;
for (i = 0; i < 10; i += 1) {
around = *cspan_at(&lead, 22, stage);
if (around >= 1e+300) {
break;
}
nearest = 1e+300;
for (side = 0; side < 2; side += 1) {
end = around + step * (1 - 2 * side);
if ((fabs(end) <= bound) || (fabs(around) < bound)) {
time = try_end(order, stage, end, limits, lead, timing, coefficients);
if (time >= *cspan_at(&lead, 23, 0)) {
nearest = span_min(nearest, time);
}
}
}
if (*cspan_at(&lead, 22, stage) == around) {
if (nearest <= (1.0 + 0.001) * *cspan_at(&lead, 23, 0)) {
break;
}
step = 0.5 * step;
}
}
}
static bool leads_in(double time, array_double_2d lead) {
bool result;
result = (0.0 <= *cspan_at(&lead, 23, 0)) && (*cspan_at(&lead, 23, 0) <= time);
return result;
}
static int64_t first_free_stage(int64_t order) {
return order == 1 ? order + 2 : order;
}
static void try_soonest(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d first;
int64_t stage, i;
double time, bound, before, level;
first = span_row(&lead, 26);
stage = first_free_stage(order);
soonest_ends(order, lead);
time = try_lead(order, 400, limits, lead, timing, coefficients);
if (is_settled(lead) || (stage >= (int64_t)(*cspan_at(&lead, 59, 0)))) {
return;
}
bound = *cspan_at(&lead, 19, stage);
for (i = 0; i < 8; i += 1) {
if ((time >= 1e+300) || (*cspan_at(&first, 4) != 0.0)) {
break;
}
before = *cspan_at(&lead, 23, 0);
level = *cspan_at(&first, 2) + *cspan_at(&first, 3);
*cspan_at(&lead, 21, stage) = span_min(span_max(level, -bound), bound);
time = try_lead(order, 400, limits, lead, timing, coefficients);
if ((before >= 0.0) && ((1.0 + 0.001) * *cspan_at(&lead, 23, 0) > before)) {
break;
}
}
}
static void improve_ends(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t i, stage;
for (i = 0; i < 2; i += 1) {
stage = first_free_stage(order) + 2 * i;
if (leads_in(within_0001, lead)) {
break;
}
if (stage < (int64_t)(*cspan_at(&lead, 59, 0))) {
search_end(order, stage, limits, lead, timing, coefficients);
}
}
}
static bool try_steeper(int64_t order, double within_0001, int64_t times, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double steep, before;
bool shorter, result;
steep = pow(10.0, (double)(times));
set_limits(steep, lead);
*cspan_at(&lead, 23, 4) = 0.99;
before = *cspan_at(&lead, 23, 0);
try_soonest(order, limits, lead, timing, coefficients);
*cspan_at(&lead, 23, 4) = 1.0 - 1e-12;
shorter = *cspan_at(&lead, 23, 0) != before;
if (shorter) {
*cspan_at(&lead, 23, 3) = steep;
}
result = (shorter || (times <= 1)) && (!leads_in(within_0001, lead));
return result;
}
static void search_ends(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double steep, before;
int64_t i;
steep = *cspan_at(&lead, 23, 3);
for (i = 0; i < 4; i += 1) {
if (is_settled(lead) || leads_in(within_0001, lead)) {
break;
}
before = *cspan_at(&lead, 23, 0);
set_limits(steep, lead);
improve_ends(order, within_0001, limits, lead, timing, coefficients);
if (before >= 0.0) {
break;
}
if (*cspan_at(&lead, 23, 0) < 0.0) {
steep = 10.0 * steep;
}
}
}
static double near_zero(double i) {
double share;
if (i == 0.0) {
return 0.0;
}
share = pow(0.7, (12 - fabs(i)));
if (i < 0.0) {
share = -share;
}
return share;
}
static bool jumps_often(array_double_2d lead) {
bool result;
result = (int64_t)(*cspan_at(&lead, 59, 0)) > 4;
return result;
}
static double hopeful_time(array_double_2d lead) {
double result;
if (*cspan_at(&lead, 23, 0) < 0.0) {
return 1e+300;
}
result = 1.2 * *cspan_at(&lead, 23, 0);
return result;
}
static double follow_level(int64_t order, double level, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d first;
int64_t i;
double time, after, found;
first = span_row(&lead, 26);
found = 1e+300;
for (i = 0; i < 4; i += 1) {
time = try_level(order, level, least, limits, lead, timing, coefficients);
if (!(time < (1.0 - 1e-10) * least)) {
break;
}
least = time;
found = time;
*cspan_at(&lead, 23, 2) = level;
after = *cspan_at(&first, 2) + *cspan_at(&first, 3);
if (level_order(order, lead) != *cspan_at(&first, 4) + 4 - order) {
break;
}
level = after;
}
return found;
}
static double search_grid(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t stage, count, i;
double kept, least, level, time, found;
stage = level_order(order, lead);
kept = *cspan_at(&lead, 23, 2);
least = hopeful_time(lead);
found = 1e+300;
count = jumps_often(lead) ? 12 : 0;
for (i = (-count) - 1; i < count + 1; i += 1) {
level = i >= -count ? near_zero((double)(i)) * *cspan_at(&lead, 19, stage) : kept;
time = follow_level(order, level, least, limits, lead, timing, coefficients);
if (time < least) {
least = time;
found = time;
}
}
return found;
}
static void improve_level(int64_t order, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double bound, step, around, level, time;
int64_t useless, i, side;
bound = (*cspan_at(&lead, 19, level_order(order, lead)));
step = 0.15 * fabs(*cspan_at(&lead, 23, 2)) + 0.005 * bound;
useless = 0;
for (i = 0; i < 8; i += 1) {
around = *cspan_at(&lead, 23, 2);
for (side = 0; side < 2; side += 1) {
level = span_min(span_max(around + step * (1 - 2 * side), -bound), bound);
time = try_level(order, level, least, limits, lead, timing, coefficients);
if (time < (1.0 - 1e-10) * least) {
least = time;
*cspan_at(&lead, 23, 2) = level;
}
}
useless = useless + 1;
if (*cspan_at(&lead, 23, 2) == around) {
step = 0.25 * step;
}
else {
useless = 0;
}
if (useless == 4) {
break;
}
}
}
static void search_levels(int64_t order, double found, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t first, i;
double before, level;
first = 0;
if (found >= 1e+300) {
*cspan_at(&lead, 23, 2) = (*cspan_at(&lead, 15, level_order(order, lead)));
*cspan_at(&lead, 23, 4) = 1.0 - 1e-12;
}
else {
first = 1;
*cspan_at(&lead, 23, 4) = 0.99;
}
for (i = first; i < 4; i += 1) {
set_limits(pow(10.0, (double)(i)), lead);
before = *cspan_at(&lead, 23, 0);
if ((found >= 1e+300) || ((i == 1) && jumps_often(lead))) {
found = search_grid(order, limits, lead, timing, coefficients);
if ((found < 1e+300) && jumps_often(lead)) {
improve_level(order, found, limits, lead, timing, coefficients);
}
}
else {
level = *cspan_at(&lead, 23, 2);
found = try_level(order, level, 1e+300, limits, lead, timing, coefficients);
}
if ((i > 0) && (*cspan_at(&lead, 23, 0) == before)) {
break;
}
*cspan_at(&lead, 23, 4) = 0.99;
}
}
static bool permits_levels(int64_t order, array_double_2d lead) {
array_double_1d target;
bool resting;
target = span_row(&lead, 24);
if (((int64_t)(*cspan_at(&lead, 59, 0)) < 4) || is_settled(lead)) {
return 0;
}
if (level_order(order, lead) == 0) {
return 0;
}
resting = (*cspan_at(&target, 2) == 0.0) && (*cspan_at(&target, 3) == 0.0);
return (order == 1) || resting;
}
static bool settled_end(int64_t row, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
array_double_1d state;
int64_t width, i;
double length;
bool settled;
state = span_row(&lead, 15);
width = coefficients.shape[1];
length = *cspan_at(&timing, row, 1);
settled = 1;
for (i = 0; i < span_floor_div(width, 2) + 1; i += 1) {
if (row + 1 < last) {
*cspan_at(&state, i) = evaluate_piece(coefficients, row + 1, width, 0.0, i);
}
else {
*cspan_at(&state, i) = evaluate_piece(coefficients, row, width, length, i);
}
if (i > 2) {
if (fabs(*cspan_at(&state, i)) > 1e-10 * *cspan_at(&lead, 19, i)) {
settled = 0;
}
*cspan_at(&state, i) = 0.0;
}
}
*cspan_at(&state, 8) = *cspan_at(&timing, row, 0) + length;
return settled;
}
static void follow_plan(int64_t order, int64_t axis, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t first, last, tried, row, place;
double best;
first = *cspan_at(&plan_offsets, axis);
last = *cspan_at(&plan_offsets, axis + 1);
tried = 0;
for (row = first; row < last; row += 1) {
place = 400 + row - first;
if ((row - first >= span_floor_div(3 * 400, 4)) || (tried >= 8)) {
break;
}
best = *cspan_at(&lead, 23, 0);
if ((best >= 0.0) && (*cspan_at(&plan_timing, row, 0) >= best)) {
break;
}
copy_piece(plan_timing, plan_coefficients, row, timing, coefficients, place);
if (settled_end(row, last, lead, plan_timing, plan_coefficients)) {
tried = tried + 1;
soonest_ends(order, lead);
try_lead(order, place + 1, limits, lead, timing, coefficients);
}
}
}
static bool start_search(int64_t shape, array_double_1d limits, array_double_2d lead) {
int64_t i, i_0001;
segfmu_axis_limits(limits.shape[0] - 1, shape, limits, span_row(&lead, 59));
set_lower(span_row(&lead, 60), span_row(&lead, 59));
if (!segfmu_ramp_parameters(usual_share(span_row(&lead, 59)), span_row(&lead, 59), span_rows(&lead, 61, 68))) {
return 0;
}
for (i = 1; i < limits.shape[0]; i += 1) {
*cspan_at(&lead, 20, i) = rounding_error(i, limits);
}
for (i_0001 = 0; i_0001 < lead.shape[1]; i_0001 += 1) {
*cspan_at(&lead, 15, i_0001) = *cspan_at(&lead, 7, i_0001);
}
return 1;
}
static bool goes_on_at_level(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
double level, best, found;
if (jumps_often(lead) || (!permits_levels(order, lead))) {
return 0;
}
level = (*cspan_at(&lead, 15, level_order(order, lead)));
best = *cspan_at(&lead, 23, 0);
found = follow_level(order, level, hopeful_time(lead), limits, lead, timing, coefficients);
if (*cspan_at(&lead, 23, 0) == best) {
return 0;
}
search_levels(order, found, limits, lead, timing, coefficients);
return 1;
}
static bool search_stages(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t times, i;
soonest_ends(order, lead);
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 22, i) = *cspan_at(&lead, 21, i);
}
for (times = 0; times < 4; times += 1) {
if (!try_steeper(order, within_0001, times, limits, lead, timing, coefficients)) {
break;
}
if ((times == 0) && goes_on_at_level(order, limits, lead, timing, coefficients)) {
return 1;
}
}
search_ends(order, within_0001, limits, lead, timing, coefficients);
return 0;
}
static void improve_lead(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t i;
if (leads_in(1e+300, lead) && (!jumps_often(lead))) {
return;
}
time_anew(order, lead);
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 15, i) = *cspan_at(&lead, 7, i);
}
if (permits_levels(order, lead) && (!leads_in(within_0001, lead))) {
search_levels(order, 1e+300, limits, lead, timing, coefficients);
}
}
static void prepend_brake(int64_t steps, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t count, i, row;
count = (int64_t)(*cspan_at(&lead, 23, 1));
if (*cspan_at(&lead, 23, 0) < 0.0) {
return;
}
if (count + steps > 400) {
*cspan_at(&lead, 23, 0) = -1.0;
return;
}
for (i = 0; i < count; i += 1) {
row = count - 1 - i;
copy_piece(timing, coefficients, row, timing, coefficients, row + steps);
}
for (row = 0; row < steps; row += 1) {
copy_piece(timing, coefficients, 2 * 400 + row, timing, coefficients, row);
}
*cspan_at(&lead, 23, 1) = count + steps;
}
static void search_braked(int64_t order, double within_0001, int64_t shape, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t repeat, steps, i, i_0001;
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, 8, i) = *cspan_at(&lead, 7, i);
}
for (repeat = 0; repeat < 2; repeat += 1) {
if (*cspan_at(&lead, 23, 0) < 0.0) {
steps = segfmu_find_brake(repeat == 1, limits, lead, timing, coefficients);
if (steps > 0) {
for (i_0001 = 0; i_0001 < lead.shape[1]; i_0001 += 1) {
*cspan_at(&lead, 7, i_0001) = *cspan_at(&lead, 9, i_0001);
}
if (start_search(shape, limits, lead)) {
if (!search_stages(order, within_0001, limits, lead, timing, coefficients)) {
improve_lead(order, within_0001, limits, lead, timing, coefficients);
}
}
for (i_0001 = 0; i_0001 < lead.shape[1]; i_0001 += 1) {
*cspan_at(&lead, 7, i_0001) = *cspan_at(&lead, 8, i_0001);
}
prepend_brake(steps, lead, timing, coefficients);
}
}
}
}
static bool find_lead(int64_t order, double within_0001, int64_t axis, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
bool brakes, result;
int64_t smoothness, shape;
*cspan_at(&lead, 23, 0) = -1.0;
*cspan_at(&lead, 23, 1) = 0.0;
*cspan_at(&lead, 23, 3) = 1.0;
brakes = *cspan_at(&lead, 0, 3) != 0.0;
smoothness = limits.shape[0] - 1;
if ((axis < 0) || (smoothness < 2) || (smoothness > 6) || (coefficients.shape[1] != 2 * smoothness)) {
return 0;
}
shape = (int64_t)(*cspan_at(&lead, 0, 2));
if ((!brakes) || (!is_outside(limits, lead))) {
if (start_search(shape, limits, lead)) {
if (!search_stages(order, within_0001, limits, lead, timing, coefficients)) {
if (jumps_often(lead)) {
*cspan_at(&lead, 23, 4) = 1.0 - 1e-12;
follow_plan(order, axis, plan_offsets, plan_timing, plan_coefficients, limits, lead, timing, coefficients);
}
improve_lead(order, within_0001, limits, lead, timing, coefficients);
}
}
}
if (brakes && (*cspan_at(&lead, 23, 0) < 0.0)) {
search_braked(order, within_0001, shape, limits, lead, timing, coefficients);
}
result = *cspan_at(&lead, 23, 0) >= 0.0;
return result;
}
static void clear_search(array_double_2d lead) {
int64_t row, i;
for (row = 7; row < 68; row += 1) {
for (i = 0; i < lead.shape[1]; i += 1) {
*cspan_at(&lead, row, i) = 0.0;
}
}
}
static void set_start(int64_t axis, array_double_2d start, array_double_2d lower, array_double_2d lead) {
int64_t i, i_0001;
for (i_0001 = 0; i_0001 < lead.shape[1]; i_0001 += 1) {
*cspan_at(&lead, 7, i_0001) = 0.0;
}
for (i = 0; i < span_min_int(start.shape[1], 9); i += 1) {
*cspan_at(&lead, 7, i) = *cspan_at(&start, axis, i);
}
for (i = 0; i < 2; i += 1) {
*cspan_at(&lead, 60, i) = *cspan_at(&lower, axis, i);
}
}
static int64_t latest_axis(array_double_2d ends) {
double longest;
int64_t axis, latest;
latest = -1;
longest = -1.0;
for (axis = 0; axis < ends.shape[0]; axis += 1) {
if ((*cspan_at(&ends, axis, 6) == 0.0) && (*cspan_at(&ends, axis, 4) > longest)) {
latest = axis;
longest = *cspan_at(&ends, axis, 4);
}
}
return latest;
}
static int64_t take_lead(int64_t first, array_double_1d end, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t i, found, row, count;
for (i = 0; i < 3; i += 1) {
*cspan_at(&end, i) = *cspan_at(&lead, 18, i);
}
*cspan_at(&end, 3) = *cspan_at(&lead, 18, 8);
*cspan_at(&end, 4) = *cspan_at(&lead, 23, 0);
*cspan_at(&end, 5) = 0.0;
found = timing.shape[0] - 1200;
count = (int64_t)(*cspan_at(&lead, 23, 1));
for (row = 0; row < count; row += 1) {
copy_piece(timing, coefficients, found + row, timing, coefficients, first + row);
}
return count;
}
static void follow_whole(int64_t axis, array_double_1d limits, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d end, array_double_2d lead, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets) {
int64_t first, last, i, row, target;
array_double_1d reached;
double velocity;
first = *cspan_at(&plan_offsets, axis);
last = *cspan_at(&plan_offsets, axis + 1);
if (last == first) {
return;
}
reached = span_row(&lead, 16);
write_end(last - 1, plan_timing, plan_coefficients, reached);
velocity = *cspan_at(&lead, 24, 2);
if (!(*cspan_at(&reached, 3) < *cspan_at(&end, 4))) {
return;
}
if (!is_at_velocity(velocity, limits, reached)) {
return;
}
for (i = 0; i < 4; i += 1) {
*cspan_at(&end, i) = *cspan_at(&reached, i);
}
*cspan_at(&end, 4) = *cspan_at(&end, 3);
*cspan_at(&end, 5) = 1.0;
for (row = first; row < last; row += 1) {
target = row + axis * 400;
copy_piece(plan_timing, plan_coefficients, row, timing, coefficients, target);
}
*cspan_at(&offsets, axis + 1) = last - first;
}
static void pack_leads(array_int64_t_1d plan_offsets, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets) {
int64_t used, axis, first, row;
used = 0;
*cspan_at(&offsets, 0) = 0;
for (axis = 0; axis < offsets.shape[0] - 1; axis += 1) {
first = *cspan_at(&plan_offsets, axis) + axis * 400;
for (row = 0; row < *cspan_at(&offsets, axis + 1); row += 1) {
copy_piece(timing, coefficients, first + row, timing, coefficients, used);
used = used + 1;
}
*cspan_at(&offsets, axis + 1) = used;
}
}
int64_t segfmu_find_leads(array_double_3d states, array_double_2d limits, array_double_2d lower, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_2d ends, array_double_2d lead, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets) {
int64_t axes, order, rows, found, attempt, first, axis;
double latest, longest;
bool waits;
axes = limits.shape[0];
order = 2;
if (*cspan_at(&lead, 0, 0) == 1) {
order = 1;
}
latest = *cspan_at(&lead, 0, 1);
waits = (latest >= 0.0) && (axes > 1);
rows = timing.shape[0];
found = rows - 1200;
longest = span_max(latest, 0.0);
clear_search(lead);
if (waits) {
longest = 1e+300;
}
for (attempt = 0; attempt < 2 * axes; attempt += 1) {
axis = attempt;
if (attempt >= axes) {
axis = latest_axis(ends);
if ((!waits) || (axis < 0) || (*cspan_at(&ends, axis, 4) <= latest)) {
break;
}
longest = latest;
}
else {
*cspan_at(&ends, axis, 6) = 0.0;
}
set_start(axis, span_matrix(&states, 0), lower, lead);
*cspan_at(&lead, 24, 4) = *cspan_at(&states, 1, axis, 0);
*cspan_at(&lead, 24, 2) = *cspan_at(&states, 1, axis, 1);
*cspan_at(&lead, 24, 3) = *cspan_at(&states, 1, axis, 2);
if (find_lead(order, longest, axis, plan_offsets, plan_timing, plan_coefficients, span_row(&limits, axis), lead, span_rows(&timing, found, rows), span_rows(&coefficients, found, rows))) {
first = *cspan_at(&plan_offsets, axis) + axis * 400;
*cspan_at(&offsets, axis + 1) = take_lead(first, span_row(&ends, axis), lead, timing, coefficients);
}
else if (attempt < axes) {
*cspan_at(&offsets, axis + 1) = 0;
*cspan_at(&ends, axis, 4) = 1e+300;
}
if (order == 1) {
follow_whole(axis, span_row(&limits, axis), plan_offsets, plan_timing, plan_coefficients, span_row(&ends, axis), lead, timing, coefficients, offsets);
}
if (*cspan_at(&ends, axis, 4) == 1e+300) {
return axis;
}
if (attempt >= axes) {
latest = span_max(latest, *cspan_at(&ends, axis, 4));
*cspan_at(&ends, axis, 6) = 1.0;
}
}
pack_leads(plan_offsets, timing, coefficients, offsets);
return -1;
}
bool segfmu_find_brakes(array_double_2d start, array_double_2d limits, array_double_2d lower, array_double_2d brakes, array_double_2d lead, array_double_2d timing, array_double_2d coefficients) {
int64_t axis, count, i;
bool found;
found = 0;
clear_search(lead);
for (axis = 0; axis < start.shape[0]; axis += 1) {
set_start(axis, start, lower, lead);
count = segfmu_find_brake(0, span_row(&limits, axis), lead, timing, coefficients);
for (i = 0; i < 27; i += 1) {
*cspan_at(&brakes, axis, i) = count > 0 ? *cspan_at(&lead, 14, i) : 0.0;
}
if (*cspan_at(&brakes, axis, 0) > 0.0) {
found = 1;
}
}
return found;
}
static void lead_to_velocity(array_double_2d lead) {
*cspan_at(&lead, 0, 0) = 1;
*cspan_at(&lead, 0, 1) = -1.0;
*cspan_at(&lead, 0, 2) = 1;
*cspan_at(&lead, 0, 3) = 1.0;
}
static bool lead_between(int64_t source, int64_t slot, array_double_2d ends, array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead) {
int64_t first, place, failed;
first = source * 4;
place = slot * 4;
failed = segfmu_find_leads(states, limits, lower, span_part(&offsets, first, first + 4), span_matrix(&timing, source), span_matrix(&coefficients, source), ends, lead, span_matrix(&timing, slot), span_matrix(&coefficients, slot), span_part(&offsets, place, place + 4));
return failed < 0;
}
static void set_motion(array_double_2d operation, array_double_3d states) {
int64_t axis, i;
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < states.shape[2]; i += 1) {
*cspan_at(&states, 0, axis, i) = *cspan_at(&operation, 19 + axis, i);
*cspan_at(&states, 1, axis, i) = 0.0;
}
}
}
static bool lead_of(int64_t axis, int64_t source, int64_t slot, array_double_2d ends, array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead) {
int64_t rows, first, last, followed, place, used, failed;
array_double_2d plan_timing, plan_coefficients, slot_timing, slot_coefficients;
rows = timing.shape[1];
first = *cspan_at(&offsets, source * 4 + axis);
last = *cspan_at(&offsets, source * 4 + axis + 1);
followed = 5 * 4;
*cspan_at(&offsets, followed) = 0;
*cspan_at(&offsets, followed + 1) = last - first;
place = slot * 4 + axis;
used = 0;
if (axis > 0) {
used = *cspan_at(&offsets, place);
}
plan_timing = span_matrix(&timing, source);
plan_coefficients = span_matrix(&coefficients, source);
slot_timing = span_matrix(&timing, slot);
slot_coefficients = span_matrix(&coefficients, slot);
failed = segfmu_find_leads(states, limits, lower, span_part(&offsets, followed, followed + 2), span_rows(&plan_timing, first, last), span_rows(&plan_coefficients, first, last), ends, lead, span_rows(&slot_timing, used, rows), span_rows(&slot_coefficients, used, rows), span_part(&offsets, place, place + 2));
*cspan_at(&offsets, place) = used;
*cspan_at(&offsets, place + 1) = used + *cspan_at(&offsets, place + 1);
return failed < 0;
}
static bool reach_velocity(int64_t axis, array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead) {
int64_t i, reached, lower;
double wish;
bool result;
for (i = 0; i < states.shape[2]; i += 1) {
*cspan_at(&states, 0, 0, i) = *cspan_at(&operation, 19 + axis, i);
*cspan_at(&states, 1, 0, i) = 0.0;
}
wish = *cspan_at(&operation, 22, axis) * *cspan_at(&operation, 12, axis);
*cspan_at(&states, 1, 0, 1) = wish;
reached = 26 + axis;
lower = 23 + axis;
result = lead_of(axis, 1, 2, span_rows(&operation, reached, reached + 1), span_rows(&limits, axis, axis + 1), span_rows(&operation, lower, lower + 1), timing, coefficients, offsets, states, lead);
return result;
}
static bool stop_behind(int64_t axis, array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead) {
array_double_1d reached;
int64_t i, stopped, lower;
bool result;
reached = span_row(&operation, 26 + axis);
for (i = 0; i < states.shape[2]; i += 1) {
*cspan_at(&states, 0, 0, i) = 0.0;
*cspan_at(&states, 1, 0, i) = 0.0;
}
*cspan_at(&states, 0, 0, 0) = *cspan_at(&reached, 0);
*cspan_at(&states, 0, 0, 1) = *cspan_at(&reached, 1);
stopped = 29 + axis;
lower = 23 + axis;
clear_plan(5, offsets);
result = lead_of(axis, 5, 3, span_rows(&operation, stopped, stopped + 1), span_rows(&limits, axis, axis + 1), span_rows(&operation, lower, lower + 1), timing, coefficients, offsets, states, lead);
return result;
}
static bool shrink_share(int64_t axis, bool last, array_double_2d operation) {
double left, stopping, way, share, ratio;
left = room_left(axis, operation);
if (left >= 0.0) {
return 0;
}
stopping = *cspan_at(&operation, 29 + axis, 0);
way = fabs(stopping - *cspan_at(&operation, 19 + axis, 0));
share = 0.0;
if ((!last) && (way + left > 0.0)) {
ratio = (way + left) / way;
share = 0.95 * pow(ratio, 0.7);
}
*cspan_at(&operation, 12, axis) = share * *cspan_at(&operation, 12, axis);
return 1;
}
static bool goes_back(int64_t axis, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d lead) {
double now, wish, direction, step, velocity;
int64_t leads, row, part, count, i;
now = *cspan_at(&operation, 19 + axis, 1);
wish = *cspan_at(&operation, 22, axis) * *cspan_at(&operation, 12, axis);
if (now * wish < 0.0) {
return 0;
}
direction = now + wish;
leads = 2 * 4 + axis;
for (row = *cspan_at(&offsets, leads); row < *cspan_at(&offsets, leads + 1); row += 1) {
step = *cspan_at(&timing, 2, row, 1) / 8;
for (part = 0; part < 8; part += 1) {
count = part_hull(1, row, part * step, step, lead, span_matrix(&coefficients, 2));
for (i = 0; i < count; i += 1) {
velocity = *cspan_at(&lead, 312 + 0, i);
if (velocity * direction < (-1e-06) * direction * direction) {
return 1;
}
}
}
}
return 0;
}
static bool reach_velocities(bool slow, array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead) {
int64_t tries, axis, i;
lead_to_velocity(lead);
tries = 5;
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < tries; i += 1) {
if (!reach_velocity(axis, operation, limits, timing, coefficients, offsets, states, lead)) {
return 0;
}
if (slow && goes_back(axis, operation, timing, coefficients, offsets, lead)) {
return 0;
}
if (!stop_behind(axis, operation, limits, timing, coefficients, offsets, states, lead)) {
return 0;
}
if (!shrink_share(axis, i == tries - 2, operation)) {
break;
}
}
}
return 1;
}
static bool seek_velocity(bool slow, array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead) {
bool result;
if (!reach_velocities(slow, operation, limits, timing, coefficients, offsets, states, lead)) {
return 0;
}
hold_shares(operation);
result = join_held(operation, timing, coefficients, offsets);
return result;
}
static int64_t insert_end(double duration, double after, int64_t count, array_double_2d ends) {
int64_t place, j, i;
if (duration <= after) {
return count;
}
place = count;
while((place > 0) && (*cspan_at(&ends, place - 1, 0) > duration)) {
place = place - 1;
}
if ((place > 0) && (duration - *cspan_at(&ends, place - 1, 0) <= 1e-10 * duration)) {
return count;
}
count = span_min_int(count + 1, ends.shape[0]);
for (j = 0; j < count - 1 - place; j += 1) {
i = count - 1 - j;
*cspan_at(&ends, i, 0) = *cspan_at(&ends, i - 1, 0);
}
if (place < count) {
*cspan_at(&ends, place, 0) = duration;
}
return count;
}
static int64_t cruise_times(double* result_0, double* result_1_0001, double cruise, array_double_1d problem, array_double_1d axis, array_double_2d phases) {
int64_t count, row;
double duration, y, rest;
cruise_form(&count, &row, &duration, &y, phases, cruise, problem, axis);
if (count < 0) {
(*result_0) = 1e+300;
(*result_1_0001) = 1e+300;
return 0;
}
rest = *cspan_at(&problem, 4) - y;
if (rest * cruise <= 0.0) {
(*result_0) = duration;
(*result_1_0001) = 1e+300;
return 0;
}
(*result_0) = duration;
(*result_1_0001) = duration + rest / cruise;
return 0;
}
static double cruise_time(double cruise, bool covering, array_double_1d problem, array_double_1d axis, array_double_2d phases) {
double duration, covered;
cruise_times(&duration, &covered, cruise, problem, axis, phases);
return covering ? covered : duration;
}
static double turning_time(double lower, double upper, bool covering, array_double_1d problem, array_double_1d axis, array_double_2d phases) {
double p, q, t_p, t_q;
int64_t i;
p = upper - 0.6180339887498949 * (upper - lower);
q = lower + 0.6180339887498949 * (upper - lower);
t_p = cruise_time(p, covering, problem, axis, phases);
t_q = cruise_time(q, covering, problem, axis, phases);
for (i = 0; i < 30; i += 1) {
if (t_p <= t_q) {
upper = q;
q = p;
t_q = t_p;
p = upper - 0.6180339887498949 * (upper - lower);
t_p = cruise_time(p, covering, problem, axis, phases);
}
else {
lower = p;
p = q;
t_p = t_q;
q = lower + 0.6180339887498949 * (upper - lower);
t_q = cruise_time(q, covering, problem, axis, phases);
}
}
return span_min(t_p, t_q);
}
static double cruise_sample(int64_t sample, double fastest, double backwards) {
double share;
share = 2.0 * sample / 24 - 1.0;
return share < 0.0 ? backwards * share : fastest * share;
}
static int64_t insert_turn(int64_t sample, bool covering, double least, double spent, double after, double fastest, double backwards, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count) {
array_double_2d phases, ends;
double lower, upper, turn;
int64_t result;
if (spent + least <= after) {
return count;
}
phases = span_rows(&work, 0, 21);
ends = span_rows(&work, 42, 58);
lower = cruise_sample(span_max_int(sample - 1, 0), fastest, backwards);
upper = cruise_sample(span_min_int(sample + 1, 24), fastest, backwards);
turn = turning_time(lower, upper, covering, problem, axis, phases);
result = insert_end(spent + span_min(turn, least), after, count, ends);
return result;
}
static int64_t turning_ends(double spent, double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count) {
array_double_2d phases;
double first, second, first_covered, second_covered, fastest, backwards, third, third_covered, cruise;
int64_t i;
phases = span_rows(&work, 0, 21);
first = 1e+300;
second = 1e+300;
first_covered = 1e+300;
second_covered = 1e+300;
fastest = speed_bound(1.0, 4.0 * after, problem, axis);
backwards = speed_bound(-1.0, 4.0 * after, problem, axis);
for (i = 0; i < 24 + 2; i += 1) {
third = 1e+300;
third_covered = 1e+300;
if (i < 24 + 1) {
cruise = cruise_sample(i, fastest, backwards);
cruise_times(&third, &third_covered, cruise, problem, axis, phases);
}
if ((second < 1e+300) && (first >= second) && (third >= second)) {
count = insert_turn(i - 1, 0, second, spent, after, fastest, backwards, problem, axis, work, count);
}
if ((second_covered < 1e+300) && (first_covered >= second_covered)) {
if (third_covered >= second_covered) {
count = insert_turn(i - 1, 1, second_covered, spent, after, fastest, backwards, problem, axis, work, count);
}
}
first = second;
second = third;
first_covered = second_covered;
second_covered = third_covered;
}
return count;
}
static int64_t insert_covering(array_double_2d phases, int64_t taken, double spent, double after, array_double_1d problem, array_double_1d axis, int64_t count, array_double_2d ends) {
double duration;
int64_t result;
if (taken <= 0) {
return count;
}
duration = valid_duration(phases, taken, problem, axis);
if (duration < 0.0) {
return count;
}
result = insert_end(spent + duration, after, count, ends);
return result;
}
static int64_t covering_ends(double spent, double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count) {
array_double_2d phases, ends;
array_double_1d family;
double usual, cruise;
int64_t form, taken, branch, member;
phases = span_rows(&work, 0, 21);
ends = span_rows(&work, 42, 58);
family = span_row(&work, 98);
usual = usual_duration(problem, axis);
for (form = 0; form < 3; form += 1) {
if (form == 0) {
taken = slower_cruise(phases, problem, axis);
}
else {
cruise = form == 2 ? -*cspan_at(&axis, 9) : *cspan_at(&axis, 2);
taken = with_cruise(phases, cruise, problem, axis);
}
count = insert_covering(phases, taken, spent, after, problem, axis, count, ends);
}
for (branch = 0; branch < 4; branch += 1) {
if (same_members(branch, problem, family)) {
continue;
}
set_family(branch, problem, axis, family);
for (member = 0; member < 4; member += 1) {
set_member(member, usual, 0, family);
taken = tempered_form(phases, family, axis);
if (taken < 0) {
break;
}
count = insert_covering(phases, taken, spent, after, problem, axis, count, ends);
}
}
return count;
}
static int64_t gap_ends(double after, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d rest;
int64_t variant, taken, count;
double spent;
rest = span_row(&work, 60);
count = 0;
for (variant = 0; variant < 4; variant += 1) {
braked(&taken, &spent, variant, problem, axis, work);
if (taken < 0) {
continue;
}
count = covering_ends(spent, after, rest, axis, work, count);
count = turning_ends(spent, after, rest, axis, work, count);
}
return count;
}
static void set_extreme(double sign, double pace, array_double_1d problem, array_double_1d axis, array_double_2d work) {
array_double_1d passing;
double duration, acceleration;
int64_t i, q;
passing = span_row(&work, 101);
duration = *cspan_at(&problem, 5);
for (i = 0; i < 26; i += 1) {
*cspan_at(&passing, i) = 0.0;
}
*cspan_at(&passing, 1) = *cspan_at(&axis, 38);
*cspan_at(&passing, 2) = pace;
*cspan_at(&passing, 3) = duration;
acceleration = top_acceleration(axis);
acceleration = span_min(acceleration, acceleration * duration / *cspan_at(&axis, 13));
*cspan_at(&passing, 4) = acceleration;
*cspan_at(&passing, 5) = duration;
*cspan_at(&passing, 6) = sign;
q = (int64_t)(*cspan_at(&axis, 38)) + 2;
set_alternating(sign, 0.6 * duration / q, work);
}
static int64_t extreme_form(int64_t* result_0, double* result_1_0001, double sign, double pace, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t count, end;
set_extreme(sign, pace, problem, axis, work);
if (!solve_sequence(problem, axis, work)) {
(*result_0) = 0;
(*result_1_0001) = 0.0;
return 0;
}
keep_sequence(158, work);
if (!tighten(1e+300, problem, axis, work)) {
(*result_0) = 0;
(*result_1_0001) = 0.0;
return 0;
}
count = write_sequence(phases, problem, axis, work);
end = 102 + (int64_t)(*cspan_at(&work, 101, 0)) + 1;
(*result_0) = count;
(*result_1_0001) = *cspan_at(&work, end, 0);
return 0;
}
static bool timed_extremes(array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem, nearest;
double distance, known, sign, pace, reached;
int64_t i, found, attempt, count;
array_double_2d phases;
problem = span_row(&work, 59);
nearest = span_row(&work, 58);
distance = *cspan_at(&problem, 4);
known = *cspan_at(&nearest, 4);
for (i = 0; i < 2; i += 1) {
sign = 2.0 * i - 1.0;
if (known < 0.0) {
sign = -sign;
}
found = 0;
phases = span_rows(&cell, 0, 33);
if (sign > 0.0) {
found = 2;
phases = span_rows(&cell, 33, 66);
}
*cspan_at(&nearest, found) = 0.0;
for (attempt = 0; attempt < 3; attempt += 1) {
pace = 1.0 - 0.2 * attempt;
extreme_form(&count, &reached, sign, pace, phases, problem, axis, work);
if ((count > 0) && (sign * reached >= sign * distance)) {
*cspan_at(&nearest, found) = count;
*cspan_at(&nearest, found + 1) = reached;
break;
}
if ((count > 0) && (attempt == 0) && ((int64_t)(*cspan_at(&axis, 38)) < 2)) {
return 0;
}
}
if ((*cspan_at(&nearest, found) == 0.0) && (sign != known)) {
return 0;
}
}
return 1;
}
static void polynomial_levels(array_double_1d problem, array_double_1d gentle) {
double duration, a, square, y, v, b, third, fourth, fifth, first, second, inner, root, low, high, last, s, curve;
int64_t i;
duration = *cspan_at(&problem, 5);
a = *cspan_at(&problem, 1);
square = duration * duration;
y = *cspan_at(&problem, 4) - (*cspan_at(&problem, 0) + 0.5 * a * duration) * duration;
v = (*cspan_at(&problem, 2) - *cspan_at(&problem, 0) - a * duration) * duration;
b = (*cspan_at(&problem, 3) - a) * square;
third = 10.0 * y - 4.0 * v + 0.5 * b;
fourth = (-15.0) * y + 7.0 * v - b;
fifth = 6.0 * y - 3.0 * v + 0.5 * b;
first = 1.0 / 3.0;
second = 2.0 / 3.0;
inner = 4.0 * fourth * fourth - 10.0 * third * fifth;
if (inner > 0.0) {
root = fourth < 0.0 ? 2.0 * fourth - sqrt(inner) : 2.0 * fourth + sqrt(inner);
low = (-third) / root;
high = fifth != 0.0 ? (-0.1) * root / fifth : 2.0;
if (low > high) {
last = low;
low = high;
high = last;
}
if ((low > 0.0) && (low < 1.0)) {
first = low;
second = 0.5 * (1.0 + low);
}
if ((high > 0.0) && (high < 1.0)) {
second = high;
if (!((low > 0.0) && (low < 1.0))) {
first = 0.5 * high;
}
}
}
for (i = 0; i < 2; i += 1) {
s = first;
if (i == 1) {
s = second;
}
curve = s * (6.0 * third + s * (12.0 * fourth + s * 20.0 * fifth));
*cspan_at(&gentle, 0 + i) = a + curve / square;
}
}
static int64_t gentle_hold(double* result_0_0001, double* result_1, double level, array_double_1d problem, array_double_1d axis) {
double top, hold;
top = side_limit(2, level, axis);
if (fabs(level) <= top) {
(*result_0_0001) = level;
(*result_1) = 0.0;
return 0;
}
hold = 0.5 * *cspan_at(&problem, 5) * (fabs(level) / top - 1.0);
if (level < 0.0) {
(*result_0_0001) = -top;
(*result_1) = hold;
return 0;
}
(*result_0_0001) = top;
(*result_1) = hold;
return 0;
}
static void gentle_ramps(array_double_1d problem, array_double_1d axis, array_double_1d gentle) {
double hold, total, a, b, held, duration, slope;
int64_t i;
hold = 0.0;
total = 0.0;
a = *cspan_at(&problem, 1);
for (i = 0; i < 3; i += 1) {
b = *cspan_at(&problem, 3);
held = 0.0;
if (i < 2) {
gentle_hold(&b, &held, *cspan_at(&gentle, 0 + i), problem, axis);
}
segfmu_ramp_duration(&duration, &slope, fabs(b - a), axis);
*cspan_at(&gentle, 4 + i) = b;
*cspan_at(&gentle, 7 + i) = held;
*cspan_at(&gentle, 10 + i) = duration;
total = total + duration;
hold = hold + held;
a = b;
}
*cspan_at(&gentle, 13) = total > 0.0 ? (*cspan_at(&problem, 5) - hold) / total : 0.0;
}
static double gentle_errors(array_double_1d problem, array_double_1d axis, array_double_1d gentle) {
double v, y, a, b, held, basis, duration, result;
int64_t i;
gentle_ramps(problem, axis, gentle);
v = *cspan_at(&problem, 0);
y = 0.0;
a = *cspan_at(&problem, 1);
for (i = 0; i < 3; i += 1) {
b = *cspan_at(&gentle, 4 + i);
held = *cspan_at(&gentle, 7 + i);
basis = *cspan_at(&gentle, 10 + i);
duration = basis * *cspan_at(&gentle, 13);
if (duration > 0.0) {
y = y + ramp_distance(v, a, b, duration, basis, axis);
v = v + 0.5 * (a + b) * duration;
}
y = y + (v + 0.5 * b * held) * held;
v = v + b * held;
a = b;
}
*cspan_at(&gentle, 14) = v - *cspan_at(&problem, 2);
*cspan_at(&gentle, 15) = (y - *cspan_at(&problem, 4)) / *cspan_at(&problem, 5);
result = fabs(*cspan_at(&gentle, 14)) + fabs(*cspan_at(&gentle, 15));
return result;
}
static double usual_speed(array_double_1d problem, array_double_1d axis) {
double duration, speed, result;
duration = *cspan_at(&problem, 5);
speed = fabs(*cspan_at(&problem, 0)) + fabs(*cspan_at(&problem, 2));
speed = speed + (fabs(*cspan_at(&problem, 1)) + fabs(*cspan_at(&problem, 3))) * duration;
result = span_min(fastest_velocity(axis), speed + fabs(*cspan_at(&problem, 4)) / duration);
return result;
}
static bool gentle_slopes(array_double_1d problem, array_double_1d axis, array_double_1d gentle) {
double gain, excess, change, kept;
int64_t i;
gain = *cspan_at(&gentle, 14);
excess = *cspan_at(&gentle, 15);
change = 1e-07 * span_max(fabs(*cspan_at(&gentle, 0)), fabs(*cspan_at(&gentle, 0 + 1)));
if (change == 0.0) {
return 0;
}
for (i = 0; i < 2; i += 1) {
kept = *cspan_at(&gentle, 0 + i);
*cspan_at(&gentle, 0 + i) = kept + change;
gentle_errors(problem, axis, gentle);
*cspan_at(&gentle, 0 + i) = kept;
*cspan_at(&gentle, 16 + i) = (*cspan_at(&gentle, 14) - gain) / change;
*cspan_at(&gentle, 18 + i) = (*cspan_at(&gentle, 15) - excess) / change;
}
*cspan_at(&gentle, 14) = gain;
*cspan_at(&gentle, 15) = excess;
return 1;
}
static bool gentle_step(array_double_1d gentle) {
double gain, excess, g1, g2, e1, e2, determinant;
gain = *cspan_at(&gentle, 14);
excess = *cspan_at(&gentle, 15);
g1 = *cspan_at(&gentle, 16);
g2 = *cspan_at(&gentle, 16 + 1);
e1 = *cspan_at(&gentle, 18);
e2 = *cspan_at(&gentle, 18 + 1);
determinant = g1 * e2 - g2 * e1;
if (!(fabs(determinant) > 1e-09 * (fabs(g1 * e2) + fabs(g2 * e1)))) {
return 0;
}
*cspan_at(&gentle, 2) = (g2 * excess - e2 * gain) / determinant;
*cspan_at(&gentle, 2 + 1) = (e1 * gain - g1 * excess) / determinant;
return 1;
}
static void spread_levels(int64_t attempt, array_double_1d gentle) {
double middle, half, factor;
middle = 0.5 * (*cspan_at(&gentle, 0) + *cspan_at(&gentle, 0 + 1));
half = 0.5 * (*cspan_at(&gentle, 0) - *cspan_at(&gentle, 0 + 1));
factor = 1.5 * attempt + 1.0;
if (span_floor_mod(attempt, 2) == 0) {
factor = -factor;
}
half = factor * half;
*cspan_at(&gentle, 0) = middle + half;
*cspan_at(&gentle, 0 + 1) = middle - half;
}
static void take_levels(double share, array_double_1d gentle) {
int64_t i;
for (i = 0; i < 2; i += 1) {
*cspan_at(&gentle, 0 + i) = *cspan_at(&gentle, 0 + i) + share * *cspan_at(&gentle, 2 + i);
}
}
static bool solve_gentle(int64_t attempt, array_double_1d problem, array_double_1d axis, array_double_1d gentle) {
double error, speed, close, share, reached;
int64_t i, j;
polynomial_levels(problem, gentle);
if (attempt > 0) {
spread_levels(attempt, gentle);
}
error = gentle_errors(problem, axis, gentle);
speed = usual_speed(problem, axis);
close = 0.0001 * speed;
for (i = 0; i < 24; i += 1) {
if (((i == 0) || (error > close)) && (!gentle_slopes(problem, axis, gentle))) {
return 0;
}
if (!gentle_step(gentle)) {
return 0;
}
share = 1.0;
reached = error;
for (j = 0; j < 4; j += 1) {
take_levels(share, gentle);
reached = gentle_errors(problem, axis, gentle);
if (reached < error) {
break;
}
take_levels(-share, gentle);
share = 0.5 * share;
}
if (!(reached < error)) {
error = gentle_errors(problem, axis, gentle);
break;
}
error = reached;
if (error <= 2e-15 * speed) {
break;
}
}
return error <= 1e-13 * speed;
}
static int64_t write_gentle(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_1d gentle) {
double a, b;
int64_t i, used, count;
count = 0;
a = *cspan_at(&problem, 1);
for (i = 0; i < 3; i += 1) {
b = *cspan_at(&gentle, 4 + i);
used = append_change(phases, count, a, b, axis);
if (used > count) {
*cspan_at(&phases, count, 0) = *cspan_at(&phases, count, 1) * *cspan_at(&gentle, 13);
}
count = append_hold(phases, used, b, *cspan_at(&gentle, 7 + i));
a = b;
}
return count;
}
static bool is_turning(double lowest, double highest) {
return span_min(-lowest, highest) > 1e-12 * span_max(-lowest, highest);
}
static bool turns_back(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d nearest;
double weight, v, duration, y, end, lowest, highest;
int64_t count;
nearest = span_row(&work, 58);
weight = nearest_weight(problem, axis, nearest);
v = *cspan_at(&problem, 0);
if (weight < 1.0) {
count = (int64_t)(*cspan_at(&nearest, 0));
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, span_rows(&cell, 0, 33), count, v, 0.0, axis);
if (is_turning(lowest, highest)) {
return 1;
}
}
if (weight > 0.0) {
count = (int64_t)(*cspan_at(&nearest, 2));
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, span_rows(&cell, 33, 66), count, v, 0.0, axis);
return is_turning(lowest, highest);
}
return 0;
}
static bool timed_gently(bool turning, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem, gentle;
array_double_2d phases;
double target, duration, y, end, lowest, highest, fastest;
int64_t attempt, count;
problem = span_row(&work, 59);
gentle = span_row(&work, 100);
phases = span_rows(&cell, 0, 33);
target = *cspan_at(&problem, 5);
for (attempt = 0; attempt < 6; attempt += 1) {
if (!solve_gentle(attempt, problem, axis, gentle)) {
continue;
}
if (*cspan_at(&gentle, 13) < 1.0) {
return 0;
}
count = write_gentle(phases, problem, axis, gentle);
count = fit_duration(phases, count, target);
segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, *cspan_at(&problem, 0), 0.0, axis);
if (is_beyond(lowest, highest, 1.0 + 1e-12, axis)) {
return 0;
}
if (is_turning(lowest, highest) && (!turning)) {
return 0;
}
fastest = span_max(-lowest, highest);
if (fabs(end - *cspan_at(&problem, 2)) > 1e-12 * fastest) {
return 0;
}
if (fabs(y - *cspan_at(&problem, 4)) > 1e-12 * fastest * target) {
return 0;
}
*cspan_at(&work, 58, 0) = count;
*cspan_at(&work, 58, 2) = 0.0;
return 1;
}
return 0;
}
static bool timed_slower(bool turning, double shortest, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem, rest, nearest;
double velocity, backwards, factor, steepest, lowest, room;
int64_t attempt, below, above;
bool fits;
problem = span_row(&work, 59);
rest = span_row(&work, 60);
velocity = *cspan_at(&axis, 2);
backwards = *cspan_at(&axis, 9);
factor = shortest / *cspan_at(&problem, 5);
factor = factor * factor;
steepest = span_max(*cspan_at(&problem, 1), *cspan_at(&problem, 3));
lowest = span_min(*cspan_at(&problem, 1), *cspan_at(&problem, 3));
for (attempt = 0; attempt < 9; attempt += 1) {
room = *cspan_at(&axis, 3) * factor * factor * (1.0 - 1e-12);
fits = steepest <= room;
room = *cspan_at(&axis, 9 + 1) * factor * factor * (1.0 - 1e-12);
if (fits && (-lowest <= room) && (factor < 0.99)) {
*cspan_at(&rest, 0) = *cspan_at(&problem, 0) / factor;
*cspan_at(&rest, 1) = *cspan_at(&problem, 1) / (factor * factor);
*cspan_at(&rest, 2) = *cspan_at(&problem, 2) / factor;
*cspan_at(&rest, 3) = *cspan_at(&problem, 3) / (factor * factor);
*cspan_at(&rest, 4) = *cspan_at(&problem, 4);
*cspan_at(&rest, 5) = *cspan_at(&problem, 5) * factor;
*cspan_at(&axis, 2) = velocity / factor;
*cspan_at(&axis, 9) = backwards / factor;
clear_nearest(work);
usual_cruise(rest, axis, cell, work);
*cspan_at(&axis, 2) = velocity;
*cspan_at(&axis, 9) = backwards;
if (is_enclosed(work)) {
nearest = span_row(&work, 58);
below = (int64_t)(*cspan_at(&nearest, 0));
above = (int64_t)(*cspan_at(&nearest, 2));
if ((!turning) && turns_back(rest, axis, cell, work)) {
return 0;
}
stretch_phases(span_rows(&cell, 0, 33), below, 1.0 / factor);
stretch_phases(span_rows(&cell, 33, 66), above, 1.0 / factor);
return 1;
}
}
factor = pow(factor, 0.75);
}
return 0;
}
static void surround_nearest(int64_t variant, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem, nearest;
array_double_2d below, above;
int64_t count;
problem = span_row(&work, 59);
nearest = span_row(&work, 58);
below = span_rows(&cell, 0, 33);
above = span_rows(&cell, 33, 66);
count = (int64_t)(*cspan_at(&nearest, 0));
count = surround(below, count, variant, problem, axis, work);
*cspan_at(&nearest, 0) = fit_duration(below, count, *cspan_at(&problem, 5));
count = (int64_t)(*cspan_at(&nearest, 2));
count = surround(above, count, variant, problem, axis, work);
*cspan_at(&nearest, 2) = fit_duration(above, count, *cspan_at(&problem, 5));
}
static double timed_smoothly(bool turning, array_double_1d axis, array_double_2d cell, array_double_2d work) {
double shortest, weight;
shortest = *cspan_at(&cell, 67, 0);
if (shortest <= 0.0) {
return -1.0;
}
if (timed_gently(turning, axis, cell, work)) {
return 0.0;
}
if (!timed_slower(turning, shortest, axis, cell, work)) {
return -1.0;
}
weight = nearest_weight(span_row(&work, 59), axis, span_row(&work, 58));
surround_nearest(0, axis, cell, work);
return weight;
}
static double timed_braked(array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem, rest;
int64_t variant, taken;
double spent, weight;
problem = span_row(&work, 59);
rest = span_row(&work, 60);
for (variant = 0; variant < 4; variant += 1) {
braked(&taken, &spent, variant, problem, axis, work);
if (taken == -3) {
continue;
}
if (taken < 0) {
return (double)(-2);
}
if (*cspan_at(&rest, 5) <= 0.0) {
continue;
}
clear_nearest(work);
timed_between(rest, axis, cell, work);
if ((variant == 0) && (!is_enclosed(work))) {
timed_loop(rest, axis, cell, work);
note_known(work);
}
if (is_enclosed(work)) {
weight = nearest_weight(rest, axis, span_row(&work, 58));
surround_nearest(variant, axis, cell, work);
return weight;
}
}
return -1.0;
}
static int64_t slowed_shortest(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work) {
int64_t count, result;
count = segfmu_shortest_profile(problem, axis, phases, work);
result = slower_form(count, phases, problem, axis, work);
return result;
}
static double slower_passing(array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem;
array_double_2d phases;
int64_t count;
if (*cspan_at(&axis, 38) == 0.0) {
return -1.0;
}
problem = span_row(&work, 59);
phases = span_rows(&cell, 0, 33);
count = 0;
if (*cspan_at(&cell, 67, 6) != 0.0) {
count = slowed_shortest(phases, problem, axis, work);
if ((count == 0) && (*cspan_at(&axis, 12) == 2)) {
*cspan_at(&axis, 12) = 0;
count = slowed_shortest(phases, problem, axis, work);
*cspan_at(&axis, 12) = 2;
}
}
if ((count == 0) && (!ramps_suffice(axis))) {
count = plain_profile(problem, axis, phases, work);
count = slower_form(count, phases, problem, axis, work);
}
if (count == 0) {
return -1.0;
}
count = fit_duration(phases, count, *cspan_at(&problem, 5));
*cspan_at(&work, 58, 0) = count;
*cspan_at(&work, 58, 2) = 0.0;
return 0.0;
}
static double between_extremes(array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem;
double result;
problem = span_row(&work, 59);
if (!timed_extremes(axis, cell, work)) {
return -1.0;
}
if (!is_enclosed(work)) {
timed_between(problem, axis, cell, work);
timed_loop(problem, axis, cell, work);
}
if (!is_enclosed(work)) {
return -1.0;
}
surround_nearest(0, axis, cell, work);
result = nearest_weight(problem, axis, span_row(&work, 58));
return result;
}
static double timed_forwards(array_double_1d axis, array_double_2d cell, array_double_2d work) {
double weight;
weight = timed_smoothly(0, axis, cell, work);
if (weight >= 0.0) {
return weight;
}
weight = timed_braked(axis, cell, work);
if (weight == -2) {
return -1.0;
}
if ((weight < 0.0) && (*cspan_at(&axis, 38) != 0.0)) {
weight = slower_passing(axis, cell, work);
if (weight < 0.0) {
weight = between_extremes(axis, cell, work);
}
if (weight < 0.0) {
weight = timed_dipped(axis, cell, work);
}
}
if (weight < 0.0) {
weight = timed_smoothly(1, axis, cell, work);
}
return weight;
}
double segfmu_timed_profile(double target, array_double_1d axis, array_double_2d cell, array_double_2d work) {
array_double_1d problem, nearest;
int64_t mirrored, turned, below, above;
double weight;
problem = span_row(&work, 59);
boundary_problem(span_row(&cell, 66), axis, problem);
*cspan_at(&problem, 5) = target;
orient(&mirrored, &turned, problem, axis);
weight = timed_forwards(axis, cell, work);
if (weight < 0.0) {
turned = 1 - turned;
reverse_search(problem, axis);
weight = timed_forwards(axis, cell, work);
}
turn_back(mirrored, turned, problem, axis);
if (weight >= 0.0) {
nearest = span_row(&work, 58);
below = (int64_t)(*cspan_at(&nearest, 0));
above = (int64_t)(*cspan_at(&nearest, 2));
turn_phases(mirrored, turned, below, span_rows(&cell, 0, 33));
turn_phases(mirrored, turned, above, span_rows(&cell, 33, 66));
}
return weight;
}
static int64_t set_shortest(int64_t* result_0, double* result_1_0001, array_double_2d cell, array_double_1d axis, array_double_2d work) {
array_double_1d problem;
array_double_2d phases;
int64_t count;
problem = span_row(&cell, 66);
phases = span_rows(&cell, 0, 33);
count = segfmu_shortest_profile(problem, axis, phases, work);
*cspan_at(&cell, 67, 3) = span_max_int(count, 0);
*cspan_at(&cell, 67, 4) = 0.0;
*cspan_at(&cell, 67, 2) = 0.0;
if (count < 0) {
(*result_0) = count;
(*result_1_0001) = 0.0;
return 0;
}
(*result_0) = 0;
(*result_1_0001) = total_duration(phases, count);
return 0;
}
static void set_stretched(double target, bool resting, array_double_2d cell, array_double_1d axis, array_double_2d work) {
array_double_2d phases;
double shortest, duration;
int64_t i, status, count;
phases = span_rows(&cell, 0, 33);
shortest = *cspan_at(&cell, 67, 0) - *cspan_at(&cell, 68, 2);
duration = 0.0;
if (*cspan_at(&cell, 67, 4) == 0.0) {
for (i = 0; i < (int64_t)(*cspan_at(&cell, 67, 3)); i += 1) {
duration = duration + *cspan_at(&phases, i, 0);
}
}
if ((duration == 0.0) || (fabs(duration - shortest) > 1e-13 * shortest)) {
set_shortest(&status, &duration, cell, axis, work);
}
count = (int64_t)(*cspan_at(&cell, 67, 3));
if (resting && (count == 0)) {
*cspan_at(&cell, 67, 3) = append_hold(phases, 0, 0.0, target);
}
else if (resting) {
stretch_phases(phases, count, target / duration);
}
}
static bool set_duration(double target, array_double_2d cell, array_double_1d axis, array_double_2d work) {
double delay, shortest, weight;
bool resting;
delay = *cspan_at(&cell, 68, 2);
shortest = *cspan_at(&cell, 67, 0);
if (target < shortest * (1.0 - 1e-13)) {
return 0;
}
resting = is_resting(span_row(&cell, 66), axis);
if (resting || (target <= shortest * (1.0 + 1e-13))) {
set_stretched(target - delay, resting, cell, axis, work);
return 1;
}
weight = segfmu_timed_profile(target - delay, axis, cell, work);
if (weight < 0.0) {
return 0;
}
*cspan_at(&cell, 67, 2) = weight;
*cspan_at(&cell, 67, 3) = *cspan_at(&work, 58, 0);
*cspan_at(&cell, 67, 4) = *cspan_at(&work, 58, 2);
return 1;
}
static double first_feasible(double outside, double inside, array_double_2d cell, array_double_1d axis, array_double_2d work) {
double duration;
int64_t i;
duration = inside * (1.0 - 1e-09);
for (i = 0; i < 100; i += 1) {
if (inside - outside <= 1e-09 * inside) {
break;
}
if (set_duration(duration, cell, axis, work)) {
inside = duration;
}
else {
outside = duration;
}
duration = 0.5 * (outside + inside);
}
return inside;
}
static double next_feasible(double start, double most, array_double_2d cell, array_double_1d axis, array_double_2d work) {
double after, delay, growth, duration;
int64_t sweep, count, i;
after = start;
delay = *cspan_at(&cell, 68, 2);
for (sweep = 0; sweep < 8; sweep += 1) {
count = gap_ends(after - delay, span_row(&cell, 66), axis, work);
for (i = 0; i < count; i += 1) {
duration = delay + *cspan_at(&work, 42 + i, 0) * (1.0 + 1e-10);
duration = span_min(duration, most);
if (set_duration(duration, cell, axis, work)) {
if ((*cspan_at(&axis, 14) == 0.0) || (!ramps_suffice(axis))) {
duration = first_feasible(after, duration, cell, axis, work);
}
return duration;
}
if (duration >= most) {
return -1.0;
}
after = duration;
}
if (count < 58 - 42) {
break;
}
}
growth = 1.005;
for (i = 0; i < 100; i += 1) {
duration = span_min(after * growth, most);
if (set_duration(duration, cell, axis, work)) {
duration = first_feasible(after, duration, cell, axis, work);
return duration;
}
if (duration >= most) {
return -1.0;
}
after = duration;
growth = 1.005 * growth;
}
return -1.0;
}
static double round_up(double duration, double sample_time) {
double samples;
if (sample_time <= 0.0) {
return duration;
}
samples = duration / sample_time - 1e-09;
if (!(samples * 2e-16 < 1.0)) {
return duration;
}
return (int64_t)ceil(samples) * sample_time;
}
static double common_duration(double start, double most, double sample_time, int64_t first, int64_t last, array_double_2d axes, array_double_3d cells, array_double_2d work) {
int64_t i, place, agreed, row;
array_double_2d cell;
array_double_1d axis;
double duration;
duration = start;
for (i = first; i < last; i += 1) {
duration = span_max(duration, *cspan_at(&cells, i, 67, 0));
}
duration = round_up(duration, sample_time);
place = first;
agreed = 0;
for (i = 0; i < 100000; i += 1) {
if (agreed == last - first) {
return duration;
}
if (duration >= most) {
return -1.0;
}
cell = span_matrix(&cells, place);
row = span_floor_mod(place, axes.shape[0]);
axis = span_row(&axes, row);
if (set_duration(duration, cell, axis, work)) {
agreed = agreed + 1;
}
else {
duration = next_feasible(duration, most, cell, axis, work);
if (duration < 0.0) {
return -1.0;
}
duration = round_up(duration, sample_time);
agreed = 0;
}
place = place + 1;
if (place == last) {
place = first;
}
}
return -1.0;
}
static void note_shortest(double time, array_double_1d axis, array_double_2d cell) {
int64_t count;
bool passing;
time = time + *cspan_at(&cell, 68, 2);
*cspan_at(&cell, 67, 0) = time;
*cspan_at(&cell, 67, 1) = time;
count = (int64_t)(*cspan_at(&cell, 67, 3));
passing = is_passing(span_rows(&cell, 0, 33), count, axis);
*cspan_at(&cell, 67, 6) = passing;
}
static int64_t plan_with_share(int64_t axis, double share, array_double_2d axes, array_double_3d cells, array_double_2d work) {
array_double_1d report;
int64_t missed, j, status;
double slow, time, sign;
report = span_row(&work, 99);
*cspan_at(&report, 0) = axis;
missed = 0;
slow = 0.0;
if (!segfmu_ramp_parameters(share, span_row(&axes, axis), work)) {
return -9;
}
for (j = axis; (axes.shape[0] > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += axes.shape[0]) {
*cspan_at(&report, 1) = span_floor_div(j, axes.shape[0]);
set_shortest(&status, &time, span_matrix(&cells, j), span_row(&axes, axis), work);
if (status < 0) {
*cspan_at(&report, 2) = *cspan_at(&cells, j, 66, 1);
sign = *cspan_at(&report, 2);
if (status == -2) {
*cspan_at(&report, 2) = *cspan_at(&cells, j, 66, 3);
sign = -*cspan_at(&report, 2);
}
*cspan_at(&report, 3) = side_limit(1, sign, span_row(&axes, axis));
*cspan_at(&report, 4) = own_side(1, sign, span_row(&axes, axis));
return status;
}
missed = span_max_int(missed, (int64_t)(*cspan_at(&work, 98, 21)));
slow = span_max(slow, *cspan_at(&work, 98, 22));
note_shortest(time, span_row(&axes, axis), span_matrix(&cells, j));
}
*cspan_at(&work, 98, 21) = missed;
*cspan_at(&work, 98, 22) = slow;
return 0;
}
static double axis_duration(int64_t axis, array_double_2d axes, array_double_3d cells) {
int64_t j;
double total;
total = 0.0;
for (j = axis; (axes.shape[0] > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += axes.shape[0]) {
total = total + *cspan_at(&cells, j, 67, 0);
}
return total;
}
static void keep_shortest(int64_t axis, array_double_2d axes, array_double_3d cells) {
int64_t j, count;
array_double_2d cell;
for (j = axis; (axes.shape[0] > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += axes.shape[0]) {
cell = span_matrix(&cells, j);
count = (int64_t)(*cspan_at(&cell, 67, 3));
copy_phases(span_rows(&cell, 0, 33), span_rows(&cell, 33, 66), count);
*cspan_at(&cell, 67, 5) = count;
}
}
static void restore_shortest(int64_t axis, array_double_2d axes, array_double_3d cells) {
int64_t j, count;
array_double_2d cell, phases;
for (j = axis; (axes.shape[0] > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += axes.shape[0]) {
cell = span_matrix(&cells, j);
phases = span_rows(&cell, 0, 33);
count = (int64_t)(*cspan_at(&cell, 67, 5));
copy_phases(span_rows(&cell, 33, 66), phases, count);
*cspan_at(&cell, 67, 3) = count;
note_shortest(total_duration(phases, count), span_row(&axes, axis), cell);
}
}
static double smoothness_share(double usual, double share) {
return sqrt((1.0 - usual) / (1.0 - share)) / 1.000001;
}
static bool shorter_with(double share, double kept, double factor, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work) {
double longest;
int64_t status;
longest = factor * axis_duration(axis, axes, cells);
keep_shortest(axis, axes, cells);
status = plan_with_share(axis, share, axes, cells, work);
if ((status == 0) && (axis_duration(axis, axes, cells) < longest)) {
return 1;
}
segfmu_ramp_parameters(kept, span_row(&axes, axis), work);
restore_shortest(axis, axes, cells);
return 0;
}
static double plan_steeper(int64_t missed, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work) {
double factor, share;
share = usual_share(span_row(&axes, axis));
if (snap_is_last(span_row(&axes, axis))) {
factor = smoothness_share(share, moderate_share());
if (shorter_with(moderate_share(), share, factor, axis, axes, cells, work)) {
share = moderate_share();
}
missed = span_min_int(missed, (int64_t)(*cspan_at(&work, 98, 21)));
}
if (missed == 2) {
factor = smoothness_share(share, steepest_share());
if (shorter_with(steepest_share(), share, factor, axis, axes, cells, work)) {
share = steepest_share();
}
}
return share;
}
static void plan_thoroughly(double share, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work) {
*cspan_at(&axes, axis, 12) = 2;
if (!shorter_with(share, share, 1.0 - 1e-09, axis, axes, cells, work)) {
*cspan_at(&axes, axis, 12) = 0;
}
}
static int64_t plan_refused(int64_t* result_0, double* result_1, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work) {
double share, factor;
int64_t status;
share = moderate_share();
status = plan_with_share(axis, share, axes, cells, work);
if (status != 0) {
(*result_0) = plan_with_share(axis, steepest_share(), axes, cells, work);
(*result_1) = steepest_share();
return 0;
}
factor = smoothness_share(share, steepest_share());
if (shorter_with(steepest_share(), share, factor, axis, axes, cells, work)) {
share = steepest_share();
}
(*result_0) = status;
(*result_1) = share;
return 0;
}
static int64_t plan_axis(int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work) {
double share;
int64_t missed, status;
share = usual_share(span_row(&axes, axis));
status = plan_with_share(axis, share, axes, cells, work);
missed = (int64_t)(*cspan_at(&work, 98, 21));
if (*cspan_at(&axes, axis, 14) == 0.0) {
return status;
}
if ((status == -1) || (status == -2)) {
plan_refused(&status, &share, axis, axes, cells, work);
}
else if ((status == 0) && (missed > 0)) {
share = plan_steeper(missed, axis, axes, cells, work);
}
if ((status == 0) && (*cspan_at(&work, 98, 22) != 0.0)) {
plan_thoroughly(share, axis, axes, cells, work);
}
return status;
}
static int64_t check_waypoints(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_1d report) {
int64_t j, i;
double velocity, acceleration;
bool moving;
for (j = 0; j < states.shape[0]; j += 1) {
for (i = 0; i < axes.shape[0]; i += 1) {
velocity = *cspan_at(&states, j, i, 1);
acceleration = *cspan_at(&states, j, i, 2);
*cspan_at(&report, 0) = i;
*cspan_at(&report, 1) = j;
*cspan_at(&report, 2) = velocity;
*cspan_at(&report, 3) = side_limit(1, velocity, span_row(&axes, i));
*cspan_at(&report, 4) = own_side(1, velocity, span_row(&axes, i));
if (fabs(velocity) > *cspan_at(&report, 3) * (1.0 + 1e-12)) {
return -7;
}
moving = (velocity != 0.0) || (acceleration != 0.0);
if ((*cspan_at(&dwells, j) > 0.0) && moving) {
return -10;
}
*cspan_at(&report, 2) = acceleration;
*cspan_at(&report, 3) = side_limit(2, acceleration, span_row(&axes, i));
*cspan_at(&report, 4) = own_side(2, acceleration, span_row(&axes, i));
if (fabs(acceleration) > *cspan_at(&report, 3) * (1.0 + 1e-12)) {
return -8;
}
}
}
return 0;
}
static int64_t time_left(double* result_0, double* result_1, int64_t* result_2, int64_t first, int64_t step, double target, array_double_3d cells) {
double rest, base;
int64_t count, j;
rest = target;
base = 0.0;
count = 0;
for (j = first; (step > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += step) {
rest = rest - *cspan_at(&cells, j, 67, 1);
if (*cspan_at(&cells, j, 68, 4) != 0.0) {
base = base + *cspan_at(&cells, j, 67, 1);
count = count + 1;
}
}
(*result_0) = rest;
(*result_1) = base;
(*result_2) = count;
return 0;
}
static bool prolong_all(int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work) {
int64_t step, j, sweep, count, end, i;
double rest, base, factor, extra, present, reached;
step = axes.shape[0];
for (j = first; (step > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += step) {
*cspan_at(&cells, j, 68, 4) = 1.0;
}
for (sweep = 0; sweep < 100; sweep += 1) {
time_left(&rest, &base, &count, first, step, target, cells);
if (rest <= 1e-13 * target) {
return 1;
}
if (count == 0) {
return 0;
}
factor = 1.0;
extra = rest / count;
if (base > 0.0) {
factor = 1.0 + rest / base;
extra = 0.0;
}
for (j = first; (step > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += step) {
if (*cspan_at(&cells, j, 68, 4) != 0.0) {
present = *cspan_at(&cells, j, 67, 1);
end = j + last - first;
reached = common_duration(present * factor + extra, 1e+300, 0.0, j, end, axes, cells, work);
if ((reached < 0.0) || (reached - present > rest * (1.0 + 1e-13))) {
*cspan_at(&cells, j, 68, 4) = 0.0;
}
else {
rest = rest - (reached - present);
for (i = j; i < end; i += 1) {
*cspan_at(&cells, i, 67, 1) = reached;
}
}
}
}
}
return 0;
}
static bool prolong_from(int64_t begin, double share, int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work) {
int64_t step, intervals, k, count, j, i;
double rest, base, present, reached;
step = axes.shape[0];
intervals = span_floor_div(cells.shape[0], step);
for (k = 0; k < intervals; k += 1) {
time_left(&rest, &base, &count, first, step, target, cells);
j = first + span_floor_mod((begin - first + k * step), (intervals * step));
present = *cspan_at(&cells, j, 67, 1);
reached = common_duration(present + share * rest, 1e+300, 0.0, j, j + last - first, axes, cells, work);
if ((reached >= 0.0) && (reached - present <= rest * (1.0 + 1e-13))) {
for (i = j; i < j + last - first; i += 1) {
*cspan_at(&cells, i, 67, 1) = reached;
}
}
share = 1.0;
}
time_left(&rest, &base, &count, first, step, target, cells);
return rest <= 1e-13 * target;
}
static bool distribute(int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work) {
int64_t step, i, quarters, j;
double share;
step = axes.shape[0];
for (i = 0; i < cells.shape[0]; i += 1) {
*cspan_at(&cells, i, 68, 3) = *cspan_at(&cells, i, 67, 1);
}
if (prolong_all(first, last, target, axes, cells, work)) {
return 1;
}
for (quarters = 0; quarters < 4; quarters += 1) {
for (j = first; (step > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += step) {
for (i = 0; i < cells.shape[0]; i += 1) {
*cspan_at(&cells, i, 67, 1) = *cspan_at(&cells, i, 68, 3);
}
share = 1.0 - 0.25 * quarters;
if (prolong_from(j, share, first, last, target, axes, cells, work)) {
return 1;
}
}
}
return 0;
}
static bool rewrite_intervals(int64_t first, int64_t last, array_double_2d axes, array_double_3d cells, array_double_2d work) {
int64_t j, i;
double duration;
for (j = 0; (axes.shape[0] > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += axes.shape[0]) {
for (i = first; i < last; i += 1) {
duration = *cspan_at(&cells, j + i, 67, 1);
if (!set_duration(duration, span_matrix(&cells, j + i), span_row(&axes, i), work)) {
return 0;
}
}
}
return 1;
}
static void set_problems(array_double_3d states, array_double_3d cells) {
int64_t axes, j, i;
array_double_2d cell;
axes = states.shape[1];
for (j = 0; j < states.shape[0] - 1; j += 1) {
for (i = 0; i < axes; i += 1) {
cell = span_matrix(&cells, j * axes + i);
*cspan_at(&cell, 66, 0) = *cspan_at(&states, j, i, 1);
*cspan_at(&cell, 66, 1) = *cspan_at(&states, j, i, 2);
*cspan_at(&cell, 66, 2) = *cspan_at(&states, j + 1, i, 1);
*cspan_at(&cell, 66, 3) = *cspan_at(&states, j + 1, i, 2);
*cspan_at(&cell, 66, 4) = *cspan_at(&states, j + 1, i, 0) - *cspan_at(&states, j, i, 0);
*cspan_at(&cell, 66, 5) = 0.0;
*cspan_at(&cell, 68, 2) = 0.0;
if ((j == 0) && (states.shape[2] > 3)) {
*cspan_at(&cell, 68, 2) = *cspan_at(&states, j, i, 3);
}
}
}
}
static double meet_intervals(int64_t first, int64_t last, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work) {
double sample_time, longest, time, total;
bool meeting;
int64_t j, end, i;
sample_time = *cspan_at(&options, 3);
meeting = (int64_t)(*cspan_at(&options, 2)) == 1;
total = 0.0;
for (j = first; (axes.shape[0] > 0) ? (j < cells.shape[0]) : (j > cells.shape[0]); j += axes.shape[0]) {
if (meeting || (sample_time > 0.0)) {
end = j + last - first;
longest = 0.0;
for (i = j; i < end; i += 1) {
longest = span_max(longest, *cspan_at(&cells, i, 67, 1));
}
time = common_duration(longest, 1e+300, sample_time, j, end, axes, cells, work);
*cspan_at(&work, 99, 0) = first;
*cspan_at(&work, 99, 1) = span_floor_div(j, axes.shape[0]);
if (time < 0.0) {
return -1.0;
}
for (i = j; i < end; i += 1) {
*cspan_at(&cells, i, 67, 1) = time;
}
}
total = total + *cspan_at(&cells, j, 67, 1);
}
return total;
}
static int64_t synchronize_plan(array_double_1d dwells, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work) {
array_double_1d report;
int64_t synchronization, group, j, axis;
double duration, resting, longest, total, target;
report = span_row(&work, 99);
synchronization = (int64_t)(*cspan_at(&options, 2));
duration = *cspan_at(&options, 4);
group = synchronization == 1 ? axes.shape[0] : 1;
resting = 0.0;
for (j = 0; j < dwells.shape[0]; j += 1) {
resting = resting + *cspan_at(&dwells, j);
}
longest = 0.0;
for (axis = 0; (group > 0) ? (axis < axes.shape[0]) : (axis > axes.shape[0]); axis += group) {
total = meet_intervals(axis, axis + group, options, axes, cells, work);
if (total < 0.0) {
return -4;
}
longest = span_max(longest, total);
}
*cspan_at(&report, 2) = longest + resting;
*cspan_at(&report, 3) = duration;
target = longest;
if (duration > 0.0) {
if (duration < (longest + resting) * (1.0 - 1e-13)) {
return -5;
}
target = span_max(duration - resting, longest);
}
if ((synchronization != 2) && (duration <= 0.0)) {
return 0;
}
*cspan_at(&report, 2) = target + resting;
for (axis = 0; (group > 0) ? (axis < axes.shape[0]) : (axis > axes.shape[0]); axis += group) {
*cspan_at(&report, 0) = axis;
if (!distribute(axis, axis + group, target, axes, cells, work)) {
return -6;
}
if (!rewrite_intervals(axis, axis + group, axes, cells, work)) {
return -6;
}
}
return 0;
}
int64_t segfmu_plan_phases(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work) {
array_double_1d report;
double sample_time;
int64_t smoothness, shape, axis, status;
report = span_row(&work, 99);
*cspan_at(&report, 2) = *cspan_at(&options, 3);
sample_time = *cspan_at(&report, 2);
if ((sample_time > 0.0) && (!((1e-09 <= sample_time) && (sample_time <= 1000000.0)))) {
return -16;
}
smoothness = (int64_t)(*cspan_at(&options, 0));
shape = (int64_t)(*cspan_at(&options, 1));
for (axis = 0; axis < axes.shape[0]; axis += 1) {
segfmu_axis_limits(smoothness, shape, span_row(&limits, axis), span_row(&axes, axis));
set_lower(span_row(&lower, axis), span_row(&axes, axis));
}
status = check_waypoints(states, dwells, axes, report);
if (status < 0) {
return status;
}
set_problems(states, cells);
for (axis = 0; axis < axes.shape[0]; axis += 1) {
status = plan_axis(axis, axes, cells, work);
if (status < 0) {
return status;
}
}
status = synchronize_plan(dwells, options, axes, cells, work);
return status;
}
int64_t segfmu_count_pieces(array_double_2d axes, array_double_3d cells) {
int64_t each, i, total;
double phases;
total = 810 + axes.shape[0] + cells.shape[0];
each = segfmu_ramp_pieces(span_row(&axes, 0));
for (i = 0; i < cells.shape[0]; i += 1) {
phases = *cspan_at(&cells, i, 67, 3);
phases = phases + *cspan_at(&cells, i, 67, 4);
total = total + each * (int64_t)(phases);
}
return total;
}
static void shift_piece(array_double_2d coefficients, int64_t source, double t, double weight, int64_t target) {
int64_t width, i;
double factorial, value;
width = coefficients.shape[1];
factorial = 1.0;
for (i = 0; i < width; i += 1) {
if (i > 0) {
factorial = factorial * i;
}
value = evaluate_piece(coefficients, source, width, t, i) / factorial;
*cspan_at(&coefficients, target, i) = *cspan_at(&coefficients, target, i) + weight * value;
}
}
static int64_t merge_pieces(double weight, double now, int64_t middle, int64_t last, array_double_2d timing, array_double_2d coefficients, int64_t row) {
int64_t a, b, i;
double total, same, t, t_a, t_b, rest_a, rest_b, step;
a = timing.shape[0] - 810;
b = middle;
total = 0.0;
for (i = a; i < middle; i += 1) {
total = total + *cspan_at(&timing, i, 1);
}
same = 2e-16 * (last - a) * total;
t = now;
t_a = 0.0;
t_b = 0.0;
while((a < middle) && (b < last)) {
clear_piece(coefficients, row);
shift_piece(coefficients, a, t_a, 1.0 - weight, row);
shift_piece(coefficients, b, t_b, weight, row);
rest_a = *cspan_at(&timing, a, 1) - t_a;
rest_b = *cspan_at(&timing, b, 1) - t_b;
step = span_min(rest_a, rest_b);
if (fabs(rest_a - rest_b) <= same) {
step = rest_a;
if (*cspan_at(&timing, b, 1) < *cspan_at(&timing, a, 1)) {
step = rest_b;
}
}
*cspan_at(&timing, row, 0) = t;
*cspan_at(&timing, row, 1) = step;
t = t + step;
t_a = t_a + step;
t_b = t_b + step;
row = row + 1;
if (rest_a <= step + same) {
a = a + 1;
t_a = 0.0;
}
if (rest_b <= step + same) {
b = b + 1;
t_b = 0.0;
}
}
return row;
}
static int64_t expand_profile(array_double_2d cell, bool second, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work) {
array_double_1d state;
int64_t count, result;
state = span_row(&work, 1);
*cspan_at(&state, 0) = *cspan_at(&cell, 68, 0);
*cspan_at(&state, 1) = *cspan_at(&cell, 66, 0);
*cspan_at(&state, 2) = *cspan_at(&cell, 66, 1);
*cspan_at(&state, 3) = 0.0;
*cspan_at(&state, 8) = *cspan_at(&cell, 68, 1);
if (second) {
count = (int64_t)(*cspan_at(&cell, 67, 4));
result = segfmu_expand_phases(span_rows(&cell, 33, 66), count, axis, timing, coefficients, row, work);
return result;
}
count = (int64_t)(*cspan_at(&cell, 67, 3));
result = segfmu_expand_phases(span_rows(&cell, 0, 33), count, axis, timing, coefficients, row, work);
return result;
}
static int64_t expand_cell(array_double_2d cell, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work) {
double weight, now;
int64_t spare, middle, last, result;
weight = *cspan_at(&cell, 67, 2);
if ((weight <= 0.0) || (weight >= 1.0)) {
result = expand_profile(cell, weight >= 1.0, axis, timing, coefficients, row, work);
return result;
}
spare = timing.shape[0] - 810;
middle = expand_profile(cell, 0, axis, timing, coefficients, spare, work);
last = expand_profile(cell, 1, axis, timing, coefficients, middle, work);
now = *cspan_at(&cell, 68, 1);
result = merge_pieces(weight, now, middle, last, timing, coefficients, row);
return result;
}
static int64_t expand_plan(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work) {
int64_t points, count, axis, j, row;
double now, a;
array_double_2d cell;
points = states.shape[0];
count = axes.shape[0];
row = 0;
for (axis = 0; axis < count; axis += 1) {
*cspan_at(&offsets, axis) = row;
now = 0.0;
for (j = 0; j < points; j += 1) {
*cspan_at(&times, j, axis) = now;
if ((*cspan_at(&dwells, j) > 0.0) || ((j == points - 1) && (row == *cspan_at(&offsets, axis)))) {
clear_piece(coefficients, row);
a = *cspan_at(&states, j, axis, 2);
*cspan_at(&coefficients, row, 0) = *cspan_at(&states, j, axis, 0);
*cspan_at(&coefficients, row, 1) = *cspan_at(&states, j, axis, 1);
*cspan_at(&coefficients, row, 2) = 0.5 * a;
*cspan_at(&timing, row, 0) = now;
*cspan_at(&timing, row, 1) = *cspan_at(&dwells, j);
now = now + *cspan_at(&dwells, j);
row = row + 1;
}
if (j < points - 1) {
cell = span_matrix(&cells, j * count + axis);
*cspan_at(&cell, 68, 0) = *cspan_at(&states, j, axis, 0);
*cspan_at(&cell, 68, 1) = now + *cspan_at(&cell, 68, 2);
row = expand_cell(cell, span_row(&axes, axis), timing, coefficients, row, work);
now = now + *cspan_at(&cell, 67, 1);
}
}
*cspan_at(&times, points, axis) = now;
}
*cspan_at(&offsets, count) = row;
return row;
}
static void lead_to_plan(array_double_2d lead) {
array_double_1d options;
options = span_row(&lead, 1);
*cspan_at(&lead, 0, 0) = 2;
*cspan_at(&lead, 0, 2) = *cspan_at(&options, 1);
*cspan_at(&lead, 0, 1) = *cspan_at(&options, 4);
if ((int64_t)(*cspan_at(&options, 2)) == 0) {
if (*cspan_at(&options, 4) == 0.0) {
*cspan_at(&lead, 0, 1) = -1.0;
}
}
}
static bool join_behind(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_3d cells, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d lead) {
int64_t count, leads, behind, whole, end;
count = axes.shape[0];
leads = 1 * (count + 1);
behind = 2 * (count + 1);
whole = 3 * (count + 1);
end = 4 * (count + 1);
if (*cspan_at(&offsets, leads + count) + segfmu_count_pieces(axes, cells) > timing.shape[1]) {
return 0;
}
expand_plan(states, dwells, axes, cells, span_matrix(&timing, 2), span_matrix(&coefficients, 2), span_part(&offsets, behind, whole), times, span_rows(&lead, 308, 312));
segfmu_join_plans(span_matrix(&timing, 1), span_matrix(&coefficients, 1), span_part(&offsets, leads, behind), span_matrix(&timing, 2), span_matrix(&coefficients, 2), span_part(&offsets, behind, whole), span_matrix(&timing, 3), span_matrix(&coefficients, 3), span_part(&offsets, whole, end));
return 1;
}
bool segfmu_judge_pieces(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, array_double_2d brakes, array_double_2d lead, array_double_2d spare_timing, array_double_2d spare_coefficients) {
array_double_2d check;
double tolerance, joints;
int64_t axis, wrong, i;
check = span_rows(&lead, 312, 360);
tolerance = *cspan_at(&lead, 2, 0);
joints = *cspan_at(&lead, 2, 1);
for (axis = 0; axis < limits.shape[0]; axis += 1) {
for (i = 0; i < brakes.shape[1]; i += 1) {
*cspan_at(&brakes, axis, i) = 0.0;
}
}
wrong = check_plan(states, times, timing, coefficients, offsets, limits, lower, tolerance, joints, check);
if (wrong > 0) {
if (segfmu_find_brakes(span_matrix(&states, 0), limits, lower, brakes, lead, spare_timing, spare_coefficients)) {
wrong = check_braked_plan(states, times, timing, coefficients, offsets, limits, lower, brakes, tolerance, joints, check);
}
}
return wrong == 0;
}
static void set_delayed(array_double_3d states) {
int64_t points, j, axis, i;
points = span_floor_div(states.shape[0], 2);
for (j = 1; j < points; j += 1) {
for (axis = 0; axis < states.shape[1]; axis += 1) {
for (i = 0; i < states.shape[2]; i += 1) {
*cspan_at(&states, points + j, axis, i) = 0.0;
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&states, points + j, axis, i) = *cspan_at(&states, j, axis, i);
}
}
}
}
static int64_t finish_plan(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d lead) {
int64_t points, last, count, ends, whole, end;
points = dwells.shape[0];
last = 2 * points;
count = limits.shape[0];
ends = 2 * count;
whole = 3 * (count + 1);
end = 4 * (count + 1);
if (!join_behind(span_layers(&states, points, last), dwells, span_rows(&axes, 0, count), cells, timing, coefficients, offsets, times, lead)) {
return 1;
}
if (segfmu_judge_pieces(span_layers(&states, 0, points), times, span_matrix(&timing, 3), span_matrix(&coefficients, 3), span_part(&offsets, whole, end), limits, lower, span_rows(&axes, count, ends), lead, span_matrix(&timing, 2), span_matrix(&coefficients, 2))) {
return 0;
}
return (int64_t)(-12);
}
int64_t segfmu_plan_onward(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d lead) {
int64_t points, count, last, done, i, first, behind, failed, status;
points = dwells.shape[0];
count = limits.shape[0];
last = 2 * points;
done = (int64_t)(*cspan_at(&lead, 0, 4));
status = 0;
*cspan_at(&lead, 0, 5) = -1.0;
for (i = 0; i < 5; i += 1) {
*cspan_at(&lead, 68 + 99, i) = 0.0;
}
if (timing.shape[1] < *cspan_at(&offsets, count) + 400 * count + 1200) {
return 1;
}
if (done == 0) {
lead_to_plan(lead);
first = count + 1;
behind = 2 * first;
failed = segfmu_find_leads(span_layers(&states, 0, 2), limits, lower, span_part(&offsets, 0, first), span_matrix(&timing, 0), span_matrix(&coefficients, 0), span_matrix(&states, points), lead, span_matrix(&timing, 1), span_matrix(&coefficients, 1), span_part(&offsets, first, behind));
*cspan_at(&lead, 0, 5) = failed;
if (failed >= 0) {
status = (int64_t)(-3);
}
}
if ((status == 0) && (done != 2)) {
set_delayed(states);
status = segfmu_plan_phases(span_layers(&states, points, last), dwells, limits, lower, span_row(&lead, 1), span_rows(&axes, 0, count), cells, span_rows(&lead, 68, 308));
}
if (status == 0) {
status = finish_plan(states, dwells, limits, lower, axes, cells, timing, coefficients, offsets, times, lead);
}
return status;
}
static void set_place(array_double_2d operation, array_double_3d states) {
int64_t axis, i;
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < states.shape[2]; i += 1) {
*cspan_at(&states, 1, axis, i) = 0.0;
}
*cspan_at(&states, 1, axis, 0) = *cspan_at(&operation, 1, 1 + axis);
}
}
static void set_ends(array_double_2d operation, array_double_3d states) {
int64_t axis, i;
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < states.shape[2]; i += 1) {
*cspan_at(&states, 0, axis, i) = 0.0;
}
for (i = 0; i < 4; i += 1) {
*cspan_at(&states, 0, axis, i) = *cspan_at(&operation, 26 + axis, i);
}
}
set_place(operation, states);
}
static void set_options(array_double_2d known, array_double_2d lead, array_double_2d work) {
int64_t i;
for (i = 0; i < 5; i += 1) {
*cspan_at(&lead, 1, i) = *cspan_at(&known, 5, i);
}
*cspan_at(&lead, 1, 3) = 0.0;
*cspan_at(&lead, 1, 4) = 0.0;
for (i = 0; i < 2; i += 1) {
*cspan_at(&work, 84, i) = 0.0;
}
}
static double coming_velocity(int64_t axis, array_double_2d operation, array_double_2d limits) {
array_double_1d now;
double acceleration, time, before, velocity;
int64_t order;
now = span_row(&operation, 19 + axis);
velocity = *cspan_at(&now, 1);
acceleration = *cspan_at(&now, 2);
if (velocity * acceleration <= 0.0) {
return velocity;
}
time = 0.0;
before = fabs(acceleration);
for (order = 2; order < span_min_int(limits.shape[1], 4); order += 1) {
if (*cspan_at(&limits, axis, order) > 0.0) {
time = time + before / *cspan_at(&limits, axis, order);
before = *cspan_at(&limits, axis, order);
}
}
return velocity + 0.5 * acceleration * time;
}
static bool is_too_fast(array_double_2d operation, array_double_3d limits) {
int64_t axis;
double velocity, slowed;
bool faster;
faster = 0;
for (axis = 0; axis < 3; axis += 1) {
velocity = coming_velocity(axis, operation, span_matrix(&limits, 0));
slowed = limited_velocity(velocity, 1.0, *cspan_at(&limits, 1, axis, 0), *cspan_at(&operation, 23 + axis, 0));
*cspan_at(&operation, 22, axis) = slowed;
*cspan_at(&operation, 12, axis) = 1.0;
if (fabs(velocity - slowed) > 1e-09 * *cspan_at(&limits, 1, axis, 0)) {
faster = 1;
}
}
return faster;
}
static void end_ways_at_target(array_double_2d operation) {
int64_t axis, i;
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < 2; i += 1) {
*cspan_at(&operation, 16 + axis, i) = *cspan_at(&operation, 1, 1 + axis);
}
}
}
static bool lead_to_target(array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead) {
bool result;
set_motion(operation, states);
set_place(operation, states);
lead_to_plan(lead);
*cspan_at(&lead, 0, 3) = 1.0;
result = lead_between(1, 2, span_rows(&operation, 26, 29), limits, span_rows(&operation, 23, 26), timing, coefficients, offsets, states, lead);
return result;
}
static bool plan_target(array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work) {
array_double_1d dwells;
array_double_2d axes;
int64_t status, first, last;
bool result;
dwells = span_row(&work, 84);
axes = span_rows(&work, 85, 88);
status = segfmu_plan_phases(states, dwells, limits, lower, span_row(&lead, 1), axes, cells, span_rows(&lead, 68, 308));
if (status < 0) {
return 0;
}
first = 1 * 4;
last = 5 * 4;
result = join_behind(states, dwells, axes, cells, span_layers(&timing, 1, 5), span_layers(&coefficients, 1, 5), span_part(&offsets, first, last), span_rows(&work, 81, 84), lead);
return result;
}
static bool seek_target(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work) {
bool found;
int64_t axis, i;
set_options(known, lead, work);
found = 0;
if (is_too_fast(operation, limits)) {
set_lower_of(0, operation, limits, known);
end_ways_at_target(operation);
found = reach_velocities(0, operation, span_matrix(&limits, 0), timing, coefficients, offsets, states, lead);
set_lower_of(1, operation, limits, known);
}
else {
found = lead_to_target(operation, span_matrix(&limits, 1), timing, coefficients, offsets, states, lead);
}
if (!found) {
return 0;
}
set_ends(operation, states);
found = plan_target(span_matrix(&limits, 1), span_rows(&operation, 23, 26), timing, coefficients, offsets, states, cells, lead, work);
if ((!found) || (!has_room(4, offsets))) {
return 0;
}
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < 4; i += 1) {
*cspan_at(&operation, 9 + axis, i) = 0.0;
}
}
return 1;
}
static void open_ways(array_double_2d operation, array_double_2d known) {
int64_t axis;
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&operation, 16 + axis, 0) = low_end(axis, known);
*cspan_at(&operation, 16 + axis, 1) = high_end(axis, known);
}
}
static bool are_ways_kept(array_double_2d operation) {
int64_t axis, i;
double kept;
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < 2; i += 1) {
kept = *cspan_at(&operation, 13 + axis, i);
if (kept != *cspan_at(&operation, 16 + axis, i)) {
return 0;
}
}
}
return 1;
}
static void keep_ways(array_double_2d operation) {
int64_t axis, i;
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < 2; i += 1) {
*cspan_at(&operation, 13 + axis, i) = *cspan_at(&operation, 16 + axis, i);
}
}
}
static bool rests_short(array_double_2d operation) {
int64_t axis;
array_double_1d now;
double end, left;
bool resting;
for (axis = 0; axis < 3; axis += 1) {
now = span_row(&operation, 19 + axis);
end = *cspan_at(&now, 0);
if (*cspan_at(&operation, 22, axis) > 0.0) {
end = *cspan_at(&operation, 16 + axis, 1);
}
else if (*cspan_at(&operation, 22, axis) < 0.0) {
end = *cspan_at(&operation, 16 + axis, 0);
}
left = fabs(end - *cspan_at(&now, 0)) - 2.0 * end_rounding_of(end);
resting = (*cspan_at(&now, 1) == 0.0) && (*cspan_at(&now, 2) == 0.0);
if (resting && (left > 0.0)) {
return 1;
}
}
return 0;
}
static double depth_towards(int64_t axis, double low, double high, double place, array_double_2d operation) {
double wish, now, touch;
array_double_1d way;
wish = *cspan_at(&operation, 22, axis) * *cspan_at(&operation, 12, axis);
now = *cspan_at(&operation, 19 + axis, 0);
way = span_row(&operation, 16 + axis);
touch = 1e-09 * span_max(fabs(low), fabs(high));
if ((wish > 0.0) && (now <= low + touch) && (*cspan_at(&way, 1) > now)) {
return place - low;
}
if ((wish < 0.0) && (now >= high - touch) && (*cspan_at(&way, 0) < now)) {
return high - place;
}
return 1e+300;
}
static void end_way(int64_t axis, double low, double high, array_double_2d operation) {
double now, end;
array_double_1d way;
now = *cspan_at(&operation, 19 + axis, 0);
way = span_row(&operation, 16 + axis);
if (*cspan_at(&operation, 22, axis) > 0.0) {
end = low - end_rounding_of(low);
if (*cspan_at(&way, 1) <= end) {
end = now;
}
*cspan_at(&way, 1) = end;
}
else {
end = high + end_rounding_of(high);
if (*cspan_at(&way, 0) >= end) {
end = now;
}
*cspan_at(&way, 0) = end;
}
}
static bool end_before_obstacle(array_double_2d operation, array_double_2d known, array_double_2d work) {
array_double_1d fault, box;
int64_t obstacle, low, high, axes, chosen, axis;
double least, depth;
fault = span_row(&work, 80);
box = span_row(&work, 52);
obstacle = 9 + (int64_t)(*cspan_at(&fault, 5));
segfmu_write_box(span_row(&known, 4), span_row(&known, obstacle), box);
low = 0;
high = 3;
axes = 3;
if ((int64_t)(*cspan_at(&fault, 9)) == 2) {
low = 6;
high = 9;
axes = 2;
}
chosen = -1;
least = 1e+300;
for (axis = 0; axis < axes; axis += 1) {
depth = depth_towards(axis, *cspan_at(&box, low + axis), *cspan_at(&box, high + axis), *cspan_at(&fault, 2 + axis), operation);
if (depth < least) {
least = depth;
chosen = axis;
}
}
if (chosen < 0) {
return 0;
}
end_way(chosen, *cspan_at(&box, low + chosen), *cspan_at(&box, high + chosen), operation);
return 1;
}
static bool is_prolonged(array_double_2d operation) {
array_double_1d progress;
int64_t attempt;
progress = span_row(&operation, 4);
attempt = (int64_t)(*cspan_at(&progress, 3));
if ((*cspan_at(&progress, 11) > 0.0) || (!is_aim(3, operation))) {
return 0;
}
return (attempt == 0) || (attempt == 10);
}
static void choose_ease(int64_t attempt, int64_t status, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
double pace, steepness, speed;
int64_t first;
if (!is_slower(attempt + 1)) {
return;
}
pace = 1.0;
steepness = 1.0;
speed = 1.0;
if (status == 6) {
first = 4 * 4;
ease_within(&pace, &steepness, &speed, span_matrix(&timing, 4), span_matrix(&coefficients, 4), span_part(&offsets, first, first + 4), known, work);
}
note_ease(attempt, pace, steepness, speed, operation);
if (attempt == 6) {
stop_as_before(operation);
}
}
static bool keeps_blocked(array_double_2d operation) {
bool result;
if ((!is_prolonged(operation)) || (!are_ways_kept(operation))) {
return 0;
}
result = !rests_short(operation);
return result;
}
static int64_t first_attempt(int64_t* result_0_0001, int64_t* result_1_0001, array_double_2d operation, array_double_2d known) {
array_double_1d progress;
int64_t following;
progress = span_row(&operation, 4);
following = (int64_t)(*cspan_at(&progress, 11));
*cspan_at(&progress, 11) = 0.0;
if (following > 0) {
(*result_0_0001) = following - 1;
(*result_1_0001) = (int64_t)(*cspan_at(&progress, 12));
return 0;
}
open_ways(operation, known);
*cspan_at(&progress, 13) = 0.0;
*cspan_at(&progress, 8) = 1.0;
(*result_0_0001) = 0;
(*result_1_0001) = 0;
return 0;
}
static bool keeps_stopping(int64_t attempt, array_double_2d operation) {
double stopping;
bool result;
if (attempt < 6) {
return 0;
}
stopping = *cspan_at(&operation, 4, 3);
if ((6 <= stopping) && (stopping < 9)) {
result = is_aim(3, operation);
return result;
}
return 0;
}
static bool is_passed_over(int64_t attempt, int64_t failed, array_double_2d operation) {
bool result;
if (keeps_stopping(attempt, operation)) {
return 1;
}
result = !is_worth(attempt, failed, span_row(&operation, 1));
return result;
}
static void put_off(int64_t attempt, int64_t failed, array_double_2d operation) {
array_double_1d progress;
progress = span_row(&operation, 4);
*cspan_at(&progress, 11) = 1 + attempt;
*cspan_at(&progress, 12) = failed;
if (!is_aim(3, operation)) {
*cspan_at(&progress, 1) = 7;
}
}
static bool seek_plan(int64_t attempt, array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work) {
array_double_1d aim;
int64_t axis;
bool slow, result;
aim = span_row(&operation, 1);
set_attempt(attempt, operation, limits, known);
if ((*cspan_at(&aim, 0) > 0.5) && (attempt < 6)) {
result = seek_target(operation, limits, known, timing, coefficients, offsets, states, cells, lead, work);
return result;
}
for (axis = 0; axis < 3; axis += 1) {
*cspan_at(&operation, 22, axis) = *cspan_at(&aim, 1 + axis);
*cspan_at(&operation, 12, axis) = share_of(attempt, axis, operation);
}
slow = is_slower(attempt) && (attempt < 6);
result = seek_velocity(slow, operation, span_matrix(&limits, 1), timing, coefficients, offsets, states, lead);
return result;
}
static bool is_stop(array_double_1d aim) {
double fastest;
int64_t axis;
bool result;
fastest = 0.0;
for (axis = 0; axis < 3; axis += 1) {
fastest = span_max(fastest, fabs(*cspan_at(&aim, 1 + axis)));
}
result = (*cspan_at(&aim, 0) < 0.5) && (fastest == 0.0);
return result;
}
static int64_t rank(int64_t attempt, array_double_2d operation) {
if (is_stop(span_row(&operation, 1))) {
return 0;
}
if (attempt <= 2) {
if (*cspan_at(&operation, 4, 13) > 0.0) {
return 10;
}
return 0;
}
return attempt;
}
static bool is_slowed(array_double_2d operation) {
array_double_1d aim;
bool result;
aim = span_row(&operation, 1);
if ((*cspan_at(&aim, 0) > 0.5) || is_stop(aim)) {
return 0;
}
result = *cspan_at(&operation, 4, 8) < 1.0;
return result;
}
static void note_taken(int64_t attempt, array_double_2d operation) {
array_double_1d command;
int64_t i;
double retry;
command = span_row(&operation, 0);
for (i = 0; i < 5; i += 1) {
*cspan_at(&operation, 3, i) = *cspan_at(&operation, 1, i);
}
*cspan_at(&operation, 4, 3) = attempt;
retry = *cspan_at(&command, 0);
if (!is_stop(span_row(&operation, 1))) {
retry = retry + 0.499 * *cspan_at(&command, 14);
}
*cspan_at(&operation, 4, 4) = retry;
}
static void take_plan(int64_t attempt, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets) {
array_double_1d progress;
int64_t axis, i;
progress = span_row(&operation, 4);
copy_plan(4, 0, timing, coefficients, offsets);
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < 4; i += 1) {
*cspan_at(&operation, 6 + axis, i) = *cspan_at(&operation, 9 + axis, i);
}
}
keep_ways(operation);
*cspan_at(&progress, 0) = *cspan_at(&operation, 0, 0);
*cspan_at(&progress, 14) = *cspan_at(&progress, 14) + 1.0;
*cspan_at(&progress, 1) = 0;
if ((attempt > 0) || is_slowed(operation)) {
*cspan_at(&progress, 1) = 1;
}
note_taken(attempt, operation);
}
static bool blocks(int64_t attempt, array_double_2d operation, array_double_2d known, array_double_2d work) {
array_double_1d progress;
progress = span_row(&operation, 4);
if ((attempt >= 6) || (*cspan_at(&operation, 1, 0) > 0.5)) {
return 0;
}
if (!(*cspan_at(&progress, 13) < 3.0)) {
return 0;
}
if (!end_before_obstacle(operation, known, work)) {
return 0;
}
*cspan_at(&progress, 13) = *cspan_at(&progress, 13) + 1.0;
return 1;
}
static bool holds_until_next(array_double_2d operation) {
double begin;
bool result;
begin = *cspan_at(&operation, 4, 0);
result = holds_long_enough(*cspan_at(&operation, 0, 0) - begin, operation);
return result;
}
static bool renew_holds(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work, array_double_3d stack) {
array_double_1d progress;
double elapsed, retry;
int64_t status;
progress = span_row(&operation, 4);
elapsed = *cspan_at(&operation, 0, 0) - *cspan_at(&progress, 0);
copy_plan(1, 4, timing, coefficients, offsets);
if (!prolong_holds(elapsed, operation, timing, coefficients, offsets)) {
return 0;
}
*cspan_at(&progress, 15) = *cspan_at(&progress, 15) + 1.0;
status = prove_plan(operation, limits, known, timing, coefficients, offsets, states, lead, work, stack);
if (status != 0) {
*cspan_at(&progress, 2) = status;
return 0;
}
retry = *cspan_at(&progress, 4);
take_plan((int64_t)(*cspan_at(&progress, 3)), operation, timing, coefficients, offsets);
*cspan_at(&progress, 4) = retry;
return 1;
}
static bool attempt_plans(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work, array_double_3d stack) {
array_double_1d progress;
int64_t attempt, failed, tries, status;
progress = span_row(&operation, 4);
first_attempt(&attempt, &failed, operation, known);
tries = 0;
while(attempt < 9) {
if (is_passed_over(attempt, failed, operation)) {
attempt = attempt + 1;
continue;
}
if ((tries > 0) && (!(tries < *cspan_at(&operation, 0, 15)))) {
put_off(attempt, failed, operation);
return 0;
}
tries = tries + 1;
*cspan_at(&progress, 15) = *cspan_at(&progress, 15) + 1.0;
status = 2;
if (seek_plan(attempt, operation, limits, known, timing, coefficients, offsets, states, cells, lead, work)) {
status = prove_plan(operation, span_matrix(&limits, 0), known, timing, coefficients, offsets, states, lead, work, stack);
}
if (status == 0) {
*cspan_at(&progress, 9) = ease_of(attempt, 6, operation);
*cspan_at(&progress, 10) = ease_of(attempt, 7, operation);
take_plan(rank(attempt, operation), operation, timing, coefficients, offsets);
return 1;
}
if ((failed == 0) && (*cspan_at(&progress, 13) == 0.0)) {
*cspan_at(&progress, 2) = status;
}
choose_ease(attempt, status, operation, known, timing, coefficients, offsets, work);
if (!((status == 5) && blocks(attempt, operation, known, work))) {
failed = status;
attempt = attempt + 1;
}
else if (keeps_blocked(operation)) {
*cspan_at(&progress, 1) = 1;
note_taken(10, operation);
if (holds_until_next(operation)) {
return 0;
}
if (renew_holds(operation, span_matrix(&limits, 0), known, timing, coefficients, offsets, states, lead, work, stack)) {
return 1;
}
}
}
if (failed > 0) {
*cspan_at(&progress, 1) = *cspan_at(&progress, 2);
}
note_taken(9, operation);
return 0;
}
static bool trips(array_double_2d operation) {
int64_t drive;
for (drive = 0; drive < 3; drive += 1) {
if (*cspan_at(&operation, 0, 17 + drive) > 0.5) {
if (*cspan_at(&operation, 32, 28 + drive) < 0.5) {
return 1;
}
}
}
return 0;
}
static bool brake_anew(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_2d work) {
advance_swing(elapsed, *cspan_at(&known, 0, 3), span_row(&operation, 32), work);
put_aside(operation);
note_trips(operation);
if (!plan_brakes(operation, known, work)) {
bring_back(operation);
note_trips(operation);
*cspan_at(&operation, 4, 2) = 6;
}
cover_swing(operation, known, timing, coefficients, offsets, work);
return 1;
}
void segfmu_begin_operation(double time, array_double_2d operation) {
int64_t row, i;
for (row = 1; row < 38; row += 1) {
for (i = 0; i < operation.shape[1]; i += 1) {
*cspan_at(&operation, row, i) = 0.0;
}
}
*cspan_at(&operation, 4, 0) = time;
*cspan_at(&operation, 4, 4) = time;
*cspan_at(&operation, 32, 31) = time;
*cspan_at(&operation, 3, 0) = -1.0;
}
static void begin_swing(array_double_2d operation) {
array_double_1d progress;
int64_t axis, i;
progress = span_row(&operation, 4);
for (axis = 0; axis < 3; axis += 1) {
for (i = 0; i < 4; i += 1) {
*cspan_at(&operation, 6 + axis, i) = 0.0;
}
}
*cspan_at(&progress, 14) = *cspan_at(&progress, 14) + 1.0;
*cspan_at(&progress, 1) = 0;
*cspan_at(&progress, 3) = 0.0;
*cspan_at(&progress, 11) = 0.0;
*cspan_at(&progress, 4) = *cspan_at(&operation, 0, 0);
*cspan_at(&progress, 5) = 5;
*cspan_at(&operation, 32, 31) = *cspan_at(&operation, 0, 0);
*cspan_at(&operation, 3, 0) = -1.0;
}
static bool is_due(array_double_2d operation) {
double retry;
bool result;
retry = *cspan_at(&operation, 4, 4);
result = !(*cspan_at(&operation, 0, 0) < retry);
return result;
}
static bool is_served(double elapsed, array_double_2d operation) {
array_double_1d progress;
bool result;
progress = span_row(&operation, 4);
if (!is_aim(3, operation)) {
return 0;
}
if (*cspan_at(&progress, 3) == 0) {
result = holds_long_enough(elapsed, operation);
return result;
}
if ((*cspan_at(&progress, 11) > 0.0) || is_due(operation)) {
return 0;
}
result = (!is_prolonged(operation)) || holds_long_enough(elapsed, operation);
return result;
}
static bool renews(double elapsed, array_double_2d operation) {
bool result;
if ((!is_prolonged(operation)) || holds_long_enough(elapsed, operation)) {
return 0;
}
result = (*cspan_at(&operation, 4, 3) == 0) || (!is_due(operation));
return result;
}
bool segfmu_operate(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work, array_double_3d stack) {
array_double_1d command, progress;
int64_t mode, i;
double elapsed;
bool result;
command = span_row(&operation, 0);
progress = span_row(&operation, 4);
mode = wanted_mode(command);
elapsed = *cspan_at(&command, 0) - *cspan_at(&progress, 0);
if (takes_measured(operation, known, timing, coefficients, offsets, work, stack)) {
return 1;
}
if (*cspan_at(&operation, 32, 0) > 0.5) {
if (trips(operation)) {
result = brake_anew(elapsed, operation, known, timing, coefficients, offsets, work);
return result;
}
if (!wants_calm(operation)) {
result = prolong_swing(elapsed, operation, known, timing, coefficients, offsets, work);
return result;
}
take_over(elapsed, operation, known, timing, coefficients, offsets, work, stack);
return 1;
}
if (mode == 5) {
note_present(elapsed, operation, timing, coefficients, offsets);
if (begin_emergency(operation, known, timing, coefficients, offsets, work)) {
begin_swing(operation);
return 1;
}
}
if (mode == 0) {
return 0;
}
if (is_calming(operation)) {
result = calm_on(elapsed, operation, known, timing, coefficients, offsets, work, stack);
return result;
}
for (i = 0; i < 5; i += 1) {
*cspan_at(&operation, 2, i) = *cspan_at(&operation, 1, i);
}
write_aim(operation, span_matrix(&limits, 0), known, timing, coefficients, offsets);
if (!is_aim(2, operation)) {
*cspan_at(&progress, 11) = 0.0;
}
if (is_served(elapsed, operation)) {
return 0;
}
note_present(elapsed, operation, timing, coefficients, offsets);
if (renews(elapsed, operation) && renew_holds(operation, span_matrix(&limits, 0), known, timing, coefficients, offsets, states, lead, work, stack)) {
return 1;
}
result = attempt_plans(operation, limits, known, timing, coefficients, offsets, states, cells, lead, work, stack);
return result;
}
int64_t segfmu_check_ready(array_double_1d compensation, array_double_1d resistance, int64_t pieces, array_double_1d fault) {
int64_t drive;
for (drive = 0; drive < 3; drive += 1) {
*cspan_at(&fault, 0) = drive;
*cspan_at(&fault, 1) = *cspan_at(&compensation, 3 + drive);
if (*cspan_at(&fault, 1) > 0.0) {
return 1;
}
if (rubs(resistance, drive)) {
return 2;
}
}
*cspan_at(&fault, 1) = pieces;
if (pieces > 1200) {
return 3;
}
return 0;
}
double segfmu_next_operation(array_double_2d operation) {
array_double_1d command, progress, swing, held;
int64_t mode, axis;
double uncovered, following, renewed, result;
command = span_row(&operation, 0);
progress = span_row(&operation, 4);
swing = span_row(&operation, 32);
mode = wanted_mode(command);
if (*cspan_at(&swing, 0) > 0.5) {
uncovered = *cspan_at(&progress, 0) + *cspan_at(&swing, 1) - 0.5 * *cspan_at(&command, 14);
if ((mode == 5) || (mode == 0)) {
return uncovered;
}
result = span_min(uncovered, next_calm(operation));
return result;
}
if (mode == 0) {
return 1e+300;
}
if (is_calming(operation)) {
result = *cspan_at(&swing, 31);
return result;
}
if ((*cspan_at(&progress, 3) > 0.0) || (*cspan_at(&progress, 11) > 0.0)) {
result = span_max(*cspan_at(&progress, 4), *cspan_at(&command, 0) + 0.25 * *cspan_at(&command, 14));
return result;
}
following = 1e+300;
for (axis = 0; axis < 3; axis += 1) {
held = span_row(&operation, 6 + axis);
if (*cspan_at(&held, 2) > 0.5) {
renewed = *cspan_at(&held, 1) - 0.5 * *cspan_at(&command, 14);
following = span_min(following, *cspan_at(&progress, 0) + renewed);
}
}
return following;
}
static void write_variables(bool step, array_double_1d path, array_double_3d spots, array_double_3d links) {
int64_t axes, source, target, i, field, end;
axes = (int64_t)(*cspan_at(&path, 3));
source = 5;
target = 5;
if (step) {
source = 4;
target = 4;
}
for (i = 0; i < links.shape[0]; i += 1) {
for (field = 0; field < 2; field += 1) {
*cspan_at(&links, i, target, 1 + field) = *cspan_at(&spots, i, source, field);
end = 1 + 2 + field;
*cspan_at(&links, i, target, end) = *cspan_at(&spots, i + axes, source, field);
}
}
}
static int64_t unit_of(double* result_0_0001, int64_t* result_1_0001, int64_t column, int64_t order, array_double_1d track) {
int64_t field;
if (column == 0) {
(*result_0_0001) = 1.0;
(*result_1_0001) = 0;
return 0;
}
if (column >= 5) {
(*result_0_0001) = *cspan_at(&track, 50 + order - 1);
(*result_1_0001) = order;
return 0;
}
field = span_floor_mod((column - 1), 2);
(*result_0_0001) = *cspan_at(&track, 50 + field);
(*result_1_0001) = field + 1;
return 0;
}
static void write_scales(array_double_1d path, array_double_1d track, double time, array_double_2d link, array_double_2d square) {
int64_t order, j, power, k, derivative;
double duration, unit, whole;
order = (int64_t)(*cspan_at(&path, 0));
duration = exp(time);
for (j = 0; j < (int64_t)(5 + *cspan_at(&path, 1)); j += 1) {
unit_of(&unit, &power, j, order, track);
for (k = 0; k < power; k += 1) {
unit = unit * duration;
}
*cspan_at(&square, 1, j) = power;
*cspan_at(&square, 0, j) = unit;
*cspan_at(&square, 2, j) = *cspan_at(&link, 5, j) * unit;
}
whole = *cspan_at(&path, 8);
for (derivative = 0; derivative < order + 1; derivative += 1) {
*cspan_at(&square, 3, derivative) = *cspan_at(&link, 2, derivative) / whole;
whole = whole * duration;
}
}
static void write_node_shares(array_double_1d path, array_double_1d track, double time, array_double_2d link, array_double_2d grid, array_double_2d square) {
int64_t count, i, derivative, j;
double scale, total, where;
write_scales(path, track, time, link, square);
count = (int64_t)(5 + *cspan_at(&path, 1));
for (i = 0; i < (int64_t)(*cspan_at(&path, 2)); i += 1) {
derivative = (int64_t)(*cspan_at(&grid, i, 105));
*cspan_at(&grid, i, 106) = 0.0;
scale = *cspan_at(&square, 3, derivative);
if (scale > 0.0) {
total = 0.0;
for (j = 0; j < count; j += 1) {
total = total + *cspan_at(&grid, i, 0 + j) * *cspan_at(&square, 2, j);
}
where = *cspan_at(&link, 1, derivative) / *cspan_at(&path, 8);
*cspan_at(&grid, i, 106) = total * scale + where;
}
}
}
static double largest_node_share(array_double_1d path, array_double_2d tracks, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square) {
int64_t axes, i, axis, row;
double time, largest;
axes = (int64_t)(*cspan_at(&path, 3));
largest = 0.0;
for (i = 0; i < links.shape[0]; i += 1) {
axis = span_floor_mod(i, axes);
time = (*cspan_at(&spans, span_floor_div(i, axes), 2));
write_node_shares(path, span_row(&tracks, axis), time, span_matrix(&links, i), grid, square);
for (row = 0; row < (int64_t)(*cspan_at(&path, 2)); row += 1) {
largest = span_max(largest, fabs(*cspan_at(&grid, row, 106)));
}
}
return largest;
}
static double room_of(double share) {
if (!(fabs(share) < 1.0)) {
return 0.0;
}
return (1.0 - share) * (1.0 + share);
}
static double state_offset(array_double_2d spot, int64_t row, int64_t field, array_double_1d track) {
double middle, result;
middle = *cspan_at(&track, 54 + field) / *cspan_at(&track, 50 + field);
result = *cspan_at(&spot, row, field) - middle;
return result;
}
static double path_total(int64_t column, array_double_2d spans) {
int64_t i;
double total;
total = 0.0;
for (i = 0; i < spans.shape[0]; i += 1) {
total = total + exp(*cspan_at(&spans, i, column));
}
return total;
}
static double barrier_value(double theta, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square) {
int64_t axes, i, axis, field, row;
double room, share, time, total;
axes = (int64_t)(*cspan_at(&path, 3));
total = theta * path_total(2, spans);
for (i = 0; i < spots.shape[0]; i += 1) {
axis = span_floor_mod(i, axes);
room = 1.0;
for (field = 0; field < 2; field += 1) {
if (*cspan_at(&spots, i, 2, field) != 0.0) {
share = state_offset(span_matrix(&spots, i), 5, field, span_row(&tracks, axis));
room = room * room_of(share);
}
}
if (room <= 0.0) {
return 1e+300;
}
total = total - log(room);
}
for (i = 0; i < links.shape[0]; i += 1) {
axis = span_floor_mod(i, axes);
time = (*cspan_at(&spans, span_floor_div(i, axes), 2));
write_node_shares(path, span_row(&tracks, axis), time, span_matrix(&links, i), grid, square);
room = 1.0;
for (row = 0; row < (int64_t)(*cspan_at(&path, 2)); row += 1) {
room = room * room_of(*cspan_at(&grid, row, 106));
}
if (room <= 0.0) {
return 1e+300;
}
total = total - log(room);
}
return total;
}
static bool band_solve(array_double_2d band) {
int64_t width, i, j, k, step;
double total;
width = band.shape[1] - 1;
for (i = 0; i < band.shape[0]; i += 1) {
for (j = span_max_int(0, i - width + 1); j < i + 1; j += 1) {
total = *cspan_at(&band, i, i - j);
for (k = span_max_int(0, i - width + 1); k < j; k += 1) {
total = total - *cspan_at(&band, i, i - k) * *cspan_at(&band, j, j - k);
}
if (i == j) {
if (!(total > 0.0)) {
return 0;
}
*cspan_at(&band, i, 0) = sqrt(total);
}
else {
*cspan_at(&band, i, i - j) = total / *cspan_at(&band, j, 0);
}
}
}
for (i = 0; i < band.shape[0]; i += 1) {
total = *cspan_at(&band, i, width);
for (k = span_max_int(0, i - width + 1); k < i; k += 1) {
total = total - *cspan_at(&band, i, i - k) * *cspan_at(&band, k, width);
}
*cspan_at(&band, i, width) = total / *cspan_at(&band, i, 0);
}
for (step = 0; step < band.shape[0]; step += 1) {
i = band.shape[0] - 1 - step;
total = *cspan_at(&band, i, width);
for (k = i + 1; k < span_min_int(i + width, band.shape[0]); k += 1) {
total = total - *cspan_at(&band, k, k - i) * *cspan_at(&band, k, width);
}
*cspan_at(&band, i, width) = total / *cspan_at(&band, i, 0);
}
return 1;
}
static int64_t end_row(int64_t i, int64_t place, int64_t axes) {
int64_t spot;
spot = i + span_floor_div(place, 2) * axes;
return spot * 2 + span_floor_mod(place, 2);
}
static bool write_durations(double theta, array_double_1d path, array_double_3d links, array_double_2d spans) {
int64_t axes, j, axis, last;
double duration;
array_double_2d link;
axes = (int64_t)(*cspan_at(&path, 3));
for (j = 0; j < spans.shape[0]; j += 1) {
duration = theta * exp(*cspan_at(&spans, j, 2));
*cspan_at(&spans, j, 4) = duration;
*cspan_at(&spans, j, 3) = 2.0 * duration;
for (axis = 0; axis < axes; axis += 1) {
link = span_matrix(&links, j * axes + axis);
last = 8 + 4;
*cspan_at(&spans, j, 4) = *cspan_at(&spans, j, 4) + *cspan_at(&link, 7, 4);
*cspan_at(&spans, j, 3) = *cspan_at(&spans, j, 3) + *cspan_at(&link, last, 4);
}
if (!(*cspan_at(&spans, j, 3) > 0.0)) {
return 0;
}
}
return 1;
}
static void add_link(int64_t i, int64_t other, int64_t axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band) {
int64_t width, place, row, beside, column;
double pull, bend, own, slope, value;
width = band.shape[1] - 1;
pull = (*cspan_at(&spans, span_floor_div(i, axes), 4));
bend = (*cspan_at(&spans, span_floor_div(i, axes), 3));
for (place = 0; place < 4; place += 1) {
row = end_row(i, place, axes);
own = *cspan_at(&links, i, 8 + place, 4);
if ((*cspan_at(&spots, span_floor_div(row, 2), 2, span_floor_mod(row, 2))) == 0.0) {
continue;
}
if (other == i) {
slope = *cspan_at(&links, i, 7, place) - own * pull / bend;
*cspan_at(&band, row, width) = *cspan_at(&band, row, width) - slope;
}
for (beside = 0; beside < 4; beside += 1) {
column = end_row(other, beside, axes);
if ((*cspan_at(&spots, span_floor_div(column, 2), 2, span_floor_mod(column, 2))) == 0.0) {
continue;
}
if (column <= row) {
value = (-own) * *cspan_at(&links, other, 8 + beside, 4) / bend;
if (other == i) {
value = value + *cspan_at(&links, i, 8 + place, beside);
}
*cspan_at(&band, row, row - column) = *cspan_at(&band, row, row - column) + value;
}
}
}
}
static void write_band(array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band) {
int64_t axes, width, i, j, place, axis, field, other;
double share, inner;
axes = (int64_t)(*cspan_at(&path, 3));
width = band.shape[1] - 1;
for (i = 0; i < band.shape[0]; i += 1) {
for (j = 0; j < width + 1; j += 1) {
*cspan_at(&band, i, j) = 0.0;
}
place = span_floor_div(i, 2);
axis = span_floor_mod(place, axes);
field = span_floor_mod(i, 2);
*cspan_at(&band, i, 0) = 1.0;
if (*cspan_at(&spots, place, 2, field) != 0.0) {
share = state_offset(span_matrix(&spots, place), 5, field, span_row(&tracks, axis));
inner = (1.0 - share) * (1.0 + share);
*cspan_at(&band, i, 0) = 2.0 * (1.0 + share * share) / (inner * inner);
*cspan_at(&band, i, width) = (-2.0) * share / inner;
}
}
for (i = 0; i < links.shape[0]; i += 1) {
for (other = 0; other < axes; other += 1) {
add_link(i, i - span_floor_mod(i, axes) + other, axes, spots, links, spans, band);
}
}
}
static void write_components(int64_t count, array_double_2d link) {
int64_t i, place;
double step, change;
for (i = 0; i < 14 - 5; i += 1) {
step = 0.0;
if (i < count) {
step = -*cspan_at(&link, 13 + i, 5);
for (place = 0; place < 4; place += 1) {
change = *cspan_at(&link, 4, 1 + place);
step = step - *cspan_at(&link, 13 + i, place) * change;
}
step = step - *cspan_at(&link, 13 + i, 4) * *cspan_at(&link, 4, 14);
}
*cspan_at(&link, 4, 5 + i) = step;
}
}
static double write_steps(array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, double theta) {
int64_t axes, i, axis, field, j, place, end, column;
double promised, step, share, total;
array_double_2d link;
axes = (int64_t)(*cspan_at(&path, 3));
promised = 0.0;
for (i = 0; i < spots.shape[0]; i += 1) {
axis = span_floor_mod(i, axes);
for (field = 0; field < 2; field += 1) {
step = *cspan_at(&band, i * 2 + field, band.shape[1] - 1);
*cspan_at(&spots, i, 4, field) = step;
if (*cspan_at(&spots, i, 2, field) != 0.0) {
share = state_offset(span_matrix(&spots, i), 5, field, span_row(&tracks, axis));
promised = promised + 2.0 * share / ((1.0 - share) * (1.0 + share)) * step;
}
}
}
write_variables(1, path, spots, links);
for (j = 0; j < spans.shape[0]; j += 1) {
total = *cspan_at(&spans, j, 4);
for (axis = 0; axis < axes; axis += 1) {
link = span_matrix(&links, j * axes + axis);
for (place = 0; place < 4; place += 1) {
end = 1 + place;
total = total + *cspan_at(&link, 8 + place, 4) * *cspan_at(&link, 4, end);
}
}
*cspan_at(&spans, j, 1) = (-total) / *cspan_at(&spans, j, 3);
promised = promised + theta * exp(*cspan_at(&spans, j, 2)) * *cspan_at(&spans, j, 1);
}
for (i = 0; i < links.shape[0]; i += 1) {
*cspan_at(&links, i, 4, 14) = (*cspan_at(&spans, span_floor_div(i, axes), 1));
write_components((int64_t)(*cspan_at(&path, 1)), span_matrix(&links, i));
for (column = 1; column < 15; column += 1) {
promised = promised + *cspan_at(&links, i, 6, column) * *cspan_at(&links, i, 4, column);
}
}
return -promised;
}
static bool set_axes(array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_2d work) {
array_double_2d planner;
int64_t smoothness, shape, axis;
planner = span_rows(&work, 2, 242);
smoothness = (int64_t)(*cspan_at(&work, 0, 0));
shape = (int64_t)(*cspan_at(&work, 0, 1));
for (axis = 0; axis < axes.shape[0]; axis += 1) {
segfmu_axis_limits(smoothness, shape, span_row(&limits, axis), span_row(&axes, axis));
set_lower(span_row(&lower, axis), span_row(&axes, axis));
if (!segfmu_ramp_parameters(usual_share(span_row(&axes, axis)), span_row(&axes, axis), planner)) {
return 0;
}
}
return 1;
}
static bool plan_alone(int64_t place, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work) {
array_double_2d cell, planner;
int64_t status;
double duration;
cell = span_matrix(&cells, place * axes.shape[0] + axis);
planner = span_rows(&work, 2, 242);
set_shortest(&status, &duration, cell, span_row(&axes, axis), planner);
if (status < 0) {
return 0;
}
note_shortest(duration, span_row(&axes, axis), cell);
return 1;
}
static double shortest_of(int64_t place, int64_t axis, array_double_2d axes, array_double_3d cells) {
int64_t from_cell;
double result;
from_cell = place * axes.shape[0] + axis;
result = *cspan_at(&cells, from_cell, 67, 0);
return result;
}
static double least_length(int64_t place, array_double_2d axes, array_double_3d cells, array_double_2d work) {
int64_t axis;
double longest;
longest = 0.0;
for (axis = 0; axis < axes.shape[0]; axis += 1) {
if (!plan_alone(place, axis, axes, cells, work)) {
return 1e+300;
}
longest = span_max(longest, shortest_of(place, axis, axes, cells));
}
return longest;
}
static double common_length(int64_t place, double most, array_double_2d axes, array_double_3d cells, array_double_2d work) {
int64_t first;
array_double_2d planner;
double found;
first = place * axes.shape[0];
planner = span_rows(&work, 2, 242);
found = common_duration(0.0, most, 0.0, first, first + axes.shape[0], axes, cells, planner);
return found < 0.0 ? 1e+300 : found;
}
static double plan_lengths(array_double_3d states, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d work) {
double total;
int64_t j;
set_problems(states, cells);
total = 0.0;
for (j = 0; j < spans.shape[0]; j += 1) {
*cspan_at(&spans, j, 10) = least_length(j, axes, cells, work);
if (*cspan_at(&spans, j, 10) < 1e+300) {
*cspan_at(&spans, j, 10) = common_length(j, 1e+300, axes, cells, work);
}
total = total + *cspan_at(&spans, j, 10);
}
return span_min(total, 1e+300);
}
static double farthest_beyond(int64_t side, double low, double high, double first, array_double_2d cell, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
array_double_2d expansion, hulls;
int64_t count, row;
double length, known;
*cspan_at(&cell, 68, 0) = first;
*cspan_at(&cell, 68, 1) = 0.0;
expansion = span_rows(&work, 242, 246);
count = expand_cell(cell, axis, timing, coefficients, 0, expansion);
hulls = span_rows(&work, 2, 242);
known = 0.0;
for (row = 0; row < count; row += 1) {
write_room(side, row, 0.0, low, high, coefficients, hulls);
length = *cspan_at(&timing, row, 1);
known = greatest_lack(coefficients.shape[1], length, known, hulls);
}
return known;
}
static bool leaves_box(int64_t place, array_double_3d states, array_double_1d path, array_double_3d links, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
int64_t axis, i, side;
double low, high, first, beyond;
for (axis = 0; axis < axes.shape[0]; axis += 1) {
i = place * axes.shape[0] + axis;
low = *cspan_at(&links, i, 0, 0);
high = *cspan_at(&links, i, 0, 1);
first = *cspan_at(&states, place, axis, 0);
if (high - low < 1e+300) {
for (side = 0; side < 2; side += 1) {
beyond = farthest_beyond(side, low, high, first, span_matrix(&cells, i), span_row(&axes, axis), timing, coefficients, work);
if (beyond > *cspan_at(&path, 18)) {
return 1;
}
}
}
}
return 0;
}
static void copy_states(array_double_3d source, array_double_3d target) {
int64_t point, axis, i;
for (point = 0; point < source.shape[0]; point += 1) {
for (axis = 0; axis < source.shape[1]; axis += 1) {
for (i = 0; i < 3; i += 1) {
*cspan_at(&target, point, axis, i) = *cspan_at(&source, point, axis, i);
}
}
}
}
static int64_t offer_states(array_double_3d tried, array_double_3d best, array_double_1d path, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
double total;
int64_t j, count;
bool shorter, beyond, slow;
set_problems(tried, cells);
total = 0.0;
for (j = 0; j < spans.shape[0]; j += 1) {
*cspan_at(&spans, j, 10) = least_length(j, axes, cells, work);
total = total + *cspan_at(&spans, j, 10);
}
shorter = total < *cspan_at(&path, 13);
if (shorter) {
total = 0.0;
for (j = 0; j < spans.shape[0]; j += 1) {
*cspan_at(&spans, j, 10) = common_length(j, 1e+300, axes, cells, work);
total = total + *cspan_at(&spans, j, 10);
}
shorter = total < *cspan_at(&path, 13);
}
count = 0;
beyond = 0;
for (j = 0; j < spans.shape[0]; j += 1) {
slow = !(*cspan_at(&spans, j, 10) <= 1.005 * exp(*cspan_at(&spans, j, 0)));
if (shorter && leaves_box(j, tried, path, links, axes, cells, timing, coefficients, work)) {
slow = 1;
beyond = 1;
}
*cspan_at(&spans, j, 9) = slow;
if (slow) {
count = count + 1;
}
}
if (shorter && (!beyond)) {
*cspan_at(&path, 13) = total;
copy_states(tried, best);
}
return count;
}
static double extent(int64_t axis, array_double_3d given) {
double low, high;
int64_t point;
low = *cspan_at(&given, 0, axis, 0);
high = low;
for (point = 0; point < given.shape[0]; point += 1) {
low = span_min(low, *cspan_at(&given, point, axis, 0));
high = span_max(high, *cspan_at(&given, point, axis, 0));
}
return high - low;
}
static void write_boxes(double room, int64_t first, array_double_3d given, array_double_1d path, array_double_2d axes, array_double_3d links) {
int64_t count, i, point, axis, last;
double farthest, here, there, before, after, low, high, beyond, inwards;
count = (int64_t)(*cspan_at(&path, 3));
farthest = 0.0;
for (i = 0; i < links.shape[0]; i += 1) {
point = first + span_floor_div(i, count);
axis = span_floor_mod(i, count);
here = *cspan_at(&given, point, axis, 0);
there = *cspan_at(&given, point + 1, axis, 0);
farthest = span_max(farthest, fabs(there - here));
before = (*cspan_at(&given, span_max_int(point - 1, 0), axis, 0));
last = span_min_int(point + 2, given.shape[0] - 1);
after = *cspan_at(&given, last, axis, 0);
low = span_min(span_min(here, there), span_min(before, after));
high = span_max(span_max(here, there), span_max(before, after));
beyond = room < 1e+300 ? room * (high - low) : 1e+300;
inwards = 2.0 * 1e-09 * extent(axis, given);
low = span_max(low - beyond, *cspan_at(&axes, axis, 56) + inwards);
high = span_min(high + beyond, *cspan_at(&axes, axis, 56 + 1) - inwards);
*cspan_at(&links, i, 0, 0) = span_min(low, span_min(here, there));
*cspan_at(&links, i, 0, 1) = span_max(high, span_max(here, there));
}
for (i = 0; i < links.shape[0]; i += 1) {
*cspan_at(&links, i, 0, 2) = 1e-09 * farthest;
}
}
static bool admit_states(array_double_3d states, array_double_1d path, array_double_3d spots, array_double_3d links) {
int64_t count, i, axis, j, field;
bool inner, turns, fixed, admitted, found;
double here, low, high;
count = (int64_t)(*cspan_at(&path, 3));
found = 0;
for (i = 0; i < spots.shape[0]; i += 1) {
axis = span_floor_mod(i, count);
inner = (count <= i) && (i < spots.shape[0] - count);
turns = 0;
fixed = 0;
if (inner) {
here = (*cspan_at(&states, span_floor_div(i, count), axis, 0));
for (j = 0; j < 2; j += 1) {
low = *cspan_at(&links, i - j * count, 0, 0);
high = *cspan_at(&links, i - j * count, 0, 1);
turns = turns || (here == low) || (here == high);
fixed = fixed || (low == high);
}
}
for (field = 0; field < 2; field += 1) {
admitted = inner && (*cspan_at(&spots, i, 0, field) != 0.0);
if (field == 0) {
admitted = admitted && (!turns);
}
else {
admitted = admitted && (!fixed);
}
*cspan_at(&spots, i, 1, field) = admitted;
*cspan_at(&spots, i, 2, field) = admitted;
found = found || admitted;
}
}
return found;
}
static bool is_moving(array_double_3d states) {
int64_t point, axis, i;
for (point = 0; point < states.shape[0]; point += 1) {
for (axis = 0; axis < states.shape[1]; axis += 1) {
for (i = 1; i < 3; i += 1) {
if (*cspan_at(&states, point, axis, i) != 0.0) {
return 1;
}
}
}
}
return 0;
}
static void write_margin(array_double_1d path, array_double_3d links) {
double least, most, value;
int64_t i, edge;
least = 1e+300;
most = -1e+300;
for (i = 0; i < links.shape[0]; i += 1) {
for (edge = 0; edge < 2; edge += 1) {
value = *cspan_at(&links, i, 0, edge);
if (fabs(value) < 1e+300) {
least = span_min(least, value);
most = span_max(most, value);
}
}
}
*cspan_at(&path, 18) = most > least ? 1e-09 * (most - least) : 0.0;
}
static void widen_boxes(array_double_3d states, array_double_1d path, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
int64_t count, i, axis, side, edge;
bool planned;
double low, high, here, beyond;
count = (int64_t)(*cspan_at(&path, 3));
if (is_moving(states)) {
planned = plan_lengths(states, spans, axes, cells, work) < 1e+300;
for (i = 0; i < links.shape[0]; i += 1) {
axis = span_floor_mod(i, count);
low = *cspan_at(&links, i, 0, 0);
high = *cspan_at(&links, i, 0, 1);
here = (*cspan_at(&states, span_floor_div(i, count), axis, 0));
for (side = 0; side < 2; side += 1) {
beyond = 1e+300;
if (planned && (high - low < 1e+300)) {
beyond = farthest_beyond(side, low, high, here, span_matrix(&cells, i), span_row(&axes, axis), timing, coefficients, work);
}
edge = 1 - side;
*cspan_at(&links, i, 0, edge) = *cspan_at(&links, i, 0, edge) + (1.0 - 2.0 * side) * beyond;
}
}
}
write_margin(path, links);
}
static double power_over_factorial(double base, int64_t exponent) {
int64_t i;
double value;
if (exponent < 0) {
return 0.0;
}
value = 1.0;
for (i = 0; i < exponent; i += 1) {
value = value * base / (i + 1);
}
return value;
}
static double control_effect(int64_t order, int64_t derivative, int64_t cell, int64_t node) {
double count, begin;
if (node <= cell) {
return 0.0;
}
count = 12.0;
begin = power_over_factorial((node - cell) / count, order - derivative);
return begin - power_over_factorial((node - cell - 1) / count, order - derivative);
}
static double end_effect(int64_t derivative, int64_t column, double time) {
int64_t state;
state = column - 0;
if ((state == 1) || (state == 2)) {
return power_over_factorial(time, state - derivative);
}
return 0.0;
}
static bool is_required(int64_t derivative, int64_t column) {
if (derivative == 0) {
return column == 0;
}
return (derivative < 3) && (column == 1 + derivative + 1);
}
static void write_least_controls(int64_t order, int64_t first, array_double_2d grid, array_double_2d square) {
array_double_2d own, right;
int64_t i, j, cell;
double effect, total;
own = span_rows(&square, 6, 15);
right = span_rows(&square, 15, 24);
for (i = 0; i < order; i += 1) {
for (j = 0; j < order; j += 1) {
*cspan_at(&own, i, j) = 0.0;
for (cell = 0; cell < 12; cell += 1) {
effect = control_effect(order, i, cell, 12);
*cspan_at(&own, i, j) = *cspan_at(&own, i, j) + effect * control_effect(order, j, cell, 12);
}
}
for (j = 0; j < 5; j += 1) {
*cspan_at(&right, i, j) = -end_effect(i, j, 1.0);
if (is_required(i, j)) {
*cspan_at(&right, i, j) = *cspan_at(&right, i, j) + 1.0;
}
}
}
matrix_solve(order, 5, own, right);
for (cell = 0; cell < 12; cell += 1) {
for (j = 0; j < 5; j += 1) {
total = 0.0;
for (i = 0; i < order; i += 1) {
total = total + control_effect(order, i, cell, 12) * *cspan_at(&right, i, j);
}
*cspan_at(&grid, first + cell, 0 + j) = total;
}
}
}
static void project_out(int64_t unit, int64_t row, array_double_2d basis) {
double total;
int64_t cell;
total = 0.0;
for (cell = 0; cell < 12; cell += 1) {
total = total + *cspan_at(&basis, unit, cell) * *cspan_at(&basis, row, cell);
}
for (cell = 0; cell < 12; cell += 1) {
*cspan_at(&basis, row, cell) = *cspan_at(&basis, row, cell) - total * *cspan_at(&basis, unit, cell);
}
}
static void write_free_controls(int64_t order, int64_t first, array_double_2d grid, array_double_2d square) {
array_double_2d basis;
int64_t i, cell, k, sweep, other;
double value, norm;
basis = span_rows(&square, 24, 33);
for (i = 0; i < 12 - order; i += 1) {
for (cell = 0; cell < 12; cell += 1) {
*cspan_at(&basis, i, cell) = 0.0;
}
value = 1.0;
for (k = 0; k < order + 1; k += 1) {
*cspan_at(&basis, i, i + k) = value;
value = (-value) * (order - k) / (k + 1);
}
for (sweep = 0; sweep < 2; sweep += 1) {
for (other = 0; other < i; other += 1) {
project_out(other, i, basis);
}
}
norm = 0.0;
for (cell = 0; cell < 12; cell += 1) {
norm = norm + *cspan_at(&basis, i, cell) * *cspan_at(&basis, i, cell);
}
for (cell = 0; cell < 12; cell += 1) {
*cspan_at(&basis, i, cell) = *cspan_at(&basis, i, cell) / sqrt(norm);
value = *cspan_at(&basis, i, cell) * sqrt(12.0);
*cspan_at(&grid, first + cell, 0 + 5 + i) = value;
}
}
}
static void write_products(array_double_1d row) {
int64_t place, j, k;
place = 14;
for (j = 1; j < 14; j += 1) {
for (k = 1; k < j + 1; k += 1) {
*cspan_at(&row, place) = *cspan_at(&row, 0 + j) * *cspan_at(&row, 0 + k);
place = place + 1;
}
}
}
static void write_grid(int64_t order, array_double_2d grid, array_double_2d square) {
int64_t first, i, j, derivative, node, cell;
double total, effect;
first = order * 11;
for (i = 0; i < first + 12; i += 1) {
*cspan_at(&grid, i, 105) = span_min_int(span_floor_div(i, 11), order);
for (j = 0; j < 14; j += 1) {
*cspan_at(&grid, i, 0 + j) = 0.0;
}
}
write_least_controls(order, first, grid, square);
write_free_controls(order, first, grid, square);
for (i = 0; i < first; i += 1) {
derivative = span_floor_div(i, 11);
node = span_floor_mod(i, 11) + 1;
for (j = 0; j < 14; j += 1) {
total = end_effect(derivative, j, node / 12.0);
for (cell = 0; cell < node; cell += 1) {
effect = control_effect(order, derivative, cell, node);
total = total + effect * *cspan_at(&grid, first + cell, 0 + j);
}
*cspan_at(&grid, i, 0 + j) = total;
}
}
for (i = 0; i < first + 12; i += 1) {
write_products(span_row(&grid, i));
}
}
static int64_t row_change(double* result_0_0001, double* result_1_0001, int64_t row, int64_t count, array_double_2d grid, array_double_2d square) {
int64_t derivative, power, end, j, exponent;
double slope, bend, part, scale;
derivative = (int64_t)(*cspan_at(&grid, row, 105));
slope = 0.0;
bend = 0.0;
for (power = 0; power < 3; power += 1) {
part = 0.0;
if (power == 0) {
part = *cspan_at(&grid, row, 0) * *cspan_at(&square, 2, 0);
}
else {
for (end = 0; end < 2; end += 1) {
j = 1 + end * 2 + power - 1;
part = part + *cspan_at(&grid, row, 0 + j) * *cspan_at(&square, 2, j);
}
}
exponent = power - derivative;
slope = slope + part * exponent;
bend = bend + part * exponent * (exponent + 1);
}
part = 0.0;
for (j = 5; j < count; j += 1) {
part = part + *cspan_at(&grid, row, 0 + j) * *cspan_at(&square, 2, j);
}
exponent = (int64_t)(*cspan_at(&square, 1, 5)) - derivative;
slope = slope + part * exponent;
bend = bend + part * exponent * (exponent + 1);
scale = *cspan_at(&square, 3, derivative);
(*result_0_0001) = scale * slope;
(*result_1_0001) = scale * bend;
return 0;
}
static int64_t pair_place(int64_t one, int64_t other) {
int64_t row, place;
row = one - 1;
place = span_floor_div(row * (row + 1), 2);
return place + other - 1;
}
static double add_share(int64_t row, int64_t count, array_double_2d link, array_double_2d grid, array_double_2d square) {
int64_t derivative, j, place;
double slope, bend, share, inner, first, second, scale, pull, crossed, curve, by, added;
derivative = (int64_t)(*cspan_at(&grid, row, 105));
row_change(&slope, &bend, row, count, grid, square);
share = *cspan_at(&grid, row, 106);
inner = (1.0 - share) * (1.0 + share);
first = 2.0 * share / inner;
second = 2.0 * (1.0 + share * share) / (inner * inner);
scale = *cspan_at(&square, 3, derivative);
pull = first * scale;
crossed = (second * slope - first * derivative) * scale;
curve = second * scale * scale;
for (j = 1; j < count; j += 1) {
by = *cspan_at(&grid, row, 0 + j);
*cspan_at(&link, 6, j) = *cspan_at(&link, 6, j) + pull * by;
*cspan_at(&square, 5, j) = *cspan_at(&square, 5, j) + crossed * by;
}
for (place = 0; place < pair_place(count, 1); place += 1) {
added = curve * *cspan_at(&grid, row, 14 + place);
*cspan_at(&square, 4, place) = *cspan_at(&square, 4, place) + added;
}
*cspan_at(&link, 6, 14) = *cspan_at(&link, 6, 14) + first * slope;
*cspan_at(&square, 5, 14) = *cspan_at(&square, 5, 14) + first * bend;
return second * slope * slope;
}
static void give_units(int64_t count, array_double_2d link, array_double_2d square) {
int64_t place, j, k;
double unit, power, crossed, value;
place = 0;
for (j = 1; j < count; j += 1) {
unit = *cspan_at(&square, 0, j);
power = *cspan_at(&square, 1, j);
*cspan_at(&link, 6, j) = unit * *cspan_at(&link, 6, j);
crossed = unit * *cspan_at(&square, 5, j);
*cspan_at(&square, 5, j) = crossed + power * *cspan_at(&link, 6, j);
for (k = 1; k < j + 1; k += 1) {
value = unit * *cspan_at(&square, 0, k) * *cspan_at(&square, 4, place);
*cspan_at(&square, 4, place) = value;
place = place + 1;
}
}
}
static double hessian_entry(int64_t one, int64_t other, array_double_2d square) {
int64_t first, second;
double result;
first = span_max_int(one, other);
second = span_min_int(one, other);
if (first == 14) {
result = *cspan_at(&square, 5, second);
return result;
}
result = (*cspan_at(&square, 4, pair_place(first, second)));
return result;
}
static int64_t outer_column(int64_t place) {
return place == 4 ? 14 : (int64_t)(1 + place);
}
static void eliminate(int64_t count, array_double_2d link, array_double_2d square) {
array_double_2d own, coupled, solved;
int64_t i, j, column, k;
double slope, value;
own = span_rows(&square, 6, 15);
coupled = span_rows(&square, 15, 24);
solved = span_rows(&link, 13, 22);
for (i = 0; i < count; i += 1) {
for (j = 0; j < count; j += 1) {
*cspan_at(&own, i, j) = hessian_entry(5 + i, 5 + j, square);
}
for (j = 0; j < 5; j += 1) {
*cspan_at(&coupled, i, j) = hessian_entry(5 + i, outer_column(j), square);
*cspan_at(&solved, i, j) = *cspan_at(&coupled, i, j);
}
*cspan_at(&solved, i, 5) = *cspan_at(&link, 6, 5 + i);
}
matrix_solve(count, 6, own, solved);
for (j = 0; j < 5; j += 1) {
column = outer_column(j);
slope = *cspan_at(&link, 6, column);
for (i = 0; i < count; i += 1) {
slope = slope - *cspan_at(&coupled, i, j) * *cspan_at(&solved, i, 5);
}
*cspan_at(&link, 7, j) = slope;
for (k = 0; k < 5; k += 1) {
value = hessian_entry(column, outer_column(k), square);
for (i = 0; i < count; i += 1) {
value = value - *cspan_at(&coupled, i, j) * *cspan_at(&solved, i, k);
}
*cspan_at(&link, 8 + j, k) = value;
}
}
}
static void write_model(double ridge, array_double_1d path, array_double_1d track, double time, array_double_2d link, array_double_2d grid, array_double_2d square) {
int64_t j, place, count, i;
double curvature;
write_node_shares(path, track, time, link, grid, square);
for (j = 0; j < 15; j += 1) {
*cspan_at(&link, 6, j) = 0.0;
*cspan_at(&square, 5, j) = 0.0;
}
for (place = 0; place < 91; place += 1) {
*cspan_at(&square, 4, place) = 0.0;
}
count = (int64_t)(5 + *cspan_at(&path, 1));
curvature = 0.0;
for (i = 0; i < (int64_t)(*cspan_at(&path, 2)); i += 1) {
if ((*cspan_at(&link, 2, (int64_t)(*cspan_at(&grid, i, 105)))) > 0.0) {
curvature = curvature + add_share(i, count, link, grid, square);
}
}
give_units(count, link, square);
for (j = 1; j < 5; j += 1) {
place = pair_place(j, j);
*cspan_at(&square, 4, place) = (1.0 + ridge) * *cspan_at(&square, 4, place);
}
curvature = (1.0 + ridge) * curvature;
*cspan_at(&square, 5, 14) = curvature + *cspan_at(&square, 5, 14);
eliminate((int64_t)(*cspan_at(&path, 1)), link, square);
}
static double gap_of(int64_t point) {
return 0.03 * pow(3.1622776601683795, (double)((7 - point)));
}
static void try_move(double share, array_double_1d path, array_double_3d spots, array_double_3d links, array_double_2d spans) {
int64_t i, field, j;
double change;
for (i = 0; i < spots.shape[0]; i += 1) {
for (field = 0; field < 2; field += 1) {
change = share > 0.0 ? share * *cspan_at(&spots, i, 4, field) : 0.0;
*cspan_at(&spots, i, 5, field) = *cspan_at(&spots, i, 3, field) + change;
}
}
for (i = 0; i < links.shape[0]; i += 1) {
for (j = 0; j < 15; j += 1) {
change = share > 0.0 ? share * *cspan_at(&links, i, 4, j) : 0.0;
*cspan_at(&links, i, 5, j) = *cspan_at(&links, i, 3, j) + change;
}
*cspan_at(&links, i, 5, 0) = *cspan_at(&links, i, 3, 0);
}
for (j = 0; j < spans.shape[0]; j += 1) {
change = share > 0.0 ? -log(1.0 - share * *cspan_at(&spans, j, 1)) : 0.0;
*cspan_at(&spans, j, 2) = *cspan_at(&spans, j, 0) + change;
}
write_variables(0, path, spots, links);
}
static void take_tried(array_double_3d spots, array_double_3d links, array_double_2d spans) {
int64_t i, field, j;
for (i = 0; i < spots.shape[0]; i += 1) {
for (field = 0; field < 2; field += 1) {
*cspan_at(&spots, i, 3, field) = *cspan_at(&spots, i, 5, field);
}
}
for (i = 0; i < links.shape[0]; i += 1) {
for (j = 0; j < 15; j += 1) {
*cspan_at(&links, i, 3, j) = *cspan_at(&links, i, 5, j);
}
}
for (j = 0; j < spans.shape[0]; j += 1) {
*cspan_at(&spans, j, 0) = *cspan_at(&spans, j, 2);
}
}
static double write_step_of(double theta, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band) {
int64_t axes, attempt, i, axis;
double ridge, time, result;
axes = (int64_t)(*cspan_at(&path, 3));
ridge = 0.0;
for (attempt = 0; attempt < 100; attempt += 1) {
for (i = 0; i < links.shape[0]; i += 1) {
axis = span_floor_mod(i, axes);
time = (*cspan_at(&spans, span_floor_div(i, axes), 2));
write_model(ridge, path, span_row(&tracks, axis), time, span_matrix(&links, i), grid, square);
}
if (write_durations(theta, path, links, spans)) {
write_band(path, tracks, spots, links, spans, band);
if (band_solve(band)) {
result = write_steps(path, tracks, spots, links, spans, band, theta);
return result;
}
}
ridge = span_max(ridge / 0.1, 0.1);
}
return -1e+300;
}
static bool centre_path(double theta, double accuracy, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band) {
double value, decrease, longest, share, tried;
int64_t attempt, j;
try_move(0.0, path, spots, links, spans);
value = barrier_value(theta, path, tracks, spots, links, spans, grid, square);
for (attempt = 0; attempt < 30; attempt += 1) {
decrease = write_step_of(theta, path, tracks, spots, links, spans, grid, square, band);
if (!((-1e+300 < decrease) && (decrease < 1e+300))) {
return 0;
}
longest = 0.6;
for (j = 0; j < spans.shape[0]; j += 1) {
longest = span_max(longest, fabs(*cspan_at(&spans, j, 1)));
}
share = 0.6 / longest;
try_move(share, path, spots, links, spans);
tried = barrier_value(theta, path, tracks, spots, links, spans, grid, square);
while(!(tried <= value)) {
share = 0.5 * share;
if (share < 1e-07) {
return 0;
}
try_move(share, path, spots, links, spans);
tried = barrier_value(theta, path, tracks, spots, links, spans, grid, square);
}
take_tried(spots, links, spans);
value = tried;
if (decrease < accuracy) {
break;
}
}
return 1;
}
static void write_times(array_double_1d path, array_double_2d tracks, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square) {
int64_t axes, axis, j, k, row;
double least, reach, limit, distance, first, growth, fits, used;
array_double_2d link;
axes = (int64_t)(*cspan_at(&path, 3));
least = 0.0;
reach = 0.0;
for (axis = 0; axis < axes; axis += 1) {
limit = *cspan_at(&tracks, axis, 50);
least = span_max(least, limit / *cspan_at(&tracks, axis, 50 + 1));
for (j = 0; j < spans.shape[0]; j += 1) {
distance = *cspan_at(&links, j * axes + axis, 5, 0);
reach = span_max(reach, fabs(distance) / limit);
}
}
first = log(1.0 / 1000.0 * least);
growth = (log(1000.0 * (least + reach)) - first) / 24;
for (j = 0; j < spans.shape[0]; j += 1) {
fits = 1e+300;
for (k = 0; k < 24 + 1; k += 1) {
used = 0.0;
for (axis = 0; axis < axes; axis += 1) {
link = span_matrix(&links, j * axes + axis);
write_node_shares(path, span_row(&tracks, axis), first + growth * k, link, grid, square);
for (row = 0; row < (int64_t)(*cspan_at(&path, 2)); row += 1) {
if (*cspan_at(&grid, row, 105) != 0.0) {
used = span_max(used, fabs(*cspan_at(&grid, row, 106)));
}
}
}
if (used < fits) {
fits = used;
*cspan_at(&spans, j, 2) = first + growth * k;
}
if (used <= 0.5) {
break;
}
}
}
}
static bool retreat(array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band) {
int64_t attempt;
double theta, used;
for (attempt = 0; attempt < 100; attempt += 1) {
theta = *cspan_at(&path, 7) / (*cspan_at(&path, 9) * path_total(0, spans));
if (!centre_path(theta, 0.5, path, tracks, spots, links, spans, grid, square, band)) {
return 0;
}
try_move(0.0, path, spots, links, spans);
used = largest_node_share(path, tracks, links, spans, grid, square);
if (used > 1.0 - 0.001) {
return 0;
}
*cspan_at(&path, 8) = span_max(1.0, *cspan_at(&path, 8) * (used + 0.1 * (1.0 - used)));
if (*cspan_at(&path, 8) == 1.0) {
return 1;
}
}
return 0;
}
static bool begin_path(array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band) {
double used;
bool result;
*cspan_at(&path, 8) = 1.0;
write_variables(0, path, spots, links);
write_times(path, tracks, links, spans, grid, square);
used = largest_node_share(path, tracks, links, spans, grid, square);
take_tried(spots, links, spans);
if (used < 1.0) {
return 1;
}
*cspan_at(&path, 8) = 2.0 * used;
result = retreat(path, tracks, spots, links, spans, grid, square, band);
return result;
}
static double slow_path(double gap, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square) {
double before, value, total, theta, power;
int64_t attempt, i, field, j;
*cspan_at(&path, 8) = 1.0;
before = 1e+300;
for (attempt = 0; attempt < 100; attempt += 1) {
try_move(0.0, path, spots, links, spans);
value = barrier_value(0.0, path, tracks, spots, links, spans, grid, square);
total = path_total(0, spans);
if (before < 1e+300) {
theta = (before - value) / (total * (1.0 - 1.0 / 1.02));
if (theta * gap * total <= *cspan_at(&path, 7)) {
return 3.1622776601683795 * theta;
}
}
before = value;
for (i = 0; i < spots.shape[0]; i += 1) {
for (field = 0; field < 2; field += 1) {
*cspan_at(&spots, i, 3, field) = *cspan_at(&spots, i, 3, field) / pow(1.02, (double)((field + 1)));
}
}
power = pow(1.02, (double)((int64_t)(*cspan_at(&path, 0))));
for (i = 0; i < links.shape[0]; i += 1) {
for (j = 5; j < 14; j += 1) {
*cspan_at(&links, i, 3, j) = *cspan_at(&links, i, 3, j) / power;
}
}
for (j = 0; j < spans.shape[0]; j += 1) {
*cspan_at(&spans, j, 0) = *cspan_at(&spans, j, 0) + log(1.02);
}
}
return -1.0;
}
static double follow_path(double theta, double gap, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d grid, array_double_2d square, array_double_2d band) {
double reached, accuracy;
reached = 1e+300;
while(reached > 1.05 * gap) {
accuracy = 0.5;
if (*cspan_at(&path, 7) > 1.05 * gap * theta * path_total(0, spans)) {
accuracy = 20.0;
}
if (!centre_path(theta, accuracy, path, tracks, spots, links, spans, grid, square, band)) {
return -1.0;
}
reached = *cspan_at(&path, 7) / (theta * path_total(0, spans));
theta = theta * span_min(3.1622776601683795, span_max(1.0, reached / gap));
}
return theta;
}
static double limit_of(int64_t place, int64_t axis, array_double_2d limits) {
double result;
if (place < limits.shape[1]) {
if (*cspan_at(&limits, axis, place) > 0.0) {
result = span_min(*cspan_at(&limits, axis, place), 1e+300);
return result;
}
}
return 1e+300;
}
static void write_tracks(array_double_2d limits, array_double_2d lower, array_double_1d path, array_double_2d tracks) {
int64_t axis, field;
double half, acceleration, jerk, snap, crackle, pop;
*cspan_at(&path, 0) = 3.0;
for (axis = 0; axis < limits.shape[0]; axis += 1) {
for (field = 0; field < 2; field += 1) {
half = 0.5 * (*cspan_at(&limits, axis, field) + *cspan_at(&lower, axis, field));
*cspan_at(&tracks, axis, 50 + field) = half;
*cspan_at(&tracks, axis, 54 + field) = *cspan_at(&limits, axis, field) - half;
}
acceleration = *cspan_at(&tracks, axis, 50 + 1);
jerk = limit_of(2, axis, limits);
snap = limit_of(3, axis, limits);
crackle = limit_of(4, axis, limits);
if (crackle < 1e+300) {
snap = span_min(snap, pow((crackle * crackle * acceleration), (1.0 / 3.0)));
}
pop = limit_of(5, axis, limits);
if (pop < 1e+300) {
snap = span_min(snap, sqrt(pop * acceleration));
}
if (snap < 1e+300) {
*cspan_at(&path, 0) = 4.0;
}
if (jerk < 1e+300) {
snap = span_min(snap, 10.0 * jerk * jerk / acceleration);
}
*cspan_at(&tracks, axis, 52) = jerk;
*cspan_at(&tracks, axis, 53) = snap;
}
*cspan_at(&path, 1) = 12 - *cspan_at(&path, 0);
*cspan_at(&path, 2) = *cspan_at(&path, 0) * 11 + 12;
}
static double limit_share(int64_t order, double degree, bool smoothstep) {
double share;
share = 1.0;
if (order == 3) {
share = pow(0.93, degree);
if (smoothstep) {
share = 0.6 * share;
}
}
else if (order == 4) {
share = pow(0.75, degree);
if (smoothstep) {
share = 0.5 * share;
}
}
return share;
}
static void write_box_scale(double first, array_double_2d link) {
double half, middle;
half = 0.5 * (*cspan_at(&link, 0, 1) - *cspan_at(&link, 0, 0));
*cspan_at(&link, 2, 0) = 0.0;
*cspan_at(&link, 1, 0) = 0.0;
if (half < 1e+300) {
half = span_max(half, *cspan_at(&link, 0, 2));
*cspan_at(&link, 2, 0) = 1.0 / half;
middle = 0.5 * (*cspan_at(&link, 0, 0) + *cspan_at(&link, 0, 1));
*cspan_at(&link, 1, 0) = (first - middle) / half;
}
}
static void write_scales_of(bool smoothstep, array_double_3d given, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d links, array_double_2d spans) {
int64_t count, i, field, axis, j, order;
double state, first, last, limit, share;
count = (int64_t)(*cspan_at(&path, 3));
*cspan_at(&path, 7) = *cspan_at(&path, 2) * links.shape[0];
for (i = 0; i < spots.shape[0]; i += 1) {
for (field = 0; field < 2; field += 1) {
state = (*cspan_at(&given, span_floor_div(i, count), span_floor_mod(i, count), 1 + field));
*cspan_at(&spots, i, 5, field) = state / (*cspan_at(&tracks, span_floor_mod(i, count), 50 + field));
if (*cspan_at(&spots, i, 2, field) != 0.0) {
*cspan_at(&spots, i, 5, field) = 0.0;
*cspan_at(&path, 7) = *cspan_at(&path, 7) + 1.0;
}
}
}
for (i = 0; i < links.shape[0]; i += 1) {
axis = span_floor_mod(i, count);
first = (*cspan_at(&given, span_floor_div(i, count), axis, 0));
for (j = 0; j < 15; j += 1) {
*cspan_at(&links, i, 5, j) = 0.0;
}
last = (*cspan_at(&given, span_floor_div(i, count) + 1, axis, 0));
*cspan_at(&links, i, 5, 0) = last - first;
write_box_scale(first, span_matrix(&links, i));
for (order = 1; order < (int64_t)(*cspan_at(&path, 0)) + 1; order += 1) {
limit = *cspan_at(&tracks, axis, 50 + order - 1);
share = limit_share(order, (*cspan_at(&spans, span_floor_div(i, count), 5)), smoothstep);
*cspan_at(&links, i, 2, order) = 0.0;
*cspan_at(&links, i, 1, order) = 0.0;
if (limit < 1e+300) {
*cspan_at(&links, i, 2, order) = 1.0 / (limit * share);
}
if (order < 3) {
*cspan_at(&links, i, 1, order) = (-*cspan_at(&tracks, axis, 54 + order - 1)) / limit;
}
}
}
}
static double highest_state(int64_t field, double limit) {
if (field == 1) {
return limit * (1.0 - 1.0 / 65536.0);
}
return limit;
}
static void write_tried(array_double_3d given, array_double_1d path, array_double_2d tracks, array_double_3d spots, array_double_3d tried) {
int64_t count, i, point, axis, k, field;
double share, digits, state, high, low;
count = (int64_t)(*cspan_at(&path, 3));
for (i = 0; i < spots.shape[0]; i += 1) {
point = span_floor_div(i, count);
axis = span_floor_mod(i, count);
for (k = 0; k < 3; k += 1) {
*cspan_at(&tried, point, axis, k) = *cspan_at(&given, point, axis, k);
}
for (field = 0; field < 2; field += 1) {
if (*cspan_at(&spots, i, 2, field) != 0.0) {
share = *cspan_at(&spots, i, 3, field);
digits = (int64_t)floor(65536.0 * fabs(share) + 0.5) / 65536.0;
if (share < 0.0) {
digits = -digits;
}
state = digits * *cspan_at(&tracks, axis, 50 + field);
high = highest_state(field, *cspan_at(&tracks, axis, 2 + field));
low = -highest_state(field, *cspan_at(&tracks, axis, 9 + field));
state = span_min(span_max(state, low), high);
*cspan_at(&tried, point, axis, 1 + field) = state;
}
}
}
}
static bool may_beat(double known, int64_t place, double total) {
return total <= (1.0 + 1.05 * gap_of(place)) * known;
}
static int64_t block_rows(int64_t* result_0_0001, int64_t* result_1_0001, int64_t block, array_double_1d path, array_double_3d choice) {
int64_t begin;
begin = block * (span_floor_div(choice.shape[0], 5));
(*result_0_0001) = begin + (int64_t)(*cspan_at(&path, 5));
(*result_1_0001) = begin + (int64_t)(*cspan_at(&path, 6)) + 1;
return 0;
}
static bool try_path(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
array_double_1d path;
array_double_2d grid, square;
int64_t begin, end, offered, first, fewest, place, slow, j;
array_double_3d given, tried, best;
bool smoothstep, hopeful, last, result;
double theta;
path = span_row(&tools, 0);
grid = span_rows(&tools, 1, 57);
square = span_rows(&tools, 57, 90);
block_rows(&begin, &end, 0, path, choice);
given = span_layers(&choice, begin, end);
block_rows(&begin, &end, 3, path, choice);
tried = span_layers(&choice, begin, end);
block_rows(&begin, &end, (int64_t)(*cspan_at(&path, 15)), path, choice);
best = span_layers(&choice, begin, end);
smoothstep = (int64_t)(*cspan_at(&work, 0, 1)) == 0;
write_scales_of(smoothstep, given, path, axes, spots, links, spans);
offered = is_moving(given) ? 5 : 7;
first = 5;
if (*cspan_at(&path, 10) != 0.0) {
first = 7;
theta = slow_path(gap_of(6), path, axes, spots, links, spans, grid, square);
if (theta < 0.0) {
return 0;
}
}
else if (begin_path(path, axes, spots, links, spans, grid, square, band)) {
theta = *cspan_at(&path, 7) / (*cspan_at(&path, 9) * path_total(0, spans));
}
else {
return 0;
}
fewest = spans.shape[0] + 1;
for (place = first; place < 7 + 1; place += 1) {
theta = follow_path(theta, gap_of(place), path, axes, spots, links, spans, grid, square, band);
if (theta < 0.0) {
break;
}
*cspan_at(&path, 11) = path_total(0, spans);
hopeful = may_beat(span_min(*cspan_at(&path, 13), *cspan_at(&path, 14)), place, *cspan_at(&path, 11));
last = (place == 7) && may_beat(*cspan_at(&path, 14), place, *cspan_at(&path, 11));
if (!(hopeful || last)) {
return 0;
}
if (place < offered) {
continue;
}
write_tried(given, path, axes, spots, tried);
slow = offer_states(tried, best, path, links, spans, axes, cells, timing, coefficients, work);
if (slow < fewest) {
fewest = slow;
for (j = 0; j < spans.shape[0]; j += 1) {
*cspan_at(&spans, j, 8) = *cspan_at(&spans, j, 9);
}
}
if (!hopeful) {
return 0;
}
}
result = fewest <= spans.shape[0];
return result;
}
static bool tighten_path(bool everywhere, array_double_2d spans) {
bool any_slow, retried, changed;
int64_t j;
double degree, failed;
any_slow = 0;
for (j = 0; j < spans.shape[0]; j += 1) {
if (everywhere) {
*cspan_at(&spans, j, 8) = 1.0;
}
if (*cspan_at(&spans, j, 8) != 0.0) {
any_slow = 1;
degree = *cspan_at(&spans, j, 5);
*cspan_at(&spans, j, 6) = span_max(*cspan_at(&spans, j, 6), degree);
}
}
changed = 0;
for (j = 0; j < spans.shape[0]; j += 1) {
failed = *cspan_at(&spans, j, 6);
if (!any_slow) {
*cspan_at(&spans, j, 7) = *cspan_at(&spans, j, 5);
}
retried = *cspan_at(&spans, j, 8) != 0.0;
if (!any_slow) {
retried = (failed >= 0.0) && (*cspan_at(&spans, j, 7) - failed > 0.4);
}
if (retried) {
changed = 1;
*cspan_at(&spans, j, 5) = 0.5 + 1.4 * failed;
if (*cspan_at(&spans, j, 7) < 1e+300) {
*cspan_at(&spans, j, 5) = 0.5 * (failed + *cspan_at(&spans, j, 7));
}
}
}
return changed;
}
static void search_states(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
array_double_1d path;
int64_t j, begin, end, sweep;
bool resting, going_on;
double known;
path = span_row(&tools, 0);
for (j = 0; j < spans.shape[0]; j += 1) {
*cspan_at(&spans, j, 5) = 0.0;
*cspan_at(&spans, j, 6) = -1.0;
*cspan_at(&spans, j, 7) = 1e+300;
}
*cspan_at(&path, 10) = 0.0;
*cspan_at(&path, 11) = 1e+300;
block_rows(&begin, &end, 0, path, choice);
resting = !is_moving(span_layers(&choice, begin, end));
known = *cspan_at(&path, 13);
for (sweep = 0; sweep < 10; sweep += 1) {
going_on = try_path(choice, tools, axes, spots, links, spans, band, cells, timing, coefficients, work);
if (sweep == 0) {
*cspan_at(&path, 12) = span_min(*cspan_at(&path, 12), *cspan_at(&path, 11));
}
if (!going_on) {
return;
}
if (!tighten_path((sweep > span_floor_div(10, 2)) && (*cspan_at(&path, 13) >= known), spans)) {
return;
}
*cspan_at(&path, 10) = resting;
}
}
static void keep_cells(int64_t point, int64_t axis, bool back, array_double_2d axes, array_double_3d cells, array_double_3d links) {
int64_t place, i;
for (place = point - 1; place < point + 1; place += 1) {
i = place * axes.shape[0] + axis;
if (back) {
*cspan_at(&cells, i, 67, 0) = *cspan_at(&links, i, 22, 0);
*cspan_at(&cells, i, 67, 6) = *cspan_at(&links, i, 22, 1);
}
else {
*cspan_at(&links, i, 22, 0) = *cspan_at(&cells, i, 67, 0);
*cspan_at(&links, i, 22, 1) = *cspan_at(&cells, i, 67, 6);
}
}
}
static void forget_profiles(int64_t point, int64_t axis, array_double_2d axes, array_double_3d cells) {
int64_t place;
for (place = point - 1; place < point + 1; place += 1) {
*cspan_at(&cells, place * axes.shape[0] + axis, 67, 4) = 1.0;
}
}
static void set_state(double value, int64_t point, int64_t axis, int64_t field, array_double_3d states, array_double_2d axes, array_double_3d cells) {
int64_t count, first;
*cspan_at(&states, point, axis, 1 + field) = value;
count = axes.shape[0];
first = (point - 1) * count;
set_problems(span_layers(&states, point - 1, point + 2), span_layers(&cells, first, first + 2 * count));
}
static double longest_of(int64_t place, int64_t without, array_double_2d axes, array_double_3d cells) {
int64_t other;
double longest;
longest = 0.0;
for (other = 0; other < axes.shape[0]; other += 1) {
if (other != without) {
longest = span_max(longest, shortest_of(place, other, axes, cells));
}
}
return longest;
}
static double tried_length(int64_t point, int64_t axis, array_double_3d states, array_double_1d path, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
double least, others, shortest, most, found, result;
int64_t place;
least = 0.0;
for (place = point - 1; place < point + 1; place += 1) {
least = least + longest_of(place, axis, axes, cells);
}
for (place = point - 1; place < point + 1; place += 1) {
if (!(least < *cspan_at(&path, 14))) {
return 1e+300;
}
if (!plan_alone(place, axis, axes, cells, work)) {
return 1e+300;
}
others = longest_of(place, axis, axes, cells);
least = least + span_max(shortest_of(place, axis, axes, cells) - others, 0.0);
}
for (place = point - 1; place < point + 1; place += 1) {
shortest = span_max(longest_of(place, axis, axes, cells), shortest_of(place, axis, axes, cells));
most = *cspan_at(&path, 14) - (least - shortest);
found = common_length(place, most, axes, cells, work);
if (found >= 1e+300) {
return 1e+300;
}
*cspan_at(&spans, place, 11) = found;
least = least + (found - shortest);
}
for (place = point - 1; place < point + 1; place += 1) {
if (leaves_box(place, states, path, links, axes, cells, timing, coefficients, work)) {
return 1e+300;
}
}
result = *cspan_at(&spans, point - 1, 11) + *cspan_at(&spans, point, 11);
return result;
}
static void polish_state(int64_t spot, int64_t field, array_double_3d states, array_double_1d path, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
int64_t point, axis, trial, place;
double high, low, least, move, before, here, value, found;
point = span_floor_div(spot, axes.shape[0]);
axis = span_floor_mod(spot, axes.shape[0]);
high = highest_state(field, *cspan_at(&axes, axis, 2 + field));
low = -highest_state(field, *cspan_at(&axes, axis, 9 + field));
least = *cspan_at(&spans, point - 1, 10) + *cspan_at(&spans, point, 10);
move = *cspan_at(&path, 16) * 0.5 * (high - low);
before = 1e+300;
for (trial = 0; trial < 100; trial += 1) {
here = *cspan_at(&states, point, axis, 1 + field);
value = span_min(span_max(here + move, low), high);
keep_cells(point, axis, 0, axes, cells, links);
set_state(value, point, axis, field, states, axes, cells);
*cspan_at(&path, 14) = least / 1.000001;
found = tried_length(point, axis, states, path, links, spans, axes, cells, timing, coefficients, work);
if ((trial > 1) && (found < 1e+300)) {
least = found;
for (place = point - 1; place < point + 1; place += 1) {
*cspan_at(&spans, place, 10) = *cspan_at(&spans, place, 11);
}
continue;
}
set_state(here, point, axis, field, states, axes, cells);
keep_cells(point, axis, 1, axes, cells, links);
forget_profiles(point, axis, axes, cells);
if (trial > 1) {
return;
}
if (trial == 0) {
before = found;
move = -move;
}
else if ((before >= 1e+300) && (found >= 1e+300)) {
return;
}
else if (before <= found) {
move = -move;
}
}
}
static bool runs_backwards(array_double_2d spans) {
int64_t count, j;
double longest, ahead;
count = spans.shape[0];
longest = 0.0;
for (j = 0; j < count; j += 1) {
longest = span_max(longest, *cspan_at(&spans, j, 10));
}
for (j = 0; j < count; j += 1) {
ahead = *cspan_at(&spans, j, 10) - *cspan_at(&spans, count - 1 - j, 10);
if (fabs(ahead) > (1.000001 - 1.0) * longest) {
return ahead < 0.0;
}
}
return 0;
}
static double polish_states(array_double_3d states, array_double_1d path, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
int64_t count, last, axis, sweep, k, point, spot, field, j;
bool backwards;
double total;
count = axes.shape[0];
last = states.shape[0] - 1;
plan_lengths(states, spans, axes, cells, work);
for (axis = 0; axis < count; axis += 1) {
*cspan_at(&axes, axis, 12) = 1;
}
*cspan_at(&path, 16) = 0.03;
for (sweep = 0; sweep < 3; sweep += 1) {
backwards = runs_backwards(spans);
for (k = 1; k < last; k += 1) {
point = backwards ? last - k : k;
for (spot = point * count; spot < (point + 1) * count; spot += 1) {
for (field = 0; field < 2; field += 1) {
if (*cspan_at(&spots, spot, 2, field) != 0.0) {
polish_state(spot, field, states, path, links, spans, axes, cells, timing, coefficients, work);
}
}
}
}
*cspan_at(&path, 16) = *cspan_at(&path, 16) / 3.1622776601683795;
}
for (axis = 0; axis < count; axis += 1) {
*cspan_at(&axes, axis, 12) = 0;
}
total = 0.0;
for (j = 0; j < spans.shape[0]; j += 1) {
total = total + *cspan_at(&spans, j, 10);
}
return total;
}
static double few_digits(double value) {
double shifted;
if (!(fabs(value) < 1e+300)) {
return value;
}
shifted = 524289.0 * value;
return shifted - (shifted - value);
}
static void measure_states(int64_t axis, int64_t places, double slowest, array_double_3d choice, array_double_1d track) {
double length, before, position, here, state;
int64_t point, field;
length = *cspan_at(&track, 58) * *cspan_at(&track, 58) / *cspan_at(&track, 58 + 1);
before = *cspan_at(&choice, 0, axis, 0);
position = 0.0;
for (point = 0; point < places; point += 1) {
here = *cspan_at(&choice, point, axis, 0);
position = position + few_digits((here - before) / length);
before = here;
*cspan_at(&choice, point, axis, 0) = position;
for (field = 0; field < 2; field += 1) {
state = *cspan_at(&choice, point, axis, 1 + field) / *cspan_at(&track, 58 + field);
state = few_digits(state);
if (field == 0) {
state = span_min(span_max(state, -slowest), 1.0);
}
*cspan_at(&choice, point, axis, 1 + field) = state;
}
}
}
static void take_units(int64_t places, array_double_3d choice, array_double_2d limits, array_double_2d lower, array_double_2d axes) {
double time, speed, length, first, edge, unit;
int64_t axis, side, order;
time = *cspan_at(&limits, 0, 0) / *cspan_at(&limits, 0, 1);
for (axis = 0; axis < axes.shape[0]; axis += 1) {
speed = *cspan_at(&limits, axis, 0);
length = speed * time;
*cspan_at(&axes, axis, 58) = speed;
*cspan_at(&axes, axis, 58 + 1) = speed / time;
first = *cspan_at(&choice, 0, axis, 0);
for (side = 0; side < 2; side += 1) {
edge = *cspan_at(&axes, axis, 56 + side);
if (fabs(edge) < 1e+300) {
*cspan_at(&axes, axis, 56 + side) = few_digits((edge - first) / length);
}
}
*cspan_at(&lower, axis, 0) = *cspan_at(&lower, axis, 0) / speed;
*cspan_at(&lower, axis, 1) = few_digits(*cspan_at(&lower, axis, 1) / *cspan_at(&axes, axis, 58 + 1));
unit = length;
for (order = 0; order < limits.shape[1]; order += 1) {
unit = unit / time;
if (*cspan_at(&limits, axis, order) < 1e+300) {
*cspan_at(&limits, axis, order) = few_digits(*cspan_at(&limits, axis, order) / unit);
}
}
measure_states(axis, places, *cspan_at(&lower, axis, 0), choice, span_row(&axes, axis));
}
}
static void return_states(int64_t point, array_double_3d choice, array_double_2d axes) {
int64_t axis, field;
double state;
for (axis = 0; axis < axes.shape[0]; axis += 1) {
for (field = 0; field < 2; field += 1) {
state = *cspan_at(&choice, point, axis, 1 + field);
if (state != 0.0) {
state = state * *cspan_at(&axes, axis, 58 + field);
}
*cspan_at(&choice, point, axis, 1 + field) = state;
}
}
}
static void restore_given(array_double_2d given, array_double_2d found) {
int64_t axis, i;
for (axis = 0; axis < found.shape[0]; axis += 1) {
for (i = 0; i < 3; i += 1) {
if (!is_free(*cspan_at(&given, axis, i))) {
*cspan_at(&found, axis, i) = *cspan_at(&given, axis, i);
}
}
}
}
static int64_t check_limits(array_double_2d limits, array_double_1d report) {
int64_t axis, order;
for (axis = 0; axis < limits.shape[0]; axis += 1) {
*cspan_at(&report, 0) = axis;
for (order = 0; order < limits.shape[1]; order += 1) {
*cspan_at(&report, 2) = *cspan_at(&limits, axis, order);
if ((order < 2) && (!(*cspan_at(&limits, axis, order) > 0.0))) {
return (-14) - order;
}
if (!(*cspan_at(&limits, axis, order) >= 0.0)) {
return -11;
}
}
}
return 0;
}
static bool is_real(double value) {
return value - value == 0.0;
}
static int64_t check_numbers(array_double_3d states, array_double_2d limits, array_double_1d report) {
int64_t j, axis, i;
double value;
for (j = 0; j < states.shape[0]; j += 1) {
*cspan_at(&report, 1) = j;
for (axis = 0; axis < states.shape[1]; axis += 1) {
*cspan_at(&report, 0) = axis;
for (i = 0; i < 3; i += 1) {
value = *cspan_at(&states, j, axis, i);
if (is_real(value)) {
continue;
}
*cspan_at(&report, 2) = value;
if (i == 0) {
return -11;
}
*cspan_at(&report, 3) = *cspan_at(&limits, axis, i - 1);
return (-7) + 1 - i;
}
}
}
return 0;
}
int64_t segfmu_check_problem(array_double_3d states, array_double_2d limits, array_double_1d report) {
int64_t status;
status = check_limits(limits, report);
if (status == 0) {
status = check_numbers(states, limits, report);
}
return status;
}
static double change_time(double size, int64_t derivative, array_double_1d limits) {
int64_t i;
double longest;
longest = 0.0;
for (i = derivative; i < limits.shape[0]; i += 1) {
if (*cspan_at(&limits, i) > 0.0) {
longest = span_max(longest, pow((size / *cspan_at(&limits, i)), (1.0 / (i - derivative + 1))));
}
}
return longest;
}
static int64_t axis_scale(double* result_0, double* result_1_0001, int64_t axis, array_double_3d states, array_double_1d limits) {
double distance, velocity, acceleration, position, before, value;
int64_t j;
distance = 0.0;
velocity = 0.0;
acceleration = 0.0;
for (j = 0; j < states.shape[0]; j += 1) {
if (j > 0) {
position = *cspan_at(&states, j, axis, 0);
before = *cspan_at(&states, j - 1, axis, 0);
distance = span_max(distance, fabs(position - before));
}
value = fabs(*cspan_at(&states, j, axis, 1));
if (value > velocity) {
velocity = value;
}
value = fabs(*cspan_at(&states, j, axis, 2));
if (value > acceleration) {
acceleration = value;
}
}
velocity = span_max(velocity, acceleration * change_time(acceleration, 2, limits));
if (distance > 0.0) {
velocity = span_max(velocity, distance / change_time(distance, 0, limits));
}
velocity = span_min(velocity, *cspan_at(&limits, 0));
if (velocity > 0.0) {
acceleration = span_max(acceleration, velocity / change_time(velocity, 1, limits));
}
(*result_0) = velocity;
(*result_1_0001) = span_min(acceleration, *cspan_at(&limits, 1));
return 0;
}
double segfmu_motion_scale(int64_t order, array_double_3d states, array_double_2d limits) {
int64_t axis;
double velocity, acceleration, largest;
largest = 0.0;
for (axis = 0; axis < states.shape[1]; axis += 1) {
axis_scale(&velocity, &acceleration, axis, states, span_row(&limits, axis));
if (order == 1) {
velocity = acceleration;
}
largest = span_max(largest, velocity);
}
return largest;
}
static double settle_value(double value, int64_t order, int64_t axis, array_double_3d states, array_double_2d limits, array_double_2d lower) {
double limit;
limit = (value < 0.0) && (*cspan_at(&lower, axis, order) > 0.0) ? *cspan_at(&lower, axis, order) : *cspan_at(&limits, axis, order);
if ((fabs(value) <= 1e-09 * limit) && (fabs(value) <= 1e-09 * segfmu_motion_scale(order, states, limits))) {
return 0.0;
}
if (fabs(fabs(value) - limit) <= 1e-09 * limit) {
return value > 0.0 ? limit : -limit;
}
return value;
}
static bool differ(double before, double value) {
return !(is_real(value) && (fabs(value - before) <= 2e-15 * span_max(fabs(value), 1.0)));
}
static bool is_same(array_double_2d before, array_double_2d state) {
int64_t axis, i;
for (axis = 0; axis < state.shape[0]; axis += 1) {
for (i = 0; i < state.shape[1]; i += 1) {
if (differ(*cspan_at(&before, axis, i), *cspan_at(&state, axis, i))) {
return 0;
}
}
}
return 1;
}
int64_t segfmu_settle_states(int64_t first, array_double_3d states, array_double_2d limits, array_double_2d lower) {
int64_t j, axis, i, changed;
double given, settled, before;
changed = 0;
for (j = first; j < states.shape[0]; j += 1) {
for (axis = 0; axis < states.shape[1]; axis += 1) {
for (i = 0; i < 2; i += 1) {
given = *cspan_at(&states, j, axis, 1 + i);
settled = given;
if (given != 0.0) {
settled = settle_value(given, i, axis, states, limits, lower);
}
if (j > first) {
before = *cspan_at(&states, j - 1, axis, 1 + i);
if (fabs(settled - before) <= 2e-15 * fabs(before)) {
settled = before;
}
}
if (fabs(settled - given) > 0.0) {
*cspan_at(&states, j, axis, 1 + i) = settled;
changed = changed + 1;
}
}
}
if ((j > first) && is_same(span_matrix(&states, j - 1), span_matrix(&states, j))) {
for (axis = 0; axis < states.shape[1]; axis += 1) {
before = *cspan_at(&states, j - 1, axis, 0);
if (fabs(*cspan_at(&states, j, axis, 0) - before) > 0.0) {
*cspan_at(&states, j, axis, 0) = before;
changed = changed + 1;
}
}
}
}
return changed;
}
int64_t segfmu_settle_dwells(double sample_time, array_double_1d dwells) {
int64_t j, changed;
double rounded;
changed = 0;
if ((1e-09 <= sample_time) && (sample_time <= 1000000.0)) {
for (j = 0; j < dwells.shape[0]; j += 1) {
rounded = round_up(*cspan_at(&dwells, j), sample_time);
if (fabs(rounded - *cspan_at(&dwells, j)) > 0.0) {
*cspan_at(&dwells, j) = rounded;
changed = changed + 1;
}
}
}
return changed;
}
double segfmu_usual_room(void) {
return 0.25;
}
static void give_states(int64_t point, int64_t count, array_double_3d spots) {
int64_t axis, field;
for (axis = 0; axis < count; axis += 1) {
for (field = 0; field < 2; field += 1) {
*cspan_at(&spots, point * count + axis, 0, field) = 0.0;
}
}
}
static bool stays(int64_t point, array_double_3d choice) {
int64_t axis;
double here;
for (axis = 0; axis < choice.shape[1]; axis += 1) {
here = *cspan_at(&choice, point, axis, 0);
if (here != *cspan_at(&choice, point - 1, axis, 0)) {
return 0;
}
}
return 1;
}
static int64_t write_places(array_double_3d states, array_double_1d dwells, array_double_3d choice, array_double_1d place, array_double_3d spots) {
int64_t count, point, own, axis, field, places;
bool free;
count = states.shape[1];
copy_states(states, span_layers(&choice, 0, states.shape[0]));
segfmu_unite_waypoints(span_layers(&choice, 0, states.shape[0]), place);
for (point = 1; point < states.shape[0]; point += 1) {
own = (int64_t)(*cspan_at(&place, point));
take_states(1, span_matrix(&choice, point), span_matrix(&choice, own));
}
places = (int64_t)(*cspan_at(&place, states.shape[0] - 1)) + 1;
for (point = 0; point < places; point += 1) {
for (axis = 0; axis < count; axis += 1) {
for (field = 0; field < 2; field += 1) {
free = is_free(*cspan_at(&choice, point, axis, 1 + field));
if (free) {
*cspan_at(&choice, point, axis, 1 + field) = 0.0;
}
free = free && (0 < point) && (point < places - 1);
*cspan_at(&spots, point * count + axis, 0, field) = free;
}
}
}
for (point = 0; point < states.shape[0]; point += 1) {
own = (int64_t)(*cspan_at(&place, point));
if (*cspan_at(&dwells, point) > 0.0) {
give_states(own, count, spots);
}
if ((0 < own) && stays(own, choice)) {
give_states(own - 1, count, spots);
give_states(own, count, spots);
}
}
return places;
}
static void bring_down(array_double_3d given, array_double_2d limits, array_double_2d lower, array_double_2d axes) {
int64_t axis, order;
double velocity, acceleration, reached;
for (axis = 0; axis < axes.shape[0]; axis += 1) {
for (order = 0; order < 2; order += 1) {
*cspan_at(&axes, axis, 50 + order) = *cspan_at(&limits, axis, order);
*cspan_at(&limits, axis, order) = span_max(*cspan_at(&limits, axis, order), *cspan_at(&lower, axis, order));
}
}
velocity = 4.0 * segfmu_motion_scale(0, given, limits);
acceleration = 4.0 * segfmu_motion_scale(1, given, limits);
for (axis = 0; axis < axes.shape[0]; axis += 1) {
for (order = 0; order < 2; order += 1) {
reached = order == 1 ? acceleration : velocity;
*cspan_at(&limits, axis, order) = *cspan_at(&axes, axis, 50 + order);
if (reached > 0.0) {
*cspan_at(&limits, axis, order) = span_min(*cspan_at(&limits, axis, order), reached);
*cspan_at(&lower, axis, order) = span_min(*cspan_at(&lower, axis, order), reached);
}
}
}
}
bool segfmu_begin_choice(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d allowed, array_double_3d choice, array_double_1d place, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_2d work) {
array_double_1d path;
int64_t places, axis, order;
array_double_2d square;
bool result;
path = span_row(&tools, 0);
places = write_places(states, dwells, choice, place, spots);
for (axis = 0; axis < axes.shape[0]; axis += 1) {
for (order = 0; order < 2; order += 1) {
if (!(*cspan_at(&lower, axis, order) > 0.0)) {
*cspan_at(&lower, axis, order) = *cspan_at(&limits, axis, order);
}
*cspan_at(&axes, axis, 56 + order) = *cspan_at(&allowed, axis, order);
}
}
bring_down(span_layers(&choice, 0, places), limits, lower, axes);
take_units(places, choice, limits, lower, axes);
*cspan_at(&path, 3) = axes.shape[0];
*cspan_at(&path, 4) = places;
*cspan_at(&path, 6) = 0.0;
write_tracks(limits, lower, path, axes);
square = span_rows(&tools, 57, 90);
write_grid((int64_t)(*cspan_at(&path, 0)), span_rows(&tools, 1, 57), square);
result = set_axes(limits, lower, axes, work);
return result;
}
static bool is_given(int64_t point, int64_t count, array_double_3d spots) {
int64_t axis, field;
for (axis = 0; axis < count; axis += 1) {
for (field = 0; field < 2; field += 1) {
if (*cspan_at(&spots, point * count + axis, 0, field) != 0.0) {
return 0;
}
}
}
return 1;
}
bool segfmu_next_passage(array_double_2d tools, array_double_3d spots) {
array_double_1d path;
int64_t count, end, first, last;
path = span_row(&tools, 0);
count = (int64_t)(*cspan_at(&path, 3));
end = (int64_t)(*cspan_at(&path, 4)) - 1;
first = (int64_t)(*cspan_at(&path, 6));
while((first < end) && is_given(first + 1, count, spots)) {
first = first + 1;
}
last = first + 1;
while((last < end) && (!is_given(last, count, spots))) {
last = last + 1;
}
*cspan_at(&path, 5) = first;
*cspan_at(&path, 6) = last;
return last <= end;
}
static void searched_states(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
array_double_1d path;
int64_t begin, end, attempts, attempt;
array_double_3d given;
path = span_row(&tools, 0);
block_rows(&begin, &end, 0, path, choice);
given = span_layers(&choice, begin, end);
block_rows(&begin, &end, (int64_t)(*cspan_at(&path, 15)), path, choice);
copy_states(given, span_layers(&choice, begin, end));
*cspan_at(&path, 12) = 1e+300;
*cspan_at(&path, 13) = plan_lengths(given, spans, axes, cells, work);
*cspan_at(&path, 9) = gap_of(3);
attempts = is_moving(given) ? 2 : 1;
for (attempt = 0; attempt < attempts; attempt += 1) {
search_states(choice, tools, axes, spots, links, spans, band, cells, timing, coefficients, work);
*cspan_at(&path, 9) = gap_of(0);
}
}
static bool choose_fields(bool all_fields, array_double_3d spots) {
int64_t i;
double admitted;
bool found;
found = 0;
for (i = 0; i < spots.shape[0]; i += 1) {
found = found || (*cspan_at(&spots, i, 1, 1) != 0.0);
*cspan_at(&spots, i, 2, 1) = 0.0;
if (all_fields) {
admitted = *cspan_at(&spots, i, 1, 1);
*cspan_at(&spots, i, 2, 1) = admitted;
}
}
return found;
}
static double fastest_states(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
array_double_1d path;
int64_t begin, end;
array_double_3d best, alone;
double least, total;
path = span_row(&tools, 0);
block_rows(&begin, &end, 1, path, choice);
best = span_layers(&choice, begin, end);
block_rows(&begin, &end, 2, path, choice);
alone = span_layers(&choice, begin, end);
*cspan_at(&path, 14) = 1e+300;
*cspan_at(&path, 15) = 1;
searched_states(choice, tools, axes, spots, links, spans, band, cells, timing, coefficients, work);
total = polish_states(best, path, spots, links, spans, axes, cells, timing, coefficients, work);
if (!choose_fields(0, spots)) {
return total;
}
*cspan_at(&path, 14) = total;
*cspan_at(&path, 15) = 2;
searched_states(choice, tools, axes, spots, links, spans, band, cells, timing, coefficients, work);
least = 1e+300;
if (may_beat(total, 7, *cspan_at(&path, 12))) {
least = polish_states(alone, path, spots, links, spans, axes, cells, timing, coefficients, work);
}
choose_fields(1, spots);
if (least < total) {
copy_states(alone, best);
total = polish_states(best, path, spots, links, spans, axes, cells, timing, coefficients, work);
}
return total;
}
void segfmu_choose_passage(array_double_3d choice, array_double_2d tools, array_double_2d axes, array_double_3d spots, array_double_3d links, array_double_2d spans, array_double_2d band, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_double_2d work) {
array_double_1d path;
int64_t first, last, begin, end, low, high, beyond, size, attempt, places;
array_double_3d part, best, kept, own_spots, own_links, own_cells;
array_double_2d own_spans;
double least, share, found;
path = span_row(&tools, 0);
first = (int64_t)(*cspan_at(&path, 5));
last = (int64_t)(*cspan_at(&path, 6));
block_rows(&begin, &end, 0, path, choice);
part = span_layers(&choice, begin, end);
block_rows(&begin, &end, 1, path, choice);
best = span_layers(&choice, begin, end);
block_rows(&begin, &end, 4, path, choice);
kept = span_layers(&choice, begin, end);
low = first * axes.shape[0];
high = last * axes.shape[0];
beyond = high + axes.shape[0];
size = 2 * (beyond - low);
own_spots = span_layers(&spots, low, beyond);
own_links = span_layers(&links, low, high);
own_spans = span_rows(&spans, first, last);
own_cells = span_layers(&cells, low, high);
least = 1e+300;
copy_states(part, kept);
share = *cspan_at(&path, 17);
for (attempt = 0; attempt < 2; attempt += 1) {
if (attempt == 1) {
if (share <= segfmu_usual_room()) {
break;
}
share = segfmu_usual_room();
}
places = (int64_t)(*cspan_at(&path, 4));
write_boxes(share, first, span_layers(&choice, 0, places), path, axes, own_links);
if (!admit_states(part, path, own_spots, own_links)) {
continue;
}
widen_boxes(part, path, own_links, own_spans, axes, own_cells, timing, coefficients, work);
found = fastest_states(choice, tools, axes, own_spots, own_links, own_spans, span_rows(&band, 0, size), own_cells, timing, coefficients, work);
if (found < least) {
least = found;
copy_states(best, kept);
}
}
copy_states(kept, part);
}
void segfmu_end_choice(array_double_3d states, array_double_1d place, array_double_3d choice, array_double_2d axes) {
int64_t point, own;
for (point = 0; point < states.shape[0]; point += 1) {
own = (int64_t)(*cspan_at(&place, point));
if ((point == 0) || (own != (int64_t)(*cspan_at(&place, point - 1)))) {
return_states(own, choice, axes);
}
restore_given(span_matrix(&states, point), span_matrix(&choice, own));
}
for (point = 0; point < states.shape[0]; point += 1) {
own = (int64_t)(*cspan_at(&place, point));
take_states(0, span_matrix(&choice, own), span_matrix(&states, point));
}
}
static int64_t sensing_rows(double sample_time, double dead_time) {
int64_t samples;
if (sample_time <= 0.0) {
return 4;
}
samples = (int64_t)ceil(dead_time / sample_time) + 2;
return 4 + span_floor_div((samples + 12 - 1), 12);
}
static int64_t sensing_end(array_double_2d settings) {
array_double_1d sensors;
int64_t result;
sensors = span_row(&settings, 1);
result = 40 + sensing_rows(*cspan_at(&sensors, 0), *cspan_at(&sensors, 1));
return result;
}
void segfmu_measure_state(array_double_1d state, array_double_1d sensors, array_double_1d numbers, array_double_1d measured) {
bool noisy;
int64_t i;
double value, step;
noisy = 0;
for (i = 0; i < 5; i += 1) {
noisy = noisy || (*cspan_at(&sensors, 8 + i) > 0.0);
}
for (i = 0; i < 5; i += 1) {
value = *cspan_at(&state, i) + *cspan_at(&sensors, 3 + i);
if (noisy) {
value = value + *cspan_at(&sensors, 8 + i) * next_normal(numbers);
}
step = *cspan_at(&sensors, 13 + i);
if (fabs(value) < 1000000000000000.0 * step) {
value = (int64_t)floor(value / step + 0.5) * step;
}
*cspan_at(&measured, i) = value;
}
}
static double next_sample(array_double_1d sensors, array_double_2d memory) {
double result;
if (*cspan_at(&sensors, 0) <= 0.0) {
return 1e+300;
}
result = *cspan_at(&memory, 0, 0) * *cspan_at(&sensors, 0);
return result;
}
static int64_t ring_size(array_double_2d memory) {
int64_t result;
result = 12 * (memory.shape[0] - 4);
return result;
}
static int64_t ring_place(int64_t* result_0, int64_t* result_1_0001, int64_t number, array_double_2d memory) {
int64_t sample, row;
sample = span_floor_mod(number, ring_size(memory));
row = 4 + span_floor_div(sample, 12);
(*result_0) = row;
(*result_1_0001) = 6 * (span_floor_mod(sample, 12));
return 0;
}
static void deliver_samples(array_double_1d sensors, double time, array_double_2d memory) {
array_double_1d queue;
double latest;
int64_t row, column, i;
queue = span_row(&memory, 0);
latest = time + 1e-09 * *cspan_at(&sensors, 0);
while(*cspan_at(&queue, 2) > 0.5) {
ring_place(&row, &column, (int64_t)(*cspan_at(&queue, 1)), memory);
if ((*cspan_at(&queue, 3) > 0.5) && (*cspan_at(&memory, row, column + 0) > latest)) {
return;
}
for (i = 0; i < 5; i += 1) {
*cspan_at(&memory, 2, i) = *cspan_at(&memory, row, column + 1 + i);
}
*cspan_at(&queue, 1) = (double)(span_floor_mod(((int64_t)(*cspan_at(&queue, 1)) + 1), ring_size(memory)));
*cspan_at(&queue, 2) = *cspan_at(&queue, 2) - 1.0;
*cspan_at(&queue, 3) = 1.0;
}
}
static void take_sample(array_double_1d sensors, array_double_1d state, array_double_2d memory) {
array_double_1d queue, taken;
double time;
int64_t row, column, i;
queue = span_row(&memory, 0);
taken = span_row(&memory, 3);
time = next_sample(sensors, memory);
deliver_samples(sensors, time, memory);
segfmu_measure_state(state, sensors, span_row(&memory, 1), taken);
ring_place(&row, &column, (int64_t)(*cspan_at(&queue, 1)) + (int64_t)(*cspan_at(&queue, 2)), memory);
*cspan_at(&memory, row, column + 0) = time + *cspan_at(&sensors, 1);
for (i = 0; i < 5; i += 1) {
*cspan_at(&memory, row, column + 1 + i) = *cspan_at(&taken, i);
}
*cspan_at(&queue, 0) = *cspan_at(&queue, 0) + 1.0;
*cspan_at(&queue, 2) = *cspan_at(&queue, 2) + 1.0;
}
static void start_sensing(array_double_1d sensors, array_double_1d state, array_double_2d memory) {
int64_t i;
for (i = 0; i < 4; i += 1) {
*cspan_at(&memory, 0, i) = 0.0;
}
segfmu_seed_numbers((int64_t)(*cspan_at(&sensors, 2)), span_row(&memory, 1));
if (*cspan_at(&sensors, 0) > 0.0) {
take_sample(sensors, state, memory);
}
}
static void sense_signals(array_double_1d sensors, double time, array_double_1d state, array_double_2d memory, array_double_1d measured) {
int64_t i;
if (*cspan_at(&sensors, 0) <= 0.0) {
segfmu_measure_state(state, sensors, span_row(&memory, 1), measured);
return;
}
deliver_samples(sensors, time, memory);
for (i = 0; i < 5; i += 1) {
*cspan_at(&measured, i) = *cspan_at(&memory, 2, i);
}
}
static double time_tolerance(array_double_2d settings) {
double result;
result = 1e-09 * span_min(*cspan_at(&settings, 0, 1), 1.0);
return result;
}
static double present_time(array_double_2d memory) {
double result;
result = *cspan_at(&memory, 6, 1) + *cspan_at(&memory, 6, 2);
return result;
}
static double next_tick(array_double_2d settings, array_double_2d memory) {
double result;
result = *cspan_at(&memory, 6, 3) * *cspan_at(&settings, 0, 1);
return result;
}
static double next_reading(array_double_2d settings, array_double_2d memory) {
double result;
result = next_sample(span_row(&settings, 1), span_rows(&memory, 40, sensing_end(settings)));
return result;
}
double segfmu_rig_next_event(array_double_2d settings, array_double_2d memory) {
double time, result;
time = span_min(next_tick(settings, memory), *cspan_at(&memory, 6, 4));
result = span_min(time, next_reading(settings, memory));
return result;
}
static double next_event(array_double_2d settings, double duration, array_double_2d memory) {
double until;
until = segfmu_rig_next_event(settings, memory) - *cspan_at(&memory, 6, 1);
if (until >= duration - time_tolerance(settings)) {
return duration;
}
return until;
}
static double next_change(array_double_2d changes, double after, array_double_2d memory) {
double start, gust, duration, time, first;
int64_t i;
start = *cspan_at(&memory, 6, 0);
gust = *cspan_at(&memory, 5, 65);
duration = *cspan_at(&memory, 5, 66);
first = 1e+300;
for (i = 0; i < changes.shape[0]; i += 1) {
time = *cspan_at(&changes, i, 0) - start;
if (time > after) {
first = span_min(first, time);
}
}
if (duration > 0.0) {
time = gust - start;
if (time > after) {
first = span_min(first, time);
}
time = gust + duration - start;
if (time > after) {
first = span_min(first, time);
}
}
return first;
}
static double mechanical_energy(array_double_2d memory) {
array_double_1d energy;
double result;
energy = span_row(&memory, 13);
suspended_energy(span_row(&memory, 5), span_row(&memory, 4), span_rows(&memory, 14, 14 + 26), energy);
result = *cspan_at(&energy, 0) + *cspan_at(&energy, 1);
return result;
}
static void change_payload(array_double_2d settings, array_double_2d changes, double time, array_double_2d memory) {
int64_t chosen, i;
double start;
chosen = -1;
for (i = 0; i < changes.shape[0]; i += 1) {
start = *cspan_at(&changes, i, 0);
if (start <= time + time_tolerance(settings)) {
if ((chosen < 0) || (start > *cspan_at(&changes, chosen, 0))) {
chosen = i;
}
}
}
if (chosen >= 0) {
*cspan_at(&memory, 5, 2) = *cspan_at(&changes, chosen, 1);
}
}
static void handle_events(array_double_2d settings, array_double_2d changes, array_double_2d memory) {
array_double_1d clock, energy;
double time, latest, before, added;
clock = span_row(&memory, 6);
energy = span_row(&memory, 13);
time = present_time(memory);
latest = time + time_tolerance(settings);
while(next_reading(settings, memory) <= latest) {
take_sample(span_row(&settings, 1), span_row(&memory, 4), span_rows(&memory, 40, sensing_end(settings)));
}
while(*cspan_at(&clock, 4) <= latest) {
*cspan_at(&clock, 4) = next_change(changes, *cspan_at(&clock, 4), memory);
before = mechanical_energy(memory);
change_payload(settings, changes, *cspan_at(&clock, 0) + time, memory);
added = mechanical_energy(memory) - before;
*cspan_at(&energy, 3) = *cspan_at(&energy, 3) + added;
}
}
static void update_signals(array_double_2d settings, double time, array_double_2d memory) {
sense_signals(span_row(&settings, 1), time, span_row(&memory, 4), span_rows(&memory, 40, sensing_end(settings)), span_row(&memory, 0));
}
static bool is_driven(array_double_2d memory) {
bool result;
result = (int64_t)(*cspan_at(&memory, 5, 24)) == 1;
return result;
}
static double setpoint_at(array_double_1d setpoints, int64_t i, double share, array_double_2d memory) {
double last, bend, result;
last = *cspan_at(&memory, 7, i);
bend = *cspan_at(&memory, 11, i) + *cspan_at(&memory, 12, i) * (share + 1.0);
result = last + (*cspan_at(&setpoints, i) - last + bend * (share - 1.0)) * share;
return result;
}
static int64_t setpoint_rates(double* result_0_0001, double* result_1, double* result_2_0001, array_double_1d setpoints, int64_t i, double share, double duration, array_double_2d memory) {
double square, cube, slope, bend;
square = *cspan_at(&memory, 11, i);
cube = *cspan_at(&memory, 12, i);
slope = *cspan_at(&setpoints, i) - *cspan_at(&memory, 7, i) - square - cube;
slope = slope + (2.0 * square + 3.0 * cube * share) * share;
bend = (square + 3.0 * cube * share) / (duration * duration);
(*result_0_0001) = slope / duration;
(*result_1) = bend;
(*result_2_0001) = cube / (duration * duration * duration);
return 0;
}
static double bounded_velocity(int64_t axis, double velocity, array_double_2d memory) {
double bound;
bound = velocity_bound(span_row(&memory, 5), axis, velocity);
if (exceeds(velocity, bound)) {
*cspan_at(&memory, 8, 11 + axis) = 1.0;
return limited(velocity, bound);
}
return velocity;
}
static void set_polynomial(int64_t row, int64_t rates, int64_t i, double value, double slope, double square, double cube, array_double_2d memory) {
*cspan_at(&memory, 14 + row, i) = value;
*cspan_at(&memory, 14 + rates, 0 + i) = slope;
*cspan_at(&memory, 14 + rates, 3 + i) = square;
*cspan_at(&memory, 14 + rates, 6 + i) = cube;
}
static void set_command(int64_t axis, double value, double slope, double square, double cube, array_double_2d memory) {
set_polynomial(0, 1, axis, value, slope, square, cube, memory);
}
static void follow_velocity(int64_t axis, double end, double square, double cube, double length, array_double_2d memory) {
double bend, velocity, mean;
bend = square + cube * length;
velocity = bounded_velocity(axis, end, memory);
if (velocity != end) {
square = 0.0;
cube = 0.0;
bend = 0.0;
}
mean = (velocity - axis_velocity(span_row(&memory, 4), axis)) / length;
set_command(axis, mean - bend * length, 2.0 * square, 3.0 * cube, 0.0, memory);
}
static void set_load_force(int64_t i, double value, double slope, double square, double cube, array_double_2d memory) {
set_polynomial(2, 3, i, value, slope, square, cube, memory);
}
static int64_t delay_rows(double longest, double period) {
int64_t commands;
if (longest <= 0.0) {
return 0;
}
commands = 2 * (512 + (int64_t)ceil(longest / period)) + 8;
return 1 + span_floor_div((commands + 5 - 1), 5);
}
static double longest_delay(array_double_1d plant) {
int64_t i;
double longest;
longest = 0.0;
for (i = 0; i < 3; i += 1) {
longest = span_max(longest, *cspan_at(&plant, 46 + i));
}
return longest;
}
static bool is_late(array_double_2d memory) {
bool result;
result = longest_delay(span_row(&memory, 5)) > 0.0;
return result;
}
static int64_t command_place(int64_t* result_0, int64_t* result_1_0001, int64_t number, array_double_2d delayed) {
int64_t size, place, row;
size = 5 * (delayed.shape[0] - 1);
place = span_floor_mod(((int64_t)(*cspan_at(&delayed, 0, 0)) + number), size);
row = 1 + span_floor_div(place, 5);
(*result_0) = row;
(*result_1_0001) = 14 * (span_floor_mod(place, 5));
return 0;
}
static double command_start(int64_t number, array_double_2d delayed) {
int64_t row, column;
double result;
command_place(&row, &column, number, delayed);
result = *cspan_at(&delayed, row, column + 0);
return result;
}
static void start_delay(array_double_1d setpoints, array_double_2d delayed, array_double_2d memory) {
int64_t row, column, first, i;
*cspan_at(&delayed, 0, 1) = 1.0;
command_place(&row, &column, 0, delayed);
*cspan_at(&delayed, row, column + 0) = -1e+100;
first = 0;
if (is_driven(memory)) {
first = 3;
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&delayed, row, column + 2 + i) = *cspan_at(&setpoints, first + i);
}
}
static int64_t shifted_command(double* result_0, double* result_1, double* result_2_0001, double* result_3, int64_t axis, double after, int64_t column, array_double_1d sent) {
double cube, square, linear, value;
cube = *cspan_at(&sent, column + 11 + axis);
square = *cspan_at(&sent, column + 8 + axis);
linear = *cspan_at(&sent, column + 5 + axis);
value = *cspan_at(&sent, column + 2 + axis);
value = value + after * (linear + after * (square + after * cube));
linear = linear + after * (2.0 * square + 3.0 * after * cube);
(*result_0) = value;
(*result_1) = linear;
(*result_2_0001) = square + 3.0 * after * cube;
(*result_3) = cube;
return 0;
}
static void join_commands(double time, double shortest, array_double_2d delayed) {
int64_t newest, row, column, before, place, i;
double length, after, value, Dummy_0000, Dummy_0001, Dummy_0002, slope;
newest = (int64_t)(*cspan_at(&delayed, 0, 1)) - 1;
if (newest < 1) {
return;
}
command_place(&row, &column, newest, delayed);
command_place(&before, &place, newest - 1, delayed);
length = time - *cspan_at(&delayed, before, place + 0);
if ((*cspan_at(&delayed, row, column + 1) > 0.5) || (length >= shortest)) {
return;
}
after = time - *cspan_at(&delayed, row, column + 0);
for (i = 0; i < 3; i += 1) {
shifted_command(&value, &Dummy_0000, &Dummy_0001, &Dummy_0002, i, after, column, span_row(&delayed, row));
slope = (value - *cspan_at(&delayed, before, place + 2 + i)) / length;
*cspan_at(&delayed, before, place + 5 + i) = slope;
*cspan_at(&delayed, before, place + 8 + i) = 0.0;
*cspan_at(&delayed, before, place + 11 + i) = 0.0;
}
*cspan_at(&delayed, 0, 1) = (double)(newest);
}
static void drop_commands(double time, array_double_2d delayed) {
array_double_1d queue;
int64_t size;
queue = span_row(&delayed, 0);
size = 5 * (delayed.shape[0] - 1);
while((*cspan_at(&queue, 1) > 1.5) && ((command_start(1, delayed) <= time) || (*cspan_at(&queue, 1) >= size))) {
*cspan_at(&queue, 0) = (double)(span_floor_mod(((int64_t)(*cspan_at(&queue, 0)) + 1), size));
*cspan_at(&queue, 1) = *cspan_at(&queue, 1) - 1.0;
}
}
static void write_command(int64_t axis, array_double_1d setpoints, double share, double duration, array_double_2d memory, int64_t column, array_double_1d sent) {
int64_t place;
double added, gained, value, slope, square, cube;
place = 0 + axis;
added = *cspan_at(&memory, 3, 0 + axis);
gained = 0.0;
if (is_driven(memory)) {
place = 3 + axis;
gained = added;
added = *cspan_at(&memory, 9, axis);
}
value = setpoint_at(setpoints, place, share, memory);
setpoint_rates(&slope, &square, &cube, setpoints, place, share, duration, memory);
*cspan_at(&sent, column + 2 + axis) = value + added;
*cspan_at(&sent, column + 5 + axis) = slope + gained;
*cspan_at(&sent, column + 8 + axis) = square;
*cspan_at(&sent, column + 11 + axis) = cube;
}
static void send_commands(array_double_1d setpoints, double duration, array_double_2d memory, array_double_2d delayed) {
array_double_1d clock, queue;
bool ticked;
double time, longest, share;
int64_t newest, row, column, i;
clock = span_row(&memory, 6);
queue = span_row(&delayed, 0);
ticked = *cspan_at(&queue, 2) != *cspan_at(&clock, 3);
if ((*cspan_at(&clock, 2) > 0.0) && (!ticked)) {
return;
}
time = present_time(memory);
newest = (int64_t)(*cspan_at(&queue, 1)) - 1;
while((newest > 0) && (command_start(newest, delayed) >= time)) {
newest = newest - 1;
}
*cspan_at(&queue, 1) = newest + 1.0;
*cspan_at(&queue, 2) = *cspan_at(&clock, 3);
longest = longest_delay(span_row(&memory, 5));
join_commands(time, longest / 512, delayed);
drop_commands(time - longest, delayed);
command_place(&row, &column, (int64_t)(*cspan_at(&queue, 1)), delayed);
*cspan_at(&queue, 1) = *cspan_at(&queue, 1) + 1.0;
*cspan_at(&delayed, row, column + 0) = time;
*cspan_at(&delayed, row, column + 1) = 0.0;
if (ticked) {
*cspan_at(&delayed, row, column + 1) = 1.0;
}
share = *cspan_at(&clock, 2) / duration;
for (i = 0; i < 3; i += 1) {
write_command(i, setpoints, share, duration, memory, column, span_row(&delayed, row));
}
}
static int64_t command_number(double time, array_double_2d delayed) {
int64_t last, middle, first;
first = 0;
last = (int64_t)(*cspan_at(&delayed, 0, 1)) - 1;
while(first < last) {
middle = span_floor_div((first + last + 1), 2);
if (command_start(middle, delayed) <= time) {
first = middle;
}
else {
last = middle - 1;
}
}
return first;
}
static double next_command(array_double_2d settings, double until, array_double_2d memory, array_double_2d delayed) {
array_double_1d clock;
int64_t newest, i, number;
double late, latest, due, first;
clock = span_row(&memory, 6);
first = until;
newest = (int64_t)(*cspan_at(&delayed, 0, 1)) - 1;
for (i = 0; i < 3; i += 1) {
late = *cspan_at(&memory, 5, 46 + i);
latest = present_time(memory) - late + time_tolerance(settings);
number = command_number(latest, delayed);
if ((late > 0.0) && (number < newest)) {
due = command_start(number + 1, delayed) + late - *cspan_at(&clock, 1);
if (due < until - time_tolerance(settings)) {
first = span_min(first, due);
}
}
}
return first;
}
static void late_commands(array_double_2d settings, double length, array_double_2d memory, array_double_2d delayed) {
int64_t i, number, row, column;
double late, time, after, value, slope, square, cube, end;
for (i = 0; i < 3; i += 1) {
late = *cspan_at(&memory, 5, 46 + i);
if (late > 0.0) {
time = present_time(memory) - late;
number = command_number(time + time_tolerance(settings), delayed);
command_place(&row, &column, number, delayed);
after = time - *cspan_at(&delayed, row, column + 0);
shifted_command(&value, &slope, &square, &cube, i, after, column, span_row(&delayed, row));
if (is_driven(memory) && (*cspan_at(&memory, 5, 18 + i) == 0.0)) {
end = value + length * (slope + length * (square + length * cube));
follow_velocity(i, end, square, cube, length, memory);
}
else {
set_command(i, value, slope, square, cube, memory);
}
}
}
}
static void start_planned(array_double_1d setpoints, array_double_2d memory) {
array_double_1d planned;
int64_t i;
double value, lag, behind;
planned = span_row(&memory, 10);
for (i = 0; i < 3; i += 1) {
value = *cspan_at(&setpoints, 3 + i);
lag = *cspan_at(&memory, 5, 18 + i);
*cspan_at(&planned, 0 + i) = value;
if (lag > 0.0) {
behind = value - *cspan_at(&memory, 4, 5 + i);
*cspan_at(&planned, 3 + i) = behind / lag;
}
}
}
static void follow_setpoint(int64_t axis, double setpoint, double slope, double period, array_double_2d memory) {
array_double_1d planned;
double lag, bound, reached, risen, before, mean, after, gained, most;
planned = span_row(&memory, 10);
lag = *cspan_at(&memory, 5, 18 + axis);
if (lag <= 0.0) {
*cspan_at(&planned, 3 + axis) = slope;
return;
}
bound = velocity_bound(span_row(&memory, 5), axis, setpoint);
reached = setpoint;
if (exceeds(setpoint, bound)) {
reached = limited(setpoint, bound);
}
risen = reached - *cspan_at(&planned, 0 + axis);
*cspan_at(&planned, 0 + axis) = reached;
if (*cspan_at(&memory, 6, 3) > 1.5) {
before = *cspan_at(&planned, 3 + axis);
mean = risen / period;
after = mean + (before - mean) * exp((-period) / lag);
gained = risen - lag * (after - before);
most = period * acceleration_bound(span_row(&memory, 5), axis, gained);
if (exceeds(gained, most)) {
after = before + (risen - limited(gained, most)) / lag;
}
*cspan_at(&planned, 3 + axis) = after;
}
}
static bool controller_due(array_double_2d settings, array_double_2d memory) {
bool result;
result = next_tick(settings, memory) <= present_time(memory) + time_tolerance(settings);
return result;
}
static void prepare_tick(array_double_2d settings, array_double_1d setpoints, double duration, array_double_2d memory) {
array_double_1d clock;
double time, share, value, slope, Dummy_0000, Dummy_0001;
int64_t i, velocity;
clock = span_row(&memory, 6);
time = present_time(memory);
share = *cspan_at(&clock, 2) / duration;
*cspan_at(&clock, 3) = *cspan_at(&clock, 3) + 1.0;
*cspan_at(&clock, 5) = *cspan_at(&clock, 0) + time;
update_signals(settings, time, memory);
for (i = 0; i < 10; i += 1) {
value = setpoint_at(setpoints, 6 + i, share, memory);
*cspan_at(&memory, 1, i) = value;
}
for (i = 0; i < 3; i += 1) {
if (is_driven(memory)) {
velocity = 3 + i;
setpoint_rates(&slope, &Dummy_0000, &Dummy_0001, setpoints, velocity, share, duration, memory);
value = setpoint_at(setpoints, velocity, share, memory);
follow_setpoint(i, value, slope, *cspan_at(&settings, 0, 1), memory);
*cspan_at(&memory, 2, i) = *cspan_at(&memory, 10, 3 + i);
}
else {
value = setpoint_at(setpoints, 0 + i, share, memory);
*cspan_at(&memory, 2, i) = value;
}
}
}
static void bound_feedback(array_double_2d settings, array_double_3d gains, array_double_1d situation, array_double_2d memory) {
array_double_1d parameters, state, reference, plant;
array_double_2d tick;
double length, velocity, place, rate, sign, angle, swing;
int64_t i;
parameters = span_row(&settings, 2);
state = span_row(&memory, 4);
reference = span_row(&memory, 1);
plant = span_row(&memory, 5);
tick = span_rows(&memory, 0, 4);
length = *cspan_at(&state, 0 + 2);
*cspan_at(&situation, 0) = *cspan_at(&plant, 2) * *cspan_at(&plant, 3);
*cspan_at(&situation, 1) = length;
for (i = 0; i < 3; i += 1) {
velocity = *cspan_at(&state, 5 + i);
if (is_driven(memory)) {
velocity = *cspan_at(&reference, 5 + i) + *cspan_at(&memory, 9, i);
}
*cspan_at(&situation, 2 + i) = velocity;
place = *cspan_at(&state, 0 + i) - *cspan_at(&reference, 0 + i);
rate = *cspan_at(&state, 5 + i) - *cspan_at(&reference, 5 + i);
if (i != 2) {
sign = 1.0 - 2.0 * i;
angle = *cspan_at(&state, 3 + i) - *cspan_at(&reference, 3 + i);
swing = *cspan_at(&state, 8 + i) - *cspan_at(&reference, 8 + i);
place = place + length * sign * angle;
rate = rate + length * sign * swing;
}
*cspan_at(&situation, 5 + i) = place;
*cspan_at(&situation, 8 + i) = rate;
bound_return(i, parameters, gains, tick, situation);
bound_correction(i, parameters, tick, situation);
}
}
void segfmu_switch_correction(array_double_2d settings, array_double_2d memory) {
array_double_1d loop, correction;
double acts, decay, acted, fade, value, fading;
int64_t i;
loop = span_row(&settings, 0);
correction = span_row(&memory, 3);
acts = 2.0;
if (*cspan_at(&loop, 2) < 0.5) {
acts = 1.0;
}
decay = 0.0;
if (*cspan_at(&loop, 4) > 0.0) {
decay = exp((-*cspan_at(&loop, 1)) / *cspan_at(&loop, 4));
}
acted = *cspan_at(&correction, 6);
for (i = 0; i < 3; i += 1) {
if (*cspan_at(&loop, 2) < 0.5) {
*cspan_at(&correction, 0 + i) = 0.0;
if (is_driven(memory)) {
fade = span_max(*cspan_at(&loop, 4), *cspan_at(&loop, 1));
*cspan_at(&correction, 0 + i) = (-*cspan_at(&memory, 9, i)) / fade;
}
}
value = *cspan_at(&correction, 0 + i);
fading = *cspan_at(&correction, 3 + i);
if ((acted > 0.5) && (acted != acts)) {
fading = *cspan_at(&correction, 7 + i) - value;
}
fading = decay * fading;
*cspan_at(&correction, 3 + i) = fading;
*cspan_at(&correction, 0 + i) = value + fading;
*cspan_at(&correction, 7 + i) = value + fading;
}
*cspan_at(&correction, 6) = acts;
}
static void correct_setpoints(array_double_2d settings, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_2d memory) {
if ((int64_t)(*cspan_at(&settings, 0, 0)) == 2) {
segfmu_track_setpoint(span_row(&settings, 2), table, gains, span_rows(&memory, 0, 4), tracker);
}
else {
segfmu_feedback_correction(span_row(&memory, 4), span_row(&memory, 1), span_row(&memory, 9), gains, span_row(&memory, 3));
bound_feedback(settings, gains, span_row(&tracker, 30), memory);
}
segfmu_switch_correction(settings, memory);
}
static void command_velocities(array_double_1d setpoints, double duration, double until, array_double_2d memory) {
double done, length, correction, added, command, slope, square, cube, end;
int64_t i, velocity;
done = *cspan_at(&memory, 6, 2);
length = until - done;
for (i = 0; i < 3; i += 1) {
velocity = 3 + i;
correction = *cspan_at(&memory, 3, 0 + i);
added = *cspan_at(&memory, 9, i);
command = setpoint_at(setpoints, velocity, done / duration, memory) + added;
setpoint_rates(&slope, &square, &cube, setpoints, velocity, done / duration, duration, memory);
*cspan_at(&memory, 9, i) = added + correction * length;
set_command(i, command, slope + correction, square, cube, memory);
if (*cspan_at(&memory, 5, 18 + i) == 0.0) {
end = setpoint_at(setpoints, velocity, until / duration, memory);
follow_velocity(i, end + *cspan_at(&memory, 9, i), square, cube, length, memory);
}
}
}
static void command_forces(array_double_1d setpoints, double duration, array_double_2d memory) {
double share, force, slope, square, cube, correction;
int64_t i;
share = *cspan_at(&memory, 6, 2) / duration;
for (i = 0; i < 3; i += 1) {
force = setpoint_at(setpoints, 0 + i, share, memory);
setpoint_rates(&slope, &square, &cube, setpoints, 0 + i, share, duration, memory);
correction = *cspan_at(&memory, 3, 0 + i);
set_command(i, force + correction, slope, square, cube, memory);
}
}
static void follow_wind(array_double_1d setpoints, double duration, array_double_2d memory) {
double share, force, slope, square, cube;
int64_t i, place;
share = *cspan_at(&memory, 6, 2) / duration;
for (i = 0; i < 3; i += 1) {
place = 16 + i;
force = setpoint_at(setpoints, place, share, memory);
setpoint_rates(&slope, &square, &cube, setpoints, place, share, duration, memory);
set_load_force(i, force, slope, square, cube, memory);
}
}
static int64_t advance_plant(array_double_2d settings, array_double_2d components, array_double_1d setpoints, double duration, double until, array_double_2d memory) {
array_double_1d clock, report;
array_double_2d work;
double time, before;
int64_t i, status;
clock = span_row(&memory, 6);
report = span_row(&memory, 8);
work = span_rows(&memory, 14, 14 + 26);
time = *cspan_at(&clock, 0) + *cspan_at(&clock, 1) + *cspan_at(&clock, 2);
if (is_driven(memory)) {
command_velocities(setpoints, duration, until, memory);
}
else {
command_forces(setpoints, duration, memory);
}
if (is_late(memory)) {
late_commands(settings, until - *cspan_at(&clock, 2), memory, span_rows(&memory, sensing_end(settings), memory.shape[0]));
}
follow_wind(setpoints, duration, memory);
status = segfmu_plant_advance(span_row(&memory, 5), components, time, span_row(&memory, 4), until - *cspan_at(&clock, 2), *cspan_at(&settings, 0, 3), work, report);
for (i = 0; i < 3; i += 1) {
before = *cspan_at(&report, 11 + i);
*cspan_at(&report, 11 + i) = span_max(before, *cspan_at(&report, 3 + i));
}
if (status != 0) {
*cspan_at(&clock, 5) = time + *cspan_at(&report, 10);
}
return status;
}
void segfmu_rig_signals(array_double_2d settings, double time, array_double_2d memory) {
*cspan_at(&memory, 6, 1) = time;
*cspan_at(&memory, 6, 2) = 0.0;
update_signals(settings, time, memory);
}
static double added_velocity(int64_t axis, double time, array_double_2d memory) {
double held, correction, result;
held = time - *cspan_at(&memory, 6, 6);
correction = *cspan_at(&memory, 3, 0 + axis);
result = *cspan_at(&memory, 9, axis) + correction * held;
return result;
}
void segfmu_rig_event(array_double_2d settings, array_double_2d changes, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_1d setpoints, double time, array_double_2d memory) {
array_double_1d clock;
int64_t i;
clock = span_row(&memory, 6);
segfmu_rig_signals(settings, time, memory);
for (i = 0; i < 19; i += 1) {
*cspan_at(&memory, 7, i) = *cspan_at(&setpoints, i);
}
handle_events(settings, changes, memory);
if (controller_due(settings, memory)) {
for (i = 0; i < 3; i += 1) {
*cspan_at(&memory, 9, i) = added_velocity(i, time, memory);
}
*cspan_at(&clock, 6) = time;
prepare_tick(settings, setpoints, 1.0, memory);
correct_setpoints(settings, table, gains, tracker, memory);
}
}
static int64_t commanded_rates(array_double_2d components, array_double_1d setpoints, double time, array_double_2d memory, array_double_1d derivative) {
array_double_2d work;
array_double_1d report;
int64_t i, result;
work = span_rows(&memory, 14, 14 + 26);
report = span_row(&memory, 8);
for (i = 0; i < 3; i += 1) {
set_load_force(i, *cspan_at(&setpoints, 16 + i), 0.0, 0.0, 0.0, memory);
}
plant_derivative(span_row(&memory, 5), components, *cspan_at(&memory, 6, 0) + time, 0.0, span_row(&memory, 4), work, derivative);
for (i = 0; i < 8; i += 1) {
*cspan_at(&report, i) = *cspan_at(&work, 14, i);
}
*cspan_at(&report, 8) = *cspan_at(&derivative, 14);
*cspan_at(&report, 9) = *cspan_at(&derivative, 15);
result = plant_status(span_row(&memory, 5), span_row(&memory, 4), span_row(&work, 14));
return result;
}
int64_t segfmu_rig_rates(array_double_2d components, array_double_1d setpoints, double time, array_double_2d memory, array_double_1d derivative) {
int64_t i, result;
double command, correction;
for (i = 0; i < 3; i += 1) {
if (is_driven(memory)) {
command = *cspan_at(&setpoints, 3 + i) + added_velocity(i, time, memory);
}
else {
correction = *cspan_at(&memory, 3, 0 + i);
command = *cspan_at(&setpoints, 0 + i) + correction;
}
set_command(i, command, 0.0, 0.0, 0.0, memory);
}
result = commanded_rates(components, setpoints, time, memory, derivative);
return result;
}
static double first_command(int64_t axis, array_double_1d setpoints, array_double_2d memory) {
array_double_1d plant;
double present, change, by_force, velocity;
plant = span_row(&memory, 5);
if (!is_driven(memory)) {
velocity = *cspan_at(&setpoints, 0 + axis);
return velocity;
}
velocity = *cspan_at(&setpoints, 3 + axis);
if (*cspan_at(&plant, 18 + axis) > 0.0) {
return velocity;
}
velocity = bounded_velocity(axis, velocity, memory);
present = axis_velocity(span_row(&memory, 4), axis);
change = velocity - present;
by_force = force_bound(plant, axis, change, present);
if (span_max(acceleration_bound(plant, axis, change), by_force) == 0.0) {
return 0.0;
}
return 1000000.0 * change;
}
static void act_first(array_double_2d components, array_double_1d setpoints, array_double_2d memory) {
array_double_1d state, plant, report, derivative;
int64_t i, status;
double command, before;
state = span_row(&memory, 4);
plant = span_row(&memory, 5);
report = span_row(&memory, 8);
derivative = span_row(&memory, 14 + 4 + 6);
for (i = 0; i < 3; i += 1) {
command = first_command(i, setpoints, memory);
set_command(i, command, 0.0, 0.0, 0.0, memory);
}
status = commanded_rates(components, setpoints, 0.0, memory, derivative);
if ((status == 5) && may_slacken(plant)) {
change_rope(plant, state);
commanded_rates(components, setpoints, 0.0, memory, derivative);
*cspan_at(&state, 20) = 0.0;
*cspan_at(&state, 21) = 0.0;
*cspan_at(&state, 22) = 0.0;
}
for (i = 0; i < 3; i += 1) {
before = *cspan_at(&report, 11 + i);
*cspan_at(&report, 11 + i) = span_max(before, *cspan_at(&report, 3 + i));
}
}
int64_t segfmu_rig_rows(array_double_2d settings) {
double longest;
int64_t late, result;
longest = longest_delay(span_row(&settings, 3));
late = delay_rows(longest, *cspan_at(&settings, 0, 1));
result = sensing_end(settings) + late;
return result;
}
void segfmu_rig_start(array_double_2d settings, array_double_2d components, array_double_2d changes, array_double_1d state, array_double_1d setpoints, double start, array_double_2d memory) {
int64_t row, i;
for (row = 0; row < memory.shape[0]; row += 1) {
for (i = 0; i < memory.shape[1]; i += 1) {
*cspan_at(&memory, row, i) = 0.0;
}
}
for (i = 0; i < 10; i += 1) {
*cspan_at(&memory, 4, i) = *cspan_at(&state, i);
}
for (i = 16; i < 20; i += 1) {
*cspan_at(&memory, 4, i) = *cspan_at(&state, i);
}
for (i = 0; i < 80; i += 1) {
*cspan_at(&memory, 5, i) = *cspan_at(&settings, 3, i);
}
*cspan_at(&memory, 5, 65) = segfmu_begin_time(*cspan_at(&settings, 3, 65), start);
for (i = 0; i < 3; i += 1) {
*cspan_at(&memory, 4, 10 + i) = first_deflection(span_row(&memory, 5), i, *cspan_at(&state, 5 + i));
}
for (i = 0; i < 19; i += 1) {
*cspan_at(&memory, 7, i) = *cspan_at(&setpoints, i);
}
start_planned(setpoints, memory);
*cspan_at(&memory, 6, 0) = start;
*cspan_at(&memory, 6, 4) = next_change(changes, 0.0, memory);
change_payload(settings, changes, start, memory);
*cspan_at(&memory, 13, 2) = mechanical_energy(memory);
start_sensing(span_row(&settings, 1), span_row(&memory, 4), span_rows(&memory, 40, sensing_end(settings)));
update_signals(settings, 0.0, memory);
if (is_late(memory)) {
start_delay(setpoints, span_rows(&memory, sensing_end(settings), memory.shape[0]), memory);
}
act_first(components, setpoints, memory);
}
int64_t segfmu_rig_step(array_double_2d settings, array_double_2d components, array_double_2d changes, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_1d setpoints, double duration, array_double_2d memory) {
array_double_1d clock;
int64_t i, status;
double until;
array_double_2d delayed;
clock = span_row(&memory, 6);
if ((!(fabs(duration) < 1e+100)) || (!all_finite(setpoints, 19))) {
*cspan_at(&clock, 5) = *cspan_at(&clock, 0) + *cspan_at(&clock, 1);
return 4;
}
status = 0;
if (*cspan_at(&clock, 2) == 0.0) {
for (i = 0; i < 3; i += 1) {
*cspan_at(&memory, 8, 11 + i) = 0.0;
}
}
while((status == 0) && (*cspan_at(&clock, 2) < duration)) {
if (controller_due(settings, memory)) {
prepare_tick(settings, setpoints, duration, memory);
if ((int64_t)(*cspan_at(&settings, 0, 0)) == 0) {
return -1;
}
correct_setpoints(settings, table, gains, tracker, memory);
}
until = next_event(settings, duration, memory);
if (is_late(memory)) {
delayed = span_rows(&memory, sensing_end(settings), memory.shape[0]);
send_commands(setpoints, duration, memory, delayed);
until = next_command(settings, until, memory, delayed);
}
status = advance_plant(settings, components, setpoints, duration, until, memory);
if (status == 0) {
*cspan_at(&clock, 2) = until;
handle_events(settings, changes, memory);
}
}
*cspan_at(&clock, 2) = 0.0;
if (status == 0) {
*cspan_at(&clock, 1) = *cspan_at(&clock, 1) + duration;
for (i = 0; i < 19; i += 1) {
*cspan_at(&memory, 7, i) = *cspan_at(&setpoints, i);
*cspan_at(&memory, 11, i) = 0.0;
*cspan_at(&memory, 12, i) = 0.0;
}
}
update_signals(settings, *cspan_at(&clock, 1), memory);
return status;
}
void segfmu_rig_balance(array_double_2d memory, array_double_1d balance) {
array_double_1d state, energy;
state = span_row(&memory, 4);
energy = span_row(&memory, 13);
mechanical_energy(memory);
*cspan_at(&balance, 0) = *cspan_at(&energy, 0);
*cspan_at(&balance, 1) = *cspan_at(&energy, 1);
*cspan_at(&balance, 2) = *cspan_at(&energy, 2);
*cspan_at(&balance, 3) = *cspan_at(&state, 13);
*cspan_at(&balance, 4) = *cspan_at(&state, 14);
*cspan_at(&balance, 5) = *cspan_at(&energy, 3);
*cspan_at(&balance, 6) = *cspan_at(&state, 15);
}
double segfmu_rig_imbalance(array_double_1d balance) {
double gained, kept;
gained = *cspan_at(&balance, 3) + *cspan_at(&balance, 4) + *cspan_at(&balance, 5);
gained = gained - *cspan_at(&balance, 6);
kept = *cspan_at(&balance, 0) + *cspan_at(&balance, 1) - *cspan_at(&balance, 2);
return kept - gained;
}
static void load_outputs(array_double_1d target, array_double_2d memory, array_double_1d outputs) {
array_double_2d load;
double square, speed, error;
int64_t i;
load = span_rows(&memory, 14 + 16, 14 + 16 + 2);
suspended_load(span_row(&memory, 5), span_row(&memory, 4), span_rows(&memory, 14, 14 + 26), load);
square = 0.0;
speed = 0.0;
for (i = 0; i < 3; i += 1) {
speed = speed + *cspan_at(&load, 1, i) * *cspan_at(&load, 1, i);
error = *cspan_at(&load, 0, i) - *cspan_at(&target, i);
*cspan_at(&outputs, 18 + i) = *cspan_at(&load, 0, i);
*cspan_at(&outputs, 21 + i) = *cspan_at(&load, 1, i);
*cspan_at(&outputs, 26 + i) = error;
square = square + error * error;
}
*cspan_at(&outputs, 24) = sqrt(speed);
*cspan_at(&outputs, 29) = sqrt(square);
}
static double total_sway(double angle_x, double angle_y) {
double across;
across = cos(angle_x) * sin(angle_y);
return atan2(sqrt(sin(angle_x) * sin(angle_x) + across * across), cos(angle_x) * cos(angle_y));
}
static void drive_outputs(array_double_2d memory, array_double_1d outputs) {
array_double_1d report;
int64_t i;
report = span_row(&memory, 8);
for (i = 0; i < 3; i += 1) {
*cspan_at(&outputs, 30 + i) = *cspan_at(&report, 0 + i);
*cspan_at(&outputs, 33 + i) = *cspan_at(&report, 11 + i);
*cspan_at(&outputs, 36 + i) = *cspan_at(&report, 0 + i) * axis_velocity(span_row(&memory, 4), i);
}
*cspan_at(&outputs, 39) = *cspan_at(&report, 6);
*cspan_at(&outputs, 49) = *cspan_at(&report, 8);
*cspan_at(&outputs, 50) = *cspan_at(&report, 9);
*cspan_at(&outputs, 40) = *cspan_at(&memory, 5, 2);
}
void segfmu_rig_outputs(array_double_1d target, array_double_2d memory, array_double_1d balance, array_double_1d outputs) {
array_double_1d state;
int64_t i;
state = span_row(&memory, 4);
for (i = 0; i < 10; i += 1) {
*cspan_at(&outputs, 0 + i) = *cspan_at(&state, i);
}
for (i = 0; i < 3; i += 1) {
*cspan_at(&outputs, 10 + i) = *cspan_at(&state, 10 + i);
}
for (i = 0; i < 5; i += 1) {
*cspan_at(&outputs, 13 + i) = *cspan_at(&memory, 0, i);
}
load_outputs(target, memory, outputs);
*cspan_at(&outputs, 25) = total_sway(*cspan_at(&state, 3), *cspan_at(&state, 3 + 1));
drive_outputs(memory, outputs);
segfmu_rig_balance(memory, balance);
*cspan_at(&outputs, 41) = *cspan_at(&balance, 0);
*cspan_at(&outputs, 42) = *cspan_at(&balance, 1);
*cspan_at(&outputs, 43) = *cspan_at(&state, 13) + *cspan_at(&state, 14);
*cspan_at(&outputs, 44) = *cspan_at(&balance, 3);
*cspan_at(&outputs, 45) = *cspan_at(&balance, 4);
*cspan_at(&outputs, 46) = *cspan_at(&balance, 5);
*cspan_at(&outputs, 47) = *cspan_at(&balance, 6);
*cspan_at(&outputs, 48) = segfmu_rig_imbalance(balance);
}
void segfmu_tracking_estimates(array_double_1d parameters, array_double_2d tracker, array_double_1d estimates) {
int64_t i;
*cspan_at(&estimates, 0) = *cspan_at(&parameters, 3 + 2) * (1.0 + *cspan_at(&tracker, 5, 3));
for (i = 0; i < 3; i += 1) {
*cspan_at(&estimates, 1 + i) = *cspan_at(&tracker, 25 + i, 4);
}
for (i = 0; i < 6 - 4; i += 1) {
*cspan_at(&estimates, 4 + i) = *cspan_at(&tracker, 25 + i, 5);
}
*cspan_at(&estimates, 6) = *cspan_at(&tracker, 11 + 9, 5);
}
static int64_t axis_slopes(double* result_0, double* result_1_0001, double* result_2, array_double_1d plant, int64_t axis, array_double_1d state) {
double velocity, by_position, damping, by_velocity, by_deflection;
velocity = *cspan_at(&state, 5 + axis);
buffer_slopes(&by_position, &damping, plant, axis, *cspan_at(&state, 0 + axis), velocity);
friction_slopes(&by_velocity, &by_deflection, plant, axis, velocity, *cspan_at(&state, 10 + axis));
(*result_0) = by_position;
(*result_1_0001) = by_velocity + damping;
(*result_2) = by_deflection;
return 0;
}
static double power_slope(array_double_1d plant, int64_t axis, array_double_1d state, array_double_1d action) {
double velocity, force, bound;
velocity = *cspan_at(&state, 5 + axis);
force = *cspan_at(&action, 0 + axis);
bound = force_bound(plant, axis, force, velocity);
if ((*cspan_at(&action, 3 + axis) < 0.5) || (bound == static_bound(plant, axis, force))) {
return 0.0;
}
return (-force) / velocity;
}
static void add_damping(array_double_1d plant, array_double_1d by, array_double_1d row) {
int64_t j;
double damped;
for (j = 0; j < 2; j += 1) {
damped = *cspan_at(&plant, 49) * *cspan_at(&by, 13 + j);
*cspan_at(&row, 8 + j) = *cspan_at(&row, 8 + j) - damped;
}
}
static void forced_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials) {
array_double_1d saturated, row, rope;
int64_t i, j, hoist, velocity;
double by_force, by_position, slope, by_deflection, by_velocity, by_power;
crane_rhs_partials(state, span_row(&rig, 13), span_row(&rig, 15), plant, work);
saturated = span_row(&rig, 14);
for (i = 0; i < 5; i += 1) {
row = span_row(&partials, 0 + i);
for (j = 0; j < 10; j += 1) {
*cspan_at(&row, j) = *cspan_at(&work, i, j);
}
for (j = 0; j < 3; j += 1) {
by_force = *cspan_at(&work, i, 10 + j);
axis_slopes(&by_position, &slope, &by_deflection, plant, j, state);
*cspan_at(&row, 0 + j) = *cspan_at(&row, 0 + j) - by_position * by_force;
*cspan_at(&row, 5 + j) = *cspan_at(&row, 5 + j) - slope * by_force;
*cspan_at(&row, 16 + j) = (-by_deflection) * by_force;
*cspan_at(&row, 13 + j) = *cspan_at(&work, i, 15 + j);
if (*cspan_at(&saturated, 3 + j) < 0.5) {
*cspan_at(&row, 10 + j) = by_force;
}
by_velocity = by_force * power_slope(plant, j, state, saturated);
*cspan_at(&row, 5 + j) = *cspan_at(&row, 5 + j) + by_velocity;
}
add_damping(plant, span_row(&work, i), row);
}
for (j = 0; j < 3; j += 1) {
if (*cspan_at(&saturated, 3 + j) < 0.5) {
*cspan_at(&partials, 5 + j, 10 + j) = 1.0;
}
by_velocity = power_slope(plant, j, state, saturated);
*cspan_at(&partials, 5 + j, 5 + j) = by_velocity;
}
rope = span_row(&partials, 8);
hoist = 10 + 2;
velocity = 5 + 2;
*cspan_at(&rope, hoist) = *cspan_at(&partials, 5 + 2, hoist);
by_power = *cspan_at(&partials, 5 + 2, velocity);
axis_slopes(&by_position, &slope, &by_deflection, plant, 2, state);
*cspan_at(&rope, 0 + 2) = -by_position;
*cspan_at(&rope, velocity) = by_power - slope;
*cspan_at(&rope, 16 + 2) = -by_deflection;
}
static bool demand_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_1d command, array_double_2d partials) {
array_double_1d action;
int64_t i;
double lag, largest, demand, fastest;
bool clipped, bounded;
action = span_row(&rig, 14);
for (i = 0; i < 3; i += 1) {
lag = *cspan_at(&plant, 18 + i);
largest = force_bound(plant, i, *cspan_at(&action, 0 + i), *cspan_at(&state, 5 + i));
demand = *cspan_at(&command, i);
fastest = velocity_bound(plant, i, demand);
clipped = exceeds(demand, fastest);
if (clipped) {
demand = limited(demand, fastest);
}
demand = (demand - *cspan_at(&state, 5 + i)) / lag;
bounded = exceeds(demand, acceleration_bound(plant, i, demand));
if ((*cspan_at(&action, 3 + i) > 0.5) && (!(bounded || clipped))) {
return 0;
}
if ((largest > 0.0) && (fabs(*cspan_at(&action, 0 + i)) >= largest * (1.0 - 1e-09))) {
return 0;
}
if (!bounded) {
if (!clipped) {
*cspan_at(&partials, i, 10 + i) = 1.0 / lag;
}
*cspan_at(&partials, i, 5 + i) = (-1.0) / lag;
}
}
return 1;
}
static bool driven_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials) {
int64_t first, i, j, velocity, command;
array_double_1d row, force;
double by_drive, hoist, by_position, slope, by_deflection;
if (!demand_partials(plant, state, rig, span_row(&rig, 0), partials)) {
return 0;
}
crane_driven_partials(state, span_row(&rig, 18), span_row(&rig, 13), span_row(&rig, 15), plant, work);
first = 0 + 3;
for (i = 0; i < 5; i += 1) {
row = span_row(&partials, first + i);
for (j = 0; j < 10; j += 1) {
*cspan_at(&row, j) = *cspan_at(&work, i, j);
}
for (j = 0; j < 3; j += 1) {
by_drive = *cspan_at(&work, i, 10 + j);
velocity = 5 + j;
command = 10 + j;
*cspan_at(&row, velocity) = *cspan_at(&row, velocity) + by_drive * *cspan_at(&partials, j, velocity);
*cspan_at(&row, command) = by_drive * *cspan_at(&partials, j, command);
*cspan_at(&row, 13 + j) = *cspan_at(&work, i, 15 + j);
}
add_damping(plant, span_row(&work, i), row);
}
for (j = 0; j < 20; j += 1) {
hoist = *cspan_at(&partials, 5 + 2, j);
*cspan_at(&partials, 8, j) = hoist;
}
for (i = 0; i < 3; i += 1) {
velocity = 5 + i;
axis_slopes(&by_position, &slope, &by_deflection, plant, i, state);
force = span_row(&partials, 5 + i);
*cspan_at(&force, 0 + i) = *cspan_at(&force, 0 + i) + by_position;
*cspan_at(&force, velocity) = *cspan_at(&force, velocity) + slope;
*cspan_at(&force, 16 + i) = by_deflection;
}
return 1;
}
static void power_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials) {
array_double_1d drive, wind, lost;
int64_t j, i, rate, by_wind;
double velocity, by_position, slope, by_deflection, deflection;
drive = span_row(&partials, 9);
wind = span_row(&partials, 10);
lost = span_row(&partials, 11);
segfmu_crane_load_partials(state, work);
for (j = 0; j < 10; j += 1) {
for (i = 0; i < 3; i += 1) {
*cspan_at(&wind, j) = *cspan_at(&wind, j) + *cspan_at(&rig, 15, i) * *cspan_at(&work, 3 + i, j);
}
}
for (i = 0; i < 3; i += 1) {
rate = 5 + i;
velocity = *cspan_at(&state, rate);
for (j = 0; j < 19; j += 1) {
*cspan_at(&drive, j) = *cspan_at(&drive, j) + *cspan_at(&partials, 5 + i, j) * velocity;
}
*cspan_at(&drive, rate) = *cspan_at(&drive, rate) + *cspan_at(&rig, 14, 0 + i);
by_wind = 13 + i;
for (j = 5; j < 10; j += 1) {
*cspan_at(&wind, by_wind) = *cspan_at(&wind, by_wind) + *cspan_at(&work, 3 + i, j) * *cspan_at(&state, j);
}
axis_slopes(&by_position, &slope, &by_deflection, plant, i, state);
deflection = *cspan_at(&state, 10 + i);
*cspan_at(&lost, 0 + i) = by_position * velocity;
*cspan_at(&lost, rate) = slope * velocity + *cspan_at(&rig, 19, i);
*cspan_at(&lost, 16 + i) = by_deflection * velocity;
if (deflection_rate(plant, i, velocity, deflection) != 0.0) {
*cspan_at(&partials, 12 + i, rate) = 1.0;
}
}
for (i = 8; i < 10; i += 1) {
*cspan_at(&lost, i) = 2.0 * *cspan_at(&plant, 49) * *cspan_at(&state, i);
}
}
static void drag_partials(array_double_1d plant, array_double_1d air, array_double_2d work, array_double_2d partials) {
int64_t j, i, k, row;
double slope, along, added;
for (j = 0; j < 10; j += 1) {
for (i = 0; i < 3; i += 1) {
slope = 0.0;
for (k = 0; k < 3; k += 1) {
along = *cspan_at(&work, 3 + k, j);
slope = slope - drag_slope(plant, air, i, k) * along;
}
for (row = 0; row < 15; row += 1) {
added = *cspan_at(&partials, row, 13 + i) * slope;
*cspan_at(&partials, row, j) = *cspan_at(&partials, row, j) + added;
}
}
}
}
bool segfmu_rig_partials(array_double_2d components, double time, array_double_2d memory, array_double_2d work, array_double_2d partials) {
array_double_1d plant, state, row;
array_double_2d rig;
int64_t i, j;
bool driven;
double slope, added, correction;
plant = span_row(&memory, 5);
state = span_row(&memory, 4);
rig = span_rows(&memory, 14, 14 + 26);
if (may_slacken(plant) && (*cspan_at(&rig, 14, 6) >= 0.0)) {
return 0;
}
for (i = 0; i < 15; i += 1) {
for (j = 0; j < 20; j += 1) {
*cspan_at(&partials, i, j) = 0.0;
}
}
for (i = 0; i < 6; i += 1) {
for (j = 0; j < 18; j += 1) {
*cspan_at(&work, i, j) = 0.0;
}
}
driven = is_driven(memory);
if (driven) {
if (!driven_partials(plant, state, rig, work, partials)) {
return 0;
}
}
else {
for (i = 0; i < 3; i += 1) {
if (at_velocity_bound(plant, i, state)) {
return 0;
}
}
forced_partials(plant, state, rig, work, partials);
}
power_partials(plant, state, rig, work, partials);
wind_rates(plant, components, *cspan_at(&memory, 6, 0) + time, span_row(&rig, 21));
if (*cspan_at(&plant, 77) > 0.0) {
drag_partials(plant, span_row(&rig, 21), work, partials);
}
for (i = 0; i < 15; i += 1) {
row = span_row(&partials, i);
for (j = 0; j < 3; j += 1) {
slope = *cspan_at(&rig, 21, 6 + j);
added = *cspan_at(&row, 19) + *cspan_at(&row, 13 + j) * slope;
if (driven) {
correction = *cspan_at(&memory, 3, 0 + j);
added = added + *cspan_at(&row, 10 + j) * correction;
}
*cspan_at(&row, 19) = added;
}
}
return 1;
}
int64_t segfmu_check_travel(array_double_1d least, array_double_1d greatest, array_double_1d fault) {
int64_t axis;
for (axis = 0; axis < 3; axis += 1) {
if (!(*cspan_at(&least, axis) < *cspan_at(&greatest, axis))) {
*cspan_at(&fault, 0) = axis;
*cspan_at(&fault, 2) = *cspan_at(&least, axis);
*cspan_at(&fault, 3) = *cspan_at(&greatest, axis);
return 1;
}
}
return 0;
}
int64_t segfmu_check_lags(array_double_1d plant, int64_t exchange, array_double_1d fault) {
int64_t axis;
double lag;
*cspan_at(&fault, 3) = 1e-05;
if ((int64_t)(*cspan_at(&plant, 24)) == 1) {
for (axis = 0; axis < 3; axis += 1) {
lag = *cspan_at(&plant, 18 + axis);
*cspan_at(&fault, 1) = axis;
*cspan_at(&fault, 2) = lag;
if ((lag == 0.0) && (exchange == 1)) {
return 2;
}
if ((lag > 0.0) && (lag < *cspan_at(&fault, 3))) {
return 16;
}
}
}
return 0;
}
int64_t segfmu_check_friction(array_double_1d static_0001, array_double_1d coulomb, array_double_1d fault) {
int64_t axis;
for (axis = 0; axis < 3; axis += 1) {
if ((*cspan_at(&static_0001, axis) > 0.0) && (*cspan_at(&static_0001, axis) < *cspan_at(&coulomb, axis))) {
*cspan_at(&fault, 1) = axis;
*cspan_at(&fault, 2) = *cspan_at(&static_0001, axis);
*cspan_at(&fault, 3) = *cspan_at(&coulomb, axis);
return 12;
}
}
return 0;
}
double segfmu_wind_speed(array_double_1d speed) {
double squares;
int64_t i;
squares = 0.0;
for (i = 0; i < 3; i += 1) {
squares = squares + *cspan_at(&speed, i) * *cspan_at(&speed, i);
}
return sqrt(squares);
}
int64_t segfmu_check_turbulence(array_double_1d speed, array_double_1d deviation, array_double_1d fault) {
int64_t i;
for (i = 0; i < 3; i += 1) {
*cspan_at(&fault, 2) = *cspan_at(&deviation, i);
if ((*cspan_at(&deviation, i) > 0.0) && (segfmu_wind_speed(speed) == 0.0)) {
return 13;
}
}
return 0;
}
int64_t segfmu_check_changes(array_double_2d changes, array_double_1d fault) {
int64_t i, k;
for (i = 0; i < changes.shape[0]; i += 1) {
*cspan_at(&fault, 2) = *cspan_at(&changes, i, 0);
for (k = 0; k < i; k += 1) {
if (*cspan_at(&changes, k, 0) == *cspan_at(&changes, i, 0)) {
return 19;
}
}
}
return 0;
}
int64_t segfmu_check_slack(array_double_1d plant, int64_t exchange, array_double_1d fault) {
*cspan_at(&fault, 2) = *cspan_at(&plant, 79);
if (has_tackle(plant) && may_slacken(plant)) {
return 18;
}
if ((exchange == 1) && may_slacken(plant)) {
return 14;
}
return 0;
}
int64_t segfmu_check_delays(array_double_1d plant, double period, int64_t exchange, array_double_1d fault) {
int64_t axis;
double late;
for (axis = 0; axis < 3; axis += 1) {
late = *cspan_at(&plant, 46 + axis);
*cspan_at(&fault, 1) = axis;
*cspan_at(&fault, 2) = late;
*cspan_at(&fault, 3) = period;
if ((exchange == 1) && (late > 0.0)) {
return 11;
}
if (late > 100000 * period) {
return 10;
}
}
return 0;
}
int64_t segfmu_check_sensors(array_double_1d sensors, array_double_1d fault) {
double sample_time, dead_time, noise;
int64_t i;
sample_time = *cspan_at(&sensors, 0);
dead_time = *cspan_at(&sensors, 1);
noise = 0.0;
for (i = 0; i < 13 - 8; i += 1) {
noise = noise + *cspan_at(&sensors, 8 + i);
}
if ((sample_time == 0.0) && ((dead_time > 0.0) || (noise > 0.0))) {
return 3;
}
*cspan_at(&fault, 2) = sample_time;
*cspan_at(&fault, 3) = 1e-06;
if ((sample_time > 0.0) && (sample_time < *cspan_at(&fault, 3))) {
return 4;
}
*cspan_at(&fault, 2) = dead_time;
*cspan_at(&fault, 3) = sample_time;
if (dead_time > 100000 * sample_time) {
return 5;
}
return 0;
}
int64_t segfmu_check_rope_bounds(double length, double shortest, double longest, array_double_1d fault) {
*cspan_at(&fault, 2) = length;
if (!(length > 0.0)) {
return 6;
}
*cspan_at(&fault, 2) = shortest;
*cspan_at(&fault, 3) = longest;
if ((longest > 0.0) && (!(shortest < longest))) {
return 7;
}
return 0;
}
int64_t segfmu_check_lengths(array_double_1d lengths, array_double_1d fault) {
double shortest, longest;
shortest = *cspan_at(&lengths, 0);
longest = *cspan_at(&lengths, 1);
*cspan_at(&fault, 2) = shortest;
*cspan_at(&fault, 3) = longest;
if (!((shortest > 0.0) && (shortest <= longest) && (longest <= 1.7976931348623157e+308))) {
return 8;
}
return 0;
}
void segfmu_start_state(array_double_1d own, array_double_1d held, array_double_1d reference, array_double_1d state) {
bool none, there;
int64_t i;
none = *cspan_at(&reference, 0 + 2) <= 0.0;
for (i = 0; i < 10; i += 1) {
there = fabs(*cspan_at(&own, i) - *cspan_at(&reference, i)) <= 1e-09 * (1.0 + fabs(*cspan_at(&own, i)));
if (none || there || (*cspan_at(&reference, i) == *cspan_at(&held, i))) {
*cspan_at(&state, i) = *cspan_at(&own, i);
}
else {
*cspan_at(&state, i) = *cspan_at(&reference, i) + (*cspan_at(&own, i) - *cspan_at(&held, i));
}
}
}
int64_t segfmu_check_start(array_double_1d state, array_double_1d reference, array_double_1d fault) {
int64_t rope, i;
rope = 0 + 2;
*cspan_at(&fault, 0) = rope;
*cspan_at(&fault, 1) = *cspan_at(&state, rope);
*cspan_at(&fault, 2) = *cspan_at(&reference, rope);
if (!(*cspan_at(&state, rope) > 0.0)) {
return 1;
}
for (i = 3; i < 5; i += 1) {
*cspan_at(&fault, 0) = i;
*cspan_at(&fault, 1) = *cspan_at(&state, i);
if (!(fabs(*cspan_at(&state, i)) < 1.5707963267948966)) {
return 2;
}
}
return 0;
}
int64_t segfmu_judge_start(array_double_1d state, array_double_1d reference, double gravity, array_double_1d fault) {
double length, farthest, scale, distance;
int64_t i, status;
length = *cspan_at(&reference, 0 + 2);
if (length <= 0.0) {
return 0;
}
farthest = 1.0;
status = 0;
for (i = 0; i < 10; i += 1) {
scale = 0.8;
if ((i < 3) || ((i >= 5) && (i < 8))) {
scale = 0.25 * length;
}
if (i >= 5) {
scale = scale * sqrt(gravity / length);
}
distance = fabs(*cspan_at(&state, i) - *cspan_at(&reference, i)) / scale;
if (distance > farthest) {
farthest = distance;
*cspan_at(&fault, 0) = i;
*cspan_at(&fault, 1) = *cspan_at(&state, i);
*cspan_at(&fault, 2) = *cspan_at(&reference, i);
status = 3;
}
}
return status;
}
int64_t segfmu_check_start_rope(double length, double shortest, double longest, array_double_1d fault) {
*cspan_at(&fault, 0) = 0 + 2;
*cspan_at(&fault, 1) = length;
*cspan_at(&fault, 2) = shortest;
if (length < shortest) {
return 5;
}
*cspan_at(&fault, 2) = longest;
if ((longest > 0.0) && (length > longest)) {
return 5;
}
return 0;
}
int64_t segfmu_is_elsewhere(array_double_1d before, array_double_1d reference, double step) {
int64_t i;
double moved, small;
if (*cspan_at(&reference, 0 + 2) <= 0.0) {
return 0;
}
for (i = 0; i < 3; i += 1) {
moved = 2.0 * step * fabs(*cspan_at(&reference, 5 + i));
small = 0.001 * fabs(*cspan_at(&reference, 0 + 2));
if (fabs(*cspan_at(&reference, 0 + i) - *cspan_at(&before, 0 + i)) > moved + small) {
return 1;
}
}
return 0;
}
int64_t segfmu_expand_motion(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work) {
array_double_1d judging;
int64_t wrong;
if (segfmu_count_pieces(axes, cells) > timing.shape[0]) {
return 1;
}
expand_plan(states, dwells, axes, cells, timing, coefficients, offsets, times, span_rows(&work, 242, 246));
judging = span_row(&work, 1);
wrong = check_plan(states, times, timing, coefficients, offsets, limits, lower, *cspan_at(&judging, 0), *cspan_at(&judging, 1), span_rows(&work, 246, 294));
if (wrong > 0) {
return -12;
}
return 0;
}
int64_t segfmu_plan_motion(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work) {
array_double_2d planner;
int64_t status;
planner = span_rows(&work, 2, 242);
status = segfmu_check_problem(states, limits, span_row(&planner, 99));
if (status == 0) {
status = segfmu_plan_phases(states, dwells, limits, lower, span_row(&work, 0), axes, cells, planner);
}
if (status == 0) {
status = segfmu_expand_motion(states, dwells, limits, lower, axes, cells, timing, coefficients, offsets, times, work);
}
return status;
}
