/* A crane's block: the arrays of the kernels, and a rig's memory at its end. */
#ifndef SEGFMU_CRANE_H
#define SEGFMU_CRANE_H

#include "arrays.h"
#include "model.h"
#include "records.h"
#include "suspension.h"

/* numbers of rows that there is room for, and sizes of the tables' parts for a rope length */
enum {
    COMPONENTS = 2 * DISTURBANCE_COMPONENTS, CHANGES = DISTURBANCE_MOST_CHANGES, MOST_LENGTHS = MODEL_ROWS,
    GAINS_BLOCK = GAINS_SIZE * GAINS_COLUMNS, OBSERVER_BLOCK = OBSERVER_SIZE * OBSERVER_COLUMNS
};

typedef struct {
    model base;
    double settings[SETTINGS_SIZE * SETTINGS_COLUMNS], setpoints[SETPOINTS_SIZE];
    double changes[CHANGES * PAYLOAD_CHANGE_SIZE], components[COMPONENTS * SINUSOID_SIZE];
    double gains[MOST_LENGTHS * GAINS_BLOCK];
    /* of source measured: the observer's table, and what the controller remembers */
    double observer[MOST_LENGTHS * OBSERVER_BLOCK];
    double tracker[TRACKER_SIZE * TRACKER_COLUMNS];
    double derivative[PLANT_STATE_SIZE];
    /* of the start: start values of the state, the state that follows from them, the setpoints, and
       how far it is from its reference */
    double own[STATE_SIZE], shown[STATE_SIZE], begun[SETPOINTS_SIZE], misfit[START_FAULT_SIZE];
    suspension below;  /* what the model remembers of what is between rope and load */
    int64_t placed, stepped, fit;
    /* co-simulation: inputs at the end of the last step, and their slopes in it */
    double input[MODEL_INPUTS], slope[MODEL_INPUTS];
    /* by state, commands, wind and time, see kernels/rig/partials.py; of load and energies by state */
    double partials[RIG_PARTIALS_SIZE * RIG_VARIABLES_SIZE];
    double load_partials[LOAD_PARTIALS_SIZE * STATE_SIZE], energy_partials[ENERGIES_SIZE * STATE_SIZE];
    int64_t differentiated;  /* 1: partials are those of the present time, -1: there are none */
    int64_t count_changes, count_components, count_lengths, count_observer;
    int64_t rows;       /* of the memory; 0: not initialised */
    double memory[];
} crane;

static inline array_double_2d memory_of(crane *m)
{
    return matrix(m->memory, m->rows, MEMORY_COLUMNS);
}

static inline array_double_2d settings_of(crane *m)
{
    return matrix(m->settings, SETTINGS_SIZE, SETTINGS_COLUMNS);
}

static inline array_double_2d components_of(crane *m)
{
    return matrix(m->components, m->count_components, SINUSOID_SIZE);
}

static inline array_double_2d changes_of(crane *m)
{
    return matrix(m->changes, m->count_changes, PAYLOAD_CHANGE_SIZE);
}

static inline array_double_2d tracker_of(crane *m)
{
    return matrix(m->tracker, TRACKER_SIZE, TRACKER_COLUMNS);
}

static inline array_double_3d gains_of(crane *m)
{
    return cuboid(m->gains, m->count_lengths, GAINS_SIZE, GAINS_COLUMNS);
}

static inline array_double_3d observer_of(crane *m)
{
    return cuboid(m->observer, m->count_observer, OBSERVER_SIZE, OBSERVER_COLUMNS);
}

static inline double *row(crane *m, int place)
{
    return m->memory + place * MEMORY_COLUMNS;
}

/* A row of the settings. */
static inline double *setting(crane *m, int place)
{
    return m->settings + place * SETTINGS_COLUMNS;
}

static inline double *tracked(crane *m, int place)
{
    return m->tracker + place * TRACKER_COLUMNS;
}

static inline bool driven(const crane *m)
{
    return m->base.integer[V_DRIVE_MODE] == 2;
}

/* kg; of the load that feedback and observer are for */
static inline double nominal_payload(const crane *m)
{
    const double *real = m->base.real;
    return segfmu_nominal_payload(real[V_FEEDBACK_PAYLOAD_MASS], real[V_CRANE_PAYLOAD_MASS]);
}

/* At most so many rope lengths of the closed form and the observers, and how many; 0 with a message where
   they do not fit. */
static int64_t crane_lengths(const crane *m, int64_t most, double lengths[], char message[MESSAGE]);

/* The `Plant` with the load that feedback and observer are for. */
static void crane_nominal(crane *m, double plant[PLANT_SIZE]);

/* What every feedback knows of the drives; then the observer and the controller on measured signals, from
   the start. */
static void crane_begin_tracking(crane *m);
static bool crane_set_tracking(crane *m, char message[MESSAGE]);

/* Feedback of measured signals, in suspension.c of each model: who corrects, from the start, and a
   correction that is due by a controller of the model. */
static bool crane_corrects(const crane *m);
static bool crane_set_feedback(crane *m, char message[MESSAGE]);
static void crane_correct(crane *m);

/* Whether what the model remembers can be, with a table of its controller if that corrects. */
static bool suspension_sound(const crane *m, bool corrects);

/* The controller's tunable parameters; `switched` makes what changes fade in. */
static void crane_tune_tracking(crane *m, bool switched);

/* Turn parameters into the kernels' arrays; false with a message where they do not fit. */
static bool crane_set_up(crane *m, char message[MESSAGE]);

/* The gains, from the table or in closed form. */
static bool crane_set_gains(crane *m, char message[MESSAGE]);

/* Find the state at the start; false with a message where there is none. */
static bool crane_place(crane *m, double state[PLANT_STATE_SIZE], char message[MESSAGE]);

/* What hangs on the rope, in suspension.c of each model: its part of the `Plant`, of the state at the
   start, which may not fit, and of the outputs. */
static void crane_read_suspension(const model *base, double plant[PLANT_SIZE]);
static bool crane_hang(crane *m, double state[PLANT_STATE_SIZE], char message[MESSAGE]);
static void crane_show_suspension(crane *m);

/* Before a step: start again where the reference was not given at initialisation, but is now. */
static bool crane_replace(crane *m, char message[MESSAGE]);

/* Whether the state at the start is far from a reference that was given, or its rope outside its
   range, with a message. */
static bool crane_misfit(const crane *m, char message[MESSAGE]);
static bool crane_out_of_range(const crane *m, char message[MESSAGE]);

/* The inputs as setpoints. */
static void crane_read_inputs(crane *m);

/* Setpoints up to a time within the step: linear from the inputs at the end of the last step to those
   at its end, or by the derivatives of those at its beginning, where they are given. */
static void crane_follow_inputs(crane *m, double time);

/* s since the start, as the rig counts them */
static double crane_elapsed(const crane *m);

/* Derivatives of the state at the present time under setpoints; the plant's status. */
static int64_t crane_rates(crane *m);

/* Whether accelerations follow from the setpoints of the present: not without lag in velocity mode,
   nor with a dead time. */
static bool crane_follows(const crane *m);

/* The message of a status of the plant. */
static bool crane_failed(crane *m, int64_t status, double time, char message[MESSAGE]);

/* The reference of the load's position that is set, as the outputs take it. */
static void crane_read_target(crane *m, double target[TARGET_SIZE]);

/* Partial derivative of an output of the record by a column of RIG_VARIABLES, by an energy of the state
   or by a component of the reference; -1 for the others of these. */
static double crane_difference(crane *m, int output, int column, int energy, int reference);

#endif
