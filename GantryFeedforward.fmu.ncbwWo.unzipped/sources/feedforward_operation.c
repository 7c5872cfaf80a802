/* GantryFeedforward: commands while it runs, by the kernels of operation. */
#include <math.h>
#include <string.h>

#include "feedforward.h"

/* The arrays of `segfmu_operate`. */
typedef struct {
    array_double_2d operation;
    array_double_3d limits;
    array_double_2d known;
    array_double_3d timing, coefficients;
    array_int64_t_1d offsets;
    array_double_3d states, cells;
    array_double_2d lead, work;
    array_double_3d stack;
} operation_arrays;

/* The next numbers of a block, of which some are used; NULL where they are only counted. */
static double *part(double *block, int64_t *used, int64_t count)
{
    double *found = block == NULL ? NULL : block + *used;
    *used += count;
    return found;
}

/* Carve the arrays out of a block, NULL to count the numbers that they use. */
static operation_arrays carve(double *block, int64_t smoothness, int64_t *used)
{
    const int64_t orders = smoothness + 1, width = 2 * smoothness, columns = 2 * width - 3;
    const int64_t rows = OPERATION_ROWS_ALL, slots = SLOT_COUNT;
    operation_arrays a;
    a.operation = matrix(part(block, used, OPERATION_SIZE * OPERATION_COLUMNS), OPERATION_SIZE,
                         OPERATION_COLUMNS);
    a.limits = cuboid(part(block, used, 2 * AXES * orders), 2, AXES, orders);
    a.known = matrix(part(block, used, KNOWN_SIZE * KNOWN_COLUMNS), KNOWN_SIZE, KNOWN_COLUMNS);
    a.timing = cuboid(part(block, used, slots * rows * TIMING_SIZE), slots, rows, TIMING_SIZE);
    a.coefficients = cuboid(part(block, used, slots * rows * width), slots, rows, width);
    a.offsets.data = (int64_t *)(void *)part(block, used, slots * SLOT_OFFSETS);
    a.offsets.shape[0] = slots * SLOT_OFFSETS;
    a.states = cuboid(part(block, used, 2 * AXES * orders), 2, AXES, orders);
    a.cells = cuboid(part(block, used, AXES * CELL_SIZE * CELL_COLUMNS), AXES, CELL_SIZE, CELL_COLUMNS);
    a.lead = matrix(part(block, used, LEAD_WORK_SIZE * LEAD_WORK_COLUMNS), LEAD_WORK_SIZE,
                    LEAD_WORK_COLUMNS);
    a.work = matrix(part(block, used, OPERATION_WORK_SIZE * OPERATION_WORK_COLUMNS),
                    OPERATION_WORK_SIZE, OPERATION_WORK_COLUMNS);
    a.stack = cuboid(part(block, used, STACK_ROWS * SPAN_SIZE * columns), STACK_ROWS, SPAN_SIZE,
                     columns);
    return a;
}

bool takes_commands(const model *base)
{
    return base->integer[V_COMMAND_ENABLED];
}

size_t operation_size(int64_t smoothness)
{
    int64_t used = 0;
    carve(NULL, smoothness, &used);
    return (size_t)used;
}

static operation_arrays arrays_of(const feedforward *m)
{
    int64_t used = 0;
    return carve((double *)m->space + mission_size(m), m->smoothness, &used);
}

static double *row_of(const array_double_2d *a, int64_t row)
{
    return a->data + row * a->shape[1];
}

