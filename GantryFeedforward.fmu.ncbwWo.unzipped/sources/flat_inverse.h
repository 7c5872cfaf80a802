/* The flat inverse of the gantry crane, in `FEEDFORWARD`. */
#ifndef SEGFMU_FLAT_INVERSE_H
#define SEGFMU_FLAT_INVERSE_H

#include "records.h"

/* derivatives of the load's position that it needs, and where its results are */
enum {
    INVERSE_ORDERS = FLAT_ORDERS_CRANE, RESULTS = FEEDFORWARD_SIZE,
    RESULT_FORCE = FEEDFORWARD_FORCE, RESULT_STATE = FEEDFORWARD_STATE,
    RESULT_VELOCITY = RESULT_STATE + STATE_VELOCITY, RESULT_ACCELERATION = FEEDFORWARD_ACCELERATION,
    RESULT_SETPOINT = FEEDFORWARD_VELOCITY
};
#define feeds_results feeds_feedforward

#endif
