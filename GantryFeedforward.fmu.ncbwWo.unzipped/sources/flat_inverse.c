/* GantryFeedforward: the flat inverse of the gantry crane. */
#include <string.h>

#include "feedforward.h"

void crane_of(const model *base, double known[RESISTANCE_SIZE])
{
    memset(known, 0, RESISTANCE_SIZE * sizeof *known);
    feed_record(&feeds_resistance, base, known);
}

void invert(double known[RESISTANCE_SIZE], double *load, double results[RESULTS])
{
    segfmu_crane_flat_inverse(
        matrix(load, ORDERS, AXES), vector(known, RESISTANCE_SIZE),
        vector(results, AXES_SIZE), vector(results + RESULT_STATE, STATE_SIZE),
        vector(results + RESULT_ACCELERATION, COORDINATES_SIZE));
}

void invert_derivative(double known[RESISTANCE_SIZE], double *load, int64_t order, double results[RESULTS])
{
    enum { COLUMNS = MODEL_ORDERS + 3 };
    double work[FLAT_SERIES_SIZE * COLUMNS];
    segfmu_flat_derivatives(
        matrix(load, ORDERS + order, AXES), order, vector(known, RESISTANCE_SIZE),
        matrix(work, FLAT_SERIES_SIZE, COLUMNS), vector(results, RESULTS));
}

/* Check that the load stays below the trolley, the rope taut, and its length within its range. */
bool require_taut(const segfmu_trajectory *t, const model *base, char message[MESSAGE])
{
    const int64_t width = 2 * t->smoothness;
    double space[ROPE_WORK_SIZE * MOST_COLUMNS];
    double fault[ROPE_FAULT_SIZE], bounds[ROPE_BOUNDS_SIZE];
    feed_record(&feeds_rope_bounds, base, bounds);
    int64_t status = segfmu_check_rope(
        matrix((double *)t->timing, t->pieces, 2),
        matrix((double *)t->coefficients, t->pieces, width), offsets_of(t),
        vector(bounds, ROPE_BOUNDS_SIZE), matrix(space, ROPE_WORK_SIZE, 4 * width - 5),
        vector(fault, ROPE_FAULT_SIZE));
    return !segfmu_rope_message(status, fault, message, MESSAGE);
}
