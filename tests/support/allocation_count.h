#pragma once

#include <cstdint>

namespace palpate::test {

// Allocations so far of this program and of the libraries that take their operator new from it. A program
// that links palpate_allocation_count has its operators replaced.
std::uint64_t allocation_count();

}  // namespace palpate::test
