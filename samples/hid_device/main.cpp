// A haptic device without hardware, for whoever builds one or tries a program without one: a ball on springs
// that speaks the open haptic HID protocol through the kernel's /dev/uhid. Palpate finds it as
// hid:1209:0001:REFERENCE.

#include <signal.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "samples/hid_device/haptic_device.h"
#include "samples/hid_device/uhid_port.h"

namespace palpate::hid_device {
namespace {

// Of pid.codes, for tests; a product of yours has ids of its own.
constexpr std::uint16_t kVendor = 0x1209;
constexpr std::uint16_t kProduct = 0x0001;

constexpr double kSway = 0.02;       // m: the hand moves up and down
constexpr double kSwayPeriod = 5.0;  // s

volatile sig_atomic_t stopped = 0;

void print(const HapticDevice& device) {
  const Vector& force = device.force();
  std::printf("\r%8.1f s  %s  force %6.2f %6.2f %6.2f N ", device.time(),
              device.armed() ? "armed   " : "disarmed", force[0], force[1], force[2]);
  std::fflush(stdout);
}

void run() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kPeriod(1);
  constexpr int kBetweenPrints = 100;
  UhidPort port(kVendor, kProduct, "REFERENCE");
  HapticDevice device;
  Clock::time_point due = Clock::now();
  for (int tick = 0; !stopped; ++tick) {
    due += kPeriod;
    port.serve(device, due);
    device.mass().hold_at({0.0, kSway * std::sin(2.0 * M_PI * device.time() / kSwayPeriod), 0.0});
    port.send(device.step());
    if (tick % kBetweenPrints == 0) print(device);
  }
  std::printf("\n");
}

}  // namespace
}  // namespace palpate::hid_device

int main() {
  signal(SIGINT, [](int) { palpate::hid_device::stopped = 1; });
  signal(SIGTERM, [](int) { palpate::hid_device::stopped = 1; });
  try {
    palpate::hid_device::run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "palpate-hid-device: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
