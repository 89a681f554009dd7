#include "tests/device/openhaptics/phantom_loop.h"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "engine/device/openhaptics/openhaptics_backend.h"

namespace palpate::test {

PhantomLoop::PhantomLoop(StandInLibrary& library, const std::string& name) : library_(library) {
  auto opened = OpenHapticsBackend().open(StandInLibrary::in_library(name));
  if (!opened) throw std::runtime_error(opened.error().message);
  device_ = std::make_unique<GuardedDevice>(std::move(opened.value()));
  device_->claim();
  device_->servo_host()->carry(*this);
}

PhantomLoop::~PhantomLoop() {
  device_->servo_host()->put_down();
}

void PhantomLoop::tick(double dt) noexcept {
  device_->read();
  device_->write(wanted_, true, dt);
}

// The keeper of lost devices lives in our time.
void PhantomLoop::next() {
  library_.tick();
  if (status().state.condition == DeviceCondition::kLost)
    std::this_thread::sleep_for(std::chrono::microseconds(500));
}

bool PhantomLoop::engage() {
  device_->arm();
  return until([this] {
    const DeviceStatus now = status();
    return now.safety.state == SafetyState::kArmed && now.applied.force == now.wanted.force;
  });
}

}  // namespace palpate::test
