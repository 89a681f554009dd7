#include "engine/device/hid/wrench_writer.h"

#include <algorithm>
#include <chrono>

#include "engine/base/own_thread.h"

namespace palpate {
namespace {

// Between two of the same command: samples that show its effect take a while to come back.
constexpr double kBetweenCommands = 20e3;  // µs

// A servo that was held up for this many watchdogs' times has ended: amplifiers that click need not click
// sooner.
constexpr int kEnd = 10;

}  // namespace

void WrenchWriter::start() {
  thread_ = std::thread([this] { run(); });
}

void WrenchWriter::stop() {
  if (!thread_.joinable()) return;
  stop_.raise();
  posted_.ring();
  thread_.join();
}

void WrenchWriter::post(const Order& order) {
  orders_.back() = order;
  orders_.publish();
  posted_.ring();
}

void WrenchWriter::hear(bool armed) {
  if (armed) {
    armed_.raise();
  } else {
    armed_.lower();
  }
}

void WrenchWriter::run() {
  begin_own_thread("palpate-hid-out");
  ask_for_priority(kDevicePriority);
  const auto patience = std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 * watchdog_));
  while (!stop_.raised()) {
    const bool rung = posted_.wait(patience);
    if (orders_.fetch()) {
      silences_ = 0;
      send(orders_.front());
    } else if (rung || armed_.raised()) {
      send(after_silence());
    }
  }
  commanded_.reset();
  send({});
}

WrenchWriter::Order WrenchWriter::after_silence() {
  silences_ = std::min(silences_ + 1, kEnd);
  Order nothing;
  nothing.answered = orders_.front().answered;
  nothing.engaged = orders_.front().engaged && silences_ < kEnd;
  return nothing;
}

void WrenchWriter::send(const Order& order) {
  const std::shared_ptr<HidConnection> connection = link_.connection();
  if (!connection || connection->given_up()) return;
  command(*connection, order.engaged);
  const auto report = ohhp_report(OhhpWrench{order.wrench, order.answered, watchdog_});
  if (!connection->out().write(report)) return connection->give_up();
  sent_.add(1);
}

void WrenchWriter::command(HidConnection& connection, bool engaged) {
  using Kind = OhhpCommand::Kind;
  if (calibrating_.lower()) connection.out().send_feature(ohhp_report(OhhpCommand{Kind::kCalibrate}));
  if (engaged == armed_.raised()) return;
  if (commanded_ && commanded_->elapsed_us() < kBetweenCommands) return;
  connection.out().send_feature(ohhp_report(OhhpCommand{engaged ? Kind::kArm : Kind::kDisarm}));
  commanded_.emplace();
}

}  // namespace palpate
