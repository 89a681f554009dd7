#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

#include "engine/device/hid/ohhp.h"
#include "engine/device/hid/ohhp_features.h"
#include "engine/device/hid/ohhp_sample.h"
#include "engine/device/hid/ohhp_wrench.h"
#include "samples/hid_device/report.h"

// The engine's reports against those of the reference device, which shares no code with it.
namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 20261;

class OhhpReports : public testing::Test {
 protected:
  void SetUp() override { SCOPED_TRACE(testing::Message() << "seed " << kSeed); }

  double within(double most) { return std::uniform_real_distribution<double>(-most, most)(random_); }
  std::uint32_t bits() { return static_cast<std::uint32_t>(random_()); }
  hid_device::Vector vector(double most) { return {within(most), within(most), within(most)}; }

  std::vector<std::uint8_t> noise(std::size_t size) {
    std::vector<std::uint8_t> bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(bits());
    return bytes;
  }

  hid_device::Sample sample() {
    hid_device::Sample made;
    made.flags = static_cast<std::uint8_t>(bits() & 0x7F);
    made.sequence = static_cast<std::uint16_t>(bits());
    made.time_us = bits();
    made.motion.position = vector(0.5);
    made.motion.velocity = vector(5.0);
    made.motion.turn_rate = vector(60.0);
    std::normal_distribution<double> normal;
    double squares = 0.0;
    for (double& part : made.motion.orientation) squares += std::pow(part = normal(random_), 2);
    for (double& part : made.motion.orientation) part /= std::sqrt(squares);
    made.buttons = static_cast<std::uint16_t>(bits());
    made.temperature = static_cast<std::uint8_t>(bits());
    return made;
  }

  std::mt19937_64 random_{kSeed};
};

void expect_near(const DVec3& got, const hid_device::Vector& wanted, double slack) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(got[axis], wanted[static_cast<std::size_t>(axis)], slack);
}

TEST_F(OhhpReports, ChecksumIsTheStandardsOwn) {
  constexpr std::string_view kCheck = "123456789";
  const std::vector<std::uint8_t> bytes(kCheck.begin(), kCheck.end());
  EXPECT_EQ(crc8(bytes), 0xDF);  // the check value of CRC-8/AUTOSAR
}

TEST_F(OhhpReports, SamplesArriveAsTheyWereSent) {
  for (int i = 0; i < 20'000; ++i) {
    const hid_device::Sample sent = sample();
    const auto got = parse_ohhp_sample(hid_device::report_of(sent));
    ASSERT_TRUE(got) << "sample " << i;
    EXPECT_EQ(got->flags, sent.flags);
    EXPECT_EQ(got->sequence, sent.sequence);
    EXPECT_EQ(got->time_us, sent.time_us);
    EXPECT_EQ(got->buttons, sent.buttons);
    EXPECT_DOUBLE_EQ(got->temperature, sent.temperature / 255.0);
    expect_near(got->tool.position, sent.motion.position, 0.51e-7);
    expect_near(got->tool.linear_velocity, sent.motion.velocity, 0.51e-6);
    expect_near(got->tool.angular_velocity, sent.motion.turn_rate, 0.51e-6);
    const auto& q = sent.motion.orientation;
    EXPECT_NEAR(glm::dot(got->tool.orientation, DQuat(q[3], q[0], q[1], q[2])), 1.0, 1e-8);
    ASSERT_FALSE(HasFailure()) << "sample " << i;
  }
}

TEST_F(OhhpReports, WrenchesArriveAsTheyWereSent) {
  for (int i = 0; i < 20'000; ++i) {
    const hid_device::Vector force = vector(100.0);
    const hid_device::Vector torque = vector(10.0);
    const auto answered = static_cast<std::uint16_t>(bits());
    const OhhpWrench sent{
        {{force[0], force[1], force[2]}, {torque[0], torque[1], torque[2]}}, answered, 0.01};
    const auto got = hid_device::parse_wrench(ohhp_report(sent));
    ASSERT_TRUE(got);
    EXPECT_EQ(got->answered, answered);
    EXPECT_EQ(got->time_to_live_ms, 10);
    expect_near(sent.wrench.force, got->force, 0.51e-6);
    expect_near(sent.wrench.torque, got->torque, 0.51e-6);
    ASSERT_FALSE(HasFailure()) << "wrench " << i;
  }
}

TEST_F(OhhpReports, NumbersThatDoNotFitSaturateAndNoNumberIsNone) {
  const OhhpWrench wild{{{1e9, -1e9, std::nan("")}, {HUGE_VAL, -HUGE_VAL, 0.0}}, 1, 1e9};
  const auto got = hid_device::parse_wrench(ohhp_report(wild));
  ASSERT_TRUE(got);
  const double most = 1e-6 * std::numeric_limits<std::int32_t>::max();
  expect_near({most, -most, 0.0}, got->force, 2e-6);
  expect_near({most, -most, 0.0}, got->torque, 2e-6);
  EXPECT_EQ(got->time_to_live_ms, 0xFFFF);
}

TEST_F(OhhpReports, CommandsArriveAsTheyWereSent) {
  const auto got = hid_device::parse_command(ohhp_report(OhhpCommand{OhhpCommand::Kind::kSetWatchdog, 12}));
  ASSERT_TRUE(got);
  EXPECT_EQ(got->command, hid_device::Command::kSetWatchdog);
  EXPECT_EQ(got->milliseconds, 12);
}

