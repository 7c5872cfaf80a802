/* GantryCrane: inputs over a communication step. */
#include <string.h>

#include "crane.h"

/* What is read as one array lies side by side. */
#define SIDE_BY_SIDE(first, last, count) \
    typedef char first##_is_first[(last) - (first) == (count) - 1 ? 1 : -1]
SIDE_BY_SIDE(V_FORCE_BRIDGE, V_REFERENCE_SWAY_Y_RATE, 16);
SIDE_BY_SIDE(V_WIND_X, V_WIND_Z, 3);

void crane_read_inputs(crane *m)
{
    const double *real = m->base.real;
    memcpy(m->setpoints, &real[V_FORCE_BRIDGE], 16 * sizeof *real);
    memcpy(m->setpoints + 16, &real[V_WIND_X], 3 * sizeof *real);
}

/* An input by its derivatives: at the present time, at a later one, its slope there, and what it
   has of the square and the cube of the share of the time between. */
static void follow_derivatives(const model *base, int i, double time, double course[5])
{
    double past = base->real[V_TIME] - base->step_start, length = time - base->real[V_TIME];
    double cube = base->slope[2][i] / 6.0;
    double square = 0.5 * base->slope[1][i] + 3.0 * cube * past;
    double slope = base->slope[0][i] + (base->slope[1][i] + 3.0 * cube * past) * past;
    course[0] = base->real[i]
        + (base->slope[0][i] + (0.5 * base->slope[1][i] + cube * past) * past) * past;
    course[1] = course[0] + (slope + (square + cube * length) * length) * length;
    course[2] = slope + (2.0 * square + 3.0 * cube * length) * length;
    course[3] = square * length * length;
    course[4] = cube * length * length * length;
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
        double course[5] = {start, end, (end - start) / (time - now), 0.0, 0.0};
        if (base->sloped) {
            follow_derivatives(base, i, time, course);
        }
        m->input[i] = course[1];
        m->slope[i] = course[2];
        if (i < V_REFERENCE_LOAD_POSITION_X) {
            row(m, ROW_LAST)[i] = course[0];
            m->setpoints[i] = course[1];
            row(m, ROW_SQUARES)[FIRST_BEND + i] = course[3];
            row(m, ROW_CUBES)[FIRST_BEND + i] = course[4];
        }
    }
}
