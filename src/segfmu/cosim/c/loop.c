#include <stdbool.h>
#include <string.h>

#include "loop.h"

typedef int (*access2)(void *, const uint32_t *, size_t, void *);
typedef int (*access3)(void *, const uint32_t *, size_t, void *, size_t);
typedef int (*slopes)(void *, const uint32_t *, size_t, const int *, void *);
typedef int (*step2)(void *, double, double, int);
typedef int (*step3)(void *, double, double, bool, bool *, bool *, bool *, double *);
typedef int (*mode)(void *);
typedef int (*update)(void *, bool *, bool *, bool *, bool *, bool *, double *);

static bool stop(simulation *s, int64_t outcome, int64_t item, int status)
{
    s->outcome = outcome;
    s->item = item;
    s->status = status;
    return false;
}

static bool do_call(simulation *s, int64_t item)
{
    const call *c = &s->calls[item];
    int status;
    if (c->taped && s->tape.use == REPEATS) {
        return tell_again(&s->tape, c->values, c->taped) || stop(s, OFF_TAPE, item, 0);
    }
    switch (c->form) {
    case ACCESS2:
        status = ((access2)c->function)(c->instance, c->references, c->count, c->values);
        break;
    case ACCESS3:
        status = ((access3)c->function)(c->instance, c->references, c->count, c->values, c->size);
        break;
    default:
        status = ((slopes)c->function)(c->instance, c->references, c->count, c->orders, c->values);
    }
    if (status > WARNING) {
        return stop(s, CALL_FAILED, item, status);
    }
    if (c->taped) {
        keep_told(&s->tape, c->values, c->taped);
    }
    return true;
}

/* A step as it is on the tape. */
typedef struct {
    double start, end, reached;
    int64_t at_event;
} told_step;

static bool repeats(const simulation *s, int64_t item)
{
    return s->units[item].taped && s->tape.use == REPEATS;
}

static bool repeat_step(simulation *s, int64_t item)
{
    told_step t;
    if (!tell_again(&s->tape, &t, sizeof t) || t.start != s->lasts[item] || t.end != s->reached) {
        return stop(s, OFF_TAPE, item, 0);
    }
    s->units[item].at_event = t.at_event;
    s->lasts[item] = s->reached = t.reached;
    return true;
}

/* A step to s->reached, from where the unit is; the first one may end it earlier. */
static bool do_step(simulation *s, int64_t item)
{
    unit *u = &s->units[item];
    double start = s->lasts[item], end = s->reached, told = end;
    bool event = false, terminate = false, early = false;
    int status;
    if (repeats(s, item)) {
        return repeat_step(s, item);
    }
    if (u->version == 2) {
        status = ((step2)u->do_step)(u->instance, start, end - start, 1);
    } else {
        status = ((step3)u->do_step)(u->instance, start, end - start, true, &event, &terminate,
                                     &early, &told);
    }
    if (status > WARNING) {
        return stop(s, STEP_FAILED, item, status);
    }
    if (terminate) {
        s->reached = told;
        return stop(s, STEP_TERMINATED, item, status);
    }
    u->at_event = event && u->has_events;
    if (item == 0 && early && told < end - s->instant) {
        s->reached = told;
    }
    s->lasts[item] = s->reached;
    if (u->taped) {
        const told_step t = {start, end, s->reached, u->at_event};
        keep_told(&s->tape, &t, sizeof t);
    }
    return true;
}

static bool enter_event(simulation *s, int64_t item)
{
    int status = ((mode)s->units[item].enter_event)(s->units[item].instance);
    return status <= WARNING || stop(s, ENTER_FAILED, item, status);
}

/* From event mode to step mode. */
static bool leave_event(simulation *s, int64_t item)
{
    unit *u = &s->units[item];
    bool again = true;
    for (int64_t rounds = 0; again; rounds++) {
        if (rounds > s->most_stalls) {
            return stop(s, EVENT_STALLED, item, 0);
        }
        bool terminate = false, nominals = false, states = false, defined = false;
        double next = 0.0;
        int status = ((update)u->update)(u->instance, &again, &terminate, &nominals, &states,
                                         &defined, &next);
        if (status > WARNING) {
            return stop(s, UPDATE_FAILED, item, status);
        }
        if (terminate) {
            return stop(s, EVENT_TERMINATED, item, status);
        }
    }
    int status = ((mode)u->enter_step)(u->instance);
    return status <= WARNING || stop(s, LEAVE_FAILED, item, status);
}

