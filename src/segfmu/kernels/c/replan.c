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

/* The plan behind the leads. */
static int plan_after(replanning *t, const segfmu_problem *p, double *full, double *times,
                      double *space, segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes, n = t->smoothness, m = p->points, cells = (m - 1) * k;
    array_double_3d states = cuboid(take(&space, m * k * DELAYED_STATE_SIZE), m, k,
                                    DELAYED_STATE_SIZE);
    for (int64_t i = 0; i < m * k; i++) {
        double *state = states.data + i * DELAYED_STATE_SIZE;
        const double *source = i < k ? t->ends + i * DELAYED_STATE_SIZE : full + i * (n + 1);
        for (int64_t d = 0; d < STATE; d++) {
            state[d] = source[d];
        }
        state[DELAYED_STATE_DELAY] = i < k ? source[DELAYED_STATE_DELAY] : 0.0;
    }
    double *options = take(&space, PLAN_OPTIONS_SIZE);
    segfmu_write_options(p, options);
    array_double_2d axes = matrix(take(&space, k * AXIS_SIZE), k, AXIS_SIZE);
    array_double_3d profiles = cuboid(take(&space, cells * CELL_SIZE * CELL_COLUMNS), cells,
                                      CELL_SIZE, CELL_COLUMNS);
    array_double_2d work = matrix(take(&space, PLAN_WORK_SIZE * PLAN_WORK_COLUMNS),
                                  PLAN_WORK_SIZE, PLAN_WORK_COLUMNS);
    array_double_1d dwells = segfmu_gather_dwells(p, &space);
    double *report = work.data + PLAN_WORK_REFUSAL * PLAN_WORK_COLUMNS;
    memset(report, 0, sizeof trajectory->report);
    int64_t status = segfmu_plan_phases(
        states, dwells, t->limits, t->lower, vector(options, PLAN_OPTIONS_SIZE), axes, profiles, work);
    if (status < 0) {
        memcpy(trajectory->report, report, sizeof trajectory->report);
        return (int)status;
    }
    array_double_2d expansion = matrix(take(&space, EXPANSION_SIZE * EXPANSION_COLUMNS),
                                       EXPANSION_SIZE, EXPANSION_COLUMNS);
    segfmu_expand_plan(states, dwells, axes, profiles, t->plan.timing, t->plan.coefficients,
                       t->plan.offsets, matrix(times, m + 1, k), expansion);
    return segfmu_join_leads(t, m, full, times, space, trajectory);
}

/* Round the ends of the leads: with rounding errors in its velocity an axis at rest would count as
   moving. They are between the present states and the targets, which tell the scale. */
static void settle_ends(replanning *t, int64_t points, const double *full)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    double *space = t->space, *path = take(&space, (points + 1) * k * STATE);
    for (int64_t row = 0; row <= points; row++) {
        for (int64_t axis = 0; axis < k; axis++) {
            const double *state = full + ((row < 2 ? 0 : row - 1) * k + axis) * width;
            if (row == 1) {
                state = t->ends + axis * DELAYED_STATE_SIZE;
            }
            memcpy(path + (row * k + axis) * STATE, state, STATE * sizeof *path);
        }
    }
    segfmu_settle_states(1, cuboid(path, points + 1, k, STATE), t->limits, t->lower);
    for (int64_t axis = 0; axis < k; axis++) {
        memcpy(t->ends + axis * DELAYED_STATE_SIZE, path + (k + axis) * STATE,
               STATE * sizeof *path);
    }
}

