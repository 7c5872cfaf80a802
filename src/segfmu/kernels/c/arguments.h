/* What the compiled Python module needs to take its arguments. */
#ifndef SEGFMU_ARGUMENTS_H
#define SEGFMU_ARGUMENTS_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <stdbool.h>
#include <string.h>

#include "kernels.h"

enum { MOST_ARRAYS = 24 };

/* The arguments of one call, and the buffers that it holds. */
typedef struct {
    const char *function;
    PyObject *const *values;
    int buffers;
    Py_buffer buffer[MOST_ARRAYS];
} arguments;

static void release_arguments(arguments *call)
{
    while (call->buffers > 0) {
        PyBuffer_Release(&call->buffer[--call->buffers]);
    }
}

static bool take_count(const arguments *call, Py_ssize_t count, Py_ssize_t expected)
{
    if (count == expected) {
        return true;
    }
    PyErr_Format(PyExc_TypeError, "%s() takes %zd arguments, got %zd", call->function, expected,
                 count);
    return false;
}

static bool take_float(const arguments *call, int index, double *value)
{
    *value = PyFloat_AsDouble(call->values[index]);
    return !(*value == -1.0 && PyErr_Occurred());
}

static bool take_int(const arguments *call, int index, int64_t *value)
{
    *value = PyLong_AsLongLong(call->values[index]);
    return !(*value == -1 && PyErr_Occurred());
}

static bool take_bool(const arguments *call, int index, bool *value)
{
    int truth = PyObject_IsTrue(call->values[index]);
    *value = truth > 0;
    return truth >= 0;
}

/* The array in argument `index`: C order, `rank` dimensions, 'd' double or 'l' 64-bit integer. */
static Py_buffer *take_array(arguments *call, int index, int rank, char type, bool writable)
{
    int flags = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT | (writable ? PyBUF_WRITABLE : 0);
    Py_buffer *buffer = &call->buffer[call->buffers];
    if (PyObject_GetBuffer(call->values[index], buffer, flags) != 0) {
        return NULL;
    }
    call->buffers++;
    const char *format = buffer->format ? buffer->format : "B";
    bool fits = type == 'd' ? strcmp(format, "d") == 0
                            : (strcmp(format, "l") == 0 || strcmp(format, "q") == 0);
    if (buffer->ndim != rank || buffer->itemsize != 8 || !fits) {
        PyErr_Format(PyExc_TypeError, "%s() argument %d: expected a %d-dimensional array of %s",
                     call->function, index + 1, rank, type == 'd' ? "float64" : "int64");
        return NULL;
    }
    return buffer;
}

static bool has_extent(const arguments *call, const char *name, int dimension, Py_ssize_t extent,
                       int64_t expected)
{
    if (extent == expected) {
        return true;
    }
    PyErr_Format(PyExc_IndexError, "%s() argument %s: dimension %d must be %lld, got %zd",
                 call->function, name, dimension, (long long)expected, extent);
    return false;
}

static bool has_at_least(const arguments *call, const char *name, int dimension, Py_ssize_t extent,
                         int64_t least)
{
    if (extent >= least) {
        return true;
    }
    PyErr_Format(PyExc_IndexError, "%s() argument %s: dimension %d must be at least %lld, got %zd",
                 call->function, name, dimension, (long long)least, extent);
    return false;
}

/* The first piece of each axis and the end of the last one: every axis has one of the `pieces`. */
static bool has_pieces(const arguments *call, const char *name, const int64_t *offsets,
                       int64_t count, int64_t least, int64_t pieces)
{
    bool good = offsets[0] >= 0 && offsets[count - 1] <= pieces;
    for (int64_t i = 1; i < count; i++) {
        good = good && offsets[i] - offsets[i - 1] >= least;
    }
    if (!good) {
        PyErr_Format(PyExc_IndexError, "%s() argument %s: must ascend from 0 to at most %lld",
                     call->function, name, (long long)pieces);
    }
    return good;
}

#endif
