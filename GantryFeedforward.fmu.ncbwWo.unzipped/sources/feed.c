/* Records of the kernels from variables, and variables from records. */
#include "feed.h"

#include <string.h>

void feed_row(const feeds *table, const model *m, int64_t row, double record[])
{
    for (int64_t i = 0; i < table->count; i++) {
        const feed *f = &table->rows[i];
        int64_t offset = f->offset + row * f->step;
        record[f->place] = f->whole ? (double)(m->integer[offset] - f->base) : m->real[offset];
    }
}

void feed_record(const feeds *table, const model *m, double record[])
{
    for (int64_t i = 0; i < table->run_count; i++) {
        const feed_run *r = &table->runs[i];
        memcpy(record + r->place, m->real + r->offset, r->count * sizeof *record);
    }
    for (int64_t i = table->reals; i < table->count; i++) {
        const feed *f = &table->rows[i];
        record[f->place] = (double)(m->integer[f->offset] - f->base);
    }
}

bool feed_same(const feeds *table, const model *m, int64_t rows, const double real[])
{
    for (int64_t i = 0; i < rows * table->count; i++) {
        const feed *f = &table->rows[i % table->count];
        int64_t offset = f->offset + i / table->count * f->step;
        if (!f->whole && m->real[offset] != real[offset]) {
            return false;
        }
    }
    return true;
}

void show_record(const feeds *table, const double record[], model *m)
{
    for (int64_t i = 0; i < table->run_count; i++) {
        const feed_run *r = &table->runs[i];
        memcpy(m->real + r->offset, record + r->place, r->count * sizeof *record);
    }
    for (int64_t i = table->reals; i < table->count; i++) {
        const feed *f = &table->rows[i];
        m->integer[f->offset] = record[f->place] > 0.0;
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
