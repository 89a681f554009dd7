#pragma once

#include <stdexcept>
#include <string>

#include "palpate/palpate.h"

namespace palpate::cli {

// Why the program ends with exit code 1: one line that names the file.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Turns an error of the library into a Failure.
inline void check(plp_result result) {
  if (result < 0) throw Failure(plp_last_error());
}

}  // namespace palpate::cli
