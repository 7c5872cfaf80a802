/* Random numbers, references, values and pointers for calls that an FMU must survive. */
#ifndef RANDOM_H
#define RANDOM_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static uint64_t random_state = 1;

static uint64_t random_word(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state * 0x2545F4914F6CDD1Du >> 11;
}

static int below(int n)
{
    return (int)(random_word() % (uint64_t)n);
}

static int rarely(void)
{
    return below(40) == 0;
}

static double unit(void)
{
    return (double)random_word() / 9007199254740992.0;
}

/* Mostly of use, sometimes not a number, infinite, huge, tiny or of the wrong sign. */
static double random_real(void)
{
    static const double odd[] = {
        NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e-300, 0.0, -1.0, 1e9, 5e-324, -0.0, 1e20
    };
    if (below(12) == 0) {
        return odd[below(12)];
    }
    return below(2) ? unit() : 4.0 * unit() - 2.0;
}

static int random_integer(void)
{
    static const int odd[] = {2147483647, -2147483647 - 1, -1, 0, 17, 1000000};
    return below(6) == 0 ? odd[below(6)] : below(6);
}

static uint32_t random_reference(int variables)
{
    return rarely() ? (uint32_t)random_word() : 1 + (uint32_t)below(variables);
}

#endif
