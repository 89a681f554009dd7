#include "tests/bench/coal_method.h"

#ifdef PALPATE_BENCH_COAL
#include <coal/BVH/BVH_model.h>
#include <coal/distance.h>
#endif

namespace palpate::bench {

#ifdef PALPATE_BENCH_COAL
namespace {

using Volume = coal::OBBRSS;

std::shared_ptr<coal::BVHModel<Volume>> coal_model(const Mesh& mesh) {
  std::vector<coal::Vec3s> points;
  for (const Vec3& position : mesh.positions) {
    const DVec3 p = mesh.frame.metres(DVec3(position));
    points.emplace_back(p.x, p.y, p.z);
  }
  std::vector<coal::Triangle> triangles;
  for (const auto& [i, j, k] : mesh.triangles) triangles.emplace_back(i, j, k);
  auto model = std::make_shared<coal::BVHModel<Volume>>();
  model->beginModel(static_cast<unsigned>(triangles.size()), static_cast<unsigned>(points.size()));
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

coal::Transform3s transform_of(const Pose& pose) {
  coal::Matrix3s rotation;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) rotation(row, column) = pose.rotation[column][row];
  return {rotation, coal::Vec3s(pose.translation.x, pose.translation.y, pose.translation.z)};
}

DVec3 point_of(const coal::Vec3s& point) {
  return {point[0], point[1], point[2]};
}

class CoalDistance : public Method {
 public:
  explicit CoalDistance(const ModelPair& pair)
      : a_(coal_model(pair.a->mesh())),
        b_(coal_model(pair.b->mesh())),
        centre_(pair.b->centre()),
        cutoff_(pair.cutoff) {}

  std::string name() const override { return "coal_obbrss"; }
  std::string returns() const override { return "one minimum"; }

  void update(const Pose& a_from_b) override {
    reference_ = a_from_b * centre_;
    result_.clear();
    coal::distance(a_.get(), coal::Transform3s::Identity(), b_.get(), transform_of(a_from_b), request_,
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
  std::shared_ptr<coal::BVHModel<Volume>> a_, b_;
  DVec3 centre_;
  double cutoff_;
  DVec3 reference_{0.0};
  coal::DistanceRequest request_{true, false};
  coal::DistanceResult result_;
};

}  // namespace

std::unique_ptr<Method> coal_method(const ModelPair& pair) {
  return std::make_unique<CoalDistance>(pair);
}

#else

std::unique_ptr<Method> coal_method(const ModelPair&) {
  return nullptr;
}

#endif

}  // namespace palpate::bench
