/* Instances, modes, messages, and the course of a simulation. */
#include "glue.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* times that differ by less, relative to their size, are the same: importers add up steps */
static const double SAME = 1e-9;

/* of a time to which a step was added, relative to it */
static const double ROUNDING = 1e-14;

/* s; beyond it doubles have no microseconds */
static const double LATEST = 1e9;

static const char *const CATEGORIES[] = {
    "logEvents", "logStatusWarning", "logStatusDiscard", "logStatusError", "logStatusFatal"
};

void glue_log(instance *c, int status, const char *format, ...)
{
    if (c->report == NULL || (status == STATUS_DISCARD && !c->logging)) {
        return;
    }
    char message[2 * MESSAGE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    c->report(c, status, CATEGORIES[status], message);
}

static void start(instance *c, int interface)
{
    memset(c->model, 0, model_used(c->model));
    memcpy(c->model->real, model_real_start, sizeof c->model->real);
    memcpy(c->model->integer, model_integer_start, sizeof c->model->integer);
    c->model->mode = MODE_INSTANTIATED;
    c->model->interface = interface;
}

instance *glue_create(const char *name, const char *token, int interface, bool logging,
                      reporter report, callback log, void *environment)
{
    instance heard = {0};
    heard.report = log == NULL ? NULL : report;
    heard.log = log;
    heard.environment = environment;
    heard.name = (char *)(name == NULL ? "" : name);
    if (name == NULL || name[0] == '\0') {
        glue_log(&heard, STATUS_ERROR, "an instance needs a name");
        return NULL;
    }
    if (token == NULL || strcmp(token, model_token) != 0) {
        glue_log(&heard, STATUS_ERROR, "the token of %s is %s, got %.80s; the description and the "
                 "binary are not of the same archive", model_name, model_token,
                 token == NULL ? "none" : token);
        return NULL;
    }
    instance *c = calloc(1, sizeof *c);
    char *own = malloc(strlen(name) + 1);
    model *block = calloc(1, model_size());
    if (c == NULL || own == NULL || block == NULL) {
        glue_log(&heard, STATUS_ERROR, "out of memory");
        free(c);
        free(own);
        free(block);
        return NULL;
    }
    *c = heard;
    c->name = strcpy(own, name);
    c->logging = logging;
    c->model = block;
    start(c, interface);
    return c;
}

void glue_free(instance *c)
{
    if (c != NULL) {
        free(c->model);
        free(c->name);
        free(c);
    }
}

void glue_reset(instance *c)
{
    start(c, (int)c->model->interface);
}

bool glue_allows(instance *c, int modes, const char *function)
{
    if (c == NULL) {
        return false;
    }
    if ((c->model->mode & modes) == 0) {
        const char *mode = c->model->mode == MODE_INSTANTIATED ? "before initialisation"
            : c->model->mode == MODE_CONFIGURATION ? "in configuration mode"
            : c->model->mode == MODE_INITIALISATION ? "in initialisation mode"
            : c->model->mode == MODE_EVENT ? "in event mode"
            : c->model->mode == MODE_CONTINUOUS ? "in continuous-time mode"
            : c->model->mode == MODE_STEP ? "between steps"
            : c->model->mode == MODE_TERMINATED ? "after termination" : "after an error";
        glue_log(c, STATUS_ERROR, "%s is not allowed %s", function, mode);
        return false;
    }
    return true;
}

bool glue_given(instance *c, const void *pointer, const char *function)
{
    if (pointer == NULL) {
        glue_log(c, STATUS_ERROR, "%s: an argument is a null pointer", function);
    }
    return pointer != NULL;
}

bool glue_finite(instance *c, double value, const char *what)
{
    if (!isfinite(value)) {
        glue_log(c, STATUS_ERROR, "%s must be finite, got %g", what, value);
        return false;
    }
    return true;
}

bool glue_time(instance *c, double time, const char *what)
{
    if (!(fabs(time) <= LATEST)) {
        glue_log(c, STATUS_ERROR, "%s must be within %g s of 0, got %g s", what, LATEST, time);
        return false;
    }
    return true;
}

void glue_set_time(instance *c, double time)
{
    c->model->real[V_TIME] = time;
    c->model->evaluated = 0;
}

/* The first parameter outside its range, as the specification gives it. */
static bool in_range(instance *c)
{
    for (size_t i = 0; i < MODEL_VARIABLES; i++) {
        const variable *v = &model_variables[i];
        if (v->setting == SET_NEVER) {
            continue;
        }
        for (size_t k = 0; k < glue_elements(c, (uint32_t)i); k++) {
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
