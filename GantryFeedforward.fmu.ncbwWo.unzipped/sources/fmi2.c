/* FMI 2.0 for every model of model.h: co-simulation and model exchange in one binary. */
#include "fmi2.h"

#include <math.h>
#include <string.h>

enum { REALS = 1 << KIND_REAL, BOOLEANS = 1 << KIND_BOOLEAN,
       INTEGERS = 1 << KIND_INTEGER | 1 << KIND_ENUMERATION };

static const int glue_state_modes = MODE_CONTINUOUS;

static void report(instance *c, int code, const char *category, const char *message)
{
    fmi2CallbackLogger log = (fmi2CallbackLogger)c->log;
    /* the standard has the importer format the message, so every percent sign is doubled: names and
       tokens that the importer gave may have some */
    enum { MOST_TEXT = 4 * MESSAGE };
    char text[MOST_TEXT];
    size_t used = 0;
    for (const char *p = message; *p != '\0' && used + 2 < sizeof text; p++) {
        text[used++] = *p;
        if (*p == '%') {
            text[used++] = '%';
        }
    }
    text[used] = '\0';
    log(c->environment, c->name, (fmi2Status)code, category, text);
}

/* ---- versions, logging, instances ---- */

const char *fmi2GetTypesPlatform(void)
{
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void)
{
    return fmi2Version;
}

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, size_t count,
                               const fmi2String categories[])
{
    instance *c = component;
    ALLOW(MODE_ANY);
    if (count > 0) {
        GIVEN(categories);
    }
    return status(glue_choose(c, on != fmi2False, categories, count));
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean on)
{
    (void)visible;
    if (functions == NULL) {
        return NULL;
    }
    int interface = type == fmi2CoSimulation ? CO_SIMULATION
        : type == fmi2ModelExchange ? MODEL_EXCHANGE : NO_INTERFACE;
    return glue_create(name, guid, resources, interface, on != fmi2False, report,
                       (callback)functions->logger, functions->componentEnvironment);
}

void fmi2FreeInstance(fmi2Component component)
{
    glue_free(component);
}

/* ---- initialisation, termination, reset ---- */

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean has_tolerance,
                               fmi2Real tolerance, fmi2Real start, fmi2Boolean has_stop,
                               fmi2Real stop)
{
    instance *c = component;
    ALLOW(MODE_INSTANTIATED);
    (void)has_tolerance;
    (void)tolerance;
    return status(glue_begin(c, start, has_stop != fmi2False, stop));
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component)
{
    instance *c = component;
    ALLOW(MODE_INSTANTIATED);
    c->model->mode = MODE_INITIALISATION;
    return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component)
{
    instance *c = component;
    ALLOW(MODE_INITIALISATION);
    if (!glue_initialise(c)) {
        return fmi2Error;
    }
    c->model->mode = c->model->interface == CO_SIMULATION ? MODE_STEP : MODE_EVENT;
    /* OpenModelica sets parameters here */
    c->model->starting = c->model->mode == MODE_EVENT;
    return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component component)
{
    instance *c = component;
    bool moved;
    ALLOW(MODE_RUNNING);
    if (!glue_started(c, &moved)) {
        return fmi2Error;
    }
    c->model->mode = MODE_TERMINATED;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component component)
{
    instance *c = component;
    ALLOW(MODE_ANY);
    glue_reset(c);
    return fmi2OK;
}

/* ---- values ---- */

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       fmi2Real values[])
{
    instance *c = component;
    ALLOW(MODE_ANY);
    if (!glue_readable(c, __func__, references, count, values, count, REALS)) {
        return fmi2Error;
    }
    glue_get_reals(c, references, count, values);
    return fmi2OK;
}

static fmi2Status get_integers(instance *c, const char *function,
                               const fmi2ValueReference references[], size_t count, int values[],
                               int kinds)
{
    if (!glue_allows(c, MODE_ANY, function)
        || !glue_readable(c, function, references, count, values, count, kinds)) {
        return fmi2Error;
    }
    for (size_t i = 0; i < count; i++) {
        values[i] = (int)glue_integer(c, references[i], 0);
    }
    return fmi2OK;
}

fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[],
                          size_t count, fmi2Integer values[])
{
    return get_integers(component, __func__, references, count, values, INTEGERS);
}

fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[],
                          size_t count, fmi2Boolean values[])
{
    return get_integers(component, __func__, references, count, values, BOOLEANS);
}

fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference references[],
                         size_t count, fmi2String values[])
{
    instance *c = component;
    ALLOW(MODE_ANY);
    return status(glue_readable(c, __func__, references, count, values, count, 0));
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[])
{
    instance *c = component;
    ALLOW(MODE_ANY);
    return status(glue_settable(c, __func__, references, count, values, count, REALS)
                  && glue_set_reals(c, references, count, values, count));
}

static fmi2Status set_integers(instance *c, const char *function,
                               const fmi2ValueReference references[], size_t count,
                               const int values[], int kinds)
{
    if (!glue_allows(c, MODE_ANY, function)
        || !glue_settable(c, function, references, count, values, count, kinds)) {
        return fmi2Error;
    }
    for (size_t i = 0; i < count; i++) {
        bool boolean = glue_variable(references[i])->kind == KIND_BOOLEAN;
        if (!glue_set_integer(c, references[i], 0, boolean ? values[i] != fmi2False : values[i])) {
            return fmi2Error;
        }
    }
    return fmi2OK;
}

fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[],
                          size_t count, const fmi2Integer values[])
{
    return set_integers(component, __func__, references, count, values, INTEGERS);
}

fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference references[],
                          size_t count, const fmi2Boolean values[])
{
    return set_integers(component, __func__, references, count, values, BOOLEANS);
}

fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference references[],
                         size_t count, const fmi2String values[])
{
    instance *c = component;
    ALLOW(MODE_ANY);
    return status(glue_settable(c, __func__, references, count, values, count, 0));
}

/* ---- saved states ---- */

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate *state)
{
    instance *c = component;
    ALLOW(MODE_ANY);
    GIVEN(state);
    return status(glue_save(c, state));
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state)
{
    instance *c = component;
    ALLOW(MODE_ANY);
    GIVEN(state);
    return status(glue_restore(c, state));
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate *state)
{
    instance *c = component;
    ALLOW(MODE_ANY);
    /* as with free(), there may be nothing */
    if (state != NULL) {
        glue_free_state(state);
    }
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t *size)
{
    instance *c = component;
    ALLOW(MODE_ANY);
    GIVEN(state);
    GIVEN(size);
    *size = glue_state_size(state);
    return fmi2OK;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[],
                                 size_t size)
{
    instance *c = component;
    ALLOW(MODE_ANY);
    GIVEN(state);
    GIVEN(bytes);
    return status(glue_serialise(c, state, bytes, size));
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state)
{
    instance *c = component;
    ALLOW(MODE_ANY);
    GIVEN(bytes);
    GIVEN(state);
    return status(glue_deserialise(c, bytes, size, state));
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component,
                                        const fmi2ValueReference unknowns[], size_t m,
                                        const fmi2ValueReference knowns[], size_t n,
                                        const fmi2Real seed[], fmi2Real found[])
{
    instance *c = component;
    ALLOW(MODE_INITIALISATION | MODE_RUNNING | MODE_TERMINATED);
    return status(glue_directional(c, __func__, unknowns, m, knowns, n, seed, found, false));
}
