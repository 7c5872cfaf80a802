/* FMI 3.0 for every model of model.h: instances, initialisation, saved states. */
#include "fmi3.h"

#include <math.h>
#include <string.h>

static const int glue_state_modes = MODE_CONTINUOUS | MODE_EVENT;

static void report(instance *c, int code, const char *category, const char *message)
{
    fmi3LogMessageCallback log = (fmi3LogMessageCallback)c->log;
    log(c->environment, (fmi3Status)code, category, message);
}

/* ---- versions, logging, instances ---- */

const char *fmi3GetVersion(void)
{
    return fmi3Version;
}

fmi3Status fmi3SetDebugLogging(fmi3Instance self, fmi3Boolean on, size_t count,
                               const fmi3String categories[])
{
    instance *c = self;
    ALLOW(MODE_ANY);
    if (count > 0) {
        GIVEN(categories);
    }
    return status(glue_choose(c, on, categories, count));
}

fmi3Instance fmi3InstantiateModelExchange(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean on,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    (void)visible;
    return glue_create(name, token, resources, MODEL_EXCHANGE, on, report, (callback)log,
                       environment);
}

fmi3Instance fmi3InstantiateCoSimulation(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean on,
    fmi3Boolean event_mode, fmi3Boolean early_return, const fmi3ValueReference required[],
    size_t count, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3IntermediateUpdateCallback update)
{
    (void)visible;
    instance *c = glue_create(name, token, resources, CO_SIMULATION, on, report, (callback)log,
                              environment);
    if (c == NULL) {
        return NULL;
    }
    for (size_t i = 0; i < count; i++) {
        if (required == NULL || required[i] < 1 || required[i] > c->start.variables) {
            glue_log(c, STATUS_ERROR, "a required intermediate variable does not exist");
            glue_free(c);
            return NULL;
        }
    }
    c->event_mode = event_mode;
    c->early_return = early_return;
    c->update = (callback)update;
    return c;
}

fmi3Instance fmi3InstantiateScheduledExecution(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean on,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, fmi3ClockUpdateCallback update,
    fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock)
{
    (void)name;
    (void)token;
    (void)resources;
    (void)visible;
    (void)on;
    (void)update;
    (void)lock;
    (void)unlock;
    if (log != NULL) {
        log(environment, fmi3Error, "logStatusError", "scheduled execution is not available");
    }
    return NULL;
}

void fmi3FreeInstance(fmi3Instance self)
{
    glue_free(self);
}

/* ---- initialisation, configuration, termination, reset ---- */

fmi3Status fmi3EnterInitializationMode(fmi3Instance self, fmi3Boolean has_tolerance,
                                       fmi3Float64 tolerance, fmi3Float64 start,
                                       fmi3Boolean has_stop, fmi3Float64 stop)
{
    instance *c = self;
    ALLOW(MODE_INSTANTIATED);
    (void)has_tolerance;
    (void)tolerance;
    if (!glue_begin(c, start, has_stop, stop)) {
        return fmi3Error;
    }
    c->model->mode = MODE_INITIALISATION;
    return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance self)
{
    instance *c = self;
    ALLOW(MODE_INITIALISATION);
    if (!glue_initialise(c)) {
        return fmi3Error;
    }
    bool steps = c->model->interface == CO_SIMULATION && !c->event_mode;
    c->model->mode = steps ? MODE_STEP : MODE_EVENT;
    return fmi3OK;
}

static fmi3Status no_configuration(instance *c, const char *function)
{
    if (glue_allows(c, MODE_ANY, function)) {
        glue_log(c, STATUS_ERROR, "%s: there are no structural parameters; arrays have a fixed size",
                 function);
    }
    return fmi3Error;
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance self)
{
    return no_configuration(self, __func__);
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance self)
{
    return no_configuration(self, __func__);
}

fmi3Status fmi3Terminate(fmi3Instance self)
{
    instance *c = self;
    ALLOW(MODE_RUNNING);
    c->model->mode = MODE_TERMINATED;
    return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance self)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    glue_reset(c);
    return fmi3OK;
}

/* ---- saved states ---- */

fmi3Status fmi3GetFMUState(fmi3Instance self, fmi3FMUState *state)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    GIVEN(state);
    return status(glue_save(c, state));
}

fmi3Status fmi3SetFMUState(fmi3Instance self, fmi3FMUState state)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    GIVEN(state);
    return status(glue_restore(c, state));
}

fmi3Status fmi3FreeFMUState(fmi3Instance self, fmi3FMUState *state)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    /* as with free(), there may be nothing */
    if (state != NULL) {
        glue_free_state(state);
    }
    return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance self, fmi3FMUState state, size_t *size)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    GIVEN(state);
    GIVEN(size);
    *size = glue_state_size(state);
    return fmi3OK;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance self, fmi3FMUState state, fmi3Byte bytes[],
                                 size_t size)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    GIVEN(state);
    GIVEN(bytes);
    return status(glue_serialise(c, state, bytes, size));
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance self, const fmi3Byte bytes[], size_t size,
                                   fmi3FMUState *state)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    GIVEN(bytes);
    GIVEN(state);
    return status(glue_deserialise(c, bytes, size, state));
}
