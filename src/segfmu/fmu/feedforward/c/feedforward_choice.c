/* Planner and flat inverse: free velocities and accelerations of waypoints within given limits. */
#include <math.h>
#include <string.h>

#include "limit_search.h"

/* The arrays of a choice for axes that meet in the waypoints. */
typedef struct {
    array_double_3d states, choice, spots, links, cells;
    array_double_1d dwells, place;
    array_double_2d limits, lower, allowed, tools, axes, spans, band, timing, coefficients, work;
} state_choice;

static array_double_2d take_matrix(double **block, size_t *size, int64_t rows, int64_t columns)
{
    double *data = block == NULL ? NULL : take(block, rows * columns);
    *size += (size_t)(rows * columns);
    return matrix(data, rows, columns);
}

static array_double_3d take_cuboid(double **block, size_t *size, int64_t first, int64_t rows, int64_t columns)
{
    double *data = block == NULL ? NULL : take(block, first * rows * columns);
    *size += (size_t)(first * rows * columns);
    return cuboid(data, first, rows, columns);
}

/* Lay the arrays out in a block, or only count the numbers that they need. */
static size_t lay_choice(state_choice *c, int64_t m, int64_t k, int64_t n, double **block)
{
    size_t size = 0;
    c->states = take_cuboid(block, &size, m, k, WAYPOINT_STATE_SIZE);
    c->choice = take_cuboid(block, &size, BLOCK_COUNT * m, k, WAYPOINT_STATE_SIZE);
    c->spots = take_cuboid(block, &size, m * k, SPOT_SIZE, SPOT_COLUMNS);
    c->links = take_cuboid(block, &size, (m - 1) * k, LINK_SIZE, LINK_COLUMNS);
    c->cells = take_cuboid(block, &size, (m - 1) * k, CELL_SIZE, CELL_COLUMNS);
    c->limits = take_matrix(block, &size, k, n + 1);
    c->lower = take_matrix(block, &size, k, LOWER_SIZE);
    c->allowed = take_matrix(block, &size, k, 2);
    c->tools = take_matrix(block, &size, TOOLS_SIZE, TOOLS_COLUMNS);
    c->axes = take_matrix(block, &size, k, TRACK_SIZE);
    c->spans = take_matrix(block, &size, m, STRETCH_SIZE);
    c->band = take_matrix(block, &size, 2 * m * k, 4 * k + 1);
    c->timing = take_matrix(block, &size, 2 * SPARE_ROWS, TIMING_SIZE);
    c->coefficients = take_matrix(block, &size, 2 * SPARE_ROWS, 2 * n);
    c->work = take_matrix(block, &size, MOTION_WORK_SIZE, MOTION_WORK_COLUMNS);
    c->dwells = vector(take_matrix(block, &size, m, 1).data, m);
    c->place = vector(take_matrix(block, &size, m, 1).data, m);
    return size;
}

size_t choice_size(const model *base)
{
    state_choice c;
    if (free_waypoint(base) < 0) {
        return 0;
    }
    return lay_choice(
        &c, base->integer[V_WAYPOINT_COUNT], AXES, base->integer[V_PLANNER_SMOOTHNESS], NULL);
}

/* What is asked of the axes from `first` on. */
static void pose_choice(state_choice *c, const feedforward *m, const request *r, int first)
{
    const double *real = m->base.real;
    const int64_t points = c->states.shape[0], count = c->states.shape[1];
    const double every = 1e307;
    for (int64_t axis = 0; axis < count; axis++) {
        const int64_t own = first + axis;
        for (int64_t i = 0; i < c->limits.shape[1]; i++) {
            *cspan_at(&c->limits, axis, i) = i < LIMITS ? r->limits[own * LIMITS + i] : 0.0;
        }
        for (int64_t i = 0; i < LOWER_SIZE; i++) {
            *cspan_at(&c->lower, axis, i) = -r->lower[own * LOWER_SIZE + i];
            *cspan_at(&c->allowed, axis, i) = i == 0 ? -every : every;
        }
        for (int64_t i = 0; i < points; i++) {
            double *state = c->states.data + (i * count + axis) * WAYPOINT_STATE_SIZE;
            const int64_t place = i * AXES + own;
            state[WAYPOINT_STATE_POSITION] = real[V_WAYPOINT_POSITION + place];
            state[WAYPOINT_STATE_VELOCITY] = is_free_state(&m->base, place, 0) ? NAN : r->velocity[place];
            state[WAYPOINT_STATE_ACCELERATION] =
                is_free_state(&m->base, place, 1) ? NAN : r->acceleration[place];
        }
    }
    memcpy(c->dwells.data, real + V_WAYPOINT_DWELL, (size_t)points * sizeof *real);
    double *options = c->work.data + MOTION_WORK_OPTIONS * MOTION_WORK_COLUMNS;
    feed_record(&feeds_plan_options, &m->base, options);
    options[PLAN_OPTIONS_SYNCHRONIZATION] = SYNCHRONIZATION_WAYPOINTS;
    options[PLAN_OPTIONS_SAMPLE_TIME] = options[PLAN_OPTIONS_DURATION] = 0.0;
    *cspan_at(&c->tools, TOOLS_PATH, PATH_SHARE) = segfmu_usual_room();
}

void choose_free_states(feedforward *m, request *r)
{
    const int64_t points = m->base.integer[V_WAYPOINT_COUNT], n = m->base.integer[V_PLANNER_SMOOTHNESS];
    double options[PLAN_OPTIONS_SIZE];
    feed_record(&feeds_plan_options, &m->base, options);
    const bool meets = (int)options[PLAN_OPTIONS_SYNCHRONIZATION] == SYNCHRONIZATION_WAYPOINTS;
    const int count = meets ? AXES : 1;
    double *const space = m->space + segfmu_plan_size(points, AXES, n);
    if (free_waypoint(&m->base) < 0) {
        return;
    }
    for (int first = 0; first < AXES; first += count) {
        state_choice c;
        double *block = space;
        memset(space, 0, choice_size(&m->base) * sizeof *space);
        lay_choice(&c, points, count, n, &block);
        pose_choice(&c, m, r, first);
        segfmu_settle_states(0, c.states, c.limits, c.lower);
        if (segfmu_begin_choice(c.states, c.dwells, c.limits, c.lower, c.allowed, c.choice, c.place,
                                c.tools, c.axes, c.spots, c.work)) {
            while (segfmu_next_passage(c.tools, c.spots)) {
                segfmu_choose_passage(c.choice, c.tools, c.axes, c.spots, c.links, c.spans, c.band,
                                      c.cells, c.timing, c.coefficients, c.work);
            }
        }
        segfmu_end_choice(c.states, c.place, c.choice, c.tools, c.axes);
        for (int64_t i = 0; i < points * count; i++) {
            const int64_t place = i / count * AXES + first + i % count;
            const double *state = c.states.data + i * WAYPOINT_STATE_SIZE;
            r->velocity[place] = state[WAYPOINT_STATE_VELOCITY];
            r->acceleration[place] = state[WAYPOINT_STATE_ACCELERATION];
        }
    }
}
