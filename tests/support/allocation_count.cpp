#include "tests/support/allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>

// Apart from the tests: inlined into them, a compiler sees free() meet its own idea of new and warns.
namespace {

// Only compared before and after, on one thread or with the others at rest: no order is needed.
std::atomic<std::uint64_t> count = 0;
std::atomic<bool> failing = false;

void* counted(std::size_t size) noexcept {
  count.fetch_add(1, std::memory_order_relaxed);
  return failing.load(std::memory_order_relaxed) ? nullptr : std::malloc(size);
}

void* counted(std::size_t size, std::align_val_t alignment) noexcept {
  count.fetch_add(1, std::memory_order_relaxed);
  if (failing.load(std::memory_order_relaxed)) return nullptr;
  const auto align = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(align, (size + align - 1) / align * align);
}

void* or_throw(void* memory) {
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

std::uint64_t palpate::test::allocation_count() {
  return count.load(std::memory_order_relaxed);
}

palpate::test::AllocationFailure::AllocationFailure() {
  failing.store(true, std::memory_order_relaxed);
}
palpate::test::AllocationFailure::~AllocationFailure() {
  failing.store(false, std::memory_order_relaxed);
}

void* operator new(std::size_t size) {
  return or_throw(counted(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return or_throw(counted(size, alignment));
}
// The default of these calls those above, a sanitizer's does not, yet what they give is freed below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return counted(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return counted(size, alignment);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
