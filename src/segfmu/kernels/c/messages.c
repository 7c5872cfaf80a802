/* Generated from the texts in kernels/messages.py by `python -m segfmu.codegen`; never edited. */
#include "messages.h"

#include <stdio.h>

#include "records.h"

bool segfmu_plan_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const axis[] = {"x", "y", "z"};
    static const char *const side[] = {"", "_min"};
    switch (status) {
    case -1:
        snprintf(text, size,
            "axis %s, waypoints %d -> %d: braking the first acceleration %.6g m/s2 "
            "exceeds the velocity limit %.6g m/s; lower the velocity or the acceleration "
            "of waypoint %d or raise limits.velocity%s",
            axis[(int)report[REFUSAL_AXIS]],
            (int)report[REFUSAL_INTERVAL] + 1,
            (int)report[REFUSAL_INTERVAL] + 2,
            report[REFUSAL_VALUE],
            report[REFUSAL_BOUND],
            (int)report[REFUSAL_INTERVAL] + 1,
            side[(int)report[REFUSAL_SIDE]]);
        return true;
    case -2:
        snprintf(text, size,
            "axis %s, waypoints %d -> %d: building up the last acceleration %.6g m/s2 "
            "exceeds the velocity limit %.6g m/s; lower the velocity or the acceleration "
            "of waypoint %d or raise limits.velocity%s",
            axis[(int)report[REFUSAL_AXIS]],
            (int)report[REFUSAL_INTERVAL] + 1,
            (int)report[REFUSAL_INTERVAL] + 2,
            report[REFUSAL_VALUE],
            report[REFUSAL_BOUND],
            (int)report[REFUSAL_INTERVAL] + 2,
            side[(int)report[REFUSAL_SIDE]]);
        return true;
    case -3:
        snprintf(text, size,
            "axis %s, waypoints %d -> %d: no profile within the limits was found; raise "
            "the limits or change the velocities of the two waypoints",
            axis[(int)report[REFUSAL_AXIS]],
            (int)report[REFUSAL_INTERVAL] + 1,
            (int)report[REFUSAL_INTERVAL] + 2);
        return true;
    case -4:
        snprintf(text, size,
            "waypoints %d -> %d: no common duration of the axes was found; change the "
            "velocities of waypoint %d or set the synchronization to none",
            (int)report[REFUSAL_INTERVAL] + 1,
            (int)report[REFUSAL_INTERVAL] + 2,
            (int)report[REFUSAL_INTERVAL] + 2);
        return true;
    case -5:
        snprintf(text, size,
            "duration %.9g s is shorter than the shortest plan, %.9g s; raise duration "
            "or the limits",
            report[REFUSAL_BOUND],
            report[REFUSAL_VALUE]);
        return true;
    case -6:
        snprintf(text, size,
            "axis %s: the motion between moving waypoints cannot be prolonged to exactly "
            "%.9g s; change the duration, let waypoints rest, or set the synchronization "
            "to waypoints",
            axis[(int)report[REFUSAL_AXIS]],
            report[REFUSAL_VALUE]);
        return true;
    case -16:
        snprintf(text, size,
            "sample_time must be from 1e-9 to 1e6 s, or 0 for none, got %g s",
            report[REFUSAL_VALUE]);
        return true;
    case -7:
        snprintf(text, size,
            "axis %s, waypoint %d: velocity %.6g m/s exceeds the limit %.6g m/s; raise "
            "limits.velocity%s or lower the waypoint's velocity",
            axis[(int)report[REFUSAL_AXIS]],
            (int)report[REFUSAL_INTERVAL] + 1,
            report[REFUSAL_VALUE],
            report[REFUSAL_BOUND],
            side[(int)report[REFUSAL_SIDE]]);
        return true;
    case -8:
        snprintf(text, size,
            "axis %s, waypoint %d: acceleration %.6g m/s2 exceeds the limit %.6g m/s2; "
            "raise limits.acceleration%s or lower the waypoint's acceleration",
            axis[(int)report[REFUSAL_AXIS]],
            (int)report[REFUSAL_INTERVAL] + 1,
            report[REFUSAL_VALUE],
            report[REFUSAL_BOUND],
            side[(int)report[REFUSAL_SIDE]]);
        return true;
    case -9:
        snprintf(text, size,
            "axis %s: no limit bounds the duration of an acceleration ramp; give "
            "limits.jerk or a higher one",
            axis[(int)report[REFUSAL_AXIS]]);
        return true;
    case -10:
        snprintf(text, size,
            "axis %s, waypoint %d: a dwell needs a waypoint at rest; omit its velocity "
            "and acceleration, or the dwell",
            axis[(int)report[REFUSAL_AXIS]],
            (int)report[REFUSAL_INTERVAL] + 1);
        return true;
    case -11:
        snprintf(text, size,
            "the number of waypoints, an option of the planner, or a limit, a position "
            "or a dwell is out of range");
        return true;
    case -12:
        snprintf(text, size,
            "the plan breaks a limit or misses a waypoint by more than 1e-9 (relative): "
            "the problem is badly scaled; choose limits and distances of similar size");
        return true;
    case -14:
        snprintf(text, size,
            "limits.%s.velocity must be greater than 0, got %g",
            axis[(int)report[REFUSAL_AXIS]],
            report[REFUSAL_VALUE]);
        return true;
    case -15:
        snprintf(text, size,
            "limits.%s.acceleration must be greater than 0, got %g",
            axis[(int)report[REFUSAL_AXIS]],
            report[REFUSAL_VALUE]);
        return true;
    default:
        return false;
    }
}

