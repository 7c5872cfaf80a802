/* FMI 2.0: the functions that only model exchange or only co-simulation has. */
#include "fmi2.h"

#include <math.h>

/* s; later than any time that can be set */
static const double FAR_AWAY = 1e12;

/* Whether an instance is for one of the interfaces. */
static bool is(instance *c, int interface, const char *function)
{
    if (c->model->interface != interface) {
        glue_log(c, STATUS_ERROR, "%s is a function of %s", function,
                 interface == CO_SIMULATION ? "co-simulation" : "model exchange");
    }
    return c->model->interface == interface;
}

/* Whether an array has one element a state. */
static bool sized(instance *c, const void *values, size_t size, size_t wanted, const char *function)
{
    if (size != wanted) {
        glue_log(c, STATUS_ERROR, "%s: there are %lu values, got %lu", function,
                 (unsigned long)wanted, (unsigned long)size);
        return false;
    }
    return wanted == 0 || glue_given(c, values, function);
}

/* ---- model exchange ---- */

fmi2Status fmi2EnterEventMode(fmi2Component component)
{
    instance *c = component;
    ALLOW(MODE_CONTINUOUS | MODE_EVENT);
    c->model->mode = MODE_EVENT;
    return fmi2OK;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component component, fmi2EventInfo *info)
{
    instance *c = component;
    bool moved;
    ALLOW(MODE_EVENT);
    GIVEN(info);
    if (!glue_started(c, &moved) || !glue_event(c)) {
        return fmi2Error;
    }
    double next = model_next_event(c->model);
    info->newDiscreteStatesNeeded = fmi2False;
    info->terminateSimulation = fmi2False;
    info->nominalsOfContinuousStatesChanged = fmi2False;
    info->valuesOfContinuousStatesChanged = moved ? fmi2True : fmi2False;
    info->nextEventTimeDefined = isfinite(next) ? fmi2True : fmi2False;
    /* OpenModelica reads it where it is not defined as well */
    info->nextEventTime = isfinite(next) ? next : FAR_AWAY;
    return fmi2OK;
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component component)
{
    instance *c = component;
    bool moved;
    ALLOW(MODE_EVENT);
    if (!glue_started(c, &moved)) {
        return fmi2Error;
    }
    c->model->mode = MODE_CONTINUOUS;
    return fmi2OK;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component component, fmi2Boolean no_set_before,
                                       fmi2Boolean *enter_event_mode, fmi2Boolean *terminate)
{
    instance *c = component;
    bool event = false;
    ALLOW(MODE_CONTINUOUS);
    GIVEN(enter_event_mode);
    GIVEN(terminate);
    (void)no_set_before;
    fmi2Status status = glue_accept(c, &event) ? fmi2OK : fmi2Error;
    *enter_event_mode = event;
    *terminate = fmi2False;
    return status;
}

fmi2Status fmi2SetTime(fmi2Component component, fmi2Real time)
{
    instance *c = component;
    ALLOW(MODE_CONTINUOUS | MODE_EVENT);
    if (!is(c, MODEL_EXCHANGE, __func__) || !glue_time(c, time, "the time")) {
        return fmi2Error;
    }
    glue_set_time(c, time);
    return fmi2OK;
}

fmi2Status fmi2SetContinuousStates(fmi2Component component, const fmi2Real states[], size_t size)
{
    instance *c = component;
    /* event mode for OpenModelica, which sets them before the first event is over */
    ALLOW(MODE_CONTINUOUS | MODE_EVENT);
    if (!sized(c, states, size, MODEL_STATES, __func__) || !glue_follows(c)) {
        return fmi2Error;
    }
    for (size_t i = 0; i < size; i++) {
        if (!glue_finite(c, states[i], "a state")) {
            return fmi2Error;
        }
    }
    model_set_states(c->model, states);
    c->model->evaluated = 0;
    return fmi2OK;
}

fmi2Status fmi2GetDerivatives(fmi2Component component, fmi2Real derivatives[], size_t size)
{
    instance *c = component;
    ALLOW(MODE_INITIALISATION | MODE_EVENT | MODE_CONTINUOUS | MODE_TERMINATED | MODE_FAILED);
    if (!sized(c, derivatives, size, MODEL_STATES, __func__)) {
        return fmi2Error;
    }
    if (!glue_derivatives(c, derivatives)) {
        /* of a state that a solver only tries: it may go on with a shorter step */
        return c->model->mode == MODE_CONTINUOUS ? fmi2Discard : fmi2Error;
    }
    return fmi2OK;
}

