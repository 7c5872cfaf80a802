/* GantryCrane: exact partial derivatives in model exchange, and with them the time derivatives of
   outputs in co-simulation; outputs that are not listed here have differences. */
#include <string.h>

#include "crane.h"
#include "feeds.h"

enum { WORKS = PLANT_STATE_SLACK - PLANT_STATE_DRIVE_WORK };

/* A variable by which is differentiated: a column of the kernel's, a state that is an energy, or a
   component of the load's reference; -1 where it is none. */
typedef struct {
    int column, energy, reference;
} known_place;

/* Whether an index is in a range of a record, and its position there. */
static bool among(int place, int first, int count, int *which)
{
    *which = place - first;
    return *which >= 0 && *which < count;
}

static bool find_known(const crane *m, const variable *v, known_place *k)
{
    *k = (known_place){-1, -1, -1};
    if (v->kind != KIND_REAL) {
        return false;
    }
    int which, state = feed_place(&feeds_state, v->offset);
    int setpoint = feed_place(&feeds_setpoints, v->offset);
    int output = feed_place(&feeds_outputs, v->offset);
    k->reference = feed_place(&feeds_target, v->offset);
    if (state >= 0) {
        k->column = state;
    } else if (among(setpoint, SETPOINTS_FORCE, AXES_SIZE, &which)) {
        k->column = driven(m) ? -1 : RIG_VARIABLES_COMMAND + which;
    } else if (among(setpoint, SETPOINTS_VELOCITY, AXES_SIZE, &which)) {
        k->column = driven(m) ? RIG_VARIABLES_COMMAND + which : -1;
    } else if (among(setpoint, SETPOINTS_WIND, VECTOR_SIZE, &which)) {
        k->column = RIG_VARIABLES_WIND + which;
    } else if (among(output, OUTPUTS_DEFLECTION, AXES_SIZE, &which)) {
        k->column = RIG_VARIABLES_DEFLECTION + which;
    } else if (v->offset == V_TIME) {
        k->column = RIG_VARIABLES_TIME;
    } else if (output == OUTPUTS_DRIVE_WORK || output == OUTPUTS_WIND_WORK
               || output == OUTPUTS_DISSIPATED) {
        k->energy = output == OUTPUTS_DRIVE_WORK ? 0 : output == OUTPUTS_WIND_WORK ? 1 : 2;
    } else {
        /* references act only at the ticks of the controller */
        return v->setting == SET_INPUT;
    }
    return true;
}

static bool differentiate(crane *m)
{
    double work[LOAD_PARTIALS_SIZE * CRANE_PARTIALS_SIZE];
    if (m->differentiated == 0) {
        array_double_1d state = vector(row(m, MEMORY_STATE), STATE_SIZE);
        m->differentiated = segfmu_rig_partials(
            components_of(m), crane_elapsed(m), memory_of(m),
            matrix(work, LOAD_PARTIALS_SIZE, CRANE_PARTIALS_SIZE),
            matrix(m->partials, RIG_PARTIALS_SIZE, RIG_VARIABLES_SIZE)) ? 1 : -1;
        segfmu_crane_load_partials(state, matrix(m->load_partials, LOAD_PARTIALS_SIZE, STATE_SIZE));
        segfmu_crane_energy_partials(state, vector(row(m, MEMORY_PLANT), MASSES_SIZE),
                                     matrix(m->energy_partials, ENERGIES_SIZE, STATE_SIZE));
    }
    return m->differentiated > 0;
}

/* Of a result of the kernel: a row of its matrix. */
static double of_rig(const crane *m, int row, const known_place *k)
{
    return k->column < 0 ? 0.0 : m->partials[row * RIG_VARIABLES_SIZE + k->column];
}

/* Of the load's position and velocity, or of kinetic and potential energy. */
static double of_state(const double *partials, int row, const known_place *k)
{
    return k->column < 0 || k->column >= STATE_SIZE ? 0.0 : partials[row * STATE_SIZE + k->column];
}

static double of_error(const crane *m, int axis, const known_place *k)
{
    return of_state(m->load_partials, axis, k) - (k->reference == axis ? 1.0 : 0.0);
}

static double of_velocity(const crane *m, int axis, const known_place *k)
{
    return of_state(m->load_partials, LOAD_PARTIALS_VELOCITY + axis, k);
}

/* Of an output that is the norm of the three from `first` on. */
static double of_norm(const crane *m, int output, int first,
                      double (*of_part)(const crane *, int, const known_place *),
                      const known_place *k)
{
    const double *real = m->base.real;
    double norm = real[feed_offset(&feeds_outputs, output)], sum = 0.0;
    for (int i = 0; norm > 0.0 && i < VECTOR_SIZE; i++) {
        sum += real[feed_offset(&feeds_outputs, first + i)] / norm * of_part(m, i, k);
    }
    return sum;
}

