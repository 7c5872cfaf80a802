/* What is left of the old plan, leads from it (segfmu_find_lead), and the check of what follows. */
#include "lead.h"

#include <math.h>
#include <string.h>

/* of velocity and acceleration at the end of a plan, relative to their limits */
static const double ROUNDING = 1e-11;

/* As many rows as a plan takes, as the leads take, and as the old plan has. */
static int64_t most_rows(int64_t points, int64_t axes, int64_t smoothness, int64_t old)
{
    const int64_t leads = axes * LEAD_ROWS_PIECES, rest = old + axes + 1;
    return segfmu_most_pieces(points, axes, smoothness) + (leads > rest ? leads : rest);
}

size_t segfmu_replan_size(int64_t points, int64_t axes, int64_t smoothness, int64_t pieces)
{
    const int64_t rows = most_rows(points, axes, smoothness, pieces);
    const int64_t piece = TIMING_SIZE + 2 * smoothness;
    const int64_t cells = (points - 1) * axes;
    const int64_t lists = 5 * (rows * piece + axes + 1);
    const int64_t lead = LEAD_WORK_SIZE * LEAD_WORK_COLUMNS + LEAD_ROWS_ALL * piece + 2 * axes
        + (BRAKE_SIZE + 2) * axes;
    const int64_t planned = points * (axes * (DELAYED_STATE_SIZE + smoothness + 1) + 1)
        + PLAN_OPTIONS_SIZE + axes * AXIS_SIZE + cells * CELL_SIZE * CELL_COLUMNS
        + PLAN_WORK_SIZE * PLAN_WORK_COLUMNS + EXPANSION_SIZE * EXPANSION_COLUMNS
        + CHECK_SIZE * CHECK_COLUMNS + 2 * (points + 1) * axes;
    return (size_t)(lists + lead + planned
                    + axes * (smoothness + 1 + DELAYED_STATE_SIZE + LOWER_SIZE) + points);
}

void segfmu_start_states(const piece_list *list, int64_t smoothness, double *states)
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

replanning segfmu_begin_replanning(
    const segfmu_trajectory *old, double time, int64_t points, const double *limits,
    const double *lower, double *space)
{
    const int64_t k = old->axes, n = old->smoothness, rows = most_rows(points, k, n, old->pieces);
    replanning t = {.axes = k, .smoothness = n, .limits = matrix((double *)limits, k, n + 1)};
    t.lower = segfmu_gather_lower(lower, k, &space);
    t.now = take(&space, k * (n + 1));
    t.ends = take(&space, k * DELAYED_STATE_SIZE);
    t.outside = take(&space, k);
    t.rest = segfmu_take_pieces(&space, rows, k, n);
    t.leads = segfmu_take_pieces(&space, rows, k, n);
    t.plan = segfmu_take_pieces(&space, rows, k, n);
    t.joined = segfmu_take_pieces(&space, 2 * rows, k, n);
    t.space = space;
    segfmu_cut_rest(old, time, &t.rest);
    segfmu_start_states(&t.rest, n, t.now);
    return t;
}

void segfmu_cut_rest(const segfmu_trajectory *old, double time, piece_list *rest)
{
    array_int64_t_1d offsets = {(int64_t *)old->offsets, {old->axes + 1}};
    segfmu_cut_plan(time, matrix((double *)old->timing, old->pieces, TIMING_SIZE),
                    matrix((double *)old->coefficients, old->pieces, 2 * old->smoothness), offsets,
                    rest->timing, rest->coefficients, rest->offsets);
}

int segfmu_settle_targets(
    const replanning *t, int64_t points, double *states, double *report)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    segfmu_settle_states(1, cuboid(states, points, k, width), t->limits, t->lower);
    const int64_t status = segfmu_check_problem(
        cuboid(states, points, k, width), t->limits, vector(report, REFUSAL_SIZE));
    if (status == PLAN_STATUS_PLANNED) {
        memset(report, 0, SEGFMU_REPORT * sizeof *report);
    }
    return (int)status;
}

