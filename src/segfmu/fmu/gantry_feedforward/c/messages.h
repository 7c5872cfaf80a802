/* Why a plan is refused, in the words of the Python package. */
#ifndef SEGFMU_MESSAGES_H
#define SEGFMU_MESSAGES_H

#include "say.h"
#include "segfmu.h"

/* The message of a status of segfmu_plan and its report. */
bool say_infeasible(char message[MESSAGE], int status, const segfmu_problem *problem,
                    const double report[4]);

/* Whether waypoints that follow each other differ in something that doubles can tell. */
bool waypoints_differ(const segfmu_problem *problem, char message[MESSAGE]);

/* Proof that the load stays below the trolley, the rope taut, and its length within its range.
   crane: masses of bridge, trolley, load, gravity, shortest and longest rope (0: any). */
bool require_rope(const segfmu_trajectory *trajectory, const double crane[6],
                  char message[MESSAGE]);

#endif