/* Of an output that is an energy, or changes at events alone; false where it is neither. */
static bool of_energy(const crane *m, int output, const known_place *k, double *value)
{
    static const double gained[WORKS] = {1.0, 1.0, -1.0};
    const double kinetic = of_state(m->energy_partials, ENERGIES_KINETIC, k);
    const double potential = of_state(m->energy_partials, ENERGIES_POTENTIAL, k);
    switch (output) {
    case OUTPUTS_KINETIC: *value = kinetic; return true;
    case OUTPUTS_POTENTIAL: *value = potential; return true;
    case OUTPUTS_WORK: *value = k->energy == 0 || k->energy == 1; return true;
    case OUTPUTS_DRIVE_WORK: *value = k->energy == 0; return true;
    case OUTPUTS_WIND_WORK: *value = k->energy == 1; return true;
    case OUTPUTS_DISSIPATED: *value = k->energy == 2; return true;
    case OUTPUTS_IMBALANCE:
        *value = kinetic + potential - (k->energy < 0 ? 0.0 : gained[k->energy]);
        return true;
    case OUTPUTS_PAYLOAD:
    case OUTPUTS_PAYLOAD_MASS: *value = 0.0; return true;
    default: return false;
    }
}

/* A signal follows the state where its sensor is continuous and has no steps. */
static double of_signal(const crane *m, int sensor, const known_place *k)
{
    const double *sensors = setting((crane *)m, SETTINGS_SENSORS);
    return k->column == sensor && sensors[SENSORS_SAMPLE_TIME] <= 0.0
        && sensors[SENSORS_RESOLUTION + sensor] <= 0.0;
}

static double of_power(const crane *m, int drive, const known_place *k)
{
    const double *real = m->base.real;
    double velocity = real[feed_offset(&feeds_state, STATE_VELOCITY + drive)];
    double force = real[feed_offset(&feeds_outputs, OUTPUTS_FORCE + drive)];
    return of_rig(m, RIG_PARTIALS_FORCE + drive, k) * velocity
        + (k->column == STATE_VELOCITY + drive ? force : 0.0);
}

/* Of an output that follows from forces; false where it does not. */
static bool of_forces(const crane *m, const variable *unknown, int output, const known_place *k,
                      double *value)
{
    int which, acceleration = feed_place(&feeds_accelerations, unknown->offset);
    if (among(acceleration, ACCELERATIONS_DEFLECTION, AXES_SIZE, &which)) {
        *value = of_rig(m, RIG_PARTIALS_DEFLECTION + which, k);
    } else if (acceleration >= 0) {
        *value = of_rig(m, RIG_PARTIALS_ACCELERATION + acceleration, k);
    } else if (among(output, OUTPUTS_FORCE, AXES_SIZE, &which)) {
        *value = of_rig(m, RIG_PARTIALS_FORCE + which, k);
    } else if (among(output, OUTPUTS_POWER, AXES_SIZE, &which)) {
        *value = of_power(m, which, k);
    } else if (output == OUTPUTS_ROPE_FORCE) {
        *value = of_rig(m, RIG_PARTIALS_ROPE_FORCE, k);
    } else if (output == OUTPUTS_WIND_POWER) {
        *value = of_rig(m, RIG_PARTIALS_WIND_POWER, k);
    } else if (output == OUTPUTS_FRICTION_POWER) {
        *value = of_rig(m, RIG_PARTIALS_FRICTION_POWER, k);
    } else if (unknown->offset == V_POWER_DRIVES) {
        *value = of_rig(m, RIG_PARTIALS_DRIVE_POWER, k);
    } else {
        return false;
    }
    return true;
}

/* Of an output that follows from the state; false where it does not. */
static bool of_place(const crane *m, int output, const known_place *k, double *value)
{
    int which;
    if (among(output, OUTPUTS_STATE, STATE_SIZE, &which)) {
        *value = k->column == which;
    } else if (among(output, OUTPUTS_DEFLECTION, AXES_SIZE, &which)) {
        *value = k->column == RIG_VARIABLES_DEFLECTION + which;
    } else if (among(output, OUTPUTS_MEASURED, COORDINATES_SIZE, &which)) {
        *value = of_signal(m, which, k);
    } else if (among(output, OUTPUTS_LOAD_POSITION, VECTOR_SIZE, &which)) {
        *value = of_state(m->load_partials, LOAD_PARTIALS_POSITION + which, k);
    } else if (among(output, OUTPUTS_LOAD_VELOCITY, VECTOR_SIZE, &which)) {
        *value = of_velocity(m, which, k);
    } else if (among(output, OUTPUTS_ERROR, VECTOR_SIZE, &which)) {
        *value = of_error(m, which, k);
    } else if (output == OUTPUTS_ERROR_NORM) {
        *value = of_norm(m, output, OUTPUTS_ERROR, of_error, k);
    } else if (output == OUTPUTS_LOAD_SPEED) {
        *value = of_norm(m, output, OUTPUTS_LOAD_VELOCITY, of_velocity, k);
    } else {
        return false;
    }
    return true;
}

