/* Shared by replan.c and velocity.c: what is left of the old plan, leads from it, and the check of
   what follows. Programs do not need it. */
#ifndef SEGFMU_LEAD_H
#define SEGFMU_LEAD_H

#include "problem.h"
#include "replan.h"

enum { STATE = WAYPOINT_STATE_SIZE };

/* What one call works with; `rest` is what is left of the old plan. */
typedef struct {
    int64_t axes, smoothness;
    array_double_2d limits;      /* (k, n + 1) */
    array_double_2d lower;       /* (k, Lower) */
    double *now;                 /* (k, n + 1): state at the start */
    double *ends;                /* (k, DelayedState): where leads end */
    double *outside;             /* (k,): time until axes are inside their limits [s] */
    piece_list rest, leads, plan, joined;
    double *space;
} replanning;

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

/* Where the rest of each axis ends, and when, in t->ends. */
void segfmu_end_rest(replanning *t);

/* The leads of all axes to targets (k, n + 1); the first axis that has none, or -1.
   order: of LeadStage. meeting >= 0: the axes meet at the targets, after this time or later; else each is as fast as it
   can. */
int64_t segfmu_settle_axes(replanning *t, int64_t order, int64_t shape, double meeting,
                           const double *targets);

/* Show pieces as the trajectory, judged; states (m, k, n + 1), times (m + 1, k). */
int segfmu_judge_pieces(
    const replanning *t, const piece_list *found, int64_t points, double *states, double *times,
    double *space, segfmu_trajectory *trajectory);

/* The leads and what follows them, judged. */
int segfmu_join_leads(
    replanning *t, int64_t points, double *states, double *times, double *space,
    segfmu_trajectory *trajectory);

#endif