TEST_F(OhhpReports, AnyWrongBitsInARowOfEightAreFound) {
  for (int i = 0; i < 20'000; ++i) {
    auto report = hid_device::report_of(sample());
    const std::uint32_t wrong = 1 + bits() % 255;
    const std::uint32_t first = bits() % (8 * ohhp::kSampleSize - 7);
    for (std::uint32_t bit = 0; bit < 8; ++bit) {
      if (wrong >> bit & 1) report[(first + bit) / 8] ^= static_cast<std::uint8_t>(0x80 >> (first + bit) % 8);
    }
    ASSERT_FALSE(parse_ohhp_sample(report)) << "report " << i;
  }
}

TEST_F(OhhpReports, EveryOtherLengthAndKindIsRefused) {
  const auto report = hid_device::report_of(sample());
  const std::span<const std::uint8_t> bytes(report);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(parse_ohhp_sample(bytes.first(size))) << size;
    EXPECT_FALSE(parse_ohhp_features(bytes.first(size))) << size;
  }
  EXPECT_FALSE(parse_ohhp_sample(hid_device::report_of(hid_device::Features{})));
  EXPECT_FALSE(parse_ohhp_features(report));
}

// With a right checksum, so that what stands behind it is reached.
TEST_F(OhhpReports, NoiseIsRefusedOrIsAFiniteSample) {
  int accepted = 0;
  for (int i = 0; i < 100'000; ++i) {
    auto bytes = noise(i % 4 == 0 ? bits() % 100 : ohhp::kSampleSize);
    EXPECT_FALSE(bytes.size() != ohhp::kSampleSize && parse_ohhp_sample(bytes));
    EXPECT_FALSE(parse_ohhp_features(bytes));
    if (bytes.size() != ohhp::kSampleSize) continue;
    bytes[0] = ohhp::kSampleId;
    if (i % 2 == 0) bytes[32] = 0, bytes[33] = 0, bytes[34] = 0, bytes[35] = 0x40;  // w is 1
    if (i % 2 == 0) std::fill_n(bytes.begin() + 20, 12, std::uint8_t{0});
    ohhp::seal(bytes);
    const auto parsed = parse_ohhp_sample(bytes);
    if (!parsed) continue;
    ++accepted;
    ASSERT_NEAR(glm::length(parsed->tool.orientation), 1.0, 1e-12);
    ASSERT_LE(glm::length(parsed->tool.position), 400.0);
  }
  EXPECT_GT(accepted, 1000);
}

TEST_F(OhhpReports, AnOrientationThatIsNoneIsRefused) {
  hid_device::Sample none = sample();
  none.motion.orientation = {0.0, 0.0, 0.0, 0.9};
  EXPECT_FALSE(parse_ohhp_sample(hid_device::report_of(none)));
}

TEST_F(OhhpReports, FeaturesAreWhatTheDeviceSays) {
  hid_device::Features sent;
  sent.traits = 3;
  sent.actuated = 0x07;
  sent.max_force = 7.9;
  const auto got = parse_ohhp_features(hid_device::report_of(sent));
  ASSERT_TRUE(got) << got.error().message;
  const OhhpFeatures& features = got.value();
  EXPECT_TRUE(features.has(OhhpFeatures::kHasDeadMan) && features.has(OhhpFeatures::kWantsCalibration));
  EXPECT_EQ(features.capabilities.sensed, kAllDegrees);
  EXPECT_EQ(features.capabilities.actuated, kTranslations);
  EXPECT_EQ(features.capabilities.buttons, 2);
  EXPECT_NEAR(features.limits.max_force, 7.9, 1e-9);
  EXPECT_NEAR(features.limits.continuous_force, 3.95, 1e-9);
  EXPECT_EQ(features.limits.max_torque, 0.0) << "there are no motors for it";
  EXPECT_EQ(features.limits.max_stiffness, 1000.0);
  EXPECT_NEAR(features.limits.max_damping, 5.0, 1e-12);
  EXPECT_NEAR(features.limits.position_resolution, 1e-7, 1e-15);
  EXPECT_EQ(features.limits.update_rate, 1000.0);
  EXPECT_NEAR(features.watchdog, 0.02, 1e-12);
  EXPECT_NEAR(features.limits.workspace.low.y, -0.1, 1e-12);
  EXPECT_NEAR(features.limits.workspace.high.z, 0.1, 1e-12);
}

TEST_F(OhhpReports, LimitsBeyondOursAreLowered) {
  hid_device::Features giant;
  giant.max_force = 1e6;
  giant.max_torque = 1e3;
  giant.watchdog_ms = 60'000;
  const auto got = parse_ohhp_features(hid_device::report_of(giant));
  ASSERT_TRUE(got);
  EXPECT_EQ(got.value().limits.max_force, 50.0);
  EXPECT_LE(got.value().limits.continuous_force, 50.0);
  EXPECT_EQ(got.value().limits.max_torque, 2.0);
  EXPECT_EQ(got.value().watchdog, 0.1);
}

TEST_F(OhhpReports, FeaturesThatAreNotSafeAreRefusedWithTheReason) {
  hid_device::Features slow;
  slow.rate_hz = 100;
  hid_device::Features reckless;
  reckless.watchdog_ms = 0;
  auto newer = hid_device::report_of(hid_device::Features{});
  newer[5] = 2;
  ohhp::seal(newer);
  auto foreign = newer;
  foreign[1] = 'X';
  ohhp::seal(foreign);
  const auto reason = [](std::span<const std::uint8_t> report) {
    const auto parsed = parse_ohhp_features(report);
    return parsed ? std::string() : parsed.error().message;
  };
  EXPECT_NE(reason(hid_device::report_of(slow)).find("200 samples"), std::string::npos);
  EXPECT_NE(reason(hid_device::report_of(reckless)).find("watchdog"), std::string::npos);
  EXPECT_NE(reason(newer).find("version 2"), std::string::npos);
  EXPECT_NE(reason(foreign).find("OHHP"), std::string::npos);
}

}  // namespace
}  // namespace palpate
