#pragma once

#include "tests/fault/journey.h"

namespace palpate::test {

// With the tool on a device, in the air above a floor.
void simulated_device(Journey& journey);
void openhaptics_device(Journey& journey);

// The same with one that is pulled out, is plugged in again, and is pulled out for good. Where hidapi is.
void hid_device(Journey& journey);
void space_mouse(Journey& journey);

}  // namespace palpate::test
