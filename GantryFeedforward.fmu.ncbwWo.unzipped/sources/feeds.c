/* Generated from the interface specification in Python; never edited. */
#include "feeds.h"

static const feed feeds_resistance_rows[] = {
    {0, 39, 0, 0, false},
    {1, 40, 0, 0, false},
    {2, 41, 0, 0, false},
    {3, 42, 0, 0, false},
    {4, 302, 0, 0, false},
    {5, 306, 0, 0, false},
    {6, 310, 0, 0, false},
    {7, 303, 0, 0, false},
    {8, 307, 0, 0, false},
    {9, 311, 0, 0, false},
    {10, 304, 0, 0, false},
    {11, 308, 0, 0, false},
    {12, 312, 0, 0, false},
    {13, 305, 0, 0, false},
    {14, 309, 0, 0, false},
    {15, 313, 0, 0, false},
    {16, 314, 0, 0, false},
    {17, 315, 0, 0, false},
    {18, 85, 0, 0, false},
    {19, 87, 0, 0, false},
    {20, 89, 0, 0, false}
};
static const feed_run feeds_resistance_runs[] = {{0, 39, 4}, {4, 302, 1}, {5, 306, 1}, {6, 310, 1}, {7, 303, 1}, {8, 307, 1}, {9, 311, 1}, {10, 304, 1}, {11, 308, 1}, {12, 312, 1}, {13, 305, 1}, {14, 309, 1}, {15, 313, 3}, {18, 85, 1}, {19, 87, 1}, {20, 89, 1}};
static const feeds feeds_resistance = {
    feeds_resistance_rows, 21, 21, feeds_resistance_runs, 16
};

static const feed feeds_rope_bounds_rows[] = {
    {0, 42, 0, 0, false},
    {1, 43, 0, 0, false},
    {2, 44, 0, 0, false}
};
static const feed_run feeds_rope_bounds_runs[] = {{0, 42, 3}};
static const feeds feeds_rope_bounds = {
    feeds_rope_bounds_rows, 3, 3, feeds_rope_bounds_runs, 1
};

static const feed feeds_plan_options_rows[] = {
    {3, 81, 0, 0, false},
    {4, 82, 0, 0, false},
    {0, 4, 0, 0, true},
    {1, 5, 0, 1, true},
    {2, 6, 0, 1, true}
};
static const feed_run feeds_plan_options_runs[] = {{3, 81, 2}};
static const feeds feeds_plan_options = {
    feeds_plan_options_rows, 5, 2, feeds_plan_options_runs, 1
};

static const feed feeds_load_limits_rows[] = {
    {0, 45, 0, 0, false},
    {1, 46, 0, 0, false},
    {2, 47, 0, 0, false},
    {3, 48, 0, 0, false},
    {4, 51, 0, 0, false},
    {5, 52, 0, 0, false},
    {6, 53, 0, 0, false},
    {7, 54, 0, 0, false},
    {8, 57, 0, 0, false},
    {9, 58, 0, 0, false},
    {10, 59, 0, 0, false},
    {11, 60, 0, 0, false}
};
static const feed_run feeds_load_limits_runs[] = {{0, 45, 4}, {4, 51, 4}, {8, 57, 4}};
static const feeds feeds_load_limits = {
    feeds_load_limits_rows, 12, 12, feeds_load_limits_runs, 3
};

static const feed feeds_lower_limits_rows[] = {
    {0, 49, 0, 0, false},
    {1, 50, 0, 0, false},
    {2, 55, 0, 0, false},
    {3, 56, 0, 0, false},
    {4, 61, 0, 0, false},
    {5, 62, 0, 0, false}
};
static const feed_run feeds_lower_limits_runs[] = {{0, 49, 2}, {2, 55, 2}, {4, 61, 2}};
static const feeds feeds_lower_limits = {
    feeds_lower_limits_rows, 6, 6, feeds_lower_limits_runs, 3
};

