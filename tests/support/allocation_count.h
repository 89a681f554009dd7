#pragma once

#include <cstdint>

namespace palpate::test {

// Allocations so far of this program and of the libraries that take their operator new from it. A program
// that links palpate_allocation_count has its operators replaced.
std::uint64_t allocation_count();

// As long as one lives, that program has no memory left: every allocation throws.
class AllocationFailure {
 public:
  AllocationFailure();
  ~AllocationFailure();
  AllocationFailure(const AllocationFailure&) = delete;
  AllocationFailure& operator=(const AllocationFailure&) = delete;
};

}  // namespace palpate::test
