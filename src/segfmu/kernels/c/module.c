/* Generated from the kernels in Python by `python -m segfmu.codegen`; never edited. */
#include "arguments.h"

static PyObject *call_evaluate(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "evaluate", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_times;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 int64_t in_derivative;
 Py_buffer *in_values;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_times = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_timing = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 3, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 4, 1, 'd', false)) != NULL
  && take_int(&call, 5, &in_derivative)
  && (in_values = take_array(&call, 6, 2, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_extent(&call, "values", 0, in_values->shape[0], in_times->shape[0])
  && has_extent(&call, "values", 1, in_values->shape[1], in_ends->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_ends->shape[0] + 1))
  && has_pieces(&call, "offsets", in_offsets->buf, (in_ends->shape[0] + 1), 1, in_timing->shape[0])) {
  segfmu_evaluate(
   (array_double_1d){in_times->buf, {in_times->shape[0]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}},
   in_derivative,
   (array_double_2d){in_values->buf, {in_values->shape[0], in_values->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_evaluate_orders(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "evaluate_orders", .values = values};
 PyObject *answer = NULL;
 double in_time;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 Py_buffer *in_values;
 (void)self;
 if (take_count(&call, count, 6)
  && take_float(&call, 0, &in_time)
  && (in_timing = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 3, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_values = take_array(&call, 5, 2, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 1)
  && has_at_least(&call, "values", 0, in_values->shape[0], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_extent(&call, "values", 1, in_values->shape[1], in_ends->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_ends->shape[0] + 1))
  && has_pieces(&call, "offsets", in_offsets->buf, (in_ends->shape[0] + 1), 1, in_timing->shape[0])) {
  segfmu_evaluate_orders(
   in_time,
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}},
   (array_double_2d){in_values->buf, {in_values->shape[0], in_values->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_state_scale(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "state_scale", .values = values};
 PyObject *answer = NULL;
 int64_t in_order;
 double in_duration;
 Py_buffer *in_limits;
 (void)self;
 if (take_count(&call, count, 3)
  && take_int(&call, 0, &in_order)
  && take_float(&call, 1, &in_duration)
  && (in_limits = take_array(&call, 2, 1, 'd', false)) != NULL
  && has_at_least(&call, "limits", 0, in_limits->shape[0], (in_order + 2))) {
  answer = PyFloat_FromDouble(segfmu_state_scale(
   in_order,
   in_duration,
   (array_double_1d){in_limits->buf, {in_limits->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_rope(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_rope", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_bounds;
 Py_buffer *in_work;
 Py_buffer *in_report;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && (in_bounds = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_work = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_report = take_array(&call, 5, 1, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "bounds", 0, in_bounds->shape[0], 3)
  && has_at_least(&call, "work", 0, in_work->shape[0], 52)
  && has_at_least(&call, "work", 1, in_work->shape[1], ((4 * in_coefficients->shape[1]) - 5))
  && has_at_least(&call, "report", 0, in_report->shape[0], 3)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_check_rope(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_bounds->buf, {in_bounds->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_1d){in_report->buf, {in_report->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_clearance_spans(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "clearance_spans", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 double in_gravity;
 Py_buffer *in_work;
 Py_buffer *in_spans;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && take_float(&call, 3, &in_gravity)
  && (in_work = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_spans = take_array(&call, 5, 3, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "work", 0, in_work->shape[0], 52)
  && has_at_least(&call, "work", 1, in_work->shape[1], ((4 * in_coefficients->shape[1]) - 5))
  && has_at_least(&call, "spans", 0, in_spans->shape[0], (in_timing->shape[0] + 1))
  && has_at_least(&call, "spans", 1, in_spans->shape[1], 10)
  && has_at_least(&call, "spans", 2, in_spans->shape[2], ((2 * in_coefficients->shape[1]) - 3))
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_clearance_spans(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   in_gravity,
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_3d){in_spans->buf, {in_spans->shape[0], in_spans->shape[1], in_spans->shape[2]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_contact_times(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "contact_times", .values = values};
 PyObject *answer = NULL;
 int64_t in_part;
 double in_until;
 int64_t in_count;
 Py_buffer *in_box;
 Py_buffer *in_spans;
 Py_buffer *in_stack;
 Py_buffer *in_times;
 Py_buffer *in_place;
 (void)self;
 if (take_count(&call, count, 8)
  && take_int(&call, 0, &in_part)
  && take_float(&call, 1, &in_until)
  && take_int(&call, 2, &in_count)
  && (in_box = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_spans = take_array(&call, 4, 3, 'd', false)) != NULL
  && (in_stack = take_array(&call, 5, 3, 'd', true)) != NULL
  && (in_times = take_array(&call, 6, 2, 'd', false)) != NULL
  && (in_place = take_array(&call, 7, 1, 'd', false)) != NULL
  && has_at_least(&call, "spans", 2, in_spans->shape[2], 1)
  && has_at_least(&call, "times", 0, in_times->shape[0], 1)
  && has_extent(&call, "stack", 2, in_stack->shape[2], in_spans->shape[2])
  && has_at_least(&call, "box", 0, in_box->shape[0], 13)
  && has_at_least(&call, "spans", 0, in_spans->shape[0], in_count)
  && has_at_least(&call, "spans", 1, in_spans->shape[1], 10)
  && has_at_least(&call, "stack", 0, in_stack->shape[0], 43)
  && has_at_least(&call, "stack", 1, in_stack->shape[1], 10)
  && has_at_least(&call, "times", 1, in_times->shape[1], 2)
  && has_at_least(&call, "place", 0, in_place->shape[0], 3)) {
  answer = PyLong_FromLongLong(segfmu_contact_times(
   in_part,
   in_until,
   in_count,
   (array_double_1d){in_box->buf, {in_box->shape[0]}},
   (array_double_3d){in_spans->buf, {in_spans->shape[0], in_spans->shape[1], in_spans->shape[2]}},
   (array_double_3d){in_stack->buf, {in_stack->shape[0], in_stack->shape[1], in_stack->shape[2]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}},
   (array_double_1d){in_place->buf, {in_place->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_path_excursion(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "path_excursion", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_led;
 Py_buffer *in_positions;
 Py_buffer *in_times;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_work;
 Py_buffer *in_excursion;
 (void)self;
 if (take_count(&call, count, 8)
  && (in_led = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_positions = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_times = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_timing = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 4, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 5, 1, 'l', false)) != NULL
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_excursion = take_array(&call, 7, 1, 'd', true)) != NULL
  && has_at_least(&call, "led", 0, in_led->shape[0], 1)
  && has_at_least(&call, "led", 1, in_led->shape[1], 1)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "positions", 0, in_positions->shape[0], in_led->shape[0])
  && has_extent(&call, "positions", 1, in_positions->shape[1], in_led->shape[1])
  && has_extent(&call, "times", 0, in_times->shape[0], in_led->shape[0])
  && has_extent(&call, "times", 1, in_times->shape[1], in_led->shape[1])
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_led->shape[1] + 1))
  && has_at_least(&call, "work", 0, in_work->shape[0], 52)
  && has_at_least(&call, "work", 1, in_work->shape[1], ((4 * in_coefficients->shape[1]) - 5))
  && has_at_least(&call, "excursion", 0, in_excursion->shape[0], 4)
  && has_pieces(&call, "offsets", in_offsets->buf, (in_led->shape[1] + 1), 1, in_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_path_excursion(
   (array_double_2d){in_led->buf, {in_led->shape[0], in_led->shape[1]}},
   (array_double_2d){in_positions->buf, {in_positions->shape[0], in_positions->shape[1]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_1d){in_excursion->buf, {in_excursion->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_leaves_range(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "leaves_range", .values = values};
 PyObject *answer = NULL;
 int64_t in_axis;
 double in_begin;
 double in_end;
 double in_low;
 double in_high;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_work;
 Py_buffer *in_excursion;
 (void)self;
 if (take_count(&call, count, 10)
  && take_int(&call, 0, &in_axis)
  && take_float(&call, 1, &in_begin)
  && take_float(&call, 2, &in_end)
  && take_float(&call, 3, &in_low)
  && take_float(&call, 4, &in_high)
  && (in_timing = take_array(&call, 5, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 6, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 7, 1, 'l', false)) != NULL
  && (in_work = take_array(&call, 8, 2, 'd', true)) != NULL
  && (in_excursion = take_array(&call, 9, 1, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_axis + 2))
  && has_at_least(&call, "work", 0, in_work->shape[0], 52)
  && has_at_least(&call, "work", 1, in_work->shape[1], ((4 * in_coefficients->shape[1]) - 5))
  && has_at_least(&call, "excursion", 0, in_excursion->shape[0], 4)
  && has_pieces(&call, "offsets", in_offsets->buf, (in_axis + 2), 1, in_timing->shape[0])) {
  answer = PyBool_FromLong(segfmu_leaves_range(
   in_axis,
   in_begin,
   in_end,
   in_low,
   in_high,
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_1d){in_excursion->buf, {in_excursion->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_path_ranges(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "path_ranges", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 double in_gravity;
 Py_buffer *in_work;
 Py_buffer *in_ranges;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && take_float(&call, 3, &in_gravity)
  && (in_work = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_ranges = take_array(&call, 5, 2, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_extent(&call, "work", 1, in_work->shape[1], in_coefficients->shape[1])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "work", 0, in_work->shape[0], 2)
  && has_at_least(&call, "ranges", 0, in_ranges->shape[0], 6)
  && has_at_least(&call, "ranges", 1, in_ranges->shape[1], 3)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  segfmu_path_ranges(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   in_gravity,
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_ranges->buf, {in_ranges->shape[0], in_ranges->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_first_contact(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "first_contact", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 double in_gravity;
 Py_buffer *in_boxes;
 Py_buffer *in_work;
 Py_buffer *in_stack;
 Py_buffer *in_ranges;
 bool in_lasting;
 Py_buffer *in_report;
 (void)self;
 if (take_count(&call, count, 10)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && take_float(&call, 3, &in_gravity)
  && (in_boxes = take_array(&call, 4, 2, 'd', false)) != NULL
  && (in_work = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_stack = take_array(&call, 6, 3, 'd', true)) != NULL
  && (in_ranges = take_array(&call, 7, 2, 'd', true)) != NULL
  && take_bool(&call, 8, &in_lasting)
  && (in_report = take_array(&call, 9, 1, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "boxes", 1, in_boxes->shape[1], 13)
  && has_at_least(&call, "work", 0, in_work->shape[0], 52)
  && has_at_least(&call, "work", 1, in_work->shape[1], ((4 * in_coefficients->shape[1]) - 5))
  && has_at_least(&call, "stack", 0, in_stack->shape[0], 43)
  && has_at_least(&call, "stack", 1, in_stack->shape[1], 10)
  && has_at_least(&call, "stack", 2, in_stack->shape[2], ((2 * in_coefficients->shape[1]) - 3))
  && has_at_least(&call, "ranges", 0, in_ranges->shape[0], 6)
  && has_at_least(&call, "ranges", 1, in_ranges->shape[1], 3)
  && has_at_least(&call, "report", 0, in_report->shape[0], 6)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_first_contact(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   in_gravity,
   (array_double_2d){in_boxes->buf, {in_boxes->shape[0], in_boxes->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_3d){in_stack->buf, {in_stack->shape[0], in_stack->shape[1], in_stack->shape[2]}},
   (array_double_2d){in_ranges->buf, {in_ranges->shape[0], in_ranges->shape[1]}},
   in_lasting,
   (array_double_1d){in_report->buf, {in_report->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_shrink_boxes(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "shrink_boxes", .values = values};
 PyObject *answer = NULL;
 double in_touch;
 Py_buffer *in_boxes;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_touch)
  && (in_boxes = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "boxes", 1, in_boxes->shape[1], 13)) {
  segfmu_shrink_boxes(
   in_touch,
   (array_double_2d){in_boxes->buf, {in_boxes->shape[0], in_boxes->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_box(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_box", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_space;
 Py_buffer *in_obstacle;
 Py_buffer *in_box;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_space = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_obstacle = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_box = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "space", 0, in_space->shape[0], 14)
  && has_at_least(&call, "obstacle", 0, in_obstacle->shape[0], 8)
  && has_at_least(&call, "box", 0, in_box->shape[0], 13)) {
  segfmu_write_box(
   (array_double_1d){in_space->buf, {in_space->shape[0]}},
   (array_double_1d){in_obstacle->buf, {in_obstacle->shape[0]}},
   (array_double_1d){in_box->buf, {in_box->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_space_contact(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "space_contact", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_space;
 Py_buffer *in_obstacles;
 Py_buffer *in_boxes;
 Py_buffer *in_work;
 Py_buffer *in_stack;
 Py_buffer *in_ranges;
 bool in_lasting;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && (in_space = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_obstacles = take_array(&call, 4, 2, 'd', false)) != NULL
  && (in_boxes = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_stack = take_array(&call, 7, 3, 'd', true)) != NULL
  && (in_ranges = take_array(&call, 8, 2, 'd', true)) != NULL
  && take_bool(&call, 9, &in_lasting)
  && (in_fault = take_array(&call, 10, 1, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "obstacles", 0, in_obstacles->shape[0], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "space", 0, in_space->shape[0], 14)
  && has_at_least(&call, "obstacles", 1, in_obstacles->shape[1], 8)
  && has_at_least(&call, "boxes", 0, in_boxes->shape[0], (in_obstacles->shape[0] + 6))
  && has_at_least(&call, "boxes", 1, in_boxes->shape[1], 13)
  && has_at_least(&call, "work", 0, in_work->shape[0], 52)
  && has_at_least(&call, "work", 1, in_work->shape[1], ((4 * in_coefficients->shape[1]) - 5))
  && has_at_least(&call, "stack", 0, in_stack->shape[0], 43)
  && has_at_least(&call, "stack", 1, in_stack->shape[1], 10)
  && has_at_least(&call, "stack", 2, in_stack->shape[2], ((2 * in_coefficients->shape[1]) - 3))
  && has_at_least(&call, "ranges", 0, in_ranges->shape[0], 6)
  && has_at_least(&call, "ranges", 1, in_ranges->shape[1], 3)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 10)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_space_contact(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_space->buf, {in_space->shape[0]}},
   (array_double_2d){in_obstacles->buf, {in_obstacles->shape[0], in_obstacles->shape[1]}},
   (array_double_2d){in_boxes->buf, {in_boxes->shape[0], in_boxes->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_3d){in_stack->buf, {in_stack->shape[0], in_stack->shape[1], in_stack->shape[2]}},
   (array_double_2d){in_ranges->buf, {in_ranges->shape[0], in_ranges->shape[1]}},
   in_lasting,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_crane_rhs(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "crane_rhs", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_generalized_force;
 Py_buffer *in_load_force;
 Py_buffer *in_masses;
 Py_buffer *in_derivative;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_generalized_force = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_load_force = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_masses = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_derivative = take_array(&call, 4, 1, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "generalized_force", 0, in_generalized_force->shape[0], 5)
  && has_at_least(&call, "load_force", 0, in_load_force->shape[0], 3)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 4)
  && has_at_least(&call, "derivative", 0, in_derivative->shape[0], 10)) {
  segfmu_crane_rhs(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_generalized_force->buf, {in_generalized_force->shape[0]}},
   (array_double_1d){in_load_force->buf, {in_load_force->shape[0]}},
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   (array_double_1d){in_derivative->buf, {in_derivative->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_crane_driven(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "crane_driven", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_carriage;
 Py_buffer *in_generalized_force;
 Py_buffer *in_load_force;
 Py_buffer *in_masses;
 Py_buffer *in_derivative;
 Py_buffer *in_force;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_carriage = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_generalized_force = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_load_force = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_masses = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_derivative = take_array(&call, 5, 1, 'd', true)) != NULL
  && (in_force = take_array(&call, 6, 1, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "carriage", 0, in_carriage->shape[0], 3)
  && has_at_least(&call, "generalized_force", 0, in_generalized_force->shape[0], 5)
  && has_at_least(&call, "load_force", 0, in_load_force->shape[0], 3)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 4)
  && has_at_least(&call, "derivative", 0, in_derivative->shape[0], 10)
  && has_at_least(&call, "force", 0, in_force->shape[0], 3)) {
  segfmu_crane_driven(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_carriage->buf, {in_carriage->shape[0]}},
   (array_double_1d){in_generalized_force->buf, {in_generalized_force->shape[0]}},
   (array_double_1d){in_load_force->buf, {in_load_force->shape[0]}},
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   (array_double_1d){in_derivative->buf, {in_derivative->shape[0]}},
   (array_double_1d){in_force->buf, {in_force->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_crane_flat_inverse(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "crane_flat_inverse", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_flat;
 Py_buffer *in_masses;
 Py_buffer *in_force;
 Py_buffer *in_state;
 Py_buffer *in_acceleration;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_flat = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_masses = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_force = take_array(&call, 2, 1, 'd', true)) != NULL
  && (in_state = take_array(&call, 3, 1, 'd', true)) != NULL
  && (in_acceleration = take_array(&call, 4, 1, 'd', true)) != NULL
  && has_at_least(&call, "flat", 0, in_flat->shape[0], 5)
  && has_at_least(&call, "flat", 1, in_flat->shape[1], 3)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 4)
  && has_at_least(&call, "force", 0, in_force->shape[0], 3)
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "acceleration", 0, in_acceleration->shape[0], 5)) {
  segfmu_crane_flat_inverse(
   (array_double_2d){in_flat->buf, {in_flat->shape[0], in_flat->shape[1]}},
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   (array_double_1d){in_force->buf, {in_force->shape[0]}},
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_acceleration->buf, {in_acceleration->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_crane_load(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "crane_load", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_load;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_load = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "load", 0, in_load->shape[0], 2)
  && has_at_least(&call, "load", 1, in_load->shape[1], 3)) {
  segfmu_crane_load(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_2d){in_load->buf, {in_load->shape[0], in_load->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_crane_energy(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "crane_energy", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_masses;
 Py_buffer *in_energy;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_masses = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_energy = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 4)
  && has_at_least(&call, "energy", 0, in_energy->shape[0], 2)) {
  segfmu_crane_energy(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   (array_double_1d){in_energy->buf, {in_energy->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_flat_derivatives(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "flat_derivatives", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_flat;
 int64_t in_order;
 Py_buffer *in_masses;
 Py_buffer *in_work;
 Py_buffer *in_found;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_flat = take_array(&call, 0, 2, 'd', false)) != NULL
  && take_int(&call, 1, &in_order)
  && (in_masses = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_work = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_found = take_array(&call, 4, 1, 'd', true)) != NULL
  && has_at_least(&call, "flat", 0, in_flat->shape[0], (in_order + 5))
  && has_at_least(&call, "flat", 1, in_flat->shape[1], 3)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 4)
  && has_at_least(&call, "work", 0, in_work->shape[0], 18)
  && has_at_least(&call, "work", 1, in_work->shape[1], (in_order + 3))
  && has_at_least(&call, "found", 0, in_found->shape[0], 18)) {
  segfmu_flat_derivatives(
   (array_double_2d){in_flat->buf, {in_flat->shape[0], in_flat->shape[1]}},
   in_order,
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_1d){in_found->buf, {in_found->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_hook_derivatives(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "hook_derivatives", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_flat;
 int64_t in_order;
 Py_buffer *in_masses;
 double in_hook_mass;
 double in_sling;
 Py_buffer *in_work;
 Py_buffer *in_found;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_flat = take_array(&call, 0, 2, 'd', false)) != NULL
  && take_int(&call, 1, &in_order)
  && (in_masses = take_array(&call, 2, 1, 'd', false)) != NULL
  && take_float(&call, 3, &in_hook_mass)
  && take_float(&call, 4, &in_sling)
  && (in_work = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_found = take_array(&call, 6, 1, 'd', true)) != NULL
  && has_at_least(&call, "flat", 0, in_flat->shape[0], (in_order + 7))
  && has_at_least(&call, "flat", 1, in_flat->shape[1], 3)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 4)
  && has_at_least(&call, "work", 0, in_work->shape[0], 23)
  && has_at_least(&call, "work", 1, in_work->shape[1], (in_order + 5))
  && has_at_least(&call, "found", 0, in_found->shape[0], 24)) {
  segfmu_hook_derivatives(
   (array_double_2d){in_flat->buf, {in_flat->shape[0], in_flat->shape[1]}},
   in_order,
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   in_hook_mass,
   in_sling,
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_1d){in_found->buf, {in_found->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_flat_orders(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "flat_orders", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_resistance;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_resistance = take_array(&call, 0, 1, 'd', false)) != NULL
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)) {
  answer = PyLong_FromLongLong(segfmu_flat_orders(
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_feedback_correction(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "feedback_correction", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_reference;
 Py_buffer *in_added;
 Py_buffer *in_gains;
 Py_buffer *in_correction;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_reference = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_added = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_gains = take_array(&call, 3, 3, 'd', false)) != NULL
  && (in_correction = take_array(&call, 4, 1, 'd', true)) != NULL
  && has_at_least(&call, "gains", 0, in_gains->shape[0], 1)
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "reference", 0, in_reference->shape[0], 10)
  && has_at_least(&call, "added", 0, in_added->shape[0], 3)
  && has_at_least(&call, "gains", 1, in_gains->shape[1], 4)
  && has_at_least(&call, "gains", 2, in_gains->shape[2], 11)
  && has_at_least(&call, "correction", 0, in_correction->shape[0], 3)) {
  segfmu_feedback_correction(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_reference->buf, {in_reference->shape[0]}},
   (array_double_1d){in_added->buf, {in_added->shape[0]}},
   (array_double_3d){in_gains->buf, {in_gains->shape[0], in_gains->shape[1], in_gains->shape[2]}},
   (array_double_1d){in_correction->buf, {in_correction->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_feedback_bandwidth(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "feedback_bandwidth", .values = values};
 PyObject *answer = NULL;
 double in_ratio;
 double in_length;
 double in_gravity;
 double in_delay;
 double in_largest;
 (void)self;
 if (take_count(&call, count, 5)
  && take_float(&call, 0, &in_ratio)
  && take_float(&call, 1, &in_length)
  && take_float(&call, 2, &in_gravity)
  && take_float(&call, 3, &in_delay)
  && take_float(&call, 4, &in_largest)) {
  answer = PyFloat_FromDouble(segfmu_feedback_bandwidth(
   in_ratio,
   in_length,
   in_gravity,
   in_delay,
   in_largest));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_feedback_gains(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "feedback_gains", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 double in_length;
 double in_bandwidth;
 double in_pendulum;
 double in_hoist_bandwidth;
 double in_damping;
 Py_buffer *in_gains;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_float(&call, 1, &in_length)
  && take_float(&call, 2, &in_bandwidth)
  && take_float(&call, 3, &in_pendulum)
  && take_float(&call, 4, &in_hoist_bandwidth)
  && take_float(&call, 5, &in_damping)
  && (in_gains = take_array(&call, 6, 2, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 25)
  && has_at_least(&call, "gains", 0, in_gains->shape[0], 4)
  && has_at_least(&call, "gains", 1, in_gains->shape[1], 11)) {
  segfmu_feedback_gains(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_length,
   in_bandwidth,
   in_pendulum,
   in_hoist_bandwidth,
   in_damping,
   (array_double_2d){in_gains->buf, {in_gains->shape[0], in_gains->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_observer_predict(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "observer_predict", .values = values};
 PyObject *answer = NULL;
 int64_t in_axis;
 double in_length;
 Py_buffer *in_table;
 double in_command;
 double in_correction;
 Py_buffer *in_estimate;
 Py_buffer *in_scratch;
 (void)self;
 if (take_count(&call, count, 7)
  && take_int(&call, 0, &in_axis)
  && take_float(&call, 1, &in_length)
  && (in_table = take_array(&call, 2, 3, 'd', false)) != NULL
  && take_float(&call, 3, &in_command)
  && take_float(&call, 4, &in_correction)
  && (in_estimate = take_array(&call, 5, 1, 'd', true)) != NULL
  && (in_scratch = take_array(&call, 6, 1, 'd', true)) != NULL
  && has_at_least(&call, "table", 0, in_table->shape[0], 1)
  && has_at_least(&call, "table", 1, in_table->shape[1], 19)
  && has_at_least(&call, "table", 2, in_table->shape[2], 10)
  && has_at_least(&call, "estimate", 0, in_estimate->shape[0], 6)
  && has_at_least(&call, "scratch", 0, in_scratch->shape[0], 8)) {
  segfmu_observer_predict(
   in_axis,
   in_length,
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}},
   in_command,
   in_correction,
   (array_double_1d){in_estimate->buf, {in_estimate->shape[0]}},
   (array_double_1d){in_scratch->buf, {in_scratch->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_observer_correct(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "observer_correct", .values = values};
 PyObject *answer = NULL;
 double in_length;
 Py_buffer *in_table;
 Py_buffer *in_measured;
 Py_buffer *in_reference;
 Py_buffer *in_estimate;
 (void)self;
 if (take_count(&call, count, 5)
  && take_float(&call, 0, &in_length)
  && (in_table = take_array(&call, 1, 3, 'd', false)) != NULL
  && (in_measured = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_reference = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_estimate = take_array(&call, 4, 2, 'd', true)) != NULL
  && has_at_least(&call, "table", 0, in_table->shape[0], 1)
  && has_at_least(&call, "table", 1, in_table->shape[1], 19)
  && has_at_least(&call, "table", 2, in_table->shape[2], 10)
  && has_at_least(&call, "measured", 0, in_measured->shape[0], 5)
  && has_at_least(&call, "reference", 0, in_reference->shape[0], 5)
  && has_at_least(&call, "estimate", 0, in_estimate->shape[0], 3)
  && has_at_least(&call, "estimate", 1, in_estimate->shape[1], 6)) {
  segfmu_observer_correct(
   in_length,
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}},
   (array_double_1d){in_measured->buf, {in_measured->shape[0]}},
   (array_double_1d){in_reference->buf, {in_reference->shape[0]}},
   (array_double_2d){in_estimate->buf, {in_estimate->shape[0], in_estimate->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_observer_design(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "observer_design", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 double in_sample_time;
 double in_length;
 Py_buffer *in_expected;
 Py_buffer *in_work;
 Py_buffer *in_table;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_float(&call, 1, &in_sample_time)
  && take_float(&call, 2, &in_length)
  && (in_expected = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_work = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_table = take_array(&call, 5, 2, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 25)
  && has_at_least(&call, "expected", 0, in_expected->shape[0], 5)
  && has_at_least(&call, "work", 0, in_work->shape[0], 72)
  && has_at_least(&call, "work", 1, in_work->shape[1], 16)
  && has_at_least(&call, "table", 0, in_table->shape[0], 19)
  && has_at_least(&call, "table", 1, in_table->shape[1], 10)) {
  segfmu_observer_design(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_sample_time,
   in_length,
   (array_double_1d){in_expected->buf, {in_expected->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_table->buf, {in_table->shape[0], in_table->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rope_range(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rope_range", .values = values};
 PyObject *answer = NULL;
 double in_length;
 double in_shortest;
 double in_longest;
 Py_buffer *in_found;
 (void)self;
 if (take_count(&call, count, 4)
  && take_float(&call, 0, &in_length)
  && take_float(&call, 1, &in_shortest)
  && take_float(&call, 2, &in_longest)
  && (in_found = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "found", 0, in_found->shape[0], 2)) {
  segfmu_rope_range(
   in_length,
   in_shortest,
   in_longest,
   (array_double_1d){in_found->buf, {in_found->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_table_lengths(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "table_lengths", .values = values};
 PyObject *answer = NULL;
 double in_shortest;
 double in_longest;
 int64_t in_rows;
 Py_buffer *in_lengths;
 (void)self;
 if (take_count(&call, count, 4)
  && take_float(&call, 0, &in_shortest)
  && take_float(&call, 1, &in_longest)
  && take_int(&call, 2, &in_rows)
  && (in_lengths = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "lengths", 0, in_lengths->shape[0], in_rows)) {
  answer = PyLong_FromLongLong(segfmu_table_lengths(
   in_shortest,
   in_longest,
   in_rows,
   (array_double_1d){in_lengths->buf, {in_lengths->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_flat_table(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "flat_table", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 Py_buffer *in_design;
 int64_t in_rows;
 Py_buffer *in_lengths;
 Py_buffer *in_table;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_design = take_array(&call, 1, 1, 'd', false)) != NULL
  && take_int(&call, 2, &in_rows)
  && (in_lengths = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_table = take_array(&call, 4, 3, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "design", 0, in_design->shape[0], 5)
  && has_at_least(&call, "lengths", 0, in_lengths->shape[0], in_rows)
  && has_at_least(&call, "table", 0, in_table->shape[0], in_rows)
  && has_at_least(&call, "table", 1, in_table->shape[1], 4)
  && has_at_least(&call, "table", 2, in_table->shape[2], 11)) {
  segfmu_flat_table(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   (array_double_1d){in_design->buf, {in_design->shape[0]}},
   in_rows,
   (array_double_1d){in_lengths->buf, {in_lengths->shape[0]}},
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_set_steps(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "set_steps", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_sensors;
 double in_longest;
 Py_buffer *in_uncertainty;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_sensors = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_float(&call, 1, &in_longest)
  && (in_uncertainty = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "sensors", 0, in_sensors->shape[0], 18)
  && has_at_least(&call, "uncertainty", 0, in_uncertainty->shape[0], 7)) {
  segfmu_set_steps(
   (array_double_1d){in_sensors->buf, {in_sensors->shape[0]}},
   in_longest,
   (array_double_1d){in_uncertainty->buf, {in_uncertainty->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_observer_table(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "observer_table", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 double in_sample_time;
 Py_buffer *in_uncertainty;
 int64_t in_rows;
 Py_buffer *in_lengths;
 Py_buffer *in_expected;
 Py_buffer *in_work;
 Py_buffer *in_table;
 (void)self;
 if (take_count(&call, count, 8)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_float(&call, 1, &in_sample_time)
  && (in_uncertainty = take_array(&call, 2, 1, 'd', false)) != NULL
  && take_int(&call, 3, &in_rows)
  && (in_lengths = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_expected = take_array(&call, 5, 1, 'd', true)) != NULL
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_table = take_array(&call, 7, 3, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 25)
  && has_at_least(&call, "uncertainty", 0, in_uncertainty->shape[0], 7)
  && has_at_least(&call, "lengths", 0, in_lengths->shape[0], in_rows)
  && has_at_least(&call, "expected", 0, in_expected->shape[0], 5)
  && has_at_least(&call, "work", 0, in_work->shape[0], 72)
  && has_at_least(&call, "work", 1, in_work->shape[1], 16)
  && has_at_least(&call, "table", 0, in_table->shape[0], in_rows)
  && has_at_least(&call, "table", 1, in_table->shape[1], 19)
  && has_at_least(&call, "table", 2, in_table->shape[2], 10)) {
  answer = PyBool_FromLong(segfmu_observer_table(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_sample_time,
   (array_double_1d){in_uncertainty->buf, {in_uncertainty->shape[0]}},
   in_rows,
   (array_double_1d){in_lengths->buf, {in_lengths->shape[0]}},
   (array_double_1d){in_expected->buf, {in_expected->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_nominal_payload(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "nominal_payload", .values = values};
 PyObject *answer = NULL;
 double in_expected;
 double in_payload;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_expected)
  && take_float(&call, 1, &in_payload)) {
  answer = PyFloat_FromDouble(segfmu_nominal_payload(
   in_expected,
   in_payload));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_signal_age(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "signal_age", .values = values};
 PyObject *answer = NULL;
 double in_dead_time;
 double in_sampling;
 double in_period;
 (void)self;
 if (take_count(&call, count, 3)
  && take_float(&call, 0, &in_dead_time)
  && take_float(&call, 1, &in_sampling)
  && take_float(&call, 2, &in_period)) {
  answer = PyFloat_FromDouble(segfmu_signal_age(
   in_dead_time,
   in_sampling,
   in_period));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_drive_bound(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "drive_bound", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 int64_t in_axis;
 double in_sign;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_int(&call, 1, &in_axis)
  && take_float(&call, 2, &in_sign)
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)) {
  answer = PyFloat_FromDouble(segfmu_drive_bound(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_axis,
   in_sign));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_set_walks(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "set_walks", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 Py_buffer *in_uncertainty;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_uncertainty = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "uncertainty", 0, in_uncertainty->shape[0], 7)) {
  segfmu_set_walks(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   (array_double_1d){in_uncertainty->buf, {in_uncertainty->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_set_drives(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "set_drives", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 Py_buffer *in_tracking;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_tracking = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "tracking", 0, in_tracking->shape[0], 41)) {
  segfmu_set_drives(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   (array_double_1d){in_tracking->buf, {in_tracking->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_set_tracking(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "set_tracking", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 Py_buffer *in_design;
 double in_longest;
 Py_buffer *in_tracking;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_design = take_array(&call, 1, 1, 'd', false)) != NULL
  && take_float(&call, 2, &in_longest)
  && (in_tracking = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "design", 0, in_design->shape[0], 10)
  && has_at_least(&call, "tracking", 0, in_tracking->shape[0], 41)) {
  segfmu_set_tracking(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   (array_double_1d){in_design->buf, {in_design->shape[0]}},
   in_longest,
   (array_double_1d){in_tracking->buf, {in_tracking->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_set_fading(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "set_fading", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_tracking;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_tracking = take_array(&call, 0, 1, 'd', true)) != NULL
  && has_at_least(&call, "tracking", 0, in_tracking->shape[0], 41)) {
  segfmu_set_fading(
   (array_double_1d){in_tracking->buf, {in_tracking->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_gains(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_gains", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 double in_period;
 int64_t in_predicted;
 Py_buffer *in_ends;
 Py_buffer *in_table;
 Py_buffer *in_work;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_float(&call, 1, &in_period)
  && take_int(&call, 2, &in_predicted)
  && (in_ends = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_table = take_array(&call, 4, 3, 'd', false)) != NULL
  && (in_work = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_fault = take_array(&call, 6, 1, 'd', true)) != NULL
  && has_at_least(&call, "table", 0, in_table->shape[0], 1)
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 2)
  && has_at_least(&call, "table", 1, in_table->shape[1], 4)
  && has_at_least(&call, "table", 2, in_table->shape[2], 11)
  && has_at_least(&call, "work", 0, in_work->shape[0], 130)
  && has_at_least(&call, "work", 1, in_work->shape[1], 48)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_gains(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_period,
   in_predicted,
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}},
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_track_setpoint(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "track_setpoint", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_parameters;
 Py_buffer *in_table;
 Py_buffer *in_gains;
 Py_buffer *in_tick;
 Py_buffer *in_memory;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_parameters = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_table = take_array(&call, 1, 3, 'd', false)) != NULL
  && (in_gains = take_array(&call, 2, 3, 'd', false)) != NULL
  && (in_tick = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_memory = take_array(&call, 4, 2, 'd', true)) != NULL
  && has_at_least(&call, "table", 0, in_table->shape[0], 1)
  && has_at_least(&call, "gains", 0, in_gains->shape[0], 1)
  && has_at_least(&call, "parameters", 0, in_parameters->shape[0], 41)
  && has_at_least(&call, "table", 1, in_table->shape[1], 19)
  && has_at_least(&call, "table", 2, in_table->shape[2], 10)
  && has_at_least(&call, "gains", 1, in_gains->shape[1], 4)
  && has_at_least(&call, "gains", 2, in_gains->shape[2], 11)
  && has_at_least(&call, "tick", 0, in_tick->shape[0], 4)
  && has_at_least(&call, "tick", 1, in_tick->shape[1], 10)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], 71)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 13)) {
  segfmu_track_setpoint(
   (array_double_1d){in_parameters->buf, {in_parameters->shape[0]}},
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}},
   (array_double_3d){in_gains->buf, {in_gains->shape[0], in_gains->shape[1], in_gains->shape[2]}},
   (array_double_2d){in_tick->buf, {in_tick->shape[0], in_tick->shape[1]}},
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_crane_load_partials(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "crane_load_partials", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_partials;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_partials = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "partials", 0, in_partials->shape[0], 6)
  && has_at_least(&call, "partials", 1, in_partials->shape[1], 10)) {
  segfmu_crane_load_partials(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_2d){in_partials->buf, {in_partials->shape[0], in_partials->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_crane_energy_partials(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "crane_energy_partials", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_masses;
 Py_buffer *in_partials;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_masses = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_partials = take_array(&call, 2, 2, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 4)
  && has_at_least(&call, "partials", 0, in_partials->shape[0], 2)
  && has_at_least(&call, "partials", 1, in_partials->shape[1], 10)) {
  segfmu_crane_energy_partials(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   (array_double_2d){in_partials->buf, {in_partials->shape[0], in_partials->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_same_break(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "same_break", .values = values};
 PyObject *answer = NULL;
 double in_time;
 (void)self;
 if (take_count(&call, count, 1)
  && take_float(&call, 0, &in_time)) {
  answer = PyFloat_FromDouble(segfmu_same_break(
   in_time));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_next_plan_event(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "next_plan_event", .values = values};
 PyObject *answer = NULL;
 double in_time;
 double in_start;
 Py_buffer *in_timing;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 Py_buffer *in_times;
 (void)self;
 if (take_count(&call, count, 6)
  && take_float(&call, 0, &in_time)
  && take_float(&call, 1, &in_start)
  && (in_timing = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 3, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_times = take_array(&call, 5, 2, 'd', false)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 1)
  && has_at_least(&call, "times", 0, in_times->shape[0], 1)
  && has_extent(&call, "times", 1, in_times->shape[1], in_ends->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_ends->shape[0] + 1))
  && has_pieces(&call, "offsets", in_offsets->buf, (in_ends->shape[0] + 1), 1, in_timing->shape[0])) {
  answer = PyFloat_FromDouble(segfmu_next_plan_event(
   in_time,
   in_start,
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_right_of_break(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "right_of_break", .values = values};
 PyObject *answer = NULL;
 double in_time;
 double in_start;
 Py_buffer *in_timing;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 (void)self;
 if (take_count(&call, count, 5)
  && take_float(&call, 0, &in_time)
  && take_float(&call, 1, &in_start)
  && (in_timing = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 3, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 4, 1, 'd', false)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 1)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_ends->shape[0] + 1))
  && has_pieces(&call, "offsets", in_offsets->buf, (in_ends->shape[0] + 1), 1, in_timing->shape[0])) {
  answer = PyFloat_FromDouble(segfmu_right_of_break(
   in_time,
   in_start,
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_resists(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "resists", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_resistance;
 int64_t in_axis;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_resistance = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_int(&call, 1, &in_axis)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)) {
  answer = PyBool_FromLong(segfmu_resists(
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   in_axis));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_planned_friction(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "planned_friction", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_resistance;
 int64_t in_axis;
 double in_time;
 double in_position;
 double in_velocity;
 Py_buffer *in_contacts;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_resistance = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_int(&call, 1, &in_axis)
  && take_float(&call, 2, &in_time)
  && take_float(&call, 3, &in_position)
  && take_float(&call, 4, &in_velocity)
  && (in_contacts = take_array(&call, 5, 2, 'd', false)) != NULL
  && has_at_least(&call, "contacts", 0, in_contacts->shape[0], 1)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "contacts", 1, in_contacts->shape[1], 7)) {
  answer = PyFloat_FromDouble(segfmu_planned_friction(
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   in_axis,
   in_time,
   in_position,
   in_velocity,
   (array_double_2d){in_contacts->buf, {in_contacts->shape[0], in_contacts->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_contact_history(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "contact_history", .values = values};
 PyObject *answer = NULL;
 int64_t in_axis;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 Py_buffer *in_resistance;
 Py_buffer *in_work;
 Py_buffer *in_contacts;
 (void)self;
 if (take_count(&call, count, 8)
  && take_int(&call, 0, &in_axis)
  && (in_timing = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 3, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_resistance = take_array(&call, 5, 1, 'd', false)) != NULL
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_contacts = take_array(&call, 7, 2, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "contacts", 0, in_contacts->shape[0], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 3)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "work", 0, in_work->shape[0], 35)
  && has_at_least(&call, "work", 1, in_work->shape[1], 24)
  && has_at_least(&call, "contacts", 1, in_contacts->shape[1], 7)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_contact_history(
   in_axis,
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}},
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_contacts->buf, {in_contacts->shape[0], in_contacts->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_next_contact_event(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "next_contact_event", .values = values};
 PyObject *answer = NULL;
 double in_time;
 double in_start;
 Py_buffer *in_contacts;
 (void)self;
 if (take_count(&call, count, 3)
  && take_float(&call, 0, &in_time)
  && take_float(&call, 1, &in_start)
  && (in_contacts = take_array(&call, 2, 2, 'd', false)) != NULL
  && has_at_least(&call, "contacts", 0, in_contacts->shape[0], 1)
  && has_at_least(&call, "contacts", 1, in_contacts->shape[1], 7)) {
  answer = PyFloat_FromDouble(segfmu_next_contact_event(
   in_time,
   in_start,
   (array_double_2d){in_contacts->buf, {in_contacts->shape[0], in_contacts->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_drive_demands(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "drive_demands", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_flat;
 Py_buffer *in_times;
 Py_buffer *in_resistance;
 Py_buffer *in_contacts;
 Py_buffer *in_work;
 Py_buffer *in_demands;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_flat = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_times = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_resistance = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_contacts = take_array(&call, 3, 3, 'd', false)) != NULL
  && (in_work = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_demands = take_array(&call, 5, 2, 'd', true)) != NULL
  && has_at_least(&call, "flat", 0, in_flat->shape[0], 1)
  && has_at_least(&call, "contacts", 1, in_contacts->shape[1], 1)
  && has_extent(&call, "times", 0, in_times->shape[0], in_flat->shape[0])
  && has_extent(&call, "demands", 0, in_demands->shape[0], in_flat->shape[0])
  && has_at_least(&call, "flat", 2, in_flat->shape[2], 3)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "contacts", 0, in_contacts->shape[0], 3)
  && has_at_least(&call, "contacts", 2, in_contacts->shape[2], 7)
  && has_at_least(&call, "work", 0, in_work->shape[0], 26)
  && has_at_least(&call, "work", 1, in_work->shape[1], 10)
  && has_at_least(&call, "demands", 1, in_demands->shape[1], 17)
  && has_at_least(&call, "flat", 1, in_flat->shape[1], segfmu_flat_orders((array_double_1d){in_resistance->buf, {in_resistance->shape[0]}}))) {
  segfmu_drive_demands(
   (array_double_3d){in_flat->buf, {in_flat->shape[0], in_flat->shape[1], in_flat->shape[2]}},
   (array_double_1d){in_times->buf, {in_times->shape[0]}},
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   (array_double_3d){in_contacts->buf, {in_contacts->shape[0], in_contacts->shape[1], in_contacts->shape[2]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_demands->buf, {in_demands->shape[0], in_demands->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_plant_failure(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "plant_failure", .values = values};
 PyObject *answer = NULL;
 int64_t in_status;
 double in_time;
 Py_buffer *in_state;
 Py_buffer *in_plant;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 5)
  && take_int(&call, 0, &in_status)
  && take_float(&call, 1, &in_time)
  && (in_state = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_plant = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_fault = take_array(&call, 4, 1, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 23)
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 6)) {
  answer = PyLong_FromLongLong(segfmu_plant_failure(
   in_status,
   in_time,
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_friction_derivative(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "friction_derivative", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_resistance;
 int64_t in_axis;
 double in_time;
 Py_buffer *in_motion;
 int64_t in_order;
 Py_buffer *in_contacts;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_resistance = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_int(&call, 1, &in_axis)
  && take_float(&call, 2, &in_time)
  && (in_motion = take_array(&call, 3, 1, 'd', false)) != NULL
  && take_int(&call, 4, &in_order)
  && (in_contacts = take_array(&call, 5, 2, 'd', false)) != NULL
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && has_at_least(&call, "contacts", 0, in_contacts->shape[0], 1)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "motion", 0, in_motion->shape[0], (in_order + 2))
  && has_at_least(&call, "contacts", 1, in_contacts->shape[1], 7)
  && has_at_least(&call, "work", 0, in_work->shape[0], 9)
  && has_at_least(&call, "work", 1, in_work->shape[1], (in_order + 1))) {
  answer = PyFloat_FromDouble(segfmu_friction_derivative(
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   in_axis,
   in_time,
   (array_double_1d){in_motion->buf, {in_motion->shape[0]}},
   in_order,
   (array_double_2d){in_contacts->buf, {in_contacts->shape[0], in_contacts->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_demand_peaks(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "demand_peaks", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 Py_buffer *in_resistance;
 Py_buffer *in_contacts;
 Py_buffer *in_work;
 Py_buffer *in_peaks;
 Py_buffer *in_times;
 (void)self;
 if (take_count(&call, count, 9)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_resistance = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_contacts = take_array(&call, 5, 3, 'd', false)) != NULL
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_peaks = take_array(&call, 7, 2, 'd', true)) != NULL
  && (in_times = take_array(&call, 8, 2, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "contacts", 1, in_contacts->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 3)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "contacts", 0, in_contacts->shape[0], 3)
  && has_at_least(&call, "contacts", 2, in_contacts->shape[2], 7)
  && has_at_least(&call, "work", 0, in_work->shape[0], 100)
  && has_at_least(&call, "work", 1, in_work->shape[1], 17)
  && has_at_least(&call, "peaks", 0, in_peaks->shape[0], 2)
  && has_at_least(&call, "peaks", 1, in_peaks->shape[1], 17)
  && has_at_least(&call, "times", 0, in_times->shape[0], 2)
  && has_at_least(&call, "times", 1, in_times->shape[1], 17)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  segfmu_demand_peaks(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}},
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   (array_double_3d){in_contacts->buf, {in_contacts->shape[0], in_contacts->shape[1], in_contacts->shape[2]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_peaks->buf, {in_peaks->shape[0], in_peaks->shape[1]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_demand_samples(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "demand_samples", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 Py_buffer *in_resistance;
 Py_buffer *in_contacts;
 Py_buffer *in_work;
 Py_buffer *in_peaks;
 Py_buffer *in_times;
 (void)self;
 if (take_count(&call, count, 9)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_resistance = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_contacts = take_array(&call, 5, 3, 'd', false)) != NULL
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_peaks = take_array(&call, 7, 2, 'd', true)) != NULL
  && (in_times = take_array(&call, 8, 2, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "contacts", 1, in_contacts->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 3)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "contacts", 0, in_contacts->shape[0], 3)
  && has_at_least(&call, "contacts", 2, in_contacts->shape[2], 7)
  && has_at_least(&call, "work", 0, in_work->shape[0], 100)
  && has_at_least(&call, "work", 1, in_work->shape[1], 17)
  && has_at_least(&call, "peaks", 0, in_peaks->shape[0], 2)
  && has_at_least(&call, "peaks", 1, in_peaks->shape[1], 17)
  && has_at_least(&call, "times", 0, in_times->shape[0], 2)
  && has_at_least(&call, "times", 1, in_times->shape[1], 17)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  segfmu_demand_samples(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}},
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   (array_double_3d){in_contacts->buf, {in_contacts->shape[0], in_contacts->shape[1], in_contacts->shape[2]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_peaks->buf, {in_peaks->shape[0], in_peaks->shape[1]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_seed_numbers(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "seed_numbers", .values = values};
 PyObject *answer = NULL;
 int64_t in_seed;
 Py_buffer *in_numbers;
 (void)self;
 if (take_count(&call, count, 2)
  && take_int(&call, 0, &in_seed)
  && (in_numbers = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "numbers", 0, in_numbers->shape[0], 2)) {
  segfmu_seed_numbers(
   in_seed,
   (array_double_1d){in_numbers->buf, {in_numbers->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_next_uniform(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "next_uniform", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_numbers;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_numbers = take_array(&call, 0, 1, 'd', true)) != NULL
  && has_at_least(&call, "numbers", 0, in_numbers->shape[0], 2)) {
  answer = PyFloat_FromDouble(segfmu_next_uniform(
   (array_double_1d){in_numbers->buf, {in_numbers->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_noise_components(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "noise_components", .values = values};
 PyObject *answer = NULL;
 double in_bandwidth;
 Py_buffer *in_deviation;
 Py_buffer *in_numbers;
 Py_buffer *in_components;
 (void)self;
 if (take_count(&call, count, 4)
  && take_float(&call, 0, &in_bandwidth)
  && (in_deviation = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_numbers = take_array(&call, 2, 1, 'd', true)) != NULL
  && (in_components = take_array(&call, 3, 2, 'd', true)) != NULL
  && has_at_least(&call, "deviation", 0, in_deviation->shape[0], 3)
  && has_at_least(&call, "numbers", 0, in_numbers->shape[0], 2)
  && has_at_least(&call, "components", 1, in_components->shape[1], 8)) {
  segfmu_noise_components(
   in_bandwidth,
   (array_double_1d){in_deviation->buf, {in_deviation->shape[0]}},
   (array_double_1d){in_numbers->buf, {in_numbers->shape[0]}},
   (array_double_2d){in_components->buf, {in_components->shape[0], in_components->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_turbulence_components(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "turbulence_components", .values = values};
 PyObject *answer = NULL;
 double in_speed;
 double in_length;
 double in_bandwidth;
 Py_buffer *in_deviation;
 Py_buffer *in_numbers;
 Py_buffer *in_components;
 (void)self;
 if (take_count(&call, count, 6)
  && take_float(&call, 0, &in_speed)
  && take_float(&call, 1, &in_length)
  && take_float(&call, 2, &in_bandwidth)
  && (in_deviation = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_numbers = take_array(&call, 4, 1, 'd', true)) != NULL
  && (in_components = take_array(&call, 5, 2, 'd', true)) != NULL
  && has_at_least(&call, "deviation", 0, in_deviation->shape[0], 3)
  && has_at_least(&call, "numbers", 0, in_numbers->shape[0], 2)
  && has_at_least(&call, "components", 1, in_components->shape[1], 8)) {
  segfmu_turbulence_components(
   in_speed,
   in_length,
   in_bandwidth,
   (array_double_1d){in_deviation->buf, {in_deviation->shape[0]}},
   (array_double_1d){in_numbers->buf, {in_numbers->shape[0]}},
   (array_double_2d){in_components->buf, {in_components->shape[0], in_components->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_plant_advance(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "plant_advance", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 Py_buffer *in_components;
 double in_time;
 Py_buffer *in_state;
 double in_duration;
 double in_tolerance;
 Py_buffer *in_work;
 Py_buffer *in_report;
 (void)self;
 if (take_count(&call, count, 8)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_components = take_array(&call, 1, 2, 'd', false)) != NULL
  && take_float(&call, 2, &in_time)
  && (in_state = take_array(&call, 3, 1, 'd', true)) != NULL
  && take_float(&call, 4, &in_duration)
  && take_float(&call, 5, &in_tolerance)
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_report = take_array(&call, 7, 1, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "components", 1, in_components->shape[1], 8)
  && has_at_least(&call, "state", 0, in_state->shape[0], 23)
  && has_at_least(&call, "work", 0, in_work->shape[0], 26)
  && has_at_least(&call, "work", 1, in_work->shape[1], 24)
  && has_at_least(&call, "report", 0, in_report->shape[0], 14)) {
  answer = PyLong_FromLongLong(segfmu_plant_advance(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   (array_double_2d){in_components->buf, {in_components->shape[0], in_components->shape[1]}},
   in_time,
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   in_duration,
   in_tolerance,
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_1d){in_report->buf, {in_report->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_bound_uses(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "bound_uses", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_peaks;
 Py_buffer *in_times;
 Py_buffer *in_bounds;
 Py_buffer *in_uses;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_peaks = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_times = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_bounds = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_uses = take_array(&call, 3, 1, 'd', true)) != NULL
  && (in_fault = take_array(&call, 4, 1, 'd', true)) != NULL
  && has_at_least(&call, "peaks", 0, in_peaks->shape[0], 2)
  && has_at_least(&call, "peaks", 1, in_peaks->shape[1], 17)
  && has_at_least(&call, "times", 0, in_times->shape[0], 2)
  && has_at_least(&call, "times", 1, in_times->shape[1], 17)
  && has_at_least(&call, "bounds", 0, in_bounds->shape[0], 29)
  && has_at_least(&call, "uses", 0, in_uses->shape[0], 34)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 7)) {
  answer = PyLong_FromLongLong(segfmu_bound_uses(
   (array_double_2d){in_peaks->buf, {in_peaks->shape[0], in_peaks->shape[1]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}},
   (array_double_1d){in_bounds->buf, {in_bounds->shape[0]}},
   (array_double_1d){in_uses->buf, {in_uses->shape[0]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_has_bounds(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "has_bounds", .values = values};
 PyObject *answer = NULL;
 int64_t in_first;
 int64_t in_last;
 Py_buffer *in_bounds;
 (void)self;
 if (take_count(&call, count, 3)
  && take_int(&call, 0, &in_first)
  && take_int(&call, 1, &in_last)
  && (in_bounds = take_array(&call, 2, 1, 'd', false)) != NULL
  && has_at_least(&call, "bounds", 0, in_bounds->shape[0], 29)) {
  answer = PyBool_FromLong(segfmu_has_bounds(
   in_first,
   in_last,
   (array_double_1d){in_bounds->buf, {in_bounds->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_paced_use(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "paced_use", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_uses;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_uses = take_array(&call, 0, 1, 'd', false)) != NULL
  && has_at_least(&call, "uses", 0, in_uses->shape[0], 34)) {
  answer = PyFloat_FromDouble(segfmu_paced_use(
   (array_double_1d){in_uses->buf, {in_uses->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_hook_design(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "hook_design", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 double in_sample_time;
 double in_length;
 Py_buffer *in_weights;
 Py_buffer *in_work;
 Py_buffer *in_table;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_float(&call, 1, &in_sample_time)
  && take_float(&call, 2, &in_length)
  && (in_weights = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_work = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_table = take_array(&call, 5, 2, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "weights", 0, in_weights->shape[0], 10)
  && has_at_least(&call, "work", 0, in_work->shape[0], 92)
  && has_at_least(&call, "work", 1, in_work->shape[1], 16)
  && has_at_least(&call, "table", 0, in_table->shape[0], 34)
  && has_at_least(&call, "table", 1, in_table->shape[1], 9)) {
  segfmu_hook_design(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_sample_time,
   in_length,
   (array_double_1d){in_weights->buf, {in_weights->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_table->buf, {in_table->shape[0], in_table->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_hook_correction(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "hook_correction", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_table;
 Py_buffer *in_limits;
 Py_buffer *in_measured;
 Py_buffer *in_reference;
 Py_buffer *in_feedforward;
 Py_buffer *in_estimates;
 Py_buffer *in_correction;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_table = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_limits = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_measured = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_reference = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_feedforward = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_estimates = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_correction = take_array(&call, 6, 1, 'd', true)) != NULL
  && has_at_least(&call, "table", 0, in_table->shape[0], 1)
  && has_at_least(&call, "table", 1, in_table->shape[1], 34)
  && has_at_least(&call, "table", 2, in_table->shape[2], 9)
  && has_at_least(&call, "limits", 0, in_limits->shape[0], 13)
  && has_at_least(&call, "measured", 0, in_measured->shape[0], 5)
  && has_at_least(&call, "reference", 0, in_reference->shape[0], 10)
  && has_at_least(&call, "feedforward", 0, in_feedforward->shape[0], 3)
  && has_at_least(&call, "estimates", 0, in_estimates->shape[0], 4)
  && has_at_least(&call, "estimates", 1, in_estimates->shape[1], 9)
  && has_at_least(&call, "correction", 0, in_correction->shape[0], 3)) {
  segfmu_hook_correction(
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}},
   (array_double_1d){in_limits->buf, {in_limits->shape[0]}},
   (array_double_1d){in_measured->buf, {in_measured->shape[0]}},
   (array_double_1d){in_reference->buf, {in_reference->shape[0]}},
   (array_double_1d){in_feedforward->buf, {in_feedforward->shape[0]}},
   (array_double_2d){in_estimates->buf, {in_estimates->shape[0], in_estimates->shape[1]}},
   (array_double_1d){in_correction->buf, {in_correction->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_hook_frequencies(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "hook_frequencies", .values = values};
 PyObject *answer = NULL;
 double in_rope;
 Py_buffer *in_masses;
 Py_buffer *in_found;
 (void)self;
 if (take_count(&call, count, 3)
  && take_float(&call, 0, &in_rope)
  && (in_masses = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_found = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 6)
  && has_at_least(&call, "found", 0, in_found->shape[0], 2)) {
  segfmu_hook_frequencies(
   in_rope,
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   (array_double_1d){in_found->buf, {in_found->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_hook_load_motion(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "hook_load_motion", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_tension;
 Py_buffer *in_masses;
 Py_buffer *in_work;
 Py_buffer *in_load;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_tension = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_masses = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_work = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_load = take_array(&call, 4, 2, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 14)
  && has_at_least(&call, "tension", 0, in_tension->shape[0], 2)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 6)
  && has_at_least(&call, "work", 0, in_work->shape[0], 5)
  && has_at_least(&call, "work", 1, in_work->shape[1], 3)
  && has_at_least(&call, "load", 0, in_load->shape[0], 4)
  && has_at_least(&call, "load", 1, in_load->shape[1], 3)) {
  segfmu_hook_load_motion(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_tension->buf, {in_tension->shape[0]}},
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_load->buf, {in_load->shape[0], in_load->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_hook_outputs(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "hook_outputs", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_memory;
 Py_buffer *in_outputs;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_memory = take_array(&call, 0, 2, 'd', true)) != NULL
  && (in_outputs = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "memory", 0, in_memory->shape[0], 44)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "outputs", 0, in_outputs->shape[0], 13)) {
  segfmu_hook_outputs(
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}},
   (array_double_1d){in_outputs->buf, {in_outputs->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_hook(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_hook", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 Py_buffer *in_masses;
 double in_hook_mass;
 double in_sling;
 Py_buffer *in_bounds;
 Py_buffer *in_polynomials;
 Py_buffer *in_work;
 Py_buffer *in_report;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_masses = take_array(&call, 4, 1, 'd', false)) != NULL
  && take_float(&call, 5, &in_hook_mass)
  && take_float(&call, 6, &in_sling)
  && (in_bounds = take_array(&call, 7, 1, 'd', false)) != NULL
  && (in_polynomials = take_array(&call, 8, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 9, 2, 'd', true)) != NULL
  && (in_report = take_array(&call, 10, 1, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 3)
  && has_at_least(&call, "masses", 0, in_masses->shape[0], 4)
  && has_at_least(&call, "bounds", 0, in_bounds->shape[0], 3)
  && has_at_least(&call, "polynomials", 0, in_polynomials->shape[0], 52)
  && has_at_least(&call, "polynomials", 1, in_polynomials->shape[1], ((4 * in_coefficients->shape[1]) - 5))
  && has_at_least(&call, "work", 0, in_work->shape[0], 34)
  && has_at_least(&call, "work", 1, in_work->shape[1], 4)
  && has_at_least(&call, "report", 0, in_report->shape[0], 3)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_check_hook(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_1d){in_ends->buf, {in_ends->shape[0]}},
   (array_double_1d){in_masses->buf, {in_masses->shape[0]}},
   in_hook_mass,
   in_sling,
   (array_double_1d){in_bounds->buf, {in_bounds->shape[0]}},
   (array_double_2d){in_polynomials->buf, {in_polynomials->shape[0], in_polynomials->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_1d){in_report->buf, {in_report->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_heading(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_heading", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_places;
 Py_buffer *in_heading;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_places = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_heading = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "places", 0, in_places->shape[0], 1)
  && has_at_least(&call, "places", 1, in_places->shape[1], 3)
  && has_at_least(&call, "heading", 0, in_heading->shape[0], 5)) {
  segfmu_write_heading(
   (array_double_2d){in_places->buf, {in_places->shape[0], in_places->shape[1]}},
   (array_double_1d){in_heading->buf, {in_heading->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_begin_pace(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "begin_pace", .values = values};
 PyObject *answer = NULL;
 double in_most;
 double in_full;
 Py_buffer *in_pace;
 (void)self;
 if (take_count(&call, count, 3)
  && take_float(&call, 0, &in_most)
  && take_float(&call, 1, &in_full)
  && (in_pace = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "pace", 0, in_pace->shape[0], 10)) {
  segfmu_begin_pace(
   in_most,
   in_full,
   (array_double_1d){in_pace->buf, {in_pace->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_next_pace(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "next_pace", .values = values};
 PyObject *answer = NULL;
 double in_use;
 Py_buffer *in_pace;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_use)
  && (in_pace = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "pace", 0, in_pace->shape[0], 10)) {
  answer = PyBool_FromLong(segfmu_next_pace(
   in_use,
   (array_double_1d){in_pace->buf, {in_pace->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_unite_waypoints(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "unite_waypoints", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_place;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_states = take_array(&call, 0, 3, 'd', true)) != NULL
  && (in_place = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_extent(&call, "place", 0, in_place->shape[0], in_states->shape[0])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)) {
  segfmu_unite_waypoints(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_1d){in_place->buf, {in_place->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_free(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_free", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_place;
 Py_buffer *in_dwells;
 Py_buffer *in_heading;
 Py_buffer *in_kinds;
 Py_buffer *in_led;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_states = take_array(&call, 0, 3, 'd', true)) != NULL
  && (in_place = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_dwells = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_heading = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_kinds = take_array(&call, 4, 1, 'd', true)) != NULL
  && (in_led = take_array(&call, 5, 2, 'd', true)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_extent(&call, "place", 0, in_place->shape[0], in_states->shape[0])
  && has_extent(&call, "dwells", 0, in_dwells->shape[0], in_states->shape[0])
  && has_extent(&call, "led", 0, in_led->shape[0], in_states->shape[0])
  && has_at_least(&call, "states", 1, in_states->shape[1], 3)
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "heading", 0, in_heading->shape[0], 5)
  && has_at_least(&call, "led", 1, in_led->shape[1], 3)
  && has_at_least(&call, "kinds", 0, in_kinds->shape[0], (18 + (6 * (((double *)in_place->buf)[(in_states->shape[0] - 1)] - 1))))) {
  segfmu_write_free(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_1d){in_place->buf, {in_place->shape[0]}},
   (array_double_1d){in_dwells->buf, {in_dwells->shape[0]}},
   (array_double_1d){in_heading->buf, {in_heading->shape[0]}},
   (array_double_1d){in_kinds->buf, {in_kinds->shape[0]}},
   (array_double_2d){in_led->buf, {in_led->shape[0], in_led->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_states(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_states", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_unknowns;
 Py_buffer *in_kinds;
 Py_buffer *in_table;
 Py_buffer *in_place;
 Py_buffer *in_heading;
 Py_buffer *in_states;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_unknowns = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_kinds = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_table = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_place = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_heading = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_states = take_array(&call, 5, 3, 'd', true)) != NULL
  && has_at_least(&call, "place", 0, in_place->shape[0], 1)
  && has_extent(&call, "states", 0, in_states->shape[0], in_place->shape[0])
  && has_at_least(&call, "table", 0, in_table->shape[0], 3)
  && has_at_least(&call, "table", 1, in_table->shape[1], 6)
  && has_at_least(&call, "heading", 0, in_heading->shape[0], 5)
  && has_at_least(&call, "states", 1, in_states->shape[1], 3)
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "unknowns", 0, in_unknowns->shape[0], (18 + (6 * (((double *)in_place->buf)[(in_place->shape[0] - 1)] - 1))))
  && has_at_least(&call, "kinds", 0, in_kinds->shape[0], (18 + (6 * (((double *)in_place->buf)[(in_place->shape[0] - 1)] - 1))))) {
  segfmu_write_states(
   (array_double_1d){in_unknowns->buf, {in_unknowns->shape[0]}},
   (array_double_1d){in_kinds->buf, {in_kinds->shape[0]}},
   (array_double_2d){in_table->buf, {in_table->shape[0], in_table->shape[1]}},
   (array_double_1d){in_place->buf, {in_place->shape[0]}},
   (array_double_1d){in_heading->buf, {in_heading->shape[0]}},
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_is_judged(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "is_judged", .values = values};
 PyObject *answer = NULL;
 double in_duration;
 Py_buffer *in_uses;
 Py_buffer *in_search;
 (void)self;
 if (take_count(&call, count, 3)
  && take_float(&call, 0, &in_duration)
  && (in_uses = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_search = take_array(&call, 2, 2, 'd', false)) != NULL
  && has_at_least(&call, "search", 1, in_search->shape[1], 1)
  && has_at_least(&call, "uses", 0, in_uses->shape[0], 34)
  && has_at_least(&call, "search", 0, in_search->shape[0], 17)) {
  answer = PyBool_FromLong(segfmu_is_judged(
   in_duration,
   (array_double_1d){in_uses->buf, {in_uses->shape[0]}},
   (array_double_2d){in_search->buf, {in_search->shape[0], in_search->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_cap_best(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "cap_best", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_axes;
 Py_buffer *in_search;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_axes = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_search = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "axes", 0, in_axes->shape[0], 3)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 23)
  && has_at_least(&call, "search", 0, in_search->shape[0], 17)
  && has_at_least(&call, "search", 1, in_search->shape[1], ((double *)in_search->buf)[0 * in_search->shape[1] + 1])) {
  segfmu_cap_best(
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_2d){in_search->buf, {in_search->shape[0], in_search->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_best(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_best", .values = values};
 PyObject *answer = NULL;
 double in_pace;
 Py_buffer *in_search;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_pace)
  && (in_search = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "search", 0, in_search->shape[0], 17)
  && has_at_least(&call, "search", 1, in_search->shape[1], ((double *)in_search->buf)[0 * in_search->shape[1] + 1])) {
  segfmu_write_best(
   in_pace,
   (array_double_2d){in_search->buf, {in_search->shape[0], in_search->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_keep_best(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "keep_best", .values = values};
 PyObject *answer = NULL;
 double in_pace;
 Py_buffer *in_search;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_pace)
  && (in_search = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "search", 0, in_search->shape[0], 17)
  && has_at_least(&call, "search", 1, in_search->shape[1], ((double *)in_search->buf)[0 * in_search->shape[1] + 1])) {
  segfmu_keep_best(
   in_pace,
   (array_double_2d){in_search->buf, {in_search->shape[0], in_search->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_begin_limits(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "begin_limits", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_starts;
 Py_buffer *in_kinds;
 Py_buffer *in_search;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_starts = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_kinds = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_search = take_array(&call, 2, 2, 'd', true)) != NULL
  && has_at_least(&call, "starts", 0, in_starts->shape[0], 1)
  && has_at_least(&call, "starts", 1, in_starts->shape[1], 1)
  && has_at_least(&call, "search", 1, in_search->shape[1], 1)
  && has_extent(&call, "kinds", 0, in_kinds->shape[0], in_starts->shape[1])
  && has_at_least(&call, "search", 0, in_search->shape[0], 17)) {
  segfmu_begin_limits(
   (array_double_2d){in_starts->buf, {in_starts->shape[0], in_starts->shape[1]}},
   (array_double_1d){in_kinds->buf, {in_kinds->shape[0]}},
   (array_double_2d){in_search->buf, {in_search->shape[0], in_search->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_next_limits(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "next_limits", .values = values};
 PyObject *answer = NULL;
 double in_duration;
 Py_buffer *in_uses;
 Py_buffer *in_starts;
 Py_buffer *in_search;
 Py_buffer *in_values;
 Py_buffer *in_slopes;
 Py_buffer *in_newton;
 (void)self;
 if (take_count(&call, count, 7)
  && take_float(&call, 0, &in_duration)
  && (in_uses = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_starts = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_search = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_values = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_slopes = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_newton = take_array(&call, 6, 2, 'd', true)) != NULL
  && has_at_least(&call, "starts", 0, in_starts->shape[0], 1)
  && has_at_least(&call, "search", 1, in_search->shape[1], 1)
  && has_at_least(&call, "uses", 0, in_uses->shape[0], 34)
  && has_at_least(&call, "search", 0, in_search->shape[0], 17)
  && has_at_least(&call, "values", 0, in_values->shape[0], 2)
  && has_at_least(&call, "values", 1, in_values->shape[1], 35)
  && has_at_least(&call, "slopes", 1, in_slopes->shape[1], 35)
  && has_at_least(&call, "starts", 1, in_starts->shape[1], ((double *)in_search->buf)[0 * in_search->shape[1] + 1])
  && has_at_least(&call, "slopes", 0, in_slopes->shape[0], ((double *)in_search->buf)[0 * in_search->shape[1] + 1])
  && has_at_least(&call, "newton", 0, in_newton->shape[0], (2 * ((double *)in_search->buf)[0 * in_search->shape[1] + 1]))
  && has_at_least(&call, "newton", 1, in_newton->shape[1], ((double *)in_search->buf)[0 * in_search->shape[1] + 1])) {
  answer = PyBool_FromLong(segfmu_next_limits(
   in_duration,
   (array_double_1d){in_uses->buf, {in_uses->shape[0]}},
   (array_double_2d){in_starts->buf, {in_starts->shape[0], in_starts->shape[1]}},
   (array_double_2d){in_search->buf, {in_search->shape[0], in_search->shape[1]}},
   (array_double_2d){in_values->buf, {in_values->shape[0], in_values->shape[1]}},
   (array_double_2d){in_slopes->buf, {in_slopes->shape[0], in_slopes->shape[1]}},
   (array_double_2d){in_newton->buf, {in_newton->shape[0], in_newton->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_axes(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_axes", .values = values};
 PyObject *answer = NULL;
 bool in_narrow;
 Py_buffer *in_positions;
 Py_buffer *in_velocities;
 Py_buffer *in_accelerations;
 Py_buffer *in_bounds;
 Py_buffer *in_caps;
 Py_buffer *in_resistance;
 Py_buffer *in_axes;
 (void)self;
 if (take_count(&call, count, 8)
  && take_bool(&call, 0, &in_narrow)
  && (in_positions = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_velocities = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_accelerations = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_bounds = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_caps = take_array(&call, 5, 2, 'd', false)) != NULL
  && (in_resistance = take_array(&call, 6, 1, 'd', false)) != NULL
  && (in_axes = take_array(&call, 7, 2, 'd', true)) != NULL
  && has_at_least(&call, "positions", 0, in_positions->shape[0], 1)
  && has_extent(&call, "velocities", 0, in_velocities->shape[0], in_positions->shape[0])
  && has_extent(&call, "accelerations", 0, in_accelerations->shape[0], in_positions->shape[0])
  && has_at_least(&call, "positions", 1, in_positions->shape[1], 3)
  && has_at_least(&call, "velocities", 1, in_velocities->shape[1], 3)
  && has_at_least(&call, "accelerations", 1, in_accelerations->shape[1], 3)
  && has_at_least(&call, "bounds", 0, in_bounds->shape[0], 29)
  && has_at_least(&call, "caps", 0, in_caps->shape[0], 3)
  && has_at_least(&call, "caps", 1, in_caps->shape[1], 6)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "axes", 0, in_axes->shape[0], 3)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 23)) {
  segfmu_write_axes(
   in_narrow,
   (array_double_2d){in_positions->buf, {in_positions->shape[0], in_positions->shape[1]}},
   (array_double_2d){in_velocities->buf, {in_velocities->shape[0], in_velocities->shape[1]}},
   (array_double_2d){in_accelerations->buf, {in_accelerations->shape[0], in_accelerations->shape[1]}},
   (array_double_1d){in_bounds->buf, {in_bounds->shape[0]}},
   (array_double_2d){in_caps->buf, {in_caps->shape[0], in_caps->shape[1]}},
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_narrow_bounds(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "narrow_bounds", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_bounds;
 Py_buffer *in_caps;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_bounds = take_array(&call, 0, 1, 'd', true)) != NULL
  && (in_caps = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "bounds", 0, in_bounds->shape[0], 29)
  && has_at_least(&call, "caps", 0, in_caps->shape[0], 3)
  && has_at_least(&call, "caps", 1, in_caps->shape[1], 6)) {
  segfmu_narrow_bounds(
   (array_double_1d){in_bounds->buf, {in_bounds->shape[0]}},
   (array_double_2d){in_caps->buf, {in_caps->shape[0], in_caps->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_kinds(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_kinds", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_axes;
 Py_buffer *in_kinds;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_axes = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_kinds = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "axes", 0, in_axes->shape[0], 3)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 23)
  && has_at_least(&call, "kinds", 0, in_kinds->shape[0], 18)) {
  segfmu_write_kinds(
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_1d){in_kinds->buf, {in_kinds->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_limits(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_limits", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_unknowns;
 Py_buffer *in_axes;
 Py_buffer *in_table;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_unknowns = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_axes = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_table = take_array(&call, 2, 2, 'd', true)) != NULL
  && has_at_least(&call, "unknowns", 0, in_unknowns->shape[0], 18)
  && has_at_least(&call, "axes", 0, in_axes->shape[0], 3)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 23)
  && has_at_least(&call, "table", 0, in_table->shape[0], 3)
  && has_at_least(&call, "table", 1, in_table->shape[1], 6)) {
  segfmu_write_limits(
   (array_double_1d){in_unknowns->buf, {in_unknowns->shape[0]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_2d){in_table->buf, {in_table->shape[0], in_table->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_shares(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_shares", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_peaks;
 Py_buffer *in_bounds;
 Py_buffer *in_axes;
 Py_buffer *in_uses;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_peaks = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_bounds = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_axes = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_uses = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "peaks", 0, in_peaks->shape[0], 2)
  && has_at_least(&call, "peaks", 1, in_peaks->shape[1], 17)
  && has_at_least(&call, "bounds", 0, in_bounds->shape[0], 29)
  && has_at_least(&call, "axes", 0, in_axes->shape[0], 3)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 23)
  && has_at_least(&call, "uses", 0, in_uses->shape[0], 34)) {
  segfmu_write_shares(
   (array_double_2d){in_peaks->buf, {in_peaks->shape[0], in_peaks->shape[1]}},
   (array_double_1d){in_bounds->buf, {in_bounds->shape[0]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_1d){in_uses->buf, {in_uses->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_starts(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_starts", .values = values};
 PyObject *answer = NULL;
 double in_rope;
 Py_buffer *in_bounds;
 Py_buffer *in_resistance;
 Py_buffer *in_axes;
 Py_buffer *in_starts;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 6)
  && take_float(&call, 0, &in_rope)
  && (in_bounds = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_resistance = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_axes = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_starts = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_fault = take_array(&call, 5, 1, 'd', true)) != NULL
  && has_at_least(&call, "bounds", 0, in_bounds->shape[0], 29)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "axes", 0, in_axes->shape[0], 3)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 23)
  && has_at_least(&call, "starts", 0, in_starts->shape[0], 16)
  && has_at_least(&call, "starts", 1, in_starts->shape[1], 18)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_write_starts(
   in_rope,
   (array_double_1d){in_bounds->buf, {in_bounds->shape[0]}},
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_2d){in_starts->buf, {in_starts->shape[0], in_starts->shape[1]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_write_passing(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "write_passing", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_positions;
 Py_buffer *in_kinds;
 Py_buffer *in_axes;
 Py_buffer *in_heading;
 Py_buffer *in_start;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_positions = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_kinds = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_axes = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_heading = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_start = take_array(&call, 4, 1, 'd', true)) != NULL
  && has_at_least(&call, "positions", 0, in_positions->shape[0], 1)
  && has_at_least(&call, "positions", 1, in_positions->shape[1], 3)
  && has_at_least(&call, "kinds", 0, in_kinds->shape[0], (18 + (6 * (in_positions->shape[0] - 2))))
  && has_at_least(&call, "axes", 0, in_axes->shape[0], 3)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 23)
  && has_at_least(&call, "heading", 0, in_heading->shape[0], 5)
  && has_at_least(&call, "start", 0, in_start->shape[0], (18 + (6 * (in_positions->shape[0] - 2))))) {
  segfmu_write_passing(
   (array_double_2d){in_positions->buf, {in_positions->shape[0], in_positions->shape[1]}},
   (array_double_1d){in_kinds->buf, {in_kinds->shape[0]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_1d){in_heading->buf, {in_heading->shape[0]}},
   (array_double_1d){in_start->buf, {in_start->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_range(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_range", .values = values};
 PyObject *answer = NULL;
 double in_value;
 double in_least;
 double in_most;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 4)
  && take_float(&call, 0, &in_value)
  && take_float(&call, 1, &in_least)
  && take_float(&call, 2, &in_most)
  && (in_fault = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 3)) {
  answer = PyLong_FromLongLong(segfmu_check_range(
   in_value,
   in_least,
   in_most,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_begin_time(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "begin_time", .values = values};
 PyObject *answer = NULL;
 double in_given;
 double in_start;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_given)
  && take_float(&call, 1, &in_start)) {
  answer = PyFloat_FromDouble(segfmu_begin_time(
   in_given,
   in_start));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_ramp_duration(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "ramp_duration", .values = values};
 PyObject *answer = NULL;
 double in_change;
 Py_buffer *in_axis;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_change)
  && (in_axis = take_array(&call, 1, 1, 'd', false)) != NULL
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)) {
  double result_0;
  double result_1;
  segfmu_ramp_duration(
   &result_0,
   &result_1,
   in_change,
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}});
  answer = Py_BuildValue("(dd)", result_0, result_1);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_ramp_pieces(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "ramp_pieces", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_axis;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_axis = take_array(&call, 0, 1, 'd', false)) != NULL
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)) {
  answer = PyLong_FromLongLong(segfmu_ramp_pieces(
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_expand_phases(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "expand_phases", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_phases;
 int64_t in_count;
 Py_buffer *in_axis;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 int64_t in_row;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_phases = take_array(&call, 0, 2, 'd', false)) != NULL
  && take_int(&call, 1, &in_count)
  && (in_axis = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_timing = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 4, 2, 'd', true)) != NULL
  && take_int(&call, 5, &in_row)
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && has_at_least(&call, "phases", 0, in_phases->shape[0], in_count)
  && has_at_least(&call, "phases", 1, in_phases->shape[1], 5)
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "work", 0, in_work->shape[0], 4)
  && has_at_least(&call, "work", 1, in_work->shape[1], 12)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], (in_row + (segfmu_ramp_pieces((array_double_1d){in_axis->buf, {in_axis->shape[0]}}) * in_count)))
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], (in_row + (segfmu_ramp_pieces((array_double_1d){in_axis->buf, {in_axis->shape[0]}}) * in_count)))
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], (2 * ((double *)in_axis->buf)[0]))) {
  answer = PyLong_FromLongLong(segfmu_expand_phases(
   (array_double_2d){in_phases->buf, {in_phases->shape[0], in_phases->shape[1]}},
   in_count,
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   in_row,
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_cut_plan(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "cut_plan", .values = values};
 PyObject *answer = NULL;
 double in_time;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_cut_timing;
 Py_buffer *in_cut_coefficients;
 Py_buffer *in_cut_offsets;
 (void)self;
 if (take_count(&call, count, 7)
  && take_float(&call, 0, &in_time)
  && (in_timing = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 3, 1, 'l', false)) != NULL
  && (in_cut_timing = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_cut_coefficients = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_cut_offsets = take_array(&call, 6, 1, 'l', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_extent(&call, "cut_coefficients", 1, in_cut_coefficients->shape[1], in_coefficients->shape[1])
  && has_extent(&call, "cut_offsets", 0, in_cut_offsets->shape[0], in_offsets->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "cut_timing", 0, in_cut_timing->shape[0], (in_timing->shape[0] + in_offsets->shape[0]))
  && has_at_least(&call, "cut_timing", 1, in_cut_timing->shape[1], 2)
  && has_at_least(&call, "cut_coefficients", 0, in_cut_coefficients->shape[0], (in_timing->shape[0] + in_offsets->shape[0]))
  && has_pieces(&call, "offsets", in_offsets->buf, in_offsets->shape[0], 1, in_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_cut_plan(
   in_time,
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_cut_timing->buf, {in_cut_timing->shape[0], in_cut_timing->shape[1]}},
   (array_double_2d){in_cut_coefficients->buf, {in_cut_coefficients->shape[0], in_cut_coefficients->shape[1]}},
   (array_int64_t_1d){in_cut_offsets->buf, {in_cut_offsets->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_meet_ends(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "meet_ends", .values = values};
 PyObject *answer = NULL;
 double in_clock;
 double in_dwell;
 Py_buffer *in_timing;
 Py_buffer *in_offsets;
 (void)self;
 if (take_count(&call, count, 4)
  && take_float(&call, 0, &in_clock)
  && take_float(&call, 1, &in_dwell)
  && (in_timing = take_array(&call, 2, 2, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 3, 1, 'l', false)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 1)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_pieces(&call, "offsets", in_offsets->buf, in_offsets->shape[0], 1, in_timing->shape[0])) {
  segfmu_meet_ends(
   in_clock,
   in_dwell,
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_anchor_plan(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "anchor_plan", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_ends;
 Py_buffer *in_limits;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_ends = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_limits = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_timing = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 4, 1, 'l', false)) != NULL
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 1)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_ends->shape[0])
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "ends", 1, in_ends->shape[1], 1)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], 1)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 4)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_ends->shape[0] + 1))
  && has_pieces(&call, "offsets", in_offsets->buf, (in_ends->shape[0] + 1), 1, in_timing->shape[0])) {
  segfmu_anchor_plan(
   (array_double_2d){in_ends->buf, {in_ends->shape[0], in_ends->shape[1]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_join_plans(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "join_plans", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_lead_timing;
 Py_buffer *in_lead_coefficients;
 Py_buffer *in_lead_offsets;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_joined_timing;
 Py_buffer *in_joined_coefficients;
 Py_buffer *in_joined_offsets;
 (void)self;
 if (take_count(&call, count, 9)
  && (in_lead_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_lead_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_lead_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && (in_timing = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 4, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 5, 1, 'l', false)) != NULL
  && (in_joined_timing = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_joined_coefficients = take_array(&call, 7, 2, 'd', true)) != NULL
  && (in_joined_offsets = take_array(&call, 8, 1, 'l', true)) != NULL
  && has_at_least(&call, "lead_timing", 0, in_lead_timing->shape[0], 1)
  && has_at_least(&call, "lead_coefficients", 1, in_lead_coefficients->shape[1], 1)
  && has_at_least(&call, "lead_offsets", 0, in_lead_offsets->shape[0], 1)
  && has_extent(&call, "lead_coefficients", 0, in_lead_coefficients->shape[0], in_lead_timing->shape[0])
  && has_extent(&call, "timing", 0, in_timing->shape[0], in_lead_timing->shape[0])
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_lead_timing->shape[0])
  && has_extent(&call, "coefficients", 1, in_coefficients->shape[1], in_lead_coefficients->shape[1])
  && has_extent(&call, "offsets", 0, in_offsets->shape[0], in_lead_offsets->shape[0])
  && has_extent(&call, "joined_coefficients", 1, in_joined_coefficients->shape[1], in_lead_coefficients->shape[1])
  && has_extent(&call, "joined_offsets", 0, in_joined_offsets->shape[0], in_lead_offsets->shape[0])
  && has_at_least(&call, "lead_timing", 1, in_lead_timing->shape[1], 2)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "joined_timing", 0, in_joined_timing->shape[0], (2 * in_lead_timing->shape[0]))
  && has_at_least(&call, "joined_timing", 1, in_joined_timing->shape[1], 2)
  && has_at_least(&call, "joined_coefficients", 0, in_joined_coefficients->shape[0], (2 * in_lead_timing->shape[0]))
  && has_pieces(&call, "lead_offsets", in_lead_offsets->buf, in_lead_offsets->shape[0], 0, in_lead_timing->shape[0])
  && has_pieces(&call, "offsets", in_offsets->buf, in_lead_offsets->shape[0], 1, in_lead_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_join_plans(
   (array_double_2d){in_lead_timing->buf, {in_lead_timing->shape[0], in_lead_timing->shape[1]}},
   (array_double_2d){in_lead_coefficients->buf, {in_lead_coefficients->shape[0], in_lead_coefficients->shape[1]}},
   (array_int64_t_1d){in_lead_offsets->buf, {in_lead_offsets->shape[0]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_joined_timing->buf, {in_joined_timing->shape[0], in_joined_timing->shape[1]}},
   (array_double_2d){in_joined_coefficients->buf, {in_joined_coefficients->shape[0], in_joined_coefficients->shape[1]}},
   (array_int64_t_1d){in_joined_offsets->buf, {in_joined_offsets->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_measure_phases(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "measure_phases", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_phases;
 int64_t in_count;
 double in_v;
 double in_within;
 Py_buffer *in_axis;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_phases = take_array(&call, 0, 2, 'd', false)) != NULL
  && take_int(&call, 1, &in_count)
  && take_float(&call, 2, &in_v)
  && take_float(&call, 3, &in_within)
  && (in_axis = take_array(&call, 4, 1, 'd', false)) != NULL
  && has_at_least(&call, "phases", 0, in_phases->shape[0], in_count)
  && has_at_least(&call, "phases", 1, in_phases->shape[1], 5)
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)) {
  double result_0;
  double result_1;
  double result_2;
  double result_3;
  double result_4;
  segfmu_measure_phases(
   &result_0,
   &result_1,
   &result_2,
   &result_3,
   &result_4,
   (array_double_2d){in_phases->buf, {in_phases->shape[0], in_phases->shape[1]}},
   in_count,
   in_v,
   in_within,
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}});
  answer = Py_BuildValue("(ddddd)", result_0, result_1, result_2, result_3, result_4);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_axis_limits(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "axis_limits", .values = values};
 PyObject *answer = NULL;
 int64_t in_smoothness;
 int64_t in_shape;
 Py_buffer *in_limits;
 Py_buffer *in_axis;
 (void)self;
 if (take_count(&call, count, 4)
  && take_int(&call, 0, &in_smoothness)
  && take_int(&call, 1, &in_shape)
  && (in_limits = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_axis = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "limits", 0, in_limits->shape[0], (in_smoothness + 1))
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)) {
  segfmu_axis_limits(
   in_smoothness,
   in_shape,
   (array_double_1d){in_limits->buf, {in_limits->shape[0]}},
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_ramp_parameters(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "ramp_parameters", .values = values};
 PyObject *answer = NULL;
 double in_share;
 Py_buffer *in_axis;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 3)
  && take_float(&call, 0, &in_share)
  && (in_axis = take_array(&call, 1, 1, 'd', true)) != NULL
  && (in_work = take_array(&call, 2, 2, 'd', true)) != NULL
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)
  && has_at_least(&call, "work", 0, in_work->shape[0], 2)
  && has_at_least(&call, "work", 1, in_work->shape[1], 12)) {
  answer = PyBool_FromLong(segfmu_ramp_parameters(
   in_share,
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_shortest_profile(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "shortest_profile", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_problem;
 Py_buffer *in_axis;
 Py_buffer *in_phases;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_problem = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_axis = take_array(&call, 1, 1, 'd', true)) != NULL
  && (in_phases = take_array(&call, 2, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 3, 2, 'd', true)) != NULL
  && has_at_least(&call, "problem", 0, in_problem->shape[0], 6)
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)
  && has_at_least(&call, "phases", 0, in_phases->shape[0], 33)
  && has_at_least(&call, "phases", 1, in_phases->shape[1], 5)
  && has_at_least(&call, "work", 0, in_work->shape[0], 408)
  && has_at_least(&call, "work", 1, in_work->shape[1], 50)) {
  answer = PyLong_FromLongLong(segfmu_shortest_profile(
   (array_double_1d){in_problem->buf, {in_problem->shape[0]}},
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}},
   (array_double_2d){in_phases->buf, {in_phases->shape[0], in_phases->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_find_brake(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "find_brake", .values = values};
 PyObject *answer = NULL;
 bool in_whole;
 Py_buffer *in_limits;
 Py_buffer *in_lead;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 (void)self;
 if (take_count(&call, count, 5)
  && take_bool(&call, 0, &in_whole)
  && (in_limits = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_lead = take_array(&call, 2, 2, 'd', true)) != NULL
  && (in_timing = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 4, 2, 'd', true)) != NULL
  && has_at_least(&call, "limits", 0, in_limits->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "lead", 0, in_lead->shape[0], 1312)
  && has_at_least(&call, "lead", 1, in_lead->shape[1], 50)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1200)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], 1200)) {
  answer = PyLong_FromLongLong(segfmu_find_brake(
   in_whole,
   (array_double_1d){in_limits->buf, {in_limits->shape[0]}},
   (array_double_2d){in_lead->buf, {in_lead->shape[0], in_lead->shape[1]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_plan_ends(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "plan_ends", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_ends;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && (in_ends = take_array(&call, 3, 2, 'd', true)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_at_least(&call, "ends", 0, in_ends->shape[0], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_ends->shape[0] + 1))
  && has_at_least(&call, "ends", 1, in_ends->shape[1], 4)
  && has_pieces(&call, "offsets", in_offsets->buf, (in_ends->shape[0] + 1), 1, in_timing->shape[0])) {
  segfmu_plan_ends(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_ends->buf, {in_ends->shape[0], in_ends->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_are_at_velocities(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "are_at_velocities", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_targets;
 Py_buffer *in_limits;
 Py_buffer *in_ends;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_targets = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_limits = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_ends = take_array(&call, 2, 2, 'd', false)) != NULL
  && has_at_least(&call, "targets", 0, in_targets->shape[0], 1)
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_targets->shape[0])
  && has_extent(&call, "ends", 0, in_ends->shape[0], in_targets->shape[0])
  && has_at_least(&call, "targets", 1, in_targets->shape[1], 2)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], 2)
  && has_at_least(&call, "ends", 1, in_ends->shape[1], 4)) {
  answer = PyBool_FromLong(segfmu_are_at_velocities(
   (array_double_2d){in_targets->buf, {in_targets->shape[0], in_targets->shape[1]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_ends->buf, {in_ends->shape[0], in_ends->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_find_leads(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "find_leads", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 Py_buffer *in_plan_offsets;
 Py_buffer *in_plan_timing;
 Py_buffer *in_plan_coefficients;
 Py_buffer *in_ends;
 Py_buffer *in_lead;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_states = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_limits = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_lower = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_plan_offsets = take_array(&call, 3, 1, 'l', false)) != NULL
  && (in_plan_timing = take_array(&call, 4, 2, 'd', false)) != NULL
  && (in_plan_coefficients = take_array(&call, 5, 2, 'd', false)) != NULL
  && (in_ends = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_lead = take_array(&call, 7, 2, 'd', true)) != NULL
  && (in_timing = take_array(&call, 8, 2, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 9, 2, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 10, 1, 'l', true)) != NULL
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_at_least(&call, "states", 2, in_states->shape[2], 1)
  && has_at_least(&call, "plan_timing", 0, in_plan_timing->shape[0], 1)
  && has_at_least(&call, "plan_coefficients", 1, in_plan_coefficients->shape[1], 1)
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_extent(&call, "limits", 1, in_limits->shape[1], in_states->shape[2])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_states->shape[1])
  && has_extent(&call, "plan_coefficients", 0, in_plan_coefficients->shape[0], in_plan_timing->shape[0])
  && has_extent(&call, "ends", 0, in_ends->shape[0], in_states->shape[1])
  && has_extent(&call, "coefficients", 1, in_coefficients->shape[1], in_plan_coefficients->shape[1])
  && has_at_least(&call, "states", 0, in_states->shape[0], 2)
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)
  && has_at_least(&call, "plan_offsets", 0, in_plan_offsets->shape[0], (in_states->shape[1] + 1))
  && has_at_least(&call, "plan_timing", 1, in_plan_timing->shape[1], 2)
  && has_at_least(&call, "ends", 1, in_ends->shape[1], 7)
  && has_at_least(&call, "lead", 0, in_lead->shape[0], 1312)
  && has_at_least(&call, "lead", 1, in_lead->shape[1], 50)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], ((in_plan_timing->shape[0] + (400 * in_states->shape[1])) + 1200))
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], ((in_plan_timing->shape[0] + (400 * in_states->shape[1])) + 1200))
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_states->shape[1] + 1))
  && has_pieces(&call, "plan_offsets", in_plan_offsets->buf, (in_states->shape[1] + 1), 0, in_plan_timing->shape[0])) {
  answer = PyLong_FromLongLong(segfmu_find_leads(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}},
   (array_int64_t_1d){in_plan_offsets->buf, {in_plan_offsets->shape[0]}},
   (array_double_2d){in_plan_timing->buf, {in_plan_timing->shape[0], in_plan_timing->shape[1]}},
   (array_double_2d){in_plan_coefficients->buf, {in_plan_coefficients->shape[0], in_plan_coefficients->shape[1]}},
   (array_double_2d){in_ends->buf, {in_ends->shape[0], in_ends->shape[1]}},
   (array_double_2d){in_lead->buf, {in_lead->shape[0], in_lead->shape[1]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_find_brakes(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "find_brakes", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_start;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 Py_buffer *in_brakes;
 Py_buffer *in_lead;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_start = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_limits = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_lower = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_brakes = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_lead = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_timing = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 6, 2, 'd', true)) != NULL
  && has_at_least(&call, "start", 0, in_start->shape[0], 1)
  && has_at_least(&call, "start", 1, in_start->shape[1], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_start->shape[0])
  && has_extent(&call, "limits", 1, in_limits->shape[1], in_start->shape[1])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_start->shape[0])
  && has_extent(&call, "brakes", 0, in_brakes->shape[0], in_start->shape[0])
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)
  && has_at_least(&call, "brakes", 1, in_brakes->shape[1], 27)
  && has_at_least(&call, "lead", 0, in_lead->shape[0], 1312)
  && has_at_least(&call, "lead", 1, in_lead->shape[1], 50)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1200)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], 1200)) {
  answer = PyBool_FromLong(segfmu_find_brakes(
   (array_double_2d){in_start->buf, {in_start->shape[0], in_start->shape[1]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}},
   (array_double_2d){in_brakes->buf, {in_brakes->shape[0], in_brakes->shape[1]}},
   (array_double_2d){in_lead->buf, {in_lead->shape[0], in_lead->shape[1]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_timed_profile(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "timed_profile", .values = values};
 PyObject *answer = NULL;
 double in_target;
 Py_buffer *in_axis;
 Py_buffer *in_cell;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 4)
  && take_float(&call, 0, &in_target)
  && (in_axis = take_array(&call, 1, 1, 'd', true)) != NULL
  && (in_cell = take_array(&call, 2, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 3, 2, 'd', false)) != NULL
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)
  && has_at_least(&call, "cell", 0, in_cell->shape[0], 69)
  && has_at_least(&call, "cell", 1, in_cell->shape[1], 7)
  && has_at_least(&call, "work", 0, in_work->shape[0], 408)
  && has_at_least(&call, "work", 1, in_work->shape[1], 50)) {
  answer = PyFloat_FromDouble(segfmu_timed_profile(
   in_target,
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}},
   (array_double_2d){in_cell->buf, {in_cell->shape[0], in_cell->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_plan_phases(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "plan_phases", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_dwells;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 Py_buffer *in_options;
 Py_buffer *in_axes;
 Py_buffer *in_cells;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 8)
  && (in_states = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_dwells = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_limits = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_lower = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_options = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_axes = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_cells = take_array(&call, 6, 3, 'd', true)) != NULL
  && (in_work = take_array(&call, 7, 2, 'd', true)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_extent(&call, "dwells", 0, in_dwells->shape[0], in_states->shape[0])
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_states->shape[1])
  && has_extent(&call, "axes", 0, in_axes->shape[0], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)
  && has_at_least(&call, "options", 0, in_options->shape[0], 5)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 50)
  && has_at_least(&call, "cells", 0, in_cells->shape[0], ((in_states->shape[0] - 1) * in_states->shape[1]))
  && has_at_least(&call, "cells", 1, in_cells->shape[1], 69)
  && has_at_least(&call, "cells", 2, in_cells->shape[2], 7)
  && has_at_least(&call, "work", 0, in_work->shape[0], 408)
  && has_at_least(&call, "work", 1, in_work->shape[1], 50)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], (((double *)in_options->buf)[0] + 1))) {
  answer = PyLong_FromLongLong(segfmu_plan_phases(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_1d){in_dwells->buf, {in_dwells->shape[0]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}},
   (array_double_1d){in_options->buf, {in_options->shape[0]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_3d){in_cells->buf, {in_cells->shape[0], in_cells->shape[1], in_cells->shape[2]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_spline_share(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "spline_share", .values = values};
 PyObject *answer = NULL;
 bool in_highest;
 double in_duration;
 Py_buffer *in_first;
 Py_buffer *in_last;
 Py_buffer *in_allowed;
 Py_buffer *in_axis;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 7)
  && take_bool(&call, 0, &in_highest)
  && take_float(&call, 1, &in_duration)
  && (in_first = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_last = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_allowed = take_array(&call, 4, 1, 'd', false)) != NULL
  && (in_axis = take_array(&call, 5, 1, 'd', false)) != NULL
  && (in_work = take_array(&call, 6, 2, 'd', true)) != NULL
  && has_at_least(&call, "first", 0, in_first->shape[0], 8)
  && has_at_least(&call, "last", 0, in_last->shape[0], 8)
  && has_at_least(&call, "allowed", 0, in_allowed->shape[0], 2)
  && has_at_least(&call, "axis", 0, in_axis->shape[0], 50)
  && has_at_least(&call, "work", 0, in_work->shape[0], 784)
  && has_at_least(&call, "work", 1, in_work->shape[1], 25)) {
  answer = PyFloat_FromDouble(segfmu_spline_share(
   in_highest,
   in_duration,
   (array_double_1d){in_first->buf, {in_first->shape[0]}},
   (array_double_1d){in_last->buf, {in_last->shape[0]}},
   (array_double_1d){in_allowed->buf, {in_allowed->shape[0]}},
   (array_double_1d){in_axis->buf, {in_axis->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_append_spline(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "append_spline", .values = values};
 PyObject *answer = NULL;
 double in_duration;
 Py_buffer *in_first;
 Py_buffer *in_last;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 int64_t in_row;
 Py_buffer *in_state;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 8)
  && take_float(&call, 0, &in_duration)
  && (in_first = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_last = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_timing = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 4, 2, 'd', true)) != NULL
  && take_int(&call, 5, &in_row)
  && (in_state = take_array(&call, 6, 1, 'd', true)) != NULL
  && (in_work = take_array(&call, 7, 2, 'd', true)) != NULL
  && has_at_least(&call, "first", 0, in_first->shape[0], 8)
  && has_at_least(&call, "last", 0, in_last->shape[0], 8)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], (in_row + 60))
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], (in_row + 60))
  && has_at_least(&call, "state", 0, in_state->shape[0], 9)
  && has_at_least(&call, "work", 0, in_work->shape[0], 784)
  && has_at_least(&call, "work", 1, in_work->shape[1], 25)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], ((2 * ((double *)in_work->buf)[0 * in_work->shape[1] + 0]) - 2))) {
  answer = PyLong_FromLongLong(segfmu_append_spline(
   in_duration,
   (array_double_1d){in_first->buf, {in_first->shape[0]}},
   (array_double_1d){in_last->buf, {in_last->shape[0]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   in_row,
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_count_pieces(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "count_pieces", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_axes;
 Py_buffer *in_cells;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_axes = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_cells = take_array(&call, 1, 3, 'd', false)) != NULL
  && has_at_least(&call, "axes", 0, in_axes->shape[0], 1)
  && has_at_least(&call, "cells", 0, in_cells->shape[0], 1)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 50)
  && has_at_least(&call, "cells", 1, in_cells->shape[1], 69)
  && has_at_least(&call, "cells", 2, in_cells->shape[2], 7)) {
  answer = PyLong_FromLongLong(segfmu_count_pieces(
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_3d){in_cells->buf, {in_cells->shape[0], in_cells->shape[1], in_cells->shape[2]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_judge_pieces(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "judge_pieces", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_times;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 Py_buffer *in_brakes;
 Py_buffer *in_lead;
 Py_buffer *in_spare_timing;
 Py_buffer *in_spare_coefficients;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_states = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_times = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_timing = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 4, 1, 'l', false)) != NULL
  && (in_limits = take_array(&call, 5, 2, 'd', false)) != NULL
  && (in_lower = take_array(&call, 6, 2, 'd', false)) != NULL
  && (in_brakes = take_array(&call, 7, 2, 'd', true)) != NULL
  && (in_lead = take_array(&call, 8, 2, 'd', true)) != NULL
  && (in_spare_timing = take_array(&call, 9, 2, 'd', true)) != NULL
  && (in_spare_coefficients = take_array(&call, 10, 2, 'd', true)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], 1)
  && has_extent(&call, "times", 1, in_times->shape[1], in_states->shape[1])
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_states->shape[1])
  && has_extent(&call, "brakes", 0, in_brakes->shape[0], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "times", 0, in_times->shape[0], (in_states->shape[0] + 1))
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], ((2 * in_limits->shape[1]) - 2))
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_states->shape[1] + 1))
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)
  && has_at_least(&call, "brakes", 1, in_brakes->shape[1], 27)
  && has_at_least(&call, "lead", 0, in_lead->shape[0], 1312)
  && has_at_least(&call, "lead", 1, in_lead->shape[1], 50)
  && has_at_least(&call, "spare_timing", 0, in_spare_timing->shape[0], 1200)
  && has_at_least(&call, "spare_timing", 1, in_spare_timing->shape[1], 2)
  && has_at_least(&call, "spare_coefficients", 0, in_spare_coefficients->shape[0], 1200)
  && has_at_least(&call, "spare_coefficients", 1, in_spare_coefficients->shape[1], ((2 * in_limits->shape[1]) - 2))
  && has_pieces(&call, "offsets", in_offsets->buf, (in_states->shape[1] + 1), 1, in_timing->shape[0])) {
  answer = PyBool_FromLong(segfmu_judge_pieces(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}},
   (array_double_2d){in_brakes->buf, {in_brakes->shape[0], in_brakes->shape[1]}},
   (array_double_2d){in_lead->buf, {in_lead->shape[0], in_lead->shape[1]}},
   (array_double_2d){in_spare_timing->buf, {in_spare_timing->shape[0], in_spare_timing->shape[1]}},
   (array_double_2d){in_spare_coefficients->buf, {in_spare_coefficients->shape[0], in_spare_coefficients->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_plan_onward(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "plan_onward", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_dwells;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 Py_buffer *in_axes;
 Py_buffer *in_cells;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_times;
 Py_buffer *in_lead;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_states = take_array(&call, 0, 3, 'd', true)) != NULL
  && (in_dwells = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_limits = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_lower = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_axes = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_cells = take_array(&call, 5, 3, 'd', true)) != NULL
  && (in_timing = take_array(&call, 6, 3, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 7, 3, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 8, 1, 'l', true)) != NULL
  && (in_times = take_array(&call, 9, 2, 'd', true)) != NULL
  && (in_lead = take_array(&call, 10, 2, 'd', true)) != NULL
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_at_least(&call, "dwells", 0, in_dwells->shape[0], 1)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], 1)
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_states->shape[1])
  && has_extent(&call, "times", 1, in_times->shape[1], in_states->shape[1])
  && has_at_least(&call, "states", 0, in_states->shape[0], (2 * in_dwells->shape[0]))
  && has_at_least(&call, "states", 2, in_states->shape[2], 7)
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)
  && has_at_least(&call, "axes", 0, in_axes->shape[0], (2 * in_states->shape[1]))
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 50)
  && has_at_least(&call, "cells", 0, in_cells->shape[0], ((in_dwells->shape[0] - 1) * in_states->shape[1]))
  && has_at_least(&call, "cells", 1, in_cells->shape[1], 69)
  && has_at_least(&call, "cells", 2, in_cells->shape[2], 7)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 4)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], ((400 * in_states->shape[1]) + 1200))
  && has_at_least(&call, "timing", 2, in_timing->shape[2], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], 4)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], ((400 * in_states->shape[1]) + 1200))
  && has_at_least(&call, "coefficients", 2, in_coefficients->shape[2], ((2 * in_limits->shape[1]) - 2))
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (4 * (in_states->shape[1] + 1)))
  && has_at_least(&call, "times", 0, in_times->shape[0], (in_dwells->shape[0] + 1))
  && has_at_least(&call, "lead", 0, in_lead->shape[0], 1312)
  && has_at_least(&call, "lead", 1, in_lead->shape[1], 50)) {
  answer = PyLong_FromLongLong(segfmu_plan_onward(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_1d){in_dwells->buf, {in_dwells->shape[0]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_3d){in_cells->buf, {in_cells->shape[0], in_cells->shape[1], in_cells->shape[2]}},
   (array_double_3d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1], in_timing->shape[2]}},
   (array_double_3d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1], in_coefficients->shape[2]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}},
   (array_double_2d){in_lead->buf, {in_lead->shape[0], in_lead->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_keeps_drives(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "keeps_drives", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_known;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_timing = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_coefficients = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_offsets = take_array(&call, 2, 1, 'l', false)) != NULL
  && (in_known = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_work = take_array(&call, 4, 2, 'd', false)) != NULL
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 1)
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 4)
  && has_at_least(&call, "known", 0, in_known->shape[0], 25)
  && has_at_least(&call, "known", 1, in_known->shape[1], 29)
  && has_at_least(&call, "work", 0, in_work->shape[0], 169)
  && has_at_least(&call, "work", 1, in_work->shape[1], 102)
  && has_pieces(&call, "offsets", in_offsets->buf, 4, 1, in_timing->shape[0])) {
  answer = PyBool_FromLong(segfmu_keeps_drives(
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_known->buf, {in_known->shape[0], in_known->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_foresee_emergency(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "foresee_emergency", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_operation;
 Py_buffer *in_known;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 6)
  && (in_operation = take_array(&call, 0, 2, 'd', true)) != NULL
  && (in_known = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_timing = take_array(&call, 2, 3, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 3, 3, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 4, 1, 'l', true)) != NULL
  && (in_work = take_array(&call, 5, 2, 'd', true)) != NULL
  && has_at_least(&call, "coefficients", 2, in_coefficients->shape[2], 1)
  && has_at_least(&call, "operation", 0, in_operation->shape[0], 38)
  && has_at_least(&call, "operation", 1, in_operation->shape[1], 102)
  && has_at_least(&call, "known", 0, in_known->shape[0], 25)
  && has_at_least(&call, "known", 1, in_known->shape[1], 29)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 6)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 3604)
  && has_at_least(&call, "timing", 2, in_timing->shape[2], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], 6)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 3604)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 24)
  && has_at_least(&call, "work", 0, in_work->shape[0], 169)
  && has_at_least(&call, "work", 1, in_work->shape[1], 102)) {
  answer = PyBool_FromLong(segfmu_foresee_emergency(
   (array_double_2d){in_operation->buf, {in_operation->shape[0], in_operation->shape[1]}},
   (array_double_2d){in_known->buf, {in_known->shape[0], in_known->shape[1]}},
   (array_double_3d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1], in_timing->shape[2]}},
   (array_double_3d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1], in_coefficients->shape[2]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_take_over_measured(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "take_over_measured", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_operation;
 Py_buffer *in_known;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_work;
 Py_buffer *in_stack;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_operation = take_array(&call, 0, 2, 'd', true)) != NULL
  && (in_known = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_timing = take_array(&call, 2, 3, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 3, 3, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 4, 1, 'l', true)) != NULL
  && (in_work = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_stack = take_array(&call, 6, 3, 'd', true)) != NULL
  && has_at_least(&call, "coefficients", 2, in_coefficients->shape[2], 1)
  && has_at_least(&call, "operation", 0, in_operation->shape[0], 38)
  && has_at_least(&call, "operation", 1, in_operation->shape[1], 102)
  && has_at_least(&call, "known", 0, in_known->shape[0], 25)
  && has_at_least(&call, "known", 1, in_known->shape[1], 29)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 6)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 3604)
  && has_at_least(&call, "timing", 2, in_timing->shape[2], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], 6)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 3604)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 24)
  && has_at_least(&call, "work", 0, in_work->shape[0], 169)
  && has_at_least(&call, "work", 1, in_work->shape[1], 102)
  && has_at_least(&call, "stack", 0, in_stack->shape[0], 43)
  && has_at_least(&call, "stack", 1, in_stack->shape[1], 10)
  && has_at_least(&call, "stack", 2, in_stack->shape[2], ((2 * in_coefficients->shape[2]) - 3))) {
  answer = PyLong_FromLongLong(segfmu_take_over_measured(
   (array_double_2d){in_operation->buf, {in_operation->shape[0], in_operation->shape[1]}},
   (array_double_2d){in_known->buf, {in_known->shape[0], in_known->shape[1]}},
   (array_double_3d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1], in_timing->shape[2]}},
   (array_double_3d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1], in_coefficients->shape[2]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_3d){in_stack->buf, {in_stack->shape[0], in_stack->shape[1], in_stack->shape[2]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_begin_operation(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "begin_operation", .values = values};
 PyObject *answer = NULL;
 double in_time;
 Py_buffer *in_operation;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_time)
  && (in_operation = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "operation", 0, in_operation->shape[0], 38)
  && has_at_least(&call, "operation", 1, in_operation->shape[1], 102)) {
  segfmu_begin_operation(
   in_time,
   (array_double_2d){in_operation->buf, {in_operation->shape[0], in_operation->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_operate(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "operate", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_operation;
 Py_buffer *in_limits;
 Py_buffer *in_known;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_states;
 Py_buffer *in_cells;
 Py_buffer *in_lead;
 Py_buffer *in_work;
 Py_buffer *in_stack;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_operation = take_array(&call, 0, 2, 'd', true)) != NULL
  && (in_limits = take_array(&call, 1, 3, 'd', true)) != NULL
  && (in_known = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_timing = take_array(&call, 3, 3, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 4, 3, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 5, 1, 'l', true)) != NULL
  && (in_states = take_array(&call, 6, 3, 'd', true)) != NULL
  && (in_cells = take_array(&call, 7, 3, 'd', true)) != NULL
  && (in_lead = take_array(&call, 8, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 9, 2, 'd', true)) != NULL
  && (in_stack = take_array(&call, 10, 3, 'd', true)) != NULL
  && has_at_least(&call, "limits", 2, in_limits->shape[2], 1)
  && has_extent(&call, "states", 2, in_states->shape[2], in_limits->shape[2])
  && has_at_least(&call, "operation", 0, in_operation->shape[0], 38)
  && has_at_least(&call, "operation", 1, in_operation->shape[1], 102)
  && has_at_least(&call, "limits", 0, in_limits->shape[0], 2)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], 3)
  && has_at_least(&call, "known", 0, in_known->shape[0], 25)
  && has_at_least(&call, "known", 1, in_known->shape[1], 29)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 6)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 3604)
  && has_at_least(&call, "timing", 2, in_timing->shape[2], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], 6)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], 3604)
  && has_at_least(&call, "coefficients", 2, in_coefficients->shape[2], ((2 * in_limits->shape[2]) - 2))
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], 24)
  && has_at_least(&call, "states", 0, in_states->shape[0], 2)
  && has_at_least(&call, "states", 1, in_states->shape[1], 3)
  && has_at_least(&call, "cells", 0, in_cells->shape[0], 3)
  && has_at_least(&call, "cells", 1, in_cells->shape[1], 69)
  && has_at_least(&call, "cells", 2, in_cells->shape[2], 7)
  && has_at_least(&call, "lead", 0, in_lead->shape[0], 1312)
  && has_at_least(&call, "lead", 1, in_lead->shape[1], 50)
  && has_at_least(&call, "work", 0, in_work->shape[0], 169)
  && has_at_least(&call, "work", 1, in_work->shape[1], 102)
  && has_at_least(&call, "stack", 0, in_stack->shape[0], 43)
  && has_at_least(&call, "stack", 1, in_stack->shape[1], 10)
  && has_at_least(&call, "stack", 2, in_stack->shape[2], ((4 * in_limits->shape[2]) - 7))) {
  answer = PyBool_FromLong(segfmu_operate(
   (array_double_2d){in_operation->buf, {in_operation->shape[0], in_operation->shape[1]}},
   (array_double_3d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1], in_limits->shape[2]}},
   (array_double_2d){in_known->buf, {in_known->shape[0], in_known->shape[1]}},
   (array_double_3d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1], in_timing->shape[2]}},
   (array_double_3d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1], in_coefficients->shape[2]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_3d){in_cells->buf, {in_cells->shape[0], in_cells->shape[1], in_cells->shape[2]}},
   (array_double_2d){in_lead->buf, {in_lead->shape[0], in_lead->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_3d){in_stack->buf, {in_stack->shape[0], in_stack->shape[1], in_stack->shape[2]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_ready(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_ready", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_compensation;
 Py_buffer *in_resistance;
 int64_t in_pieces;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_compensation = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_resistance = take_array(&call, 1, 1, 'd', false)) != NULL
  && take_int(&call, 2, &in_pieces)
  && (in_fault = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "compensation", 0, in_compensation->shape[0], 6)
  && has_at_least(&call, "resistance", 0, in_resistance->shape[0], 24)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 2)) {
  answer = PyLong_FromLongLong(segfmu_check_ready(
   (array_double_1d){in_compensation->buf, {in_compensation->shape[0]}},
   (array_double_1d){in_resistance->buf, {in_resistance->shape[0]}},
   in_pieces,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_next_operation(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "next_operation", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_operation;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_operation = take_array(&call, 0, 2, 'd', false)) != NULL
  && has_at_least(&call, "operation", 0, in_operation->shape[0], 38)
  && has_at_least(&call, "operation", 1, in_operation->shape[1], 102)) {
  answer = PyFloat_FromDouble(segfmu_next_operation(
   (array_double_2d){in_operation->buf, {in_operation->shape[0], in_operation->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_problem(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_problem", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_limits;
 Py_buffer *in_report;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_states = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_limits = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_report = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], 2)
  && has_at_least(&call, "report", 0, in_report->shape[0], 5)) {
  answer = PyLong_FromLongLong(segfmu_check_problem(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_1d){in_report->buf, {in_report->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_motion_scale(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "motion_scale", .values = values};
 PyObject *answer = NULL;
 int64_t in_order;
 Py_buffer *in_states;
 Py_buffer *in_limits;
 (void)self;
 if (take_count(&call, count, 3)
  && take_int(&call, 0, &in_order)
  && (in_states = take_array(&call, 1, 3, 'd', false)) != NULL
  && (in_limits = take_array(&call, 2, 2, 'd', false)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], 2)) {
  answer = PyFloat_FromDouble(segfmu_motion_scale(
   in_order,
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_settle_states(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "settle_states", .values = values};
 PyObject *answer = NULL;
 int64_t in_first;
 Py_buffer *in_states;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 (void)self;
 if (take_count(&call, count, 4)
  && take_int(&call, 0, &in_first)
  && (in_states = take_array(&call, 1, 3, 'd', true)) != NULL
  && (in_limits = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_lower = take_array(&call, 3, 2, 'd', false)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], 2)
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)) {
  answer = PyLong_FromLongLong(segfmu_settle_states(
   in_first,
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_settle_dwells(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "settle_dwells", .values = values};
 PyObject *answer = NULL;
 double in_sample_time;
 Py_buffer *in_dwells;
 (void)self;
 if (take_count(&call, count, 2)
  && take_float(&call, 0, &in_sample_time)
  && (in_dwells = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "dwells", 0, in_dwells->shape[0], 1)) {
  answer = PyLong_FromLongLong(segfmu_settle_dwells(
   in_sample_time,
   (array_double_1d){in_dwells->buf, {in_dwells->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_usual_room(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "usual_room", .values = values};
 PyObject *answer = NULL;
 (void)self;
 if (take_count(&call, count, 0)) {
  answer = PyFloat_FromDouble(segfmu_usual_room(
   ));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_begin_choice(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "begin_choice", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_dwells;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 Py_buffer *in_allowed;
 Py_buffer *in_choice;
 Py_buffer *in_place;
 Py_buffer *in_tools;
 Py_buffer *in_axes;
 Py_buffer *in_spots;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_states = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_dwells = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_limits = take_array(&call, 2, 2, 'd', true)) != NULL
  && (in_lower = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_allowed = take_array(&call, 4, 2, 'd', false)) != NULL
  && (in_choice = take_array(&call, 5, 3, 'd', true)) != NULL
  && (in_place = take_array(&call, 6, 1, 'd', true)) != NULL
  && (in_tools = take_array(&call, 7, 2, 'd', true)) != NULL
  && (in_axes = take_array(&call, 8, 2, 'd', true)) != NULL
  && (in_spots = take_array(&call, 9, 3, 'd', true)) != NULL
  && (in_work = take_array(&call, 10, 2, 'd', true)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_extent(&call, "dwells", 0, in_dwells->shape[0], in_states->shape[0])
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_states->shape[1])
  && has_extent(&call, "allowed", 0, in_allowed->shape[0], in_states->shape[1])
  && has_extent(&call, "choice", 1, in_choice->shape[1], in_states->shape[1])
  && has_extent(&call, "place", 0, in_place->shape[0], in_states->shape[0])
  && has_extent(&call, "axes", 0, in_axes->shape[0], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)
  && has_at_least(&call, "allowed", 1, in_allowed->shape[1], 2)
  && has_at_least(&call, "choice", 0, in_choice->shape[0], (5 * in_states->shape[0]))
  && has_at_least(&call, "choice", 2, in_choice->shape[2], 3)
  && has_at_least(&call, "tools", 0, in_tools->shape[0], 80)
  && has_at_least(&call, "tools", 1, in_tools->shape[1], 114)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 60)
  && has_at_least(&call, "spots", 0, in_spots->shape[0], (in_states->shape[0] * in_states->shape[1]))
  && has_at_least(&call, "spots", 1, in_spots->shape[1], 6)
  && has_at_least(&call, "spots", 2, in_spots->shape[2], 2)
  && has_at_least(&call, "work", 0, in_work->shape[0], 1246)
  && has_at_least(&call, "work", 1, in_work->shape[1], 50)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], (((double *)in_work->buf)[0 * in_work->shape[1] + 0] + 1))) {
  answer = PyBool_FromLong(segfmu_begin_choice(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_1d){in_dwells->buf, {in_dwells->shape[0]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}},
   (array_double_2d){in_allowed->buf, {in_allowed->shape[0], in_allowed->shape[1]}},
   (array_double_3d){in_choice->buf, {in_choice->shape[0], in_choice->shape[1], in_choice->shape[2]}},
   (array_double_1d){in_place->buf, {in_place->shape[0]}},
   (array_double_2d){in_tools->buf, {in_tools->shape[0], in_tools->shape[1]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_3d){in_spots->buf, {in_spots->shape[0], in_spots->shape[1], in_spots->shape[2]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_next_passage(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "next_passage", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_tools;
 Py_buffer *in_spots;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_tools = take_array(&call, 0, 2, 'd', true)) != NULL
  && (in_spots = take_array(&call, 1, 3, 'd', false)) != NULL
  && has_at_least(&call, "spots", 0, in_spots->shape[0], 1)
  && has_at_least(&call, "tools", 0, in_tools->shape[0], 80)
  && has_at_least(&call, "tools", 1, in_tools->shape[1], 114)
  && has_at_least(&call, "spots", 1, in_spots->shape[1], 6)
  && has_at_least(&call, "spots", 2, in_spots->shape[2], 2)) {
  answer = PyBool_FromLong(segfmu_next_passage(
   (array_double_2d){in_tools->buf, {in_tools->shape[0], in_tools->shape[1]}},
   (array_double_3d){in_spots->buf, {in_spots->shape[0], in_spots->shape[1], in_spots->shape[2]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_choose_passage(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "choose_passage", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_choice;
 Py_buffer *in_tools;
 Py_buffer *in_axes;
 Py_buffer *in_spots;
 Py_buffer *in_links;
 Py_buffer *in_spans;
 Py_buffer *in_band;
 Py_buffer *in_cells;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_choice = take_array(&call, 0, 3, 'd', true)) != NULL
  && (in_tools = take_array(&call, 1, 2, 'd', true)) != NULL
  && (in_axes = take_array(&call, 2, 2, 'd', true)) != NULL
  && (in_spots = take_array(&call, 3, 3, 'd', true)) != NULL
  && (in_links = take_array(&call, 4, 3, 'd', true)) != NULL
  && (in_spans = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_band = take_array(&call, 6, 2, 'd', false)) != NULL
  && (in_cells = take_array(&call, 7, 3, 'd', true)) != NULL
  && (in_timing = take_array(&call, 8, 2, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 9, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 10, 2, 'd', true)) != NULL
  && has_at_least(&call, "choice", 1, in_choice->shape[1], 1)
  && has_at_least(&call, "spans", 0, in_spans->shape[0], 1)
  && has_extent(&call, "axes", 0, in_axes->shape[0], in_choice->shape[1])
  && has_at_least(&call, "choice", 0, in_choice->shape[0], (5 * in_spans->shape[0]))
  && has_at_least(&call, "choice", 2, in_choice->shape[2], 3)
  && has_at_least(&call, "tools", 0, in_tools->shape[0], 80)
  && has_at_least(&call, "tools", 1, in_tools->shape[1], 114)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 60)
  && has_at_least(&call, "spots", 0, in_spots->shape[0], (in_spans->shape[0] * in_choice->shape[1]))
  && has_at_least(&call, "spots", 1, in_spots->shape[1], 6)
  && has_at_least(&call, "spots", 2, in_spots->shape[2], 2)
  && has_at_least(&call, "links", 0, in_links->shape[0], ((in_spans->shape[0] - 1) * in_choice->shape[1]))
  && has_at_least(&call, "links", 1, in_links->shape[1], 23)
  && has_at_least(&call, "links", 2, in_links->shape[2], 15)
  && has_at_least(&call, "spans", 1, in_spans->shape[1], 12)
  && has_at_least(&call, "band", 0, in_band->shape[0], ((2 * in_spans->shape[0]) * in_choice->shape[1]))
  && has_at_least(&call, "band", 1, in_band->shape[1], ((4 * in_choice->shape[1]) + 1))
  && has_at_least(&call, "cells", 0, in_cells->shape[0], ((in_spans->shape[0] - 1) * in_choice->shape[1]))
  && has_at_least(&call, "cells", 1, in_cells->shape[1], 69)
  && has_at_least(&call, "cells", 2, in_cells->shape[2], 7)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1620)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "coefficients", 0, in_coefficients->shape[0], 1620)
  && has_at_least(&call, "work", 0, in_work->shape[0], 1246)
  && has_at_least(&call, "work", 1, in_work->shape[1], 50)
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], (2 * ((double *)in_work->buf)[0 * in_work->shape[1] + 0]))) {
  segfmu_choose_passage(
   (array_double_3d){in_choice->buf, {in_choice->shape[0], in_choice->shape[1], in_choice->shape[2]}},
   (array_double_2d){in_tools->buf, {in_tools->shape[0], in_tools->shape[1]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_3d){in_spots->buf, {in_spots->shape[0], in_spots->shape[1], in_spots->shape[2]}},
   (array_double_3d){in_links->buf, {in_links->shape[0], in_links->shape[1], in_links->shape[2]}},
   (array_double_2d){in_spans->buf, {in_spans->shape[0], in_spans->shape[1]}},
   (array_double_2d){in_band->buf, {in_band->shape[0], in_band->shape[1]}},
   (array_double_3d){in_cells->buf, {in_cells->shape[0], in_cells->shape[1], in_cells->shape[2]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_end_choice(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "end_choice", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_place;
 Py_buffer *in_choice;
 Py_buffer *in_tools;
 Py_buffer *in_axes;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_states = take_array(&call, 0, 3, 'd', true)) != NULL
  && (in_place = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_choice = take_array(&call, 2, 3, 'd', true)) != NULL
  && (in_tools = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_axes = take_array(&call, 4, 2, 'd', false)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_extent(&call, "place", 0, in_place->shape[0], in_states->shape[0])
  && has_extent(&call, "choice", 1, in_choice->shape[1], in_states->shape[1])
  && has_extent(&call, "axes", 0, in_axes->shape[0], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "choice", 0, in_choice->shape[0], (5 * in_states->shape[0]))
  && has_at_least(&call, "choice", 2, in_choice->shape[2], 3)
  && has_at_least(&call, "tools", 0, in_tools->shape[0], 80)
  && has_at_least(&call, "tools", 1, in_tools->shape[1], 114)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 60)) {
  segfmu_end_choice(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_1d){in_place->buf, {in_place->shape[0]}},
   (array_double_3d){in_choice->buf, {in_choice->shape[0], in_choice->shape[1], in_choice->shape[2]}},
   (array_double_2d){in_tools->buf, {in_tools->shape[0], in_tools->shape[1]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_measure_state(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "measure_state", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_sensors;
 Py_buffer *in_numbers;
 Py_buffer *in_measured;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_sensors = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_numbers = take_array(&call, 2, 1, 'd', true)) != NULL
  && (in_measured = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 5)
  && has_at_least(&call, "sensors", 0, in_sensors->shape[0], 18)
  && has_at_least(&call, "numbers", 0, in_numbers->shape[0], 2)
  && has_at_least(&call, "measured", 0, in_measured->shape[0], 5)) {
  segfmu_measure_state(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_sensors->buf, {in_sensors->shape[0]}},
   (array_double_1d){in_numbers->buf, {in_numbers->shape[0]}},
   (array_double_1d){in_measured->buf, {in_measured->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_next_event(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_next_event", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_settings;
 Py_buffer *in_memory;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_settings = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_memory = take_array(&call, 1, 2, 'd', false)) != NULL
  && has_at_least(&call, "settings", 0, in_settings->shape[0], 4)
  && has_at_least(&call, "settings", 1, in_settings->shape[1], 80)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], 44)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)) {
  answer = PyFloat_FromDouble(segfmu_rig_next_event(
   (array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}},
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_switch_correction(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "switch_correction", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_settings;
 Py_buffer *in_memory;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_settings = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_memory = take_array(&call, 1, 2, 'd', true)) != NULL
  && has_at_least(&call, "settings", 0, in_settings->shape[0], 4)
  && has_at_least(&call, "settings", 1, in_settings->shape[1], 80)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], 44)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)) {
  segfmu_switch_correction(
   (array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}},
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_event(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_event", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_settings;
 Py_buffer *in_changes;
 Py_buffer *in_table;
 Py_buffer *in_gains;
 Py_buffer *in_tracker;
 Py_buffer *in_setpoints;
 double in_time;
 Py_buffer *in_memory;
 (void)self;
 if (take_count(&call, count, 8)
  && (in_settings = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_changes = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_table = take_array(&call, 2, 3, 'd', false)) != NULL
  && (in_gains = take_array(&call, 3, 3, 'd', false)) != NULL
  && (in_tracker = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_setpoints = take_array(&call, 5, 1, 'd', false)) != NULL
  && take_float(&call, 6, &in_time)
  && (in_memory = take_array(&call, 7, 2, 'd', true)) != NULL
  && has_at_least(&call, "table", 0, in_table->shape[0], 1)
  && has_at_least(&call, "gains", 0, in_gains->shape[0], 1)
  && has_at_least(&call, "settings", 0, in_settings->shape[0], 4)
  && has_at_least(&call, "settings", 1, in_settings->shape[1], 80)
  && has_at_least(&call, "changes", 1, in_changes->shape[1], 2)
  && has_at_least(&call, "table", 1, in_table->shape[1], 19)
  && has_at_least(&call, "table", 2, in_table->shape[2], 10)
  && has_at_least(&call, "gains", 1, in_gains->shape[1], 4)
  && has_at_least(&call, "gains", 2, in_gains->shape[2], 11)
  && has_at_least(&call, "tracker", 0, in_tracker->shape[0], 71)
  && has_at_least(&call, "tracker", 1, in_tracker->shape[1], 13)
  && has_at_least(&call, "setpoints", 0, in_setpoints->shape[0], 19)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], segfmu_rig_rows((array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}}))) {
  segfmu_rig_event(
   (array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}},
   (array_double_2d){in_changes->buf, {in_changes->shape[0], in_changes->shape[1]}},
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}},
   (array_double_3d){in_gains->buf, {in_gains->shape[0], in_gains->shape[1], in_gains->shape[2]}},
   (array_double_2d){in_tracker->buf, {in_tracker->shape[0], in_tracker->shape[1]}},
   (array_double_1d){in_setpoints->buf, {in_setpoints->shape[0]}},
   in_time,
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_signals(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_signals", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_settings;
 double in_time;
 Py_buffer *in_memory;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_settings = take_array(&call, 0, 2, 'd', false)) != NULL
  && take_float(&call, 1, &in_time)
  && (in_memory = take_array(&call, 2, 2, 'd', true)) != NULL
  && has_at_least(&call, "settings", 0, in_settings->shape[0], 4)
  && has_at_least(&call, "settings", 1, in_settings->shape[1], 80)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], segfmu_rig_rows((array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}}))) {
  segfmu_rig_signals(
   (array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}},
   in_time,
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_rates(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_rates", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_components;
 Py_buffer *in_setpoints;
 double in_time;
 Py_buffer *in_memory;
 Py_buffer *in_derivative;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_components = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_setpoints = take_array(&call, 1, 1, 'd', false)) != NULL
  && take_float(&call, 2, &in_time)
  && (in_memory = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_derivative = take_array(&call, 4, 1, 'd', true)) != NULL
  && has_at_least(&call, "components", 1, in_components->shape[1], 8)
  && has_at_least(&call, "setpoints", 0, in_setpoints->shape[0], 19)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], 44)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "derivative", 0, in_derivative->shape[0], 23)) {
  answer = PyLong_FromLongLong(segfmu_rig_rates(
   (array_double_2d){in_components->buf, {in_components->shape[0], in_components->shape[1]}},
   (array_double_1d){in_setpoints->buf, {in_setpoints->shape[0]}},
   in_time,
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}},
   (array_double_1d){in_derivative->buf, {in_derivative->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_rows(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_rows", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_settings;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_settings = take_array(&call, 0, 2, 'd', false)) != NULL
  && has_at_least(&call, "settings", 0, in_settings->shape[0], 4)
  && has_at_least(&call, "settings", 1, in_settings->shape[1], 80)) {
  answer = PyLong_FromLongLong(segfmu_rig_rows(
   (array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_start(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_start", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_settings;
 Py_buffer *in_components;
 Py_buffer *in_changes;
 Py_buffer *in_state;
 Py_buffer *in_setpoints;
 double in_start;
 Py_buffer *in_memory;
 (void)self;
 if (take_count(&call, count, 7)
  && (in_settings = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_components = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_changes = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_state = take_array(&call, 3, 1, 'd', false)) != NULL
  && (in_setpoints = take_array(&call, 4, 1, 'd', false)) != NULL
  && take_float(&call, 5, &in_start)
  && (in_memory = take_array(&call, 6, 2, 'd', true)) != NULL
  && has_at_least(&call, "settings", 0, in_settings->shape[0], 4)
  && has_at_least(&call, "settings", 1, in_settings->shape[1], 80)
  && has_at_least(&call, "components", 1, in_components->shape[1], 8)
  && has_at_least(&call, "changes", 1, in_changes->shape[1], 2)
  && has_at_least(&call, "state", 0, in_state->shape[0], 23)
  && has_at_least(&call, "setpoints", 0, in_setpoints->shape[0], 19)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], segfmu_rig_rows((array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}}))) {
  segfmu_rig_start(
   (array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}},
   (array_double_2d){in_components->buf, {in_components->shape[0], in_components->shape[1]}},
   (array_double_2d){in_changes->buf, {in_changes->shape[0], in_changes->shape[1]}},
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_setpoints->buf, {in_setpoints->shape[0]}},
   in_start,
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_step(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_step", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_settings;
 Py_buffer *in_components;
 Py_buffer *in_changes;
 Py_buffer *in_table;
 Py_buffer *in_gains;
 Py_buffer *in_tracker;
 Py_buffer *in_setpoints;
 double in_duration;
 Py_buffer *in_memory;
 (void)self;
 if (take_count(&call, count, 9)
  && (in_settings = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_components = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_changes = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_table = take_array(&call, 3, 3, 'd', false)) != NULL
  && (in_gains = take_array(&call, 4, 3, 'd', false)) != NULL
  && (in_tracker = take_array(&call, 5, 2, 'd', true)) != NULL
  && (in_setpoints = take_array(&call, 6, 1, 'd', false)) != NULL
  && take_float(&call, 7, &in_duration)
  && (in_memory = take_array(&call, 8, 2, 'd', true)) != NULL
  && has_at_least(&call, "table", 0, in_table->shape[0], 1)
  && has_at_least(&call, "gains", 0, in_gains->shape[0], 1)
  && has_at_least(&call, "settings", 0, in_settings->shape[0], 4)
  && has_at_least(&call, "settings", 1, in_settings->shape[1], 80)
  && has_at_least(&call, "components", 1, in_components->shape[1], 8)
  && has_at_least(&call, "changes", 1, in_changes->shape[1], 2)
  && has_at_least(&call, "table", 1, in_table->shape[1], 19)
  && has_at_least(&call, "table", 2, in_table->shape[2], 10)
  && has_at_least(&call, "gains", 1, in_gains->shape[1], 4)
  && has_at_least(&call, "gains", 2, in_gains->shape[2], 11)
  && has_at_least(&call, "tracker", 0, in_tracker->shape[0], 71)
  && has_at_least(&call, "tracker", 1, in_tracker->shape[1], 13)
  && has_at_least(&call, "setpoints", 0, in_setpoints->shape[0], 19)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], segfmu_rig_rows((array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}}))) {
  answer = PyLong_FromLongLong(segfmu_rig_step(
   (array_double_2d){in_settings->buf, {in_settings->shape[0], in_settings->shape[1]}},
   (array_double_2d){in_components->buf, {in_components->shape[0], in_components->shape[1]}},
   (array_double_2d){in_changes->buf, {in_changes->shape[0], in_changes->shape[1]}},
   (array_double_3d){in_table->buf, {in_table->shape[0], in_table->shape[1], in_table->shape[2]}},
   (array_double_3d){in_gains->buf, {in_gains->shape[0], in_gains->shape[1], in_gains->shape[2]}},
   (array_double_2d){in_tracker->buf, {in_tracker->shape[0], in_tracker->shape[1]}},
   (array_double_1d){in_setpoints->buf, {in_setpoints->shape[0]}},
   in_duration,
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_balance(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_balance", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_memory;
 Py_buffer *in_balance;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_memory = take_array(&call, 0, 2, 'd', true)) != NULL
  && (in_balance = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "memory", 0, in_memory->shape[0], 44)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "balance", 0, in_balance->shape[0], 7)) {
  segfmu_rig_balance(
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}},
   (array_double_1d){in_balance->buf, {in_balance->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_imbalance(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_imbalance", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_balance;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_balance = take_array(&call, 0, 1, 'd', false)) != NULL
  && has_at_least(&call, "balance", 0, in_balance->shape[0], 7)) {
  answer = PyFloat_FromDouble(segfmu_rig_imbalance(
   (array_double_1d){in_balance->buf, {in_balance->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_outputs(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_outputs", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_target;
 Py_buffer *in_memory;
 Py_buffer *in_balance;
 Py_buffer *in_outputs;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_target = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_memory = take_array(&call, 1, 2, 'd', true)) != NULL
  && (in_balance = take_array(&call, 2, 1, 'd', true)) != NULL
  && (in_outputs = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "target", 0, in_target->shape[0], 3)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], 44)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "balance", 0, in_balance->shape[0], 7)
  && has_at_least(&call, "outputs", 0, in_outputs->shape[0], 51)) {
  segfmu_rig_outputs(
   (array_double_1d){in_target->buf, {in_target->shape[0]}},
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}},
   (array_double_1d){in_balance->buf, {in_balance->shape[0]}},
   (array_double_1d){in_outputs->buf, {in_outputs->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_tracking_estimates(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "tracking_estimates", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_parameters;
 Py_buffer *in_tracker;
 Py_buffer *in_estimates;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_parameters = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_tracker = take_array(&call, 1, 2, 'd', false)) != NULL
  && (in_estimates = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "parameters", 0, in_parameters->shape[0], 41)
  && has_at_least(&call, "tracker", 0, in_tracker->shape[0], 71)
  && has_at_least(&call, "tracker", 1, in_tracker->shape[1], 13)
  && has_at_least(&call, "estimates", 0, in_estimates->shape[0], 7)) {
  segfmu_tracking_estimates(
   (array_double_1d){in_parameters->buf, {in_parameters->shape[0]}},
   (array_double_2d){in_tracker->buf, {in_tracker->shape[0], in_tracker->shape[1]}},
   (array_double_1d){in_estimates->buf, {in_estimates->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_rig_partials(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "rig_partials", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_components;
 double in_time;
 Py_buffer *in_memory;
 Py_buffer *in_work;
 Py_buffer *in_partials;
 (void)self;
 if (take_count(&call, count, 5)
  && (in_components = take_array(&call, 0, 2, 'd', false)) != NULL
  && take_float(&call, 1, &in_time)
  && (in_memory = take_array(&call, 2, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 3, 2, 'd', true)) != NULL
  && (in_partials = take_array(&call, 4, 2, 'd', true)) != NULL
  && has_at_least(&call, "components", 1, in_components->shape[1], 8)
  && has_at_least(&call, "memory", 0, in_memory->shape[0], 44)
  && has_at_least(&call, "memory", 1, in_memory->shape[1], 80)
  && has_at_least(&call, "work", 0, in_work->shape[0], 6)
  && has_at_least(&call, "work", 1, in_work->shape[1], 18)
  && has_at_least(&call, "partials", 0, in_partials->shape[0], 15)
  && has_at_least(&call, "partials", 1, in_partials->shape[1], 20)) {
  answer = PyBool_FromLong(segfmu_rig_partials(
   (array_double_2d){in_components->buf, {in_components->shape[0], in_components->shape[1]}},
   in_time,
   (array_double_2d){in_memory->buf, {in_memory->shape[0], in_memory->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}},
   (array_double_2d){in_partials->buf, {in_partials->shape[0], in_partials->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_travel(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_travel", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_least;
 Py_buffer *in_greatest;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_least = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_greatest = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_fault = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "least", 0, in_least->shape[0], 3)
  && has_at_least(&call, "greatest", 0, in_greatest->shape[0], 3)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_travel(
   (array_double_1d){in_least->buf, {in_least->shape[0]}},
   (array_double_1d){in_greatest->buf, {in_greatest->shape[0]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_lags(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_lags", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 int64_t in_exchange;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_int(&call, 1, &in_exchange)
  && (in_fault = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_lags(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_exchange,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_friction(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_friction", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_static;
 Py_buffer *in_coulomb;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_static = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_coulomb = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_fault = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "static", 0, in_static->shape[0], 3)
  && has_at_least(&call, "coulomb", 0, in_coulomb->shape[0], 3)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_friction(
   (array_double_1d){in_static->buf, {in_static->shape[0]}},
   (array_double_1d){in_coulomb->buf, {in_coulomb->shape[0]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_wind_speed(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "wind_speed", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_speed;
 (void)self;
 if (take_count(&call, count, 1)
  && (in_speed = take_array(&call, 0, 1, 'd', false)) != NULL
  && has_at_least(&call, "speed", 0, in_speed->shape[0], 3)) {
  answer = PyFloat_FromDouble(segfmu_wind_speed(
   (array_double_1d){in_speed->buf, {in_speed->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_turbulence(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_turbulence", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_speed;
 Py_buffer *in_deviation;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_speed = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_deviation = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_fault = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "speed", 0, in_speed->shape[0], 3)
  && has_at_least(&call, "deviation", 0, in_deviation->shape[0], 3)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_turbulence(
   (array_double_1d){in_speed->buf, {in_speed->shape[0]}},
   (array_double_1d){in_deviation->buf, {in_deviation->shape[0]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_changes(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_changes", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_changes;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_changes = take_array(&call, 0, 2, 'd', false)) != NULL
  && (in_fault = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "changes", 1, in_changes->shape[1], 2)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_changes(
   (array_double_2d){in_changes->buf, {in_changes->shape[0], in_changes->shape[1]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_slack(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_slack", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 int64_t in_exchange;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_int(&call, 1, &in_exchange)
  && (in_fault = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_slack(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_exchange,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_delays(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_delays", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_plant;
 double in_period;
 int64_t in_exchange;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_plant = take_array(&call, 0, 1, 'd', false)) != NULL
  && take_float(&call, 1, &in_period)
  && take_int(&call, 2, &in_exchange)
  && (in_fault = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "plant", 0, in_plant->shape[0], 80)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_delays(
   (array_double_1d){in_plant->buf, {in_plant->shape[0]}},
   in_period,
   in_exchange,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_sensors(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_sensors", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_sensors;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_sensors = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_fault = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "sensors", 0, in_sensors->shape[0], 18)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_sensors(
   (array_double_1d){in_sensors->buf, {in_sensors->shape[0]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_rope_bounds(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_rope_bounds", .values = values};
 PyObject *answer = NULL;
 double in_length;
 double in_shortest;
 double in_longest;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 4)
  && take_float(&call, 0, &in_length)
  && take_float(&call, 1, &in_shortest)
  && take_float(&call, 2, &in_longest)
  && (in_fault = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_rope_bounds(
   in_length,
   in_shortest,
   in_longest,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_lengths(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_lengths", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_lengths;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 2)
  && (in_lengths = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_fault = take_array(&call, 1, 1, 'd', true)) != NULL
  && has_at_least(&call, "lengths", 0, in_lengths->shape[0], 2)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_lengths(
   (array_double_1d){in_lengths->buf, {in_lengths->shape[0]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_start_state(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "start_state", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_own;
 Py_buffer *in_held;
 Py_buffer *in_reference;
 Py_buffer *in_state;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_own = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_held = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_reference = take_array(&call, 2, 1, 'd', false)) != NULL
  && (in_state = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "own", 0, in_own->shape[0], 10)
  && has_at_least(&call, "held", 0, in_held->shape[0], 10)
  && has_at_least(&call, "reference", 0, in_reference->shape[0], 10)
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)) {
  segfmu_start_state(
   (array_double_1d){in_own->buf, {in_own->shape[0]}},
   (array_double_1d){in_held->buf, {in_held->shape[0]}},
   (array_double_1d){in_reference->buf, {in_reference->shape[0]}},
   (array_double_1d){in_state->buf, {in_state->shape[0]}});
  answer = Py_NewRef(Py_None);
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_start(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_start", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_reference;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_reference = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_fault = take_array(&call, 2, 1, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "reference", 0, in_reference->shape[0], 10)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_start(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_reference->buf, {in_reference->shape[0]}},
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_judge_start(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "judge_start", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_state;
 Py_buffer *in_reference;
 double in_gravity;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 4)
  && (in_state = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_reference = take_array(&call, 1, 1, 'd', false)) != NULL
  && take_float(&call, 2, &in_gravity)
  && (in_fault = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "state", 0, in_state->shape[0], 10)
  && has_at_least(&call, "reference", 0, in_reference->shape[0], 10)
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_judge_start(
   (array_double_1d){in_state->buf, {in_state->shape[0]}},
   (array_double_1d){in_reference->buf, {in_reference->shape[0]}},
   in_gravity,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_check_start_rope(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "check_start_rope", .values = values};
 PyObject *answer = NULL;
 double in_length;
 double in_shortest;
 double in_longest;
 Py_buffer *in_fault;
 (void)self;
 if (take_count(&call, count, 4)
  && take_float(&call, 0, &in_length)
  && take_float(&call, 1, &in_shortest)
  && take_float(&call, 2, &in_longest)
  && (in_fault = take_array(&call, 3, 1, 'd', true)) != NULL
  && has_at_least(&call, "fault", 0, in_fault->shape[0], 4)) {
  answer = PyLong_FromLongLong(segfmu_check_start_rope(
   in_length,
   in_shortest,
   in_longest,
   (array_double_1d){in_fault->buf, {in_fault->shape[0]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_is_elsewhere(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "is_elsewhere", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_before;
 Py_buffer *in_reference;
 double in_step;
 (void)self;
 if (take_count(&call, count, 3)
  && (in_before = take_array(&call, 0, 1, 'd', false)) != NULL
  && (in_reference = take_array(&call, 1, 1, 'd', false)) != NULL
  && take_float(&call, 2, &in_step)
  && has_at_least(&call, "before", 0, in_before->shape[0], 10)
  && has_at_least(&call, "reference", 0, in_reference->shape[0], 10)) {
  answer = PyLong_FromLongLong(segfmu_is_elsewhere(
   (array_double_1d){in_before->buf, {in_before->shape[0]}},
   (array_double_1d){in_reference->buf, {in_reference->shape[0]}},
   in_step));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_plan_motion(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "plan_motion", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_dwells;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 Py_buffer *in_axes;
 Py_buffer *in_cells;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_times;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_states = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_dwells = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_limits = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_lower = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_axes = take_array(&call, 4, 2, 'd', true)) != NULL
  && (in_cells = take_array(&call, 5, 3, 'd', true)) != NULL
  && (in_timing = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 7, 2, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 8, 1, 'l', true)) != NULL
  && (in_times = take_array(&call, 9, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 10, 2, 'd', true)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_extent(&call, "dwells", 0, in_dwells->shape[0], in_states->shape[0])
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_states->shape[1])
  && has_extent(&call, "axes", 0, in_axes->shape[0], in_states->shape[1])
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_extent(&call, "times", 1, in_times->shape[1], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 50)
  && has_at_least(&call, "cells", 0, in_cells->shape[0], ((in_states->shape[0] - 1) * in_states->shape[1]))
  && has_at_least(&call, "cells", 1, in_cells->shape[1], 69)
  && has_at_least(&call, "cells", 2, in_cells->shape[2], 7)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_states->shape[1] + 1))
  && has_at_least(&call, "times", 0, in_times->shape[0], (in_states->shape[0] + 1))
  && has_at_least(&call, "work", 0, in_work->shape[0], 1246)
  && has_at_least(&call, "work", 1, in_work->shape[1], 50)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], (((double *)in_work->buf)[0 * in_work->shape[1] + 0] + 1))
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], (2 * ((double *)in_work->buf)[0 * in_work->shape[1] + 0]))) {
  answer = PyLong_FromLongLong(segfmu_plan_motion(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_1d){in_dwells->buf, {in_dwells->shape[0]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_3d){in_cells->buf, {in_cells->shape[0], in_cells->shape[1], in_cells->shape[2]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyObject *call_expand_motion(
 PyObject *self, PyObject *const *values, Py_ssize_t count) {
 arguments call = {.function = "expand_motion", .values = values};
 PyObject *answer = NULL;
 Py_buffer *in_states;
 Py_buffer *in_dwells;
 Py_buffer *in_limits;
 Py_buffer *in_lower;
 Py_buffer *in_axes;
 Py_buffer *in_cells;
 Py_buffer *in_timing;
 Py_buffer *in_coefficients;
 Py_buffer *in_offsets;
 Py_buffer *in_times;
 Py_buffer *in_work;
 (void)self;
 if (take_count(&call, count, 11)
  && (in_states = take_array(&call, 0, 3, 'd', false)) != NULL
  && (in_dwells = take_array(&call, 1, 1, 'd', false)) != NULL
  && (in_limits = take_array(&call, 2, 2, 'd', false)) != NULL
  && (in_lower = take_array(&call, 3, 2, 'd', false)) != NULL
  && (in_axes = take_array(&call, 4, 2, 'd', false)) != NULL
  && (in_cells = take_array(&call, 5, 3, 'd', true)) != NULL
  && (in_timing = take_array(&call, 6, 2, 'd', true)) != NULL
  && (in_coefficients = take_array(&call, 7, 2, 'd', true)) != NULL
  && (in_offsets = take_array(&call, 8, 1, 'l', true)) != NULL
  && (in_times = take_array(&call, 9, 2, 'd', true)) != NULL
  && (in_work = take_array(&call, 10, 2, 'd', true)) != NULL
  && has_at_least(&call, "states", 0, in_states->shape[0], 1)
  && has_at_least(&call, "states", 1, in_states->shape[1], 1)
  && has_at_least(&call, "timing", 0, in_timing->shape[0], 1)
  && has_extent(&call, "dwells", 0, in_dwells->shape[0], in_states->shape[0])
  && has_extent(&call, "limits", 0, in_limits->shape[0], in_states->shape[1])
  && has_extent(&call, "lower", 0, in_lower->shape[0], in_states->shape[1])
  && has_extent(&call, "axes", 0, in_axes->shape[0], in_states->shape[1])
  && has_extent(&call, "coefficients", 0, in_coefficients->shape[0], in_timing->shape[0])
  && has_extent(&call, "times", 1, in_times->shape[1], in_states->shape[1])
  && has_at_least(&call, "states", 2, in_states->shape[2], 3)
  && has_at_least(&call, "lower", 1, in_lower->shape[1], 2)
  && has_at_least(&call, "axes", 1, in_axes->shape[1], 50)
  && has_at_least(&call, "cells", 0, in_cells->shape[0], ((in_states->shape[0] - 1) * in_states->shape[1]))
  && has_at_least(&call, "cells", 1, in_cells->shape[1], 69)
  && has_at_least(&call, "cells", 2, in_cells->shape[2], 7)
  && has_at_least(&call, "timing", 1, in_timing->shape[1], 2)
  && has_at_least(&call, "offsets", 0, in_offsets->shape[0], (in_states->shape[1] + 1))
  && has_at_least(&call, "times", 0, in_times->shape[0], (in_states->shape[0] + 1))
  && has_at_least(&call, "work", 0, in_work->shape[0], 1246)
  && has_at_least(&call, "work", 1, in_work->shape[1], 50)
  && has_at_least(&call, "limits", 1, in_limits->shape[1], (((double *)in_work->buf)[0 * in_work->shape[1] + 0] + 1))
  && has_at_least(&call, "coefficients", 1, in_coefficients->shape[1], (2 * ((double *)in_work->buf)[0 * in_work->shape[1] + 0]))) {
  answer = PyLong_FromLongLong(segfmu_expand_motion(
   (array_double_3d){in_states->buf, {in_states->shape[0], in_states->shape[1], in_states->shape[2]}},
   (array_double_1d){in_dwells->buf, {in_dwells->shape[0]}},
   (array_double_2d){in_limits->buf, {in_limits->shape[0], in_limits->shape[1]}},
   (array_double_2d){in_lower->buf, {in_lower->shape[0], in_lower->shape[1]}},
   (array_double_2d){in_axes->buf, {in_axes->shape[0], in_axes->shape[1]}},
   (array_double_3d){in_cells->buf, {in_cells->shape[0], in_cells->shape[1], in_cells->shape[2]}},
   (array_double_2d){in_timing->buf, {in_timing->shape[0], in_timing->shape[1]}},
   (array_double_2d){in_coefficients->buf, {in_coefficients->shape[0], in_coefficients->shape[1]}},
   (array_int64_t_1d){in_offsets->buf, {in_offsets->shape[0]}},
   (array_double_2d){in_times->buf, {in_times->shape[0], in_times->shape[1]}},
   (array_double_2d){in_work->buf, {in_work->shape[0], in_work->shape[1]}}));
 }
 release_arguments(&call);
 return answer;
}

static PyMethodDef methods[] = {
 {"evaluate", (PyCFunction)(void (*)(void))call_evaluate, METH_FASTCALL, NULL},
 {"evaluate_orders", (PyCFunction)(void (*)(void))call_evaluate_orders, METH_FASTCALL, NULL},
 {"state_scale", (PyCFunction)(void (*)(void))call_state_scale, METH_FASTCALL, NULL},
 {"check_rope", (PyCFunction)(void (*)(void))call_check_rope, METH_FASTCALL, NULL},
 {"clearance_spans", (PyCFunction)(void (*)(void))call_clearance_spans, METH_FASTCALL, NULL},
 {"contact_times", (PyCFunction)(void (*)(void))call_contact_times, METH_FASTCALL, NULL},
 {"path_excursion", (PyCFunction)(void (*)(void))call_path_excursion, METH_FASTCALL, NULL},
 {"leaves_range", (PyCFunction)(void (*)(void))call_leaves_range, METH_FASTCALL, NULL},
 {"path_ranges", (PyCFunction)(void (*)(void))call_path_ranges, METH_FASTCALL, NULL},
 {"first_contact", (PyCFunction)(void (*)(void))call_first_contact, METH_FASTCALL, NULL},
 {"shrink_boxes", (PyCFunction)(void (*)(void))call_shrink_boxes, METH_FASTCALL, NULL},
 {"write_box", (PyCFunction)(void (*)(void))call_write_box, METH_FASTCALL, NULL},
 {"space_contact", (PyCFunction)(void (*)(void))call_space_contact, METH_FASTCALL, NULL},
 {"crane_rhs", (PyCFunction)(void (*)(void))call_crane_rhs, METH_FASTCALL, NULL},
 {"crane_driven", (PyCFunction)(void (*)(void))call_crane_driven, METH_FASTCALL, NULL},
 {"crane_flat_inverse", (PyCFunction)(void (*)(void))call_crane_flat_inverse, METH_FASTCALL, NULL},
 {"crane_load", (PyCFunction)(void (*)(void))call_crane_load, METH_FASTCALL, NULL},
 {"crane_energy", (PyCFunction)(void (*)(void))call_crane_energy, METH_FASTCALL, NULL},
 {"flat_derivatives", (PyCFunction)(void (*)(void))call_flat_derivatives, METH_FASTCALL, NULL},
 {"hook_derivatives", (PyCFunction)(void (*)(void))call_hook_derivatives, METH_FASTCALL, NULL},
 {"flat_orders", (PyCFunction)(void (*)(void))call_flat_orders, METH_FASTCALL, NULL},
 {"feedback_correction", (PyCFunction)(void (*)(void))call_feedback_correction, METH_FASTCALL, NULL},
 {"feedback_bandwidth", (PyCFunction)(void (*)(void))call_feedback_bandwidth, METH_FASTCALL, NULL},
 {"feedback_gains", (PyCFunction)(void (*)(void))call_feedback_gains, METH_FASTCALL, NULL},
 {"observer_predict", (PyCFunction)(void (*)(void))call_observer_predict, METH_FASTCALL, NULL},
 {"observer_correct", (PyCFunction)(void (*)(void))call_observer_correct, METH_FASTCALL, NULL},
 {"observer_design", (PyCFunction)(void (*)(void))call_observer_design, METH_FASTCALL, NULL},
 {"rope_range", (PyCFunction)(void (*)(void))call_rope_range, METH_FASTCALL, NULL},
 {"table_lengths", (PyCFunction)(void (*)(void))call_table_lengths, METH_FASTCALL, NULL},
 {"flat_table", (PyCFunction)(void (*)(void))call_flat_table, METH_FASTCALL, NULL},
 {"set_steps", (PyCFunction)(void (*)(void))call_set_steps, METH_FASTCALL, NULL},
 {"observer_table", (PyCFunction)(void (*)(void))call_observer_table, METH_FASTCALL, NULL},
 {"nominal_payload", (PyCFunction)(void (*)(void))call_nominal_payload, METH_FASTCALL, NULL},
 {"signal_age", (PyCFunction)(void (*)(void))call_signal_age, METH_FASTCALL, NULL},
 {"drive_bound", (PyCFunction)(void (*)(void))call_drive_bound, METH_FASTCALL, NULL},
 {"set_walks", (PyCFunction)(void (*)(void))call_set_walks, METH_FASTCALL, NULL},
 {"set_drives", (PyCFunction)(void (*)(void))call_set_drives, METH_FASTCALL, NULL},
 {"set_tracking", (PyCFunction)(void (*)(void))call_set_tracking, METH_FASTCALL, NULL},
 {"set_fading", (PyCFunction)(void (*)(void))call_set_fading, METH_FASTCALL, NULL},
 {"check_gains", (PyCFunction)(void (*)(void))call_check_gains, METH_FASTCALL, NULL},
 {"track_setpoint", (PyCFunction)(void (*)(void))call_track_setpoint, METH_FASTCALL, NULL},
 {"crane_load_partials", (PyCFunction)(void (*)(void))call_crane_load_partials, METH_FASTCALL, NULL},
 {"crane_energy_partials", (PyCFunction)(void (*)(void))call_crane_energy_partials, METH_FASTCALL, NULL},
 {"same_break", (PyCFunction)(void (*)(void))call_same_break, METH_FASTCALL, NULL},
 {"next_plan_event", (PyCFunction)(void (*)(void))call_next_plan_event, METH_FASTCALL, NULL},
 {"right_of_break", (PyCFunction)(void (*)(void))call_right_of_break, METH_FASTCALL, NULL},
 {"resists", (PyCFunction)(void (*)(void))call_resists, METH_FASTCALL, NULL},
 {"planned_friction", (PyCFunction)(void (*)(void))call_planned_friction, METH_FASTCALL, NULL},
 {"contact_history", (PyCFunction)(void (*)(void))call_contact_history, METH_FASTCALL, NULL},
 {"next_contact_event", (PyCFunction)(void (*)(void))call_next_contact_event, METH_FASTCALL, NULL},
 {"drive_demands", (PyCFunction)(void (*)(void))call_drive_demands, METH_FASTCALL, NULL},
 {"plant_failure", (PyCFunction)(void (*)(void))call_plant_failure, METH_FASTCALL, NULL},
 {"friction_derivative", (PyCFunction)(void (*)(void))call_friction_derivative, METH_FASTCALL, NULL},
 {"demand_peaks", (PyCFunction)(void (*)(void))call_demand_peaks, METH_FASTCALL, NULL},
 {"demand_samples", (PyCFunction)(void (*)(void))call_demand_samples, METH_FASTCALL, NULL},
 {"seed_numbers", (PyCFunction)(void (*)(void))call_seed_numbers, METH_FASTCALL, NULL},
 {"next_uniform", (PyCFunction)(void (*)(void))call_next_uniform, METH_FASTCALL, NULL},
 {"noise_components", (PyCFunction)(void (*)(void))call_noise_components, METH_FASTCALL, NULL},
 {"turbulence_components", (PyCFunction)(void (*)(void))call_turbulence_components, METH_FASTCALL, NULL},
 {"plant_advance", (PyCFunction)(void (*)(void))call_plant_advance, METH_FASTCALL, NULL},
 {"bound_uses", (PyCFunction)(void (*)(void))call_bound_uses, METH_FASTCALL, NULL},
 {"has_bounds", (PyCFunction)(void (*)(void))call_has_bounds, METH_FASTCALL, NULL},
 {"paced_use", (PyCFunction)(void (*)(void))call_paced_use, METH_FASTCALL, NULL},
 {"hook_design", (PyCFunction)(void (*)(void))call_hook_design, METH_FASTCALL, NULL},
 {"hook_correction", (PyCFunction)(void (*)(void))call_hook_correction, METH_FASTCALL, NULL},
 {"hook_frequencies", (PyCFunction)(void (*)(void))call_hook_frequencies, METH_FASTCALL, NULL},
 {"hook_load_motion", (PyCFunction)(void (*)(void))call_hook_load_motion, METH_FASTCALL, NULL},
 {"hook_outputs", (PyCFunction)(void (*)(void))call_hook_outputs, METH_FASTCALL, NULL},
 {"check_hook", (PyCFunction)(void (*)(void))call_check_hook, METH_FASTCALL, NULL},
 {"write_heading", (PyCFunction)(void (*)(void))call_write_heading, METH_FASTCALL, NULL},
 {"begin_pace", (PyCFunction)(void (*)(void))call_begin_pace, METH_FASTCALL, NULL},
 {"next_pace", (PyCFunction)(void (*)(void))call_next_pace, METH_FASTCALL, NULL},
 {"unite_waypoints", (PyCFunction)(void (*)(void))call_unite_waypoints, METH_FASTCALL, NULL},
 {"write_free", (PyCFunction)(void (*)(void))call_write_free, METH_FASTCALL, NULL},
 {"write_states", (PyCFunction)(void (*)(void))call_write_states, METH_FASTCALL, NULL},
 {"is_judged", (PyCFunction)(void (*)(void))call_is_judged, METH_FASTCALL, NULL},
 {"cap_best", (PyCFunction)(void (*)(void))call_cap_best, METH_FASTCALL, NULL},
 {"write_best", (PyCFunction)(void (*)(void))call_write_best, METH_FASTCALL, NULL},
 {"keep_best", (PyCFunction)(void (*)(void))call_keep_best, METH_FASTCALL, NULL},
 {"begin_limits", (PyCFunction)(void (*)(void))call_begin_limits, METH_FASTCALL, NULL},
 {"next_limits", (PyCFunction)(void (*)(void))call_next_limits, METH_FASTCALL, NULL},
 {"write_axes", (PyCFunction)(void (*)(void))call_write_axes, METH_FASTCALL, NULL},
 {"narrow_bounds", (PyCFunction)(void (*)(void))call_narrow_bounds, METH_FASTCALL, NULL},
 {"write_kinds", (PyCFunction)(void (*)(void))call_write_kinds, METH_FASTCALL, NULL},
 {"write_limits", (PyCFunction)(void (*)(void))call_write_limits, METH_FASTCALL, NULL},
 {"write_shares", (PyCFunction)(void (*)(void))call_write_shares, METH_FASTCALL, NULL},
 {"write_starts", (PyCFunction)(void (*)(void))call_write_starts, METH_FASTCALL, NULL},
 {"write_passing", (PyCFunction)(void (*)(void))call_write_passing, METH_FASTCALL, NULL},
 {"check_range", (PyCFunction)(void (*)(void))call_check_range, METH_FASTCALL, NULL},
 {"begin_time", (PyCFunction)(void (*)(void))call_begin_time, METH_FASTCALL, NULL},
 {"ramp_duration", (PyCFunction)(void (*)(void))call_ramp_duration, METH_FASTCALL, NULL},
 {"ramp_pieces", (PyCFunction)(void (*)(void))call_ramp_pieces, METH_FASTCALL, NULL},
 {"expand_phases", (PyCFunction)(void (*)(void))call_expand_phases, METH_FASTCALL, NULL},
 {"cut_plan", (PyCFunction)(void (*)(void))call_cut_plan, METH_FASTCALL, NULL},
 {"meet_ends", (PyCFunction)(void (*)(void))call_meet_ends, METH_FASTCALL, NULL},
 {"anchor_plan", (PyCFunction)(void (*)(void))call_anchor_plan, METH_FASTCALL, NULL},
 {"join_plans", (PyCFunction)(void (*)(void))call_join_plans, METH_FASTCALL, NULL},
 {"measure_phases", (PyCFunction)(void (*)(void))call_measure_phases, METH_FASTCALL, NULL},
 {"axis_limits", (PyCFunction)(void (*)(void))call_axis_limits, METH_FASTCALL, NULL},
 {"ramp_parameters", (PyCFunction)(void (*)(void))call_ramp_parameters, METH_FASTCALL, NULL},
 {"shortest_profile", (PyCFunction)(void (*)(void))call_shortest_profile, METH_FASTCALL, NULL},
 {"find_brake", (PyCFunction)(void (*)(void))call_find_brake, METH_FASTCALL, NULL},
 {"plan_ends", (PyCFunction)(void (*)(void))call_plan_ends, METH_FASTCALL, NULL},
 {"are_at_velocities", (PyCFunction)(void (*)(void))call_are_at_velocities, METH_FASTCALL, NULL},
 {"find_leads", (PyCFunction)(void (*)(void))call_find_leads, METH_FASTCALL, NULL},
 {"find_brakes", (PyCFunction)(void (*)(void))call_find_brakes, METH_FASTCALL, NULL},
 {"timed_profile", (PyCFunction)(void (*)(void))call_timed_profile, METH_FASTCALL, NULL},
 {"plan_phases", (PyCFunction)(void (*)(void))call_plan_phases, METH_FASTCALL, NULL},
 {"spline_share", (PyCFunction)(void (*)(void))call_spline_share, METH_FASTCALL, NULL},
 {"append_spline", (PyCFunction)(void (*)(void))call_append_spline, METH_FASTCALL, NULL},
 {"count_pieces", (PyCFunction)(void (*)(void))call_count_pieces, METH_FASTCALL, NULL},
 {"judge_pieces", (PyCFunction)(void (*)(void))call_judge_pieces, METH_FASTCALL, NULL},
 {"plan_onward", (PyCFunction)(void (*)(void))call_plan_onward, METH_FASTCALL, NULL},
 {"keeps_drives", (PyCFunction)(void (*)(void))call_keeps_drives, METH_FASTCALL, NULL},
 {"foresee_emergency", (PyCFunction)(void (*)(void))call_foresee_emergency, METH_FASTCALL, NULL},
 {"take_over_measured", (PyCFunction)(void (*)(void))call_take_over_measured, METH_FASTCALL, NULL},
 {"begin_operation", (PyCFunction)(void (*)(void))call_begin_operation, METH_FASTCALL, NULL},
 {"operate", (PyCFunction)(void (*)(void))call_operate, METH_FASTCALL, NULL},
 {"check_ready", (PyCFunction)(void (*)(void))call_check_ready, METH_FASTCALL, NULL},
 {"next_operation", (PyCFunction)(void (*)(void))call_next_operation, METH_FASTCALL, NULL},
 {"check_problem", (PyCFunction)(void (*)(void))call_check_problem, METH_FASTCALL, NULL},
 {"motion_scale", (PyCFunction)(void (*)(void))call_motion_scale, METH_FASTCALL, NULL},
 {"settle_states", (PyCFunction)(void (*)(void))call_settle_states, METH_FASTCALL, NULL},
 {"settle_dwells", (PyCFunction)(void (*)(void))call_settle_dwells, METH_FASTCALL, NULL},
 {"usual_room", (PyCFunction)(void (*)(void))call_usual_room, METH_FASTCALL, NULL},
 {"begin_choice", (PyCFunction)(void (*)(void))call_begin_choice, METH_FASTCALL, NULL},
 {"next_passage", (PyCFunction)(void (*)(void))call_next_passage, METH_FASTCALL, NULL},
 {"choose_passage", (PyCFunction)(void (*)(void))call_choose_passage, METH_FASTCALL, NULL},
 {"end_choice", (PyCFunction)(void (*)(void))call_end_choice, METH_FASTCALL, NULL},
 {"measure_state", (PyCFunction)(void (*)(void))call_measure_state, METH_FASTCALL, NULL},
 {"rig_next_event", (PyCFunction)(void (*)(void))call_rig_next_event, METH_FASTCALL, NULL},
 {"switch_correction", (PyCFunction)(void (*)(void))call_switch_correction, METH_FASTCALL, NULL},
 {"rig_event", (PyCFunction)(void (*)(void))call_rig_event, METH_FASTCALL, NULL},
 {"rig_signals", (PyCFunction)(void (*)(void))call_rig_signals, METH_FASTCALL, NULL},
 {"rig_rates", (PyCFunction)(void (*)(void))call_rig_rates, METH_FASTCALL, NULL},
 {"rig_rows", (PyCFunction)(void (*)(void))call_rig_rows, METH_FASTCALL, NULL},
 {"rig_start", (PyCFunction)(void (*)(void))call_rig_start, METH_FASTCALL, NULL},
 {"rig_step", (PyCFunction)(void (*)(void))call_rig_step, METH_FASTCALL, NULL},
 {"rig_balance", (PyCFunction)(void (*)(void))call_rig_balance, METH_FASTCALL, NULL},
 {"rig_imbalance", (PyCFunction)(void (*)(void))call_rig_imbalance, METH_FASTCALL, NULL},
 {"rig_outputs", (PyCFunction)(void (*)(void))call_rig_outputs, METH_FASTCALL, NULL},
 {"tracking_estimates", (PyCFunction)(void (*)(void))call_tracking_estimates, METH_FASTCALL, NULL},
 {"rig_partials", (PyCFunction)(void (*)(void))call_rig_partials, METH_FASTCALL, NULL},
 {"check_travel", (PyCFunction)(void (*)(void))call_check_travel, METH_FASTCALL, NULL},
 {"check_lags", (PyCFunction)(void (*)(void))call_check_lags, METH_FASTCALL, NULL},
 {"check_friction", (PyCFunction)(void (*)(void))call_check_friction, METH_FASTCALL, NULL},
 {"wind_speed", (PyCFunction)(void (*)(void))call_wind_speed, METH_FASTCALL, NULL},
 {"check_turbulence", (PyCFunction)(void (*)(void))call_check_turbulence, METH_FASTCALL, NULL},
 {"check_changes", (PyCFunction)(void (*)(void))call_check_changes, METH_FASTCALL, NULL},
 {"check_slack", (PyCFunction)(void (*)(void))call_check_slack, METH_FASTCALL, NULL},
 {"check_delays", (PyCFunction)(void (*)(void))call_check_delays, METH_FASTCALL, NULL},
 {"check_sensors", (PyCFunction)(void (*)(void))call_check_sensors, METH_FASTCALL, NULL},
 {"check_rope_bounds", (PyCFunction)(void (*)(void))call_check_rope_bounds, METH_FASTCALL, NULL},
 {"check_lengths", (PyCFunction)(void (*)(void))call_check_lengths, METH_FASTCALL, NULL},
 {"start_state", (PyCFunction)(void (*)(void))call_start_state, METH_FASTCALL, NULL},
 {"check_start", (PyCFunction)(void (*)(void))call_check_start, METH_FASTCALL, NULL},
 {"judge_start", (PyCFunction)(void (*)(void))call_judge_start, METH_FASTCALL, NULL},
 {"check_start_rope", (PyCFunction)(void (*)(void))call_check_start_rope, METH_FASTCALL, NULL},
 {"is_elsewhere", (PyCFunction)(void (*)(void))call_is_elsewhere, METH_FASTCALL, NULL},
 {"plan_motion", (PyCFunction)(void (*)(void))call_plan_motion, METH_FASTCALL, NULL},
 {"expand_motion", (PyCFunction)(void (*)(void))call_expand_motion, METH_FASTCALL, NULL},
 {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
 PyModuleDef_HEAD_INIT, "_compiled", "The kernels, compiled.", 0, methods, NULL,
 NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit__compiled(void) {
 return PyModuleDef_Init(&definition);
}
