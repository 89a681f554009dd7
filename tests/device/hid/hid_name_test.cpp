#include "engine/device/hid/hid_name.h"

#include <gtest/gtest.h>

#include "engine/device/hid/hid_advice.h"
#include "engine/device/hid/unwrapped.h"

namespace palpate {
namespace {

TEST(HidName, IsReadAndWrittenAlike) {
  for (const char* text : {"046d:c626", "1209:0001:SN42", "256f:c63a:a:b"}) {
    const auto name = HidName::parse(text);
    ASSERT_TRUE(name) << text;
    EXPECT_EQ(name->text(), text);
  }
  EXPECT_EQ(HidName::parse("046D:C626")->vendor, 0x046D);
  EXPECT_EQ(HidName::parse("046D:C626")->product, 0xC626);
}

TEST(HidName, IsNothingElse) {
  for (const char* text : {"", "046d", "046d:", "046d:c62", "46d:c626", "046d:c626:", "046d-c626",
                           "xyzw:c626", "046d:c6266", "+46d:c626", "046d:c626 ", "0x46:c626"}) {
    EXPECT_FALSE(HidName::parse(text)) << text;
  }
}

TEST(HidName, WithoutASerialCoversAnyDeviceOfItsKind) {
  const HidName any{0x1209, 1, ""};
  const HidName one{0x1209, 1, "SN42"};
  EXPECT_TRUE(any.covers(one));
  EXPECT_TRUE(one.covers(one));
  EXPECT_FALSE(one.covers(any));
  EXPECT_FALSE(any.covers({0x1209, 2, "SN42"}));
}

TEST(HidAdvice, ARefusalComesWithTheRuleThatLiftsIt) {
  HidEntry entry{{0x46d, 0xc626, ""}, HidKind::kSpaceMouse, "SpaceNavigator", "/dev/hidraw3", false, false};
  EXPECT_NE(obstacle_to(entry).find(R"(KERNELS=="*:046D:C626.*", TAG+="uaccess")"), std::string::npos);
  EXPECT_NE(obstacle_to(entry).find("/dev/hidraw3"), std::string::npos);
  entry.permitted = true;
  EXPECT_EQ(obstacle_to(entry), "");
  entry.taken = true;
  EXPECT_EQ(obstacle_to(entry), "it is open already");
  entry.kind = HidKind::kVendor;
  EXPECT_NE(obstacle_to(entry).find("OpenHaptics"), std::string::npos);
}

TEST(Unwrapped, GoesOnWhereACounterWraps) {
  Unwrapped<std::uint16_t> counter;
  counter.restart(1);
  EXPECT_EQ(counter.advance(65'534), 0);
  EXPECT_EQ(counter.advance(65'535), 1);
  EXPECT_EQ(counter.advance(0), 1);
  EXPECT_EQ(counter.advance(3), 3);
  EXPECT_EQ(counter.total(), 6u);
  counter.restart(10);
  EXPECT_EQ(counter.advance(40'000), 0);
  EXPECT_EQ(counter.total(), 16u);
}

}  // namespace
}  // namespace palpate
