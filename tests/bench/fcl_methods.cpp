#include "tests/bench/fcl_methods.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/distance.h>

#include "engine/base/clock.h"

namespace palpate::bench {
namespace {

template <class Volume>
std::shared_ptr<fcl::BVHModel<Volume>> fcl_model(const Mesh& mesh) {
  std::vector<fcl::Vector3d> points;
  for (const Vec3& position : mesh.positions) {
    const DVec3 p = mesh.frame.metres(DVec3(position));
    points.emplace_back(p.x, p.y, p.z);
  }
  std::vector<fcl::Triangle> triangles;
  for (const auto& [i, j, k] : mesh.triangles) triangles.emplace_back(i, j, k);
  auto model = std::make_shared<fcl::BVHModel<Volume>>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transform_of(const Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) transform.linear()(row, column) = pose.rotation[column][row];
  transform.translation() << pose.translation.x, pose.translation.y, pose.translation.z;
  return transform;
}

DVec3 point_of(const fcl::Vector3d& point) {
  return {point[0], point[1], point[2]};
}

template <class Volume>
class FclDistance : public Method {
 public:
  FclDistance(const char* name, const ModelPair& pair)
      : name_(name),
        a_(fcl_model<Volume>(pair.a->mesh())),
        b_(fcl_model<Volume>(pair.b->mesh())),
        centre_(pair.b->centre()),
        cutoff_(pair.cutoff) {}

  std::string name() const override { return name_; }
  std::string returns() const override { return "one minimum"; }

  // The first model's frame is the world's, in which FCL then has both nearest points.
  void update(const Pose& a_from_b) override {
    reference_ = a_from_b * centre_;
    result_.clear();
    fcl::distance<double>(a_.get(), fcl::Transform3d::Identity(), b_.get(), transform_of(a_from_b), request_,
                          result_);
  }

  Outcome outcome() const override {
    const double distance = result_.min_distance;
    std::vector<SpringContact> contacts;
    if (distance > 0.0 && distance < cutoff_) {
      const DVec3 p = point_of(result_.nearest_points[0]), q = point_of(result_.nearest_points[1]);
      contacts.push_back({q, glm::normalize(q - p), distance, 1.0});
    }
    Outcome outcome = outcome_of(contacts, cutoff_, reference_);
    outcome.min_distance = distance;
    outcome.overlap = distance <= 0.0;
    return outcome;
  }

 private:
  const char* name_;
  std::shared_ptr<fcl::BVHModel<Volume>> a_, b_;
  DVec3 centre_;
  double cutoff_;
  DVec3 reference_{0.0};
  fcl::DistanceRequestd request_{true};
  fcl::DistanceResultd result_;
};

}  // namespace

std::unique_ptr<Method> fcl_obbrss_method(const ModelPair& pair) {
  return std::make_unique<FclDistance<fcl::OBBRSSd>>("fcl_obbrss", pair);
}

std::unique_ptr<Method> fcl_rss_method(const ModelPair& pair) {
  return std::make_unique<FclDistance<fcl::RSSd>>("fcl_rss", pair);
}

HierarchyCost fcl_hierarchy_cost(const Mesh& mesh) {
  const Stopwatch watch;
  const auto model = fcl_model<fcl::OBBRSSd>(mesh);
  const double build_us = watch.elapsed_us();
  // Nodes, indices of the triangles in the order of the leaves, triangles and vertices.
  const std::size_t bytes =
      static_cast<std::size_t>(model->getNumBVs()) * sizeof(fcl::BVNode<fcl::OBBRSSd>) +
      static_cast<std::size_t>(model->num_tris) * (sizeof(unsigned) + sizeof(fcl::Triangle)) +
      static_cast<std::size_t>(model->num_vertices) * sizeof(fcl::Vector3d);
  return {build_us, static_cast<double>(bytes)};
}

}  // namespace palpate::bench
