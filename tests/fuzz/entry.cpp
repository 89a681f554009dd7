// libFuzzer's way into one target: PALPATE_FUZZ_TARGET.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  palpate::fuzz::PALPATE_FUZZ_TARGET({data, size});
  return 0;
}
