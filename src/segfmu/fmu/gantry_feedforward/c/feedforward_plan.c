/* GantryFeedforward: the plan from the parameters, and how the block keeps it. */
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
    feed_record(&feeds_resistance, &m->base, known);
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

/* What the plan uses of the bounds of the drives; a `BoundStatus`. */
static int64_t note_uses(feedforward *m, double uses[BOUND_USES_SIZE], double fault[BOUND_FAULT_SIZE])
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    double bounds[DRIVE_BOUNDS_SIZE], known[RESISTANCE_SIZE];
    double work[DEMAND_PEAKS_SIZE * DEMAND_PEAKS_COLUMNS];
    double space[2][2 * DEMAND_SIZE] = {{0.0}};
    array_double_2d peaks = matrix(space[0], 2, DEMAND_SIZE), times = matrix(space[1], 2, DEMAND_SIZE);
    bool bounded = false;
    feed_record(&feeds_drive_bounds, &m->base, bounds);
    for (int i = 0; i < DRIVE_BOUNDS_SIZE; i++) {
        bounded = bounded || bounds[i] != 0.0;
    }
    if (bounded) {
        feed_record(&feeds_resistance, &m->base, known);
        segfmu_demand_peaks(
            timing_of(&t), matrix((double *)t.coefficients, t.pieces, 2 * t.smoothness),
            offsets_of(&t), vector((double *)t.ends, AXES), vector(known, RESISTANCE_SIZE),
            contacts(m), matrix(work, DEMAND_PEAKS_SIZE, DEMAND_PEAKS_COLUMNS), peaks, times);
    }
    return segfmu_bound_uses(
        peaks, times, vector(bounds, DRIVE_BOUNDS_SIZE), vector(uses, BOUND_USES_SIZE),
        vector(fault, BOUND_FAULT_SIZE));
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

/* Limits at a pace as the planner takes them, (axes, n + 1). */
static void gather_limits(const model *base, int64_t smoothness, double pace, double *table)
{
    double limits[LOAD_LIMITS_SIZE];
    feed_record(&feeds_load_limits, base, limits);
    for (int axis = 0; axis < AXES; axis++) {
        double power = 1.0;
        for (int64_t i = 0; i <= smoothness; i++) {
            power *= pace;
            table[axis * (smoothness + 1) + i] = i < LIMITS ? power * limits[axis * LIMITS + i] : 0.0;
        }
    }
}

/* Magnitudes of the limits in the negative direction, (axes, 2). */
static void gather_lower(const model *base, double pace, double *lower)
{
    feed_record(&feeds_lower_limits, base, lower);
    for (int i = 0; i < LOWER_LIMITS_SIZE; i++) {
        lower[i] *= i % 2 == 0 ? -pace : -pace * pace;
    }
}

/* Check that the load stays below the trolley, the rope taut, and its length within its range. */
static bool require_rope(const segfmu_trajectory *t, const model *base, char message[MESSAGE])
{
    enum { MOST_WIDTH = 2 * MOST_SMOOTHNESS, MOST_COLUMNS = 4 * MOST_WIDTH - 5 };
    const int64_t width = 2 * t->smoothness;
    double space[ROPE_WORK_SIZE * MOST_COLUMNS];
    double fault[ROPE_FAULT_SIZE], bounds[ROPE_BOUNDS_SIZE];
    feed_record(&feeds_rope_bounds, base, bounds);
    int64_t status = segfmu_check_rope(
        matrix((double *)t->timing, t->pieces, 2),
        matrix((double *)t->coefficients, t->pieces, width), offsets_of(t),
        vector(bounds, ROPE_BOUNDS_SIZE), matrix(space, ROPE_WORK_SIZE, 4 * width - 5),
        vector(fault, ROPE_FAULT_SIZE));
    return !segfmu_rope_message(status, fault, message, MESSAGE);
}

/* Check that load and rope keep to the workspace and off the obstacles; works in what the planner has
   left of the block, which is more than this needs. */
static bool require_space(feedforward *m, char message[MESSAGE])
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
        matrix(ranges, RANGES_SIZE, AXES), vector(fault, SPACE_FAULT_SIZE));
    return !segfmu_space_message(status, fault, message, MESSAGE);
}

/* Plan at a pace; false with a message where that cannot be done. */
static bool plan_at(feedforward *m, double pace, char message[MESSAGE])
{
    const double *real = m->base.real;
    double limits[AXES * (MOST_SMOOTHNESS + 1)], lower[LOWER_LIMITS_SIZE];
    double velocity[MOST_POINTS * AXES], acceleration[MOST_POINTS * AXES];
    double options[PLAN_OPTIONS_SIZE];
    feed_record(&feeds_plan_options, &m->base, options);
    segfmu_problem problem = {
        m->base.integer[V_WAYPOINT_COUNT], AXES, (int64_t)options[PLAN_OPTIONS_SMOOTHNESS],
        (int64_t)options[PLAN_OPTIONS_SHAPE], (int64_t)options[PLAN_OPTIONS_SYNCHRONIZATION],
        options[PLAN_OPTIONS_SAMPLE_TIME], options[PLAN_OPTIONS_DURATION],
        &real[V_WAYPOINT_POSITION], velocity, acceleration, &real[V_WAYPOINT_DWELL], limits, lower
    };
    segfmu_trajectory found;
    for (int64_t i = 0; i < problem.points * AXES; i++) {
        velocity[i] = pace * real[V_WAYPOINT_VELOCITY + i];
        acceleration[i] = pace * pace * real[V_WAYPOINT_ACCELERATION + i];
    }
    gather_limits(&m->base, problem.smoothness, pace, limits);
    gather_lower(&m->base, pace, lower);
    int status = segfmu_plan(&problem, m->space, &found);
    if (segfmu_plan_message(status, found.report, message, MESSAGE)
        || !require_rope(&found, &m->base, message)) {
        return false;
    }
    compact(m, &found);
    return require_space(m, message) && note_contacts(m, message);
}

bool feedforward_plan(feedforward *m, char message[MESSAGE])
{
    double pace[PACE_SIZE], uses[BOUND_USES_SIZE], fault[BOUND_FAULT_SIZE], most;
    int64_t status;
    segfmu_begin_pace(vector(pace, PACE_SIZE));
    do {
        if (!plan_at(m, pace[PACE_PACE], message)) {
            return false;
        }
        status = note_uses(m, uses, fault);
        most = 0.0;
        for (int i = 0; i < DEMAND_SIZE; i++) {
            most = fmax(most, uses[BOUND_USES_USE + i]);
        }
    } while (m->base.integer[V_PLANNER_SLOWS_DOWN] && segfmu_next_pace(most, vector(pace, PACE_SIZE)));
    const segfmu_trajectory plan = feedforward_trajectory(m);
    note_events(m, &plan);
    show_record(&feeds_bound_uses, uses, &m->base);
    show_record(&feeds_pace, pace, &m->base);
    return !segfmu_bound_message(status, fault, message, MESSAGE);
}
