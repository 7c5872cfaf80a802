/* A crane: inputs over a communication step. */
#include "crane.h"
#include "feeds.h"

void crane_read_inputs(crane *m)
{
    feed_record(&feeds_setpoints, &m->base, m->setpoints);
}

/* An input between two times: its values, its slope at the end, and its coefficients of the
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

/* Follow an input, by its place in `real`, to a time within the step, which is at a share of the rest
   of the step. */
static segment follow_input(crane *m, int i, double time, double share)
{
    const model *base = &m->base;
    double start = m->input[i];
    double end = time < base->step_end ? start + (base->real[i] - start) * share : base->real[i];
    segment s = {start, end, (end - start) / (time - base->real[V_TIME]), 0.0, 0.0};
    if (base->sloped) {
        s = follow_derivatives(base, i, time);
    }
    m->input[i] = s.end;
    m->slope[i] = s.slope;
    return s;
}

void crane_follow_inputs(crane *m, double time)
{
    const double now = m->base.real[V_TIME], share = (time - now) / (m->base.step_end - now);
    for (int64_t k = 0; k < feeds_setpoints.count; k++) {
        int place = feeds_setpoints.rows[k].place;
        segment s = follow_input(m, feeds_setpoints.rows[k].offset, time, share);
        row(m, MEMORY_LAST)[place] = s.start;
        m->setpoints[place] = s.end;
        row(m, MEMORY_SQUARE)[place] = s.square;
        row(m, MEMORY_CUBE)[place] = s.cube;
    }
    for (int64_t k = 0; k < feeds_target.count; k++) {
        follow_input(m, feeds_target.rows[k].offset, time, share);
    }
}
