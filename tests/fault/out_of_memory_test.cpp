// Every request for memory is refused in turn: alone, and as by a memory that is full until the call has
// returned.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "tests/fault/scenarios.h"

namespace palpate::test {
namespace {

using Extent = FailingAllocation::Extent;

// About so many requests of a scenario are refused in a short run; PALPATE_LONG=1 refuses each.
constexpr std::uint64_t kShort = 150;

bool is_long() {
  const char* const wish = std::getenv("PALPATE_LONG");
  return wish && std::string(wish) == "1";
}

// For whoever looks for what a crash comes from.
char whereabouts[128];

void tell_whereabouts(int signal) {
  static_cast<void>(!::write(STDERR_FILENO, whereabouts, std::strlen(whereabouts)));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

struct Outcome {
  std::string kept;
  std::string complaints;
  const char* failed_call = "";
  bool is_comparable = true;
  bool failed = false;
  std::uint64_t requests = 0;    // of one that nothing disturbed
  std::int64_t left_behind = 0;  // blocks of memory
};

Outcome outcome_of(const Scenario& scenario, std::uint64_t nth = FailingAllocation::kNever,
                   Extent extent = Extent::kOnce) {
  std::snprintf(whereabouts, sizeof whereabouts, "%s, request %llu%s\n", scenario.name.c_str(),
                static_cast<unsigned long long>(nth), extent == Extent::kOnce ? "" : ", then full");
  const std::int64_t before = live_blocks();
  Outcome outcome;
  {
    const FailingAllocation failing(nth, extent);
    Journey journey;
    scenario.run(journey);
    outcome.is_comparable = journey.is_comparable();
    outcome.failed_call = journey.failed_call();
    outcome.failed = FailingAllocation::failed();
    outcome.requests = nth - FailingAllocation::requests_left();
    FailingAllocation::pass();
    outcome.kept = journey.kept();
    outcome.complaints = journey.complaints();
  }
  outcome.left_behind = live_blocks() - before;
  return outcome;
}

// Blocks that a run leaves behind. For threads that come and go Embree and the C library keep some.
double blocks_kept(const Scenario& scenario) {
  constexpr int kRuns = 20;
  const std::int64_t before = live_blocks();
  for (int i = 0; i < kRuns; ++i) outcome_of(scenario);
  return static_cast<double>(live_blocks() - before) / kRuns;
}

class OutOfMemory : public testing::TestWithParam<Scenario> {
 protected:
  void SetUp() override {
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE}) std::signal(signal, tell_whereabouts);
  }
};

TEST_P(OutOfMemory, EndsInAnErrorAndLeavesEverythingAsItWas) {
  const Scenario& scenario = GetParam();
  outcome_of(scenario);  // what is made once for the process is made
  const Outcome undisturbed = outcome_of(scenario);
  ASSERT_EQ(undisturbed.complaints, "");
  const std::uint64_t stride = is_long() ? 1 : undisturbed.requests / kShort + 1;
  std::uint64_t refused = 0;
  const double kept = blocks_kept(scenario);
  const std::int64_t before = live_blocks();
  for (const Extent extent : {Extent::kOnce, Extent::kFull}) {
    for (std::uint64_t nth = extent == Extent::kOnce ? 1 : 1 + stride / 2;; nth += stride) {
      const Outcome outcome = outcome_of(scenario, nth, extent);
      if (!outcome.failed) break;
      ++refused;
      EXPECT_EQ(outcome.complaints, "") << whereabouts;
      EXPECT_TRUE(!outcome.is_comparable || outcome.kept == undisturbed.kept)
          << whereabouts << outcome.failed_call;
      // What is made at the first error, as by Embree to remember it, is not made again.
      if (scenario.has_threads || outcome.left_behind <= undisturbed.left_behind) continue;
      EXPECT_LE(outcome_of(scenario, nth, extent).left_behind, undisturbed.left_behind)
          << whereabouts << outcome.failed_call;
    }
  }
  EXPECT_LT(static_cast<double>(live_blocks() - before), 64.0 + (kept + 0.5) * static_cast<double>(refused))
      << "on the whole";
  std::printf("%llu of %llu requests refused, in both ways together\n",
              static_cast<unsigned long long>(refused),
              static_cast<unsigned long long>(undisturbed.requests));
}

const Scenario& scenario_named(const std::string& name) {
  return *std::ranges::find(scenarios(), name, &Scenario::name);
}

// Each in a process of its own, in which nothing has been made yet that is made once.
TEST(OutOfMemoryDeathTest, TheFirstUseMayFailAndTheNextSucceeds) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const std::uint64_t stride = is_long() ? 1 : 23;
  for (std::uint64_t nth = 1; nth < 350; nth += stride) {
    EXPECT_EXIT(
        {
          const Outcome outcome = outcome_of(scenario_named("Query"), nth);
          std::fputs(outcome.complaints.c_str(), stderr);
          std::exit(outcome.complaints.empty() ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
  }
}

INSTANTIATE_TEST_SUITE_P(All, OutOfMemory, testing::ValuesIn(scenarios()),
                         [](const testing::TestParamInfo<Scenario>& info) { return info.param.name; });

}  // namespace
}  // namespace palpate::test