void segfmu_rest_end(const replanning *t, int64_t axis, double *end)
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

/* Copy pieces to row `to` of a list. */
static void copy_rows(piece_list *list, int64_t to, const double *timing,
                      const double *coefficients, int64_t rows)
{
    const int64_t width = list->coefficients.shape[1];
    memmove(list->timing.data + to * TIMING_SIZE, timing,
            (size_t)(rows * TIMING_SIZE) * sizeof *timing);
    memmove(list->coefficients.data + to * width, coefficients,
            (size_t)(rows * width) * sizeof *coefficients);
}

int segfmu_ends_at_velocity(
    const replanning *t, int64_t axis, const double *target, const double *end, int found)
{
    const double *limits = t->limits.data + axis * (t->smoothness + 1);
    const double missed = end[WAYPOINT_STATE_VELOCITY] - target[WAYPOINT_STATE_VELOCITY];
    return fabs(missed) <= ROUNDING * limits[0]
        && fabs(end[WAYPOINT_STATE_ACCELERATION]) <= ROUNDING * limits[1]
        && (!found || end[DELAYED_STATE_DELAY] < t->ends[axis * DELAYED_STATE_SIZE
                                                         + DELAYED_STATE_DELAY]);
}

/* What the leads of all axes are searched with. */
typedef struct {
    int64_t order, shape;
    const double *targets;
    array_double_2d work, timing, coefficients;
} lead_search;

/* A lead of one axis, from row `to` of t->leads on; the number of its pieces, -1: there is none.
   It goes over levels if others take longer than `within`. */
static int64_t find_one(replanning *t, const lead_search *s, int64_t axis, double within,
                        int64_t to)
{
    const int64_t width = t->smoothness + 1;
    const double *target = s->targets + axis * width;
    double *now = s->work.data + LEAD_WORK_NOW * LEAD_WORK_COLUMNS;
    double *aim = s->work.data + LEAD_WORK_TARGET * LEAD_WORK_COLUMNS;
    const double *reached = s->work.data + LEAD_WORK_REACHED * LEAD_WORK_COLUMNS;
    const double *best = s->work.data + LEAD_WORK_BEST * LEAD_WORK_COLUMNS;
    double *end = t->ends + axis * DELAYED_STATE_SIZE, last[DELAYED_STATE_SIZE];
    for (int64_t i = 0; i < width; i++) {
        now[i] = t->now[axis * width + i];
    }
    aim[PROBLEM_DISTANCE] = target[WAYPOINT_STATE_POSITION];
    aim[PROBLEM_W] = target[WAYPOINT_STATE_VELOCITY];
    aim[PROBLEM_B] = target[WAYPOINT_STATE_ACCELERATION];
    s->work.data[LEAD_WORK_AXIS * LEAD_WORK_COLUMNS + AXIS_SHAPE] = (double)s->shape;
    for (int64_t i = 0; i < LOWER_SIZE; i++) {
        s->work.data[LEAD_WORK_LOWER * LEAD_WORK_COLUMNS + i] = t->lower.data[axis * LOWER_SIZE + i];
    }
    s->work.data[LEAD_WORK_BEST * LEAD_WORK_COLUMNS + LEAD_BRAKES] = 1.0;
    int found = segfmu_find_lead(
        s->order, within, axis, t->rest.offsets, t->rest.timing, t->rest.coefficients,
        span_row(&t->limits, axis), s->work, s->timing, s->coefficients);
    for (int64_t i = 0; i < STATE; i++) {
        end[i] = reached[i];
    }
    end[DELAYED_STATE_DELAY] = reached[CHAIN_TIME];
    const int64_t first = t->rest.offsets.data[axis];
    const int64_t rows = t->rest.offsets.data[axis + 1] - first;
    if (s->order == TO_VELOCITY && rows > 0) {
        segfmu_rest_end(t, axis, last);
        if (segfmu_ends_at_velocity(t, axis, target, last, found)) {
            memcpy(end, last, sizeof last);
            copy_rows(&t->leads, to, t->rest.timing.data + first * TIMING_SIZE,
                      t->rest.coefficients.data + first * 2 * t->smoothness, rows);
            return rows;
        }
    }
    if (!found) {
        return -1;
    }
    copy_rows(&t->leads, to, s->timing.data, s->coefficients.data, (int64_t)best[LEAD_COUNT]);
    return (int64_t)best[LEAD_COUNT];
}

