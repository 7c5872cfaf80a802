/* Generated from the texts in kernels/messages.py by `python -m segfmu.codegen`; never edited. */
#ifndef SEGFMU_MESSAGES_H
#define SEGFMU_MESSAGES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "visible.h"

/* The message of a status and its report; false for a status without one. */
SEGFMU_API bool segfmu_plan_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_rope_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_limit_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_bound_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_path_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_space_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_ready_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_takeover_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_plant_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_setup_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_range_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_access_message(
    int64_t status, const double *report, char *text, size_t size);
SEGFMU_API bool segfmu_start_message(
    int64_t status, const double *report, char *text, size_t size);

#endif
