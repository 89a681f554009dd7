#pragma once

#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/device/hid/hid_connection.h"
#include "engine/device/hid/hid_entry.h"
#include "engine/device/hid/hid_name.h"

// The devices that are plugged in now. From any thread; hidapi's functions that are for one thread at a time
// are called here alone, behind a lock.
namespace palpate::hid_bus {

// One entry a device node, in the order of their paths.
std::vector<HidEntry> entries();

// The first device of that name and kind that nobody in this process has. A null pointer if none is plugged
// in; the error tells why none can be had.
Result<std::shared_ptr<HidConnection>> connect(const HidName& name, HidKind kind);

// For HidConnection: the node may be connected to again.
void give_back(const std::string& path);

}  // namespace palpate::hid_bus
