#include "tests/device/hid/mock_ohhp.h"

#include <chrono>
#include <cmath>

namespace palpate::test {
namespace {

MockIdentity identity_of(const std::string& serial) {
  const auto descriptor = hid_device::report_descriptor();
  return {0x1209, 0x0001, serial, "Mock Haptic", Report(descriptor.begin(), descriptor.end())};
}

template <std::size_t kSize>
Report report_of(const std::array<std::uint8_t, kSize>& bytes) {
  return Report(bytes.begin(), bytes.end());
}

}  // namespace

MockOhhp::MockOhhp(const std::string& serial, const hid_device::Features& features)
    : MockNode(identity_of(serial)), device_(features), features_(report_of(device_.features())) {}

MockOhhp::~MockOhhp() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  if (thread_.joinable()) thread_.join();
}

void MockOhhp::start() {
  thread_ = std::thread([this] { run(); });
}

// By absolute times: a thread that was held up makes up for it.
void MockOhhp::run() {
  constexpr std::chrono::milliseconds kPeriod(1);
  auto due = std::chrono::steady_clock::now();
  while (true) {
    std::this_thread::sleep_until(due += kPeriod);
    const std::vector<Report> wrenches = received();
    const std::lock_guard lock(mutex_);
    if (stopped_) return;
    for (const Report& wrench : wrenches) refused_ += device_.take_wrench(wrench) ? 0 : 1;
    sample();
  }
}

void MockOhhp::sample() {
  auto report = device_.step();
  const hid_device::Vector& force = device_.force();
  log_.push_back({device_.sequence(), std::hypot(force[0], force[1], force[2]), device_.armed()});
  if (paused_) return;
  if (swallowed_ > 0) {
    --swallowed_;
    return;
  }
  if (damaged_ > 0) {
    --damaged_;
    report[10] ^= 0x20;
  }
  send(report);
}

std::vector<MockOhhp::Step> MockOhhp::log() {
  const std::lock_guard lock(mutex_);
  return log_;
}

std::size_t MockOhhp::steps() {
  const std::lock_guard lock(mutex_);
  return log_.size();
}

std::size_t MockOhhp::refused() {
  const std::lock_guard lock(mutex_);
  return refused_;
}

std::uint16_t MockOhhp::watchdog_ms() {
  const std::lock_guard lock(mutex_);
  return watchdog_ms_;
}

void MockOhhp::damage(int samples) {
  const std::lock_guard lock(mutex_);
  damaged_ = samples;
}

void MockOhhp::swallow(int samples) {
  const std::lock_guard lock(mutex_);
  swallowed_ = samples;
}

void MockOhhp::pause(bool paused) {
  const std::lock_guard lock(mutex_);
  paused_ = paused;
}

bool MockOhhp::get_feature(std::uint8_t id, Report& report) {
  constexpr std::uint8_t kFeaturesId = 3;
  const std::lock_guard lock(mutex_);
  report = features_;
  return id == kFeaturesId && !report.empty();
}

bool MockOhhp::set_feature(std::span<const std::uint8_t> report) {
  const std::lock_guard lock(mutex_);
  if (!device_.take_command(report)) return false;
  const auto command = hid_device::parse_command(report);
  if (command->command == hid_device::Command::kSetWatchdog) watchdog_ms_ = command->milliseconds;
  return true;
}

void MockOhhp::answer_features(Report report) {
  const std::lock_guard lock(mutex_);
  features_ = std::move(report);
}

}  // namespace palpate::test
