#pragma once

#include <cstddef>

namespace palpate::test {

// Threads of this process. One that has just been joined may still be among them for a moment.
std::size_t thread_count();

// The number that it comes to within a few seconds: `expected` if it ever does.
std::size_t settled_thread_count(std::size_t expected);

}  // namespace palpate::test
