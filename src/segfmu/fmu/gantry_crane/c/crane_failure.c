/* GantryCrane: why the plant has failed. */
#include "crane.h"
#include "say.h"

bool crane_failed(crane *m, int64_t status, double time, char message[MESSAGE])
{
    static const char *const reasons[] = {
        "a sway angle came to 90 degrees", "the rope's length came to zero",
        "the integration steps became too small", "a value is not finite", "the rope went slack"
    };
    static const char *const axes[] = {"bridge", "trolley", "rope"};
    if (status < 6) {
        return say(message, "at %.3f s: %s; check the setpoints, the masses and the friction", time,
                   reasons[status - 1]);
    }
    int64_t axis = (status - 6) % 3, limit = (status >= 9 ? 25 : 22) + axis;
    return say(message, "at %.3f s: %s at %.6g m is at its end stop, %s position %.6g m; shorten "
               "the move, brake earlier or widen the travel limits", time, axes[axis],
               m->memory[axis], status >= 9 ? "greatest" : "least", m->parameters[limit]);
}
