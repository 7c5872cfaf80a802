/* Reads a problem as numbers from stdin, plans it, and prints the trajectory at 50 times. */
#include <stdio.h>
#include <stdlib.h>

#include "segfmu.h"

static double *numbers(long count)
{
    double *values = malloc((size_t)count * sizeof(double));
    for (long i = 0; i < count; i++) {
        if (scanf("%lf", &values[i]) != 1) {
            exit(3);
        }
    }
    return values;
}

int main(void)
{
    long m, k, n, shape, synchronization;
    if (scanf("%ld %ld %ld %ld %ld", &m, &k, &n, &shape, &synchronization) != 5) {
        return 3;
    }
    double *times = numbers(2), *y = numbers(m * k), *v = numbers(m * k), *a = numbers(m * k);
    double *dwells = numbers(m), *limits = numbers(k * (n + 1));
    segfmu_problem problem = {
        m, k, n, shape, synchronization, times[0], times[1], y, v, a, dwells, limits, NULL
    };
    double *space = malloc(segfmu_plan_size(m, k, n) * sizeof(double));
    double *values = malloc((size_t)k * sizeof(double));
    segfmu_trajectory trajectory;
    int status = segfmu_plan(&problem, space, &trajectory);
    printf("%d %.17g\n", status, status == 0 ? trajectory.duration : trajectory.report[0]);
    for (int i = 0; status == 0 && i < 50; i++) {
        double t = trajectory.duration * i / 49.0;
        for (int d = 0; d < 3; d++) {
            segfmu_value(&trajectory, t, d, values);
            for (long axis = 0; axis < k; axis++) {
                printf("%.17g ", values[axis]);
            }
        }
        printf("\n");
    }
    free(times); free(y); free(v); free(a); free(dwells); free(limits); free(space); free(values);
    return 0;
}
