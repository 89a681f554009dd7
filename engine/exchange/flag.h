#pragma once

#include <atomic>

namespace palpate {

// One bit between threads.
class Flag {
 public:
  // Acquire: what was done before the flag was raised is seen.
  bool raised() const { return raised_.load(std::memory_order_acquire); }

  // What the flag was before. Acquire and release: of two threads that change it, the second sees what the
  // first did before.
  bool raise() { return raised_.exchange(true, std::memory_order_acq_rel); }
  bool lower() { return raised_.exchange(false, std::memory_order_acq_rel); }

 private:
  std::atomic<bool> raised_{false};
};

}  // namespace palpate
