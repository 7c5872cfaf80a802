/* A crane: why the plant has failed. */
#include <math.h>

#include "crane.h"
#include "messages.h"
#include "records.h"

/* Whether a failure follows from a start far from the reference: within a swing of the load. */
static bool misplaced(const crane *m, int64_t status, double time)
{
    const double turn = 6.283185307179586;
    double length = m->shown[STATE_POSITION + AXES_ROPE];
    return m->fit != START_STATUS_FITS && status < PLANT_STATUS_BELOW_TRAVEL
        && time - m->base.start < turn * sqrt(length / m->base.real[V_CRANE_GRAVITY]);
}

bool crane_failed(crane *m, int64_t status, double time, char message[MESSAGE])
{
    double fault[PLANT_FAULT_SIZE];
    if (misplaced(m, status, time)) {
        m->misfit[START_FAULT_TIME] = time;
        return !segfmu_start_message(START_STATUS_FAILED, m->misfit, message, MESSAGE);
    }
    status = segfmu_plant_failure(status, time, vector(row(m, MEMORY_STATE), PLANT_STATE_SIZE),
                                  vector(setting(m, SETTINGS_PLANT), PLANT_SIZE),
                                  vector(fault, PLANT_FAULT_SIZE));
    return !segfmu_plant_message(status, fault, message, MESSAGE);
}
