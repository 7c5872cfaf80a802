/* HookCrane: the feedback of measured signals, by the kernels of kernels/hook. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "say.h"

bool crane_corrects(const crane *m)
{
    return m->base.integer[V_FEEDBACK_SOURCE] == 2;
}

bool suspension_sound(const crane *m, bool corrects)
{
    return m->below.count >= (corrects ? 1 : 0) && m->below.count <= HOOK_LENGTHS;
}

static array_double_3d table_of(crane *m)
{
    return cuboid(m->below.table, m->below.count, HOOK_TABLE_SIZE, HOOK_TABLE_COLUMNS);
}

static bool is_finite(const crane *m)
{
    for (int64_t i = 0; i < m->below.count * HOOK_BLOCK; i++) {
        if (!isfinite(m->below.table[i])) {
            return false;
        }
    }
    return true;
}

/* The table over rope lengths; false with a message where there is none. */
static bool design(crane *m, char message[MESSAGE])
{
    enum { COLUMNS = 2 * HOOK_AXIS_CORRECTION };
    double work[HOOK_DESIGN_SIZE * COLUMNS], weights[HOOK_WEIGHING_SIZE], plant[PLANT_SIZE];
    double lengths[HOOK_LENGTHS];
    m->below.count = crane_lengths(m, HOOK_LENGTHS, lengths, message);
    if (m->below.count == 0) {
        return false;
    }
    crane_nominal(m, plant);
    if (m->base.real[V_FEEDBACK_SLING] > 0.0) {
        plant[PLANT_SLING] = m->base.real[V_FEEDBACK_SLING];
    }
    feed_record(&feeds_hook_weighing, &m->base, weights);
    for (int64_t i = 0; i < m->below.count; i++) {
        memset(work, 0, sizeof work);
        segfmu_hook_design(
            vector(plant, PLANT_SIZE), m->base.real[V_FEEDBACK_SAMPLE_TIME], lengths[i],
            vector(weights, HOOK_WEIGHING_SIZE), matrix(work, HOOK_DESIGN_SIZE, COLUMNS),
            matrix(m->below.table + i * HOOK_BLOCK, HOOK_TABLE_SIZE, HOOK_TABLE_COLUMNS));
    }
    return is_finite(m)
        || say(message, "no gains were found for ropes of %g to %g m: masses, sling, lags "
               "or feedback.hook.* do not fit", lengths[0], lengths[m->below.count - 1]);
}

bool crane_set_feedback(crane *m, char message[MESSAGE])
{
    crane_begin_tracking(m);
    m->below.count = 0;
    memset(m->below.estimates, 0, sizeof m->below.estimates);
    if (!crane_corrects(m)) {
        return true;
    }
    if (m->base.interface == MODEL_EXCHANGE && m->base.integer[V_FEEDBACK_ENABLED]) {
        return say(message, "in model exchange feedback.source must be state, or feedback.enabled false: "
                   "the feedback of measured signals with a hook needs co-simulation");
    }
    return design(m, message);
}

/* Velocities that corrections keep; force drives have none. */
static void set_speeds(const crane *m, double limits[HOOK_LIMITS_SIZE])
{
    const double *real = m->base.real;
    const double most[] = {
        real[V_DRIVE_BRIDGE_VELOCITY_MAX], real[V_DRIVE_TROLLEY_VELOCITY_MAX],
        real[V_DRIVE_HOIST_VELOCITY_MAX]
    };
    const double least[] = {
        real[V_DRIVE_BRIDGE_VELOCITY_MIN], real[V_DRIVE_TROLLEY_VELOCITY_MIN],
        real[V_DRIVE_HOIST_VELOCITY_MIN]
    };
    for (int i = 0; i < AXES_SIZE; i++) {
        const double fastest = driven(m) && most[i] > 0.0 ? most[i] : 1e99;
        limits[HOOK_LIMITS_FASTEST + i] = fastest;
        limits[HOOK_LIMITS_SLOWEST + i] = driven(m) && least[i] < 0.0 ? least[i] : -fastest;
    }
    limits[HOOK_LIMITS_PERIOD] = real[V_FEEDBACK_SAMPLE_TIME];
}

void crane_correct(crane *m)
{
    const double *drives = setting(m, SETTINGS_TRACKING);
    double limits[HOOK_LIMITS_SIZE];
    memcpy(limits + HOOK_LIMITS_LEAST, drives + TRACKING_LEAST, AXES_SIZE * sizeof *limits);
    memcpy(limits + HOOK_LIMITS_GREATEST, drives + TRACKING_GREATEST, AXES_SIZE * sizeof *limits);
    set_speeds(m, limits);
    segfmu_hook_correction(
        table_of(m), vector(limits, HOOK_LIMITS_SIZE),
        vector(row(m, MEMORY_SIGNALS), COORDINATES_SIZE),
        vector(row(m, MEMORY_REFERENCE), STATE_SIZE), vector(row(m, MEMORY_ADDED_TO), AXES_SIZE),
        matrix(m->below.estimates, AXES_SIZE + 1, HOOK_AXIS_SIZE),
        vector(row(m, MEMORY_CORRECTION) + CORRECTION_VALUE, AXES_SIZE));
    segfmu_switch_correction(settings_of(m), memory_of(m));
}
