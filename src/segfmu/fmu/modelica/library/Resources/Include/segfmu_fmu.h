/* An unpacked FMU of FMI 2.0 model exchange as functions of time, states and inputs, for external
   objects of Modelica. Every function sets what its result follows from, so that the order in which
   a tool calls them does not matter. */
#ifndef SEGFMU_FMU_H
#define SEGFMU_FMU_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ModelicaUtilities.h"

#if defined(_WIN32)
#include <windows.h>
#define SEGFMU_SUFFIX ".dll"
#define SEGFMU_FOLDERS "win64"
#else
#include <dlfcn.h>
#if defined(__APPLE__)
#define SEGFMU_SUFFIX ".dylib"
/* the first one has both processors where both are built */
#define SEGFMU_FOLDERS "darwin64", "aarch64-darwin"
#elif defined(__aarch64__)
#define SEGFMU_SUFFIX ".so"
#define SEGFMU_FOLDERS "aarch64-linux"
#else
#define SEGFMU_SUFFIX ".so"
#define SEGFMU_FOLDERS "linux64"
#endif
#endif

/* no event; a time that Modelica's simulations do not reach */
#define SEGFMU_NEVER 1e60

/* an address has up to three characters for one of a path */
enum { SEGFMU_PATH = 4096, SEGFMU_ADDRESS = 3 * SEGFMU_PATH, SEGFMU_MESSAGE = 1000 };
enum { SEGFMU_MODEL_EXCHANGE = 0, SEGFMU_WARNING = 1 };

/* what an instance is ready for */
enum { SEGFMU_OPENED, SEGFMU_INITIALISATION, SEGFMU_EVENTS, SEGFMU_INTEGRATION };

/* types of FMI 2.0 */
typedef void (*segfmu_logger)(void *environment, const char *instance, int status,
                              const char *category, const char *format, ...);
typedef struct {
    segfmu_logger log;
    void *(*allocate)(size_t count, size_t size);
    void (*release)(void *memory);
    void (*finished)(void *environment, int status);
    void *environment;
} segfmu_callbacks;
typedef struct {
    int again, terminate, nominals_changed, states_changed, next_defined;
    double next;
} segfmu_event_info;

typedef struct {
    void *library, *component;
    segfmu_callbacks callbacks;
    int phase;
    size_t count;           /* of the states */
    double time, *states;   /* that the FMU has */
    char instance[SEGFMU_MESSAGE], message[SEGFMU_MESSAGE];
    void *(*instantiate)(const char *, int, const char *, const char *, const segfmu_callbacks *,
                         int, int);
    void (*release)(void *);
    int (*setup)(void *, int, double, double, int, double);
    int (*enter_initialization)(void *), (*exit_initialization)(void *), (*reset)(void *);
    int (*enter_events)(void *), (*enter_integration)(void *);
    int (*update)(void *, segfmu_event_info *);
    int (*set_time)(void *, double);
    int (*set_states)(void *, const double *, size_t), (*get_states)(void *, double *, size_t);
    int (*get_derivatives)(void *, double *, size_t);
    int (*accept)(void *, int, int *, int *);
    int (*set_reals)(void *, const unsigned *, size_t, const double *);
    int (*get_reals)(void *, const unsigned *, size_t, double *);
    int (*set_integers)(void *, const unsigned *, size_t, const int *);
    int (*get_integers)(void *, const unsigned *, size_t, int *);
    int (*set_booleans)(void *, const unsigned *, size_t, const int *);
    int (*get_booleans)(void *, const unsigned *, size_t, int *);
} segfmu_fmu;

/* ---- opening ---- */

static void segfmu_log(void *environment, const char *instance, int status, const char *category,
                       const char *format, ...)
{
    segfmu_fmu *f = (segfmu_fmu *)environment;
    va_list arguments;
    (void)category;
    va_start(arguments, format);
    vsnprintf(f->message, sizeof f->message, format, arguments);
    va_end(arguments);
    if (status == SEGFMU_WARNING) {
        ModelicaFormatMessage("%s: warning: %s\n", instance, f->message);
    }
}

