#include "tests/bench/turns.h"

#include <sys/resource.h>
#include <algorithm>
#include <ctime>

#include "engine/base/clock.h"

namespace palpate::bench {
namespace {

constexpr std::size_t kTurn = 10;  // poses

long times_suspended() {
  rusage usage;
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nivcsw;
}

double processor_us() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

Sample measure(Method& method, const Pose& pose) {
  method.prepare(pose);
  const long suspended = times_suspended();
  const double processor_start = processor_us();
  const Stopwatch watch;
  method.update(pose);
  const double us = watch.elapsed_us(), used_us = processor_us() - processor_start;
  const bool interrupted = times_suspended() != suspended;
  return {interrupted ? used_us : us, interrupted, method.outcome()};
}

template <class Value>
Series series_of(const Run& run, Value&& value) {
  Series series;
  for (const std::optional<Sample>& sample : run)
    if (sample) value(*sample, series);
  return series;
}

}  // namespace

std::vector<Run> run_by_turns(const Methods& methods, std::span<const Pose> poses) {
  std::vector<Run> runs(methods.size(), Run(poses.size()));
  for (const auto& method : methods) method->restart();
  for (std::size_t begin = 0; begin < poses.size(); begin += kTurn) {
    const std::size_t end = std::min(poses.size(), begin + kTurn);
    for (std::size_t m = 0; m < methods.size(); ++m)
      for (std::size_t i = begin; i < end; ++i)
        if (i % methods[m]->every() == 0) runs[m][i] = measure(*methods[m], poses[i]);
  }
  return runs;
}

Series time_us(const Run& run) {
  return series_of(run, [](const Sample& sample, Series& series) { series.add(sample.us); });
}

Series servo_us(const Run& run) {
  return series_of(run, [](const Sample& sample, Series& series) {
    if (!sample.interrupted || sample.outcome.aside_us == 0.0)
      series.add(sample.us - sample.outcome.aside_us);
  });
}

Series per_lmd_us(const Run& run) {
  return series_of(run, [](const Sample& sample, Series& series) {
    if (sample.outcome.followed > 0) series.add(sample.us / static_cast<double>(sample.outcome.followed));
  });
}

Series lmds(const Run& run) {
  return series_of(run, [](const Sample& sample, Series& series) {
    series.add(static_cast<double>(sample.outcome.lmds));
  });
}

Series node_pairs(const Run& run) {
  return series_of(run, [](const Sample& sample, Series& series) {
    series.add(static_cast<double>(sample.outcome.work.node_pairs));
  });
}

Series triangle_pairs(const Run& run) {
  return series_of(run, [](const Sample& sample, Series& series) {
    series.add(static_cast<double>(sample.outcome.work.triangle_pairs));
  });
}

Series interruptions(const Run& run) {
  return series_of(run, [](const Sample& sample, Series& series) { series.add(sample.interrupted); });
}

}  // namespace palpate::bench
