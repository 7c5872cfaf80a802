/* Reaching a velocity: leads to it, which is then held until all axes have it. */
#include "lead.h"

/* What each axis holds after its lead to a velocity, which ends in a state of ends (k, DelayedState),
   with times and the state where that ends; anchors the leads. The velocities are those of the last
   states. */
static void hold_velocities(const replanning *t, int anchored, double *ends, double *states,
                            double *times)
{
    const int64_t k = t->axes, n = t->smoothness;
    const piece_list leads = segfmu_part(t, PLAN_PART_LEADS);
    const piece_list holds = segfmu_part(t, PLAN_PART_BEHIND);
    double duration = 0.0;
    for (int64_t axis = 0; axis < k; axis++) {
        duration = span_max(duration, ends[axis * DELAYED_STATE_SIZE + DELAYED_STATE_DELAY]);
    }
    for (int64_t axis = 0; axis < k; axis++) {
        double *end = ends + axis * DELAYED_STATE_SIZE;
        const double hold = duration - end[DELAYED_STATE_DELAY];
        double *piece = holds.coefficients.data + axis * 2 * n;
        double *last = states + (k + axis) * (n + 1);
        const double velocity = last[WAYPOINT_STATE_VELOCITY];
        holds.timing.data[axis * TIMING_SIZE + TIMING_START] = end[DELAYED_STATE_DELAY];
        holds.timing.data[axis * TIMING_SIZE + TIMING_LENGTH] = hold;
        holds.offsets.data[axis] = axis;
        for (int64_t i = 0; i < 2 * n; i++) {
            piece[i] = 0.0;
        }
        piece[PIECE_POSITION] = end[WAYPOINT_STATE_POSITION];
        piece[PIECE_VELOCITY] = velocity;
        last[WAYPOINT_STATE_POSITION] = end[WAYPOINT_STATE_POSITION] + velocity * hold;
        times[axis] = 0.0;
        times[k + axis] = times[2 * k + axis] = duration;
        if (anchored) {
            double there[] = {end[WAYPOINT_STATE_POSITION], velocity, 0.0};
            array_int64_t_1d part = {leads.offsets.data + axis, {2}};
            segfmu_anchor_plan(matrix(there, 1, STATE), span_rows(&t->limits, axis, axis + 1),
                               leads.timing, leads.coefficients, part);
        }
    }
    holds.offsets.data[k] = k;
    if (anchored) {
        segfmu_start_states(&leads, n, states);
    }
}

/* Take what is left of the old plan as leads; 0 if it does not end at the velocities. */
static int follow_rest(const replanning *t, const double *targets, double *ends)
{
    const int64_t k = t->axes;
    const piece_list leads = segfmu_part(t, PLAN_PART_LEADS);
    segfmu_follow_rest(t);
    segfmu_end_pieces(&leads, ends);
    return segfmu_are_at_velocities(matrix((double *)targets, k, t->smoothness + 1), t->limits,
                                    matrix(ends, k, DELAYED_STATE_SIZE));
}

/* Leads between the states (2, k, n + 1), with their ends (k, DelayedState); the first axis that has
   none, or -1. */
static int64_t find_leads(const replanning *t, double *states, double *ends)
{
    const int64_t k = t->axes;
    const piece_list rest = segfmu_part(t, PLAN_PART_FOLLOWED);
    const piece_list leads = segfmu_part(t, PLAN_PART_LEADS);
    double *space = t->space, *found = take(&space, k * LEAD_END_SIZE);
    double *task = t->lead.data + LEAD_WORK_TASK * LEAD_WORK_COLUMNS;
    task[LEAD_TASK_ORDER] = LEAD_STAGE_VELOCITY;
    task[LEAD_TASK_MEETING] = -1.0;
    task[LEAD_TASK_SHAPE] = SHAPE_PLATEAU;
    const int64_t failed = segfmu_find_leads(
        cuboid(states, 2, k, t->smoothness + 1), t->limits, t->lower, rest.offsets, rest.timing,
        rest.coefficients, matrix(found, k, LEAD_END_SIZE), t->lead, leads.timing,
        leads.coefficients, leads.offsets);
    for (int64_t axis = 0; axis < k; axis++) {
        memcpy(ends + axis * DELAYED_STATE_SIZE, found + axis * LEAD_END_SIZE,
               DELAYED_STATE_SIZE * sizeof *ends);
    }
    return failed;
}

/* The states (2, k, n + 1): now, and there with the velocities. */
static void set_states(const replanning *t, const double *velocities, double *states)
{
    const int64_t width = t->smoothness + 1;
    for (int64_t axis = 0; axis < t->axes; axis++) {
        const double *now = t->now + axis * width;
        double *last = states + (t->axes + axis) * width;
        for (int64_t i = 0; i < width; i++) {
            states[axis * width + i] = now[i];
            last[i] = 0.0;
        }
        last[WAYPOINT_STATE_POSITION] = now[WAYPOINT_STATE_POSITION];
        last[WAYPOINT_STATE_VELOCITY] = velocities[axis];
    }
}

