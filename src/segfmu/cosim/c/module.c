/* The module segfmu.cosim._loop: runs rows of a simulation that native.py has laid out in memory. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "loop.h"

static PyObject *run(PyObject *self, PyObject *given)
{
    unsigned long long address;
    long long first, last;
    int64_t outcome;
    (void)self;
    if (!PyArg_ParseTuple(given, "KLL", &address, &first, &last)) {
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    outcome = run_rows((simulation *)(uintptr_t)address, first, last);
    Py_END_ALLOW_THREADS
    return PyLong_FromLongLong(outcome);
}

static PyMethodDef methods[] = {
    {"run", run, METH_VARARGS,
     "run(address, first, last): do the steps to these communication points; 0, or what ended it."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_loop", "The step loop of the co-simulation master, compiled.", 0,
    methods, NULL, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit__loop(void)
{
    PyObject *module = PyModule_Create(&definition);
    if (module && PyModule_AddIntConstant(module, "SIZE", (long)sizeof(simulation)) != 0) {
        Py_DECREF(module);
        return NULL;
    }
    return module;
}
