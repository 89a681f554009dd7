#include "tests/bench/embree_model.h"

#include <algorithm>

namespace palpate::bench {
namespace {

// One query: where it is and the best so far.
struct Query {
  const std::vector<Vec3>& positions;
  const std::vector<TriangleIndices>& triangles;
  Vec3 point;
  Vec3 best{0.0f};
  bool found = false;
};

// After C. Ericson, Real-Time Collision Detection, section 5.1.5.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - b;
  const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  const Vec3 cp = p - c;
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const float scale = 1 / (va + vb + vc);
  return a + ab * (vb * scale) + ac * (vc * scale);
}

}  // namespace

EmbreeModel::EmbreeModel(const Mesh& mesh) : device_(rtcNewDevice(nullptr)), triangles_(mesh.triangles) {
  for (const Vec3& position : mesh.positions) positions_.push_back(Vec3(mesh.frame.metres(DVec3(position))));
  rtcSetDeviceMemoryMonitorFunction(device_, count_memory, this);
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                            sizeof(Vec3), positions_.size());
  std::copy(positions_.begin(), positions_.end(), static_cast<Vec3*>(positions));
  void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(TriangleIndices), triangles_.size());
  std::copy(triangles_.begin(), triangles_.end(), static_cast<TriangleIndices*>(triangles));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
}

EmbreeModel::~EmbreeModel() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

EmbreeModel::Closest EmbreeModel::closest(const DVec3& point, double reach) const {
  Query query{positions_, triangles_, Vec3(point)};
  RTCPointQuery sphere{query.point.x, query.point.y, query.point.z, 0.0f, static_cast<float>(reach)};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_, &sphere, &context, visit, &query);
  if (!query.found) return {};
  return {glm::length(point - DVec3(query.best)), DVec3(query.best)};
}

bool EmbreeModel::visit(RTCPointQueryFunctionArguments* arguments) {
  Query& query = *static_cast<Query*>(arguments->userPtr);
  const auto [i, j, k] = query.triangles[arguments->primID];
  const Vec3 closest =
      closest_on_triangle(query.point, query.positions[i], query.positions[j], query.positions[k]);
  const float distance = glm::length(query.point - closest);
  if (distance >= arguments->query->radius) return false;
  arguments->query->radius = distance;
  query.best = closest;
  query.found = true;
  return true;
}

// Embree builds in parallel and calls this from many threads.
bool EmbreeModel::count_memory(void* model, ssize_t bytes, bool) {
  static_cast<EmbreeModel*>(model)->bytes_ += bytes;
  return true;
}

}  // namespace palpate::bench
