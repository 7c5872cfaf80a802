/* Generated from the interface specification in Python; never edited. */
#include "feeds.h"

static const feed feeds_loop_rows[] = {
    {1, 188, 0, 0, false},
    {4, 195, 0, 0, false},
    {0, 13, 0, 0, true},
    {2, 11, 0, 0, true}
};
static const feed_run feeds_loop_runs[] = {{1, 188, 1}, {4, 195, 1}};
static const feeds feeds_loop = {
    feeds_loop_rows, 4, 2, feeds_loop_runs, 2
};

static const feed feeds_sensors_rows[] = {
    {0, 138, 0, 0, false},
    {1, 139, 0, 0, false},
    {3, 142, 0, 0, false},
    {4, 145, 0, 0, false},
    {5, 148, 0, 0, false},
    {6, 151, 0, 0, false},
    {7, 154, 0, 0, false},
    {8, 141, 0, 0, false},
    {9, 144, 0, 0, false},
    {10, 147, 0, 0, false},
    {11, 150, 0, 0, false},
    {12, 153, 0, 0, false},
    {13, 140, 0, 0, false},
    {14, 143, 0, 0, false},
    {15, 146, 0, 0, false},
    {16, 149, 0, 0, false},
    {17, 152, 0, 0, false},
    {2, 6, 0, 0, true}
};
static const feed_run feeds_sensors_runs[] = {{0, 138, 2}, {3, 142, 1}, {4, 145, 1}, {5, 148, 1}, {6, 151, 1}, {7, 154, 1}, {8, 141, 1}, {9, 144, 1}, {10, 147, 1}, {11, 150, 1}, {12, 153, 1}, {13, 140, 1}, {14, 143, 1}, {15, 146, 1}, {16, 149, 1}, {17, 152, 1}};
static const feeds feeds_sensors = {
    feeds_sensors_rows, 18, 17, feeds_sensors_runs, 16
};

