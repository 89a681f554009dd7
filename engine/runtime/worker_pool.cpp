#include "engine/runtime/worker_pool.h"

#include <utility>

namespace palpate {

WorkerPool::WorkerPool(unsigned threads) {
  threads_.reserve(threads);
  try {
    for (std::size_t worker = 1; worker < threads; ++worker)
      threads_.emplace_back([this, worker] { work(worker); });
  } catch (...) {
    end();
    throw;
  }
}

WorkerPool::~WorkerPool() {
  end();
}

void WorkerPool::end() {
  {
    const Lock lock(mutex_);
    ending_ = true;
  }
  begin_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::run(Pieces& pieces, std::size_t count) {
  Lock lock(mutex_);
  pieces_ = &pieces;
  count_ = count;
  next_ = 0;
  begin_.notify_all();
  run_pieces(lock, 0);
  done_.wait(lock, [this] { return running_ == 0; });
  if (std::exception_ptr failure = std::exchange(failure_, nullptr)) std::rethrow_exception(failure);
}

void WorkerPool::work(std::size_t worker) {
  Lock lock(mutex_);
  while (true) {
    begin_.wait(lock, [this] { return ending_ || next_ < count_; });
    if (ending_) return;
    run_pieces(lock, worker);
    if (running_ == 0) done_.notify_one();
  }
}

// Runs pieces as long as there are some that nobody has begun; the lock is held but for the piece itself.
void WorkerPool::run_pieces(Lock& lock, std::size_t worker) {
  while (next_ < count_) {
    const std::size_t piece = next_++;
    ++running_;
    lock.unlock();
    std::exception_ptr failure;
    try {
      pieces_->run(piece, worker);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    --running_;
    if (failure && (!failure_ || piece < failed_piece_)) {
      failure_ = failure;
      failed_piece_ = piece;
    }
  }
}

}  // namespace palpate
