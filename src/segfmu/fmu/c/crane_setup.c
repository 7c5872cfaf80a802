/* GantryCrane: parameters and inputs as the arrays of the kernels. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "say.h"

/* What is read as one array lies side by side. */
#define SIDE_BY_SIDE(first, last, count) \
    typedef char first##_is_first[(last) - (first) == (count) - 1 ? 1 : -1]
SIDE_BY_SIDE(V_FORCE_BRIDGE, V_REFERENCE_SWAY_Y_RATE, 16);
SIDE_BY_SIDE(V_REFERENCE_LOAD_POSITION_X, V_REFERENCE_LOAD_POSITION_Z, 3);
SIDE_BY_SIDE(V_WIND_X, V_WIND_Z, 3);
SIDE_BY_SIDE(V_BRIDGE_POSITION, V_SWAY_Y_RATE, STATE);
SIDE_BY_SIDE(V_CRANE_BRIDGE_MASS, V_CRANE_ROPE_MAX, 6);
SIDE_BY_SIDE(V_DRIVE_BRIDGE_LAG, V_DRIVE_HOIST_ACCELERATION_MAX, 9);
SIDE_BY_SIDE(V_FRICTION_BRIDGE_VISCOUS, V_FRICTION_SWAY_VISCOUS, 8);
SIDE_BY_SIDE(V_TRAVEL_BRIDGE_MIN, V_TRAVEL_ROPE_MAX, 6);
SIDE_BY_SIDE(V_SENSOR_BRIDGE_POSITION_RESOLUTION, V_SENSOR_SWAY_Y_ANGLE_OFFSET, 15);
SIDE_BY_SIDE(V_PAYLOAD_1_TIME, V_PAYLOAD_4_MASS, 2 * CHANGES);

static const double SMALLEST_SAMPLE = 1e-6;

/* what the kernel's memory says of the tick before where the gains were others, see kernels/rig/rig.py */
static const double RETUNED = 3.0;

static bool driven(const crane *m)
{
    return m->base.integer[V_DRIVE_MODE] == 2;
}

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

/* The table, whose columns are those of one axis each. */
static bool read_table(crane *m, char message[MESSAGE])
{
    static const struct { int first, axis, count, places[4]; } axes[] = {
        {V_FEEDBACK_TABLE_BRIDGE, 0, 4, {0, 3, 5, 8}},
        {V_FEEDBACK_TABLE_TROLLEY, 1, 4, {1, 4, 6, 9}},
        {V_FEEDBACK_TABLE_HOIST, 2, 2, {2, 7, 0, 0}}
    };
    const double *real = m->base.real;
    if (m->base.integer[V_FEEDBACK_TABLE_MODE] != m->base.integer[V_DRIVE_MODE]) {
        return say(message, "the gains of feedback.table are for the other drive.mode; set "
                   "feedback.design to flatness, or gains for this mode and feedback.table.mode");
    }
    m->count_lengths = m->base.integer[V_FEEDBACK_TABLE_COUNT];
    memset(m->gains, 0, sizeof m->gains);
    for (int64_t row = 0; row < m->count_lengths; row++) {
        m->lengths[row] = real[V_FEEDBACK_TABLE_LENGTH + row];
        if (row > 0 && !(m->lengths[row] > m->lengths[row - 1])) {
            return say(message, "feedback.table[%d].length %g m must be above that of the row "
                       "before, %g m", (int)row + 1, m->lengths[row], m->lengths[row - 1]);
        }
        for (int a = 0; a < 3; a++) {
            for (int k = 0; k < axes[a].count; k++) {
                m->gains[row * GAINS + axes[a].axis * STATE + axes[a].places[k]] =
                    real[axes[a].first + row * axes[a].count + k];
            }
        }
    }
    return true;
}

bool crane_rope_range(const crane *m, double range[2], char message[MESSAGE])
{
    const double *real = m->base.real;
    double shortest = real[V_CRANE_ROPE_MIN], longest = real[V_CRANE_ROPE_MAX];
    range[0] = shortest > 0.0 ? shortest : 0.2 * real[V_ROPE_LENGTH];
    range[1] = longest > 0.0 ? longest : 5.0 * real[V_ROPE_LENGTH];
    return range[0] <= range[1]
        || say(message, "the rope lengths of the feedback, %g to %g m, must be ascending; set "
               "crane.rope_min and crane.rope_max", range[0], range[1]);
}

