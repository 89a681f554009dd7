#pragma once

#include <cstddef>
#include <cstdint>

namespace palpate::test {

// While one lives, a request for memory of this process fails: the n-th from now on, counted from 1. With
// kFull there is then no memory but what is given back. Threads that are spared get theirs all the same.
class FailingAllocation {
 public:
  enum class Extent { kOnce, kFull };

  static constexpr std::uint64_t kNever = UINT64_MAX;

  FailingAllocation(std::uint64_t nth, Extent extent);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  static bool failed();                  // one was refused
  static void pass();                    // from now on none is
  static std::uint64_t requests_left();  // until the one that fails
};

// While one lives, this thread is given memory, and its requests are not counted.
class Spared {
 public:
  Spared();
  ~Spared();
  Spared(const Spared&) = delete;
  Spared& operator=(const Spared&) = delete;
};

// While one lives, a thread that is spared is not.
class Exposed {
 public:
  Exposed();
  ~Exposed();
  Exposed(const Exposed&) = delete;
  Exposed& operator=(const Exposed&) = delete;
};

// The largest request for memory, in bytes, since the last call of this function.
std::size_t take_largest_request();

// Blocks of memory that are in use; always 0 where a sanitizer keeps account of them.
std::int64_t live_blocks();

}  // namespace palpate::test
