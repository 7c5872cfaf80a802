/* Planner and flat inverse: the plan is made from the parameters; all outputs are functions of time. */
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
    const int64_t smoothness = base->integer[V_PLANNER_SMOOTHNESS];
    const size_t plan = segfmu_plan_size(base->integer[V_WAYPOINT_COUNT], AXES, smoothness);
    const size_t search = base->integer[V_PLANNER_FINDS_LIMITS] ? search_size(base) : 0;
    const size_t operation = takes_commands(base) ? operation_size(smoothness) : 0;
    const size_t choice = choice_size(base), most = search > operation ? search : operation;
    /* one after the other: states are chosen, limits are searched for, commands begin */
    return sizeof(feedforward) + sizeof(double) * (plan + (most > choice ? most : choice));
}

size_t mission_size(const feedforward *m)
{
    return planned_size(m) + (size_t)(AXES_SIZE * m->rows * CONTACT_SIZE);
}

static size_t kept(const feedforward *m)
{
    if (m->pieces == 0) {
        return 0;
    }
    return mission_size(m) + (m->operates ? operation_size(m->smoothness) : 0);
}

size_t model_used(const model *base)
{
    return sizeof(feedforward) + kept((const feedforward *)base) * sizeof(double);
}

/* Whether the pieces of the axes follow each other. */
static bool ordered(const feedforward *m)
{
    const segfmu_trajectory t = mission_trajectory(m);
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
    if (m->rows < 1 || m->rows > most || m->operates != (m->operates != 0)
        || m->operating != (m->operating != 0) || m->operating > m->operates) {
        return false;
    }
    for (int i = 0; i < AXES_SIZE; i++) {
        if (m->turns[i] < 0 || m->turns[i] > m->rows) {
            return false;
        }
    }
    return m->points >= 2 && m->points <= MOST_POINTS && m->smoothness >= 2 && m->smoothness <= 6
        && m->pieces >= AXES && m->pieces <= most && size == model_used(base) && ordered(m)
        && operation_sound(m);
}

bool model_initialise(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    m->pieces = 0;
    m->operates = m->operating = 0;
    if (!feedforward_plan(m, message)
        || (takes_commands(base) && !begin_commands(m, message))) {
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

static double drives_of(const feedforward *m, double known[COMPENSATION_SIZE])
{
    double longest = 0.0;
    feed_record(&feeds_compensation, &m->base, known);
    for (int i = 0; i < AXES_SIZE; i++) {
        longest = fmax(longest, known[COMPENSATION_DEAD_TIME + i]);
    }
    return longest;
}

/* s by which the outputs are ahead of a plan that begins at its start time. The longest dead time has
   to pass before the load can move. At initialisation the outputs are those of the start, where the
   crane begins; from then on the lead counts. */
double ahead_of(const feedforward *m)
{
    double known[COMPENSATION_SIZE];
    return (m->base.running ? m->base.real[V_SETPOINT_LEAD] : 0.0) - drives_of(m, known);
}

static double beginning(const feedforward *m)
{
    return (m->operating ? operation_begin(m) : feedforward_start(m)) - ahead_of(m);
}

static double upcoming(const feedforward *m)
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    double known[COMPENSATION_SIZE], first = INFINITY;
    drives_of(m, known);
    /* of the reference, then of the setpoints, which are earlier by their dead times */
    for (int i = -1; i < AXES_SIZE; i++) {
        double dead = i < 0 ? 0.0 : known[COMPENSATION_DEAD_TIME + i];
        if (i >= 0 && m->turns[i] > 0 && !m->operating) {
            double turn = segfmu_next_contact_event(
                m->base.real[V_TIME], beginning(m) - dead, contacts_of(m, i));
            first = turn < 1e300 ? fmin(first, turn) : first;
        }
        if (i >= 0 && dead == 0.0) {
            continue;
        }
        double next = segfmu_next_plan_event(
            m->base.real[V_TIME], beginning(m) - dead, timing_of(&t), offsets_of(&t),
            vector((double *)t.ends, AXES), matrix((double *)t.times, t.points, AXES));
        first = next < 1e300 ? fmin(first, next) : first;
    }
    /* in co-simulation each step looks at the command */
    if (m->operating && m->base.interface == MODEL_EXCHANGE) {
        double renewal = operation_renewal(m);
        first = renewal < 1e300 ? fmin(first, renewal - ahead_of(m)) : first;
    }
    return first;
}

double model_next_event(const model *base)
{
    const feedforward *m = (const feedforward *)base;
    return m->ahead == ahead_of(m) ? m->upcoming : upcoming(m);
}

static void note_event(feedforward *m);

bool model_event(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    if (m->operates && base->running && base->interface == MODEL_EXCHANGE) {
        follow_command(m, 0.0, message);
    }
    note_event(m);
    return true;
}

static void note_event(feedforward *m)
{
    model *base = &m->base;
    double time = base->real[V_TIME], latest = time + segfmu_same_break(time);
    int64_t passed = 0;
    m->ahead = ahead_of(m);
    if (m->operating) {
        double end = operation_begin(m) + operation_trajectory(m).duration - m->ahead;
        base->integer[V_PLAN_INTERVAL] = 1;
        base->integer[V_PLAN_DONE] = end <= latest;
        m->upcoming = upcoming(m);
        base->real[V_PLAN_NEXT_EVENT] = fmin(m->upcoming, end);
        return;
    }
    while (passed < m->points && m->events[passed] - m->ahead <= latest) {
        passed++;
    }
    /* the last event is the end, the one before it the arrival at the last waypoint */
    int64_t intervals = m->points - 1;
    base->integer[V_PLAN_INTERVAL] = passed + 1 < intervals ? passed + 1 : intervals;
    base->integer[V_PLAN_DONE] = passed == m->points;
    m->upcoming = upcoming(m);
    base->real[V_PLAN_NEXT_EVENT] = fmin(m->upcoming, m->events[m->points - 1] - m->ahead);
}

static void begin_lead(feedforward *m, char message[MESSAGE])
{
    if (m->ahead != ahead_of(m)) {
        model_event(&m->base, message);
    }
}

bool model_advance(model *base, double *reached, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    begin_lead(m, message);
    if (m->operates && base->real[V_TIME] == base->step_start) {
        follow_command(m, base->step_end - base->step_start, message);
        note_event(m);
        *reached = fmin(m->upcoming, base->step_end);
    }
    return true;
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
