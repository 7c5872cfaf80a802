/* Generated from the interface specification in Python; never edited. */
#ifndef SEGFMU_FEEDS_H
#define SEGFMU_FEEDS_H

#include "feed.h"

static const feeds feeds_loop;
static const feeds feeds_sensors;
static const feeds feeds_plant;
static const feeds feeds_state;
static const feeds feeds_setpoints;
static const feeds feeds_target;
static const feeds feeds_payload_change;
static const feeds feeds_wind_noise;
static const feeds feeds_turbulence;
static const feeds feeds_tracking;
static const feeds feeds_tracking_design;
static const feeds feeds_outputs;
static const feeds feeds_accelerations;
static const feeds feeds_estimates;
static const feeds feeds_flat_design;
static const feeds feeds_gains_row;

#endif
