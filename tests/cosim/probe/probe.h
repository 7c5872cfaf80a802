/* A small model that does what a test tells it: y = gain x + time, and failures of any kind. */
#ifndef PROBE_H
#define PROBE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { X, GAIN, FAIL_TIME, Y, NARROW, REALS };
enum { N, FAIL_STATUS, RESET_STATUS, N_OUT, RUNS, TINY, WIDE, WHOLES };
enum { FLAG, TALK, FLAG_OUT, FLAGS };

typedef void (*say)(void *environment, int status, const char *message);

typedef struct {
    double time, real[REALS];
    int64_t whole[WHOLES];
    bool flag[FLAGS];
    char text[200];
    void *environment;
    say say;
} probe;

static void probe_reset(probe *p)
{
    int64_t runs = p->whole[RUNS];
    p->time = 0.0;
    memset(p->real, 0, sizeof p->real);
    memset(p->whole, 0, sizeof p->whole);
    memset(p->flag, 0, sizeof p->flag);
    p->real[GAIN] = 1.0;
    p->real[FAIL_TIME] = 1e9;
    p->whole[RUNS] = runs;
    p->text[0] = 0;
}

static probe *probe_made(void *environment, say say)
{
    probe *p = calloc(1, sizeof *p);
    p->environment = environment;
    p->say = say;
    probe_reset(p);
    return p;
}

static void probe_evaluate(probe *p)
{
    p->real[Y] = p->real[GAIN] * p->real[X] + p->time;
    p->real[NARROW] = (double)(float)p->real[Y];
    p->whole[N_OUT] = 3 * p->whole[N];
    p->whole[WIDE] = p->whole[TINY] - 1000000000000;
    p->flag[FLAG_OUT] = !p->flag[FLAG];
}

static int probe_start(probe *p)
{
    if (p->text[0]) {
        p->say(p->environment, 1, p->text);
    }
    return p->real[GAIN] != p->real[GAIN] ? 3 : 0;
}

static int probe_step(probe *p, double time, double size)
{
    if (p->flag[TALK]) {
        p->say(p->environment, 1, "100 %% at a step");
    }
    if (time + size > p->real[FAIL_TIME] && p->whole[FAIL_STATUS] > 1) {
        if (p->whole[FAIL_STATUS] == 99) {
            abort();
        }
        while (p->whole[FAIL_STATUS] == 98) {
            /* an FMU that hangs */
            sleep(1);
        }
        p->say(p->environment, (int)p->whole[FAIL_STATUS], "told to fail");
        return (int)p->whole[FAIL_STATUS];
    }
    p->time = time + size;
    return (int)p->whole[FAIL_STATUS] == 1 ? 1 : 0;
}

#endif
