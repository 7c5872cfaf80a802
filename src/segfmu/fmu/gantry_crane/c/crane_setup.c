/* GantryCrane: parameters as the arrays of the kernels. */
#include <string.h>

#include "crane.h"
#include "say.h"

/* What is read as one array lies side by side. */
#define SIDE_BY_SIDE(first, last, count) \
    typedef char first##_is_first[(last) - (first) == (count) - 1 ? 1 : -1]
SIDE_BY_SIDE(V_REFERENCE_LOAD_POSITION_X, V_REFERENCE_LOAD_POSITION_Z, 3);
SIDE_BY_SIDE(V_BRIDGE_POSITION, V_SWAY_Y_RATE, STATE);
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
    double *p = m->parameters;
    memcpy(p, &real[V_CRANE_BRIDGE_MASS], 4 * sizeof *p);
    p[4] = driven(m);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            p[5 + 3 * k + i] = drive[3 * i + k];
        }
        p[14 + i] = friction[2 * i];
        p[17 + i] = friction[2 * i + 1];
        p[22 + i] = real[V_TRAVEL_BRIDGE_MIN + 2 * i];
        p[25 + i] = real[V_TRAVEL_BRIDGE_MIN + 2 * i + 1];
        p[28 + i] = real[V_WIND_CONSTANT_X + i];
        if (!(p[22 + i] < p[25 + i])) {
            return say(message, "travel.%s: min %g m must be below max %g m", axes[i], p[22 + i],
                       p[25 + i]);
        }
        if (driven(m) && p[5 + i] == 0.0 && m->base.interface != 1) {
            return say(message, "in model exchange with drive.mode velocity, drive.%s.lag must be "
                       "above 0 s, as without lag the acceleration does not follow from the "
                       "setpoints; set a lag, or use co-simulation",
                       i == 2 ? "hoist" : axes[i]);
        }
    }
    p[20] = real[V_FRICTION_WIDTH];
    p[21] = real[V_FRICTION_SWAY_VISCOUS];
    memset(p + 31, 0, 6 * sizeof *p);
    if (real[V_WIND_GUST_DURATION] > 0.0) {
        p[31] = real[V_WIND_GUST_START];
        p[32] = real[V_WIND_GUST_DURATION];
        p[33] = (double)(m->base.integer[V_WIND_GUST_SHAPE] - 1);
        memcpy(p + 34, &real[V_WIND_GUST_FORCE_X], 3 * sizeof *p);
    }
    return true;
}

static bool set_sensors(crane *m, char message[MESSAGE])
{
    const double *real = m->base.real, *own = &real[V_SENSOR_BRIDGE_POSITION_RESOLUTION];
    double *s = m->sensors, noise = 0.0;
    s[0] = real[V_SENSOR_SAMPLE_TIME];
    s[1] = real[V_SENSOR_DEAD_TIME];
    s[2] = (double)m->base.integer[V_SENSOR_SEED];
    for (int i = 0; i < 5; i++) {
        s[3 + i] = own[3 * i + 2];
        s[8 + i] = own[3 * i + 1];
        s[13 + i] = own[3 * i];
        noise += s[8 + i];
    }
    if (s[0] == 0.0 && (s[1] > 0.0 || noise > 0.0)) {
        return say(message, "sensor noise and dead_time belong to samples: set sensor.sample_time "
                   "above 0 s");
    }
    if (s[0] > 0.0 && s[0] < SMALLEST_SAMPLE) {
        return say(message, "sensor.sample_time must be 0 or at least %g s, got %g s",
                   SMALLEST_SAMPLE, s[0]);
    }
    if (s[1] > MOST_SAMPLES * s[0]) {
        return say(message, "sensor.dead_time %g s is longer than %d samples of %g s; lower it or "
                   "raise sensor.sample_time", s[1], MOST_SAMPLES, s[0]);
    }
    return true;
}

static void set_disturbances(crane *m)
{
    double numbers[2], deviation[3];
    memcpy(deviation, &m->base.real[V_WIND_NOISE_DEVIATION_X], sizeof deviation);
    bool noisy = deviation[0] != 0.0 || deviation[1] != 0.0 || deviation[2] != 0.0;
    m->count_components = noisy ? COMPONENTS : 0;
    segfmu_seed_numbers(m->base.integer[V_WIND_NOISE_SEED], vector(numbers, 2));
    segfmu_noise_components(m->base.real[V_WIND_NOISE_BANDWIDTH], vector(deviation, 3),
                            vector(numbers, 2), matrix(m->components, m->count_components, 7));
    m->count_changes = m->base.integer[V_PAYLOAD_COUNT];
    memcpy(m->changes, &m->base.real[V_PAYLOAD_1_TIME], sizeof m->changes);
}

bool crane_set_up(crane *m, char message[MESSAGE])
{
    const double *real = m->base.real;
    if (!(real[V_ROPE_LENGTH] > 0.0)) {
        return say(message, "rope.length must start above 0 m, got %g", real[V_ROPE_LENGTH]);
    }
    if (real[V_CRANE_ROPE_MAX] > 0.0 && !(real[V_CRANE_ROPE_MIN] < real[V_CRANE_ROPE_MAX])) {
        return say(message, "rope_min %g m must be less than rope_max %g m",
                   real[V_CRANE_ROPE_MIN], real[V_CRANE_ROPE_MAX]);
    }
    m->loop[0] = (double)m->base.integer[V_FEEDBACK_SOURCE];
    m->loop[1] = real[V_FEEDBACK_SAMPLE_TIME];
    m->loop[3] = TOLERANCE;
    if (!set_parameters(m, message) || !set_sensors(m, message) || !crane_set_gains(m, message)
        || !crane_set_tracking(m, message)) {
        return false;
    }
    set_disturbances(m);
    return true;
}
