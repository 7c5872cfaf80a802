/* GantryCrane: crane and rope lengths that the tables of gains and of the observer are for. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "messages.h"

bool crane_rope_range(const crane *m, double range[2], char message[MESSAGE])
{
    const double *real = m->base.real;
    double shortest = real[V_CRANE_ROPE_MIN], longest = real[V_CRANE_ROPE_MAX];
    range[0] = shortest > 0.0 ? shortest : 0.2 * real[V_ROPE_LENGTH];
    range[1] = longest > 0.0 ? longest : 5.0 * real[V_ROPE_LENGTH];
    double fault[SETUP_FAULT_SIZE] = {0.0};
    fault[SETUP_FAULT_VALUE] = range[0];
    fault[SETUP_FAULT_BOUND] = range[1];
    return range[0] <= range[1]
        || !segfmu_setup_message(SETUP_STATUS_LENGTHS, fault, message, MESSAGE);
}

double crane_node(const double range[2], int64_t row)
{
    double share = (double)row / (MOST_LENGTHS - 1);
    return row == MOST_LENGTHS - 1 ? range[1] : range[0] * pow(range[1] / range[0], share);
}

void crane_nominal(crane *m, double plant[PLANT_SIZE])
{
    memcpy(plant, setting(m, SETTINGS_PLANT), PLANT_SIZE * sizeof *plant);
    plant[PLANT_PAYLOAD_MASS] = nominal_payload(m);
}
