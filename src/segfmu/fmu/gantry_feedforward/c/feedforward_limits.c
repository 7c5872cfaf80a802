/* GantryFeedforward: limits of the load from the bounds of the drives. */
#include <math.h>
#include <string.h>

#include "feedforward.h"

enum { UNKNOWNS = AXES * LIMIT_ROW_SIZE };

/* a bound that is used beyond this is exceeded, and the largest pace beyond what samples suggest */
static const double KEPT = 1.0 + 1e-9, FASTEST = 1e3;

typedef struct {
    double bounds[DRIVE_BOUNDS_SIZE], known[RESISTANCE_SIZE], caps[UNKNOWNS];
    double axes[AXES * AXIS_TASK_SIZE], kinds[UNKNOWNS], starts[STARTS_COUNT * UNKNOWNS];
    double rows[SEARCH_SIZE * UNKNOWNS], values[SEARCH_VALUES_SIZE * VALUES_SIZE];
    double slopes[UNKNOWNS * VALUES_SIZE], newton[2 * UNKNOWNS * UNKNOWNS];
    double uses[2 * DEMAND_SIZE], most;
    double closest[UNKNOWNS], least; /* of the last plans the one that uses the bounds least */
} limit_search;

static array_double_2d axes_of(limit_search *s)
{
    return matrix(s->axes, AXES, AXIS_TASK_SIZE);
}

static array_double_2d rows_of(limit_search *s)
{
    return matrix(s->rows, SEARCH_SIZE, UNKNOWNS);
}

static array_double_2d starts_of(limit_search *s)
{
    return matrix(s->starts, STARTS_COUNT, UNKNOWNS);
}

/* The given limits, as the search takes them: largest ones, 0 where there are none. */
static void gather_caps(const model *base, double *caps)
{
    double limits[LOAD_LIMITS_SIZE], lower[LOWER_LIMITS_SIZE];
    feed_record(&feeds_load_limits, base, limits);
    feed_record(&feeds_lower_limits, base, lower);
    for (int axis = 0; axis < AXES; axis++) {
        double *row = caps + axis * LIMIT_ROW_SIZE;
        memcpy(row, limits + axis * LIMITS, LIMITS * sizeof *row);
        for (int i = 0; i < LIMIT_ROW_SIZE - LIMIT_ROW_VELOCITY_MIN; i++) {
            const double least = lower[axis * (LIMIT_ROW_SIZE - LIMIT_ROW_VELOCITY_MIN) + i];
            row[LIMIT_ROW_VELOCITY_MIN + i] = least < 0.0 ? -least : row[i];
        }
    }
}

/* What is searched for; narrow: with the smaller bounds of both directions in both. */
static bool pose_search(limit_search *s, const feedforward *m, bool narrow, char message[MESSAGE])
{
    double *real = (double *)m->base.real, fault[LIMIT_FAULT_SIZE], rope = 0.0;
    const int64_t points = m->base.integer[V_WAYPOINT_COUNT];
    array_double_2d positions = matrix(&real[V_WAYPOINT_POSITION], points, AXES);
    feed_record(&feeds_drive_bounds, &m->base, s->bounds);
    feed_record(&feeds_resistance, &m->base, s->known);
    gather_caps(&m->base, s->caps);
    array_double_2d caps = matrix(s->caps, AXES, LIMIT_ROW_SIZE);
    if (narrow) {
        segfmu_narrow_bounds(vector(s->bounds, DRIVE_BOUNDS_SIZE), caps);
    }
    segfmu_write_axes(
        positions, matrix(&real[V_WAYPOINT_VELOCITY], points, AXES),
        matrix(&real[V_WAYPOINT_ACCELERATION], points, AXES), vector(s->bounds, DRIVE_BOUNDS_SIZE),
        caps, vector(s->known, RESISTANCE_SIZE), axes_of(s));
    segfmu_write_kinds(axes_of(s), vector(s->kinds, UNKNOWNS));
    for (int64_t i = 0; i < points; i++) {
        rope = fmax(rope, -real[V_WAYPOINT_POSITION + i * AXES + AXES_ROPE]);
    }
    int64_t status = segfmu_write_starts(
        rope, vector(s->bounds, DRIVE_BOUNDS_SIZE), vector(s->known, RESISTANCE_SIZE), axes_of(s),
        starts_of(s), vector(fault, LIMIT_FAULT_SIZE));
    return !segfmu_limit_message(status, fault, message, MESSAGE);
}

/* Plan what the row TRIAL stands for; its duration, -1 with a message if there is no plan that may be
   taken. A plan within the bounds has to be clear of obstacles as well. */
