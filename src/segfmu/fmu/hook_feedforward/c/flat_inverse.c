/* HookFeedforward: the flat inverse of a crane with hook and sling. */
#include <string.h>

#include "feedforward.h"

void crane_of(const model *base, double known[RESISTANCE_SIZE])
{
    memset(known, 0, RESISTANCE_SIZE * sizeof *known);
    feed_record(&feeds_resistance, base, known);
    known[RESISTANCE_SUSPENSION] = HOOK_MODEL_CODE;
    known[RESISTANCE_TACKLE_MASS] = base->real[V_HOOK_MASS];
    known[RESISTANCE_SLING] = base->real[V_HOOK_SLING];
}

void invert(double known[RESISTANCE_SIZE], double *load, double results[RESULTS])
{
    invert_derivative(known, load, 0, results);
}

void invert_derivative(double known[RESISTANCE_SIZE], double *load, int64_t order, double results[RESULTS])
{
    enum { COLUMNS = MODEL_ORDERS + FLAT_ORDERS_CRANE };
    double work[SLING_SERIES_SIZE * COLUMNS];
    segfmu_hook_derivatives(
        matrix(load, ORDERS + order, AXES), order, vector(known, MASSES_SIZE),
        known[RESISTANCE_TACKLE_MASS], known[RESISTANCE_SLING],
        matrix(work, SLING_SERIES_SIZE, COLUMNS), vector(results, HOOK_INVERSE_SIZE));
}

/* Refuse obstacles that the rope is to keep off: its path is not judged. */
static bool require_free_rope(const model *base, char message[MESSAGE])
{
    double row[OBSTACLE_ROW_SIZE], fault[SPACE_FAULT_SIZE] = {0.0};
    for (int64_t i = 0; i < base->integer[V_OBSTACLE_COUNT]; i++) {
        feed_row(&feeds_obstacle_row, base, i, row);
        if (row[OBSTACLE_ROW_ROPE] > 0.0) {
            fault[SPACE_FAULT_BOX] = (double)i;
            return !segfmu_space_message(SPACE_STATUS_SLING, fault, message, MESSAGE);
        }
    }
    return true;
}

bool require_taut(const segfmu_trajectory *t, const model *base, char message[MESSAGE])
{
    const int64_t width = 2 * t->smoothness;
    double space[ROPE_WORK_SIZE * MOST_COLUMNS], work[HOOK_PATH_SIZE * HOOK_PATH_COLUMNS];
    double fault[ROPE_FAULT_SIZE], bounds[ROPE_BOUNDS_SIZE], known[RESISTANCE_SIZE];
    feed_record(&feeds_rope_bounds, base, bounds);
    crane_of(base, known);
    int64_t status = segfmu_check_hook(
        matrix((double *)t->timing, t->pieces, 2),
        matrix((double *)t->coefficients, t->pieces, width), offsets_of(t),
        vector((double *)t->ends, AXES), vector(known, MASSES_SIZE), known[RESISTANCE_TACKLE_MASS],
        known[RESISTANCE_SLING], vector(bounds, ROPE_BOUNDS_SIZE),
        matrix(space, ROPE_WORK_SIZE, 4 * width - 5),
        matrix(work, HOOK_PATH_SIZE, HOOK_PATH_COLUMNS), vector(fault, ROPE_FAULT_SIZE));
    return !segfmu_rope_message(status, fault, message, MESSAGE) && require_free_rope(base, message);
}
