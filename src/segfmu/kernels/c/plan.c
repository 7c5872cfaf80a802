/* The pure-C entry point: carves the kernels' arrays out of one block of work space. */
#include "segfmu.h"

#include "arrays.h"
#include "records.h"

/* most phases of an interval of one axis, two profiles */
enum { PHASES = 2 * (CELL_ABOVE - CELL_BELOW) };

/* The kernels only read these; their arrays have no const. */
static array_double_2d given(const double *data, int64_t rows, int64_t columns)
{
    return matrix((double *)data, rows, columns);
}

static array_int64_t_1d integers(double *data, int64_t n)
{
    array_int64_t_1d a = {(int64_t *)(void *)data, {n}};
    return a;
}

/* Two profiles cut at all their switching times, and a dwell; a ramp has 2^(n-1) - 1 pieces. */
static int64_t most_pieces(int64_t points, int64_t axes, int64_t smoothness)
{
    const int64_t interval = PHASES * ((INT64_C(1) << (smoothness - 1)) - 1) + 1;
    return ((points - 1) * interval + 2) * axes + SPARE_ROWS;
}

size_t segfmu_plan_size(int64_t points, int64_t axes, int64_t smoothness)
{
    const int64_t planned = points * axes * WAYPOINT_STATE_SIZE + axes * AXIS_SIZE
        + (points - 1) * axes * CELL_SIZE * CELL_COLUMNS + MOTION_WORK_SIZE * MOTION_WORK_COLUMNS;
    const int64_t expanded = most_pieces(points, axes, smoothness) * (TIMING_SIZE + 2 * smoothness)
        + (axes + 1) + (points + 1) * axes;
    return (size_t)(planned + expanded);
}

static int sizes_in_range(const segfmu_problem *p)
{
    return p->points >= 2 && p->axes >= 1 && p->smoothness >= 2 && p->smoothness <= 6
        && p->shape >= SHAPE_SMOOTHSTEP && p->shape <= SHAPE_PLATEAU
        && p->synchronization >= SYNCHRONIZATION_NONE
        && p->synchronization <= SYNCHRONIZATION_TOTAL && p->sample_time >= 0.0
        && p->duration >= 0.0;
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
    double *options = space + MOTION_WORK_OPTIONS * MOTION_WORK_COLUMNS;
    options[PLAN_OPTIONS_SMOOTHNESS] = (double)p->smoothness;
    options[PLAN_OPTIONS_SHAPE] = (double)p->shape;
    options[PLAN_OPTIONS_SYNCHRONIZATION] = (double)p->synchronization;
    options[PLAN_OPTIONS_SAMPLE_TIME] = p->sample_time;
    options[PLAN_OPTIONS_DURATION] = p->duration;
    space[MOTION_WORK_JUDGING * MOTION_WORK_COLUMNS + JUDGING_TOLERANCE] = 1e-9;
    return matrix(space, MOTION_WORK_SIZE, MOTION_WORK_COLUMNS);
}

/* The trajectory in its arrays; `times` has the ends as its last row. */
static void describe(const segfmu_problem *p, array_double_2d timing, array_double_2d coefficients,
                     array_int64_t_1d offsets, array_double_2d times, segfmu_trajectory *trajectory)
{
    trajectory->points = p->points;
    trajectory->axes = p->axes;
    trajectory->smoothness = p->smoothness;
    trajectory->pieces = offsets.data[p->axes];
    trajectory->timing = timing.data;
    trajectory->coefficients = coefficients.data;
    trajectory->offsets = offsets.data;
    trajectory->times = times.data;
    trajectory->ends = times.data + p->points * p->axes;
    trajectory->duration = 0.0;
    for (int64_t axis = 0; axis < p->axes; axis++) {
        trajectory->duration = span_max(trajectory->duration, trajectory->ends[axis]);
    }
}

int segfmu_plan(const segfmu_problem *p, double *space, segfmu_trajectory *trajectory)
{
    for (int i = 0; i < REFUSAL_SIZE; i++) {
        trajectory->report[i] = 0.0;
    }
    if (!sizes_in_range(p)) {
        return PLAN_STATUS_OUT_OF_RANGE;
    }
    const int64_t m = p->points, k = p->axes, n = p->smoothness, intervals = (m - 1) * k;
    const int64_t rows = most_pieces(m, k, n);
    array_double_3d states = gather_states(p, take(&space, m * k * WAYPOINT_STATE_SIZE));
    array_double_2d limits = given(p->limits, k, n + 1);
    array_double_2d axes = matrix(take(&space, k * AXIS_SIZE), k, AXIS_SIZE);
    array_double_3d cells = cuboid(
        take(&space, intervals * CELL_SIZE * CELL_COLUMNS), intervals, CELL_SIZE, CELL_COLUMNS);
    array_double_2d work = gather_options(
        p, take(&space, MOTION_WORK_SIZE * MOTION_WORK_COLUMNS));
    array_double_2d timing = matrix(take(&space, rows * TIMING_SIZE), rows, TIMING_SIZE);
    array_double_2d coefficients = matrix(take(&space, rows * 2 * n), rows, 2 * n);
    array_int64_t_1d offsets = integers(take(&space, k + 1), k + 1);
    array_double_2d times = matrix(take(&space, (m + 1) * k), m + 1, k);
    segfmu_settle_states(states, limits);
    int64_t status = segfmu_plan_motion(
        states, vector((double *)p->dwells, m), limits, axes, cells, timing, coefficients, offsets,
        times, work);
    if (status == PLAN_STATUS_PLANNED || status == PLAN_STATUS_CHECK_FAILED) {
        describe(p, timing, coefficients, offsets, times, trajectory);
    } else {
        const double *report
            = work.data + (MOTION_WORK_PLAN + PLAN_WORK_REFUSAL) * MOTION_WORK_COLUMNS;
        for (int i = 0; i < REFUSAL_SIZE; i++) {
            trajectory->report[i] = report[i];
        }
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
