#pragma once

#include <memory>

#include "samples/viewer/frame_state.h"
#include "samples/viewer/hand.h"

namespace palpate::viewer {

// Models that touch: a rig, the hand that moves it, and what has been felt.
class Session {
 public:
  // `record`: a file for a trace from the first step on; empty: none.
  Session(std::shared_ptr<const Content> content, std::size_t remembered, const std::string& record);

  // A frame of the window or of the film goes by.
  void advance();
  void step();  // one tick, while paused

  void pause(bool on);
  bool paused() const { return paused_; }
  bool finished() const;  // a replay without a device has come to its end

  Rig& rig() { return rig_; }
  Hand& hand() { return hand_; }
  const History& history() const { return history_; }
  FrameState state() const;

 private:
  void remember();

  std::shared_ptr<const Content> content_;
  Rig rig_;
  Hand hand_;
  History history_;
  std::uint64_t ticks_ = 0;
  bool paused_ = false;
};

}  // namespace palpate::viewer
