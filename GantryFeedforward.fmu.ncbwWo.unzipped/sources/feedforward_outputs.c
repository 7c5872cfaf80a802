/* Planner and flat inverse: reference and setpoints at a time, and their derivatives. */
#include <math.h>
#include <string.h>

#include "feedforward.h"

/* Position and derivatives of the load at a time, one row a derivative. */
static void evaluate(const segfmu_trajectory *t, double time, int64_t orders, double *values)
{
    segfmu_evaluate_orders(
        time, timing_of(t), matrix((double *)t->coefficients, t->pieces, 2 * t->smoothness),
        offsets_of(t), vector((double *)t->ends, AXES), matrix(values, orders, AXES));
}

/* The setpoint of a drive that acts at once but with a lag, or one of its derivatives. */
static double setpoint(const double results[RESULTS], int i, double lag)
{
    return results[RESULT_VELOCITY + i] + lag * results[RESULT_ACCELERATION + i];
}

/* Add the friction of a drive to its force, at a time since the start of the plan. */
static void add_friction(feedforward *m, int i, double time, const double of[RESULTS], double *force)
{
    if (m->turns[i] > 0) {
        double known[RESISTANCE_SIZE];
        crane_of(&m->base, known);
        *force += segfmu_planned_friction(
            vector(known, RESISTANCE_SIZE), i, time, of[RESULT_STATE + i],
            of[RESULT_VELOCITY + i], contacts_of(m, i));
    }
}

bool model_evaluate(model *base, char message[MESSAGE])
{
    feedforward *m = (feedforward *)base;
    const segfmu_trajectory trajectory = feedforward_trajectory(m);
    double load[ORDERS * AXES], early[ORDERS * AXES], known[COMPENSATION_SIZE];
    double results[RESULTS], other[RESULTS], crane[RESISTANCE_SIZE];
    begin_lead(m, message);
    memset(m->derived, 0, sizeof m->derived);
    memset(m->moved, 0, sizeof m->moved);
    drives_of(m, known);
    crane_of(base, crane);
    double time = base->real[V_TIME] - beginning(m);
    evaluate(&trajectory, time, ORDERS, load);
    invert(crane, load, results);
    for (int i = 0; i < AXES_SIZE; i++) {
        const double *of = results;
        if (known[COMPENSATION_DEAD_TIME + i] > 0.0) {
            evaluate(&trajectory, time + known[COMPENSATION_DEAD_TIME + i], ORDERS, early);
            invert(crane, early, other);
            of = other;
        }
        results[RESULT_FORCE + i] = of[RESULT_FORCE + i];
        add_friction(
            m, i, time + known[COMPENSATION_DEAD_TIME + i], of, &results[RESULT_FORCE + i]);
        results[RESULT_SETPOINT + i] = setpoint(of, i, known[COMPENSATION_LAG + i]);
    }
    show_record(&feeds_load_motion, load, base);
    show_record(&feeds_results, results, base);
    return true;
}

/* The load's motion from now on, one row a derivative, kept until the time changes; of the reference, or
   of a drive's setpoints. */
static double *motion(feedforward *m, int of, double dead)
{
    double *found = m->motion[of];
    if (!m->moved[of]) {
        const segfmu_trajectory t = feedforward_trajectory(m);
        double time = segfmu_right_of_break(
            m->base.real[V_TIME], beginning(m) - dead, timing_of(&t), offsets_of(&t),
            vector((double *)t.ends, AXES));
        evaluate(&t, time, ORDERS + MODEL_ORDERS, found);
        m->moved[of] = 1;
    }
    return found;
}

/* Derivatives of what the flat inverse gives, kept until the time changes; of those of the reference, or
   of a drive's setpoints. At a break of the plan, those from then on. */
static const double *derivatives(feedforward *m, int of, double dead, int64_t order)
{
    double known[RESISTANCE_SIZE];
    double *found = m->derivatives[order - 1][of];
    if (!m->derived[order - 1][of]) {
        crane_of(&m->base, known);
        invert_derivative(known, motion(m, of, dead), order, found);
        m->derived[order - 1][of] = 1;
    }
    return found;
}

/* A derivative of the friction of a drive, whose setpoints are those of a dead time later. */
static double friction_of(feedforward *m, int i, int of, double dead, int64_t order)
{
    double known[RESISTANCE_SIZE], results[RESULTS], path[MODEL_ORDERS + 2];
    double work[FRICTION_SERIES_SIZE * (MODEL_ORDERS + 1)];
    crane_of(&m->base, known);
    invert(known, motion(m, of, dead), results);
    path[0] = results[RESULT_STATE + i];
    path[1] = results[RESULT_VELOCITY + i];
    for (int64_t k = 1; k <= order; k++) {
        path[k + 1] = derivatives(m, of, dead, k)[RESULT_VELOCITY + i];
    }
    return segfmu_friction_derivative(
        vector(known, RESISTANCE_SIZE), i, m->base.real[V_TIME] - beginning(m) + dead,
        vector(path, MODEL_ORDERS + 2), order, contacts_of(m, i),
        matrix(work, FRICTION_SERIES_SIZE, MODEL_ORDERS + 1));
}

/* A derivative of an entry of `Feedforward`. */
static double derivative_of(feedforward *m, int place, int64_t order)
{
    double known[COMPENSATION_SIZE];
    drives_of(m, known);
    int first = place >= RESULT_SETPOINT ? RESULT_SETPOINT : RESULT_FORCE;
    int i = place - first;
    if (i >= AXES_SIZE) {
        return derivatives(m, 0, 0.0, order)[place];
    }
    double dead = known[COMPENSATION_DEAD_TIME + i];
    int of = dead > 0.0 ? i + 1 : 0;
    const double *found = derivatives(m, of, dead, order);
    if (first == RESULT_SETPOINT) {
        return setpoint(found, i, known[COMPENSATION_LAG + i]);
    }
    return m->turns[i] > 0 ? found[place] + friction_of(m, i, of, dead, order) : found[place];
}

bool model_output_derivative(model *base, const variable *output, int64_t order, double *value)
{
    feedforward *m = (feedforward *)base;
    int load = feed_place(&feeds_load_motion, output->offset);
    int place = feed_place(&feeds_results, output->offset);
    if (load >= 0) {
        *value = motion(m, 0, 0.0)[(load / AXES + order) * AXES + load % AXES];
        return true;
    }
    if (place < 0) {
        return false;
    }
    *value = derivative_of(m, place, order);
    return true;
}

bool model_partial(model *m, const variable *unknown, const variable *known, double *value)
{
    return unknown->differentiable && known->offset == V_TIME && known->kind == KIND_REAL
        && model_output_derivative(m, unknown, 1, value);
}
