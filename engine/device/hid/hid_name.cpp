#include "engine/device/hid/hid_name.h"

#include <charconv>
#include <cstdio>

namespace palpate {
namespace {

constexpr std::size_t kDigits = 4;
constexpr std::size_t kIdsLength = 2 * kDigits + 1;

bool parse_id(std::string_view text, std::uint16_t& id) {
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, id, 16);
  return text.size() == kDigits && read.ec == std::errc() && read.ptr == end;
}

}  // namespace

std::optional<HidName> HidName::parse(std::string_view text) {
  HidName name;
  if (text.size() < kIdsLength || text[kDigits] != ':') return std::nullopt;
  if (!parse_id(text.substr(0, kDigits), name.vendor)) return std::nullopt;
  if (!parse_id(text.substr(kDigits + 1, kDigits), name.product)) return std::nullopt;
  if (text.size() == kIdsLength) return name;
  if (text[kIdsLength] != ':' || text.size() == kIdsLength + 1) return std::nullopt;
  name.serial = text.substr(kIdsLength + 1);
  return name;
}

std::string HidName::text() const {
  char ids[kIdsLength + 1];
  std::snprintf(ids, sizeof ids, "%04x:%04x", vendor, product);
  return serial.empty() ? ids : std::string(ids) + ':' + serial;
}

}  // namespace palpate
