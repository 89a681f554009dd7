#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/device/device.h"
#include "engine/device/openhaptics/hd_abi.h"
#include "engine/device/openhaptics/hd_facts.h"
#include "engine/exchange/flag.h"
#include "engine/exchange/loan.h"
#include "engine/exchange/triple_slot.h"

namespace palpate {

class HdScheduler;

// A PHANToM that OpenHaptics reaches. The vendor's scheduler owns its loop: each of its ticks begins a frame,
// takes a sample, runs the servo that it carries, if any, sends the wrench and ends the frame. A servo that
// ticks elsewhere gets the newest sample and leaves its wrench for the next tick.
class HdDevice final : public Device, public ServoHost {
 public:
  static Result<std::unique_ptr<Device>> open(HdScheduler& scheduler, std::string name, std::string uri);
  ~HdDevice() override;

  const DeviceInfo& info() const override { return facts_.info; }
  DeviceState read() override;
  void write(const DeviceWrench& wrench) override;
  void step(double) override {}
  std::optional<DeviceState> glance() override;
  bool calibrate() override;
  std::string advice(DeviceCondition condition) const override;
  ServoHost* servo_host() override { return this; }

  double rate_hz() const override { return facts_.info.limits.update_rate; }
  void carry(ServoTask& task) override { rider_.lend(task); }
  void put_down() override { rider_.take_back(); }

  // The scheduler's, one thread at a time. While it rests:
  Status connect();
  void disconnect();
  bool take_up(double time);  // a lost device; false: it still does not answer
  // At any time:
  bool is_lost() const { return lost_.raised(); }
  // While it is lost:
  bool is_connected() const { return handle_ != hd::kNoDevice; }
  double unsought(double time) const { return time - sought_; }  // s since the last attempt to take it up
  // On the library's thread. `silent`: no force.
  void tick(double dt, bool silent);

 private:
  struct Shown {
    DeviceState state;
    double time = 0.0;             // s, of the tick
    hd::ErrorCode last_error = 0;  // that is none of the known ones
  };

  HdDevice(HdScheduler& scheduler, std::string name, std::string uri);

  Status initialise();
  void configure();
  void sense(double time);
  void read_motion(RigidMotion& tool) const;
  std::uint32_t read_buttons() const;
  double read_temperature() const;
  void check_calibration();
  bool note_errors();
  void note(hd::ErrorCode code);
  void recover(double dt);
  void publish(double time, bool silent);
  void actuate(double dt, bool silent);
  void send(const DeviceWrench& wrench);
  DeviceWrench wrench_to_send(double dt, bool silent);
  void set_output(bool on);
  void update_calibration();
  bool may_push() const { return condition_ == DeviceCondition::kReady && state_.calibrated; }

  HdScheduler& scheduler_;
  const hd::Functions& call_;
  const std::string name_;
  const std::string uri_;
  HdFacts facts_;
  double most_force_ = 0.0;   // N; no more than info() says, even if another device has been taken up
  double most_torque_ = 0.0;  // N·m

  // While lost_ is raised the handle is the keeper's, otherwise the callback's.
  Flag lost_;
  hd::Handle handle_ = hd::kNoDevice;
  double sought_ = 0.0;

  // The callback's.
  DeviceState state_;
  DeviceCondition condition_ = DeviceCondition::kReady;
  double let_go_for_ = 0.0;  // s until it may push again after a fault
  hd::ErrorCode last_error_ = 0;
  bool output_ = false;
  int update_style_ = 0;       // of the calibration after this frame; 0: none
  double since_update_ = 1e9;  // s
  double order_age_ = 1e9;     // s
  std::uint64_t ticks_ = 0;

  Loan<ServoTask> rider_;
  Flag asked_to_calibrate_;
  TripleSlot<DeviceState> samples_;  // to whoever ticks
  TripleSlot<DeviceWrench> orders_;  // from there
  mutable TripleSlot<Shown> shown_;  // to all others
  mutable std::mutex asking_;        // guards the reader's side of shown_
};

}  // namespace palpate
