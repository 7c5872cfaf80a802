/* Planner and flat inverse: limits of the load from the bounds of the drives. */
#include <math.h>
#include <string.h>

#include "checksum.h"
#include "limit_search.h"

/* a bound that is used beyond this is exceeded, and the largest pace beyond what samples suggest */
static const double KEPT = 1.0 + 1e-9, FASTEST = 1e3;

static array_double_2d axes_of(limit_search *s)
{
    return matrix(s->axes, AXES, AXIS_TASK_SIZE);
}

static array_double_2d rows_of(limit_search *s)
{
    return matrix(s->rows, SEARCH_SIZE, s->unknowns);
}

static array_double_2d starts_of(limit_search *s)
{
    return matrix(s->starts, STARTS_COUNT, s->unknowns);
}

static double *unknowns_in(limit_search *s, int64_t row)
{
    return s->rows + row * s->unknowns;
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
static bool pose_search(
    limit_search *s, const feedforward *m, bool narrow, bool chooses, char message[MESSAGE])
{
    double *real = (double *)m->base.real, fault[LIMIT_FAULT_SIZE], rope = 0.0;
    s->chooses = s->strict = chooses;
    s->unknowns = LIMIT_UNKNOWNS + (chooses ? STATE_UNKNOWNS * (s->places - 2) : 0);
    feed_record(&feeds_drive_bounds, &m->base, s->bounds);
    crane_of(&m->base, s->known);
    gather_caps(&m->base, s->caps);
    array_double_2d caps = matrix(s->caps, AXES, LIMIT_ROW_SIZE);
    if (narrow) {
        segfmu_narrow_bounds(vector(s->bounds, DRIVE_BOUNDS_SIZE), caps);
    }
    segfmu_write_axes(
        narrow, matrix(&real[V_WAYPOINT_POSITION], s->points, AXES),
        matrix(s->base.velocity, s->points, AXES), matrix(s->base.acceleration, s->points, AXES),
        vector(s->bounds, DRIVE_BOUNDS_SIZE), caps, vector(s->known, RESISTANCE_SIZE), axes_of(s));
    segfmu_write_kinds(axes_of(s), vector(s->kinds, s->unknowns));
    for (int64_t i = 0; i < s->points; i++) {
        rope = fmax(rope, -real[V_WAYPOINT_POSITION + i * AXES + AXES_ROPE]);
    }
    memset(s->starts, 0, (size_t)(STARTS_COUNT * s->unknowns) * sizeof *s->starts);
    int64_t status = segfmu_write_starts(
        rope, vector(s->bounds, DRIVE_BOUNDS_SIZE), vector(s->known, RESISTANCE_SIZE), axes_of(s),
        starts_of(s), vector(fault, LIMIT_FAULT_SIZE));
    for (int k = 0; chooses && k < STARTS_COUNT; k++) {
        segfmu_write_passing(
            matrix(s->places_at, s->places, AXES), vector(s->kinds, s->unknowns), axes_of(s),
            vector(s->heading, HEADING_SIZE), vector(s->starts + k * s->unknowns, s->unknowns));
    }
    return !segfmu_limit_message(status, fault, message, MESSAGE);
}

/* The request that the row TRIAL stands for. */
static void read_trial(limit_search *s, bool timed, request *r)
{
    double table[LIMIT_UNKNOWNS];
    array_double_1d trial = vector(unknowns_in(s, SEARCH_TRIAL), s->unknowns);
    array_double_2d limits = matrix(table, AXES, LIMIT_ROW_SIZE);
    *r = s->base;
    r->timed = timed;
    segfmu_write_limits(trial, axes_of(s), limits);
    for (int axis = 0; axis < AXES; axis++) {
        const double *row = table + axis * LIMIT_ROW_SIZE;
        memcpy(r->limits + axis * LIMITS, row, LIMITS * sizeof *row);
        for (int i = 0; i < LIMIT_ROW_SIZE - LIMIT_ROW_VELOCITY_MIN; i++) {
            const bool own = s->axes[axis * AXIS_TASK_SIZE + AXIS_TASK_DIRECTED + i] > 0.0;
            r->lower[axis * (LIMIT_ROW_SIZE - LIMIT_ROW_VELOCITY_MIN) + i] =
                own ? -row[LIMIT_ROW_VELOCITY_MIN + i] : 0.0;
        }
    }
    if (s->chooses) {
        memcpy(s->tried, s->states, (size_t)(s->points * POINT) * sizeof *s->tried);
        segfmu_write_states(
            trial, vector(s->kinds, s->unknowns), limits, vector(s->place, s->points),
            vector(s->heading, HEADING_SIZE), cuboid(s->tried, s->points, AXES, WAYPOINT_STATE_SIZE));
        split_states(s->tried, s->points, r);
    }
}

/* Check that the path stays in the boxes of waypoints with states that were chosen. */
static bool require_boxes(limit_search *s, feedforward *m, char message[MESSAGE])
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    const int64_t width = 2 * t.smoothness;
    double work[ROPE_WORK_SIZE * MOST_COLUMNS], fault[EXCURSION_SIZE];
    int64_t status = !s->chooses ? PATH_STATUS_INSIDE : segfmu_path_excursion(
        matrix(s->led, s->points, AXES),
        matrix(&m->base.real[V_WAYPOINT_POSITION], s->points, AXES),
        matrix((double *)t.times, s->points, AXES), timing_of(&t),
        matrix((double *)t.coefficients, t.pieces, width), offsets_of(&t),
        matrix(work, ROPE_WORK_SIZE, 4 * width - 5), vector(fault, EXCURSION_SIZE));
    return !segfmu_path_message(status, fault, message, MESSAGE);
}

