/* A small importer: steps GantryFeedforward and GantryCrane from their libraries, one after the
   other, and prints what the crane gives. Compiled with -DFMI=2 or -DFMI=3.

   pair <library> <token> <library> <token> <steps> <step> <out:in>... : <seen>...
   (value references; outputs of the first go to inputs of the second). */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#define OPEN(path) ((void *)LoadLibraryA(path))
#define LOOK(library, name) ((void *)GetProcAddress((HMODULE)(library), name))
#else
#include <dlfcn.h>
#define OPEN(path) dlopen(path, RTLD_NOW | RTLD_LOCAL)
#define LOOK(library, name) dlsym(library, name)
#endif

#if FMI == 2
#include "fmi2FunctionTypes.h"
#define NAME(name) fmi2##name
#define SYMBOL(name) "fmi2" #name
#else
#include "fmi3FunctionTypes.h"
#define NAME(name) fmi3##name
#define SYMBOL(name) "fmi3" #name
#endif

enum { MOST = 100, GOOD = 1 };

typedef struct {
    void *library, *instance;
} unit;

static void fail(const char *what, const char *which)
{
    printf("failed: %s %s\n", what, which);
    exit(1);
}

static void *find(unit *u, const char *name)
{
    void *found = LOOK(u->library, name);
    if (found == NULL) {
        fail("no function", name);
    }
    return found;
}

/* The function of a unit with its type; a status above warning ends the program. */
#define CALL(u, name, ...) \
    do { \
        NAME(name##TYPE) *f_ = NULL; \
        void *found_ = find(u, SYMBOL(name)); \
        memcpy(&f_, &found_, sizeof f_); \
        if ((int)f_((u)->instance, __VA_ARGS__) > GOOD) fail("status of", #name); \
    } while (0)
#define CALL_ALONE(u, name) \
    do { \
        NAME(name##TYPE) *f_ = NULL; \
        void *found_ = find(u, SYMBOL(name)); \
        memcpy(&f_, &found_, sizeof f_); \
        if ((int)f_((u)->instance) > GOOD) fail("status of", #name); \
    } while (0)

#if FMI == 2
static void say(void *environment, fmi2String name, fmi2Status status, fmi2String category,
                fmi2String message, ...)
{
    (void)environment;
    (void)category;
    printf("%s, status %d: %s\n", name, (int)status, message);
}
static const fmi2CallbackFunctions FUNCTIONS = {say, calloc, free, NULL, NULL};
#else
static void say(void *environment, fmi3Status status, fmi3String category, fmi3String message)
{
    (void)environment;
    (void)category;
    printf("status %d: %s\n", (int)status, message);
}
#endif

static void create(unit *u, const char *path, const char *token, const char *resources)
{
    u->library = OPEN(path);
    if (u->library == NULL) {
        fail("cannot load", path);
    }
#if FMI == 2
    void *found = find(u, "fmi2Instantiate");
    fmi2InstantiateTYPE *make = NULL;
    memcpy(&make, &found, sizeof make);
    u->instance = make("one", fmi2CoSimulation, token, resources, &FUNCTIONS, fmi2False, fmi2False);
#else
    void *found = find(u, "fmi3InstantiateCoSimulation");
    fmi3InstantiateCoSimulationTYPE *make = NULL;
    memcpy(&make, &found, sizeof make);
    u->instance = make("one", token, resources, fmi3False, fmi3False, fmi3False, fmi3False, NULL, 0, NULL,
                       say, NULL);
#endif
    if (u->instance == NULL) {
        fail("cannot instantiate", path);
    }
}

static void begin(unit *u)
{
#if FMI == 2
    CALL(u, SetupExperiment, fmi2False, 0.0, 0.0, fmi2False, 0.0);
    CALL_ALONE(u, EnterInitializationMode);
#else
    CALL(u, EnterInitializationMode, fmi3False, 0.0, 0.0, fmi3False, 0.0);
#endif
}

static void step(unit *u, double time, double length)
{
#if FMI == 2
    CALL(u, DoStep, time, length, fmi2True);
#else
    fmi3Boolean event, end, early;
    double reached;
    CALL(u, DoStep, time, length, fmi3True, &event, &end, &early, &reached);
#endif
}

static void get(unit *u, const uint32_t references[], size_t count, double values[])
{
#if FMI == 2
    CALL(u, GetReal, references, count, values);
#else
    CALL(u, GetFloat64, references, count, values, count);
#endif
}

static void set(unit *u, const uint32_t references[], size_t count, const double values[])
{
#if FMI == 2
    CALL(u, SetReal, references, count, values);
#else
    CALL(u, SetFloat64, references, count, values, count);
#endif
}

int main(int count, char **words)
{
    unit source, sink;
    uint32_t from[MOST], to[MOST], seen[MOST];
    double values[MOST];
    size_t links = 0, wanted = 0;
    int i = 9;
    if (count < 11) {
        fail("arguments", "");
    }
    for (; i < count && strcmp(words[i], ":") != 0 && links < MOST; i++, links++) {
        from[links] = (uint32_t)strtoul(words[i], NULL, 10);
        to[links] = (uint32_t)strtoul(strchr(words[i], ':') + 1, NULL, 10);
    }
    for (i++; i < count && wanted < MOST; i++, wanted++) {
        seen[wanted] = (uint32_t)strtoul(words[i], NULL, 10);
    }
    create(&source, words[1], words[2], words[3]);
    create(&sink, words[4], words[5], words[6]);
    long steps = strtol(words[7], NULL, 10);
    double length = strtod(words[8], NULL);
    begin(&source);
    begin(&sink);
    CALL_ALONE(&source, ExitInitializationMode);
    get(&source, from, links, values);
    set(&sink, to, links, values);
    CALL_ALONE(&sink, ExitInitializationMode);
    for (long k = 0; k < steps; k++) {
        step(&source, (double)k * length, length);
        get(&source, from, links, values);
        set(&sink, to, links, values);
        step(&sink, (double)k * length, length);
        get(&sink, seen, wanted, values);
        for (size_t n = 0; k % 20 == 19 && n < wanted; n++) {
            printf("%.17g%c", values[n], n + 1 < wanted ? ' ' : '\n');
        }
    }
    return 0;
}
