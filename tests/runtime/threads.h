#pragma once

#include <cstddef>

namespace palpate::test {

// Threads of this process.
std::size_t thread_count();

}  // namespace palpate::test
