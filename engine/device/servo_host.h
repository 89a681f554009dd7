#pragma once

#include "engine/device/servo_task.h"

namespace palpate {

// Somebody else's loop that ticks a device, a vendor's scheduler, and takes a servo along: the servo runs
// between the sample and the wrench of one tick, so that neither is late.
class ServoHost {
 public:
  virtual double rate_hz() const = 0;

  // `task` runs in every tick until put_down(); one at a time.
  virtual void carry(ServoTask& task) = 0;

  // Returns when no tick runs the task any more.
  virtual void put_down() = 0;

 protected:
  ~ServoHost() = default;
};

}  // namespace palpate
