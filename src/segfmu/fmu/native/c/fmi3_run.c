/* FMI 3.0: derivatives, events, model exchange and co-simulation. */
#include "fmi3.h"

#include <math.h>

static fmi3Status refuse(fmi3Instance self, const char *function)
{
    instance *c = self;
    if (glue_allows(c, MODE_ANY, function)) {
        glue_log(c, STATUS_ERROR, "%s is not available", function);
    }
    return fmi3Error;
}

/* ---- dependencies and derivatives ---- */

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance self, fmi3ValueReference reference,
                                               size_t *count)
{
    (void)reference;
    (void)count;
    return refuse(self, __func__);
}

fmi3Status fmi3GetVariableDependencies(
    fmi3Instance self, fmi3ValueReference dependent, size_t elements[],
    fmi3ValueReference independents[], size_t independent_elements[], fmi3DependencyKind kinds[],
    size_t count)
{
    (void)dependent;
    (void)elements;
    (void)independents;
    (void)independent_elements;
    (void)kinds;
    (void)count;
    return refuse(self, __func__);
}

/* The derivatives of the standard are by element; ours are of scalars. */
static fmi3Status directional(fmi3Instance self, const char *function, const uint32_t unknowns[],
                              size_t m, const uint32_t knowns[], size_t n,
                              const fmi3Float64 seed[], size_t seeds, fmi3Float64 found[],
                              size_t size, bool adjoint)
{
    instance *c = self;
    if (!glue_allows(c, MODE_INITIALISATION | MODE_RUNNING | MODE_TERMINATED, function)) {
        return fmi3Error;
    }
    if (seeds != (adjoint ? m : n) || size != (adjoint ? n : m)) {
        glue_log(c, STATUS_ERROR, "%s: seed and result have %lu and %lu values, got %lu and %lu",
                 function, (unsigned long)(adjoint ? m : n), (unsigned long)(adjoint ? n : m),
                 (unsigned long)seeds, (unsigned long)size);
        return fmi3Error;
    }
    return status(glue_directional(c, function, unknowns, m, knowns, n, seed, found, adjoint));
}

fmi3Status fmi3GetDirectionalDerivative(
    fmi3Instance self, const fmi3ValueReference unknowns[], size_t m,
    const fmi3ValueReference knowns[], size_t n, const fmi3Float64 seed[], size_t seeds,
    fmi3Float64 found[], size_t size)
{
    return directional(self, __func__, unknowns, m, knowns, n, seed, seeds, found, size, false);
}

fmi3Status fmi3GetAdjointDerivative(
    fmi3Instance self, const fmi3ValueReference unknowns[], size_t m,
    const fmi3ValueReference knowns[], size_t n, const fmi3Float64 seed[], size_t seeds,
    fmi3Float64 found[], size_t size)
{
    return directional(self, __func__, unknowns, m, knowns, n, seed, seeds, found, size, true);
}

fmi3Status fmi3GetOutputDerivatives(fmi3Instance self, const fmi3ValueReference references[],
                                    size_t count, const fmi3Int32 orders[], fmi3Float64 values[],
                                    size_t size)
{
    instance *c = self;
    ALLOW(MODE_STEP | MODE_EVENT | MODE_TERMINATED | MODE_UPDATE);
    if (size != count) {
        glue_log(c, STATUS_ERROR, "%s: there are %lu values, got %lu", __func__,
                 (unsigned long)count, (unsigned long)size);
        return fmi3Error;
    }
    return status(glue_output_derivatives(c, __func__, references, count, orders, values));
}

/* ---- events ---- */

fmi3Status fmi3EnterEventMode(fmi3Instance self)
{
    instance *c = self;
    ALLOW(MODE_CONTINUOUS | MODE_EVENT | MODE_STEP);
    if (c->model->interface == CO_SIMULATION && !c->event_mode) {
        glue_log(c, STATUS_ERROR, "%s: the instance was made without event mode", __func__);
        return fmi3Error;
    }
    c->model->mode = MODE_EVENT;
    return fmi3OK;
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance self)
{
    instance *c = self;
    ALLOW(MODE_INITIALISATION | MODE_EVENT);
    return fmi3OK;
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance self, fmi3Boolean *again, fmi3Boolean *terminate,
                                    fmi3Boolean *nominals_changed, fmi3Boolean *states_changed,
                                    fmi3Boolean *has_next, fmi3Float64 *next)
{
    instance *c = self;
    ALLOW(MODE_EVENT);
    GIVEN(again);
    GIVEN(terminate);
    GIVEN(nominals_changed);
    GIVEN(states_changed);
    GIVEN(has_next);
    GIVEN(next);
    if (!glue_event(c)) {
        return fmi3Error;
    }
    double time = model_next_event(c->model);
    *again = *terminate = *nominals_changed = *states_changed = false;
    *has_next = isfinite(time);
    *next = isfinite(time) ? time : 0.0;
    return fmi3OK;
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance self)
{
    instance *c = self;
    ALLOW(MODE_EVENT);
    if (c->model->interface != MODEL_EXCHANGE) {
        return refuse(self, __func__);
    }
    c->model->mode = MODE_CONTINUOUS;
    return fmi3OK;
}

