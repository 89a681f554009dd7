#include "engine/device/registry.h"

#include <gtest/gtest.h>

#include <string>

namespace palpate {
namespace {

// A second scheme: one device that exists but cannot be opened.
class UnpluggedBackend final : public DeviceBackend {
 public:
  std::string_view scheme() const override { return "cable"; }
  std::vector<DeviceIdentity> enumerate() const override { return {{"cable:arm", "Arm", "7"}}; }
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
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.front().uri, kDefaultDeviceUri);
  for (const DeviceIdentity& identity : found) {
    const auto opened = registry.open(identity.uri);
    ASSERT_TRUE(opened) << identity.uri;
    EXPECT_EQ(opened.value()->info().identity.uri, identity.uri);
    EXPECT_EQ(opened.value()->info().identity.name, identity.name);
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
    EXPECT_EQ(opened.error().code, ErrorCode::kInvalidArgument);
    const std::string& message = opened.error().message;
    for (const char* part : {uri, "sim:premium6dof", "sim:touch", "cable:arm"}) {
      EXPECT_TRUE(contains(message, part)) << message << " lacks " << part;
    }
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
