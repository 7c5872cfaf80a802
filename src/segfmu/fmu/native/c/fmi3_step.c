/* FMI 3.0: co-simulation. */
#include "fmi3.h"

fmi3Status fmi3EnterStepMode(fmi3Instance self)
{
    instance *c = self;
    ALLOW(MODE_EVENT);
    if (c->model->interface != CO_SIMULATION) {
        glue_log(c, STATUS_ERROR, "%s is a function of co-simulation", __func__);
        return fmi3Error;
    }
    c->model->mode = MODE_STEP;
    return fmi3OK;
}

/* Tell the importer of the time reached; it may ask for an earlier end of the step. */
static void update(instance *c, double *end)
{
    fmi3IntermediateUpdateCallback tell = (fmi3IntermediateUpdateCallback)c->update;
    double now = c->model->real[V_TIME];
    fmi3Boolean early = false;
    fmi3Float64 asked = now;
    if (tell == NULL) {
        return;
    }
    c->model->mode = MODE_UPDATE;
    tell(c->environment, now, false, true, true, c->early_return && now < *end, &early, &asked);
    c->model->mode = MODE_STEP;
    if (early && c->early_return && asked < *end) {
        *end = asked > now ? asked : now;
    }
}

fmi3Status fmi3DoStep(fmi3Instance self, fmi3Float64 time, fmi3Float64 step,
                      fmi3Boolean no_set_before, fmi3Boolean *event_needed, fmi3Boolean *terminate,
                      fmi3Boolean *early, fmi3Float64 *reached)
{
    instance *c = self;
    ALLOW(MODE_STEP);
    GIVEN(event_needed);
    GIVEN(terminate);
    GIVEN(early);
    GIVEN(reached);
    (void)no_set_before;
    *event_needed = *terminate = *early = false;
    *reached = c->model->real[V_TIME];
    if (!glue_begin_step(c, time, step)) {
        return fmi3Error;
    }
    double end = c->model->step_end;
    bool last = false;
    while (!last) {
        bool event = false;
        if (!glue_continue_step(c, end, &event)) {
            return fmi3Error;
        }
        *reached = c->model->real[V_TIME];
        update(c, &end);
        last = *reached >= end || (event && c->early_return);
        *event_needed = event && last && c->event_mode;
        if (event && !*event_needed && !glue_event(c)) {
            return fmi3Error;
        }
    }
    *early = *reached < c->model->step_end;
    return fmi3OK;
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance self, fmi3ValueReference clock, fmi3Float64 time)
{
    instance *c = self;
    ALLOW(MODE_ANY);
    (void)clock;
    (void)time;
    glue_log(c, STATUS_ERROR, "%s: scheduled execution is not available", __func__);
    return fmi3Error;
}
