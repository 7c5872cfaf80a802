#include "fmi3Functions.h"
#include "probe.h"

typedef struct {
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
    probe *p;
    bool early;
} instance;

static void say3(void *environment, int status, const char *message)
{
    instance *c = environment;
    c->log(c->environment, (fmi3Status)status, "logAll", message);
}

fmi3Instance fmi3InstantiateCoSimulation(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
    fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early,
    const fmi3ValueReference required[], size_t count, fmi3InstanceEnvironment environment,
    fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update)
{
    (void)name; (void)token; (void)resources; (void)visible; (void)logging; (void)required;
    (void)count; (void)update; (void)event_mode;
    instance *c = calloc(1, sizeof *c);
    *c = (instance){environment, log, probe_made(c, say3), early};
    return c;
}

void fmi3FreeInstance(fmi3Instance c)
{
    free(((instance *)c)->p);
    free(c);
}

const char *fmi3GetVersion(void) { return "3.0"; }

fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean defined, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean stop_defined,
                                       fmi3Float64 stop)
{
    (void)defined; (void)tolerance; (void)stop_defined; (void)stop;
    ((instance *)c)->p->time = start;
    return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance c)
{
    return (fmi3Status)probe_start(((instance *)c)->p);
}

fmi3Status fmi3Terminate(fmi3Instance c) { (void)c; return fmi3OK; }

fmi3Status fmi3Reset(fmi3Instance c)
{
    probe *p = ((instance *)c)->p;
    int64_t status = p->whole[RESET_STATUS];
    probe_reset(p);
    p->whole[RUNS]++;
    return (fmi3Status)status;
}

fmi3Status fmi3EnterEventMode(fmi3Instance c) { (void)c; return fmi3OK; }

fmi3Status fmi3EnterStepMode(fmi3Instance c) { (void)c; return fmi3OK; }

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, fmi3Boolean *again, fmi3Boolean *terminate,
                                    fmi3Boolean *nominals, fmi3Boolean *states,
                                    fmi3Boolean *defined, fmi3Float64 *next)
{
    (void)next;
    *nominals = *states = *defined = false;
    /* an event that never ends */
    *again = ((instance *)c)->p->whole[FAIL_STATUS] == -4
        && ((instance *)c)->p->time >= ((instance *)c)->p->real[FAIL_TIME];
    /* asks for the end at its second event */
    *terminate = ((instance *)c)->p->whole[FAIL_STATUS] == -2
        && ((instance *)c)->p->time >= ((instance *)c)->p->real[FAIL_TIME];
    return fmi3OK;
}

/* FAIL_STATUS -1: ends every step where it begins; -2: an event at FAIL_TIME; -3: asks for the end;
   -4: an event at FAIL_TIME that never ends; -5: as -1, whether it may or not. */
fmi3Status fmi3DoStep(fmi3Instance self, fmi3Float64 time, fmi3Float64 size, fmi3Boolean prior,
                      fmi3Boolean *event, fmi3Boolean *terminate, fmi3Boolean *early,
                      fmi3Float64 *reached)
{
    instance *c = self;
    (void)prior;
    double at = c->p->real[FAIL_TIME];
    int64_t way = c->p->whole[FAIL_STATUS];
    *event = *terminate = *early = false;
    if ((way == -5 || (c->early && way == -1)) && time + size > at) {
        size = 0.0;
        *early = true;
    } else if (c->early && (way == -2 || way == -4) && time < at && time + size >= at) {
        size = at - time;
        *event = *early = true;
    }
    *terminate = way == -3 && time + size > at;
    fmi3Status status = (fmi3Status)probe_step(c->p, time, size);
    *reached = c->p->time;
    return status;
}

#define ACCESS(name, kind, field)                                                                   \
    fmi3Status fmi3Get##name(fmi3Instance c, const fmi3ValueReference r[], size_t n, kind v[],      \
                             size_t size)                                                           \
    {                                                                                               \
        (void)size;                                                                                 \
        probe_evaluate(((instance *)c)->p);                                                         \
        for (size_t i = 0; i < n; i++) {                                                            \
            v[i] = (kind)((instance *)c)->p->field[r[i] % 100];                                     \
        }                                                                                           \
        return fmi3OK;                                                                              \
    }                                                                                               \
    fmi3Status fmi3Set##name(fmi3Instance c, const fmi3ValueReference r[], size_t n,                \
                             const kind v[], size_t size)                                           \
    {                                                                                               \
        (void)size;                                                                                 \
        for (size_t i = 0; i < n; i++) {                                                            \
            ((instance *)c)->p->field[r[i] % 100] = v[i];                                           \
        }                                                                                           \
        return fmi3OK;                                                                              \
    }

ACCESS(Float64, fmi3Float64, real)
ACCESS(Float32, fmi3Float32, real)
ACCESS(Int8, fmi3Int8, whole)
ACCESS(Int32, fmi3Int32, whole)
ACCESS(Int64, fmi3Int64, whole)
ACCESS(Boolean, fmi3Boolean, flag)

fmi3Status fmi3GetString(fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3String v[],
                         size_t size)
{
    (void)r; (void)size;
    for (size_t i = 0; i < n; i++) {
        v[i] = ((instance *)c)->p->text;
    }
    return fmi3OK;
}

fmi3Status fmi3SetString(fmi3Instance c, const fmi3ValueReference r[], size_t n,
                         const fmi3String v[], size_t size)
{
    (void)r; (void)n; (void)size;
    char *text = ((instance *)c)->p->text;
    strncpy(text, v[0], sizeof ((instance *)c)->p->text - 1);
    return fmi3OK;
}
