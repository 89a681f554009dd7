#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "engine/base/clock.h"
#include "engine/device/device.h"
#include "engine/device/freshness.h"
#include "engine/device/hid/hid_link.h"
#include "engine/device/hid/ohhp_features.h"
#include "engine/device/hid/ohhp_sample.h"
#include "engine/device/hid/unwrapped.h"
#include "engine/device/hid/wrench_writer.h"
#include "engine/exchange/triple_slot.h"

namespace palpate {

// A haptic device that speaks the open protocol. Of the reader's thread, the writer's and the servo none
// waits for another.
class OhhpDevice final : public Device, private HidListener {
 public:
  // Asks the device what it is. The error tells why it is none to be used.
  static Result<std::unique_ptr<Device>> open(std::shared_ptr<HidConnection> connection);

  ~OhhpDevice() override;

  const DeviceInfo& info() const override { return info_; }
  DeviceState read() override;
  void engage(bool engaged) override { engaged_ = engaged; }
  void write(const DeviceWrench& wrench) override;
  void step(double dt) override { sending_.update(writer_.sent(), dt); }
  std::optional<DeviceState> glance() override;
  bool calibrate() override;
  std::string advice(DeviceCondition condition) const override;

 private:
  // A sample, and its number as the device counts.
  struct Heard {
    DeviceState state;
    std::uint16_t number = 0;
  };

  OhhpDevice(std::shared_ptr<HidConnection> connection, const OhhpFeatures& features);
  void await_first_sample();

  bool accept(HidConnection& connection) override;
  void take(std::span<const std::uint8_t> report) override;
  void show() override;
  void silent(double seconds) override;
  void lost() override;

  void count(const OhhpSample& sample);
  void publish(const Heard& heard);
  void publish(DeviceCondition condition);

  const OhhpFeatures features_;
  DeviceInfo info_;

  // The reader's.
  OhhpSample sample_;
  Unwrapped<std::uint16_t> sequence_;
  Unwrapped<std::uint32_t> time_us_;
  Stopwatch since_lost_;
  Heard newest_;
  bool fresh_ = false;  // sample_ was not shown yet

  // The servo's.
  bool engaged_ = false;
  std::uint16_t answered_ = 0;
  Freshness sending_;

  TripleSlot<Heard> to_servo_;
  TripleSlot<Heard> to_others_;
  std::mutex asking_;  // guards the readers' side of to_others_
  HidLink link_;
  WrenchWriter writer_;
};

}  // namespace palpate
