// Runs shapes and poses at which numbers fail, and hands on them, for a given time; prints tables.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "tests/stress/report.h"

namespace palpate::stress {
namespace {

struct Arguments {
  double minutes = 50.0;
  std::uint64_t seed = 1;
  unsigned jobs = 2;
  std::string only;
  int number = -1;  // of the one case to run of each family
  std::string out;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Families and scenes one after another on several threads, each for its share of the time.
class Session {
 public:
  explicit Session(const Arguments& arguments) : arguments_(arguments) {
    for (const Family& family : families())
      if (wanted(family.name)) chosen_families_.push_back(&family);
    for (const HandScene& scene : hand_scenes())
      if (arguments_.number < 0 && wanted(scene.name)) chosen_scenes_.push_back(&scene);
    family_reports_.resize(chosen_families_.size());
    hand_reports_.resize(chosen_scenes_.size());
  }

  // The number of faults.
  int run() {
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(arguments_.jobs, 1u); ++i) threads.emplace_back([this] { work(); });
    for (std::thread& thread : threads) thread.join();
    const std::string tables = search_table(family_reports_) + "\n" + triangle_table(family_reports_) + "\n" +
                               hand_table(hand_reports_);
    std::printf("\n%s", tables.c_str());
    if (!arguments_.out.empty()) std::ofstream(arguments_.out) << tables;
    return faults_;
  }

 private:
  bool wanted(const std::string& name) const { return name.find(arguments_.only) != std::string::npos; }
  std::size_t items() const { return chosen_families_.size() + chosen_scenes_.size(); }

  void work() {
    for (;;) {
      std::size_t item;
      {
        const std::lock_guard lock(mutex_);
        item = next_++;
      }
      if (item >= items()) return;
      // The slow ones first come last: scenes before families.
      if (item < chosen_scenes_.size())
        run_scene(item);
      else
        run_family(item - chosen_scenes_.size());
    }
  }

  double share() const {
    return 60.0 * arguments_.minutes * std::max(arguments_.jobs, 1u) / static_cast<double>(items());
  }

  void run_family(std::size_t i) {
    const auto start = Clock::now();
    FamilyReport& report = family_reports_[i];
    const int first = std::max(arguments_.number, 0);
    for (int number = first; number == first || (arguments_.number < 0 && seconds_since(start) < share());
         ++number)
      run_case(*chosen_families_[i], arguments_.seed, number, report);
    say(report.family, std::to_string(report.search.cases) + " cases", report.faults(), report.wrong);
  }

  void run_scene(std::size_t i) {
    const auto start = Clock::now();
    HandReport& report = hand_reports_[i];
    report.scene = chosen_scenes_[i]->name;
    report.outcome = stress_hand(*chosen_scenes_[i], [&] { return seconds_since(start) > share(); });
    say(report.scene, std::to_string(report.outcome.cycles) + " cycles", report.outcome.faults(), {});
  }

  void say(const std::string& name, const std::string& amount, int faults,
           const std::vector<std::string>& wrong) {
    const std::lock_guard lock(mutex_);
    faults_ += faults;
    std::printf("[%5.0f s] %2zu of %zu: %-22s %s, %d faults\n", seconds_since(start_), ++done_, items(),
                name.c_str(), amount.c_str(), faults);
    for (const std::string& one : wrong) std::printf("  %s\n", one.c_str());
    std::fflush(stdout);
  }

  const Arguments arguments_;
  const Clock::time_point start_ = Clock::now();
  std::vector<const Family*> chosen_families_;
  std::vector<const HandScene*> chosen_scenes_;
  std::vector<FamilyReport> family_reports_;
  std::vector<HandReport> hand_reports_;
  std::mutex mutex_;
  std::size_t next_ = 0, done_ = 0;
  int faults_ = 0;
};

}  // namespace
}  // namespace palpate::stress

int main(int count, char** values) {
  palpate::stress::Arguments arguments;
  CLI::App app{"Numerical stress: shapes and poses at which numbers fail"};
  app.add_option("--minutes", arguments.minutes, "all together")->check(CLI::PositiveNumber);
  app.add_option("--seed", arguments.seed, "names the run");
  app.add_option("--jobs", arguments.jobs, "threads");
  app.add_option("--only", arguments.only, "families and scenes whose name holds this");
  app.add_option("--case", arguments.number,
                 "the number of the one case to run of each family, as faults tell it")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--out", arguments.out, "file for the tables");
  CLI11_PARSE(app, count, values);
  return palpate::stress::Session(arguments).run() == 0 ? 0 : 1;
}
