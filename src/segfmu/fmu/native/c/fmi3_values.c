/* FMI 3.0: values, derivatives, dependencies, clocks. */
#include "fmi3.h"

/* modes in which values are read */
enum { READABLE = MODE_ANY | MODE_UPDATE };

/* Types that no variable has: only a call for no variable is in order. */
#define WITHOUT(Type)                                                                             \
    fmi3Status fmi3Get##Type(fmi3Instance c, const fmi3ValueReference references[], size_t count, \
                             fmi3##Type values[], size_t size)                                    \
    {                                                                                             \
        ALLOW(READABLE);                                                                          \
        return status(glue_readable(c, __func__, references, count, values, size, 0));            \
    }                                                                                             \
    fmi3Status fmi3Set##Type(fmi3Instance c, const fmi3ValueReference references[], size_t count, \
                             const fmi3##Type values[], size_t size)                              \
    {                                                                                             \
        ALLOW(MODE_ANY);                                                                          \
        return status(glue_settable(c, __func__, references, count, values, size, 0));            \
    }

WITHOUT(Float32)
WITHOUT(Int8)
WITHOUT(UInt8)
WITHOUT(Int16)
WITHOUT(UInt16)
WITHOUT(UInt32)
WITHOUT(UInt64)
WITHOUT(String)

/* Whole numbers and truth values, arrays row by row. */
#define WHOLE(Type, kinds)                                                                        \
    fmi3Status fmi3Get##Type(fmi3Instance c, const fmi3ValueReference references[], size_t count, \
                             fmi3##Type values[], size_t size)                                    \
    {                                                                                             \
        ALLOW(READABLE);                                                                          \
        if (!glue_readable(c, __func__, references, count, values, size, kinds)) {                \
            return fmi3Error;                                                                     \
        }                                                                                         \
        for (size_t i = 0; i < count; i++) {                                                      \
            const size_t elements = glue_elements_of(c, glue_variable(references[i]));            \
            for (size_t k = 0; k < elements; k++) {                                               \
                *values++ = (fmi3##Type)glue_integer(c, references[i], k);                        \
            }                                                                                     \
        }                                                                                         \
        return fmi3OK;                                                                            \
    }                                                                                             \
    fmi3Status fmi3Set##Type(fmi3Instance c, const fmi3ValueReference references[], size_t count, \
                             const fmi3##Type values[], size_t size)                              \
    {                                                                                             \
        ALLOW(MODE_ANY);                                                                          \
        if (!glue_settable(c, __func__, references, count, values, size, kinds)) {                \
            return fmi3Error;                                                                     \
        }                                                                                         \
        for (size_t i = 0; i < count; i++) {                                                      \
            const size_t elements = glue_elements_of(c, glue_variable(references[i]));            \
            for (size_t k = 0; k < elements; k++) {                                               \
                if (!glue_set_integer(c, references[i], k, (int64_t)*values++)) {                 \
                    return fmi3Error;                                                             \
                }                                                                                 \
            }                                                                                     \
        }                                                                                         \
        return fmi3OK;                                                                            \
    }

/* descriptions may have enumerations as integers */
WHOLE(Int32, 1 << KIND_INTEGER | 1 << KIND_ENUMERATION)
WHOLE(Int64, 1 << KIND_ENUMERATION)
WHOLE(Boolean, 1 << KIND_BOOLEAN)

fmi3Status fmi3GetFloat64(fmi3Instance self, const fmi3ValueReference references[], size_t count,
                          fmi3Float64 values[], size_t size)
{
    instance *c = self;
    ALLOW(READABLE);
    if (!glue_readable(c, __func__, references, count, values, size, 1 << KIND_REAL)) {
        return fmi3Error;
    }
    glue_get_reals(c, references, count, values);
    return fmi3OK;
}

fmi3Status fmi3SetFloat64(fmi3Instance self, const fmi3ValueReference references[], size_t count,
                          const fmi3Float64 values[], size_t size)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    return status(glue_settable(c, __func__, references, count, values, size, 1 << KIND_REAL)
                  && glue_set_reals(c, references, count, values, size));
}

fmi3Status fmi3GetBinary(fmi3Instance self, const fmi3ValueReference references[], size_t count,
                         size_t sizes[], fmi3Binary values[], size_t size)
{
    instance *c = self;
    ALLOW(READABLE);
    (void)sizes;
    return status(glue_readable(c, __func__, references, count, values, size, 0));
}

fmi3Status fmi3SetBinary(fmi3Instance self, const fmi3ValueReference references[], size_t count,
                         const size_t sizes[], const fmi3Binary values[], size_t size)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    (void)sizes;
    return status(glue_settable(c, __func__, references, count, values, size, 0));
}

/* ---- clocks: there are none ---- */

static fmi3Status no_clock(fmi3Instance self, const fmi3ValueReference references[], size_t count,
                           const char *function)
{
    instance *c = self;
    if (!glue_allows(c, MODE_ANY, function)) {
        return fmi3Error;
    }
    return status(glue_readable(c, function, references, count, references, count, 0));
}

fmi3Status fmi3GetClock(fmi3Instance self, const fmi3ValueReference references[], size_t count,
                        fmi3Clock values[])
{
    (void)values;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3SetClock(fmi3Instance self, const fmi3ValueReference references[], size_t count,
                        const fmi3Clock values[])
{
    (void)values;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance self, const fmi3ValueReference references[],
                                  size_t count, fmi3Float64 intervals[],
                                  fmi3IntervalQualifier qualifiers[])
{
    (void)intervals;
    (void)qualifiers;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance self, const fmi3ValueReference references[],
                                   size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                   fmi3IntervalQualifier qualifiers[])
{
    (void)counters;
    (void)resolutions;
    (void)qualifiers;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance self, const fmi3ValueReference references[],
                               size_t count, fmi3Float64 shifts[])
{
    (void)shifts;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3GetShiftFraction(fmi3Instance self, const fmi3ValueReference references[],
                                size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
{
    (void)counters;
    (void)resolutions;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance self, const fmi3ValueReference references[],
                                  size_t count, const fmi3Float64 intervals[])
{
    (void)intervals;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance self, const fmi3ValueReference references[],
                                   size_t count, const fmi3UInt64 counters[],
                                   const fmi3UInt64 resolutions[])
{
    (void)counters;
    (void)resolutions;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance self, const fmi3ValueReference references[],
                               size_t count, const fmi3Float64 shifts[])
{
    (void)shifts;
    return no_clock(self, references, count, __func__);
}

fmi3Status fmi3SetShiftFraction(fmi3Instance self, const fmi3ValueReference references[],
                                size_t count, const fmi3UInt64 counters[],
                                const fmi3UInt64 resolutions[])
{
    (void)counters;
    (void)resolutions;
    return no_clock(self, references, count, __func__);
}
