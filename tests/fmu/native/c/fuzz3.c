/* Random sequences of calls of FMI 3.0: each must end with a status, none may crash. */
#include <stdio.h>
#include <string.h>

/* the whole FMU, so that its tables are at hand */
#include "fmu.c"
#include "random.h"

enum { MOST = 6, CALLS = 40, FOLDER = 3, ROOM = 400 };

static long messages;
static start_values starts;
static const char *resources;
static fmi3Instance one;
static fmi3FMUState saved;
static fmi3ValueReference references[MOST];
static fmi3Float64 reals[ROOM];
static fmi3Int32 whole[ROOM];
static fmi3Byte *bytes;
static size_t stored;
static double now;
static int exchange;

static void hear(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                 fmi3String message)
{
    (void)environment;
    if (category == NULL || message == NULL || message[0] == '\0' || strlen(message) > 800
        || status > fmi3Fatal) {
        abort();
    }
    messages++;
}

static void updated(fmi3InstanceEnvironment environment, fmi3Float64 time, fmi3Boolean set,
                   fmi3Boolean get, fmi3Boolean finished, fmi3Boolean may_return,
                   fmi3Boolean *early, fmi3Float64 *asked)
{
    (void)environment;
    (void)set;
    (void)get;
    (void)finished;
    *early = may_return && below(4) == 0;
    *asked = below(4) ? time + 0.01 * unit() : random_real();
}

static void choose(void)
{
    int fine = below(3) > 0;
    for (int i = 0; i < MOST; i++) {
        references[i] = random_reference((int)starts.variables);
    }
    for (int i = 0; i < ROOM; i++) {
        reals[i] = fine ? unit() : random_real();
        whole[i] = random_integer();
    }
}

static void instantiate(void)
{
    const char *name = rarely() ? NULL : "one", *token = rarely() ? "other" : starts.token;
    exchange = below(2);
    now = 0.0;
    if (exchange) {
        one = fmi3InstantiateModelExchange(name, token, rarely() ? NULL : resources, false,
                                           below(2), NULL, rarely() ? NULL : hear);
    } else {
        choose();
        one = fmi3InstantiateCoSimulation(
            name, token, resources, false, below(2), below(2), below(2), references,
            rarely() ? (size_t)below(MOST) : 0, NULL, rarely() ? NULL : hear,
            below(2) ? NULL : updated);
    }
}

static void store(void)
{
    size_t size = 0;
    if (saved == NULL || fmi3SerializedFMUStateSize(one, saved, &size) != fmi3OK) {
        return;
    }
    bytes = realloc(bytes, size);
    stored = fmi3SerializeFMUState(one, saved, bytes, size) == fmi3OK ? size : 0;
}

static void load(void)
{
    fmi3FMUState found = NULL;
    if (stored > 0) {
        if (below(2)) {
            bytes[random_word() % stored] ^= (fmi3Byte)(1 << below(8));
        }
        fmi3DeserializeFMUState(one, bytes, below(4) ? stored : stored / 2, &found);
    }
    if (found != NULL) {
        fmi3SetFMUState(one, found);
        fmi3FreeFMUState(one, &found);
    }
}

/* Number of values of a variable, as the description has it. */
static size_t elements(const variable *v)
{
    return (size_t)(v->elements + starts.rows * v->columns);
}

/* Set a parameter to something near its start value, or to anything. */
static void tune(void)
{
    fmi3ValueReference r = 1 + (fmi3ValueReference)below((int)starts.variables);
    const variable *v = glue_variable(r);
    fmi3Int64 value = below(8) ? 1 + below(4) : random_integer();
    fmi3Int32 small = (fmi3Int32)value;
    fmi3Boolean truth = below(2);
    switch (v->kind) {
    case KIND_REAL:
        for (size_t i = 0; i < elements(v) && i < ROOM; i++) {
            double near = starts.real[v->offset + i] * (0.5 + unit());
            reals[i] = below(20) ? near : random_real();
        }
        fmi3SetFloat64(one, &r, 1, reals, elements(v));
        break;
    case KIND_INTEGER: fmi3SetInt32(one, &r, 1, &small, 1); break;
    case KIND_BOOLEAN: fmi3SetBoolean(one, &r, 1, &truth, 1); break;
    default: fmi3SetInt64(one, &r, 1, &value, 1); break;
    }
}

