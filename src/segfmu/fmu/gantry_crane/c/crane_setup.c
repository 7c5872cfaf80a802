/* GantryCrane: parameters as the arrays of the kernels. */
#include <string.h>

#include "crane.h"
#include "say.h"

/* What is read as one array lies side by side. */
#define SIDE_BY_SIDE(first, last, count) \
    typedef char first##_is_first[(last) - (first) == (count) - 1 ? 1 : -1]
SIDE_BY_SIDE(V_REFERENCE_LOAD_POSITION_X, V_REFERENCE_LOAD_POSITION_Z, 3);
SIDE_BY_SIDE(V_BRIDGE_POSITION, V_SWAY_Y_RATE, STATE_SIZE);
SIDE_BY_SIDE(V_CRANE_BRIDGE_MASS, V_CRANE_ROPE_MAX, 6);
SIDE_BY_SIDE(V_DRIVE_BRIDGE_LAG, V_DRIVE_HOIST_ACCELERATION_MAX, 9);
SIDE_BY_SIDE(V_FRICTION_BRIDGE_VISCOUS, V_FRICTION_SWAY_VISCOUS, 8);
SIDE_BY_SIDE(V_TRAVEL_BRIDGE_MIN, V_TRAVEL_ROPE_MAX, 6);
SIDE_BY_SIDE(V_SENSOR_BRIDGE_POSITION_RESOLUTION, V_SENSOR_SWAY_Y_ANGLE_OFFSET, 15);
SIDE_BY_SIDE(V_PAYLOAD_1_TIME, V_PAYLOAD_4_MASS, 2 * CHANGES);

static const double SMALLEST_SAMPLE = 1e-6;

static bool set_parameters(crane *m, char message[MESSAGE])
{
    static const char *const axes[] = {"bridge", "trolley", "rope"};
    const double *real = m->base.real, *drive = &real[V_DRIVE_BRIDGE_LAG];
    const double *friction = &real[V_FRICTION_BRIDGE_VISCOUS];
    double *p = setting(m, SETTINGS_PLANT);
    memcpy(p, &real[V_CRANE_BRIDGE_MASS], MASSES_SIZE * sizeof *p);
    p[PLANT_MODE] = driven(m) ? DRIVE_MODE_VELOCITY : DRIVE_MODE_FORCE;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            p[PLANT_LAG + 3 * k + i] = drive[3 * i + k];
        }
        p[PLANT_VISCOUS + i] = friction[2 * i];
        p[PLANT_COULOMB + i] = friction[2 * i + 1];
        p[PLANT_TRAVEL_MIN + i] = real[V_TRAVEL_BRIDGE_MIN + 2 * i];
        p[PLANT_TRAVEL_MAX + i] = real[V_TRAVEL_BRIDGE_MIN + 2 * i + 1];
        p[PLANT_WIND + i] = real[V_WIND_CONSTANT_X + i];
        if (!(p[PLANT_TRAVEL_MIN + i] < p[PLANT_TRAVEL_MAX + i])) {
            return say(message, "travel.%s: min %g m must be below max %g m", axes[i],
                       p[PLANT_TRAVEL_MIN + i], p[PLANT_TRAVEL_MAX + i]);
        }
        if (driven(m) && p[PLANT_LAG + i] == 0.0 && m->base.interface != 1) {
            return say(message, "in model exchange with drive.mode velocity, drive.%s.lag must be "
                       "above 0 s, as without lag the acceleration does not follow from the "
                       "setpoints; set a lag, or use co-simulation",
                       i == 2 ? "hoist" : axes[i]);
        }
    }
    p[PLANT_FRICTION_WIDTH] = real[V_FRICTION_WIDTH];
    p[PLANT_SWAY_DAMPING] = real[V_FRICTION_SWAY_VISCOUS];
    memset(p + PLANT_GUST_START, 0, (PLANT_SIZE - PLANT_GUST_START) * sizeof *p);
    if (real[V_WIND_GUST_DURATION] > 0.0) {
        p[PLANT_GUST_START] = real[V_WIND_GUST_START];
        p[PLANT_GUST_DURATION] = real[V_WIND_GUST_DURATION];
        p[PLANT_GUST_SHAPE] = (double)(m->base.integer[V_WIND_GUST_SHAPE] - 1);
        memcpy(p + PLANT_GUST_FORCE, &real[V_WIND_GUST_FORCE_X], VECTOR_SIZE * sizeof *p);
    }
    return true;
}

