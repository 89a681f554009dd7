#pragma once

#include <cstdint>

namespace palpate {

// How much of its files a load looked at.
struct LoadTally {
  std::uint64_t read_bytes = 0;     // of files, or of the glTF given in memory
  std::uint64_t decoded_bytes = 0;  // of elements of accessors and of Draco streams, as often as they were
};

}  // namespace palpate
