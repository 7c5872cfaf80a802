/* Generated from the interface specification in Python; never edited. */
/* Compile this file alone: it includes all others. Nothing but the functions of FMI is visible
   outside; FMI2_FUNCTION_PREFIX, FMI3_FUNCTION_PREFIX go before their names. */
/* no model calls all of these */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#ifdef SEGFMU_KERNELS_APART
#include "oldest.h"
#else
#define SEGFMU_API static
#include "core.c"
#endif
#include "variables.c"
#include "feed.c"
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "feedforward.c"
#include "feedforward_choice.c"
#include "feedforward_limits.c"
#include "feedforward_operation.c"
#include "feedforward_outputs.c"
#include "feedforward_places.c"
#include "feedforward_plan.c"
#include "feeds.c"
#include "flat_inverse.c"
#include "fmi2.c"
#include "fmi2_run.c"
#include "instance.c"
#include "say.c"
#include "simulation.c"
#include "start.c"
#include "state.c"
#include "values.c"
