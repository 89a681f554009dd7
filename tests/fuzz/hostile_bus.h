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

  struct Identity {
    std::uint16_t vendor, product, usage_page, usage;
  };

  struct Plugged {
    Identity identity;
    Report features;  // its answer to any question; empty: it refuses
    Report first;     // what it reports at once
  };

  static HostileBus& the();

  void plug(Plugged device);  // which pulls out what was there
  void unplug();

  // Reports it, and waits until the reader has it and asks for more, or is not there.
  void report(Report report);
  bool is_heard();  // all that was reported

  // The longest force that was written to it since it was plugged in, N, as the wrench report counts it.
  double strongest();

  // hidapi's side, which needs no memory. A device is known by how often something was plugged in before.
  struct Found {
    Identity identity;
    std::uint64_t number;
  };
  std::optional<Found> find();
  int read(std::uint64_t number, std::span<std::uint8_t> into, int timeout_ms);
  int write(std::uint64_t number, std::span<const std::uint8_t> report);
  int feature(std::uint64_t number, std::span<std::uint8_t> into);

 private:
  bool is_there(std::uint64_t number) const { return plugged_ && number == number_; }

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::optional<Plugged> plugged_;
  std::uint64_t number_ = 0;
  std::optional<Report> waiting_;
  double strongest_ = 0.0;
};

}  // namespace palpate::fuzz
