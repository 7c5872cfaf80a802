/* Planner and flat inverse: the plan from the parameters, and how the block keeps it. */
#include <math.h>
#include <string.h>

#include "feedforward.h"

static void move(double **to, const void *from, int64_t count)
{
    memmove(*to, from, (size_t)count * sizeof **to);
    *to += count;
}

/* Move the part of the planner's work space that evaluation needs to its beginning. */
static void compact(feedforward *m, const segfmu_trajectory *found)
{
    double *to = m->space;
    move(&to, found->timing, found->pieces * 2);
    move(&to, found->coefficients, found->pieces * 2 * found->smoothness);
    move(&to, found->offsets, AXES + 1);
    move(&to, found->times, found->points * AXES);
    move(&to, found->ends, AXES);
    m->points = found->points;
    m->smoothness = found->smoothness;
    m->pieces = found->pieces;
    m->duration = found->duration;
}

segfmu_trajectory feedforward_trajectory(const feedforward *m)
{
    return m->operating ? operation_trajectory(m) : mission_trajectory(m);
}

segfmu_trajectory mission_trajectory(const feedforward *m)
{
    segfmu_trajectory t = {0};
    t.points = m->points;
    t.axes = AXES;
    t.smoothness = m->smoothness;
    t.pieces = m->pieces;
    t.duration = m->duration;
    t.timing = m->space;
    t.coefficients = t.timing + m->pieces * 2;
    t.offsets = (const int64_t *)(const void *)(t.coefficients + m->pieces * 2 * m->smoothness);
    t.times = (const double *)(const void *)(t.offsets + AXES + 1);
    t.ends = t.times + m->points * AXES;
    return t;
}

double feedforward_start(const feedforward *m)
{
    return segfmu_begin_time(m->base.real[V_PLANNER_START_TIME], m->base.start);
}

static size_t planned_size(const feedforward *m)
{
    return (size_t)(m->pieces * (2 + 2 * m->smoothness) + AXES + 1 + m->points * AXES + AXES);
}

static array_double_3d contacts(const feedforward *m)
{
    return cuboid((double *)m->space + planned_size(m), AXES_SIZE, m->rows, CONTACT_SIZE);
}

static array_double_2d contacts_of(const feedforward *m, int axis)
{
    return matrix(contacts(m).data + axis * m->rows * CONTACT_SIZE, m->rows, CONTACT_SIZE);
}

/* The histories of all contacts, in what the planner has left of the block. */
static bool note_contacts(feedforward *m, char message[MESSAGE])
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    double known[RESISTANCE_SIZE], work[CONTACT_WORK_SIZE * CONTACT_WORK_COLUMNS];
    double fault[SETUP_FAULT_SIZE] = {0.0};
    int64_t longest = 0, rubbing = 0;
    crane_of(&m->base, known);
    for (int i = 0; i < AXES_SIZE; i++) {
        rubbing += segfmu_resists(vector(known, RESISTANCE_SIZE), i);
    }
    int64_t status = segfmu_check_friction(
        vector(known + RESISTANCE_STATIC, AXES_SIZE), vector(known + RESISTANCE_COULOMB, AXES_SIZE),
        vector(fault, SETUP_FAULT_SIZE));
    size_t left = segfmu_plan_size(m->points, AXES, m->smoothness) - planned_size(m);
    m->rows = rubbing > 0 ? (int64_t)(left / (AXES_SIZE * CONTACT_SIZE)) : 1;
    for (int i = 0; i < AXES_SIZE && status == SETUP_STATUS_FITS; i++) {
        int64_t rows = segfmu_contact_history(
            i, timing_of(&t), matrix((double *)t.coefficients, t.pieces, 2 * t.smoothness),
            offsets_of(&t), vector((double *)t.ends, AXES), vector(known, RESISTANCE_SIZE),
            matrix(work, CONTACT_WORK_SIZE, CONTACT_WORK_COLUMNS), contacts_of(m, i));
        m->turns[i] = segfmu_resists(vector(known, RESISTANCE_SIZE), i) ? rows : 0;
        longest = rows > longest ? rows : longest;
        fault[SETUP_FAULT_DRIVE] = i;
        status = rows > 0 ? SETUP_STATUS_FITS : SETUP_STATUS_MANY_TURNS;
    }
    double *to = contacts(m).data;
    for (int i = 0; i < AXES_SIZE; i++) {
        move(&to, contacts_of(m, i).data, longest * CONTACT_SIZE);
    }
    m->rows = longest;
    return !segfmu_setup_message(status, fault, message, MESSAGE);
}

