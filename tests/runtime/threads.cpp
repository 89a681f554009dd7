#include "tests/runtime/threads.h"

#include <filesystem>

std::size_t palpate::test::thread_count() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}
