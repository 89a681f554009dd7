#pragma once

#include <optional>
#include <thread>

#include "engine/base/result.h"
#include "engine/device/servo_task.h"
#include "engine/exchange/flag.h"
#include "engine/runtime/servo_meter.h"
#include "engine/runtime/servo_options.h"

namespace palpate {

// A thread that runs a task at a fixed rate. It sleeps until absolute times, so that errors do not add up;
// after a stall it leaves ticks out rather than make up for them. All but the task is for one thread at a
// time.
class ServoThread {
 public:
  ServoThread() = default;
  ~ServoThread() { stop(); }
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  // `task` must live until stop(). It must not run already. Errors: kLimit (no more threads).
  Status start(ServoTask& task, const ServoOptions& options);
  void stop();
  bool running() const { return thread_.joinable(); }

  const ServoStatistics& statistics();
  const ServoGrants& grants();
  const ServoOptions& options() const { return options_; }

 private:
  void run(ServoTask& task);
  const ServoMeter::Report& newest();

  ServoOptions options_;
  std::optional<Flag> stop_;
  std::optional<ServoMeter> meter_;
  std::thread thread_;
};

}  // namespace palpate
