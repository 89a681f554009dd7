#include "tests/bench/scene_methods.h"

#include <optional>

namespace palpate::bench {
namespace {

DVec3 vector_of(const double (&values)[3]) {
  return {values[0], values[1], values[2]};
}

class SceneMethod : public Method {
 public:
  SceneMethod(const ModelPair& pair, const SceneMode& mode)
      : mode_(mode), cutoff_(pair.cutoff), a_(public_model(*pair.a)), b_(public_model(*pair.b)) {}

  void restart() override {
    scene_.emplace(cutoff_, mode_.mode, mode_.law, mode_.global_every);
    scene_->add_static(a_.get(), Pose{});
    scene_->add_tool(b_.get(), mode_.reference_point);
  }

  std::string name() const override {
    return mode_.law == Law::kSmooth ? mode_.name + "_smooth" : mode_.name;
  }
  std::string returns() const override { return mode_.returns; }
  void update(const Pose& a_from_b) override { scene_->step(a_from_b); }

  Outcome outcome() const override {
    const plp_contacts contacts = scene_->contacts();
    Outcome outcome;
    outcome.lmds = contacts.set_count;
    outcome.min_distance = contacts.min_distance;
    outcome.wrench = {vector_of(contacts.wrench.force), vector_of(contacts.wrench.torque)};
    outcome.overlap = contacts.overlap != 0;
    if (mode_.mode == PLP_MODE_DESCENT) outcome.aside_us = contacts.work.global_us;
    return outcome;
  }

 private:
  SceneMode mode_;
  double cutoff_;
  cli::OwnedModel a_, b_;
  std::optional<TouchScene> scene_;
};

}  // namespace

std::unique_ptr<Method> scene_method(const ModelPair& pair, const SceneMode& mode) {
  return std::make_unique<SceneMethod>(pair, mode);
}

}  // namespace palpate::bench
