/* GantryCrane's block: the arrays of the kernels, and a rig's memory at its end. */
#ifndef SEGFMU_CRANE_H
#define SEGFMU_CRANE_H

#include "arrays.h"
#include "model.h"

enum {
    LOOP = 5, STATE = 10, SETPOINTS = 19, PARAMETERS = 37, SENSORS = 18, COLUMNS = 40, GAINS = 3 * STATE,
    PARTIAL_ROWS = 12, PARTIAL_COLUMNS = 17, TRACKING = 27, BLOCK = 18 * STATE, MEMORY = 22,
    COMPONENTS = 32, CHANGES = 4, MOST_LENGTHS = MODEL_ROWS, MOST_SAMPLES = 100000
};

/* rows of the memory, see kernels/rig/rig.py */
enum {
    ROW_STATE, ROW_PARAMETERS, ROW_CLOCK, ROW_LAST, ROW_REPORT, ROW_SIGNALS, ROW_CORRECTION = 8,
    ROW_SQUARES = 10, ROW_CUBES, ROW_DERIVATIVE = 20, ROW_QUEUE = 30, FIRST_BEND = 10
};

typedef struct {
    model base;
    double loop[LOOP], sensors[SENSORS], parameters[PARAMETERS], setpoints[SETPOINTS];
    double changes[CHANGES * 2], components[COMPONENTS * 7];
    double lengths[MOST_LENGTHS], gains[MOST_LENGTHS * GAINS];
    /* of source measured: the observer's table, and what the controller remembers */
    double tracking[TRACKING], nodes[MOST_LENGTHS], observer[MOST_LENGTHS * BLOCK];
    double tracker[MEMORY * STATE];
    double derivative[MODEL_STATES];
    /* co-simulation: inputs at the end of the last step, and their slopes in it */
    double input[MODEL_INPUTS], slope[MODEL_INPUTS];
    /* by state, commands, wind and time, see kernels/rig/partials.py; of load and energies by state */
    double partials[PARTIAL_ROWS * PARTIAL_COLUMNS], load_partials[6 * STATE];
    double energy_partials[2 * STATE];
    int64_t differentiated;  /* 1: partials are those of the present time, -1: there are none */
    int64_t count_changes, count_components, count_lengths, count_nodes;
    int64_t rows;       /* of the memory; 0: not initialised */
    double memory[];
} crane;

static inline array_double_2d memory_of(crane *m)
{
    return matrix(m->memory, m->rows, COLUMNS);
}

static inline array_double_3d gains_of(crane *m)
{
    return cuboid(m->gains, m->count_lengths, 3, STATE);
}

static inline array_double_3d observer_of(crane *m)
{
    return cuboid(m->observer, m->count_nodes, 18, STATE);
}

static inline double *row(crane *m, int place)
{
    return m->memory + place * COLUMNS;
}

static inline bool driven(const crane *m)
{
    return m->base.integer[V_DRIVE_MODE] == 2;
}

/* kg; of the load that feedback and observer are for */
static inline double nominal_payload(const crane *m)
{
    double payload = m->base.real[V_FEEDBACK_PAYLOAD_MASS];
    return payload > 0.0 ? payload : m->base.real[V_CRANE_PAYLOAD_MASS];
}

/* The least and greatest rope length of the closed form and the observer; false with a message
   where there is none. */
bool crane_rope_range(const crane *m, double range[2], char message[MESSAGE]);

/* A rope length of their tables, in equal ratios. */
double crane_node(const double range[2], int64_t row);

/* The observer and the controller on measured signals, from the start. */
bool crane_set_tracking(crane *m, char message[MESSAGE]);

/* The controller's tunable parameters; `switched` makes what changes fade in. */
void crane_tune_tracking(crane *m, bool switched);

/* The estimates as outputs. */
void crane_show_estimates(crane *m);

/* Turn parameters into the kernels' arrays; false with a message where they do not fit. */
bool crane_set_up(crane *m, char message[MESSAGE]);

/* The gains, from the table or in closed form. */
bool crane_set_gains(crane *m, char message[MESSAGE]);

/* The inputs as setpoints. */
void crane_read_inputs(crane *m);

/* Setpoints up to a time within the step: linear from the inputs at the end of the last step to those
   at its end, or by the derivatives of those at its beginning, where they are given. */
void crane_follow_inputs(crane *m, double time);

/* s since the start, as the rig counts them */
double crane_elapsed(const crane *m);

/* Derivatives of the state at the present time under setpoints; the plant's status. */
int64_t crane_rates(crane *m);

/* Whether accelerations follow from the setpoints: not without lag in velocity mode. */
bool crane_follows(const crane *m);

/* The message of a status of the plant. */
bool crane_failed(crane *m, int64_t status, double time, char message[MESSAGE]);

#endif
