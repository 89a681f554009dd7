#pragma once

#include <atomic>

namespace palpate {

// What can lie in a mailbox: in one at a time, once.
class Letter {
 public:
  virtual ~Letter() = default;

  Letter* next() const { return next_; }

 private:
  friend class Mailbox;
  Letter* next_ = nullptr;
};

// Letters from any threads to one reader. They are linked, not copied, so there is always room. Reading is
// wait-free; posting is, too, while only one thread posts.
class Mailbox {
 public:
  Mailbox() = default;
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  // The letter belongs to the reader until it has been taken.
  void post(Letter* letter) {
    // Relaxed: the exchange below decides, and what lies before is only linked, not read.
    Letter* newest = newest_.load(std::memory_order_relaxed);
    do {
      letter->next_ = newest;
      // Release: the reader must see the letter whole.
    } while (
        !newest_.compare_exchange_weak(newest, letter, std::memory_order_release, std::memory_order_relaxed));
  }

  // All letters, linked by next() in the order in which they were posted; null if there are none.
  Letter* take() {
    // Acquire: pairs with the release of every letter in the chain, because each exchange continues the one
    // before.
    Letter* newest = newest_.exchange(nullptr, std::memory_order_acquire);
    Letter* oldest = nullptr;
    while (newest) {
      Letter* const before = newest->next_;
      newest->next_ = oldest;
      oldest = newest;
      newest = before;
    }
    return oldest;
  }

 private:
  std::atomic<Letter*> newest_{nullptr};
};

}  // namespace palpate
