/* A crane: where it starts. */
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "messages.h"

static array_double_1d reference_of(double setpoints[])
{
    return vector(setpoints + SETPOINTS_REFERENCE, STATE_SIZE);
}

/* Start values of the state: where outputs show the state, those that were set before. */
static void read_own(crane *m)
{
    double set[STATE_SIZE];
    feed_record(&feeds_state, &m->base, set);
    for (int i = 0; i < STATE_SIZE; i++) {
        if (!m->placed || set[i] != m->shown[i]) {
            m->own[i] = set[i];
        }
    }
}

/* Start values of the reference. */
static void read_held(const crane *m, double held[SETPOINTS_SIZE])
{
    for (int64_t i = 0; i < feeds_setpoints.count; i++) {
        held[feeds_setpoints.rows[i].place] = m->base.held[feeds_setpoints.rows[i].offset];
    }
}

/* How far the start is from its reference; a reference that nobody gave is none. */
static void judge(crane *m)
{
    m->fit = segfmu_judge_start(vector(m->shown, STATE_SIZE), reference_of(m->setpoints),
                                m->base.real[V_CRANE_GRAVITY],
                                vector(m->misfit, START_FAULT_SIZE));
}

bool crane_place(crane *m, double state[PLANT_STATE_SIZE], char message[MESSAGE])
{
    double held[SETPOINTS_SIZE], fault[START_FAULT_SIZE] = {0.0};
    const array_double_1d reference = reference_of(m->setpoints);
    const array_double_1d report = vector(fault, START_FAULT_SIZE);
    read_own(m);
    read_held(m, held);
    if (m->base.integer[V_START_ON_REFERENCE]) {
        segfmu_start_state(vector(m->own, STATE_SIZE), reference_of(held), reference,
                           vector(state, STATE_SIZE));
    } else {
        memcpy(state, m->own, sizeof m->own);
    }
    int64_t status = segfmu_check_start(vector(state, STATE_SIZE), reference, report);
    if (segfmu_start_message(status, fault, message, MESSAGE) || !crane_hang(m, state, message)) {
        return false;
    }
    show_record(&feeds_state, state, &m->base);
    memcpy(m->shown, state, sizeof m->shown);
    memcpy(m->begun, m->setpoints, sizeof m->begun);
    m->placed = 1;
    m->stepped = 0;
    m->fit = START_STATUS_FITS;
    if (m->base.given) {
        judge(m);
    }
    return true;
}

bool crane_replace(crane *m, char message[MESSAGE])
{
    const model *base = &m->base;
    bool late = !m->stepped && !base->given;
    m->stepped = 1;
    if (!late) {
        return true;
    }
    crane_read_inputs(m);
    if (!segfmu_is_elsewhere(reference_of(m->begun), reference_of(m->setpoints),
                             base->step_end - base->step_start)) {
        return true;
    }
    if (base->integer[V_START_ON_REFERENCE]) {
        return model_initialise(&m->base, message);
    }
    judge(m);
    return true;
}

bool crane_misfit(const crane *m, char message[MESSAGE])
{
    return m->base.integer[V_FEEDBACK_ENABLED]
        && segfmu_start_message(m->fit, m->misfit, message, MESSAGE);
}

bool crane_out_of_range(const crane *m, char message[MESSAGE])
{
    double fault[START_FAULT_SIZE] = {0.0};
    int64_t status = segfmu_check_start_rope(m->shown[STATE_POSITION + AXES_ROPE],
                                             m->base.real[V_CRANE_ROPE_MIN],
                                             m->base.real[V_CRANE_ROPE_MAX],
                                             vector(fault, START_FAULT_SIZE));
    return m->base.given && segfmu_start_message(status, fault, message, MESSAGE);
}
