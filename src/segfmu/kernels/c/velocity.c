/* Reaching a velocity: leads to it, which is then held until all axes have it. */
#include "lead.h"

/* What each axis holds after its lead to a velocity, with times and the state where that ends;
   anchors the leads. The velocities are those of the last states. */
static void hold_velocities(replanning *t, int anchored, double *states, double *times)
{
    const int64_t k = t->axes, n = t->smoothness;
    double duration = 0.0;
    for (int64_t axis = 0; axis < k; axis++) {
        duration = span_max(duration, t->ends[axis * DELAYED_STATE_SIZE + DELAYED_STATE_DELAY]);
    }
    for (int64_t axis = 0; axis < k; axis++) {
        double *end = t->ends + axis * DELAYED_STATE_SIZE;
        const double hold = duration - end[DELAYED_STATE_DELAY];
        double *piece = t->plan.coefficients.data + axis * 2 * n;
        double *last = states + (k + axis) * (n + 1);
        const double velocity = last[WAYPOINT_STATE_VELOCITY];
        t->plan.timing.data[axis * TIMING_SIZE + TIMING_START] = end[DELAYED_STATE_DELAY];
        t->plan.timing.data[axis * TIMING_SIZE + TIMING_LENGTH] = hold;
        t->plan.offsets.data[axis] = axis;
        for (int64_t i = 0; i < 2 * n; i++) {
            piece[i] = 0.0;
        }
        end[WAYPOINT_STATE_VELOCITY] = velocity;
        end[WAYPOINT_STATE_ACCELERATION] = 0.0;
        piece[PIECE_POSITION] = end[WAYPOINT_STATE_POSITION];
        piece[PIECE_VELOCITY] = velocity;
        last[WAYPOINT_STATE_POSITION] = end[WAYPOINT_STATE_POSITION] + velocity * hold;
        times[axis] = 0.0;
        times[k + axis] = times[2 * k + axis] = duration;
        if (anchored) {
            array_int64_t_1d part = {t->leads.offsets.data + axis, {2}};
            segfmu_anchor_plan(matrix(end, 1, STATE), span_rows(&t->limits, axis, axis + 1),
                               t->leads.timing, t->leads.coefficients, part);
        }
    }
    t->plan.offsets.data[k] = k;
    if (anchored) {
        segfmu_start_states(&t->leads, n, states);
    }
}

/* Take what is left of the old plan as leads; 0 if it does not end at the velocities. */
static int follow_rest(replanning *t, const double *targets)
{
    const int64_t k = t->axes;
    t->leads = t->rest;
    segfmu_end_rest(t);
    return segfmu_are_at_velocities(matrix((double *)targets, k, t->smoothness + 1), t->limits,
                                    matrix(t->ends, k, DELAYED_STATE_SIZE));
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

/* The trajectory of leads to velocities, from the rest of the old plan or without it. */
static int join_velocities(replanning *t, int resting, const double *targets, double *states,
                           double *times, segfmu_trajectory *trajectory)
{
    const int64_t failed = segfmu_settle_axes(t, LEAD_STAGE_VELOCITY, SHAPE_PLATEAU, -1.0, targets);
    if (failed >= 0) {
        trajectory->report[REFUSAL_AXIS] = (double)failed;
        return PLAN_STATUS_NO_PROFILE;
    }
    int status = PLAN_STATUS_CHECK_FAILED;
    /* anchored: rounding errors of the whole old plan against its last bit; then leads that are
       shorter than the clock resolves */
    for (int attempt = 0; attempt < 3 && status == PLAN_STATUS_CHECK_FAILED; attempt++) {
        if (attempt == 2 && !(resting && follow_rest(t, targets))) {
            break;
        }
        hold_velocities(t, attempt > 0, states, times);
        status = segfmu_join_leads(t, 2, states, times, t->space, trajectory);
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
    const double *targets = states + k * (n + 1);
    set_states(&t, velocities, states);
    int status = check_velocities(&t, velocities, states, trajectory->report);
    if (status != PLAN_STATUS_PLANNED) {
        return status;
    }
    const piece_list leads = t.leads;
    status = join_velocities(&t, 1, targets, states, times, trajectory);
    if (status == PLAN_STATUS_CHECK_FAILED) {
        /* what is left of the old plan need not keep the new limits */
        for (int64_t axis = 0; axis <= k; axis++) {
            t.rest.offsets.data[axis] = 0;
        }
        t.leads = leads;
        set_states(&t, velocities, states);
        status = check_velocities(&t, velocities, states, trajectory->report);
        if (status == PLAN_STATUS_PLANNED) {
            status = join_velocities(&t, 0, targets, states, times, trajectory);
        }
    }
    return status;
}