/* What is known of the crane and its space, as the parameters are, and the limits of the plan. */
static void fill_known(const feedforward *m, operation_arrays *a)
{
    double limits[PLAN_LIMITS_SIZE];
    feed_record(&feeds_resistance, &m->base, row_of(&a->known, KNOWN_CRANE));
    feed_record(&feeds_rope_bounds, &m->base, row_of(&a->known, KNOWN_ROPE));
    feed_record(&feeds_drive_bounds, &m->base, row_of(&a->known, KNOWN_BOUNDS));
    feed_record(&feeds_drive_brakes, &m->base, row_of(&a->known, KNOWN_BRAKES));
    feed_record(&feeds_space, &m->base, row_of(&a->known, KNOWN_SPACE));
    feed_record(&feeds_plan_options, &m->base, row_of(&a->known, KNOWN_OPTIONS));
    feed_record(&feeds_plan_limits, &m->base, limits);
    for (int axis = 0; axis < AXES; axis++) {
        const double *row = limits + axis * LIMIT_ROW_SIZE;
        for (int i = 0; i < LOWER_SIZE; i++) {
            row_of(&a->known, KNOWN_LOWER + axis)[i] = -row[LIMIT_ROW_VELOCITY_MIN + i];
        }
        for (int64_t i = 0; i <= m->smoothness; i++) {
            a->limits.data[axis * (m->smoothness + 1) + i] = i < LIMITS ? row[i] : 0.0;
        }
    }
    for (int64_t i = 0; i < SPACE_LIMITS_OBSTACLES; i++) {
        feed_row(&feeds_obstacle_row, &m->base, i, row_of(&a->known, KNOWN_OBSTACLES + i));
    }
}

static void note_answer(feedforward *m, const operation_arrays *a)
{
    const double *progress = row_of(&a->operation, OPERATION_PROGRESS);
    for (int axis = 0; axis < AXES; axis++) {
        const double *when = a->timing.data + (a->offsets.data[axis + 1] - 1) * TIMING_SIZE;
        m->stops[axis] = when[TIMING_START] + when[TIMING_LENGTH];
    }
    m->base.integer[V_PLAN_STATUS] = (int64_t)progress[PROGRESS_STATUS];
    m->base.integer[V_PLAN_REFUSED] = (int64_t)progress[PROGRESS_REFUSED];
}

/* What an emergency stop at a time [s] would come to, if the user wants to know. */
static void foresee(feedforward *m, operation_arrays *a, double time)
{
    double *swing = row_of(&a->operation, OPERATION_SWING);
    bool found = false;
    if (m->base.integer[V_COMMAND_FORESEES]) {
        row_of(&a->operation, OPERATION_COMMAND)[COMMAND_TIME] = time;
        fill_known(m, a);
        found = segfmu_foresee_emergency(a->operation, a->known, a->timing, a->coefficients,
                                         a->offsets, a->work);
    }
    m->base.real[V_PLAN_EMERGENCY_DURATION] = found ? swing[SWING_STAND] : -1.0;
    m->base.real[V_PLAN_EMERGENCY_SWAY] = found ? swing[SWING_SWAY] : -1.0;
}

/* Begin in the measured state instead of with the plan; false with a message where that cannot be. */
static bool begin_measured(feedforward *m, operation_arrays *a, char message[MESSAGE])
{
    double fault[READY_FAULT_SIZE] = {0.0};
    double *command = row_of(&a->operation, OPERATION_COMMAND);
    feed_record(&feeds_command, &m->base, command);
    command[COMMAND_TIME] = feedforward_start(m);
    fault[READY_FAULT_VALUE] = m->base.real[V_MEASURED_ROPE_LENGTH];
    fill_known(m, a);
    int64_t status = segfmu_take_over_measured(
        a->operation, a->known, a->timing, a->coefficients, a->offsets, a->work, a->stack);
    if (segfmu_takeover_message(status, fault, message, MESSAGE)) {
        return false;
    }
    m->operating = 1;
    note_answer(m, a);
    return true;
}

bool begin_commands(feedforward *m, char message[MESSAGE])
{
    double compensation[COMPENSATION_SIZE], resistance[RESISTANCE_SIZE] = {0.0};
    double fault[READY_FAULT_SIZE] = {0.0};
    feed_record(&feeds_compensation, &m->base, compensation);
    feed_record(&feeds_resistance, &m->base, resistance);
    int64_t status = segfmu_check_ready(
        vector(compensation, COMPENSATION_SIZE), vector(resistance, RESISTANCE_SIZE), m->pieces,
        vector(fault, READY_FAULT_SIZE));
    if (segfmu_ready_message(status, fault, message, MESSAGE)) {
        return false;
    }
    const segfmu_trajectory plan = mission_trajectory(m);
    operation_arrays a = arrays_of(m);
    memset(a.operation.data, 0, operation_size(m->smoothness) * sizeof *a.operation.data);
    memcpy(a.timing.data, plan.timing, (size_t)(m->pieces * TIMING_SIZE) * sizeof *plan.timing);
    memcpy(a.coefficients.data, plan.coefficients,
           (size_t)(m->pieces * 2 * m->smoothness) * sizeof *plan.coefficients);
    memcpy(a.offsets.data, plan.offsets, SLOT_OFFSETS * sizeof *plan.offsets);
    segfmu_begin_operation(feedforward_start(m), a.operation);
    m->operates = 1;
    if (m->base.integer[V_COMMAND_TAKE_OVER] && !begin_measured(m, &a, message)) {
        return false;
    }
    foresee(m, &a, m->base.real[V_TIME] + ahead_of(m));
    return true;
}

