/* Pendulum: angle and rate, by the classical method of fourth order in co-simulation. */
#include <math.h>
#include <string.h>

#include "say.h"

static const double LONGEST_STEP = 1e-3;

typedef struct {
    model base;
    double state[MODEL_STATES];
    double before[MODEL_INPUTS];  /* inputs at the end of the last step */
} pendulum;

static const double model_nominals[MODEL_STATES + 1] = {0.1, 0.1, 0.0};

size_t model_least(void)
{
    return sizeof(pendulum);
}

size_t model_size(const model *m)
{
    (void)m;
    return sizeof(pendulum);
}

bool model_sound(const model *m, size_t size)
{
    (void)m;
    return size == sizeof(pendulum);
}

size_t model_used(const model *m)
{
    (void)m;
    return sizeof(pendulum);
}

bool model_initialise(model *base, char message[MESSAGE])
{
    pendulum *m = (pendulum *)base;
    if (!(base->real[V_REFERENCE_ROPE_LENGTH] > 0.0)) {
        return say(message, "reference.rope.length must be above 0 m");
    }
    m->state[0] = base->real[V_SWAY_ANGLE];
    m->state[1] = base->real[V_SWAY_RATE];
    memcpy(m->before, base->real, sizeof m->before);
    return true;
}

bool model_warning(const model *m, const double start[], char message[MESSAGE])
{
    (void)m;
    (void)start;
    (void)message;
    return false;
}

static void rates(const double state[], const double input[], double gravity, double found[])
{
    double pull = gravity * sin(state[0]) + input[V_REFERENCE_BRIDGE_ACCELERATION] * cos(state[0])
        + 2.0 * input[V_REFERENCE_ROPE_VELOCITY] * state[1];
    found[0] = state[1];
    found[1] = -pull / input[V_REFERENCE_ROPE_LENGTH];
}

/* Inputs within a step: by their derivatives at its beginning, else linear. */
static void inputs_at(const pendulum *m, double time, double input[])
{
    const model *base = &m->base;
    double past = time - base->step_start, length = base->step_end - base->step_start;
    for (int i = 0; i < MODEL_INPUTS; i++) {
        input[i] = base->sloped
            ? base->real[i] + (base->slope[0][i]
                + (base->slope[1][i] / 2.0 + base->slope[2][i] * past / 6.0) * past) * past
            : m->before[i] + (base->real[i] - m->before[i]) * past / length;
    }
}

static void slope_at(const pendulum *m, double time, const double last[], double step,
                     double found[])
{
    double state[MODEL_STATES], input[MODEL_INPUTS];
    for (int i = 0; i < MODEL_STATES; i++) {
        state[i] = m->state[i] + step * last[i];
    }
    inputs_at(m, time + step, input);
    rates(state, input, m->base.real[V_CRANE_GRAVITY], found);
}

bool model_advance(model *base, double *reached, char message[MESSAGE])
{
    pendulum *m = (pendulum *)base;
    const double time = *reached;
    double now = base->real[V_TIME], steps = ceil((time - now) / LONGEST_STEP);
    double step = (time - now) / steps;
    (void)message;
    for (int64_t k = 0; (double)k < steps; k++) {
        double at = now + (double)k * step, still[MODEL_STATES] = {0.0, 0.0};
        double a[MODEL_STATES], b[MODEL_STATES], c[MODEL_STATES], d[MODEL_STATES];
        slope_at(m, at, still, 0.0, a);
        slope_at(m, at, a, 0.5 * step, b);
        slope_at(m, at, b, 0.5 * step, c);
        slope_at(m, at, c, step, d);
        for (int i = 0; i < MODEL_STATES; i++) {
            m->state[i] += step / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]);
        }
    }
    inputs_at(m, time, m->before);
    if (time >= base->step_end) {
        memset(base->slope, 0, sizeof base->slope);
        base->sloped = 0;
    }
    return true;
}

bool model_evaluate(model *base, char message[MESSAGE])
{
    pendulum *m = (pendulum *)base;
    double found[MODEL_STATES];
    (void)message;
    rates(m->state, base->real, base->real[V_CRANE_GRAVITY], found);
    base->real[V_SWAY_ANGLE] = m->state[0];
    base->real[V_SWAY_RATE] = m->state[1];
    base->real[V_SWAY_ACCELERATION] = found[1];
    base->real[V_LOAD_OFFSET] = base->real[V_REFERENCE_ROPE_LENGTH] * sin(m->state[0]);
    return true;
}

double model_next_event(const model *m)
{
    (void)m;
    return INFINITY;
}

bool model_event(model *m, char message[MESSAGE])
{
    (void)m;
    (void)message;
    return true;
}

void model_get_states(const model *base, double states[])
{
    memcpy(states, ((const pendulum *)base)->state, MODEL_STATES * sizeof *states);
}

void model_set_states(model *base, const double states[])
{
    memcpy(((pendulum *)base)->state, states, MODEL_STATES * sizeof *states);
}

bool model_derivatives(model *base, double derivatives[], char message[MESSAGE])
{
    const pendulum *m = (const pendulum *)base;
    (void)message;
    rates(m->state, base->real, base->real[V_CRANE_GRAVITY], derivatives);
    return true;
}

bool model_accept(model *m, char message[MESSAGE])
{
    (void)m;
    (void)message;
    return true;
}

bool model_output_derivative(model *m, const variable *output, int64_t order, double *value)
{
    (void)m;
    (void)output;
    (void)order;
    (void)value;
    return false;
}

bool model_partial(model *m, const variable *unknown, const variable *known, double *value)
{
    (void)m;
    (void)unknown;
    (void)known;
    (void)value;
    return false;
}
