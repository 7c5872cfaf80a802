/* Access to variables by value reference. */
#include <math.h>
#include <string.h>

#include "glue.h"
#include "messages.h"
#include "records.h"

enum { INPUT_MODES = MODE_INSTANTIATED | MODE_INITIALISATION | MODE_RUNNING };

/* Modes in which a variable may be set. */
static int modes_of(const instance *c, const variable *v)
{
    static const int modes[] = {
        0, MODE_INSTANTIATED | MODE_INITIALISATION,
        MODE_INSTANTIATED | MODE_INITIALISATION | MODE_EVENT | MODE_STEP,
        MODE_INSTANTIATED | MODE_INITIALISATION, INPUT_MODES,
        /* between events for OpenModelica, which sets them at each of the integrator's stages */
        MODE_INSTANTIATED | MODE_INITIALISATION | MODE_EVENT | MODE_STEP | MODE_CONTINUOUS
    };
    int allowed = modes[v->setting];
    if (v->setting == SET_FIXED && c->model->starting) {
        allowed |= MODE_EVENT;
    }
    if (v->state > 0 && c->model->interface == MODEL_EXCHANGE) {
        allowed |= glue_state_modes;
    }
    return allowed;
}

static const char *kind_name(uint8_t kind)
{
    static const char *const names[] = {"Real", "Integer", "Boolean", "Enumeration"};
    return names[kind];
}

/* What is asked of all variables of a call at once: a bit for each kind of setting among them, and
   these. */
enum { ALL_CALCULATED = 1 << 8, ALL_EARLY = 1 << 9 };

/* Lists up to this length are checked as fast as they are compared. */
enum { SHORT_LIST = 8 };

static bool is_last(const instance *c, const known_list *last, const uint32_t references[],
                    size_t count, size_t size, int kinds)
{
    return last->count == count && last->size == size && last->kinds == kinds
        && last->rows == c->start.rows && count > SHORT_LIST
        && memcmp(last->references, references, count * sizeof *references) == 0;
}

static void keep_last(const instance *c, known_list *last, const uint32_t references[],
                      size_t count, size_t size, int kinds, int all)
{
    if (count > SHORT_LIST && count <= MODEL_VARIABLES) {
        last->count = count;
        last->size = size;
        last->kinds = kinds;
        last->rows = c->start.rows;
        last->all = all;
        last->scalar = true;
        memcpy(last->references, references, count * sizeof *references);
        for (size_t i = 0; i < count; i++) {
            const variable *v = glue_variable(references[i]);
            last->places[i] = v->offset;
            last->scalar = last->scalar && v->elements == 1;
        }
    }
}

/* Places of the values of a list that was checked just now; NULL where it was not kept, and where it
   has arrays. */
static const uint16_t *known_places(const instance *c, int list, size_t count)
{
    const known_list *last = &c->known[list];
    return count > SHORT_LIST && count <= MODEL_VARIABLES && last->scalar ? last->places : NULL;
}

/* Checks for both reading and setting; `all` tells what is among the variables. */
static bool usable(instance *c, int list, const char *function,
                   const uint32_t references[], size_t count, const void *values, size_t size,
                   int kinds, int *all)
{
    if (count > 0
        && (!glue_given(c, references, function) || !glue_given(c, values, function))) {
        return false;
    }
    known_list *last = &c->known[list];
    if (is_last(c, last, references, count, size, kinds)) {
        *all = last->all;
        return true;
    }
    size_t elements = 0;
    int found = 0;
    for (size_t i = 0; i < count; i++) {
        if (references[i] < 1 || references[i] > c->start.variables) {
            const double fault[ACCESS_FAULT_SIZE] = {references[i]};
            char message[MESSAGE];
            segfmu_access_message(ACCESS_STATUS_NO_VARIABLE, fault, message, MESSAGE);
            glue_log(c, STATUS_ERROR, "%s: %s", function, message);
            return false;
        }
        const variable *v = glue_variable(references[i]);
        if ((kinds & (1 << v->kind)) == 0) {
            glue_log(c, STATUS_ERROR, "%s: %s is of type %s", function, glue_label(v)->name,
                     kind_name(v->kind));
            return false;
        }
        elements += glue_elements_of(c, v);
        found |= 1 << v->setting;
        if (v->calculated) {
            /* exact start values can be read at once */
            found |= v->setting == SET_NEVER ? ALL_CALCULATED | ALL_EARLY : ALL_CALCULATED;
        }
    }
    *all = found;
    if (elements != size) {
        glue_log(c, STATUS_ERROR, "%s: the variables have %lu values, got %lu", function,
                 (unsigned long)elements, (unsigned long)size);
        return false;
    }
    keep_last(c, last, references, count, size, kinds, found);
    return true;
}

