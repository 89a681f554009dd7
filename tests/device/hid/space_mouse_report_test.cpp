#include "engine/device/hid/space_mouse_report.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace palpate {
namespace {

using Report = std::vector<std::uint8_t>;

TEST(SpaceMouseReport, OlderDevicesTellMotionAndTurnApart) {
  SpaceMouseReport report;
  EXPECT_TRUE(report.take(Report{1, 0x5E, 0x01, 0xA2, 0xFE, 10, 0}));
  EXPECT_TRUE(report.take(Report{2, 1, 0, 0xFF, 0xFF, 0, 1}));
  EXPECT_EQ(report.axes, (std::array<int, 6>{350, -350, 10, 1, -1, 256}));
}

TEST(SpaceMouseReport, NewerDevicesTellAllAtOnce) {
  SpaceMouseReport report;
  EXPECT_TRUE(report.take(Report{1, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 0xFA, 0xFF}));
  EXPECT_EQ(report.axes, (std::array<int, 6>{1, 2, 3, 4, 5, -6}));
}

TEST(SpaceMouseReport, DeflectionBeyondTheFullOneIsTheFullOne) {
  SpaceMouseReport report;
  EXPECT_TRUE(report.take(Report{1, 0xFF, 0x7F, 0, 0x80, 0, 0}));
  EXPECT_EQ(report.axes, (std::array<int, 6>{350, -350, 0, 0, 0, 0}));
}

TEST(SpaceMouseReport, ButtonsLeaveTheCapAsItIs) {
  SpaceMouseReport report;
  EXPECT_TRUE(report.take(Report{1, 9, 0, 0, 0, 0, 0}));
  EXPECT_TRUE(report.take(Report{3, 0x02, 0x01}));
  EXPECT_EQ(report.buttons, 0x0102u);
  EXPECT_TRUE(report.take(Report{3, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(report.buttons, 0x04030201u);
  EXPECT_EQ(report.axes[0], 9);
}

TEST(SpaceMouseReport, OtherReportsChangeNothing) {
  SpaceMouseReport report;
  for (const Report& other : {Report{}, Report{1}, Report{1, 2, 3}, Report{2, 0, 0, 0, 0, 0},
                              Report{0x17, 90}, Report{4, 1, 1, 1, 1, 1, 1}}) {
    EXPECT_FALSE(report.take(other));
  }
  EXPECT_EQ(report.axes, (std::array<int, 6>{}));
  EXPECT_EQ(report.buttons, 0u);
}

TEST(SpaceMouseReport, NoiseLeavesEveryAxisInItsRange) {
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937_64 random(kSeed);
  SpaceMouseReport report;
  for (int i = 0; i < 100'000; ++i) {
    Report noise(random() % 20);
    for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random());
    if (!noise.empty()) noise[0] &= 3;
    report.take(noise);
    for (const int axis : report.axes) ASSERT_LE(std::abs(axis), SpaceMouseReport::kFullDeflection);
  }
}

}  // namespace
}  // namespace palpate
