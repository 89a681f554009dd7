#pragma once

#include <atomic>
#include <chrono>
#include <thread>

namespace palpate {

// Lends a thing to one thread, which uses it now and then and waits for nobody. Whoever takes it back waits
// for the end of a use, and then knows that there will be no other. Lending and taking back are for one
// thread at a time.
template <class T>
class Loan {
 public:
  Loan() = default;
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;

  // Sequentially consistent, as the three below: the user says that it is busy before it looks, and whoever
  // takes back takes it away before it asks, so that at least one sees the other.
  void lend(T& thing) { lent_.store(&thing, std::memory_order_seq_cst); }

  void take_back() {
    lent_.store(nullptr, std::memory_order_seq_cst);
    while (busy_.load(std::memory_order_seq_cst)) std::this_thread::sleep_for(kLookAgain);
  }

  // The user's: calls use(thing) if there is one.
  template <class Use>
  void use(Use&& use) {
    busy_.store(true, std::memory_order_seq_cst);
    if (T* const thing = lent_.load(std::memory_order_seq_cst)) use(*thing);
    // Release: what was done to the thing is seen by whoever takes it back.
    busy_.store(false, std::memory_order_release);
  }

 private:
  static constexpr std::chrono::microseconds kLookAgain{50};

  std::atomic<T*> lent_{nullptr};
  std::atomic<bool> busy_{false};
};

}  // namespace palpate
