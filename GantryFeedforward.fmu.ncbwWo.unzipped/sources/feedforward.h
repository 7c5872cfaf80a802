/* The block of planner and flat inverse: the plan, at the end of it. Inverse and commands are the
   model's own. */
#ifndef SEGFMU_FEEDFORWARD_H
#define SEGFMU_FEEDFORWARD_H

#include "arrays.h"
#include "feeds.h"
#include "flat_inverse.h"
#include "messages.h"
#include "model.h"
#include "records.h"
#include "segfmu.h"

/* orders of the load's motion that are inverted, and derivatives that have a limit */
enum {
    AXES = VECTOR_SIZE, ORDERS = INVERSE_ORDERS, LIMITS = LOAD_LIMITS_Y - LOAD_LIMITS_X, MOST_SMOOTHNESS = 6,
    MOST_POINTS = MODEL_ROWS,
    MOST_COLUMNS = 8 * MOST_SMOOTHNESS - 5 /* of what `check_rope` works in */
};

/* a bound that is used up to this is used in full */
static const double FULL = 1.0 - 1e-6;

typedef struct {
    model base;
    int64_t points, smoothness, pieces;
    double duration;
    double events[MOST_POINTS + 1];  /* s, ascending: arrival at the waypoints, end */
    double ahead;                    /* s; the reference is that of so much later */
    double upcoming;                 /* s; the next event of the outputs, infinite after the last */
    /* derivatives of the reference, then of what belongs to the setpoints of each drive, and whether
       they are those of the present time */
    int64_t derived[MODEL_ORDERS][1 + AXES_SIZE];
    double derivatives[MODEL_ORDERS][1 + AXES_SIZE][RESULTS];
    /* the same of the load's motion, with which they are found */
    int64_t moved[1 + AXES_SIZE];
    double motion[1 + AXES_SIZE][(ORDERS + MODEL_ORDERS) * AXES];
    int64_t rows;                    /* of the history of every drive's contact */
    int64_t turns[AXES_SIZE];        /* those that count; 0: no friction */
    int64_t operates;                /* commands can be followed; their arrays are behind the plan */
    int64_t operating;               /* there was one: the present plan is in these arrays */
    double stops[AXES_SIZE];         /* s; when the axes of that come to rest, since its start */
    double space[];                  /* timing, coefficients, offsets, times, ends, contacts */
} feedforward;

/* What is planned: limits of the load, a row per axis; least ones are below 0, 0: as the others. */
typedef struct {
    double limits[LOAD_LIMITS_SIZE], lower[LOWER_LIMITS_SIZE];
    double velocity[MOST_POINTS * AXES], acceleration[MOST_POINTS * AXES];
    bool timed;                      /* whether a sample time and a duration are kept */
} request;

/* Pieces of each axis, as the kernels take them. */
static inline array_int64_t_1d offsets_of(const segfmu_trajectory *t)
{
    array_int64_t_1d offsets = {(int64_t *)t->offsets, {AXES + 1}};
    return offsets;
}

static inline array_double_2d timing_of(const segfmu_trajectory *t)
{
    return matrix((double *)t->timing, t->pieces, 2);
}

/* The crane of the parameters. */
static void crane_of(const model *base, double known[RESISTANCE_SIZE]);

/* The inverse for derivatives of the load's position, one row each, and derivatives of it, for which
   there are so many rows more. */
static void invert(double known[RESISTANCE_SIZE], double *load, double results[RESULTS]);
static void invert_derivative(
    double known[RESISTANCE_SIZE], double *load, int64_t order, double results[RESULTS]);

/* What is known of the drives, and the longest dead time [s] of them. */
static double drives_of(const feedforward *m, double known[COMPENSATION_SIZE]);

/* The time at which the plan starts without lead and dead times. */
static double feedforward_start(const feedforward *m);

/* The time at which the reference begins to move. */
static double beginning(const feedforward *m);

/* The lead counts from the end of initialisation on, where no importer asks for an event. */
static void begin_lead(feedforward *m, char message[MESSAGE]);

/* Plan by the parameters; false with a message where that cannot be done. */
static bool feedforward_plan(feedforward *m, char message[MESSAGE]);

/* Plan what is asked for, with a taut rope; false with a message where that cannot be done. */
static bool plan_at(feedforward *m, const request *r, char message[MESSAGE]);

/* The same without a look at the rope, and that look. */
static bool plan_loosely(feedforward *m, const request *r, char message[MESSAGE]);
static bool require_taut_plan(const feedforward *m, char message[MESSAGE]);

/* Check that what pulls stays taut, and the rope within its range. */
static bool require_taut(const segfmu_trajectory *t, const model *base, char message[MESSAGE]);

/* Check that load and rope keep to the workspace and off the obstacles. Works in what the plan has
   left of the block, which is more than this needs; the contacts there are found again. */
static bool require_space(feedforward *m, char message[MESSAGE]);

/* Greatest demands on the drives in both directions and their times, (2, DEMAND_SIZE): exact ones, or
   those among samples. */
static void measure(feedforward *m, bool exact, double *peaks, double *times);

/* Plan with limits of the load that are found, and free states with them; false with a message where
   there are none. Gives the exact demands as `measure` does. It needs so many numbers behind those that
   `segfmu_plan` needs. */
static bool feedforward_limits(feedforward *m, double *peaks, double *times, char message[MESSAGE]);
static size_t search_size(const model *base);

/* The first waypoint with a free velocity or acceleration, counted from 0; -1: there is none. */
static int64_t free_waypoint(const model *base);

/* Whether the velocity (order 0) or acceleration of an axis at a waypoint is free. */
static bool is_free_state(const model *base, int64_t place, int order);

/* Choose the free states of a request within its limits. It needs so many numbers behind those that
   `segfmu_plan` needs. */
static void choose_free_states(feedforward *m, request *r);
static size_t choice_size(const model *base);

/* Numbers of the plan in the block, without contacts. */
static size_t planned_size(const feedforward *m);

/* The same with contacts. */
static size_t mission_size(const feedforward *m);

/* Whether commands can be followed, and numbers of their arrays, at a smoothness. */
static bool takes_commands(const model *base);
static size_t operation_size(int64_t smoothness);

/* Get ready for commands behind the plan; false with a message where that cannot be. */
static bool begin_commands(feedforward *m, char message[MESSAGE]);

/* Follow the command at the present time, with the next one a step [s] later. */
static void follow_command(feedforward *m, double step, char message[MESSAGE]);

/* When the present plan begins, and when the command has to be looked at again. */
static double operation_begin(const feedforward *m);
static double operation_renewal(const feedforward *m);

/* The present plan. */
static segfmu_trajectory operation_trajectory(const feedforward *m);

/* Whether the arrays of commands have sizes and indices within themselves. */
static bool operation_sound(const feedforward *m);

/* s by which the outputs are ahead of a plan that begins at its start time. */
static double ahead_of(const feedforward *m);

/* The history of a drive's contact. */
static array_double_2d contacts_of(const feedforward *m, int axis);

/* The trajectory that is followed, and that of the mission. */
static segfmu_trajectory feedforward_trajectory(const feedforward *m);
static segfmu_trajectory mission_trajectory(const feedforward *m);

#endif