/* Of an output or state derivative by one variable; `rig`: it may follow from forces. False for a
   continuous output that is not of the record. */
static bool of_unknown(const crane *m, const variable *unknown, const known_place *k, bool *rig,
                       double *value)
{
    int output = feed_place(&feeds_outputs, unknown->offset);
    *value = 0.0;
    *rig = of_forces(m, unknown, output, k, value);
    if (*rig || of_place(m, output, k, value) || of_energy(m, output, k, value)
        || !unknown->differentiable) {
        return true;
    }
    *rig = output >= 0;
    if (*rig) {
        *value = crane_difference((crane *)m, output, k->column, k->energy, k->reference);
    }
    return *rig;
}

bool model_partial(model *base, const variable *unknown, const variable *known, double *value)
{
    crane *m = (crane *)base;
    known_place k;
    bool rig;
    return base->interface == MODEL_EXCHANGE && unknown->kind == KIND_REAL && unknown->calculated
        && find_known(m, known, &k) && differentiate(m) && of_unknown(m, unknown, &k, &rig, value);
}

/* Make the kernel's work space that of the present time; the step's report stays. */
static void to_present(crane *m)
{
    double report[REPORT_SIZE], *now = row(m, MEMORY_REPORT);
    if (m->differentiated != 0 || !crane_follows(m)) {
        return;
    }
    memcpy(report, now, sizeof report);
    for (int place = 0; place < SETPOINTS_SIZE; place++) {
        m->setpoints[place] = m->input[feed_offset(&feeds_setpoints, place)];
    }
    /* corrections are in the velocities already */
    row(m, MEMORY_CLOCK)[CLOCK_LAST_TICK] = crane_elapsed(m);
    crane_rates(m);
    memcpy(now, report, sizeof report);
}

/* The partial derivative of an output that has one. */
static double partial_of(const crane *m, const variable *output, const known_place *k)
{
    bool rig;
    double value;
    of_unknown(m, output, k, &rig, &value);
    return value;
}

/* What the slopes of three setpoints from a place on bring, by the columns from another one on. */
static double by_slopes(const crane *m, const variable *output, int column, int place)
{
    known_place k = {-1, -1, -1};
    double sum = 0.0;
    for (int i = 0; i < AXES_SIZE; i++) {
        k.column = column + i;
        sum += partial_of(m, output, &k) * m->slope[feed_offset(&feeds_setpoints, place + i)];
    }
    return sum;
}

bool model_output_derivative(model *base, const variable *output, int64_t order, double *value)
{
    crane *m = (crane *)base;
    bool rig;
    if (base->interface == MODEL_EXCHANGE || order != 1) {
        return false;
    }
    to_present(m);
    const bool smooth = differentiate(m) && crane_follows(m);
    known_place k = {-1, -1, -1};
    if (!of_unknown(m, output, &k, &rig, value) || (rig && !smooth)) {
        return false;
    }
    const int commands = driven(m) ? SETPOINTS_VELOCITY : SETPOINTS_FORCE;
    double sum = by_slopes(m, output, RIG_VARIABLES_COMMAND, commands)
        + by_slopes(m, output, RIG_VARIABLES_WIND, SETPOINTS_WIND);
    for (k.column = 0; k.column < STATE_SIZE; k.column++) {
        sum += partial_of(m, output, &k) * m->derivative[k.column];
    }
    for (int i = 0; i < AXES_SIZE; i++) {
        k.column = RIG_VARIABLES_DEFLECTION + i;
        sum += partial_of(m, output, &k) * m->derivative[PLANT_STATE_DEFLECTION + i];
    }
    k.column = RIG_VARIABLES_TIME;
    sum += partial_of(m, output, &k);
    k.column = -1;
    for (k.energy = 0; k.energy < WORKS; k.energy++) {
        sum += partial_of(m, output, &k) * m->derivative[PLANT_STATE_DRIVE_WORK + k.energy];
    }
    k.energy = -1;
    for (k.reference = 0; k.reference < VECTOR_SIZE; k.reference++) {
        sum += partial_of(m, output, &k) * m->slope[feed_offset(&feeds_target, TARGET_LOAD + k.reference)];
    }
    *value = sum;
    return true;
}
