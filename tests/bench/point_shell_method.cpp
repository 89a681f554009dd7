#include "tests/bench/point_shell_method.h"

#include <algorithm>

#include "engine/base/clock.h"
#include "tests/bench/embree_model.h"

namespace palpate::bench {
namespace {

class PointShell : public Method {
 public:
  explicit PointShell(const ModelPair& pair)
      : b_(pair.b), a_(pair.a->mesh()), cutoff_(pair.cutoff), found_(b_->mesh().positions.size()) {
    for (const Vec3& position : b_->mesh().positions)
      shell_.push_back(b_->mesh().frame.metres(DVec3(position)));
  }

  std::string name() const override { return "point_shell"; }
  std::string returns() const override { return "closest point of each vertex of the tool"; }
  std::size_t every() const override { return 10; }

  void update(const Pose& a_from_b) override {
    reference_ = a_from_b * b_->centre();
    contacts_.clear();
    for (std::size_t v = 0; v < shell_.size(); ++v) {
      const DVec3 point = a_from_b * shell_[v];
      found_[v] = a_.closest(point, cutoff_);
    }
    for (std::uint32_t v = 0; v < shell_.size(); ++v) {
      const double distance = found_[v].distance;
      if (!(distance > 0.0 && distance < cutoff_ && is_nearest_around(v))) continue;
      const DVec3 point = a_from_b * shell_[v];
      contacts_.push_back({point, (point - found_[v].point) / distance, distance, 1.0});
    }
  }

  Outcome outcome() const override { return outcome_of(contacts_, cutoff_, reference_); }

 private:
  bool is_nearest_around(std::uint32_t vertex) const {
    const auto neighbours = b_->mesh().vertex_neighbours[vertex];
    return std::all_of(neighbours.begin(), neighbours.end(), [&](std::uint32_t other) {
      return found_[vertex].distance <= found_[other].distance;
    });
  }

  std::shared_ptr<const Model> b_;
  EmbreeModel a_;
  double cutoff_;
  std::vector<DVec3> shell_;  // metres, frame of the tool
  std::vector<EmbreeModel::Closest> found_;
  DVec3 reference_{0.0};
  std::vector<SpringContact> contacts_;
};

}  // namespace

std::unique_ptr<Method> point_shell_method(const ModelPair& pair) {
  return std::make_unique<PointShell>(pair);
}

HierarchyCost embree_hierarchy_cost(const Mesh& mesh) {
  const Stopwatch watch;
  const EmbreeModel model(mesh);
  return {watch.elapsed_us(), static_cast<double>(model.bytes())};
}

}  // namespace palpate::bench
