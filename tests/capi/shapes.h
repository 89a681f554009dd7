#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "palpate/palpate.h"

namespace palpate::test {

// Triangles in the form in which a caller has them.
struct Shape {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// An axis-aligned box about the origin.
inline Shape box(float x, float y, float z) {
  Shape shape;
  for (int corner = 0; corner < 8; ++corner) {
    shape.positions.push_back({corner & 1 ? x : -x, corner & 2 ? y : -y, corner & 4 ? z : -z});
  }
  shape.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return shape;
}

// A torus about the z axis.
inline Shape torus(double ring, double tube, std::uint32_t around, std::uint32_t across) {
  Shape shape;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * i / around;
      const double v = 2.0 * std::numbers::pi * j / across;
      const double radius = ring + tube * std::cos(v);
      shape.positions.push_back({static_cast<float>(radius * std::cos(u)),
                                 static_cast<float>(radius * std::sin(u)),
                                 static_cast<float>(tube * std::sin(v))});
      const std::uint32_t k = (i + 1) % around;
      const std::uint32_t l = (j + 1) % across;
      shape.triangles.push_back({i * across + j, k * across + j, k * across + l});
      shape.triangles.push_back({i * across + j, k * across + l, i * across + l});
    }
  }
  return shape;
}

// Valid as long as `shape`.
inline plp_triangles triangles_of(const Shape& shape) {
  plp_triangles triangles;
  plp_triangles_init(&triangles, sizeof triangles);
  triangles.positions = shape.positions.data();
  triangles.vertex_count = shape.positions.size();
  triangles.indices = shape.triangles.data();
  triangles.triangle_count = shape.triangles.size();
  return triangles;
}

// Owns one reference to a model.
class TestModel {
 public:
  explicit TestModel(const Shape& shape) : TestModel(triangles_of(shape)) {}
  explicit TestModel(const plp_triangles& triangles) {
    EXPECT_EQ(plp_model_create_from_triangles(&triangles, nullptr, &handle), PLP_OK) << plp_last_error();
  }
  ~TestModel() { plp_model_release(handle); }
  TestModel(const TestModel&) = delete;
  TestModel& operator=(const TestModel&) = delete;

  plp_model handle = nullptr;
};

// Owns a query result.
class TestQuery {
 public:
  TestQuery() { EXPECT_EQ(plp_query_result_create(&handle), PLP_OK); }
  ~TestQuery() { plp_query_result_release(handle); }
  TestQuery(const TestQuery&) = delete;
  TestQuery& operator=(const TestQuery&) = delete;

  plp_contacts contacts() const {
    plp_contacts read;
    plp_contacts_init(&read, sizeof read);
    EXPECT_EQ(plp_query_result_get(handle, &read), PLP_OK);
    return read;
  }

  plp_query_result handle = nullptr;
};

// Owns a scene.
class TestScene {
 public:
  explicit TestScene(const plp_scene_options& options) {
    EXPECT_EQ(plp_scene_create(&options, &handle), PLP_OK) << plp_last_error();
  }
  explicit TestScene(double cutoff) : TestScene(options_with(cutoff)) {}
  ~TestScene() { plp_scene_release(handle); }
  TestScene(const TestScene&) = delete;
  TestScene& operator=(const TestScene&) = delete;

  static plp_scene_options options_with(double cutoff) {
    plp_scene_options options;
    plp_scene_options_init(&options, sizeof options);
    options.cutoff = cutoff;
    options.law = PLP_LAW_SPRINGS;
    return options;
  }

  plp_body add(plp_model model, plp_body_kind kind, const plp_pose& pose) {
    plp_body_options options;
    plp_body_options_init(&options, sizeof options);
    options.model = model;
    options.kind = kind;
    options.pose = pose;
    plp_body body = 0;
    EXPECT_EQ(plp_scene_add_body(handle, &options, &body), PLP_OK) << plp_last_error();
    return body;
  }

  plp_contacts step() {
    EXPECT_EQ(plp_scene_step(handle), PLP_OK) << plp_last_error();
    plp_contacts read;
    plp_contacts_init(&read, sizeof read);
    EXPECT_EQ(plp_scene_get_contacts(handle, &read), PLP_OK);
    return read;
  }

  plp_scene handle = nullptr;
};

inline plp_pose at(double x, double y, double z) {
  return {{x, y, z}, {0.0, 0.0, 0.0, 1.0}};
}

}  // namespace palpate::test
