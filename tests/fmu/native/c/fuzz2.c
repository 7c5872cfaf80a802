/* Random sequences of calls of FMI 2.0: each must end with a status, none may crash. */
#include <stdio.h>
#include <string.h>

/* the whole FMU, so that its tables are at hand */
#include "fmu.c"
#include "random.h"

enum { MOST = 6, CALLS = 40, FOLDER = 3 };

static long messages;
static start_values starts;
static const char *resources;

static void hear(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status,
                 fmi2String category, fmi2String message, ...)
{
    (void)environment;
    if (name == NULL || category == NULL || message == NULL || message[0] == '\0'
        || strchr(message, '%') != NULL || strlen(message) > 800 || status > fmi2Fatal) {
        abort();
    }
    messages++;
}

static fmi2Component component;
static fmi2FMUstate saved;
static fmi2ValueReference references[MOST];
static fmi2Real reals[64];
static fmi2Integer wholes[MOST];
static fmi2String strings[MOST];
static char *bytes;
static size_t stored;
static double now;
static int exchange;

static void choose(void)
{
    /* mostly one kind of call: values that are fine, or anything */
    int fine = below(3) > 0;
    for (int i = 0; i < MOST; i++) {
        references[i] = random_reference((int)starts.variables);
        wholes[i] = random_integer();
    }
    for (int i = 0; i < 64; i++) {
        reals[i] = fine ? unit() : random_real();
    }
}

static void instantiate(void)
{
    fmi2CallbackFunctions functions = {hear, calloc, free, NULL, NULL};
    int type = below(2);
    exchange = type == fmi2ModelExchange;
    component = fmi2Instantiate(rarely() ? NULL : "one", (fmi2Type)type,
                                rarely() ? "other" : starts.token,
                                rarely() ? NULL : resources,
                                rarely() ? NULL : &functions, fmi2False, below(2));
    now = 0.0;
}

static void store(void)
{
    size_t size = 0;
    if (saved == NULL || fmi2SerializedFMUstateSize(component, saved, &size) != fmi2OK) {
        return;
    }
    bytes = realloc(bytes, size);
    stored = fmi2SerializeFMUstate(component, saved, bytes, size) == fmi2OK ? size : 0;
}

static void load(void)
{
    fmi2FMUstate found = NULL;
    if (stored > 0) {
        if (below(2)) {
            bytes[random_word() % stored] ^= (char)(1 << below(8));
        }
        fmi2DeSerializeFMUstate(component, bytes, below(4) ? stored : stored / 2, &found);
    }
    if (found != NULL) {
        fmi2SetFMUstate(component, found);
        fmi2FreeFMUstate(component, &found);
    }
}

/* Set a parameter to something near its start value, or to anything. */
static void tune(void)
{
    fmi2ValueReference one = 1 + (fmi2ValueReference)below((int)starts.variables);
    const variable *v = glue_variable(one);
    if (v->kind == KIND_REAL) {
        double near = starts.real[v->offset] * (0.5 + unit()) + (below(3) ? 0.0 : 0.1 * unit());
        fmi2Real value = below(8) ? near : random_real();
        fmi2SetReal(component, &one, 1, &value);
    } else {
        fmi2Integer value = below(8) ? 1 + below(4) : random_integer();
        if (v->kind == KIND_BOOLEAN) {
            fmi2SetBoolean(component, &one, 1, &value);
        } else {
            fmi2SetInteger(component, &one, 1, &value);
        }
    }
}

