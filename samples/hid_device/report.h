#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "samples/hid_device/mass.h"

// The reports of the open haptic HID protocol, seen from the device: engine/device/hid/PROTOCOL.md has every
// byte.
namespace palpate::hid_device {

using Bytes = std::span<const std::uint8_t>;

// What the device says a thousand times a second.
struct Sample {
  enum Flag : std::uint8_t {
    kCalibrated = 1 << 0,
    kArmed = 1 << 1,
    kDeadMan = 1 << 2,
    kWatchdog = 1 << 3,
    kTooHot = 1 << 4,
    kSaturated = 1 << 5,
    kEmergency = 1 << 6,
  };

  std::uint8_t flags = 0;
  std::uint16_t sequence = 0;
  std::uint32_t time_us = 0;
  Motion motion;
  std::uint16_t buttons = 0;
  std::uint8_t temperature = 0;
};

// What the device is.
struct Features {
  std::uint8_t traits = 0;  // bit 0: has a dead-man switch; bit 1: wants to be told to calibrate
  std::uint8_t actuated = 0x3F;
  std::uint8_t buttons = 2;
  std::uint16_t rate_hz = 1000;
  std::uint16_t watchdog_ms = 20;
  double max_force = 5.0;   // N
  double max_torque = 0.1;  // N·m
};

// What it is told to push with.
struct WrenchOrder {
  std::uint16_t answered = 0;  // the sequence of the sample it was computed from
  Vector force{};              // N
  Vector torque{};             // N·m
  std::uint16_t time_to_live_ms = 0;
};

enum class Command : std::uint8_t { kArm = 1, kDisarm = 2, kCalibrate = 3, kSetWatchdog = 4 };

struct CommandOrder {
  Command command = Command::kDisarm;
  std::uint16_t milliseconds = 0;
};

// How a host learns the reports' sizes.
std::span<const std::uint8_t> report_descriptor();

std::array<std::uint8_t, 64> report_of(const Sample& sample);
std::array<std::uint8_t, 64> report_of(const Features& features);

// None for a report of another kind or length, or with a wrong checksum.
std::optional<WrenchOrder> parse_wrench(Bytes report);
std::optional<CommandOrder> parse_command(Bytes report);

}  // namespace palpate::hid_device