static const feed feeds_load_motion_rows[] = {
    {0, 6, 0, 0, false},
    {1, 7, 0, 0, false},
    {2, 8, 0, 0, false},
    {3, 9, 0, 0, false},
    {4, 10, 0, 0, false},
    {5, 11, 0, 0, false},
    {6, 12, 0, 0, false},
    {7, 13, 0, 0, false},
    {8, 14, 0, 0, false},
    {9, 15, 0, 0, false},
    {10, 16, 0, 0, false},
    {11, 17, 0, 0, false},
    {12, 18, 0, 0, false},
    {13, 19, 0, 0, false},
    {14, 20, 0, 0, false}
};
static const feed_run feeds_load_motion_runs[] = {{0, 6, 15}};
static const feeds feeds_load_motion = {
    feeds_load_motion_rows, 15, 15, feeds_load_motion_runs, 1
};

static const feed feeds_compensation_rows[] = {
    {0, 85, 0, 0, false},
    {1, 87, 0, 0, false},
    {2, 89, 0, 0, false},
    {3, 86, 0, 0, false},
    {4, 88, 0, 0, false},
    {5, 90, 0, 0, false}
};
static const feed_run feeds_compensation_runs[] = {{0, 85, 1}, {1, 87, 1}, {2, 89, 1}, {3, 86, 1}, {4, 88, 1}, {5, 90, 1}};
static const feeds feeds_compensation = {
    feeds_compensation_rows, 6, 6, feeds_compensation_runs, 6
};

static const feed feeds_drive_bounds_rows[] = {
    {0, 91, 0, 0, false},
    {1, 98, 0, 0, false},
    {2, 105, 0, 0, false},
    {3, 93, 0, 0, false},
    {4, 100, 0, 0, false},
    {5, 107, 0, 0, false},
    {6, 95, 0, 0, false},
    {7, 102, 0, 0, false},
    {8, 109, 0, 0, false},
    {9, 97, 0, 0, false},
    {10, 104, 0, 0, false},
    {11, 111, 0, 0, false},
    {12, 115, 0, 0, false},
    {13, 117, 0, 0, false},
    {14, 119, 0, 0, false},
    {15, 112, 0, 0, false},
    {16, 113, 0, 0, false},
    {17, 92, 0, 0, false},
    {18, 99, 0, 0, false},
    {19, 106, 0, 0, false},
    {20, 94, 0, 0, false},
    {21, 101, 0, 0, false},
    {22, 108, 0, 0, false},
    {23, 96, 0, 0, false},
    {24, 103, 0, 0, false},
    {25, 110, 0, 0, false},
    {26, 114, 0, 0, false},
    {27, 116, 0, 0, false},
    {28, 118, 0, 0, false}
};
static const feed_run feeds_drive_bounds_runs[] = {{0, 91, 1}, {1, 98, 1}, {2, 105, 1}, {3, 93, 1}, {4, 100, 1}, {5, 107, 1}, {6, 95, 1}, {7, 102, 1}, {8, 109, 1}, {9, 97, 1}, {10, 104, 1}, {11, 111, 1}, {12, 115, 1}, {13, 117, 1}, {14, 119, 1}, {15, 112, 2}, {17, 92, 1}, {18, 99, 1}, {19, 106, 1}, {20, 94, 1}, {21, 101, 1}, {22, 108, 1}, {23, 96, 1}, {24, 103, 1}, {25, 110, 1}, {26, 114, 1}, {27, 116, 1}, {28, 118, 1}};
static const feeds feeds_drive_bounds = {
    feeds_drive_bounds_rows, 29, 29, feeds_drive_bounds_runs, 28
};

