/* A batch of boundary problems, as both drivers take it; arrays in C order, SI units. */
#ifndef BATCH_H
#define BATCH_H

#include <stdint.h>

typedef struct {
    int64_t count, axes, smoothness, shape;
    const double *limits;        /* (count, axes, smoothness + 1), 0 where absent */
    const double *positions;     /* (count, 2, axes): start, end */
    const double *velocities;    /* (count, 2, axes) */
    const double *accelerations; /* (count, 2, axes) */
    double *durations;           /* (count,) out: s, NaN where refused */
    double *times;               /* (count,) out: us of each problem; NULL: the whole is timed */
} batch;

#endif
