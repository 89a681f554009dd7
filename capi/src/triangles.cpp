#include "capi/src/triangles.h"

#include <cstring>
#include <limits>
#include <utility>

#include "capi/src/space.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

// Rows of three numbers in a caller's buffer, which may lie at any alignment.
struct RowBuffer {
  const std::byte* data;
  std::size_t stride;

  template <class Number>
  Number read(std::size_t row, std::size_t column) const {
    Number number;
    std::memcpy(&number, data + row * stride + column * sizeof(Number), sizeof number);
    return number;
  }
};

// Refuses a stride that makes rows overlap, or rows that no address space can hold.
RowBuffer checked_rows(const void* data, std::size_t stride, std::size_t rows, std::size_t number_size,
                       const std::string& name) {
  const std::size_t row_size = 3 * number_size;
  if (stride == 0) stride = row_size;
  if (stride < row_size) {
    refuse(ErrorCode::kInvalidArgument,
           name + "_stride is less than the " + std::to_string(row_size) + " bytes of a row");
  }
  if (rows > 0 && (rows - 1) > (std::numeric_limits<std::size_t>::max() - row_size) / stride) {
    refuse(ErrorCode::kInvalidArgument, name + "_stride times the count is more than memory can hold");
  }
  return {static_cast<const std::byte*>(data), stride};
}

template <class Number>
void read_positions(const RowBuffer& rows, std::size_t count, const Space& space,
                    std::vector<DVec3>& positions) {
  positions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const DVec3 position(rows.read<Number>(i, 0), rows.read<Number>(i, 1), rows.read<Number>(i, 2));
    positions.push_back(space.point_in(position));
  }
}

template <class Number>
void read_indices(const RowBuffer& rows, std::size_t vertex_count, std::vector<TriangleIndices>& triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t index = rows.read<Number>(i, k);
      if (index >= vertex_count) {
        refuse(ErrorCode::kInvalidArgument, "triangle " + std::to_string(i) + " names vertex " +
                                                std::to_string(index) + ", but there are " +
                                                std::to_string(vertex_count));
      }
      triangles[i][k] = index;
    }
  }
}

void number_in_order(std::vector<TriangleIndices>& triangles) {
  std::uint32_t next = 0;
  for (TriangleIndices& triangle : triangles) {
    for (std::uint32_t& vertex : triangle) vertex = next++;
  }
}

std::vector<DVec3> positions_of(const plp_triangles& triangles, const Space& space) {
  require(triangles.positions, "triangles->positions is null");
  if (triangles.vertex_count >= std::numeric_limits<std::uint32_t>::max()) {
    refuse(ErrorCode::kLimit, "triangles->vertex_count is not below 2^32 - 1");
  }
  const auto rows = [&](std::size_t number_size) {
    return checked_rows(triangles.positions, triangles.position_stride, triangles.vertex_count, number_size,
                        "triangles->position");
  };
  std::vector<DVec3> positions;
  switch (raw_enum(triangles.position_type)) {
    case PLP_TYPE_FLOAT32:
      read_positions<float>(rows(sizeof(float)), triangles.vertex_count, space, positions);
      return positions;
    case PLP_TYPE_FLOAT64:
      read_positions<double>(rows(sizeof(double)), triangles.vertex_count, space, positions);
      return positions;
  }
  refuse(ErrorCode::kInvalidArgument,
         "triangles->position_type is neither PLP_TYPE_FLOAT32 nor PLP_TYPE_FLOAT64");
}

void fill_indices(const plp_triangles& from, std::vector<TriangleIndices>& triangles) {
  const auto rows = [&](std::size_t number_size) {
    return checked_rows(from.indices, from.index_stride, from.triangle_count, number_size,
                        "triangles->index");
  };
  switch (raw_enum(from.index_type)) {
    case PLP_TYPE_UINT8:
      return read_indices<std::uint8_t>(rows(1), from.vertex_count, triangles);
    case PLP_TYPE_UINT16:
      return read_indices<std::uint16_t>(rows(2), from.vertex_count, triangles);
    case PLP_TYPE_UINT32:
      return read_indices<std::uint32_t>(rows(4), from.vertex_count, triangles);
  }
  refuse(ErrorCode::kInvalidArgument, "triangles->index_type is not PLP_TYPE_UINT8, UINT16 or UINT32");
}

// How many triangles the caller means, once it is known that the vertices suffice.
std::size_t checked_triangle_count(const plp_triangles& triangles, std::uint64_t max_triangles) {
  std::size_t count = triangles.triangle_count;
  if (!triangles.indices) {
    const std::size_t available = triangles.vertex_count / 3;
    if (count == 0) {
      require(triangles.vertex_count % 3 == 0,
              "triangles->vertex_count is no multiple of 3 and there are no indices");
      count = available;
    }
    require(count <= available, "triangles->triangle_count needs more vertices than there are");
  }
  if (count > max_triangles) {
    refuse(ErrorCode::kLimit,
           std::to_string(count) + " triangles are more than the limit of " + std::to_string(max_triangles));
  }
  return count;
}

}  // namespace

TriangleSoup read_triangles(const plp_triangles& triangles, std::uint64_t max_triangles) {
  require(triangles.reserved == 0, "triangles->reserved is not zero");
  const Space space(triangles.space, "triangles->space");
  const std::size_t count = checked_triangle_count(triangles, max_triangles);

  TriangleSoup soup;
  soup.positions = positions_of(triangles, space);
  soup.triangles.resize(count);
  if (triangles.indices) {
    fill_indices(triangles, soup.triangles);
  } else {
    number_in_order(soup.triangles);
  }
  if (space.mirrored()) {
    for (TriangleIndices& triangle : soup.triangles) std::swap(triangle[1], triangle[2]);
  }
  return soup;
}

}  // namespace palpate::capi
