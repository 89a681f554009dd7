#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "engine/device/guarded_device.h"
#include "engine/device/hid/hid_backend.h"
#include "tests/device/hid/mock_bus.h"
#include "tests/device/hid/mock_ohhp.h"

namespace palpate::test {

// Waits until something holds that another thread brings about, half a minute at most.
template <class Condition>
bool wait_until(Condition&& condition) {
  for (int i = 0; i < 30'000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

// A bus, and the backend that looks at it.
class HidBench : public testing::Test {
 protected:
  std::shared_ptr<MockOhhp> plug_ohhp(const std::string& serial = "SN42",
                                      const hid_device::Features& features = {}) {
    auto device = std::make_shared<MockOhhp>(serial, features);
    device->start();
    number_ = bus_.plug(device);
    return device;
  }

  std::unique_ptr<Device> open(std::string_view name) {
    auto opened = backend_.open(name);
    EXPECT_TRUE(opened) << opened.error().message;
    return opened ? std::move(opened.value()) : nullptr;
  }

  std::string refusal(std::string_view name) {
    const auto opened = backend_.open(name);
    return opened ? "" : opened.error().message;
  }

  MockBus bus_;
  HidBackend backend_;
  int number_ = -1;  // of the node that was plugged in last
};

}  // namespace palpate::test
