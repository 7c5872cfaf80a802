/* A crane: parameters as the arrays of the kernels. */
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "messages.h"

static bool set_parameters(crane *m, char message[MESSAGE])
{
    double *plant = setting(m, SETTINGS_PLANT), *sensors = setting(m, SETTINGS_SENSORS);
    double fault[SETUP_FAULT_SIZE] = {0.0};
    const array_double_1d report = vector(fault, SETUP_FAULT_SIZE);
    feed_record(&feeds_plant, &m->base, plant);
    crane_read_suspension(&m->base, plant);
    feed_record(&feeds_sensors, &m->base, sensors);
    int64_t status = segfmu_check_travel(vector(plant + PLANT_TRAVEL_MIN, AXES_SIZE),
                                         vector(plant + PLANT_TRAVEL_MAX, AXES_SIZE), report);
    if (status == SETUP_STATUS_FITS) {
        status = segfmu_check_lags(vector(plant, PLANT_SIZE), m->base.interface != CO_SIMULATION,
                                   report);
    }
    if (status == SETUP_STATUS_FITS) {
        status = segfmu_check_slack(vector(plant, PLANT_SIZE), m->base.interface != CO_SIMULATION,
                                    report);
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

/* Rows of the components from one on, for one part of them. */
static array_double_2d sines_from(crane *m, int64_t first)
{
    return matrix(m->components + first * SINUSOID_SIZE, DISTURBANCE_COMPONENTS, SINUSOID_SIZE);
}

static bool any(const double values[VECTOR_SIZE])
{
    return values[0] != 0.0 || values[1] != 0.0 || values[2] != 0.0;
}

/* Noise of the wind's force, then turbulence of the air; false without a mean speed for it. */
static bool set_wind(crane *m, char message[MESSAGE])
{
    double numbers[RANDOM_STATE_SIZE], noise[WIND_NOISE_SIZE], air[TURBULENCE_SIZE];
    double fault[SETUP_FAULT_SIZE] = {0.0};
    const array_double_1d random = vector(numbers, RANDOM_STATE_SIZE);
    const array_double_1d speed = vector(air + TURBULENCE_SPEED, VECTOR_SIZE);
    const array_double_1d deviation = vector(air + TURBULENCE_DEVIATION, VECTOR_SIZE);
    feed_record(&feeds_wind_noise, &m->base, noise);
    feed_record(&feeds_turbulence, &m->base, air);
    int64_t status = segfmu_check_turbulence(speed, deviation, vector(fault, SETUP_FAULT_SIZE));
    if (segfmu_setup_message(status, fault, message, MESSAGE)) {
        return false;
    }
    m->count_components = 0;
    memset(m->components, 0, sizeof m->components);
    if (any(noise + WIND_NOISE_DEVIATION)) {
        segfmu_seed_numbers((int64_t)noise[WIND_NOISE_SEED], random);
        segfmu_noise_components(noise[WIND_NOISE_BANDWIDTH],
                                vector(noise + WIND_NOISE_DEVIATION, VECTOR_SIZE), random,
                                sines_from(m, 0));
        m->count_components = DISTURBANCE_COMPONENTS;
    }
    if (any(air + TURBULENCE_DEVIATION)) {
        segfmu_seed_numbers((int64_t)air[TURBULENCE_SEED], random);
        segfmu_turbulence_components(segfmu_wind_speed(speed), air[TURBULENCE_LENGTH],
                                     air[TURBULENCE_BANDWIDTH], deviation, random,
                                     sines_from(m, m->count_components));
        m->count_components += DISTURBANCE_COMPONENTS;
    }
    return true;
}

/* Changes of the load; false if two are at one time. */
static bool set_changes(crane *m, char message[MESSAGE])
{
    double fault[SETUP_FAULT_SIZE] = {0.0};
    m->count_changes = m->base.integer[V_PAYLOAD_COUNT];
    for (int64_t row = 0; row < m->count_changes; row++) {
        feed_row(&feeds_payload_change, &m->base, row, m->changes + row * PAYLOAD_CHANGE_SIZE);
    }
    int64_t status = segfmu_check_changes(changes_of(m), vector(fault, SETUP_FAULT_SIZE));
    return !segfmu_setup_message(status, fault, message, MESSAGE);
}

bool crane_set_up(crane *m, char message[MESSAGE])
{
    double *loop = setting(m, SETTINGS_LOOP);
    feed_record(&feeds_loop, &m->base, loop);
    loop[LOOP_TOLERANCE] = TOLERANCE;
    if (crane_corrects(m)) {
        loop[LOOP_CORRECTOR] = CORRECTOR_CALLER;
    }
    if (!check_rope(m, message) || !set_parameters(m, message) || !crane_set_gains(m, message)
        || !crane_set_feedback(m, message) || !set_wind(m, message)) {
        return false;
    }
    return set_changes(m, message);
}
