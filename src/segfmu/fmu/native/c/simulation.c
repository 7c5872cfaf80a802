/* The sequence of a simulation: initialisation, steps, events. */
#include <math.h>

#include "glue.h"

/* s; a command between events is followed so long after the one before: a signal that changes all the
   time would ask for an event at each of the integrator's steps, which begin anew there */
static const double COMMANDED = 1e-3;

/* Whether all values are in the ranges that the specification gives. */
static bool in_range(instance *c)
{
    for (size_t i = 0; i < MODEL_VARIABLES; i++) {
        const variable *v = &model_variables[i];
        for (size_t k = 0; v->setting != SET_NEVER && k < glue_elements_of(c, v); k++) {
            double value = v->kind == KIND_REAL ? c->model->real[v->offset + k]
                                                : (double)c->model->integer[v->offset + k];
            if (!glue_in_range(c, v, k, value, "initialisation failed")) {
                return false;
            }
        }
    }
    return true;
}

static bool follow_parameters(instance *c)
{
    char message[MESSAGE] = "";
    if (!in_range(c) || !glue_reserve(c, model_size(c->model))) {
        return false;
    }
    if (!model_initialise(c->model, message)) {
        glue_log(c, STATUS_ERROR, "initialisation failed: %s", message);
        return false;
    }
    glue_release(c);
    c->model->initialised = 1;
    c->model->evaluated = 0;
    return true;
}

/* A solver of model exchange may try states outside the model's range. */
static int trial_status(const instance *c)
{
    return c->model->mode == MODE_CONTINUOUS ? STATUS_DISCARD : STATUS_ERROR;
}

/* The first differentiable variable at a place of `real`; there has to be one. */
static const variable *calculated_at(uint32_t place)
{
    const variable *v = model_variables;
    while (!v->differentiable || v->offset != place) {
        v++;
    }
    return v;
}

/* Whether the outputs are numbers: parameters at the edge of their range can overflow. */
static bool finite_outputs(instance *c)
{
    const double *real = c->model->real;
    for (size_t i = 0; i < MODEL_RUNS; i++) {
        const run r = model_differentiable[i];
        for (uint32_t k = r.first; k < (uint32_t)(r.first + r.count); k++) {
            if (!isfinite(real[k])) {
                glue_log(c, trial_status(c), "at %.9g s: %s is not finite; check the size of "
                         "parameters and inputs", real[V_TIME], glue_label(calculated_at(k))->name);
                return false;
            }
        }
    }
    return true;
}

bool glue_follows(instance *c)
{
    return c->model->initialised || follow_parameters(c);
}

bool glue_evaluate(instance *c)
{
    char message[MESSAGE];
    if ((c->model->mode & (MODE_INITIALISATION | MODE_EVENT)) != 0 && !glue_follows(c)) {
        return false;
    }
    model *m = c->model;
    if ((m->mode & (MODE_INITIALISATION | MODE_RUNNING | MODE_UPDATE)) == 0 || m->evaluated) {
        return true;
    }
    if (!model_evaluate(m, message)) {
        glue_log(c, STATUS_ERROR, "%s", message);
        return false;
    }
    if (!finite_outputs(c)) {
        return false;
    }
    m->evaluated = 1;
    return true;
}

bool glue_derivatives(instance *c, double derivatives[])
{
    char message[MESSAGE] = "";
    if (!glue_evaluate(c)) {
        return false;
    }
    if (!model_derivatives(c->model, derivatives, message)) {
        glue_log(c, trial_status(c), "%s", message);
        return false;
    }
    return true;
}

bool glue_begin(instance *c, double start, bool has_stop, double stop)
{
    if (!glue_time(c, start, "the start time")) {
        return false;
    }
    if (has_stop && !(stop >= start)) {
        glue_log(c, STATUS_ERROR, "the stop time %g s is before the start time %g s", stop, start);
        return false;
    }
    c->model->start = start;
    c->model->stops = has_stop;
    c->model->stop = has_stop ? stop : 0.0;
    c->model->initialised = 0;
    glue_set_time(c, start);
    return true;
}

bool glue_initialise(instance *c)
{
    char message[MESSAGE];
    if (glue_follows(c) && glue_evaluate(c)) {
        if (model_warning(c->model, c->start.real, message)) {
            glue_log(c, STATUS_WARNING, "%s", message);
        }
        c->model->running = 1;
        c->model->evaluated = 0;
        return true;
    }
    c->model->mode = MODE_FAILED;
    return false;
}

