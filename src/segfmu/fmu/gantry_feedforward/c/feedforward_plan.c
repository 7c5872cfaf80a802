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

static array_double_2d contacts_of(const feedforward *m, int axis)
{
    const double *first = m->space + planned_size(m);
    for (int i = 0; i < axis; i++) {
        first += m->turns[i] * CONTACT_SIZE;
    }
    return matrix((double *)first, m->turns[axis], CONTACT_SIZE);
}

/* The contacts that rub, in what the planner has left of the block. */
static bool note_contacts(feedforward *m, char message[MESSAGE])
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    double known[RESISTANCE_SIZE], work[CONTACT_WORK_SIZE * CONTACT_WORK_COLUMNS];
    double fault[SETUP_FAULT_SIZE] = {0.0};
    feed_record(&feeds_resistance, &m->base, known);
    memset(m->turns, 0, sizeof m->turns);
    int64_t status = segfmu_check_friction(
        vector(known + RESISTANCE_STATIC, AXES_SIZE), vector(known + RESISTANCE_COULOMB, AXES_SIZE),
        vector(fault, SETUP_FAULT_SIZE));
    size_t left = segfmu_plan_size(m->points, AXES, m->smoothness) - planned_size(m);
    for (int i = 0; i < AXES_SIZE && status == SETUP_STATUS_FITS; i++) {
        if (segfmu_resists(vector(known, RESISTANCE_SIZE), i)) {
            array_double_2d rows = contacts_of(m, i);
            rows.shape[0] = (int64_t)(left / CONTACT_SIZE);
            m->turns[i] = segfmu_contact_history(
                i, timing_of(&t), matrix((double *)t.coefficients, t.pieces, 2 * t.smoothness),
                offsets_of(&t), vector((double *)t.ends, AXES), vector(known, RESISTANCE_SIZE),
                matrix(work, CONTACT_WORK_SIZE, CONTACT_WORK_COLUMNS), rows);
            left -= (size_t)(m->turns[i] * CONTACT_SIZE);
            fault[SETUP_FAULT_DRIVE] = i;
            status = m->turns[i] > 0 ? SETUP_STATUS_FITS : SETUP_STATUS_MANY_TURNS;
        }
    }
    return !segfmu_setup_message(status, fault, message, MESSAGE);
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

/* Limits as the planner takes them, (axes, n + 1). */
static void gather_limits(const model *base, int64_t smoothness, double *table)
{
    double limits[LOAD_LIMITS_SIZE];
    feed_record(&feeds_load_limits, base, limits);
    for (int axis = 0; axis < AXES; axis++) {
        for (int64_t i = 0; i <= smoothness; i++) {
            table[axis * (smoothness + 1) + i] = i < LIMITS ? limits[axis * LIMITS + i] : 0.0;
        }
    }
}

/* Magnitudes of the limits in the negative direction, (axes, 2). */
static void gather_lower(const model *base, double *lower)
{
    feed_record(&feeds_lower_limits, base, lower);
    for (int i = 0; i < LOWER_LIMITS_SIZE; i++) {
        lower[i] = -lower[i];
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

bool feedforward_plan(feedforward *m, char message[MESSAGE])
{
    const double *real = m->base.real;
    double limits[AXES * (MOST_SMOOTHNESS + 1)], lower[LOWER_LIMITS_SIZE];
    double options[PLAN_OPTIONS_SIZE];
    feed_record(&feeds_plan_options, &m->base, options);
    segfmu_problem problem = {
        m->base.integer[V_WAYPOINT_COUNT], AXES, (int64_t)options[PLAN_OPTIONS_SMOOTHNESS],
        (int64_t)options[PLAN_OPTIONS_SHAPE], (int64_t)options[PLAN_OPTIONS_SYNCHRONIZATION],
        options[PLAN_OPTIONS_SAMPLE_TIME], options[PLAN_OPTIONS_DURATION],
        &real[V_WAYPOINT_POSITION], &real[V_WAYPOINT_VELOCITY], &real[V_WAYPOINT_ACCELERATION],
        &real[V_WAYPOINT_DWELL], limits, lower
    };
    segfmu_trajectory found;
    gather_limits(&m->base, problem.smoothness, limits);
    gather_lower(&m->base, lower);
    int status = segfmu_plan(&problem, m->space, &found);
    if (segfmu_plan_message(status, found.report, message, MESSAGE)
        || !require_rope(&found, &m->base, message)) {
        return false;
    }
    compact(m, &found);
    const segfmu_trajectory plan = feedforward_trajectory(m);
    note_events(m, &plan);
    return note_contacts(m, message);
}
