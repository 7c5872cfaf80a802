/* What the sources of FMI 3.0 share. */
#ifndef SEGFMU_FMI3_H
#define SEGFMU_FMI3_H

#include "fmi3Functions.h"

#include "glue.h"

#define ALLOW(modes) if (!glue_allows(c, (modes), __func__)) return fmi3Error
#define GIVEN(pointer) if (!glue_given(c, (pointer), __func__)) return fmi3Error

static inline fmi3Status status(bool good)
{
    return good ? fmi3OK : fmi3Error;
}

#endif
