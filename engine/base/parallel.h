#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace palpate {

// Calls task(i) for every i below `count`, on several threads at once: what they write must not overlap. For
// work that takes milliseconds, away from the servo. Throws what a task throws, once all have ended.
template <class Task>
void in_parallel(std::size_t count, const Task& task) {
  constexpr std::size_t kMostThreads = 8;
  const std::size_t threads =
      std::min({std::size_t{std::thread::hardware_concurrency()}, kMostThreads, count});
  const auto stride = [&](std::size_t first) {
    for (std::size_t i = first; i < count; i += std::max<std::size_t>(threads, 1)) task(i);
  };
  std::vector<std::future<void>> others;
  std::vector<std::size_t> own{0};
  for (std::size_t first = 1; first < threads; ++first) {
    try {
      others.push_back(std::async(std::launch::async, stride, first));
    } catch (const std::system_error&) {
      own.push_back(first);  // there is no thread to be had
    }
  }
  for (std::size_t first : own) stride(first);
  for (std::future<void>& other : others) other.get();
}

// Calls visit(i) for every i below `count`, blocks of them side by side.
template <class Visit>
void for_each_in_parallel(std::size_t count, const Visit& visit) {
  constexpr std::size_t kBlock = std::size_t{1} << 14;
  in_parallel((count + kBlock - 1) / kBlock, [&](std::size_t block) {
    const std::size_t end = std::min(count, (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) visit(static_cast<std::uint32_t>(i));
  });
}

}  // namespace palpate
