#pragma once

#include <memory>
#include <optional>

#include "engine/exchange/flag.h"
#include "engine/exchange/triple_slot.h"
#include "engine/runtime/command.h"

namespace palpate {

// The newest pose of a body on its way to the servo: however many are sent, one waits.
class PosePost : public Command {
 public:
  explicit PosePost(BodyId id) : id_(id) {}

  // True: it must be posted; false: it lies in the mailbox already.
  bool send(const Pose& pose) {
    poses_.back() = pose;
    poses_.publish();
    return !posted_.raise();
  }

  void execute(Scene& scene) noexcept override {
    posted_.lower();  // first, so that a pose sent from now on is posted again
    if (poses_.fetch()) scene.set_pose(id_, poses_.front());
  }
  bool ends() const override { return false; }

 private:
  const BodyId id_;
  TripleSlot<Pose> poses_;
  Flag posted_;
};

// A body as those who change the scene see it.
struct BodyRecord {
  explicit BodyRecord(BodyId its_id) : id(its_id), post(its_id) {}

  const BodyId id;
  BodyKind kind = BodyKind::kStatic;
  std::shared_ptr<const Model> model;
  Pose pose;             // as it was set last
  bool in_hand = false;  // a device has moved it since
  BodyOptions as_added;  // for whoever records
  struct Sight {
    DVec3 at;            // from the tool
    std::uint64_t step;  // of the tool's pose
  };
  std::optional<Sight> seen;  // by the last survey of a later step
  double ahead = 0.0;         // metres that it may come nearer while it is made ready
  PosePost post;
};

}  // namespace palpate
