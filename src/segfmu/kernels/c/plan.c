/* The pure-C entry point: carves the kernels' arrays out of one block of work space. */
#include "segfmu.h"

#include "kernels.h"

/* most polynomial pieces of an interval of one axis: two profiles of 13 phases, 7 pieces each,
   cut at all their switching times; and a dwell */
enum { PIECES = 2 * 13 * 7 + 1, RAMP = 48, ROWS = 13, COLUMNS = 4, WORK = 43 };

static double *take(double **space, int64_t count)
{
    double *taken = *space;
    *space += count;
    return taken;
}

static array_double_1d vector(double *data, int64_t n)
{
    array_double_1d a = {data, {n}};
    return a;
}

static array_double_2d matrix(double *data, int64_t rows, int64_t columns)
{
    array_double_2d a = {data, {rows, columns}};
    return a;
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

static int64_t most_pieces(int64_t points, int64_t axes)
{
    return ((points - 1) * PIECES + 2) * axes;
}

size_t segfmu_plan_size(int64_t points, int64_t axes, int64_t smoothness)
{
    int64_t cells = (points - 1) * axes;
    int64_t planned = axes * RAMP + 2 * cells * ROWS * COLUMNS + 2 * cells + 3 * cells
        + (points - 1) + WORK * (4 + 2 * smoothness);
    int64_t expanded = most_pieces(points, axes) * (2 + 2 * smoothness) + (axes + 1)
        + points * axes + axes + 200 * 2 + 200 * 16 + 43 * 14;
    return (size_t)(planned + expanded);
}

static int in_range(const segfmu_problem *p)
{
    return p->points >= 2 && p->axes >= 1 && p->smoothness >= 2 && p->smoothness <= 6
        && p->shape >= 0 && p->shape <= 1 && p->synchronization >= 0 && p->synchronization <= 2
        && p->sample_time >= 0.0 && p->duration >= 0.0;
}

int segfmu_plan(const segfmu_problem *p, double *space, segfmu_trajectory *trajectory)
{
    for (int i = 0; i < 4; i++) {
        trajectory->report[i] = 0.0;
    }
    if (!in_range(p)) {
        return -11;
    }
    const int64_t m = p->points, k = p->axes, n = p->smoothness, cells = (m - 1) * k;
    const int64_t rows = most_pieces(m, k);
    array_double_2d positions = given(p->positions, m, k);
    array_double_2d velocities = given(p->velocities, m, k);
    array_double_2d accelerations = given(p->accelerations, m, k);
    array_double_1d dwells = vector((double *)p->dwells, m);
    array_double_2d limits = given(p->limits, k, n + 1);
    array_double_2d ramps = matrix(take(&space, k * RAMP), k, RAMP);
    array_double_3d phases = {
        take(&space, 2 * cells * ROWS * COLUMNS), {2 * cells, ROWS, COLUMNS}
    };
    array_int64_t_1d counts = integers(take(&space, 2 * cells), 2 * cells);
    array_double_1d weights = vector(take(&space, cells), cells);
    array_double_2d shortest = matrix(take(&space, cells), m - 1, k);
    array_double_2d durations = matrix(take(&space, cells), m - 1, k);
    array_int64_t_1d active = integers(take(&space, m - 1), m - 1);
    array_double_2d work = matrix(take(&space, WORK * (4 + 2 * n)), WORK, 4 + 2 * n);
    int64_t status = segfmu_plan_phases(
        positions, velocities, accelerations, dwells, limits, n, p->shape, p->synchronization,
        p->sample_time, p->duration, ramps, phases, counts, weights, shortest, durations, active,
        work, vector(trajectory->report, 4));
    if (status < 0) {
        return (int)status;
    }
    array_double_2d timing = matrix(take(&space, rows * 2), rows, 2);
    array_double_2d coefficients = matrix(take(&space, rows * 2 * n), rows, 2 * n);
    array_int64_t_1d offsets = integers(take(&space, k + 1), k + 1);
    array_double_2d times = matrix(take(&space, m * k), m, k);
    array_double_1d ends = vector(take(&space, k), k);
    array_double_2d scratch_timing = matrix(take(&space, 200 * 2), 200, 2);
    array_double_2d scratch = matrix(take(&space, 200 * 16), 200, 16);
    trajectory->pieces = segfmu_expand_plan(
        positions, velocities, dwells, n, p->shape, phases, counts, weights, durations, ramps,
        scratch_timing, scratch, timing, coefficients, offsets, times);
    trajectory->points = m;
    trajectory->axes = k;
    trajectory->smoothness = n;
    trajectory->timing = timing.data;
    trajectory->coefficients = coefficients.data;
    trajectory->offsets = offsets.data;
    trajectory->times = times.data;
    trajectory->ends = ends.data;
    trajectory->duration = 0.0;
    for (int64_t axis = 0; axis < k; axis++) {
        ends.data[axis] = times.data[(m - 1) * k + axis] + p->dwells[m - 1];
        trajectory->duration = span_max(trajectory->duration, ends.data[axis]);
    }
    array_double_2d check = matrix(take(&space, 43 * 14), 43, 14);
    return segfmu_check_plan(positions, velocities, accelerations, times, timing, coefficients,
                             offsets, ends, limits, 1e-9, check) == 0 ? 0 : -12;
}

void segfmu_value(
    const segfmu_trajectory *trajectory, double t, int64_t derivative, double *values)
{
    const int64_t k = trajectory->axes, n = trajectory->smoothness;
    array_int64_t_1d offsets = {(int64_t *)trajectory->offsets, {k + 1}};
    segfmu_evaluate(
        vector(&t, 1), given(trajectory->timing, trajectory->pieces, 2),
        given(trajectory->coefficients, trajectory->pieces, 2 * n), offsets,
        vector((double *)trajectory->ends, k), derivative, matrix(values, 1, k));
}
