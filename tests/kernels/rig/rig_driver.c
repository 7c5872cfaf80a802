/* Runs the crane's sampled loop without Python: the case on standard input, a row of output a step.

   The steps from the middle on are done twice, the second time after the memory was put back and
   the rig been started afresh; it prints both. With an argument it prints the microseconds a step
   takes, over that many runs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "kernels.h"

enum { SETPOINTS = 19, COLUMNS = 40, TRACKER = 22 * 10 };

typedef struct {
    array_double_1d loop, sensors, parameters, state, tracking, lengths, gain_lengths;
    array_double_2d components, changes, steps, memory, tracker;
    array_double_3d table, gains;
    double start, *block;
    size_t size;
} rig;

static double *numbers(int64_t count)
{
    double *data = malloc((size_t)(count > 0 ? count : 1) * sizeof(double));
    for (int64_t i = 0; i < count; i++) {
        if (data == NULL || scanf("%lf", &data[i]) != 1) {
            exit(2);
        }
    }
    return data;
}

static array_double_1d vector(int64_t n)
{
    array_double_1d a = {numbers(n), {n}};
    return a;
}

static array_double_2d matrix(int64_t rows, int64_t columns)
{
    array_double_2d a = {numbers(rows * columns), {rows, columns}};
    return a;
}

static array_double_3d stack(int64_t count, int64_t rows, int64_t columns)
{
    array_double_3d a = {numbers(count * rows * columns), {count, rows, columns}};
    return a;
}

/* One block holds the memory of the loop and, behind it, that of the tracking controller. */
static rig read_rig(void)
{
    long components, changes, rows, steps;
    rig r;
    if (scanf("%ld %ld %ld %ld", &components, &changes, &rows, &steps) != 4) {
        exit(2);
    }
    r.loop = vector(5);
    r.sensors = vector(18);
    r.parameters = vector(37);
    r.state = vector(10);
    double *start = numbers(1);
    r.start = *start;
    free(start);
    r.components = matrix(components, 7);
    r.changes = matrix(changes, 2);
    r.tracking = vector(27);
    r.lengths = vector(rows);
    r.table = stack(rows, 18, 10);
    r.gain_lengths = vector(rows);
    r.gains = stack(rows, 3, 10);
    r.steps = matrix(1 + steps, 1 + SETPOINTS);
    int64_t used = segfmu_rig_rows(r.sensors.data[0], r.sensors.data[1]);
    r.size = (size_t)(used * COLUMNS + TRACKER) * sizeof(double);
    r.block = malloc(r.size);
    r.memory = (array_double_2d){r.block, {used, COLUMNS}};
    r.tracker = (array_double_2d){r.block + used * COLUMNS, {22, 10}};
    return r;
}

static void start(rig *r)
{
    array_double_1d first = {r->steps.data + 1, {SETPOINTS}};
    memset(r->tracker.data, 0, TRACKER * sizeof(double));
    segfmu_rig_start(r->loop, r->sensors, r->changes, r->parameters, r->state, first, r->start,
                     r->memory);
}

static void run(rig *r, int64_t from, int64_t to, int print)
{
    for (int64_t i = from; i < to; i++) {
        double *row = r->steps.data + i * (1 + SETPOINTS);
        array_double_1d setpoints = {row + 1, {SETPOINTS}};
        if (segfmu_rig_step(r->loop, r->sensors, r->components, r->changes, r->tracking,
                            r->lengths, r->table, r->gain_lengths, r->gains, r->tracker,
                            setpoints, row[0], r->memory) != 0) {
            exit(3);
        }
        for (int j = 0; print && j < 18; j++) {
            const double *from_row = r->memory.data + COLUMNS * (j < 10 ? 0 : j < 15 ? 5 : 4);
            printf("%a ", from_row[j < 10 ? j : j < 15 ? j - 10 : j - 15]);
        }
        if (print) {
            printf("\n");
        }
    }
}

int main(int argc, char **argv)
{
    rig r = read_rig();
    int64_t steps = r.steps.shape[0], middle = steps / 2;
    if (argc > 1) {
        long runs = atol(argv[1]);
        clock_t begin = clock();
        for (long i = 0; i < runs; i++) {
            start(&r);
            run(&r, 1, steps, 0);
        }
        double seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
        printf("%g\n", 1e6 * seconds / (double)(runs * (steps - 1)));
        return 0;
    }
    double *saved = malloc(r.size);
    start(&r);
    run(&r, 1, middle, 1);
    memcpy(saved, r.block, r.size);
    run(&r, middle, steps, 1);
    start(&r);
    memcpy(r.block, saved, r.size);
    run(&r, middle, steps, 1);
    void *all[] = {
        r.loop.data, r.sensors.data, r.parameters.data, r.state.data, r.components.data,
        r.changes.data, r.tracking.data, r.lengths.data, r.table.data, r.gain_lengths.data,
        r.gains.data, r.steps.data, r.block, saved
    };
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        free(all[i]);
    }
    return 0;
}
