#include <array>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "engine/exchange/counter.h"
#include "engine/exchange/flag.h"
#include "engine/exchange/mailbox.h"

namespace palpate {
namespace {

struct Numbered : Letter {
  Numbered(int its_sender, int its_number) : sender(its_sender), number(its_number) {}
  int sender;
  int number;
};

TEST(Mailbox, GivesLettersInOrder) {
  Mailbox mailbox;
  EXPECT_EQ(mailbox.take(), nullptr);
  Numbered first(0, 1), second(0, 2);
  mailbox.post(&first);
  mailbox.post(&second);
  Letter* const taken = mailbox.take();
  EXPECT_EQ(taken, &first);
  EXPECT_EQ(taken->next(), &second);
  EXPECT_EQ(second.next(), nullptr);
  EXPECT_EQ(mailbox.take(), nullptr);
}

TEST(Mailbox, LosesNothingFromManyThreads) {
  constexpr int kSenders = 3, kLetters = 20'000;
  Mailbox mailbox;
  std::vector<std::thread> senders;
  for (int sender = 0; sender < kSenders; ++sender) {
    senders.emplace_back([&mailbox, sender] {
      for (int i = 0; i < kLetters; ++i) mailbox.post(new Numbered(sender, i));
    });
  }
  std::array<int, kSenders> expected{};
  int wrong = 0;
  for (int left = kSenders * kLetters; left > 0;) {
    for (Letter* letter = mailbox.take(); letter; --left) {
      const auto* taken = static_cast<Numbered*>(letter);
      wrong += taken->number != expected[taken->sender]++;
      letter = letter->next();
      delete taken;
    }
    std::this_thread::yield();
  }
  for (std::thread& sender : senders) sender.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Flag, TellsWhatItWas) {
  Flag flag;
  EXPECT_FALSE(flag.raise());
  EXPECT_TRUE(flag.raise());
  EXPECT_TRUE(flag.raised());
  EXPECT_TRUE(flag.lower());
  EXPECT_FALSE(flag.lower());
}

TEST(Counter, MayBeReadWhileItCounts) {
  Counter counter;
  std::thread writer([&] {
    for (int i = 0; i < 10'000; ++i) counter.add(2);
  });
  std::uint64_t last = 0, backwards = 0;
  while (last < 20'000) {
    const std::uint64_t now = counter.value();
    backwards += now < last;
    last = now;
  }
  writer.join();
  EXPECT_EQ(backwards, 0u);
}

}  // namespace
}  // namespace palpate
