/* Replanning to waypoints: the planner behind leads, and the old plan as the last resort. */
#include <math.h>

#include "lead.h"

/* a plan to the same target replaces the rest of the old one if it takes less than this share */
static const double SHORTER = 0.99;

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
static int plan_after(replanning *t, const segfmu_problem *p, const double *full, double *space,
                      segfmu_trajectory *trajectory)
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
    options[PLAN_OPTIONS_SMOOTHNESS] = (double)n;
    options[PLAN_OPTIONS_SHAPE] = (double)p->shape;
    options[PLAN_OPTIONS_SYNCHRONIZATION] = (double)p->synchronization;
    options[PLAN_OPTIONS_SAMPLE_TIME] = p->sample_time;
    options[PLAN_OPTIONS_DURATION] = p->duration;
    array_double_2d axes = matrix(take(&space, k * AXIS_SIZE), k, AXIS_SIZE);
    array_double_3d profiles = cuboid(take(&space, cells * CELL_SIZE * CELL_COLUMNS), cells,
                                      CELL_SIZE, CELL_COLUMNS);
    array_double_2d work = matrix(take(&space, PLAN_WORK_SIZE * PLAN_WORK_COLUMNS),
                                  PLAN_WORK_SIZE, PLAN_WORK_COLUMNS);
    array_double_1d dwells = vector((double *)p->dwells, m);
    int64_t status = segfmu_plan_phases(
        states, dwells, matrix((double *)t->limits, k, n + 1),
        vector(options, PLAN_OPTIONS_SIZE), axes, profiles, work);
    if (status < 0) {
        for (int i = 0; i < REFUSAL_SIZE; i++) {
            trajectory->report[i] = work.data[PLAN_WORK_REFUSAL * PLAN_WORK_COLUMNS + i];
        }
        return (int)status;
    }
    array_double_2d expansion = matrix(take(&space, EXPANSION_SIZE * EXPANSION_COLUMNS),
                                       EXPANSION_SIZE, EXPANSION_COLUMNS);
    double *times = take(&space, (m + 1) * k);
    segfmu_expand_plan(states, dwells, axes, profiles, t->plan.timing, t->plan.coefficients,
                       t->plan.offsets, matrix(times, m + 1, k), expansion);
    return segfmu_join_leads(t, m, (double *)full, times, space, trajectory);
}

/* The rest of the old plan, which took `clock`, if it ends in the only target. */
static int keep_rest(replanning *t, const segfmu_problem *p, double clock, double *full,
                     double *times, double *space, segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    double end[DELAYED_STATE_SIZE];
    if (p->points != 2) {
        return PLAN_STATUS_NO_PROFILE;
    }
    segfmu_meet_ends(clock, t->rest.timing, t->rest.offsets);
    for (int64_t axis = 0; axis < k; axis++) {
        const double *target = full + (k + axis) * width;
        segfmu_rest_end(t, axis, end);
        times[axis] = 0.0;
        times[k + axis] = times[2 * k + axis] = end[DELAYED_STATE_DELAY];
        double missed = target[WAYPOINT_STATE_POSITION] - end[WAYPOINT_STATE_POSITION];
        if (fabs(missed) > TOLERANCE * (fabs(target[WAYPOINT_STATE_POSITION])
                                        + t->limits[axis * width] * end[DELAYED_STATE_DELAY])) {
            return PLAN_STATUS_NO_PROFILE;
        }
    }
    int status = segfmu_judge_pieces(t, &t->rest, p->points, full, times, space, trajectory);
    if (status == PLAN_STATUS_PLANNED) {
        return status;
    }
    /* rounding errors of a whole motion may be large against what is left of it */
    segfmu_anchor_plan(matrix(full + k * width, k, width), matrix((double *)t->limits, k, width),
                       t->rest.timing, t->rest.coefficients, t->rest.offsets);
    segfmu_start_states(&t->rest, t->smoothness, full);
    return segfmu_judge_pieces(t, &t->rest, p->points, full, times, space, trajectory);
}

int segfmu_replan(const segfmu_trajectory *old, double time, const segfmu_problem *problem,
                  double *space, segfmu_trajectory *trajectory)
{
    for (int i = 0; i < REFUSAL_SIZE; i++) {
        trajectory->report[i] = 0.0;
    }
    if (problem->points < 2 || problem->axes != old->axes || !(time >= 0.0)
        || problem->smoothness != old->smoothness || problem->dwells[0] != 0.0) {
        return PLAN_STATUS_OUT_OF_RANGE;
    }
    replanning t = segfmu_begin_replanning(old, time, problem->points, problem->limits, space);
    double *full = full_states(&t, problem, &t.space);
    double *times = take(&t.space, (problem->points + 1) * t.axes);
    double *targets = take(&t.space, t.axes * STATE);
    for (int64_t i = 0; i < t.axes * STATE; i++) {
        const int64_t axis = i / STATE;
        targets[i] = full[(t.axes + axis) * (t.smoothness + 1) + i % STATE];
    }
    segfmu_trajectory kept = *trajectory;
    int keeps = keep_rest(&t, problem, old->duration, full, times, t.space, &kept);
    int status = PLAN_STATUS_NO_PROFILE;
    if (segfmu_find_leads(&t, TO_PLAN, problem->shape, targets)) {
        status = plan_after(&t, problem, full, t.space, trajectory);
    }
    if (keeps == PLAN_STATUS_PLANNED
        && (status < 0 || !(trajectory->duration < SHORTER * kept.duration))) {
        *trajectory = kept;
        return PLAN_STATUS_PLANNED;
    }
    if (status < 0) {
        t.leads = t.rest;
        for (int64_t axis = 0; axis < t.axes; axis++) {
            segfmu_rest_end(&t, axis, t.ends + axis * DELAYED_STATE_SIZE);
        }
        /* with rounding errors in its velocity an axis at rest would count as moving */
        segfmu_settle_states(cuboid(t.ends, 1, t.axes, DELAYED_STATE_SIZE),
                             matrix((double *)t.limits, t.axes, t.smoothness + 1));
        status = plan_after(&t, problem, full, t.space, trajectory);
    }
    return status;
}
