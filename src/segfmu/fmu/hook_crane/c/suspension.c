/* HookCrane: the load hangs by a sling on a hook, which hangs on the rope. Derivatives of outputs are
   left to the importer. */
#include <math.h>
#include <string.h>

#include "crane.h"
#include "feeds.h"
#include "say.h"

static const double model_nominals[MODEL_STATES + 1] = {
    1.0, 1.0, 1.0, 0.1, 0.1, 1.0, 1.0, 1.0, 0.1, 0.1, 1e-5, 1e-5, 1e-5, 10.0, 10.0, 10.0,
    0.1, 0.1, 0.1, 0.1, 0.0
};

void crane_read_suspension(const model *base, double plant[PLANT_SIZE])
{
    double masses[HOOK_MASSES_SIZE];
    feed_record(&feeds_hook_masses, base, masses);
    plant[PLANT_SUSPENSION] = HOOK_MODEL_CODE;
    plant[PLANT_TACKLE_MASS] = masses[HOOK_MASSES_HOOK_MASS];
    plant[PLANT_SLING] = masses[HOOK_MASSES_SLING];
}

/* Start values of the sling count from its reference, as those of the crane. */
bool crane_hang(crane *m, double state[PLANT_STATE_SIZE], char message[MESSAGE])
{
    double set[SLING_SIZE], held[SLING_REFERENCE_SIZE], reference[SLING_REFERENCE_SIZE];
    double *sling = state + PLANT_STATE_SLING_ANGLE;
    const bool follows = m->base.integer[V_START_ON_REFERENCE] != 0
        && m->base.real[V_REFERENCE_ROPE_LENGTH] > 0.0;
    feed_record(&feeds_sling, &m->base, set);
    feed_record(&feeds_sling_reference, &m->base, reference);
    for (int64_t i = 0; i < feeds_sling_reference.count; i++) {
        held[feeds_sling_reference.rows[i].place] =
            m->base.held[feeds_sling_reference.rows[i].offset];
    }
    for (int i = 0; i < SLING_SIZE; i++) {
        if (!m->placed || set[i] != m->below.hung[i]) {
            m->below.own[i] = set[i];
        }
        sling[i] = m->below.own[i] + (follows ? reference[i] - held[i] : 0.0);
    }
    for (int i = 0; i < 2; i++) {
        if (!(fabs(sling[SLING_ANGLE + i]) < 1.57)) {
            return say(message, "sling.%c.angle must start within 90 degrees, got %g rad",
                       i == 0 ? 'x' : 'y', sling[SLING_ANGLE + i]);
        }
    }
    show_record(&feeds_sling, sling, &m->base);
    memcpy(m->below.hung, sling, sizeof m->below.hung);
    return true;
}

void crane_show_suspension(crane *m)
{
    double outputs[HOOK_OUTPUTS_SIZE];
    segfmu_hook_outputs(memory_of(m), vector(outputs, HOOK_OUTPUTS_SIZE));
    show_record(&feeds_hook_outputs, outputs, &m->base);
    show_record(&feeds_sling_accelerations, m->derivative + PLANT_STATE_SLING_RATE, &m->base);
}

bool model_output_derivative(model *m, const variable *output, int64_t order, double *value)
{
    (void)m;
    (void)output;
    (void)order;
    (void)value;
    return false;
}

bool model_partial(model *m, const variable *unknown, const variable *known, double *value)
{
    (void)m;
    (void)unknown;
    (void)known;
    (void)value;
    return false;
}