/* The operations of `q`; those behind an event that did not come are left out. */
static bool perform(simulation *s, sequence q)
{
    for (int64_t i = 0; i < q.count; i++) {
        const operation *o = &q.items[i];
        bool good = true;
        switch (o->kind) {
        case CALL:
            good = do_call(s, o->item);
            break;
        case COPY:
            copy_values(&s->copies[o->item], s->copies[o->item].to);
            break;
        case STEP:
            good = do_step(s, o->item);
            break;
        case GATE:
            if (s->row % o->item != 0 || s->reached < s->points[s->row]) {
                i += o->extra;
            }
            break;
        default:
            if (s->units[o->item].at_event) {
                s->units[o->item].at_event = 0;
                good = repeats(s, o->item)
                    || (enter_event(s, o->item) && leave_event(s, o->item));
            } else {
                i += o->extra;
            }
        }
        if (!good) {
            return false;
        }
    }
    return true;
}

static bool make_change(simulation *s, const change *c)
{
    bool events = s->units[c->unit].has_events;
    if (events && !enter_event(s, c->unit)) {
        return false;
    }
    for (int64_t i = c->first; i < c->first + c->count; i++) {
        const assignment *a = &s->assignments[i];
        memcpy(s->calls[a->item].values, a->data, a->bytes);
        if (!do_call(s, a->item)) {
            return false;
        }
    }
    return !events || leave_event(s, c->unit);
}

/* The changes that are due at `time`, and what other units get to know of them then. */
static bool make_changes(simulation *s, double time)
{
    bool made = false;
    while (s->next_change < s->change_count
           && s->changes[s->next_change].time <= time + s->instant) {
        if (!make_change(s, &s->changes[s->next_change])) {
            return false;
        }
        s->next_change++;
        made = true;
    }
    return !made || perform(s, s->refresh);
}

static double earlier(const simulation *s, double event, double end)
{
    return s->time + 1e-3 * s->instant < event && event < end - s->instant ? event : end;
}

/* A step of all units towards `end`, or to an earlier event or change. */
static bool advance(simulation *s, double end)
{
    for (int64_t i = 0; i < s->event_count; i++) {
        end = earlier(s, *s->events[i], end);
    }
    if (s->next_change < s->change_count) {
        end = earlier(s, s->changes[s->next_change].time, end);
    }
    s->reached = end;
    if (!perform(s, s->advance)) {
        return false;
    }
    s->stalls = s->reached > s->time ? 0 : s->stalls + 1;
    if (s->stalls > s->most_stalls) {
        return stop(s, STALLED, 0, 0);
    }
    s->time = s->reached;
    return make_changes(s, s->time) && perform(s, s->exchange);
}

static bool begin(simulation *s)
{
    int64_t before = s->next_change;
    s->time = s->reached = s->points[0];
    if (!make_changes(s, s->time)) {
        return false;
    }
    return s->next_change == before || perform(s, s->exchange);
}

static bool run_row(simulation *s, int64_t i)
{
    s->row = i;
    if (i == 0) {
        if (!begin(s)) {
            return false;
        }
    } else {
        s->time = s->points[i - 1];
        while (s->time < s->points[i]) {
            if (!advance(s, s->points[i])) {
                return false;
            }
        }
    }
    if (!perform(s, s->point)) {
        return false;
    }
    char *row = s->rows + i * s->row_size;
    memcpy(row, &s->points[i], sizeof(double));
    for (int64_t k = 0; k < s->column_count; k++) {
        copy_values(&s->columns[k], row + s->columns[k].offset);
    }
    return true;
}

int64_t run_rows(simulation *s, int64_t first, int64_t last)
{
    s->outcome = DONE;
    for (int64_t i = first; i <= last; i++) {
        if (!run_row(s, i)) {
            break;
        }
    }
    return s->outcome;
}
