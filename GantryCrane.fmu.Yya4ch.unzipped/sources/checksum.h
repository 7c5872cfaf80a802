/* A sum that tells whether bytes are those that were written. */
#ifndef SEGFMU_CHECKSUM_H
#define SEGFMU_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline uint64_t checksum_mixed(uint64_t sum, uint64_t word)
{
    sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
    return sum ^ (sum >> 29);
}

/* Over whole words. */
static inline uint64_t checksum(const void *bytes, size_t size)
{
    uint64_t sum = size, word;
    for (size_t i = 0; i + sizeof word <= size; i += sizeof word) {
        memcpy(&word, (const char *)bytes + i, sizeof word);
        sum = checksum_mixed(sum, word);
    }
    return sum;
}

#endif
