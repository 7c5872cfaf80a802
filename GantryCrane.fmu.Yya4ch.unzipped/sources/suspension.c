/* GantryCrane: the load hangs on the rope. */
#include "crane.h"

static const double model_nominals[MODEL_STATES + 1] = {
    1.0, 1.0, 1.0, 0.1, 0.1, 1.0, 1.0, 1.0, 0.1, 0.1, 1e-5, 1e-5, 1e-5, 10.0, 10.0, 10.0, 0.0
};

void crane_read_suspension(const model *base, double plant[PLANT_SIZE])
{
    (void)base;
    (void)plant;
}

bool crane_hang(crane *m, double state[PLANT_STATE_SIZE], char message[MESSAGE])
{
    (void)m;
    (void)state;
    (void)message;
    return true;
}

void crane_show_suspension(crane *m)
{
    (void)m;
}

bool crane_corrects(const crane *m)
{
    (void)m;
    return false;
}

bool crane_set_feedback(crane *m, char message[MESSAGE])
{
    return crane_set_tracking(m, message);
}

void crane_correct(crane *m)
{
    (void)m;
}

bool suspension_sound(const crane *m, bool corrects)
{
    (void)m;
    return !corrects;
}
