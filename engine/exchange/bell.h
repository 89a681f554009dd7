#pragma once

#include <errno.h>
#include <semaphore.h>
#include <time.h>

#include <chrono>

namespace palpate {

// Wakes a thread that waits. Ringing never blocks, so that a servo may; rings that nobody waited for are one.
class Bell {
 public:
  Bell() { sem_init(&rings_, 0, 0); }
  ~Bell() { sem_destroy(&rings_); }
  Bell(const Bell&) = delete;
  Bell& operator=(const Bell&) = delete;

  void ring() { sem_post(&rings_); }

  // False if it did not ring within the time.
  bool wait(std::chrono::nanoseconds longest) {
    const timespec until = after(longest);
    while (sem_clockwait(&rings_, CLOCK_MONOTONIC, &until) != 0) {
      if (errno != EINTR) return false;
    }
    while (sem_trywait(&rings_) == 0) {
    }
    return true;
  }

 private:
  static timespec after(std::chrono::nanoseconds wait) {
    constexpr long kSecond = 1'000'000'000;
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    const long nanoseconds = now.tv_nsec + wait.count() % kSecond;
    return {now.tv_sec + wait.count() / kSecond + nanoseconds / kSecond, nanoseconds % kSecond};
  }

  sem_t rings_;
};

}  // namespace palpate
