#pragma once

#include <string>

#include "engine/device/hid/hid_entry.h"

namespace palpate {

// Why a device cannot be opened and what its user can do about it; empty if it can.
std::string obstacle_to(const HidEntry& entry);

// The line of a udev rule that lets whoever sits at the machine use a device.
std::string udev_rule(const HidName& name);

}  // namespace palpate