static const feed feeds_plant_rows[] = {
    {0, 77, 0, 0, false},
    {1, 78, 0, 0, false},
    {2, 79, 0, 0, false},
    {3, 80, 0, 0, false},
    {4, 111, 0, 0, false},
    {5, 115, 0, 0, false},
    {6, 119, 0, 0, false},
    {7, 112, 0, 0, false},
    {8, 116, 0, 0, false},
    {9, 120, 0, 0, false},
    {10, 113, 0, 0, false},
    {11, 117, 0, 0, false},
    {12, 121, 0, 0, false},
    {13, 114, 0, 0, false},
    {14, 118, 0, 0, false},
    {15, 122, 0, 0, false},
    {16, 123, 0, 0, false},
    {17, 124, 0, 0, false},
    {18, 84, 0, 0, false},
    {19, 93, 0, 0, false},
    {20, 102, 0, 0, false},
    {25, 85, 0, 0, false},
    {26, 94, 0, 0, false},
    {27, 103, 0, 0, false},
    {28, 86, 0, 0, false},
    {29, 95, 0, 0, false},
    {30, 104, 0, 0, false},
    {31, 87, 0, 0, false},
    {32, 96, 0, 0, false},
    {33, 105, 0, 0, false},
    {34, 88, 0, 0, false},
    {35, 97, 0, 0, false},
    {36, 106, 0, 0, false},
    {37, 89, 0, 0, false},
    {38, 98, 0, 0, false},
    {39, 107, 0, 0, false},
    {40, 90, 0, 0, false},
    {41, 99, 0, 0, false},
    {42, 108, 0, 0, false},
    {43, 91, 0, 0, false},
    {44, 100, 0, 0, false},
    {45, 109, 0, 0, false},
    {46, 92, 0, 0, false},
    {47, 101, 0, 0, false},
    {48, 110, 0, 0, false},
    {49, 125, 0, 0, false},
    {50, 126, 0, 0, false},
    {51, 130, 0, 0, false},
    {52, 134, 0, 0, false},
    {53, 127, 0, 0, false},
    {54, 131, 0, 0, false},
    {55, 135, 0, 0, false},
    {56, 128, 0, 0, false},
    {57, 132, 0, 0, false},
    {58, 136, 0, 0, false},
    {59, 129, 0, 0, false},
    {60, 133, 0, 0, false},
    {61, 137, 0, 0, false},
    {62, 155, 0, 0, false},
    {63, 156, 0, 0, false},
    {64, 157, 0, 0, false},
    {65, 158, 0, 0, false},
    {66, 159, 0, 0, false},
    {68, 160, 0, 0, false},
    {69, 161, 0, 0, false},
    {70, 162, 0, 0, false},
    {71, 167, 0, 0, false},
    {72, 168, 0, 0, false},
    {73, 169, 0, 0, false},
    {74, 170, 0, 0, false},
    {75, 171, 0, 0, false},
    {76, 172, 0, 0, false},
    {77, 179, 0, 0, false},
    {78, 178, 0, 0, false},
    {24, 3, 0, 1, true},
    {67, 7, 0, 1, true},
    {79, 5, 0, 1, true}
};
static const feed_run feeds_plant_runs[] = {{0, 77, 4}, {4, 111, 1}, {5, 115, 1}, {6, 119, 1}, {7, 112, 1}, {8, 116, 1}, {9, 120, 1}, {10, 113, 1}, {11, 117, 1}, {12, 121, 1}, {13, 114, 1}, {14, 118, 1}, {15, 122, 3}, {18, 84, 1}, {19, 93, 1}, {20, 102, 1}, {25, 85, 1}, {26, 94, 1}, {27, 103, 1}, {28, 86, 1}, {29, 95, 1}, {30, 104, 1}, {31, 87, 1}, {32, 96, 1}, {33, 105, 1}, {34, 88, 1}, {35, 97, 1}, {36, 106, 1}, {37, 89, 1}, {38, 98, 1}, {39, 107, 1}, {40, 90, 1}, {41, 99, 1}, {42, 108, 1}, {43, 91, 1}, {44, 100, 1}, {45, 109, 1}, {46, 92, 1}, {47, 101, 1}, {48, 110, 1}, {49, 125, 2}, {51, 130, 1}, {52, 134, 1}, {53, 127, 1}, {54, 131, 1}, {55, 135, 1}, {56, 128, 1}, {57, 132, 1}, {58, 136, 1}, {59, 129, 1}, {60, 133, 1}, {61, 137, 1}, {62, 155, 5}, {68, 160, 3}, {71, 167, 6}, {77, 179, 1}, {78, 178, 1}};
static const feeds feeds_plant = {
    feeds_plant_rows, 77, 74, feeds_plant_runs, 57
};

static const feed feeds_state_rows[] = {
    {0, 22, 0, 0, false},
    {1, 23, 0, 0, false},
    {2, 24, 0, 0, false},
    {3, 25, 0, 0, false},
    {4, 26, 0, 0, false},
    {5, 27, 0, 0, false},
    {6, 28, 0, 0, false},
    {7, 29, 0, 0, false},
    {8, 30, 0, 0, false},
    {9, 31, 0, 0, false}
};
static const feed_run feeds_state_runs[] = {{0, 22, 10}};
static const feeds feeds_state = {
    feeds_state_rows, 10, 10, feeds_state_runs, 1
};

static const feed feeds_setpoints_rows[] = {
    {0, 0, 0, 0, false},
    {1, 1, 0, 0, false},
    {2, 2, 0, 0, false},
    {3, 3, 0, 0, false},
    {4, 4, 0, 0, false},
    {5, 5, 0, 0, false},
    {6, 6, 0, 0, false},
    {7, 7, 0, 0, false},
    {8, 8, 0, 0, false},
    {9, 9, 0, 0, false},
    {10, 10, 0, 0, false},
    {11, 11, 0, 0, false},
    {12, 12, 0, 0, false},
    {13, 13, 0, 0, false},
    {14, 14, 0, 0, false},
    {15, 15, 0, 0, false},
    {16, 19, 0, 0, false},
    {17, 20, 0, 0, false},
    {18, 21, 0, 0, false}
};
static const feed_run feeds_setpoints_runs[] = {{0, 0, 16}, {16, 19, 3}};
static const feeds feeds_setpoints = {
    feeds_setpoints_rows, 19, 19, feeds_setpoints_runs, 2
};

