/* Records of the kernels from variables, and variables from records, by tables of their places. */
#ifndef SEGFMU_FEED_H
#define SEGFMU_FEED_H

#include "model.h"

typedef struct {
    uint16_t place;   /* in the record */
    uint16_t offset;  /* of the variable, in `real` or `integer` */
    uint16_t step;    /* to that of the next row, where the record is a row of a table */
    uint8_t base;     /* value of the variable that is 0 in the record */
    bool whole;       /* the variable is in `integer` */
} feed;

/* Values that follow each other in the record and in `real`. */
typedef struct {
    uint16_t place, offset, count;
} feed_run;

/* The rows of `real` come first; the runs are the same rows. */
typedef struct {
    const feed *rows;
    int64_t count, reals;
    const feed_run *runs;
    int64_t run_count;
} feeds;

/* Fill a record; what no variable feeds stays. */
static void feed_record(const feeds *table, const model *m, double record[]);

/* Fill a record that is a row of a table, counted from 0. */
static void feed_row(const feeds *table, const model *m, int64_t row, double record[]);

/* Whether all real variables of a table with so many rows have these values, which are laid out as
   `real`. */
static bool feed_same(const feeds *table, const model *m, int64_t rows, const double real[]);

/* Set the variables of a record; a Boolean is true above 0. */
static void show_record(const feeds *table, const double record[], model *m);

/* The place of a variable, by its offset in `real`, in a record; -1 where it has none. */
static int feed_place(const feeds *table, int64_t offset);

/* The offset of the variable that belongs to a place of a record; there has to be one. */
static int feed_offset(const feeds *table, int place);

#endif