/* Peaks of the plan; as limits that nothing reaches change nothing, it often is one of the last. */
static seen_plan *look(feedforward *m, limit_search *s, bool exact)
{
    const uint64_t sum = checksum(m->space, mission_size(m) * sizeof *m->space) + exact;
    for (int i = 0; i < SEEN; i++) {
        if (s->seen[i].sum == sum) {
            return &s->seen[i];
        }
    }
    seen_plan *p = &s->seen[s->looks++ % SEEN];
    p->sum = sum;
    measure(m, exact, p->peaks, p->times);
    return p;
}

/* Plan what the row TRIAL stands for; its duration, -1 with a message if there is no plan that may be
   taken. A plan that would be kept has to have a taut rope, to stay in its boxes and to be clear of
   obstacles. */
static double try_limits(
    feedforward *m, limit_search *s, bool exact, bool timed, char message[MESSAGE])
{
    array_double_1d uses = vector(s->uses, 2 * DEMAND_SIZE);
    request r;
    read_trial(s, timed, &r);
    if (!plan_loosely(m, &r, message)) {
        return -1.0;
    }
    segfmu_write_shares(
        matrix(look(m, s, exact)->peaks, 2, DEMAND_SIZE), vector(s->bounds, DRIVE_BOUNDS_SIZE), axes_of(s), uses);
    s->most = 0.0;
    for (int i = 0; i < 2 * DEMAND_SIZE; i++) {
        s->most = fmax(s->most, s->uses[i]);
    }
    const bool judged = exact || segfmu_is_judged(m->duration, uses, rows_of(s));
    if (judged && !require_taut_plan(m, message)) {
        return -1.0;
    }
    if (s->most < s->least) {
        s->least = s->most;
        memcpy(s->closest, unknowns_in(s, SEARCH_TRIAL), (size_t)s->unknowns * sizeof *s->closest);
    }
    if (!judged || (s->most > KEPT && !s->strict)) {
        return m->duration;
    }
    return require_boxes(s, m, message) && require_space(m, message) ? m->duration : -1.0;
}