bool glue_started(instance *c, bool *moved)
{
    double before[MODEL_STATES + 1] = {0.0}, after[MODEL_STATES + 1] = {0.0};
    bool anew = !c->model->initialised;
    c->model->starting = 0;
    *moved = false;
    if (!anew) {
        return true;
    }
    model_get_states(c->model, before);
    if (!glue_initialise(c)) {
        return false;
    }
    model_get_states(c->model, after);
    for (int i = 0; i < MODEL_STATES; i++) {
        *moved = *moved || before[i] != after[i];
    }
    return true;
}

/* Whether inputs that follow their derivatives stay in their ranges for a step. */
static bool derivatives_in_range(instance *c, double step)
{
    const model *m = c->model;
    int found = 0;
    for (size_t i = 0; m->sloped && found < MODEL_INPUTS && i < MODEL_VARIABLES; i++) {
        const variable *v = &model_variables[i];
        if (v->setting == SET_INPUT && v->kind == KIND_REAL) {
            const int k = v->offset;
            const double bent = m->slope[1][k] / 2.0 + m->slope[2][k] / 6.0 * step;
            const double end = m->real[k] + (m->slope[0][k] + bent * step) * step;
            found++;
            if (!glue_in_range(c, v, 0, end, "derivatives refused, where the step ends")) {
                return false;
            }
        }
    }
    return true;
}

bool glue_begin_step(instance *c, double time, double step)
{
    model *m = c->model;
    double now = m->real[V_TIME], rounding = ROUNDING * (1.0 + fabs(time));
    if (!glue_time(c, time, "the communication point")
        || !glue_time(c, time + step, "the end of the step")) {
        return false;
    }
    if (!(step > 0.0)) {
        glue_log(c, STATUS_ERROR, "the communication step size must be above 0 s, got %g s", step);
        return false;
    }
    if (fabs(time - now) > fmin(SAME * (1.0 + fabs(now)), REPEATED * step + rounding)) {
        glue_log(c, STATUS_ERROR, "a step from %.15g s was asked for, the time is %.15g s", time, now);
        return false;
    }
    if (!(time + step > time + rounding)) {
        glue_log(c, STATUS_ERROR, "a step of %g s is below the resolution of the time at %.9g s",
                 step, time);
        return false;
    }
    if (m->stops && time + step > m->stop + SAME * (1.0 + fabs(m->stop)) + 1e-3 * step) {
        glue_log(c, STATUS_ERROR, "a step to %.9g s would pass the stop time %.9g s", time + step,
                 m->stop);
        return false;
    }
    if (!derivatives_in_range(c, step)) {
        return false;
    }
    glue_set_time(c, time);
    m->step_start = time;
    m->step_end = time + step;
    return true;
}

bool glue_continue_step(instance *c, double end, bool *event)
{
    char message[MESSAGE];
    double next = model_next_event(c->model), asked = fmin(next, end), reached = asked;
    if (!model_advance(c->model, &reached, message)) {
        glue_log(c, STATUS_ERROR, "%s", message);
        c->model->mode = MODE_FAILED;
        return false;
    }
    if (reached != asked) {
        next = model_next_event(c->model);
    }
    /* an importer that steps to an event has its time but for rounding */
    *event = next <= end + ROUNDING * (1.0 + fabs(end));
    glue_set_time(c, reached);
    return true;
}

bool glue_event(instance *c)
{
    char message[MESSAGE] = "";
    if (!model_event(c->model, message)) {
        glue_log(c, STATUS_ERROR, "%s", message);
        c->model->mode = MODE_FAILED;
        return false;
    }
    c->model->evaluated = 0;
    c->model->awaited = 0;
    c->model->met = c->model->real[V_TIME];
    return true;
}

bool glue_accept(instance *c, bool *event)
{
    char message[MESSAGE] = "";
    if (!model_accept(c->model, message)) {
        glue_log(c, STATUS_ERROR, "%s", message);
        c->model->mode = MODE_FAILED;
        return false;
    }
    *event = c->model->awaited && c->model->real[V_TIME] >= c->model->met + COMMANDED;
    return true;
}
