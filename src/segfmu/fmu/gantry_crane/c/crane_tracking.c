/* GantryCrane: the feedback from measured signals, as `tracking_from` of feedback_parameters.py. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "say.h"

/* What is read as one array lies side by side. */
typedef char expected_is_first
    [V_FEEDBACK_OBSERVER_WIND - V_FEEDBACK_OBSERVER_POSITION == 4 ? 1 : -1];
typedef char bridge_is_first
    [V_ESTIMATE_DISTURBANCE_LOAD_Y - V_ESTIMATE_DISTURBANCE_BRIDGE == 4 ? 1 : -1];

static const double UNLIMITED = 1e99;

/* Rope lengths and the table of the observer, with a work space of the kernel. */
static bool design_observer(crane *m, const double range[2], char message[MESSAGE])
{
    const double *real = m->base.real;
    double work[80 * 16], expected[5], lag[3], gravity = real[V_CRANE_GRAVITY];
    memcpy(expected, &real[V_FEEDBACK_OBSERVER_POSITION], sizeof expected);
    expected[3] *= gravity;
    expected[4] *= gravity;
    for (int i = 0; i < 3; i++) {
        lag[i] = real[V_DRIVE_BRIDGE_LAG + 3 * i];
    }
    m->count_nodes = range[1] > range[0] ? MOST_LENGTHS : 1;
    for (int64_t row = 0; row < m->count_nodes; row++) {
        m->nodes[row] = crane_node(range, row);
        segfmu_observer_design(
            driven(m), real[V_FEEDBACK_SAMPLE_TIME], m->nodes[row], real[V_CRANE_BRIDGE_MASS],
            real[V_CRANE_TROLLEY_MASS], nominal_payload(m), gravity, vector(lag, 3),
            vector(expected, 5), matrix(work, 80, 16), matrix(m->observer + row * BLOCK, 18, STATE));
    }
    for (int64_t i = 0; i < m->count_nodes * BLOCK; i++) {
        if (!isfinite(m->observer[i])) {
            return say(message, "the observer has no finite gains between %g and %g m of rope; check "
                       "masses, lags and feedback.observer", range[0], range[1]);
        }
    }
    return true;
}

/* As `Uncertainty.offset_parameters`. */
static void set_offset(crane *m, double longest)
{
    const double *real = m->base.real;
    double *p = m->tracking + 23, gravity = real[V_CRANE_GRAVITY];
    double angle = real[V_FEEDBACK_OBSERVER_ANGLE];
    double place = fmax(real[V_FEEDBACK_OBSERVER_POSITION], real[V_FEEDBACK_OBSERVER_LENGTH]);
    p[0] = real[V_FEEDBACK_OBSERVER_OFFSET];
    p[1] = fmin(OFFSET_RATIO * sqrt(gravity / longest),
                LARGEST_OFFSET_ANGLE / real[V_FEEDBACK_SAMPLE_TIME]);
    p[2] = angle * angle / 12.0;
    p[3] = place * place / 12.0;
}

bool crane_set_tracking(crane *m, char message[MESSAGE])
{
    const double *real = m->base.real;
    double *p = m->tracking, period = real[V_FEEDBACK_SAMPLE_TIME], range[2];
    memset(p, 0, sizeof m->tracking);
    memset(m->tracker, 0, sizeof m->tracker);
    m->count_nodes = 1;
    p[5] = nominal_payload(m);
    if (m->base.integer[V_FEEDBACK_SOURCE] != 2) {
        return true;
    }
    if (!crane_rope_range(m, range, message) || !design_observer(m, range, message)) {
        return false;
    }
    p[0] = driven(m);
    p[1] = period;
    p[2] = real[V_SENSOR_DEAD_TIME] >= 0.5 * period;
    p[3] = real[V_CRANE_BRIDGE_MASS] + real[V_CRANE_TROLLEY_MASS];
    p[4] = real[V_CRANE_TROLLEY_MASS];
    p[6] = real[V_CRANE_GRAVITY];
    for (int i = 0; i < 3; i++) {
        double most = real[V_DRIVE_BRIDGE_LAG + 3 * i + (driven(m) ? 2 : 1)];
        p[15 + i] = most > 0.0 ? most : UNLIMITED;
        p[12 + i] = -p[15 + i];
    }
    p[19] = period / real[V_FEEDBACK_PAYLOAD_TIME];
    p[20] = real[V_FEEDBACK_OBSERVER_WAKE] * real[V_FEEDBACK_OBSERVER_POSITION];
    p[21] = real[V_FEEDBACK_OBSERVER_WAKE] * real[V_FEEDBACK_OBSERVER_LENGTH];
    p[22] = real[V_FEEDBACK_OBSERVER_WAKE] * real[V_FEEDBACK_OBSERVER_ANGLE];
    set_offset(m, range[1]);
    crane_tune_tracking(m, false);
    m->tracker[3 * STATE + 4] = 0.0;
    return true;
}

void crane_tune_tracking(crane *m, bool switched)
{
    const double *real = m->base.real;
    double *p = m->tracking, fade = real[V_FEEDBACK_FADE], before[3];
    memcpy(before, p + 7, sizeof before);
    p[7] = real[V_FEEDBACK_REJECTION_CARRIAGE];
    p[8] = real[V_FEEDBACK_REJECTION_LOAD];
    p[9] = (double)m->base.integer[V_FEEDBACK_ENABLED];
    p[10] = fade;
    p[11] = fade > 0.0 ? exp(-real[V_FEEDBACK_SAMPLE_TIME] / fade) : 0.0;
    p[18] = m->base.integer[V_FEEDBACK_DESIGN] == 2 ? nominal_payload(m)
                                                    : real[V_FEEDBACK_TABLE_PAYLOAD_MASS];
    /* the controller is switched off by itself, without a bump */
    m->loop[2] = 1.0;
    if (switched || memcmp(before, p + 7, sizeof before) != 0) {
        m->tracker[3 * STATE + 4] = 1.0;
    }
}

void crane_show_estimates(crane *m)
{
    double *real = m->base.real;
    real[V_ESTIMATE_PAYLOAD_MASS] = m->tracking[5] * (1.0 + m->tracker[5 * STATE + 3]);
    for (int i = 0; i < 3; i++) {
        real[V_ESTIMATE_DISTURBANCE_BRIDGE + i] = m->tracker[i * STATE + 4];
    }
    for (int i = 0; i < 2; i++) {
        real[V_ESTIMATE_DISTURBANCE_LOAD_X + i] = m->tracker[i * STATE + 5];
    }
    real[V_ESTIMATE_ROPE_OFFSET] = m->tracker[18 * STATE + 5];
}