/* Search by samples; whether there is a plan. */
static bool search_limits(feedforward *m, limit_search *s, char message[MESSAGE])
{
    double duration;
    const int64_t n = s->unknowns;
    s->least = 1e300;
    memset(s->rows, 0, (size_t)(SEARCH_SIZE * n) * sizeof *s->rows);
    memset(s->slopes, 0, (size_t)(VALUES_SIZE * n) * sizeof *s->slopes);
    segfmu_begin_limits(starts_of(s), vector(s->kinds, n), rows_of(s));
    do {
        memset(s->uses, 0, sizeof s->uses);
        duration = try_limits(m, s, false, false, message);
    } while (segfmu_next_limits(
        duration, vector(s->uses, 2 * DEMAND_SIZE), starts_of(s), rows_of(s),
        matrix(s->values, SEARCH_VALUES_SIZE, VALUES_SIZE), matrix(s->slopes, n, VALUES_SIZE),
        matrix(s->newton, 2 * n, n)));
    return unknowns_in(s, SEARCH_STATE)[SEARCH_STATE_BEST] < 1e300;
}

/* Plan what was found at the pace at which its exact peaks just keep the bounds, up to a pace. */
static bool pace_limits(
    feedforward *m, limit_search *s, double fastest, bool timed, char message[MESSAGE])
{
    double pace[PACE_SIZE], duration;
    segfmu_cap_best(axes_of(s), rows_of(s));
    segfmu_begin_pace(fastest, FULL, vector(pace, PACE_SIZE));
    do {
        segfmu_write_best(pace[PACE_PACE], rows_of(s));
        duration = try_limits(m, s, true, timed, message);
    } while (segfmu_next_pace(duration >= 0.0 ? s->most : 1e300, vector(pace, PACE_SIZE)));
    if (pace[PACE_KEEPS] == 0.0) {
        return false;
    }
    segfmu_keep_best(pace[PACE_KEEPS], rows_of(s));
    if (pace[PACE_PACE] == pace[PACE_KEEPS] && duration >= 0.0 && s->most <= KEPT) {
        return true;
    }
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

/* Search as posed, from the limits of a narrower search where there is one, so that nothing that is
   allowed in addition makes the plan longer; known: whether there is one, whose limits these are. */
static bool search_from(
    feedforward *m, limit_search *s, bool known, double *limits, char message[MESSAGE])
{
    if (known) {
        memset(s->starts, 0, (size_t)s->unknowns * sizeof *s->starts);
        memcpy(s->starts, limits, LIMIT_UNKNOWNS * sizeof *limits);
    }
    const bool found = search_limits(m, s, message);
    memcpy(limits, unknowns_in(s, SEARCH_BEST), LIMIT_UNKNOWNS * sizeof *limits);
    return found;
}

bool feedforward_limits(feedforward *m, double *peaks, double *times, char message[MESSAGE])
{
    limit_search s;
    double limits[LIMIT_UNKNOWNS];
    const bool chooses = find_places(&s, m);
    if (!pose_search(&s, m, false, false, message)) {
        return false;
    }
    bool known = false;
    if (is_directed(&s)) {
        known = pose_search(&s, m, true, false, message) && search_from(m, &s, false, limits, message);
        for (int axis = 0; axis < AXES; axis++) {
            double *row = limits + axis * LIMIT_ROW_SIZE;
            memcpy(row + LIMIT_ROW_VELOCITY_MIN, row, LIMIT_ROW_JERK * sizeof *row);
        }
        pose_search(&s, m, false, false, message);
    }
    bool found = search_from(m, &s, known, limits, message);
    if (chooses) {
        pose_search(&s, m, false, true, message);
        found = search_from(m, &s, found, limits, message);
    }
    found = found && pace_limits(m, &s, FASTEST, false, message);
    const double *real = m->base.real;
    const bool timed = found
        && (real[V_PLANNER_SAMPLE_TIME] > 0.0 || real[V_PLANNER_DURATION] > 0.0);
    if (timed) {
        s.least = 1e300;
        found = pace_limits(m, &s, 1.0, true, message);
    }
    if (!found && s.least < 1e300) {
        /* the plan that comes closest is refused with what it exceeds or meets */
        memcpy(unknowns_in(&s, SEARCH_TRIAL), s.closest, (size_t)s.unknowns * sizeof *s.closest);
        s.strict = false;
        found = try_limits(m, &s, true, timed, message) >= 0.0;
    }
    if (found) {
        const seen_plan *last = look(m, &s, true);
        memcpy(peaks, last->peaks, sizeof last->peaks);
        memcpy(times, last->times, sizeof last->times);
    }
    return found;
}
