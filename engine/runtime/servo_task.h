#pragma once

namespace palpate {

// What a servo thread does in each tick.
class ServoTask {
 public:
  virtual ~ServoTask() = default;

  // `dt`: seconds from one tick to the next, as asked for. Neither allocates, locks, logs, blocks nor throws.
  virtual void tick(double dt) noexcept = 0;
};

}  // namespace palpate
