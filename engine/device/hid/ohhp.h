#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/device/hid/crc8.h"

// The open haptic HID protocol, version 1: what PROTOCOL.md describes, beside the reports themselves.
namespace palpate::ohhp {

constexpr std::uint16_t kUsagePage = 0xFF48;
constexpr std::uint16_t kUsage = 1;
constexpr std::uint8_t kVersion = 1;

constexpr std::uint8_t kSampleId = 0x01;
constexpr std::uint8_t kWrenchId = 0x02;
constexpr std::uint8_t kFeaturesId = 0x03;
constexpr std::uint8_t kCommandId = 0x04;

constexpr std::size_t kSampleSize = 64;
constexpr std::size_t kWrenchSize = 32;
constexpr std::size_t kFeaturesSize = 64;
constexpr std::size_t kCommandSize = 8;

// Whether a report is whole: of its id and size, and as it was sent. The last byte is the checksum of all
// before it.
inline bool is_whole(std::span<const std::uint8_t> report, std::uint8_t id, std::size_t size) {
  return report.size() == size && report[0] == id && report[size - 1] == crc8(report.first(size - 1));
}

inline void seal(std::span<std::uint8_t> report) {
  report.back() = crc8(report.first(report.size() - 1));
}

}  // namespace palpate::ohhp
