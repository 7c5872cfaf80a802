/* GantryCrane: the crane with its drives, sensors and sampled feedback. In co-simulation the kernel
   rig_step goes from event to event by itself; in model exchange the importer integrates. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "say.h"

enum { EXCHANGE = 0, ENERGIES = 7 };

/* s by which an event may be met late: importers with fixed steps cannot do better */
static const double LATEST_EVENT = 1.0;

/* periods by which the next tick or sample can be away from the present */
static const double MOST_LATE = 2.0;

/* the states in the order of the description: the crane's and its energies */
const double model_nominals[MODEL_STATES + 1] = {
    1.0, 1.0, 1.0, 0.1, 0.1, 1.0, 1.0, 1.0, 0.1, 0.1, 10.0, 10.0, 10.0, 0.0
};

/* Bytes of a block for sensors with these times; dead times that are refused need no room. */
static size_t size_for(double sample_time, double dead_time)
{
    bool sampled = sample_time > 0.0 && dead_time >= 0.0 && dead_time <= MOST_SAMPLES * sample_time;
    int64_t rows = sampled ? segfmu_rig_rows(sample_time, dead_time) : segfmu_rig_rows(0.0, 0.0);
    return sizeof(crane) + (size_t)rows * COLUMNS * sizeof(double);
}

size_t model_least(void)
{
    return size_for(0.0, 0.0);
}

size_t model_size(const model *base)
{
    return size_for(base->real[V_SENSOR_SAMPLE_TIME], base->real[V_SENSOR_DEAD_TIME]);
}

size_t model_used(const model *base)
{
    const crane *m = (const crane *)base;
    return m->rows == 0 ? model_least() : sizeof(crane) + (size_t)m->rows * COLUMNS * sizeof(double);
}

/* A whole number from 0 to below a bound, as the kernels keep it. */
static bool counts(double value, double bound)
{
    return value >= 0.0 && value < bound && value == floor(value);
}

/* Whether the times of the next tick and sample are near the present; the loops go from one to the
   next. */
static bool near(double due, double now, double period)
{
    return period > 0.0 && fabs(due - now) <= MOST_LATE * period + LATEST_EVENT;
}

/* Whether the clock and the queue of the samples are what a simulation leaves. */
static bool sound_memory(const crane *m)
{
    const double *clock = m->memory + ROW_CLOCK * COLUMNS, *queue = m->memory + ROW_QUEUE * COLUMNS;
    const double now = clock[1], places = 6.0 * (double)(m->rows - ROW_QUEUE - 4);
    for (int64_t i = 0; i < m->rows * COLUMNS; i++) {
        if (!isfinite(m->memory[i])) {
            return false;
        }
    }
    return fabs(now) <= LATEST && clock[2] == 0.0 && near(clock[3] * m->loop[1], now, m->loop[1])
        && (m->sensors[0] <= 0.0
            || (near(queue[0] * m->sensors[0], now, m->sensors[0])
                && counts(queue[1], places) && counts(queue[2], places + 1.0)));
}

bool model_sound(const model *base, size_t size)
{
    const crane *m = (const crane *)base;
    bool sized = size == model_used(base)
        && (m->rows == 0 || size == size_for(m->sensors[0], m->sensors[1]));
    return sized && (m->rows > 0 || !base->initialised) && m->count_changes >= 0
        && m->count_changes <= CHANGES && (m->count_components == 0
                                           || m->count_components == COMPONENTS)
        && m->count_lengths >= 0 && m->count_lengths <= MOST_LENGTHS && m->count_nodes >= 0
        && m->count_nodes <= MOST_LENGTHS
        && (m->rows == 0 || (m->count_lengths > 0 && m->count_nodes > 0
                             && (m->loop[0] == 1.0 || m->loop[0] == 2.0) && sound_memory(m)));
}

int64_t model_rows(const model *base)
{
    return base->integer[V_FEEDBACK_TABLE_COUNT];
}

static bool in_exchange(const crane *m)
{
    return m->base.interface == EXCHANGE;
}

double crane_elapsed(const crane *m)
{
    return m->base.real[V_TIME] - m->memory[ROW_CLOCK * COLUMNS];
}

int64_t crane_rates(crane *m)
{
    return segfmu_rig_rates(matrix(m->components, m->count_components, 7),
                            vector(m->setpoints, SETPOINTS), crane_elapsed(m), memory_of(m),
                            vector(m->derivative, MODEL_STATES));
}

