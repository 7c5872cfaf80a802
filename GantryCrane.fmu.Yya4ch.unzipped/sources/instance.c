/* Instances: their life, modes and messages. */
#include "arrays.h"
#include "glue.h"
#include "messages.h"
#include "records.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const CATEGORIES[] = {
    "logEvents", "logStatusWarning", "logStatusDiscard", "logStatusError", "logStatusFatal"
};

void glue_log(instance *c, int status, const char *format, ...)
{
    bool chosen = c->categories == 0 || (c->categories & 1u << status) != 0;
    if (c->report == NULL || !chosen || (status == STATUS_DISCARD && !c->logging)) {
        return;
    }
    char message[2 * MESSAGE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    c->report(c, status, CATEGORIES[status], message);
}

bool glue_choose(instance *c, bool on, const char *const categories[], size_t count)
{
    unsigned chosen = 0;
    for (size_t i = 0; i < count; i++) {
        size_t k = 0;
        while (k < sizeof CATEGORIES / sizeof *CATEGORIES
               && (categories[i] == NULL || strcmp(categories[i], CATEGORIES[k]) != 0)) {
            k++;
        }
        if (k == sizeof CATEGORIES / sizeof *CATEGORIES) {
            glue_log(c, STATUS_ERROR, "there is no log category %.80s",
                     categories[i] == NULL ? "NULL" : categories[i]);
            return false;
        }
        chosen |= 1u << k;
    }
    c->logging = on;
    c->categories = on ? chosen : 0;
    return true;
}

bool glue_reserve(instance *c, size_t size)
{
    if (size > c->capacity) {
        model *block = realloc(c->model, size);
        if (block == NULL) {
            glue_log(c, STATUS_ERROR, "out of memory");
            return false;
        }
        memset((char *)block + c->capacity, 0, size - c->capacity);
        c->model = block;
        c->capacity = size;
    }
    return true;
}

void glue_release(instance *c)
{
    size_t used = model_used(c->model);
    model *block = used < c->capacity ? realloc(c->model, used) : NULL;
    if (block != NULL) {
        c->model = block;
        c->capacity = used;
    }
}

static void start(instance *c, int interface)
{
    memset(c->model, 0, c->capacity);
    memcpy(c->model->real, c->start.real, sizeof c->model->real);
    memcpy(c->model->integer, c->start.integer, sizeof c->model->integer);
    memcpy(c->model->held, c->start.real, MODEL_INPUTS * sizeof *c->model->held);
    c->model->mode = MODE_INSTANTIATED;
    c->model->interface = interface;
    c->model->met = -LATEST;
}

instance *glue_create(const char *name, const char *token, const char *resources,
                      int interface, bool logging, reporter report, callback log,
                      void *environment)
{
    instance heard = {0};
    char message[MESSAGE] = "";
    heard.report = log == NULL ? NULL : report;
    heard.log = log;
    heard.environment = environment;
    heard.name = (char *)(name == NULL ? "" : name);
    if (name == NULL || name[0] == '\0') {
        glue_log(&heard, STATUS_ERROR, "an instance needs a name");
        return NULL;
    }
    if (!start_read(resources, &heard.start, message)) {
        glue_log(&heard, STATUS_ERROR, "%s", message);
        return NULL;
    }
    if (token == NULL || strcmp(token, heard.start.token) != 0) {
        glue_log(&heard, STATUS_ERROR, "the token of %s is %s, got %.80s; the description and the "
                 "resources are not of the same archive", model_name, heard.start.token,
                 token == NULL ? "none" : token);
        return NULL;
    }
    if (interface != MODEL_EXCHANGE && interface != CO_SIMULATION) {
        glue_log(&heard, STATUS_ERROR, "an instance is for model exchange or for co-simulation; the "
                 "type asked for is neither");
        return NULL;
    }
    instance *c = calloc(1, sizeof *c);
    char *own = malloc(strlen(name) + 1);
    model *block = calloc(1, model_least());
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
    c->capacity = model_least();
    start(c, interface);
    return c;
}

void glue_free(instance *c)
{
    if (c != NULL && c->model->mode == MODE_UPDATE) {
        /* the step that called is not over, and needs the instance */
        glue_log(c, STATUS_ERROR, "an instance cannot be freed within its callback");
    } else if (c != NULL) {
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
            : c->model->mode == MODE_INITIALISATION ? "in initialisation mode"
            : c->model->mode == MODE_EVENT ? "in event mode"
            : c->model->mode == MODE_CONTINUOUS ? "in continuous-time mode"
            : c->model->mode == MODE_STEP ? "between steps"
            : c->model->mode == MODE_UPDATE ? "within the intermediate update"
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
        glue_log(c, STATUS_ERROR, "%s must be within %g s of 0, got %.15g s", what, LATEST, time);
        return false;
    }
    return true;
}

void glue_set_time(instance *c, double time)
{
    c->model->real[V_TIME] = time;
    c->model->evaluated = 0;
}

bool glue_in_range(instance *c, const variable *v, size_t element, double value, const char *what)
{
    enum { PLACE = sizeof "[18446744073709551615]" };
    const label *own = glue_label(v);
    const range *within = &model_ranges[own->range];
    double most = v->counts ? (double)c->start.rows : within->most, fault[RANGE_FAULT_SIZE];
    if (value >= within->least && value <= most) {
        return true;
    }
    char message[MESSAGE] = "", place[PLACE] = "";
    int64_t status = segfmu_check_range(value, within->least, most, vector(fault, RANGE_FAULT_SIZE));
    segfmu_range_message(status, fault, message, MESSAGE);
    if (glue_elements_of(c, v) > 1) {
        snprintf(place, sizeof place, "[%lu]", (unsigned long)element + 1);
    }
    glue_log(c, STATUS_ERROR, "%s: %s%s %s", what, own->name, place, message);
    return false;
}

size_t glue_elements_of(const instance *c, const variable *v)
{
    return (size_t)(v->elements + c->start.rows * v->columns);
}

const variable *glue_variable(uint32_t reference)
{
    return &model_variables[reference - 1];
}

const label *glue_label(const variable *v)
{
    return &model_labels[v - model_variables];
}
