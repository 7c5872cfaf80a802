/* Arrays of the kernels over the memory of a caller. */
#ifndef SEGFMU_ARRAYS_H
#define SEGFMU_ARRAYS_H

#include "kernels.h"

/* The next `count` numbers of a block of memory. */
static inline double *take(double **space, int64_t count)
{
    double *taken = *space;
    *space += count;
    return taken;
}

static inline array_double_1d vector(double *data, int64_t n)
{
    array_double_1d a = {data, {n}};
    return a;
}

static inline array_double_2d matrix(double *data, int64_t rows, int64_t columns)
{
    array_double_2d a = {data, {rows, columns}};
    return a;
}

static inline array_double_3d cuboid(double *data, int64_t layers, int64_t rows, int64_t columns)
{
    array_double_3d a = {data, {layers, rows, columns}};
    return a;
}

#endif
