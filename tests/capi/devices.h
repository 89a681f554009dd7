#pragma once

#include "tests/capi/shapes.h"

namespace palpate::test {

// Owns a device.
class TestDevice {
 public:
  explicit TestDevice(const char* uri = nullptr) {
    EXPECT_EQ(plp_device_open(uri, &handle), PLP_OK) << plp_last_error();
  }
  ~TestDevice() { plp_device_release(handle); }
  TestDevice(const TestDevice&) = delete;
  TestDevice& operator=(const TestDevice&) = delete;

  plp_device_info info() const {
    plp_device_info read;
    plp_device_info_init(&read, sizeof read);
    EXPECT_EQ(plp_device_get_info(handle, &read), PLP_OK);
    return read;
  }

  plp_device_state state() const {
    plp_device_state read;
    plp_device_state_init(&read, sizeof read);
    EXPECT_EQ(plp_device_get_state(handle, &read), PLP_OK);
    return read;
  }

  plp_device handle = nullptr;
};

inline plp_hand_options hand_options() {
  plp_hand_options options;
  plp_hand_options_init(&options, sizeof options);
  return options;
}

inline plp_device_mapping device_mapping() {
  plp_device_mapping mapping;
  plp_device_mapping_init(&mapping, sizeof mapping);
  return mapping;
}

inline plp_safety_limits safety_limits() {
  plp_safety_limits limits;
  plp_safety_limits_init(&limits, sizeof limits);
  return limits;
}

}  // namespace palpate::test
