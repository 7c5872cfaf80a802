/* GantryCrane: inputs over a communication step. */
#include <string.h>

#include "crane.h"

/* What is read as one array lies side by side. */
#define SIDE_BY_SIDE(first, last, count) \
    typedef char first##_is_first[(last) - (first) == (count) - 1 ? 1 : -1]
SIDE_BY_SIDE(V_FORCE_BRIDGE, V_REFERENCE_SWAY_Y_RATE, SETPOINTS_WIND);
SIDE_BY_SIDE(V_WIND_X, V_WIND_Z, 3);

void crane_read_inputs(crane *m)
{
    const double *real = m->base.real;
    memcpy(m->setpoints, &real[V_FORCE_BRIDGE], SETPOINTS_WIND * sizeof *real);
    memcpy(m->setpoints + SETPOINTS_WIND, &real[V_WIND_X], VECTOR_SIZE * sizeof *real);
}

/* An input over the time between two times: its values, its slope at the end, and what it has of the
   square and the cube of the share of the time. */
typedef struct {
    double start, end, slope, square, cube;
} segment;

/* An input by its derivatives, from the present time to a later one. */
static segment follow_derivatives(const model *base, int i, double time)
{
    segment s;
    double past = base->real[V_TIME] - base->step_start, length = time - base->real[V_TIME];
    double cube = base->slope[2][i] / 6.0;
    double square = 0.5 * base->slope[1][i] + 3.0 * cube * past;
    double slope = base->slope[0][i] + (base->slope[1][i] + 3.0 * cube * past) * past;
    s.start = base->real[i]
        + (base->slope[0][i] + (0.5 * base->slope[1][i] + cube * past) * past) * past;
    s.end = s.start + (slope + (square + cube * length) * length) * length;
    s.slope = slope + (2.0 * square + 3.0 * cube * length) * length;
    s.square = square * length * length;
    s.cube = cube * length * length * length;
    return s;
}

void crane_follow_inputs(crane *m, double time)
{
    const model *base = &m->base;
    double now = base->real[V_TIME], share = (time - now) / (base->step_end - now);
    crane_read_inputs(m);
    for (int i = 0; i < V_WIND_X; i++) {
        double start = m->input[i];
        double end = time < base->step_end ? start + (base->real[i] - start) * share
                                           : base->real[i];
        segment s = {start, end, (end - start) / (time - now), 0.0, 0.0};
        if (base->sloped) {
            s = follow_derivatives(base, i, time);
        }
        m->input[i] = s.end;
        m->slope[i] = s.slope;
        if (i < V_REFERENCE_LOAD_POSITION_X) {
            row(m, MEMORY_LAST)[i] = s.start;
            m->setpoints[i] = s.end;
            row(m, MEMORY_SQUARE)[i] = s.square;
            row(m, MEMORY_CUBE)[i] = s.cube;
        }
    }
}
