/* A crane: the gains of the feedback, from the table or in closed form. */
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "say.h"

/* The table. */
static bool read_table(crane *m, char message[MESSAGE])
{
    if (m->base.integer[V_FEEDBACK_TABLE_MODE] != m->base.integer[V_DRIVE_MODE]) {
        return say(message, "the gains of feedback.table are for the other drive.mode; set "
                   "feedback.design to flatness, or gains for this mode and feedback.table.mode");
    }
    m->count_lengths = m->base.integer[V_FEEDBACK_TABLE_COUNT];
    memset(m->gains, 0, sizeof m->gains);
    for (int64_t row = 0; row < m->count_lengths; row++) {
        double *block = m->gains + row * GAINS_BLOCK;
        feed_row(&feeds_gains_row, &m->base, row, block);
        if (row > 0 && !(block[GAINS_ROW_LENGTH] > block[GAINS_ROW_LENGTH - GAINS_BLOCK])) {
            return say(message, "feedback.table[%d].length %g m must be above that of the row "
                       "before, %g m", (int)row + 1, block[GAINS_ROW_LENGTH],
                       block[GAINS_ROW_LENGTH - GAINS_BLOCK]);
        }
    }
    return true;
}

/* The closed form over rope lengths in equal ratios. */
static bool design_flat(crane *m, char message[MESSAGE])
{
    double plant[PLANT_SIZE], design[FLAT_DESIGN_SIZE], lengths[MOST_LENGTHS];
    int64_t count = crane_lengths(m, MOST_LENGTHS, lengths, message);
    if (count == 0) {
        return false;
    }
    crane_nominal(m, plant);
    feed_record(&feeds_flat_design, &m->base, design);
    m->count_lengths = count;
    segfmu_flat_table(vector(plant, PLANT_SIZE), vector(design, FLAT_DESIGN_SIZE), count,
                      vector(lengths, MOST_LENGTHS), gains_of(m));
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
    if (loop[LOOP_CORRECTOR] == CORRECTOR_CALLER) {
        /* that of the model has no gains here */
        memset(m->gains, 0, sizeof m->gains);
        m->count_lengths = 1;
        return true;
    }
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
