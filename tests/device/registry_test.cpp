#include "engine/device/registry.h"

#include <gtest/gtest.h>

#include <string>

#include "engine/device/simulated/simulated_phantom.h"

namespace palpate {
namespace {

// A second scheme: one device that exists but cannot be opened.
class UnpluggedBackend final : public DeviceBackend {
 public:
  std::string_view scheme() const override { return "cable"; }
  std::vector<DeviceInfo> enumerate() const override { return {{{"cable:arm", "Arm", "7"}, {}, {}}}; }
  Result<std::unique_ptr<Device>> open(std::string_view name) const override {
    if (name != "arm") return std::unique_ptr<Device>();
    return Error{ErrorCode::kUnsupported, "the arm is unplugged"};
  }
};

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(DeviceRegistry, OpensEverythingItEnumerates) {
  const DeviceRegistry registry = DeviceRegistry::standard();
  const auto found = registry.enumerate();
  ASSERT_GE(found.size(), 2u);
  EXPECT_EQ(found.front().identity.uri, kDefaultDeviceUri);
  for (const DeviceInfo& listed : found) {
    if (!contains(listed.identity.uri, "sim:")) continue;  // hardware may be there or not
    const auto opened = registry.open(listed.identity.uri);
    ASSERT_TRUE(opened) << listed.identity.uri;
    EXPECT_EQ(opened.value()->info().capabilities.actuated, listed.capabilities.actuated);
    EXPECT_EQ(opened.value()->info().limits.max_force, listed.limits.max_force);
    EXPECT_EQ(opened.value()->info().identity.uri, listed.identity.uri);
    EXPECT_EQ(opened.value()->info().identity.name, listed.identity.name);
  }
}

TEST(DeviceRegistry, OpensTheDefaultWhereNoneIsNamed) {
  const auto opened = DeviceRegistry::standard().open("");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened.value()->info().identity.uri, "sim:premium6dof");
}

TEST(DeviceRegistry, KnowsThatATouchHasNoTorque) {
  const auto opened = DeviceRegistry::standard().open("sim:touch");
  ASSERT_TRUE(opened);
  const DeviceInfo& info = opened.value()->info();
  EXPECT_EQ(info.capabilities.sensed, kAllDegrees);
  EXPECT_EQ(info.capabilities.actuated, kTranslations);
  EXPECT_EQ(info.limits.max_torque, 0.0);
  EXPECT_GT(info.limits.max_force, 0.0);
}

TEST(DeviceRegistry, NamesWhatExistsWhenAskedForWhatDoesNot) {
  DeviceRegistry registry = DeviceRegistry::standard();
  registry.add(std::make_unique<UnpluggedBackend>());
  for (const char* uri : {"sim:spoon", "sim:", "sim", "usb:touch", ":", "cable:leg", "SIM:touch"}) {
    const auto opened = registry.open(uri);
    ASSERT_FALSE(opened) << uri;
    EXPECT_EQ(opened.error().code, ErrorCode::kDevice);
    const std::string& message = opened.error().message;
    for (const char* part : {uri, "sim:premium6dof", "sim:touch", "cable:arm"}) {
      EXPECT_TRUE(contains(message, part)) << message << " lacks " << part;
    }
  }
}

// The handle moves away from where it was placed, and the sample tells as many ticks later as were asked for.
int samples_late(Device& device) {
  auto& phantom = dynamic_cast<SimulatedPhantom&>(device);
  phantom.set_grip(Grip::kReleased);
  for (int late = 0; late < 20; ++late) {
    phantom.write({DVec3(1.0, 0.0, 0.0), DVec3(0.0)});
    phantom.step(1e-2);
    if (phantom.read().tool.position.x > 0.0) return late;
  }
  return -1;
}

TEST(DeviceRegistry, OpensASimulatedDeviceWithDelay) {
  const DeviceRegistry registry = DeviceRegistry::standard();
  for (int delay = 0; delay <= 8; ++delay) {
    const auto opened = registry.open("sim:touch?delay=" + std::to_string(delay));
    ASSERT_TRUE(opened) << delay;
    EXPECT_EQ(samples_late(*opened.value()), delay);
  }
  const auto prompt = registry.open("sim:premium6dof");
  ASSERT_TRUE(prompt);
  EXPECT_EQ(samples_late(*prompt.value()), 0);
}

TEST(DeviceRegistry, RefusesParametersThatASimulatedDeviceHasNot) {
  for (const char* parameters : {"delay", "delay=", "delay=-1", "delay=9", "delay=1.5", "delay=1 ", "delay=x",
                                 "delay=99999999999", "speed=1", "delay=1&delay=2"}) {
    const auto opened = DeviceRegistry::standard().open(std::string("sim:touch?") + parameters);
    ASSERT_FALSE(opened) << parameters;
    EXPECT_EQ(opened.error().code, ErrorCode::kInvalidArgument);
    EXPECT_TRUE(contains(opened.error().message, parameters)) << opened.error().message;
  }
}

TEST(DeviceRegistry, PassesOnWhyABackendCannotOpen) {
  DeviceRegistry registry = DeviceRegistry::standard();
  registry.add(std::make_unique<UnpluggedBackend>());
  const auto opened = registry.open("cable:arm");
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(opened.error().message, "the arm is unplugged");
}

}  // namespace
}  // namespace palpate
