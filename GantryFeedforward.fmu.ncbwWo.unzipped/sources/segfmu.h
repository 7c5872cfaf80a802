/* Planning in plain C: no allocation, no global state, no exceptions; any number of threads.

   A program brings a problem and one block of work space, and gets a trajectory whose arrays lie in
   that block:

       size_t size = segfmu_plan_size(points, axes, smoothness);
       double *space = malloc(size * sizeof(double));
       segfmu_trajectory trajectory;
       int status = segfmu_plan(&problem, space, &trajectory);
       if (status == 0)
           segfmu_value(&trajectory, t, derivative, values);

   Compile it with kernels.c and plan.c, -ffp-contract=off, and the math library. */
#ifndef SEGFMU_H
#define SEGFMU_H

#include <stddef.h>
#include <stdint.h>

#include "visible.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { SEGFMU_SMOOTHSTEP = 0, SEGFMU_PLATEAU = 1 };
enum { SEGFMU_NONE = 0, SEGFMU_WAYPOINTS = 1, SEGFMU_TOTAL = 2 };

/* What to plan, SI units. Arrays are in C order; m waypoints, k axes. */
typedef struct {
    int64_t points;              /* m, at least 2 */
    int64_t axes;                /* k, at least 1 */
    int64_t smoothness;          /* n, 2 to 6: the trajectory is in C^n */
    int64_t shape;               /* of the ramps */
    int64_t synchronization;     /* of the axes */
    double sample_time;          /* s; intervals and dwells last a multiple of it; 0: any time */
    double duration;             /* s, in total, finite; 0: the shortest */
    const double *positions;     /* (m, k) */
    const double *velocities;    /* (m, k) */
    const double *accelerations; /* (m, k) */
    const double *dwells;        /* (m,) s, only at rest */
    const double *limits;        /* (k, n + 1): c_1 .. c_{n+1} of each axis, 0 where absent */
    const double *lower;         /* (k, 2): magnitudes of the velocity and acceleration limits in the
                                    negative direction, 0 or NULL: as in the positive one */
} segfmu_problem;

/* Numbers that tell of a refusal: REFUSAL_SIZE of records.h */
enum { SEGFMU_REPORT = 5 };

/* What was planned; the arrays lie in the caller's work space. */
typedef struct {
    int64_t points, axes, smoothness;
    int64_t pieces;              /* number of polynomial pieces of all axes */
    double duration;             /* s, of the slowest axis */
    const double *timing;        /* (pieces, 2): start and length [s] */
    const double *coefficients;  /* (pieces, 2 n): position in local time, ascending powers */
    const int64_t *offsets;      /* (k + 1,): first piece of each axis */
    const double *times;         /* (m, k): arrival of each axis at each waypoint [s] */
    const double *ends;          /* (k,): end of each axis [s] */
    const double *outside;       /* (k,): of replan.h, from when on each axis is inside its limits [s];
                                    NULL: always */
    double report[SEGFMU_REPORT]; /* of a refusal: REFUSAL_AXIS .. REFUSAL_SIDE of records.h */
} segfmu_trajectory;

/* Number of doubles of work space for a problem of this size. */
SEGFMU_API size_t segfmu_plan_size(int64_t points, int64_t axes, int64_t smoothness);

/* Plan and judge. Returns 0, or why the plan is refused: a PLAN_STATUS of records.h, below 0; the
   trajectory's `report` says where. */
SEGFMU_API int segfmu_plan(const segfmu_problem *problem, double *space, segfmu_trajectory *trajectory);

/* values[axis] = a derivative (0 to 2 n - 1) of every axis at time t. */
SEGFMU_API void segfmu_value(
    const segfmu_trajectory *trajectory, double t, int64_t derivative, double *values);

#ifdef __cplusplus
}
#endif

#endif
