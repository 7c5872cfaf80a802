/* GantryFeedforward: the plan is made from the parameters; all outputs are functions of time. */
#include <math.h>
#include <string.h>

#include "feedforward.h"

static const double model_nominals[MODEL_STATES + 1] = {0.0};

size_t model_least(void)
{
    return sizeof(feedforward);
}

size_t model_size(const model *base)
{
    return sizeof(feedforward) + sizeof(double) * segfmu_plan_size(
        base->integer[V_WAYPOINT_COUNT], AXES, base->integer[V_PLANNER_SMOOTHNESS]);
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

/* Whether the pieces of the axes follow each other. */
static bool ordered(const feedforward *m)
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    for (int axis = 0; axis < AXES; axis++) {
        if (t.offsets[axis] >= t.offsets[axis + 1]) {
            return false;
        }
    }
    return t.offsets[0] == 0 && t.offsets[AXES] == m->pieces;
}

bool model_sound(const model *base, size_t size)
{
    const feedforward *m = (const feedforward *)base;
    const int64_t most = (int64_t)(size / sizeof(double));
    if (m->pieces == 0) {
        return !base->initialised && size == sizeof(feedforward);
    }
    return m->points >= 2 && m->points <= MOST_POINTS && m->smoothness >= 2 && m->smoothness <= 6
        && m->pieces >= AXES && m->pieces <= most && size == model_used(base) && ordered(m);
}

bool model_initialise(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    m->pieces = 0;
    if (!feedforward_plan(m, message)) {
        return false;
    }
    base->real[V_PLAN_DURATION] = m->duration;
    return model_event(base, message);
}

bool model_warning(const model *m, const double start[], char message[MESSAGE])
{
    (void)m;
    (void)start;
    (void)message;
    return false;
}

/* ---- events ---- */

static array_double_2d timing_of(const segfmu_trajectory *t)
{
    return matrix((double *)t->timing, t->pieces, 2);
}

/* s by which the outputs are ahead. At initialisation they are those of the start, where the crane
   begins; from then on the lead counts. */
static double lead_of(const feedforward *m)
{
    return m->base.running ? m->base.real[V_SETPOINT_LEAD] : 0.0;
}

/* The time at which the outputs begin to move. */
static double beginning(const feedforward *m)
{
    return m->base.real[V_PLANNER_START_TIME] - lead_of(m);
}

static double upcoming(const feedforward *m)
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    double next = segfmu_next_plan_event(
        m->base.real[V_TIME], beginning(m), timing_of(&t), offsets_of(&t),
        vector((double *)t.ends, AXES), matrix((double *)t.times, t.points, AXES));
    return next < 1e300 ? next : INFINITY;
}

double model_next_event(const model *base)
{
    const feedforward *m = (const feedforward *)base;
    return m->ahead == lead_of(m) ? m->upcoming : upcoming(m);
}

bool model_event(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    (void)message;
    double time = base->real[V_TIME], latest = time + segfmu_same_break(time);
    int64_t passed = 0;
    m->ahead = lead_of(m);
    while (passed < m->points && m->events[passed] - m->ahead <= latest) {
        passed++;
    }
    /* the last event is the end, the one before it the arrival at the last waypoint */
    int64_t intervals = m->points - 1;
    base->integer[V_PLAN_INTERVAL] = passed + 1 < intervals ? passed + 1 : intervals;
    base->integer[V_PLAN_DONE] = passed == m->points;
    m->upcoming = upcoming(m);
    base->real[V_PLAN_NEXT_EVENT] = fmin(m->upcoming, m->events[m->points - 1] - m->ahead);
    return true;
}

/* The lead counts from the end of initialisation on, where no importer asks for an event. */
static void begin_lead(feedforward *m, char message[MESSAGE])
{
    if (m->ahead != lead_of(m)) {
        model_event(&m->base, message);
    }
}

bool model_advance(model *base, double time, char message[MESSAGE])
{
    (void)time;
    begin_lead((feedforward *)base, message);
    return true;
}

/* ---- outputs ---- */

/* Position and derivatives of the load at a time, one row a derivative. */
static void evaluate(const segfmu_trajectory *t, double time, int64_t orders, double *values)
{
    segfmu_evaluate_orders(
        time, timing_of(t), matrix((double *)t->coefficients, t->pieces, 2 * t->smoothness),
        offsets_of(t), vector((double *)t->ends, AXES), matrix(values, orders, AXES));
}

/* The velocities of the flat inverse's results as setpoints. */
static void add_setpoints(double results[RESULTS])
{
    for (int i = 0; i < AXES_SIZE; i++) {
        results[FEEDFORWARD_VELOCITY + i] = results[FEEDFORWARD_STATE + STATE_VELOCITY + i];
    }
}

bool model_evaluate(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    const segfmu_trajectory trajectory = feedforward_trajectory(m);
    double load[LOAD_MOTION_SIZE], masses[MASSES_SIZE], results[RESULTS];
    begin_lead(m, message);
    memset(m->derived, 0, sizeof m->derived);
    evaluate(&trajectory, base->real[V_TIME] - beginning(m), ORDERS, load);
    feed_record(&feeds_masses, base, masses);
    segfmu_crane_flat_inverse(
        matrix(load, ORDERS, AXES), vector(masses, MASSES_SIZE),
        vector(results, AXES_SIZE), vector(results + FLAT_INVERSE_STATE, STATE_SIZE),
        vector(results + FLAT_INVERSE_ACCELERATION, COORDINATES_SIZE));
    add_setpoints(results);
    show_record(&feeds_load_motion, load, base);
    show_record(&feeds_feedforward, results, base);
    return true;
}

/* Derivatives of what the flat inverse gives, kept until the time changes. */
static const double *derivatives(feedforward *m, const segfmu_trajectory *t, double time,
                                 int64_t order)
{
    enum { COLUMNS = MODEL_ORDERS + 3 };
    double masses[MASSES_SIZE], flat[(ORDERS + MODEL_ORDERS) * AXES];
    double work[FLAT_SERIES_SIZE * COLUMNS];
    double *found = m->derivatives[order - 1];
    if (!m->derived[order - 1]) {
        evaluate(t, time, ORDERS + order, flat);
        feed_record(&feeds_masses, &m->base, masses);
        segfmu_flat_derivatives(
            matrix(flat, ORDERS + order, AXES), order, vector(masses, MASSES_SIZE),
            matrix(work, FLAT_SERIES_SIZE, COLUMNS), vector(found, RESULTS));
        add_setpoints(found);
        m->derived[order - 1] = 1;
    }
    return found;
}

/* At a break of the plan, the derivatives from then on. */
bool model_output_derivative(model *base, const variable *output, int64_t order, double *value)
{
    feedforward *m = (feedforward *)base;
    const segfmu_trajectory t = feedforward_trajectory(m);
    double time = segfmu_right_of_break(
        base->real[V_TIME], beginning(m), timing_of(&t), offsets_of(&t),
        vector((double *)t.ends, AXES));
    int load = feed_place(&feeds_load_motion, output->offset);
    int place = feed_place(&feeds_feedforward, output->offset);
    if (load >= 0) {
        double values[AXES];
        segfmu_value(&t, time, load / AXES + order, values);
        *value = values[load % AXES];
        return true;
    }
    if (place < 0) {
        return false;
    }
    *value = derivatives(m, &t, time, order)[place];
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
