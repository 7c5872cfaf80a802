/* A crane: the feedback from measured signals, by the kernels of kernels/control. */
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "messages.h"
#include "say.h"

/* Rope lengths and the table of the observer, with work spaces of the kernel; the greatest length, or
   0 with a message. */
static double design_observer(crane *m, double uncertainty[], char message[MESSAGE])
{
    enum { COLUMNS = 2 * AXIS_MODEL_SIZE };
    double work[KALMAN_SIZE * COLUMNS], expected[EXPECTED_SIZE], plant[PLANT_SIZE];
    double lengths[MOST_LENGTHS], fault[SETUP_FAULT_SIZE] = {0.0};
    int64_t count = crane_lengths(m, MOST_LENGTHS, lengths, message);
    if (count == 0) {
        return 0.0;
    }
    m->count_observer = count;
    crane_nominal(m, plant);
    segfmu_set_steps(vector(setting(m, SETTINGS_SENSORS), SENSORS_SIZE), lengths[count - 1],
                     vector(uncertainty, UNCERTAINTY_SIZE));
    segfmu_set_walks(vector(plant, PLANT_SIZE), vector(uncertainty, UNCERTAINTY_SIZE));
    if (!segfmu_observer_table(
            vector(plant, PLANT_SIZE), m->base.real[V_FEEDBACK_SAMPLE_TIME],
            vector(uncertainty, UNCERTAINTY_SIZE), count, vector(lengths, MOST_LENGTHS),
            vector(expected, EXPECTED_SIZE), matrix(work, KALMAN_SIZE, COLUMNS), observer_of(m))) {
        fault[SETUP_FAULT_VALUE] = lengths[0];
        fault[SETUP_FAULT_BOUND] = lengths[count - 1];
        segfmu_setup_message(SETUP_STATUS_OBSERVER, fault, message, MESSAGE);
        return 0.0;
    }
    return lengths[count - 1];
}

void crane_begin_tracking(crane *m)
{
    double *p = setting(m, SETTINGS_TRACKING), plant[PLANT_SIZE];
    memset(p, 0, TRACKING_SIZE * sizeof *p);
    memset(m->tracker, 0, sizeof m->tracker);
    m->count_observer = 1;
    crane_nominal(m, plant);
    p[TRACKING_PERIOD] = m->base.real[V_FEEDBACK_SAMPLE_TIME];
    segfmu_set_drives(vector(plant, PLANT_SIZE), vector(p, TRACKING_SIZE));
}

bool crane_set_tracking(crane *m, char message[MESSAGE])
{
    double *p = setting(m, SETTINGS_TRACKING), design[TRACKING_DESIGN_SIZE], plant[PLANT_SIZE];
    crane_begin_tracking(m);
    crane_nominal(m, plant);
    if (m->base.integer[V_FEEDBACK_SOURCE] != 2) {
        return true;
    }
    feed_record(&feeds_tracking_design, &m->base, design);
    double longest = design_observer(m, design, message);
    if (longest == 0.0) {
        return false;
    }
    crane_tune_tracking(m, false);
    double age = segfmu_signal_age(design[TRACKING_DESIGN_DEAD_TIME],
                                   design[TRACKING_DESIGN_SAMPLING], p[TRACKING_PERIOD]);
    for (int i = 0; i < AXES_SIZE; i++) {
        if (age + plant[PLANT_DEAD_TIME + i] > (HISTORY_MOST - 3) * p[TRACKING_PERIOD]) {
            return say(message, "signals and drives are %g s late; a controller remembers %d samples: "
                       "raise feedback.sample_time of %g s", age + plant[PLANT_DEAD_TIME + i],
                       HISTORY_MOST - 3, p[TRACKING_PERIOD]);
        }
    }
    segfmu_set_tracking(vector(plant, PLANT_SIZE), vector(design, TRACKING_DESIGN_SIZE), longest,
                        vector(p, TRACKING_SIZE));
    tracked(m, TRACKER_COMMAND)[VELOCITY_COMMAND_SWITCHED] = 0.0;
    return true;
}

void crane_tune_tracking(crane *m, bool switched)
{
    const double *real = m->base.real;
    double *p = setting(m, SETTINGS_TRACKING);
    /* both shares that are rejected, and whether corrections are made */
    double *switches = p + TRACKING_REJECTED_DRIFT;
    double before[TRACKING_ENABLED + 1 - TRACKING_REJECTED_DRIFT];
    memcpy(before, switches, sizeof before);
    feed_record(&feeds_tracking, &m->base, p);
    segfmu_set_fading(vector(p, TRACKING_SIZE));
    p[TRACKING_GAINS_PAYLOAD] = m->base.integer[V_FEEDBACK_DESIGN] == 2 ? nominal_payload(m)
                                                    : real[V_FEEDBACK_TABLE_PAYLOAD_MASS];
    /* the controller is switched off by itself, without a bump */
    setting(m, SETTINGS_LOOP)[LOOP_ENABLED] = 1.0;
    if (switched || memcmp(before, switches, sizeof before) != 0) {
        tracked(m, TRACKER_COMMAND)[VELOCITY_COMMAND_SWITCHED] = 1.0;
    }
}
