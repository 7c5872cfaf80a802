/* An FMU that does nothing: what a call costs without a model. One output, equal to the time. */
#include "fmi2FunctionTypes.h"

#include <stdlib.h>

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean logging)
{
    (void)name; (void)type; (void)guid; (void)resources; (void)functions; (void)visible;
    (void)logging;
    return calloc(1, sizeof(double));
}

void fmi2FreeInstance(fmi2Component c)
{
    free(c);
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop)
{
    (void)tolerance_defined; (void)tolerance; (void)stop_defined; (void)stop;
    *(double *)c = start;
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
    (void)c;
    return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    (void)c;
    return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component c)
{
    (void)c;
    return fmi2OK;
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[])
{
    (void)c; (void)references; (void)count; (void)values;
    return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference references[], size_t count,
                       fmi2Real values[])
{
    (void)references;
    for (size_t i = 0; i < count; i++) {
        values[i] = *(double *)c;
    }
    return fmi2OK;
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean keep)
{
    (void)keep;
    *(double *)c = time + step;
    return fmi2OK;
}

const char *fmi2GetTypesPlatform(void)
{
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void)
{
    return "2.0";
}

/* importers look for all functions; these are not called */
#define REFUSE(name) fmi2Status name(void); fmi2Status name(void) { return fmi2Error; }
REFUSE(fmi2SetDebugLogging) REFUSE(fmi2Reset) REFUSE(fmi2GetInteger)
REFUSE(fmi2GetBoolean) REFUSE(fmi2GetString) REFUSE(fmi2SetInteger) REFUSE(fmi2SetBoolean)
REFUSE(fmi2SetString) REFUSE(fmi2GetFMUstate) REFUSE(fmi2SetFMUstate) REFUSE(fmi2FreeFMUstate)
REFUSE(fmi2SerializedFMUstateSize) REFUSE(fmi2SerializeFMUstate) REFUSE(fmi2DeSerializeFMUstate)
REFUSE(fmi2GetDirectionalDerivative) REFUSE(fmi2EnterEventMode) REFUSE(fmi2NewDiscreteStates)
REFUSE(fmi2EnterContinuousTimeMode) REFUSE(fmi2CompletedIntegratorStep) REFUSE(fmi2SetTime)
REFUSE(fmi2SetContinuousStates) REFUSE(fmi2GetDerivatives) REFUSE(fmi2GetEventIndicators)
REFUSE(fmi2GetContinuousStates) REFUSE(fmi2GetNominalsOfContinuousStates)
REFUSE(fmi2SetRealInputDerivatives) REFUSE(fmi2GetRealOutputDerivatives) REFUSE(fmi2CancelStep)
REFUSE(fmi2GetStatus) REFUSE(fmi2GetRealStatus) REFUSE(fmi2GetIntegerStatus)
REFUSE(fmi2GetBooleanStatus) REFUSE(fmi2GetStringStatus)
