#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "samples/hid_device/haptic_device.h"
#include "tests/device/hid/mock_node.h"

namespace palpate::test {

// The reference device behind a mock node, with a thread of its own that samples a thousand times a second
// while it is plugged in, and what can go wrong with it.
class MockOhhp final : public MockNode {
 public:
  explicit MockOhhp(const std::string& serial = "SN42", const hid_device::Features& features = {});
  ~MockOhhp() override;

  // A sample of the device's.
  struct Step {
    std::uint16_t sequence = 0;
    double force = 0.0;  // N, that its motors gave
    bool armed = false;
  };

  void start();
  std::vector<Step> log();      // of all samples
  std::size_t steps();          // how many samples there were
  std::size_t refused();        // wrenches
  std::uint16_t watchdog_ms();  // that it was told

  // Does something to the device between two samples.
  template <class Change>
  void change(Change&& change) {
    const std::lock_guard lock(mutex_);
    change(device_);
  }

  // Faults, for so many samples from now on.
  void damage(int samples);
  void swallow(int samples);
  // Until told otherwise.
  void pause(bool paused);

  bool get_feature(std::uint8_t id, Report& report) override;
  bool set_feature(std::span<const std::uint8_t> report) override;
  void answer_features(Report report);  // instead of the device's own

 private:
  void run();
  void sample();

  std::mutex mutex_;  // guards what follows
  hid_device::HapticDevice device_;
  Report features_;
  std::vector<Step> log_;
  std::size_t refused_ = 0;
  std::uint16_t watchdog_ms_ = 0;
  int damaged_ = 0;
  int swallowed_ = 0;
  bool paused_ = false;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace palpate::test
