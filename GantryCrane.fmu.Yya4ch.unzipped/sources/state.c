/* Saved states: the part of an instance's block that is in use, behind a header. As the block has
   no pointers, a copy in another instance, process or run goes on bit for bit. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "build.h"
#include "checksum.h"
#include "glue.h"

typedef struct {
    uint64_t format;     /* the same in all states */
    uint64_t model;      /* of its name */
    uint64_t build;      /* of the sources, and of the sizes that the compiler gave */
    uint64_t interface;  /* model exchange or co-simulation */
    uint64_t token;      /* of the description, with the start values */
    uint64_t size;       /* bytes of the block behind the header */
    uint64_t sum;        /* over the block, in serialised form */
} header;

static uint64_t mark(const char *text)
{
    uint64_t sum = 1;
    for (; *text != '\0'; text++) {
        sum = checksum_mixed(sum, (unsigned char)*text);
    }
    return sum;
}

/* A block has this layout where the sources and the sizes of structures are the same. */
static uint64_t build(void)
{
    return checksum_mixed(checksum_mixed(BUILD_MARK, sizeof(model)), model_least());
}

static header header_of(const instance *c, size_t size)
{
    header head = {mark("segfmu state"), mark(model_name), build(),
                   (uint64_t)c->model->interface, mark(c->start.token), size, 0};
    return head;
}

bool glue_save(instance *c, void **state)
{
    size_t used = model_used(c->model);
    header head = header_of(c, used);
    if (*state != NULL && glue_state_size(*state) != sizeof head + used) {
        free(*state);
        *state = NULL;
    }
    char *bytes = *state == NULL ? malloc(sizeof head + used) : *state;
    if (bytes == NULL) {
        glue_log(c, STATUS_ERROR, "out of memory");
        return false;
    }
    memcpy(bytes, &head, sizeof head);
    memcpy(bytes + sizeof head, c->model, used);
    *state = bytes;
    return true;
}

/* What a header says of another instance than this one, the most general first; NULL if nothing. */
static const char *difference(const instance *c, const header *head)
{
    header own = header_of(c, 0);
    if (head->format != own.format) {
        return "these bytes are no saved state";
    }
    if (head->model != own.model) {
        return "the state is one of another model";
    }
    if (head->build != own.build) {
        return "the state was saved by another build of this model or by that of another version of "
               "FMI; save it again with this FMU";
    }
    if (head->interface != own.interface) {
        return own.interface == MODEL_EXCHANGE
            ? "the state is one of co-simulation, this instance is for model exchange"
            : "the state is one of model exchange, this instance is for co-simulation";
    }
    if (head->token != own.token) {
        return "the state was saved by an FMU with another GUID, so with other start values, as those "
               "of another mission; restore it there, or save it again with this FMU";
    }
    return head->size < model_least() ? "the state has a size that no state of this model has" : NULL;
}

/* Whether a header is that of a state of this model and of this build of it. */
static bool fits(instance *c, const header *head)
{
    const char *message = difference(c, head);
    if (message != NULL) {
        glue_log(c, STATUS_ERROR, "%s", message);
    }
    return message == NULL;
}

static bool is_truth(int64_t value)
{
    return value == 0 || value == 1;
}

/* Whether what the parameters say of sizes and choices is in range, and all numbers are finite. */
static bool sound_values(const instance *c, const model *m)
{
    for (size_t i = 0; i < MODEL_VARIABLES; i++) {
        const variable *v = &model_variables[i];
        double value = (double)m->integer[v->kind == KIND_REAL ? 0 : v->offset];
        const range *within = &model_ranges[glue_label(v)->range];
        double most = v->counts ? (double)c->start.rows : within->most;
        if (v->kind != KIND_REAL && v->setting != SET_NEVER
            && !(value >= within->least && value <= most)) {
            return false;
        }
    }
    for (size_t i = 0; i < MODEL_REALS; i++) {
        if (!isfinite(m->real[i])) {
            return false;
        }
    }
    return m->interface == c->model->interface
        && memcmp(m->held, c->start.real, MODEL_INPUTS * sizeof *m->held) == 0
        && fabs(m->start) <= LATEST && fabs(m->met) <= LATEST
        && fabs(m->real[V_TIME]) <= LATEST && isfinite(m->stop) && isfinite(m->step_start)
        && isfinite(m->step_end);
}