static bool set_sensors(crane *m, char message[MESSAGE])
{
    const double *real = m->base.real, *own = &real[V_SENSOR_BRIDGE_POSITION_RESOLUTION];
    double *s = setting(m, SETTINGS_SENSORS), noise = 0.0;
    s[SENSORS_SAMPLE_TIME] = real[V_SENSOR_SAMPLE_TIME];
    s[SENSORS_DEAD_TIME] = real[V_SENSOR_DEAD_TIME];
    s[SENSORS_SEED] = (double)m->base.integer[V_SENSOR_SEED];
    for (int i = 0; i < COORDINATES_SIZE; i++) {
        s[SENSORS_OFFSET + i] = own[3 * i + 2];
        s[SENSORS_DEVIATION + i] = own[3 * i + 1];
        s[SENSORS_RESOLUTION + i] = own[3 * i];
        noise += s[SENSORS_DEVIATION + i];
    }
    if (s[SENSORS_SAMPLE_TIME] == 0.0 && (s[SENSORS_DEAD_TIME] > 0.0 || noise > 0.0)) {
        return say(message, "sensor noise and dead_time belong to samples: set sensor.sample_time "
                   "above 0 s");
    }
    if (s[SENSORS_SAMPLE_TIME] > 0.0 && s[SENSORS_SAMPLE_TIME] < SMALLEST_SAMPLE) {
        return say(message, "sensor.sample_time must be 0 or at least %g s, got %g s",
                   SMALLEST_SAMPLE, s[SENSORS_SAMPLE_TIME]);
    }
    if (s[SENSORS_DEAD_TIME] > MOST_SAMPLES * s[SENSORS_SAMPLE_TIME]) {
        return say(message, "sensor.dead_time %g s is longer than %d samples of %g s; lower it or "
                   "raise sensor.sample_time", s[SENSORS_DEAD_TIME], MOST_SAMPLES,
                   s[SENSORS_SAMPLE_TIME]);
    }
    return true;
}

static void set_disturbances(crane *m)
{
    double numbers[RANDOM_STATE_SIZE], deviation[VECTOR_SIZE];
    memcpy(deviation, &m->base.real[V_WIND_NOISE_DEVIATION_X], sizeof deviation);
    bool noisy = deviation[0] != 0.0 || deviation[1] != 0.0 || deviation[2] != 0.0;
    m->count_components = noisy ? COMPONENTS : 0;
    segfmu_seed_numbers(m->base.integer[V_WIND_NOISE_SEED], vector(numbers, RANDOM_STATE_SIZE));
    segfmu_noise_components(m->base.real[V_WIND_NOISE_BANDWIDTH], vector(deviation, VECTOR_SIZE),
                            vector(numbers, RANDOM_STATE_SIZE), components_of(m));
    m->count_changes = m->base.integer[V_PAYLOAD_COUNT];
    memcpy(m->changes, &m->base.real[V_PAYLOAD_1_TIME], sizeof m->changes);
}

bool crane_set_up(crane *m, char message[MESSAGE])
{
    const double *real = m->base.real;
    double *loop = setting(m, SETTINGS_LOOP);
    if (!(real[V_ROPE_LENGTH] > 0.0)) {
        return say(message, "rope.length must start above 0 m, got %g", real[V_ROPE_LENGTH]);
    }
    if (real[V_CRANE_ROPE_MAX] > 0.0 && !(real[V_CRANE_ROPE_MIN] < real[V_CRANE_ROPE_MAX])) {
        return say(message, "rope_min %g m must be less than rope_max %g m",
                   real[V_CRANE_ROPE_MIN], real[V_CRANE_ROPE_MAX]);
    }
    loop[LOOP_CORRECTOR] = m->base.integer[V_FEEDBACK_SOURCE] == 2 ? CORRECTOR_TRACKING
                                                                   : CORRECTOR_STATE;
    loop[LOOP_PERIOD] = real[V_FEEDBACK_SAMPLE_TIME];
    loop[LOOP_TOLERANCE] = TOLERANCE;
    if (!set_parameters(m, message) || !set_sensors(m, message) || !crane_set_gains(m, message)
        || !crane_set_tracking(m, message)) {
        return false;
    }
    set_disturbances(m);
    return true;
}