bool glue_readable(instance *c, const char *function, const uint32_t references[], size_t count,
                   const void *values, size_t size, int kinds)
{
    int all;
    if (!usable(c, READ_LIST, function, references, count, values, size, kinds, &all)) {
        return false;
    }
    const int early = (all & ALL_EARLY) != 0 ? MODE_INSTANTIATED : 0;
    return (all & ALL_CALCULATED) == 0
        || (glue_allows(c, (MODE_ANY | MODE_UPDATE) & ~early, function) && glue_evaluate(c));
}

bool glue_settable(instance *c, const char *function, const uint32_t references[], size_t count,
                   const void *values, size_t size, int kinds)
{
    int all;
    if (!usable(c, SET_LIST, function, references, count, values, size, kinds, &all)) {
        return false;
    }
    const int64_t mode = c->model->mode;
    if (all == 1 << SET_INPUT && (INPUT_MODES & mode) != 0) {
        return true;
    }
    for (size_t i = 0; i < count; i++) {
        const variable *v = glue_variable(references[i]);
        const int modes = modes_of(c, v);
        if ((modes & mode) == 0) {
            glue_log(c, STATUS_ERROR, "%s: %s cannot be set %s", function, glue_label(v)->name,
                     modes == 0 ? "at all" : "now");
            return false;
        }
    }
    return true;
}

void glue_get_reals(const instance *c, const uint32_t references[], size_t count, double values[])
{
    const double *real = c->model->real;
    const uint16_t *places = known_places(c, READ_LIST, count);
    if (places != NULL) {
        for (size_t i = 0; i < count; i++) {
            values[i] = real[places[i]];
        }
        return;
    }
    for (size_t i = 0; i < count; i++) {
        const variable *v = glue_variable(references[i]);
        if (v->elements == 1) {
            *values++ = real[v->offset];
        } else {
            size_t elements = glue_elements_of(c, v);
            memcpy(values, real + v->offset, elements * sizeof *values);
            values += elements;
        }
    }
}

/* What follows from variables is out of date; `settings` has a bit for each one's kind of setting,
   of commands only if their values are others. */
static void touch(instance *c, int settings)
{
    if ((c->model->mode & MODE_RUNNING) == 0 || (settings & 1 << SET_FIXED) != 0) {
        c->model->initialised = 0;
    }
    if ((settings & 1 << SET_INPUT) != 0) {
        c->model->given |= !c->model->running;
        /* OpenModelica sets inputs after initialisation, where the start can follow from them */
        if (c->model->starting && !c->model->given) {
            c->model->initialised = 0;
        }
    }
    c->model->tuned |= (settings & (1 << SET_TUNABLE | 1 << SET_COMMAND)) != 0;
    c->model->awaited |= (settings & 1 << SET_COMMAND) != 0 && c->model->mode == MODE_CONTINUOUS;
    c->model->evaluated = 0;
}

/* Whether all values are finite; reports the first one that is not. */
static bool finite_values(instance *c, const uint32_t references[], const double values[], size_t size)
{
    size_t place = 0, behind = 0;
    while (place < size && isfinite(values[place])) {
        place++;
    }
    if (place == size) {
        return true;
    }
    const variable *v = NULL;
    while (behind <= place) {
        v = glue_variable(*references++);
        behind += glue_elements_of(c, v);
    }
    return glue_finite(c, values[place], glue_label(v)->name);
}

/* While the model runs nothing checks its parameters again, so inputs and what is tuned are checked
   here. */
static bool running_in_range(instance *c, const variable *v, const double values[], size_t count)
{
    const bool tuned = v->setting == SET_TUNABLE || v->setting == SET_COMMAND;
    const char *refused = tuned ? "tuning refused" : "input refused";
    if (!(tuned || v->setting == SET_INPUT) || (c->model->mode & MODE_RUNNING) == 0) {
        return true;
    }
    for (size_t k = 0; k < count; k++) {
        if (!glue_in_range(c, v, k, values[k], refused)) {
            return false;
        }
    }
    return true;
}

static bool all_in_range(instance *c, const uint32_t references[], size_t count,
                         const double values[])
{
    for (size_t i = 0; i < count; i++) {
        const variable *v = glue_variable(references[i]);
        size_t elements = glue_elements_of(c, v);
        if (!running_in_range(c, v, values, elements)) {
            return false;
        }
        values += elements;
    }
    return true;
}

/* Set those that are states of the running model: it has them, not `real`. */
static void set_states(instance *c, const uint32_t references[], size_t count, const double values[])
{
    double states[MODEL_STATES + 1];
    model_get_states(c->model, states);
    for (size_t i = 0; i < count; i++) {
        const variable *v = glue_variable(references[i]);
        if (v->state > 0) {
            states[v->state - 1] = *values;
        }
        values += glue_elements_of(c, v);
    }
    model_set_states(c->model, states);
}

