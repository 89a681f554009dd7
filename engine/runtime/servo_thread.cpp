#include "engine/runtime/servo_thread.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <system_error>

#include "engine/base/own_thread.h"

namespace palpate {
namespace {

using Nanoseconds = ServoMeter::Nanoseconds;

// Above most others, below what the system's own threads have.
constexpr int kUsualPriority = 80;

void sleep_until(Nanoseconds time) {
  const timespec until{time / ServoMeter::kSecond, time % ServoMeter::kSecond};
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

}  // namespace

Status ServoThread::start(ServoTask& task, const ServoOptions& options) {
  options_ = options;
  stop_.emplace();
  meter_.emplace();
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

const ServoMeter::Report& ServoThread::newest() {
  static const ServoMeter::Report kNone;
  return meter_ ? meter_->newest() : kNone;
}

const ServoStatistics& ServoThread::statistics() {
  return newest().statistics;
}

const ServoGrants& ServoThread::grants() {
  return newest().grants;
}

void ServoThread::run(ServoTask& task) {
  begin_own_thread("palpate-servo");
  const ServoGrants grants{granted_priority(options_.priority), granted_cpu(options_.cpu)};
  const double dt = 1.0 / options_.rate_hz;
  const auto period = std::max<Nanoseconds>(1, static_cast<Nanoseconds>(dt * ServoMeter::kSecond));
  const Nanoseconds start = ServoMeter::now();
  meter_->begin(start, period, grants);
  for (Nanoseconds due = start + period; !stop_->raised();) {
    sleep_until(due);
    const Nanoseconds begin = ServoMeter::now();
    task.tick(dt);
    due = meter_->tick(due, begin, ServoMeter::now());
  }
}

}  // namespace palpate