void measure(feedforward *m, bool exact, double *peaks, double *times)
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    double known[RESISTANCE_SIZE], work[DEMAND_PEAKS_SIZE * DEMAND_PEAKS_COLUMNS];
    crane_of(&m->base, known);
    const array_double_2d pieces = matrix((double *)t.coefficients, t.pieces, 2 * t.smoothness);
    const array_double_1d ends = vector((double *)t.ends, AXES), crane = vector(known, RESISTANCE_SIZE);
    const array_double_2d space = matrix(work, DEMAND_PEAKS_SIZE, DEMAND_PEAKS_COLUMNS);
    const array_double_2d found = matrix(peaks, 2, DEMAND_SIZE), when = matrix(times, 2, DEMAND_SIZE);
    if (exact) {
        segfmu_demand_peaks(
            timing_of(&t), pieces, offsets_of(&t), ends, crane, contacts(m), space, found, when);
    } else {
        segfmu_demand_samples(
            timing_of(&t), pieces, offsets_of(&t), ends, crane, contacts(m), space, found, when);
    }
}

/* What demands use of the bounds of the drives; a `BoundStatus`. */
static int64_t write_uses(
    const feedforward *m, double *peaks, double *times, double uses[BOUND_USES_SIZE],
    double fault[BOUND_FAULT_SIZE])
{
    double bounds[DRIVE_BOUNDS_SIZE];
    feed_record(&feeds_drive_bounds, &m->base, bounds);
    return segfmu_bound_uses(
        matrix(peaks, 2, DEMAND_SIZE), matrix(times, 2, DEMAND_SIZE),
        vector(bounds, DRIVE_BOUNDS_SIZE), vector(uses, BOUND_USES_SIZE),
        vector(fault, BOUND_FAULT_SIZE));
}

/* What the plan uses of them. */
static int64_t note_uses(feedforward *m, double uses[BOUND_USES_SIZE], double fault[BOUND_FAULT_SIZE])
{
    double bounds[DRIVE_BOUNDS_SIZE], peaks[2 * DEMAND_SIZE] = {0.0}, times[2 * DEMAND_SIZE] = {0.0};
    feed_record(&feeds_drive_bounds, &m->base, bounds);
    if (segfmu_has_bounds(0, DEMAND_SIZE, vector(bounds, DRIVE_BOUNDS_SIZE))) {
        measure(m, true, peaks, times);
    }
    return write_uses(m, peaks, times, uses, fault);
}

static void note_events(feedforward *m, const segfmu_trajectory *found)
{
    const double start = feedforward_start(m);
    for (int64_t i = 1; i < m->points; i++) {
        double last = 0.0;
        for (int axis = 0; axis < AXES; axis++) {
            last = fmax(last, found->times[i * AXES + axis]);
        }
        m->events[i - 1] = start + last;
    }
    m->events[m->points - 1] = start + m->duration;
}

/* The given limits at a pace. */
static void gather_limits(const model *base, double pace, request *r)
{
    feed_record(&feeds_load_limits, base, r->limits);
    feed_record(&feeds_lower_limits, base, r->lower);
    for (int axis = 0; axis < AXES; axis++) {
        double power = 1.0;
        for (int i = 0; i < LIMITS; i++) {
            power *= pace;
            r->limits[axis * LIMITS + i] *= power;
        }
    }
    for (int i = 0; i < LOWER_LIMITS_SIZE; i++) {
        r->lower[i] *= i % 2 == 0 ? pace : pace * pace;
    }
    r->timed = true;
}

/* The states of the waypoints, those that are free being chosen within the given limits. */
static void gather_chosen(feedforward *m, request *r)
{
    gather_limits(&m->base, 1.0, r);
    for (int64_t i = 0; i < m->base.integer[V_WAYPOINT_COUNT] * AXES; i++) {
        r->velocity[i] = m->base.real[V_WAYPOINT_VELOCITY + i];
        r->acceleration[i] = m->base.real[V_WAYPOINT_ACCELERATION + i];
    }
    choose_free_states(m, r);
}

