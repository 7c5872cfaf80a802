/* Replanning to waypoints: the planner behind leads, and the old plan as the last resort. */
#include "lead.h"

/* a plan to the same target replaces the rest of the old one if it takes less than this share */
static const double SHORTER = 0.95;
/* of times, which nothing but rounding changes, relative */
static const double SAME_TIME = 1e-12;

/* States of the waypoints as far as derivative n; the first one is the start. */
static double *full_states(const replanning *t, const segfmu_problem *p, double **space)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    double *states = take(space, p->points * k * width);
    for (int64_t i = 0; i < p->points * k; i++) {
        for (int64_t d = 0; d < width; d++) {
            states[i * width + d] = i < k ? t->now[i * width + d] : 0.0;
        }
        if (i >= k) {
            states[i * width + WAYPOINT_STATE_POSITION] = p->positions[i];
            states[i * width + WAYPOINT_STATE_VELOCITY] = p->velocities[i];
            states[i * width + WAYPOINT_STATE_ACCELERATION] = p->accelerations[i];
        }
    }
    return states;
}

/* From the states full (m, k, n + 1) onward: with leads, or, where these have ends (k, DelayedState),
   behind what is in their part. */
static int plan_onward(replanning *t, const segfmu_problem *p, const double *full,
                       const double *ends, double *times, segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes, width = t->smoothness + 1, m = p->points, cells = (m - 1) * k;
    double *space = ends == NULL ? t->space : t->space + k * DELAYED_STATE_SIZE;
    array_double_3d states = cuboid(take(&space, 2 * m * k * LEAD_END_SIZE), 2 * m, k, LEAD_END_SIZE);
    array_double_3d profiles = cuboid(take(&space, cells * CELL_SIZE * CELL_COLUMNS), cells,
                                      CELL_SIZE, CELL_COLUMNS);
    array_double_1d dwells = segfmu_gather_dwells(p, &space);
    memset(states.data, 0, (size_t)(2 * m * k * LEAD_END_SIZE) * sizeof *states.data);
    for (int64_t i = 0; i < m * k; i++) {
        memcpy(states.data + i * LEAD_END_SIZE, full + i * width, (size_t)width * sizeof *full);
    }
    for (int64_t i = 0; i < k && ends != NULL; i++) {
        memcpy(states.data + (m * k + i) * LEAD_END_SIZE, ends + i * DELAYED_STATE_SIZE,
               DELAYED_STATE_SIZE * sizeof *ends);
    }
    double *rows = t->lead.data;
    segfmu_write_options(p, rows + LEAD_WORK_OPTIONS * LEAD_WORK_COLUMNS);
    rows[LEAD_WORK_TASK * LEAD_WORK_COLUMNS + LEAD_TASK_DONE] = ends == NULL ? DONE_NOTHING : DONE_LEADS;
    const int64_t status = segfmu_plan_onward(
        states, dwells, t->limits, t->lower, t->tables, profiles, t->timing, t->coefficients,
        t->offsets, matrix(times, m + 1, k), t->lead);
    if (status == PLAN_STATUS_PLANNED || status == PLAN_STATUS_CHECK_FAILED) {
        const piece_list whole = segfmu_part(t, PLAN_PART_WHOLE);
        segfmu_show(t, &whole, m, times, trajectory);
    } else {
        memcpy(trajectory->report, rows + (LEAD_WORK_PLAN + PLAN_WORK_REFUSAL) * LEAD_WORK_COLUMNS,
               sizeof trajectory->report);
    }
    return (int)status;
}

/* Round the ends of leads: with rounding errors in its velocity an axis at rest would count as moving.
   They are between the present states and the targets, which tell the scale. */
static void settle_ends(const replanning *t, int64_t points, const double *full, double *ends)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    double *space = t->space + k * DELAYED_STATE_SIZE, *path = take(&space, (points + 1) * k * STATE);
    for (int64_t row = 0; row <= points; row++) {
        for (int64_t axis = 0; axis < k; axis++) {
            const double *state = full + ((row < 2 ? 0 : row - 1) * k + axis) * width;
            if (row == 1) {
                state = ends + axis * DELAYED_STATE_SIZE;
            }
            memcpy(path + (row * k + axis) * STATE, state, STATE * sizeof *path);
        }
    }
    segfmu_settle_states(1, cuboid(path, points + 1, k, STATE), t->limits, t->lower);
    for (int64_t axis = 0; axis < k; axis++) {
        memcpy(ends + axis * DELAYED_STATE_SIZE, path + (k + axis) * STATE, STATE * sizeof *path);
    }
}

