/* A crane: whether the start fits its reference, and the table of gains, made at the build, the
   crane that is set. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "messages.h"
#include "say.h"

/* Whether two values differ by more than the rounding of numbers as text. */
static bool set_apart(double one, double other)
{
    return fabs(one - other) > 1e-9 * (fabs(one) + fabs(other));
}

static void add_name(char names[MESSAGE], const char *name)
{
    size_t used = strlen(names);
    snprintf(names + used, MESSAGE - used, "%s%s", used > 0 ? ", " : "", name);
}

/* The parameters whose values differ from those for which the table was designed. */
static void find_changed(const crane *m, const double start[], char names[MESSAGE])
{
    static const struct { int place; const char *name; } made_for[] = {
        {V_CRANE_BRIDGE_MASS, "crane.bridge_mass"}, {V_CRANE_TROLLEY_MASS, "crane.trolley_mass"},
        {V_CRANE_GRAVITY, "crane.gravity"}, {V_FEEDBACK_SAMPLE_TIME, "feedback.sample_time"}
    };
    const double *real = m->base.real, *shortest = m->gains + GAINS_ROW_LENGTH;
    const double *longest = shortest + (m->count_lengths - 1) * GAINS_BLOCK;
    names[0] = '\0';
    for (size_t i = 0; i < sizeof made_for / sizeof *made_for; i++) {
        if (set_apart(real[made_for[i].place], start[made_for[i].place])) {
            add_name(names, made_for[i].name);
        }
    }
    if (set_apart(nominal_payload(m), real[V_FEEDBACK_TABLE_PAYLOAD_MASS])) {
        add_name(names, real[V_FEEDBACK_PAYLOAD_MASS] > 0.0 ? "feedback.payload_mass"
                                                            : "crane.payload_mass");
    }
    if (real[V_ROPE_LENGTH] < *shortest || real[V_ROPE_LENGTH] > *longest) {
        add_name(names, "rope.length");
    }
}

/* Whether the gains are unstable with the drives at some rope length. */
static bool crane_unstable(crane *m, char message[MESSAGE])
{
    double work[LOOP_WORK_SIZE * LOOP_WORK_COLUMNS], fault[SETUP_FAULT_SIZE] = {0.0};
    double plant[PLANT_SIZE];
    double ends[2] = {m->gains[GAINS_ROW_LENGTH],
                      m->gains[GAINS_ROW_LENGTH + (m->count_lengths - 1) * GAINS_BLOCK]};
    if (m->base.integer[V_FEEDBACK_ENABLED] == 0) {
        return false;
    }
    crane_nominal(m, plant);
    int64_t status = segfmu_check_gains(
        vector(plant, PLANT_SIZE), m->base.real[V_FEEDBACK_SAMPLE_TIME],
        m->base.integer[V_FEEDBACK_SOURCE] == 2, vector(ends, 2),
        gains_of(m), matrix(work, LOOP_WORK_SIZE, LOOP_WORK_COLUMNS), vector(fault, SETUP_FAULT_SIZE));
    return segfmu_setup_message(status, fault, message, MESSAGE);
}

bool model_warning(const model *base, const double start[], char message[MESSAGE])
{
    char names[MESSAGE] = "";
    if (crane_misfit((const crane *)base, message)) {
        return true;
    }
    /* a table that was set is for the crane of who has set it */
    if (!crane_corrects((const crane *)base) && base->integer[V_FEEDBACK_DESIGN] != 2
        && feed_same(&feeds_gains_row, base, MOST_LENGTHS, start)) {
        find_changed((const crane *)base, start, names);
    }
    if (names[0] == '\0') {
        return (!crane_corrects((const crane *)base) && crane_unstable((crane *)base, message))
            || crane_out_of_range((const crane *)base, message);
    }
    say(message, "the gains of feedback.table, design lqr, were made for other values of %s; set "
        "feedback.design to flatness, or build the FMU with these values", names);
    return true;
}