/* What a function of the FMU returned; errors end the simulation or let the solver try again. */
static void segfmu_check(segfmu_fmu *f, int status, const char *what)
{
    if (status > SEGFMU_WARNING && f->message[0] != '\0') {
        ModelicaFormatError("%s: %s", f->instance, f->message);
    } else if (status > SEGFMU_WARNING) {
        ModelicaFormatError("%s: the FMU refuses the %s", f->instance, what);
    }
}

/* The folder of the unpacked FMU: the given one, or that which the package keeps beside this file. */
static void segfmu_folder(char *path, const char *folder, const char *name)
{
    const char *own = __FILE__, *end = own + strlen(own);
    while (end > own && end[-1] != '/' && end[-1] != '\\') {
        end--;
    }
    if (folder[0] != '\0') {
        snprintf(path, SEGFMU_PATH, "%s", folder);
    } else {
        snprintf(path, SEGFMU_PATH, "%.*s../FMUs/%s", (int)(end - own), own, name);
    }
}

/* The address of the FMU's resources as the standard has it. */
static void segfmu_resources(char *address, const char *folder)
{
    char path[SEGFMU_PATH];
    char *to = address + sprintf(address, "file://");
#if defined(_WIN32)
    if (_fullpath(path, folder, sizeof path) == NULL) {
        snprintf(path, sizeof path, "%s", folder);
    }
    *to++ = '/';
#else
    char *full = realpath(folder, NULL);
    snprintf(path, sizeof path, "%s", full == NULL ? folder : full);
    free(full);
#endif
    strncat(path, "/resources", sizeof path - strlen(path) - 1);
    for (const char *from = path; *from != '\0'; from++) {
        if (*from == '\\') {
            *to++ = '/';
        } else if (*from <= ' ' || *from > '~' || strchr("%#?\"<>", *from) != NULL) {
            to += sprintf(to, "%%%02X", (unsigned char)*from);
        } else {
            *to++ = *from;
        }
    }
    *to = '\0';
}

/* Addresses of functions and of data differ in type, so they are copied as bytes. */
static void segfmu_bind(segfmu_fmu *f, const char *name, void *function)
{
#if defined(_WIN32)
    FARPROC found = GetProcAddress((HMODULE)f->library, name);
#else
    void *found = dlsym(f->library, name);
#endif
    if (found == NULL) {
        ModelicaFormatError("the FMU has no function %s", name);
    }
    memcpy(function, &found, sizeof found);
}

static void segfmu_load(segfmu_fmu *f, const char *folder, const char *name)
{
    static const char *const folders[] = {SEGFMU_FOLDERS};
    const char *reason = "it cannot be loaded";
    char path[2 * SEGFMU_PATH];
    for (size_t i = 0; i < sizeof folders / sizeof *folders && f->library == NULL; i++) {
        snprintf(path, sizeof path, "%s/binaries/%s/%s%s", folder, folders[i], name, SEGFMU_SUFFIX);
#if defined(_WIN32)
        f->library = (void *)LoadLibraryA(path);
#else
        f->library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
        reason = f->library == NULL ? dlerror() : "";
#endif
    }
    if (f->library == NULL) {
        ModelicaFormatError("%s: %s; the parameter folder takes the folder of the unpacked FMU",
                            path, reason);
    }
}

