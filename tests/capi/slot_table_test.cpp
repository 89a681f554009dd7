#include "engine/exchange/handle_table.h"

#include <atomic>
#include <set>
#include <thread>

#include <gtest/gtest.h>

namespace palpate {
namespace {

// Counts the living, and knows whether it is one of them.
struct Witness {
  static constexpr int kAlive = 0x600d;

  explicit Witness(std::atomic<int>& living) : living_(living) { ++living_; }
  ~Witness() {
    mark = 0;
    --living_;
  }

  int mark = kAlive;

 private:
  std::atomic<int>& living_;
};

using Table = HandleTable<Witness>;

class SlotTableTest : public testing::Test {
 protected:
  std::unique_ptr<Witness> witness() { return std::make_unique<Witness>(living_); }

  std::atomic<int> living_ = 0;
};

TEST_F(SlotTableTest, RefusesNullStaleAndForeignHandles) {
  Table table(1);
  Table other(2);
  const auto handle = table.create(witness());
  ASSERT_NE(handle, 0u);
  EXPECT_TRUE(table.pin(handle));
  EXPECT_FALSE(table.pin(0));
  EXPECT_FALSE(other.pin(handle));
  EXPECT_FALSE(table.pin(handle + 1));
  EXPECT_FALSE(table.pin(handle | 1ull << 53));  // a bit that no handle has
  EXPECT_FALSE(table.pin(handle | (SlotTable::kMaxSlots - 1)));
  EXPECT_EQ(table.release(handle), SlotTable::Outcome::kDone);
  EXPECT_FALSE(table.pin(handle));
  EXPECT_EQ(table.release(handle), SlotTable::Outcome::kInvalid);
  EXPECT_EQ(table.retain(handle), SlotTable::Outcome::kInvalid);
  EXPECT_EQ(living_, 0);
}

TEST_F(SlotTableTest, ReusedSlotHasAnotherHandle) {
  Table table(1);
  std::set<SlotTable::Handle> seen;
  for (int i = 0; i < 100; ++i) {
    const auto handle = table.create(witness());
    EXPECT_TRUE(seen.insert(handle).second);
    table.release(handle);
  }
}

TEST_F(SlotTableTest, LastReferenceDestroys) {
  Table table(1);
  const auto handle = table.create(witness());
  EXPECT_EQ(table.retain(handle), SlotTable::Outcome::kDone);
  table.release(handle);
  EXPECT_EQ(living_, 1);
  table.release(handle);
  EXPECT_EQ(living_, 0);
}

TEST_F(SlotTableTest, PinDefersDestruction) {
  Table table(1);
  const auto handle = table.create(witness());
  {
    const auto first = table.pin(handle);
    const auto second = table.pin(handle);
    table.release(handle);
    EXPECT_FALSE(table.pin(handle));
    EXPECT_EQ(second->mark, Witness::kAlive);
    EXPECT_EQ(living_, 1);
  }
  EXPECT_EQ(living_, 0);
}

TEST_F(SlotTableTest, SecondReleaseDoesNotTakeAPin) {
  Table table(1);
  const auto handle = table.create(witness());
  const auto pin = table.pin(handle);
  EXPECT_EQ(table.release(handle), SlotTable::Outcome::kDone);
  EXPECT_EQ(table.release(handle), SlotTable::Outcome::kInvalid);
  EXPECT_EQ(living_, 1);
}

TEST_F(SlotTableTest, FullTableRefuses) {
  Table table(1, {.slots = 2});
  const auto first = table.create(witness());
  table.create(witness());
  EXPECT_EQ(table.create(witness()), 0u);
  EXPECT_EQ(living_, 2);
  table.release(first);
  EXPECT_NE(table.create(witness()), 0u);
}

TEST_F(SlotTableTest, GrowsOverManyChunksWithoutMovingObjects) {
  Table table(1);
  const auto first = table.create(witness());
  const auto pin = table.pin(first);
  const Witness* place = &*pin;
  std::set<SlotTable::Handle> handles;
  for (int i = 0; i < 5000; ++i) handles.insert(table.create(witness()));
  EXPECT_EQ(handles.size(), 5000u);
  const auto again = table.pin(first);
  EXPECT_EQ(&*again, place);
  for (const auto handle : handles) EXPECT_TRUE(table.pin(handle));
}

TEST_F(SlotTableTest, SlotRetiresWhenItsGenerationsAreUsedUp) {
  Table table(1, {.slots = 1, .generations = 3});
  for (int i = 0; i < 3; ++i) {
    const auto handle = table.create(witness());
    ASSERT_NE(handle, 0u);
    table.release(handle);
  }
  EXPECT_EQ(table.create(witness()), 0u);
}

TEST_F(SlotTableTest, ReferencesAreLimited) {
  Table table(1);
  const auto handle = table.create(witness());
  for (int i = 1; i < 65'535; ++i) ASSERT_EQ(table.retain(handle), SlotTable::Outcome::kDone);
  EXPECT_EQ(table.retain(handle), SlotTable::Outcome::kFull);
  for (int i = 0; i < 65'535; ++i) ASSERT_EQ(table.release(handle), SlotTable::Outcome::kDone);
  EXPECT_EQ(living_, 0);
}

TEST_F(SlotTableTest, TableDestroysWhatIsLeft) {
  {
    Table table(1);
    table.create(witness());
    table.create(witness());
  }
  EXPECT_EQ(living_, 0);
}

// Readers use whatever handle is current while it is released and replaced beneath them.
TEST_F(SlotTableTest, ReadersNeverMeetTheDead) {
  Table table(1);
  std::atomic<SlotTable::Handle> current = table.create(witness());
  std::atomic<bool> done = false;
  std::atomic<int> dead = 0;
  std::vector<std::thread> readers;
  for (int i = 0; i < 3; ++i) {
    readers.emplace_back([&] {
      while (!done) {
        const auto pin = table.pin(current);
        if (pin && pin->mark != Witness::kAlive) ++dead;
      }
    });
  }
  for (int i = 0; i < 20'000; ++i) {
    const auto old = current.exchange(table.create(witness()));
    EXPECT_EQ(table.release(old), SlotTable::Outcome::kDone);
  }
  done = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(dead, 0);
  EXPECT_EQ(living_, 1);
}

TEST_F(SlotTableTest, ThreadsThatReleaseOneHandleDestroyItOnce) {
  Table table(1);
  for (int round = 0; round < 200; ++round) {
    const auto handle = table.create(witness());
    std::atomic<int> released = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] { released += table.release(handle) == SlotTable::Outcome::kDone; });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(released, 1);
    EXPECT_EQ(living_, 0);
  }
}

TEST_F(SlotTableTest, ThreadsCreateAndRelease) {
  Table table(1);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 3000; ++k) {
        const auto handle = table.create(witness());
        EXPECT_EQ(table.retain(handle), SlotTable::Outcome::kDone);
        EXPECT_EQ(table.release(handle), SlotTable::Outcome::kDone);
        EXPECT_EQ(table.pin(handle)->mark, Witness::kAlive);
        EXPECT_EQ(table.release(handle), SlotTable::Outcome::kDone);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(living_, 0);
}

}  // namespace
}  // namespace palpate
