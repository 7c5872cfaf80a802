/* Arrays as the translated kernels take them: C order, no gaps, owned by the caller.

   A function gets a pointer and the extents by value; nothing is allocated. The names are those
   that Pyccel writes; its own span library is not needed for what the kernels use. */
#ifndef SEGFMU_SPAN_H
#define SEGFMU_SPAN_H

#include <stdint.h>

/* Short functions that GNU C would call; where size counts more, the macro is given as empty. */
#ifndef SPAN_INLINE
#ifdef __GNUC__
#define SPAN_INLINE inline __attribute__((always_inline))
#else
#define SPAN_INLINE
#endif
#endif

enum { MOST_DIMENSIONS = 3 };

typedef struct { double *data; int64_t shape[1]; } array_double_1d;
typedef struct { double *data; int64_t shape[2]; } array_double_2d;
typedef struct { double *data; int64_t shape[MOST_DIMENSIONS]; } array_double_3d;
typedef struct { int64_t *data; int64_t shape[1]; } array_int64_t_1d;

/* Address of an element: cspan_at(&a, i), cspan_at(&a, i, j) or cspan_at(&a, i, j, k). */
#define cspan_at(...) SPAN_PICK(__VA_ARGS__, SPAN_AT3, SPAN_AT2, SPAN_AT1, 0)(__VA_ARGS__)
#define SPAN_PICK(a, i, j, k, chosen, ...) chosen
#define SPAN_AT1(a, i) ((a)->data + (i))
#define SPAN_AT2(a, i, j) ((a)->data + (i) * (a)->shape[1] + (j))
#define SPAN_AT3(a, i, j, k) ((a)->data + ((i) * (a)->shape[1] + (j)) * (a)->shape[2] + (k))

/* a[i, :] */
static inline array_double_1d span_row(const array_double_2d *a, int64_t i)
{
    array_double_1d row = {a->data + i * a->shape[1], {a->shape[1]}};
    return row;
}

/* a[first:last, :] */
static inline array_double_2d span_rows(const array_double_2d *a, int64_t first, int64_t last)
{
    array_double_2d rows = {a->data + first * a->shape[1], {last - first, a->shape[1]}};
    return rows;
}

/* a[first:last, :, :] */
static inline array_double_3d span_layers(const array_double_3d *a, int64_t first, int64_t last)
{
    const int64_t size = a->shape[1] * a->shape[2];
    array_double_3d layers = {a->data + first * size, {last - first, a->shape[1], a->shape[2]}};
    return layers;
}

/* a[first:last] */
static inline array_double_1d span_piece(const array_double_1d *a, int64_t first, int64_t last)
{
    array_double_1d piece = {a->data + first, {last - first}};
    return piece;
}

static inline array_int64_t_1d span_part(const array_int64_t_1d *a, int64_t first, int64_t last)
{
    array_int64_t_1d part = {a->data + first, {last - first}};
    return part;
}

/* a[i, :, :] */
static inline array_double_2d span_matrix(const array_double_3d *a, int64_t i)
{
    array_double_2d matrix = {
        a->data + i * a->shape[1] * a->shape[2], {a->shape[1], a->shape[2]}
    };
    return matrix;
}

/* min(a, b) and max(a, b) of Python, the first one where they are equal. */
static inline double span_min(double a, double b)
{
    return b < a ? b : a;
}

static inline double span_max(double a, double b)
{
    return b > a ? b : a;
}

static inline int64_t span_min_int(int64_t a, int64_t b)
{
    return b < a ? b : a;
}

static inline int64_t span_max_int(int64_t a, int64_t b)
{
    return b > a ? b : a;
}

/* a // b of Python: rounded down. */
static inline int64_t span_floor_div(int64_t a, int64_t b)
{
    int64_t quotient = a / b;
    return a % b != 0 && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

/* a % b of Python: with the sign of b. */
static inline int64_t span_floor_mod(int64_t a, int64_t b)
{
    int64_t rest = a % b;
    return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}

#endif
