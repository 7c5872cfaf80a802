/* Reaching a velocity: leads to it, which is then held until all axes have it. */
#include "lead.h"

/* What each axis holds after its lead to a velocity, with states and times; anchors the leads. */
static void hold_velocities(replanning *t, const double *velocities, int anchored, double *states,
                            double *times)
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
        t->plan.timing.data[axis * TIMING_SIZE + TIMING_START] = end[DELAYED_STATE_DELAY];
        t->plan.timing.data[axis * TIMING_SIZE + TIMING_LENGTH] = hold;
        t->plan.offsets.data[axis] = axis;
        for (int64_t i = 0; i < 2 * n; i++) {
            piece[i] = 0.0;
        }
        end[WAYPOINT_STATE_VELOCITY] = velocities[axis];
        end[WAYPOINT_STATE_ACCELERATION] = 0.0;
        piece[PIECE_POSITION] = end[WAYPOINT_STATE_POSITION];
        piece[PIECE_VELOCITY] = velocities[axis];
        for (int64_t i = 0; i <= n; i++) {
            states[axis * (n + 1) + i] = t->now[axis * (n + 1) + i];
            last[i] = 0.0;
        }
        last[WAYPOINT_STATE_POSITION] = end[WAYPOINT_STATE_POSITION] + velocities[axis] * hold;
        last[WAYPOINT_STATE_VELOCITY] = velocities[axis];
        times[axis] = 0.0;
        times[k + axis] = times[2 * k + axis] = duration;
        if (anchored) {
            array_int64_t_1d part = {t->leads.offsets.data + axis, {2}};
            array_double_2d limits = matrix((double *)t->limits + axis * (n + 1), 1, n + 1);
            segfmu_anchor_plan(matrix(end, 1, STATE), limits, t->leads.timing,
                               t->leads.coefficients, part);
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
    t->leads = t->rest;
    for (int64_t axis = 0; axis < t->axes; axis++) {
        double *end = t->ends + axis * DELAYED_STATE_SIZE;
        segfmu_rest_end(t, axis, end);
        if (!segfmu_ends_at_velocity(t, axis, targets + axis * STATE, end, 0)) {
            return 0;
        }
    }
    return 1;
}

int segfmu_reach_velocity(const segfmu_trajectory *old, double time, const double *velocities,
                          const double *limits, double *space, segfmu_trajectory *trajectory)
{
    for (int i = 0; i < REFUSAL_SIZE; i++) {
        trajectory->report[i] = 0.0;
    }
    if (!(time >= 0.0)) {
        return PLAN_STATUS_OUT_OF_RANGE;
    }
    replanning t = segfmu_begin_replanning(old, time, 2, limits, space);
    const int64_t k = t.axes, n = t.smoothness;
    double *targets = take(&t.space, k * STATE), *times = take(&t.space, 3 * k);
    double *states = take(&t.space, 2 * k * (n + 1));
    for (int64_t axis = 0; axis < k; axis++) {
        targets[axis * STATE + WAYPOINT_STATE_POSITION] = 0.0;
        targets[axis * STATE + WAYPOINT_STATE_VELOCITY] = velocities[axis];
        targets[axis * STATE + WAYPOINT_STATE_ACCELERATION] = 0.0;
    }
    if (!segfmu_find_leads(&t, TO_VELOCITY, SHAPE_PLATEAU, targets)) {
        return PLAN_STATUS_NO_PROFILE;
    }
    int status = PLAN_STATUS_CHECK_FAILED;
    /* anchored: rounding errors of the whole old plan against its last bit; then leads that are
       shorter than the clock resolves */
    for (int attempt = 0; attempt < 3 && status == PLAN_STATUS_CHECK_FAILED; attempt++) {
        if (attempt == 2 && !follow_rest(&t, targets)) {
            break;
        }
        hold_velocities(&t, velocities, attempt > 0, states, times);
        status = segfmu_join_leads(&t, 2, states, times, t.space, trajectory);
    }
    return status;
}