#define VALUES(Type)                                                                     \
    static fmi3Status get_##Type(fmi3Instance c, const fmi3ValueReference *r, size_t n)  \
    {                                                                                    \
        fmi3##Type values[ROOM];                                                         \
        return fmi3Get##Type(c, r, n, rarely() ? NULL : values, rarely() ? n + 1 : n);   \
    }                                                                                    \
    static fmi3Status set_##Type(fmi3Instance c, const fmi3ValueReference *r, size_t n)  \
    {                                                                                    \
        fmi3##Type values[ROOM] = {0};                                                   \
        return fmi3Set##Type(c, r, n, rarely() ? NULL : values, rarely() ? n + 1 : n);   \
    }
VALUES(Float32)
VALUES(Int8)
VALUES(UInt8)
VALUES(Int16)
VALUES(UInt16)
VALUES(Int32)
VALUES(UInt32)
VALUES(Int64)
VALUES(UInt64)
VALUES(Boolean)
VALUES(String)

static fmi3Status typed(fmi3Instance c, const fmi3ValueReference *r, size_t n)
{
    static fmi3Status (*const all[])(fmi3Instance, const fmi3ValueReference *, size_t) = {
        get_Float32, set_Float32, get_Int8, set_Int8, get_UInt8, set_UInt8, get_Int16, set_Int16,
        get_UInt16, set_UInt16, get_Int32, set_Int32, get_UInt32, set_UInt32, get_Int64, set_Int64,
        get_UInt64, set_UInt64, get_Boolean, set_Boolean, get_String, set_String
    };
    return all[below(22)](c, r, n);
}

static fmi3Status clocks(fmi3Instance c, const fmi3ValueReference *r, size_t n)
{
    fmi3Clock clock[MOST] = {false};
    fmi3IntervalQualifier qualifiers[MOST];
    fmi3UInt64 counters[MOST] = {0};
    fmi3Binary binary[MOST] = {NULL};
    size_t sizes[MOST] = {0};
    switch (below(12)) {
    case 0: return fmi3GetClock(c, r, n, clock);
    case 1: return fmi3SetClock(c, r, n, clock);
    case 2: return fmi3GetIntervalDecimal(c, r, n, reals, qualifiers);
    case 3: return fmi3GetIntervalFraction(c, r, n, counters, counters, qualifiers);
    case 4: return fmi3GetShiftDecimal(c, r, n, reals);
    case 5: return fmi3GetShiftFraction(c, r, n, counters, counters);
    case 6: return fmi3SetIntervalDecimal(c, r, n, reals);
    case 7: return fmi3SetIntervalFraction(c, r, n, counters, counters);
    case 8: return fmi3SetShiftDecimal(c, r, n, reals);
    case 9: return fmi3SetShiftFraction(c, r, n, counters, counters);
    case 10: return fmi3GetBinary(c, r, n, sizes, binary, n);
    default: return fmi3SetBinary(c, r, n, sizes, (const fmi3Binary *)binary, n);
    }
}

static fmi3Status step(fmi3Instance c)
{
    fmi3Boolean flags[3] = {false};
    fmi3Float64 reached = now, length = rarely() ? random_real() : 0.05 * unit();
    length = length > 1.0 ? 1.0 : length;
    fmi3Status status = fmi3DoStep(c, rarely() ? random_real() : now, length, true, &flags[0],
                                   rarely() ? NULL : &flags[1], &flags[2], &reached);
    now = status == fmi3OK ? reached : now;
    return status;
}

