#pragma once

#include <atomic>
#include <limits>
#include <vector>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "engine/mesh/mesh.h"

namespace palpate::bench {

// A mesh in a scene of Embree that is asked for closest points. Metres, single precision.
class EmbreeModel {
 public:
  struct Closest {
    double distance = std::numeric_limits<double>::infinity();
    DVec3 point{0.0};
  };

  explicit EmbreeModel(const Mesh& mesh);
  ~EmbreeModel();
  EmbreeModel(const EmbreeModel&) = delete;
  EmbreeModel& operator=(const EmbreeModel&) = delete;

  // The closest point within `reach`, or one that is infinitely far.
  Closest closest(const DVec3& point, double reach) const;

  std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }

 private:
  static bool count_memory(void* model, ssize_t bytes, bool post);
  static bool visit(RTCPointQueryFunctionArguments* arguments);

  std::atomic<ssize_t> bytes_ = 0;
  RTCDevice device_;
  RTCScene scene_;
  std::vector<Vec3> positions_;
  std::vector<TriangleIndices> triangles_;
};

}  // namespace palpate::bench
