/* The flat inverse of the gantry crane, in `FEEDFORWARD`. */
#ifndef SEGFMU_FLAT_INVERSE_H
#define SEGFMU_FLAT_INVERSE_H

#include "model.h"
#include "records.h"

/* derivatives of the load's position that it needs, and where its results are */
enum {
    INVERSE_ORDERS = FLAT_ORDERS_CRANE, RESULTS = FEEDFORWARD_SIZE,
    RESULT_FORCE = FEEDFORWARD_FORCE, RESULT_STATE = FEEDFORWARD_STATE,
    RESULT_VELOCITY = RESULT_STATE + STATE_VELOCITY, RESULT_ACCELERATION = FEEDFORWARD_ACCELERATION,
    RESULT_SETPOINT = FEEDFORWARD_VELOCITY
};
#define feeds_results feeds_feedforward

/* The crane of the parameters. */
static void crane_of(const model *base, double known[RESISTANCE_SIZE]);

/* The inverse for derivatives of the load's position, one row each, and derivatives of it, for which
   there are so many rows more. */
static void invert(double known[RESISTANCE_SIZE], double *load, double results[RESULTS]);
static void invert_derivative(
    double known[RESISTANCE_SIZE], double *load, int64_t order, double results[RESULTS]);

#endif