bool segfmu_rope_message(
    int64_t status, const double *report, char *text, size_t size)
{
    switch (status) {
    case 1:
        snprintf(text, size,
            "at %.3f s: load height z passes the trolley's height, %.6g m, and reaches "
            "%.6g m; lower the waypoints",
            report[ROPE_FAULT_TIME],
            report[ROPE_FAULT_BOUND],
            report[ROPE_FAULT_WORST]);
        return true;
    case 2:
        snprintf(text, size,
            "at %.3f s: downward acceleration of the load passes gravity, where the rope "
            "goes slack, %.6g m/s2, and reaches %.6g m/s2; lower limits.z.acceleration",
            report[ROPE_FAULT_TIME],
            report[ROPE_FAULT_BOUND],
            report[ROPE_FAULT_WORST]);
        return true;
    case 3:
        snprintf(text, size,
            "at %.3f s: rope length passes rope_max, %.6g m, and reaches %.6g m; raise "
            "the waypoints or rope_max",
            report[ROPE_FAULT_TIME],
            report[ROPE_FAULT_BOUND],
            report[ROPE_FAULT_WORST]);
        return true;
    case 4:
        snprintf(text, size,
            "at %.3f s: rope length passes rope_min, %.6g m, and reaches %.6g m; lower "
            "the waypoints or rope_min",
            report[ROPE_FAULT_TIME],
            report[ROPE_FAULT_BOUND],
            report[ROPE_FAULT_WORST]);
        return true;
    case 5:
        snprintf(text, size,
            "at %.3f s: downward acceleration of all on the rope passes gravity, where "
            "the rope goes slack, %.6g m/s2, and reaches %.6g m/s2; lower "
            "limits.z.acceleration",
            report[ROPE_FAULT_TIME],
            report[ROPE_FAULT_BOUND],
            report[ROPE_FAULT_WORST]);
        return true;
    case 6:
        snprintf(text, size,
            "at %.3f s: height z of the rope's end passes the trolley's height, %.6g m, "
            "and reaches %.6g m; lower the waypoints",
            report[ROPE_FAULT_TIME],
            report[ROPE_FAULT_BOUND],
            report[ROPE_FAULT_WORST]);
        return true;
    default:
        return false;
    }
}

