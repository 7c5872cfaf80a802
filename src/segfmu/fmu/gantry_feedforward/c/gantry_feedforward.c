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
    return planned_size(m) + (size_t)(AXES_SIZE * m->rows * CONTACT_SIZE);
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
    if (m->rows < 1 || m->rows > most) {
        return false;
    }
    for (int i = 0; i < AXES_SIZE; i++) {
        if (m->turns[i] < 0 || m->turns[i] > m->rows) {
            return false;
        }
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
static double ahead_of(const feedforward *m)
{
    double known[COMPENSATION_SIZE];
    return (m->base.running ? m->base.real[V_SETPOINT_LEAD] : 0.0) - drives_of(m, known);
}

static double beginning(const feedforward *m)
{
    return feedforward_start(m) - ahead_of(m);
}

static double upcoming(const feedforward *m)
{
    const segfmu_trajectory t = feedforward_trajectory(m);
    double known[COMPENSATION_SIZE], first = INFINITY;
    drives_of(m, known);
    /* of the reference, then of the setpoints, which are earlier by their dead times */
    for (int i = -1; i < AXES_SIZE; i++) {
        double dead = i < 0 ? 0.0 : known[COMPENSATION_DEAD_TIME + i];
        if (i >= 0 && m->turns[i] > 0) {
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
    return first;
}

double model_next_event(const model *base)
{
    const feedforward *m = (const feedforward *)base;
    return m->ahead == ahead_of(m) ? m->upcoming : upcoming(m);
}

bool model_event(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    (void)message;
    double time = base->real[V_TIME], latest = time + segfmu_same_break(time);
    int64_t passed = 0;
    m->ahead = ahead_of(m);
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

static void begin_lead(feedforward *m, char message[MESSAGE])
{
    if (m->ahead != ahead_of(m)) {
        model_event(&m->base, message);
    }
}

bool model_advance(model *base, double time, char message[MESSAGE])
{
    (void)time;
    begin_lead((feedforward *)base, message);
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
