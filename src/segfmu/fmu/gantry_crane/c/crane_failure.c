/* GantryCrane: why the plant has failed. */
#include "crane.h"
#include "messages.h"
#include "records.h"

bool crane_failed(crane *m, int64_t status, double time, char message[MESSAGE])
{
    double fault[PLANT_FAULT_SIZE];
    status = segfmu_plant_failure(status, time, vector(row(m, MEMORY_STATE), STATE_SIZE),
                                  vector(setting(m, SETTINGS_PLANT), PLANT_SIZE),
                                  vector(fault, PLANT_FAULT_SIZE));
    return !segfmu_plant_message(status, fault, message, MESSAGE);
}
