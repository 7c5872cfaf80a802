/* HookFeedforward takes no commands: it follows the plan of its parameters. */
#include <math.h>

#include "feedforward.h"

bool takes_commands(const model *base)
{
    (void)base;
    return false;
}

size_t operation_size(int64_t smoothness)
{
    (void)smoothness;
    return 0;
}

bool begin_commands(feedforward *m, char message[MESSAGE])
{
    (void)m;
    (void)message;
    return true;
}

void follow_command(feedforward *m, double step, char message[MESSAGE])
{
    (void)m;
    (void)step;
    (void)message;
}

double operation_begin(const feedforward *m)
{
    return feedforward_start(m);
}

double operation_renewal(const feedforward *m)
{
    (void)m;
    return INFINITY;
}

segfmu_trajectory operation_trajectory(const feedforward *m)
{
    return mission_trajectory(m);
}

bool operation_sound(const feedforward *m)
{
    return !m->operates;
}
