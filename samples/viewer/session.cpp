#include "samples/viewer/session.h"

#include <algorithm>

#include "samples/cli/contacts.h"

namespace palpate::viewer {

Session::Session(std::shared_ptr<const Content> content, std::size_t remembered, const std::string& record)
    : content_(std::move(content)), rig_(*content_), hand_(*content_, rig_), history_(remembered) {
  if (!record.empty()) rig_.record(record);
  if (!content_->arguments.stepped) rig_.start();
}

void Session::advance() {
  if (paused_) return;
  if (rig_.runs()) return remember();
  for (unsigned i = 0; i < content_->arguments.ticks_per_frame && !finished(); ++i) step();
}

void Session::step() {
  hand_.before_step(ticks_);
  rig_.step();
  remember();
  ++ticks_;
}

void Session::pause(bool on) {
  if (on) rig_.stop();
  if (!on && !content_->arguments.stepped) rig_.start();
  paused_ = on;
}

bool Session::finished() const {
  const cli::Motion* replay = content_->arguments.replay.get();
  return replay && !rig_.has_device() && ticks_ >= replay->poses().size();
}

FrameState Session::state() const {
  FrameState state{};
  state.contacts = rig_.contacts();
  for (std::size_t i = 0; i < state.contacts.lmd_count; ++i)
    state.lmds.push_back(cli::lmd_at(state.contacts, i));
  state.tool = rig_.tool();
  if (rig_.has_simulated_hand()) state.wanted = hand_.wanted();
  if (rig_.has_device()) state.device = rig_.device_state();
  if (rig_.has_device()) state.device_info = rig_.device_info();
  state.servo = rig_.servo();
  state.recording = rig_.recording();
  state.cutoff = rig_.settings().cutoff;
  state.runs = rig_.runs();
  state.paused = paused_;
  state.simulated = rig_.has_simulated_hand();
  state.seconds = history_.size() > 0 ? history_.newest().seconds : 0.0;
  return state;
}

void Session::remember() {
  const plp_contacts contacts = rig_.contacts();
  cli::Tick tick{};
  tick.seconds = rig_.seconds();
  const cli::Motion* replay = content_->arguments.replay.get();
  if (replay && !rig_.has_device())
    tick.seconds = replay->poses()[std::min<std::size_t>(ticks_, replay->poses().size() - 1)].seconds;
  tick.lmds = contacts.set_count;
  tick.min_distance = contacts.min_distance;
  tick.wrench = contacts.wrench;
  // With a device a step does more than to find its wrench: it simulates a hand, or talks to a driver.
  tick.local_us = rig_.has_device() ? contacts.search_us : rig_.step_us();
  tick.work = contacts.work;
  tick.overlap = contacts.overlap != 0;
  history_.add(tick);
}

}  // namespace palpate::viewer