static const feed feeds_bound_uses_rows[] = {
    {0, 120, 0, 0, false},
    {1, 122, 0, 0, false},
    {2, 124, 0, 0, false},
    {3, 126, 0, 0, false},
    {4, 128, 0, 0, false},
    {5, 130, 0, 0, false},
    {6, 132, 0, 0, false},
    {7, 134, 0, 0, false},
    {8, 136, 0, 0, false},
    {9, 138, 0, 0, false},
    {10, 140, 0, 0, false},
    {11, 142, 0, 0, false},
    {12, 144, 0, 0, false},
    {13, 146, 0, 0, false},
    {14, 148, 0, 0, false},
    {15, 150, 0, 0, false},
    {16, 152, 0, 0, false},
    {17, 121, 0, 0, false},
    {18, 123, 0, 0, false},
    {19, 125, 0, 0, false},
    {20, 127, 0, 0, false},
    {21, 129, 0, 0, false},
    {22, 131, 0, 0, false},
    {23, 133, 0, 0, false},
    {24, 135, 0, 0, false},
    {25, 137, 0, 0, false},
    {26, 139, 0, 0, false},
    {27, 141, 0, 0, false},
    {28, 143, 0, 0, false},
    {29, 145, 0, 0, false},
    {30, 147, 0, 0, false},
    {31, 149, 0, 0, false},
    {32, 151, 0, 0, false},
    {33, 153, 0, 0, false}
};
static const feed_run feeds_bound_uses_runs[] = {{0, 120, 1}, {1, 122, 1}, {2, 124, 1}, {3, 126, 1}, {4, 128, 1}, {5, 130, 1}, {6, 132, 1}, {7, 134, 1}, {8, 136, 1}, {9, 138, 1}, {10, 140, 1}, {11, 142, 1}, {12, 144, 1}, {13, 146, 1}, {14, 148, 1}, {15, 150, 1}, {16, 152, 1}, {17, 121, 1}, {18, 123, 1}, {19, 125, 1}, {20, 127, 1}, {21, 129, 1}, {22, 131, 1}, {23, 133, 1}, {24, 135, 1}, {25, 137, 1}, {26, 139, 1}, {27, 141, 1}, {28, 143, 1}, {29, 145, 1}, {30, 147, 1}, {31, 149, 1}, {32, 151, 1}, {33, 153, 1}};
static const feeds feeds_bound_uses = {
    feeds_bound_uses_rows, 34, 34, feeds_bound_uses_runs, 34
};

static const feed feeds_space_rows[] = {
    {0, 42, 0, 0, false},
    {1, 154, 0, 0, false},
    {2, 156, 0, 0, false},
    {3, 158, 0, 0, false},
    {4, 155, 0, 0, false},
    {5, 157, 0, 0, false},
    {6, 159, 0, 0, false},
    {7, 160, 0, 0, false},
    {8, 161, 0, 0, false},
    {9, 162, 0, 0, false},
    {10, 163, 0, 0, false},
    {11, 164, 0, 0, false},
    {12, 165, 0, 0, false},
    {13, 9, 0, 0, true}
};
static const feed_run feeds_space_runs[] = {{0, 42, 1}, {1, 154, 1}, {2, 156, 1}, {3, 158, 1}, {4, 155, 1}, {5, 157, 1}, {6, 159, 7}};
static const feeds feeds_space = {
    feeds_space_rows, 14, 13, feeds_space_runs, 7
};

static const feed feeds_obstacle_row_rows[] = {
    {0, 166, 3, 0, false},
    {1, 167, 3, 0, false},
    {2, 168, 3, 0, false},
    {3, 214, 3, 0, false},
    {4, 215, 3, 0, false},
    {5, 216, 3, 0, false},
    {6, 262, 1, 0, false},
    {7, 10, 1, 0, true}
};
static const feed_run feeds_obstacle_row_runs[] = {{0, 166, 3}, {3, 214, 3}, {6, 262, 1}};
static const feeds feeds_obstacle_row = {
    feeds_obstacle_row_rows, 8, 7, feeds_obstacle_row_runs, 3
};

static const feed feeds_pace_rows[] = {
    {0, 38, 0, 0, false}
};
static const feed_run feeds_pace_runs[] = {{0, 38, 1}};
static const feeds feeds_pace = {
    feeds_pace_rows, 1, 1, feeds_pace_runs, 1
};

