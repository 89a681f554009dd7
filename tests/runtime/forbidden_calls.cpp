#include "tests/runtime/forbidden_calls.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

// Functions of this program come before those of every library that it loads. What is not forbidden goes on
// to the next: for memory by glibc's own names, because looking a name up allocates.

namespace {

thread_local int forbidden = 0;

void check(const char* name) {
  if (forbidden == 0) return;
  forbidden = 0;
  syscall(SYS_write, STDERR_FILENO, "forbidden call: ", 16);
  syscall(SYS_write, STDERR_FILENO, name, std::strlen(name));
  syscall(SYS_write, STDERR_FILENO, "\n", 1);
  std::abort();
}

template <class Function>
Function next(Function, const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

mode_t mode_after(int flags, va_list arguments) {
  return flags & (O_CREAT | O_TMPFILE) ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

palpate::test::ForbiddenCalls::ForbiddenCalls() {
  ++forbidden;
}

palpate::test::ForbiddenCalls::~ForbiddenCalls() {
  --forbidden;
}

extern "C" {

#pragma GCC visibility push(default)

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) {
  check("malloc");
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  check("calloc");
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  check("realloc");
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  check("aligned_alloc");
  return __libc_memalign(alignment, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  check("memalign");
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  check("posix_memalign");
  *memory = __libc_memalign(alignment, size);
  return *memory ? 0 : ENOMEM;
}
void free(void* memory) {
  if (memory) check("free");
  __libc_free(memory);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static const auto call = next(&pthread_mutex_lock, "pthread_mutex_lock");
  check("pthread_mutex_lock");
  return call(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  static const auto call = next(&pthread_mutex_trylock, "pthread_mutex_trylock");
  check("pthread_mutex_trylock");
  return call(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  static const auto call = next(&pthread_rwlock_rdlock, "pthread_rwlock_rdlock");
  check("pthread_rwlock_rdlock");
  return call(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  static const auto call = next(&pthread_rwlock_wrlock, "pthread_rwlock_wrlock");
  check("pthread_rwlock_wrlock");
  return call(lock);
}
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  static const auto call = next(&pthread_cond_wait, "pthread_cond_wait");
  check("pthread_cond_wait");
  return call(condition, mutex);
}
int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* until) {
  static const auto call = next(&pthread_cond_timedwait, "pthread_cond_timedwait");
  check("pthread_cond_timedwait");
  return call(condition, mutex, until);
}
int pthread_cond_signal(pthread_cond_t* condition) noexcept {
  static const auto call = next(&pthread_cond_signal, "pthread_cond_signal");
  check("pthread_cond_signal");
  return call(condition);
}
int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
  static const auto call = next(&pthread_cond_broadcast, "pthread_cond_broadcast");
  check("pthread_cond_broadcast");
  return call(condition);
}
int sem_wait(sem_t* semaphore) {
  static const auto call = next(&sem_wait, "sem_wait");
  check("sem_wait");
  return call(semaphore);
}
int nanosleep(const timespec* time, timespec* left) {
  static const auto call = next(&nanosleep, "nanosleep");
  check("nanosleep");
  return call(time, left);
}
int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* left) {
  static const auto call = next(&clock_nanosleep, "clock_nanosleep");
  check("clock_nanosleep");
  return call(clock, flags, time, left);
}

int open(const char* path, int flags, ...) {
  static const auto call = next(&open, "open");
  check("open");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_after(flags, arguments);
  va_end(arguments);
  return call(path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
  static const auto call = next(&openat, "openat");
  check("openat");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_after(flags, arguments);
  va_end(arguments);
  return call(folder, path, flags, mode);
}
ssize_t read(int file, void* bytes, std::size_t size) {
  static const auto call = next(&read, "read");
  check("read");
  return call(file, bytes, size);
}
ssize_t write(int file, const void* bytes, std::size_t size) {
  static const auto call = next(&write, "write");
  check("write");
  return call(file, bytes, size);
}
std::FILE* fopen(const char* path, const char* mode) {
  static const auto call = next(&fopen, "fopen");
  check("fopen");
  return call(path, mode);
}
std::size_t fwrite(const void* bytes, std::size_t size, std::size_t count, std::FILE* file) {
  static const auto call = next(&fwrite, "fwrite");
  check("fwrite");
  return call(bytes, size, count, file);
}
int fflush(std::FILE* file) {
  static const auto call = next(&fflush, "fflush");
  check("fflush");
  return call(file);
}

#pragma GCC visibility pop

}  // extern "C"
