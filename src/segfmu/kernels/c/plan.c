/* The pure-C entry point: carves the kernels' arrays out of one block of work space. */
#include "segfmu.h"

#include "arrays.h"
#include "records.h"

/* most phases of an interval of one axis, two profiles */
enum { PHASES = 2 * (CELL_ABOVE - CELL_BELOW) };

static double *take(double **space, int64_t count)
{
    double *taken = *space;
    *space += count;
    return taken;
}

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
    int64_t planned = points * axes * WAYPOINT_STATE_SIZE + PLAN_OPTIONS_SIZE + axes * AXIS_SIZE
        + (points - 1) * axes * CELL_SIZE * CELL_COLUMNS + PLAN_WORK_SIZE * PLAN_WORK_COLUMNS;
    int64_t expanded = most_pieces(points, axes, smoothness) * (TIMING_SIZE + 2 * smoothness)
        + (axes + 1) + (points + 1) * axes + EXPANSION_SIZE * EXPANSION_COLUMNS
        + CHECK_SIZE * CHECK_COLUMNS;
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

static array_double_1d gather_options(const segfmu_problem *p, double *space)
{
    space[PLAN_OPTIONS_SMOOTHNESS] = (double)p->smoothness;
    space[PLAN_OPTIONS_SHAPE] = (double)p->shape;
    space[PLAN_OPTIONS_SYNCHRONIZATION] = (double)p->synchronization;
    space[PLAN_OPTIONS_SAMPLE_TIME] = p->sample_time;
    space[PLAN_OPTIONS_DURATION] = p->duration;
    return vector(space, PLAN_OPTIONS_SIZE);
}

/* What the phases are expanded from, and the limits. */
typedef struct {
    array_double_3d states, cells;
    array_double_2d axes, limits;
    array_double_1d dwells;
} phases;

/* The pieces of the phases, judged; `space` is what is left of the work space. */
static int expand(const segfmu_problem *p, const phases *planned, double *space,
                  segfmu_trajectory *trajectory)
{
    const int64_t m = p->points, k = p->axes, n = p->smoothness;
    const int64_t rows = most_pieces(m, k, n);
    array_double_2d timing = matrix(take(&space, rows * TIMING_SIZE), rows, TIMING_SIZE);
    array_double_2d coefficients = matrix(take(&space, rows * 2 * n), rows, 2 * n);
    array_int64_t_1d offsets = integers(take(&space, k + 1), k + 1);
    array_double_2d times = matrix(take(&space, (m + 1) * k), m + 1, k);
    array_double_2d work = matrix(
        take(&space, EXPANSION_SIZE * EXPANSION_COLUMNS), EXPANSION_SIZE, EXPANSION_COLUMNS);
    trajectory->pieces = segfmu_expand_plan(
        planned->states, planned->dwells, planned->axes, planned->cells, timing, coefficients,
        offsets, times, work);
    trajectory->points = m;
    trajectory->axes = k;
    trajectory->smoothness = n;
    trajectory->timing = timing.data;
    trajectory->coefficients = coefficients.data;
    trajectory->offsets = offsets.data;
    trajectory->times = times.data;
    trajectory->ends = times.data + m * k;
    trajectory->duration = 0.0;
    for (int64_t axis = 0; axis < k; axis++) {
        trajectory->duration = span_max(trajectory->duration, trajectory->ends[axis]);
    }
    array_double_2d check = matrix(
        take(&space, CHECK_SIZE * CHECK_COLUMNS), CHECK_SIZE, CHECK_COLUMNS);
    int64_t wrong = segfmu_check_plan(planned->states, times, timing, coefficients, offsets,
                                      planned->limits, 1e-9, check);
    return wrong == 0 ? PLAN_STATUS_PLANNED : PLAN_STATUS_CHECK_FAILED;
}

int segfmu_plan(const segfmu_problem *p, double *space, segfmu_trajectory *trajectory)
{
    for (int i = 0; i < REFUSAL_SIZE; i++) {
        trajectory->report[i] = 0.0;
    }
    if (!sizes_in_range(p)) {
        return PLAN_STATUS_OUT_OF_RANGE;
    }
    const int64_t m = p->points, k = p->axes, cells = (m - 1) * k;
    phases planned = {
        .states = gather_states(p, take(&space, m * k * WAYPOINT_STATE_SIZE)),
        .cells = {take(&space, cells * CELL_SIZE * CELL_COLUMNS),
                  {cells, CELL_SIZE, CELL_COLUMNS}},
        .axes = matrix(take(&space, k * AXIS_SIZE), k, AXIS_SIZE),
        .limits = given(p->limits, k, p->smoothness + 1),
        .dwells = vector((double *)p->dwells, m),
    };
    array_double_1d options = gather_options(p, take(&space, PLAN_OPTIONS_SIZE));
    array_double_2d work = matrix(take(&space, PLAN_WORK_SIZE * PLAN_WORK_COLUMNS), PLAN_WORK_SIZE, PLAN_WORK_COLUMNS);
    double *report = work.data + PLAN_WORK_REFUSAL * PLAN_WORK_COLUMNS;
    segfmu_settle_states(planned.states, planned.limits);
    int64_t status = segfmu_check_problem(planned.states, planned.limits,
                                          vector(report, REFUSAL_SIZE));
    if (status == PLAN_STATUS_PLANNED) {
        status = segfmu_plan_phases(planned.states, planned.dwells, planned.limits, options,
                                    planned.axes, planned.cells, work);
    }
    if (status < 0) {
        for (int i = 0; i < REFUSAL_SIZE; i++) {
            trajectory->report[i] = report[i];
        }
        return (int)status;
    }
    return expand(p, &planned, space, trajectory);
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
