/* Replanning in plain C: plans that begin anywhere on another one. As segfmu.h, without allocation.

       size_t size = segfmu_replan_size(points, axes, smoothness, old.pieces);
       double *space = malloc(size * sizeof(double));
       int status = segfmu_replan(&old, time, &problem, space, &trajectory);

   The old trajectory has to stay where it is during the call, the space as long as the new one is
   used. Compile it with replan.c, velocity.c, lead.c, plan.c and kernels.c. */
#ifndef SEGFMU_REPLAN_H
#define SEGFMU_REPLAN_H

#include "segfmu.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Number of doubles of work space for a problem of this size from a trajectory of so many pieces. */
SEGFMU_API size_t segfmu_replan_size(
    int64_t points, int64_t axes, int64_t smoothness, int64_t pieces);

/* Plan from the state of a trajectory at a time, which becomes the time 0. The first waypoint of the
   problem is that state; what the problem says of it is not read. If the problem has one waypoint
   more and the trajectory ends there, the rest of the trajectory is kept unless a new plan is shorter
   by 1 %. Otherwise, if no plan keeps the limits at once, the trajectory is followed to its end
   first. Returns 0, or a PLAN_STATUS of records.h. */
SEGFMU_API int segfmu_replan(
    const segfmu_trajectory *old, double time, const segfmu_problem *problem, double *space,
    segfmu_trajectory *trajectory);

/* Reach velocities (k,) [m/s] as soon as possible, wherever that is; zeros to stop. An axis keeps its
   velocity until the last one is there. limits (k, n + 1) as in segfmu_problem; the space is that of
   two points. */
SEGFMU_API int segfmu_reach_velocity(
    const segfmu_trajectory *old, double time, const double *velocities, const double *limits,
    double *space, segfmu_trajectory *trajectory);

#ifdef __cplusplus
}
#endif

#endif
