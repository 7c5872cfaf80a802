/* What is left of the old plan, work space of the kernels that go on from there, and the check of
   pieces. */
#include "lead.h"

#include <string.h>

/* As many rows as a part takes: a plan behind leads, and the search for leads. */
static int64_t most_rows(int64_t points, int64_t axes, int64_t smoothness, int64_t old)
{
    const int64_t leads = old + axes + 1 + axes * LEAD_ROWS_PIECES;
    return segfmu_most_pieces(points, axes, smoothness) + leads + LEAD_ROWS_ALL;
}

size_t segfmu_replan_size(int64_t points, int64_t axes, int64_t smoothness, int64_t pieces)
{
    const int64_t rows = most_rows(points, axes, smoothness, pieces), width = smoothness + 1;
    const int64_t parts = PLAN_PART_COUNT * (rows * (TIMING_SIZE + 2 * smoothness) + axes + 1);
    const int64_t cells = (points - 1) * axes;
    const int64_t planned = points * (axes * (2 * LEAD_END_SIZE + width + 1) + 1)
        + 2 * axes * AXIS_SIZE + cells * CELL_SIZE * CELL_COLUMNS;
    return (size_t)(parts + LEAD_WORK_SIZE * LEAD_WORK_COLUMNS + planned
                    + axes * (width + LOWER_SIZE + DELAYED_STATE_SIZE + 6));
}

piece_list segfmu_part(const replanning *t, int64_t part)
{
    const int64_t rows = t->timing.shape[1], columns = t->coefficients.shape[2];
    piece_list list = {
        .timing = matrix(t->timing.data + part * rows * TIMING_SIZE, rows, TIMING_SIZE),
        .coefficients = matrix(t->coefficients.data + part * rows * columns, rows, columns),
        .offsets = {t->offsets.data + part * (t->axes + 1), {t->axes + 1}},
    };
    return list;
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
    const int64_t parts = PLAN_PART_COUNT, work = LEAD_WORK_SIZE * LEAD_WORK_COLUMNS;
    replanning t = {.axes = k, .smoothness = n, .limits = matrix((double *)limits, k, n + 1)};
    t.lower = segfmu_gather_lower(lower, k, &space);
    t.now = take(&space, k * (n + 1));
    t.outside = take(&space, k);
    t.tables = matrix(take(&space, 2 * k * AXIS_SIZE), 2 * k, AXIS_SIZE);
    t.lead = matrix(take(&space, work), LEAD_WORK_SIZE, LEAD_WORK_COLUMNS);
    t.timing = cuboid(take(&space, parts * rows * TIMING_SIZE), parts, rows, TIMING_SIZE);
    t.coefficients = cuboid(take(&space, parts * rows * 2 * n), parts, rows, 2 * n);
    t.offsets.data = (int64_t *)(void *)take(&space, parts * (k + 1));
    t.offsets.shape[0] = parts * (k + 1);
    t.space = space;
    memset(t.lead.data, 0, (size_t)work * sizeof *t.lead.data);
    memset(t.offsets.data, 0, (size_t)t.offsets.shape[0] * sizeof *t.offsets.data);
    t.lead.data[LEAD_WORK_TASK * LEAD_WORK_COLUMNS + LEAD_TASK_BRAKES] = 1.0;
    /* as nothing judges it once more, nearly all of the tolerance is used */
    t.lead.data[LEAD_WORK_JUDGING * LEAD_WORK_COLUMNS + JUDGING_TOLERANCE] = PLAN_TOLERANCE;
    t.lead.data[LEAD_WORK_JUDGING * LEAD_WORK_COLUMNS + JUDGING_JOINTS] = 0.95 * PLAN_TOLERANCE;
    piece_list rest = segfmu_part(&t, PLAN_PART_FOLLOWED);
    segfmu_cut_rest(old, time, &rest);
    segfmu_start_states(&rest, n, t.now);
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

void segfmu_end_pieces(const piece_list *list, double *ends)
{
    segfmu_plan_ends(list->timing, list->coefficients, list->offsets,
                     matrix(ends, list->offsets.shape[0] - 1, DELAYED_STATE_SIZE));
}

void segfmu_follow_rest(const replanning *t)
{
    const piece_list rest = segfmu_part(t, PLAN_PART_FOLLOWED);
    const piece_list leads = segfmu_part(t, PLAN_PART_LEADS);
    const size_t used = (size_t)rest.offsets.data[t->axes];
    memcpy(leads.timing.data, rest.timing.data, used * TIMING_SIZE * sizeof *leads.timing.data);
    memcpy(leads.coefficients.data, rest.coefficients.data,
           used * (size_t)rest.coefficients.shape[1] * sizeof *leads.coefficients.data);
    memcpy(leads.offsets.data, rest.offsets.data,
           (size_t)(t->axes + 1) * sizeof *leads.offsets.data);
}

void segfmu_show(
    const replanning *t, const piece_list *found, int64_t points, const double *times,
    segfmu_trajectory *trajectory)
{
    segfmu_describe(found, points, times, trajectory);
    for (int64_t axis = 0; axis < t->axes; axis++) {
        t->outside[axis] = t->tables.data[(t->axes + axis) * AXIS_SIZE + BRAKE_UNTIL];
    }
    trajectory->outside = t->outside;
}

int segfmu_judge(
    const replanning *t, const piece_list *found, int64_t points, double *states, double *times,
    segfmu_trajectory *trajectory)
{
    const int64_t k = t->axes;
    const piece_list spare = segfmu_part(t, PLAN_PART_BEHIND);
    const int right = segfmu_judge_pieces(
        cuboid(states, points, k, t->smoothness + 1), matrix(times, points + 1, k), found->timing,
        found->coefficients, found->offsets, t->limits, t->lower,
        span_rows(&t->tables, k, 2 * k), t->lead, spare.timing, spare.coefficients);
    segfmu_show(t, found, points, times, trajectory);
    return right ? PLAN_STATUS_PLANNED : PLAN_STATUS_CHECK_FAILED;
}
