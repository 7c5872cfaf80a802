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

/* Plan from the state of a trajectory at a time, which becomes the time 0.

   old       Its axes and smoothness are those of the problem.
   time      Finite, not below 0. After its end the trajectory stays where it is.
   problem   As for segfmu_plan, with at least one waypoint behind the first one. That is the state at
             the time: what the problem says of it is not read but for dwells[0], which must be 0.

   A state that cannot keep the limits, as with limits that are lowered while an axis moves, is brought
   inside them first; the trajectory's `outside` tells how long that takes.

   All options of the problem hold for a new plan. If the problem has one more waypoint, what is left
   of the trajectory is kept unless a new plan is shorter by 5 %. It must do what the problem asks:

   - It ends in the position, velocity and acceleration of that waypoint, to 1e-9 (relative).
   - dwells[1] is the trajectory's own last dwell. Once an axis has begun it, what is left of it
     counts.
   - duration is 0, or that of the rest. sample_time is 0.
   - All axes end together, unless synchronization is SEGFMU_NONE.
   - It keeps the limits. The shape does not matter.

   If no plan keeps the limits at once, the trajectory is followed to its end first.

   Returns 0, or a PLAN_STATUS of records.h, below 0. The statuses are those of segfmu_plan, and so is
   the report; waypoint 0 is the start. OUT_OF_RANGE: also a time, axes, smoothness or dwells[0] as
   they must not be. */
SEGFMU_API int segfmu_replan(
    const segfmu_trajectory *old, double time, const segfmu_problem *problem, double *space,
    segfmu_trajectory *trajectory);

/* Reach velocities (k,) [m/s] as soon as possible, wherever that is; zeros to stop. An axis keeps its
   velocity until the last one is there; the accelerations are 0 then. limits (k, n + 1) and lower
   (k, 2) or NULL as in segfmu_problem; time as above; the space is that of two points. The ramps are
   plateau ramps.

   Returns 0, or a PLAN_STATUS of records.h, below 0, with this in the report:
   OUT_OF_RANGE            of the time: nothing; of a limit: axis and value
   NO_VELOCITY_LIMIT, NO_ACCELERATION_LIMIT    axis and value of the limit, which is not above 0
   WAYPOINT_VELOCITY       axis, value, bound and side of a velocity beyond its limit; waypoint 1
   NO_PROFILE              first axis that does not reach its velocity within the limits
   CHECK_FAILED            nothing: numbers are badly scaled */
SEGFMU_API int segfmu_reach_velocity(
    const segfmu_trajectory *old, double time, const double *velocities, const double *limits,
    const double *lower, double *space, segfmu_trajectory *trajectory);

#ifdef __cplusplus
}
#endif

#endif
