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
    if (status < PLANT_STATUS_BELOW_TRAVEL) {
        return say(message, "at %.3f s: %s; check the setpoints, the masses and the friction", time,
                   reasons[status - PLANT_STATUS_SWAY_ANGLE]);
    }
    bool above = status >= PLANT_STATUS_ABOVE_TRAVEL;
    int64_t axis = status - (above ? PLANT_STATUS_ABOVE_TRAVEL : PLANT_STATUS_BELOW_TRAVEL);
    int64_t limit = (above ? PLANT_TRAVEL_MAX : PLANT_TRAVEL_MIN) + axis;
    return say(message, "at %.3f s: %s at %.6g m is at its end stop, %s position %.6g m; shorten "
               "the move, brake earlier or widen the travel limits", time, axes[axis],
               row(m, MEMORY_STATE)[STATE_POSITION + axis], above ? "greatest" : "least",
               setting(m, SETTINGS_PLANT)[limit]);
}
