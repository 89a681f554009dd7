#pragma once

namespace palpate {

// What is done in each tick of a servo, by whatever thread.
class ServoTask {
 public:
  virtual ~ServoTask() = default;

  // `dt`: seconds from one tick to the next, as asked for, or as they passed in a long pause. Neither
  // allocates, locks, logs, blocks nor throws.
  virtual void tick(double dt) noexcept = 0;
};

}  // namespace palpate