/* Whether a command asks for anything but the plan that there is. */
static bool asks(const double command[COMMAND_SIZE])
{
    for (int i = COMMAND_TRIPPED; i < COMMAND_MEASURED; i++) {
        if (command[i] != 0.0) {
            return true;
        }
    }
    return command[COMMAND_MODE] != OPERATION_MODE_MISSION;
}

void follow_command(feedforward *m, double step, char message[MESSAGE])
{
    operation_arrays a = arrays_of(m);
    double *command = row_of(&a.operation, OPERATION_COMMAND);
    (void)message;
    feed_record(&feeds_command, &m->base, command);
    command[COMMAND_TIME] = m->base.real[V_TIME] + ahead_of(m);
    command[COMMAND_STEP] = step;
    command[COMMAND_LEAD] = m->base.real[V_SETPOINT_LEAD];
    const double time = command[COMMAND_TIME] + step;
    if (m->operating || asks(command)) {
        m->operating = 1;
        fill_known(m, &a);
        segfmu_operate(a.operation, a.limits, a.known, a.timing, a.coefficients, a.offsets, a.states,
                       a.cells, a.lead, a.work, a.stack);
        note_answer(m, &a);
    }
    foresee(m, &a, time);
}

double operation_begin(const feedforward *m)
{
    const operation_arrays a = arrays_of(m);
    return row_of(&a.operation, OPERATION_PROGRESS)[PROGRESS_BEGIN];
}

double operation_renewal(const feedforward *m)
{
    return segfmu_next_operation(arrays_of(m).operation);
}

segfmu_trajectory operation_trajectory(const feedforward *m)
{
    const operation_arrays a = arrays_of(m);
    segfmu_trajectory t = {0};
    t.points = 1;
    t.axes = AXES;
    t.smoothness = m->smoothness;
    t.pieces = a.offsets.data[AXES];
    t.timing = a.timing.data;
    t.coefficients = a.coefficients.data;
    t.offsets = a.offsets.data;
    t.times = t.ends = m->stops;
    for (int axis = 0; axis < AXES; axis++) {
        t.duration = fmax(t.duration, m->stops[axis]);
    }
    return t;
}

bool operation_sound(const feedforward *m)
{
    if (!m->operates) {
        return true;
    }
    const operation_arrays a = arrays_of(m);
    const double *progress = row_of(&a.operation, OPERATION_PROGRESS);
    bool sound = a.offsets.data[0] == 0 && a.offsets.data[AXES] <= OPERATION_ROWS_KEPT
        && isfinite(progress[PROGRESS_BEGIN])
        && progress[PROGRESS_NEXT] >= 0.0 && progress[PROGRESS_NEXT] <= OPERATION_ROWS_KEPT
        && progress[PROGRESS_FAILED] >= 0.0 && progress[PROGRESS_FAILED] <= OPERATION_STATUS_TRAVEL;
    const double *swing = row_of(&a.operation, OPERATION_SWING);
    for (int i = 0; i < SWING_SIZE; i++) {
        sound = sound && isfinite(swing[i]);
    }
    /* a load that swings has a rope */
    sound = sound && (swing[SWING_ACTIVE] == 0.0 || swing[SWING_POSITION + 2] > 0.0);
    for (int axis = 0; axis < AXES && sound; axis++) {
        const double *held = row_of(&a.operation, OPERATION_HELD + axis);
        int64_t pieces = a.offsets.data[axis + 1] - a.offsets.data[axis];
        /* the piece that is held comes before those behind it */
        sound = pieces > 0 && pieces <= OPERATION_ROWS_KEPT && held[HELD_VELOCITY_BEHIND] >= 0.0
            && held[HELD_VELOCITY_BEHIND] < (double)pieces;
    }
    return sound;
}
