#include <cstring>
#include <limits>
#include <string>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

plp_model_info info_of(plp_model model) {
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  EXPECT_EQ(plp_model_get_info(model, &info), PLP_OK);
  return info;
}

plp_result create(const plp_triangles& triangles, const plp_model_options* options = nullptr) {
  plp_model model = nullptr;
  const plp_result result = plp_model_create_from_triangles(&triangles, options, &model);
  plp_model_release(model);
  return result;
}

// Rows of three numbers, `stride` bytes apart, beginning at an odd address.
template <class Number, class Row>
std::vector<unsigned char> odd_rows(const std::vector<Row>& rows, std::size_t stride) {
  std::vector<unsigned char> bytes(1 + stride * rows.size(), 0xee);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Number number = static_cast<Number>(rows[i][k]);
      std::memcpy(&bytes[1 + i * stride + k * sizeof number], &number, sizeof number);
    }
  }
  return bytes;
}

class Triangles : public testing::Test {
 protected:
  void expect_box(const plp_triangles& triangles) {
    const TestModel model(triangles);
    const plp_model_info info = info_of(model.handle);
    EXPECT_EQ(info.searched.triangles, 12u);
    EXPECT_EQ(info.searched.vertices, 8u);
    EXPECT_EQ(info.searched.watertight, 1);
    EXPECT_EQ(info.source.orientation, PLP_ORIENTATION_OUTWARD);
    EXPECT_EQ(info.bounds_min[0], -1.0);
    EXPECT_EQ(info.bounds_max[1], 2.0);
    EXPECT_EQ(info.bounds_max[2], 3.0);
  }

  Shape box_ = box(1.0f, 2.0f, 3.0f);
  plp_triangles triangles_ = triangles_of(box_);
};

TEST_F(Triangles, Plain) {
  expect_box(triangles_);
}

TEST_F(Triangles, EveryNumberTypeAtOddAddressesAndStrides) {
  const auto floats = odd_rows<float>(box_.positions, 29);
  const auto doubles = odd_rows<double>(box_.positions, 31);
  const auto bytes = odd_rows<std::uint8_t>(box_.triangles, 5);
  const auto shorts = odd_rows<std::uint16_t>(box_.triangles, 9);
  const auto words = odd_rows<std::uint32_t>(box_.triangles, 13);
  const std::pair<plp_type, const std::vector<unsigned char>*> indices[] = {
      {PLP_TYPE_UINT8, &bytes}, {PLP_TYPE_UINT16, &shorts}, {PLP_TYPE_UINT32, &words}};
  const std::size_t index_strides[] = {5, 9, 13};
  for (int i = 0; i < 3; ++i) {
    for (const bool wide : {false, true}) {
      triangles_.positions = (wide ? doubles : floats).data() + 1;
      triangles_.position_type = wide ? PLP_TYPE_FLOAT64 : PLP_TYPE_FLOAT32;
      triangles_.position_stride = wide ? 31 : 29;
      triangles_.indices = indices[i].second->data() + 1;
      triangles_.index_type = indices[i].first;
      triangles_.index_stride = index_strides[i];
      expect_box(triangles_);
    }
  }
}

TEST_F(Triangles, WithoutIndices) {
  std::vector<std::array<float, 3>> corners;
  for (const auto& triangle : box_.triangles) {
    for (const std::uint32_t vertex : triangle) corners.push_back(box_.positions[vertex]);
  }
  triangles_.positions = corners.data();
  triangles_.vertex_count = corners.size();
  triangles_.indices = nullptr;
  expect_box(triangles_);
  triangles_.triangle_count = 0;
  expect_box(triangles_);
  triangles_.index_type = PLP_TYPE_NONE;
  expect_box(triangles_);
  triangles_.triangle_count = 13;
  EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT);
  triangles_.triangle_count = 0;
  triangles_.vertex_count = 35;
  EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT);
}

TEST_F(Triangles, IndexOutOfRangeNamesItsTriangle) {
  box_.triangles[7][1] = 8;
  EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(plp_last_error()).find("triangle 7"), std::string::npos) << plp_last_error();
}

TEST_F(Triangles, TypesAreChecked) {
  for (const int bad : {0, 3, 6, -1}) {
    triangles_.position_type = static_cast<plp_type>(bad);
    EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT) << bad;
  }
  triangles_.position_type = PLP_TYPE_FLOAT32;
  for (const int bad : {0, 1, 2, 99}) {
    triangles_.index_type = static_cast<plp_type>(bad);
    EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT) << bad;
  }
}