/* The same at a pace. */
static void pace_states(const request *chosen, int64_t points, double pace, request *r)
{
    for (int64_t i = 0; i < points * AXES; i++) {
        r->velocity[i] = pace * chosen->velocity[i];
        r->acceleration[i] = pace * pace * chosen->acceleration[i];
    }
}

/* Show the limits that a plan has. */
static void show_limits(model *base, const request *r)
{
    enum { LEAST = LIMIT_ROW_SIZE - LIMIT_ROW_VELOCITY_MIN };
    double found[PLAN_LIMITS_SIZE];
    for (int axis = 0; axis < AXES; axis++) {
        double *row = found + axis * LIMIT_ROW_SIZE;
        memcpy(row, r->limits + axis * LIMITS, LIMITS * sizeof *row);
        for (int i = 0; i < LEAST; i++) {
            const double least = r->lower[axis * LEAST + i];
            row[LIMIT_ROW_VELOCITY_MIN + i] = least < 0.0 ? least : -row[i];
        }
    }
    show_record(&feeds_plan_limits, found, base);
}

bool require_space(feedforward *m, char message[MESSAGE])
{
    enum { BOXES = SPACE_LIMITS_FACES + SPACE_LIMITS_OBSTACLES };
    const segfmu_trajectory t = feedforward_trajectory(m);
    const int64_t width = 2 * t.smoothness, rows = 4 * width - 5, columns = 2 * width - 3;
    double space[SPACE_SIZE], obstacles[SPACE_LIMITS_OBSTACLES * OBSTACLE_ROW_SIZE];
    double ranges[RANGES_SIZE * AXES], fault[SPACE_FAULT_SIZE] = {0.0};
    double *left = m->space + planned_size(m);
    array_double_2d boxes = matrix(take(&left, BOXES * BOX_SIZE), BOXES, BOX_SIZE);
    array_double_2d work = matrix(take(&left, ROPE_WORK_SIZE * rows), ROPE_WORK_SIZE, rows);
    feed_record(&feeds_space, &m->base, space);
    for (int64_t i = 0; i < SPACE_LIMITS_OBSTACLES; i++) {
        feed_row(&feeds_obstacle_row, &m->base, i, obstacles + i * OBSTACLE_ROW_SIZE);
    }
    int64_t status = segfmu_space_contact(
        timing_of(&t), matrix((double *)t.coefficients, t.pieces, width), offsets_of(&t),
        vector(space, SPACE_SIZE), matrix(obstacles, SPACE_LIMITS_OBSTACLES, OBSTACLE_ROW_SIZE),
        boxes, work, cuboid(left, STACK_ROWS, SPAN_SIZE, columns),
        matrix(ranges, RANGES_SIZE, AXES), true, vector(fault, SPACE_FAULT_SIZE));
    return !segfmu_space_message(status, fault, message, MESSAGE) && note_contacts(m, message);
}

bool plan_at(feedforward *m, const request *r, char message[MESSAGE])
{
    return plan_loosely(m, r, message) && require_taut_plan(m, message);
}

bool require_taut_plan(const feedforward *m, char message[MESSAGE])
{
    const segfmu_trajectory t = mission_trajectory(m);
    return require_taut(&t, &m->base, message);
}

bool plan_loosely(feedforward *m, const request *r, char message[MESSAGE])
{
    const double *real = m->base.real;
    double limits[AXES * (MOST_SMOOTHNESS + 1)] = {0.0}, lower[LOWER_LIMITS_SIZE];
    double options[PLAN_OPTIONS_SIZE];
    feed_record(&feeds_plan_options, &m->base, options);
    segfmu_problem problem = {
        m->base.integer[V_WAYPOINT_COUNT], AXES, (int64_t)options[PLAN_OPTIONS_SMOOTHNESS],
        (int64_t)options[PLAN_OPTIONS_SHAPE], (int64_t)options[PLAN_OPTIONS_SYNCHRONIZATION],
        r->timed ? options[PLAN_OPTIONS_SAMPLE_TIME] : 0.0,
        r->timed ? options[PLAN_OPTIONS_DURATION] : 0.0,
        &real[V_WAYPOINT_POSITION], r->velocity, r->acceleration, &real[V_WAYPOINT_DWELL], limits, lower
    };
    segfmu_trajectory found;
    for (int axis = 0; axis < AXES; axis++) {
        const double *own = r->limits + axis * LIMITS;
        memcpy(limits + axis * (problem.smoothness + 1), own, LIMITS * sizeof *own);
    }
    for (int i = 0; i < LOWER_LIMITS_SIZE; i++) {
        lower[i] = -r->lower[i];
    }
    int status = segfmu_plan(&problem, m->space, &found);
    if (segfmu_plan_message(status, found.report, message, MESSAGE)) {
        return false;
    }
    compact(m, &found);
    show_limits(&m->base, r);
    return note_contacts(m, message);
}