/* The plan behind all that is left of the old one. */
static int plan_behind(replanning *t, const segfmu_problem *p, double *full, double *times,
                       segfmu_trajectory *trajectory)
{
    const piece_list leads = segfmu_part(t, PLAN_PART_LEADS);
    double *space = t->space, *ends = take(&space, t->axes * DELAYED_STATE_SIZE);
    segfmu_follow_rest(t);
    segfmu_end_pieces(&leads, ends);
    settle_ends(t, p->points, full, ends);
    int status = plan_onward(t, p, full, ends, times, trajectory);
    if (status == PLAN_STATUS_CHECK_FAILED) {
        /* rounding errors of a whole motion may be large against what is left of it */
        double *states = take(&space, t->axes * STATE);
        for (int64_t axis = 0; axis < t->axes; axis++) {
            memcpy(states + axis * STATE, ends + axis * DELAYED_STATE_SIZE, STATE * sizeof *ends);
        }
        segfmu_anchor_plan(matrix(states, t->axes, STATE), t->limits, leads.timing,
                           leads.coefficients, leads.offsets);
        segfmu_start_states(&leads, t->smoothness, full);
        status = plan_onward(t, p, full, ends, times, trajectory);
    }
    return status;
}

/* Whether two states of an axis are the same within the tolerance of a plan that takes `clock`. */
static int same_state(const replanning *t, int64_t axis, double clock, const double *a,
                      const double *b)
{
    const int64_t width = t->smoothness + 1;
    const array_double_1d bounds = vector(t->limits.data + axis * width, width);
    /* at least what segfmu_check_plan takes for the distance that is covered */
    double scale = segfmu_state_scale(0, clock, bounds) + 1e-5 * fabs(b[WAYPOINT_STATE_POSITION]);
    for (int i = 0; i < STATE; i++) {
        if (!(fabs(a[i] - b[i]) <= PLAN_TOLERANCE * scale)) {
            return 0;
        }
        scale = segfmu_state_scale(i + 1, clock, bounds);
    }
    return 1;
}

/* Once some axes are in the last dwell, they rest until the last one has done so, or, while that
   moves, for a whole dwell; times (3, k) of a rest that ends at stops. */
static void rest_in_dwell(const piece_list *rest, int begun, double dwell, double *times)
{
    const int64_t k = rest->offsets.shape[0] - 1;
    double *stops = times + 2 * k, latest = 0.0;
    for (int64_t axis = 0; axis < k; axis++) {
        latest = span_max(latest, stops[axis]);
    }
    dwell = begun ? span_min(dwell, latest) : dwell;
    for (int64_t axis = 0; axis < k; axis++) {
        const int64_t last = rest->offsets.data[axis + 1] - 1;
        double *when = rest->timing.data + last * TIMING_SIZE;
        if (begun && when[TIMING_LENGTH] < dwell) {
            when[TIMING_LENGTH] = dwell;
            stops[axis] = when[TIMING_START] + dwell;
        }
        times[axis] = 0.0;
        times[k + axis] = stops[axis] - dwell;
    }
}

/* Whether the rest of the old plan ends in the target with its dwell, the axes together if asked;
   its times (3, k). */