static double try_limits(
    feedforward *m, limit_search *s, bool exact, bool timed, char message[MESSAGE])
{
    double table[UNKNOWNS], peaks[2 * DEMAND_SIZE], times[2 * DEMAND_SIZE];
    double *trial = s->rows + SEARCH_TRIAL * UNKNOWNS;
    request r = {.pace = 1.0, .timed = timed};
    segfmu_write_limits(
        vector(trial, UNKNOWNS), axes_of(s), matrix(table, AXES, LIMIT_ROW_SIZE));
    for (int axis = 0; axis < AXES; axis++) {
        const double *row = table + axis * LIMIT_ROW_SIZE;
        memcpy(r.limits + axis * LIMITS, row, LIMITS * sizeof *row);
        for (int i = 0; i < LIMIT_ROW_SIZE - LIMIT_ROW_VELOCITY_MIN; i++) {
            const bool own = s->axes[axis * AXIS_TASK_SIZE + AXIS_TASK_DIRECTED + i] > 0.0;
            r.lower[axis * (LIMIT_ROW_SIZE - LIMIT_ROW_VELOCITY_MIN) + i] =
                own ? -row[LIMIT_ROW_VELOCITY_MIN + i] : 0.0;
        }
    }
    if (!plan_at(m, &r, message)) {
        return -1.0;
    }
    measure(m, exact, peaks, times);
    segfmu_write_shares(
        matrix(peaks, 2, DEMAND_SIZE), vector(s->bounds, DRIVE_BOUNDS_SIZE), axes_of(s),
        vector(s->uses, 2 * DEMAND_SIZE));
    s->most = 0.0;
    for (int i = 0; i < 2 * DEMAND_SIZE; i++) {
        s->most = fmax(s->most, s->uses[i]);
    }
    if (s->most < s->least) {
        s->least = s->most;
        memcpy(s->closest, trial, sizeof s->closest);
    }
    return s->most > KEPT || require_space(m, message) ? m->duration : -1.0;
}

/* Search by samples; whether there is a plan. */
static bool search_limits(feedforward *m, limit_search *s, char message[MESSAGE])
{
    double duration;
    s->least = 1e300;
    segfmu_begin_limits(starts_of(s), vector(s->kinds, UNKNOWNS), rows_of(s));
    do {
        memset(s->uses, 0, sizeof s->uses);
        duration = try_limits(m, s, false, false, message);
    } while (segfmu_next_limits(
        duration, vector(s->uses, 2 * DEMAND_SIZE), starts_of(s), rows_of(s),
        matrix(s->values, SEARCH_VALUES_SIZE, VALUES_SIZE), matrix(s->slopes, UNKNOWNS, VALUES_SIZE),
        matrix(s->newton, 2 * UNKNOWNS, UNKNOWNS)));
    return s->rows[SEARCH_STATE * UNKNOWNS + SEARCH_STATE_BEST] < 1e300;
}

/* Plan what was found at the pace at which its exact peaks just keep the bounds, up to a pace. */
static bool pace_limits(
    feedforward *m, limit_search *s, double fastest, bool timed, char message[MESSAGE])
{
    double pace[PACE_SIZE], duration;
    segfmu_begin_pace(fastest, FULL, vector(pace, PACE_SIZE));
    do {
        segfmu_write_best(pace[PACE_PACE], rows_of(s));
        duration = try_limits(m, s, true, timed, message);
    } while (segfmu_next_pace(duration >= 0.0 ? s->most : 1e300, vector(pace, PACE_SIZE)));
    if (pace[PACE_KEEPS] == 0.0) {
        return false;
    }
    segfmu_keep_best(pace[PACE_KEEPS], rows_of(s));
    return try_limits(m, s, true, timed, message) >= 0.0 && s->most <= KEPT;
}

static bool is_directed(limit_search *s)
{
    for (int i = 0; i < AXES; i++) {
        const double *row = s->axes + i * AXIS_TASK_SIZE + AXIS_TASK_DIRECTED;
        if (row[0] + row[1] > 0.0) {
            return true;
        }
    }
    return false;
}

bool feedforward_limits(feedforward *m, char message[MESSAGE])
{
    limit_search s;
    memset(&s, 0, sizeof s);
    if (!pose_search(&s, m, false, message)) {
        return false;
    }
    if (is_directed(&s)) {
        /* from the limits for the smaller bounds, so that no larger one makes the plan longer */
        double found[UNKNOWNS];
        bool narrow = pose_search(&s, m, true, message) && search_limits(m, &s, message);
        memcpy(found, s.rows + SEARCH_BEST * UNKNOWNS, sizeof found);
        for (int axis = 0; axis < AXES; axis++) {
            double *row = found + axis * LIMIT_ROW_SIZE;
            memcpy(row + LIMIT_ROW_VELOCITY_MIN, row, LIMIT_ROW_JERK * sizeof *row);
        }
        pose_search(&s, m, false, message);
        if (narrow) {
            memcpy(s.starts, found, sizeof found);
        }
    }
    bool found = search_limits(m, &s, message) && pace_limits(m, &s, FASTEST, false, message);
    const double *real = m->base.real;
    const bool timed = found
        && (real[V_PLANNER_SAMPLE_TIME] > 0.0 || real[V_PLANNER_DURATION] > 0.0);
    if (timed) {
        s.least = 1e300;
        found = pace_limits(m, &s, 1.0, true, message);
    }
    if (!found && s.least < 1e300) {
        /* the plan that comes closest is refused with what it exceeds or meets */
        memcpy(s.rows + SEARCH_TRIAL * UNKNOWNS, s.closest, sizeof s.closest);
        found = try_limits(m, &s, true, timed, message) >= 0.0;
    }
    return found;
}