static const feed feeds_target_rows[] = {
    {0, 16, 0, 0, false},
    {1, 17, 0, 0, false},
    {2, 18, 0, 0, false}
};
static const feed_run feeds_target_runs[] = {{0, 16, 3}};
static const feeds feeds_target = {
    feeds_target_rows, 3, 3, feeds_target_runs, 1
};

static const feed feeds_payload_change_rows[] = {
    {0, 180, 2, 0, false},
    {1, 181, 2, 0, false}
};
static const feed_run feeds_payload_change_runs[] = {{0, 180, 2}};
static const feeds feeds_payload_change = {
    feeds_payload_change_rows, 2, 2, feeds_payload_change_runs, 1
};

static const feed feeds_wind_noise_rows[] = {
    {0, 163, 0, 0, false},
    {1, 164, 0, 0, false},
    {2, 165, 0, 0, false},
    {3, 166, 0, 0, false},
    {4, 8, 0, 0, true}
};
static const feed_run feeds_wind_noise_runs[] = {{0, 163, 4}};
static const feeds feeds_wind_noise = {
    feeds_wind_noise_rows, 5, 4, feeds_wind_noise_runs, 1
};

static const feed feeds_turbulence_rows[] = {
    {0, 167, 0, 0, false},
    {1, 168, 0, 0, false},
    {2, 169, 0, 0, false},
    {3, 173, 0, 0, false},
    {4, 174, 0, 0, false},
    {5, 175, 0, 0, false},
    {6, 176, 0, 0, false},
    {7, 177, 0, 0, false},
    {8, 9, 0, 0, true}
};
static const feed_run feeds_turbulence_runs[] = {{0, 167, 3}, {3, 173, 5}};
static const feeds feeds_turbulence = {
    feeds_turbulence_rows, 9, 8, feeds_turbulence_runs, 2
};

static const feed feeds_tracking_rows[] = {
    {1, 188, 0, 0, false},
    {6, 80, 0, 0, false},
    {7, 193, 0, 0, false},
    {8, 194, 0, 0, false},
    {10, 195, 0, 0, false},
    {0, 3, 0, 1, true},
    {9, 11, 0, 0, true},
    {39, 15, 0, 1, true},
    {40, 14, 0, 0, true}
};
static const feed_run feeds_tracking_runs[] = {{1, 188, 1}, {6, 80, 1}, {7, 193, 2}, {10, 195, 1}};
static const feeds feeds_tracking = {
    feeds_tracking_rows, 9, 5, feeds_tracking_runs, 4
};

static const feed feeds_tracking_design_rows[] = {
    {0, 197, 0, 0, false},
    {1, 198, 0, 0, false},
    {2, 199, 0, 0, false},
    {3, 200, 0, 0, false},
    {4, 201, 0, 0, false},
    {5, 202, 0, 0, false},
    {6, 203, 0, 0, false},
    {7, 139, 0, 0, false},
    {8, 138, 0, 0, false},
    {9, 196, 0, 0, false}
};
static const feed_run feeds_tracking_design_runs[] = {{0, 197, 7}, {7, 139, 1}, {8, 138, 1}, {9, 196, 1}};
static const feeds feeds_tracking_design = {
    feeds_tracking_design_rows, 10, 10, feeds_tracking_design_runs, 4
};

