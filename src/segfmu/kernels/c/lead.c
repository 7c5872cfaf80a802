/* What is left of the old plan, leads from it (segfmu_find_lead), and the check of what follows. */
#include "lead.h"

#include <math.h>

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
    const int64_t lead = LEAD_WORK_SIZE * LEAD_WORK_COLUMNS + 2 * LEAD_ROWS_PIECES * piece;
    const int64_t planned = points * axes * (DELAYED_STATE_SIZE + smoothness + 1)
        + PLAN_OPTIONS_SIZE + axes * AXIS_SIZE + cells * CELL_SIZE * CELL_COLUMNS
        + PLAN_WORK_SIZE * PLAN_WORK_COLUMNS + EXPANSION_SIZE * EXPANSION_COLUMNS
        + CHECK_SIZE * CHECK_COLUMNS + 2 * (points + 1) * axes;
    return (size_t)(lists + lead + planned
                    + axes * (smoothness + 1 + DELAYED_STATE_SIZE) + points);
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
    const segfmu_trajectory *old, double time, int64_t points, const double *limits, double *space)
{
    const int64_t k = old->axes, n = old->smoothness, rows = most_rows(points, k, n, old->pieces);
    replanning t = {.axes = k, .smoothness = n, .limits = matrix((double *)limits, k, n + 1)};
    t.now = take(&space, k * (n + 1));
    t.ends = take(&space, k * DELAYED_STATE_SIZE);
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
    segfmu_settle_states(cuboid(states + k * width, points - 1, k, width), t->limits);
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

static void append(piece_list *list, int64_t *count, const double *timing,
                   const double *coefficients, int64_t rows)
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

/* A lead of one axis to a target in the row BEST of work (LeadWork); 0 if there is none. */
static int find_one(replanning *t, int64_t order, int64_t axis, const double *target,
                    array_double_2d work, array_double_2d timing, array_double_2d coefficients)
{
    const int64_t width = t->smoothness + 1;
    double *now = work.data + LEAD_WORK_NOW * LEAD_WORK_COLUMNS;
    double *aim = work.data + LEAD_WORK_TARGET * LEAD_WORK_COLUMNS;
    const double *reached = work.data + LEAD_WORK_REACHED * LEAD_WORK_COLUMNS;
    double *end = t->ends + axis * DELAYED_STATE_SIZE;
    for (int64_t i = 0; i < width; i++) {
        now[i] = t->now[axis * width + i];
    }
    aim[PROBLEM_DISTANCE] = target[WAYPOINT_STATE_POSITION];
    aim[PROBLEM_W] = target[WAYPOINT_STATE_VELOCITY];
    aim[PROBLEM_B] = target[WAYPOINT_STATE_ACCELERATION];
    int found = segfmu_find_lead(
        order, axis, t->rest.offsets, t->rest.timing, t->rest.coefficients,
        span_row(&t->limits, axis), work, timing, coefficients);
    for (int64_t i = 0; i < STATE; i++) {
        end[i] = reached[i];
    }
    end[DELAYED_STATE_DELAY] = reached[CHAIN_TIME];
    return found;
}

int64_t segfmu_find_leads(replanning *t, int64_t order, int64_t shape, const double *targets)
{
    const int64_t n = t->smoothness, rows = 2 * LEAD_ROWS_PIECES;
    double *space = t->space;
    array_double_2d work = matrix(take(&space, LEAD_WORK_SIZE * LEAD_WORK_COLUMNS),
                                  LEAD_WORK_SIZE, LEAD_WORK_COLUMNS);
    array_double_2d timing = matrix(take(&space, rows * TIMING_SIZE), rows, TIMING_SIZE);
    array_double_2d coefficients = matrix(take(&space, rows * 2 * n), rows, 2 * n);
    int64_t count = 0;
    for (int64_t i = 0; i < LEAD_WORK_SIZE * LEAD_WORK_COLUMNS; i++) {
        work.data[i] = 0.0;
    }
    const double *best = work.data + LEAD_WORK_BEST * LEAD_WORK_COLUMNS;
    t->leads.offsets.data[0] = 0;
    for (int64_t axis = 0; axis < t->axes; axis++) {
        const double *target = targets + axis * (n + 1);
        double *end = t->ends + axis * DELAYED_STATE_SIZE, last[DELAYED_STATE_SIZE];
        work.data[LEAD_WORK_AXIS * LEAD_WORK_COLUMNS + AXIS_SHAPE] = (double)shape;
        int found = find_one(t, order, axis, target, work, timing, coefficients);
        segfmu_rest_end(t, axis, last);
        if (order == TO_VELOCITY && segfmu_ends_at_velocity(t, axis, target, last, found)) {
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
            return axis;
        }
        t->leads.offsets.data[axis + 1] = count;
    }
    return -1;
}

int segfmu_judge_pieces(
    const replanning *t, const piece_list *found, int64_t points, double *states, double *times,
    double *space, segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes, n = t->smoothness;
    array_double_2d check = matrix(take(&space, CHECK_SIZE * CHECK_COLUMNS), CHECK_SIZE,
                                   CHECK_COLUMNS);
    segfmu_describe(found, points, times, trajectory);
    int64_t wrong = segfmu_check_plan(
        cuboid(states, points, k, n + 1), matrix(times, points + 1, k), found->timing,
        found->coefficients, found->offsets, t->limits, PLAN_TOLERANCE, check);
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
