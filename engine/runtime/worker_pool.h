#pragma once

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/scene/executor.h"

namespace palpate {

// Threads that share the pieces of a step with the caller's. For synchronous stepping: the caller waits.
class WorkerPool : public Executor {
 public:
  static constexpr unsigned kMostThreads = 256;

  // `threads` with the caller's, at least 1. Throws std::system_error if the system has no more.
  explicit WorkerPool(unsigned threads);
  ~WorkerPool() override;
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  std::size_t workers() const override { return threads_.size() + 1; }
  void run(Pieces& pieces, std::size_t count) override;

 private:
  using Lock = std::unique_lock<std::mutex>;

  void work(std::size_t worker);
  void run_pieces(Lock& lock, std::size_t worker);
  void end();

  std::mutex mutex_;  // guards all below
  std::condition_variable begin_;
  std::condition_variable done_;
  Pieces* pieces_ = nullptr;
  std::size_t count_ = 0;
  std::size_t next_ = 0;     // the first piece that nobody has begun
  std::size_t running_ = 0;  // pieces begun and not done
  std::size_t failed_piece_ = 0;
  std::exception_ptr failure_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace palpate
