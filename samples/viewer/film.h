#pragma once

#include "samples/viewer/arguments.h"

namespace palpate::viewer {

// Runs without a window, writes what the arguments ask for and says where. Throws cli::Failure.
void run_film(const Arguments& arguments);

}  // namespace palpate::viewer
