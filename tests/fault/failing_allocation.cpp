#include "tests/fault/failing_allocation.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>

// Functions of this program come before those of every library that it loads. A sanitizer has a malloc of its
// own, which must not be replaced: there only C++ is refused memory.

namespace {

using palpate::test::FailingAllocation;

// Sequentially consistent: which request of which thread is the n-th matters to nobody, that it is one does.
std::atomic<std::uint64_t> left = 0;  // until the one that fails; 0: none does
std::atomic<bool> full = false;
std::atomic<std::int64_t> given_back = 0;  // bytes, since the memory is full
std::atomic<bool> any_failed = false;
std::atomic<std::int64_t> live = 0;

std::atomic<std::size_t> largest = 0;

thread_local int spared = 0;

bool is_full() {
  return full.load() && any_failed.load() && left.load() == 1;
}

void note(std::size_t bytes) {
  std::size_t seen = largest.load();
  while (bytes > seen && !largest.compare_exchange_weak(seen, bytes)) {
  }
}

bool refused(std::size_t bytes) {
  note(bytes);
  if (spared > 0) return false;
  std::uint64_t seen = left.load();
  while (seen > 1 && !left.compare_exchange_weak(seen, seen - 1)) {
  }
  if (seen != 1) return false;
  if (!full.load()) {
    if (!left.compare_exchange_strong(seen, 0)) return false;
  } else if (any_failed.load()) {
    const auto wanted = static_cast<std::int64_t>(bytes);
    if (given_back.fetch_sub(wanted) >= wanted) return false;
    given_back.fetch_add(wanted);
  }
  any_failed.store(true);
  return true;
}

void give_back(void* memory) {
  if (memory && is_full()) given_back.fetch_add(static_cast<std::int64_t>(malloc_usable_size(memory)));
}

}  // namespace

namespace palpate::test {

FailingAllocation::FailingAllocation(std::uint64_t nth, Extent extent) {
  full.store(extent == Extent::kFull);
  given_back.store(0);
  any_failed.store(false);
  left.store(nth);
}

FailingAllocation::~FailingAllocation() {
  pass();
}

bool FailingAllocation::failed() {
  return any_failed.load();
}

void FailingAllocation::pass() {
  left.store(0);
}

std::uint64_t FailingAllocation::requests_left() {
  return left.load();
}

Spared::Spared() {
  ++spared;
}

Spared::~Spared() {
  --spared;
}

Exposed::Exposed() {
  --spared;
}

Exposed::~Exposed() {
  ++spared;
}

std::size_t take_largest_request() {
  return largest.exchange(0);
}

std::int64_t live_blocks() {
  return live.load();
}

}  // namespace palpate::test

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

namespace {

void* given(std::size_t size) noexcept {
  return refused(size) ? nullptr : std::malloc(size);
}

void* given(std::size_t size, std::align_val_t alignment) noexcept {
  if (refused(size)) return nullptr;
  const auto align = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(align, (size + align - 1) / align * align);
}

// As the operators of the standard library do.
template <class Give>
void* insist(Give give) {
  while (true) {
    if (void* const memory = give()) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

}  // namespace

void* operator new(std::size_t size) {
  return insist([&] { return given(size); });
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return insist([&] { return given(size, alignment); });
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return given(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return given(size, alignment);
}
void operator delete(void* memory) noexcept {
  give_back(memory);
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  give_back(memory);
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  give_back(memory);
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  give_back(memory);
  std::free(memory);
}

// A sanitizer's own ones of arrays do not come here.
void* operator new[](std::size_t size) {
  return operator new(size);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return operator new(size, alignment);
}
void* operator new[](std::size_t size, const std::nothrow_t& nothrow) noexcept {
  return operator new(size, nothrow);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t& nothrow) noexcept {
  return operator new(size, alignment, nothrow);
}
void operator delete[](void* memory) noexcept {
  operator delete(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  operator delete(memory);
}
void operator delete[](void* memory, std::align_val_t alignment) noexcept {
  operator delete(memory, alignment);
}
void operator delete[](void* memory, std::size_t, std::align_val_t alignment) noexcept {
  operator delete(memory, alignment);
}

#else

namespace {

void* counted(void* memory) {
  if (memory) live.fetch_add(1);
  return memory;
}

void* none() {
  errno = ENOMEM;
  return nullptr;
}

}  // namespace

extern "C" {

#pragma GCC visibility push(default)

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) {
  return refused(size) ? none() : counted(__libc_malloc(size));
}
void* calloc(std::size_t count, std::size_t size) {
  return refused(count * size) ? none() : counted(__libc_calloc(count, size));
}
void* realloc(void* memory, std::size_t size) {
  if (!memory) return malloc(size);
  return refused(size) ? none() : __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return refused(size) ? none() : counted(__libc_memalign(alignment, size));
}
void* memalign(std::size_t alignment, std::size_t size) {
  return aligned_alloc(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  void* const found = aligned_alloc(alignment, size);
  if (!found) return ENOMEM;
  *memory = found;
  return 0;
}
void free(void* memory) {
  give_back(memory);
  if (memory) live.fetch_sub(1);
  __libc_free(memory);
}

#pragma GCC visibility pop

}  // extern "C"

#endif
