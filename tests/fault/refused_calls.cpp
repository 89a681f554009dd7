#include "tests/fault/refused_calls.h"

#include <dlfcn.h>
#include <pthread.h>
#include <time.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <utility>

// Functions of this program come before those of every library that it loads.

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

std::atomic<int> threads_left = -1;  // -1: no end of them
std::atomic<std::int64_t> monotonic_ahead = 0;
std::atomic<std::int64_t> wall_ahead = 0;

// Of the thread that tests.
int opens_left = 0;
std::function<void()> at_opening;

template <class Function>
Function next(Function, const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

std::int64_t ahead(clockid_t clock) {
  if (clock == CLOCK_MONOTONIC) return monotonic_ahead.load();
  return clock == CLOCK_REALTIME ? wall_ahead.load() : 0;
}

timespec moved(const timespec& time, std::int64_t by) {
  const std::int64_t sum = time.tv_sec * kSecond + time.tv_nsec + by;
  return {sum / kSecond, sum % kSecond};
}

}  // namespace

namespace palpate::test {

NoThreadsFrom::NoThreadsFrom(int nth) {
  threads_left.store(nth - 1);
}

NoThreadsFrom::~NoThreadsFrom() {
  threads_left.store(-1);
}

void before_opening(int nth, std::function<void()> action) {
  opens_left = nth;
  at_opening = std::move(action);
}

void set_monotonic_clock_ahead(std::chrono::nanoseconds by) {
  monotonic_ahead.store(by.count());
}

void set_wall_clock_ahead(std::chrono::nanoseconds by) {
  wall_ahead.store(by.count());
}

}  // namespace palpate::test

extern "C" {

#pragma GCC visibility push(default)

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  static const auto call = next(&pthread_create, "pthread_create");
  int left = threads_left.load();
  while (left > 0 && !threads_left.compare_exchange_weak(left, left - 1)) {
  }
  return left == 0 ? EAGAIN : call(thread, attributes, run, argument);
}

std::FILE* fopen(const char* path, const char* mode) {
  static const auto call = next(&fopen, "fopen");
  if (opens_left > 0 && --opens_left == 0) std::exchange(at_opening, nullptr)();
  return call(path, mode);
}

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static const auto call = next(&clock_gettime, "clock_gettime");
  const int result = call(clock, time);
  if (result == 0 && ahead(clock) != 0) *time = moved(*time, ahead(clock));
  return result;
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* left) {
  static const auto call = next(&clock_nanosleep, "clock_nanosleep");
  if (!(flags & TIMER_ABSTIME) || ahead(clock) == 0) return call(clock, flags, time, left);
  const timespec really = moved(*time, -ahead(clock));
  return really.tv_sec < 0 ? 0 : call(clock, flags, &really, left);
}

#pragma GCC visibility pop

}  // extern "C"
