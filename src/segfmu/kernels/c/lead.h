/* Shared by replan.c and velocity.c: what is left of the old plan, work space of the kernels that go on
   from there, and the check of pieces. Programs do not need it. */
#ifndef SEGFMU_LEAD_H
#define SEGFMU_LEAD_H

#include "problem.h"
#include "replan.h"

enum { STATE = WAYPOINT_STATE_SIZE };

/* What one call works with. The pieces of all parts of a plan (PlanPart) are in one block. */
typedef struct {
    int64_t axes, smoothness;
    array_double_2d limits;      /* (k, n + 1) */
    array_double_2d lower;       /* (k, Lower) */
    double *now;                 /* (k, n + 1): state at the start */
    double *outside;             /* (k,): time until axes are inside their limits [s] */
    array_double_2d tables;      /* (2 k, Axis): the axes, and their brakes */
    array_double_2d lead;        /* LeadWork */
    array_double_3d timing, coefficients;
    array_int64_t_1d offsets;
    double *space;
} replanning;

/* The pieces of a part of the plan (PlanPart); what is left of the old plan is FOLLOWED. */
piece_list segfmu_part(const replanning *t, int64_t part);

/* The rest of the old plan from a time on, and work space as large as segfmu_replan_size tells. */
replanning segfmu_begin_replanning(
    const segfmu_trajectory *old, double time, int64_t points, const double *limits,
    const double *lower, double *space);

/* What is left of the old plan from a time on. */
void segfmu_cut_rest(const segfmu_trajectory *old, double time, piece_list *rest);

/* Settle the targets of states (m, k, n + 1), which begin with the start. Returns PLANNED, or why
   states or limits are refused, with a report (Refusal). */
int segfmu_settle_targets(
    const replanning *t, int64_t points, double *states, double *report);

/* The states (k, n + 1) in which the pieces of axes begin; that of an axis without stays. */
void segfmu_start_states(const piece_list *list, int64_t smoothness, double *states);

/* Where the pieces of each axis end, and when: ends (k, DelayedState). */
void segfmu_end_pieces(const piece_list *list, double *ends);

/* Take what is left of the old plan for leads. */
void segfmu_follow_rest(const replanning *t);

/* Show pieces as the trajectory, judged; states (m, k, n + 1), times (m + 1, k). The part BEHIND is
   work space. */
int segfmu_judge(
    const replanning *t, const piece_list *found, int64_t points, double *states, double *times,
    segfmu_trajectory *trajectory);

/* Show pieces that are judged already as the trajectory. */
void segfmu_show(
    const replanning *t, const piece_list *found, int64_t points, const double *times,
    segfmu_trajectory *trajectory);

#endif