TEST_F(Triangles, ImpossibleBuffersAreRefused) {
  triangles_.position_stride = 11;
  EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT);
  triangles_.position_stride = SIZE_MAX;
  EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT);
  triangles_.position_stride = 0;
  triangles_.index_stride = SIZE_MAX / 4;
  EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT);
  triangles_.index_stride = 0;
  triangles_.vertex_count = SIZE_MAX;
  EXPECT_EQ(create(triangles_), PLP_ERROR_LIMIT);
  triangles_.vertex_count = 8;
  triangles_.triangle_count = SIZE_MAX;
  EXPECT_EQ(create(triangles_), PLP_ERROR_LIMIT);
  triangles_.triangle_count = 12;
  triangles_.positions = nullptr;
  EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT);
  triangles_.positions = box_.positions.data();
  triangles_.reserved = 1;
  EXPECT_EQ(create(triangles_), PLP_ERROR_INVALID_ARGUMENT);
}

TEST_F(Triangles, LimitOfTheOptions) {
  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.max_triangles = 11;
  EXPECT_EQ(create(triangles_, &options), PLP_ERROR_LIMIT);
  options.max_triangles = 12;
  EXPECT_EQ(create(triangles_, &options), PLP_OK);
}

TEST_F(Triangles, CoordinatesThatAreNotFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    box_.positions[3][1] = bad;
    EXPECT_EQ(create(triangles_), PLP_ERROR_NON_FINITE);
  }
}

TEST_F(Triangles, NothingToTouch) {
  triangles_.triangle_count = 0;
  EXPECT_EQ(create(triangles_), PLP_ERROR_NO_TRIANGLES);
  const std::array<std::uint32_t, 3> line = {1, 1, 2};
  triangles_.indices = &line;
  triangles_.triangle_count = 1;
  EXPECT_EQ(create(triangles_), PLP_ERROR_NO_TRIANGLES);
}

TEST_F(Triangles, MirroredSpaceTurnsTheWinding) {
  // The box in a space whose x runs the other way: seen there, the same winding faces inward.
  for (auto& position : box_.positions) position[0] = -position[0];
  for (auto& triangle : box_.triangles) std::swap(triangle[1], triangle[2]);
  triangles_.space = {{-1, 2, 3}, 0, 1.0};
  expect_box(triangles_);
}

TEST_F(Triangles, UnitsAndAxes) {
  // A space in centimetres with z up: its x y z are Palpate's x −z y.
  for (auto& position : box_.positions)
    position = {100.0f * position[0], -100.0f * position[2], 100.0f * position[1]};
  triangles_.space = {{1, -3, 2}, 0, 0.01};
  const TestModel model(triangles_);
  const plp_model_info info = info_of(model.handle);
  EXPECT_EQ(info.source.orientation, PLP_ORIENTATION_OUTWARD);
  EXPECT_DOUBLE_EQ(info.bounds_max[0], 1.0);
  EXPECT_DOUBLE_EQ(info.bounds_max[1], 2.0);
  EXPECT_DOUBLE_EQ(info.bounds_max[2], 3.0);
}

TEST_F(Triangles, FlagsReachTheMesh) {
  for (auto& triangle : box_.triangles) std::swap(triangle[1], triangle[2]);
  const TestModel turned(triangles_);
  EXPECT_EQ(info_of(turned.handle).source.orientation, PLP_ORIENTATION_INWARD);
  EXPECT_EQ(info_of(turned.handle).searched.orientation, PLP_ORIENTATION_OUTWARD);
  EXPECT_EQ(info_of(turned.handle).flipped_components, 1u);

  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.flags = PLP_MODEL_DOUBLE_SIDED | PLP_MODEL_KEEP_WINDING;
  plp_model kept = nullptr;
  ASSERT_EQ(plp_model_create_from_triangles(&triangles_, &options, &kept), PLP_OK);
  EXPECT_EQ(info_of(kept).searched.orientation, PLP_ORIENTATION_INWARD);
  EXPECT_EQ(info_of(kept).reversed_triangles, 0u);
  plp_model_release(kept);
}

TEST_F(Triangles, TreeIsBuiltOnDemandOnly) {
  const TestModel model(triangles_);
  EXPECT_EQ(info_of(model.handle).tree_nodes, 0u);
  EXPECT_GT(info_of(model.handle).mesh_bytes, 0u);
  EXPECT_EQ(plp_model_prepare(model.handle), PLP_OK);
  EXPECT_GT(info_of(model.handle).tree_nodes, 0u);
  EXPECT_GT(info_of(model.handle).tree_bytes, 0u);
}

