/* A crane: crane and rope lengths that the tables of gains and of the observer are for. */
#include <string.h>

#include "crane.h"
#include "messages.h"

int64_t crane_lengths(const crane *m, int64_t most, double lengths[], char message[MESSAGE])
{
    const double *real = m->base.real;
    double fault[SETUP_FAULT_SIZE] = {0.0}, range[ROPE_RANGE_SIZE];
    segfmu_rope_range(real[V_ROPE_LENGTH], real[V_CRANE_ROPE_MIN], real[V_CRANE_ROPE_MAX],
                      vector(range, ROPE_RANGE_SIZE));
    int64_t status = segfmu_check_lengths(vector(range, ROPE_RANGE_SIZE),
                                          vector(fault, SETUP_FAULT_SIZE));
    if (segfmu_setup_message(status, fault, message, MESSAGE)) {
        return 0;
    }
    return segfmu_table_lengths(range[ROPE_RANGE_SHORTEST], range[ROPE_RANGE_LONGEST],
                                most, vector(lengths, most));
}

void crane_nominal(crane *m, double plant[PLANT_SIZE])
{
    memcpy(plant, setting(m, SETTINGS_PLANT), PLANT_SIZE * sizeof *plant);
    plant[PLANT_PAYLOAD_MASS] = nominal_payload(m);
}
