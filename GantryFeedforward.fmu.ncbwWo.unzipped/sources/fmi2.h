/* What the sources of FMI 2.0 share. */
#ifndef SEGFMU_FMI2_H
#define SEGFMU_FMI2_H

#include "fmi2Functions.h"

#include "glue.h"

#define ALLOW(modes) if (!glue_allows(c, (modes), __func__)) return fmi2Error
#define GIVEN(pointer) if (!glue_given(c, (pointer), __func__)) return fmi2Error

static inline fmi2Status status(bool good)
{
    return good ? fmi2OK : fmi2Error;
}

#endif
