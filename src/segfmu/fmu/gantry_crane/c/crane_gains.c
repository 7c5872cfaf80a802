/* GantryCrane: the gains of the feedback, from the table or in closed form. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "say.h"

/* what the kernel's memory says of the tick before where the gains were others, see kernels/rig/rig.py */
static const double RETUNED = 3.0;

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
