/* SPDX-License-Identifier: MIT */
#include "values.h"

#include <math.h>
#include <string.h>

gd_variant variant_nil(void) {
  gd_variant variant;
  gd_variant_new_nil(&variant);
  return variant;
}

gd_variant variant_of_bool(bool value) {
  gd_variant variant;
  gd_variant_new_bool(&variant, value);
  return variant;
}

gd_variant variant_of_int(int64_t value) {
  gd_variant variant;
  gd_variant_new_int(&variant, value);
  return variant;
}

gd_variant variant_of_real(double value) {
  gd_variant variant;
  gd_variant_new_real(&variant, value);
  return variant;
}

gd_variant variant_of_text(const char* utf8) {
  gd_handle string = gd_string_from_utf8(utf8);
  gd_variant variant;
  gd_variant_new_string(&variant, &string);
  gd_string_destroy(&string);
  return variant;
}

gd_variant variant_of_vector(const double vector[3]) {
  const float floats[3] = {(float)vector[0], (float)vector[1], (float)vector[2]};
  gd_vector3 converted;
  memcpy(converted.bytes, floats, sizeof floats);
  gd_variant variant;
  gd_variant_new_vector3(&variant, &converted);
  return variant;
}

static void matrix_of(const double q[4], double m[3][3]) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const double s = 2 / (x * x + y * y + z * z + w * w);
  m[0][0] = 1 - s * (y * y + z * z), m[0][1] = s * (x * y - z * w), m[0][2] = s * (x * z + y * w);
  m[1][0] = s * (x * y + z * w), m[1][1] = 1 - s * (x * x + z * z), m[1][2] = s * (y * z - x * w);
  m[2][0] = s * (x * z - y * w), m[2][1] = s * (y * z + x * w), m[2][2] = 1 - s * (x * x + y * y);
}

gd_variant variant_of_pose(const plp_pose* pose) {
  double matrix[3][3];
  matrix_of(pose->orientation, matrix);
  float floats[12];
  for (int i = 0; i < 9; ++i) floats[i] = (float)matrix[i / 3][i % 3];
  for (int i = 0; i < 3; ++i) floats[9 + i] = (float)pose->position[i];
  gd_transform converted;
  memcpy(converted.bytes, floats, sizeof floats);
  gd_variant variant;
  gd_variant_new_transform(&variant, &converted);
  return variant;
}

gd_variant variant_of_numbers(const double* numbers, int count) {
  gd_handle array;
  gd_array_new(&array);
  for (int i = 0; i < count; ++i) array_append(&array, variant_of_real(numbers[i]));
  return variant_of_array(&array);
}

void array_append(gd_handle* array, gd_variant value) {
  gd_array_append(array, &value);
  gd_variant_destroy(&value);
}

void dictionary_set(gd_handle* dictionary, const char* key, gd_variant value) {
  gd_variant name = variant_of_text(key);
  gd_dictionary_set(dictionary, &name, &value);
  gd_variant_destroy(&name);
  gd_variant_destroy(&value);
}

gd_variant variant_of_array(gd_handle* array) {
  gd_variant variant;
  gd_variant_new_array(&variant, array);
  gd_array_destroy(array);
  return variant;
}

gd_variant variant_of_dictionary(gd_handle* dictionary) {
  gd_variant variant;
  gd_variant_new_dictionary(&variant, dictionary);
  gd_dictionary_destroy(dictionary);
  return variant;
}

gd_handle text_hold(const gd_variant* value) {
  gd_handle string = gd_variant_as_string(value);
  const gd_handle utf8 = gd_string_utf8(&string);
  gd_string_destroy(&string);
  return utf8;
}

const char* text_of(const gd_handle* held) {
  const char* text = gd_utf8_data(held);
  return text ? text : "";
}

void text_release(gd_handle* held) {
  gd_utf8_destroy(held);
}

bool is_number(const gd_variant* value) {
  const int type = gd_variant_type(value);
  return type == GD_INT || type == GD_REAL;
}

/* Four times the square of each component is on the diagonal; the others follow from the largest,
 * unnormalised. */
static void quaternion_of(const double m[3][3], double q[4]) {
  const double squares[4] = {1 + m[0][0] - m[1][1] - m[2][2], 1 - m[0][0] + m[1][1] - m[2][2],
                             1 - m[0][0] - m[1][1] + m[2][2], 1 + m[0][0] + m[1][1] + m[2][2]};
  int largest = 0;
  for (int i = 1; i < 4; ++i)
    if (squares[i] > squares[largest]) largest = i;
  q[largest] = squares[largest];
  if (largest == 3) {
    q[0] = m[2][1] - m[1][2], q[1] = m[0][2] - m[2][0], q[2] = m[1][0] - m[0][1];
    return;
  }
  const int next = (largest + 1) % 3, last = (largest + 2) % 3;
  q[next] = m[next][largest] + m[largest][next];
  q[last] = m[last][largest] + m[largest][last];
  q[3] = m[last][next] - m[next][last];
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool is_rotation(const double m[3][3]) {
  const double kTolerance = 1e-4; /* of what floats keep after many turns */
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      if (!(fabs(dot(m[i], m[j]) - (i == j)) <= kTolerance)) return false;
  const double cross[3] = {m[0][1] * m[1][2] - m[0][2] * m[1][1], m[0][2] * m[1][0] - m[0][0] * m[1][2],
                           m[0][0] * m[1][1] - m[0][1] * m[1][0]};
  return dot(cross, m[2]) > 0;
}

bool pose_of(const gd_variant* transform, plp_pose* pose) {
  const gd_transform given = gd_variant_as_transform(transform);
  float floats[12];
  memcpy(floats, given.bytes, sizeof floats);
  double matrix[3][3];
  for (int i = 0; i < 9; ++i) matrix[i / 3][i % 3] = floats[i];
  if (!is_rotation((const double(*)[3])matrix)) return false;
  quaternion_of((const double(*)[3])matrix, pose->orientation);
  for (int i = 0; i < 3; ++i) pose->position[i] = floats[9 + i];
  return true;
}

bool numbers_of(const gd_variant* array, double* numbers, int count) {
  gd_handle held = gd_variant_as_array(array);
  bool all = gd_array_size(&held) == count;
  for (int i = 0; all && i < count; ++i) {
    gd_variant item = gd_array_get(&held, i);
    all = is_number(&item);
    if (all) numbers[i] = gd_variant_as_real(&item);
    gd_variant_destroy(&item);
  }
  gd_array_destroy(&held);
  return all;
}
