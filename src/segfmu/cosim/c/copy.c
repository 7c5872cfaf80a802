/* Values of any type of FMI into buffers and columns of another one of the same kind. */
#include <stdbool.h>
#include <string.h>

#include "loop.h"

static size_t width(int64_t type)
{
    switch (type) {
    case F64: case I64: case U64: return 8;
    case F32: case I32: case U32: return 4;
    case I16: case U16: return 2;
    default: return 1;
    }
}

static bool is_real(int64_t type)
{
    return type == F64 || type == F32;
}

static double real(const char *from, int64_t type)
{
    double wide;
    float narrow;
    if (type == F64) {
        memcpy(&wide, from, sizeof wide);
        return wide;
    }
    memcpy(&narrow, from, sizeof narrow);
    return narrow;
}

static void put_real(char *to, int64_t type, double value)
{
    float narrow = (float)value;
    if (type == F64) {
        memcpy(to, &value, sizeof value);
    } else {
        memcpy(to, &narrow, sizeof narrow);
    }
}

#define READ(kind) { kind value; memcpy(&value, from, sizeof value); return (int64_t)value; }

static int64_t whole(const char *from, int64_t type)
{
    switch (type) {
    case I8: READ(int8_t)
    case I16: READ(int16_t)
    case U16: READ(uint16_t)
    case I32: READ(int32_t)
    case U32: READ(uint32_t)
    case I64: READ(int64_t)
    case U64: READ(uint64_t)
    default: READ(uint8_t)
    }
}

#define WRITE(kind) { kind cut = (kind)value; memcpy(to, &cut, sizeof cut); return; }

static void put_whole(char *to, int64_t type, int64_t value)
{
    switch (type) {
    case BOOL: *to = value != 0; return;
    case I16: case U16: WRITE(uint16_t)
    case I32: case U32: WRITE(uint32_t)
    case I64: case U64: WRITE(uint64_t)
    default: WRITE(uint8_t)
    }
}

void copy_values(const copy *c, char *to)
{
    size_t in = width(c->from_type), out = width(c->to_type);
    if (c->from_type == c->to_type && !c->index) {
        memcpy(to, c->from, (size_t)c->count * in);
        return;
    }
    if (c->from_type == F64 && c->to_type == F64) {
        for (int64_t i = 0; i < c->count; i++, to += sizeof(double)) {
            memcpy(to, c->from + (size_t)c->index[i] * sizeof(double), sizeof(double));
        }
        return;
    }
    for (int64_t i = 0; i < c->count; i++, to += out) {
        const char *from = c->from + (size_t)(c->index ? c->index[i] : i) * in;
        if (is_real(c->from_type)) {
            put_real(to, c->to_type, real(from, c->from_type));
        } else {
            put_whole(to, c->to_type, whole(from, c->from_type));
        }
    }
}
