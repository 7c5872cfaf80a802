/* Runs the crane's sampled loop without Python: the case on standard input, a row of output a step.

   The steps from the middle on are done twice, the second time after the memory was put back and
   the rig been started afresh; it prints both. With an argument it prints the microseconds a step
   takes, over that many runs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "kernels.h"
#include "records.h"

enum { TRACKER = TRACKER_SIZE * TRACKER_COLUMNS };

typedef struct {
    array_double_1d state;
    array_double_2d settings, components, changes, steps, memory, tracker;
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
    r.settings = matrix(SETTINGS_SIZE, SETTINGS_COLUMNS);
    r.state = vector(PLANT_STATE_SIZE);
    double *start = numbers(1);
    r.start = *start;
    free(start);
    r.components = matrix(components, SINUSOID_SIZE);
    r.changes = matrix(changes, PAYLOAD_CHANGE_SIZE);
    r.table = stack(rows, OBSERVER_SIZE, OBSERVER_COLUMNS);
    r.gains = stack(rows, GAINS_SIZE, GAINS_COLUMNS);
    r.steps = matrix(1 + steps, 1 + SETPOINTS_SIZE);
    int64_t used = segfmu_rig_rows(r.settings);
    r.size = (size_t)(used * MEMORY_COLUMNS + TRACKER) * sizeof(double);
    r.block = malloc(r.size);
    r.memory = (array_double_2d){r.block, {used, MEMORY_COLUMNS}};
    r.tracker = (array_double_2d){r.block + used * MEMORY_COLUMNS, {TRACKER_SIZE, TRACKER_COLUMNS}};
    return r;
}

static void start(rig *r)
{
    array_double_1d first = {r->steps.data + 1, {SETPOINTS_SIZE}};
    memset(r->tracker.data, 0, TRACKER * sizeof(double));
    segfmu_rig_start(r->settings, r->components, r->changes, r->state, first, r->start, r->memory);
}

static void print_row(const rig *r, int place, int count)
{
    for (int i = 0; i < count; i++) {
        printf("%a ", r->memory.data[place * MEMORY_COLUMNS + i]);
    }
}

static void run(rig *r, int64_t from, int64_t to, int print)
{
    for (int64_t i = from; i < to; i++) {
        double *row = r->steps.data + i * (1 + SETPOINTS_SIZE);
        array_double_1d setpoints = {row + 1, {SETPOINTS_SIZE}};
        if (segfmu_rig_step(r->settings, r->components, r->changes, r->table, r->gains, r->tracker,
                            setpoints, row[0], r->memory) != PLANT_STATUS_DONE) {
            exit(3);
        }
        if (print) {
            print_row(r, MEMORY_STATE, STATE_SIZE);
            print_row(r, MEMORY_SIGNALS, COORDINATES_SIZE);
            print_row(r, MEMORY_REPORT, REPORT_SATURATED);
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
        r.settings.data, r.state.data, r.components.data, r.changes.data, r.table.data,
        r.gains.data, r.steps.data, r.block, saved
    };
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        free(all[i]);
    }
    return 0;
}