bool segfmu_limit_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const axis[] = {"x", "y", "z"};
    static const char *const drive[] = {"bridge", "trolley", "hoist"};
    static const char *const side[] = {"", "_min"};
    switch (status) {
    case 1:
        snprintf(text, size,
            "axis %s: nothing bounds the acceleration; give a bound of the %s's "
            "acceleration, force or power, or limits of the load",
            axis[(int)report[LIMIT_FAULT_AXIS]],
            drive[(int)report[LIMIT_FAULT_DRIVE]]);
        return true;
    case 2:
        snprintf(text, size,
            "axis %s: %s velocity%s must have a bound of at least 1e-05 m/s, got %g m/s; "
            "raise the bound",
            axis[(int)report[LIMIT_FAULT_AXIS]],
            drive[(int)report[LIMIT_FAULT_DRIVE]],
            side[(int)report[LIMIT_FAULT_SIDE]],
            report[LIMIT_FAULT_VALUE]);
        return true;
    case 3:
        snprintf(text, size,
            "axis %s: %s acceleration%s must have a bound of at least 1e-05 m/s2, got %g "
            "m/s2; raise the bound",
            axis[(int)report[LIMIT_FAULT_AXIS]],
            drive[(int)report[LIMIT_FAULT_DRIVE]],
            side[(int)report[LIMIT_FAULT_SIDE]],
            report[LIMIT_FAULT_VALUE]);
        return true;
    default:
        return false;
    }
}

bool segfmu_bound_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const drive[] = {"bridge", "trolley", "hoist"};
    static const char *const axis[] = {"x", "y", "z"};
    static const char *const stopped[] = {"bridge", "trolley", "rope"};
    static const char *const side[] = {"max", "min"};
    switch (status) {
    case 1:
        snprintf(text, size,
            "at %.3f s: the plan needs %.9g N, drive.%s.force_%s is %.9g N; lower "
            "limits.%s or the masses, move the waypoints, or raise the bound",
            report[BOUND_FAULT_TIME],
            report[BOUND_FAULT_VALUE],
            drive[(int)report[BOUND_FAULT_DRIVE]],
            side[(int)report[BOUND_FAULT_SIDE]],
            report[BOUND_FAULT_BOUND],
            axis[(int)report[BOUND_FAULT_AXIS]]);
        return true;
    case 2:
        snprintf(text, size,
            "at %.3f s: the plan needs %.9g m/s, drive.%s.velocity_%s is %.9g m/s; lower "
            "limits.%s, move the waypoints, or raise the bound",
            report[BOUND_FAULT_TIME],
            report[BOUND_FAULT_VALUE],
            drive[(int)report[BOUND_FAULT_DRIVE]],
            side[(int)report[BOUND_FAULT_SIDE]],
            report[BOUND_FAULT_BOUND],
            axis[(int)report[BOUND_FAULT_AXIS]]);
        return true;
    case 3:
        snprintf(text, size,
            "at %.3f s: the plan needs %.9g m/s2, drive.%s.acceleration_%s is %.9g m/s2; "
            "lower limits.%s, move the waypoints, or raise the bound",
            report[BOUND_FAULT_TIME],
            report[BOUND_FAULT_VALUE],
            drive[(int)report[BOUND_FAULT_DRIVE]],
            side[(int)report[BOUND_FAULT_SIDE]],
            report[BOUND_FAULT_BOUND],
            axis[(int)report[BOUND_FAULT_AXIS]]);
        return true;
    case 4:
        snprintf(text, size,
            "at %.3f s: the plan needs %.9g W, drive.%s.power_%s is %.9g W; lower "
            "limits.%s or the masses, move the waypoints, or raise the bound",
            report[BOUND_FAULT_TIME],
            report[BOUND_FAULT_VALUE],
            drive[(int)report[BOUND_FAULT_DRIVE]],
            side[(int)report[BOUND_FAULT_SIDE]],
            report[BOUND_FAULT_BOUND],
            axis[(int)report[BOUND_FAULT_AXIS]]);
        return true;
    case 6:
        snprintf(text, size,
            "at %.3f s: the plan needs %.9g rad, sway.%s.angle_max is %.9g rad; lower "
            "limits.%s, move the waypoints, or raise the bound",
            report[BOUND_FAULT_TIME],
            report[BOUND_FAULT_VALUE],
            axis[(int)report[BOUND_FAULT_AXIS]],
            report[BOUND_FAULT_BOUND],
            axis[(int)report[BOUND_FAULT_AXIS]]);
        return true;
    case 5:
        snprintf(text, size,
            "at %.3f s: the plan takes the %s to %.9g m, beyond its end stop "
            "travel.%s.%s at %.9g m; move the waypoints, or lower their velocities and "
            "accelerations along %s",
            report[BOUND_FAULT_TIME],
            stopped[(int)report[BOUND_FAULT_STOPPED]],
            report[BOUND_FAULT_VALUE],
            stopped[(int)report[BOUND_FAULT_STOPPED]],
            side[(int)report[BOUND_FAULT_SIDE]],
            report[BOUND_FAULT_BOUND],
            axis[(int)report[BOUND_FAULT_AXIS]]);
        return true;
    default:
        return false;
    }
}