/* The plan with the given limits, slower if it may be. */
static bool plan_as_given(feedforward *m, char message[MESSAGE])
{
    double pace[PACE_SIZE], uses[BOUND_USES_SIZE], fault[BOUND_FAULT_SIZE];
    const bool slows = m->base.integer[V_PLANNER_SLOWS_DOWN] && !m->base.integer[V_PLANNER_FINDS_LIMITS];
    int64_t status;
    request chosen, r;
    gather_chosen(m, &chosen);
    segfmu_begin_pace(1.0, FULL, vector(pace, PACE_SIZE));
    do {
        gather_limits(&m->base, pace[PACE_PACE], &r);
        pace_states(&chosen, m->base.integer[V_WAYPOINT_COUNT], pace[PACE_PACE], &r);
        if (!plan_at(m, &r, message) || !require_space(m, message)) {
            return false;
        }
        status = note_uses(m, uses, fault);
    } while (slows && segfmu_next_pace(
        segfmu_paced_use(vector(uses, BOUND_USES_SIZE)), vector(pace, PACE_SIZE)));
    show_record(&feeds_bound_uses, uses, &m->base);
    show_record(&feeds_pace, pace, &m->base);
    return !segfmu_bound_message(status, fault, message, MESSAGE);
}

/* Whether limits are given with which a motion can be planned. */
static bool has_limits(const model *base)
{
    request r;
    gather_limits(base, 1.0, &r);
    for (int axis = 0; axis < AXES; axis++) {
        if (r.limits[axis * LIMITS] <= 0.0 || r.limits[axis * LIMITS + 1] <= 0.0) {
            return false;
        }
    }
    return true;
}

/* The plan with limits that are found where those given do not keep the bounds. */
static bool plan_as_found(feedforward *m, char message[MESSAGE])
{
    double uses[BOUND_USES_SIZE], fault[BOUND_FAULT_SIZE];
    double peaks[2 * DEMAND_SIZE], times[2 * DEMAND_SIZE];
    char found[MESSAGE] = "";
    const bool given = has_limits(&m->base);
    if (given && plan_as_given(m, message)) {
        return true;
    }
    if (!feedforward_limits(m, peaks, times, given ? found : message)) {
        return false;
    }
    int64_t status = write_uses(m, peaks, times, uses, fault);
    show_record(&feeds_bound_uses, uses, &m->base);
    return !segfmu_bound_message(status, fault, message, MESSAGE);
}

/* Check that there is room between the end stops of each axis. */
static bool require_travel(const model *base, char message[MESSAGE])
{
    double bounds[DRIVE_BOUNDS_SIZE], fault[SETUP_FAULT_SIZE] = {0.0};
    feed_record(&feeds_drive_bounds, base, bounds);
    int64_t status = segfmu_check_travel(
        vector(bounds + DRIVE_BOUNDS_TRAVEL_MIN, AXES_SIZE),
        vector(bounds + DRIVE_BOUNDS_TRAVEL_MAX, AXES_SIZE), vector(fault, SETUP_FAULT_SIZE));
    return !segfmu_setup_message(status, fault, message, MESSAGE);
}

bool feedforward_plan(feedforward *m, char message[MESSAGE])
{
    const bool finds = m->base.integer[V_PLANNER_FINDS_LIMITS];
    m->base.real[V_PLAN_PACE] = 1.0;
    if (!require_travel(&m->base, message)) {
        return false;
    }
    if (!(finds ? plan_as_found(m, message) : plan_as_given(m, message))) {
        return false;
    }
    const segfmu_trajectory plan = feedforward_trajectory(m);
    note_events(m, &plan);
    return true;
}
