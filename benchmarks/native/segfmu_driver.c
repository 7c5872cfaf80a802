/* Times segfmu's compiled kernels; every function returns the microseconds of the whole batch. */
#define _POSIX_C_SOURCE 199309L

#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "batch.h"
#include "kernels.h"
#include "records.h"
#include "segfmu.h"

typedef double solver(const batch *b, int64_t i, double *space);

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

/* One axis: the phases of the shortest profile, from the limits as they are given. */
static double solve_profile(const batch *b, int64_t i, double *space)
{
    const int64_t n = b->smoothness;
    const double *y = b->positions + 2 * i, *v = b->velocities + 2 * i;
    const double *a = b->accelerations + 2 * i;
    array_double_1d limits = {(double *)b->limits + i * (n + 1), {n + 1}};
    array_double_1d axis = {space, {AXIS_SIZE}}, problem = {axis.data + AXIS_SIZE, {PROBLEM_SIZE}};
    array_double_2d phases = {problem.data + PROBLEM_SIZE, {CELL_ABOVE, CELL_COLUMNS}};
    array_double_2d work = {
        phases.data + CELL_ABOVE * CELL_COLUMNS, {PLAN_WORK_SIZE, PLAN_WORK_COLUMNS}
    };
    problem.data[PROBLEM_V] = v[0];
    problem.data[PROBLEM_A] = a[0];
    problem.data[PROBLEM_W] = v[1];
    problem.data[PROBLEM_B] = a[1];
    problem.data[PROBLEM_DISTANCE] = y[1] - y[0];
    problem.data[PROBLEM_DURATION] = 0.0;
    segfmu_axis_limits(n, b->shape, limits, axis);
    if (!segfmu_ramp_parameters(0.1, axis, work)) {
        return NAN;
    }
    int64_t count = segfmu_shortest_profile(problem, axis, phases, work);
    double duration = count < 0 ? NAN : 0.0;
    for (int64_t row = 0; row < count; row++) {
        duration += phases.data[row * CELL_COLUMNS + PHASE_DURATION];
    }
    return duration;
}

/* Any number of axes: synchronised, as polynomials, checked against every limit. */
static double solve_plan(const batch *b, int64_t i, double *space)
{
    static const double dwells[2] = {0.0, 0.0};
    const int64_t k = b->axes, n = b->smoothness;
    segfmu_problem problem = {
        .points = 2, .axes = k, .smoothness = n, .shape = b->shape,
        .synchronization = SEGFMU_WAYPOINTS, .positions = b->positions + 2 * k * i,
        .velocities = b->velocities + 2 * k * i, .accelerations = b->accelerations + 2 * k * i,
        .dwells = dwells, .limits = b->limits + k * (n + 1) * i
    };
    segfmu_trajectory trajectory;
    return segfmu_plan(&problem, space, &trajectory) == 0 ? trajectory.duration : NAN;
}

static double run(const batch *b, solver *solve, size_t size)
{
    double *space = malloc(size * sizeof(double));
    double begun = now();
    for (int64_t i = 0; i < b->count; i++) {
        double before = b->times ? now() : 0.0;
        b->durations[i] = solve(b, i, space);
        if (b->times) {
            b->times[i] = now() - before;
        }
    }
    double taken = now() - begun;
    free(space);
    return taken;
}

double run_profile(const batch *b)
{
    return run(b, solve_profile, AXIS_SIZE + PROBLEM_SIZE + CELL_ABOVE * CELL_COLUMNS
        + PLAN_WORK_SIZE * PLAN_WORK_COLUMNS);
}

double run_plan(const batch *b)
{
    return run(b, solve_plan, segfmu_plan_size(2, b->axes, b->smoothness));
}

/* One plan through many points; returns its microseconds, or its status where it is refused. */
double run_mission(const segfmu_problem *problem)
{
    double *space = malloc(
        segfmu_plan_size(problem->points, problem->axes, problem->smoothness) * sizeof(double));
    segfmu_trajectory trajectory;
    double begun = now();
    int status = segfmu_plan(problem, space, &trajectory);
    double taken = now() - begun;
    free(space);
    return status == 0 ? taken : (double)status;
}