/* One call; NULL pointers, wrong sizes and modes are among them. */
static fmi3Status call(int which)
{
    fmi3Instance c = rarely() ? NULL : one;
    fmi3ValueReference *r = rarely() ? NULL : references;
    fmi3Float64 *v = rarely() ? NULL : reals, more[64] = {0}, next;
    size_t n = (size_t)below(MOST), size = rarely() ? (size_t)below(14) : MODEL_STATES, count;
    size_t m = (size_t)below(3);
    fmi3Boolean b[6], *flag = rarely() ? NULL : b;
    switch (which) {
    case 0: return fmi3EnterConfigurationMode(c);
    case 1: return fmi3EnterInitializationMode(c, below(2), 1e-6, rarely() ? random_real() : 0.0,
                                               below(2), random_real() + 5.0);
    case 2: return fmi3ExitInitializationMode(c);
    case 3: return fmi3ExitConfigurationMode(c);
    case 4: return rarely() ? fmi3Terminate(c) : fmi3OK;
    case 5: now = 0.0; return rarely() ? fmi3Reset(c) : fmi3OK;
    case 6: return fmi3GetFloat64(c, r, n, v, rarely() ? n + 1 : n);
    case 7: return fmi3SetFloat64(c, r, n, v, rarely() ? n + 1 : n);
    case 8: return typed(c, r, n);
    case 9: return clocks(c, r, n);
    case 10: return fmi3GetFMUState(c, rarely() ? NULL : &saved);
    case 11: return fmi3SetFMUState(c, saved);
    case 12: store(); return fmi3OK;
    case 13: load(); return fmi3OK;
    case 14: return fmi3GetDirectionalDerivative(c, r, n, references, m, v, m, more, n);
    case 15: return fmi3GetAdjointDerivative(c, r, n, references, m, v, n, more, m);
    case 16: return fmi3GetOutputDerivatives(c, r, n, whole, v, n);
    case 17: return fmi3EnterEventMode(c);
    case 18: return fmi3UpdateDiscreteStates(c, b, b + 1, flag, b + 3, b + 4, &next);
    case 19: return fmi3EnterContinuousTimeMode(c);
    case 20: return fmi3EnterStepMode(c);
    case 21: return fmi3CompletedIntegratorStep(c, below(2), b, flag);
    case 22: now += 0.1 * unit(); return fmi3SetTime(c, rarely() ? random_real() : now);
    case 23: return fmi3SetContinuousStates(c, v, size);
    case 24: return fmi3GetContinuousStateDerivatives(c, v, size);
    case 25: return fmi3GetEventIndicators(c, v, (size_t)below(2));
    case 26: return fmi3GetContinuousStates(c, v, size);
    case 27: return fmi3GetNominalsOfContinuousStates(c, v, size);
    case 28: return fmi3GetNumberOfContinuousStates(c, rarely() ? NULL : &count);
    case 29: return fmi3GetNumberOfEventIndicators(c, rarely() ? NULL : &count);
    case 30: return fmi3GetNumberOfVariableDependencies(c, references[0], &count);
    case 31: return fmi3EvaluateDiscreteStates(c);
    case 32: return fmi3SetDebugLogging(c, below(2), 0, NULL);
    case 33: return fmi3ActivateModelPartition(c, references[0], unit());
    default: return step(c);
    }
}

/* A call that is likely to be in order where the sequence is. */
static int likely(int place)
{
    static const int stepping[] = {34, 34, 6, 7, 8, 10, 11, 12, 13, 14, 15, 16, 17, 18, 20, 20};
    static const int exchanging[] = {
        17, 18, 19, 21, 22, 22, 23, 24, 26, 27, 6, 7, 10, 11, 12, 13, 14
    };
    if (place < 2) {
        return place + 1;
    }
    if (place < 4) {
        return place == 2 ? 18 : exchange ? 19 : 20;
    }
    return exchange ? exchanging[below(17)] : stepping[below(16)];
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
            fmi3Status status = call(orderly && (k < 4 || below(8) > 0) ? likely(k) : below(60));
            if (status < fmi3OK || status > fmi3Fatal) {
                printf("sequence %ld, call %d: status %d\n", s, k, (int)status);
                return 1;
            }
            calls++;
            errors += status == fmi3Error;
        }
        if (one != NULL) {
            fmi3FreeFMUState(one, &saved);
        }
        free(one == NULL ? saved : NULL);
        saved = NULL;
        fmi3FreeInstance(one);
    }
    free(bytes);
    printf("%ld sequences, %ld calls, %ld errors, %ld messages\n", sequences, calls, errors,
           messages);
    return errors > 0 && messages > 0 ? 0 : 1;
}