bool segfmu_path_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const axis[] = {"x", "y", "z"};
    switch (status) {
    case 1:
        snprintf(text, size,
            "between waypoints %d and %d the path leaves the box of both by %.4g m along "
            "%s, from %.3f s",
            (int)report[EXCURSION_INTERVAL] + 1,
            (int)report[EXCURSION_INTERVAL] + 2,
            report[EXCURSION_DISTANCE],
            axis[(int)report[EXCURSION_AXIS]],
            report[EXCURSION_TIME]);
        return true;
    default:
        return false;
    }
}

bool segfmu_space_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const axis[] = {"x", "y", "z"};
    switch (status) {
    case 1:
        snprintf(text, size,
            "obstacle %d: the load meets it from %.3f s to %.3f s, first at (%.4g, %.4g, "
            "%.4g) m; lead the waypoints past it at more distance or above it",
            (int)report[SPACE_FAULT_BOX] + 1,
            report[SPACE_FAULT_BEGIN],
            report[SPACE_FAULT_END],
            report[SPACE_FAULT_X],
            report[SPACE_FAULT_Y],
            report[SPACE_FAULT_Z]);
        return true;
    case 2:
        snprintf(text, size,
            "obstacle %d: the rope meets it from %.3f s to %.3f s, first at (%.4g, %.4g, "
            "%.4g) m; lead the waypoints past it at more distance or above it",
            (int)report[SPACE_FAULT_BOX] + 1,
            report[SPACE_FAULT_BEGIN],
            report[SPACE_FAULT_END],
            report[SPACE_FAULT_X],
            report[SPACE_FAULT_Y],
            report[SPACE_FAULT_Z]);
        return true;
    case 3:
        snprintf(text, size,
            "workspace.%s: the load leaves its end at %.9g m from %.3f s to %.3f s; move "
            "the waypoints or give them lower velocities",
            axis[(int)report[SPACE_FAULT_AXIS]],
            report[SPACE_FAULT_BOUND],
            report[SPACE_FAULT_BEGIN],
            report[SPACE_FAULT_END]);
        return true;
    case 4:
        snprintf(text, size,
            "workspace.%s: minimum must be below its maximum %.15g m, got %.15g m",
            axis[(int)report[SPACE_FAULT_AXIS]],
            report[SPACE_FAULT_BOUND],
            report[SPACE_FAULT_VALUE]);
        return true;
    case 6:
        snprintf(text, size,
            "obstacle[%d]: the rope above a sling, and the sling itself, are not judged; "
            "set obstacle[%d].rope to false, and let the margin keep them off",
            (int)report[SPACE_FAULT_BOX] + 1,
            (int)report[SPACE_FAULT_BOX] + 1);
        return true;
    case 5:
        snprintf(text, size,
            "obstacle[%d]: minimum.%s must be below its maximum %.15g m, got %.15g m",
            (int)report[SPACE_FAULT_BOX] + 1,
            axis[(int)report[SPACE_FAULT_AXIS]],
            report[SPACE_FAULT_BOUND],
            report[SPACE_FAULT_VALUE]);
        return true;
    default:
        return false;
    }
}

bool segfmu_ready_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const drive[] = {"bridge", "trolley", "hoist"};
    switch (status) {
    case 1:
        snprintf(text, size,
            "drive.%s.dead_time is %g s: no command can be followed with a drive that "
            "acts late; set it to 0, or command.enabled to false",
            drive[(int)report[READY_FAULT_DRIVE]],
            report[READY_FAULT_VALUE]);
        return true;
    case 2:
        snprintf(text, size,
            "friction.%s: no command can be followed with Coulomb or static friction; "
            "set both to 0, or command.enabled to false",
            drive[(int)report[READY_FAULT_DRIVE]]);
        return true;
    case 3:
        snprintf(text, size,
            "the plan has %.0f polynomial pieces, too many for commands; use fewer "
            "waypoints, or set command.enabled to false",
            report[READY_FAULT_VALUE]);
        return true;
    default:
        return false;
    }
}

