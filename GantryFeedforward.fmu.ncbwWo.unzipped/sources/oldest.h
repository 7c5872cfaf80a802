/* A shared library for x86_64 Linux asks for the functions of the oldest glibc: the newer versions of
   these three differ in errno alone, and would need glibc 2.29. */
#include <stdint.h>

#if defined(SEGFMU_OLDEST_GLIBC) && defined(__GLIBC__) && defined(__x86_64__)
__asm__(".symver exp,exp@GLIBC_2.2.5\n.symver log,log@GLIBC_2.2.5\n.symver pow,pow@GLIBC_2.2.5");
#endif
