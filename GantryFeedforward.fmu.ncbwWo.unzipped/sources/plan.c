/* The pure-C entry point: carves the kernels' arrays out of one block of work space. */
#include "problem.h"

/* The kernels only read these; their arrays have no const. */
static array_double_2d given(const double *data, int64_t rows, int64_t columns)
{
    return matrix((double *)data, rows, columns);
}

size_t segfmu_plan_size(int64_t points, int64_t axes, int64_t smoothness)
{
    const int64_t planned = points * (axes * WAYPOINT_STATE_SIZE + 1)
        + axes * (AXIS_SIZE + LOWER_SIZE)
        + (points - 1) * axes * CELL_SIZE * CELL_COLUMNS + MOTION_WORK_SIZE * MOTION_WORK_COLUMNS;
    const int64_t expanded = segfmu_most_pieces(points, axes, smoothness) * (TIMING_SIZE + 2 * smoothness)
        + (axes + 1) + (points + 1) * axes;
    return (size_t)(planned + expanded);
}

static array_double_3d gather_states(const segfmu_problem *p, double *space)
{
    const int64_t count = p->points * p->axes;
    array_double_3d states = {space, {p->points, p->axes, WAYPOINT_STATE_SIZE}};
    for (int64_t i = 0; i < count; i++) {
        double *state = space + i * WAYPOINT_STATE_SIZE;
        state[WAYPOINT_STATE_POSITION] = p->positions[i];
        state[WAYPOINT_STATE_VELOCITY] = p->velocities[i];
        state[WAYPOINT_STATE_ACCELERATION] = p->accelerations[i];
    }
    return states;
}

static array_double_2d gather_options(const segfmu_problem *p, double *space)
{
    segfmu_write_options(p, space + MOTION_WORK_OPTIONS * MOTION_WORK_COLUMNS);
    double *judging = space + MOTION_WORK_JUDGING * MOTION_WORK_COLUMNS;
    judging[JUDGING_TOLERANCE] = PLAN_TOLERANCE;
    judging[JUDGING_JOINTS] = 0.5 * PLAN_TOLERANCE;
    return matrix(space, MOTION_WORK_SIZE, MOTION_WORK_COLUMNS);
}

int segfmu_plan(const segfmu_problem *p, double *space, segfmu_trajectory *trajectory)
{
    if (!segfmu_in_range(p, trajectory->report)) {
        return PLAN_STATUS_OUT_OF_RANGE;
    }
    const int64_t m = p->points, k = p->axes, n = p->smoothness, intervals = (m - 1) * k;
    array_double_3d states = gather_states(p, take(&space, m * k * WAYPOINT_STATE_SIZE));
    array_double_1d dwells = segfmu_gather_dwells(p, &space);
    array_double_2d limits = given(p->limits, k, n + 1);
    array_double_2d lower = segfmu_gather_lower(p->lower, k, &space);
    array_double_2d axes = matrix(take(&space, k * AXIS_SIZE), k, AXIS_SIZE);
    array_double_3d cells = cuboid(
        take(&space, intervals * CELL_SIZE * CELL_COLUMNS), intervals, CELL_SIZE, CELL_COLUMNS);
    array_double_2d work = gather_options(
        p, take(&space, MOTION_WORK_SIZE * MOTION_WORK_COLUMNS));
    piece_list found = segfmu_take_pieces(&space, segfmu_most_pieces(m, k, n), k, n);
    array_double_2d times = matrix(take(&space, (m + 1) * k), m + 1, k);
    double *report = work.data + (MOTION_WORK_PLAN + PLAN_WORK_REFUSAL) * MOTION_WORK_COLUMNS;
    memset(report, 0, sizeof trajectory->report);
    segfmu_settle_states(0, states, limits, lower);
    int64_t status = segfmu_plan_motion(
        states, dwells, limits, lower, axes, cells, found.timing,
        found.coefficients, found.offsets, times, work);
    if (status == PLAN_STATUS_PLANNED || status == PLAN_STATUS_CHECK_FAILED) {
        segfmu_describe(&found, m, times.data, trajectory);
    } else {
        memcpy(trajectory->report, report, sizeof trajectory->report);
    }
    return (int)status;
}

void segfmu_value(
    const segfmu_trajectory *trajectory, double t, int64_t derivative, double *values)
{
    const int64_t k = trajectory->axes, n = trajectory->smoothness;
    array_int64_t_1d offsets = {(int64_t *)trajectory->offsets, {k + 1}};
    segfmu_evaluate(
        vector(&t, 1), given(trajectory->timing, trajectory->pieces, TIMING_SIZE),
        given(trajectory->coefficients, trajectory->pieces, 2 * n), offsets,
        vector((double *)trajectory->ends, k), derivative, matrix(values, 1, k));
}
