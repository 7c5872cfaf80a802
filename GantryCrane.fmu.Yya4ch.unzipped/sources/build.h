/* Generated from the interface specification in Python; never edited. */
#ifndef SEGFMU_BUILD_H
#define SEGFMU_BUILD_H

/* of the sources: with others, values lie in memory and in files in another way */
#define BUILD_MARK 0xbbe59eb155348303u

#endif