TEST_F(Triangles, NotesSayWhatWasRepaired) {
  box_.triangles.push_back({0, 0, 1});
  triangles_ = triangles_of(box_);
  const TestModel model(triangles_);
  const plp_model_info info = info_of(model.handle);
  EXPECT_EQ(info.degenerate_triangles, 1u);
  ASSERT_GT(info.note_count, 0u);
  for (std::uint32_t i = 0; i < info.note_count; ++i) {
    ASSERT_NE(plp_model_note(model.handle, i), nullptr);
    EXPECT_GT(std::strlen(plp_model_note(model.handle, i)), 0u);
  }
  EXPECT_EQ(plp_model_note(model.handle, info.note_count), nullptr);
}

// What plp_model_get_vertices and plp_model_get_triangles tell of a model.
struct Copied {
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint32_t> sources;

  explicit Copied(plp_model model) {
    std::size_t vertices = 0, triangles = 0;
    EXPECT_EQ(plp_model_get_vertices(model, nullptr, 0, &vertices), PLP_OK);
    EXPECT_EQ(plp_model_get_triangles(model, nullptr, nullptr, 0, &triangles), PLP_OK);
    positions.resize(vertices);
    corners.resize(triangles);
    sources.resize(triangles);
    EXPECT_EQ(plp_model_get_vertices(model, positions[0].data(), vertices, &vertices), PLP_OK);
    EXPECT_EQ(plp_model_get_triangles(model, corners[0].data(), sources.data(), triangles, &triangles),
              PLP_OK);
  }
};

TEST_F(Triangles, ComeBackAsTheyAreSearched) {
  // A soup far from the origin, inside out: it comes back welded and turned.
  Shape soup;
  for (const auto& triangle : box_.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t corner : triangle) soup.positions.push_back(box_.positions[corner]);
    soup.triangles.push_back({first, first + 2, first + 1});
  }
  for (auto& position : soup.positions) position[0] += 1000.0f;
  const TestModel model(soup);
  const Copied copied(model.handle);
  ASSERT_EQ(copied.positions.size(), 8u);
  ASSERT_EQ(copied.corners.size(), 12u);
  for (const auto& [x, y, z] : copied.positions) {
    EXPECT_EQ(std::abs(x - 1000.0), 1.0);
    EXPECT_EQ(std::abs(y), 2.0);
    EXPECT_EQ(std::abs(z), 3.0);
  }
  for (std::size_t i = 0; i < copied.corners.size(); ++i) {
    const auto at = [&](int k) { return copied.positions[copied.corners[i][k]]; };
    const auto a = at(0), b = at(1), c = at(2);
    double volume = 0.0;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      const double shift = k == 0 ? 1000.0 : 0.0;
      volume += (a[k] - shift) * ((b[l] - a[l]) * (c[m] - a[m]) - (b[m] - a[m]) * (c[l] - a[l]));
    }
    EXPECT_GT(volume, 0.0);
    const auto& given = soup.triangles[copied.sources[i]];
    EXPECT_EQ(soup.positions[given[0]][1] + soup.positions[given[1]][1] + soup.positions[given[2]][1],
              a[1] + b[1] + c[1]);
  }
}

TEST_F(Triangles, NoMoreAreWrittenThanFit) {
  const TestModel model(triangles_);
  constexpr double kUntouched = 77.0;
  std::array<double, 9> positions;
  positions.fill(kUntouched);
  std::size_t count = 0;
  EXPECT_EQ(plp_model_get_vertices(model.handle, positions.data(), 2, &count), PLP_OK);
  EXPECT_EQ(count, 8u);
  EXPECT_NE(positions[5], kUntouched);
  for (int i = 6; i < 9; ++i) EXPECT_EQ(positions[i], kUntouched);

  std::array<std::uint32_t, 40> corners;
  corners.fill(77);
  EXPECT_EQ(plp_model_get_triangles(model.handle, corners.data(), nullptr, 1000, &count), PLP_OK);
  EXPECT_EQ(count, 12u);
  for (int i = 0; i < 36; ++i) EXPECT_LT(corners[i], 8u);
  for (int i = 36; i < 40; ++i) EXPECT_EQ(corners[i], 77u);
}

TEST_F(Triangles, CopiesAreRefusedWithoutAModelOrRoom) {
  const TestModel model(triangles_);
  std::size_t count = 77;
  double numbers[3];
  EXPECT_EQ(plp_model_get_vertices(nullptr, numbers, 1, &count), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_model_get_triangles(nullptr, nullptr, nullptr, 0, &count), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_model_get_vertices(model.handle, nullptr, 1, &count), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_model_get_vertices(model.handle, numbers, 1, nullptr), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_model_get_triangles(model.handle, nullptr, nullptr, 0, nullptr), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(count, 77u);
}

}  // namespace
}  // namespace palpate::test
