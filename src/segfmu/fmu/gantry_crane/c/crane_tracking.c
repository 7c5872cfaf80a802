/* GantryCrane: the feedback from measured signals, as `tracking_from` of feedback_parameters.py. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "say.h"

static const double UNLIMITED = 1e99;

/* Rope lengths and the table of the observer, with a work space of the kernel. */
static bool design_observer(crane *m, const double range[2], char message[MESSAGE])
{
    const double *real = m->base.real;
    enum { COLUMNS = 2 * AXIS_MODEL_SIZE };
    double work[KALMAN_SIZE * COLUMNS], expected[EXPECTED_SIZE], plant[PLANT_SIZE];
    feed_record(&feeds_expected, &m->base, expected);
    expected[EXPECTED_DRIFT] *= real[V_CRANE_GRAVITY];
    expected[EXPECTED_WIND] *= real[V_CRANE_GRAVITY];
    crane_nominal(m, plant);
    m->count_observer = range[1] > range[0] ? MOST_LENGTHS : 1;
    for (int64_t row = 0; row < m->count_observer; row++) {
        segfmu_observer_design(
            vector(plant, PLANT_SIZE), real[V_FEEDBACK_SAMPLE_TIME], crane_node(range, row),
            vector(expected, EXPECTED_SIZE), matrix(work, KALMAN_SIZE, COLUMNS),
            matrix(m->observer + row * OBSERVER_BLOCK, OBSERVER_SIZE, OBSERVER_COLUMNS));
    }
    for (int64_t i = 0; i < m->count_observer * OBSERVER_BLOCK; i++) {
        if (!isfinite(m->observer[i])) {
            return say(message, "the observer has no finite gains between %g and %g m of rope; check "
                       "masses, lags and feedback.observer", range[0], range[1]);
        }
    }
    return true;
}

bool crane_set_tracking(crane *m, char message[MESSAGE])
{
    const double *real = m->base.real;
    double *p = setting(m, SETTINGS_TRACKING), period = real[V_FEEDBACK_SAMPLE_TIME], range[2];
    double uncertainty[UNCERTAINTY_SIZE];
    memset(p, 0, TRACKING_SIZE * sizeof *p);
    memset(m->tracker, 0, sizeof m->tracker);
    m->count_observer = 1;
    p[TRACKING_MASSES + AXES_ROPE] = nominal_payload(m);
    if (m->base.integer[V_FEEDBACK_SOURCE] != 2) {
        return true;
    }
    if (!crane_rope_range(m, range, message) || !design_observer(m, range, message)) {
        return false;
    }
    p[TRACKING_DELAYED] = real[V_SENSOR_DEAD_TIME] >= 0.5 * period;
    p[TRACKING_MASSES + AXES_BRIDGE] = real[V_CRANE_BRIDGE_MASS] + real[V_CRANE_TROLLEY_MASS];
    p[TRACKING_MASSES + AXES_TROLLEY] = real[V_CRANE_TROLLEY_MASS];
    for (int i = 0; i < AXES_SIZE; i++) {
        double most = setting(m, SETTINGS_PLANT)[(driven(m) ? PLANT_ACCELERATION_MAX
                                                            : PLANT_FORCE_MAX) + i];
        p[TRACKING_GREATEST + i] = most > 0.0 ? most : UNLIMITED;
        p[TRACKING_LEAST + i] = -p[TRACKING_GREATEST + i];
    }
    p[TRACKING_PAYLOAD_SHARE] = period / real[V_FEEDBACK_PAYLOAD_TIME];
    feed_record(&feeds_uncertainty, &m->base, uncertainty);
    crane_tune_tracking(m, false);
    segfmu_set_noise(vector(uncertainty, UNCERTAINTY_SIZE), real[V_CRANE_GRAVITY], range[1],
                     vector(p, TRACKING_SIZE));
    tracked(m, TRACKER_COMMAND)[VELOCITY_COMMAND_SWITCHED] = 0.0;
    return true;
}

void crane_tune_tracking(crane *m, bool switched)
{
    const double *real = m->base.real;
    double *p = setting(m, SETTINGS_TRACKING), fade = real[V_FEEDBACK_FADE];
    /* both shares that are rejected, and whether corrections are made */
    double *switches = p + TRACKING_REJECTED_DRIFT;
    double before[TRACKING_ENABLED + 1 - TRACKING_REJECTED_DRIFT];
    memcpy(before, switches, sizeof before);
    feed_record(&feeds_tracking, &m->base, p);
    p[TRACKING_DECAY] = fade > 0.0 ? exp(-real[V_FEEDBACK_SAMPLE_TIME] / fade) : 0.0;
    p[TRACKING_GAINS_PAYLOAD] = m->base.integer[V_FEEDBACK_DESIGN] == 2 ? nominal_payload(m)
                                                    : real[V_FEEDBACK_TABLE_PAYLOAD_MASS];
    /* the controller is switched off by itself, without a bump */
    setting(m, SETTINGS_LOOP)[LOOP_ENABLED] = 1.0;
    if (switched || memcmp(before, switches, sizeof before) != 0) {
        tracked(m, TRACKER_COMMAND)[VELOCITY_COMMAND_SWITCHED] = 1.0;
    }
}