bool glue_set_reals(instance *c, const uint32_t references[], size_t count, const double values[],
                    size_t size)
{
    const uint16_t *places = known_places(c, SET_LIST, count);
    double *real = c->model->real;
    int settings = 0;
    if (!finite_values(c, references, values, size)
        || !all_in_range(c, references, count, values)) {
        return false;
    }
    if (places != NULL && c->known[SET_LIST].all == 1 << SET_INPUT) {
        for (size_t i = 0; i < count; i++) {
            real[places[i]] = values[i];
        }
        touch(c, 1 << SET_INPUT);
        return true;
    }
    if (MODEL_STATES > 0 && (c->model->mode & glue_state_modes) != 0) {
        set_states(c, references, count, values);
    }
    for (size_t i = 0; i < count; i++) {
        const variable *v = glue_variable(references[i]);
        const bool same = v->setting == SET_COMMAND && real[v->offset] == *values;
        if (v->elements == 1) {
            real[v->offset] = *values++;
        } else {
            size_t elements = glue_elements_of(c, v);
            memcpy(real + v->offset, values, elements * sizeof *values);
            values += elements;
        }
        settings |= same ? 0 : 1 << v->setting;
    }
    if (settings != 0) {
        touch(c, settings);
    }
    return true;
}

int64_t glue_integer(const instance *c, uint32_t reference, size_t element)
{
    return c->model->integer[glue_variable(reference)->offset + element];
}

bool glue_set_integer(instance *c, uint32_t reference, size_t element, int64_t value)
{
    const variable *v = glue_variable(reference);
    double number = (double)value;
    if (!running_in_range(c, v, &number, 1)) {
        return false;
    }
    int64_t *place = c->model->integer + v->offset + element;
    if (v->setting != SET_COMMAND || *place != value) {
        touch(c, 1 << v->setting);
    }
    *place = value;
    return true;
}

bool glue_directional(instance *c, const char *function, const uint32_t unknowns[], size_t m,
                      const uint32_t knowns[], size_t n, const double seed[], double found[],
                      bool adjoint)
{
    const int real = 1 << KIND_REAL;
    size_t rows = adjoint ? n : m, columns = adjoint ? m : n;
    int all;
    if (rows == 0) {
        return true;
    }
    if (!usable(c, UNKNOWN_LIST, function, unknowns, m, found, m, real, &all)
        || !usable(c, KNOWN_LIST, function, knowns, n, found, n, real, &all) || !glue_given(c, found, function)
        || (columns > 0 && !glue_given(c, seed, function)) || !glue_evaluate(c)) {
        return false;
    }
    for (size_t i = 0; i < rows; i++) {
        double sum = 0.0;
        for (size_t j = 0; j < columns; j++) {
            const variable *unknown = glue_variable(unknowns[adjoint ? j : i]);
            const variable *known = glue_variable(knowns[adjoint ? i : j]);
            double partial = 0.0;
            if (!model_partial(c->model, unknown, known, &partial)) {
                glue_log(c, STATUS_ERROR, "%s: there is no derivative of %s by %s now", function,
                         glue_label(unknown)->name, glue_label(known)->name);
                return false;
            }
            sum += partial * seed[j];
        }
        found[i] = sum;
    }
    return true;
}

bool glue_output_derivatives(instance *c, const char *function, const uint32_t references[],
                             size_t count, const int32_t orders[], double values[])
{
    int all;
    if (!usable(c, UNKNOWN_LIST, function, references, count, values, count, 1 << KIND_REAL, &all)
        || (count > 0 && !glue_given(c, orders, function)) || !glue_evaluate(c)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const variable *v = glue_variable(references[i]);
        if (!v->differentiable || orders[i] < 1 || orders[i] > MODEL_ORDERS
            || !model_output_derivative(c->model, v, orders[i], &values[i])) {
            glue_log(c, STATUS_ERROR, "%s: %s has no derivative of order %d", function, glue_label(v)->name,
                     (int)orders[i]);
            return false;
        }
    }
    return true;
}

bool glue_input_derivatives(instance *c, const char *function, const uint32_t references[],
                            size_t count, const int32_t orders[], const double values[])
{
    int all;
    if (!usable(c, KNOWN_LIST, function, references, count, values, count, 1 << KIND_REAL, &all)
        || (count > 0 && !glue_given(c, orders, function))) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const variable *v = glue_variable(references[i]);
        if (v->setting != SET_INPUT || orders[i] < 1 || orders[i] > INPUT_ORDERS) {
            glue_log(c, STATUS_ERROR, "%s: %s takes no derivative of order %d", function, glue_label(v)->name,
                     (int)orders[i]);
            return false;
        }
        if (!glue_finite(c, values[i], glue_label(v)->name)) {
            return false;
        }
    }
    for (size_t i = 0; i < count; i++) {
        c->model->slope[orders[i] - 1][glue_variable(references[i])->offset] = values[i];
        c->model->sloped = 1;
    }
    return true;
}
