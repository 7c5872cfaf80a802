/* Replanning: leads from the old plan (find_lead), the planner behind them, and what is left of the
   old plan as the last resort. */
#include "replan.h"

#include <math.h>

#include "arrays.h"
#include "records.h"

enum { TO_VELOCITY = 1, TO_PLAN = 2, STATE = WAYPOINT_STATE_SIZE };

/* a plan to the same target replaces the rest of the old one if it takes less than this share */
static const double SHORTER = 0.99;
static const double TOLERANCE = 1e-9;

/* The pieces of all axes. */
typedef struct {
    array_double_2d timing, coefficients;
    array_int64_t_1d offsets;
} pieces;

/* What one call works with; `rest` is what is left of the old plan. */
typedef struct {
    int64_t axes, smoothness, rows;
    const double *limits;
    double *now;                 /* (k, n + 1): state at the start */
    double *ends;                /* (k, DelayedState): where leads end */
    pieces rest, leads, plan, joined;
    double *space;
} task;

static double *take(double **space, int64_t count)
{
    double *taken = *space;
    *space += count;
    return taken;
}

static pieces take_pieces(double **space, int64_t rows, int64_t axes, int64_t smoothness)
{
    pieces p;
    p.timing = matrix(take(space, rows * TIMING_SIZE), rows, TIMING_SIZE);
    p.coefficients = matrix(take(space, rows * 2 * smoothness), rows, 2 * smoothness);
    p.offsets.data = (int64_t *)(void *)take(space, axes + 1);
    p.offsets.shape[0] = axes + 1;
    return p;
}

/* As many rows as plan.c has for a plan, as the leads take, and as the old plan has. */
static int64_t most_rows(int64_t points, int64_t axes, int64_t smoothness, int64_t old)
{
    const int64_t profiles = 2 * (CELL_ABOVE - CELL_BELOW);
    const int64_t interval = profiles * ((INT64_C(1) << (smoothness - 1)) - 1) + 1;
    const int64_t plan = ((points - 1) * interval + 2) * axes + SPARE_ROWS;
    const int64_t leads = axes * LEAD_ROWS_PIECES, rest = old + axes + 1;
    return plan + (leads > rest ? leads : rest);
}

size_t segfmu_replan_size(int64_t points, int64_t axes, int64_t smoothness, int64_t pieces)
{
    const int64_t rows = most_rows(points, axes, smoothness, pieces);
    const int64_t piece = TIMING_SIZE + 2 * smoothness;
    const int64_t cells = (points - 1) * axes;
    const int64_t lists = 5 * (rows * piece + axes + 1);
    const int64_t lead = LEAD_WORK_SIZE * LEAD_WORK_COLUMNS + 2 * LEAD_ROWS_PIECES * piece;
    const int64_t planned = points * axes * (DELAYED_STATE_SIZE + smoothness + 1)
        + PLAN_OPTIONS_SIZE + axes * AXIS_SIZE + cells * CELL_SIZE * CELL_COLUMNS
        + PLAN_WORK_SIZE * PLAN_WORK_COLUMNS + EXPANSION_SIZE * EXPANSION_COLUMNS
        + CHECK_SIZE * CHECK_COLUMNS + 2 * (points + 1) * axes;
    return (size_t)(lists + lead + planned
                    + axes * (smoothness + 1 + DELAYED_STATE_SIZE) + points);
}

/* The states (k, n + 1) in which the pieces of axes begin; that of an axis without stays. */
static void start_states(const pieces *list, int64_t smoothness, double *states)
{
    for (int64_t axis = 0; axis + 1 < list->offsets.shape[0]; axis++) {
        const int64_t row = list->offsets.data[axis];
        const double *first = list->coefficients.data + row * 2 * smoothness;
        double factorial = 1.0;
        for (int64_t i = 0; i <= smoothness && row < list->offsets.data[axis + 1]; i++) {
            factorial *= i > 1 ? (double)i : 1.0;
            states[axis * (smoothness + 1) + i] = first[i] * factorial;
        }
    }
}

