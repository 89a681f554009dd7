#include "engine/runtime/servo_thread.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <system_error>

#include "engine/base/own_thread.h"

namespace palpate {
namespace {

using Nanoseconds = std::int64_t;

constexpr Nanoseconds kSecond = 1'000'000'000;

// Above most others, below what the system's own threads have.
constexpr int kUsualPriority = 80;

Nanoseconds now() {
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * kSecond + time.tv_nsec;
}

void sleep_until(Nanoseconds time) {
  const timespec until{time / kSecond, time % kSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
  }
}

int granted_priority(int wanted) {
  if (wanted == ServoOptions::kNoPriority) return 0;
  sched_param parameters{};
  parameters.sched_priority = wanted == 0 ? kUsualPriority : wanted;
  const bool granted = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
  return granted ? parameters.sched_priority : 0;
}

int granted_cpu(int wanted) {
  if (wanted < 0 || wanted >= CPU_SETSIZE) return ServoOptions::kAnyCpu;
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  CPU_SET(wanted, &cpus);
  const bool granted = pthread_setaffinity_np(pthread_self(), sizeof cpus, &cpus) == 0;
  return granted ? wanted : ServoOptions::kAnyCpu;
}

// Measures the rate about once a second.
class RateMeter {
 public:
  explicit RateMeter(Nanoseconds start) : start_(start) {}

  void tick(Nanoseconds time, double& rate_hz) {
    ++ticks_;
    if (rate_hz > 0.0 && time - start_ < kSecond) return;
    if (time <= start_) return;
    rate_hz = static_cast<double>(ticks_ * kSecond) / static_cast<double>(time - start_);
    if (time - start_ < kSecond) return;
    ticks_ = 0;
    start_ = time;
  }

 private:
  Nanoseconds start_;
  std::int64_t ticks_ = 0;
};

}  // namespace

Status ServoThread::start(ServoTask& task, const ServoOptions& options) {
  options_ = options;
  stop_.emplace();
  reports_.emplace();
  try {
    thread_ = std::thread([this, &task] { run(task); });
  } catch (const std::system_error&) {
    return Error{ErrorCode::kLimit, "the system allows no more threads"};
  }
  return Done{};
}

void ServoThread::stop() {
  if (!running()) return;
  stop_->raise();
  thread_.join();
}

const ServoThread::Report& ServoThread::newest() {
  static const Report kNone;
  if (!reports_) return kNone;
  reports_->fetch();
  return reports_->front();
}

const ServoStatistics& ServoThread::statistics() {
  return newest().statistics;
}

const ServoGrants& ServoThread::grants() {
  return newest().grants;
}

void ServoThread::run(ServoTask& task) {
  begin_own_thread("palpate-servo");
  Report report;
  report.grants = {granted_priority(options_.priority), granted_cpu(options_.cpu)};
  const double dt = 1.0 / options_.rate_hz;
  const auto period = std::max<Nanoseconds>(1, static_cast<Nanoseconds>(dt * kSecond));
  Nanoseconds due = now() + period;
  RateMeter meter(due - period);
  ServoStatistics& statistics = report.statistics;
  while (!stop_->raised()) {
    sleep_until(due);
    const Nanoseconds begin = now();
    task.tick(dt);
    const Nanoseconds end = now();
    ++statistics.ticks;
    statistics.lateness.add(static_cast<std::uint64_t>(std::max<Nanoseconds>(0, begin - due)));
    statistics.work.add(static_cast<std::uint64_t>(end - begin));
    meter.tick(end, statistics.rate_hz);
    due += period;
    if (end > due) {
      const Nanoseconds passed = (end - due) / period + 1;
      ++statistics.missed;
      statistics.skipped += static_cast<std::uint64_t>(passed);
      due += passed * period;
    }
    reports_->back() = report;
    reports_->publish();
  }
}

}  // namespace palpate
