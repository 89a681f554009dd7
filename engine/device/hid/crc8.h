#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace palpate {

// The checksum of OHHP reports: CRC-8/AUTOSAR, polynomial 0x2F. It finds any wrong bit and any wrong bits
// within a row of eight, and all but one in 256 of other errors. Bit by bit: 63 bytes a millisecond are no
// work.
constexpr std::uint8_t crc8(std::span<const std::uint8_t> bytes) {
  constexpr unsigned kPolynomial = 0x2F;
  unsigned crc = 0xFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ (crc & 0x80 ? 0x100 | kPolynomial : 0);
  }
  return static_cast<std::uint8_t>(crc ^ 0xFF);
}

}  // namespace palpate