static task begin(const segfmu_trajectory *old, double time, int64_t points,
                  const double *limits, double *space)
{
    const int64_t k = old->axes, n = old->smoothness;
    task t = {.axes = k, .smoothness = n, .rows = most_rows(points, k, n, old->pieces),
              .limits = limits};
    t.now = take(&space, k * (n + 1));
    t.ends = take(&space, k * DELAYED_STATE_SIZE);
    t.rest = take_pieces(&space, t.rows, k, n);
    t.leads = take_pieces(&space, t.rows, k, n);
    t.plan = take_pieces(&space, t.rows, k, n);
    t.joined = take_pieces(&space, 2 * t.rows, k, n);
    t.space = space;
    array_int64_t_1d offsets = {(int64_t *)old->offsets, {k + 1}};
    segfmu_cut_plan(time, matrix((double *)old->timing, old->pieces, TIMING_SIZE),
                    matrix((double *)old->coefficients, old->pieces, 2 * n), offsets,
                    t.rest.timing, t.rest.coefficients, t.rest.offsets);
    start_states(&t.rest, n, t.now);
    return t;
}

/* Where the rest of an axis ends, and when: DelayedState. */
static void rest_end(const task *t, int64_t axis, double *end)
{
    const int64_t last = t->rest.offsets.data[axis + 1] - 1, width = 2 * t->smoothness;
    const double *when = t->rest.timing.data + last * TIMING_SIZE;
    const double *piece = t->rest.coefficients.data + last * width;
    const double length = when[TIMING_LENGTH];
    for (int64_t order = 0; order < STATE; order++) {
        double value = 0.0;
        for (int64_t i = width - 1; i >= order; i--) {
            double factor = 1.0;
            for (int64_t m = 0; m < order; m++) {
                factor *= (double)(i - m);
            }
            value = value * length + factor * piece[i];
        }
        end[order] = value;
    }
    end[DELAYED_STATE_DELAY] = when[TIMING_START] + length;
}

static void append(pieces *list, int64_t *count, const double *timing, const double *coefficients,
                   int64_t rows)
{
    const int64_t width = list->coefficients.shape[1];
    for (int64_t i = 0; i < rows * TIMING_SIZE; i++) {
        list->timing.data[*count * TIMING_SIZE + i] = timing[i];
    }
    for (int64_t i = 0; i < rows * width; i++) {
        list->coefficients.data[*count * width + i] = coefficients[i];
    }
    *count += rows;
}

/* Whether the rest of an axis ends at its velocity before a lead does that was found, or not. */
static int is_kept(const task *t, int64_t axis, const double *target, const double *end, int found)
{
    const double *limits = t->limits + axis * (t->smoothness + 1);
    return fabs(end[WAYPOINT_STATE_VELOCITY] - target[WAYPOINT_STATE_VELOCITY]) <= 1e-11 * limits[0]
        && fabs(end[WAYPOINT_STATE_ACCELERATION]) <= 1e-11 * limits[1]
        && (!found || end[DELAYED_STATE_DELAY] < t->ends[axis * DELAYED_STATE_SIZE
                                                         + DELAYED_STATE_DELAY]);
}

