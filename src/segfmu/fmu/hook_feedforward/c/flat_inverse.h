/* The flat inverse of a crane with hook and sling, in `HOOK_FEEDFORWARD`. */
#ifndef SEGFMU_FLAT_INVERSE_H
#define SEGFMU_FLAT_INVERSE_H

#include "records.h"

/* derivatives of the load's position that it needs, and where its results are */
enum {
    INVERSE_ORDERS = HOOK_MODEL_ORDERS, RESULTS = HOOK_FEEDFORWARD_SIZE,
    RESULT_FORCE = HOOK_FEEDFORWARD_FORCE, RESULT_STATE = HOOK_FEEDFORWARD_STATE,
    RESULT_VELOCITY = RESULT_STATE + HOOK_STATE_VELOCITY,
    RESULT_ACCELERATION = HOOK_FEEDFORWARD_ACCELERATION, RESULT_SETPOINT = HOOK_FEEDFORWARD_VELOCITY
};
#define feeds_results feeds_hook_feedforward

#endif
