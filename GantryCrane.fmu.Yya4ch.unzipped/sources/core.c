/* Generated from the interface specification in Python; never edited. */
/* The kernels: fmu.c includes them, or is linked with them where SEGFMU_KERNELS_APART is defined. */
#include "oldest.h"

#include "kernels.c"
#include "messages.c"
#include "plan.c"