/* The leads of all axes to targets (k, WaypointState); 0 if one has none. */
static int find_leads(task *t, int64_t order, int64_t shape, const double *targets)
{
    const int64_t k = t->axes, n = t->smoothness, rows = 2 * LEAD_ROWS_PIECES;
    double *space = t->space;
    array_double_2d work = matrix(take(&space, LEAD_WORK_SIZE * LEAD_WORK_COLUMNS),
                                  LEAD_WORK_SIZE, LEAD_WORK_COLUMNS);
    array_double_2d timing = matrix(take(&space, rows * TIMING_SIZE), rows, TIMING_SIZE);
    array_double_2d coefficients = matrix(take(&space, rows * 2 * n), rows, 2 * n);
    int64_t count = 0;
    for (int64_t i = 0; i < LEAD_WORK_SIZE * LEAD_WORK_COLUMNS; i++) {
        work.data[i] = 0.0;
    }
    double *now = work.data + LEAD_WORK_NOW * LEAD_WORK_COLUMNS;
    double *aim = work.data + LEAD_WORK_TARGET * LEAD_WORK_COLUMNS;
    const double *best = work.data + LEAD_WORK_BEST * LEAD_WORK_COLUMNS;
    const double *reached = work.data + LEAD_WORK_REACHED * LEAD_WORK_COLUMNS;
    t->leads.offsets.data[0] = 0;
    for (int64_t axis = 0; axis < k; axis++) {
        const double *target = targets + axis * STATE;
        double *end = t->ends + axis * DELAYED_STATE_SIZE, last[DELAYED_STATE_SIZE];
        work.data[LEAD_WORK_AXIS * LEAD_WORK_COLUMNS + AXIS_SHAPE] = (double)shape;
        for (int64_t i = 0; i <= n; i++) {
            now[i] = t->now[axis * (n + 1) + i];
        }
        aim[PROBLEM_DISTANCE] = target[WAYPOINT_STATE_POSITION];
        aim[PROBLEM_W] = target[WAYPOINT_STATE_VELOCITY];
        aim[PROBLEM_B] = target[WAYPOINT_STATE_ACCELERATION];
        int found = segfmu_find_lead(
            order, axis, t->rest.offsets, t->rest.timing, t->rest.coefficients,
            vector((double *)t->limits + axis * (n + 1), n + 1), work, timing, coefficients);
        for (int64_t i = 0; i < STATE; i++) {
            end[i] = reached[i];
        }
        end[DELAYED_STATE_DELAY] = reached[CHAIN_TIME];
        rest_end(t, axis, last);
        if (order == TO_VELOCITY && is_kept(t, axis, target, last, found)) {
            const int64_t first = t->rest.offsets.data[axis];
            for (int64_t i = 0; i < DELAYED_STATE_SIZE; i++) {
                end[i] = last[i];
            }
            append(&t->leads, &count, t->rest.timing.data + first * TIMING_SIZE,
                   t->rest.coefficients.data + first * 2 * n,
                   t->rest.offsets.data[axis + 1] - first);
        } else if (found) {
            append(&t->leads, &count, timing.data, coefficients.data, (int64_t)best[LEAD_COUNT]);
        } else {
            return 0;
        }
        t->leads.offsets.data[axis + 1] = count;
    }
    return 1;
}

/* Show pieces as the trajectory, judged; states (m, k, n + 1), times (m + 1, k). */
static int judge(const task *t, const pieces *found, int64_t points, double *states, double *times,
                 double *space, segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes, n = t->smoothness;
    array_double_2d check = matrix(take(&space, CHECK_SIZE * CHECK_COLUMNS), CHECK_SIZE,
                                   CHECK_COLUMNS);
    trajectory->points = points;
    trajectory->axes = k;
    trajectory->smoothness = n;
    trajectory->pieces = found->offsets.data[k];
    trajectory->timing = found->timing.data;
    trajectory->coefficients = found->coefficients.data;
    trajectory->offsets = found->offsets.data;
    trajectory->times = times;
    trajectory->ends = times + points * k;
    trajectory->duration = 0.0;
    for (int64_t axis = 0; axis < k; axis++) {
        trajectory->duration = span_max(trajectory->duration, trajectory->ends[axis]);
    }
    int64_t wrong = segfmu_check_plan(
        cuboid(states, points, k, n + 1), matrix(times, points + 1, k), found->timing,
        found->coefficients, found->offsets, matrix((double *)t->limits, k, n + 1), TOLERANCE,
        check);
    return wrong == 0 ? PLAN_STATUS_PLANNED : PLAN_STATUS_CHECK_FAILED;
}

/* States of the waypoints as far as derivative n; the first one is the start. */
static double *full_states(const task *t, const segfmu_problem *p, double **space)
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