static void segfmu_bind_all(segfmu_fmu *f)
{
    segfmu_bind(f, "fmi2Instantiate", &f->instantiate);
    segfmu_bind(f, "fmi2FreeInstance", &f->release);
    segfmu_bind(f, "fmi2SetupExperiment", &f->setup);
    segfmu_bind(f, "fmi2EnterInitializationMode", &f->enter_initialization);
    segfmu_bind(f, "fmi2ExitInitializationMode", &f->exit_initialization);
    segfmu_bind(f, "fmi2Reset", &f->reset);
    segfmu_bind(f, "fmi2EnterEventMode", &f->enter_events);
    segfmu_bind(f, "fmi2EnterContinuousTimeMode", &f->enter_integration);
    segfmu_bind(f, "fmi2NewDiscreteStates", &f->update);
    segfmu_bind(f, "fmi2SetTime", &f->set_time);
    segfmu_bind(f, "fmi2SetContinuousStates", &f->set_states);
    segfmu_bind(f, "fmi2GetContinuousStates", &f->get_states);
    segfmu_bind(f, "fmi2GetDerivatives", &f->get_derivatives);
    segfmu_bind(f, "fmi2CompletedIntegratorStep", &f->accept);
    segfmu_bind(f, "fmi2SetReal", &f->set_reals);
    segfmu_bind(f, "fmi2GetReal", &f->get_reals);
    segfmu_bind(f, "fmi2SetInteger", &f->set_integers);
    segfmu_bind(f, "fmi2GetInteger", &f->get_integers);
    segfmu_bind(f, "fmi2SetBoolean", &f->set_booleans);
    segfmu_bind(f, "fmi2GetBoolean", &f->get_booleans);
}

/* An instance; `token` identifies the description that the Modelica class was made from. */
static void *segfmu_open(const char *folder, const char *name, const char *instance,
                         const char *token, int states)
{
    char path[SEGFMU_PATH], address[SEGFMU_ADDRESS];
    segfmu_fmu *f = (segfmu_fmu *)calloc(1, sizeof *f);
    double *memory = (double *)calloc((size_t)states + 1, sizeof *memory);
    if (f == NULL || memory == NULL) {
        free(f);
        free(memory);
        ModelicaError("out of memory");
    }
    snprintf(f->instance, sizeof f->instance, "%s", instance);
    f->states = memory;
    f->count = (size_t)states;
    segfmu_folder(path, folder, name);
    segfmu_resources(address, path);
    segfmu_load(f, path, name);
    segfmu_bind_all(f);
    f->callbacks.log = segfmu_log;
    f->callbacks.allocate = calloc;
    f->callbacks.release = free;
    f->callbacks.environment = f;
    f->component = f->instantiate(instance, SEGFMU_MODEL_EXCHANGE, token, address, &f->callbacks,
                                  0, 0);
    if (f->component == NULL) {
        ModelicaFormatError("%s: %s: %s; class and FMU come from one run of segfmu build --modelica",
                            instance, path, f->message);
    }
    return f;
}

static void segfmu_close(void *object)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    if (f == NULL) {
        return;
    }
    f->release(f->component);
#if defined(_WIN32)
    FreeLibrary((HMODULE)f->library);
#else
    dlclose(f->library);
#endif
    free(f->states);
    free(f);
}

/* ---- what the FMU's results follow from ---- */

/* Inputs that change; setting the present values again would have the FMU calculate anew. */
static void segfmu_set_inputs(segfmu_fmu *f, const int *references, const double *values,
                              size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const unsigned reference = (unsigned)references[i];
        double present = 0.0;
        segfmu_check(f, f->get_reals(f->component, &reference, 1, &present), "inputs");
        if (present != values[i]) {
            segfmu_check(f, f->set_reals(f->component, &reference, 1, &values[i]), "inputs");
        }
    }
}

static void segfmu_set(segfmu_fmu *f, double time, const double *states, size_t count,
                       const int *references, const double *inputs, size_t input_count)
{
    if (f->phase == SEGFMU_OPENED) {
        ModelicaError("the FMU was used before its initialisation");
    }
    if (time != f->time) {
        segfmu_check(f, f->set_time(f->component, time), "time");
        f->time = time;
    }
    if (count > 0 && memcmp(states, f->states, count * sizeof *states) != 0) {
        segfmu_check(f, f->set_states(f->component, states, count), "states");
        memcpy(f->states, states, count * sizeof *states);
    }
    segfmu_set_inputs(f, references, inputs, input_count);
}

/* ---- the functions of the Modelica package ---- */

