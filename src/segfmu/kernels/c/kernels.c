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
static double interval_end(double time, array_double_2d timing, array_int64_t_1d offsets);
static void interval_pieces(double time, double until, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work);
static double demand_bound(int64_t demand, array_double_1d bounds);
static int64_t rope_demand(int64_t demand, array_double_1d bounds, int64_t width, array_double_2d work);
static double first_negative(int64_t count, double length, array_double_2d work);
static double value_at(int64_t demand, double local, double gravity, int64_t width, array_double_2d work);
static double worst_value(int64_t demand, double first, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work);
static void write_row(int64_t source, int64_t count, double length, int64_t row, array_double_2d work, array_double_2d span);
static void write_difference(int64_t first, int64_t pull, int64_t second, int64_t other, double length, int64_t row, array_double_2d work, array_double_2d span);
static void note_rounding(array_double_2d span);
static void write_span(int64_t part, double time, double until, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work, array_double_2d span);
static void halve_span(int64_t row, array_double_3d stack);
static int64_t part_meeting(int64_t part, array_double_2d span, array_double_1d box);
static void note_place(int64_t part, array_double_2d span, array_double_1d box, array_double_1d place);
static int64_t note_time(int64_t found, array_double_2d span, array_double_2d times);
static int64_t halved_contacts(int64_t part, int64_t found, array_double_1d box, array_double_3d stack, array_double_2d times, array_double_1d place);
static int64_t span_contacts(int64_t part, int64_t found, array_double_1d box, array_double_2d span, array_double_3d stack, array_double_2d times, array_double_1d place);
static int64_t sum_range(double* result_0, double* result_1, int64_t axis, double share, double lean, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work);
static void widen_range(int64_t row, int64_t axis, double least, double most, array_double_2d ranges);
static bool is_near(int64_t part, array_double_1d box, array_double_2d ranges);
static bool is_any_near(array_double_2d boxes, array_double_2d ranges);
static double touch_distance(array_double_2d ranges);
static void shrink_box(double touch, int64_t low, int64_t high, array_double_1d box);
static void note_first(int64_t part, array_double_2d boxes, array_double_3d stack, array_double_2d ranges, array_double_1d report);
static void prolong_contact(int64_t part, array_double_2d boxes, array_double_3d stack, array_double_2d ranges, array_double_1d report);
static void write_faces(array_double_1d space, array_double_2d boxes);
static int64_t obstacle_count(array_double_1d space, array_double_2d obstacles);
static int64_t check_space(array_double_1d space, array_double_2d obstacles, array_double_1d fault);
static double side_bound(double sign, double greatest, double least);
static bool exceeds(double value, double bound);
static double limited(double value, double bound);
static double velocity_bound(array_double_1d plant, int64_t axis, double sign);
static double acceleration_bound(array_double_1d plant, int64_t axis, double sign);
static double static_bound(array_double_1d plant, int64_t axis, double sign);
static double force_bound(array_double_1d plant, int64_t axis, double sign, double velocity);
static void rope_direction(array_double_1d state, array_double_1d limit);
static double carriage_mass(array_double_1d masses, int64_t axis);
static double available_force(int64_t axis, double side, array_double_1d limit);
static double limit_side(array_double_1d plant, int64_t axis, array_double_1d action, array_double_1d limit);
static double missing_force(int64_t axis, array_double_1d action, array_double_1d limit);
static void change_accelerations(array_double_1d plant, array_double_1d action, array_double_1d limit);
static void limit_accelerations(array_double_1d plant, array_double_1d state, array_double_1d action, array_double_1d acceleration, array_double_1d limit);
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
static void kalman_model(int64_t axis, array_double_1d plant, double length, array_double_2d model);
static void kalman_series(double part, double drift, double wind, array_double_2d model, array_double_2d transition, array_double_2d covariance, array_double_2d work);
static void kalman_sampled(double sample_time, double drift, double wind, array_double_2d model, array_double_2d transition, array_double_2d covariance, array_double_2d work);
static double kalman_turn(array_double_2d spread, array_double_2d work);
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
static double spectral_radius(int64_t n, array_double_2d a, array_double_2d square);
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
static void share_series(array_double_1d resistance, double time, array_double_1d motion, int64_t order, array_double_2d contacts, array_double_2d work);
static void level_series(array_double_1d resistance, int64_t axis, int64_t count, array_double_2d work);
static void add_dry_series(array_double_1d resistance, int64_t axis, int64_t count, array_double_2d work);
static double pace_between(array_double_1d pace);
static void write_transform(array_double_2d work);
static void demand_at(double time, int64_t row, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work);
static void note_value(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times);
static double sooner(double time, double after, double following);
static double next_joint(double time, double duration, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends, array_double_3d contacts);
static void sample_demands(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work);
static void enlarge_scale(array_double_2d work);
static void share_scale(array_double_2d work);
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
static void stage_state(int64_t stage, double h, int64_t count, array_double_1d state, array_double_2d k, array_double_1d trial);
static double step_error(double h, int64_t count, array_double_1d start, array_double_1d end, array_double_2d k);
static double next_step(double error, double tolerance);
static bool all_finite(array_double_1d values, int64_t count);
static void plant_powers(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void plant_derivative(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, array_double_2d work, array_double_1d derivative);
static void reuse_last_stage(array_double_2d work);
static void first_stage(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, array_double_2d work);
static double try_step(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, double h, array_double_2d work);
static int64_t plant_status(array_double_1d plant, array_double_1d state, double rope_force);
static void accept_step(array_double_1d state, array_double_2d work, double elapsed, array_double_1d report);
static bool has_own_bound(int64_t i, int64_t side, array_double_1d bounds);
static double bound_magnitude(int64_t i, int64_t side, array_double_1d bounds);
static void write_fault(int64_t i, int64_t side, double peak, double time, array_double_1d bounds, array_double_1d fault);
static double root_share(double newest, double other, double before, double e_newest, double e_other, double e_before);
static int64_t next_bracket(double* result_0_0001, double* result_1_0001, double* result_2_0001, double* result_3_0001, bool crossed, double newest, double other, double e_newest, double e_other);
static double least_scale(void);
static double push_of(double velocity);
static double standstill(int64_t slot, int64_t axis, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static double end_rounding_of(double end);
static double low_end(int64_t axis, array_double_2d known);
static double high_end(int64_t axis, array_double_2d known);
static void write_push(double scale, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static double limited_velocity(double velocity, double scale, double limit, double lower);
static void write_wish(int64_t mode, double scale, array_double_1d aim, array_double_1d command, array_double_2d limits, array_double_2d known);
static void write_aim(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static int64_t most_attempts(void);
static int64_t most_in_step(void);
static int64_t first_stop(void);
static double pace_of(int64_t attempt);
static double share_of(int64_t attempt, int64_t axis);
static bool is_worth(int64_t attempt, int64_t failed, array_double_1d aim);
static void set_lower_of(int64_t place, array_double_2d operation, array_double_3d limits, array_double_2d known);
static void set_attempt(int64_t attempt, array_double_2d operation, array_double_3d limits, array_double_2d known);
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
static void write_sway(array_double_2d reach);
static bool write_reach(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d crane, array_double_2d work);
static int64_t judge_reach(array_double_1d bounds, array_double_2d work);
static bool keeps_between(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work);
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
static int64_t plan_pieces(int64_t slot, array_int64_t_1d offsets);
static double plan_end(int64_t slot, int64_t axis, array_double_3d timing, array_int64_t_1d offsets);
static void copy_plan(int64_t source, int64_t target, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool has_room(int64_t slot, array_int64_t_1d offsets);
static void clear_plan(int64_t slot, array_int64_t_1d offsets);
static bool keeps_limits(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work);
static int64_t prove_plan(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work, array_double_3d stack);
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
static double usual_share(array_double_1d axis);
static double steeper_above(void);
static double moderate_share(void);
static double steepest_share(void);
static bool ramps_suffice(array_double_1d axis);
static bool snap_is_last(array_double_1d axis);
static double saving(array_double_1d axis);
static bool plateau_parameters(double share, array_double_1d axis);
static bool smoothstep_parameters(array_double_1d axis, array_double_1d psi, array_double_1d peaks);
static double shortest_scale(int64_t order, array_double_1d limits);
static double natural_limit(int64_t order, double steep, array_double_1d axis, array_double_1d limits);
static void chain_limits(double steep, array_double_1d axis, array_double_1d state, array_double_1d limits);
static void set_chains(double steep, array_double_1d axis, array_double_1d limits, array_double_2d chains);
static void lift_pieces(int64_t order, int64_t first, int64_t last, array_double_1d state, array_double_2d timing, array_double_2d coefficients);
static bool set_box(double steep, int64_t loose, array_double_1d limits, array_double_2d lead);
static double lower_limit(int64_t order, array_double_1d limits, array_double_2d lead);
static bool is_outside(array_double_1d limits, array_double_2d lead);
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
static void swap_entries(array_double_2d phases, int64_t i, int64_t j, int64_t column);
static void reverse_phases(array_double_2d phases, int64_t first, int64_t count);
static void reverse_problem(array_double_1d problem);
static void boundary_problem(array_double_1d problem, array_double_1d axis, array_double_1d cleaned);
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
static int64_t direct_form(array_double_2d phases, bool from_start, array_double_1d problem, array_double_1d axis);
static double set_loop(array_double_1d problem, array_double_1d axis, array_double_1d family);
static int64_t level_from(double* result_0_0001, double* result_1_0001, double* result_2_0001, double a, double time, double up, double down, array_double_1d family, array_double_1d axis);
static double set_point(double place, double radius, array_double_1d family, array_double_1d axis);
static double loop_radius(int64_t arc, double place, double missing, double largest, array_double_1d family, array_double_1d axis);
static bool slow_middle(double place, double radius, array_double_1d family, array_double_1d axis);
static double window_edge(int64_t halvings, double inside, double outside, array_double_1d family, array_double_1d axis);
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
static double nearby_member(array_double_1d family, array_double_1d axis);
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
static double distance_within(double change, array_double_1d problem);
static double cruise_range(array_double_2d phases, double middle, double y, double hold, array_double_1d problem, array_double_1d axis);
static void keep_nearest(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static bool is_enclosed(array_double_2d work);
static double keep_cruise(double cruise, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static void between_cruises(double lower, double upper, double e_lower, double e_upper, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static double cruise_edge(double inside, double outside, double h_inside, double h_outside, array_double_2d phases, array_double_1d problem, array_double_1d axis);
static void scan_cruises(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static int64_t loop_excess(double* result_0, double* result_1, int64_t arc, double place, double missing, double largest, array_double_1d family, array_double_1d axis);
static double loop_root(int64_t arc, double lower, double upper, double e_lower, double e_upper, double missing, double largest, array_double_1d family, array_double_1d axis);
static int64_t arc_root(int64_t* result_0, double* result_1, int64_t arc, int64_t sample, double missing, double largest, array_double_1d family, array_double_1d axis);
static int64_t loop_form(int64_t last, int64_t count, double longest, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void timed_loop(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work);
static int64_t next_loop(int64_t* result_0_0001, double* result_1_0001, int64_t arc, int64_t sample, double longest, array_double_1d problem, array_double_1d axis, array_double_2d work);
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
static bool has_pace(array_double_1d passing);
static double residual_norm(int64_t count, array_double_1d residual);
static void pace_column(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void time_column(int64_t column, int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void whole_column(int64_t column, int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void newton_step(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work);
static double longest_step(array_double_2d work);
static void take_step(double share, array_double_2d work);
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
static bool release_touch(int64_t kind, array_double_2d work);
static int64_t add_plateau(bool upward, array_double_1d axis, array_double_2d work);
static bool meet_limits(bool upward, double longest, array_double_1d problem, array_double_1d axis, array_double_2d work);
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
static int64_t vanishing_level(int64_t step, array_double_2d work);
static bool release_plateau(array_double_2d work);
static bool flip_level(array_double_2d work);
static bool follow(double target, array_double_1d problem, array_double_1d axis, array_double_2d work);
static void append_level(double sign, double time, array_double_2d work);
static void append_levels(double change, array_double_1d axis, array_double_2d work);
static int64_t limit_held(int64_t* result_0, double* result_1_0001, double a, double v, array_double_1d axis);
static void copy_levels(int64_t count, array_double_2d phases, double v, array_double_1d axis, array_double_2d work);
static void begin_sequence(int64_t count, array_double_2d phases, array_double_1d axis, array_double_1d passing);
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
static bool may_detour(array_double_1d problem, array_double_1d axis);
static int64_t shortest_between(int64_t attempt, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static bool is_done(array_double_1d problem);
static int64_t braked_variant(int64_t* result_0_0001, double* result_1_0001, int64_t variant, double longest, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t braked_ramps(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
static bool crosses_zero(int64_t row, array_double_2d phases);
static int64_t shorter_braked(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t shorter_than_detour(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
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
static int64_t begun_profile(array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t plain_profile(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work);
static int64_t append_stage(double v, double a, double w, array_double_2d phases, array_double_1d chain);
static void set_stage_problem(int64_t order, double end, array_double_1d state, array_double_1d problem);
static int64_t stage_phases(int64_t order, double end, bool free, array_double_2d lead);
static int64_t append_phases(int64_t order, double end, int64_t count, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t run_stage(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void drop_rounding(int64_t order, array_double_2d lead);
static int64_t settle(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double outside_by(double value, int64_t order, array_double_2d lead);
static int64_t hold_highest(double value, double length, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t lead_to(int64_t order, double end, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double part_hull(int64_t order, int64_t row, double start, double length, array_double_2d lead, array_double_2d coefficients);
static bool stays_inside(int64_t order, int64_t first, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double time_crossed(int64_t order, int64_t row, double lower, double upper, array_double_2d lead, array_double_2d coefficients);
static int64_t inside_from(int64_t* result_0_0001, double* result_1_0001, int64_t order, int64_t first, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double try_brake(int64_t order, double side, double level, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void note_extremes(int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void end_brake(double until, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void append_pieces(double until, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void split_brake(double until, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double time_inside(array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double level_limit(int64_t order, double side, array_double_2d lead);
static int64_t best_level(double* result_0, double* result_1, int64_t order, double side, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t level_time(double* result_0, double* result_1, int64_t order, double side, double gentle, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double side_beyond(int64_t order, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void bring_highest(array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool bring_gently(int64_t order, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool bring_inside(int64_t order, bool whole, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void clip_reached(array_double_2d lead);
static int64_t brake_within(double steep, int64_t loose, bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t best_steepness(double* result_0_0001, double* result_1, int64_t loose, bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double end_rounding(void);
static void write_end(int64_t last, array_double_2d timing, array_double_2d coefficients, array_double_1d end);
static bool is_at_velocity(double velocity, array_double_1d limits, array_double_1d end);
static int64_t level_order(int64_t order, array_double_2d lead);
static double lead_end(int64_t order, array_double_2d lead);
static int64_t passing_phases(int64_t order, double least, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t settle_over_level(int64_t order, double end, double least, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void set_limits(double steep, array_double_2d lead);
static bool is_settled(array_double_2d lead);
static void soonest_ends(int64_t order, array_double_2d lead);
static double profile_time(array_double_2d lead);
static void keep_lead(int64_t last, double time, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool begins_now(array_double_2d lead, array_double_2d coefficients);
static bool keep_better(int64_t last, double time, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool try_lead(int64_t order, int64_t row, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double try_level(int64_t order, double level, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool try_end(int64_t order, int64_t stage, double end, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void search_end(int64_t order, int64_t stage, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void follow_profile(int64_t order, int64_t stage, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static int64_t first_free_stage(int64_t order);
static void improve_ends(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void search_ends(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double near_zero(double i);
static void search_pairs(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static double search_grid(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void improve_level(int64_t order, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void search_levels(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool permits_levels(int64_t order, array_double_2d lead);
static void search_stages(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool settled_end(int64_t row, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void follow_plan(int64_t order, int64_t axis, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool start_search(int64_t shape, array_double_1d limits, array_double_2d lead);
static void improve_lead(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void prepend_brake(int64_t steps, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void search_braked(int64_t order, double within_0001, int64_t shape, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static bool find_lead(int64_t order, double within_0001, int64_t axis, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void set_start(int64_t axis, array_double_2d start, array_double_2d lower, array_double_2d lead);
static void set_target(int64_t axis, array_double_2d targets, array_double_2d lead);
static int64_t latest_axis(array_double_2d ends);
static int64_t take_lead(int64_t first, array_double_1d end, array_double_2d lead, array_double_2d timing, array_double_2d coefficients);
static void follow_whole(int64_t axis, array_double_1d limits, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d end, array_double_2d lead, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets);
static void pack_leads(array_int64_t_1d plan_offsets, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets);
static void clear_lead(array_double_2d lead);
static void set_lead(int64_t order, int64_t shape, double meeting, array_double_2d lead);
static bool lead_between(int64_t source, int64_t slot, array_double_2d ends, array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static void set_motion(array_double_2d operation, array_double_3d states);
static bool reach_velocities(array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static bool reach_and_stop(array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static double way_left(int64_t axis, double velocity, double rest, array_double_2d known);
static double room_left(int64_t axis, array_double_2d operation, array_double_2d known);
static bool shrink_shares(bool last, array_double_2d operation, array_double_2d known);
static void hold_shares(array_double_2d operation, array_double_2d known);
static void shift_row(int64_t row, double later, double way, array_double_3d timing, array_double_3d coefficients);
static bool join_held(array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool seek_velocity(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead);
static bool holds_long_enough(double elapsed, array_double_2d operation);
static bool prolong_holds(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static int64_t insert_end(double duration, double after, int64_t count, array_double_2d ends);
static int64_t cruise_times(double* result_0, double* result_1_0001, double cruise, array_double_1d problem, array_double_1d axis, array_double_2d phases);
static double cruise_time(double cruise, bool covering, array_double_1d problem, array_double_1d axis, array_double_2d phases);
static double turning_time(double lower, double upper, bool covering, array_double_1d problem, array_double_1d axis, array_double_2d phases);
static double cruise_sample(int64_t sample, double fastest, double backwards);
static int64_t insert_turn(int64_t sample, bool covering, double least, double spent, double after, double fastest, double backwards, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count);
static int64_t turning_ends(double spent, double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count);
static int64_t insert_covering(array_double_2d phases, int64_t taken, double spent, double after, array_double_1d problem, array_double_1d axis, int64_t count, array_double_2d ends);
static int64_t covering_ends(double spent, double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count);
static int64_t loop_ends(double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count);
static int64_t dip_ends(double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count);
static int64_t gap_ends(double after, double shortest, array_double_1d problem, array_double_1d axis, array_double_2d work);
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
static bool timed_gently(array_double_1d axis, array_double_2d cell, array_double_2d work);
static bool timed_slower(double shortest, array_double_1d axis, array_double_2d cell, array_double_2d work);
static void surround_nearest(int64_t variant, array_double_1d axis, array_double_2d cell, array_double_2d work);
static double timed_braked(array_double_1d axis, array_double_2d cell, array_double_2d work);
static int64_t slowed_shortest(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work);
static double slower_passing(array_double_1d axis, array_double_2d cell, array_double_2d work);
static double between_extremes(array_double_1d axis, array_double_2d cell, array_double_2d work);
static int64_t set_shortest(int64_t* result_0, double* result_1_0001, array_double_2d cell, array_double_1d axis, array_double_2d work);
static void set_stretched(double target, bool resting, array_double_2d cell, array_double_1d axis, array_double_2d work);
static bool set_duration(double target, array_double_2d cell, array_double_1d axis, array_double_2d work);
static double first_feasible(double accuracy, double outside, double inside, array_double_2d cell, array_double_1d axis, array_double_2d work);
static double earlier_feasible(double start, double end, array_double_2d cell, array_double_1d axis, array_double_2d work);
static double next_feasible(double start, array_double_2d cell, array_double_1d axis, array_double_2d work);
static double round_up(double duration, double sample_time);
static double common_duration(double start, double sample_time, int64_t first, int64_t last, array_double_2d axes, array_double_3d cells, array_double_2d work);
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
static void set_place(array_double_2d operation, array_double_3d states);
static void set_ends(array_double_2d operation, array_double_3d states);
static void set_options(array_double_2d known, array_double_2d work);
static bool is_too_fast(array_double_2d operation, array_double_2d limits);
static bool lead_to_target(array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work);
static bool plan_target(array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work);
static void join_behind(array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool seek_target(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work);
static bool is_aim(int64_t row, array_double_2d operation);
static void note_present(double elapsed, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool is_stop(array_double_1d aim);
static void note_taken(int64_t attempt, array_double_2d operation);
static void take_plan(int64_t attempt, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets);
static bool keeps_stopping(int64_t attempt, array_double_2d operation);
static int64_t rank(int64_t attempt, array_double_1d aim);
static bool attempt_plans(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work, array_double_3d stack);
static int64_t check_limits(array_double_2d limits, array_double_1d report);
static int64_t check_numbers(array_double_3d states, array_double_2d limits, array_double_1d report);
static double change_time(double size, int64_t derivative, array_double_1d limits);
static int64_t axis_scale(double* result_0, double* result_1_0001, int64_t axis, array_double_3d states, array_double_1d limits);
static double settle_value(double value, int64_t order, int64_t axis, array_double_3d states, array_double_2d limits, array_double_2d lower);
static bool differ(double before, double value);
static bool is_same(array_double_2d before, array_double_2d state);
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


static int64_t row_range(double* result_0, double* result_1, array_double_2d span, int64_t row)
{
    double least;
    double most;
    int64_t i;
    least = (*cspan_at(&span, row, INT64_C(0)));
    most = least;
    for (i = INT64_C(1); i < span.shape[INT64_C(1)]; i += INT64_C(1))
    {
        least = span_min(least, (*cspan_at(&span, row, i)));
        most = span_max(most, (*cspan_at(&span, row, i)));
    }
    (*result_0) = least;
    (*result_1) = most;
    return 0;
}
static int64_t load_meeting(array_double_2d span, array_double_1d box)
{
    int64_t axis;
    double least;
    double most;
    double low;
    double high;
    int64_t meeting;
    meeting = INT64_C(1);
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        row_range(&least, &most, span, INT64_C(0) + axis);
        low = (*cspan_at(&box, INT64_C(0) + axis));
        high = (*cspan_at(&box, INT64_C(3) + axis));
        if ((most <= low) || (least >= high))
        {
            return INT64_C(0);
        }
        if ((least <= low) || (most >= high))
        {
            meeting = INT64_C(2);
        }
    }
    return meeting;
}
static bool is_beside(int64_t axis, double lowest, double highest, double top, array_double_2d span, array_double_1d box)
{
    double bottom;
    bool below;
    bool above;
    int64_t i;
    double reach;
    double upwards;
    double low;
    double high;
    double side;
    double place;
    bottom = (*cspan_at(&box, INT64_C(6) + INT64_C(2)));
    below = 1;
    above = 1;
    for (i = INT64_C(0); i < span.shape[INT64_C(1)]; i += INT64_C(1))
    {
        reach = (*cspan_at(&span, INT64_C(3) + axis, i));
        upwards = (*cspan_at(&span, INT64_C(6) + INT64_C(2), i));
        low = reach - (*cspan_at(&box, INT64_C(6) + axis)) * upwards;
        high = reach - (*cspan_at(&box, INT64_C(9) + axis)) * upwards;
        side = (*cspan_at(&span, INT64_C(6) + axis, i));
        place = (*cspan_at(&span, INT64_C(0) + axis, i));
        below = below && (low + top * side <= 0.0);
        above = above && (high + top * side >= 0.0);
        if (lowest < bottom)
        {
            below = below && (low + bottom * side <= 0.0);
            above = above && (high + bottom * side >= 0.0);
        }
        if (highest > bottom)
        {
            below = below && (place <= (*cspan_at(&box, INT64_C(6) + axis)));
            above = above && (place >= (*cspan_at(&box, INT64_C(9) + axis)));
        }
        if ((!below) && (!above))
        {
            return 0;
        }
    }
    return 1;
}
static int64_t turn_range(double* result_0, double* result_1, int64_t corner, array_double_2d span, array_double_1d box)
{
    double x;
    double y;
    double least;
    double most;
    int64_t i;
    double turn;
    x = (*cspan_at(&box, INT64_C(6)));
    y = (*cspan_at(&box, INT64_C(6) + INT64_C(1)));
    if (span_floor_mod(corner, INT64_C(2)) == INT64_C(1))
    {
        x = (*cspan_at(&box, INT64_C(9)));
    }
    if (span_floor_div(corner, INT64_C(2)) == INT64_C(1))
    {
        y = (*cspan_at(&box, INT64_C(9) + INT64_C(1)));
    }
    least = 1e+300;
    most = -1e+300;
    for (i = INT64_C(0); i < span.shape[INT64_C(1)]; i += INT64_C(1))
    {
        turn = (*cspan_at(&span, INT64_C(5), i)) - x * (*cspan_at(&span, INT64_C(6) + INT64_C(1), i)) + y * (*cspan_at(&span, INT64_C(6), i));
        least = span_min(least, turn);
        most = span_max(most, turn);
    }
    (*result_0) = least;
    (*result_1) = most;
    return 0;
}
static int64_t count_edges(int64_t* result_0, int64_t* result_1, array_double_2d span, array_double_1d box)
{
    double rounding;
    int64_t left;
    int64_t right;
    int64_t corner;
    double least;
    double most;
    rounding = (*cspan_at(&span, INT64_C(9), INT64_C(3)));
    left = INT64_C(0);
    right = INT64_C(0);
    for (corner = INT64_C(0); corner < INT64_C(4); corner += INT64_C(1))
    {
        turn_range(&least, &most, corner, span, box);
        if (least > rounding)
        {
            left = left + INT64_C(1);
        }
        if (most < -rounding)
        {
            right = right + INT64_C(1);
        }
    }
    (*result_0) = left;
    (*result_1) = right;
    return 0;
}
static bool is_across(int64_t axis, double lowest, double highest, double top, array_double_2d span, array_double_1d box)
{
    double bottom;
    bool past_low;
    bool past_high;
    bool lower_past_low;
    bool lower_past_high;
    int64_t i;
    double reach;
    double upwards;
    double low;
    double high;
    double side;
    double place;
    bottom = (*cspan_at(&box, INT64_C(6) + INT64_C(2)));
    past_low = 1;
    past_high = 1;
    lower_past_low = 1;
    lower_past_high = 1;
    for (i = INT64_C(0); i < span.shape[INT64_C(1)]; i += INT64_C(1))
    {
        reach = (*cspan_at(&span, INT64_C(3) + axis, i));
        upwards = (*cspan_at(&span, INT64_C(6) + INT64_C(2), i));
        low = reach - (*cspan_at(&box, INT64_C(6) + axis)) * upwards;
        high = reach - (*cspan_at(&box, INT64_C(9) + axis)) * upwards;
        side = (*cspan_at(&span, INT64_C(6) + axis, i));
        place = (*cspan_at(&span, INT64_C(0) + axis, i));
        past_low = past_low && (low + top * side > 0.0);
        past_high = past_high && (high + top * side < 0.0);
        if (lowest < bottom)
        {
            lower_past_low = lower_past_low && (low + bottom * side > 0.0);
            lower_past_high = lower_past_high && (high + bottom * side < 0.0);
        }
        if (highest > bottom)
        {
            lower_past_low = lower_past_low && (place > (*cspan_at(&box, INT64_C(6) + axis)));
            lower_past_high = lower_past_high && (place < (*cspan_at(&box, INT64_C(9) + axis)));
        }
    }
    return (past_low || lower_past_low) && (past_high || lower_past_high);
}
static double value_about(double share, int64_t row, array_double_2d span)
{
    double result;
    result = (1.0 - share) * (*cspan_at(&span, row, INT64_C(0))) + share * (*cspan_at(&span, row, span.shape[INT64_C(1)] - INT64_C(1)));
    return result;
}
static double shared_height(double share, array_double_2d span, array_double_1d box)
{
    double top;
    double bottom;
    double upwards;
    int64_t axis;
    double place;
    double slope;
    double near;
    double far;
    top = span_min((*cspan_at(&box, INT64_C(9) + INT64_C(2))), 0.0);
    bottom = span_max((*cspan_at(&box, INT64_C(6) + INT64_C(2))), value_about(share, INT64_C(0) + INT64_C(2), span));
    upwards = value_about(share, INT64_C(6) + INT64_C(2), span);
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        place = value_about(share, INT64_C(3) + axis, span) / upwards;
        slope = value_about(share, INT64_C(6) + axis, span) / upwards;
        near = (*cspan_at(&box, INT64_C(6) + axis)) - place;
        far = (*cspan_at(&box, INT64_C(9) + axis)) - place;
        if (slope < 0.0)
        {
            near = (*cspan_at(&box, INT64_C(9) + axis)) - place;
            far = (*cspan_at(&box, INT64_C(6) + axis)) - place;
        }
        if (fabs(slope) * 1000000000000.0 > fabs(near))
        {
            bottom = span_max(bottom, near / slope);
        }
        if (fabs(slope) * 1000000000000.0 > fabs(far))
        {
            top = span_min(top, far / slope);
        }
    }
    return 0.5 * (bottom + top);
}
static bool is_within(double height, array_double_2d span, array_double_1d box)
{
    int64_t axis;
    int64_t i;
    double place;
    double upwards;
    bool result;
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < span.shape[INT64_C(1)]; i += INT64_C(1))
        {
            place = (*cspan_at(&span, INT64_C(3) + axis, i)) + height * (*cspan_at(&span, INT64_C(6) + axis, i));
            upwards = (*cspan_at(&span, INT64_C(6) + INT64_C(2), i));
            if (!(place - (*cspan_at(&box, INT64_C(6) + axis)) * upwards > 0.0))
            {
                return 0;
            }
            if (!(place - (*cspan_at(&box, INT64_C(9) + axis)) * upwards < 0.0))
            {
                return 0;
            }
        }
    }
    result = ((*cspan_at(&box, INT64_C(6) + INT64_C(2))) < height) && (height < (*cspan_at(&box, INT64_C(9) + INT64_C(2)))) && (height < 0.0);
    return result;
}
static int64_t rope_meeting(array_double_2d span, array_double_1d box)
{
    double least;
    double most;
    double top;
    double lowest;
    double highest;
    int64_t axis;
    int64_t left;
    int64_t right;
    double height;
    row_range(&least, &most, span, INT64_C(6) + INT64_C(2));
    top = span_min((*cspan_at(&box, INT64_C(9) + INT64_C(2))), 0.0);
    if ((most <= 1e-09) || ((*cspan_at(&box, INT64_C(6) + INT64_C(2))) >= top))
    {
        return INT64_C(0);
    }
    row_range(&lowest, &highest, span, INT64_C(0) + INT64_C(2));
    if (lowest >= top)
    {
        return INT64_C(0);
    }
    if (least <= 0.0)
    {
        return INT64_C(2);
    }
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        if (is_beside(axis, lowest, highest, top, span, box))
        {
            return INT64_C(0);
        }
    }
    count_edges(&left, &right, span, box);
    if ((left == INT64_C(4)) || (right == INT64_C(4)))
    {
        return INT64_C(0);
    }
    if (highest >= top)
    {
        return INT64_C(2);
    }
    if (is_across(INT64_C(0), lowest, highest, top, span, box) && is_across(INT64_C(1), lowest, highest, top, span, box) && (left > INT64_C(0)) && (right > INT64_C(0)))
    {
        return INT64_C(1);
    }
    height = shared_height(0.5, span, box);
    if ((highest < height) && is_within(height, span, box))
    {
        return INT64_C(1);
    }
    return INT64_C(2);
}
static bool part_moves(int64_t part, array_double_2d span)
{
    double rounding;
    int64_t axis;
    double least;
    double most;
    double slowest;
    double fastest;
    rounding = (*cspan_at(&span, INT64_C(9), INT64_C(4)));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        row_range(&least, &most, span, INT64_C(0) + axis);
        if (most - least > rounding)
        {
            return 1;
        }
    }
    if (part == INT64_C(1))
    {
        return 0;
    }
    row_range(&slowest, &fastest, span, INT64_C(6) + INT64_C(2));
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        row_range(&least, &most, span, INT64_C(3) + axis);
        if (most - least > rounding * slowest)
        {
            return 1;
        }
    }
    return 0;
}
static void polynomial_differentiate(array_double_1d a, int64_t count, int64_t order, array_double_1d found)
{
    int64_t i;
    double factor;
    int64_t j;
    for (i = INT64_C(0); i < count - order; i += INT64_C(1))
    {
        factor = 1.0;
        for (j = INT64_C(0); j < order; j += INT64_C(1))
        {
            factor = factor * (i + j + INT64_C(1));
        }
        (*cspan_at(&found, i)) = factor * (*cspan_at(&a, i + order));
    }
}
static void polynomial_add_product(array_double_1d a, int64_t a_count, array_double_1d b, int64_t b_count, array_double_1d found)
{
    int64_t i;
    int64_t j;
    for (i = INT64_C(0); i < a_count; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < b_count; j += INT64_C(1))
        {
            (*cspan_at(&found, i + j)) = (*cspan_at(&found, i + j)) + (*cspan_at(&a, i)) * (*cspan_at(&b, j));
        }
    }
}
static void polynomial_clear(array_double_1d found)
{
    int64_t i;
    for (i = INT64_C(0); i < found.shape[INT64_C(0)]; i += INT64_C(1))
    {
        (*cspan_at(&found, i)) = 0.0;
    }
}
static void polynomial_shift(array_double_1d a, double offset, int64_t count)
{
    int64_t i;
    int64_t j;
    int64_t k;
    for (i = INT64_C(0); i < count - INT64_C(1); i += INT64_C(1))
    {
        for (j = INT64_C(0); j < count - INT64_C(1) - i; j += INT64_C(1))
        {
            k = count - INT64_C(2) - j;
            (*cspan_at(&a, k)) = (*cspan_at(&a, k)) + offset * (*cspan_at(&a, k + INT64_C(1)));
        }
    }
}
static void rope_pull(double gravity, int64_t width, array_double_2d work)
{
    polynomial_differentiate(span_row(&work, INT64_C(0)), width, INT64_C(2), span_row(&work, INT64_C(3)));
    polynomial_differentiate(span_row(&work, INT64_C(0) + INT64_C(1)), width, INT64_C(2), span_row(&work, INT64_C(3) + INT64_C(1)));
    polynomial_differentiate(span_row(&work, INT64_C(0) + INT64_C(2)), width, INT64_C(2), span_row(&work, INT64_C(3) + INT64_C(2)));
    (*cspan_at(&work, INT64_C(3) + INT64_C(2), INT64_C(0))) = (*cspan_at(&work, INT64_C(3) + INT64_C(2), INT64_C(0))) + gravity;
}
static int64_t rope_margin(int64_t demand, double bound, int64_t width, array_double_2d work)
{
    array_double_1d z;
    array_double_1d w_x;
    array_double_1d w_y;
    array_double_1d w_z;
    array_double_1d margin;
    array_double_1d product_0;
    array_double_1d product_1;
    array_double_1d product_2;
    int64_t i;
    double sign;
    z = span_row(&work, INT64_C(0) + INT64_C(2));
    w_x = span_row(&work, INT64_C(3));
    w_y = span_row(&work, INT64_C(3) + INT64_C(1));
    w_z = span_row(&work, INT64_C(3) + INT64_C(2));
    margin = span_row(&work, INT64_C(6));
    product_0 = span_row(&work, INT64_C(7));
    product_1 = span_row(&work, INT64_C(7) + INT64_C(1));
    product_2 = span_row(&work, INT64_C(7) + INT64_C(2));
    if (demand == INT64_C(1))
    {
        for (i = INT64_C(0); i < width; i += INT64_C(1))
        {
            (*cspan_at(&margin, i)) = -(*cspan_at(&z, i));
        }
        (*cspan_at(&margin, INT64_C(0))) = (*cspan_at(&margin, INT64_C(0))) - bound;
        return width;
    }
    if (demand == INT64_C(2))
    {
        for (i = INT64_C(0); i < width - INT64_C(2); i += INT64_C(1))
        {
            (*cspan_at(&margin, i)) = (*cspan_at(&w_z, i));
        }
        (*cspan_at(&margin, INT64_C(0))) = (*cspan_at(&margin, INT64_C(0))) - bound;
        return width - INT64_C(2);
    }
    polynomial_clear(product_0);
    polynomial_add_product(w_z, width - INT64_C(2), w_z, width - INT64_C(2), product_0);
    polynomial_clear(product_1);
    polynomial_add_product(z, width, z, width, product_1);
    polynomial_clear(product_2);
    polynomial_add_product(w_x, width - INT64_C(2), w_x, width - INT64_C(2), product_2);
    polynomial_add_product(w_y, width - INT64_C(2), w_y, width - INT64_C(2), product_2);
    polynomial_add_product(w_z, width - INT64_C(2), w_z, width - INT64_C(2), product_2);
    polynomial_clear(margin);
    polynomial_add_product(product_1, INT64_C(2) * width - INT64_C(1), product_2, INT64_C(2) * width - INT64_C(5), margin);
    sign = 1.0;
    if (demand == INT64_C(4))
    {
        sign = -1.0;
    }
    for (i = INT64_C(0); i < INT64_C(4) * width - INT64_C(7); i += INT64_C(1))
    {
        (*cspan_at(&margin, i)) = sign * (bound * bound * (*cspan_at(&product_0, i)) - (*cspan_at(&margin, i)));
    }
    return INT64_C(4) * width - INT64_C(7);
}
static double rope_value(int64_t demand, double gravity, double z, double w_x, double w_y, double w_z)
{
    if (demand == INT64_C(1))
    {
        return z;
    }
    if (demand == INT64_C(2))
    {
        return gravity - w_z;
    }
    return (-z) * sqrt(w_x * w_x + w_y * w_y + w_z * w_z) / w_z;
}
static int64_t find_piece(double time, array_double_2d timing, int64_t first, int64_t last)
{
    int64_t upper;
    int64_t middle;
    int64_t lower;
    lower = first;
    upper = last;
    while(upper - lower > INT64_C(1))
    {
        middle = span_floor_div((lower + upper), INT64_C(2));
        if (time >= (*cspan_at(&timing, middle, INT64_C(0))))
        {
            lower = middle;
        }
        else
        {
            upper = middle;
        }
    }
    return lower;
}
static double evaluate_piece(array_double_2d coefficients, int64_t row, int64_t width, double t, int64_t derivative)
{
    int64_t j;
    int64_t i;
    double factor;
    int64_t m;
    double value;
    value = 0.0;
    for (j = INT64_C(0); j < width - derivative; j += INT64_C(1))
    {
        i = width - INT64_C(1) - j;
        factor = 1.0;
        for (m = INT64_C(0); m < derivative; m += INT64_C(1))
        {
            factor = factor * (i - m);
        }
        value = value * t + factor * (*cspan_at(&coefficients, row, i));
    }
    return value;
}
static double local_time(double time, array_double_2d timing, int64_t row)
{
    double result;
    result = span_min(time - (*cspan_at(&timing, row, INT64_C(0))), (*cspan_at(&timing, row, INT64_C(1))));
    return result;
}
void segfmu_evaluate(array_double_1d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, int64_t derivative, array_double_2d values)
{
    int64_t width;
    int64_t axis;
    int64_t first;
    int64_t last;
    int64_t row;
    int64_t i;
    double t;
    bool behind;
    double local;
    width = coefficients.shape[INT64_C(1)];
    for (axis = INT64_C(0); axis < ends.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        first = (*cspan_at(&offsets, axis));
        last = (*cspan_at(&offsets, axis + INT64_C(1)));
        row = first;
        for (i = INT64_C(0); i < times.shape[INT64_C(0)]; i += INT64_C(1))
        {
            t = span_min(span_max((*cspan_at(&times, i)), (*cspan_at(&timing, first, INT64_C(0)))), (*cspan_at(&ends, axis)));
            behind = (row + INT64_C(1) < last) && (t >= (*cspan_at(&timing, row + INT64_C(1), INT64_C(0))));
            if ((t < (*cspan_at(&timing, row, INT64_C(0)))) || behind)
            {
                row = find_piece(t, timing, first, last);
            }
            if ((derivative > INT64_C(0)) && (t != (*cspan_at(&times, i))))
            {
                (*cspan_at(&values, i, axis)) = 0.0;
            }
            else
            {
                local = local_time(t, timing, row);
                (*cspan_at(&values, i, axis)) = evaluate_piece(coefficients, row, width, local, derivative);
            }
        }
    }
}
void segfmu_evaluate_orders(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d values)
{
    int64_t width;
    int64_t axis;
    double t;
    int64_t row;
    double local;
    int64_t derivative;
    width = coefficients.shape[INT64_C(1)];
    for (axis = INT64_C(0); axis < ends.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        t = span_min(span_max(time, (*cspan_at(&timing, (*cspan_at(&offsets, axis)), INT64_C(0)))), (*cspan_at(&ends, axis)));
        row = find_piece(t, timing, (*cspan_at(&offsets, axis)), (*cspan_at(&offsets, axis + INT64_C(1))));
        local = local_time(t, timing, row);
        for (derivative = INT64_C(0); derivative < values.shape[INT64_C(0)]; derivative += INT64_C(1))
        {
            if ((derivative > INT64_C(0)) && (t != time))
            {
                (*cspan_at(&values, derivative, axis)) = 0.0;
            }
            else
            {
                (*cspan_at(&values, derivative, axis)) = evaluate_piece(coefficients, row, width, local, derivative);
            }
        }
    }
}
static void bernstein_coefficients(array_double_2d coefficients, int64_t row, int64_t count, double length, array_double_2d hull)
{
    double power;
    double binomial;
    int64_t i;
    int64_t r;
    int64_t j;
    power = 1.0;
    binomial = 1.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&hull, INT64_C(0), i)) = (*cspan_at(&coefficients, row, i)) * power / binomial;
        power = power * length;
        binomial = binomial * (count - INT64_C(1) - i) / (i + INT64_C(1));
    }
    for (r = INT64_C(1); r < count; r += INT64_C(1))
    {
        for (j = INT64_C(0); j < count - r; j += INT64_C(1))
        {
            i = count - INT64_C(1) - j;
            (*cspan_at(&hull, INT64_C(0), i)) = (*cspan_at(&hull, INT64_C(0), i)) + (*cspan_at(&hull, INT64_C(0), i - INT64_C(1)));
        }
    }
}
static double integrate_hull(int64_t count, double start, double length, array_double_1d values)
{
    double value;
    double step;
    int64_t i;
    double gain;
    double largest;
    value = start;
    largest = fabs(start);
    step = length / span_max_int(count, INT64_C(1));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        gain = step * (*cspan_at(&values, i));
        (*cspan_at(&values, i)) = value;
        value = value + gain;
        largest = span_max(largest, fabs(value));
    }
    (*cspan_at(&values, count)) = value;
    return largest;
}
static void split_hull(array_double_2d hull, int64_t row, int64_t count)
{
    int64_t i;
    int64_t r;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&hull, row + INT64_C(1), i)) = (*cspan_at(&hull, row, i));
    }
    for (r = INT64_C(1); r < count; r += INT64_C(1))
    {
        for (i = INT64_C(0); i < count - r; i += INT64_C(1))
        {
            (*cspan_at(&hull, row + INT64_C(1), i)) = 0.5 * ((*cspan_at(&hull, row + INT64_C(1), i)) + (*cspan_at(&hull, row + INT64_C(1), i + INT64_C(1))));
        }
        (*cspan_at(&hull, row, r)) = (*cspan_at(&hull, row + INT64_C(1), INT64_C(0)));
    }
}
static bool within(array_double_2d hull, int64_t count, double lowest, double highest)
{
    int64_t rows;
    int64_t row;
    bool inside;
    int64_t i;
    double depth;
    double last;
    bool ends;
    rows = INT64_C(1);
    (*cspan_at(&hull, INT64_C(0), INT64_C(13))) = 0.0;
    while(rows > INT64_C(0))
    {
        row = rows - INT64_C(1);
        inside = 1;
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            inside = inside && (lowest <= (*cspan_at(&hull, row, i))) && ((*cspan_at(&hull, row, i)) <= highest);
        }
        if (inside)
        {
            rows = rows - INT64_C(1);
            continue;
        }
        depth = (*cspan_at(&hull, row, INT64_C(13)));
        last = (*cspan_at(&hull, row, count - INT64_C(1)));
        ends = (lowest <= (*cspan_at(&hull, row, INT64_C(0)))) && ((*cspan_at(&hull, row, INT64_C(0))) <= highest);
        ends = ends && (lowest <= last) && (last <= highest);
        if ((!ends) || (depth > 34.0))
        {
            return 0;
        }
        split_hull(hull, row, count);
        (*cspan_at(&hull, row, INT64_C(13))) = depth + 1.0;
        (*cspan_at(&hull, row + INT64_C(1), INT64_C(13))) = depth + 1.0;
        rows = rows + INT64_C(1);
    }
    return 1;
}
static double least_peak(int64_t order, array_double_1d limits)
{
    double below;
    double limit;
    int64_t i;
    double before;
    below = (*cspan_at(&limits, INT64_C(0)));
    limit = (*cspan_at(&limits, INT64_C(0)));
    for (i = INT64_C(1); i < order; i += INT64_C(1))
    {
        before = limit;
        limit = (*cspan_at(&limits, i));
        if (limit <= 0.0)
        {
            limit = before * before / below;
        }
        below = before;
    }
    return 1e-05 * limit;
}
static double least_distance(array_double_1d limits)
{
    double scale;
    double ramp;
    int64_t order;
    double square;
    scale = (*cspan_at(&limits, INT64_C(0))) * (*cspan_at(&limits, INT64_C(0))) / (*cspan_at(&limits, INT64_C(1)));
    ramp = 0.0;
    for (order = INT64_C(2); order < span_min_int(limits.shape[INT64_C(0)], INT64_C(4)); order += INT64_C(1))
    {
        if ((*cspan_at(&limits, order)) > 0.0)
        {
            square = (*cspan_at(&limits, INT64_C(1))) / (*cspan_at(&limits, order));
            if (order == INT64_C(2))
            {
                square = square * square;
            }
            ramp = span_max(ramp, (*cspan_at(&limits, INT64_C(1))) * square);
        }
    }
    if (ramp > 0.0)
    {
        scale = span_min(scale, 1000.0 * ramp);
    }
    return 1e-09 * scale;
}
static double reached_limit(int64_t order, double duration, array_double_1d limits)
{
    int64_t j;
    double change;
    double reached;
    reached = 0.0;
    for (j = INT64_C(0); j < limits.shape[INT64_C(0)] - order + INT64_C(1); j += INT64_C(1))
    {
        change = reached * duration;
        reached = (*cspan_at(&limits, limits.shape[INT64_C(0)] - INT64_C(1) - j));
        if ((reached <= 0.0) || ((change > 0.0) && (change < reached)))
        {
            reached = change;
        }
    }
    return reached;
}
double segfmu_state_scale(int64_t order, double duration, array_double_1d limits)
{
    double result;
    if (order == INT64_C(0))
    {
        result = reached_limit(INT64_C(1), duration, limits) * duration + least_distance(limits);
        return result;
    }
    result = span_max(least_peak(order, limits), reached_limit(order, duration, limits));
    return result;
}
static double rounding_error(int64_t order, array_double_1d limits)
{
    double result;
    result = 4e-10 * least_peak(order, limits);
    return result;
}
static void keep_inside(array_double_2d work)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(27); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(47), i)) = 0.0;
    }
}
static void set_bounds(double middle, array_double_1d limits, array_double_1d lower, array_double_2d work)
{
    array_double_1d report;
    int64_t d;
    double lowest;
    double highest;
    report = span_row(&work, INT64_C(47));
    for (d = INT64_C(1); d < limits.shape[INT64_C(0)] + INT64_C(1); d += INT64_C(1))
    {
        lowest = -(*cspan_at(&limits, d - INT64_C(1)));
        highest = (*cspan_at(&limits, d - INT64_C(1)));
        if ((d <= INT64_C(2)) && ((*cspan_at(&lower, d - INT64_C(1))) > 0.0))
        {
            lowest = -(*cspan_at(&lower, d - INT64_C(1)));
        }
        if ((highest > 0.0) && (middle < (*cspan_at(&report, INT64_C(0)))))
        {
            lowest = span_min(lowest, (*cspan_at(&report, INT64_C(11) + d)));
            highest = span_max(highest, (*cspan_at(&report, INT64_C(19) + d)));
        }
        (*cspan_at(&work, INT64_C(45), d)) = lowest;
        (*cspan_at(&work, INT64_C(46), d)) = highest;
    }
}
static void note_ends(int64_t d, bool joined, double start, double end, double largest, array_double_2d work)
{
    double jump;
    (*cspan_at(&work, INT64_C(41), d)) = span_max((*cspan_at(&work, INT64_C(41), d)), largest);
    if (joined)
    {
        jump = fabs(start - (*cspan_at(&work, INT64_C(40), d)));
        (*cspan_at(&work, INT64_C(42), d)) = span_max((*cspan_at(&work, INT64_C(42), d)), jump);
    }
    (*cspan_at(&work, INT64_C(40), d)) = end;
}
static bool check_piece(int64_t order, int64_t row, bool joined, double length, array_double_2d coefficients, double tolerance, array_double_2d work)
{
    array_double_1d values;
    int64_t degree;
    int64_t d;
    array_double_1d starts;
    double factorial;
    int64_t count;
    double start;
    double largest;
    double lowest;
    double highest;
    array_double_2d hull;
    int64_t i;
    double share;
    values = span_row(&work, INT64_C(43));
    degree = coefficients.shape[INT64_C(1)] - INT64_C(1);
    while((degree > INT64_C(0)) && ((*cspan_at(&coefficients, row, degree)) == 0.0))
    {
        degree = degree - INT64_C(1);
    }
    for (d = degree + INT64_C(1); d < order + INT64_C(1); d += INT64_C(1))
    {
        note_ends(d, joined, 0.0, 0.0, 0.0, work);
    }
    starts = span_row(&work, INT64_C(44));
    factorial = 1.0;
    for (d = INT64_C(0); d < degree + INT64_C(1); d += INT64_C(1))
    {
        if (d > INT64_C(1))
        {
            factorial = factorial * d;
        }
        (*cspan_at(&starts, d)) = (*cspan_at(&coefficients, row, d)) * factorial;
    }
    for (count = INT64_C(0); count < degree + INT64_C(1); count += INT64_C(1))
    {
        d = degree - count;
        start = (*cspan_at(&starts, d));
        largest = integrate_hull(count, start, length, values);
        if (!(fabs((*cspan_at(&values, count))) < 1e+300))
        {
            return 0;
        }
        if (d <= order)
        {
            note_ends(d, joined, start, (*cspan_at(&values, count)), largest, work);
            lowest = (*cspan_at(&work, INT64_C(45), d));
            highest = (*cspan_at(&work, INT64_C(46), d));
            if ((d > INT64_C(0)) && (highest > 0.0))
            {
                if (largest > span_min(-lowest, highest) * (1.0 + tolerance))
                {
                    hull = span_rows(&work, INT64_C(0), INT64_C(40));
                    for (i = INT64_C(0); i < count + INT64_C(1); i += INT64_C(1))
                    {
                        (*cspan_at(&hull, INT64_C(0), i)) = (*cspan_at(&values, i));
                    }
                    share = 1.0 + tolerance;
                    if (!within(hull, count + INT64_C(1), lowest * share, highest * share))
                    {
                        return 0;
                    }
                }
            }
        }
    }
    return 1;
}
static bool check_axis(int64_t first, int64_t last, array_double_2d timing, array_double_2d coefficients, array_double_1d limits, array_double_1d lower, double tolerance, double joints, array_double_2d work)
{
    int64_t order;
    int64_t i;
    double low;
    double high;
    int64_t row;
    double length;
    double middle;
    double least;
    int64_t d;
    bool result;
    order = limits.shape[INT64_C(0)];
    for (i = INT64_C(0); i < INT64_C(14); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(41), i)) = 0.0;
        (*cspan_at(&work, INT64_C(42), i)) = 0.0;
    }
    low = (*cspan_at(&coefficients, first, INT64_C(0)));
    high = low;
    for (row = first; row < last; row += INT64_C(1))
    {
        low = span_min(low, (*cspan_at(&coefficients, row, INT64_C(0))));
        high = span_max(high, (*cspan_at(&coefficients, row, INT64_C(0))));
        length = (*cspan_at(&timing, row, INT64_C(1)));
        middle = (*cspan_at(&timing, row, INT64_C(0))) + 0.5 * length;
        set_bounds(middle, limits, lower, work);
        if (!check_piece(order, row, row > first, length, coefficients, tolerance, work))
        {
            return 0;
        }
    }
    low = span_min(low, (*cspan_at(&work, INT64_C(40), INT64_C(0))));
    high = span_max(high, (*cspan_at(&work, INT64_C(40), INT64_C(0))));
    least = least_distance(limits);
    (*cspan_at(&work, INT64_C(41), INT64_C(0))) = span_max(span_max(high - low, least), 1e-05 * span_max(-low, high));
    for (d = INT64_C(1); d < order; d += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(41), d)) = span_max((*cspan_at(&work, INT64_C(41), d)), least_peak(d, limits));
    }
    for (d = INT64_C(0); d < order; d += INT64_C(1))
    {
        if (!((*cspan_at(&work, INT64_C(42), d)) <= joints * (*cspan_at(&work, INT64_C(41), d))))
        {
            return 0;
        }
    }
    result = (*cspan_at(&work, INT64_C(41), INT64_C(0))) < 1e+300;
    return result;
}
static double switching_time(double time, double duration, array_double_2d timing, int64_t row)
{
    double length;
    double same;
    double local;
    length = (*cspan_at(&timing, row, INT64_C(1)));
    local = local_time(time, timing, row);
    same = 1e-12 * duration;
    if (local < length - local)
    {
        if (local < same)
        {
            local = 0.0;
        }
    }
    else if (local > length - same)
    {
        local = length;
    }
    return local;
}
static bool check_motion(int64_t axis, array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, double tolerance, double joints, array_double_2d work)
{
    int64_t width;
    int64_t points;
    int64_t first;
    int64_t last;
    double duration;
    int64_t j;
    int64_t point;
    int64_t row;
    double local;
    int64_t d;
    double value;
    double scale;
    width = coefficients.shape[INT64_C(1)];
    points = states.shape[INT64_C(0)];
    first = (*cspan_at(&offsets, axis));
    last = (*cspan_at(&offsets, axis + INT64_C(1)));
    if (!check_axis(first, last, timing, coefficients, span_row(&limits, axis), span_row(&lower, axis), tolerance, joints, work))
    {
        return 0;
    }
    duration = (*cspan_at(&times, points, axis)) - (*cspan_at(&times, INT64_C(0), axis));
    for (j = INT64_C(0); j < points + INT64_C(1); j += INT64_C(1))
    {
        point = span_min_int(j, points - INT64_C(1));
        row = find_piece((*cspan_at(&times, j, axis)), timing, first, last);
        local = switching_time((*cspan_at(&times, j, axis)), (*cspan_at(&times, points, axis)), timing, row);
        for (d = INT64_C(0); d < states.shape[INT64_C(2)]; d += INT64_C(1))
        {
            value = evaluate_piece(coefficients, row, width, local, d);
            scale = (*cspan_at(&work, INT64_C(41), d));
            if ((d > INT64_C(0)) && ((*cspan_at(&limits, axis, d - INT64_C(1))) > 0.0))
            {
                scale = span_max(scale, segfmu_state_scale(d, duration, span_row(&limits, axis)));
            }
            if (!(fabs(value - (*cspan_at(&states, point, axis, d))) <= joints * scale))
            {
                return 0;
            }
        }
    }
    return 1;
}
int64_t segfmu_check_plan(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, double tolerance, double joints, array_double_2d work)
{
    int64_t axis;
    keep_inside(work);
    for (axis = INT64_C(0); axis < limits.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        if (!check_motion(axis, states, times, timing, coefficients, offsets, limits, lower, tolerance, joints, work))
        {
            return INT64_C(1) + axis;
        }
    }
    return INT64_C(0);
}
int64_t segfmu_check_braked_plan(array_double_3d states, array_double_2d times, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d limits, array_double_2d lower, array_double_2d brakes, double tolerance, double joints, array_double_2d work)
{
    int64_t axis;
    int64_t i;
    for (axis = INT64_C(0); axis < limits.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(27); i += INT64_C(1))
        {
            (*cspan_at(&work, INT64_C(47), i)) = (*cspan_at(&brakes, axis, i));
        }
        if (!check_motion(axis, states, times, timing, coefficients, offsets, limits, lower, tolerance, joints, work))
        {
            return INT64_C(1) + axis;
        }
    }
    return INT64_C(0);
}
static double interval_end(double time, array_double_2d timing, array_int64_t_1d offsets)
{
    int64_t axis;
    int64_t last;
    int64_t row;
    double end;
    double until;
    until = time;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        last = (*cspan_at(&offsets, axis + INT64_C(1)));
        row = find_piece(time, timing, (*cspan_at(&offsets, axis)), last);
        end = (*cspan_at(&timing, row, INT64_C(0))) + (*cspan_at(&timing, row, INT64_C(1)));
        if (row + INT64_C(1) < last)
        {
            end = (*cspan_at(&timing, row + INT64_C(1), INT64_C(0)));
        }
        if ((end > time) && ((until == time) || (end < until)))
        {
            until = end;
        }
    }
    return until;
}
static void interval_pieces(double time, double until, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work)
{
    int64_t width;
    double middle;
    int64_t axis;
    int64_t last;
    int64_t row;
    array_double_1d piece;
    int64_t i;
    width = coefficients.shape[INT64_C(1)];
    middle = 0.5 * (time + until);
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        last = (*cspan_at(&offsets, axis + INT64_C(1)));
        row = find_piece(middle, timing, (*cspan_at(&offsets, axis)), last);
        piece = span_row(&work, INT64_C(0) + axis);
        for (i = INT64_C(0); i < width; i += INT64_C(1))
        {
            (*cspan_at(&piece, i)) = (*cspan_at(&coefficients, row, i));
        }
        if (middle > (*cspan_at(&timing, row, INT64_C(0))) + (*cspan_at(&timing, row, INT64_C(1))))
        {
            (*cspan_at(&piece, INT64_C(0))) = evaluate_piece(coefficients, row, width, (*cspan_at(&timing, row, INT64_C(1))), INT64_C(0));
            for (i = INT64_C(1); i < width; i += INT64_C(1))
            {
                (*cspan_at(&piece, i)) = 0.0;
            }
        }
        else
        {
            polynomial_shift(piece, time - (*cspan_at(&timing, row, INT64_C(0))), width);
        }
    }
    rope_pull(gravity, width, work);
}
static double demand_bound(int64_t demand, array_double_1d bounds)
{
    double result;
    if (demand == INT64_C(2))
    {
        result = (*cspan_at(&bounds, INT64_C(0)));
        return result;
    }
    if (demand == INT64_C(3))
    {
        result = (*cspan_at(&bounds, INT64_C(2)));
        return result;
    }
    if (demand == INT64_C(4))
    {
        result = (*cspan_at(&bounds, INT64_C(1)));
        return result;
    }
    return 0.0;
}
static int64_t rope_demand(int64_t demand, array_double_1d bounds, int64_t width, array_double_2d work)
{
    double tolerance;
    double bound;
    int64_t result;
    tolerance = 1e-09;
    bound = demand_bound(demand, bounds);
    if (demand == INT64_C(1))
    {
        result = rope_margin(demand, tolerance, width, work);
        return result;
    }
    if (demand == INT64_C(2))
    {
        result = rope_margin(demand, tolerance * bound, width, work);
        return result;
    }
    if (bound <= 0.0)
    {
        return INT64_C(0);
    }
    if (demand == INT64_C(3))
    {
        result = rope_margin(demand, bound * (1.0 + tolerance), width, work);
        return result;
    }
    result = rope_margin(demand, bound * (1.0 - tolerance), width, work);
    return result;
}
static double first_negative(int64_t count, double length, array_double_2d work)
{
    int64_t start;
    int64_t depth;
    array_double_2d hull;
    int64_t i;
    double swapped;
    int64_t rows;
    int64_t row;
    double smallest;
    double result;
    start = work.shape[INT64_C(1)] - INT64_C(2);
    depth = work.shape[INT64_C(1)] - INT64_C(1);
    hull = span_rows(&work, INT64_C(10), work.shape[INT64_C(0)]);
    bernstein_coefficients(work, INT64_C(6), count, length, hull);
    for (i = INT64_C(0); i < span_floor_div(count, INT64_C(2)); i += INT64_C(1))
    {
        swapped = (*cspan_at(&hull, INT64_C(0), i));
        (*cspan_at(&hull, INT64_C(0), i)) = (*cspan_at(&hull, INT64_C(0), count - INT64_C(1) - i));
        (*cspan_at(&hull, INT64_C(0), count - INT64_C(1) - i)) = swapped;
    }
    (*cspan_at(&hull, INT64_C(0), start)) = 0.0;
    (*cspan_at(&hull, INT64_C(0), depth)) = 0.0;
    rows = INT64_C(1);
    while(rows > INT64_C(0))
    {
        row = rows - INT64_C(1);
        smallest = (*cspan_at(&hull, row, INT64_C(0)));
        for (i = INT64_C(1); i < count; i += INT64_C(1))
        {
            smallest = span_min(smallest, (*cspan_at(&hull, row, i)));
        }
        if (smallest >= 0.0)
        {
            rows = row;
        }
        else if (((*cspan_at(&hull, row, count - INT64_C(1))) < 0.0) || ((*cspan_at(&hull, row, depth)) > 39.5))
        {
            result = (*cspan_at(&hull, row, start));
            return result;
        }
        else
        {
            split_hull(hull, row, count);
            (*cspan_at(&hull, row + INT64_C(1), start)) = (*cspan_at(&hull, row, start));
            (*cspan_at(&hull, row, depth)) = (*cspan_at(&hull, row, depth)) + 1.0;
            (*cspan_at(&hull, row + INT64_C(1), depth)) = (*cspan_at(&hull, row, depth));
            (*cspan_at(&hull, row, start)) = (*cspan_at(&hull, row, start)) + pow(0.5, (*cspan_at(&hull, row, depth)));
            rows = rows + INT64_C(1);
        }
    }
    return -1.0;
}
static double value_at(int64_t demand, double local, double gravity, int64_t width, array_double_2d work)
{
    double z;
    double w_x;
    double w_y;
    double w_z;
    z = evaluate_piece(work, INT64_C(0) + INT64_C(2), width, local, INT64_C(0));
    w_x = evaluate_piece(work, INT64_C(3), width - INT64_C(2), local, INT64_C(0));
    w_y = evaluate_piece(work, INT64_C(3) + INT64_C(1), width - INT64_C(2), local, INT64_C(0));
    w_z = evaluate_piece(work, INT64_C(3) + INT64_C(2), width - INT64_C(2), local, INT64_C(0));
    return rope_value(demand, gravity, z, w_x, w_y, w_z);
}
static double worst_value(int64_t demand, double first, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work)
{
    double gravity;
    int64_t width;
    double sign;
    double worst;
    double time;
    double until;
    int64_t intervals;
    int64_t i;
    double local;
    gravity = (*cspan_at(&bounds, INT64_C(0)));
    width = coefficients.shape[INT64_C(1)];
    sign = 1.0;
    if (demand == INT64_C(4))
    {
        sign = -1.0;
    }
    worst = -1e+300;
    time = (*cspan_at(&timing, (*cspan_at(&offsets, INT64_C(0))), INT64_C(0)));
    until = interval_end(time, timing, offsets);
    intervals = INT64_C(0);
    while((until > time) || (intervals == INT64_C(0)))
    {
        intervals = intervals + INT64_C(1);
        if (until >= first)
        {
            interval_pieces(time, until, timing, coefficients, offsets, gravity, work);
            for (i = INT64_C(0); i < INT64_C(33); i += INT64_C(1))
            {
                local = span_max((until - time) * i / 32.0, first - time);
                worst = span_max(worst, sign * value_at(demand, local, gravity, width, work));
            }
        }
        time = until;
        until = interval_end(time, timing, offsets);
    }
    return sign * worst;
}
int64_t segfmu_check_rope(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d bounds, array_double_2d work, array_double_1d report)
{
    int64_t none;
    double time;
    double until;
    int64_t intervals;
    int64_t demand;
    int64_t count;
    double share;
    int64_t failed;
    none = INT64_C(4) + INT64_C(1);
    time = (*cspan_at(&timing, (*cspan_at(&offsets, INT64_C(0))), INT64_C(0)));
    until = interval_end(time, timing, offsets);
    failed = none;
    intervals = INT64_C(0);
    while((until > time) || (intervals == INT64_C(0)))
    {
        intervals = intervals + INT64_C(1);
        interval_pieces(time, until, timing, coefficients, offsets, (*cspan_at(&bounds, INT64_C(0))), work);
        for (demand = INT64_C(1); demand < failed; demand += INT64_C(1))
        {
            count = rope_demand(demand, bounds, coefficients.shape[INT64_C(1)], work);
            if (count > INT64_C(0))
            {
                share = first_negative(count, until - time, work);
                if (share >= 0.0)
                {
                    failed = demand;
                    (*cspan_at(&report, INT64_C(0))) = time + share * (until - time);
                    break;
                }
            }
        }
        time = until;
        until = interval_end(time, timing, offsets);
    }
    if (failed == none)
    {
        return INT64_C(0);
    }
    (*cspan_at(&report, INT64_C(1))) = worst_value(failed, (*cspan_at(&report, INT64_C(0))), timing, coefficients, offsets, bounds, work);
    (*cspan_at(&report, INT64_C(2))) = demand_bound(failed, bounds);
    return failed;
}
static void write_row(int64_t source, int64_t count, double length, int64_t row, array_double_2d work, array_double_2d span)
{
    int64_t columns;
    array_double_2d part;
    int64_t i;
    columns = span.shape[INT64_C(1)];
    part = span_rows(&span, row, row + INT64_C(1));
    for (i = INT64_C(0); i < columns; i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(6), i)) = 0.0;
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(6), i)) = (*cspan_at(&work, source, i));
    }
    bernstein_coefficients(work, INT64_C(6), columns, length, part);
}
static void write_difference(int64_t first, int64_t pull, int64_t second, int64_t other, double length, int64_t row, array_double_2d work, array_double_2d span)
{
    int64_t width;
    array_double_1d product;
    array_double_1d taken;
    int64_t i;
    width = span_floor_div((span.shape[INT64_C(1)] + INT64_C(3)), INT64_C(2));
    product = span_row(&work, INT64_C(7));
    taken = span_row(&work, INT64_C(7) + INT64_C(1));
    polynomial_clear(product);
    polynomial_clear(taken);
    polynomial_add_product(span_row(&work, INT64_C(0) + first), width, span_row(&work, INT64_C(3) + pull), width - INT64_C(2), product);
    polynomial_add_product(span_row(&work, INT64_C(0) + second), width, span_row(&work, INT64_C(3) + other), width - INT64_C(2), taken);
    for (i = INT64_C(0); i < INT64_C(2) * width - INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&product, i)) = (*cspan_at(&product, i)) - (*cspan_at(&taken, i));
    }
    write_row(INT64_C(7), INT64_C(2) * width - INT64_C(3), length, row, work, span);
}
static void note_rounding(array_double_2d span)
{
    double place;
    double pull;
    int64_t i;
    int64_t axis;
    place = 0.0;
    pull = 0.0;
    for (i = INT64_C(0); i < span.shape[INT64_C(1)]; i += INT64_C(1))
    {
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            place = span_max(place, fabs((*cspan_at(&span, INT64_C(0) + axis, i))));
        }
        for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
        {
            pull = span_max(pull, fabs((*cspan_at(&span, INT64_C(6) + axis, i))));
        }
    }
    (*cspan_at(&span, INT64_C(9), INT64_C(3))) = 1e-14 * place * pull;
    (*cspan_at(&span, INT64_C(9), INT64_C(4))) = 1e-12 * place;
}
static void write_span(int64_t part, double time, double until, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work, array_double_2d span)
{
    int64_t width;
    int64_t axis;
    int64_t i;
    double pull;
    int64_t row;
    width = coefficients.shape[INT64_C(1)];
    interval_pieces(time, until, timing, coefficients, offsets, gravity, work);
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < width - INT64_C(2); i += INT64_C(1))
        {
            pull = (*cspan_at(&work, INT64_C(3) + axis, i));
            (*cspan_at(&work, INT64_C(3) + axis, i)) = pull / gravity;
        }
    }
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        write_row(INT64_C(0) + axis, width, until - time, INT64_C(0) + axis, work, span);
        write_row(INT64_C(3) + axis, width - INT64_C(2), until - time, INT64_C(6) + axis, work, span);
    }
    if (part == INT64_C(2))
    {
        for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
        {
            write_difference(axis, INT64_C(2), INT64_C(2), axis, until - time, INT64_C(3) + axis, work, span);
        }
        write_difference(INT64_C(0), INT64_C(1), INT64_C(1), INT64_C(0), until - time, INT64_C(5), work, span);
    }
    else
    {
        for (row = INT64_C(3); row < INT64_C(6); row += INT64_C(1))
        {
            for (i = INT64_C(0); i < span.shape[INT64_C(1)]; i += INT64_C(1))
            {
                (*cspan_at(&span, row, i)) = 0.0;
            }
        }
    }
    (*cspan_at(&span, INT64_C(9), INT64_C(0))) = time;
    (*cspan_at(&span, INT64_C(9), INT64_C(1))) = until - time;
    (*cspan_at(&span, INT64_C(9), INT64_C(2))) = 0.0;
    note_rounding(span);
}
int64_t segfmu_clearance_spans(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work, array_double_3d spans)
{
    double time;
    double until;
    int64_t count;
    count = INT64_C(0);
    time = (*cspan_at(&timing, (*cspan_at(&offsets, INT64_C(0))), INT64_C(0)));
    until = interval_end(time, timing, offsets);
    while((until > time) || (count == INT64_C(0)))
    {
        write_span(INT64_C(2), time, until, timing, coefficients, offsets, gravity, work, span_matrix(&spans, count));
        count = count + INT64_C(1);
        time = until;
        until = interval_end(time, timing, offsets);
    }
    return count;
}
static void halve_span(int64_t row, array_double_3d stack)
{
    int64_t count;
    array_double_2d span;
    array_double_2d first;
    int64_t k;
    int64_t r;
    int64_t i;
    double half;
    count = stack.shape[INT64_C(2)];
    span = span_matrix(&stack, row);
    first = span_matrix(&stack, row + INT64_C(1));
    for (k = INT64_C(0); k < INT64_C(9); k += INT64_C(1))
    {
        for (r = INT64_C(0); r < count; r += INT64_C(1))
        {
            (*cspan_at(&first, k, r)) = (*cspan_at(&span, k, INT64_C(0)));
            for (i = INT64_C(0); i < count - INT64_C(1) - r; i += INT64_C(1))
            {
                (*cspan_at(&span, k, i)) = 0.5 * ((*cspan_at(&span, k, i)) + (*cspan_at(&span, k, i + INT64_C(1))));
            }
        }
    }
    half = 0.5 * (*cspan_at(&span, INT64_C(9), INT64_C(1)));
    (*cspan_at(&first, INT64_C(9), INT64_C(0))) = (*cspan_at(&span, INT64_C(9), INT64_C(0)));
    (*cspan_at(&span, INT64_C(9), INT64_C(0))) = (*cspan_at(&span, INT64_C(9), INT64_C(0))) + half;
    (*cspan_at(&span, INT64_C(9), INT64_C(2))) = (*cspan_at(&span, INT64_C(9), INT64_C(2))) + 1.0;
    for (i = INT64_C(2); i < INT64_C(4) + INT64_C(1); i += INT64_C(1))
    {
        (*cspan_at(&first, INT64_C(9), i)) = (*cspan_at(&span, INT64_C(9), i));
    }
    (*cspan_at(&span, INT64_C(9), INT64_C(1))) = half;
    (*cspan_at(&first, INT64_C(9), INT64_C(1))) = half;
}
static int64_t part_meeting(int64_t part, array_double_2d span, array_double_1d box)
{
    int64_t result;
    if (part == INT64_C(1))
    {
        result = load_meeting(span, box);
        return result;
    }
    result = rope_meeting(span, box);
    return result;
}
static void note_place(int64_t part, array_double_2d span, array_double_1d box, array_double_1d place)
{
    int64_t axis;
    double upwards;
    double height;
    double rope;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        (*cspan_at(&place, axis)) = (*cspan_at(&span, INT64_C(0) + axis, INT64_C(0)));
    }
    upwards = (*cspan_at(&span, INT64_C(6) + INT64_C(2), INT64_C(0)));
    if ((part == INT64_C(2)) && (upwards > 0.0))
    {
        height = shared_height(0.0, span, box);
        for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
        {
            rope = (*cspan_at(&span, INT64_C(3) + axis, INT64_C(0))) + height * (*cspan_at(&span, INT64_C(6) + axis, INT64_C(0)));
            (*cspan_at(&place, axis)) = rope / upwards;
        }
        (*cspan_at(&place, INT64_C(2))) = height;
    }
}
static int64_t note_time(int64_t found, array_double_2d span, array_double_2d times)
{
    double begin;
    double end;
    int64_t rows;
    begin = (*cspan_at(&span, INT64_C(9), INT64_C(0)));
    end = begin + (*cspan_at(&span, INT64_C(9), INT64_C(1)));
    rows = times.shape[INT64_C(0)];
    if ((INT64_C(0) < found) && (found <= rows) && (begin <= (*cspan_at(&times, found - INT64_C(1), INT64_C(1))) + 1e-11 * end))
    {
        (*cspan_at(&times, found - INT64_C(1), INT64_C(1))) = end;
        return found;
    }
    if (found < rows)
    {
        (*cspan_at(&times, found, INT64_C(0))) = begin;
        (*cspan_at(&times, found, INT64_C(1))) = end;
    }
    return found + INT64_C(1);
}
static int64_t halved_contacts(int64_t part, int64_t found, array_double_1d box, array_double_3d stack, array_double_2d times, array_double_1d place)
{
    int64_t rows;
    int64_t halvings;
    array_double_2d span;
    int64_t meeting;
    bool deep;
    rows = INT64_C(1);
    halvings = INT64_C(0);
    while(rows > INT64_C(0))
    {
        span = span_matrix(&stack, rows - INT64_C(1));
        meeting = part_meeting(part, span, box);
        deep = (*cspan_at(&span, INT64_C(9), INT64_C(2))) > 39.5;
        if ((meeting == INT64_C(2)) && (!deep) && (halvings < INT64_C(20000)) && part_moves(part, span))
        {
            halve_span(rows - INT64_C(1), stack);
            rows = rows + INT64_C(1);
            halvings = halvings + INT64_C(1);
            continue;
        }
        rows = rows - INT64_C(1);
        if (meeting == INT64_C(0))
        {
            if ((found > INT64_C(0)) && (times.shape[INT64_C(0)] == INT64_C(1)))
            {
                return found;
            }
            continue;
        }
        if (found == INT64_C(0))
        {
            note_place(part, span, box, place);
        }
        found = note_time(found, span, times);
    }
    return found;
}
static int64_t span_contacts(int64_t part, int64_t found, array_double_1d box, array_double_2d span, array_double_3d stack, array_double_2d times, array_double_1d place)
{
    int64_t k;
    int64_t i;
    int64_t result;
    if (part_meeting(part, span, box) == INT64_C(0))
    {
        return found;
    }
    for (k = INT64_C(0); k < INT64_C(10); k += INT64_C(1))
    {
        for (i = INT64_C(0); i < span.shape[INT64_C(1)]; i += INT64_C(1))
        {
            (*cspan_at(&stack, INT64_C(0), k, i)) = (*cspan_at(&span, k, i));
        }
    }
    result = halved_contacts(part, found, box, stack, times, place);
    return result;
}
int64_t segfmu_contact_times(int64_t part, double until, int64_t count, array_double_1d box, array_double_3d spans, array_double_3d stack, array_double_2d times, array_double_1d place)
{
    int64_t row;
    array_double_2d span;
    int64_t found;
    found = INT64_C(0);
    for (row = INT64_C(0); row < count; row += INT64_C(1))
    {
        span = span_matrix(&spans, row);
        if (((*cspan_at(&span, INT64_C(9), INT64_C(0))) >= until) || (found > times.shape[INT64_C(0)]))
        {
            break;
        }
        found = span_contacts(part, found, box, span, stack, times, place);
    }
    return found;
}
static int64_t sum_range(double* result_0, double* result_1, int64_t axis, double share, double lean, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work)
{
    int64_t width;
    double least;
    double most;
    int64_t piece;
    int64_t i;
    double second;
    width = coefficients.shape[INT64_C(1)];
    least = 1e+300;
    most = -1e+300;
    for (piece = (*cspan_at(&offsets, axis)); piece < (*cspan_at(&offsets, axis + INT64_C(1))); piece += INT64_C(1))
    {
        for (i = INT64_C(0); i < width; i += INT64_C(1))
        {
            (*cspan_at(&work, INT64_C(1), i)) = share * (*cspan_at(&coefficients, piece, i));
        }
        for (i = INT64_C(0); i < width - INT64_C(2); i += INT64_C(1))
        {
            second = (i + INT64_C(1)) * (i + INT64_C(2)) * (*cspan_at(&coefficients, piece, i + INT64_C(2)));
            (*cspan_at(&work, INT64_C(1), i)) = (*cspan_at(&work, INT64_C(1), i)) + lean * second;
        }
        bernstein_coefficients(work, INT64_C(1), width, (*cspan_at(&timing, piece, INT64_C(1))), work);
        for (i = INT64_C(0); i < width; i += INT64_C(1))
        {
            least = span_min(least, (*cspan_at(&work, INT64_C(0), i)));
            most = span_max(most, (*cspan_at(&work, INT64_C(0), i)));
        }
    }
    (*result_0) = least;
    (*result_1) = most;
    return 0;
}
static void widen_range(int64_t row, int64_t axis, double least, double most, array_double_2d ranges)
{
    (*cspan_at(&ranges, row, axis)) = span_min((*cspan_at(&ranges, row, axis)), least);
    (*cspan_at(&ranges, row + INT64_C(1), axis)) = span_max((*cspan_at(&ranges, row + INT64_C(1), axis)), most);
}
void segfmu_path_ranges(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d work, array_double_2d ranges)
{
    int64_t axis;
    int64_t row;
    double least;
    double most;
    double pull;
    double lean;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (row = INT64_C(0); row < INT64_C(4); row += INT64_C(2))
        {
            (*cspan_at(&ranges, row, axis)) = 1e+300;
            (*cspan_at(&ranges, row + INT64_C(1), axis)) = -1e+300;
        }
        sum_range(&least, &most, axis, 1.0, 0.0, timing, coefficients, offsets, work);
        widen_range(INT64_C(0), axis, least, most, ranges);
        widen_range(INT64_C(2), axis, least, most, ranges);
    }
    widen_range(INT64_C(2), INT64_C(2), 0.0, 0.0, ranges);
    sum_range(&least, &most, INT64_C(2), 0.0, 1.0, timing, coefficients, offsets, work);
    pull = gravity + least;
    if (pull <= 0.0)
    {
        for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
        {
            widen_range(INT64_C(2), axis, -1e+300, 1e+300, ranges);
        }
        return;
    }
    lean = span_max(-(*cspan_at(&ranges, INT64_C(0), INT64_C(2))), 0.0) / pull;
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        sum_range(&least, &most, axis, 1.0, lean, timing, coefficients, offsets, work);
        widen_range(INT64_C(2), axis, least, most, ranges);
    }
}
static bool is_near(int64_t part, array_double_1d box, array_double_2d ranges)
{
    int64_t low;
    int64_t high;
    int64_t row;
    int64_t axis;
    low = INT64_C(0);
    high = INT64_C(3);
    row = INT64_C(0);
    if (part == INT64_C(2))
    {
        low = INT64_C(6);
        high = INT64_C(9);
        row = INT64_C(2);
        if ((*cspan_at(&box, INT64_C(12))) < 0.5)
        {
            return 0;
        }
    }
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        if (((*cspan_at(&ranges, row + INT64_C(1), axis)) <= (*cspan_at(&box, low + axis))) || ((*cspan_at(&ranges, row, axis)) >= (*cspan_at(&box, high + axis))))
        {
            return 0;
        }
    }
    return 1;
}
static bool is_any_near(array_double_2d boxes, array_double_2d ranges)
{
    int64_t number;
    array_double_1d box;
    for (number = INT64_C(0); number < boxes.shape[INT64_C(0)]; number += INT64_C(1))
    {
        box = span_row(&boxes, number);
        if (is_near(INT64_C(1), box, ranges) || is_near(INT64_C(2), box, ranges))
        {
            return 1;
        }
    }
    return 0;
}
static double touch_distance(array_double_2d ranges)
{
    double largest;
    int64_t axis;
    largest = 0.0;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        largest = span_max(largest, fabs((*cspan_at(&ranges, INT64_C(0), axis))));
        largest = span_max(largest, fabs((*cspan_at(&ranges, INT64_C(1), axis))));
    }
    return 1e-09 * largest;
}
static void shrink_box(double touch, int64_t low, int64_t high, array_double_1d box)
{
    int64_t axis;
    double edge;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        edge = span_min(touch, 0.25 * ((*cspan_at(&box, high + axis)) - (*cspan_at(&box, low + axis))));
        (*cspan_at(&box, low + axis)) = (*cspan_at(&box, low + axis)) + edge;
        (*cspan_at(&box, high + axis)) = (*cspan_at(&box, high + axis)) - edge;
    }
}
void segfmu_shrink_boxes(double touch, array_double_2d boxes)
{
    int64_t number;
    for (number = INT64_C(0); number < boxes.shape[INT64_C(0)]; number += INT64_C(1))
    {
        shrink_box(touch, INT64_C(0), INT64_C(3), span_row(&boxes, number));
        shrink_box(touch, INT64_C(6), INT64_C(9), span_row(&boxes, number));
    }
}
static void note_first(int64_t part, array_double_2d boxes, array_double_3d stack, array_double_2d ranges, array_double_1d report)
{
    array_double_2d times;
    array_double_1d place;
    int64_t number;
    int64_t found;
    int64_t axis;
    times = span_rows(&ranges, INT64_C(5), INT64_C(5) + INT64_C(1));
    place = span_row(&ranges, INT64_C(4));
    for (number = INT64_C(0); number < boxes.shape[INT64_C(0)]; number += INT64_C(1))
    {
        if (is_near(part, span_row(&boxes, number), ranges))
        {
            found = span_contacts(part, INT64_C(0), span_row(&boxes, number), span_matrix(&stack, INT64_C(42)), stack, times, place);
            if ((found > INT64_C(0)) && ((*cspan_at(&times, INT64_C(0), INT64_C(0))) < (*cspan_at(&report, INT64_C(0)))))
            {
                (*cspan_at(&report, INT64_C(0))) = (*cspan_at(&times, INT64_C(0), INT64_C(0)));
                (*cspan_at(&report, INT64_C(1))) = (*cspan_at(&times, INT64_C(0), INT64_C(1)));
                (*cspan_at(&report, INT64_C(5))) = number;
                for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
                {
                    (*cspan_at(&report, INT64_C(2) + axis)) = (*cspan_at(&place, axis));
                }
            }
        }
    }
}
static void prolong_contact(int64_t part, array_double_2d boxes, array_double_3d stack, array_double_2d ranges, array_double_1d report)
{
    array_double_2d times;
    int64_t number;
    times = span_rows(&ranges, INT64_C(5), INT64_C(5) + INT64_C(1));
    (*cspan_at(&times, INT64_C(0), INT64_C(0))) = (*cspan_at(&report, INT64_C(0)));
    (*cspan_at(&times, INT64_C(0), INT64_C(1))) = (*cspan_at(&report, INT64_C(1)));
    number = (int64_t)((*cspan_at(&report, INT64_C(5))));
    span_contacts(part, INT64_C(1), span_row(&boxes, number), span_matrix(&stack, INT64_C(42)), stack, times, span_row(&ranges, INT64_C(4)));
    (*cspan_at(&report, INT64_C(1))) = (*cspan_at(&times, INT64_C(0), INT64_C(1)));
}
int64_t segfmu_first_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, double gravity, array_double_2d boxes, array_double_2d work, array_double_3d stack, array_double_2d ranges, array_double_1d report)
{
    double time;
    double until;
    bool lasts;
    bool ended;
    int64_t part;
    segfmu_shrink_boxes(touch_distance(ranges), boxes);
    if (!is_any_near(boxes, ranges))
    {
        return INT64_C(0);
    }
    for (part = INT64_C(1); part < INT64_C(2) + INT64_C(1); part += INT64_C(1))
    {
        (*cspan_at(&report, INT64_C(0))) = 1e+300;
        time = (*cspan_at(&timing, (*cspan_at(&offsets, INT64_C(0))), INT64_C(0)));
        until = interval_end(time, timing, offsets);
        lasts = 1;
        while(lasts)
        {
            write_span(part, time, until, timing, coefficients, offsets, gravity, work, span_matrix(&stack, INT64_C(42)));
            if ((*cspan_at(&report, INT64_C(0))) >= 1e+300)
            {
                note_first(part, boxes, stack, ranges, report);
            }
            else
            {
                prolong_contact(part, boxes, stack, ranges, report);
            }
            ended = ((*cspan_at(&report, INT64_C(0))) < 1e+300) && ((*cspan_at(&report, INT64_C(1))) < until * (INT64_C(1) - 1e-11));
            time = until;
            until = interval_end(time, timing, offsets);
            lasts = (until > time) && (!ended);
        }
        if ((*cspan_at(&report, INT64_C(0))) < 1e+300)
        {
            return part;
        }
    }
    return INT64_C(0);
}
void segfmu_write_box(array_double_1d space, array_double_1d obstacle, array_double_1d box)
{
    int64_t axis;
    double low;
    double high;
    double half;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        low = (*cspan_at(&obstacle, INT64_C(0) + axis)) - (*cspan_at(&obstacle, INT64_C(6)));
        high = (*cspan_at(&obstacle, INT64_C(3) + axis)) + (*cspan_at(&obstacle, INT64_C(6)));
        half = 0.5 * (*cspan_at(&space, INT64_C(7) + axis));
        (*cspan_at(&box, INT64_C(0) + axis)) = low - half - (*cspan_at(&space, INT64_C(10) + axis));
        (*cspan_at(&box, INT64_C(3) + axis)) = high + half - (*cspan_at(&space, INT64_C(10) + axis));
        (*cspan_at(&box, INT64_C(6) + axis)) = low;
        (*cspan_at(&box, INT64_C(9) + axis)) = high;
    }
    (*cspan_at(&box, INT64_C(12))) = (*cspan_at(&obstacle, INT64_C(7)));
}
static void write_faces(array_double_1d space, array_double_2d boxes)
{
    int64_t number;
    int64_t axis;
    for (number = INT64_C(0); number < INT64_C(6); number += INT64_C(1))
    {
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            (*cspan_at(&boxes, number, INT64_C(0) + axis)) = -1e+30;
            (*cspan_at(&boxes, number, INT64_C(3) + axis)) = 1e+30;
            (*cspan_at(&boxes, number, INT64_C(6) + axis)) = -1e+30;
            (*cspan_at(&boxes, number, INT64_C(9) + axis)) = 1e+30;
        }
        (*cspan_at(&boxes, number, INT64_C(12))) = 0.0;
        axis = span_floor_div(number, INT64_C(2));
        if (span_floor_mod(number, INT64_C(2)) == INT64_C(0))
        {
            (*cspan_at(&boxes, number, INT64_C(3) + axis)) = (*cspan_at(&space, INT64_C(1) + axis));
        }
        else
        {
            (*cspan_at(&boxes, number, INT64_C(0) + axis)) = (*cspan_at(&space, INT64_C(4) + axis));
        }
    }
}
static int64_t obstacle_count(array_double_1d space, array_double_2d obstacles)
{
    int64_t result;
    result = span_min_int((int64_t)((*cspan_at(&space, INT64_C(13)))), obstacles.shape[INT64_C(0)]);
    return result;
}
static int64_t check_space(array_double_1d space, array_double_2d obstacles, array_double_1d fault)
{
    int64_t axis;
    int64_t number;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        (*cspan_at(&fault, INT64_C(6))) = axis;
        (*cspan_at(&fault, INT64_C(7))) = (*cspan_at(&space, INT64_C(1) + axis));
        (*cspan_at(&fault, INT64_C(8))) = (*cspan_at(&space, INT64_C(4) + axis));
        if ((*cspan_at(&fault, INT64_C(7))) >= (*cspan_at(&fault, INT64_C(8))))
        {
            return INT64_C(4);
        }
    }
    for (number = INT64_C(0); number < obstacle_count(space, obstacles); number += INT64_C(1))
    {
        (*cspan_at(&fault, INT64_C(5))) = number;
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            (*cspan_at(&fault, INT64_C(6))) = axis;
            (*cspan_at(&fault, INT64_C(7))) = (*cspan_at(&obstacles, number, INT64_C(0) + axis));
            (*cspan_at(&fault, INT64_C(8))) = (*cspan_at(&obstacles, number, INT64_C(3) + axis));
            if ((*cspan_at(&fault, INT64_C(7))) >= (*cspan_at(&fault, INT64_C(8))))
            {
                return INT64_C(5);
            }
        }
    }
    return INT64_C(0);
}
int64_t segfmu_space_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d space, array_double_2d obstacles, array_double_2d boxes, array_double_2d work, array_double_3d stack, array_double_2d ranges, array_double_1d fault)
{
    int64_t status;
    int64_t count;
    int64_t number;
    array_double_2d used;
    int64_t part;
    int64_t axis;
    status = check_space(space, obstacles, fault);
    if (status != INT64_C(0))
    {
        return status;
    }
    write_faces(space, boxes);
    count = obstacle_count(space, obstacles);
    for (number = INT64_C(0); number < count; number += INT64_C(1))
    {
        segfmu_write_box(space, span_row(&obstacles, number), span_row(&boxes, INT64_C(6) + number));
    }
    segfmu_path_ranges(timing, coefficients, offsets, (*cspan_at(&space, INT64_C(0))), work, ranges);
    used = span_rows(&boxes, INT64_C(0), INT64_C(6) + count);
    part = segfmu_first_contact(timing, coefficients, offsets, (*cspan_at(&space, INT64_C(0))), used, work, stack, ranges, fault);
    if (part == INT64_C(0))
    {
        return INT64_C(0);
    }
    number = (int64_t)((*cspan_at(&fault, INT64_C(5))));
    if (number >= INT64_C(6))
    {
        (*cspan_at(&fault, INT64_C(5))) = number - INT64_C(6);
        return part;
    }
    axis = span_floor_div(number, INT64_C(2));
    (*cspan_at(&fault, INT64_C(6))) = axis;
    (*cspan_at(&fault, INT64_C(7))) = (*cspan_at(&fault, INT64_C(2) + axis));
    (*cspan_at(&fault, INT64_C(8))) = (*cspan_at(&space, INT64_C(1) + axis));
    if (span_floor_mod(number, INT64_C(2)) == INT64_C(1))
    {
        (*cspan_at(&fault, INT64_C(8))) = (*cspan_at(&space, INT64_C(4) + axis));
    }
    return INT64_C(3);
}
static double side_bound(double sign, double greatest, double least)
{
    if ((sign < 0.0) && (least < 0.0))
    {
        return -least;
    }
    return greatest;
}
static bool exceeds(double value, double bound)
{
    return (bound > 0.0) && (fabs(value) > bound * (1.0 + 1e-12));
}
static double limited(double value, double bound)
{
    return span_min(span_max(value, -bound), bound);
}
static double velocity_bound(array_double_1d plant, int64_t axis, double sign)
{
    double result;
    result = side_bound(sign, (*cspan_at(&plant, INT64_C(34) + axis)), (*cspan_at(&plant, INT64_C(37) + axis)));
    return result;
}
static double acceleration_bound(array_double_1d plant, int64_t axis, double sign)
{
    double result;
    result = side_bound(sign, (*cspan_at(&plant, INT64_C(28) + axis)), (*cspan_at(&plant, INT64_C(31) + axis)));
    return result;
}
static double static_bound(array_double_1d plant, int64_t axis, double sign)
{
    double result;
    result = side_bound(sign, (*cspan_at(&plant, INT64_C(22) + axis)), (*cspan_at(&plant, INT64_C(25) + axis)));
    return result;
}
static double force_bound(array_double_1d plant, int64_t axis, double sign, double velocity)
{
    double speed;
    double by_power;
    double bound;
    bound = static_bound(plant, axis, sign);
    if ((*cspan_at(&plant, INT64_C(40) + axis)) > 0.0)
    {
        speed = span_max(fabs(velocity), 1e-99);
        by_power = (*cspan_at(&plant, INT64_C(40) + axis)) / speed;
        if ((bound == 0.0) || (by_power < bound))
        {
            bound = by_power;
        }
    }
    return bound;
}
static void rope_direction(array_double_1d state, array_double_1d limit)
{
    double phi_x;
    double phi_y;
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(3) + INT64_C(1)));
    (*cspan_at(&limit, INT64_C(6))) = sin(phi_x);
    (*cspan_at(&limit, INT64_C(6) + INT64_C(1))) = (-cos(phi_x)) * sin(phi_y);
    (*cspan_at(&limit, INT64_C(6) + INT64_C(2))) = 1.0;
}
static double carriage_mass(array_double_1d masses, int64_t axis)
{
    double result;
    if (axis == INT64_C(0))
    {
        result = (*cspan_at(&masses, INT64_C(0))) + (*cspan_at(&masses, INT64_C(1)));
        return result;
    }
    if (axis == INT64_C(1))
    {
        result = (*cspan_at(&masses, INT64_C(1)));
        return result;
    }
    return 0.0;
}
static double available_force(int64_t axis, double side, array_double_1d limit)
{
    double result;
    if (side < 0.0)
    {
        result = (*cspan_at(&limit, INT64_C(12) + axis));
        return result;
    }
    result = (*cspan_at(&limit, INT64_C(9) + axis));
    return result;
}
static double limit_side(array_double_1d plant, int64_t axis, array_double_1d action, array_double_1d limit)
{
    double change;
    double along;
    int64_t i;
    double needed;
    double side;
    side = (*cspan_at(&limit, INT64_C(0) + axis));
    change = (*cspan_at(&limit, INT64_C(3) + axis));
    if (side != 0.0)
    {
        if (side * change > 0.0)
        {
            return 0.0;
        }
        return side;
    }
    along = 0.0;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        along = along + (*cspan_at(&limit, INT64_C(6) + i)) * (*cspan_at(&limit, INT64_C(3) + i));
    }
    needed = (*cspan_at(&action, INT64_C(0) + axis)) + carriage_mass(plant, axis) * change;
    needed = needed + (*cspan_at(&plant, INT64_C(2))) * (*cspan_at(&limit, INT64_C(6) + axis)) * along;
    if (needed > 0.0)
    {
        side = 1.0;
    }
    else
    {
        side = -1.0;
    }
    if (!exceeds(needed, available_force(axis, side, limit)))
    {
        return 0.0;
    }
    return side;
}
static double missing_force(int64_t axis, array_double_1d action, array_double_1d limit)
{
    double side;
    double bound;
    double result;
    side = (*cspan_at(&limit, INT64_C(0) + axis));
    bound = side * available_force(axis, side, limit);
    result = bound - (*cspan_at(&action, INT64_C(0) + axis));
    return result;
}
static void change_accelerations(array_double_1d plant, array_double_1d action, array_double_1d limit)
{
    double payload;
    double total;
    double weight;
    int64_t i;
    double missing;
    double mass;
    double rope;
    double along;
    bool hoist_limited;
    double rest;
    payload = (*cspan_at(&plant, INT64_C(2)));
    total = 0.0;
    weight = 1.0;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        if ((*cspan_at(&limit, INT64_C(0) + i)) != 0.0)
        {
            missing = missing_force(i, action, limit);
            mass = carriage_mass(plant, i);
            rope = (*cspan_at(&limit, INT64_C(6) + i));
            total = total + rope * missing / mass;
            weight = weight + payload * rope * rope / mass;
        }
    }
    along = total / weight;
    hoist_limited = (*cspan_at(&limit, INT64_C(0) + INT64_C(2))) != 0.0;
    if (hoist_limited)
    {
        along = missing_force(INT64_C(2), action, limit) / payload;
    }
    rest = along;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&limit, INT64_C(3) + i)) = 0.0;
        if ((*cspan_at(&limit, INT64_C(0) + i)) != 0.0)
        {
            missing = missing_force(i, action, limit);
            missing = missing - payload * (*cspan_at(&limit, INT64_C(6) + i)) * along;
            (*cspan_at(&limit, INT64_C(3) + i)) = missing / carriage_mass(plant, i);
        }
        rest = rest - (*cspan_at(&limit, INT64_C(6) + i)) * (*cspan_at(&limit, INT64_C(3) + i));
    }
    (*cspan_at(&limit, INT64_C(3) + INT64_C(2))) = 0.0;
    if (hoist_limited)
    {
        (*cspan_at(&limit, INT64_C(3) + INT64_C(2))) = rest;
    }
}
static void limit_accelerations(array_double_1d plant, array_double_1d state, array_double_1d action, array_double_1d acceleration, array_double_1d limit)
{
    int64_t i;
    double velocity;
    int64_t Dummy_0000;
    bool changed;
    double side;
    rope_direction(state, limit);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&limit, INT64_C(0) + i)) = 0.0;
        (*cspan_at(&limit, INT64_C(3) + i)) = 0.0;
        velocity = (*cspan_at(&state, INT64_C(5) + i));
        (*cspan_at(&limit, INT64_C(9) + i)) = force_bound(plant, i, 1.0, velocity);
        (*cspan_at(&limit, INT64_C(12) + i)) = force_bound(plant, i, -1.0, velocity);
    }
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(16); Dummy_0000 += INT64_C(1))
    {
        changed = 0;
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            if (!changed)
            {
                side = limit_side(plant, i, action, limit);
                changed = side != (*cspan_at(&limit, INT64_C(0) + i));
                (*cspan_at(&limit, INT64_C(0) + i)) = side;
            }
        }
        if (!changed)
        {
            break;
        }
        change_accelerations(plant, action, limit);
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&acceleration, i)) = (*cspan_at(&acceleration, i)) + (*cspan_at(&limit, INT64_C(3) + i));
        if ((*cspan_at(&limit, INT64_C(0) + i)) != 0.0)
        {
            (*cspan_at(&action, INT64_C(3) + i)) = 1.0;
        }
    }
}
static bool at_velocity_bound(array_double_1d plant, int64_t axis, array_double_1d state)
{
    double velocity;
    double bound;
    velocity = (*cspan_at(&state, INT64_C(5) + axis));
    bound = velocity_bound(plant, axis, velocity);
    return (bound > 0.0) && (fabs(velocity) >= bound);
}
static double held_side(int64_t axis, array_double_1d state, array_double_1d derivative, array_double_1d limit)
{
    double side;
    side = 1.0;
    if ((*cspan_at(&state, INT64_C(5) + axis)) < 0.0)
    {
        side = -1.0;
    }
    if ((*cspan_at(&limit, INT64_C(0) + axis)) != 0.0)
    {
        if (side * (*cspan_at(&limit, INT64_C(15) + axis)) > 0.0)
        {
            return 0.0;
        }
        return side;
    }
    if (side * ((*cspan_at(&derivative, INT64_C(5) + axis)) + (*cspan_at(&limit, INT64_C(3) + axis))) > 0.0)
    {
        return side;
    }
    return 0.0;
}
static void hold_accelerations(array_double_1d plant, array_double_1d derivative, array_double_1d limit)
{
    double payload;
    double along;
    double weight;
    int64_t i;
    double rope;
    double mass;
    double pull;
    payload = (*cspan_at(&plant, INT64_C(2)));
    along = 0.0;
    weight = 1.0;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        rope = (*cspan_at(&limit, INT64_C(6) + i));
        (*cspan_at(&limit, INT64_C(3) + i)) = 0.0;
        if ((*cspan_at(&limit, INT64_C(0) + i)) != 0.0)
        {
            (*cspan_at(&limit, INT64_C(3) + i)) = -(*cspan_at(&derivative, INT64_C(5) + i));
            along = along + rope * (*cspan_at(&limit, INT64_C(3) + i));
        }
        else if (i != INT64_C(2))
        {
            weight = weight + payload * rope * rope / carriage_mass(plant, i);
        }
    }
    if ((*cspan_at(&limit, INT64_C(0) + INT64_C(2))) == 0.0)
    {
        (*cspan_at(&limit, INT64_C(3) + INT64_C(2))) = -along;
        along = 0.0;
    }
    along = along / weight;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        mass = carriage_mass(plant, i);
        pull = payload * (*cspan_at(&limit, INT64_C(6) + i)) * along;
        (*cspan_at(&limit, INT64_C(15) + i)) = 0.0;
        if ((*cspan_at(&limit, INT64_C(0) + i)) != 0.0)
        {
            (*cspan_at(&limit, INT64_C(15) + i)) = mass * (*cspan_at(&limit, INT64_C(3) + i)) + pull;
        }
        else if (i != INT64_C(2))
        {
            (*cspan_at(&limit, INT64_C(3) + i)) = (-pull) / mass;
        }
    }
}
static void hold_velocities(array_double_1d plant, array_double_1d state, array_double_1d derivative, array_double_1d action, array_double_1d limit)
{
    int64_t i;
    int64_t Dummy_0000;
    bool changed;
    double side;
    double force;
    double bound;
    rope_direction(state, limit);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&limit, INT64_C(0) + i)) = 0.0;
        (*cspan_at(&limit, INT64_C(3) + i)) = 0.0;
        (*cspan_at(&limit, INT64_C(15) + i)) = 0.0;
    }
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(16); Dummy_0000 += INT64_C(1))
    {
        changed = 0;
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            if ((!changed) && at_velocity_bound(plant, i, state))
            {
                side = held_side(i, state, derivative, limit);
                changed = side != (*cspan_at(&limit, INT64_C(0) + i));
                (*cspan_at(&limit, INT64_C(0) + i)) = side;
            }
        }
        if (!changed)
        {
            break;
        }
        hold_accelerations(plant, derivative, limit);
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        if ((*cspan_at(&limit, INT64_C(0) + i)) != 0.0)
        {
            force = (*cspan_at(&action, INT64_C(0) + i)) + (*cspan_at(&limit, INT64_C(15) + i));
            bound = force_bound(plant, i, force, (*cspan_at(&state, INT64_C(5) + i)));
            if (exceeds(force, bound))
            {
                force = limited(force, bound);
            }
            (*cspan_at(&action, INT64_C(0) + i)) = force;
            (*cspan_at(&action, INT64_C(3) + i)) = 1.0;
        }
    }
}
static int64_t table_row(double length, array_double_3d table)
{
    int64_t row;
    row = INT64_C(0);
    while((row + INT64_C(2) < table.shape[INT64_C(0)]) && (length > (*cspan_at(&table, row + INT64_C(1), INT64_C(0), INT64_C(0)))))
    {
        row = row + INT64_C(1);
    }
    return row;
}
static double table_share(double length, array_double_3d table, int64_t row)
{
    double first;
    double result;
    if (table.shape[INT64_C(0)] < INT64_C(2))
    {
        return 0.0;
    }
    first = (*cspan_at(&table, row, INT64_C(0), INT64_C(0)));
    result = span_min(span_max((length - first) / ((*cspan_at(&table, row + INT64_C(1), INT64_C(0), INT64_C(0))) - first), 0.0), 1.0);
    return result;
}
void segfmu_feedback_correction(array_double_1d state, array_double_1d reference, array_double_1d added, array_double_3d gains, array_double_1d correction)
{
    double length;
    int64_t row;
    double share;
    int64_t following;
    int64_t i;
    int64_t axis;
    double total;
    int64_t j;
    double k;
    length = (*cspan_at(&state, INT64_C(0) + INT64_C(2)));
    row = table_row(length, gains);
    share = table_share(length, gains, row);
    following = span_min_int(row + INT64_C(1), gains.shape[INT64_C(0)] - INT64_C(1));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        axis = INT64_C(1) + i;
        total = 0.0;
        for (j = INT64_C(0); j < INT64_C(10); j += INT64_C(1))
        {
            k = (1.0 - share) * (*cspan_at(&gains, row, axis, j)) + share * (*cspan_at(&gains, following, axis, j));
            total = total + k * ((*cspan_at(&state, j)) - (*cspan_at(&reference, j)));
        }
        k = (1.0 - share) * (*cspan_at(&gains, row, axis, INT64_C(10)));
        k = k + share * (*cspan_at(&gains, following, axis, INT64_C(10)));
        (*cspan_at(&correction, i)) = -(total + k * (*cspan_at(&added, i)));
    }
}
double segfmu_feedback_bandwidth(double ratio, double length, double gravity, double delay, double largest)
{
    return span_min(ratio * sqrt(gravity / length), largest / delay);
}
static void lead_gains(int64_t axis, double lag, double length, double gravity, array_double_1d gains)
{
    double position;
    double velocity;
    double direct;
    double sign;
    double angle;
    double rate;
    if (lag <= 0.0)
    {
        return;
    }
    position = (*cspan_at(&gains, INT64_C(0) + axis));
    velocity = (*cspan_at(&gains, INT64_C(5) + axis));
    direct = velocity;
    if (axis != INT64_C(2))
    {
        sign = 1.0 - 2.0 * axis;
        angle = sign * (*cspan_at(&gains, INT64_C(3) + axis));
        rate = sign * (*cspan_at(&gains, INT64_C(8) + axis));
        direct = velocity - rate / length;
        (*cspan_at(&gains, INT64_C(3) + axis)) = sign * (angle - lag * rate * gravity / length);
        (*cspan_at(&gains, INT64_C(8) + axis)) = sign * (rate + lag * angle);
    }
    (*cspan_at(&gains, INT64_C(5) + axis)) = velocity + lag * position - direct;
    (*cspan_at(&gains, INT64_C(10))) = direct;
}
void segfmu_feedback_gains(array_double_1d plant, double length, double bandwidth, double pendulum, double hoist_bandwidth, double damping, array_double_2d gains)
{
    bool driven;
    double gravity;
    double slope;
    double square;
    double k0;
    double k1;
    double k2;
    double k3;
    int64_t i;
    int64_t j;
    array_double_1d axis;
    double sign;
    double scale;
    double pull;
    double ratio;
    double angle;
    double weight;
    array_double_1d hoist;
    driven = (int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(1);
    gravity = (*cspan_at(&plant, INT64_C(3)));
    slope = 2.0 * damping * bandwidth;
    square = bandwidth * bandwidth;
    k0 = square * pendulum * pendulum;
    k1 = slope * (square + pendulum * pendulum);
    k2 = square + pendulum * pendulum + slope * slope;
    k3 = 2.0 * slope;
    for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
    {
        for (j = INT64_C(0); j < INT64_C(11); j += INT64_C(1))
        {
            (*cspan_at(&gains, i, j)) = 0.0;
        }
    }
    (*cspan_at(&gains, INT64_C(0), INT64_C(0))) = length;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        axis = span_row(&gains, INT64_C(1) + i);
        sign = 1.0 - 2.0 * i;
        scale = 1.0;
        pull = 0.0;
        if (!driven)
        {
            scale = carriage_mass(plant, i);
            pull = (*cspan_at(&plant, INT64_C(2))) * gravity;
        }
        ratio = length / gravity;
        angle = scale * (ratio * length * k0 - length * k2 + gravity) + pull;
        (*cspan_at(&axis, INT64_C(0) + i)) = scale * ratio * k0;
        (*cspan_at(&axis, INT64_C(3) + i)) = sign * angle;
        (*cspan_at(&axis, INT64_C(5) + i)) = scale * ratio * k1;
        (*cspan_at(&axis, INT64_C(8) + i)) = sign * scale * (ratio * length * k1 - length * k3);
    }
    weight = 1.0;
    if (!driven)
    {
        weight = (*cspan_at(&plant, INT64_C(2)));
    }
    hoist = span_row(&gains, INT64_C(1) + INT64_C(2));
    (*cspan_at(&hoist, INT64_C(0) + INT64_C(2))) = weight * hoist_bandwidth * hoist_bandwidth;
    (*cspan_at(&hoist, INT64_C(5) + INT64_C(2))) = weight * 2.0 * damping * hoist_bandwidth;
    if (driven)
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            lead_gains(i, (*cspan_at(&plant, INT64_C(19) + i)), length, gravity, span_row(&gains, INT64_C(1) + i));
        }
    }
}
static double return_effort(void)
{
    return 3.5;
}
static double return_speed(void)
{
    return 0.7;
}
static double held_within(double value, double least, double greatest)
{
    return span_max(span_min(value, greatest), least);
}
static double scheduled_gain(double length, int64_t axis, int64_t column, array_double_3d gains)
{
    int64_t row;
    double share;
    int64_t following;
    double first;
    double result;
    row = table_row(length, gains);
    share = table_share(length, gains, row);
    following = span_min_int(row + INT64_C(1), gains.shape[INT64_C(0)] - INT64_C(1));
    first = (*cspan_at(&gains, row, INT64_C(1) + axis, column));
    result = first + share * ((*cspan_at(&gains, following, INT64_C(1) + axis, column)) - first);
    return result;
}
static double top_speed(int64_t axis, double sign, array_double_1d parameters, array_double_1d situation)
{
    double power;
    double bound;
    bound = side_bound(sign, (*cspan_at(&parameters, INT64_C(30) + axis)), (*cspan_at(&parameters, INT64_C(33) + axis)));
    power = (*cspan_at(&parameters, INT64_C(36) + axis));
    if (bound <= 0.0)
    {
        bound = 1e+99;
    }
    if ((axis == INT64_C(2)) && (power > 0.0))
    {
        bound = span_min(bound, power / (*cspan_at(&situation, INT64_C(0))));
    }
    return bound;
}
static double power_bound(int64_t axis, array_double_1d parameters, array_double_1d situation)
{
    double power;
    double weight;
    double gravity;
    double force;
    power = (*cspan_at(&parameters, INT64_C(36) + axis));
    if (power <= 0.0)
    {
        return 1e+99;
    }
    force = power / span_max(fabs((*cspan_at(&situation, INT64_C(2) + axis))), 1e-12 * power);
    if ((int64_t)((*cspan_at(&parameters, INT64_C(0)))) == INT64_C(0))
    {
        return force;
    }
    weight = (*cspan_at(&situation, INT64_C(0)));
    gravity = (*cspan_at(&parameters, INT64_C(6)));
    if (axis == INT64_C(2))
    {
        return gravity * span_max(force / weight - 1.0, 0.001);
    }
    force = force / ((*cspan_at(&parameters, INT64_C(3) + axis)) + weight / gravity);
    return force;
}
static double least_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation)
{
    double least;
    double result;
    least = span_max((*cspan_at(&parameters, INT64_C(12) + axis)), -power_bound(axis, parameters, situation));
    result = span_min(least - (*cspan_at(&tick, INT64_C(2), axis)), 0.0);
    return result;
}
static double greatest_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation)
{
    double greatest;
    double result;
    greatest = (*cspan_at(&parameters, INT64_C(15) + axis));
    if (axis != INT64_C(2))
    {
        greatest = span_min(greatest, power_bound(axis, parameters, situation));
    }
    else if ((int64_t)((*cspan_at(&parameters, INT64_C(0)))) == INT64_C(0))
    {
        greatest = span_min(greatest, (-0.1) * (*cspan_at(&situation, INT64_C(0))));
    }
    result = span_max(greatest - (*cspan_at(&tick, INT64_C(2), axis)), 0.0);
    return result;
}
static void bound_correction(int64_t axis, array_double_1d parameters, array_double_2d tick, array_double_1d situation)
{
    double correction;
    double least;
    double greatest;
    double velocity;
    double period;
    correction = (*cspan_at(&tick, INT64_C(3), axis));
    if ((int64_t)((*cspan_at(&parameters, INT64_C(0)))) == INT64_C(1))
    {
        least = -top_speed(axis, -1.0, parameters, situation);
        greatest = top_speed(axis, 1.0, parameters, situation);
        velocity = (*cspan_at(&situation, INT64_C(2) + axis));
        period = (*cspan_at(&parameters, INT64_C(1)));
        correction = held_within(correction, span_min(least - velocity, 0.0) / period, span_max(greatest - velocity, 0.0) / period);
    }
    (*cspan_at(&tick, INT64_C(3), axis)) = held_within(correction, least_correction(axis, parameters, tick, situation), greatest_correction(axis, parameters, tick, situation));
}
static double return_room(int64_t axis, array_double_1d parameters, array_double_3d gains, array_double_1d situation)
{
    double sign;
    double length;
    double pull;
    double opposed;
    if (axis == INT64_C(2))
    {
        return 1.0;
    }
    sign = 1.0 - 2.0 * axis;
    length = (*cspan_at(&situation, INT64_C(1)));
    pull = (*cspan_at(&parameters, INT64_C(6)));
    if ((int64_t)((*cspan_at(&parameters, INT64_C(0)))) == INT64_C(0))
    {
        pull = pull * (*cspan_at(&parameters, INT64_C(3) + axis)) + (*cspan_at(&situation, INT64_C(0)));
    }
    opposed = length * scheduled_gain(length, axis, INT64_C(0) + axis, gains);
    opposed = opposed - sign * scheduled_gain(length, axis, INT64_C(3) + axis, gains);
    return return_effort() * span_max(1.0 + opposed / pull, 1.0);
}
static void bound_return(int64_t axis, array_double_1d parameters, array_double_3d gains, array_double_2d tick, array_double_1d situation)
{
    double length;
    double slope;
    double pull;
    double damping;
    double asked;
    double speed;
    double reference;
    double fastest;
    double room;
    double least;
    double greatest;
    double given;
    length = (*cspan_at(&situation, INT64_C(1)));
    slope = scheduled_gain(length, axis, INT64_C(5) + axis, gains);
    slope = slope + scheduled_gain(length, axis, INT64_C(10), gains);
    pull = scheduled_gain(length, axis, INT64_C(0) + axis, gains);
    pull = pull * (*cspan_at(&situation, INT64_C(5) + axis));
    damping = slope * (*cspan_at(&situation, INT64_C(8) + axis));
    asked = -(pull + damping);
    speed = top_speed(axis, -pull, parameters, situation);
    if ((slope > 0.0) && (speed < 1e+99))
    {
        reference = fabs((*cspan_at(&tick, INT64_C(1), INT64_C(5) + axis)));
        fastest = slope * return_speed() * span_max(speed - reference, 0.0);
        pull = held_within(pull, -fastest, fastest);
    }
    room = return_room(axis, parameters, gains, situation);
    least = room * least_correction(axis, parameters, tick, situation);
    greatest = room * greatest_correction(axis, parameters, tick, situation);
    given = held_within(-(pull + damping), least, greatest);
    (*cspan_at(&tick, INT64_C(3), axis)) = (*cspan_at(&tick, INT64_C(3), axis)) + given - asked;
}
void segfmu_observer_predict(int64_t axis, double length, array_double_3d table, double command, double correction, array_double_1d estimate, array_double_1d scratch)
{
    int64_t row;
    double share;
    int64_t following;
    int64_t j;
    int64_t i;
    int64_t k;
    double total;
    double entry;
    row = table_row(length, table);
    share = table_share(length, table, row);
    following = span_min_int(row + INT64_C(1), table.shape[INT64_C(0)] - INT64_C(1));
    for (j = INT64_C(0); j < INT64_C(6); j += INT64_C(1))
    {
        (*cspan_at(&scratch, j)) = (*cspan_at(&estimate, j));
    }
    (*cspan_at(&scratch, INT64_C(6))) = command;
    (*cspan_at(&scratch, INT64_C(7))) = correction;
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        k = INT64_C(1) + INT64_C(6) * axis + i;
        total = 0.0;
        for (j = INT64_C(0); j < INT64_C(8); j += INT64_C(1))
        {
            entry = (1.0 - share) * (*cspan_at(&table, row, k, j)) + share * (*cspan_at(&table, following, k, j));
            total = total + entry * (*cspan_at(&scratch, j));
        }
        (*cspan_at(&estimate, i)) = total;
    }
}
static void observer_input(int64_t axis, double length, array_double_3d table, double period, double correction, array_double_1d change)
{
    int64_t row;
    double share;
    int64_t following;
    int64_t i;
    int64_t k;
    double entry;
    row = table_row(length, table);
    share = table_share(length, table, row);
    following = span_min_int(row + INT64_C(1), table.shape[INT64_C(0)] - INT64_C(1));
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        k = INT64_C(1) + INT64_C(6) * axis + i;
        entry = (1.0 - share) * (*cspan_at(&table, row, k, INT64_C(7)));
        entry = entry + share * (*cspan_at(&table, following, k, INT64_C(7)));
        (*cspan_at(&change, i)) = entry * correction;
    }
    (*cspan_at(&change, INT64_C(6))) = period * correction;
}
static void observer_bend(int64_t axis, double length, array_double_3d table, double factor, array_double_1d change, array_double_1d estimate)
{
    int64_t row;
    double share;
    int64_t following;
    int64_t i;
    int64_t k;
    double total;
    int64_t j;
    double entry;
    row = table_row(length, table);
    share = table_share(length, table, row);
    following = span_min_int(row + INT64_C(1), table.shape[INT64_C(0)] - INT64_C(1));
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        k = INT64_C(1) + INT64_C(6) * axis + i;
        total = -(*cspan_at(&change, i));
        for (j = INT64_C(0); j < INT64_C(7); j += INT64_C(1))
        {
            entry = (1.0 - share) * (*cspan_at(&table, row, k, j)) + share * (*cspan_at(&table, following, k, j));
            total = total + entry * (*cspan_at(&change, j));
        }
        (*cspan_at(&estimate, i)) = (*cspan_at(&estimate, i)) + factor * total;
    }
}
void segfmu_observer_correct(double length, array_double_3d table, array_double_1d measured, array_double_1d reference, array_double_2d estimate)
{
    int64_t row;
    double share;
    int64_t following;
    int64_t axis;
    double first;
    double second;
    double sign;
    int64_t angle;
    double deviation;
    int64_t i;
    int64_t k;
    double a;
    double b;
    row = table_row(length, table);
    share = table_share(length, table, row);
    following = span_min_int(row + INT64_C(1), table.shape[INT64_C(0)] - INT64_C(1));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        first = (*cspan_at(&measured, axis)) - (*cspan_at(&reference, axis)) - (*cspan_at(&estimate, axis, INT64_C(0)));
        second = 0.0;
        if (axis != INT64_C(2))
        {
            sign = 1.0 - 2.0 * axis;
            angle = INT64_C(3) + axis;
            deviation = sign * ((*cspan_at(&measured, angle)) - (*cspan_at(&reference, angle)));
            second = deviation - (*cspan_at(&estimate, axis, INT64_C(1)));
        }
        for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
        {
            k = INT64_C(1) + INT64_C(6) * axis + i;
            a = (1.0 - share) * (*cspan_at(&table, row, k, INT64_C(8)));
            a = a + share * (*cspan_at(&table, following, k, INT64_C(8)));
            b = (1.0 - share) * (*cspan_at(&table, row, k, INT64_C(9)));
            b = b + share * (*cspan_at(&table, following, k, INT64_C(9)));
            (*cspan_at(&estimate, axis, i)) = (*cspan_at(&estimate, axis, i)) + a * first + b * second;
        }
    }
}
static int64_t remembered_ticks(array_double_1d parameters)
{
    double longest;
    int64_t axis;
    longest = (*cspan_at(&parameters, INT64_C(2)));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        longest = span_max(longest, (*cspan_at(&parameters, INT64_C(27) + axis)));
    }
    return span_min_int((int64_t)(longest) + INT64_C(3), INT64_C(40));
}
static void remember_tick(array_double_1d parameters, array_double_1d reference, array_double_2d memory)
{
    array_double_1d held;
    array_double_1d command;
    int64_t rows;
    int64_t back;
    int64_t row;
    int64_t i;
    double added;
    held = span_row(&memory, INT64_C(4));
    command = span_row(&memory, INT64_C(3));
    rows = remembered_ticks(parameters);
    for (back = INT64_C(0); back < rows - INT64_C(1); back += INT64_C(1))
    {
        row = INT64_C(31) + rows - INT64_C(1) - back;
        for (i = INT64_C(0); i < INT64_C(13); i += INT64_C(1))
        {
            (*cspan_at(&memory, row, i)) = (*cspan_at(&memory, row - INT64_C(1), i));
        }
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(31), INT64_C(0) + i)) = (*cspan_at(&held, INT64_C(0) + i));
        added = (*cspan_at(&parameters, INT64_C(1))) * (*cspan_at(&held, INT64_C(0) + i));
        (*cspan_at(&command, INT64_C(0) + i)) = (*cspan_at(&command, INT64_C(0) + i)) + added;
    }
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(31), INT64_C(3) + i)) = (*cspan_at(&reference, i));
    }
}
static void remember_start(array_double_1d reference, array_double_2d memory)
{
    int64_t row;
    int64_t i;
    for (row = INT64_C(0); row < INT64_C(40); row += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
        {
            (*cspan_at(&memory, INT64_C(31) + row, INT64_C(3) + i)) = (*cspan_at(&reference, i));
        }
    }
}
static void aged_reference(array_double_1d parameters, array_double_2d memory)
{
    double age;
    int64_t whole;
    double share;
    int64_t i;
    double later;
    double earlier;
    age = (*cspan_at(&parameters, INT64_C(2)));
    whole = span_min_int((int64_t)(age + 1e-09), INT64_C(40) - INT64_C(2));
    share = span_min(span_max(age - whole, 0.0), 1.0);
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        later = (*cspan_at(&memory, INT64_C(31) + whole, INT64_C(3) + i));
        earlier = (*cspan_at(&memory, INT64_C(31) + whole + INT64_C(1), INT64_C(3) + i));
        (*cspan_at(&memory, INT64_C(6), i)) = later + share * (earlier - later);
    }
}
static void advance_axis(int64_t axis, int64_t back, double share, array_double_1d parameters, double length, array_double_3d table, array_double_2d memory, array_double_1d estimate)
{
    double period;
    double before;
    double after;
    double command;
    int64_t i;
    array_double_1d change;
    period = (*cspan_at(&parameters, INT64_C(1)));
    before = (*cspan_at(&memory, INT64_C(31) + back + INT64_C(1), INT64_C(0) + axis));
    after = (*cspan_at(&memory, INT64_C(31) + back, INT64_C(0) + axis));
    command = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + axis)) - share * period * before;
    for (i = INT64_C(0); i < back + INT64_C(1); i += INT64_C(1))
    {
        command = command - period * (*cspan_at(&memory, INT64_C(31) + i, INT64_C(0) + axis));
    }
    segfmu_observer_predict(axis, length, table, command, share * before + (1.0 - share) * after, estimate, span_row(&memory, INT64_C(9)));
    if (share > 1e-09)
    {
        change = span_row(&memory, INT64_C(29));
        observer_input(axis, length, table, period, before - after, change);
        observer_bend(axis, length, table, 0.5 * share * (1.0 - share), change, estimate);
    }
}
static void advance_estimates(array_double_1d parameters, double length, array_double_3d table, array_double_2d memory)
{
    int64_t axis;
    double delay;
    int64_t whole;
    double share;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        delay = (*cspan_at(&parameters, INT64_C(27) + axis));
        whole = span_min_int((int64_t)(delay + 1e-09), INT64_C(40) - INT64_C(2));
        share = span_min(span_max(delay - whole, 0.0), 1.0);
        advance_axis(axis, whole, share, parameters, length, table, memory, span_row(&memory, INT64_C(0) + axis));
    }
}
static void predict_share(int64_t axis, double share, array_double_1d parameters, double length, array_double_3d table, array_double_2d memory)
{
    array_double_1d present;
    array_double_1d ahead;
    array_double_1d change;
    int64_t i;
    double latest;
    double command;
    present = span_row(&memory, INT64_C(25) + axis);
    ahead = span_row(&memory, INT64_C(28));
    change = span_row(&memory, INT64_C(29));
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        (*cspan_at(&ahead, i)) = (*cspan_at(&present, i));
    }
    latest = (*cspan_at(&memory, INT64_C(31), INT64_C(0) + axis));
    command = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + axis));
    command = command - share * (*cspan_at(&parameters, INT64_C(1))) * latest;
    segfmu_observer_predict(axis, length, table, command, latest, ahead, span_row(&memory, INT64_C(9)));
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        (*cspan_at(&change, i)) = (*cspan_at(&ahead, i)) - (*cspan_at(&present, i));
        (*cspan_at(&present, i)) = (*cspan_at(&present, i)) + share * (*cspan_at(&change, i));
    }
    (*cspan_at(&change, INT64_C(6))) = (*cspan_at(&parameters, INT64_C(1))) * latest;
    observer_bend(axis, length, table, (-0.5) * share * (1.0 - share), change, present);
}
static void predict_present(array_double_1d parameters, double length, array_double_3d table, array_double_2d memory)
{
    int64_t axis;
    double delay;
    int64_t whole;
    double share;
    array_double_1d present;
    int64_t i;
    int64_t back;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        delay = (*cspan_at(&parameters, INT64_C(27) + axis));
        whole = span_min_int((int64_t)(delay + 1e-09), INT64_C(40) - INT64_C(2));
        share = span_min(span_max(delay - whole, 0.0), 1.0);
        present = span_row(&memory, INT64_C(25) + axis);
        for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
        {
            (*cspan_at(&present, i)) = (*cspan_at(&memory, INT64_C(0) + axis, i));
        }
        for (back = INT64_C(0); back < whole; back += INT64_C(1))
        {
            advance_axis(axis, whole - INT64_C(1) - back, share, parameters, length, table, memory, present);
        }
        if (share > 1e-09)
        {
            predict_share(axis, share, parameters, length, table, memory);
        }
    }
}
static void matrix_set(int64_t n, double value, array_double_2d a)
{
    int64_t i;
    int64_t j;
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < n; j += INT64_C(1))
        {
            (*cspan_at(&a, i, j)) = 0.0;
        }
        (*cspan_at(&a, i, i)) = value;
    }
}
static void matrix_copy(int64_t n, array_double_2d a, array_double_2d c)
{
    int64_t i;
    int64_t j;
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < n; j += INT64_C(1))
        {
            (*cspan_at(&c, i, j)) = (*cspan_at(&a, i, j));
        }
    }
}
static void matrix_add(int64_t n, double factor, array_double_2d a, array_double_2d c)
{
    int64_t i;
    int64_t j;
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < n; j += INT64_C(1))
        {
            (*cspan_at(&c, i, j)) = (*cspan_at(&c, i, j)) + factor * (*cspan_at(&a, i, j));
        }
    }
}
static void matrix_product(int64_t n, array_double_2d a, array_double_2d b, array_double_2d c)
{
    int64_t i;
    int64_t j;
    double total;
    int64_t k;
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < n; j += INT64_C(1))
        {
            total = 0.0;
            for (k = INT64_C(0); k < n; k += INT64_C(1))
            {
                total = total + (*cspan_at(&a, i, k)) * (*cspan_at(&b, k, j));
            }
            (*cspan_at(&c, i, j)) = total;
        }
    }
}
static void matrix_product_transposed(int64_t n, array_double_2d a, array_double_2d b, array_double_2d c)
{
    int64_t i;
    int64_t j;
    double total;
    int64_t k;
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < n; j += INT64_C(1))
        {
            total = 0.0;
            for (k = INT64_C(0); k < n; k += INT64_C(1))
            {
                total = total + (*cspan_at(&a, i, k)) * (*cspan_at(&b, j, k));
            }
            (*cspan_at(&c, i, j)) = total;
        }
    }
}
static void matrix_transpose(int64_t n, array_double_2d a, array_double_2d c)
{
    int64_t i;
    int64_t j;
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < n; j += INT64_C(1))
        {
            (*cspan_at(&c, i, j)) = (*cspan_at(&a, j, i));
        }
    }
}
static void matrix_reduce(int64_t n, int64_t columns, int64_t pivot, array_double_2d a, array_double_2d b)
{
    int64_t best;
    int64_t i;
    int64_t j;
    double kept;
    double factor;
    best = pivot;
    for (i = pivot + INT64_C(1); i < n; i += INT64_C(1))
    {
        if (fabs((*cspan_at(&a, i, pivot))) > fabs((*cspan_at(&a, best, pivot))))
        {
            best = i;
        }
    }
    for (j = INT64_C(0); j < n; j += INT64_C(1))
    {
        kept = (*cspan_at(&a, pivot, j));
        (*cspan_at(&a, pivot, j)) = (*cspan_at(&a, best, j));
        (*cspan_at(&a, best, j)) = kept;
    }
    for (j = INT64_C(0); j < columns; j += INT64_C(1))
    {
        kept = (*cspan_at(&b, pivot, j));
        (*cspan_at(&b, pivot, j)) = (*cspan_at(&b, best, j));
        (*cspan_at(&b, best, j)) = kept;
    }
    for (i = pivot + INT64_C(1); i < n; i += INT64_C(1))
    {
        factor = (*cspan_at(&a, i, pivot)) / (*cspan_at(&a, pivot, pivot));
        for (j = pivot; j < n; j += INT64_C(1))
        {
            (*cspan_at(&a, i, j)) = (*cspan_at(&a, i, j)) - factor * (*cspan_at(&a, pivot, j));
        }
        for (j = INT64_C(0); j < columns; j += INT64_C(1))
        {
            (*cspan_at(&b, i, j)) = (*cspan_at(&b, i, j)) - factor * (*cspan_at(&b, pivot, j));
        }
    }
}
static void matrix_solve(int64_t n, int64_t columns, array_double_2d a, array_double_2d b)
{
    int64_t pivot;
    int64_t step;
    int64_t i;
    int64_t j;
    double total;
    int64_t k;
    for (pivot = INT64_C(0); pivot < n; pivot += INT64_C(1))
    {
        matrix_reduce(n, columns, pivot, a, b);
    }
    for (step = INT64_C(0); step < n; step += INT64_C(1))
    {
        i = n - INT64_C(1) - step;
        for (j = INT64_C(0); j < columns; j += INT64_C(1))
        {
            total = (*cspan_at(&b, i, j));
            for (k = i + INT64_C(1); k < n; k += INT64_C(1))
            {
                total = total - (*cspan_at(&a, i, k)) * (*cspan_at(&b, k, j));
            }
            (*cspan_at(&b, i, j)) = total / (*cspan_at(&a, i, i));
        }
    }
}
static void kalman_model(int64_t axis, array_double_1d plant, double length, array_double_2d model)
{
    double mass;
    double gravity;
    double lag;
    bool driven;
    array_double_1d rate;
    int64_t j;
    mass = carriage_mass(plant, axis);
    gravity = (*cspan_at(&plant, INT64_C(3)));
    lag = (*cspan_at(&plant, INT64_C(19) + axis));
    driven = (int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(1);
    matrix_set(INT64_C(8), 0.0, model);
    (*cspan_at(&model, INT64_C(6), INT64_C(7))) = 1.0;
    (*cspan_at(&model, INT64_C(0), INT64_C(2))) = 1.0;
    (*cspan_at(&model, INT64_C(2), INT64_C(4))) = 1.0;
    if (driven && (lag > 0.0))
    {
        (*cspan_at(&model, INT64_C(2), INT64_C(2))) = (-1.0) / lag;
        (*cspan_at(&model, INT64_C(2), INT64_C(6))) = 1.0 / lag;
    }
    else if (driven || (axis == INT64_C(2)))
    {
        (*cspan_at(&model, INT64_C(2), INT64_C(7))) = 1.0;
    }
    else
    {
        (*cspan_at(&model, INT64_C(2), INT64_C(7))) = 1.0 / mass;
        (*cspan_at(&model, INT64_C(2), INT64_C(1))) = (*cspan_at(&plant, INT64_C(2))) * gravity / mass;
    }
    if (axis != INT64_C(2))
    {
        rate = span_row(&model, INT64_C(3));
        (*cspan_at(&model, INT64_C(1), INT64_C(3))) = 1.0;
        for (j = INT64_C(0); j < INT64_C(8); j += INT64_C(1))
        {
            (*cspan_at(&rate, j)) = (-(*cspan_at(&model, INT64_C(2), j))) / length;
        }
        (*cspan_at(&rate, INT64_C(1))) = (*cspan_at(&rate, INT64_C(1))) - gravity / length;
        (*cspan_at(&rate, INT64_C(5))) = 1.0 / length;
    }
}
static void kalman_series(double part, double drift, double wind, array_double_2d model, array_double_2d transition, array_double_2d covariance, array_double_2d work)
{
    array_double_2d term;
    array_double_2d product;
    array_double_2d transposed;
    int64_t n;
    term = span_rows(&work, INT64_C(0), INT64_C(8));
    product = span_rows(&work, INT64_C(8), INT64_C(16));
    transposed = span_rows(&work, INT64_C(16), INT64_C(24));
    matrix_set(INT64_C(8), 1.0, transition);
    matrix_set(INT64_C(8), 1.0, term);
    for (n = INT64_C(1); n < INT64_C(17); n += INT64_C(1))
    {
        matrix_product(INT64_C(8), model, term, product);
        matrix_set(INT64_C(8), 0.0, term);
        matrix_add(INT64_C(8), part / n, product, term);
        matrix_add(INT64_C(8), 1.0, term, transition);
    }
    matrix_set(INT64_C(6), 0.0, covariance);
    matrix_set(INT64_C(6), 0.0, term);
    (*cspan_at(&term, INT64_C(4), INT64_C(4))) = drift * drift * part;
    (*cspan_at(&term, INT64_C(5), INT64_C(5))) = wind * wind * part;
    for (n = INT64_C(2); n < INT64_C(18); n += INT64_C(1))
    {
        matrix_add(INT64_C(6), 1.0, term, covariance);
        matrix_product(INT64_C(6), model, term, product);
        matrix_product_transposed(INT64_C(6), term, model, transposed);
        matrix_add(INT64_C(6), 1.0, transposed, product);
        matrix_set(INT64_C(6), 0.0, term);
        matrix_add(INT64_C(6), part / n, product, term);
    }
}
static void kalman_sampled(double sample_time, double drift, double wind, array_double_2d model, array_double_2d transition, array_double_2d covariance, array_double_2d work)
{
    double size;
    int64_t i;
    double total;
    int64_t j;
    double part;
    int64_t doublings;
    array_double_2d term;
    array_double_2d product;
    int64_t Dummy_0000;
    size = 0.0;
    for (i = INT64_C(0); i < INT64_C(8); i += INT64_C(1))
    {
        total = 0.0;
        for (j = INT64_C(0); j < INT64_C(8); j += INT64_C(1))
        {
            total = total + fabs((*cspan_at(&model, i, j)));
        }
        size = span_max(size, total);
    }
    part = sample_time;
    doublings = INT64_C(0);
    while(size * part > 0.5)
    {
        part = 0.5 * part;
        doublings = doublings + INT64_C(1);
    }
    kalman_series(part, drift, wind, model, transition, covariance, work);
    term = span_rows(&work, INT64_C(0), INT64_C(8));
    product = span_rows(&work, INT64_C(8), INT64_C(16));
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < doublings; Dummy_0000 += INT64_C(1))
    {
        matrix_product(INT64_C(6), transition, covariance, term);
        matrix_product_transposed(INT64_C(6), term, transition, product);
        matrix_add(INT64_C(6), 1.0, product, covariance);
        matrix_product(INT64_C(8), transition, transition, term);
        matrix_copy(INT64_C(8), term, transition);
    }
}
static double kalman_turn(array_double_2d spread, array_double_2d work)
{
    array_double_2d transposed;
    array_double_2d information;
    array_double_2d factor;
    array_double_2d solution;
    array_double_2d product;
    array_double_2d change;
    int64_t n;
    int64_t i;
    int64_t j;
    double largest;
    transposed = span_rows(&work, INT64_C(0), INT64_C(8));
    information = span_rows(&work, INT64_C(8), INT64_C(16));
    factor = span_rows(&work, INT64_C(16), INT64_C(24));
    solution = span_rows(&work, INT64_C(24), INT64_C(32));
    product = span_rows(&work, INT64_C(32), INT64_C(40));
    change = span_rows(&work, INT64_C(40), INT64_C(48));
    n = INT64_C(6);
    matrix_set(n, 1.0, factor);
    matrix_product(n, information, spread, solution);
    matrix_add(n, 1.0, solution, factor);
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < n; j += INT64_C(1))
        {
            (*cspan_at(&solution, i, j)) = (*cspan_at(&transposed, i, j));
            (*cspan_at(&solution, i, n + j)) = (*cspan_at(&information, i, j));
        }
    }
    matrix_solve(n, INT64_C(2) * n, factor, solution);
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < n; j += INT64_C(1))
        {
            (*cspan_at(&product, i, j)) = (*cspan_at(&solution, i, n + j));
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
    for (i = INT64_C(0); i < n; i += INT64_C(1))
    {
        if ((*cspan_at(&spread, i, i)) > 0.0)
        {
            largest = span_max(largest, (*cspan_at(&change, i, i)) / (*cspan_at(&spread, i, i)));
        }
    }
    return largest;
}
static void kalman_gain(int64_t axis, double first, double second, array_double_2d spread, array_double_2d table)
{
    double a;
    double b;
    double d;
    double determinant;
    int64_t i;
    array_double_1d row;
    a = (*cspan_at(&spread, INT64_C(0), INT64_C(0))) + first;
    b = 0.5 * ((*cspan_at(&spread, INT64_C(0), INT64_C(1))) + (*cspan_at(&spread, INT64_C(1), INT64_C(0))));
    d = (*cspan_at(&spread, INT64_C(1), INT64_C(1))) + second;
    if (axis == INT64_C(2))
    {
        b = 0.0;
    }
    determinant = a * d - b * b;
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        row = span_row(&table, INT64_C(1) + INT64_C(6) * axis + i);
        (*cspan_at(&row, INT64_C(8))) = (d * (*cspan_at(&spread, i, INT64_C(0))) - b * (*cspan_at(&spread, i, INT64_C(1)))) / determinant;
        (*cspan_at(&row, INT64_C(9))) = (a * (*cspan_at(&spread, i, INT64_C(1))) - b * (*cspan_at(&spread, i, INT64_C(0)))) / determinant;
    }
}
static void kalman_axis(int64_t axis, double sample_time, array_double_1d expected, array_double_2d work, array_double_2d table)
{
    array_double_2d transition;
    array_double_2d spread;
    array_double_2d transposed;
    array_double_2d information;
    double step;
    double wind;
    double position;
    double angle;
    int64_t first;
    int64_t i;
    int64_t j;
    int64_t turns;
    transition = span_rows(&work, INT64_C(48), INT64_C(56));
    spread = span_rows(&work, INT64_C(56), INT64_C(64));
    transposed = span_rows(&work, INT64_C(0), INT64_C(8));
    information = span_rows(&work, INT64_C(8), INT64_C(16));
    step = (*cspan_at(&expected, INT64_C(0)));
    wind = (*cspan_at(&expected, INT64_C(4)));
    if (axis == INT64_C(2))
    {
        step = (*cspan_at(&expected, INT64_C(1)));
        wind = 0.0;
    }
    position = step * step / 12.0;
    angle = (*cspan_at(&expected, INT64_C(2))) * (*cspan_at(&expected, INT64_C(2))) / 12.0;
    kalman_sampled(sample_time, (*cspan_at(&expected, INT64_C(3))), wind, span_rows(&work, INT64_C(64), INT64_C(72)), transition, spread, span_rows(&work, INT64_C(0), INT64_C(24)));
    first = INT64_C(1) + INT64_C(6) * axis;
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        for (j = INT64_C(0); j < INT64_C(8); j += INT64_C(1))
        {
            (*cspan_at(&table, first + i, j)) = (*cspan_at(&transition, i, j));
        }
    }
    matrix_transpose(INT64_C(6), transition, transposed);
    matrix_set(INT64_C(6), 0.0, information);
    (*cspan_at(&information, INT64_C(0), INT64_C(0))) = 1.0 / position;
    if (axis != INT64_C(2))
    {
        (*cspan_at(&information, INT64_C(1), INT64_C(1))) = 1.0 / angle;
    }
    turns = INT64_C(0);
    while((kalman_turn(spread, span_rows(&work, INT64_C(0), INT64_C(48))) > 1e-15) && (turns < INT64_C(60)))
    {
        turns = turns + INT64_C(1);
    }
    kalman_gain(axis, position, angle, spread, table);
    if (axis == INT64_C(2))
    {
        for (i = INT64_C(1); i < INT64_C(6); i += INT64_C(2))
        {
            for (j = INT64_C(0); j < INT64_C(10); j += INT64_C(1))
            {
                (*cspan_at(&table, first + i, j)) = 0.0;
            }
        }
    }
}
void segfmu_observer_design(array_double_1d plant, double sample_time, double length, array_double_1d expected, array_double_2d work, array_double_2d table)
{
    int64_t j;
    int64_t axis;
    for (j = INT64_C(0); j < INT64_C(10); j += INT64_C(1))
    {
        (*cspan_at(&table, INT64_C(0), j)) = 0.0;
    }
    (*cspan_at(&table, INT64_C(0), INT64_C(0))) = length;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        kalman_model(axis, plant, length, span_rows(&work, INT64_C(64), INT64_C(72)));
        kalman_axis(axis, sample_time, expected, work, table);
    }
}
void segfmu_rope_range(double length, double shortest, double longest, array_double_1d found)
{
    (*cspan_at(&found, INT64_C(0))) = shortest;
    (*cspan_at(&found, INT64_C(1))) = longest;
    if (!(shortest > 0.0))
    {
        (*cspan_at(&found, INT64_C(0))) = 0.2 * length;
    }
    if (!(longest > 0.0))
    {
        (*cspan_at(&found, INT64_C(1))) = 5.0 * length;
    }
}
int64_t segfmu_table_lengths(double shortest, double longest, int64_t rows, array_double_1d lengths)
{
    int64_t row;
    (*cspan_at(&lengths, INT64_C(0))) = shortest;
    if (!(longest > shortest))
    {
        return INT64_C(1);
    }
    for (row = INT64_C(1); row < rows - INT64_C(1); row += INT64_C(1))
    {
        (*cspan_at(&lengths, row)) = shortest * pow((longest / shortest), ((double)(row) / (double)((rows - INT64_C(1)))));
    }
    (*cspan_at(&lengths, rows - INT64_C(1))) = longest;
    return rows;
}
static double largest_angle(void)
{
    return 0.25;
}
static double largest_hoist_angle(void)
{
    return 0.5;
}
static double acts_late(array_double_1d plant, array_double_1d design)
{
    double dead;
    double lag;
    int64_t axis;
    double result;
    dead = 0.0;
    lag = 0.0;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        dead = span_max(dead, (*cspan_at(&plant, INT64_C(43) + axis)));
        lag = span_max(lag, (*cspan_at(&plant, INT64_C(19) + axis)));
    }
    if ((int64_t)((*cspan_at(&plant, INT64_C(18)))) != INT64_C(1))
    {
        lag = 0.0;
    }
    result = (*cspan_at(&design, INT64_C(0))) + (*cspan_at(&design, INT64_C(4))) + dead + 0.25 * lag;
    return result;
}
static void design_flat_gains(array_double_1d plant, array_double_1d design, double length, array_double_2d gains)
{
    double delay;
    double gravity;
    double ratio;
    double bandwidth;
    double hoist;
    double pendulum;
    delay = acts_late(plant, design);
    gravity = (*cspan_at(&plant, INT64_C(3)));
    ratio = (*cspan_at(&design, INT64_C(1)));
    bandwidth = segfmu_feedback_bandwidth(ratio, length, gravity, delay, largest_angle());
    hoist = segfmu_feedback_bandwidth((*cspan_at(&design, INT64_C(2))), length, gravity, delay, largest_hoist_angle());
    pendulum = ratio * sqrt(gravity / length);
    segfmu_feedback_gains(plant, length, bandwidth, pendulum, hoist, (*cspan_at(&design, INT64_C(3))), gains);
}
void segfmu_flat_table(array_double_1d plant, array_double_1d design, int64_t rows, array_double_1d lengths, array_double_3d table)
{
    int64_t row;
    for (row = INT64_C(0); row < rows; row += INT64_C(1))
    {
        design_flat_gains(plant, design, (*cspan_at(&lengths, row)), span_matrix(&table, row));
    }
}
static double sensor_step(array_double_1d sensors, int64_t signal)
{
    double step;
    double deviation;
    step = (*cspan_at(&sensors, INT64_C(13) + signal));
    deviation = (*cspan_at(&sensors, INT64_C(8) + signal));
    return sqrt(step * step + 12.0 * deviation * deviation);
}
void segfmu_set_steps(array_double_1d sensors, double longest, array_double_1d uncertainty)
{
    double bridge;
    double trolley;
    double first;
    if ((*cspan_at(&uncertainty, INT64_C(0))) == 0.0)
    {
        bridge = sensor_step(sensors, INT64_C(0));
        trolley = sensor_step(sensors, INT64_C(0) + INT64_C(1));
        (*cspan_at(&uncertainty, INT64_C(0))) = span_max(bridge, trolley);
    }
    if ((*cspan_at(&uncertainty, INT64_C(1))) == 0.0)
    {
        (*cspan_at(&uncertainty, INT64_C(1))) = sensor_step(sensors, INT64_C(0) + INT64_C(2));
    }
    if ((*cspan_at(&uncertainty, INT64_C(2))) == 0.0)
    {
        first = sensor_step(sensors, INT64_C(3));
        (*cspan_at(&uncertainty, INT64_C(2))) = span_max(first, sensor_step(sensors, INT64_C(3) + INT64_C(1)));
    }
    if ((*cspan_at(&uncertainty, INT64_C(0))) == 0.0)
    {
        (*cspan_at(&uncertainty, INT64_C(0))) = 0.0002 * longest;
    }
    if ((*cspan_at(&uncertainty, INT64_C(1))) == 0.0)
    {
        (*cspan_at(&uncertainty, INT64_C(1))) = 0.0002 * longest;
    }
    if ((*cspan_at(&uncertainty, INT64_C(2))) == 0.0)
    {
        (*cspan_at(&uncertainty, INT64_C(2))) = 6.283185307179586 / 4096.0;
    }
}
static void expect_errors(array_double_1d uncertainty, double gravity, double length, double sample_time, array_double_1d expected)
{
    double time;
    double repeated;
    time = sqrt(length / gravity);
    repeated = sqrt(span_max(1.0, 0.05 * time / sample_time));
    (*cspan_at(&expected, INT64_C(0))) = repeated * (*cspan_at(&uncertainty, INT64_C(0)));
    (*cspan_at(&expected, INT64_C(1))) = repeated * (*cspan_at(&uncertainty, INT64_C(1)));
    (*cspan_at(&expected, INT64_C(2))) = repeated * (*cspan_at(&uncertainty, INT64_C(2)));
    (*cspan_at(&expected, INT64_C(3))) = (*cspan_at(&uncertainty, INT64_C(3))) * gravity / sqrt(time);
    (*cspan_at(&expected, INT64_C(4))) = (*cspan_at(&uncertainty, INT64_C(4))) * gravity / sqrt(time);
}
bool segfmu_observer_table(array_double_1d plant, double sample_time, array_double_1d uncertainty, int64_t rows, array_double_1d lengths, array_double_1d expected, array_double_2d work, array_double_3d table)
{
    int64_t row;
    int64_t i;
    int64_t j;
    bool finite;
    finite = 1;
    for (row = INT64_C(0); row < rows; row += INT64_C(1))
    {
        expect_errors(uncertainty, (*cspan_at(&plant, INT64_C(3))), (*cspan_at(&lengths, row)), sample_time, expected);
        segfmu_observer_design(plant, sample_time, (*cspan_at(&lengths, row)), expected, work, span_matrix(&table, row));
        for (i = INT64_C(0); i < INT64_C(19); i += INT64_C(1))
        {
            for (j = INT64_C(0); j < INT64_C(10); j += INT64_C(1))
            {
                finite = finite && (fabs((*cspan_at(&table, row, i, j))) <= 1.7976931348623157e+308);
            }
        }
    }
    return finite;
}
static void offset_filter(bool first, double share, array_double_1d signals, array_double_2d states)
{
    int64_t i;
    double before;
    int64_t k;
    double lagged;
    double entering;
    for (i = INT64_C(0); i < INT64_C(7); i += INT64_C(1))
    {
        before = (*cspan_at(&states, INT64_C(0), i));
        (*cspan_at(&states, INT64_C(0), i)) = (*cspan_at(&signals, i));
        for (k = INT64_C(1); k < INT64_C(4); k += INT64_C(1))
        {
            lagged = (*cspan_at(&states, k, i));
            entering = before + (*cspan_at(&states, k - INT64_C(1), i));
            (*cspan_at(&states, k, i)) = ((1.0 - share) * lagged + share * entering) / (1.0 + share);
            if (first)
            {
                (*cspan_at(&states, k, i)) = (*cspan_at(&signals, i));
            }
            before = lagged;
        }
    }
}
static void offset_signals(array_double_1d measured, double start, array_double_1d signals)
{
    double phi_x;
    double phi_y;
    double length;
    int64_t i;
    double place;
    phi_x = (*cspan_at(&measured, INT64_C(3)));
    phi_y = (*cspan_at(&measured, INT64_C(3) + INT64_C(1)));
    (*cspan_at(&signals, INT64_C(3) + INT64_C(0))) = sin(phi_x);
    (*cspan_at(&signals, INT64_C(3) + INT64_C(1))) = (-cos(phi_x)) * sin(phi_y);
    (*cspan_at(&signals, INT64_C(3) + INT64_C(2))) = (-cos(phi_x)) * cos(phi_y);
    length = (*cspan_at(&measured, INT64_C(0) + INT64_C(2)));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&signals, INT64_C(0) + i)) = length * (*cspan_at(&signals, INT64_C(3) + i));
    }
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        place = (*cspan_at(&signals, INT64_C(0) + i));
        (*cspan_at(&signals, INT64_C(0) + i)) = place + (*cspan_at(&measured, INT64_C(0) + i));
    }
    (*cspan_at(&signals, INT64_C(6))) = start;
}
static double second_difference(int64_t signal, array_double_2d states)
{
    double difference;
    double result;
    difference = (*cspan_at(&states, INT64_C(1), signal)) - 2.0 * (*cspan_at(&states, INT64_C(2), signal));
    result = difference + (*cspan_at(&states, INT64_C(3), signal));
    return result;
}
static int64_t offset_residual(double* result_0_0001, double* result_1_0001, int64_t axis, double gravity, double square, array_double_2d states)
{
    int64_t sideways;
    int64_t upwards;
    double place;
    double height;
    double turn;
    double drop;
    double across;
    double down;
    sideways = INT64_C(3) + axis;
    upwards = INT64_C(3) + INT64_C(2);
    place = square * second_difference(INT64_C(0) + axis, states);
    height = square * second_difference(INT64_C(0) + INT64_C(2), states) + gravity;
    turn = square * second_difference(sideways, states);
    drop = square * second_difference(upwards, states);
    across = (*cspan_at(&states, INT64_C(3), sideways));
    down = (*cspan_at(&states, INT64_C(3), upwards));
    (*result_0_0001) = height * across - place * down;
    (*result_1_0001) = drop * across - turn * down;
    return 0;
}
static int64_t offset_noise(double* result_0, double* result_1_0001, array_double_1d parameters, double length)
{
    double w;
    double gravity;
    double share;
    double fifth;
    double angle;
    double of_angles;
    double residual;
    w = (*cspan_at(&parameters, INT64_C(24)));
    gravity = (*cspan_at(&parameters, INT64_C(6)));
    share = (*cspan_at(&parameters, INT64_C(1))) / 16.0;
    fifth = 3.0 * w * w * w * w * w;
    angle = length * length * fifth + gravity * w * (3.0 * gravity - 2.0 * length * w * w);
    of_angles = angle * (*cspan_at(&parameters, INT64_C(25)));
    residual = share * (of_angles + fifth * (*cspan_at(&parameters, INT64_C(26))));
    (*result_0) = residual;
    (*result_1_0001) = share * fifth * (*cspan_at(&parameters, INT64_C(25)));
    return 0;
}
static void offset_centre(int64_t axis, double share, array_double_1d values, array_double_1d means)
{
    int64_t i;
    int64_t k;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        k = INT64_C(0) + INT64_C(3) * axis + i;
        (*cspan_at(&means, k)) = (*cspan_at(&means, k)) + share * ((*cspan_at(&values, i)) - (*cspan_at(&means, k)));
        (*cspan_at(&values, i)) = (*cspan_at(&values, i)) - (*cspan_at(&means, k));
    }
}
static void offset_sum(double keep, array_double_1d values, array_double_1d sums)
{
    double residual;
    double factor;
    double instrument;
    double square;
    residual = (*cspan_at(&values, INT64_C(0)));
    factor = (*cspan_at(&values, INT64_C(1)));
    instrument = (*cspan_at(&values, INT64_C(2)));
    square = instrument * instrument;
    (*cspan_at(&sums, INT64_C(0))) = keep * (*cspan_at(&sums, INT64_C(0))) + instrument * residual;
    (*cspan_at(&sums, INT64_C(1))) = keep * (*cspan_at(&sums, INT64_C(1))) + instrument * factor;
    (*cspan_at(&sums, INT64_C(2))) = keep * (*cspan_at(&sums, INT64_C(2))) + square * residual * residual;
    (*cspan_at(&sums, INT64_C(3))) = keep * (*cspan_at(&sums, INT64_C(3))) + square * residual * factor;
    (*cspan_at(&sums, INT64_C(4))) = keep * (*cspan_at(&sums, INT64_C(4))) + square * factor * factor;
    (*cspan_at(&sums, INT64_C(5))) = keep * (*cspan_at(&sums, INT64_C(5))) + square;
}
static void offset_decide(array_double_1d parameters, double length, double noise, array_double_1d sums, array_double_1d estimate)
{
    double period;
    double bandwidth;
    double samples;
    double offset;
    double left;
    double least;
    double deviation;
    double largest;
    period = (*cspan_at(&parameters, INT64_C(1)));
    bandwidth = (*cspan_at(&parameters, INT64_C(24)));
    samples = 2.0 / (bandwidth * period);
    offset = (*cspan_at(&sums, INT64_C(0))) / (*cspan_at(&sums, INT64_C(1)));
    left = (*cspan_at(&sums, INT64_C(2))) - 2.0 * offset * (*cspan_at(&sums, INT64_C(3)));
    left = left + offset * offset * (*cspan_at(&sums, INT64_C(4)));
    least = noise * (*cspan_at(&sums, INT64_C(5))) / 16.0;
    deviation = sqrt(samples * (span_max(left, 0.0) + least)) / (*cspan_at(&sums, INT64_C(1)));
    (*cspan_at(&estimate, INT64_C(0))) = offset;
    (*cspan_at(&estimate, INT64_C(1))) = deviation;
    (*cspan_at(&estimate, INT64_C(2))) = (*cspan_at(&estimate, INT64_C(2))) + 1.0;
    largest = 3.0 * (*cspan_at(&parameters, INT64_C(23))) * length;
    if ((fabs(offset) < 5.0 * deviation) || (fabs(offset) > largest))
    {
        (*cspan_at(&estimate, INT64_C(2))) = 0.0;
    }
    if ((*cspan_at(&estimate, INT64_C(2))) * period * bandwidth > 5.0)
    {
        (*cspan_at(&estimate, INT64_C(3))) = offset;
        (*cspan_at(&estimate, INT64_C(4))) = 1.0;
    }
    else if (fabs(offset - (*cspan_at(&estimate, INT64_C(3)))) > 3.0 * deviation)
    {
        (*cspan_at(&estimate, INT64_C(4))) = 0.0;
    }
}
static void offset_equations(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory)
{
    array_double_1d means;
    array_double_1d signals;
    array_double_2d filtered;
    array_double_2d planned;
    bool first;
    double start;
    double bandwidth;
    double step;
    double square;
    int64_t axis;
    double gravity;
    double seen;
    double factor;
    double expected;
    double instrument;
    double residual;
    double settling;
    array_double_1d equation;
    means = span_row(&memory, INT64_C(8));
    signals = span_row(&memory, INT64_C(11));
    filtered = span_rows(&memory, INT64_C(0), INT64_C(4));
    planned = span_rows(&memory, INT64_C(4), INT64_C(8));
    first = (*cspan_at(&means, INT64_C(8))) < 0.5;
    (*cspan_at(&means, INT64_C(8))) = 1.0;
    start = 0.0;
    if (first)
    {
        start = 1.0;
    }
    bandwidth = (*cspan_at(&parameters, INT64_C(24)));
    step = bandwidth * (*cspan_at(&parameters, INT64_C(1)));
    square = bandwidth * bandwidth;
    offset_signals(measured, start, signals);
    offset_filter(first, 0.5 * step, signals, filtered);
    offset_signals(reference, start, signals);
    offset_filter(first, 0.5 * step, signals, planned);
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        gravity = (*cspan_at(&parameters, INT64_C(6)));
        offset_residual(&seen, &factor, axis, gravity, square, filtered);
        offset_residual(&expected, &instrument, axis, gravity, square, planned);
        residual = expected - seen;
        if (first)
        {
            (*cspan_at(&means, INT64_C(6) + axis)) = residual;
        }
        settling = (*cspan_at(&filtered, INT64_C(3), INT64_C(6)));
        equation = span_row(&memory, INT64_C(12) + axis);
        (*cspan_at(&equation, INT64_C(0))) = residual - (*cspan_at(&means, INT64_C(6) + axis)) * settling;
        (*cspan_at(&equation, INT64_C(1))) = factor;
        (*cspan_at(&equation, INT64_C(2))) = instrument;
        offset_centre(axis, step / 12.0, equation, means);
    }
}
static double offset_estimate(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory)
{
    array_double_1d sums;
    array_double_1d estimate;
    double length;
    double noise;
    double factor_noise;
    double power;
    int64_t axis;
    double instrument;
    double step;
    double aim;
    double used;
    double result;
    if ((*cspan_at(&parameters, INT64_C(23))) <= 0.0)
    {
        return 0.0;
    }
    sums = span_row(&memory, INT64_C(10));
    estimate = span_row(&memory, INT64_C(9));
    length = (*cspan_at(&measured, INT64_C(0) + INT64_C(2)));
    offset_equations(parameters, measured, reference, memory);
    offset_noise(&noise, &factor_noise, parameters, length);
    power = 0.0;
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        instrument = (*cspan_at(&memory, INT64_C(12) + axis, INT64_C(2)));
        power = power + instrument * instrument;
    }
    if (power > 9.0 * factor_noise)
    {
        step = (*cspan_at(&parameters, INT64_C(24))) * (*cspan_at(&parameters, INT64_C(1)));
        offset_sum(1.0 - step / 60.0, span_row(&memory, INT64_C(12)), sums);
        offset_sum(1.0, span_row(&memory, INT64_C(12) + INT64_C(1)), sums);
        if ((*cspan_at(&sums, INT64_C(1))) > 0.0)
        {
            offset_decide(parameters, length, noise, sums, estimate);
        }
    }
    aim = (*cspan_at(&estimate, INT64_C(4))) * (*cspan_at(&estimate, INT64_C(3)));
    used = (*cspan_at(&estimate, INT64_C(5)));
    (*cspan_at(&estimate, INT64_C(5))) = aim + (*cspan_at(&parameters, INT64_C(11))) * (used - aim);
    result = (*cspan_at(&estimate, INT64_C(5)));
    return result;
}
double segfmu_nominal_payload(double expected, double payload)
{
    if (expected > 0.0)
    {
        return expected;
    }
    return payload;
}
double segfmu_signal_age(double dead_time, double sampling, double period)
{
    double age;
    double ratio;
    if (sampling <= 0.0)
    {
        return dead_time;
    }
    age = sampling * (int64_t)ceil(dead_time / sampling - 1e-06);
    ratio = period / sampling;
    if (fabs(ratio - (int64_t)floor(ratio + 0.5)) > 1e-06)
    {
        age = dead_time + 0.5 * sampling;
    }
    return age;
}
double segfmu_drive_bound(array_double_1d plant, int64_t axis, double sign)
{
    double moved;
    double by_force;
    double bound;
    bound = static_bound(plant, axis, sign);
    if ((int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(1))
    {
        moved = carriage_mass(plant, axis) + (*cspan_at(&plant, INT64_C(2)));
        by_force = bound / moved;
        if ((axis == INT64_C(2)) && (sign > 0.0))
        {
            by_force = 0.0;
        }
        else if ((axis == INT64_C(2)) && (bound > 0.0))
        {
            by_force = span_max(by_force - (*cspan_at(&plant, INT64_C(3))), 0.001 * (*cspan_at(&plant, INT64_C(3))));
        }
        bound = acceleration_bound(plant, axis, sign);
        if ((by_force > 0.0) && ((bound <= 0.0) || (by_force < bound)))
        {
            bound = by_force;
        }
    }
    if (bound > 0.0)
    {
        return bound;
    }
    return 1e+99;
}
static double weak_drive(void)
{
    return 0.1;
}
static double drive_strength(array_double_1d plant, int64_t axis)
{
    double weight;
    double weaker;
    weight = (*cspan_at(&plant, INT64_C(3)));
    if ((int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(0))
    {
        weight = weight * carriage_mass(plant, axis);
    }
    weaker = span_min(segfmu_drive_bound(plant, axis, 1.0), segfmu_drive_bound(plant, axis, -1.0));
    return span_min(weaker / (weak_drive() * weight), 1.0);
}
void segfmu_set_walks(array_double_1d plant, array_double_1d uncertainty)
{
    double strength;
    strength = span_min(drive_strength(plant, INT64_C(0)), drive_strength(plant, INT64_C(1)));
    (*cspan_at(&uncertainty, INT64_C(4))) = strength * (*cspan_at(&uncertainty, INT64_C(4)));
}
void segfmu_set_drives(array_double_1d plant, array_double_1d tracking)
{
    int64_t axis;
    double greatest;
    (*cspan_at(&tracking, INT64_C(0))) = (*cspan_at(&plant, INT64_C(18)));
    (*cspan_at(&tracking, INT64_C(3) + INT64_C(0))) = carriage_mass(plant, INT64_C(0));
    (*cspan_at(&tracking, INT64_C(3) + INT64_C(1))) = carriage_mass(plant, INT64_C(1));
    (*cspan_at(&tracking, INT64_C(3) + INT64_C(2))) = (*cspan_at(&plant, INT64_C(2)));
    (*cspan_at(&tracking, INT64_C(6))) = (*cspan_at(&plant, INT64_C(3)));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        (*cspan_at(&tracking, INT64_C(15) + axis)) = segfmu_drive_bound(plant, axis, 1.0);
        (*cspan_at(&tracking, INT64_C(12) + axis)) = -segfmu_drive_bound(plant, axis, -1.0);
        (*cspan_at(&tracking, INT64_C(30) + axis)) = (*cspan_at(&plant, INT64_C(34) + axis));
        (*cspan_at(&tracking, INT64_C(33) + axis)) = (*cspan_at(&plant, INT64_C(37) + axis));
        (*cspan_at(&tracking, INT64_C(36) + axis)) = (*cspan_at(&plant, INT64_C(40) + axis));
    }
    greatest = 0.0;
    if ((int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(1))
    {
        greatest = span_min(0.9 * (*cspan_at(&plant, INT64_C(3))), (*cspan_at(&tracking, INT64_C(15) + INT64_C(2))));
    }
    (*cspan_at(&tracking, INT64_C(15) + INT64_C(2))) = greatest;
}
static void set_noise(array_double_1d uncertainty, double gravity, double longest, array_double_1d tracking)
{
    double wake;
    double angle;
    double place;
    wake = (*cspan_at(&uncertainty, INT64_C(5)));
    (*cspan_at(&tracking, INT64_C(20))) = wake * (*cspan_at(&uncertainty, INT64_C(0)));
    (*cspan_at(&tracking, INT64_C(21))) = wake * (*cspan_at(&uncertainty, INT64_C(1)));
    (*cspan_at(&tracking, INT64_C(22))) = wake * (*cspan_at(&uncertainty, INT64_C(2)));
    (*cspan_at(&tracking, INT64_C(23))) = (*cspan_at(&uncertainty, INT64_C(6)));
    (*cspan_at(&tracking, INT64_C(24))) = span_min(4.0 * sqrt(gravity / longest), 0.5 / (*cspan_at(&tracking, INT64_C(1))));
    angle = (*cspan_at(&uncertainty, INT64_C(2)));
    place = span_max((*cspan_at(&uncertainty, INT64_C(0))), (*cspan_at(&uncertainty, INT64_C(1))));
    (*cspan_at(&tracking, INT64_C(25))) = angle * angle / 12.0;
    (*cspan_at(&tracking, INT64_C(26))) = place * place / 12.0;
}
void segfmu_set_tracking(array_double_1d plant, array_double_1d design, double longest, array_double_1d tracking)
{
    double period;
    double age;
    int64_t axis;
    period = (*cspan_at(&tracking, INT64_C(1)));
    segfmu_set_drives(plant, tracking);
    age = segfmu_signal_age((*cspan_at(&design, INT64_C(7))), (*cspan_at(&design, INT64_C(8))), period);
    (*cspan_at(&tracking, INT64_C(2))) = age / period;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        (*cspan_at(&tracking, INT64_C(27) + axis)) = (age + (*cspan_at(&plant, INT64_C(43) + axis))) / period;
    }
    (*cspan_at(&tracking, INT64_C(19))) = period / (*cspan_at(&design, INT64_C(9)));
    set_noise(design, (*cspan_at(&plant, INT64_C(3))), longest, tracking);
}
void segfmu_set_fading(array_double_1d tracking)
{
    double fade;
    fade = (*cspan_at(&tracking, INT64_C(10)));
    (*cspan_at(&tracking, INT64_C(11))) = 0.0;
    if (fade > 0.0)
    {
        (*cspan_at(&tracking, INT64_C(11))) = exp((-(*cspan_at(&tracking, INT64_C(1)))) / fade);
    }
}
static double spectral_radius(int64_t n, array_double_2d a, array_double_2d square)
{
    double total;
    double weight;
    int64_t Dummy_0000;
    double size;
    int64_t i;
    int64_t j;
    total = 0.0;
    weight = 1.0;
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(30); Dummy_0000 += INT64_C(1))
    {
        size = 0.0;
        for (i = INT64_C(0); i < n; i += INT64_C(1))
        {
            for (j = INT64_C(0); j < n; j += INT64_C(1))
            {
                size = span_max(size, fabs((*cspan_at(&a, i, j))));
            }
        }
        if (!(size > 0.0))
        {
            return 0.0;
        }
        total = total + weight * log(size);
        weight = 0.5 * weight;
        for (i = INT64_C(0); i < n; i += INT64_C(1))
        {
            for (j = INT64_C(0); j < n; j += INT64_C(1))
            {
                (*cspan_at(&a, i, j)) = (*cspan_at(&a, i, j)) / size;
            }
        }
        matrix_product(n, a, a, square);
        matrix_copy(n, square, a);
    }
    return exp(total);
}
static bool is_state(int64_t axis, bool lagging, int64_t place)
{
    if (place == INT64_C(6))
    {
        return lagging;
    }
    if ((place == INT64_C(1)) || (place == INT64_C(3)))
    {
        return axis != INT64_C(2);
    }
    return (place == INT64_C(0)) || (place == INT64_C(2));
}
static void axis_gains(int64_t axis, array_double_1d plant, double length, array_double_3d table, array_double_1d gains)
{
    double sign;
    double scale;
    bool driven;
    int64_t i;
    double command;
    double place;
    double velocity;
    sign = 1.0 - 2.0 * axis;
    scale = 1.0;
    driven = (int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(1);
    if ((axis == INT64_C(2)) && (!driven))
    {
        scale = 1.0 / (*cspan_at(&plant, INT64_C(2)));
    }
    for (i = INT64_C(0); i < INT64_C(8); i += INT64_C(1))
    {
        (*cspan_at(&gains, i)) = 0.0;
    }
    command = scale * scheduled_gain(length, axis, INT64_C(10), table);
    (*cspan_at(&gains, INT64_C(6))) = command;
    place = scheduled_gain(length, axis, INT64_C(0) + axis, table);
    velocity = scheduled_gain(length, axis, INT64_C(5) + axis, table);
    (*cspan_at(&gains, INT64_C(0))) = scale * place;
    (*cspan_at(&gains, INT64_C(2))) = scale * velocity;
    if (driven && ((*cspan_at(&plant, INT64_C(19) + axis)) <= 0.0))
    {
        (*cspan_at(&gains, INT64_C(2))) = scale * velocity + command;
    }
    if (axis != INT64_C(2))
    {
        (*cspan_at(&gains, INT64_C(1))) = sign * scheduled_gain(length, axis, INT64_C(3) + axis, table);
        (*cspan_at(&gains, INT64_C(3))) = sign * scheduled_gain(length, axis, INT64_C(8) + axis, table);
    }
}
static int64_t close_loop(int64_t axis, bool lagging, double delay, array_double_1d gains, array_double_2d work)
{
    array_double_2d transition;
    array_double_2d loop;
    int64_t own;
    int64_t whole;
    double share;
    int64_t i;
    int64_t j;
    double effect;
    int64_t order;
    transition = span_rows(&work, INT64_C(8), INT64_C(16));
    loop = span_rows(&work, INT64_C(48), INT64_C(96));
    own = INT64_C(7);
    whole = span_min_int((int64_t)(delay + 1e-09), INT64_C(48) - own - INT64_C(2));
    share = span_min(span_max(delay - whole, 0.0), 1.0);
    order = own + whole;
    if (share > 1e-09)
    {
        order = order + INT64_C(1);
    }
    for (i = INT64_C(0); i < order; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < order; j += INT64_C(1))
        {
            (*cspan_at(&loop, i, j)) = 0.0;
        }
    }
    for (i = INT64_C(0); i < own; i += INT64_C(1))
    {
        if (is_state(axis, lagging, i))
        {
            effect = (*cspan_at(&transition, i, INT64_C(7)));
            for (j = INT64_C(0); j < own; j += INT64_C(1))
            {
                if (is_state(axis, lagging, j))
                {
                    (*cspan_at(&loop, i, j)) = (*cspan_at(&transition, i, j));
                    if (whole == INT64_C(0))
                    {
                        (*cspan_at(&loop, i, j)) = (*cspan_at(&loop, i, j)) - (1.0 - share) * effect * (*cspan_at(&gains, j));
                    }
                }
            }
            if (whole > INT64_C(0))
            {
                (*cspan_at(&loop, i, own + whole - INT64_C(1))) = (1.0 - share) * effect;
            }
            if (share > 1e-09)
            {
                (*cspan_at(&loop, i, own + whole)) = share * effect;
            }
        }
    }
    for (i = own; i < order; i += INT64_C(1))
    {
        if (i > own)
        {
            (*cspan_at(&loop, i, i - INT64_C(1))) = 1.0;
        }
        else
        {
            for (j = INT64_C(0); j < own; j += INT64_C(1))
            {
                if (is_state(axis, lagging, j))
                {
                    (*cspan_at(&loop, i, j)) = -(*cspan_at(&gains, j));
                }
            }
        }
    }
    return order;
}
int64_t segfmu_check_gains(array_double_1d plant, double period, int64_t predicted, array_double_1d ends, array_double_3d table, array_double_2d work, array_double_1d fault)
{
    array_double_1d lengths;
    array_double_1d gains;
    int64_t count;
    int64_t axis;
    bool driven;
    bool lagging;
    double delay;
    int64_t row;
    int64_t order;
    double growth;
    int64_t status;
    lengths = span_row(&work, INT64_C(144));
    gains = span_row(&work, INT64_C(145));
    count = segfmu_table_lengths((*cspan_at(&ends, INT64_C(0))), (*cspan_at(&ends, INT64_C(1))), INT64_C(33), lengths);
    status = INT64_C(0);
    (*cspan_at(&fault, INT64_C(3))) = 1.0 + 1e-06;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        driven = (int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(1);
        lagging = driven && ((*cspan_at(&plant, INT64_C(19) + axis)) > 0.0);
        delay = (*cspan_at(&plant, INT64_C(43) + axis)) / period;
        if (predicted == INT64_C(1))
        {
            delay = 0.0;
        }
        for (row = INT64_C(0); row < count; row += INT64_C(1))
        {
            kalman_model(axis, plant, (*cspan_at(&lengths, row)), span_rows(&work, INT64_C(0), INT64_C(8)));
            kalman_sampled(period, 0.0, 0.0, span_rows(&work, INT64_C(0), INT64_C(8)), span_rows(&work, INT64_C(8), INT64_C(16)), span_rows(&work, INT64_C(16), INT64_C(24)), span_rows(&work, INT64_C(24), INT64_C(48)));
            axis_gains(axis, plant, (*cspan_at(&lengths, row)), table, gains);
            order = close_loop(axis, lagging, delay, gains, work);
            growth = spectral_radius(order, span_rows(&work, INT64_C(48), INT64_C(96)), span_rows(&work, INT64_C(96), INT64_C(144)));
            if (growth > (*cspan_at(&fault, INT64_C(3))))
            {
                (*cspan_at(&fault, INT64_C(3))) = growth;
                (*cspan_at(&fault, INT64_C(1))) = (double)(axis);
                (*cspan_at(&fault, INT64_C(2))) = (*cspan_at(&lengths, row));
                status = INT64_C(15);
            }
        }
    }
    return status;
}
static void track_wake(array_double_1d parameters, array_double_1d measured, array_double_1d reference, array_double_2d memory)
{
    int64_t i;
    double tolerance;
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        tolerance = (*cspan_at(&parameters, INT64_C(20)));
        if (i == INT64_C(0) + INT64_C(2))
        {
            tolerance = (*cspan_at(&parameters, INT64_C(21)));
        }
        else if (i >= INT64_C(3))
        {
            tolerance = (*cspan_at(&parameters, INT64_C(22)));
        }
        if (fabs((*cspan_at(&measured, i)) - (*cspan_at(&reference, i))) > tolerance)
        {
            (*cspan_at(&memory, INT64_C(4), INT64_C(6))) = 1.0;
        }
    }
}
static void track_offset(array_double_1d parameters, array_double_2d tick, array_double_2d memory)
{
    array_double_1d measured;
    array_double_2d offsets;
    double before;
    double offset;
    array_double_1d hoist;
    int64_t length;
    int64_t i;
    measured = span_row(&tick, INT64_C(0));
    offsets = span_rows(&memory, INT64_C(11), INT64_C(11) + INT64_C(14));
    before = (*cspan_at(&offsets, INT64_C(9), INT64_C(5)));
    offset = offset_estimate(parameters, measured, span_row(&memory, INT64_C(6)), offsets);
    if ((*cspan_at(&parameters, INT64_C(40))) < 0.5)
    {
        offset = 0.0;
        before = 0.0;
    }
    hoist = span_row(&memory, INT64_C(0) + INT64_C(2));
    (*cspan_at(&hoist, INT64_C(0))) = (*cspan_at(&hoist, INT64_C(0))) + (offset - before);
    length = INT64_C(0) + INT64_C(2);
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(10), i)) = (*cspan_at(&measured, i));
    }
    (*cspan_at(&memory, INT64_C(10), length)) = (*cspan_at(&measured, length)) + offset;
}
static void track_start(array_double_1d measured, array_double_1d reference, array_double_2d memory)
{
    array_double_2d estimate;
    int64_t i;
    int64_t phi_x;
    int64_t phi_y;
    estimate = span_rows(&memory, INT64_C(0), INT64_C(3));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&estimate, i, INT64_C(0))) = (*cspan_at(&measured, i)) - (*cspan_at(&reference, i));
    }
    phi_x = INT64_C(3);
    phi_y = INT64_C(3) + INT64_C(1);
    (*cspan_at(&estimate, INT64_C(0), INT64_C(1))) = (*cspan_at(&measured, phi_x)) - (*cspan_at(&reference, phi_x));
    (*cspan_at(&estimate, INT64_C(1), INT64_C(1))) = (*cspan_at(&reference, phi_y)) - (*cspan_at(&measured, phi_y));
    (*cspan_at(&memory, INT64_C(3), INT64_C(3))) = 1.0;
}
static void track_observe(array_double_1d parameters, array_double_3d table, array_double_2d memory)
{
    array_double_1d measured;
    array_double_1d reference;
    double length;
    measured = span_row(&memory, INT64_C(10));
    reference = span_row(&memory, INT64_C(6));
    length = (*cspan_at(&measured, INT64_C(0) + INT64_C(2)));
    track_wake(parameters, measured, reference, memory);
    if ((*cspan_at(&memory, INT64_C(3), INT64_C(3))) < 0.5)
    {
        track_start(measured, reference, memory);
    }
    else
    {
        advance_estimates(parameters, length, table, memory);
        segfmu_observer_correct(length, table, measured, reference, span_rows(&memory, INT64_C(0), INT64_C(3)));
    }
    predict_present(parameters, length, table, memory);
}
static bool track_acts(array_double_1d parameters, array_double_2d memory)
{
    bool result;
    result = ((*cspan_at(&parameters, INT64_C(9))) > 0.5) && ((*cspan_at(&memory, INT64_C(4), INT64_C(6))) > 0.5);
    return result;
}
static void track_deviation(array_double_1d parameters, array_double_2d memory)
{
    double length;
    array_double_1d deviation;
    array_double_1d target;
    int64_t i;
    double moves;
    double slant;
    array_double_1d estimate;
    double sign;
    double rejected;
    double angle;
    int64_t place;
    length = (*cspan_at(&memory, INT64_C(10), INT64_C(0) + INT64_C(2)));
    deviation = span_row(&memory, INT64_C(7));
    target = span_row(&memory, INT64_C(8));
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        (*cspan_at(&target, i)) = 0.0;
    }
    moves = 1.0;
    if ((int64_t)((*cspan_at(&parameters, INT64_C(39)))) == INT64_C(1))
    {
        moves = 0.0;
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&deviation, INT64_C(0) + i)) = (*cspan_at(&memory, INT64_C(25) + i, INT64_C(0)));
        (*cspan_at(&deviation, INT64_C(5) + i)) = (*cspan_at(&memory, INT64_C(25) + i, INT64_C(2)));
    }
    slant = 0.0;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        estimate = span_row(&memory, INT64_C(25) + i);
        sign = 1.0 - 2.0 * i;
        rejected = (*cspan_at(&parameters, INT64_C(8))) * (*cspan_at(&estimate, INT64_C(5)));
        angle = rejected / (*cspan_at(&parameters, INT64_C(6)));
        place = INT64_C(0) + i;
        (*cspan_at(&deviation, place)) = (*cspan_at(&deviation, place)) + moves * length * angle;
        (*cspan_at(&deviation, INT64_C(3) + i)) = sign * ((*cspan_at(&estimate, INT64_C(1))) - angle);
        (*cspan_at(&deviation, INT64_C(8) + i)) = sign * (*cspan_at(&estimate, INT64_C(3)));
        slant = slant + 0.5 * moves * length * angle * angle;
    }
    (*cspan_at(&target, INT64_C(0) + INT64_C(2))) = length - (*cspan_at(&deviation, INT64_C(0) + INT64_C(2))) + slant;
    (*cspan_at(&deviation, INT64_C(0) + INT64_C(2))) = length;
}
static void track_situation(array_double_1d parameters, array_double_2d tick, array_double_2d memory)
{
    array_double_1d situation;
    array_double_1d deviation;
    double length;
    double share;
    double weight;
    int64_t i;
    double velocity;
    double place;
    double rate;
    double sign;
    situation = span_row(&memory, INT64_C(30));
    deviation = span_row(&memory, INT64_C(7));
    length = (*cspan_at(&memory, INT64_C(10), INT64_C(0) + INT64_C(2)));
    share = (*cspan_at(&memory, INT64_C(5), INT64_C(3)));
    weight = (*cspan_at(&parameters, INT64_C(3) + INT64_C(2))) * (*cspan_at(&parameters, INT64_C(6)));
    (*cspan_at(&situation, INT64_C(0))) = (1.0 + share) * weight;
    (*cspan_at(&situation, INT64_C(1))) = length;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        velocity = (*cspan_at(&memory, INT64_C(25) + i, INT64_C(2)));
        if ((int64_t)((*cspan_at(&parameters, INT64_C(0)))) == INT64_C(1))
        {
            velocity = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + i));
        }
        velocity = velocity + (*cspan_at(&tick, INT64_C(1), INT64_C(5) + i));
        (*cspan_at(&situation, INT64_C(2) + i)) = velocity;
        place = (*cspan_at(&deviation, INT64_C(0) + i)) - (*cspan_at(&memory, INT64_C(8), INT64_C(0) + i));
        rate = (*cspan_at(&deviation, INT64_C(5) + i));
        if (i != INT64_C(2))
        {
            sign = 1.0 - 2.0 * i;
            place = place + length * sign * (*cspan_at(&deviation, INT64_C(3) + i));
            rate = rate + length * sign * (*cspan_at(&deviation, INT64_C(8) + i));
        }
        (*cspan_at(&situation, INT64_C(5) + i)) = place;
        (*cspan_at(&situation, INT64_C(8) + i)) = rate;
    }
}
static void track_forces(array_double_1d parameters, array_double_2d memory, array_double_1d correction)
{
    double rejected;
    double payload;
    int64_t i;
    array_double_1d estimate;
    double mass;
    double pull;
    double drift;
    double rope;
    double share;
    rejected = (*cspan_at(&parameters, INT64_C(7)));
    payload = (*cspan_at(&parameters, INT64_C(3) + INT64_C(2)));
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        estimate = span_row(&memory, INT64_C(25) + i);
        mass = rejected * (*cspan_at(&parameters, INT64_C(3) + i));
        pull = (*cspan_at(&parameters, INT64_C(8))) * payload * (*cspan_at(&estimate, INT64_C(5)));
        (*cspan_at(&correction, i)) = (*cspan_at(&correction, i)) - mass * (*cspan_at(&estimate, INT64_C(4))) - pull;
    }
    drift = (*cspan_at(&memory, INT64_C(25) + INT64_C(2), INT64_C(4)));
    rope = (*cspan_at(&correction, INT64_C(2))) / (*cspan_at(&parameters, INT64_C(18))) - rejected * drift;
    share = (*cspan_at(&memory, INT64_C(5), INT64_C(3)));
    rope = (1.0 + share) * rope - share * (*cspan_at(&parameters, INT64_C(6)));
    (*cspan_at(&correction, INT64_C(2))) = payload * rope;
}
static void track_law(array_double_1d parameters, array_double_3d gains, array_double_2d tick, array_double_2d memory)
{
    array_double_1d correction;
    bool driven;
    int64_t i;
    double added;
    double fade;
    correction = span_row(&tick, INT64_C(3));
    driven = (int64_t)((*cspan_at(&parameters, INT64_C(0)))) == INT64_C(1);
    track_deviation(parameters, memory);
    track_situation(parameters, tick, memory);
    if (!track_acts(parameters, memory))
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&correction, i)) = 0.0;
            if (driven)
            {
                added = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + i));
                fade = span_max((*cspan_at(&parameters, INT64_C(10))), (*cspan_at(&parameters, INT64_C(1))));
                (*cspan_at(&correction, i)) = (-added) / fade;
            }
        }
        return;
    }
    segfmu_feedback_correction(span_row(&memory, INT64_C(7)), span_row(&memory, INT64_C(8)), span_row(&memory, INT64_C(3)), gains, correction);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        bound_return(i, parameters, gains, tick, span_row(&memory, INT64_C(30)));
    }
    if (!driven)
    {
        track_forces(parameters, memory, correction);
    }
}
static void track_hoist(array_double_1d parameters, array_double_2d memory)
{
    double gravity;
    array_double_1d held;
    double share;
    double force;
    double rope;
    gravity = (*cspan_at(&parameters, INT64_C(6)));
    held = span_row(&memory, INT64_C(4));
    share = (*cspan_at(&memory, INT64_C(5), INT64_C(3)));
    force = (*cspan_at(&held, INT64_C(3) + INT64_C(2)));
    rope = (force / (*cspan_at(&parameters, INT64_C(3) + INT64_C(2))) + share * gravity) / (1.0 + share);
    (*cspan_at(&held, INT64_C(0) + INT64_C(2))) = rope;
    if (track_acts(parameters, memory))
    {
        share = share - (*cspan_at(&parameters, INT64_C(19))) * (1.0 + share) * rope / gravity;
        (*cspan_at(&memory, INT64_C(5), INT64_C(3))) = span_min(span_max(share, -0.98), 9.0);
    }
}
void segfmu_track_setpoint(array_double_1d parameters, array_double_3d table, array_double_3d gains, array_double_2d tick, array_double_2d memory)
{
    array_double_1d correction;
    array_double_1d held;
    array_double_1d step;
    array_double_1d reference;
    int64_t i;
    correction = span_row(&tick, INT64_C(3));
    held = span_row(&memory, INT64_C(4));
    step = span_row(&memory, INT64_C(5));
    reference = span_row(&tick, INT64_C(1));
    if ((*cspan_at(&memory, INT64_C(3), INT64_C(3))) < 0.5)
    {
        remember_start(reference, memory);
    }
    remember_tick(parameters, reference, memory);
    aged_reference(parameters, memory);
    track_offset(parameters, tick, memory);
    track_observe(parameters, table, memory);
    track_law(parameters, gains, tick, memory);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        if ((*cspan_at(&memory, INT64_C(3), INT64_C(4))) > 0.5)
        {
            (*cspan_at(&step, INT64_C(0) + i)) = (*cspan_at(&held, INT64_C(3) + i)) - (*cspan_at(&correction, i));
        }
        (*cspan_at(&step, INT64_C(0) + i)) = (*cspan_at(&parameters, INT64_C(11))) * (*cspan_at(&step, INT64_C(0) + i));
        (*cspan_at(&correction, i)) = (*cspan_at(&correction, i)) + (*cspan_at(&step, INT64_C(0) + i));
        bound_correction(i, parameters, tick, span_row(&memory, INT64_C(30)));
        (*cspan_at(&held, INT64_C(3) + i)) = (*cspan_at(&correction, i));
        (*cspan_at(&held, INT64_C(0) + i)) = (*cspan_at(&correction, i));
    }
    if ((int64_t)((*cspan_at(&parameters, INT64_C(0)))) == INT64_C(0))
    {
        track_hoist(parameters, memory);
    }
    (*cspan_at(&memory, INT64_C(3), INT64_C(4))) = 0.0;
}
void segfmu_crane_rhs(array_double_1d state, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative)
{
    double l;
    double phi_x;
    double phi_y;
    double x_t_rate;
    double y_t_rate;
    double l_rate;
    double phi_x_rate;
    double phi_y_rate;
    double bridge_mass;
    double trolley_mass;
    double payload_mass;
    double gravity;
    double f_x_t;
    double f_y_t;
    double f_l;
    double f_phi_x;
    double f_phi_y;
    double w_x;
    double w_y;
    double w_z;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    double c10;
    double c11;
    double c12;
    double c13;
    double c14;
    double c15;
    double c16;
    double c17;
    double c18;
    double c19;
    double c20;
    double c21;
    double c22;
    double c23;
    double c24;
    double c25;
    double c26;
    double c27;
    double c28;
    l = (*cspan_at(&state, INT64_C(2)));
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(4)));
    x_t_rate = (*cspan_at(&state, INT64_C(5)));
    y_t_rate = (*cspan_at(&state, INT64_C(6)));
    l_rate = (*cspan_at(&state, INT64_C(7)));
    phi_x_rate = (*cspan_at(&state, INT64_C(8)));
    phi_y_rate = (*cspan_at(&state, INT64_C(9)));
    bridge_mass = (*cspan_at(&masses, INT64_C(0)));
    trolley_mass = (*cspan_at(&masses, INT64_C(1)));
    payload_mass = (*cspan_at(&masses, INT64_C(2)));
    gravity = (*cspan_at(&masses, INT64_C(3)));
    f_x_t = (*cspan_at(&generalized_force, INT64_C(0)));
    f_y_t = (*cspan_at(&generalized_force, INT64_C(1)));
    f_l = (*cspan_at(&generalized_force, INT64_C(2)));
    f_phi_x = (*cspan_at(&generalized_force, INT64_C(3)));
    f_phi_y = (*cspan_at(&generalized_force, INT64_C(4)));
    w_x = (*cspan_at(&load_force, INT64_C(0)));
    w_y = (*cspan_at(&load_force, INT64_C(1)));
    w_z = (*cspan_at(&load_force, INT64_C(2)));
    c0 = INT64_C(1) / (bridge_mass + trolley_mass);
    c1 = sin(phi_x);
    c2 = cos(phi_x);
    c3 = INT64_C(1) / l;
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
    c18 = INT64_C(1) / payload_mass;
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
    (*cspan_at(&derivative, INT64_C(0))) = x_t_rate;
    (*cspan_at(&derivative, INT64_C(1))) = y_t_rate;
    (*cspan_at(&derivative, INT64_C(2))) = l_rate;
    (*cspan_at(&derivative, INT64_C(3))) = phi_x_rate;
    (*cspan_at(&derivative, INT64_C(4))) = phi_y_rate;
    (*cspan_at(&derivative, INT64_C(5))) = (-c0) * c6;
    (*cspan_at(&derivative, INT64_C(6))) = c14;
    (*cspan_at(&derivative, INT64_C(7))) = (-c1) * c19 + c22 * c27 + c28 * c8;
    (*cspan_at(&derivative, INT64_C(8))) = (-c3) * (c12 * c28 + c19 * c2 + c26 * c27);
    (*cspan_at(&derivative, INT64_C(9))) = c10 * ((-c27) * c7 + c28 * c9);
}
void segfmu_crane_driven(array_double_1d state, array_double_1d carriage, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_1d derivative, array_double_1d force)
{
    double l;
    double phi_x;
    double phi_y;
    double x_t_rate;
    double y_t_rate;
    double l_rate;
    double phi_x_rate;
    double phi_y_rate;
    double bridge_mass;
    double trolley_mass;
    double payload_mass;
    double gravity;
    double a_x;
    double a_y;
    double a_l;
    double f_phi_x;
    double f_phi_y;
    double w_x;
    double w_y;
    double w_z;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    double c10;
    double c11;
    double c12;
    double c13;
    double c14;
    double c15;
    double c16;
    double c17;
    double c18;
    double c19;
    double c20;
    double c21;
    double c22;
    double c23;
    double c24;
    double c25;
    double c26;
    double c27;
    double c28;
    double c29;
    double c30;
    double c31;
    double c32;
    double c33;
    double c34;
    l = (*cspan_at(&state, INT64_C(2)));
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(4)));
    x_t_rate = (*cspan_at(&state, INT64_C(5)));
    y_t_rate = (*cspan_at(&state, INT64_C(6)));
    l_rate = (*cspan_at(&state, INT64_C(7)));
    phi_x_rate = (*cspan_at(&state, INT64_C(8)));
    phi_y_rate = (*cspan_at(&state, INT64_C(9)));
    bridge_mass = (*cspan_at(&masses, INT64_C(0)));
    trolley_mass = (*cspan_at(&masses, INT64_C(1)));
    payload_mass = (*cspan_at(&masses, INT64_C(2)));
    gravity = (*cspan_at(&masses, INT64_C(3)));
    a_x = (*cspan_at(&carriage, INT64_C(0)));
    a_y = (*cspan_at(&carriage, INT64_C(1)));
    a_l = (*cspan_at(&carriage, INT64_C(2)));
    f_phi_x = (*cspan_at(&generalized_force, INT64_C(3)));
    f_phi_y = (*cspan_at(&generalized_force, INT64_C(4)));
    w_x = (*cspan_at(&load_force, INT64_C(0)));
    w_y = (*cspan_at(&load_force, INT64_C(1)));
    w_z = (*cspan_at(&load_force, INT64_C(2)));
    c0 = INT64_C(1) / (l * l);
    c1 = INT64_C(1) / payload_mass;
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
    c27 = INT64_C(1) / l;
    c28 = c2 * c27;
    c29 = c12 * c27;
    c30 = c25 / c2;
    c31 = (-c29) * c30;
    c32 = c11 * c27;
    c33 = c3 * c32;
    c34 = -c24;
    (*cspan_at(&derivative, INT64_C(0))) = x_t_rate;
    (*cspan_at(&derivative, INT64_C(1))) = y_t_rate;
    (*cspan_at(&derivative, INT64_C(2))) = l_rate;
    (*cspan_at(&derivative, INT64_C(3))) = phi_x_rate;
    (*cspan_at(&derivative, INT64_C(4))) = phi_y_rate;
    (*cspan_at(&derivative, INT64_C(5))) = a_x;
    (*cspan_at(&derivative, INT64_C(6))) = a_y;
    (*cspan_at(&derivative, INT64_C(7))) = a_l;
    (*cspan_at(&derivative, INT64_C(8))) = (-c0) * c24;
    (*cspan_at(&derivative, INT64_C(9))) = c0 * c25 / (c2 * c2);
    (*cspan_at(&force, INT64_C(0))) = a_x * (bridge_mass + trolley_mass) + payload_mass * ((-c24) * c28 + c26 + c8) - w_x;
    (*cspan_at(&force, INT64_C(1))) = a_y * trolley_mass + payload_mass * (c19 - c24 * c33 + c31) - w_y;
    (*cspan_at(&force, INT64_C(2))) = payload_mass * ((-c11) * c2 * (c20 + c31 + c33 * c34) - c12 * c2 * (c23 + c29 * c3 * c34 + c30 * c32) + c3 * (c26 + c28 * c34 + c9));
}
void segfmu_crane_flat_inverse(array_double_2d flat, array_double_1d masses, array_double_1d force, array_double_1d state, array_double_1d acceleration)
{
    double p0x;
    double p0y;
    double p0z;
    double p1x;
    double p1y;
    double p1z;
    double p2x;
    double p2y;
    double p2z;
    double p3x;
    double p3y;
    double p3z;
    double p4x;
    double p4y;
    double p4z;
    double bridge_mass;
    double trolley_mass;
    double payload_mass;
    double gravity;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    double c10;
    double c11;
    double c12;
    double c13;
    double c14;
    double c15;
    double c16;
    double c17;
    double c18;
    double c19;
    double c20;
    double c21;
    double c22;
    double c23;
    double c24;
    double c25;
    double c26;
    double c27;
    double c28;
    double c29;
    double c30;
    double c31;
    double c32;
    double c33;
    double c34;
    double c35;
    double c36;
    double c37;
    double c38;
    double c39;
    double c40;
    double c41;
    double c42;
    double c43;
    double c44;
    double c45;
    double c46;
    double c47;
    double c48;
    double c49;
    double c50;
    double c51;
    double c52;
    double c53;
    double c54;
    double c55;
    double c56;
    double c57;
    double c58;
    double c59;
    double c60;
    double c61;
    double c62;
    double c63;
    double c64;
    double c65;
    double c66;
    double c67;
    p0x = (*cspan_at(&flat, INT64_C(0), INT64_C(0)));
    p0y = (*cspan_at(&flat, INT64_C(0), INT64_C(1)));
    p0z = (*cspan_at(&flat, INT64_C(0), INT64_C(2)));
    p1x = (*cspan_at(&flat, INT64_C(1), INT64_C(0)));
    p1y = (*cspan_at(&flat, INT64_C(1), INT64_C(1)));
    p1z = (*cspan_at(&flat, INT64_C(1), INT64_C(2)));
    p2x = (*cspan_at(&flat, INT64_C(2), INT64_C(0)));
    p2y = (*cspan_at(&flat, INT64_C(2), INT64_C(1)));
    p2z = (*cspan_at(&flat, INT64_C(2), INT64_C(2)));
    p3x = (*cspan_at(&flat, INT64_C(3), INT64_C(0)));
    p3y = (*cspan_at(&flat, INT64_C(3), INT64_C(1)));
    p3z = (*cspan_at(&flat, INT64_C(3), INT64_C(2)));
    p4x = (*cspan_at(&flat, INT64_C(4), INT64_C(0)));
    p4y = (*cspan_at(&flat, INT64_C(4), INT64_C(1)));
    p4z = (*cspan_at(&flat, INT64_C(4), INT64_C(2)));
    bridge_mass = (*cspan_at(&masses, INT64_C(0)));
    trolley_mass = (*cspan_at(&masses, INT64_C(1)));
    payload_mass = (*cspan_at(&masses, INT64_C(2)));
    gravity = (*cspan_at(&masses, INT64_C(3)));
    c0 = gravity + p2z;
    c1 = INT64_C(1) / c0;
    c2 = c1 * p0z;
    c3 = c1 * p2z;
    c4 = p0z * p4z;
    c5 = c0 * c0;
    c6 = INT64_C(1) / c5;
    c7 = c6 * p2x;
    c8 = c1 * p3z;
    c9 = c8 * p2x;
    c10 = c1 * p1z;
    c11 = c1 * (c8 * p0z - p1z);
    c12 = p0z * p3x;
    c13 = p1z * p2x;
    c14 = c6 * p3z;
    c15 = c10 * (c9 - p3x) + c11 * p3x + c14 * (c12 + c13 - INT64_C(2) * c9 * p0z) - c2 * p4x - c3 * p2x + c4 * c7 + p2x;
    c16 = p2y * p4z;
    c17 = c6 * p0z;
    c18 = p2y * p3z;
    c19 = p0z * p3y;
    c20 = p1z * p2y;
    c21 = INT64_C(2) * c18;
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
    c34 = INT64_C(1) / c27;
    c35 = c1 * c34;
    c36 = c12 * p2x;
    c37 = c19 * p2y;
    c38 = c27 * c6;
    c39 = c34 - c38;
    c40 = p0z * p3z;
    c41 = INT64_C(1) / c26;
    c42 = c28 * p3x;
    c43 = INT64_C(1) / c28;
    c44 = c43 * p2y;
    c45 = c44 * p3y;
    c46 = c0 * c43;
    c47 = c46 * p3z;
    c48 = INT64_C(1) / c25;
    c49 = c35 * p2y;
    c50 = c41 + c6;
    c51 = c30 * c41;
    c52 = c32 * c41;
    c53 = p2x * p2y;
    c54 = INT64_C(1) / (c26 * sqrt(c26));
    c55 = c44 * p2x;
    c56 = c46 * p2x;
    c57 = INT64_C(2) * c41;
    c58 = c42 * c57;
    c59 = c23 * c57;
    c60 = c43 * p2x;
    c61 = c60 * p3y;
    c62 = p2x / (c25 * sqrt(c25));
    c63 = c0 * c18;
    c64 = c60 * p3z;
    c65 = c0 * p3y;
    c66 = c65 * p2y;
    c67 = INT64_C(2) * c48;
    (*cspan_at(&force, INT64_C(0))) = c15 * (bridge_mass + trolley_mass) + p2x * payload_mass;
    (*cspan_at(&force, INT64_C(1))) = c22 * trolley_mass + p2y * payload_mass;
    (*cspan_at(&force, INT64_C(2))) = (-c27) * payload_mass;
    (*cspan_at(&state, INT64_C(0))) = (-c2) * p2x + p0x;
    (*cspan_at(&state, INT64_C(1))) = (-c2) * p2y + p0y;
    (*cspan_at(&state, INT64_C(2))) = (-c2) * c27;
    (*cspan_at(&state, INT64_C(3))) = atan2(-p2x, c28);
    (*cspan_at(&state, INT64_C(4))) = atan2(p2y, c0);
    (*cspan_at(&state, INT64_C(5))) = c14 * c29 + c31 + p1x;
    (*cspan_at(&state, INT64_C(6))) = c17 * c18 + c33 + p1y;
    (*cspan_at(&state, INT64_C(7))) = (-c10) * c27 - c35 * c36 - c35 * c37 - c39 * c40;
    (*cspan_at(&state, INT64_C(8))) = c41 * ((-c42) + c45 * p2x + c47 * p2x);
    (*cspan_at(&state, INT64_C(9))) = c48 * (c0 * p3y - c18);
    (*cspan_at(&acceleration, INT64_C(0))) = c15;
    (*cspan_at(&acceleration, INT64_C(1))) = c22;
    (*cspan_at(&acceleration, INT64_C(2))) = (-c27) * c3 - c29 * c35 * p4x + c34 * p3x * (c23 * c51 + c31 + c40 * c50 * p2x + c52 * c53) + c34 * p3y * (c18 * c50 * p0z + c24 * c52 + c33 + c51 * c53) - c39 * c4 - c49 * p0z * p4y - p1z * (c35 * p2x * p3x + c39 * p3z + c49 * p3y) + p3z * (c12 * c34 * c7 + c34 * c37 * c6 - c34 * p1z + c36 * c54 + c37 * c54 + c38 * p1z - c40 * ((-c0) * c54 - c35 + INT64_C(2) * c27 / (c0 * c0 * c0)));
    (*cspan_at(&acceleration, INT64_C(3))) = c41 * ((-c28) * p4x + c55 * p4y + c56 * p4z + p3x * ((-c45) * c59 + c45 - c47 * c59 + c47 + c58 * p2x) - p3y * (c21 * c41 * c56 + c24 * c57 * c61 + c24 * c62 * p3y + c44 * p3x - c58 * p2y - c61 + c62 * c63) - p3z * ((-c0) * c58 + c46 * p3x + c5 * c57 * c64 + c5 * c62 * p3z + c55 * c57 * c65 + c62 * c66 - c64));
    (*cspan_at(&acceleration, INT64_C(4))) = c48 * (c0 * p4y - c16 - p3y * ((-c24) * c67 * p3z + c66 * c67 + p3z) + p3z * ((-c5) * c67 * p3y + c63 * c67 + p3y));
}
void segfmu_crane_load(array_double_1d state, array_double_2d load)
{
    double x_t;
    double y_t;
    double l;
    double phi_x;
    double phi_y;
    double x_t_rate;
    double y_t_rate;
    double l_rate;
    double phi_x_rate;
    double phi_y_rate;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    x_t = (*cspan_at(&state, INT64_C(0)));
    y_t = (*cspan_at(&state, INT64_C(1)));
    l = (*cspan_at(&state, INT64_C(2)));
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(4)));
    x_t_rate = (*cspan_at(&state, INT64_C(5)));
    y_t_rate = (*cspan_at(&state, INT64_C(6)));
    l_rate = (*cspan_at(&state, INT64_C(7)));
    phi_x_rate = (*cspan_at(&state, INT64_C(8)));
    phi_y_rate = (*cspan_at(&state, INT64_C(9)));
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
    (*cspan_at(&load, INT64_C(0), INT64_C(0))) = c1 + x_t;
    (*cspan_at(&load, INT64_C(0), INT64_C(1))) = (-c5) + y_t;
    (*cspan_at(&load, INT64_C(0), INT64_C(2))) = -c7;
    (*cspan_at(&load, INT64_C(1), INT64_C(0))) = c0 * l_rate + c4 * phi_x_rate + x_t_rate;
    (*cspan_at(&load, INT64_C(1), INT64_C(1))) = (-c2) * c8 + c2 * c9 - c7 * phi_y_rate + y_t_rate;
    (*cspan_at(&load, INT64_C(1), INT64_C(2))) = c5 * phi_y_rate - c6 * c8 + c6 * c9;
}
void segfmu_crane_energy(array_double_1d state, array_double_1d masses, array_double_1d energy)
{
    double l;
    double phi_x;
    double phi_y;
    double x_t_rate;
    double y_t_rate;
    double l_rate;
    double phi_x_rate;
    double phi_y_rate;
    double bridge_mass;
    double trolley_mass;
    double payload_mass;
    double gravity;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    double c10;
    double c11;
    double c12;
    l = (*cspan_at(&state, INT64_C(2)));
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(4)));
    x_t_rate = (*cspan_at(&state, INT64_C(5)));
    y_t_rate = (*cspan_at(&state, INT64_C(6)));
    l_rate = (*cspan_at(&state, INT64_C(7)));
    phi_x_rate = (*cspan_at(&state, INT64_C(8)));
    phi_y_rate = (*cspan_at(&state, INT64_C(9)));
    bridge_mass = (*cspan_at(&masses, INT64_C(0)));
    trolley_mass = (*cspan_at(&masses, INT64_C(1)));
    payload_mass = (*cspan_at(&masses, INT64_C(2)));
    gravity = (*cspan_at(&masses, INT64_C(3)));
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
    (*cspan_at(&energy, INT64_C(0))) = 1.0 / 2.0 * bridge_mass * c0 + 1.0 / 2.0 * payload_mass * (c10 * c10 + c11 * c11 + c12 * c12) + 1.0 / 2.0 * trolley_mass * (c0 + y_t_rate * y_t_rate);
    (*cspan_at(&energy, INT64_C(1))) = (-c4) * c8 * gravity * payload_mass;
}
static void crane_rhs_partials(array_double_1d state, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_2d partials)
{
    double l;
    double phi_x;
    double phi_y;
    double l_rate;
    double phi_x_rate;
    double phi_y_rate;
    double bridge_mass;
    double trolley_mass;
    double payload_mass;
    double gravity;
    double f_x_t;
    double f_y_t;
    double f_l;
    double f_phi_x;
    double f_phi_y;
    double w_x;
    double w_y;
    double w_z;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    double c10;
    double c11;
    double c12;
    double c13;
    double c14;
    double c15;
    double c16;
    double c17;
    double c18;
    double c19;
    double c20;
    double c21;
    double c22;
    double c23;
    double c24;
    double c25;
    double c26;
    double c27;
    double c28;
    double c29;
    double c30;
    double c31;
    double c32;
    double c33;
    double c34;
    double c35;
    double c36;
    double c37;
    double c38;
    double c39;
    double c40;
    double c41;
    double c42;
    double c43;
    double c44;
    double c45;
    double c46;
    double c47;
    double c48;
    double c49;
    double c50;
    double c51;
    double c52;
    double c53;
    double c54;
    double c55;
    double c56;
    double c57;
    double c58;
    double c59;
    double c60;
    double c61;
    double c62;
    double c63;
    double c64;
    double c65;
    double c66;
    double c67;
    double c68;
    double c69;
    double c70;
    double c71;
    double c72;
    double c73;
    double c74;
    double c75;
    double c76;
    double c77;
    double c78;
    double c79;
    double c80;
    double c81;
    double c82;
    double c83;
    double c84;
    double c85;
    double c86;
    double c87;
    double c88;
    double c89;
    double c90;
    double c91;
    double c92;
    double c93;
    double c94;
    double c95;
    double c96;
    double c97;
    double c98;
    double c99;
    double c100;
    double c101;
    double c102;
    double c103;
    double c104;
    double c105;
    double c106;
    double c107;
    double c108;
    double c109;
    double c110;
    double c111;
    double c112;
    l = (*cspan_at(&state, INT64_C(2)));
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(4)));
    l_rate = (*cspan_at(&state, INT64_C(7)));
    phi_x_rate = (*cspan_at(&state, INT64_C(8)));
    phi_y_rate = (*cspan_at(&state, INT64_C(9)));
    bridge_mass = (*cspan_at(&masses, INT64_C(0)));
    trolley_mass = (*cspan_at(&masses, INT64_C(1)));
    payload_mass = (*cspan_at(&masses, INT64_C(2)));
    gravity = (*cspan_at(&masses, INT64_C(3)));
    f_x_t = (*cspan_at(&generalized_force, INT64_C(0)));
    f_y_t = (*cspan_at(&generalized_force, INT64_C(1)));
    f_l = (*cspan_at(&generalized_force, INT64_C(2)));
    f_phi_x = (*cspan_at(&generalized_force, INT64_C(3)));
    f_phi_y = (*cspan_at(&generalized_force, INT64_C(4)));
    w_x = (*cspan_at(&load_force, INT64_C(0)));
    w_y = (*cspan_at(&load_force, INT64_C(1)));
    w_z = (*cspan_at(&load_force, INT64_C(2)));
    c0 = INT64_C(1) / (bridge_mass + trolley_mass);
    c1 = INT64_C(1) / (l * l);
    c2 = cos(phi_x);
    c3 = c2 * f_phi_x;
    c4 = c0 * c1 * c3;
    c5 = c2 * f_l;
    c6 = INT64_C(1) / l;
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
    c17 = INT64_C(1) / c2;
    c18 = c17 * f_phi_y;
    c19 = c16 * c18;
    c20 = c15 * c8 - c19;
    c21 = INT64_C(1) / trolley_mass;
    c22 = c1 * c21;
    c23 = c20 * c22;
    c24 = c7 * f_l;
    c25 = c13 * f_phi_x;
    c26 = c16 * c7;
    c27 = c2 * c2;
    c28 = INT64_C(1) / c27;
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
    c42 = INT64_C(1) / payload_mass;
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
    c92 = INT64_C(2) * c2;
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
    c109 = INT64_C(2) * c6;
    c110 = (-c16) * c17 * c22 * c36;
    c111 = c103 * c6;
    c112 = c109 * c17;
    (*cspan_at(&partials, INT64_C(0), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(2))) = c4;
    (*cspan_at(&partials, INT64_C(0), INT64_C(3))) = -c11;
    (*cspan_at(&partials, INT64_C(0), INT64_C(4))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(7))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(8))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(9))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(10))) = c0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(11))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(12))) = c12;
    (*cspan_at(&partials, INT64_C(0), INT64_C(13))) = c14;
    (*cspan_at(&partials, INT64_C(0), INT64_C(14))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(15))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(16))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(17))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(2))) = c23;
    (*cspan_at(&partials, INT64_C(1), INT64_C(3))) = c31;
    (*cspan_at(&partials, INT64_C(1), INT64_C(4))) = (-c21) * c33;
    (*cspan_at(&partials, INT64_C(1), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(7))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(8))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(9))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(10))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(11))) = c21;
    (*cspan_at(&partials, INT64_C(1), INT64_C(12))) = c35;
    (*cspan_at(&partials, INT64_C(1), INT64_C(13))) = c38;
    (*cspan_at(&partials, INT64_C(1), INT64_C(14))) = c41;
    (*cspan_at(&partials, INT64_C(1), INT64_C(15))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(16))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(17))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(2))) = c34 * c61 - c44 * c7 + c45 * c54;
    (*cspan_at(&partials, INT64_C(2), INT64_C(3))) = (-c2) * ((-c0) * c68 + c2 * l_rate * phi_x_rate - c65 * phi_x_rate - c67) + c34 * (c31 + c82) - c36 * (c42 * c79 + c81) + c45 * (c49 * l_rate - c70 - c71 * phi_x_rate - c72) + c63 * c7 - c7 * c77;
    (*cspan_at(&partials, INT64_C(2), INT64_C(4))) = c2 * c89;
    (*cspan_at(&partials, INT64_C(2), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(7))) = c92 * ((-c50) + c90 + c91);
    (*cspan_at(&partials, INT64_C(2), INT64_C(8))) = INT64_C(2) * c34 * c69 + INT64_C(2) * c45 * c73 + INT64_C(2) * c65 * c7;
    (*cspan_at(&partials, INT64_C(2), INT64_C(9))) = c92 * c93;
    (*cspan_at(&partials, INT64_C(2), INT64_C(10))) = c12;
    (*cspan_at(&partials, INT64_C(2), INT64_C(11))) = c35;
    (*cspan_at(&partials, INT64_C(2), INT64_C(12))) = c100 * c27 + c27 * c95 + c96 * c97;
    (*cspan_at(&partials, INT64_C(2), INT64_C(13))) = c101;
    (*cspan_at(&partials, INT64_C(2), INT64_C(14))) = c102;
    (*cspan_at(&partials, INT64_C(2), INT64_C(15))) = c103;
    (*cspan_at(&partials, INT64_C(2), INT64_C(16))) = (-c34) * c42;
    (*cspan_at(&partials, INT64_C(2), INT64_C(17))) = (-c42) * c45;
    (*cspan_at(&partials, INT64_C(3), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(2))) = c6 * (c104 * c2 * c6 + c15 * c6 * c7 * c87 + c16 * c6 * c7 * c76 - c2 * c44 - c26 * c54 - c36 * c61);
    (*cspan_at(&partials, INT64_C(3), INT64_C(3))) = c6 * (c104 * c7 - c105 * c26 - c106 * c2 - c107 * c36 + c2 * c63 - c2 * c77);
    (*cspan_at(&partials, INT64_C(3), INT64_C(4))) = (-c108) * c89;
    (*cspan_at(&partials, INT64_C(3), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(7))) = (-c109) * (c27 * phi_x_rate + c7 * c90 + c7 * c91);
    (*cspan_at(&partials, INT64_C(3), INT64_C(8))) = c109 * (c2 * c65 - c26 * c73 - c36 * c69);
    (*cspan_at(&partials, INT64_C(3), INT64_C(9))) = (-INT64_C(2)) * c108 * c93;
    (*cspan_at(&partials, INT64_C(3), INT64_C(10))) = c14;
    (*cspan_at(&partials, INT64_C(3), INT64_C(11))) = c38;
    (*cspan_at(&partials, INT64_C(3), INT64_C(12))) = c101;
    (*cspan_at(&partials, INT64_C(3), INT64_C(13))) = c1 * (c100 * c96 + c27 * c97 + c95 * c96);
    (*cspan_at(&partials, INT64_C(3), INT64_C(14))) = c110;
    (*cspan_at(&partials, INT64_C(3), INT64_C(15))) = c13 * c42;
    (*cspan_at(&partials, INT64_C(3), INT64_C(16))) = c111 * c15;
    (*cspan_at(&partials, INT64_C(3), INT64_C(17))) = c111 * c16;
    (*cspan_at(&partials, INT64_C(4), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(2))) = c39 * ((-c15) * c54 + c15 * c6 * c76 + c16 * c61 - c6 * c88);
    (*cspan_at(&partials, INT64_C(4), INT64_C(3))) = c39 * ((-c105) * c15 + c107 * c16 + c16 * c17 * c7 * c87 - c17 * c7 * c85);
    (*cspan_at(&partials, INT64_C(4), INT64_C(4))) = c39 * ((-c106) - c15 * c84 + c16 * c86 - c77);
    (*cspan_at(&partials, INT64_C(4), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(7))) = c112 * ((-c15) * c60 + c16 * c52);
    (*cspan_at(&partials, INT64_C(4), INT64_C(8))) = c112 * ((-c15) * c73 + c16 * c69);
    (*cspan_at(&partials, INT64_C(4), INT64_C(9))) = c112 * ((-c15) * c74 + c16 * c71);
    (*cspan_at(&partials, INT64_C(4), INT64_C(10))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(11))) = c41;
    (*cspan_at(&partials, INT64_C(4), INT64_C(12))) = c102;
    (*cspan_at(&partials, INT64_C(4), INT64_C(13))) = c110;
    (*cspan_at(&partials, INT64_C(4), INT64_C(14))) = c1 * c28 * (c42 * c98 + c94 * c99);
    (*cspan_at(&partials, INT64_C(4), INT64_C(15))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(16))) = (-c40) * c42;
    (*cspan_at(&partials, INT64_C(4), INT64_C(17))) = c15 * c39 * c42;
}
static void crane_driven_partials(array_double_1d state, array_double_1d carriage, array_double_1d generalized_force, array_double_1d load_force, array_double_1d masses, array_double_2d partials)
{
    double l;
    double phi_x;
    double phi_y;
    double l_rate;
    double phi_x_rate;
    double phi_y_rate;
    double bridge_mass;
    double trolley_mass;
    double payload_mass;
    double gravity;
    double a_x;
    double a_y;
    double a_l;
    double f_phi_x;
    double f_phi_y;
    double w_x;
    double w_y;
    double w_z;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    double c10;
    double c11;
    double c12;
    double c13;
    double c14;
    double c15;
    double c16;
    double c17;
    double c18;
    double c19;
    double c20;
    double c21;
    double c22;
    double c23;
    double c24;
    double c25;
    double c26;
    double c27;
    double c28;
    double c29;
    double c30;
    double c31;
    double c32;
    double c33;
    double c34;
    double c35;
    double c36;
    double c37;
    double c38;
    double c39;
    double c40;
    double c41;
    double c42;
    double c43;
    double c44;
    double c45;
    double c46;
    double c47;
    double c48;
    double c49;
    double c50;
    double c51;
    double c52;
    double c53;
    double c54;
    double c55;
    double c56;
    double c57;
    double c58;
    double c59;
    double c60;
    double c61;
    double c62;
    double c63;
    double c64;
    double c65;
    double c66;
    double c67;
    double c68;
    double c69;
    double c70;
    double c71;
    double c72;
    double c73;
    double c74;
    double c75;
    double c76;
    double c77;
    double c78;
    double c79;
    double c80;
    double c81;
    double c82;
    double c83;
    double c84;
    double c85;
    double c86;
    double c87;
    double c88;
    double c89;
    double c90;
    double c91;
    double c92;
    double c93;
    double c94;
    double c95;
    double c96;
    double c97;
    double c98;
    double c99;
    double c100;
    double c101;
    double c102;
    double c103;
    double c104;
    double c105;
    double c106;
    double c107;
    double c108;
    double c109;
    double c110;
    double c111;
    double c112;
    double c113;
    double c114;
    double c115;
    double c116;
    double c117;
    double c118;
    double c119;
    double c120;
    double c121;
    double c122;
    double c123;
    double c124;
    double c125;
    double c126;
    double c127;
    double c128;
    double c129;
    double c130;
    double c131;
    double c132;
    double c133;
    double c134;
    double c135;
    double c136;
    double c137;
    double c138;
    double c139;
    double c140;
    double c141;
    double c142;
    double c143;
    double c144;
    double c145;
    double c146;
    double c147;
    double c148;
    double c149;
    double c150;
    double c151;
    double c152;
    double c153;
    double c154;
    double c155;
    double c156;
    double c157;
    double c158;
    double c159;
    double c160;
    double c161;
    double c162;
    l = (*cspan_at(&state, INT64_C(2)));
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(4)));
    l_rate = (*cspan_at(&state, INT64_C(7)));
    phi_x_rate = (*cspan_at(&state, INT64_C(8)));
    phi_y_rate = (*cspan_at(&state, INT64_C(9)));
    bridge_mass = (*cspan_at(&masses, INT64_C(0)));
    trolley_mass = (*cspan_at(&masses, INT64_C(1)));
    payload_mass = (*cspan_at(&masses, INT64_C(2)));
    gravity = (*cspan_at(&masses, INT64_C(3)));
    a_x = (*cspan_at(&carriage, INT64_C(0)));
    a_y = (*cspan_at(&carriage, INT64_C(1)));
    a_l = (*cspan_at(&carriage, INT64_C(2)));
    f_phi_x = (*cspan_at(&generalized_force, INT64_C(3)));
    f_phi_y = (*cspan_at(&generalized_force, INT64_C(4)));
    w_x = (*cspan_at(&load_force, INT64_C(0)));
    w_y = (*cspan_at(&load_force, INT64_C(1)));
    w_z = (*cspan_at(&load_force, INT64_C(2)));
    c0 = INT64_C(1) / (l * l);
    c1 = INT64_C(1) / l;
    c2 = INT64_C(1) / payload_mass;
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
    c77 = INT64_C(2) * c1;
    c78 = c28 * c50 - c4 * c8 + c42 * c55;
    c79 = c14 * c34 + c18 * c43;
    c80 = c5 * c77;
    c81 = c1 * c4;
    c82 = c1 * c50;
    c83 = c14 * c14;
    c84 = c18 * c18;
    c85 = c84 - INT64_C(1);
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
    c96 = INT64_C(1) / c4;
    c97 = c77 * c96;
    c98 = c0 * c96;
    c99 = c18 * c4;
    c100 = c14 * c4;
    c101 = (-c100) * c66 - c5 * c70 + c5 * c71 + c63 * c99;
    c102 = INT64_C(1) / c75;
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
    c119 = INT64_C(2) * payload_mass;
    c120 = c119 * c4;
    c121 = c75 - INT64_C(1);
    c122 = c4 * c50;
    c123 = (-c122) * payload_mass;
    c124 = c75 * c86 + INT64_C(1);
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
    c140 = (-c133) * c86 + INT64_C(1);
    c141 = c100 * payload_mass;
    c142 = c133 - INT64_C(1);
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
    c160 = c158 + c159 - c75 + INT64_C(1);
    c161 = -c133;
    c162 = c139 + c142 * c84 + c161;
    (*cspan_at(&partials, INT64_C(0), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(2))) = c0 * (INT64_C(2) * c1 * c48 - c61);
    (*cspan_at(&partials, INT64_C(0), INT64_C(3))) = (-c1) * c67;
    (*cspan_at(&partials, INT64_C(0), INT64_C(4))) = (-c73) * c74;
    (*cspan_at(&partials, INT64_C(0), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(7))) = (-c76) * c77;
    (*cspan_at(&partials, INT64_C(0), INT64_C(8))) = (-c77) * c78;
    (*cspan_at(&partials, INT64_C(0), INT64_C(9))) = (-c79) * c80;
    (*cspan_at(&partials, INT64_C(0), INT64_C(10))) = -c81;
    (*cspan_at(&partials, INT64_C(0), INT64_C(11))) = -c82;
    (*cspan_at(&partials, INT64_C(0), INT64_C(12))) = c86 * c87;
    (*cspan_at(&partials, INT64_C(0), INT64_C(13))) = c88;
    (*cspan_at(&partials, INT64_C(0), INT64_C(14))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(15))) = c2 * c81;
    (*cspan_at(&partials, INT64_C(0), INT64_C(16))) = c2 * c82;
    (*cspan_at(&partials, INT64_C(0), INT64_C(17))) = c2 * c89;
    (*cspan_at(&partials, INT64_C(1), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(2))) = (-c98) * (c14 * c59 + c18 * c91 - c90 - c93 + c95 * c97);
    (*cspan_at(&partials, INT64_C(1), INT64_C(3))) = c103 * (c101 + c80 * c95 * c96);
    (*cspan_at(&partials, INT64_C(1), INT64_C(4))) = (-c104) * c105;
    (*cspan_at(&partials, INT64_C(1), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(7))) = (-c106) * c97;
    (*cspan_at(&partials, INT64_C(1), INT64_C(8))) = (-c108) * c97;
    (*cspan_at(&partials, INT64_C(1), INT64_C(9))) = (-c109) * c97;
    (*cspan_at(&partials, INT64_C(1), INT64_C(10))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(11))) = c110;
    (*cspan_at(&partials, INT64_C(1), INT64_C(12))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(13))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(14))) = c102 * c88;
    (*cspan_at(&partials, INT64_C(1), INT64_C(15))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(16))) = (-c110) * c2;
    (*cspan_at(&partials, INT64_C(1), INT64_C(17))) = c111 * c2;
    (*cspan_at(&partials, INT64_C(2), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(2))) = (-payload_mass) * (c112 + c113 * c114 - c115 * c81);
    (*cspan_at(&partials, INT64_C(2), INT64_C(3))) = (-c116) * payload_mass;
    (*cspan_at(&partials, INT64_C(2), INT64_C(4))) = (-c117) * c4 * c73;
    (*cspan_at(&partials, INT64_C(2), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(7))) = c118 * c120;
    (*cspan_at(&partials, INT64_C(2), INT64_C(8))) = c119 * ((-c4) * c78 - c8);
    (*cspan_at(&partials, INT64_C(2), INT64_C(9))) = (-c120) * c5 * c79;
    (*cspan_at(&partials, INT64_C(2), INT64_C(10))) = bridge_mass - c121 * payload_mass + trolley_mass;
    (*cspan_at(&partials, INT64_C(2), INT64_C(11))) = c123;
    (*cspan_at(&partials, INT64_C(2), INT64_C(12))) = c117 * c124;
    (*cspan_at(&partials, INT64_C(2), INT64_C(13))) = c81;
    (*cspan_at(&partials, INT64_C(2), INT64_C(14))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(15))) = c121;
    (*cspan_at(&partials, INT64_C(2), INT64_C(16))) = c122;
    (*cspan_at(&partials, INT64_C(2), INT64_C(17))) = c4 * c55;
    (*cspan_at(&partials, INT64_C(3), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(2))) = payload_mass * (c126 * ((-c125) - c72) + c127 * c48 + c129 - c61 * c82);
    (*cspan_at(&partials, INT64_C(3), INT64_C(3))) = c132 * payload_mass;
    (*cspan_at(&partials, INT64_C(3), INT64_C(4))) = payload_mass * (c104 * c18 - c133 * c14 * c73 + c135 + c44);
    (*cspan_at(&partials, INT64_C(3), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(7))) = c119 * (c106 * c18 + c136);
    (*cspan_at(&partials, INT64_C(3), INT64_C(8))) = c119 * (c108 * c18 + c28 - c50 * c78);
    (*cspan_at(&partials, INT64_C(3), INT64_C(9))) = c119 * (c109 * c18 - c138 + c34);
    (*cspan_at(&partials, INT64_C(3), INT64_C(10))) = c123;
    (*cspan_at(&partials, INT64_C(3), INT64_C(11))) = (-c139) * payload_mass + trolley_mass;
    (*cspan_at(&partials, INT64_C(3), INT64_C(12))) = (-c140) * c141;
    (*cspan_at(&partials, INT64_C(3), INT64_C(13))) = c82;
    (*cspan_at(&partials, INT64_C(3), INT64_C(14))) = -c110;
    (*cspan_at(&partials, INT64_C(3), INT64_C(15))) = c122;
    (*cspan_at(&partials, INT64_C(3), INT64_C(16))) = c139;
    (*cspan_at(&partials, INT64_C(3), INT64_C(17))) = c14 * c142 * c18;
    (*cspan_at(&partials, INT64_C(4), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(2))) = (-payload_mass) * (c100 * ((-c113) * c127 + c115 * c82 + c126 * c146 + c129) + c5 * (c112 + c114 * (c143 * l + c144 * l + c145 * l + c3) - c81 * (c112 * c94 + c143 + c144 + c145 - c54 - c60)) + c99 * ((-c0) * c113 * c55 + c1 * c115 * c18 * c5 - c1 * c14 * c146 - c128 * c14 - c21 * phi_y_rate + c56 * phi_x_rate));
    (*cspan_at(&partials, INT64_C(4), INT64_C(3))) = payload_mass * ((-c100) * c132 - c116 * c5 + c14 * c5 * (a_y - c148 - c15 - c48 * c82) + c18 * c5 * (c135 + c45) + c4 * (c11 - c131 - c8 * phi_x_rate) - c99 * (a_l * c18 * c5 + c1 * c102 * c14 * c5 * c95 - c130 * c14 - c131 * c18 - c34 * phi_x_rate - c55 * c67 + c56 * l_rate - c64));
    (*cspan_at(&partials, INT64_C(4), INT64_C(4))) = c4 * payload_mass * (c133 * c149 + c14 * (c151 + c45) - c14 * (c14 * c153 + c151 - c152 * c18 + c44) - c18 * ((-c147) + c150 + c36) - c18 * (c14 * c152 + c148 - c150 + c153 * c18));
    (*cspan_at(&partials, INT64_C(4), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(7))) = c120 * (c118 * c5 - c14 * (c136 + c154 * c18) - c18 * ((-c14) * c154 + c39 - c55 * c76));
    (*cspan_at(&partials, INT64_C(4), INT64_C(8))) = c119 * ((-c100) * (c155 * c50 - c156 * c18 + c28) + c5 * (c10 + c155 * c4 - c7) - c99 * (c14 * c156 + c155 * c55 + c42));
    (*cspan_at(&partials, INT64_C(4), INT64_C(9))) = (-c120) * (c137 + c14 * ((-c138) - c157 * c18 - c30 + c31 + c33) + c18 * ((-c137) * c18 + c14 * c157 + c43));
    (*cspan_at(&partials, INT64_C(4), INT64_C(10))) = c117 * c160;
    (*cspan_at(&partials, INT64_C(4), INT64_C(11))) = c141 * c162;
    (*cspan_at(&partials, INT64_C(4), INT64_C(12))) = payload_mass * (c124 * c133 + c140 * c158 + c140 * c159);
    (*cspan_at(&partials, INT64_C(4), INT64_C(13))) = (-c86) * c87;
    (*cspan_at(&partials, INT64_C(4), INT64_C(14))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(15))) = (-c160) * c5;
    (*cspan_at(&partials, INT64_C(4), INT64_C(16))) = (-c100) * c162;
    (*cspan_at(&partials, INT64_C(4), INT64_C(17))) = c99 * ((-c133) * c84 - c142 * c83 - c161 - c83 + INT64_C(1));
}
void segfmu_crane_load_partials(array_double_1d state, array_double_2d partials)
{
    double l;
    double phi_x;
    double phi_y;
    double l_rate;
    double phi_x_rate;
    double phi_y_rate;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    double c10;
    double c11;
    double c12;
    double c13;
    double c14;
    double c15;
    double c16;
    l = (*cspan_at(&state, INT64_C(2)));
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(4)));
    l_rate = (*cspan_at(&state, INT64_C(7)));
    phi_x_rate = (*cspan_at(&state, INT64_C(8)));
    phi_y_rate = (*cspan_at(&state, INT64_C(9)));
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
    (*cspan_at(&partials, INT64_C(0), INT64_C(0))) = INT64_C(1);
    (*cspan_at(&partials, INT64_C(0), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(2))) = c0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(3))) = c2;
    (*cspan_at(&partials, INT64_C(0), INT64_C(4))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(7))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(8))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(9))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(1))) = INT64_C(1);
    (*cspan_at(&partials, INT64_C(1), INT64_C(2))) = c5;
    (*cspan_at(&partials, INT64_C(1), INT64_C(3))) = c7;
    (*cspan_at(&partials, INT64_C(1), INT64_C(4))) = c10;
    (*cspan_at(&partials, INT64_C(1), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(7))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(8))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(9))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(2))) = c12;
    (*cspan_at(&partials, INT64_C(2), INT64_C(3))) = c13;
    (*cspan_at(&partials, INT64_C(2), INT64_C(4))) = c14;
    (*cspan_at(&partials, INT64_C(2), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(7))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(8))) = 0.0;
    (*cspan_at(&partials, INT64_C(2), INT64_C(9))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(2))) = c1 * phi_x_rate;
    (*cspan_at(&partials, INT64_C(3), INT64_C(3))) = c1 * l_rate - c6 * phi_x_rate;
    (*cspan_at(&partials, INT64_C(3), INT64_C(4))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(5))) = INT64_C(1);
    (*cspan_at(&partials, INT64_C(3), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(7))) = c0;
    (*cspan_at(&partials, INT64_C(3), INT64_C(8))) = c2;
    (*cspan_at(&partials, INT64_C(3), INT64_C(9))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(2))) = (-c11) * phi_y_rate + c15 * phi_x_rate;
    (*cspan_at(&partials, INT64_C(4), INT64_C(3))) = c13 * phi_y_rate + c14 * phi_x_rate + c15 * l_rate;
    (*cspan_at(&partials, INT64_C(4), INT64_C(4))) = (-c11) * l_rate + c13 * phi_x_rate + c14 * phi_y_rate;
    (*cspan_at(&partials, INT64_C(4), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(4), INT64_C(6))) = INT64_C(1);
    (*cspan_at(&partials, INT64_C(4), INT64_C(7))) = c5;
    (*cspan_at(&partials, INT64_C(4), INT64_C(8))) = c7;
    (*cspan_at(&partials, INT64_C(4), INT64_C(9))) = c10;
    (*cspan_at(&partials, INT64_C(5), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(5), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(5), INT64_C(2))) = c16 * phi_x_rate + c4 * phi_y_rate;
    (*cspan_at(&partials, INT64_C(5), INT64_C(3))) = c16 * l_rate - c7 * phi_y_rate + c9 * phi_x_rate;
    (*cspan_at(&partials, INT64_C(5), INT64_C(4))) = c4 * l_rate - c7 * phi_x_rate + c9 * phi_y_rate;
    (*cspan_at(&partials, INT64_C(5), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(5), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(5), INT64_C(7))) = c12;
    (*cspan_at(&partials, INT64_C(5), INT64_C(8))) = c13;
    (*cspan_at(&partials, INT64_C(5), INT64_C(9))) = c14;
}
void segfmu_crane_energy_partials(array_double_1d state, array_double_1d masses, array_double_2d partials)
{
    double l;
    double phi_x;
    double phi_y;
    double x_t_rate;
    double y_t_rate;
    double l_rate;
    double phi_x_rate;
    double phi_y_rate;
    double bridge_mass;
    double trolley_mass;
    double payload_mass;
    double gravity;
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double c6;
    double c7;
    double c8;
    double c9;
    double c10;
    double c11;
    double c12;
    double c13;
    double c14;
    double c15;
    double c16;
    double c17;
    double c18;
    double c19;
    double c20;
    double c21;
    double c22;
    double c23;
    l = (*cspan_at(&state, INT64_C(2)));
    phi_x = (*cspan_at(&state, INT64_C(3)));
    phi_y = (*cspan_at(&state, INT64_C(4)));
    x_t_rate = (*cspan_at(&state, INT64_C(5)));
    y_t_rate = (*cspan_at(&state, INT64_C(6)));
    l_rate = (*cspan_at(&state, INT64_C(7)));
    phi_x_rate = (*cspan_at(&state, INT64_C(8)));
    phi_y_rate = (*cspan_at(&state, INT64_C(9)));
    bridge_mass = (*cspan_at(&masses, INT64_C(0)));
    trolley_mass = (*cspan_at(&masses, INT64_C(1)));
    payload_mass = (*cspan_at(&masses, INT64_C(2)));
    gravity = (*cspan_at(&masses, INT64_C(3)));
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
    (*cspan_at(&partials, INT64_C(0), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(0), INT64_C(2))) = payload_mass * (c14 * (c12 + c9) + c17 * (c15 - c16) + c6 * phi_x_rate);
    (*cspan_at(&partials, INT64_C(0), INT64_C(3))) = payload_mass * (c14 * ((-c10) * c18 + c2 * c7 + c4 * c7) + c17 * (c10 * c2 + c10 * c4 + c18 * c7) - c5 * ((-c13) + c8 * l));
    (*cspan_at(&partials, INT64_C(0), INT64_C(4))) = c14 * payload_mass * y_t_rate;
    (*cspan_at(&partials, INT64_C(0), INT64_C(5))) = bridge_mass * x_t_rate + c5 * payload_mass + trolley_mass * x_t_rate;
    (*cspan_at(&partials, INT64_C(0), INT64_C(6))) = c17 * payload_mass + trolley_mass * y_t_rate;
    (*cspan_at(&partials, INT64_C(0), INT64_C(7))) = (-payload_mass) * (c0 * c19 + c0 * c20 - c1 * c5);
    (*cspan_at(&partials, INT64_C(0), INT64_C(8))) = c21 * (c1 * c19 + c1 * c20 + c6);
    (*cspan_at(&partials, INT64_C(0), INT64_C(9))) = c22 * (c10 * c14 - c17 * c7);
    (*cspan_at(&partials, INT64_C(1), INT64_C(0))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(1))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(2))) = (-c0) * c23 * payload_mass;
    (*cspan_at(&partials, INT64_C(1), INT64_C(3))) = c1 * c21 * c23;
    (*cspan_at(&partials, INT64_C(1), INT64_C(4))) = c10 * c22 * gravity;
    (*cspan_at(&partials, INT64_C(1), INT64_C(5))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(6))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(7))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(8))) = 0.0;
    (*cspan_at(&partials, INT64_C(1), INT64_C(9))) = 0.0;
}
static double series_factorial(int64_t order)
{
    int64_t i;
    double product;
    product = 1.0;
    for (i = INT64_C(2); i < order + INT64_C(1); i += INT64_C(1))
    {
        product = product * i;
    }
    return product;
}
static void series_of_derivatives(array_double_2d values, int64_t first, int64_t column, int64_t count, array_double_1d found)
{
    double scale;
    int64_t i;
    scale = 1.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if (i > INT64_C(1))
        {
            scale = scale * i;
        }
        (*cspan_at(&found, i)) = (*cspan_at(&values, first + i, column)) / scale;
    }
}
static double series_derivative(array_double_1d a, int64_t order)
{
    double result;
    result = series_factorial(order) * (*cspan_at(&a, order));
    return result;
}
static void series_sum(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found)
{
    int64_t i;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&found, i)) = (*cspan_at(&a, i)) + (*cspan_at(&b, i));
    }
}
static void series_difference(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found)
{
    int64_t i;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&found, i)) = (*cspan_at(&a, i)) - (*cspan_at(&b, i));
    }
}
static void series_negative(array_double_1d a, int64_t count, array_double_1d found)
{
    int64_t i;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&found, i)) = -(*cspan_at(&a, i));
    }
}
static void series_product(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found)
{
    int64_t k;
    double total;
    int64_t i;
    for (k = INT64_C(0); k < count; k += INT64_C(1))
    {
        total = 0.0;
        for (i = INT64_C(0); i < k + INT64_C(1); i += INT64_C(1))
        {
            total = total + (*cspan_at(&a, i)) * (*cspan_at(&b, k - i));
        }
        (*cspan_at(&found, k)) = total;
    }
}
static void series_quotient(array_double_1d a, array_double_1d b, int64_t count, array_double_1d found)
{
    int64_t k;
    double total;
    int64_t i;
    for (k = INT64_C(0); k < count; k += INT64_C(1))
    {
        total = (*cspan_at(&a, k));
        for (i = INT64_C(0); i < k; i += INT64_C(1))
        {
            total = total - (*cspan_at(&found, i)) * (*cspan_at(&b, k - i));
        }
        (*cspan_at(&found, k)) = total / (*cspan_at(&b, INT64_C(0)));
    }
}
static void series_root(array_double_1d a, int64_t count, array_double_1d found)
{
    int64_t k;
    double total;
    int64_t i;
    (*cspan_at(&found, INT64_C(0))) = sqrt((*cspan_at(&a, INT64_C(0))));
    for (k = INT64_C(1); k < count; k += INT64_C(1))
    {
        total = (*cspan_at(&a, k));
        for (i = INT64_C(1); i < k; i += INT64_C(1))
        {
            total = total - (*cspan_at(&found, i)) * (*cspan_at(&found, k - i));
        }
        (*cspan_at(&found, k)) = total / (2.0 * (*cspan_at(&found, INT64_C(0))));
    }
}
static void series_exponential(array_double_1d a, int64_t count, array_double_1d found)
{
    int64_t k;
    double total;
    int64_t i;
    (*cspan_at(&found, INT64_C(0))) = exp((*cspan_at(&a, INT64_C(0))));
    for (k = INT64_C(1); k < count; k += INT64_C(1))
    {
        total = 0.0;
        for (i = INT64_C(1); i < k + INT64_C(1); i += INT64_C(1))
        {
            total = total + i * (*cspan_at(&a, i)) * (*cspan_at(&found, k - i));
        }
        (*cspan_at(&found, k)) = total / k;
    }
}
static void series_angle(array_double_1d y, array_double_1d x, array_double_1d square, int64_t count, array_double_1d scratch, array_double_1d found)
{
    int64_t k;
    double total;
    int64_t i;
    (*cspan_at(&found, INT64_C(0))) = atan2((*cspan_at(&y, INT64_C(0))), (*cspan_at(&x, INT64_C(0))));
    for (k = INT64_C(0); k < count - INT64_C(1); k += INT64_C(1))
    {
        total = 0.0;
        for (i = INT64_C(0); i < k + INT64_C(1); i += INT64_C(1))
        {
            total = total + (k + INT64_C(1) - i) * ((*cspan_at(&x, i)) * (*cspan_at(&y, k + INT64_C(1) - i)) - (*cspan_at(&y, i)) * (*cspan_at(&x, k + INT64_C(1) - i)));
        }
        for (i = INT64_C(0); i < k; i += INT64_C(1))
        {
            total = total - (*cspan_at(&scratch, i)) * (*cspan_at(&square, k - i));
        }
        (*cspan_at(&scratch, k)) = total / (*cspan_at(&square, INT64_C(0)));
        (*cspan_at(&found, k + INT64_C(1))) = (*cspan_at(&scratch, k)) / (k + 1.0);
    }
}
void segfmu_flat_derivatives(array_double_2d flat, int64_t order, array_double_1d masses, array_double_2d work, array_double_1d found)
{
    double bridge_mass;
    double trolley_mass;
    double payload_mass;
    double gravity;
    array_double_1d x;
    array_double_1d y;
    array_double_1d z;
    array_double_1d w_x;
    array_double_1d w_y;
    array_double_1d w_z;
    array_double_1d s0;
    array_double_1d s1;
    array_double_1d s2;
    array_double_1d s3;
    array_double_1d s4;
    array_double_1d s5;
    array_double_1d s6;
    array_double_1d x_t;
    array_double_1d y_t;
    array_double_1d l;
    array_double_1d phi_x;
    array_double_1d phi_y;
    int64_t count;
    int64_t i;
    double scale;
    bridge_mass = (*cspan_at(&masses, INT64_C(0)));
    trolley_mass = (*cspan_at(&masses, INT64_C(1)));
    payload_mass = (*cspan_at(&masses, INT64_C(2)));
    gravity = (*cspan_at(&masses, INT64_C(3)));
    x = span_row(&work, INT64_C(0));
    y = span_row(&work, INT64_C(0) + INT64_C(1));
    z = span_row(&work, INT64_C(0) + INT64_C(2));
    w_x = span_row(&work, INT64_C(3));
    w_y = span_row(&work, INT64_C(3) + INT64_C(1));
    w_z = span_row(&work, INT64_C(3) + INT64_C(2));
    s0 = span_row(&work, INT64_C(6));
    s1 = span_row(&work, INT64_C(6) + INT64_C(1));
    s2 = span_row(&work, INT64_C(6) + INT64_C(2));
    s3 = span_row(&work, INT64_C(6) + INT64_C(3));
    s4 = span_row(&work, INT64_C(6) + INT64_C(4));
    s5 = span_row(&work, INT64_C(6) + INT64_C(5));
    s6 = span_row(&work, INT64_C(6) + INT64_C(6));
    x_t = span_row(&work, INT64_C(13));
    y_t = span_row(&work, INT64_C(13) + INT64_C(1));
    l = span_row(&work, INT64_C(13) + INT64_C(2));
    phi_x = span_row(&work, INT64_C(13) + INT64_C(3));
    phi_y = span_row(&work, INT64_C(13) + INT64_C(4));
    count = order + INT64_C(3);
    series_of_derivatives(flat, INT64_C(0), INT64_C(0), count, x);
    series_of_derivatives(flat, INT64_C(0), INT64_C(1), count, y);
    series_of_derivatives(flat, INT64_C(0), INT64_C(2), count, z);
    series_of_derivatives(flat, INT64_C(2), INT64_C(0), count, w_x);
    series_of_derivatives(flat, INT64_C(2), INT64_C(1), count, w_y);
    series_of_derivatives(flat, INT64_C(2), INT64_C(2), count, w_z);
    (*cspan_at(&w_z, INT64_C(0))) = (*cspan_at(&w_z, INT64_C(0))) + gravity;
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
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&found, INT64_C(3) + INT64_C(0) + i)) = series_derivative(span_row(&work, INT64_C(13) + i), order);
        (*cspan_at(&found, INT64_C(3) + INT64_C(5) + i)) = series_derivative(span_row(&work, INT64_C(13) + i), order + INT64_C(1));
        (*cspan_at(&found, INT64_C(13) + i)) = series_derivative(span_row(&work, INT64_C(13) + i), order + INT64_C(2));
    }
    scale = series_factorial(order);
    (*cspan_at(&found, INT64_C(0))) = payload_mass * (*cspan_at(&flat, order + INT64_C(2), INT64_C(0))) + (bridge_mass + trolley_mass) * (*cspan_at(&found, INT64_C(13)));
    (*cspan_at(&found, INT64_C(0) + INT64_C(1))) = payload_mass * (*cspan_at(&flat, order + INT64_C(2), INT64_C(1))) + trolley_mass * (*cspan_at(&found, INT64_C(13) + INT64_C(1)));
    (*cspan_at(&found, INT64_C(0) + INT64_C(2))) = (-payload_mass) * scale * (*cspan_at(&s3, order));
}
static double compression(array_double_1d plant, int64_t axis, double position)
{
    double result;
    if (position > (*cspan_at(&plant, INT64_C(50) + axis)))
    {
        result = position - (*cspan_at(&plant, INT64_C(50) + axis));
        return result;
    }
    result = span_min(position - (*cspan_at(&plant, INT64_C(47) + axis)), 0.0);
    return result;
}
static double buffer_force(array_double_1d plant, int64_t axis, double position, double velocity)
{
    double pressed;
    double force;
    if ((*cspan_at(&plant, INT64_C(53) + axis)) == 0.0)
    {
        return 0.0;
    }
    pressed = compression(plant, axis, position);
    if (pressed == 0.0)
    {
        return 0.0;
    }
    force = (*cspan_at(&plant, INT64_C(53) + axis)) * pressed + (*cspan_at(&plant, INT64_C(56) + axis)) * velocity;
    if (force * pressed <= 0.0)
    {
        return 0.0;
    }
    return force;
}
static int64_t buffer_slopes(double* result_0_0001, double* result_1_0001, array_double_1d plant, int64_t axis, double position, double velocity)
{
    if (buffer_force(plant, axis, position, velocity) == 0.0)
    {
        (*result_0_0001) = 0.0;
        (*result_1_0001) = 0.0;
        return 0;
    }
    (*result_0_0001) = (*cspan_at(&plant, INT64_C(53) + axis));
    (*result_1_0001) = (*cspan_at(&plant, INT64_C(56) + axis));
    return 0;
}
static double dry_level(array_double_1d resistance, int64_t axis, double velocity)
{
    double ratio;
    double coulomb;
    coulomb = (*cspan_at(&resistance, INT64_C(7) + axis));
    if ((*cspan_at(&resistance, INT64_C(10) + axis)) <= coulomb)
    {
        return coulomb;
    }
    ratio = velocity / (*cspan_at(&resistance, INT64_C(16)));
    coulomb = coulomb + ((*cspan_at(&resistance, INT64_C(10) + axis)) - coulomb) * exp((-ratio) * ratio);
    return coulomb;
}
static double level_slope(array_double_1d resistance, int64_t axis, double velocity)
{
    double coulomb;
    double width;
    double result;
    coulomb = (*cspan_at(&resistance, INT64_C(7) + axis));
    if ((*cspan_at(&resistance, INT64_C(10) + axis)) <= coulomb)
    {
        return 0.0;
    }
    width = (*cspan_at(&resistance, INT64_C(16)));
    result = (-2.0) * velocity / (width * width) * (dry_level(resistance, axis, velocity) - coulomb);
    return result;
}
static bool rubs(array_double_1d resistance, int64_t axis)
{
    bool result;
    result = ((*cspan_at(&resistance, INT64_C(7) + axis)) > 0.0) || ((*cspan_at(&resistance, INT64_C(10) + axis)) > 0.0);
    return result;
}
static double deflected(array_double_1d resistance, double deflection)
{
    double result;
    result = span_min(span_max(deflection / (*cspan_at(&resistance, INT64_C(17))), -1.0), 1.0);
    return result;
}
static double contact_damping(array_double_1d resistance, int64_t axis)
{
    double mass;
    double static_0001;
    double result;
    mass = carriage_mass(resistance, axis);
    if (axis == INT64_C(2))
    {
        mass = (*cspan_at(&resistance, INT64_C(2)));
    }
    static_0001 = span_max((*cspan_at(&resistance, INT64_C(10) + axis)), (*cspan_at(&resistance, INT64_C(7) + axis)));
    result = 2.0 * sqrt(1.5 * static_0001 * mass / (*cspan_at(&resistance, INT64_C(17))));
    return result;
}
static double dry_friction(array_double_1d resistance, int64_t axis, double level, double velocity, double deflection)
{
    double share;
    double friction;
    double damped;
    if (level <= 0.0)
    {
        return 0.0;
    }
    share = deflected(resistance, deflection);
    friction = level * 0.5 * share * (3.0 - share * share);
    damped = contact_damping(resistance, axis) * velocity / level;
    damped = damped / sqrt(1.0 + damped * damped);
    return friction + level * damped * (1.0 - share * share);
}
static double smooth_friction(array_double_1d resistance, int64_t axis, double velocity)
{
    double drag;
    double result;
    drag = (*cspan_at(&resistance, INT64_C(13) + axis));
    result = (*cspan_at(&resistance, INT64_C(4) + axis)) * velocity + drag * velocity * fabs(velocity);
    return result;
}
static double friction_force(array_double_1d resistance, int64_t axis, double velocity, double deflection)
{
    double level;
    double friction;
    friction = smooth_friction(resistance, axis, velocity);
    if (rubs(resistance, axis))
    {
        level = dry_level(resistance, axis, velocity);
        friction = friction + dry_friction(resistance, axis, level, velocity, deflection);
    }
    return friction;
}
static int64_t friction_slopes(double* result_0, double* result_1_0001, array_double_1d resistance, int64_t axis, double velocity, double deflection)
{
    double drag;
    double by_velocity;
    double level;
    double slope;
    double share;
    double rest;
    double damping;
    double damped;
    double root;
    double changed;
    double by_share;
    drag = (*cspan_at(&resistance, INT64_C(13) + axis));
    by_velocity = (*cspan_at(&resistance, INT64_C(4) + axis)) + 2.0 * drag * fabs(velocity);
    if (!rubs(resistance, axis))
    {
        (*result_0) = by_velocity;
        (*result_1_0001) = 0.0;
        return 0;
    }
    level = dry_level(resistance, axis, velocity);
    if (level <= 0.0)
    {
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
    if (fabs(share) >= 1.0)
    {
        (*result_0) = by_velocity;
        (*result_1_0001) = 0.0;
        return 0;
    }
    by_share = level * (1.5 * rest - 2.0 * share * damped / root);
    (*result_0) = by_velocity;
    (*result_1_0001) = by_share / (*cspan_at(&resistance, INT64_C(17)));
    return 0;
}
static double deflection_rate(array_double_1d resistance, int64_t axis, double velocity, double deflection)
{
    if (!rubs(resistance, axis))
    {
        return 0.0;
    }
    if ((fabs(deflection) >= (*cspan_at(&resistance, INT64_C(17)))) && (deflection * velocity >= 0.0))
    {
        return 0.0;
    }
    return velocity;
}
static double first_deflection(array_double_1d resistance, int64_t axis, double velocity)
{
    double share;
    double result;
    if (!rubs(resistance, axis))
    {
        return 0.0;
    }
    share = velocity / (*cspan_at(&resistance, INT64_C(16)));
    result = (*cspan_at(&resistance, INT64_C(17))) * span_min(span_max(share, -1.0), 1.0);
    return result;
}
static double next_break(double time, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends)
{
    int64_t axis;
    int64_t first;
    int64_t last;
    int64_t row;
    double following;
    following = 1e+300;
    for (axis = INT64_C(0); axis < ends.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        first = (*cspan_at(&offsets, axis));
        last = (*cspan_at(&offsets, axis + INT64_C(1)));
        if (time < (*cspan_at(&timing, first, INT64_C(0))))
        {
            following = span_min(following, (*cspan_at(&timing, first, INT64_C(0))));
        }
        else
        {
            row = find_piece(time, timing, first, last) + INT64_C(1);
            if (row < last)
            {
                following = span_min(following, (*cspan_at(&timing, row, INT64_C(0))));
            }
            else if (time < (*cspan_at(&ends, axis)))
            {
                following = span_min(following, (*cspan_at(&ends, axis)));
            }
        }
    }
    return following;
}
double segfmu_same_break(double time)
{
    return 1e-08 + 1e-14 * fabs(time);
}
double segfmu_next_plan_event(double time, double start, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends, array_double_2d times)
{
    double event;
    int64_t waypoint;
    double arrival;
    int64_t axis;
    double piece_end;
    event = 1e+300;
    for (waypoint = INT64_C(1); waypoint < times.shape[INT64_C(0)] + INT64_C(1); waypoint += INT64_C(1))
    {
        arrival = 0.0;
        for (axis = INT64_C(0); axis < ends.shape[INT64_C(0)]; axis += INT64_C(1))
        {
            if (waypoint < times.shape[INT64_C(0)])
            {
                arrival = span_max(arrival, (*cspan_at(&times, waypoint, axis)));
            }
            else
            {
                arrival = span_max(arrival, (*cspan_at(&ends, axis)));
            }
        }
        if (start + arrival > time + segfmu_same_break(time))
        {
            event = span_min(event, start + arrival);
        }
    }
    piece_end = next_break(time + segfmu_same_break(time) - start, timing, offsets, ends);
    if (piece_end < 1e+300)
    {
        piece_end = start + piece_end;
    }
    if ((event <= piece_end + segfmu_same_break(time)) || (piece_end <= time))
    {
        return event;
    }
    return piece_end;
}
double segfmu_right_of_break(double time, double start, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends)
{
    double local;
    double behind;
    local = time - start;
    behind = local + segfmu_same_break(time);
    if (next_break(local - segfmu_same_break(time), timing, offsets, ends) <= behind)
    {
        return behind;
    }
    return local;
}
bool segfmu_resists(array_double_1d resistance, int64_t axis)
{
    double smooth;
    bool result;
    smooth = (*cspan_at(&resistance, INT64_C(4) + axis)) + (*cspan_at(&resistance, INT64_C(13) + axis));
    result = (smooth > 0.0) || rubs(resistance, axis);
    return result;
}
static double release_time(array_double_1d resistance, int64_t axis)
{
    double mass;
    double static_0001;
    double result;
    mass = carriage_mass(resistance, axis);
    if (axis == INT64_C(2))
    {
        mass = (*cspan_at(&resistance, INT64_C(2)));
    }
    static_0001 = span_max((*cspan_at(&resistance, INT64_C(10) + axis)), (*cspan_at(&resistance, INT64_C(7) + axis)));
    result = 20.0 * sqrt((*cspan_at(&resistance, INT64_C(17))) * mass / (1.5 * static_0001));
    return result;
}
static int64_t axis_motion(double* result_0, double* result_1, double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work)
{
    array_double_2d load;
    int64_t axis;
    double position;
    double velocity;
    load = span_rows(&work, INT64_C(5), INT64_C(10));
    axis = (int64_t)((*cspan_at(&work, INT64_C(3), INT64_C(0))));
    segfmu_evaluate_orders(time, timing, coefficients, offsets, ends, load);
    segfmu_crane_flat_inverse(load, span_row(&work, INT64_C(4)), span_row(&work, INT64_C(0)), span_row(&work, INT64_C(1)), span_row(&work, INT64_C(2)));
    position = (*cspan_at(&work, INT64_C(1), INT64_C(0) + axis));
    velocity = (*cspan_at(&work, INT64_C(1), INT64_C(5) + axis));
    (*result_0) = position;
    (*result_1) = velocity;
    return 0;
}
static int64_t find_contact(double time, array_double_2d contacts)
{
    int64_t upper;
    int64_t middle;
    int64_t lower;
    lower = INT64_C(0);
    upper = contacts.shape[INT64_C(0)];
    while(upper - lower > INT64_C(1))
    {
        middle = span_floor_div((lower + upper), INT64_C(2));
        if (time >= (*cspan_at(&contacts, middle, INT64_C(0))))
        {
            lower = middle;
        }
        else
        {
            upper = middle;
        }
    }
    return lower;
}
static double planned_deflection(array_double_1d resistance, double time, double position, array_double_2d contacts, int64_t row)
{
    double deflection;
    double released;
    double share;
    double most;
    deflection = (*cspan_at(&contacts, row, INT64_C(2)));
    released = (*cspan_at(&contacts, row, INT64_C(3)));
    if (released > 0.0)
    {
        share = span_min((time - (*cspan_at(&contacts, row, INT64_C(0)))) / released, 1.0);
        return deflection * (1.0 - share * share * (3.0 - 2.0 * share));
    }
    deflection = deflection + position - (*cspan_at(&contacts, row, INT64_C(1)));
    most = (*cspan_at(&resistance, INT64_C(17)));
    return span_min(span_max(deflection, -most), most);
}
static double release_rate(double time, array_double_2d contacts, int64_t row)
{
    double released;
    double share;
    double result;
    released = (*cspan_at(&contacts, row, INT64_C(3)));
    share = span_min((time - (*cspan_at(&contacts, row, INT64_C(0)))) / released, 1.0);
    result = (-6.0) * (*cspan_at(&contacts, row, INT64_C(2))) * share * (1.0 - share) / released;
    return result;
}
static bool stops(double time, array_double_2d contacts, int64_t row)
{
    bool result;
    if ((*cspan_at(&contacts, row, INT64_C(3))) > 0.0)
    {
        return 1;
    }
    if (row + INT64_C(1) >= contacts.shape[INT64_C(0)])
    {
        return 0;
    }
    result = ((*cspan_at(&contacts, row + INT64_C(1), INT64_C(3))) > 0.0) && (time >= (*cspan_at(&contacts, row + INT64_C(1), INT64_C(4))));
    return result;
}
double segfmu_planned_friction(array_double_1d resistance, int64_t axis, double time, double position, double velocity, array_double_2d contacts)
{
    int64_t row;
    double deflection;
    double rate;
    double level;
    double friction;
    double result;
    if ((time < 0.0) || (!segfmu_resists(resistance, axis)))
    {
        return 0.0;
    }
    row = find_contact(time, contacts);
    deflection = planned_deflection(resistance, time, position, contacts, row);
    rate = velocity;
    if ((*cspan_at(&contacts, row, INT64_C(3))) > 0.0)
    {
        rate = release_rate(time, contacts, row);
    }
    level = dry_level(resistance, axis, rate);
    if (stops(time, contacts, row))
    {
        level = (*cspan_at(&resistance, INT64_C(7) + axis));
    }
    friction = smooth_friction(resistance, axis, rate);
    result = friction + dry_friction(resistance, axis, level, rate, deflection);
    return result;
}
static double stillness(array_double_2d work)
{
    double result;
    result = 1e-06 * (*cspan_at(&work, INT64_C(4), INT64_C(16)));
    return result;
}
static bool at_rest(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work)
{
    int64_t k;
    double time;
    double position;
    double velocity;
    for (k = INT64_C(1); k < INT64_C(12); k += INT64_C(1))
    {
        time = begin + k * (end - begin) / 12.0;
        axis_motion(&position, &velocity, time, timing, coefficients, offsets, ends, work);
        if (fabs(velocity) > stillness(work))
        {
            return 0;
        }
    }
    return 1;
}
static void add_contact(double time, bool rests, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts)
{
    array_double_1d history;
    array_double_1d resistance;
    int64_t count;
    int64_t before;
    double position;
    double velocity;
    history = span_row(&work, INT64_C(3));
    resistance = span_row(&work, INT64_C(4));
    count = (int64_t)((*cspan_at(&history, INT64_C(1))));
    if ((count == INT64_C(0)) || (count >= contacts.shape[INT64_C(0)]))
    {
        (*cspan_at(&history, INT64_C(1))) = 0.0;
        return;
    }
    before = count - INT64_C(1);
    if ((*cspan_at(&contacts, before, INT64_C(3))) > time - (*cspan_at(&contacts, before, INT64_C(0))))
    {
        (*cspan_at(&contacts, before, INT64_C(3))) = 0.0;
    }
    axis_motion(&position, &velocity, time, timing, coefficients, offsets, ends, work);
    (*cspan_at(&contacts, count, INT64_C(2))) = planned_deflection(resistance, time, position, contacts, before);
    (*cspan_at(&contacts, count, INT64_C(0))) = time;
    (*cspan_at(&contacts, count, INT64_C(1))) = position;
    if (rests)
    {
        (*cspan_at(&contacts, count, INT64_C(3))) = release_time(resistance, (int64_t)((*cspan_at(&history, INT64_C(0)))));
    }
    (*cspan_at(&history, INT64_C(1))) = count + 1.0;
}
static double turning_point(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work)
{
    double lower;
    double upper;
    int64_t Dummy_0000;
    double middle;
    double position;
    double velocity;
    lower = begin;
    upper = end;
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(50); Dummy_0000 += INT64_C(1))
    {
        middle = 0.5 * (lower + upper);
        axis_motion(&position, &velocity, middle, timing, coefficients, offsets, ends, work);
        if (velocity * (*cspan_at(&work, INT64_C(3), INT64_C(2))) > 0.0)
        {
            lower = middle;
        }
        else
        {
            upper = middle;
        }
    }
    return 0.5 * (lower + upper);
}
static void add_turns(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts)
{
    array_double_1d history;
    double before;
    int64_t k;
    double time;
    double position;
    double velocity;
    double turn;
    history = span_row(&work, INT64_C(3));
    before = begin;
    for (k = INT64_C(1); k < INT64_C(13); k += INT64_C(1))
    {
        time = begin + k * (end - begin) / 12.0;
        axis_motion(&position, &velocity, time, timing, coefficients, offsets, ends, work);
        if (fabs(velocity) > stillness(work))
        {
            if ((*cspan_at(&history, INT64_C(2))) * velocity < 0.0)
            {
                turn = turning_point(before, time, timing, coefficients, offsets, ends, work);
                add_contact(turn, 0, timing, coefficients, offsets, ends, work, contacts);
            }
            (*cspan_at(&history, INT64_C(2))) = velocity / fabs(velocity);
            before = time;
        }
    }
}
static void follow_contact(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts)
{
    array_double_1d history;
    bool rested;
    double time;
    double following;
    bool rests;
    history = span_row(&work, INT64_C(3));
    rested = 0;
    time = 0.0;
    following = next_break(time, timing, offsets, ends);
    while((following < 1e+300) && ((*cspan_at(&history, INT64_C(1))) > 0.0))
    {
        rests = at_rest(time, following, timing, coefficients, offsets, ends, work);
        if (rests != rested)
        {
            add_contact(time, rests, timing, coefficients, offsets, ends, work, contacts);
            (*cspan_at(&history, INT64_C(2))) = 0.0;
            rested = rests;
        }
        if (!rests)
        {
            add_turns(time, following, timing, coefficients, offsets, ends, work, contacts);
        }
        time = following;
        following = next_break(time, timing, offsets, ends);
    }
    if (!rested)
    {
        add_contact(time, 1, timing, coefficients, offsets, ends, work, contacts);
    }
}
static double sliding_time(int64_t row, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts)
{
    array_double_1d resistance;
    double lower;
    double most;
    int64_t Dummy_0000;
    double middle;
    double position;
    double velocity;
    double deflection;
    double upper;
    resistance = span_row(&work, INT64_C(4));
    lower = (*cspan_at(&contacts, row, INT64_C(0)));
    if ((*cspan_at(&contacts, row, INT64_C(3))) > 0.0)
    {
        upper = lower + (*cspan_at(&contacts, row, INT64_C(3)));
        return upper;
    }
    most = (*cspan_at(&resistance, INT64_C(17)));
    upper = end;
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(50); Dummy_0000 += INT64_C(1))
    {
        middle = 0.5 * (lower + upper);
        axis_motion(&position, &velocity, middle, timing, coefficients, offsets, ends, work);
        deflection = planned_deflection(resistance, middle, position, contacts, row);
        if ((deflection * velocity >= 0.0) && (fabs(deflection) >= most))
        {
            upper = middle;
        }
        else
        {
            lower = middle;
        }
    }
    return upper;
}
static double fading_time(double time, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work)
{
    double faded;
    double share;
    bool fast;
    int64_t Dummy_0000;
    double position;
    double velocity;
    faded = 3.0 * (*cspan_at(&work, INT64_C(4), INT64_C(16)));
    share = 0.5;
    fast = 1;
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(40); Dummy_0000 += INT64_C(1))
    {
        if (fast)
        {
            axis_motion(&position, &velocity, time + share * (end - time), timing, coefficients, offsets, ends, work);
            fast = fabs(velocity) > faded;
        }
        if (fast)
        {
            share = 0.5 * share;
        }
    }
    return time + span_min(2.0 * share, 0.5) * (end - time);
}
static void settle_contact(int64_t row, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_2d work, array_double_2d contacts)
{
    array_double_1d resistance;
    int64_t axis;
    double time;
    double end;
    double slides;
    double begun;
    double settled;
    resistance = span_row(&work, INT64_C(4));
    axis = (int64_t)((*cspan_at(&work, INT64_C(3), INT64_C(0))));
    time = (*cspan_at(&contacts, row, INT64_C(0)));
    end = time;
    if (row + INT64_C(1) < (int64_t)((*cspan_at(&work, INT64_C(3), INT64_C(1)))))
    {
        end = (*cspan_at(&contacts, row + INT64_C(1), INT64_C(0)));
    }
    slides = sliding_time(row, end, timing, coefficients, offsets, ends, work, contacts);
    begun = time;
    settled = slides;
    if ((*cspan_at(&resistance, INT64_C(10) + axis)) > (*cspan_at(&resistance, INT64_C(7) + axis)))
    {
        if ((*cspan_at(&contacts, row, INT64_C(3))) == 0.0)
        {
            settled = span_max(settled, fading_time(time, end, timing, coefficients, offsets, ends, work));
        }
        if (row > INT64_C(0))
        {
            begun = fading_time(time, (*cspan_at(&contacts, row - INT64_C(1), INT64_C(0))), timing, coefficients, offsets, ends, work);
        }
    }
    (*cspan_at(&contacts, row, INT64_C(4))) = begun;
    (*cspan_at(&contacts, row, INT64_C(5))) = slides;
    (*cspan_at(&contacts, row, INT64_C(6))) = settled;
}
int64_t segfmu_contact_history(int64_t axis, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_2d work, array_double_2d contacts)
{
    int64_t i;
    array_double_1d history;
    int64_t place;
    double position;
    double velocity;
    int64_t row;
    int64_t count;
    for (i = INT64_C(0); i < INT64_C(18); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(4), i)) = (*cspan_at(&resistance, i));
    }
    history = span_row(&work, INT64_C(3));
    (*cspan_at(&history, INT64_C(0))) = axis;
    (*cspan_at(&history, INT64_C(1))) = 1.0;
    (*cspan_at(&history, INT64_C(2))) = 0.0;
    for (i = INT64_C(0); i < contacts.shape[INT64_C(0)]; i += INT64_C(1))
    {
        for (place = INT64_C(0); place < INT64_C(7); place += INT64_C(1))
        {
            (*cspan_at(&contacts, i, place)) = 0.0;
        }
        (*cspan_at(&contacts, i, INT64_C(0))) = 1e+300;
    }
    axis_motion(&position, &velocity, 0.0, timing, coefficients, offsets, ends, work);
    (*cspan_at(&contacts, INT64_C(0), INT64_C(0))) = 0.0;
    (*cspan_at(&contacts, INT64_C(0), INT64_C(1))) = position;
    if (!rubs(resistance, axis))
    {
        return INT64_C(1);
    }
    (*cspan_at(&contacts, INT64_C(0), INT64_C(2))) = first_deflection(resistance, axis, velocity);
    follow_contact(timing, coefficients, offsets, ends, work, contacts);
    count = (int64_t)((*cspan_at(&history, INT64_C(1))));
    for (row = INT64_C(0); row < count; row += INT64_C(1))
    {
        settle_contact(row, timing, coefficients, offsets, ends, work, contacts);
    }
    return count;
}
static double contact_node(double time, double begin, double end)
{
    int64_t k;
    double node;
    if (end > begin)
    {
        for (k = INT64_C(0); k < INT64_C(17); k += INT64_C(1))
        {
            node = begin + k * (end - begin) / 16.0;
            if (node > time)
            {
                return node;
            }
        }
    }
    return 1e+300;
}
double segfmu_next_contact_event(double time, double start, array_double_2d contacts)
{
    double after;
    int64_t row;
    double event;
    after = time + segfmu_same_break(time) - start;
    row = find_contact(after, contacts);
    event = contact_node(after, (*cspan_at(&contacts, row, INT64_C(0))), (*cspan_at(&contacts, row, INT64_C(6))));
    if (after < (*cspan_at(&contacts, row, INT64_C(0))))
    {
        event = (*cspan_at(&contacts, row, INT64_C(0)));
    }
    if ((row + INT64_C(1) < contacts.shape[INT64_C(0)]) && ((*cspan_at(&contacts, row + INT64_C(1), INT64_C(0))) < 1e+300))
    {
        event = span_min(event, (*cspan_at(&contacts, row + INT64_C(1), INT64_C(0))));
        event = span_min(event, contact_node(after, (*cspan_at(&contacts, row + INT64_C(1), INT64_C(4))), (*cspan_at(&contacts, row + INT64_C(1), INT64_C(0)))));
    }
    if (event < 1e+300)
    {
        event = start + event;
        if (event <= time)
        {
            event = 1e+300;
        }
    }
    return event;
}
static void motion_demand(array_double_2d flat, double time, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_1d demand)
{
    int64_t k;
    double velocity;
    double force;
    segfmu_crane_flat_inverse(flat, resistance, span_row(&work, INT64_C(0)), span_row(&work, INT64_C(1)), span_row(&work, INT64_C(2)));
    for (k = INT64_C(0); k < INT64_C(3); k += INT64_C(1))
    {
        velocity = (*cspan_at(&work, INT64_C(1), INT64_C(5) + k));
        force = (*cspan_at(&work, INT64_C(0), k)) + segfmu_planned_friction(resistance, k, time, (*cspan_at(&work, INT64_C(1), INT64_C(0) + k)), velocity, span_matrix(&contacts, k));
        (*cspan_at(&demand, INT64_C(0) + k)) = force;
        (*cspan_at(&demand, INT64_C(3) + k)) = velocity;
        (*cspan_at(&demand, INT64_C(6) + k)) = (*cspan_at(&work, INT64_C(2), k));
        (*cspan_at(&demand, INT64_C(9) + k)) = force * velocity;
    }
    for (k = INT64_C(0); k < INT64_C(2); k += INT64_C(1))
    {
        (*cspan_at(&demand, INT64_C(12) + k)) = (*cspan_at(&work, INT64_C(1), INT64_C(3) + k));
    }
}
void segfmu_drive_demands(array_double_3d flat, array_double_1d times, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d demands)
{
    int64_t i;
    for (i = INT64_C(0); i < flat.shape[INT64_C(0)]; i += INT64_C(1))
    {
        motion_demand(span_matrix(&flat, i), (*cspan_at(&times, i)), resistance, contacts, work, span_row(&demands, i));
    }
}
static bool may_slacken(array_double_1d plant)
{
    bool result;
    result = (int64_t)((*cspan_at(&plant, INT64_C(76)))) == INT64_C(1);
    return result;
}
static bool is_slack(array_double_1d state)
{
    bool result;
    result = (*cspan_at(&state, INT64_C(16))) > 0.5;
    return result;
}
static double axis_position(array_double_1d state, int64_t axis)
{
    double result;
    if ((axis == INT64_C(2)) && is_slack(state))
    {
        result = (*cspan_at(&state, INT64_C(17)));
        return result;
    }
    result = (*cspan_at(&state, INT64_C(0) + axis));
    return result;
}
static double axis_velocity(array_double_1d state, int64_t axis)
{
    double result;
    if ((axis == INT64_C(2)) && is_slack(state))
    {
        result = (*cspan_at(&state, INT64_C(18)));
        return result;
    }
    result = (*cspan_at(&state, INT64_C(5) + axis));
    return result;
}
static bool bears_wrongly(array_double_1d plant, array_double_1d state, double rope_force)
{
    double over;
    bool result;
    if (is_slack(state))
    {
        over = (*cspan_at(&state, INT64_C(0) + INT64_C(2))) - (*cspan_at(&state, INT64_C(17)));
        result = over > 1e-10 * (*cspan_at(&state, INT64_C(17)));
        return result;
    }
    result = rope_force > 1e-09 * (*cspan_at(&plant, INT64_C(2))) * (*cspan_at(&plant, INT64_C(3)));
    return result;
}
static void change_rope(array_double_1d plant, array_double_1d state)
{
    int64_t rope;
    double mass;
    double against;
    double along;
    double across;
    double drives;
    double lost;
    rope = INT64_C(5) + INT64_C(2);
    if (!is_slack(state))
    {
        (*cspan_at(&state, INT64_C(16))) = 1.0;
        (*cspan_at(&state, INT64_C(17))) = (*cspan_at(&state, INT64_C(0) + INT64_C(2)));
        (*cspan_at(&state, INT64_C(18))) = (*cspan_at(&state, rope));
        return;
    }
    mass = (*cspan_at(&plant, INT64_C(2)));
    against = (*cspan_at(&state, rope)) - (*cspan_at(&state, INT64_C(18)));
    along = (*cspan_at(&state, INT64_C(18))) + sin((*cspan_at(&state, INT64_C(3)))) * (*cspan_at(&state, INT64_C(5)));
    across = cos((*cspan_at(&state, INT64_C(3)))) * sin((*cspan_at(&state, INT64_C(3) + INT64_C(1))));
    along = along - across * (*cspan_at(&state, INT64_C(5) + INT64_C(1)));
    drives = (*cspan_at(&state, INT64_C(13))) - mass * against * along;
    lost = 0.5 * mass * against * against;
    (*cspan_at(&state, INT64_C(13))) = drives;
    (*cspan_at(&state, INT64_C(15))) = (*cspan_at(&state, INT64_C(15))) + lost;
    (*cspan_at(&state, rope)) = (*cspan_at(&state, INT64_C(18)));
    (*cspan_at(&state, INT64_C(16))) = 0.0;
    (*cspan_at(&state, INT64_C(17))) = 0.0;
    (*cspan_at(&state, INT64_C(18))) = 0.0;
}
static void run_on(array_double_1d plant, array_double_2d work)
{
    array_double_1d force;
    int64_t rope;
    int64_t i;
    force = span_row(&work, INT64_C(13));
    rope = INT64_C(0) + INT64_C(2);
    if ((!may_slacken(plant)) || ((*cspan_at(&force, rope)) < 0.0))
    {
        return;
    }
    (*cspan_at(&work, INT64_C(14), INT64_C(0) + INT64_C(2))) = (*cspan_at(&work, INT64_C(19), INT64_C(2)));
    (*cspan_at(&force, rope)) = 0.0;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&force, INT64_C(3) + i)) = 0.0;
    }
}
static void forced_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative)
{
    array_double_1d force;
    array_double_1d action;
    bool fast;
    int64_t i;
    double drive;
    double bound;
    force = span_row(&work, INT64_C(13));
    action = span_row(&work, INT64_C(14));
    fast = 0;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        drive = (*cspan_at(&work, INT64_C(18), i));
        bound = force_bound(plant, i, drive, (*cspan_at(&state, INT64_C(5) + i)));
        if (exceeds(drive, bound))
        {
            drive = limited(drive, bound);
            (*cspan_at(&action, INT64_C(3) + i)) = 1.0;
        }
        fast = fast || at_velocity_bound(plant, i, state);
        (*cspan_at(&action, INT64_C(0) + i)) = drive;
        (*cspan_at(&force, i)) = drive - (*cspan_at(&work, INT64_C(19), i));
    }
    run_on(plant, work);
    segfmu_crane_rhs(state, force, span_row(&work, INT64_C(15)), plant, derivative);
    if (fast)
    {
        hold_velocities(plant, state, derivative, action, span_row(&work, INT64_C(20)));
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&force, i)) = (*cspan_at(&action, INT64_C(0) + i)) - (*cspan_at(&work, INT64_C(19), i));
        }
        run_on(plant, work);
        segfmu_crane_rhs(state, force, span_row(&work, INT64_C(15)), plant, derivative);
    }
    (*cspan_at(&action, INT64_C(6))) = (*cspan_at(&force, INT64_C(0) + INT64_C(2)));
}
static void slack_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative)
{
    array_double_1d force;
    array_double_1d action;
    int64_t i;
    double needed;
    double drive;
    double bound;
    force = span_row(&work, INT64_C(13));
    action = span_row(&work, INT64_C(14));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        needed = carriage_mass(plant, i) * (*cspan_at(&work, INT64_C(18), i));
        drive = needed + (*cspan_at(&work, INT64_C(19), i));
        bound = force_bound(plant, i, drive, axis_velocity(state, i));
        if (exceeds(drive, bound) && (i != INT64_C(2)))
        {
            drive = limited(drive, bound);
            (*cspan_at(&action, INT64_C(3) + i)) = 1.0;
        }
        (*cspan_at(&action, INT64_C(0) + i)) = drive;
        (*cspan_at(&force, i)) = drive - (*cspan_at(&work, INT64_C(19), i));
    }
    (*cspan_at(&force, INT64_C(0) + INT64_C(2))) = 0.0;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&force, INT64_C(3) + i)) = 0.0;
    }
    segfmu_crane_rhs(state, force, span_row(&work, INT64_C(15)), plant, derivative);
    (*cspan_at(&derivative, INT64_C(17))) = (*cspan_at(&state, INT64_C(18)));
    (*cspan_at(&derivative, INT64_C(18))) = (*cspan_at(&work, INT64_C(18), INT64_C(2)));
    (*cspan_at(&action, INT64_C(6))) = 0.0;
}
static void driven_forces(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative)
{
    array_double_1d action;
    int64_t i;
    action = span_row(&work, INT64_C(14));
    segfmu_crane_driven(state, span_row(&work, INT64_C(18)), span_row(&work, INT64_C(13)), span_row(&work, INT64_C(15)), plant, derivative, action);
    (*cspan_at(&action, INT64_C(6))) = (*cspan_at(&action, INT64_C(0) + INT64_C(2)));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&action, INT64_C(0) + i)) = (*cspan_at(&action, INT64_C(0) + i)) + (*cspan_at(&work, INT64_C(19), i));
    }
}
static void driven_derivative(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative)
{
    array_double_1d action;
    int64_t i;
    double demand;
    double bound;
    action = span_row(&work, INT64_C(14));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        demand = (*cspan_at(&work, INT64_C(18), i));
        if ((*cspan_at(&plant, INT64_C(19) + i)) > 0.0)
        {
            bound = velocity_bound(plant, i, demand);
            if (exceeds(demand, bound))
            {
                demand = limited(demand, bound);
                (*cspan_at(&action, INT64_C(3) + i)) = 1.0;
            }
            demand = (demand - axis_velocity(state, i)) / (*cspan_at(&plant, INT64_C(19) + i));
        }
        bound = acceleration_bound(plant, i, demand);
        if (exceeds(demand, bound))
        {
            demand = limited(demand, bound);
            (*cspan_at(&action, INT64_C(3) + i)) = 1.0;
        }
        (*cspan_at(&work, INT64_C(18), i)) = demand;
    }
    if (is_slack(state))
    {
        slack_derivative(plant, state, work, derivative);
        return;
    }
    driven_forces(plant, state, work, derivative);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        bound = force_bound(plant, i, (*cspan_at(&action, INT64_C(0) + i)), (*cspan_at(&state, INT64_C(5) + i)));
        if (exceeds((*cspan_at(&action, INT64_C(0) + i)), bound))
        {
            limit_accelerations(plant, state, action, span_row(&work, INT64_C(18)), span_row(&work, INT64_C(20)));
            driven_forces(plant, state, work, derivative);
            break;
        }
    }
}
int64_t segfmu_plant_failure(int64_t status, double time, array_double_1d state, array_double_1d plant, array_double_1d fault)
{
    int64_t axis;
    (*cspan_at(&fault, INT64_C(0))) = time;
    if (status < INT64_C(6))
    {
        return status;
    }
    axis = span_floor_mod((status - INT64_C(6)), INT64_C(3));
    (*cspan_at(&fault, INT64_C(1))) = axis;
    (*cspan_at(&fault, INT64_C(2))) = (*cspan_at(&state, INT64_C(0) + axis));
    if (status >= INT64_C(9))
    {
        (*cspan_at(&fault, INT64_C(3))) = (*cspan_at(&plant, INT64_C(50) + axis));
        return INT64_C(9);
    }
    (*cspan_at(&fault, INT64_C(3))) = (*cspan_at(&plant, INT64_C(47) + axis));
    return INT64_C(6);
}
static void share_series(array_double_1d resistance, double time, array_double_1d motion, int64_t order, array_double_2d contacts, array_double_2d work)
{
    array_double_1d share;
    array_double_1d velocity;
    double later;
    int64_t row;
    double most;
    int64_t i;
    double released;
    double first;
    double at;
    share = span_row(&work, INT64_C(1));
    velocity = span_row(&work, INT64_C(0));
    later = time + segfmu_same_break(time);
    row = find_contact(later, contacts);
    most = (*cspan_at(&resistance, INT64_C(17)));
    for (i = INT64_C(0); i < order + INT64_C(1); i += INT64_C(1))
    {
        (*cspan_at(&velocity, i)) = (*cspan_at(&motion, i + INT64_C(1))) / series_factorial(i);
    }
    released = (*cspan_at(&contacts, row, INT64_C(3)));
    if (released > 0.0)
    {
        first = (*cspan_at(&contacts, row, INT64_C(2)));
        for (i = INT64_C(0); i < order + INT64_C(1); i += INT64_C(1))
        {
            (*cspan_at(&velocity, i)) = 0.0;
        }
        if (later < (*cspan_at(&contacts, row, INT64_C(5))))
        {
            at = (later - (*cspan_at(&contacts, row, INT64_C(0)))) / released;
            (*cspan_at(&velocity, INT64_C(0))) = release_rate(later, contacts, row);
            if (order > INT64_C(0))
            {
                (*cspan_at(&velocity, INT64_C(1))) = (-6.0) * first * (1.0 - 2.0 * at) / (released * released);
            }
            if (order > INT64_C(1))
            {
                (*cspan_at(&velocity, INT64_C(2))) = 6.0 * first / (released * released * released);
            }
        }
    }
    (*cspan_at(&share, INT64_C(0))) = planned_deflection(resistance, later, (*cspan_at(&motion, INT64_C(0))), contacts, row) / most;
    for (i = INT64_C(0); i < order; i += INT64_C(1))
    {
        (*cspan_at(&share, i + INT64_C(1))) = (*cspan_at(&velocity, i)) / ((i + INT64_C(1)) * most);
        if ((released == 0.0) && (later >= (*cspan_at(&contacts, row, INT64_C(5)))))
        {
            (*cspan_at(&share, i + INT64_C(1))) = 0.0;
        }
    }
}
static void level_series(array_double_1d resistance, int64_t axis, int64_t count, array_double_2d work)
{
    array_double_1d velocity;
    array_double_1d level;
    array_double_1d first;
    double coulomb;
    double width;
    int64_t i;
    double rise;
    velocity = span_row(&work, INT64_C(0));
    level = span_row(&work, INT64_C(2));
    first = span_row(&work, INT64_C(5));
    coulomb = (*cspan_at(&resistance, INT64_C(7) + axis));
    width = (*cspan_at(&resistance, INT64_C(16)));
    series_product(velocity, velocity, count, first);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&first, i)) = (-(*cspan_at(&first, i))) / (width * width);
    }
    series_exponential(first, count, level);
    rise = span_max((*cspan_at(&resistance, INT64_C(10) + axis)) - coulomb, 0.0);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&level, i)) = rise * (*cspan_at(&level, i));
    }
    (*cspan_at(&level, INT64_C(0))) = (*cspan_at(&level, INT64_C(0))) + coulomb;
}
static void add_dry_series(array_double_1d resistance, int64_t axis, int64_t count, array_double_2d work)
{
    array_double_1d velocity;
    array_double_1d share;
    array_double_1d level;
    array_double_1d rest;
    array_double_1d damped;
    array_double_1d first;
    array_double_1d second;
    array_double_1d third;
    array_double_1d friction;
    double damping;
    int64_t i;
    velocity = span_row(&work, INT64_C(0));
    share = span_row(&work, INT64_C(1));
    level = span_row(&work, INT64_C(2));
    rest = span_row(&work, INT64_C(4));
    damped = span_row(&work, INT64_C(3));
    first = span_row(&work, INT64_C(5));
    second = span_row(&work, INT64_C(5) + INT64_C(1));
    third = span_row(&work, INT64_C(5) + INT64_C(2));
    friction = span_row(&work, INT64_C(8));
    damping = contact_damping(resistance, axis);
    series_product(velocity, velocity, count, first);
    series_product(level, level, count, second);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&first, i)) = (*cspan_at(&second, i)) + damping * damping * (*cspan_at(&first, i));
        (*cspan_at(&second, i)) = damping * (*cspan_at(&velocity, i));
    }
    series_root(first, count, third);
    series_quotient(second, third, count, damped);
    series_product(share, share, count, first);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&rest, i)) = -(*cspan_at(&first, i));
        (*cspan_at(&second, i)) = (-0.5) * (*cspan_at(&first, i));
    }
    (*cspan_at(&rest, INT64_C(0))) = (*cspan_at(&rest, INT64_C(0))) + 1.0;
    (*cspan_at(&second, INT64_C(0))) = (*cspan_at(&second, INT64_C(0))) + 1.5;
    series_product(share, second, count, first);
    series_product(damped, rest, count, second);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&third, i)) = (*cspan_at(&first, i)) + (*cspan_at(&second, i));
    }
    series_product(level, third, count, first);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&friction, i)) = (*cspan_at(&friction, i)) + (*cspan_at(&first, i));
    }
}
double segfmu_friction_derivative(array_double_1d resistance, int64_t axis, double time, array_double_1d motion, int64_t order, array_double_2d contacts, array_double_2d work)
{
    int64_t count;
    array_double_1d friction;
    array_double_1d velocity;
    double side;
    int64_t i;
    array_double_1d square;
    double later;
    double result;
    if ((time < 0.0) || (!segfmu_resists(resistance, axis)))
    {
        return 0.0;
    }
    count = order + INT64_C(1);
    friction = span_row(&work, INT64_C(8));
    velocity = span_row(&work, INT64_C(0));
    share_series(resistance, time, motion, order, contacts, work);
    side = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if ((side == 0.0) && ((*cspan_at(&velocity, i)) != 0.0))
        {
            side = (*cspan_at(&velocity, i)) / fabs((*cspan_at(&velocity, i)));
        }
    }
    square = span_row(&work, INT64_C(5));
    series_product(velocity, velocity, count, square);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&friction, i)) = (*cspan_at(&resistance, INT64_C(4) + axis)) * (*cspan_at(&velocity, i));
        (*cspan_at(&friction, i)) = (*cspan_at(&friction, i)) + side * (*cspan_at(&resistance, INT64_C(13) + axis)) * (*cspan_at(&square, i));
    }
    if (rubs(resistance, axis))
    {
        later = time + segfmu_same_break(time);
        level_series(resistance, axis, count, work);
        if (stops(later, contacts, find_contact(later, contacts)))
        {
            for (i = INT64_C(0); i < count; i += INT64_C(1))
            {
                (*cspan_at(&work, INT64_C(2), i)) = 0.0;
            }
            (*cspan_at(&work, INT64_C(2), INT64_C(0))) = (*cspan_at(&resistance, INT64_C(7) + axis));
        }
        if ((*cspan_at(&work, INT64_C(2), INT64_C(0))) > 0.0)
        {
            add_dry_series(resistance, axis, count, work);
        }
    }
    result = series_derivative(friction, order);
    return result;
}
void segfmu_begin_pace(array_double_1d pace)
{
    (*cspan_at(&pace, INT64_C(0))) = 1.0;
    (*cspan_at(&pace, INT64_C(1))) = 0.0;
    (*cspan_at(&pace, INT64_C(2))) = 1.0;
    (*cspan_at(&pace, INT64_C(3))) = 0.0;
    (*cspan_at(&pace, INT64_C(4))) = 0.0;
    (*cspan_at(&pace, INT64_C(5))) = 0.0;
}
static double pace_between(array_double_1d pace)
{
    double lower;
    double upper;
    double aim;
    double slower;
    double share;
    double rise;
    lower = (*cspan_at(&pace, INT64_C(1)));
    upper = (*cspan_at(&pace, INT64_C(2)));
    aim = 1.0 - 5e-07;
    if (lower <= 0.0)
    {
        slower = span_min(sqrt(aim / (*cspan_at(&pace, INT64_C(4)))), 0.999);
        if ((*cspan_at(&pace, INT64_C(5))) > 2.5)
        {
            slower = 0.5;
        }
        return span_max(slower * upper, 0.001);
    }
    share = 0.5;
    rise = (*cspan_at(&pace, INT64_C(4))) / (*cspan_at(&pace, INT64_C(3)));
    if (span_floor_mod((int64_t)((*cspan_at(&pace, INT64_C(5)))), INT64_C(3)) > INT64_C(0))
    {
        share = log(aim / (*cspan_at(&pace, INT64_C(3)))) / log(rise);
    }
    share = span_min(span_max(share, 0.001), 0.999);
    return lower * exp(share * log(upper / lower));
}
bool segfmu_next_pace(double use, array_double_1d pace)
{
    double last;
    bool result;
    last = (*cspan_at(&pace, INT64_C(0)));
    if (use <= 1.0 + 1e-09)
    {
        (*cspan_at(&pace, INT64_C(1))) = last;
        (*cspan_at(&pace, INT64_C(3))) = use;
        if ((last >= 1.0) || (use >= 1.0 - 1e-06) || ((*cspan_at(&pace, INT64_C(5))) >= 40.0))
        {
            return 0;
        }
    }
    else
    {
        (*cspan_at(&pace, INT64_C(2))) = last;
        (*cspan_at(&pace, INT64_C(4))) = use;
        if (last <= 0.001)
        {
            return 0;
        }
    }
    (*cspan_at(&pace, INT64_C(5))) = (*cspan_at(&pace, INT64_C(5))) + 1.0;
    (*cspan_at(&pace, INT64_C(0))) = pace_between(pace);
    if ((*cspan_at(&pace, INT64_C(5))) >= 40.0)
    {
        (*cspan_at(&pace, INT64_C(0))) = (*cspan_at(&pace, INT64_C(1)));
    }
    result = (*cspan_at(&pace, INT64_C(0))) > 0.0;
    return result;
}
static void write_transform(array_double_2d work)
{
    int64_t last;
    int64_t k;
    int64_t j;
    double weight;
    double angle;
    last = INT64_C(17) - INT64_C(1);
    for (k = INT64_C(0); k < INT64_C(17); k += INT64_C(1))
    {
        for (j = INT64_C(0); j < INT64_C(17); j += INT64_C(1))
        {
            weight = 2.0 / last;
            if ((j == INT64_C(0)) || (j == last))
            {
                weight = 0.5 * weight;
            }
            if ((k == INT64_C(0)) || (k == last))
            {
                weight = 0.5 * weight;
            }
            angle = 3.141592653589793 * k * (last - j) / last;
            (*cspan_at(&work, INT64_C(57) + k, j)) = weight * cos(angle);
        }
    }
}
static void demand_at(double time, int64_t row, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work)
{
    array_double_2d load;
    load = span_rows(&work, INT64_C(3), INT64_C(8));
    segfmu_evaluate_orders(time, timing, coefficients, offsets, ends, load);
    motion_demand(load, time, resistance, contacts, work, span_row(&work, row));
}
static void note_value(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times)
{
    int64_t i;
    int64_t side;
    double value;
    demand_at(time, INT64_C(56), timing, coefficients, offsets, ends, resistance, contacts, work);
    for (i = INT64_C(0); i < INT64_C(14); i += INT64_C(1))
    {
        for (side = INT64_C(0); side < INT64_C(2); side += INT64_C(1))
        {
            value = (1.0 - 2.0 * side) * (*cspan_at(&work, INT64_C(56), i));
            if (value > (*cspan_at(&peaks, side, i)))
            {
                (*cspan_at(&peaks, side, i)) = value;
                (*cspan_at(&times, side, i)) = time;
            }
        }
    }
}
static double sooner(double time, double after, double following)
{
    if (time > after)
    {
        return span_min(time, following);
    }
    return following;
}
static double next_joint(double time, double duration, array_double_2d timing, array_int64_t_1d offsets, array_double_1d ends, array_double_3d contacts)
{
    double after;
    int64_t axis;
    int64_t row;
    double following;
    after = time + 1e-12 * duration;
    following = next_break(after, timing, offsets, ends);
    for (axis = INT64_C(0); axis < contacts.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        for (row = INT64_C(0); row < contacts.shape[INT64_C(1)]; row += INT64_C(1))
        {
            if ((*cspan_at(&contacts, axis, row, INT64_C(0))) < 1e+300)
            {
                following = sooner((*cspan_at(&contacts, axis, row, INT64_C(0))), after, following);
                following = sooner((*cspan_at(&contacts, axis, row, INT64_C(4))), after, following);
                following = sooner((*cspan_at(&contacts, axis, row, INT64_C(5))), after, following);
                following = sooner((*cspan_at(&contacts, axis, row, INT64_C(6))), after, following);
            }
        }
    }
    if (following > duration)
    {
        return 1e+300;
    }
    return following;
}
static void sample_demands(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work)
{
    int64_t last;
    int64_t j;
    double time;
    last = INT64_C(17) - INT64_C(1);
    for (j = INT64_C(0); j < INT64_C(17); j += INT64_C(1))
    {
        time = begin + 0.5 * (end - begin) * (1.0 + cos(3.141592653589793 * (last - j) / last));
        demand_at(time, INT64_C(8) + j, timing, coefficients, offsets, ends, resistance, contacts, work);
    }
}
static void enlarge_scale(array_double_2d work)
{
    int64_t j;
    int64_t i;
    for (j = INT64_C(0); j < INT64_C(17); j += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(14); i += INT64_C(1))
        {
            (*cspan_at(&work, INT64_C(55), i)) = span_max((*cspan_at(&work, INT64_C(55), i)), fabs((*cspan_at(&work, INT64_C(8) + j, i))));
        }
    }
}
static void share_scale(array_double_2d work)
{
    array_double_1d scale;
    int64_t group;
    int64_t last;
    double most;
    int64_t i;
    scale = span_row(&work, INT64_C(55));
    for (group = INT64_C(0); group < INT64_C(14); group += INT64_C(3))
    {
        last = span_min_int(group + INT64_C(3), INT64_C(14));
        most = 0.0;
        for (i = group; i < last; i += INT64_C(1))
        {
            most = span_max(most, (*cspan_at(&scale, i)));
        }
        for (i = group; i < last; i += INT64_C(1))
        {
            (*cspan_at(&scale, i)) = span_max((*cspan_at(&scale, i)), 0.001 * most);
        }
    }
    for (i = INT64_C(12); i < INT64_C(14); i += INT64_C(1))
    {
        (*cspan_at(&scale, i)) = span_max((*cspan_at(&scale, i)), 1e-06);
    }
}
static bool is_resolved(int64_t depth, array_double_2d work)
{
    bool resolved;
    int64_t i;
    int64_t k;
    double total;
    int64_t j;
    int64_t last;
    double tail;
    double scale;
    bool rounding;
    double before;
    resolved = 1;
    for (i = INT64_C(0); i < INT64_C(14); i += INT64_C(1))
    {
        for (k = INT64_C(0); k < INT64_C(17); k += INT64_C(1))
        {
            total = 0.0;
            for (j = INT64_C(0); j < INT64_C(17); j += INT64_C(1))
            {
                total = total + (*cspan_at(&work, INT64_C(57) + k, j)) * (*cspan_at(&work, INT64_C(8) + j, i));
            }
            (*cspan_at(&work, INT64_C(25) + k, i)) = total;
        }
        last = INT64_C(25) + INT64_C(17) - INT64_C(1);
        tail = span_max(fabs((*cspan_at(&work, last, i))), fabs((*cspan_at(&work, last - INT64_C(1), i))));
        scale = (*cspan_at(&work, INT64_C(55), i));
        rounding = 0;
        if (depth > INT64_C(0))
        {
            before = (*cspan_at(&work, INT64_C(42) + depth - INT64_C(1), i));
            rounding = (tail <= 1e-05 * scale) && (tail > 0.1 * before);
        }
        if ((tail > 1e-11 * scale) && (!rounding))
        {
            resolved = 0;
        }
        (*cspan_at(&work, INT64_C(42) + depth, i)) = tail;
    }
    return resolved || (depth == INT64_C(12));
}
static double series_value(int64_t i, double place, array_double_2d work)
{
    double second;
    double first;
    int64_t j;
    double coefficient;
    double value;
    double result;
    second = 0.0;
    first = 0.0;
    for (j = INT64_C(0); j < INT64_C(17) - INT64_C(1); j += INT64_C(1))
    {
        coefficient = (*cspan_at(&work, INT64_C(25) + INT64_C(17) - INT64_C(1) - j, i));
        value = coefficient + 2.0 * place * first - second;
        second = first;
        first = value;
    }
    result = (*cspan_at(&work, INT64_C(25), i)) + place * first - second;
    return result;
}
static double peak_place(int64_t i, double sign, array_double_2d work)
{
    double reach;
    double best;
    double most;
    int64_t k;
    double value;
    double lower;
    double upper;
    double golden;
    int64_t Dummy_0000;
    double left;
    double right;
    double inner;
    reach = 2.0 / (INT64_C(65) - INT64_C(1));
    best = -1.0;
    most = sign * series_value(i, best, work);
    for (k = INT64_C(1); k < INT64_C(65); k += INT64_C(1))
    {
        value = sign * series_value(i, (-1.0) + k * reach, work);
        if (value > most)
        {
            most = value;
            best = (-1.0) + k * reach;
        }
    }
    lower = span_max(best - reach, -1.0);
    upper = span_min(best + reach, 1.0);
    golden = 0.5 * (sqrt(5.0) - 1.0);
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(40); Dummy_0000 += INT64_C(1))
    {
        left = upper - golden * (upper - lower);
        right = lower + golden * (upper - lower);
        if (sign * series_value(i, left, work) < sign * series_value(i, right, work))
        {
            lower = left;
        }
        else
        {
            upper = right;
        }
    }
    inner = 0.5 * (lower + upper);
    if (sign * series_value(i, inner, work) > most)
    {
        return inner;
    }
    return best;
}
static void note_peaks(double start, double length, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times)
{
    int64_t i;
    double room;
    int64_t k;
    double rounding;
    int64_t side;
    double sign;
    double known;
    double place;
    for (i = INT64_C(0); i < INT64_C(14); i += INT64_C(1))
    {
        room = 0.0;
        for (k = INT64_C(1); k < INT64_C(17); k += INT64_C(1))
        {
            room = room + fabs((*cspan_at(&work, INT64_C(25) + k, i)));
        }
        rounding = 1e-13 * (fabs((*cspan_at(&work, INT64_C(25), i))) + room);
        for (side = INT64_C(0); side < INT64_C(2); side += INT64_C(1))
        {
            sign = 1.0 - 2.0 * side;
            known = (*cspan_at(&peaks, side, i)) - rounding;
            if (sign * (*cspan_at(&work, INT64_C(25), i)) + room > known)
            {
                place = peak_place(i, sign, work);
                if (sign * series_value(i, place, work) > known)
                {
                    note_value(start + 0.5 * (place + 1.0) * length, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
                }
            }
        }
    }
}
static void search_interval(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times)
{
    int64_t depth;
    int64_t place;
    double length;
    double start;
    depth = INT64_C(0);
    place = INT64_C(0);
    while((depth > INT64_C(0)) || (place == INT64_C(0)))
    {
        length = (end - begin) * pow(0.5, (double)(depth));
        start = begin + place * length;
        sample_demands(start, start + length, timing, coefficients, offsets, ends, resistance, contacts, work);
        if (is_resolved(depth, work))
        {
            note_peaks(start, length, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
            place = place + INT64_C(1);
            while((depth > INT64_C(0)) && (span_floor_mod(place, INT64_C(2)) == INT64_C(0)))
            {
                place = span_floor_div(place, INT64_C(2));
                depth = depth - INT64_C(1);
            }
        }
        else
        {
            place = INT64_C(2) * place;
            depth = depth + INT64_C(1);
        }
    }
}
void segfmu_demand_peaks(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d ends, array_double_1d resistance, array_double_3d contacts, array_double_2d work, array_double_2d peaks, array_double_2d times)
{
    double duration;
    int64_t axis;
    int64_t i;
    int64_t side;
    double begin;
    double end;
    duration = 0.0;
    for (axis = INT64_C(0); axis < ends.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        duration = span_max(duration, (*cspan_at(&ends, axis)));
    }
    for (i = INT64_C(0); i < INT64_C(14); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(55), i)) = 0.0;
        for (side = INT64_C(0); side < INT64_C(2); side += INT64_C(1))
        {
            (*cspan_at(&peaks, side, i)) = 0.0;
            (*cspan_at(&times, side, i)) = 0.0;
        }
    }
    write_transform(work);
    note_value(0.0, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
    for (axis = INT64_C(0); axis < ends.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        note_value((*cspan_at(&ends, axis)), timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
    }
    begin = 0.0;
    end = next_joint(begin, duration, timing, offsets, ends, contacts);
    while(end < 1e+300)
    {
        sample_demands(begin, end, timing, coefficients, offsets, ends, resistance, contacts, work);
        enlarge_scale(work);
        begin = end;
        end = next_joint(begin, duration, timing, offsets, ends, contacts);
    }
    share_scale(work);
    begin = 0.0;
    end = next_joint(begin, duration, timing, offsets, ends, contacts);
    while(end < 1e+300)
    {
        search_interval(begin, end, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times);
        begin = end;
        end = next_joint(begin, duration, timing, offsets, ends, contacts);
    }
}
static double full_circle(void)
{
    return 6.283185307179586;
}
double segfmu_next_uniform(array_double_1d numbers)
{
    double first;
    double second;
    double difference;
    first = 40014.0 * (*cspan_at(&numbers, INT64_C(0)));
    second = 40692.0 * (*cspan_at(&numbers, INT64_C(1)));
    (*cspan_at(&numbers, INT64_C(0))) = first - (int64_t)floor(first / 2147483563.0) * 2147483563.0;
    (*cspan_at(&numbers, INT64_C(1))) = second - (int64_t)floor(second / 2147483399.0) * 2147483399.0;
    difference = (*cspan_at(&numbers, INT64_C(0))) - (*cspan_at(&numbers, INT64_C(1)));
    if (difference < 1.0)
    {
        difference = difference + 2147483562.0;
    }
    return difference / 2147483563.0;
}
void segfmu_seed_numbers(int64_t seed, array_double_1d numbers)
{
    int64_t other;
    int64_t Dummy_0000;
    other = seed * INT64_C(69069) + INT64_C(12345);
    (*cspan_at(&numbers, INT64_C(0))) = 1.0 + seed - span_floor_div(seed, INT64_C(2147483562)) * INT64_C(2147483562);
    (*cspan_at(&numbers, INT64_C(1))) = 1.0 + other - span_floor_div(other, INT64_C(2147483398)) * INT64_C(2147483398);
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(20); Dummy_0000 += INT64_C(1))
    {
        segfmu_next_uniform(numbers);
    }
}
static double next_normal(array_double_1d numbers)
{
    double radius;
    double result;
    radius = sqrt((-2.0) * log(segfmu_next_uniform(numbers)));
    result = radius * cos(full_circle() * segfmu_next_uniform(numbers));
    return result;
}
void segfmu_noise_components(double bandwidth, array_double_1d deviation, array_double_1d numbers, array_double_2d components)
{
    int64_t count;
    int64_t i;
    double frequency;
    int64_t axis;
    double amplitude;
    double phase;
    count = components.shape[INT64_C(0)];
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        frequency = full_circle() * bandwidth * (i + segfmu_next_uniform(numbers)) / count;
        (*cspan_at(&components, i, INT64_C(0))) = frequency;
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            amplitude = (*cspan_at(&deviation, axis)) * sqrt(2.0 / count);
            phase = full_circle() * segfmu_next_uniform(numbers);
            (*cspan_at(&components, i, INT64_C(1) + axis)) = amplitude * cos(phase);
            (*cspan_at(&components, i, INT64_C(4) + axis)) = amplitude * sin(phase);
        }
    }
}
void segfmu_turbulence_components(double speed, double length, double bandwidth, array_double_1d deviation, array_double_1d numbers, array_double_2d components)
{
    int64_t count;
    double most;
    double held;
    int64_t i;
    double rest;
    double frequency;
    int64_t axis;
    double amplitude;
    double phase;
    count = components.shape[INT64_C(0)];
    most = bandwidth * length / speed;
    held = 1.0 - pow((1.0 + most * most), ((-1.0) / 3.0));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        rest = 1.0 - held * (i + segfmu_next_uniform(numbers)) / count;
        frequency = sqrt(1.0 / (rest * rest * rest) - 1.0) * speed / length;
        (*cspan_at(&components, i, INT64_C(0))) = full_circle() * frequency;
        (*cspan_at(&components, i, INT64_C(7))) = 1.0;
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            amplitude = (*cspan_at(&deviation, axis)) * sqrt(2.0 / count);
            phase = full_circle() * segfmu_next_uniform(numbers);
            (*cspan_at(&components, i, INT64_C(1) + axis)) = amplitude * cos(phase);
            (*cspan_at(&components, i, INT64_C(4) + axis)) = amplitude * sin(phase);
        }
    }
}
static double gust_factor(double shape, double share)
{
    if ((share <= 0.0) || (share >= 1.0))
    {
        return 0.0;
    }
    if ((int64_t)(shape) == INT64_C(1))
    {
        return sin(0.5 * full_circle() * share);
    }
    return 0.5 * (1.0 - cos(full_circle() * share));
}
static double gust_rate(double shape, double share)
{
    double angle;
    angle = full_circle() * share;
    if ((int64_t)(shape) == INT64_C(1))
    {
        return 0.5 * full_circle() * cos(0.5 * angle);
    }
    return 0.5 * full_circle() * cos(angle - 0.25 * full_circle());
}
static double command_slope(int64_t i, double elapsed, array_double_1d rate)
{
    double slope;
    double result;
    slope = (*cspan_at(&rate, INT64_C(3) + i)) + elapsed * (*cspan_at(&rate, INT64_C(6) + i));
    result = (*cspan_at(&rate, INT64_C(0) + i)) + elapsed * slope;
    return result;
}
static void add_sinusoid(array_double_1d component, double sine, double cosine, array_double_1d total)
{
    int64_t i;
    double added;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        added = (*cspan_at(&total, i)) + (*cspan_at(&component, INT64_C(1) + i)) * sine;
        (*cspan_at(&total, i)) = added + (*cspan_at(&component, INT64_C(4) + i)) * cosine;
    }
}
static double drag_factor(array_double_1d plant)
{
    double result;
    result = 0.5 * (*cspan_at(&plant, INT64_C(75))) * (*cspan_at(&plant, INT64_C(74)));
    return result;
}
static double relative_speed(array_double_1d air)
{
    double squares;
    int64_t i;
    squares = 0.0;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        squares = squares + (*cspan_at(&air, INT64_C(0) + i)) * (*cspan_at(&air, INT64_C(0) + i));
    }
    return sqrt(squares);
}
static void add_drag(array_double_1d plant, array_double_1d state, array_double_2d work)
{
    array_double_1d air;
    int64_t i;
    double own;
    double factor;
    air = span_row(&work, INT64_C(21));
    segfmu_crane_load(state, span_rows(&work, INT64_C(16), INT64_C(16) + INT64_C(2)));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        own = (*cspan_at(&work, INT64_C(16) + INT64_C(1), i));
        (*cspan_at(&air, INT64_C(0) + i)) = (*cspan_at(&air, INT64_C(0) + i)) - own;
    }
    factor = drag_factor(plant) * relative_speed(air);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(15), i)) = (*cspan_at(&work, INT64_C(15), i)) + factor * (*cspan_at(&air, INT64_C(0) + i));
    }
}
static void wind_force(array_double_1d plant, array_double_2d components, double start, double elapsed, array_double_1d state, array_double_2d work)
{
    double time;
    double gust;
    double share;
    array_double_1d force;
    array_double_1d air;
    array_double_1d rate;
    int64_t i;
    double given;
    double steady;
    int64_t k;
    double sine;
    double cosine;
    time = start + elapsed;
    gust = 0.0;
    if ((*cspan_at(&plant, INT64_C(63))) > 0.0)
    {
        share = (time - (*cspan_at(&plant, INT64_C(62)))) / (*cspan_at(&plant, INT64_C(63)));
        gust = gust_factor((*cspan_at(&plant, INT64_C(64))), share);
    }
    force = span_row(&work, INT64_C(15));
    air = span_row(&work, INT64_C(21));
    rate = span_row(&work, INT64_C(3));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        given = (*cspan_at(&work, INT64_C(2), i)) + elapsed * command_slope(i, elapsed, rate);
        steady = given + (*cspan_at(&plant, INT64_C(59) + i));
        (*cspan_at(&force, i)) = steady + gust * (*cspan_at(&plant, INT64_C(65) + i));
        (*cspan_at(&air, INT64_C(0) + i)) = (*cspan_at(&plant, INT64_C(68) + i)) + gust * (*cspan_at(&plant, INT64_C(71) + i));
    }
    for (k = INT64_C(0); k < components.shape[INT64_C(0)]; k += INT64_C(1))
    {
        sine = sin((*cspan_at(&components, k, INT64_C(0))) * time);
        cosine = cos((*cspan_at(&components, k, INT64_C(0))) * time);
        if ((*cspan_at(&components, k, INT64_C(7))) > 0.5)
        {
            add_sinusoid(span_row(&components, k), sine, cosine, air);
        }
        else
        {
            add_sinusoid(span_row(&components, k), sine, cosine, force);
        }
    }
    if ((*cspan_at(&plant, INT64_C(74))) > 0.0)
    {
        add_drag(plant, state, work);
    }
}
static double drag_slope(array_double_1d plant, array_double_1d air, int64_t i, int64_t j)
{
    double speed;
    double slope;
    double result;
    speed = relative_speed(air);
    if (((*cspan_at(&plant, INT64_C(74))) == 0.0) || (speed == 0.0))
    {
        return 0.0;
    }
    slope = (*cspan_at(&air, INT64_C(0) + i)) * (*cspan_at(&air, INT64_C(0) + j)) / speed;
    if (i == j)
    {
        slope = slope + speed;
    }
    result = drag_factor(plant) * slope;
    return result;
}
static void add_rate(array_double_1d component, double time, int64_t first, array_double_1d total)
{
    double frequency;
    double angle;
    int64_t i;
    double sines;
    frequency = (*cspan_at(&component, INT64_C(0)));
    angle = frequency * time;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        sines = (*cspan_at(&component, INT64_C(1) + i)) * cos(angle);
        sines = sines - (*cspan_at(&component, INT64_C(4) + i)) * sin(angle);
        (*cspan_at(&total, first + i)) = (*cspan_at(&total, first + i)) + frequency * sines;
    }
}
static void wind_rates(array_double_1d plant, array_double_2d components, double time, array_double_1d air)
{
    double gust;
    double duration;
    double share;
    int64_t i;
    int64_t k;
    double rate;
    int64_t j;
    gust = 0.0;
    duration = (*cspan_at(&plant, INT64_C(63)));
    if (duration > 0.0)
    {
        share = (time - (*cspan_at(&plant, INT64_C(62)))) / duration;
        if ((share > 0.0) && (share < 1.0))
        {
            gust = gust_rate((*cspan_at(&plant, INT64_C(64))), share) / duration;
        }
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&air, INT64_C(3) + i)) = gust * (*cspan_at(&plant, INT64_C(71) + i));
        (*cspan_at(&air, INT64_C(6) + i)) = gust * (*cspan_at(&plant, INT64_C(65) + i));
    }
    for (k = INT64_C(0); k < components.shape[INT64_C(0)]; k += INT64_C(1))
    {
        if ((*cspan_at(&components, k, INT64_C(7))) > 0.5)
        {
            add_rate(span_row(&components, k), time, INT64_C(3), air);
        }
        else
        {
            add_rate(span_row(&components, k), time, INT64_C(6), air);
        }
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        rate = (*cspan_at(&air, INT64_C(6) + i));
        for (j = INT64_C(0); j < INT64_C(3); j += INT64_C(1))
        {
            rate = rate + drag_slope(plant, air, i, j) * (*cspan_at(&air, INT64_C(3) + j));
        }
        (*cspan_at(&air, INT64_C(6) + i)) = rate;
    }
}
static double stage_node(int64_t stage)
{
    if (stage == INT64_C(0))
    {
        return 0.0;
    }
    if (stage == INT64_C(1))
    {
        return 1.0 / 5.0;
    }
    if (stage == INT64_C(2))
    {
        return 3.0 / 10.0;
    }
    if (stage == INT64_C(3))
    {
        return 4.0 / 5.0;
    }
    if (stage == INT64_C(4))
    {
        return 8.0 / 9.0;
    }
    return 1.0;
}
static void stage_state(int64_t stage, double h, int64_t count, array_double_1d state, array_double_2d k, array_double_1d trial)
{
    double a0;
    int64_t i;
    double a1;
    double a2;
    double a3;
    double part;
    double a4;
    double a5;
    if (stage == INT64_C(1))
    {
        a0 = h * (1.0 / 5.0);
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            (*cspan_at(&trial, i)) = (*cspan_at(&state, i)) + a0 * (*cspan_at(&k, INT64_C(0), i));
        }
    }
    else if (stage == INT64_C(2))
    {
        a0 = h * (3.0 / 40.0);
        a1 = h * (9.0 / 40.0);
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            (*cspan_at(&trial, i)) = (*cspan_at(&state, i)) + a0 * (*cspan_at(&k, INT64_C(0), i)) + a1 * (*cspan_at(&k, INT64_C(1), i));
        }
    }
    else if (stage == INT64_C(3))
    {
        a0 = h * (44.0 / 45.0);
        a1 = h * ((-56.0) / 15.0);
        a2 = h * (32.0 / 9.0);
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            (*cspan_at(&trial, i)) = (*cspan_at(&state, i)) + a0 * (*cspan_at(&k, INT64_C(0), i)) + a1 * (*cspan_at(&k, INT64_C(1), i)) + a2 * (*cspan_at(&k, INT64_C(2), i));
        }
    }
    else if (stage == INT64_C(4))
    {
        a0 = h * (19372.0 / 6561.0);
        a1 = h * ((-25360.0) / 2187.0);
        a2 = h * (64448.0 / 6561.0);
        a3 = h * ((-212.0) / 729.0);
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            part = (*cspan_at(&state, i)) + a0 * (*cspan_at(&k, INT64_C(0), i)) + a1 * (*cspan_at(&k, INT64_C(1), i)) + a2 * (*cspan_at(&k, INT64_C(2), i));
            (*cspan_at(&trial, i)) = part + a3 * (*cspan_at(&k, INT64_C(3), i));
        }
    }
    else if (stage == INT64_C(5))
    {
        a0 = h * (9017.0 / 3168.0);
        a1 = h * ((-355.0) / 33.0);
        a2 = h * (46732.0 / 5247.0);
        a3 = h * (49.0 / 176.0);
        a4 = h * ((-5103.0) / 18656.0);
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            part = (*cspan_at(&state, i)) + a0 * (*cspan_at(&k, INT64_C(0), i)) + a1 * (*cspan_at(&k, INT64_C(1), i)) + a2 * (*cspan_at(&k, INT64_C(2), i));
            (*cspan_at(&trial, i)) = part + a3 * (*cspan_at(&k, INT64_C(3), i)) + a4 * (*cspan_at(&k, INT64_C(4), i));
        }
    }
    else
    {
        a0 = h * (35.0 / 384.0);
        a2 = h * (500.0 / 1113.0);
        a3 = h * (125.0 / 192.0);
        a4 = h * ((-2187.0) / 6784.0);
        a5 = h * (11.0 / 84.0);
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            part = (*cspan_at(&state, i)) + a0 * (*cspan_at(&k, INT64_C(0), i)) + a2 * (*cspan_at(&k, INT64_C(2), i)) + a3 * (*cspan_at(&k, INT64_C(3), i));
            (*cspan_at(&trial, i)) = part + a4 * (*cspan_at(&k, INT64_C(4), i)) + a5 * (*cspan_at(&k, INT64_C(5), i));
        }
    }
}
static double step_error(double h, int64_t count, array_double_1d start, array_double_1d end, array_double_2d k)
{
    double e0;
    double e2;
    double e3;
    double e4;
    double e5;
    double e6;
    int64_t i;
    double part;
    double difference;
    double size;
    double error;
    e0 = h * (71.0 / 57600.0);
    e2 = h * ((-71.0) / 16695.0);
    e3 = h * (71.0 / 1920.0);
    e4 = h * ((-17253.0) / 339200.0);
    e5 = h * (22.0 / 525.0);
    e6 = h * ((-1.0) / 40.0);
    error = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        part = e0 * (*cspan_at(&k, INT64_C(0), i)) + e2 * (*cspan_at(&k, INT64_C(2), i)) + e3 * (*cspan_at(&k, INT64_C(3), i));
        difference = part + e4 * (*cspan_at(&k, INT64_C(4), i)) + e5 * (*cspan_at(&k, INT64_C(5), i)) + e6 * (*cspan_at(&k, INT64_C(6), i));
        size = 1.0 + span_max(fabs((*cspan_at(&start, i))), fabs((*cspan_at(&end, i))));
        error = span_max(error, fabs(difference) / size);
    }
    if (!(error < 1e+100))
    {
        return 1e+100;
    }
    return error;
}
static double next_step(double error, double tolerance)
{
    if (5300.0 * error > tolerance)
    {
        return span_min(5.0, span_max(0.2, 0.9 * pow((tolerance / error), 0.2)));
    }
    return 5.0;
}
static bool all_finite(array_double_1d values, int64_t count)
{
    int64_t i;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if (!(fabs((*cspan_at(&values, i))) < 1e+100))
        {
            return 0;
        }
    }
    return 1;
}
static void plant_powers(array_double_1d plant, array_double_1d state, array_double_2d work, array_double_1d derivative)
{
    array_double_1d wind;
    bool calm;
    double squares;
    int64_t i;
    double velocity;
    double drive;
    double power;
    double lost;
    wind = span_row(&work, INT64_C(15));
    calm = ((*cspan_at(&wind, INT64_C(0))) == 0.0) && ((*cspan_at(&wind, INT64_C(1))) == 0.0) && ((*cspan_at(&wind, INT64_C(2))) == 0.0);
    if (!calm)
    {
        segfmu_crane_load(state, span_rows(&work, INT64_C(16), INT64_C(16) + INT64_C(2)));
    }
    squares = (*cspan_at(&state, INT64_C(8))) * (*cspan_at(&state, INT64_C(8)));
    squares = squares + (*cspan_at(&state, INT64_C(8) + INT64_C(1))) * (*cspan_at(&state, INT64_C(8) + INT64_C(1)));
    (*cspan_at(&derivative, INT64_C(13))) = 0.0;
    (*cspan_at(&derivative, INT64_C(14))) = 0.0;
    (*cspan_at(&derivative, INT64_C(15))) = (*cspan_at(&plant, INT64_C(46))) * squares;
    if (may_slacken(plant) && ((*cspan_at(&work, INT64_C(14), INT64_C(6))) >= 0.0))
    {
        (*cspan_at(&derivative, INT64_C(15))) = 0.0;
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        velocity = axis_velocity(state, i);
        drive = (*cspan_at(&work, INT64_C(14), INT64_C(0) + i)) * velocity;
        (*cspan_at(&derivative, INT64_C(13))) = (*cspan_at(&derivative, INT64_C(13))) + drive;
        if (!calm)
        {
            power = (*cspan_at(&wind, i)) * (*cspan_at(&work, INT64_C(16) + INT64_C(1), i));
            (*cspan_at(&derivative, INT64_C(14))) = (*cspan_at(&derivative, INT64_C(14))) + power;
        }
        lost = (*cspan_at(&work, INT64_C(19), i)) * velocity;
        (*cspan_at(&derivative, INT64_C(15))) = (*cspan_at(&derivative, INT64_C(15))) + lost;
    }
}
static void plant_derivative(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, array_double_2d work, array_double_1d derivative)
{
    array_double_1d rate;
    int64_t i;
    double slope;
    double velocity;
    double deflection;
    double resistance;
    double torque;
    rate = span_row(&work, INT64_C(1));
    wind_force(plant, components, time, elapsed, state, work);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        slope = command_slope(i, elapsed, rate);
        (*cspan_at(&work, INT64_C(18), i)) = (*cspan_at(&work, INT64_C(0), i)) + elapsed * slope;
        velocity = axis_velocity(state, i);
        deflection = (*cspan_at(&state, INT64_C(10) + i));
        resistance = buffer_force(plant, i, axis_position(state, i), velocity);
        resistance = resistance + friction_force(plant, i, velocity, deflection);
        (*cspan_at(&work, INT64_C(19), i)) = resistance;
        (*cspan_at(&derivative, INT64_C(10) + i)) = deflection_rate(plant, i, velocity, deflection);
        (*cspan_at(&work, INT64_C(14), INT64_C(3) + i)) = 0.0;
    }
    (*cspan_at(&derivative, INT64_C(16))) = 0.0;
    (*cspan_at(&derivative, INT64_C(17))) = 0.0;
    (*cspan_at(&derivative, INT64_C(18))) = 0.0;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        torque = (-(*cspan_at(&plant, INT64_C(46)))) * (*cspan_at(&state, INT64_C(8) + i));
        (*cspan_at(&work, INT64_C(13), INT64_C(3) + i)) = torque;
    }
    if ((int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(1))
    {
        driven_derivative(plant, state, work, derivative);
    }
    else
    {
        forced_derivative(plant, state, work, derivative);
    }
    plant_powers(plant, state, work, derivative);
}
static void reuse_last_stage(array_double_2d work)
{
    array_double_1d action;
    int64_t i;
    action = span_row(&work, INT64_C(14));
    for (i = INT64_C(0); i < INT64_C(19); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(4), i)) = (*cspan_at(&work, INT64_C(4) + INT64_C(6), i));
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&action, INT64_C(7) + i)) = (*cspan_at(&action, INT64_C(3) + i));
    }
}
static void first_stage(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, array_double_2d work)
{
    plant_derivative(plant, components, time, elapsed, state, work, span_row(&work, INT64_C(4) + INT64_C(6)));
    reuse_last_stage(work);
}
static double try_step(array_double_1d plant, array_double_2d components, double time, double elapsed, array_double_1d state, double h, array_double_2d work)
{
    array_double_2d stages;
    array_double_1d trial;
    int64_t stage;
    int64_t count;
    double result;
    stages = span_rows(&work, INT64_C(4), INT64_C(4) + INT64_C(7));
    trial = span_row(&work, INT64_C(11));
    for (stage = INT64_C(1); stage < INT64_C(7); stage += INT64_C(1))
    {
        count = INT64_C(13);
        if ((stage == INT64_C(6)) || may_slacken(plant))
        {
            count = INT64_C(19);
        }
        stage_state(stage, h, count, state, stages, trial);
        if (!all_finite(trial, count))
        {
            return 1e+100;
        }
        plant_derivative(plant, components, time, elapsed + stage_node(stage) * h, trial, work, span_row(&work, INT64_C(4) + stage));
    }
    result = step_error(h, INT64_C(19), state, trial, stages);
    return result;
}
static int64_t plant_status(array_double_1d plant, array_double_1d state, double rope_force)
{
    int64_t i;
    double position;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        if (fabs((*cspan_at(&state, INT64_C(3) + i))) >= 1.57)
        {
            return INT64_C(1);
        }
    }
    if ((*cspan_at(&state, INT64_C(0) + INT64_C(2))) <= 0.0)
    {
        return INT64_C(2);
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        if ((*cspan_at(&plant, INT64_C(53) + i)) > 0.0)
        {
            continue;
        }
        position = axis_position(state, i);
        if (position < (*cspan_at(&plant, INT64_C(47) + i)) - 1e-09)
        {
            return INT64_C(6) + i;
        }
        if (position > (*cspan_at(&plant, INT64_C(50) + i)) + 1e-09)
        {
            return INT64_C(9) + i;
        }
    }
    if (bears_wrongly(plant, state, rope_force))
    {
        return INT64_C(5);
    }
    return INT64_C(0);
}
static void accept_step(array_double_1d state, array_double_2d work, double elapsed, array_double_1d report)
{
    array_double_1d action;
    int64_t i;
    double saturated;
    action = span_row(&work, INT64_C(14));
    for (i = INT64_C(0); i < INT64_C(19); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = (*cspan_at(&work, INT64_C(11), i));
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        saturated = span_max((*cspan_at(&action, INT64_C(3) + i)), (*cspan_at(&action, INT64_C(7) + i)));
        (*cspan_at(&report, INT64_C(0) + i)) = (*cspan_at(&action, INT64_C(0) + i));
        (*cspan_at(&report, INT64_C(3) + i)) = span_max((*cspan_at(&report, INT64_C(3) + i)), saturated);
    }
    (*cspan_at(&report, INT64_C(6))) = (*cspan_at(&action, INT64_C(6)));
    (*cspan_at(&report, INT64_C(7))) = (*cspan_at(&work, INT64_C(4) + INT64_C(6), INT64_C(14)));
    (*cspan_at(&report, INT64_C(8))) = (*cspan_at(&work, INT64_C(4) + INT64_C(6), INT64_C(15)));
    (*cspan_at(&report, INT64_C(9))) = elapsed;
}
int64_t segfmu_plant_advance(array_double_1d plant, array_double_2d components, double time, array_double_1d state, double duration, double tolerance, array_double_2d work, array_double_1d report)
{
    int64_t i;
    bool finite;
    double t;
    double planned;
    double h;
    int64_t Dummy_0000;
    bool last;
    double error;
    double rope_force;
    int64_t status;
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        (*cspan_at(&report, i)) = 0.0;
    }
    finite = all_finite(state, INT64_C(19)) && all_finite(span_row(&work, INT64_C(0)), INT64_C(3));
    if ((!finite) || (!all_finite(span_row(&work, INT64_C(2)), INT64_C(3))))
    {
        return INT64_C(4);
    }
    first_stage(plant, components, time, 0.0, state, work);
    t = 0.0;
    planned = (*cspan_at(&work, INT64_C(12), INT64_C(0)));
    if (planned <= 0.0)
    {
        planned = duration;
    }
    h = planned;
    for (Dummy_0000 = INT64_C(0); Dummy_0000 < INT64_C(200000); Dummy_0000 += INT64_C(1))
    {
        last = h >= duration - t;
        if (last)
        {
            planned = h;
            h = duration - t;
        }
        error = try_step(plant, components, time, t, state, h, work);
        if (error > tolerance)
        {
            h = h * next_step(error, tolerance);
            if (h < 1e-12 * duration)
            {
                return INT64_C(3);
            }
            continue;
        }
        rope_force = (*cspan_at(&work, INT64_C(14), INT64_C(6)));
        status = plant_status(plant, span_row(&work, INT64_C(11)), rope_force);
        if (status != INT64_C(0))
        {
            if (h >= 1e-07)
            {
                h = 0.5 * h;
                continue;
            }
            if ((status != INT64_C(5)) || (!may_slacken(plant)))
            {
                return status;
            }
            change_rope(plant, state);
            first_stage(plant, components, time, t, state, work);
            h = duration - t;
            continue;
        }
        t = t + h;
        h = h * next_step(error, tolerance);
        accept_step(state, work, t, report);
        if (last)
        {
            (*cspan_at(&work, INT64_C(12), INT64_C(0))) = span_max(h, planned);
            return INT64_C(0);
        }
        reuse_last_stage(work);
    }
    return INT64_C(3);
}
static bool has_own_bound(int64_t i, int64_t side, array_double_1d bounds)
{
    bool result;
    result = (side == INT64_C(1)) && (i < INT64_C(9)) && ((*cspan_at(&bounds, INT64_C(14) + i)) < 0.0);
    return result;
}
static double bound_magnitude(int64_t i, int64_t side, array_double_1d bounds)
{
    double result;
    if (has_own_bound(i, side, bounds))
    {
        result = -(*cspan_at(&bounds, INT64_C(14) + i));
        return result;
    }
    result = (*cspan_at(&bounds, i));
    return result;
}
static void write_fault(int64_t i, int64_t side, double peak, double time, array_double_1d bounds, array_double_1d fault)
{
    (*cspan_at(&fault, INT64_C(0))) = span_floor_mod(i, INT64_C(3));
    (*cspan_at(&fault, INT64_C(1))) = span_floor_mod(i, INT64_C(3));
    (*cspan_at(&fault, INT64_C(2))) = 0.0;
    (*cspan_at(&fault, INT64_C(3))) = peak;
    (*cspan_at(&fault, INT64_C(4))) = (*cspan_at(&bounds, i));
    if (has_own_bound(i, side, bounds))
    {
        (*cspan_at(&fault, INT64_C(2))) = 1.0;
        (*cspan_at(&fault, INT64_C(3))) = -peak;
        (*cspan_at(&fault, INT64_C(4))) = (*cspan_at(&bounds, INT64_C(14) + i));
    }
    (*cspan_at(&fault, INT64_C(5))) = time;
}
int64_t segfmu_bound_uses(array_double_2d peaks, array_double_2d times, array_double_1d bounds, array_double_1d uses, array_double_1d fault)
{
    double worst;
    int64_t i;
    int64_t side;
    double bound;
    double share;
    int64_t status;
    status = INT64_C(0);
    worst = 1.0 + 1e-09;
    for (i = INT64_C(0); i < INT64_C(14); i += INT64_C(1))
    {
        (*cspan_at(&uses, INT64_C(0) + i)) = 0.0;
        (*cspan_at(&uses, INT64_C(14) + i)) = 0.0;
        for (side = INT64_C(0); side < INT64_C(2); side += INT64_C(1))
        {
            bound = bound_magnitude(i, side, bounds);
            if (bound > 0.0)
            {
                share = (*cspan_at(&peaks, side, i)) / bound;
                if (share > (*cspan_at(&uses, INT64_C(0) + i)))
                {
                    (*cspan_at(&uses, INT64_C(0) + i)) = share;
                    (*cspan_at(&uses, INT64_C(14) + i)) = (*cspan_at(&times, side, i));
                }
                if (share > worst)
                {
                    worst = share;
                    status = INT64_C(1) + span_floor_div(i, INT64_C(3));
                    write_fault(i, side, (*cspan_at(&peaks, side, i)), (*cspan_at(&times, side, i)), bounds, fault);
                }
            }
        }
    }
    return status;
}
int64_t segfmu_check_range(double value, double least, double most, array_double_1d fault)
{
    (*cspan_at(&fault, INT64_C(0))) = value;
    (*cspan_at(&fault, INT64_C(1))) = least;
    (*cspan_at(&fault, INT64_C(2))) = most;
    if ((value >= least) && (value <= most))
    {
        return INT64_C(0);
    }
    if (most > 1.7976931348623157e+308)
    {
        return INT64_C(1);
    }
    if (least < -1.7976931348623157e+308)
    {
        return INT64_C(3);
    }
    return INT64_C(2);
}
static double root_share(double newest, double other, double before, double e_newest, double e_other, double e_before)
{
    double place;
    double height;
    double share;
    double rest;
    double least;
    if (e_newest * e_other * e_before == 0.0)
    {
        return 0.5;
    }
    if ((before == other) && (e_newest * e_other < 0.0))
    {
        return span_min(span_max(e_newest / (e_newest - e_other), 0.1), 0.9);
    }
    if ((e_before == e_newest) || (e_before == e_other) || (before == other))
    {
        return 0.5;
    }
    place = (newest - other) / (before - other);
    height = (e_newest - e_other) / (e_before - e_other);
    if ((height * height >= place) || ((1.0 - height) * (1.0 - height) >= 1.0 - place))
    {
        return 0.5;
    }
    share = e_newest / (e_other - e_newest) * e_before / (e_other - e_before);
    rest = (before - newest) / (other - newest);
    share = share + rest * e_newest / (e_before - e_newest) * e_other / (e_before - e_other);
    least = 2e-16 * span_max(fabs(newest), fabs(other)) / fabs(other - newest);
    return span_max(span_min(share, 1.0 - least), least);
}
static int64_t next_bracket(double* result_0_0001, double* result_1_0001, double* result_2_0001, double* result_3_0001, bool crossed, double newest, double other, double e_newest, double e_other)
{
    if (crossed)
    {
        (*result_0_0001) = newest;
        (*result_1_0001) = other;
        (*result_2_0001) = e_newest;
        (*result_3_0001) = e_other;
        return 0;
    }
    (*result_0_0001) = other;
    (*result_1_0001) = newest;
    (*result_2_0001) = e_other;
    (*result_3_0001) = e_newest;
    return 0;
}
double segfmu_begin_time(double given, double start)
{
    if (given <= -INT64_C(1000000000))
    {
        return start;
    }
    return given;
}
static double least_scale(void)
{
    return 0.001;
}
static double push_of(double velocity)
{
    if (velocity > 0.0)
    {
        return 1.0;
    }
    if (velocity < 0.0)
    {
        return -1.0;
    }
    return 0.0;
}
static double standstill(int64_t slot, int64_t axis, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    int64_t last;
    double result;
    last = (*cspan_at(&offsets, slot * INT64_C(4) + axis + INT64_C(1))) - INT64_C(1);
    result = evaluate_piece(span_matrix(&coefficients, slot), last, coefficients.shape[INT64_C(2)], (*cspan_at(&timing, slot, last, INT64_C(1))), INT64_C(0));
    return result;
}
static double end_rounding_of(double end)
{
    return 1e-10 * fabs(end);
}
static double low_end(int64_t axis, array_double_2d known)
{
    double end;
    double longest;
    end = (*cspan_at(&known, INT64_C(3), INT64_C(1) + axis));
    longest = (*cspan_at(&known, INT64_C(1), INT64_C(2)));
    if ((axis == INT64_C(2)) && (longest > 0.0))
    {
        end = span_max(end, -longest);
    }
    return end + end_rounding_of(end);
}
static double high_end(int64_t axis, array_double_2d known)
{
    double end;
    end = (*cspan_at(&known, INT64_C(3), INT64_C(4) + axis));
    if (axis == INT64_C(2))
    {
        end = span_min(end, -(*cspan_at(&known, INT64_C(1), INT64_C(1))));
    }
    return end - end_rounding_of(end);
}
static void write_push(double scale, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    array_double_1d aim;
    array_double_1d command;
    int64_t axis;
    double push;
    double distance;
    int64_t i;
    double wished;
    aim = span_row(&operation, INT64_C(1));
    command = span_row(&operation, INT64_C(0));
    if ((*cspan_at(&operation, INT64_C(4), INT64_C(5))) != INT64_C(4))
    {
        (*cspan_at(&aim, INT64_C(0))) = 0.0;
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            (*cspan_at(&aim, INT64_C(1) + axis)) = 0.0;
            (*cspan_at(&operation, INT64_C(5), axis)) = push_of((*cspan_at(&command, INT64_C(3) + axis)));
        }
    }
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        push = push_of((*cspan_at(&command, INT64_C(3) + axis)));
        if (push == (*cspan_at(&operation, INT64_C(5), axis)))
        {
            continue;
        }
        (*cspan_at(&operation, INT64_C(5), axis)) = push;
        distance = (*cspan_at(&command, INT64_C(11) + axis));
        if ((fabs(push) > 0.0) && (0.0 < distance) && (distance < 1e+300))
        {
            if ((*cspan_at(&aim, INT64_C(0))) < 0.5)
            {
                (*cspan_at(&aim, INT64_C(0))) = 1.0;
                for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
                {
                    (*cspan_at(&aim, INT64_C(1) + i)) = standstill(INT64_C(0), i, timing, coefficients, offsets);
                }
            }
            wished = (*cspan_at(&aim, INT64_C(1) + axis)) + push * distance;
            (*cspan_at(&aim, INT64_C(1) + axis)) = span_min(span_max(wished, low_end(axis, known)), high_end(axis, known));
        }
    }
    (*cspan_at(&aim, INT64_C(4))) = scale * (*cspan_at(&aim, INT64_C(0)));
}
static double limited_velocity(double velocity, double scale, double limit, double lower)
{
    double least;
    least = limit;
    if (lower > 0.0)
    {
        least = lower;
    }
    if (velocity > 0.0)
    {
        return span_min(velocity, scale * limit);
    }
    if (velocity < 0.0)
    {
        return span_max(velocity, (-scale) * least);
    }
    return 0.0;
}
static void write_wish(int64_t mode, double scale, array_double_1d aim, array_double_1d command, array_double_2d limits, array_double_2d known)
{
    int64_t axis;
    double lower;
    (*cspan_at(&aim, INT64_C(0))) = 0.0;
    (*cspan_at(&aim, INT64_C(4))) = 0.0;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        (*cspan_at(&aim, INT64_C(1) + axis)) = 0.0;
    }
    if (mode == INT64_C(2))
    {
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            lower = (*cspan_at(&known, INT64_C(5) + axis, INT64_C(0)));
            (*cspan_at(&aim, INT64_C(1) + axis)) = limited_velocity((*cspan_at(&command, INT64_C(3) + axis)), scale, (*cspan_at(&limits, axis, INT64_C(0))), lower);
        }
    }
    else if ((mode == INT64_C(1)) && ((*cspan_at(&command, INT64_C(9))) > 0.5) && (scale > 0.0))
    {
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            if (!(fabs((*cspan_at(&command, INT64_C(6) + axis))) < 1e+300))
            {
                return;
            }
        }
        (*cspan_at(&aim, INT64_C(0))) = 1.0;
        (*cspan_at(&aim, INT64_C(4))) = scale;
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            (*cspan_at(&aim, INT64_C(1) + axis)) = (*cspan_at(&command, INT64_C(6) + axis));
        }
    }
}
static void write_aim(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    array_double_1d command;
    int64_t mode;
    double scale;
    int64_t axis;
    command = span_row(&operation, INT64_C(0));
    mode = (int64_t)((*cspan_at(&command, INT64_C(2))));
    scale = (*cspan_at(&command, INT64_C(10)));
    if (!(scale >= least_scale()))
    {
        scale = 0.0;
    }
    scale = span_min(scale, 1.0);
    if ((mode == INT64_C(4)) && (scale > 0.0))
    {
        write_push(scale, operation, known, timing, coefficients, offsets);
    }
    else
    {
        write_wish(mode, scale, span_row(&operation, INT64_C(1)), command, limits, known);
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            (*cspan_at(&operation, INT64_C(5), axis)) = 0.0;
        }
    }
    (*cspan_at(&operation, INT64_C(4), INT64_C(5))) = mode;
}
static int64_t most_attempts(void)
{
    return INT64_C(9);
}
static int64_t most_in_step(void)
{
    return INT64_C(3);
}
static int64_t first_stop(void)
{
    return INT64_C(6);
}
static double pace_of(int64_t attempt)
{
    if ((attempt == INT64_C(1)) || (attempt == INT64_C(7)))
    {
        return sqrt(0.5);
    }
    if ((attempt == INT64_C(2)) || (attempt == INT64_C(8)))
    {
        return 0.5;
    }
    return 1.0;
}
static double share_of(int64_t attempt, int64_t axis)
{
    if (attempt >= first_stop())
    {
        return 0.0;
    }
    if (attempt == INT64_C(3))
    {
        return 0.25;
    }
    if ((attempt == INT64_C(4)) && (axis == INT64_C(2)))
    {
        return 0.0;
    }
    if ((attempt == INT64_C(5)) && (axis < INT64_C(2)))
    {
        return 0.0;
    }
    return 1.0;
}
static bool is_worth(int64_t attempt, int64_t failed, array_double_1d aim)
{
    bool slows;
    bool blocked;
    double horizontal;
    double vertical;
    slows = (attempt == INT64_C(1)) || (attempt == INT64_C(2)) || (attempt == INT64_C(7)) || (attempt == INT64_C(8));
    blocked = (failed == INT64_C(4)) || (failed == INT64_C(5));
    if (slows && blocked)
    {
        return 0;
    }
    if (attempt >= first_stop())
    {
        return 1;
    }
    if ((*cspan_at(&aim, INT64_C(0))) > 0.5)
    {
        return attempt <= INT64_C(2);
    }
    horizontal = fabs((*cspan_at(&aim, INT64_C(1)))) + fabs((*cspan_at(&aim, INT64_C(1) + INT64_C(1))));
    vertical = fabs((*cspan_at(&aim, INT64_C(1) + INT64_C(2))));
    if ((attempt == INT64_C(4)) || (attempt == INT64_C(5)))
    {
        return (horizontal > 0.0) && (vertical > 0.0);
    }
    return horizontal + vertical > 0.0;
}
static void set_lower_of(int64_t place, array_double_2d operation, array_double_3d limits, array_double_2d known)
{
    int64_t axis;
    int64_t i;
    double share;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
        {
            share = (*cspan_at(&limits, place, axis, i)) / (*cspan_at(&limits, INT64_C(0), axis, i));
            (*cspan_at(&operation, INT64_C(17) + axis, i)) = share * (*cspan_at(&known, INT64_C(5) + axis, i));
        }
    }
}
static void set_attempt(int64_t attempt, array_double_2d operation, array_double_3d limits, array_double_2d known)
{
    double pace;
    double scale;
    int64_t axis;
    double power;
    int64_t i;
    pace = pace_of(attempt);
    scale = 1.0;
    if (((*cspan_at(&operation, INT64_C(1), INT64_C(0))) > 0.5) && (attempt < first_stop()))
    {
        scale = (*cspan_at(&operation, INT64_C(1), INT64_C(4)));
    }
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        power = pace;
        (*cspan_at(&limits, INT64_C(1), axis, INT64_C(0))) = scale * (*cspan_at(&limits, INT64_C(0), axis, INT64_C(0)));
        for (i = INT64_C(1); i < limits.shape[INT64_C(2)]; i += INT64_C(1))
        {
            power = power * pace;
            (*cspan_at(&limits, INT64_C(1), axis, i)) = power * (*cspan_at(&limits, INT64_C(0), axis, i));
        }
    }
    set_lower_of(INT64_C(1), operation, limits, known);
}
static void set_range(double centre, double radius, array_double_1d found)
{
    (*cspan_at(&found, INT64_C(0))) = centre;
    (*cspan_at(&found, INT64_C(1))) = radius;
}
static void add_range(double share, array_double_1d a, array_double_1d found)
{
    (*cspan_at(&found, INT64_C(0))) = (*cspan_at(&found, INT64_C(0))) + share * (*cspan_at(&a, INT64_C(0)));
    (*cspan_at(&found, INT64_C(1))) = (*cspan_at(&found, INT64_C(1))) + fabs(share) * (*cspan_at(&a, INT64_C(1)));
}
static void add_range_product(double share, array_double_1d a, array_double_1d b, array_double_1d found)
{
    double radius;
    radius = fabs((*cspan_at(&a, INT64_C(0)))) * (*cspan_at(&b, INT64_C(1)));
    radius = radius + (*cspan_at(&a, INT64_C(1))) * (fabs((*cspan_at(&b, INT64_C(0)))) + (*cspan_at(&b, INT64_C(1))));
    (*cspan_at(&found, INT64_C(0))) = (*cspan_at(&found, INT64_C(0))) + share * (*cspan_at(&a, INT64_C(0))) * (*cspan_at(&b, INT64_C(0)));
    (*cspan_at(&found, INT64_C(1))) = (*cspan_at(&found, INT64_C(1))) + fabs(share) * radius;
}
static void divide_range(array_double_1d a, array_double_1d b, array_double_1d found)
{
    double quotient;
    double least;
    quotient = (*cspan_at(&a, INT64_C(0))) / (*cspan_at(&b, INT64_C(0)));
    least = (*cspan_at(&b, INT64_C(0))) - (*cspan_at(&b, INT64_C(1)));
    (*cspan_at(&found, INT64_C(1))) = ((*cspan_at(&a, INT64_C(1))) + fabs(quotient) * (*cspan_at(&b, INT64_C(1)))) / least;
    (*cspan_at(&found, INT64_C(0))) = quotient;
}
static void write_derivative(int64_t order, int64_t width, double radius, array_double_1d piece, array_double_1d found)
{
    double total;
    double value;
    int64_t j;
    int64_t i;
    int64_t k;
    total = 0.0;
    value = 0.0;
    for (j = INT64_C(0); j < width - order; j += INT64_C(1))
    {
        i = width - INT64_C(1) - j;
        value = (*cspan_at(&piece, i));
        for (k = INT64_C(0); k < order; k += INT64_C(1))
        {
            value = value * (i - k);
        }
        if (i > order)
        {
            total = (total + fabs(value)) * radius;
        }
    }
    set_range(value, total, found);
}
static void write_load(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d work)
{
    int64_t width;
    double middle;
    double radius;
    array_double_1d piece;
    int64_t axis;
    int64_t last;
    int64_t row;
    int64_t i;
    double local;
    int64_t order;
    int64_t place;
    width = coefficients.shape[INT64_C(1)];
    middle = 0.5 * (begin + end);
    radius = 0.5 * (end - begin);
    piece = span_row(&work, INT64_C(89));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        last = (*cspan_at(&offsets, axis + INT64_C(1)));
        row = find_piece(middle, timing, (*cspan_at(&offsets, axis)), last);
        for (i = INT64_C(0); i < width; i += INT64_C(1))
        {
            (*cspan_at(&piece, i)) = (*cspan_at(&coefficients, row, i));
        }
        local = middle - (*cspan_at(&timing, row, INT64_C(0)));
        if (local > (*cspan_at(&timing, row, INT64_C(1))))
        {
            (*cspan_at(&piece, INT64_C(0))) = evaluate_piece(coefficients, row, width, (*cspan_at(&timing, row, INT64_C(1))), INT64_C(0));
            for (i = INT64_C(1); i < width; i += INT64_C(1))
            {
                (*cspan_at(&piece, i)) = 0.0;
            }
        }
        else
        {
            polynomial_shift(piece, local, width);
        }
        for (order = INT64_C(0); order < INT64_C(5); order += INT64_C(1))
        {
            place = INT64_C(90) + INT64_C(0) + INT64_C(3) * order + axis;
            write_derivative(order, width, radius, piece, span_row(&work, place));
        }
    }
}
static void write_slope(int64_t axis, array_double_2d reach)
{
    array_double_1d slope;
    array_double_1d rate;
    array_double_1d pull;
    array_double_1d pull_rate;
    array_double_1d total;
    slope = span_row(&reach, INT64_C(16) + axis);
    rate = span_row(&reach, INT64_C(18) + axis);
    pull = span_row(&reach, INT64_C(15));
    pull_rate = span_row(&reach, INT64_C(9) + INT64_C(2));
    total = span_row(&reach, INT64_C(26));
    divide_range(span_row(&reach, INT64_C(6) + axis), pull, slope);
    set_range(0.0, 0.0, total);
    add_range(1.0, span_row(&reach, INT64_C(9) + axis), total);
    add_range_product(-1.0, slope, pull_rate, total);
    divide_range(total, pull, rate);
    set_range(0.0, 0.0, total);
    add_range(1.0, span_row(&reach, INT64_C(12) + axis), total);
    add_range_product(-2.0, rate, pull_rate, total);
    add_range_product(-1.0, slope, span_row(&reach, INT64_C(12) + INT64_C(2)), total);
    divide_range(total, pull, span_row(&reach, INT64_C(20) + axis));
}
static void write_stretch(array_double_2d reach)
{
    array_double_1d total;
    array_double_1d stretch;
    array_double_1d rate;
    int64_t axis;
    double root;
    array_double_1d slope_rate;
    total = span_row(&reach, INT64_C(26));
    stretch = span_row(&reach, INT64_C(22));
    rate = span_row(&reach, INT64_C(23));
    set_range(1.0, 0.0, total);
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        add_range_product(1.0, span_row(&reach, INT64_C(16) + axis), span_row(&reach, INT64_C(16) + axis), total);
    }
    root = sqrt((*cspan_at(&total, INT64_C(0))));
    set_range(root, (*cspan_at(&total, INT64_C(1))) / (1.0 + root), stretch);
    set_range(0.0, 0.0, total);
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        slope_rate = span_row(&reach, INT64_C(18) + axis);
        add_range_product(1.0, span_row(&reach, INT64_C(16) + axis), slope_rate, total);
    }
    divide_range(total, stretch, rate);
    set_range(0.0, 0.0, total);
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        slope_rate = span_row(&reach, INT64_C(18) + axis);
        add_range_product(1.0, slope_rate, slope_rate, total);
        add_range_product(1.0, span_row(&reach, INT64_C(16) + axis), span_row(&reach, INT64_C(20) + axis), total);
    }
    add_range_product(-1.0, rate, rate, total);
    divide_range(total, stretch, span_row(&reach, INT64_C(24)));
}
static void write_drive(int64_t drive, double ahead, array_double_1d factor, array_double_1d rate, array_double_1d change, array_double_2d reach)
{
    array_double_1d velocity;
    array_double_1d acceleration;
    velocity = span_row(&reach, INT64_C(27) + INT64_C(3) + drive);
    acceleration = span_row(&reach, INT64_C(27) + INT64_C(6) + drive);
    set_range(0.0, 0.0, velocity);
    add_range(ahead, span_row(&reach, INT64_C(3) + drive), velocity);
    add_range_product(-1.0, span_row(&reach, INT64_C(3) + INT64_C(2)), factor, velocity);
    add_range_product(-1.0, span_row(&reach, INT64_C(0) + INT64_C(2)), rate, velocity);
    set_range(0.0, 0.0, acceleration);
    add_range(ahead, span_row(&reach, INT64_C(6) + drive), acceleration);
    add_range_product(-1.0, span_row(&reach, INT64_C(6) + INT64_C(2)), factor, acceleration);
    add_range_product(-2.0, span_row(&reach, INT64_C(3) + INT64_C(2)), rate, acceleration);
    add_range_product(-1.0, span_row(&reach, INT64_C(0) + INT64_C(2)), change, acceleration);
}
static void add_resistance(int64_t drive, array_double_1d crane, array_double_2d reach)
{
    array_double_1d velocity;
    double most;
    double dry;
    double smooth;
    velocity = span_row(&reach, INT64_C(27) + INT64_C(3) + drive);
    most = fabs((*cspan_at(&velocity, INT64_C(0)))) + (*cspan_at(&velocity, INT64_C(1)));
    dry = span_max((*cspan_at(&crane, INT64_C(10) + drive)), (*cspan_at(&crane, INT64_C(7) + drive)));
    smooth = (*cspan_at(&crane, INT64_C(4) + drive)) + (*cspan_at(&crane, INT64_C(13) + drive)) * most;
    set_range(0.0, dry + smooth * most, span_row(&reach, INT64_C(25)));
    add_range(1.0, span_row(&reach, INT64_C(25)), span_row(&reach, INT64_C(27) + INT64_C(0) + drive));
}
static void write_forces(array_double_1d crane, array_double_2d reach)
{
    double payload;
    int64_t drive;
    array_double_1d force;
    array_double_1d acceleration;
    array_double_1d power;
    payload = (*cspan_at(&crane, INT64_C(2)));
    for (drive = INT64_C(0); drive < INT64_C(2); drive += INT64_C(1))
    {
        force = span_row(&reach, INT64_C(27) + INT64_C(0) + drive);
        set_range(0.0, 0.0, force);
        acceleration = span_row(&reach, INT64_C(27) + INT64_C(6) + drive);
        add_range(carriage_mass(crane, drive), acceleration, force);
        add_range(payload, span_row(&reach, INT64_C(6) + drive), force);
    }
    force = span_row(&reach, INT64_C(27) + INT64_C(0) + INT64_C(2));
    set_range(0.0, 0.0, force);
    add_range_product(-payload, span_row(&reach, INT64_C(15)), span_row(&reach, INT64_C(22)), force);
    for (drive = INT64_C(0); drive < INT64_C(3); drive += INT64_C(1))
    {
        add_resistance(drive, crane, reach);
        power = span_row(&reach, INT64_C(27) + INT64_C(9) + drive);
        set_range(0.0, 0.0, power);
        add_range_product(1.0, span_row(&reach, INT64_C(27) + INT64_C(0) + drive), span_row(&reach, INT64_C(27) + INT64_C(3) + drive), power);
    }
}
static void write_sway(array_double_2d reach)
{
    array_double_1d q_x;
    array_double_1d q_y;
    double across;
    double most;
    q_x = span_row(&reach, INT64_C(16));
    q_y = span_row(&reach, INT64_C(16) + INT64_C(1));
    across = (*cspan_at(&q_x, INT64_C(0))) / sqrt(1.0 + (*cspan_at(&q_y, INT64_C(0))) * (*cspan_at(&q_y, INT64_C(0))));
    most = fabs((*cspan_at(&q_x, INT64_C(0)))) + (*cspan_at(&q_x, INT64_C(1)));
    set_range(-atan(across), (*cspan_at(&q_x, INT64_C(1))) + most * (*cspan_at(&q_y, INT64_C(1))), span_row(&reach, INT64_C(27) + INT64_C(12)));
    set_range(atan((*cspan_at(&q_y, INT64_C(0)))), (*cspan_at(&q_y, INT64_C(1))), span_row(&reach, INT64_C(27) + INT64_C(12) + INT64_C(1)));
}
static bool write_reach(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_1d crane, array_double_2d work)
{
    array_double_2d reach;
    array_double_1d pull;
    int64_t axis;
    write_load(begin, end, timing, coefficients, offsets, work);
    reach = span_rows(&work, INT64_C(90), INT64_C(131));
    pull = span_row(&reach, INT64_C(15));
    set_range((*cspan_at(&crane, INT64_C(3))), 0.0, pull);
    add_range(1.0, span_row(&reach, INT64_C(6) + INT64_C(2)), pull);
    if (!((*cspan_at(&pull, INT64_C(0))) > (*cspan_at(&pull, INT64_C(1)))))
    {
        return 0;
    }
    write_slope(INT64_C(0), reach);
    write_slope(INT64_C(1), reach);
    write_stretch(reach);
    for (axis = INT64_C(0); axis < INT64_C(2); axis += INT64_C(1))
    {
        write_drive(axis, 1.0, span_row(&reach, INT64_C(16) + axis), span_row(&reach, INT64_C(18) + axis), span_row(&reach, INT64_C(20) + axis), reach);
    }
    write_drive(INT64_C(2), 0.0, span_row(&reach, INT64_C(22)), span_row(&reach, INT64_C(23)), span_row(&reach, INT64_C(24)), reach);
    write_forces(crane, reach);
    write_sway(reach);
    return 1;
}
static int64_t judge_reach(array_double_1d bounds, array_double_2d work)
{
    double rounding;
    int64_t i;
    array_double_1d demand;
    int64_t side;
    double bound;
    double value;
    int64_t proved;
    proved = INT64_C(1);
    rounding = 1.0 + 1e-09;
    for (i = INT64_C(0); i < INT64_C(14); i += INT64_C(1))
    {
        demand = span_row(&work, INT64_C(90) + INT64_C(27) + i);
        for (side = INT64_C(0); side < INT64_C(2); side += INT64_C(1))
        {
            bound = bound_magnitude(i, side, bounds) * rounding;
            if (bound != 0.0)
            {
                value = (1.0 - 2.0 * side) * (*cspan_at(&demand, INT64_C(0)));
                if (!(value <= bound))
                {
                    return -INT64_C(1);
                }
                if (!(value + (*cspan_at(&demand, INT64_C(1))) <= bound))
                {
                    proved = INT64_C(0);
                }
            }
        }
    }
    return proved;
}
static bool keeps_between(double begin, double end, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work)
{
    int64_t depth;
    int64_t place;
    double length;
    double start;
    int64_t found;
    depth = INT64_C(0);
    place = INT64_C(0);
    while((depth > INT64_C(0)) || (place == INT64_C(0)))
    {
        length = (end - begin) * pow(0.5, (double)(depth));
        start = begin + place * length;
        found = INT64_C(0);
        if (write_reach(start, start + length, timing, coefficients, offsets, span_row(&known, INT64_C(0)), work))
        {
            found = judge_reach(span_row(&known, INT64_C(2)), work);
        }
        if ((found < INT64_C(0)) || ((found == INT64_C(0)) && (depth == INT64_C(10))))
        {
            return 0;
        }
        if (found == INT64_C(0))
        {
            place = INT64_C(2) * place;
            depth = depth + INT64_C(1);
        }
        else
        {
            place = place + INT64_C(1);
            while((depth > INT64_C(0)) && (span_floor_mod(place, INT64_C(2)) == INT64_C(0)))
            {
                place = span_floor_div(place, INT64_C(2));
                depth = depth - INT64_C(1);
            }
        }
    }
    return 1;
}
bool segfmu_keeps_drives(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d known, array_double_2d work)
{
    bool bounded;
    int64_t i;
    double time;
    double until;
    int64_t intervals;
    bounded = 0;
    for (i = INT64_C(0); i < INT64_C(23); i += INT64_C(1))
    {
        if ((*cspan_at(&known, INT64_C(2), i)) != 0.0)
        {
            bounded = 1;
        }
    }
    if (!bounded)
    {
        return 1;
    }
    time = (*cspan_at(&timing, (*cspan_at(&offsets, INT64_C(0))), INT64_C(0)));
    until = interval_end(time, timing, offsets);
    intervals = INT64_C(0);
    while((until > time) || (intervals == INT64_C(0)))
    {
        intervals = intervals + INT64_C(1);
        if (!keeps_between(time, until, timing, coefficients, offsets, known, work))
        {
            return 0;
        }
        time = until;
        until = interval_end(time, timing, offsets);
    }
    return 1;
}
static double inner_rise(double rise, int64_t level, array_double_1d axis)
{
    double result;
    result = span_min(span_max((*cspan_at(&axis, INT64_C(21) + level)), (*cspan_at(&axis, INT64_C(26) + level)) * rise), 0.5 * rise);
    return result;
}
static double shifted_root(double value, int64_t power, double shift)
{
    int64_t i;
    double x_power;
    int64_t j;
    double error;
    double step;
    double x;
    if (power == INT64_C(0))
    {
        return value + shift;
    }
    if (power == INT64_C(1))
    {
        return 0.5 * (shift + sqrt(shift * shift + 4.0 * value));
    }
    x = shift + pow(value, (1.0 / (power + INT64_C(1))));
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        x_power = 1.0;
        for (j = INT64_C(0); j < power - INT64_C(1); j += INT64_C(1))
        {
            x_power = x_power * x;
        }
        error = x_power * x * (x - shift) - value;
        step = error / (x_power * (power * (x - shift) + x));
        if (step <= 2e-16 * x)
        {
            break;
        }
        x = x - step;
    }
    return x;
}
static int64_t plateau_duration(double* result_0_0001, double* result_1_0001, double change, int64_t first, array_double_1d axis)
{
    int64_t boxes;
    double factor;
    double doubled;
    int64_t level;
    double limit;
    double least;
    double share;
    int64_t power;
    double x_power;
    int64_t j;
    double value;
    double x;
    double rest;
    boxes = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(1);
    factor = 1.0;
    doubled = 1.0;
    for (level = first; level < boxes; level += INT64_C(1))
    {
        limit = (*cspan_at(&axis, INT64_C(4) + level));
        least = (*cspan_at(&axis, INT64_C(21) + level));
        share = (*cspan_at(&axis, INT64_C(26) + level));
        power = level - first;
        x_power = 1.0;
        for (j = INT64_C(0); j < power; j += INT64_C(1))
        {
            x_power = x_power * 2.0 * least;
        }
        if ((limit > 0.0) && (change >= factor * x_power * limit * least))
        {
            value = change / (factor * limit);
            x = 0.0;
            if (share > 0.0)
            {
                x = value / (1.0 - share);
                if (power == INT64_C(1))
                {
                    x = sqrt(x);
                }
                else if (power > INT64_C(1))
                {
                    x = pow(x, (1.0 / (power + INT64_C(1))));
                }
            }
            if ((share == 0.0) || (share * x < least))
            {
                if ((least > 0.0) || (power == INT64_C(0)))
                {
                    x = shifted_root(value, power, least);
                }
                else if (power == INT64_C(1))
                {
                    x = sqrt(value);
                }
                else
                {
                    x = pow(value, (1.0 / (power + INT64_C(1))));
                }
                rest = x - least;
                (*result_0_0001) = doubled * x;
                (*result_1_0001) = doubled * x * rest / (change * (power * rest + x));
                return 0;
            }
            (*result_0_0001) = doubled * x;
            (*result_1_0001) = doubled * x / ((power + INT64_C(1)) * change);
            return 0;
        }
        factor = factor * doubled;
        doubled = 2.0 * doubled;
    }
    (*result_0_0001) = 0.0;
    (*result_1_0001) = 0.0;
    return 0;
}
static int64_t plateau_change(double* result_0, double* result_1_0001, double duration, int64_t first, array_double_1d axis)
{
    int64_t boxes;
    double x;
    double factor;
    double doubled;
    int64_t level;
    double least;
    double share;
    int64_t power;
    double steepest;
    int64_t j;
    double change;
    boxes = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(1);
    x = duration;
    factor = 1.0;
    doubled = 1.0;
    for (level = first; level < boxes; level += INT64_C(1))
    {
        least = (*cspan_at(&axis, INT64_C(21) + level));
        if (x >= 2.0 * least)
        {
            share = (*cspan_at(&axis, INT64_C(26) + level));
            power = level - first;
            steepest = factor * (*cspan_at(&axis, INT64_C(4) + level));
            for (j = INT64_C(0); j < power; j += INT64_C(1))
            {
                steepest = steepest * x;
            }
            if (share * x >= least)
            {
                change = steepest * (1.0 - share) * x;
                (*result_0) = change;
                (*result_1_0001) = (power + INT64_C(1)) * change / duration;
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
static int64_t slowest_root(double* result_0, double* result_1_0001, double change, array_double_1d axis)
{
    double slowest;
    int64_t exponent;
    double root;
    int64_t e;
    slowest = (*cspan_at(&axis, INT64_C(31))) * change;
    exponent = INT64_C(1);
    if ((*cspan_at(&axis, INT64_C(31) + INT64_C(1))) > 0.0)
    {
        root = sqrt((*cspan_at(&axis, INT64_C(31) + INT64_C(1))) * change);
        if (root > slowest)
        {
            slowest = root;
            exponent = INT64_C(2);
        }
    }
    for (e = INT64_C(3); e < INT64_C(6); e += INT64_C(1))
    {
        if ((*cspan_at(&axis, INT64_C(31) + e - INT64_C(1))) > 0.0)
        {
            root = pow(((*cspan_at(&axis, INT64_C(31) + e - INT64_C(1))) * change), (1.0 / e));
            if (root > slowest)
            {
                slowest = root;
                exponent = e;
            }
        }
    }
    (*result_0) = slowest;
    (*result_1_0001) = slowest / (exponent * change);
    return 0;
}
static int64_t fastest_power(double* result_0, double* result_1_0001, double duration, array_double_1d axis)
{
    double fastest;
    int64_t exponent;
    double power;
    int64_t e;
    double change;
    fastest = -1.0;
    exponent = INT64_C(1);
    power = 1.0;
    for (e = INT64_C(1); e < INT64_C(6); e += INT64_C(1))
    {
        power = power * duration;
        if ((*cspan_at(&axis, INT64_C(31) + e - INT64_C(1))) > 0.0)
        {
            change = power / (*cspan_at(&axis, INT64_C(31) + e - INT64_C(1)));
            if ((fastest < 0.0) || (change < fastest))
            {
                fastest = change;
                exponent = e;
            }
        }
    }
    (*result_0) = fastest;
    (*result_1_0001) = exponent * fastest / duration;
    return 0;
}
SPAN_INLINE int64_t segfmu_ramp_duration(double* result_0, double* result_1, double change, array_double_1d axis)
{
    double slope;
    double duration;
    if (change <= 0.0)
    {
        (*result_0) = 0.0;
        (*result_1) = 0.0;
        return 0;
    }
    if (change >= (*cspan_at(&axis, INT64_C(15))))
    {
        slope = (*cspan_at(&axis, INT64_C(16)));
        (*result_0) = change * slope + (*cspan_at(&axis, INT64_C(18)));
        (*result_1) = slope;
        return 0;
    }
    if ((*cspan_at(&axis, INT64_C(19))) > 0.0)
    {
        duration = sqrt((*cspan_at(&axis, INT64_C(19))) * change);
        (*result_0) = duration;
        (*result_1) = 0.5 / change * duration;
        return 0;
    }
    if ((*cspan_at(&axis, INT64_C(14))) < 0.5)
    {
        slowest_root(result_0, result_1, change, axis);
        return 0;
    }
    plateau_duration(result_0, result_1, change, INT64_C(0), axis);
    return 0;
}
static SPAN_INLINE int64_t ramp_change(double* result_0, double* result_1, double duration, array_double_1d axis)
{
    double slope;
    if (duration <= 0.0)
    {
        (*result_0) = 0.0;
        (*result_1) = 0.0;
        return 0;
    }
    if ((*cspan_at(&axis, INT64_C(19))) > 0.0)
    {
        if (((*cspan_at(&axis, INT64_C(16))) > 0.0) && (duration >= 2.0 * (*cspan_at(&axis, INT64_C(21)))))
        {
            slope = (*cspan_at(&axis, INT64_C(17)));
            (*result_0) = (duration - (*cspan_at(&axis, INT64_C(18)))) * slope;
            (*result_1) = slope;
            return 0;
        }
        slope = duration * (*cspan_at(&axis, INT64_C(20)));
        (*result_0) = slope * duration;
        (*result_1) = 2.0 * slope;
        return 0;
    }
    if ((*cspan_at(&axis, INT64_C(14))) < 0.5)
    {
        fastest_power(result_0, result_1, duration, axis);
        return 0;
    }
    plateau_change(result_0, result_1, duration, INT64_C(0), axis);
    return 0;
}
static int64_t rise_moments(double* result_0_0001, double* result_1_0001, double duration, int64_t first, array_double_1d axis)
{
    double rise;
    double squares;
    double fourths;
    int64_t level;
    double inner;
    double square;
    rise = duration;
    squares = 0.0;
    fourths = 0.0;
    for (level = first; level < (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(2); level += INT64_C(1))
    {
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
static SPAN_INLINE double ramp_variance(double basis, array_double_1d axis)
{
    double rise;
    double box;
    double fourth;
    double variance;
    if (((*cspan_at(&axis, INT64_C(16))) > 0.0) && ((*cspan_at(&axis, INT64_C(14))) > 0.5))
    {
        rise = (*cspan_at(&axis, INT64_C(21)));
        if ((basis >= 2.0 * rise) && ((*cspan_at(&axis, INT64_C(26))) == 0.0))
        {
            box = basis - rise;
            variance = box * box / 12.0 + (*cspan_at(&axis, INT64_C(37)));
            return variance;
        }
    }
    if ((*cspan_at(&axis, INT64_C(36))) > 0.0)
    {
        variance = (*cspan_at(&axis, INT64_C(36))) * basis * basis;
        return variance;
    }
    rise_moments(&variance, &fourth, basis, INT64_C(0), axis);
    return variance;
}
static SPAN_INLINE double ramp_distance(double v, double a, double b, double duration, double basis, array_double_1d axis)
{
    double variance;
    double y;
    y = (v + 0.5 * a * duration) * duration;
    if (b == a)
    {
        return y;
    }
    variance = ramp_variance(basis, axis);
    if (duration != basis)
    {
        variance = variance * (duration / basis) * (duration / basis);
    }
    return y + (b - a) * (0.125 * duration * duration + 0.5 * variance);
}
static int64_t rise_pieces(int64_t boxes)
{
    int64_t i;
    int64_t count;
    count = INT64_C(0);
    for (i = INT64_C(0); i < boxes; i += INT64_C(1))
    {
        count = INT64_C(2) * count + INT64_C(1);
    }
    return count;
}
int64_t segfmu_ramp_pieces(array_double_1d axis)
{
    int64_t result;
    if ((*cspan_at(&axis, INT64_C(14))) < 0.5)
    {
        return INT64_C(1);
    }
    result = rise_pieces((int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(1));
    return result;
}
static int64_t held_level(int64_t* result_0, double* result_1, int64_t piece, int64_t boxes)
{
    int64_t level;
    int64_t rest;
    double sign;
    level = boxes - INT64_C(1);
    rest = piece;
    while(span_floor_mod(rest, INT64_C(2)) == INT64_C(0))
    {
        level = level - INT64_C(1);
        rest = span_floor_div(rest, INT64_C(2));
    }
    sign = 1.0;
    rest = span_floor_div(rest, INT64_C(2));
    while(rest > INT64_C(0))
    {
        if (span_floor_mod(rest, INT64_C(2)) == INT64_C(1))
        {
            sign = -sign;
        }
        rest = span_floor_div(rest, INT64_C(2));
    }
    (*result_0) = level;
    (*result_1) = sign;
    return 0;
}
static int64_t held_peak(double* result_0_0001, double* result_1_0001, double* result_2, int64_t level, int64_t first, double rise, double peak, double stretch, array_double_1d axis)
{
    double inner;
    inner = 0.0;
    if (level < (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(2) - first)
    {
        inner = inner_rise(rise, first + level, axis);
    }
    (*result_0_0001) = (rise - 2.0 * inner) * stretch;
    (*result_1_0001) = peak / ((rise - inner) * stretch);
    (*result_2) = inner;
    return 0;
}
static int64_t piece_peak(double* result_0, double* result_1, int64_t level, int64_t first, double change, double duration, double basis, array_double_1d axis)
{
    double stretch;
    double rise;
    double peak;
    double length;
    int64_t i;
    stretch = duration / basis;
    rise = basis;
    peak = change;
    length = 0.0;
    for (i = INT64_C(0); i < level + INT64_C(1); i += INT64_C(1))
    {
        held_peak(&length, &peak, &rise, i, first, rise, peak, stretch, axis);
    }
    (*result_0) = length;
    (*result_1) = peak;
    return 0;
}
static void transition_coefficients(int64_t order, array_double_1d coefficients)
{
    int64_t i;
    double scale;
    double binomial;
    for (i = INT64_C(0); i < INT64_C(2) * order + INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&coefficients, i)) = 0.0;
    }
    scale = 1.0;
    for (i = INT64_C(1); i < order + INT64_C(1); i += INT64_C(1))
    {
        scale = scale * (order + INT64_C(1) + i) / i;
    }
    scale = scale * (order + INT64_C(1));
    binomial = 1.0;
    for (i = INT64_C(0); i < order + INT64_C(1); i += INT64_C(1))
    {
        (*cspan_at(&coefficients, order + INT64_C(1) + i)) = scale * binomial / (order + INT64_C(1) + i);
        binomial = (-binomial) * (order - i) / (i + INT64_C(1));
    }
}
static double polynomial_derivative(array_double_1d coefficients, int64_t count, int64_t times, double s)
{
    int64_t j;
    int64_t i;
    double factor;
    int64_t m;
    double value;
    value = 0.0;
    for (j = INT64_C(0); j < count - times; j += INT64_C(1))
    {
        i = count - INT64_C(1) - j;
        factor = 1.0;
        for (m = INT64_C(0); m < times; m += INT64_C(1))
        {
            factor = factor * (i - m);
        }
        value = value * s + factor * (*cspan_at(&coefficients, i));
    }
    return value;
}
static void transition_peaks(int64_t order, array_double_1d coefficients, array_double_1d peaks)
{
    int64_t count;
    int64_t samples;
    int64_t j;
    double best;
    int64_t at;
    int64_t i;
    double value;
    double lower;
    double upper;
    double left;
    double middle;
    double slope;
    count = INT64_C(2) * order + INT64_C(2);
    transition_coefficients(order, coefficients);
    (*cspan_at(&peaks, INT64_C(0))) = 1.0;
    samples = INT64_C(64) * (order + INT64_C(1));
    for (j = INT64_C(1); j < order + INT64_C(2); j += INT64_C(1))
    {
        best = 0.0;
        at = INT64_C(0);
        for (i = INT64_C(0); i < samples + INT64_C(1); i += INT64_C(1))
        {
            value = fabs(polynomial_derivative(coefficients, count, j, i / (2.0 * samples)));
            if (value > best)
            {
                best = value;
                at = i;
            }
        }
        lower = (at - INT64_C(1)) / (2.0 * samples);
        upper = (at + INT64_C(1)) / (2.0 * samples);
        if (at == INT64_C(0))
        {
            lower = 0.0;
        }
        left = polynomial_derivative(coefficients, count, j + INT64_C(1), lower);
        for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
        {
            middle = 0.5 * (lower + upper);
            slope = polynomial_derivative(coefficients, count, j + INT64_C(1), middle);
            if (slope * left > 0.0)
            {
                lower = middle;
            }
            else
            {
                upper = middle;
            }
        }
        value = fabs(polynomial_derivative(coefficients, count, j, 0.5 * (lower + upper)));
        if (value > best)
        {
            best = value;
        }
        (*cspan_at(&peaks, j)) = best;
    }
}
static int64_t append_piece(double duration, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_1d state)
{
    int64_t width;
    int64_t order;
    double factorial;
    int64_t i;
    int64_t used;
    double y;
    double v;
    double a;
    double jerk;
    int64_t j;
    width = coefficients.shape[INT64_C(1)];
    order = span_floor_div(width, INT64_C(2)) + INT64_C(1);
    (*cspan_at(&coefficients, row, INT64_C(0))) = (*cspan_at(&coefficients, row, INT64_C(0))) + (*cspan_at(&state, INT64_C(0)));
    (*cspan_at(&coefficients, row, INT64_C(1))) = (*cspan_at(&coefficients, row, INT64_C(1))) + (*cspan_at(&state, INT64_C(1)));
    factorial = 1.0;
    for (i = INT64_C(2); i < order + INT64_C(1); i += INT64_C(1))
    {
        factorial = factorial * i;
        if ((*cspan_at(&state, i)) != 0.0)
        {
            (*cspan_at(&coefficients, row, i)) = (*cspan_at(&coefficients, row, i)) + (*cspan_at(&state, i)) / factorial;
        }
    }
    (*cspan_at(&timing, row, INT64_C(0))) = (*cspan_at(&state, INT64_C(8)));
    (*cspan_at(&timing, row, INT64_C(1))) = duration;
    used = width;
    while((used > INT64_C(1)) && ((*cspan_at(&coefficients, row, used - INT64_C(1))) == 0.0))
    {
        used = used - INT64_C(1);
    }
    y = 0.0;
    v = 0.0;
    a = 0.0;
    jerk = 0.0;
    for (j = INT64_C(0); j < used; j += INT64_C(1))
    {
        i = used - INT64_C(1) - j;
        y = y * duration + (*cspan_at(&coefficients, row, i));
        if (i > INT64_C(0))
        {
            v = v * duration + i * (*cspan_at(&coefficients, row, i));
        }
        if (i > INT64_C(1))
        {
            a = a * duration + i * (i - INT64_C(1)) * (*cspan_at(&coefficients, row, i));
        }
        if (i > INT64_C(2))
        {
            jerk = jerk * duration + i * (i - INT64_C(1)) * (i - INT64_C(2)) * (*cspan_at(&coefficients, row, i));
        }
    }
    (*cspan_at(&state, INT64_C(0))) = y;
    (*cspan_at(&state, INT64_C(1))) = v;
    (*cspan_at(&state, INT64_C(2))) = a;
    (*cspan_at(&state, INT64_C(3))) = jerk;
    for (i = INT64_C(4); i < order; i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = evaluate_piece(coefficients, row, used, duration, i);
    }
    (*cspan_at(&state, INT64_C(8))) = (*cspan_at(&state, INT64_C(8))) + duration;
    return row + INT64_C(1);
}
static void clear_piece(array_double_2d coefficients, int64_t row)
{
    int64_t i;
    for (i = INT64_C(0); i < coefficients.shape[INT64_C(1)]; i += INT64_C(1))
    {
        (*cspan_at(&coefficients, row, i)) = 0.0;
    }
}
static void set_held(int64_t above, double level, array_double_1d state)
{
    int64_t i;
    (*cspan_at(&state, INT64_C(2) + above)) = level;
    for (i = INT64_C(3) + above; i < INT64_C(8); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = 0.0;
    }
}
static int64_t expand_plateau(array_double_1d phase, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work)
{
    array_double_1d state;
    array_double_1d lengths;
    array_double_1d peaks;
    double duration;
    double basis;
    double peak;
    int64_t first;
    int64_t boxes;
    double rise;
    int64_t level;
    double length;
    int64_t count;
    int64_t piece;
    double sign;
    int64_t held;
    int64_t i;
    state = span_row(&work, INT64_C(1));
    lengths = span_row(&work, INT64_C(2));
    peaks = span_row(&work, INT64_C(3));
    duration = (*cspan_at(&phase, INT64_C(0)));
    basis = (*cspan_at(&phase, INT64_C(1)));
    peak = (*cspan_at(&phase, INT64_C(3)));
    first = (int64_t)((*cspan_at(&phase, INT64_C(4))));
    boxes = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(1) - first;
    rise = basis;
    for (level = INT64_C(0); level < boxes; level += INT64_C(1))
    {
        held_peak(&length, &peak, &rise, level, first, rise, peak, duration / basis, axis);
        (*cspan_at(&lengths, level)) = length;
        (*cspan_at(&peaks, level)) = peak;
    }
    count = rise_pieces(boxes);
    for (piece = INT64_C(1); piece < count + INT64_C(1); piece += INT64_C(1))
    {
        held_level(&level, &sign, piece, boxes);
        held = INT64_C(3) + first + level;
        for (i = held; i < INT64_C(8); i += INT64_C(1))
        {
            (*cspan_at(&state, i)) = 0.0;
        }
        (*cspan_at(&state, held)) = sign * (*cspan_at(&peaks, level));
        if ((*cspan_at(&lengths, level)) > 0.0)
        {
            clear_piece(coefficients, row);
            row = append_piece((*cspan_at(&lengths, level)), timing, coefficients, row, state);
        }
    }
    return row;
}
static bool is_unnoticed(array_double_1d phase, double time, array_double_1d axis)
{
    bool result;
    if (((*cspan_at(&phase, INT64_C(4))) > 0.5) || ((*cspan_at(&phase, INT64_C(0))) > 1e-06 * time))
    {
        return 0;
    }
    result = fabs((*cspan_at(&phase, INT64_C(3)))) <= 1e-13 * (*cspan_at(&axis, INT64_C(3)));
    return result;
}
int64_t segfmu_expand_phases(array_double_2d phases, int64_t count, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work)
{
    array_double_1d psi;
    array_double_1d state;
    int64_t order;
    bool plateau;
    int64_t i;
    double a;
    double change;
    int64_t above;
    bool ramp;
    double duration;
    int64_t j;
    double scale;
    psi = span_row(&work, INT64_C(0));
    state = span_row(&work, INT64_C(1));
    order = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(2);
    plateau = (*cspan_at(&axis, INT64_C(14))) > 0.5;
    if (!plateau)
    {
        transition_coefficients(order, psi);
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        a = (*cspan_at(&phases, i, INT64_C(2)));
        change = (*cspan_at(&phases, i, INT64_C(3)));
        above = (int64_t)((*cspan_at(&phases, i, INT64_C(4))));
        set_held(above, a, state);
        ramp = (change != 0.0) && (!is_unnoticed(span_row(&phases, i), (*cspan_at(&state, INT64_C(8))), axis));
        if (plateau && ramp)
        {
            row = expand_plateau(span_row(&phases, i), axis, timing, coefficients, row, work);
        }
        else
        {
            duration = (*cspan_at(&phases, i, INT64_C(0)));
            clear_piece(coefficients, row);
            if (ramp)
            {
                for (j = order + INT64_C(1); j < INT64_C(2) * order + INT64_C(2); j += INT64_C(1))
                {
                    scale = change * (*cspan_at(&psi, j)) / ((j + 1.0) * (j + 2.0));
                    (*cspan_at(&coefficients, row, INT64_C(2) + j)) = scale / pow(duration, (double)(j));
                }
            }
            row = append_piece(duration, timing, coefficients, row, state);
        }
        set_held(above, a + change, state);
    }
    return row;
}
static double end_derivative(int64_t row, int64_t last, int64_t order, array_double_2d timing, array_double_2d coefficients)
{
    int64_t width;
    double length;
    double largest;
    double power;
    int64_t i;
    double start;
    double value;
    width = coefficients.shape[INT64_C(1)];
    length = (*cspan_at(&timing, row, INT64_C(1)));
    if ((row + INT64_C(1) < last) && (order <= span_floor_div(width, INT64_C(2))))
    {
        value = evaluate_piece(coefficients, row + INT64_C(1), width, 0.0, order);
        return value;
    }
    value = evaluate_piece(coefficients, row, width, length, order);
    largest = 0.0;
    power = 1.0;
    for (i = order; i < width; i += INT64_C(1))
    {
        start = evaluate_piece(coefficients, row, width, 0.0, i);
        largest = span_max(largest, fabs(start) * power);
        power = power * length / (i - order + INT64_C(1));
    }
    if ((order > INT64_C(0)) && (fabs(value) <= 1e-13 * largest))
    {
        return 0.0;
    }
    return value;
}
static void cut_piece(int64_t row, int64_t last, double local, array_double_2d timing, array_double_2d coefficients, array_double_2d cut_coefficients, int64_t target)
{
    int64_t width;
    double rest;
    double factorial;
    int64_t i;
    double value;
    int64_t j;
    int64_t order;
    double end;
    width = coefficients.shape[INT64_C(1)];
    rest = (*cspan_at(&timing, row, INT64_C(1))) - local;
    factorial = 1.0;
    for (i = INT64_C(0); i < width; i += INT64_C(1))
    {
        if (i > INT64_C(0))
        {
            factorial = factorial * i;
        }
        value = 0.0;
        if (rest > local)
        {
            value = evaluate_piece(coefficients, row, width, local, i);
        }
        else
        {
            for (j = INT64_C(0); j < width - i; j += INT64_C(1))
            {
                order = width - INT64_C(1) - j;
                end = end_derivative(row, last, order, timing, coefficients);
                value = end - value * rest / (order - i + INT64_C(1));
            }
        }
        (*cspan_at(&cut_coefficients, target, i)) = value / factorial;
    }
}
static void settle_end(bool moves, int64_t first, int64_t last, array_double_2d coefficients, array_double_2d cut_coefficients, int64_t target)
{
    double position;
    double velocity;
    double acceleration;
    double fastest;
    double steepest;
    int64_t row;
    position = (*cspan_at(&cut_coefficients, target, INT64_C(0)));
    velocity = (*cspan_at(&cut_coefficients, target, INT64_C(1)));
    acceleration = (*cspan_at(&cut_coefficients, target, INT64_C(2)));
    fastest = 0.0;
    steepest = 0.0;
    for (row = first; row < last; row += INT64_C(1))
    {
        fastest = span_max(fastest, fabs((*cspan_at(&coefficients, row, INT64_C(1)))));
        steepest = span_max(steepest, fabs((*cspan_at(&coefficients, row, INT64_C(2)))));
    }
    clear_piece(cut_coefficients, target);
    (*cspan_at(&cut_coefficients, target, INT64_C(0))) = position;
    if (moves && (fabs(velocity) > 1e-09 * fastest))
    {
        (*cspan_at(&cut_coefficients, target, INT64_C(1))) = velocity;
    }
    if (moves && (fabs(acceleration) > 1e-09 * steepest))
    {
        (*cspan_at(&cut_coefficients, target, INT64_C(2))) = acceleration;
    }
}
static void copy_piece(array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d target_timing, array_double_2d target_coefficients, int64_t target)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&target_timing, target, i)) = (*cspan_at(&timing, row, i));
    }
    for (i = INT64_C(0); i < coefficients.shape[INT64_C(1)]; i += INT64_C(1))
    {
        (*cspan_at(&target_coefficients, target, i)) = (*cspan_at(&coefficients, row, i));
    }
}
int64_t segfmu_cut_plan(double time, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d cut_timing, array_double_2d cut_coefficients, array_int64_t_1d cut_offsets)
{
    int64_t axis;
    int64_t last;
    int64_t row;
    double local;
    double start;
    double rest;
    double end;
    bool moves;
    int64_t target;
    target = INT64_C(0);
    for (axis = INT64_C(0); axis < offsets.shape[INT64_C(0)] - INT64_C(1); axis += INT64_C(1))
    {
        (*cspan_at(&cut_offsets, axis)) = target;
        last = (*cspan_at(&offsets, axis + INT64_C(1)));
        row = find_piece(time, timing, (*cspan_at(&offsets, axis)), last);
        local = span_max(local_time(time, timing, row), 0.0);
        start = 0.0;
        rest = (*cspan_at(&timing, row, INT64_C(1))) - local;
        cut_piece(row, last, local, timing, coefficients, cut_coefficients, target);
        if ((row == last - INT64_C(1)) && (rest <= 1e-15 * time))
        {
            end = (*cspan_at(&timing, row, INT64_C(0))) + (*cspan_at(&timing, row, INT64_C(1)));
            moves = time - end <= 1e-15 * time;
            settle_end(moves, (*cspan_at(&offsets, axis)), last, coefficients, cut_coefficients, target);
            rest = 0.0;
        }
        while(row < last)
        {
            (*cspan_at(&cut_timing, target, INT64_C(0))) = start;
            (*cspan_at(&cut_timing, target, INT64_C(1))) = rest;
            start = start + rest;
            target = target + INT64_C(1);
            row = row + INT64_C(1);
            if (row < last)
            {
                rest = (*cspan_at(&timing, row, INT64_C(1)));
                copy_piece(timing, coefficients, row, cut_timing, cut_coefficients, target);
            }
        }
    }
    (*cspan_at(&cut_offsets, offsets.shape[INT64_C(0)] - INT64_C(1))) = target;
    return target;
}
void segfmu_meet_ends(double clock, double dwell, array_double_2d timing, array_int64_t_1d offsets)
{
    double latest;
    int64_t axis;
    int64_t row;
    double late;
    int64_t longest;
    int64_t i;
    latest = 0.0;
    for (axis = INT64_C(0); axis < offsets.shape[INT64_C(0)] - INT64_C(1); axis += INT64_C(1))
    {
        row = (*cspan_at(&offsets, axis + INT64_C(1))) - INT64_C(1);
        latest = span_max(latest, (*cspan_at(&timing, row, INT64_C(0))) + (*cspan_at(&timing, row, INT64_C(1))));
    }
    for (axis = INT64_C(0); axis < offsets.shape[INT64_C(0)] - INT64_C(1); axis += INT64_C(1))
    {
        row = (*cspan_at(&offsets, axis + INT64_C(1))) - INT64_C(1);
        late = latest - ((*cspan_at(&timing, row, INT64_C(0))) + (*cspan_at(&timing, row, INT64_C(1))));
        if (late > 1e-12 * clock)
        {
            continue;
        }
        longest = row;
        if ((dwell > 0.0) && (row > (*cspan_at(&offsets, axis))))
        {
            longest = row - INT64_C(1);
        }
        for (i = (*cspan_at(&offsets, axis)); i < longest; i += INT64_C(1))
        {
            if ((*cspan_at(&timing, i, INT64_C(1))) > (*cspan_at(&timing, longest, INT64_C(1))))
            {
                longest = i;
            }
        }
        (*cspan_at(&timing, longest, INT64_C(1))) = (*cspan_at(&timing, longest, INT64_C(1))) + late;
        for (i = longest + INT64_C(1); i < row + INT64_C(1); i += INT64_C(1))
        {
            (*cspan_at(&timing, i, INT64_C(0))) = (*cspan_at(&timing, i, INT64_C(0))) + late;
        }
    }
}
static void add_power(double value, int64_t order, double before, array_double_2d coefficients, int64_t row)
{
    int64_t power;
    double term;
    int64_t i;
    for (power = INT64_C(0); power < order + INT64_C(1); power += INT64_C(1))
    {
        term = value;
        for (i = INT64_C(1); i < order - power + INT64_C(1); i += INT64_C(1))
        {
            term = (-term) * before / i;
        }
        for (i = INT64_C(1); i < power + INT64_C(1); i += INT64_C(1))
        {
            term = term / i;
        }
        (*cspan_at(&coefficients, row, power)) = (*cspan_at(&coefficients, row, power)) + term;
    }
}
void segfmu_anchor_plan(array_double_2d ends, array_double_2d limits, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets)
{
    int64_t width;
    int64_t axis;
    int64_t last;
    int64_t i;
    int64_t row;
    double length;
    int64_t j;
    int64_t order;
    double wanted;
    double rounding;
    int64_t repeat;
    double missed;
    width = coefficients.shape[INT64_C(1)];
    for (axis = INT64_C(0); axis < offsets.shape[INT64_C(0)] - INT64_C(1); axis += INT64_C(1))
    {
        last = (*cspan_at(&offsets, axis + INT64_C(1))) - INT64_C(1);
        for (i = INT64_C(0); i < (*cspan_at(&offsets, axis + INT64_C(1))) - (*cspan_at(&offsets, axis)); i += INT64_C(1))
        {
            row = last - i;
            length = (*cspan_at(&timing, row, INT64_C(1)));
            for (j = INT64_C(0); j < span_floor_div(width, INT64_C(2)) + INT64_C(1); j += INT64_C(1))
            {
                order = span_floor_div(width, INT64_C(2)) - j;
                wanted = 0.0;
                rounding = 0.0;
                if ((order > INT64_C(0)) && (order <= limits.shape[INT64_C(1)]))
                {
                    rounding = rounding_error(order, span_row(&limits, axis));
                }
                if (i > INT64_C(0))
                {
                    wanted = evaluate_piece(coefficients, row + INT64_C(1), width, 0.0, order);
                }
                else if (order < ends.shape[INT64_C(1)])
                {
                    wanted = (*cspan_at(&ends, axis, order));
                }
                for (repeat = INT64_C(0); repeat < INT64_C(2); repeat += INT64_C(1))
                {
                    missed = wanted - evaluate_piece(coefficients, row, width, length, order);
                    if (fabs(missed) > rounding)
                    {
                        add_power(missed, order, length, coefficients, row);
                    }
                }
            }
        }
    }
}
int64_t segfmu_join_plans(array_double_2d lead_timing, array_double_2d lead_coefficients, array_int64_t_1d lead_offsets, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d joined_timing, array_double_2d joined_coefficients, array_int64_t_1d joined_offsets)
{
    int64_t axis;
    int64_t row;
    int64_t target;
    target = INT64_C(0);
    for (axis = INT64_C(0); axis < offsets.shape[INT64_C(0)] - INT64_C(1); axis += INT64_C(1))
    {
        (*cspan_at(&joined_offsets, axis)) = target;
        for (row = (*cspan_at(&lead_offsets, axis)); row < (*cspan_at(&lead_offsets, axis + INT64_C(1))); row += INT64_C(1))
        {
            copy_piece(lead_timing, lead_coefficients, row, joined_timing, joined_coefficients, target);
            target = target + INT64_C(1);
        }
        for (row = (*cspan_at(&offsets, axis)); row < (*cspan_at(&offsets, axis + INT64_C(1))); row += INT64_C(1))
        {
            copy_piece(timing, coefficients, row, joined_timing, joined_coefficients, target);
            target = target + INT64_C(1);
        }
    }
    (*cspan_at(&joined_offsets, offsets.shape[INT64_C(0)] - INT64_C(1))) = target;
    return target;
}
static int64_t plan_pieces(int64_t slot, array_int64_t_1d offsets)
{
    int64_t result;
    result = (*cspan_at(&offsets, slot * INT64_C(4) + INT64_C(3))) - (*cspan_at(&offsets, slot * INT64_C(4)));
    return result;
}
static double plan_end(int64_t slot, int64_t axis, array_double_3d timing, array_int64_t_1d offsets)
{
    int64_t last;
    double result;
    last = (*cspan_at(&offsets, slot * INT64_C(4) + axis + INT64_C(1))) - INT64_C(1);
    result = (*cspan_at(&timing, slot, last, INT64_C(0))) + (*cspan_at(&timing, slot, last, INT64_C(1)));
    return result;
}
static void copy_plan(int64_t source, int64_t target, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    int64_t i;
    int64_t row;
    for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
    {
        (*cspan_at(&offsets, target * INT64_C(4) + i)) = (*cspan_at(&offsets, source * INT64_C(4) + i));
    }
    for (row = INT64_C(0); row < plan_pieces(source, offsets); row += INT64_C(1))
    {
        copy_piece(span_matrix(&timing, source), span_matrix(&coefficients, source), row, span_matrix(&timing, target), span_matrix(&coefficients, target), row);
    }
}
static bool has_room(int64_t slot, array_int64_t_1d offsets)
{
    bool result;
    result = plan_pieces(slot, offsets) <= INT64_C(1200);
    return result;
}
static void clear_plan(int64_t slot, array_int64_t_1d offsets)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
    {
        (*cspan_at(&offsets, slot * INT64_C(4) + i)) = INT64_C(0);
    }
}
static bool keeps_limits(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work)
{
    int64_t first;
    array_double_2d times;
    int64_t axis;
    int64_t i;
    int64_t j;
    bool result;
    first = INT64_C(4) * INT64_C(4);
    times = span_rows(&work, INT64_C(81), INT64_C(84));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < states.shape[INT64_C(2)]; i += INT64_C(1))
        {
            (*cspan_at(&states, INT64_C(0), axis, i)) = (*cspan_at(&operation, INT64_C(13) + axis, i));
            (*cspan_at(&states, INT64_C(1), axis, i)) = 0.0;
        }
        (*cspan_at(&states, INT64_C(1), axis, INT64_C(0))) = standstill(INT64_C(4), axis, timing, coefficients, offsets);
        (*cspan_at(&times, INT64_C(0), axis)) = 0.0;
        for (j = INT64_C(1); j < states.shape[INT64_C(0)] + INT64_C(1); j += INT64_C(1))
        {
            (*cspan_at(&times, j, axis)) = plan_end(INT64_C(4), axis, timing, offsets);
        }
    }
    result = segfmu_check_plan(states, times, span_matrix(&timing, INT64_C(4)), span_matrix(&coefficients, INT64_C(4)), span_part(&offsets, first, first + INT64_C(4)), limits, span_rows(&known, INT64_C(5), INT64_C(8)), 1e-09, 9.5e-10, span_rows(&lead, INT64_C(305), INT64_C(353))) == INT64_C(0);
    return result;
}
static int64_t prove_plan(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work, array_double_3d stack)
{
    int64_t first;
    array_int64_t_1d pieces;
    int64_t contact;
    first = INT64_C(4) * INT64_C(4);
    pieces = span_part(&offsets, first, first + INT64_C(4));
    if (!keeps_limits(operation, limits, known, timing, coefficients, offsets, states, lead, work))
    {
        return INT64_C(2);
    }
    if (segfmu_check_rope(span_matrix(&timing, INT64_C(4)), span_matrix(&coefficients, INT64_C(4)), pieces, span_row(&known, INT64_C(1)), span_rows(&work, INT64_C(0), INT64_C(52)), span_row(&work, INT64_C(80))) != INT64_C(0))
    {
        return INT64_C(3);
    }
    contact = segfmu_space_contact(span_matrix(&timing, INT64_C(4)), span_matrix(&coefficients, INT64_C(4)), pieces, span_row(&known, INT64_C(3)), span_rows(&known, INT64_C(8), INT64_C(24)), span_rows(&work, INT64_C(52), INT64_C(74)), span_rows(&work, INT64_C(0), INT64_C(52)), stack, span_rows(&work, INT64_C(74), INT64_C(80)), span_row(&work, INT64_C(80)));
    if (contact == INT64_C(3))
    {
        return INT64_C(4);
    }
    if (contact != INT64_C(0))
    {
        return INT64_C(5);
    }
    if (!segfmu_keeps_drives(span_matrix(&timing, INT64_C(4)), span_matrix(&coefficients, INT64_C(4)), pieces, known, work))
    {
        return INT64_C(6);
    }
    return INT64_C(0);
}
static double side_limit(int64_t order, double sign, array_double_1d axis)
{
    double result;
    if ((order <= INT64_C(2)) && (sign < 0.0))
    {
        result = (*cspan_at(&axis, INT64_C(9) + order - INT64_C(1)));
        return result;
    }
    result = (*cspan_at(&axis, INT64_C(2) + order - INT64_C(1)));
    return result;
}
static double own_side(int64_t order, double sign, array_double_1d axis)
{
    if ((sign < 0.0) && (fabs(side_limit(order, sign, axis) - side_limit(order, 1.0, axis)) > 0.0))
    {
        return 1.0;
    }
    return 0.0;
}
static void set_lower(array_double_1d lower, array_double_1d axis)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        if ((*cspan_at(&lower, i)) > 0.0)
        {
            (*cspan_at(&axis, INT64_C(9) + i)) = (*cspan_at(&lower, i));
        }
    }
}
static double fastest_velocity(array_double_1d axis)
{
    double result;
    result = span_max((*cspan_at(&axis, INT64_C(2))), (*cspan_at(&axis, INT64_C(9))));
    return result;
}
static double slowest_velocity(array_double_1d axis)
{
    double result;
    result = span_min((*cspan_at(&axis, INT64_C(2))), (*cspan_at(&axis, INT64_C(9))));
    return result;
}
static double top_acceleration(array_double_1d axis)
{
    double result;
    result = span_max((*cspan_at(&axis, INT64_C(3))), (*cspan_at(&axis, INT64_C(9) + INT64_C(1))));
    return result;
}
static bool is_beyond(double low, double high, double share, array_double_1d axis)
{
    bool result;
    result = (low < (-(*cspan_at(&axis, INT64_C(9)))) * share) || (high > (*cspan_at(&axis, INT64_C(2))) * share);
    return result;
}
static void exchange_sides(int64_t order, array_double_1d axis)
{
    double kept;
    kept = (*cspan_at(&axis, INT64_C(2) + order - INT64_C(1)));
    (*cspan_at(&axis, INT64_C(2) + order - INT64_C(1))) = (*cspan_at(&axis, INT64_C(9) + order - INT64_C(1)));
    (*cspan_at(&axis, INT64_C(9) + order - INT64_C(1))) = kept;
}
static void reverse_axis(array_double_1d axis)
{
    exchange_sides(INT64_C(2), axis);
}
static void mirror_axis(array_double_1d axis)
{
    exchange_sides(INT64_C(1), axis);
    exchange_sides(INT64_C(2), axis);
}
void segfmu_axis_limits(int64_t smoothness, int64_t shape, array_double_1d limits, array_double_1d axis)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(50); i += INT64_C(1))
    {
        (*cspan_at(&axis, i)) = 0.0;
    }
    (*cspan_at(&axis, INT64_C(0))) = smoothness;
    (*cspan_at(&axis, INT64_C(1))) = shape;
    for (i = INT64_C(0); i < smoothness + INT64_C(1); i += INT64_C(1))
    {
        (*cspan_at(&axis, INT64_C(2) + i)) = (*cspan_at(&limits, i));
    }
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&axis, INT64_C(9) + i)) = (*cspan_at(&limits, i));
    }
}
static double usual_share(array_double_1d axis)
{
    int64_t raised;
    raised = (int64_t)((*cspan_at(&axis, INT64_C(11))));
    if (((*cspan_at(&axis, INT64_C(0))) + raised == 4.0) && (raised < INT64_C(2)) && ((*cspan_at(&axis, INT64_C(4) + INT64_C(1) - raised)) > 0.0))
    {
        return 0.05;
    }
    return 0.1;
}
static double steeper_above(void)
{
    return 0.2;
}
static double moderate_share(void)
{
    return 0.02;
}
static double steepest_share(void)
{
    return 0.004;
}
static bool ramps_suffice(array_double_1d axis)
{
    bool result;
    result = (*cspan_at(&axis, INT64_C(21) + INT64_C(1))) == 0.0;
    return result;
}
static bool snap_is_last(array_double_1d axis)
{
    bool result;
    result = ((*cspan_at(&axis, INT64_C(26))) == 0.0) && ramps_suffice(axis);
    return result;
}
static double saving(array_double_1d axis)
{
    double result;
    result = 0.6 * (*cspan_at(&axis, INT64_C(26) + INT64_C(1)));
    return result;
}
static bool plateau_parameters(double share, array_double_1d axis)
{
    int64_t boxes;
    int64_t last;
    int64_t level;
    int64_t i;
    double limit;
    double rise;
    double slope;
    double time;
    double variance;
    double fourth;
    double jerk;
    boxes = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(1);
    (*cspan_at(&axis, INT64_C(14))) = 1.0;
    last = -INT64_C(1);
    for (level = INT64_C(0); level < boxes; level += INT64_C(1))
    {
        if ((*cspan_at(&axis, INT64_C(4) + level)) > 0.0)
        {
            last = level;
        }
    }
    if (last < INT64_C(0))
    {
        return 0;
    }
    (*cspan_at(&axis, INT64_C(38))) = span_min_int(span_floor_div((last + INT64_C(1)), INT64_C(2)), INT64_C(2));
    for (level = INT64_C(0); level < boxes - INT64_C(1); level += INT64_C(1))
    {
        if ((level > INT64_C(0)) || (last == INT64_C(0)))
        {
            (*cspan_at(&axis, INT64_C(26) + level)) = share;
            if (level > last)
            {
                (*cspan_at(&axis, INT64_C(26) + level)) = span_max(share, usual_share(axis));
            }
            if ((level + (*cspan_at(&axis, INT64_C(11))) == 2.0) && (last + (*cspan_at(&axis, INT64_C(11))) > 1.5))
            {
                (*cspan_at(&axis, INT64_C(26) + level)) = steeper_above() * share;
            }
        }
    }
    for (i = INT64_C(0); i < last; i += INT64_C(1))
    {
        level = last - INT64_C(1) - i;
        limit = (*cspan_at(&axis, INT64_C(4) + level));
        rise = 1e+60;
        if (limit > 0.0)
        {
            plateau_duration(&rise, &slope, limit, level + INT64_C(1), axis);
        }
        (*cspan_at(&axis, INT64_C(21) + level)) = rise;
    }
    if (last == INT64_C(1))
    {
        (*cspan_at(&axis, INT64_C(20))) = 0.25 * (*cspan_at(&axis, INT64_C(4) + INT64_C(1))) * (1.0 - (*cspan_at(&axis, INT64_C(26) + INT64_C(1))));
        (*cspan_at(&axis, INT64_C(19))) = 1.0 / (*cspan_at(&axis, INT64_C(20)));
    }
    if (last <= INT64_C(1))
    {
        time = 1.0;
        if (last == INT64_C(1))
        {
            time = (*cspan_at(&axis, INT64_C(21)));
        }
        rise_moments(&variance, &fourth, time, INT64_C(0), axis);
        (*cspan_at(&axis, INT64_C(36))) = variance / (time * time);
    }
    jerk = (*cspan_at(&axis, INT64_C(4)));
    if (jerk > 0.0)
    {
        rise = (*cspan_at(&axis, INT64_C(21)));
        (*cspan_at(&axis, INT64_C(15))) = jerk * rise;
        (*cspan_at(&axis, INT64_C(17))) = jerk * (1.0 - (*cspan_at(&axis, INT64_C(26))));
        (*cspan_at(&axis, INT64_C(16))) = 1.0 / (*cspan_at(&axis, INT64_C(17)));
        (*cspan_at(&axis, INT64_C(18))) = rise;
        if (rise > 0.0)
        {
            rise_moments(cspan_at(&axis, INT64_C(37)), &fourth, rise, INT64_C(1), axis);
        }
    }
    return 1;
}
static bool smoothstep_parameters(array_double_1d axis, array_double_1d psi, array_double_1d peaks)
{
    int64_t k;
    int64_t j;
    double limit;
    double slope;
    int64_t e;
    double change;
    bool bounded;
    k = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(2);
    bounded = 0;
    transition_peaks(k, psi, peaks);
    (*cspan_at(&axis, INT64_C(39))) = 2.0 * k + 2.0;
    for (j = INT64_C(0); j < INT64_C(2) * k + INT64_C(2); j += INT64_C(1))
    {
        (*cspan_at(&axis, INT64_C(40) + j)) = (*cspan_at(&psi, j));
    }
    (*cspan_at(&axis, INT64_C(36))) = 1.0 / (4.0 * (INT64_C(2) * k + INT64_C(3)));
    for (j = INT64_C(1); j < k + INT64_C(2); j += INT64_C(1))
    {
        limit = (*cspan_at(&axis, INT64_C(4) + j - INT64_C(1)));
        if (limit > 0.0)
        {
            (*cspan_at(&axis, INT64_C(31) + j - INT64_C(1))) = (*cspan_at(&peaks, j)) / limit;
            bounded = 1;
        }
    }
    slope = (*cspan_at(&axis, INT64_C(31)));
    if (slope > 0.0)
    {
        (*cspan_at(&axis, INT64_C(15))) = 0.0;
        (*cspan_at(&axis, INT64_C(16))) = slope;
        (*cspan_at(&axis, INT64_C(17))) = 1.0 / slope;
        for (e = INT64_C(2); e < k + INT64_C(2); e += INT64_C(1))
        {
            change = pow(((*cspan_at(&axis, INT64_C(31) + e - INT64_C(1))) / pow(slope, (double)(e))), (1.0 / (e - INT64_C(1))));
            (*cspan_at(&axis, INT64_C(15))) = span_max((*cspan_at(&axis, INT64_C(15))), change);
        }
    }
    return bounded;
}
bool segfmu_ramp_parameters(double share, array_double_1d axis, array_double_2d work)
{
    int64_t i;
    double duration;
    double slope;
    bool bounded;
    for (i = INT64_C(13); i < INT64_C(50); i += INT64_C(1))
    {
        (*cspan_at(&axis, i)) = 0.0;
    }
    (*cspan_at(&axis, INT64_C(15))) = 1e+300;
    bounded = 0;
    if ((int64_t)((*cspan_at(&axis, INT64_C(1)))) == INT64_C(1))
    {
        bounded = plateau_parameters(share, axis);
    }
    else
    {
        bounded = smoothstep_parameters(axis, span_row(&work, INT64_C(0)), span_row(&work, INT64_C(1)));
    }
    if (bounded)
    {
        segfmu_ramp_duration(&duration, &slope, top_acceleration(axis), axis);
        (*cspan_at(&axis, INT64_C(13))) = duration;
    }
    return bounded;
}
static double shortest_scale(int64_t order, array_double_1d limits)
{
    int64_t below;
    double scale;
    scale = (*cspan_at(&limits, order - INT64_C(1))) / (*cspan_at(&limits, order));
    for (below = INT64_C(1); below < order - INT64_C(1); below += INT64_C(1))
    {
        scale = span_min(scale, pow(((*cspan_at(&limits, below)) / (*cspan_at(&limits, order))), (1.0 / (order - below))));
    }
    return scale;
}
static double natural_limit(int64_t order, double steep, array_double_1d axis, array_double_1d limits)
{
    double below;
    int64_t highest;
    int64_t top;
    int64_t above;
    double bound;
    int64_t given;
    double growth;
    double result;
    below = (*cspan_at(&limits, order - INT64_C(1)));
    highest = (int64_t)((*cspan_at(&axis, INT64_C(0)))) + INT64_C(1);
    top = INT64_C(2);
    for (above = order + INT64_C(1); above < highest + INT64_C(1); above += INT64_C(1))
    {
        bound = (*cspan_at(&axis, INT64_C(2) + above - INT64_C(1)));
        if (bound > 0.0)
        {
            return 2.0 * below * pow((bound / below), (1.0 / (above - order + INT64_C(1))));
        }
    }
    for (given = INT64_C(3); given < order; given += INT64_C(1))
    {
        if ((*cspan_at(&axis, INT64_C(2) + given - INT64_C(1))) > 0.0)
        {
            top = given;
        }
    }
    growth = pow(steep, (1.0 / (highest - top))) / usual_share(axis);
    result = growth * below / shortest_scale(order - INT64_C(1), limits);
    return result;
}
static void chain_limits(double steep, array_double_1d axis, array_double_1d state, array_double_1d limits)
{
    int64_t smoothness;
    int64_t order;
    double bound;
    double room;
    double needed;
    smoothness = (int64_t)((*cspan_at(&axis, INT64_C(0))));
    for (order = INT64_C(1); order < smoothness + INT64_C(2); order += INT64_C(1))
    {
        (*cspan_at(&limits, order)) = (*cspan_at(&axis, INT64_C(2) + order - INT64_C(1)));
        if ((*cspan_at(&limits, order)) <= 0.0)
        {
            bound = natural_limit(order, steep, axis, limits);
            if (order <= smoothness)
            {
                bound = span_max(bound, 2.0 * fabs((*cspan_at(&state, order))));
            }
            room = (*cspan_at(&limits, order - INT64_C(2))) - fabs((*cspan_at(&state, order - INT64_C(2))));
            needed = (*cspan_at(&state, order - INT64_C(1))) * (*cspan_at(&state, order - INT64_C(1)));
            if (needed > room * bound)
            {
                bound = span_max(bound, span_min(needed / span_max(room, 1e-300), 10000.0 * bound));
            }
            (*cspan_at(&limits, order)) = bound;
        }
    }
}
static void set_chains(double steep, array_double_1d axis, array_double_1d limits, array_double_2d chains)
{
    int64_t smoothness;
    int64_t order;
    array_double_1d chain;
    int64_t i;
    smoothness = (int64_t)((*cspan_at(&axis, INT64_C(0))));
    for (order = INT64_C(0); order < smoothness - INT64_C(1); order += INT64_C(1))
    {
        chain = span_row(&chains, order);
        for (i = INT64_C(0); i < INT64_C(50); i += INT64_C(1))
        {
            (*cspan_at(&chain, i)) = 0.0;
        }
        (*cspan_at(&chain, INT64_C(0))) = smoothness - order;
        (*cspan_at(&chain, INT64_C(1))) = INT64_C(1);
        (*cspan_at(&chain, INT64_C(11))) = order;
        for (i = INT64_C(0); i < smoothness - order + INT64_C(1); i += INT64_C(1))
        {
            (*cspan_at(&chain, INT64_C(2) + i)) = (*cspan_at(&axis, INT64_C(2) + order + i));
            if (i <= INT64_C(2))
            {
                (*cspan_at(&chain, INT64_C(2) + i)) = (*cspan_at(&limits, order + INT64_C(1) + i));
            }
        }
        (*cspan_at(&chain, INT64_C(9))) = (*cspan_at(&chain, INT64_C(2)));
        (*cspan_at(&chain, INT64_C(9) + INT64_C(1))) = (*cspan_at(&chain, INT64_C(3)));
        if (order == INT64_C(0))
        {
            (*cspan_at(&chain, INT64_C(9))) = (*cspan_at(&axis, INT64_C(9)));
            (*cspan_at(&chain, INT64_C(9) + INT64_C(1))) = (*cspan_at(&axis, INT64_C(9) + INT64_C(1)));
        }
        else if (order == INT64_C(1))
        {
            (*cspan_at(&chain, INT64_C(9))) = (*cspan_at(&axis, INT64_C(9) + INT64_C(1)));
        }
        segfmu_ramp_parameters(usual_share(chain) / span_min(steep, 10.0), chain, span_rows(&chains, smoothness - INT64_C(1), smoothness + INT64_C(1)));
    }
}
static void lift_pieces(int64_t order, int64_t first, int64_t last, array_double_1d state, array_double_2d timing, array_double_2d coefficients)
{
    int64_t width;
    int64_t row;
    int64_t j;
    int64_t i;
    double value;
    int64_t m;
    double factorial;
    double length;
    width = coefficients.shape[INT64_C(1)];
    for (row = first; row < last; row += INT64_C(1))
    {
        for (j = INT64_C(0); j < width - order; j += INT64_C(1))
        {
            i = width - INT64_C(1) - j;
            value = (*cspan_at(&coefficients, row, i - order));
            for (m = INT64_C(0); m < order; m += INT64_C(1))
            {
                value = value / (i - m);
            }
            (*cspan_at(&coefficients, row, i)) = value;
        }
        factorial = 1.0;
        for (i = INT64_C(0); i < order; i += INT64_C(1))
        {
            if (i > INT64_C(0))
            {
                factorial = factorial * i;
            }
            (*cspan_at(&coefficients, row, i)) = (*cspan_at(&state, i)) / factorial;
        }
        for (i = INT64_C(0); i < order; i += INT64_C(1))
        {
            length = (*cspan_at(&timing, row, INT64_C(1)));
            (*cspan_at(&state, i)) = evaluate_piece(coefficients, row, width, length, i);
        }
    }
}
static bool set_box(double steep, int64_t loose, array_double_1d limits, array_double_2d lead)
{
    int64_t smoothness;
    array_double_1d axis;
    array_double_1d state;
    int64_t i;
    smoothness = limits.shape[INT64_C(0)] - INT64_C(1);
    axis = span_row(&lead, INT64_C(52));
    state = span_row(&lead, INT64_C(8));
    segfmu_axis_limits(smoothness, INT64_C(1), limits, axis);
    set_lower(span_row(&lead, INT64_C(53)), axis);
    for (i = loose; i < smoothness + INT64_C(1); i += INT64_C(1))
    {
        if ((*cspan_at(&limits, i - INT64_C(1))) > 0.0)
        {
            (*cspan_at(&axis, INT64_C(2) + i - INT64_C(1))) = span_max((*cspan_at(&limits, i - INT64_C(1))), fabs((*cspan_at(&lead, INT64_C(0), i))));
        }
    }
    if (!segfmu_ramp_parameters(usual_share(axis), axis, span_rows(&lead, INT64_C(54), INT64_C(61))))
    {
        return 0;
    }
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = 0.0;
    }
    for (i = INT64_C(1); i < smoothness + INT64_C(1); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(12), i)) = rounding_error(i, limits);
        if ((*cspan_at(&limits, i - INT64_C(1))) <= 0.0)
        {
            (*cspan_at(&state, i)) = (*cspan_at(&lead, INT64_C(0), i));
        }
    }
    chain_limits(steep, axis, state, span_row(&lead, INT64_C(11)));
    set_chains(steep, axis, span_row(&lead, INT64_C(11)), span_rows(&lead, INT64_C(54), INT64_C(61)));
    for (i = INT64_C(1); i < smoothness + INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(4), i)) = -(*cspan_at(&lead, INT64_C(11), i));
        if (i <= INT64_C(2))
        {
            (*cspan_at(&lead, INT64_C(4), i)) = -(*cspan_at(&axis, INT64_C(9) + i - INT64_C(1)));
        }
        (*cspan_at(&lead, INT64_C(5), i)) = (*cspan_at(&lead, INT64_C(11), i));
    }
    return 1;
}
static double lower_limit(int64_t order, array_double_1d limits, array_double_2d lead)
{
    double result;
    if ((order <= INT64_C(2)) && ((*cspan_at(&lead, INT64_C(53), order - INT64_C(1))) > 0.0))
    {
        result = (*cspan_at(&lead, INT64_C(53), order - INT64_C(1)));
        return result;
    }
    result = (*cspan_at(&limits, order - INT64_C(1)));
    return result;
}
static bool is_outside(array_double_1d limits, array_double_2d lead)
{
    int64_t i;
    double value;
    double bound;
    for (i = INT64_C(1); i < limits.shape[INT64_C(0)]; i += INT64_C(1))
    {
        value = (*cspan_at(&lead, INT64_C(0), i));
        bound = (*cspan_at(&limits, i - INT64_C(1)));
        if (value < 0.0)
        {
            bound = lower_limit(i, limits, lead);
        }
        if ((bound > 0.0) && (fabs(value) > bound * (1.0 + 1e-12)))
        {
            return 1;
        }
    }
    return 0;
}
static int64_t level_gain(double* result_0, double* result_1_0001, double level, double a, double b, array_double_1d axis)
{
    double first;
    double slope;
    double last;
    segfmu_ramp_duration(&first, &slope, level - a, axis);
    segfmu_ramp_duration(&last, &slope, level - b, axis);
    (*result_0) = first;
    (*result_1_0001) = 0.5 * (a + level) * first + 0.5 * (level + b) * last;
    return 0;
}
static double linear_level(double gain, double a, double b, array_double_1d axis)
{
    double slope;
    double half;
    double rest;
    double square;
    slope = (*cspan_at(&axis, INT64_C(16)));
    half = 0.5 * (*cspan_at(&axis, INT64_C(18)));
    rest = gain + 0.5 * slope * (a * a + b * b) - half * (a + b);
    square = half * half + slope * rest;
    if (square <= 0.0)
    {
        return -1.0;
    }
    return rest / (half + sqrt(square));
}
static int64_t root_level(double* result_0_0001, double* result_1, double gain, double a, double b, double lower, double upper, double start, array_double_1d axis)
{
    double t;
    double level;
    double t_before;
    double rate_before;
    int64_t i;
    double change;
    double growth;
    double t_end;
    double slope;
    double first;
    double second;
    double error;
    double rate;
    double following;
    double newton;
    double near;
    double bend;
    double reached;
    bool far;
    t = start;
    level = a;
    t_before = start;
    rate_before = 0.0;
    for (i = INT64_C(0); i < INT64_C(100); i += INT64_C(1))
    {
        ramp_change(&change, &growth, t, axis);
        level = a + change;
        segfmu_ramp_duration(&t_end, &slope, level - b, axis);
        first = 0.5 * (a + level) * t;
        second = 0.5 * (level + b) * t_end;
        error = first + second - gain;
        if (fabs(error) <= 2e-16 * (fabs(first) + fabs(second)))
        {
            (*result_0_0001) = t;
            (*result_1) = level;
            return 0;
        }
        if (error > 0.0)
        {
            upper = t;
        }
        else
        {
            lower = t;
        }
        rate = 0.5 * (a + level) + 0.5 * growth * (t + t_end + (level + b) * slope);
        following = 0.5 * (lower + upper);
        if (rate > 0.0)
        {
            newton = t - error / rate;
            near = 1e-09 * t;
            bend = 0.0;
            if (i > INT64_C(0))
            {
                bend = 0.5 * error / rate * (rate - rate_before) / (t - t_before);
            }
            if ((bend != 0.0) && (fabs(bend) < 0.5 * rate))
            {
                newton = t - error / (rate - bend);
                near = 1e-07 * t;
            }
            if (fabs(newton - t) <= near)
            {
                ramp_change(&change, &growth, newton, axis);
                (*result_0_0001) = newton;
                (*result_1) = a + change;
                return 0;
            }
            reached = first + second;
            far = (reached > 0.0) && (gain > 0.0) && ((reached > 2.0 * gain) || (gain > 2.0 * reached));
            if (far && (reached < 60.0 * t * rate))
            {
                newton = t * pow((gain / reached), (reached / (t * rate)));
                if (span_floor_mod(i, INT64_C(3)) == INT64_C(2))
                {
                    newton = sqrt(span_max(lower, 0.001 * upper) * upper);
                }
            }
            if ((newton > lower) && (newton < upper))
            {
                following = newton;
            }
        }
        if (fabs(following - t) <= 4e-16 * t)
        {
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
static int64_t solve_level(double* result_0_0001, double* result_1_0001, double* result_2_0001, double gain, double a, double b, double low, double high, double near, array_double_1d axis)
{
    double linear_from;
    double level;
    double t;
    double t_high;
    double most;
    double t_low;
    double least;
    double start;
    linear_from = (*cspan_at(&axis, INT64_C(15)));
    if (span_max(a, b) + linear_from <= high)
    {
        level = linear_level(gain, a, b, axis);
        if ((level >= span_max(a, b) + linear_from) && (level >= low) && (level <= high))
        {
            t = (level - a) * (*cspan_at(&axis, INT64_C(16))) + (*cspan_at(&axis, INT64_C(18)));
            (*result_0_0001) = t;
            (*result_1_0001) = 0.0;
            (*result_2_0001) = level;
            return 0;
        }
    }
    level_gain(&t_high, &most, high, a, b, axis);
    if (gain > most)
    {
        (*result_0_0001) = t_high;
        (*result_1_0001) = (gain - most) / high;
        (*result_2_0001) = high;
        return 0;
    }
    level_gain(&t_low, &least, low, a, b, axis);
    if (gain <= least)
    {
        if (gain < least - 1e-14 * (fabs(gain) + fabs(least)))
        {
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
    if ((start <= t_low) || (start >= t_high))
    {
        start = t_low + (t_high - t_low) * sqrt((gain - least) / (most - least));
    }
    root_level(&t, &level, gain, a, b, t_low, t_high, start, axis);
    (*result_0_0001) = t;
    (*result_1_0001) = 0.0;
    (*result_2_0001) = level;
    return 0;
}
static int64_t member_distance(double* result_0_0001, double* result_1, array_double_1d family, array_double_1d axis)
{
    double v;
    double a;
    double b;
    double t1;
    double hold1;
    double level1;
    double hold2;
    double level2;
    double t3;
    double basis;
    double slope;
    double t2;
    double y;
    v = (*cspan_at(&family, INT64_C(0)));
    a = (*cspan_at(&family, INT64_C(1)));
    b = (*cspan_at(&family, INT64_C(3)));
    t1 = (*cspan_at(&family, INT64_C(27)));
    hold1 = (*cspan_at(&family, INT64_C(28)));
    level1 = (*cspan_at(&family, INT64_C(29)));
    hold2 = (*cspan_at(&family, INT64_C(30)));
    level2 = (*cspan_at(&family, INT64_C(31)));
    t3 = (*cspan_at(&family, INT64_C(32)));
    segfmu_ramp_duration(&basis, &slope, fabs(level2 - level1), axis);
    t2 = basis * (*cspan_at(&family, INT64_C(33)));
    basis = basis + (*cspan_at(&family, INT64_C(34))) * (t2 - basis);
    if ((*cspan_at(&family, INT64_C(15))) > 0.5)
    {
        (*result_0_0001) = t1 + hold1 + t2 + hold2 + t3;
        (*result_1) = 0.0;
        return 0;
    }
    y = ramp_distance(v, a, level1, t1, t1, axis);
    v = v + 0.5 * (a + level1) * t1;
    if (hold1 > 0.0)
    {
        y = y + (v + 0.5 * level1 * hold1) * hold1;
        v = v + level1 * hold1;
    }
    y = y + ramp_distance(v, level1, level2, t2, basis, axis);
    v = v + 0.5 * (level1 + level2) * t2;
    if (hold2 > 0.0)
    {
        y = y + (v + 0.5 * level2 * hold2) * hold2;
        v = v + level2 * hold2;
    }
    y = y + ramp_distance(v, level2, b, t3, t3, axis);
    (*result_0_0001) = t1 + hold1 + t2 + hold2 + t3;
    (*result_1) = y;
    return 0;
}
static int64_t second_level(double* result_0, double* result_1, double* result_2, double* result_3, double p, array_double_1d family, array_double_1d axis)
{
    double b;
    double last_ramp;
    double hold;
    double t;
    double level;
    double change;
    double slope;
    double gain;
    b = (*cspan_at(&family, INT64_C(3)));
    last_ramp = (*cspan_at(&family, INT64_C(7)));
    hold = 0.0;
    t = p;
    if (p >= last_ramp)
    {
        t = last_ramp;
        hold = p - last_ramp;
        level = -(*cspan_at(&family, INT64_C(5)));
    }
    else
    {
        ramp_change(&change, &slope, p, axis);
        level = b - change;
    }
    gain = (*cspan_at(&family, INT64_C(2))) - (*cspan_at(&family, INT64_C(0))) - 0.5 * (level + b) * t - level * hold;
    (*result_0) = level;
    (*result_1) = t;
    (*result_2) = hold;
    (*result_3) = gain;
    return 0;
}
static bool has_member(double p, array_double_1d family, array_double_1d axis)
{
    double a;
    double level;
    double t;
    double hold;
    double gain;
    double first;
    double least;
    a = (*cspan_at(&family, INT64_C(1)));
    second_level(&level, &t, &hold, &gain, p, family, axis);
    level_gain(&first, &least, span_max(0.0, span_max(a, level)), a, level, axis);
    return gain >= least;
}
static int64_t canonical_member(double* result_0, double* result_1, double p, array_double_1d family, array_double_1d axis)
{
    double a;
    double level2;
    double t3;
    double hold2;
    double gain;
    double low;
    double near;
    double t1;
    double hold1;
    double level1;
    a = (*cspan_at(&family, INT64_C(1)));
    second_level(&level2, &t3, &hold2, &gain, p, family, axis);
    low = span_max(0.0, span_max(a, level2));
    near = (*cspan_at(&family, INT64_C(27)));
    solve_level(&t1, &hold1, &level1, gain, a, level2, low, (*cspan_at(&family, INT64_C(6))), near, axis);
    if (hold1 < 0.0)
    {
        (*result_0) = -1.0;
        (*result_1) = 0.0;
        return 0;
    }
    (*cspan_at(&family, INT64_C(27))) = t1;
    (*cspan_at(&family, INT64_C(28))) = hold1;
    (*cspan_at(&family, INT64_C(29))) = level1;
    (*cspan_at(&family, INT64_C(30))) = hold2;
    (*cspan_at(&family, INT64_C(31))) = level2;
    (*cspan_at(&family, INT64_C(32))) = t3;
    member_distance(result_0, result_1, family, axis);
    return 0;
}
static int64_t curved_part(double* result_0, double* result_1, double* result_2_0001, double s, array_double_1d axis)
{
    int64_t count;
    double value;
    double slope;
    double integral;
    int64_t j;
    int64_t i;
    count = (int64_t)((*cspan_at(&axis, INT64_C(39))));
    value = 0.0;
    slope = 0.0;
    integral = 0.0;
    for (j = INT64_C(0); j < count; j += INT64_C(1))
    {
        i = count - INT64_C(1) - j;
        value = value * s + (*cspan_at(&axis, INT64_C(40) + i));
        integral = integral * s + (*cspan_at(&axis, INT64_C(40) + i)) / (i + 1.0);
        if (i > INT64_C(0))
        {
            slope = slope * s + i * (*cspan_at(&axis, INT64_C(40) + i));
        }
    }
    (*result_0) = value;
    (*result_1) = slope;
    (*result_2_0001) = integral * s;
    return 0;
}
static double invert_curved_part(double value, double upper, array_double_1d axis)
{
    double low;
    double high;
    int64_t i;
    double at;
    double slope;
    double integral;
    double step;
    double newton;
    double s;
    low = 0.0;
    high = upper;
    s = upper * sqrt(span_min(span_max(2.0 * value, 0.0), 1.0));
    for (i = INT64_C(0); i < INT64_C(100); i += INT64_C(1))
    {
        curved_part(&at, &slope, &integral, s, axis);
        if (at > value)
        {
            high = s;
        }
        else
        {
            low = s;
        }
        step = 0.5 * (low + high) - s;
        if (slope > 0.0)
        {
            newton = (value - at) / slope;
            if ((s + newton > low) && (s + newton < high))
            {
                step = newton;
            }
        }
        s = s + step;
        if (fabs(step) <= 1e-09)
        {
            return s;
        }
    }
    return s;
}
static double extreme_gain(double a, double b, double duration, double basis, array_double_1d axis)
{
    double smaller;
    double slowness;
    smaller = span_min(fabs(a), fabs(b));
    if ((*cspan_at(&axis, INT64_C(14))) < 0.5)
    {
        return 0.5 * smaller * duration;
    }
    slowness = (basis - inner_rise(basis, INT64_C(0), axis)) * (duration / basis) / fabs(b - a);
    return 0.5 * smaller * (duration + (smaller - fabs(b - a)) * slowness);
}
static double taylor(double t, double first, double second, double third, double fourth, double fifth)
{
    return t * (first + t / 2.0 * (second + t / 3.0 * (third + t / 4.0 * (fourth + t / 5.0 * fifth))));
}
static double crossing_time(double a, double length, double jerk, double snap, double crackle, double pop, double highest)
{
    double low;
    double high;
    int64_t i;
    double at;
    double slope;
    double step;
    double newton;
    double t;
    low = 0.0;
    high = length;
    t = 0.5 * length;
    for (i = INT64_C(0); i < INT64_C(100); i += INT64_C(1))
    {
        at = a + taylor(t, jerk, snap, crackle, pop, highest);
        if (at * a <= 0.0)
        {
            high = t;
        }
        else
        {
            low = t;
        }
        slope = jerk + taylor(t, snap, crackle, pop, highest, 0.0);
        step = 0.5 * (low + high) - t;
        if (slope * a < 0.0)
        {
            newton = (-at) / slope;
            if ((t + newton > low) && (t + newton < high))
            {
                step = newton;
            }
        }
        t = t + step;
        if (fabs(step) <= 1e-07 * length)
        {
            break;
        }
    }
    return t;
}
static double plateau_extreme_velocity(double v, double a, double change, double duration, double basis, array_double_1d axis)
{
    int64_t boxes;
    double jerk;
    double snap;
    double crackle;
    double pop;
    double highest;
    int64_t pieces;
    int64_t piece;
    int64_t level;
    double sign;
    double length;
    double peak;
    double end;
    double gain;
    bool crossed;
    boxes = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(1);
    jerk = 0.0;
    snap = 0.0;
    crackle = 0.0;
    pop = 0.0;
    highest = 0.0;
    pieces = rise_pieces(boxes);
    for (piece = INT64_C(1); piece < pieces + INT64_C(1); piece += INT64_C(1))
    {
        held_level(&level, &sign, piece, boxes);
        piece_peak(&length, &peak, level, INT64_C(0), change, duration, basis, axis);
        if (level == INT64_C(0))
        {
            jerk = sign * peak;
            snap = 0.0;
            crackle = 0.0;
            pop = 0.0;
            highest = 0.0;
        }
        else if (level == INT64_C(1))
        {
            snap = sign * peak;
            crackle = 0.0;
            pop = 0.0;
            highest = 0.0;
        }
        else if (level == INT64_C(2))
        {
            crackle = sign * peak;
            pop = 0.0;
            highest = 0.0;
        }
        else if (level == INT64_C(3))
        {
            pop = sign * peak;
            highest = 0.0;
        }
        else
        {
            highest = sign * peak;
        }
        end = length;
        gain = taylor(end, jerk, snap, crackle, pop, highest);
        crossed = (a + gain) * change >= 0.0;
        if (crossed)
        {
            end = crossing_time(a, length, jerk, snap, crackle, pop, highest);
        }
        v = v + end * a;
        v = v + end * taylor(end, jerk / 2.0, snap / 3.0, crackle / 4.0, pop / 5.0, highest / 6.0);
        if (crossed)
        {
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
static double ramp_extreme_velocity(double v, double a, double b, double duration, double basis, array_double_1d axis)
{
    double start;
    double first;
    double change;
    double s;
    double value;
    double slope;
    double integral;
    double result;
    start = v;
    first = a;
    change = b - a;
    if (fabs(a) > fabs(b))
    {
        start = v + 0.5 * (a + b) * duration;
        first = -b;
    }
    if ((*cspan_at(&axis, INT64_C(14))) > 0.5)
    {
        result = plateau_extreme_velocity(start, first, change, duration, basis, axis);
        return result;
    }
    if ((*cspan_at(&axis, INT64_C(39))) == 2.0)
    {
        return start - 0.5 * first * first * duration / change;
    }
    s = invert_curved_part((-first) / change, 0.5, axis);
    curved_part(&value, &slope, &integral, s, axis);
    return start + duration * (first * s + change * integral);
}
static double flush_tiny(double value, double scale)
{
    if (fabs(value) <= 1e-30 * scale)
    {
        return 0.0;
    }
    return value;
}
static double boundary_value(double value, double lower, double upper)
{
    return span_min(span_max(flush_tiny(value, span_max(lower, upper)), -lower), upper);
}
static int64_t append_phase(array_double_2d phases, int64_t count, double duration, double basis, double start, double change, double above)
{
    if (duration <= 0.0)
    {
        return count;
    }
    (*cspan_at(&phases, count, INT64_C(0))) = duration;
    (*cspan_at(&phases, count, INT64_C(1))) = basis;
    (*cspan_at(&phases, count, INT64_C(2))) = start;
    (*cspan_at(&phases, count, INT64_C(3))) = change;
    (*cspan_at(&phases, count, INT64_C(4))) = above;
    return count + INT64_C(1);
}
static int64_t append_ramp(array_double_2d phases, int64_t count, double a, double b, double duration, array_double_1d axis)
{
    double change;
    double slope;
    int64_t result;
    if (duration <= 0.0)
    {
        return count;
    }
    ramp_change(&change, &slope, duration, axis);
    if (b < a)
    {
        change = -change;
    }
    result = append_phase(phases, count, duration, duration, a, change, 0.0);
    return result;
}
static int64_t append_change(array_double_2d phases, int64_t count, double a, double b, array_double_1d axis)
{
    double duration;
    double slope;
    int64_t result;
    segfmu_ramp_duration(&duration, &slope, fabs(b - a), axis);
    result = append_phase(phases, count, duration, duration, a, b - a, 0.0);
    return result;
}
static int64_t append_hold(array_double_2d phases, int64_t count, double a, double duration)
{
    int64_t result;
    result = append_phase(phases, count, duration, 0.0, a, 0.0, 0.0);
    return result;
}
static int64_t insert_hold(array_double_2d phases, int64_t count, int64_t row, double a, double duration)
{
    int64_t j;
    int64_t i;
    int64_t column;
    if (duration <= 0.0)
    {
        return count;
    }
    for (j = INT64_C(0); j < count - row; j += INT64_C(1))
    {
        i = count - INT64_C(1) - j;
        for (column = INT64_C(0); column < INT64_C(5); column += INT64_C(1))
        {
            (*cspan_at(&phases, i + INT64_C(1), column)) = (*cspan_at(&phases, i, column));
        }
    }
    append_hold(phases, row, a, duration);
    return count + INT64_C(1);
}
static void copy_phases(array_double_2d source, array_double_2d target, int64_t count)
{
    int64_t i;
    int64_t column;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        for (column = INT64_C(0); column < INT64_C(5); column += INT64_C(1))
        {
            (*cspan_at(&target, i, column)) = (*cspan_at(&source, i, column));
        }
    }
}
static int64_t join_phases(array_double_2d source, int64_t count, array_double_2d phases, int64_t used)
{
    int64_t i;
    int64_t column;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        for (column = INT64_C(0); column < INT64_C(5); column += INT64_C(1))
        {
            (*cspan_at(&phases, used + i, column)) = (*cspan_at(&source, i, column));
        }
    }
    return used + count;
}
static void mirror_phases(array_double_2d phases, int64_t count)
{
    int64_t i;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&phases, i, INT64_C(2))) = -(*cspan_at(&phases, i, INT64_C(2)));
        (*cspan_at(&phases, i, INT64_C(3))) = -(*cspan_at(&phases, i, INT64_C(3)));
    }
}
static void swap_entries(array_double_2d phases, int64_t i, int64_t j, int64_t column)
{
    double kept;
    kept = (*cspan_at(&phases, i, column));
    (*cspan_at(&phases, i, column)) = (*cspan_at(&phases, j, column));
    (*cspan_at(&phases, j, column)) = kept;
}
static void reverse_phases(array_double_2d phases, int64_t first, int64_t count)
{
    int64_t i;
    int64_t column;
    double end;
    for (i = INT64_C(0); i < span_floor_div((count - first), INT64_C(2)); i += INT64_C(1))
    {
        for (column = INT64_C(0); column < INT64_C(5); column += INT64_C(1))
        {
            swap_entries(phases, first + i, count - INT64_C(1) - i, column);
        }
    }
    for (i = first; i < count; i += INT64_C(1))
    {
        end = (*cspan_at(&phases, i, INT64_C(2))) + (*cspan_at(&phases, i, INT64_C(3)));
        (*cspan_at(&phases, i, INT64_C(2))) = -end;
        if ((*cspan_at(&phases, i, INT64_C(4))) == 1.0)
        {
            (*cspan_at(&phases, i, INT64_C(2))) = end;
            (*cspan_at(&phases, i, INT64_C(3))) = -(*cspan_at(&phases, i, INT64_C(3)));
        }
    }
}
static void reverse_problem(array_double_1d problem)
{
    double v;
    double a;
    v = (*cspan_at(&problem, INT64_C(0)));
    a = (*cspan_at(&problem, INT64_C(1)));
    (*cspan_at(&problem, INT64_C(0))) = (*cspan_at(&problem, INT64_C(2)));
    (*cspan_at(&problem, INT64_C(1))) = -(*cspan_at(&problem, INT64_C(3)));
    (*cspan_at(&problem, INT64_C(2))) = v;
    (*cspan_at(&problem, INT64_C(3))) = -a;
}
static void boundary_problem(array_double_1d problem, array_double_1d axis, array_double_1d cleaned)
{
    double fastest;
    double backwards;
    double top;
    double bottom;
    double velocity;
    double acceleration;
    double ramp;
    double scale;
    fastest = (*cspan_at(&axis, INT64_C(2)));
    backwards = (*cspan_at(&axis, INT64_C(9)));
    top = (*cspan_at(&axis, INT64_C(3)));
    bottom = (*cspan_at(&axis, INT64_C(9) + INT64_C(1)));
    (*cspan_at(&cleaned, INT64_C(0))) = boundary_value((*cspan_at(&problem, INT64_C(0))), backwards, fastest);
    (*cspan_at(&cleaned, INT64_C(1))) = boundary_value((*cspan_at(&problem, INT64_C(1))), bottom, top);
    (*cspan_at(&cleaned, INT64_C(2))) = boundary_value((*cspan_at(&problem, INT64_C(2))), backwards, fastest);
    (*cspan_at(&cleaned, INT64_C(3))) = boundary_value((*cspan_at(&problem, INT64_C(3))), bottom, top);
    velocity = fastest_velocity(axis);
    acceleration = top_acceleration(axis);
    ramp = acceleration * (*cspan_at(&axis, INT64_C(13))) * (*cspan_at(&axis, INT64_C(13)));
    scale = span_min(velocity * velocity / acceleration, ramp);
    (*cspan_at(&cleaned, INT64_C(4))) = flush_tiny((*cspan_at(&problem, INT64_C(4))), scale);
    (*cspan_at(&cleaned, INT64_C(5))) = (*cspan_at(&problem, INT64_C(5)));
}
static double speed_bound(double sign, double duration, array_double_1d problem, array_double_1d axis)
{
    double half;
    double change;
    double slope;
    double steepest;
    double most;
    double result;
    half = 0.5 * duration;
    ramp_change(&change, &slope, half, axis);
    steepest = span_max(fabs((*cspan_at(&problem, INT64_C(1)))), fabs((*cspan_at(&problem, INT64_C(3))))) + change;
    steepest = span_min(steepest, top_acceleration(axis));
    most = span_max(fabs((*cspan_at(&problem, INT64_C(0)))), fabs((*cspan_at(&problem, INT64_C(2))))) + steepest * half;
    result = span_min(side_limit(INT64_C(1), sign, axis), most);
    return result;
}
static bool is_resting(array_double_1d problem, array_double_1d axis)
{
    double speed;
    double acceleration;
    bool result;
    speed = fabs((*cspan_at(&problem, INT64_C(0)))) + fabs((*cspan_at(&problem, INT64_C(2))));
    if (flush_tiny(speed, fastest_velocity(axis)) != 0.0)
    {
        return 0;
    }
    acceleration = fabs((*cspan_at(&problem, INT64_C(1)))) + fabs((*cspan_at(&problem, INT64_C(3))));
    result = flush_tiny(acceleration, top_acceleration(axis)) == 0.0;
    return result;
}
int64_t segfmu_measure_phases(double* result_0, double* result_1, double* result_2_0001, double* result_3, double* result_4, array_double_2d phases, int64_t count, double v, double within_0001, array_double_1d axis)
{
    double total;
    double y;
    double lowest;
    double highest;
    int64_t i;
    double duration;
    double basis;
    double a;
    double b;
    double near;
    double bound;
    double extreme;
    total = 0.0;
    y = 0.0;
    lowest = v;
    highest = v;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        duration = (*cspan_at(&phases, i, INT64_C(0)));
        basis = (*cspan_at(&phases, i, INT64_C(1)));
        a = (*cspan_at(&phases, i, INT64_C(2)));
        b = a + (*cspan_at(&phases, i, INT64_C(3)));
        if (a * b < 0.0)
        {
            near = v;
            if (fabs(a) > fabs(b))
            {
                near = v + 0.5 * (a + b) * duration;
            }
            bound = near + extreme_gain(a, b, duration, basis, axis);
            if (a < 0.0)
            {
                bound = 2.0 * near - bound;
            }
            if ((bound > span_max(highest, within_0001)) || (bound < span_min(lowest, -within_0001)))
            {
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
static double total_duration(array_double_2d phases, int64_t count)
{
    int64_t i;
    double total;
    total = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        total = total + (*cspan_at(&phases, i, INT64_C(0)));
    }
    return total;
}
static double valid_duration(array_double_2d phases, int64_t count, array_double_1d problem, array_double_1d axis)
{
    double distance;
    double most;
    double y;
    double end;
    double lowest;
    double highest;
    double fastest;
    double duration;
    distance = (*cspan_at(&problem, INT64_C(4)));
    most = slowest_velocity(axis) * (1.0 + 1e-12);
    segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, (*cspan_at(&problem, INT64_C(0))), most, axis);
    if (is_beyond(lowest, highest, 1.0 + 1e-12, axis))
    {
        return -1.0;
    }
    fastest = span_max(-lowest, highest);
    if (fabs(end - (*cspan_at(&problem, INT64_C(2)))) > 1e-12 * fastest)
    {
        return -1.0;
    }
    if (fabs(y - distance) > 1e-12 * (fabs(distance) + fastest * duration))
    {
        return -1.0;
    }
    return duration;
}
static bool is_passing(array_double_2d phases, int64_t count, array_double_1d axis)
{
    int64_t i;
    bool found;
    found = 0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if ((*cspan_at(&phases, i, INT64_C(3))) != 0.0)
        {
            if (((*cspan_at(&phases, i, INT64_C(4))) < 0.5) || ((*cspan_at(&phases, i, INT64_C(4))) != (*cspan_at(&axis, INT64_C(38)))))
            {
                return 0;
            }
            found = 1;
        }
    }
    return found;
}
static bool has_dip(array_double_2d phases, int64_t count)
{
    bool result;
    if (count == INT64_C(0))
    {
        return 0;
    }
    result = ((*cspan_at(&phases, INT64_C(0), INT64_C(4))) > 0.5) || ((*cspan_at(&phases, count - INT64_C(1), INT64_C(4))) > 0.5);
    return result;
}
static void stretch_phases(array_double_2d phases, int64_t count, double factor)
{
    int64_t i;
    double power;
    int64_t j;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&phases, i, INT64_C(0))) = (*cspan_at(&phases, i, INT64_C(0))) * factor;
        power = factor * factor;
        for (j = INT64_C(0); j < (int64_t)((*cspan_at(&phases, i, INT64_C(4)))); j += INT64_C(1))
        {
            power = power * factor;
        }
        (*cspan_at(&phases, i, INT64_C(2))) = (*cspan_at(&phases, i, INT64_C(2))) / power;
        (*cspan_at(&phases, i, INT64_C(3))) = (*cspan_at(&phases, i, INT64_C(3))) / power;
    }
}
static int64_t fit_duration(array_double_2d phases, int64_t count, double target)
{
    double total;
    int64_t i;
    double duration;
    int64_t j;
    int64_t kept;
    total = 0.0;
    kept = INT64_C(0);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        duration = (*cspan_at(&phases, i, INT64_C(0)));
        if (duration > 1e-13 * target)
        {
            for (j = INT64_C(0); j < INT64_C(5); j += INT64_C(1))
            {
                (*cspan_at(&phases, kept, j)) = (*cspan_at(&phases, i, j));
            }
            total = total + duration;
            kept = kept + INT64_C(1);
        }
    }
    for (i = INT64_C(0); i < kept; i += INT64_C(1))
    {
        (*cspan_at(&phases, i, INT64_C(0))) = (*cspan_at(&phases, i, INT64_C(0))) * (target / total);
    }
    return kept;
}
static int64_t append_velocity_change(array_double_2d phases, int64_t count, double v, double a, double w, double top, double bottom, array_double_1d axis)
{
    double sign;
    double t1;
    double hold;
    double level;
    int64_t result;
    sign = 1.0;
    solve_level(&t1, &hold, &level, w - v, a, 0.0, span_max(0.0, a), top, -1.0, axis);
    if (hold < 0.0)
    {
        sign = -1.0;
        solve_level(&t1, &hold, &level, v - w, -a, 0.0, span_max(0.0, -a), bottom, -1.0, axis);
        if (hold < 0.0)
        {
            return -INT64_C(1);
        }
    }
    count = append_ramp(phases, count, a, sign * level, t1, axis);
    count = append_hold(phases, count, sign * level, hold);
    result = append_change(phases, count, sign * level, 0.0, axis);
    return result;
}
static int64_t cruise_form(int64_t* result_0, int64_t* result_1, double* result_2, double* result_3, array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis)
{
    double v;
    double top;
    double bottom;
    int64_t row;
    double w;
    double b;
    int64_t count;
    double duration;
    double y;
    double end;
    double lowest;
    double highest;
    v = (*cspan_at(&problem, INT64_C(0)));
    top = (*cspan_at(&axis, INT64_C(3)));
    bottom = (*cspan_at(&axis, INT64_C(9) + INT64_C(1)));
    row = append_velocity_change(phases, INT64_C(0), v, (*cspan_at(&problem, INT64_C(1))), cruise, top, bottom, axis);
    if (row < INT64_C(0))
    {
        (*result_0) = -INT64_C(1);
        (*result_1) = INT64_C(0);
        (*result_2) = 0.0;
        (*result_3) = 0.0;
        return 0;
    }
    w = (*cspan_at(&problem, INT64_C(2)));
    b = (*cspan_at(&problem, INT64_C(3)));
    count = append_velocity_change(phases, row, w, -b, cruise, bottom, top, axis);
    if (count < INT64_C(0))
    {
        (*result_0) = -INT64_C(1);
        (*result_1) = INT64_C(0);
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
static int64_t with_cruise(array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis)
{
    double distance;
    int64_t count;
    int64_t row;
    double duration;
    double y;
    double hold;
    int64_t result;
    distance = (*cspan_at(&problem, INT64_C(4)));
    cruise_form(&count, &row, &duration, &y, phases, cruise, problem, axis);
    if ((count < INT64_C(0)) || (cruise == 0.0))
    {
        return span_max_int(count, INT64_C(0));
    }
    hold = (distance - y) / cruise;
    if ((hold < 0.0) && (fabs(distance - y) > 1e-13 * fabs(distance)))
    {
        return INT64_C(0);
    }
    result = insert_hold(phases, count, row, 0.0, hold);
    return result;
}
static int64_t vanishing_cruise(double short_0001, double far, double start, array_double_2d phases, array_double_1d problem, array_double_1d axis)
{
    double distance;
    double newest;
    double other;
    double before;
    double e_newest;
    double e_other;
    double e_before;
    bool falls_short;
    int64_t i;
    double middle;
    double share;
    int64_t count;
    int64_t row;
    double duration;
    double y;
    double error;
    bool missing;
    double lower;
    double upper;
    double cruise;
    int64_t result;
    distance = (*cspan_at(&problem, INT64_C(4)));
    newest = short_0001;
    other = far;
    before = other;
    e_newest = 0.0;
    e_other = 0.0;
    e_before = 0.0;
    falls_short = 1;
    for (i = INT64_C(0); i < INT64_C(120); i += INT64_C(1))
    {
        middle = start;
        if (i > INT64_C(0))
        {
            share = root_share(newest, other, before, e_newest, e_other, e_before);
            middle = newest + share * (other - newest);
        }
        if ((middle - newest) * (middle - other) >= 0.0)
        {
            if (i > INT64_C(0))
            {
                break;
            }
            middle = 0.5 * (newest + other);
        }
        cruise_form(&count, &row, &duration, &y, phases, middle, problem, axis);
        error = y - distance;
        missing = (count < INT64_C(0)) || (error < 0.0);
        if (count < INT64_C(0))
        {
            error = 0.0;
        }
        next_bracket(&other, &before, &e_other, &e_before, missing != falls_short, newest, other, e_newest, e_other);
        newest = middle;
        e_newest = error;
        falls_short = missing;
        if ((count >= INT64_C(0)) && (fabs(error) <= 1e-15 * fabs(distance)))
        {
            other = newest;
            break;
        }
    }
    lower = newest;
    upper = other;
    if (!falls_short)
    {
        lower = other;
        upper = newest;
    }
    cruise = lower;
    if (cruise < 0.0)
    {
        cruise = upper;
    }
    result = with_cruise(phases, cruise, problem, axis);
    return result;
}
static int64_t slower_cruise(array_double_2d phases, array_double_1d problem, array_double_1d axis)
{
    double start;
    double slowest;
    int64_t result;
    start = span_max((*cspan_at(&problem, INT64_C(0))), (*cspan_at(&problem, INT64_C(2))));
    slowest = -(*cspan_at(&axis, INT64_C(9)));
    result = vanishing_cruise(slowest, (*cspan_at(&axis, INT64_C(2))), start, phases, problem, axis);
    return result;
}
static int64_t shorter_cruise(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d trial)
{
    double distance;
    double longest;
    double fastest;
    double backwards;
    double before;
    double e_before;
    int64_t i;
    double cruise;
    int64_t used;
    int64_t row;
    double duration;
    double y;
    double error;
    double short_0001;
    double far;
    distance = (*cspan_at(&problem, INT64_C(4)));
    longest = 1e+300;
    fastest = (*cspan_at(&axis, INT64_C(2)));
    backwards = (*cspan_at(&axis, INT64_C(9)));
    if (count > INT64_C(0))
    {
        longest = total_duration(phases, count);
        fastest = speed_bound(1.0, longest, problem, axis);
        backwards = speed_bound(-1.0, longest, problem, axis);
    }
    before = 0.0;
    e_before = 0.0;
    for (i = INT64_C(0); i < INT64_C(13); i += INT64_C(1))
    {
        cruise = fastest * (1.0 - i / 6.0);
        if (i > INT64_C(6))
        {
            cruise = backwards * (1.0 - i / 6.0);
        }
        cruise_form(&used, &row, &duration, &y, trial, cruise, problem, axis);
        error = 0.0;
        if (used >= INT64_C(0))
        {
            error = y - distance;
        }
        if (error * e_before < 0.0)
        {
            short_0001 = cruise;
            far = before;
            if (e_before < 0.0)
            {
                short_0001 = before;
                far = cruise;
            }
            used = vanishing_cruise(short_0001, far, 0.5 * (short_0001 + far), trial, problem, axis);
            duration = -1.0;
            if (used > INT64_C(0))
            {
                duration = valid_duration(trial, used, problem, axis);
            }
            if ((duration >= 0.0) && (duration < longest * (1.0 - 1e-10)))
            {
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
static int64_t direct_form(array_double_2d phases, bool from_start, array_double_1d problem, array_double_1d axis)
{
    double v;
    double a;
    double w;
    double b;
    double distance;
    double end;
    double t;
    double slope;
    double cruise;
    int64_t count;
    int64_t row;
    double duration;
    double y;
    v = (*cspan_at(&problem, INT64_C(0)));
    a = (*cspan_at(&problem, INT64_C(1)));
    w = (*cspan_at(&problem, INT64_C(2)));
    b = (*cspan_at(&problem, INT64_C(3)));
    distance = (*cspan_at(&problem, INT64_C(4)));
    end = fabs(b);
    if (from_start)
    {
        end = fabs(a);
    }
    if (end == 0.0)
    {
        return INT64_C(0);
    }
    segfmu_ramp_duration(&t, &slope, end, axis);
    cruise = w - 0.5 * b * t;
    if (from_start)
    {
        cruise = v + 0.5 * a * t;
    }
    if (is_beyond(cruise, cruise, 1.0, axis))
    {
        return INT64_C(0);
    }
    cruise_form(&count, &row, &duration, &y, phases, cruise, problem, axis);
    if (fabs(y - distance) > 1e-14 * (fabs(distance) + (fabs(v) + fabs(w)) * duration))
    {
        return INT64_C(0);
    }
    return span_max_int(count, INT64_C(0));
}
static double set_loop(array_double_1d problem, array_double_1d axis, array_double_1d family)
{
    double v;
    double a;
    double w;
    double b;
    double single;
    double slope;
    double missing;
    double sign;
    double top;
    double bottom;
    v = (*cspan_at(&problem, INT64_C(0)));
    a = (*cspan_at(&problem, INT64_C(1)));
    w = (*cspan_at(&problem, INT64_C(2)));
    b = (*cspan_at(&problem, INT64_C(3)));
    segfmu_ramp_duration(&single, &slope, fabs(b - a), axis);
    missing = w - v - 0.5 * (a + b) * single;
    sign = 1.0;
    if (missing < 0.0)
    {
        sign = -1.0;
    }
    (*cspan_at(&family, INT64_C(0))) = sign * v;
    (*cspan_at(&family, INT64_C(1))) = sign * a;
    (*cspan_at(&family, INT64_C(2))) = sign * w;
    (*cspan_at(&family, INT64_C(3))) = sign * b;
    (*cspan_at(&family, INT64_C(15))) = 0.0;
    (*cspan_at(&family, INT64_C(16))) = sign * (*cspan_at(&problem, INT64_C(4)));
    top = side_limit(INT64_C(2), sign, axis);
    bottom = side_limit(INT64_C(2), -sign, axis);
    (*cspan_at(&family, INT64_C(4))) = top;
    (*cspan_at(&family, INT64_C(5))) = bottom;
    (*cspan_at(&family, INT64_C(12))) = v;
    (*cspan_at(&family, INT64_C(13))) = 0.0;
    (*cspan_at(&family, INT64_C(14))) = 0.5 - 0.5 * sign;
    segfmu_ramp_duration(cspan_at(&family, INT64_C(8)), &slope, top - sign * a, axis);
    segfmu_ramp_duration(cspan_at(&family, INT64_C(9)), &slope, bottom + sign * a, axis);
    segfmu_ramp_duration(cspan_at(&family, INT64_C(10)), &slope, top - sign * b, axis);
    segfmu_ramp_duration(cspan_at(&family, INT64_C(11)), &slope, bottom + sign * b, axis);
    return sign * missing;
}
static int64_t level_from(double* result_0_0001, double* result_1_0001, double* result_2_0001, double a, double time, double up, double down, array_double_1d family, array_double_1d axis)
{
    double change;
    double slope;
    if (time >= up)
    {
        (*result_0_0001) = up;
        (*result_1_0001) = time - up;
        (*result_2_0001) = (*cspan_at(&family, INT64_C(4)));
        return 0;
    }
    if (-time >= down)
    {
        (*result_0_0001) = down;
        (*result_1_0001) = (-time) - down;
        (*result_2_0001) = -(*cspan_at(&family, INT64_C(5)));
        return 0;
    }
    ramp_change(&change, &slope, fabs(time), axis);
    if (time < 0.0)
    {
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
static double set_point(double place, double radius, array_double_1d family, array_double_1d axis)
{
    double part;
    double p_sign;
    double q_sign;
    double a;
    double b;
    double t1;
    double hold1;
    double level1;
    double t3;
    double hold2;
    double level2;
    double t2;
    double slope;
    double gain;
    double result;
    part = place;
    p_sign = 1.0;
    q_sign = 1.0;
    if (place >= 3.0)
    {
        part = 4.0 - place;
        q_sign = -1.0;
    }
    else if (place >= 2.0)
    {
        part = place - 2.0;
        p_sign = -1.0;
        q_sign = -1.0;
    }
    else if (place >= 1.0)
    {
        part = 2.0 - place;
        p_sign = -1.0;
    }
    a = (*cspan_at(&family, INT64_C(1)));
    b = (*cspan_at(&family, INT64_C(3)));
    level_from(&t1, &hold1, &level1, a, p_sign * radius * (1.0 - part), (*cspan_at(&family, INT64_C(8))), (*cspan_at(&family, INT64_C(9))), family, axis);
    level_from(&t3, &hold2, &level2, b, q_sign * radius * part, (*cspan_at(&family, INT64_C(10))), (*cspan_at(&family, INT64_C(11))), family, axis);
    segfmu_ramp_duration(&t2, &slope, fabs(level2 - level1), axis);
    (*cspan_at(&family, INT64_C(27))) = t1;
    (*cspan_at(&family, INT64_C(28))) = hold1;
    (*cspan_at(&family, INT64_C(29))) = level1;
    (*cspan_at(&family, INT64_C(30))) = hold2;
    (*cspan_at(&family, INT64_C(31))) = level2;
    (*cspan_at(&family, INT64_C(32))) = t3;
    gain = 0.5 * ((a + level1) * t1 + (level1 + level2) * t2 + (level2 + b) * t3);
    gain = gain + level1 * hold1 + level2 * hold2;
    result = gain - ((*cspan_at(&family, INT64_C(2))) - (*cspan_at(&family, INT64_C(0))));
    return result;
}
static double loop_radius(int64_t arc, double place, double missing, double largest, array_double_1d family, array_double_1d axis)
{
    double lower;
    double e_lower;
    double upper;
    double e_upper;
    double other;
    double before;
    double e_newest;
    double e_other;
    double e_before;
    double scale;
    int64_t i;
    double share;
    double radius;
    double error;
    double newest;
    lower = 0.0;
    e_lower = -missing;
    upper = span_min(span_max(0.25 * missing / (*cspan_at(&family, INT64_C(4))), 1e-06 * largest), 0.25 * largest);
    e_upper = set_point(place, upper, family, axis);
    while((e_upper < 0.0) || (arc == INT64_C(6)))
    {
        if (!(upper < largest))
        {
            return -1.0;
        }
        lower = upper;
        e_lower = e_upper;
        upper = span_min(2.0 * upper, largest);
        e_upper = set_point(place, upper, family, axis);
        if ((arc == INT64_C(6)) && (e_lower >= 0.0) && (e_upper < 0.0))
        {
            break;
        }
    }
    newest = upper;
    other = lower;
    before = lower;
    e_newest = e_upper;
    e_other = e_lower;
    e_before = e_lower;
    scale = fabs((*cspan_at(&family, INT64_C(0)))) + fabs((*cspan_at(&family, INT64_C(2)))) + missing;
    for (i = INT64_C(0); i < INT64_C(80); i += INT64_C(1))
    {
        if ((fabs(e_newest) <= 1e-16 * scale) || (fabs(other - newest) <= 4e-16 * newest))
        {
            break;
        }
        share = root_share(newest, other, before, e_newest, e_other, e_before);
        radius = newest + share * (other - newest);
        error = set_point(place, radius, family, axis);
        next_bracket(&other, &before, &e_other, &e_before, error * e_newest < 0.0, newest, other, e_newest, e_other);
        newest = radius;
        e_newest = error;
    }
    return newest;
}
static bool slow_middle(double place, double radius, array_double_1d family, array_double_1d axis)
{
    double error;
    double level1;
    double level2;
    double fastest;
    double slope;
    double mean;
    double stretch;
    error = set_point(place, radius, family, axis);
    level1 = (*cspan_at(&family, INT64_C(29)));
    level2 = (*cspan_at(&family, INT64_C(31)));
    segfmu_ramp_duration(&fastest, &slope, fabs(level2 - level1), axis);
    mean = 0.5 * (level1 + level2);
    if (fastest <= 0.0)
    {
        return 0;
    }
    if (mean != 0.0)
    {
        stretch = 1.0 - error / (mean * fastest);
    }
    else if (((*cspan_at(&family, INT64_C(15))) > 0.5) && (radius == 0.0) && (error == 0.0))
    {
        stretch = (*cspan_at(&family, INT64_C(16))) / fastest;
    }
    else
    {
        return 0;
    }
    (*cspan_at(&family, INT64_C(33))) = stretch;
    return stretch >= 1.0;
}
static double window_edge(int64_t halvings, double inside, double outside, array_double_1d family, array_double_1d axis)
{
    int64_t i;
    double middle;
    for (i = INT64_C(0); i < halvings; i += INT64_C(1))
    {
        middle = 0.5 * (inside + outside);
        if ((middle == inside) || (middle == outside))
        {
            break;
        }
        if (has_member(middle, family, axis))
        {
            inside = middle;
        }
        else
        {
            outside = middle;
        }
    }
    return inside;
}
static int64_t canonical_value(double* result_0_0001, double* result_1, double p, array_double_1d family, array_double_1d axis)
{
    double duration;
    double y;
    canonical_member(&duration, &y, p, family, axis);
    if ((*cspan_at(&family, INT64_C(15))) > 0.5)
    {
        (*result_0_0001) = duration;
        (*result_1) = duration;
        return 0;
    }
    (*result_0_0001) = y;
    (*result_1) = duration;
    return 0;
}
static double bracketed_root(double lower, double upper, double f_lower, double f_upper, array_double_1d family, array_double_1d axis)
{
    double target;
    double newest;
    double e_newest;
    double other;
    double e_other;
    double before;
    double e_before;
    double speed;
    int64_t i;
    double share;
    double p;
    double value;
    double duration;
    double error;
    target = (*cspan_at(&family, INT64_C(16)));
    newest = upper;
    e_newest = f_upper - target;
    other = lower;
    e_other = f_lower - target;
    before = lower;
    e_before = e_other;
    speed = fabs((*cspan_at(&family, INT64_C(0)))) + fabs((*cspan_at(&family, INT64_C(2))));
    if ((*cspan_at(&family, INT64_C(15))) > 0.5)
    {
        speed = 0.0;
    }
    for (i = INT64_C(0); i < INT64_C(120); i += INT64_C(1))
    {
        if ((e_newest == 0.0) || (fabs(newest - other) <= 2e-16 * fabs(newest)))
        {
            break;
        }
        share = root_share(newest, other, before, e_newest, e_other, e_before);
        p = newest + share * (other - newest);
        canonical_value(&value, &duration, p, family, axis);
        error = value - target;
        next_bracket(&other, &before, &e_other, &e_before, error * e_newest < 0.0, newest, other, e_newest, e_other);
        newest = p;
        e_newest = error;
        if (fabs(error) <= 2e-15 * (fabs(target) + speed * duration))
        {
            break;
        }
    }
    if (fabs(e_other) < fabs(e_newest))
    {
        return other;
    }
    return newest;
}
static int64_t highest_member(double* result_0_0001, double* result_1_0001, double lower, double upper, array_double_1d family, array_double_1d axis)
{
    double shrink;
    double p;
    double q;
    double f_p;
    double duration;
    double f_q;
    int64_t i;
    shrink = 0.6180339887498949;
    p = upper - shrink * (upper - lower);
    q = lower + shrink * (upper - lower);
    canonical_value(&f_p, &duration, p, family, axis);
    canonical_value(&f_q, &duration, q, family, axis);
    for (i = INT64_C(0); i < INT64_C(30); i += INT64_C(1))
    {
        if (span_max(f_p, f_q) >= (*cspan_at(&family, INT64_C(16))))
        {
            break;
        }
        if (f_p >= f_q)
        {
            upper = q;
            q = p;
            f_q = f_p;
            p = upper - shrink * (upper - lower);
            canonical_value(&f_p, &duration, p, family, axis);
        }
        else
        {
            lower = p;
            p = q;
            f_p = f_q;
            q = lower + shrink * (upper - lower);
            canonical_value(&f_q, &duration, q, family, axis);
        }
    }
    if (f_p >= f_q)
    {
        (*result_0_0001) = p;
        (*result_1_0001) = f_p;
        return 0;
    }
    (*result_0_0001) = q;
    (*result_1_0001) = f_q;
    return 0;
}
static double rising_member(double f_start, double end, array_double_1d family, array_double_1d axis)
{
    double target;
    double step;
    double before;
    double f_lower;
    int64_t i;
    double value;
    double duration;
    double bend;
    double p;
    double highest;
    double result;
    target = (*cspan_at(&family, INT64_C(16)));
    step = 0.125 * end;
    before = f_start;
    f_lower = f_start;
    for (i = INT64_C(1); i < INT64_C(9); i += INT64_C(1))
    {
        canonical_value(&value, &duration, i * step, family, axis);
        if ((value >= target) && (value > f_lower))
        {
            result = bracketed_root((i - INT64_C(1)) * step, i * step, f_lower, value, family, axis);
            return result;
        }
        bend = 2.0 * f_lower - before - value;
        if ((i > INT64_C(1)) && (f_lower >= span_max(before, value)) && (target <= f_lower + 0.25 * bend))
        {
            highest_member(&p, &highest, (i - INT64_C(2)) * step, i * step, family, axis);
            if ((highest >= target) && (highest > before))
            {
                result = bracketed_root((i - INT64_C(2)) * step, p, before, highest, family, axis);
                return result;
            }
        }
        before = f_lower;
        f_lower = value;
    }
    return -1.0;
}
static void note_near(double y, double duration, array_double_1d family, array_double_1d axis)
{
    double speed;
    speed = fabs((*cspan_at(&family, INT64_C(0)))) + fabs((*cspan_at(&family, INT64_C(2))));
    speed = speed + (fabs((*cspan_at(&family, INT64_C(1)))) + fabs((*cspan_at(&family, INT64_C(3))))) * duration;
    if (fabs(y - (*cspan_at(&family, INT64_C(16)))) <= saving(axis) * speed * duration)
    {
        (*cspan_at(&family, INT64_C(20))) = INT64_C(2);
    }
}
static int64_t first_window(double* result_0, double* result_1, double f_start, double t_zero, array_double_1d family, array_double_1d axis)
{
    double target;
    double value;
    double duration;
    double end;
    double going_on;
    double p;
    target = (*cspan_at(&family, INT64_C(16)));
    canonical_value(&value, &duration, t_zero, family, axis);
    end = t_zero;
    going_on = t_zero;
    if (duration < 0.0)
    {
        end = window_edge(INT64_C(80), 0.0, t_zero, family, axis);
        canonical_value(&value, &duration, end, family, axis);
        going_on = -1.0;
    }
    if ((*cspan_at(&family, INT64_C(0))) < 0.0)
    {
        p = rising_member(f_start, end, family, axis);
        if (p >= 0.0)
        {
            (*result_0) = p;
            (*result_1) = going_on;
            return 0;
        }
    }
    if ((value >= target) && (value > f_start))
    {
        p = bracketed_root(0.0, end, f_start, value, family, axis);
        (*result_0) = p;
        (*result_1) = going_on;
        return 0;
    }
    if (going_on < 0.0)
    {
        note_near(value, duration, family, axis);
    }
    (*result_0) = -1.0;
    (*result_1) = going_on;
    return 0;
}
static bool only_farther(array_double_1d family)
{
    double gain;
    double loss;
    bool result;
    if ((*cspan_at(&family, INT64_C(3))) > 0.0)
    {
        return 0;
    }
    gain = 0.5 * ((*cspan_at(&family, INT64_C(1))) + (*cspan_at(&family, INT64_C(29)))) * (*cspan_at(&family, INT64_C(27)));
    gain = gain + (*cspan_at(&family, INT64_C(29))) * (*cspan_at(&family, INT64_C(28)));
    loss = 0.5 * ((*cspan_at(&family, INT64_C(31))) + (*cspan_at(&family, INT64_C(3)))) * (*cspan_at(&family, INT64_C(32)));
    loss = loss + (*cspan_at(&family, INT64_C(31))) * (*cspan_at(&family, INT64_C(30)));
    result = ((*cspan_at(&family, INT64_C(0))) + gain >= 0.0) || ((*cspan_at(&family, INT64_C(2))) - loss >= 0.0);
    return result;
}
static double shorter_member(double f_start, array_double_1d family, array_double_1d axis)
{
    int64_t samples;
    double span;
    int64_t i;
    double p;
    double value;
    double duration;
    double result;
    samples = INT64_C(12);
    span = span_max((*cspan_at(&family, INT64_C(7))), (*cspan_at(&axis, INT64_C(13))));
    for (i = INT64_C(1); i < samples + INT64_C(1); i += INT64_C(1))
    {
        if (only_farther(family))
        {
            return -1.0;
        }
        p = span * i * i / (samples * samples);
        canonical_value(&value, &duration, p, family, axis);
        if (duration < 0.0)
        {
            return -1.0;
        }
        if (value <= (*cspan_at(&family, INT64_C(16))))
        {
            result = bracketed_root(p, 0.0, value, f_start, family, axis);
            return result;
        }
    }
    return -1.0;
}
static void note_near_gain(array_double_1d family, array_double_1d axis)
{
    double a;
    double b;
    double low;
    double first;
    double least;
    a = (*cspan_at(&family, INT64_C(1)));
    b = (*cspan_at(&family, INT64_C(3)));
    low = span_max(0.0, span_max(a, b));
    level_gain(&first, &least, low, a, b, axis);
    if ((*cspan_at(&family, INT64_C(2))) - (*cspan_at(&family, INT64_C(0))) >= (1.0 - saving(axis)) * least)
    {
        (*cspan_at(&family, INT64_C(20))) = INT64_C(2);
    }
}
static double second_window(double t_zero, array_double_1d family, array_double_1d axis)
{
    double upper;
    double value;
    double duration;
    int64_t i;
    double result;
    upper = (*cspan_at(&family, INT64_C(7)));
    canonical_value(&value, &duration, upper, family, axis);
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        if (duration >= 0.0)
        {
            break;
        }
        upper = 2.0 * upper;
        canonical_value(&value, &duration, upper, family, axis);
    }
    result = window_edge(INT64_C(80), upper, t_zero, family, axis);
    return result;
}
static double farther_member(double lower, double f_lower, array_double_1d family, array_double_1d axis)
{
    double upper;
    int64_t i;
    double f_upper;
    double duration;
    double result;
    upper = span_max((*cspan_at(&family, INT64_C(7))), (*cspan_at(&axis, INT64_C(13))));
    if (upper <= lower)
    {
        upper = 2.0 * lower;
    }
    for (i = INT64_C(0); i < INT64_C(200); i += INT64_C(1))
    {
        canonical_value(&f_upper, &duration, upper, family, axis);
        if (f_upper >= (*cspan_at(&family, INT64_C(16))))
        {
            result = bracketed_root(lower, upper, f_lower, f_upper, family, axis);
            return result;
        }
        lower = upper;
        f_lower = f_upper;
        upper = 2.0 * upper;
    }
    return -1.0;
}
static double canonical_search(array_double_1d family, array_double_1d axis)
{
    double target;
    double v;
    double w;
    double f_lower;
    double duration;
    double lower;
    double t_zero;
    double slope;
    double p;
    target = (*cspan_at(&family, INT64_C(16)));
    v = (*cspan_at(&family, INT64_C(0)));
    w = (*cspan_at(&family, INT64_C(2)));
    canonical_value(&f_lower, &duration, 0.0, family, axis);
    if (duration < 0.0)
    {
        note_near_gain(family, axis);
        return -1.0;
    }
    if (fabs(f_lower - target) <= 1e-14 * (fabs(target) + (fabs(v) + fabs(w)) * duration))
    {
        return 0.0;
    }
    if (f_lower > target)
    {
        note_near(f_lower, duration, family, axis);
        if ((v >= 0.0) && (w >= 0.0))
        {
            return -1.0;
        }
        p = shorter_member(f_lower, family, axis);
        return p;
    }
    lower = 0.0;
    if ((*cspan_at(&family, INT64_C(3))) > 0.0)
    {
        segfmu_ramp_duration(&t_zero, &slope, (*cspan_at(&family, INT64_C(3))), axis);
        first_window(&p, &lower, f_lower, t_zero, family, axis);
        if (p >= 0.0)
        {
            return p;
        }
        if (lower < 0.0)
        {
            lower = second_window(t_zero, family, axis);
        }
        canonical_value(&f_lower, &duration, lower, family, axis);
        if (f_lower > target)
        {
            return -1.0;
        }
    }
    p = farther_member(lower, f_lower, family, axis);
    return p;
}
static double nearby_member(array_double_1d family, array_double_1d axis)
{
    double target;
    double lower;
    double upper;
    double f_lower;
    double duration;
    double f_upper;
    double result;
    target = (*cspan_at(&family, INT64_C(16)));
    lower = 0.95 * (*cspan_at(&family, INT64_C(26)));
    upper = 1.05 * (*cspan_at(&family, INT64_C(26)));
    if (lower <= 0.0)
    {
        return -1.0;
    }
    canonical_value(&f_lower, &duration, lower, family, axis);
    if (duration < 0.0)
    {
        return -1.0;
    }
    canonical_value(&f_upper, &duration, upper, family, axis);
    if ((duration < 0.0) || ((f_lower - target) * (f_upper - target) > 0.0) || (f_lower == f_upper))
    {
        return -1.0;
    }
    if (f_upper > f_lower)
    {
        result = bracketed_root(lower, upper, f_lower, f_upper, family, axis);
        return result;
    }
    result = bracketed_root(upper, lower, f_upper, f_lower, family, axis);
    return result;
}
static double member_search(array_double_1d family, array_double_1d axis)
{
    double target;
    int64_t passed;
    int64_t begin;
    double lower;
    double f_lower;
    bool whole;
    double p;
    int64_t i;
    double value;
    double duration;
    double upper;
    double f_upper;
    bool inside;
    double outside;
    bool found;
    double result;
    target = (*cspan_at(&family, INT64_C(16)));
    passed = INT64_C(0);
    begin = INT64_C(0);
    lower = -1.0;
    f_lower = 0.0;
    whole = (*cspan_at(&family, INT64_C(6))) == (*cspan_at(&family, INT64_C(4)));
    if (whole && ((*cspan_at(&family, INT64_C(17))) > 0.5))
    {
        passed = (int64_t)((*cspan_at(&family, INT64_C(17))));
        begin = (int64_t)((*cspan_at(&family, INT64_C(22))));
        lower = (*cspan_at(&family, INT64_C(23)));
        f_lower = (*cspan_at(&family, INT64_C(24)));
        if ((begin > INT64_C(13)) && (lower >= 0.0) && (f_lower > target))
        {
            return -1.0;
        }
    }
    p = 0.0;
    for (i = begin; i < INT64_C(36); i += INT64_C(1))
    {
        p = (*cspan_at(&family, INT64_C(18))) * i * i / 144.0;
        canonical_value(&value, &duration, p, family, axis);
        upper = p;
        f_upper = value;
        inside = duration >= 0.0;
        if (inside && (lower < 0.0) && (i > INT64_C(0)))
        {
            outside = (*cspan_at(&family, INT64_C(18))) * (i - INT64_C(1)) * (i - INT64_C(1)) / 144.0;
            lower = window_edge(INT64_C(24), p, outside, family, axis);
            canonical_value(&f_lower, &duration, lower, family, axis);
        }
        if ((!inside) && (lower >= 0.0))
        {
            upper = window_edge(INT64_C(24), lower, p, family, axis);
            canonical_value(&f_upper, &duration, upper, family, axis);
        }
        found = (lower >= 0.0) && ((f_lower - target) * (f_upper - target) <= 0.0);
        found = found && (f_upper != f_lower);
        if (found && (passed == (int64_t)((*cspan_at(&family, INT64_C(17))))))
        {
            if (whole)
            {
                (*cspan_at(&family, INT64_C(22))) = i + INT64_C(1);
                (*cspan_at(&family, INT64_C(23))) = p;
                if (!inside)
                {
                    (*cspan_at(&family, INT64_C(23))) = -1.0;
                }
                (*cspan_at(&family, INT64_C(24))) = f_upper;
            }
            if (f_upper > f_lower)
            {
                result = bracketed_root(lower, upper, f_lower, f_upper, family, axis);
                return result;
            }
            result = bracketed_root(upper, lower, f_upper, f_lower, family, axis);
            return result;
        }
        if (found)
        {
            passed = passed + INT64_C(1);
        }
        lower = -1.0;
        if (inside)
        {
            lower = p;
            f_lower = value;
            if ((i > INT64_C(12)) && (value > target))
            {
                return -1.0;
            }
        }
    }
    return -1.0;
}
static void set_family(int64_t branch, array_double_1d problem, array_double_1d axis, array_double_1d family)
{
    bool reverse;
    bool mirror;
    double v;
    double a;
    double w;
    double b;
    double distance;
    double top;
    double bottom;
    double last_ramp;
    double slope;
    reverse = (branch == INT64_C(1)) || (branch == INT64_C(2));
    mirror = branch >= INT64_C(2);
    v = (*cspan_at(&problem, INT64_C(0)));
    a = (*cspan_at(&problem, INT64_C(1)));
    w = (*cspan_at(&problem, INT64_C(2)));
    b = (*cspan_at(&problem, INT64_C(3)));
    distance = (*cspan_at(&problem, INT64_C(4)));
    (*cspan_at(&family, INT64_C(12))) = v;
    if (reverse)
    {
        v = (*cspan_at(&problem, INT64_C(2)));
        a = -(*cspan_at(&problem, INT64_C(3)));
        w = (*cspan_at(&problem, INT64_C(0)));
        b = -(*cspan_at(&problem, INT64_C(1)));
    }
    if (mirror)
    {
        v = -v;
        a = -a;
        w = -w;
        b = -b;
        distance = -distance;
    }
    top = (*cspan_at(&axis, INT64_C(3)));
    bottom = (*cspan_at(&axis, INT64_C(9) + INT64_C(1)));
    if (reverse != mirror)
    {
        top = (*cspan_at(&axis, INT64_C(9) + INT64_C(1)));
        bottom = (*cspan_at(&axis, INT64_C(3)));
    }
    segfmu_ramp_duration(&last_ramp, &slope, b + bottom, axis);
    (*cspan_at(&family, INT64_C(0))) = v;
    (*cspan_at(&family, INT64_C(1))) = a;
    (*cspan_at(&family, INT64_C(2))) = w;
    (*cspan_at(&family, INT64_C(3))) = b;
    (*cspan_at(&family, INT64_C(4))) = top;
    (*cspan_at(&family, INT64_C(5))) = bottom;
    (*cspan_at(&family, INT64_C(7))) = last_ramp;
    (*cspan_at(&family, INT64_C(13))) = reverse;
    (*cspan_at(&family, INT64_C(14))) = mirror;
    (*cspan_at(&family, INT64_C(15))) = 0.0;
    (*cspan_at(&family, INT64_C(16))) = distance;
    (*cspan_at(&family, INT64_C(17))) = -1.0;
    (*cspan_at(&family, INT64_C(27))) = -1.0;
    (*cspan_at(&family, INT64_C(18))) = last_ramp;
    (*cspan_at(&family, INT64_C(33))) = 1.0;
    (*cspan_at(&family, INT64_C(34))) = 0.0;
    (*cspan_at(&family, INT64_C(25))) = 0.0;
}
static void set_member(int64_t member, double time, bool by_time, array_double_1d family)
{
    (*cspan_at(&family, INT64_C(17))) = member;
    (*cspan_at(&family, INT64_C(18))) = span_min(span_max((*cspan_at(&family, INT64_C(7))), 0.1 * time), time);
    (*cspan_at(&family, INT64_C(26))) = -1.0;
    if (by_time)
    {
        (*cspan_at(&family, INT64_C(15))) = 1.0;
        (*cspan_at(&family, INT64_C(16))) = time;
    }
}
static bool same_members(int64_t branch, array_double_1d problem, array_double_1d family)
{
    double a;
    double b;
    if ((span_floor_mod(branch, INT64_C(2)) == INT64_C(0)) || ((*cspan_at(&family, INT64_C(25))) > 0.5))
    {
        return 0;
    }
    a = (*cspan_at(&problem, INT64_C(1)));
    b = (*cspan_at(&problem, INT64_C(3)));
    if (branch >= INT64_C(2))
    {
        a = -a;
        b = -b;
    }
    return (a >= 0.0) && (b <= 0.0);
}
static int64_t write_member(array_double_2d phases, array_double_1d family, array_double_1d axis)
{
    double a;
    double b;
    double level1;
    double level2;
    int64_t before;
    double basis;
    double duration;
    int64_t count;
    a = (*cspan_at(&family, INT64_C(1)));
    b = (*cspan_at(&family, INT64_C(3)));
    level1 = (*cspan_at(&family, INT64_C(29)));
    level2 = (*cspan_at(&family, INT64_C(31)));
    count = append_ramp(phases, INT64_C(0), a, level1, (*cspan_at(&family, INT64_C(27))), axis);
    count = append_hold(phases, count, level1, (*cspan_at(&family, INT64_C(28))));
    before = count;
    count = append_change(phases, count, level1, level2, axis);
    if ((count > before) && ((*cspan_at(&family, INT64_C(33))) > 1.0))
    {
        basis = (*cspan_at(&phases, before, INT64_C(1)));
        duration = basis * (*cspan_at(&family, INT64_C(33)));
        (*cspan_at(&phases, before, INT64_C(0))) = duration;
        (*cspan_at(&phases, before, INT64_C(1))) = basis + (*cspan_at(&family, INT64_C(34))) * (duration - basis);
    }
    count = append_hold(phases, count, level2, (*cspan_at(&family, INT64_C(30))));
    count = append_ramp(phases, count, level2, b, (*cspan_at(&family, INT64_C(32))), axis);
    if ((*cspan_at(&family, INT64_C(13))) > 0.5)
    {
        reverse_phases(phases, INT64_C(0), count);
    }
    if ((*cspan_at(&family, INT64_C(14))) > 0.5)
    {
        mirror_phases(phases, count);
    }
    return count;
}
static int64_t merged_form(array_double_2d phases, double highest, array_double_1d family, array_double_1d axis)
{
    double p;
    double duration;
    double y;
    int64_t result;
    (*cspan_at(&family, INT64_C(6))) = highest;
    if ((*cspan_at(&family, INT64_C(17))) < 0.0)
    {
        p = canonical_search(family, axis);
    }
    else
    {
        p = nearby_member(family, axis);
        if (p < 0.0)
        {
            p = member_search(family, axis);
        }
    }
    if (p < 0.0)
    {
        return -INT64_C(1);
    }
    (*cspan_at(&family, INT64_C(26))) = p;
    canonical_member(&duration, &y, p, family, axis);
    if (duration < 0.0)
    {
        return -INT64_C(1);
    }
    result = write_member(phases, family, axis);
    return result;
}
static double velocity_excess(array_double_2d phases, int64_t count, double v, double within_0001, array_double_1d axis)
{
    double duration;
    double y;
    double end;
    double lowest;
    double highest;
    double result;
    segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, v, within_0001, axis);
    result = span_max(highest - (*cspan_at(&axis, INT64_C(2))), (-lowest) - (*cspan_at(&axis, INT64_C(9))));
    return result;
}
static int64_t level_within(double* result_0, double* result_1_0001, double* result_2_0001, double* result_3_0001, double outside, double e_outside, array_double_2d phases, array_double_1d family, array_double_1d axis)
{
    double peak_limit;
    double other_limit;
    double v;
    double rounding;
    double margin;
    double too_low;
    double inside;
    int64_t i;
    int64_t count;
    double duration;
    double y;
    double end;
    double lowest;
    double highest;
    double peak;
    double other;
    double excess;
    peak_limit = (*cspan_at(&axis, INT64_C(2)));
    other_limit = (*cspan_at(&axis, INT64_C(9)));
    if ((*cspan_at(&family, INT64_C(14))) > 0.5)
    {
        peak_limit = (*cspan_at(&axis, INT64_C(9)));
        other_limit = (*cspan_at(&axis, INT64_C(2)));
    }
    v = (*cspan_at(&family, INT64_C(12)));
    rounding = 1e-12 * fastest_velocity(axis);
    margin = 1e-09 * fastest_velocity(axis);
    too_low = span_max((*cspan_at(&family, INT64_C(1))), span_max((*cspan_at(&family, INT64_C(3))), 0.001 * outside));
    inside = too_low;
    for (i = INT64_C(0); i < INT64_C(24); i += INT64_C(1))
    {
        count = merged_form(phases, inside, family, axis);
        segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, span_max_int(count, INT64_C(0)), v, 0.0, axis);
        peak = highest;
        other = -lowest;
        if ((*cspan_at(&family, INT64_C(14))) > 0.5)
        {
            peak = -lowest;
            other = highest;
        }
        if ((count <= INT64_C(0)) || (other > other_limit + rounding))
        {
            too_low = inside;
        }
        else if (peak > peak_limit + rounding)
        {
            outside = inside;
            e_outside = peak - peak_limit + margin;
        }
        else
        {
            excess = span_max(peak - peak_limit, other - other_limit);
            (*result_0) = inside;
            (*result_1_0001) = outside;
            (*result_2_0001) = excess + margin;
            (*result_3_0001) = e_outside;
            return 0;
        }
        if (too_low == outside)
        {
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
static double highest_within(double inside, double outside, double e_inside, double e_outside, array_double_2d phases, array_double_1d family, array_double_1d axis)
{
    double margin;
    double before;
    double e_before;
    bool newest_inside;
    bool constant;
    bool probing;
    int64_t steps;
    double share;
    double level;
    int64_t count;
    double error;
    double v;
    margin = 1e-09 * fastest_velocity(axis);
    before = outside;
    e_before = e_outside;
    newest_inside = 1;
    constant = 0;
    probing = 0;
    steps = INT64_C(0);
    while(steps < INT64_C(60))
    {
        steps = steps + INT64_C(1);
        probing = 0;
        if (constant)
        {
            e_inside = 0.0;
            if (steps > INT64_C(24))
            {
                break;
            }
        }
        else if (fabs(e_inside) <= margin)
        {
            probing = 1;
        }
        if (newest_inside)
        {
            share = root_share(inside, outside, before, e_inside, e_outside, e_before);
        }
        else
        {
            share = 1.0 - root_share(outside, inside, before, e_outside, e_inside, e_before);
        }
        if (probing)
        {
            share = 0.001;
        }
        level = inside + share * (outside - inside);
        count = merged_form(phases, level, family, axis);
        error = 0.0;
        if (count > INT64_C(0))
        {
            v = (*cspan_at(&family, INT64_C(12)));
            error = velocity_excess(phases, count, v, 0.0, axis) + margin;
        }
        if ((count > INT64_C(0)) && (error <= margin))
        {
            before = outside;
            e_before = e_outside;
            if (newest_inside)
            {
                before = inside;
                e_before = e_inside;
            }
            inside = level;
            e_inside = error;
            newest_inside = 1;
            if (probing && (outside - inside <= 1e-05 * outside))
            {
                break;
            }
            constant = constant || probing;
        }
        else if (probing)
        {
            break;
        }
        else
        {
            before = inside;
            e_before = e_inside;
            if (!newest_inside)
            {
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
static int64_t tempered_form(array_double_2d phases, array_double_1d family, array_double_1d axis)
{
    double rounding;
    double margin;
    double v;
    double e_outside;
    double outside;
    int64_t i;
    double level;
    double inside;
    double e_inside;
    int64_t count;
    count = merged_form(phases, (*cspan_at(&family, INT64_C(4))), family, axis);
    rounding = 1e-12 * fastest_velocity(axis);
    margin = 1e-09 * fastest_velocity(axis);
    if (count <= INT64_C(0))
    {
        return count;
    }
    v = (*cspan_at(&family, INT64_C(12)));
    e_outside = velocity_excess(phases, count, v, slowest_velocity(axis), axis) + margin;
    if (e_outside <= margin + rounding)
    {
        return count;
    }
    (*cspan_at(&family, INT64_C(25))) = 1.0;
    outside = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        level = (*cspan_at(&phases, i, INT64_C(2)));
        if ((*cspan_at(&family, INT64_C(13))) != (*cspan_at(&family, INT64_C(14))))
        {
            level = -level;
        }
        outside = span_max(outside, level);
    }
    level_within(&inside, &outside, &e_inside, &e_outside, outside, e_outside, phases, family, axis);
    if (inside < 0.0)
    {
        return INT64_C(0);
    }
    inside = highest_within(inside, outside, e_inside, e_outside, phases, family, axis);
    count = merged_form(phases, inside, family, axis);
    return count;
}
static int64_t timed_cruise(int64_t* result_0, double* result_1_0001, double* result_2, array_double_2d phases, double cruise, array_double_1d problem, array_double_1d axis)
{
    int64_t count;
    int64_t row;
    double duration;
    double y;
    double hold;
    cruise_form(&count, &row, &duration, &y, phases, cruise, problem, axis);
    if (count < INT64_C(0))
    {
        (*result_0) = -INT64_C(1);
        (*result_1_0001) = 0.0;
        (*result_2) = -1.0;
        return 0;
    }
    hold = (*cspan_at(&problem, INT64_C(5))) - duration;
    count = insert_hold(phases, count, row, 0.0, hold);
    (*result_0) = count;
    (*result_1_0001) = y + cruise * hold;
    (*result_2) = hold;
    return 0;
}
static double distance_within(double change, array_double_1d problem)
{
    double result;
    result = 2.0 * (*cspan_at(&problem, INT64_C(5))) * fabs(change);
    return result;
}
static double cruise_range(array_double_2d phases, double middle, double y, double hold, array_double_1d problem, array_double_1d axis)
{
    double distance;
    double limit;
    double outside;
    bool failed;
    double missing;
    double cruise;
    int64_t i;
    int64_t count;
    double y_cruise;
    double inside;
    distance = (*cspan_at(&problem, INT64_C(4)));
    limit = speed_bound(1.0, (*cspan_at(&problem, INT64_C(5))), problem, axis);
    if (y > distance)
    {
        limit = -speed_bound(-1.0, (*cspan_at(&problem, INT64_C(5))), problem, axis);
    }
    inside = middle;
    outside = limit;
    failed = 0;
    missing = distance - y;
    cruise = middle + 2.5 * missing / ((*cspan_at(&problem, INT64_C(5))) + hold);
    if (cruise * limit > limit * limit)
    {
        cruise = limit;
    }
    for (i = INT64_C(0); i < INT64_C(30); i += INT64_C(1))
    {
        if (fabs(missing) > distance_within(outside - inside, problem))
        {
            break;
        }
        timed_cruise(&count, &y_cruise, &hold, phases, cruise, problem, axis);
        if ((count >= INT64_C(0)) && (hold >= 0.0))
        {
            inside = cruise;
            if (((y_cruise - distance) * missing >= 0.0) || (cruise == limit))
            {
                break;
            }
            missing = distance - y_cruise;
        }
        else
        {
            outside = cruise;
            failed = 1;
        }
        cruise = limit;
        if (failed)
        {
            cruise = 0.5 * (inside + outside);
            if ((cruise == inside) || (cruise == outside))
            {
                break;
            }
        }
    }
    return inside;
}
static void keep_nearest(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_2d trial;
    array_double_1d nearest;
    double distance;
    double target;
    double most;
    double duration;
    double y;
    double end;
    double lowest;
    double highest;
    bool below;
    bool above;
    if (count <= INT64_C(0))
    {
        return;
    }
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    nearest = span_row(&work, INT64_C(58));
    distance = (*cspan_at(&problem, INT64_C(4)));
    target = (*cspan_at(&problem, INT64_C(5)));
    most = slowest_velocity(axis) * (1.0 + 1e-12);
    segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, trial, count, (*cspan_at(&problem, INT64_C(0))), most, axis);
    if (is_beyond(lowest, highest, 1.0 + 1e-12, axis))
    {
        return;
    }
    if (fabs(duration - target) > 3e-11 * target)
    {
        return;
    }
    if (fabs(end - (*cspan_at(&problem, INT64_C(2)))) > 1e-11 * span_max(-lowest, highest))
    {
        return;
    }
    below = (*cspan_at(&nearest, INT64_C(0))) > 0.0;
    if ((y <= distance) && ((!below) || (y > (*cspan_at(&nearest, INT64_C(1))))))
    {
        copy_phases(trial, span_rows(&cell, INT64_C(0), INT64_C(33)), count);
        (*cspan_at(&nearest, INT64_C(0))) = count;
        (*cspan_at(&nearest, INT64_C(1))) = y;
    }
    above = (*cspan_at(&nearest, INT64_C(2))) > 0.0;
    if ((y >= distance) && ((!above) || (y < (*cspan_at(&nearest, INT64_C(3))))))
    {
        copy_phases(trial, span_rows(&cell, INT64_C(33), INT64_C(66)), count);
        (*cspan_at(&nearest, INT64_C(2))) = count;
        (*cspan_at(&nearest, INT64_C(3))) = y;
    }
}
static bool is_enclosed(array_double_2d work)
{
    array_double_1d nearest;
    bool result;
    nearest = span_row(&work, INT64_C(58));
    result = ((*cspan_at(&nearest, INT64_C(0))) > 0.0) && ((*cspan_at(&nearest, INT64_C(2))) > 0.0);
    return result;
}
static double keep_cruise(double cruise, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_2d trial;
    int64_t count;
    double hold;
    double y;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    timed_cruise(&count, &y, &hold, trial, cruise, problem, axis);
    keep_nearest(count, problem, axis, cell, work);
    return y;
}
static void between_cruises(double lower, double upper, double e_lower, double e_upper, array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    double distance;
    double newest;
    double other;
    double before;
    double e_newest;
    double e_other;
    double e_before;
    double speed;
    double rounding;
    int64_t i;
    double share;
    double cruise;
    double error;
    distance = (*cspan_at(&problem, INT64_C(4)));
    newest = upper;
    other = lower;
    before = lower;
    e_newest = e_upper;
    e_other = e_lower;
    e_before = e_other;
    speed = fabs((*cspan_at(&problem, INT64_C(0)))) + fabs((*cspan_at(&problem, INT64_C(2))));
    rounding = 2e-15 * (fabs(distance) + speed * (*cspan_at(&problem, INT64_C(5))));
    for (i = INT64_C(0); i < INT64_C(100); i += INT64_C(1))
    {
        if ((e_newest == 0.0) || (e_other == 0.0))
        {
            return;
        }
        share = root_share(newest, other, before, e_newest, e_other, e_before);
        if (i == INT64_C(0))
        {
            share = e_newest / (e_newest - e_other);
        }
        cruise = newest + share * (other - newest);
        if ((cruise == newest) || (cruise == other))
        {
            return;
        }
        error = keep_cruise(cruise, problem, axis, cell, work) - distance;
        if (fabs(error) <= rounding)
        {
            return;
        }
        next_bracket(&other, &before, &e_other, &e_before, error * e_newest < 0.0, newest, other, e_newest, e_other);
        newest = cruise;
        e_newest = error;
    }
}
static double cruise_edge(double inside, double outside, double h_inside, double h_outside, array_double_2d phases, array_double_1d problem, array_double_1d axis)
{
    double newest;
    double other;
    double before;
    double h_newest;
    double h_other;
    double h_before;
    double width;
    int64_t i;
    double share;
    double cruise;
    int64_t count;
    double y;
    double hold;
    bool fits;
    newest = outside;
    other = inside;
    before = inside;
    h_newest = h_outside;
    h_other = h_inside;
    h_before = h_inside;
    width = 1e-10 * fabs(outside - inside);
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        if (fabs(outside - inside) <= width)
        {
            break;
        }
        share = root_share(newest, other, before, h_newest, h_other, h_before);
        cruise = newest + share * (other - newest);
        if ((cruise == newest) || (cruise == other))
        {
            break;
        }
        timed_cruise(&count, &y, &hold, phases, cruise, problem, axis);
        fits = (count >= INT64_C(0)) && (hold >= 0.0);
        if (count < INT64_C(0))
        {
            hold = 0.0;
        }
        next_bracket(&other, &before, &h_other, &h_before, fits != (newest == inside), newest, other, h_newest, h_other);
        newest = cruise;
        h_newest = hold;
        if (fits)
        {
            inside = cruise;
            if (hold <= 1e-12 * (*cspan_at(&problem, INT64_C(5))))
            {
                break;
            }
        }
        else
        {
            outside = cruise;
        }
    }
    return inside;
}
static void scan_cruises(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_2d trial;
    double distance;
    double fastest;
    double backwards;
    int64_t samples;
    bool inside;
    double before;
    double e_before;
    double h_before;
    int64_t i;
    double cruise;
    int64_t count;
    double y;
    double hold;
    double error;
    bool fits;
    double lower;
    double e_lower;
    double upper;
    double e_upper;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    distance = (*cspan_at(&problem, INT64_C(4)));
    fastest = speed_bound(1.0, (*cspan_at(&problem, INT64_C(5))), problem, axis);
    backwards = speed_bound(-1.0, (*cspan_at(&problem, INT64_C(5))), problem, axis);
    samples = INT64_C(24);
    inside = 0;
    before = 0.0;
    e_before = 0.0;
    h_before = 0.0;
    for (i = INT64_C(0); i < samples + INT64_C(1); i += INT64_C(1))
    {
        cruise = fastest * (2.0 * i / samples - 1.0);
        if (cruise < 0.0)
        {
            cruise = backwards * (2.0 * i / samples - 1.0);
        }
        timed_cruise(&count, &y, &hold, trial, cruise, problem, axis);
        error = y - distance;
        fits = (count >= INT64_C(0)) && (hold >= 0.0);
        if (count < INT64_C(0))
        {
            hold = 0.0;
        }
        if (fits)
        {
            keep_nearest(count, problem, axis, cell, work);
        }
        if ((i > INT64_C(0)) && (inside || fits))
        {
            lower = before;
            e_lower = e_before;
            upper = cruise;
            e_upper = error;
            if (!inside)
            {
                lower = cruise_edge(cruise, before, hold, h_before, trial, problem, axis);
                e_lower = keep_cruise(lower, problem, axis, cell, work) - distance;
            }
            if (!fits)
            {
                upper = cruise_edge(before, cruise, h_before, hold, trial, problem, axis);
                e_upper = keep_cruise(upper, problem, axis, cell, work) - distance;
            }
            if (e_lower * e_upper <= 0.0)
            {
                between_cruises(lower, upper, e_lower, e_upper, problem, axis, cell, work);
            }
            if (is_enclosed(work))
            {
                return;
            }
        }
        inside = fits;
        before = cruise;
        e_before = error;
        h_before = hold;
    }
}
static int64_t loop_excess(double* result_0, double* result_1, int64_t arc, double place, double missing, double largest, array_double_1d family, array_double_1d axis)
{
    double part;
    double side;
    double duration;
    double y;
    double error;
    double speed;
    (*cspan_at(&family, INT64_C(33))) = 1.0;
    (*cspan_at(&family, INT64_C(34))) = 0.0;
    if ((arc == INT64_C(0)) || (arc == INT64_C(6)))
    {
        if (loop_radius(arc, place, missing, largest, family, axis) < 0.0)
        {
            (*result_0) = -1.0;
            (*result_1) = 0.0;
            return 0;
        }
    }
    else if (arc == INT64_C(5))
    {
        (*cspan_at(&family, INT64_C(34))) = 0.25 * place;
        if (!slow_middle(0.0, 0.0, family, axis))
        {
            (*result_0) = -1.0;
            (*result_1) = 0.0;
            return 0;
        }
    }
    else
    {
        if ((arc == INT64_C(3)) || (arc == INT64_C(4)))
        {
            (*cspan_at(&family, INT64_C(34))) = 1.0;
        }
        part = 0.5 * place - 1.0;
        side = 0.0;
        if (part < 0.0)
        {
            side = 2.0;
        }
        if ((arc == INT64_C(2)) || (arc == INT64_C(4)))
        {
            side = side + 1.0;
        }
        if (!slow_middle(side, largest * part * part, family, axis))
        {
            (*result_0) = -1.0;
            (*result_1) = 0.0;
            return 0;
        }
    }
    member_distance(&duration, &y, family, axis);
    if ((*cspan_at(&family, INT64_C(15))) > 0.5)
    {
        error = duration - (*cspan_at(&family, INT64_C(16)));
        if (fabs(error) <= 1e-15 * duration)
        {
            error = 0.0;
        }
        (*result_0) = duration;
        (*result_1) = error;
        return 0;
    }
    error = y - (*cspan_at(&family, INT64_C(16)));
    speed = fabs((*cspan_at(&family, INT64_C(0)))) + fabs((*cspan_at(&family, INT64_C(2)))) + top_acceleration(axis) * duration;
    if (fabs(error) <= 2e-13 * (fabs(y) + span_min(fastest_velocity(axis), speed) * duration))
    {
        error = 0.0;
    }
    (*result_0) = duration;
    (*result_1) = error;
    return 0;
}
static double loop_root(int64_t arc, double lower, double upper, double e_lower, double e_upper, double missing, double largest, array_double_1d family, array_double_1d axis)
{
    double place;
    double error;
    double newest;
    double other;
    double before;
    double e_newest;
    double e_other;
    double e_before;
    int64_t i;
    double share;
    double duration;
    if ((e_lower == 0.0) || (e_upper == 0.0))
    {
        place = upper;
        if (e_lower == 0.0)
        {
            place = lower;
        }
        loop_excess(&duration, &error, arc, place, missing, largest, family, axis);
        return duration;
    }
    newest = upper;
    other = lower;
    before = lower;
    e_newest = e_upper;
    e_other = e_lower;
    e_before = e_lower;
    duration = -1.0;
    for (i = INT64_C(0); i < INT64_C(100); i += INT64_C(1))
    {
        share = root_share(newest, other, before, e_newest, e_other, e_before);
        place = newest + share * (other - newest);
        if ((place == newest) || (place == other))
        {
            break;
        }
        loop_excess(&duration, &error, arc, place, missing, largest, family, axis);
        if (duration < 0.0)
        {
            return -1.0;
        }
        next_bracket(&other, &before, &e_other, &e_before, error * e_newest < 0.0, newest, other, e_newest, e_other);
        newest = place;
        e_newest = error;
        if (error == 0.0)
        {
            break;
        }
    }
    return duration;
}
static int64_t arc_root(int64_t* result_0, double* result_1, int64_t arc, int64_t sample, double missing, double largest, array_double_1d family, array_double_1d axis)
{
    int64_t samples;
    double place;
    double duration;
    double e_place;
    bool known;
    int64_t i;
    double before;
    double e_before;
    bool was_known;
    double other;
    double e_other;
    double inside;
    double e_inside;
    double outside;
    int64_t j;
    double middle;
    double error;
    samples = INT64_C(48);
    place = 4.0 * sample / samples;
    loop_excess(&duration, &e_place, arc, place, missing, largest, family, axis);
    known = duration >= 0.0;
    for (i = sample + INT64_C(1); i < samples + INT64_C(1); i += INT64_C(1))
    {
        before = place;
        e_before = e_place;
        was_known = known;
        place = 4.0 * i / samples;
        loop_excess(&duration, &e_place, arc, place, missing, largest, family, axis);
        known = duration >= 0.0;
        if ((!known) && (!was_known))
        {
            continue;
        }
        other = before;
        e_other = e_before;
        inside = place;
        e_inside = e_place;
        if (known != was_known)
        {
            outside = before;
            other = place;
            e_other = e_place;
            if (was_known)
            {
                outside = place;
                other = before;
                e_other = e_before;
            }
            inside = other;
            e_inside = e_other;
            for (j = INT64_C(0); j < INT64_C(12); j += INT64_C(1))
            {
                middle = 0.5 * (inside + outside);
                loop_excess(&duration, &error, arc, middle, missing, largest, family, axis);
                if (duration < 0.0)
                {
                    outside = middle;
                }
                else
                {
                    inside = middle;
                    e_inside = error;
                    if (error * e_other <= 0.0)
                    {
                        break;
                    }
                }
            }
        }
        if ((other != inside) && (e_other * e_inside <= 0.0))
        {
            duration = loop_root(arc, other, inside, e_other, e_inside, missing, largest, family, axis);
            if (duration >= 0.0)
            {
                (*result_0) = i;
                (*result_1) = duration;
                return 0;
            }
        }
    }
    (*result_0) = -INT64_C(1);
    (*result_1) = -1.0;
    return 0;
}
static int64_t loop_form(int64_t last, int64_t count, double longest, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d family;
    array_double_2d trial;
    double missing;
    double given;
    int64_t arc;
    int64_t sample;
    double duration;
    int64_t used;
    family = span_row(&work, INT64_C(98));
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    missing = set_loop(problem, axis, family);
    given = longest;
    for (arc = INT64_C(0); arc < last + INT64_C(1); arc += INT64_C(1))
    {
        if ((arc == INT64_C(6)) && (longest < given))
        {
            break;
        }
        sample = INT64_C(0);
        while((sample >= INT64_C(0)) && (sample < INT64_C(48)))
        {
            arc_root(&sample, &duration, arc, sample, missing, given, family, axis);
            if ((sample >= INT64_C(0)) && (duration < longest))
            {
                used = write_member(trial, family, axis);
                duration = valid_duration(trial, used, problem, axis);
                if ((duration >= 0.0) && (duration < longest * (1.0 - 1e-10)))
                {
                    copy_phases(trial, phases, used);
                    count = used;
                    longest = duration;
                }
            }
        }
    }
    return count;
}
static void timed_loop(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d family;
    double target;
    double missing;
    int64_t arc;
    int64_t sample;
    double duration;
    int64_t used;
    family = span_row(&work, INT64_C(98));
    target = (*cspan_at(&problem, INT64_C(5)));
    missing = set_loop(problem, axis, family);
    (*cspan_at(&family, INT64_C(15))) = 1.0;
    (*cspan_at(&family, INT64_C(16))) = target;
    for (arc = INT64_C(0); arc < INT64_C(5) + INT64_C(1); arc += INT64_C(1))
    {
        sample = INT64_C(0);
        while((sample >= INT64_C(0)) && (sample < INT64_C(48)))
        {
            arc_root(&sample, &duration, arc, sample, missing, target, family, axis);
            if (sample >= INT64_C(0))
            {
                used = write_member(span_rows(&work, INT64_C(0), INT64_C(21)), family, axis);
                keep_nearest(used, problem, axis, cell, work);
            }
        }
        if (is_enclosed(work))
        {
            return;
        }
    }
}
static int64_t next_loop(int64_t* result_0_0001, double* result_1_0001, int64_t arc, int64_t sample, double longest, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d family;
    array_double_2d trial;
    double missing;
    double duration;
    int64_t used;
    family = span_row(&work, INT64_C(98));
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    missing = set_loop(problem, axis, family);
    arc_root(&sample, &duration, arc, sample, missing, longest, family, axis);
    if (sample < INT64_C(0))
    {
        (*result_0_0001) = -INT64_C(1);
        (*result_1_0001) = -1.0;
        return 0;
    }
    used = write_member(trial, family, axis);
    (*result_0_0001) = sample;
    (*result_1_0001) = valid_duration(trial, used, problem, axis);
    return 0;
}
static double taylor_value(int64_t order, int64_t top, double t, array_double_1d state)
{
    double power;
    int64_t i;
    double value;
    value = (*cspan_at(&state, order));
    power = 1.0;
    for (i = order + INT64_C(1); i < top + INT64_C(1); i += INT64_C(1))
    {
        power = power * (t / (i - order));
        value = value + power * (*cspan_at(&state, i));
    }
    return value;
}
static double zero_time(int64_t order, int64_t top, double length, array_double_1d state)
{
    double lower;
    double upper;
    int64_t i;
    double value;
    double step;
    double slope;
    double newton;
    double t;
    lower = 0.0;
    upper = length;
    t = 0.5 * length;
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        value = taylor_value(order, top, t, state);
        if (value * (*cspan_at(&state, order)) > 0.0)
        {
            lower = t;
        }
        else
        {
            upper = t;
        }
        step = 0.5 * (lower + upper) - t;
        slope = taylor_value(order + INT64_C(1), top, t, state);
        if (slope != 0.0)
        {
            newton = (-value) / slope;
            if ((t + newton > lower) && (t + newton < upper))
            {
                step = newton;
            }
        }
        t = t + step;
        if (fabs(step) <= 1e-07 * length)
        {
            break;
        }
    }
    return t;
}
static void advance_piece(int64_t top, double length, array_double_1d state, array_double_1d end)
{
    int64_t order;
    double power;
    int64_t j;
    for (order = INT64_C(0); order < top + INT64_C(1); order += INT64_C(1))
    {
        (*cspan_at(&end, order)) = (*cspan_at(&state, order));
    }
    power = 1.0;
    for (j = INT64_C(1); j < top + INT64_C(1); j += INT64_C(1))
    {
        power = power * (length / j);
        for (order = INT64_C(0); order < top + INT64_C(1) - j; order += INT64_C(1))
        {
            (*cspan_at(&end, order)) = (*cspan_at(&end, order)) + power * (*cspan_at(&state, order + j));
        }
    }
}
static void note_excess(int64_t q, int64_t node, bool holding, array_double_1d axis, array_double_1d end, array_double_2d excess)
{
    int64_t order;
    double limit;
    double share;
    for (order = INT64_C(1); order < q; order += INT64_C(1))
    {
        limit = side_limit(order, (*cspan_at(&end, order)), axis);
        if (limit > 0.0)
        {
            share = fabs((*cspan_at(&end, order))) / limit - 1.0;
            if (share > span_max((*cspan_at(&excess, order, INT64_C(0))), 1e-10))
            {
                (*cspan_at(&excess, order, INT64_C(0))) = share;
                (*cspan_at(&excess, order, INT64_C(1))) = node;
                (*cspan_at(&excess, order, INT64_C(2))) = holding;
                (*cspan_at(&excess, order, INT64_C(3))) = 1.0;
                if ((*cspan_at(&end, order)) < 0.0)
                {
                    (*cspan_at(&excess, order, INT64_C(3))) = -1.0;
                }
            }
        }
    }
}
static void piece_excess(double length, int64_t node, bool holding, array_double_1d axis, array_double_2d work)
{
    array_double_1d state;
    array_double_1d end;
    array_double_2d excess;
    int64_t q;
    int64_t top;
    double rest;
    int64_t i;
    double step;
    int64_t j;
    int64_t order;
    state = span_row(&work, INT64_C(203));
    end = span_row(&work, INT64_C(203) + INT64_C(1));
    excess = span_rows(&work, INT64_C(196), INT64_C(202));
    q = (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1)))) + INT64_C(2);
    top = (int64_t)((*cspan_at(&axis, INT64_C(0)))) + INT64_C(1);
    rest = length;
    for (i = INT64_C(0); i < INT64_C(16); i += INT64_C(1))
    {
        step = rest;
        advance_piece(top, step, state, end);
        for (j = INT64_C(0); j < q - INT64_C(1); j += INT64_C(1))
        {
            order = q - j;
            if ((*cspan_at(&state, order)) * (*cspan_at(&end, order)) < 0.0)
            {
                step = zero_time(order, top, step, state);
                advance_piece(top, step, state, end);
                (*cspan_at(&end, order)) = 0.0;
            }
        }
        note_excess(q, node, holding, axis, end, excess);
        for (order = INT64_C(0); order < top + INT64_C(1); order += INT64_C(1))
        {
            (*cspan_at(&state, order)) = (*cspan_at(&end, order));
        }
        rest = rest - step;
        if (rest <= 0.0)
        {
            break;
        }
    }
}
static bool measure_excess(array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d excess;
    array_double_1d state;
    int64_t above;
    int64_t q;
    int64_t boxes;
    double level;
    int64_t pieces;
    int64_t order;
    int64_t i;
    int64_t row;
    double ramp;
    double change;
    int64_t piece;
    int64_t held;
    double sign;
    double basis;
    double length;
    double peak;
    passing = span_row(&work, INT64_C(101));
    excess = span_rows(&work, INT64_C(196), INT64_C(202));
    state = span_row(&work, INT64_C(203));
    above = (int64_t)((*cspan_at(&passing, INT64_C(1))));
    q = above + INT64_C(2);
    boxes = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(1) - above;
    level = (*cspan_at(&passing, INT64_C(8)));
    pieces = rise_pieces(boxes);
    for (order = INT64_C(0); order < INT64_C(4); order += INT64_C(1))
    {
        (*cspan_at(&excess, order, INT64_C(0))) = 0.0;
    }
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&passing, INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        row = INT64_C(102) + i;
        for (order = INT64_C(0); order < INT64_C(8); order += INT64_C(1))
        {
            (*cspan_at(&state, order)) = 0.0;
            if (order < q)
            {
                (*cspan_at(&state, order)) = (*cspan_at(&work, row, INT64_C(0) + order));
            }
        }
        (*cspan_at(&state, q)) = level;
        ramp = (*cspan_at(&work, row, INT64_C(11)));
        change = (*cspan_at(&work, row, INT64_C(9))) - level;
        if (ramp > 0.0)
        {
            for (piece = INT64_C(1); piece < pieces + INT64_C(1); piece += INT64_C(1))
            {
                held_level(&held, &sign, piece, boxes);
                basis = ramp * (*cspan_at(&passing, INT64_C(2)));
                piece_peak(&length, &peak, held, above, change, ramp, basis, axis);
                for (order = q + INT64_C(1) + held; order < INT64_C(8); order += INT64_C(1))
                {
                    (*cspan_at(&state, order)) = 0.0;
                }
                (*cspan_at(&state, q + INT64_C(1) + held)) = sign * peak;
                if (length > 0.0)
                {
                    piece_excess(length, i, 0, axis, work);
                }
            }
        }
        level = (*cspan_at(&work, row, INT64_C(9)));
        if ((*cspan_at(&work, row, INT64_C(10))) > 0.0)
        {
            for (order = q; order < INT64_C(8); order += INT64_C(1))
            {
                (*cspan_at(&state, order)) = 0.0;
            }
            (*cspan_at(&state, q)) = level;
            piece_excess((*cspan_at(&work, row, INT64_C(10))), i, 1, axis, work);
        }
    }
    for (order = INT64_C(1); order < q; order += INT64_C(1))
    {
        if ((*cspan_at(&excess, order, INT64_C(0))) > 0.0)
        {
            return 1;
        }
    }
    return 0;
}
static double power_term(double t, double sixth)
{
    return t * t * t * t * t * t * sixth / 720.0;
}
static double highest_in_piece(double length, double value, double first, double second, double third, double fourth, double fifth, double sixth)
{
    double end;
    double slope;
    double at;
    double highest;
    end = length;
    highest = value + taylor(end, first, second, third, fourth, fifth);
    highest = highest + power_term(end, sixth);
    slope = first + taylor(end, second, third, fourth, fifth, sixth);
    if ((first > 0.0) && (slope < 0.0))
    {
        end = crossing_time(first, length, second, third, fourth, fifth, sixth);
        at = value + taylor(end, first, second, third, fourth, fifth);
        highest = span_max(highest, at + power_term(end, sixth));
    }
    return highest;
}
static double highest_at_node(int64_t order, double sign, int64_t i, array_double_1d passing, array_double_1d axis, array_double_2d nodes)
{
    int64_t above;
    int64_t boxes;
    double before;
    int64_t below;
    double upper;
    double lower;
    double lowest;
    double level;
    double slope;
    double curvature;
    double third;
    double ramp;
    double change;
    int64_t pieces;
    int64_t piece;
    double length;
    int64_t held;
    double direction;
    double basis;
    double peak;
    double at;
    double highest;
    above = (int64_t)((*cspan_at(&passing, INT64_C(1))));
    boxes = (int64_t)((*cspan_at(&axis, INT64_C(0)))) - INT64_C(1) - above;
    before = (*cspan_at(&passing, INT64_C(8)));
    if (i > INT64_C(0))
    {
        before = (*cspan_at(&nodes, i - INT64_C(1), INT64_C(9)));
    }
    below = INT64_C(0) + above + INT64_C(1);
    upper = sign * (*cspan_at(&nodes, i, below));
    below = below - INT64_C(1);
    lower = sign * (*cspan_at(&nodes, i, below));
    below = below - INT64_C(1);
    lowest = sign * (*cspan_at(&nodes, i, below));
    level = sign * before;
    slope = 0.0;
    curvature = 0.0;
    third = 0.0;
    ramp = (*cspan_at(&nodes, i, INT64_C(11)));
    change = sign * ((*cspan_at(&nodes, i, INT64_C(9))) - before);
    highest = lowest;
    if (order == above)
    {
        highest = lower;
    }
    else if (order == above + INT64_C(1))
    {
        highest = upper;
    }
    pieces = rise_pieces(boxes);
    for (piece = INT64_C(1); piece < pieces + INT64_C(2); piece += INT64_C(1))
    {
        length = (*cspan_at(&nodes, i, INT64_C(10)));
        if (piece <= pieces)
        {
            length = 0.0;
            if (ramp > 0.0)
            {
                held_level(&held, &direction, piece, boxes);
                basis = ramp * (*cspan_at(&passing, INT64_C(2)));
                piece_peak(&length, &peak, held, above, change, ramp, basis, axis);
                if (held == INT64_C(0))
                {
                    slope = direction * peak;
                    curvature = 0.0;
                    third = 0.0;
                }
                else if (held == INT64_C(1))
                {
                    curvature = direction * peak;
                    third = 0.0;
                }
                else
                {
                    third = direction * peak;
                }
            }
        }
        else
        {
            level = sign * (*cspan_at(&nodes, i, INT64_C(9)));
            slope = 0.0;
            curvature = 0.0;
            third = 0.0;
        }
        if (length > 0.0)
        {
            at = highest_in_piece(length, lowest, lower, upper, level, slope, curvature, third);
            if (order == above)
            {
                at = highest_in_piece(length, lower, upper, level, slope, curvature, third, 0.0);
            }
            else if (order == above + INT64_C(1))
            {
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
static double instant_error(int64_t peak, array_double_1d passing, array_double_1d axis, array_double_2d nodes)
{
    int64_t order;
    int64_t first;
    int64_t last;
    double highest;
    int64_t i;
    double sign;
    double result;
    order = (int64_t)((*cspan_at(&passing, INT64_C(14) + peak)));
    first = span_max_int((int64_t)((*cspan_at(&passing, INT64_C(20) + peak))), INT64_C(0));
    last = (int64_t)((*cspan_at(&passing, INT64_C(23) + peak)));
    highest = -1e+300;
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&passing, INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        if ((i >= first) && (i <= last))
        {
            sign = (*cspan_at(&passing, INT64_C(17) + peak));
            highest = span_max(highest, highest_at_node(order, sign, i, passing, axis, nodes));
        }
    }
    result = highest - side_limit(order, (*cspan_at(&passing, INT64_C(17) + peak)), axis);
    return result;
}
static void shift_instants(int64_t place, int64_t by, array_double_1d passing)
{
    int64_t peak;
    for (peak = INT64_C(0); peak < (int64_t)((*cspan_at(&passing, INT64_C(13)))); peak += INT64_C(1))
    {
        if ((*cspan_at(&passing, INT64_C(20) + peak)) >= place)
        {
            (*cspan_at(&passing, INT64_C(20) + peak)) = (*cspan_at(&passing, INT64_C(20) + peak)) + by;
        }
        if ((*cspan_at(&passing, INT64_C(23) + peak)) >= place)
        {
            (*cspan_at(&passing, INT64_C(23) + peak)) = (*cspan_at(&passing, INT64_C(23) + peak)) + by;
        }
    }
}
static void place_instant(int64_t peak, int64_t order, double sign, int64_t node, array_double_1d passing)
{
    (*cspan_at(&passing, INT64_C(14) + peak)) = order;
    (*cspan_at(&passing, INT64_C(17) + peak)) = sign;
    (*cspan_at(&passing, INT64_C(20) + peak)) = node - INT64_C(1);
    (*cspan_at(&passing, INT64_C(23) + peak)) = node + INT64_C(1);
}
static void add_instant(int64_t order, double sign, int64_t node, array_double_1d passing)
{
    int64_t peak;
    peak = (int64_t)((*cspan_at(&passing, INT64_C(13))));
    place_instant(peak, order, sign, node, passing);
    (*cspan_at(&passing, INT64_C(13))) = peak + INT64_C(1);
}
static double power_of(double base, int64_t exponent)
{
    int64_t i;
    double power;
    power = 1.0;
    for (i = INT64_C(0); i < exponent; i += INT64_C(1))
    {
        power = power * base;
    }
    return power;
}
static void set_level(array_double_1d node, array_double_1d passing, array_double_1d axis)
{
    int64_t above;
    int64_t kind;
    double pace;
    double time;
    double sign;
    double rise;
    double most;
    double change;
    double slope;
    above = (int64_t)((*cspan_at(&passing, INT64_C(1))));
    kind = (int64_t)((*cspan_at(&node, INT64_C(4))));
    pace = (*cspan_at(&passing, INT64_C(2)));
    time = (*cspan_at(&node, INT64_C(6)));
    (*cspan_at(&node, INT64_C(9))) = 0.0;
    (*cspan_at(&node, INT64_C(10))) = time;
    if ((*cspan_at(&node, INT64_C(7))) > 0.5)
    {
        return;
    }
    if ((kind > INT64_C(0)) && ((kind != above) || (time >= 0.0)))
    {
        return;
    }
    sign = (*cspan_at(&node, INT64_C(5))) * power_of(pace, above + INT64_C(2));
    if (time < 0.0)
    {
        sign = -sign;
    }
    rise = fabs(time);
    (*cspan_at(&node, INT64_C(10))) = 0.0;
    most = (*cspan_at(&axis, INT64_C(21) + above - INT64_C(1)));
    if (rise >= most)
    {
        (*cspan_at(&node, INT64_C(9))) = sign * (*cspan_at(&axis, INT64_C(4) + above - INT64_C(1)));
        (*cspan_at(&node, INT64_C(10))) = (rise - most) / pace;
    }
    else if (rise > 0.0)
    {
        plateau_change(&change, &slope, rise, above, axis);
        (*cspan_at(&node, INT64_C(9))) = sign * change;
    }
}
static void advance(double time, double level, double change, double variance, double fourth, int64_t above, array_double_1d state)
{
    double half;
    double moment;
    double second;
    double third;
    double last;
    int64_t k;
    int64_t order;
    double total;
    int64_t farthest;
    double square;
    half = 0.5 * time;
    moment = half;
    second = half * time;
    third = second * time / 3.0;
    last = 0.25 * third * time;
    for (k = INT64_C(0); k < above + INT64_C(2); k += INT64_C(1))
    {
        order = above + INT64_C(2) - k;
        total = (*cspan_at(&state, k));
        if (order == INT64_C(4))
        {
            total = total + time * (*cspan_at(&state, k + INT64_C(1))) + second * (*cspan_at(&state, k + INT64_C(2)));
            farthest = k + INT64_C(3);
            total = total + third * (*cspan_at(&state, farthest));
        }
        else if (order == INT64_C(3))
        {
            total = total + time * (*cspan_at(&state, k + INT64_C(1))) + second * (*cspan_at(&state, k + INT64_C(2)));
            last = third;
        }
        else if (order == INT64_C(2))
        {
            total = total + time * (*cspan_at(&state, k + INT64_C(1)));
            last = second;
        }
        else
        {
            last = time;
        }
        total = total + last * level;
        if (change != 0.0)
        {
            square = half * half;
            if (order == INT64_C(1))
            {
                moment = half;
            }
            else if (order == INT64_C(2))
            {
                moment = 0.5 * (square + variance);
            }
            else if (order == INT64_C(3))
            {
                moment = half * (square + 3.0 * variance) / 6.0;
            }
            else
            {
                moment = square * (square + 6.0 * variance) + 3.0 * variance * variance;
                moment = (moment + fourth) / 24.0;
            }
            total = total + change * moment;
        }
        (*cspan_at(&state, k)) = total;
    }
}
static void pass_node(int64_t i, array_double_1d passing, array_double_1d axis, array_double_2d nodes)
{
    int64_t above;
    double pace;
    double before;
    double change;
    int64_t k;
    double basis;
    double slope;
    double variance;
    double fourth;
    double square;
    above = (int64_t)((*cspan_at(&passing, INT64_C(1))));
    pace = (*cspan_at(&passing, INT64_C(2)));
    before = (*cspan_at(&passing, INT64_C(8)));
    if (i > INT64_C(0))
    {
        before = (*cspan_at(&nodes, i - INT64_C(1), INT64_C(9)));
    }
    change = (*cspan_at(&nodes, i, INT64_C(9))) - before;
    for (k = INT64_C(0); k < above + INT64_C(2); k += INT64_C(1))
    {
        (*cspan_at(&nodes, i + INT64_C(1), INT64_C(0) + k)) = (*cspan_at(&nodes, i, INT64_C(0) + k));
    }
    (*cspan_at(&nodes, i, INT64_C(11))) = 0.0;
    if (change != 0.0)
    {
        plateau_duration(&basis, &slope, fabs(change) / power_of(pace, above + INT64_C(2)), above, axis);
        rise_moments(&variance, &fourth, basis, above, axis);
        square = 1.0 / (pace * pace);
        (*cspan_at(&nodes, i, INT64_C(11))) = basis / pace;
        advance(basis / pace, before, change, variance * square, fourth * square * square, above, span_row(&nodes, i + INT64_C(1)));
    }
}
static int64_t dropped_condition(int64_t q, array_double_1d node)
{
    int64_t result;
    if ((*cspan_at(&node, INT64_C(7))) > 1.5)
    {
        result = (int64_t)((*cspan_at(&node, INT64_C(4))));
        return result;
    }
    if ((*cspan_at(&node, INT64_C(7))) > 0.5)
    {
        return q - INT64_C(1);
    }
    return -INT64_C(1);
}
static double residual_scale(int64_t order, array_double_1d passing, array_double_1d axis)
{
    double acceleration;
    double time;
    double speed;
    acceleration = (*cspan_at(&passing, INT64_C(4)));
    time = (*cspan_at(&passing, INT64_C(3)));
    if (order > INT64_C(1))
    {
        speed = acceleration / power_of(span_min(time, (*cspan_at(&axis, INT64_C(13)))), order - INT64_C(2));
        return speed;
    }
    speed = span_min(fastest_velocity(axis), acceleration * time);
    if (order == INT64_C(1))
    {
        return speed;
    }
    return speed * time;
}
static int64_t node_residuals(int64_t i, int64_t row, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual)
{
    int64_t q;
    int64_t kind;
    int64_t dropped;
    int64_t k;
    double error;
    double sign;
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    kind = (int64_t)((*cspan_at(&nodes, i, INT64_C(4))));
    dropped = dropped_condition(q, span_row(&nodes, i));
    if (kind == INT64_C(0))
    {
        return row;
    }
    for (k = kind; k < q; k += INT64_C(1))
    {
        error = (*cspan_at(&nodes, i + INT64_C(1), INT64_C(0) + k));
        if (k == kind)
        {
            sign = (*cspan_at(&nodes, i, INT64_C(5)));
            error = error - sign * side_limit(kind, sign, axis);
        }
        (*cspan_at(&residual, INT64_C(0) + row)) = error / residual_scale(k, passing, axis);
        if (k == dropped)
        {
            error = (*cspan_at(&nodes, i, INT64_C(6))) - (*cspan_at(&nodes, i, INT64_C(8)));
            (*cspan_at(&residual, INT64_C(0) + row)) = error / (*cspan_at(&passing, INT64_C(3)));
        }
        row = row + INT64_C(1);
    }
    return row;
}
static bool stays_at_limit(array_double_1d node)
{
    bool result;
    result = ((*cspan_at(&node, INT64_C(4))) > 0.5) && ((*cspan_at(&node, INT64_C(7))) < 0.5) && ((*cspan_at(&node, INT64_C(9))) == 0.0);
    return result;
}
static void hold_limit(int64_t q, array_double_1d node, array_double_1d axis, array_double_1d state)
{
    int64_t kind;
    int64_t k;
    if (stays_at_limit(node))
    {
        kind = (int64_t)((*cspan_at(&node, INT64_C(4))));
        (*cspan_at(&state, INT64_C(0) + kind)) = (*cspan_at(&node, INT64_C(5))) * side_limit(kind, (*cspan_at(&node, INT64_C(5))), axis);
        for (k = kind + INT64_C(1); k < q; k += INT64_C(1))
        {
            (*cspan_at(&state, INT64_C(0) + k)) = 0.0;
        }
    }
}
static int64_t first_row(int64_t node, array_double_1d passing, array_double_2d nodes)
{
    int64_t q;
    int64_t i;
    int64_t row;
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    row = INT64_C(0);
    for (i = INT64_C(0); i < node; i += INT64_C(1))
    {
        if ((*cspan_at(&nodes, i, INT64_C(4))) > 0.5)
        {
            row = row + q - (int64_t)((*cspan_at(&nodes, i, INT64_C(4))));
        }
    }
    return row;
}
static void end_residuals(int64_t row, array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_1d end, array_double_1d residual)
{
    int64_t k;
    double target;
    double error;
    for (k = INT64_C(0); k < (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2); k += INT64_C(1))
    {
        target = 0.0;
        if (k == INT64_C(0))
        {
            target = (*cspan_at(&problem, INT64_C(4)));
        }
        else if (k == INT64_C(1))
        {
            target = (*cspan_at(&problem, INT64_C(2)));
        }
        else if (k == INT64_C(2))
        {
            target = (*cspan_at(&problem, INT64_C(3)));
        }
        error = (*cspan_at(&end, INT64_C(0) + k)) - target;
        (*cspan_at(&residual, INT64_C(0) + row + k)) = error / residual_scale(k, passing, axis);
    }
}
static int64_t follow_node(int64_t i, int64_t row, array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual)
{
    int64_t q;
    double hold;
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    if (i == (int64_t)((*cspan_at(&passing, INT64_C(0)))))
    {
        (*cspan_at(&nodes, i, INT64_C(4))) = 0.0;
        (*cspan_at(&nodes, i, INT64_C(9))) = 0.0;
        (*cspan_at(&nodes, i, INT64_C(10))) = 0.0;
        pass_node(i, passing, axis, nodes);
        end_residuals(row, problem, passing, axis, span_row(&nodes, i + INT64_C(1)), residual);
        return row + q;
    }
    set_level(span_row(&nodes, i), passing, axis);
    pass_node(i, passing, axis, nodes);
    row = node_residuals(i, row, passing, axis, nodes, residual);
    hold = (*cspan_at(&nodes, i, INT64_C(10)));
    hold_limit(q, span_row(&nodes, i), axis, span_row(&nodes, i + INT64_C(1)));
    if (hold != 0.0)
    {
        advance(hold, (*cspan_at(&nodes, i, INT64_C(9))), 0.0, 0.0, 0.0, q - INT64_C(2), span_row(&nodes, i + INT64_C(1)));
    }
    return row;
}
static double sequence_duration(array_double_1d passing, array_double_2d nodes)
{
    int64_t i;
    double total;
    total = 0.0;
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&passing, INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        total = total + (*cspan_at(&nodes, i, INT64_C(11))) + (*cspan_at(&nodes, i, INT64_C(10)));
    }
    return total;
}
static void run_sequence(array_double_1d problem, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d residual)
{
    int64_t k;
    int64_t jerk;
    int64_t row;
    int64_t i;
    int64_t peak;
    double scale;
    double error;
    for (k = INT64_C(0); k < (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2); k += INT64_C(1))
    {
        (*cspan_at(&nodes, INT64_C(0), INT64_C(0) + k)) = 0.0;
    }
    (*cspan_at(&nodes, INT64_C(0), INT64_C(0) + INT64_C(1))) = (*cspan_at(&problem, INT64_C(0)));
    (*cspan_at(&nodes, INT64_C(0), INT64_C(0) + INT64_C(2))) = (*cspan_at(&problem, INT64_C(1)));
    jerk = INT64_C(0) + INT64_C(3);
    if ((*cspan_at(&passing, INT64_C(1))) > 1.5)
    {
        (*cspan_at(&nodes, INT64_C(0), jerk)) = (*cspan_at(&passing, INT64_C(9)));
    }
    row = INT64_C(0);
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&passing, INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        row = follow_node(i, row, problem, passing, axis, nodes, residual);
    }
    for (peak = INT64_C(0); peak < (int64_t)((*cspan_at(&passing, INT64_C(13)))); peak += INT64_C(1))
    {
        scale = residual_scale((int64_t)((*cspan_at(&passing, INT64_C(14) + peak))), passing, axis);
        error = instant_error(peak, passing, axis, nodes);
        (*cspan_at(&residual, INT64_C(0) + row)) = error / scale;
        row = row + INT64_C(1);
    }
    if ((*cspan_at(&passing, INT64_C(5))) > 0.0)
    {
        error = sequence_duration(passing, nodes) - (*cspan_at(&passing, INT64_C(5)));
        if ((*cspan_at(&passing, INT64_C(6))) != 0.0)
        {
            row = first_row((int64_t)((*cspan_at(&passing, INT64_C(0)))), passing, nodes);
        }
        (*cspan_at(&residual, INT64_C(0) + row)) = error / (*cspan_at(&passing, INT64_C(3)));
    }
}
static void follow_change(int64_t first, int64_t row, array_double_1d passing, array_double_1d axis, array_double_2d nodes, array_double_1d change, array_double_1d slopes)
{
    int64_t q;
    int64_t count;
    int64_t i;
    int64_t kind;
    int64_t dropped;
    int64_t k;
    double slope;
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    for (i = first; i < count + INT64_C(1); i += INT64_C(1))
    {
        advance((*cspan_at(&nodes, i, INT64_C(11))), 0.0, 0.0, 0.0, 0.0, q - INT64_C(2), change);
        kind = (int64_t)((*cspan_at(&nodes, i, INT64_C(4))));
        dropped = -INT64_C(1);
        if (i < count)
        {
            dropped = dropped_condition(q, span_row(&nodes, i));
        }
        if ((kind > INT64_C(0)) || (i == count))
        {
            for (k = kind; k < q; k += INT64_C(1))
            {
                slope = (*cspan_at(&change, INT64_C(0) + k)) / residual_scale(k, passing, axis);
                if (k == dropped)
                {
                    slope = 0.0;
                }
                (*cspan_at(&slopes, INT64_C(0) + row)) = slope;
                row = row + INT64_C(1);
            }
        }
        if (stays_at_limit(span_row(&nodes, i)))
        {
            for (k = kind; k < q; k += INT64_C(1))
            {
                (*cspan_at(&change, INT64_C(0) + k)) = 0.0;
            }
        }
        if ((*cspan_at(&nodes, i, INT64_C(10))) != 0.0)
        {
            advance((*cspan_at(&nodes, i, INT64_C(10))), 0.0, 0.0, 0.0, 0.0, q - INT64_C(2), change);
        }
    }
}
static bool is_square(array_double_1d passing, array_double_2d nodes)
{
    int64_t count;
    int64_t conditions;
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    conditions = first_row(count, passing, nodes) + (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    conditions = conditions + (int64_t)((*cspan_at(&passing, INT64_C(13))));
    return (conditions == count) && (count <= INT64_C(16));
}
static void begin_dip(int64_t above, double v, double a, array_double_2d work)
{
    array_double_1d passing;
    double sign;
    int64_t i;
    int64_t column;
    passing = span_row(&work, INT64_C(101));
    (*cspan_at(&passing, INT64_C(0))) = above + INT64_C(1);
    (*cspan_at(&passing, INT64_C(1))) = above;
    (*cspan_at(&passing, INT64_C(2))) = 1.0;
    (*cspan_at(&passing, INT64_C(8))) = 0.0;
    sign = -1.0;
    for (i = INT64_C(0); i < above + INT64_C(2); i += INT64_C(1))
    {
        for (column = INT64_C(0); column < INT64_C(12); column += INT64_C(1))
        {
            (*cspan_at(&work, INT64_C(102) + i, column)) = 0.0;
        }
        (*cspan_at(&work, INT64_C(102) + i, INT64_C(5))) = sign;
        sign = -sign;
    }
    (*cspan_at(&work, INT64_C(102), INT64_C(0) + INT64_C(1))) = v;
    (*cspan_at(&work, INT64_C(102), INT64_C(0) + INT64_C(2))) = a;
}
static double follow_dip(int64_t order, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    int64_t above;
    int64_t i;
    double hold;
    double result;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    above = (int64_t)((*cspan_at(&passing, INT64_C(1))));
    for (i = INT64_C(0); i < above + INT64_C(2); i += INT64_C(1))
    {
        if (i <= above)
        {
            set_level(span_row(&nodes, i), passing, axis);
        }
        pass_node(i, passing, axis, nodes);
        if ((*cspan_at(&nodes, i, INT64_C(10))) > 0.0)
        {
            hold = (*cspan_at(&nodes, i, INT64_C(10)));
            advance(hold, (*cspan_at(&nodes, i, INT64_C(9))), 0.0, 0.0, 0.0, above, span_row(&nodes, i + INT64_C(1)));
        }
    }
    result = (*cspan_at(&nodes, above + INT64_C(2), INT64_C(0) + order));
    return result;
}
static double last_jerk(double second, array_double_1d axis, array_double_2d work)
{
    double result;
    (*cspan_at(&work, INT64_C(102) + INT64_C(1), INT64_C(6))) = second;
    result = follow_dip(INT64_C(3), axis, work);
    return result;
}
static void balance_jerk(array_double_1d axis, array_double_2d work)
{
    double newest;
    double e_newest;
    double other;
    double e_other;
    int64_t i;
    double before;
    double e_before;
    double share;
    double second;
    double error;
    bool crossed;
    newest = (*cspan_at(&work, INT64_C(102), INT64_C(6)));
    e_newest = last_jerk(newest, axis, work);
    if (e_newest >= 0.0)
    {
        return;
    }
    other = 2.0 * newest;
    e_other = last_jerk(other, axis, work);
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        if (e_other >= 0.0)
        {
            break;
        }
        newest = other;
        e_newest = e_other;
        other = 2.0 * other;
        e_other = last_jerk(other, axis, work);
    }
    before = other;
    e_before = e_other;
    for (i = INT64_C(0); i < INT64_C(80); i += INT64_C(1))
    {
        share = root_share(newest, other, before, e_newest, e_other, e_before);
        second = newest + share * (other - newest);
        if ((second == newest) || (second == other) || (e_newest == 0.0))
        {
            break;
        }
        error = last_jerk(second, axis, work);
        crossed = error * e_newest <= 0.0;
        next_bracket(&other, &before, &e_other, &e_before, crossed, newest, other, e_newest, e_other);
        newest = second;
        e_newest = error;
    }
    (*cspan_at(&work, INT64_C(102) + INT64_C(1), INT64_C(6))) = newest;
}
static double last_excess(double time, double end, array_double_1d axis, array_double_2d work)
{
    int64_t above;
    double result;
    above = (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1))));
    (*cspan_at(&work, INT64_C(102) + above, INT64_C(6))) = time;
    if (above == INT64_C(2))
    {
        balance_jerk(axis, work);
    }
    result = follow_dip(INT64_C(2), axis, work) - end;
    return result;
}
static bool close_dip(double first, double end, array_double_1d axis, array_double_2d work)
{
    double newest;
    double e_newest;
    double other;
    double e_other;
    double before;
    double e_before;
    int64_t i;
    double share;
    double time;
    double error;
    bool crossed;
    (*cspan_at(&work, INT64_C(102), INT64_C(6))) = first;
    newest = 0.0;
    e_newest = last_excess(newest, end, axis, work);
    if (e_newest > 0.0)
    {
        return 0;
    }
    other = first;
    e_other = last_excess(other, end, axis, work);
    before = other;
    e_before = e_other;
    for (i = INT64_C(0); i < INT64_C(80); i += INT64_C(1))
    {
        share = root_share(newest, other, before, e_newest, e_other, e_before);
        time = newest + share * (other - newest);
        if ((time == newest) || (time == other) || (e_newest == 0.0))
        {
            break;
        }
        error = last_excess(time, end, axis, work);
        crossed = error * e_newest <= 0.0;
        next_bracket(&other, &before, &e_other, &e_before, crossed, newest, other, e_newest, e_other);
        newest = time;
        e_newest = error;
    }
    last_excess(newest, end, axis, work);
    return 1;
}
static int64_t judge_dip(bool* result_0, bool* result_1, double first, double end, array_double_1d axis, array_double_2d work)
{
    array_double_2d excess;
    bool fast;
    bool shallow;
    bool deep;
    int64_t order;
    excess = span_rows(&work, INT64_C(196), INT64_C(202));
    if (!close_dip(first, end, axis, work))
    {
        (*result_0) = 1;
        (*result_1) = 0;
        return 0;
    }
    if (!measure_excess(axis, work))
    {
        (*result_0) = 0;
        (*result_1) = 0;
        return 0;
    }
    fast = (*cspan_at(&excess, INT64_C(1), INT64_C(0))) > 0.0;
    shallow = fast && ((*cspan_at(&excess, INT64_C(1), INT64_C(3))) > 0.0);
    deep = fast && (!shallow);
    for (order = INT64_C(2); order < INT64_C(4); order += INT64_C(1))
    {
        deep = deep || ((*cspan_at(&excess, order, INT64_C(0))) > 0.0);
    }
    (*result_0) = shallow;
    (*result_1) = deep;
    return 0;
}
static double find_edge(bool deepest, double lower, double end, array_double_1d axis, array_double_2d work)
{
    double accuracy;
    double upper;
    int64_t i;
    double first;
    bool shallow;
    bool deep;
    double found;
    accuracy = 0.001;
    if (deepest)
    {
        accuracy = 0.01;
    }
    upper = 1e+300;
    found = -1.0;
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        first = 2.0 * lower;
        if (upper < 1e+300)
        {
            first = 0.5 * (lower + upper);
        }
        judge_dip(&shallow, &deep, first, end, axis, work);
        if (shallow && deep)
        {
            break;
        }
        if ((!shallow) && (!deep))
        {
            found = first;
        }
        if (shallow || (deepest && (!deep)))
        {
            lower = first;
        }
        else
        {
            upper = first;
        }
        if ((upper - lower <= 1e-12 * upper) || ((found > 0.0) && (upper - lower <= accuracy * upper)))
        {
            break;
        }
    }
    return found;
}
static bool find_dips(double v, double a, double end, array_double_1d axis, array_double_1d dips, array_double_2d work)
{
    double sign;
    double duration;
    double slope;
    double gain;
    int64_t lower;
    int64_t above;
    double least;
    sign = 1.0;
    if (a < 0.0)
    {
        sign = -1.0;
    }
    segfmu_ramp_duration(&duration, &slope, fabs(a), axis);
    gain = 0.37 * fabs(a) * duration;
    if (ramps_suffice(axis) || (sign * v + gain > side_limit(INT64_C(1), sign, axis)))
    {
        return 0;
    }
    (*cspan_at(&dips, INT64_C(0))) = v;
    (*cspan_at(&dips, INT64_C(1))) = a;
    (*cspan_at(&dips, INT64_C(2))) = (-sign) * end;
    for (lower = INT64_C(0); lower < (int64_t)((*cspan_at(&axis, INT64_C(38)))); lower += INT64_C(1))
    {
        above = (int64_t)((*cspan_at(&axis, INT64_C(38)))) - lower;
        begin_dip(above, sign * v, fabs(a), work);
        if (sign < 0.0)
        {
            mirror_axis(axis);
        }
        least = find_edge(0, 0.02 * duration, -end, axis, work);
        if (sign < 0.0)
        {
            mirror_axis(axis);
        }
        if (least > 0.0)
        {
            (*cspan_at(&dips, INT64_C(3))) = above;
            (*cspan_at(&dips, INT64_C(4))) = least;
            (*cspan_at(&dips, INT64_C(5))) = least;
            return 1;
        }
    }
    return 0;
}
static void find_deepest(array_double_1d axis, array_double_1d dips, array_double_2d work)
{
    double end;
    end = -fabs((*cspan_at(&dips, INT64_C(2))));
    if ((*cspan_at(&dips, INT64_C(1))) < 0.0)
    {
        mirror_axis(axis);
    }
    (*cspan_at(&dips, INT64_C(5))) = span_max(find_edge(1, (*cspan_at(&dips, INT64_C(4))), end, axis, work), (*cspan_at(&dips, INT64_C(4))));
    if ((*cspan_at(&dips, INT64_C(1))) < 0.0)
    {
        mirror_axis(axis);
    }
}
static int64_t write_levels(array_double_2d phases, array_double_2d work)
{
    double above;
    double level;
    int64_t i;
    int64_t row;
    double ramp;
    int64_t used;
    above = (*cspan_at(&work, INT64_C(101), INT64_C(1)));
    level = 0.0;
    used = INT64_C(0);
    for (i = INT64_C(0); i < (int64_t)(above) + INT64_C(2); i += INT64_C(1))
    {
        row = INT64_C(102) + i;
        ramp = (*cspan_at(&work, row, INT64_C(11)));
        used = append_phase(phases, used, ramp, ramp, level, (*cspan_at(&work, row, INT64_C(9))) - level, above);
        level = (*cspan_at(&work, row, INT64_C(9)));
        used = append_phase(phases, used, (*cspan_at(&work, row, INT64_C(10))), 0.0, level, 0.0, above);
    }
    return used;
}
static int64_t write_dip(int64_t* result_0, double* result_1, double* result_2, double* result_3, double depth, array_double_1d axis, array_double_1d dips, array_double_2d phases, array_double_2d work)
{
    int64_t above;
    double sign;
    double first;
    int64_t count;
    array_double_2d nodes;
    double duration;
    double y;
    double v;
    above = (int64_t)((*cspan_at(&dips, INT64_C(3))));
    if (above == INT64_C(0))
    {
        (*result_0) = INT64_C(0);
        (*result_1) = 0.0;
        (*result_2) = 0.0;
        (*result_3) = (*cspan_at(&dips, INT64_C(0)));
        return 0;
    }
    sign = 1.0;
    if ((*cspan_at(&dips, INT64_C(1))) < 0.0)
    {
        sign = -1.0;
    }
    begin_dip(above, sign * (*cspan_at(&dips, INT64_C(0))), fabs((*cspan_at(&dips, INT64_C(1)))), work);
    first = (*cspan_at(&dips, INT64_C(4))) + depth * ((*cspan_at(&dips, INT64_C(5))) - (*cspan_at(&dips, INT64_C(4))));
    close_dip(first, sign * (*cspan_at(&dips, INT64_C(2))), axis, work);
    count = write_levels(phases, work);
    if (sign < 0.0)
    {
        mirror_phases(phases, count);
    }
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    duration = sequence_duration(span_row(&work, INT64_C(101)), nodes);
    y = sign * (*cspan_at(&nodes, above + INT64_C(2), INT64_C(0)));
    v = sign * (*cspan_at(&nodes, above + INT64_C(2), INT64_C(0) + INT64_C(1)));
    v = boundary_value(v, (*cspan_at(&axis, INT64_C(9))), (*cspan_at(&axis, INT64_C(2))));
    (*result_0) = count;
    (*result_1) = duration;
    (*result_2) = y;
    (*result_3) = v;
    return 0;
}
static double peak_past_zero(double v, double a, double level, array_double_1d axis)
{
    double duration;
    double slope;
    double result;
    segfmu_ramp_duration(&duration, &slope, a - level, axis);
    if (level >= 0.0)
    {
        return v + 0.5 * a * duration;
    }
    result = ramp_extreme_velocity(v, a, level, duration, duration, axis);
    return result;
}
static double deep_level(double v, double a, double velocity_limit, double bottom, array_double_1d axis)
{
    double shrink;
    double lower;
    double upper;
    double inner;
    double outer;
    double at_inner;
    double at_outer;
    int64_t i;
    shrink = 0.6180339887498949;
    lower = -span_min(bottom, 1000.0 * a);
    upper = 0.0;
    if (peak_past_zero(v, a, lower, axis) <= velocity_limit)
    {
        return lower;
    }
    inner = upper - shrink * (upper - lower);
    outer = lower + shrink * (upper - lower);
    at_inner = peak_past_zero(v, a, inner, axis);
    at_outer = peak_past_zero(v, a, outer, axis);
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        if (at_inner <= velocity_limit)
        {
            return inner;
        }
        if (at_outer <= velocity_limit)
        {
            return outer;
        }
        if (at_inner < at_outer - 1e-12 * velocity_limit)
        {
            upper = outer;
            outer = inner;
            at_outer = at_inner;
            inner = upper - shrink * (upper - lower);
            at_inner = peak_past_zero(v, a, inner, axis);
        }
        else
        {
            lower = inner;
            inner = outer;
            at_inner = at_outer;
            outer = lower + shrink * (upper - lower);
            at_outer = peak_past_zero(v, a, outer, axis);
        }
    }
    return 1.0;
}
static double level_past_zero(double v, double a, double velocity_limit, double bottom, array_double_1d axis)
{
    double newest;
    double e_newest;
    double other;
    double e_other;
    double before;
    double e_before;
    int64_t i;
    double share;
    double level;
    double error;
    bool crossed;
    double inside;
    inside = deep_level(v, a, velocity_limit, bottom, axis);
    if (inside > 0.0)
    {
        return inside;
    }
    newest = inside;
    e_newest = peak_past_zero(v, a, inside, axis) - velocity_limit;
    other = 0.0;
    e_other = peak_past_zero(v, a, other, axis) - velocity_limit;
    before = other;
    e_before = e_other;
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        share = root_share(newest, other, before, e_newest, e_other, e_before);
        level = newest + share * (other - newest);
        if ((level == newest) || (level == other))
        {
            break;
        }
        error = peak_past_zero(v, a, level, axis) - velocity_limit;
        crossed = newest == inside;
        if (error <= 0.0)
        {
            crossed = newest != inside;
            inside = level;
        }
        next_bracket(&other, &before, &e_other, &e_before, crossed, newest, other, e_newest, e_other);
        newest = level;
        e_newest = error;
    }
    return inside;
}
static int64_t brake(int64_t* result_0, double* result_1, double* result_2, double* result_3, double v, double a, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    int64_t count;
    double level;
    double reached;
    int64_t i;
    double duration;
    double y;
    double end;
    double lowest;
    double highest;
    double sign;
    double most;
    double bottom;
    double past;
    array_double_1d dips;
    count = INT64_C(0);
    level = a;
    reached = v;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        count = append_change(phases, count, level, 0.0, axis);
        segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, v, 1e+300, axis);
        if (!is_beyond(end, end, 1.0 + 1e-12, axis))
        {
            (*result_0) = count;
            (*result_1) = duration;
            (*result_2) = y;
            (*result_3) = end;
            return 0;
        }
        count = count - INT64_C(1);
        sign = 1.0;
        if (level < 0.0)
        {
            sign = -1.0;
        }
        most = side_limit(INT64_C(1), sign, axis);
        bottom = side_limit(INT64_C(2), -sign, axis);
        past = sign * level_past_zero(sign * reached, sign * level, most, bottom, axis);
        if (past * sign > 0.0)
        {
            break;
        }
        count = append_change(phases, count, level, past, axis);
        segfmu_measure_phases(&duration, &y, &reached, &lowest, &highest, phases, count, v, 1e+300, axis);
        level = past;
    }
    dips = span_row(&work, INT64_C(62));
    if (find_dips(v, a, 0.0, axis, dips, work))
    {
        write_dip(result_0, result_1, result_2, result_3, 0.0, axis, dips, phases, work);
        return 0;
    }
    (*result_0) = -INT64_C(1);
    (*result_1) = 0.0;
    (*result_2) = 0.0;
    (*result_3) = 0.0;
    return 0;
}
static bool nearly_brakes(double v, double a, array_double_1d axis)
{
    double duration;
    double slope;
    double end;
    double near;
    bool result;
    segfmu_ramp_duration(&duration, &slope, fabs(a), axis);
    end = v + 0.5 * a * duration;
    near = v + (1.0 - saving(axis)) * (0.5 * a * duration);
    result = is_beyond(end, end, 1.0, axis) && (!is_beyond(near, near, 1.0, axis));
    return result;
}
static int64_t braked(int64_t* result_0_0001, double* result_1, int64_t variant, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_2d trial;
    array_double_1d rest;
    int64_t first;
    int64_t last;
    double spent;
    double v;
    double a;
    double w;
    double b;
    double distance;
    double duration;
    double y;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    rest = span_row(&work, INT64_C(60));
    first = INT64_C(0);
    last = INT64_C(0);
    spent = 0.0;
    v = (*cspan_at(&problem, INT64_C(0)));
    a = (*cspan_at(&problem, INT64_C(1)));
    w = (*cspan_at(&problem, INT64_C(2)));
    b = (*cspan_at(&problem, INT64_C(3)));
    distance = (*cspan_at(&problem, INT64_C(4)));
    if (((span_floor_mod(variant, INT64_C(2)) == INT64_C(1)) && (a == 0.0)) || ((variant >= INT64_C(2)) && (b == 0.0)))
    {
        (*result_0_0001) = -INT64_C(3);
        (*result_1) = 0.0;
        return 0;
    }
    if (span_floor_mod(variant, INT64_C(2)) == INT64_C(1))
    {
        brake(&first, &duration, &y, &v, v, a, axis, trial, work);
        if (first < INT64_C(0))
        {
            (*result_0_0001) = -INT64_C(1);
            (*result_1) = 0.0;
            return 0;
        }
        spent = duration;
        distance = distance - y;
        a = 0.0;
    }
    if (variant >= INT64_C(2))
    {
        reverse_axis(axis);
        brake(&last, &duration, &y, &w, w, -b, axis, trial, work);
        reverse_axis(axis);
        if (last < INT64_C(0))
        {
            (*result_0_0001) = -INT64_C(2);
            (*result_1) = 0.0;
            return 0;
        }
        spent = spent + duration;
        distance = distance - y;
        b = 0.0;
    }
    (*cspan_at(&rest, INT64_C(0))) = v;
    (*cspan_at(&rest, INT64_C(1))) = a;
    (*cspan_at(&rest, INT64_C(2))) = w;
    (*cspan_at(&rest, INT64_C(3))) = b;
    (*cspan_at(&rest, INT64_C(4))) = distance;
    (*cspan_at(&rest, INT64_C(5))) = (*cspan_at(&problem, INT64_C(5))) - spent;
    (*result_0_0001) = first + last;
    (*result_1) = spent;
    return 0;
}
static int64_t surround(array_double_2d phases, int64_t count, int64_t variant, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_2d trial;
    double v;
    int64_t first;
    double duration;
    double y;
    double end;
    int64_t j;
    int64_t i;
    int64_t column;
    double w;
    int64_t last;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    if (span_floor_mod(variant, INT64_C(2)) == INT64_C(1))
    {
        v = (*cspan_at(&problem, INT64_C(0)));
        brake(&first, &duration, &y, &end, v, (*cspan_at(&problem, INT64_C(1))), axis, trial, work);
        for (j = INT64_C(0); j < count; j += INT64_C(1))
        {
            i = count - INT64_C(1) - j;
            for (column = INT64_C(0); column < INT64_C(5); column += INT64_C(1))
            {
                (*cspan_at(&phases, first + i, column)) = (*cspan_at(&phases, i, column));
            }
        }
        copy_phases(trial, phases, first);
        count = first + count;
    }
    if (variant >= INT64_C(2))
    {
        w = (*cspan_at(&problem, INT64_C(2)));
        reverse_axis(axis);
        brake(&last, &duration, &y, &end, w, -(*cspan_at(&problem, INT64_C(3))), axis, trial, work);
        reverse_axis(axis);
        reverse_phases(trial, INT64_C(0), last);
        count = join_phases(trial, last, phases, count);
    }
    return count;
}
static void timed_merged(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_2d trial;
    array_double_1d family;
    int64_t branch;
    int64_t member;
    int64_t count;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    family = span_row(&work, INT64_C(98));
    for (branch = INT64_C(0); branch < INT64_C(4); branch += INT64_C(1))
    {
        if (same_members(branch, problem, family))
        {
            continue;
        }
        set_family(branch, problem, axis, family);
        for (member = INT64_C(0); member < INT64_C(2); member += INT64_C(1))
        {
            set_member(member, (*cspan_at(&problem, INT64_C(5))), 1, family);
            count = tempered_form(trial, family, axis);
            if (count < INT64_C(0))
            {
                break;
            }
            keep_nearest(count, problem, axis, cell, work);
        }
    }
}
static void usual_cruise(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_2d trial;
    double v;
    double w;
    double distance;
    double middle;
    int64_t count;
    double y;
    double hold;
    double edge;
    double y_edge;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    v = (*cspan_at(&problem, INT64_C(0)));
    w = (*cspan_at(&problem, INT64_C(2)));
    distance = (*cspan_at(&problem, INT64_C(4)));
    middle = span_min(span_max(distance / (*cspan_at(&problem, INT64_C(5))), span_min(v, w)), span_max(v, w));
    timed_cruise(&count, &y, &hold, trial, middle, problem, axis);
    if ((count >= INT64_C(0)) && (hold >= 0.0))
    {
        keep_nearest(count, problem, axis, cell, work);
        edge = cruise_range(trial, middle, y, hold, problem, axis);
        y_edge = keep_cruise(edge, problem, axis, cell, work);
        if (is_enclosed(work))
        {
            between_cruises(middle, edge, y - distance, y_edge - distance, problem, axis, cell, work);
        }
    }
}
static void timed_between(array_double_1d problem, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    usual_cruise(problem, axis, cell, work);
    if (!is_enclosed(work))
    {
        scan_cruises(problem, axis, cell, work);
    }
    if (!is_enclosed(work))
    {
        timed_merged(problem, axis, cell, work);
    }
}
static void note_known(array_double_2d work)
{
    array_double_1d nearest;
    nearest = span_row(&work, INT64_C(58));
    (*cspan_at(&nearest, INT64_C(4))) = 0.0;
    if ((*cspan_at(&nearest, INT64_C(0))) > 0.0)
    {
        (*cspan_at(&nearest, INT64_C(4))) = -1.0;
    }
    else if ((*cspan_at(&nearest, INT64_C(2))) > 0.0)
    {
        (*cspan_at(&nearest, INT64_C(4))) = 1.0;
    }
}
static void clear_nearest(array_double_2d work)
{
    (*cspan_at(&work, INT64_C(58), INT64_C(0))) = 0.0;
    (*cspan_at(&work, INT64_C(58), INT64_C(2))) = 0.0;
}
static double nearest_weight(array_double_1d problem, array_double_1d axis, array_double_1d nearest)
{
    double distance;
    double below;
    double above;
    double target;
    double speed;
    double tiny;
    distance = (*cspan_at(&problem, INT64_C(4)));
    below = (*cspan_at(&nearest, INT64_C(1)));
    above = (*cspan_at(&nearest, INT64_C(3)));
    target = (*cspan_at(&problem, INT64_C(5)));
    speed = speed_bound(1.0, target, problem, axis);
    speed = span_max(speed, speed_bound(-1.0, target, problem, axis));
    tiny = 1e-14 * (fabs(distance) + speed * target);
    if (above - distance <= tiny)
    {
        return 1.0;
    }
    if (distance - below > tiny)
    {
        return (distance - below) / (above - below);
    }
    return 0.0;
}
static bool has_pace(array_double_1d passing)
{
    bool result;
    result = ((*cspan_at(&passing, INT64_C(5))) > 0.0) && ((*cspan_at(&passing, INT64_C(6))) == 0.0);
    return result;
}
static double residual_norm(int64_t count, array_double_1d residual)
{
    double total;
    int64_t i;
    total = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        total = total + (*cspan_at(&residual, INT64_C(0) + i)) * (*cspan_at(&residual, INT64_C(0) + i));
    }
    return sqrt(total);
}
static void pace_column(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    array_double_1d residual;
    double change;
    int64_t i;
    double slope;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    residual = span_row(&work, INT64_C(202));
    change = 1e-07;
    (*cspan_at(&passing, INT64_C(2))) = (*cspan_at(&passing, INT64_C(2))) + change;
    run_sequence(problem, passing, axis, nodes, residual);
    (*cspan_at(&passing, INT64_C(2))) = (*cspan_at(&passing, INT64_C(2))) - change;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        slope = ((*cspan_at(&residual, INT64_C(0) + i)) + (*cspan_at(&work, INT64_C(219) + i, INT64_C(0)))) / change;
        (*cspan_at(&work, INT64_C(203) + i, count - INT64_C(1))) = slope;
    }
    run_sequence(problem, passing, axis, nodes, residual);
}
static void time_column(int64_t column, int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    array_double_1d residual;
    array_double_1d slopes;
    array_double_2d before;
    array_double_1d moved;
    int64_t q;
    int64_t following;
    array_double_1d base;
    double spent;
    int64_t j;
    int64_t i;
    double change;
    int64_t row;
    int64_t begin;
    double slope;
    int64_t k;
    double difference;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    residual = span_row(&work, INT64_C(202));
    slopes = span_row(&work, INT64_C(235));
    before = span_rows(&work, INT64_C(236), INT64_C(239));
    moved = span_row(&work, INT64_C(239));
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    following = column + INT64_C(2);
    base = span_row(&work, INT64_C(236) + INT64_C(2));
    spent = 0.0;
    for (j = INT64_C(0); j < INT64_C(3); j += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(12); i += INT64_C(1))
        {
            (*cspan_at(&before, j, i)) = (*cspan_at(&nodes, column + j, i));
        }
    }
    for (j = INT64_C(0); j < INT64_C(2); j += INT64_C(1))
    {
        spent = spent - (*cspan_at(&nodes, column + j, INT64_C(11))) - (*cspan_at(&nodes, column + j, INT64_C(10)));
    }
    change = 1e-07 * (fabs((*cspan_at(&nodes, column, INT64_C(6)))) + 0.001 * (*cspan_at(&passing, INT64_C(3))));
    (*cspan_at(&nodes, column, INT64_C(6))) = (*cspan_at(&nodes, column, INT64_C(6))) + change;
    row = first_row(column, passing, nodes);
    begin = row;
    row = follow_node(column, row, problem, passing, axis, nodes, residual);
    row = follow_node(column + INT64_C(1), row, problem, passing, axis, nodes, residual);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&slopes, INT64_C(0) + i)) = 0.0;
    }
    for (i = begin; i < row; i += INT64_C(1))
    {
        slope = (*cspan_at(&residual, INT64_C(0) + i)) + (*cspan_at(&work, INT64_C(219) + i, INT64_C(0)));
        (*cspan_at(&slopes, INT64_C(0) + i)) = slope / change;
    }
    for (j = INT64_C(0); j < INT64_C(2); j += INT64_C(1))
    {
        spent = spent + (*cspan_at(&nodes, column + j, INT64_C(11))) + (*cspan_at(&nodes, column + j, INT64_C(10)));
    }
    if ((*cspan_at(&passing, INT64_C(5))) > 0.0)
    {
        (*cspan_at(&slopes, INT64_C(0) + count - INT64_C(1))) = spent / (change * (*cspan_at(&passing, INT64_C(3))));
    }
    if (following <= (int64_t)((*cspan_at(&passing, INT64_C(0)))))
    {
        for (k = INT64_C(0); k < q; k += INT64_C(1))
        {
            difference = (*cspan_at(&nodes, following, INT64_C(0) + k)) - (*cspan_at(&base, INT64_C(0) + k));
            (*cspan_at(&moved, INT64_C(0) + k)) = difference / change;
        }
        follow_change(following, row, passing, axis, nodes, moved, slopes);
    }
    for (j = INT64_C(0); j < INT64_C(3); j += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(12); i += INT64_C(1))
        {
            (*cspan_at(&nodes, column + j, i)) = (*cspan_at(&before, j, i));
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(203) + i, column)) = (*cspan_at(&slopes, INT64_C(0) + i));
    }
}
static void whole_column(int64_t column, int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    array_double_1d residual;
    double time;
    double change;
    int64_t i;
    double slope;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    residual = span_row(&work, INT64_C(202));
    time = (*cspan_at(&nodes, column, INT64_C(6)));
    change = 1e-07 * (fabs(time) + 0.001 * (*cspan_at(&passing, INT64_C(3))));
    (*cspan_at(&nodes, column, INT64_C(6))) = time + change;
    run_sequence(problem, passing, axis, nodes, residual);
    (*cspan_at(&nodes, column, INT64_C(6))) = time;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        slope = ((*cspan_at(&residual, INT64_C(0) + i)) + (*cspan_at(&work, INT64_C(219) + i, INT64_C(0)))) / change;
        (*cspan_at(&work, INT64_C(203) + i, column)) = slope;
    }
}
static void newton_step(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_1d residual;
    int64_t i;
    int64_t j;
    double largest;
    double added;
    double diagonal;
    array_double_2d matrix;
    passing = span_row(&work, INT64_C(101));
    residual = span_row(&work, INT64_C(202));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(219) + i, INT64_C(0))) = -(*cspan_at(&residual, INT64_C(0) + i));
    }
    if (has_pace(passing))
    {
        pace_column(count, problem, axis, work);
    }
    (*cspan_at(&work, INT64_C(200), INT64_C(4))) = (*cspan_at(&work, INT64_C(200), INT64_C(4))) + 1.0;
    for (j = INT64_C(0); j < (int64_t)((*cspan_at(&passing, INT64_C(0)))); j += INT64_C(1))
    {
        if (((*cspan_at(&passing, INT64_C(13))) > 0.5) || ((*cspan_at(&passing, INT64_C(6))) != 0.0))
        {
            whole_column(j, count, problem, axis, work);
        }
        else
        {
            time_column(j, count, problem, axis, work);
        }
    }
    for (j = INT64_C(0); j < count; j += INT64_C(1))
    {
        largest = 0.0;
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            largest = span_max(largest, fabs((*cspan_at(&work, INT64_C(203) + i, j))));
        }
        added = 1e-12 * largest;
        if (largest == 0.0)
        {
            added = 1.0;
        }
        diagonal = (*cspan_at(&work, INT64_C(203) + j, j));
        if (diagonal < 0.0)
        {
            added = -added;
        }
        (*cspan_at(&work, INT64_C(203) + j, j)) = diagonal + added;
    }
    matrix = span_rows(&work, INT64_C(203), INT64_C(219));
    matrix_solve(count, INT64_C(1), matrix, span_rows(&work, INT64_C(219), INT64_C(235)));
}
static double longest_step(array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    int64_t count;
    int64_t i;
    double change;
    double time;
    double most;
    double share;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    share = 1.0;
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        change = (*cspan_at(&work, INT64_C(219) + i, INT64_C(0)));
        time = (*cspan_at(&nodes, i, INT64_C(6)));
        if (!(fabs(change) < 1000000000000.0 * (*cspan_at(&passing, INT64_C(3)))))
        {
            return 0.0;
        }
        most = 0.5 * (*cspan_at(&passing, INT64_C(3)));
        if ((*cspan_at(&nodes, i, INT64_C(4))) < 0.5)
        {
            most = 0.7 * fabs(time);
            if (change * time >= 0.0)
            {
                most = 1.5 * fabs(time);
            }
            most = most + 0.01 * (*cspan_at(&passing, INT64_C(3)));
        }
        if (fabs(change) * share > most)
        {
            share = most / fabs(change);
        }
    }
    if (has_pace(passing))
    {
        change = fabs((*cspan_at(&work, INT64_C(219) + count, INT64_C(0))));
        if (change * share > 0.3 * (*cspan_at(&passing, INT64_C(2))))
        {
            share = 0.3 * (*cspan_at(&passing, INT64_C(2))) / change;
        }
    }
    return share;
}
static void take_step(double share, array_double_2d work)
{
    int64_t count;
    int64_t i;
    int64_t row;
    double pace;
    count = (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0))));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        row = INT64_C(102) + i;
        (*cspan_at(&work, row, INT64_C(6))) = (*cspan_at(&work, row, INT64_C(6))) + share * (*cspan_at(&work, INT64_C(219) + i, INT64_C(0)));
    }
    if (has_pace(span_row(&work, INT64_C(101))))
    {
        pace = (*cspan_at(&work, INT64_C(101), INT64_C(2))) + share * (*cspan_at(&work, INT64_C(219) + count, INT64_C(0)));
        (*cspan_at(&work, INT64_C(101), INT64_C(2))) = pace;
    }
}
static bool solve_sequence(array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    array_double_1d residual;
    int64_t count;
    double error;
    bool quick;
    double earlier;
    int64_t i;
    double share;
    double reached;
    int64_t j;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    residual = span_row(&work, INT64_C(202));
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    if (has_pace(passing))
    {
        count = count + INT64_C(1);
    }
    run_sequence(problem, passing, axis, nodes, residual);
    error = residual_norm(count, residual);
    quick = ramps_suffice(axis) || ((*cspan_at(&passing, INT64_C(12))) > 0.5);
    earlier = error;
    for (i = INT64_C(0); i < INT64_C(30); i += INT64_C(1))
    {
        if (error <= 2e-15)
        {
            break;
        }
        if (quick && (i > INT64_C(0)) && (span_floor_mod(i, INT64_C(4)) == INT64_C(0)))
        {
            if (error > 0.7 * earlier)
            {
                break;
            }
            earlier = error;
        }
        newton_step(count, problem, axis, work);
        share = longest_step(work);
        reached = error;
        for (j = INT64_C(0); j < INT64_C(8); j += INT64_C(1))
        {
            if ((share == 0.0) || ((j > INT64_C(0)) && (error <= 1e-11)))
            {
                break;
            }
            take_step(share, work);
            run_sequence(problem, passing, axis, nodes, residual);
            reached = residual_norm(count, residual);
            if (reached < error * (1.0 - 0.0001 * share))
            {
                break;
            }
            take_step(-share, work);
            share = 0.5 * share;
        }
        if (!(reached < error * (1.0 - 0.0001 * share)))
        {
            run_sequence(problem, passing, axis, nodes, residual);
            break;
        }
        error = reached;
    }
    return error <= 1e-12;
}
static void keep_sequence(int64_t row, array_double_2d work)
{
    int64_t i;
    int64_t j;
    for (i = INT64_C(0); i < INT64_C(26); i += INT64_C(1))
    {
        (*cspan_at(&work, row, i)) = (*cspan_at(&work, INT64_C(101), i));
    }
    for (j = INT64_C(0); j < (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0)))) + INT64_C(2); j += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(12); i += INT64_C(1))
        {
            (*cspan_at(&work, row + INT64_C(1) + j, i)) = (*cspan_at(&work, INT64_C(102) + j, i));
        }
    }
}
static void restore_sequence(int64_t row, array_double_2d work)
{
    int64_t i;
    int64_t j;
    for (i = INT64_C(0); i < INT64_C(26); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(101), i)) = (*cspan_at(&work, row, i));
    }
    for (j = INT64_C(0); j < (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0)))) + INT64_C(2); j += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(12); i += INT64_C(1))
        {
            (*cspan_at(&work, INT64_C(102) + j, i)) = (*cspan_at(&work, row + INT64_C(1) + j, i));
        }
    }
}
static void insert_node(int64_t place, int64_t kind, double sign, double time, bool touch, array_double_2d work)
{
    array_double_1d passing;
    int64_t count;
    int64_t j;
    int64_t row;
    int64_t i;
    passing = span_row(&work, INT64_C(101));
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    shift_instants(place, INT64_C(1), passing);
    for (j = INT64_C(0); j < count - place; j += INT64_C(1))
    {
        row = INT64_C(102) + count - j;
        for (i = INT64_C(0); i < INT64_C(12); i += INT64_C(1))
        {
            (*cspan_at(&work, row, i)) = (*cspan_at(&work, row - INT64_C(1), i));
        }
    }
    row = INT64_C(102) + place;
    (*cspan_at(&work, row, INT64_C(4))) = kind;
    (*cspan_at(&work, row, INT64_C(5))) = sign;
    (*cspan_at(&work, row, INT64_C(6))) = time;
    (*cspan_at(&work, row, INT64_C(7))) = touch;
    (*cspan_at(&work, row, INT64_C(8))) = 0.0;
    (*cspan_at(&passing, INT64_C(0))) = count + INT64_C(1);
}
static void set_alternating(double sign, double time, array_double_2d work)
{
    int64_t i;
    (*cspan_at(&work, INT64_C(101), INT64_C(0))) = 0.0;
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1)))) + INT64_C(2); i += INT64_C(1))
    {
        insert_node(i, INT64_C(0), sign * (1.0 - 2.0 * (span_floor_mod(i, INT64_C(2)))), time, 0, work);
    }
}
static void remove_node(int64_t place, array_double_2d work)
{
    array_double_1d passing;
    int64_t count;
    int64_t row;
    int64_t i;
    passing = span_row(&work, INT64_C(101));
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    for (row = INT64_C(102) + place; row < INT64_C(102) + count - INT64_C(1); row += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(12); i += INT64_C(1))
        {
            (*cspan_at(&work, row, i)) = (*cspan_at(&work, row + INT64_C(1), i));
        }
    }
    (*cspan_at(&passing, INT64_C(0))) = count - INT64_C(1);
    shift_instants(place + INT64_C(1), -INT64_C(1), passing);
}
static int64_t split_guess(double* result_0_0001, double* result_1_0001, double* result_2_0001, int64_t guess)
{
    if (guess == INT64_C(1))
    {
        (*result_0_0001) = 0.9;
        (*result_1_0001) = 0.7;
        (*result_2_0001) = 0.6;
        return 0;
    }
    if (guess == INT64_C(2))
    {
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
static bool split_level(int64_t place, int64_t kind, double sign, int64_t guess, array_double_1d axis, array_double_2d work)
{
    int64_t row;
    double time;
    double level_sign;
    double dip;
    double before;
    double depth;
    double after;
    row = INT64_C(102) + place;
    if ((*cspan_at(&work, row, INT64_C(4))) > 0.5)
    {
        return 0;
    }
    time = (*cspan_at(&work, row, INT64_C(6)));
    level_sign = (*cspan_at(&work, row, INT64_C(5)));
    dip = span_min(fabs(time), (*cspan_at(&axis, INT64_C(21) + kind - INT64_C(1))));
    split_guess(&before, &depth, &after, guess);
    (*cspan_at(&work, row, INT64_C(6))) = before * time;
    insert_node(place + INT64_C(1), kind, sign, (-depth) * dip, 0, work);
    insert_node(place + INT64_C(2), INT64_C(0), level_sign, after * time, 0, work);
    return 1;
}
static bool split_ramp(int64_t place, int64_t kind, double sign, bool touch, bool holding, array_double_2d work)
{
    int64_t first;
    int64_t last;
    int64_t plateau;
    double share;
    double time;
    double before;
    double after;
    double hold;
    first = INT64_C(102) + place - INT64_C(1);
    last = INT64_C(102) + place;
    plateau = kind + INT64_C(2);
    if (holding)
    {
        last = last + INT64_C(1);
        if ((*cspan_at(&work, last - INT64_C(1), INT64_C(4))) != plateau)
        {
            return 0;
        }
    }
    if (((*cspan_at(&work, first, INT64_C(4))) > 0.5) || ((*cspan_at(&work, last, INT64_C(4))) > 0.5))
    {
        return 0;
    }
    share = 0.7;
    if (touch)
    {
        share = 0.5;
    }
    time = share * 0.5 * ((*cspan_at(&work, first, INT64_C(6))) + (*cspan_at(&work, last, INT64_C(6))));
    before = (*cspan_at(&work, first, INT64_C(5)));
    after = (*cspan_at(&work, last, INT64_C(5)));
    if (holding)
    {
        hold = (*cspan_at(&work, last - INT64_C(1), INT64_C(6)));
        insert_node(place + INT64_C(1), plateau, (*cspan_at(&work, last - INT64_C(1), INT64_C(5))), hold, 0, work);
        place = place + INT64_C(1);
    }
    insert_node(place, INT64_C(0), before, time, 0, work);
    insert_node(place, kind, sign, 0.0, touch, work);
    insert_node(place, INT64_C(0), after, time, 0, work);
    return 1;
}
static bool insert_plateau(int64_t kind, bool touching, int64_t guess, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_1d excess;
    int64_t q;
    int64_t count;
    int64_t place;
    double sign;
    bool holding;
    int64_t row;
    bool here;
    bool inside;
    bool result;
    passing = span_row(&work, INT64_C(101));
    excess = span_row(&work, INT64_C(196) + kind);
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    place = (int64_t)((*cspan_at(&excess, INT64_C(1))));
    sign = (*cspan_at(&excess, INT64_C(3)));
    holding = (*cspan_at(&excess, INT64_C(2))) > 0.5;
    if (count > INT64_C(12))
    {
        return 0;
    }
    if (kind == q - INT64_C(2))
    {
        if (!holding)
        {
            row = INT64_C(102) + place;
            here = (place < count) && ((*cspan_at(&work, row, INT64_C(4))) < 0.5);
            if ((!here) || ((*cspan_at(&work, row, INT64_C(9))) * sign >= 0.0))
            {
                place = place - INT64_C(1);
            }
        }
        inside = (place >= INT64_C(0)) && (place < count);
        result = inside && split_level(place, kind, sign, guess, axis, work);
        return result;
    }
    if ((place == INT64_C(0)) || (place >= count))
    {
        return 0;
    }
    if (kind == q - INT64_C(3))
    {
        result = split_ramp(place, kind, sign, touching, holding, work);
        return result;
    }
    row = INT64_C(102) + place;
    if (holding || ((*cspan_at(&work, row, INT64_C(4))) > 0.5) || ((*cspan_at(&work, row - INT64_C(1), INT64_C(4))) > 0.5))
    {
        return 0;
    }
    insert_node(place, kind, sign, 0.0, 0, work);
    return 1;
}
static bool rotate_levels(array_double_2d work)
{
    array_double_1d passing;
    int64_t count;
    int64_t first;
    int64_t last;
    double tiny;
    double at_first;
    double at_last;
    passing = span_row(&work, INT64_C(101));
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    first = INT64_C(102);
    last = INT64_C(102) + count - INT64_C(1);
    tiny = 0.03 * (*cspan_at(&passing, INT64_C(3)));
    if ((count < INT64_C(2)) || ((*cspan_at(&work, first, INT64_C(4))) > 0.5) || ((*cspan_at(&work, last, INT64_C(4))) > 0.5))
    {
        return 0;
    }
    if ((*cspan_at(&passing, INT64_C(6))) != 0.0)
    {
        return 0;
    }
    at_first = fabs((*cspan_at(&work, first, INT64_C(6))));
    at_last = fabs((*cspan_at(&work, last, INT64_C(6))));
    if (span_min(at_first, at_last) >= tiny)
    {
        return 0;
    }
    if (at_first <= at_last)
    {
        remove_node(INT64_C(0), work);
        insert_node(count - INT64_C(1), INT64_C(0), -(*cspan_at(&work, last - INT64_C(1), INT64_C(5))), tiny, 0, work);
    }
    else
    {
        remove_node(count - INT64_C(1), work);
        insert_node(INT64_C(0), INT64_C(0), -(*cspan_at(&work, first, INT64_C(5))), tiny, 0, work);
    }
    return 1;
}
static bool solve_rotated(array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    bool result;
    if (solve_sequence(problem, axis, work))
    {
        return 1;
    }
    result = rotate_levels(work) && solve_sequence(problem, axis, work);
    return result;
}
static int64_t overlong_plateau(array_double_2d work)
{
    array_double_1d passing;
    double least;
    int64_t i;
    int64_t row;
    int64_t kind;
    bool held;
    int64_t found;
    passing = span_row(&work, INT64_C(101));
    found = -INT64_C(1);
    least = (-1e-12) * (*cspan_at(&passing, INT64_C(3)));
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&passing, INT64_C(0)))); i += INT64_C(1))
    {
        row = INT64_C(102) + i;
        kind = (int64_t)((*cspan_at(&work, row, INT64_C(4))));
        held = ((*cspan_at(&work, row, INT64_C(7))) < 0.5) && (kind != (int64_t)((*cspan_at(&passing, INT64_C(1)))));
        if ((kind > INT64_C(0)) && held && ((*cspan_at(&work, row, INT64_C(6))) < least))
        {
            found = i;
            least = (*cspan_at(&work, row, INT64_C(6)));
        }
    }
    return found;
}
static bool shorten_hold(int64_t row, int64_t touch, int64_t steps, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    double hold;
    int64_t i;
    hold = (*cspan_at(&work, row, INT64_C(6)));
    (*cspan_at(&work, row, INT64_C(7))) = touch;
    for (i = INT64_C(0); i < steps; i += INT64_C(1))
    {
        (*cspan_at(&work, row, INT64_C(8))) = hold * (steps - INT64_C(1) - i) / steps;
        if (!solve_sequence(problem, axis, work))
        {
            return 0;
        }
    }
    return 1;
}
static bool touch_limit(int64_t row, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t kind;
    bool result;
    keep_sequence(INT64_C(120), work);
    kind = (int64_t)((*cspan_at(&work, row, INT64_C(4))));
    if (kind == (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1)))) + INT64_C(1))
    {
        if (shorten_hold(row, INT64_C(2), INT64_C(1), problem, axis, work))
        {
            return 1;
        }
    }
    else if (shorten_hold(row, INT64_C(1), INT64_C(4), problem, axis, work))
    {
        return 1;
    }
    restore_sequence(INT64_C(120), work);
    result = shorten_hold(row, INT64_C(2), INT64_C(4), problem, axis, work);
    return result;
}
static bool release_touch(int64_t kind, array_double_2d work)
{
    int64_t i;
    int64_t row;
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0)))); i += INT64_C(1))
    {
        row = INT64_C(102) + i;
        if (((*cspan_at(&work, row, INT64_C(4))) == kind) && ((*cspan_at(&work, row, INT64_C(7))) == 1.0))
        {
            (*cspan_at(&work, row, INT64_C(7))) = 0.0;
            return 1;
        }
    }
    return 0;
}
static int64_t add_plateau(bool upward, array_double_1d axis, array_double_2d work)
{
    int64_t q;
    int64_t j;
    int64_t kind;
    int64_t lowest;
    q = (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1)))) + INT64_C(2);
    for (j = INT64_C(0); j < q - INT64_C(1); j += INT64_C(1))
    {
        kind = q - INT64_C(1) - j;
        if (upward)
        {
            kind = j + INT64_C(1);
        }
        if ((*cspan_at(&work, INT64_C(196) + kind, INT64_C(0))) > 0.0)
        {
            if (insert_plateau(kind, 0, INT64_C(0), axis, work))
            {
                return kind;
            }
        }
    }
    lowest = q - INT64_C(3);
    if ((lowest > INT64_C(0)) && ((*cspan_at(&work, INT64_C(196) + lowest, INT64_C(0))) > 0.0))
    {
        if (release_touch(lowest, work))
        {
            return q;
        }
    }
    return INT64_C(0);
}
static bool meet_limits(bool upward, double longest, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    int64_t q;
    int64_t added;
    int64_t attempt;
    int64_t place;
    int64_t row;
    passing = span_row(&work, INT64_C(101));
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    added = INT64_C(0);
    for (attempt = INT64_C(0); attempt < INT64_C(16); attempt += INT64_C(1))
    {
        if ((attempt > INT64_C(0)) && (!solve_sequence(problem, axis, work)))
        {
            if ((added == INT64_C(0)) || (added != q - INT64_C(3)))
            {
                return 0;
            }
            restore_sequence(INT64_C(120), work);
            added = INT64_C(0);
            if (!insert_plateau(q - INT64_C(3), 1, INT64_C(0), axis, work))
            {
                return 0;
            }
            if (!solve_sequence(problem, axis, work))
            {
                return 0;
            }
        }
        if (sequence_duration(passing, span_rows(&work, INT64_C(102), INT64_C(120))) >= longest)
        {
            return 0;
        }
        added = INT64_C(0);
        place = overlong_plateau(work);
        if (place >= INT64_C(0))
        {
            row = INT64_C(102) + place;
            if (!touch_limit(row, problem, axis, work))
            {
                return 0;
            }
        }
        else if (!measure_excess(axis, work))
        {
            return 1;
        }
        else
        {
            keep_sequence(INT64_C(120), work);
            added = add_plateau(upward, axis, work);
            if (added == INT64_C(0))
            {
                return 0;
            }
        }
    }
    return 0;
}
static bool may_go_on(array_double_2d work)
{
    bool result;
    result = (*cspan_at(&work, INT64_C(200), INT64_C(4))) < (*cspan_at(&work, INT64_C(200), INT64_C(5)));
    return result;
}
static bool insert_level(int64_t variant, int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    int64_t node;
    int64_t count;
    int64_t place;
    int64_t beside;
    double sign;
    int64_t row;
    bool result;
    passing = span_row(&work, INT64_C(101));
    node = (int64_t)((*cspan_at(&work, INT64_C(196) + order, INT64_C(1))));
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    place = node;
    beside = node;
    sign = 1.0;
    if (variant == INT64_C(0))
    {
        beside = node - INT64_C(1);
    }
    else if (variant == INT64_C(2))
    {
        place = node - INT64_C(1);
        beside = node - INT64_C(1);
    }
    else if (variant == INT64_C(3))
    {
        place = node + INT64_C(1);
    }
    else if (variant == INT64_C(4))
    {
        place = INT64_C(0);
        beside = INT64_C(0);
        sign = -1.0;
    }
    else if (variant == INT64_C(5))
    {
        place = count;
        beside = count - INT64_C(1);
        sign = -1.0;
    }
    if ((place < INT64_C(0)) || (beside < INT64_C(0)) || (beside >= count) || (count > INT64_C(12)))
    {
        return 0;
    }
    row = INT64_C(102) + beside;
    if (((*cspan_at(&passing, INT64_C(13))) > 2.5) || ((*cspan_at(&work, row, INT64_C(4))) > 0.5))
    {
        return 0;
    }
    sign = sign * (*cspan_at(&work, row, INT64_C(5)));
    insert_node(place, INT64_C(0), sign, 0.5 * (*cspan_at(&work, row, INT64_C(6))), 0, work);
    add_instant(order, (*cspan_at(&work, INT64_C(196) + order, INT64_C(3))), node, passing);
    result = solve_rotated(problem, axis, work);
    return result;
}
static bool move_instant(int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    int64_t node;
    int64_t peak;
    passing = span_row(&work, INT64_C(101));
    node = (int64_t)((*cspan_at(&work, INT64_C(196) + order, INT64_C(1))));
    for (peak = INT64_C(0); peak < (int64_t)((*cspan_at(&passing, INT64_C(13)))); peak += INT64_C(1))
    {
        if (((int64_t)((*cspan_at(&passing, INT64_C(14) + peak))) == order) && may_go_on(work))
        {
            place_instant(peak, order, (*cspan_at(&work, INT64_C(196) + order, INT64_C(3))), node, passing);
            if (solve_rotated(problem, axis, work))
            {
                return 1;
            }
            restore_sequence(INT64_C(120), work);
        }
    }
    return 0;
}
static bool compares_levels(array_double_1d axis)
{
    bool result;
    result = ((*cspan_at(&axis, INT64_C(38))) < 1.5) && (!ramps_suffice(axis));
    return result;
}
static double sequence_cost(array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    int64_t end;
    double result;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    if ((*cspan_at(&passing, INT64_C(6))) != 0.0)
    {
        end = (int64_t)((*cspan_at(&passing, INT64_C(0)))) + INT64_C(1);
        result = (-(*cspan_at(&passing, INT64_C(6)))) * (*cspan_at(&nodes, end, INT64_C(0)));
        return result;
    }
    result = sequence_duration(passing, nodes);
    return result;
}
static bool insert_instant(int64_t order, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    double least;
    int64_t variant;
    double cost;
    if (((*cspan_at(&work, INT64_C(200), INT64_C(6))) > 0.5) && move_instant(order, problem, axis, work))
    {
        return 1;
    }
    least = 1e+300;
    for (variant = INT64_C(0); variant < INT64_C(6); variant += INT64_C(1))
    {
        if (may_go_on(work) && insert_level(variant, order, problem, axis, work))
        {
            if (has_pace(span_row(&work, INT64_C(101))) || (!compares_levels(axis)))
            {
                return 1;
            }
            cost = sequence_cost(work);
            if (cost < least)
            {
                least = cost;
                keep_sequence(INT64_C(177), work);
            }
        }
        restore_sequence(INT64_C(120), work);
    }
    if (least < 1e+300)
    {
        restore_sequence(INT64_C(177), work);
    }
    return least < 1e+300;
}
static bool insert_limit(array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t q;
    int64_t order;
    int64_t j;
    int64_t lower;
    double excess;
    int64_t guesses;
    int64_t guess;
    bool result;
    q = (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1)))) + INT64_C(2);
    order = q - INT64_C(1);
    for (j = INT64_C(1); j < q - INT64_C(1); j += INT64_C(1))
    {
        lower = q - INT64_C(1) - j;
        excess = (*cspan_at(&work, INT64_C(196) + order, INT64_C(0)));
        if ((*cspan_at(&work, INT64_C(196) + lower, INT64_C(0))) > excess)
        {
            order = lower;
        }
    }
    keep_sequence(INT64_C(120), work);
    if ((order == q - INT64_C(3)) && insert_instant(order, problem, axis, work))
    {
        return 1;
    }
    guesses = INT64_C(1);
    if (order == q - INT64_C(2))
    {
        guesses = INT64_C(3);
    }
    for (guess = INT64_C(0); guess < guesses; guess += INT64_C(1))
    {
        if (may_go_on(work) && insert_plateau(order, 0, guess, axis, work))
        {
            if (solve_rotated(problem, axis, work))
            {
                return 1;
            }
        }
        restore_sequence(INT64_C(120), work);
    }
    result = (order >= q - INT64_C(2)) && insert_instant(order, problem, axis, work);
    return result;
}
static bool stay_below(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t row;
    keep_sequence(INT64_C(120), work);
    row = INT64_C(102) + place;
    (*cspan_at(&work, row, INT64_C(7))) = 2.0;
    (*cspan_at(&work, row, INT64_C(8))) = 0.0;
    if (solve_rotated(problem, axis, work))
    {
        return 1;
    }
    restore_sequence(INT64_C(120), work);
    return 0;
}
static bool end_highest(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    bool first;
    int64_t row;
    int64_t order;
    double sign;
    double hold;
    bool result;
    first = has_pace(span_row(&work, INT64_C(101))) || (!compares_levels(axis));
    if (first && stay_below(place, problem, axis, work))
    {
        return 1;
    }
    row = INT64_C(102) + place;
    order = (int64_t)((*cspan_at(&work, row, INT64_C(4))));
    sign = (*cspan_at(&work, row, INT64_C(5)));
    hold = (*cspan_at(&work, row, INT64_C(6)));
    remove_node(place, work);
    (*cspan_at(&work, INT64_C(196) + order, INT64_C(1))) = place;
    (*cspan_at(&work, INT64_C(196) + order, INT64_C(3))) = sign;
    keep_sequence(INT64_C(120), work);
    if (insert_instant(order, problem, axis, work))
    {
        return 1;
    }
    insert_node(place, order, sign, hold, 0, work);
    result = (!first) && stay_below(place, problem, axis, work);
    return result;
}
static bool end_plateau(int64_t place, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t row;
    int64_t order;
    double sign;
    int64_t side;
    bool result;
    row = INT64_C(102) + place;
    order = (int64_t)((*cspan_at(&work, row, INT64_C(4))));
    sign = (*cspan_at(&work, row, INT64_C(5)));
    if (order == (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1)))) + INT64_C(1))
    {
        result = end_highest(place, problem, axis, work);
        return result;
    }
    keep_sequence(INT64_C(120), work);
    for (side = INT64_C(0); side < INT64_C(2); side += INT64_C(1))
    {
        remove_node(place, work);
        remove_node(place - side, work);
        add_instant(order, sign, place - side, span_row(&work, INT64_C(101)));
        if (solve_rotated(problem, axis, work))
        {
            return 1;
        }
        restore_sequence(INT64_C(120), work);
    }
    return 0;
}
static bool meet_all(array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t attempt;
    int64_t place;
    for (attempt = INT64_C(0); attempt < INT64_C(10); attempt += INT64_C(1))
    {
        place = overlong_plateau(work);
        if (place >= INT64_C(0))
        {
            if (!end_plateau(place, problem, axis, work))
            {
                return 0;
            }
        }
        else if (!measure_excess(axis, work))
        {
            return 1;
        }
        else if (!insert_limit(problem, axis, work))
        {
            return 0;
        }
    }
    return 0;
}
static int64_t vanishing_level(int64_t step, array_double_2d work)
{
    array_double_1d passing;
    double least;
    int64_t i;
    int64_t row;
    int64_t found;
    passing = span_row(&work, INT64_C(101));
    found = -INT64_C(1);
    least = 0.1 * (*cspan_at(&passing, INT64_C(3)));
    for (i = INT64_C(0); (step > 0) ? (i < (int64_t)((*cspan_at(&passing, INT64_C(0))))) : (i > (int64_t)((*cspan_at(&passing, INT64_C(0))))); i += step)
    {
        row = INT64_C(102) + i;
        if (((*cspan_at(&work, row, INT64_C(4))) < 0.5) && (fabs((*cspan_at(&work, row, INT64_C(6)))) < least))
        {
            found = i;
            least = fabs((*cspan_at(&work, row, INT64_C(6))));
        }
    }
    return found;
}
static bool release_plateau(array_double_2d work)
{
    array_double_1d passing;
    int64_t count;
    int64_t kind;
    int64_t end;
    int64_t i;
    int64_t row;
    bool touches;
    passing = span_row(&work, INT64_C(101));
    count = (int64_t)((*cspan_at(&passing, INT64_C(0))));
    kind = (int64_t)((*cspan_at(&passing, INT64_C(1))));
    end = vanishing_level(span_max_int(count - INT64_C(1), INT64_C(1)), work);
    if ((end < INT64_C(0)) || ((*cspan_at(&passing, INT64_C(13))) > 2.5))
    {
        return 0;
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        row = INT64_C(102) + i;
        touches = ((*cspan_at(&work, row, INT64_C(7))) < 0.5) && ((*cspan_at(&work, row, INT64_C(6))) < 0.0);
        if (touches && ((int64_t)((*cspan_at(&work, row, INT64_C(4)))) == kind))
        {
            (*cspan_at(&work, row, INT64_C(4))) = 0.0;
            add_instant(kind, (*cspan_at(&work, row, INT64_C(5))), i, passing);
            remove_node(end, work);
            return 1;
        }
    }
    return 0;
}
static bool flip_level(array_double_2d work)
{
    int64_t found;
    int64_t row;
    double time;
    found = vanishing_level(INT64_C(1), work);
    if (found < INT64_C(0))
    {
        return 0;
    }
    row = INT64_C(102) + found;
    time = span_max(fabs((*cspan_at(&work, row, INT64_C(6)))), 0.03 * (*cspan_at(&work, INT64_C(101), INT64_C(3))));
    if ((*cspan_at(&work, row, INT64_C(6))) > 0.0)
    {
        time = -time;
    }
    (*cspan_at(&work, row, INT64_C(6))) = time;
    return 1;
}
static bool follow(double target, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t change;
    bool changed;
    for (change = INT64_C(0); change < INT64_C(3); change += INT64_C(1))
    {
        restore_sequence(INT64_C(158), work);
        (*cspan_at(&work, INT64_C(101), INT64_C(12))) = 1.0;
        (*cspan_at(&work, INT64_C(101), INT64_C(5))) = target;
        changed = 1;
        if (change == INT64_C(1))
        {
            changed = release_plateau(work);
        }
        else if (change == INT64_C(2))
        {
            changed = flip_level(work);
        }
        if (changed && may_go_on(work) && solve_rotated(problem, axis, work))
        {
            if (meet_all(problem, axis, work))
            {
                return 1;
            }
        }
    }
    return 0;
}
static void append_level(double sign, double time, array_double_2d work)
{
    int64_t count;
    int64_t row;
    double last;
    count = (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0))));
    if (count > INT64_C(0))
    {
        row = INT64_C(102) + count - INT64_C(1);
        if (((*cspan_at(&work, row, INT64_C(4))) < 0.5) && ((*cspan_at(&work, row, INT64_C(5))) == sign))
        {
            last = (*cspan_at(&work, row, INT64_C(6)));
            (*cspan_at(&work, row, INT64_C(6))) = sqrt(last * last + time * time);
            return;
        }
    }
    insert_node(count, INT64_C(0), sign, time, 0, work);
}
static void append_levels(double change, array_double_1d axis, array_double_2d work)
{
    double sign;
    double duration;
    double slope;
    double rise;
    double hold;
    double time;
    int64_t count;
    if (change == 0.0)
    {
        return;
    }
    sign = 1.0;
    if (change < 0.0)
    {
        sign = -1.0;
    }
    segfmu_ramp_duration(&duration, &slope, fabs(change), axis);
    rise = inner_rise(duration, INT64_C(0), axis);
    hold = span_max(duration - 2.0 * rise, 0.0);
    if ((*cspan_at(&work, INT64_C(101), INT64_C(1))) < 1.5)
    {
        append_level(sign, rise + hold, work);
        return;
    }
    time = rise - inner_rise(rise, INT64_C(1), axis);
    append_level(sign, time, work);
    if (hold > 1e-09 * duration)
    {
        count = (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0))));
        insert_node(count, INT64_C(3), sign, hold, 0, work);
    }
    append_level(-sign, time, work);
}
static int64_t limit_held(int64_t* result_0, double* result_1_0001, double a, double v, array_double_1d axis)
{
    int64_t order;
    double value;
    order = INT64_C(0);
    value = 0.0;
    if (fabs(a) >= side_limit(INT64_C(2), a, axis) * (1.0 - 1e-09))
    {
        order = INT64_C(2);
        value = a;
    }
    else if ((a == 0.0) && (fabs(v) >= side_limit(INT64_C(1), v, axis) * (1.0 - 1e-09)))
    {
        order = INT64_C(1);
        value = v;
    }
    if (value < 0.0)
    {
        (*result_0) = order;
        (*result_1_0001) = -1.0;
        return 0;
    }
    (*result_0) = order;
    (*result_1_0001) = 1.0;
    return 0;
}
static void copy_levels(int64_t count, array_double_2d phases, double v, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    double pending;
    int64_t i;
    double a;
    double change;
    double duration;
    int64_t order;
    double sign;
    passing = span_row(&work, INT64_C(101));
    (*cspan_at(&passing, INT64_C(0))) = 0.0;
    pending = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        a = (*cspan_at(&phases, i, INT64_C(2)));
        change = (*cspan_at(&phases, i, INT64_C(3)));
        duration = (*cspan_at(&phases, i, INT64_C(0)));
        if (change * pending < 0.0)
        {
            append_levels(pending, axis, work);
            pending = 0.0;
        }
        pending = pending + change;
        if (change == 0.0)
        {
            limit_held(&order, &sign, a, v, axis);
            if (order > INT64_C(0))
            {
                append_levels(pending, axis, work);
                pending = 0.0;
                insert_node((int64_t)((*cspan_at(&passing, INT64_C(0)))), order, sign, duration, 0, work);
            }
        }
        v = v + (a + 0.5 * change) * duration;
    }
    append_levels(pending, axis, work);
}
static void begin_sequence(int64_t count, array_double_2d phases, array_double_1d axis, array_double_1d passing)
{
    int64_t i;
    double a;
    (*cspan_at(&passing, INT64_C(1))) = (*cspan_at(&axis, INT64_C(38)));
    (*cspan_at(&passing, INT64_C(2))) = 1.0;
    (*cspan_at(&passing, INT64_C(5))) = 0.0;
    (*cspan_at(&passing, INT64_C(6))) = 0.0;
    (*cspan_at(&passing, INT64_C(13))) = 0.0;
    (*cspan_at(&passing, INT64_C(12))) = 0.0;
    (*cspan_at(&passing, INT64_C(3))) = total_duration(phases, count);
    (*cspan_at(&passing, INT64_C(4))) = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        a = fabs((*cspan_at(&phases, i, INT64_C(2))) + (*cspan_at(&phases, i, INT64_C(3))));
        (*cspan_at(&passing, INT64_C(4))) = span_max((*cspan_at(&passing, INT64_C(4))), a);
        a = fabs((*cspan_at(&phases, i, INT64_C(2))));
        (*cspan_at(&passing, INT64_C(4))) = span_max((*cspan_at(&passing, INT64_C(4))), a);
    }
}
static bool set_sequence(int64_t attempt, int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    int64_t q;
    double factor;
    int64_t i;
    int64_t row;
    passing = span_row(&work, INT64_C(101));
    q = (int64_t)((*cspan_at(&axis, INT64_C(38)))) + INT64_C(2);
    begin_sequence(count, phases, axis, passing);
    if (((*cspan_at(&passing, INT64_C(4))) == 0.0) || has_dip(phases, count))
    {
        return 0;
    }
    copy_levels(count, phases, (*cspan_at(&problem, INT64_C(0))), axis, work);
    if (!is_square(passing, span_rows(&work, INT64_C(102), INT64_C(120))))
    {
        set_alternating(1.0, 0.7 * (*cspan_at(&passing, INT64_C(3))) / q, work);
    }
    factor = 1.0;
    if (q == INT64_C(4))
    {
        factor = 1.25;
    }
    if (span_floor_mod(attempt, INT64_C(3)) == INT64_C(1))
    {
        factor = 1.3 * factor;
    }
    else if (span_floor_mod(attempt, INT64_C(3)) == INT64_C(2))
    {
        factor = 0.8 * factor;
    }
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&passing, INT64_C(0)))); i += INT64_C(1))
    {
        row = INT64_C(102) + i;
        if ((*cspan_at(&work, row, INT64_C(4))) < 0.5)
        {
            (*cspan_at(&work, row, INT64_C(6))) = factor * (*cspan_at(&work, row, INT64_C(6)));
            if (attempt >= INT64_C(3))
            {
                (*cspan_at(&work, row, INT64_C(5))) = -(*cspan_at(&work, row, INT64_C(5)));
            }
        }
        else if (attempt >= INT64_C(3))
        {
            return 0;
        }
    }
    return 1;
}
static bool first_solution(int64_t count, array_double_2d ramps, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t attempt;
    for (attempt = INT64_C(0); attempt < INT64_C(6); attempt += INT64_C(1))
    {
        if (!set_sequence(attempt, count, ramps, problem, axis, work))
        {
            return 0;
        }
        if (solve_rotated(problem, axis, work))
        {
            keep_sequence(INT64_C(158), work);
            return 1;
        }
    }
    return 0;
}
static double largest_excess(array_double_1d axis, array_double_2d work)
{
    int64_t order;
    double largest;
    largest = 0.0;
    if (measure_excess(axis, work))
    {
        for (order = INT64_C(1); order < (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1)))) + INT64_C(2); order += INT64_C(1))
        {
            largest = span_max(largest, (*cspan_at(&work, INT64_C(196) + order, INT64_C(0))));
        }
    }
    return largest;
}
static bool is_brief(array_double_1d axis)
{
    bool result;
    result = ramps_suffice(axis) && ((*cspan_at(&axis, INT64_C(12))) < 0.5);
    return result;
}
static bool shorter_solution(array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    int64_t q;
    double most;
    double duration;
    double sign;
    double scale;
    int64_t attempt;
    bool shorter;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    if (is_brief(axis) || is_resting(problem, axis))
    {
        return 0;
    }
    most = 0.3;
    if ((int64_t)((*cspan_at(&passing, INT64_C(0)))) == q)
    {
        most = 1e+300;
    }
    duration = sequence_duration(passing, nodes);
    sign = (*cspan_at(&work, INT64_C(102), INT64_C(5)));
    scale = duration;
    (*cspan_at(&passing, INT64_C(12))) = 1.0;
    for (attempt = INT64_C(0); attempt < INT64_C(4); attempt += INT64_C(1))
    {
        sign = -sign;
        if (attempt == INT64_C(2))
        {
            if ((*cspan_at(&work, INT64_C(98), INT64_C(19))) >= duration)
            {
                break;
            }
            scale = (*cspan_at(&work, INT64_C(98), INT64_C(19)));
        }
        set_alternating(sign, 0.35 * scale / q, work);
        if (solve_rotated(problem, axis, work))
        {
            shorter = sequence_duration(passing, nodes) < 0.9 * duration;
            if (shorter && (largest_excess(axis, work) < most))
            {
                (*cspan_at(&passing, INT64_C(12))) = 0.0;
                keep_sequence(INT64_C(158), work);
                return 1;
            }
        }
    }
    return 0;
}
static void loosen(double share, array_double_1d axis, array_double_2d work)
{
    array_double_1d loose;
    int64_t i;
    int64_t order;
    double excess;
    double factor;
    int64_t lower;
    loose = span_row(&work, INT64_C(201));
    for (i = INT64_C(0); i < INT64_C(50); i += INT64_C(1))
    {
        (*cspan_at(&loose, i)) = (*cspan_at(&axis, i));
    }
    for (order = INT64_C(1); order < (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(1)))) + INT64_C(2); order += INT64_C(1))
    {
        i = INT64_C(2) + order - INT64_C(1);
        excess = (*cspan_at(&work, INT64_C(200), INT64_C(0) + order));
        factor = pow((1.0 + excess), (1.0 - share));
        (*cspan_at(&loose, i)) = (*cspan_at(&axis, i)) * factor;
        if (order <= INT64_C(2))
        {
            lower = INT64_C(9) + order - INT64_C(1);
            (*cspan_at(&loose, lower)) = (*cspan_at(&axis, lower)) * factor;
        }
    }
}
static bool tighten(double longest, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    array_double_1d steps;
    int64_t order;
    double most;
    double each;
    double least;
    double target;
    double reached;
    double step;
    double share;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    steps = span_row(&work, INT64_C(200));
    measure_excess(axis, work);
    for (order = INT64_C(1); order < (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2); order += INT64_C(1))
    {
        (*cspan_at(&steps, INT64_C(0) + order)) = (*cspan_at(&work, INT64_C(196) + order, INT64_C(0)));
    }
    (*cspan_at(&passing, INT64_C(3))) = sequence_duration(passing, nodes);
    keep_sequence(INT64_C(158), work);
    most = 150.0;
    each = 40.0;
    least = 0.1;
    if (longest > 1.4 * (*cspan_at(&passing, INT64_C(3))))
    {
        most = 400.0;
        least = 0.02;
    }
    if (compares_levels(axis))
    {
        most = most + 500.0;
        each = 200.0;
    }
    (*cspan_at(&steps, INT64_C(4))) = 0.0;
    (*cspan_at(&steps, INT64_C(6))) = 0.0;
    target = (*cspan_at(&passing, INT64_C(5)));
    reached = 0.0;
    step = 1.0;
    while((step > least) && ((*cspan_at(&steps, INT64_C(4))) < most))
    {
        (*cspan_at(&steps, INT64_C(5))) = span_min((*cspan_at(&steps, INT64_C(4))) + each, most);
        share = span_min(reached + step, 1.0);
        loosen(share, axis, work);
        if (follow(target, problem, span_row(&work, INT64_C(201)), work))
        {
            if (sequence_duration(passing, nodes) >= longest)
            {
                return 0;
            }
            if (share == 1.0)
            {
                return 1;
            }
            keep_sequence(INT64_C(158), work);
            reached = share;
        }
        else
        {
            step = 0.5 * step;
        }
    }
    return 0;
}
static bool slow_down(double longest, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    double fast;
    double slow;
    int64_t i;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    fast = 1.0;
    slow = 0.0;
    for (i = INT64_C(0); i < INT64_C(24); i += INT64_C(1))
    {
        (*cspan_at(&passing, INT64_C(2))) = 0.97 * fast;
        if (slow > 0.0)
        {
            (*cspan_at(&passing, INT64_C(2))) = 0.5 * (slow + fast);
        }
        if (!solve_sequence(problem, axis, work))
        {
            break;
        }
        if (sequence_duration(passing, nodes) >= longest)
        {
            break;
        }
        if ((overlong_plateau(work) < INT64_C(0)) && (!measure_excess(axis, work)))
        {
            keep_sequence(INT64_C(120), work);
            slow = (*cspan_at(&passing, INT64_C(2)));
        }
        else
        {
            fast = (*cspan_at(&passing, INT64_C(2)));
        }
        if ((slow > 0.0) && (fast - slow < 0.0001))
        {
            break;
        }
    }
    if (slow > 0.0)
    {
        restore_sequence(INT64_C(120), work);
    }
    return slow > 0.0;
}
static void flush_levels(array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d nodes;
    int64_t i;
    passing = span_row(&work, INT64_C(101));
    nodes = span_rows(&work, INT64_C(102), INT64_C(120));
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&passing, INT64_C(0)))); i += INT64_C(1))
    {
        if (((*cspan_at(&nodes, i, INT64_C(4))) < 0.5) && (fabs((*cspan_at(&nodes, i, INT64_C(6)))) < 1e-13 * (*cspan_at(&passing, INT64_C(3)))))
        {
            (*cspan_at(&nodes, i, INT64_C(6))) = 0.0;
        }
    }
    run_sequence(problem, passing, axis, nodes, span_row(&work, INT64_C(202)));
}
static double idle_time(int64_t i, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    int64_t row;
    double before;
    double scale;
    double spent;
    passing = span_row(&work, INT64_C(101));
    row = INT64_C(102) + i;
    before = (*cspan_at(&passing, INT64_C(8)));
    if (i > INT64_C(0))
    {
        before = (*cspan_at(&work, row - INT64_C(1), INT64_C(9)));
    }
    if ((before != 0.0) || ((*cspan_at(&work, row, INT64_C(9))) == 0.0) || ((*cspan_at(&work, row + INT64_C(1), INT64_C(9))) != 0.0))
    {
        return 0.0;
    }
    spent = (*cspan_at(&work, row, INT64_C(11))) + (*cspan_at(&work, row, INT64_C(10))) + (*cspan_at(&work, row + INT64_C(1), INT64_C(11)));
    scale = residual_scale((int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(1), passing, axis);
    if (fabs((*cspan_at(&work, row, INT64_C(9)))) * spent > 1e-12 * scale)
    {
        return 0.0;
    }
    return spent;
}
static int64_t write_sequence(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    double above;
    double level;
    double idle;
    int64_t i;
    int64_t row;
    double after;
    int64_t state;
    double ramp;
    double basis;
    double change;
    double held;
    double order;
    int64_t kind;
    double sign;
    int64_t used;
    flush_levels(problem, axis, work);
    above = (*cspan_at(&work, INT64_C(101), INT64_C(1)));
    level = (*cspan_at(&work, INT64_C(101), INT64_C(8)));
    used = INT64_C(0);
    idle = 0.0;
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        row = INT64_C(102) + i;
        after = idle;
        idle = idle_time(i, axis, work);
        if (idle > 0.0)
        {
            state = INT64_C(0) + (int64_t)(above) + INT64_C(1);
            used = append_phase(phases, used, idle, 0.0, (*cspan_at(&work, row, state)), 0.0, above - 1.0);
            level = 0.0;
            continue;
        }
        if (after == 0.0)
        {
            ramp = (*cspan_at(&work, row, INT64_C(11)));
            basis = ramp * (*cspan_at(&work, INT64_C(101), INT64_C(2)));
            change = (*cspan_at(&work, row, INT64_C(9))) - level;
            used = append_phase(phases, used, ramp, basis, level, change, above);
        }
        level = (*cspan_at(&work, row, INT64_C(9)));
        if (((*cspan_at(&work, row, INT64_C(10))) > 0.0) && ((*cspan_at(&work, row, INT64_C(7))) < 0.5))
        {
            held = level;
            order = above;
            if (((*cspan_at(&work, row, INT64_C(4))) > 0.5) && (level == 0.0))
            {
                order = span_max((*cspan_at(&work, row, INT64_C(4))) - 2.0, 0.0);
                held = 0.0;
                if ((*cspan_at(&work, row, INT64_C(4))) > 1.5)
                {
                    kind = (int64_t)((*cspan_at(&work, row, INT64_C(4))));
                    sign = (*cspan_at(&work, row, INT64_C(5)));
                    held = sign * side_limit(kind, sign, axis);
                }
            }
            used = append_phase(phases, used, (*cspan_at(&work, row, INT64_C(10))), 0.0, held, 0.0, order);
        }
    }
    return used;
}
static bool stays_below(array_double_2d work)
{
    int64_t i;
    for (i = INT64_C(0); i < (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0)))); i += INT64_C(1))
    {
        if ((*cspan_at(&work, INT64_C(102) + i, INT64_C(7))) > 1.5)
        {
            return 1;
        }
    }
    return 0;
}
static double passing_duration(int64_t way, double longest, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    bool found;
    double result;
    restore_sequence(INT64_C(158), work);
    if (way == INT64_C(3))
    {
        found = tighten(longest, problem, axis, work);
    }
    else if (way == INT64_C(2))
    {
        found = slow_down(longest, problem, axis, work);
    }
    else
    {
        found = meet_limits(way == INT64_C(1), longest, problem, axis, work);
    }
    if (!found)
    {
        return -1.0;
    }
    result = sequence_duration(span_row(&work, INT64_C(101)), span_rows(&work, INT64_C(102), INT64_C(120)));
    return result;
}
static int64_t usual_ways(array_double_1d axis, array_double_2d work)
{
    if (is_brief(axis))
    {
        return INT64_C(2);
    }
    if ((*cspan_at(&work, INT64_C(101), INT64_C(11))) < 0.5)
    {
        return INT64_C(4);
    }
    return INT64_C(3);
}
static int64_t shortest_way(int64_t* result_0, double* result_1_0001, int64_t ways, double shortest, double longest, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t used;
    int64_t way;
    double found;
    used = INT64_C(0);
    for (way = INT64_C(0); way < ways; way += INT64_C(1))
    {
        if ((ways == INT64_C(2)) && (way == INT64_C(1)) && (used == INT64_C(0)))
        {
            break;
        }
        found = passing_duration(way, shortest, problem, axis, work);
        if ((found > 0.0) && (found < shortest))
        {
            shortest = found;
            if (found < longest)
            {
                used = write_sequence(phases, problem, axis, work);
                keep_sequence(INT64_C(139), work);
            }
            if ((way == INT64_C(3)) || ((way < INT64_C(2)) && (!stays_below(work))))
            {
                (*cspan_at(&work, INT64_C(101), INT64_C(10))) = 1.0;
                break;
            }
        }
    }
    (*result_0) = used;
    (*result_1_0001) = shortest;
    return 0;
}
static int64_t passing_form(double shortest, double longest, int64_t count, array_double_2d ramps, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    int64_t ways;
    int64_t used;
    int64_t others;
    passing = span_row(&work, INT64_C(101));
    (*cspan_at(&passing, INT64_C(10))) = 0.0;
    ways = usual_ways(axis, work);
    if (!first_solution(count, ramps, problem, axis, work))
    {
        return INT64_C(0);
    }
    used = INT64_C(0);
    if (((*cspan_at(&passing, INT64_C(11))) < 0.5) && shorter_solution(problem, axis, work))
    {
        shortest_way(&used, &shortest, ways, shortest, longest, phases, problem, axis, work);
        if ((*cspan_at(&passing, INT64_C(10))) > 0.5)
        {
            return used;
        }
        first_solution(count, ramps, problem, axis, work);
    }
    shortest_way(&others, &shortest, ways, shortest, longest, phases, problem, axis, work);
    if (others > INT64_C(0))
    {
        return others;
    }
    return used;
}
static bool pace_down(int64_t moving, double shortest, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_1d taken;
    double target;
    double reached;
    double step;
    double least;
    double duration;
    restore_sequence(INT64_C(139), work);
    passing = span_row(&work, INT64_C(101));
    taken = span_row(&work, INT64_C(200));
    target = (*cspan_at(&problem, INT64_C(5)));
    keep_sequence(INT64_C(158), work);
    (*cspan_at(&taken, INT64_C(4))) = 0.0;
    (*cspan_at(&taken, INT64_C(6))) = moving;
    reached = shortest;
    step = target - shortest;
    least = 0.01 * step;
    while(reached < target)
    {
        (*cspan_at(&taken, INT64_C(5))) = (*cspan_at(&taken, INT64_C(4))) + 40.0;
        duration = span_min(reached + step, target);
        if (follow(duration, problem, axis, work) && ((*cspan_at(&passing, INT64_C(2))) <= 1.0))
        {
            keep_sequence(INT64_C(158), work);
            reached = duration;
        }
        else
        {
            step = 0.5 * step;
        }
        if ((step < least) || ((*cspan_at(&taken, INT64_C(4))) > 300.0))
        {
            return 0;
        }
    }
    return 1;
}
static int64_t timed_passing(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    double shortest;
    int64_t ways;
    int64_t moving;
    int64_t result;
    restore_sequence(INT64_C(139), work);
    shortest = sequence_duration(span_row(&work, INT64_C(101)), span_rows(&work, INT64_C(102), INT64_C(120)));
    if ((*cspan_at(&problem, INT64_C(5))) < shortest)
    {
        return INT64_C(0);
    }
    ways = INT64_C(1);
    if ((*cspan_at(&work, INT64_C(101), INT64_C(13))) > 0.5)
    {
        ways = INT64_C(2);
    }
    for (moving = INT64_C(0); moving < ways; moving += INT64_C(1))
    {
        if (pace_down(moving, shortest, problem, axis, work))
        {
            result = write_sequence(phases, problem, axis, work);
            return result;
        }
    }
    return INT64_C(0);
}
static int64_t slower_form(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    bool backwards;
    if (!is_passing(phases, count, axis))
    {
        return INT64_C(0);
    }
    backwards = (*cspan_at(&work, INT64_C(101), INT64_C(7))) > 0.5;
    if (backwards)
    {
        reverse_problem(problem);
        reverse_axis(axis);
    }
    count = timed_passing(phases, problem, axis, work);
    if (backwards)
    {
        reverse_problem(problem);
        reverse_axis(axis);
        reverse_phases(phases, INT64_C(0), count);
    }
    return count;
}
static double usual_duration(array_double_1d problem, array_double_1d axis)
{
    double top;
    double distance;
    double cruise;
    double result;
    top = span_min((*cspan_at(&axis, INT64_C(3))), (*cspan_at(&axis, INT64_C(9) + INT64_C(1))));
    distance = fabs((*cspan_at(&problem, INT64_C(4))));
    cruise = span_max(fabs((*cspan_at(&problem, INT64_C(0)))), fabs((*cspan_at(&problem, INT64_C(2))))) + sqrt(top * distance);
    cruise = span_min(slowest_velocity(axis), cruise + top * (*cspan_at(&axis, INT64_C(13))));
    result = 4.0 * (cruise / top + (*cspan_at(&axis, INT64_C(13)))) + distance / cruise;
    return result;
}
static int64_t fastest_between(array_double_2d phases, array_double_1d problem, array_double_1d axis)
{
    double v;
    double a;
    double w;
    double b;
    double duration;
    double end;
    double scale;
    int64_t first;
    int64_t i;
    int64_t side;
    double cruise;
    int64_t count;
    v = (*cspan_at(&problem, INT64_C(0)));
    a = (*cspan_at(&problem, INT64_C(1)));
    w = (*cspan_at(&problem, INT64_C(2)));
    b = (*cspan_at(&problem, INT64_C(3)));
    count = append_change(phases, INT64_C(0), a, b, axis);
    if (count > INT64_C(0))
    {
        duration = (*cspan_at(&phases, INT64_C(0), INT64_C(0)));
        end = v + 0.5 * (a + b) * duration;
        scale = fabs(v) + fabs(w) + (fabs(a) + fabs(b)) * duration;
        if (fabs(end - w) <= 1e-13 * span_min(fastest_velocity(axis), scale))
        {
            if (valid_duration(phases, count, problem, axis) >= 0.0)
            {
                return count;
            }
        }
    }
    first = INT64_C(0);
    if ((*cspan_at(&problem, INT64_C(4))) < 0.0)
    {
        first = INT64_C(1);
    }
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        side = span_floor_mod((first + i), INT64_C(2));
        cruise = (*cspan_at(&axis, INT64_C(2)));
        if (side == INT64_C(1))
        {
            cruise = -(*cspan_at(&axis, INT64_C(9)));
        }
        count = with_cruise(phases, cruise, problem, axis);
        if ((count > INT64_C(0)) && (valid_duration(phases, count, problem, axis) >= 0.0))
        {
            return count;
        }
    }
    return INT64_C(0);
}
static bool may_detour(array_double_1d problem, array_double_1d axis)
{
    double slowest;
    bool result;
    slowest = slowest_velocity(axis);
    if (slowest == fastest_velocity(axis))
    {
        return 0;
    }
    result = span_max(fabs((*cspan_at(&problem, INT64_C(0)))), fabs((*cspan_at(&problem, INT64_C(2))))) > slowest;
    return result;
}
static int64_t shortest_between(int64_t attempt, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_2d trial;
    array_double_1d family;
    double shortest;
    int64_t found;
    int64_t branch;
    int64_t count;
    double duration;
    int64_t best;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    family = span_row(&work, INT64_C(98));
    best = INT64_C(0);
    shortest = 0.0;
    if (attempt == INT64_C(0))
    {
        best = fastest_between(phases, problem, axis);
        if (best > INT64_C(0))
        {
            shortest = total_duration(phases, best);
            if (!may_detour(problem, axis))
            {
                return best;
            }
        }
    }
    found = -INT64_C(1);
    for (branch = INT64_C(0); branch < INT64_C(6) - attempt; branch += INT64_C(1))
    {
        if ((attempt == INT64_C(0)) && (found == branch - INT64_C(1)) && same_members(branch, problem, family))
        {
            continue;
        }
        if ((branch >= INT64_C(4)) && (attempt == INT64_C(0)) && (found >= INT64_C(0)))
        {
            break;
        }
        if ((branch == INT64_C(4)) && (attempt == INT64_C(1)))
        {
            count = slower_cruise(trial, problem, axis);
        }
        else if (branch >= INT64_C(4))
        {
            count = direct_form(trial, branch == INT64_C(4), problem, axis);
        }
        else
        {
            set_family(branch, problem, axis, family);
            if (attempt == INT64_C(0))
            {
                count = merged_form(trial, (*cspan_at(&family, INT64_C(4))), family, axis);
            }
            else
            {
                count = tempered_form(trial, family, axis);
            }
        }
        if (count > INT64_C(0))
        {
            duration = valid_duration(trial, count, problem, axis);
            if (attempt == INT64_C(0))
            {
                (*cspan_at(&family, INT64_C(19))) = span_min((*cspan_at(&family, INT64_C(19))), total_duration(trial, count));
            }
            if (duration >= 0.0)
            {
                found = branch;
            }
            if ((duration >= 0.0) && ((best == INT64_C(0)) || (duration < shortest)))
            {
                copy_phases(trial, phases, count);
                best = count;
                shortest = duration;
            }
        }
    }
    return best;
}
static bool is_done(array_double_1d problem)
{
    bool result;
    if (((*cspan_at(&problem, INT64_C(4))) != 0.0) || ((*cspan_at(&problem, INT64_C(0))) != (*cspan_at(&problem, INT64_C(2)))))
    {
        return 0;
    }
    result = (*cspan_at(&problem, INT64_C(1))) == (*cspan_at(&problem, INT64_C(3)));
    return result;
}
static int64_t braked_variant(int64_t* result_0_0001, double* result_1_0001, int64_t variant, double longest, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    array_double_2d trial;
    array_double_2d candidate;
    array_double_1d rest;
    int64_t taken;
    double spent;
    int64_t count;
    double duration;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    candidate = span_rows(&work, INT64_C(21), INT64_C(42));
    rest = span_row(&work, INT64_C(60));
    braked(&taken, &spent, span_floor_mod(variant, INT64_C(4)), problem, axis, work);
    if (taken == -INT64_C(3))
    {
        (*result_0_0001) = INT64_C(0);
        (*result_1_0001) = 0.0;
        return 0;
    }
    if (taken < INT64_C(0))
    {
        (*result_0_0001) = taken;
        (*result_1_0001) = 0.0;
        return 0;
    }
    count = shortest_between(span_floor_div(variant, INT64_C(4)), candidate, rest, axis, work);
    if ((count == INT64_C(0)) && (variant == INT64_C(4)))
    {
        count = shorter_cruise(INT64_C(0), candidate, rest, axis, trial);
    }
    if ((count == INT64_C(0)) && (!(is_done(rest) && ((*cspan_at(&rest, INT64_C(1))) == 0.0))))
    {
        (*result_0_0001) = INT64_C(0);
        (*result_1_0001) = 0.0;
        return 0;
    }
    duration = valid_duration(candidate, count, rest, axis);
    if ((duration < 0.0) || (spent + duration >= longest))
    {
        (*result_0_0001) = INT64_C(0);
        (*result_1_0001) = 0.0;
        return 0;
    }
    count = surround(candidate, count, span_floor_mod(variant, INT64_C(4)), problem, axis, work);
    copy_phases(candidate, phases, count);
    (*result_0_0001) = count;
    (*result_1_0001) = spent + duration;
    return 0;
}
static int64_t braked_ramps(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    int64_t best;
    double shortest;
    double usual;
    int64_t variant;
    int64_t count;
    double duration;
    best = INT64_C(0);
    shortest = 1e+300;
    usual = usual_duration(problem, axis);
    for (variant = INT64_C(1); variant < INT64_C(8); variant += INT64_C(1))
    {
        if ((variant > INT64_C(4)) && (best > INT64_C(0)) && (shortest <= usual))
        {
            break;
        }
        braked_variant(&count, &duration, variant, shortest, problem, axis, phases, work);
        if (count < INT64_C(0))
        {
            return count;
        }
        if (count > INT64_C(0))
        {
            best = count;
            shortest = duration;
        }
    }
    if (best == INT64_C(0))
    {
        return -INT64_C(3);
    }
    return best;
}
static bool crosses_zero(int64_t row, array_double_2d phases)
{
    double a;
    bool result;
    a = (*cspan_at(&phases, row, INT64_C(2)));
    result = a * (a + (*cspan_at(&phases, row, INT64_C(3)))) < 0.0;
    return result;
}
static int64_t shorter_braked(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    bool first;
    bool last;
    double longest;
    int64_t variant;
    int64_t used;
    double duration;
    first = crosses_zero(INT64_C(0), phases);
    last = crosses_zero(count - INT64_C(1), phases);
    longest = total_duration(phases, count) * (1.0 - 1e-10);
    for (variant = INT64_C(1); variant < INT64_C(4); variant += INT64_C(1))
    {
        if (((variant == INT64_C(2)) || first) && ((variant == INT64_C(1)) || last))
        {
            braked_variant(&used, &duration, variant, longest, problem, axis, phases, work);
            if (used > INT64_C(0))
            {
                count = used;
                longest = duration;
            }
        }
    }
    return count;
}
static int64_t shorter_than_detour(int64_t count, array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    double longest;
    int64_t variant;
    int64_t used;
    double duration;
    longest = total_duration(phases, count) * (1.0 - 1e-10);
    for (variant = INT64_C(1); variant < INT64_C(8); variant += INT64_C(1))
    {
        braked_variant(&used, &duration, variant, longest, problem, axis, phases, work);
        if (used > INT64_C(0))
        {
            count = used;
            longest = duration;
        }
    }
    return count;
}
static int64_t passing_either_way(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work)
{
    array_double_2d ramps;
    array_double_1d passing;
    double longest;
    double whole;
    int64_t forwards;
    double settled;
    int64_t result;
    int64_t backwards;
    ramps = span_rows(&work, INT64_C(0), INT64_C(21));
    passing = span_row(&work, INT64_C(101));
    (*cspan_at(&passing, INT64_C(8))) = 0.0;
    (*cspan_at(&passing, INT64_C(9))) = 0.0;
    copy_phases(phases, ramps, count);
    longest = total_duration(ramps, count) * (1.0 - 1e-09);
    whole = longest;
    forwards = passing_form(whole, longest, count, ramps, phases, asked, axis, work);
    settled = (*cspan_at(&passing, INT64_C(10)));
    (*cspan_at(&passing, INT64_C(7))) = 0.0;
    result = count;
    if (forwards > INT64_C(0))
    {
        if ((settled > 0.5) && ramps_suffice(axis))
        {
            return forwards;
        }
        longest = total_duration(phases, forwards);
        result = forwards;
    }
    reverse_problem(asked);
    reverse_axis(axis);
    reverse_phases(ramps, INT64_C(0), count);
    backwards = passing_form(whole, longest, count, ramps, phases, asked, axis, work);
    reverse_problem(asked);
    reverse_axis(axis);
    if (backwards > INT64_C(0))
    {
        reverse_phases(phases, INT64_C(0), backwards);
        (*cspan_at(&passing, INT64_C(7))) = 1.0;
        return backwards;
    }
    if (forwards > INT64_C(0))
    {
        (*cspan_at(&passing, INT64_C(10))) = settled;
    }
    return result;
}
static bool set_dips(double v, double a, double end, array_double_1d axis, array_double_1d dips, array_double_2d work)
{
    double duration;
    double slope;
    double reached;
    (*cspan_at(&dips, INT64_C(0))) = v;
    (*cspan_at(&dips, INT64_C(2))) = a;
    (*cspan_at(&dips, INT64_C(3))) = 0.0;
    segfmu_ramp_duration(&duration, &slope, fabs(a), axis);
    reached = v + 0.5 * a * duration;
    if (!is_beyond(reached, reached, 1.0, axis))
    {
        return 1;
    }
    if (!find_dips(v, a, end, axis, dips, work))
    {
        return 0;
    }
    find_deepest(axis, dips, work);
    return 1;
}
static double problem_between(double depth, array_double_1d asked, array_double_1d axis, array_double_1d rest, array_double_2d work)
{
    array_double_2d trial;
    int64_t first;
    double spent;
    double y;
    double v;
    int64_t last;
    double duration;
    double w;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    write_dip(&first, &spent, &y, &v, depth, axis, span_row(&work, INT64_C(63)), trial, work);
    (*cspan_at(&rest, INT64_C(0))) = v;
    (*cspan_at(&rest, INT64_C(1))) = (*cspan_at(&work, INT64_C(63), INT64_C(2)));
    (*cspan_at(&rest, INT64_C(4))) = (*cspan_at(&asked, INT64_C(4))) - y;
    write_dip(&last, &duration, &y, &w, depth, axis, span_row(&work, INT64_C(64)), trial, work);
    (*cspan_at(&rest, INT64_C(2))) = w;
    (*cspan_at(&rest, INT64_C(3))) = -(*cspan_at(&work, INT64_C(64), INT64_C(2)));
    (*cspan_at(&rest, INT64_C(4))) = (*cspan_at(&rest, INT64_C(4))) - y;
    return spent + duration;
}
static int64_t profile_between(array_double_1d rest, array_double_1d axis, array_double_2d work)
{
    array_double_2d phases;
    int64_t count;
    int64_t result;
    phases = span_rows(&work, INT64_C(65), INT64_C(98));
    if (is_done(rest))
    {
        return INT64_C(0);
    }
    count = shortest_between(INT64_C(0), phases, rest, axis, work);
    if (count == INT64_C(0))
    {
        count = braked_ramps(rest, axis, phases, work);
    }
    if (count <= INT64_C(0))
    {
        return -INT64_C(1);
    }
    result = passing_either_way(count, phases, rest, axis, work);
    return result;
}
static int64_t with_dips(double depth, int64_t count, array_double_2d phases, array_double_1d axis, array_double_2d work)
{
    array_double_2d trial;
    array_double_2d between;
    int64_t used;
    double duration;
    double y;
    double v;
    int64_t last;
    int64_t result;
    trial = span_rows(&work, INT64_C(0), INT64_C(21));
    between = span_rows(&work, INT64_C(65), INT64_C(98));
    write_dip(&used, &duration, &y, &v, depth, axis, span_row(&work, INT64_C(63)), phases, work);
    used = join_phases(between, count, phases, used);
    write_dip(&last, &duration, &y, &v, depth, axis, span_row(&work, INT64_C(64)), trial, work);
    reverse_phases(trial, INT64_C(0), last);
    result = join_phases(trial, last, phases, used);
    return result;
}
static int64_t dipped_profile(double depth, double longest, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work)
{
    array_double_1d rest;
    array_double_2d between;
    double spent;
    int64_t count;
    int64_t result;
    rest = span_row(&work, INT64_C(61));
    between = span_rows(&work, INT64_C(65), INT64_C(98));
    spent = problem_between(depth, asked, axis, rest, work);
    if (spent >= longest)
    {
        return INT64_C(0);
    }
    count = profile_between(rest, axis, work);
    if ((count < INT64_C(0)) || (spent + total_duration(between, count) >= longest))
    {
        return INT64_C(0);
    }
    result = with_dips(depth, count, phases, axis, work);
    return result;
}
static bool set_both_dips(double end, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d first;
    array_double_1d last;
    bool found;
    bool result;
    first = span_row(&work, INT64_C(63));
    last = span_row(&work, INT64_C(64));
    if (!set_dips((*cspan_at(&problem, INT64_C(0))), (*cspan_at(&problem, INT64_C(1))), end, axis, first, work))
    {
        return 0;
    }
    reverse_axis(axis);
    found = set_dips((*cspan_at(&problem, INT64_C(2))), -(*cspan_at(&problem, INT64_C(3))), end, axis, last, work);
    reverse_axis(axis);
    if (!found)
    {
        return 0;
    }
    result = (*cspan_at(&first, INT64_C(3))) + (*cspan_at(&last, INT64_C(3))) > 0.0;
    return result;
}
static int64_t best_depth(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work)
{
    double middle;
    double best;
    int64_t sweep;
    int64_t i;
    double depth;
    double longest;
    int64_t taken;
    middle = 0.5;
    best = -1.0;
    for (sweep = INT64_C(0); sweep < INT64_C(3); sweep += INT64_C(1))
    {
        for (i = -INT64_C(2); i < INT64_C(3); i += INT64_C(1))
        {
            depth = middle + 0.25 * i / pow(2.0, (double)(sweep));
            if ((sweep > INT64_C(0)) && ((span_floor_mod(i, INT64_C(2)) == INT64_C(0)) || (depth < 0.0) || (depth > 1.0)))
            {
                continue;
            }
            longest = total_duration(phases, count) * (1.0 - 1e-09);
            taken = dipped_profile(depth, longest, phases, asked, axis, work);
            if (taken > INT64_C(0))
            {
                count = taken;
                best = depth;
            }
        }
        if (best < 0.0)
        {
            break;
        }
        middle = best;
    }
    return count;
}
static int64_t shorter_dipped(int64_t count, array_double_2d phases, array_double_1d asked, array_double_1d axis, array_double_2d work)
{
    int64_t i;
    double end;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        end = 0.45 * i * span_min((*cspan_at(&axis, INT64_C(3))), (*cspan_at(&axis, INT64_C(9) + INT64_C(1))));
        if (set_both_dips(end, asked, axis, work))
        {
            count = best_depth(count, phases, asked, axis, work);
        }
    }
    return count;
}
static void surround_with_dips(int64_t column, double depth, array_double_2d phases, array_double_1d axis, array_double_2d work)
{
    int64_t count;
    double duration;
    count = (int64_t)((*cspan_at(&work, INT64_C(58), column)));
    if (count > INT64_C(0))
    {
        copy_phases(phases, span_rows(&work, INT64_C(65), INT64_C(98)), count);
        count = with_dips(depth, count, phases, axis, work);
        duration = (*cspan_at(&work, INT64_C(59), INT64_C(5)));
        (*cspan_at(&work, INT64_C(58), column)) = fit_duration(phases, count, duration);
    }
}
static double timed_between_dips(array_double_1d rest, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d nearest;
    array_double_2d between;
    int64_t count;
    double result;
    nearest = span_row(&work, INT64_C(58));
    between = span_rows(&work, INT64_C(65), INT64_C(98));
    clear_nearest(work);
    if ((*cspan_at(&rest, INT64_C(5))) <= 0.0)
    {
        return -1.0;
    }
    timed_between(rest, axis, cell, work);
    if (is_enclosed(work))
    {
        result = nearest_weight(rest, axis, nearest);
        return result;
    }
    clear_nearest(work);
    count = slower_form(profile_between(rest, axis, work), between, rest, axis, work);
    copy_phases(between, span_rows(&cell, INT64_C(0), INT64_C(33)), count);
    (*cspan_at(&nearest, INT64_C(0))) = count;
    if (count == INT64_C(0))
    {
        return -1.0;
    }
    return 0.0;
}
static double timed_dipped(array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    array_double_1d rest;
    int64_t i;
    double depth;
    double spent;
    array_double_2d below;
    array_double_2d above;
    double weight;
    problem = span_row(&work, INT64_C(59));
    rest = span_row(&work, INT64_C(61));
    if (!set_both_dips(0.0, problem, axis, work))
    {
        return -1.0;
    }
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        depth = 0.25 * i;
        spent = problem_between(depth, problem, axis, rest, work);
        (*cspan_at(&rest, INT64_C(5))) = (*cspan_at(&problem, INT64_C(5))) - spent;
        weight = timed_between_dips(rest, axis, cell, work);
        if (weight >= 0.0)
        {
            below = span_rows(&cell, INT64_C(0), INT64_C(33));
            above = span_rows(&cell, INT64_C(33), INT64_C(66));
            surround_with_dips(INT64_C(0), depth, below, axis, work);
            surround_with_dips(INT64_C(2), depth, above, axis, work);
            return weight;
        }
    }
    return -1.0;
}
static double sign_of(double value)
{
    if (value < 0.0)
    {
        return -1.0;
    }
    return 1.0;
}
static bool may_touch(double v, double a, array_double_1d axis)
{
    double duration;
    double slope;
    double sign;
    bool result;
    segfmu_ramp_duration(&duration, &slope, fabs(a), axis);
    sign = sign_of(a);
    result = sign * v + 0.5 * fabs(a) * duration > 0.9 * side_limit(INT64_C(1), sign, axis);
    return result;
}
static void set_touching(int64_t variant, double duration, array_double_1d problem, array_double_2d work)
{
    array_double_1d passing;
    int64_t q;
    double sign;
    double time;
    double last;
    passing = span_row(&work, INT64_C(101));
    q = (int64_t)((*cspan_at(&passing, INT64_C(1)))) + INT64_C(2);
    sign = 1.0;
    if (span_floor_mod(variant, INT64_C(2)) == INT64_C(1))
    {
        sign = -1.0;
    }
    time = duration / (q + INT64_C(2));
    if (q == INT64_C(4))
    {
        time = 0.7 * time;
    }
    set_alternating(sign, time, work);
    last = sign * (1.0 - 2.0 * (span_floor_mod(q, INT64_C(2))));
    insert_node(q, INT64_C(0), last, time, 0, work);
    if (variant < INT64_C(4))
    {
        add_instant(INT64_C(1), sign_of((*cspan_at(&problem, INT64_C(1)))), INT64_C(1) + span_floor_div(variant, INT64_C(2)), passing);
    }
    else
    {
        add_instant(INT64_C(1), sign_of(-(*cspan_at(&problem, INT64_C(3)))), q - INT64_C(1), passing);
    }
    if (variant >= INT64_C(6))
    {
        insert_node(q + INT64_C(1), INT64_C(0), -last, time, 0, work);
        add_instant(INT64_C(1), sign_of((*cspan_at(&problem, INT64_C(1)))), INT64_C(1), passing);
    }
}
static int64_t touching_guess(int64_t* result_0_0001, double* result_1, int64_t attempt)
{
    int64_t time;
    double share;
    if (attempt >= INT64_C(30))
    {
        (*result_0_0001) = INT64_C(6) + span_floor_mod(attempt, INT64_C(2));
        (*result_1) = 0.5 + 0.15 * (span_floor_div((attempt - INT64_C(30)), INT64_C(2)));
        return 0;
    }
    time = span_floor_div(attempt, INT64_C(6));
    share = 0.65;
    if (time == INT64_C(1))
    {
        share = 0.5;
    }
    else if (time == INT64_C(2))
    {
        share = 0.75;
    }
    else if (time == INT64_C(3))
    {
        share = 1.0;
    }
    else if (time == INT64_C(4))
    {
        share = 0.35;
    }
    (*result_0_0001) = span_floor_mod(attempt, INT64_C(6));
    (*result_1) = share;
    return 0;
}
static int64_t touching_starts(int64_t* result_0, double* result_1_0001, int64_t count, double longest, array_double_2d ramps, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    double whole;
    bool first;
    bool last;
    int64_t used;
    double before;
    int64_t attempts;
    int64_t ways;
    int64_t attempt;
    int64_t variant;
    double share;
    double duration;
    int64_t found;
    passing = span_row(&work, INT64_C(101));
    whole = total_duration(ramps, count);
    first = may_touch((*cspan_at(&problem, INT64_C(0))), (*cspan_at(&problem, INT64_C(1))), axis);
    last = may_touch((*cspan_at(&problem, INT64_C(2))), -(*cspan_at(&problem, INT64_C(3))), axis);
    used = INT64_C(0);
    before = 0.0;
    attempts = INT64_C(34);
    ways = usual_ways(axis, work);
    if (ramps_suffice(axis))
    {
        attempts = INT64_C(6);
        ways = INT64_C(2);
    }
    for (attempt = INT64_C(0); attempt < attempts; attempt += INT64_C(1))
    {
        touching_guess(&variant, &share, attempt);
        if (((variant < INT64_C(4)) || (variant > INT64_C(5))) && (!first))
        {
            continue;
        }
        if ((variant > INT64_C(3)) && (!last))
        {
            continue;
        }
        begin_sequence(count, ramps, axis, passing);
        set_touching(variant, share * whole, problem, work);
        if (!solve_rotated(problem, axis, work))
        {
            continue;
        }
        duration = sequence_duration(passing, span_rows(&work, INT64_C(102), INT64_C(120)));
        if ((duration < longest) && (fabs(duration - before) > 1e-09 * duration))
        {
            before = duration;
            keep_sequence(INT64_C(158), work);
            shortest_way(&found, &longest, ways, longest, longest, phases, problem, axis, work);
            if (found > INT64_C(0))
            {
                used = found;
            }
        }
    }
    (*result_0) = used;
    (*result_1_0001) = longest;
    return 0;
}
static int64_t touching_form(int64_t count, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    array_double_2d ramps;
    double longest;
    int64_t result;
    int64_t backwards;
    passing = span_row(&work, INT64_C(101));
    ramps = span_rows(&work, INT64_C(0), INT64_C(21));
    copy_phases(phases, ramps, count);
    (*cspan_at(&passing, INT64_C(8))) = 0.0;
    (*cspan_at(&passing, INT64_C(9))) = 0.0;
    longest = total_duration(ramps, count) * (1.0 - 1e-09);
    touching_starts(&result, &longest, count, longest, ramps, phases, problem, axis, work);
    reverse_problem(problem);
    reverse_axis(axis);
    touching_starts(&backwards, &longest, count, longest, ramps, phases, problem, axis, work);
    reverse_problem(problem);
    reverse_axis(axis);
    if (backwards > INT64_C(0))
    {
        reverse_phases(phases, INT64_C(0), backwards);
        (*cspan_at(&passing, INT64_C(7))) = 1.0;
        return backwards;
    }
    if (result > INT64_C(0))
    {
        (*cspan_at(&passing, INT64_C(7))) = 0.0;
        return result;
    }
    return count;
}
static double least_lever(double c, double gain, double top, array_double_1d axis)
{
    double jerk;
    double rise;
    double rest;
    double hold;
    if (gain <= 0.0)
    {
        return 0.0;
    }
    jerk = (*cspan_at(&axis, INT64_C(4)));
    rise = (top - c) / jerk;
    rest = gain - (c + 0.5 * jerk * rise) * rise;
    if (rest <= 0.0)
    {
        rise = (sqrt(c * c + 2.0 * jerk * gain) - c) / jerk;
        rest = 0.0;
    }
    hold = rest / top;
    return (0.5 * c + jerk * rise / 3.0) * rise * rise + rest * (rise + 0.5 * hold);
}
static double early_window(double duration, array_double_1d problem, array_double_1d axis)
{
    double sign;
    double v;
    double a;
    double w;
    double b;
    double distance;
    double gain;
    double single;
    double slope;
    double top;
    double jerk;
    double first;
    double last;
    double late;
    double early;
    double rounding;
    double least;
    double most;
    double slowest;
    double fastest;
    sign = 1.0;
    if ((*cspan_at(&problem, INT64_C(1))) + (*cspan_at(&problem, INT64_C(3))) < 0.0)
    {
        sign = -1.0;
    }
    v = sign * (*cspan_at(&problem, INT64_C(0)));
    a = sign * (*cspan_at(&problem, INT64_C(1)));
    w = sign * (*cspan_at(&problem, INT64_C(2)));
    b = sign * (*cspan_at(&problem, INT64_C(3)));
    distance = sign * (*cspan_at(&problem, INT64_C(4)));
    gain = w - v;
    if ((a < 0.0) || (b < 0.0) || (a + b == 0.0) || ((*cspan_at(&axis, INT64_C(0))) < 3.0))
    {
        return 0.0;
    }
    segfmu_ramp_duration(&single, &slope, fabs(b - a), axis);
    if (gain < 0.5 * (a + b) * single * (1.0 - 1e-12))
    {
        return 0.0;
    }
    top = side_limit(INT64_C(2), sign, axis);
    jerk = (*cspan_at(&axis, INT64_C(4)));
    first = 0.0;
    last = 0.0;
    late = 0.0;
    early = 0.0;
    if ((jerk > 0.0) && ((*cspan_at(&axis, INT64_C(15))) > 0.0) && ((*cspan_at(&axis, INT64_C(14))) > 0.5))
    {
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
    if (slowest > 0.0)
    {
        most = span_min(most, (distance - late) / slowest);
    }
    else if (slowest < 0.0)
    {
        least = span_max(least, (distance - late) / slowest);
    }
    else if (late > distance)
    {
        return 0.0;
    }
    if (fastest > 0.0)
    {
        least = span_max(least, (distance + early) / fastest);
    }
    else if (fastest < 0.0)
    {
        most = span_min(most, (distance + early) / fastest);
    }
    else if (distance + early > 0.0)
    {
        return 0.0;
    }
    if (most < least * (1.0 - 1e-09))
    {
        return 0.0;
    }
    return span_min(most * (1.0 + 1e-09), duration);
}
static double short_window(double duration, array_double_1d problem, array_double_1d axis, array_double_1d rest)
{
    double a;
    double b;
    int64_t i;
    double spent;
    double slope;
    double distance;
    double longest;
    double result;
    a = (*cspan_at(&problem, INT64_C(1)));
    b = (*cspan_at(&problem, INT64_C(3)));
    if (a * b >= 0.0)
    {
        result = early_window(duration, problem, axis);
        return result;
    }
    if (span_min(fabs(a), fabs(b)) > 0.2 * span_max(fabs(a), fabs(b)))
    {
        return 0.0;
    }
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        (*cspan_at(&rest, i)) = (*cspan_at(&problem, i));
    }
    if (fabs(a) < fabs(b))
    {
        segfmu_ramp_duration(&spent, &slope, fabs(a), axis);
        distance = ramp_distance((*cspan_at(&problem, INT64_C(0))), a, 0.0, spent, spent, axis);
        (*cspan_at(&rest, INT64_C(0))) = (*cspan_at(&problem, INT64_C(0))) + 0.5 * a * spent;
        (*cspan_at(&rest, INT64_C(1))) = 0.0;
    }
    else
    {
        segfmu_ramp_duration(&spent, &slope, fabs(b), axis);
        (*cspan_at(&rest, INT64_C(2))) = (*cspan_at(&problem, INT64_C(2))) - 0.5 * b * spent;
        distance = ramp_distance((*cspan_at(&rest, INT64_C(2))), 0.0, b, spent, spent, axis);
        (*cspan_at(&rest, INT64_C(3))) = 0.0;
    }
    (*cspan_at(&rest, INT64_C(4))) = (*cspan_at(&problem, INT64_C(4))) - distance;
    longest = early_window(duration - spent, rest, axis);
    if (longest > 0.0)
    {
        return longest + spent;
    }
    return 0.0;
}
static void begin_search(array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    boundary_problem(problem, axis, span_row(&work, INT64_C(59)));
    (*cspan_at(&work, INT64_C(98), INT64_C(20))) = INT64_C(0);
    (*cspan_at(&work, INT64_C(98), INT64_C(21))) = 0.0;
    (*cspan_at(&work, INT64_C(98), INT64_C(19))) = 1e+300;
    (*cspan_at(&work, INT64_C(101), INT64_C(11))) = 0.0;
}
static int64_t shortest_ramps(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    array_double_1d asked;
    int64_t count;
    asked = span_row(&work, INT64_C(59));
    begin_search(problem, axis, work);
    if (is_done(asked))
    {
        return INT64_C(0);
    }
    count = shortest_between(INT64_C(0), phases, asked, axis, work);
    if (count == INT64_C(0))
    {
        count = braked_ramps(asked, axis, phases, work);
    }
    return count;
}
static int64_t usual_braked(array_double_1d asked, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    double free;
    int64_t status;
    double longest;
    bool settled;
    bool passing;
    int64_t last;
    int64_t count;
    double window;
    int64_t result;
    free = (*cspan_at(&work, INT64_C(98), INT64_C(19)));
    status = braked_ramps(asked, axis, phases, work);
    longest = usual_duration(asked, axis);
    if (status > INT64_C(0))
    {
        settled = 0;
        if ((*cspan_at(&axis, INT64_C(38))) > 0.5)
        {
            status = passing_either_way(status, phases, asked, axis, work);
            settled = ((*cspan_at(&work, INT64_C(101), INT64_C(10))) > 0.5) && ramps_suffice(axis);
        }
        longest = total_duration(phases, status);
        if (settled && (longest <= 1.1 * free) && (early_window(longest, asked, axis) <= 0.0))
        {
            return status;
        }
    }
    passing = (*cspan_at(&asked, INT64_C(1))) * (*cspan_at(&asked, INT64_C(3))) <= 0.0;
    if (is_resting(asked, axis) || (passing && (status < INT64_C(0)) && (status != -INT64_C(3))))
    {
        return status;
    }
    last = INT64_C(6);
    count = span_max_int(status, INT64_C(0));
    window = short_window(longest, asked, axis, span_row(&work, INT64_C(60)));
    if (window > 0.0)
    {
        count = loop_form(last, count, window, phases, asked, axis, work);
    }
    else if ((status > INT64_C(0)) && ramps_suffice(axis))
    {
        last = INT64_C(2);
    }
    if ((count == INT64_C(0)) || (total_duration(phases, count) >= longest))
    {
        count = loop_form(last, count, longest, phases, asked, axis, work);
    }
    if (count == INT64_C(0))
    {
        return status;
    }
    if (((*cspan_at(&axis, INT64_C(38))) > 0.5) && ((status < INT64_C(0)) || (total_duration(phases, count) < longest)))
    {
        result = passing_either_way(count, phases, asked, axis, work);
        return result;
    }
    return count;
}
static int64_t shortest_braked(array_double_1d asked, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    double free;
    double most;
    double far;
    int64_t status;
    free = (*cspan_at(&work, INT64_C(98), INT64_C(19)));
    status = usual_braked(asked, axis, phases, work);
    if ((status <= INT64_C(0)) || ((*cspan_at(&axis, INT64_C(38))) < 0.5))
    {
        return status;
    }
    most = 1.05 * free;
    far = most;
    if (ramps_suffice(axis))
    {
        most = 1.1 * free;
        far = 2.0 * free;
    }
    else if (total_duration(phases, status) > most)
    {
        status = shorter_dipped(status, phases, asked, axis, work);
    }
    if (((*cspan_at(&axis, INT64_C(12))) > 0.5) && (total_duration(phases, status) > far))
    {
        status = touching_form(status, phases, asked, axis, work);
    }
    (*cspan_at(&work, INT64_C(98), INT64_C(21))) = total_duration(phases, status) > most;
    return status;
}
static bool misses_little(double free, double duration, array_double_1d asked, array_double_1d axis)
{
    bool result;
    if (duration > 1.3 * free)
    {
        return 1;
    }
    if (early_window(duration, asked, axis) > 0.0)
    {
        return 1;
    }
    if (nearly_brakes((*cspan_at(&asked, INT64_C(0))), (*cspan_at(&asked, INT64_C(1))), axis))
    {
        return 1;
    }
    result = nearly_brakes((*cspan_at(&asked, INT64_C(2))), -(*cspan_at(&asked, INT64_C(3))), axis);
    return result;
}
static int64_t begun_profile(array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    array_double_1d asked;
    array_double_1d family;
    int64_t missed;
    double free;
    array_double_1d rest;
    double longest;
    array_double_2d trial;
    int64_t count;
    asked = span_row(&work, INT64_C(59));
    family = span_row(&work, INT64_C(98));
    (*cspan_at(&work, INT64_C(101), INT64_C(10))) = 1.0;
    if (is_done(asked))
    {
        return INT64_C(0);
    }
    count = shortest_between(INT64_C(0), phases, asked, axis, work);
    if ((count > INT64_C(0)) && may_detour(asked, axis))
    {
        count = shorter_than_detour(count, asked, axis, phases, work);
    }
    missed = (int64_t)((*cspan_at(&family, INT64_C(20))));
    if (count == INT64_C(0))
    {
        free = (*cspan_at(&family, INT64_C(19)));
        count = shortest_braked(asked, axis, phases, work);
        if ((*cspan_at(&work, INT64_C(101), INT64_C(10))) < 0.5)
        {
            missed = span_max_int(missed, INT64_C(1));
        }
        if ((count > INT64_C(0)) && misses_little(free, total_duration(phases, count), asked, axis))
        {
            missed = INT64_C(2);
        }
    }
    else
    {
        rest = span_row(&work, INT64_C(60));
        longest = short_window(total_duration(phases, count), asked, axis, rest);
        if (longest > 0.0)
        {
            count = loop_form(INT64_C(6), count, longest, phases, asked, axis, work);
            if (total_duration(phases, count) > longest)
            {
                missed = INT64_C(2);
            }
        }
        if (((*cspan_at(&axis, INT64_C(38))) > 0.5) && (!ramps_suffice(axis)))
        {
            count = passing_either_way(count, phases, asked, axis, work);
        }
    }
    if ((count > INT64_C(0)) && ((*cspan_at(&axis, INT64_C(14))) < 0.5))
    {
        trial = span_rows(&work, INT64_C(0), INT64_C(21));
        count = shorter_cruise(count, phases, asked, axis, trial);
        count = shorter_braked(count, asked, axis, phases, work);
    }
    if ((!snap_is_last(axis)) && (!is_resting(asked, axis)))
    {
        missed = INT64_C(2);
    }
    (*cspan_at(&family, INT64_C(20))) = missed;
    return count;
}
int64_t segfmu_shortest_profile(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    int64_t result;
    begin_search(problem, axis, work);
    result = begun_profile(axis, phases, work);
    return result;
}
static int64_t plain_profile(array_double_1d problem, array_double_1d axis, array_double_2d phases, array_double_2d work)
{
    int64_t result;
    begin_search(problem, axis, work);
    (*cspan_at(&work, INT64_C(101), INT64_C(11))) = 1.0;
    result = begun_profile(axis, phases, work);
    return result;
}
static int64_t append_stage(double v, double a, double w, array_double_2d phases, array_double_1d chain)
{
    double top;
    int64_t result;
    top = (*cspan_at(&chain, INT64_C(3)));
    result = append_velocity_change(phases, INT64_C(0), v, a, w, top, (*cspan_at(&chain, INT64_C(9) + INT64_C(1))), chain);
    return result;
}
static void set_stage_problem(int64_t order, double end, array_double_1d state, array_double_1d problem)
{
    (*cspan_at(&problem, INT64_C(0))) = (*cspan_at(&state, order + INT64_C(1)));
    (*cspan_at(&problem, INT64_C(1))) = (*cspan_at(&state, order + INT64_C(2)));
    (*cspan_at(&problem, INT64_C(2))) = 0.0;
    (*cspan_at(&problem, INT64_C(3))) = 0.0;
    (*cspan_at(&problem, INT64_C(4))) = end - (*cspan_at(&state, order));
}
static int64_t stage_phases(int64_t order, double end, bool free, array_double_2d lead)
{
    array_double_1d state;
    array_double_2d phases;
    int64_t smoothness;
    array_double_1d chain;
    array_double_1d problem;
    int64_t result;
    state = span_row(&lead, INT64_C(8));
    phases = span_rows(&lead, INT64_C(19), INT64_C(52));
    smoothness = (int64_t)((*cspan_at(&lead, INT64_C(54), INT64_C(0))));
    if (order == smoothness - INT64_C(1))
    {
        chain = span_row(&lead, INT64_C(54) + order - INT64_C(1));
        if (free)
        {
            result = append_change(phases, INT64_C(0), (*cspan_at(&state, order + INT64_C(1))), 0.0, chain);
            return result;
        }
        result = append_stage((*cspan_at(&state, order)), (*cspan_at(&state, order + INT64_C(1))), end, phases, chain);
        return result;
    }
    chain = span_row(&lead, INT64_C(54) + order);
    if (free)
    {
        result = append_stage((*cspan_at(&state, order + INT64_C(1))), (*cspan_at(&state, order + INT64_C(2))), 0.0, phases, chain);
        return result;
    }
    problem = span_row(&lead, INT64_C(18));
    set_stage_problem(order, end, state, problem);
    result = plain_profile(problem, chain, phases, span_rows(&lead, INT64_C(61), INT64_C(301)));
    return result;
}
static int64_t append_phases(int64_t order, double end, int64_t count, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d state;
    int64_t smoothness;
    int64_t seen;
    array_double_1d chain;
    array_double_2d expansion;
    array_double_1d now;
    int64_t third;
    array_double_2d phases;
    int64_t i;
    int64_t last;
    state = span_row(&lead, INT64_C(8));
    smoothness = (int64_t)((*cspan_at(&lead, INT64_C(54), INT64_C(0))));
    seen = span_min_int(order, smoothness - INT64_C(2));
    chain = span_row(&lead, INT64_C(54) + seen);
    if ((count < INT64_C(0)) || (row + segfmu_ramp_pieces(chain) * count > INT64_C(2) * INT64_C(400)))
    {
        return -INT64_C(1);
    }
    expansion = span_rows(&lead, INT64_C(301), INT64_C(305));
    now = span_row(&expansion, INT64_C(1));
    (*cspan_at(&now, INT64_C(0))) = (*cspan_at(&state, seen));
    (*cspan_at(&now, INT64_C(1))) = (*cspan_at(&state, seen + INT64_C(1)));
    (*cspan_at(&now, INT64_C(2))) = (*cspan_at(&state, seen + INT64_C(2)));
    third = seen + INT64_C(3);
    (*cspan_at(&now, INT64_C(3))) = (*cspan_at(&state, third));
    (*cspan_at(&now, INT64_C(8))) = (*cspan_at(&state, INT64_C(8)));
    phases = span_rows(&lead, INT64_C(19), INT64_C(52));
    last = segfmu_expand_phases(phases, count, chain, timing, coefficients, row, expansion);
    lift_pieces(seen, row, last, state, timing, coefficients);
    (*cspan_at(&state, seen)) = (*cspan_at(&now, INT64_C(0)));
    (*cspan_at(&state, seen + INT64_C(1))) = (*cspan_at(&now, INT64_C(1)));
    if (end <= 1e+299)
    {
        (*cspan_at(&state, order)) = end;
    }
    for (i = order + INT64_C(1); i < smoothness + INT64_C(1); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = 0.0;
    }
    (*cspan_at(&state, INT64_C(8))) = (*cspan_at(&now, INT64_C(8)));
    return last;
}
static int64_t run_stage(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    double end;
    int64_t count;
    int64_t result;
    end = (*cspan_at(&lead, INT64_C(13), order));
    count = stage_phases(order, end, end > 1e+299, lead);
    result = append_phases(order, end, count, row, lead, timing, coefficients);
    return result;
}
static void drop_rounding(int64_t order, array_double_2d lead)
{
    array_double_1d state;
    int64_t i;
    double aim;
    state = span_row(&lead, INT64_C(8));
    for (i = INT64_C(1); i < (int64_t)((*cspan_at(&lead, INT64_C(54), INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        aim = 0.0;
        if ((i == order) && ((*cspan_at(&lead, INT64_C(13), i)) < 1e+299))
        {
            aim = (*cspan_at(&lead, INT64_C(13), i));
        }
        if (fabs((*cspan_at(&state, i)) - aim) <= (*cspan_at(&lead, INT64_C(12), i)))
        {
            (*cspan_at(&state, i)) = aim;
        }
    }
}
static int64_t settle(int64_t order, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t smoothness;
    int64_t i;
    int64_t stage;
    smoothness = (int64_t)((*cspan_at(&lead, INT64_C(54), INT64_C(0))));
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(8), i)) = (*cspan_at(&lead, INT64_C(7), i));
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        stage = order + INT64_C(4) - INT64_C(2) * i;
        if ((stage < smoothness) && (row >= INT64_C(0)))
        {
            drop_rounding(order, lead);
            row = run_stage(stage, row, lead, timing, coefficients);
        }
    }
    return row;
}
static double outside_by(double value, int64_t order, array_double_2d lead)
{
    double low;
    double high;
    low = (*cspan_at(&lead, INT64_C(4), order));
    high = (*cspan_at(&lead, INT64_C(5), order));
    return span_max(value - high, low - value) - 1e-13 * (high - low);
}
static int64_t hold_highest(double value, double length, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d state;
    int64_t smoothness;
    double factorial;
    int64_t i;
    state = span_row(&lead, INT64_C(8));
    smoothness = (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0))));
    if ((row < INT64_C(0)) || (row >= INT64_C(2) * INT64_C(400)))
    {
        return -INT64_C(1);
    }
    if (length <= 0.0)
    {
        return row;
    }
    clear_piece(coefficients, row);
    factorial = 1.0;
    for (i = INT64_C(0); i < smoothness + INT64_C(1); i += INT64_C(1))
    {
        if (i > INT64_C(0))
        {
            factorial = factorial * i;
        }
        (*cspan_at(&coefficients, row, i)) = (*cspan_at(&state, i)) / factorial;
    }
    (*cspan_at(&coefficients, row, smoothness + INT64_C(1))) = value / (factorial * (smoothness + INT64_C(1)));
    (*cspan_at(&timing, row, INT64_C(0))) = (*cspan_at(&state, INT64_C(8)));
    (*cspan_at(&timing, row, INT64_C(1))) = length;
    for (i = INT64_C(0); i < smoothness + INT64_C(1); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = evaluate_piece(coefficients, row, coefficients.shape[INT64_C(1)], length, i);
    }
    (*cspan_at(&state, INT64_C(8))) = (*cspan_at(&state, INT64_C(8))) + length;
    return row + INT64_C(1);
}
static int64_t lead_to(int64_t order, double end, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d state;
    double top;
    double length;
    int64_t i;
    int64_t result;
    state = span_row(&lead, INT64_C(8));
    if (row < INT64_C(0))
    {
        return -INT64_C(1);
    }
    if (order == (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0)))))
    {
        top = (*cspan_at(&lead, INT64_C(5), order + INT64_C(1)));
        if (end < (*cspan_at(&state, order)))
        {
            top = (*cspan_at(&lead, INT64_C(4), order + INT64_C(1)));
        }
        length = (end - (*cspan_at(&state, order))) / top;
        row = hold_highest(top, length, row, lead, timing, coefficients);
        (*cspan_at(&state, order)) = end;
        return row;
    }
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(7), i)) = (*cspan_at(&state, i));
        (*cspan_at(&lead, INT64_C(13), i)) = 1e+300;
    }
    (*cspan_at(&lead, INT64_C(13), order)) = end;
    result = settle(order, row, lead, timing, coefficients);
    return result;
}
static double part_hull(int64_t order, int64_t row, double start, double length, array_double_2d lead, array_double_2d coefficients)
{
    array_double_2d check;
    int64_t width;
    double factorial;
    int64_t i;
    double value;
    double largest;
    check = span_rows(&lead, INT64_C(305), INT64_C(353));
    width = coefficients.shape[INT64_C(1)];
    factorial = 1.0;
    for (i = INT64_C(0); i < width - order; i += INT64_C(1))
    {
        if (i > INT64_C(0))
        {
            factorial = factorial * i;
        }
        value = evaluate_piece(coefficients, row, width, start, order + i);
        (*cspan_at(&check, INT64_C(43), i)) = value / factorial;
    }
    bernstein_coefficients(check, INT64_C(43), width - order, length, check);
    largest = -1e+300;
    for (i = INT64_C(0); i < width - order; i += INT64_C(1))
    {
        largest = span_max(largest, outside_by((*cspan_at(&check, INT64_C(0), i)), order, lead));
    }
    return largest;
}
static bool stays_inside(int64_t order, int64_t first, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_2d check;
    double low;
    double high;
    int64_t count;
    int64_t row;
    double length;
    double slack;
    check = span_rows(&lead, INT64_C(305), INT64_C(353));
    low = (*cspan_at(&lead, INT64_C(4), order));
    high = (*cspan_at(&lead, INT64_C(5), order));
    count = coefficients.shape[INT64_C(1)] - order;
    for (row = first; row < last; row += INT64_C(1))
    {
        length = (*cspan_at(&timing, row, INT64_C(1)));
        if (part_hull(order, row, 0.0, length, lead, coefficients) > 0.0)
        {
            slack = 1e-10 * (high - low);
            if (!within(check, count, low - slack, high + slack))
            {
                return 0;
            }
        }
    }
    return 1;
}
static double time_crossed(int64_t order, int64_t row, double lower, double upper, array_double_2d lead, array_double_2d coefficients)
{
    int64_t k;
    double middle;
    double value;
    for (k = INT64_C(0); k < INT64_C(60); k += INT64_C(1))
    {
        middle = 0.5 * (lower + upper);
        value = evaluate_piece(coefficients, row, coefficients.shape[INT64_C(1)], middle, order);
        if (outside_by(value, order, lead) > 0.0)
        {
            lower = middle;
        }
        else
        {
            upper = middle;
        }
    }
    return upper;
}
static int64_t inside_from(int64_t* result_0_0001, double* result_1_0001, int64_t order, int64_t first, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t width;
    int64_t i;
    int64_t row;
    double length;
    double upper;
    double step;
    double lower;
    double value;
    width = coefficients.shape[INT64_C(1)];
    for (i = INT64_C(0); i < last - first; i += INT64_C(1))
    {
        row = last - INT64_C(1) - i;
        length = (*cspan_at(&timing, row, INT64_C(1)));
        upper = length;
        step = length;
        while(upper > 0.0)
        {
            lower = span_max(upper - step, 0.0);
            value = evaluate_piece(coefficients, row, width, lower, order);
            if (part_hull(order, row, lower, upper - lower, lead, coefficients) <= 0.0)
            {
                upper = lower;
                step = 2.0 * step;
            }
            else if (step > 0.001 * length)
            {
                step = 0.25 * step;
            }
            else if (outside_by(value, order, lead) > 0.0)
            {
                (*result_0_0001) = row;
                (*result_1_0001) = time_crossed(order, row, lower, upper, lead, coefficients);
                return 0;
            }
            else if (step > 1e-09 * length)
            {
                step = 0.25 * step;
            }
            else
            {
                upper = lower;
            }
        }
    }
    (*result_0_0001) = first;
    (*result_1_0001) = 0.0;
    return 0;
}
static double try_brake(int64_t order, double side, double level, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d state;
    array_double_1d turn;
    int64_t smoothness;
    double near;
    double far;
    int64_t first;
    int64_t row;
    int64_t i;
    int64_t last;
    double room;
    double hold;
    double local;
    double result;
    state = span_row(&lead, INT64_C(8));
    turn = span_row(&lead, INT64_C(3));
    smoothness = (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0))));
    near = (*cspan_at(&lead, INT64_C(5), order));
    far = (*cspan_at(&lead, INT64_C(4), order));
    if (side < 0.0)
    {
        near = (*cspan_at(&lead, INT64_C(4), order));
        far = (*cspan_at(&lead, INT64_C(5), order));
    }
    first = INT64_C(400);
    row = first;
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = (*cspan_at(&lead, INT64_C(2), i));
    }
    if (settled && (order + INT64_C(2) <= smoothness))
    {
        row = lead_to(order + INT64_C(2), 0.0, row, lead, timing, coefficients);
    }
    row = lead_to(order + INT64_C(1), level, row, lead, timing, coefficients);
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&turn, i)) = (*cspan_at(&state, i));
    }
    last = lead_to(order + INT64_C(1), 0.0, row, lead, timing, coefficients);
    if (last < INT64_C(0))
    {
        return 1e+300;
    }
    room = side * ((*cspan_at(&state, order)) - far);
    if (room < 0.0)
    {
        return -1.0;
    }
    if (level != 0.0)
    {
        hold = span_min(side * ((*cspan_at(&turn, order)) - near), room) / fabs(level);
        for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
        {
            (*cspan_at(&state, i)) = (*cspan_at(&turn, i));
        }
        row = hold_highest(0.0, hold, row, lead, timing, coefficients);
        last = lead_to(order + INT64_C(1), 0.0, row, lead, timing, coefficients);
    }
    if ((last < INT64_C(0)) || (outside_by((*cspan_at(&state, order)), order, lead) > 0.0))
    {
        return 1e+300;
    }
    for (i = order + INT64_C(1); i < smoothness + INT64_C(2); i += INT64_C(1))
    {
        if (!stays_inside(i, first, last, lead, timing, coefficients))
        {
            return 1e+300;
        }
    }
    inside_from(&row, &local, order, first, last, lead, timing, coefficients);
    if ((last > first) && (!stays_inside(order, row + INT64_C(1), last, lead, timing, coefficients)))
    {
        return 1e+300;
    }
    (*cspan_at(&lead, INT64_C(6), INT64_C(2))) = last;
    if (last == first)
    {
        result = (*cspan_at(&lead, INT64_C(2), INT64_C(8)));
        return result;
    }
    result = (*cspan_at(&timing, row, INT64_C(0))) + local;
    return result;
}
static void note_extremes(int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_2d check;
    array_double_1d report;
    int64_t width;
    int64_t parts;
    double step;
    int64_t order;
    int64_t part;
    int64_t i;
    double value;
    check = span_rows(&lead, INT64_C(305), INT64_C(353));
    report = span_row(&lead, INT64_C(6));
    width = coefficients.shape[INT64_C(1)];
    parts = INT64_C(8);
    step = (*cspan_at(&timing, row, INT64_C(1))) / parts;
    for (order = INT64_C(1); order < span_floor_div(width, INT64_C(2)) + INT64_C(2); order += INT64_C(1))
    {
        for (part = INT64_C(0); part < parts; part += INT64_C(1))
        {
            part_hull(order, row, part * step, step, lead, coefficients);
            for (i = INT64_C(0); i < width - order; i += INT64_C(1))
            {
                value = (*cspan_at(&check, INT64_C(0), i));
                (*cspan_at(&report, INT64_C(11) + order)) = span_min((*cspan_at(&report, INT64_C(11) + order)), value);
                (*cspan_at(&report, INT64_C(19) + order)) = span_max((*cspan_at(&report, INT64_C(19) + order)), value);
            }
        }
    }
}
static void end_brake(double until, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d report;
    array_double_1d reached;
    int64_t width;
    int64_t first;
    int64_t count;
    int64_t row;
    double length;
    int64_t i;
    report = span_row(&lead, INT64_C(6));
    reached = span_row(&lead, INT64_C(2));
    width = coefficients.shape[INT64_C(1)];
    first = INT64_C(2) * INT64_C(400);
    count = (int64_t)((*cspan_at(&report, INT64_C(1))));
    while((count > INT64_C(0)) && ((*cspan_at(&timing, first + count - INT64_C(1), INT64_C(0))) >= until))
    {
        count = count - INT64_C(1);
    }
    (*cspan_at(&report, INT64_C(1))) = count;
    if (count > INT64_C(0))
    {
        row = first + count - INT64_C(1);
        length = span_min((*cspan_at(&timing, row, INT64_C(1))), until - (*cspan_at(&timing, row, INT64_C(0))));
        (*cspan_at(&timing, row, INT64_C(1))) = length;
        for (i = INT64_C(0); i < span_floor_div(width, INT64_C(2)) + INT64_C(1); i += INT64_C(1))
        {
            (*cspan_at(&reached, i)) = evaluate_piece(coefficients, row, width, length, i);
        }
        (*cspan_at(&reached, INT64_C(8))) = (*cspan_at(&timing, row, INT64_C(0))) + length;
    }
}
static void append_pieces(double until, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d report;
    int64_t row;
    int64_t target;
    report = span_row(&lead, INT64_C(6));
    for (row = INT64_C(400); row < last; row += INT64_C(1))
    {
        target = INT64_C(2) * INT64_C(400) + (int64_t)((*cspan_at(&report, INT64_C(1))));
        if (((*cspan_at(&timing, row, INT64_C(0))) >= until) || (target >= INT64_C(1200)))
        {
            break;
        }
        copy_piece(timing, coefficients, row, timing, coefficients, target);
        (*cspan_at(&report, INT64_C(1))) = (*cspan_at(&report, INT64_C(1))) + 1.0;
    }
    end_brake(until, lead, timing, coefficients);
}
static void split_brake(double until, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d report;
    int64_t width;
    int64_t first;
    int64_t last;
    int64_t row;
    double local;
    int64_t i;
    double factorial;
    double value;
    report = span_row(&lead, INT64_C(6));
    width = coefficients.shape[INT64_C(1)];
    first = INT64_C(2) * INT64_C(400);
    last = first + (int64_t)((*cspan_at(&report, INT64_C(1))));
    for (row = first; row < last; row += INT64_C(1))
    {
        local = until - (*cspan_at(&timing, row, INT64_C(0)));
        if ((local > 0.0) && (local < (*cspan_at(&timing, row, INT64_C(1)))) && (last < INT64_C(1200)))
        {
            for (i = INT64_C(0); i < last - row; i += INT64_C(1))
            {
                copy_piece(timing, coefficients, last - INT64_C(1) - i, timing, coefficients, last - i);
            }
            factorial = 1.0;
            for (i = INT64_C(0); i < width; i += INT64_C(1))
            {
                if (i > INT64_C(0))
                {
                    factorial = factorial * i;
                }
                value = evaluate_piece(coefficients, row, width, local, i);
                (*cspan_at(&coefficients, row + INT64_C(1), i)) = value / factorial;
            }
            (*cspan_at(&timing, row + INT64_C(1), INT64_C(0))) = until;
            (*cspan_at(&timing, row + INT64_C(1), INT64_C(1))) = (*cspan_at(&timing, row, INT64_C(1))) - local;
            (*cspan_at(&timing, row, INT64_C(1))) = local;
            (*cspan_at(&report, INT64_C(1))) = (*cspan_at(&report, INT64_C(1))) + 1.0;
            break;
        }
    }
}
static double time_inside(array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t first;
    int64_t last;
    int64_t i;
    int64_t row;
    double local;
    double until;
    first = INT64_C(2) * INT64_C(400);
    last = first + (int64_t)((*cspan_at(&lead, INT64_C(6), INT64_C(1))));
    until = 0.0;
    for (i = INT64_C(1); i < limits.shape[INT64_C(0)]; i += INT64_C(1))
    {
        if (((*cspan_at(&limits, i - INT64_C(1))) > 0.0) && (last > first))
        {
            (*cspan_at(&lead, INT64_C(4), i)) = -lower_limit(i, limits, lead);
            (*cspan_at(&lead, INT64_C(5), i)) = (*cspan_at(&limits, i - INT64_C(1)));
            inside_from(&row, &local, i, first, last, lead, timing, coefficients);
            until = span_max(until, (*cspan_at(&timing, row, INT64_C(0))) + local);
        }
    }
    return until;
}
static double level_limit(int64_t order, double side, array_double_2d lead)
{
    double result;
    if (side < 0.0)
    {
        result = (*cspan_at(&lead, INT64_C(5), order + INT64_C(1)));
        return result;
    }
    result = (*cspan_at(&lead, INT64_C(4), order + INT64_C(1)));
    return result;
}
static int64_t best_level(double* result_0, double* result_1, int64_t order, double side, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    double edge;
    double least;
    double best;
    double share;
    double low;
    double high;
    int64_t i;
    double time;
    edge = level_limit(order, side, lead);
    least = try_brake(order, side, edge, settled, lead, timing, coefficients);
    best = edge;
    share = 1.0;
    if (least < 0.0)
    {
        least = 1e+300;
        low = 0.0;
        high = 1.0;
        for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
        {
            share = 0.5 * (low + high);
            time = try_brake(order, side, share * edge, settled, lead, timing, coefficients);
            if (time < 0.0)
            {
                high = share;
            }
            else
            {
                low = share;
                if (time < least)
                {
                    least = time;
                    best = share * edge;
                }
            }
        }
    }
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        share = 0.5 * share;
        if (i == INT64_C(5))
        {
            share = 0.0;
        }
        if (least > (*cspan_at(&lead, INT64_C(2), INT64_C(8))))
        {
            time = try_brake(order, side, share * edge, settled, lead, timing, coefficients);
            if ((time >= 0.0) && (time < least))
            {
                least = time;
                best = share * edge;
            }
        }
    }
    (*result_0) = least;
    (*result_1) = best;
    return 0;
}
static int64_t level_time(double* result_0, double* result_1, int64_t order, double side, double gentle, bool settled, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    double level;
    double time;
    if (gentle > 0.0)
    {
        level = (1.0 - gentle) * level_limit(order, side, lead);
        time = try_brake(order, side, level, settled, lead, timing, coefficients);
        if ((time >= 0.0) && (time < 1e+299))
        {
            (*result_0) = time;
            (*result_1) = level;
            return 0;
        }
    }
    best_level(result_0, result_1, order, side, settled, lead, timing, coefficients);
    return 0;
}
static double side_beyond(int64_t order, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d state;
    array_double_1d reached;
    double low;
    int64_t first;
    int64_t i;
    int64_t last;
    double value;
    state = span_row(&lead, INT64_C(8));
    reached = span_row(&lead, INT64_C(2));
    low = (*cspan_at(&lead, INT64_C(4), order));
    first = INT64_C(400);
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = (*cspan_at(&reached, i));
    }
    last = lead_to(order + INT64_C(1), 0.0, first, lead, timing, coefficients);
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        value = (*cspan_at(&state, order));
        if (i == INT64_C(1))
        {
            value = (*cspan_at(&reached, order));
        }
        if (outside_by(value, order, lead) > 0.0)
        {
            if (value > low)
            {
                return 1.0;
            }
            return -1.0;
        }
    }
    if ((last >= INT64_C(0)) && stays_inside(order, first, last, lead, timing, coefficients))
    {
        return 0.0;
    }
    if ((*cspan_at(&reached, order + INT64_C(1))) > 0.0)
    {
        return 1.0;
    }
    return -1.0;
}
static void bring_highest(array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t order;
    double value;
    double end;
    int64_t i;
    int64_t last;
    double until;
    order = (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0))));
    value = (*cspan_at(&lead, INT64_C(2), order));
    end = span_min(span_max(value, (*cspan_at(&lead, INT64_C(4), order))), (*cspan_at(&lead, INT64_C(5), order)));
    if (outside_by(value, order, lead) > 0.0)
    {
        for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
        {
            (*cspan_at(&lead, INT64_C(8), i)) = (*cspan_at(&lead, INT64_C(2), i));
        }
        last = lead_to(order, end, INT64_C(400), lead, timing, coefficients);
        until = (*cspan_at(&lead, INT64_C(8), INT64_C(8)));
        append_pieces(until, last, lead, timing, coefficients);
        (*cspan_at(&lead, INT64_C(6), INT64_C(0))) = until;
    }
    (*cspan_at(&lead, INT64_C(2), order)) = end;
}
static bool bring_gently(int64_t order, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t first;
    array_double_1d reached;
    array_double_1d state;
    double value;
    double end;
    int64_t i;
    int64_t last;
    double until;
    first = INT64_C(400);
    reached = span_row(&lead, INT64_C(2));
    state = span_row(&lead, INT64_C(8));
    value = (*cspan_at(&reached, order));
    if (!(outside_by(value, order, lead) > 0.0))
    {
        return 0;
    }
    end = span_min(span_max(value, (*cspan_at(&lead, INT64_C(4), order))), (*cspan_at(&lead, INT64_C(5), order)));
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = (*cspan_at(&reached, i));
    }
    last = lead_to(order, end, first, lead, timing, coefficients);
    if (last < INT64_C(0))
    {
        return 0;
    }
    for (i = order + INT64_C(1); i < (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0)))) + INT64_C(2); i += INT64_C(1))
    {
        if (!stays_inside(i, first, last, lead, timing, coefficients))
        {
            return 0;
        }
    }
    until = (*cspan_at(&state, INT64_C(8)));
    append_pieces(until, last, lead, timing, coefficients);
    for (i = order + INT64_C(1); i < (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        (*cspan_at(&reached, i)) = 0.0;
    }
    (*cspan_at(&reached, order)) = end;
    (*cspan_at(&lead, INT64_C(6), INT64_C(0))) = until;
    return 1;
}
static bool bring_inside(int64_t order, bool whole, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d report;
    array_double_1d reached;
    double gentle;
    double side;
    double time;
    double level;
    bool settled;
    int64_t i;
    double start;
    double low;
    report = span_row(&lead, INT64_C(6));
    reached = span_row(&lead, INT64_C(2));
    gentle = (*cspan_at(&report, INT64_C(3) + order));
    if ((gentle == 1.0) && bring_gently(order, lead, timing, coefficients))
    {
        return 1;
    }
    side = side_beyond(order, lead, timing, coefficients);
    if ((side == 0.0) && (!whole))
    {
        return 1;
    }
    time = 1e+300;
    level = 0.0;
    settled = 0;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        if (time > 1e+299)
        {
            settled = i == INT64_C(1);
            if (side == 0.0)
            {
                time = try_brake(order, 1.0, 0.0, settled, lead, timing, coefficients);
            }
            else
            {
                level_time(&time, &level, order, side, gentle, settled, lead, timing, coefficients);
            }
        }
    }
    if (time > 1e+299)
    {
        return 0;
    }
    start = (*cspan_at(&reached, INT64_C(8)));
    if (side != 0.0)
    {
        try_brake(order, side, level, settled, lead, timing, coefficients);
    }
    if (time > start)
    {
        (*cspan_at(&report, INT64_C(0))) = time;
    }
    else if (!whole)
    {
        return 1;
    }
    if (whole)
    {
        time = 1e+300;
    }
    append_pieces(time, (int64_t)((*cspan_at(&report, INT64_C(2)))), lead, timing, coefficients);
    for (i = order; i < reached.shape[INT64_C(0)] - INT64_C(2); i += INT64_C(1))
    {
        if (i <= (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0)))))
        {
            if (whole && (i > order))
            {
                (*cspan_at(&reached, i)) = 0.0;
            }
            low = (*cspan_at(&lead, INT64_C(4), i));
            (*cspan_at(&reached, i)) = span_min(span_max((*cspan_at(&reached, i)), low), (*cspan_at(&lead, INT64_C(5), i)));
        }
    }
    return 1;
}
static void clip_reached(array_double_2d lead)
{
    int64_t i;
    double value;
    for (i = INT64_C(1); i < (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        value = span_max((*cspan_at(&lead, INT64_C(2), i)), (*cspan_at(&lead, INT64_C(4), i)));
        (*cspan_at(&lead, INT64_C(2), i)) = span_min(value, (*cspan_at(&lead, INT64_C(5), i)));
    }
}
static int64_t brake_within(double steep, int64_t loose, bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t smoothness;
    array_double_1d report;
    int64_t i;
    bool let_go;
    int64_t order;
    int64_t first;
    int64_t row;
    int64_t result;
    smoothness = limits.shape[INT64_C(0)] - INT64_C(1);
    report = span_row(&lead, INT64_C(6));
    (*cspan_at(&report, INT64_C(0))) = 0.0;
    (*cspan_at(&report, INT64_C(1))) = 0.0;
    for (i = INT64_C(0); i < smoothness + INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&report, INT64_C(11) + i)) = 0.0;
        (*cspan_at(&report, INT64_C(19) + i)) = 0.0;
    }
    if (!set_box(steep, loose, limits, lead))
    {
        return -INT64_C(1);
    }
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(2), i)) = (*cspan_at(&lead, INT64_C(0), i));
    }
    bring_highest(lead, timing, coefficients);
    let_go = whole || (loose <= smoothness);
    for (i = INT64_C(1); i < smoothness; i += INT64_C(1))
    {
        order = smoothness - i;
        if (!bring_inside(order, let_go && (order == INT64_C(1)), lead, timing, coefficients))
        {
            return -INT64_C(1);
        }
    }
    if (let_go)
    {
        if (loose <= smoothness)
        {
            (*cspan_at(&report, INT64_C(0))) = time_inside(limits, lead, timing, coefficients);
        }
        split_brake((*cspan_at(&report, INT64_C(0))), lead, timing, coefficients);
        if (!whole)
        {
            end_brake((*cspan_at(&report, INT64_C(0))), lead, timing, coefficients);
            clip_reached(lead);
        }
    }
    first = INT64_C(2) * INT64_C(400);
    for (row = first; row < first + (int64_t)((*cspan_at(&report, INT64_C(1)))); row += INT64_C(1))
    {
        if ((*cspan_at(&timing, row, INT64_C(0))) < (*cspan_at(&report, INT64_C(0))))
        {
            note_extremes(row, lead, timing, coefficients);
        }
    }
    result = (int64_t)((*cspan_at(&report, INT64_C(1))));
    return result;
}
static int64_t best_steepness(double* result_0_0001, double* result_1, int64_t loose, bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t highest;
    int64_t i;
    double best;
    double steep;
    double chosen;
    int64_t count;
    double until;
    highest = INT64_C(1);
    for (i = INT64_C(0); i < limits.shape[INT64_C(0)]; i += INT64_C(1))
    {
        if ((*cspan_at(&limits, i)) <= 0.0)
        {
            highest = INT64_C(8);
        }
    }
    best = 1e+300;
    steep = 1.0;
    chosen = 0.0;
    for (i = INT64_C(0); i < highest; i += INT64_C(1))
    {
        count = brake_within(steep, loose, whole, limits, lead, timing, coefficients);
        until = (*cspan_at(&lead, INT64_C(6), INT64_C(0)));
        if ((count >= INT64_C(0)) && (until == 0.0))
        {
            (*result_0_0001) = steep;
            (*result_1) = 0.0;
            return 0;
        }
        if ((count > INT64_C(0)) && (until < 0.997 * best))
        {
            best = until;
            chosen = steep;
        }
        else if ((best < 1e+299) && (i > INT64_C(2)))
        {
            break;
        }
        steep = 10.0 * steep;
    }
    (*result_0_0001) = chosen;
    (*result_1) = best;
    return 0;
}
int64_t segfmu_find_brake(bool whole, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t smoothness;
    array_double_1d report;
    int64_t i;
    int64_t loose;
    double chosen;
    double best;
    int64_t order;
    double steep;
    double until;
    double gentle;
    int64_t count;
    int64_t result;
    smoothness = limits.shape[INT64_C(0)] - INT64_C(1);
    if ((smoothness < INT64_C(2)) || (smoothness > INT64_C(6)) || (coefficients.shape[INT64_C(1)] != INT64_C(2) * smoothness))
    {
        return -INT64_C(1);
    }
    report = span_row(&lead, INT64_C(6));
    for (i = INT64_C(0); i < INT64_C(27); i += INT64_C(1))
    {
        (*cspan_at(&report, i)) = 0.0;
    }
    loose = smoothness + INT64_C(1);
    best_steepness(&chosen, &best, loose, whole, limits, lead, timing, coefficients);
    if (best == 0.0)
    {
        result = (int64_t)((*cspan_at(&report, INT64_C(1))));
        return result;
    }
    for (i = INT64_C(0); i < smoothness - INT64_C(2); i += INT64_C(1))
    {
        order = smoothness - i;
        if (((*cspan_at(&limits, order - INT64_C(1))) > 0.0) && (fabs((*cspan_at(&lead, INT64_C(0), order))) > (*cspan_at(&limits, order - INT64_C(1)))))
        {
            best_steepness(&steep, &until, order, whole, limits, lead, timing, coefficients);
            if ((steep > 0.0) && (until < 0.5 * best))
            {
                chosen = steep;
                best = until;
                loose = order;
            }
        }
    }
    if ((chosen == 0.0) && (smoothness > INT64_C(2)))
    {
        (*cspan_at(&report, INT64_C(3) + INT64_C(2))) = 0.5;
        best_steepness(&chosen, &best, loose, whole, limits, lead, timing, coefficients);
    }
    if (chosen == 0.0)
    {
        return -INT64_C(1);
    }
    for (order = INT64_C(2); order < smoothness; order += INT64_C(1))
    {
        gentle = (*cspan_at(&report, INT64_C(3) + order));
        for (i = INT64_C(1); i < INT64_C(5); i += INT64_C(1))
        {
            (*cspan_at(&report, INT64_C(3) + order)) = 0.25 * i;
            count = brake_within(chosen, loose, whole, limits, lead, timing, coefficients);
            if ((count > INT64_C(0)) && ((*cspan_at(&report, INT64_C(0))) < 0.999 * best))
            {
                best = (*cspan_at(&report, INT64_C(0)));
                gentle = (*cspan_at(&report, INT64_C(3) + order));
            }
        }
        (*cspan_at(&report, INT64_C(3) + order)) = gentle;
    }
    result = brake_within(chosen, loose, whole, limits, lead, timing, coefficients);
    return result;
}
static double end_rounding(void)
{
    return 1e-11;
}
static void write_end(int64_t last, array_double_2d timing, array_double_2d coefficients, array_double_1d end)
{
    int64_t width;
    double length;
    int64_t order;
    width = coefficients.shape[INT64_C(1)];
    length = (*cspan_at(&timing, last, INT64_C(1)));
    for (order = INT64_C(0); order < INT64_C(3); order += INT64_C(1))
    {
        (*cspan_at(&end, order)) = evaluate_piece(coefficients, last, width, length, order);
    }
    (*cspan_at(&end, INT64_C(3))) = (*cspan_at(&timing, last, INT64_C(0))) + length;
}
static bool is_at_velocity(double velocity, array_double_1d limits, array_double_1d end)
{
    double missed;
    bool result;
    missed = (*cspan_at(&end, INT64_C(1))) - velocity;
    if (fabs(missed) > end_rounding() * (*cspan_at(&limits, INT64_C(0))))
    {
        return 0;
    }
    result = fabs((*cspan_at(&end, INT64_C(2)))) <= end_rounding() * (*cspan_at(&limits, INT64_C(1)));
    return result;
}
void segfmu_plan_ends(array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d ends)
{
    int64_t axis;
    for (axis = INT64_C(0); axis < offsets.shape[INT64_C(0)] - INT64_C(1); axis += INT64_C(1))
    {
        write_end((*cspan_at(&offsets, axis + INT64_C(1))) - INT64_C(1), timing, coefficients, span_row(&ends, axis));
    }
}
bool segfmu_are_at_velocities(array_double_2d targets, array_double_2d limits, array_double_2d ends)
{
    int64_t axis;
    double velocity;
    for (axis = INT64_C(0); axis < ends.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        velocity = (*cspan_at(&targets, axis, INT64_C(1)));
        if (!is_at_velocity(velocity, span_row(&limits, axis), span_row(&ends, axis)))
        {
            return 0;
        }
    }
    return 1;
}
static int64_t level_order(int64_t order, array_double_2d lead)
{
    int64_t seen;
    int64_t above;
    seen = INT64_C(2) - order;
    above = (int64_t)((*cspan_at(&lead, INT64_C(54) + seen, INT64_C(38))));
    if (above == INT64_C(0))
    {
        return INT64_C(0);
    }
    return seen + INT64_C(2) + above;
}
static double lead_end(int64_t order, array_double_2d lead)
{
    double result;
    if (order == INT64_C(1))
    {
        result = (*cspan_at(&lead, INT64_C(17), INT64_C(2)));
        return result;
    }
    result = (*cspan_at(&lead, INT64_C(17), INT64_C(4)));
    return result;
}
static int64_t passing_phases(int64_t order, double least, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d state;
    array_double_1d level;
    int64_t seen;
    array_double_1d chain;
    array_double_1d problem;
    array_double_2d phases;
    array_double_2d plan;
    array_double_2d ramps;
    array_double_1d passing;
    double end;
    double longest;
    int64_t count;
    int64_t third;
    int64_t result;
    state = span_row(&lead, INT64_C(8));
    level = span_row(&lead, INT64_C(9));
    seen = INT64_C(2) - order;
    chain = span_row(&lead, INT64_C(54) + seen);
    problem = span_row(&lead, INT64_C(18));
    phases = span_rows(&lead, INT64_C(19), INT64_C(52));
    plan = span_rows(&lead, INT64_C(61), INT64_C(301));
    ramps = span_rows(&plan, INT64_C(0), INT64_C(21));
    passing = span_row(&plan, INT64_C(101));
    end = lead_end(order, lead);
    (*cspan_at(&lead, INT64_C(13), seen + INT64_C(2))) = 1e+300;
    if (run_stage(seen + INT64_C(2), row, lead, timing, coefficients) < INT64_C(0))
    {
        return INT64_C(0);
    }
    longest = (*cspan_at(&state, INT64_C(8))) - (*cspan_at(&level, INT64_C(8)));
    set_stage_problem(seen, end, state, problem);
    count = shortest_ramps(problem, chain, phases, plan);
    if (count <= INT64_C(0))
    {
        return INT64_C(0);
    }
    copy_phases(phases, ramps, count);
    longest = span_min(longest + total_duration(ramps, count), least - (*cspan_at(&level, INT64_C(8))));
    set_stage_problem(seen, end, level, problem);
    (*cspan_at(&passing, INT64_C(11))) = 1.0;
    (*cspan_at(&passing, INT64_C(8))) = (*cspan_at(&level, level_order(order, lead)));
    third = seen + INT64_C(3);
    (*cspan_at(&passing, INT64_C(9))) = (*cspan_at(&level, third));
    result = passing_form(longest, longest, count, ramps, phases, problem, chain, plan);
    return result;
}
static int64_t settle_over_level(int64_t order, double end, double least, int64_t row, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d state;
    array_double_1d level;
    int64_t stage;
    int64_t i;
    int64_t count;
    int64_t seen;
    int64_t result;
    state = span_row(&lead, INT64_C(8));
    level = span_row(&lead, INT64_C(9));
    stage = level_order(order, lead);
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(13), i)) = 1e+300;
    }
    (*cspan_at(&lead, INT64_C(13), stage)) = end;
    row = settle(stage, row, lead, timing, coefficients);
    if ((row < INT64_C(0)) || ((*cspan_at(&state, INT64_C(8))) >= least))
    {
        return -INT64_C(1);
    }
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&level, i)) = (*cspan_at(&state, i));
    }
    count = passing_phases(order, least, row, lead, timing, coefficients);
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&state, i)) = (*cspan_at(&level, i));
    }
    if (count == INT64_C(0))
    {
        return -INT64_C(1);
    }
    seen = INT64_C(2) - order;
    end = lead_end(order, lead);
    result = append_phases(seen, end, count, row, lead, timing, coefficients);
    return result;
}
static void set_limits(double steep, array_double_2d lead)
{
    array_double_1d axis;
    axis = span_row(&lead, INT64_C(52));
    chain_limits(steep, axis, span_row(&lead, INT64_C(7)), span_row(&lead, INT64_C(11)));
    set_chains(steep, axis, span_row(&lead, INT64_C(11)), span_rows(&lead, INT64_C(54), INT64_C(61)));
}
static bool is_settled(array_double_2d lead)
{
    int64_t i;
    for (i = INT64_C(3); i < (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0)))) + INT64_C(1); i += INT64_C(1))
    {
        if ((*cspan_at(&lead, INT64_C(7), i)) != 0.0)
        {
            return 0;
        }
    }
    return 1;
}
static void soonest_ends(int64_t order, array_double_2d lead)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(13), i)) = 1e+300;
    }
    if (order == INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(13), order)) = (*cspan_at(&lead, INT64_C(17), INT64_C(2)));
    }
}
static double profile_time(array_double_2d lead)
{
    array_double_1d state;
    array_double_1d target;
    array_double_1d problem;
    array_double_1d axis;
    array_double_2d phases;
    int64_t order;
    double value;
    int64_t count;
    int64_t i;
    double duration;
    state = span_row(&lead, INT64_C(8));
    target = span_row(&lead, INT64_C(17));
    problem = span_row(&lead, INT64_C(18));
    axis = span_row(&lead, INT64_C(52));
    phases = span_rows(&lead, INT64_C(19), INT64_C(52));
    for (order = INT64_C(1); order < INT64_C(3); order += INT64_C(1))
    {
        value = (*cspan_at(&state, INT64_C(0) + order));
        if (fabs(value) > side_limit(order, value, axis) * (1.0 + 1e-12))
        {
            return -1.0;
        }
    }
    (*cspan_at(&problem, INT64_C(0))) = (*cspan_at(&state, INT64_C(0) + INT64_C(1)));
    (*cspan_at(&problem, INT64_C(1))) = (*cspan_at(&state, INT64_C(0) + INT64_C(2)));
    (*cspan_at(&problem, INT64_C(2))) = (*cspan_at(&target, INT64_C(2)));
    (*cspan_at(&problem, INT64_C(3))) = (*cspan_at(&target, INT64_C(3)));
    (*cspan_at(&problem, INT64_C(4))) = (*cspan_at(&target, INT64_C(4))) - (*cspan_at(&state, INT64_C(0)));
    count = plain_profile(problem, axis, phases, span_rows(&lead, INT64_C(61), INT64_C(301)));
    if (count < INT64_C(0))
    {
        return -1.0;
    }
    duration = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        duration = duration + (*cspan_at(&phases, i, INT64_C(0)));
    }
    return duration;
}
static void keep_lead(int64_t last, double time, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t first;
    int64_t row;
    int64_t i;
    first = INT64_C(400);
    for (row = first; row < last; row += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
        {
            (*cspan_at(&timing, row - first, i)) = (*cspan_at(&timing, row, i));
        }
        for (i = INT64_C(0); i < coefficients.shape[INT64_C(1)]; i += INT64_C(1))
        {
            (*cspan_at(&coefficients, row - first, i)) = (*cspan_at(&coefficients, row, i));
        }
    }
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(10), i)) = (*cspan_at(&lead, INT64_C(8), i));
        (*cspan_at(&lead, INT64_C(14), i)) = (*cspan_at(&lead, INT64_C(13), i));
    }
    (*cspan_at(&lead, INT64_C(15), INT64_C(0))) = time;
    (*cspan_at(&lead, INT64_C(15), INT64_C(1))) = last - first;
}
static bool begins_now(array_double_2d lead, array_double_2d coefficients)
{
    int64_t width;
    int64_t i;
    double value;
    width = coefficients.shape[INT64_C(1)];
    for (i = INT64_C(1); i < span_floor_div(width, INT64_C(2)) + INT64_C(1); i += INT64_C(1))
    {
        value = evaluate_piece(coefficients, INT64_C(400), width, 0.0, i);
        if (!(fabs(value - (*cspan_at(&lead, INT64_C(0), i))) <= 1e-11 * (*cspan_at(&lead, INT64_C(11), i))))
        {
            return 0;
        }
    }
    return 1;
}
static bool keep_better(int64_t last, double time, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t first;
    double best;
    array_double_2d check;
    array_double_1d lower;
    first = INT64_C(400);
    best = (*cspan_at(&lead, INT64_C(15), INT64_C(0)));
    if ((best >= 0.0) && (!(time < best * (*cspan_at(&lead, INT64_C(15), INT64_C(3))))))
    {
        return 0;
    }
    check = span_rows(&lead, INT64_C(305), INT64_C(353));
    lower = span_row(&lead, INT64_C(53));
    if (last > first)
    {
        if (!begins_now(lead, coefficients))
        {
            return 0;
        }
        keep_inside(check);
        if (!check_axis(first, last, timing, coefficients, limits, lower, 1e-09, 5e-10, check))
        {
            return 0;
        }
    }
    keep_lead(last, time, lead, timing, coefficients);
    (*cspan_at(&lead, INT64_C(15), INT64_C(3))) = 1.0 - 1e-12;
    return 1;
}
static bool try_lead(int64_t order, int64_t row, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t last;
    double time;
    double rest;
    bool result;
    last = settle(order, row, lead, timing, coefficients);
    if (last < INT64_C(0))
    {
        return 0;
    }
    time = (*cspan_at(&lead, INT64_C(8), INT64_C(8)));
    if (order == INT64_C(2))
    {
        rest = profile_time(lead);
        if (rest < 0.0)
        {
            return 0;
        }
        time = time + rest;
    }
    result = keep_better(last, time, limits, lead, timing, coefficients);
    return result;
}
static double try_level(int64_t order, double level, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t last;
    double time;
    last = settle_over_level(order, level, least, INT64_C(400), lead, timing, coefficients);
    if (last < INT64_C(0))
    {
        return 1e+300;
    }
    time = (*cspan_at(&lead, INT64_C(8), INT64_C(8)));
    keep_better(last, time, limits, lead, timing, coefficients);
    return time;
}
static bool try_end(int64_t order, int64_t stage, double end, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    double bound;
    int64_t i;
    bool result;
    bound = (*cspan_at(&lead, INT64_C(11), stage));
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(13), i)) = (*cspan_at(&lead, INT64_C(14), i));
    }
    (*cspan_at(&lead, INT64_C(13), stage)) = span_min(span_max(end, -bound), bound);
    result = try_lead(order, INT64_C(400), limits, lead, timing, coefficients);
    return result;
}
static void search_end(int64_t order, int64_t stage, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    double bound;
    int64_t i;
    double step;
    double end;
    bound = (*cspan_at(&lead, INT64_C(11), stage));
    for (i = -INT64_C(4); i < INT64_C(5); i += INT64_C(1))
    {
        try_end(order, stage, 0.25 * i * bound, limits, lead, timing, coefficients);
    }
    step = 0.125 * bound;
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        end = (*cspan_at(&lead, INT64_C(14), stage));
        if (end > 1e+299)
        {
            break;
        }
        if (!try_end(order, stage, end + step, limits, lead, timing, coefficients))
        {
            if (!try_end(order, stage, end - step, limits, lead, timing, coefficients))
            {
                step = 0.5 * step;
            }
        }
    }
}
static void follow_profile(int64_t order, int64_t stage, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d first;
    int64_t i;
    double level;
    first = span_row(&lead, INT64_C(19));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        if ((*cspan_at(&first, INT64_C(4))) > 0.5)
        {
            break;
        }
        level = (*cspan_at(&first, INT64_C(2))) + (*cspan_at(&first, INT64_C(3)));
        if (!try_end(order, stage, level, limits, lead, timing, coefficients))
        {
            break;
        }
    }
}
static int64_t first_free_stage(int64_t order)
{
    if (order == INT64_C(1))
    {
        return order + INT64_C(2);
    }
    return order;
}
static void improve_ends(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t smoothness;
    int64_t first_free;
    int64_t sweep;
    int64_t i;
    int64_t stage;
    smoothness = (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0))));
    first_free = first_free_stage(order);
    for (sweep = INT64_C(0); sweep < INT64_C(2); sweep += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
        {
            stage = first_free + INT64_C(2) * i;
            if (stage < smoothness)
            {
                if (i == INT64_C(0))
                {
                    follow_profile(order, stage, limits, lead, timing, coefficients);
                }
                search_end(order, stage, limits, lead, timing, coefficients);
            }
        }
        if (first_free + INT64_C(2) >= smoothness)
        {
            break;
        }
    }
}
static void search_ends(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t i;
    soonest_ends(order, lead);
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(14), i)) = (*cspan_at(&lead, INT64_C(13), i));
    }
    try_lead(order, INT64_C(400), limits, lead, timing, coefficients);
    if (!is_settled(lead))
    {
        improve_ends(order, limits, lead, timing, coefficients);
    }
}
static double near_zero(double i)
{
    double share;
    if (i == 0.0)
    {
        return 0.0;
    }
    share = pow(0.7, (12.0 - fabs(i)));
    if (i < 0.0)
    {
        share = -share;
    }
    return share;
}
static void search_pairs(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t smoothness;
    int64_t stage;
    int64_t earlier;
    int64_t i;
    int64_t j;
    bool free;
    double end;
    smoothness = (int64_t)((*cspan_at(&lead, INT64_C(52), INT64_C(0))));
    stage = first_free_stage(order);
    earlier = stage + INT64_C(2);
    for (i = -INT64_C(12); i < INT64_C(13); i += INT64_C(1))
    {
        for (j = -INT64_C(12); j < INT64_C(14); j += INT64_C(1))
        {
            free = j == INT64_C(13);
            if ((!free) && (earlier >= smoothness))
            {
                continue;
            }
            soonest_ends(order, lead);
            (*cspan_at(&lead, INT64_C(13), stage)) = near_zero((double)(i)) * (*cspan_at(&lead, INT64_C(11), stage));
            if (!free)
            {
                end = near_zero((double)(j)) * (*cspan_at(&lead, INT64_C(11), earlier));
                (*cspan_at(&lead, INT64_C(13), earlier)) = end;
            }
            try_lead(order, INT64_C(400), limits, lead, timing, coefficients);
        }
    }
}
static double search_grid(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t stage;
    double kept;
    double least;
    int64_t count;
    int64_t i;
    double level;
    double time;
    double found;
    stage = level_order(order, lead);
    kept = (*cspan_at(&lead, INT64_C(15), INT64_C(2)));
    least = 1e+300;
    if ((*cspan_at(&lead, INT64_C(15), INT64_C(0))) >= 0.0)
    {
        least = 1.2 * (*cspan_at(&lead, INT64_C(15), INT64_C(0)));
    }
    found = 1e+300;
    count = INT64_C(6);
    if ((*cspan_at(&lead, INT64_C(52), INT64_C(0))) > 4.5)
    {
        count = INT64_C(24);
    }
    for (i = (-count) - INT64_C(1); i < count + INT64_C(1); i += INT64_C(1))
    {
        level = kept;
        if (i >= -count)
        {
            level = near_zero(12.0 * i / count) * (*cspan_at(&lead, INT64_C(11), stage));
        }
        time = try_level(order, level, least, limits, lead, timing, coefficients);
        if (time < least)
        {
            least = time;
            found = time;
            (*cspan_at(&lead, INT64_C(15), INT64_C(2))) = level;
        }
    }
    return found;
}
static void improve_level(int64_t order, double least, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    double bound;
    double step;
    int64_t i;
    double around;
    int64_t side;
    double level;
    double time;
    bound = (*cspan_at(&lead, INT64_C(11), level_order(order, lead)));
    step = 0.15 * fabs((*cspan_at(&lead, INT64_C(15), INT64_C(2)))) + 0.005 * bound;
    for (i = INT64_C(0); i < INT64_C(8); i += INT64_C(1))
    {
        around = (*cspan_at(&lead, INT64_C(15), INT64_C(2)));
        for (side = INT64_C(0); side < INT64_C(2); side += INT64_C(1))
        {
            level = span_min(span_max(around + step * (INT64_C(1) - INT64_C(2) * side), -bound), bound);
            time = try_level(order, level, least, limits, lead, timing, coefficients);
            if (time < least)
            {
                least = time;
                (*cspan_at(&lead, INT64_C(15), INT64_C(2))) = level;
            }
        }
        if ((*cspan_at(&lead, INT64_C(15), INT64_C(2))) == around)
        {
            step = 0.5 * step;
        }
    }
}
static void search_levels(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    double steep;
    double found;
    double highest;
    int64_t i;
    double before;
    double level;
    steep = 1.0;
    found = 1e+300;
    highest = (*cspan_at(&lead, INT64_C(52), INT64_C(0)));
    (*cspan_at(&lead, INT64_C(15), INT64_C(2))) = (*cspan_at(&lead, INT64_C(7), level_order(order, lead)));
    (*cspan_at(&lead, INT64_C(15), INT64_C(3))) = 1.0 - 1e-12;
    for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
    {
        set_limits(steep, lead);
        before = (*cspan_at(&lead, INT64_C(15), INT64_C(0)));
        if ((found > 1e+299) || ((i == INT64_C(1)) && (highest > 4.5)))
        {
            found = search_grid(order, limits, lead, timing, coefficients);
        }
        else
        {
            level = (*cspan_at(&lead, INT64_C(15), INT64_C(2)));
            found = try_level(order, level, 1e+300, limits, lead, timing, coefficients);
        }
        if (found < 1e+299)
        {
            improve_level(order, found, limits, lead, timing, coefficients);
        }
        if ((i > INT64_C(0)) && ((*cspan_at(&lead, INT64_C(15), INT64_C(0))) == before))
        {
            break;
        }
        (*cspan_at(&lead, INT64_C(15), INT64_C(3))) = 0.99;
        steep = 10.0 * steep;
    }
}
static bool permits_levels(int64_t order, array_double_2d lead)
{
    array_double_1d target;
    bool resting;
    target = span_row(&lead, INT64_C(17));
    if (((*cspan_at(&lead, INT64_C(52), INT64_C(0))) < 3.5) || is_settled(lead))
    {
        return 0;
    }
    if (level_order(order, lead) == INT64_C(0))
    {
        return 0;
    }
    resting = ((*cspan_at(&target, INT64_C(2))) == 0.0) && ((*cspan_at(&target, INT64_C(3))) == 0.0);
    return (order == INT64_C(1)) || resting;
}
static void search_stages(int64_t order, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    double steep;
    int64_t i;
    double before;
    int64_t j;
    bool gained;
    steep = 1.0;
    for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
    {
        set_limits(steep, lead);
        (*cspan_at(&lead, INT64_C(15), INT64_C(3))) = 0.99;
        before = (*cspan_at(&lead, INT64_C(15), INT64_C(0)));
        if (before >= 0.0)
        {
            for (j = INT64_C(0); j < INT64_C(9); j += INT64_C(1))
            {
                (*cspan_at(&lead, INT64_C(13), j)) = (*cspan_at(&lead, INT64_C(14), j));
            }
            gained = try_lead(order, INT64_C(400), limits, lead, timing, coefficients);
            if ((i > INT64_C(1)) && (!gained))
            {
                break;
            }
        }
        search_ends(order, limits, lead, timing, coefficients);
        steep = 10.0 * steep;
    }
    if (((*cspan_at(&lead, INT64_C(15), INT64_C(0))) < 0.0) && (!is_settled(lead)))
    {
        search_pairs(order, limits, lead, timing, coefficients);
        if ((*cspan_at(&lead, INT64_C(15), INT64_C(0))) >= 0.0)
        {
            improve_ends(order, limits, lead, timing, coefficients);
        }
    }
}
static bool settled_end(int64_t row, int64_t last, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    array_double_1d state;
    int64_t width;
    double length;
    int64_t i;
    bool settled;
    state = span_row(&lead, INT64_C(7));
    width = coefficients.shape[INT64_C(1)];
    length = (*cspan_at(&timing, row, INT64_C(1)));
    settled = 1;
    for (i = INT64_C(0); i < span_floor_div(width, INT64_C(2)) + INT64_C(1); i += INT64_C(1))
    {
        if (row + INT64_C(1) < last)
        {
            (*cspan_at(&state, i)) = evaluate_piece(coefficients, row + INT64_C(1), width, 0.0, i);
        }
        else
        {
            (*cspan_at(&state, i)) = evaluate_piece(coefficients, row, width, length, i);
        }
        if (i > INT64_C(2))
        {
            if (fabs((*cspan_at(&state, i))) > 1e-10 * (*cspan_at(&lead, INT64_C(11), i)))
            {
                settled = 0;
            }
            (*cspan_at(&state, i)) = 0.0;
        }
    }
    (*cspan_at(&state, INT64_C(8))) = (*cspan_at(&timing, row, INT64_C(0))) + length;
    return settled;
}
static void follow_plan(int64_t order, int64_t axis, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t first;
    int64_t last;
    int64_t tried;
    int64_t row;
    int64_t place;
    int64_t i;
    first = (*cspan_at(&plan_offsets, axis));
    last = (*cspan_at(&plan_offsets, axis + INT64_C(1)));
    tried = INT64_C(0);
    for (row = first; row < last; row += INT64_C(1))
    {
        place = INT64_C(400) + row - first;
        if ((row - first >= span_floor_div(INT64_C(3) * INT64_C(400), INT64_C(4))) || (tried >= INT64_C(8)))
        {
            break;
        }
        for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
        {
            (*cspan_at(&timing, place, i)) = (*cspan_at(&plan_timing, row, i));
        }
        for (i = INT64_C(0); i < coefficients.shape[INT64_C(1)]; i += INT64_C(1))
        {
            (*cspan_at(&coefficients, place, i)) = (*cspan_at(&plan_coefficients, row, i));
        }
        if (settled_end(row, last, lead, plan_timing, plan_coefficients))
        {
            tried = tried + INT64_C(1);
            for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
            {
                (*cspan_at(&lead, INT64_C(13), i)) = 1e+300;
            }
            if (order == INT64_C(1))
            {
                (*cspan_at(&lead, INT64_C(13), order)) = (*cspan_at(&lead, INT64_C(17), INT64_C(2)));
            }
            try_lead(order, place + INT64_C(1), limits, lead, timing, coefficients);
        }
    }
}
static bool start_search(int64_t shape, array_double_1d limits, array_double_2d lead)
{
    int64_t i;
    segfmu_axis_limits(limits.shape[INT64_C(0)] - INT64_C(1), shape, limits, span_row(&lead, INT64_C(52)));
    set_lower(span_row(&lead, INT64_C(53)), span_row(&lead, INT64_C(52)));
    if (!segfmu_ramp_parameters(usual_share(span_row(&lead, INT64_C(52))), span_row(&lead, INT64_C(52)), span_rows(&lead, INT64_C(54), INT64_C(61))))
    {
        return 0;
    }
    for (i = INT64_C(1); i < limits.shape[INT64_C(0)]; i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(12), i)) = rounding_error(i, limits);
    }
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(7), i)) = (*cspan_at(&lead, INT64_C(0), i));
    }
    return 1;
}
static void improve_lead(int64_t order, double within_0001, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t i;
    double time;
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(7), i)) = (*cspan_at(&lead, INT64_C(0), i));
    }
    time = (*cspan_at(&lead, INT64_C(15), INT64_C(0)));
    if (((time < 0.0) || (time > within_0001)) && permits_levels(order, lead))
    {
        search_levels(order, limits, lead, timing, coefficients);
    }
}
static void prepend_brake(int64_t steps, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t count;
    int64_t i;
    int64_t row;
    count = (int64_t)((*cspan_at(&lead, INT64_C(15), INT64_C(1))));
    if ((*cspan_at(&lead, INT64_C(15), INT64_C(0))) < 0.0)
    {
        return;
    }
    if (count + steps > INT64_C(400))
    {
        (*cspan_at(&lead, INT64_C(15), INT64_C(0))) = -1.0;
        return;
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        row = count - INT64_C(1) - i;
        copy_piece(timing, coefficients, row, timing, coefficients, row + steps);
    }
    for (row = INT64_C(0); row < steps; row += INT64_C(1))
    {
        copy_piece(timing, coefficients, INT64_C(2) * INT64_C(400) + row, timing, coefficients, row);
    }
    (*cspan_at(&lead, INT64_C(15), INT64_C(1))) = count + steps;
}
static void search_braked(int64_t order, double within_0001, int64_t shape, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t i;
    int64_t repeat;
    int64_t steps;
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(1), i)) = (*cspan_at(&lead, INT64_C(0), i));
    }
    for (repeat = INT64_C(0); repeat < INT64_C(2); repeat += INT64_C(1))
    {
        if ((*cspan_at(&lead, INT64_C(15), INT64_C(0))) < 0.0)
        {
            steps = segfmu_find_brake(repeat == INT64_C(1), limits, lead, timing, coefficients);
            if (steps > INT64_C(0))
            {
                for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
                {
                    (*cspan_at(&lead, INT64_C(0), i)) = (*cspan_at(&lead, INT64_C(2), i));
                }
                if (start_search(shape, limits, lead))
                {
                    search_stages(order, limits, lead, timing, coefficients);
                    improve_lead(order, within_0001, limits, lead, timing, coefficients);
                }
                for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
                {
                    (*cspan_at(&lead, INT64_C(0), i)) = (*cspan_at(&lead, INT64_C(1), i));
                }
                prepend_brake(steps, lead, timing, coefficients);
            }
        }
    }
}
static bool find_lead(int64_t order, double within_0001, int64_t axis, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d limits, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    bool brakes;
    int64_t smoothness;
    int64_t shape;
    bool result;
    (*cspan_at(&lead, INT64_C(15), INT64_C(0))) = -1.0;
    (*cspan_at(&lead, INT64_C(15), INT64_C(1))) = 0.0;
    brakes = (*cspan_at(&lead, INT64_C(16), INT64_C(3))) > 0.5;
    smoothness = limits.shape[INT64_C(0)] - INT64_C(1);
    if ((axis < INT64_C(0)) || (smoothness < INT64_C(2)) || (smoothness > INT64_C(6)) || (coefficients.shape[INT64_C(1)] != INT64_C(2) * smoothness))
    {
        return 0;
    }
    shape = (int64_t)((*cspan_at(&lead, INT64_C(16), INT64_C(2))));
    if ((!brakes) || (!is_outside(limits, lead)))
    {
        if (start_search(shape, limits, lead))
        {
            search_stages(order, limits, lead, timing, coefficients);
            (*cspan_at(&lead, INT64_C(15), INT64_C(3))) = 1.0 - 1e-12;
            follow_plan(order, axis, plan_offsets, plan_timing, plan_coefficients, limits, lead, timing, coefficients);
            improve_lead(order, within_0001, limits, lead, timing, coefficients);
        }
    }
    if (brakes && ((*cspan_at(&lead, INT64_C(15), INT64_C(0))) < 0.0))
    {
        search_braked(order, within_0001, shape, limits, lead, timing, coefficients);
    }
    result = (*cspan_at(&lead, INT64_C(15), INT64_C(0))) >= 0.0;
    return result;
}
static void set_start(int64_t axis, array_double_2d start, array_double_2d lower, array_double_2d lead)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(9); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(0), i)) = 0.0;
    }
    for (i = INT64_C(0); i < span_min_int(start.shape[INT64_C(1)], INT64_C(9)); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(0), i)) = (*cspan_at(&start, axis, i));
    }
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&lead, INT64_C(53), i)) = (*cspan_at(&lower, axis, i));
    }
}
static void set_target(int64_t axis, array_double_2d targets, array_double_2d lead)
{
    (*cspan_at(&lead, INT64_C(17), INT64_C(4))) = (*cspan_at(&targets, axis, INT64_C(0)));
    (*cspan_at(&lead, INT64_C(17), INT64_C(2))) = (*cspan_at(&targets, axis, INT64_C(1)));
    (*cspan_at(&lead, INT64_C(17), INT64_C(3))) = (*cspan_at(&targets, axis, INT64_C(2)));
}
static int64_t latest_axis(array_double_2d ends)
{
    double longest;
    int64_t axis;
    int64_t latest;
    latest = -INT64_C(1);
    longest = -1.0;
    for (axis = INT64_C(0); axis < ends.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        if (((*cspan_at(&ends, axis, INT64_C(6))) < 0.5) && ((*cspan_at(&ends, axis, INT64_C(4))) > longest))
        {
            latest = axis;
            longest = (*cspan_at(&ends, axis, INT64_C(4)));
        }
    }
    return latest;
}
static int64_t take_lead(int64_t first, array_double_1d end, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t i;
    int64_t found;
    int64_t row;
    int64_t count;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&end, i)) = (*cspan_at(&lead, INT64_C(10), i));
    }
    (*cspan_at(&end, INT64_C(3))) = (*cspan_at(&lead, INT64_C(10), INT64_C(8)));
    (*cspan_at(&end, INT64_C(4))) = (*cspan_at(&lead, INT64_C(15), INT64_C(0)));
    (*cspan_at(&end, INT64_C(5))) = 0.0;
    found = timing.shape[INT64_C(0)] - INT64_C(1200);
    count = (int64_t)((*cspan_at(&lead, INT64_C(15), INT64_C(1))));
    for (row = INT64_C(0); row < count; row += INT64_C(1))
    {
        copy_piece(timing, coefficients, found + row, timing, coefficients, first + row);
    }
    return count;
}
static void follow_whole(int64_t axis, array_double_1d limits, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_1d end, array_double_2d lead, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets)
{
    int64_t first;
    int64_t last;
    array_double_1d reached;
    double velocity;
    int64_t i;
    int64_t row;
    int64_t target;
    first = (*cspan_at(&plan_offsets, axis));
    last = (*cspan_at(&plan_offsets, axis + INT64_C(1)));
    if (last == first)
    {
        return;
    }
    reached = span_row(&lead, INT64_C(8));
    write_end(last - INT64_C(1), plan_timing, plan_coefficients, reached);
    velocity = (*cspan_at(&lead, INT64_C(17), INT64_C(2)));
    if (!((*cspan_at(&reached, INT64_C(3))) < (*cspan_at(&end, INT64_C(4)))))
    {
        return;
    }
    if (!is_at_velocity(velocity, limits, reached))
    {
        return;
    }
    for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
    {
        (*cspan_at(&end, i)) = (*cspan_at(&reached, i));
    }
    (*cspan_at(&end, INT64_C(4))) = (*cspan_at(&end, INT64_C(3)));
    (*cspan_at(&end, INT64_C(5))) = 1.0;
    for (row = first; row < last; row += INT64_C(1))
    {
        target = row + axis * INT64_C(400);
        copy_piece(plan_timing, plan_coefficients, row, timing, coefficients, target);
    }
    (*cspan_at(&offsets, axis + INT64_C(1))) = last - first;
}
static void pack_leads(array_int64_t_1d plan_offsets, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets)
{
    int64_t used;
    int64_t axis;
    int64_t first;
    int64_t row;
    used = INT64_C(0);
    (*cspan_at(&offsets, INT64_C(0))) = INT64_C(0);
    for (axis = INT64_C(0); axis < offsets.shape[INT64_C(0)] - INT64_C(1); axis += INT64_C(1))
    {
        first = (*cspan_at(&plan_offsets, axis)) + axis * INT64_C(400);
        for (row = INT64_C(0); row < (*cspan_at(&offsets, axis + INT64_C(1))); row += INT64_C(1))
        {
            copy_piece(timing, coefficients, first + row, timing, coefficients, used);
            used = used + INT64_C(1);
        }
        (*cspan_at(&offsets, axis + INT64_C(1))) = used;
    }
}
int64_t segfmu_find_leads(array_double_3d states, array_double_2d limits, array_double_2d lower, array_int64_t_1d plan_offsets, array_double_2d plan_timing, array_double_2d plan_coefficients, array_double_2d ends, array_double_2d lead, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets)
{
    int64_t axes;
    int64_t order;
    double latest;
    bool waits;
    int64_t rows;
    int64_t found;
    double longest;
    int64_t attempt;
    int64_t first;
    int64_t axis;
    axes = limits.shape[INT64_C(0)];
    order = INT64_C(2);
    if ((*cspan_at(&lead, INT64_C(16), INT64_C(0))) == INT64_C(1))
    {
        order = INT64_C(1);
    }
    latest = (*cspan_at(&lead, INT64_C(16), INT64_C(1)));
    waits = (latest >= 0.0) && (axes > INT64_C(1));
    rows = timing.shape[INT64_C(0)];
    found = rows - INT64_C(1200);
    longest = span_max(latest, 0.0);
    if (waits)
    {
        longest = 1e+300;
    }
    for (attempt = INT64_C(0); attempt < INT64_C(2) * axes; attempt += INT64_C(1))
    {
        axis = attempt;
        if (attempt >= axes)
        {
            axis = latest_axis(ends);
            if ((!waits) || (axis < INT64_C(0)) || ((*cspan_at(&ends, axis, INT64_C(4))) <= latest))
            {
                break;
            }
            longest = latest;
        }
        else
        {
            (*cspan_at(&ends, axis, INT64_C(6))) = 0.0;
        }
        set_start(axis, span_matrix(&states, INT64_C(0)), lower, lead);
        set_target(axis, span_matrix(&states, INT64_C(1)), lead);
        if (find_lead(order, longest, axis, plan_offsets, plan_timing, plan_coefficients, span_row(&limits, axis), lead, span_rows(&timing, found, rows), span_rows(&coefficients, found, rows)))
        {
            first = (*cspan_at(&plan_offsets, axis)) + axis * INT64_C(400);
            (*cspan_at(&offsets, axis + INT64_C(1))) = take_lead(first, span_row(&ends, axis), lead, timing, coefficients);
        }
        else if (attempt < axes)
        {
            (*cspan_at(&offsets, axis + INT64_C(1))) = INT64_C(0);
            (*cspan_at(&ends, axis, INT64_C(4))) = 1e+300;
        }
        if (order == INT64_C(1))
        {
            follow_whole(axis, span_row(&limits, axis), plan_offsets, plan_timing, plan_coefficients, span_row(&ends, axis), lead, timing, coefficients, offsets);
        }
        if ((*cspan_at(&ends, axis, INT64_C(4))) == 1e+300)
        {
            return axis;
        }
        if (attempt >= axes)
        {
            latest = span_max(latest, (*cspan_at(&ends, axis, INT64_C(4))));
            (*cspan_at(&ends, axis, INT64_C(6))) = 1.0;
        }
    }
    pack_leads(plan_offsets, timing, coefficients, offsets);
    return -INT64_C(1);
}
bool segfmu_find_brakes(array_double_2d start, array_double_2d limits, array_double_2d lower, array_double_2d brakes, array_double_2d lead, array_double_2d timing, array_double_2d coefficients)
{
    int64_t axis;
    int64_t count;
    int64_t i;
    bool found;
    found = 0;
    for (axis = INT64_C(0); axis < start.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        set_start(axis, start, lower, lead);
        count = segfmu_find_brake(0, span_row(&limits, axis), lead, timing, coefficients);
        for (i = INT64_C(0); i < INT64_C(27); i += INT64_C(1))
        {
            (*cspan_at(&brakes, axis, i)) = 0.0;
            if (count > INT64_C(0))
            {
                (*cspan_at(&brakes, axis, i)) = (*cspan_at(&lead, INT64_C(6), i));
            }
        }
        if ((*cspan_at(&brakes, axis, INT64_C(0))) > 0.0)
        {
            found = 1;
        }
    }
    return found;
}
static void clear_lead(array_double_2d lead)
{
    int64_t row;
    int64_t i;
    for (row = INT64_C(0); row < lead.shape[INT64_C(0)]; row += INT64_C(1))
    {
        for (i = INT64_C(0); i < lead.shape[INT64_C(1)]; i += INT64_C(1))
        {
            (*cspan_at(&lead, row, i)) = 0.0;
        }
    }
}
static void set_lead(int64_t order, int64_t shape, double meeting, array_double_2d lead)
{
    clear_lead(lead);
    (*cspan_at(&lead, INT64_C(16), INT64_C(0))) = order;
    (*cspan_at(&lead, INT64_C(16), INT64_C(1))) = meeting;
    (*cspan_at(&lead, INT64_C(16), INT64_C(2))) = shape;
    (*cspan_at(&lead, INT64_C(16), INT64_C(3))) = 1.0;
}
static bool lead_between(int64_t source, int64_t slot, array_double_2d ends, array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead)
{
    int64_t first;
    int64_t place;
    int64_t failed;
    first = source * INT64_C(4);
    place = slot * INT64_C(4);
    failed = segfmu_find_leads(states, limits, lower, span_part(&offsets, first, first + INT64_C(4)), span_matrix(&timing, source), span_matrix(&coefficients, source), ends, lead, span_matrix(&timing, slot), span_matrix(&coefficients, slot), span_part(&offsets, place, place + INT64_C(4)));
    return failed < INT64_C(0);
}
static void set_motion(array_double_2d operation, array_double_3d states)
{
    int64_t axis;
    int64_t i;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < states.shape[INT64_C(2)]; i += INT64_C(1))
        {
            (*cspan_at(&states, INT64_C(0), axis, i)) = (*cspan_at(&operation, INT64_C(13) + axis, i));
            (*cspan_at(&states, INT64_C(1), axis, i)) = 0.0;
        }
    }
}
static bool reach_velocities(array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead)
{
    int64_t axis;
    double wish;
    bool result;
    set_motion(operation, states);
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        wish = (*cspan_at(&operation, INT64_C(16), axis)) * (*cspan_at(&operation, INT64_C(12), axis));
        (*cspan_at(&states, INT64_C(1), axis, INT64_C(1))) = wish;
    }
    set_lead(INT64_C(1), INT64_C(1), -1.0, lead);
    result = lead_between(INT64_C(1), INT64_C(2), span_rows(&operation, INT64_C(20), INT64_C(23)), limits, span_rows(&operation, INT64_C(17), INT64_C(20)), timing, coefficients, offsets, states, lead);
    return result;
}
static bool reach_and_stop(array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead)
{
    array_double_2d reached;
    int64_t axis;
    int64_t i;
    array_double_2d stopped;
    bool result;
    if (!reach_velocities(operation, limits, timing, coefficients, offsets, states, lead))
    {
        return 0;
    }
    reached = span_rows(&operation, INT64_C(20), INT64_C(23));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < states.shape[INT64_C(2)]; i += INT64_C(1))
        {
            (*cspan_at(&states, INT64_C(0), axis, i)) = 0.0;
            (*cspan_at(&states, INT64_C(1), axis, i)) = 0.0;
        }
        (*cspan_at(&states, INT64_C(0), axis, INT64_C(0))) = (*cspan_at(&reached, axis, INT64_C(0)));
        (*cspan_at(&states, INT64_C(0), axis, INT64_C(1))) = (*cspan_at(&reached, axis, INT64_C(1)));
    }
    stopped = span_rows(&operation, INT64_C(23), INT64_C(26));
    set_lead(INT64_C(1), INT64_C(1), -1.0, lead);
    clear_plan(INT64_C(5), offsets);
    result = lead_between(INT64_C(5), INT64_C(3), stopped, limits, span_rows(&operation, INT64_C(17), INT64_C(20)), timing, coefficients, offsets, states, lead);
    return result;
}
static double way_left(int64_t axis, double velocity, double rest, array_double_2d known)
{
    double result;
    if (velocity > 0.0)
    {
        result = high_end(axis, known) - rest;
        return result;
    }
    if (velocity < 0.0)
    {
        result = rest - low_end(axis, known);
        return result;
    }
    return 1e+300;
}
static double room_left(int64_t axis, array_double_2d operation, array_double_2d known)
{
    double result;
    result = way_left(axis, (*cspan_at(&operation, INT64_C(20) + axis, INT64_C(1))), (*cspan_at(&operation, INT64_C(23) + axis, INT64_C(0))), known);
    return result;
}
static bool shrink_shares(bool last, array_double_2d operation, array_double_2d known)
{
    int64_t axis;
    double left;
    double stopping;
    double way;
    double share;
    double ratio;
    bool found;
    found = 0;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        left = room_left(axis, operation, known);
        if (left < 0.0)
        {
            found = 1;
            stopping = (*cspan_at(&operation, INT64_C(23) + axis, INT64_C(0)));
            way = fabs(stopping - (*cspan_at(&operation, INT64_C(13) + axis, INT64_C(0))));
            share = 0.0;
            if ((!last) && (way + left > 0.0))
            {
                ratio = (way + left) / way;
                share = 0.95 * pow(ratio, 0.7);
            }
            (*cspan_at(&operation, INT64_C(12), axis)) = share * (*cspan_at(&operation, INT64_C(12), axis));
        }
    }
    return found;
}
static void hold_shares(array_double_2d operation, array_double_2d known)
{
    array_double_1d command;
    double until;
    int64_t axis;
    array_double_1d held;
    double velocity;
    double delay;
    double longest;
    double hold;
    command = span_row(&operation, INT64_C(0));
    until = (*cspan_at(&command, INT64_C(1))) + (*cspan_at(&command, INT64_C(14)));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        held = span_row(&operation, INT64_C(9) + axis);
        velocity = (*cspan_at(&operation, INT64_C(16), axis)) * (*cspan_at(&operation, INT64_C(12), axis));
        delay = (*cspan_at(&operation, INT64_C(20) + axis, INT64_C(3)));
        (*cspan_at(&held, INT64_C(0))) = velocity;
        (*cspan_at(&held, INT64_C(1))) = delay;
        (*cspan_at(&held, INT64_C(2))) = 0.0;
        if (fabs(velocity) > 0.0)
        {
            longest = span_max(room_left(axis, operation, known), 0.0) / fabs(velocity);
            hold = span_max(until - delay, 0.0);
            if (hold < longest)
            {
                (*cspan_at(&held, INT64_C(2))) = 1.0;
            }
            (*cspan_at(&held, INT64_C(1))) = delay + span_min(hold, longest);
        }
    }
}
static void shift_row(int64_t row, double later, double way, array_double_3d timing, array_double_3d coefficients)
{
    (*cspan_at(&timing, INT64_C(4), row, INT64_C(0))) = (*cspan_at(&timing, INT64_C(4), row, INT64_C(0))) + later;
    (*cspan_at(&coefficients, INT64_C(4), row, INT64_C(0))) = (*cspan_at(&coefficients, INT64_C(4), row, INT64_C(0))) + way;
}
static bool join_held(array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    int64_t rows;
    int64_t tried;
    int64_t target;
    int64_t axis;
    array_double_1d reached;
    array_double_1d held;
    double hold;
    int64_t leads;
    int64_t row;
    int64_t behind;
    double way;
    rows = plan_pieces(INT64_C(2), offsets) + plan_pieces(INT64_C(3), offsets) + INT64_C(3);
    if (rows > INT64_C(1200))
    {
        return 0;
    }
    tried = INT64_C(4) * INT64_C(4);
    target = INT64_C(0);
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        (*cspan_at(&offsets, tried + axis)) = target;
        reached = span_row(&operation, INT64_C(20) + axis);
        held = span_row(&operation, INT64_C(9) + axis);
        hold = (*cspan_at(&held, INT64_C(1))) - (*cspan_at(&reached, INT64_C(3)));
        leads = INT64_C(2) * INT64_C(4) + axis;
        for (row = (*cspan_at(&offsets, leads)); row < (*cspan_at(&offsets, leads + INT64_C(1))); row += INT64_C(1))
        {
            copy_piece(span_matrix(&timing, INT64_C(2)), span_matrix(&coefficients, INT64_C(2)), row, span_matrix(&timing, INT64_C(4)), span_matrix(&coefficients, INT64_C(4)), target);
            target = target + INT64_C(1);
        }
        clear_piece(span_matrix(&coefficients, INT64_C(4)), target);
        (*cspan_at(&coefficients, INT64_C(4), target, INT64_C(0))) = (*cspan_at(&reached, INT64_C(0)));
        (*cspan_at(&coefficients, INT64_C(4), target, INT64_C(1))) = (*cspan_at(&reached, INT64_C(1)));
        (*cspan_at(&timing, INT64_C(4), target, INT64_C(0))) = (*cspan_at(&reached, INT64_C(3)));
        (*cspan_at(&timing, INT64_C(4), target, INT64_C(1))) = hold;
        target = target + INT64_C(1);
        behind = INT64_C(3) * INT64_C(4) + axis;
        (*cspan_at(&held, INT64_C(3))) = (*cspan_at(&offsets, behind + INT64_C(1))) - (*cspan_at(&offsets, behind));
        way = (*cspan_at(&reached, INT64_C(1))) * hold;
        for (row = (*cspan_at(&offsets, behind)); row < (*cspan_at(&offsets, behind + INT64_C(1))); row += INT64_C(1))
        {
            copy_piece(span_matrix(&timing, INT64_C(3)), span_matrix(&coefficients, INT64_C(3)), row, span_matrix(&timing, INT64_C(4)), span_matrix(&coefficients, INT64_C(4)), target);
            shift_row(target, (*cspan_at(&held, INT64_C(1))), way, timing, coefficients);
            target = target + INT64_C(1);
        }
    }
    (*cspan_at(&offsets, tried + INT64_C(3))) = target;
    return 1;
}
static bool seek_velocity(array_double_2d operation, array_double_2d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead)
{
    int64_t tries;
    int64_t i;
    bool result;
    tries = INT64_C(5);
    for (i = INT64_C(0); i < tries; i += INT64_C(1))
    {
        if (!reach_and_stop(operation, limits, timing, coefficients, offsets, states, lead))
        {
            return 0;
        }
        if (!shrink_shares(i == tries - INT64_C(2), operation, known))
        {
            break;
        }
    }
    hold_shares(operation, known);
    result = join_held(operation, timing, coefficients, offsets);
    return result;
}
static bool holds_long_enough(double elapsed, array_double_2d operation)
{
    array_double_1d command;
    double until;
    int64_t axis;
    array_double_1d held;
    command = span_row(&operation, INT64_C(0));
    until = elapsed + (*cspan_at(&command, INT64_C(1))) + 0.501 * (*cspan_at(&command, INT64_C(14)));
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        held = span_row(&operation, INT64_C(6) + axis);
        if (((*cspan_at(&held, INT64_C(2))) > 0.5) && ((*cspan_at(&held, INT64_C(1))) < until))
        {
            return 0;
        }
    }
    return 1;
}
static bool prolong_holds(double elapsed, array_double_2d operation, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    array_double_1d command;
    double until;
    int64_t axis;
    array_double_1d held;
    int64_t i;
    double before;
    double velocity;
    int64_t last;
    int64_t first;
    double rest;
    double longest;
    double longer;
    int64_t row;
    command = span_row(&operation, INT64_C(0));
    until = (*cspan_at(&command, INT64_C(1))) + (*cspan_at(&command, INT64_C(14)));
    if (!has_room(INT64_C(4), offsets))
    {
        return 0;
    }
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        held = span_row(&operation, INT64_C(9) + axis);
        for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
        {
            (*cspan_at(&held, i)) = (*cspan_at(&operation, INT64_C(6) + axis, i));
        }
        before = (*cspan_at(&held, INT64_C(1))) - elapsed;
        (*cspan_at(&held, INT64_C(1))) = before;
        if ((*cspan_at(&held, INT64_C(2))) > 0.5)
        {
            if (before <= 0.0)
            {
                return 0;
            }
            velocity = (*cspan_at(&held, INT64_C(0)));
            last = (*cspan_at(&offsets, INT64_C(4) * INT64_C(4) + axis + INT64_C(1)));
            first = last - (int64_t)((*cspan_at(&held, INT64_C(3))));
            rest = standstill(INT64_C(4), axis, timing, coefficients, offsets);
            longest = span_max(way_left(axis, velocity, rest, known), 0.0) / fabs(velocity);
            longer = span_max(until - before, 0.0);
            if (longest <= longer)
            {
                longer = longest;
                (*cspan_at(&held, INT64_C(2))) = 0.0;
            }
            (*cspan_at(&timing, INT64_C(4), first - INT64_C(1), INT64_C(1))) = (*cspan_at(&timing, INT64_C(4), first - INT64_C(1), INT64_C(1))) + longer;
            (*cspan_at(&held, INT64_C(1))) = before + longer;
            for (row = first; row < last; row += INT64_C(1))
            {
                shift_row(row, longer, velocity * longer, timing, coefficients);
            }
        }
    }
    return 1;
}
static int64_t insert_end(double duration, double after, int64_t count, array_double_2d ends)
{
    int64_t place;
    int64_t j;
    int64_t i;
    if (duration <= after)
    {
        return count;
    }
    place = count;
    while((place > INT64_C(0)) && ((*cspan_at(&ends, place - INT64_C(1), INT64_C(0))) > duration))
    {
        place = place - INT64_C(1);
    }
    if ((place > INT64_C(0)) && (duration - (*cspan_at(&ends, place - INT64_C(1), INT64_C(0))) <= 1e-10 * duration))
    {
        return count;
    }
    count = span_min_int(count + INT64_C(1), ends.shape[INT64_C(0)]);
    for (j = INT64_C(0); j < count - INT64_C(1) - place; j += INT64_C(1))
    {
        i = count - INT64_C(1) - j;
        (*cspan_at(&ends, i, INT64_C(0))) = (*cspan_at(&ends, i - INT64_C(1), INT64_C(0)));
    }
    if (place < count)
    {
        (*cspan_at(&ends, place, INT64_C(0))) = duration;
    }
    return count;
}
static int64_t cruise_times(double* result_0, double* result_1_0001, double cruise, array_double_1d problem, array_double_1d axis, array_double_2d phases)
{
    int64_t count;
    int64_t row;
    double duration;
    double y;
    double rest;
    cruise_form(&count, &row, &duration, &y, phases, cruise, problem, axis);
    if (count < INT64_C(0))
    {
        (*result_0) = 1e+300;
        (*result_1_0001) = 1e+300;
        return 0;
    }
    rest = (*cspan_at(&problem, INT64_C(4))) - y;
    if (rest * cruise <= 0.0)
    {
        (*result_0) = duration;
        (*result_1_0001) = 1e+300;
        return 0;
    }
    (*result_0) = duration;
    (*result_1_0001) = duration + rest / cruise;
    return 0;
}
static double cruise_time(double cruise, bool covering, array_double_1d problem, array_double_1d axis, array_double_2d phases)
{
    double duration;
    double covered;
    cruise_times(&duration, &covered, cruise, problem, axis, phases);
    if (covering)
    {
        return covered;
    }
    return duration;
}
static double turning_time(double lower, double upper, bool covering, array_double_1d problem, array_double_1d axis, array_double_2d phases)
{
    double shrink;
    double p;
    double q;
    double t_p;
    double t_q;
    int64_t i;
    shrink = 0.6180339887498949;
    p = upper - shrink * (upper - lower);
    q = lower + shrink * (upper - lower);
    t_p = cruise_time(p, covering, problem, axis, phases);
    t_q = cruise_time(q, covering, problem, axis, phases);
    for (i = INT64_C(0); i < INT64_C(30); i += INT64_C(1))
    {
        if (t_p <= t_q)
        {
            upper = q;
            q = p;
            t_q = t_p;
            p = upper - shrink * (upper - lower);
            t_p = cruise_time(p, covering, problem, axis, phases);
        }
        else
        {
            lower = p;
            p = q;
            t_p = t_q;
            q = lower + shrink * (upper - lower);
            t_q = cruise_time(q, covering, problem, axis, phases);
        }
    }
    return span_min(t_p, t_q);
}
static double cruise_sample(int64_t sample, double fastest, double backwards)
{
    double share;
    share = 2.0 * sample / INT64_C(24) - 1.0;
    if (share < 0.0)
    {
        return backwards * share;
    }
    return fastest * share;
}
static int64_t insert_turn(int64_t sample, bool covering, double least, double spent, double after, double fastest, double backwards, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count)
{
    array_double_2d phases;
    array_double_2d ends;
    double lower;
    double upper;
    double turn;
    int64_t result;
    if (spent + least <= after)
    {
        return count;
    }
    phases = span_rows(&work, INT64_C(0), INT64_C(21));
    ends = span_rows(&work, INT64_C(42), INT64_C(58));
    lower = cruise_sample(span_max_int(sample - INT64_C(1), INT64_C(0)), fastest, backwards);
    upper = cruise_sample(span_min_int(sample + INT64_C(1), INT64_C(24)), fastest, backwards);
    turn = turning_time(lower, upper, covering, problem, axis, phases);
    result = insert_end(spent + span_min(turn, least), after, count, ends);
    return result;
}
static int64_t turning_ends(double spent, double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count)
{
    array_double_2d phases;
    double first;
    double second;
    double first_covered;
    double second_covered;
    double fastest;
    double backwards;
    int64_t i;
    double third;
    double third_covered;
    double cruise;
    phases = span_rows(&work, INT64_C(0), INT64_C(21));
    first = 1e+300;
    second = 1e+300;
    first_covered = 1e+300;
    second_covered = 1e+300;
    fastest = speed_bound(1.0, 4.0 * after, problem, axis);
    backwards = speed_bound(-1.0, 4.0 * after, problem, axis);
    for (i = INT64_C(0); i < INT64_C(26); i += INT64_C(1))
    {
        third = 1e+300;
        third_covered = 1e+300;
        if (i < INT64_C(25))
        {
            cruise = cruise_sample(i, fastest, backwards);
            cruise_times(&third, &third_covered, cruise, problem, axis, phases);
        }
        if ((second < 1e+300) && (first >= second) && (third >= second))
        {
            count = insert_turn(i - INT64_C(1), 0, second, spent, after, fastest, backwards, problem, axis, work, count);
        }
        if ((second_covered < 1e+300) && (first_covered >= second_covered))
        {
            if (third_covered >= second_covered)
            {
                count = insert_turn(i - INT64_C(1), 1, second_covered, spent, after, fastest, backwards, problem, axis, work, count);
            }
        }
        first = second;
        second = third;
        first_covered = second_covered;
        second_covered = third_covered;
    }
    return count;
}
static int64_t insert_covering(array_double_2d phases, int64_t taken, double spent, double after, array_double_1d problem, array_double_1d axis, int64_t count, array_double_2d ends)
{
    double duration;
    int64_t result;
    if (taken <= INT64_C(0))
    {
        return count;
    }
    duration = valid_duration(phases, taken, problem, axis);
    if (duration < 0.0)
    {
        return count;
    }
    result = insert_end(spent + duration, after, count, ends);
    return result;
}
static int64_t covering_ends(double spent, double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count)
{
    array_double_2d phases;
    array_double_2d ends;
    array_double_1d family;
    double usual;
    int64_t form;
    int64_t taken;
    double cruise;
    int64_t branch;
    int64_t member;
    phases = span_rows(&work, INT64_C(0), INT64_C(21));
    ends = span_rows(&work, INT64_C(42), INT64_C(58));
    family = span_row(&work, INT64_C(98));
    usual = usual_duration(problem, axis);
    for (form = INT64_C(0); form < INT64_C(5); form += INT64_C(1))
    {
        if (form == INT64_C(0))
        {
            taken = slower_cruise(phases, problem, axis);
        }
        else if (form < INT64_C(3))
        {
            cruise = (*cspan_at(&axis, INT64_C(2)));
            if (form == INT64_C(2))
            {
                cruise = -(*cspan_at(&axis, INT64_C(9)));
            }
            taken = with_cruise(phases, cruise, problem, axis);
        }
        else
        {
            taken = direct_form(phases, form == INT64_C(3), problem, axis);
        }
        count = insert_covering(phases, taken, spent, after, problem, axis, count, ends);
    }
    for (branch = INT64_C(0); branch < INT64_C(4); branch += INT64_C(1))
    {
        if (same_members(branch, problem, family))
        {
            continue;
        }
        set_family(branch, problem, axis, family);
        for (member = INT64_C(0); member < INT64_C(4); member += INT64_C(1))
        {
            set_member(member, usual, 0, family);
            taken = tempered_form(phases, family, axis);
            if (taken < INT64_C(0))
            {
                break;
            }
            count = insert_covering(phases, taken, spent, after, problem, axis, count, ends);
        }
    }
    return count;
}
static int64_t loop_ends(double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count)
{
    array_double_2d ends;
    double longest;
    int64_t arc;
    int64_t sample;
    double duration;
    ends = span_rows(&work, INT64_C(42), INT64_C(58));
    longest = usual_duration(problem, axis);
    for (arc = INT64_C(0); arc < INT64_C(5); arc += INT64_C(1))
    {
        sample = INT64_C(0);
        while((sample >= INT64_C(0)) && (sample < INT64_C(48)))
        {
            next_loop(&sample, &duration, arc, sample, longest, problem, axis, work);
            if (duration >= 0.0)
            {
                count = insert_end(duration, after, count, ends);
            }
        }
    }
    return count;
}
static int64_t dip_ends(double after, array_double_1d problem, array_double_1d axis, array_double_2d work, int64_t count)
{
    array_double_1d rest;
    array_double_2d between;
    array_double_2d ends;
    int64_t i;
    double spent;
    int64_t used;
    double duration;
    rest = span_row(&work, INT64_C(61));
    between = span_rows(&work, INT64_C(65), INT64_C(98));
    ends = span_rows(&work, INT64_C(42), INT64_C(58));
    if (!set_both_dips(0.0, problem, axis, work))
    {
        return count;
    }
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        spent = problem_between(0.25 * i, problem, axis, rest, work);
        used = profile_between(rest, axis, work);
        if (used >= INT64_C(0))
        {
            duration = spent + total_duration(between, used);
            count = insert_end(duration, after, count, ends);
        }
    }
    return count;
}
static int64_t gap_ends(double after, double shortest, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d rest;
    int64_t count;
    int64_t variant;
    int64_t taken;
    double spent;
    int64_t result;
    rest = span_row(&work, INT64_C(60));
    count = INT64_C(0);
    for (variant = INT64_C(0); variant < INT64_C(4); variant += INT64_C(1))
    {
        braked(&taken, &spent, variant, problem, axis, work);
        if (taken < INT64_C(0))
        {
            continue;
        }
        if ((variant == INT64_C(0)) && ((after < 1.1 * shortest) || (!snap_is_last(axis))))
        {
            count = loop_ends(after, rest, axis, work, count);
        }
        count = covering_ends(spent, after, rest, axis, work, count);
        count = turning_ends(spent, after, rest, axis, work, count);
    }
    result = dip_ends(after, problem, axis, work, count);
    return result;
}
static void set_extreme(double sign, double pace, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    array_double_1d passing;
    double duration;
    int64_t i;
    double acceleration;
    int64_t q;
    passing = span_row(&work, INT64_C(101));
    duration = (*cspan_at(&problem, INT64_C(5)));
    for (i = INT64_C(0); i < INT64_C(26); i += INT64_C(1))
    {
        (*cspan_at(&passing, i)) = 0.0;
    }
    (*cspan_at(&passing, INT64_C(1))) = (*cspan_at(&axis, INT64_C(38)));
    (*cspan_at(&passing, INT64_C(2))) = pace;
    (*cspan_at(&passing, INT64_C(3))) = duration;
    acceleration = top_acceleration(axis);
    acceleration = span_min(acceleration, acceleration * duration / (*cspan_at(&axis, INT64_C(13))));
    (*cspan_at(&passing, INT64_C(4))) = acceleration;
    (*cspan_at(&passing, INT64_C(5))) = duration;
    (*cspan_at(&passing, INT64_C(6))) = sign;
    q = (int64_t)((*cspan_at(&axis, INT64_C(38)))) + INT64_C(2);
    set_alternating(sign, 0.6 * duration / q, work);
}
static int64_t extreme_form(int64_t* result_0, double* result_1_0001, double sign, double pace, array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t count;
    int64_t end;
    set_extreme(sign, pace, problem, axis, work);
    if (!solve_sequence(problem, axis, work))
    {
        (*result_0) = INT64_C(0);
        (*result_1_0001) = 0.0;
        return 0;
    }
    keep_sequence(INT64_C(158), work);
    if (!tighten(1e+300, problem, axis, work))
    {
        (*result_0) = INT64_C(0);
        (*result_1_0001) = 0.0;
        return 0;
    }
    count = write_sequence(phases, problem, axis, work);
    end = INT64_C(102) + (int64_t)((*cspan_at(&work, INT64_C(101), INT64_C(0)))) + INT64_C(1);
    (*result_0) = count;
    (*result_1_0001) = (*cspan_at(&work, end, INT64_C(0)));
    return 0;
}
static bool timed_extremes(array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    array_double_1d nearest;
    double distance;
    double known;
    int64_t i;
    double sign;
    int64_t found;
    array_double_2d phases;
    int64_t attempt;
    double pace;
    int64_t count;
    double reached;
    problem = span_row(&work, INT64_C(59));
    nearest = span_row(&work, INT64_C(58));
    distance = (*cspan_at(&problem, INT64_C(4)));
    known = (*cspan_at(&nearest, INT64_C(4)));
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        sign = 2.0 * i - 1.0;
        if (known < 0.0)
        {
            sign = -sign;
        }
        found = INT64_C(0);
        phases = span_rows(&cell, INT64_C(0), INT64_C(33));
        if (sign > 0.0)
        {
            found = INT64_C(2);
            phases = span_rows(&cell, INT64_C(33), INT64_C(66));
        }
        (*cspan_at(&nearest, found)) = 0.0;
        for (attempt = INT64_C(0); attempt < INT64_C(3); attempt += INT64_C(1))
        {
            pace = 1.0 - 0.2 * attempt;
            extreme_form(&count, &reached, sign, pace, phases, problem, axis, work);
            if ((count > INT64_C(0)) && (sign * reached >= sign * distance))
            {
                (*cspan_at(&nearest, found)) = count;
                (*cspan_at(&nearest, found + INT64_C(1))) = reached;
                break;
            }
            if ((count > INT64_C(0)) && (attempt == INT64_C(0)) && ((*cspan_at(&axis, INT64_C(38))) < 1.5))
            {
                return 0;
            }
        }
        if (((*cspan_at(&nearest, found)) == 0.0) && (sign != known))
        {
            return 0;
        }
    }
    return 1;
}
static void polynomial_levels(array_double_1d problem, array_double_1d gentle)
{
    double duration;
    double a;
    double square;
    double y;
    double v;
    double b;
    double third;
    double fourth;
    double fifth;
    double first;
    double second;
    double inner;
    double root;
    double low;
    double high;
    double last;
    int64_t i;
    double s;
    double curve;
    duration = (*cspan_at(&problem, INT64_C(5)));
    a = (*cspan_at(&problem, INT64_C(1)));
    square = duration * duration;
    y = (*cspan_at(&problem, INT64_C(4))) - ((*cspan_at(&problem, INT64_C(0))) + 0.5 * a * duration) * duration;
    v = ((*cspan_at(&problem, INT64_C(2))) - (*cspan_at(&problem, INT64_C(0))) - a * duration) * duration;
    b = ((*cspan_at(&problem, INT64_C(3))) - a) * square;
    third = 10.0 * y - 4.0 * v + 0.5 * b;
    fourth = (-15.0) * y + 7.0 * v - b;
    fifth = 6.0 * y - 3.0 * v + 0.5 * b;
    first = 1.0 / 3.0;
    second = 2.0 / 3.0;
    inner = 4.0 * fourth * fourth - 10.0 * third * fifth;
    if (inner > 0.0)
    {
        root = 2.0 * fourth + sqrt(inner);
        if (fourth < 0.0)
        {
            root = 2.0 * fourth - sqrt(inner);
        }
        low = (-third) / root;
        high = 2.0;
        if (fifth != 0.0)
        {
            high = (-0.1) * root / fifth;
        }
        if (low > high)
        {
            last = low;
            low = high;
            high = last;
        }
        if ((low > 0.0) && (low < 1.0))
        {
            first = low;
            second = 0.5 * (1.0 + low);
        }
        if ((high > 0.0) && (high < 1.0))
        {
            second = high;
            if (!((low > 0.0) && (low < 1.0)))
            {
                first = 0.5 * high;
            }
        }
    }
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        s = first;
        if (i == INT64_C(1))
        {
            s = second;
        }
        curve = s * (6.0 * third + s * (12.0 * fourth + s * 20.0 * fifth));
        (*cspan_at(&gentle, INT64_C(0) + i)) = a + curve / square;
    }
}
static int64_t gentle_hold(double* result_0_0001, double* result_1, double level, array_double_1d problem, array_double_1d axis)
{
    double top;
    double hold;
    top = side_limit(INT64_C(2), level, axis);
    if (fabs(level) <= top)
    {
        (*result_0_0001) = level;
        (*result_1) = 0.0;
        return 0;
    }
    hold = 0.5 * (*cspan_at(&problem, INT64_C(5))) * (fabs(level) / top - 1.0);
    if (level < 0.0)
    {
        (*result_0_0001) = -top;
        (*result_1) = hold;
        return 0;
    }
    (*result_0_0001) = top;
    (*result_1) = hold;
    return 0;
}
static void gentle_ramps(array_double_1d problem, array_double_1d axis, array_double_1d gentle)
{
    double hold;
    double total;
    double a;
    int64_t i;
    double b;
    double held;
    double duration;
    double slope;
    hold = 0.0;
    total = 0.0;
    a = (*cspan_at(&problem, INT64_C(1)));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        b = (*cspan_at(&problem, INT64_C(3)));
        held = 0.0;
        if (i < INT64_C(2))
        {
            gentle_hold(&b, &held, (*cspan_at(&gentle, INT64_C(0) + i)), problem, axis);
        }
        segfmu_ramp_duration(&duration, &slope, fabs(b - a), axis);
        (*cspan_at(&gentle, INT64_C(4) + i)) = b;
        (*cspan_at(&gentle, INT64_C(7) + i)) = held;
        (*cspan_at(&gentle, INT64_C(10) + i)) = duration;
        total = total + duration;
        hold = hold + held;
        a = b;
    }
    (*cspan_at(&gentle, INT64_C(13))) = 0.0;
    if (total > 0.0)
    {
        (*cspan_at(&gentle, INT64_C(13))) = ((*cspan_at(&problem, INT64_C(5))) - hold) / total;
    }
}
static double gentle_errors(array_double_1d problem, array_double_1d axis, array_double_1d gentle)
{
    double v;
    double y;
    double a;
    int64_t i;
    double b;
    double held;
    double basis;
    double duration;
    double result;
    gentle_ramps(problem, axis, gentle);
    v = (*cspan_at(&problem, INT64_C(0)));
    y = 0.0;
    a = (*cspan_at(&problem, INT64_C(1)));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        b = (*cspan_at(&gentle, INT64_C(4) + i));
        held = (*cspan_at(&gentle, INT64_C(7) + i));
        basis = (*cspan_at(&gentle, INT64_C(10) + i));
        duration = basis * (*cspan_at(&gentle, INT64_C(13)));
        if (duration > 0.0)
        {
            y = y + ramp_distance(v, a, b, duration, basis, axis);
            v = v + 0.5 * (a + b) * duration;
        }
        y = y + (v + 0.5 * b * held) * held;
        v = v + b * held;
        a = b;
    }
    (*cspan_at(&gentle, INT64_C(14))) = v - (*cspan_at(&problem, INT64_C(2)));
    (*cspan_at(&gentle, INT64_C(15))) = (y - (*cspan_at(&problem, INT64_C(4)))) / (*cspan_at(&problem, INT64_C(5)));
    result = fabs((*cspan_at(&gentle, INT64_C(14)))) + fabs((*cspan_at(&gentle, INT64_C(15))));
    return result;
}
static double usual_speed(array_double_1d problem, array_double_1d axis)
{
    double duration;
    double speed;
    double result;
    duration = (*cspan_at(&problem, INT64_C(5)));
    speed = fabs((*cspan_at(&problem, INT64_C(0)))) + fabs((*cspan_at(&problem, INT64_C(2))));
    speed = speed + (fabs((*cspan_at(&problem, INT64_C(1)))) + fabs((*cspan_at(&problem, INT64_C(3))))) * duration;
    result = span_min(fastest_velocity(axis), speed + fabs((*cspan_at(&problem, INT64_C(4)))) / duration);
    return result;
}
static bool gentle_slopes(array_double_1d problem, array_double_1d axis, array_double_1d gentle)
{
    double gain;
    double excess;
    double change;
    int64_t i;
    double kept;
    gain = (*cspan_at(&gentle, INT64_C(14)));
    excess = (*cspan_at(&gentle, INT64_C(15)));
    change = 1e-07 * span_max(fabs((*cspan_at(&gentle, INT64_C(0)))), fabs((*cspan_at(&gentle, INT64_C(0) + INT64_C(1)))));
    if (change == 0.0)
    {
        return 0;
    }
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        kept = (*cspan_at(&gentle, INT64_C(0) + i));
        (*cspan_at(&gentle, INT64_C(0) + i)) = kept + change;
        gentle_errors(problem, axis, gentle);
        (*cspan_at(&gentle, INT64_C(0) + i)) = kept;
        (*cspan_at(&gentle, INT64_C(16) + i)) = ((*cspan_at(&gentle, INT64_C(14))) - gain) / change;
        (*cspan_at(&gentle, INT64_C(18) + i)) = ((*cspan_at(&gentle, INT64_C(15))) - excess) / change;
    }
    (*cspan_at(&gentle, INT64_C(14))) = gain;
    (*cspan_at(&gentle, INT64_C(15))) = excess;
    return 1;
}
static bool gentle_step(array_double_1d gentle)
{
    double gain;
    double excess;
    double g1;
    double g2;
    double e1;
    double e2;
    double determinant;
    gain = (*cspan_at(&gentle, INT64_C(14)));
    excess = (*cspan_at(&gentle, INT64_C(15)));
    g1 = (*cspan_at(&gentle, INT64_C(16)));
    g2 = (*cspan_at(&gentle, INT64_C(16) + INT64_C(1)));
    e1 = (*cspan_at(&gentle, INT64_C(18)));
    e2 = (*cspan_at(&gentle, INT64_C(18) + INT64_C(1)));
    determinant = g1 * e2 - g2 * e1;
    if (!(fabs(determinant) > 1e-09 * (fabs(g1 * e2) + fabs(g2 * e1))))
    {
        return 0;
    }
    (*cspan_at(&gentle, INT64_C(2))) = (g2 * excess - e2 * gain) / determinant;
    (*cspan_at(&gentle, INT64_C(2) + INT64_C(1))) = (e1 * gain - g1 * excess) / determinant;
    return 1;
}
static void spread_levels(int64_t attempt, array_double_1d gentle)
{
    double middle;
    double half;
    double factor;
    middle = 0.5 * ((*cspan_at(&gentle, INT64_C(0))) + (*cspan_at(&gentle, INT64_C(0) + INT64_C(1))));
    half = 0.5 * ((*cspan_at(&gentle, INT64_C(0))) - (*cspan_at(&gentle, INT64_C(0) + INT64_C(1))));
    factor = 1.5 * attempt + 1.0;
    if (span_floor_mod(attempt, INT64_C(2)) == INT64_C(0))
    {
        factor = -factor;
    }
    half = factor * half;
    (*cspan_at(&gentle, INT64_C(0))) = middle + half;
    (*cspan_at(&gentle, INT64_C(0) + INT64_C(1))) = middle - half;
}
static void take_levels(double share, array_double_1d gentle)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&gentle, INT64_C(0) + i)) = (*cspan_at(&gentle, INT64_C(0) + i)) + share * (*cspan_at(&gentle, INT64_C(2) + i));
    }
}
static bool solve_gentle(int64_t attempt, array_double_1d problem, array_double_1d axis, array_double_1d gentle)
{
    double error;
    double speed;
    double close;
    int64_t i;
    double share;
    double reached;
    int64_t j;
    polynomial_levels(problem, gentle);
    if (attempt > INT64_C(0))
    {
        spread_levels(attempt, gentle);
    }
    error = gentle_errors(problem, axis, gentle);
    speed = usual_speed(problem, axis);
    close = 0.0001 * speed;
    for (i = INT64_C(0); i < INT64_C(16); i += INT64_C(1))
    {
        if (((i == INT64_C(0)) || (error > close)) && (!gentle_slopes(problem, axis, gentle)))
        {
            return 0;
        }
        if (!gentle_step(gentle))
        {
            return 0;
        }
        share = 1.0;
        reached = error;
        for (j = INT64_C(0); j < INT64_C(4); j += INT64_C(1))
        {
            take_levels(share, gentle);
            reached = gentle_errors(problem, axis, gentle);
            if (reached < error)
            {
                break;
            }
            take_levels(-share, gentle);
            share = 0.5 * share;
        }
        if (!(reached < error))
        {
            error = gentle_errors(problem, axis, gentle);
            break;
        }
        error = reached;
        if (error <= 2e-15 * speed)
        {
            break;
        }
    }
    return error <= 1e-13 * speed;
}
static int64_t write_gentle(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_1d gentle)
{
    double a;
    int64_t i;
    double b;
    int64_t used;
    int64_t count;
    count = INT64_C(0);
    a = (*cspan_at(&problem, INT64_C(1)));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        b = (*cspan_at(&gentle, INT64_C(4) + i));
        used = append_change(phases, count, a, b, axis);
        if (used > count)
        {
            (*cspan_at(&phases, count, INT64_C(0))) = (*cspan_at(&phases, count, INT64_C(1))) * (*cspan_at(&gentle, INT64_C(13)));
        }
        count = append_hold(phases, used, b, (*cspan_at(&gentle, INT64_C(7) + i)));
        a = b;
    }
    return count;
}
static bool timed_gently(array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    array_double_1d gentle;
    array_double_2d phases;
    double target;
    double most;
    int64_t attempt;
    int64_t count;
    double duration;
    double y;
    double end;
    double lowest;
    double highest;
    double fastest;
    problem = span_row(&work, INT64_C(59));
    gentle = span_row(&work, INT64_C(100));
    phases = span_rows(&cell, INT64_C(0), INT64_C(33));
    target = (*cspan_at(&problem, INT64_C(5)));
    most = slowest_velocity(axis) * (1.0 + 1e-12);
    for (attempt = INT64_C(0); attempt < INT64_C(6); attempt += INT64_C(1))
    {
        if (!solve_gentle(attempt, problem, axis, gentle))
        {
            continue;
        }
        if ((*cspan_at(&gentle, INT64_C(13))) < 1.0)
        {
            return 0;
        }
        count = write_gentle(phases, problem, axis, gentle);
        count = fit_duration(phases, count, target);
        segfmu_measure_phases(&duration, &y, &end, &lowest, &highest, phases, count, (*cspan_at(&problem, INT64_C(0))), most, axis);
        if (is_beyond(lowest, highest, 1.0 + 1e-12, axis))
        {
            return 0;
        }
        fastest = span_max(-lowest, highest);
        if (fabs(end - (*cspan_at(&problem, INT64_C(2)))) > 1e-12 * fastest)
        {
            return 0;
        }
        if (fabs(y - (*cspan_at(&problem, INT64_C(4)))) > 1e-12 * fastest * target)
        {
            return 0;
        }
        (*cspan_at(&work, INT64_C(58), INT64_C(0))) = count;
        (*cspan_at(&work, INT64_C(58), INT64_C(2))) = 0.0;
        return 1;
    }
    return 0;
}
static bool timed_slower(double shortest, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    array_double_1d rest;
    double velocity;
    double backwards;
    double factor;
    double steepest;
    double lowest;
    int64_t attempt;
    double room;
    bool fits;
    array_double_1d nearest;
    int64_t below;
    int64_t above;
    problem = span_row(&work, INT64_C(59));
    rest = span_row(&work, INT64_C(60));
    velocity = (*cspan_at(&axis, INT64_C(2)));
    backwards = (*cspan_at(&axis, INT64_C(9)));
    factor = shortest / (*cspan_at(&problem, INT64_C(5)));
    factor = factor * factor;
    steepest = span_max((*cspan_at(&problem, INT64_C(1))), (*cspan_at(&problem, INT64_C(3))));
    lowest = span_min((*cspan_at(&problem, INT64_C(1))), (*cspan_at(&problem, INT64_C(3))));
    for (attempt = INT64_C(0); attempt < INT64_C(9); attempt += INT64_C(1))
    {
        room = (*cspan_at(&axis, INT64_C(3))) * factor * factor * (1.0 - 1e-12);
        fits = steepest <= room;
        room = (*cspan_at(&axis, INT64_C(9) + INT64_C(1))) * factor * factor * (1.0 - 1e-12);
        if (fits && (-lowest <= room) && (factor < 0.99))
        {
            (*cspan_at(&rest, INT64_C(0))) = (*cspan_at(&problem, INT64_C(0))) / factor;
            (*cspan_at(&rest, INT64_C(1))) = (*cspan_at(&problem, INT64_C(1))) / (factor * factor);
            (*cspan_at(&rest, INT64_C(2))) = (*cspan_at(&problem, INT64_C(2))) / factor;
            (*cspan_at(&rest, INT64_C(3))) = (*cspan_at(&problem, INT64_C(3))) / (factor * factor);
            (*cspan_at(&rest, INT64_C(4))) = (*cspan_at(&problem, INT64_C(4)));
            (*cspan_at(&rest, INT64_C(5))) = (*cspan_at(&problem, INT64_C(5))) * factor;
            (*cspan_at(&axis, INT64_C(2))) = velocity / factor;
            (*cspan_at(&axis, INT64_C(9))) = backwards / factor;
            clear_nearest(work);
            usual_cruise(rest, axis, cell, work);
            (*cspan_at(&axis, INT64_C(2))) = velocity;
            (*cspan_at(&axis, INT64_C(9))) = backwards;
            if (is_enclosed(work))
            {
                nearest = span_row(&work, INT64_C(58));
                below = (int64_t)((*cspan_at(&nearest, INT64_C(0))));
                above = (int64_t)((*cspan_at(&nearest, INT64_C(2))));
                stretch_phases(span_rows(&cell, INT64_C(0), INT64_C(33)), below, 1.0 / factor);
                stretch_phases(span_rows(&cell, INT64_C(33), INT64_C(66)), above, 1.0 / factor);
                return 1;
            }
        }
        factor = pow(factor, 0.75);
    }
    return 0;
}
static void surround_nearest(int64_t variant, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    array_double_1d nearest;
    array_double_2d below;
    array_double_2d above;
    int64_t count;
    problem = span_row(&work, INT64_C(59));
    nearest = span_row(&work, INT64_C(58));
    below = span_rows(&cell, INT64_C(0), INT64_C(33));
    above = span_rows(&cell, INT64_C(33), INT64_C(66));
    count = (int64_t)((*cspan_at(&nearest, INT64_C(0))));
    count = surround(below, count, variant, problem, axis, work);
    (*cspan_at(&nearest, INT64_C(0))) = fit_duration(below, count, (*cspan_at(&problem, INT64_C(5))));
    count = (int64_t)((*cspan_at(&nearest, INT64_C(2))));
    count = surround(above, count, variant, problem, axis, work);
    (*cspan_at(&nearest, INT64_C(2))) = fit_duration(above, count, (*cspan_at(&problem, INT64_C(5))));
}
static double timed_braked(array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    array_double_1d rest;
    int64_t variant;
    int64_t taken;
    double spent;
    double weight;
    problem = span_row(&work, INT64_C(59));
    rest = span_row(&work, INT64_C(60));
    for (variant = INT64_C(0); variant < INT64_C(4); variant += INT64_C(1))
    {
        braked(&taken, &spent, variant, problem, axis, work);
        if (taken == -INT64_C(3))
        {
            continue;
        }
        if (taken < INT64_C(0))
        {
            return -2.0;
        }
        if ((*cspan_at(&rest, INT64_C(5))) <= 0.0)
        {
            continue;
        }
        clear_nearest(work);
        timed_between(rest, axis, cell, work);
        if ((variant == INT64_C(0)) && (!is_enclosed(work)))
        {
            timed_loop(rest, axis, cell, work);
            note_known(work);
        }
        if (is_enclosed(work))
        {
            weight = nearest_weight(rest, axis, span_row(&work, INT64_C(58)));
            surround_nearest(variant, axis, cell, work);
            return weight;
        }
    }
    return -1.0;
}
static int64_t slowed_shortest(array_double_2d phases, array_double_1d problem, array_double_1d axis, array_double_2d work)
{
    int64_t count;
    int64_t result;
    count = segfmu_shortest_profile(problem, axis, phases, work);
    result = slower_form(count, phases, problem, axis, work);
    return result;
}
static double slower_passing(array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    array_double_2d phases;
    int64_t count;
    if ((*cspan_at(&axis, INT64_C(38))) < 0.5)
    {
        return -1.0;
    }
    problem = span_row(&work, INT64_C(59));
    phases = span_rows(&cell, INT64_C(0), INT64_C(33));
    count = INT64_C(0);
    if ((*cspan_at(&cell, INT64_C(67), INT64_C(6))) > 0.5)
    {
        count = slowed_shortest(phases, problem, axis, work);
        if ((count == INT64_C(0)) && ((*cspan_at(&axis, INT64_C(12))) > 0.5))
        {
            (*cspan_at(&axis, INT64_C(12))) = 0.0;
            count = slowed_shortest(phases, problem, axis, work);
            (*cspan_at(&axis, INT64_C(12))) = 1.0;
        }
    }
    if ((count == INT64_C(0)) && (!ramps_suffice(axis)))
    {
        count = plain_profile(problem, axis, phases, work);
        count = slower_form(count, phases, problem, axis, work);
    }
    if (count == INT64_C(0))
    {
        return -1.0;
    }
    count = fit_duration(phases, count, (*cspan_at(&problem, INT64_C(5))));
    (*cspan_at(&work, INT64_C(58), INT64_C(0))) = count;
    (*cspan_at(&work, INT64_C(58), INT64_C(2))) = 0.0;
    return 0.0;
}
static double between_extremes(array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    double result;
    problem = span_row(&work, INT64_C(59));
    if (!timed_extremes(axis, cell, work))
    {
        return -1.0;
    }
    if (!is_enclosed(work))
    {
        timed_between(problem, axis, cell, work);
        timed_loop(problem, axis, cell, work);
    }
    if (!is_enclosed(work))
    {
        return -1.0;
    }
    surround_nearest(INT64_C(0), axis, cell, work);
    result = nearest_weight(problem, axis, span_row(&work, INT64_C(58)));
    return result;
}
double segfmu_timed_profile(double target, array_double_1d axis, array_double_2d cell, array_double_2d work)
{
    array_double_1d problem;
    array_double_1d nearest;
    double shortest;
    double weight;
    problem = span_row(&work, INT64_C(59));
    nearest = span_row(&work, INT64_C(58));
    boundary_problem(span_row(&cell, INT64_C(66)), axis, problem);
    (*cspan_at(&problem, INT64_C(5))) = target;
    shortest = (*cspan_at(&cell, INT64_C(67), INT64_C(0)));
    if ((shortest > 0.0) && timed_gently(axis, cell, work))
    {
        return 0.0;
    }
    if ((shortest > 0.0) && timed_slower(shortest, axis, cell, work))
    {
        weight = nearest_weight(problem, axis, nearest);
        surround_nearest(INT64_C(0), axis, cell, work);
        return weight;
    }
    weight = timed_braked(axis, cell, work);
    if (weight < -1.5)
    {
        return -1.0;
    }
    if ((weight < 0.0) && ((*cspan_at(&axis, INT64_C(38))) > 0.5))
    {
        weight = slower_passing(axis, cell, work);
        if (weight < 0.0)
        {
            weight = between_extremes(axis, cell, work);
        }
        if (weight < 0.0)
        {
            weight = timed_dipped(axis, cell, work);
        }
    }
    return weight;
}
static int64_t set_shortest(int64_t* result_0, double* result_1_0001, array_double_2d cell, array_double_1d axis, array_double_2d work)
{
    array_double_1d problem;
    array_double_2d phases;
    int64_t count;
    problem = span_row(&cell, INT64_C(66));
    phases = span_rows(&cell, INT64_C(0), INT64_C(33));
    count = segfmu_shortest_profile(problem, axis, phases, work);
    (*cspan_at(&cell, INT64_C(67), INT64_C(3))) = span_max_int(count, INT64_C(0));
    (*cspan_at(&cell, INT64_C(67), INT64_C(4))) = 0.0;
    (*cspan_at(&cell, INT64_C(67), INT64_C(2))) = 0.0;
    if (count < INT64_C(0))
    {
        (*result_0) = count;
        (*result_1_0001) = 0.0;
        return 0;
    }
    (*result_0) = INT64_C(0);
    (*result_1_0001) = total_duration(phases, count);
    return 0;
}
static void set_stretched(double target, bool resting, array_double_2d cell, array_double_1d axis, array_double_2d work)
{
    array_double_2d phases;
    double shortest;
    double duration;
    int64_t i;
    int64_t status;
    int64_t count;
    phases = span_rows(&cell, INT64_C(0), INT64_C(33));
    shortest = (*cspan_at(&cell, INT64_C(67), INT64_C(0))) - (*cspan_at(&cell, INT64_C(68), INT64_C(2)));
    duration = 0.0;
    if ((*cspan_at(&cell, INT64_C(67), INT64_C(4))) == 0.0)
    {
        for (i = INT64_C(0); i < (int64_t)((*cspan_at(&cell, INT64_C(67), INT64_C(3)))); i += INT64_C(1))
        {
            duration = duration + (*cspan_at(&phases, i, INT64_C(0)));
        }
    }
    if ((duration == 0.0) || (fabs(duration - shortest) > 1e-13 * shortest))
    {
        set_shortest(&status, &duration, cell, axis, work);
    }
    count = (int64_t)((*cspan_at(&cell, INT64_C(67), INT64_C(3))));
    if (resting && (count == INT64_C(0)))
    {
        (*cspan_at(&cell, INT64_C(67), INT64_C(3))) = append_hold(phases, INT64_C(0), 0.0, target);
    }
    else if (resting)
    {
        stretch_phases(phases, count, target / duration);
    }
}
static bool set_duration(double target, array_double_2d cell, array_double_1d axis, array_double_2d work)
{
    double delay;
    double shortest;
    bool resting;
    double weight;
    delay = (*cspan_at(&cell, INT64_C(68), INT64_C(2)));
    shortest = (*cspan_at(&cell, INT64_C(67), INT64_C(0)));
    if (target < shortest * (1.0 - 1e-13))
    {
        return 0;
    }
    resting = is_resting(span_row(&cell, INT64_C(66)), axis);
    if (resting || (target <= shortest * (1.0 + 1e-13)))
    {
        set_stretched(target - delay, resting, cell, axis, work);
        return 1;
    }
    weight = segfmu_timed_profile(target - delay, axis, cell, work);
    if (weight < 0.0)
    {
        return 0;
    }
    (*cspan_at(&cell, INT64_C(67), INT64_C(2))) = weight;
    (*cspan_at(&cell, INT64_C(67), INT64_C(3))) = (*cspan_at(&work, INT64_C(58), INT64_C(0)));
    (*cspan_at(&cell, INT64_C(67), INT64_C(4))) = (*cspan_at(&work, INT64_C(58), INT64_C(2)));
    return 1;
}
static double first_feasible(double accuracy, double outside, double inside, array_double_2d cell, array_double_1d axis, array_double_2d work)
{
    double duration;
    int64_t i;
    duration = inside * (1.0 - 0.75 * accuracy);
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        if ((duration <= outside) || (inside - outside <= accuracy * inside))
        {
            break;
        }
        if (set_duration(duration, cell, axis, work))
        {
            inside = duration;
        }
        else
        {
            outside = duration;
        }
        duration = 0.5 * (outside + inside);
    }
    return inside;
}
static double earlier_feasible(double start, double end, array_double_2d cell, array_double_1d axis, array_double_2d work)
{
    double outside;
    int64_t i;
    double duration;
    double result;
    outside = start;
    if (start > 1.1 * (*cspan_at(&cell, INT64_C(67), INT64_C(0))))
    {
        return end;
    }
    for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
    {
        duration = start * (1.0 + 0.004 * pow(2.0, (double)(i)));
        if (duration > 0.98 * end)
        {
            break;
        }
        if (set_duration(duration, cell, axis, work))
        {
            result = first_feasible(0.0001, outside, duration, cell, axis, work);
            return result;
        }
        outside = duration;
    }
    return end;
}
static double next_feasible(double start, array_double_2d cell, array_double_1d axis, array_double_2d work)
{
    double after;
    double delay;
    double shortest;
    int64_t sweep;
    int64_t count;
    int64_t i;
    double duration;
    double growth;
    double result;
    after = start;
    delay = (*cspan_at(&cell, INT64_C(68), INT64_C(2)));
    shortest = (*cspan_at(&cell, INT64_C(67), INT64_C(0))) - delay;
    for (sweep = INT64_C(0); sweep < INT64_C(8); sweep += INT64_C(1))
    {
        count = gap_ends(after - delay, shortest, span_row(&cell, INT64_C(66)), axis, work);
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            duration = delay + (*cspan_at(&work, INT64_C(42) + i, INT64_C(0))) * (1.0 + 1e-09);
            if (set_duration(duration, cell, axis, work))
            {
                if (((*cspan_at(&axis, INT64_C(14))) < 0.5) || (!ramps_suffice(axis)))
                {
                    duration = first_feasible(4e-09, after, duration, cell, axis, work);
                }
                result = earlier_feasible(start, duration, cell, axis, work);
                return result;
            }
            after = duration;
        }
        if (count < INT64_C(58) - INT64_C(42))
        {
            break;
        }
    }
    growth = 1.005;
    for (i = INT64_C(0); i < INT64_C(600); i += INT64_C(1))
    {
        duration = after * growth;
        if (set_duration(duration, cell, axis, work))
        {
            result = first_feasible(4e-09, after, duration, cell, axis, work);
            return result;
        }
        after = duration;
        if (i > INT64_C(230))
        {
            growth = 1.02;
        }
        if (i > INT64_C(350))
        {
            growth = 1.1;
        }
    }
    return -1.0;
}
static double round_up(double duration, double sample_time)
{
    if (sample_time <= 0.0)
    {
        return duration;
    }
    return (int64_t)ceil(duration / sample_time - 1e-09) * sample_time;
}
static double common_duration(double start, double sample_time, int64_t first, int64_t last, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    int64_t i;
    int64_t place;
    int64_t agreed;
    array_double_2d cell;
    int64_t row;
    array_double_1d axis;
    double duration;
    duration = start;
    for (i = first; i < last; i += INT64_C(1))
    {
        duration = span_max(duration, (*cspan_at(&cells, i, INT64_C(67), INT64_C(0))));
    }
    duration = round_up(duration, sample_time);
    place = first;
    agreed = INT64_C(0);
    for (i = INT64_C(0); i < INT64_C(100000); i += INT64_C(1))
    {
        if (agreed == last - first)
        {
            return duration;
        }
        cell = span_matrix(&cells, place);
        row = span_floor_mod(place, axes.shape[INT64_C(0)]);
        axis = span_row(&axes, row);
        if (set_duration(duration, cell, axis, work))
        {
            agreed = agreed + INT64_C(1);
        }
        else
        {
            duration = next_feasible(duration, cell, axis, work);
            if (duration < 0.0)
            {
                return -1.0;
            }
            duration = round_up(duration, sample_time);
            agreed = INT64_C(0);
        }
        place = place + INT64_C(1);
        if (place == last)
        {
            place = first;
        }
    }
    return -1.0;
}
static void note_shortest(double time, array_double_1d axis, array_double_2d cell)
{
    int64_t count;
    bool passing;
    time = time + (*cspan_at(&cell, INT64_C(68), INT64_C(2)));
    (*cspan_at(&cell, INT64_C(67), INT64_C(0))) = time;
    (*cspan_at(&cell, INT64_C(67), INT64_C(1))) = time;
    count = (int64_t)((*cspan_at(&cell, INT64_C(67), INT64_C(3))));
    passing = is_passing(span_rows(&cell, INT64_C(0), INT64_C(33)), count, axis);
    (*cspan_at(&cell, INT64_C(67), INT64_C(6))) = passing;
}
static int64_t plan_with_share(int64_t axis, double share, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    array_double_1d report;
    int64_t missed;
    double slow;
    int64_t j;
    double time;
    double sign;
    int64_t status;
    report = span_row(&work, INT64_C(99));
    (*cspan_at(&report, INT64_C(0))) = axis;
    missed = INT64_C(0);
    slow = 0.0;
    if (!segfmu_ramp_parameters(share, span_row(&axes, axis), work))
    {
        return -INT64_C(9);
    }
    for (j = axis; (axes.shape[INT64_C(0)] > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += axes.shape[INT64_C(0)])
    {
        (*cspan_at(&report, INT64_C(1))) = span_floor_div(j, axes.shape[INT64_C(0)]);
        set_shortest(&status, &time, span_matrix(&cells, j), span_row(&axes, axis), work);
        if (status < INT64_C(0))
        {
            (*cspan_at(&report, INT64_C(2))) = (*cspan_at(&cells, j, INT64_C(66), INT64_C(1)));
            sign = (*cspan_at(&report, INT64_C(2)));
            if (status == -INT64_C(2))
            {
                (*cspan_at(&report, INT64_C(2))) = (*cspan_at(&cells, j, INT64_C(66), INT64_C(3)));
                sign = -(*cspan_at(&report, INT64_C(2)));
            }
            (*cspan_at(&report, INT64_C(3))) = side_limit(INT64_C(1), sign, span_row(&axes, axis));
            (*cspan_at(&report, INT64_C(4))) = own_side(INT64_C(1), sign, span_row(&axes, axis));
            return status;
        }
        missed = span_max_int(missed, (int64_t)((*cspan_at(&work, INT64_C(98), INT64_C(20)))));
        slow = span_max(slow, (*cspan_at(&work, INT64_C(98), INT64_C(21))));
        note_shortest(time, span_row(&axes, axis), span_matrix(&cells, j));
    }
    (*cspan_at(&work, INT64_C(98), INT64_C(20))) = missed;
    (*cspan_at(&work, INT64_C(98), INT64_C(21))) = slow;
    return INT64_C(0);
}
static double axis_duration(int64_t axis, array_double_2d axes, array_double_3d cells)
{
    int64_t j;
    double total;
    total = 0.0;
    for (j = axis; (axes.shape[INT64_C(0)] > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += axes.shape[INT64_C(0)])
    {
        total = total + (*cspan_at(&cells, j, INT64_C(67), INT64_C(0)));
    }
    return total;
}
static void keep_shortest(int64_t axis, array_double_2d axes, array_double_3d cells)
{
    int64_t j;
    array_double_2d cell;
    int64_t count;
    for (j = axis; (axes.shape[INT64_C(0)] > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += axes.shape[INT64_C(0)])
    {
        cell = span_matrix(&cells, j);
        count = (int64_t)((*cspan_at(&cell, INT64_C(67), INT64_C(3))));
        copy_phases(span_rows(&cell, INT64_C(0), INT64_C(33)), span_rows(&cell, INT64_C(33), INT64_C(66)), count);
        (*cspan_at(&cell, INT64_C(67), INT64_C(5))) = count;
    }
}
static void restore_shortest(int64_t axis, array_double_2d axes, array_double_3d cells)
{
    int64_t j;
    array_double_2d cell;
    array_double_2d phases;
    int64_t count;
    for (j = axis; (axes.shape[INT64_C(0)] > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += axes.shape[INT64_C(0)])
    {
        cell = span_matrix(&cells, j);
        phases = span_rows(&cell, INT64_C(0), INT64_C(33));
        count = (int64_t)((*cspan_at(&cell, INT64_C(67), INT64_C(5))));
        copy_phases(span_rows(&cell, INT64_C(33), INT64_C(66)), phases, count);
        (*cspan_at(&cell, INT64_C(67), INT64_C(3))) = count;
        note_shortest(total_duration(phases, count), span_row(&axes, axis), cell);
    }
}
static double smoothness_share(double usual, double share)
{
    return 0.999 * sqrt((1.0 - usual) / (1.0 - share));
}
static bool shorter_with(double share, double kept, double factor, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    double longest;
    int64_t status;
    longest = factor * axis_duration(axis, axes, cells);
    keep_shortest(axis, axes, cells);
    status = plan_with_share(axis, share, axes, cells, work);
    if ((status == INT64_C(0)) && (axis_duration(axis, axes, cells) < longest))
    {
        return 1;
    }
    segfmu_ramp_parameters(kept, span_row(&axes, axis), work);
    restore_shortest(axis, axes, cells);
    return 0;
}
static double plan_steeper(int64_t missed, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    double factor;
    double share;
    share = usual_share(span_row(&axes, axis));
    if (snap_is_last(span_row(&axes, axis)))
    {
        factor = smoothness_share(share, moderate_share());
        if (shorter_with(moderate_share(), share, factor, axis, axes, cells, work))
        {
            share = moderate_share();
        }
        missed = span_min_int(missed, (int64_t)((*cspan_at(&work, INT64_C(98), INT64_C(20)))));
    }
    if (missed == INT64_C(2))
    {
        factor = smoothness_share(share, steepest_share());
        if (shorter_with(steepest_share(), share, factor, axis, axes, cells, work))
        {
            share = steepest_share();
        }
    }
    return share;
}
static void plan_thoroughly(double share, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    (*cspan_at(&axes, axis, INT64_C(12))) = 1.0;
    if (!shorter_with(share, share, 1.0 - 1e-09, axis, axes, cells, work))
    {
        (*cspan_at(&axes, axis, INT64_C(12))) = 0.0;
    }
}
static int64_t plan_refused(int64_t* result_0, double* result_1, int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    double share;
    int64_t status;
    double factor;
    share = moderate_share();
    status = plan_with_share(axis, share, axes, cells, work);
    if (status != INT64_C(0))
    {
        (*result_0) = plan_with_share(axis, steepest_share(), axes, cells, work);
        (*result_1) = steepest_share();
        return 0;
    }
    factor = smoothness_share(share, steepest_share());
    if (shorter_with(steepest_share(), share, factor, axis, axes, cells, work))
    {
        share = steepest_share();
    }
    (*result_0) = status;
    (*result_1) = share;
    return 0;
}
static int64_t plan_axis(int64_t axis, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    double share;
    int64_t missed;
    int64_t status;
    share = usual_share(span_row(&axes, axis));
    status = plan_with_share(axis, share, axes, cells, work);
    missed = (int64_t)((*cspan_at(&work, INT64_C(98), INT64_C(20))));
    if ((*cspan_at(&axes, axis, INT64_C(14))) < 0.5)
    {
        return status;
    }
    if ((status == -INT64_C(1)) || (status == -INT64_C(2)))
    {
        plan_refused(&status, &share, axis, axes, cells, work);
    }
    else if ((status == INT64_C(0)) && (missed > INT64_C(0)))
    {
        share = plan_steeper(missed, axis, axes, cells, work);
    }
    if ((status == INT64_C(0)) && ((*cspan_at(&work, INT64_C(98), INT64_C(21))) > 0.5))
    {
        plan_thoroughly(share, axis, axes, cells, work);
    }
    return status;
}
static int64_t check_waypoints(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_1d report)
{
    int64_t j;
    int64_t i;
    double velocity;
    double acceleration;
    bool moving;
    for (j = INT64_C(0); j < states.shape[INT64_C(0)]; j += INT64_C(1))
    {
        for (i = INT64_C(0); i < axes.shape[INT64_C(0)]; i += INT64_C(1))
        {
            velocity = (*cspan_at(&states, j, i, INT64_C(1)));
            acceleration = (*cspan_at(&states, j, i, INT64_C(2)));
            (*cspan_at(&report, INT64_C(0))) = i;
            (*cspan_at(&report, INT64_C(1))) = j;
            (*cspan_at(&report, INT64_C(2))) = velocity;
            (*cspan_at(&report, INT64_C(3))) = side_limit(INT64_C(1), velocity, span_row(&axes, i));
            (*cspan_at(&report, INT64_C(4))) = own_side(INT64_C(1), velocity, span_row(&axes, i));
            if (fabs(velocity) > (*cspan_at(&report, INT64_C(3))) * (1.0 + 1e-12))
            {
                return -INT64_C(7);
            }
            moving = (velocity != 0.0) || (acceleration != 0.0);
            if (((*cspan_at(&dwells, j)) > 0.0) && moving)
            {
                return -INT64_C(10);
            }
            (*cspan_at(&report, INT64_C(2))) = acceleration;
            (*cspan_at(&report, INT64_C(3))) = side_limit(INT64_C(2), acceleration, span_row(&axes, i));
            (*cspan_at(&report, INT64_C(4))) = own_side(INT64_C(2), acceleration, span_row(&axes, i));
            if (fabs(acceleration) > (*cspan_at(&report, INT64_C(3))) * (1.0 + 1e-12))
            {
                return -INT64_C(8);
            }
        }
    }
    return INT64_C(0);
}
static int64_t time_left(double* result_0, double* result_1, int64_t* result_2, int64_t first, int64_t step, double target, array_double_3d cells)
{
    double rest;
    double base;
    int64_t count;
    int64_t j;
    rest = target;
    base = 0.0;
    count = INT64_C(0);
    for (j = first; (step > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += step)
    {
        rest = rest - (*cspan_at(&cells, j, INT64_C(67), INT64_C(1)));
        if ((*cspan_at(&cells, j, INT64_C(68), INT64_C(4))) > 0.5)
        {
            base = base + (*cspan_at(&cells, j, INT64_C(67), INT64_C(1)));
            count = count + INT64_C(1);
        }
    }
    (*result_0) = rest;
    (*result_1) = base;
    (*result_2) = count;
    return 0;
}
static bool prolong_all(int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    int64_t step;
    int64_t j;
    int64_t sweep;
    double rest;
    double base;
    int64_t count;
    double factor;
    double extra;
    double present;
    int64_t end;
    double reached;
    int64_t i;
    step = axes.shape[INT64_C(0)];
    for (j = first; (step > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += step)
    {
        (*cspan_at(&cells, j, INT64_C(68), INT64_C(4))) = 1.0;
    }
    for (sweep = INT64_C(0); sweep < INT64_C(50); sweep += INT64_C(1))
    {
        time_left(&rest, &base, &count, first, step, target, cells);
        if (rest <= 1e-13 * target)
        {
            return 1;
        }
        if (count == INT64_C(0))
        {
            return 0;
        }
        factor = 1.0;
        extra = rest / count;
        if (base > 0.0)
        {
            factor = 1.0 + rest / base;
            extra = 0.0;
        }
        for (j = first; (step > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += step)
        {
            if ((*cspan_at(&cells, j, INT64_C(68), INT64_C(4))) > 0.5)
            {
                present = (*cspan_at(&cells, j, INT64_C(67), INT64_C(1)));
                end = j + last - first;
                reached = common_duration(present * factor + extra, 0.0, j, end, axes, cells, work);
                if ((reached < 0.0) || (reached - present > rest * (1.0 + 1e-13)))
                {
                    (*cspan_at(&cells, j, INT64_C(68), INT64_C(4))) = 0.0;
                }
                else
                {
                    rest = rest - (reached - present);
                    for (i = j; i < end; i += INT64_C(1))
                    {
                        (*cspan_at(&cells, i, INT64_C(67), INT64_C(1))) = reached;
                    }
                }
            }
        }
    }
    return 0;
}
static bool prolong_from(int64_t begin, double share, int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    int64_t step;
    int64_t intervals;
    int64_t k;
    double rest;
    double base;
    int64_t count;
    int64_t j;
    double present;
    double reached;
    int64_t i;
    step = axes.shape[INT64_C(0)];
    intervals = span_floor_div(cells.shape[INT64_C(0)], step);
    for (k = INT64_C(0); k < intervals; k += INT64_C(1))
    {
        time_left(&rest, &base, &count, first, step, target, cells);
        j = first + span_floor_mod((begin - first + k * step), (intervals * step));
        present = (*cspan_at(&cells, j, INT64_C(67), INT64_C(1)));
        reached = common_duration(present + share * rest, 0.0, j, j + last - first, axes, cells, work);
        if ((reached >= 0.0) && (reached - present <= rest * (1.0 + 1e-13)))
        {
            for (i = j; i < j + last - first; i += INT64_C(1))
            {
                (*cspan_at(&cells, i, INT64_C(67), INT64_C(1))) = reached;
            }
        }
        share = 1.0;
    }
    time_left(&rest, &base, &count, first, step, target, cells);
    return rest <= 1e-13 * target;
}
static bool distribute(int64_t first, int64_t last, double target, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    int64_t step;
    int64_t i;
    int64_t quarters;
    int64_t j;
    double share;
    step = axes.shape[INT64_C(0)];
    for (i = INT64_C(0); i < cells.shape[INT64_C(0)]; i += INT64_C(1))
    {
        (*cspan_at(&cells, i, INT64_C(68), INT64_C(3))) = (*cspan_at(&cells, i, INT64_C(67), INT64_C(1)));
    }
    if (prolong_all(first, last, target, axes, cells, work))
    {
        return 1;
    }
    for (quarters = INT64_C(0); quarters < INT64_C(4); quarters += INT64_C(1))
    {
        for (j = first; (step > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += step)
        {
            for (i = INT64_C(0); i < cells.shape[INT64_C(0)]; i += INT64_C(1))
            {
                (*cspan_at(&cells, i, INT64_C(67), INT64_C(1))) = (*cspan_at(&cells, i, INT64_C(68), INT64_C(3)));
            }
            share = 1.0 - 0.25 * quarters;
            if (prolong_from(j, share, first, last, target, axes, cells, work))
            {
                return 1;
            }
        }
    }
    return 0;
}
static bool rewrite_intervals(int64_t first, int64_t last, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    int64_t j;
    int64_t i;
    double duration;
    for (j = INT64_C(0); (axes.shape[INT64_C(0)] > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += axes.shape[INT64_C(0)])
    {
        for (i = first; i < last; i += INT64_C(1))
        {
            duration = (*cspan_at(&cells, j + i, INT64_C(67), INT64_C(1)));
            if (!set_duration(duration, span_matrix(&cells, j + i), span_row(&axes, i), work))
            {
                return 0;
            }
        }
    }
    return 1;
}
static void set_problems(array_double_3d states, array_double_3d cells)
{
    int64_t axes;
    int64_t j;
    int64_t i;
    array_double_2d cell;
    axes = states.shape[INT64_C(1)];
    for (j = INT64_C(0); j < states.shape[INT64_C(0)] - INT64_C(1); j += INT64_C(1))
    {
        for (i = INT64_C(0); i < axes; i += INT64_C(1))
        {
            cell = span_matrix(&cells, j * axes + i);
            (*cspan_at(&cell, INT64_C(66), INT64_C(0))) = (*cspan_at(&states, j, i, INT64_C(1)));
            (*cspan_at(&cell, INT64_C(66), INT64_C(1))) = (*cspan_at(&states, j, i, INT64_C(2)));
            (*cspan_at(&cell, INT64_C(66), INT64_C(2))) = (*cspan_at(&states, j + INT64_C(1), i, INT64_C(1)));
            (*cspan_at(&cell, INT64_C(66), INT64_C(3))) = (*cspan_at(&states, j + INT64_C(1), i, INT64_C(2)));
            (*cspan_at(&cell, INT64_C(66), INT64_C(4))) = (*cspan_at(&states, j + INT64_C(1), i, INT64_C(0))) - (*cspan_at(&states, j, i, INT64_C(0)));
            (*cspan_at(&cell, INT64_C(66), INT64_C(5))) = 0.0;
            (*cspan_at(&cell, INT64_C(68), INT64_C(2))) = 0.0;
            if ((j == INT64_C(0)) && (states.shape[INT64_C(2)] > INT64_C(3)))
            {
                (*cspan_at(&cell, INT64_C(68), INT64_C(2))) = (*cspan_at(&states, j, i, INT64_C(3)));
            }
        }
    }
}
static double meet_intervals(int64_t first, int64_t last, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    double sample_time;
    bool meeting;
    int64_t j;
    int64_t end;
    double longest;
    int64_t i;
    double time;
    double total;
    sample_time = (*cspan_at(&options, INT64_C(3)));
    meeting = (int64_t)((*cspan_at(&options, INT64_C(2)))) == INT64_C(1);
    total = 0.0;
    for (j = first; (axes.shape[INT64_C(0)] > 0) ? (j < cells.shape[INT64_C(0)]) : (j > cells.shape[INT64_C(0)]); j += axes.shape[INT64_C(0)])
    {
        if (meeting || (sample_time > 0.0))
        {
            end = j + last - first;
            longest = 0.0;
            for (i = j; i < end; i += INT64_C(1))
            {
                longest = span_max(longest, (*cspan_at(&cells, i, INT64_C(67), INT64_C(1))));
            }
            time = common_duration(longest, sample_time, j, end, axes, cells, work);
            (*cspan_at(&work, INT64_C(99), INT64_C(0))) = first;
            (*cspan_at(&work, INT64_C(99), INT64_C(1))) = span_floor_div(j, axes.shape[INT64_C(0)]);
            if (time < 0.0)
            {
                return -1.0;
            }
            for (i = j; i < end; i += INT64_C(1))
            {
                (*cspan_at(&cells, i, INT64_C(67), INT64_C(1))) = time;
            }
        }
        total = total + (*cspan_at(&cells, j, INT64_C(67), INT64_C(1)));
    }
    return total;
}
static int64_t synchronize_plan(array_double_1d dwells, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    array_double_1d report;
    int64_t synchronization;
    double duration;
    int64_t group;
    double resting;
    int64_t j;
    double longest;
    int64_t axis;
    double total;
    double target;
    report = span_row(&work, INT64_C(99));
    synchronization = (int64_t)((*cspan_at(&options, INT64_C(2))));
    duration = (*cspan_at(&options, INT64_C(4)));
    group = INT64_C(1);
    if (synchronization == INT64_C(1))
    {
        group = axes.shape[INT64_C(0)];
    }
    resting = 0.0;
    for (j = INT64_C(0); j < dwells.shape[INT64_C(0)]; j += INT64_C(1))
    {
        resting = resting + (*cspan_at(&dwells, j));
    }
    longest = 0.0;
    for (axis = INT64_C(0); (group > 0) ? (axis < axes.shape[INT64_C(0)]) : (axis > axes.shape[INT64_C(0)]); axis += group)
    {
        total = meet_intervals(axis, axis + group, options, axes, cells, work);
        if (total < 0.0)
        {
            return -INT64_C(4);
        }
        longest = span_max(longest, total);
    }
    (*cspan_at(&report, INT64_C(2))) = longest + resting;
    (*cspan_at(&report, INT64_C(3))) = duration;
    target = longest;
    if (duration > 0.0)
    {
        target = duration - resting;
        if (target < longest * (1.0 - 1e-13))
        {
            return -INT64_C(5);
        }
    }
    if ((synchronization != INT64_C(2)) && (duration <= 0.0))
    {
        return INT64_C(0);
    }
    (*cspan_at(&report, INT64_C(2))) = target + resting;
    for (axis = INT64_C(0); (group > 0) ? (axis < axes.shape[INT64_C(0)]) : (axis > axes.shape[INT64_C(0)]); axis += group)
    {
        (*cspan_at(&report, INT64_C(0))) = axis;
        if (!distribute(axis, axis + group, target, axes, cells, work))
        {
            return -INT64_C(6);
        }
        if (!rewrite_intervals(axis, axis + group, axes, cells, work))
        {
            return -INT64_C(6);
        }
    }
    return INT64_C(0);
}
int64_t segfmu_plan_phases(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_1d options, array_double_2d axes, array_double_3d cells, array_double_2d work)
{
    array_double_1d report;
    int64_t smoothness;
    int64_t shape;
    int64_t axis;
    int64_t status;
    report = span_row(&work, INT64_C(99));
    (*cspan_at(&report, INT64_C(2))) = (*cspan_at(&options, INT64_C(3)));
    if (((*cspan_at(&report, INT64_C(2))) > 0.0) && (!((1e-09 <= (*cspan_at(&report, INT64_C(2)))) && ((*cspan_at(&report, INT64_C(2))) <= 1000000.0))))
    {
        return -INT64_C(16);
    }
    smoothness = (int64_t)((*cspan_at(&options, INT64_C(0))));
    shape = (int64_t)((*cspan_at(&options, INT64_C(1))));
    for (axis = INT64_C(0); axis < axes.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        segfmu_axis_limits(smoothness, shape, span_row(&limits, axis), span_row(&axes, axis));
        set_lower(span_row(&lower, axis), span_row(&axes, axis));
    }
    status = check_waypoints(states, dwells, axes, report);
    if (status < INT64_C(0))
    {
        return status;
    }
    set_problems(states, cells);
    for (axis = INT64_C(0); axis < axes.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        status = plan_axis(axis, axes, cells, work);
        if (status < INT64_C(0))
        {
            return status;
        }
    }
    status = synchronize_plan(dwells, options, axes, cells, work);
    return status;
}
int64_t segfmu_count_pieces(array_double_2d axes, array_double_3d cells)
{
    int64_t each;
    int64_t i;
    double phases;
    int64_t total;
    total = INT64_C(810) + axes.shape[INT64_C(0)] + cells.shape[INT64_C(0)];
    each = segfmu_ramp_pieces(span_row(&axes, INT64_C(0)));
    for (i = INT64_C(0); i < cells.shape[INT64_C(0)]; i += INT64_C(1))
    {
        phases = (*cspan_at(&cells, i, INT64_C(67), INT64_C(3)));
        phases = phases + (*cspan_at(&cells, i, INT64_C(67), INT64_C(4)));
        total = total + each * (int64_t)(phases);
    }
    return total;
}
static void shift_piece(array_double_2d coefficients, int64_t source, double t, double weight, int64_t target)
{
    int64_t width;
    double factorial;
    int64_t i;
    double value;
    width = coefficients.shape[INT64_C(1)];
    factorial = 1.0;
    for (i = INT64_C(0); i < width; i += INT64_C(1))
    {
        if (i > INT64_C(0))
        {
            factorial = factorial * i;
        }
        value = evaluate_piece(coefficients, source, width, t, i) / factorial;
        (*cspan_at(&coefficients, target, i)) = (*cspan_at(&coefficients, target, i)) + weight * value;
    }
}
static int64_t merge_pieces(double weight, double now, int64_t middle, int64_t last, array_double_2d timing, array_double_2d coefficients, int64_t row)
{
    int64_t a;
    int64_t b;
    double t;
    double t_a;
    double t_b;
    double rest_a;
    double rest_b;
    double step;
    a = timing.shape[INT64_C(0)] - INT64_C(810);
    b = middle;
    t = now;
    t_a = 0.0;
    t_b = 0.0;
    while((a < middle) && (b < last))
    {
        clear_piece(coefficients, row);
        shift_piece(coefficients, a, t_a, 1.0 - weight, row);
        shift_piece(coefficients, b, t_b, weight, row);
        rest_a = (*cspan_at(&timing, a, INT64_C(1))) - t_a;
        rest_b = (*cspan_at(&timing, b, INT64_C(1))) - t_b;
        step = span_min(rest_a, rest_b);
        (*cspan_at(&timing, row, INT64_C(0))) = t;
        (*cspan_at(&timing, row, INT64_C(1))) = step;
        t = t + step;
        t_a = t_a + step;
        t_b = t_b + step;
        row = row + INT64_C(1);
        if (rest_a <= step)
        {
            a = a + INT64_C(1);
            t_a = 0.0;
        }
        if (rest_b <= step)
        {
            b = b + INT64_C(1);
            t_b = 0.0;
        }
    }
    return row;
}
static int64_t expand_profile(array_double_2d cell, bool second, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work)
{
    array_double_1d state;
    int64_t count;
    int64_t result;
    state = span_row(&work, INT64_C(1));
    (*cspan_at(&state, INT64_C(0))) = (*cspan_at(&cell, INT64_C(68), INT64_C(0)));
    (*cspan_at(&state, INT64_C(1))) = (*cspan_at(&cell, INT64_C(66), INT64_C(0)));
    (*cspan_at(&state, INT64_C(2))) = (*cspan_at(&cell, INT64_C(66), INT64_C(1)));
    (*cspan_at(&state, INT64_C(3))) = 0.0;
    (*cspan_at(&state, INT64_C(8))) = (*cspan_at(&cell, INT64_C(68), INT64_C(1)));
    if (second)
    {
        count = (int64_t)((*cspan_at(&cell, INT64_C(67), INT64_C(4))));
        result = segfmu_expand_phases(span_rows(&cell, INT64_C(33), INT64_C(66)), count, axis, timing, coefficients, row, work);
        return result;
    }
    count = (int64_t)((*cspan_at(&cell, INT64_C(67), INT64_C(3))));
    result = segfmu_expand_phases(span_rows(&cell, INT64_C(0), INT64_C(33)), count, axis, timing, coefficients, row, work);
    return result;
}
static int64_t expand_cell(array_double_2d cell, array_double_1d axis, array_double_2d timing, array_double_2d coefficients, int64_t row, array_double_2d work)
{
    double weight;
    int64_t spare;
    int64_t middle;
    int64_t last;
    double now;
    int64_t result;
    weight = (*cspan_at(&cell, INT64_C(67), INT64_C(2)));
    if ((weight <= 0.0) || (weight >= 1.0))
    {
        result = expand_profile(cell, weight >= 1.0, axis, timing, coefficients, row, work);
        return result;
    }
    spare = timing.shape[INT64_C(0)] - INT64_C(810);
    middle = expand_profile(cell, 0, axis, timing, coefficients, spare, work);
    last = expand_profile(cell, 1, axis, timing, coefficients, middle, work);
    now = (*cspan_at(&cell, INT64_C(68), INT64_C(1)));
    result = merge_pieces(weight, now, middle, last, timing, coefficients, row);
    return result;
}
int64_t segfmu_expand_plan(array_double_3d states, array_double_1d dwells, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work)
{
    int64_t points;
    int64_t count;
    int64_t axis;
    double now;
    int64_t j;
    double a;
    array_double_2d cell;
    int64_t row;
    points = states.shape[INT64_C(0)];
    count = axes.shape[INT64_C(0)];
    row = INT64_C(0);
    for (axis = INT64_C(0); axis < count; axis += INT64_C(1))
    {
        (*cspan_at(&offsets, axis)) = row;
        now = 0.0;
        for (j = INT64_C(0); j < points; j += INT64_C(1))
        {
            (*cspan_at(&times, j, axis)) = now;
            if (((*cspan_at(&dwells, j)) > 0.0) || ((j == points - INT64_C(1)) && (row == (*cspan_at(&offsets, axis)))))
            {
                clear_piece(coefficients, row);
                a = (*cspan_at(&states, j, axis, INT64_C(2)));
                (*cspan_at(&coefficients, row, INT64_C(0))) = (*cspan_at(&states, j, axis, INT64_C(0)));
                (*cspan_at(&coefficients, row, INT64_C(1))) = (*cspan_at(&states, j, axis, INT64_C(1)));
                (*cspan_at(&coefficients, row, INT64_C(2))) = 0.5 * a;
                (*cspan_at(&timing, row, INT64_C(0))) = now;
                (*cspan_at(&timing, row, INT64_C(1))) = (*cspan_at(&dwells, j));
                now = now + (*cspan_at(&dwells, j));
                row = row + INT64_C(1);
            }
            if (j < points - INT64_C(1))
            {
                cell = span_matrix(&cells, j * count + axis);
                (*cspan_at(&cell, INT64_C(68), INT64_C(0))) = (*cspan_at(&states, j, axis, INT64_C(0)));
                (*cspan_at(&cell, INT64_C(68), INT64_C(1))) = now + (*cspan_at(&cell, INT64_C(68), INT64_C(2)));
                row = expand_cell(cell, span_row(&axes, axis), timing, coefficients, row, work);
                now = now + (*cspan_at(&cell, INT64_C(67), INT64_C(1)));
            }
        }
        (*cspan_at(&times, points, axis)) = now;
    }
    (*cspan_at(&offsets, count)) = row;
    return row;
}
static void set_place(array_double_2d operation, array_double_3d states)
{
    int64_t axis;
    int64_t i;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < states.shape[INT64_C(2)]; i += INT64_C(1))
        {
            (*cspan_at(&states, INT64_C(1), axis, i)) = 0.0;
        }
        (*cspan_at(&states, INT64_C(1), axis, INT64_C(0))) = (*cspan_at(&operation, INT64_C(1), INT64_C(1) + axis));
    }
}
static void set_ends(array_double_2d operation, array_double_3d states)
{
    int64_t axis;
    int64_t i;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < states.shape[INT64_C(2)]; i += INT64_C(1))
        {
            (*cspan_at(&states, INT64_C(0), axis, i)) = 0.0;
        }
        for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
        {
            (*cspan_at(&states, INT64_C(0), axis, i)) = (*cspan_at(&operation, INT64_C(20) + axis, i));
        }
    }
    set_place(operation, states);
}
static void set_options(array_double_2d known, array_double_2d work)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(85), i)) = (*cspan_at(&known, INT64_C(4), i));
    }
    (*cspan_at(&work, INT64_C(85), INT64_C(3))) = 0.0;
    (*cspan_at(&work, INT64_C(85), INT64_C(4))) = 0.0;
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        (*cspan_at(&work, INT64_C(84), i)) = 0.0;
    }
}
static bool is_too_fast(array_double_2d operation, array_double_2d limits)
{
    int64_t axis;
    double velocity;
    double slowed;
    bool faster;
    faster = 0;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        velocity = (*cspan_at(&operation, INT64_C(13) + axis, INT64_C(1)));
        slowed = limited_velocity(velocity, 1.0, (*cspan_at(&limits, axis, INT64_C(0))), (*cspan_at(&operation, INT64_C(17) + axis, INT64_C(0))));
        (*cspan_at(&operation, INT64_C(16), axis)) = slowed;
        (*cspan_at(&operation, INT64_C(12), axis)) = 1.0;
        if (fabs(velocity - slowed) > 1e-09 * (*cspan_at(&limits, axis, INT64_C(0))))
        {
            faster = 1;
        }
    }
    return faster;
}
static bool lead_to_target(array_double_2d operation, array_double_2d limits, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_2d lead, array_double_2d work)
{
    array_double_1d options;
    double meeting;
    bool result;
    options = span_row(&work, INT64_C(85));
    meeting = 0.0;
    if ((int64_t)((*cspan_at(&options, INT64_C(2)))) == INT64_C(0))
    {
        meeting = -1.0;
    }
    set_motion(operation, states);
    set_place(operation, states);
    set_lead(INT64_C(2), (int64_t)((*cspan_at(&options, INT64_C(1)))), meeting, lead);
    result = lead_between(INT64_C(1), INT64_C(2), span_rows(&operation, INT64_C(20), INT64_C(23)), limits, span_rows(&operation, INT64_C(17), INT64_C(20)), timing, coefficients, offsets, states, lead);
    return result;
}
static bool plan_target(array_double_2d limits, array_double_2d lower, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work)
{
    array_double_1d dwells;
    array_double_2d axes;
    int64_t status;
    int64_t place;
    dwells = span_row(&work, INT64_C(84));
    axes = span_rows(&work, INT64_C(86), INT64_C(89));
    status = segfmu_plan_phases(states, dwells, limits, lower, span_row(&work, INT64_C(85)), axes, cells, span_rows(&lead, INT64_C(61), INT64_C(301)));
    if ((status < INT64_C(0)) || (segfmu_count_pieces(axes, cells) > timing.shape[INT64_C(1)]))
    {
        return 0;
    }
    place = INT64_C(3) * INT64_C(4);
    segfmu_expand_plan(states, dwells, axes, cells, span_matrix(&timing, INT64_C(3)), span_matrix(&coefficients, INT64_C(3)), span_part(&offsets, place, place + INT64_C(4)), span_rows(&work, INT64_C(81), INT64_C(84)), span_rows(&lead, INT64_C(301), INT64_C(305)));
    return 1;
}
static void join_behind(array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    int64_t leads;
    int64_t behind;
    int64_t tried;
    leads = INT64_C(2) * INT64_C(4);
    behind = INT64_C(3) * INT64_C(4);
    tried = INT64_C(4) * INT64_C(4);
    segfmu_join_plans(span_matrix(&timing, INT64_C(2)), span_matrix(&coefficients, INT64_C(2)), span_part(&offsets, leads, leads + INT64_C(4)), span_matrix(&timing, INT64_C(3)), span_matrix(&coefficients, INT64_C(3)), span_part(&offsets, behind, behind + INT64_C(4)), span_matrix(&timing, INT64_C(4)), span_matrix(&coefficients, INT64_C(4)), span_part(&offsets, tried, tried + INT64_C(4)));
}
static bool seek_target(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work)
{
    bool found;
    int64_t rows;
    int64_t axis;
    int64_t i;
    set_options(known, work);
    found = 0;
    if (is_too_fast(operation, span_matrix(&limits, INT64_C(1))))
    {
        set_lower_of(INT64_C(0), operation, limits, known);
        found = reach_velocities(operation, span_matrix(&limits, INT64_C(0)), timing, coefficients, offsets, states, lead);
        set_lower_of(INT64_C(1), operation, limits, known);
    }
    else
    {
        found = lead_to_target(operation, span_matrix(&limits, INT64_C(1)), timing, coefficients, offsets, states, lead, work);
    }
    if (!found)
    {
        return 0;
    }
    set_ends(operation, states);
    found = plan_target(span_matrix(&limits, INT64_C(1)), span_rows(&operation, INT64_C(17), INT64_C(20)), timing, coefficients, offsets, states, cells, lead, work);
    rows = plan_pieces(INT64_C(2), offsets) + plan_pieces(INT64_C(3), offsets);
    if ((!found) || (rows > INT64_C(1200)))
    {
        return 0;
    }
    join_behind(timing, coefficients, offsets);
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
        {
            (*cspan_at(&operation, INT64_C(9) + axis, i)) = 0.0;
        }
    }
    return 1;
}
void segfmu_begin_operation(double time, array_double_2d operation)
{
    int64_t row;
    int64_t i;
    for (row = INT64_C(1); row < INT64_C(26); row += INT64_C(1))
    {
        for (i = INT64_C(0); i < operation.shape[INT64_C(1)]; i += INT64_C(1))
        {
            (*cspan_at(&operation, row, i)) = 0.0;
        }
    }
    (*cspan_at(&operation, INT64_C(4), INT64_C(0))) = time;
    (*cspan_at(&operation, INT64_C(3), INT64_C(0))) = -1.0;
}
static bool is_aim(int64_t row, array_double_2d operation)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        if ((*cspan_at(&operation, INT64_C(1), i)) != (*cspan_at(&operation, row, i)))
        {
            return 0;
        }
    }
    return 1;
}
static void note_present(double elapsed, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    int64_t present;
    int64_t rest;
    int64_t width;
    int64_t axis;
    int64_t row;
    int64_t order;
    present = INT64_C(0) * INT64_C(4);
    rest = INT64_C(1) * INT64_C(4);
    segfmu_cut_plan(span_max(elapsed, 0.0), span_matrix(&timing, INT64_C(0)), span_matrix(&coefficients, INT64_C(0)), span_part(&offsets, present, present + INT64_C(4)), span_matrix(&timing, INT64_C(1)), span_matrix(&coefficients, INT64_C(1)), span_part(&offsets, rest, rest + INT64_C(4)));
    width = coefficients.shape[INT64_C(2)];
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        row = (*cspan_at(&offsets, rest + axis));
        for (order = INT64_C(0); order < span_floor_div(width, INT64_C(2)) + INT64_C(1); order += INT64_C(1))
        {
            (*cspan_at(&operation, INT64_C(13) + axis, order)) = evaluate_piece(span_matrix(&coefficients, INT64_C(1)), row, width, 0.0, order);
        }
    }
}
static bool is_stop(array_double_1d aim)
{
    double fastest;
    int64_t axis;
    bool result;
    fastest = 0.0;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        fastest = span_max(fastest, fabs((*cspan_at(&aim, INT64_C(1) + axis))));
    }
    result = ((*cspan_at(&aim, INT64_C(0))) < 0.5) && (fastest == 0.0);
    return result;
}
static void note_taken(int64_t attempt, array_double_2d operation)
{
    array_double_1d command;
    int64_t i;
    double retry;
    command = span_row(&operation, INT64_C(0));
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&operation, INT64_C(3), i)) = (*cspan_at(&operation, INT64_C(1), i));
    }
    (*cspan_at(&operation, INT64_C(4), INT64_C(3))) = attempt;
    retry = (*cspan_at(&command, INT64_C(0)));
    if (!is_stop(span_row(&operation, INT64_C(1))))
    {
        retry = retry + 0.5 * (*cspan_at(&command, INT64_C(14)));
    }
    (*cspan_at(&operation, INT64_C(4), INT64_C(4))) = retry;
}
static void take_plan(int64_t attempt, array_double_2d operation, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets)
{
    array_double_1d progress;
    int64_t axis;
    int64_t i;
    progress = span_row(&operation, INT64_C(4));
    copy_plan(INT64_C(4), INT64_C(0), timing, coefficients, offsets);
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
        {
            (*cspan_at(&operation, INT64_C(6) + axis, i)) = (*cspan_at(&operation, INT64_C(9) + axis, i));
        }
    }
    (*cspan_at(&progress, INT64_C(0))) = (*cspan_at(&operation, INT64_C(0), INT64_C(0)));
    (*cspan_at(&progress, INT64_C(8))) = (*cspan_at(&progress, INT64_C(8))) + 1.0;
    (*cspan_at(&progress, INT64_C(1))) = INT64_C(0);
    if (attempt > INT64_C(0))
    {
        (*cspan_at(&progress, INT64_C(1))) = INT64_C(1);
    }
    note_taken(attempt, operation);
}
static bool keeps_stopping(int64_t attempt, array_double_2d operation)
{
    double stopping;
    bool result;
    if (attempt < first_stop())
    {
        return 0;
    }
    stopping = (*cspan_at(&operation, INT64_C(4), INT64_C(3)));
    if ((first_stop() <= stopping) && (stopping < most_attempts()))
    {
        result = is_aim(INT64_C(3), operation);
        return result;
    }
    return 0;
}
static int64_t rank(int64_t attempt, array_double_1d aim)
{
    if ((attempt <= INT64_C(2)) || is_stop(aim))
    {
        return INT64_C(0);
    }
    return attempt;
}
static bool attempt_plans(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work, array_double_3d stack)
{
    array_double_1d progress;
    array_double_1d aim;
    int64_t first;
    int64_t failed;
    int64_t tries;
    int64_t attempt;
    bool found;
    int64_t axis;
    int64_t status;
    progress = span_row(&operation, INT64_C(4));
    aim = span_row(&operation, INT64_C(1));
    first = (int64_t)((*cspan_at(&progress, INT64_C(6))));
    failed = INT64_C(0);
    if (first > INT64_C(0))
    {
        failed = (int64_t)((*cspan_at(&progress, INT64_C(7))));
    }
    tries = INT64_C(0);
    (*cspan_at(&progress, INT64_C(6))) = 0.0;
    for (attempt = first; attempt < most_attempts(); attempt += INT64_C(1))
    {
        if ((!is_worth(attempt, failed, aim)) || keeps_stopping(attempt, operation))
        {
            continue;
        }
        if (tries == most_in_step())
        {
            (*cspan_at(&progress, INT64_C(6))) = attempt;
            (*cspan_at(&progress, INT64_C(7))) = failed;
            return 0;
        }
        tries = tries + INT64_C(1);
        (*cspan_at(&progress, INT64_C(9))) = (*cspan_at(&progress, INT64_C(9))) + 1.0;
        set_attempt(attempt, operation, limits, known);
        found = 0;
        if (((*cspan_at(&aim, INT64_C(0))) > 0.5) && (attempt < first_stop()))
        {
            found = seek_target(operation, limits, known, timing, coefficients, offsets, states, cells, lead, work);
        }
        else
        {
            for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
            {
                (*cspan_at(&operation, INT64_C(16), axis)) = (*cspan_at(&aim, INT64_C(1) + axis));
                (*cspan_at(&operation, INT64_C(12), axis)) = share_of(attempt, axis);
            }
            found = seek_velocity(operation, span_matrix(&limits, INT64_C(1)), known, timing, coefficients, offsets, states, lead);
        }
        status = INT64_C(2);
        if (found)
        {
            status = prove_plan(operation, span_matrix(&limits, INT64_C(0)), known, timing, coefficients, offsets, states, lead, work, stack);
        }
        if (status == INT64_C(0))
        {
            take_plan(rank(attempt, aim), operation, timing, coefficients, offsets);
            return 1;
        }
        if (failed == INT64_C(0))
        {
            (*cspan_at(&progress, INT64_C(2))) = status;
        }
        failed = status;
    }
    if (failed > INT64_C(0))
    {
        (*cspan_at(&progress, INT64_C(1))) = (*cspan_at(&progress, INT64_C(2)));
    }
    note_taken(most_attempts(), operation);
    return 0;
}
bool segfmu_operate(array_double_2d operation, array_double_3d limits, array_double_2d known, array_double_3d timing, array_double_3d coefficients, array_int64_t_1d offsets, array_double_3d states, array_double_3d cells, array_double_2d lead, array_double_2d work, array_double_3d stack)
{
    array_double_1d command;
    array_double_1d progress;
    int64_t i;
    double elapsed;
    bool taken;
    int64_t status;
    bool result;
    command = span_row(&operation, INT64_C(0));
    progress = span_row(&operation, INT64_C(4));
    if ((int64_t)((*cspan_at(&command, INT64_C(2)))) == INT64_C(0))
    {
        return 0;
    }
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&operation, INT64_C(2), i)) = (*cspan_at(&operation, INT64_C(1), i));
    }
    write_aim(operation, span_matrix(&limits, INT64_C(0)), known, timing, coefficients, offsets);
    elapsed = (*cspan_at(&command, INT64_C(0))) - (*cspan_at(&progress, INT64_C(0)));
    taken = is_aim(INT64_C(3), operation);
    if (!is_aim(INT64_C(2), operation))
    {
        (*cspan_at(&progress, INT64_C(6))) = 0.0;
    }
    if (taken && ((*cspan_at(&progress, INT64_C(3))) == 0.0))
    {
        if (holds_long_enough(elapsed, operation))
        {
            return 0;
        }
    }
    else if (taken && ((*cspan_at(&command, INT64_C(0))) < (*cspan_at(&progress, INT64_C(4)))))
    {
        if ((*cspan_at(&progress, INT64_C(6))) == 0.0)
        {
            return 0;
        }
    }
    note_present(elapsed, operation, timing, coefficients, offsets);
    if (taken && ((*cspan_at(&progress, INT64_C(3))) == 0.0) && ((*cspan_at(&progress, INT64_C(6))) == 0.0))
    {
        copy_plan(INT64_C(1), INT64_C(4), timing, coefficients, offsets);
        if (prolong_holds(elapsed, operation, known, timing, coefficients, offsets))
        {
            (*cspan_at(&progress, INT64_C(9))) = (*cspan_at(&progress, INT64_C(9))) + 1.0;
            status = prove_plan(operation, span_matrix(&limits, INT64_C(0)), known, timing, coefficients, offsets, states, lead, work, stack);
            if (status == INT64_C(0))
            {
                take_plan(INT64_C(0), operation, timing, coefficients, offsets);
                return 1;
            }
            (*cspan_at(&progress, INT64_C(2))) = status;
        }
    }
    result = attempt_plans(operation, limits, known, timing, coefficients, offsets, states, cells, lead, work, stack);
    return result;
}
int64_t segfmu_check_ready(array_double_1d compensation, array_double_1d resistance, int64_t pieces, array_double_1d fault)
{
    int64_t drive;
    for (drive = INT64_C(0); drive < INT64_C(3); drive += INT64_C(1))
    {
        (*cspan_at(&fault, INT64_C(0))) = drive;
        (*cspan_at(&fault, INT64_C(1))) = (*cspan_at(&compensation, INT64_C(3) + drive));
        if ((*cspan_at(&fault, INT64_C(1))) > 0.0)
        {
            return INT64_C(1);
        }
        if (rubs(resistance, drive))
        {
            return INT64_C(2);
        }
    }
    (*cspan_at(&fault, INT64_C(1))) = pieces;
    if (pieces > INT64_C(1200))
    {
        return INT64_C(3);
    }
    return INT64_C(0);
}
double segfmu_next_operation(array_double_2d operation)
{
    array_double_1d command;
    array_double_1d progress;
    int64_t axis;
    array_double_1d held;
    double renewed;
    double following;
    command = span_row(&operation, INT64_C(0));
    progress = span_row(&operation, INT64_C(4));
    if ((int64_t)((*cspan_at(&command, INT64_C(2)))) == INT64_C(0))
    {
        return 1e+300;
    }
    if (((*cspan_at(&progress, INT64_C(3))) > 0.0) || ((*cspan_at(&progress, INT64_C(6))) > 0.0))
    {
        following = span_max((*cspan_at(&progress, INT64_C(4))), (*cspan_at(&command, INT64_C(0))) + 0.25 * (*cspan_at(&command, INT64_C(14))));
        return following;
    }
    following = 1e+300;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        held = span_row(&operation, INT64_C(6) + axis);
        if ((*cspan_at(&held, INT64_C(2))) > 0.5)
        {
            renewed = (*cspan_at(&held, INT64_C(1))) - 0.5 * (*cspan_at(&command, INT64_C(14)));
            following = span_min(following, (*cspan_at(&progress, INT64_C(0))) + renewed);
        }
    }
    return following;
}
static int64_t check_limits(array_double_2d limits, array_double_1d report)
{
    int64_t axis;
    int64_t order;
    for (axis = INT64_C(0); axis < limits.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        (*cspan_at(&report, INT64_C(0))) = axis;
        for (order = INT64_C(0); order < limits.shape[INT64_C(1)]; order += INT64_C(1))
        {
            (*cspan_at(&report, INT64_C(2))) = (*cspan_at(&limits, axis, order));
            if ((order < INT64_C(2)) && (!((*cspan_at(&limits, axis, order)) > 0.0)))
            {
                return (-INT64_C(14)) - order;
            }
            if (!((*cspan_at(&limits, axis, order)) >= 0.0))
            {
                return -INT64_C(11);
            }
        }
    }
    return INT64_C(0);
}
static int64_t check_numbers(array_double_3d states, array_double_2d limits, array_double_1d report)
{
    int64_t j;
    int64_t axis;
    int64_t i;
    double value;
    for (j = INT64_C(0); j < states.shape[INT64_C(0)]; j += INT64_C(1))
    {
        (*cspan_at(&report, INT64_C(1))) = j;
        for (axis = INT64_C(0); axis < states.shape[INT64_C(1)]; axis += INT64_C(1))
        {
            (*cspan_at(&report, INT64_C(0))) = axis;
            for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
            {
                value = (*cspan_at(&states, j, axis, i));
                if (fabs(value) <= 1.7976931348623157e+308)
                {
                    continue;
                }
                (*cspan_at(&report, INT64_C(2))) = value;
                if (i == INT64_C(0))
                {
                    return -INT64_C(11);
                }
                (*cspan_at(&report, INT64_C(3))) = (*cspan_at(&limits, axis, i - INT64_C(1)));
                return (-INT64_C(7)) + INT64_C(1) - i;
            }
        }
    }
    return INT64_C(0);
}
int64_t segfmu_check_problem(array_double_3d states, array_double_2d limits, array_double_1d report)
{
    int64_t status;
    status = check_limits(limits, report);
    if (status == INT64_C(0))
    {
        status = check_numbers(states, limits, report);
    }
    return status;
}
static double change_time(double size, int64_t derivative, array_double_1d limits)
{
    int64_t i;
    double longest;
    longest = 0.0;
    for (i = derivative; i < limits.shape[INT64_C(0)]; i += INT64_C(1))
    {
        if ((*cspan_at(&limits, i)) > 0.0)
        {
            longest = span_max(longest, pow((size / (*cspan_at(&limits, i))), (1.0 / (i - derivative + INT64_C(1)))));
        }
    }
    return longest;
}
static int64_t axis_scale(double* result_0, double* result_1_0001, int64_t axis, array_double_3d states, array_double_1d limits)
{
    double distance;
    double velocity;
    double acceleration;
    int64_t j;
    double position;
    double before;
    double value;
    distance = 0.0;
    velocity = 0.0;
    acceleration = 0.0;
    for (j = INT64_C(0); j < states.shape[INT64_C(0)]; j += INT64_C(1))
    {
        if (j > INT64_C(0))
        {
            position = (*cspan_at(&states, j, axis, INT64_C(0)));
            before = (*cspan_at(&states, j - INT64_C(1), axis, INT64_C(0)));
            distance = span_max(distance, fabs(position - before));
        }
        value = fabs((*cspan_at(&states, j, axis, INT64_C(1))));
        if (value > velocity)
        {
            velocity = value;
        }
        value = fabs((*cspan_at(&states, j, axis, INT64_C(2))));
        if (value > acceleration)
        {
            acceleration = value;
        }
    }
    velocity = span_max(velocity, acceleration * change_time(acceleration, INT64_C(2), limits));
    if (distance > 0.0)
    {
        velocity = span_max(velocity, distance / change_time(distance, INT64_C(0), limits));
    }
    velocity = span_min(velocity, (*cspan_at(&limits, INT64_C(0))));
    if (velocity > 0.0)
    {
        acceleration = span_max(acceleration, velocity / change_time(velocity, INT64_C(1), limits));
    }
    (*result_0) = velocity;
    (*result_1_0001) = span_min(acceleration, (*cspan_at(&limits, INT64_C(1))));
    return 0;
}
double segfmu_motion_scale(int64_t order, array_double_3d states, array_double_2d limits)
{
    int64_t axis;
    double velocity;
    double acceleration;
    double largest;
    largest = 0.0;
    for (axis = INT64_C(0); axis < states.shape[INT64_C(1)]; axis += INT64_C(1))
    {
        axis_scale(&velocity, &acceleration, axis, states, span_row(&limits, axis));
        if (order == INT64_C(1))
        {
            velocity = acceleration;
        }
        largest = span_max(largest, velocity);
    }
    return largest;
}
static double settle_value(double value, int64_t order, int64_t axis, array_double_3d states, array_double_2d limits, array_double_2d lower)
{
    double limit;
    limit = (*cspan_at(&limits, axis, order));
    if ((value < 0.0) && ((*cspan_at(&lower, axis, order)) > 0.0))
    {
        limit = (*cspan_at(&lower, axis, order));
    }
    if ((fabs(value) <= 1e-09 * limit) && (fabs(value) <= 1e-09 * segfmu_motion_scale(order, states, limits)))
    {
        return 0.0;
    }
    if (fabs(fabs(value) - limit) <= 1e-09 * limit)
    {
        if (value > 0.0)
        {
            return limit;
        }
        return -limit;
    }
    return value;
}
static bool differ(double before, double value)
{
    double size;
    size = fabs(value);
    return !((size <= 1.7976931348623157e+308) && (fabs(value - before) <= 1e-15 * span_max(size, 1.0)));
}
static bool is_same(array_double_2d before, array_double_2d state)
{
    int64_t axis;
    int64_t i;
    for (axis = INT64_C(0); axis < state.shape[INT64_C(0)]; axis += INT64_C(1))
    {
        for (i = INT64_C(0); i < state.shape[INT64_C(1)]; i += INT64_C(1))
        {
            if (differ((*cspan_at(&before, axis, i)), (*cspan_at(&state, axis, i))))
            {
                return 0;
            }
        }
    }
    return 1;
}
int64_t segfmu_settle_states(int64_t first, array_double_3d states, array_double_2d limits, array_double_2d lower)
{
    int64_t j;
    int64_t axis;
    int64_t i;
    double given;
    double settled;
    double before;
    int64_t changed;
    changed = INT64_C(0);
    for (j = first; j < states.shape[INT64_C(0)]; j += INT64_C(1))
    {
        for (axis = INT64_C(0); axis < states.shape[INT64_C(1)]; axis += INT64_C(1))
        {
            for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
            {
                given = (*cspan_at(&states, j, axis, INT64_C(1) + i));
                settled = given;
                if (given != 0.0)
                {
                    settled = settle_value(given, i, axis, states, limits, lower);
                }
                if (j > first)
                {
                    before = (*cspan_at(&states, j - INT64_C(1), axis, INT64_C(1) + i));
                    if (fabs(settled - before) <= 1e-15 * fabs(before))
                    {
                        settled = before;
                    }
                }
                if (fabs(settled - given) > 0.0)
                {
                    (*cspan_at(&states, j, axis, INT64_C(1) + i)) = settled;
                    changed = changed + INT64_C(1);
                }
            }
        }
        if ((j > first) && is_same(span_matrix(&states, j - INT64_C(1)), span_matrix(&states, j)))
        {
            for (axis = INT64_C(0); axis < states.shape[INT64_C(1)]; axis += INT64_C(1))
            {
                before = (*cspan_at(&states, j - INT64_C(1), axis, INT64_C(0)));
                if (fabs((*cspan_at(&states, j, axis, INT64_C(0))) - before) > 0.0)
                {
                    (*cspan_at(&states, j, axis, INT64_C(0))) = before;
                    changed = changed + INT64_C(1);
                }
            }
        }
    }
    return changed;
}
int64_t segfmu_settle_dwells(double sample_time, array_double_1d dwells)
{
    int64_t j;
    double rounded;
    int64_t changed;
    changed = INT64_C(0);
    if ((1e-09 <= sample_time) && (sample_time <= 1000000.0))
    {
        for (j = INT64_C(0); j < dwells.shape[INT64_C(0)]; j += INT64_C(1))
        {
            rounded = (*cspan_at(&dwells, j));
            if (rounded < 1000000000000000.0 * sample_time)
            {
                rounded = round_up(rounded, sample_time);
            }
            if (fabs(rounded - (*cspan_at(&dwells, j))) > 0.0)
            {
                (*cspan_at(&dwells, j)) = rounded;
                changed = changed + INT64_C(1);
            }
        }
    }
    return changed;
}
static int64_t sensing_rows(double sample_time, double dead_time)
{
    int64_t samples;
    if (sample_time <= 0.0)
    {
        return INT64_C(4);
    }
    samples = (int64_t)ceil(dead_time / sample_time) + INT64_C(2);
    return INT64_C(4) + span_floor_div((samples + INT64_C(12) - INT64_C(1)), INT64_C(12));
}
static int64_t sensing_end(array_double_2d settings)
{
    array_double_1d sensors;
    int64_t result;
    sensors = span_row(&settings, INT64_C(1));
    result = INT64_C(36) + sensing_rows((*cspan_at(&sensors, INT64_C(0))), (*cspan_at(&sensors, INT64_C(1))));
    return result;
}
void segfmu_measure_state(array_double_1d state, array_double_1d sensors, array_double_1d numbers, array_double_1d measured)
{
    bool noisy;
    int64_t i;
    double value;
    double step;
    noisy = 0;
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        noisy = noisy || ((*cspan_at(&sensors, INT64_C(8) + i)) > 0.0);
    }
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        value = (*cspan_at(&state, i)) + (*cspan_at(&sensors, INT64_C(3) + i));
        if (noisy)
        {
            value = value + (*cspan_at(&sensors, INT64_C(8) + i)) * next_normal(numbers);
        }
        step = (*cspan_at(&sensors, INT64_C(13) + i));
        if (fabs(value) < 1000000000000000.0 * step)
        {
            value = (int64_t)floor(value / step + 0.5) * step;
        }
        (*cspan_at(&measured, i)) = value;
    }
}
static double next_sample(array_double_1d sensors, array_double_2d memory)
{
    double result;
    if ((*cspan_at(&sensors, INT64_C(0))) <= 0.0)
    {
        return 1e+300;
    }
    result = (*cspan_at(&memory, INT64_C(0), INT64_C(0))) * (*cspan_at(&sensors, INT64_C(0)));
    return result;
}
static int64_t ring_size(array_double_2d memory)
{
    int64_t result;
    result = INT64_C(12) * (memory.shape[INT64_C(0)] - INT64_C(4));
    return result;
}
static int64_t ring_place(int64_t* result_0, int64_t* result_1_0001, int64_t number, array_double_2d memory)
{
    int64_t sample;
    int64_t row;
    sample = span_floor_mod(number, ring_size(memory));
    row = INT64_C(4) + span_floor_div(sample, INT64_C(12));
    (*result_0) = row;
    (*result_1_0001) = INT64_C(6) * (span_floor_mod(sample, INT64_C(12)));
    return 0;
}
static void deliver_samples(array_double_1d sensors, double time, array_double_2d memory)
{
    array_double_1d queue;
    double latest;
    int64_t row;
    int64_t column;
    int64_t i;
    queue = span_row(&memory, INT64_C(0));
    latest = time + 1e-09 * (*cspan_at(&sensors, INT64_C(0)));
    while((*cspan_at(&queue, INT64_C(2))) > 0.5)
    {
        ring_place(&row, &column, (int64_t)((*cspan_at(&queue, INT64_C(1)))), memory);
        if (((*cspan_at(&queue, INT64_C(3))) > 0.5) && ((*cspan_at(&memory, row, column + INT64_C(0))) > latest))
        {
            return;
        }
        for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
        {
            (*cspan_at(&memory, INT64_C(2), i)) = (*cspan_at(&memory, row, column + INT64_C(1) + i));
        }
        (*cspan_at(&queue, INT64_C(1))) = (double)(span_floor_mod(((int64_t)((*cspan_at(&queue, INT64_C(1)))) + INT64_C(1)), ring_size(memory)));
        (*cspan_at(&queue, INT64_C(2))) = (*cspan_at(&queue, INT64_C(2))) - 1.0;
        (*cspan_at(&queue, INT64_C(3))) = 1.0;
    }
}
static void take_sample(array_double_1d sensors, array_double_1d state, array_double_2d memory)
{
    array_double_1d queue;
    array_double_1d taken;
    double time;
    int64_t row;
    int64_t column;
    int64_t i;
    queue = span_row(&memory, INT64_C(0));
    taken = span_row(&memory, INT64_C(3));
    time = next_sample(sensors, memory);
    deliver_samples(sensors, time, memory);
    segfmu_measure_state(state, sensors, span_row(&memory, INT64_C(1)), taken);
    ring_place(&row, &column, (int64_t)((*cspan_at(&queue, INT64_C(1)))) + (int64_t)((*cspan_at(&queue, INT64_C(2)))), memory);
    (*cspan_at(&memory, row, column + INT64_C(0))) = time + (*cspan_at(&sensors, INT64_C(1)));
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&memory, row, column + INT64_C(1) + i)) = (*cspan_at(&taken, i));
    }
    (*cspan_at(&queue, INT64_C(0))) = (*cspan_at(&queue, INT64_C(0))) + 1.0;
    (*cspan_at(&queue, INT64_C(2))) = (*cspan_at(&queue, INT64_C(2))) + 1.0;
}
static void start_sensing(array_double_1d sensors, array_double_1d state, array_double_2d memory)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(4); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(0), i)) = 0.0;
    }
    segfmu_seed_numbers((int64_t)((*cspan_at(&sensors, INT64_C(2)))), span_row(&memory, INT64_C(1)));
    if ((*cspan_at(&sensors, INT64_C(0))) > 0.0)
    {
        take_sample(sensors, state, memory);
    }
}
static void sense_signals(array_double_1d sensors, double time, array_double_1d state, array_double_2d memory, array_double_1d measured)
{
    int64_t i;
    if ((*cspan_at(&sensors, INT64_C(0))) <= 0.0)
    {
        segfmu_measure_state(state, sensors, span_row(&memory, INT64_C(1)), measured);
        return;
    }
    deliver_samples(sensors, time, memory);
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&measured, i)) = (*cspan_at(&memory, INT64_C(2), i));
    }
}
static double time_tolerance(array_double_2d settings)
{
    double result;
    result = 1e-09 * (*cspan_at(&settings, INT64_C(0), INT64_C(1)));
    return result;
}
static double present_time(array_double_2d memory)
{
    double result;
    result = (*cspan_at(&memory, INT64_C(6), INT64_C(1))) + (*cspan_at(&memory, INT64_C(6), INT64_C(2)));
    return result;
}
static double next_tick(array_double_2d settings, array_double_2d memory)
{
    double result;
    result = (*cspan_at(&memory, INT64_C(6), INT64_C(3))) * (*cspan_at(&settings, INT64_C(0), INT64_C(1)));
    return result;
}
static double next_reading(array_double_2d settings, array_double_2d memory)
{
    double result;
    result = next_sample(span_row(&settings, INT64_C(1)), span_rows(&memory, INT64_C(36), sensing_end(settings)));
    return result;
}
double segfmu_rig_next_event(array_double_2d settings, array_double_2d memory)
{
    double time;
    double result;
    time = span_min(next_tick(settings, memory), (*cspan_at(&memory, INT64_C(6), INT64_C(4))));
    result = span_min(time, next_reading(settings, memory));
    return result;
}
static double next_event(array_double_2d settings, double duration, array_double_2d memory)
{
    double until;
    until = segfmu_rig_next_event(settings, memory) - (*cspan_at(&memory, INT64_C(6), INT64_C(1)));
    if (until >= duration - time_tolerance(settings))
    {
        return duration;
    }
    return until;
}
static double next_change(array_double_2d changes, double after, array_double_2d memory)
{
    double start;
    double gust;
    double duration;
    int64_t i;
    double time;
    double first;
    start = (*cspan_at(&memory, INT64_C(6), INT64_C(0)));
    gust = (*cspan_at(&memory, INT64_C(5), INT64_C(62)));
    duration = (*cspan_at(&memory, INT64_C(5), INT64_C(63)));
    first = 1e+300;
    for (i = INT64_C(0); i < changes.shape[INT64_C(0)]; i += INT64_C(1))
    {
        time = (*cspan_at(&changes, i, INT64_C(0))) - start;
        if (time > after)
        {
            first = span_min(first, time);
        }
    }
    if (duration > 0.0)
    {
        time = gust - start;
        if (time > after)
        {
            first = span_min(first, time);
        }
        time = gust + duration - start;
        if (time > after)
        {
            first = span_min(first, time);
        }
    }
    return first;
}
static double mechanical_energy(array_double_2d memory)
{
    array_double_1d energy;
    double result;
    energy = span_row(&memory, INT64_C(13));
    segfmu_crane_energy(span_row(&memory, INT64_C(4)), span_row(&memory, INT64_C(5)), energy);
    result = (*cspan_at(&energy, INT64_C(0))) + (*cspan_at(&energy, INT64_C(1)));
    return result;
}
static void change_payload(array_double_2d settings, array_double_2d changes, double time, array_double_2d memory)
{
    int64_t chosen;
    int64_t i;
    double start;
    chosen = -INT64_C(1);
    for (i = INT64_C(0); i < changes.shape[INT64_C(0)]; i += INT64_C(1))
    {
        start = (*cspan_at(&changes, i, INT64_C(0)));
        if (start <= time + time_tolerance(settings))
        {
            if ((chosen < INT64_C(0)) || (start > (*cspan_at(&changes, chosen, INT64_C(0)))))
            {
                chosen = i;
            }
        }
    }
    if (chosen >= INT64_C(0))
    {
        (*cspan_at(&memory, INT64_C(5), INT64_C(2))) = (*cspan_at(&changes, chosen, INT64_C(1)));
    }
}
static void handle_events(array_double_2d settings, array_double_2d changes, array_double_2d memory)
{
    array_double_1d clock;
    array_double_1d energy;
    double time;
    double latest;
    double before;
    double added;
    clock = span_row(&memory, INT64_C(6));
    energy = span_row(&memory, INT64_C(13));
    time = present_time(memory);
    latest = time + time_tolerance(settings);
    while(next_reading(settings, memory) <= latest)
    {
        take_sample(span_row(&settings, INT64_C(1)), span_row(&memory, INT64_C(4)), span_rows(&memory, INT64_C(36), sensing_end(settings)));
    }
    while((*cspan_at(&clock, INT64_C(4))) <= latest)
    {
        (*cspan_at(&clock, INT64_C(4))) = next_change(changes, (*cspan_at(&clock, INT64_C(4))), memory);
        before = mechanical_energy(memory);
        change_payload(settings, changes, (*cspan_at(&clock, INT64_C(0))) + time, memory);
        added = mechanical_energy(memory) - before;
        (*cspan_at(&energy, INT64_C(3))) = (*cspan_at(&energy, INT64_C(3))) + added;
    }
}
static void update_signals(array_double_2d settings, double time, array_double_2d memory)
{
    sense_signals(span_row(&settings, INT64_C(1)), time, span_row(&memory, INT64_C(4)), span_rows(&memory, INT64_C(36), sensing_end(settings)), span_row(&memory, INT64_C(0)));
}
static bool is_driven(array_double_2d memory)
{
    bool result;
    result = (int64_t)((*cspan_at(&memory, INT64_C(5), INT64_C(18)))) == INT64_C(1);
    return result;
}
static double setpoint_at(array_double_1d setpoints, int64_t i, double share, array_double_2d memory)
{
    double last;
    double bend;
    double result;
    last = (*cspan_at(&memory, INT64_C(7), i));
    bend = (*cspan_at(&memory, INT64_C(11), i)) + (*cspan_at(&memory, INT64_C(12), i)) * (share + 1.0);
    result = last + ((*cspan_at(&setpoints, i)) - last + bend * (share - 1.0)) * share;
    return result;
}
static int64_t setpoint_rates(double* result_0_0001, double* result_1, double* result_2_0001, array_double_1d setpoints, int64_t i, double share, double duration, array_double_2d memory)
{
    double square;
    double cube;
    double slope;
    double bend;
    square = (*cspan_at(&memory, INT64_C(11), i));
    cube = (*cspan_at(&memory, INT64_C(12), i));
    slope = (*cspan_at(&setpoints, i)) - (*cspan_at(&memory, INT64_C(7), i)) - square - cube;
    slope = slope + (2.0 * square + 3.0 * cube * share) * share;
    bend = (square + 3.0 * cube * share) / (duration * duration);
    (*result_0_0001) = slope / duration;
    (*result_1) = bend;
    (*result_2_0001) = cube / (duration * duration * duration);
    return 0;
}
static double bounded_velocity(int64_t axis, double velocity, array_double_2d memory)
{
    double bound;
    bound = velocity_bound(span_row(&memory, INT64_C(5)), axis, velocity);
    if (exceeds(velocity, bound))
    {
        (*cspan_at(&memory, INT64_C(8), INT64_C(10) + axis)) = 1.0;
        return limited(velocity, bound);
    }
    return velocity;
}
static void set_polynomial(int64_t row, int64_t rates, int64_t i, double value, double slope, double square, double cube, array_double_2d memory)
{
    (*cspan_at(&memory, INT64_C(14) + row, i)) = value;
    (*cspan_at(&memory, INT64_C(14) + rates, INT64_C(0) + i)) = slope;
    (*cspan_at(&memory, INT64_C(14) + rates, INT64_C(3) + i)) = square;
    (*cspan_at(&memory, INT64_C(14) + rates, INT64_C(6) + i)) = cube;
}
static void set_command(int64_t axis, double value, double slope, double square, double cube, array_double_2d memory)
{
    set_polynomial(INT64_C(0), INT64_C(1), axis, value, slope, square, cube, memory);
}
static void set_load_force(int64_t i, double value, double slope, double square, double cube, array_double_2d memory)
{
    set_polynomial(INT64_C(2), INT64_C(3), i, value, slope, square, cube, memory);
}
static int64_t delay_rows(double longest, double period)
{
    int64_t commands;
    if (longest <= 0.0)
    {
        return INT64_C(0);
    }
    commands = INT64_C(2) * (INT64_C(512) + (int64_t)ceil(longest / period)) + INT64_C(8);
    return INT64_C(1) + span_floor_div((commands + INT64_C(5) - INT64_C(1)), INT64_C(5));
}
static double longest_delay(array_double_1d plant)
{
    int64_t i;
    double longest;
    longest = 0.0;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        longest = span_max(longest, (*cspan_at(&plant, INT64_C(43) + i)));
    }
    return longest;
}
static bool is_late(array_double_2d memory)
{
    bool result;
    result = longest_delay(span_row(&memory, INT64_C(5))) > 0.0;
    return result;
}
static int64_t command_place(int64_t* result_0, int64_t* result_1_0001, int64_t number, array_double_2d delayed)
{
    int64_t size;
    int64_t place;
    int64_t row;
    size = INT64_C(5) * (delayed.shape[INT64_C(0)] - INT64_C(1));
    place = span_floor_mod(((int64_t)((*cspan_at(&delayed, INT64_C(0), INT64_C(0)))) + number), size);
    row = INT64_C(1) + span_floor_div(place, INT64_C(5));
    (*result_0) = row;
    (*result_1_0001) = INT64_C(14) * (span_floor_mod(place, INT64_C(5)));
    return 0;
}
static double command_start(int64_t number, array_double_2d delayed)
{
    int64_t row;
    int64_t column;
    double result;
    command_place(&row, &column, number, delayed);
    result = (*cspan_at(&delayed, row, column + INT64_C(0)));
    return result;
}
static void start_delay(array_double_1d setpoints, array_double_2d delayed, array_double_2d memory)
{
    int64_t row;
    int64_t column;
    int64_t first;
    int64_t i;
    (*cspan_at(&delayed, INT64_C(0), INT64_C(1))) = 1.0;
    command_place(&row, &column, INT64_C(0), delayed);
    (*cspan_at(&delayed, row, column + INT64_C(0))) = -1e+100;
    first = INT64_C(0);
    if (is_driven(memory))
    {
        first = INT64_C(3);
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&delayed, row, column + INT64_C(2) + i)) = (*cspan_at(&setpoints, first + i));
    }
}
static int64_t shifted_command(double* result_0, double* result_1, double* result_2_0001, double* result_3, int64_t axis, double after, int64_t column, array_double_1d sent)
{
    double cube;
    double square;
    double linear;
    double value;
    cube = (*cspan_at(&sent, column + INT64_C(11) + axis));
    square = (*cspan_at(&sent, column + INT64_C(8) + axis));
    linear = (*cspan_at(&sent, column + INT64_C(5) + axis));
    value = (*cspan_at(&sent, column + INT64_C(2) + axis));
    value = value + after * (linear + after * (square + after * cube));
    linear = linear + after * (2.0 * square + 3.0 * after * cube);
    (*result_0) = value;
    (*result_1) = linear;
    (*result_2_0001) = square + 3.0 * after * cube;
    (*result_3) = cube;
    return 0;
}
static void join_commands(double time, double shortest, array_double_2d delayed)
{
    int64_t newest;
    int64_t row;
    int64_t column;
    int64_t before;
    int64_t place;
    double length;
    double after;
    int64_t i;
    double value;
    double Dummy_0000;
    double Dummy_0001;
    double Dummy_0002;
    double slope;
    newest = (int64_t)((*cspan_at(&delayed, INT64_C(0), INT64_C(1)))) - INT64_C(1);
    if (newest < INT64_C(1))
    {
        return;
    }
    command_place(&row, &column, newest, delayed);
    command_place(&before, &place, newest - INT64_C(1), delayed);
    length = time - (*cspan_at(&delayed, before, place + INT64_C(0)));
    if (((*cspan_at(&delayed, row, column + INT64_C(1))) > 0.5) || (length >= shortest))
    {
        return;
    }
    after = time - (*cspan_at(&delayed, row, column + INT64_C(0)));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        shifted_command(&value, &Dummy_0000, &Dummy_0001, &Dummy_0002, i, after, column, span_row(&delayed, row));
        slope = (value - (*cspan_at(&delayed, before, place + INT64_C(2) + i))) / length;
        (*cspan_at(&delayed, before, place + INT64_C(5) + i)) = slope;
        (*cspan_at(&delayed, before, place + INT64_C(8) + i)) = 0.0;
        (*cspan_at(&delayed, before, place + INT64_C(11) + i)) = 0.0;
    }
    (*cspan_at(&delayed, INT64_C(0), INT64_C(1))) = (double)(newest);
}
static void drop_commands(double time, array_double_2d delayed)
{
    array_double_1d queue;
    int64_t size;
    queue = span_row(&delayed, INT64_C(0));
    size = INT64_C(5) * (delayed.shape[INT64_C(0)] - INT64_C(1));
    while(((*cspan_at(&queue, INT64_C(1))) > 1.5) && ((command_start(INT64_C(1), delayed) <= time) || ((*cspan_at(&queue, INT64_C(1))) >= size)))
    {
        (*cspan_at(&queue, INT64_C(0))) = (double)(span_floor_mod(((int64_t)((*cspan_at(&queue, INT64_C(0)))) + INT64_C(1)), size));
        (*cspan_at(&queue, INT64_C(1))) = (*cspan_at(&queue, INT64_C(1))) - 1.0;
    }
}
static void write_command(int64_t axis, array_double_1d setpoints, double share, double duration, array_double_2d memory, int64_t column, array_double_1d sent)
{
    int64_t place;
    double added;
    double gained;
    double value;
    double slope;
    double square;
    double cube;
    place = INT64_C(0) + axis;
    added = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + axis));
    gained = 0.0;
    if (is_driven(memory))
    {
        place = INT64_C(3) + axis;
        gained = added;
        added = (*cspan_at(&memory, INT64_C(9), axis));
    }
    value = setpoint_at(setpoints, place, share, memory);
    setpoint_rates(&slope, &square, &cube, setpoints, place, share, duration, memory);
    (*cspan_at(&sent, column + INT64_C(2) + axis)) = value + added;
    (*cspan_at(&sent, column + INT64_C(5) + axis)) = slope + gained;
    (*cspan_at(&sent, column + INT64_C(8) + axis)) = square;
    (*cspan_at(&sent, column + INT64_C(11) + axis)) = cube;
}
static void send_commands(array_double_1d setpoints, double duration, array_double_2d memory, array_double_2d delayed)
{
    array_double_1d clock;
    array_double_1d queue;
    bool ticked;
    double time;
    int64_t newest;
    double longest;
    int64_t row;
    int64_t column;
    double share;
    int64_t i;
    clock = span_row(&memory, INT64_C(6));
    queue = span_row(&delayed, INT64_C(0));
    ticked = (*cspan_at(&queue, INT64_C(2))) != (*cspan_at(&clock, INT64_C(3)));
    if (((*cspan_at(&clock, INT64_C(2))) > 0.0) && (!ticked))
    {
        return;
    }
    time = present_time(memory);
    newest = (int64_t)((*cspan_at(&queue, INT64_C(1)))) - INT64_C(1);
    while((newest > INT64_C(0)) && (command_start(newest, delayed) >= time))
    {
        newest = newest - INT64_C(1);
    }
    (*cspan_at(&queue, INT64_C(1))) = newest + 1.0;
    (*cspan_at(&queue, INT64_C(2))) = (*cspan_at(&clock, INT64_C(3)));
    longest = longest_delay(span_row(&memory, INT64_C(5)));
    join_commands(time, longest / INT64_C(512), delayed);
    drop_commands(time - longest, delayed);
    command_place(&row, &column, (int64_t)((*cspan_at(&queue, INT64_C(1)))), delayed);
    (*cspan_at(&queue, INT64_C(1))) = (*cspan_at(&queue, INT64_C(1))) + 1.0;
    (*cspan_at(&delayed, row, column + INT64_C(0))) = time;
    (*cspan_at(&delayed, row, column + INT64_C(1))) = 0.0;
    if (ticked)
    {
        (*cspan_at(&delayed, row, column + INT64_C(1))) = 1.0;
    }
    share = (*cspan_at(&clock, INT64_C(2))) / duration;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        write_command(i, setpoints, share, duration, memory, column, span_row(&delayed, row));
    }
}
static int64_t command_number(double time, array_double_2d delayed)
{
    int64_t last;
    int64_t middle;
    int64_t first;
    first = INT64_C(0);
    last = (int64_t)((*cspan_at(&delayed, INT64_C(0), INT64_C(1)))) - INT64_C(1);
    while(first < last)
    {
        middle = span_floor_div((first + last + INT64_C(1)), INT64_C(2));
        if (command_start(middle, delayed) <= time)
        {
            first = middle;
        }
        else
        {
            last = middle - INT64_C(1);
        }
    }
    return first;
}
static double next_command(array_double_2d settings, double until, array_double_2d memory, array_double_2d delayed)
{
    array_double_1d clock;
    int64_t newest;
    int64_t i;
    double late;
    double latest;
    int64_t number;
    double due;
    double first;
    clock = span_row(&memory, INT64_C(6));
    first = until;
    newest = (int64_t)((*cspan_at(&delayed, INT64_C(0), INT64_C(1)))) - INT64_C(1);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        late = (*cspan_at(&memory, INT64_C(5), INT64_C(43) + i));
        latest = present_time(memory) - late + time_tolerance(settings);
        number = command_number(latest, delayed);
        if ((late > 0.0) && (number < newest))
        {
            due = command_start(number + INT64_C(1), delayed) + late - (*cspan_at(&clock, INT64_C(1)));
            if (due < until - time_tolerance(settings))
            {
                first = span_min(first, due);
            }
        }
    }
    return first;
}
static void late_commands(array_double_2d settings, double length, array_double_2d memory, array_double_2d delayed)
{
    int64_t i;
    double late;
    double time;
    int64_t number;
    int64_t row;
    int64_t column;
    double after;
    double value;
    double slope;
    double square;
    double cube;
    double end;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        late = (*cspan_at(&memory, INT64_C(5), INT64_C(43) + i));
        if (late > 0.0)
        {
            time = present_time(memory) - late;
            number = command_number(time + time_tolerance(settings), delayed);
            command_place(&row, &column, number, delayed);
            after = time - (*cspan_at(&delayed, row, column + INT64_C(0)));
            shifted_command(&value, &slope, &square, &cube, i, after, column, span_row(&delayed, row));
            if (is_driven(memory) && ((*cspan_at(&memory, INT64_C(5), INT64_C(19) + i)) == 0.0))
            {
                end = value + length * (slope + length * (square + length * cube));
                end = bounded_velocity(i, end, memory);
                value = (end - axis_velocity(span_row(&memory, INT64_C(4)), i)) / length;
                slope = 0.0;
                square = 0.0;
                cube = 0.0;
            }
            set_command(i, value, slope, square, cube, memory);
        }
    }
}
static void start_planned(array_double_1d setpoints, array_double_2d memory)
{
    array_double_1d planned;
    int64_t i;
    double value;
    double lag;
    double behind;
    planned = span_row(&memory, INT64_C(10));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        value = (*cspan_at(&setpoints, INT64_C(3) + i));
        lag = (*cspan_at(&memory, INT64_C(5), INT64_C(19) + i));
        (*cspan_at(&planned, INT64_C(0) + i)) = value;
        if (lag > 0.0)
        {
            behind = value - (*cspan_at(&memory, INT64_C(4), INT64_C(5) + i));
            (*cspan_at(&planned, INT64_C(3) + i)) = behind / lag;
        }
    }
}
static void follow_setpoint(int64_t axis, double setpoint, double slope, double period, array_double_2d memory)
{
    array_double_1d planned;
    double lag;
    double bound;
    double reached;
    double risen;
    double before;
    double mean;
    double after;
    double gained;
    double most;
    planned = span_row(&memory, INT64_C(10));
    lag = (*cspan_at(&memory, INT64_C(5), INT64_C(19) + axis));
    if (lag <= 0.0)
    {
        (*cspan_at(&planned, INT64_C(3) + axis)) = slope;
        return;
    }
    bound = velocity_bound(span_row(&memory, INT64_C(5)), axis, setpoint);
    reached = setpoint;
    if (exceeds(setpoint, bound))
    {
        reached = limited(setpoint, bound);
    }
    risen = reached - (*cspan_at(&planned, INT64_C(0) + axis));
    (*cspan_at(&planned, INT64_C(0) + axis)) = reached;
    if ((*cspan_at(&memory, INT64_C(6), INT64_C(3))) > 1.5)
    {
        before = (*cspan_at(&planned, INT64_C(3) + axis));
        mean = risen / period;
        after = mean + (before - mean) * exp((-period) / lag);
        gained = risen - lag * (after - before);
        most = period * acceleration_bound(span_row(&memory, INT64_C(5)), axis, gained);
        if (exceeds(gained, most))
        {
            after = before + (risen - limited(gained, most)) / lag;
        }
        (*cspan_at(&planned, INT64_C(3) + axis)) = after;
    }
}
static bool controller_due(array_double_2d settings, array_double_2d memory)
{
    bool result;
    result = next_tick(settings, memory) <= present_time(memory) + time_tolerance(settings);
    return result;
}
static void prepare_tick(array_double_2d settings, array_double_1d setpoints, double duration, array_double_2d memory)
{
    array_double_1d clock;
    double time;
    double share;
    int64_t i;
    double value;
    int64_t velocity;
    double slope;
    double Dummy_0000;
    double Dummy_0001;
    clock = span_row(&memory, INT64_C(6));
    time = present_time(memory);
    share = (*cspan_at(&clock, INT64_C(2))) / duration;
    (*cspan_at(&clock, INT64_C(3))) = (*cspan_at(&clock, INT64_C(3))) + 1.0;
    (*cspan_at(&clock, INT64_C(5))) = (*cspan_at(&clock, INT64_C(0))) + time;
    update_signals(settings, time, memory);
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        value = setpoint_at(setpoints, INT64_C(6) + i, share, memory);
        (*cspan_at(&memory, INT64_C(1), i)) = value;
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        if (is_driven(memory))
        {
            velocity = INT64_C(3) + i;
            setpoint_rates(&slope, &Dummy_0000, &Dummy_0001, setpoints, velocity, share, duration, memory);
            value = setpoint_at(setpoints, velocity, share, memory);
            follow_setpoint(i, value, slope, (*cspan_at(&settings, INT64_C(0), INT64_C(1))), memory);
            (*cspan_at(&memory, INT64_C(2), i)) = (*cspan_at(&memory, INT64_C(10), INT64_C(3) + i));
        }
        else
        {
            value = setpoint_at(setpoints, INT64_C(0) + i, share, memory);
            (*cspan_at(&memory, INT64_C(2), i)) = value;
        }
    }
}
static void bound_feedback(array_double_2d settings, array_double_3d gains, array_double_1d situation, array_double_2d memory)
{
    array_double_1d parameters;
    array_double_1d state;
    array_double_1d reference;
    array_double_1d plant;
    array_double_2d tick;
    double length;
    int64_t i;
    double velocity;
    double place;
    double rate;
    double sign;
    double angle;
    double swing;
    parameters = span_row(&settings, INT64_C(2));
    state = span_row(&memory, INT64_C(4));
    reference = span_row(&memory, INT64_C(1));
    plant = span_row(&memory, INT64_C(5));
    tick = span_rows(&memory, INT64_C(0), INT64_C(4));
    length = (*cspan_at(&state, INT64_C(0) + INT64_C(2)));
    (*cspan_at(&situation, INT64_C(0))) = (*cspan_at(&plant, INT64_C(2))) * (*cspan_at(&plant, INT64_C(3)));
    (*cspan_at(&situation, INT64_C(1))) = length;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        velocity = (*cspan_at(&state, INT64_C(5) + i));
        if (is_driven(memory))
        {
            velocity = (*cspan_at(&reference, INT64_C(5) + i)) + (*cspan_at(&memory, INT64_C(9), i));
        }
        (*cspan_at(&situation, INT64_C(2) + i)) = velocity;
        place = (*cspan_at(&state, INT64_C(0) + i)) - (*cspan_at(&reference, INT64_C(0) + i));
        rate = (*cspan_at(&state, INT64_C(5) + i)) - (*cspan_at(&reference, INT64_C(5) + i));
        if (i != INT64_C(2))
        {
            sign = 1.0 - 2.0 * i;
            angle = (*cspan_at(&state, INT64_C(3) + i)) - (*cspan_at(&reference, INT64_C(3) + i));
            swing = (*cspan_at(&state, INT64_C(8) + i)) - (*cspan_at(&reference, INT64_C(8) + i));
            place = place + length * sign * angle;
            rate = rate + length * sign * swing;
        }
        (*cspan_at(&situation, INT64_C(5) + i)) = place;
        (*cspan_at(&situation, INT64_C(8) + i)) = rate;
        bound_return(i, parameters, gains, tick, situation);
        bound_correction(i, parameters, tick, situation);
    }
}
void segfmu_switch_correction(array_double_2d settings, array_double_2d memory)
{
    array_double_1d loop;
    array_double_1d correction;
    double acts;
    double decay;
    double acted;
    int64_t i;
    double fade;
    double value;
    double fading;
    loop = span_row(&settings, INT64_C(0));
    correction = span_row(&memory, INT64_C(3));
    acts = 2.0;
    if ((*cspan_at(&loop, INT64_C(2))) < 0.5)
    {
        acts = 1.0;
    }
    decay = 0.0;
    if ((*cspan_at(&loop, INT64_C(4))) > 0.0)
    {
        decay = exp((-(*cspan_at(&loop, INT64_C(1)))) / (*cspan_at(&loop, INT64_C(4))));
    }
    acted = (*cspan_at(&correction, INT64_C(6)));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        if ((*cspan_at(&loop, INT64_C(2))) < 0.5)
        {
            (*cspan_at(&correction, INT64_C(0) + i)) = 0.0;
            if (is_driven(memory))
            {
                fade = span_max((*cspan_at(&loop, INT64_C(4))), (*cspan_at(&loop, INT64_C(1))));
                (*cspan_at(&correction, INT64_C(0) + i)) = (-(*cspan_at(&memory, INT64_C(9), i))) / fade;
            }
        }
        value = (*cspan_at(&correction, INT64_C(0) + i));
        fading = (*cspan_at(&correction, INT64_C(3) + i));
        if ((acted > 0.5) && (acted != acts))
        {
            fading = (*cspan_at(&correction, INT64_C(7) + i)) - value;
        }
        fading = decay * fading;
        (*cspan_at(&correction, INT64_C(3) + i)) = fading;
        (*cspan_at(&correction, INT64_C(0) + i)) = value + fading;
        (*cspan_at(&correction, INT64_C(7) + i)) = value + fading;
    }
    (*cspan_at(&correction, INT64_C(6))) = acts;
}
static void correct_setpoints(array_double_2d settings, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_2d memory)
{
    if ((int64_t)((*cspan_at(&settings, INT64_C(0), INT64_C(0)))) == INT64_C(2))
    {
        segfmu_track_setpoint(span_row(&settings, INT64_C(2)), table, gains, span_rows(&memory, INT64_C(0), INT64_C(4)), tracker);
    }
    else
    {
        segfmu_feedback_correction(span_row(&memory, INT64_C(4)), span_row(&memory, INT64_C(1)), span_row(&memory, INT64_C(9)), gains, span_row(&memory, INT64_C(3)));
        bound_feedback(settings, gains, span_row(&tracker, INT64_C(30)), memory);
    }
    segfmu_switch_correction(settings, memory);
}
static void command_velocities(array_double_1d setpoints, double duration, double until, array_double_2d memory)
{
    double done;
    double length;
    int64_t i;
    int64_t velocity;
    double correction;
    double added;
    double command;
    double slope;
    double square;
    double cube;
    double end;
    double acceleration;
    done = (*cspan_at(&memory, INT64_C(6), INT64_C(2)));
    length = until - done;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        velocity = INT64_C(3) + i;
        correction = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + i));
        added = (*cspan_at(&memory, INT64_C(9), i));
        command = setpoint_at(setpoints, velocity, done / duration, memory) + added;
        setpoint_rates(&slope, &square, &cube, setpoints, velocity, done / duration, duration, memory);
        (*cspan_at(&memory, INT64_C(9), i)) = added + correction * length;
        set_command(i, command, slope + correction, square, cube, memory);
        if ((*cspan_at(&memory, INT64_C(5), INT64_C(19) + i)) == 0.0)
        {
            end = setpoint_at(setpoints, velocity, until / duration, memory);
            end = end + (*cspan_at(&memory, INT64_C(9), i));
            end = bounded_velocity(i, end, memory);
            acceleration = (end - axis_velocity(span_row(&memory, INT64_C(4)), i)) / length;
            set_command(i, acceleration, 0.0, 0.0, 0.0, memory);
        }
    }
}
static void command_forces(array_double_1d setpoints, double duration, array_double_2d memory)
{
    double share;
    int64_t i;
    double force;
    double slope;
    double square;
    double cube;
    double correction;
    share = (*cspan_at(&memory, INT64_C(6), INT64_C(2))) / duration;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        force = setpoint_at(setpoints, INT64_C(0) + i, share, memory);
        setpoint_rates(&slope, &square, &cube, setpoints, INT64_C(0) + i, share, duration, memory);
        correction = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + i));
        set_command(i, force + correction, slope, square, cube, memory);
    }
}
static void follow_wind(array_double_1d setpoints, double duration, array_double_2d memory)
{
    double share;
    int64_t i;
    int64_t place;
    double force;
    double slope;
    double square;
    double cube;
    share = (*cspan_at(&memory, INT64_C(6), INT64_C(2))) / duration;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        place = INT64_C(16) + i;
        force = setpoint_at(setpoints, place, share, memory);
        setpoint_rates(&slope, &square, &cube, setpoints, place, share, duration, memory);
        set_load_force(i, force, slope, square, cube, memory);
    }
}
static int64_t advance_plant(array_double_2d settings, array_double_2d components, array_double_1d setpoints, double duration, double until, array_double_2d memory)
{
    array_double_1d clock;
    array_double_1d report;
    array_double_2d work;
    double time;
    int64_t i;
    double before;
    int64_t status;
    clock = span_row(&memory, INT64_C(6));
    report = span_row(&memory, INT64_C(8));
    work = span_rows(&memory, INT64_C(14), INT64_C(14) + INT64_C(22));
    time = (*cspan_at(&clock, INT64_C(0))) + (*cspan_at(&clock, INT64_C(1))) + (*cspan_at(&clock, INT64_C(2)));
    if (is_driven(memory))
    {
        command_velocities(setpoints, duration, until, memory);
    }
    else
    {
        command_forces(setpoints, duration, memory);
    }
    if (is_late(memory))
    {
        late_commands(settings, until - (*cspan_at(&clock, INT64_C(2))), memory, span_rows(&memory, sensing_end(settings), memory.shape[INT64_C(0)]));
    }
    follow_wind(setpoints, duration, memory);
    status = segfmu_plant_advance(span_row(&memory, INT64_C(5)), components, time, span_row(&memory, INT64_C(4)), until - (*cspan_at(&clock, INT64_C(2))), (*cspan_at(&settings, INT64_C(0), INT64_C(3))), work, report);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        before = (*cspan_at(&report, INT64_C(10) + i));
        (*cspan_at(&report, INT64_C(10) + i)) = span_max(before, (*cspan_at(&report, INT64_C(3) + i)));
    }
    if (status != INT64_C(0))
    {
        (*cspan_at(&clock, INT64_C(5))) = time + (*cspan_at(&report, INT64_C(9)));
    }
    return status;
}
void segfmu_rig_signals(array_double_2d settings, double time, array_double_2d memory)
{
    (*cspan_at(&memory, INT64_C(6), INT64_C(1))) = time;
    (*cspan_at(&memory, INT64_C(6), INT64_C(2))) = 0.0;
    update_signals(settings, time, memory);
}
static double added_velocity(int64_t axis, double time, array_double_2d memory)
{
    double held;
    double correction;
    double result;
    held = time - (*cspan_at(&memory, INT64_C(6), INT64_C(6)));
    correction = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + axis));
    result = (*cspan_at(&memory, INT64_C(9), axis)) + correction * held;
    return result;
}
void segfmu_rig_event(array_double_2d settings, array_double_2d changes, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_1d setpoints, double time, array_double_2d memory)
{
    array_double_1d clock;
    int64_t i;
    clock = span_row(&memory, INT64_C(6));
    segfmu_rig_signals(settings, time, memory);
    for (i = INT64_C(0); i < INT64_C(19); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(7), i)) = (*cspan_at(&setpoints, i));
    }
    handle_events(settings, changes, memory);
    if (controller_due(settings, memory))
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&memory, INT64_C(9), i)) = added_velocity(i, time, memory);
        }
        (*cspan_at(&clock, INT64_C(6))) = time;
        prepare_tick(settings, setpoints, 1.0, memory);
        correct_setpoints(settings, table, gains, tracker, memory);
    }
}
static int64_t commanded_rates(array_double_2d components, array_double_1d setpoints, double time, array_double_2d memory, array_double_1d derivative)
{
    array_double_2d work;
    array_double_1d report;
    int64_t i;
    int64_t result;
    work = span_rows(&memory, INT64_C(14), INT64_C(14) + INT64_C(22));
    report = span_row(&memory, INT64_C(8));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        set_load_force(i, (*cspan_at(&setpoints, INT64_C(16) + i)), 0.0, 0.0, 0.0, memory);
    }
    plant_derivative(span_row(&memory, INT64_C(5)), components, (*cspan_at(&memory, INT64_C(6), INT64_C(0))) + time, 0.0, span_row(&memory, INT64_C(4)), work, derivative);
    for (i = INT64_C(0); i < INT64_C(7); i += INT64_C(1))
    {
        (*cspan_at(&report, i)) = (*cspan_at(&work, INT64_C(14), i));
    }
    (*cspan_at(&report, INT64_C(7))) = (*cspan_at(&derivative, INT64_C(14)));
    (*cspan_at(&report, INT64_C(8))) = (*cspan_at(&derivative, INT64_C(15)));
    result = plant_status(span_row(&memory, INT64_C(5)), span_row(&memory, INT64_C(4)), (*cspan_at(&work, INT64_C(14), INT64_C(6))));
    return result;
}
int64_t segfmu_rig_rates(array_double_2d components, array_double_1d setpoints, double time, array_double_2d memory, array_double_1d derivative)
{
    int64_t i;
    double command;
    double correction;
    int64_t result;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        if (is_driven(memory))
        {
            command = (*cspan_at(&setpoints, INT64_C(3) + i)) + added_velocity(i, time, memory);
        }
        else
        {
            correction = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + i));
            command = (*cspan_at(&setpoints, INT64_C(0) + i)) + correction;
        }
        set_command(i, command, 0.0, 0.0, 0.0, memory);
    }
    result = commanded_rates(components, setpoints, time, memory, derivative);
    return result;
}
static double first_command(int64_t axis, array_double_1d setpoints, array_double_2d memory)
{
    array_double_1d plant;
    double present;
    double change;
    double by_force;
    double velocity;
    plant = span_row(&memory, INT64_C(5));
    if (!is_driven(memory))
    {
        velocity = (*cspan_at(&setpoints, INT64_C(0) + axis));
        return velocity;
    }
    velocity = (*cspan_at(&setpoints, INT64_C(3) + axis));
    if ((*cspan_at(&plant, INT64_C(19) + axis)) > 0.0)
    {
        return velocity;
    }
    velocity = bounded_velocity(axis, velocity, memory);
    present = axis_velocity(span_row(&memory, INT64_C(4)), axis);
    change = velocity - present;
    by_force = force_bound(plant, axis, change, present);
    if (span_max(acceleration_bound(plant, axis, change), by_force) == 0.0)
    {
        return 0.0;
    }
    return 1000000.0 * change;
}
static void act_first(array_double_2d components, array_double_1d setpoints, array_double_2d memory)
{
    array_double_1d state;
    array_double_1d plant;
    array_double_1d report;
    array_double_1d derivative;
    int64_t i;
    double command;
    int64_t status;
    double before;
    state = span_row(&memory, INT64_C(4));
    plant = span_row(&memory, INT64_C(5));
    report = span_row(&memory, INT64_C(8));
    derivative = span_row(&memory, INT64_C(14) + INT64_C(4) + INT64_C(6));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        command = first_command(i, setpoints, memory);
        set_command(i, command, 0.0, 0.0, 0.0, memory);
    }
    status = commanded_rates(components, setpoints, 0.0, memory, derivative);
    if ((status == INT64_C(5)) && may_slacken(plant))
    {
        change_rope(plant, state);
        commanded_rates(components, setpoints, 0.0, memory, derivative);
        (*cspan_at(&state, INT64_C(16))) = 0.0;
        (*cspan_at(&state, INT64_C(17))) = 0.0;
        (*cspan_at(&state, INT64_C(18))) = 0.0;
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        before = (*cspan_at(&report, INT64_C(10) + i));
        (*cspan_at(&report, INT64_C(10) + i)) = span_max(before, (*cspan_at(&report, INT64_C(3) + i)));
    }
}
int64_t segfmu_rig_rows(array_double_2d settings)
{
    double longest;
    int64_t late;
    int64_t result;
    longest = longest_delay(span_row(&settings, INT64_C(3)));
    late = delay_rows(longest, (*cspan_at(&settings, INT64_C(0), INT64_C(1))));
    result = sensing_end(settings) + late;
    return result;
}
void segfmu_rig_start(array_double_2d settings, array_double_2d components, array_double_2d changes, array_double_1d state, array_double_1d setpoints, double start, array_double_2d memory)
{
    int64_t row;
    int64_t i;
    for (row = INT64_C(0); row < memory.shape[INT64_C(0)]; row += INT64_C(1))
    {
        for (i = INT64_C(0); i < memory.shape[INT64_C(1)]; i += INT64_C(1))
        {
            (*cspan_at(&memory, row, i)) = 0.0;
        }
    }
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(4), i)) = (*cspan_at(&state, i));
    }
    for (i = INT64_C(0); i < INT64_C(77); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(5), i)) = (*cspan_at(&settings, INT64_C(3), i));
    }
    (*cspan_at(&memory, INT64_C(5), INT64_C(62))) = segfmu_begin_time((*cspan_at(&settings, INT64_C(3), INT64_C(62))), start);
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(4), INT64_C(10) + i)) = first_deflection(span_row(&memory, INT64_C(5)), i, (*cspan_at(&state, INT64_C(5) + i)));
    }
    for (i = INT64_C(0); i < INT64_C(19); i += INT64_C(1))
    {
        (*cspan_at(&memory, INT64_C(7), i)) = (*cspan_at(&setpoints, i));
    }
    start_planned(setpoints, memory);
    (*cspan_at(&memory, INT64_C(6), INT64_C(0))) = start;
    (*cspan_at(&memory, INT64_C(6), INT64_C(4))) = next_change(changes, 0.0, memory);
    change_payload(settings, changes, start, memory);
    (*cspan_at(&memory, INT64_C(13), INT64_C(2))) = mechanical_energy(memory);
    start_sensing(span_row(&settings, INT64_C(1)), span_row(&memory, INT64_C(4)), span_rows(&memory, INT64_C(36), sensing_end(settings)));
    update_signals(settings, 0.0, memory);
    if (is_late(memory))
    {
        start_delay(setpoints, span_rows(&memory, sensing_end(settings), memory.shape[INT64_C(0)]), memory);
    }
    act_first(components, setpoints, memory);
}
int64_t segfmu_rig_step(array_double_2d settings, array_double_2d components, array_double_2d changes, array_double_3d table, array_double_3d gains, array_double_2d tracker, array_double_1d setpoints, double duration, array_double_2d memory)
{
    array_double_1d clock;
    int64_t i;
    double until;
    array_double_2d delayed;
    int64_t status;
    clock = span_row(&memory, INT64_C(6));
    if ((!(fabs(duration) < 1e+100)) || (!all_finite(setpoints, INT64_C(19))))
    {
        (*cspan_at(&clock, INT64_C(5))) = (*cspan_at(&clock, INT64_C(0))) + (*cspan_at(&clock, INT64_C(1)));
        return INT64_C(4);
    }
    status = INT64_C(0);
    if ((*cspan_at(&clock, INT64_C(2))) == 0.0)
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&memory, INT64_C(8), INT64_C(10) + i)) = 0.0;
        }
    }
    while((status == INT64_C(0)) && ((*cspan_at(&clock, INT64_C(2))) < duration))
    {
        if (controller_due(settings, memory))
        {
            prepare_tick(settings, setpoints, duration, memory);
            if ((int64_t)((*cspan_at(&settings, INT64_C(0), INT64_C(0)))) == INT64_C(0))
            {
                return -INT64_C(1);
            }
            correct_setpoints(settings, table, gains, tracker, memory);
        }
        until = next_event(settings, duration, memory);
        if (is_late(memory))
        {
            delayed = span_rows(&memory, sensing_end(settings), memory.shape[INT64_C(0)]);
            send_commands(setpoints, duration, memory, delayed);
            until = next_command(settings, until, memory, delayed);
        }
        status = advance_plant(settings, components, setpoints, duration, until, memory);
        if (status == INT64_C(0))
        {
            (*cspan_at(&clock, INT64_C(2))) = until;
            handle_events(settings, changes, memory);
        }
    }
    (*cspan_at(&clock, INT64_C(2))) = 0.0;
    if (status == INT64_C(0))
    {
        (*cspan_at(&clock, INT64_C(1))) = (*cspan_at(&clock, INT64_C(1))) + duration;
        for (i = INT64_C(0); i < INT64_C(19); i += INT64_C(1))
        {
            (*cspan_at(&memory, INT64_C(7), i)) = (*cspan_at(&setpoints, i));
            (*cspan_at(&memory, INT64_C(11), i)) = 0.0;
            (*cspan_at(&memory, INT64_C(12), i)) = 0.0;
        }
    }
    update_signals(settings, (*cspan_at(&clock, INT64_C(1))), memory);
    return status;
}
void segfmu_rig_balance(array_double_2d memory, array_double_1d balance)
{
    array_double_1d state;
    array_double_1d energy;
    state = span_row(&memory, INT64_C(4));
    energy = span_row(&memory, INT64_C(13));
    segfmu_crane_energy(state, span_row(&memory, INT64_C(5)), energy);
    (*cspan_at(&balance, INT64_C(0))) = (*cspan_at(&energy, INT64_C(0)));
    (*cspan_at(&balance, INT64_C(1))) = (*cspan_at(&energy, INT64_C(1)));
    (*cspan_at(&balance, INT64_C(2))) = (*cspan_at(&energy, INT64_C(2)));
    (*cspan_at(&balance, INT64_C(3))) = (*cspan_at(&state, INT64_C(13)));
    (*cspan_at(&balance, INT64_C(4))) = (*cspan_at(&state, INT64_C(14)));
    (*cspan_at(&balance, INT64_C(5))) = (*cspan_at(&energy, INT64_C(3)));
    (*cspan_at(&balance, INT64_C(6))) = (*cspan_at(&state, INT64_C(15)));
}
double segfmu_rig_imbalance(array_double_1d balance)
{
    double gained;
    double kept;
    gained = (*cspan_at(&balance, INT64_C(3))) + (*cspan_at(&balance, INT64_C(4))) + (*cspan_at(&balance, INT64_C(5)));
    gained = gained - (*cspan_at(&balance, INT64_C(6)));
    kept = (*cspan_at(&balance, INT64_C(0))) + (*cspan_at(&balance, INT64_C(1))) - (*cspan_at(&balance, INT64_C(2)));
    return kept - gained;
}
static void load_outputs(array_double_1d target, array_double_2d memory, array_double_1d outputs)
{
    array_double_2d load;
    double square;
    double speed;
    int64_t i;
    double error;
    load = span_rows(&memory, INT64_C(14) + INT64_C(16), INT64_C(14) + INT64_C(16) + INT64_C(2));
    segfmu_crane_load(span_row(&memory, INT64_C(4)), load);
    square = 0.0;
    speed = 0.0;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        speed = speed + (*cspan_at(&load, INT64_C(1), i)) * (*cspan_at(&load, INT64_C(1), i));
        error = (*cspan_at(&load, INT64_C(0), i)) - (*cspan_at(&target, i));
        (*cspan_at(&outputs, INT64_C(18) + i)) = (*cspan_at(&load, INT64_C(0), i));
        (*cspan_at(&outputs, INT64_C(21) + i)) = (*cspan_at(&load, INT64_C(1), i));
        (*cspan_at(&outputs, INT64_C(26) + i)) = error;
        square = square + error * error;
    }
    (*cspan_at(&outputs, INT64_C(24))) = sqrt(speed);
    (*cspan_at(&outputs, INT64_C(29))) = sqrt(square);
}
static double total_sway(double angle_x, double angle_y)
{
    double across;
    across = cos(angle_x) * sin(angle_y);
    return atan2(sqrt(sin(angle_x) * sin(angle_x) + across * across), cos(angle_x) * cos(angle_y));
}
static void drive_outputs(array_double_2d memory, array_double_1d outputs)
{
    array_double_1d report;
    int64_t i;
    report = span_row(&memory, INT64_C(8));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&outputs, INT64_C(30) + i)) = (*cspan_at(&report, INT64_C(0) + i));
        (*cspan_at(&outputs, INT64_C(33) + i)) = (*cspan_at(&report, INT64_C(10) + i));
        (*cspan_at(&outputs, INT64_C(36) + i)) = (*cspan_at(&report, INT64_C(0) + i)) * axis_velocity(span_row(&memory, INT64_C(4)), i);
    }
    (*cspan_at(&outputs, INT64_C(39))) = (*cspan_at(&report, INT64_C(6)));
    (*cspan_at(&outputs, INT64_C(49))) = (*cspan_at(&report, INT64_C(7)));
    (*cspan_at(&outputs, INT64_C(50))) = (*cspan_at(&report, INT64_C(8)));
    (*cspan_at(&outputs, INT64_C(40))) = (*cspan_at(&memory, INT64_C(5), INT64_C(2)));
}
void segfmu_rig_outputs(array_double_1d target, array_double_2d memory, array_double_1d balance, array_double_1d outputs)
{
    array_double_1d state;
    int64_t i;
    state = span_row(&memory, INT64_C(4));
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        (*cspan_at(&outputs, INT64_C(0) + i)) = (*cspan_at(&state, i));
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&outputs, INT64_C(10) + i)) = (*cspan_at(&state, INT64_C(10) + i));
    }
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&outputs, INT64_C(13) + i)) = (*cspan_at(&memory, INT64_C(0), i));
    }
    load_outputs(target, memory, outputs);
    (*cspan_at(&outputs, INT64_C(25))) = total_sway((*cspan_at(&state, INT64_C(3))), (*cspan_at(&state, INT64_C(3) + INT64_C(1))));
    drive_outputs(memory, outputs);
    segfmu_rig_balance(memory, balance);
    (*cspan_at(&outputs, INT64_C(41))) = (*cspan_at(&balance, INT64_C(0)));
    (*cspan_at(&outputs, INT64_C(42))) = (*cspan_at(&balance, INT64_C(1)));
    (*cspan_at(&outputs, INT64_C(43))) = (*cspan_at(&state, INT64_C(13))) + (*cspan_at(&state, INT64_C(14)));
    (*cspan_at(&outputs, INT64_C(44))) = (*cspan_at(&balance, INT64_C(3)));
    (*cspan_at(&outputs, INT64_C(45))) = (*cspan_at(&balance, INT64_C(4)));
    (*cspan_at(&outputs, INT64_C(46))) = (*cspan_at(&balance, INT64_C(5)));
    (*cspan_at(&outputs, INT64_C(47))) = (*cspan_at(&balance, INT64_C(6)));
    (*cspan_at(&outputs, INT64_C(48))) = segfmu_rig_imbalance(balance);
}
void segfmu_tracking_estimates(array_double_1d parameters, array_double_2d tracker, array_double_1d estimates)
{
    int64_t i;
    (*cspan_at(&estimates, INT64_C(0))) = (*cspan_at(&parameters, INT64_C(3) + INT64_C(2))) * (1.0 + (*cspan_at(&tracker, INT64_C(5), INT64_C(3))));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&estimates, INT64_C(1) + i)) = (*cspan_at(&tracker, INT64_C(25) + i, INT64_C(4)));
    }
    for (i = INT64_C(0); i < INT64_C(6) - INT64_C(4); i += INT64_C(1))
    {
        (*cspan_at(&estimates, INT64_C(4) + i)) = (*cspan_at(&tracker, INT64_C(25) + i, INT64_C(5)));
    }
    (*cspan_at(&estimates, INT64_C(6))) = (*cspan_at(&tracker, INT64_C(11) + INT64_C(9), INT64_C(5)));
}
static int64_t axis_slopes(double* result_0, double* result_1_0001, double* result_2, array_double_1d plant, int64_t axis, array_double_1d state)
{
    double velocity;
    double by_position;
    double damping;
    double by_velocity;
    double by_deflection;
    velocity = (*cspan_at(&state, INT64_C(5) + axis));
    buffer_slopes(&by_position, &damping, plant, axis, (*cspan_at(&state, INT64_C(0) + axis)), velocity);
    friction_slopes(&by_velocity, &by_deflection, plant, axis, velocity, (*cspan_at(&state, INT64_C(10) + axis)));
    (*result_0) = by_position;
    (*result_1_0001) = by_velocity + damping;
    (*result_2) = by_deflection;
    return 0;
}
static double power_slope(array_double_1d plant, int64_t axis, array_double_1d state, array_double_1d action)
{
    double velocity;
    double force;
    double bound;
    velocity = (*cspan_at(&state, INT64_C(5) + axis));
    force = (*cspan_at(&action, INT64_C(0) + axis));
    bound = force_bound(plant, axis, force, velocity);
    if (((*cspan_at(&action, INT64_C(3) + axis)) < 0.5) || (bound == static_bound(plant, axis, force)))
    {
        return 0.0;
    }
    return (-force) / velocity;
}
static void add_damping(array_double_1d plant, array_double_1d by, array_double_1d row)
{
    int64_t j;
    double damped;
    for (j = INT64_C(0); j < INT64_C(2); j += INT64_C(1))
    {
        damped = (*cspan_at(&plant, INT64_C(46))) * (*cspan_at(&by, INT64_C(13) + j));
        (*cspan_at(&row, INT64_C(8) + j)) = (*cspan_at(&row, INT64_C(8) + j)) - damped;
    }
}
static void forced_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials)
{
    array_double_1d saturated;
    int64_t i;
    array_double_1d row;
    int64_t j;
    double by_force;
    double by_position;
    double slope;
    double by_deflection;
    double by_velocity;
    array_double_1d rope;
    int64_t hoist;
    int64_t velocity;
    double by_power;
    crane_rhs_partials(state, span_row(&rig, INT64_C(13)), span_row(&rig, INT64_C(15)), plant, work);
    saturated = span_row(&rig, INT64_C(14));
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        row = span_row(&partials, INT64_C(0) + i);
        for (j = INT64_C(0); j < INT64_C(10); j += INT64_C(1))
        {
            (*cspan_at(&row, j)) = (*cspan_at(&work, i, j));
        }
        for (j = INT64_C(0); j < INT64_C(3); j += INT64_C(1))
        {
            by_force = (*cspan_at(&work, i, INT64_C(10) + j));
            axis_slopes(&by_position, &slope, &by_deflection, plant, j, state);
            (*cspan_at(&row, INT64_C(0) + j)) = (*cspan_at(&row, INT64_C(0) + j)) - by_position * by_force;
            (*cspan_at(&row, INT64_C(5) + j)) = (*cspan_at(&row, INT64_C(5) + j)) - slope * by_force;
            (*cspan_at(&row, INT64_C(16) + j)) = (-by_deflection) * by_force;
            (*cspan_at(&row, INT64_C(13) + j)) = (*cspan_at(&work, i, INT64_C(15) + j));
            if ((*cspan_at(&saturated, INT64_C(3) + j)) < 0.5)
            {
                (*cspan_at(&row, INT64_C(10) + j)) = by_force;
            }
            by_velocity = by_force * power_slope(plant, j, state, saturated);
            (*cspan_at(&row, INT64_C(5) + j)) = (*cspan_at(&row, INT64_C(5) + j)) + by_velocity;
        }
        add_damping(plant, span_row(&work, i), row);
    }
    for (j = INT64_C(0); j < INT64_C(3); j += INT64_C(1))
    {
        if ((*cspan_at(&saturated, INT64_C(3) + j)) < 0.5)
        {
            (*cspan_at(&partials, INT64_C(5) + j, INT64_C(10) + j)) = 1.0;
        }
        by_velocity = power_slope(plant, j, state, saturated);
        (*cspan_at(&partials, INT64_C(5) + j, INT64_C(5) + j)) = by_velocity;
    }
    rope = span_row(&partials, INT64_C(8));
    hoist = INT64_C(10) + INT64_C(2);
    velocity = INT64_C(5) + INT64_C(2);
    (*cspan_at(&rope, hoist)) = (*cspan_at(&partials, INT64_C(5) + INT64_C(2), hoist));
    by_power = (*cspan_at(&partials, INT64_C(5) + INT64_C(2), velocity));
    axis_slopes(&by_position, &slope, &by_deflection, plant, INT64_C(2), state);
    (*cspan_at(&rope, INT64_C(0) + INT64_C(2))) = -by_position;
    (*cspan_at(&rope, velocity)) = by_power - slope;
    (*cspan_at(&rope, INT64_C(16) + INT64_C(2))) = -by_deflection;
}
static bool demand_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_1d command, array_double_2d partials)
{
    array_double_1d action;
    int64_t i;
    double lag;
    double largest;
    double demand;
    double fastest;
    bool clipped;
    bool bounded;
    action = span_row(&rig, INT64_C(14));
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        lag = (*cspan_at(&plant, INT64_C(19) + i));
        largest = force_bound(plant, i, (*cspan_at(&action, INT64_C(0) + i)), (*cspan_at(&state, INT64_C(5) + i)));
        demand = (*cspan_at(&command, i));
        fastest = velocity_bound(plant, i, demand);
        clipped = exceeds(demand, fastest);
        if (clipped)
        {
            demand = limited(demand, fastest);
        }
        demand = (demand - (*cspan_at(&state, INT64_C(5) + i))) / lag;
        bounded = exceeds(demand, acceleration_bound(plant, i, demand));
        if (((*cspan_at(&action, INT64_C(3) + i)) > 0.5) && (!(bounded || clipped)))
        {
            return 0;
        }
        if ((largest > 0.0) && (fabs((*cspan_at(&action, INT64_C(0) + i))) >= largest * (1.0 - 1e-09)))
        {
            return 0;
        }
        if (!bounded)
        {
            if (!clipped)
            {
                (*cspan_at(&partials, i, INT64_C(10) + i)) = 1.0 / lag;
            }
            (*cspan_at(&partials, i, INT64_C(5) + i)) = (-1.0) / lag;
        }
    }
    return 1;
}
static bool driven_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials)
{
    int64_t first;
    int64_t i;
    array_double_1d row;
    int64_t j;
    double by_drive;
    int64_t velocity;
    int64_t command;
    double hoist;
    double by_position;
    double slope;
    double by_deflection;
    array_double_1d force;
    if (!demand_partials(plant, state, rig, span_row(&rig, INT64_C(0)), partials))
    {
        return 0;
    }
    crane_driven_partials(state, span_row(&rig, INT64_C(18)), span_row(&rig, INT64_C(13)), span_row(&rig, INT64_C(15)), plant, work);
    first = INT64_C(0) + INT64_C(3);
    for (i = INT64_C(0); i < INT64_C(5); i += INT64_C(1))
    {
        row = span_row(&partials, first + i);
        for (j = INT64_C(0); j < INT64_C(10); j += INT64_C(1))
        {
            (*cspan_at(&row, j)) = (*cspan_at(&work, i, j));
        }
        for (j = INT64_C(0); j < INT64_C(3); j += INT64_C(1))
        {
            by_drive = (*cspan_at(&work, i, INT64_C(10) + j));
            velocity = INT64_C(5) + j;
            command = INT64_C(10) + j;
            (*cspan_at(&row, velocity)) = (*cspan_at(&row, velocity)) + by_drive * (*cspan_at(&partials, j, velocity));
            (*cspan_at(&row, command)) = by_drive * (*cspan_at(&partials, j, command));
            (*cspan_at(&row, INT64_C(13) + j)) = (*cspan_at(&work, i, INT64_C(15) + j));
        }
        add_damping(plant, span_row(&work, i), row);
    }
    for (j = INT64_C(0); j < INT64_C(20); j += INT64_C(1))
    {
        hoist = (*cspan_at(&partials, INT64_C(5) + INT64_C(2), j));
        (*cspan_at(&partials, INT64_C(8), j)) = hoist;
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        velocity = INT64_C(5) + i;
        axis_slopes(&by_position, &slope, &by_deflection, plant, i, state);
        force = span_row(&partials, INT64_C(5) + i);
        (*cspan_at(&force, INT64_C(0) + i)) = (*cspan_at(&force, INT64_C(0) + i)) + by_position;
        (*cspan_at(&force, velocity)) = (*cspan_at(&force, velocity)) + slope;
        (*cspan_at(&force, INT64_C(16) + i)) = by_deflection;
    }
    return 1;
}
static void power_partials(array_double_1d plant, array_double_1d state, array_double_2d rig, array_double_2d work, array_double_2d partials)
{
    array_double_1d drive;
    array_double_1d wind;
    array_double_1d lost;
    int64_t j;
    int64_t i;
    int64_t rate;
    double velocity;
    int64_t by_wind;
    double by_position;
    double slope;
    double by_deflection;
    double deflection;
    drive = span_row(&partials, INT64_C(9));
    wind = span_row(&partials, INT64_C(10));
    lost = span_row(&partials, INT64_C(11));
    segfmu_crane_load_partials(state, work);
    for (j = INT64_C(0); j < INT64_C(10); j += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&wind, j)) = (*cspan_at(&wind, j)) + (*cspan_at(&rig, INT64_C(15), i)) * (*cspan_at(&work, INT64_C(3) + i, j));
        }
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        rate = INT64_C(5) + i;
        velocity = (*cspan_at(&state, rate));
        for (j = INT64_C(0); j < INT64_C(19); j += INT64_C(1))
        {
            (*cspan_at(&drive, j)) = (*cspan_at(&drive, j)) + (*cspan_at(&partials, INT64_C(5) + i, j)) * velocity;
        }
        (*cspan_at(&drive, rate)) = (*cspan_at(&drive, rate)) + (*cspan_at(&rig, INT64_C(14), INT64_C(0) + i));
        by_wind = INT64_C(13) + i;
        for (j = INT64_C(5); j < INT64_C(10); j += INT64_C(1))
        {
            (*cspan_at(&wind, by_wind)) = (*cspan_at(&wind, by_wind)) + (*cspan_at(&work, INT64_C(3) + i, j)) * (*cspan_at(&state, j));
        }
        axis_slopes(&by_position, &slope, &by_deflection, plant, i, state);
        deflection = (*cspan_at(&state, INT64_C(10) + i));
        (*cspan_at(&lost, INT64_C(0) + i)) = by_position * velocity;
        (*cspan_at(&lost, rate)) = slope * velocity + (*cspan_at(&rig, INT64_C(19), i));
        (*cspan_at(&lost, INT64_C(16) + i)) = by_deflection * velocity;
        if (deflection_rate(plant, i, velocity, deflection) != 0.0)
        {
            (*cspan_at(&partials, INT64_C(12) + i, rate)) = 1.0;
        }
    }
    for (i = INT64_C(8); i < INT64_C(10); i += INT64_C(1))
    {
        (*cspan_at(&lost, i)) = 2.0 * (*cspan_at(&plant, INT64_C(46))) * (*cspan_at(&state, i));
    }
}
static void drag_partials(array_double_1d plant, array_double_1d air, array_double_2d work, array_double_2d partials)
{
    int64_t j;
    int64_t i;
    double slope;
    int64_t k;
    double along;
    int64_t row;
    double added;
    for (j = INT64_C(0); j < INT64_C(10); j += INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            slope = 0.0;
            for (k = INT64_C(0); k < INT64_C(3); k += INT64_C(1))
            {
                along = (*cspan_at(&work, INT64_C(3) + k, j));
                slope = slope - drag_slope(plant, air, i, k) * along;
            }
            for (row = INT64_C(0); row < INT64_C(15); row += INT64_C(1))
            {
                added = (*cspan_at(&partials, row, INT64_C(13) + i)) * slope;
                (*cspan_at(&partials, row, j)) = (*cspan_at(&partials, row, j)) + added;
            }
        }
    }
}
bool segfmu_rig_partials(array_double_2d components, double time, array_double_2d memory, array_double_2d work, array_double_2d partials)
{
    array_double_1d plant;
    array_double_1d state;
    array_double_2d rig;
    int64_t i;
    int64_t j;
    bool driven;
    array_double_1d row;
    double slope;
    double added;
    double correction;
    plant = span_row(&memory, INT64_C(5));
    state = span_row(&memory, INT64_C(4));
    rig = span_rows(&memory, INT64_C(14), INT64_C(14) + INT64_C(22));
    if (may_slacken(plant) && ((*cspan_at(&rig, INT64_C(14), INT64_C(6))) >= 0.0))
    {
        return 0;
    }
    for (i = INT64_C(0); i < INT64_C(15); i += INT64_C(1))
    {
        for (j = INT64_C(0); j < INT64_C(20); j += INT64_C(1))
        {
            (*cspan_at(&partials, i, j)) = 0.0;
        }
    }
    for (i = INT64_C(0); i < INT64_C(6); i += INT64_C(1))
    {
        for (j = INT64_C(0); j < INT64_C(18); j += INT64_C(1))
        {
            (*cspan_at(&work, i, j)) = 0.0;
        }
    }
    driven = is_driven(memory);
    if (driven)
    {
        if (!driven_partials(plant, state, rig, work, partials))
        {
            return 0;
        }
    }
    else
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            if (at_velocity_bound(plant, i, state))
            {
                return 0;
            }
        }
        forced_partials(plant, state, rig, work, partials);
    }
    power_partials(plant, state, rig, work, partials);
    wind_rates(plant, components, (*cspan_at(&memory, INT64_C(6), INT64_C(0))) + time, span_row(&rig, INT64_C(21)));
    if ((*cspan_at(&plant, INT64_C(74))) > 0.0)
    {
        drag_partials(plant, span_row(&rig, INT64_C(21)), work, partials);
    }
    for (i = INT64_C(0); i < INT64_C(15); i += INT64_C(1))
    {
        row = span_row(&partials, i);
        for (j = INT64_C(0); j < INT64_C(3); j += INT64_C(1))
        {
            slope = (*cspan_at(&rig, INT64_C(21), INT64_C(6) + j));
            added = (*cspan_at(&row, INT64_C(19))) + (*cspan_at(&row, INT64_C(13) + j)) * slope;
            if (driven)
            {
                correction = (*cspan_at(&memory, INT64_C(3), INT64_C(0) + j));
                added = added + (*cspan_at(&row, INT64_C(10) + j)) * correction;
            }
            (*cspan_at(&row, INT64_C(19))) = added;
        }
    }
    return 1;
}
int64_t segfmu_check_travel(array_double_1d least, array_double_1d greatest, array_double_1d fault)
{
    int64_t axis;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        if (!((*cspan_at(&least, axis)) < (*cspan_at(&greatest, axis))))
        {
            (*cspan_at(&fault, INT64_C(0))) = axis;
            (*cspan_at(&fault, INT64_C(2))) = (*cspan_at(&least, axis));
            (*cspan_at(&fault, INT64_C(3))) = (*cspan_at(&greatest, axis));
            return INT64_C(1);
        }
    }
    return INT64_C(0);
}
int64_t segfmu_check_lags(array_double_1d plant, int64_t exchange, array_double_1d fault)
{
    int64_t axis;
    double lag;
    (*cspan_at(&fault, INT64_C(3))) = 1e-05;
    if ((int64_t)((*cspan_at(&plant, INT64_C(18)))) == INT64_C(1))
    {
        for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
        {
            lag = (*cspan_at(&plant, INT64_C(19) + axis));
            (*cspan_at(&fault, INT64_C(1))) = axis;
            (*cspan_at(&fault, INT64_C(2))) = lag;
            if ((lag == 0.0) && (exchange == INT64_C(1)))
            {
                return INT64_C(2);
            }
            if ((lag > 0.0) && (lag < (*cspan_at(&fault, INT64_C(3)))))
            {
                return INT64_C(16);
            }
        }
    }
    return INT64_C(0);
}
int64_t segfmu_check_friction(array_double_1d static_0001, array_double_1d coulomb, array_double_1d fault)
{
    int64_t axis;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        if (((*cspan_at(&static_0001, axis)) > 0.0) && ((*cspan_at(&static_0001, axis)) < (*cspan_at(&coulomb, axis))))
        {
            (*cspan_at(&fault, INT64_C(1))) = axis;
            (*cspan_at(&fault, INT64_C(2))) = (*cspan_at(&static_0001, axis));
            (*cspan_at(&fault, INT64_C(3))) = (*cspan_at(&coulomb, axis));
            return INT64_C(12);
        }
    }
    return INT64_C(0);
}
double segfmu_wind_speed(array_double_1d speed)
{
    double squares;
    int64_t i;
    squares = 0.0;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        squares = squares + (*cspan_at(&speed, i)) * (*cspan_at(&speed, i));
    }
    return sqrt(squares);
}
int64_t segfmu_check_turbulence(array_double_1d speed, array_double_1d deviation, array_double_1d fault)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&fault, INT64_C(2))) = (*cspan_at(&deviation, i));
        if (((*cspan_at(&deviation, i)) > 0.0) && (segfmu_wind_speed(speed) == 0.0))
        {
            return INT64_C(13);
        }
    }
    return INT64_C(0);
}
int64_t segfmu_check_slack(array_double_1d plant, int64_t exchange, array_double_1d fault)
{
    (*cspan_at(&fault, INT64_C(2))) = (*cspan_at(&plant, INT64_C(76)));
    if ((exchange == INT64_C(1)) && may_slacken(plant))
    {
        return INT64_C(14);
    }
    return INT64_C(0);
}
int64_t segfmu_check_delays(array_double_1d plant, double period, int64_t exchange, array_double_1d fault)
{
    int64_t axis;
    double late;
    for (axis = INT64_C(0); axis < INT64_C(3); axis += INT64_C(1))
    {
        late = (*cspan_at(&plant, INT64_C(43) + axis));
        (*cspan_at(&fault, INT64_C(1))) = axis;
        (*cspan_at(&fault, INT64_C(2))) = late;
        (*cspan_at(&fault, INT64_C(3))) = period;
        if ((exchange == INT64_C(1)) && (late > 0.0))
        {
            return INT64_C(11);
        }
        if (late > INT64_C(100000) * period)
        {
            return INT64_C(10);
        }
    }
    return INT64_C(0);
}
int64_t segfmu_check_sensors(array_double_1d sensors, array_double_1d fault)
{
    double sample_time;
    double dead_time;
    double noise;
    int64_t i;
    sample_time = (*cspan_at(&sensors, INT64_C(0)));
    dead_time = (*cspan_at(&sensors, INT64_C(1)));
    noise = 0.0;
    for (i = INT64_C(0); i < INT64_C(13) - INT64_C(8); i += INT64_C(1))
    {
        noise = noise + (*cspan_at(&sensors, INT64_C(8) + i));
    }
    if ((sample_time == 0.0) && ((dead_time > 0.0) || (noise > 0.0)))
    {
        return INT64_C(3);
    }
    (*cspan_at(&fault, INT64_C(2))) = sample_time;
    (*cspan_at(&fault, INT64_C(3))) = 1e-06;
    if ((sample_time > 0.0) && (sample_time < (*cspan_at(&fault, INT64_C(3)))))
    {
        return INT64_C(4);
    }
    (*cspan_at(&fault, INT64_C(2))) = dead_time;
    (*cspan_at(&fault, INT64_C(3))) = sample_time;
    if (dead_time > INT64_C(100000) * sample_time)
    {
        return INT64_C(5);
    }
    return INT64_C(0);
}
int64_t segfmu_check_rope_bounds(double length, double shortest, double longest, array_double_1d fault)
{
    (*cspan_at(&fault, INT64_C(2))) = length;
    if (!(length > 0.0))
    {
        return INT64_C(6);
    }
    (*cspan_at(&fault, INT64_C(2))) = shortest;
    (*cspan_at(&fault, INT64_C(3))) = longest;
    if ((longest > 0.0) && (!(shortest < longest)))
    {
        return INT64_C(7);
    }
    return INT64_C(0);
}
int64_t segfmu_check_lengths(array_double_1d lengths, array_double_1d fault)
{
    double shortest;
    double longest;
    shortest = (*cspan_at(&lengths, INT64_C(0)));
    longest = (*cspan_at(&lengths, INT64_C(1)));
    (*cspan_at(&fault, INT64_C(2))) = shortest;
    (*cspan_at(&fault, INT64_C(3))) = longest;
    if (!((shortest > 0.0) && (shortest <= longest) && (longest <= 1.7976931348623157e+308)))
    {
        return INT64_C(8);
    }
    return INT64_C(0);
}
void segfmu_start_state(array_double_1d own, array_double_1d held, array_double_1d reference, array_double_1d state)
{
    bool none;
    int64_t i;
    bool there;
    none = (*cspan_at(&reference, INT64_C(0) + INT64_C(2))) <= 0.0;
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        there = fabs((*cspan_at(&own, i)) - (*cspan_at(&reference, i))) <= 1e-09 * (1.0 + fabs((*cspan_at(&own, i))));
        if (none || there || ((*cspan_at(&reference, i)) == (*cspan_at(&held, i))))
        {
            (*cspan_at(&state, i)) = (*cspan_at(&own, i));
        }
        else
        {
            (*cspan_at(&state, i)) = (*cspan_at(&reference, i)) + ((*cspan_at(&own, i)) - (*cspan_at(&held, i)));
        }
    }
}
int64_t segfmu_check_start(array_double_1d state, array_double_1d reference, array_double_1d fault)
{
    int64_t rope;
    int64_t i;
    rope = INT64_C(0) + INT64_C(2);
    (*cspan_at(&fault, INT64_C(0))) = rope;
    (*cspan_at(&fault, INT64_C(1))) = (*cspan_at(&state, rope));
    (*cspan_at(&fault, INT64_C(2))) = (*cspan_at(&reference, rope));
    if (!((*cspan_at(&state, rope)) > 0.0))
    {
        return INT64_C(1);
    }
    for (i = INT64_C(3); i < INT64_C(5); i += INT64_C(1))
    {
        (*cspan_at(&fault, INT64_C(0))) = i;
        (*cspan_at(&fault, INT64_C(1))) = (*cspan_at(&state, i));
        if (!(fabs((*cspan_at(&state, i))) < 1.5707963267948966))
        {
            return INT64_C(2);
        }
    }
    return INT64_C(0);
}
int64_t segfmu_judge_start(array_double_1d state, array_double_1d reference, double gravity, array_double_1d fault)
{
    double length;
    double farthest;
    int64_t i;
    double scale;
    double distance;
    int64_t status;
    length = (*cspan_at(&reference, INT64_C(0) + INT64_C(2)));
    if (length <= 0.0)
    {
        return INT64_C(0);
    }
    farthest = 1.0;
    status = INT64_C(0);
    for (i = INT64_C(0); i < INT64_C(10); i += INT64_C(1))
    {
        scale = 0.8;
        if ((i < INT64_C(3)) || ((i >= INT64_C(5)) && (i < INT64_C(8))))
        {
            scale = 0.25 * length;
        }
        if (i >= INT64_C(5))
        {
            scale = scale * sqrt(gravity / length);
        }
        distance = fabs((*cspan_at(&state, i)) - (*cspan_at(&reference, i))) / scale;
        if (distance > farthest)
        {
            farthest = distance;
            (*cspan_at(&fault, INT64_C(0))) = i;
            (*cspan_at(&fault, INT64_C(1))) = (*cspan_at(&state, i));
            (*cspan_at(&fault, INT64_C(2))) = (*cspan_at(&reference, i));
            status = INT64_C(3);
        }
    }
    return status;
}
int64_t segfmu_check_start_rope(double length, double shortest, double longest, array_double_1d fault)
{
    (*cspan_at(&fault, INT64_C(0))) = INT64_C(0) + INT64_C(2);
    (*cspan_at(&fault, INT64_C(1))) = length;
    (*cspan_at(&fault, INT64_C(2))) = shortest;
    if (length < shortest)
    {
        return INT64_C(5);
    }
    (*cspan_at(&fault, INT64_C(2))) = longest;
    if ((longest > 0.0) && (length > longest))
    {
        return INT64_C(5);
    }
    return INT64_C(0);
}
int64_t segfmu_is_elsewhere(array_double_1d before, array_double_1d reference, double step)
{
    int64_t i;
    double moved;
    double small;
    if ((*cspan_at(&reference, INT64_C(0) + INT64_C(2))) <= 0.0)
    {
        return INT64_C(0);
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        moved = 2.0 * step * fabs((*cspan_at(&reference, INT64_C(5) + i)));
        small = 0.001 * fabs((*cspan_at(&reference, INT64_C(0) + INT64_C(2))));
        if (fabs((*cspan_at(&reference, INT64_C(0) + i)) - (*cspan_at(&before, INT64_C(0) + i))) > moved + small)
        {
            return INT64_C(1);
        }
    }
    return INT64_C(0);
}
int64_t segfmu_expand_motion(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work)
{
    double tolerance;
    int64_t wrong;
    if (segfmu_count_pieces(axes, cells) > timing.shape[INT64_C(0)])
    {
        return INT64_C(1);
    }
    segfmu_expand_plan(states, dwells, axes, cells, timing, coefficients, offsets, times, span_rows(&work, INT64_C(242), INT64_C(246)));
    tolerance = (*cspan_at(&work, INT64_C(1), INT64_C(0)));
    wrong = segfmu_check_plan(states, times, timing, coefficients, offsets, limits, lower, tolerance, 0.5 * tolerance, span_rows(&work, INT64_C(246), INT64_C(294)));
    if (wrong > INT64_C(0))
    {
        return -INT64_C(12);
    }
    return INT64_C(0);
}
int64_t segfmu_plan_motion(array_double_3d states, array_double_1d dwells, array_double_2d limits, array_double_2d lower, array_double_2d axes, array_double_3d cells, array_double_2d timing, array_double_2d coefficients, array_int64_t_1d offsets, array_double_2d times, array_double_2d work)
{
    array_double_2d planner;
    int64_t status;
    planner = span_rows(&work, INT64_C(2), INT64_C(242));
    status = segfmu_check_problem(states, limits, span_row(&planner, INT64_C(99)));
    if (status == INT64_C(0))
    {
        status = segfmu_plan_phases(states, dwells, limits, lower, span_row(&work, INT64_C(0)), axes, cells, planner);
    }
    if (status == INT64_C(0))
    {
        status = segfmu_expand_motion(states, dwells, limits, lower, axes, cells, timing, coefficients, offsets, times, work);
    }
    return status;
}
