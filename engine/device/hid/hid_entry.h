#pragma once

#include <cstdint>
#include <string>

#include "engine/device/hid/hid_name.h"

namespace palpate {

// What can be done with a device on the bus.
enum class HidKind : std::uint8_t {
  kSpaceMouse,
  kOhhp,    // a haptic device that speaks the open protocol
  kVendor,  // a haptic device that speaks a closed one
  kOther,   // a keyboard, and the like
};

// A device on the bus, whether or not it can be opened.
struct HidEntry {
  HidName name;
  HidKind kind = HidKind::kOther;
  std::string product;     // as its maker calls it
  std::string path;        // of its node in /dev
  bool permitted = false;  // to read and write the node
  bool taken = false;      // by a connection of this process
};

}  // namespace palpate