/* Bytes from outside can have a sum that fits and values that do not: whether a block's mode exists,
   and its sizes and indices are within it. */
static bool sound(const instance *c, const model *m, size_t size)
{
    bool mode = m->mode > 0 && m->mode <= MODE_FAILED && (m->mode & (m->mode - 1)) == 0
        && (m->mode & MODE_ANY) != 0;
    bool starting = m->mode == MODE_EVENT && m->starting;
    bool ready = m->initialised || starting
        || (m->mode & (MODE_RUNNING | MODE_TERMINATED)) == 0;
    return mode && ready && is_truth(m->initialised) && is_truth(m->starting)
        && is_truth(m->evaluated) && is_truth(m->stops) && is_truth(m->running)
        && is_truth(m->given) && is_truth(m->sloped) && is_truth(m->tuned)
        && is_truth(m->awaited) && sound_values(c, m) && model_sound(m, size);
}

bool glue_restore(instance *c, const void *state)
{
    header head;
    memcpy(&head, state, sizeof head);
    if (!fits(c, &head) || !glue_reserve(c, (size_t)head.size)) {
        return false;
    }
    memcpy(c->model, (const char *)state + sizeof head, (size_t)head.size);
    memset((char *)c->model + head.size, 0, c->capacity - (size_t)head.size);
    return true;
}

size_t glue_state_size(const void *state)
{
    header head;
    memcpy(&head, state, sizeof head);
    return sizeof head + (size_t)head.size;
}

void glue_free_state(void **state)
{
    free(*state);
    *state = NULL;
}

bool glue_serialise(instance *c, const void *state, void *bytes, size_t size)
{
    header head;
    memcpy(&head, state, sizeof head);
    if (!fits(c, &head)) {
        return false;
    }
    if (size < glue_state_size(state)) {
        glue_log(c, STATUS_ERROR, "the state has %lu bytes, there is room for %lu",
                 (unsigned long)glue_state_size(state), (unsigned long)size);
        return false;
    }
    const char *block = (const char *)state + sizeof head;
    head.sum = checksum(block, (size_t)head.size);
    memcpy(bytes, &head, sizeof head);
    memcpy((char *)bytes + sizeof head, block, (size_t)head.size);
    return true;
}

bool glue_deserialise(instance *c, const void *bytes, size_t size, void **state)
{
    header head;
    if (size < sizeof head) {
        glue_log(c, STATUS_ERROR, "%lu bytes are not a saved state", (unsigned long)size);
        return false;
    }
    memcpy(&head, bytes, sizeof head);
    if (!fits(c, &head)) {
        return false;
    }
    if (head.size != size - sizeof head) {
        glue_log(c, STATUS_ERROR, "the saved state is damaged: its header is that of %.0f bytes, there "
                 "are %lu", (double)sizeof head + (double)head.size, (unsigned long)size);
        return false;
    }
    const char *block = (const char *)bytes + sizeof head;
    if (head.sum != checksum(block, (size_t)head.size)) {
        glue_log(c, STATUS_ERROR, "the bytes of the saved state are damaged");
        return false;
    }
    char *copy = malloc(sizeof head + (size_t)head.size);
    if (copy == NULL) {
        glue_log(c, STATUS_ERROR, "out of memory");
        return false;
    }
    memcpy(copy, bytes, sizeof head + (size_t)head.size);
    if (!sound(c, (const model *)(const void *)(copy + sizeof head), (size_t)head.size)) {
        glue_log(c, STATUS_ERROR, "the saved state has values that no simulation comes to");
        free(copy);
        return false;
    }
    *state = copy;
    return true;
}
