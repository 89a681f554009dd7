#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

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

// Where a body stands in the hierarchy of the file that it comes from.
struct BodyNode {
  std::string name;              // "" if it has none
  std::int32_t index = -1;       // in the file; −1: it comes from none
  BodyId above = 0;              // the nearest body in the hierarchy; 0: none
  DMat4 above_from_parent{1.0};  // the node's parent, in the frame of the body above or else of the scene
  DMat4 body_from_node{1.0};     // what of the node's transform its model holds
};

// A body that is to be added. `above` of its node is its place among the new ones, counted from 1.
struct NewBody {
  BodyOptions options;
  BodyNode node;
};

// A body as those who change the scene see it.
struct BodyRecord {
  explicit BodyRecord(BodyId its_id) : id(its_id), post(its_id) {}

  const BodyId id;
  BodyOptions options;  // as it was added
  BodyNode node;
  Pose pose;             // as it was set last
  bool in_hand = false;  // a device has moved it since
  struct Sight {
    DVec3 at;            // from the tool
    std::uint64_t step;  // of the tool's pose
  };
  std::optional<Sight> seen;  // by the last survey of a later step
  double ahead = 0.0;         // metres that it may come nearer while it is made ready
  PosePost post;
};

}  // namespace palpate
