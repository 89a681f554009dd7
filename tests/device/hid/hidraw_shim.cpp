#include "tests/device/hid/hidraw_shim.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdarg.h>
#include <sys/ioctl.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cstring>

// Stands before the C library, and before umockdev's own such library, in the order in which a program's
// symbols are looked up. Reads, writes and polls are the kernel's own, on a socket that keeps the borders of
// reports as hidraw does.
namespace palpate::test {
namespace {

std::atomic<HidrawNodes*> standing_in{nullptr};

HidrawNodes* nodes() {
  return standing_in.load(std::memory_order_acquire);
}

// Descriptors that are ours. A sanitizer opens and closes files while it reports, and must not wait for a
// lock that whoever it reports on may hold: for all other descriptors none is taken.
constexpr int kDescriptors = 4096;
std::atomic<bool> is_ours[kDescriptors];

bool has(int descriptor) {
  return descriptor >= 0 && descriptor < kDescriptors && nodes() &&
         is_ours[descriptor].load(std::memory_order_acquire);
}

int opened(int descriptor) {
  if (descriptor >= 0 && descriptor < kDescriptors)
    is_ours[descriptor].store(true, std::memory_order_release);
  return descriptor;
}

bool is_hidraw(const char* path) {
  return path && std::strncmp(path, "/dev/hidraw", 11) == 0;
}

// As a system call returns it.
int returned(int result) {
  if (result >= 0) return result;
  errno = -result;
  return -1;
}

template <class Function>
Function* system_own(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int open_as(const char* name, const char* path, int flags, mode_t mode) {
  if (is_hidraw(path) && nodes()) return returned(opened(nodes()->open(path)));
  return system_own<int(const char*, int, ...)>(name)(path, flags, mode);
}

mode_t mode_of(int flags, va_list arguments) {
  return flags & (O_CREAT | O_TMPFILE) ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

__attribute__((visibility("default"))) void stand_in(HidrawNodes* nodes) {
  standing_in.store(nodes, std::memory_order_release);
}

}  // namespace palpate::test

using namespace palpate::test;

extern "C" {
#pragma GCC visibility push(default)

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_as("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_as("open64", path, flags, mode);
}

int __open_2(const char* path, int flags) {
  return open_as("open", path, flags, 0);
}

int __open64_2(const char* path, int flags) {
  return open_as("open64", path, flags, 0);
}

int access(const char* path, int mode) noexcept {
  if (is_hidraw(path) && nodes()) return returned(nodes()->access(path));
  return system_own<int(const char*, int)>("access")(path, mode);
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
  va_list arguments;
  va_start(arguments, request);
  void* const argument = va_arg(arguments, void*);
  va_end(arguments);
  if (has(descriptor)) return returned(nodes()->ioctl(descriptor, request, argument));
  return system_own<int(int, unsigned long, ...)>("ioctl")(descriptor, request, argument);
}

#ifndef __clang__  // which does not know the warning
// glibc declares that it only writes what it is given.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
int poll(pollfd* files, nfds_t count, int timeout) {
  if (count == 1 && has(files[0].fd)) nodes()->before_poll(files[0].fd);
  return system_own<int(pollfd*, nfds_t, int)>("poll")(files, count, timeout);
}

int close(int descriptor) {
  if (has(descriptor)) {
    is_ours[descriptor].store(false, std::memory_order_release);
    nodes()->closing(descriptor);
  }
  return system_own<int(int)>("close")(descriptor);
}

#pragma GCC visibility pop
}