double crane_node(const double range[2], int64_t row)
{
    double share = (double)row / (MOST_LENGTHS - 1);
    return row == MOST_LENGTHS - 1 ? range[1] : range[0] * pow(range[1] / range[0], share);
}

/* The closed form over rope lengths in equal ratios. */
static bool design_flat(crane *m, char message[MESSAGE])
{
    const double *real = m->base.real;
    double payload = nominal_payload(m), gravity = real[V_CRANE_GRAVITY], range[2];
    double delay = real[V_FEEDBACK_SAMPLE_TIME];
    if (driven(m)) {
        delay += fmax(m->parameters[5], fmax(m->parameters[6], m->parameters[7]));
    }
    if (!crane_rope_range(m, range, message)) {
        return false;
    }
    m->count_lengths = range[1] > range[0] ? MOST_LENGTHS : 1;
    for (int64_t row = 0; row < m->count_lengths; row++) {
        m->lengths[row] = crane_node(range, row);
        double bandwidth = segfmu_feedback_bandwidth(
            real[V_FEEDBACK_BANDWIDTH], m->lengths[row], gravity, delay, LARGEST_ANGLE);
        double hoist = segfmu_feedback_bandwidth(
            real[V_FEEDBACK_HOIST_BANDWIDTH], m->lengths[row], gravity, delay,
            LARGEST_HOIST_ANGLE);
        segfmu_feedback_gains(
            driven(m), m->lengths[row], real[V_CRANE_BRIDGE_MASS], real[V_CRANE_TROLLEY_MASS],
            payload, gravity, bandwidth, hoist, real[V_FEEDBACK_DAMPING],
            matrix(m->gains + row * GAINS, 3, STATE));
    }
    return true;
}

bool crane_set_gains(crane *m, char message[MESSAGE])
{
    double before[MOST_LENGTHS * GAINS];
    memcpy(before, m->gains, sizeof before);
    m->base.tuned = 0;
    m->loop[2] = (double)m->base.integer[V_FEEDBACK_ENABLED];
    m->loop[4] = m->base.real[V_FEEDBACK_FADE];
    if (!(m->base.integer[V_FEEDBACK_DESIGN] == 2 ? design_flat(m, message)
                                                  : read_table(m, message))) {
        return false;
    }
    bool switched = memcmp(before, m->gains, sizeof before) != 0;
    if (m->loop[0] > 1.5) {
        crane_tune_tracking(m, switched);
    } else if (switched && m->rows > 0 && m->memory[ROW_CORRECTION * COLUMNS + 6] > 0.0) {
        m->memory[ROW_CORRECTION * COLUMNS + 6] = RETUNED;
    }
    return true;
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

void crane_read_inputs(crane *m)
{
    const double *real = m->base.real;
    memcpy(m->setpoints, &real[V_FORCE_BRIDGE], 16 * sizeof *real);
    memcpy(m->setpoints + 16, &real[V_WIND_X], 3 * sizeof *real);
}

bool crane_failed(crane *m, int64_t status, double time, char message[MESSAGE])
{
    static const char *const reasons[] = {
        "a sway angle came to 90 degrees", "the rope's length came to zero",
        "the integration steps became too small", "a value is not finite", "the rope went slack"
    };
    static const char *const axes[] = {"bridge", "trolley", "rope"};
    if (status < 6) {
        return say(message, "at %.3f s: %s; check the setpoints, the masses and the friction", time,
                   reasons[status - 1]);
    }
    int64_t axis = (status - 6) % 3, limit = (status >= 9 ? 25 : 22) + axis;
    return say(message, "at %.3f s: %s at %.6g m is at its end stop, %s position %.6g m; shorten "
               "the move, brake earlier or widen the travel limits", time, axes[axis],
               m->memory[axis], status >= 9 ? "greatest" : "least", m->parameters[limit]);
}
