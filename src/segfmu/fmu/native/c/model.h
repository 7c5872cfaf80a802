/* All that the FMI glue knows of a model: a block of memory without pointers, and what can be done
   with it. fmi2.c and fmi3.c are written once against this header; the table of variables comes
   from the interface specification in Python. */
#ifndef SEGFMU_MODEL_H
#define SEGFMU_MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "variables.h"

/* room for a message, its end included */
enum { MESSAGE = 400 };

/* interfaces of an instance */
enum { MODEL_EXCHANGE, CO_SIMULATION, NO_INTERFACE };

/* orders of the derivatives of inputs */
enum { INPUT_ORDERS = 3 };

enum { KIND_REAL, KIND_INTEGER, KIND_BOOLEAN, KIND_ENUMERATION };

/* Who may set a variable, and when: a parameter before the end of initialisation, a tunable one at
   events and between steps as well, start values as a parameter, inputs always. Commands, which may be
   discrete inputs, are taken between events too, and act at the next one. */
enum { SET_NEVER, SET_FIXED, SET_TUNABLE, SET_START, SET_INPUT, SET_COMMAND };

/* A variable; its value reference is its place in the table, from 1. */
typedef struct {
    uint16_t offset;      /* of its first value in `real`, else in `integer` */
    uint16_t elements;    /* of a scalar, which is one, or of an array of the same size everywhere */
    uint16_t columns;     /* of another array, which has all rows of the instance */
    uint8_t kind;
    uint8_t setting;
    uint8_t state;        /* its place among the states, from 1; 0: it is none */
    bool calculated;      /* follows from the others */
    bool differentiable;  /* an output or a state's derivative, continuous */
    bool counts;          /* rows in use, at most those that there are */
} variable;

/* What steps do not need of a variable, in a table of its own so that the other one stays small. */
typedef struct {
    char name[MODEL_NAME];  /* no pointer: the loader would have one to set for each */
    uint16_t range;         /* its place among the ranges */
} label;

typedef struct {
    double least, most;
} range;

/* Values of `real` that follow each other. */
typedef struct {
    uint16_t first, count;
} run;

/* of variables.c: variables, their labels and ranges, and where those that are differentiable lie */
static const variable model_variables[MODEL_VARIABLES];
static const label model_labels[MODEL_VARIABLES];
static const range model_ranges[MODEL_RANGES];
static const run model_differentiable[MODEL_RUNS + 1];

/* The beginning of every model's block. */
typedef struct {
    int64_t mode;         /* of the glue */
    int64_t interface;    /* of the glue: co-simulation or model exchange */
    int64_t initialised;  /* the model follows from the present parameters and start values */
    int64_t evaluated;    /* outputs follow from the present time, states and inputs */
    int64_t tuned;        /* a tunable parameter was set, or a command to another value */
    int64_t awaited;      /* the latter between events, which asks for one */
    double met;           /* s; the time of the last event */
    int64_t starting;     /* fixed parameters can be set in event mode, as before initialisation */
    int64_t running;      /* initialisation is over */
    int64_t given;        /* inputs were set before that */
    int64_t stops;        /* there is a stop time */
    double start, stop;   /* s */
    double held[MODEL_INPUTS + 1];   /* start values of the inputs, in the order of `real` */
    double step_start;    /* s; of the communication step under way */
    double step_end;
    /* derivatives of the inputs at the beginning of the step, where they are given */
    double slope[INPUT_ORDERS][MODEL_INPUTS + 1];
    int64_t sloped;       /* they are */
    double real[MODEL_REALS];        /* real[V_TIME] is the time */
    int64_t integer[MODEL_INTEGERS];
} model;

/* Bytes of a block before initialisation, of one that has room for what `model_initialise` needs by
   the present parameters, and of the part of a block that is in use. */
static size_t model_least(void);
static size_t model_size(const model *m);
static size_t model_used(const model *m);

/* Whether a block that comes from outside, of so many bytes, has sizes and indices within itself. */
static bool model_sound(const model *m, size_t size);

/* Follow parameters and start values, at the present time. Where a function returns false, it
   has left a message of one line. */
static bool model_initialise(model *m, char message[MESSAGE]);

/* What the user ought to know of parameters that can be followed, by the start values of `real`; true
   with a message of one line. */
static bool model_warning(const model *m, const double start[], char message[MESSAGE]);

/* Make the outputs follow time, states and inputs. */
static bool model_evaluate(model *m, char message[MESSAGE]);

/* Co-simulation: go on to a time, at most to the next event. Where commands at the beginning of a step
   change the next event, the model says how far it went. */
static bool model_advance(model *m, double *reached, char message[MESSAGE]);

/* Events: when the next one is, infinite where there is none, and the event at the present time. */
static double model_next_event(const model *m);
static bool model_event(model *m, char message[MESSAGE]);

/* Model exchange. */
static void model_get_states(const model *m, double states[]);
static void model_set_states(model *m, const double states[]);
static bool model_derivatives(model *m, double derivatives[], char message[MESSAGE]);
static bool model_accept(model *m, char message[MESSAGE]);
static const double model_nominals[MODEL_STATES + 1];

/* Time derivative, from order 1, of a continuous output; false where there is none. */
static bool model_output_derivative(model *m, const variable *output, int64_t order, double *value);

/* Partial derivative of an output or state derivative by a state, an input or time; false where
   it is not one of these. */
static bool model_partial(model *m, const variable *unknown, const variable *known, double *value);

#endif
