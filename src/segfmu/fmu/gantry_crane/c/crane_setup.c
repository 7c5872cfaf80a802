/* GantryCrane: parameters as the arrays of the kernels. */
#include "crane.h"
#include "feeds.h"
#include "messages.h"

static bool set_parameters(crane *m, char message[MESSAGE])
{
    double *plant = setting(m, SETTINGS_PLANT), *sensors = setting(m, SETTINGS_SENSORS);
    double fault[SETUP_FAULT_SIZE] = {0.0};
    const array_double_1d report = vector(fault, SETUP_FAULT_SIZE);
    feed_record(&feeds_plant, &m->base, plant);
    feed_record(&feeds_sensors, &m->base, sensors);
    int64_t status = segfmu_check_travel(vector(plant + PLANT_TRAVEL_MIN, AXES_SIZE),
                                         vector(plant + PLANT_TRAVEL_MAX, AXES_SIZE), report);
    if (status == SETUP_STATUS_FITS && m->base.interface != CO_SIMULATION) {
        status = segfmu_check_lags(vector(plant, PLANT_SIZE), report);
    }
    if (status == SETUP_STATUS_FITS) {
        status = segfmu_check_friction(vector(plant + PLANT_STATIC, AXES_SIZE),
                                       vector(plant + PLANT_COULOMB, AXES_SIZE), report);
    }
    if (status == SETUP_STATUS_FITS) {
        status = segfmu_check_delays(vector(plant, PLANT_SIZE),
                                     setting(m, SETTINGS_LOOP)[LOOP_PERIOD],
                                     m->base.interface != CO_SIMULATION, report);
    }
    if (status == SETUP_STATUS_FITS) {
        status = segfmu_check_sensors(vector(sensors, SENSORS_SIZE), report);
    }
    return !segfmu_setup_message(status, fault, message, MESSAGE);
}

static bool check_rope(const crane *m, char message[MESSAGE])
{
    const double *real = m->base.real;
    double fault[SETUP_FAULT_SIZE] = {0.0};
    int64_t status = segfmu_check_rope_bounds(real[V_ROPE_LENGTH], real[V_CRANE_ROPE_MIN],
                                              real[V_CRANE_ROPE_MAX],
                                              vector(fault, SETUP_FAULT_SIZE));
    return !segfmu_setup_message(status, fault, message, MESSAGE);
}

static void set_disturbances(crane *m)
{
    double numbers[RANDOM_STATE_SIZE], noise[WIND_NOISE_SIZE];
    bool noisy = false;
    feed_record(&feeds_wind_noise, &m->base, noise);
    for (int i = 0; i < VECTOR_SIZE; i++) {
        noisy = noisy || noise[WIND_NOISE_DEVIATION + i] != 0.0;
    }
    m->count_components = noisy ? COMPONENTS : 0;
    segfmu_seed_numbers((int64_t)noise[WIND_NOISE_SEED], vector(numbers, RANDOM_STATE_SIZE));
    segfmu_noise_components(noise[WIND_NOISE_BANDWIDTH],
                            vector(noise + WIND_NOISE_DEVIATION, VECTOR_SIZE),
                            vector(numbers, RANDOM_STATE_SIZE), components_of(m));
    m->count_changes = m->base.integer[V_PAYLOAD_COUNT];
    for (int64_t row = 0; row < m->count_changes; row++) {
        feed_row(&feeds_payload_change, &m->base, row, m->changes + row * PAYLOAD_CHANGE_SIZE);
    }
}

bool crane_set_up(crane *m, char message[MESSAGE])
{
    double *loop = setting(m, SETTINGS_LOOP);
    feed_record(&feeds_loop, &m->base, loop);
    loop[LOOP_TOLERANCE] = TOLERANCE;
    if (!check_rope(m, message) || !set_parameters(m, message) || !crane_set_gains(m, message)
        || !crane_set_tracking(m, message)) {
        return false;
    }
    set_disturbances(m);
    return true;
}
