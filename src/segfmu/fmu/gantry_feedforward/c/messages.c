/* Why a plan is refused, in the words of the Python package. */
#include "messages.h"

#include <math.h>

#include "kernels.h"
#include "records.h"

/* Refusals of a whole interval of an axis. */
static bool say_interval(char message[MESSAGE], int status, const segfmu_problem *p, int axis,
                         int interval)
{
    if (status != -1 && status != -2) {
        return say(message, "axis %c, waypoints %d -> %d: no profile within the limits was found; "
                   "raise the limits or change the velocities of the two waypoints", "xyz"[axis],
                   interval + 1, interval + 2);
    }
    int point = status == -1 ? interval : interval + 1;
    return say(message, "axis %c, waypoints %d -> %d: %s acceleration %.6g m/s2 passes the velocity "
               "limit %.6g m/s; lower the velocity or the acceleration of waypoint %d or raise "
               "limits.velocity", "xyz"[axis], interval + 1, interval + 2,
               status == -1 ? "braking the first" : "building up the last",
               p->accelerations[point * p->axes + axis], p->limits[axis * (p->smoothness + 1)],
               point + 1);
}

bool say_infeasible(char message[MESSAGE], int status, const segfmu_problem *p,
                    const double report[4])
{
    int axis = (int)report[0], interval = (int)report[1];
    double value = report[2], bound = report[3];
    char name = "xyz"[axis >= 0 && axis < 3 ? axis : 0];
    switch (status) {
    case -4:
        return say(message, "waypoints %d -> %d: no common duration of the axes found; change the "
                   "velocities of waypoint %d or set planner.synchronization to none",
                   interval + 1, interval + 2, interval + 2);
    case -5:
        return say(message, "duration %.9g s is shorter than the shortest plan, %.9g s; raise "
                   "duration or the limits", bound, value);
    case -6:
        return say(message, "axis %c: between its moving waypoints it cannot be prolonged to "
                   "exactly %.9g s; change the duration, let waypoints rest, or set "
                   "planner.synchronization to waypoints", name, value);
    case -7:
    case -8: {
        const char *what = status == -7 ? "velocity" : "acceleration";
        const char *unit = status == -7 ? "m/s" : "m/s2";
        return say(message, "axis %c, waypoint %d: %s %.6g %s exceeds the limit %.6g %s; raise "
                   "limits.%s or lower the waypoint's %s", name, interval + 1, what, value, unit,
                   bound, unit, what, what);
    }
    case -9:
        return say(message, "axis %c: no limit bounds the duration of an acceleration ramp; give "
                   "limits.jerk or a higher one", name);
    case -10:
        return say(message, "axis %c, waypoint %d: a dwell needs a waypoint at rest; leave out its "
                   "velocity and acceleration, or the dwell", name, interval + 1);
    case -11:
        return say(message, "the number of waypoints or a choice of the planner is out of range");
    case -12:
        return say(message, "the profile found misses a limit or a waypoint by over 1e-9 "
                   "(relative); the problem is too badly scaled, bring limits and distances closer "
                   "together");
    default:
        return say_interval(message, status, p, axis, interval);
    }
}

bool waypoints_differ(const segfmu_problem *p, char message[MESSAGE])
{
    const double *states[] = {p->positions, p->velocities, p->accelerations};
    for (int64_t i = 1; i < p->points; i++) {
        bool same = true;
        for (int64_t j = 0; same && j < 3 * p->axes; j++) {
            const double *now = states[j / p->axes] + i * p->axes + j % p->axes;
            double before = now[-p->axes];
            same = fabs(*now - before) <= 1e-15 * fmax(fabs(*now), 1.0);
        }
        if (same) {
            return say(message, "waypoints %d and %d are the same; leave one out, or give it a "
                       "dwell", (int)i, (int)i + 1);
        }
    }
    return true;
}

bool require_rope(const segfmu_trajectory *t, const double crane[6], char message[MESSAGE])
{
    static const struct { const char *name, *unit, *limit, *remedy; } demands[] = {
        {"load height z", "m", "the trolley's height", "lower the waypoints"},
        {"downward acceleration of the load", "m/s2", "gravity, where the rope goes slack",
         "lower limits.z.acceleration"},
        {"rope length", "m", "rope_max", "raise the waypoints or rope_max"},
        {"rope length", "m", "rope_min", "lower the waypoints or rope_min"}
    };
    enum { WIDTH = 12 };
    const int64_t width = 2 * t->smoothness;
    double space[ROPE_WORK_SIZE * (4 * WIDTH - 5)], found[3];
    array_double_2d timing = {(double *)t->timing, {t->pieces, 2}};
    array_double_2d coefficients = {(double *)t->coefficients, {t->pieces, width}};
    array_int64_t_1d offsets = {(int64_t *)t->offsets, {t->axes + 1}};
    array_double_2d work = {space, {ROPE_WORK_SIZE, 4 * width - 5}};
    array_double_1d bounds = {(double *)&crane[MASSES_GRAVITY], {ROPE_BOUNDS_SIZE}};
    array_double_1d report = {found, {3}};
    int64_t status = segfmu_check_rope(timing, coefficients, offsets, bounds, work, report);
    if (status == 0) {
        return true;
    }
    return say(message, "at %.3f s: %s passes %s, %.6g %s, and comes to %.6g %s; %s", found[0],
               demands[status - 1].name, demands[status - 1].limit, found[2],
               demands[status - 1].unit, found[1], demands[status - 1].unit,
               demands[status - 1].remedy);
}
