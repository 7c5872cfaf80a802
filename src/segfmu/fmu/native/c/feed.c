/* Records of the kernels from variables, and variables from records. */
#include "feed.h"

void feed_record(const feeds *table, const model *m, double record[])
{
    for (int64_t i = 0; i < table->count; i++) {
        const feed *f = &table->rows[i];
        record[f->place] = f->whole ? (double)(m->integer[f->offset] - f->base)
                                    : m->real[f->offset];
    }
}

void show_record(const feeds *table, const double record[], model *m)
{
    for (int64_t i = 0; i < table->count; i++) {
        const feed *f = &table->rows[i];
        if (f->whole) {
            m->integer[f->offset] = record[f->place] > 0.0;
        } else {
            m->real[f->offset] = record[f->place];
        }
    }
}

int feed_place(const feeds *table, int64_t offset)
{
    for (int64_t i = 0; i < table->count; i++) {
        if (!table->rows[i].whole && table->rows[i].offset == offset) {
            return table->rows[i].place;
        }
    }
    return -1;
}

int feed_offset(const feeds *table, int place)
{
    int64_t i = 0;
    while (table->rows[i].place != place) {
        i++;
    }
    return table->rows[i].offset;
}
