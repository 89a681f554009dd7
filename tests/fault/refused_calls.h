#pragma once

#include <chrono>
#include <functional>

namespace palpate::test {

// While one lives, this process gets no thread from the n-th request on, counted from 1.
class NoThreadsFrom {
 public:
  explicit NoThreadsFrom(int nth);
  ~NoThreadsFrom();
  NoThreadsFrom(const NoThreadsFrom&) = delete;
  NoThreadsFrom& operator=(const NoThreadsFrom&) = delete;
};

// Called in the n-th fopen() from now on, counted from 1, before it opens the file.
void before_opening(int nth, std::function<void()> action);

// From now on these clocks of this process are wrong by so much, for those who read them and who wait for
// them.
void set_monotonic_clock_ahead(std::chrono::nanoseconds by);
void set_wall_clock_ahead(std::chrono::nanoseconds by);

}  // namespace palpate::test
