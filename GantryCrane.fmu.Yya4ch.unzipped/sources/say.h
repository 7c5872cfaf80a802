/* Messages of the models. */
#ifndef SEGFMU_SAY_H
#define SEGFMU_SAY_H

#include "model.h"

/* Write a message; returns false, as every function does that leaves one. */
static bool say(char message[MESSAGE], const char *format, ...);

#endif
