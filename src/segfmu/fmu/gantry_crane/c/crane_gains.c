/* GantryCrane: the gains of the feedback, from the table or in closed form. */
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "say.h"

/* The table, whose columns are those of one axis each. */
static bool read_table(crane *m, char message[MESSAGE])
{
    static const struct { int first, axis, count, places[4]; } axes[] = {
        {V_FEEDBACK_TABLE_BRIDGE, AXES_BRIDGE, 4,
         {STATE_POSITION, STATE_ANGLE, STATE_VELOCITY, STATE_RATE}},
        {V_FEEDBACK_TABLE_TROLLEY, AXES_TROLLEY, 4,
         {STATE_POSITION + 1, STATE_ANGLE + 1, STATE_VELOCITY + 1, STATE_RATE + 1}},
        {V_FEEDBACK_TABLE_HOIST, AXES_ROPE, 2, {STATE_POSITION + 2, STATE_VELOCITY + 2}}
    };
    const double *real = m->base.real;
    if (m->base.integer[V_FEEDBACK_TABLE_MODE] != m->base.integer[V_DRIVE_MODE]) {
        return say(message, "the gains of feedback.table are for the other drive.mode; set "
                   "feedback.design to flatness, or gains for this mode and feedback.table.mode");
    }
    m->count_lengths = m->base.integer[V_FEEDBACK_TABLE_COUNT];
    memset(m->gains, 0, sizeof m->gains);
    for (int64_t row = 0; row < m->count_lengths; row++) {
        const double *length = &real[V_FEEDBACK_TABLE_LENGTH + row];
        double *block = m->gains + row * GAINS_BLOCK;
        if (row > 0 && !(length[0] > length[-1])) {
            return say(message, "feedback.table[%d].length %g m must be above that of the row "
                       "before, %g m", (int)row + 1, length[0], length[-1]);
        }
        block[GAINS_LENGTH * GAINS_COLUMNS] = length[0];
        for (int a = 0; a < 3; a++) {
            for (int k = 0; k < axes[a].count; k++) {
                block[(GAINS_AXES + axes[a].axis) * GAINS_COLUMNS + axes[a].places[k]] =
                    real[axes[a].first + row * axes[a].count + k];
            }
        }
    }
    return true;
}

/* The closed form over rope lengths in equal ratios. */
static bool design_flat(crane *m, char message[MESSAGE])
{
    double plant[PLANT_SIZE], design[FLAT_DESIGN_SIZE], range[2];
    if (!crane_rope_range(m, range, message)) {
        return false;
    }
    crane_nominal(m, plant);
    feed_record(&feeds_flat_design, &m->base, design);
    m->count_lengths = range[1] > range[0] ? MOST_LENGTHS : 1;
    for (int64_t row = 0; row < m->count_lengths; row++) {
        segfmu_design_flat_gains(
            vector(plant, PLANT_SIZE), vector(design, FLAT_DESIGN_SIZE), crane_node(range, row),
            matrix(m->gains + row * GAINS_BLOCK, GAINS_SIZE, GAINS_COLUMNS));
    }
    return true;
}

/* Whether gains differ; the rope lengths do not count. */
static bool other_gains(const double *before, const double *gains)
{
    const int first = GAINS_AXES * GAINS_COLUMNS;
    for (int row = 0; row < MOST_LENGTHS; row++) {
        int block = row * GAINS_BLOCK + first;
        if (memcmp(before + block, gains + block, (GAINS_BLOCK - first) * sizeof *gains) != 0) {
            return true;
        }
    }
    return false;
}

bool crane_set_gains(crane *m, char message[MESSAGE])
{
    double before[MOST_LENGTHS * GAINS_BLOCK], *loop = setting(m, SETTINGS_LOOP);
    memcpy(before, m->gains, sizeof before);
    m->base.tuned = 0;
    loop[LOOP_ENABLED] = (double)m->base.integer[V_FEEDBACK_ENABLED];
    loop[LOOP_FADE] = m->base.real[V_FEEDBACK_FADE];
    if (!(m->base.integer[V_FEEDBACK_DESIGN] == 2 ? design_flat(m, message)
                                                  : read_table(m, message))) {
        return false;
    }
    bool switched = other_gains(before, m->gains);
    if (loop[LOOP_CORRECTOR] == CORRECTOR_TRACKING) {
        crane_tune_tracking(m, switched);
    } else if (switched && m->rows > 0) {
        double *acted = &row(m, MEMORY_CORRECTION)[CORRECTION_ACTED];
        *acted = *acted == ACTING_NO_TICK ? *acted : ACTING_RETUNED;
    }
    return true;
}