/* The leads and what follows them, judged. */
static int join(task *t, int64_t points, double *states, double *times, double *space,
                segfmu_trajectory *trajectory)
{
    segfmu_join_plans(t->leads.timing, t->leads.coefficients, t->leads.offsets, t->plan.timing,
                      t->plan.coefficients, t->plan.offsets, t->joined.timing,
                      t->joined.coefficients, t->joined.offsets);
    return judge(t, &t->joined, points, states, times, space, trajectory);
}

/* The plan behind the leads. */
static int plan_after(task *t, const segfmu_problem *p, const double *full, double *space,
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
    return join(t, m, (double *)full, times, space, trajectory);
}

/* The rest of the old plan, which took `clock`, if it ends in the only target. */
static int keep_rest(task *t, const segfmu_problem *p, double clock, double *full,
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
        rest_end(t, axis, end);
        times[axis] = 0.0;
        times[k + axis] = times[2 * k + axis] = end[DELAYED_STATE_DELAY];
        double missed = target[WAYPOINT_STATE_POSITION] - end[WAYPOINT_STATE_POSITION];
        if (fabs(missed) > TOLERANCE * (fabs(target[WAYPOINT_STATE_POSITION])
                                        + t->limits[axis * width] * end[DELAYED_STATE_DELAY])) {
            return PLAN_STATUS_NO_PROFILE;
        }
    }
    if (judge(t, &t->rest, p->points, full, times, space, trajectory) == PLAN_STATUS_PLANNED) {
        return PLAN_STATUS_PLANNED;
    }
    /* rounding errors of a whole motion may be large against what is left of it */
    segfmu_anchor_plan(matrix(full + k * width, k, width), t->rest.timing, t->rest.coefficients,
                       t->rest.offsets);
    start_states(&t->rest, t->smoothness, full);
    return judge(t, &t->rest, p->points, full, times, space, trajectory);
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
    task t = begin(old, time, problem->points, problem->limits, space);
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
    if (find_leads(&t, TO_PLAN, problem->shape, targets)) {
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
            rest_end(&t, axis, t.ends + axis * DELAYED_STATE_SIZE);
        }
        /* with rounding errors in its velocity an axis at rest would count as moving */
        segfmu_settle_states(cuboid(t.ends, 1, t.axes, DELAYED_STATE_SIZE),
                             matrix((double *)t.limits, t.axes, t.smoothness + 1));
        status = plan_after(&t, problem, full, t.space, trajectory);
    }
    return status;
}

/* What each axis holds after its lead to a velocity, with states and times; anchors the leads. */
static void hold_velocities(task *t, const double *velocities, int anchored, double *states,
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
            segfmu_anchor_plan(matrix(end, 1, STATE), t->leads.timing, t->leads.coefficients,
                               part);
        }
    }
    t->plan.offsets.data[k] = k;
    if (anchored) {
        start_states(&t->leads, n, states);
    }
}

/* Take what is left of the old plan as leads; 0 if it does not end at the velocities. */
static int follow_rest(task *t, const double *targets)
{
    t->leads = t->rest;
    for (int64_t axis = 0; axis < t->axes; axis++) {
        double *end = t->ends + axis * DELAYED_STATE_SIZE;
        rest_end(t, axis, end);
        if (!is_kept(t, axis, targets + axis * STATE, end, 0)) {
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
    task t = begin(old, time, 2, limits, space);
    const int64_t k = t.axes, n = t.smoothness;
    double *targets = take(&t.space, k * STATE), *times = take(&t.space, 3 * k);
    double *states = take(&t.space, 2 * k * (n + 1));
    for (int64_t axis = 0; axis < k; axis++) {
        targets[axis * STATE + WAYPOINT_STATE_POSITION] = 0.0;
        targets[axis * STATE + WAYPOINT_STATE_VELOCITY] = velocities[axis];
        targets[axis * STATE + WAYPOINT_STATE_ACCELERATION] = 0.0;
    }
    if (!find_leads(&t, TO_VELOCITY, SHAPE_PLATEAU, targets)) {
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
        status = join(&t, 2, states, times, t.space, trajectory);
    }
    return status;
}
