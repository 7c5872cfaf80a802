/* A search for limits of the load, and for free states of waypoints with them. */
#ifndef SEGFMU_LIMIT_SEARCH_H
#define SEGFMU_LIMIT_SEARCH_H

#include "feedforward.h"

/* unknowns: limits, then velocities and accelerations of places between the first and the last */
enum { LIMIT_UNKNOWNS = AXES * LIMIT_ROW_SIZE, STATE_UNKNOWNS = 2 * AXES, POINT = AXES * WAYPOINT_STATE_SIZE };

/* Plans whose peaks are remembered: slopes change every unknown once. */
enum { SEEN = 32 };

typedef struct {
    uint64_t sum;      /* of the plan */
    double peaks[2 * DEMAND_SIZE], times[2 * DEMAND_SIZE];
} seen_plan;

typedef struct {
    double bounds[DRIVE_BOUNDS_SIZE], known[RESISTANCE_SIZE], caps[LIMIT_UNKNOWNS];
    double axes[AXES * AXIS_TASK_SIZE], values[SEARCH_VALUES_SIZE * VALUES_SIZE];
    double uses[2 * DEMAND_SIZE], most, least, heading[HEADING_SIZE];
    seen_plan seen[SEEN];
    int64_t points, places, unknowns, looks;
    bool chooses;      /* free states are searched for, too */
    bool strict;       /* where bounds are exceeded paths are judged as well: free states lead astray */
    request base;      /* states with rest where they are free */
    /* by waypoint, in the block behind the plan */
    double *states, *tried, *place, *places_at, *led;
    /* by unknown, there as well; closest: of the last plans the one that uses the bounds least */
    double *kinds, *starts, *rows, *slopes, *newton, *closest;
} limit_search;

/* Begin a search in the block behind the plan, with the places of the waypoints; whether free states
   are to be searched for. */
static bool find_places(limit_search *s, feedforward *m);

/* Velocities and accelerations of states (points, AXES, WAYPOINT_STATE). */
static void split_states(const double *states, int64_t points, request *r);

#endif