fmi2Status fmi2GetEventIndicators(fmi2Component component, fmi2Real indicators[], size_t size)
{
    instance *c = component;
    ALLOW(MODE_INITIALISATION | MODE_EVENT | MODE_CONTINUOUS | MODE_TERMINATED | MODE_FAILED);
    return status(sized(c, indicators, size, 0, __func__));
}

fmi2Status fmi2GetContinuousStates(fmi2Component component, fmi2Real states[], size_t size)
{
    instance *c = component;
    ALLOW(MODE_INITIALISATION | MODE_EVENT | MODE_CONTINUOUS | MODE_TERMINATED | MODE_FAILED);
    if (!sized(c, states, size, MODEL_STATES, __func__) || !glue_evaluate(c)) {
        return fmi2Error;
    }
    model_get_states(c->model, states);
    return fmi2OK;
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component component, fmi2Real nominals[],
                                             size_t size)
{
    instance *c = component;
    ALLOW(MODE_INSTANTIATED | MODE_INITIALISATION | MODE_EVENT | MODE_CONTINUOUS | MODE_TERMINATED
          | MODE_FAILED);
    if (!sized(c, nominals, size, MODEL_STATES, __func__)) {
        return fmi2Error;
    }
    for (size_t i = 0; i < size; i++) {
        nominals[i] = model_nominals[i];
    }
    return fmi2OK;
}

/* ---- co-simulation ---- */

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component,
                                       const fmi2ValueReference references[], size_t count,
                                       const fmi2Integer orders[], const fmi2Real values[])
{
    instance *c = component;
    ALLOW(MODE_INSTANTIATED | MODE_INITIALISATION | MODE_STEP);
    if (!is(c, CO_SIMULATION, __func__)) {
        return fmi2Error;
    }
    return status(glue_input_derivatives(c, __func__, references, count, orders, values));
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component,
                                        const fmi2ValueReference references[], size_t count,
                                        const fmi2Integer orders[], fmi2Real values[])
{
    instance *c = component;
    ALLOW(MODE_STEP | MODE_TERMINATED);
    return status(glue_output_derivatives(c, __func__, references, count, orders, values));
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real step,
                      fmi2Boolean no_set_before)
{
    instance *c = component;
    ALLOW(MODE_STEP);
    (void)no_set_before;
    if (!glue_begin_step(c, time, step)) {
        return fmi2Error;
    }
    double end = c->model->step_end;
    do {
        bool event = false;
        if (!glue_continue_step(c, end, &event) || (event && !glue_event(c))) {
            return fmi2Error;
        }
    } while (c->model->real[V_TIME] < end);
    return fmi2OK;
}

fmi2Status fmi2CancelStep(fmi2Component component)
{
    instance *c = component;
    ALLOW(MODE_ANY);
    glue_log(c, STATUS_ERROR, "%s: no step is under way", __func__);
    return fmi2Error;
}

/* Steps are never pending, so nothing but the time reached is known of the last one. */
static fmi2Status unknown(instance *c, const void *value, const char *function)
{
    if (!glue_allows(c, MODE_STEP | MODE_TERMINATED | MODE_FAILED, function)
        || !glue_given(c, value, function)) {
        return fmi2Error;
    }
    glue_log(c, STATUS_DISCARD, "%s: this status is not available", function);
    return fmi2Discard;
}

fmi2Status fmi2GetStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Status *value)
{
    (void)kind;
    return unknown(component, value, __func__);
}

fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value)
{
    instance *c = component;
    if (kind != fmi2LastSuccessfulTime) {
        return unknown(c, value, __func__);
    }
    ALLOW(MODE_STEP | MODE_TERMINATED | MODE_FAILED);
    GIVEN(value);
    *value = c->model->real[V_TIME];
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component component, const fmi2StatusKind kind,
                                fmi2Integer *value)
{
    (void)kind;
    return unknown(component, value, __func__);
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind,
                                fmi2Boolean *value)
{
    instance *c = component;
    if (kind != fmi2Terminated) {
        return unknown(c, value, __func__);
    }
    ALLOW(MODE_STEP | MODE_TERMINATED | MODE_FAILED);
    GIVEN(value);
    *value = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component component, const fmi2StatusKind kind,
                               fmi2String *value)
{
    (void)kind;
    return unknown(component, value, __func__);
}