/* PLANNED, or why limits or velocities are refused; settles the velocities. */
static int check_velocities(const replanning *t, const double *velocities, double *states,
                            double *report)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    const int status = segfmu_settle_targets(t, 2, states, report);
    if (status != PLAN_STATUS_PLANNED) {
        return status;
    }
    for (int64_t axis = 0; axis < k; axis++) {
        const double velocity = states[(k + axis) * width + WAYPOINT_STATE_VELOCITY];
        const double upper = t->limits.data[axis * width];
        const double lower = t->lower.data[axis * LOWER_SIZE + LOWER_VELOCITY];
        const double bound = velocity < 0.0 && lower > 0.0 ? lower : upper;
        if (fabs(velocity) > bound) {
            report[REFUSAL_AXIS] = (double)axis;
            report[REFUSAL_INTERVAL] = 1.0;
            report[REFUSAL_VALUE] = velocities[axis];
            report[REFUSAL_BOUND] = bound;
            report[REFUSAL_SIDE] = bound < upper || bound > upper;
            return PLAN_STATUS_WAYPOINT_VELOCITY;
        }
    }
    memset(report, 0, SEGFMU_REPORT * sizeof *report);
    return PLAN_STATUS_PLANNED;
}

/* The trajectory of leads to velocities and what is held behind them, judged. */
static int join_holds(const replanning *t, double *states, double *times,
                      segfmu_trajectory *trajectory)
{
    const piece_list leads = segfmu_part(t, PLAN_PART_LEADS);
    const piece_list holds = segfmu_part(t, PLAN_PART_BEHIND);
    const piece_list whole = segfmu_part(t, PLAN_PART_WHOLE);
    segfmu_join_plans(leads.timing, leads.coefficients, leads.offsets, holds.timing,
                      holds.coefficients, holds.offsets, whole.timing, whole.coefficients,
                      whole.offsets);
    return segfmu_judge(t, &whole, 2, states, times, trajectory);
}

/* The trajectory of leads to velocities, from the rest of the old plan or without it. */
static int reach(const replanning *t, int resting, double *states, double *times,
                 segfmu_trajectory *trajectory)
{
    replanning inner = *t;
    double *ends = take(&inner.space, t->axes * DELAYED_STATE_SIZE);
    const double *targets = states + t->axes * (t->smoothness + 1);
    const int64_t failed = find_leads(&inner, states, ends);
    if (failed >= 0) {
        trajectory->report[REFUSAL_AXIS] = (double)failed;
        return PLAN_STATUS_NO_PROFILE;
    }
    int status = PLAN_STATUS_CHECK_FAILED;
    /* anchored: rounding errors of the whole old plan against its last bit; then leads that are
       shorter than the clock resolves */
    for (int attempt = 0; attempt < 3 && status == PLAN_STATUS_CHECK_FAILED; attempt++) {
        if (attempt == 2 && !(resting && follow_rest(t, targets, ends))) {
            break;
        }
        hold_velocities(t, attempt > 0, ends, states, times);
        status = join_holds(t, states, times, trajectory);
    }
    return status;
}

int segfmu_reach_velocity(const segfmu_trajectory *old, double time, const double *velocities,
                          const double *limits, const double *lower, double *space,
                          segfmu_trajectory *trajectory)
{
    memset(trajectory->report, 0, sizeof trajectory->report);
    if (!(time >= 0.0 && isfinite(time))) {
        return PLAN_STATUS_OUT_OF_RANGE;
    }
    replanning t = segfmu_begin_replanning(old, time, 2, limits, lower, space);
    const int64_t k = t.axes, n = t.smoothness;
    double *times = take(&t.space, 3 * k), *states = take(&t.space, 2 * k * (n + 1));
    set_states(&t, velocities, states);
    int status = check_velocities(&t, velocities, states, trajectory->report);
    if (status != PLAN_STATUS_PLANNED) {
        return status;
    }
    status = reach(&t, 1, states, times, trajectory);
    if (status == PLAN_STATUS_CHECK_FAILED) {
        /* what is left of the old plan need not keep the new limits */
        const piece_list rest = segfmu_part(&t, PLAN_PART_FOLLOWED);
        memset(rest.offsets.data, 0, (size_t)(k + 1) * sizeof *rest.offsets.data);
        set_states(&t, velocities, states);
        status = check_velocities(&t, velocities, states, trajectory->report);
        if (status == PLAN_STATUS_PLANNED) {
            status = reach(&t, 0, states, times, trajectory);
        }
    }
    return status;
}