static const feed feeds_outputs_rows[] = {
    {0, 22, 0, 0, false},
    {1, 23, 0, 0, false},
    {2, 24, 0, 0, false},
    {3, 25, 0, 0, false},
    {4, 26, 0, 0, false},
    {5, 27, 0, 0, false},
    {6, 28, 0, 0, false},
    {7, 29, 0, 0, false},
    {8, 30, 0, 0, false},
    {9, 31, 0, 0, false},
    {10, 72, 0, 0, false},
    {11, 73, 0, 0, false},
    {12, 74, 0, 0, false},
    {13, 32, 0, 0, false},
    {14, 33, 0, 0, false},
    {15, 34, 0, 0, false},
    {16, 35, 0, 0, false},
    {17, 36, 0, 0, false},
    {18, 37, 0, 0, false},
    {19, 38, 0, 0, false},
    {20, 39, 0, 0, false},
    {21, 40, 0, 0, false},
    {22, 41, 0, 0, false},
    {23, 42, 0, 0, false},
    {24, 75, 0, 0, false},
    {25, 76, 0, 0, false},
    {26, 43, 0, 0, false},
    {27, 44, 0, 0, false},
    {28, 45, 0, 0, false},
    {29, 46, 0, 0, false},
    {30, 47, 0, 0, false},
    {31, 49, 0, 0, false},
    {32, 51, 0, 0, false},
    {36, 48, 0, 0, false},
    {37, 50, 0, 0, false},
    {38, 52, 0, 0, false},
    {39, 53, 0, 0, false},
    {40, 54, 0, 0, false},
    {41, 55, 0, 0, false},
    {42, 56, 0, 0, false},
    {43, 57, 0, 0, false},
    {44, 58, 0, 0, false},
    {45, 59, 0, 0, false},
    {46, 60, 0, 0, false},
    {47, 61, 0, 0, false},
    {48, 62, 0, 0, false},
    {49, 63, 0, 0, false},
    {50, 64, 0, 0, false},
    {33, 0, 0, 0, true},
    {34, 1, 0, 0, true},
    {35, 2, 0, 0, true}
};
static const feed_run feeds_outputs_runs[] = {{0, 22, 10}, {10, 72, 3}, {13, 32, 11}, {24, 75, 2}, {26, 43, 5}, {31, 49, 1}, {32, 51, 1}, {36, 48, 1}, {37, 50, 1}, {38, 52, 13}};
static const feeds feeds_outputs = {
    feeds_outputs_rows, 51, 48, feeds_outputs_runs, 10
};

static const feed feeds_accelerations_rows[] = {
    {0, 443, 0, 0, false},
    {1, 444, 0, 0, false},
    {2, 445, 0, 0, false},
    {3, 446, 0, 0, false},
    {4, 447, 0, 0, false},
    {5, 448, 0, 0, false},
    {6, 449, 0, 0, false},
    {7, 450, 0, 0, false}
};
static const feed_run feeds_accelerations_runs[] = {{0, 443, 8}};
static const feeds feeds_accelerations = {
    feeds_accelerations_rows, 8, 8, feeds_accelerations_runs, 1
};

static const feed feeds_estimates_rows[] = {
    {0, 65, 0, 0, false},
    {1, 66, 0, 0, false},
    {2, 67, 0, 0, false},
    {3, 68, 0, 0, false},
    {4, 69, 0, 0, false},
    {5, 70, 0, 0, false},
    {6, 71, 0, 0, false}
};
static const feed_run feeds_estimates_runs[] = {{0, 65, 7}};
static const feeds feeds_estimates = {
    feeds_estimates_rows, 7, 7, feeds_estimates_runs, 1
};

static const feed feeds_flat_design_rows[] = {
    {0, 188, 0, 0, false},
    {1, 190, 0, 0, false},
    {2, 191, 0, 0, false},
    {3, 192, 0, 0, false},
    {4, 139, 0, 0, false}
};
static const feed_run feeds_flat_design_runs[] = {{0, 188, 1}, {1, 190, 3}, {4, 139, 1}};
static const feeds feeds_flat_design = {
    feeds_flat_design_rows, 5, 5, feeds_flat_design_runs, 3
};

static const feed feeds_gains_row_rows[] = {
    {0, 205, 1, 0, false},
    {11, 222, 5, 0, false},
    {14, 223, 5, 0, false},
    {16, 224, 5, 0, false},
    {19, 225, 5, 0, false},
    {21, 226, 5, 0, false},
    {23, 307, 5, 0, false},
    {26, 308, 5, 0, false},
    {28, 309, 5, 0, false},
    {31, 310, 5, 0, false},
    {32, 311, 5, 0, false},
    {35, 392, 3, 0, false},
    {40, 393, 3, 0, false},
    {43, 394, 3, 0, false}
};
static const feed_run feeds_gains_row_runs[] = {{0, 205, 1}, {11, 222, 1}, {14, 223, 1}, {16, 224, 1}, {19, 225, 1}, {21, 226, 1}, {23, 307, 1}, {26, 308, 1}, {28, 309, 1}, {31, 310, 2}, {35, 392, 1}, {40, 393, 1}, {43, 394, 1}};
static const feeds feeds_gains_row = {
    feeds_gains_row_rows, 14, 14, feeds_gains_row_runs, 13
};
