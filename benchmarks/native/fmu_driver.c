/* An importer without Python: loads an FMI 2.0 co-simulation FMU, initialises it and steps it. */
#define _POSIX_C_SOURCE 200809L
#include <dlfcn.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>

#include "fmi2FunctionTypes.h"

typedef struct {
    const char *library, *token, *resources;
    size_t inputs, outputs;
    const uint32_t *input_references, *output_references;
    const double *input_values;
    int64_t steps;
    double step;
} job;

static void silent(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status,
                   fmi2String category, fmi2String message, ...)
{
    (void)environment;
    (void)name;
    (void)status;
    (void)category;
    (void)message;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* dlsym gives object pointers, which ISO C does not turn into those of functions */
#define FIND(name) *(void **)&name = dlsym(library, "fmi2" #name); if (name == NULL) return -2

/* times (2): of initialisation, of all steps with inputs set and outputs read [s]. Returns 0, or a
   negative number that says what failed. */
int measure(const job *j, double times[2])
{
    fmi2InstantiateTYPE *Instantiate;
    fmi2FreeInstanceTYPE *FreeInstance;
    fmi2SetupExperimentTYPE *SetupExperiment;
    fmi2EnterInitializationModeTYPE *EnterInitializationMode;
    fmi2ExitInitializationModeTYPE *ExitInitializationMode;
    fmi2SetRealTYPE *SetReal;
    fmi2GetRealTYPE *GetReal;
    fmi2DoStepTYPE *DoStep;
    fmi2CallbackFunctions functions = {silent, calloc, free, NULL, NULL};
    void *library = dlopen(j->library, RTLD_NOW | RTLD_LOCAL);
    double *found = calloc(j->outputs + 1, sizeof *found);
    if (library == NULL) {
        return -1;
    }
    FIND(Instantiate);
    FIND(FreeInstance);
    FIND(SetupExperiment);
    FIND(EnterInitializationMode);
    FIND(ExitInitializationMode);
    FIND(SetReal);
    FIND(GetReal);
    FIND(DoStep);
    fmi2Component c = Instantiate("one", fmi2CoSimulation, j->token, j->resources, &functions, 0, 0);
    if (c == NULL) {
        return -3;
    }
    int failed = 0;
    double start = now();
    failed |= SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0) > fmi2Warning
        || EnterInitializationMode(c) > fmi2Warning || ExitInitializationMode(c) > fmi2Warning;
    times[0] = now() - start;
    start = now();
    for (int64_t i = 0; i < j->steps && !failed; i++) {
        failed |= SetReal(c, j->input_references, j->inputs, j->input_values) > fmi2Warning;
        failed |= DoStep(c, (double)i * j->step, j->step, 1) > fmi2Warning;
        failed |= GetReal(c, j->output_references, j->outputs, found) > fmi2Warning;
    }
    times[1] = now() - start;
    FreeInstance(c);
    free(found);
    dlclose(library);
    return failed ? -4 : 0;
}
