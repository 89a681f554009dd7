#include "engine/exchange/loan.h"

#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "engine/exchange/flag.h"

namespace palpate {
namespace {

struct Counted {
  int uses = 0;
};

TEST(Loan, IsUsedWhileItIsLent) {
  Loan<Counted> loan;
  Counted thing;
  const auto use = [](Counted& lent) { ++lent.uses; };
  loan.use(use);
  loan.lend(thing);
  loan.use(use);
  loan.use(use);
  loan.take_back();
  loan.use(use);
  EXPECT_EQ(thing.uses, 2);
  loan.take_back();
}

// What was taken back may be destroyed at once, however often the other thread uses it.
TEST(Loan, IsNotUsedAfterItWasTakenBack) {
  constexpr int kRounds = 2000, kMostRounds = 100 * kRounds;  // more if the user's thread comes late
  Loan<Counted> loan;
  Flag stop;
  std::thread user([&] {
    while (!stop.raised()) loan.use([](Counted& lent) { ++lent.uses; });
  });
  int used = 0, late = 0;
  for (int round = 0; round < kRounds || (used == 0 && round < kMostRounds); ++round) {
    auto thing = std::make_unique<Counted>();
    loan.lend(*thing);
    std::this_thread::yield();
    loan.take_back();
    const int uses = thing->uses;
    used += uses > 0;
    std::this_thread::yield();
    late += thing->uses != uses;
  }
  stop.raise();
  user.join();
  EXPECT_EQ(late, 0);
  EXPECT_GT(used, 0);
}

}  // namespace
}  // namespace palpate
