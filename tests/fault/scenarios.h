#pragma once

#include <string>
#include <vector>

#include "tests/fault/journey.h"

namespace palpate::test {

// Something that programs do with the library.
struct Scenario {
  std::string name;
  void (*run)(Journey& journey);
  bool has_threads = false;  // of its own: what is the n-th request differs from run to run
};

const std::vector<Scenario>& scenarios();

}  // namespace palpate::test
