#include "engine/device/hid/hid_link.h"

#include <array>
#include <chrono>
#include <exception>
#include <utility>

#include "engine/base/own_thread.h"
#include "engine/device/hid/hid_bus.h"

namespace palpate {
namespace {

constexpr int kPatienceMs = 20;                          // of a read: how late a stop is at most
constexpr std::chrono::milliseconds kBetweenTries{200};  // to find the device again
constexpr int kMostAtOnce = 256;                         // the kernel queues 64
constexpr std::size_t kLongestReport = 256;

}  // namespace

HidLink::HidLink(std::shared_ptr<HidConnection> connection, HidListener& listener)
    : entry_(connection->entry()), listener_(listener), connection_(std::move(connection)) {}

HidLink::~HidLink() {
  stop();
}

void HidLink::start() {
  thread_ = std::thread([this] { run(); });
}

void HidLink::stop() {
  if (!thread_.joinable()) return;
  stop_.raise();
  woken_.ring();
  thread_.join();
}

std::shared_ptr<HidConnection> HidLink::connection() {
  const std::lock_guard lock(mutex_);
  return connection_;
}

void HidLink::set_connection(std::shared_ptr<HidConnection> connection) {
  const std::lock_guard lock(mutex_);
  std::swap(connection_, connection);
}

void HidLink::run() {
  begin_own_thread("palpate-hid-in");
  ask_for_priority(kDevicePriority);
  while (!stop_.raised()) {
    const std::shared_ptr<HidConnection> now = connection();
    if (!now) {
      connect_again();
    } else if (!hear(*now)) {
      set_connection(nullptr);
      listener_.lost();
    }
  }
}

// The newest report is what counts, but each is taken: a stall leaves a queue of old ones behind. False: the
// device has gone.
bool HidLink::hear(HidConnection& connection) {
  std::array<std::uint8_t, kLongestReport> report;
  int length = connection.in().read(report, kPatienceMs);
  if (length == 0) listener_.silent(1e-6 * heard_.elapsed_us());
  if (length == 0) return !connection.given_up();
  for (int count = 1; length > 0; ++count) {
    listener_.take(std::span(report).first(static_cast<std::size_t>(length)));
    length = count < kMostAtOnce ? connection.in().read(report, 0) : 0;
  }
  if (length < 0 || connection.given_up()) return false;
  listener_.show();
  heard_ = Stopwatch();
  return true;
}

// Permission may come a moment after the device, so a refusal is no reason to give up.
void HidLink::connect_again() {
  bool connected = false;
  try {
    connected = connect();
  } catch (const std::exception&) {
    // Out of memory: the device stays lost until the next attempt.
  }
  if (!connected) woken_.wait(kBetweenTries);
}

bool HidLink::connect() {
  auto found = hid_bus::connect(entry_.name, entry_.kind);
  if (!found || !found.value() || !listener_.accept(*found.value())) return false;
  set_connection(std::move(found.value()));
  heard_ = Stopwatch();
  return true;
}

}  // namespace palpate
