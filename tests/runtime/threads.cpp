#include "tests/runtime/threads.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

namespace palpate::test {
namespace {

std::size_t listed_threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

}  // namespace

std::size_t thread_count() {
  // The thread sanitizer starts a thread of its own beside the first of a program.
  pid_t first = 0;
  std::thread([&] { first = gettid(); }).join();
  while (std::filesystem::exists("/proc/self/task/" + std::to_string(first)))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return listed_threads();
}

std::size_t settled_thread_count(std::size_t expected) {
  std::size_t count = listed_threads();
  for (int i = 0; i < 5000 && count != expected; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    count = listed_threads();
  }
  return count;
}

}  // namespace palpate::test
