/* What FMUs have told in a run, in its order, for runs in which they would tell the same. */
#include <stdbool.h>
#include <string.h>

#include "loop.h"

void keep_told(tape *t, const void *from, size_t bytes)
{
    if (t->use != RECORDS) {
        return;
    }
    if (bytes > t->size - t->place) {
        t->use = UNUSED;
        return;
    }
    memcpy(t->data + t->place, from, bytes);
    t->place += bytes;
}

bool tell_again(tape *t, void *to, size_t bytes)
{
    if (bytes > t->size - t->place) {
        return false;
    }
    memcpy(to, t->data + t->place, bytes);
    t->place += bytes;
    return true;
}