static int ends_as_asked(const replanning *t, const piece_list *rest, const segfmu_trajectory *old,
                         double time, const segfmu_problem *p, const double *targets, double *times)
{
    const int64_t k = t->axes;
    double *space = t->space, *ends = take(&space, k * DELAYED_STATE_SIZE);
    const double *arrivals = old->times + (old->points - 1) * k;
    const double same = SAME_TIME * old->duration;
    double *stops = times + 2 * k;
    int begun = 0;
    segfmu_end_pieces(rest, ends);
    for (int64_t axis = 0; axis < k; axis++) {
        const double *end = ends + axis * DELAYED_STATE_SIZE;
        stops[axis] = end[DELAYED_STATE_DELAY];
        if (!same_state(t, axis, old->duration, end, targets + axis * (t->smoothness + 1))
            || fabs(old->ends[axis] - arrivals[axis] - p->dwells[1]) > same) {
            return 0;
        }
        begun = begun || (p->dwells[1] > 0.0 && arrivals[axis] < time);
    }
    rest_in_dwell(rest, begun, p->dwells[1], times);
    const int meets = p->synchronization != SYNCHRONIZATION_NONE || p->duration > 0.0;
    const double together = p->duration > 0.0 ? p->duration : stops[0];
    for (int64_t axis = 0; axis < k && meets; axis++) {
        if (fabs(stops[axis] - together) > same) {
            return 0;
        }
    }
    return 1;
}

/* The rest of the old plan, if it does what the problem asks for. Its times (3, k) have room behind them
   for how long it is outside the limits. */
static int keep_rest(const replanning *t, const segfmu_trajectory *old, double time,
                     const segfmu_problem *p, const double *full, double *times,
                     segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    replanning kept = *t;
    double *states = take(&kept.space, 2 * k * width), *targets = states + k * width;
    kept.outside = times + 3 * k;
    if (p->points != 2 || p->sample_time > 0.0) {
        return PLAN_STATUS_NO_PROFILE;
    }
    /* the plan in the trajectory no longer needs its leads */
    piece_list rest = segfmu_part(t, PLAN_PART_LEADS);
    segfmu_cut_rest(old, time, &rest);
    segfmu_meet_ends(old->duration, p->dwells[1], rest.timing, rest.offsets);
    if (!ends_as_asked(&kept, &rest, old, time, p, full + k * width, times)) {
        return PLAN_STATUS_NO_PROFILE;
    }
    memcpy(states, full, (size_t)(2 * k * width) * sizeof *states);
    int status = segfmu_judge(&kept, &rest, 2, states, times, trajectory);
    if (status == PLAN_STATUS_PLANNED) {
        return status;
    }
    /* rounding errors of a whole motion may be large against what is left of it */
    segfmu_anchor_plan(matrix(targets, k, width), t->limits, rest.timing, rest.coefficients,
                       rest.offsets);
    segfmu_start_states(&rest, t->smoothness, states);
    for (int64_t axis = 0; axis < k; axis++) {
        if (!same_state(t, axis, old->duration, states + axis * width, full + axis * width)) {
            return PLAN_STATUS_NO_PROFILE;
        }
    }
    return segfmu_judge(&kept, &rest, 2, states, times, trajectory);
}

int segfmu_replan(const segfmu_trajectory *old, double time, const segfmu_problem *problem,
                  double *space, segfmu_trajectory *trajectory)
{
    if (!segfmu_in_range(problem, trajectory->report) || !(time >= 0.0 && isfinite(time))
        || problem->axes != old->axes || problem->smoothness != old->smoothness
        || problem->dwells[0] != 0.0) {
        return PLAN_STATUS_OUT_OF_RANGE;
    }
    const int64_t m = problem->points;
    replanning t = segfmu_begin_replanning(
        old, time, m, problem->limits, problem->lower, space);
    const int64_t k = t.axes;
    double *full = full_states(&t, problem, &t.space);
    double *times = take(&t.space, (m + 1) * k), *kept_times = take(&t.space, 4 * k);
    segfmu_trajectory kept = {0};
    int status = segfmu_settle_targets(&t, m, full, trajectory->report);
    if (status != PLAN_STATUS_PLANNED) {
        return status;
    }
    status = plan_onward(&t, problem, full, NULL, times, trajectory);
    int keeps = keep_rest(&t, old, time, problem, full, kept_times, &kept);
    if (keeps == PLAN_STATUS_PLANNED
        && (status < 0 || !(trajectory->duration < SHORTER * kept.duration))) {
        *trajectory = kept;
        return PLAN_STATUS_PLANNED;
    }
    return status < 0 ? plan_behind(&t, problem, full, times, trajectory) : status;
}
