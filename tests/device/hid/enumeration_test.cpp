#include "tests/device/hid/hid_bench.h"
#include "tests/device/hid/mock_space_mouse.h"

namespace palpate::test {
namespace {

class HidEnumeration : public HidBench {};

std::string uris(const std::vector<DeviceInfo>& infos) {
  std::string all;
  for (const DeviceInfo& info : infos) all += info.identity.uri + ' ';
  return all;
}

TEST_F(HidEnumeration, AnEmptyBusHasNoDevices) {
  EXPECT_TRUE(backend_.enumerate().empty());
  const auto opened = backend_.open("1209:0001");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened.value(), nullptr);
}

TEST_F(HidEnumeration, DevicesAreListedByTheirUrisAndOthersAreNot) {
  bus_.plug(std::make_shared<MockSpaceMouse>(0x046D, 0xC626));
  plug_ohhp("A1");
  bus_.plug(
      std::make_shared<MockNode>(MockIdentity{0x046D, 0xC31C, "", "Keyboard", {5, 1, 9, 6, 0xA1, 1, 0xC0}}));
  plug_ohhp("B2");
  EXPECT_EQ(uris(backend_.enumerate()), "hid:046d:c626 hid:1209:0001:A1 hid:1209:0001:B2 ");
  const DeviceInfo haptic = backend_.enumerate()[1];
  EXPECT_EQ(haptic.identity.name, "Mock Haptic");
  EXPECT_EQ(haptic.identity.serial, "A1");
  EXPECT_EQ(haptic.condition, DeviceCondition::kReady);
}

TEST_F(HidEnumeration, WhatIsPluggedInLaterIsFoundAndWhatIsPulledOutIsNot) {
  plug_ohhp("A1");
  EXPECT_EQ(uris(backend_.enumerate()), "hid:1209:0001:A1 ");
  const int first = number_;
  plug_ohhp("B2");
  bus_.unplug(first);
  EXPECT_EQ(uris(backend_.enumerate()), "hid:1209:0001:B2 ");
}

TEST_F(HidEnumeration, TheMakersOwnProtocolIsLeftToOpenHaptics) {
  bus_.plug(std::make_shared<MockNode>(
      MockIdentity{0x2988, 0x0302, "T1", "Touch", {6, 0, 0xFF, 9, 1, 0xA1, 1, 0xC0}}));
  const auto infos = backend_.enumerate();
  ASSERT_EQ(infos.size(), 1u);
  EXPECT_EQ(infos[0].condition, DeviceCondition::kWithheld);
  EXPECT_NE(infos[0].advice.find("use the OpenHaptics backend"), std::string::npos);
  EXPECT_NE(refusal("2988:0302").find("use the OpenHaptics backend"), std::string::npos);
}

TEST_F(HidEnumeration, WithoutPermissionThereIsTheRuleThatGivesIt) {
  plug_ohhp()->permit(false);
  const auto infos = backend_.enumerate();
  ASSERT_EQ(infos.size(), 1u);
  EXPECT_EQ(infos[0].condition, DeviceCondition::kWithheld);
  for (const std::string& text : {infos[0].advice, refusal("1209:0001")}) {
    EXPECT_NE(text.find(R"(KERNELS=="*:1209:0001.*", TAG+="uaccess")"), std::string::npos) << text;
    EXPECT_NE(text.find("/dev/hidraw0"), std::string::npos) << text;
  }
}

TEST_F(HidEnumeration, ADeviceIsOpenedOnceAndItsSiblingBesideIt) {
  plug_ohhp("A1");
  plug_ohhp("B2");
  auto any = open("1209:0001");
  auto other = open("1209:0001");
  ASSERT_TRUE(any && other);
  EXPECT_EQ(any->info().identity.uri, "hid:1209:0001:A1");
  EXPECT_EQ(other->info().identity.uri, "hid:1209:0001:B2");
  EXPECT_NE(refusal("1209:0001:A1").find("open already"), std::string::npos);
  EXPECT_EQ(backend_.enumerate()[0].condition, DeviceCondition::kCannotOpen);
  any.reset();
  EXPECT_EQ(refusal("1209:0001:A1"), "");
}

TEST_F(HidEnumeration, ADeviceIsWhatItsFeaturesSay) {
  hid_device::Features features;
  features.actuated = 0x07;
  features.max_force = 3.3;
  const auto mock = plug_ohhp("SN42", features);
  const auto device = open("1209:0001:SN42");
  ASSERT_TRUE(device);
  EXPECT_EQ(device->info().capabilities.actuated, kTranslations);
  EXPECT_NEAR(device->info().limits.max_force, 3.3, 1e-9);
  EXPECT_EQ(device->info().limits.max_torque, 0.0);
  EXPECT_EQ(mock->watchdog_ms(), 10) << "no longer than our own";
  EXPECT_GT(device->glance()->sequence, 0u) << "the first sample is awaited";
}

TEST_F(HidEnumeration, FeaturesThatAreNoneAreRefusedWithTheReason) {
  const auto mock = plug_ohhp();
  const auto bytes = hid_device::report_of(hid_device::Features{});
  Report report(bytes.begin(), bytes.end());
  report[20] ^= 1;
  mock->answer_features(report);
  EXPECT_NE(refusal("1209:0001").find("hid:1209:0001:SN42: its feature report 3 has a wrong checksum"),
            std::string::npos);
  mock->answer_features(Report(report.begin(), report.begin() + 20));
  EXPECT_NE(refusal("1209:0001").find("has 20 bytes"), std::string::npos);
  mock->answer_features({});
  EXPECT_NE(refusal("1209:0001").find("has 0 bytes"), std::string::npos);
  report.resize(100);
  mock->answer_features(report);
  EXPECT_NE(refusal("1209:0001").find("has 65 bytes"), std::string::npos);
  mock->answer_features(Report(bytes.begin(), bytes.end()));
  EXPECT_TRUE(open("1209:0001")) << "a refusal leaves the device free";
}

}  // namespace
}  // namespace palpate::test
