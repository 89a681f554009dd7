#pragma once

#include "tests/device/hid/mock_node.h"

namespace palpate::test {

// A SpaceMouse by its report descriptor: a multi-axis controller of the generic desktop page.
class MockSpaceMouse final : public MockNode {
 public:
  explicit MockSpaceMouse(std::uint16_t vendor = 0x256F, std::uint16_t product = 0xC635)
      : MockNode({vendor, product, "", "SpaceMouse", descriptor()}) {}

 private:
  static Report descriptor() {
    return {
        0x05, 0x01, 0x09, 0x08, 0xA1, 0x01,              // generic desktop, multi-axis controller
        0xA1, 0x00, 0x85, 0x01,                          // report 1
        0x16, 0xA2, 0xFE, 0x26, 0x5E, 0x01,              // -350 to 350
        0x09, 0x30, 0x09, 0x31, 0x09, 0x32,              // x y z
        0x75, 0x10, 0x95, 0x03, 0x81, 0x02, 0xC0,        // three times 16 bits
        0xA1, 0x00, 0x85, 0x02,                          // report 2
        0x09, 0x33, 0x09, 0x34, 0x09, 0x35,              // rotation about x y z
        0x75, 0x10, 0x95, 0x03, 0x81, 0x02, 0xC0, 0xC0,  // three times 16 bits
    };
  }
};

}  // namespace palpate::test
