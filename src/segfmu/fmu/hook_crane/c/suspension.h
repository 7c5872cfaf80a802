/* What HookCrane remembers of hook and sling. */
#ifndef SEGFMU_SUSPENSION_H
#define SEGFMU_SUSPENSION_H

#include <stdint.h>

#include "records.h"

/* rope lengths of the feedback's table at most, and the size of its part for one */
enum { HOOK_LENGTHS = 9, HOOK_BLOCK = HOOK_TABLE_SIZE * HOOK_TABLE_COLUMNS };

typedef struct {
    /* start values of the sling's state, and the state that follows from them */
    double own[SLING_SIZE], hung[SLING_SIZE];
    /* of the feedback of measured signals: its table, and estimates with work space */
    double table[HOOK_LENGTHS * HOOK_BLOCK], estimates[(AXES_SIZE + 1) * HOOK_AXIS_SIZE];
    int64_t count;
} suspension;

#endif