/* The plan behind all that is left of the old one. */
static int plan_behind(replanning *t, const segfmu_problem *p, double *full, double *times,
                       segfmu_trajectory *trajectory)
{
    t->leads = t->rest;
    segfmu_end_rest(t);
    settle_ends(t, p->points, full);
    int status = plan_after(t, p, full, times, t->space, trajectory);
    if (status == PLAN_STATUS_CHECK_FAILED) {
        /* rounding errors of a whole motion may be large against what is left of it */
        double *space = t->space, *ends = take(&space, t->axes * STATE);
        for (int64_t axis = 0; axis < t->axes; axis++) {
            memcpy(ends + axis * STATE, t->ends + axis * DELAYED_STATE_SIZE, STATE * sizeof *ends);
        }
        segfmu_anchor_plan(matrix(ends, t->axes, STATE), t->limits, t->leads.timing,
                           t->leads.coefficients, t->leads.offsets);
        segfmu_start_states(&t->leads, t->smoothness, full);
        status = plan_after(t, p, full, times, t->space, trajectory);
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
static void rest_in_dwell(replanning *t, int begun, double dwell, double *times)
{
    const int64_t k = t->axes;
    double *stops = times + 2 * k, latest = 0.0;
    for (int64_t axis = 0; axis < k; axis++) {
        latest = span_max(latest, stops[axis]);
    }
    dwell = begun ? span_min(dwell, latest) : dwell;
    for (int64_t axis = 0; axis < k; axis++) {
        const int64_t last = t->rest.offsets.data[axis + 1] - 1;
        double *when = t->rest.timing.data + last * TIMING_SIZE;
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
static int ends_as_asked(replanning *t, const segfmu_trajectory *old, double time,
                         const segfmu_problem *p, const double *targets, double *times)
{
    const int64_t k = t->axes;
    const double *arrivals = old->times + (old->points - 1) * k;
    const double same = SAME_TIME * old->duration;
    double *stops = times + 2 * k;
    int begun = 0;
    segfmu_end_rest(t);
    for (int64_t axis = 0; axis < k; axis++) {
        const double *end = t->ends + axis * DELAYED_STATE_SIZE;
        stops[axis] = end[DELAYED_STATE_DELAY];
        if (!same_state(t, axis, old->duration, end, targets + axis * (t->smoothness + 1))
            || fabs(old->ends[axis] - arrivals[axis] - p->dwells[1]) > same) {
            return 0;
        }
        begun = begun || (p->dwells[1] > 0.0 && arrivals[axis] < time);
    }
    rest_in_dwell(t, begun, p->dwells[1], times);
    const int meets = p->synchronization != SYNCHRONIZATION_NONE || p->duration > 0.0;
    const double together = p->duration > 0.0 ? p->duration : stops[0];
    for (int64_t axis = 0; axis < k && meets; axis++) {
        if (fabs(stops[axis] - together) > same) {
            return 0;
        }
    }
    return 1;
}

/* The rest of the old plan, if it does what the problem asks for; t->rest stays as it is. Its times
   (3, k) have room behind them for how long it is outside the limits. */
static int keep_rest(const replanning *t, const segfmu_trajectory *old, double time,
                     const segfmu_problem *p, const double *full, double *times, double *space,
                     segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    double *states = take(&space, 2 * k * width), *targets = states + k * width;
    replanning kept = *t;
    kept.outside = times + 3 * k;
    if (p->points != 2 || p->sample_time > 0.0) {
        return PLAN_STATUS_NO_PROFILE;
    }
    /* the plan in the trajectory no longer needs its leads */
    kept.rest = t->leads;
    segfmu_cut_rest(old, time, &kept.rest);
    segfmu_meet_ends(old->duration, p->dwells[1], kept.rest.timing, kept.rest.offsets);
    if (!ends_as_asked(&kept, old, time, p, full + k * width, times)) {
        return PLAN_STATUS_NO_PROFILE;
    }
    memcpy(states, full, (size_t)(2 * k * width) * sizeof *states);
    int status = segfmu_judge_pieces(&kept, &kept.rest, 2, states, times, space, trajectory);
    if (status == PLAN_STATUS_PLANNED) {
        return status;
    }
    /* rounding errors of a whole motion may be large against what is left of it */
    segfmu_anchor_plan(matrix(targets, k, width), t->limits, kept.rest.timing,
                       kept.rest.coefficients, kept.rest.offsets);
    segfmu_start_states(&kept.rest, t->smoothness, states);
    for (int64_t axis = 0; axis < k; axis++) {
        if (!same_state(t, axis, old->duration, states + axis * width, full + axis * width)) {
            return PLAN_STATUS_NO_PROFILE;
        }
    }
    return segfmu_judge_pieces(&kept, &kept.rest, 2, states, times, space, trajectory);
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
    const double *targets = full + k * (t.smoothness + 1);
    const int apart = problem->synchronization == SYNCHRONIZATION_NONE && problem->duration == 0.0;
    const double meeting = apart ? -1.0 : problem->duration;
    if (segfmu_settle_axes(&t, LEAD_STAGE_ACCELERATION, problem->shape, meeting, targets) >= 0) {
        status = PLAN_STATUS_NO_PROFILE;
    } else {
        status = plan_after(&t, problem, full, times, t.space, trajectory);
    }
    int keeps = keep_rest(&t, old, time, problem, full, kept_times, t.space, &kept);
    if (keeps == PLAN_STATUS_PLANNED
        && (status < 0 || !(trajectory->duration < SHORTER * kept.duration))) {
        *trajectory = kept;
        return PLAN_STATUS_PLANNED;
    }
    return status < 0 ? plan_behind(&t, problem, full, times, trajectory) : status;
}
