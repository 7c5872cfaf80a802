#include "fmi2Functions.h"
#include "probe.h"

static void say2(void *environment, int status, const char *message)
{
    const fmi2CallbackFunctions *functions = environment;
    functions->logger(functions->componentEnvironment, "probe", (fmi2Status)status, "logAll",
                      message);
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean logging)
{
    (void)name; (void)type; (void)guid; (void)resources; (void)visible; (void)logging;
    return probe_made((void *)functions, say2);
}

void fmi2FreeInstance(fmi2Component c) { free(c); }

const char *fmi2GetVersion(void) { return "2.0"; }

const char *fmi2GetTypesPlatform(void) { return "default"; }

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop)
{
    (void)defined; (void)tolerance; (void)stop_defined; (void)stop;
    ((probe *)c)->time = start;
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) { (void)c; return fmi2OK; }

fmi2Status fmi2ExitInitializationMode(fmi2Component c) { return (fmi2Status)probe_start(c); }

fmi2Status fmi2Terminate(fmi2Component c) { (void)c; return fmi2OK; }

fmi2Status fmi2Reset(fmi2Component c)
{
    probe *p = c;
    int64_t status = p->whole[RESET_STATUS];
    probe_reset(p);
    p->whole[RUNS]++;
    return (fmi2Status)status;
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real size, fmi2Boolean prior)
{
    (void)prior;
    return (fmi2Status)probe_step(c, time, size);
}

#define ACCESS(name, kind, field)                                                           \
    fmi2Status fmi2Get##name(fmi2Component c, const fmi2ValueReference r[], size_t n, kind v[])     \
    {                                                                                               \
        probe_evaluate(c);                                                                          \
        for (size_t i = 0; i < n; i++) {                                                            \
            v[i] = (kind)((probe *)c)->field[r[i]];                                                 \
        }                                                                                           \
        return fmi2OK;                                                                              \
    }                                                                                               \
    fmi2Status fmi2Set##name(fmi2Component c, const fmi2ValueReference r[], size_t n,               \
                             const kind v[])                                                        \
    {                                                                                               \
        for (size_t i = 0; i < n; i++) {                                                            \
            ((probe *)c)->field[r[i]] = v[i];                                                       \
        }                                                                                           \
        return fmi2OK;                                                                              \
    }

ACCESS(Real, fmi2Real, real)
ACCESS(Integer, fmi2Integer, whole)
ACCESS(Boolean, fmi2Boolean, flag)

fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2String v[])
{
    (void)r;
    for (size_t i = 0; i < n; i++) {
        v[i] = ((probe *)c)->text;
    }
    return fmi2OK;
}

fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference r[], size_t n,
                         const fmi2String v[])
{
    (void)r; (void)n;
    strncpy(((probe *)c)->text, v[0], sizeof ((probe *)c)->text - 1);
    return fmi2OK;
}
