/* The step loop of a co-simulation in C: what schedule.py lists and loop.py does in Python, with the
 * same numbers. It knows no Python; native.py fills these structures and keeps their memory. */
#ifndef SEGFMU_LOOP_H
#define SEGFMU_LOOP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Status codes of FMI 2.0 and 3.0 above which a call has failed. */
enum { WARNING = 1 };

/* Types of the values of buffers and columns. */
enum type { F64, F32, I8, U8, I16, U16, I32, U32, I64, U64, BOOL };

/* Forms of the functions that get and set. */
enum form { ACCESS2, ACCESS3, SLOPES };

/* Operations; MEET makes the next `extra` ones depend on an event, GATE on a communication point
 * whose number is a multiple of `item`. */
enum kind { CALL, COPY, STEP, MEET, GATE };

/* How a run ended. */
enum outcome { DONE, CALL_FAILED, STEP_FAILED, ENTER_FAILED, UPDATE_FAILED, LEAVE_FAILED,
               STEP_TERMINATED, EVENT_TERMINATED, STALLED, EVENT_STALLED, OFF_TAPE };

/* What a run does with its tape: calls and steps that are `taped` are put on it, or heard from it
 * without their FMU. */
enum tape_use { UNUSED, RECORDS, REPEATS };

typedef struct {
    int64_t use;
    char *data;
    size_t size, place;
} tape;

typedef struct {
    int64_t form;
    void *function, *instance;
    const uint32_t *references;
    size_t count;
    const int *orders;
    void *values;
    size_t size, taped;  /* bytes on the tape, or 0 */
} call;

/* `count` values; from the places `index`, or from the beginning if it is NULL. A column's target is
 * its place in a row. */
typedef struct {
    int64_t from_type, to_type, count;
    const char *from;
    const int64_t *index;
    char *to;
    int64_t offset;
} copy;

typedef struct {
    int64_t kind, item, extra;
} operation;

typedef struct {
    const operation *items;
    int64_t count;
} sequence;

typedef struct {
    int64_t version;
    void *instance, *do_step, *enter_event, *update, *enter_step;
    int64_t has_events, at_event, taped;
} unit;

/* One variable of a change: `bytes` of data for the buffer of a call. */
typedef struct {
    int64_t item;
    const void *data;
    size_t bytes;
} assignment;

typedef struct {
    double time;
    int64_t unit, first, count;
} change;

typedef struct {
    unit *units;
    const call *calls;
    const copy *copies, *columns;
    int64_t column_count;
    sequence advance, exchange, refresh, point;
    const double *const *events;
    int64_t event_count;
    const change *changes;
    int64_t change_count, next_change;
    const assignment *assignments;
    const double *points;
    char *rows;
    int64_t row_size;
    double instant;
    int64_t most_stalls;
    /* where a run stands, and what ended it */
    double time, reached;
    int64_t stalls, outcome, item, status;
    /* the communication point that is next, and the time that each unit has reached */
    int64_t row;
    double *lasts;
    tape tape;
} simulation;

/* Put bytes on a tape that records; one that is full is of no use. */
void keep_told(tape *t, const void *from, size_t bytes);

/* The next bytes of a tape; false at its end. */
bool tell_again(tape *t, void *to, size_t bytes);

/* Copy values of one buffer to another place, each converted to its type. */
void copy_values(const copy *c, char *to);

/* Do the steps to the communication points `first` to `last`, and record their rows. */
int64_t run_rows(simulation *s, int64_t first, int64_t last);

#endif
