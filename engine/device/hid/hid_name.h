#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace palpate {

// Which device: "046d:c626", or "1209:0001:SN42" where there may be several.
struct HidName {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string serial;  // empty: any

  // None for what is no such name.
  static std::optional<HidName> parse(std::string_view text);

  std::string text() const;

  // Whether a device of that name is meant.
  bool covers(const HidName& device) const {
    return vendor == device.vendor && product == device.product &&
           (serial.empty() || serial == device.serial);
  }
};

}  // namespace palpate
