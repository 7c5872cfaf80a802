/* The course of a simulation: initialisation, steps, events. */
#include <math.h>

#include "glue.h"

/* times that differ by less, relative to their size, are the same: importers add up steps */
static const double SAME = 1e-9;

/* of a time to which a step was added, relative to it */
static const double ROUNDING = 1e-14;

/* The first parameter outside its range, as the specification gives it. */
static bool in_range(instance *c)
{
    for (size_t i = 0; i < MODEL_VARIABLES; i++) {
        const variable *v = &model_variables[i];
        if (v->setting == SET_NEVER) {
            continue;
        }
        for (size_t k = 0; k < glue_elements_of(c, v); k++) {
            double value = v->kind == KIND_REAL ? c->model->real[v->offset + k]
                                                : (double)c->model->integer[v->offset + k];
            if (value >= v->least && value <= v->most) {
                continue;
            }
            if (isinf(v->most)) {
                glue_log(c, STATUS_ERROR, "initialisation failed: %s must be at least %g, got %g",
                         v->name, v->least, value);
            } else {
                glue_log(c, STATUS_ERROR, "initialisation failed: %s must be at least %g and at "
                         "most %g, got %g", v->name, v->least, v->most, value);
            }
            return false;
        }
    }
    return true;
}

static bool follow_parameters(instance *c)
{
    char message[MESSAGE] = "";
    if (!in_range(c)) {
        return false;
    }
    if (!model_initialise(c->model, message)) {
        glue_log(c, STATUS_ERROR, "initialisation failed: %s", message);
        return false;
    }
    c->model->initialised = 1;
    c->model->evaluated = 0;
    return true;
}

bool glue_evaluate(instance *c)
{
    model *m = c->model;
    char message[MESSAGE];
    if (m->mode == MODE_INITIALISATION && !m->initialised && !follow_parameters(c)) {
        return false;
    }
    if ((m->mode & (MODE_INITIALISATION | MODE_RUNNING)) == 0 || m->evaluated) {
        return true;
    }
    if (!model_evaluate(m, message)) {
        glue_log(c, STATUS_ERROR, "%s", message);
        return false;
    }
    m->evaluated = 1;
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
    if ((c->model->initialised || follow_parameters(c)) && glue_evaluate(c)) {
        if (model_warning(c->model, message)) {
            glue_log(c, STATUS_WARNING, "%s", message);
        }
        return true;
    }
    c->model->mode = MODE_FAILED;
    return false;
}

bool glue_begin_step(instance *c, double time, double step)
{
    model *m = c->model;
    double now = m->real[V_TIME];
    if (!glue_time(c, time, "the communication point")
        || !glue_time(c, time + step, "the end of the step")) {
        return false;
    }
    if (fabs(time - now) > SAME * (1.0 + fabs(now))) {
        glue_log(c, STATUS_ERROR, "a step from %.9g s was asked for, the time is %.9g s", time, now);
        return false;
    }
    if (!(step > 0.0)) {
        glue_log(c, STATUS_ERROR, "the communication step size must be above 0 s, got %g s", step);
        return false;
    }
    if (m->stops && time + step > m->stop + SAME * (1.0 + fabs(m->stop)) + 1e-3 * step) {
        glue_log(c, STATUS_ERROR, "a step to %.9g s would pass the stop time %.9g s", time + step,
                 m->stop);
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
    double next = model_next_event(c->model);
    /* an importer that steps to an event has its time but for rounding */
    *event = next <= end + ROUNDING * (1.0 + fabs(end));
    next = fmin(next, end);
    if (!model_advance(c->model, next, message)) {
        glue_log(c, STATUS_ERROR, "%s", message);
        c->model->mode = MODE_FAILED;
        return false;
    }
    glue_set_time(c, next);
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
    return true;
}