/* The same under the present inputs. */
static int64_t find_rates(crane *m)
{
    crane_read_inputs(m);
    return crane_rates(m);
}

bool crane_follows(const crane *m)
{
    const double *lag = m->parameters + 5;
    return m->parameters[4] < 0.5 || (lag[0] > 0.0 && lag[1] > 0.0 && lag[2] > 0.0);
}

/* The first derivatives; the report stays that of a start. */
static void start_rates(crane *m)
{
    double report[COLUMNS];
    memset(m->derivative, 0, sizeof m->derivative);
    if (crane_follows(m)) {
        memcpy(report, row(m, ROW_REPORT), sizeof report);
        find_rates(m);
        memcpy(row(m, ROW_REPORT), report, sizeof report);
    }
}

bool model_initialise(model *base, char message[MESSAGE])
{
    crane *m = (crane *)base;
    m->rows = 0;
    if (!crane_set_up(m, message)) {
        return false;
    }
    m->rows = segfmu_rig_rows(m->sensors[0], m->sensors[1]);
    crane_read_inputs(m);
    segfmu_rig_start(
        vector(m->loop, LOOP), vector(m->sensors, SENSORS), matrix(m->changes, m->count_changes, 2),
        vector(m->parameters, PARAMETERS), vector(&base->real[V_BRIDGE_POSITION], STATE),
        vector(m->setpoints, SETPOINTS), base->real[V_TIME], memory_of(m));
    for (int i = 0; i < 3; i++) {
        base->integer[V_DRIVE_BRIDGE_SATURATED + i] = 0;
    }
    start_rates(m);
    memcpy(m->input, base->real, sizeof m->input);
    memset(m->slope, 0, sizeof m->slope);
    return true;
}

/* ---- co-simulation ---- */

bool model_advance(model *base, double time, char message[MESSAGE])
{
    crane *m = (crane *)base;
    if (base->tuned && !crane_set_gains(m, message)) {
        return false;
    }
    crane_follow_inputs(m, time);
    int64_t status = segfmu_rig_step(
        vector(m->loop, LOOP), vector(m->sensors, SENSORS),
        matrix(m->components, m->count_components, 7), matrix(m->changes, m->count_changes, 2),
        vector(m->tracking, TRACKING), vector(m->nodes, m->count_nodes), observer_of(m),
        vector(m->lengths, m->count_lengths), gains_of(m), matrix(m->tracker, MEMORY, STATE),
        vector(m->setpoints, SETPOINTS),
        time - base->real[V_TIME], memory_of(m));
    memcpy(m->derivative, row(m, ROW_DERIVATIVE), sizeof m->derivative);
    for (int i = 0; i < 3; i++) {
        base->integer[V_DRIVE_BRIDGE_SATURATED + i] = row(m, ROW_REPORT)[10 + i] > 0.0;
    }
    if (time >= base->step_end && base->sloped) {
        memset(base->slope, 0, sizeof base->slope);
        base->sloped = 0;
    }
    return status == 0 || crane_failed(m, status, row(m, ROW_CLOCK)[7], message);
}

/* ---- events: of model exchange, as co-simulation meets them within its steps ---- */

double model_next_event(const model *base)
{
    crane *m = (crane *)base;
    if (!in_exchange(m)) {
        return INFINITY;
    }
    double since = segfmu_rig_next_event(vector(m->loop, LOOP), vector(m->sensors, SENSORS),
                                         memory_of(m));
    return since < 1e299 ? row(m, ROW_CLOCK)[0] + since : INFINITY;
}

bool model_event(model *base, char message[MESSAGE])
{
    crane *m = (crane *)base;
    if (base->tuned && !crane_set_gains(m, message)) {
        return false;
    }
    if (!in_exchange(m)) {
        return true;
    }
    double late = crane_elapsed(m) - segfmu_rig_next_event(
        vector(m->loop, LOOP), vector(m->sensors, SENSORS), memory_of(m));
    if (late > LATEST_EVENT) {
        return say(message, "the time event at %.9g s was missed by %g s; an importer has to stop at "
                   "the times that the FMU names", base->real[V_TIME] - late, late);
    }
    crane_read_inputs(m);
    segfmu_rig_event(vector(m->loop, LOOP), vector(m->sensors, SENSORS),
                     matrix(m->changes, m->count_changes, 2), vector(m->tracking, TRACKING),
                     vector(m->nodes, m->count_nodes), observer_of(m),
                     vector(m->lengths, m->count_lengths), gains_of(m),
                     matrix(m->tracker, MEMORY, STATE), vector(m->setpoints, SETPOINTS),
                     crane_elapsed(m), memory_of(m));
    find_rates(m);
    for (int i = 0; i < 3; i++) {
        base->integer[V_DRIVE_BRIDGE_SATURATED + i] = row(m, ROW_REPORT)[3 + i] > 0.0;
    }
    return true;
}

