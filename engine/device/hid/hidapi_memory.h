#pragma once

#include <cerrno>
#include <new>

namespace palpate {

// What a call of hidapi's gives, null for nothing. Of a lack of memory it says no more than that; errno does.
template <class Call>
auto* given_memory(Call call) {
  errno = 0;
  auto* const given = call();
  if (!given && errno == ENOMEM) throw std::bad_alloc();
  return given;
}

}  // namespace palpate
