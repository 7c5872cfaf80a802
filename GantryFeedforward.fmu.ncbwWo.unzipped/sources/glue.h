/* Shared by fmi2.c and fmi3.c: instances, the sequence of a simulation, access to variables, saved
   states. Each file calls those before it: instance.c, simulation.c, values.c; instance.c, state.c. */
#ifndef SEGFMU_GLUE_H
#define SEGFMU_GLUE_H

#include "model.h"
#include "start.h"

/* the numbers of both versions of the standard */
enum { STATUS_OK, STATUS_WARNING, STATUS_DISCARD, STATUS_ERROR, STATUS_FATAL };

/* States of the standard's state machines. */
enum {
    MODE_INSTANTIATED = 1, MODE_INITIALISATION = 4, MODE_EVENT = 8,
    MODE_CONTINUOUS = 16, MODE_STEP = 32, MODE_TERMINATED = 64, MODE_FAILED = 128,
    MODE_RUNNING = MODE_EVENT | MODE_CONTINUOUS | MODE_STEP,
    MODE_ANY = MODE_INSTANTIATED | MODE_INITIALISATION | MODE_RUNNING | MODE_TERMINATED | MODE_FAILED,
    /* within the callback of FMI 3.0: values can be read, and nothing else */
    MODE_UPDATE = 256
};

/* modes in which states can be set one by one in model exchange; of fmi2.c and fmi3.c */
static const int glue_state_modes;

typedef struct instance instance;
typedef void (*reporter)(instance *c, int status, const char *category, const char *message);
/* any function; cast back to its own type before it is called */
typedef void (*callback)(void);

/* What a list of variables is for; the last one for each that was found right is kept, as importers ask
   for the same ones in every step. */
enum { READ_LIST, SET_LIST, UNKNOWN_LIST, KNOWN_LIST, LISTS };

typedef struct {
    size_t count, size;
    int64_t rows;
    int kinds, all;
    bool scalar;  /* all variables have one value, at these places of `real` or `integer` */
    uint16_t places[MODEL_VARIABLES];
    uint32_t references[MODEL_VARIABLES];
} known_list;

struct instance {
    model *model;
    size_t capacity;  /* bytes of the model's block */
    start_values start;
    char *name;
    void *environment;
    reporter report;
    callback log, update;
    bool logging;
    unsigned categories;  /* a bit each of those that were chosen; 0: all */
    bool event_mode, early_return;
    known_list known[LISTS];
};

/* A new instance in mode INSTANTIATED, or NULL with a message. */
static instance *glue_create(const char *name, const char *token, const char *resources,
                             int interface, bool logging, reporter report, callback log,
                             void *environment);
static void glue_free(instance *c);
/* Make room in the model's block, which may move; false where there is no memory. */
static bool glue_reserve(instance *c, size_t size);
/* Give back the room that the model needed to plan; the block may move. */
static void glue_release(instance *c);
/* Back to the start values, mode INSTANTIATED. */
static void glue_reset(instance *c);

/* Errors and warnings are reported unless other categories were chosen, the rest where logging is
   on. */
static void glue_log(instance *c, int status, const char *format, ...);

/* Choose what is logged; false for a category that does not exist. */
static bool glue_choose(instance *c, bool on, const char *const categories[], size_t count);

/* Whether a call is allowed: c exists and is in one of the modes; reports what is wrong. */
static bool glue_allows(instance *c, int modes, const char *function);
/* Whether a pointer that must be given is there; reports if not. */
static bool glue_given(instance *c, const void *pointer, const char *function);

static void glue_set_time(instance *c, double time);
/* Whether a time can be used: clocks need digits behind it. */
static bool glue_time(instance *c, double time, const char *what);
static bool glue_finite(instance *c, double value, const char *what);

/* The variable of a value reference, which must exist. */
static const variable *glue_variable(uint32_t reference);
/* Its name and range. */
static const label *glue_label(const variable *v);

/* Check references, kind and number of values; before reading, make the values current. */
static bool glue_readable(instance *c, const char *function, const uint32_t references[], size_t count,
                   const void *values, size_t size, int kinds);
static bool glue_settable(instance *c, const char *function, const uint32_t references[], size_t count,
                   const void *values, size_t size, int kinds);
/* Number of elements of a variable. */
static size_t glue_elements_of(const instance *c, const variable *v);
/* Whether a value of an element is in the range of its variable; reports if not, `what` goes before. */
static bool glue_in_range(instance *c, const variable *v, size_t element, double value, const char *what);
static void glue_get_reals(const instance *c, const uint32_t references[], size_t count, double values[]);
static bool glue_set_reals(instance *c, const uint32_t references[], size_t count, const double values[],
                    size_t size);
/* One integer, Boolean or enumeration. */
static int64_t glue_integer(const instance *c, uint32_t reference, size_t element);
static bool glue_set_integer(instance *c, uint32_t reference, size_t element, int64_t value);

/* The experiment: start time, and stop time where there is one. */
static bool glue_begin(instance *c, double start, bool has_stop, double stop);
/* End of initialisation; the instance fails where its parameters are of no use. */
static bool glue_initialise(instance *c);
/* Follow parameters that were set since the model last did. */
static bool glue_follows(instance *c);
/* The same where the first event is handled; from then on fixed parameters stay as they are. `moved`:
   the states are no longer those that the importer has. */
static bool glue_started(instance *c, bool *moved);
/* Outputs current, after parameters. */
static bool glue_evaluate(instance *c);

/* Model exchange: the derivatives at the present state. */
static bool glue_derivatives(instance *c, double derivatives[]);

/* A step of the importer's integrator is over; whether it is to enter event mode. */
static bool glue_accept(instance *c, bool *event);

/* One communication step: begin it, go on to its end or an event. */
static bool glue_begin_step(instance *c, double time, double step);
static bool glue_continue_step(instance *c, double end, bool *event);
static bool glue_event(instance *c);

/* Products of the partial derivatives with a seed. */
static bool glue_directional(instance *c, const char *function, const uint32_t unknowns[], size_t m,
                      const uint32_t knowns[], size_t n, const double seed[], double found[],
                      bool adjoint);
static bool glue_output_derivatives(instance *c, const char *function, const uint32_t references[],
                             size_t count, const int32_t orders[], double values[]);

/* Derivatives of inputs at the beginning of the next step; they hold until the end of that step. */
static bool glue_input_derivatives(instance *c, const char *function, const uint32_t references[],
                            size_t count, const int32_t orders[], const double values[]);

/* Saved states: the used part of the block behind a header. */
static bool glue_save(instance *c, void **state);
static bool glue_restore(instance *c, const void *state);
static size_t glue_state_size(const void *state);
static void glue_free_state(void **state);
static bool glue_serialise(instance *c, const void *state, void *bytes, size_t size);
static bool glue_deserialise(instance *c, const void *bytes, size_t size, void **state);

#endif
