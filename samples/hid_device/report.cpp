#include "samples/hid_device/report.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::hid_device {
namespace {

// A vendor's page, 0xFF48, with four reports of plain bytes.
constexpr std::uint8_t kDescriptor[] = {
    0x06, 0x48, 0xFF,                           // usage page 0xFF48
    0x09, 0x01,                                 // usage 1
    0xA1, 0x01,                                 // collection: application
    0x15, 0x00,                                 // logical minimum 0
    0x26, 0xFF, 0x00,                           // logical maximum 255
    0x75, 0x08,                                 // report size: 8 bits
    0x85, 0x01, 0x09, 0x01, 0x95, 63, 0x81, 2,  // report 1: 63 bytes in
    0x85, 0x02, 0x09, 0x02, 0x95, 31, 0x91, 2,  // report 2: 31 bytes out
    0x85, 0x03, 0x09, 0x03, 0x95, 63, 0xB1, 2,  // report 3: 63 bytes of feature
    0x85, 0x04, 0x09, 0x04, 0x95, 7,  0xB1, 2,  // report 4: 7 bytes of feature
    0xC0,
};

constexpr std::size_t kWrenchSize = 32;
constexpr std::size_t kCommandSize = 8;

// CRC-8/AUTOSAR.
std::uint8_t checksum(Bytes bytes) {
  std::uint8_t crc = 0xFF;
  for (const std::uint8_t byte : bytes) {
    crc = static_cast<std::uint8_t>(crc ^ byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = static_cast<std::uint8_t>(crc & 0x80 ? (crc << 1) ^ 0x2F : crc << 1);
    }
  }
  return static_cast<std::uint8_t>(~crc);
}

// Fills a report from the front, the lowest byte of a number first.
template <std::size_t kSize>
class Writer {
 public:
  Writer& bits(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) report_[at_++] = static_cast<std::uint8_t>(value >> (8 * i));
    return *this;
  }
  // In units of `1 / units`, rounded.
  Writer& number(double value, double units) {
    const double most = std::numeric_limits<std::int32_t>::max();
    const auto rounded = static_cast<std::int32_t>(std::clamp(std::round(value * units), -most, most));
    return bits(static_cast<std::uint32_t>(rounded), 4);
  }
  Writer& vector(const Vector& v, double units) {
    return number(v[0], units).number(v[1], units).number(v[2], units);
  }
  std::array<std::uint8_t, kSize> sealed() {
    report_[kSize - 1] = checksum(Bytes(report_).first(kSize - 1));
    return report_;
  }

 private:
  std::array<std::uint8_t, kSize> report_{};
  std::size_t at_ = 0;
};

bool is_whole(Bytes report, std::uint8_t id, std::size_t size) {
  return report.size() == size && report[0] == id && report[size - 1] == checksum(report.first(size - 1));
}

std::uint16_t u16_at(Bytes report, std::size_t at) {
  return static_cast<std::uint16_t>(report[at] | report[at + 1] << 8);
}

double number_at(Bytes report, std::size_t at, double unit) {
  const std::uint32_t bits = u16_at(report, at) | std::uint32_t{u16_at(report, at + 2)} << 16;
  return unit * static_cast<std::int32_t>(bits);
}

Vector vector_at(Bytes report, std::size_t at, double unit) {
  return {number_at(report, at, unit), number_at(report, at + 4, unit), number_at(report, at + 8, unit)};
}

}  // namespace

std::span<const std::uint8_t> report_descriptor() {
  return kDescriptor;
}

std::array<std::uint8_t, 64> report_of(const Sample& sample) {
  constexpr double kQ30 = 1 << 30;
  const Motion& motion = sample.motion;
  Writer<64> report;
  report.bits(1, 1).bits(sample.flags, 1).bits(sample.sequence, 2).bits(sample.time_us, 4);
  report.vector(motion.position, 1e7);
  for (const double part : motion.orientation) report.number(part, kQ30);
  report.vector(motion.velocity, 1e6).vector(motion.turn_rate, 1e6);
  return report.bits(sample.buttons, 2).bits(sample.temperature, 1).sealed();
}

std::array<std::uint8_t, 64> report_of(const Features& features) {
  constexpr int kReach = 100;  // mm, each way
  Writer<64> report;
  report.bits(3, 1);
  for (const char letter : {'O', 'H', 'H', 'P'}) report.bits(static_cast<std::uint8_t>(letter), 1);
  report.bits(1, 1)
      .bits(0x3F, 1)
      .bits(features.actuated, 1)
      .bits(features.traits, 1)
      .bits(features.buttons, 1);
  report.bits(features.rate_hz, 2).bits(features.watchdog_ms, 2).bits(0, 2);
  report.number(features.max_force, 1e3).number(0.5 * features.max_force, 1e3);
  report.number(features.max_torque, 1e6).number(0.5 * features.max_torque, 1e6);
  report.bits(1000, 4).number(5.0, 1e3);  // N/m, N·s/m
  report.bits(100, 4).bits(1, 4);         // 0.1 µm, 1 µrad
  for (int corner : {-kReach, kReach}) {
    for (int axis = 0; axis < 3; ++axis) report.bits(static_cast<std::uint16_t>(corner), 2);
  }
  return report.sealed();
}

std::optional<WrenchOrder> parse_wrench(Bytes report) {
  if (!is_whole(report, 2, kWrenchSize)) return std::nullopt;
  return WrenchOrder{u16_at(report, 2), vector_at(report, 4, 1e-6), vector_at(report, 16, 1e-6),
                     u16_at(report, 28)};
}

std::optional<CommandOrder> parse_command(Bytes report) {
  if (!is_whole(report, 4, kCommandSize)) return std::nullopt;
  if (report[1] < 1 || report[1] > 4) return std::nullopt;
  return CommandOrder{static_cast<Command>(report[1]), u16_at(report, 2)};
}

}  // namespace palpate::hid_device