/* Begin the initialisation with these parameters, as often as the tool wants to. */
static double segfmu_start(void *object, double time, const int *real_references,
                           const double *reals, size_t real_count, const int *integer_references,
                           const int *integers, size_t integer_count,
                           const int *boolean_references, const int *booleans,
                           size_t boolean_count)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    if (f->phase != SEGFMU_OPENED) {
        segfmu_check(f, f->reset(f->component), "reset");
    }
    f->phase = SEGFMU_OPENED;
    segfmu_check(f, f->setup(f->component, 0, 0.0, time, 0, 0.0), "start time");
    segfmu_check(f, f->set_reals(f->component, (const unsigned *)real_references, real_count,
                                 reals), "parameters");
    segfmu_check(f, f->set_integers(f->component, (const unsigned *)integer_references,
                                    integer_count, integers), "parameters");
    segfmu_check(f, f->set_booleans(f->component, (const unsigned *)boolean_references,
                                    boolean_count, booleans), "parameters");
    segfmu_check(f, f->enter_initialization(f->component), "initialisation");
    f->phase = SEGFMU_INITIALISATION;
    f->time = time;
    segfmu_check(f, f->get_states(f->component, f->states, f->count), "states");
    return time;
}

/* The states at the start, under the inputs that they can follow from. */
static void segfmu_states(void *object, const int *references, const double *inputs,
                          size_t input_count, double *states, size_t count)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    segfmu_set_inputs(f, references, inputs, input_count);
    segfmu_check(f, f->get_states(f->component, f->states, count), "states");
    memcpy(states, f->states, count * sizeof *states);
}

/* End the initialisation, under all inputs. */
static double segfmu_begin(void *object, const int *references, const double *inputs,
                           size_t input_count)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    segfmu_set_inputs(f, references, inputs, input_count);
    if (f->phase == SEGFMU_INITIALISATION) {
        segfmu_check(f, f->exit_initialization(f->component), "initialisation");
        f->phase = SEGFMU_EVENTS;
        segfmu_check(f, f->get_states(f->component, f->states, f->count), "states");
    }
    return f->time;
}

/* The event at a time; the time of the next one. */
static double segfmu_event(void *object, double time, const double *states, size_t count,
                           const int *references, const double *inputs, size_t input_count)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    segfmu_event_info info = {0};
    int event = 0, end = 0;
    segfmu_set(f, time, states, count, references, inputs, input_count);
    if (f->phase == SEGFMU_INTEGRATION) {
        segfmu_check(f, f->accept(f->component, 1, &event, &end), "step");
        segfmu_check(f, f->enter_events(f->component), "event");
        f->phase = SEGFMU_EVENTS;
    }
    do {
        segfmu_check(f, f->update(f->component, &info), "event");
    } while (info.again);
    segfmu_check(f, f->enter_integration(f->component), "event");
    f->phase = SEGFMU_INTEGRATION;
    return info.next_defined ? info.next : SEGFMU_NEVER;
}

static void segfmu_derivatives(void *object, double time, const double *states, size_t count,
                               const int *references, const double *inputs, size_t input_count,
                               double *derivatives)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    segfmu_set(f, time, states, count, references, inputs, input_count);
    segfmu_check(f, f->get_derivatives(f->component, derivatives, count), "derivatives");
}

static void segfmu_reals(void *object, double time, const double *states, size_t count,
                         const int *references, const double *inputs, size_t input_count,
                         const int *wanted, double *values, size_t wanted_count)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    segfmu_set(f, time, states, count, references, inputs, input_count);
    segfmu_check(f, f->get_reals(f->component, (const unsigned *)wanted, wanted_count, values),
                 "outputs");
}

static int segfmu_integer(void *object, int reference)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    const unsigned wanted = (unsigned)reference;
    int value = 0;
    segfmu_check(f, f->get_integers(f->component, &wanted, 1, &value), "outputs");
    return value;
}

static int segfmu_boolean(void *object, int reference)
{
    segfmu_fmu *f = (segfmu_fmu *)object;
    const unsigned wanted = (unsigned)reference;
    int value = 0;
    segfmu_check(f, f->get_booleans(f->component, &wanted, 1, &value), "outputs");
    return value;
}

#endif
