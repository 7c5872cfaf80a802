/* What is left of the old plan, leads from it (segfmu_find_leads), and the check of what follows. */
#include "lead.h"

#include <string.h>

/* As many rows as a plan takes, as the leads take, and as the old plan has. */
static int64_t most_rows(int64_t points, int64_t axes, int64_t smoothness, int64_t old)
{
    const int64_t leads = axes * LEAD_ROWS_PIECES, rest = old + axes + 1;
    return segfmu_most_pieces(points, axes, smoothness) + (leads > rest ? leads : rest);
}

/* As many rows as the search for leads takes. */
static int64_t lead_rows(int64_t axes, int64_t old)
{
    return old + axes + 1 + axes * LEAD_ROWS_PIECES + LEAD_ROWS_ALL;
}

size_t segfmu_replan_size(int64_t points, int64_t axes, int64_t smoothness, int64_t pieces)
{
    const int64_t rows = most_rows(points, axes, smoothness, pieces);
    const int64_t piece = TIMING_SIZE + 2 * smoothness;
    const int64_t cells = (points - 1) * axes;
    const int64_t lists = 4 * rows * piece + lead_rows(axes, pieces) * piece + 5 * (axes + 1);
    const int64_t lead = LEAD_WORK_SIZE * LEAD_WORK_COLUMNS + LEAD_ROWS_ALL * piece
        + (2 * (smoothness + 1) + LEAD_END_SIZE + BRAKE_SIZE) * axes;
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
    t.leads = segfmu_take_pieces(&space, lead_rows(k, old->pieces), k, n);
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

void segfmu_end_rest(replanning *t)
{
    segfmu_plan_ends(t->rest.timing, t->rest.coefficients, t->rest.offsets,
                     matrix(t->ends, t->axes, DELAYED_STATE_SIZE));
}

/* Work space in which one axis settles, all zeros. */
static array_double_2d lead_work(double **space)
{
    double *work = take(space, LEAD_WORK_SIZE * LEAD_WORK_COLUMNS);
    memset(work, 0, LEAD_WORK_SIZE * LEAD_WORK_COLUMNS * sizeof *work);
    return matrix(work, LEAD_WORK_SIZE, LEAD_WORK_COLUMNS);
}

int64_t segfmu_settle_axes(replanning *t, int64_t order, int64_t shape, double meeting,
                           const double *targets)
{
    const int64_t k = t->axes, width = t->smoothness + 1;
    double *space = t->space, *states = take(&space, 2 * k * width);
    double *ends = take(&space, k * LEAD_END_SIZE);
    array_double_2d work = lead_work(&space);
    double *task = work.data + LEAD_WORK_TASK * LEAD_WORK_COLUMNS;
    task[LEAD_TASK_ORDER] = (double)order;
    task[LEAD_TASK_MEETING] = meeting;
    task[LEAD_TASK_SHAPE] = (double)shape;
    task[LEAD_TASK_BRAKES] = 1.0;
    memcpy(states, t->now, (size_t)(k * width) * sizeof *states);
    memcpy(states + k * width, targets, (size_t)(k * width) * sizeof *states);
    const int64_t failed = segfmu_find_leads(
        cuboid(states, 2, k, width), t->limits, t->lower, t->rest.offsets, t->rest.timing,
        t->rest.coefficients, matrix(ends, k, LEAD_END_SIZE), work, t->leads.timing,
        t->leads.coefficients, t->leads.offsets);
    for (int64_t axis = 0; axis < k; axis++) {
        memcpy(t->ends + axis * DELAYED_STATE_SIZE, ends + axis * LEAD_END_SIZE,
               DELAYED_STATE_SIZE * sizeof *ends);
    }
    return failed;
}

/* The brakes (k, Brake) of the states (k, n + 1), zeros where they can stay inside; whether there is
   one. */
static int find_brakes(const replanning *t, double *states, double *brakes, double *space)
{
    const int64_t k = t->axes, n = t->smoothness, rows = LEAD_ROWS_ALL;
    array_double_2d timing = matrix(take(&space, rows * TIMING_SIZE), rows, TIMING_SIZE);
    array_double_2d coefficients = matrix(take(&space, rows * 2 * n), rows, 2 * n);
    return segfmu_find_brakes(matrix(states, k, n + 1), t->limits, t->lower,
                              matrix(brakes, k, BRAKE_SIZE), lead_work(&space), timing,
                              coefficients);
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
