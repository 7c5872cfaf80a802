/* GantryCrane: partial derivatives of outputs that crane_partials.c does not list, by central
   differences of the kernel that fills the outputs. Forces and powers, which that kernel reads, have
   exact derivatives: the chain rule does the rest. */
#include <math.h>

#include "crane.h"
#include "feeds.h"

/* of a number, relative to it or to 1: differences are then right to about 1e-10 */
static const double SHARE = 6e-6;

/* what the outputs read of the report, and the rows of its exact partial derivatives */
static const struct { int place, row; } REPORTED[] = {
    {REPORT_FORCE, RIG_PARTIALS_FORCE}, {REPORT_FORCE + 1, RIG_PARTIALS_FORCE + 1},
    {REPORT_FORCE + 2, RIG_PARTIALS_FORCE + 2}, {REPORT_ROPE_FORCE, RIG_PARTIALS_ROPE_FORCE},
    {REPORT_WIND_POWER, RIG_PARTIALS_WIND_POWER},
    {REPORT_FRICTION_POWER, RIG_PARTIALS_FRICTION_POWER}
};

static double output_of(crane *m, double target[TARGET_SIZE], int output)
{
    double balance[BALANCE_SIZE], outputs[OUTPUTS_SIZE];
    segfmu_rig_outputs(vector(target, TARGET_SIZE), memory_of(m), vector(balance, BALANCE_SIZE),
                       vector(outputs, OUTPUTS_SIZE));
    return outputs[output];
}

/* The slope of an output by a number that the kernel reads; the number stays as it was. */
static double slope_by(crane *m, double target[TARGET_SIZE], int output, double *number)
{
    const double kept = *number, step = SHARE * fmax(1.0, fabs(kept));
    *number = kept + step;
    double above = output_of(m, target, output);
    *number = kept - step;
    double below = output_of(m, target, output);
    *number = kept;
    return (above - below) / (2.0 * step);
}

double crane_difference(crane *m, int output, int column, int energy, int reference)
{
    double target[TARGET_SIZE], *state = row(m, MEMORY_STATE), slope = 0.0;
    crane_read_target(m, target);
    if (reference >= 0) {
        slope = slope_by(m, target, output, &target[reference]);
    } else if (energy >= 0) {
        slope = slope_by(m, target, output, &state[PLANT_STATE_DRIVE_WORK + energy]);
    } else if (column >= 0) {
        slope = column < STATE_SIZE ? slope_by(m, target, output, &state[column]) : 0.0;
        for (size_t i = 0; i < sizeof REPORTED / sizeof *REPORTED; i++) {
            double partial = m->partials[REPORTED[i].row * RIG_VARIABLES_SIZE + column];
            if (partial != 0.0) {
                slope += partial
                    * slope_by(m, target, output, row(m, MEMORY_REPORT) + REPORTED[i].place);
            }
        }
    }
    /* the kernel's work space is that of the present state again */
    output_of(m, target, output);
    return slope;
}