/* One call; NULL pointers, wrong sizes and modes are among them. */
static fmi2Status call(int which)
{
    fmi2Component c = rarely() ? NULL : component;
    fmi2ValueReference *r = rarely() ? NULL : references;
    fmi2Real *v = rarely() ? NULL : reals, more[64] = {0};
    fmi2Integer *i = rarely() ? NULL : wholes;
    size_t n = (size_t)below(MOST), size = rarely() ? (size_t)below(14) : MODEL_STATES;
    fmi2EventInfo info;
    fmi2Boolean flags[2];
    fmi2Status status;
    const fmi2StatusKind kind = (fmi2StatusKind)below(4);
    switch (which) {
    case 0: return fmi2SetupExperiment(c, below(2), 1e-6, rarely() ? random_real() : 0.0, below(2),
                                       random_real() + 5.0);
    case 1: return fmi2EnterInitializationMode(c);
    case 2: return fmi2ExitInitializationMode(c);
    case 3: return rarely() ? fmi2Terminate(c) : fmi2OK;
    case 4: now = 0.0; return rarely() ? fmi2Reset(c) : fmi2OK;
    case 5: return fmi2GetReal(c, r, n, v);
    case 6: return fmi2GetInteger(c, r, n, i);
    case 7: return fmi2GetBoolean(c, r, n, i);
    case 8: return fmi2GetString(c, r, n, rarely() ? NULL : strings);
    case 9: return fmi2SetReal(c, r, n, v);
    case 10: return fmi2SetInteger(c, r, n, i);
    case 11: return fmi2SetBoolean(c, r, n, i);
    case 12: return fmi2SetString(c, r, n, rarely() ? NULL : strings);
    case 13: return fmi2GetFMUstate(c, rarely() ? NULL : &saved);
    case 14: return fmi2SetFMUstate(c, saved);
    case 15: store(); return fmi2OK;
    case 16: load(); return fmi2OK;
    case 17: return fmi2GetDirectionalDerivative(c, r, n, rarely() ? NULL : references + 1,
                                                 (size_t)below(3), v, more);
    case 18: return fmi2EnterEventMode(c);
    case 19: return fmi2NewDiscreteStates(c, rarely() ? NULL : &info);
    case 20: return fmi2EnterContinuousTimeMode(c);
    case 21: return fmi2CompletedIntegratorStep(c, below(2), flags, rarely() ? NULL : flags + 1);
    case 22: now += 0.1 * unit(); return fmi2SetTime(c, rarely() ? random_real() : now);
    case 23: return fmi2SetContinuousStates(c, v, size);
    case 24: return fmi2GetDerivatives(c, v, size);
    case 25: return fmi2GetEventIndicators(c, v, (size_t)below(2));
    case 26: return fmi2GetContinuousStates(c, v, size);
    case 27: return fmi2GetNominalsOfContinuousStates(c, v, size);
    case 28: return fmi2SetRealInputDerivatives(c, r, n, i, v);
    case 29: return fmi2GetRealOutputDerivatives(c, r, n, i, v);
    case 30: return fmi2CancelStep(c);
    case 31: return fmi2GetStatus(c, kind, rarely() ? NULL : &status);
    case 32: return fmi2GetRealStatus(c, kind, v);
    case 33: return fmi2GetIntegerStatus(c, kind, i);
    case 34: return fmi2GetBooleanStatus(c, kind, i);
    case 35: return fmi2GetStringStatus(c, kind, rarely() ? NULL : strings);
    case 36: return fmi2SetDebugLogging(c, below(2), n, rarely() ? NULL : strings);
    default: {
        double step = rarely() ? random_real() : 0.05 * unit();
        double start = rarely() ? random_real() : now;
        step = step > 1.0 ? 1.0 : step;
        status = fmi2DoStep(c, start, step, fmi2True);
        now = status == fmi2OK ? start + step : now;
        return status;
    }
    }
}

/* A call that is likely to be in order where the sequence is. */
static int likely(int place)
{
    static const int stepping[] = {37, 37, 5, 6, 7, 9, 13, 14, 15, 16, 17, 28, 29, 32};
    static const int exchanging[] = {18, 19, 20, 21, 22, 22, 23, 24, 26, 27, 5, 9, 13, 14, 15, 16, 17};
    if (place < 2) {
        return place + 1;
    }
    if (exchange && place < 4) {
        return 17 + place;
    }
    return exchange ? exchanging[below(17)] : stepping[below(14)];
}

int main(int count, char **arguments)
{
    long sequences = count > 1 ? atol(arguments[1]) : 1000, calls = 0, errors = 0;
    uint64_t first = count > 2 ? strtoull(arguments[2], NULL, 10) : 1;
    char message[MESSAGE];
    resources = count > FOLDER ? arguments[FOLDER] : ".";
    if (!start_read(resources, &starts, message)) {
        printf("%s\n", message);
        return 1;
    }
    for (long s = 0; s < sequences; s++) {
        random_state = (first + (uint64_t)s) * 0x9E3779B97F4A7C15u | 1;
        instantiate();
        /* half of the sequences begin in good order, so that the deep modes are met */
        int orderly = below(2);
        for (int k = orderly ? below(8) : 0; k > 0; k--) {
            tune();
        }
        for (int k = 0; k < CALLS; k++) {
            choose();
            int which = orderly && (k < 4 || below(8) > 0) ? likely(k) : below(60);
            fmi2Status status = call(which);
            if (status < fmi2OK || status > fmi2Fatal) {
                printf("sequence %ld, call %d: status %d\n", s, which, (int)status);
                return 1;
            }
            calls++;
            errors += status == fmi2Error;
        }
        if (component != NULL) {
            fmi2FreeFMUstate(component, &saved);
        }
        free(component == NULL ? saved : NULL);
        saved = NULL;
        fmi2FreeInstance(component);
    }
    free(bytes);
    printf("%ld sequences, %ld calls, %ld errors, %ld messages\n", sequences, calls, errors,
           messages);
    return errors > 0 && messages > 0 ? 0 : 1;
}
