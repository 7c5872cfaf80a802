/* A crane with its drives, sensors and sampled feedback. In co-simulation the kernel
   rig_step goes from event to event by itself; in model exchange the importer integrates. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "say.h"

/* s by which an event may be handled late: importers with fixed steps cannot do better */
static const double LATEST_EVENT = 1.0;

/* periods by which the next tick or sample can be away from the present */
static const double MOST_LATE = 2.0;

/* Bytes of a block for the times in the settings; those that are refused need no room. */
static size_t size_for(double settings[SETTINGS_SIZE * SETTINGS_COLUMNS])
{
    double *sensors = settings + SETTINGS_SENSORS * SETTINGS_COLUMNS;
    double *late = settings + SETTINGS_PLANT * SETTINGS_COLUMNS + PLANT_DEAD_TIME;
    const double period = settings[SETTINGS_LOOP * SETTINGS_COLUMNS + LOOP_PERIOD];
    const double sample_time = sensors[SENSORS_SAMPLE_TIME], dead_time = sensors[SENSORS_DEAD_TIME];
    if (!(sample_time > 0.0 && dead_time >= 0.0
          && dead_time <= SENSOR_LIMITS_MOST_SAMPLES * sample_time)) {
        sensors[SENSORS_SAMPLE_TIME] = 0.0;
    }
    for (int i = 0; i < AXES_SIZE; i++) {
        if (!(period > 0.0 && late[i] >= 0.0 && late[i] <= DELAY_MOST_TICKS * period)) {
            late[i] = 0.0;
        }
    }
    int64_t rows = segfmu_rig_rows(matrix(settings, SETTINGS_SIZE, SETTINGS_COLUMNS));
    return sizeof(crane) + (size_t)rows * MEMORY_COLUMNS * sizeof(double);
}

size_t model_least(void)
{
    double settings[SETTINGS_SIZE * SETTINGS_COLUMNS] = {0.0};
    return size_for(settings);
}

size_t model_size(const model *base)
{
    double settings[SETTINGS_SIZE * SETTINGS_COLUMNS] = {0.0};
    feed_record(&feeds_loop, base, settings + SETTINGS_LOOP * SETTINGS_COLUMNS);
    feed_record(&feeds_sensors, base, settings + SETTINGS_SENSORS * SETTINGS_COLUMNS);
    feed_record(&feeds_plant, base, settings + SETTINGS_PLANT * SETTINGS_COLUMNS);
    return size_for(settings);
}