/* ---- model exchange ---- */

enum { EXCHANGE = MODE_INITIALISATION | MODE_EVENT | MODE_CONTINUOUS | MODE_TERMINATED };

static bool sized(instance *c, const void *values, size_t size, size_t wanted, const char *function)
{
    if (size != wanted) {
        glue_log(c, STATUS_ERROR, "%s: there are %lu values, got %lu", function,
                 (unsigned long)wanted, (unsigned long)size);
        return false;
    }
    return wanted == 0 || glue_given(c, values, function);
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance self, fmi3Boolean no_set_before,
                                       fmi3Boolean *enter_event_mode, fmi3Boolean *terminate)
{
    instance *c = self;
    ALLOW(MODE_CONTINUOUS);
    GIVEN(enter_event_mode);
    GIVEN(terminate);
    (void)no_set_before;
    *enter_event_mode = *terminate = false;
    return glue_accept(c, enter_event_mode) ? fmi3OK : fmi3Error;
}

fmi3Status fmi3SetTime(fmi3Instance self, fmi3Float64 time)
{
    instance *c = self;
    ALLOW(MODE_CONTINUOUS | MODE_EVENT);
    if (c->model->interface != MODEL_EXCHANGE) {
        return refuse(self, __func__);
    }
    if (!glue_time(c, time, "the time")) {
        return fmi3Error;
    }
    glue_set_time(c, time);
    return fmi3OK;
}

fmi3Status fmi3SetContinuousStates(fmi3Instance self, const fmi3Float64 states[], size_t size)
{
    instance *c = self;
    ALLOW(MODE_CONTINUOUS);
    if (!sized(c, states, size, MODEL_STATES, __func__)) {
        return fmi3Error;
    }
    for (size_t i = 0; i < size; i++) {
        if (!glue_finite(c, states[i], "a state")) {
            return fmi3Error;
        }
    }
    model_set_states(c->model, states);
    c->model->evaluated = 0;
    return fmi3OK;
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance self, fmi3Float64 derivatives[],
                                             size_t size)
{
    instance *c = self;
    ALLOW(EXCHANGE);
    if (!sized(c, derivatives, size, MODEL_STATES, __func__)) {
        return fmi3Error;
    }
    if (!glue_derivatives(c, derivatives)) {
        /* of a state that a solver only tries: it may go on with a shorter step */
        return c->model->mode == MODE_CONTINUOUS ? fmi3Discard : fmi3Error;
    }
    return fmi3OK;
}

fmi3Status fmi3GetEventIndicators(fmi3Instance self, fmi3Float64 indicators[], size_t size)
{
    instance *c = self;
    ALLOW(EXCHANGE);
    return status(sized(c, indicators, size, 0, __func__));
}

fmi3Status fmi3GetContinuousStates(fmi3Instance self, fmi3Float64 states[], size_t size)
{
    instance *c = self;
    ALLOW(EXCHANGE);
    if (!sized(c, states, size, MODEL_STATES, __func__) || !glue_evaluate(c)) {
        return fmi3Error;
    }
    model_get_states(c->model, states);
    return fmi3OK;
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance self, fmi3Float64 nominals[], size_t size)
{
    instance *c = self;
    ALLOW(EXCHANGE);
    if (!sized(c, nominals, size, MODEL_STATES, __func__)) {
        return fmi3Error;
    }
    for (size_t i = 0; i < size; i++) {
        nominals[i] = model_nominals[i];
    }
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance self, size_t *count)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    GIVEN(count);
    *count = 0;
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance self, size_t *count)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    GIVEN(count);
    *count = MODEL_STATES;
    return fmi3OK;
}
