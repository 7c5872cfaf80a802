/* GantryFeedforward: the plan is made from the parameters; all outputs are functions of time. */
#include <math.h>
#include <string.h>

#include "kernels.h"
#include "messages.h"
#include "model.h"
#include "segfmu.h"

enum { AXES = 3, ORDERS = 5, RESULTS = 18, MOST_POINTS = MODEL_ROWS };

const double model_nominals[MODEL_STATES + 1] = {0.0};

typedef struct {
    model base;
    int64_t points, smoothness, pieces;
    double duration;
    double events[MOST_POINTS + 1];  /* s, ascending: arrival at the waypoints, end */
    int64_t passed;                  /* of the events */
    double space[];                  /* timing, coefficients, offsets, times, ends */
} feedforward;

/* Where the outputs are that the flat inverse gives: forces, state, accelerations of the carriage. */
static const uint16_t RESULT_OFFSETS[RESULTS - 2] = {
    V_FORCE_BRIDGE, V_FORCE_TROLLEY, V_FORCE_HOIST,
    V_REFERENCE_BRIDGE_POSITION, V_REFERENCE_TROLLEY_POSITION, V_REFERENCE_ROPE_LENGTH,
    V_REFERENCE_SWAY_X_ANGLE, V_REFERENCE_SWAY_Y_ANGLE,
    V_REFERENCE_BRIDGE_VELOCITY, V_REFERENCE_TROLLEY_VELOCITY, V_REFERENCE_ROPE_VELOCITY,
    V_REFERENCE_SWAY_X_RATE, V_REFERENCE_SWAY_Y_RATE,
    V_REFERENCE_BRIDGE_ACCELERATION, V_REFERENCE_TROLLEY_ACCELERATION,
    V_REFERENCE_ROPE_ACCELERATION
};
enum { RATES = 8 };  /* first of the three velocities among the results */

/* What is read or written as one array lies side by side. */
#define SIDE_BY_SIDE(first, last, count) \
    typedef char first##_is_first[(last) - (first) == (count) - 1 ? 1 : -1]
SIDE_BY_SIDE(V_VELOCITY_BRIDGE, V_VELOCITY_HOIST, 3);
SIDE_BY_SIDE(V_REFERENCE_LOAD_POSITION_X, V_REFERENCE_LOAD_SNAP_Z, ORDERS * AXES);
SIDE_BY_SIDE(V_CRANE_BRIDGE_MASS, V_CRANE_ROPE_MAX, 6);
SIDE_BY_SIDE(V_LIMITS_X_VELOCITY, V_LIMITS_Z_SNAP, 4 * AXES);

static array_double_1d vector(double *data, int64_t n)
{
    array_double_1d a = {data, {n}};
    return a;
}

static array_double_2d matrix(double *data, int64_t rows, int64_t columns)
{
    array_double_2d a = {data, {rows, columns}};
    return a;
}

size_t model_size(void)
{
    return sizeof(feedforward) + segfmu_plan_size(MOST_POINTS, AXES, 6) * sizeof(double);
}

static size_t kept(const feedforward *m)
{
    if (m->pieces == 0) {
        return 0;
    }
    return (size_t)(m->pieces * (2 + 2 * m->smoothness) + AXES + 1 + m->points * AXES + AXES);
}

size_t model_used(const model *base)
{
    return sizeof(feedforward) + kept((const feedforward *)base) * sizeof(double);
}

int64_t model_rows(const model *base)
{
    return base->integer[V_WAYPOINT_COUNT];
}

/* ---- planning ---- */

static void move(double **to, const void *from, int64_t count)
{
    memmove(*to, from, (size_t)count * sizeof **to);
    *to += count;
}

/* Keep of the planner's work space what evaluation needs, at its beginning. */
static void compact(feedforward *m, const segfmu_trajectory *found)
{
    double *to = m->space;
    move(&to, found->timing, found->pieces * 2);
    move(&to, found->coefficients, found->pieces * 2 * found->smoothness);
    move(&to, found->offsets, AXES + 1);
    move(&to, found->times, found->points * AXES);
    move(&to, found->ends, AXES);
    m->points = found->points;
    m->smoothness = found->smoothness;
    m->pieces = found->pieces;
    m->duration = found->duration;
}

