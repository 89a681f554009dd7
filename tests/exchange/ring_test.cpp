#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "engine/exchange/ring.h"

namespace palpate {
namespace {

TEST(Ring, IsFirstInFirstOutAndBounded) {
  Ring<int> ring(3);
  EXPECT_EQ(ring.capacity(), 4u);
  int item = -1;
  EXPECT_FALSE(ring.pop(item));
  EXPECT_EQ(ring.room(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(i));
  EXPECT_EQ(ring.room(), 0u);
  EXPECT_FALSE(ring.push(4));
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(ring.pop(item));
    EXPECT_EQ(item, i);
  }
  EXPECT_EQ(ring.room(), 4u);
  EXPECT_FALSE(ring.pop(item));
}

TEST(Ring, KeepsWhatItRefuses) {
  Ring<std::unique_ptr<int>> ring(1);
  ASSERT_TRUE(ring.push(std::make_unique<int>(1)));
  auto refused = std::make_unique<int>(2);
  EXPECT_FALSE(ring.push(std::move(refused)));
  ASSERT_NE(refused, nullptr);
  EXPECT_EQ(*refused, 2);
}

TEST(Ring, LosesNothingBetweenThreads) {
  constexpr std::uint64_t kCount = 100'000;
  Ring<std::unique_ptr<std::uint64_t>> ring(64);
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < kCount;) {
      auto item = std::make_unique<std::uint64_t>(i);
      while (!ring.push(std::move(item))) std::this_thread::yield();
      ++i;
    }
  });
  std::uint64_t wrong = 0;
  for (std::uint64_t expected = 0; expected < kCount;) {
    std::unique_ptr<std::uint64_t> item;
    if (ring.pop(item)) {
      wrong += *item != expected++;
    } else {
      std::this_thread::yield();
    }
  }
  producer.join();
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace palpate
