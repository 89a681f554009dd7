#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace palpate::capi {

// Bytes of UTF-8 `text` that fit into `room` without cutting a character apart.
inline std::size_t fitting_length(const std::string& text, std::size_t room) {
  if (text.size() <= room) return text.size();
  std::size_t length = room;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  return length;
}

// Terminated, and cut where it is too long.
template <std::size_t kSize>
void store_text(const std::string& text, char (&out)[kSize]) {
  const std::size_t length = fitting_length(text, kSize - 1);
  std::copy_n(text.data(), length, out);
  out[length] = 0;
}

}  // namespace palpate::capi
