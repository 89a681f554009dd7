#include "engine/base/memory_reserve.h"

#include <mutex>
#include <new>

namespace palpate {
namespace {

std::mutex mutex;  // guards all but what is of one thread
std::new_handler handler_of_program = nullptr;
int reserves = 0;

MemoryReserve* of_all_threads = nullptr;
thread_local MemoryReserve* of_this_thread = nullptr;

}  // namespace

MemoryReserve::MemoryReserve(std::size_t bytes, For whom) : whom_(whom) {
  for (auto& half : halves_) half.reset(new std::byte[bytes / 2]);
  const std::lock_guard lock(mutex);
  next_ = list();
  list() = this;
  if (reserves++ == 0) handler_of_program = std::set_new_handler(serve);
}

MemoryReserve::~MemoryReserve() {
  const std::lock_guard lock(mutex);
  MemoryReserve** link = &list();
  while (*link != this) link = &(*link)->next_;
  *link = next_;
  // One that the program has installed meanwhile stays.
  if (--reserves == 0 && std::get_new_handler() == serve) std::set_new_handler(handler_of_program);
}

MemoryReserve*& MemoryReserve::list() const {
  return whom_ == For::kThisThread ? of_this_thread : of_all_threads;
}

bool MemoryReserve::is_touched() const {
  const std::lock_guard lock(mutex);
  return !halves_.front();
}

// The handler of operator new, which asks for its memory anew whenever this returns.
void MemoryReserve::serve() {
  std::new_handler program = nullptr;
  {
    const std::lock_guard lock(mutex);
    MemoryReserve* const reserve = of_this_thread ? of_this_thread : any_left();
    if (reserve && reserve->give_back()) return;
    program = handler_of_program;
  }
  if (!program) throw std::bad_alloc();
  program();
}

MemoryReserve* MemoryReserve::any_left() {
  MemoryReserve* reserve = of_all_threads;
  while (reserve && !reserve->halves_.back()) reserve = reserve->next_;
  return reserve;
}

// Whether it is worth while to ask anew.
bool MemoryReserve::give_back() {
  const bool first = halves_.front() != nullptr;
  halves_[first ? 0 : 1].reset();
  return first || whom_ == For::kAllThreads;
}

}  // namespace palpate
