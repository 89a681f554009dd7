#pragma once

#include <cstdint>
#include <memory>

#include "engine/device/device.h"
#include "engine/device/freshness.h"
#include "engine/device/hid/hid_link.h"
#include "engine/device/hid/rate_control.h"
#include "engine/device/hid/space_mouse_report.h"
#include "engine/exchange/triple_slot.h"

namespace palpate {

// A cap that is pushed to move the tool, without force. The pose is integrated in the servo's own time, so
// that it is as smooth as the servo although the device reports 60 times a second.
class SpaceMouse final : public Device, private HidListener {
 public:
  explicit SpaceMouse(std::shared_ptr<HidConnection> connection);
  ~SpaceMouse() override { link_.stop(); }

  const DeviceInfo& info() const override { return info_; }
  DeviceState read() override;
  void write(const DeviceWrench&) override {}
  void step(double dt) override;

 private:
  struct Heard {
    SpaceMouseReport report;
    std::uint64_t count = 0;
    bool lost = false;
  };

  bool accept(HidConnection&) override;
  void take(std::span<const std::uint8_t> report) override { newest_.report.take(report); }
  void show() override;
  void lost() override;

  void publish();

  DeviceInfo info_;

  // The servo's.
  RateControl control_;
  Freshness heard_;
  double time_ = 0.0;
  std::uint64_t sequence_ = 0;

  Heard newest_;  // the reader's
  TripleSlot<Heard> to_servo_;
  HidLink link_;
};

}  // namespace palpate
