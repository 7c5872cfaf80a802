/* What GantryCrane remembers of what is between rope and load: nothing. */
#ifndef SEGFMU_SUSPENSION_H
#define SEGFMU_SUSPENSION_H

#include <stdint.h>

typedef struct {
    int64_t nothing;
} suspension;

#endif
