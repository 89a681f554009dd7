#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace palpate::fuzz {

// A bus with one device that says whatever a target wants. Its functions stand before hidapi's own in this
// program.
class HostileBus {
 public:
  using Report = std::vector<std::uint8_t>;

  struct Plugged {
    std::uint16_t vendor, product, usage_page, usage;
    Report features;  // its answer to any question; empty: it refuses
    Report first;     // what it reports at once
  };

  static HostileBus& the();

  void plug(Plugged device);
  void unplug();

  // Reports it, and waits until the reader has it and asks for more, or is not there.
  void report(Report report);

  // The longest force that was written to it since it was plugged in, N, as the wrench report counts it.
  double strongest();

  // hidapi's side.
  std::optional<Plugged> plugged();
  int read(std::span<std::uint8_t> into, int timeout_ms);
  int write(std::span<const std::uint8_t> report);
  int feature(std::span<std::uint8_t> into);

 private:
  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::optional<Plugged> plugged_;
  std::optional<Report> waiting_;
  double strongest_ = 0.0;
};

}  // namespace palpate::fuzz
