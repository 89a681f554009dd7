#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace palpate {

// Memory for when there is no other, for libraries that do not bear to be refused a little of it: where
// operator new would fail while a reserve lives, the reserve is given back, and whoever asked gets what he
// wanted after all. The work in hand is to be given up then: ask is_touched() at its end.
class MemoryReserve {
 public:
  enum class For {
    kThisThread,  // half of it is kept for destructors, which run once the next refusal has thrown
    kAllThreads,
  };

  MemoryReserve(std::size_t bytes, For whom);
  ~MemoryReserve();
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;

  bool is_touched() const;

 private:
  static void serve();
  static MemoryReserve* any_left();
  bool give_back();
  MemoryReserve*& list() const;

  std::array<std::unique_ptr<std::byte[]>, 2> halves_;
  const For whom_;
  MemoryReserve* next_ = nullptr;
};

}  // namespace palpate
