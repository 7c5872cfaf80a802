/* Plans from the problem in stdin, replans to its last waypoint and to a new one, and stops. */
#include <stdio.h>
#include <stdlib.h>

#include "replan.h"

static void show(int status, const segfmu_trajectory *trajectory)
{
    double values[8];
    printf("%d", status);
    if (status == 0) {
        printf(" %.17g", trajectory->duration);
        for (int d = 0; d <= trajectory->smoothness; d++) {
            segfmu_value(trajectory, 0.0, d, values);
            printf(" %.17g", values[0]);
        }
        segfmu_value(trajectory, trajectory->duration, 0, values);
        printf(" %.17g %.17g", values[0], values[1]);
    }
    printf("\n");
}

int main(void)
{
    double number[64];
    int count = 0;
    while (count < 64 && scanf("%lf", &number[count]) == 1) {
        count++;
    }
    const long n = (long)number[0];
    const double time = number[1], *limits = number + 2;
    double positions[4] = {0.0, 0.0, 1.0, 0.5}, rest[4] = {0.0, 0.0, 0.0, 0.0};
    segfmu_problem problem = {
        2, 2, n, SEGFMU_PLATEAU, SEGFMU_WAYPOINTS, 0.0, 0.0, positions, rest, rest, rest, limits
    };
    double *space = malloc(segfmu_plan_size(2, 2, n) * sizeof(double));
    segfmu_trajectory old, found;
    show(segfmu_plan(&problem, space, &old), &old);
    double *other = malloc(segfmu_replan_size(2, 2, n, old.pieces) * sizeof(double));
    show(segfmu_replan(&old, time, &problem, other, &found), &found);
    positions[2] = 0.2;
    positions[3] = -0.4;
    show(segfmu_replan(&old, time, &problem, other, &found), &found);
    show(segfmu_reach_velocity(&old, time, rest, limits, other, &found), &found);
    free(space);
    free(other);
    return 0;
}