/* Leads of axes that meet at the targets after the time `latest` or later: only those that are late
   make haste, so that the planner can slow the others down. */
static int64_t find_meeting(replanning *t, const lead_search *s, double latest, double *space)
{
    double *times = take(&space, t->axes), *counts = take(&space, t->axes);
    const double *time = s->work.data + LEAD_WORK_BEST * LEAD_WORK_COLUMNS + LEAD_TIME;
    for (int64_t axis = 0; axis < t->axes; axis++) {
        const int64_t rows = find_one(t, s, axis, INFINITY, axis * LEAD_ROWS_PIECES);
        if (rows < 0) {
            return axis;
        }
        counts[axis] = (double)rows;
        times[axis] = *time;
    }
    for (int64_t i = 0; i < t->axes; i++) {
        int64_t last = 0;
        for (int64_t axis = 1; axis < t->axes; axis++) {
            last = times[axis] > times[last] ? axis : last;
        }
        if (times[last] <= latest) {
            break;
        }
        const int64_t rows = find_one(t, s, last, latest, last * LEAD_ROWS_PIECES);
        if (rows < 0) {
            return last;
        }
        counts[last] = (double)rows;
        latest = span_max(latest, *time);
        times[last] = -1.0;
    }
    for (int64_t axis = 0; axis < t->axes; axis++) {
        const int64_t from = axis * LEAD_ROWS_PIECES, to = t->leads.offsets.data[axis];
        const int64_t width = t->leads.coefficients.shape[1], rows = (int64_t)counts[axis];
        copy_rows(&t->leads, to, t->leads.timing.data + from * TIMING_SIZE,
                  t->leads.coefficients.data + from * width, rows);
        t->leads.offsets.data[axis + 1] = to + rows;
    }
    return -1;
}

int64_t segfmu_find_leads(replanning *t, int64_t order, int64_t shape, double meeting,
                          const double *targets)
{
    const int64_t n = t->smoothness, rows = LEAD_ROWS_ALL;
    double *space = t->space;
    lead_search s = {order, shape, targets,
                     matrix(take(&space, LEAD_WORK_SIZE * LEAD_WORK_COLUMNS), LEAD_WORK_SIZE,
                            LEAD_WORK_COLUMNS),
                     matrix(take(&space, rows * TIMING_SIZE), rows, TIMING_SIZE),
                     matrix(take(&space, rows * 2 * n), rows, 2 * n)};
    for (int64_t i = 0; i < LEAD_WORK_SIZE * LEAD_WORK_COLUMNS; i++) {
        s.work.data[i] = 0.0;
    }
    t->leads.offsets.data[0] = 0;
    if (meeting >= 0.0 && t->axes > 1) {
        return find_meeting(t, &s, meeting, space);
    }
    for (int64_t axis = 0; axis < t->axes; axis++) {
        const int64_t to = t->leads.offsets.data[axis];
        const int64_t count = find_one(t, &s, axis, span_max(meeting, 0.0), to);
        if (count < 0) {
            return axis;
        }
        t->leads.offsets.data[axis + 1] = to + count;
    }
    return -1;
}

/* The brakes (k, Brake) of the states (k, n + 1), zeros where they can stay inside; whether there is
   one. */
