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

#include "crane.c"
#include "crane_differences.c"
#include "crane_failure.c"
#include "crane_gains.c"
#include "crane_inputs.c"
#include "crane_lengths.c"
#include "crane_partials.c"
#include "crane_setup.c"
#include "crane_start.c"
#include "crane_tracking.c"
#include "crane_warning.c"
#include "feeds.c"
#include "fmi2.c"
#include "fmi2_run.c"
#include "instance.c"
#include "say.c"
#include "simulation.c"
#include "start.c"
#include "state.c"
#include "suspension.c"
#include "values.c"