/* ---- outputs ---- */

static void show_load(crane *m)
{
    double *real = m->base.real, *load = &real[V_LOAD_POSITION_X], square = 0.0;
    segfmu_crane_load(vector(row(m, ROW_STATE), STATE), matrix(load, 2, 3));
    for (int i = 0; i < 3; i++) {
        double error = load[i] - real[V_REFERENCE_LOAD_POSITION_X + i];
        real[V_ERROR_LOAD_X + i] = error;
        square += error * error;
    }
    real[V_ERROR_LOAD_NORM] = sqrt(square);
}

static void show_energies(crane *m)
{
    double *real = m->base.real, balance[ENERGIES];
    segfmu_rig_balance(memory_of(m), vector(balance, ENERGIES));
    real[V_ENERGY_KINETIC] = balance[0];
    real[V_ENERGY_POTENTIAL] = balance[1];
    real[V_ENERGY_DRIVES] = balance[3];
    real[V_ENERGY_WIND] = balance[4];
    real[V_ENERGY_WORK] = balance[3] + balance[4];
    real[V_ENERGY_PAYLOAD] = balance[5];
    real[V_ENERGY_DISSIPATED] = balance[6];
    real[V_ENERGY_IMBALANCE] = segfmu_rig_imbalance(vector(balance, ENERGIES));
}

bool model_evaluate(model *base, char message[MESSAGE])
{
    crane *m = (crane *)base;
    double *real = base->real;
    (void)message;
    m->differentiated = 0;
    if (in_exchange(m)) {
        find_rates(m);
        if (m->sensors[0] <= 0.0) {
            segfmu_rig_signals(vector(m->sensors, SENSORS), crane_elapsed(m), memory_of(m));
        }
    }
    const double *state = row(m, ROW_STATE), *report = row(m, ROW_REPORT);
    memcpy(&real[V_BRIDGE_POSITION], state, STATE * sizeof *real);
    memcpy(&real[V_MEASURED_BRIDGE_POSITION], row(m, ROW_SIGNALS), 5 * sizeof *real);
    memcpy(&real[V_BRIDGE_ACCELERATION], m->derivative + 5, 5 * sizeof *real);
    show_load(m);
    show_energies(m);
    crane_show_estimates(m);
    real[V_POWER_DRIVES] = 0.0;
    for (int i = 0; i < 3; i++) {
        real[V_DRIVE_BRIDGE_FORCE + 2 * i] = report[i];
        real[V_DRIVE_BRIDGE_POWER + 2 * i] = report[i] * state[5 + i];
        real[V_POWER_DRIVES] += report[i] * state[5 + i];
    }
    real[V_ROPE_FORCE] = report[6];
    real[V_POWER_WIND] = report[7];
    real[V_POWER_FRICTION] = report[8];
    real[V_PAYLOAD_MASS] = row(m, ROW_PARAMETERS)[2];
    return true;
}

/* ---- model exchange ---- */

void model_get_states(const model *base, double states[])
{
    memcpy(states, row((crane *)base, ROW_STATE), MODEL_STATES * sizeof *states);
}

void model_set_states(model *base, const double states[])
{
    memcpy(row((crane *)base, ROW_STATE), states, MODEL_STATES * sizeof *states);
}

bool model_derivatives(model *base, double derivatives[], char message[MESSAGE])
{
    crane *m = (crane *)base;
    memcpy(derivatives, m->derivative, sizeof m->derivative);
    for (int i = 0; i < MODEL_STATES; i++) {
        if (!isfinite(derivatives[i])) {
            return crane_failed(m, 4, base->real[V_TIME], message);
        }
    }
    return true;
}

bool model_accept(model *base, char message[MESSAGE])
{
    crane *m = (crane *)base;
    int64_t status = find_rates(m);
    base->evaluated = 0;
    segfmu_rig_signals(vector(m->sensors, SENSORS), crane_elapsed(m), memory_of(m));
    return status == 0 || crane_failed(m, status, base->real[V_TIME], message);
}