/* The trajectory in the block. */
static segfmu_trajectory trajectory_of(const feedforward *m)
{
    segfmu_trajectory t = {0};
    t.points = m->points;
    t.axes = AXES;
    t.smoothness = m->smoothness;
    t.pieces = m->pieces;
    t.duration = m->duration;
    t.timing = m->space;
    t.coefficients = t.timing + m->pieces * 2;
    t.offsets = (const int64_t *)(const void *)(t.coefficients + m->pieces * 2 * m->smoothness);
    t.times = (const double *)(const void *)(t.offsets + AXES + 1);
    t.ends = t.times + m->points * AXES;
    return t;
}

static void note_events(feedforward *m, const segfmu_trajectory *found)
{
    double start = m->base.real[V_PLANNER_START_TIME];
    for (int64_t i = 1; i < m->points; i++) {
        double last = 0.0;
        for (int axis = 0; axis < AXES; axis++) {
            last = fmax(last, found->times[i * AXES + axis]);
        }
        m->events[i - 1] = start + last;
    }
    m->events[m->points - 1] = start + m->duration;
}

/* Limits as the planner takes them, (axes, n + 1). */
static bool gather_limits(const double *real, int64_t smoothness, double *table,
                          char message[MESSAGE])
{
    for (int axis = 0; axis < AXES; axis++) {
        for (int64_t i = 0; i <= smoothness; i++) {
            table[axis * (smoothness + 1) + i] = i < 4 ? real[V_LIMITS_X_VELOCITY + axis * 4 + i]
                                                       : 0.0;
        }
        for (int i = 0; i < 2; i++) {
            double value = real[V_LIMITS_X_VELOCITY + axis * 4 + i];
            if (!(value > 0.0)) {
                return say(message, "limits.%c.%s must be greater than 0, got %g", "xyz"[axis],
                           i == 0 ? "velocity" : "acceleration", value);
            }
        }
    }
    return true;
}

static bool make_plan(feedforward *m, char message[MESSAGE])
{
    const double *real = m->base.real;
    const int64_t *integer = m->base.integer;
    double limits[AXES * 7];
    segfmu_problem problem = {
        integer[V_WAYPOINT_COUNT], AXES, integer[V_PLANNER_SMOOTHNESS],
        integer[V_PLANNER_SHAPE] - 1, integer[V_PLANNER_SYNCHRONIZATION] - 1,
        real[V_PLANNER_SAMPLE_TIME], real[V_PLANNER_DURATION],
        &real[V_WAYPOINT_POSITION], &real[V_WAYPOINT_VELOCITY], &real[V_WAYPOINT_ACCELERATION],
        &real[V_WAYPOINT_DWELL], limits
    };
    segfmu_trajectory found;
    if (!gather_limits(real, problem.smoothness, limits, message)
        || !waypoints_differ(&problem, message)) {
        return false;
    }
    int status = segfmu_plan(&problem, m->space, &found);
    if (status != 0) {
        return say_infeasible(message, status, &problem, found.report);
    }
    if (!require_rope(&found, &real[V_CRANE_BRIDGE_MASS], message)) {
        return false;
    }
    compact(m, &found);
    const segfmu_trajectory plan = trajectory_of(m);
    note_events(m, &plan);
    return true;
}

bool model_initialise(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    m->pieces = 0;
    if (!make_plan(m, message)) {
        return false;
    }
    base->real[V_PLAN_DURATION] = m->duration;
    return model_event(base, message);
}

/* ---- events ---- */

double model_next_event(const model *base)
{
    const feedforward *m = (const feedforward *)base;
    return m->passed < m->points ? m->events[m->passed] : INFINITY;
}

