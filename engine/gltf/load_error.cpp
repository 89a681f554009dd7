#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

constexpr std::size_t kLongestQuote = 100;

bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
}

}  // namespace

std::string quoted(std::string_view text) {
  std::size_t end = text.size();
  if (end > kLongestQuote) {
    end = kLongestQuote;
    while (end > 0 && continues_character(text[end])) --end;  // never half a UTF-8 character
  }
  std::string quote = "\"";
  for (const char byte : text.substr(0, end)) quote += static_cast<unsigned char>(byte) < 0x20u ? '?' : byte;
  return quote + (end < text.size() ? "…\"" : "\"");
}

}  // namespace palpate::gltf
