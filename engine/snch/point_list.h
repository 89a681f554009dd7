#pragma once

#include <cstddef>
#include <vector>

#include "engine/math/vector.h"

namespace palpate {

// Points as a structure of arrays.
class PointList {
 public:
  static constexpr std::size_t kPadding = 16;  // behind the last, so that whole vectors can be read

  std::size_t size() const { return size_; }
  void push_back(const Vec3& point) {
    if (size_ + kPadding >= coordinates_[0].size())
      for (std::vector<float>& row : coordinates_) row.resize(2 * row.size() + 2 * kPadding);
    for (int axis = 0; axis < 3; ++axis) coordinates_[axis][size_] = point[axis];
    ++size_;
  }
  Vec3 operator[](std::size_t i) const {
    return {coordinates_[0][i], coordinates_[1][i], coordinates_[2][i]};
  }
  const float* coordinates(int axis) const { return coordinates_[axis].data(); }

 private:
  std::vector<float> coordinates_[3];
  std::size_t size_ = 0;
};

}  // namespace palpate
