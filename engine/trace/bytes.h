#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/trace/fields.h"

namespace palpate {

using TraceBytes = std::vector<std::byte>;

template <std::size_t kSize>
using UintOfSize = std::conditional_t<kSize == 8, std::uint64_t,
                                      std::conditional_t<kSize == 4, std::uint32_t, std::uint8_t>>;

// Puts numbers behind `bytes`, little-endian.
class ByteAppender {
 public:
  explicit ByteAppender(TraceBytes& bytes) : bytes_(bytes) {}

  template <class Number>
  void operator()(const Number& number) {
    auto bits = std::bit_cast<UintOfSize<sizeof(Number)>>(number);
    for (std::size_t i = 0; i < sizeof bits; ++i)
      bytes_.push_back(static_cast<std::byte>(static_cast<std::uint64_t>(bits) >> (8 * i)));
  }
  template <class Number, std::size_t kCount>
  void operator()(const std::array<Number, kCount>& numbers) {
    for (const Number& number : numbers) (*this)(number);
  }

 private:
  TraceBytes& bytes_;
};

// Takes numbers from `bytes`, which has enough of them.
class ByteTaker {
 public:
  explicit ByteTaker(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class Number>
  void operator()(Number& number) {
    using Bits = UintOfSize<sizeof(Number)>;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bits |= std::to_integer<std::uint64_t>(bytes_[i]) << (8 * i);
    number = std::bit_cast<Number>(static_cast<Bits>(bits));
    bytes_ = bytes_.subspan(sizeof(Number));
  }
  template <class Number, std::size_t kCount>
  void operator()(std::array<Number, kCount>& numbers) {
    for (Number& number : numbers) (*this)(number);
  }

 private:
  std::span<const std::byte> bytes_;
};

// A record's length in a file.
template <class Record>
std::uint32_t stored_size() {
  std::size_t size = 0;
  Record record;
  each_field(record, [&](const auto& field) { size += sizeof field; });
  return static_cast<std::uint32_t>(size);
}

template <class Record>
void append_record(Record record, TraceBytes& bytes) {
  each_field(record, ByteAppender(bytes));
}

template <class Record>
Record take_record(std::span<const std::byte> bytes) {
  Record record;
  each_field(record, ByteTaker(bytes));
  return record;
}

}  // namespace palpate
