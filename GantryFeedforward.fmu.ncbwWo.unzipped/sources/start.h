/* Start values of all variables, read from the resources of the archive. */
#ifndef SEGFMU_START_H
#define SEGFMU_START_H

#include "model.h"

enum { LONGEST_TOKEN = 40 };

typedef struct {
    int64_t rows;                     /* of the arrays */
    int64_t variables;                /* that the description has */
    char token[LONGEST_TOKEN + 1];    /* GUID of the description */
    double real[MODEL_REALS];
    int64_t integer[MODEL_INTEGERS];
} start_values;

/* Read them from the folder that an importer names, a path or a URI; false with a message. */
static bool start_read(const char *location, start_values *start, char message[MESSAGE]);

#endif