bool segfmu_takeover_message(
    int64_t status, const double *report, char *text, size_t size)
{
    switch (status) {
    case 3:
        snprintf(text, size,
            "command.take_over: measured.* with a rope of %g m is no state of a load "
            "below its crane, or the way from there to rest leaves the range of the "
            "rope; give all ten values, or widen crane.rope_min and crane.rope_max",
            report[READY_FAULT_VALUE]);
        return true;
    case 4:
        snprintf(text, size,
            "command.take_over: the way from the measured state to rest leaves the "
            "workspace, or is beyond 1e6 m, where targets end; widen workspace.*, move "
            "the origin, or let the swing decay");
        return true;
    case 5:
        snprintf(text, size,
            "command.take_over: the way from the measured state to rest meets an "
            "obstacle; move that, or let the swing decay");
        return true;
    case 8:
        snprintf(text, size,
            "command.take_over: the way from the measured state to rest passes an end "
            "stop; widen travel.*, or let the swing decay");
        return true;
    case 6:
        snprintf(text, size,
            "command.take_over: the drives cannot bring the load to rest from the "
            "measured state; give drive.*.acceleration_max, more of it, or let the swing "
            "decay");
        return true;
    default:
        return false;
    }
}

bool segfmu_plant_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const axis[] = {"bridge", "trolley", "rope"};
    static const char *const sway[] = {"sway.x.angle", "sway.y.angle", "sling.x.angle", "sling.y.angle"};
    switch (status) {
    case 1:
        snprintf(text, size,
            "at %.3f s: %s reached %.4g rad, with %.4g m of rope; the crane is known up "
            "to 90 degrees; check setpoints, feedback, wind, masses, friction, and where "
            "the load begins",
            report[PLANT_FAULT_TIME],
            sway[(int)report[PLANT_FAULT_SWAY]],
            report[PLANT_FAULT_ANGLE],
            report[PLANT_FAULT_POSITION]);
        return true;
    case 2:
        snprintf(text, size,
            "at %.3f s: the rope length reached zero; check setpoints, wind, masses and "
            "friction",
            report[PLANT_FAULT_TIME]);
        return true;
    case 3:
        snprintf(text, size,
            "at %.3f s: the integration steps became too small; check setpoints, wind, "
            "masses and friction",
            report[PLANT_FAULT_TIME]);
        return true;
    case 4:
        snprintf(text, size,
            "at %.3f s: a value is not finite; check setpoints, wind, masses and friction",
            report[PLANT_FAULT_TIME]);
        return true;
    case 5:
        snprintf(text, size,
            "at %.3f s: the rope went slack; check setpoints, wind, masses and friction",
            report[PLANT_FAULT_TIME]);
        return true;
    case 12:
        snprintf(text, size,
            "at %.3f s: the sling went slack; check setpoints, wind, masses and friction",
            report[PLANT_FAULT_TIME]);
        return true;
    case 6:
        snprintf(text, size,
            "at %.3f s: %s at %.6g m is at its end stop, least position %.6g m; shorten "
            "the move, brake earlier or widen the travel limits",
            report[PLANT_FAULT_TIME],
            axis[(int)report[PLANT_FAULT_AXIS]],
            report[PLANT_FAULT_POSITION],
            report[PLANT_FAULT_STOP]);
        return true;
    case 9:
        snprintf(text, size,
            "at %.3f s: %s at %.6g m is at its end stop, greatest position %.6g m; "
            "shorten the move, brake earlier or widen the travel limits",
            report[PLANT_FAULT_TIME],
            axis[(int)report[PLANT_FAULT_AXIS]],
            report[PLANT_FAULT_POSITION],
            report[PLANT_FAULT_STOP]);
        return true;
    default:
        return false;
    }
}

