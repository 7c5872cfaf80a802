/* Generated from the interface specification in Python; never edited. */
#ifndef SEGFMU_FEEDS_H
#define SEGFMU_FEEDS_H

#include "feed.h"

static const feeds feeds_resistance;
static const feeds feeds_rope_bounds;
static const feeds feeds_plan_options;
static const feeds feeds_load_limits;
static const feeds feeds_lower_limits;
static const feeds feeds_load_motion;
static const feeds feeds_compensation;
static const feeds feeds_drive_bounds;
static const feeds feeds_bound_uses;
static const feeds feeds_space;
static const feeds feeds_obstacle_row;
static const feeds feeds_pace;
static const feeds feeds_plan_limits;
static const feeds feeds_feedforward;
static const feeds feeds_command;
static const feeds feeds_drive_brakes;

#endif
