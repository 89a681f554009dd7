#pragma once

#include <string>

namespace palpate::bench {

// Where and from what a result comes.
struct Machine {
  std::string processor;
  std::string compiler;
  std::string flags;
  std::string simd;  // the widest instruction set that both this build and the processor have
};

Machine this_machine();

}  // namespace palpate::bench