static const feed feeds_plan_limits_rows[] = {
    {0, 63, 0, 0, false},
    {1, 64, 0, 0, false},
    {2, 65, 0, 0, false},
    {3, 66, 0, 0, false},
    {4, 67, 0, 0, false},
    {5, 68, 0, 0, false},
    {6, 69, 0, 0, false},
    {7, 70, 0, 0, false},
    {8, 71, 0, 0, false},
    {9, 72, 0, 0, false},
    {10, 73, 0, 0, false},
    {11, 74, 0, 0, false},
    {12, 75, 0, 0, false},
    {13, 76, 0, 0, false},
    {14, 77, 0, 0, false},
    {15, 78, 0, 0, false},
    {16, 79, 0, 0, false},
    {17, 80, 0, 0, false}
};
static const feed_run feeds_plan_limits_runs[] = {{0, 63, 18}};
static const feeds feeds_plan_limits = {
    feeds_plan_limits_rows, 18, 18, feeds_plan_limits_runs, 1
};

static const feed feeds_feedforward_rows[] = {
    {0, 0, 0, 0, false},
    {1, 1, 0, 0, false},
    {2, 2, 0, 0, false},
    {3, 21, 0, 0, false},
    {4, 24, 0, 0, false},
    {5, 27, 0, 0, false},
    {6, 30, 0, 0, false},
    {7, 32, 0, 0, false},
    {8, 22, 0, 0, false},
    {9, 25, 0, 0, false},
    {10, 28, 0, 0, false},
    {11, 31, 0, 0, false},
    {12, 33, 0, 0, false},
    {13, 23, 0, 0, false},
    {14, 26, 0, 0, false},
    {15, 29, 0, 0, false},
    {18, 3, 0, 0, false},
    {19, 4, 0, 0, false},
    {20, 5, 0, 0, false}
};
static const feed_run feeds_feedforward_runs[] = {{0, 0, 3}, {3, 21, 1}, {4, 24, 1}, {5, 27, 1}, {6, 30, 1}, {7, 32, 1}, {8, 22, 1}, {9, 25, 1}, {10, 28, 1}, {11, 31, 1}, {12, 33, 1}, {13, 23, 1}, {14, 26, 1}, {15, 29, 1}, {18, 3, 3}};
static const feeds feeds_feedforward = {
    feeds_feedforward_rows, 19, 19, feeds_feedforward_runs, 15
};

static const feed feeds_command_rows[] = {
    {3, 278, 0, 0, false},
    {4, 279, 0, 0, false},
    {5, 280, 0, 0, false},
    {6, 281, 0, 0, false},
    {7, 282, 0, 0, false},
    {8, 283, 0, 0, false},
    {10, 284, 0, 0, false},
    {11, 289, 0, 0, false},
    {12, 290, 0, 0, false},
    {13, 291, 0, 0, false},
    {14, 285, 0, 0, false},
    {21, 292, 0, 0, false},
    {22, 293, 0, 0, false},
    {23, 294, 0, 0, false},
    {24, 295, 0, 0, false},
    {25, 296, 0, 0, false},
    {26, 297, 0, 0, false},
    {27, 298, 0, 0, false},
    {28, 299, 0, 0, false},
    {29, 300, 0, 0, false},
    {30, 301, 0, 0, false},
    {2, 27, 0, 1, true},
    {9, 28, 0, 0, true},
    {15, 29, 0, 0, true},
    {17, 31, 0, 0, true},
    {18, 32, 0, 0, true},
    {19, 33, 0, 0, true},
    {20, 34, 0, 0, true}
};
static const feed_run feeds_command_runs[] = {{3, 278, 6}, {10, 284, 1}, {11, 289, 3}, {14, 285, 1}, {21, 292, 10}};
static const feeds feeds_command = {
    feeds_command_rows, 28, 21, feeds_command_runs, 5
};

static const feed feeds_drive_brakes_rows[] = {
    {0, 286, 0, 0, false},
    {1, 287, 0, 0, false},
    {2, 288, 0, 0, false}
};
static const feed_run feeds_drive_brakes_runs[] = {{0, 286, 3}};
static const feeds feeds_drive_brakes = {
    feeds_drive_brakes_rows, 3, 3, feeds_drive_brakes_runs, 1
};
