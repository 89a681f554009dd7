#include <thread>

#include <gtest/gtest.h>

#include "engine/exchange/triple_slot.h"

namespace palpate {
namespace {

TEST(TripleSlot, GivesTheNewestValueOnce) {
  TripleSlot<int> slot;
  EXPECT_FALSE(slot.fetch());
  EXPECT_EQ(slot.front(), 0);
  for (const int value : {1, 2, 3}) {
    slot.back() = value;
    slot.publish();
  }
  EXPECT_TRUE(slot.fetch());
  EXPECT_EQ(slot.front(), 3);
  EXPECT_FALSE(slot.fetch());
  EXPECT_EQ(slot.front(), 3) << "an old value stays";
}

// A value too large for any processor to copy at once: it comes whole, and never an older one after a newer.
TEST(TripleSlot, HandsWholeValuesBetweenThreads) {
  struct Wide {
    std::uint64_t numbers[32] = {};
  };
  constexpr std::uint64_t kLast = 50'000;
  TripleSlot<Wide> slot;
  std::thread writer([&] {
    for (std::uint64_t value = 1; value <= kLast; ++value) {
      for (std::uint64_t& number : slot.back().numbers) number = value;
      slot.publish();
    }
  });
  std::uint64_t seen = 0, torn = 0, backwards = 0;
  while (seen < kLast) {
    if (!slot.fetch()) {
      std::this_thread::yield();
      continue;
    }
    const Wide& value = slot.front();
    for (const std::uint64_t number : value.numbers) torn += number != value.numbers[0];
    backwards += value.numbers[0] <= seen;
    seen = value.numbers[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
}

}  // namespace
}  // namespace palpate