bool segfmu_setup_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const axis[] = {"bridge", "trolley", "rope"};
    static const char *const drive[] = {"bridge", "trolley", "hoist"};
    switch (status) {
    case 1:
        snprintf(text, size,
            "travel.%s: min %.15g m must be below max %.15g m",
            axis[(int)report[SETUP_FAULT_AXIS]],
            report[SETUP_FAULT_VALUE],
            report[SETUP_FAULT_BOUND]);
        return true;
    case 2:
        snprintf(text, size,
            "in model exchange with drive.mode velocity, drive.%s.lag must be above 0 s "
            "(without lag the setpoints do not determine the acceleration); set a lag, "
            "or use co-simulation",
            drive[(int)report[SETUP_FAULT_DRIVE]]);
        return true;
    case 16:
        snprintf(text, size,
            "drive.%s.lag must be 0 or at least %.15g s, got %.15g s; 0 is an ideal drive",
            drive[(int)report[SETUP_FAULT_DRIVE]],
            report[SETUP_FAULT_BOUND],
            report[SETUP_FAULT_VALUE]);
        return true;
    case 3:
        snprintf(text, size,
            "sensor noise and dead_time need sampled signals: set sensor.sample_time "
            "above 0 s");
        return true;
    case 4:
        snprintf(text, size,
            "sensor.sample_time must be 0 or at least %.15g s, got %.15g s",
            report[SETUP_FAULT_BOUND],
            report[SETUP_FAULT_VALUE]);
        return true;
    case 5:
        snprintf(text, size,
            "sensor.dead_time %.15g s is longer than 100000 samples of %.15g s; lower it "
            "or raise sensor.sample_time",
            report[SETUP_FAULT_VALUE],
            report[SETUP_FAULT_BOUND]);
        return true;
    case 12:
        snprintf(text, size,
            "friction.%s.static %.15g N must be 0 or at least friction.%s.coulomb %.15g N",
            drive[(int)report[SETUP_FAULT_DRIVE]],
            report[SETUP_FAULT_VALUE],
            drive[(int)report[SETUP_FAULT_DRIVE]],
            report[SETUP_FAULT_BOUND]);
        return true;
    case 17:
        snprintf(text, size,
            "friction.%s: the plan turns the %s more often than there is memory for; "
            "drop waypoints, or set the friction to 0",
            drive[(int)report[SETUP_FAULT_DRIVE]],
            drive[(int)report[SETUP_FAULT_DRIVE]]);
        return true;
    case 13:
        snprintf(text, size,
            "wind.turbulence.deviation %g m/s needs a mean speed for its spectrum: set "
            "wind.speed",
            report[SETUP_FAULT_VALUE]);
        return true;
    case 19:
        snprintf(text, size,
            "two changes of the load are at %.15g s, and one alone can count; leave one "
            "out, or move it",
            report[SETUP_FAULT_VALUE]);
        return true;
    case 14:
        snprintf(text, size,
            "in model exchange rope.slack must be error, got free_fall (the slack rope "
            "has no state there); use co-simulation");
        return true;
    case 18:
        snprintf(text, size,
            "with a sling rope.slack must be error, got free_fall (what is below the "
            "rope has no slack rope); drop slack");
        return true;
    case 10:
        snprintf(text, size,
            "drive.%s.dead_time %.15g s is longer than 100000 periods of %.15g s; lower "
            "it or raise feedback.sample_time",
            drive[(int)report[SETUP_FAULT_DRIVE]],
            report[SETUP_FAULT_VALUE],
            report[SETUP_FAULT_BOUND]);
        return true;
    case 11:
        snprintf(text, size,
            "in model exchange drive.%s.dead_time must be 0 s, got %.15g s (the "
            "setpoints of the past are the importer's); delay the setpoints in the "
            "importer, or use co-simulation",
            drive[(int)report[SETUP_FAULT_DRIVE]],
            report[SETUP_FAULT_VALUE]);
        return true;
    case 6:
        snprintf(text, size,
            "the start value of rope.length must be above 0 m, got %g m",
            report[SETUP_FAULT_VALUE]);
        return true;
    case 7:
        snprintf(text, size,
            "rope_min %.15g m must be less than rope_max %.15g m",
            report[SETUP_FAULT_VALUE],
            report[SETUP_FAULT_BOUND]);
        return true;
    case 8:
        snprintf(text, size,
            "rope lengths must be positive and ascending, got %.15g to %.15g m; set the "
            "crane's rope_min and rope_max",
            report[SETUP_FAULT_VALUE],
            report[SETUP_FAULT_BOUND]);
        return true;
    case 9:
        snprintf(text, size,
            "the observer has no finite gains between %g and %g m of rope; check masses, "
            "lags and what it expects",
            report[SETUP_FAULT_VALUE],
            report[SETUP_FAULT_BOUND]);
        return true;
    case 15:
        snprintf(text, size,
            "the feedback of the %s is unstable at %g m of rope: a deviation grows %g "
            "times in a sample; lower feedback.sample_time, or set feedback.design to "
            "flatness (for drive.%s.lag) and feedback.source to measured (for "
            "drive.%s.dead_time)",
            drive[(int)report[SETUP_FAULT_DRIVE]],
            report[SETUP_FAULT_VALUE],
            report[SETUP_FAULT_BOUND],
            drive[(int)report[SETUP_FAULT_DRIVE]],
            drive[(int)report[SETUP_FAULT_DRIVE]]);
        return true;
    default:
        return false;
    }
}

