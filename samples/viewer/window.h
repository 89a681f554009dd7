#pragma once

#include "samples/viewer/arguments.h"

namespace palpate::viewer {

// Runs in a window until that is closed. Throws cli::Failure.
void run_window(const Arguments& arguments);

}  // namespace palpate::viewer
