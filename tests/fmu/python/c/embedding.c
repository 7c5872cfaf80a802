/* An importer without Python, as PythonFMU's library finds it: loads libpython for the library's
   symbols, initialises an FMI 2.0 co-simulation FMU, steps it and ends. */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

#include "fmi2FunctionTypes.h"

static void silent(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status,
                   fmi2String category, fmi2String message, ...)
{
    (void)environment;
    (void)name;
    (void)status;
    (void)category;
    (void)message;
}

/* dlsym gives object pointers, which ISO C does not turn into those of functions */
#define FIND(name) *(void **)&name = dlsym(library, "fmi2" #name); if (name == NULL) return 2

/* arguments: libpython, the FMU's library, its token, its resources */
int main(int count, char **argument)
{
    fmi2InstantiateTYPE *Instantiate;
    fmi2FreeInstanceTYPE *FreeInstance;
    fmi2SetupExperimentTYPE *SetupExperiment;
    fmi2EnterInitializationModeTYPE *EnterInitializationMode;
    fmi2ExitInitializationModeTYPE *ExitInitializationMode;
    fmi2DoStepTYPE *DoStep;
    fmi2CallbackFunctions functions = {silent, calloc, free, NULL, NULL};
    if (count != 5 || dlopen(argument[1], RTLD_NOW | RTLD_GLOBAL) == NULL) {
        return 2;
    }
    void *library = dlopen(argument[2], RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        return 2;
    }
    FIND(Instantiate);
    FIND(FreeInstance);
    FIND(SetupExperiment);
    FIND(EnterInitializationMode);
    FIND(ExitInitializationMode);
    FIND(DoStep);
    fmi2Component c = Instantiate("one", fmi2CoSimulation, argument[3], argument[4], &functions, 0,
                                  0);
    if (c == NULL) {
        return 3;
    }
    if (SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0) != fmi2OK || EnterInitializationMode(c) != fmi2OK
        || ExitInitializationMode(c) != fmi2OK || DoStep(c, 0.0, 1e-3, 1) != fmi2OK) {
        return 4;
    }
    FreeInstance(c);
    dlclose(library);
    puts("done");
    return 0;
}