bool segfmu_range_message(
    int64_t status, const double *report, char *text, size_t size)
{
    switch (status) {
    case 1:
        snprintf(text, size,
            "must be at least %g, got %.15g",
            report[RANGE_FAULT_LEAST],
            report[RANGE_FAULT_VALUE]);
        return true;
    case 3:
        snprintf(text, size,
            "must be at most %g, got %.15g",
            report[RANGE_FAULT_MOST],
            report[RANGE_FAULT_VALUE]);
        return true;
    case 2:
        snprintf(text, size,
            "must be at least %g and at most %g, got %.15g",
            report[RANGE_FAULT_LEAST],
            report[RANGE_FAULT_MOST],
            report[RANGE_FAULT_VALUE]);
        return true;
    default:
        return false;
    }
}

bool segfmu_access_message(
    int64_t status, const double *report, char *text, size_t size)
{
    switch (status) {
    case 1:
        snprintf(text, size,
            "there is no variable with value reference %.0f",
            report[ACCESS_FAULT_REFERENCE]);
        return true;
    default:
        return false;
    }
}

bool segfmu_start_message(
    int64_t status, const double *report, char *text, size_t size)
{
    static const char *const place[] = {"bridge.position", "trolley.position", "rope.length", "sway.x.angle", "sway.y.angle", "bridge.velocity", "trolley.velocity", "rope.velocity", "sway.x.rate", "sway.y.rate"};
    switch (status) {
    case 1:
        snprintf(text, size,
            "the start value of rope.length must be above 0 m, got %g; its reference "
            "starts at %g m, see start.on_reference",
            report[START_FAULT_VALUE],
            report[START_FAULT_BOUND]);
        return true;
    case 2:
        snprintf(text, size,
            "%s must start within 90 degrees, got %.15g rad",
            place[(int)report[START_FAULT_PLACE]],
            report[START_FAULT_VALUE]);
        return true;
    case 3:
        snprintf(text, size,
            "%s started at %g, its reference at %g; set start.on_reference to true and "
            "connect the reference at initialisation, or start values that fit the first "
            "waypoint",
            place[(int)report[START_FAULT_PLACE]],
            report[START_FAULT_VALUE],
            report[START_FAULT_BOUND]);
        return true;
    case 4:
        snprintf(text, size,
            "at %.3f s: the crane left the range of its equations; %s started at %g, its "
            "reference at %g; set start.on_reference to true and connect the reference "
            "at initialisation, or start values that fit the first waypoint",
            report[START_FAULT_TIME],
            place[(int)report[START_FAULT_PLACE]],
            report[START_FAULT_VALUE],
            report[START_FAULT_BOUND]);
        return true;
    case 5:
        snprintf(text, size,
            "%s starts at %g m, outside crane.rope_min and crane.rope_max, here %g m",
            place[(int)report[START_FAULT_PLACE]],
            report[START_FAULT_VALUE],
            report[START_FAULT_BOUND]);
        return true;
    default:
        return false;
    }
}