size_t model_used(const model *base)
{
    const crane *m = (const crane *)base;
    return m->rows == 0 ? model_least()
                        : sizeof(crane) + (size_t)m->rows * MEMORY_COLUMNS * sizeof(double);
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

/* Rows of the memory up to the end of the samples. */
static int64_t sampled_rows(crane *m)
{
    double settings[SETTINGS_SIZE * SETTINGS_COLUMNS];
    memcpy(settings, m->settings, sizeof settings);
    memset(settings + SETTINGS_PLANT * SETTINGS_COLUMNS + PLANT_DEAD_TIME, 0,
           AXES_SIZE * sizeof *settings);
    return segfmu_rig_rows(matrix(settings, SETTINGS_SIZE, SETTINGS_COLUMNS));
}

/* Whether the ring of late commands, behind the samples, is what a simulation leaves. */
static bool sound_commands(crane *m, int64_t first)
{
    const double places = DELAY_COMMANDS_A_ROW * (double)(m->rows - first - DELAYED_RING);
    const double *queue = row(m, (int)first + DELAYED_QUEUE);
    return m->rows == first
        || (counts(queue[COMMAND_QUEUE_OLDEST], places)
            && counts(queue[COMMAND_QUEUE_WAITING] - 1.0, places));
}

/* Whether the clock and the rings are what a simulation leaves. */
static bool sound_memory(crane *m)
{
    const double period = setting(m, SETTINGS_LOOP)[LOOP_PERIOD];
    const double sample_time = setting(m, SETTINGS_SENSORS)[SENSORS_SAMPLE_TIME];
    const double *clock = row(m, MEMORY_CLOCK), *queue = row(m, MEMORY_SENSING + SENSING_QUEUE);
    const double now = clock[CLOCK_REACHED];
    const int64_t end = sampled_rows(m);
    const double places = RING_SAMPLES_A_ROW * (double)(end - MEMORY_SENSING - SENSING_RING);
    for (int64_t i = 0; i < m->rows * MEMORY_COLUMNS; i++) {
        if (!isfinite(m->memory[i])) {
            return false;
        }
    }
    return fabs(now) <= LATEST && clock[CLOCK_DONE] == 0.0
        && near(clock[CLOCK_TICKS] * period, now, period)
        && (sample_time <= 0.0
            || (near(queue[QUEUE_TAKEN] * sample_time, now, sample_time)
                && counts(queue[QUEUE_OLDEST], places)
                && counts(queue[QUEUE_WAITING], places + 1.0)))
        && sound_commands(m, end);
}

bool model_sound(const model *base, size_t size)
{
    crane *m = (crane *)base;
    double settings[SETTINGS_SIZE * SETTINGS_COLUMNS];
    const double corrector = setting(m, SETTINGS_LOOP)[LOOP_CORRECTOR];
    memcpy(settings, m->settings, sizeof settings);
    bool sized = size == model_used(base) && (m->rows == 0 || size == size_for(settings));
    return sized && (m->rows > 0 || !base->initialised) && m->count_changes >= 0
        && m->count_changes <= CHANGES && m->count_components >= 0
        && m->count_components <= COMPONENTS
        && m->count_components % DISTURBANCE_COMPONENTS == 0
        && m->count_lengths >= 0 && m->count_lengths <= MOST_LENGTHS && m->count_observer >= 0
        && m->count_observer <= MOST_LENGTHS && suspension_sound(m, false)
        && (m->rows == 0 || (m->count_lengths > 0 && m->count_observer > 0
                             && (corrector == CORRECTOR_STATE || corrector == CORRECTOR_TRACKING
                                 || (corrector == CORRECTOR_CALLER && suspension_sound(m, true)))
                             && sound_memory(m)));
}

static bool in_exchange(const crane *m)
{
    return m->base.interface == MODEL_EXCHANGE;
}

double crane_elapsed(const crane *m)
{
    return m->base.real[V_TIME] - m->memory[MEMORY_CLOCK * MEMORY_COLUMNS + CLOCK_START];
}

int64_t crane_rates(crane *m)
{
    return segfmu_rig_rates(components_of(m), vector(m->setpoints, SETPOINTS_SIZE),
                            crane_elapsed(m), memory_of(m),
                            vector(m->derivative, PLANT_STATE_SIZE));
}

/* The same under the present inputs. */
static int64_t find_rates(crane *m)
{
    crane_read_inputs(m);
    return crane_rates(m);
}

bool crane_follows(const crane *m)
{
    const double *plant = setting((crane *)m, SETTINGS_PLANT);
    for (int i = 0; i < AXES_SIZE; i++) {
        if (plant[PLANT_DEAD_TIME + i] > 0.0 || (driven(m) && plant[PLANT_LAG + i] <= 0.0)) {
            return false;
        }
    }
    return true;
}

/* The derivatives that the kernels have found last in co-simulation. */
static void take_rates(crane *m)
{
    memcpy(m->derivative, row(m, MEMORY_WORK + WORK_STAGES + STAGES_K7), sizeof m->derivative);
}

bool model_initialise(model *base, char message[MESSAGE])
{
    crane *m = (crane *)base;
    double state[PLANT_STATE_SIZE] = {0.0};
    m->rows = 0;
    crane_read_inputs(m);
    if (!crane_place(m, state, message) || !crane_set_up(m, message)) {
        return false;
    }
    m->rows = segfmu_rig_rows(settings_of(m));
    segfmu_rig_start(
        settings_of(m), components_of(m), changes_of(m), vector(state, PLANT_STATE_SIZE),
        vector(m->setpoints, SETPOINTS_SIZE), base->real[V_TIME], memory_of(m));
    take_rates(m);
    memcpy(m->input, base->real, sizeof m->input);
    memset(m->slope, 0, sizeof m->slope);
    return true;
}

/* ---- co-simulation ---- */

static int64_t step_to(crane *m, double time)
{
    return segfmu_rig_step(
        settings_of(m), components_of(m), changes_of(m), observer_of(m), gains_of(m), tracker_of(m),
        vector(m->setpoints, SETPOINTS_SIZE), time - m->base.real[V_TIME], memory_of(m));
}

bool model_advance(model *base, double *reached, char message[MESSAGE])
{
    crane *m = (crane *)base;
    const double time = *reached;
    if (!crane_replace(m, message) || (base->tuned && !crane_set_gains(m, message))) {
        return false;
    }
    crane_follow_inputs(m, time);
    int64_t status = step_to(m, time);
    while (status == RIG_STATUS_TICK) {
        crane_correct(m);
        status = step_to(m, time);
    }
    take_rates(m);
    if (time >= base->step_end && base->sloped) {
        memset(base->slope, 0, sizeof base->slope);
        base->sloped = 0;
    }
    return status == 0 || crane_failed(m, status, row(m, MEMORY_CLOCK)[CLOCK_EVENT], message);
}

/* ---- events of model exchange; co-simulation handles them within its steps ---- */

double model_next_event(const model *base)
{
    crane *m = (crane *)base;
    if (!in_exchange(m)) {
        return INFINITY;
    }
    double since = segfmu_rig_next_event(settings_of(m), memory_of(m));
    return since < 1e299 ? row(m, MEMORY_CLOCK)[CLOCK_START] + since : INFINITY;
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
    double late = crane_elapsed(m) - segfmu_rig_next_event(settings_of(m), memory_of(m));
    if (late > LATEST_EVENT) {
        return say(message, "the time event at %.9g s was missed by %g s; an importer has to stop at "
                   "the times that the FMU names", base->real[V_TIME] - late, late);
    }
    crane_read_inputs(m);
    segfmu_rig_event(settings_of(m), changes_of(m), observer_of(m), gains_of(m), tracker_of(m),
                     vector(m->setpoints, SETPOINTS_SIZE), crane_elapsed(m), memory_of(m));
    find_rates(m);
    double *report = row(m, MEMORY_REPORT);
    memcpy(report + REPORT_STEP_SATURATED, report + REPORT_SATURATED, AXES_SIZE * sizeof *report);
    return true;
}

/* ---- outputs ---- */

/* Where the load shall be now. Between steps, inputs that are ahead are those of the next step's end,
   and the reference of the present is what they have come to in the last one. */
void crane_read_target(crane *m, double target[TARGET_SIZE])
{
    feed_record(&feeds_target, &m->base, target);
    if (in_exchange(m) || m->base.real[V_SETPOINT_LEAD] <= 0.0) {
        return;
    }
    for (int64_t i = 0; i < feeds_target.count; i++) {
        target[feeds_target.rows[i].place] = m->input[feeds_target.rows[i].offset];
    }
}

bool model_evaluate(model *base, char message[MESSAGE])
{
    crane *m = (crane *)base;
    double target[TARGET_SIZE], balance[BALANCE_SIZE], outputs[OUTPUTS_SIZE];
    double estimates[ESTIMATES_SIZE];
    (void)message;
    m->differentiated = 0;
    if (in_exchange(m)) {
        find_rates(m);
        if (setting(m, SETTINGS_SENSORS)[SENSORS_SAMPLE_TIME] <= 0.0) {
            segfmu_rig_signals(settings_of(m), crane_elapsed(m), memory_of(m));
        }
    }
    crane_read_target(m, target);
    segfmu_rig_outputs(vector(target, TARGET_SIZE), memory_of(m), vector(balance, BALANCE_SIZE),
                       vector(outputs, OUTPUTS_SIZE));
    segfmu_tracking_estimates(vector(setting(m, SETTINGS_TRACKING), TRACKING_SIZE), tracker_of(m),
                              vector(estimates, ESTIMATES_SIZE));
    show_record(&feeds_outputs, outputs, base);
    show_record(&feeds_accelerations, m->derivative + STATE_VELOCITY, base);
    show_record(&feeds_estimates, estimates, base);
    crane_show_suspension(m);
    base->real[V_POWER_DRIVES] = 0.0;
    for (int i = 0; i < AXES_SIZE; i++) {
        base->real[V_POWER_DRIVES] += outputs[OUTPUTS_POWER + i];
    }
    return true;
}

/* ---- model exchange ---- */

void model_get_states(const model *base, double states[])
{
    memcpy(states, row((crane *)base, MEMORY_STATE), MODEL_STATES * sizeof *states);
}

void model_set_states(model *base, const double states[])
{
    memcpy(row((crane *)base, MEMORY_STATE), states, MODEL_STATES * sizeof *states);
}

bool model_derivatives(model *base, double derivatives[], char message[MESSAGE])
{
    crane *m = (crane *)base;
    memcpy(derivatives, m->derivative, MODEL_STATES * sizeof *derivatives);
    for (int i = 0; i < MODEL_STATES; i++) {
        if (!isfinite(derivatives[i])) {
            return crane_failed(m, PLANT_STATUS_NOT_FINITE, base->real[V_TIME], message);
        }
    }
    return true;
}

bool model_accept(model *base, char message[MESSAGE])
{
    crane *m = (crane *)base;
    int64_t status = find_rates(m);
    base->evaluated = 0;
    segfmu_rig_signals(settings_of(m), crane_elapsed(m), memory_of(m));
    return status == 0 || crane_failed(m, status, base->real[V_TIME], message);
}
