/* Planner and flat inverse: the places of the waypoints, their free states, and the work space of a search. */
#include <math.h>
#include <string.h>

#include "limit_search.h"

bool is_free_state(const model *base, int64_t place, int order)
{
    return base->integer[(order == 0 ? V_WAYPOINT_VELOCITY_FREE : V_WAYPOINT_ACCELERATION_FREE) + place];
}

int64_t free_waypoint(const model *base)
{
    for (int64_t i = 0; i < base->integer[V_WAYPOINT_COUNT] * AXES; i++) {
        if (is_free_state(base, i, 0) || is_free_state(base, i, 1)) {
            return i / AXES;
        }
    }
    return -1;
}

static int64_t most_unknowns(const model *base)
{
    const int64_t inner = base->integer[V_WAYPOINT_COUNT] - 2;
    return LIMIT_UNKNOWNS + (free_waypoint(base) >= 0 && inner > 0 ? STATE_UNKNOWNS * inner : 0);
}

/* Numbers by waypoint and by unknown. */
enum {
    BY_POINT = 2 * POINT + 1 + 2 * AXES, BY_UNKNOWN = 2 + STARTS_COUNT + SEARCH_SIZE + VALUES_SIZE
};

size_t search_size(const model *base)
{
    const int64_t most = most_unknowns(base);
    return (size_t)(base->integer[V_WAYPOINT_COUNT] * BY_POINT + most * (BY_UNKNOWN + 2 * most));
}

static void lay_out(limit_search *s, const model *base, double *block)
{
    const int64_t most = most_unknowns(base);
    s->states = take(&block, s->points * POINT);
    s->tried = take(&block, s->points * POINT);
    s->place = take(&block, s->points);
    s->places_at = take(&block, s->points * AXES);
    s->led = take(&block, s->points * AXES);
    s->kinds = take(&block, most);
    s->closest = take(&block, most);
    s->starts = take(&block, STARTS_COUNT * most);
    s->rows = take(&block, SEARCH_SIZE * most);
    s->slopes = take(&block, VALUES_SIZE * most);
    s->newton = take(&block, 2 * most * most);
}

void split_states(const double *states, int64_t points, request *r)
{
    for (int64_t i = 0; i < points * AXES; i++) {
        r->velocity[i] = states[i * WAYPOINT_STATE_SIZE + WAYPOINT_STATE_VELOCITY];
        r->acceleration[i] = states[i * WAYPOINT_STATE_SIZE + WAYPOINT_STATE_ACCELERATION];
    }
}

bool find_places(limit_search *s, feedforward *m)
{
    double *real = m->base.real;
    memset(s, 0, sizeof *s);
    s->points = m->base.integer[V_WAYPOINT_COUNT];
    lay_out(s, &m->base, m->space + segfmu_plan_size(s->points, AXES, m->base.integer[V_PLANNER_SMOOTHNESS]));
    for (int64_t i = 0; i < s->points * AXES; i++) {
        double *state = s->states + i * WAYPOINT_STATE_SIZE;
        state[WAYPOINT_STATE_POSITION] = real[V_WAYPOINT_POSITION + i];
        state[WAYPOINT_STATE_VELOCITY] = is_free_state(&m->base, i, 0) ? NAN : real[V_WAYPOINT_VELOCITY + i];
        state[WAYPOINT_STATE_ACCELERATION] =
            is_free_state(&m->base, i, 1) ? NAN : real[V_WAYPOINT_ACCELERATION + i];
    }
    array_double_3d states = cuboid(s->states, s->points, AXES, WAYPOINT_STATE_SIZE);
    array_double_1d place = vector(s->place, s->points);
    segfmu_unite_waypoints(states, place);
    for (int64_t i = 0; i < s->points; i++) {
        if (i == 0 || s->place[i] > s->place[i - 1]) {
            memcpy(s->places_at + s->places++ * AXES, real + V_WAYPOINT_POSITION + i * AXES,
                   AXES * sizeof *real);
        }
    }
    segfmu_write_heading(matrix(s->places_at, s->places, AXES), vector(s->heading, HEADING_SIZE));
    segfmu_write_free(
        states, place, vector(real + V_WAYPOINT_DWELL, s->points), vector(s->heading, HEADING_SIZE),
        vector(s->kinds, most_unknowns(&m->base)), matrix(s->led, s->points, AXES));
    split_states(s->states, s->points, &s->base);
    bool chooses = false;
    for (int64_t i = 0; i < s->points * AXES; i++) {
        chooses = chooses || s->led[i] > 0.0;
    }
    return chooses;
}
