/* GantryCrane: exact partial derivatives in model exchange, and with them the time derivatives of
   outputs in co-simulation. */
#include <string.h>

#include "crane.h"

enum { WORKS = PLANT_STATE_SIZE - STATE_SIZE };

/* A variable by which is differentiated: a column of the kernel's, a state that is an energy, or a
   component of the load's reference; -1 where it is none. */
typedef struct {
    int column, energy, reference;
} known_place;

static bool at(const variable *v, int first, int count, int *place)
{
    *place = (int)v->offset - first;
    return *place >= 0 && *place < count;
}

static bool find_known(const crane *m, const variable *v, known_place *k)
{
    int place;
    *k = (known_place){-1, -1, -1};
    if (v->kind != KIND_REAL) {
        return false;
    }
    if (at(v, V_BRIDGE_POSITION, STATE_SIZE, &place)) {
        k->column = place;
    } else if (at(v, V_FORCE_BRIDGE, 3, &place)) {
        k->column = driven(m) ? -1 : RIG_VARIABLES_COMMAND + place;
    } else if (at(v, V_VELOCITY_BRIDGE, 3, &place)) {
        k->column = driven(m) ? RIG_VARIABLES_COMMAND + place : -1;
    } else if (at(v, V_WIND_X, 3, &place)) {
        k->column = RIG_VARIABLES_WIND + place;
    } else if (v->offset == V_TIME) {
        k->column = RIG_VARIABLES_TIME;
    } else if (at(v, V_REFERENCE_LOAD_POSITION_X, 3, &place)) {
        k->reference = place;
    } else if (v->offset == V_ENERGY_DRIVES || v->offset == V_ENERGY_WIND
               || v->offset == V_ENERGY_DISSIPATED) {
        k->energy = v->offset == V_ENERGY_DRIVES ? 0 : v->offset == V_ENERGY_WIND ? 1 : 2;
    } else {
        /* references act at the ticks of the controller alone */
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

static double of_norm(const crane *m, const known_place *k)
{
    const double *error = &m->base.real[V_ERROR_LOAD_X];
    double norm = m->base.real[V_ERROR_LOAD_NORM], sum = 0.0;
    for (int i = 0; norm > 0.0 && i < 3; i++) {
        sum += error[i] / norm * of_error(m, i, k);
    }
    return sum;
}

static double of_energy(const crane *m, int offset, const known_place *k)
{
    static const double gained[WORKS] = {1.0, 1.0, -1.0};
    switch (offset) {
    case V_ENERGY_KINETIC: return of_state(m->energy_partials, ENERGIES_KINETIC, k);
    case V_ENERGY_POTENTIAL: return of_state(m->energy_partials, ENERGIES_POTENTIAL, k);
    case V_ENERGY_WORK: return k->energy == 0 || k->energy == 1 ? 1.0 : 0.0;
    case V_ENERGY_DRIVES: return k->energy == 0;
    case V_ENERGY_WIND: return k->energy == 1;
    case V_ENERGY_DISSIPATED: return k->energy == 2;
    case V_ENERGY_IMBALANCE:
        return of_state(m->energy_partials, ENERGIES_KINETIC, k)
            + of_state(m->energy_partials, ENERGIES_POTENTIAL, k)
            - (k->energy < 0 ? 0.0 : gained[k->energy]);
    default: return 0.0;
    }
}

/* A signal follows the state where its sensor is continuous and has no steps. */
static double of_signal(const crane *m, int sensor, const known_place *k)
{
    const double *sensors = setting((crane *)m, SETTINGS_SENSORS);
    bool follows = sensors[SENSORS_SAMPLE_TIME] <= 0.0
        && sensors[SENSORS_RESOLUTION + sensor] <= 0.0;
    return follows && k->column == sensor ? 1.0 : 0.0;
}

static double of_drive(const crane *m, int place, const known_place *k)
{
    const double *real = m->base.real;
    int drive = place / 2;
    double force = of_rig(m, RIG_PARTIALS_FORCE + drive, k);
    if (place % 2 == 0) {
        return force;
    }
    return force * real[V_BRIDGE_VELOCITY + drive]
        + (k->column == STATE_VELOCITY + drive ? real[V_DRIVE_BRIDGE_FORCE + place - 1] : 0.0);
}

/* Of an output or state derivative by one variable; `rig`: it follows from forces. */
static double of_unknown(const crane *m, const variable *unknown, const known_place *k, bool *rig)
{
    int place, offset = unknown->offset;
    *rig = false;
    if (at(unknown, V_BRIDGE_POSITION, STATE_SIZE, &place)) {
        return k->column == place;
    }
    if (at(unknown, V_MEASURED_BRIDGE_POSITION, COORDINATES_SIZE, &place)) {
        return of_signal(m, place, k);
    }
    if (at(unknown, V_LOAD_POSITION_X, LOAD_PARTIALS_SIZE, &place)) {
        return of_state(m->load_partials, place, k);
    }
    if (at(unknown, V_ERROR_LOAD_X, 3, &place)) {
        return of_error(m, place, k);
    }
    if (offset == V_ERROR_LOAD_NORM) {
        return of_norm(m, k);
    }
    *rig = true;
    if (at(unknown, V_BRIDGE_ACCELERATION, COORDINATES_SIZE, &place)) {
        return of_rig(m, place, k);
    }
    if (at(unknown, V_DRIVE_BRIDGE_FORCE, 6, &place)) {
        return of_drive(m, place, k);
    }
    if (offset == V_ROPE_FORCE) {
        return of_rig(m, RIG_PARTIALS_ROPE_FORCE, k);
    }
    if (offset == V_POWER_DRIVES || offset == V_POWER_WIND || offset == V_POWER_FRICTION) {
        return of_rig(m, offset == V_POWER_DRIVES ? RIG_PARTIALS_DRIVE_POWER
                      : offset == V_POWER_WIND ? RIG_PARTIALS_WIND_POWER
                      : RIG_PARTIALS_FRICTION_POWER, k);
    }
    *rig = false;
    return of_energy(m, offset, k);
}

bool model_partial(model *base, const variable *unknown, const variable *known, double *value)
{
    crane *m = (crane *)base;
    known_place k;
    bool rig;
    if (base->interface != MODEL_EXCHANGE || unknown->kind != KIND_REAL || !unknown->calculated
        || !find_known(m, known, &k) || !differentiate(m)) {
        return false;
    }
    *value = of_unknown(m, unknown, &k, &rig);
    return true;
}

/* Make the kernel's work space that of the present time; the step's report stays. */
static void settle(crane *m)
{
    double report[REPORT_SIZE], *now = row(m, MEMORY_REPORT);
    if (m->differentiated != 0 || !crane_follows(m)) {
        return;
    }
    memcpy(report, now, sizeof report);
    memcpy(m->setpoints, m->input, SETPOINTS_WIND * sizeof *m->setpoints);
    /* corrections are in the velocities already */
    row(m, MEMORY_CLOCK)[CLOCK_LAST_TICK] = crane_elapsed(m);
    crane_rates(m);
    memcpy(now, report, sizeof report);
}

bool model_output_derivative(model *base, const variable *output, int64_t order, double *value)
{
    crane *m = (crane *)base;
    bool rig, smooth;
    if (base->interface == MODEL_EXCHANGE || order != 1) {
        return false;
    }
    settle(m);
    smooth = differentiate(m) && crane_follows(m);
    const double *commands = m->slope
        + (driven(m) ? V_VELOCITY_BRIDGE : V_FORCE_BRIDGE);
    known_place k = {-1, -1, -1};
    *value = of_unknown(m, output, &k, &rig);
    if (rig && !smooth) {
        return false;
    }
    double sum = 0.0;
    for (k.column = 0; k.column < STATE_SIZE; k.column++) {
        sum += of_unknown(m, output, &k, &rig) * m->derivative[k.column];
    }
    for (k.column = RIG_VARIABLES_COMMAND; k.column < RIG_VARIABLES_WIND; k.column++) {
        sum += of_unknown(m, output, &k, &rig) * commands[k.column - RIG_VARIABLES_COMMAND];
    }
    k.column = RIG_VARIABLES_TIME;
    sum += of_unknown(m, output, &k, &rig);
    k.column = -1;
    for (k.energy = 0; k.energy < WORKS; k.energy++) {
        sum += of_unknown(m, output, &k, &rig) * m->derivative[STATE_SIZE + k.energy];
    }
    k.energy = -1;
    for (k.reference = 0; k.reference < 3; k.reference++) {
        sum += of_unknown(m, output, &k, &rig)
            * m->slope[V_REFERENCE_LOAD_POSITION_X + k.reference];
    }
    *value = sum;
    return true;
}
