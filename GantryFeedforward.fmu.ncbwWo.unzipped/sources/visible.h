/* What programs may call. One that includes the sources, to be a single translation unit, defines
   SEGFMU_API as static before, and shows nothing of them. */
#ifndef SEGFMU_API
#define SEGFMU_API
#endif