static int find_brakes(const replanning *t, const double *states, double *brakes, double *space)
{
    const int64_t n = t->smoothness;
    array_double_2d work = matrix(take(&space, LEAD_WORK_SIZE * LEAD_WORK_COLUMNS),
                                  LEAD_WORK_SIZE, LEAD_WORK_COLUMNS);
    array_double_2d timing = matrix(take(&space, LEAD_ROWS_ALL * TIMING_SIZE), LEAD_ROWS_ALL,
                                    TIMING_SIZE);
    array_double_2d coefficients = matrix(take(&space, LEAD_ROWS_ALL * 2 * n), LEAD_ROWS_ALL,
                                          2 * n);
    int any = 0;
    memset(work.data, 0, LEAD_WORK_SIZE * LEAD_WORK_COLUMNS * sizeof *work.data);
    for (int64_t axis = 0; axis < t->axes; axis++) {
        double *brake = brakes + axis * BRAKE_SIZE;
        const double *found = work.data + LEAD_WORK_BRAKE * LEAD_WORK_COLUMNS;
        memset(brake, 0, BRAKE_SIZE * sizeof *brake);
        memcpy(work.data + LEAD_WORK_NOW * LEAD_WORK_COLUMNS, states + axis * (n + 1),
               (size_t)(n + 1) * sizeof *states);
        memcpy(work.data + LEAD_WORK_LOWER * LEAD_WORK_COLUMNS, t->lower.data + axis * LOWER_SIZE,
               LOWER_SIZE * sizeof *t->lower.data);
        if (segfmu_find_brake(0, span_row(&t->limits, axis), work, timing, coefficients) > 0) {
            memcpy(brake, found, BRAKE_SIZE * sizeof *brake);
            any = any || brake[BRAKE_UNTIL] > 0.0;
        }
    }
    return any;
}

int segfmu_judge_pieces(
    const replanning *t, const piece_list *found, int64_t points, double *states, double *times,
    double *space, segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes, n = t->smoothness;
    array_double_2d check = matrix(take(&space, CHECK_SIZE * CHECK_COLUMNS), CHECK_SIZE,
                                   CHECK_COLUMNS);
    double *brakes = take(&space, k * BRAKE_SIZE);
    segfmu_describe(found, points, times, trajectory);
    memset(t->outside, 0, (size_t)k * sizeof *t->outside);
    trajectory->outside = t->outside;
    /* as nothing judges it once more, nearly all of the tolerance is used */
    int64_t wrong = segfmu_check_plan(
        cuboid(states, points, k, n + 1), matrix(times, points + 1, k), found->timing,
        found->coefficients, found->offsets, t->limits, t->lower, PLAN_TOLERANCE,
        0.95 * PLAN_TOLERANCE, check);
    if (wrong > 0 && find_brakes(t, states, brakes, space)) {
        wrong = segfmu_check_braked_plan(
            cuboid(states, points, k, n + 1), matrix(times, points + 1, k), found->timing,
            found->coefficients, found->offsets, t->limits, t->lower,
            matrix(brakes, k, BRAKE_SIZE), PLAN_TOLERANCE, 0.95 * PLAN_TOLERANCE, check);
        for (int64_t axis = 0; axis < k; axis++) {
            t->outside[axis] = brakes[axis * BRAKE_SIZE + BRAKE_UNTIL];
        }
    }
    return wrong == 0 ? PLAN_STATUS_PLANNED : PLAN_STATUS_CHECK_FAILED;
}

int segfmu_join_leads(
    replanning *t, int64_t points, double *states, double *times, double *space,
    segfmu_trajectory *trajectory)
{
    segfmu_join_plans(t->leads.timing, t->leads.coefficients, t->leads.offsets, t->plan.timing,
                      t->plan.coefficients, t->plan.offsets, t->joined.timing,
                      t->joined.coefficients, t->joined.offsets);
    return segfmu_judge_pieces(t, &t->joined, points, states, times, space, trajectory);
}
