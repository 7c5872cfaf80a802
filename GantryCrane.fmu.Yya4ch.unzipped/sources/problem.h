/* Shared by plan.c and by what replans: the range of a problem, the options of the planner, and the
   polynomial pieces of a trajectory. Programs do not need it. */
#ifndef SEGFMU_PROBLEM_H
#define SEGFMU_PROBLEM_H

#include <math.h>
#include <string.h>

#include "arrays.h"
#include "records.h"
#include "segfmu.h"

/* of limits, jumps and waypoints, relative */
static const double PLAN_TOLERANCE = 1e-9;

/* The pieces of all axes. */
typedef struct {
    array_double_2d timing, coefficients;
    array_int64_t_1d offsets;
} piece_list;

/* Most pieces of a plan: two profiles of each interval of an axis, cut at all their switching
   times, and a dwell; a ramp has 2^(n-1) - 1 pieces. */
static inline int64_t segfmu_most_pieces(int64_t points, int64_t axes, int64_t smoothness)
{
    const int64_t phases = 2 * (CELL_ABOVE - CELL_BELOW);
    const int64_t interval = phases * ((INT64_C(1) << (smoothness - 1)) - 1) + 1;
    return ((points - 1) * interval + 2) * axes + SPARE_ROWS;
}

static inline piece_list segfmu_take_pieces(
    double **space, int64_t rows, int64_t axes, int64_t smoothness)
{
    piece_list p;
    p.timing = matrix(take(space, rows * TIMING_SIZE), rows, TIMING_SIZE);
    p.coefficients = matrix(take(space, rows * 2 * smoothness), rows, 2 * smoothness);
    p.offsets.data = (int64_t *)(void *)take(space, axes + 1);
    p.offsets.shape[0] = axes + 1;
    return p;
}

/* Whether sizes, choices and times are in range, with a report; segfmu_check_problem judges limits
   and states. */
static inline int segfmu_in_range(const segfmu_problem *p, double *report)
{
    memset(report, 0, SEGFMU_REPORT * sizeof *report);
    if (!(p->points >= 2 && p->axes >= 1 && p->smoothness >= 2 && p->smoothness <= 6
          && p->shape >= SHAPE_SMOOTHSTEP && p->shape <= SHAPE_PLATEAU
          && p->synchronization >= SYNCHRONIZATION_NONE
          && p->synchronization <= SYNCHRONIZATION_TOTAL && p->sample_time >= 0.0
          && p->duration >= 0.0 && isfinite(p->duration))) {
        return 0;
    }
    for (int64_t i = 0; i < p->points; i++) {
        if (!(p->dwells[i] >= 0.0 && isfinite(p->dwells[i]))) {
            report[REFUSAL_INTERVAL] = (double)i;
            report[REFUSAL_VALUE] = p->dwells[i];
            return 0;
        }
    }
    return 1;
}

static inline void segfmu_write_options(const segfmu_problem *p, double *options)
{
    options[PLAN_OPTIONS_SMOOTHNESS] = (double)p->smoothness;
    options[PLAN_OPTIONS_SHAPE] = (double)p->shape;
    options[PLAN_OPTIONS_SYNCHRONIZATION] = (double)p->synchronization;
    options[PLAN_OPTIONS_SAMPLE_TIME] = p->sample_time;
    options[PLAN_OPTIONS_DURATION] = p->duration;
}

/* A copy of the limits in the negative direction (Lower), 0 where there are none. */
static inline array_double_2d segfmu_gather_lower(
    const double *lower, int64_t axes, double **space)
{
    const size_t size = (size_t)(axes * LOWER_SIZE) * sizeof **space;
    double *data = take(space, axes * LOWER_SIZE);
    if (lower == NULL) {
        memset(data, 0, size);
    } else {
        memcpy(data, lower, size);
    }
    return matrix(data, axes, LOWER_SIZE);
}

/* A copy of the dwells, rounded up to multiples of the sample time. */
static inline array_double_1d segfmu_gather_dwells(const segfmu_problem *p, double **space)
{
    array_double_1d dwells = vector(take(space, p->points), p->points);
    memcpy(dwells.data, p->dwells, (size_t)p->points * sizeof *dwells.data);
    segfmu_settle_dwells(p->sample_time, dwells);
    return dwells;
}

/* Show pieces as the trajectory; times (m + 1, k) have the ends as their last row. */
static inline void segfmu_describe(
    const piece_list *found, int64_t points, const double *times, segfmu_trajectory *trajectory)
{
    const int64_t k = found->offsets.shape[0] - 1;
    trajectory->points = points;
    trajectory->axes = k;
    trajectory->smoothness = found->coefficients.shape[1] / 2;
    trajectory->pieces = found->offsets.data[k];
    trajectory->timing = found->timing.data;
    trajectory->coefficients = found->coefficients.data;
    trajectory->offsets = found->offsets.data;
    trajectory->times = times;
    trajectory->ends = times + points * k;
    trajectory->outside = NULL;
    trajectory->duration = 0.0;
    for (int64_t axis = 0; axis < k; axis++) {
        trajectory->duration = span_max(trajectory->duration, trajectory->ends[axis]);
    }
}

#endif