bool model_event(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    (void)message;
    m->passed = 0;
    while (m->passed < m->points && m->events[m->passed] <= base->real[V_TIME]) {
        m->passed++;
    }
    /* the last event is the end, the one before it the arrival at the last waypoint */
    int64_t intervals = m->points - 1;
    base->integer[V_PLAN_INTERVAL] = m->passed + 1 < intervals ? m->passed + 1 : intervals;
    base->integer[V_PLAN_DONE] = m->passed == m->points;
    return true;
}

bool model_advance(model *base, double time, char message[MESSAGE])
{
    (void)base;
    (void)time;
    (void)message;
    return true;
}

/* ---- outputs ---- */

static double local_time(const model *base)
{
    return base->real[V_TIME] - base->real[V_PLANNER_START_TIME];
}

bool model_evaluate(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    double *real = base->real, *load = &real[V_REFERENCE_LOAD_POSITION_X];
    const double *crane = &real[V_CRANE_BRIDGE_MASS];
    const segfmu_trajectory trajectory = trajectory_of(m);
    double results[RESULTS];
    (void)message;
    for (int d = 0; d < ORDERS; d++) {
        segfmu_value(&trajectory, local_time(base), d, load + d * AXES);
    }
    segfmu_crane_flat_inverse(
        matrix(load, ORDERS, AXES), crane[0], crane[1], crane[2], crane[3], vector(results, 3),
        vector(results + 3, 10), vector(results + 13, 5));
    for (int i = 0; i < RESULTS - 2; i++) {
        real[RESULT_OFFSETS[i]] = results[i];
    }
    for (int i = 0; i < 3; i++) {
        real[V_VELOCITY_BRIDGE + i] = results[RATES + i];
    }
    return true;
}

/* The place of an output among the results of the flat inverse, or -1. */
static int place_of(const variable *output)
{
    for (int i = 0; i < 3; i++) {
        if (output->offset == V_VELOCITY_BRIDGE + i) {
            return RATES + i;
        }
    }
    for (int i = 0; i < RESULTS - 2; i++) {
        if (output->offset == RESULT_OFFSETS[i]) {
            return i;
        }
    }
    return -1;
}

bool model_output_derivative(model *base, const variable *output, int64_t order, double *value)
{
    feedforward *m = (feedforward *)base;
    const segfmu_trajectory trajectory = trajectory_of(m);
    const double *crane = &base->real[V_CRANE_BRIDGE_MASS];
    double t = local_time(base), flat[(ORDERS + MODEL_ORDERS) * AXES], found[RESULTS];
    double work[20 * (MODEL_ORDERS + 3)];
    int load = (int)output->offset - V_REFERENCE_LOAD_POSITION_X, place = place_of(output);
    if (load >= 0 && load < ORDERS * AXES) {
        segfmu_value(&trajectory, t, load / AXES + order, flat);
        *value = flat[load % AXES];
        return true;
    }
    if (place < 0) {
        return false;
    }
    for (int64_t d = 0; d < ORDERS + order; d++) {
        segfmu_value(&trajectory, t, d, flat + d * AXES);
    }
    segfmu_flat_derivatives(
        matrix(flat, ORDERS + order, AXES), order, crane[0], crane[1], crane[2], crane[3],
        matrix(work, 20, MODEL_ORDERS + 3), vector(found, RESULTS));
    *value = found[place];
    return true;
}

bool model_partial(model *m, const variable *unknown, const variable *known, double *value)
{
    return unknown->differentiable && known->offset == V_TIME && known->kind == KIND_REAL
        && model_output_derivative(m, unknown, 1, value);
}

/* ---- model exchange: no continuous states ---- */

void model_get_states(const model *m, double states[])
{
    (void)m;
    (void)states;
}

void model_set_states(model *m, const double states[])
{
    (void)m;
    (void)states;
}

bool model_derivatives(model *m, double derivatives[], char message[MESSAGE])
{
    (void)m;
    (void)derivatives;
    (void)message;
    return true;
}

bool model_accept(model *m, char message[MESSAGE])
{
    (void)m;
    (void)message;
    return true;
}
